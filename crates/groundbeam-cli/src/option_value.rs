//! Parses values of options: named choices, names of output files, sizes and shards.

use clap::builder::{
    PathBufValueParser, PossibleValue, PossibleValuesParser, RangedU64ValueParser, TypedValueParser,
};
use groundbeam::{Method, Start};
use groundbeam_file::print::Asked;
use groundbeam_report::calculation::Paper;
#[cfg(feature = "study")]
use groundbeam_study::Shard;
use std::path::{Path, PathBuf};

/// A picture to draw.
#[derive(Debug, Clone)]
pub struct Plot {
    pub path: PathBuf,
    pub format: PlotFormat,
}

/// Format of a picture.
#[derive(Debug, Clone, Copy)]
pub enum PlotFormat {
    Svg,
    #[cfg(feature = "png")]
    Png,
}

impl Plot {
    pub fn parser() -> impl TypedValueParser<Value = Self> {
        PathBufValueParser::new().try_map(Plot::of)
    }

    /// Returns the picture for this path. The ending of the file name determines the format.
    fn of(path: PathBuf) -> Result<Self, String> {
        let format = match extension(&path).as_str() {
            "svg" => PlotFormat::Svg,
            #[cfg(feature = "png")]
            "png" => PlotFormat::Png,
            #[cfg(not(feature = "png"))]
            "png" => return Err(not_built_in("PNG", "png")),
            _ => return Err("the name of a picture must end in .svg or .png".into()),
        };
        Ok(Plot { path, format })
    }
}

/// A calculation report to write.
#[derive(Debug, Clone)]
pub struct Report {
    pub path: PathBuf,
    pub format: ReportFormat,
}

/// Format of a report.
#[derive(Debug, Clone, Copy)]
pub enum ReportFormat {
    #[cfg(feature = "html")]
    Html,
    Pdf,
}

impl Report {
    pub fn parser() -> impl TypedValueParser<Value = Self> {
        PathBufValueParser::new().try_map(Report::of)
    }

    /// Returns the report for this path. The ending of the file name determines the format.
    fn of(path: PathBuf) -> Result<Self, String> {
        let format = match extension(&path).as_str() {
            #[cfg(feature = "html")]
            "html" | "htm" => ReportFormat::Html,
            #[cfg(not(feature = "html"))]
            "html" | "htm" => return Err(not_built_in("HTML", "html")),
            "pdf" if groundbeam_pdf::BUILT_IN => ReportFormat::Pdf,
            "pdf" => return Err(groundbeam_pdf::NOT_BUILT_IN.into()),
            _ => return Err("the name of a report must end in .html or .pdf".into()),
        };
        Ok(Report { path, format })
    }
}

/// Returns the ending of a file name in lower case, without the dot.
fn extension(path: &Path) -> String {
    path.extension()
        .and_then(|extension| extension.to_str())
        .unwrap_or_default()
        .to_ascii_lowercase()
}

/// Returns the message for a format that is not built in.
#[cfg(not(all(feature = "html", feature = "png")))]
fn not_built_in(form: &str, feature: &str) -> String {
    format!("this program was built without {form}; build it with `--features {feature}`")
}

/// Choice of an option: its name, its help text and its value.
type Choice<T> = (&'static str, &'static str, T);

pub const PAPERS: [Choice<Paper>; 2] =
    [("a4", "210 mm × 297 mm", Paper::A4), ("letter", "8.5 in × 11 in", Paper::Letter)];

pub const UNITS: [Choice<Asked>; 3] = [
    ("file", "Units of the model file: ft, kip and ksf for a file that uses them", Asked::File),
    ("si", "SI units: m, kN, kPa", Asked::Si),
    ("us", "US units: ft, in, kip, ksf, pci", Asked::Us),
];

pub const METHODS: [Choice<Method>; 4] = [
    ("exact", "Closed-form solution between the contact edges, no mesh", Method::Exact),
    (
        "active-set",
        "Energy minimization by Newton's method, with ground forces at mesh nodes",
        Method::ActiveSet,
    ),
    (
        "psor",
        "Projected successive over-relaxation, Kikuchi's equations (5.17), (5.18)",
        Method::Psor,
    ),
    ("uzawa", "Uzawa's iteration, Kikuchi's equations (5.14) to (5.17)", Method::Uzawa),
];

pub const STARTS: [Choice<Start>; 2] = [
    (
        "bilateral",
        "The pressure of the bilateral problem without its tensile part",
        Start::Bilateral,
    ),
    ("zero", "Zero pressure", Start::Zero),
];

/// Returns a parser that accepts the names of the given choices and returns the value of the named choice.
pub fn one_of<T: Copy + Send + Sync + 'static, const N: usize>(
    choices: [Choice<T>; N],
) -> impl TypedValueParser<Value = T> {
    let named = |(name, help, _): Choice<T>| PossibleValue::new(name).help(help);
    let value = move |written: String| {
        let choice = choices.iter().find(|(name, ..)| *name == written);
        choice.map(|(.., value)| *value).ok_or("there is no such choice")
    };
    PossibleValuesParser::new(choices.map(named)).try_map(value)
}

/// Parses a whole number.
pub fn number() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new()
}

/// Parses a shard such as `3/8`.
#[cfg(feature = "study")]
pub fn shard(written: &str) -> Result<Shard, String> {
    let parts = written.split_once('/').and_then(|(number, of)| {
        Some(Shard { number: number.trim().parse().ok()?, of: of.trim().parse().ok()? })
    });
    let known = parts.filter(|shard| (1..=shard.of).contains(&shard.number));
    known.ok_or_else(|| "write shard i of N as i/N, with i from 1 to N, as in 3/8".into())
}

/// Returns the error for the option `--pressure`, which only earlier versions had.
pub fn no_choice_of_pressure(_: &str) -> Result<std::convert::Infallible, String> {
    let forces = "with `active-set`, `psor` and `uzawa`, the ground acts on the nodes only (Kikuchi's equation 5.5)";
    Err(format!("{forces}: omit this option; for pressure along the beam, use `--method exact`"))
}

/// Parses a number of bytes, as in `8 GB` or `500MB`.
pub fn bytes(written: &str) -> Result<u64, String> {
    let written = written.trim();
    let split = written.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(written.len());
    let (number, unit) = written.split_at(split);
    let scale = match unit.trim() {
        "B" => 1.0,
        "kB" => 1e3,
        "MB" => 1e6,
        "GB" => 1e9,
        "TB" => 1e12,
        _ => return Err("a size needs a unit: B, kB, MB, GB or TB, as in \"8 GB\"".into()),
    };
    match number.trim().parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok((number * scale) as u64),
        _ => Err("a size must be a positive number with a unit, as in \"8 GB\"".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_sizes_need_a_unit() {
        assert_eq!([bytes("8 GB"), bytes(" 0.5kB ")], [Ok(8_000_000_000), Ok(500)]);
        for wrong in ["8", "GB", "-1 GB", "8 gb", "inf GB", ""] {
            assert!(bytes(wrong).is_err(), "{wrong}");
        }
    }
}
