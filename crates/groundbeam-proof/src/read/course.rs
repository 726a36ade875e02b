//! Sums, products and restrictions of quantities along a stretch, which are polynomials in the Bernstein basis.

use crate::{Course, Scalar};

/// The Bernstein coefficients of a quantity. A constant quantity has a single coefficient.
pub(crate) fn values<S: Scalar>(course: &Course<S>) -> &[S] {
    match course {
        Course::Constant(value) => std::slice::from_ref(value),
        Course::Varying(values) => values,
    }
}

fn of<S: Scalar>(values: Vec<S>) -> Course<S> {
    match values[..] {
        [value] => Course::Constant(value),
        _ => Course::Varying(values),
    }
}

/// Whether a quantity is constant along its stretch.
pub(crate) fn is_constant<S>(course: &Course<S>) -> bool {
    matches!(course, Course::Constant(_))
}

/// The values of a quantity at the left and at the right end of its stretch.
pub(crate) fn ends<S: Scalar>(course: &Course<S>) -> [S; 2] {
    let values = values(course);
    [values.first(), values.last()].map(|value| value.copied().unwrap_or(S::zero()))
}

/// The product of two quantities on the same stretch.
pub(crate) fn times<S: Scalar>(a: &Course<S>, b: &Course<S>) -> Course<S> {
    let (a, b) = (values(a), values(b));
    let (m, n) = (a.len() - 1, b.len() - 1);
    let mut product = vec![S::zero(); m + n + 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            let weight = S::of(binomial(m, i) * binomial(n, j));
            product[i + j] = product[i + j] + weight * *x * *y;
        }
    }
    for (k, value) in product.iter_mut().enumerate() {
        *value = value.div(S::of(binomial(m + n, k)));
    }
    of(product)
}

/// The sum of two quantities on the same stretch.
pub(crate) fn plus<S: Scalar>(a: &Course<S>, b: &Course<S>) -> Course<S> {
    let degree = values(a).len().max(values(b).len()) - 1;
    let raised = |course: &Course<S>| {
        let rise = degree + 1 - values(course).len();
        if rise == 0 { course.clone() } else { times(course, &of(vec![S::one(); rise + 1])) }
    };
    let (a, b) = (raised(a), raised(b));
    of(values(&a).iter().zip(values(&b)).map(|(a, b)| *a + *b).collect())
}

/// The product of a quantity and a number.
pub(crate) fn scaled<S: Scalar>(course: &Course<S>, factor: S) -> Course<S> {
    of(values(course).iter().map(|value| *value * factor).collect())
}

/// Restricts a quantity to a part of its stretch. The part begins and ends at the given fractions of the length of the
/// stretch: 0 is the left end of the stretch, and 1 the right end.
pub(crate) fn between<S: Scalar>(course: &Course<S>, [from, to]: [S; 2]) -> Course<S> {
    let given = values(course);
    let degree = given.len() - 1;
    let part = |i: usize| {
        // Computes the blossom of the polynomial by de Casteljau's algorithm with a separate argument on each
        // level.
        let mut values = given.to_vec();
        for level in 0..degree {
            let t = if level + i < degree { from } else { to };
            for j in 0..degree - level {
                values[j] = (S::one() - t) * values[j] + t * values[j + 1];
            }
        }
        values[0]
    };
    of((0..given.len()).map(part).collect())
}

/// The binomial coefficient "n choose k". It is exact for the polynomial degrees that occur here.
fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(course: &Course<f64>, t: f64) -> f64 {
        ends(&between(course, [t, 1.0]))[0]
    }

    #[test]
    fn sums_products_and_parts_are_those_of_the_values() {
        let a = Course::Varying(vec![3.0, 1.0, 4.0, 1.5]);
        let b = Course::Varying(vec![2.0, -1.0]);
        let c = Course::Constant(5.0);
        let part = between(&a, [0.2, 0.7]);
        for t in [0.0, 0.3, 0.6, 1.0] {
            let close = |x: f64, y: f64| assert!((x - y).abs() < 1e-13, "{x} {y}");
            close(at(&times(&a, &b), t), at(&a, t) * at(&b, t));
            close(at(&plus(&a, &b), t), at(&a, t) + at(&b, t));
            close(at(&plus(&a, &c), t), at(&a, t) + 5.0);
            close(at(&part, t), at(&a, 0.2 + 0.5 * t));
            // The Bernstein form of `a` is (1 − t)³·3 + 3t(1 − t)²·1 + 3t²(1 − t)·4 + t³·1.5.
            let s = 1.0 - t;
            close(
                at(&a, t),
                3.0 * s * s * s + 3.0 * t * s * s + 12.0 * t * t * s + 1.5 * t * t * t,
            );
        }
        assert_eq!(times(&c, &Course::Constant(2.0)), Course::Constant(10.0));
    }
}
