//! Computes Sobol's sequence with the direction numbers of Joe and Kuo, scrambled by Owen's method.

use super::mixed;
use std::sync::LazyLock;

/// Number of binary digits of a coordinate that Sobol's sequence determines. They distinguish 2³² points.
const DIGITS: usize = 32;

/// Direction numbers V₁, …, V₃₂ of every available dimension.
static DIRECTIONS: LazyLock<Vec<[u32; DIGITS]>> = LazyLock::new(|| {
    let lines = include_str!("../../data/sobol.txt").lines().filter(|line| !line.starts_with('#'));
    let read = |line: &str| {
        let numbers = line.split(' ').map(|word| word.parse().expect("a number"));
        directions(&numbers.collect::<Vec<u32>>())
    };
    // The first dimension is van der Corput's sequence.
    let first = std::array::from_fn(|i| 1 << (DIGITS - 1 - i));
    std::iter::once(first).chain(lines.map(read)).collect()
});

/// Computes direction numbers from a primitive polynomial and its initial numbers m₁, m₂, …: Joe and Kuo (2008),
/// equations (2.1) to (2.3).
fn directions(numbers: &[u32]) -> [u32; DIGITS] {
    let (polynomial, initial) = (numbers[0], &numbers[1..]);
    let degree = initial.len();
    let mut v = [0_u32; DIGITS];
    for i in 0..DIGITS {
        if i < degree {
            v[i] = initial[i] << (DIGITS - 1 - i);
            continue;
        }
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for j in 1..degree {
            if polynomial >> (degree - j) & 1 == 1 {
                v[i] ^= v[i - j];
            }
        }
    }
    v
}

/// Sobol's sequence in a given number of dimensions. The stored table of direction numbers limits the number of dimensions.
#[derive(Debug, Clone)]
pub struct Sobol {
    dimensions: usize,
}

impl Sobol {
    /// Creates Sobol's sequence in this number of dimensions. Coordinates beyond the available dimensions are
    /// independent random numbers.
    pub fn new(dimensions: usize) -> Self {
        Sobol { dimensions: dimensions.min(DIRECTIONS.len()) }
    }

    /// Computes a coordinate of point `index`: 32 scrambled binary digits of the Sobol point, then the random digits of
    /// `uniform`.
    pub fn coordinate(&self, dimension: usize, index: u64, key: u64, uniform: f64) -> f64 {
        if dimension >= self.dimensions {
            return uniform;
        }
        let digits = scrambled(point(&DIRECTIONS[dimension], index), key);
        let part = 1.0 / (1_u64 << DIGITS) as f64;
        ((f64::from(digits) + uniform) * part).min(1.0 - f64::EPSILON)
    }
}

/// Returns the first 32 binary digits of a coordinate of point `index`, before scrambling.
fn point(directions: &[u32; DIGITS], index: u64) -> u32 {
    let bits = (0..DIGITS).filter(|i| index >> i & 1 == 1);
    bits.fold(0, |digits, i| digits ^ directions[i])
}

/// Applies Owen's nested scrambling, in which the inversion of a digit depends on all digits before it.
fn scrambled(digits: u32, key: u64) -> u32 {
    let mut turned = digits;
    for i in 0..DIGITS {
        let before = if i == 0 { 0 } else { u64::from(digits >> (DIGITS - i)) };
        let turn = mixed(key ^ mixed(before | (i as u64) << 40)) & 1;
        turned ^= (turn as u32) << (DIGITS - 1 - i);
    }
    turned
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares one of our points with point 1000 of the unscrambled Sobol sequence of SciPy 1.17. SciPy orders the
    /// same points by Gray code: its point i is our point i ⊕ (i >> 1).
    #[test]
    fn the_sequence_has_the_points_of_joe_and_kuo() {
        let gray = 1000_u64 ^ (1000 >> 1);
        let found = [0, 1, 2, 50, 100, 255]
            .map(|dimension| f64::from(point(&DIRECTIONS[dimension], gray)) / 2.0_f64.powi(32));
        assert_eq!(found, EXPECTED);
    }

    const EXPECTED: [f64; 6] = [
        0.219_726_562_5,
        0.096_679_687_5,
        0.518_554_687_5,
        0.352_539_062_5,
        0.768_554_687_5,
        0.249_023_437_5,
    ];
}
