//! Represents open ground, −(μ u′)′ + k u = 0, by two-ports.

pub(crate) mod link;
