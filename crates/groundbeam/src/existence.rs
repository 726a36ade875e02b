//! Whether an equilibrium exists, before anything is solved. Section 4, sharpened.
//!
//! The energy is coercive, and so has a least value, exactly if every rigid motion r = a x + b ≤ 0 of the
//! beam that presses nowhere on the ground, that the supports allow and the tension does not resist, costs
//! work: F(r) < 0. For a free beam without tension these are all r with r(0) ≤ 0 and r(l) ≤ 0, and since
//! F(r) = R₀ r(0) + R_l r(l) with the *static reactions* R₀ and R_l of the loads, both must be positive:
//! that is (4.24)/(4.25), necessary as well as sufficient. Tension resists rotation, supports resist more;
//! both shrink the set of free motions.

use crate::model::{Load, Model, SupportKind};
use crate::solution::ContactRegion;

/// What the statics say about equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Verdict {
    /// There is exactly one equilibrium.
    #[default]
    Unique,
    /// A static reaction is zero, or the beam stands on one point alone: equilibria may exist, and then not
    /// one alone. The motion changes no energy.
    NotUnique(RigidMotion),
    /// There is none: the motion never presses on the ground and the loads gain work in it.
    None(RigidMotion),
    /// Compression that the ground helps to bear: there is a stable equilibrium next to the unloaded state, on
    /// the branch that begins without compression. It is a local one: others, far from it, are not ruled out.
    Local(Local),
    /// The branch of stable equilibria that begins without compression ends before the compression is
    /// reached: the beam buckles.
    Buckles(Buckling),
}

/// How firmly a local equilibrium stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Local {
    /// The smallest eigenvalue of the second variation ∫(EI z″² + P z'²) + springs + ground where it touches,
    /// measured by the same without P: between 0, where the beam buckles, and 1, without compression.
    /// It is 1 + P/P_b with the buckling load P_b of the beam glued to the ground where it touches.
    pub stability_margin: f64,
    /// The compression at which the branch of stable equilibria ends as it grows, the loads staying as they
    /// are \[N\].
    pub critical_compression: f64,
}

/// Where the branch of stable equilibria ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Buckling {
    /// The compression at which it ends, from below \[N\].
    pub critical_compression: f64,
    /// Where the buckling mode r is largest \[m\].
    pub at: f64,
    /// r(0), for r(`at`) = −1: up.
    pub left: f64,
    /// r(l).
    pub right: f64,
    /// F(r), the work of the loads in it \[N·m per m\].
    pub work: f64,
}

impl Verdict {
    /// Whether there is an equilibrium to be found: the only one, one of many, or a local one.
    pub fn stands(&self) -> bool {
        match self {
            Verdict::Unique | Verdict::NotUnique(_) | Verdict::Local(_) => true,
            Verdict::None(_) | Verdict::Buckles(_) => false,
        }
    }
}

/// A rigid motion of the beam, r(x) = a x + b, scaled to a largest size of 1. It presses nowhere: r ≤ 0,
/// unless the beam stands on one point inside and turns about it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidMotion {
    /// r(0): 0 or −1; about a point inside, between −1 and 0.
    pub left: f64,
    /// r(l): 0 or −1; about a point inside, between 0 and 1.
    pub right: f64,
    /// F(r), the work of the loads in it \[N·m per m of lift\].
    pub work: f64,
}

/// The verdict and the statics it rests on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Existence {
    /// Whether an equilibrium exists, and is the only one.
    pub verdict: Verdict,
    /// R₀ and R_l: what supports under the beam's two ends would carry if the beam were rigid and stood on
    /// them alone, up positive \[N\].
    pub static_reactions: [f64; 2],
}

impl Existence {
    /// The loads' resultant, down positive \[N\].
    pub fn resultant(&self) -> f64 {
        self.static_reactions[0] + self.static_reactions[1]
    }

    /// Where the resultant acts on a beam of length `l` \[m\]; none if it is zero.
    pub fn resultant_position(&self, l: f64) -> Option<f64> {
        let total = self.resultant();
        (total != 0.0).then(|| l * (self.static_reactions[1] / total))
    }

    /// The same once the contact is known: a beam that stands on a single point inside, and that neither
    /// tension nor a support keeps from turning there, has more than one equilibrium.
    pub(crate) fn with_contact(self, model: &Model, contact: &[ContactRegion]) -> Existence {
        let (mut points, turning) = hold(model);
        points.extend(contact.iter().flat_map(|region| [region.from, region.to]));
        let l = model.beam.length;
        let verdict = match (self.verdict, points.first()) {
            (Verdict::Unique, Some(&x)) if turning && points.iter().all(|point| *point == x) => {
                let largest = x.max(l - x);
                let (left, right) = (-x / largest, (l - x) / largest);
                Verdict::NotUnique(RigidMotion { left, right, work: 0.0 })
            }
            (verdict, _) => verdict,
        };
        Existence { verdict, ..self }
    }
}

