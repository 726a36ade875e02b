//! Area, second moment of area and shear area of a cross section, as polynomials of its dimensions.
//!
//! The shear area of a box, an I or a T is the area of the webs between the flanges. The shear areas of other shapes
//! follow from the form factors of Roark's Formulas, 8th ed., 8.10.

use super::course::{plus, scaled, times};
use super::fields::Along;
use super::unit::pi;
use crate::{Course, Scalar};

/// Area, second moment, shear area and depth of a cross section.
#[derive(Debug, Clone)]
pub(crate) struct Shape<S> {
    pub area: Along<S>,
    pub second_moment: Along<S>,
    pub shear_area: Option<Along<S>>,
    /// Depth from the lower to the upper face of the section; `None` if the depth is not known.
    pub depth: Option<Along<S>>,
}

impl<S: Scalar> Shape<S> {
    /// Restricts the cross section to a part of the stretch of the beam to which it applies. The part begins and ends
    /// at the fractions `way` of the length of the stretch.
    pub fn between(&self, way: [S; 2]) -> Self {
        Shape {
            area: self.area.between(way),
            second_moment: self.second_moment.between(way),
            shear_area: self.shear_area.as_ref().map(|along| along.between(way)),
            depth: self.depth.as_ref().map(|along| along.between(way)),
        }
    }
}

/// Area, second moment of area and shear area of a cross section, or the reason why its dimensions are impossible.
pub(crate) type Measures<S> = Result<[Course<S>; 3], &'static str>;

/// n/d.
fn part<S: Scalar>(n: f64, d: f64) -> S {
    S::of(n).div(S::of(d))
}

pub(crate) fn by<S: Scalar>(course: &Course<S>, n: f64, d: f64) -> Course<S> {
    scaled(course, part(n, d))
}

pub(crate) fn less<S: Scalar>(a: &Course<S>, b: &Course<S>) -> Course<S> {
    plus(a, &scaled(b, S::of(-1.0)))
}

/// Computes a − times·b for dimensions `a` and `b` that are linear along the stretch. Fails unless the result is
/// positive at both ends of the stretch.
fn inside<S: Scalar>(a: &Course<S>, b: &Course<S>, times: f64) -> Result<Course<S>, &'static str> {
    let rest = less(a, &scaled(b, S::of(times)));
    let is_possible = super::course::values(&rest).iter().all(|value| value.low() > 0.0);
    is_possible
        .then_some(rest)
        .ok_or("a wall, flange or web is too thick for the dimensions of the section")
}

fn cube<S: Scalar>(a: &Course<S>) -> Course<S> {
    times(&times(a, a), a)
}

pub(crate) fn rectangle<S: Scalar>(b: &Course<S>, h: &Course<S>) -> [Course<S>; 3] {
    let area = times(b, h);
    let second_moment = by(&times(b, &cube(h)), 1.0, 12.0);
    let shear = by(&area, 5.0, 6.0);
    [area, second_moment, shear]
}

pub(crate) fn circle<S: Scalar>(d: &Course<S>) -> Measures<S> {
    let square = times(d, d);
    let pi = pi::<S>().ok_or("π is out of range")?;
    let area = scaled(&square, pi * part(1.0, 4.0));
    let second_moment = scaled(&times(&square, &square), pi * part(1.0, 64.0));
    let shear = by(&area, 9.0, 10.0);
    Ok([area, second_moment, shear])
}

/// A tube with the diameter d and the wall thickness t. It has the area A = π t (d − t) and the second moment of area
/// I = (π/64)(d⁴ − (d − 2t)⁴).
pub(crate) fn tube<S: Scalar>(d: &Course<S>, t: &Course<S>) -> Measures<S> {
    let inner = inside(d, t, 2.0)?;
    let pi = pi::<S>().ok_or("π is out of range")?;
    let area = scaled(&times(t, &less(d, t)), pi);
    let fourth = |d: &Course<S>| times(&times(d, d), &times(d, d));
    let second_moment = scaled(&less(&fourth(d), &fourth(&inner)), pi * part(1.0, 64.0));
    let shear = by(&area, 1.0, 2.0);
    Ok([area, second_moment, shear])
}

