//! Tests of the corrected deflection: supports, jumps between pieces, and closed-form bounds of the correction.

#![cfg(test)]

use super::{Deflection, admissible, bent};
use crate::answer::{Answer, Piece};
use crate::given::frame;
use crate::random::numbers;
use crate::read::read_model;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::wide::Wide;

/// Returns value, slope and curvature of a cubic at the fraction x of a piece of length h. The cubic has the
/// values a and b and the slopes s and t at the ends of the piece.
fn cubic([a, b, s, t]: [f64; 4], h: f64, x: f64) -> [f64; 3] {
    let (square, cube) = (x * x, x * x * x);
    let value = a * (1.0 - 3.0 * square + 2.0 * cube) + b * (3.0 * square - 2.0 * cube);
    let slope = (b - a) * 6.0 * (x - square) / h;
    let curvature = (b - a) * (6.0 - 12.0 * x) / (h * h);
    [
        value + h * (s * (x - 2.0 * square + cube) + t * (cube - square)),
        slope + s * (1.0 - 4.0 * x + 3.0 * square) + t * (3.0 * square - 2.0 * x),
        curvature + (s * (6.0 * x - 4.0) + t * (6.0 * x - 2.0)) / h,
    ]
}

#[test]
fn the_cubic_and_its_derivatives_are_bounded() {
    let values = [-1.0, -0.3, 0.0, 0.6, 1.0];
    for i in 0..625 {
        let ends = [0, 1, 2, 3].map(|j| values[i / 5_usize.pow(j) % 5]);
        for h in [0.01, 1.0, 7.0] {
            let bounds = bent(h, [ends[0], ends[1]], [ends[2], ends[3]]);
            for step in 0..=40 {
                let all = cubic(ends, h, f64::from(step) / 40.0);
                for (value, bound) in all.into_iter().zip(bounds) {
                    let bound = bound.value() * (1.0 + 1e-12);
                    assert!(value.abs() <= bound, "{ends:?} {h}: {value} {bound}");
                }
            }
        }
    }
}

/// Checks that the corrected deflection has no jumps, that its slope jumps only at hinges, and that it satisfies pins
/// and clamps. The claimed deflection and slope jump at every node.
#[test]
fn an_admissible_deflection_has_no_jumps_and_satisfies_the_supports() {
    let mut random = numbers();
    for case in 0..300 {
        let pinned =
            |at: usize| format!("[[support]]\nat = {at}\ntype = 'pinned'\nsettlement = 0.25\n");
        let clamp = |at: usize| format!("[[support]]\nat = {at}\ntype = 'fixed'\n");
        let hinge = |at: usize| format!("[[hinge]]\nat = {at}\n");
        let all = [
            String::new(),
            pinned(2),
            clamp(0),
            pinned(1) + &pinned(4),
            clamp(3) + &hinge(1),
            clamp(5) + &pinned(2),
        ];
        // The pieces of a stiff beam are shorter than (4EI/k)^¼, so their corrections are linear, except on the longest
        // piece between two rigid supports.
        let bending = if case % 2 == 0 { 1000.0 } else { 1e-3 };
        let text = format!(
            "[beam]\nlength = 5\nEI = {bending}\n[foundation]\nk = 1\n{}",
            all[case / 2 % all.len()]
        );
        let model = read_model::<Wide>(&text, None).expect("a model");
        let piece = |i: u32| Piece {
            x: [f64::from(i), f64::from(i + 1)],
            half: 0.5,
            deflection: (0..4).map(|_| 0.1 * random()).collect(),
            ..Piece::default()
        };
        let answer = Answer { pieces: (0..5).map(piece).collect(), ..Answer::default() };
        let frame = frame(&model, &answer, None, &[]).expect("a frame");
        let found = admissible(&frame).expect("a deflection");
        let near = |a: Wide, b: Wide| near(&text, a, b);
        let slope =
            |i: usize, side: usize| found.claimed[i].rotation[side] + found.pieces[i].slope[side];
        for (i, (claimed, c)) in found.claimed.iter().zip(&found.pieces).enumerate() {
            let ends = [0, 1].map(|side| found.values[i + side] - claimed.value[side]);
            near(ends[1] - ends[0], c.rise);
            if bending > 1.0 && c.bounds[2] == Size::ZERO {
                near(c.rise, c.slope[0] * frame.spans[i].h);
                near(c.slope[0], c.slope[1]);
            }
            for side in [0, 1] {
                assert!(ends[side].size() <= c.bounds[0].value() + 1e-12);
                assert!(c.slope[side].size() <= c.bounds[1].value() + 1e-12);
            }
            if i > 0 && !frame.nodes[i].is_hinged() {
                near(slope(i - 1, 1), slope(i, 0));
            }
        }
        for (i, node) in frame.nodes.iter().enumerate() {
            if let Some(settled) = node.rigid {
                near(found.values[i], settled);
            }
            if node.clamped {
                near(if i < 5 { slope(i, 0) } else { slope(4, 1) }, Wide::of(0.0));
            }
            // The spring forces at a node follow from the claimed deflection and rotation at an end of an adjacent
            // piece. This end must lie at the node.
            let [piece, side] = found.felt[i];
            assert!(piece + side == i && piece < 5);
        }
    }
}

