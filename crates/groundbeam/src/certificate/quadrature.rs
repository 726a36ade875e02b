//! A piece's polynomials where the proof looks at them: at the points of quadrature and at both ends.

use crate::numeric::polynomial::{Coefficients, derivative, ends};

/// Gauss–Legendre points on \[−1, 1\], exact to degree 23: to rounding for every integrand here.
const GAUSS: [(f64, f64); 6] = [
    (0.125_233_408_511_468_9, 0.249_147_045_813_402_78),
    (0.367_831_498_998_180_2, 0.233_492_536_538_354_82),
    (0.587_317_954_286_617_4, 0.203_167_426_723_065_92),
    (0.769_902_674_194_304_7, 0.160_078_328_543_346_22),
    (0.904_117_256_370_474_9, 0.106_939_325_995_318_43),
    (0.981_560_634_246_719_2, 0.047_175_336_386_511_83),
];

/// Points and weights.
pub(crate) fn gauss() -> impl Iterator<Item = (f64, f64)> {
    GAUSS.iter().flat_map(|&(s, w)| [(-s, w), (s, w)])
}

/// Values at the points, in their order.
pub(super) type AtPoints = [f64; 2 * GAUSS.len()];

/// f at all points. Two that lie at ±s share what the even powers make there and what the odd ones do.
pub(super) fn at_points(c: &[f64]) -> AtPoints {
    let squares = GAUSS.map(|(s, _)| s * s);
    let [mut even, mut odd] = [[0.0; GAUSS.len()]; 2];
    for powers in c.chunks(2).rev() {
        let [upper, lower] = [powers.get(1).copied().unwrap_or(0.0), powers[0]];
        for i in 0..GAUSS.len() {
            even[i] = even[i] * squares[i] + lower;
            odd[i] = odd[i] * squares[i] + upper;
        }
    }
    std::array::from_fn(|i| {
        let odd = GAUSS[i / 2].0 * odd[i / 2];
        if i % 2 == 0 { even[i / 2] - odd } else { even[i / 2] + odd }
    })
}

/// w and its derivatives by s, and the rotation of the sections.
#[derive(Debug)]
pub(super) struct Seen {
    /// w, w' and w″ at the points.
    pub deflection: AtPoints,
    pub slope: AtPoints,
    pub bend: AtPoints,
    /// Where the beam shears, half·φ and its derivative at the points.
    pub turned: Option<[AtPoints; 2]>,
    /// w and w' at both ends.
    pub ends: [[f64; 2]; 2],
    /// w and half·φ, which is w' where the beam does not shear, at both ends.
    pub motion: [[f64; 2]; 2],
}

impl Seen {
    /// How many points there are.
    pub const POINTS: usize = 2 * GAUSS.len();

    pub fn of(deflection: &[f64], rotation: &[f64], half: f64) -> Self {
        let slope = derivative(deflection);
        let turned: Coefficients = rotation.iter().map(|c| half * c).collect();
        let bend = derivative(&slope);
        let ([left, right], [tilt_left, tilt_right]) = (ends(deflection), ends(&slope));
        let sides = [[left, tilt_left], [right, tilt_right]];
        let motion = if turned.is_empty() {
            sides
        } else {
            let [turned_left, turned_right] = ends(&turned);
            [[left, turned_left], [right, turned_right]]
        };
        Seen {
            deflection: at_points(deflection),
            slope: at_points(&slope),
            bend: at_points(&bend),
            turned: (!turned.is_empty())
                .then(|| [at_points(&turned), at_points(&derivative(&turned))]),
            ends: sides,
            motion,
        }
    }
}

/// The larger of two numbers; what is no number is passed over.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The least and the largest of zero and the values seen of a polynomial: what is printed; what is proven
/// is bounded.
pub(super) fn seen_bounds(c: &[f64], points: &AtPoints) -> [f64; 2] {
    let all = points.iter().copied().chain(ends(c));
    all.fold([0.0, 0.0], |[low, high], p| [-larger(-low, -p), larger(high, p)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::polynomial::jet;

    #[test]
    fn points_and_ends_are_where_they_are() {
        for count in [0, 1, 4, 7, 20] {
            let c: Vec<f64> = (0..count).map(|j| 1.0 / f64::from(j + 2)).collect();
            let seen = Seen::of(&c, &[], 1.0);
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-13 * (1.0 + b.abs());
            for (i, (s, _)) in gauss().enumerate() {
                let [w, slope, bend, _] = jet(&c, s);
                assert!(near(seen.deflection[i], w) && near(seen.slope[i], slope));
                assert!(near(seen.bend[i], bend), "{count} {s}");
            }
            for (end, s) in seen.ends.iter().zip([-1.0, 1.0]) {
                let [w, slope, ..] = jet(&c, s);
                assert!(near(end[0], w) && near(end[1], slope));
            }
        }
    }
}
