//! Options of the command line as typed. [`request`](crate::request) interprets them.

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use groundbeam_file::print::DIGITS;
use groundbeam_report::RESULT_DIGITS;
use std::path::PathBuf;

/// Beams on tensionless ground
///
/// Given a beam, a Pasternak or Winkler foundation and loads, computes contact, lift-off and contact
/// pressure, and bounds the error. If no equilibrium exists, states in which direction the beam tips.
#[derive(Debug, Parser)]
#[command(name = "groundbeam", version, max_term_width = 100, after_long_help = AFTER)]
#[command(subcommand_required = true, arg_required_else_help = true)]
pub struct Typed {
    #[command(subcommand)]
    pub command: Command,
}

const AFTER: &str = "\
Exit status:
  0  solved; for a file with combinations all of them, for a train all positions
  1  an answer is not proven or a check is undecided (--proven); a check fails or is not judged (--strict).
     Without --strict a check that fails leaves the status 0
  2  the input or the command line is wrong
  3  the model is valid, but it or at least one combination or position has no equilibrium
  4  the solver did not reach its own tolerance
  130  a study was stopped from the keyboard; completed samples are saved

Environment:
  NO_COLOR  if set, output has no colour";

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a model and report contact, forces, extremes and the certificate
    Solve(Solve),
    /// Read a model and decide whether an equilibrium exists, without solving
    Check(Check),
    /// Prove a result document against its model file
    Verify(Verify),
    /// Write a commented starter model file
    New(New),
    /// Solve a model with every method and show their errors relative to `exact`
    Compare(Compare),
    /// Solve a model thousands of times on random ground and under random loads, and estimate the probability
    /// of events
    #[cfg(feature = "study")]
    Study(Study),
    /// Merge the shards of a study
    #[cfg(feature = "study")]
    Merge(Merge),
    /// Show the model on a page in the browser; results follow each change at once
    #[cfg(feature = "serve")]
    Serve(Serve),
    /// Print the JSON Schema of model files, with which an editor completes and checks them
    Schema {
        /// Print the schema of study files instead
        #[arg(long)]
        study: bool,
    },
    /// Print a completion script for a shell
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Print the manual page
    #[command(hide = true)]
    Man,
}

#[derive(Debug, Args)]
#[command(after_long_help = AFTER)]
pub struct Solve {
    /// Model file (TOML); `-` for standard input
    pub file: PathBuf,

    /// Print the result as one JSON document on standard output, and nothing else
    #[arg(long)]
    pub json: bool,

    /// Add the pieces of the solution to the document, from which `groundbeam verify` proves it
    #[arg(long, requires = "json")]
    pub pieces: bool,

    /// Prove the solution: existence, uniqueness, contact set, and an error bound for every printed quantity
    ///
    /// The proof encloses all rounding errors. The exit status is 1 if something is not proven. With --json
    /// the document contains the pieces of the solution and the bounds, which `groundbeam verify` proves
    /// again.
    #[arg(long)]
    pub proven: bool,

    /// Write all fields along the beam as a table; for combinations, the envelope
    #[arg(long, value_name = "OUT")]
    pub csv: Option<PathBuf>,

    /// Draw beam, ground, pressure, moment and shear, or the envelopes of combinations; the file name ends in
    /// .svg or .png
    #[arg(long, value_name = "OUT")]
    pub plot: Option<PathBuf>,

    /// Write a printable calculation report: input, assumptions, results, certificate; the file name ends in
    /// .html or .pdf
    #[arg(long, value_name = "OUT")]
    pub report: Option<PathBuf>,

    /// The paper of the report; default: A4 for PDF, the paper of the user's printer for HTML
    #[arg(long, value_enum, requires = "report")]
    pub paper: Option<Paper>,

    /// Write every step of the iteration as a table
    #[arg(long, value_name = "OUT")]
    pub history: Option<PathBuf>,

    /// Positions at which the fields are listed, as in "0 m, 0.5 m", or 0,0.5 for a file without units
    ///
    /// For --json and --csv. Default: an equidistant grid with every load, contact edge and extreme.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub at: Option<String>,

    /// Also compute the load factors at which the beam first lifts off and at which equilibrium is lost
    ///
    /// All loads grow. With names of load cases, only their loads grow, as in --factors=Q or
    /// --factors=Q,wind.
    #[arg(long, value_name = "CASES", num_args = 0..=1, require_equals = true)]
    pub factors: Option<Option<String>>,

