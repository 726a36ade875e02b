//! The ground surface ū, the concentrated contact forces of the shear layer, and the residual of the ground equation.
//!
//! In contact, ū is the corrected deflection minus the initial gap. Out of contact, the equation of the shear layer is
//! solved exactly, by (4) of docs/proof.md.
//!
//! The decrease of the shear-layer force μu′ at a node in contact is a concentrated contact force. A tensile force is
//! omitted and becomes a residual. See *Ground* in section 3 of docs/proof.md.

use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
use crate::polynomial::Polynomial;
use crate::scalar::{Scalar, positive_part};
use crate::size::Size;
use std::ops::Range;

/// The settlement of the ground's surface, and the forces on the surface.
#[derive(Debug)]
pub(crate) struct Surface<S> {
    pub pieces: Vec<SurfacePiece<S>>,
    pub nodes: Vec<SurfaceNode<S>>,
    /// Whether beam and layer touch at each node.
    pub touches: Vec<bool>,
    /// Upper bound of the energy norm of the residual of the ground equation: residual forces at nodes, and residual pressures.
    pub unclaimed: Size,
}

#[derive(Debug, Clone)]
pub(crate) struct SurfacePiece<S> {
    /// Ground displacement ū at both ends of a piece out of contact on a shear layer; `None` on other pieces.
    pub open: Option<[S; 2]>,
    /// Ground displacement ū along a piece out of contact on a shear layer whose k or μ varies; `None` on other pieces.
    pub along: Option<Box<Polynomial<S>>>,
    /// Largest |ρ| of the residual ρ = kū − (μū′)′ − q on a piece out of contact whose k or μ varies; zero on other pieces.
    pub missed: Size,
    /// Force μū′ in the shear layer at both ends of a piece out of contact.
    pub flux: [S; 2],
    /// Upper bound of √g on a piece, where g is the layer's settlement at x under a unit force at x; infinite on Winkler ground.
    pub flexibility: Size,
}

/// The ground displacement ū and the forces at one node; all zero at a node where beam and shear layer are not in contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SurfaceNode<S> {
    /// Decrease, from left to right, of the shear-layer force at the node, minus the point force on the ground at the node.
    pub jump: S,
    pub settlement: S,
    /// Concentrated contact force: equal to `jump`, or zero if `jump` is negative.
    pub force: S,
}

impl<S> Surface<S> {
    /// Returns a bound of √g at a node, with the layer's flexibility g: the smaller of the bounds on the two adjacent pieces.
    pub fn flexibility_at(&self, node: usize) -> Size {
        let right = self.pieces.get(node).map_or(Size::INFINITE, |piece| piece.flexibility);
        let left = node.checked_sub(1).map_or(Size::INFINITE, |i| self.pieces[i].flexibility);
        right.least(left)
    }
}

/// Computes the displacement of the ground out of contact, and the shear-layer forces μu′ at all nodes.
pub(crate) fn surface<S: Scalar>(frame: &Frame<S>, deflection: &Deflection<S>) -> Surface<S> {
    let touches: Vec<bool> = (0..frame.nodes.len()).map(|i| touches(frame, i)).collect();
    let zero = S::zero();
    let piece = SurfacePiece {
        open: None,
        along: None,
        missed: Size::ZERO,
        flux: [zero; 2],
        flexibility: Size::INFINITE,
    };
    let mut surface = Surface {
        pieces: vec![piece; frame.spans.len()],
        nodes: vec![SurfaceNode { jump: zero, settlement: zero, force: zero }; frame.nodes.len()],
        unclaimed: Size::ZERO,
        touches,
    };
    let mut first = 0;
    while first < frame.spans.len() {
        let mut end = first;
        while end < frame.spans.len() && frame.spans[end].layered {
            end += 1;
        }
        if end > first {
            let links: Vec<_> = frame.spans[first..end].iter().map(Link::of).collect();
            let layer = Layer::of(frame, deflection, &links, first);
            layer.flexibility(&mut surface);
            layer.solve(&mut surface);
            layer.forces(&mut surface);
        }
        first = end + 1;
    }
    surface
}

