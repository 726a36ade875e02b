//! Computes the mean, standard deviation, quantiles and histogram of a series of numbers in three passes with bounded memory.
//!
//! The passes give mean and range ([`Moments`]), counts in many fine bins ([`Counted`]), and the numbers in the bins
//! that contain a quantile ([`Ranked`]). The results are exact.

use std::collections::BTreeMap;

/// Number of fine bins, which are equal parts of the range of the numbers. It is a multiple of every number of
/// histogram bins in [`HISTOGRAMS`].
const PARTS: usize = 20_480;
/// Possible numbers of bins of the reported histogram.
const HISTOGRAMS: [usize; 10] = [1, 2, 4, 5, 8, 10, 16, 20, 32, 40];
/// Probabilities of the reported quantiles, then of the two quartiles.
const QUANTILES: [f64; 7] = [0.0, 0.05, 0.5, 0.95, 1.0, 0.25, 0.75];

/// Count, mean, standard deviation and range of the numbers, computed in the first of three passes. NaN is not counted.
#[derive(Debug, Clone, Copy)]
pub struct Moments {
    count: u64,
    mean: f64,
    /// Sum of squares of the differences from the mean.
    squares: f64,
    range: [f64; 2],
}

impl Moments {
    pub fn new() -> Self {
        Moments { count: 0, mean: 0.0, squares: 0.0, range: [f64::INFINITY, f64::NEG_INFINITY] }
    }

    /// Adds one number (Welford, *Technometrics* 4 (1962)).
    pub fn add(&mut self, value: f64) {
        if value.is_nan() {
            return;
        }
        self.count += 1;
        let apart = value - self.mean;
        self.mean += apart / self.count as f64;
        self.squares += apart * (value - self.mean);
        self.range = [self.range[0].min(value), self.range[1].max(value)];
    }

    /// The largest number; `None` if no number was added.
    pub fn largest(&self) -> Option<f64> {
        (self.count > 0).then_some(self.range[1])
    }

    /// Starts the second pass over the numbers, which counts them in fine bins. Returns `None` if no number was added.
    pub fn counted(self) -> Option<Counted> {
        (self.count > 0).then(|| Counted { moments: self, parts: vec![Part::EMPTY; PARTS] })
    }
}

/// Count and range of the numbers in one fine bin. All bins have the same width.
#[derive(Debug, Clone, Copy)]
struct Part {
    count: u64,
    range: [f64; 2],
}

impl Part {
    const EMPTY: Part = Part { count: 0, range: [f64::INFINITY, f64::NEG_INFINITY] };
}

/// Counts of the numbers in fine bins of equal width, computed in the second of three passes over the numbers.
#[derive(Debug, Clone)]
pub struct Counted {
    moments: Moments,
    parts: Vec<Part>,
}

impl Counted {
    /// Index of the fine bin that contains a number. The index increases with the number.
    fn part(&self, value: f64) -> usize {
        let [from, to] = self.moments.range;
        let place = (value - from) / (to - from) * PARTS as f64;
        // If all numbers are equal, they are counted in the first fine bin.
        if place > 0.0 { (place as usize).min(PARTS - 1) } else { 0 }
    }

    pub fn add(&mut self, value: f64) {
        if value.is_nan() {
            return;
        }
        let part = self.part(value);
        let Part { count, range } = &mut self.parts[part];
        *count += 1;
        *range = [range[0].min(value), range[1].max(value)];
    }

    /// Starts the third pass over the numbers, which collects the numbers in the fine bins that contain a quantile.
    pub fn ranked(self) -> Ranked {
        let mut kept = BTreeMap::new();
        for rank in QUANTILES.into_iter().flat_map(|part| self.ranks(part).0) {
            let (part, _) = self.part_of(rank);
            let [least, most] = self.parts[part].range;
            if least < most {
                kept.insert(part, Vec::new());
            }
        }
        Ranked { counted: self, kept }
    }

    /// Returns the two ranks between which a quantile lies, and the relative position of the quantile between
    /// these ranks (Hyndman and Fan's type 7).
    fn ranks(&self, part: f64) -> ([u64; 2], f64) {
        let last = self.moments.count - 1;
        let place = part * last as f64;
        let below = (place.floor() as u64).min(last);
        ([below, (below + 1).min(last)], place - place.floor())
    }

    /// Returns the fine bin that contains the number of this rank, and the rank of the number within the bin.
    fn part_of(&self, rank: u64) -> (usize, u64) {
        let mut before = 0;
        for (i, part) in self.parts.iter().enumerate() {
            if rank < before + part.count {
                return (i, rank - before);
            }
            before += part.count;
        }
        (PARTS - 1, 0)
    }
}

/// The numbers in the fine bins that contain a quantile, collected in the third pass over all numbers.
#[derive(Debug, Clone)]
pub struct Ranked {
    counted: Counted,
    /// The numbers in each fine bin that contains a quantile, by the index of the bin.
    kept: BTreeMap<usize, Vec<f64>>,
}

/// The reported statistics.
#[derive(Debug, Clone, PartialEq)]
pub struct Statistics {
    pub mean: f64,
    pub deviation: f64,
    /// The smallest number, the 5 %, 50 % and 95 % quantiles, and the largest number.
    pub quantiles: [f64; 5],
    pub histogram: Vec<u64>,
}

