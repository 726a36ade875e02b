//! Divides a model into the pieces of a claimed solution: checks ranges of values, and assigns loads and supports to nodes.

use crate::answer::{Answer, Reaction};
use crate::beside::Row;
use crate::coefficient::Coefficient;
use crate::compression::Compression;
use crate::frame::{Frame, Node, Span, spans};
use crate::held;
use crate::idle::too_close;
use crate::kinds::not_covered;
use crate::model::{Action, Course, Extent, Load, Model};
use crate::outside;
use crate::polynomial::{HIGHEST_COURSE, Line};
use crate::positions::Positions;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::stability::margin;
use crate::units::Units;
use crate::values::{in_range, positive};

/// Indices of the nodes at the ends of the segments and loads, at the supports and hinges, and at the corners of the initial gap.
struct Places {
    beam: Vec<[usize; 2]>,
    ground: Vec<[usize; 2]>,
    /// First and last node of each load; `None` for a load outside the beam.
    loads: Vec<Option<[usize; 2]>>,
    /// Node of each support; `None` for an inactive support.
    supports: Vec<Option<usize>>,
    hinges: Vec<usize>,
    gap: Vec<usize>,
}

/// Returns the model and the claimed deflection, divided into the pieces of the claimed solution, in the units of the
/// proof (m and N times powers of two).
///
/// Under compression, `stability` is σ; if it is `None`, a lower bound of σ is proven. The supports `placed` have nodes
/// although they have no reaction.
pub(crate) fn frame<S: Scalar>(
    model: &Model<S>,
    answer: &Answer,
    stability: Option<f64>,
    placed: &[usize],
) -> Result<Frame<S>, NotProven> {
    if let Some(kind) = not_covered(model) {
        return Err(kind);
    }
    let units = Units::of(model)?;
    let length = units.metres(model.beam.length);
    let mut positions = Positions::of(answer, length, units)?;
    let reactions = held::reactions(model, answer)?;
    let places = places(model, &reactions, placed, &mut positions, units)?;
    let pressed = pressed(answer, &positions)?;
    let exact = positions.exact()?;
    let mut nodes: Vec<Node<S>> = exact.iter().map(|x| Node::at(*x)).collect();
    for node in pressed {
        nodes[node].pressed = true;
    }
    let spans = spans(answer, &exact, units)?;
    let tension = units.scaled(model.beam.axial_force, 1, 0);
    let mut frame = Frame {
        spans,
        nodes,
        supports: Vec::new(),
        tension: (tension.high() > 0.0).then_some(tension),
        carrier: 0.0,
        compression: None,
        outside: [S::zero(); 2],
        pushed: [S::zero(); 2],
        rows: [Row::none(), Row::none()],
        length,
        units,
    };
    stiffness(model, &places, &mut frame)?;
    if model.loads.iter().any(lifts) {
        return Err(NotProven::new("a load on the ground acts upward"));
    }
    loads(model, &places, &mut frame);
    gap(model, &places, &mut frame)?;
    held::supports(model, &reactions, &places.supports, &mut frame)?;
    held::hinges(model, &places.hinges, &mut frame)?;
    if tension.high() < 0.0 {
        let force = positive(-tension, "the axial force")?;
        let what = "the critical load is not proven to exceed the compression";
        let margin = stability.or_else(|| margin(&frame, force));
        let margin = margin.ok_or_else(|| NotProven::new(what))?;
        frame.compression = Some(Compression { force, margin });
    }
    outside::beside(model, &mut frame)?;
    held::weights(&mut frame);
    Ok(frame)
}

