//! A field by the eigenvectors of its covariance: z(x) = Σ √λᵢ φᵢ(x) ξᵢ.
//!
//! The eigenvalue problem ∫R(x, y) φ(y) dy = λ φ(x) is solved at the field's own points by a rule of quadrature
//! (Nyström's method), so that with all terms the covariance at the points is R exactly.

use groundbeam_file::study::Share;
use nalgebra::DMatrix;

/// The terms that are kept, those of the largest eigenvalues first.
#[derive(Debug, Clone)]
pub struct Expansion {
    /// √λ φ at the points, term by term.
    waves: Vec<Vec<f64>>,
    eigenvalues: Vec<f64>,
    /// The sum of all eigenvalues, those cut off too.
    total: f64,
}

impl Expansion {
    /// By the correlation of two points and the quadrature's weights.
    pub fn new(
        count: usize,
        correlation: impl Fn(usize, usize) -> f64,
        weight: impl Fn(usize) -> f64,
        share: Share,
    ) -> Self {
        let root = |i: usize| weight(i).sqrt();
        let weighted = DMatrix::from_fn(count, count, |i, j| root(i) * correlation(i, j) * root(j));
        let solved = weighted.symmetric_eigen();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| solved.eigenvalues[b].total_cmp(&solved.eigenvalues[a]));
        let positive = |i: &usize| solved.eigenvalues[*i].max(0.0);
        let total: f64 = order.iter().map(positive).sum();
        let terms = match share {
            Share::Terms(terms) => terms.min(count),
            Share::OfVariance(1.0) => count,
            Share::OfVariance(share) => {
                let mut sum = 0.0;
                let reaches = |i: &usize| {
                    sum += positive(i);
                    sum >= share * total
                };
                order.iter().position(reaches).map_or(count, |last| last + 1)
            }
        };
        order.truncate(terms);
        let wave = |&term: &usize| {
            let vector = solved.eigenvectors.column(term);
            // The sign of an eigenvector is free: the entry of the largest size is positive.
            let largest =
                vector.iter().fold(0.0_f64, |m, v| if v.abs() > m.abs() { *v } else { m });
            let scale = positive(&term).sqrt() * largest.signum();
            (0..count).map(|i| scale * vector[i] / root(i)).collect()
        };
        Expansion {
            waves: order.iter().map(wave).collect(),
            eigenvalues: order.iter().map(positive).collect(),
            total,
        }
    }

    /// How many there are.
    pub fn terms(&self) -> usize {
        self.waves.len()
    }

    /// Their eigenvalues, the largest first.
    #[cfg(test)]
    pub fn eigenvalues(&self) -> &[f64] {
        &self.eigenvalues
    }

    /// The share of the variance that they hold.
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
