//! Bounds the error of the deflection on the whole beam from error bounds at single positions, the anchors.

use crate::coefficient::Coefficient;
use crate::frame::{Node, Span};
use crate::model::Acts;
use crate::pointwise::Pointwise;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// Fractions of the length of a piece. For each fraction, the proof computes a lower bound of the pressure on a part in
/// the middle of the piece.
const PARTS: [f64; 4] = [0.9, 0.5, 0.25, 0.0625];

/// Returns the fractions in `PARTS` whose middle part lies within the piece, which may be shorter than its stored
/// length.
pub(crate) fn parts_of<S: Scalar>(span: &Span<S>) -> impl Iterator<Item = f64> {
    let [left, right] = [-span.t[0].high(), span.t[1].low()];
    PARTS.into_iter().filter(move |part| *part <= left && *part <= right)
}

/// A position at which an error bound of the deflection or of the rotation is known.
#[derive(Debug, Clone, Copy)]
struct Anchor {
    /// Interval that contains the position of the anchor.
    x: [f64; 2],
    bound: Size,
}

/// Positions on one part of the beam at which an error bound of the deflection or of the rotation is known.
#[derive(Debug, Clone, Default)]
struct Anchors {
    /// Positions with a known error bound of the deflection.
    places: Vec<Anchor>,
    /// Positions with a known error bound of the rotation: clamps and rotational springs.
    slopes: Vec<Anchor>,
}

impl Anchors {
    fn count(&self) -> usize {
        self.places.len() + self.slopes.len()
    }
}

/// A part of the beam that has no hinges in its interior, except hinges with a rotational spring.
struct Part {
    pieces: Range<usize>,
    /// Bound of the sum of the absolute jumps of the rotation error at the elastic hinges inside the part.
    kinks: Size,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Divides the beam at all hinges, with or without a rotational spring. Returns the parts as ranges of pieces.
    pub(crate) fn parts(&self) -> Vec<Range<usize>> {
        self.cut(|node| node.is_hinged())
    }

    /// Divides the beam at the hinges without a rotational spring. Returns the parts as ranges of pieces.
    pub(crate) fn joined_parts(&self) -> Vec<Range<usize>> {
        self.cut(|node| node.is_free_hinge())
    }

    fn cut(&self, at: impl Fn(&Node<S>) -> bool) -> Vec<Range<usize>> {
        let frame = self.fields.frame;
        let mut parts = Vec::new();
        let mut first = 0;
        for i in 1..=frame.spans.len() {
            if i == frame.spans.len() || at(&frame.nodes[i]) {
                parts.push(first..i);
                first = i;
            }
        }
        parts
    }

    /// Returns bounds of the L² norms of two errors on a part: derivative of the rotation, and shear strain.
    pub(crate) fn flexure(&self, part: &Range<usize>) -> [Size; 2] {
        let spans = &self.fields.frame.spans[part.clone()];
        let most = |of: &dyn Fn(&Span<S>) -> Option<&Coefficient<S>>| {
            let all = spans.iter().filter_map(of);
            let largest = all.map(|x| Size::of(1.0).over(x.low())).fold(Size::ZERO, Size::worst);
            (2.0 * self.beam_energy() * largest).root()
        };
        [most(&|span| Some(&span.bending)), most(&|span| span.stiffness.as_ref())]
    }

