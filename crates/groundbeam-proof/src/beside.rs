//! The shear layer outside the beam: stretches of constant k and μ with their loads, listed outward.

/// A stretch of ground with constant k and μ outside the beam, with its loads.
#[derive(Debug, Clone)]
pub(crate) struct LoadedStretch<S> {
    /// Length of the stretch; `None` for an infinite stretch, which has no loads.
    pub length: Option<S>,
    /// k and μ of the stretch.
    pub ground: [S; 2],
    /// Distributed load q at the two ends of the stretch, first at the end nearer to the beam.
    pub spread: [S; 2],
    /// Point force at the outer end of the stretch, which is the end farther from the beam.
    pub force: S,
}

/// The stretches of shear layer outside one end of the beam, in order from the beam outward.
#[derive(Debug, Clone)]
pub(crate) struct Row<S> {
    pub stretches: Vec<LoadedStretch<S>>,
    /// Whether the ground surface is fixed at zero settlement at the far end of the last stretch.
    pub held: bool,
}

impl<S> Row<S> {
    /// Returns an empty list of ground stretches, for an end of the beam without a shear layer outside the beam.
    pub fn none() -> Self {
        Row { stretches: Vec::new(), held: false }
    }
}
