//! Finds the longest free span, and the free span with the largest clearance, over all positions of a train.

use super::passage::Passage;
use groundbeam::solution::LiftOff;

/// A stretch of the beam without contact, and the position of the train.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Opened {
    /// Position of the first axle of the train \[m\].
    pub first_axle: f64,
    /// The stretch of the beam without contact.
    pub stretch: LiftOff,
}

/// The longest free span of a passage, and the free span with the largest clearance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeSpans {
    /// The longest free span.
    pub longest: Opened,
    /// The free span with the largest clearance.
    pub highest: Opened,
}

impl Passage<'_> {
    /// The longest free span, and the free span with the largest clearance, over all solved positions. Lifted ends
    /// count. The first of equal spans is taken. `None` if the beam never lifts off.
    pub fn free_spans(&self) -> Option<FreeSpans> {
        let mut found: Option<FreeSpans> = None;
        for (first_axle, solution) in self.solved() {
            for stretch in solution.lift_off() {
                let here = Opened { first_axle, stretch };
                let FreeSpans { longest, highest } =
                    found.get_or_insert(FreeSpans { longest: here, highest: here });
                if stretch.length() > longest.stretch.length() {
                    *longest = here;
                }
                if stretch.largest_gap.value > highest.stretch.largest_gap.value {
                    *highest = here;
                }
            }
        }
        found
    }
}
