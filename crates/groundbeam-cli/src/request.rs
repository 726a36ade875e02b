//! Converts the typed options into a request with all choices and outputs.

use crate::distinct::Output;
use crate::failure::Failure;
use crate::typed::{self, Command, Typed};
use clap_complete::Shell;
use groundbeam::Options;
use groundbeam_file::print;
use groundbeam_report::Units;
use groundbeam_report::calculation::Paper;
#[cfg(feature = "study")]
use groundbeam_study::Shard;
use std::path::PathBuf;

/// The requested action.
pub enum Request {
    Solve(Solve),
    Check(Check),
    Verify(Verify),
    Compare(Compare),
    New(New),
    #[cfg(feature = "serve")]
    Serve(Serve),
    #[cfg(feature = "study")]
    Study(Study),
    #[cfg(feature = "study")]
    Merge(Merge),
    /// The JSON Schema of model files or of study files.
    Schema {
        study: bool,
    },
    Completions(Shell),
    Manual,
}

/// Solves a model and writes the requested outputs.
pub struct Solve {
    pub file: PathBuf,
    pub json: bool,
    /// Whether the document includes the pieces of the solution.
    pub pieces: bool,
    /// Whether the solution is proven.
    pub proven: bool,
    pub csv: Option<PathBuf>,
    pub plot: Option<Plot>,
    pub report: Option<Report>,
    pub history: Option<PathBuf>,
    /// Positions as typed. They are parsed after the file, because its units decide.
    pub at: Option<String>,
    pub factors: Option<Grow>,
    /// Name of one combination of the file.
    pub combination: Option<String>,
    /// Name of one set of combinations of the file.
    pub set: Option<String>,
    /// Whether a check that fails or is not judged gives the exit status 1.
    pub strict: bool,
    /// Whether a terminal shows a drawing of the beam below the report.
    pub drawing: bool,
    pub printed: Printed,
    pub options: Options,
}

impl Solve {
    /// The first given option that needs a single result.
    pub fn about_one_answer(&self) -> Option<&'static str> {
        let history = self.history.as_ref().map(|_| "--history");
        history.or(self.factors.as_ref().map(|_| "--factors"))
    }
}

/// The loads that the load factor multiplies.
pub enum Grow {
    /// All loads.
    All,
    /// The loads of the listed cases, as typed. The list is parsed after the file.
    Cases(String),
}

/// A picture to draw.
pub struct Plot {
    pub path: PathBuf,
    pub format: Format,
}

/// Format of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    Svg,
    #[cfg(feature = "png")]
    Png,
}

/// A calculation report to write.
pub struct Report {
    pub path: PathBuf,
    pub setting: Setting,
}

/// Format and paper of a report.
#[derive(Debug, Clone, Copy)]
pub enum Setting {
    /// HTML for a paper size; `None` for the paper of the user's printer.
    #[cfg(feature = "html")]
    Html(Option<Paper>),
    Pdf(Paper),
}

/// Decides whether an equilibrium exists.
pub struct Check {
    pub file: PathBuf,
    pub json: bool,
    pub printed: Printed,
}

/// Units and digits of printed results.
#[derive(Debug, Clone, Copy)]
pub struct Printed {
    pub asked: print::Asked,
    pub digits: usize,
}

impl Printed {
    fn of(typed: typed::Printed) -> Self {
        let asked = match typed.units {
            typed::UnitsAsked::File => print::Asked::File,
            typed::UnitsAsked::Si => print::Asked::Si,
            typed::UnitsAsked::Us => print::Asked::Us,
        };
        Printed { asked, digits: typed.digits.into() }
    }

    /// The requested units, or those of the file.
    pub fn units(self, own: Units) -> Result<Units, Failure> {
        let rule = "--units: the file has no units, so its numbers cannot be converted";
        let units = own.in_system(self.asked).ok_or_else(|| Failure::usage(rule.to_owned()))?;
        Ok(units.with_digits(self.digits))
    }
}

