//! Reads study files, which name the model and define its random parameters, the sampling method and the requested results.

mod event;
mod field;
mod keep;
mod random;
mod sampling;

pub use event::{BUILT_IN, Event, Exceeds, Judged};
pub use field::{Correlation, FieldOf, Method, RandomField, Share};
pub use keep::Keep;
pub use random::{Distribution, Joined, Random};
pub use sampling::{Plan, Sampling};

use crate::beside::{Beside, OtherFile};
use crate::diagnostic::Diagnostics;
use crate::document::Document;
use crate::fault::Fault;
use crate::keys::{Table, Value, key, table, tables, text, word};
use crate::printable::printable;
use crate::reader::Reader;
use crate::source::Source;
use crate::table::Section;
use crate::{code, no_model, parse_beside, syntax, text_of};
use std::path::{Path, PathBuf};
use toml::de::DeTable;

/// Tables of a study file.
pub(crate) static STUDY: Table = Table {
    name: "the file",
    keys: &[
        text("title", "Footing on random ground", "The title of the summary."),
        text("model", "strip-footing.toml", "The model: a file in the folder of the study file.")
            .needed(),
        key(
            "samples",
            Value::Count([1, sampling::MOST_SAMPLES]),
            "The number of samples; default: 10000.",
        ),
        key(
            "seed",
            Value::Count([0, i64::MAX as u64]),
            "The seed of all random numbers; default: 0.",
        ),
        word("sampling", &sampling::NAMES, "The sampling method; default: `monte-carlo`."),
        key(
            "replicates",
            Value::Count([1, sampling::MOST_REPLICATES]),
            "The number of independent hypercubes or sequences; default: 16.",
        ),
        tables("random", &random::TABLE, "A random parameter of the model."),
        tables("correlated", &random::CORRELATED, "The correlation of two random parameters."),
        table("field", &field::TABLE, "Random fields along the beam."),
        table("keep", &keep::TABLE, "The values saved for each sample."),
        tables("event", &event::TABLE, "A condition whose probability is estimated."),
    ],
};

/// Contents of a study file that has been read, with its model.
#[derive(Debug, Clone)]
pub struct StudyFile {
    /// Path of the study file, relative to the working directory.
    pub path: PathBuf,
    /// Title of the study, if the file gives one.
    pub title: Option<String>,
    /// Text of the study file.
    pub text: String,
    /// Path of the model file, relative to the working directory.
    pub model_path: PathBuf,
    /// Contents of the model file, with the model.
    pub document: Document,
    /// Number of samples, seed and sampling method.
    pub plan: Plan,
    /// Random parameters of the model.
    pub random: Vec<Random>,
    /// Correlations between the random parameters.
    pub joined: Vec<Joined>,
    /// Random fields of the ground stiffness and of the bending stiffness along the beam.
    pub field: Option<RandomField>,
    /// Values saved for each sample.
    pub keep: Keep,
    /// Events whose probability is estimated.
    pub events: Vec<Event>,
}

/// Reads a study file, the model that it names, and the files that the model names.
///
/// # Errors
///
/// Returns the error of a file that cannot be read, or all faults of the study file or of the model file.
pub fn read_study(path: &Path) -> Result<StudyFile, StudyError> {
    read(path, folder_of(path).into())
}

/// Reads a study from files in memory, as [`StudyFile::files`] returns them.
///
/// # Errors
///
/// Returns the same errors as [`read_study`].
pub fn read_held_study(path: &Path, files: &[OtherFile]) -> Result<StudyFile, StudyError> {
    read(path, Beside::held(folder_of(path), files))
}

fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

fn read(path: &Path, beside: Beside) -> Result<StudyFile, StudyError> {
    let unreadable = |error| StudyError::Unreadable(path.to_owned(), error);
    let bytes = beside.read_path(path).map_err(unreadable)?;
    let wrong = |found| StudyError::wrong(found, path, &bytes);
    let text = text_of(&bytes).map_err(wrong)?;
    match parse(path, text, beside) {
        Ok(study) => Ok(study),
        Err(At::Study(found)) => Err(wrong(found)),
        Err(At::Model(error)) => Err(error),
    }
}

impl StudyFile {
    /// Returns all files of the study: the study file, the model file, and the files that the model names.
    pub fn files(&self) -> Vec<OtherFile> {
        let of = |path: &Path, text: &str| OtherFile {
            name: path.display().to_string(),
            text: text.to_owned(),
        };
        let own = [of(&self.path, &self.text), of(&self.model_path, self.document.text())];
        let others = self.document.files.iter().map(|file| OtherFile::clone(file));
        own.into_iter().chain(others).collect()
    }
}

/// Faults of the study file, or an error of its model file.
enum At {
    Study(Diagnostics),
    Model(StudyError),
}

impl From<Diagnostics> for At {
    fn from(found: Diagnostics) -> Self {
        At::Study(found)
    }
}

