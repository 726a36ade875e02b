//! Numerical tools that know no beam.

pub(crate) mod line_search;
pub(crate) mod polynomial;
pub(crate) mod tolerance;
