//! The fields along the beam, dense enough for a picture.

use crate::curve::Jumps;
use crate::size::Sizes;
use groundbeam::{Field, Fields, Solution};

/// Even steps along the beam: finer than a screen.
const EVEN_STEPS: usize = 1200;
/// A point nearer than this to the line between its neighbours is left out, in page units.
const FLAT: f64 = 0.04;

/// Positions and values, with two entries where a field jumps.
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

    /// One field, rounding taken for zero.
    pub fn field(&self, field: Field) -> Vec<(f64, f64)> {
        let value = |fields: &Fields| self.sizes.value(field, fields.get(field));
        self.rows.iter().map(|(x, fields)| (*x, value(fields))).collect()
    }

    /// Something made of the fields, between two positions.
    pub fn between(&self, from: f64, to: f64, value: impl Fn(&Fields) -> f64) -> Vec<(f64, f64)> {
        let inside = self.rows.iter().filter(|(x, _)| *x >= from && *x <= to);
        inside.map(|(x, fields)| (*x, value(fields))).collect()
    }

    pub fn all(&self, value: impl Fn(&Fields) -> f64) -> Vec<(f64, f64)> {
        self.rows.iter().map(|(x, fields)| (*x, value(fields))).collect()
    }
}

/// The same line with fewer points (Ramer, Douglas and Peucker).
pub(super) fn simplified(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut kept = vec![false; points.len()];
    kept[0] = true;
    kept[points.len() - 1] = true;
    let mut open = vec![(0, points.len() - 1)];
    while let Some((first, last)) = open.pop() {
        let farthest = (first + 1..last)
            .map(|i| (i, distance(points[i], points[first], points[last])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((i, distance)) = farthest
            && distance > FLAT
        {
            kept[i] = true;
            open.push((first, i));
            open.push((i, last));
        }
    }
    points.iter().zip(kept).filter(|(_, kept)| *kept).map(|(point, _)| *point).collect()
}

/// From a point to the line between two others.
fn distance([x, y]: [f64; 2], [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> f64 {
    let [dx, dy] = [x2 - x1, y2 - y1];
    let length = dx.hypot(dy);
    if length == 0.0 {
        return (x - x1).hypot(y - y1);
    }
    ((x - x1) * dy - (y - y1) * dx).abs() / length
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_lines_need_two_points() {
        let line: Vec<_> = (0..100).map(|i| [i as f64, 2.0 * i as f64]).collect();
        assert_eq!(simplified(&line), [[0.0, 0.0], [99.0, 198.0]]);
        let jump = [[0.0, 0.0], [1.0, 0.0], [1.0, 5.0], [2.0, 5.0]];
        assert_eq!(simplified(&jump), jump);
    }
}
