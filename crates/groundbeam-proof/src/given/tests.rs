//! Checks the problem that is built from a model and a claimed solution. Invalid models and solutions must be refused.

#![cfg(test)]

use super::frame;
use crate::answer::{Answer, Piece};
use crate::model::{Action, Acts, Extent, Load, Model, Support, SupportKind};
use crate::read::read_model;
use crate::scalar::Scalar;
use crate::wide::Wide;

fn answer(count: u32) -> Answer {
    let piece = |i: u32| Piece {
        x: [f64::from(i), f64::from(i + 1)],
        half: 0.5,
        deflection: vec![0.0],
        rotation: vec![0.0],
        ..Piece::default()
    };
    Answer { pieces: (0..count).map(piece).collect(), ..Answer::default() }
}

/// Checks that the stiffness μ of the shear layer and the shear stiffness S of the beam jump at the ends of segments,
/// and not inside a segment in which they vary.
#[test]
fn a_node_is_a_step_where_a_coefficient_jumps() {
    for (segments, steps) in [
        ("", [false; 3]),
        ("[[foundation.segment]]\nfrom = 0\nto = 2\nk = 1\nmu = [1, 2]\n", [false, true, false]),
        ("[[foundation.segment]]\nfrom = 0\nto = 2\nk = 1\nmu = [2, 1]\n", [false, false, false]),
        ("[[foundation.segment]]\nfrom = 1\nto = 2\nk = 1\nmu = 3\n", [true, true, false]),
        ("[[foundation.segment]]\nfrom = 1\nto = 3\nk = 1\nmu = [1, 2]\n", [false, false, true]),
        ("[[foundation.segment]]\nfrom = 1\nto = 3\nk = 1\nmu = [2, 1]\n", [true, false, false]),
        (
            "[[foundation.segment]]\nfrom = 0\nto = 1\nk = 1\nmu = 3\n\
             [[foundation.segment]]\nfrom = 1\nto = 2\nk = 1\nmu = 2\n",
            [true, true, false],
        ),
        ("[[foundation.segment]]\nfrom = 1\nto = 4\nk = 2\nmu = 1\n", [false; 3]),
        ("[[beam.segment]]\nfrom = 1\nto = 3\nshear_stiffness = 9\n", [true, false, true]),
        ("[[beam.segment]]\nfrom = 1\nto = 3\nshear_stiffness = 5\nEI = 7\n", [false; 3]),
    ] {
        let text = format!(
            "[beam]\nlength = 4\nEI = 1\nshear_stiffness = 5\n[foundation]\nk = 1\nmu = 1\n{segments}"
        );
        let model = read_model::<Wide>(&text, None).expect("a model");
        let found = frame(&model, &answer(4), None, &[]).expect("a frame");
        assert_eq!([1, 2, 3].map(|i: usize| found.nodes[i].stepped), steps, "{segments}");
    }
}

/// Checks that a load on the ground must act downward, and that a load on the beam must lie on the beam.
#[test]
fn loads_that_the_theorem_does_not_cover_are_refused() {
    let text = "[beam]\nlength = 2\nEI = 1\nshear_stiffness = 5\n[foundation]\nk = 1\nmu = 1\n";
    let model = read_model::<Wide>(text, None).expect("a model");
    let point = |at: f64, size: f64| Extent::Point { at: Wide::of(at), size: Wide::of(size) };
    let spread = |start: f64, end: f64| Extent::Distributed {
        from: Wide::of(0.0),
        to: Wide::of(1.0),
        start: Wide::of(start),
        end: Wide::of(end),
    };
    let beside = Extent::Distributed {
        from: Wide::of(-1.0),
        to: Wide::of(1.0),
        start: Wide::of(1.0),
        end: Wide::of(1.0),
    };
    for (on_ground, extent, right) in [
        (true, point(1.0, 1.0), true),
        (true, point(1.0, 0.0), true),
        (true, point(1.0, -1e-9), false),
        (true, point(-1.0, 1.0), true),
        (true, point(-1.0, -1.0), false),
        (true, spread(1.0, 0.0), true),
        (true, spread(1.0, -1.0), false),
        (true, spread(-1.0, 1.0), false),
        (false, spread(-1.0, 1.0), true),
        (false, beside, false),
        (true, beside, true),
        (false, point(1.0, -1.0), true),
        (false, point(-1.0, 1.0), false),
        (false, point(3.0, 1.0), false),
    ] {
        let mut model = model.clone();
        model.loads.push(Load { action: Action::Force, extent, on_ground });
        assert_eq!(frame(&model, &answer(2), None, &[]).is_ok(), right, "{on_ground} {extent:?}");
    }
}

