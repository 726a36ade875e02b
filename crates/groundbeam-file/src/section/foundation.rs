//! Reads `[foundation]` and `[[foundation.segment]]`.

use super::segments::{Body, Segment, Whole};
use super::{band, soil};
use crate::band::Band;
use crate::code;
use crate::fault::Fault;
use crate::keys::{
    ALSO_FROM, ALSO_TO, ALSO_WIDTH, Key, Table, Value, Words, along, key, quantity, table, tables,
    word,
};
use crate::profile::Along;
use crate::quantity::{
    AREA_SHEAR, GROUND_POSITION, POSITION, SHEAR_CONSTANT, SPRING_PER_LENGTH, SUBGRADE_MODULUS,
    WIDTH,
};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys};
use crate::table::Section;
use groundbeam::model::Part;
use groundbeam::{
    Beam, Foundation,
    model::{FoundationSegment, GroundEnd, Profile},
};

// Keys for k and μ in `[foundation]` and `[[foundation.segment]]`. The reader accepts up to `Profile::MOST` values, but
// the model at most three.
const K: Key = along(
    "k",
    &SPRING_PER_LENGTH,
    Profile::MOST,
    "The spring constant k of the ground per length of beam; at most three values.",
)
.also(&["spring", "spring_constant", "winkler", "stiffness"]);
const MODULUS: Value = Value::Along(&SUBGRADE_MODULUS, 2);
const SUBGRADE: Key = key(
    "subgrade_modulus",
    MODULUS,
    "The spring constant per area. It needs `width`; k is this constant times `width`.",
)
.also(&["ks", "k_s", "modulus", "bedding_modulus"]);
const C1: Key = key("C1", MODULUS, "Another name for `subgrade_modulus`.");
const BEARING: Key = along("width", &WIDTH, 2, "The bearing width of the beam.").also(ALSO_WIDTH);
const MU: Key = along(
    "mu",
    &SHEAR_CONSTANT,
    Profile::MOST,
    "The shear constant μ; at most three values; default: 0 (Winkler).",
)
.also(&["µ", "μ", "shear", "g", "gp", "shear_constant", "pasternak"]);
const C2: Key = along(
    "C2",
    &AREA_SHEAR,
    2,
    "The shear constant per width. It needs `width`; mu is this constant times `width`.",
);

static SEGMENT: Table = Table {
    name: "[[foundation.segment]]",
    keys: &[
        quantity("from", &POSITION, "The start of the segment.").needed().also(ALSO_FROM),
        quantity("to", &POSITION, "The end of the segment.").needed().also(ALSO_TO),
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
    message: "`{}` is not an end condition of the ground",
    hint: "write \"free\" for an end at a trench, or \"held\" for an end at a wall",
};
const END: &[Key] = &[
    quantity("ends", &GROUND_POSITION, "The position of the end.").needed(),
    word("as", &WAYS, "The end condition of the ground: `free` at a trench, or `held` at a wall.")
        .needed(),
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
        tables(
            "segment",
            &SEGMENT,
            "A part of the ground whose constants differ from those in `[foundation]`.",
        ),
        table("soil", &soil::TABLE, "Soil data, from which k and mu follow."),
        table("band", &band::TABLE, "Lower and upper factors on k and mu."),
        table("left", &LEFT, "The left end of the ground; default: unbounded."),
        table("right", &RIGHT, "The right end of the ground; default: unbounded."),
    ],
};

static BODY: Body = Body {
    segment: Part::FoundationSegment,
    fields: ["subgrade", "shear_layer"],
    keys: Keys { product: "k", factors: ["subgrade_modulus", "width"], instead: "" },
};

/// Data of the ground in the file.
#[derive(Debug)]
pub(crate) struct Ground {
    pub foundation: Foundation,
    /// Bearing width of the whole beam \[m\]; `None` if it varies or is not given.
    pub width: Option<f64>,
    /// Bearing widths of segments. A bearing width that varies along the whole beam is also in this list.
    pub local_widths: Vec<Along>,
    pub band: Option<Band>,
}

impl Ground {
    fn unreadable() -> Self {
        Ground {
            foundation: Foundation::winkler(f64::NAN),
            width: None,
            local_widths: Vec::new(),
            band: None,
        }
    }
}

