//! Computes Gaussian random fields along the beam from independent standard normal random numbers.

mod circulant;
mod karhunen_loeve;

use circulant::Circulant;
use groundbeam_file::Course;
use groundbeam_file::study::{Correlation, Method, RandomField};
use karhunen_loeve::Expansion;

/// A field of mean 0 and variance 1 at given points.
#[derive(Debug, Clone)]
pub enum Field {
    /// An expansion in eigenvectors of the covariance.
    KarhunenLoeve(Expansion),
    /// A Fourier series with random coefficients on a period longer than the beam (circulant embedding).
    Circulant(Circulant),
}

impl Field {
    /// Creates the random field of a study on a beam of length `beam`. Returns `None` if the circulant embedding
    /// fails.
    pub fn new(random: &RandomField, beam: f64) -> Option<Self> {
        let count = random.points;
        // The points of a piecewise linear field are the ends of its stretches. The points of a piecewise
        // constant field are the middles of its stretches.
        let (first, step) = match random.course {
            Course::Lines => (0.0, beam / (count - 1) as f64),
            Course::Steps => (0.5 * beam / count as f64, beam / count as f64),
        };
        let correlation = |distance: f64| correlation(random.correlation, distance / random.length);
        match random.method {
            Method::Circulant => Circulant::new(count, |steps| correlation(step * steps as f64))
                .map(Field::Circulant),
            Method::KarhunenLoeve(share) => {
                let at: Vec<f64> = (0..count).map(|i| first + step * i as f64).collect();
                // Piecewise linear fields use the trapezoidal rule, piecewise constant fields the midpoint rule.
                let weight = |i: usize| match random.course {
                    Course::Lines if i == 0 || i == count - 1 => 0.5 * step,
                    _ => step,
                };
                let expansion =
                    Expansion::new(count, |i, j| correlation((at[i] - at[j]).abs()), weight, share);
                Some(Field::KarhunenLoeve(expansion))
            }
        }
    }

    /// Number of independent standard normal variables of the random field.
    pub fn numbers(&self) -> usize {
        match self {
            Field::KarhunenLoeve(expansion) => expansion.terms(),
            Field::Circulant(circle) => circle.numbers(),
        }
    }

    /// Fraction of the variance of the field that the kept terms of its series expansion represent.
    pub fn variance(&self) -> f64 {
        match self {
            Field::KarhunenLoeve(expansion) => expansion.variance(),
            Field::Circulant(_) => 1.0,
        }
    }

    /// The field at its points.
    pub fn of(&self, numbers: &[f64]) -> Vec<f64> {
        match self {
            Field::KarhunenLoeve(expansion) => expansion.of(numbers),
            Field::Circulant(circle) => circle.of(numbers),
        }
    }
}

