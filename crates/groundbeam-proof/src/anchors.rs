//! Bounds of the error e of the deflection on the whole beam, from positions (anchors) where |e| or |e_φ| is bounded.

use crate::coefficient::Coefficient;
use crate::frame::{Node, Span};
use crate::model::Acts;
use crate::pointwise::Pointwise;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// Fractions c such that a lower bound of the pressure is computed on the part |t| ≤ c of a piece.
const PARTS: [f64; 4] = [0.9, 0.5, 0.25, 0.0625];

/// The `PARTS` that lie within the piece; `half` may be less than half the length.
pub(crate) fn parts_of<S: Scalar>(span: &Span<S>) -> impl Iterator<Item = f64> {
    let [left, right] = [-span.t[0].high(), span.t[1].low()];
    PARTS.into_iter().filter(move |part| *part <= left && *part <= right)
}

/// A position with a bound of |e|, or of |e_φ|.
#[derive(Debug, Clone, Copy)]
struct Anchor {
    /// An interval that contains the position.
    x: [f64; 2],
    bound: Size,
}

/// The anchors on one part of the beam.
#[derive(Debug, Clone, Default)]
struct Anchors {
    /// Positions with a bound of |e|.
    places: Vec<Anchor>,
    /// Positions with a bound of |e_φ|: clamps and rotational springs.
    slopes: Vec<Anchor>,
}

impl Anchors {
    fn count(&self) -> usize {
        self.places.len() + self.slopes.len()
    }
}

/// A part of the beam without free hinges.
struct Part {
    pieces: Range<usize>,
    /// A bound of Σ|[e_φ]| over the elastic hinges inside the part.
    kinks: Size,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// The parts of the beam between hinges of both kinds, as ranges of pieces.
    pub(crate) fn parts(&self) -> Vec<Range<usize>> {
        self.cut(|node| node.is_hinged())
    }

    /// The parts of the beam between free hinges.
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

    /// s = s₂/√EI_min and s_γ = s₂/√S_min of a part: e′ = e_φ + γ with (∫e_φ′²)^½ ≤ s and (∫γ²)^½ ≤ s_γ,
    /// where γ = 0 and s_γ = 0 if the part has no shear deformation.
    pub(crate) fn flexure(&self, part: &Range<usize>) -> [Size; 2] {
        let spans = &self.fields.frame.spans[part.clone()];
        let most = |of: &dyn Fn(&Span<S>) -> Option<&Coefficient<S>>| {
            let all = spans.iter().filter_map(of);
            let largest = all.map(|x| Size::of(1.0).over(x.low())).fold(Size::ZERO, Size::worst);
            (2.0 * self.beam_energy() * largest).root()
        };
        [most(&|span| Some(&span.bending)), most(&|span| span.stiffness.as_ref())]
    }

    /// sup|e| on each part between hinges. A part needs two anchors, or one anchor and a bound of its slope.
    /// Its bound then gives anchors of the neighbours at the common hinges. Parts joined by elastic hinges
    /// also have a common bound, with a kink of at most (2E/k_φ)^½ at each hinge. Under tension, one anchor
    /// is sufficient: |e(x)| ≤ |e(y)| + (2E/P)^½|x − y|^½.
    pub(crate) fn deflections(&self, parts: &[Range<usize>]) -> Vec<Size> {
        let frame = self.fields.frame;
        let mut anchors: Vec<Anchors> = parts.iter().map(|part| self.anchors(part)).collect();
        let mut found = vec![Size::INFINITE; parts.len()];
        // Number of anchors with which the bound of each part was last computed.
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
        if let Some(tension) = frame.tension {
            let all = anchors.iter().flat_map(|part| &part.places).map(|anchor| anchor.bound);
            let least = all.fold(Size::INFINITE, Size::least);
            let length = Size::of(frame.length.high());
            let any = least + ((2.0 * self.energy).over(tension.low()) * length).root();
            found.iter_mut().for_each(|found| *found = found.least(any));
        }
        found
    }

    /// Adds an anchor to each neighbour of a bounded part, at their common hinge.
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

    /// A bound of |[e_φ]| at an elastic hinge, ½k_φ[e_φ]² ≤ E; zero at other nodes.
    fn kink(&self, node: usize) -> Size {
        match self.fields.frame.nodes[node].hinge {
            None => Size::ZERO,
            Some(spring) => (2.0 * self.beam_energy()).over(spring.low()).root(),
        }
    }

    /// The anchors of a part.
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

    /// Bound of |e| at a touching node with a force ā ≥ (1 − |λ|)a > 0: e = d + C*, and āC* ≤ E.
    fn pressed(&self, node: usize) -> Option<Size> {
        let surface = &self.fields.surface;
        let force = self.kept(self.balanced.factors[node].size()) * surface.nodes[node].force.low();
        (force > 0.0)
            .then(|| self.s2() * surface.flexibility_at(node) + self.energy.over(force.next_down()))
    }

