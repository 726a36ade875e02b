//! The proof that comes with every solution, by code that shares nothing with the methods that find one.
//!
//! Given are a deflection w, a ground surface u, a pressure p with concentrated forces, and the supports'
//! reactions. Everything else is made anew from the model: shear and moment by integrating loads and
//! pressure from the left end, so that (m, s, p) is in equilibrium; the ground's forces from its equation
//! (2.2); the clearance from w and u. With these (Prager and Synge)
//!
//! gap = ½∫(EI (w″ − κ₀) + m)²/EI + ½ b(u − Gp, u − Gp) + ⟨p, u + g₀ − w⟩
//!
//! is the primal energy less the reciprocal energy, and half the squared error of (w, u) in the energy
//! norm, against the continuous problem, is at most this number. `docs/certificate.md` has the proof.

mod balance;
mod beam;
mod certificate;
mod claim;
mod curve;
mod ground;
mod hinges;
mod joints;
mod lift;
mod neighbours;
mod outside;
mod quadrature;
mod statics;
mod supports;
mod surface;
mod unclaimed;

use crate::certificate::claim::NEAR;
use crate::model::{Hinge, Load, Model};
use crate::numeric::polynomial::{jet, value};
use balance::{GivenBack, Remains, Segment};
use beam::{Sums, beam_piece, work_at_points};
pub use certificate::Certificate;
pub(crate) use claim::{Claim, ClaimedPiece};
use ground::GroundSums;
use hinges::Hinges;
use joints::Joints;
use outside::Outside;
use quadrature::Seen;
pub(crate) use quadrature::gauss;
use statics::{Events, SpreadLoad};
use supports::Supports;
use surface::Under;

/// The certificate of a claim. Nothing else makes one.
pub(crate) fn certify(model: &Model, claim: &Claim) -> Certificate {
    let mut walk = Walk::new(model, claim);
    for (i, piece) in claim.pieces.iter().enumerate() {
        walk.add(piece, claim.pieces.get(i + 1));
    }
    walk.finish();
    let [force_balance, moment_balance] = walk.events.balance();
    let (sums, ground, joints, events) = (&walk.sums, &walk.ground, &walk.joints, &walk.events);

    let inner = sums.axial + ground.energy + walk.supports.energy;
    let held = sums.axial.abs() + ground.energy + walk.supports.energy;
    let strain = 0.5 * (sums.bending + sums.curling + held);
    let norm = walk.norm(strain);
    let stability = claim.stability;
    let gap = 0.5 * norm * norm / stability + walk.work();

    // Loads that supports take without any strain, and supports that settle together, leave rounding alone, to
    // be judged by the energy that they would put into the ground and the beam.
    let (length, k, ei) =
        (model.beam.length, model.foundation.subgrade, model.beam.bending_stiffness);
    let wave = (4.0 * ei / k).sqrt().sqrt().min(length);
    let sunk = events.forces * (events.forces / (k * length));
    let turned = events.moments / length * (events.moments / (k * length * length));
    let moments = events.moments + events.forces * wave;
    let bent = moments * wave * (moments / ei);
    let settled = model.supports.iter().map(|s| s.settlement.abs()).fold(0.0, f64::max) / wave;
    let pushed = ei / wave * (settled * settled);
    let strain = strain + f64::EPSILON * (sunk + turned + bent + pushed);
    let moment_bound = (2.0 * gap / stability).sqrt() + joints.norm + ROUNDED * sums.moment.sqrt();
    let stiffest = model.beam.stiffest();
    Certificate {
        primal_energy: 0.5 * (sums.bending + inner) - sums.work - ground.work,
        dual_energy: sums.curled
            - 0.5 * (sums.moment + inner)
            - ground.work_on_gap
            - walk.supports.settled,
        gap,
        relative_gap: relative(gap, strain),
        force_balance,
        moment_balance,
        smallest_pressure: ground.smallest_pressure(events.forces),
        deepest_penetration: relative(ground.lifting.deepest, sums.largest_deflection),
        continuity: joints.continuity(model, sums.largest_deflection, sums.largest_slope),
        complementarity: relative(
            ground.worst_product,
            ground.largest_force * sums.largest_deflection,
        ),
        settlement_bound: settlement_bound(model, claim, gap / stability, ground, joints),
        moment_bound,
        moment_rms_bound: moment_bound * (stiffest / model.beam.length).sqrt(),
    }
}

/// Rounding of fields and of sums of squares, relative to their size.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

fn relative(x: f64, scale: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x / scale }
}