impl Ranked {
    pub fn add(&mut self, value: f64) {
        if value.is_nan() {
            return;
        }
        let part = self.counted.part(value);
        if let Some(kept) = self.kept.get_mut(&part) {
            kept.push(value);
        }
    }

    pub fn finish(mut self) -> Statistics {
        for kept in self.kept.values_mut() {
            kept.sort_by(f64::total_cmp);
        }
        let Moments { count, mean, squares, .. } = self.counted.moments;
        let deviation = if count < 2 { 0.0 } else { (squares / (count - 1) as f64).sqrt() };
        let [quantiles @ .., lower, upper] = QUANTILES.map(|part| self.quantile(part));
        Statistics { mean, deviation, quantiles, histogram: self.histogram([lower, upper]) }
    }

    fn quantile(&self, part: f64) -> f64 {
        let (ranks, between) = self.counted.ranks(part);
        let [below, above] = ranks.map(|rank| {
            let (part, place) = self.counted.part_of(rank);
            let kept = self.kept.get(&part).and_then(|kept| kept.get(place as usize));
            kept.copied().unwrap_or(self.counted.parts[part].range[0])
        });
        below + between * (above - below)
    }

    /// Counts the numbers in each bin of a histogram. The bin width is about that of Freedman and Diaconis, *Z.
    /// Wahrscheinlichkeitstheorie* 57 (1981).
    fn histogram(&self, [lower, upper]: [f64; 2]) -> Vec<u64> {
        let Moments { count, range: [least, most], .. } = self.counted.moments;
        let width = 2.0 * (upper - lower) / (count as f64).cbrt();
        let finest = HISTOGRAMS[HISTOGRAMS.len() - 1];
        let advised = match (least < most, width > 0.0) {
            (false, _) => 1.0,
            (true, true) => (most - least) / width,
            // If most numbers are equal, for example zero, the quartiles coincide, and their distance cannot
            // determine the width of the histogram's bins.
            (true, false) => finest as f64,
        };
        let parts = HISTOGRAMS.into_iter().find(|parts| *parts as f64 >= advised).unwrap_or(finest);
        let sum = |parts: &[Part]| parts.iter().map(|part| part.count).sum();
        self.counted.parts.chunks(PARTS / parts).map(sum).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn statistics(values: &[f64]) -> Option<Statistics> {
        let mut moments = Moments::new();
        values.iter().for_each(|value| moments.add(*value));
        let mut counted = moments.counted()?;
        values.iter().for_each(|value| counted.add(*value));
        let mut ranked = counted.ranked();
        values.iter().for_each(|value| ranked.add(*value));
        Some(ranked.finish())
    }

    /// Tests quantiles against those of the sorted numbers. The numbers differ widely, many of them are equal, and
    /// some are NaN.
    #[test]
    fn quantiles_agree_with_sorted_numbers() {
        let mut seed = 1_u64;
        let mut uniform = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for count in [1, 2, 3, 10, 1000, 50_000] {
            for shape in 0..4 {
                let mut draw = || match (shape, uniform()) {
                    (0, u) => u - 0.3,
                    (1, u) => (-u.ln()).powi(9),
                    (2, u) => {
                        if u < 0.9 {
                            0.0
                        } else {
                            u
                        }
                    }
                    (_, u) => {
                        if u < 0.1 {
                            f64::NAN
                        } else {
                            (4.0 * u).floor()
                        }
                    }
                };
                let values: Vec<f64> = (0..count).map(|_| draw()).collect();
                let mut sorted = values.clone();
                sorted.retain(|value| !value.is_nan());
                sorted.sort_by(f64::total_cmp);
                let Some(found) = statistics(&values) else {
                    assert!(sorted.is_empty());
                    continue;
                };
                let n = sorted.len();
                for (part, found) in QUANTILES.into_iter().zip(found.quantiles) {
                    let place = part * (n - 1) as f64;
                    let below = place.floor() as usize;
                    let above = sorted[(below + 1).min(n - 1)];
                    let exact = sorted[below] + (place - place.floor()) * (above - sorted[below]);
                    assert_eq!(found, exact, "{count} {shape} {part}");
                }
                assert_eq!(found.histogram.iter().sum::<u64>(), n as u64);
                let mean = sorted.iter().sum::<f64>() / n as f64;
                let squares: f64 = sorted.iter().map(|value| (value - mean).powi(2)).sum();
                let deviation = if n > 1 { (squares / (n - 1) as f64).sqrt() } else { 0.0 };
                assert!((found.mean - mean).abs() <= 1e-12 * (mean.abs() + deviation));
                assert!((found.deviation - deviation).abs() <= 1e-11 * deviation);
            }
        }
    }

    #[test]
    fn the_numbers_of_histogram_bins_divide_the_number_of_parts() {
        assert!(HISTOGRAMS.iter().all(|parts| PARTS.is_multiple_of(*parts)));
        let found = statistics(&[2.0; 5]).unwrap();
        assert_eq!((found.histogram, found.deviation), (vec![5], 0.0));
        let even: Vec<f64> = (0..1000).map(f64::from).collect();
        assert_eq!(statistics(&even).unwrap().histogram, [100; 10]);
    }
}
