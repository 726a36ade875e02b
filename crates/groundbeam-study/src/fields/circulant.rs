//! Computes a random field by circulant embedding: Dietrich and Newsam, *SIAM J. Sci. Comput.* 18 (1997)
//! 1088–1107.
//!
//! The field is periodic on a circle at least twice as long as the beam. The covariance of equidistant points
//! on it is a circulant matrix, which the discrete Fourier transform diagonalises. If all of its eigenvalues
//! are positive, the field on the beam's part of the circle has exactly the required covariance.

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::fmt;
use std::sync::Arc;

/// Maximum length of the circle on which the field is periodic, relative to the smallest possible length.
const LONGEST: usize = 64;
/// A negative eigenvalue is rounding error if its magnitude is below this fraction of the largest eigenvalue.
const ROUNDING: f64 = 1e-10;

/// A random field by circulant embedding: a sum of harmonics with random amplitudes, periodic on a circle of
/// which the beam is a part.
#[derive(Clone)]
pub struct Circulant {
    /// Number of points on the beam.
    count: usize,
    /// Amplitudes √(λ/m) of the m Fourier terms; λ is the eigenvalue of the circulant matrix for a term.
    heights: Vec<f64>,
    transform: Arc<dyn Fft<f64>>,
}

impl fmt::Debug for Circulant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Circulant").field("count", &self.count).finish_non_exhaustive()
    }
}

impl Circulant {
    /// Creates the field from its correlation, which is a function of the number of steps between two points.
    /// Returns `None` if the circulant matrix has a negative eigenvalue for every tried length of the circle.
    pub fn new(count: usize, correlation: impl Fn(usize) -> f64) -> Option<Self> {
        let least = (2 * (count - 1)).max(2).next_power_of_two();
        let mut size = least;
        while size <= LONGEST * least {
            let transform = FftPlanner::new().plan_fft_forward(size);
            let mut row: Vec<Complex<f64>> =
                (0..size).map(|i| Complex::from(correlation(i.min(size - i)))).collect();
            transform.process(&mut row);
            let largest = row.iter().fold(0.0_f64, |most, value| most.max(value.re));
            if row.iter().all(|value| value.re >= -ROUNDING * largest) {
                let height = |value: &Complex<f64>| (value.re.max(0.0) / size as f64).sqrt();
                return Some(Circulant {
                    count,
                    heights: row.iter().map(height).collect(),
                    transform,
                });
            }
            size *= 2;
        }
        None
    }

    /// Number of independent standard normal variables of the field: one for each Fourier term.
    pub fn numbers(&self) -> usize {
        self.heights.len()
    }

    /// Computes the values of the field at its points from independent standard normal numbers. The first
    /// number is the factor of the mean. The following numbers are the factors of the cosine and the sine of
    /// each harmonic, from the longest to the shortest wavelength.
    pub fn of(&self, numbers: &[f64]) -> Vec<f64> {
        let size = self.heights.len();
        let half = size / 2;
        let mut waves = vec![Complex::default(); size];
        waves[0] = Complex::from(self.heights[0] * numbers[0]);
        waves[half] = Complex::from(self.heights[half] * numbers[size - 1]);
        for k in 1..half {
            let height = self.heights[k] * std::f64::consts::FRAC_1_SQRT_2;
            let wave = Complex::new(height * numbers[2 * k - 1], height * numbers[2 * k]);
            waves[k] = wave;
            waves[size - k] = wave.conj();
        }
        self.transform.process(&mut waves);
        waves[..self.count].iter().map(|value| value.re).collect()
    }
}