/// |u − u*|: of the surface that was moved, by how much it was moved, and rounding of u and of positions.
fn settlement_bound(
    model: &Model,
    claim: &Claim,
    gap: f64,
    ground: &GroundSums,
    joints: &Joints,
) -> f64 {
    let flexibility = outside::flexibility(model, &Outside::of(model, claim));
    if flexibility == f64::INFINITY {
        return flexibility;
    }
    let [u, slope] = ground.largest;
    let moved = ground.lifting.moved + joints.moved;
    let rounding = ROUNDED * (u + slope * model.beam.length);
    (2.0 * gap * flexibility).sqrt() + moved + rounding
}

/// The state of the walk along the beam.
struct Walk<'a> {
    model: &'a Model,
    claim: &'a Claim<'a>,
    sums: Sums,
    ground: GroundSums<'a>,
    joints: Joints,
    events: Events,
    supports: Supports<'a>,
    hinges: Hinges<'a>,
    /// The loads that are spread.
    spread: Vec<Load>,
    segment: Segment,
    given_back: GivenBack,
    /// The sum of all loads' sizes.
    loads: f64,
    /// ∫1/EI, ∫P w'², the pulls, the joints' moments and ∫1/S where the segment began.
    began: [f64; 5],
}

impl<'a> Walk<'a> {
    fn new(model: &'a Model, claim: &'a Claim<'a>) -> Self {
        let outside = Outside::of(model, claim);
        let mut walk = Walk {
            model,
            claim,
            sums: Sums::default(),
            ground: GroundSums::new(model, claim, &outside),
            joints: Joints::new(model, claim, &outside),
            events: Events::of(model, claim),
            supports: Supports::new(model, claim),
            hinges: Hinges::new(model),
            spread: statics::spread(model),
            segment: Segment::default(),
            given_back: GivenBack::new(outside::flexibility(model, &outside)),
            loads: statics::size(model),
            began: [0.0; 5],
        };
        walk.stop(0.0);
        walk
    }

    fn stop(&mut self, x: f64) {
        self.events.advance(x);
        self.supports.advance(x, self.claim, &mut self.segment.carriers);
        self.segment.to = x;
    }

    /// Over one piece, and what stands at its right end.
    fn add(&mut self, piece: &'a ClaimedPiece<'a>, next: Option<&ClaimedPiece>) {
        let model = self.model;
        let seen = Seen::of(piece.deflection, piece.rotation, piece.half);
        let load = SpreadLoad::on(&self.spread, piece.x);
        beam_piece(model, piece, &load, &seen, &mut self.events, &mut self.sums);
        let under = Under::new(model, piece, seen.ends);
        self.ground.add(under, &seen, &mut self.segment.carriers);
        self.joints.add(piece, seen.motion);
        self.stop(piece.x[1]);
        let Some(next) = next else { return };
        if let Some(hinge) = self.hinges.at(piece.x[1]) {
            // Nothing is known of w' at a hinge within a piece.
            if hinge.at < piece.x[1] - NEAR * self.model.beam.length {
                self.joints.misplaced = f64::INFINITY;
            }
            self.turn(hinge, seen.motion[1][1] / piece.half, next);
        }
        if self.hinges.none_is_free() {
            self.may_cut(&under, next);
        }
    }

    /// Over a hinge, with the slope before it. A spring in it is a flexibility of the beam in one point; at a free
    /// one no moment may be left, and what is left of it is given back.
    fn turn(&mut self, hinge: &Hinge, before: f64, next: &ClaimedPiece) {
        let [shear, moment] = self.events.inner();
        if hinge.is_free() {
            let remains = self.remains([shear, 0.0]);
            self.events.restart(hinge.at, &remains);
            let ended = self.end_segment(remains);
            self.hinges.pieces.push(ended);
            return;
        }
        let spring = hinge.rotational_spring;
        let after = match next.rotation {
            [] => jet(next.deflection, -1.0)[1] / next.half,
            rotation => value(rotation, -1.0),
        };
        let bend = spring * (after - before);
        let misfit = bend + moment;
        self.sums.bending += bend * bend / spring;
        self.sums.moment += moment * moment / spring;
        self.sums.misfit += misfit * misfit / spring;
        self.sums.flexibility += 1.0 / spring;
    }

