//! `[foundation]` and `[[foundation.segment]]`.

use super::{band, soil};
use crate::band::Band;
use crate::code;
use crate::fault::Fault;
use crate::keys::{ALSO_FROM, ALSO_TO, ALSO_WIDTH, Key, Table, Value, Words, key};
use crate::profile::{Along, left_out};
use crate::quantity::{
    AREA_SHEAR, GROUND_POSITION, POSITION, SHEAR_CONSTANT, SPRING_PER_LENGTH, SUBGRADE_MODULUS,
    WIDTH,
};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness, cover};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Beam, Foundation, FoundationSegment, GroundEnd, Profile};

// The keys of k and μ, in `[foundation]` and in `[[foundation.segment]]`. How many control values a ground may have the
// model knows.
const K: Key = key(
    "k",
    Value::Along(&SPRING_PER_LENGTH, Profile::MOST),
    "The spring constant per length of beam; two values run linearly, three are the control values of a curve.",
)
.also(&["spring", "spring_constant", "winkler", "stiffness"]);
const MODULUS: Value = Value::Along(&SUBGRADE_MODULUS, 2);
const SUBGRADE: Key =
    key("subgrade_modulus", MODULUS, "The subgrade modulus, with `width`: k is their product.")
        .also(&["ks", "k_s", "modulus", "bedding_modulus"]);
const C1: Key = key("C1", MODULUS, "Another name of `subgrade_modulus`.");
const BEARING: Key =
    key("width", Value::Along(&WIDTH, 2), "The width on which the beam bears.").also(ALSO_WIDTH);
const MU: Key = key(
    "mu",
    Value::Along(&SHEAR_CONSTANT, Profile::MOST),
    "The shear constant; left out: 0, separate springs (Winkler). Lists as for `k`.",
)
.also(&["µ", "μ", "shear", "g", "gp", "shear_constant", "pasternak"]);
const C2: Key = key(
    "C2",
    Value::Along(&AREA_SHEAR, 2),
    "The shear constant of an area, with `width`: mu is their product.",
);

static SEGMENT: Table = Table {
    name: "[[foundation.segment]]",
    keys: &[
        key("from", Value::Quantity(&POSITION), "Where the segment begins.")
            .needed()
            .also(ALSO_FROM),
        key("to", Value::Quantity(&POSITION), "Where it ends.").needed().also(ALSO_TO),
        K,
        SUBGRADE,
        C1,
        BEARING,
        MU,
        C2,
    ],
};

static WAYS: Words = Words {
    all: || vec!["free", "held"],
    also: &[],
    message: "`{}` is no way in which ground ends",
    hint: "\"free\", as beside a trench, or \"held\", as by a wall",
};
const END: &[Key] = &[
    key("ends", Value::Quantity(&GROUND_POSITION), "The position of the end.").needed(),
    key("as", Value::Word(&WAYS), "`free`, as beside a trench, or `held`, as by a wall.").needed(),
];
static LEFT: Table = Table { name: "[foundation] left", keys: END };
static RIGHT: Table = Table { name: "[foundation] right", keys: END };

pub(super) static TABLE: Table = Table {
    name: "[foundation]",
    keys: &[
        K,
        SUBGRADE,
        C1,
        BEARING,
        MU,
        C2,
        key("segment", Value::Tables(&SEGMENT), "Other ground between two positions."),
        key("soil", Value::Table(&soil::TABLE), "The soil, from which k and mu follow."),
        key("band", Value::Table(&band::TABLE), "The limits of k and mu as multiples."),
        key("left", Value::Table(&LEFT), "The end of the ground on the left; left out: endless."),
        key("right", Value::Table(&RIGHT), "The end of the ground on the right."),
    ],
};

const STIFFNESS: Keys = Keys { product: "k", factors: ["subgrade_modulus", "width"], instead: "" };

/// All that the file says of the ground.
#[derive(Debug)]
pub(crate) struct Ground {
    pub foundation: Foundation,
    /// The width on which the whole beam bears.
    pub width: Option<f64>,
    pub band: Option<Band>,
}

impl Ground {
    fn unreadable() -> Self {
        Ground { foundation: Foundation::winkler(f64::NAN), width: None, band: None }
    }
}

pub(super) fn read(reader: &mut Reader, root: &Section, beam: &Beam) -> Ground {
    let Some(table) = reader.table(root, "foundation") else {
        if root.value("foundation").is_none() {
            reader.missing(
                root,
                &["foundation"],
                "`[foundation]`",
                "[foundation] with `k`, and `mu` if it shears",
            );
        }
        return Ground::unreadable();
    };
    reader.places.part(Part::Foundation, &table.span);
    let mut ground = match reader.open(&table, "soil") {
        Some(soil) => on_soil(reader, &table, &soil, beam),
        None if table.value("soil").is_some() => {
            reader.places.field(Part::Foundation, "subgrade", &Field::unreadable(0..0));
            return Ground::unreadable();
        }
        None => constants(reader, &table, beam.length),
    };
    let shears = |ground: &Foundation| {
        let somewhere = ground.segments.iter().any(|segment| segment.shear_layer.largest() != 0.0);
        ground.shear_layer != 0.0 || somewhere
    };
    ground.band = band::read(reader, &table, shears(&ground.foundation));
    ground
}

