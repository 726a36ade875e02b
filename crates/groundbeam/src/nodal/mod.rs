//! Solves Kikuchi's discrete problem (5.5), (5.10), (5.11), with ground forces at the nodes, for up to millions of elements.
//!
//! Between nodes the deflection is the exact solution of the beam equation, in place of the cubic element (5.2).
//! [Sweeps](sweep) eliminate the elements, and [Newton's method](newton) finds the contact zones. See section 10 of
//! docs/methods.md.

pub(crate) mod back_sweep;
pub(crate) mod beam;
pub(crate) mod check;
pub(crate) mod edges;
pub(crate) mod form;
pub(crate) mod grid;
pub(crate) mod hull;
pub(crate) mod lanes;
pub(crate) mod layer;
pub(crate) mod layout;
pub(crate) mod levels;
pub(crate) mod newton;
pub(crate) mod open;
pub(crate) mod quadratic;
pub(crate) mod reactions;
pub(crate) mod search;
pub(crate) mod solution;
pub(crate) mod span;
pub(crate) mod stand;
pub(crate) mod stretch;
pub(crate) mod sweep;
