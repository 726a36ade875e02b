//! A piece of the linearised beam: one element between two nodes.

use crate::element::operator::ZoneKind;
use crate::mesh::cell::Cell;

/// A part of an element on which w and u are short power series.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    /// The element it lies in.
    pub element: usize,
    /// Its cell, cut to its ends.
    pub cell: Cell,
    /// Half its length \[m\].
    pub half: f64,
    /// Whether beam and ground touch.
    pub touch: ZoneKind,
    /// Its ends in the element's own coordinate.
    pub part: [f64; 2],
}
