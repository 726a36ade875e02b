//! Elimination of unknowns from a small quadratic form, the energy of a few degrees of freedom.

/// Error of a solve. The bonded system is not positive definite because the contact does not support the beam,
/// or the iteration did not converge.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NotSolved;

/// Quadratic form ½zᵀHz − gᵀz of N unknowns z.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quadratic<const N: usize> {
    pub h: [[f64; N]; N],
    pub g: [f64; N],
}

/// An eliminated unknown as the function `by`·z + `constant` of the remaining unknowns z.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row<const N: usize> {
    pub by: [f64; N],
    pub constant: f64,
}

/// A pivot counts as rounding error if it is below this fraction of the magnitude of its terms.
const PIVOT_ROUNDING: f64 = 1e-15;

impl<const N: usize> Quadratic<N> {
    pub const ZERO: Self = Quadratic { h: [[0.0; N]; N], g: [0.0; N] };

    /// Adds the quadratic form ½vᵀKv − qᵀv of the variables v = `rows`·z.
    pub fn add<const M: usize>(&mut self, rows: &[[f64; N]; M], k: &[[f64; M]; M], q: &[f64; M]) {
        for a in 0..M {
            for (g, by) in self.g.iter_mut().zip(&rows[a]) {
                *g += q[a] * by;
            }
            for b in 0..M {
                if k[a][b] == 0.0 {
                    continue;
                }
                let own = rows[b].map(|by| k[a][b] * by);
                for (h, by) in self.h.iter_mut().zip(&rows[a]).filter(|(_, by)| **by != 0.0) {
                    for (h, own) in h.iter_mut().zip(&own) {
                        *h += by * own;
                    }
                }
            }
        }
    }

    /// Eliminates the unknown e by substituting the function `row` for it. The coefficient of e in `row` is
    /// zero.
    pub fn hold(&mut self, e: usize, row: Row<N>) {
        let Row { by, constant } = row;
        for j in 0..N {
            self.g[j] -= self.h[j][e] * constant;
        }
        for i in (0..N).filter(|i| *i != e) {
            self.g[i] += by[i] * self.g[e];
            for j in 0..N {
                self.h[i][j] += by[i] * self.h[e][j];
            }
        }
        for i in (0..N).filter(|i| *i != e) {
            for j in 0..N {
                self.h[j][i] += by[i] * self.h[j][e];
            }
        }
        self.clear(e);
    }

    /// Eliminates the unknown e by minimising the energy over e. Returns e as a function of the remaining
    /// unknowns. `size` is the magnitude of the terms in the pivot.
    pub fn eliminate(&mut self, e: usize, size: f64) -> Result<Row<N>, NotSolved> {
        let pivot = self.h[e][e];
        if pivot.is_nan() || pivot <= PIVOT_ROUNDING * size || pivot <= 0.0 {
            return Err(NotSolved);
        }
        let mut by = self.h[e].map(|h| -h / pivot);
        by[e] = 0.0;
        let constant = self.g[e] / pivot;
        for i in (0..N).filter(|i| *i != e) {
            self.g[i] += by[i] * self.g[e];
            for j in (0..N).filter(|j| *j != e) {
                self.h[i][j] += by[i] * self.h[e][j];
            }
        }
        self.clear(e);
        Ok(Row { by, constant })
    }

    fn clear(&mut self, e: usize) {
        self.g[e] = 0.0;
        self.h[e] = [0.0; N];
        for row in &mut self.h {
            row[e] = 0.0;
        }
    }
}

impl<const N: usize> Row<N> {
    pub fn value(&self, z: &[f64; N]) -> f64 {
        self.by.iter().zip(z).map(|(by, z)| by * z).sum::<f64>() + self.constant
    }

    /// Eliminates the unknown e from this linear function. `other` gives e as a linear function of the remaining
    /// unknowns.
    pub fn with(mut self, e: usize, other: &Row<N>) -> Self {
        let part = std::mem::take(&mut self.by[e]);
        for (by, other) in self.by.iter_mut().zip(&other.by) {
            *by += part * other;
        }
        self.constant += part * other.constant;
        self
    }
}
