//! A deflection of beam and ground: the solution itself, or how it answers to a small change.

use super::joint::Joint;
use crate::derivatives::piece::Piece;
use crate::element::operator::ZoneKind;
use crate::ground::link::{between, settled, slope_between};
use crate::numeric::polynomial::{Coefficients, jet};
use crate::numeric::quadrature::gauss;

/// Points of quadrature of a piece.
pub(super) const POINTS: usize = 12;

/// A deflection of beam and ground.
#[derive(Debug, Clone, Default)]
pub(super) struct Field {
    /// The four of every element.
    pub shapes: Vec<[f64; 4]>,
    /// w on every piece, and φ where the beam shears; nothing elsewhere.
    pub curves: Vec<[Coefficients; 2]>,
    /// What the beam makes of u at the ends of the strips of every joint.
    pub heights: Vec<Vec<f64>>,
    /// The same at both ends of every piece off the ground.
    open: Vec<[f64; 2]>,
    /// Where such ground varies, u on the piece.
    settled: Vec<Coefficients>,
    /// The field at the points of quadrature of every piece.
    pub points: Vec<Point>,
}

/// Beam and ground at one place.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Point {
    /// w \[m\] and w'.
    pub w: f64,
    pub slope: f64,
    /// φ, which is w' where the beam does not shear, and w' − φ.
    pub rotation: f64,
    pub strain: f64,
    /// φ' − κ₀ \[1/m\].
    pub bend: f64,
    /// u \[m\] and u'.
    pub u: f64,
    pub rise: f64,
}

impl Field {
    /// A field of which only the four of every element are known.
    pub fn of(shapes: Vec<[f64; 4]>) -> Self {
        Field { shapes, ..Field::default() }
    }

    /// Prepares a field whose curves and heights are known. The solution itself is `loaded`.
    pub fn sample(&mut self, pieces: &[Piece], joints: &[Joint], loaded: bool) {
        self.open = vec![[0.0; 2]; pieces.len()];
        for (joint, heights) in joints.iter().zip(&self.heights) {
            for (strip, ends) in joint.strips.iter().zip(heights.windows(2)) {
                if let Some(piece) = strip {
                    self.open[*piece] = [ends[0], ends[1]];
                }
            }
        }
        let own = |(piece, ends): (&Piece, &[f64; 2])| varying(piece, *ends);
        self.settled = pieces.iter().zip(&self.open).map(own).collect();
        let mut points = Vec::with_capacity(pieces.len() * POINTS);
        for (i, piece) in pieces.iter().enumerate() {
            points.extend(gauss().map(|(s, _)| self.look(piece, i, s, loaded)));
        }
        self.points = points;
    }

    /// Open ground under a beam at rest, from u at both ends of a piece, at the points of quadrature.
    pub fn of_open_ground(piece: &Piece, ends: [f64; 2]) -> Vec<Point> {
        let field = Field {
            curves: vec![[Coefficients::zeros(1), Coefficients::default()]],
            open: vec![ends],
            settled: vec![varying(piece, ends)],
            ..Field::default()
        };
        gauss().map(|(s, _)| field.look(piece, 0, s, false)).collect()
    }

    /// The field with the other sign. Its curves have lost what is imposed on the beam; its points have not.
    pub fn negated(&self) -> Self {
        let mut field = self.clone();
        for v in &mut field.shapes {
            *v = v.map(|v| -v);
        }
        let curves = field.curves.iter_mut().flatten();
        for c in curves.chain(&mut field.settled).flat_map(|c| c.iter_mut()) {
            *c = -*c;
        }
        for heights in field.heights.iter_mut().flatten().chain(field.open.iter_mut().flatten()) {
            *heights = -*heights;
        }
        for point in &mut field.points {
            let Point { w, slope, rotation, strain, bend, u, rise } = *point;
            *point = Point {
                w: -w,
                slope: -slope,
                rotation: -rotation,
                strain: -strain,
                bend: -bend,
                u: -u,
                rise: -rise,
            };
        }
        field
    }

    /// The field at s of a piece.
    pub fn look(&self, piece: &Piece, i: usize, s: f64, loaded: bool) -> Point {
        let (cell, half) = (&piece.cell, piece.half);
        let [curve, turns] = &self.curves[i];
        let [w, dw, ddw, _] = jet(curve, s);
        let (slope, bend) = (dw / half, ddw / (half * half));
        let linear = |[left, right]: [f64; 2]| 0.5 * (left + right) + 0.5 * (right - left) * s;
        let mut point = Point { w, slope, rotation: slope, strain: 0.0, bend, u: w, rise: slope };
        if !turns.is_empty() {
            let [turned, rate, ..] = jet(turns, s);
            (point.rotation, point.strain, point.bend) = (turned, slope - turned, rate / half);
        }
        if piece.touch == ZoneKind::Open {
            [point.u, point.rise] = self.open_ground(piece, i, s);
            if loaded {
                let [own, sinks] = cell.free_field_at(s);
                (point.u, point.rise) = (point.u + own, point.rise + sinks);
            }
        } else if loaded {
            (point.u, point.rise) = (w - linear(cell.gap), slope - cell.gap_slope);
        }
        if loaded {
            point.bend -= linear(cell.curvature);
        }
        point
    }

    /// u and u' of open ground, but for what it settles by itself.
    fn open_ground(&self, piece: &Piece, i: usize, s: f64) -> [f64; 2] {
        let [left, right] = self.open[i];
        if [left, right] == [0.0; 2] {
            return [0.0; 2];
        }
        if !self.settled[i].is_empty() {
            let [u, du, ..] = jet(&self.settled[i], s);
            return [u, du / piece.half];
        }
        let b = (piece.cell.subgrade / piece.cell.shear_layer).sqrt();
        let (bh, t) = (2.0 * b * piece.half, 0.5 * (1.0 + s));
        [between(left, right, bh, t), b * slope_between(left, right, bh, t)]
    }
}

/// u on a piece off the ground where the ground varies; nothing elsewhere.
fn varying(piece: &Piece, ends: [f64; 2]) -> Coefficients {
    let cell = &piece.cell;
    if piece.touch == ZoneKind::Open && cell.shear_layer > 0.0 && cell.ground_varies() {
        settled(&cell.subgrade_along(), &cell.shear_layer_along(), piece.half, ends)
    } else {
        Coefficients::default()
    }
}
