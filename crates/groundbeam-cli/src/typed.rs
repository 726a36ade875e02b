//! The command line's options as typed. [`request`](crate::request) gives them their meaning.

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use groundbeam_report::RESULT_DIGITS;
use std::path::PathBuf;

/// Beams on ground that can only push back.
///
/// Given a beam, a Pasternak or Winkler foundation and loads, finds where the beam touches, where it lifts
/// off and how hard the ground pushes, and bounds the error of the answer. If no equilibrium exists, says which way the
/// beam tips.
#[derive(Debug, Parser)]
#[command(name = "groundbeam", version, max_term_width = 100, after_long_help = AFTER)]
#[command(subcommand_required = true, arg_required_else_help = true)]
pub struct Typed {
    #[command(subcommand)]
    pub command: Command,
}

const AFTER: &str = "\
Exit status:
  0  solved; of a file with combinations, all of them; of a train, every position
  1  an answer is not proven or a check is undecided (--proven); a check fails or is not judged (--strict).
     Without --strict a check that fails leaves the status 0
  2  the input or the command line is wrong
  3  the model is right and no equilibrium exists, of a combination or position at least
  4  the solver could not meet its own tolerance
  130  a study was stopped from the keyboard; what is done is kept

Environment:
  NO_COLOR  if set, nothing is coloured";

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a model and report contact, forces, extremes and the certificate
    Solve(Solve),
    /// Read a model and tell whether an equilibrium exists, without solving
    Check(Check),
    /// Prove a result document against its model file
    Verify(Verify),
    /// Write a commented model file to begin with
    New(New),
    /// Solve a model with every method and show their errors against `exact`
    Compare(Compare),
    /// Solve a model thousands of times on random ground and under random loads, and tell how probable events are
    #[cfg(feature = "study")]
    Study(Study),
    /// Put the shards of a study together
    #[cfg(feature = "study")]
    Merge(Merge),
    /// Show the model on a page in the browser, where it can be changed and follows at once
    #[cfg(feature = "serve")]
    Serve(Serve),
    /// Print the JSON Schema of model files, with which an editor completes and checks them
    Schema {
        /// The schema of study files instead
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

    /// Print the result as one JSON document, and nothing else, on standard output
    #[arg(long)]
    pub json: bool,

    /// Add the pieces of the answer to the document, from which `groundbeam verify` proves it
    #[arg(long, requires = "json")]
    pub pieces: bool,

    /// Prove the answer: existence, uniqueness, contact set, and a bound of the error of every printed quantity
    ///
    /// All rounding is enclosed. The exit status is 1 if something is not proven. With --json the document holds the pieces
    /// of the answer and the bounds, which `groundbeam verify` proves again.
    #[arg(long)]
    pub proven: bool,

    /// Write all fields along the beam as a table; of combinations, the envelope
    #[arg(long, value_name = "OUT")]
    pub csv: Option<PathBuf>,

    /// Draw beam, ground, pressure, moment and shear, or the envelopes of combinations; the format is that of the name, .svg or .png
    #[arg(long, value_name = "OUT")]
    pub plot: Option<PathBuf>,

    /// Write a calculation report that prints well: input, assumptions, results, certificate; a name that ends in .html or .pdf
    #[arg(long, value_name = "OUT")]
    pub report: Option<PathBuf>,

    /// The paper on which the report is set; left out, a PDF is on A4, and HTML takes that of whoever prints it
    #[arg(long, value_enum, requires = "report")]
    pub paper: Option<Paper>,

    /// Write every step of the iteration as a table
    #[arg(long, value_name = "OUT")]
    pub history: Option<PathBuf>,

    /// Positions at which the fields are listed, as in "0 m, 0.5 m", or 0,0.5 for a file without units
    ///
    /// For --json and --csv. Left out: an even grid with every load, edge of contact and extreme.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub at: Option<String>,

    /// Also tell how far the loads may grow until the beam first lifts off, and until equilibrium is lost
    ///
    /// All loads grow or, with names, those whose `case` is named; the others stay. As in --factors=Q or
    /// --factors=Q,wind.
    #[arg(long, value_name = "CASES", num_args = 0..=1, require_equals = true)]
    pub factors: Option<Option<String>>,

    /// Solve this one of the file's combinations alone
    ///
    /// Left out, a file with combinations gives the results of all of them and their envelope.
    #[arg(long, value_name = "NAME")]
    pub combination: Option<String>,

    /// Solve the combinations of this set alone, one of the sets that the file asks for
    #[arg(long, value_name = "NAME", conflicts_with = "combination")]
    pub set: Option<String>,

    /// Make the exit status 1 if a check fails or is not judged
    ///
    /// Left out, the verdicts are printed and the exit status is that of the solution.
    #[arg(long)]
    pub strict: bool,

    /// Leave out the small drawing that a terminal shows below the report
    #[arg(long)]
    pub no_drawing: bool,

    /// How to solve
    #[arg(long, value_enum, default_value = "exact")]
    pub method: Method,

    /// Elements of the mesh; `exact` has none
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub elements: u32,

    /// The ground of the methods with a mesh presses on the nodes alone
    #[arg(long, hide = true, value_parser = no_choice_of_pressure)]
    pub pressure: Option<std::convert::Infallible>,

    /// Where `psor` and `uzawa` begin
    #[arg(long, value_enum, default_value = "bilateral")]
    pub start: Start,

    /// Sweeps after which `psor` and `uzawa` give up
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = clap::value_parser!(u64).range(1..))]
    pub most_sweeps: u64,

    /// The memory that the solve may need, as in "8 GB"; a model that needs more is refused before it is solved
    #[arg(long, value_name = "SIZE", default_value = "4 GB", value_parser = bytes)]
    pub memory_limit: u64,

    #[command(flatten)]
    pub printed: Printed,
}

