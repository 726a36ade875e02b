//! Samples the fields along the beam for a picture.

use crate::curve::Jumps;
use crate::size::Sizes;
use groundbeam::{Field, Solution, solution::Fields};

/// Number of equal steps along the beam. A step is shorter than a pixel of a screen.
const EVEN_STEPS: usize = 1200;
/// Maximum number of points that are simplified together, because the time may grow with the square of this
/// number.
const TOGETHER: usize = 4096;
/// Maximum distance of a removed point from the simplified line, in page units.
const FLAT: f64 = 0.04;

/// Values of all fields at positions along the beam. A position at which a field jumps has two entries.
pub(super) struct Samples {
    rows: Vec<(f64, Fields)>,
    pub sizes: Sizes,
}

impl Samples {
    pub fn of(solution: &Solution) -> Self {
        let jumps = Jumps::of(solution);
        let mut rows = Vec::new();
        for x in solution.stations(EVEN_STEPS) {
            let (left, right) = jumps.rows(solution, x);
            rows.extend(left.map(|fields| (x, fields)));
            rows.push((x, right));
        }
        Samples { rows, sizes: Sizes::of(solution) }
    }

    /// Positions and values of one field, with rounding errors set to zero.
    pub fn field(&self, field: Field) -> Vec<(f64, f64)> {
        let value = |fields: &Fields| self.sizes.value(field, fields.get(field));
        self.rows.iter().map(|(x, fields)| (*x, value(fields))).collect()
    }

    /// Positions between `from` and `to`, with the values of a function of the fields.
    pub fn between(&self, from: f64, to: f64, value: impl Fn(&Fields) -> f64) -> Vec<(f64, f64)> {
        let inside = self.rows.iter().filter(|(x, _)| *x >= from && *x <= to);
        inside.map(|(x, fields)| (*x, value(fields))).collect()
    }

    pub fn all(&self, value: impl Fn(&Fields) -> f64) -> Vec<(f64, f64)> {
        self.rows.iter().map(|(x, fields)| (*x, value(fields))).collect()
    }
}

/// Simplifies a line to fewer points by the algorithm of Ramer, Douglas and Peucker. The parts of a very long
/// line are simplified separately.
pub(super) fn simplified(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut kept = vec![false; points.len()];
    for first in (0..points.len()).step_by(TOGETHER) {
        keep(points, first, (first + TOGETHER).min(points.len() - 1), &mut kept);
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

/// Marks the two end points, and the points between them that the simplified line needs.
fn keep(points: &[[f64; 2]], first: usize, last: usize, kept: &mut [bool]) {
    kept[first] = true;
    kept[last] = true;
    let mut open = vec![(first, last)];
    while let Some((first, last)) = open.pop() {
        let distance = distance_to(points[first], points[last]);
        let farthest =
            (first + 1..last).map(|i| (i, distance(points[i]))).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((i, distance)) = farthest
            && distance > FLAT
        {
            kept[i] = true;
            open.push((first, i));
            open.push((i, last));
        }
    }
}

/// Returns a function that computes the distance of a point from the line through two given points.
fn distance_to([x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> impl Fn([f64; 2]) -> f64 {
    let [dx, dy] = [x2 - x1, y2 - y1];
    let length = dx.hypot(dy);
    move |[x, y]| {
        if length == 0.0 {
            return (x - x1).hypot(y - y1);
        }
        ((x - x1) * dy - (y - y1) * dx).abs() / length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_straight_line_is_simplified_to_two_points() {
        let line: Vec<_> = (0..100).map(|i| [i as f64, 2.0 * i as f64]).collect();
        assert_eq!(simplified(&line), [[0.0, 0.0], [99.0, 198.0]]);
        let jump = [[0.0, 0.0], [1.0, 0.0], [1.0, 5.0], [2.0, 5.0]];
        assert_eq!(simplified(&jump), jump);
        assert_eq!(simplified(&jump[..1]), jump[..1]);
        assert_eq!(simplified(&[]), [[0.0; 2]; 0]);
    }

    #[test]
    fn simplifying_a_very_long_line_keeps_its_corners() {
        let saw: Vec<_> = (0..3 * TOGETHER).map(|i| [i as f64, (i % 2) as f64]).collect();
        assert_eq!(simplified(&saw), saw);
        let straight: Vec<_> = (0..3 * TOGETHER).map(|i| [i as f64, 1.0]).collect();
        let ends = [0, TOGETHER, 2 * TOGETHER, 3 * TOGETHER - 1];
        assert_eq!(simplified(&straight), ends.map(|i| [i as f64, 1.0]));
    }
}
