//! Decides from loads and supports alone whether an equilibrium exists, by a sharper form of theorem 2 of Kikuchi (1980).
//!
//! An equilibrium exists if the loads do negative work in every rigid motion that ground, supports and tension do not
//! resist. A free beam without tension needs two positive static reactions, (4.24)/(4.25). The proof is in
//! `docs/existence.md`.

use crate::existence::statics::static_reactions;
use crate::existence::unloaded_piece::balanced_without_a_layer;
use crate::existence::verdict::{Existence, RigidMotion, Verdict};
use crate::existence::work::rays;
use crate::model::Model;
use crate::numeric::sum::Sum;

/// Returns the verdict for a valid model without compression, or with compression under which the energy is
/// convex.
pub fn existence(model: &Model) -> Existence {
    let l = model.beam.length;
    let whole = static_reactions(&model.loads, &[0.0, l]);
    let verdict = match judge(&rays(model)) {
        Verdict::NotUnique(motion) => balanced_without_a_layer(model, motion),
        verdict => verdict,
    };
    Existence { verdict, static_reactions: [whole[0].sum, whole[1].sum] }
}

/// Returns the verdict on existence that follows from the work of the loads along the extreme rays of the cone of free
/// rigid motions.
fn judge(rays: &[(Sum, RigidMotion)]) -> Verdict {
    let worst = rays.iter().filter(|(cost, _)| cost.is_negative());
    if let Some((_, motion)) = worst.max_by(|a, b| a.1.work.total_cmp(&b.1.work)) {
        return Verdict::None(*motion);
    }
    match rays.iter().find(|(cost, _)| cost.is_zero()) {
        Some((_, motion)) => Verdict::NotUnique(RigidMotion { work: 0.0, ..*motion }),
        None => Verdict::Unique,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Action, Extent};
    use crate::model::{Beam, Foundation, Hinge, Load, Support};

    fn beam() -> Model {
        Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
    }

    fn exists(model: &Model) -> bool {
        !matches!(existence(model).verdict, Verdict::None(_))
    }

    #[test]
    fn kikuchi_5_21() {
        // Under a force f₀ and a moment M₀ at the middle of a beam of length l, an equilibrium exists for
        // ½ f₀ l > M₀ > −½ f₀ l.
        let case =
            |m| beam().with_load(Load::point_force(2.0, 1.0)).with_load(Load::point_moment(2.0, m));
        assert!(exists(&case(1.99)) && exists(&case(-1.99)));
        assert!(!exists(&case(2.01)) && !exists(&case(-2.01)));
        assert!(matches!(existence(&case(2.0)).verdict, Verdict::NotUnique(m) if m.left == -1.0));
        let Verdict::None(motion) = existence(&case(3.0)).verdict else { panic!() };
        assert_eq!((motion.left, motion.right, motion.work), (-1.0, 0.0, 0.25));
    }

    #[test]
    fn kikuchi_figure_2() {
        // Case (a) of figure 2 of Kikuchi's paper: a uniform load f₀ acts over the length a in the middle of the
        // beam, and a moment M₀ acts at each end of the loaded part.
        let (f0, a, l) = (3.0, 2.0, 4.0);
        for m0 in [2.9, 3.1] {
            let model = beam()
                .with_load(Load::uniform_force(1.0, 3.0, f0))
                .with_load(Load::point_moment(1.0, m0))
                .with_load(Load::point_moment(3.0, m0));
            let condition =
                f0 * a > 0.5 * f0 * a + 2.0 * m0 / l && 0.5 * f0 * a + 2.0 * m0 / l > 0.0;
            assert_eq!(exists(&model), condition, "(a) {m0}");
        }
        // Case (b) of figure 2 of Kikuchi's paper: a uniform load f₀ acts on the left part [0, a] of the beam, and a
        // moment M₀ acts to the right of this part.
        for m0 in [-7.0, -5.0, 17.0, 19.0] {
            let model = beam()
                .with_load(Load::uniform_force(0.0, a, f0))
                .with_load(Load::point_moment(3.0, m0));
            let middle = a / (2.0 * l) * f0 * a + m0 / l;
            assert_eq!(exists(&model), f0 * a > middle && middle > 0.0, "(b) {m0}");
        }
        // Case (c) of figure 2 of Kikuchi's paper: f₁ and f₃ act at the left and the right end, and f₂ on an arm of
        // length a to the left of the beam. The model replaces the arm by the moment −f₂ a.
        for (f2, f3) in [(1.0, 0.3), (1.0, 0.2), (-1.0, 0.1)] {
            let (f1, a) = (2.0, 1.0);
            let model = beam()
                .with_load(Load::point_force(0.0, f1))
                .with_load(Load::point_force(0.0, f2))
                .with_load(Load::point_moment(0.0, -f2 * a))
                .with_load(Load::point_force(l, f3));
            let middle = (-f2 * a + f3 * l) / l;
            assert_eq!(exists(&model), f1 + f2 + f3 > middle && middle > 0.0, "(c) {f2} {f3}");
        }
    }

    #[test]
    fn tension_and_supports_shrink_the_free_motions() {
        let outside =
            beam().with_load(Load::point_force(2.0, 1.0)).with_load(Load::point_moment(2.0, 2.8));
        assert!(!exists(&outside));
        let mut tied = outside.clone();
        tied.beam.axial_force = 2.0;
        assert!(exists(&tied));
        assert!(exists(&outside.clone().with_support(Support::pinned(1.0))));
        assert!(exists(&outside.clone().with_support(Support::pinned(0.0))));
        assert!(!exists(&outside.clone().with_support(Support::pinned(4.0))));
        assert!(exists(&outside.clone().with_support(Support::fixed(4.0))));
        assert!(exists(&outside.with_support(Support::spring(4.0, 1.0, 1.0))));
    }

    /// If no equilibrium exists, the loads do positive work in the motion of the verdict. Otherwise they do no positive
    /// work in random upward motions.
    #[test]
    fn random_motions_of_hinged_beams() {
        // A linear congruential generator, x' = 16807 x mod (2³¹ − 1), returns random numbers.
        let mut seed = 1980_u64;
        let mut dice = move || {
            seed = seed * 16807 % 2_147_483_647;
            seed as f64 / 2_147_483_647.0
        };
        let mut verdicts = [0; 2];
        for _ in 0..2000 {
            let mut model = beam();
            for _ in 0..3 {
                model = model.with_hinge(Hinge::free(4.0 * dice()));
            }
            for _ in 0..4 {
                let force = dice() - 0.1;
                model = model.with_load(Load::point_force(4.0 * dice(), force));
                let from = 3.0 * dice();
                let force = dice() - 0.1;
                model = model.with_load(Load::uniform_force(from, from + dice(), force));
                let moment = 0.2 * (dice() - 0.5);
                model = model.with_load(Load::point_moment(4.0 * dice(), moment));
            }
            let work = |r: &dyn Fn(f64) -> f64| -> f64 {
                let each = model.loads.iter().map(|load| match (load.action(), load.extent()) {
                    (Action::Force, Extent::Point { at, size }) => size * r(at),
                    (Action::Moment, Extent::Point { at, size }) => {
                        size * (r(at + 1e-7) - r(at - 1e-7)) / 2e-7
                    }
                    (Action::Force, Extent::Distributed { from, to, start, .. }) => {
                        let n = 2000;
                        let step = (to - from) / f64::from(n);
                        let x = |i: i32| from + (f64::from(i) + 0.5) * step;
                        (0..n).map(|i| start * r(x(i)) * step).sum()
                    }
                    _ => 0.0,
                });
                each.sum()
            };
            let found = existence(&model).verdict;
            verdicts[usize::from(matches!(found, Verdict::None(_)))] += 1;
            if let Verdict::None(motion) = found {
                let gained = work(&|x| motion.at(&model, x));
                assert!(
                    (gained - motion.work).abs() < 1e-5 && motion.work > 0.0,
                    "{motion:?} {gained}"
                );
                continue;
            }
            let mut nodes: Vec<f64> = model.hinges.iter().map(|h| h.at).chain([0.0, 4.0]).collect();
            nodes.sort_by(f64::total_cmp);
            let values: Vec<f64> = nodes.iter().map(|_| -dice()).collect();
            let r = |x: f64| {
                let i = nodes.partition_point(|node| *node <= x).clamp(1, 4);
                let t = (x - nodes[i - 1]) / (nodes[i] - nodes[i - 1]);
                values[i - 1] + t * (values[i] - values[i - 1])
            };
            assert!(work(&r) < 1e-5, "{values:?} {model:?}");
        }
        assert!(verdicts.iter().all(|count| *count > 300), "{verdicts:?}");
    }

    #[test]
    fn supports_that_hold_a_hinged_beam() {
        let slab = || {
            beam()
                .with_hinge(Hinge::free(1.0))
                .with_hinge(Hinge::free(3.0))
                .with_load(Load::uniform_force(0.0, 4.0, 1.0))
        };
        let lifted = |model: Model, x: f64| model.with_load(Load::point_force(x, -2.0));
        assert!(exists(&slab()));
        // An end or a free hinge can lift alone. A hinge with a spring cannot.
        for x in [0.0, 1.0, 4.0] {
            assert!(!exists(&lifted(slab(), x)), "{x}");
            assert!(!exists(&lifted(slab().with_hinge(Hinge::elastic(2.0, 1.0)), x)));
        }
        let mut stiff = slab();
        stiff.hinges.iter_mut().for_each(|hinge| hinge.rotational_spring = 1.0);
        assert!(exists(&lifted(stiff, 1.0)));
        // With a support inside a piece between two hinges or beam ends, neither end of this piece can lift off. A
        // support at a hinge prevents the lift-off of this hinge only.
        assert!(exists(&lifted(slab().with_support(Support::pinned(0.5)), 1.0)));
        assert!(!exists(&lifted(slab().with_support(Support::pinned(0.5)), 3.0)));
        assert!(exists(&lifted(slab().with_support(Support::pinned(1.0)), 1.0)));
        assert!(!exists(&lifted(slab().with_support(Support::pinned(1.0)), 0.0)));
        // A piece that cannot rotate can lift off only as a whole.
        let turned = |at: f64| slab().with_support(Support::spring(at, 0.0, 1.0));
        assert!(exists(&lifted(turned(0.5), 1.0)) && !exists(&lifted(turned(3.5), 1.0)));
        // Under tension, only the whole beam can lift off. An upward force of 2 does not lift the load of 4.
        let mut tied = slab();
        tied.beam.axial_force = 1.0;
        assert!(exists(&lifted(tied.clone(), 4.0)));
        assert!(!exists(&lifted(lifted(tied, 4.0), 0.0).with_load(Load::point_force(2.0, -0.1))));
    }

    #[test]
    fn a_lifting_resultant_is_refused_even_under_tension() {
        let mut model = beam().with_load(Load::point_force(2.0, -1.0));
        model.beam.axial_force = 5.0;
        let Verdict::None(motion) = existence(&model).verdict else { panic!() };
        assert_eq!((motion.left, motion.right, motion.work), (-1.0, -1.0, 1.0));
    }

    /// If several motions prove that no equilibrium exists, the verdict names the motion in which the loads do the most
    /// work.
    #[test]
    fn the_motion_with_the_largest_work_is_the_proof() {
        let model = |left: f64, right: f64| {
            let loads = beam().with_load(Load::point_force(0.0, left));
            existence(&loads.with_load(Load::point_force(4.0, right))).verdict
        };
        let motion =
            |left: f64, right: f64, work: f64| RigidMotion { left, right, work, lifted: None };
        assert_eq!(model(-1.0, -3.0), Verdict::None(motion(0.0, -1.0, 3.0)));
        assert_eq!(model(-3.0, -1.0), Verdict::None(motion(-1.0, 0.0, 3.0)));
        assert_eq!(model(0.0, -1.0), Verdict::None(motion(0.0, -1.0, 1.0)));
        assert_eq!(model(1.0, 1.0), Verdict::Unique);
        // The verdict names the first motion in which the loads do no work. The stored work is 0, not −0.
        let Verdict::NotUnique(found) = model(0.0, 0.0) else { panic!() };
        assert_eq!((found, found.work.is_sign_positive()), (motion(-1.0, 0.0, 0.0), true));
    }
}