    /// Solve only this combination of the file
    ///
    /// Default: the results of all combinations and their envelope.
    #[arg(long, value_name = "NAME")]
    pub combination: Option<String>,

    /// Solve only the combinations of this set, one of the sets that the file asks for
    #[arg(long, value_name = "NAME", conflicts_with = "combination")]
    pub set: Option<String>,

    /// Make the exit status 1 if a check fails or is not judged
    ///
    /// Default: the verdicts are printed, and the exit status is that of the solution.
    #[arg(long)]
    pub strict: bool,

    /// Leave out the small drawing that a terminal shows below the report
    #[arg(long)]
    pub no_drawing: bool,

    /// The method of solution
    #[arg(long, value_enum, default_value = "exact")]
    pub method: Method,

    /// Elements of the mesh; `exact` has none
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub elements: u32,

    /// The ground of the methods with a mesh presses on the nodes alone
    #[arg(long, hide = true, value_parser = no_choice_of_pressure)]
    pub pressure: Option<std::convert::Infallible>,

    /// Initial pressure of `psor` and `uzawa`
    #[arg(long, value_enum, default_value = "bilateral")]
    pub start: Start,

    /// Maximum number of sweeps of `psor` and `uzawa`
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = clap::value_parser!(u64).range(1..))]
    pub most_sweeps: u64,

    /// Memory limit of the solve, as in "8 GB"; a model that needs more is rejected before it is solved
    #[arg(long, value_name = "SIZE", default_value = "4 GB", value_parser = bytes)]
    pub memory_limit: u64,

    #[command(flatten)]
    pub printed: Printed,
}

#[derive(Debug, Args)]
pub struct Check {
    /// Model file (TOML); `-` for standard input
    pub file: PathBuf,

    /// Print the verdict as one JSON document on standard output, and nothing else
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    pub printed: Printed,
}

/// Units and digits of printed quantities.
#[derive(Debug, Clone, Copy, Args)]
pub struct Printed {
    /// Units of printed results, drawings and tables; JSON is always in SI units
    #[arg(long, value_enum, default_value = "file")]
    pub units: UnitsAsked,

    /// Significant digits of results; proven numbers have as many as their bound allows
    #[arg(long, value_name = "N", default_value_t = RESULT_DIGITS as u8, value_parser = clap::value_parser!(u8).range(*DIGITS.start() as i64..=*DIGITS.end() as i64))]
    pub digits: u8,
}

/// Units of printed quantities.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum UnitsAsked {
    /// Units of the model file: ft, kip and ksf for a file that uses them
    File,
    /// SI units: m, kN, kPa
    Si,
    /// US units: ft, in, kip, ksf, pci
    Us,
}

/// Prove a result document against its model file
///
/// The document comes from `groundbeam solve --json --pieces` or from another program. Each of its numbers is
/// compared with the exact solution of the model, with arithmetic that encloses all rounding errors. The
/// proof shares no code with the solver.
#[derive(Debug, Args)]
#[command(after_long_help = VERIFIED)]
pub struct Verify {
    /// Result document (JSON); `-` for standard input
    pub result: PathBuf,

    /// Model file (TOML)
    pub model: PathBuf,

    /// Write the log of the proof, which `reference/replay` recomputes
    #[arg(long, value_name = "FILE")]
    pub log: Option<PathBuf>,

    /// Exit with status 1 if the document has numbers that the proof does not cover
    #[arg(long)]
    pub strict: bool,

    /// Print the proven statements as one JSON document on standard output, and nothing else
    #[arg(long)]
    pub json: bool,
}

const VERIFIED: &str = "\
Exit status:
  0  proven: there is exactly one equilibrium, its contact set is that of the document, and every
     error is at most a millionth of its scale
  1  not proven; the first reason and all proven bounds are printed
  2  the document or the model file cannot be read
  3  proven for the model in the document alone: the proof does not read the model file";

#[derive(Debug, Args)]
pub struct New {
    /// The file to write; an existing file is not replaced
    #[arg(default_value = "model.toml")]
    pub file: PathBuf,

    /// The subject of the model
    #[arg(long, value_enum, default_value = "footing")]
    pub kind: Starter,
}