/// The verdict for a valid model with P ≥ 0, or whose energy is convex in spite of compression.
pub fn existence(model: &Model) -> Existence {
    let reactions = static_reactions(&model.loads, model.beam.length);
    let free = free_motions(model);
    let verdict = judge(&rays_of(free, reactions));
    let static_reactions = reactions.map(|reaction| reaction.sum);
    let resultant = static_reactions[0] + static_reactions[1];
    let verdict = match free {
        Free::RisingAndTurning => balanced_on_an_end(model, verdict, resultant),
        _ => verdict,
    };
    Existence { verdict, static_reactions }
}

/// The extreme rays of the cone of free motions, each with the work −F(r) it costs: linear in the loads.
/// Which rays there are does not depend on the loads.
pub(crate) fn rays(model: &Model) -> Vec<(Sum, RigidMotion)> {
    rays_of(free_motions(model), static_reactions(&model.loads, model.beam.length))
}

fn rays_of(free: Free, [left, right]: [Sum; 2]) -> Vec<(Sum, RigidMotion)> {
    let ray =
        |l: f64, r: f64, cost: Sum| (cost, RigidMotion { left: l, right: r, work: -cost.sum });
    match free {
        Free::Nothing => Vec::new(),
        Free::Turning(About::LeftEnd) => vec![ray(0.0, -1.0, right)],
        Free::Turning(About::RightEnd) => vec![ray(-1.0, 0.0, left)],
        Free::Rising => vec![ray(-1.0, -1.0, left.plus(right))],
        Free::RisingAndTurning => vec![ray(-1.0, 0.0, left), ray(0.0, -1.0, right)],
    }
}

/// What the cost of the extreme rays says.
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

/// A resultant exactly over an end must be carried by a concentrated force there. Only a shear layer has
/// one; on separate springs the beam would sink and turn without end.
fn balanced_on_an_end(model: &Model, verdict: Verdict, resultant: f64) -> Verdict {
    let Verdict::NotUnique(motion) = verdict else { return verdict };
    let l = model.beam.length;
    let end = if motion.left == 0.0 { f64::MIN_POSITIVE } else { l * (1.0 - f64::EPSILON) };
    if resultant != 0.0 && model.foundation.constants_at(end).1 == 0.0 {
        return Verdict::None(motion);
    }
    verdict
}

/// The rigid motions r ≤ 0 that neither supports nor tension resist.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Free {
    Nothing,
    Turning(About),
    Rising,
    RisingAndTurning,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum About {
    LeftEnd,
    RightEnd,
}

fn free_motions(model: &Model) -> Free {
    let (held, turning) = hold(model);
    match (held.as_slice(), turning) {
        ([], true) => Free::RisingAndTurning,
        ([], false) => Free::Rising,
        ([x], true) if *x == 0.0 => Free::Turning(About::LeftEnd),
        ([x], true) if *x == model.beam.length => Free::Turning(About::RightEnd),
        // Turning about a point inside the beam presses one side into the ground.
        _ => Free::Nothing,
    }
}

/// Where supports hold the beam, and whether it may turn.
fn hold(model: &Model) -> (Vec<f64>, bool) {
    let mut held: Vec<f64> = Vec::new();
    let mut turning = model.beam.axial_force == 0.0;
    for support in &model.supports {
        let (holds, stops_turning) = match support.kind {
            SupportKind::Pinned => (true, false),
            SupportKind::Fixed => (true, true),
            SupportKind::Spring { spring, rotational_spring } => {
                (spring > 0.0, rotational_spring > 0.0)
            }
        };
        if holds && !held.contains(&support.at) {
            held.push(support.at);
        }
        turning &= !stops_turning;
    }
    (held, turning)
}

/// Whether supports leave no rigid motion at all, pressing on the ground or not: what a beam in
/// compression needs.
pub(crate) fn held_rigidly(model: &Model) -> bool {
    let holds = |kind: SupportKind| match kind {
        SupportKind::Pinned => [true, false],
        SupportKind::Fixed => [true, true],
        SupportKind::Spring { spring, rotational_spring } => {
            [spring > 0.0, rotational_spring > 0.0]
        }
    };
    let places = model.supports.iter().filter(|s| holds(s.kind)[0]).count();
    let turns = model.supports.iter().any(|s| holds(s.kind)[1]);
    places >= 2 || (places == 1 && turns)
}

/// A sum with the size of what was added, so that zero can be told from rounding.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    pub sum: f64,
    compensation: f64,
    size: f64,
}

impl Sum {
    fn add(&mut self, term: f64) {
        // Neumaier's summation: the sum of the given numbers is right to the last bit or two.
        let sum = self.sum + term;
        self.compensation += if self.sum.abs() >= term.abs() {
            (self.sum - sum) + term
        } else {
            (term - sum) + self.sum
        };
        self.sum = sum;
        self.size += term.abs();
    }

    fn finished(mut self) -> Self {
        self.sum += self.compensation;
        self.compensation = 0.0;
        if self.is_zero() {
            self.sum = 0.0;
        }
        self
    }

