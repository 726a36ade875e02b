//! `[foundation]` and `[[foundation.segment]]`.

use crate::quantity::{POSITION, SHEAR_CONSTANT, SPRING_PER_LENGTH, SUBGRADE_MODULUS, WIDTH};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness, cover};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Foundation, FoundationSegment};

const KEYS: &[&str] = &["k", "subgrade_modulus", "width", "mu", "segment"];
const SEGMENT_KEYS: &[&str] = &["from", "to", "k", "subgrade_modulus", "width", "mu"];
const STIFFNESS: Keys = Keys {
    product: ("k", &SPRING_PER_LENGTH),
    factors: [("subgrade_modulus", &SUBGRADE_MODULUS), ("width", &WIDTH)],
    instead: "",
};

pub(super) fn read(reader: &mut Reader, root: &Section, beam_length: f64) -> Foundation {
    let Some(table) = reader.table(root, "foundation", "[foundation]") else {
        if root.value("foundation").is_none() {
            reader.missing(
                root,
                &["foundation"],
                "`[foundation]`",
                "[foundation] with `k`, and `mu` if it shears",
            );
        }
        return Foundation::winkler(f64::NAN);
    };
    reader.refuse_unknown(&table, KEYS);
    reader.places.part(Part::Foundation, &table.span);

    let shear = reader.quantity(&table, "mu", &SHEAR_CONSTANT);
    let shear = shear.unwrap_or_else(|| Field::new(0.0, table.span.clone()));
    reader.places.field(Part::Foundation, "shear", &shear);
    let given = given(reader, &table);
    let stiffness = given.resolve(reader, &Given::default(), &STIFFNESS);
    let known = match &stiffness {
        Stiffness::Known(field) => Some(field.clone()),
        _ => None,
    };

    let mut segments = Vec::new();
    for (i, segment) in
        reader.tables(&table, "segment", "[[foundation.segment]]").iter().enumerate()
    {
        let part = Part::FoundationSegment(i);
        segments.push(read_segment(reader, segment, part, &given, known.as_ref(), &shear));
    }

    let covered = cover(beam_length, segments.iter().map(|s| (s.from, s.to)));
    let rightmost = segments.iter().max_by(|a, b| a.to.total_cmp(&b.to));
    match (&stiffness, rightmost) {
        // Nothing is left for it to hold for; it must only be possible values.
        (Stiffness::NotGiven | Stiffness::Half(..), Some(segment)) if covered => {
            reader.places.field(Part::Foundation, "spring", &Field::unreadable(0..0));
            let (spring, shear) = (segment.spring, segment.shear);
            Foundation { spring, shear, segments }
        }
        _ => {
            let spring = reader.settle(stiffness, &table, &STIFFNESS);
            reader.places.field(Part::Foundation, "spring", &spring);
            Foundation { spring: spring.value, shear: shear.value, segments }
        }
    }
}

/// What a segment leaves out it has from `[foundation]`.
fn read_segment(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    parent: &Given,
    parent_spring: Option<&Field>,
    parent_shear: &Field,
) -> FoundationSegment {
    reader.refuse_unknown(table, SEGMENT_KEYS);
    reader.places.part(part, &table.span);
    let from = reader.required(table, "from", &POSITION);
    let to = reader.required(table, "to", &POSITION);
    let own_shear = reader.quantity(table, "mu", &SHEAR_CONSTANT);
    let stiffness = given(reader, table).resolve(reader, parent, &STIFFNESS);
    let spring = match (&stiffness, parent_spring) {
        // A value of the parent's is reported at the parent if it is wrong.
        (Stiffness::NotGiven, Some(spring)) if own_shear.is_some() => {
            reader.places.field(part, "spring", &Field::unreadable(0..0));
            spring.clone()
        }
        _ => {
            let spring = reader.settle(stiffness, table, &STIFFNESS);
            reader.places.field(part, "spring", &spring);
            spring
        }
    };
    let inherited = Field::unreadable(0..0);
    reader.places.field(part, "shear", own_shear.as_ref().unwrap_or(&inherited));
    let shear = own_shear.map_or(parent_shear.value, |shear| shear.value);
    reader.places.field(part, "from", &from);
    reader.places.field(part, "to", &to);
    FoundationSegment { from: from.value, to: to.value, spring: spring.value, shear }
}

fn given(reader: &mut Reader, table: &Section) -> Given {
    let product = reader.quantity(table, "k", &SPRING_PER_LENGTH);
    let modulus = reader.quantity(table, "subgrade_modulus", &SUBGRADE_MODULUS);
    let modulus = modulus.map(|modulus| reader.positive("subgrade_modulus", modulus));
    let width = reader.quantity(table, "width", &WIDTH);
    let width = width.map(|width| reader.positive("width", width));
    Given { product, factors: [modulus, width] }
}
