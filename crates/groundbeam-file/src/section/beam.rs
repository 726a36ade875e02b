//! `[beam]` and `[[beam.segment]]`.

use super::curl::{self, Depth};
use super::material;
use super::shape::{self, Shape};
use super::shear::{self, Shear};
use super::weight::{self, Area};
use crate::keys::{ALSO_E, ALSO_FROM, ALSO_TO, Key, Table, Value, key};
use crate::materials;
use crate::profile::{Along, left_out};
use crate::quantity::{
    BENDING_STIFFNESS, CAMBER, ELASTIC_MODULUS, FORCE, LENGTH, POSITION, SECOND_MOMENT_OF_AREA,
    UNIT_WEIGHT,
};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness, cover};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{Beam, BeamSegment, Load, Profile};
use std::ops::Range;

// The keys of the bending stiffness, in `[beam]` and in `[[beam.segment]]`.
const EI: Key = key(
    "EI",
    Value::Along(&BENDING_STIFFNESS, Profile::MOST),
    "The bending stiffness; two values run linearly, more are the control values of a curve.",
)
.also(&["bending_stiffness", "stiffness", "flexural_rigidity"]);
const E: Key =
    key("E", Value::Along(&ELASTIC_MODULUS, 2), "The elastic modulus, with `I` or `section`.")
        .also(ALSO_E);
const MATERIAL: Key = key(
    "material",
    Value::Name("C30/37", materials::spellings),
    "The name of a material that gives E ([Materials](#materials)).",
);
const I: Key = key("I", Value::Along(&SECOND_MOMENT_OF_AREA, 2), "The second moment of area.")
    .also(&["second_moment_of_area", "moment_of_inertia", "inertia"]);
const SECTION: Key = key(
    "section",
    Value::Table(&shape::TABLE),
    "The cross section, which gives I ([Sections](#sections-and-own-weight)).",
);

static SEGMENT: Table = Table {
    name: "[[beam.segment]]",
    keys: &[
        key("from", Value::Quantity(&POSITION), "Where the segment begins.")
            .needed()
            .also(ALSO_FROM),
        key("to", Value::Quantity(&POSITION), "Where it ends.").needed().also(ALSO_TO),
        EI,
        E,
        MATERIAL,
        I,
        SECTION,
        shear::STIFFNESS,
        shear::GA,
        shear::MODULUS,
        shear::POISSON,
        shear::AREA,
    ],
};

pub(super) static TABLE: Table = Table {
    name: "[beam]",
    keys: &[
        key("length", Value::Quantity(&LENGTH), "The length of the beam.")
            .needed()
            .also(&["l", "span"]),
        EI,
        E,
        MATERIAL,
        I,
        SECTION,
        key(
            "unit_weight",
            Value::Quantity(&UNIT_WEIGHT),
            "The weight per volume, or `\"material\"`: the own weight is a load; left out: it is none.",
        ),
        key("weight_case", Value::Text("G"), "The load case of the own weight."),
        key(
            "axial_force",
            Value::Quantity(&FORCE),
            "The axial force, tension positive; left out: 0.",
        )
        .also(&["n", "p", "axial", "normal_force"]),
        key(
            "camber",
            Value::Quantity(&CAMBER),
            "The rise at mid-length with which the beam is made.",
        ),
        key("segment", Value::Tables(&SEGMENT), "A part of the beam with another stiffness."),
        shear::STIFFNESS,
        shear::GA,
        shear::MODULUS,
        shear::POISSON,
        shear::AREA,
    ],
};

const STIFFNESS: Keys = Keys { product: "EI", factors: ["E", "I"], instead: " or a `section`" };

/// A load that follows from what `[beam]` says of itself.
pub(super) struct OwnLoad {
    pub load: Load,
    pub case: Option<String>,
    /// From what it follows.
    pub span: Range<usize>,
}

/// What `[beam]` says.
pub(super) struct Read {
    pub beam: Beam,
    /// Its own weight and its camber, if the file gives them.
    pub loads: Vec<OwnLoad>,
    pub depths: Vec<Depth>,
    /// The expansion of its material, if that is one all along.
    pub expansion: Option<f64>,
}

pub(super) fn read(reader: &mut Reader, root: &Section) -> Read {
    let beam = Beam::uniform(f64::NAN, f64::NAN);
    let unknown = Read { beam, loads: Vec::new(), depths: Vec::new(), expansion: None };
    let Some(table) = reader.table(root, "beam") else {
        if root.value("beam").is_none() {
            reader.missing(root, &["beam"], "`[beam]`", "[beam] with `length` and `EI`");
        }
        return unknown;
    };
    reader.places.part(Part::Beam, &table.span);

    let length = reader.required(&table, "length");
    reader.places.field(Part::Beam, "length", &length);
    let axial_force = reader.quantity(&table, "axial_force");
    let axial_force = axial_force.unwrap_or_else(|| Field::new(0.0, table.span.clone()));
    reader.places.field(Part::Beam, "axial_force", &axial_force);

    let (given, shape) = given(reader, &table);
    let none = Shear::default();
    let modulus = given.factors[0].as_ref();
    let shear = Shear::read(reader, &table, [modulus, None], shape.as_ref(), &none);
    let shear_stiffness = shear.settle(reader, &table, &none);
    if let Some(along) = &shear_stiffness {
        reader.places.field(Part::Beam, "shear_stiffness", &along.field());
    }
    let whole = Whole { given: &given, shear: &shear, shear_stiffness: shear_stiffness.as_ref() };
    let mut areas = Vec::new();
    let mut depths = Vec::new();
    let mut one_material = true;
    let mut segments = Vec::new();
    for (i, segment) in reader.tables(&table, "segment").iter().enumerate() {
        let part = Part::BeamSegment(i);
        let (read, own) = read_segment(reader, segment, part, &whole, length.value);
        let way = [read.from / length.value, read.to / length.value];
        let shape = own.or_else(|| shape.as_ref().map(|shape| shape.between(way)));
        let shape = shape.filter(|_| !gives_stiffness(segment));
        let (area, depth) = shape.map_or((None, None), |shape| (Some(shape.area), shape.depth));
        areas.push(Area { from: read.from, to: read.to, area });
        depths.push(Depth { from: read.from, to: read.to, depth });
        one_material &= ["material", "E"].iter().all(|key| segment.value(key).is_none());
        segments.push(read);
    }
    let material = material::of(&table).filter(|_| one_material);
    let base = shape.filter(|_| !gives_stiffness(&table));
    let (area, depth) = base.map_or((None, None), |shape| (Some(shape.area), shape.depth));
    let mut loads = weight::read(reader, &table, length.value, material, area, areas);
    loads.extend(curl::camber(reader, &table, length.value));
    let depths = curl::all(length.value, depth, depths);

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
            add_where_it_varies(reader, &known, &whole, length.value, &mut segments);
            known.profile.start()
        }
    };
    let shear_stiffness = shear_stiffness.map(|along| along.profile.start());
    let axial_force = axial_force.value;
    let length = length.value;
    let beam = Beam { length, bending_stiffness, shear_stiffness, segments, axial_force };
    Read { beam, loads, depths, expansion: material.map(|material| material.expansion) }
}

