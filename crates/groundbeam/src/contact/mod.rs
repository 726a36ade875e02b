//! The contact iterations of section 5 of Kikuchi's paper (exact, active set, Uzawa) and the parts that they share.

pub(crate) mod bonded;
pub(crate) mod continuation;
mod descent;
pub(crate) mod edge_error;
pub(crate) mod edge_step;
pub(crate) mod edges;
pub(crate) mod exact;
mod flexibility;
mod free_beam;
pub(crate) mod intervals;
pub(crate) mod layout;
pub(crate) mod nodes;
pub(crate) mod obstacle;
pub(crate) mod point_contact;
pub(crate) mod short_span;
mod springs;
pub(crate) mod start;
pub(crate) mod state;
pub(crate) mod stopping;
pub(crate) mod surface;
mod translation;
mod undecided;
pub(crate) mod unloaded_ends;
pub(crate) mod uzawa;
mod zone_forces;
