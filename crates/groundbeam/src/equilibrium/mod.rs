//! Computes equilibria on one-way supports, under compression and on soil models, and estimates the size of a solve.

pub(crate) mod branch;
pub(crate) mod buckling;
pub(crate) mod local;
pub(crate) mod one_way;
pub(crate) mod size;
pub(crate) mod soil;