#[derive(Debug, Args)]
pub struct Check {
    /// Model file (TOML); `-` for standard input
    pub file: PathBuf,

    /// Print the verdict as one JSON document, and nothing else, on standard output
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    pub printed: Printed,
}

/// How quantities are printed.
#[derive(Debug, Clone, Copy, Args)]
pub struct Printed {
    /// Units of everything that is printed, drawn or written as a table; JSON is always in SI units
    #[arg(long, value_enum, default_value = "file")]
    pub units: UnitsAsked,

    /// Significant digits of results; proven numbers have as many as their bound allows
    #[arg(long, value_name = "N", default_value_t = RESULT_DIGITS as u8, value_parser = clap::value_parser!(u8).range(2..=15))]
    pub digits: u8,
}

/// The units of what is printed.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum UnitsAsked {
    /// Those of the model file: ft, kip and ksf for a file that has them
    File,
    /// SI units: m, kN, kPa
    Si,
    /// US units: ft, in, kip, ksf, pci
    Us,
}

/// Prove a result document against its model file
///
/// The document is one of `groundbeam solve --json --pieces`, or of another program. Each number in it is compared with the
/// exact solution of the model in arithmetic that encloses all rounding. The proof shares no code with the solver.
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

    /// Keys with numbers that the proof does not cover make the exit status 1
    #[arg(long)]
    pub strict: bool,

    /// Print what is proven as one JSON document, and nothing else, on standard output
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
    /// The file to write; one that is there is not replaced
    #[arg(default_value = "model.toml")]
    pub file: PathBuf,

    /// What it is about
    #[arg(long, value_enum, default_value = "footing")]
    pub kind: Starter,
}

#[derive(Debug, Args)]
pub struct Compare {
    /// Model file (TOML) without combinations and trains; `-` for standard input
    pub file: PathBuf,

    /// Print the comparison as one JSON document, and nothing else, on standard output
    #[arg(long)]
    pub json: bool,

    /// Elements of the meshes
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub elements: u32,

    /// Sweeps after which `psor` and `uzawa` give up
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = clap::value_parser!(u64).range(1..))]
    pub most_sweeps: u64,

    /// The memory that the solve may need, as in "8 GB"; a model that needs more is refused before it is solved
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

    /// Where the results go, one row a sample (Parquet)
    ///
    /// What is there already is gone on with, and nothing is done twice: the same command after a stop ends the work.
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,

    /// So many samples, not as many as the file says
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub samples: Option<u64>,

    /// Another seed than the file's
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,

    /// Only the i-th of N equal parts of the samples, from 1 on, as in 3/8; `groundbeam merge` puts all together
    #[arg(long, value_name = "i/N")]
    pub shard: Option<String>,

    /// Threads; left out, as many as there are processors. The results do not depend on it
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub threads: u16,

    /// Throw away what is there and begin anew
    #[arg(long)]
    pub restart: bool,

    /// Draw how probable events are and how numbers scatter; the format is that of the name, .svg or .png
    #[arg(long, value_name = "OUT", conflicts_with = "shard")]
    pub plot: Option<PathBuf>,

    /// Print the summary as one JSON document, and nothing else, on standard output
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

    /// Where all go together
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,
}

/// What a model file to begin with is about.
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
    /// Model file (TOML) to begin with; left out, an example. The file itself is never changed
    pub file: Option<PathBuf>,

    /// Port of this machine to listen on; 0 takes a free one
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,

    /// Do not open the browser
    #[arg(long)]
    pub no_open: bool,
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
    /// Closed forms between the edges of contact, no mesh
    Exact,
    /// Cubic elements, Newton's method on the convex energy
    ActiveSet,
    /// Projected successive over-relaxation, Kikuchi (5.17), (5.18)
    Psor,
    /// Uzawa's iteration, Kikuchi (5.14) to (5.17)
    Uzawa,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub enum Start {
    /// From the pressure of the bilateral problem, its pulls left out
    Bilateral,
    /// From no pressure
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

/// A number of bytes, as in `8 GB` or `500MB`.
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
        _ => return Err("a size has a unit: B, kB, MB, GB or TB, as in \"8 GB\"".into()),
    };
    match number.trim().parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok((number * scale) as u64),
        _ => Err("a size is a positive number with a unit, as in \"8 GB\"".into()),
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
