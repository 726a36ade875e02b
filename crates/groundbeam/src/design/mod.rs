//! Design checks of a solution.

pub(crate) mod checks;
pub(crate) mod limit_states;
