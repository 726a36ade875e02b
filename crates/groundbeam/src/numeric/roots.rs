//! Roots of polynomials: sign changes on s ∈ \[−1, 1\], and a test for complex zeros inside a circle.

use super::polynomial::{Coefficients, rescale, value, with_slope};

/// Radius of a circle about s = 0 inside which a polynomial that [varies little](varies_little) has no complex zero.
const ZERO_FREE_RADIUS: f64 = 10.0;

/// Whether the power series of the reciprocal of a polynomial converges at least like the powers of
/// 1/[`ZERO_FREE_RADIUS`].
pub(crate) fn varies_little(c: &[f64]) -> bool {
    is_free_of_zeros(c, ZERO_FREE_RADIUS)
}

/// Whether a polynomial has no complex zero inside the circle |s| = `radius`, by the test of Schur and Cohn.
fn is_free_of_zeros(c: &[f64], radius: f64) -> bool {
    // If |c₀| > Σ|cⱼ| radiusʲ with j ≥ 1, the constant term outweighs all others inside the circle.
    let others = c.iter().skip(1).rev().fold(0.0, |sum, a| (sum + a.abs()) * radius);
    if c.first().is_some_and(|first| first.abs() > others) {
        return true;
    }
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
    // Each step lowers the degree by one and keeps the number of zeros inside the circle.
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

/// Appends the positions in (−1, 1) at which a polynomial changes its sign, from left to right. Bounds from the
/// coefficients exclude intervals without zeros, so the polynomial is not sampled.
pub(crate) fn sign_changes(c: &[f64], roots: &mut Vec<f64>) {
    // Terms of high order are omitted if they are far below the rounding error of the other terms.
    let mut negligible = f64::EPSILON / 16.0 * c.iter().map(|a| a.abs()).sum::<f64>();
    let mut count = c.len();
    while count > 1 && c[count - 1].abs() <= negligible {
        count -= 1;
        negligible -= c[count].abs();
    }
    isolate(&c[..count], [-1.0, 1.0], None, 0, roots);
}

/// Maximum number of halvings of an interval. After this number of halvings the interval counts as a point.
pub(crate) const DEEPEST: u32 = 40;

/// Appends the sign changes on the interval `x` of a polynomial with the local coefficients `c`. Neighbouring intervals
/// share an end value in `ends`, so rounding cannot hide a root there.
fn isolate(c: &[f64], x: [f64; 2], ends: Option<[f64; 2]>, depth: u32, roots: &mut Vec<f64>) {
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
    let ends = ends.unwrap_or_else(|| [-1.0, 1.0].map(|s| value(c, s)));
    let first = rest.first().map_or(0.0, |a| a.abs());
    let place = |s: f64| x[0] + 0.5 * (x[1] - x[0]) * (s + 1.0);
    if first > slope - first || depth >= DEEPEST {
        if differ(ends) {
            roots.push(place(monotone_root(c, [-1.0, 1.0], ends[0])));
        }
        return;
    }
    let beside = beside_middle(c);
    for (middle, ends) in [(-0.5, [ends[0], beside[0]]), (0.5, [beside[1], ends[1]])] {
        if middle > 0.0 && differ(beside) {
            roots.push(place(0.0));
        }
        // Taylor's formula about the middle of this half interval, with a bound of its remainder, can exclude a
        // zero.
        let [f, slope] = with_slope(c, middle);
        if f.abs() > 0.5 * slope.abs() + 0.125 * bend {
            continue;
        }
        let half = [middle - 0.5, middle + 0.5];
        if slope.abs() > 0.5 * bend {
            if differ(ends) {
                roots.push(place(monotone_root(c, half, ends[0])));
            }
        } else {
            isolate(&rescale(c, middle, 0.5), half.map(place), Some(ends), depth + 1, roots);
        }
    }
}

fn differ([left, right]: [f64; 2]) -> bool {
    (left > 0.0 && right < 0.0) || (left < 0.0 && right > 0.0)
}

/// Two numbers that have the signs of a polynomial just left and just right of s = 0. The first nonzero term of
/// the polynomial determines these signs.
fn beside_middle(c: &[f64]) -> [f64; 2] {
    let order = c.iter().position(|&a| a != 0.0).unwrap_or(0);
    let right = c[order];
    [if order % 2 == 1 { -right } else { right }, right]
}

/// Finds the root of a polynomial that is monotone and changes its sign between `low` and `high`. `left` is its value
/// at `low`.
pub(crate) fn monotone_root(c: &[f64], [mut low, mut high]: [f64; 2], left: f64) -> f64 {
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
        // The error of `next` is of the order of the square of the step `next − s`.
        let last = is_inside && (next - s).abs() < 1e-10;
        if next == s || last || high - low < 1e-16 {
            return next;
        }
        s = next;
    }
    s
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::elementary::cos;
    use crate::numeric::polynomial::product;

    #[test]
    fn zeros_inside_a_circle() {
        // The polynomial (s − 3)²(s + 4) = 36 − 15 s − 2 s² + s³ has its zeros at 3 and −4.
        let c = [36.0, -15.0, -2.0, 1.0, 0.0];
        assert!(is_free_of_zeros(&c, 2.999) && !is_free_of_zeros(&c, 3.001));
        // The polynomial (s² + 4)(s − 3) has a pair of complex zeros at ±2i.
        let c = [-12.0, 4.0, -3.0, 1.0];
        assert!(is_free_of_zeros(&c, 1.999) && !is_free_of_zeros(&c, 2.001));
        assert!(is_free_of_zeros(&[2.0, 0.0], 1e9) && !is_free_of_zeros(&[0.0, 1.0], 1e-9));
    }

    /// The polynomial is the derivative of a pressure on soft Winkler springs. Its root s = 0 is the common end of two
    /// intervals.
    #[test]
    fn a_root_between_two_halves() {
        let w = [9.130750818000197e-5, 0.0, -1.0956900980259498e-4, 0.0, 1.826150161472349e-5];
        let rest = [0.0, 8.16100210943466e-15, 0.0, -2.9146436074731087e-16, 0.0, -4.34e-26];
        let c: Vec<f64> = w.into_iter().chain(rest).collect();
        for scale in [1.0, 1.1, 1.3, 1.7, 3.1] {
            let slope: Vec<f64> = (1..c.len()).map(|j| scale * j as f64 * c[j]).collect();
            let mut roots = vec![];
            sign_changes(&slope, &mut roots);
            assert_eq!(roots, [0.0], "{scale}");
        }
        // A double root is not a sign change.
        let mut roots = vec![];
        sign_changes(&[0.0, 0.0, 1.0, 0.0, 0.1, 0.2], &mut roots);
        assert!(roots.is_empty(), "{roots:?}");
    }

    #[test]
    fn all_sign_changes_of_a_chebyshev_polynomial() {
        // The Chebyshev polynomial T₁₀ has its roots at cos((2i−1)π/20).
        let c = [-1.0, 0.0, 50.0, 0.0, -400.0, 0.0, 1120.0, 0.0, -1280.0, 0.0, 512.0];
        let mut roots = vec![];
        sign_changes(&c, &mut roots);
        assert_eq!(roots.len(), 10);
        for (i, r) in roots.iter().rev().enumerate() {
            let exact = cos((2 * i + 1) as f64 * std::f64::consts::PI / 20.0);
            assert!((r - exact).abs() < 1e-13, "{r} {exact}");
        }
    }

    /// The test uses polynomials with real roots at least 0.01 apart and with pairs of complex roots.
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
            assert_eq!(roots.len(), inside.len(), "{c:?}: found {roots:?}, expected {inside:?}");
            for (root, exact) in roots.iter().zip(&inside) {
                assert!((root - exact).abs() < 1e-7, "{c:?}: found {roots:?}, expected {inside:?}");
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
