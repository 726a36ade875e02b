//! Where the beam touches: one file per method.

pub(crate) mod active_set;
pub(crate) mod balanced;
pub(crate) mod corner;
mod descent;
pub(crate) mod edges;
pub(crate) mod exact;
pub(crate) mod glue;
pub(crate) mod layout;
pub(crate) mod majorant;
mod narrow;
mod near;
pub(crate) mod nested;
pub(crate) mod recover;
pub(crate) mod refine;
mod softened;
pub(crate) mod state;
pub(crate) mod stopping;
pub(crate) mod stretches;
pub(crate) mod surface;
pub(crate) mod transfer;
pub(crate) mod uzawa;
