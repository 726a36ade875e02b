//! Defines the commands and options of the command line.

use crate::distinct::Output;
use crate::failure::Failure;
#[cfg(feature = "study")]
use crate::option_value::shard;
use crate::option_value::{
    METHODS, PAPERS, Plot, Report, STARTS, UNITS, bytes, no_choice_of_pressure, number, one_of,
};
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;
use groundbeam::{Method, Options, Start};
use groundbeam_file::print::{Asked, DIGITS};
use groundbeam_report::calculation::Paper;
use groundbeam_report::{RESULT_DIGITS, Units};
#[cfg(feature = "study")]
use groundbeam_study::Shard;
use std::path::PathBuf;

/// Beams on tensionless ground
///
/// Given a beam, a Pasternak or Winkler foundation and loads, computes contact, lift-off and contact
/// pressure, and bounds the error. If no equilibrium exists, states in which direction the beam tips.
#[derive(Debug, Parser)]
#[command(name = "groundbeam", version, max_term_width = 100, after_long_help = AFTER)]
#[command(subcommand_required = true, arg_required_else_help = true)]
pub struct CommandLine {
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
  4  the solver did not reach its tolerance
  130  a study was stopped from the keyboard; completed samples are saved

Environment:
  NO_COLOR  if set and not empty, output has no colour";

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Solve a model and report contact, forces, extremes and the certificate
    Solve(Solve),
    /// Read a model and decide whether an equilibrium exists, without solving
    Check(Check),
    /// Prove that the numbers in a result document are correct for its model file
    Verify(Verify),
    /// Write a commented starter model file
    New(New),
    /// Solve a model with every method and show the errors relative to the method `exact`
    Compare(Compare),
    /// Solve a model thousands of times on random ground and under random loads, and estimate the probability
    /// of events
    #[cfg(feature = "study")]
    Study(Study),
    /// Merge the shards of a study
    #[cfg(feature = "study")]
    Merge(Merge),
    /// Show the model on a page in the browser and solve it again after each change
    #[cfg(feature = "serve")]
    Serve(Serve),
    /// Print the JSON Schema of model files, for completion and checks in an editor
    Schema {
        /// Print the JSON Schema of study files
        #[arg(long)]
        study: bool,
    },
    /// Print a completion script for a shell
    Completions {
        /// Shell for which the script is printed
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

    /// Add the solution as piecewise polynomials to the document, so that `groundbeam verify` can prove it
    #[arg(long, requires = "json")]
    pub pieces: bool,

    /// Prove the solution: existence, uniqueness, contact set, and an error bound for every printed quantity
    ///
    /// The proof encloses all rounding errors. The exit status is 1 if something is not proven. With --json
    /// the document contains the solution as piecewise polynomials and the bounds, which `groundbeam verify`
    /// proves again.
    #[arg(long)]
    pub proven: bool,

    /// Write all results along the beam as a table; for combinations, the envelope
    #[arg(long, value_name = "OUT")]
    pub csv: Option<PathBuf>,

    /// Draw beam, ground, pressure, moment and shear, or the envelopes of combinations; the file name ends in
    /// .svg or .png
    #[arg(long, value_name = "OUT", value_parser = Plot::parser())]
    pub plot: Option<Plot>,

    /// Write a printable calculation report: input, assumptions, results, certificate; the file name ends in
    /// .html or .pdf
    #[arg(long, value_name = "OUT", value_parser = Report::parser())]
    pub report: Option<Report>,

    /// Paper size of the report; default: A4 for PDF, the paper size of the user's printer for HTML
    #[arg(long, requires = "report", value_parser = one_of(PAPERS))]
    pub paper: Option<Paper>,

    /// Write every step of the iteration as a table
    #[arg(long, value_name = "OUT")]
    pub history: Option<PathBuf>,

    /// Positions at which results are listed, as in "0 m, 0.5 m", or 0,0.5 for a file without units
    ///
    /// Applies to --json and --csv. Default: an equidistant grid with every load, contact edge and extreme.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub at: Option<String>,

    /// Also compute the load factors at which the beam first lifts off and at which equilibrium is lost
    ///
    /// By default, all loads grow. If load cases are named, as in --factors=Q or --factors=Q,wind, only the loads of
    /// these load cases grow.
    #[arg(long, value_name = "CASES", num_args = 0..=1, require_equals = true)]
    pub factors: Option<Option<String>>,

    /// Solve only this combination of the file
    ///
    /// Default: the results of all combinations and their envelope.
    #[arg(long, value_name = "NAME")]
    pub combination: Option<String>,

    /// Solve only the combinations of the set NAME, which a key `set` of the model file must name
    #[arg(long, value_name = "NAME", conflicts_with = "combination")]
    pub set: Option<String>,

    /// Make the exit status 1 if a check fails or is not judged
    ///
    /// Default: the verdicts are printed and do not change the exit status.
    #[arg(long)]
    pub strict: bool,

    /// Leave out the small drawing that a terminal shows below the report
    #[arg(long)]
    pub no_drawing: bool,

    /// The method of solution
    #[arg(long, default_value = "exact", value_parser = one_of(METHODS))]
    pub method: Method,

    /// Number of elements of the mesh, 1 to 10 000 000; the method `exact` uses no mesh
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = number().range(1..=10_000_000))]
    pub elements: usize,

    /// Option of earlier versions; with a mesh, the ground now acts on the nodes only
    #[arg(long, hide = true, value_parser = no_choice_of_pressure)]
    pub pressure: Option<std::convert::Infallible>,

    /// Initial pressure of `psor` and `uzawa`
    #[arg(long, default_value = "bilateral", value_parser = one_of(STARTS))]
    pub start: Start,

    /// Maximum number of sweeps of `psor` and `uzawa`
    #[arg(long, value_name = "N", default_value_t = 1_000_000, value_parser = number().range(1..))]
    pub most_sweeps: usize,

    /// Memory limit of the solve, as in "8 GB"; a model that needs more is refused before it is solved
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
    /// Units of printed results, drawings and tables; JSON is in SI units, or without units if the file has none
    #[arg(long, default_value = "file", value_parser = one_of(UNITS))]
    pub units: Asked,

    /// Number of significant digits of results, 2 to 15; a proven number has as many digits as its error bound
    /// allows
    #[arg(long, value_name = "N", default_value_t = RESULT_DIGITS, value_parser = number().range(*DIGITS.start() as u64..=*DIGITS.end() as u64))]
    pub digits: usize,
}

