//! Proves the exact contact set: finds intervals that contain the contact edges and the concentrated contact forces.
//!
//! The theory is in section 5 of docs/proof.md. On a shear layer, the exact solution is first proven to be out of
//! contact where the claimed solution is. Then the claimed contact regions are proven. The proof on Winkler ground is
//! in `springs.rs`. If a step fails, its name and position are returned.

use crate::approach::Approach;
use crate::contact_set::{Contact, ContactForce, ContactRegion, EdgeShift, Shown, more};
use crate::polynomial::{Budget, Polynomial, below};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// Length of the shortest part at an end of a piece on which contact or clearance is proven, in the local coordinate t.
pub(crate) const SHORTEST_PART: f64 = 4e-12;

impl<S: Scalar> Contact<'_, S> {
    /// Proves the contact set, both on ground with a shear layer and on Winkler ground.
    pub fn shown(&self) -> Shown {
        let frame = self.fields.frame;
        let spans = &frame.spans;
        let mut shown = Shown::nothing(frame.nodes.len());
        let mut first = 0;
        while first < spans.len() {
            let mut end = first;
            while end < spans.len() && spans[end].layered == spans[first].layered {
                end += 1;
            }
            let layered = spans[first].layered;
            let found = match layered {
                true => self.layer(first, end, &mut shown),
                false => self.springs(first, end, &mut shown),
            };
            if let Err(why) = found {
                shown.failed[usize::from(!layered)].get_or_insert(why);
            }
            first = end;
        }
        shown
    }

    /// Proves the contact set on one shear layer. First it proves clearance on the pieces that are claimed to be out of
    /// contact, then the contact regions and the contact points.
    fn layer(&self, first: usize, end: usize, shown: &mut Shown) -> Result<(), NotProven> {
        let (spans, touches) = (&self.fields.frame.spans, &self.fields.surface.touches);
        // `beside` contains the proven bounds of the pieces to the left and right of each node. Only a piece out of
        // contact beside a node in contact has such bounds.
        let mut beside: Vec<[Option<Approach>; 2]> = vec![[None; 2]; spans.len() + 1];
        for i in (first..end).filter(|i| !spans[*i].touches) {
            let [left, right] = self.shown_open(i, &mut shown.zones).ok_or_else(|| {
                self.failed(
                    "the clearance between beam and ground is too small to exclude contact",
                    i,
                )
            })?;
            beside[i][1] = left;
            beside[i + 1][0] = right;
        }
        for node in (first..=end).filter(|node| touches[*node]) {
            let tolerance = self.tolerance(node, &beside);
            shown.tolerances[node] = shown.tolerances[node].worst(tolerance);
        }
        let mut node = first;
        while node <= end {
            if !touches[node] {
                node += 1;
                continue;
            }
            let mut last = node;
            while last < end && spans[last].touches {
                last += 1;
            }
            if last == node {
                self.point(node, &beside, shown)?;
            } else {
                self.region([node, last], &beside, shown)?;
            }
            node = last + 1;
        }
        Ok(())
    }

    /// Proves that a contact point is the only contact in its neighbourhood. This requires that the contact force
    /// exceeds its error bound.
    fn point(
        &self,
        node: usize,
        beside: &[[Option<Approach>; 2]],
        shown: &mut Shown,
    ) -> Result<(), NotProven> {
        let tolerance = self.tolerance(node, beside);
        let alone = beside[node].iter().flatten().all(|side| side.theta == Size::ZERO);
        if !(alone && self.fields.surface.nodes[node].jump.low() > tolerance.value()) {
            return Err(self.failed(
                "at a claimed contact point, the exact solution may have no contact, or contact over a short interval",
                node,
            ));
        }
        self.force(node, tolerance, true, shown);
        let x = self.interval(node, [Size::ZERO; 2]);
        shown.set.regions.push(ContactRegion { from: x, to: x });
        Ok(())
    }

    /// Proves a contact region between the nodes `a` and `b`.
    fn region(
        &self,
        [a, b]: [usize; 2],
        beside: &[[Option<Approach>; 2]],
        shown: &mut Shown,
    ) -> Result<(), NotProven> {
        let frame = self.fields.frame;
        let mut budget = Budget::new(b - a);
        for i in a..b {
            let field = self.fields.pressures[i].field.coarse();
            let error = more(self.bounds[i].pressure);
            let span = &frame.spans[i];
            if below(&field, error, Size::ZERO, span.interval(), &mut budget).depth != Size::ZERO {
                return Err(self.failed("the pressure is smaller than its error bound", i));
            }
        }
        let left = self.edge(a, 0, beside)?;
        let right = self.edge(b, 1, beside)?;
        shown.edges.extend([left, right]);
        let available = (frame.nodes[b].x - frame.nodes[a].x).low();
        if !((left.inside + right.inside).value() < available) {
            return Err(
                self.failed("a contact region is shorter than the error bounds of its edges", a)
            );
        }
        for node in (a..=b).filter(|node| !frame.smooth(*node)) {
            let tolerance = self.tolerance(node, beside);
            if node == a || node == b {
                let inside = if node == a { left.inside } else { right.inside };
                self.force(node, tolerance, inside == Size::ZERO, shown);
                continue;
            }
            let pushes = self.fields.surface.nodes[node].jump.low() >= tolerance.value();
            if !pushes && !self.bends_open(node) {
                return Err(self.failed(
                    "a concentrated force inside a contact region is not proven to be compressive",
                    node,
                ));
            }
            // The exact contact region contains `node`: the exact end of the region is closer to the claimed end than
            // `node`.
            self.force(node, tolerance, true, shown);
        }
        shown.set.regions.push(ContactRegion {
            from: self.interval(a, [left.outside, left.inside]),
            to: self.interval(b, [right.inside, right.outside]),
        });
        Ok(())
    }

    /// Bounds the distance between the exact and the claimed end of a contact region, outward and inward. The inward
    /// bound is θ′ of (14) in docs/proof.md.
    fn edge(
        &self,
        node: usize,
        side: usize,
        beside: &[[Option<Approach>; 2]],
    ) -> Result<EdgeShift, NotProven> {
        let approach = beside[node][side];
        let outside = approach.map_or(Size::ZERO, |approach| approach.theta);
        // The claimed contact region ends at `node`, and the piece `i` is its last piece at this end.
        let i = if side == 0 { node } else { node - 1 };
        let span = &self.fields.frame.spans[i];
        // On a beam with shear deformation, `opened_at` gives another bound of the inward distance, which may be
        // smaller than that of `balanced_inside`.
        let shears = self.fields.frame.shears();
        let rough = if shears { self.opened_at(i, side) } else { None };
        let mut most = rough.unwrap_or(Size::INFINITE);
        let tolerance = self.tolerance(node, beside);
        let jump = self.fields.surface.nodes[node].jump;
        let without_slope = self.tolerance_beside(node, side, beside);
        let beyond = [
            approach.map_or(Size::ZERO, |approach| approach.flux + approach.steep),
            Size::below_zero((jump - S::of(without_slope.value())).low()),
        ];
        let missing = Size::below_zero((jump - S::of(tolerance.value())).low());
        if missing == Size::ZERO {
            return Ok(EdgeShift { node, side, outside, inside: Size::ZERO, beyond });
        }
        let (field, error) = (self.fields.pressures[i].field.coarse(), self.bounds[i].pressure);
        let piece = (span.interval()[side], span.half.low());
        most = most.least(balanced_inside(&field, error, missing, piece, side));
        match most < Size::INFINITE {
            true => Ok(EdgeShift { node, side, outside, inside: most, beyond }),
            false => {
                Err(self
                    .failed("no error bound is proven for the position of a contact edge", node))
            }
        }
    }

    /// Returns ε_a, the error bound of a concentrated force: the sum of the error bounds of the flux μu′ on both
    /// sides of the node.
    fn tolerance(&self, node: usize, beside: &[[Option<Approach>; 2]]) -> Size {
        self.tolerance_beside(node, 0, beside) + self.tolerance_beside(node, 1, beside)
    }

    /// Returns the error bound of the flux μu′ on one side of a node.
    fn tolerance_beside(&self, node: usize, side: usize, beside: &[[Option<Approach>; 2]]) -> Size {
        let frame = self.fields.frame;
        let last = frame.spans.len();
        if frame.layered(node)[side] {
            let i = node + side - 1;
            let span = &frame.spans[i];
            return match (span.touches, beside[node][side]) {
                (true, _) => Size::of(span.shear.high()) * self.bounds[i].slope,
                (false, Some(approach)) => approach.flux,
                (false, None) => Size::INFINITE,
            };
        }
        if node != [0, last][side] {
            return Size::ZERO;
        }
        let i = if side == 0 { 0 } else { last - 1 };
        Size::of(frame.outside[side].high()) * self.bounds[i].settlement
    }

    /// Whether the slope of the exact clearance is proven not to decrease from left to right at a node out of contact.
    ///
    /// See *Region* and *Timoshenko beams on a layer* in section 5 of docs/proof.md. On a beam with shear deformation,
    /// the node must have no support and no upward force.
    pub(crate) fn bends_open(&self, node: usize) -> bool {
        let frame = self.fields.frame;
        let corner = || (frame.spans[node].gap_slope() - frame.spans[node - 1].gap_slope()).low();
        let here = &frame.nodes[node];
        let alone = here.rigid.is_none() && here.spring.is_none() && here.force.low() >= 0.0;
        let down = alone || !frame.kinks(node);
        down && frame.even(node) && (!here.corner || corner() >= 0.0)
    }

    /// Adds the interval of a concentrated force. The interval includes zero unless contact is proven at the node.
    fn force(&self, node: usize, tolerance: Size, contact: bool, shown: &mut Shown) {
        let frame = self.fields.frame;
        let jump = self.fields.surface.nodes[node].jump;
        let (low, high) = (
            (jump.low() - tolerance.value()).next_down().max(0.0),
            (jump.high() + tolerance.value()).next_up().max(0.0),
        );
        let low = if contact { low } else { 0.0 };
        let below = frame.units.restored(low, 1, 0);
        let below = if below > 1e-280 { below } else { 0.0 };
        let force = [below, frame.units.restored(high, 1, 0)];
        shown.pressed[node] = below > 0.0;
        shown.set.forces.push(ContactForce { x: frame.place(node), force });
    }
}

