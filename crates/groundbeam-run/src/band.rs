//! Computes the ranges of results over uncertain k and μ, from solutions with several factors on k and μ.

use crate::answers::Answers;
use groundbeam::{Field, envelope::Envelope, solution::ByField};

/// The smallest or the largest value of a field for the best estimates of k and μ, and the range of this extreme
/// value over all pairs of k and μ for which the model was solved.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Banded {
    /// Extreme value for the best estimates of k and μ.
    pub best: f64,
    /// Smallest result for the extreme value over all pairs of k and μ for which the model was solved.
    pub low: f64,
    /// Largest result for the extreme value over all pairs of k and μ for which the model was solved.
    pub high: f64,
}

/// Factors on k and μ that give the best estimates.
pub const BEST: [f64; 2] = [1.0, 1.0];

impl Answers {
    /// The smallest and the largest value of each field, in the order of [`Field::ALL`], for the best estimates of k
    /// and μ. Each value has its range over all solved pairs of k and μ. `None` if no combination is solved with the
    /// factors [`BEST`].
    pub fn bands(&self) -> Option<ByField<[Banded; 2]>> {
        let mut grounds = vec![BEST];
        for ground in self.solved().filter_map(|(answer, _)| answer.label.combination.ground) {
            if !grounds.contains(&ground) {
                grounds.push(ground);
            }
        }
        let mut bands: Option<ByField<[Banded; 2]>> = None;
        for ground in grounds {
            let extremes = self.extremes_on(ground)?;
            let first =
                extremes.map(|both| both.map(|best| Banded { best, low: best, high: best }));
            let bands = bands.get_or_insert(first);
            for (band, value) in bands.iter_mut().flatten().zip(extremes.into_iter().flatten()) {
                band.low = band.low.min(value);
                band.high = band.high.max(value);
            }
        }
        bands
    }

    /// The smallest and the largest value of each field over all combinations, for one pair of factors on k and
    /// μ; `None` if no combination is solved for this pair.
    fn extremes_on(&self, ground: [f64; 2]) -> Option<ByField<[f64; 2]>> {
        let here =
            self.solved().filter(|(answer, _)| answer.label.combination.ground == Some(ground));
        let solutions: Vec<_> = here.map(|(_, solution)| solution).collect();
        if solutions.is_empty() {
            return None;
        }
        let envelope = Envelope::of(solutions);
        Some(Field::ALL.map(|field| {
            let range = envelope.range(field);
            [range.min, range.max].map(|governing| governing.extreme.value)
        }))
    }
}
