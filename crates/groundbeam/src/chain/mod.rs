//! Elimination of the discrete beam and ground at a given contact.

pub(crate) mod elimination;
pub(crate) mod hinge;
pub(crate) mod links;
pub(crate) mod mirror;
pub(crate) mod node;