    /// Returns a bound of the deflection error on each part between hinges (section 4 of docs/proof.md). A part needs
    /// two positions with a known bound (anchors), or one anchor and a bound of the rotation error.
    pub(crate) fn deflections(&self, parts: &[Range<usize>]) -> Vec<Size> {
        let frame = self.fields.frame;
        let mut anchors: Vec<Anchors> = parts.iter().map(|part| self.anchors(part)).collect();
        let mut found = vec![Size::INFINITE; parts.len()];
        // For each part, the number of anchors (positions with a known error bound) that its last computed bound uses.
        let mut used = vec![0; parts.len()];
        for _ in 0..2 {
            let order: Vec<usize> = (0..parts.len()).chain((0..parts.len()).rev()).collect();
            for j in order {
                if anchors[j].count() == used[j] {
                    continue;
                }
                let part = Part { pieces: parts[j].clone(), kinks: Size::ZERO };
                found[j] = found[j].least(self.best_along(&part, &anchors[j]));
                used[j] = anchors[j].count();
                self.hand_on(j, parts, &found, &mut anchors);
            }
            // Parts joined by elastic hinges also have a common bound.
            for joined in self.joined_parts() {
                let inside =
                    |part: &Range<usize>| joined.start <= part.start && part.end <= joined.end;
                let members: Vec<usize> = (0..parts.len()).filter(|j| inside(&parts[*j])).collect();
                if members.len() < 2 || members.iter().all(|j| found[*j] < Size::INFINITE) {
                    continue;
                }
                let mut all = Anchors::default();
                for j in &members {
                    all.places.extend(&anchors[*j].places);
                    all.slopes.extend(&anchors[*j].slopes);
                }
                let kinks = (joined.start + 1..joined.end).map(|node| self.kink(node)).sum();
                let together = self.best_along(&Part { pieces: joined.clone(), kinks }, &all);
                for j in members {
                    found[j] = found[j].least(together);
                    self.hand_on(j, parts, &found, &mut anchors);
                }
            }
        }
        // Under axial tension, one anchor is sufficient for the whole beam.
        if let Some(tension) = frame.tension {
            let all = anchors.iter().flat_map(|part| &part.places).map(|anchor| anchor.bound);
            let least = all.fold(Size::INFINITE, Size::least);
            let length = Size::of(frame.length.high());
            let any = least + ((2.0 * self.energy).over(tension.low()) * length).root();
            found.iter_mut().for_each(|found| *found = found.least(any));
        }
        found
    }

    /// If the deflection error of part `j` has a finite bound, adds an anchor with this bound to each neighbouring
    /// part. The position of the anchor is the hinge that joins the two parts.
    fn hand_on(&self, j: usize, parts: &[Range<usize>], found: &[Size], anchors: &mut [Anchors]) {
        if !(found[j] < Size::INFINITE) {
            return;
        }
        let at = |node: usize| {
            let x = self.fields.frame.nodes[node].x;
            Anchor { x: [x.low(), x.high()], bound: found[j] }
        };
        if j > 0 {
            anchors[j - 1].places.push(at(parts[j].start));
        }
        if j + 1 < parts.len() {
            anchors[j + 1].places.push(at(parts[j].end));
        }
    }

    /// Returns a bound of the jump of the rotation error at a node, from the energy of its elastic hinge; zero without
    /// one.
    fn kink(&self, node: usize) -> Size {
        match self.fields.frame.nodes[node].hinge {
            None => Size::ZERO,
            Some(spring) => (2.0 * self.beam_energy()).over(spring.low()).root(),
        }
    }

    /// Returns the anchors of a part of the beam: the supports, contact nodes and contact intervals at which the error
    /// of the deflection or of the rotation is bounded.
    fn anchors(&self, part: &Range<usize>) -> Anchors {
        let frame = self.fields.frame;
        let mut anchors = Anchors::default();
        for node in part.start..=part.end {
            let here = &frame.nodes[node];
            let x = [here.x.low(), here.x.high()];
            let place = |bound: Size| Anchor { x, bound };
            if here.acts != Acts::Both {
                anchors.places.extend(self.pushed(node).map(place));
            } else if here.rigid.is_some() {
                anchors.places.push(place(Size::ZERO));
            }
            if here.clamped {
                anchors.slopes.push(place(Size::ZERO));
            }
            let energy = 2.0 * self.beam_energy();
            if let Some([spring, _]) = here.spring.filter(|_| here.acts == Acts::Both) {
                anchors.places.push(place(energy.over(spring.low()).root()));
            }
            if let Some(turning) = here.turning {
                anchors.slopes.push(place(energy.over(turning.low()).root()));
            }
            anchors.places.extend(self.pressed(node).map(place));
        }
        let s = self.flexure(part);
        let touching = part.clone().filter(|i| frame.spans[*i].touches);
        anchors.places.extend(touching.filter_map(|i| self.pressing(i, s)).flatten());
        anchors
    }

