//! Equilibria: the convex problem (theorem 1), one-way supports, compression.

pub(crate) mod branch;
pub(crate) mod buckling;
pub(crate) mod local;
pub(crate) mod one_way;
pub(crate) mod size;
pub(crate) mod soil;