/// Whether beam and layer are in contact at a node: at an end of a piece in contact, or at a claimed concentrated contact force.
fn touches<S: Scalar>(frame: &Frame<S>, node: usize) -> bool {
    let (layered, touching) = (frame.layered(node), frame.touching(node));
    let any = layered[0] || layered[1];
    (layered[0] && touching[0]) || (layered[1] && touching[1]) || (any && frame.nodes[node].pressed)
}

/// The ground on one side of a node, condensed to the node. With the settlement u of the node, it exerts the upward
/// force `stiffness` · u − `pushed` on the node.
#[derive(Clone, Copy)]
pub(crate) struct Behind<S> {
    stiffness: S,
    pushed: S,
}

impl<S: Scalar> Behind<S> {
    /// Returns the condensed ground with an additional force on the surface at the node.
    fn loaded(self, force: S) -> Self {
        Behind { pushed: self.pushed + force, ..self }
    }
}

/// Free-field settlement q/k of a piece under the load q: end values, increase from left to right, and shear-layer force μq′/k.
#[derive(Clone, Copy)]
struct FreeField<S> {
    ends: [S; 2],
    rise: S,
    slope: S,
}

/// A piece out of contact. Its settlement is u = q/k + v, where q is the load on the ground and v is a solution of μv″ = kv.
/// Varying k and μ are replaced by their minima.
pub(crate) struct Link<S> {
    /// Stiffnesses K₁ and K₂ of equation (4) in docs/proof.md.
    across: S,
    own: S,
    /// Free-field settlement q/k; zero without a load on the piece.
    free: FreeField<S>,
}

impl<S: Scalar> Link<S> {
    fn of(span: &Span<S>) -> Self {
        let (spring, shear) = (span.spring.least(), span.shear.least());
        let root = (spring * shear).sqrt();
        let z = spring.div(shear).sqrt() * span.h;
        // e = exp(−z) − 1 avoids cancellation for small z: sinh z = −e(2 + e)/(2(1 + e)), tanh(z/2) = −e/(2 + e).
        let e = (-z).expm1();
        let sum = e + S::of(2.0);
        let across = (root * (e + S::one()).scaled(1)).div(-e * sum);
        let zero = S::zero();
        let free = match span.free_field() {
            None => FreeField { ends: [zero; 2], rise: zero, slope: zero },
            Some(free) => FreeField {
                ends: span.t.map(|t| free.value(t)),
                rise: free.rise(span.t),
                slope: shear * free.coefficient(1) * span.per_length,
            },
        };
        Link { across, own: (root * -e).div(sum), free }
    }

    /// Returns the sum of two stiffnesses at the near end: of this piece with its far end fixed, and of the ground `behind`.
    fn divisor(&self, behind: Behind<S>) -> S {
        behind.stiffness + self.own + self.across
    }

    /// Returns the piece with the ground displacement measured from the level `height`, to avoid cancellation.
    fn above(&self, height: S) -> Self {
        let ends = self.free.ends.map(|free| free - height);
        Link { free: FreeField { ends, ..self.free }, ..*self }
    }

    /// Returns the increase of the settlement q/k and the shear-layer force μq′/k, in the direction from `near` to the far end.
    fn outward(&self, near: usize) -> [S; 2] {
        let FreeField { rise, slope, .. } = self.free;
        if near == 0 { [rise, slope] } else { [-rise, -slope] }
    }

    /// Returns the downward force at the near end due to loads on the piece and on the ground `behind`, if u = 0 at both ends.
    fn source(&self, behind: Behind<S>, near: usize) -> S {
        let [rise, slope] = self.outward(near);
        behind.pushed + slope + self.own * self.free.ends[near] - self.across * rise
    }

    /// Returns the ground displacement u at the near end of the piece, which adjoins the ground `behind`, from u at its far end.
    fn near(&self, behind: Behind<S>, near: usize, far: S) -> S {
        (self.across * far + self.source(behind, near)).div(self.divisor(behind))
    }

