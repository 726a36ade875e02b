//! groundbeam checked against what is known: shared by the tests.

pub mod random;
pub mod reference;
