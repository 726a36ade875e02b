//! What holds the beam besides the ground, from left to right.
//!
//! A support that acts in one direction alone is in equilibrium with a reaction R ≥ 0 that way only, and admits a
//! deflection that keeps clear of it or presses its spring.

use super::Claim;
use super::balance::{Carriers, Weights};
use crate::model::{Model, Support, SupportKind};

/// The share of all forces that a spring is taken to be able to carry, whatever it does carry.
const LEAST: f64 = 1e-3;

pub(super) struct Supports<'a> {
    /// With the claimed force and moment, from right to left; the next one is the last.
    ahead: Vec<(&'a Support, f64, f64)>,
    near: f64,
    length: f64,
    /// The sum of all concentrated forces: no rigid support weighs less.
    all: f64,
    /// Σ R δ: the work of the reactions on the settlements.
    pub settled: f64,
    /// The springs' energies, twice, and those of what they miss of their own laws.
    pub energy: f64,
    pub misfit: f64,
}

impl<'a> Supports<'a> {
    pub fn new(model: &'a Model, claim: &Claim) -> Self {
        let claimed = |i: usize| claim.reactions.get(i).map_or((0.0, 0.0), |r| (r.1, r.2));
        let supports = model.supports.iter().enumerate();
        let mut ahead: Vec<_> = supports
            .map(|(i, support)| {
                let (force, moment) = claimed(i);
                (support, force, moment)
            })
            .collect();
        ahead.sort_by(|a, b| b.0.at.total_cmp(&a.0.at));
        let length = model.beam.length;
        let forces = claim.forces.iter().map(|f| f.1.abs());
        let reactions = claim.reactions.iter().map(|r| r.1.abs() + r.2.abs() / length);
        let all = forces.chain(reactions).sum();
        let near = super::NEAR * length;
        Supports { ahead, near, length, all, settled: 0.0, energy: 0.0, misfit: 0.0 }
    }

    /// Those up to and at x.
    pub fn advance(&mut self, x: f64, claim: &Claim, carriers: &mut Carriers) {
        let missed = |by: f64, spring: f64| if by == 0.0 { 0.0 } else { by * by / spring };
        let near = self.near;
        while let Some((support, force, moment)) =
            self.ahead.pop_if(|(support, ..)| support.at <= x + near)
        {
            self.settled += force * support.settlement;
            if support.is_one_way() {
                self.one_way(support, force, claim, carriers);
                continue;
            }
            match support.kind {
                SupportKind::Spring { spring, rotational_spring } => {
                    let [w, slope] = claim.deflection(support.at);
                    let w = w - support.settlement;
                    self.energy += spring * w * w + rotational_spring * slope * slope;
                    self.misfit += missed(spring * w - force, spring)
                        + missed(rotational_spring * slope + moment, rotational_spring);
                    // A spring that happens to carry nothing still can.
                    let able = |claimed: f64, stiffness: f64, least: f64| {
                        if stiffness > 0.0 { claimed.abs().max(least) } else { claimed.abs() }
                    };
                    let force = able(force, spring, LEAST * self.all);
                    let moment = able(moment, rotational_spring, LEAST * self.all * self.length);
                    carriers.stored += missed(force, spring) + missed(moment, rotational_spring);
                    carriers.supports.add(Weights::point(support.at, force));
                    carriers.turning += moment * self.length;
                }
                SupportKind::Pinned => carriers.supports.add(Weights::point(support.at, self.all)),
                SupportKind::Fixed => {
                    carriers.supports.add(Weights::point(support.at, self.all));
                    carriers.turning += self.all * self.length * self.length;
                }
            }
        }
    }

    /// Rigid, it must touch where it acts (`joints.rs` closes what it misses), and then does no work. Elastic, it costs
    /// no more than a spring that acts both ways, which is what is taken where it acts.
    fn one_way(&mut self, support: &Support, force: f64, claim: &Claim, carriers: &mut Carriers) {
        let w = claim.deflection(support.at)[0] - support.settlement;
        let sign = support.acts.sign();
        let reaction = sign * force;
        if reaction < 0.0 {
            self.misfit = f64::INFINITY;
        }
        if let SupportKind::Spring { spring, .. } = support.kind
            && spring > 0.0
        {
            let pressed = if reaction > 0.0 { sign * w } else { (sign * w).max(0.0) };
            let missed = spring * pressed - reaction;
            self.energy += spring * pressed * pressed;
            self.misfit += missed * missed / spring;
            carriers.stored += reaction * reaction / spring;
        }
        // It can carry more or less only as long as it acts.
        carriers.supports.add(Weights::point(support.at, reaction));
    }
}
