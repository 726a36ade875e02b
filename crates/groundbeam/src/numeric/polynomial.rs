//! Polynomials on one stretch of the beam, in the stretch's own coordinate s ∈ \[−1, 1\].
//!
//! A polynomial is a slice of coefficients, constant first. Centred coordinates keep the digits of
//! each derivative: the curvature never has to be found as a difference of deflections.

use std::ops::{Deref, DerefMut};

/// The most coefficients that anything here has: a rotation of 20 times a shear stiffness of degree 5.
pub(crate) const MOST: usize = 25;

/// Coefficients held in place. Cells have a few of these each, made anew in every step: none of them is
/// worth a trip to the heap.
#[derive(Clone, Copy, PartialEq, Default)]
pub(crate) struct Coefficients {
    count: usize,
    held: [f64; MOST],
}

impl Coefficients {
    pub fn zeros(count: usize) -> Self {
        debug_assert!(count <= MOST);
        Coefficients { count: count.min(MOST), held: [0.0; MOST] }
    }

    /// The same polynomial with room for at least `count`.
    pub fn at_least(mut self, count: usize) -> Self {
        debug_assert!(count <= MOST);
        self.count = self.count.max(count.min(MOST));
        self
    }

    /// The highest one.
    pub fn pop(&mut self) -> Option<f64> {
        self.count = self.count.checked_sub(1)?;
        Some(std::mem::take(&mut self.held[self.count]))
    }
}

impl Deref for Coefficients {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.held[..self.count]
    }
}

impl DerefMut for Coefficients {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.held[..self.count]
    }
}

impl From<&[f64]> for Coefficients {
    fn from(c: &[f64]) -> Self {
        let mut all = Self::zeros(c.len());
        let count = all.count;
        all.copy_from_slice(&c[..count]);
        all
    }
}

impl FromIterator<f64> for Coefficients {
    fn from_iter<T: IntoIterator<Item = f64>>(c: T) -> Self {
        let mut all = Self::default();
        for c in c {
            debug_assert!(all.count < MOST);
            if let Some(next) = all.held.get_mut(all.count) {
                *next = c;
                all.count += 1;
            }
        }
        all
    }
}

