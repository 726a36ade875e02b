//! Existence of an equilibrium, from loads and supports alone. Section 4, sharpened.
//!
//! The energy is coercive, and therefore has a minimum, if and only if F(r) < 0 for every free rigid motion r
//! = a x + b ≤ 0 of the beam, where F(r) is the work of the loads. A motion is free if it presses nowhere on
//! the ground and if neither supports nor tension resist it. For a free beam without tension these are all r
//! with r(0) ≤ 0 and r(l) ≤ 0. Since F(r) = R₀ r(0) + R_l r(l) with the *static reactions* R₀ and R_l of the
//! loads, both must be positive: (4.24)/(4.25), necessary and sufficient. Tension and supports reduce the set
//! of free motions. Free hinges enlarge it: r may have a kink at each.

use crate::existence::rigid_motions::Mechanism;
use crate::existence::statics::static_reactions;
use crate::existence::verdict::{Existence, RigidMotion, Verdict};
use crate::model::{Model, Support};
use crate::numeric::sum::Sum;
use std::ops::Range;

/// The verdict for a valid model with P ≥ 0, or with a convex energy in spite of compression.
pub fn existence(model: &Model) -> Existence {
    let l = model.beam.length;
    let whole = static_reactions(&model.loads, &[0.0, l]);
    let verdict = match judge(&rays(model)) {
        Verdict::NotUnique(motion) => balanced_without_a_layer(model, motion),
        verdict => verdict,
    };
    Existence { verdict, static_reactions: [whole[0].sum, whole[1].sum] }
}

/// The static reactions: position \[m\] and force, up positive \[N\]. They are the forces of supports under
/// the ends and the free hinges of a beam that is rigid between them and has no other supports.
///
/// ```
/// use groundbeam::{Beam, Foundation, Hinge, Load, Model, existence::static_reactions};
///
/// let model = Model::new(Beam::uniform(4.0, 1.0), Foundation::winkler(1.0))
///     .with_hinge(Hinge::free(2.0))
///     .with_load(Load::point_force(3.0, 1.0));
/// assert_eq!(static_reactions(&model), [(0.0, 0.0), (2.0, 0.5), (4.0, 0.5)]);
/// ```
pub fn static_reactions_of(model: &Model) -> Vec<(f64, f64)> {
    let nodes = Mechanism::of(model).nodes;
    let reactions = static_reactions(&model.loads, &nodes);
    nodes.into_iter().zip(reactions).map(|(x, reaction)| (x, reaction.sum)).collect()
}

/// The extreme rays of the cone of free motions, each with its work −F(r), which is linear in the loads. The
/// rays do not depend on the loads.
pub(crate) fn rays(model: &Model) -> Vec<(Sum, RigidMotion)> {
    let mechanism = Mechanism::of(model);
    let nodes = &mechanism.nodes;
    let reactions = static_reactions(&model.loads, nodes);
    let last = nodes.len() - 1;
    let hinged = last > 1;
    let ray = |group: Range<usize>| {
        let own = reactions[group.clone()].iter().copied();
        let cost = own.reduce(Sum::plus).unwrap_or_default();
        let lifts = |node: usize| if group.contains(&node) { -1.0 } else { 0.0 };
        let lifted = hinged.then(|| [nodes[group.start], nodes[group.end - 1]]);
        (cost, RigidMotion { left: lifts(0), right: lifts(last), work: -cost.sum, lifted })
    };
    mechanism.free_groups().into_iter().map(ray).collect()
}

/// The sum of the absolute values of the loads \[N\].
pub(crate) fn size_of_loads(model: &Model) -> f64 {
    static_reactions(&model.loads, &Mechanism::of(model).nodes).iter().map(|sum| sum.size).sum()
}

/// The verdict from the work of the extreme rays.
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

