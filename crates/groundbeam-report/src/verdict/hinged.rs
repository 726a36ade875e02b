//! Writes why a beam with free hinges has one equilibrium, several or none, from the tipping of its parts.

use crate::quantity::Units;
use groundbeam::{
    Existence, Model, Verdict,
    existence::{RigidMotion, static_reactions},
};

/// The reason why there is exactly one equilibrium, more than one equilibrium, or none. The effects of
/// compression are not included.
pub(super) fn sentence(model: &Model, existence: &Existence, units: Units) -> String {
    let moves = |motion| moves(model, motion, units);
    match existence.verdict {
        Verdict::Unique => {
            let held = if model.supports.is_empty() { "hinges" } else { "hinges and supports" };
            format!(
                "the loads resist every motion that lifts a part of the beam and is allowed by its {held}"
            )
        }
        Verdict::NotUnique(motion)
            if motion.left == 0.0 && motion.right == 0.0 && is_at_rest(motion) =>
        {
            let [from, to] = motion.lifted.unwrap_or_default().map(|x| units.position(x));
            format!(
                "the part of the beam from x = {from} to {to} rests on too few points: its rotation is \
                 not determined, any equilibrium shown is one of many"
            )
        }
        Verdict::NotUnique(motion) => format!(
            "the loads do not prevent a motion of the beam: {}; the amount of this motion is not \
             determined, any equilibrium shown is one of many",
            moves(motion)
        ),
        Verdict::None(motion) if motion.work == 0.0 => format!(
            "the loads do not prevent a motion of the beam: {}; Winkler ground (mu = 0) cannot \
             carry the rest of the beam on one point",
            moves(motion)
        ),
        Verdict::None(motion) => format!("the loads lift a part of the beam: {}", moves(motion)),
        Verdict::Local(_) | Verdict::Buckles(_) => String::new(),
    }
}

/// Whether the motion lifts a part of the beam of nonzero length, and the loads do no work.
fn is_at_rest(motion: RigidMotion) -> bool {
    motion.lifted.is_some_and(|[from, to]| from < to) && motion.work == 0.0
}

/// Description of the motion, such as `the hinge at x = 4 lifts off, the left end stays in place`.
pub(super) fn moves(model: &Model, motion: RigidMotion, units: Units) -> String {
    let l = model.beam.length;
    let [from, to] = motion.lifted.unwrap_or([0.0, l]);
    let nodes: Vec<f64> = static_reactions(model).into_iter().map(|(x, _)| x).collect();
    let before = nodes.iter().rev().find(|x| **x < from).copied();
    let after = nodes.iter().find(|x| **x > to).copied();
    let at = |x: f64| {
        if x == 0.0 {
            "the left end".to_owned()
        } else if x == l {
            "the right end".to_owned()
        } else {
            format!("the hinge at x = {}", units.position(x))
        }
    };
    let lifted = if from == to { at(from) } else { format!("all from {} to {}", at(from), at(to)) };
    match (before, after) {
        (None, None) => "the beam lifts off as a whole".to_owned(),
        (Some(rest), None) | (None, Some(rest)) => {
            format!("{lifted} lifts off, {} stays in place", at(rest))
        }
        (Some(left), Some(right)) => {
            format!("{lifted} lifts off, {} and {} stay in place", at(left), at(right))
        }
    }
}

/// Short description of the motion, such as `the left end lifts off`.
pub(crate) fn falls(motion: RigidMotion, units: Units) -> String {
    match (motion.lifted, motion.left < 0.0, motion.right < 0.0) {
        (None, true, false) => "the beam tips about its right end".to_owned(),
        (None, false, true) => "the beam tips about its left end".to_owned(),
        (Some(_), true, false) => "the left end lifts off".to_owned(),
        (Some(_), false, true) => "the right end lifts off".to_owned(),
        (Some([x, _]), false, false) => {
            format!("the hinge at x = {} lifts off", units.position(x))
        }
        _ => "the beam lifts off as a whole".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{motion as written, remedy, sentence};
    use super::*;
    use groundbeam::{Beam, Foundation, Hinge, Load};

    #[test]
    fn every_verdict_has_its_sentence() {
        let slab = || {
            Model::new(Beam::uniform(6.0, 1.0), Foundation::pasternak(1.0, 1.0))
                .with_hinge(Hinge::free(2.0))
                .with_hinge(Hinge::free(4.0))
                .with_load(Load::uniform_force(0.0, 6.0, 1.0))
        };
        let cases = [
            (slab(), "lifts a part of the beam and is allowed by its hinges", "", ""),
            (
                slab().with_load(Load::point_force(6.0, -3.0)),
                "lift a part of the beam: the right end lifts off, the hinge at x = 4 stays in place",
                "the right end lifts off, the hinge at x = 4 stays in place; no part of the beam moves into the ground",
                "of more than 2 at the right end",
            ),
            (
                slab().with_load(Load::point_force(2.0, -3.0)),
                "the hinge at x = 2 lifts off, the left end and the hinge at x = 4 stay in place",
                "the hinge at x = 2 lifts off",
                " at x = 2",
            ),
            (
                slab().with_load(Load::point_force(6.0, -1.0)),
                "the loads do not prevent a motion of the beam: the right end lifts off",
                "",
                "",
            ),
        ];
        for (model, said, moving, mended) in cases {
            let existence = groundbeam::exists(&model).unwrap();
            let found = sentence(&model, &existence, Units::PLAIN);
            assert!(found.contains(said), "{found}");
            if let Verdict::None(motion) = existence.verdict {
                let found = written(&model, motion, Units::PLAIN);
                assert!(found.contains(moving), "{found}");
                let found = remedy(motion, Units::PLAIN).unwrap();
                assert!(found.contains(mended), "{found}");
            }
        }
    }
}
