//! Computes, from the static reactions, the work of the loads in the extreme rigid motions that lift the beam off the ground.
//!
//! Every free rigid motion is a sum of positive multiples of the extreme motions.

use crate::existence::rigid_motions::Mechanism;
use crate::existence::statics::static_reactions;
use crate::existence::verdict::RigidMotion;
use crate::model::Model;
use crate::numeric::sum::Sum;
use std::ops::Range;

/// Returns the position \[m\] and the size \[N\], positive upward, of each static reaction. The static reactions are
/// the support forces of a chain of rigid beams with supports only at its ends and at its free hinges.
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

/// Returns the extreme rays of the cone of free rigid motions. The number before each motion is minus the work of the
/// loads in this motion.
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

/// Returns the sum of the absolute values of all contributions of the loads to the static reactions \[N\].
pub(crate) fn size_of_loads(model: &Model) -> f64 {
    static_reactions(&model.loads, &Mechanism::of(model).nodes).iter().map(|sum| sum.size).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Hinge, Load, Support};

    fn beam() -> Model {
        Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
    }

    /// On a rigid piece from a to b, a force F at x gives the reaction F (b − x)/(b − a) at a. A moment M
    /// gives −M/(b − a) at a and M/(b − a) at b.
    #[test]
    fn each_end_and_hinge_has_its_static_reaction() {
        let hinged = beam().with_hinge(Hinge::free(2.0));
        let loaded =
            hinged.with_load(Load::point_force(3.5, 1.0)).with_load(Load::point_moment(1.0, -3.0));
        assert_eq!(static_reactions_of(&loaded), [(0.0, 1.5), (2.0, -1.25), (4.0, 0.75)]);
        // The size is the sum of the absolute contributions of all loads to the static reactions. The force
        // contributes 0.25 + 0.75, and the moment contributes 3/2 + 3/2.
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
}
