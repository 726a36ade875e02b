//! The shear layer outside the beam: stretches of constant k and μ with their loads, listed outward.

/// A stretch of ground with constant k and μ outside the beam, with its loads.
#[derive(Debug, Clone)]
pub(crate) struct LoadedStretch<S> {
    /// Length of the stretch; `None` for an infinite stretch, which has no loads.
    pub length: Option<S>,
    /// k and μ.
    pub ground: [S; 2],
    /// q at the near and at the far end.
    pub spread: [S; 2],
    /// The point force at the far end of the stretch.
    pub force: S,
}

/// The shear layer outside one end of the beam, listed outward.
#[derive(Debug, Clone)]
pub(crate) struct Row<S> {
    pub stretches: Vec<LoadedStretch<S>>,
    /// Whether the surface is held at the end of the last stretch.
    pub held: bool,
}

impl<S> Row<S> {
    /// No ground.
    pub fn none() -> Self {
        Row { stretches: Vec::new(), held: false }
    }
}
