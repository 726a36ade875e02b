//! Bounds of the error e of the deflection, from the places where e is bounded: its anchors.

use crate::coefficient::Coefficient;
use crate::frame::Span;
use crate::model::Acts;
use crate::pointwise::Pointwise;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// The parts |t| ≤ … of a piece on which the least pressure is tried.
const PARTS: [f64; 4] = [0.9, 0.5, 0.25, 0.0625];

/// Those that lie within a piece: `half` need not be half of its length.
pub(crate) fn parts_of<S: Scalar>(span: &Span<S>) -> impl Iterator<Item = f64> {
    let [left, right] = [-span.t[0].high(), span.t[1].low()];
    PARTS.into_iter().filter(move |part| *part <= left && *part <= right)
}

/// A place with a bound of |e|.
#[derive(Debug, Clone, Copy)]
struct Anchor {
    /// An interval that holds the place.
    x: [f64; 2],
    bound: Size,
    clamp: bool,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// The parts of the beam between hinges of both kinds, as ranges of pieces.
    pub(crate) fn parts(&self) -> Vec<Range<usize>> {
        let frame = self.fields.frame;
        let mut parts = Vec::new();
        let mut first = 0;
        for i in 1..=frame.spans.len() {
            if i == frame.spans.len() || frame.nodes[i].is_hinged() {
                parts.push(first..i);
                first = i;
            }
        }
        parts
    }

    /// s = s₂/√EI_min and s_γ = s₂/√S_min of a part: e′ = e_φ + γ with (∫e_φ′²)^½ ≤ s and (∫γ²)^½ ≤ s_γ, where γ = 0 and
    /// s_γ = 0 if the part does not shear.
    pub(crate) fn flexure(&self, part: &Range<usize>) -> [Size; 2] {
        let spans = &self.fields.frame.spans[part.clone()];
        let most = |of: &dyn Fn(&Span<S>) -> Option<&Coefficient<S>>| {
            let all = spans.iter().filter_map(of);
            let largest = all.map(|x| Size::of(1.0).over(x.low())).fold(Size::ZERO, Size::worst);
            (2.0 * self.beam_energy() * largest).root()
        };
        [most(&|span| Some(&span.bending)), most(&|span| span.stiffness.as_ref())]
    }

    /// sup|e| on each part. A part needs two anchors or a clamp, and hands its bound on at hinges. Under tension one anchor
    /// anywhere is enough: |e(x)| ≤ |e(y)| + (2E/P)^½|x − y|^½.
    pub(crate) fn deflections(&self, parts: &[Range<usize>]) -> Vec<Size> {
        let frame = self.fields.frame;
        let mut anchors: Vec<Vec<Anchor>> = parts.iter().map(|part| self.anchors(part)).collect();
        let mut found = vec![Size::INFINITE; parts.len()];
        // How many anchors each part had when its bound was computed.
        let mut used = vec![0; parts.len()];
        for _ in 0..2 {
            let order: Vec<usize> = (0..parts.len()).chain((0..parts.len()).rev()).collect();
            for j in order {
                if anchors[j].len() == used[j] {
                    continue;
                }
                found[j] = found[j].least(self.best_along(&parts[j], &anchors[j]));
                used[j] = anchors[j].len();
                if !(found[j] < Size::INFINITE) {
                    continue;
                }
                let hand_on = |node: usize| {
                    let x = frame.nodes[node].x;
                    Anchor { x: [x.low(), x.high()], bound: found[j], clamp: false }
                };
                if j > 0 {
                    anchors[j - 1].push(hand_on(parts[j].start));
                }
                if j + 1 < parts.len() {
                    anchors[j + 1].push(hand_on(parts[j].end));
                }
            }
        }
        if let Some(tension) = frame.tension {
            let all = anchors.iter().flatten().map(|anchor| anchor.bound);
            let least = all.fold(Size::INFINITE, Size::least);
            let length = Size::of(frame.length.high());
            let any = least + ((2.0 * self.energy).over(tension.low()) * length).root();
            found.iter_mut().for_each(|found| *found = found.least(any));
        }
        found
    }

