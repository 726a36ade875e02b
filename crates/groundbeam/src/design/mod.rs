//! Design checks of a solution.

pub(crate) mod checks;
pub(crate) mod limit_states;

pub use checks::{Beside, Check, Checked, Limits, overturning};
pub use limit_states::{LimitState, LimitStates};