    /// Bound of |e| at an active one-way support. For a rigid support with ρ̄ ≥ (1 − |λ|)|R|, ρ̄ς(w̄ − w*) ≤
    /// E. A spring with κv̄ > (2κE)^½ is also active in the exact solution, so ½κe² ≤ E.
    fn pushed(&self, node: usize) -> Option<Size> {
        let pushing = self.fields.residual.pushing[node].low();
        if let Some([spring, _]) = self.fields.frame.nodes[node].spring {
            let least = (2.0 * Size::of(spring.high()) * self.energy).root();
            let bound = (2.0 * self.energy).over(spring.low()).root();
            return (pushing > least.value()).then_some(bound);
        }
        let kept = (self.kept(self.balanced.factors[node].size()) * pushing).next_down();
        (kept > 0.0).then(|| self.energy.over(kept))
    }

    /// A lower bound of 1 − γ.
    fn kept(&self, factor: f64) -> f64 {
        (1.0 - factor).next_down()
    }

    /// A lower bound p_m of p̄ ≥ (1 − γ)p on the part |t| ≤ `part` of a touching piece.
    pub(crate) fn least_pressure(&self, i: usize, part: f64) -> f64 {
        let pressure = &self.fields.pressures[i].field;
        let least = pressure.coefficient(0).low() - pressure.tail(part).value();
        (least.next_down() * self.kept(self.balanced.factor(i).value())).next_down()
    }

    /// On an interval of length h with p̄ ≥ p_m > 0 the mean of |d + C*| is at most d₁ + E/(p_m h). The
    /// difference of e and a linear function is bounded by s and s_γ. So both ends of the interval are
    /// anchors with
    ///
    /// ```text
    /// |e| ≤ (1 + √2)(d₁ + E/(p_m h) + (2/(5√3)) s(h/2)^{3/2} + ⅔s_γ(h/2)^½) + s(h/2)^{3/2}/√3 + s_γ(h/2)^½,
    /// ```
    ///
    /// d₁ = s₂√g in a layer, (2E/(kh))^½ on Winkler ground.
    fn pressing(&self, i: usize, [s, sheared]: [Size; 2]) -> Option<[Anchor; 2]> {
        let span = &self.fields.frame.spans[i];
        let mut best: Option<[Anchor; 2]> = None;
        for part in parts_of(span) {
            let least = self.least_pressure(i, part);
            if !(least > 0.0) {
                continue;
            }
            // |t| ≤ part is an interval of the length 2·part·half.
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

    /// The smallest bound of sup|e| on a part. Each trial uses the anchors whose bounds lie below one level.
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

    /// sup|e| on a part whose kinks have a sum of at most j:
    ///
    /// - between anchors at distance h, the larger bound + s(h³/48)^½ + ½s_γh^½ + ¼jh;
    /// - on an overhang o beyond anchors b₁ (nearer) and b₂ at distance h,
    ///   b₁ + (b₁ + b₂)o/h + s(o²(h + o)/3)^½ + s_γ(o(h + o)/h)^½ + jo;
    /// - where |e_φ| ≤ θ at a distance d from the anchor, b₁ + θo + so(d + o/3)^½ + s_γo^½ + jo.
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

/// A bound of |e| on an interval, from a bound of the mean of |e|, from `curved` = s(h/2)^{3/2} and from
/// `slid` = s_γ(h/2)^½. These two bound the difference of e and its tangent in the middle. The absolute value
/// of a linear function is at most 1 + √2 times its mean.
pub(crate) fn from_mean(mean: Size, curved: Size, slid: Size) -> Size {
    let mean = mean + 0.2310 * curved + 0.6667 * slid;
    2.4143 * mean + 0.5774 * curved + slid
}

/// s(h³/48)^½ + ½s_γh^½: the largest excess of |e| over its values at both ends of a length h.
pub(crate) fn between(h: Size, [s, sheared]: [Size; 2]) -> Size {
    s * (h.square() * h).over(48.0).root() + 0.5 * (sheared * h.root())
}

/// A bound of |e| on an overhang of length o. `near` and `far` are bounds of |e| at two positions beside it, the nearer one
/// first. `distance` has a lower and an upper bound of the distance between the two positions.
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

/// θo + so(d + o/3)^½ + s_γo^½: the change of e over a length o, if |e_φ| ≤ θ at a position not farther than d from its
/// start.
pub(crate) fn along_slope(
    [slope, distance]: [Size; 2],
    over: Size,
    [s, sheared]: [Size; 2],
) -> Size {
    let bent = s * over * (distance + 0.33334 * over).root();
    slope * over + bent + sheared * over.root()
}

/// An upper bound of the distance from a to b, zero if b lies left of a.
fn distance(a: f64, b: f64) -> Size {
    let d = (b - a).next_up();
    if d <= 0.0 { Size::ZERO } else { Size::of(d) }
}

mod tests;
