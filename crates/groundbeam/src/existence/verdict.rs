//! The verdict on existence: whether an equilibrium exists and is unique, and the motion that decides it.

use crate::existence::rigid_motions::Mechanism;
use crate::model::Model;
use crate::numeric::tolerance::SUM_ROUNDING;

/// The verdict on the existence of an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// There is exactly one equilibrium.
    Unique,
    /// More than one equilibrium exists, because this rigid motion does not change the energy. Examples are a beam on a
    /// single point and a free piece beside a hinge.
    NotUnique(RigidMotion),
    /// No equilibrium exists. The loads do positive work in this rigid motion, or zero work if equilibrium needs a
    /// concentrated contact force that the ground cannot exert.
    None(RigidMotion),
    /// A stable equilibrium on the path that starts without compression. Without the ground, the beam would be
    /// unstable. Other equilibria are possible.
    Local(Local),
    /// The beam buckles: the path of stable equilibria from zero compression ends before the given compression is
    /// reached.
    Buckles(Buckling),
}

/// The stability of a local equilibrium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Local {
    /// Smallest ratio of the second variation of the energy to that without the axial force P. It is 1 + P/P_b for the
    /// buckling load P_b of the beam bonded to the ground in contact, and 0 at buckling.
    pub stability_margin: f64,
    /// The compression at which the path of stable equilibria ends, at constant loads \[N\].
    pub critical_compression: f64,
}

/// The buckling of the beam at the end of the path of stable equilibria.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Buckling {
    /// Lower bound of the compression at the end of the path of stable equilibria \[N\].
    pub critical_compression: f64,
    /// Position of the largest value of the buckling mode r \[m\].
    pub at: f64,
    /// Value r(0) of the buckling mode at the left end. The mode r is scaled to −1 (upward) at the position
    /// `at`.
    pub left: f64,
    /// Value r(l) of the buckling mode r at the right end. The mode is scaled as for `left`.
    pub right: f64,
    /// Work F(r) of the loads in the buckling mode r, per metre of uplift at the position `at` \[N·m per m\].
    pub work: f64,
}

impl Verdict {
    /// Whether an equilibrium can be computed. The equilibrium may be unique, one of several, or only a local minimum
    /// of the energy.
    pub fn stands(&self) -> bool {
        match self {
            Verdict::Unique | Verdict::NotUnique(_) | Verdict::Local(_) => true,
            Verdict::None(_) | Verdict::Buckles(_) => false,
        }
    }

    /// Returns the motion r that decides the verdict, as its end values r(0) and r(l) and the work F(r) of the
    /// loads \[N·m per m\].
    pub fn motion(&self) -> Option<[f64; 3]> {
        match self {
            Verdict::None(motion) | Verdict::NotUnique(motion) => {
                Some([motion.left, motion.right, motion.work])
            }
            Verdict::Buckles(mode) => Some([mode.left, mode.right, mode.work]),
            Verdict::Unique | Verdict::Local(_) => None,
        }
    }
}

/// A rigid motion of the beam with the downward displacement r(x), linear between free hinges and scaled to a largest
/// absolute value of one. It is upward (r ≤ 0), except in a rotation about the single point that holds the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RigidMotion {
    /// Displacement r(0) of the left end, positive down: 0 or −1. In a rotation about a single point, it lies between
    /// −1 and 0.
    pub left: f64,
    /// Displacement r(l) of the right end, positive down: 0 or −1. In a rotation about a single point, it lies between
    /// 0 and 1.
    pub right: f64,
    /// Work F(r) of the loads in the rigid motion r, per metre of its largest displacement \[N·m/m\].
    pub work: f64,
    /// Positions \[m\] of the first and the last of the ends and free hinges that rise (r = −1), with all between them.
    /// After a solve, they are the ends of the first piece that can move. `None` without free hinges.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub lifted: Option<[f64; 2]>,
}