    /// Where w tells shear and moment as well as equilibrium from the left does, they are taken from it.
    fn may_cut(&mut self, under: &Under, next: &ClaimedPiece) {
        let (x, beam) = (next.x[0], &self.model.beam);
        let course = beam.bending_stiffness_on(next.x);
        let [stiffness, rise] = course.rising_at(-1.0);
        let wave = (4.0 * stiffness / under.spring).sqrt().sqrt();
        let wave = wave.max(((under.shear + beam.axial_force.max(0.0)) / under.spring).sqrt());
        let ends_bare = next.open.is_none() && self.segment.is_bare();
        if !(ends_bare || self.segment.stands(wave)) {
            return;
        }
        let half = next.half;
        let [_, dw, mut ddw, mut third] = jet(next.deflection, -1.0);
        if !next.rotation.is_empty() {
            let [_, turned, bends, _] = jet(next.rotation, -1.0);
            (ddw, third) = (half * turned, half * bends);
        }
        let load = SpreadLoad::on(&self.spread, next.x);
        ddw -= load.curvature(-1.0) * half * half;
        third -= load.curvature[1] * half * half;
        let bend = stiffness * third + rise * ddw;
        let shear = (beam.axial_force * dw - bend / (half * half)) / half;
        let own = [shear - load.moment(-1.0), -stiffness * ddw / (half * half)];
        let remains = self.remains(own);
        if remains.force.abs() * wave + remains.moment.abs() <= ALIKE * self.loads * wave {
            self.events.restart(x, &remains);
            let ended = self.end_segment(remains);
            self.given_back.add(ended);
        }
    }

    fn remains(&self, own: [f64; 2]) -> Remains {
        let length = self.segment.to - self.segment.from;
        let axial = self.model.beam.axial_force * self.sums.largest_slope;
        self.events.remains(own, length, axial)
    }

    fn end_segment(&mut self, remains: Remains) -> Segment {
        let sums = &self.sums;
        let now = [
            sums.flexibility,
            sums.axial,
            self.ground.pull,
            self.joints.moment(),
            sums.shear_flexibility,
        ];
        let [flexibility, axial, pull, moment, shear_flexibility] =
            [0, 1, 2, 3, 4].map(|i| now[i] - self.began[i]);
        self.began = now;
        let x = self.segment.to;
        let mut ended = std::mem::take(&mut self.segment);
        (self.segment.from, self.segment.to) = (x, x);
        ended.moment = pull * (ended.to - ended.from) + moment;
        ended.remains = remains;
        ended.remains.force_noise += pull;
        ended.remains.moment_noise += ended.moment;
        (ended.flexibility, ended.axial) = (flexibility, axial.max(0.0));
        ended.shear_flexibility = shear_flexibility;
        ended.shear_softness = 1.0 / self.model.beam.softest_in_shear();
        ended.forces = ended.remains.force.abs() + ended.remains.force_noise;
        ended.tension = self.model.beam.axial_force.max(0.0);
        ended
    }

    fn finish(&mut self) {
        self.ground.finish(&mut self.segment.carriers);
        self.joints.finish(self.claim);
        work_at_points(self.model, self.claim, &mut self.sums);
        let remains = self.remains([0.0; 2]);
        let last = self.end_segment(remains);
        if self.hinges.none_is_free() {
            self.given_back.finish(last);
        } else {
            self.hinges.pieces.push(last);
            hinges::give(&self.hinges.pieces, &mut self.given_back);
        }
    }

    /// The norm of everything that is an error in the energies.
    fn norm(&self, strain: f64) -> f64 {
        if self.sums.too_long {
            return f64::INFINITY;
        }
        let [pressed, supports, bent] = self.given_back.norms();
        let ground = self.ground.misfit() + self.ground.lifting.norm() + pressed;
        let beam = self.sums.misfit.sqrt() + bent;
        let held = self.supports.misfit.sqrt() + supports;
        let rounding = ROUNDED * (2.0 * strain + self.sums.moment).sqrt();
        // Compression shears the deflections that close joints: |P| ∫z'²/S, and less |P| ∫z'² than z costs.
        let beam_model = &self.model.beam;
        let compressed = (-beam_model.axial_force).max(0.0) / beam_model.softest_in_shear();
        let joints = self.joints.norm * (1.0 + compressed.sqrt());
        (beam * beam + ground * ground + held * held).sqrt() + joints + rounding
    }

    /// What is no square: work of forces on a clearance.
    fn work(&self) -> f64 {
        // Nothing has a lever: what remains does work on a motion of the beam's own size.
        let lost = self.given_back.lost.map_or(0.0, |Remains { force, moment, .. }| {
            force.abs() * self.sums.largest_deflection + moment.abs() * self.sums.largest_slope
        });
        let clear = (1.0 + self.given_back.pressure) * self.ground.clear;
        clear + self.ground.lifting.work + 2.0 * lost
    }
}

/// How well shear and moment from w must agree with those from equilibrium to take their place.
const ALIKE: f64 = 1e-8;
