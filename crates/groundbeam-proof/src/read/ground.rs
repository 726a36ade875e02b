//! Reads `[foundation]`: k and μ, along the whole beam and by segments, and the ends of the ground.

use super::error::{Read, Reason, fault, wrong};
use super::fields::{
    AREA_SHEAR, Along, Fields, GROUND_SHEAR, LENGTH, MODULUS, POSITION, Quantity, SUBGRADE_MODULUS,
    Section, Values,
};
use super::place::{covers, is_left, left_out, ordered, overlapping};
use super::product::{Found, Given};
use super::soil::{self, Bearing};
use crate::{Beam, Course, Ground, GroundEnd, GroundSegment, Scalar};

const KEYS: &[&str] =
    &["k", "subgrade_modulus", "C1", "width", "mu", "C2", "segment", "left", "right"];
const SEGMENT_KEYS: &[&str] = &["from", "to", "k", "subgrade_modulus", "C1", "width", "mu", "C2"];
const NAMES: [&str; 3] = ["k", "subgrade_modulus", "width"];
const CURVE: Values = Values::Curve(3);

pub(crate) fn read<S: Scalar>(
    fields: &mut Fields,
    root: Section,
    beam: &Beam<S>,
) -> Read<Ground<S>> {
    let Some(table) = root.table("foundation")? else { return root.missing("foundation") };
    if let Some(soil) = table.table("soil")? {
        table.only(&[&["width", "soil", "band"]], &[])?;
        let width = fields.required(table, "width", LENGTH)?.value;
        let Beam { length, bending_stiffness, .. } = *beam;
        let bearing = Bearing { width, length, bending_stiffness };
        let [spring, shear] = soil::read(fields, soil, &bearing)?;
        let ends = [GroundEnd::Endless; 2];
        return Ok(Ground { spring, shear, segments: Vec::new(), ends });
    }
    table.only(&[KEYS, &["band"]], &[])?;
    let length = beam.length;
    let left = end(fields, table, "left", |at| S::zero() - at)?;
    let right = end(fields, table, "right", |at| at - length)?;
    let given = given(fields, table)?;
    let of_area = fields.along(table, "C2", AREA_SHEAR, Values::Linear)?;
    let shear = shear(fields, table, of_area.as_ref(), given.factors[1].as_ref())?;
    let shear = shear.unwrap_or(Along::constant(S::zero(), table.at));
    let found = given.resolve(&Given::nothing(), NAMES)?;
    let spring = match &found {
        Found::Known(spring) => Some(spring.clone()),
        _ => None,
    };
    let whole = Whole { given, spring, shear, of_area, length };
    let mut segments = Vec::new();
    for segment in table.tables("segment")? {
        segments.push(whole.segment(fields, segment)?);
    }
    let spans: Vec<[S; 2]> = segments.iter().map(|s| [s.from, s.to]).collect();
    if overlapping(&spans).is_some() {
        return wrong(table.at, "segments of the ground overlap");
    }
    let rightmost = segments.iter().reduce(|a, b| match a.to.middle() <= b.to.middle() {
        true => b,
        false => a,
    });
    let (spring, shear) = match (found, rightmost) {
        (Found::Nothing | Found::Half(_), Some(segment)) if covers(length, &spans) => {
            let end = |course: &Course<S>| super::course::ends(course)[1];
            (end(&segment.spring), end(&segment.shear))
        }
        (found, _) => {
            let spring = found.known(table, "k")?;
            whole.add_where_it_varies(&spring, &spans, &mut segments);
            (spring.ends()[0], whole.shear.ends()[0])
        }
    };
    for segment in &segments {
        never_thins_out(&segment.shear, table.at)?;
    }
    Ok(Ground { spring, shear, segments, ends: [left, right] })
}

/// Refuses a varying shear layer whose μ decreases to zero.
fn never_thins_out<S: Scalar>(shear: &Course<S>, at: usize) -> Read<()> {
    match shear {
        Course::Varying(values) if !values.iter().all(|value| value.low() > 0.0) => {
            wrong(at, "`mu` varies and falls to zero")
        }
        _ => Ok(()),
    }
}

/// Reads an end of the ground, such as `left = { ends = "-2 m", as = "free" }`; `beyond` is the distance of
/// the ground's end from the beam's end.
fn end<S: Scalar>(
    fields: &mut Fields,
    table: Section,
    key: &str,
    beyond: impl Fn(S) -> S,
) -> Read<GroundEnd<S>> {
    let Some(end) = table.table(key)? else { return Ok(GroundEnd::Endless) };
    end.only(&[&["ends", "as"]], &[])?;
    let Quantity { value, at, .. } = fields.required(end, "ends", POSITION)?;
    let beyond = beyond(value);
    match end.words("as")? {
        Some(("free", _)) if beyond.high() >= 0.0 => Ok(GroundEnd::Free(value)),
        Some(("held", _)) if beyond.low() > 0.0 => Ok(GroundEnd::Held(value)),
        Some(("free" | "held", _)) => wrong(at, "the ground must not end under the beam"),
        Some((_, at)) => wrong(at, "`as` must be \"free\" or \"held\""),
        None => end.missing("as"),
    }
}

/// k as a table gives it.
fn given<S: Scalar>(fields: &mut Fields, table: Section) -> Read<Given<S>> {
    table.exclusive("subgrade_modulus", "C1")?;
    let whole = fields.along(table, "k", MODULUS, CURVE)?;
    let mut modulus = None;
    for key in ["subgrade_modulus", "C1"] {
        let read = fields.along(table, key, SUBGRADE_MODULUS, Values::Linear)?;
        modulus = modulus.or(read);
    }
    let width = fields.along(table, "width", LENGTH, Values::Linear)?;
    Ok(Given { whole, factors: [modulus, width] })
}