    /// The anchors of a part.
    fn anchors(&self, part: &Range<usize>) -> Vec<Anchor> {
        let frame = self.fields.frame;
        let mut anchors = Vec::new();
        for node in part.start..=part.end {
            let here = &frame.nodes[node];
            let x = [here.x.low(), here.x.high()];
            if here.acts != Acts::Both {
                anchors.extend(self.pushed(node).map(|bound| Anchor { x, bound, clamp: false }));
            } else if here.rigid.is_some() {
                anchors.push(Anchor { x, bound: Size::ZERO, clamp: here.clamped });
            }
            if let Some([spring, _]) = here.spring.filter(|_| here.acts == Acts::Both) {
                let bound = (2.0 * self.beam_energy()).over(spring.low()).root();
                anchors.push(Anchor { x, bound, clamp: false });
            }
            if let Some(bound) = self.pressed(node) {
                anchors.push(Anchor { x, bound, clamp: false });
            }
        }
        let s = self.flexure(part);
        let touching = part.clone().filter(|i| frame.spans[*i].touches);
        anchors.extend(touching.filter_map(|i| self.pressing(i, s)).flatten());
        anchors
    }

    /// At a touching node with a force ā ≥ (1 − |λ|)a > 0: e = d + C*, and āC* ≤ E.
    fn pressed(&self, node: usize) -> Option<Size> {
        let surface = &self.fields.surface;
        let force = self.kept(self.balanced.factors[node].size()) * surface.nodes[node].force.low();
        (surface.touches[node] && force > 0.0)
            .then(|| self.s2() * surface.flexibility_at(node) + self.energy.over(force.next_down()))
    }

    /// At a support of one direction that acts. A rigid one with ρ̄ ≥ (1 − |λ|)|R|: ρ̄ς(w̄ − w*) ≤ E. A spring with
    /// κv̄ > (2κE)^½ acts in the exact solution too, and ½κe² ≤ E.
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

