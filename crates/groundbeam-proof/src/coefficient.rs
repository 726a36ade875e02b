//! A coefficient EI, S, k or μ of the equations on one piece, as a constant or a polynomial, with bounds of its values.

use crate::model::Course;
use crate::polynomial::{Line, Polynomial};
use crate::scalar::Scalar;

/// A coefficient EI, S, k or μ on one piece.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Coefficient<S> {
    /// Constant along the piece.
    Even(S),
    /// A polynomial in the local coordinate t of the piece.
    Varying(Box<Varying<S>>),
}

/// A coefficient that varies along a piece.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Varying<S> {
    along: Polynomial<S>,
    /// Lower and upper bound of the coefficient on the piece.
    bounds: [f64; 2],
    /// Values of the coefficient at the two ends of the piece.
    ends: [S; 2],
}

impl<S: Scalar> Coefficient<S> {
    /// Returns the coefficient on a piece from the profile `course` of its segment (0 ≤ s ≤ 1). `line` is s as a
    /// function of t on the piece, between the two `ends`. `scaled` converts values to the units of the proof.
    pub fn of(course: &Course<S>, line: &Line<S>, ends: [S; 2], scaled: impl Fn(S) -> S) -> Self {
        let values: Vec<S> = match course {
            Course::Constant(value) => return Coefficient::Even(scaled(*value)),
            Course::Varying(values) => values.iter().map(|value| scaled(*value)).collect(),
        };
        if values.iter().all(|value| *value == values[0]) {
            return Coefficient::Even(values[0]);
        }
        let controls = controls(&values, ends);
        let mut bounds = [controls[0].low(), controls[0].high()];
        for control in &controls {
            bounds[0] = if control.low() >= bounds[0] { bounds[0] } else { control.low() };
            bounds[1] = if control.high() <= bounds[1] { bounds[1] } else { control.high() };
        }
        let ends = [controls[0], controls[controls.len() - 1]];
        Coefficient::Varying(Box::new(Varying { along: in_powers(&values, line), bounds, ends }))
    }

    /// Returns the value of a constant coefficient, or `None` if the coefficient varies.
    pub fn even(&self) -> Option<S> {
        match self {
            Coefficient::Even(value) => Some(*value),
            Coefficient::Varying(_) => None,
        }
    }

    /// Returns a varying coefficient as a polynomial in the local coordinate t of the piece, or `None` if the
    /// coefficient is constant.
    pub fn along(&self) -> Option<&Polynomial<S>> {
        match self {
            Coefficient::Even(_) => None,
            Coefficient::Varying(varying) => Some(&varying.along),
        }
    }

    /// Returns the coefficient at the left end (`side` = 0) or right end (`side` = 1) of the piece.
    pub fn at_end(&self, side: usize) -> S {
        match self {
            Coefficient::Even(value) => *value,
            Coefficient::Varying(varying) => varying.ends[side],
        }
    }

    /// The product with a field.
    pub fn times(&self, field: Polynomial<S>) -> Polynomial<S> {
        match self {
            Coefficient::Even(value) => field.times(*value),
            Coefficient::Varying(varying) => &field * &varying.along,
        }
    }

    /// Returns a lower bound of the coefficient on the piece.
    pub fn low(&self) -> f64 {
        match self {
            Coefficient::Even(value) => value.low(),
            Coefficient::Varying(varying) => varying.bounds[0],
        }
    }

    /// Returns an upper bound of the coefficient on the piece.
    pub fn high(&self) -> f64 {
        match self {
            Coefficient::Even(value) => value.high(),
            Coefficient::Varying(varying) => varying.bounds[1],
        }
    }

    /// Returns the rounded value of the coefficient at t = 0. The value is used for decisions only; it is not a
    /// bound.
    pub fn middle(&self) -> f64 {
        match self {
            Coefficient::Even(value) => value.middle(),
            Coefficient::Varying(varying) => varying.along.coefficient(0).middle(),
        }
    }

