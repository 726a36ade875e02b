//! The tables of a model file, one file each, in the order of [`groundbeam::Model`].

mod beam;
mod foundation;
mod gap;
mod load;
mod support;

use crate::code;
use crate::fault::Fault;
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::Model;

const TABLES: &[&str] = &["title", "beam", "foundation", "load", "support", "gap", "combination"];

/// Reads the whole file: its title, and its model as far as it could be read.
pub(crate) fn read(reader: &mut Reader, root: &Section) -> (Option<String>, Model) {
    reader.refuse_unknown(root, TABLES);
    let title = reader.words(root, "title", "Strip footing").map(|(title, _)| title.to_owned());
    let beam = beam::read(reader, root);
    let foundation = foundation::read(reader, root, beam.length);
    let loads = load::read(reader, root, beam.length);
    let supports = support::read(reader, root);
    let gap = gap::read(reader, root);
    for combination in reader.tables(root, "combination", "[[combination]]") {
        unsupported(reader, combination.span);
    }
    (title, Model { beam, foundation, loads, supports, gap })
}

fn unsupported(reader: &mut Reader, span: std::ops::Range<usize>) {
    let message = "load cases and combinations are not supported yet";
    let hint = "write one file for each combination, with the factors multiplied into the loads";
    reader.report(Fault::new(code::UNSUPPORTED, span, message, "", hint));
}
