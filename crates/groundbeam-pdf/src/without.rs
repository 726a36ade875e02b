//! Replaces the typesetter in builds without it by a function that returns an error.

use crate::{Error, NOT_BUILT_IN};
use groundbeam_report::calculation::{Paper, Report};

/// Returns an error that says that PDF is not built in.
pub(crate) fn pdf(_: &Report, _: Paper) -> Result<Vec<u8>, Error> {
    Err(Error(NOT_BUILT_IN.to_owned()))
}