/// Checks that a curvature at a point and one-way supports that restrain the slope are refused.
#[test]
fn kinds_that_the_theorem_does_not_cover_are_refused() {
    let text = "[beam]\nlength = 2\nEI = 1\nshear_stiffness = 5\n[foundation]\nk = 1\nmu = 1\n";
    let model = read_model::<Wide>(text, None).expect("a model");
    let is_ok = |model: &Model<Wide>| frame(model, &answer(2), None, &[]).is_ok();
    for (action, right) in
        [(Action::Moment, true), (Action::Force, true), (Action::Curvature, false)]
    {
        let mut model = model.clone();
        let extent = Extent::Point { at: Wide::of(1.0), size: Wide::of(1.0) };
        model.loads.push(Load { action, extent, on_ground: false });
        assert_eq!(is_ok(&model), right, "{action:?}");
    }
    let spring = |turning: f64| SupportKind::Spring {
        spring: Wide::of(1.0),
        rotational_spring: Wide::of(turning),
    };
    for (kind, acts, right) in [
        (SupportKind::Pinned, Acts::Up, true),
        (SupportKind::Fixed, Acts::Both, true),
        (SupportKind::Fixed, Acts::Up, false),
        (SupportKind::Fixed, Acts::Down, false),
        (spring(0.0), Acts::Down, true),
        (spring(1.0), Acts::Both, true),
        (spring(1.0), Acts::Up, false),
    ] {
        let mut model = model.clone();
        model.supports.push(Support { at: Wide::of(1.0), kind, settlement: Wide::of(0.0), acts });
        assert_eq!(is_ok(&model), right, "{kind:?} {acts:?}");
    }
    for (axial, right) in [(1.0, true), (0.0, true)] {
        let mut model = model.clone();
        model.beam.axial_force = Wide::of(axial);
        assert_eq!(is_ok(&model), right, "{axial}");
        model.beam.axial_force = Wide::of(axial).widened(2.0);
        assert!(!is_ok(&model), "{axial}");
    }
}

#[test]
fn the_corners_of_the_clearance_are_in_order() {
    let text = "[beam]\nlength = 2\nEI = 1\nshear_stiffness = 5\n[foundation]\nk = 1\n\
        [[gap]]\nat = 0\nvalue = 1\n[[gap]]\nat = 1\nvalue = 2\n[[gap]]\nat = 2\nvalue = 0\n";
    let mut model = read_model::<Wide>(text, None).expect("a model");
    assert!(frame(&model, &answer(2), None, &[]).is_ok());
    model.gap.swap(1, 2);
    assert!(frame(&model, &answer(2), None, &[]).is_err());
}

#[test]
fn a_field_has_at_most_26_coefficients() {
    let text = "[beam]\nlength = 2\nEI = 1\nshear_stiffness = 5\n[foundation]\nk = 1\n";
    let model = read_model::<Wide>(text, None).expect("a model");
    for (count, right) in [(25, true), (26, true), (27, false), (28, false)] {
        let changes: [fn(&mut Piece) -> &mut Vec<f64>; 3] = [
            |piece| &mut piece.deflection,
            |piece| &mut piece.rotation,
            |piece| &mut piece.pressure,
        ];
        for change in changes {
            let mut answer = answer(2);
            *change(&mut answer.pieces[1]) = vec![0.0; count];
            assert_eq!(frame(&model, &answer, None, &[]).is_ok(), right, "{count}");
        }
    }
}
