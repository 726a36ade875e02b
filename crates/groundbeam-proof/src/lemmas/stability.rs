//! Compares lower bounds of critical loads with closed forms.

#![cfg(test)]

use crate::answer::{Answer, Piece};
use crate::ball::Ball;
use crate::given::frame;
use crate::model::{Acts, Beam, Ground, GroundEnd, Hinge, Model, Support, SupportKind};
use crate::scalar::Scalar;
use crate::wide::Wide;
use std::f64::consts::PI;

/// Returns a beam of length 1 with EI = 1. Its supports must lie at its ends or quarter points. `shear` is the shear
/// stiffness, and `hinge` the rotational stiffness of a hinge at midspan.
fn beam(
    supports: &[(f64, SupportKind<f64>)],
    shear: Option<f64>,
    hinge: Option<f64>,
) -> Model<f64> {
    let support = |(at, kind): &(f64, SupportKind<f64>)| Support {
        at: *at,
        kind: *kind,
        settlement: 0.0,
        acts: Acts::Both,
    };
    Model {
        beam: Beam {
            length: 1.0,
            bending_stiffness: 1.0,
            shear_stiffness: shear,
            segments: Vec::new(),
            axial_force: 0.0,
        },
        ground: Ground {
            spring: 1.0,
            shear: 0.0,
            segments: Vec::new(),
            ends: [GroundEnd::Endless; 2],
        },
        loads: Vec::new(),
        supports: supports.iter().map(support).collect(),
        hinges: hinge.map(|k| Hinge { at: 0.5, rotational_spring: k }).into_iter().collect(),
        gap: Vec::new(),
    }
}

fn margin(model: &Model<f64>, compression: f64) -> Option<f64> {
    margin_in::<f64>(model, compression)
}

/// Returns the number σ for which the work of a compression is proven to be at most 1 − σ times the strain
/// energy; `None` if no such number is proven.
fn margin_in<S: Scalar>(model: &Model<f64>, compression: f64) -> Option<f64> {
    let length = model.beam.length;
    let support = |support: &Support<f64>| Support {
        at: S::of(support.at),
        kind: match support.kind {
            SupportKind::Pinned => SupportKind::Pinned,
            SupportKind::Fixed => SupportKind::Fixed,
            SupportKind::Spring { spring, rotational_spring } => SupportKind::Spring {
                spring: S::of(spring),
                rotational_spring: S::of(rotational_spring),
            },
        },
        settlement: S::zero(),
        acts: support.acts,
    };
    let hinge = |hinge: &Hinge<f64>| Hinge {
        at: S::of(hinge.at),
        rotational_spring: S::of(hinge.rotational_spring),
    };
    let model = Model {
        beam: Beam {
            length: S::of(model.beam.length),
            bending_stiffness: S::of(model.beam.bending_stiffness),
            shear_stiffness: model.beam.shear_stiffness.map(S::of),
            segments: Vec::new(),
            axial_force: S::of(-compression),
        },
        ground: Ground {
            spring: S::one(),
            shear: S::zero(),
            segments: Vec::new(),
            ends: [GroundEnd::Endless; 2],
        },
        loads: Vec::new(),
        supports: model.supports.iter().map(support).collect(),
        hinges: model.hinges.iter().map(hinge).collect(),
        gap: Vec::new(),
    };
    let rotation = if model.beam.shear_stiffness.is_some() { vec![0.0] } else { Vec::new() };
    let piece = |i: u32| Piece {
        x: [i, i + 1].map(|i| 0.25 * length * f64::from(i)),
        half: 0.125 * length,
        deflection: vec![0.0],
        rotation: rotation.clone(),
        ..Piece::default()
    };
    let answer = Answer { pieces: (0..4).map(piece).collect(), ..Answer::default() };
    let frame = frame(&model, &answer, None, &[]);
    frame.ok().and_then(|frame| frame.compression.map(|compression| compression.margin))
}

