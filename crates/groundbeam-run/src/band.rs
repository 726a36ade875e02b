//! Bands of grounds: the results at multiples of k and μ.

use crate::answers::Answers;
use groundbeam::{ByField, Envelope, Field};

/// A number on the best ground, and between which it lies on all grounds of a band that were solved.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Banded {
    /// On the best ground.
    pub best: f64,
    /// The smallest on any.
    pub low: f64,
    /// The largest on any.
    pub high: f64,
}

/// The factors of k and μ of the ground that is most likely.
pub const BEST: [f64; 2] = [1.0, 1.0];

impl Answers {
    /// The smallest and the largest value of each field, in the order of [`Field::ALL`], over all combinations on a
    /// ground, with their bands over the grounds; none without a band, or with no solution on the best ground.
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

    /// The smallest and the largest values on a ground; none if nothing is solved there.
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