    /// On an interval of length h with p̄ ≥ p_m > 0 the mean of |d + C*| is at most d₁ + E/(p_m h), and e differs from a
    /// straight line by little. Both ends of the interval are anchors with
    ///
    /// ```text
    /// |e| ≤ (1 + √2)(d₁ + E/(p_m h) + (2/(5√3)) s(h/2)^{3/2} + ⅔s_γ(h/2)^½) + s(h/2)^{3/2}/√3 + s_γ(h/2)^½,
    /// ```
    ///
    /// d₁ = s₂√g in a layer, (2E/(kh))^½ on separate springs.
    fn pressing(&self, i: usize, [s, sheared]: [Size; 2]) -> Option<[Anchor; 2]> {
        let span = &self.fields.frame.spans[i];
        let kept = self.kept(self.balanced.factor(i).value());
        let mut best: Option<[Anchor; 2]> = None;
        for part in parts_of(span) {
            let least = self.least_pressure(i, part);
            if !(least > 0.0 && kept > 0.5) {
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
            let mean = settled + spread + 0.2310 * curved + 0.6667 * slid;
            let bound = 2.4143 * mean + 0.5774 * curved + slid;
            if best.is_none_or(|best| bound < best[0].bound) {
                let inside = [ends[0].high(), ends[1].low()];
                best = Some(inside.map(|x| Anchor { x: [x; 2], bound, clamp: false }));
            }
        }
        best
    }

    /// The least of sup|e| on a part over sets of anchors: all whose bound is below some level.
    fn best_along(&self, part: &Range<usize>, anchors: &[Anchor]) -> Size {
        let mut sorted = anchors.to_vec();
        sorted.sort_by(|a, b| a.bound.value().total_cmp(&b.bound.value()));
        let mut least = self.along(part, &sorted);
        let mut count = 1;
        while count < sorted.len() {
            let level = 16.0 * sorted[count - 1].bound;
            while count < sorted.len() && sorted[count].bound <= level {
                count += 1;
            }
            least = least.least(self.along(part, &sorted[..count]));
            count += 1;
        }
        least
    }

    /// sup|e| on a part: between anchors at distance h the larger bound + s(h³/48)^½ + ½s_γh^½; on an overhang o beyond
    /// anchors b₁ (nearer) and b₂ at distance h: b₁ + (b₁ + b₂)o/h + s(o²(h + o)/3)^½ + s_γ(o(h + o)/h)^½; beyond a clamp
    /// s o^{3/2}/√3 + s_γo^½.
    fn along(&self, part: &Range<usize>, anchors: &[Anchor]) -> Size {
        let frame = self.fields.frame;
        let [s, sheared] = self.flexure(part);
        let mut anchors: Vec<&Anchor> =
            anchors.iter().filter(|anchor| anchor.bound < Size::INFINITE).collect();
        anchors.sort_by(|a, b| a.x[0].total_cmp(&b.x[0]));
        let (Some(first), Some(last)) = (anchors.first(), anchors.last()) else {
            return Size::INFINITE;
        };
        let mut largest = Size::ZERO;
        for pair in anchors.windows(2) {
            let gap = distance(pair[0].x[0], pair[1].x[1]);
            let cube = gap.square() * gap;
            let bent = s * cube.over(48.0).root() + 0.5 * (sheared * gap.root());
            largest = largest.worst(pair[0].bound.worst(pair[1].bound) + bent);
        }
        largest = largest.worst(first.bound).worst(last.bound);
        let ends = [frame.nodes[part.start].x, frame.nodes[part.end].x];
        let left = distance(ends[0].low(), first.x[1]);
        let right = distance(last.x[0], ends[1].high());
        for (near, over, side) in [(first, left, 0), (last, right, 1)] {
            let mut least = Size::INFINITE;
            if near.clamp {
                least = 0.5774 * (s * over * over.root()) + sheared * over.root();
            }
            for far in &anchors {
                let gap = if side == 0 { far.x[0] - near.x[1] } else { near.x[0] - far.x[1] };
                let gap = gap.next_down();
                if gap > 0.0 {
                    let turn = ((near.bound + far.bound) * over).over(gap);
                    let long = distance(far.x[0], near.x[1]).worst(distance(near.x[0], far.x[1]));
                    let bent = s * (over.square() * (long + over)).over(3.0).root();
                    let slid = sheared * (over * (long + over)).over(gap).root();
                    least = least.least(near.bound + turn + bent + slid);
                }
            }
            let outside = over.value() > 0.0;
            largest = if outside { largest.worst(least) } else { largest };
        }
        largest
    }
}

/// A bound of the distance from a to b, zero if b lies before a.
fn distance(a: f64, b: f64) -> Size {
    let d = (b - a).next_up();
    if d <= 0.0 { Size::ZERO } else { Size::of(d) }
}

#[cfg(test)]
mod tests {
    use super::parts_of;
    use crate::answer::Piece;
    use crate::frame::Span;
    use crate::scalar::Scalar;
    use crate::units::Units;
    use crate::wide::Wide;

    /// With half = 1 a piece of the length 1.6 runs over |t| ≤ 0.8.
    #[test]
    fn the_least_pressure_is_that_of_the_piece_alone() {
        for (half, wanted) in [(1.0, &[0.5, 0.25, 0.0625][..]), (0.8, &[0.9, 0.5, 0.25, 0.0625])] {
            let piece = Piece { x: [0.0, 1.6], half, deflection: vec![1.0], ..Piece::default() };
            let units = Units { length: 0, force: 0 };
            let span = Span::of(&piece, [0.0, 1.6].map(Wide::of), units).expect("a piece");
            assert_eq!(parts_of(&span).collect::<Vec<_>>(), wanted);
        }
    }
}
