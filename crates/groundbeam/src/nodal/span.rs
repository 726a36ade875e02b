//! Condenses the pieces of a beam span that is out of contact to one element.
//!
//! Two joined pieces have the unknowns (w, θ, D₁, D₂, d₁, t): displacements of the left end, deformations of both
//! pieces together, and deformations of the left piece, which are eliminated. Deformations are displacements of the
//! right end relative to the rigid motion of the left end. The rotation t includes the jump at a hinge.

use super::beam::{Beam, Given, NODAL_TERMS};
use super::grid::Grid;
use super::quadratic::{NotSolved, Quadratic, Row};
use super::stand::Stand;
use crate::element::element::{Basis, Element, mirror_shape};

/// A piece of a span, with the coefficients of the back-substitution for the part of the span before this
/// piece.
#[derive(Debug, Clone)]
pub(crate) struct Piece {
    /// Left and right end node of the piece in the grid.
    pub nodes: [usize; 2],
    pub length: f64,
    /// Closed form of the deflection of a uniform beam; `None` for a single element without a closed form.
    beam: Option<Beam>,
    /// Deformations d₁ and t of the span before this piece, as linear functions of the [unknowns](self) (w, θ, D₁, D₂).
    before: [Row<6>; 2],
    /// Rotation just before a hinge at the start of this piece, relative to the rigid motion of the start of the span.
    /// It is a linear function of the [unknowns](self) (w, θ, d₁, t).
    hinge: Option<Row<4>>,
}

impl Piece {
    /// Returns the deflection, the rotation and the deformations of the piece with its left and right end exchanged.
    pub fn mirrored(&self, own: [f64; 4]) -> [f64; 4] {
        mirror_shape(&own, self.length, Basis::Deformation)
    }

    /// Coefficients of the deflection w(s), s ∈ [0, 1], and the number of significant coefficients; `None`
    /// without a closed form.
    pub fn series(&self, own: [f64; 4]) -> Option<([f64; NODAL_TERMS], usize)> {
        self.beam.as_ref().map(|beam| beam.unfold(own))
    }
}

/// The beam between two nodes, condensed to one element. Its inner nodes are eliminated from left to right, or from
/// right to left if `mirrored` is true.
#[derive(Debug, Clone, Default)]
pub(crate) struct Span {
    pub from: usize,
    pub to: usize,
    pub mirrored: bool,
    pieces: Vec<Piece>,
    pub whole: Element,
}

/// Index of the eliminated deflection among the unknowns of two joined pieces, in place of d₁ in the
/// [list of unknowns](self).
const D: usize = 4;
/// Index of the eliminated rotation among the unknowns of two joined pieces, in place of t in the
/// [list of unknowns](self).
const T: usize = 5;

/// Largest rotational stiffness of a hinge and the beam before it that counts as zero, relative to the piece after the
/// hinge.
const FREE_HINGE: f64 = 1e-14;

const NONE: Row<6> = Row { by: [0.0; 6], constant: 0.0 };

impl Span {
    /// Condenses the beam between two nodes, from right to left if `mirrored`. `stand` returns loads, supports and
    /// hinge at a node.
    pub fn set(
        &mut self,
        grid: &Grid,
        [from, to]: [usize; 2],
        mirrored: bool,
        stand: impl Fn(usize) -> Stand,
    ) -> Result<(), NotSolved> {
        (self.from, self.to, self.mirrored) = (from, to, mirrored);
        self.pieces.clear();
        let (first, last) = (grid.run_at(from), grid.run_at(to - 1));
        for i in first..=last {
            let run = if mirrored { last - (i - first) } else { i };
            let (a, b) = (grid.runs[run].first.max(from), grid.runs[run].end().min(to));
            self.add_run(grid, run, [a, b], &stand)?;
        }
        Ok(())
    }