/// Computes the correction of a claimed deflection that is linear on each piece. `pieces` contains the length
/// of each piece and the two coefficients of its deflection.
fn corrected(text: &str, pieces: &[[f64; 3]]) -> Deflection<Wide> {
    let length: f64 = pieces.iter().map(|[length, ..]| length).sum();
    let ground = "[foundation]\nk = 1\n";
    let model = format!("{ground}[beam]\nlength = {length:?}\n{text}");
    let model = read_model::<Wide>(&model, None).expect("a model");
    let mut to = 0.0;
    let piece = |[length, deflection @ ..]: &[f64; 3]| {
        let from = to;
        to += length;
        let (half, deflection) = (0.5 * length, deflection.to_vec());
        Piece { x: [from, to], half, deflection, ..Piece::default() }
    };
    let pieces = pieces.iter().map(piece).collect();
    let answer = Answer { pieces, ..Answer::default() };
    admissible(&frame(&model, &answer, None, &[]).expect("a frame")).expect("a deflection")
}

fn near(what: &str, a: Wide, b: Wide) {
    assert!((a - b).size() < 1e-12, "{what}: {a:?} {b:?}");
}

/// Checks that the claimed deflection of the shorter of two pieces is kept at their common node. Pieces longer than
/// (4EI/k)^¼ = 2.21 must have a cubic correction.
#[test]
fn the_claim_of_the_shorter_of_two_long_pieces_is_kept() {
    for ([left, right], bends, kept) in [
        ([2.5, 2.25], [true, true], 1),
        ([2.25, 2.5], [true, true], 0),
        ([2.25, 2.25], [true, true], 1),
        ([2.125, 2.25], [false, true], 0),
        ([2.25, 2.125], [true, false], 1),
    ] {
        let found = corrected("EI = 6\n", &[[left, 1.0, 0.0], [right, 2.0, 0.0]]);
        let what = format!("{left} {right}");
        assert_eq!([0, 1].map(|i| found.pieces[i].bounds[2] > Size::ZERO), bends, "{what}");
        near(&what, found.values[1], found.claimed[kept].value[1 - kept]);
    }
}

/// Checks which piece between two rigid supports gets a cubic correction: the longest piece, or the first of
/// several longest pieces.
#[test]
fn the_longest_piece_between_rigid_supports_bends() {
    for (lengths, longest) in [([1.0, 2.0, 1.5], 1), ([1.0, 2.0, 2.0], 1), ([1.5, 1.0, 1.0], 0)] {
        let length: f64 = lengths.iter().sum();
        let pins = [0.0, length].map(|x| {
            format!("[[support]]\nat = {x:?}\ntype = 'pinned'\nsettlement = {}\n", 0.5 + x)
        });
        let found = corrected(
            &("EI = 1000\n".to_owned() + &pins.concat()),
            &lengths.map(|h| [h, 1.0, 0.0]),
        );
        let bends = |i: usize| found.pieces[i].bounds[2] > Size::ZERO;
        assert_eq!([0, 1, 2].map(bends), [0, 1, 2].map(|i| i == longest), "{lengths:?}");
    }
}

/// Checks that the claimed rotation of an adjacent piece with a linear correction is kept at a rigid support. If both
/// corrections are linear, that of the right piece is kept.
#[test]
fn the_rotation_at_a_support_is_that_of_a_short_piece() {
    let pin = |at: f64| format!("[[support]]\nat = {at:?}\ntype = 'pinned'\n");
    for (bending, [left, right], pins, kept) in [
        (4.0, [1.0, 3.0], 1, 0),
        (4.0, [3.0, 1.0], 1, 1),
        (4.0, [1.0, 1.5], 1, 1),
        (1000.0, [1.5, 1.0], 2, 0),
    ] {
        let pins = [pin(left), pin(left + right)][..pins].concat();
        let pin = format!("EI = {bending:?}\n{pins}");
        let found = corrected(&pin, &[[left, 1.0, 0.5 * left], [right, 2.0, -right]]);
        let turned = found.claimed[0].rotation[1] + found.pieces[0].slope[1];
        near("rotation", turned, found.claimed[kept].rotation[1 - kept]);
        near("rotation", turned, Wide::of([1.0, -2.0][kept]));
    }
}

/// Checks that the spring forces at a node follow from the claimed deflection of the adjacent piece with the smaller
/// sum of the absolute values of its coefficients.
#[test]
fn springs_feel_the_piece_with_the_smaller_coefficients() {
    for (deflections, felt) in [([1.0, 3.0], [0, 1]), ([3.0, 1.0], [1, 0]), ([1.0, 1.0], [0, 1])] {
        let found = corrected("EI = 1000\n", &deflections.map(|w| [1.0, w, 0.0]));
        assert_eq!(found.felt, [[0, 0], felt, [1, 1]], "{deflections:?}");
    }
}

/// The correction of the claimed deflection is a cubic on a piece that is at least as long as (4EI/k)^¼, and linear
/// on a shorter piece.
#[test]
fn a_piece_bends_from_one_wave_length_on() {
    for bending in [4.5, 6.0, 7.5, 30.0, 0.01] {
        let wave = f64::powf(4.0 * bending, 0.25);
        let pieces = [0.98, 1.02].map(|part| [part * wave, 1.0, 0.0]);
        let found = corrected(&format!("EI = {bending:?}\n"), &pieces);
        let bends = [0, 1].map(|i| found.pieces[i].bounds[2] > Size::ZERO);
        assert_eq!(bends, [false, true], "{bending}");
    }
}