impl Printed {
    /// Returns the requested units with the requested number of digits. `own` are the units of the file.
    pub fn units(self, own: Units) -> Result<Units, Failure> {
        let rule = "--units: the file has no units, so its numbers cannot be converted";
        let units = own.in_system(self.units).ok_or_else(|| Failure::usage(rule.to_owned()))?;
        Ok(units.with_digits(self.digits))
    }
}

/// Prove that the numbers in a result document are correct for its model file
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
    /// Model file (TOML) without combinations, trains or uncertain ground; `-` for standard input
    pub file: PathBuf,

    /// Print the comparison as one JSON document on standard output, and nothing else
    #[arg(long)]
    pub json: bool,

    /// Number of elements of each mesh, 1 to 100 000
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = number().range(1..=100_000))]
    pub elements: usize,

    /// Maximum number of sweeps of `psor` and `uzawa`
    #[arg(long, value_name = "N", default_value_t = 100_000, value_parser = number().range(1..))]
    pub most_sweeps: usize,

    /// Memory limit of the solve, as in "8 GB"; a model that needs more is refused before it is solved
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
    /// A run continues an existing file; no sample is computed twice. After a stop, run the same command again.
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,

    /// Number of samples; replaces the number in the study file
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub samples: Option<u64>,

    /// Seed of the random numbers; replaces the seed in the study file
    #[arg(long, value_name = "S")]
    pub seed: Option<u64>,

    /// Solve only part i of N equal parts of the samples, as in 3/8; `groundbeam merge` merges all parts
    #[arg(long, value_name = "i/N", value_parser = shard)]
    pub shard: Option<Shard>,

    /// Number of threads; default: the number of processors. The results do not depend on the number of threads
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true, value_parser = number().range(0..=65_535))]
    pub threads: usize,

    /// Delete existing results and start again
    #[arg(long)]
    pub restart: bool,

    /// Draw the probabilities of events and the scatter of results; the file name ends in .svg or .png; not with `--shard`
    #[arg(long, value_name = "OUT", conflicts_with = "shard", value_parser = Plot::parser())]
    pub plot: Option<Plot>,

    /// Print the summary as one JSON document on standard output, and nothing else
    #[arg(long)]
    pub json: bool,

    #[command(flatten)]
    pub printed: Printed,
}

#[cfg(feature = "study")]
#[derive(Debug, Args)]
pub struct Merge {
    /// Result files of all shards, in any order
    #[arg(required = true)]
    pub files: Vec<PathBuf>,

    /// File for the merged results
    #[arg(long, value_name = "OUT")]
    pub out: PathBuf,
}

/// Kind of structure that a starter model file describes.
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

    /// Port of this machine to listen on; 0 selects a free port
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,

    /// Do not open the browser
    #[arg(long)]
    pub no_open: bool,

    #[command(flatten)]
    pub printed: Printed,
}

impl Solve {
    /// Returns the options of the solver.
    pub fn options(&self) -> Options {
        Options {
            method: self.method,
            elements: self.elements,
            start: self.start,
            most_sweeps: self.most_sweeps,
            memory_limit: self.memory_limit,
            ..Options::default()
        }
    }

    /// Whether the result document includes the pieces of the solution.
    pub fn includes_pieces(&self) -> bool {
        self.pieces || self.proven
    }

    /// Returns an option on the command line that requires a model with a single result; `None` without such an option.
    pub fn about_one_answer(&self) -> Option<&'static str> {
        let history = self.history.as_ref().map(|_| "--history");
        history.or(self.factors.as_ref().map(|_| "--factors"))
    }

    /// Returns the options that name output files, with the paths of these files.
    pub fn outputs(&self) -> impl Iterator<Item = Output<'_>> {
        let plot = self.plot.as_ref().map(|plot| &plot.path);
        let report = self.report.as_ref().map(|report| &report.path);
        let all = [
            ("--csv", self.csv.as_ref()),
            ("--plot", plot),
            ("--report", report),
            ("--history", self.history.as_ref()),
        ];
        all.into_iter().filter_map(|(option, path)| Some((option, path?.as_path())))
    }
}

#[cfg(feature = "study")]
impl Study {
    /// Returns the part of the samples that this run solves.
    pub fn shard(&self) -> Shard {
        self.shard.unwrap_or(Shard::WHOLE)
    }

    /// Returns the options that name output files, with the paths of these files.
    pub fn outputs(&self) -> impl Iterator<Item = Output<'_>> {
        let plot = self.plot.as_ref().map(|plot| ("--plot", plot.path.as_path()));
        [("--out", self.out.as_path())].into_iter().chain(plot)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        CommandLine::command().debug_assert();
    }
}