/// Proves a result document.
pub struct Verify {
    pub result: PathBuf,
    pub model: PathBuf,
    /// Output file for the log of the proof.
    pub log: Option<PathBuf>,
    /// Whether keys that the proof does not cover count as not proven.
    pub strict: bool,
    pub json: bool,
}

/// Solves a model with every method.
pub struct Compare {
    pub file: PathBuf,
    pub json: bool,
    pub elements: usize,
    pub most_sweeps: usize,
    pub memory_limit: u64,
    pub printed: Printed,
}

/// Writes a starter model file.
pub struct New {
    pub file: PathBuf,
    pub kind: typed::Starter,
}

/// Serves a page on this machine.
#[cfg(feature = "serve")]
pub struct Serve {
    /// The initial model file.
    pub file: Option<PathBuf>,
    /// Port to listen on; 0 selects a free port.
    pub port: u16,
    pub opens_browser: bool,
    pub printed: Printed,
}

/// Solves a model for many samples.
#[cfg(feature = "study")]
pub struct Study {
    pub file: PathBuf,
    pub out: PathBuf,
    pub samples: Option<u64>,
    pub seed: Option<u64>,
    pub shard: Shard,
    /// 0: Number of threads; 0 for the number of processors.
    pub threads: usize,
    pub restart: bool,
    pub plot: Option<Plot>,
    pub json: bool,
    pub printed: Printed,
}

/// Merges shards.
#[cfg(feature = "study")]
pub struct Merge {
    pub files: Vec<PathBuf>,
    pub out: PathBuf,
}

#[cfg(feature = "study")]
impl Study {
    /// Options that name output files.
    pub fn outputs(&self) -> impl Iterator<Item = Output<'_>> {
        let plot = self.plot.as_ref().map(|plot| ("--plot", plot.path.as_path()));
        [("--out", self.out.as_path())].into_iter().chain(plot)
    }

    fn of(typed: typed::Study) -> Result<Self, Failure> {
        let shard = match &typed.shard {
            None => Shard::WHOLE,
            Some(written) => shard(written)?,
        };
        let typed::Study { file, out, samples, seed, threads, restart, plot, json, .. } = typed;
        let printed = Printed::of(typed.printed);
        let plot = plot.map(Plot::of).transpose()?;
        let threads = threads.into();
        Ok(Study { file, out, samples, seed, shard, threads, restart, plot, json, printed })
    }
}

/// Parses a shard such as `3/8`.
#[cfg(feature = "study")]
fn shard(written: &str) -> Result<Shard, Failure> {
    let parts = written.split_once('/').and_then(|(number, of)| {
        Some(Shard { number: number.trim().parse().ok()?, of: of.trim().parse().ok()? })
    });
    let known = parts.filter(|shard| (1..=shard.of).contains(&shard.number));
    known.ok_or_else(|| {
        Failure::usage(format!(
            "--shard {written}: write shard i of N as i/N, with i from 1 to N, as in 3/8"
        ))
    })
}

impl Request {
    pub fn of(typed: Typed) -> Result<Self, Failure> {
        Ok(match typed.command {
            Command::Solve(solve) => Request::Solve(Solve::of(solve)?),
            Command::Check(check) => Request::Check(Check {
                file: check.file,
                json: check.json,
                printed: Printed::of(check.printed),
            }),
            Command::Verify(typed::Verify { result, model, log, strict, json }) => {
                Request::Verify(Verify { result, model, log, strict, json })
            }
            Command::Compare(compare) => Request::Compare(Compare {
                file: compare.file,
                json: compare.json,
                elements: compare.elements as usize,
                most_sweeps: usize::try_from(compare.most_sweeps).unwrap_or(usize::MAX),
                memory_limit: compare.memory_limit,
                printed: Printed::of(compare.printed),
            }),
            Command::New(new) => Request::New(New { file: new.file, kind: new.kind }),
            #[cfg(feature = "serve")]
            Command::Serve(typed::Serve { file, port, no_open, printed }) => {
                let printed = Printed::of(printed);
                Request::Serve(Serve { file, port, opens_browser: !no_open, printed })
            }
            #[cfg(feature = "study")]
            Command::Study(study) => Request::Study(Study::of(study)?),
            #[cfg(feature = "study")]
            Command::Merge(typed::Merge { files, out }) => Request::Merge(Merge { files, out }),
            Command::Schema { study } => Request::Schema { study },
            Command::Completions { shell } => Request::Completions(shell),
            Command::Man => Request::Manual,
        })
    }
}