impl RigidMotion {
    /// Returns the displacement r at the position `x`, positive down. `model` must be the model of this motion.
    ///
    /// ```
    /// use groundbeam::{Beam, Foundation, Hinge, Load, Model, Verdict, exists};
    ///
    /// let model = Model::new(Beam::uniform(4.0, 1.0), Foundation::winkler(1.0))
    ///     .with_hinge(Hinge::free(2.0))
    ///     .with_load(Load::point_force(1.0, 1.0))
    ///     .with_load(Load::point_force(3.0, -0.25))
    ///     .with_load(Load::point_force(2.0, 0.2));
    /// let Verdict::None(motion) = exists(&model)?.verdict else { panic!("it stands") };
    /// assert_eq!([0.0, 2.0, 3.0, 4.0].map(|x| motion.at(&model, x)), [0.0, 0.0, -0.5, -1.0]);
    /// # Ok::<(), groundbeam::Error>(())
    /// ```
    pub fn at(&self, model: &Model, x: f64) -> f64 {
        let nodes = Mechanism::of(model).nodes;
        let l = model.beam.length;
        let Some([from, to]) = self.lifted else {
            return (self.left * (l - x) + self.right * x) / l;
        };
        let value = |node: f64| if from <= node && node <= to { -1.0 } else { 0.0 };
        let after = nodes.partition_point(|node| *node <= x).clamp(1, nodes.len() - 1);
        let [a, b] = [nodes[after - 1], nodes[after]];
        (value(a) * (b - x) + value(b) * (x - a)) / (b - a)
    }
}

/// The verdict and the static reactions from which it follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Existence {
    /// Whether an equilibrium exists and is unique.
    pub verdict: Verdict,
    /// The static reactions R₀ and R_l, positive upward \[N\]. They are the reactions of supports under the
    /// beam's two ends if the beam is rigid and has no other support.
    pub static_reactions: [f64; 2],
}

impl Existence {
    /// The resultant of the loads, positive downward \[N\]. It is zero if it is within the rounding error of
    /// the static reactions.
    pub fn resultant(&self) -> f64 {
        let [left, right] = self.static_reactions;
        let total = left + right;
        if total.abs() <= SUM_ROUNDING * (left.abs() + right.abs()) { 0.0 } else { total }
    }

    /// The position of the resultant on a beam of length `l` \[m\]; `None` if the resultant is zero.
    pub fn resultant_position(&self, l: f64) -> Option<f64> {
        let total = self.resultant();
        (total != 0.0).then(|| l * (self.static_reactions[1] / total))
    }

