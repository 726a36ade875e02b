//! Computes equilibria with one-way supports, with compression and with soil models, and estimates the memory of a solve.

pub(crate) mod branch;
pub(crate) mod buckling;
pub(crate) mod local;
pub(crate) mod one_way;
pub(crate) mod size;
pub(crate) mod soil;
