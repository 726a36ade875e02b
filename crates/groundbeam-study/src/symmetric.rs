//! Computes eigenvalues, eigenvectors and Cholesky factors of symmetric matrices.

/// A symmetric matrix, stored row by row.
#[derive(Debug, Clone)]
pub struct Symmetric {
    rows: Vec<Vec<f64>>,
}

/// Eigenvalues in decreasing order, and their unit eigenvectors.
#[derive(Debug, Clone)]
pub struct Eigen {
    pub values: Vec<f64>,
    pub vectors: Vec<Vec<f64>>,
}

impl Symmetric {
    /// The matrix with these entries on and below the diagonal.
    pub fn new(size: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let row = |i: usize| (0..size).map(|j| entry(i.max(j), i.min(j))).collect();
        Symmetric { rows: (0..size).map(row).collect() }
    }

    /// Computes the Cholesky factor L of the matrix L Lᵀ, row by row up to the diagonal. Returns `None` if the
    /// matrix is not positive definite.
    pub fn root(&self) -> Option<Vec<Vec<f64>>> {
        let mut root: Vec<Vec<f64>> = Vec::with_capacity(self.rows.len());
        for (i, row) in self.rows.iter().enumerate() {
            let mut new = Vec::with_capacity(i + 1);
            for (j, above) in root.iter().enumerate() {
                new.push((row[j] - dot(&new, &above[..j])) / above[j]);
            }
            let square = row[i] - dot(&new, &new);
            if square.is_nan() || square <= 0.0 {
                return None;
            }
            new.push(square.sqrt());
            root.push(new);
        }
        Some(root)
    }

    /// Computes all eigenvalues and eigenvectors (Golub and Van Loan, *Matrix computations*, 4th edition, algorithms
    /// 8.3.1 and 8.3.3). The error of an eigenvalue is a few machine epsilons times the largest absolute eigenvalue.
    pub fn eigen(mut self) -> Eigen {
        // The matrix is scaled so that squares of small entries do not underflow.
        let entries = self.rows.iter().flatten();
        let scale = entries.fold(f64::MIN_POSITIVE, |most, entry| most.max(entry.abs()));
        self.rows.iter_mut().flatten().for_each(|entry| *entry /= scale);
        let mut tridiagonal = Tridiagonal::of(self);
        tridiagonal.diagonalise();
        let Tridiagonal { diagonal, vectors, .. } = tridiagonal;
        let values = diagonal.into_iter().map(|value| scale * value);
        let mut pairs: Vec<(f64, Vec<f64>)> = values.zip(vectors).collect();
        pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
        let (values, vectors) = pairs.into_iter().unzip();
        Eigen { values, vectors }
    }
}

/// A symmetric matrix Q T Qᵀ with orthogonal Q and tridiagonal T.
struct Tridiagonal {
    diagonal: Vec<f64>,
    /// The entries of the tridiagonal matrix T next to its diagonal.
    beside: Vec<f64>,
    /// The columns of Q.
    vectors: Vec<Vec<f64>>,
}

impl Tridiagonal {
    /// Makes a matrix tridiagonal by Householder reflections I − 2vvᵀ with unit vectors v. Each reflection clears a
    /// column below the entry next to the diagonal.
    fn of(matrix: Symmetric) -> Self {
        let Symmetric { rows: mut a } = matrix;
        let size = a.len();
        let mut beside = Vec::with_capacity(size);
        let mut mirrors: Vec<Vec<f64>> = Vec::with_capacity(size);
        for k in 0..size.saturating_sub(1) {
            let mut v = a[k][k + 1..].to_vec();
            let length = dot(&v, &v).sqrt();
            // The reflection maps the column to one entry next to the diagonal, ±`length`. Its sign is opposite
            // to that of v₀, so that no cancellation occurs in the reflection vector v.
            let reflected = if v[0] > 0.0 { -length } else { length };
            v[0] -= reflected;
            let norm = dot(&v, &v).sqrt();
            v.iter_mut().for_each(|v| *v = if norm > 0.0 { *v / norm } else { 0.0 });
            // The reflection changes the remaining matrix A to (I − 2vvᵀ) A (I − 2vvᵀ) = A − 2vqᵀ − 2qvᵀ with q =
            // Av − (vᵀAv)v.
            let mut q: Vec<f64> = a[k + 1..].iter().map(|row| dot(&row[k + 1..], &v)).collect();
            let along = dot(&q, &v);
            add(&mut q, -along, &v);
            for (i, row) in a[k + 1..].iter_mut().enumerate() {
                add(&mut row[k + 1..], -2.0 * v[i], &q);
                add(&mut row[k + 1..], -2.0 * q[i], &v);
            }
            beside.push(reflected);
            mirrors.push(v);
        }
        let mut vectors: Vec<Vec<f64>> =
            (0..size).map(|i| (0..size).map(|j| f64::from(i == j)).collect()).collect();
        for vector in &mut vectors {
            for (k, v) in mirrors.iter().enumerate().rev() {
                let part = &mut vector[k + 1..];
                let along = dot(part, v);
                add(part, -2.0 * along, v);
            }
        }
        Tridiagonal { diagonal: (0..size).map(|i| a[i][i]).collect(), beside, vectors }
    }

