//! Returns an error in place of a PDF, in builds without the typesetter.

use crate::{Error, NOT_BUILT_IN};
use groundbeam_report::calculation::{Paper, Report};

/// Returns an error that says that PDF is not built in.
pub(crate) fn pdf(_: &Report, _: Paper) -> Result<Vec<u8>, Error> {
    Err(Error(NOT_BUILT_IN.to_owned()))
}