/// Area, second moment and shear area of a box with the width b, the height h and the wall thickness t.
pub(crate) fn boxed<S: Scalar>(b: &Course<S>, h: &Course<S>, t: &Course<S>) -> Measures<S> {
    let (width, height) = (inside(b, t, 2.0)?, inside(h, t, 2.0)?);
    let two = scaled(t, S::of(2.0));
    let area = times(&two, &plus(b, &height));
    let second_moment = less(&times(b, &cube(h)), &times(&width, &cube(&height)));
    let shear = times(&two, &height);
    Ok([area, by(&second_moment, 1.0, 12.0), shear])
}

/// Area, second moment and shear area of an I-section with the width b and the height h.
pub(crate) fn i_shape<S: Scalar>(
    b: &Course<S>,
    h: &Course<S>,
    flange: &Course<S>,
    web: &Course<S>,
) -> Measures<S> {
    let height = inside(h, flange, 2.0)?;
    let beside = inside(b, web, 1.0)?;
    let shear = times(web, &height);
    let area = plus(&scaled(&times(b, flange), S::of(2.0)), &shear);
    let second_moment = less(&times(b, &cube(h)), &times(&beside, &cube(&height)));
    Ok([area, by(&second_moment, 1.0, 12.0), shear])
}

/// Adds fillets to the four corners between web and flanges of an I-section.
pub(crate) fn filled<S: Scalar>(
    [area, second_moment, shear]: [Course<S>; 3],
    [b, h, flange, web]: [&Course<S>; 4],
    radius: &Course<S>,
) -> Measures<S> {
    let height = inside(h, flange, 2.0)?;
    inside(&height, radius, 2.0)?;
    inside(&inside(b, web, 1.0)?, radius, 2.0)?;
    let [corners, bent] = corners(&by(&height, 1.0, 2.0), radius)?;
    Ok([plus(&area, &corners), plus(&second_moment, &bent), shear])
}

/// Total area of four corner fillets and their second moment about the middle axis of the section. One side of each
/// fillet lies on a face at the distance `face` from this axis.
pub(crate) fn corners<S: Scalar>(
    face: &Course<S>,
    radius: &Course<S>,
) -> Result<[Course<S>; 2], &'static str> {
    let pi = pi::<S>().ok_or("π is out of range")?;
    // A fillet is a square minus a quarter disc. Its area is (1 − π/4)r², and its first and second moments about the
    // face are (5/6 − π/4)r³ and (1 − 5π/16)r⁴.
    let less_pi = |n: f64, d: f64, times: f64, of: f64| part::<S>(n, d) - pi * part(times, of);
    let square = times(radius, radius);
    let area = scaled(&square, S::of(4.0) * less_pi(1.0, 1.0, 1.0, 4.0));
    let steiner = times(&area, &times(face, face));
    let first = times(face, &times(&square, radius));
    let first = scaled(&first, S::of(8.0) * less_pi(5.0, 6.0, 1.0, 4.0));
    let own = scaled(&times(&square, &square), S::of(4.0) * less_pi(1.0, 1.0, 5.0, 16.0));
    Ok([area, plus(&less(&steiner, &first), &own)])
}

/// Area, second moment and shear area of a T-section with the width b and the height h. The shear area is that of the
/// stem below the flange.
pub(crate) fn t_shape<S: Scalar>(
    b: &Course<S>,
    h: &Course<S>,
    flange: &Course<S>,
    web: &Course<S>,
) -> Measures<S> {
    let stem = inside(h, flange, 1.0)?;
    inside(b, web, 1.0)?;
    let (plate, leg) = (times(b, flange), times(web, &stem));
    let area = plus(&plate, &leg);
    let own = by(&plus(&times(b, &cube(flange)), &times(web, &cube(&stem))), 1.0, 12.0);
    let [whole, _] = super::course::ends(&area);
    // The centroids of flange and stem are h/2 apart.
    let apart = times(&times(&plate, &leg), &times(h, h));
    let steiner = scaled(&apart, S::one().div(S::of(4.0) * whole));
    Ok([area, plus(&own, &steiner), leg])
}

