//! Tests of the listed numbers of a result document against the pieces of the claimed solution.

#![cfg(test)]

use super::*;
use crate::Answer;
use crate::given_claim::with_fields;
use crate::wide::Wide;
use serde_json::json;

/// The beam consists of three pieces with the contact pressures 1, 2 and 3. A contact edge at an end of the beam
/// adjoins only one piece.
#[test]
fn a_pressure_at_an_edge_is_compared_with_both_pieces_that_exist() {
    let text = "[beam]\nlength = 3\nEI = 1\n[foundation]\nk = 1\nmu = 0\n";
    let piece =
        |i: u32| json!({"x": [i, i + 1], "half": 0.5, "touches": true, "deflection": [i + 1]});
    let pieces = json!({"pieces": [piece(0), piece(1), piece(2)]});
    let answer = Answer::from_json(&pieces.to_string()).expect("an answer");
    let document = Document { answer, ..Document::default() };
    with_fields(text, &pieces, |fields| {
        let patches = Patches::of(fields);
        let comparison = Comparison { document: &document, fields, patches };
        for (piece, edge, most) in [
            (0, [-0.5, 0.5], 1.0),
            (0, [0.25, 0.5], 1.0),
            (0, [0.5, 1.5], 2.0),
            (1, [0.5, 1.5], 2.0),
            (1, [1.5, 2.5], 3.0),
            (2, [1.5, 2.5], 3.0),
            (2, [2.5, 3.0], 3.0),
            (2, [2.5, 3.5], 3.0),
        ] {
            for (listed, exact) in [(0.0, 0.0), (most, 0.0), (most + 0.25, 0.25), (-0.25, 0.25)] {
                let found = comparison.off_an_edge(listed, (piece, Wide::zero()), edge);
                assert!((found - exact).abs() < 1e-12, "{piece} {edge:?} {listed}: {found}");
            }
        }
    });
}