/// The verdict for a piece that may lift without work. Such a piece can press on the ground only under a node
/// that stays at rest. If no neighbouring piece can press there, the load of this node needs a concentrated
/// contact force. Only a shear layer or a support that pushes up can carry it; on Winkler ground the beam
/// would sink and rotate without limit.
fn balanced_without_a_layer(model: &Model, motion: RigidMotion) -> Verdict {
    let mechanism = Mechanism::of(model);
    let (nodes, groups) = (&mechanism.nodes, mechanism.free_groups());
    let reactions = static_reactions(&model.loads, nodes);
    let cost = |group: &Range<usize>| {
        reactions[group.clone()].iter().copied().reduce(Sum::plus).unwrap_or_default()
    };
    let pieces = nodes.len() - 1;
    let beside = |group: &Range<usize>| group.start.saturating_sub(1)..group.end.min(pieces);
    let mut bare = vec![false; pieces];
    for group in groups.iter().filter(|group| cost(group).is_zero()) {
        bare[beside(group)].fill(true);
    }
    let l = model.beam.length;
    let layered = |node: usize| {
        let x = nodes[node];
        let sides = [x - f64::EPSILON * l, x + f64::EPSILON * l];
        let inside = sides.map(|x| x.clamp(f64::MIN_POSITIVE, l * (1.0 - f64::EPSILON)));
        let bearing = |support: &Support| (support.at - x).abs() <= 4.0 * f64::EPSILON * l;
        model.supports.iter().any(bearing)
            || inside.iter().any(|x| model.foundation.constants_at(*x).1 > 0.0)
    };
    let sinks = |group: &Range<usize>| {
        !cost(group).is_zero()
            && bare[beside(group)].iter().all(|bare| *bare)
            && !group.clone().any(layered)
    };
    if groups.iter().any(sinks) { Verdict::None(motion) } else { Verdict::NotUnique(motion) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::existence::verdict::{Buckling, Local};
    use crate::model::{Action, Extent};
    use crate::model::{Acts, Beam, Foundation, Hinge, Load, Support};
    use crate::numeric::elementary::power;

    fn beam() -> Model {
        Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
    }

    fn exists(model: &Model) -> bool {
        !matches!(existence(model).verdict, Verdict::None(_))
    }

    #[test]
    fn kikuchi_5_21() {
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
        // (a) A uniform load f₀ over a length a about the middle, and a total moment 2M₀.
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
        // (b) A uniform load on [0, a] and a moment M₀.
        for m0 in [-7.0, -5.0, 17.0, 19.0] {
            let model = beam()
                .with_load(Load::uniform_force(0.0, a, f0))
                .with_load(Load::point_moment(3.0, m0));
            let middle = a / (2.0 * l) * f0 * a + m0 / l;
            assert_eq!(exists(&model), f0 * a > middle && middle > 0.0, "(b) {m0}");
        }
        // (c) f₁ at the left end, a moment −f₂ a by f₂ upward, f₃ at the right end.
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

    /// A motion r ≤ 0 with random values at the ends and hinges has F(r) < 0, or the verdict names a group of
    /// nodes that lifts without work.
    #[test]
    fn random_motions_of_hinged_beams() {
        // A linear congruential generator: x' = 16807 x mod 2³¹ − 1.
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
    fn what_holds_a_hinged_beam() {
        let slab = || {
            beam()
                .with_hinge(Hinge::free(1.0))
                .with_hinge(Hinge::free(3.0))
                .with_load(Load::uniform_force(0.0, 4.0, 1.0))
        };
        let pulled = |model: Model, x: f64| model.with_load(Load::point_force(x, -2.0));
        assert!(exists(&slab()));
        // A hinge or an end can lift alone; a spring in the hinge keeps the beam straight.
        for x in [0.0, 1.0, 4.0] {
            assert!(!exists(&pulled(slab(), x)), "{x}");
            assert!(!exists(&pulled(slab().with_hinge(Hinge::elastic(2.0, 1.0)), x)));
        }
        let mut stiff = slab();
        stiff.hinges.iter_mut().for_each(|hinge| hinge.rotational_spring = 1.0);
        assert!(exists(&pulled(stiff, 1.0)));
        // A support within a piece holds both of its nodes; a support at a hinge holds that hinge only.
        assert!(exists(&pulled(slab().with_support(Support::pinned(0.5)), 1.0)));
        assert!(!exists(&pulled(slab().with_support(Support::pinned(0.5)), 3.0)));
        assert!(exists(&pulled(slab().with_support(Support::pinned(1.0)), 1.0)));
        assert!(!exists(&pulled(slab().with_support(Support::pinned(1.0)), 0.0)));
        // A piece that cannot rotate lifts as a whole: a load of 4 against 2. Tension keeps the whole beam
        // straight.
        let turned = |at: f64| slab().with_support(Support::spring(at, 0.0, 1.0));
        assert!(exists(&pulled(turned(0.5), 1.0)) && !exists(&pulled(turned(3.5), 1.0)));
        let mut tied = slab();
        tied.beam.axial_force = 1.0;
        assert!(exists(&pulled(tied.clone(), 4.0)));
        assert!(!exists(&pulled(pulled(tied, 4.0), 0.0).with_load(Load::point_force(2.0, -0.1))));
    }

    #[test]
    fn an_unloaded_piece_may_lie_as_it_likes() {
        let half = |ground| {
            Model::new(Beam::uniform(4.0, 1.0), ground)
                .with_hinge(Hinge::free(2.0))
                .with_load(Load::uniform_force(0.0, 2.0, 1.0))
        };
        let springs = existence(&half(Foundation::winkler(1.0))).verdict;
        assert!(matches!(springs, Verdict::NotUnique(m) if m.lifted == Some([4.0, 4.0])));
        // The whole load over the hinge: only a shear layer carries it at a point.
        let over = |ground| {
            let mut model = half(ground);
            model.loads = vec![Load::point_force(2.0, 1.0)];
            existence(&model).verdict
        };
        assert!(matches!(over(Foundation::pasternak(1.0, 1.0)), Verdict::NotUnique(_)));
        assert!(matches!(over(Foundation::winkler(1.0)), Verdict::None(m) if m.work == 0.0));
    }

    #[test]
    fn a_lifting_resultant_is_refused_even_under_tension() {
        let mut model = beam().with_load(Load::point_force(2.0, -1.0));
        model.beam.axial_force = 5.0;
        let Verdict::None(motion) = existence(&model).verdict else { panic!() };
        assert_eq!((motion.left, motion.right, motion.work), (-1.0, -1.0, 1.0));
    }

    #[test]
    fn what_each_verdict_says() {
        let motion = RigidMotion { left: -1.0, right: 0.0, work: 0.5, lifted: None };
        let local = Local { stability_margin: 0.5, critical_compression: 2.0 };
        let buckling =
            Buckling { critical_compression: 2.0, at: 1.0, left: -0.25, right: 0.75, work: 3.0 };
        for (verdict, stands, moves) in [
            (Verdict::Unique, true, None),
            (Verdict::NotUnique(motion), true, Some([-1.0, 0.0, 0.5])),
            (Verdict::Local(local), true, None),
            (Verdict::None(motion), false, Some([-1.0, 0.0, 0.5])),
            (Verdict::Buckles(buckling), false, Some([-0.25, 0.75, 3.0])),
        ] {
            assert_eq!((verdict.stands(), verdict.motion()), (stands, moves), "{verdict:?}");
        }
    }

    #[test]
    fn a_motion_is_straight_between_ends_and_hinges() {
        let whole = RigidMotion { left: -1.0, right: 0.5, work: 0.0, lifted: None };
        assert_eq!([0.0, 1.0, 3.0, 4.0].map(|x| whole.at(&beam(), x)), [-1.0, -0.625, 0.125, 0.5]);
        let hinged = beam().with_hinge(Hinge::free(1.0)).with_hinge(Hinge::free(2.0));
        let at = |lifted: [f64; 2]| {
            let motion = RigidMotion { lifted: Some(lifted), ..whole };
            [0.0, 0.25, 1.0, 1.5, 2.0, 3.5, 4.0].map(|x| motion.at(&hinged, x))
        };
        assert_eq!(at([0.0, 0.0]), [-1.0, -0.75, 0.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(at([1.0, 1.0]), [0.0, -0.25, -1.0, -0.5, 0.0, 0.0, 0.0]);
        assert_eq!(at([1.0, 2.0]), [0.0, -0.25, -1.0, -1.0, -1.0, -0.25, 0.0]);
        assert_eq!(at([4.0, 4.0]), [0.0, 0.0, 0.0, 0.0, 0.0, -0.75, -1.0]);
    }

    /// For a force F at the distance a on a beam of length 4, R₀ = F (1 − a/4) and R_l = F a/4.
    #[test]
    fn the_resultant_and_its_position_follow_from_the_static_reactions() {
        let found = existence(&beam().with_load(Load::point_force(1.0, 4.0)));
        assert_eq!(found.static_reactions, [3.0, 1.0]);
        assert_eq!((found.resultant(), found.resultant_position(4.0)), (4.0, Some(1.0)));
        // A couple alone has no position.
        let couple = existence(&beam().with_load(Load::point_moment(1.0, 2.0)));
        assert_eq!(couple.static_reactions, [-0.5, 0.5]);
        assert_eq!((couple.resultant(), couple.resultant_position(4.0)), (0.0, None));
    }

    /// On a rigid piece from a to b, a force F at x gives the reaction F (b − x)/(b − a) at a. A moment M
    /// gives −M/(b − a) at a and M/(b − a) at b.
    #[test]
    fn each_end_and_hinge_has_its_static_reaction() {
        let hinged = beam().with_hinge(Hinge::free(2.0));
        let loaded =
            hinged.with_load(Load::point_force(3.5, 1.0)).with_load(Load::point_moment(1.0, -3.0));
        assert_eq!(static_reactions_of(&loaded), [(0.0, 1.5), (2.0, -1.25), (4.0, 0.75)]);
        // Absolute values do not cancel: 0.25 + 0.75 of the force, twice 3/2 of the moment.
        assert_eq!(size_of_loads(&loaded), 4.0);
        assert_eq!(size_of_loads(&loaded.with_load(Load::point_force(3.5, -1.0))), 5.0);
    }

    #[test]
    fn the_extreme_rays_lift_each_group_of_nodes() {
        // A rotational spring at 2 makes the hinges at 1 and 3 lift together.
        let model = beam()
            .with_hinge(Hinge::free(1.0))
            .with_hinge(Hinge::free(3.0))
            .with_support(Support::spring(2.0, 0.0, 1.0))
            .with_load(Load::uniform_force(0.0, 4.0, 1.0));
        let found = rays(&model).into_iter().map(|(cost, motion)| (cost.sum, motion));
        let ray = |left: f64, right: f64, cost: f64, lifted: [f64; 2]| {
            (cost, RigidMotion { left, right, work: -cost, lifted: Some(lifted) })
        };
        let wanted = [
            ray(-1.0, 0.0, 0.5, [0.0, 0.0]),
            ray(0.0, 0.0, 3.0, [1.0, 3.0]),
            ray(0.0, -1.0, 0.5, [4.0, 4.0]),
        ];
        assert_eq!(found.collect::<Vec<_>>(), wanted);
    }

    /// If several motions prove that no equilibrium exists, the verdict names the one with the largest work.
    #[test]
    fn the_worst_motion_is_the_proof() {
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
        // The verdict names the first motion without work, and its work is 0, not −0.
        let Verdict::NotUnique(found) = model(0.0, 0.0) else { panic!() };
        assert_eq!((found, found.work.is_sign_positive()), (motion(-1.0, 0.0, 0.0), true));
    }

    fn with_contact(model: &Model, contact: &[[f64; 2]]) -> Verdict {
        let stands = Existence { verdict: Verdict::Unique, static_reactions: [1.0, 2.0] };
        let found = stands.with_contact(model, contact);
        assert_eq!(found.static_reactions, [1.0, 2.0]);
        found.verdict
    }

    #[test]
    fn a_beam_on_one_point_turns_about_it() {
        let turns = |left: f64, right: f64| {
            Verdict::NotUnique(RigidMotion { left, right, work: 0.0, lifted: None })
        };
        let beam = beam();
        // The end farther from the point moves by 1.
        assert_eq!(with_contact(&beam, &[[1.0; 2]]), turns(-1.0 / 3.0, 1.0));
        assert_eq!(with_contact(&beam, &[[3.0; 2]]), turns(-1.0, 1.0 / 3.0));
        assert_eq!(with_contact(&beam, &[[1.0; 2], [3.0; 2]]), Verdict::Unique);
        assert_eq!(with_contact(&beam, &[[1.0, 1.5]]), Verdict::Unique);
        let pinned = beam.clone().with_support(Support::pinned(1.0));
        assert_eq!(with_contact(&pinned, &[]), turns(-1.0 / 3.0, 1.0));
        assert_eq!(with_contact(&pinned, &[[3.0; 2]]), Verdict::Unique);
        let mut tied = beam.clone();
        tied.beam.axial_force = 1.0;
        assert_eq!(with_contact(&tied, &[[1.0; 2]]), Verdict::Unique);
        // Without a point of contact there is no rotation about it.
        assert_eq!(with_contact(&beam, &[]), Verdict::Unique);
        // If no equilibrium exists, contact at one point does not change the verdict.
        let falls = existence(&beam.clone().with_load(Load::point_force(2.0, -1.0)));
        assert_eq!(falls.with_contact(&beam, &[[1.0; 2]]), falls);
    }

    #[test]
    fn a_piece_that_nothing_holds_may_move() {
        let hinged = beam().with_hinge(Hinge::free(2.0));
        let mechanism = |from: f64, to: f64| {
            let lifted = Some([from, to]);
            Verdict::NotUnique(RigidMotion { left: 0.0, right: 0.0, work: 0.0, lifted })
        };
        assert_eq!(with_contact(&hinged, &[[0.5, 1.0]]), mechanism(2.0, 4.0));
        assert_eq!(with_contact(&hinged, &[[2.0, 3.0]]), mechanism(0.0, 2.0));
        assert_eq!(with_contact(&hinged, &[]), mechanism(0.0, 2.0));
        // Contact on both sides of the hinge holds the hinge, and therefore both pieces.
        assert_eq!(with_contact(&hinged, &[[1.0, 3.0]]), Verdict::Unique);
        assert_eq!(with_contact(&hinged, &[[1.0, 2.0], [3.0; 2]]), Verdict::Unique);
    }

    /// Under a force over an end or a hinge, an unloaded beam on Winkler ground sinks without limit, unless a
    /// shear layer reaches this position: only a shear layer carries a concentrated force. The result does
    /// not depend on the unit of length.
    #[test]
    fn a_force_over_a_node_needs_a_shear_layer() {
        let over = |unit: f64, x: f64, shear: [f64; 2], [from, to]: [f64; 2]| {
            let [inside, outside] = shear;
            let ground = Foundation::pasternak(1.0, outside).with_segment(
                from * unit,
                to * unit,
                1.0,
                inside,
            );
            Model::new(Beam::uniform(4.0 * unit, 1.0), ground)
                .with_hinge(Hinge::free(2.0 * unit))
                .with_load(Load::point_force(x * unit, 1.0))
        };
        for unit in [1.0, power(0.5, 40), power(2.0, 40)] {
            for (x, segment, layered, bare) in [
                (2.0, [1.0, 2.0], true, true),
                (2.0, [2.0, 3.0], true, true),
                (2.0, [1.0, 3.0], true, false),
                (2.0, [0.0, 1.0], false, true),
                (2.0, [3.0, 4.0], false, true),
                (0.0, [0.0, 1.0], true, false),
                (0.0, [1.0, 4.0], false, true),
                (4.0, [3.0, 4.0], true, false),
                (4.0, [0.0, 3.0], false, true),
            ] {
                // A shear layer only along the segment, and only outside it.
                for (shear, carried) in [([1.0, 0.0], layered), ([0.0, 1.0], bare)] {
                    let verdict = existence(&over(unit, x, shear, segment)).verdict;
                    let stands = matches!(verdict, Verdict::NotUnique(_));
                    assert_eq!(stands, carried, "{x} {segment:?} {shear:?} {verdict:?}");
                    assert_eq!(verdict.stands(), carried);
                }
            }
        }
    }

    /// A support that only pushes up also carries a force over it. Positions closer than 4 ε l count as one.
    #[test]
    fn a_force_over_a_node_needs_a_bearing_at_that_node() {
        let springs = Model::new(Beam::uniform(4.0, 1.0), Foundation::winkler(1.0))
            .with_hinge(Hinge::free(2.0))
            .with_load(Load::point_force(2.0, 1.0));
        let apart = 4.0 * f64::EPSILON * 4.0;
        for (at, carried) in [
            (2.0, true),
            (2.0 + apart, true),
            (2.0 - apart, true),
            (2.0 + 1.5 * apart, false),
            (2.0 - 1.5 * apart, false),
            (1.0, false),
            (4.0, false),
        ] {
            let bearing = Support::pinned(at).acting(Acts::Up);
            let verdict = existence(&springs.clone().with_support(bearing)).verdict;
            assert_eq!(verdict.stands(), carried, "{at}");
        }
    }

    /// A loaded piece beside the node presses on its springs, which also carry the force over the node.
    #[test]
    fn a_loaded_piece_carries_the_node_beside_it() {
        let springs = Model::new(Beam::uniform(4.0, 1.0), Foundation::winkler(1.0))
            .with_hinge(Hinge::free(1.0))
            .with_hinge(Hinge::free(3.0));
        let verdict = |loads: &[Load]| {
            let mut model = springs.clone();
            model.loads = loads.to_vec();
            existence(&model).verdict
        };
        let middle = Load::uniform_force(1.0, 3.0, 1.0);
        for x in [1.0, 2.0, 3.0] {
            let both = verdict(&[middle, Load::point_force(x, 1.0)]);
            assert!(matches!(both, Verdict::NotUnique(m) if m.lifted == Some([0.0; 2])), "{x}");
        }
        // A force inside the middle piece presses this piece on the ground; a force over its end presses no
        // piece.
        assert!(matches!(verdict(&[Load::point_force(2.0, 1.0)]), Verdict::NotUnique(_)));
        assert!(matches!(verdict(&[Load::point_force(1.0, 1.0)]), Verdict::None(_)));
        assert!(matches!(verdict(&[Load::point_force(3.0, 1.0)]), Verdict::None(_)));
        // A piece that cannot rotate carries a force over its end with all of its springs.
        let model = springs.with_support(Support::spring(2.0, 0.0, 1.0));
        let stiff = existence(&model.with_load(Load::point_force(1.0, 1.0))).verdict;
        assert!(matches!(stiff, Verdict::NotUnique(_)));
    }
}