fn places<S: Scalar>(
    model: &Model<S>,
    reactions: &[Option<Reaction>],
    placed: &[usize],
    positions: &mut Positions<S>,
    units: Units,
) -> Result<Places, NotProven> {
    let stretch = |positions: &mut Positions<S>, from: S, to: S| {
        let mut find = |x: S| positions.find_clipped(units.metres(x));
        Ok::<_, NotProven>([find(from)?, find(to)?])
    };
    let beam = model
        .beam
        .segments
        .iter()
        .map(|s| stretch(positions, s.from, s.to))
        .collect::<Result<_, _>>()?;
    let ground = model
        .ground
        .segments
        .iter()
        .map(|s| stretch(positions, s.from, s.to))
        .collect::<Result<_, _>>()?;
    let gap: Result<Vec<_>, _> =
        model.gap.iter().map(|corner| stretch(positions, corner.at, corner.at)).collect();
    let mut loads = Vec::with_capacity(model.loads.len());
    for load in &model.loads {
        loads.push(match load.extent {
            Extent::Point { at, .. } => match positions.is_beside(units.metres(at)) {
                true if load.on_ground => None,
                _ => Some([positions.find(units.metres(at))?; 2]),
            },
            Extent::Distributed { from, to, .. } if load.on_ground => {
                Some(stretch(positions, from, to)?)
            }
            Extent::Distributed { from, to, .. } => {
                Some([positions.find(units.metres(from))?, positions.find(units.metres(to))?])
            }
        });
    }
    let mut supports = Vec::new();
    for (i, (support, reaction)) in model.supports.iter().zip(reactions).enumerate() {
        let (idle, x) = (held::is_idle(support, reaction), units.metres(support.at));
        supports.push(match (idle, placed.contains(&i)) {
            (true, false) => None,
            (true, true) => {
                let place = units.restored(x.middle(), 0, 1);
                Some(positions.find(x).map_err(|_| too_close().at(place))?)
            }
            (false, _) => Some(positions.find(x)?),
        });
    }
    let hinges = model.hinges.iter().map(|hinge| positions.find(units.metres(hinge.at)));
    let hinges = hinges.collect::<Result<_, _>>()?;
    let gap = gap?.into_iter().map(|[node, _]| node).collect();
    Ok(Places { beam, ground, loads, supports, hinges, gap })
}

/// Returns the nodes at which the answer has a positive concentrated contact force.
fn pressed<S: Scalar>(answer: &Answer, positions: &Positions<S>) -> Result<Vec<usize>, NotProven> {
    let mut pressed = Vec::new();
    for force in &answer.forces {
        let node = positions.of_force(force.x).ok_or_else(|| {
            NotProven::new("a concentrated force is not at an end of a piece").at(force.x)
        })?;
        if force.force > 0.0 {
            pressed.push(node);
        }
    }
    Ok(pressed)
}

fn stiffness<S: Scalar>(
    model: &Model<S>,
    places: &Places,
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    let units = frame.units;
    if let Some(tension) = frame.tension {
        positive(tension, "the axial force")?;
    }
    let (beam, ground) = (&model.beam, &model.ground);
    let even = |x: S, length: i32| Coefficient::Even(units.scaled(x, 1, length));
    let mut shears = vec![beam.shear_stiffness.map(|x| even(x, 0)); frame.spans.len()];
    for span in &mut frame.spans {
        span.bending = even(beam.bending_stiffness, 2);
        span.spring = even(ground.spring, -2);
        span.shear = even(ground.shear, 0);
    }
    // `courses` contains the profiles of μ, S and k for each piece that lies in a segment.
    let mut courses = vec![[None; 3]; frame.spans.len()];
    for (piece, j) in pieces_of(places.beam.iter().copied(), frame.spans.len())? {
        let segment = &beam.segments[j];
        let part = Part::of(&frame.spans[piece], [segment.from, segment.to], units);
        frame.spans[piece].bending = part.course(&segment.bending_stiffness, 2)?;
        if let Some(course) = &segment.shear_stiffness {
            courses[piece][1] = Some(course);
            shears[piece] = Some(part.course(course, 0)?);
        }
    }
    for (piece, j) in pieces_of(places.ground.iter().copied(), frame.spans.len())? {
        let segment = &ground.segments[j];
        courses[piece][0] = Some(&segment.shear);
        courses[piece][2] = Some(&segment.spring);
        let part = Part::of(&frame.spans[piece], [segment.from, segment.to], units);
        frame.spans[piece].spring = part.course(&segment.spring, -2)?;
        frame.spans[piece].shear = part.course(&segment.shear, 0)?;
    }
    steps(model, &courses, frame);
    for (span, shear) in frame.spans.iter_mut().zip(shears) {
        in_range(&span.bending, "EI")?;
        in_range(&span.spring, "k")?;
        span.layered = span.shear != Coefficient::Even(S::zero());
        if span.layered {
            in_range(&span.shear, "the shear constant of the ground")?;
        }
        if let Some(shear) = &shear {
            in_range(shear, "the shear stiffness")?;
        }
        span.stiffness = shear;
        if span.stiffness.is_some() != span.rotation.is_some() {
            let what = "a piece must have a `rotation` if the beam has shear deformation, and must not have one otherwise";
            return Err(NotProven::new(what).at(units.restored(span.x[0].middle(), 0, 1)));
        }
    }
    Ok(())
}

