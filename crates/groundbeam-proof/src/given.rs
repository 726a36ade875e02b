//! From model and answer to the problem on the pieces: checks of range, and where everything stands.

use crate::answer::Answer;
use crate::frame::{Frame, Node, spans};
use crate::kinds::not_covered;
use crate::model::{Action, Extent, Model, Support, SupportKind};
use crate::outside;
use crate::positions::Positions;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::units::Units;
use crate::values::{constant, not_negative, positive};

/// More pieces than this are refused.
const MOST_PIECES: usize = 100_000;

/// Where the parts of the model stand, as indices of nodes.
struct Places {
    beam: Vec<[usize; 2]>,
    ground: Vec<[usize; 2]>,
    loads: Vec<[usize; 2]>,
    supports: Vec<usize>,
    hinges: Vec<usize>,
    gap: Vec<usize>,
}

/// The problem on the pieces of the answer, in the units of the proof.
pub(crate) fn frame<S: Scalar>(model: &Model<S>, answer: &Answer) -> Result<Frame<S>, NotProven> {
    if let Some(kind) = not_covered(model) {
        return Err(kind);
    }
    if answer.pieces.len() > MOST_PIECES {
        return Err(NotProven::new("the answer has more than 100,000 pieces"));
    }
    let units = Units::of(model)?;
    let length = units.metres(model.beam.length);
    let mut positions = Positions::of(answer, length, units)?;
    let places = places(model, &mut positions, units)?;
    let pressed = pressed(answer, &positions)?;
    let exact = positions.exact()?;
    let mut nodes: Vec<Node<S>> = exact.iter().map(|x| Node::at(*x)).collect();
    for node in pressed {
        nodes[node].pressed = true;
    }
    let spans = spans(answer, &exact, units)?;
    let tension = units.scaled(model.beam.axial_force, 1, 0);
    let outside = [S::zero(); 2];
    let mut frame = Frame {
        spans,
        nodes,
        tension: (tension.high() > 0.0).then_some(tension),
        outside,
        length,
        units,
    };
    stiffness(model, &places, &mut frame)?;
    loads(model, &places, &mut frame);
    gap(model, &places, &mut frame)?;
    supports(model, answer, &places, &mut frame)?;
    hinges(model, &places, &mut frame)?;
    frame.outside = outside::stiffness(model, &frame)?;
    weights(&mut frame);
    Ok(frame)
}

fn places<S: Scalar>(
    model: &Model<S>,
    positions: &mut Positions<S>,
    units: Units,
) -> Result<Places, NotProven> {
    let mut stretch = |from: S, to: S| -> Result<[usize; 2], NotProven> {
        Ok([positions.find_clipped(units.metres(from))?, positions.find_clipped(units.metres(to))?])
    };
    let beam =
        model.beam.segments.iter().map(|s| stretch(s.from, s.to)).collect::<Result<_, _>>()?;
    let ground =
        model.ground.segments.iter().map(|s| stretch(s.from, s.to)).collect::<Result<_, _>>()?;
    let gap: Result<Vec<_>, _> =
        model.gap.iter().map(|corner| stretch(corner.at, corner.at)).collect();
    let mut loads = Vec::new();
    for load in &model.loads {
        loads.push(match load.extent {
            Extent::Point { at, .. } => [positions.find(units.metres(at))?; 2],
            Extent::Distributed { from, to, .. } => {
                [positions.find(units.metres(from))?, positions.find(units.metres(to))?]
            }
        });
    }
    let supports = model.supports.iter().map(|s| positions.find(units.metres(s.at)));
    let supports = supports.collect::<Result<_, _>>()?;
    let hinges = model.hinges.iter().map(|hinge| positions.find(units.metres(hinge.at)));
    let hinges = hinges.collect::<Result<_, _>>()?;
    let gap = gap?.into_iter().map(|[node, _]| node).collect();
    Ok(Places { beam, ground, loads, supports, hinges, gap })
}

