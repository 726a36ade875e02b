//! Proves the exact contact set: intervals that contain the edges of every region and the concentrated forces of a layer.
//!
//! The proof uses the bounds of w, w′, M and u on each piece. In a layer, first the clearance of the open stretches
//! is proven, then the contact of the regions. On Winkler ground, the sign of w − g₀ decides. If a step fails, the
//! name and the position of the step are returned.

use crate::approach::Approach;
use crate::contact_set::{Contact, ContactForce, ContactRegion, EdgeShift, Shown, more};
use crate::polynomial::{Budget, Polynomial, below};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

/// Length of the shortest part of a piece next to an end, in units of t, on which contact or clearance is decided.
pub(crate) const SHORTEST_PART: f64 = 4e-12;

impl<S: Scalar> Contact<'_, S> {
    /// Proves the contact set of all layers and of the Winkler ground.
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

    /// Proves the contact set of a layer: first the open stretches, then the contact regions and points.
    fn layer(&self, first: usize, end: usize, shown: &mut Shown) -> Result<(), NotProven> {
        let (spans, touches) = (&self.fields.frame.spans, &self.fields.surface.touches);
        // `beside` contains the `Approach` of the open pieces on the left and on the right of each node of the
        // layer.
        let mut beside: Vec<[Option<Approach>; 2]> = vec![[None; 2]; spans.len() + 1];
        for i in (first..end).filter(|i| !spans[*i].touches) {
            let [left, right] = self.shown_open(i, &mut shown.zones).ok_or_else(|| {
                self.failed("the clearance of open ground is too small to exclude contact", i)
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
                "the beam may be open at a contact point, or touch over a short region",
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
                return Err(self
                    .failed("a concentrated force inside a contact region may be tensile", node));
            }
            // The exact solution is in contact on both sides of an inner node, because θ′ is shorter than the piece
            // at the edge.
            self.force(node, tolerance, true, shown);
        }
        shown.set.regions.push(ContactRegion {
            from: self.interval(a, [left.outside, left.inside]),
            to: self.interval(b, [right.inside, right.outside]),
        });
        Ok(())
    }

    /// Bounds the distance between an end of the exact contact region and the claimed end. The bounds are θ outward
    /// and θ′ inward. θ′ satisfies ∫(p − ε_p) ≥ ε_a − a over the length θ′. ε_p and ε_a are the error bounds of the
    /// pressure and of the concentrated force a.
    fn edge(
        &self,
        node: usize,
        side: usize,
        beside: &[[Option<Approach>; 2]],
    ) -> Result<EdgeShift, NotProven> {
        let approach = beside[node][side];
        let outside = approach.map_or(Size::ZERO, |approach| approach.theta);
        // `i` is the piece of the contact region that ends at `node`.
        let i = if side == 0 { node } else { node - 1 };
        let span = &self.fields.frame.spans[i];
        // On a beam with shear deformation, `opened_at` also bounds the length inside the edge that may be open.
        // This bound does not use the contact set, and may be smaller than the bound from `balanced_inside`.
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
            false => Err(self.failed("the position of a region's edge has no bound", node)),
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

    /// Whether the slope of the exact clearance C* cannot decrease at a node where the exact beam is open. The flux
    /// must have no jump at the node, and a corner of g₀ must increase the slope. On a beam with shear deformation,
    /// a point force F causes the jump [C*′] = F/(S + P), so F must act downward.
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

/// Returns a length θ′ from the end of a piece inward on which (p − ε)θ′ is at least `missing`, with the smallest p
/// on this length and the error bound ε of p. θ′ is at most one unit of t, so θ′ is shorter than the piece. The result
/// is infinite if no such length is found. `end` is the value of t at the end, and `half` is the length per unit of t.
fn balanced_inside<C: Scalar>(
    field: &Polynomial<C>,
    error: Size,
    missing: Size,
    (end, half): (f64, f64),
    side: usize,
) -> Size {
    // `part` is the length from the end on which p − ε is bounded.
    let mut part = SHORTEST_PART;
    loop {
        part = part.min(1.0);
        let [least, available] = pressed_beside(field, error, (end, half), side, part);
        let inside = missing.over(least);
        if inside.value() <= available {
            return inside;
        }
        if part == 1.0 {
            return Size::INFINITE;
        }
        part *= 4.0;
    }
}

/// Returns lower bounds of p − ε on a part of a piece next to an end, and of the length of this part. `part` is the
/// length in units of t.
pub(crate) fn pressed_beside<C: Scalar>(
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

#[cfg(test)]
mod tests {
    use super::{balanced_inside, pressed_beside};
    use crate::approach::Approach;
    use crate::ball::Ball;
    use crate::contact_set::{Contact, Shown};
    use crate::fields::Fields;
    use crate::given_claim::with_fields;
    use crate::pointwise::PieceBounds;
    use crate::polynomial::Polynomial;
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;
    use crate::wide::Wide;
    use serde_json::json;

    /// Checks that the pressure minus its error has at least the resultant `missing` on the length θ′ from an end
    /// of the piece. Where the pressure is nearly constant, θ′ is the smallest such length.
    #[test]
    fn the_length_inside_an_edge_balances_the_missing_force() {
        let mut random = numbers();
        let mut found = 0;
        for i in 0..1000 {
            let (side, half) = (i % 2, 3.0_f64.powf(random()));
            let sign = if side == 0 { -1.0 } else { 1.0 };
            let steep = if i % 3 == 0 { 1e-6 } else { 2.0 };
            let c = [1.0 + 0.5 * random(), steep * random(), steep * random()];
            let p = |t: f64| c[0] + t * (c[1] + t * c[2]);
            let error = 0.3 * random().abs();
            let missing = half * 10.0_f64.powf(2.0 * random() - 2.0);
            let field = <Polynomial<Ball>>::from_coefficients(c.map(Ball::of));
            let inside =
                balanced_inside(&field, Size::of(error), Size::of(missing), (sign, half), side);
            let (near, whole) = (p(sign) - error, inside.value());
            if steep < 1.0 {
                let wanted = missing / near;
                let ratio = whole / wanted;
                let fits = wanted < 0.999 * half;
                assert!(
                    if fits {
                        (1.0 - 1e-5..1.0 + 1e-5).contains(&ratio)
                    } else {
                        wanted > 0.99 * half || ratio < 1.1
                    },
                    "{ratio}"
                );
            }
            if whole < f64::INFINITY {
                found += 1;
                let places = (0..=100).map(|j| sign * (1.0 - whole / half * f64::from(j) / 100.0));
                let least = places.map(p).fold(f64::INFINITY, f64::min) - error;
                assert!(
                    whole <= half && whole * least >= missing * (1.0 - 1e-12),
                    "{whole} {least} {missing}"
                );
            }
        }
        assert!(found > 500, "{found}");
    }

    /// p decreases inward from 1 to 0 on half of the piece. The length that balances a small force is the force over
    /// the pressure at the end.
    #[test]
    fn the_length_inside_an_edge_uses_the_pressure_near_the_edge() {
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let field = <Polynomial<Ball>>::from_coefficients([0.0, sign].map(Ball::of));
            for missing in [1e-3, 1e-6, 1e-9] {
                let small = Size::of(missing);
                let inside = balanced_inside(&field, Size::ZERO, small, (sign, 1.0), side).value();
                let ratio = inside / missing;
                assert!((1.0..1.0 + 5.0 * missing + 1e-6).contains(&ratio), "{missing} {ratio}");
            }
        }
    }

    /// The bounds of a pressure that increases inward from zero include the rounding errors of the position.
    #[test]
    fn the_pressure_on_a_short_part_is_not_above_that_at_the_end() {
        for (side, sign) in [(0, -1.0), (1, 1.0)] {
            let field = <Polynomial<Ball>>::from_coefficients([1.0, -sign].map(Ball::of));
            for part in [4e-12, 1e-10, 1e-8] {
                let [least, length] = pressed_beside(&field, Size::ZERO, (sign, 2.0), side, part);
                assert!((-1e-14..=0.0).contains(&least), "{part} {least}");
                assert!((0.7 * part..2.0 * part).contains(&length), "{part} {length}");
            }
        }
    }

    /// Passes a claim of four pieces of length ¼ to `of`. The beam w = 1 is in contact on the third piece of a layer
    /// with k = μ = 1, so p = 1 there. t lies between −5/6 and 5/6 on this piece, and one unit of t is the length 0.15.
    fn with_region<T>(of: impl FnOnce(&mut Fields<Wide>) -> T) -> T {
        let model = "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1\nmu = 1\n";
        let piece = |i: usize| {
            let (from, half) = (0.25 * i as f64, if i == 2 { 0.15 } else { 0.125 });
            json!({"x": [from, from + 0.25], "half": half, "touches": i == 2, "deflection": [1]})
        };
        let pieces: Vec<_> = (0..4).map(piece).collect();
        with_fields(model, &json!({"pieces": pieces}), of)
    }

    fn is(what: &str, found: Size, exact: f64) {
        assert!((found.value() / exact - 1.0).abs() < 1e-9, "{what}: {found:?} {exact}");
    }

    /// The region ends at nodes 2 and 3. The errors of the flux are 0.2 outside and 0.05 inside. A force a leaves a
    /// length θ′ = 0.25 − a, and a part 0.2 − a of the jump of the flux that does not depend on the slope.
    #[test]
    fn an_edge_moves_inward_by_the_missing_force() {
        with_region(|fields| {
            let mut beside = [[None; 2]; 5];
            let [theta, flux, steep] = [0.01, 0.2, 0.3].map(Size::of);
            let approach = Approach { theta, flux, steep, reach: 0.0 };
            (beside[2][0], beside[3][1]) = (Some(approach), Some(approach));
            let bounds = [PieceBounds { slope: Size::of(0.05), ..PieceBounds::EXACT }; 4];
            for (node, side) in [(2, 0), (3, 1)] {
                for jump in [0.15, 0.3, 0.05] {
                    fields.surface.nodes[node].jump = Wide::of(jump);
                    let contact = Contact { fields, bounds: &bounds };
                    let found = contact.edge(node, side, &beside);
                    // One unit of t is too short for the missing force 0.2.
                    let Ok(found) = found else {
                        assert_eq!(jump, 0.05);
                        continue;
                    };
                    assert_eq!((found.node, found.side, found.outside), (node, side, theta));
                    is("outside", found.beyond[0], 0.5);
                    if jump == 0.3 {
                        assert_eq!([found.inside, found.beyond[1]], [Size::ZERO; 2]);
                    } else {
                        is("inside", found.inside, 0.1);
                        is("force", found.beyond[1], 0.05);
                    }
                }
            }
        });
    }

    /// The region has the length 0.25. The exact beam is in contact somewhere if both θ′ together are shorter.
    #[test]
    fn a_region_is_longer_than_the_bounds_of_its_edges() {
        with_region(|fields| {
            let [theta, flux, steep] = [Size::ZERO; 3];
            let approach = Approach { theta, flux, steep, reach: 0.0 };
            let mut beside = [[None; 2]; 5];
            (beside[2][0], beside[3][1]) = (Some(approach), Some(approach));
            let bounds = [PieceBounds::EXACT; 4];
            for ([left, right], longer) in [
                ([0.12, 0.12], true),
                ([0.14, 0.1], true),
                ([0.13, 0.13], false),
                ([0.14, 0.12], false),
            ] {
                fields.surface.nodes[2].jump = Wide::of(-left);
                fields.surface.nodes[3].jump = Wide::of(-right);
                let contact = Contact { fields, bounds: &bounds };
                let found = contact.region([2, 3], &beside, &mut Shown::nothing(5));
                assert_eq!(found.is_ok(), longer, "{left} {right}");
            }
        });
    }

    /// The interval of a concentrated force is a ± ε_a, and it contains zero where contact is not proven. Only a
    /// positive force holds the beam.
    #[test]
    fn a_concentrated_force_is_positive_only_if_proven() {
        with_region(|fields| {
            fields.surface.nodes[2].jump = Wide::of(1.0);
            let bounds = [PieceBounds::EXACT; 4];
            let contact = Contact { fields, bounds: &bounds };
            for (tolerance, touches, [low, high]) in [
                (0.25, true, [0.75, 1.25]),
                (0.25, false, [0.0, 1.25]),
                (1.0, true, [0.0, 2.0]),
                (2.0, true, [0.0, 3.0]),
            ] {
                let mut shown = Shown::nothing(5);
                contact.force(2, Size::of(tolerance), touches, &mut shown);
                let [found] = &shown.set.forces[..] else { panic!("one force") };
                assert!((found.force[0] - low).abs() < 1e-12, "{found:?}");
                assert!((found.force[1] - high).abs() < 1e-12, "{found:?}");
                assert_eq!(shown.pressed, [false, false, low > 0.0, false, false]);
            }
        });
    }
}