    /// Condenses this piece and the ground `behind` its near end to its far end, using only sums of positive terms.
    fn behind(&self, behind: Behind<S>, near: usize) -> Behind<S> {
        let part = self.across.div(self.divisor(behind));
        Behind {
            stiffness: part * (behind.stiffness + self.own) + self.own,
            pushed: part * self.source(behind, near) + self.own_push(near),
        }
    }

    /// Condenses this piece to its far end if the surface is fixed at u = 0 at its near end.
    fn behind_held(&self, near: usize) -> Behind<S> {
        Behind { stiffness: self.across + self.own, pushed: self.own_push(near) }
    }

    /// Returns the downward force at the far end of the piece due to the loads on the piece, if u = 0 at both ends.
    fn own_push(&self, near: usize) -> S {
        let [rise, slope] = self.outward(near);
        self.own * self.free.ends[1 - near] + self.across * rise - slope
    }

    /// Returns the force μu′ in the shear layer at both ends of the piece, from the ground displacement u at these ends.
    pub(crate) fn fluxes(&self, [left, right]: [S; 2]) -> [S; 2] {
        let FreeField { ends: [a, b], slope, .. } = self.free;
        let (left, right) = (left - a, right - b);
        let across = self.across * (right - left) + slope;
        [across - self.own * left, across + self.own * right]
    }

    /// Returns the increase of the shear-layer force μu′ from the left to the right end, from the displacements u at these ends.
    fn flux_gained(&self, [left, right]: [S; 2]) -> S {
        let [a, b] = self.free.ends;
        self.own * ((left - a) + (right - b))
    }
}

/// A shear layer: a maximal run of pieces with μ > 0.
pub(crate) struct Layer<'a, S> {
    pub(crate) frame: &'a Frame<S>,
    deflection: &'a Deflection<S>,
    pub(crate) links: &'a [Link<S>],
    pub(crate) first: usize,
    /// For each node, the ground on its left and right, condensed to the node as if out of contact, without the load at the node.
    behind: [Vec<Behind<S>>; 2],
}

impl<'a, S: Scalar> Layer<'a, S> {
    fn of(
        frame: &'a Frame<S>,
        deflection: &'a Deflection<S>,
        links: &'a [Link<S>],
        first: usize,
    ) -> Self {
        let (count, end) = (links.len(), first + links.len());
        let beyond = |at_end: bool, side: usize| match at_end {
            true => Behind { stiffness: frame.outside[side], pushed: frame.pushed[side] },
            false => Behind { stiffness: S::zero(), pushed: S::zero() },
        };
        let force = |i: usize| frame.nodes[first + i].ground_force;
        let mut left = Vec::with_capacity(count + 1);
        left.push(beyond(first == 0, 0));
        for i in 0..count {
            left.push(links[i].behind(left[i].loaded(force(i)), 0));
        }
        let mut right = Vec::with_capacity(count + 1);
        right.push(beyond(end == frame.spans.len(), 1));
        for i in 0..count {
            let at_right = right[i].loaded(force(count - i));
            right.push(links[count - 1 - i].behind(at_right, 1));
        }
        right.reverse();
        Layer { frame, deflection, links, first, behind: [left, right] }
    }

    /// Returns the last node of the layer.
    pub(crate) fn end(&self) -> usize {
        self.first + self.links.len()
    }

    /// Bounds √g on each piece, where g is the settlement at x under a unit force at x. See *Ground* in section 3 of
    /// docs/proof.md.
    fn flexibility(&self, surface: &mut Surface<S>) {
        // The stiffness of the layer on one side of x is smallest at an end of the piece.
        let least = |side: usize, i: usize| {
            let [a, b] = [i, i + 1].map(|j| self.behind[side][j].stiffness.low());
            if a <= b { a } else { b }
        };
        // The flexibility is at most that at an end of a layer with free ends and the smallest k and μ.
        let whole = self.least_stiffness();
        for i in 0..self.links.len() {
            let stiffness = (least(0, i) + least(1, i)).next_down();
            let stiffness = if whole > stiffness { whole } else { stiffness };
            surface.pieces[self.first + i].flexibility = Size::of(1.0).over(stiffness).root();
        }
    }