impl Solve {
    fn of(typed: typed::Solve) -> Result<Self, Failure> {
        let options = Options {
            method: match typed.method {
                typed::Method::Exact => groundbeam::Method::Exact,
                typed::Method::ActiveSet => groundbeam::Method::ActiveSet,
                typed::Method::Psor => groundbeam::Method::Psor,
                typed::Method::Uzawa => groundbeam::Method::Uzawa,
            },
            elements: typed.elements as usize,
            start: match typed.start {
                typed::Start::Bilateral => groundbeam::Start::Bilateral,
                typed::Start::Zero => groundbeam::Start::Zero,
            },
            most_sweeps: usize::try_from(typed.most_sweeps).unwrap_or(usize::MAX),
            memory_limit: typed.memory_limit,
            ..Options::default()
        };
        let plot = typed.plot.map(Plot::of).transpose()?;
        let paper = typed.paper.map(|paper| match paper {
            typed::Paper::A4 => Paper::A4,
            typed::Paper::Letter => Paper::Letter,
        });
        let report = typed.report.map(|path| Report::of(path, paper)).transpose()?;
        Ok(Solve {
            file: typed.file,
            json: typed.json,
            pieces: typed.pieces || typed.proven,
            proven: typed.proven,
            csv: typed.csv,
            plot,
            report,
            history: typed.history,
            at: typed.at,
            combination: typed.combination,
            set: typed.set,
            strict: typed.strict,
            factors: typed.factors.map(|cases| cases.map_or(Grow::All, Grow::Cases)),
            drawing: !typed.no_drawing,
            printed: Printed::of(typed.printed),
            options,
        })
    }

    /// Options that name output files.
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

impl Report {
    /// A report whose file name determines the format.
    fn of(path: PathBuf, paper: Option<Paper>) -> Result<Self, Failure> {
        let wrong =
            |rule: &str| Err(Failure::usage(format!("--report {}: {rule}", path.display())));
        let extension = path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase);
        let setting = match extension.as_deref() {
            #[cfg(feature = "html")]
            Some("html" | "htm") => Setting::Html(paper),
            #[cfg(not(feature = "html"))]
            Some("html" | "htm") => return wrong(&not_built_in("HTML", "html")),
            Some("pdf") if groundbeam_pdf::BUILT_IN => Setting::Pdf(paper.unwrap_or(Paper::A4)),
            Some("pdf") => return wrong(groundbeam_pdf::NOT_BUILT_IN),
            _ => return wrong("the name of a report ends in .html or .pdf"),
        };
        Ok(Report { path, setting })
    }
}

/// Hint for a format that is not built in.
#[cfg(not(all(feature = "html", feature = "png")))]
fn not_built_in(form: &str, feature: &str) -> String {
    format!("this program was built without {form}; build it with `--features {feature}`")
}

impl Plot {
    fn of(path: PathBuf) -> Result<Self, Failure> {
        let wrong = |rule: &str| Err(Failure::usage(format!("--plot {}: {rule}", path.display())));
        let extension = path.extension().and_then(|e| e.to_str()).map(str::to_ascii_lowercase);
        let format = match extension.as_deref() {
            Some("svg") => Format::Svg,
            #[cfg(feature = "png")]
            Some("png") => Format::Png,
            #[cfg(not(feature = "png"))]
            Some("png") => return wrong(&not_built_in("PNG", "png")),
            _ => return wrong("the name of a picture ends in .svg or .png"),
        };
        Ok(Plot { path, format })
    }
}
