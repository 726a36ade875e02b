//! Writes results to standard output and to files. A file is written completely or not at all.

use crate::failure::Failure;
use crate::input::Input;
use crate::option_value::{Plot, PlotFormat, Report, ReportFormat};
use groundbeam_report::Results;
use groundbeam_report::calculation::Paper;
use groundbeam_report::svg::Picture;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::path::Path;

/// Whether standard output is a terminal.
pub fn standard_output_is_a_terminal() -> bool {
    io::stdout().is_terminal()
}

/// Prints to standard output. A closed pipe is not an error.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut standard_output = io::stdout().lock();
    let written = standard_output.write_all(text.as_bytes()).and_then(|()| standard_output.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::usage(format!("standard output: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes a picture in the format of its file name, if a picture is requested.
pub fn draw(plot: Option<&Plot>, picture: impl FnOnce() -> Option<Picture>) -> Result<(), Failure> {
    let Some(Plot { path, format }) = plot else { return Ok(()) };
    let Some(picture) = picture() else { return Ok(()) };
    let bytes = match format {
        PlotFormat::Svg => picture.to_string().into_bytes(),
        #[cfg(feature = "png")]
        PlotFormat::Png => picture.png().map_err(|error| Failure::usage(error.to_string()))?,
    };
    write(path, &bytes)
}

/// Writes the calculation report, if a report is requested.
pub fn report(
    wanted: Option<&Report>,
    paper: Option<Paper>,
    results: &Results,
    input: &Input,
) -> Result<(), Failure> {
    let Some(Report { path, format }) = wanted else { return Ok(()) };
    let report = results.calculation(&input.source());
    let bytes = match format {
        #[cfg(feature = "html")]
        ReportFormat::Html => groundbeam_report::html::report(&report, paper)
            .map(String::into_bytes)
            .map_err(|error| Failure::usage(error.to_string()))?,
        ReportFormat::Pdf => groundbeam_pdf::report(&report, paper.unwrap_or(Paper::A4))
            .map_err(|error| Failure::usage(error.to_string()))?,
    };
    write(path, &bytes)
}

/// Writes an output file completely or not at all. A closed pipe is not an error.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    match groundbeam_file::output::write(path, bytes) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(|error| Failure::file(path, &error)),
    }
}
