//! The admissible deflection w̄ = w + c and rotation φ̄ = φ + c′, from the claimed fields and the rigid supports.
//!
//! The correction c closes the jumps of the claimed deflection w and rotation φ, and satisfies the rigid supports. It
//! is a cubic on pieces of at least the characteristic length (4EI/k)^¼, and on the longest piece between two rigid
//! supports. On other pieces, c is linear and continues the correction of the neighbouring piece. (3) of docs/proof.md
//! bounds c.

use crate::frame::{Frame, Span};
use crate::polynomial::Polynomial;
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// The correction c on one piece. It is added to the claimed deflection to remove the jumps and to satisfy the
/// supports.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Correction<S> {
    /// Slope c′ of the correction c of the claimed deflection, at both ends of the piece.
    pub slope: [S; 2],
    /// Rise of the correction c: its value at the right end of the piece minus its value at the left end.
    pub rise: S,
    /// Upper bounds of |c|, |c′| and |c″| on the piece, where c is the correction that is added to the claimed
    /// deflection.
    pub bounds: [Size; 3],
}

/// The claimed deflection, slope and rotation at both ends of a piece.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Claimed<S> {
    /// Claimed deflection w at both ends of the piece.
    pub value: [S; 2],
    /// Claimed slope w′ at both ends of the piece.
    pub slope: [S; 2],
    /// Rotation φ at both ends of the piece; equal to w′ on a piece without shear deformation.
    pub rotation: [S; 2],
}

impl<S: Scalar> Claimed<S> {
    fn of(span: &Span<S>) -> Self {
        let ends = |p: &Polynomial<S>| span.t.map(|t| p.value(t));
        let slope = ends(&span.derivative(&span.deflection));
        let rotation = span.rotation.as_deref().map_or(slope, ends);
        Claimed { value: ends(&span.deflection), slope, rotation }
    }
}

/// The admissible deflection w̄ = w + c: the claimed fields at the ends of each piece, and the corrections c.
#[derive(Debug)]
pub(crate) struct Deflection<S> {
    pub pieces: Vec<Correction<S>>,
    pub claimed: Vec<Claimed<S>>,
    /// Corrected deflection w̄ at the nodes.
    pub values: Vec<S>,
    /// For each node, an adjacent piece and its end at the node (0 left, 1 right), whose claimed values give the spring
    /// forces. The piece with the smaller coefficients of w is taken, for less rounding error.
    pub felt: Vec<[usize; 2]>,
}

impl<S: Scalar> Deflection<S> {
    /// Returns the claimed deflection w and rotation φ at a node, from which the forces of the support springs at
    /// this node follow.
    pub fn at_support(&self, node: usize) -> [S; 2] {
        let [piece, side] = self.felt[node];
        let claimed = &self.claimed[piece];
        [claimed.value[side], claimed.rotation[side]]
    }
}

/// Computes a continuous deflection from the pieces of the claimed deflection. A cubic polynomial is added to some
/// pieces. These pieces are selected first. Then the polynomials are computed from left to right.
pub(crate) fn admissible<S: Scalar>(frame: &Frame<S>) -> Result<Deflection<S>, NotProven> {
    let claimed: Vec<_> = frame.spans.iter().map(Claimed::of).collect();
    let bends = bending(frame);
    let mut walk = Walk {
        frame,
        claimed: &claimed,
        bends: &bends,
        values: vec![S::zero(); frame.nodes.len()],
        turns: vec![[S::zero(); 2]; frame.nodes.len()],
        held: vec![false; frame.nodes.len()],
    };
    walk.chains();
    let contradicted =
        (0..frame.nodes.len()).find(|i| frame.nodes[*i].rigid.is_some() && !walk.held[*i]);
    if let Some(node) = contradicted {
        return Err(NotProven::new(
            "at a rigid support, the deflection cannot be corrected to equal the settlement of the support",
        )
        .at(frame.place(node)));
    }
    let pieces = (0..frame.spans.len()).map(|i| walk.correction(i)).collect();
    let values = walk.values;
    let felt = (0..frame.nodes.len()).map(|node| felt(frame, node)).collect();
    Ok(Deflection { pieces, claimed, values, felt })
}

/// Returns one of the pieces that meet at a node, and the end of this piece at the node: 0 for the left end, 1 for
/// the right end. It is the piece with the smaller coefficients of w.
fn felt<S: Scalar>(frame: &Frame<S>, node: usize) -> [usize; 2] {
    let size = |piece: usize| frame.spans[piece].deflection.size(1.0);
    match (node.checked_sub(1), node < frame.spans.len()) {
        (Some(left), true) if size(node) < size(left) => [node, 0],
        (Some(left), _) => [left, 1],
        (None, _) => [node, 0],
    }
}

/// Selects the pieces with a cubic correction: pieces of at least the characteristic length (4EI/k)^¼, and the longest
/// piece between neighbouring rigid supports.
fn bending<S: Scalar>(frame: &Frame<S>) -> Vec<bool> {
    let length = |i: usize| frame.spans[i].h.middle();
    let mut bends: Vec<bool> = frame
        .spans
        .iter()
        .map(|span| {
            let waves = span.h.square().square().middle() * span.spring.middle();
            waves >= 4.0 * span.bending.middle()
        })
        .collect();
    let rigid: Vec<usize> =
        (0..frame.nodes.len()).filter(|i| frame.nodes[*i].rigid.is_some()).collect();
    for pair in rigid.windows(2) {
        let mut longest = pair[0];
        for i in pair[0]..pair[1] {
            if length(i) > length(longest) {
                longest = i;
            }
        }
        bends[longest] = true;
    }
    bends
}

