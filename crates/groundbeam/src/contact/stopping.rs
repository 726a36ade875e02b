//! Defines the constants for the start, the step length and the stop of the contact iteration, with the experiments behind them.
//!
//! Lengths are relative to the length of the beam. The experiments count steps over the random models of the
//! verification crate. Hard 774 is model 774 of the random family Hard.

/// Largest move of the contact edges at which the contact has converged, relative to the length of the shortest
/// contact zone. A limit of 1e-13 needs 10 % fewer steps in case C of the benchmarks, but leaves pressures of −1e-13 of
/// the largest pressure at edges on Winkler ground.
pub(crate) const CONVERGED_MOVE: f64 = 1e-15;

/// Moves of the contact edges up to this fraction of the beam's length may be only rounding error. The iteration
/// has converged if the largest move in a step is within this limit and at least a quarter of the largest move in
/// the preceding step. If Newton's method for the edges moves no edge farther than this limit, the obstacle problem
/// determines the contact set instead.
pub(crate) const ROUNDING_MOVE: f64 = 1e-12;

/// Largest move of a contact edge, relative to the length of the beam, that counts as rounding error after
/// [`STALE_STEPS`] consecutive steps without progress. A step makes progress if its move is at most half of the
/// preceding move. A move within this limit must instead be at most half of the smallest move so far.
/// Model 774 of the random family Hard needs this criterion.
pub(crate) const JITTER: f64 = 1e-7;

/// Distance between beam and ground, in units in the last place of the deflection, below which rounding error decides
/// whether beam and ground touch. In the reference model hard-006, which was solved to 60 digits, rounding error
/// causes distances of at most 1.8 of these units; in 300 models of an unloaded beam beyond a settled clamp, at most 9.
/// In a step that makes progress, the distances are 3·10³ units and more.
pub(crate) const ULPS: f64 = 64.0;

/// If no contact edge moves by more than this fraction of the beam's length, the line search does not shorten the
/// step, because the decrease of the energy is lost in rounding error. The random test model `Gap 1369` needs a
/// value above 1.1e-8.
pub(crate) const BLIND: f64 = 2e-8;

/// Two contact sets count as equal if no edge differs by more than this fraction of the beam's length. The
/// iteration uses this limit to detect a return to an earlier contact set.
pub(crate) const SAME: f64 = 1e-9;

/// Number of consecutive steps without progress after which the iteration tests whether only rounding error moves the
/// contact edges.
pub(crate) const STALE_STEPS: usize = 4;

/// A step may move the contact edges by Newton's method if the preceding step moved them by less than this fraction
/// of the beam's length, and no earlier step moved them less. The beam must also need no stabilising springs.
pub(crate) const NEAR: f64 = 0.1;

/// Largest move of a contact edge in one Newton step of the edges, as a fraction of the length of the contact zone
/// or of the adjacent ground out of contact, whichever is shorter.
pub(crate) const NEAR_EDGE: f64 = 0.25;

/// Limit on the number of steps of a contact iteration. The first `always` steps are always allowed. Further steps,
/// up to `most`, are allowed while the number of steps times the number of cells is below `work`.
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

/// Limit on the number of Newton steps of a contact iteration that starts from the result of the continuation in
/// the beam's stiffness. It also applies within the continuation, to its first beam and to its shortest step. A
/// short gap between two contact zones closes slowly under the line search. The random models Shearing 6302 and
/// Hinged 1100 need 133 and 296 steps on a few cells, and in Shearing 7839 the number of steps times the number of
/// cells reaches 100,000. On the 3000 cells of the random model Hard 9773, 300 steps take a minute and do not
/// converge.
pub(crate) const MOST_STEPS: StepLimit = StepLimit { always: 60, most: 400, work: 100_000 };