    /// Divides a part of a row of equal elements into pieces with short power series, and appends the pieces to the
    /// span.
    fn add_run(
        &mut self,
        grid: &Grid,
        run: usize,
        [from, to]: [usize; 2],
        stand: &impl Fn(usize) -> Stand,
    ) -> Result<(), NotSolved> {
        let own = &grid.runs[run];
        if let Some(element) = &own.element {
            let element = if self.mirrored { element.mirrored() } else { *element };
            return self.add(element, None, [from, to], stand);
        }
        let count = to - from;
        let wanted = own.pieces(grid.axial_force, own.h * count as f64).min(count);
        let at = |i: usize| count * i / wanted;
        // Pieces with equal lengths, loads and imposed curvatures have the same closed form.
        let mut last: Option<(f64, Given, Beam)> = None;
        for i in 0..wanted {
            let (a, b) = if self.mirrored {
                (to - at(i + 1), to - at(i))
            } else {
                (from + at(i), from + at(i + 1))
            };
            let part = own.part(a, b);
            let given = if self.mirrored { part.mirrored() } else { part };
            let length = own.h * (b - a) as f64;
            let beam = match last {
                Some((known, loads, beam)) if known == length && loads == given => beam,
                _ => Beam::new(own.cell.stiffness, &given, grid.axial_force, length),
            };
            last = Some((length, given, beam));
            self.add(beam.element(), Some(beam), [a, b], stand)?;
        }
        Ok(())
    }

    /// Appends a piece to the span. `stand` returns the loads, supports and hinge at the node before this
    /// piece.
    fn add(
        &mut self,
        next: Element,
        beam: Option<Beam>,
        nodes: [usize; 2],
        stand: &impl Fn(usize) -> Stand,
    ) -> Result<(), NotSolved> {
        let length = next.length;
        let mut piece = Piece { nodes, length, beam, before: [NONE; 2], hinge: None };
        if self.pieces.is_empty() {
            self.whole = next;
        } else {
            let stand = stand(if self.mirrored { nodes[1] } else { nodes[0] });
            self.whole = join(&self.whole, &stand, &next, &mut piece)?;
        }
        self.pieces.push(piece);
        Ok(())
    }

    /// The end nodes of all pieces; a node between two pieces occurs twice.
    pub fn ends(&self) -> impl Iterator<Item = usize> {
        self.pieces.iter().flat_map(|piece| piece.nodes)
    }

    /// Calls `each` for every piece, from the last to the first, with the deflection and the rotation of its first end
    /// and its two deformations. `v` contains these four numbers for the whole span.
    pub fn unfold(&self, v: &[f64; 4], mut each: impl FnMut(&Piece, [f64; 4])) {
        let [w, theta, mut d1, mut d2] = *v;
        let mut length = self.whole.length;
        for (i, piece) in self.pieces.iter().enumerate().rev() {
            let l = piece.length;
            length -= l;
            let mut own = [w, theta, d1, d2];
            if i > 0 {
                let z = [w, theta, d1, d2, 0.0, 0.0];
                let [b, turn] = [0, 1].map(|r| piece.before[r].value(&z));
                own = [w + length * theta + b, theta + turn, d1 - b - l * turn, d2 - turn];
                let bent = piece.hinge.map_or(turn, |hinge| hinge.value(&[w, theta, b, turn]));
                (d1, d2) = (b, bent);
            }
            each(piece, own);
        }
    }
}

/// The deflection or rotation that is eliminated at the node between two joined pieces.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Eliminated {
    /// The deformation of the left piece.
    Left,
    /// The deformation of the right piece.
    Right,
    /// The displacement of the node.
    Node,
}