/// Reads the stiffness μ of the shear layer, or computes it as the product of `C2`, the stiffness per unit width, and
/// the width of the beam.
fn shear<S: Scalar>(
    fields: &mut Fields,
    table: Section,
    of_area: Option<&Along<S>>,
    width: Option<&Along<S>>,
) -> Read<Option<Along<S>>> {
    let given = fields.along(table, "mu", GROUND_SHEAR, CURVE)?;
    match (given, of_area, width) {
        (given, None, _) => Ok(given),
        (Some(given), Some(_), _) => fault(given.at, Reason::Together("mu", "C2")),
        (None, Some(of_area), Some(width)) => Ok(Some(of_area.times(width))),
        (None, Some(_), None) => table.missing("width"),
    }
}

/// The values of `[foundation]` for the whole beam.
struct Whole<S> {
    given: Given<S>,
    spring: Option<Along<S>>,
    shear: Along<S>,
    /// C2, the stiffness of the shear layer per unit width of the beam, if the file gives C2 instead of μ.
    of_area: Option<Along<S>>,
    length: S,
}

impl<S: Scalar> Whole<S> {
    /// Whether μ, k or a factor of k in `[foundation]` is not constant along the beam.
    fn varies(&self) -> bool {
        let Given { whole, factors: [modulus, width] } = &self.given;
        let given = [whole, modulus, width].into_iter().flatten();
        given.chain([&self.shear]).any(|along| !along.is_constant())
    }

    /// A position as a fraction of the beam's length; 0 to the left of the beam, and 1 to the right of it.
    fn way(&self, x: S) -> S {
        if x.high() <= 0.0 {
            return S::zero();
        }
        if x.low() >= self.length.high() { S::one() } else { x.div(self.length) }
    }

    /// Reads a segment. A value that the segment does not give is that of the whole beam.
    fn segment(&self, fields: &mut Fields, table: Section) -> Read<GroundSegment<S>> {
        table.only(&[SEGMENT_KEYS], &[])?;
        let from: Quantity<S> = fields.required(table, "from", POSITION)?;
        let to: Quantity<S> = fields.required(table, "to", POSITION)?;
        let [mut from, mut to] = ordered([from.value, to.value], to.at)?;
        let way = [from, to].map(|x| self.way(x));
        let own = given(fields, table)?;
        let own_shear = self.segment_shear(fields, table, &own, way)?;
        let parent = self.given.between(way);
        let spring = match (own.resolve(&parent, NAMES)?, &self.spring) {
            (Found::Nothing, Some(spring)) if own_shear.is_some() => spring.between(way),
            (found, _) => found.known(table, "k")?,
        };
        let own_varies = own_shear.as_ref().is_some_and(|shear| !shear.is_constant())
            || [&own.whole, &own.factors[0], &own.factors[1]]
                .into_iter()
                .flatten()
                .any(|along| !along.is_constant());
        let shear = own_shear.unwrap_or_else(|| self.shear.between(way));
        let length = self.length;
        let is_beside = !(is_left(S::zero(), to) && is_left(from, length));
        let [mut spring, mut shear] = [spring.course, shear.course];
        if is_beside {
            // Outside the beam, a quantity that varies along the beam keeps its value at the beam's end.
            (spring, shear) = (even(spring, table.at)?, even(shear, table.at)?);
        } else if self.varies() {
            // If `[foundation]` varies along the beam, a segment that extends beyond the beam is cut at the end of the
            // beam. Its own k and μ must then be constant.
            let before = is_left(from, S::zero());
            let behind = is_left(length, to);
            if (before || behind) && own_varies {
                return wrong(
                    table.at,
                    "a segment with varying ground must not extend beyond the beam",
                );
            }
            from = if before { S::zero() } else { from };
            to = if behind { length } else { to };
        }
        Ok(GroundSegment { from, to, spring, shear })
    }

    /// Reads μ of a segment that gives μ, C2 or a width; `None` for every other segment.
    fn segment_shear(
        &self,
        fields: &mut Fields,
        table: Section,
        own: &Given<S>,
        way: [S; 2],
    ) -> Read<Option<Along<S>>> {
        let of_area = fields.along(table, "C2", AREA_SHEAR, Values::Linear)?;
        let inherits = own.factors[1].is_some() && table.table.get("mu").is_none();
        let inherited = self.of_area.as_ref().filter(|_| inherits).map(|along| along.between(way));
        let width = self.given.factors[1].as_ref().map(|width| width.between(way));
        let width = own.factors[1].clone().or(width);
        shear(fields, table, of_area.or(inherited).as_ref(), width.as_ref())
    }

    /// If `[foundation]` gives a varying k or μ for the whole beam, adds ground segments with this k and μ on all parts
    /// of the beam that no given segment covers.
    fn add_where_it_varies(
        &self,
        spring: &Along<S>,
        spans: &[[S; 2]],
        segments: &mut Vec<GroundSegment<S>>,
    ) {
        if spring.is_constant() && self.shear.is_constant() {
            return;
        }
        for ([from, to], way) in left_out(self.length, spans) {
            let [spring, shear] = [spring, &self.shear].map(|along| along.between(way).course);
            segments.push(GroundSegment { from, to, spring, shear });
        }
    }
}

/// Returns a constant if all Bernstein coefficients of a polynomial are equal, otherwise an error.
fn even<S: Scalar>(course: Course<S>, at: usize) -> Read<Course<S>> {
    let Course::Varying(values) = course else { return Ok(course) };
    match values[..] {
        [first, ..]
            if values.iter().all(|v| v.low() <= first.high() && first.low() <= v.high()) =>
        {
            Ok(Course::Constant(first))
        }
        _ => wrong(at, "ground outside the beam must not vary along a segment"),
    }
}
