//! Reads `[beam]` and its segments: EI, shear stiffness, self-weight and depth of the section.

use super::case::{Cased, case};
use super::error::{Read, wrong};
use super::fields::{
    Along, BENDING_STIFFNESS, DEFLECTION, FORCE, Fields, LENGTH, MODULUS, Quantity, SECOND_MOMENT,
    Section, UNIT_WEIGHT, Values,
};
use super::material::{self, Material};
use super::place::{covers, left_out, overlapping, stretch};
use super::product::{Found, Given};
use super::section;
use super::shapes::Shape;
use super::shear::{self, Shear};
use super::unit::Exact;
use crate::{Action, Beam, BeamSegment, Extent, Load, Scalar};

const KEYS: &[&str] = &[
    "length",
    "EI",
    "E",
    "material",
    "I",
    "section",
    "unit_weight",
    "weight_case",
    "axial_force",
    "camber",
    "segment",
];
const SEGMENT_KEYS: &[&str] = &["from", "to", "EI", "E", "material", "I", "section"];
const NAMES: [&str; 3] = ["EI", "E", "I"];

/// The data that follow from the keys of `[beam]`.
pub(crate) struct ReadBeam<S> {
    pub beam: Beam<S>,
    /// Loads from self-weight and camber.
    pub loads: Vec<Cased<S>>,
    /// The depths of the section, from the left end to the right end.
    pub depths: Vec<Depth<S>>,
    /// The thermal expansion of the material, if it is constant along the beam.
    pub expansion: Option<S>,
}

/// A quantity of the cross section on a stretch of the beam; `None` if the quantity is not known on the stretch.
pub(crate) struct Stretch<S> {
    pub ends: [S; 2],
    pub of: Option<Along<S>>,
}

/// The depth of the cross section on a stretch of the beam, as an exact decimal and as a number of the proof; `None` if
/// it is unknown or not constant.
pub(crate) struct Depth<S> {
    pub ends: [S; 2],
    pub of: Option<(Exact, S)>,
}

/// Bending data of a table: EI, or its factors E and I. Also the cross section and the material, if the table has
/// them.
struct Bending<S> {
    given: Given<S>,
    shape: Option<Shape<S>>,
    material: Option<Material>,
}

pub(crate) fn read<S: Scalar>(fields: &mut Fields, root: Section) -> Read<ReadBeam<S>> {
    let Some(table) = root.table("beam")? else { return root.missing("beam") };
    table.only(&[KEYS, shear::KEYS], &[])?;
    let length: S = fields.required(table, "length", LENGTH)?.value;
    let axial_force = fields.quantity(table, "axial_force", FORCE)?;
    let axial_force = axial_force.map_or(S::zero(), |force: Quantity<S>| force.value);
    let Bending { given, shape, material } = bending(fields, table)?;
    let nothing = Shear::nothing();
    let modulus = [given.factors[0].as_ref(), None];
    let shear = Shear::read(fields, table, modulus, shape.as_ref(), &nothing)?;
    let shear_stiffness = shear.settle(table, &nothing)?;
    let whole = Whole { given, shear, shear_stiffness, length };

    let mut parts = Parts { segments: Vec::new(), areas: Vec::new(), depths: Vec::new() };
    let mut one_material = true;
    for segment in table.tables("segment")? {
        let (read, own) = whole.segment(fields, segment)?;
        let ends = [read.from, read.to];
        let way = whole.way(ends);
        let shape = own.or_else(|| shape.as_ref().map(|shape| shape.between(way)));
        parts.note(ends, shape.filter(|_| !gives_stiffness(segment)));
        one_material &= ["material", "E"].iter().all(|key| segment.table.get(key).is_none());
        parts.segments.push(read);
    }
    let spans: Vec<[S; 2]> = parts.segments.iter().map(|s| [s.from, s.to]).collect();
    if overlapping(&spans).is_some() {
        return wrong(table.at, "segments of the beam overlap");
    }
    let material = material.filter(|_| one_material);
    let base = shape.filter(|_| !gives_stiffness(table));
    for (ends, way) in left_out(length, &spans) {
        parts.note(ends, base.as_ref().map(|shape| shape.between(way)));
    }
    let mut loads = weight(fields, table, material, parts.areas)?;
    loads.extend(camber(fields, table, length)?);

    let found = whole.given.resolve(&Given::nothing(), NAMES)?;
    let rightmost = parts.segments.iter().reduce(|a, b| match a.to.middle() <= b.to.middle() {
        true => b,
        false => a,
    });
    let bending_stiffness = match (found, rightmost) {
        (Found::Nothing | Found::Half(_), Some(segment)) if covers(length, &spans) => {
            super::course::ends(&segment.bending_stiffness)[1]
        }
        (found, _) => {
            let known = found.known(table, "EI")?;
            whole.add_where_it_varies(&known, &spans, &mut parts.segments);
            known.ends()[0]
        }
    };
    let shear_stiffness = whole.shear_stiffness.as_ref().map(|along| along.ends()[0]);
    let expansion = material.map(|material| material.expansion()).transpose()?;
    let expansion = expansion.map(|expansion| expansion.value);
    let segments = parts.segments;
    let beam = Beam { length, bending_stiffness, shear_stiffness, segments, axial_force };
    Ok(ReadBeam { beam, loads, depths: merged(parts.depths), expansion })
}