/// Nodes at which the answer has a positive concentrated force.
fn pressed<S: Scalar>(answer: &Answer, positions: &Positions<S>) -> Result<Vec<usize>, NotProven> {
    let mut pressed = Vec::new();
    for force in &answer.forces {
        let node = positions.of_force(force.x).ok_or_else(|| {
            NotProven::new("no piece of the answer ends at a concentrated force").at(force.x)
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
    let bending = |x: S| positive(units.scaled(x, 1, 2), "EI");
    let ground = |[k, mu]: [S; 2]| -> Result<[S; 2], NotProven> {
        Ok([
            positive(units.scaled(k, 1, -2), "k")?,
            not_negative(units.scaled(mu, 1, 0), "the shear constant of the ground")?,
        ])
    };
    let (own, below) = (
        bending(model.beam.bending_stiffness)?,
        ground([model.ground.spring, model.ground.shear])?,
    );
    if let Some(tension) = frame.tension {
        positive(tension, "the axial force")?;
    }
    let mut stiffnesses = vec![None; frame.spans.len()];
    for (segment, [from, to]) in model.beam.segments.iter().zip(&places.beam) {
        let value = bending(constant(&segment.bending_stiffness))?;
        set(&mut stiffnesses, [*from, *to], value)?;
    }
    let mut grounds = vec![None; frame.spans.len()];
    for (segment, [from, to]) in model.ground.segments.iter().zip(&places.ground) {
        let value = ground([constant(&segment.spring), constant(&segment.shear)])?;
        set(&mut grounds, [*from, *to], value)?;
    }
    for (i, span) in frame.spans.iter_mut().enumerate() {
        span.bending = stiffnesses[i].unwrap_or(own);
        [span.spring, span.shear] = grounds[i].unwrap_or(below);
        span.layered = span.shear != S::zero();
    }
    Ok(())
}

/// Gives the pieces of a segment their value. Segments do not overlap.
fn set<T: Copy>(
    values: &mut [Option<T>],
    [from, to]: [usize; 2],
    value: T,
) -> Result<(), NotProven> {
    for place in values.iter_mut().take(to).skip(from) {
        if place.replace(value).is_some() {
            return Err(NotProven::new("two segments overlap"));
        }
    }
    Ok(())
}

fn loads<S: Scalar>(model: &Model<S>, places: &Places, frame: &mut Frame<S>) {
    let units = frame.units;
    for (load, [first, last]) in model.loads.iter().zip(&places.loads) {
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
                    Action::Force => node.force = node.force + size,
                    Action::Moment | Action::Curvature => node.moment = node.moment + size,
                }
            }
            Extent::Distributed { from, to, start, end } => {
                let ends = [from, to].map(|x| units.metres(x));
                let sizes = [start, end].map(|size| units.scaled(size, force, length - 1));
                for span in frame.spans.iter_mut().take(*last).skip(*first) {
                    let line = span.line(ends, sizes);
                    let sum = match load.action {
                        Action::Force => &mut span.force,
                        Action::Moment => &mut span.moment,
                        Action::Curvature => &mut span.curvature,
                    };
                    *sum = &*sum + &line;
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
            return Err(NotProven::new("the corners of the clearance do not follow one another"));
        }
        for span in frame.spans.iter_mut().take(nodes[1]).skip(nodes[0]) {
            span.gap = span.line([pair[0][0], pair[1][0]], [pair[0][1], pair[1][1]]);
        }
    }
    for node in &places.gap {
        frame.nodes[*node].corner = true;
    }
    Ok(())
}

fn supports<S: Scalar>(
    model: &Model<S>,
    answer: &Answer,
    places: &Places,
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    for (support, node) in model.supports.iter().zip(&places.supports) {
        hold(support, *node, frame)?;
    }
    let mut listed = vec![false; model.supports.len()];
    for reaction in &answer.reactions {
        let place = listed.get_mut(reaction.support);
        let place =
            place.ok_or_else(|| NotProven::new("a reaction of a support that is not there"))?;
        if std::mem::replace(place, true) {
            return Err(NotProven::new("two reactions of one support"));
        }
        if matches!(model.supports[reaction.support].kind, SupportKind::Spring { .. }) {
            continue;
        }
        let force = frame.units.scaled(S::of(reaction.force), 1, 0);
        let moment = frame.units.scaled(S::of(reaction.moment), 1, 1);
        if !(force.size() <= 1e60 && moment.size() <= 1e60) {
            return Err(NotProven::new("a reaction is not finite, or too large"));
        }
        let node = &mut frame.nodes[places.supports[reaction.support]];
        node.reaction = [node.reaction[0] + force, node.reaction[1] - moment];
    }
    Ok(())
}

fn hold<S: Scalar>(
    support: &Support<S>,
    node: usize,
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    let units = frame.units;
    let place = frame.place(node);
    let settlement = units.metres(support.settlement);
    if !(settlement.size() <= 1e60) {
        return Err(NotProven::new("the settlement of a support is out of range").at(place));
    }
    let node = &mut frame.nodes[node];
    match support.kind {
        SupportKind::Pinned | SupportKind::Fixed => {
            if node.rigid.is_some_and(|other| other != settlement) {
                return Err(NotProven::new("two rigid supports at one place").at(place));
            }
            node.rigid = Some(settlement);
            node.clamped |= matches!(support.kind, SupportKind::Fixed);
        }
        SupportKind::Spring { spring, rotational_spring } => {
            let spring = not_negative(units.scaled(spring, 1, -1), "a spring")?;
            let turning =
                not_negative(units.scaled(rotational_spring, 1, 1), "a rotational spring")?;
            if spring != S::zero() {
                let [sum, settled] = node.spring.unwrap_or([S::zero(); 2]);
                node.spring = Some([sum + spring, settled + spring * settlement]);
            }
            if turning != S::zero() {
                node.turning = Some(node.turning.map_or(turning, |sum| sum + turning));
            }
        }
    }
    Ok(())
}

fn hinges<S: Scalar>(
    model: &Model<S>,
    places: &Places,
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    let last = frame.spans.len();
    for (hinge, i) in model.hinges.iter().zip(&places.hinges) {
        let place = frame.place(*i);
        let spring = units_of_hinge(frame.units, hinge.rotational_spring)?;
        let node = &mut frame.nodes[*i];
        let refused = |what: &str| Err(NotProven::new(what).at(place));
        if *i == 0 || *i == last {
            return refused("a hinge at an end of the beam");
        }
        if node.hinge.replace(spring).is_some() {
            return refused("two hinges at one place");
        }
        if node.clamped || node.turning.is_some() {
            return refused("not covered: a hinge at a support that holds the slope");
        }
        if node.moment != S::zero() {
            return refused("not covered: a moment at a hinge");
        }
    }
    Ok(())
}

fn units_of_hinge<S: Scalar>(units: Units, spring: S) -> Result<S, NotProven> {
    not_negative(units.scaled(spring, 1, 1), "a rotational spring of a hinge")
}

/// Supports take part with W = 10 max(Σ|F|, Σ|R|, EI max|κ₀|/l, κ|δ|), clamps with Wl². A spring takes part with the force
/// that it has at the largest deflection, at most W.
fn weights<S: Scalar>(frame: &mut Frame<S>) {
    let (mut forces, mut reactions, mut largest) = (0.0, 0.0, 0.0);
    let mut moved = 0.0;
    for node in &frame.nodes {
        forces += node.force.size() + node.moment.size();
        reactions += node.reaction[0].size() + node.reaction[1].size();
        let settled = node.spring.map_or(0.0, |[_, settled]| settled.size());
        largest = larger(largest, settled);
    }
    for span in &frame.spans {
        let load = span.force.size(span.tau).value() + span.moment.size(span.tau).value();
        forces += load * span.h.high();
        let curled = span.bending.size() * span.curvature.size(span.tau).value();
        largest = larger(largest, curled);
        moved = larger(moved, span.deflection.coefficient(0).size());
    }
    let all = 10.0 * larger(larger(forces, reactions), largest);
    // Without loads any weight will do: the unit of force.
    let rigid = if all > 0.0 && all < 1e60 { all } else { 1.0 };
    let clamp = rigid * frame.length.square().middle();
    let limited = |force: f64, most: f64| if force < most { force } else { most };
    for node in &mut frame.nodes {
        let weights = &mut node.weights;
        weights.rigid = if node.rigid.is_some() { rigid } else { 0.0 };
        weights.clamp = if node.clamped { clamp } else { 0.0 };
        let spring = node.spring.map_or(0.0, |[spring, _]| spring.middle() * moved);
        let turning = node.turning.map_or(0.0, |turning| turning.middle() * moved);
        weights.spring = limited(spring, rigid);
        weights.turning = limited(turning, clamp);
    }
}

fn larger(a: f64, b: f64) -> f64 {
    if a >= b { a } else { b }
}
