//! The proof that comes with every solution, by code that shares nothing with the methods that find one.
//!
//! Given are a deflection w, a ground surface u, a pressure p with concentrated forces, and the supports'
//! reactions. Everything else is made anew from the model: shear and moment by integrating loads and
//! pressure from the left end, so that (m, s, p) is in equilibrium; the ground's forces from its equation
//! (2.2); the clearance from w and u. With these (Prager and Synge)
//!
//! gap = ½∫(EI w″ + m)²/EI + ½ b(u − Gp, u − Gp) + ⟨p, u + g₀ − w⟩
//!
//! is the primal energy less the reciprocal energy, and half the squared error of (w, u) in the energy
//! norm, against the continuous problem, is at most this number. `docs/certificate.md` has the proof.

mod ground;
mod statics;

use crate::model::{Model, SupportKind};
use crate::polynomial::{jet, value};
use ground::GroundSums;
use statics::{Events, SpreadLoad};

/// The proof of a solution.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Certificate {
    /// ½∫(EI w″² + P w'²) + ½b(u, u) − F(w): (3.8) and the ground's own energy \[N·m\].
    pub primal_energy: f64,
    /// The reciprocal energy −½∫m²/EI − ½∫P w'² − ½⟨p, Gp⟩ − ⟨p, g₀⟩ \[N·m\].
    pub dual_energy: f64,
    /// Primal less dual energy, summed from parts none of which can be negative \[N·m\].
    pub gap: f64,
    /// `gap` relative to the strain energy of beam, ground and springs.
    pub relative_gap: f64,
    /// |ΣF| relative to the sum of all forces' sizes.
    pub force_balance: f64,
    /// |ΣM| relative to the sum of all moments' sizes.
    pub moment_balance: f64,
    /// The smallest contact pressure relative to the largest; negative would be a pull.
    pub smallest_pressure: f64,
    /// The deepest interpenetration w − u − g₀, relative to the largest deflection.
    pub deepest_penetration: f64,
    /// The largest |p (u + g₀ − w)| of a concentrated force, relative to largest force × deflection.
    pub complementarity: f64,
    /// |u − u*| is at most this, anywhere \[m\]. Nothing is claimed (infinity) without a shear layer.
    pub settlement_bound: f64,
    /// √∫(M − M*)²/EI is at most this \[√(N·m)\].
    pub moment_bound: f64,
    /// The root mean square over the beam of M − M* is at most this \[N·m\].
    pub moment_rms_bound: f64,
}

impl Certificate {
    /// The relative violation above which a result is refused.
    pub const TOLERANCE: f64 = 1e-7;

    /// Whether every condition that no mesh excuses holds to rounding.
    pub fn holds(&self) -> bool {
        self.violation() <= Self::TOLERANCE
    }

    /// The largest relative violation of balance, signs and complementarity.
    pub fn violation(&self) -> f64 {
        let finite = if self.relative_gap.is_finite() { 0.0 } else { f64::INFINITY };
        [
            self.force_balance,
            self.moment_balance,
            -self.smallest_pressure,
            self.complementarity,
            finite,
        ]
        .into_iter()
        .fold(0.0, |worst, part| if part.is_nan() { f64::INFINITY } else { worst.max(part) })
    }
}

/// What is claimed, from left to right.
pub(crate) struct Claim<'a> {
    pub pieces: Vec<ClaimedPiece<'a>>,
    /// Concentrated contact forces: position, force up.
    pub forces: Vec<(f64, f64)>,
    /// Reactions of the supports: position, force up, moment.
    pub reactions: Vec<(f64, f64, f64)>,
    /// The part of the beam's own buckling load that its compression leaves: 1 for P ≥ 0.
    pub stability: f64,
}

/// A part of the beam on which w and p are polynomials of s ∈ \[−1, 1\].
pub(crate) struct ClaimedPiece<'a> {
    pub x: [f64; 2],
    /// Half its length; the ends themselves are rounded.
    pub half: f64,
    pub deflection: &'a [f64],
    pub pressure: &'a [f64],
    /// u at both ends where the ground is free; none where it follows the beam.
    pub open: Option<[f64; 2]>,
}

/// Gauss–Legendre points on \[−1, 1\], exact to degree 23: to rounding for every integrand here.
const GAUSS: [(f64, f64); 6] = [
    (0.125_233_408_511_468_9, 0.249_147_045_813_402_78),
    (0.367_831_498_998_180_2, 0.233_492_536_538_354_82),
    (0.587_317_954_286_617_4, 0.203_167_426_723_065_92),
    (0.769_902_674_194_304_7, 0.160_078_328_543_346_22),
    (0.904_117_256_370_474_9, 0.106_939_325_995_318_43),
    (0.981_560_634_246_719_2, 0.047_175_336_386_511_83),
];

fn gauss() -> impl Iterator<Item = (f64, f64)> {
    GAUSS.iter().flat_map(|&(s, w)| [(-s, w), (s, w)])
}

/// Energies and their parts, summed piece by piece.
#[derive(Debug, Default)]
struct Sums {
    /// ∫EI w″², ∫P w'², ∫m²/EI, ∫(EI w″ + m)²/EI, F(w).
    bending: f64,
    axial: f64,
    moment: f64,
    misfit: f64,
    work: f64,
    /// The springs' energies, twice.
    springs: f64,
    largest_deflection: f64,
}