    /// Returns a lower bound of √(kμ) tanh(bL), the stiffness at the end of a layer of length L, with b = √(k/μ).
    fn least_stiffness(&self) -> f64 {
        let spans = &self.frame.spans[self.first..self.end()];
        let least = |of: &dyn Fn(&Span<S>) -> S| {
            let all = spans.iter().map(of);
            all.reduce(|a, b| if b.low() < a.low() { b } else { a }).unwrap_or_else(S::zero)
        };
        let (spring, shear) =
            (least(&|span| span.spring.least()), least(&|span| span.shear.least()));
        let length = spans[spans.len() - 1].x[1] - spans[0].x[0];
        let decay = spring.div(shear).sqrt() * length;
        let fallen = (-decay.scaled(1)).expm1();
        ((spring * shear).sqrt() * (-fallen).div(fallen + S::of(2.0))).low()
    }

    /// Returns the ground displacement at a node in contact: the corrected deflection of the beam minus the initial gap.
    pub(crate) fn held(&self, node: usize) -> S {
        let piece = if node < self.end() { (node, 0) } else { (node - 1, 1) };
        let span = &self.frame.spans[piece.0];
        self.deflection.values[node] - span.gap.value(span.t[piece.1])
    }

    /// Returns the point force on the ground at a node.
    fn force(&self, node: usize) -> S {
        self.frame.nodes[node].ground_force
    }

    /// Computes the ground displacement on all pieces out of contact, from one node in contact to the next.
    fn solve(&self, surface: &mut Surface<S>) {
        let nodes = self.first..=self.end();
        let touching: Vec<usize> = nodes.filter(|node| surface.touches[*node]).collect();
        let even = |pieces: Range<usize>| {
            self.frame.spans[pieces].iter().all(|span| span.has_even_ground())
        };
        let (Some(first), Some(last)) = (touching.first(), touching.last()) else {
            match even(self.first..self.end()) {
                true => self.leading(self.end(), self.free_end(), surface),
                false => self.as_stored(self.first..self.end(), surface),
            }
            return;
        };
        match even(self.first..*first) {
            true => self.leading(*first, self.held(*first), surface),
            false => self.as_stored(self.first..*first, surface),
        }
        match even(*last..self.end()) {
            true => self.trailing(*last, surface),
            false => self.as_stored(*last..self.end(), surface),
        }
        for pair in touching.windows(2) {
            if !self.frame.spans[pair[0]].touches {
                match even(pair[0]..pair[1]) {
                    true => self.between(pair[0], pair[1], surface),
                    false => self.as_stored(pair[0]..pair[1], surface),
                }
            }
        }
    }

    /// Returns the ground displacement u at the right end of a layer that is nowhere in contact. Without loads u = 0.
    fn free_end(&self) -> S {
        let [left, right] = [0, 1].map(|side| self.behind[side][self.links.len()]);
        let pushed = left.pushed + right.pushed + self.force(self.end());
        if pushed == S::zero() { pushed } else { pushed.div(left.stiffness + right.stiffness) }
    }

    /// Computes the displacement of the ground out of contact from the left end of the layer to the first node in contact.
    fn leading(&self, node: usize, held: S, surface: &mut Surface<S>) {
        let mut u = held;
        for i in (0..node - self.first).rev() {
            let (behind, at_right) = (&self.behind[0], self.behind[0][i + 1]);
            let at_left = behind[i].loaded(self.force(self.first + i));
            let next = self.links[i].near(at_left, 0, u);
            surface.pieces[self.first + i].open = Some([next, u]);
            surface.pieces[self.first + i].flux = [
                at_left.stiffness * next - at_left.pushed,
                at_right.stiffness * u - at_right.pushed,
            ];
            u = next;
        }
    }

