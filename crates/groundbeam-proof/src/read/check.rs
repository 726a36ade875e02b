//! Checks a model as a whole: distinct positions of supports and hinges, ground under all ground loads, ranges of numbers.

use super::course::{is_constant, values};
use super::error::{Read, out_of_range, wrong};
use super::fields::is_within_reach;
use super::place::is_left;
use crate::{
    Action, Course, Extent, Ground, GroundEnd, Hinge, Load, Model, Scalar, Support, SupportKind,
};

/// Refuses numbers out of range, two supports or two hinges at one position, moments and rotational restraints at
/// hinges, and loads on the ground that are not allowed.
pub(crate) fn check<S: Scalar>(model: &Model<S>) -> Read<()> {
    ranges(model)?;
    let supports = sorted(model.supports.iter().map(|support| support.at));
    if meet(&supports) {
        return wrong(0, "two supports have the same position");
    }
    let hinges = sorted(model.hinges.iter().map(|hinge: &Hinge<S>| hinge.at));
    if meet(&hinges) {
        return wrong(0, "two hinges have the same position");
    }
    let moments = model.loads.iter().filter_map(turning_load);
    let mut turning = moments.chain(model.supports.iter().filter_map(clamp));
    if turning.any(|x| beside(&hinges, x).into_iter().flatten().any(|hinge| is_same(hinge, x))) {
        return wrong(0, "a moment, a clamp or a rotational spring is at a hinge");
    }
    ground_loads(model)
}

fn sorted<S: Scalar>(places: impl Iterator<Item = S>) -> Vec<S> {
    let mut places: Vec<S> = places.collect();
    places.sort_by(|a, b| a.middle().total_cmp(&b.middle()));
    places
}

/// Whether two positions are equal within their rounding errors.
fn is_same<S: Scalar>(a: S, b: S) -> bool {
    !is_left(a, b) && !is_left(b, a)
}

/// Whether any two neighbouring positions of a sorted list are equal within their rounding errors.
fn meet<S: Scalar>(places: &[S]) -> bool {
    places.windows(2).any(|pair| is_same(pair[0], pair[1]))
}

/// Returns the nearest position left of x, and the nearest position at or right of x, in a sorted list of positions.
fn beside<S: Scalar>(places: &[S], x: S) -> [Option<S>; 2] {
    let i = places.partition_point(|place| place.middle() < x.middle());
    [i.checked_sub(1).and_then(|i| places.get(i)).copied(), places.get(i).copied()]
}

/// The position of a nonzero point moment; `None` for every other load.
fn turning_load<S: Scalar>(load: &Load<S>) -> Option<S> {
    match (load.action, load.extent) {
        (Action::Moment, Extent::Point { at, size }) if size.middle() != 0.0 => Some(at),
        _ => None,
    }
}

/// The position of a support that restrains the slope; `None` for every other support.
fn clamp<S: Scalar>(support: &Support<S>) -> Option<S> {
    match support.kind {
        SupportKind::Pinned => None,
        SupportKind::Spring { rotational_spring, .. } if rotational_spring.middle() == 0.0 => None,
        _ => Some(support.at),
    }
}

/// Checks the ranges of all stiffnesses and loads. A product, such as EI, can be out of range although its factors are
/// not.
fn ranges<S: Scalar>(model: &Model<S>) -> Read<()> {
    let Model { beam, ground, loads, .. } = model;
    let mut positive = vec![beam.bending_stiffness, ground.spring];
    positive.extend(beam.shear_stiffness);
    let mut other = vec![ground.shear];
    for segment in &beam.segments {
        positive.extend(values(&segment.bending_stiffness));
        positive.extend(segment.shear_stiffness.iter().flat_map(values));
    }
    for segment in &ground.segments {
        positive.extend(values(&segment.spring));
        other.extend(values(&segment.shear));
    }
    for load in loads {
        match load.extent {
            Extent::Point { size, .. } => other.push(size),
            Extent::Distributed { start, end, .. } => other.extend([start, end]),
        }
    }
    if !positive.into_iter().all(|value| value.low() > 0.0 && is_within_reach(value)) {
        return out_of_range(0, "a stiffness is outside the range from 1e-60 to 1e60");
    }
    if !other.into_iter().all(|value| value.middle() == 0.0 || is_within_reach(value)) {
        return out_of_range(
            0,
            "a load or `mu` must be 0 or have a magnitude between 1e-60 and 1e60",
        );
    }
    Ok(())
}

/// Refuses loads beyond the ends of the ground, loads on ground with varying k or μ, and point forces on Winkler ground
/// under the beam.
fn ground_loads<S: Scalar>(model: &Model<S>) -> Read<()> {
    let ground = &model.ground;
    if !model.loads.iter().any(|load| load.on_ground) {
        return Ok(());
    }
    let varies = |course: &Course<S>| !is_constant(course);
    if ground.segments.iter().any(|segment| varies(&segment.spring) || varies(&segment.shear)) {
        return wrong(0, "loads on the ground need k and mu that are constant along each segment");
    }
    let layers = Layers::of(ground);
    for load in model.loads.iter().filter(|load| load.on_ground) {
        let [from, to] = match load.extent {
            Extent::Point { at, .. } => [at, at],
            Extent::Distributed { from, to, .. } => [from, to],
        };
        let [left, right] = ground.ends.map(|end| match end {
            GroundEnd::Endless => None,
            GroundEnd::Free(at) | GroundEnd::Held(at) => Some(at),
        });
        if left.is_some_and(|end| is_left(from, end)) || right.is_some_and(|end| is_left(end, to)) {
            return wrong(0, "a load on the ground lies beyond an end of the ground");
        }
        let is_point = matches!(load.extent, Extent::Point { .. });
        let is_under = !is_left(from, S::zero()) && !is_left(model.beam.length, from);
        if is_point && is_under && !layers.is_at(from) {
            return wrong(0, "a force at a point of the ground needs a shear layer");
        }
    }
    Ok(())
}

/// Shear layers of the ground. `segments` lists, from left to right, the ends of each ground segment and whether it has
/// a shear layer. `elsewhere` holds outside all segments.
struct Layers<S> {
    segments: Vec<([S; 2], bool)>,
    elsewhere: bool,
}

impl<S: Scalar> Layers<S> {
    fn of(ground: &Ground<S>) -> Self {
        let has_layer = |course: &Course<S>| values(course).iter().any(|mu| mu.middle() > 0.0);
        let segments = ground.segments.iter();
        let mut segments: Vec<_> =
            segments.map(|s| ([s.from, s.to], has_layer(&s.shear))).collect();
        segments.sort_by(|a, b| a.0[0].middle().total_cmp(&b.0[0].middle()));
        Layers { segments, elsewhere: ground.shear.middle() > 0.0 }
    }

    /// Whether a shear layer lies on at least one side of x.
    fn is_at(&self, x: S) -> bool {
        let right = self.segments.partition_point(|([from, _], _)| !is_left(x, *from));
        let left = self.segments.partition_point(|([from, _], _)| is_left(*from, x));
        let of = |i: usize, holds: &dyn Fn(S) -> bool| {
            let segment = i.checked_sub(1).and_then(|i| self.segments.get(i));
            let segment = segment.filter(|([_, to], _)| holds(*to));
            segment.map_or(self.elsewhere, |(_, has_layer)| *has_layer)
        };
        of(right, &|to| is_left(x, to)) || of(left, &|to| !is_left(to, x))
    }
}