/// Marks the nodes at which the stiffness μ of the shear layer, the shear stiffness S of the beam or the subgrade modulus
/// k jumps. They are continuous inside a segment.
fn steps<S: Scalar>(model: &Model<S>, courses: &[[Option<&Course<S>>; 3]], frame: &mut Frame<S>) {
    let (ground, stiffness) = (&model.ground, model.beam.shear_stiffness);
    let same = |a: Option<&Course<S>>, b: Option<&Course<S>>, base: Option<S>| match (a, b) {
        (Some(a), Some(b)) if std::ptr::eq(a, b) => true,
        _ => a.map_or(base, |a| a.end(1)) == b.map_or(base, |b| b.end(0)),
    };
    for (node, pair) in frame.nodes.iter_mut().skip(1).zip(courses.windows(2)) {
        let [left, right] = [pair[0], pair[1]];
        node.stepped =
            !(same(left[0], right[0], Some(ground.shear)) && same(left[1], right[1], stiffness));
        node.uneven = !same(left[2], right[2], Some(ground.spring));
    }
}

/// Returns the pieces that lie in segments, each with the index of its segment. Overlapping segments are an error.
fn pieces_of(
    segments: impl Iterator<Item = [usize; 2]>,
    pieces: usize,
) -> Result<Vec<(usize, usize)>, NotProven> {
    let mut taken = Vec::new();
    let mut found = Vec::new();
    for (j, [from, to]) in segments.enumerate() {
        taken.resize(pieces, false);
        for (piece, taken) in taken.iter_mut().enumerate().take(to).skip(from) {
            if std::mem::replace(taken, true) {
                return Err(NotProven::new("two segments overlap"));
            }
            found.push((piece, j));
        }
    }
    Ok(found)
}

/// A piece as a part of a segment, where s runs from 0 to 1. The piece lies between the two `ends` of s, and `line` is
/// s as a function of the local coordinate t.
struct Part<S> {
    line: Line<S>,
    ends: [S; 2],
    units: Units,
}

impl<S: Scalar> Part<S> {
    fn of(span: &Span<S>, segment: [S; 2], units: Units) -> Self {
        let [from, to] = segment.map(|x| units.metres(x));
        let length = to - from;
        let s = |x: S| (x - from).div(length);
        Part {
            line: Line::from_coefficients([s(span.middle), span.half.div(length)]),
            ends: span.x.map(s),
            units,
        }
    }

    /// Converts a profile along the segment to the coefficient on this piece, in the units of the proof. The
    /// values of the profile have the unit N m^`length`.
    fn course(&self, course: &Course<S>, length: i32) -> Result<Coefficient<S>, NotProven> {
        if matches!(course, Course::Varying(values) if values.len() > HIGHEST_COURSE + 1) {
            return Err(NotProven::new(
                "a coefficient such as EI or k is a polynomial of degree greater than 5",
            ));
        }
        let scaled = |x: S| self.units.scaled(x, 1, length);
        Ok(Coefficient::of(course, &self.line, self.ends, scaled))
    }
}

