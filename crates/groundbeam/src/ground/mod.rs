//! Represents ground without contact, −(μ u′)′ + k u = 0, by two-ports.

pub(crate) mod link;