#[derive(Debug, Args)]
pub struct Compare {
    /// Model file (TOML) without combinations or trains; `-` for standard input
    pub file: PathBuf,

    /// Print the comparison as one JSON document on standard output, and nothing else
    #[arg(long)]
    pub json: bool,

    /// Elements of the meshes
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub elements: u32,

    /// Maximum number of sweeps of `psor` and `uzawa`
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = clap::value_parser!(u64).range(1..))]
    pub most_sweeps: u64,

    /// Memory limit of the solve, as in "8 GB"; a model that needs more is rejected before it is solved
    #[arg(long, value_name = "SIZE", default_value = "4 GB", value_parser = bytes)]
    pub memory_limit: u64,

    #[command(flatten)]
    pub printed: Printed,
}

#[cfg(feature = "study")]
#[derive(Debug, Args)]
#[command(after_long_help = AFTER)]
pub struct Study {
    /// Study file (TOML), which names the model file
    pub file: PathBuf,

    /// File for the results, one row per sample (Parquet)
    ///
    /// Existing results are resumed; no sample is computed twice. After a stop, run the same command again.
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,

    /// Number of samples, in place of that of the file
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub samples: Option<u64>,

    /// Seed, in place of that of the file
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,

    /// Only part i of N equal parts of the samples, with i from 1, as in 3/8; `groundbeam merge` merges all
    /// parts
    #[arg(long, value_name = "i/N")]
    pub shard: Option<String>,

    /// Number of threads; default: the number of processors. The results do not depend on it
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub threads: u16,

    /// Delete existing results and start again
    #[arg(long)]
    pub restart: bool,

    /// Draw the probabilities of events and the scatter of results; the file name ends in .svg or .png
    #[arg(long, value_name = "OUT", conflicts_with = "shard")]
    pub plot: Option<PathBuf>,

    /// Print the summary as one JSON document on standard output, and nothing else
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    pub printed: Printed,
}

#[cfg(feature = "study")]
#[derive(Debug, Args)]
pub struct Merge {
    /// The results of all shards, in any order
    #[arg(required = true)]
    pub files: Vec<PathBuf>,

    /// File for the merged results
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,
}

/// Subject of a starter model file.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Starter {
    /// A strip footing under columns
    Footing,
    /// A rail under wheels
    Rail,
    /// A strip of a ground slab
    Slab,
    /// A pipeline over a trough in the seabed
    Pipeline,
}

#[cfg(feature = "serve")]
#[derive(Debug, Args)]
pub struct Serve {
    /// Initial model file (TOML); default: an example. The file itself is never changed
    pub file: Option<PathBuf>,

    /// Port of this machine to listen on; 0 selects a free one
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,

    /// Do not open the browser
    #[arg(long)]
    pub no_open: bool,

    #[command(flatten)]
    pub printed: Printed,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Paper {
    /// 210 mm × 297 mm
    A4,
    /// 8.5 in × 11 in
    Letter,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Method {
    /// Closed-form solution between the contact edges, no mesh
    Exact,
    /// Forces at the nodes of a mesh, Newton's method on the convex energy
    ActiveSet,
    /// Projected successive over-relaxation, Kikuchi (5.17), (5.18)
    Psor,
    /// Uzawa's iteration, Kikuchi (5.14) to (5.17)
    Uzawa,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Start {
    /// The pressure of the bilateral problem without its tensile part
    Bilateral,
    /// Zero pressure
    Zero,
}

/// Answers an option that earlier versions had.
fn no_choice_of_pressure(_: &str) -> Result<std::convert::Infallible, String> {
    let forces =
        "the ground of `active-set`, `psor` and `uzawa` presses on the nodes alone, Kikuchi (5.5)";
    Err(format!(
        "{forces}: for pressure along the beam leave the option out and use `--method exact`"
    ))
}

/// Parses a number of bytes, as in `8 GB` or `500MB`.
fn bytes(written: &str) -> Result<u64, String> {
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
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        Typed::command().debug_assert();
    }

    #[test]
    fn sizes_have_a_unit() {
        assert_eq!([bytes("8 GB"), bytes(" 0.5kB ")], [Ok(8_000_000_000), Ok(500)]);
        for wrong in ["8", "GB", "-1 GB", "8 gb", "inf GB", ""] {
            assert!(bytes(wrong).is_err(), "{wrong}");
        }
    }
}