    /// Returns a bound of the deflection error at a contact node with a positive corrected force: the bound of the
    /// ground displacement error, plus the error energy divided by the force.
    fn pressed(&self, node: usize) -> Option<Size> {
        let surface = &self.fields.surface;
        let force = self.kept(self.balanced.factors[node].size()) * surface.nodes[node].force.low();
        (force > 0.0)
            .then(|| self.s2() * surface.flexibility_at(node) + self.energy.over(force.next_down()))
    }

    /// Returns a bound of the deflection error at an active one-way support, from the bound E of the error energy: E/R
    /// with the corrected reaction R of a rigid support, √(2E/κ) at a spring of stiffness κ.
    fn pushed(&self, node: usize) -> Option<Size> {
        let pushing = self.fields.residual.pushing[node].low();
        if let Some([spring, _]) = self.fields.frame.nodes[node].spring {
            // With a larger claimed force, the spring also acts in the exact solution.
            let least = (2.0 * Size::of(spring.high()) * self.energy).root();
            let bound = (2.0 * self.energy).over(spring.low()).root();
            return (pushing > least.value()).then_some(bound);
        }
        let kept = (self.kept(self.balanced.factors[node].size()) * pushing).next_down();
        (kept > 0.0).then(|| self.energy.over(kept))
    }

    /// Returns a lower bound of 1 − `factor`.
    fn kept(&self, factor: f64) -> f64 {
        (1.0 - factor).next_down()
    }

    /// Returns a lower bound of the corrected contact pressure on the middle part of a touching piece. `part` is the
    /// relative length of this middle part.
    pub(crate) fn least_pressure(&self, i: usize, part: f64) -> f64 {
        let pressure = &self.fields.pressures[i].field;
        let least = pressure.coefficient(0).low() - pressure.tail(part).value();
        (least.next_down() * self.kept(self.balanced.factor(i).value())).next_down()
    }

    /// Returns anchors at both ends of a middle part of a touching piece, by (12) of docs/proof.md. Chooses the part
    /// with the smallest bound among those with positive pressure.
    fn pressing(&self, i: usize, [s, sheared]: [Size; 2]) -> Option<[Anchor; 2]> {
        let span = &self.fields.frame.spans[i];
        let mut best: Option<[Anchor; 2]> = None;
        for part in parts_of(span) {
            let least = self.least_pressure(i, part);
            if !(least > 0.0) {
                continue;
            }
            // Length of the middle part of the piece, rounded down. `part` is this length divided by the length of the
            // piece.
            let length = (2.0 * part * span.half.low()).next_down();
            let ends = [-part, part].map(|t| span.middle + span.half * S::of(t));
            let half = Size::of((part * span.half.high()).next_up());
            let curved = s * half * half.root();
            let slid = sheared * half.root();
            let spread = (self.energy.over(least)).over(length);
            let settled = if span.layered {
                self.s2() * self.fields.surface.pieces[i].flexibility
            } else {
                (2.0 * self.energy).over(span.spring.low()).over(length).root()
            };
            let bound = from_mean(settled + spread, curved, slid);
            if best.is_none_or(|best| bound < best[0].bound) {
                let inside = [ends[0].high(), ends[1].low()];
                best = Some(inside.map(|x| Anchor { x: [x; 2], bound }));
            }
        }
        best
    }

    /// Returns the smallest of several bounds of the deflection error: from all anchors, and from only those with small
    /// bounds.
    fn best_along(&self, part: &Part, anchors: &Anchors) -> Size {
        let mut sorted = anchors.places.clone();
        sorted.sort_by(|a, b| a.bound.value().total_cmp(&b.bound.value()));
        let mut least = self.along(part, &sorted, &anchors.slopes);
        let mut count = 1;
        while count < sorted.len() {
            let level = 16.0 * sorted[count - 1].bound;
            while count < sorted.len() && sorted[count].bound <= level {
                count += 1;
            }
            least = least.least(self.along(part, &sorted[..count], &anchors.slopes));
            count += 1;
        }
        least
    }