/// The depths from left to right. Neighbouring stretches with equal depths are merged.
fn merged<S: Scalar>(mut stretches: Vec<Stretch<S>>) -> Vec<Depth<S>> {
    stretches.sort_by(|a, b| a.ends[0].middle().total_cmp(&b.ends[0].middle()));
    let mut depths: Vec<Depth<S>> = Vec::new();
    for Stretch { ends, of } in stretches {
        let of = of.and_then(|along| Some((along.exact.clone()?, along.ends()[0])));
        let exact = |of: &Option<(Exact, S)>| of.as_ref().map(|(exact, _)| exact.clone());
        match depths.last_mut() {
            Some(last) if exact(&last.of) == exact(&of) => last.ends[1] = ends[1],
            _ => depths.push(Depth { ends, of }),
        }
    }
    depths
}

/// The segments read so far.
struct Parts<S> {
    segments: Vec<BeamSegment<S>>,
    areas: Vec<Stretch<S>>,
    depths: Vec<Stretch<S>>,
}

impl<S: Scalar> Parts<S> {
    fn note(&mut self, ends: [S; 2], shape: Option<Shape<S>>) {
        let (area, depth) = shape.map_or((None, None), |shape| (Some(shape.area), shape.depth));
        self.areas.push(Stretch { ends, of: area });
        self.depths.push(Stretch { ends, of: depth });
    }
}

/// Length and stiffnesses of the whole beam, as the keys of `[beam]` give them.
struct Whole<S> {
    given: Given<S>,
    shear: Shear<S>,
    shear_stiffness: Option<Along<S>>,
    length: S,
}

impl<S: Scalar> Whole<S> {
    fn way(&self, ends: [S; 2]) -> [S; 2] {
        ends.map(|x| x.div(self.length))
    }

    /// The shear stiffness on a part of the beam's length if it varies along the beam; otherwise `None`.
    fn shear_between(&self, way: [S; 2]) -> Option<Along<S>> {
        let varies = self.shear_stiffness.as_ref().filter(|along| !along.is_constant());
        varies.map(|along| along.between(way))
    }

    fn segment(
        &self,
        fields: &mut Fields,
        table: Section,
    ) -> Read<(BeamSegment<S>, Option<Shape<S>>)> {
        table.only(&[SEGMENT_KEYS, shear::KEYS], &[])?;
        let [from, to] = stretch(fields, table, self.length)?;
        let way = self.way([from, to]);
        let parent = self.given.between(way);
        let Bending { given: own, shape, .. } = bending(fields, table)?;
        let modulus = [own.factors[0].as_ref(), parent.factors[0].as_ref()];
        let above = self.shear.between(way);
        let shear = Shear::read(fields, table, modulus, shape.as_ref(), &above)?;
        let shear = shear.settle(table, &above)?;
        // A segment with only a shear stiffness has the bending stiffness of the beam.
        let bends = if shear.is_some() && own.is_nothing() { parent.clone() } else { own };
        let bending = bends.resolve(&parent, NAMES)?.known(table, "EI")?;
        let shear = shear.or_else(|| self.shear_between(way));
        let segment = BeamSegment {
            from,
            to,
            bending_stiffness: bending.course,
            shear_stiffness: shear.map(|along| along.course),
        };
        Ok((segment, shape))
    }

