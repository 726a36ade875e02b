//! Where the beam touches: one file per method.

pub(crate) mod active_set;
mod descent;
pub(crate) mod exact;
pub(crate) mod forms;
pub(crate) mod layout;
mod line;
pub(crate) mod majorant;
pub(crate) mod nested;
pub(crate) mod pieces;
pub(crate) mod recover;
pub(crate) mod surface;
pub(crate) mod uzawa;
mod varying;
