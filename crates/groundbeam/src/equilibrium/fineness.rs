//! What is too fine to be cut into power series: a refusal in place of a solve that would take hours.
//!
//! Where stiffness or ground vary, and where the beam shears, an element is one series of a length of about one wave.
//! A shear layer a billion times as stiff as the beam has boundary layers of 10⁻⁴ of the length, and every element
//! on it would be as short as they are.

use crate::element::courses::Touch;
use crate::element::operator::Operator;
use crate::element::uniform::parts;
use crate::mesh::cell::Cell;
use crate::mesh::mesh::Mesh;
use crate::model::{Model, Part, Problem};

/// Elements of one series each that a beam may need.
const MOST: usize = 30_000;

/// Why a model is not solved in closed forms, if it is not.
pub(crate) fn too_fine(model: &Model) -> Option<Problem> {
    let part = match model.varying_part() {
        Some(part) => part,
        None if model.beam.shears() => Part::Beam,
        None => return None,
    };
    let tension = model.beam.axial_force.max(0.0);
    let mesh = Mesh::graded(model, &[], |_| 1);
    let special =
        |cell: &&Cell| cell.beam_shear.is_some() || cell.beam_varies() || cell.ground_varies();
    let needed = |touch: Touch| {
        let cells = mesh.cells.iter().filter(special);
        let each = cells.map(|cell| parts(&Operator::of(cell, tension, touch), cell.length()));
        each.fold(0, usize::saturating_add)
    };
    let needed = needed(Touch::Contact).max(needed(Touch::Open));
    (needed > MOST).then(|| Problem::too_fine(part, needed))
}
