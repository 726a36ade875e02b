//! Draws supports as triangles, walls and springs, and hinges as circles.

use super::canvas::Canvas;
use super::paint::{Colour, Fill, Paint, Stroke};
use groundbeam::{Support, SupportKind, model::Acts};

/// Drawn height of a support below the beam.
pub(super) const HEIGHT: f64 = 20.0;

/// Draws a support under the point (x, y) of the beam's underside; `outward` is −1 at the left end, 1 at
/// the right end and 0 between them.
pub(super) fn draw(canvas: &mut Canvas, [x, y]: [f64; 2], support: &Support, outward: f64) {
    match support.acts {
        Acts::Both => {}
        // A seat under the beam represents a support that acts only upward. A loop around the beam represents a
        // support that acts only downward.
        Acts::Up => canvas.line([x - 7.0, y], [x + 7.0, y], stroke(2.2)),
        Acts::Down => {
            let hold_down =
                [[x - 5.0, y + 7.0], [x - 5.0, y - 9.0], [x + 5.0, y - 9.0], [x + 5.0, y + 7.0]];
            canvas.polyline(&hold_down, false, stroke(1.4));
        }
    }
    match support.kind {
        SupportKind::Pinned => {
            let triangle = [[x, y], [x - 8.0, y + 14.0], [x + 8.0, y + 14.0]];
            canvas.polyline(&triangle, true, outlined(Colour::Paper));
            base(canvas, [x, y + 14.0]);
        }
        SupportKind::Fixed if outward != 0.0 => wall(canvas, [x, y - 4.0], outward),
        SupportKind::Fixed => {
            canvas.rect([x - 7.0, y], [14.0, 14.0], Fill::new(Colour::Ink));
            base(canvas, [x, y + 14.0]);
        }
        SupportKind::Spring { spring, rotational_spring } => {
            if spring > 0.0 {
                zigzag(canvas, [x, y]);
                base(canvas, [x, y + 16.0]);
            }
            if rotational_spring > 0.0 {
                spiral(canvas, [x, y + 3.0]);
            }
        }
    }
    canvas.reserve(y + HEIGHT);
}

/// A hinge inside the beam.
pub(super) fn hinge(canvas: &mut Canvas, at: [f64; 2], free: bool) {
    canvas.dot(at, 4.0, outlined(if free { Colour::Paper } else { Colour::Ink }));
}

fn outlined(inside: Colour) -> Paint {
    Fill::new(inside).and(Stroke::new(Colour::Ink, 1.4))
}

fn stroke(width: f64) -> Paint {
    Fill::NONE.and(Stroke::new(Colour::Ink, width))
}

/// Draws the fixed base of a support as a line with hatching below.
fn base(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    canvas.line([x - 12.0, y], [x + 12.0, y], stroke(1.4));
    for i in 0..5 {
        let at = x - 9.0 + 5.0 * f64::from(i);
        canvas.line([at, y], [at - 4.0, y + 4.0], stroke(0.8));
    }
}

fn wall(canvas: &mut Canvas, [x, y]: [f64; 2], outward: f64) {
    canvas.line([x, y - 18.0], [x, y + 18.0], stroke(2.2));
    for i in 0..7 {
        let at = y - 15.0 + 5.5 * f64::from(i);
        canvas.line([x, at], [x + outward * 6.0, at + 5.0], stroke(0.8));
    }
}

fn zigzag(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    let mut points = vec![[x, y]];
    for i in 0..5 {
        let side = if i % 2 == 0 { 5.0 } else { -5.0 };
        points.push([x + side, y + 3.0 + 2.5 * f64::from(i)]);
    }
    points.push([x, y + 16.0]);
    canvas.polyline(&points, false, stroke(1.4));
}

fn spiral(canvas: &mut Canvas, [x, y]: [f64; 2]) {
    let points: Vec<_> = (0..=40)
        .map(|i| {
            let turn = f64::from(i) / 40.0;
            let (sin, cos) = (3.6 * std::f64::consts::PI * turn).sin_cos();
            [x + (2.0 + 8.0 * turn) * cos, y + (2.0 + 8.0 * turn) * sin]
        })
        .collect();
    canvas.polyline(&points, false, stroke(1.2));
}
