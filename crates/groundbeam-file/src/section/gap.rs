//! `[[gap]]`.

use crate::quantity::{CLEARANCE, POSITION};
use crate::reader::Reader;
use crate::table::Section;
use groundbeam::GapPoint;
use groundbeam::model::Part;

const KEYS: &[&str] = &["at", "value"];

pub(super) fn read(reader: &mut Reader, root: &Section) -> Vec<GapPoint> {
    let tables = reader.tables(root, "gap", "[[gap]]");
    let mut gap = Vec::new();
    for (i, table) in tables.iter().enumerate() {
        reader.refuse_unknown(table, KEYS);
        reader.places.part(Part::Gap(i), &table.span);
        let at = reader.required(table, "at", &POSITION);
        let value = reader.required(table, "value", &CLEARANCE);
        reader.places.field(Part::Gap(i), "at", &at);
        reader.places.field(Part::Gap(i), "value", &value);
        gap.push(GapPoint { at: at.value, value: value.value });
    }
    gap
}
