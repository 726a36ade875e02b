//! The answer piece by piece, as the proof reads it.

use groundbeam::Solution;
use groundbeam::proof::{Answer, Force, Piece};
use serde::Serialize;

/// Pieces and concentrated forces of a solution.
#[derive(Serialize)]
pub(super) struct Claimed {
    pieces: Vec<Stretch>,
    forces: Vec<Concentrated>,
}

/// A piece; of t = (x − (x₀ + x₁)/2)/half.
#[derive(Serialize)]
struct Stretch {
    x: [f64; 2],
    half: f64,
    touches: bool,
    deflection: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    rotation: Vec<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pressure: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    open: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    settlement: Vec<f64>,
}

#[derive(Serialize)]
struct Concentrated {
    x: f64,
    force: f64,
}

impl Claimed {
    pub fn of(solution: &Solution) -> Self {
        let (_, Answer { pieces, forces, .. }) = solution.claim::<f64>();
        let stretch = |piece: Piece| Stretch {
            x: piece.x,
            half: piece.half,
            touches: piece.touches,
            deflection: piece.deflection,
            rotation: piece.rotation,
            pressure: piece.pressure,
            open: piece.open,
            settlement: piece.settlement,
        };
        let concentrated = |Force { x, force }| Concentrated { x, force };
        Claimed {
            pieces: pieces.into_iter().map(stretch).collect(),
            forces: forces.into_iter().map(concentrated).collect(),
        }
    }
}
