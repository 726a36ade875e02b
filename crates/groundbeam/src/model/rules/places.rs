//! Finds equal positions and overlapping stretches in a list, in n log n steps.

use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Position with a total order.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Place(f64);

impl Eq for Place {}

impl PartialOrd for Place {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Place {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// Positions along the beam, each with the index at which it first occurs in a list.
#[derive(Debug, Clone, Default)]
pub(crate) struct Places(BTreeMap<Place, usize>);

impl Places {
    /// Adds a position with its index, unless an equal position is already present. A position that is not finite is
    /// ignored.
    pub fn add(&mut self, at: f64, number: usize) {
        if at.is_finite() {
            // The sum with 0.0 turns −0 into 0, because −0 and 0 are the same position.
            self.0.entry(Place(at + 0.0)).or_insert(number);
        }
    }

    /// Smallest index of a position that differs from `at` by at most `near`.
    pub fn first_at(&self, at: f64, near: f64) -> Option<usize> {
        if !at.is_finite() {
            return None;
        }
        let here = Place(at - near)..=Place(at + near);
        self.0.range(here).map(|(_, number)| *number).min()
    }

    /// Index of the last position that is at `at` or to the left of `at`.
    pub fn last_up_to(&self, at: f64) -> Option<usize> {
        self.0.range(..=Place(at + 0.0)).next_back().map(|(_, number)| *number)
    }
}

/// For each position, returns the index of an earlier position that differs by at most `near`; `None` if all earlier
/// positions differ by more.
pub(crate) fn repeated(
    positions: impl Iterator<Item = f64>,
    near: f64,
) -> impl Iterator<Item = Option<usize>> {
    let mut places = Places::default();
    positions.enumerate().map(move |(number, at)| {
        let other = places.first_at(at, near);
        if other.is_none() {
            places.add(at, number);
        }
        other
    })
}

/// Finds pairs of overlapping stretches, each pair with its larger index first, sorted by index. A stretch that
/// begins within several other stretches is paired with only one of them.
pub(crate) fn overlapping(stretches: &[(f64, f64)]) -> Vec<(usize, usize)> {
    let mut order: Vec<usize> = (0..stretches.len()).collect();
    // Stretches of zero or negative length are skipped, because another rule reports them.
    order.retain(|&i| stretches[i].0 < stretches[i].1);
    order.sort_by(|&a, &b| stretches[a].0.total_cmp(&stretches[b].0));
    let mut found = Vec::new();
    // Index of the visited stretch whose right end is farthest to the right.
    let mut farthest: Option<usize> = None;
    for i in order {
        let (from, to) = stretches[i];
        match farthest {
            Some(other) if from < stretches[other].1 => found.push((i.max(other), i.min(other))),
            _ => {}
        }
        farthest = farthest.filter(|&other| stretches[other].1 >= to).or(Some(i));
    }
    found.sort_unstable();
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::tolerance::same_place;

    #[test]
    fn equal_positions_are_found_within_rounding() {
        let positions = [0.3, 0.0, 0.1 + 0.2, -0.0, f64::NAN, f64::NAN, 0.4, 0.3];
        let found: Vec<_> = repeated(positions.into_iter(), same_place(1.0)).collect();
        assert_eq!(found, [None, None, Some(0), Some(1), None, None, None, Some(0)]);
        let at_wrong_lengths = [-1.0, f64::NAN, f64::INFINITY].map(same_place);
        assert_eq!(at_wrong_lengths, [0.0; 3]);
    }

    #[test]
    fn overlapping_stretches_are_found() {
        let nan = f64::NAN;
        let stretches = [(3.0, 5.0), (0.0, 2.0), (4.0, 9.0), (2.0, 3.0), (6.0, 7.0), (nan, 1.0)];
        assert_eq!(overlapping(&stretches), [(2, 0), (4, 2)]);
        assert_eq!(overlapping(&[(0.0, 9.0), (1.0, 2.0), (3.0, 4.0)]), [(1, 0), (2, 0)]);
        assert_eq!(overlapping(&[(1.0, 2.0), (1.0, 2.0), (1.0, 2.0)]), [(1, 0), (2, 0)]);
    }
}
