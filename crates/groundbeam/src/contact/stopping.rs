//! The certificate figures at which the contact iteration stops, and those that it accepts.

/// What the certificate shows, or must show.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Proof {
    /// The relative gap.
    pub gap: f64,
    /// The largest violation of balance, signs and complementarity. An edge that is off by δ leaves pδ
    /// unbalanced.
    pub violation: f64,
}

impl Proof {
    /// What is known where nothing is asked.
    pub(super) const NONE: Proof = Proof { gap: f64::INFINITY, violation: f64::INFINITY };

    pub(super) fn is_within(self, wanted: Proof) -> bool {
        self.gap <= wanted.gap && self.violation <= wanted.violation
    }
}

/// What ends the iteration early, and what is accepted in the end.
pub(crate) const PROVEN: Proof = Proof { gap: 1e-22, violation: 1e-13 };

pub(crate) const ENOUGH: Proof = Proof { gap: 1e-11, violation: 3e-8 };

/// What is accepted where rounding moves the edges for ever, after so many steps.
pub(crate) const LAST: Proof = Proof { gap: 9e-10, violation: 5e-8 };

/// The same on a mesh that only gives the next one its start.
pub(crate) const COARSE_CLOSE: f64 = 1e-6;

/// How often the coarse mesh is refined threefold before the model is given up.
pub(crate) const REFINEMENTS: u32 = 5;

/// Newton steps from one start.
pub(crate) const MOST_STEPS: usize = 200;

/// The same from edges that are known to be near: if it takes more, they are not.
pub(crate) const NEAR_STEPS: usize = 24;

/// The last move of an edge, relative to the beam's length, of a beam that only gives the next its start.
pub(crate) const ROUGH: f64 = 1e-6;

/// A move of the edges, relative to the beam's length, after which no step is shortened.
pub(crate) const LOCAL: f64 = 1e-8;

/// The same, after which the next step moves each edge by itself,
pub(crate) const NEAR: f64 = 0.1;

/// and after which the edges are so good that the certificate is asked.
pub(crate) const EDGES_CLOSE: f64 = 1e-13;

/// A step that leaves no more than this part of the move before is one that squares the error.
pub(crate) const SQUARING: f64 = 0.1;

/// How many steps may stray from that before squaring the error is no excuse.
pub(crate) const MOST_STRAYS: usize = 4;

/// Steps after which the certificate is asked whether the edges' last digits matter.
pub(crate) const PATIENCE: usize = 4;

/// How often that, whatever the steps do, before the certificate's answer is good enough.
pub(crate) const ROUNDS: usize = 12;

/// Steps in a row that did not halve the move, after which the beam is tried without its weakest zones; and steps
/// after which it is tried on a corner alone.
pub(crate) const WALKING: usize = 8;

/// The weakest zone that is kept in that, relative to the strongest, and the most that the others may move,
/// relative to the beam's length.
pub(crate) const WEAKEST: f64 = 1e-10;

pub(crate) const STILL: f64 = 1e-3;

pub(crate) const LAST_STEPS: usize = 100;
