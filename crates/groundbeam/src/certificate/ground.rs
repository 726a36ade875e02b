//! The ground's part of the proof: its equation, its clearance, its energies.

use super::Claim;
use super::balance::{Carriers, Weights};
use super::curve::Polynomial;
use super::lift::{End, Lifting};
use super::neighbours::Neighbours;
use super::outside::Outside;
use super::quadrature::{Seen, at_points, gauss, larger, seen_bounds};
use super::surface::Under;
use super::unclaimed::Unclaimed;
use crate::model::Model;

/// Sums over the ground, piece by piece from the left.
#[derive(Debug)]
pub(super) struct GroundSums<'a> {
    forces: &'a [(f64, f64)],
    /// Concentrated forces used so far.
    used: usize,
    near: f64,
    /// The piece before: its ground, and μu', u + g₀ − w at its right end; how the next one begins.
    before: Option<Before<'a>>,
    begins: End,
    /// b(u, u).
    pub energy: f64,
    /// ⟨p, g₀⟩.
    pub work_on_gap: f64,
    /// ⟨p, u + g₀ − w⟩ where forces or pressures stand clear of the ground.
    pub clear: f64,
    /// The largest force × clearance.
    pub worst_product: f64,
    pub largest_force: f64,
    pub lifting: Lifting,
    /// Concentrated forces that the ground's equation demands but nobody claims,
    unclaimed: Unclaimed,
    /// and ∫r²/k of those that are spread.
    spread: f64,
    /// The total force that pulls, and the norm of what it does to the ground.
    pub pull: f64,
    pulled: f64,
    total_pressure: f64,
    largest_pressure: f64,
    smallest_pressure: f64,
    smallest_force: f64,
    /// The largest |u| and |u'|.
    pub largest: [f64; 2],
    /// A force where nothing can carry it.
    lost: bool,
    length: f64,
    /// The stiffness of the ground beyond the ends.
    outside: [f64; 2],
    /// What acts on the ground besides the beam, and its work.
    neighbours: Neighbours,
    pub work: f64,
}

#[derive(Debug, Clone, Copy)]
struct Before<'a> {
    under: Under<'a>,
    flux: f64,
    clearance: f64,
}

impl<'a> GroundSums<'a> {
    pub fn new(model: &Model, claim: &'a Claim, outside: &Outside) -> Self {
        GroundSums {
            forces: &claim.forces,
            used: 0,
            near: super::NEAR * model.beam.length,
            before: None,
            begins: End::Free { stiffness: 0.0, force: 0.0 },
            energy: 0.0,
            work_on_gap: 0.0,
            clear: 0.0,
            worst_product: 0.0,
            largest_force: claim.forces.iter().map(|f| f.1.abs()).fold(0.0, f64::max),
            lifting: Lifting::default(),
            unclaimed: Unclaimed::new(model, outside),
            outside: outside.stiffness,
            neighbours: Neighbours::of(model, outside),
            work: 0.0,
            spread: 0.0,
            pull: 0.0,
            pulled: 0.0,
            total_pressure: 0.0,
            largest_pressure: 0.0,
            smallest_pressure: 0.0,
            smallest_force: 0.0,
            largest: [0.0; 2],
            lost: false,
            length: model.beam.length,
        }
    }

    /// One piece more, with what is seen of w.
    pub fn add(&mut self, under: Under<'a>, seen: &Seen, carriers: &mut Carriers) {
        self.joint(Some(under), carriers);
        self.quadrature(&under, seen, carriers);
        let [u, du, clearance] = under.end(1.0);
        self.see(u, du);
        self.before = Some(Before { under, flux: under.flux(1.0, du), clearance });
    }

    /// The ground beyond the right end.
    pub fn finish(&mut self, carriers: &mut Carriers) {
        self.joint(None, carriers);
        self.lost |= self.used < self.forces.len();
    }

    fn see(&mut self, u: f64, du: f64) {
        self.largest = [larger(self.largest[0], u.abs()), larger(self.largest[1], du.abs())];
    }