    /// Computes the displacement of the ground out of contact from the last node in contact to the right end of the layer.
    fn trailing(&self, node: usize, surface: &mut Surface<S>) {
        let mut u = self.held(node);
        for i in node - self.first..self.links.len() {
            let (behind, at_left) = (&self.behind[1], self.behind[1][i]);
            let at_right = behind[i + 1].loaded(self.force(self.first + i + 1));
            let next = self.links[i].near(at_right, 1, u);
            surface.pieces[self.first + i].open = Some([u, next]);
            surface.pieces[self.first + i].flux = [
                at_left.pushed - at_left.stiffness * u,
                at_right.pushed - at_right.stiffness * next,
            ];
            u = next;
        }
    }

    /// Computes the ground displacement between two nodes in contact, by condensation and back-substitution. To avoid
    /// cancellation on short pieces, displacements are measured from the left node.
    fn between(&self, from: usize, to: usize, surface: &mut Surface<S>) {
        let start = self.held(from);
        let link = |piece: usize| self.links[piece - self.first].above(start);
        let mut behind = vec![link(from).behind_held(0)];
        for piece in from + 1..to {
            let left = behind[piece - from - 1].loaded(self.force(piece));
            behind.push(link(piece).behind(left, 0));
        }
        let mut risen = (from..to).fold(S::zero(), |sum, piece| sum + self.rise(piece));
        let all = behind[to - from - 1];
        let mut flux = all.stiffness * risen - all.pushed;
        let mut right = self.held(to);
        for piece in (from..to).rev() {
            risen = match piece - from {
                0 => S::zero(),
                i => link(piece).near(behind[i - 1].loaded(self.force(piece)), 0, risen),
            };
            let left = start + risen;
            let at_left = flux - self.links[piece - self.first].flux_gained([left, right]);
            surface.pieces[piece].open = Some([left, right]);
            surface.pieces[piece].flux = [at_left, flux];
            flux = at_left + self.force(piece);
            right = left;
        }
    }

    /// Returns the increase of deflection minus gap, w̄ − g₀, along a piece. Constant terms are omitted to avoid cancellation.
    fn rise(&self, piece: usize) -> S {
        let span = &self.frame.spans[piece];
        span.obstacle().rise(span.t) + self.deflection.pieces[piece].rise
    }

    /// Returns the jump of the flux at a node, minus the force on the ground at this node.
    pub(crate) fn jump_at(&self, node: usize, surface: &Surface<S>) -> S {
        self.flux_at(node, 0, surface) - self.flux_at(node, 1, surface) - self.force(node)
    }

    /// Returns the flux μu′ on one side of a node.
    fn flux_at(&self, node: usize, side: usize, surface: &Surface<S>) -> S {
        let piece = if side == 0 { node.checked_sub(1) } else { Some(node) };
        let piece = piece.filter(|piece| (self.first..self.end()).contains(piece));
        let Some(piece) = piece else {
            let behind = self.behind[side][node - self.first];
            let outward = behind.stiffness * self.stored_at(node, surface) - behind.pushed;
            return if side == 0 { outward } else { -outward };
        };
        let span = &self.frame.spans[piece];
        if span.touches {
            let slope = self.deflection.claimed[piece].slope[1 - side];
            span.shear.at_end(1 - side) * (slope - span.gap_slope())
        } else {
            surface.pieces[piece].flux[1 - side]
        }
    }

    /// Computes the concentrated forces at touching nodes.
    fn forces(&self, surface: &mut Surface<S>) {
        for node in self.first..=self.end() {
            if !surface.touches[node] {
                continue;
            }
            let jump = self.jump_at(node, surface);
            let force = positive_part(jump);
            surface.nodes[node] = SurfaceNode { jump, settlement: self.held(node), force };
            surface.unclaimed += Size::below_zero(jump.low()) * surface.flexibility_at(node);
        }
    }
}
