//! Defines the constants for the start, the step length and the stop of the contact iteration, with the experiments behind them.
//!
//! Lengths are relative to the length of the beam. Hard 774 is model 774 of the random family Hard in the verification
//! crate.

/// Largest move of the edges at convergence, relative to the shortest contact zone. With 1e-13, benchmark case C takes
/// 10 % fewer steps, but Winkler ground keeps tensions of 1e-13 of the largest pressure.
pub(crate) const CONVERGED_MOVE: f64 = 1e-15;

/// Largest move of the edges, relative to the beam length, that may be rounding error. A step with such a move has
/// converged if the move is at least a quarter of the preceding move.
pub(crate) const ROUNDING_MOVE: f64 = 1e-12;

/// Largest move, relative to the beam length, that is rounding error after [`STALE_STEPS`] steps without progress. The
/// random model Hard 774 needs it.
pub(crate) const JITTER: f64 = 1e-7;

/// Largest distance between beam and ground that may be rounding error, in units in the last place of the deflection.
/// It is at most 9 units in 300 models beyond a settled clamp. In a step with progress, it is 3000 or more.
pub(crate) const ULPS: f64 = 64.0;

/// Largest move of the edges, relative to the beam length, without a line search: the decrease of the energy is lost in
/// rounding error. The random model Gap 1369 needs more than 1.1e-8.
pub(crate) const BLIND: f64 = 2e-8;

/// Two contact sets count as equal if no edge differs by more than this fraction of the beam's length. The
/// iteration uses this limit to detect a return to an earlier contact set.
pub(crate) const SAME: f64 = 1e-9;

/// Number of consecutive steps without progress after which the iteration tests whether only rounding error moves the
/// contact edges.
pub(crate) const STALE_STEPS: usize = 4;

/// Move, relative to the beam length, below which the next step moves the edges by Newton's method if no earlier move
/// was smaller.
pub(crate) const NEAR: f64 = 0.1;

/// Largest move of a contact edge in one Newton step of the edges, as a fraction of the length of the contact zone
/// or of the adjacent ground out of contact, whichever is shorter.
pub(crate) const NEAR_EDGE: f64 = 0.25;

/// Step limit: `always` steps are allowed, and up to `most` steps while steps times cells are below `work`.
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

/// Step limit after the continuation, and for its first beam and its shortest step. The random model Hinged 1100 needs
/// 296 steps, and Shearing 7839 needs 100,000 steps times cells. On the 3000 cells of Hard 9773, 300 steps take a
/// minute and do not converge.
pub(crate) const MOST_STEPS: StepLimit = StepLimit { always: 60, most: 400, work: 100_000 };

/// Step limit from the initial guess or a similar model, and for line searches in the continuation. In the random
/// family Hard, a limit of 8 gives 7 % more obstacle problems, and 32 gives 3 % fewer.
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

/// Relative energy gap up to which the forces in the auxiliary springs of a mechanism count as rounding error. It is
/// 3e-10 in a false equilibrium (random model Hinged 1017) and 1e-21 in an equilibrium (Hinged 8306).
pub(crate) const ROUNDING_GAP: f64 = 1e-18;

/// Relative Newton decrement below which a decrease of the energy is rounding error.
pub(crate) const LEAST_FALL: f64 = 1e-26;

/// Two contact zones are joined if the part of the beam out of contact between them is at most this long, because such
/// a short part is due to rounding error.
pub(crate) const SLIT: f64 = 1e-10;

/// Contact force of a zone, relative to all contact forces, below which it may be rounding error, as in the random
/// model Supported 973.
pub(crate) const WEIGHTLESS: f64 = 1e-13;

/// Largest length of a short beam, times the wave number. A start from full contact solves 13,314 of 18,295 random
/// models.
pub(crate) const SHORT: f64 = 24.0;

/// Largest product of wave number and node distance in the first beam of the continuation. With 16, the random model
/// Extreme 230 is not solved.
pub(crate) const STIFF_WAVES: f64 = 4.0;

/// Longest step of the continuation in the beam's stiffness, as a change of log₂ of the stiffness.
pub(crate) const LONGEST_STEP: f64 = 2.0;

/// Step of the continuation up to which a line search replaces a failed corrector. With 1e-7, the random model Hard
/// 9773 is not solved.
pub(crate) const SEARCHED_STEP: f64 = 1e-6;

/// Shortest step of the continuation. With 1e-6, the random model Extreme 1393 is not solved.
pub(crate) const SHORTEST_STEP: f64 = 1e-7;

/// Maximum number of steps of the continuation. Without this limit, a model with soft hinges takes minutes.
pub(crate) const MOST_BEAMS: usize = 500;

/// Maximum number of Newton steps of the corrector, which corrects the predicted contact edges in each step of the
/// continuation.
pub(crate) const CORRECTOR_STEPS: usize = 12;

/// The corrector of the continuation has converged if its last step moves the contact edges by at most this fraction of
/// the beam's length.
pub(crate) const ROUGH: f64 = 1e-6;

/// Number of levels of the continuation. Each level divides the elements by three. The random model Shearing 439 needs
/// the second level.
pub(crate) const LEVELS: u32 = 3;