/// Joins two elements at a node that may have loads, supports and a hinge. Writes to `piece` the coefficients
/// of the back-substitution for the left element.
fn join(
    left: &Element,
    stand: &Stand,
    next: &Element,
    piece: &mut Piece,
) -> Result<Element, NotSolved> {
    let (h, l) = (left.length, next.length);
    let mut own = Quadratic { h: left.stiffness, g: left.load };
    if let Some(spring) = stand.hinge {
        // This block replaces one unknown of the left element: the rotation d₂ of its right end becomes t, the sum
        // of d₂ and the rotation jump of the hinge.
        let bending = own.h[3][3];
        if bending + spring <= FREE_HINGE * next.stiffness[3][3] {
            return Err(NotSolved);
        }
        let mut with_jump = Quadratic::<5>::ZERO;
        let keep = |i: usize| std::array::from_fn(|j| f64::from(u8::from(i == j)));
        with_jump.add(&[keep(0), keep(1), keep(2), keep(4)], &own.h, &own.g);
        with_jump.add(&[[0.0, 0.0, 0.0, 1.0, -1.0]], &[[spring]], &[0.0]);
        let row = with_jump.eliminate(4, 0.0)?;
        let mut by = [row.by[0], row.by[1], row.by[2], row.by[3]];
        own.g = [0, 1, 2, 3].map(|i| with_jump.g[i]);
        own.h = std::array::from_fn(|i| std::array::from_fn(|j| with_jump.h[i][j]));
        // A free hinge transmits exactly zero moment. For given displacements, any other hinge transmits the fraction
        // `share` of the moment of a beam without hinge.
        let share = spring / (bending + spring);
        for j in 0..4 {
            own.h[3][j] = share * if j == 3 { bending } else { left.stiffness[3][j] };
            own.h[j][3] = own.h[3][j];
        }
        own.g[3] = share * left.load[3];
        by[3] = share;
        piece.hinge = Some(Row { by, constant: row.constant });
    }
    // The unknown with the largest stiffness is eliminated, separately for deflection and rotation. It is the
    // deformation of the left element, that of the right element, or the displacement of the node on its support. This
    // avoids differences of large stiffnesses.
    let stiffest = |left: f64, right: f64, support: f64| match () {
        () if support > left.max(right) => Eliminated::Node,
        () if left > right => Eliminated::Left,
        () => Eliminated::Right,
    };
    let support = |held: bool, spring: f64| if held { f64::INFINITY } else { spring };
    let [translation, rotation] =
        [support(stand.pinned, stand.support), support(stand.clamped, stand.turning)];
    let by_deflection = stiffest(own.h[2][2], next.stiffness[2][2], translation);
    let by_rotation = stiffest(own.h[3][3], next.stiffness[3][3], rotation);
    let unit = |i: usize| std::array::from_fn(|j| f64::from(u8::from(i == j)));
    let combined = |a: [f64; 6], times: f64, b: [f64; 6]| -> [f64; 6] {
        std::array::from_fn(|j| a[j] + times * b[j])
    };
    // Deformation of the left element, if the deformations of both elements add up to `sum`, and the left element moves
    // the node by `rigid`.
    let deformed = |by: Eliminated, unknown: usize, sum: [f64; 6], rigid: [f64; 6]| match by {
        Eliminated::Left => unit(unknown),
        Eliminated::Right => combined(sum, -1.0, unit(unknown)),
        Eliminated::Node => combined(unit(unknown), -1.0, rigid),
    };
    let t = deformed(by_rotation, T, unit(3), unit(1));
    let bend = match by_rotation {
        Eliminated::Right => unit(T),
        _ => combined(unit(3), -1.0, t),
    };
    let beyond = combined(unit(2), -l, t);
    let d1 = deformed(by_deflection, D, beyond, [1.0, h, 0.0, 0.0, 0.0, 0.0]);
    let sag = match by_deflection {
        Eliminated::Right => unit(D),
        _ => combined(beyond, -1.0, d1),
    };
    let mut both = Quadratic::<6>::ZERO;
    both.add(&[unit(0), unit(1), d1, t], &own.h, &own.g);
    let lift = combined([1.0, h, 0.0, 0.0, 0.0, 0.0], 1.0, d1);
    let turn = combined(unit(1), 1.0, t);
    both.add(&[lift, turn, sag, bend], &next.stiffness, &next.load);
    let springs = [[stand.support + stand.spring, 0.0], [0.0, stand.turning]];
    both.add(&[lift, turn], &springs, &[stand.load(), stand.moment]);
    let size = [D, T].map(|i| both.h[i][i]);
    let mut eliminated = [NONE; 2];
    if stand.pinned {
        eliminated[0].constant = stand.settlement;
        both.hold(D, eliminated[0]);
    }
    if stand.clamped {
        both.hold(T, eliminated[1]);
    }
    if !stand.pinned {
        eliminated[0] = both.eliminate(D, size[0])?;
    }
    if !stand.clamped {
        eliminated[1] = both.eliminate(T, size[1])?;
    }
    eliminated[0] = eliminated[0].with(T, &eliminated[1]);
    let put_in = |row: [f64; 6]| {
        Row { by: row, constant: 0.0 }.with(D, &eliminated[0]).with(T, &eliminated[1])
    };
    piece.before = [put_in(d1), put_in(t)];
    Ok(Element {
        length: h + l,
        stiffness: std::array::from_fn(|i| std::array::from_fn(|j| both.h[i][j])),
        load: [0, 1, 2, 3].map(|i| both.g[i]),
        ..Element::default()
    })
}