/// State of the computation: the corrected deflection w̄ at the nodes, and the corrected rotation φ̄ on both sides
/// of each node.
struct Walk<'a, S> {
    frame: &'a Frame<S>,
    claimed: &'a [Claimed<S>],
    bends: &'a [bool],
    values: Vec<S>,
    turns: Vec<[S; 2]>,
    held: Vec<bool>,
}

impl<S: Scalar> Walk<'_, S> {
    /// Computes the corrected deflection and rotation at all nodes. A chain is a run of pieces with a linear
    /// correction, or a single node between pieces with a cubic correction.
    fn chains(&mut self) {
        let last = self.frame.spans.len();
        let mut first = 0;
        while first <= last {
            let mut end = first;
            while end < last && !self.bends[end] {
                end += 1;
            }
            self.chain(first, end);
            first = end + 1;
        }
    }

    /// Computes the corrected deflection and rotation at the nodes of one chain, from `first` up to and including
    /// `end`.
    fn chain(&mut self, first: usize, end: usize) {
        let nodes = &self.frame.nodes;
        let support = (first..=end).find(|i| nodes[*i].rigid.is_some());
        let start = support.unwrap_or(first);
        // At `start`, the claimed values of an adjacent piece with a linear correction are kept. If both corrections
        // are cubic, those of the shorter piece are kept.
        let length = |i: usize| self.frame.spans[i].h.middle();
        let keeps = match (start > 0, start < self.frame.spans.len()) {
            (true, true) if start < end => (start, 0),
            (true, true) if start > first => (start - 1, 1),
            (true, true) if length(start - 1) < length(start) => (start - 1, 1),
            (_, true) => (start, 0),
            (_, false) => (start - 1, 1),
        };
        let value = nodes[start].rigid.unwrap_or(self.claimed[keeps.0].value[keeps.1]);
        let slope =
            if nodes[start].clamped { S::zero() } else { self.claimed[keeps.0].rotation[keeps.1] };
        self.held[start] = nodes[start].rigid.is_some();
        self.values[start] = value;
        self.turns[start] = [0, 1].map(|side| self.handed_on(start, side, slope));
        for i in start..end {
            let [a, b] = self.left_of(i);
            self.values[i + 1] = self.claimed[i].value[1] + a + b * self.frame.spans[i].h;
            let slope = self.claimed[i].rotation[1] + b;
            self.turns[i + 1] = [slope, self.handed_on(i + 1, 1, slope)];
        }
        for i in (first..start).rev() {
            let b = self.turns[i + 1][0] - self.claimed[i].rotation[1];
            let a = self.values[i + 1] - self.claimed[i].value[1] - b * self.frame.spans[i].h;
            self.values[i] = self.claimed[i].value[0] + a;
            let slope = self.claimed[i].rotation[0] + b;
            self.turns[i] = [self.handed_on(i, 0, slope), slope];
        }
    }

    /// Returns the rotation on one side of a node. At a hinge, this is the claimed rotation of the piece on this
    /// side; elsewhere it is `slope`.
    fn handed_on(&self, node: usize, side: usize, slope: S) -> S {
        let piece = (node + side).checked_sub(1).and_then(|piece| self.claimed.get(piece));
        match piece {
            Some(claimed) if self.frame.nodes[node].is_hinged() => claimed.rotation[1 - side],
            _ => slope,
        }
    }

    /// Returns the correction c of the claimed deflection and its slope c′ at the left end of a piece.
    fn left_of(&self, piece: usize) -> [S; 2] {
        [
            self.values[piece] - self.claimed[piece].value[0],
            self.turns[piece][1] - self.claimed[piece].rotation[0],
        ]
    }

    /// Computes the correction of the claimed deflection on a piece from the corrected deflection w̄ and rotation
    /// φ̄ at the ends of the piece.
    fn correction(&self, i: usize) -> Correction<S> {
        let h = self.frame.spans[i].h;
        let [a, b] = self.left_of(i);
        if !self.bends[i] {
            let slope = Size::of(b.size());
            let bounds = [Size::of(a.size()) + slope * Size::of(h.size()), slope, Size::ZERO];
            return Correction { slope: [b; 2], rise: b * h, bounds };
        }
        let value = [a, self.values[i + 1] - self.claimed[i].value[1]];
        let slope = [b, self.turns[i + 1][0] - self.claimed[i].rotation[1]];
        let bounds = bent(h, value, slope);
        Correction { slope, rise: value[1] - value[0], bounds }
    }
}

/// Returns upper bounds of the absolute value, slope and curvature of a cubic on a piece of length h. The cubic
/// has the given values and slopes at the ends of the piece.
fn bent<S: Scalar>(h: S, value: [S; 2], slope: [S; 2]) -> [Size; 3] {
    let most = |x: [S; 2]| Size::of(x[0].size()).worst(Size::of(x[1].size()));
    let (largest, steepest) = (most(value), most(slope));
    [
        largest + 0.3 * (steepest * Size::of(h.size())),
        (3.0 * largest).over(h.low()) + steepest,
        ((12.0 * largest).over(h.low()) + 6.0 * steepest).over(h.low()),
    ]
}

mod tests;