/// Returns a length at an end of a piece on which the pressure minus `error` balances the force `missing`; infinite if
/// none is found on half of the piece. `end` is t at this end, and `half` is the length per unit of t.
fn balanced_inside<C: Scalar>(
    field: &Polynomial<C>,
    error: Size,
    missing: Size,
    (end, half): (f64, f64),
    side: usize,
) -> Size {
    let parts = growing_parts().chain([1.0]);
    balanced_on(parts, field, error, (end, half), side, |least| missing.over(least))
        .unwrap_or(Size::INFINITE)
}

/// Returns lengths of parts of a piece in the local coordinate t: [`SHORTEST_PART`] times powers of 4, below 1.
pub(crate) fn growing_parts() -> impl Iterator<Item = f64> {
    std::iter::successors(Some(SHORTEST_PART), |part| Some(4.0 * part))
        .take_while(|part| *part < 1.0)
}

/// Returns the first of the lengths `required(least)` that fits into its part of a piece. `least` is a lower bound of
/// the pressure minus `error` on this part. All parts begin at the end `side`.
pub(crate) fn balanced_on<C: Scalar>(
    mut parts: impl Iterator<Item = f64>,
    field: &Polynomial<C>,
    error: Size,
    piece: (f64, f64),
    side: usize,
    required: impl Fn(f64) -> Size,
) -> Option<Size> {
    parts.find_map(|part| {
        let [least, available] = pressed_beside(field, error, piece, side, part);
        let length = required(least);
        (length.value() <= available).then_some(length)
    })
}

/// Returns lower bounds for a part of a piece at its end `side`: of the pressure minus `error`, and of the length of
/// the part. `part` is this length in the local coordinate t.
fn pressed_beside<C: Scalar>(
    field: &Polynomial<C>,
    error: Size,
    (end, half): (f64, f64),
    side: usize,
    part: f64,
) -> [f64; 2] {
    let m = if side == 0 { end + 0.5 * part } else { end - 0.5 * part };
    let about = field.shifted(m);
    let lost = about.tail((0.5 * part).next_up() + 4.0 * f64::EPSILON) + error;
    let least = (about.coefficient(0).low() - lost.value()).next_down();
    [least, ((part - 1e-12).next_down() * half).next_down()]
}

mod tests;
