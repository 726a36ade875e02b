//! The open ground, −(μ u′)′ + k u = 0, as two-ports, (2.2)–(2.5), (5.8).

pub(crate) mod link;
