//! Assigns hinges, and supports with their reactions, to nodes; computes weights that distribute residual forces over supports.

use crate::answer::{Answer, Reaction};
use crate::frame::{Frame, Held};
use crate::model::{Acts, Model, Support, SupportKind};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::values::not_negative;

/// Returns the claimed reaction of each support of the model; `None` if the claimed solution does not list the reaction.
pub(crate) fn reactions<S: Scalar>(
    model: &Model<S>,
    answer: &Answer,
) -> Result<Vec<Option<Reaction>>, NotProven> {
    let mut all = vec![None; model.supports.len()];
    for reaction in &answer.reactions {
        let place = all.get_mut(reaction.support);
        let place = place
            .ok_or_else(|| NotProven::new("a reaction belongs to a support that does not exist"))?;
        if place.replace(*reaction).is_some() {
            return Err(NotProven::new("a support has two reactions"));
        }
    }
    Ok(all)
}

/// Whether a one-way support has no reaction. Such a support needs no node.
pub(crate) fn is_idle<S: Scalar>(support: &Support<S>, reaction: &Option<Reaction>) -> bool {
    support.acts != Acts::Both && reaction.is_none_or(|reaction| reaction.force == 0.0)
}

/// Assigns the supports to nodes. Rigid supports get the reactions of the claimed solution. An inactive support gets a
/// node only if `places` contains one for it.
pub(crate) fn supports<S: Scalar>(
    model: &Model<S>,
    reactions: &[Option<Reaction>],
    places: &[Option<usize>],
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    let units = frame.units;
    for ((support, reaction), node) in model.supports.iter().zip(reactions).zip(places) {
        let claimed = reaction.map_or([S::zero(); 2], |reaction| {
            let (force, moment) = (S::of(reaction.force), S::of(reaction.moment));
            [units.scaled(force, 1, 0), units.scaled(moment, 1, 1)]
        });
        if !claimed.iter().all(|claimed| claimed.size() <= 1e60) {
            return Err(NotProven::new("a reaction is not finite, or too large"));
        }
        let (x, settlement) = (units.metres(support.at), units.metres(support.settlement));
        if !(settlement.size() <= 1e60) {
            let place = units.restored(x.middle(), 0, 1);
            return Err(NotProven::new("the settlement of a support is out of range").at(place));
        }
        let springs = match support.kind {
            SupportKind::Pinned | SupportKind::Fixed => None,
            SupportKind::Spring { spring, rotational_spring } => Some([
                not_negative(units.scaled(spring, 1, -1), "a spring")?,
                not_negative(units.scaled(rotational_spring, 1, 1), "a rotational spring")?,
            ]),
        };
        let held = Held { x, acts: support.acts, node: *node, springs, settlement, claimed };
        frame.supports.push(held);
        let Some(node) = *node else { continue };
        let clamps = matches!(support.kind, SupportKind::Fixed);
        hold(held, clamps, node, frame)?;
        if springs.is_some() || reaction.is_none() {
            continue;
        }
        let [force, moment] = claimed;
        if moment != S::zero() && matches!(support.kind, SupportKind::Pinned) {
            return Err(NotProven::new("a pin has a moment").at(frame.place(node)));
        }
        if support.acts != Acts::Both && !(support.acts.towards(force).low() >= 0.0) {
            let what = "a one-way support has a reaction in the wrong direction";
            return Err(NotProven::new(what).at(frame.place(node)));
        }
        let node = &mut frame.nodes[node];
        node.reaction = [node.reaction[0] + force, node.reaction[1] - moment];
    }
    Ok(())
}

/// Adds a support to its node. `clamps` states whether the support restrains the slope rigidly.
fn hold<S: Scalar>(
    held: Held<S>,
    clamps: bool,
    node: usize,
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    let place = frame.place(node);
    let node = &mut frame.nodes[node];
    let first = node.rigid.is_none() && node.spring.is_none() && node.turning.is_none();
    if node.acts != Acts::Both || (held.acts != Acts::Both && !first) {
        let what = "a one-way support shares its position with another support";
        return Err(NotProven::new(what).at(place));
    }
    node.acts = held.acts;
    let Some([spring, turning]) = held.springs else {
        if node.rigid.is_some_and(|other| other != held.settlement) {
            return Err(NotProven::new("two rigid supports have the same position").at(place));
        }
        node.rigid = Some(held.settlement);
        node.clamped |= clamps;
        return Ok(());
    };
    if spring != S::zero() {
        let [sum, settled] = node.spring.unwrap_or([S::zero(); 2]);
        node.spring = Some([sum + spring, settled + spring * held.settlement]);
    }
    if turning != S::zero() {
        node.turning = Some(node.turning.map_or(turning, |sum| sum + turning));
    }
    Ok(())
}

pub(crate) fn hinges<S: Scalar>(
    model: &Model<S>,
    places: &[usize],
    frame: &mut Frame<S>,
) -> Result<(), NotProven> {
    let last = frame.spans.len();
    for (hinge, i) in model.hinges.iter().zip(places) {
        let place = frame.place(*i);
        let spring = frame.units.scaled(hinge.rotational_spring, 1, 1);
        let spring = not_negative(spring, "a rotational spring of a hinge")?;
        let node = &mut frame.nodes[*i];
        let refused = |what: &str| Err(NotProven::new(what).at(place));
        if *i == 0 || *i == last {
            return refused("a hinge is at an end of the beam");
        }
        if node.hinge.replace(spring).is_some() {
            return refused("two hinges have the same position");
        }
        // The slope has two values at a hinge, so a support there must not restrain the slope.
        if node.clamped || node.turning.is_some() {
            return refused("a hinge is at a support that restrains the slope");
        }
        if node.moment != S::zero() {
            return refused("a moment acts at a hinge");
        }
    }
    Ok(())
}