    fn plus(self, other: Sum) -> Sum {
        Sum { sum: self.sum + other.sum, compensation: 0.0, size: self.size + other.size }
    }

    pub fn is_zero(&self) -> bool {
        self.sum.abs() <= 8.0 * f64::EPSILON * self.size
    }

    pub fn is_negative(&self) -> bool {
        self.sum < 0.0 && !self.is_zero()
    }
}

/// R₀ = F(1 − x/l) and R_l = F(x/l).
pub(crate) fn static_reactions(loads: &[Load], l: f64) -> [Sum; 2] {
    let (mut left, mut right) = (Sum::default(), Sum::default());
    let mut force_at = |force: f64, x: f64| {
        left.add(force * ((l - x) / l));
        right.add(force * (x / l));
    };
    let mut moments = Vec::new();
    for load in loads {
        match *load {
            Load::PointForce { at, force } => force_at(force, at),
            Load::PointMoment { moment, .. } => moments.push(moment),
            Load::Distributed { from, to, start, end } => {
                // Two triangles, each at its own third.
                let length = to - from;
                force_at(0.5 * start * length, from + length / 3.0);
                force_at(0.5 * end * length, to - length / 3.0);
            }
            Load::DistributedMoment { from, to, start, end } => {
                moments.push(0.5 * (start + end) * (to - from));
            }
        }
    }
    for moment in moments {
        left.add(-moment / l);
        right.add(moment / l);
    }
    [left.finished(), right.finished()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Beam, Foundation, Support};

    fn beam() -> Model {
        Model::new(Beam::uniform(4.0, 1.0), Foundation::pasternak(1.0, 1.0))
    }

    fn exists(model: &Model) -> bool {
        !matches!(existence(model).verdict, Verdict::None(_))
    }

    #[test]
    fn kikuchi_5_21() {
        // ½ f₀ l > M₀ > −½ f₀ l.
        let case = |m| beam().with_load(Load::point(1.0, 2.0)).with_load(Load::moment(m, 2.0));
        assert!(exists(&case(1.99)) && exists(&case(-1.99)));
        assert!(!exists(&case(2.01)) && !exists(&case(-2.01)));
        assert!(matches!(existence(&case(2.0)).verdict, Verdict::NotUnique(m) if m.left == -1.0));
        let Verdict::None(motion) = existence(&case(3.0)).verdict else { panic!() };
        assert_eq!((motion.left, motion.right, motion.work), (-1.0, 0.0, 0.25));
    }

    #[test]
    fn kikuchi_figure_2() {
        // (a) an even load f₀ on a stretch of length a about the middle and a moment 2M₀ in all.
        let (f0, a, l) = (3.0, 2.0, 4.0);
        for m0 in [2.9, 3.1] {
            let model = beam()
                .with_load(Load::uniform(f0, 1.0, 3.0))
                .with_load(Load::moment(m0, 1.0))
                .with_load(Load::moment(m0, 3.0));
            let condition =
                f0 * a > 0.5 * f0 * a + 2.0 * m0 / l && 0.5 * f0 * a + 2.0 * m0 / l > 0.0;
            assert_eq!(exists(&model), condition, "(a) {m0}");
        }
        // (b) the load on [0, a] and one moment M₀.
        for m0 in [-7.0, -5.0, 17.0, 19.0] {
            let model =
                beam().with_load(Load::uniform(f0, 0.0, a)).with_load(Load::moment(m0, 3.0));
            let middle = a / (2.0 * l) * f0 * a + m0 / l;
            assert_eq!(exists(&model), f0 * a > middle && middle > 0.0, "(b) {m0}");
        }
        // (c) f₁ at the left end, f₂ upward a moment −f₂ a, f₃ at the right end.
        for (f2, f3) in [(1.0, 0.3), (1.0, 0.2), (-1.0, 0.1)] {
            let (f1, a) = (2.0, 1.0);
            let model = beam()
                .with_load(Load::point(f1, 0.0))
                .with_load(Load::point(f2, 0.0))
                .with_load(Load::moment(-f2 * a, 0.0))
                .with_load(Load::point(f3, l));
            let middle = (-f2 * a + f3 * l) / l;
            assert_eq!(exists(&model), f1 + f2 + f3 > middle && middle > 0.0, "(c) {f2} {f3}");
        }
    }

    #[test]
    fn tension_and_supports_shrink_the_free_motions() {
        let outside = beam().with_load(Load::point(1.0, 2.0)).with_load(Load::moment(2.8, 2.0));
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

    #[test]
    fn a_lifting_resultant_is_refused_even_under_tension() {
        let mut model = beam().with_load(Load::point(-1.0, 2.0));
        model.beam.axial_force = 5.0;
        let Verdict::None(motion) = existence(&model).verdict else { panic!() };
        assert_eq!((motion.left, motion.right, motion.work), (-1.0, -1.0, 1.0));
    }
}
