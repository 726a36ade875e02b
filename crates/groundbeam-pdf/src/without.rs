//! In place of the typesetter where it is not built in.

use crate::{Error, NOT_BUILT_IN};
use groundbeam_report::calculation::{Paper, Report};

/// Says so.
pub(crate) fn pdf(_: &Report, _: Paper) -> Result<Vec<u8>, Error> {
    Err(Error(NOT_BUILT_IN.to_owned()))
}
