//! A request, from the typed options: all choices made, all outputs known.

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

/// What is to be done.
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
    /// The schema of model files, or of study files.
    Schema {
        study: bool,
    },
    Completions(Shell),
    Manual,
}

/// Solve a model and write these.
pub struct Solve {
    pub file: PathBuf,
    pub json: bool,
    /// Whether the document holds the pieces of the answer.
    pub pieces: bool,
    /// Whether the answer is proven.
    pub proven: bool,
    pub csv: Option<PathBuf>,
    pub plot: Option<Plot>,
    pub report: Option<Report>,
    pub history: Option<PathBuf>,
    /// As typed: it is read under the rule of the file.
    pub at: Option<String>,
    pub factors: Option<Grow>,
    /// The name of one of the file's combinations.
    pub combination: Option<String>,
    /// The name of one of the file's sets of combinations.
    pub set: Option<String>,
    /// Whether a check that fails or is not judged makes the exit status 1.
    pub strict: bool,
    /// Whether a terminal shows the beam below the report.
    pub drawing: bool,
    pub printed: Printed,
    pub options: Options,
}

impl Solve {
    /// The first option given that is about a single answer.
    pub fn about_one_answer(&self) -> Option<&'static str> {
        let history = self.history.as_ref().map(|_| "--history");
        history.or(self.factors.as_ref().map(|_| "--factors"))
    }
}

/// Whose load factors are asked for.
pub enum Grow {
    /// All loads grow.
    All,
    /// Those of the cases in a list, as typed: it is read with the file.
    Cases(String),
}

/// A picture to draw.
pub struct Plot {
    pub path: PathBuf,
    pub format: Format,
}

/// How a picture is written.
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

/// How a report is set, and on which paper.
#[derive(Debug, Clone, Copy)]
pub enum Setting {
    /// Without a paper, on that of whoever prints it.
    #[cfg(feature = "html")]
    Html(Option<Paper>),
    Pdf(Paper),
}

/// Tell whether an equilibrium exists.
pub struct Check {
    pub file: PathBuf,
    pub json: bool,
    pub printed: Printed,
}

/// The units and the digits of what is printed.
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

    /// The units of a file, or those that were asked for.
    pub fn units(self, own: Units) -> Result<Units, Failure> {
        let rule =
            "--units: the file gives no units, so that no other units follow from its numbers";
        let units = own.in_system(self.asked).ok_or_else(|| Failure::usage(rule.to_owned()))?;
        Ok(units.with_digits(self.digits))
    }
}

/// Prove a result document.
pub struct Verify {
    pub result: PathBuf,
    pub model: PathBuf,
    /// Where the log of the proof is written.
    pub log: Option<PathBuf>,
    /// Whether keys that are not covered count as not proven.
    pub strict: bool,
    pub json: bool,
}

/// Solve a model with every method.
pub struct Compare {
    pub file: PathBuf,
    pub json: bool,
    pub elements: usize,
    pub most_sweeps: usize,
    pub memory_limit: u64,
    pub printed: Printed,
}

/// Write a model file to begin with.
pub struct New {
    pub file: PathBuf,
    pub kind: typed::Starter,
}

/// Show a page on this machine.
#[cfg(feature = "serve")]
pub struct Serve {
    /// The model to begin with.
    pub file: Option<PathBuf>,
    /// 0 takes a free one.
    pub port: u16,
    pub opens_browser: bool,
}

/// Solve a model for many samples.
#[cfg(feature = "study")]
pub struct Study {
    pub file: PathBuf,
    pub out: PathBuf,
    pub samples: Option<u64>,
    pub seed: Option<u64>,
    pub shard: Shard,
    /// 0: as many as there are processors.
    pub threads: usize,
    pub restart: bool,
    pub plot: Option<Plot>,
    pub json: bool,
    pub printed: Printed,
}

/// Put shards together.
#[cfg(feature = "study")]
pub struct Merge {
    pub files: Vec<PathBuf>,
    pub out: PathBuf,
}

#[cfg(feature = "study")]
impl Study {
    /// The options that name outputs.
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

/// `3/8`
#[cfg(feature = "study")]
fn shard(written: &str) -> Result<Shard, Failure> {
    let parts = written.split_once('/').and_then(|(number, of)| {
        Some(Shard { number: number.trim().parse().ok()?, of: of.trim().parse().ok()? })
    });
    let known = parts.filter(|shard| (1..=shard.of).contains(&shard.number));
    known.ok_or_else(|| {
        Failure::usage(format!(
            "--shard {written}: the i-th of N, from 1 on, is written i/N, as in 3/8"
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
            Command::Serve(typed::Serve { file, port, no_open }) => {
                Request::Serve(Serve { file, port, opens_browser: !no_open })
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

    /// The options that name outputs.
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
    /// Its name tells how it is set.
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

/// The remedy where a form is not built in.
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
