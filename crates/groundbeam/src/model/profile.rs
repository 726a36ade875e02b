//! Quantity along a segment, as a polynomial that is given by its control values.
//!
//! A polynomial of degree n has n + 1 control values, which are its Bernstein coefficients. The first and the last
//! control value are its end values. The polynomial lies between its smallest and its largest control value, so
//! positive control values are sufficient for a positive quantity.

/// A quantity along a segment, from the left end to the right end.
///
/// ```
/// use groundbeam::model::Profile;
///
/// // A haunch: the depth is linear, and EI is proportional to its cube.
/// let depth = Profile::linear(1.2, 0.8);
/// let inertia = depth.times(&depth).and_then(|square| square.times(&depth)).unwrap();
/// assert!((inertia.at(0.5) - 1.0).abs() < 1e-15);
/// assert_eq!(Profile::linear(2.0, 2.0), Profile::constant(2.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    values: [f64; Profile::MOST],
    count: usize,
}

impl Profile {
    /// Maximum number of control values. Six values describe a polynomial of degree 5, such as E b d³/12 with linear
    /// modulus E, width b and depth d.
    pub const MOST: usize = 6;

    /// Creates a constant profile.
    pub fn constant(value: f64) -> Self {
        let mut values = [0.0; Self::MOST];
        values[0] = value;
        Profile { values, count: 1 }
    }

    /// Creates a profile that is linear between the values at both ends.
    pub fn linear(start: f64, end: f64) -> Self {
        Self::of(&[start, end])
    }

    /// Creates a profile from its control values (Bernstein coefficients). Returns `None` if `values` is empty or has
    /// more than [`Self::MOST`] entries.
    pub fn by_control_values(values: &[f64]) -> Option<Self> {
        (1..=Self::MOST).contains(&values.len()).then(|| Self::of(values))
    }

    fn of(given: &[f64]) -> Self {
        if given.iter().all(|value| *value == given[0]) {
            return Self::constant(given[0]);
        }
        let mut values = [0.0; Self::MOST];
        values[..given.len()].copy_from_slice(given);
        Profile { values, count: given.len() }
    }

    /// Control values (Bernstein coefficients) of the quantity along the segment. A constant quantity has one control
    /// value.
    pub fn control_values(&self) -> &[f64] {
        &self.values[..self.count]
    }

    /// Whether the quantity is constant.
    pub fn is_constant(&self) -> bool {
        self.count == 1
    }

    /// Value at the left end of the segment.
    pub fn start(&self) -> f64 {
        self.values[0]
    }

    /// Value at the right end of the segment.
    pub fn end(&self) -> f64 {
        self.values[self.count - 1]
    }

