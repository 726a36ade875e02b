//! The exact contact set on Winkler ground: the closure of the set where the exact beam presses on the springs.

use crate::contact_set::{Contact, ContactRegion, Shown, Zone, more};
use crate::model::Acts;
use crate::polynomial::{Budget, Polynomial, below};
use crate::refusal::NotProven;
use crate::scalar::Scalar;
use crate::size::Size;

impl<S: Scalar> Contact<'_, S> {
    /// Proves the contact set on Winkler ground between two nodes, except in a short zone on each side of every edge
    /// of contact.
    pub(crate) fn springs(
        &self,
        first: usize,
        end: usize,
        shown: &mut Shown,
    ) -> Result<(), NotProven> {
        let spans = &self.fields.frame.spans;
        let differs = |i: usize, j: usize| spans[i].touches != spans[j].touches;
        let mut zones = vec![[Size::ZERO; 2]; end - first];
        // On a piece where the exact beam rests without load, it is in contact without pressure. This needs no proof
        // from the claimed fields.
        for i in (first..end).filter(|i| !self.rests(*i)) {
            let field = self.signed(i);
            let edges = [i > first && differs(i - 1, i), i + 1 < end && differs(i, i + 1)];
            let mut interval = spans[i].interval();
            for side in [0, 1] {
                // At a rigid support at the height of the ground, the clearance is zero only without a load on the
                // ground.
                let stands = self.stands(i, side) && spans[i].ground_load.is_none();
                // At a jump of the initial gap or of a load on the ground, the clearance may change its sign without
                // a zero.
                let at_end = field.value(S::Coarse::of(interval[side])).low();
                let steps = at_end > more(self.bounds[i].deflection).value();
                if (!edges[side] || steps) && !stands {
                    continue;
                }
                let (theta, to) =
                    self.zone(i, side, &field, more(self.bounds[i].deflection)).ok_or_else(
                        || self.failed("the position of a region's edge has no bound", i + side),
                    )?;
                interval[side] = to;
                shown.zones.push(Zone { piece: i, side, theta });
                // At a rigid support on the surface of the ground, the edge of contact is the position of the support.
                if !stands {
                    zones[i - first][side] = theta;
                }
            }
            let error = more(self.bounds[i].deflection);
            let clear = interval[0] < interval[1]
                && below(&field, error, Size::ZERO, interval, &mut Budget::new(1)).depth
                    == Size::ZERO;
            if !clear {
                return Err(self.failed(
                    "the difference w − g₀ is too small to decide contact on Winkler ground",
                    i,
                ));
            }
        }
        let mut i = first;
        while i < end {
            let from = i;
            i += 1;
            if !spans[from].touches {
                continue;
            }
            while i < end && spans[i].touches {
                i += 1;
            }
            let before = if from > first { zones[from - 1 - first][1] } else { Size::ZERO };
            let after = if i < end { zones[i - first][0] } else { Size::ZERO };
            shown.set.regions.push(ContactRegion {
                from: self.interval(from, [before, zones[from - first][0]]),
                to: self.interval(i, [zones[i - 1 - first][1], after]),
            });
        }
        Ok(())
    }

    /// Returns w − g₀ − q/k on a piece in contact and its negative on an open piece, with the initial gap g₀ and the
    /// free-field settlement q/k.
    fn signed(&self, i: usize) -> Polynomial<S::Coarse> {
        let span = &self.fields.frame.spans[i];
        let field = span.above_free_field();
        if span.touches { field } else { field.times(-S::one()) }.coarse()
    }

    /// Whether the end of a piece is a rigid two-way support whose settlement equals the initial gap.
    pub(crate) fn stands(&self, i: usize, side: usize) -> bool {
        let (span, node) = (&self.fields.frame.spans[i], &self.fields.frame.nodes[i + side]);
        let gap = span.gap.value(span.t[side]);
        node.rigid == Some(gap) && node.acts == Acts::Both
    }

    /// Whether the exact deflection equals the initial gap at an end of a piece, in value and in slope. This is
    /// proven at a clamp of a beam without shear deformation, at the height of level ground.
    fn lies(&self, i: usize, side: usize) -> bool {
        let (span, node) = (&self.fields.frame.spans[i], &self.fields.frame.nodes[i + side]);
        let shears = span.stiffness.is_some();
        self.stands(i, side) && node.clamped && !shears && span.gap.tail(1.0) == Size::ZERO
    }

    /// Finds a short zone beside a rigid support at the height of the ground, on an open piece of a shear layer. In
    /// this zone the exact beam lies above the initial surface of the ground. Loads on the ground act downward, so
    /// the ground does not rise, and the exact beam is not in contact.
    pub(crate) fn leaves_support(&self, i: usize, side: usize) -> Option<(Size, f64)> {
        let bounds = &self.bounds[i];
        let field = self.fields.frame.spans[i].obstacle().times(-S::one()).coarse();
        let limit = more(bounds.settlement + bounds.deflection);
        self.stands(i, side).then(|| self.zone(i, side, &field, limit)).flatten()
    }

    /// Finds a short zone at an end of a piece. In the zone `field` grows inward faster than the error bound of its
    /// slope, up to a value above `limit`. If the exact slope is known to be zero at the end, the second derivative
    /// is compared instead. Returns the length of the zone and the coordinate t of its inner end.
    fn zone(
        &self,
        i: usize,
        side: usize,
        field: &Polynomial<S::Coarse>,
        limit: Size,
    ) -> Option<(Size, f64)> {
        let (span, bounds) = (&self.fields.frame.spans[i], &self.bounds[i]);
        let half = Size::of(span.half.high());
        let end = span.interval()[side];
        let inward = if side == 0 { 1.0 } else { -1.0 };
        let lies = self.lies(i, side);
        // A first derivative with respect to t is `half` times that with respect to x, and a second derivative
        // `half`² times.
        let (growth, error) = if lies {
            let bent = bounds.moment.over(span.bending.low());
            (field.derivative().derivative(), more(bent) * half.square())
        } else {
            (field.derivative().times(S::Coarse::of(inward)), more(bounds.slope) * half)
        };
        let at_end = growth.value(S::Coarse::of(end)).low();
        let far = (2.0 * limit.over(at_end)).value();
        let mut long = if lies { (2.0 * far).sqrt() } else { far };
        if end + inward * long == end {
            // `long` is below the rounding error of t, so the search starts with the shortest interval of doubles.
            long = 2.0 * f64::EPSILON;
        }
        for _ in 0..12 {
            let to = end + inward * long;
            if !(long < 0.75) || to == end {
                return None;
            }
            let m = end + 0.5 * (to - end);
            let about = growth.shifted(m);
            let r = (0.5 * long).next_up() + 4.0 * f64::EPSILON;
            let least = (about.coefficient(0).low() - about.tail(r).value()).next_down();
            if least > error.value() && field.value(S::Coarse::of(to)).low() > limit.value() {
                return Some((Size::of((to - end).abs().next_up()) * half, to));
            }
            long *= 2.0;
        }
        None
    }
}