    /// Computes the eigenvalues by the QR algorithm, from the last entry of the diagonal to the first.
    fn diagonalise(&mut self) {
        let size = self.diagonal.len();
        let entries = self.diagonal.iter().chain(&self.beside);
        let negligible = f64::EPSILON * entries.fold(0.0_f64, |most, entry| most.max(entry.abs()));
        for last in (1..size).rev() {
            while self.beside[last - 1].abs() > negligible {
                let is_cut = |&k: &usize| k == 0 || self.beside[k - 1].abs() <= negligible;
                let first = (0..last).rev().find(is_cut).unwrap_or(0);
                self.step(first, last);
            }
        }
    }

    /// Performs one QR step on the rows `first` to `last`, with the shift of Wilkinson: the eigenvalue of the last two
    /// rows and columns that is nearer to the last diagonal entry.
    fn step(&mut self, first: usize, last: usize) {
        let (d, e) = (&mut self.diagonal, &mut self.beside);
        let half = 0.5 * (d[last - 1] - d[last]);
        let corner = e[last - 1];
        let shift = d[last] - corner * (corner / (half + half.hypot(corner).copysign(half)));
        let (mut x, mut z) = (d[first] - shift, e[first]);
        for k in first..last {
            let length = x.hypot(z);
            let (c, s) = if length > 0.0 { (x / length, z / length) } else { (1.0, 0.0) };
            if k > first {
                e[k - 1] = length;
            }
            let (a, b, g) = (d[k], e[k], d[k + 1]);
            d[k] = c * c * a + 2.0 * c * s * b + s * s * g;
            d[k + 1] = s * s * a - 2.0 * c * s * b + c * c * g;
            e[k] = (c * c - s * s) * b + c * s * (g - a);
            if k + 1 < last {
                (x, z) = (e[k], s * e[k + 1]);
                e[k + 1] *= c;
            }
            let (left, right) = self.vectors.split_at_mut(k + 1);
            for (l, r) in left[k].iter_mut().zip(&mut right[0]) {
                (*l, *r) = (c * *l + s * *r, c * *r - s * *l);
            }
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// a ← a + factor b.
fn add(a: &mut [f64], factor: f64, b: &[f64]) {
    for (a, b) in a.iter_mut().zip(b) {
        *a += factor * b;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_chacha::ChaCha8Rng;
    use rand_core::{Rng, SeedableRng};

    /// Numbers in (−1, 1).
    fn random(size: usize, seed: u64) -> Vec<Vec<f64>> {
        let mut source = ChaCha8Rng::seed_from_u64(seed);
        let mut number = || f64::from(source.next_u32()) / f64::from(1_u32 << 31) - 1.0;
        (0..size).map(|_| (0..size).map(|_| number()).collect()).collect()
    }

    /// Asserts A = V Λ Vᵀ and V Vᵀ = I for a matrix A, to a few rounding errors of its largest eigenvalue. V
    /// contains the eigenvectors, Λ the eigenvalues.
    fn holds(matrix: &Symmetric) -> Eigen {
        let size = matrix.rows.len();
        let eigen = matrix.clone().eigen();
        assert!(eigen.values.is_sorted_by(|a, b| a >= b));
        let scale = eigen.values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let close = 4.0 * f64::EPSILON * size.max(4) as f64;
        for (i, v) in eigen.vectors.iter().enumerate() {
            for (j, other) in eigen.vectors.iter().enumerate() {
                assert!((dot(v, other) - f64::from(i == j)).abs() <= close, "{size}: {i} {j}");
            }
            for (row, entry) in matrix.rows.iter().zip(v) {
                let residual = dot(row, v) - eigen.values[i] * entry;
                assert!(residual.abs() <= close * scale, "{size}: {i} {residual:e}");
            }
        }
        eigen
    }

    #[test]
    fn eigenvalues_of_random_matrices_are_accurate() {
        for size in [0, 1, 2, 3, 4, 7, 20, 61, 120] {
            let entries = random(size, 1);
            let eigen = holds(&Symmetric::new(size, |i, j| entries[i][j]));
            let trace: f64 = (0..size).map(|i| entries[i][i]).sum();
            let sum: f64 = eigen.values.iter().sum();
            assert!((sum - trace).abs() <= 1e-13 * size as f64, "{size}: {sum} {trace}");
        }
    }

    /// Tests the matrix of the second difference, which has n rows, 2 on the diagonal and −1 beside it. Its
    /// eigenvalues are 2 − 2 cos(kπ/(n + 1)) for k = 1, …, n.
    #[test]
    fn eigenvalues_of_the_second_difference_have_their_closed_form() {
        let size = 50;
        let eigen = holds(&Symmetric::new(size, |i, j| match i - j {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        }));
        for (k, value) in eigen.values.iter().rev().enumerate() {
            let angle = std::f64::consts::PI * (k + 1) as f64 / (size + 1) as f64;
            let exact = 2.0 - 2.0 * angle.cos();
            assert!((value - exact).abs() < 1e-14, "{k}: {value} {exact}");
        }
    }

    /// Tests eigenvalues that are equal, zero, or far below the rounding error of the largest eigenvalue.
    #[test]
    fn equal_zero_and_tiny_eigenvalues_are_accurate() {
        let ones = holds(&Symmetric::new(30, |_, _| 1.0));
        assert!((ones.values[0] - 30.0).abs() < 1e-13);
        assert!(ones.values[1..].iter().all(|value| value.abs() < 1e-14));
        holds(&Symmetric::new(30, |i, j| f64::from(i == j)));
        holds(&Symmetric::new(5, |_, _| 0.0));
        holds(&Symmetric::new(12, |i, j| if i == j { 10.0_f64.powi(-3 * i as i32) } else { 0.0 }));
        holds(&Symmetric::new(40, |i, j| (-0.01 * ((i - j) as f64).powi(2)).exp()));
        holds(&Symmetric::new(40, |i, j| 1e-300 * (-0.1 * (i - j) as f64).exp()));
        let eigen = holds(&Symmetric::new(20, |i, j| 1.0 / (i + j + 1) as f64));
        // The largest eigenvalue of the 20 × 20 Hilbert matrix, computed with 50 digits, is 1.9071347204072533.
        assert!((eigen.values[0] - 1.907_134_720_407_253_3).abs() < 1e-15 * 4.0);
    }

    #[test]
    fn the_square_of_a_root_is_the_matrix() {
        for size in [0, 1, 2, 5, 40] {
            let entries = random(size, 2);
            let positive = |i: usize, j: usize| dot(&entries[i], &entries[j]) + f64::from(i == j);
            let root = Symmetric::new(size, positive).root().expect("a positive matrix");
            for i in 0..size {
                for j in 0..=i {
                    let found = dot(&root[i][..=j], &root[j]);
                    assert!((found - positive(i, j)).abs() < 1e-14 * (size + 1) as f64);
                }
            }
        }
        let correlations = |rho: f64| Symmetric::new(3, move |i, j| if i == j { 1.0 } else { rho });
        assert!(correlations(-0.49).root().is_some());
        assert!(correlations(-0.51).root().is_none());
        assert!(correlations(f64::NAN).root().is_none());
    }
}
