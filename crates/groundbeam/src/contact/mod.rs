//! The contact iterations, section 5 of the paper: exact, active set, Uzawa; and the parts that they share.

pub(crate) mod active_set;
pub(crate) mod bonded;
pub(crate) mod continuation;
mod descent;
pub(crate) mod edge_error;
pub(crate) mod edge_step;
pub(crate) mod edges;
pub(crate) mod exact;
pub(crate) mod intervals;
pub(crate) mod layout;
pub(crate) mod levels;
pub(crate) mod obstacle;
pub(crate) mod point_contact;
pub(crate) mod recover;
pub(crate) mod short_span;
mod springs;
pub(crate) mod start;
pub(crate) mod state;
pub(crate) mod stopping;
pub(crate) mod surface;
pub(crate) mod transfer;
mod undecided;
pub(crate) mod unloaded_ends;
pub(crate) mod uzawa;
mod zone_forces;
