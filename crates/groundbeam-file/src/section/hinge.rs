//! `[[hinge]]`.

use crate::lists;
use crate::quantity::{POSITION, ROTATIONAL_SPRING};
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::Hinge;
use groundbeam::model::Part;

const KEYS: &[&str] = &["at", "rotational_spring"];

pub(super) fn read(reader: &mut Reader, root: &Section) -> Vec<Hinge> {
    let tables = reader.tables(root, &lists::HINGE);
    let mut hinges = Vec::new();
    for (i, table) in tables.iter().enumerate() {
        let part = Part::Hinge(i);
        reader.refuse_unknown(table, KEYS);
        reader.places.part(part, &table.span);
        let at = reader.required(table, "at", &POSITION);
        reader.places.field(part, "at", &at);
        let spring = reader.quantity(table, "rotational_spring", &ROTATIONAL_SPRING);
        if let Some(spring) = &spring {
            reader.places.field(part, "rotational_spring", spring);
        }
        let rotational_spring = spring.map_or(0.0, |spring| spring.value);
        hinges.push(Hinge { at: at.value, rotational_spring });
    }
    hinges
}