pub(super) fn read(reader: &mut Reader, root: &Section, beam: &Beam) -> Ground {
    let Some(table) = reader.part(root, "foundation", Part::Foundation) else {
        if root.value("foundation").is_none() {
            reader.missing(
                root,
                &["foundation"],
                "`[foundation]`",
                "[foundation] with `k`, and with `mu` if the ground has a shear layer",
            );
        }
        return Ground::unreadable();
    };
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

/// Reads ground that is defined by soil data. Reports an error for each constant of the ground that is given as well.
fn on_soil(reader: &mut Reader, table: &Section, soil: &Section, beam: &Beam) -> Ground {
    for key in ["k", "subgrade_modulus", "C1", "mu", "C2", "segment", "left", "right"] {
        if let Some((name, _)) = table.table.get_key_value(key) {
            let hint = "give either the ground's constants or the soil data";
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
    Ground { foundation, width: Some(width.value), local_widths: Vec::new(), band: None }
}

/// Reads ground that is defined by its constants k and μ.
fn constants(reader: &mut Reader, table: &Section, beam_length: f64) -> Ground {
    let ends = ["left", "right"].map(|key| ground_end(reader, table, key));
    let own = given(reader, table);
    let of_area = reader.along(table, "C2");
    let width = own.factors[1].clone();
    let shear = shear(reader, table, of_area.as_ref(), width.as_ref());
    let nothing = || Along { profile: Profile::constant(0.0), span: table.span.clone() };
    let shear = shear.unwrap_or_else(nothing);
    reader.place(table, "shear_layer", &shear.field());
    let whole = Whole::new(reader, beam_length, own, Some(shear), &BODY);
    let varying = |width: &Along| !width.profile.is_constant();
    let mut local_widths: Vec<Along> =
        width.iter().filter(|width| varying(width)).cloned().collect();
    let mut segments = Vec::new();
    for segment in &reader.parts(table, "segment", Part::FoundationSegment) {
        let (segment, own_width) = read_segment(reader, segment, &whole, of_area.as_ref());
        segments.push(segment);
        local_widths.extend(own_width);
    }
    let (subgrade, shear_layer) = whole.complete(reader, table, &mut segments);
    let segment = |Segment { from, to, stiffness, second }| FoundationSegment {
        from,
        to,
        subgrade: stiffness,
        shear_layer: second.unwrap_or(Profile::constant(0.0)),
    };
    let segments = segments.into_iter().map(segment).collect();
    let shear_layer = shear_layer.unwrap_or(0.0);
    let width = width.filter(|width| width.profile.is_constant());
    let width = width.map(|width| width.profile.start()).filter(|width| width.is_finite());
    let foundation = Foundation { subgrade, shear_layer, segments, ends, soil: None };
    Ground { foundation, width, local_widths, band: None }
}

/// Reads one end of the ground, such as `left = { ends = "-2 m", as = "free" }`.
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

/// Returns the given μ, or μ as the product of the given `C2` (shear constant per width) and the bearing
/// width; `None` if neither μ nor `C2` is given.
fn shear(
    reader: &mut Reader,
    table: &Section,
    of_area: Option<&Along>,
    width: Option<&Along>,
) -> Option<Along> {
    let given = reader.along(table, "mu");
    let Some(of_area) = of_area else { return given };
    if let Some(given) = &given {
        let hint = "`mu` is the product of `C2` and `width`; give only `mu` or only `C2`";
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

/// Reads a segment of the ground, and the segment's own bearing width. `of_area` is the value of `C2` (shear
/// constant per width) in `[foundation]`.
fn read_segment(
    reader: &mut Reader,
    table: &Section,
    whole: &Whole,
    of_area: Option<&Along>,
) -> (Segment, Option<Along>) {
    let (ends, way) = whole.ends(reader, table);
    let own = given(reader, table);
    let [own_width, width] = [&own, &whole.given(way)].map(|given| given.factors[1].clone());
    // A segment with its own bearing width has its own μ, the product of this width and the shear constant `C2`.
    let inherits = own_width.is_some() && table.value("mu").is_none();
    let inherited = of_area.filter(|_| inherits).map(|along| along.between(way));
    let of_area = reader.along(table, "C2").or(inherited);
    let own_shear = shear(reader, table, of_area.as_ref(), own_width.clone().or(width).as_ref());
    let mut segment = whole.segment(reader, table, (ends, way), &own, own_shear);
    // If k or μ of `[foundation]` varies, the ground beside the beam has the values at the beam ends. Segments are cut
    // off there.
    if whole.varies() && segment.from < whole.length && segment.to > 0.0 {
        segment.from = segment.from.max(0.0);
        segment.to = segment.to.min(whole.length);
    }
    (segment, own_width)
}

fn given(reader: &mut Reader, table: &Section) -> Given {
    let product = reader.along(table, "k");
    let mut modulus = |key| {
        let modulus = reader.along(table, key)?;
        Some(reader.positive_along(key, modulus))
    };
    let (modulus, again) = (modulus("subgrade_modulus"), modulus("C1"));
    if let (Some(modulus), Some(again)) = (&modulus, &again) {
        let hint = "`C1` is another name for `subgrade_modulus`: give only one of the two keys";
        let keys = ["subgrade_modulus", "C1"];
        reader.exclusive((keys[0], &modulus.span), (keys[1], &again.span), hint);
    }
    let modulus = modulus.or(again);
    let width = reader.along(table, "width");
    let width = width.map(|width| reader.positive_along("width", width));
    Given { product, factors: [modulus, width] }
}
