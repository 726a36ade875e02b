//! The beam between two nodes: stiffness and load of one element, (2.11), (5.1).

pub(crate) mod courses;
pub(crate) mod cubic;
pub(crate) mod element;
pub(crate) mod operator;
pub(crate) mod series;
pub(crate) mod shear;
pub(crate) mod uniform;
