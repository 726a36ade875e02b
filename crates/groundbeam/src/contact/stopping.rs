//! The constants of the contact iteration: when it stops, how far it steps, how it starts; and experiments by
//! which they were chosen. Lengths are relative to the length of the beam.
//!
//! The experiments count steps over the random models of the verification crate.

/// Move below which the contact has converged, relative to the shortest zone.
pub(crate) const CONVERGED_MOVE: f64 = 1e-15;

/// Move below which the contact has converged if the move before was at most four times as long. Below it the scan is
/// used, not edge Newton.
pub(crate) const ROUNDING_MOVE: f64 = 1e-12;

/// Move below which the contact moves by rounding error, if [`STALE_STEPS`] steps have not halved the least move. Model
/// Hard 774 needs it.
pub(crate) const JITTER: f64 = 1e-7;

/// Distance between beam and ground, in units in the last place of the deflection, below which rounding error decides
/// whether they touch. In the 60-digit model hard-006 the largest such distance is 1.8; in a step that makes progress
/// it is 3·10³ and more.
pub(crate) const ULPS: f64 = 8.0;

/// Move below which a step is not shortened, because the energy does not resolve shorter moves. Gap 1369 needs more than
/// 1.1e-8.
pub(crate) const BLIND: f64 = 2e-8;

/// Distance below which two contacts count as equal when the iteration returns to an earlier one.
pub(crate) const SAME: f64 = 1e-9;

/// Number of consecutive steps without progress after which rounding error is considered.
pub(crate) const STALE_STEPS: usize = 4;

/// The next step is a Newton step of the edges only if the last move is smaller than this.
pub(crate) const NEAR: f64 = 0.1;

/// Largest move in a Newton step of an edge, relative to the length of the zone and of the open ground beside
/// it.
pub(crate) const NEAR_EDGE: f64 = 0.25;

/// Limit on the steps of a search: `always`, and on small meshes up to `most` while steps times cells are below `work`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StepLimit {
    pub always: usize,
    pub most: usize,
    pub work: usize,
}

impl StepLimit {
    pub fn allows(self, steps: usize, cells: usize) -> bool {
        steps < self.always || steps < self.most && steps * cells < self.work
    }
}

/// Limit on Newton steps of a search in and after the continuation. A slit between two zones closes slowly under the
/// line search: Shearing 6302 and Hinged 1100 need 133 and 296 steps on a few cells, Shearing 7839 needs a `work` of
/// 100,000. On the 3000 cells of Hard 9773, 300 steps take a minute and do not converge.
pub(crate) const MOST_STEPS: StepLimit = StepLimit { always: 60, most: 400, work: 100_000 };

/// Limit on Newton steps from the initial guess or from a neighbour's contact. On the models of the family Hard, a
/// limit of 8 steps needs 7 % more scans, and a limit of 32 steps 3 % fewer.
pub(crate) const FEW_STEPS: StepLimit = StepLimit { always: 16, most: 16, work: 0 };

/// Least and largest stiffness of the stabilising springs, relative to that of the ground, and the factor by which it
/// grows.
pub(crate) const SOFTEST_SPRING: f64 = 1e-6;
pub(crate) const STIFFEST_SPRING: f64 = 1e6;
pub(crate) const STIFFEN: f64 = 100.0;

/// Fraction of a step below which the stabilising springs become stiffer, and the factor on their stiffness otherwise.
pub(crate) const NOT_SHORTENED: f64 = 0.01;
pub(crate) const SOFTEN: f64 = 0.1;

/// Fraction of a step below which the line search has reached rounding error.
pub(crate) const LEAST_PART: f64 = 1e-9;

/// Largest relative energy gap at which the forces of springs that restrain a mechanism are rounding error: a spring that
/// prescribes a rotation, or the stabilising springs. Hinged 1017 has a gap of 3e-10 at a false balance, Gap 738 one of
/// 9e-30, Hinged 8306 one of 1e-21.
pub(crate) const ROUNDING_GAP: f64 = 1e-18;

/// Relative decrement below which a decrease of the energy is rounding error.
pub(crate) const LEAST_FALL: f64 = 1e-26;

/// Open ground between two zones is due to rounding error if it is shorter than this.
pub(crate) const SLIT: f64 = 1e-10;

/// Force of a zone, relative to the whole contact force, below which the zone may be left open. Supported 973 has such
/// a zone of length 0.65 l.
pub(crate) const WEIGHTLESS: f64 = 1e-13;

/// Length of a beam, in units of 1/wave number, up to which the initial guess is contact along the whole length. This
/// guess leads to the solution of 13,314 of 18,295 random models.
pub(crate) const SHORT: f64 = 24.0;

/// Largest distance between two nodes of the model, in units of 1/wave number, at which the continuation starts. With
/// 16, Extreme 230 has no solution.
pub(crate) const STIFF_WAVES: f64 = 4.0;

/// The longest and the shortest step of the continuation, in log₂ of the stiffness. Hard 6164 needs 10⁻⁷.
pub(crate) const LONGEST_STEP: f64 = 2.0;
pub(crate) const SHORTEST_STEP: f64 = 1e-7;

/// Maximum number of beams that the continuation solves, including those that do not converge. Without this
/// limit a model with soft hinges takes minutes.
pub(crate) const MOST_BEAMS: usize = 500;

/// Limit on Newton steps of the corrector in the continuation, and the move below which it has converged.
pub(crate) const CORRECTOR_STEPS: usize = 12;
pub(crate) const ROUGH: f64 = 1e-6;

/// Number of levels of the continuation. Each level has elements a third as long and shorter steps. Shearing 439 needs
/// the second level.
pub(crate) const LEVELS: u32 = 3;