/// Limit on the number of Newton steps of a contact iteration that starts from the initial guess or from the
/// contact of a similar model. It also applies to the iterations with a line search within the continuation, except
/// at its shortest step. On the random models of the family Hard, 7 % more obstacle problems are solved with a
/// limit of 8 steps, and 3 % fewer with a limit of 32 steps.
pub(crate) const FEW_STEPS: StepLimit = StepLimit { always: 16, most: 16, work: 0 };

/// Smallest and largest stiffness of the stabilising springs, relative to the stiffness of the ground, and the factor
/// by which the springs become stiffer.
pub(crate) const SOFTEST_SPRING: f64 = 1e-6;
pub(crate) const STIFFEST_SPRING: f64 = 1e6;
pub(crate) const STIFFEN: f64 = 100.0;

/// Fraction of the full Newton step below which the stabilising springs become stiffer. After a longer step,
/// [`SOFTEN`] multiplies their stiffness.
pub(crate) const NOT_SHORTENED: f64 = 0.01;
pub(crate) const SOFTEN: f64 = 0.1;

/// Fraction of the full Newton step below which a step of the line search is rounding error.
pub(crate) const LEAST_PART: f64 = 1e-9;

/// If the beam is a mechanism, auxiliary springs restrain it: stabilising springs, or a spring that prescribes a
/// rotation. If the relative energy gap of the solution is at most this value, the forces in these springs count as
/// rounding error. The random model Hinged 1017 has an energy gap of 3e-10 in a false equilibrium. In equilibrium, the
/// energy gap is 9e-30 in the random model Gap 738 and 1e-21 in Hinged 8306.
pub(crate) const ROUNDING_GAP: f64 = 1e-18;

/// Relative Newton decrement below which a decrease of the energy is rounding error.
pub(crate) const LEAST_FALL: f64 = 1e-26;

/// Two contact zones are joined if the part of the beam out of contact between them is at most this long, because such
/// a short part is due to rounding error.
pub(crate) const SLIT: f64 = 1e-10;

/// Contact force of a zone, relative to the total contact force, below which the zone may be left out of contact. The
/// random model Supported 973 has such a zone with a length of 0.65 times the length of the beam.
pub(crate) const WEIGHTLESS: f64 = 1e-13;

/// Length of a beam, in units of 1/wave number, up to which the initial guess is contact along the whole length of
/// the beam. This guess leads to the solution of 13,314 of 18,295 random models.
pub(crate) const SHORT: f64 = 24.0;

/// The continuation starts with a beam so stiff that the distance between adjacent nodes of the model, times the wave
/// number of this beam, is at most this value. With a value of 16, the solver finds no solution of the random model
/// Extreme 230.
pub(crate) const STIFF_WAVES: f64 = 4.0;

/// Longest step of the continuation in the beam's stiffness, as a change of log₂ of the stiffness.
pub(crate) const LONGEST_STEP: f64 = 2.0;

/// Step of the continuation below which Newton's method with a line search solves the beam if the corrector does not
/// converge. With a value of 1e-7, the solver finds no solution of the random model Hard 9773.
pub(crate) const SEARCHED_STEP: f64 = 1e-6;

/// Shortest step of the continuation. If the line search fails at this step, the continuation fails. With a value of
/// 1e-6, the solver finds no solution of the random model Extreme 1393.
pub(crate) const SHORTEST_STEP: f64 = 1e-7;

/// Maximum number of steps of the continuation, including steps that do not converge. Each step solves the beam
/// with another bending stiffness. Without this limit, a model with soft hinges takes minutes.
pub(crate) const MOST_BEAMS: usize = 500;

/// Maximum number of Newton steps of the corrector, which corrects the predicted contact edges in each step of the
/// continuation.
pub(crate) const CORRECTOR_STEPS: usize = 12;

/// The corrector of the continuation has converged if its last step moves the contact edges by at most this fraction of
/// the beam's length.
pub(crate) const ROUGH: f64 = 1e-6;

/// Number of levels of the continuation. The elements of each level are a third as long as those of the preceding
/// level, and the steps are shorter. The random model Shearing 439 needs the second level.
pub(crate) const LEVELS: u32 = 3;
