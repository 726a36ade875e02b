//! Computes the largest of several polynomials at every point of an interval, and the index of the polynomial that governs.

use crate::numeric::polynomial::{Coefficients, rescale, value};
use crate::numeric::roots::sign_changes;

/// A part of the interval on which one polynomial is the largest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Part {
    /// Left end of the part; both ends are coordinates s ∈ \[−1, 1\].
    pub from: f64,
    pub to: f64,
    /// Index of the largest polynomial on this part.
    pub by: usize,
}

/// Returns the parts of the interval from left to right, each with its largest polynomial. If polynomials
/// differ by no more than `rounding`, the first of them governs.
pub(super) fn parts(curves: &[Coefficients], rounding: f64) -> Vec<Part> {
    let mut parts = vec![Part { from: -1.0, to: 1.0, by: 0 }];
    for by in 1..curves.len() {
        let mut raised: Vec<Part> = Vec::with_capacity(parts.len());
        for part in &parts {
            over(*part, by, curves, rounding, |piece| match raised.last_mut() {
                Some(last) if last.by == piece.by => last.to = piece.to,
                _ => raised.push(piece),
            });
        }
        parts = raised;
    }
    parts
}

/// Divides a part where its polynomial crosses the polynomial `by`. Passes every piece to `push` with the index of its
/// larger polynomial.
fn over(part: Part, by: usize, curves: &[Coefficients], rounding: f64, mut push: impl FnMut(Part)) {
    let rise = difference(&curves[by], &curves[part.by]);
    let whole = part.from == -1.0 && part.to == 1.0;
    let middle = 0.5 * (part.from + part.to);
    let rise = if whole { rise } else { rescale(&rise, middle, 0.5 * (part.to - part.from)) };
    let (Some(constant), spread) =
        (rise.first(), rise.iter().skip(1).map(|c| c.abs()).sum::<f64>())
    else {
        return push(part);
    };
    // `constant + spread` is an upper bound of the difference of the two polynomials. If the bound is at most
    // `rounding`, the part keeps its polynomial.
    if constant + spread <= rounding {
        return push(part);
    }
    let mut cuts = vec![-1.0];
    sign_changes(&rise, &mut cuts);
    cuts.push(1.0);
    for ends in cuts.windows(2) {
        let leads = value(&rise, 0.5 * (ends[0] + ends[1])) > 0.0;
        let [from, to] = [ends[0], ends[1]]
            .map(|s| middle + 0.5 * (part.to - part.from) * s)
            .map(|s| s.clamp(part.from, part.to));
        push(Part { from, to, by: if leads { by } else { part.by } });
    }
}

/// Returns f − g.
fn difference(f: &[f64], g: &[f64]) -> Coefficients {
    let at = |c: &[f64], i: usize| c.get(i).copied().unwrap_or(0.0);
    (0..f.len().max(g.len())).map(|i| at(f, i) - at(g, i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(parts: &[Part]) -> Vec<usize> {
        parts.iter().map(|part| part.by).collect()
    }

    #[test]
    fn lines_and_a_parabola() {
        // The larger of the lines −s and s is |s|. The parabola ¼ + s²/4 is larger than |s| near the middle
        // only.
        let curves = [vec![0.0, -1.0], vec![0.0, 1.0], vec![0.25, 0.0, 0.25]]
            .map(|c| Coefficients::from(&c[..]));
        let found = parts(&curves, 0.0);
        assert_eq!(numbers(&found), [0, 2, 1]);
        // The parabola y = ¼ + s²/4 meets the line y = s at s = 2 − √3, the smaller root of s²/4 − s + ¼ = 0.
        let root = 2.0 - 3.0_f64.sqrt();
        assert!((found[1].from + root).abs() < 1e-15 && (found[2].from - root).abs() < 1e-15);
    }

    #[test]
    fn of_equal_polynomials_the_first_governs() {
        let curves = [vec![1.0, 2.0], vec![1.0, 2.0 + 1e-16], vec![1.0, 2.0]]
            .map(|c| Coefficients::from(&c[..]));
        assert_eq!(numbers(&parts(&curves, 1e-12)), [0]);
    }

    #[test]
    fn maxima_between_roots_are_found() {
        // The Chebyshev polynomial T₄ exceeds the constant −½ on three intervals.
        let curves =
            [vec![-0.5], vec![1.0, 0.0, -8.0, 0.0, 8.0]].map(|c| Coefficients::from(&c[..]));
        assert_eq!(numbers(&parts(&curves, 0.0)), [1, 0, 1, 0, 1]);
    }
}