    /// Returns a bound of the deflection error on a part: the largest of the bounds between anchors ([`between`]) and
    /// on overhangs ([`beyond`], [`along_slope`]), increased by the jumps at elastic hinges.
    fn along(&self, part: &Part, anchors: &[Anchor], slopes: &[Anchor]) -> Size {
        let frame = self.fields.frame;
        let [s, sheared] = self.flexure(&part.pieces);
        let mut anchors: Vec<&Anchor> =
            anchors.iter().filter(|anchor| anchor.bound < Size::INFINITE).collect();
        anchors.sort_by(|a, b| a.x[0].total_cmp(&b.x[0]));
        let (Some(first), Some(last)) = (anchors.first(), anchors.last()) else {
            return Size::INFINITE;
        };
        let mut largest = Size::ZERO;
        for pair in anchors.windows(2) {
            let gap = distance(pair[0].x[0], pair[1].x[1]);
            let ends = pair[0].bound.worst(pair[1].bound);
            let bent = between(gap, [s, sheared]) + 0.25 * (part.kinks * gap);
            largest = largest.worst(ends + bent);
        }
        largest = largest.worst(first.bound).worst(last.bound);
        let ends = [frame.nodes[part.pieces.start].x, frame.nodes[part.pieces.end].x];
        let left = distance(ends[0].low(), first.x[1]);
        let right = distance(last.x[0], ends[1].high());
        for (near, over, side) in [(first, left, 0), (last, right, 1)] {
            let mut least = Size::INFINITE;
            let apart =
                |far: &Anchor| distance(far.x[0], near.x[1]).worst(distance(near.x[0], far.x[1]));
            for slope in slopes.iter().filter(|slope| slope.bound < Size::INFINITE) {
                let turned = [slope.bound, apart(slope)];
                least = least.least(near.bound + along_slope(turned, over, [s, sheared]));
            }
            for far in &anchors {
                let gap = if side == 0 { far.x[0] - near.x[1] } else { near.x[0] - far.x[1] };
                let gap = gap.next_down();
                if gap > 0.0 {
                    let bounds = [near.bound, far.bound];
                    let distance = [gap, apart(far).value()];
                    least = least.least(beyond(bounds, over, distance, [s, sheared]));
                }
            }
            let outside = over.value() > 0.0;
            let end = least + part.kinks * over;
            largest = if outside { largest.worst(end) } else { largest };
        }
        largest
    }
}

/// Returns a bound of the deflection error on an interval from a bound of its mean, by (12) of docs/proof.md.
///
/// With half the length a, `curved` is s a^(3/2) and `slid` is s_γ √a; s and s_γ are the bounds of
/// [`Pointwise::flexure`].
pub(crate) fn from_mean(mean: Size, curved: Size, slid: Size) -> Size {
    let mean = mean + 0.2310 * curved + 0.6667 * slid;
    2.4143 * mean + 0.5774 * curved + slid
}

/// Returns a bound of the excess of the deflection error between two anchors at the distance `h` over the larger of
/// their bounds. `s` and `sheared` are the bounds of [`Pointwise::flexure`].
pub(crate) fn between(h: Size, [s, sheared]: [Size; 2]) -> Size {
    s * (h.square() * h).over(48.0).root() + 0.5 * (sheared * h.root())
}

/// Returns a bound of the deflection error on an overhang of length `over`, from the bounds at a near and a far
/// position. `distance` encloses the distance between these positions.
pub(crate) fn beyond(
    [near, far]: [Size; 2],
    over: Size,
    distance: [f64; 2],
    [s, sheared]: [Size; 2],
) -> Size {
    let long = Size::of(distance[1]);
    let turn = ((near + far) * over).over(distance[0]);
    let bent = s * (over.square() * (long + over)).over(3.0).root();
    let slid = sheared * (over * (long + over)).over(distance[0]).root();
    near + turn + bent + slid
}

/// Returns a bound of the change of the deflection error over the length `over`, from a bound `slope` of the rotation
/// error at most `distance` away. `s` and `sheared` are the bounds of [`Pointwise::flexure`].
pub(crate) fn along_slope(
    [slope, distance]: [Size; 2],
    over: Size,
    [s, sheared]: [Size; 2],
) -> Size {
    let bent = s * over * (distance + 0.33334 * over).root();
    slope * over + bent + sheared * over.root()
}

/// Returns an upper bound of the distance from a to b; zero if b lies left of a.
fn distance(a: f64, b: f64) -> Size {
    let d = (b - a).next_up();
    if d <= 0.0 { Size::ZERO } else { Size::of(d) }
}

mod tests;
