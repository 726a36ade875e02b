//! Numerical tools that do not depend on the mechanics of beams.

pub(crate) mod dual;
pub(crate) mod elementary;
pub(crate) mod line_search;
pub(crate) mod polynomial;
pub(crate) mod quadrature;
pub(crate) mod real;
pub(crate) mod roots;
pub(crate) mod step;
pub(crate) mod sum;
pub(crate) mod tolerance;
