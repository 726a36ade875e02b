//! Reflects a cell, so that the left-to-right elimination also runs from right to left.

use crate::chain::node::ChainCell;
use crate::chain::node::{Tie, TiedTwoPort};
use crate::element::element::{Element, mirror_row};

pub(super) fn mirror_cell(cell: &ChainCell) -> (Element, Vec<TiedTwoPort>) {
    let Element { length: h, basis, .. } = cell.element;
    let mirror_row = |row: &[f64; 4]| mirror_row(row, h, basis);
    let element = cell.element.mirrored();
    let mirror_tie = |tie: Tie| match tie {
        Tie::SurfaceLeft => Tie::SurfaceRight,
        Tie::SurfaceRight => Tie::SurfaceLeft,
        Tie::Beam { row, gap } => Tie::Beam { row: mirror_row(&row), gap },
    };
    let links = cell.links.iter().map(|tied| TiedTwoPort {
        two_port: tied.two_port.mirrored(),
        left: mirror_tie(tied.right),
        right: mirror_tie(tied.left),
    });
    (element, links.collect())
}