/// Sets the weighting factors of supports and axial tension in the balance of residual forces, (6) of docs/proof.md.
/// The proof is valid with any positive factors. The factors follow from the sizes of loads, reactions and settlements.
pub(crate) fn weights<S: Scalar>(frame: &mut Frame<S>) {
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
    // The weighting factor W of a rigid support may be any positive number. If the computed number is zero or
    // too large, W = 1 is used.
    let rigid = if all > 0.0 && all < 1e60 { all } else { 1.0 };
    let clamp = rigid * frame.length.square().middle();
    frame.carrier = rigid * frame.length.middle();
    let limited = |force: f64, most: f64| if force < most { force } else { most };
    for node in &mut frame.nodes {
        if node.acts != Acts::Both {
            // A one-way support needs no weighting factor, because its reaction is multiplied by a number between ½ and
            // 3/2 to restore equilibrium.
            continue;
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::Piece;
    use crate::given::frame;
    use crate::model::{Action, Extent, Load};
    use crate::read::read_model;
    use crate::wide::Wide;

    /// Returns a beam of length 1.5 with the uniform deflection `height`, under a point force of 1 at x = 0.
    fn loaded(height: f64) -> (Model<Wide>, Answer) {
        let text =
            "[beam]\nlength = 1.5\nEI = 1\n[foundation]\nk = 1\n[[load]]\npoint = 1\nat = 0\n";
        let deflection = vec![height];
        let piece = Piece { x: [0.0, 1.5], half: 0.75, deflection, ..Piece::default() };
        let answer = Answer { pieces: vec![piece], ..Answer::default() };
        (read_model(text, None).expect("a model"), answer)
    }

    fn support(at: f64, kind: SupportKind<Wide>, acts: Acts) -> Support<Wide> {
        Support { at: Wide::of(at), kind, settlement: Wide::zero(), acts }
    }

    fn springs(spring: f64, turning: f64) -> SupportKind<Wide> {
        SupportKind::Spring { spring: Wide::of(spring), rotational_spring: Wide::of(turning) }
    }

    #[test]
    fn a_one_way_support_is_alone_at_its_position() {
        let pin = (SupportKind::Pinned, Acts::Both);
        let (spring, turning) = ((springs(1.0, 0.0), Acts::Both), (springs(0.0, 1.0), Acts::Both));
        let (up, pushing) = ((SupportKind::Pinned, Acts::Up), (springs(1.0, 0.0), Acts::Up));
        for (supports, accepted) in [
            (&[up][..], true),
            (&[pushing], true),
            (&[pin, spring, turning], true),
            (&[pin, up], false),
            (&[spring, up], false),
            (&[turning, up], false),
            (&[up, pin], false),
            (&[pushing, spring], false),
            (&[pushing, turning], false),
            (&[up, up], false),
            (&[pin, pushing], false),
        ] {
            let (mut model, mut answer) = loaded(0.0);
            for (i, (kind, acts)) in supports.iter().enumerate() {
                model.supports.push(support(0.0, *kind, *acts));
                if *acts != Acts::Both {
                    answer.reactions.push(Reaction { support: i, force: 1.0, moment: 0.0 });
                }
            }
            assert_eq!(frame(&model, &answer, None, &[]).is_ok(), accepted, "{supports:?}");
        }
    }

    #[test]
    fn springs_at_one_position_add() {
        let (mut model, answer) = loaded(0.0);
        for (spring, turning) in [(2.0, 0.5), (1.0, 0.25), (0.0, 0.125)] {
            model.supports.push(support(1.5, springs(spring, turning), Acts::Both));
        }
        let found = frame(&model, &answer, None, &[]).expect("a frame");
        let node = &found.nodes[1];
        assert_eq!(node.spring.map(|[sum, _]| sum.middle()), Some(3.0));
        assert_eq!(node.turning.map(Wide::middle), Some(0.875));
    }

    /// Checks the weighting factor of a rigid support: ten times the sum of the loads, 2.125, or of the claimed
    /// reactions if that is larger.
    #[test]
    fn the_weights_follow_from_loads_and_reactions() {
        for (height, [force, moment], rigid) in
            [(0.5, [2.0, -1.0], 30.0), (0.5, [0.25, 0.125], 21.25), (1e3, [2.0, -1.0], 30.0)]
        {
            let (mut model, mut answer) = loaded(height);
            for (action, size) in [(Action::Force, 0.5), (Action::Moment, 0.25)] {
                let [from, to, start, end] = [0.0, 1.5, size, size].map(Wide::of);
                let extent = Extent::Distributed { from, to, start, end };
                model.loads.push(Load { action, extent, on_ground: false });
            }
            model.supports.push(support(0.0, SupportKind::Fixed, Acts::Both));
            model.supports.push(support(1.5, springs(2.0, 4.0), Acts::Both));
            answer.reactions.push(Reaction { support: 0, force, moment });
            let found = frame(&model, &answer, None, &[]).expect("a frame");
            let clamp = rigid * 2.25;
            let [spring, turning] = [2.0 * height, 4.0 * height];
            let (held, sprung) = (found.nodes[0].weights, found.nodes[1].weights);
            for (weight, exact) in [
                (held.rigid, rigid),
                (held.clamp, clamp),
                (held.spring, 0.0),
                (held.turning, 0.0),
                (sprung.rigid, 0.0),
                (sprung.clamp, 0.0),
                (sprung.spring, spring.min(rigid)),
                (sprung.turning, turning.min(clamp)),
                (found.carrier, rigid * 1.5),
            ] {
                assert!((weight - exact).abs() <= 1e-12 * exact, "{height}: {weight} {exact}");
            }
        }
    }
}