/// A ground made of soil: nothing else may say what it is.
fn on_soil(reader: &mut Reader, table: &Section, soil: &Section, beam: &Beam) -> Ground {
    for key in ["k", "subgrade_modulus", "C1", "mu", "C2", "segment", "left", "right"] {
        if let Some((name, _)) = table.table.get_key_value(key) {
            let hint = "give the ground's constants, or the soil from which they follow";
            reader.exclusive((key, &name.span()), ("soil", &soil.span), hint);
        }
    }
    let width = reader.required(table, "width");
    let width = reader.positive("width", width);
    let soil = soil::read(reader, soil, width.value);
    for field in ["subgrade", "shear_layer"] {
        reader.places.field(Part::Foundation, field, &Field::unreadable(0..0));
    }
    let unknown = || Foundation::winkler(f64::NAN);
    let foundation = soil.map_or_else(unknown, |soil| Foundation::on_soil(soil, beam));
    Ground { foundation, width: Some(width.value), band: None }
}

/// A ground given by its constants.
fn constants(reader: &mut Reader, table: &Section, beam_length: f64) -> Ground {
    let ends = ["left", "right"].map(|key| ground_end(reader, table, key));
    let given = given(reader, table);
    let of_area = reader.along(table, "C2");
    let shear = shear(reader, table, of_area.as_ref(), given.factors[1].as_ref());
    let nothing = || Along { profile: Profile::constant(0.0), span: table.span.clone() };
    let shear = shear.unwrap_or_else(nothing);
    reader.places.field(Part::Foundation, "shear_layer", &shear.field());
    let width = given.factors[1].as_ref().filter(|width| width.profile.is_constant());
    let width = width.map(|width| width.profile.start()).filter(|width| width.is_finite());
    let stiffness = given.resolve(reader, &Given::default(), &STIFFNESS);
    let known = match &stiffness {
        Stiffness::Known(spring) => Some(spring.clone()),
        _ => None,
    };
    let parent = Parent { given, spring: known, shear, of_area, length: beam_length };

    let mut segments = Vec::new();
    for (i, segment) in reader.tables(table, "segment").iter().enumerate() {
        let part = Part::FoundationSegment(i);
        segments.push(read_segment(reader, segment, part, &parent));
    }

    let covered = cover(beam_length, segments.iter().map(|s| (s.from, s.to)));
    let rightmost = segments.iter().max_by(|a, b| a.to.total_cmp(&b.to));
    let foundation = match (&stiffness, rightmost) {
        // Nothing is left for it to hold for; it must only be possible values.
        (Stiffness::NotGiven | Stiffness::Half(..), Some(segment)) if covered => {
            reader.places.field(Part::Foundation, "subgrade", &Field::unreadable(0..0));
            let (spring, shear) = (segment.subgrade.end(), segment.shear_layer.end());
            Foundation { subgrade: spring, shear_layer: shear, segments, ends, soil: None }
        }
        _ => {
            let spring = reader.settle(stiffness, table, &STIFFNESS);
            reader.places.field(Part::Foundation, "subgrade", &spring.field());
            add_where_it_varies(reader, &spring, &parent.shear, beam_length, &mut segments);
            let [spring, shear] = [&spring, &parent.shear].map(|along| along.profile.start());
            Foundation { subgrade: spring, shear_layer: shear, segments, ends, soil: None }
        }
    };
    Ground { foundation, width, band: None }
}

/// `left = { ends = "-2 m", as = "free" }`
fn ground_end(reader: &mut Reader, table: &Section, key: &'static str) -> GroundEnd {
    let Some(end) = reader.table(table, key) else { return GroundEnd::Endless };
    let at = reader.required(&end, "ends");
    reader.places.field(Part::Foundation, key, &at);
    let at = at.value;
    match reader.word(&end, "as") {
        Some("free") => GroundEnd::Free { at },
        Some("held") => GroundEnd::Held { at },
        _ => GroundEnd::Endless,
    }
}

/// μ as it is given, or as C2 times a width; none if the table says nothing of it.
fn shear(
    reader: &mut Reader,
    table: &Section,
    of_area: Option<&Along>,
    width: Option<&Along>,
) -> Option<Along> {
    let given = reader.along(table, "mu");
    let Some(of_area) = of_area else { return given };
    if let Some(given) = &given {
        let hint = "C2 times the width is `mu`; give one of the two";
        reader.exclusive(("mu", &given.span), ("C2", &of_area.span), hint);
    }
    let Some(width) = width else {
        let hint = format!("add {}", reader.line(table.keys, "width"));
        let message = "`C2` is given without `width`";
        reader.report(Fault::new(code::INCOMPLETE, of_area.span.clone(), message, "", hint));
        return Some(Along::unreadable(of_area.span.clone()));
    };
    Some(of_area.times(width, &of_area.span))
}

