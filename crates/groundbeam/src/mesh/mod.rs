//! The discrete problem, (3.8) and (3.9) of Kikuchi's paper: cells, nodes, free-field settlement, deflection and energy.

pub(crate) mod cell;
pub(crate) mod deflection;
pub(crate) mod energy;
pub(crate) mod free_field;
pub(crate) mod ground_runs;
pub(crate) mod ground_stretch;
pub(crate) mod lifted;
pub(crate) mod mesh;
pub(crate) mod open_ground;
pub(crate) mod varying;
