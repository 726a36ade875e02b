//! Design checks of a solution.

pub(crate) mod checks;
