//! Eliminates the unknowns of the discrete beam and ground for given contact zones.

pub(crate) mod elimination;
pub(crate) mod hinge;
pub(crate) mod links;
pub(crate) mod node;
