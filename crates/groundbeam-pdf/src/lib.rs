//! Writes calculation reports of [`groundbeam_report`] as PDF.
//!
//! [typst](https://typst.app) sets the pages from `templates/report.typ`. It takes minutes to build, so it is optional:
//! feature `typst` of this crate, `pdf` of the program. Without typst, [`report`] returns an error.

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

/// Whether the typesetter is built in.
pub const BUILT_IN: bool = cfg!(feature = "typst");

/// Error message and remedy for builds without the typesetter.
pub const NOT_BUILT_IN: &str = "this program was built without PDF; build it with PDF, which takes some minutes: `cargo install \
     --path crates/groundbeam-cli --features pdf`; or write a report that ends in .html and print it from a browser";

/// Reason why a report cannot be written as PDF.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error(String);

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Error {}

/// Returns a report as a PDF file. Equal reports give equal bytes.
///
/// # Errors
///
/// Returns an error if the typesetter is not built in ([`BUILT_IN`]), or if it fails.
pub fn report(report: &Report, paper: Paper) -> Result<Vec<u8>, Error> {
    pdf(report, paper)
}