/// What `[foundation]` says, along the whole beam.
struct Parent {
    given: Given,
    spring: Option<Along>,
    shear: Along,
    /// C2, where μ is given by it.
    of_area: Option<Along>,
    length: f64,
}

/// Ground that varies along the whole beam holds where no segment says otherwise.
fn add_where_it_varies(
    reader: &mut Reader,
    spring: &Along,
    shear: &Along,
    length: f64,
    segments: &mut Vec<FoundationSegment>,
) {
    let constant = spring.profile.is_constant() && shear.profile.is_constant();
    // A wrong beginning is reported once.
    if constant || spring.profile.start() <= 0.0 || shear.profile.start() < 0.0 {
        return;
    }
    for [from, to] in left_out(length, segments.iter().map(|s| (s.from, s.to))) {
        let [k, mu] = [spring, shear].map(|along| along.between([from / length, to / length]));
        let part = Part::FoundationSegment(segments.len());
        reader.places.field(part, "subgrade", &k.field());
        reader.places.field(part, "shear_layer", &mu.field());
        segments.push(FoundationSegment { from, to, subgrade: k.profile, shear_layer: mu.profile });
    }
}

/// What a segment leaves out it has from `[foundation]`.
fn read_segment(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    parent: &Parent,
) -> FoundationSegment {
    reader.places.part(part, &table.span);
    let from = reader.required(table, "from");
    let to = reader.required(table, "to");
    let way = [from.value, to.value].map(|x| (x / parent.length).clamp(0.0, 1.0));
    let own = given(reader, table);
    let own_shear = segment_shear(reader, table, &own, parent, way);
    let takes_over = |along: &Along| !along.profile.is_constant();
    let parts = [&parent.given.product, &parent.given.factors[0], &parent.given.factors[1]];
    let varies = parts.into_iter().flatten().any(takes_over) || takes_over(&parent.shear);
    let stiffness = own.resolve(reader, &parent.given.between(way), &STIFFNESS);
    let parent_spring = parent.spring.as_ref().map(|spring| spring.between(way));
    let spring = match (&stiffness, parent_spring) {
        // A value of the parent's is reported at the parent if it is wrong.
        (Stiffness::NotGiven, Some(spring)) if own_shear.is_some() => {
            reader.places.field(part, "subgrade", &Field::unreadable(0..0));
            spring
        }
        _ => {
            let spring = reader.settle(stiffness, table, &STIFFNESS);
            reader.places.field(part, "subgrade", &spring.field());
            spring
        }
    };
    let inherited = Field::unreadable(0..0);
    reader.places.field(part, "shear_layer", &own_shear.as_ref().map_or(inherited, Along::field));
    let shear = own_shear.unwrap_or_else(|| parent.shear.between(way)).profile;
    reader.places.field(part, "from", &from);
    reader.places.field(part, "to", &to);
    let (mut from, mut to) = (from.value, to.value);
    // Ground goes on beyond the beam as it is at its ends: what varies along the beam ends there.
    if varies && from < parent.length && to > 0.0 {
        (from, to) = (from.max(0.0), to.min(parent.length));
    }
    FoundationSegment { from, to, subgrade: spring.profile, shear_layer: shear }
}

/// μ of a segment that gives it, or a C2 or a width of its own.
fn segment_shear(
    reader: &mut Reader,
    table: &Section,
    own: &Given,
    parent: &Parent,
    way: [f64; 2],
) -> Option<Along> {
    let of_area = reader.along(table, "C2");
    let [own_width, width] = [&own.factors[1], &parent.given.factors[1]];
    let inherits = own_width.is_some() && table.value("mu").is_none();
    let inherited = parent.of_area.as_ref().filter(|_| inherits).map(|along| along.between(way));
    let width = own_width.clone().or_else(|| width.as_ref().map(|width| width.between(way)));
    shear(reader, table, of_area.or(inherited).as_ref(), width.as_ref())
}

fn given(reader: &mut Reader, table: &Section) -> Given {
    let product = reader.along(table, "k");
    let mut modulus = |key| {
        let modulus = reader.along(table, key)?;
        Some(reader.positive_along(key, modulus))
    };
    let (modulus, again) = (modulus("subgrade_modulus"), modulus("C1"));
    if let (Some(modulus), Some(again)) = (&modulus, &again) {
        let hint = "C1 is another name of the subgrade modulus; give it once";
        let keys = ["subgrade_modulus", "C1"];
        reader.exclusive((keys[0], &modulus.span), (keys[1], &again.span), hint);
    }
    let modulus = modulus.or(again);
    let width = reader.along(table, "width");
    let width = width.map(|width| reader.positive_along("width", width));
    Given { product, factors: [modulus, width] }
}
