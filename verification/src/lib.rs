//! Code shared by the tests that compare groundbeam with known results.

pub mod architecture;
pub mod attack;
pub mod carried;
pub mod cases;
pub mod claims;
pub mod convergence;
pub mod crossing;
pub mod dense;
mod element;
pub mod equations;
pub mod exact_attack;
pub mod frozen;
pub mod hostile;
pub mod imports;
pub mod linear;
pub mod many;
pub mod proven;
pub mod public_api;
pub mod random;
pub mod reference;
pub mod second;
pub mod solved;
pub mod troughs;
pub mod upheaval;