    /// Smallest control value (Bernstein coefficient), which is a lower bound of the quantity along the segment.
    pub fn smallest(&self) -> f64 {
        self.control_values().iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Largest control value (Bernstein coefficient), which is an upper bound of the quantity along the segment.
    pub fn largest(&self) -> f64 {
        self.control_values().iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Value at the fraction `t` of the segment's length from the left end.
    pub fn at(&self, t: f64) -> f64 {
        self.blossom(&[[1.0 - t, t]; Self::MOST - 1])
    }

    /// Product of two profiles; `None` if the product needs more than [`Self::MOST`] control values (Bernstein
    /// coefficients).
    pub fn times(&self, other: &Profile) -> Option<Profile> {
        let (m, n) = (self.count - 1, other.count - 1);
        let mut values = [0.0; Self::MOST];
        let product = values.get_mut(..=m + n)?;
        for (i, a) in self.control_values().iter().enumerate() {
            for (j, b) in other.control_values().iter().enumerate() {
                let weight = binomial(m, i) * binomial(n, j) / binomial(m + n, i + j);
                product[i + j] += weight * (a * b);
            }
        }
        Some(Self::of(product))
    }

    /// Returns the quantity multiplied by a factor.
    pub fn scaled(mut self, factor: f64) -> Self {
        for value in &mut self.values {
            *value *= factor;
        }
        self
    }

    /// Profile of the part between two fractions of the segment's length.
    pub fn part(&self, from: f64, to: f64) -> Self {
        let [a, b] = [from, to].map(|t| [1.0 - t, t]);
        Self::of(&self.between(a, b)[..self.count])
    }

    /// Returns the profile of the quantity with the left and the right end of the segment exchanged.
    pub fn mirrored(mut self) -> Self {
        self.values[..self.count].reverse();
        self
    }

    /// The value at x on a segment with the given ends.
    pub(super) fn at_position(&self, ends: [f64; 2], x: f64) -> f64 {
        self.blossom(&[weights(ends, x); Self::MOST - 1])
    }

    /// Polynomial of the quantity on the interval `x` of a segment with the given ends. The variable is s ∈ \[−1, 1\]
    /// along the interval.
    pub(crate) fn on(&self, ends: [f64; 2], x: [f64; 2]) -> CellPolynomial {
        if self.is_constant() {
            return CellPolynomial::constant(self.start());
        }
        let [a, b] = x.map(|x| weights(ends, x));
        let values = self.between(a, b);
        let degree = self.count - 1;
        let mut coefficients = [0.0; Self::MOST];
        for (i, value) in values[..self.count].iter().enumerate() {
            // The i-th Bernstein polynomial of degree n in s is C(n, i) ((1 − s)/2)^(n−i) ((1 + s)/2)^i.
            let scale = binomial(degree, i) / f64::from(1_u32 << degree) * value;
            for (j, c) in coefficients[..self.count].iter_mut().enumerate() {
                *c += scale * bernstein(degree, i, j);
            }
        }
        let values = &values[..=degree];
        let bounds = [
            values.iter().copied().fold(f64::INFINITY, f64::min),
            values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ];
        CellPolynomial { coefficients, ends: [values[0], values[degree]], bounds }
    }

    /// Computes the control values of the profile between the positions `a` and `b`. A position is given by the weights
    /// of both ends of the segment in a linear interpolation.
    fn between(&self, a: [f64; 2], b: [f64; 2]) -> [f64; Self::MOST] {
        let degree = self.count - 1;
        let mut values = [0.0; Self::MOST];
        for (i, value) in values[..self.count].iter_mut().enumerate() {
            *value =
                self.blossom(&std::array::from_fn(|level| if level + i < degree { a } else { b }));
        }
        values
    }

    /// Evaluates the polynomial by De Casteljau's algorithm, with a separate position in each step of the algorithm.
    fn blossom(&self, places: &[[f64; 2]; Self::MOST - 1]) -> f64 {
        let mut values = self.values;
        for (level, [left, right]) in places[..self.count - 1].iter().enumerate() {
            for i in 0..self.count - 1 - level {
                values[i] = left * values[i] + right * values[i + 1];
            }
        }
        values[0]
    }
}

impl From<f64> for Profile {
    fn from(value: f64) -> Self {
        Profile::constant(value)
    }
}

/// A quantity on a stretch of the beam, as a polynomial of s ∈ \[−1, 1\] along the stretch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CellPolynomial {
    /// Coefficients of the powers of s, from the constant term upwards. The coordinate s is −1 and 1 at the ends of the
    /// stretch.
    pub coefficients: [f64; Profile::MOST],
    /// Values of the quantity at both ends of the stretch. Adjacent stretches of a segment have bitwise equal values
    /// at their common end.
    pub ends: [f64; 2],
    /// Lower and upper bound of the quantity on the stretch.
    pub bounds: [f64; 2],
}

impl CellPolynomial {
    pub fn constant(value: f64) -> Self {
        let mut coefficients = [0.0; Profile::MOST];
        coefficients[0] = value;
        CellPolynomial { coefficients, ends: [value; 2], bounds: [value; 2] }
    }
}

/// Weights of both ends in a linear interpolation at x. The weight of one end is the distance of x from the other
/// end, as a fraction of the length.
fn weights([from, to]: [f64; 2], x: f64) -> [f64; 2] {
    let length = to - from;
    [(to - x) / length, (x - from) / length]
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// The coefficient of s^j in (1 − s)^(n−i) (1 + s)^i.
fn bernstein(n: usize, i: usize, j: usize) -> f64 {
    let term = |k: usize| {
        let sign = if (j - k).is_multiple_of(2) { 1.0 } else { -1.0 };
        sign * binomial(i, k) * binomial(n - i, j - k)
    };
    (j.saturating_sub(n - i)..=i.min(j)).map(term).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::polynomial::value;

    #[test]
    fn a_part_of_a_profile_keeps_its_values() {
        let curve = Profile::by_control_values(&[3.0, 1.0, 4.0, 1.0, 5.0, 9.0]).expect("a curve");
        let part = curve.part(0.2, 0.7);
        let course = curve.on([1.0, 3.0], [1.4, 2.4]);
        for s in [-1.0, -0.3, 0.0, 0.6, 1.0] {
            let t = 0.5 * (1.0 + s);
            let exact = curve.at(0.2 + 0.5 * t);
            assert!((part.at(t) - exact).abs() < 1e-14);
            assert!((value(&course.coefficients, s) - exact).abs() < 1e-14);
        }
        let next = curve.on([1.0, 3.0], [2.4, 3.0]);
        assert_eq!(course.ends[1], next.ends[0]);
        assert_eq!(next.ends[1], 9.0);
    }

    #[test]
    fn a_product_has_the_product_of_the_values() {
        let (a, b) = (Profile::linear(2.0, 3.0), Profile::linear(5.0, 1.0));
        let product = a.times(&b).and_then(|p| p.times(&b)).expect("a product");
        for t in [0.0, 0.25, 0.9, 1.0] {
            assert!((product.at(t) - a.at(t) * b.at(t) * b.at(t)).abs() < 1e-14);
        }
        assert_eq!(product.mirrored().at(0.0), product.at(1.0));
        assert_eq!(
            Profile::constant(2.0).times(&Profile::constant(0.1)).map(|p| p.start()),
            Some(0.2)
        );
        let most = Profile::by_control_values(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).expect("a curve");
        assert!(most.times(&a).is_none());
    }
}