    /// Returns the verdict after the solve. The equilibrium is not unique if the beam or one of its pieces can still
    /// move, for example if it rests on a single point.
    pub(crate) fn with_contact(self, model: &Model, contact: &[[f64; 2]]) -> Existence {
        let mechanism = Mechanism::of(model);
        // In a rigid motion of the beam, the two ends of a contact zone and the hinges inside it cannot move up or
        // down.
        let within = |&[from, to]: &[f64; 2]| {
            let nodes = mechanism.nodes.iter().copied();
            let inside: Vec<f64> = nodes.filter(|node| from < *node && *node < to).collect();
            [from, to].into_iter().chain(inside)
        };
        let points: Vec<f64> = contact.iter().flat_map(within).collect();
        let free = mechanism.first_free_piece(&points);
        let verdict = match (self.verdict, free, mechanism.point_held(&points)) {
            (Verdict::Unique, Some(_), Some(x)) if mechanism.nodes.len() == 2 => {
                let l = model.beam.length;
                let largest = x.max(l - x);
                let (left, right) = (-x / largest, (l - x) / largest);
                Verdict::NotUnique(RigidMotion { left, right, work: 0.0, lifted: None })
            }
            (Verdict::Unique, Some(piece), _) if mechanism.nodes.len() > 2 => {
                let lifted = Some(piece);
                Verdict::NotUnique(RigidMotion { left: 0.0, right: 0.0, work: 0.0, lifted })
            }
            (verdict, ..) => verdict,
        };
        Existence { verdict, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::existence::existence::existence;
    use crate::model::{Beam, Foundation, Hinge, Load, Support};

    fn beam() -> Model {
        Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
    }

    #[test]
    fn existence_and_motion_of_each_verdict() {
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
    fn a_motion_is_linear_between_ends_and_hinges() {
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

    /// For a force F at the distance a from the left end of a beam of length 4, the static reactions at the left and
    /// the right end are R₀ = F (1 − a/4) and R_l = F a/4.
    #[test]
    fn the_resultant_and_its_position_follow_from_the_static_reactions() {
        let found = existence(&beam().with_load(Load::point_force(1.0, 4.0)));
        assert_eq!(found.static_reactions, [3.0, 1.0]);
        assert_eq!((found.resultant(), found.resultant_position(4.0)), (4.0, Some(1.0)));
        // The resultant of a couple is zero and has no position.
        let couple = existence(&beam().with_load(Load::point_moment(1.0, 2.0)));
        assert_eq!(couple.static_reactions, [-0.5, 0.5]);
        assert_eq!((couple.resultant(), couple.resultant_position(4.0)), (0.0, None));
        // The resultant of two opposite forces counts as zero, even if the static reactions have rounding
        // errors.
        let beam = Model::new(Beam::uniform(1.0, 1.0), Foundation::winkler(1.0));
        let forces = [Load::point_force(0.1, 1.0), Load::point_force(0.3, -1.0)];
        let couple = existence(&Model { loads: forces.to_vec(), ..beam });
        assert_ne!(couple.static_reactions[0], -couple.static_reactions[1]);
        assert_eq!((couple.resultant(), couple.resultant_position(1.0)), (0.0, None));
    }

    fn with_contact(model: &Model, contact: &[[f64; 2]]) -> Verdict {
        let stands = Existence { verdict: Verdict::Unique, static_reactions: [1.0, 2.0] };
        let found = stands.with_contact(model, contact);
        assert_eq!(found.static_reactions, [1.0, 2.0]);
        found.verdict
    }

    #[test]
    fn a_beam_on_one_point_rotates_about_it() {
        let turns = |left: f64, right: f64| {
            Verdict::NotUnique(RigidMotion { left, right, work: 0.0, lifted: None })
        };
        let beam = beam();
        // The rotation is scaled so that the end farther from the contact point moves up or down by 1.
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
        // Without a contact point the verdict does not change.
        assert_eq!(with_contact(&beam, &[]), Verdict::Unique);
        // If no equilibrium exists, contact at one point does not change the verdict.
        let falls = existence(&beam.clone().with_load(Load::point_force(2.0, -1.0)));
        assert_eq!(falls.with_contact(&beam, &[[1.0; 2]]), falls);
    }

    #[test]
    fn an_unsupported_piece_is_a_mechanism() {
        let hinged = beam().with_hinge(Hinge::free(2.0));
        let mechanism = |from: f64, to: f64| {
            let lifted = Some([from, to]);
            Verdict::NotUnique(RigidMotion { left: 0.0, right: 0.0, work: 0.0, lifted })
        };
        assert_eq!(with_contact(&hinged, &[[0.5, 1.0]]), mechanism(2.0, 4.0));
        assert_eq!(with_contact(&hinged, &[[2.0, 3.0]]), mechanism(0.0, 2.0));
        assert_eq!(with_contact(&hinged, &[]), mechanism(0.0, 2.0));
        // Contact on both sides of the hinge restrains the hinge, and therefore both pieces.
        assert_eq!(with_contact(&hinged, &[[1.0, 3.0]]), Verdict::Unique);
        assert_eq!(with_contact(&hinged, &[[1.0, 2.0], [3.0; 2]]), Verdict::Unique);
    }
}