/// Whether a table gives EI or I by themselves: then no section of a parent's is that of the beam there.
fn gives_stiffness(table: &Section) -> bool {
    table.value("EI").is_some() || table.value("I").is_some()
}

/// What `[beam]` says, for its segments.
struct Whole<'a> {
    given: &'a Given,
    shear: &'a Shear,
    shear_stiffness: Option<&'a Along>,
}

impl Whole<'_> {
    /// The beam's shear stiffness on a part of the way, if it varies: else it is that of the beam itself.
    fn shear_between(&self, way: [f64; 2]) -> Option<Along> {
        let varies = self.shear_stiffness.filter(|along| !along.profile.is_constant());
        varies.map(|along| along.between(way))
    }
}

/// A stiffness that varies along the whole beam holds where no segment says otherwise.
fn add_where_it_varies(
    reader: &mut Reader,
    bending: &Along,
    whole: &Whole,
    length: f64,
    segments: &mut Vec<BeamSegment>,
) {
    // A wrong beginning is reported once.
    let varies = !bending.profile.is_constant() || whole.shear_between([0.0, 1.0]).is_some();
    if !varies || bending.profile.start() <= 0.0 {
        return;
    }
    for [from, to] in left_out(length, segments.iter().map(|s| (s.from, s.to))) {
        let way = [from / length, to / length];
        let own = bending.between(way);
        let part = Part::BeamSegment(segments.len());
        reader.places.field(part, "bending_stiffness", &own.field());
        let shear_stiffness = placed(reader, part, whole.shear_between(way));
        segments.push(BeamSegment { from, to, bending_stiffness: own.profile, shear_stiffness });
    }
}

fn read_segment(
    reader: &mut Reader,
    table: &Section,
    part: Part,
    whole: &Whole,
    length: f64,
) -> (BeamSegment, Option<Shape>) {
    reader.places.part(part, &table.span);
    let from = reader.required(table, "from");
    let to = reader.required(table, "to");
    let way = [from.value / length, to.value / length];
    let parent = whole.given.between(way);
    let (own, shape) = given(reader, table);
    reader.places.field(part, "from", &from);
    reader.places.field(part, "to", &to);
    let modulus = [own.factors[0].as_ref(), parent.factors[0].as_ref()];
    let above = whole.shear.between(way);
    let shear = Shear::read(reader, table, modulus, shape.as_ref(), &above);
    let shear = shear.settle(reader, table, &above);
    // A segment that says what it resists shear with may bend like the rest.
    let bends = if shear.is_some() && own.is_empty() { parent.clone() } else { own };
    let stiffness = bends.resolve(reader, &parent, &STIFFNESS);
    let stiffness = reader.settle(stiffness, table, &STIFFNESS);
    reader.places.field(part, "bending_stiffness", &stiffness.field());
    let shear = shear.or_else(|| whole.shear_between(way));
    let shear_stiffness = placed(reader, part, shear);
    let (from, to, bending_stiffness) = (from.value, to.value, stiffness.profile);
    (BeamSegment { from, to, bending_stiffness, shear_stiffness }, shape)
}

/// A segment's shear stiffness, and its place remembered.
fn placed(reader: &mut Reader, part: Part, shear: Option<Along>) -> Option<Profile> {
    let along = shear?;
    reader.places.field(part, "shear_stiffness", &along.field());
    Some(along.profile)
}

/// What a table says of EI, and its section.
fn given(reader: &mut Reader, table: &Section) -> (Given, Option<Shape>) {
    let product = reader.along(table, "EI");
    let modulus = reader.along(table, "E");
    let modulus = modulus.map(|modulus| reader.positive_along("E", modulus));
    let modulus = material::modulus(reader, table, modulus);
    let inertia = reader.along(table, "I");
    let inertia = inertia.map(|inertia| reader.positive_along("I", inertia));
    let shape = shape::read(reader, table);
    let section = shape.as_ref().map(|shape| shape.inertia.clone());
    if let (Some(inertia), Some(section)) = (&inertia, &section) {
        let hint = "the section gives I; keep one of the two";
        reader.exclusive(("I", &inertia.span), ("section", &section.span), hint);
    }
    (Given { product, factors: [modulus, inertia.or(section)] }, shape)
}
