//! The layer beside the beam: even stretches with their loads, outward.

/// A stretch of even ground beside the beam with its loads.
#[derive(Debug, Clone)]
pub(crate) struct LoadedStretch<S> {
    /// None if it has no end. Loads end somewhere, so it has none then.
    pub length: Option<S>,
    /// k and μ.
    pub ground: [S; 2],
    /// q at the near and at the far end.
    pub spread: [S; 2],
    /// The force at its far end.
    pub force: S,
}

/// The layer on one side of the beam, outward.
#[derive(Debug, Clone)]
pub(crate) struct Row<S> {
    pub stretches: Vec<LoadedStretch<S>>,
    /// Whether the surface is held at the end of the last one.
    pub held: bool,
}

impl<S> Row<S> {
    /// No ground.
    pub fn none() -> Self {
        Row { stretches: Vec::new(), held: false }
    }
}
