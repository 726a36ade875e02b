//! Decides, from the ground under the loads, whether an equilibrium exists if a piece of the beam can be lifted without work.

use crate::existence::rigid_motions::Mechanism;
use crate::existence::statics::static_reactions;
use crate::existence::verdict::{RigidMotion, Verdict};
use crate::model::{Model, Support};
use crate::numeric::sum::Sum;
use std::ops::Range;

/// Returns the verdict for a beam with a piece that can lift off while the loads do no work. Such a piece does not
/// press on the ground. A loaded node between such pieces needs a shear layer or a bearing.
pub(super) fn balanced_without_a_layer(model: &Model, motion: RigidMotion) -> Verdict {
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
    use crate::existence::existence::existence;
    use crate::model::{Acts, Beam, Foundation, Hinge, Load};
    use crate::numeric::elementary::power;

    #[test]
    fn the_rotation_of_an_unloaded_piece_is_not_unique() {
        let half = |ground| {
            Model::new(Beam::uniform(4.0, 1.0), ground)
                .with_hinge(Hinge::free(2.0))
                .with_load(Load::uniform_force(0.0, 2.0, 1.0))
        };
        let springs = existence(&half(Foundation::winkler(1.0))).verdict;
        assert!(matches!(springs, Verdict::NotUnique(m) if m.lifted == Some([4.0, 4.0])));
        // The whole load is a force over the hinge. Only a shear layer carries a concentrated force.
        let over = |ground| {
            let mut model = half(ground);
            model.loads = vec![Load::point_force(2.0, 1.0)];
            existence(&model).verdict
        };
        assert!(matches!(over(Foundation::pasternak(1.0, 1.0)), Verdict::NotUnique(_)));
        assert!(matches!(over(Foundation::winkler(1.0)), Verdict::None(m) if m.work == 0.0));
    }

    /// On Winkler ground, a beam under a single force at an end or a hinge sinks without limit. A shear layer at this
    /// position carries the force. The result does not depend on the unit of length.
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
                // The shear layer exists only along the segment, or only outside the segment.
                for (shear, carried) in [([1.0, 0.0], layered), ([0.0, 1.0], bare)] {
                    let verdict = existence(&over(unit, x, shear, segment)).verdict;
                    let stands = matches!(verdict, Verdict::NotUnique(_));
                    assert_eq!(stands, carried, "{x} {segment:?} {shear:?} {verdict:?}");
                    assert_eq!(verdict.stands(), carried);
                }
            }
        }
    }

    /// A support that only pushes up balances a force directly above it. Positions that differ by at most 4 ε l
    /// count as equal, with the machine epsilon ε and the beam length l.
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

    /// A piece under a distributed load presses on the ground. The ground reaction under this piece can also
    /// balance a point force at a node of the piece, so an equilibrium exists.
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
        // A force inside the middle piece presses it onto the ground. A force at its end presses no piece onto the
        // ground, so no equilibrium exists.
        assert!(matches!(verdict(&[Load::point_force(2.0, 1.0)]), Verdict::NotUnique(_)));
        assert!(matches!(verdict(&[Load::point_force(1.0, 1.0)]), Verdict::None(_)));
        assert!(matches!(verdict(&[Load::point_force(3.0, 1.0)]), Verdict::None(_)));
        // If the middle piece cannot rotate, all ground springs under this piece together balance a force at
        // its end.
        let model = springs.with_support(Support::spring(2.0, 0.0, 1.0));
        let stiff = existence(&model.with_load(Load::point_force(1.0, 1.0))).verdict;
        assert!(matches!(stiff, Verdict::NotUnique(_)));
    }
}
