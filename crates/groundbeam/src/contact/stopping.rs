//! Every constant of the contact iteration, with the experiment that chose it. Lengths are relative to the beam's length.
//!
//! The experiments are counts of steps over the random models of the verification crate.

/// A move of the contact that is settled, relative to the shortest zone.
pub(crate) const SETTLED: f64 = 1e-15;

/// A move that is settled if the step before was not four times as long. Below it the scan decides, not edge Newton.
pub(crate) const ROUNDED: f64 = 1e-12;

/// A move that is rounding error if [`PATIENCE`] steps have not halved the least move. Hard 774 needs it.
pub(crate) const JITTER: f64 = 1e-7;

/// Beam and ground this many units in the last place of the deflection apart: rounding error decides whether they touch.
/// The largest distance in the 60-digit model hard-006 is 1.8, in a step that makes progress 3·10³ and more.
pub(crate) const ULPS: f64 = 8.0;

/// A searched step may be this long. The energy does not resolve shorter moves.
pub(crate) const BLIND: f64 = 1e-8;

/// Two contacts within this distance are the same when the iteration returns to an earlier one.
pub(crate) const SAME: f64 = 1e-9;

/// Steps in a row without progress, before the iteration stops waiting.
pub(crate) const PATIENCE: usize = 4;

/// Switch to edge Newton when the last move is below this.
pub(crate) const NEAR: f64 = 0.1;

/// Edge Newton moves an edge by at most this part of the zone and of the open ground beside it.
pub(crate) const NEAR_EDGE: f64 = 0.25;

/// Limit on Newton steps from the start that the continuation gives.
pub(crate) const MOST_STEPS: usize = 60;

/// Limit on Newton steps from the bonded beam or from a neighbour's contact: 8 steps need 7 % more scans on Hard,
/// 32 steps 3 % fewer.
pub(crate) const FEW_STEPS: usize = 16;

/// The least and the largest stiffness of the tether, as a part of the ground's, and the factor by which it grows.
pub(crate) const TETHER: f64 = 1e-6;
pub(crate) const STIFFEST_TETHER: f64 = 1e6;
pub(crate) const TIGHTEN: f64 = 100.0;

/// A shorter part of a searched step stiffens the tether; a longer one relaxes it by this factor.
pub(crate) const NOT_SHORTENED: f64 = 0.01;
pub(crate) const RELAX: f64 = 0.1;

/// A shorter part of a step has met rounding error.
pub(crate) const LEAST_PART: f64 = 1e-9;

/// The relative gap of a beam that is balanced on one point: the moment of the spring that gives its rotation is rounding
/// error. Hinged 1017 has a gap of 3e-10 at a false balance, Gap 738 one of 9e-30.
pub(crate) const ON_ONE_POINT: f64 = 1e-18;

/// The relative fall of the energy that is rounding error: such a step has no direction.
pub(crate) const LEAST_FALL: f64 = 1e-26;

/// Open ground this short between two zones is rounding error.
pub(crate) const SLIT: f64 = 1e-10;

/// The force of a weightless zone, relative to the whole contact force. Supported 973 has a zone 0.65 l long.
pub(crate) const WEIGHTLESS: f64 = 1e-13;

/// The longest beam in units of 1/wave number that starts from contact along its whole length: 13,314 of 18,295 random
/// models are answered from there.
pub(crate) const SHORT: f64 = 24.0;

/// The longest beam in units of 1/wave number between two nodes of the model at which the continuation starts. With 16
/// Extreme 230 has no answer.
pub(crate) const STIFF_WAVES: f64 = 4.0;

/// The longest and the shortest step of the continuation in log₂ of the stiffness. Hard 6164 needs 10⁻⁷.
pub(crate) const LONGEST_STEP: f64 = 2.0;
pub(crate) const SHORTEST_STEP: f64 = 1e-7;

/// Limit on beams of the continuation, also those that do not settle. Without it a model with soft hinges takes minutes.
pub(crate) const MOST_BEAMS: usize = 500;

/// Newton steps of the continuation's corrector, and the move at which it is settled.
pub(crate) const CORRECTOR_STEPS: usize = 12;
pub(crate) const ROUGH: f64 = 1e-6;

/// Meshes of phase A that are tried, each with a third of the element length and shorter steps. Shearing 439 needs the
/// second.
pub(crate) const LEVELS: u32 = 3;
