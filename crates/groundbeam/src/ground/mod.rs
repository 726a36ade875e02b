//! The open ground, −(μ u′)′ + k u = 0, as two-ports.

pub(crate) mod link;