fn parse(path: &Path, text: &str, beside: Beside) -> Result<StudyFile, At> {
    let source = Source::new(text);
    let (table, errors) = DeTable::parse_recoverable(text);
    let syntax = syntax::explain(&source, table.get_ref(), &errors, &STUDY);
    if !syntax.readable {
        return Err(Diagnostics::new(syntax.found).into());
    }
    let root = Section::root(table.get_ref(), &STUDY);
    if root.table.is_empty() {
        let fault = Fault { message: "the file contains no study".to_owned(), ..no_model() };
        let hint = "a study needs the key `model` and a table [[random]] or [field]";
        let fault = Fault { hint: hint.to_owned(), ..fault };
        return Err(Diagnostics::from(crate::Diagnostic::new(&source, fault)).into());
    }
    let mut reader = Reader::new(&source, &root, Some(beside), false);
    reader.found = syntax.found;
    reader.refuse_unknown(&root);
    let title = reader.text(&root, "title");
    let title = title.map(|(title, _)| title.to_owned());
    let model = model(&mut reader, &root, beside)?;
    let plan = sampling::read(&mut reader, &root);
    let Some((model_path, document)) = model else {
        return Err(Diagnostics::new(reader.found).into());
    };
    let random = random::read(&mut reader, &root, &document);
    let joined = random::read_joined(&mut reader, &root, &random);
    let field = field::read(&mut reader, &root, &document, &random);
    let keep = keep::read(&mut reader, &root);
    let events = event::read(&mut reader, &root);
    if random.is_empty() && field.is_none() && reader.found.is_empty() {
        reader.missing(&root, &["random", "field"], "random quantity", "[[random]] or [field]");
    }
    let first = reader.quantities.iter().find(|quantity| !quantity.is_bare_zero);
    let span = first.map_or(0..0, |quantity| quantity.span.clone());
    let units = reader.unit_system();
    if units.is_some_and(|units| units != document.units) && reader.found.is_empty() {
        let message = match document.units {
            crate::UnitSystem::Si => {
                "the model's quantities have units, so the study's quantities need units too"
            }
            crate::UnitSystem::Plain => {
                "the model's quantities have no units, so the study's quantities must have none"
            }
        };
        let hint = "write the study's quantities with units if the model's have units, and without units otherwise";
        reader.report(Fault::new(code::MIXED, span, message, "", hint));
    }
    if !reader.found.is_empty() {
        return Err(Diagnostics::new(reader.found).into());
    }
    let (path, text) = (path.to_owned(), text.to_owned());
    Ok(StudyFile {
        title,
        path,
        text,
        model_path,
        document,
        plan,
        random,
        joined,
        field,
        keep,
        events,
    })
}

/// Reason why a study cannot be read.
#[derive(Debug)]
pub enum StudyError {
    /// The study file cannot be read.
    Unreadable(PathBuf, std::io::Error),
    /// Faults in the study file or in the model file, with the path and the text of that file.
    Wrong(Diagnostics, PathBuf, String),
}

impl StudyError {
    fn wrong(found: Diagnostics, path: &Path, bytes: &[u8]) -> Self {
        StudyError::Wrong(found, path.to_owned(), String::from_utf8_lossy(bytes).into_owned())
    }
}

impl std::fmt::Display for StudyError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            StudyError::Unreadable(path, error) => {
                write!(f, "{}: {error}", printable(&path.to_string_lossy()))
            }
            StudyError::Wrong(found, ..) => found.fmt(f),
        }
    }
}

impl std::error::Error for StudyError {}

/// Reads the model of the study.
fn model(
    reader: &mut Reader,
    root: &Section,
    beside: Beside,
) -> Result<Option<(PathBuf, Document)>, At> {
    let Some((name, span)) = reader.text(root, "model") else { return Ok(None) };
    let (path, bytes) = beside.read(name);
    let bytes = match bytes {
        Ok(bytes) => bytes,
        Err(error) => {
            let message = format!("`{name}` cannot be read: {error}");
            let hint = "the name is relative to the folder of the study file";
            reader.report(Fault::new(code::FILE, span, message, "", hint));
            return Ok(None);
        }
    };
    let beside = beside.from(folder_of(&path));
    let read = text_of(&bytes).and_then(|text| parse_beside(text, beside));
    match read {
        Ok(document) => {
            let several = match () {
                () if !document.trains.is_empty() => Some("trains"),
                () if document.has_combinations() => {
                    Some("combinations or a range of ground stiffness")
                }
                () => None,
            };
            if let Some(what) = several {
                let message = format!(
                    "`{name}` has {what}, but a study needs a model with a single solution"
                );
                let hint =
                    "use a model file without trains, combinations or ranges of ground stiffness";
                reader.report(Fault::new(code::EXCLUSIVE, span, message, "", hint));
                return Ok(None);
            }
            Ok(Some((path, document)))
        }
        Err(found) => Err(At::Model(StudyError::wrong(found, &path, &bytes))),
    }
}
