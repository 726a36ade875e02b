//! Reflected cell: the left-to-right elimination also runs right to left.

use crate::chain::node::ChainCell;
use crate::chain::node::{Tie, TiedTwoPort};
use crate::element::element::{Basis, Element};
use crate::ground::link::TwoPort;

/// Transforms the four unknowns of an element to those of the reflected element, and back.
pub(super) fn mirror_shape(v: &[f64; 4], h: f64, basis: Basis) -> [f64; 4] {
    let [w, theta, d1, d2] = *v;
    match basis {
        Basis::Deformation => [w + h * theta + d1, -(theta + d2), h * d2 - d1, d2],
        Basis::Ends => [d1, -d2, w, -theta],
    }
}

fn mirror_row(row: &[f64; 4], h: f64, basis: Basis) -> [f64; 4] {
    // row·v = row·(Q v') with Q of `mirror_shape`.
    let [a, b, c, d] = *row;
    match basis {
        Basis::Deformation => [a, h * a - b, a - c, d - b + h * c],
        Basis::Ends => [c, -d, a, -b],
    }
}

pub(super) fn mirror_cell(cell: &ChainCell) -> (Element, Vec<TiedTwoPort>) {
    let Element { length: h, basis, .. } = cell.element;
    let mirror_row = |row: &[f64; 4]| mirror_row(row, h, basis);
    let half: [[f64; 4]; 4] = std::array::from_fn(|i| mirror_row(&cell.element.stiffness[i]));
    let stiffness = std::array::from_fn(|j| {
        let column = [half[0][j], half[1][j], half[2][j], half[3][j]];
        mirror_row(&column)
    });
    let element = Element { stiffness, load: mirror_row(&cell.element.load), ..cell.element };
    let mirror_tie = |tie: Tie| match tie {
        Tie::SurfaceLeft => Tie::SurfaceRight,
        Tie::SurfaceRight => Tie::SurfaceLeft,
        Tie::Beam { row, gap } => Tie::Beam { row: mirror_row(&row), gap },
    };
    let links = cell.links.iter().map(|tied| TiedTwoPort {
        two_port: TwoPort {
            shunt_left: tied.two_port.shunt_right,
            shunt_right: tied.two_port.shunt_left,
            ..tied.two_port
        },
        left: mirror_tie(tied.right),
        right: mirror_tie(tied.left),
    });
    (element, links.collect())
}