    /// Between the piece before and the next one, or the ground beyond the beam's ends.
    fn joint(&mut self, next: Option<Under<'a>>, carriers: &mut Carriers) {
        let before = self.before.take();
        let x = match (&next, &before) {
            (Some(next), _) => next.from(),
            (None, _) => self.length,
        };
        let force = self.forces_at(x);
        let [u, du, clearance_right] = next.map_or([0.0; 3], |next| next.end(-1.0));
        self.see(u, du);
        if force > 0.0 {
            let left = before.as_ref().map_or(0.0, |before| before.under.end(1.0)[0]);
            carriers.press(Weights::point(x, force), [x, x], force * u.max(left));
        }
        let left_end = before.as_ref().map_or(0.0, |before| before.under.end(1.0)[0]);
        // The ground beyond begins with the value it has at the end.
        let (flux_left, flux_right) = match (&before, &next) {
            (Some(before), Some(next)) => (before.flux, next.flux(-1.0, du)),
            (None, Some(next)) => {
                let outside = self.outside[0];
                self.energy += outside * u * u;
                let push = self.neighbours.beside[0];
                self.work += push * u;
                (outside * u - push, next.flux(-1.0, du))
            }
            (Some(before), None) => {
                let [u, ..] = before.under.end(1.0);
                let outside = self.outside[1];
                self.energy += outside * u * u;
                let push = self.neighbours.beside[1];
                self.work += push * u;
                (before.flux, push - outside * u)
            }
            (None, None) => return,
        };
        let layer = |under: &&Under| under.shear > 0.0;
        let left = before.as_ref().map(|before| &before.under).filter(layer);
        let right = next.as_ref().filter(layer);
        // A force where a layer ends belongs to it.
        let neighbour = self.neighbours.force_at(x);
        self.work += neighbour * if next.is_some() { u } else { left_end };
        let rest = flux_left - flux_right - force.max(0.0) - neighbour;
        if left.is_some() {
            self.unclaimed.add(x, rest);
        }
        if let Some(next) = &next {
            self.unclaimed.enter(next.shear > 0.0, x);
        }
        if left.is_none() {
            self.unclaimed.add(x, rest);
        }
        let sides = [(left, before.map_or(0.0, |b| b.clearance)), (right, clearance_right)];
        self.lost |= force != 0.0 && left.is_none() && right.is_none();
        let gap = next.as_ref().map_or_else(
            || before.as_ref().map_or(0.0, |before| before.under.gap(1.0)),
            |next| next.gap(-1.0),
        );
        self.work_on_gap += force * gap;
        let at_end = before.is_none() || next.is_none();
        let [ends, begins] = self.ends(force, sides, at_end);
        if let Some(before) = &before {
            self.lifting.add(&before.under, [self.begins, ends]);
        }
        self.begins = begins;
    }

    /// How open ground is held on both sides of a joint; without a layer a side is none.
    fn ends(&mut self, force: f64, sides: [(Option<&Under>, f64); 2], at_end: bool) -> [End; 2] {
        let touches = sides.iter().any(|side| side.0.is_some_and(|under| !under.is_open()));
        let clearances = sides.map(|(under, c)| if under.is_some() { c } else { 0.0 });
        let clearance = if touches { 0.0 } else { clearances[0].max(clearances[1]) };
        if !touches {
            self.worst_product = self.worst_product.max((force * clearance).abs());
        }
        // A force that stands clear of the ground does work on the clearance, or the ground is moved up to
        // it, whichever costs less.
        let stiffness: f64 = sides
            .iter()
            .filter_map(|side| side.0)
            .map(|under| under.bounds()[2] / under.half)
            .sum();
        let clear = !touches && clearance > 0.0 && force <= clearance * stiffness;
        if clear && force > 0.0 {
            self.clear += force * clearance;
        }
        let held = touches || (force > 0.0 && !clear);
        let force = if clear { force.max(0.0) } else { 0.0 };
        let none = End::Free { stiffness: 0.0, force: 0.0 };
        match sides.map(|side| side.0) {
            [left, right] if held => {
                [left, right].map(|side| if side.is_some() { End::Edge } else { none })
            }
            [Some(_), Some(_)] => {
                let jump = (clearances[1] - clearances[0]).abs();
                [End::Open { jump, force }, End::Open { jump, force: 0.0 }]
            }
            [left, right] => {
                [(left, self.outside[1]), (right, self.outside[0])].map(|side| match side {
                    (Some(_), stiffness) if at_end => End::Free { stiffness, force },
                    (Some(_), _) => End::Free { stiffness: 0.0, force },
                    (None, _) => none,
                })
            }
        }
    }

