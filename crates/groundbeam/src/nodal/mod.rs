//! Solves Kikuchi's discrete problem (5.5), (5.10), (5.11), with ground forces at the nodes, for up to millions of elements.
//!
//! Between nodes the deflection is the exact solution of the beam equation, in place of the cubic element
//! (5.2). The methods with a mesh, the solver for long beams and the first phase of the exact method use this
//! solver. [Sweeps](sweep) from both ends of the beam eliminate rows of equal elements. Their variables are
//! the deformations of the elements. Each stretch off the ground is condensed to [one element](span).
//! Newton's method finds the contact zones, on [coarse meshes first](newton). A solve stores a few numbers
//! per node.

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
pub(crate) mod search;
pub(crate) mod solution;
pub(crate) mod span;
pub(crate) mod stand;
pub(crate) mod stretch;
pub(crate) mod sweep;