/// Whether a load on the ground may act upward. The proof of (8) in docs/proof.md requires downward loads on the
/// ground.
fn lifts<S: Scalar>(load: &Load<S>) -> bool {
    load.on_ground && sizes(load).iter().any(|size| !(size.low() >= 0.0))
}

/// Returns the sizes of a load at its two ends.
fn sizes<S: Scalar>(load: &Load<S>) -> [S; 2] {
    match load.extent {
        Extent::Point { size, .. } => [size; 2],
        Extent::Distributed { start, end, .. } => [start, end],
    }
}

fn loads<S: Scalar>(model: &Model<S>, places: &Places, frame: &mut Frame<S>) {
    let units = frame.units;
    for (load, place) in model.loads.iter().zip(&places.loads) {
        let Some([first, last]) = place else { continue };
        if sizes(load) == [S::zero(); 2] {
            continue;
        }
        let (force, length) = match load.action {
            Action::Force => (1, 0),
            Action::Moment => (1, 1),
            Action::Curvature => (0, 0),
        };
        match load.extent {
            Extent::Point { size, .. } => {
                let node = &mut frame.nodes[*first];
                let size = units.scaled(size, force, length);
                match load.action {
                    Action::Force if load.on_ground => {
                        node.ground_force = node.ground_force + size;
                    }
                    Action::Force => node.force = node.force + size,
                    Action::Moment | Action::Curvature => node.moment = node.moment + size,
                }
            }
            Extent::Distributed { from, to, start, end } => {
                let ends = [from, to].map(|x| units.metres(x));
                let sizes = [start, end].map(|size| units.scaled(size, force, length - 1));
                if load.on_ground {
                    frame.nodes[*first].uneven = true;
                    frame.nodes[*last].uneven = true;
                }
                for span in frame.spans.iter_mut().take(*last).skip(*first) {
                    let line = span.line(ends, sizes);
                    if load.on_ground {
                        span.ground_load = Some(span.ground_load.map_or(line, |sum| sum + &line));
                        continue;
                    }
                    let sum = match load.action {
                        Action::Force => &mut span.force,
                        Action::Moment => &mut span.moment,
                        Action::Curvature => &mut span.curvature,
                    };
                    *sum = *sum + &line;
                }
            }
        }
    }
}

fn gap<S: Scalar>(
    model: &Model<S>,
    places: &Places,
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    let units = frame.units;
    let corners: Vec<[S; 2]> =
        model.gap.iter().map(|c| [units.metres(c.at), units.metres(c.value)]).collect();
    let (Some(first), Some(last)) = (corners.first(), corners.last()) else { return Ok(()) };
    if !corners.iter().all(|[_, value]| value.size() <= 1e60) {
        return Err(NotProven::new("a clearance is out of range"));
    }
    let (before, after) = (places.gap[0], places.gap[places.gap.len() - 1]);
    for (i, span) in frame.spans.iter_mut().enumerate() {
        if i < before {
            span.gap = span.line(span.x, [first[1]; 2]);
        } else if i >= after {
            span.gap = span.line(span.x, [last[1]; 2]);
        }
    }
    for (pair, nodes) in corners.windows(2).zip(places.gap.windows(2)) {
        if !((pair[1][0] - pair[0][0]).low() > 0.0) {
            return Err(NotProven::new(
                "the positions at which the initial gap is given are not in increasing order",
            ));
        }
        for span in frame.spans.iter_mut().take(nodes[1]).skip(nodes[0]) {
            span.gap = span.line([pair[0][0], pair[1][0]], [pair[0][1], pair[1][1]]);
        }
    }
    let last = frame.spans.len();
    for node in places.gap.iter().filter(|node| (1..last).contains(*node)) {
        let slope = |i: usize| frame.spans[i].gap_slope();
        frame.nodes[*node].corner = slope(node - 1) != slope(*node);
    }
    Ok(())
}

mod tests;
