//! The tables of a model file, one file each, in the order of [`groundbeam::Model`].

mod beam;
mod foundation;
mod gap;
mod load;
mod soil;
mod support;

use crate::code;
use crate::fault::Fault;
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::Model;
use groundbeam::soil::Bed;

const TABLES: &[&str] = &["title", "beam", "foundation", "load", "support", "gap", "combination"];

/// The whole file, as far as it could be read.
pub(crate) struct Contents {
    pub title: Option<String>,
    pub model: Model,
    pub bed: Option<Bed>,
    /// The load case of each of the model's loads.
    pub cases: Vec<Option<String>>,
}

/// Reads the whole file.
pub(crate) fn read(reader: &mut Reader, root: &Section) -> Contents {
    reader.refuse_unknown(root, TABLES);
    let title = reader.words(root, "title", "Strip footing").map(|(title, _)| title.to_owned());
    let beam = beam::read(reader, root);
    let (foundation, bed) = foundation::read(reader, root, &beam);
    let (loads, cases) = load::read(reader, root, beam.length);
    let supports = support::read(reader, root);
    let gap = gap::read(reader, root);
    for combination in reader.tables(root, "combination", "[[combination]]") {
        unsupported(reader, combination.span);
    }
    Contents { title, model: Model { beam, foundation, loads, supports, gap }, bed, cases }
}

fn unsupported(reader: &mut Reader, span: std::ops::Range<usize>) {
    let message = "combinations of load cases are not supported yet";
    let hint = "write one file for each combination, with the factors multiplied into the loads";
    reader.report(Fault::new(code::UNSUPPORTED, span, message, "", hint));
}