/// Certifies a claim.
pub(crate) fn certify(model: &Model, claim: &Claim) -> Certificate {
    let mut sums = Sums { largest_deflection: claim.largest_deflection(), ..Sums::default() };
    let mut ground = GroundSums::new(model, claim);
    let mut events = Events::of(model, claim);
    events.advance(0.0);
    for piece in &claim.pieces {
        beam_piece(model, piece, &mut events, &mut sums);
        ground.add(model, piece, sums.largest_deflection);
        events.advance(piece.x[1]);
    }
    ground.finish(model);
    work_at_points(model, claim, &mut sums);

    let stability = claim.stability;
    let gap = 0.5 * sums.misfit / stability + ground.misfit() + ground.on_gap + ground.lifting();
    let inner = sums.axial + ground.energy + sums.springs;
    let strain = 0.5 * (sums.bending + sums.axial.abs() + ground.energy + sums.springs);
    // Loads that supports take without any strain leave rounding alone, to be judged by the energy that
    // they would put into the ground.
    let sunk = events.forces * (events.forces / (model.foundation.spring * model.beam.length));
    let strain = strain + f64::EPSILON * sunk;
    let relative = |x: f64, scale: f64| if x == 0.0 { 0.0 } else { x / scale };
    let moment_bound = (2.0 * gap / stability).sqrt();
    let stiffest = model.beam.segments.iter().map(|s| s.bending_stiffness);
    let stiffest = stiffest.fold(model.beam.bending_stiffness, f64::max);
    let [force_balance, moment_balance] = events.balance();
    Certificate {
        primal_energy: 0.5 * (sums.bending + inner) - sums.work,
        dual_energy: -0.5 * (sums.moment + inner) - ground.work_on_gap,
        gap,
        relative_gap: relative(gap, strain),
        force_balance,
        moment_balance,
        smallest_pressure: ground.smallest_pressure(events.forces),
        deepest_penetration: relative(ground.penetration, sums.largest_deflection),
        complementarity: relative(
            ground.worst_product,
            ground.largest_force * sums.largest_deflection,
        ),
        settlement_bound: (2.0 * gap / stability * ground.flexibility).sqrt(),
        moment_bound,
        moment_rms_bound: moment_bound * (stiffest / model.beam.length).sqrt(),
    }
}

/// The beam's part of a piece: m from equilibrium, its misfit to EI w″, the energies.
fn beam_piece(model: &Model, piece: &ClaimedPiece, events: &mut Events, sums: &mut Sums) {
    let [from, to] = piece.x;
    let half = piece.half;
    let stiffness = model.beam.bending_stiffness_at(0.5 * (from + to));
    let axial = model.beam.axial_force;
    let load = SpreadLoad::on(model, piece.x);
    let moment = events.integrate(piece, &load, axial);
    for (s, weight) in gauss() {
        let [w, dw, ddw, _] = jet(piece.deflection, s);
        let (slope, curvature) = (dw / half, ddw / (half * half));
        let m = value(&moment, s);
        let misfit = stiffness * curvature + m;
        let dx = weight * half;
        sums.bending += dx * stiffness * curvature * curvature;
        sums.axial += dx * axial * slope * slope;
        sums.moment += dx * m * m / stiffness;
        sums.misfit += dx * misfit * misfit / stiffness;
        sums.work += dx * (load.force(s) * w + load.moment(s) * slope);
    }
}

/// The work of point loads and the energy of springs.
fn work_at_points(model: &Model, claim: &Claim, sums: &mut Sums) {
    use crate::model::Load;
    for load in &model.loads {
        match *load {
            Load::PointForce { at, force } => sums.work += force * claim.deflection(at)[0],
            Load::PointMoment { at, moment } => sums.work += moment * claim.deflection(at)[1],
            Load::Distributed { .. } | Load::DistributedMoment { .. } => {}
        }
    }
    for support in &model.supports {
        if let SupportKind::Spring { spring, rotational_spring } = support.kind {
            let [w, slope] = claim.deflection(support.at);
            sums.springs += spring * w * w + rotational_spring * slope * slope;
        }
    }
}

impl Claim<'_> {
    /// The largest |w|, to the accuracy of a scale.
    fn largest_deflection(&self) -> f64 {
        let at = |piece: &ClaimedPiece| {
            [-1.0, -0.5, 0.0, 0.5, 1.0].map(|s| value(piece.deflection, s).abs())
        };
        self.pieces.iter().flat_map(at).fold(0.0, f64::max)
    }

    /// w and w' at a position.
    fn deflection(&self, x: f64) -> [f64; 2] {
        let i = self.pieces.partition_point(|piece| piece.x[1] < x).min(self.pieces.len() - 1);
        let piece = &self.pieces[i];
        let half = piece.half;
        let s = ((x - 0.5 * (piece.x[0] + piece.x[1])) / half).clamp(-1.0, 1.0);
        let [w, dw, ..] = jet(piece.deflection, s);
        [w, dw / half]
    }
}
