//! Reads model files (TOML with units) into a [`groundbeam::Model`].
//!
//! ```
//! let document = groundbeam_file::parse(
//!     r#"
//!     title = "Strip footing under one column"
//!
//!     [beam]
//!     length = "12 m"
//!     E = "30 GPa"
//!     section = { width = "1 m", height = "0.8 m" }
//!
//!     [foundation]
//!     subgrade_modulus = "40 MN/m^3"
//!     width = "1 m"
//!
//!     [[load]]
//!     point = "600 kN"
//!     at = "1 m"
//!     "#,
//! )?;
//! assert_eq!(document.model.beam.length, 12.0);
//! assert_eq!(document.model.foundation.subgrade, 40e6);
//! # Ok::<(), groundbeam_file::Diagnostics>(())
//! ```
//!
//! All faults of a file are reported together, each with its location and a remedy ([`Diagnostics`]).
//!
//! In a file, either all quantities have a unit or none has. Numbers with units are converted to SI with one rounding.
//! Numbers without units form one consistent system.

mod band;
mod beside;
mod case_names;
mod cases;
mod catalogue;
mod code;
mod combination;
mod demand;
mod diagnostic;
mod document;
#[cfg(test)]
mod documents;
mod fault;
mod files;
mod implausible;
mod keys;
mod list;
mod materials;
mod misread;
mod moving;
mod number;
pub mod output;
mod positions;
pub mod print;
mod printable;
mod profile;
mod profiles;
mod quantity;
mod reader;
mod render;
mod schema;
mod section;
mod sets;
mod source;
mod stiffness;
pub mod study;
mod suggest;
mod syntax;
mod table;
mod target;
mod trains;
mod unit;
mod units;
mod words;
mod write;

pub use band::Band;
pub use beside::{Beside, OtherFile};
pub use cases::parse_cases;
pub use code::{CODES, Code, Page};
pub use combination::{Combination, LoadCase};
pub use demand::{Place, Sign};
pub use diagnostic::{Diagnostic, Diagnostics, Related, Severity};
pub use document::{Depth, Document, Quantity};
pub use files::{open_file, read_bounded, read_file};
pub use materials::{Material, materials};
pub use moving::{MovingTrain, Spread};
pub use positions::{parse_positions, parse_positions_on_beam};
pub use printable::{is_unprintable, printable};
pub use profiles::{RolledSection, rail_sections, rolled_sections};
pub use schema::{model_schema, study_schema};
pub use sets::{CombinationSet, combination_sets};
pub use target::{
    Change, Course, Shape, along_the_beam, change, most_control_values, problem,
    set_the_same_number,
};
pub use trains::{TrainSet, train_sets};
pub use units::UnitSystem;
pub use write::write_toml;

use fault::Fault;
use reader::Reader;
use section::{Contents, Ground};
use source::Source;
use table::Section;
use toml::de::DeTable;

/// Reads a model file that names no other files.
///
/// # Errors
///
/// Returns all faults of the file, including [`Model::problems`](groundbeam::Model::problems). If the file is invalid
/// TOML, returns only the syntax faults.
pub fn parse(text: &str) -> Result<Document, Diagnostics> {
    read(text, None, false)
}

/// Reads a model file in a folder, and the files that the model file names.
///
/// # Errors
///
/// Returns the same faults as [`parse`]. The location of a fault in a named file lies in that file.
pub fn parse_beside<'a>(
    text: &str,
    beside: impl Into<Beside<'a>>,
) -> Result<Document, Diagnostics> {
    read(text, Some(beside.into()), false)
}

