//! Concentrated forces at the ends of a gap just born.

use super::{Joint, Scan};
use crate::contact::forms::inner;
use crate::elements::hermite;
use crate::mesh::Cell;
use crate::polynomial::rescale;

/// Open ground is narrow up to this multiple of √(μ/k), over this many nodes.
const NARROW: f64 = 1e-3;
const MOST_NARROW: usize = 4;
/// Terms of sinh and cosh that a half of that needs.
const WEIGHT_TERMS: usize = 12;

impl Scan<'_> {
    /// The same forces for a joint over narrow open ground, ∫ π φ with −(μφ')' + kφ = 0, φ = 1 at the end
    /// that is asked for and 0 at the other: differences of ψ over a gap just born have lost their digits.
    pub(super) fn pressed(&self, joint: &Joint, at_right: bool) -> Option<f64> {
        let (a, b) = (joint.left?, joint.right?);
        if b.cell > a.cell + MOST_NARROW || self.w.terms <= hermite::TERMS {
            return None;
        }
        let cells = &self.w.mesh.cells[a.cell..=b.cell];
        let ends =
            |i: usize| [if i == a.cell { a.s } else { -1.0 }, if i == b.cell { b.s } else { 1.0 }];
        let span = |i: usize| {
            let [from, to] = ends(i);
            0.5 * (to - from) * self.w.mesh.cells[i].length()
        };
        let length: f64 = (a.cell..=b.cell).map(span).sum();
        let first = &cells[0];
        let rate = (first.spring / first.shear).sqrt();
        let same = |c: &Cell| c.spring == first.spring && c.shear == first.shear;
        if length <= 0.0 || rate * length > NARROW || !cells.iter().all(same) {
            return None;
        }
        let whole = (rate * length).sinh();
        let mut force = 0.0;
        // From the end where φ vanishes.
        let mut behind = 0.0;
        let (count, sign) = (b.cell - a.cell + 1, if at_right { 1.0 } else { -1.0 });
        for step in 0..count {
            let i = if at_right { a.cell + step } else { b.cell - step };
            let [from, to] = ends(i);
            let half = 0.5 * span(i);
            if half > 0.0 {
                let pressure = rescale(&self.pressure(i), 0.5 * (from + to), 0.5 * (to - from));
                let (sinh, cosh) = {
                    let z = rate * (behind + half);
                    (z.sinh() / whole, z.cosh() / whole)
                };
                let mut power = 1.0;
                let weight: [f64; WEIGHT_TERMS] = std::array::from_fn(|j| {
                    let term = power * if j % 2 == 0 { sinh } else { cosh };
                    power *= sign * rate * half / (j + 1) as f64;
                    term
                });
                force += half * inner(&pressure, &weight, 0);
            }
            behind += 2.0 * half;
            if step + 1 < count {
                let node = if at_right { i + 1 } else { i };
                force += self.corner(node) * (rate * behind).sinh() / whole;
            }
        }
        Some(force)
    }
}