/// Correlation of two points at this distance, measured in correlation lengths.
fn correlation(of: Correlation, distance: f64) -> f64 {
    match of {
        Correlation::Exponential => (-distance).exp(),
        Correlation::Matern3 => {
            let a = 3.0_f64.sqrt() * distance;
            (1.0 + a) * (-a).exp()
        }
        Correlation::Matern5 => {
            let a = 5.0_f64.sqrt() * distance;
            (1.0 + a + a * a / 3.0) * (-a).exp()
        }
        Correlation::Gaussian => (-0.5 * distance * distance).exp(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam_file::study::Share;

    fn random(
        correlation: Correlation,
        length: f64,
        method: Method,
        course: Course,
    ) -> RandomField {
        RandomField { of: Vec::new(), correlation, length, points: 24, course, method, rho: 0.0 }
    }

    /// Tests that the fields have the required covariance. It is A Aᵀ, where column i of A is the field for ξᵢ = 1 and
    /// zeros otherwise.
    #[test]
    fn random_fields_have_the_required_covariance() {
        for which in [
            Correlation::Exponential,
            Correlation::Matern3,
            Correlation::Matern5,
            Correlation::Gaussian,
        ] {
            for (method, course) in [
                (Method::Circulant, Course::Lines),
                (Method::Circulant, Course::Steps),
                (Method::KarhunenLoeve(Share::OfVariance(1.0)), Course::Lines),
                (Method::KarhunenLoeve(Share::Terms(24)), Course::Steps),
            ] {
                let random = random(which, 2.0, method, course);
                let field = Field::new(&random, 12.0).expect("a field");
                let columns: Vec<Vec<f64>> = (0..field.numbers())
                    .map(|i| {
                        field.of(&(0..field.numbers())
                            .map(|j| f64::from(i == j))
                            .collect::<Vec<_>>())
                    })
                    .collect();
                let step = if course == Course::Lines { 12.0 / 23.0 } else { 0.5 };
                for i in 0..24_usize {
                    for j in 0..24 {
                        let found: f64 = columns.iter().map(|column| column[i] * column[j]).sum();
                        let exact = correlation(which, step * i.abs_diff(j) as f64 / 2.0);
                        assert!(
                            (found - exact).abs() < 1e-8,
                            "{which:?} {method:?} {i} {j}: {found} {exact}"
                        );
                    }
                }
            }
        }
    }

    /// Tests the eigenvalues of the exponential correlation on a stretch of length 2a, with the correlation length 1/c:
    /// Ghanem and Spanos, *Stochastic finite elements*, equations (2.39) to (2.47).
    #[test]
    fn eigenvalues_of_the_exponential_correlation_have_their_closed_form() {
        let (a, c) = (1.0_f64, 0.8_f64);
        let root = |even: bool, k: f64| {
            // Finds ωa for the frequency ω by bisection: in (kπ, kπ + π/2) for even eigenfunctions, in (kπ − π/2, kπ)
            // for odd ones.
            let f = |t: f64| match even {
                true => c * a * t.cos() - t * t.sin(),
                false => t * t.cos() + c * a * t.sin(),
            };
            let pi = std::f64::consts::PI;
            let (mut low, mut high) = match even {
                true => (k * pi + 1e-12, (k + 0.5) * pi),
                false => ((k - 0.5) * pi, k * pi - 1e-12),
            };
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if (f(middle) > 0.0) == (f(low) > 0.0) { low = middle } else { high = middle }
            }
            low / a
        };
        let exact = [root(true, 0.0), root(false, 1.0), root(true, 1.0), root(false, 2.0)]
            .map(|omega| 2.0 * c / (omega * omega + c * c));
        let error = |points: usize| {
            let random = RandomField {
                points,
                ..random(
                    Correlation::Exponential,
                    1.0 / c,
                    Method::KarhunenLoeve(Share::Terms(4)),
                    Course::Steps,
                )
            };
            let Some(Field::KarhunenLoeve(expansion)) = Field::new(&random, 2.0 * a) else {
                panic!()
            };
            let found = expansion.eigenvalues();
            exact.iter().zip(found).map(|(e, f)| (e - f).abs()).fold(0.0, f64::max)
        };
        // The error of the eigenvalues of the covariance is of second order in the spacing of the field's points.
        let [coarse, fine] = [64, 128].map(error);
        assert!(fine < 1e-3 && coarse / fine > 3.5 && coarse / fine < 4.5, "{coarse} {fine}");
    }

    #[test]
    fn the_expansion_has_as_many_terms_as_the_variance_needs() {
        let share = |share| {
            let random =
                random(Correlation::Matern5, 3.0, Method::KarhunenLoeve(share), Course::Lines);
            let field = Field::new(&random, 12.0).expect("a field");
            (field.numbers(), field.variance())
        };
        let (count, variance) = share(Share::OfVariance(0.95));
        assert!(variance >= 0.95 && share(Share::Terms(count - 1)).1 < 0.95, "{count} {variance}");
        assert_eq!(share(Share::Terms(1000)).0, 24);
    }
}