/// Reads a model that a program wrote, and the files that it names. Numbers without a unit are in SI units.
///
/// ```
/// let text = "[beam]\nlength = '12 m'\nEI = 1.28e9\n[foundation]\nk = '40 MN/m^2'\nmu = 9e6\n";
/// let model = groundbeam_file::parse_si(text, None)?.model;
/// assert_eq!((model.beam.bending_stiffness, model.foundation.subgrade), (1.28e9, 40e6));
/// assert!(groundbeam_file::parse(text).is_err(), "a file that a person wrote does not mix them");
/// # Ok::<(), groundbeam_file::Diagnostics>(())
/// ```
///
/// # Errors
///
/// Returns the same faults as [`parse_beside`].
pub fn parse_si(text: &str, beside: Option<Beside>) -> Result<Document, Diagnostics> {
    read(text, beside, true)
}

fn read(text: &str, beside: Option<Beside>, bare_is_si: bool) -> Result<Document, Diagnostics> {
    let source = Source::new(text);
    let (table, errors) = DeTable::parse_recoverable(text);
    let syntax = syntax::explain(&source, table.get_ref(), &errors, &section::MODEL);
    if !syntax.readable {
        return Err(Diagnostics::new(syntax.found));
    }
    let root = Section::root(table.get_ref(), &section::MODEL);
    if root.table.is_empty() {
        return Err(Diagnostic::new(&source, no_model()).into());
    }
    let mut reader = Reader::new(&source, &root, beside, bare_is_si);
    reader.found = syntax.found;
    let contents = section::read(&mut reader, &root);
    let model = &contents.model;
    let before = reader.found.len();
    let units = reader.unit_system().unwrap_or(UnitSystem::Plain);
    let printed = units::printed(units, &reader.quantities);
    let is_mixed = reader.found.len() > before;
    // Lengths with and without units cannot be compared, so the model of a file with mixed units is not checked.
    if !is_mixed {
        let problems = model.problems();
        for problem in &problems {
            if let Some(span) = reader.places.of(problem) {
                reader.found.push(document::diagnostic(&source, span, problem, printed));
            }
        }
        // If no error has been reported so far, every problem of the model is reported at the heading of its table. So
        // a model with a problem is never accepted.
        if reader.found.is_empty() {
            let told = problems.iter().map(|problem| {
                let span = reader.places.part_of(problem).unwrap_or(0..0);
                document::diagnostic(&source, span, problem, printed)
            });
            let told: Vec<Diagnostic> = told.collect();
            reader.found.extend(told);
        }
    }
    let warnings = implausible::warnings(&reader, &contents, printed);
    let Contents { title, model, chords, ground, limits, cases, recipes, trains, depths, .. } =
        contents;
    let quantities = reader.located(units);
    let Reader { found, places, others, .. } = reader;
    if found.is_empty() {
        let Ground { width, band, .. } = ground;
        Ok(Document {
            title,
            model,
            chords,
            width,
            band,
            limits,
            cases,
            recipes,
            trains,
            depths,
            quantities,
            files: others,
            units,
            printed,
            warnings,
            source,
            places,
        })
    } else {
        Err(Diagnostics::new(found))
    }
}

/// Returns the text of a file, which must be UTF-8.
///
/// # Errors
///
/// Returns one diagnostic at the first byte that is not UTF-8. Its text for rendering is
/// `String::from_utf8_lossy(bytes)`.
pub fn text_of(bytes: &[u8]) -> Result<&str, Diagnostics> {
    std::str::from_utf8(bytes).map_err(|error| {
        let source = Source::new(&String::from_utf8_lossy(bytes));
        let start = error.valid_up_to();
        let wide = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
        let hint =
            if wide { "the file looks like UTF-16; save it as UTF-8" } else { "save it as UTF-8" };
        let message = "the file is not UTF-8 text";
        let fault = Fault::new(code::NOT_UTF8, start..start + 1, message, "not a character", hint);
        Diagnostic::new(&source, fault).into()
    })
}

fn no_model() -> Fault {
    let hint = "a model has at least [beam] with `length` and `EI`, and [foundation] with `k`";
    Fault::new(code::EMPTY, 0..0, "the file contains no model", "", hint)
}
