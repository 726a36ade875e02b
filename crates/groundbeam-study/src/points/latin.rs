//! Computes the coordinates of sample i in a Latin hypercube from a permutation that is evaluated at i only.

use super::mixed;

/// Smallest number of rounds of the Feistel network that permutes the sample indices. With four or more
/// rounds the network is a pseudorandom permutation (Luby and Rackoff 1988).
const ROUNDS: u32 = 6;
/// A Feistel network that permutes indices of 2h bits has `ROUNDS` + `MORE_ROUNDS`/h rounds. One round mixes only a few
/// bits of a short index, so short indices need more rounds.
const MORE_ROUNDS: u32 = 24;

/// Computes a coordinate of a sample: the position `uniform` in one of `count` equal intervals of (0, 1). Each sample
/// has a different interval.
pub fn coordinate(index: u64, count: u64, key: u64, uniform: f64) -> f64 {
    let part = permuted(index, count, key);
    ((part as f64 + uniform) / count as f64).min(1.0 - f64::EPSILON)
}

/// The image of `index` under the permutation of 0, …, `count` − 1 with this key.
fn permuted(index: u64, count: u64, key: u64) -> u64 {
    let bits = u64::BITS - (count - 1).leading_zeros();
    let half = bits.div_ceil(2).max(1);
    // The Feistel network permutes all numbers below 2^(2·half). If the result is not below `count`, it is
    // permuted again until it is.
    let mut image = network(index, half, key);
    while image >= count {
        image = network(image, half, key);
    }
    image
}

/// Applies a Feistel network to a number of 2·half bits.
fn network(number: u64, half: u32, key: u64) -> u64 {
    let mask = (1_u64 << half) - 1;
    let (mut left, mut right) = (number >> half, number & mask);
    for round in 0..ROUNDS + MORE_ROUNDS / half {
        let turned = mixed(key ^ mixed(right ^ (u64::from(round) << 56))) & mask;
        (left, right) = (right, left ^ turned);
    }
    (left << half) | right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_permutation_contains_each_number_once() {
        for count in [1, 2, 3, 5, 16, 17, 1000, 1025] {
            let mut images: Vec<u64> = (0..count).map(|i| permuted(i, count, 99)).collect();
            images.sort_unstable();
            assert!(images.into_iter().eq(0..count), "{count}");
        }
    }

    /// Tests that every image is equally probable over all keys. The tolerance is five standard deviations of χ² with 4
    /// degrees of freedom.
    #[test]
    fn every_image_of_a_permutation_is_equally_probable() {
        for index in 0..5 {
            let mut counts = [0_u32; 5];
            for key in 0..50_000 {
                counts[permuted(index, 5, mixed(key)) as usize] += 1;
            }
            let chi: f64 = counts.iter().map(|c| (f64::from(*c) - 1e4).powi(2) / 1e4).sum();
            assert!(chi < 4.0 + 5.0 * 8.0_f64.sqrt(), "{counts:?}");
        }
    }
}
