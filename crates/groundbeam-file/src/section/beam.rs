//! `[beam]` and `[[beam.segment]]`.

use crate::quantity::{
    BENDING_STIFFNESS, ELASTIC_MODULUS, FORCE, LENGTH, POSITION, SECOND_MOMENT_OF_AREA, WIDTH,
};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness, cover};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Beam, BeamSegment};

const KEYS: &[&str] = &["length", "EI", "E", "I", "section", "axial_force", "segment"];
const SEGMENT_KEYS: &[&str] = &["from", "to", "EI", "E", "I", "section"];
const SECTION_KEYS: &[&str] = &["width", "height"];
const STIFFNESS: Keys = Keys {
    product: ("EI", &BENDING_STIFFNESS),
    factors: [("E", &ELASTIC_MODULUS), ("I", &SECOND_MOMENT_OF_AREA)],
    instead: " or a `section`",
};

pub(super) fn read(reader: &mut Reader, root: &Section) -> Beam {
    let unknown = Beam::uniform(f64::NAN, f64::NAN);
    let Some(table) = reader.table(root, "beam", "[beam]") else {
        if root.value("beam").is_none() {
            reader.missing(root, &["beam"], "`[beam]`", "[beam] with `length` and `EI`");
        }
        return unknown;
    };
    reader.refuse_unknown(&table, KEYS);
    reader.places.part(Part::Beam, &table.span);

    let length = reader.required(&table, "length", &LENGTH);
    reader.places.field(Part::Beam, "length", &length);
    let axial_force = reader.quantity(&table, "axial_force", &FORCE);
    let axial_force = axial_force.unwrap_or_else(|| Field::new(0.0, table.span.clone()));
    reader.places.field(Part::Beam, "axial_force", &axial_force);

    let given = given(reader, &table);
    let mut segments = Vec::new();
    for (i, segment) in reader.tables(&table, "segment", "[[beam.segment]]").iter().enumerate() {
        segments.push(read_segment(reader, segment, Part::BeamSegment(i), &given));
    }

    let stiffness = given.resolve(reader, &Given::default(), &STIFFNESS);
    let covered = cover(length.value, segments.iter().map(|s| (s.from, s.to)));
    let rightmost = segments.iter().max_by(|a, b| a.to.total_cmp(&b.to));
    let bending_stiffness = match (&stiffness, rightmost) {
        // Nothing is left for it to hold for; it must only be a possible value.
        (Stiffness::NotGiven | Stiffness::Half(..), Some(segment)) if covered => {
            reader.places.field(Part::Beam, "bending_stiffness", &Field::unreadable(0..0));
            segment.bending_stiffness
        }
        _ => {
            let field = reader.settle(stiffness, &table, &STIFFNESS);
            reader.places.field(Part::Beam, "bending_stiffness", &field);
            field.value
        }
    };
    Beam { length: length.value, bending_stiffness, segments, axial_force: axial_force.value }
}

fn read_segment(reader: &mut Reader, table: &Section, part: Part, parent: &Given) -> BeamSegment {
    reader.refuse_unknown(table, SEGMENT_KEYS);
    reader.places.part(part, &table.span);
    let from = reader.required(table, "from", &POSITION);
    let to = reader.required(table, "to", &POSITION);
    let stiffness = given(reader, table).resolve(reader, parent, &STIFFNESS);
    let stiffness = reader.settle(stiffness, table, &STIFFNESS);
    reader.places.field(part, "from", &from);
    reader.places.field(part, "to", &to);
    reader.places.field(part, "bending_stiffness", &stiffness);
    BeamSegment { from: from.value, to: to.value, bending_stiffness: stiffness.value }
}

fn given(reader: &mut Reader, table: &Section) -> Given {
    let product = reader.quantity(table, "EI", &BENDING_STIFFNESS);
    let modulus = reader.quantity(table, "E", &ELASTIC_MODULUS);
    let modulus = modulus.map(|modulus| reader.positive("E", modulus));
    let inertia = reader.quantity(table, "I", &SECOND_MOMENT_OF_AREA);
    let inertia = inertia.map(|inertia| reader.positive("I", inertia));
    let section = rectangle(reader, table);
    if let (Some(inertia), Some(section)) = (&inertia, &section) {
        let hint = "the section gives I = width height^3 / 12; keep one of the two";
        reader.exclusive(("I", &inertia.span), ("section", &section.span), hint);
    }
    Given { product, factors: [modulus, inertia.or(section)] }
}

/// I = b h³ / 12 of `section = { width, height }`.
fn rectangle(reader: &mut Reader, table: &Section) -> Option<Field> {
    let Some(section) = reader.table(table, "section", "section") else {
        // Of the wrong type, and reported: as if given, to keep "I is missing" out.
        return table.value("section").map(|value| Field::unreadable(value.span()));
    };
    reader.refuse_unknown(&section, SECTION_KEYS);
    let width = reader.required(&section, "width", &WIDTH);
    let width = reader.positive("width", width);
    let height = reader.required(&section, "height", &WIDTH);
    let height = reader.positive("height", height);
    Some(Field::new(width.value * height.value.powi(3) / 12.0, section.span))
}