impl std::fmt::Debug for Coefficients {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

/// f(s).
pub(crate) fn value(c: &[f64], s: f64) -> f64 {
    c.iter().rev().fold(0.0, |sum, &a| sum * s + a)
}

/// f(s) and f'(s), the latter with respect to s.
pub(crate) fn with_slope(c: &[f64], s: f64) -> [f64; 2] {
    c.iter().rev().fold([0.0, 0.0], |[f, d1], &a| [f * s + a, d1 * s + f])
}

/// f(s), f'(s), f''(s), f'''(s), all with respect to s.
pub(crate) fn jet(c: &[f64], s: f64) -> [f64; 4] {
    let (mut f, mut d1, mut d2, mut d3) = (0.0, 0.0, 0.0, 0.0);
    // A beam off the ground is a short polynomial.
    for &a in c.iter().rev().skip_while(|&&a| a == 0.0) {
        d3 = d3 * s + d2;
        d2 = d2 * s + d1;
        d1 = d1 * s + f;
        f = f * s + a;
    }
    [f, d1, 2.0 * d2, 6.0 * d3]
}

/// f(−1) and f(1).
pub(crate) fn ends(c: &[f64]) -> [f64; 2] {
    let [mut even, mut odd] = [0.0; 2];
    for powers in c.chunks(2).rev() {
        even += powers[0];
        odd += powers.get(1).copied().unwrap_or(0.0);
    }
    [even - odd, even + odd]
}

/// The coefficients of df/ds.
pub(crate) fn derivative(c: &[f64]) -> Coefficients {
    let mut out = Coefficients::zeros(c.len().saturating_sub(1));
    for (j, (out, a)) in out.iter_mut().zip(c.iter().skip(1)).enumerate() {
        *out = (j + 1) as f64 * a;
    }
    out
}

/// The coefficients of `start` + ∫ f dx from s = −1, on a stretch of half length `half`.
pub(crate) fn integral(c: &[f64], half: f64, start: f64) -> Coefficients {
    let mut out = Coefficients::zeros(c.len() + 1);
    for ((out, a), part) in out.iter_mut().skip(1).zip(c).zip(&PARTS) {
        *out = half * a * part;
    }
    out[0] = start - ends(&out)[0];
    out
}

/// 1/(j + 1).
const PARTS: [f64; MOST] = {
    let mut all = [0.0; MOST];
    let mut j = 0;
    while j < MOST {
        all[j] = 1.0 / (j + 1) as f64;
        j += 1;
    }
    all
};

/// The coefficients, in t ∈ \[−1, 1\], of f(middle + half·t).
pub(crate) fn rescale(c: &[f64], middle: f64, half: f64) -> Coefficients {
    let mut c = Coefficients::from(c);
    // Repeated synthetic division by (s − middle), then powers of `half`.
    for first in 0..c.len() {
        for j in (first..c.len().saturating_sub(1)).rev() {
            c[j] += middle * c[j + 1];
        }
    }
    let mut power = 1.0;
    for a in c.iter_mut() {
        *a *= power;
        power *= half;
    }
    c
}

/// The coefficients of f·g.
pub(crate) fn product(f: &[f64], g: &[f64]) -> Coefficients {
    let mut out = Coefficients::zeros((f.len() + g.len()).saturating_sub(1));
    for (i, a) in f.iter().enumerate().filter(|(_, a)| **a != 0.0) {
        for (j, b) in g.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

/// Whether f has no zero in the complex plane closer to s = 0 than `radius`: the test of Schur and Cohn,
/// which takes one degree after the other away without moving a zero across the circle.
pub(crate) fn is_free_of_zeros(c: &[f64], radius: f64) -> bool {
    let mut power = 1.0;
    let mut c: Coefficients = c
        .iter()
        .map(|a| {
            let scaled = a * power;
            power *= radius;
            scaled
        })
        .collect();
    while let Some(&last) = c.last() {
        if last != 0.0 || c.len() == 1 {
            break;
        }
        c.pop();
    }
    while c.len() > 1 {
        let (first, last) = (c[0], c[c.len() - 1]);
        let ratio = last / first;
        if ratio.is_nan() || ratio.abs() >= 1.0 {
            return false;
        }
        let degree = c.len() - 1;
        c = (0..degree).map(|i| c[i] - ratio * c[degree - i]).collect();
    }
    c.first().is_some_and(|a| *a != 0.0)
}

/// Where f changes its sign within (−1, 1), from left to right, appended to `roots`.
///
/// The intervals on which f may vanish are told from those on which it cannot by the coefficients
/// alone: |f(s)| ≥ |c₀| − Σ|cⱼ|. Nothing is sampled. A double root, where f touches zero without
/// changing sign, is not reported.
pub(crate) fn sign_changes(c: &[f64], roots: &mut Vec<f64>) {
    // What is added up for nothing: high powers far below the rounding of all the others.
    let mut negligible = f64::EPSILON / 16.0 * c.iter().map(|a| a.abs()).sum::<f64>();
    let mut count = c.len();
    while count > 1 && c[count - 1].abs() <= negligible {
        count -= 1;
        negligible -= c[count].abs();
    }
    isolate(&c[..count], -1.0, 1.0, 0, roots);
}

/// Halvings after which an interval is a point.
const DEEPEST: u32 = 40;

fn isolate(c: &[f64], low: f64, high: f64, depth: u32, roots: &mut Vec<f64>) {
    let Some((&constant, rest)) = c.split_first() else { return };
    let (mut spread, mut slope, mut bend) = (0.0, 0.0, 0.0);
    for (a, j) in rest.iter().map(|a| a.abs()).zip(1_u8..) {
        let j = f64::from(j);
        spread += a;
        slope += j * a;
        bend += j * (j - 1.0) * a;
    }
    let sum = constant.abs() + spread;
    if constant.abs() > spread || sum == 0.0 || sum.is_nan() {
        return;
    }
    let first = rest.first().map_or(0.0, |a| a.abs());
    let place = |s: f64| low + 0.5 * (high - low) * (s + 1.0);
    if first > slope - first || depth >= DEEPEST {
        let left = value(c, -1.0);
        let begins = left == 0.0 && low > -1.0 && crosses_at_left_end(c);
        if begins || left * value(c, 1.0) < 0.0 {
            roots.push(place(monotone_root(c, [-1.0, 1.0], left)));
        }
        return;
    }
    for middle in [-0.5, 0.5] {
        // Taylor's formula about the middle of a half, with all that it leaves out.
        let [f, slope] = with_slope(c, middle);
        if f.abs() > 0.5 * slope.abs() + 0.125 * bend {
            continue;
        }
        let [from, to] = [middle - 0.5, middle + 0.5];
        if slope.abs() > 0.5 * bend {
            let left = value(c, from);
            let begins = left == 0.0 && place(from) > -1.0;
            if begins || left * value(c, to) < 0.0 {
                roots.push(place(monotone_root(c, [from, to], left)));
            }
        } else {
            isolate(&rescale(c, middle, 0.5), place(from), place(to), depth + 1, roots);
        }
    }
}

/// Whether a root exactly at s = −1 is of odd order.
fn crosses_at_left_end(c: &[f64]) -> bool {
    let about_end = rescale(c, -1.0, 1.0);
    about_end.iter().position(|&a| a != 0.0).is_some_and(|order| order % 2 == 1)
}

/// The root of a function monotone between two points that changes sign there: Newton within a bracket.
fn monotone_root(c: &[f64], [mut low, mut high]: [f64; 2], left: f64) -> f64 {
    if left == 0.0 {
        return low;
    }
    let mut s = 0.5 * (low + high);
    for _ in 0..100 {
        let [f, slope] = with_slope(c, s);
        if f == 0.0 {
            return s;
        }
        if (f > 0.0) == (left > 0.0) {
            low = s;
        } else {
            high = s;
        }
        let newton = s - f / slope;
        let is_inside = newton > low && newton < high;
        let next = if is_inside { newton } else { 0.5 * (low + high) };
        // Newton's next step would be the square of this one.
        let last = is_inside && (next - s).abs() < 1e-10;
        if next == s || last || high - low < 1e-16 {
            return next;
        }
        s = next;
    }
    s
}

/// ∫ f⁽ⁿ⁾ g⁽ⁿ⁾ ds over \[−1, 1\] for the derivatives of order n ≤ 2.
pub(crate) fn inner(f: &[f64], g: &[f64], order: usize) -> f64 {
    let differentiated = |c: &[f64]| (0..order).fold(Coefficients::from(c), |c, _| derivative(&c));
    let [f, g] = [f, g].map(differentiated);
    let mut sum = 0.0;
    for (i, a) in f.iter().enumerate() {
        // ∫ s^(i+j) = 2/(i+j+1) for even i + j.
        let pairs =
            g.get(i % 2..).unwrap_or_default().chunks(2).zip(POWERS[(i + i % 2) / 2..].iter());
        sum += a * pairs.map(|(pair, whole)| pair[0] * whole).sum::<f64>();
    }
    sum
}

/// ∫ s^(2n) ds over \[−1, 1\].
pub(crate) const POWERS: [f64; MOST] = {
    let mut all = [0.0; MOST];
    let mut n = 0;
    while n < MOST {
        all[n] = 2.0 / (2 * n + 1) as f64;
        n += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jet_of_a_cubic() {
        // f = 1 + 2s + 3s² + 4s³ at s = ½ by hand.
        assert_eq!(jet(&[1.0, 2.0, 3.0, 4.0], 0.5), [3.25, 8.0, 18.0, 24.0]);
    }

    #[test]
    fn zeros_in_a_circle() {
        // (s − 3)²(s + 4) = 36 − 15 s − 2 s² + s³.
        let c = [36.0, -15.0, -2.0, 1.0, 0.0];
        assert!(is_free_of_zeros(&c, 2.999) && !is_free_of_zeros(&c, 3.001));
        // (s² + 4)(s − 3): a pair beside the axis.
        let c = [-12.0, 4.0, -3.0, 1.0];
        assert!(is_free_of_zeros(&c, 1.999) && !is_free_of_zeros(&c, 2.001));
        assert!(is_free_of_zeros(&[2.0, 0.0], 1e9) && !is_free_of_zeros(&[0.0, 1.0], 1e-9));
    }

    #[test]
    fn rescaling_is_substitution() {
        let c = [1.0, -2.0, 0.5, 3.0, -1.0];
        let r = rescale(&c, 0.3, 0.2);
        for t in [-1.0, -0.25, 0.0, 0.7, 1.0] {
            assert!((value(&r, t) - value(&c, 0.3 + 0.2 * t)).abs() < 1e-14);
        }
    }

    #[test]
    fn all_sign_changes_of_a_chebyshev_polynomial() {
        // T₁₀ has its roots at cos((2i−1)π/20).
        let c = [-1.0, 0.0, 50.0, 0.0, -400.0, 0.0, 1120.0, 0.0, -1280.0, 0.0, 512.0];
        let mut roots = vec![];
        sign_changes(&c, &mut roots);
        assert_eq!(roots.len(), 10);
        for (i, r) in roots.iter().rev().enumerate() {
            let exact = ((2 * i + 1) as f64 * std::f64::consts::PI / 20.0).cos();
            assert!((r - exact).abs() < 1e-13, "{r} {exact}");
        }
    }

    /// Products of real roots, at least 0.01 apart, and of pairs beside the axis.
    #[test]
    fn all_roots_of_random_products() {
        let mut state = 1_u64;
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..3000 {
            let mut c = Coefficients::from(&[1.0][..]);
            let mut inside: Vec<f64> = Vec::new();
            for _ in 0..(8.0 * random()) as usize {
                let root = 3.0 * random() - 1.5;
                if inside.iter().all(|other| (other - root).abs() > 0.01)
                    && (root.abs() - 1.0).abs() > 1e-6
                {
                    c = product(&c, &[-root, 1.0]);
                    inside.push(root);
                }
            }
            for _ in 0..(4.0 * random()) as usize {
                let (re, im) = (4.0 * random() - 2.0, 0.01 + random());
                c = product(&c, &[re * re + im * im, -2.0 * re, 1.0]);
            }
            inside.retain(|root| root.abs() < 1.0);
            inside.sort_by(f64::total_cmp);
            let mut roots = vec![];
            sign_changes(&c, &mut roots);
            assert_eq!(roots.len(), inside.len(), "{c:?}: {roots:?}, not {inside:?}");
            for (root, exact) in roots.iter().zip(&inside) {
                assert!((root - exact).abs() < 1e-7, "{c:?}: {roots:?}, not {inside:?}");
            }
        }
    }

    #[test]
    fn a_root_between_two_halves_is_found_once() {
        let mut roots = vec![];
        sign_changes(&[0.0, 1.0, 0.0, -3.0], &mut roots);
        assert_eq!(roots.len(), 3);
        assert!(roots[1].abs() < 1e-15);
        roots.clear();
        sign_changes(&[0.0, 0.0, 1.0], &mut roots);
        assert!(roots.is_empty(), "a double root changes no sign");
    }
}
