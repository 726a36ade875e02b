//! Calculation reports of [`groundbeam_report`] as PDF.
//!
//! The pages are set by [typst](https://typst.app) from `templates/report.typ`, which takes minutes to build: it is in this
//! crate if the feature `typst` is on, and the program has it by its feature `pdf`. Without it [`report`] says so.
//!
//! Equal reports give equal bytes: a report has no date, and none is made up.

#![forbid(unsafe_code)]
#![deny(missing_docs)]

#[cfg(feature = "typst")]
mod typeset;
#[cfg(not(feature = "typst"))]
mod without;

#[cfg(feature = "typst")]
use typeset::pdf;
#[cfg(not(feature = "typst"))]
use without::pdf;

use groundbeam_report::calculation::{Paper, Report};
use std::fmt;

/// Whether the typesetter is there.
pub const BUILT_IN: bool = cfg!(feature = "typst");

/// What is to be done where it is not.
pub const NOT_BUILT_IN: &str = "this program was built without PDF; to have it built in, which takes some minutes: `cargo install \
     --path crates/groundbeam-cli --features pdf`; or write a report that ends in .html, and print it from a browser";

/// A report that could not be made.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error(String);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Error {}

/// A report as a PDF file. Equal reports give equal bytes.
///
/// # Errors
///
/// Where the typesetter is not built in ([`BUILT_IN`]).
pub fn report(report: &Report, paper: Paper) -> Result<Vec<u8>, Error> {
    pdf(report, paper)
}