#[test]
fn lower_bounds_of_critical_loads_are_sharp() {
    use SupportKind::{Fixed, Pinned};
    let spring = |spring, rotational_spring| SupportKind::Spring { spring, rotational_spring };
    // `tangent` is the smallest positive root of tan z = z, and `held` that of z tan z = 2. Their squares are critical
    // loads.
    let tangent: f64 = 4.493_409_457_909_064;
    let held: f64 = 1.076_873_986_311_804;
    for (supports, hinge, critical) in [
        (vec![(0.0, Pinned), (1.0, Pinned)], None, PI * PI),
        (vec![(0.0, Fixed), (1.0, Pinned)], None, tangent * tangent),
        (vec![(0.0, Fixed), (1.0, Fixed)], None, 4.0 * PI * PI),
        (vec![(0.0, Fixed)], None, 0.25 * PI * PI),
        (vec![(0.0, Pinned), (0.5, Pinned), (1.0, Pinned)], None, 4.0 * PI * PI),
        // For the buckling of a pinned column of length l, a spring with the stiffness 16π²EI/l³ at midspan is as
        // effective as a rigid support.
        (
            vec![(0.0, Pinned), (0.5, spring(16.0 * PI * PI, 0.0)), (1.0, Pinned)],
            None,
            4.0 * PI * PI,
        ),
        // A column with one free end, and a lateral support and a rotational spring k_θ at the other end, has the
        // critical load z² with z tan z = k_θ.
        (vec![(0.0, Pinned), (0.0, spring(0.0, 2.0))], None, held * held),
        (vec![(0.0, Pinned), (1.0, Pinned)], Some(1.0), 4.0 * held_by_hinge()),
    ] {
        let model = beam(&supports, None, hinge);
        assert_eq!(margin(&model, 1.0001 * critical), None, "{supports:?}");
        let left = margin(&model, 0.9 * critical).expect("stable");
        assert!(left <= 0.1 && left > 0.07, "{supports:?}: {left}");
        let left = margin(&model, 0.5 * critical).expect("stable");
        assert!(left <= 0.5 && left > 0.4, "{supports:?}: {left}");
    }
}

/// Checks the critical load P = π²EI/(2l)² of a cantilever.
#[test]
fn the_critical_load_of_a_cantilever_decreases_with_the_square_of_its_length() {
    let mut model = beam(&[(0.0, SupportKind::Fixed)], None, None);
    for length in [0.3, 3.0] {
        model.beam.length = length;
        let critical = (0.5 * PI / length).powi(2);
        assert_eq!(margin(&model, 1.0001 * critical), None, "{length}");
        let left = margin(&model, 0.4 * critical).expect("stable");
        assert!((left - 0.6).abs() < 1e-6, "{length}: {left}");
    }
}

/// Returns a quarter of the critical load of a pinned column with an elastic hinge of stiffness 1 at midspan. By
/// symmetry, it is z² with z tan z = 1.
fn held_by_hinge() -> f64 {
    let z: f64 = 0.860_333_589_019_379_8;
    z * z
}

/// Checks a stiff beam with a soft hinge in ball arithmetic. The critical load 4k_φ/l follows from the equilibrium
/// of two rigid bars.
#[test]
fn a_stiff_beam_on_soft_springs_keeps_its_digits() {
    let ends = [(0.0, SupportKind::Pinned), (1.0, SupportKind::Pinned)];
    let model = beam(&ends, None, Some(1e-6));
    assert_eq!(margin(&model, 4.01e-6), None);
    for digits in [margin_in::<Ball>(&model, 3e-6), margin_in::<Wide>(&model, 3e-6)] {
        let left = digits.expect("stable");
        assert!(left <= 0.25 && left > 0.2, "{left}");
    }
}

#[test]
fn shear_lowers_the_critical_load_of_spans() {
    let ends = [(0.0, SupportKind::Pinned), (1.0, SupportKind::Pinned)];
    let model = beam(&ends, Some(20.0), None);
    let critical = 1.0 / (1.0 / (PI * PI) + 1.0 / 20.0);
    assert_eq!(margin(&model, 1.0001 * critical), None);
    let left = margin(&model, 0.9 * critical).expect("stable");
    assert!((left - 0.1).abs() < 1e-6, "{left}");
}

#[test]
fn an_unsupported_beam_has_no_critical_load() {
    assert_eq!(margin(&beam(&[], None, None), 1e-3), None);
    let hung = beam(&[(0.0, SupportKind::Pinned)], None, None);
    assert_eq!(margin(&hung, 1e-3), None);
}

/// Checks that the larger of two bounds of the margin counts: first the bound from spans, with the longest span ¾, then
/// the bound from elements, with a strong spring at midspan.
#[test]
fn the_larger_of_two_bounds_of_the_margin_counts() {
    let pin = SupportKind::Pinned;
    let found = margin(&beam(&[(0.0, pin), (0.25, pin), (1.0, pin)], None, None), 1.0);
    let exact = 1.0 - 0.5625 / (PI * PI);
    assert!(found.is_some_and(|margin| (margin - exact).abs() < 1e-6), "{found:?} {exact}");
    let spring = SupportKind::Spring { spring: 1e4, rotational_spring: 0.0 };
    let found = margin(&beam(&[(0.0, pin), (0.5, spring), (1.0, pin)], None, None), 6.0);
    let exact = 1.0 - 6.0 / (4.0 * PI * PI);
    assert!(
        found.is_some_and(|margin| (exact - 0.03..exact).contains(&margin)),
        "{found:?} {exact}"
    );
}
