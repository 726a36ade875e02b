//! Reads `[beam]` and `[[beam.segment]]`.

use super::curl::{self, Depth};
use super::material;
use super::segments::{Body, Segment, Whole};
use super::shape::{self, Shape};
use super::shear::{self, Shear};
use super::weight::{self, Area};
use crate::keys::{
    ALSO_E, ALSO_FROM, ALSO_TO, Key, Table, Value, along, key, quantity, table, tables, text,
};
use crate::materials;
use crate::quantity::{
    BENDING_STIFFNESS, CAMBER, ELASTIC_MODULUS, FORCE, LENGTH, POSITION, SECOND_MOMENT_OF_AREA,
    UNIT_WEIGHT,
};
use crate::reader::Reader;
use crate::stiffness::{Given, Keys};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{
    Beam, Load,
    model::{BeamSegment, Profile},
};
use std::ops::Range;

// Keys of the bending stiffness, in `[beam]` and in `[[beam.segment]]`.
const EI: Key = along("EI", &BENDING_STIFFNESS, Profile::MOST, "The bending stiffness.").also(&[
    "bending_stiffness",
    "stiffness",
    "flexural_rigidity",
]);
const E: Key = along("E", &ELASTIC_MODULUS, 2, "The elastic modulus; it needs `I` or a `section`.")
    .also(ALSO_E);
const MATERIAL: Key = key(
    "material",
    Value::Name("C30/37", materials::spellings),
    "The name of a material, which gives E.",
);
const I: Key = along("I", &SECOND_MOMENT_OF_AREA, 2, "The second moment of area.").also(&[
    "second_moment_of_area",
    "moment_of_inertia",
    "inertia",
]);
const SECTION: Key = table("section", &shape::TABLE, "The cross-section, which gives I.");

static SEGMENT: Table = Table {
    name: "[[beam.segment]]",
    keys: &[
        quantity("from", &POSITION, "The start of the segment.").needed().also(ALSO_FROM),
        quantity("to", &POSITION, "The end of the segment.").needed().also(ALSO_TO),
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
        quantity("length", &LENGTH, "The length of the beam.").needed().also(&["l", "span"]),
        EI,
        E,
        MATERIAL,
        I,
        SECTION,
        quantity(
            "unit_weight",
            &UNIT_WEIGHT,
            "The unit weight of the beam, or `\"material\"` for the unit weight of its \
             material; default: no self-weight.",
        ),
        text("weight_case", "G", "The load case of the self-weight."),
        quantity("axial_force", &FORCE, "Axial force, tension positive; default: 0.").also(&[
            "n",
            "p",
            "axial",
            "normal_force",
        ]),
        quantity("camber", &CAMBER, "The camber: rise at mid-length without load; default: 0."),
        tables("segment", &SEGMENT, "A part of the beam with a different stiffness."),
        shear::STIFFNESS,
        shear::GA,
        shear::MODULUS,
        shear::POISSON,
        shear::AREA,
    ],
};

static BODY: Body = Body {
    segment: Part::BeamSegment,
    fields: ["bending_stiffness", "shear_stiffness"],
    keys: Keys { product: "EI", factors: ["E", "I"], instead: " or a `section`" },
};

/// A load that follows from the data in `[beam]`.
pub(super) struct OwnLoad {
    pub load: Load,
    pub case: Option<String>,
    /// Location in the file of the data from which the load follows.
    pub span: Range<usize>,
}

/// Data of `[beam]`.
pub(super) struct Read {
    pub beam: Beam,
    /// Loads from self-weight and camber, if the file gives them.
    pub loads: Vec<OwnLoad>,
    pub depths: Vec<Depth>,
    /// Coefficient of thermal expansion \[1/K\] of the beam, if the whole beam has one material.
    pub expansion: Option<f64>,
}

pub(super) fn read(reader: &mut Reader, root: &Section) -> Read {
    let beam = Beam::uniform(f64::NAN, f64::NAN);
    let unknown = Read { beam, loads: Vec::new(), depths: Vec::new(), expansion: None };
    let Some(table) = reader.part(root, "beam", Part::Beam) else {
        if root.value("beam").is_none() {
            reader.missing(root, &["beam"], "`[beam]`", "[beam] with `length` and `EI`");
        }
        return unknown;
    };
    let length = reader.required(&table, "length").value;
    let axial_force = reader.quantity(&table, "axial_force").map_or(0.0, |force| force.value);

    let (own, shape) = given(reader, &table);
    let none = Shear::default();
    let shear = Shear::read(reader, &table, [own.factors[0].as_ref(), None], shape.as_ref(), &none);
    let shear_stiffness = shear.settle(reader, &table, &none);
    if let Some(along) = &shear_stiffness {
        reader.place(&table, "shear_stiffness", &along.field());
    }
    // A segment without a shear stiffness has the constant shear stiffness of the beam.
    let varying = shear_stiffness.clone().filter(|along| !along.profile.is_constant());
    let whole = Whole::new(reader, length, own, varying, &BODY);
    let mut areas = Vec::new();
    let mut depths = Vec::new();
    let mut one_material = true;
    let mut segments = Vec::new();
    for segment in &reader.parts(&table, "segment", Part::BeamSegment) {
        let (ends, way) = whole.ends(reader, segment);
        let (own, own_shape) = given(reader, segment);
        let above = (whole.given(way), shear.between(way));
        let modulus = [&own, &above.0].map(|given| given.factors[0].as_ref());
        let own_shear = Shear::read(reader, segment, modulus, own_shape.as_ref(), &above.1);
        let own_shear = own_shear.settle(reader, segment, &above.1);
        segments.push(whole.segment(reader, segment, (ends, way), &own, own_shear));
        let shape = own_shape.or_else(|| shape.as_ref().map(|shape| shape.between(way)));
        let shape = shape.filter(|_| !gives_stiffness(segment));
        let (area, depth) = shape.map_or((None, None), |shape| (Some(shape.area), shape.depth));
        let [from, to] = ends;
        areas.push(Area { from, to, area });
        depths.push(Depth { from, to, depth });
        one_material &= ["material", "E"].iter().all(|key| segment.value(key).is_none());
    }
    let material = material::of(&table).filter(|_| one_material);
    let base = shape.filter(|_| !gives_stiffness(&table));
    let (area, depth) = base.map_or((None, None), |shape| (Some(shape.area), shape.depth));
    let mut loads = weight::read(reader, &table, length, material, area, areas);
    loads.extend(curl::camber(reader, &table, length));
    let depths = curl::all(length, depth, depths);

    let (bending_stiffness, _) = whole.complete(reader, &table, &mut segments);
    let segment = |Segment { from, to, stiffness, second }| BeamSegment {
        from,
        to,
        bending_stiffness: stiffness,
        shear_stiffness: second,
    };
    let segments = segments.into_iter().map(segment).collect();
    let shear_stiffness = shear_stiffness.map(|along| along.profile.start());
    let beam = Beam { length, bending_stiffness, shear_stiffness, segments, axial_force };
    Read { beam, loads, depths, expansion: material.map(|material| material.expansion) }
}

/// Whether a table gives EI or I directly. If so, no section defines the area and the depth of this part of
/// the beam.
fn gives_stiffness(table: &Section) -> bool {
    table.value("EI").is_some() || table.value("I").is_some()
}

/// Reads the bending stiffness EI or its factors, and the cross-section, from a table.
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
        let hint = "the section gives I: keep either `I` or `section`";
        reader.exclusive(("I", &inertia.span), ("section", &section.span), hint);
    }
    (Given { product, factors: [modulus, inertia.or(section)] }, shape)
}
