//! Where the beam touches: one file per method.

pub(crate) mod active_set;
pub(crate) mod balanced;
pub(crate) mod branch;
pub(crate) mod deflection;
mod descent;
mod edges;
pub(crate) mod exact;
pub(crate) mod forms;
pub(crate) mod glue;
pub(crate) mod layout;
pub(crate) mod line;
pub(crate) mod majorant;
mod narrow;
mod near;
pub(crate) mod nested;
pub(crate) mod pieces;
pub(crate) mod recover;
mod softened;
pub(crate) mod stretches;
pub(crate) mod surface;
pub(crate) mod uzawa;
mod varying;
