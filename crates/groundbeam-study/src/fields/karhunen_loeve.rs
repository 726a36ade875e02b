//! Computes a random field from the eigenvectors of its covariance: z(x) = Σ √λᵢ φᵢ(x) ξᵢ.
//!
//! λᵢ and φᵢ are the eigenvalues and eigenfunctions of the covariance, and ξᵢ independent standard normal numbers.
//! Nyström's method solves the eigenvalue problem at the field's points. With all terms, the covariance there is exact.

use crate::symmetric::{Eigen, Symmetric};
use groundbeam_file::study::Share;

/// Relative difference below which two entries of an eigenvector count as equal.
const ROUNDING: f64 = 1e-6;

/// The kept terms of the expansion, in the order of decreasing eigenvalues.
#[derive(Debug, Clone)]
pub struct Expansion {
    /// Values √λ φ of each term at the points of the field; λ is the eigenvalue and φ the eigenfunction.
    waves: Vec<Vec<f64>>,
    eigenvalues: Vec<f64>,
    /// The sum of all eigenvalues, including those of the dropped terms.
    total: f64,
}

impl Expansion {
    /// Computes the Karhunen–Loève expansion from the correlations of pairs of points and the quadrature weights.
    pub fn new(
        count: usize,
        correlation: impl Fn(usize, usize) -> f64,
        weight: impl Fn(usize) -> f64,
        share: Share,
    ) -> Self {
        let root = |i: usize| weight(i).sqrt();
        let weighted = Symmetric::new(count, |i, j| root(i) * correlation(i, j) * root(j));
        let Eigen { mut values, mut vectors } = weighted.eigen();
        values.iter_mut().for_each(|value| *value = value.max(0.0));
        let total: f64 = values.iter().sum();
        let terms = match share {
            Share::Terms(terms) => terms.min(count),
            Share::OfVariance(1.0) => count,
            Share::OfVariance(share) => {
                let mut sum = 0.0;
                let reaches = |value: &f64| {
                    sum += value;
                    sum >= share * total
                };
                values.iter().position(reaches).map_or(count, |last| last + 1)
            }
        };
        values.truncate(terms);
        vectors.truncate(terms);
        for (value, vector) in values.iter().zip(&mut vectors) {
            let scale = value.sqrt() * sign(vector);
            vector.iter_mut().enumerate().for_each(|(i, entry)| *entry *= scale / root(i));
        }
        Expansion { waves: vectors, eigenvalues: values, total }
    }

    /// Number of kept terms.
    pub fn terms(&self) -> usize {
        self.waves.len()
    }

    /// The eigenvalues of the kept terms, the largest first.
    #[cfg(test)]
    pub fn eigenvalues(&self) -> &[f64] {
        &self.eigenvalues
    }

    /// Fraction of the variance of the field in the kept terms.
    pub fn variance(&self) -> f64 {
        (self.eigenvalues.iter().sum::<f64>() / self.total).min(1.0)
    }

    /// The field at its points.
    pub fn of(&self, numbers: &[f64]) -> Vec<f64> {
        let mut field = vec![0.0; self.waves.first().map_or(0, Vec::len)];
        for (wave, number) in self.waves.iter().zip(numbers) {
            for (value, height) in field.iter_mut().zip(wave) {
                *value += number * height;
            }
        }
        field
    }
}

/// Returns the sign, 1 or −1, that makes the first entry of largest magnitude positive. Magnitudes count as equal up to
/// `ROUNDING`, because an antisymmetric eigenvector has two largest entries.
fn sign(vector: &[f64]) -> f64 {
    let largest = vector.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
    let first = vector.iter().find(|entry| entry.abs() >= (1.0 - ROUNDING) * largest);
    first.map_or(1.0, |entry| entry.signum())
}
