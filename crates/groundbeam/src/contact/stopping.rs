//! The relative gaps of the certificate at which the contact iteration stops, and its limits.

/// Ends the iteration at once.
pub(crate) const PROVEN: f64 = 1e-22;

/// Ends the iteration when the edges no longer converge quadratically.
pub(crate) const ENOUGH: f64 = 1e-11;

/// Ends the iteration after [`LAST_STEPS`], where rounding error moves the edges without end.
pub(crate) const LAST: f64 = 9e-10;

/// Relative Newton decrement that ends the iteration on a mesh that is only the start of the next.
pub(crate) const COARSE_CLOSE: f64 = 1e-6;

/// Threefold refinements of the coarse mesh before the solve fails.
pub(crate) const REFINEMENTS: u32 = 5;

/// Limit on Newton steps from one initial guess.
pub(crate) const MOST_STEPS: usize = 200;

/// Iteration limit from a warm start.
pub(crate) const NEAR_STEPS: usize = 24;

/// Move of the edges, relative to l, that ends the iteration for an initial guess.
pub(crate) const ROUGH: f64 = 1e-6;

/// Move of the edges, relative to l, below which the line search is off.
pub(crate) const LOCAL: f64 = 1e-8;

/// Switch to edge Newton when the last move is below this, relative to l.
pub(crate) const NEAR: f64 = 0.1;

/// Move of the edges, relative to l, below which the certificate is computed.
pub(crate) const EDGES_CLOSE: f64 = 1e-14;

/// A step is quadratic if its move is at most this part of the move before.
pub(crate) const SQUARING: f64 = 0.1;

/// Non-quadratic steps allowed before every step uses the line search.
pub(crate) const MOST_STRAYS: usize = 4;

/// Steps after which the certificate decides whether the last digits of the edges matter.
pub(crate) const PATIENCE: usize = 4;

/// After `ROUNDS * PATIENCE` steps [`ENOUGH`] ends the iteration.
pub(crate) const ROUNDS: usize = 12;

/// Steps without progress, after which the iteration tries the beam without its weakest zones; and steps after which it
/// tries contact at a single corner.
pub(crate) const WALKING: usize = 8;

/// The weakest zone that is kept then, relative to the strongest.
pub(crate) const WEAKEST: f64 = 1e-10;

/// The largest move of the other edges then, relative to l.
pub(crate) const STILL: f64 = 1e-3;

/// Steps after which [`LAST`] ends the iteration.
pub(crate) const LAST_STEPS: usize = 100;