    /// Returns an upper bound of the coefficient on the piece. It also bounds the absolute value, because a
    /// coefficient is never negative.
    pub fn size(&self) -> f64 {
        self.high()
    }

    /// Returns a lower bound of the coefficient on the piece, in the number type of the proof. For a constant
    /// coefficient, it is the exact value.
    pub fn least(&self) -> S {
        self.even().unwrap_or_else(|| S::of(self.low()))
    }
}

/// Computes the Bernstein coefficients of a profile on the interval from s = `a` to s = `b`, by blossoming.
/// `values` are its Bernstein coefficients on 0 ≤ s ≤ 1.
fn controls<S: Scalar>(values: &[S], [a, b]: [S; 2]) -> Vec<S> {
    let degree = values.len() - 1;
    let control = |j: usize| {
        let mut row = values.to_vec();
        for round in 0..degree {
            let s = if round < degree - j { a } else { b };
            row = row.windows(2).map(|pair| (S::one() - s) * pair[0] + s * pair[1]).collect();
        }
        row[0]
    };
    (0..=degree).map(control).collect()
}

/// Converts Bernstein coefficients on 0 ≤ s ≤ 1 to a polynomial in the local coordinate t, by de Casteljau's algorithm.
/// `line` gives s as a function of t.
fn in_powers<S: Scalar>(values: &[S], line: &Line<S>) -> Polynomial<S> {
    let line = Polynomial::zero() + line;
    let rest = Polynomial::from_coefficients([S::one()]) - &line;
    let mut row: Vec<_> =
        values.iter().map(|value| Polynomial::from_coefficients([*value])).collect();
    while row.len() > 1 {
        row = row.windows(2).map(|pair| &pair[0] * &rest + &(&pair[1] * &line)).collect();
    }
    row.pop().unwrap_or_else(Polynomial::zero)
}

#[cfg(test)]
mod tests {
    use super::Coefficient;
    use crate::model::Course;
    use crate::polynomial::{HIGHEST_COURSE, Line, Polynomial};
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::wide::Wide;

    /// Evaluates at s the polynomial with the Bernstein coefficients `values` on 0 ≤ s ≤ 1.
    fn course(values: &[f64], s: f64) -> f64 {
        let n = values.len() - 1;
        let mut sum = 0.0;
        let mut binomial = 1.0;
        for (i, value) in values.iter().enumerate() {
            sum += value * binomial * s.powi(i as i32) * (1.0 - s).powi((n - i) as i32);
            binomial *= (n - i) as f64 / (i + 1) as f64;
        }
        sum
    }

    #[test]
    fn a_profile_keeps_its_values_on_a_part_of_its_segment() {
        let mut random = numbers();
        for case in 0..300 {
            let values: Vec<f64> = (0..2 + case % HIGHEST_COURSE).map(|_| 2.0 + random()).collect();
            let from = 0.5 * (random() + 1.0) * 0.6;
            let to = from + 0.1 + 0.15 * (random() + 1.0);
            let [middle, half] = [0.5 * (from + to), 0.5 * (to - from)].map(Wide::of);
            let exact: Vec<Wide> = values.iter().map(|value| Wide::of(*value)).collect();
            let line = Line::from_coefficients([middle, half]);
            let ends = [middle - half, middle + half];
            let found = Coefficient::of(&Course::Varying(exact), &line, ends, |x| x);
            for step in 0..=20 {
                let t = f64::from(step) / 10.0 - 1.0;
                let s = middle.middle() + half.middle() * t;
                let one = Polynomial::from_coefficients([Wide::of(1.0)]);
                let value = found.times(one).value(Wide::of(t)).middle();
                assert!((value - course(&values, s)).abs() < 1e-14);
                assert!(found.low() <= value + 1e-14 && value <= found.high() + 1e-14);
            }
            for (side, s) in [(0, from), (1, to)] {
                assert!((found.at_end(side).middle() - course(&values, s)).abs() < 1e-14);
            }
        }
    }
}
