//! Estimates the error of the contact edges from the trial contact sets of the last iterations.

use crate::contact::intervals::{Interval, differences};
use crate::contact::stopping::JITTER;

/// The error of the contact edges.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct EdgeError {
    /// Largest change of the position of a contact edge due to rounding error \[m\].
    pub moved: f64,
    /// Intervals on which rounding error decides whether beam and ground touch.
    pub undecided: Vec<Interval>,
}

impl EdgeError {
    /// Estimates the error of the edges from trial contacts that differ by rounding error, on a beam of length l.
    pub fn of(trials: &[&[Interval]], l: f64) -> Self {
        let mut error = EdgeError::default();
        for [from, to] in differences(trials) {
            if to - from > JITTER * l {
                error.undecided.push([from, to]);
            } else {
                error.moved = error.moved.max(to - from);
            }
        }
        error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_differences_are_undecided_and_short_ones_are_moves_of_edges() {
        let [first, second] = [vec![[0.0, 0.4], [0.6, 0.9]], vec![[0.6, 0.9 + 1e-9]]];
        let error = EdgeError::of(&[&first, &second], 1.0);
        assert_eq!(error.undecided, [[0.0, 0.4]]);
        assert!((error.moved - 1e-9).abs() < 1e-15, "{}", error.moved);
        assert_eq!(EdgeError::of(&[&first, &first], 1.0), EdgeError::default());
    }
}
