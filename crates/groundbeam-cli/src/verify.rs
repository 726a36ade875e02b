//! Runs the command `groundbeam verify`, which proves the results in a document.

use crate::colour::standard_output_has_colour;
use crate::command::Verify;
use crate::distinct;
use crate::failure::Failure;
use crate::input::{Input, bytes_of};
use crate::output::{print, write};
use crate::status::Status;
use groundbeam::proof::{self, Document, Log, NotProven, Reason, Verification, Wide};
use groundbeam_report::{LeftOut, ModelOf, Named, Units, Verified, digest_of_text, json, text};
use std::fmt::Display;
use std::path::{Path, PathBuf};

pub fn run(request: &Verify) -> Result<Status, Failure> {
    if [&request.result, &request.model].iter().all(|path| path.as_os_str() == "-") {
        let words = "document and model file cannot both be `-`: name a file for one of them";
        return Err(Failure::usage(words.to_owned()));
    }
    let documents = documents(&request.result)?;
    let model = ModelFile::read(&request.model)?;
    let log = request.log.as_deref().map(|path| ("--log", path));
    let inputs = model.files.iter().chain([&request.result, &request.model]);
    distinct::check(log, inputs.map(PathBuf::as_path))?;
    let mut logs = Vec::new();
    let verified = Verified {
        units: model.units.unwrap_or(Units::PLAIN),
        other_model: model.differs_from(&documents),
        left_out: model.left_out(&documents),
        results: documents
            .iter()
            .map(|document| {
                let mut log = request.log.is_some().then(Log::new);
                let named = prove_and_log(&model.text, &model.name, document, log.as_mut());
                logs.extend(log.map(|log| logged(document, &log)));
                named
            })
            .collect::<Result<_, Failure>>()?,
    };
    if let Some(path) = &request.log {
        write(path, logs.concat().as_bytes())?;
    }
    print(&match request.json {
        true => json::verified(&verified),
        false => text::verified(&verified, standard_output_has_colour()),
    })?;
    Ok(match (verified.is_proven(), verified.is_of_document()) {
        (false, _) => Status::NotProven,
        (true, _) if request.strict && verified.leaves_out() => Status::NotProven,
        (true, true) => Status::ProvenForDocument,
        (true, false) => Status::Done,
    })
}

/// Reads all result documents in a file.
fn documents(path: &Path) -> Result<Vec<Document>, Failure> {
    let (name, bytes) = bytes_of(path)?;
    let failure = |error: &dyn Display| {
        let remedy =
            "`groundbeam solve MODEL --json --pieces` writes a document that can be verified";
        Failure::file(Path::new(&name), &format!("{error}; {remedy}"))
    };
    if bytes.is_empty() {
        return Err(failure(&"the file is empty"));
    }
    let text = std::str::from_utf8(&bytes).map_err(|error| failure(&error))?;
    let read = Document::read(text).map_err(|error| failure(&error))?;
    if read.is_empty() { Err(failure(&"the document has no results")) } else { Ok(read) }
}

/// Model file for the proof checker, which has its own reader of model files.
struct ModelFile {
    name: String,
    text: String,
    digest: String,
    /// Units of the file according to the solver's reader; `None` if this reader refuses the file.
    units: Option<Units>,
    /// Names of the file's combinations according to the solver's reader.
    combinations: Vec<String>,
    /// Files that the model file names.
    files: Vec<PathBuf>,
}

impl ModelFile {
    /// Reads the model file with the solver's reader, which locates faults, and with the proof's own reader.
    fn read(path: &Path) -> Result<Self, Failure> {
        let (name, bytes) = bytes_of(path)?;
        let text = groundbeam_file::text_of(&bytes).map_err(|found| {
            Failure::diagnostics(&found, &name, &String::from_utf8_lossy(&bytes))
        })?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let of_solver = Input::of(name.clone(), &bytes, folder);
        let of_any = proof::read_model::<Wide>(text, None).map_err(|error| error.reason);
        let (digest, units, combinations, files) = match (of_solver, of_any) {
            (Ok(input), _) => {
                let names = input.document.combinations().into_iter().map(|c| c.name);
                let units = input.units();
                let files = input.document.files.iter().map(|file| PathBuf::from(&file.name));
                (input.digest().to_owned(), Some(units), names.collect(), files.collect())
            }
            (Err(_), Ok(_) | Err(Reason::OutOfRange(_))) => {
                (digest_of_text(text), None, Vec::new(), Vec::new())
            }
            (Err(failure), Err(_)) => return Err(failure),
        };
        Ok(ModelFile { name, text: text.to_owned(), digest, units, combinations, files })
    }

    /// Returns the combinations of the file that have no result in the documents.
    fn left_out(&self, documents: &[Document]) -> Option<LeftOut> {
        let is_there =
            |name: &&String| documents.iter().any(|d| d.combination.as_ref() == Some(*name));
        let names = self.combinations.iter().filter(|name| !is_there(name)).cloned();
        let (all, names) = (self.combinations.len(), names.collect::<Vec<_>>());
        (!names.is_empty()).then_some(LeftOut { all, names })
    }

    /// Returns a message if the documents do not belong to the file, because their digest or their units differ.
    fn differs_from(&self, documents: &[Document]) -> Option<String> {
        let mut units = documents.iter().filter_map(|document| document.units.as_deref());
        if let Some(own) = self.units.map(Units::name)
            && let Some(other) = units.find(|units| *units != own)
        {
            return Some(format!(
                "the units of the document are `{other}`, those of {} are `{own}`",
                self.name
            ));
        }
        let mut digests = documents.iter().filter_map(|document| document.model_digest.as_deref());
        let other = digests.find(|digest| *digest != self.digest)?;
        let [other, own] = [other, &self.digest].map(|d| d.chars().take(19).collect::<String>());
        Some(format!(
            "the document belongs to another model file: its digest is {other}…, that of {0} is {own}…; name its own \
             model file, or solve {0} again",
            self.name
        ))
    }
}

/// Proves one result. The model is read from the file, or from the document if the proof's own reader does not know a
/// key of the file.
pub fn prove(text: &str, name: &str, document: &Document) -> Result<Named, Failure> {
    prove_and_log(text, name, document, None)
}

/// Returns the text of a log, preceded by a line that names its result.
fn logged(document: &Document, log: &Log) -> String {
    let combination = serde_json::json!(document.combination);
    format!("{{\"name\":\"result\",\"combination\":{combination}}}\n{}", log.text())
}

/// Proves one result and writes the log of the proof.
fn prove_and_log(
    text: &str,
    name: &str,
    document: &Document,
    log: Option<&mut Log>,
) -> Result<Named, Failure> {
    let combination = document.combination.clone();
    let read = proof::read_model::<Wide>(text, combination.as_deref());
    let named = |model: ModelOf, found: Result<Verification, NotProven>| {
        Ok(Named { combination: combination.clone(), model, found })
    };
    let error = match read {
        Ok(model) => return named(ModelOf::File, proof::verify_and_log(&model, document, log)),
        Err(error) => error,
    };
    match (&error.reason, &document.model) {
        (Reason::NotRead(_), Some(own)) => {
            let model = proof::read_model::<Wide>(own, None).map_err(|error| {
                Failure::usage(format!("the model in the document cannot be read: {error}"))
            })?;
            named(ModelOf::Document, proof::verify_and_log(&model, document, log))
        }
        (Reason::NotRead(_) | Reason::NoCombination(_) | Reason::OutOfRange(_), _) => {
            named(ModelOf::File, Err(NotProven::new(error.to_string())))
        }
        _ => Err(Failure::usage(format!("{}: {error}", name))),
    }
}
