//! `[beam]` and `[[beam.segment]]`.

use crate::profile::{Along, Values, left_out};
use crate::quantity::{
    BENDING_STIFFNESS, ELASTIC_MODULUS, FORCE, LENGTH, POSITION, SECOND_MOMENT_OF_AREA, WIDTH,
};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness, cover};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Beam, BeamSegment, Profile};

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
        let part = Part::BeamSegment(i);
        segments.push(read_segment(reader, segment, part, &given, length.value));
    }

    let stiffness = given.resolve(reader, &Given::default(), &STIFFNESS);
    let covered = cover(length.value, segments.iter().map(|s| (s.from, s.to)));
    let rightmost = segments.iter().max_by(|a, b| a.to.total_cmp(&b.to));
    let bending_stiffness = match (&stiffness, rightmost) {
        // Nothing is left for it to hold for; it must only be a possible value.
        (Stiffness::NotGiven | Stiffness::Half(..), Some(segment)) if covered => {
            reader.places.field(Part::Beam, "bending_stiffness", &Field::unreadable(0..0));
            segment.bending_stiffness.end()
        }
        _ => {
            let known = reader.settle(stiffness, &table, &STIFFNESS);
            reader.places.field(Part::Beam, "bending_stiffness", &known.field());
            add_where_it_varies(reader, &known, length.value, &mut segments);
            known.profile.start()
        }
    };
    Beam { length: length.value, bending_stiffness, segments, axial_force: axial_force.value }
}

/// A stiffness that varies along the whole beam holds where no segment says otherwise.
fn add_where_it_varies(
    reader: &mut Reader,
    whole: &Along,
    length: f64,
    segments: &mut Vec<BeamSegment>,
) {
    // A wrong beginning is reported once.
    if whole.profile.is_constant() || whole.profile.start() <= 0.0 {
        return;
    }
    for [from, to] in left_out(length, segments.iter().map(|s| (s.from, s.to))) {
        let own = whole.between([from / length, to / length]);
        let part = Part::BeamSegment(segments.len());
        reader.places.field(part, "bending_stiffness", &own.field());
        segments.push(BeamSegment { from, to, bending_stiffness: own.profile });
    }
}

fn read_segment(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    parent: &Given,
    length: f64,
) -> BeamSegment {
    reader.refuse_unknown(table, SEGMENT_KEYS);
    reader.places.part(part, &table.span);
    let from = reader.required(table, "from", &POSITION);
    let to = reader.required(table, "to", &POSITION);
    let parent = parent.between([from.value / length, to.value / length]);
    let stiffness = given(reader, table).resolve(reader, &parent, &STIFFNESS);
    let stiffness = reader.settle(stiffness, table, &STIFFNESS);
    reader.places.field(part, "from", &from);
    reader.places.field(part, "to", &to);
    reader.places.field(part, "bending_stiffness", &stiffness.field());
    BeamSegment { from: from.value, to: to.value, bending_stiffness: stiffness.profile }
}

fn given(reader: &mut Reader, table: &Section) -> Given {
    let curve = Values::Curve(Profile::MOST);
    let product = reader.along(table, "EI", &BENDING_STIFFNESS, curve);
    let modulus = reader.along(table, "E", &ELASTIC_MODULUS, Values::Linear);
    let modulus = modulus.map(|modulus| reader.positive_along("E", modulus));
    let inertia = reader.along(table, "I", &SECOND_MOMENT_OF_AREA, Values::Linear);
    let inertia = inertia.map(|inertia| reader.positive_along("I", inertia));
    let section = rectangle(reader, table);
    if let (Some(inertia), Some(section)) = (&inertia, &section) {
        let hint = "the section gives I = width height^3 / 12; keep one of the two";
        reader.exclusive(("I", &inertia.span), ("section", &section.span), hint);
    }
    Given { product, factors: [modulus, inertia.or(section)] }
}

/// I = b h³ / 12 of `section = { width, height }`.
fn rectangle(reader: &mut Reader, table: &Section) -> Option<Along> {
    let Some(section) = reader.table(table, "section", "section") else {
        // Of the wrong type, and reported: as if given, to keep "I is missing" out.
        return table.value("section").map(|value| Along::unreadable(value.span()));
    };
    reader.refuse_unknown(&section, SECTION_KEYS);
    let mut side = |key: &'static str| {
        let given = reader.along(&section, key, &WIDTH, Values::Linear);
        let given = given.map(|given| reader.positive_along(key, given));
        given.unwrap_or_else(|| {
            let missing = reader.required(&section, key, &WIDTH);
            Along::unreadable(missing.span)
        })
    };
    let [width, height] = ["width", "height"].map(&mut side);
    let span = section.span;
    if width.profile.is_constant() && height.profile.is_constant() {
        let inertia = width.profile.start() * height.profile.start().powi(3) / 12.0;
        return Some(Along { profile: Profile::constant(inertia), span });
    }
    let product = [&height, &height, &height].into_iter().fold(width, |a, b| a.times(b, &span));
    Some(Along { profile: product.profile.scaled(1.0 / 12.0), span })
}