    /// If EI or the shear stiffness of the whole beam varies, adds segments with the varying stiffness
    /// between the given segments.
    fn add_where_it_varies(
        &self,
        bending: &Along<S>,
        spans: &[[S; 2]],
        segments: &mut Vec<BeamSegment<S>>,
    ) {
        if bending.is_constant() && self.shear_between([S::zero(), S::one()]).is_none() {
            return;
        }
        for (ends, way) in left_out(self.length, spans) {
            segments.push(BeamSegment {
                from: ends[0],
                to: ends[1],
                bending_stiffness: bending.between(way).course,
                shear_stiffness: self.shear_between(way).map(|along| along.course),
            });
        }
    }
}

/// Whether a table gives EI or I directly, so that the section of the beam does not apply.
fn gives_stiffness(section: Section) -> bool {
    section.table.get("EI").is_some() || section.table.get("I").is_some()
}

/// Reads the bending data of a table: EI, or its factors E and I. The table can give a material in place of E, and a
/// cross section in place of I.
fn bending<S: Scalar>(fields: &mut Fields, section: Section) -> Read<Bending<S>> {
    section.exclusive("I", "section")?;
    section.exclusive("E", "material")?;
    let whole = fields.along(section, "EI", BENDING_STIFFNESS, Values::Curve(6))?;
    let mut modulus = fields.along(section, "E", MODULUS, Values::Linear)?;
    let named = material::named(section)?;
    if let Some((material, at)) = named {
        // The data of a material have units, so the quantities of the file must also have units.
        fields.note(at, true)?;
        let Quantity { value, .. } = material.modulus().map_err(|fault| fault.moved(at))?;
        modulus = Some(Along::constant(value, at));
    }
    let second_moment = fields.along(section, "I", SECOND_MOMENT, Values::Linear)?;
    let shape = section::read(fields, section)?;
    let second_moment = second_moment.or_else(|| Some(shape.as_ref()?.second_moment.clone()));
    let given = Given { whole, factors: [modulus, second_moment] };
    Ok(Bending { given, shape, material: named.map(|(material, _)| material) })
}

/// The beam's self-weight.
fn weight<S: Scalar>(
    fields: &mut Fields,
    table: Section,
    material: Option<Material>,
    mut areas: Vec<Stretch<S>>,
) -> Read<Vec<Cased<S>>> {
    let case = case(table, "weight_case")?;
    let Some(node) = table.table.get("unit_weight") else {
        return match table.table.place("weight_case") {
            Some(at) => wrong(at, "`weight_case` is given without `unit_weight`"),
            None => Ok(Vec::new()),
        };
    };
    let is_named =
        matches!(&node.value, super::toml::Value::Text(text) if text.trim() == "material");
    let weight: Quantity<S> = if is_named {
        let listed = material.map(|material| material.unit_weight()).transpose()?.flatten();
        match listed {
            Some(weight) => weight,
            None => return wrong(node.at, "no unit weight of this beam's material is listed"),
        }
    } else {
        fields.one(node, "unit_weight", UNIT_WEIGHT)?
    };
    areas.sort_by(|a, b| a.ends[0].middle().total_cmp(&b.ends[0].middle()));
    let mut loads = Vec::new();
    for Stretch { ends: [from, to], of } in areas {
        let Some(area) = of else {
            return wrong(node.at, "the area of the beam's section is not known everywhere");
        };
        if super::course::values(&area.course).len() > 2 {
            return wrong(node.at, "the area of the beam's section is not linear along the beam");
        }
        let [start, end] = area.ends().map(|area| area * weight.value);
        let extent = Extent::Distributed { from, to, start, end };
        let load = Load { action: Action::Force, extent, on_ground: false };
        loads.push(Cased { load, case: case.clone(), at: node.at });
    }
    Ok(loads)
}

/// Reads the camber c of the beam, a parabola that rises by c at mid-length, as the imposed curvature κ₀ = 8c/l².
fn camber<S: Scalar>(fields: &mut Fields, table: Section, length: S) -> Read<Option<Cased<S>>> {
    let camber: Option<Quantity<S>> = fields.quantity(table, "camber", DEFLECTION)?;
    Ok(camber.map(|Quantity { value, at, .. }| {
        let curvature = (S::of(8.0) * value).div(length * length);
        let (from, to) = (S::zero(), length);
        let extent = Extent::Distributed { from, to, start: curvature, end: curvature };
        let load = Load { action: Action::Curvature, extent, on_ground: false };
        Cased { load, case: None, at }
    }))
}