#[cfg(test)]
mod tests {
    use super::super::course::ends;
    use super::*;

    /// Area and second moment about the centroid, as sums over thin strips.
    fn strips(width: impl Fn(f64) -> f64, height: f64) -> [f64; 2] {
        let n = 200_000;
        let step = height / f64::from(n);
        let mut sums = [0.0; 3];
        for i in 0..n {
            let y = (f64::from(i) + 0.5) * step;
            let a = width(y) * step;
            sums[0] += a;
            sums[1] += a * y;
            sums[2] += a * y * y;
        }
        [sums[0], sums[2] - sums[1] * sums[1] / sums[0]]
    }

    #[test]
    fn sections_agree_with_sums_over_thin_strips() {
        let c = |x: f64| Course::Constant(x);
        let is = |measures: Measures<f64>, by: [f64; 2], shear: f64| {
            let found = measures.unwrap().map(|course| ends(&course)[0]);
            for (found, by) in found.iter().zip([by[0], by[1], shear]) {
                assert!((found / by - 1.0).abs() < 1e-5, "{found} {by}");
            }
        };
        is(Ok(rectangle(&c(2.0), &c(1.0))), strips(|_| 2.0, 1.0), 5.0 / 3.0);
        let chord = |d: f64, y: f64| 2.0 * (0.25 * d * d - y * y).max(0.0).sqrt();
        let disc = strips(|y| chord(0.5, y - 0.25), 0.5);
        is(circle(&c(0.5)), disc, 0.9 * disc[0]);
        let ring = strips(|y| chord(0.5, y - 0.25) - chord(0.4, y - 0.25), 0.5);
        is(tube(&c(0.5), &c(0.05)), ring, 0.5 * ring[0]);
        let wall = |y: f64| if !(0.2..=0.8).contains(&y) { 2.0 } else { 0.4 };
        is(boxed(&c(2.0), &c(1.0), &c(0.2)), strips(wall, 1.0), 0.24);
        let i = |y: f64| if !(0.25..=0.75).contains(&y) { 2.0 } else { 0.1 };
        is(i_shape(&c(2.0), &c(1.0), &c(0.25), &c(0.1)), strips(i, 1.0), 0.05);
        // The fillets between web and flanges have the radius 0.2.
        let web = |y: f64| {
            let above = 0.2 - (y - 0.25).min(0.75 - y).min(0.2);
            0.1 + 2.0 * (0.2 - (0.04 - above * above).sqrt())
        };
        let rounded = |y: f64| if !(0.25..=0.75).contains(&y) { 2.0 } else { web(y) };
        let sides = [&c(2.0), &c(1.0), &c(0.25), &c(0.1)];
        let sharp = i_shape(sides[0], sides[1], sides[2], sides[3]).unwrap();
        is(filled(sharp.clone(), sides, &c(0.2)), strips(rounded, 1.0), 0.05);
        assert!(filled(sharp, sides, &c(0.25)).is_err());
        let t = |y: f64| if y < 0.25 { 2.0 } else { 0.5 };
        is(t_shape(&c(2.0), &c(1.0), &c(0.25), &c(0.5)), strips(t, 1.0), 0.375);
    }

    #[test]
    fn one_linear_dimension_makes_a_linear_area() {
        let (a, b) = (Course::Varying(vec![2.0, 1.0]), Course::Constant(0.1));
        let linear = |measures: Measures<f64>| {
            let [area, second_moment, _] = measures.unwrap();
            let count = |course: &Course<f64>| super::super::course::values(course).len();
            (count(&area), count(&second_moment))
        };
        assert_eq!(linear(tube(&a, &b)), (2, 5));
        assert_eq!(linear(boxed(&b.clone(), &a, &Course::Constant(0.01))), (2, 4));
        assert_eq!(
            linear(i_shape(&b, &a, &Course::Constant(0.02), &Course::Constant(0.01))),
            (2, 4)
        );
        assert!(tube(&b, &Course::Constant(0.05)).is_err());
    }
}
