//! Computes a random field by circulant embedding: Dietrich and Newsam, *SIAM J. Sci. Comput.* 18 (1997) 1088–1107.
//!
//! The field is periodic, so its covariance matrix at equidistant points is circulant. The discrete Fourier transform
//! gives its eigenvalues. If all are positive, the field has exactly the required covariance.

use rustfft::num_complex::Complex;
use rustfft::{Fft, FftPlanner};
use std::fmt;
use std::sync::Arc;

/// Maximum period of the field, relative to the smallest possible period.
const LONGEST: usize = 64;
/// A negative eigenvalue is rounding error if its magnitude is below this fraction of the largest eigenvalue.
const ROUNDING: f64 = 1e-10;

/// A random field as a sum of harmonics with random amplitudes. The period is at least twice the length of the field.
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
    /// Creates the field from its correlation, a function of the number of steps between two points. Returns `None` if
    /// every tried period gives a negative eigenvalue.
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

    /// Computes the values of the field from independent standard normal numbers. They multiply the constant term, then
    /// cosine and sine of each harmonic, from the longest wavelength on.
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