    /// The sum of the forces at a position.
    fn forces_at(&mut self, x: f64) -> f64 {
        let mut sum = 0.0;
        while let Some(&(at, force)) = self.forces.get(self.used) {
            if at > x + self.near {
                break;
            }
            self.lost |= at < x - self.near;
            self.used += 1;
            self.total_pressure += force.max(0.0);
            self.smallest_force = self.smallest_force.min(force);
            sum += force;
        }
        self.pull += (-sum).max(0.0);
        sum
    }

    fn quadrature(&mut self, under: &Under, seen: &Seen, carriers: &mut Carriers) {
        let half = under.half;
        let piece = under.piece;
        let open = under.is_open();
        let energy = under.energy();
        self.energy += energy.unwrap_or(0.0);
        if energy.is_some() && piece.pressure.is_empty() && !under.is_loaded() {
            return;
        }
        let bend = 1.0 / (half * half);
        let [mut mass, mut first, mut second, mut sunk] = [0.0; 4];
        let pressure = at_points(piece.pressure);
        for (i, (s, weight)) in gauss().enumerate() {
            let dx = weight * half;
            let (w, dw, p) = (seen.deflection[i], seen.slope[i], pressure[i]);
            let [u, du] = under.surface(s, w, dw);
            let [k, mu, rise] = under.constants(s);
            if energy.is_none() {
                self.energy += dx * (k * u * u + mu * du * du);
                self.see(u, du);
            }
            let rest = if open {
                self.clear += dx * (p * (u + under.gap(s) - w)).abs();
                under.residual(s) - p
            } else {
                k * u - mu * (seen.bend[i] * bend) - rise * du - p - under.load(s)
            };
            self.work += dx * under.load(s) * u;
            self.spread += dx * rest * rest / k;
            self.work_on_gap += dx * p * under.gap(s);
            self.total_pressure += dx * larger(0.0, p);
            let share = dx * p;
            mass += share;
            first += share * s;
            second += share * s * s;
            sunk += share * u;
        }
        if mass > 0.0 {
            let centre = first / mass;
            let [from, to] = piece.x;
            let weights = Weights {
                sum: mass,
                centre: 0.5 * (from + to) + half * centre,
                spread: half * half * (second - first * centre).max(0.0),
            };
            carriers.press(weights, piece.x, sunk);
        }
        let pull = Polynomial::depth(piece.pressure);
        if pull > 0.0 {
            self.pull += pull * 2.0 * half;
            self.pulled += pull * (2.0 * half / under.bounds()[0]).sqrt();
        }
        let [low, high] = seen_bounds(piece.pressure, &pressure);
        self.smallest_pressure = self.smallest_pressure.min(low);
        self.largest_pressure = self.largest_pressure.max(high);
    }

    /// ‖u − Gp‖ in the norm of b, of p without what pulls, before anything is moved.
    pub fn misfit(&self) -> f64 {
        if self.lost {
            return f64::INFINITY;
        }
        self.unclaimed.norm() + self.spread.sqrt() + self.pulled
    }

    /// The smallest pressure or concentrated force, relative to the largest or to all forces' sizes.
    pub fn smallest_pressure(&self, forces: f64) -> f64 {
        let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x / scale };
        let spread =
            relative(self.smallest_pressure, self.largest_pressure.max(forces / self.length));
        spread.min(relative(self.smallest_force, self.total_pressure.max(forces)))
    }
}
