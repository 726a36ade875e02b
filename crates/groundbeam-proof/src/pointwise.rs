//! Bounds at every point of the beam: of settlement, bending moment, deflection and slope.
//!
//! All follow from the parts of E, each of which is at most E: with s₂ = √(2E), e = w̄ − w*, d = ū − u*,
//!
//! ```text
//! ‖d‖_b ≤ s₂,   (∫EI e″²)^½ ≤ s₂,   (∫P e′²)^½ ≤ s₂,   √κ|e| ≤ s₂ at springs,   ⟨p̄, C*⟩ ≤ E.
//! ```

use crate::balance::Balanced;
use crate::fields::Fields;
use crate::scalar::Scalar;
use crate::size::Size;
use std::ops::Range;

/// Bounds of the error at every point of the beam: |claimed − exact| is at most this. Infinite: nothing is proven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Of w \[m\].
    pub deflection: f64,
    /// Of w′ \[rad\], on both sides of hinges.
    pub slope: f64,
    /// Of M \[N·m\].
    pub moment: f64,
    /// Of u \[m\].
    pub settlement: f64,
}

/// The bounds on one piece, in the units of the proof.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PieceBounds {
    pub deflection: Size,
    pub slope: Size,
    pub moment: Size,
    pub settlement: Size,
}

/// A place with a bound of |e|.
#[derive(Debug, Clone, Copy)]
struct Anchor {
    /// An interval that holds the place.
    x: [f64; 2],
    bound: Size,
    clamp: bool,
}

/// Everything that the bounds are computed from.
pub(crate) struct Pointwise<'a, S> {
    pub fields: &'a Fields<'a, S>,
    pub balanced: &'a Balanced<S>,
    pub energy: Size,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// The bounds on all pieces.
    pub fn bounds(&self) -> Vec<PieceBounds> {
        let moments = self.moments();
        let mut bounds: Vec<PieceBounds> = moments
            .iter()
            .map(|moment| PieceBounds {
                deflection: Size::INFINITE,
                slope: Size::INFINITE,
                moment: *moment,
                settlement: Size::INFINITE,
            })
            .collect();
        let parts = self.parts();
        for (part, error) in parts.iter().zip(self.deflections(&parts)) {
            self.on_part(part, error, &moments, &mut bounds);
        }
        for (i, piece) in bounds.iter_mut().enumerate() {
            piece.settlement = self.settlement(i, piece.deflection);
        }
        bounds
    }

    fn s2(&self) -> Size {
        (2.0 * self.energy).root()
    }

    /// |u − u*| in a layer: d(x) = b(d, g(x, ·)) ≤ s₂√g, and what closing and lifting add. On separate springs
    /// u* = max(w* − g₀, 0).
    fn settlement(&self, i: usize, deflection: Size) -> Size {
        let fields = self.fields;
        let (span, raised) = (&fields.frame.spans[i], fields.clearance.raised[i]);
        if span.layered {
            let energy = self.s2() * fields.surface.flexibility[i];
            return energy
                + if span.touches { fields.deflection.pieces[i].bounds[0] } else { raised };
        }
        let sunk = fields.pressures[i].depth.over(span.spring.low());
        deflection + if span.touches { sunk } else { raised }
    }

    /// |M − M*| on each piece: s₂ K(z) + |δ| with
    ///
    /// ```text
    /// K² = ∫EI z″² + ∫(P + μ)z′² + ∫kz² + K₀z(0)² + K_lz(l)² + Σκz² + Σκ_θz′²
    /// ```
    ///
    /// for any z with a unit kink at x, z = 0 at rigid supports and z′ = 0 at clamps.
    fn moments(&self) -> Vec<Size> {
        let frame = self.fields.frame;
        let last = frame.spans.len();
        let stops =
            |node: &usize| *node == 0 || *node == last || frame.nodes[*node].rigid.is_some();
        let stops: Vec<usize> = (0..=last).filter(stops).collect();
        let mut stiffness = vec![Size::INFINITE; last];
        for pair in stops.windows(2) {
            let short = self.short_kink(pair[0]..pair[1]);
            stiffness[pair[0]..pair[1]].fill(short);
        }
        for side in [0, 1] {
            self.long_kinks(side, &mut stiffness);
        }
        let moment = |(i, stiffness): (usize, &Size)| {
            let [a, b] = self.balanced.moments[i].map(|moment| Size::of(moment.size()));
            let residual = &self.fields.residual.pieces[i];
            let load = Size::of(residual.constant.size()) + residual.rest;
            let bent = frame.spans[i].length().square() * load;
            let delta = a.worst(b) + bent.over(8.0) + self.balanced.added[i][0];
            self.s2() * stiffness.root() + delta
        };
        stiffness.iter().enumerate().map(moment).collect()
    }

    /// K² for z = t(1 − t/h)² on the side of x with more room between two obstacles:
    /// 4EI/h + (2/15)(P + μ)h + kh³/105 + Σκ(4h/27)² + Σκ_θ.
    fn short_kink(&self, nodes: Range<usize>) -> Size {
        let frame = self.fields.frame;
        let room = (frame.nodes[nodes.end].x - frame.nodes[nodes.start].x).scaled(-1);
        let [bending, layer, springs] = self.largest(nodes.clone());
        let (mut supports, mut turning) = (Size::ZERO, Size::ZERO);
        for node in &frame.nodes[nodes.start..=nodes.end] {
            supports += node.spring.map_or(Size::ZERO, |[spring, _]| Size::of(spring.high()));
            turning += node.turning.map_or(Size::ZERO, |turning| Size::of(turning.high()));
        }
        let mut least = Size::INFINITE;
        let mut h = room.low();
        for _ in 0..24 {
            let long = Size::of(h);
            let cube = long.square() * long;
            let all = (4.0 * bending).over(h)
                + 0.134 * (layer * long)
                + (springs * cube).over(105.0)
                + supports * (0.1482 * long).square()
                + turning;
            least = least.least(all);
            h *= 0.5;
        }
        least
    }

    /// The largest EI, P + μ and k between two nodes.
    fn largest(&self, nodes: Range<usize>) -> [Size; 3] {
        let frame = self.fields.frame;
        let tension = Size::of(frame.tension.map_or(0.0, |tension| tension.high()));
        let mut largest = [Size::ZERO; 3];
        for span in &frame.spans[nodes] {
            let layer = tension + Size::of(span.shear.size());
            let here = [Size::of(span.bending.high()), layer, Size::of(span.spring.high())];
            for (most, here) in largest.iter_mut().zip(here) {
                *most = most.worst(here);
            }
        }
        largest
    }

    /// K² for z = the distance from x to one side, up to the end of the beam, as long as no rigid support stands there:
    /// (P + μ)L + kL³/3 + K_eL² + Σ(κ(x − x_j)² + κ_θ). It has no EI: the bound for stiff beams.
    fn long_kinks(&self, side: usize, stiffness: &mut [Size]) {
        let frame = self.fields.frame;
        let count = frame.spans.len();
        let (mut layer, mut springs) = (Size::ZERO, Size::ZERO);
        let mut held: Vec<usize> = Vec::new();
        for step in 0..count {
            let i = if side == 0 { step } else { count - 1 - step };
            // The outer node of the piece, and the inner one: x is anywhere on the piece.
            let (outer, inner) = (i + side, i + 1 - side);
            let node = &frame.nodes[outer];
            if node.rigid.is_some() {
                return;
            }
            if node.spring.is_some() || node.turning.is_some() {
                held.push(outer);
            }
            let [_, more_layer, more_springs] = self.largest(i..i + 1);
            (layer, springs) = (layer.worst(more_layer), springs.worst(more_springs));
            let from = frame.nodes[inner].x;
            let reach = |x: S| Size::of((x - from).size());
            let long = reach(frame.nodes[[0, count][side]].x);
            let mut sum = layer * long + (springs * long.square() * long).over(3.0);
            sum += Size::of(frame.outside[side].high()) * long.square();
            for node in held.iter().map(|node| &frame.nodes[*node]) {
                let spring = node.spring.map_or(0.0, |[spring, _]| spring.high());
                sum += Size::of(spring) * reach(node.x).square();
                sum += Size::of(node.turning.map_or(0.0, |turning| turning.high()));
            }
            stiffness[i] = stiffness[i].least(sum);
        }
    }

    /// The parts of the beam between hinges of both kinds, as ranges of pieces.
    fn parts(&self) -> Vec<Range<usize>> {
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

    /// s = s₂/√EI_min of a part: (∫e″²)^½ ≤ s.
    fn flexure(&self, part: &Range<usize>) -> Size {
        let spans = &self.fields.frame.spans[part.clone()];
        let lows = spans.iter().map(|span| span.bending.low());
        let least = lows.fold(f64::INFINITY, |least, low| if low < least { low } else { least });
        (2.0 * self.energy).over(least).root()
    }

    /// sup|e| on each part. A part needs two anchors or a clamp, and hands its bound on at hinges. Under tension one anchor
    /// anywhere is enough: |e(x)| ≤ |e(y)| + (2E/P)^½|x − y|^½.
    fn deflections(&self, parts: &[Range<usize>]) -> Vec<Size> {
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
            if here.rigid.is_some() {
                anchors.push(Anchor { x, bound: Size::ZERO, clamp: here.clamped });
            }
            if let Some([spring, _]) = here.spring {
                let bound = (2.0 * self.energy).over(spring.low()).root();
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
        let force = self.kept(self.balanced.factors[node].size()) * surface.force[node].low();
        (surface.touches[node] && force > 0.0)
            .then(|| self.s2() * surface.flexibility_at(node) + self.energy.over(force.next_down()))
    }

    /// A lower bound of 1 − γ.
    fn kept(&self, factor: f64) -> f64 {
        (1.0 - factor).next_down()
    }

    /// On an interval of length h with p̄ ≥ p_m > 0 the mean of |d + C*| is at most d₁ + E/(p_m h), and e differs from a
    /// straight line by little. Both ends of the interval are anchors with
    ///
    /// ```text
    /// |e| ≤ (1 + √2)(d₁ + E/(p_m h) + (2/(5√3)) s(h/2)^{3/2}) + s(h/2)^{3/2}/√3,
    /// ```
    ///
    /// d₁ = s₂√g in a layer, (2E/(kh))^½ on separate springs.
    fn pressing(&self, i: usize, s: Size) -> Option<[Anchor; 2]> {
        let span = &self.fields.frame.spans[i];
        let pressure = &self.fields.pressures[i].field;
        let kept = self.kept(self.balanced.factor(i).value());
        let mut best: Option<[Anchor; 2]> = None;
        for part in [0.9, 0.5, 0.25, 0.0625] {
            let least = pressure.coefficient(0).low() - pressure.tail(part).value();
            let least = (least.next_down() * kept).next_down();
            if !(least > 0.0 && kept > 0.5) {
                continue;
            }
            // |t| ≤ part is an interval of the length 2·part·half.
            let length = (2.0 * part * span.half.low()).next_down();
            let ends = [-part, part].map(|t| span.middle + span.half * S::of(t));
            let half = Size::of((part * span.half.high()).next_up());
            let curved = s * half * half.root();
            let spread = (self.energy.over(least)).over(length);
            let settled = if span.layered {
                self.s2() * self.fields.surface.flexibility[i]
            } else {
                (2.0 * self.energy).over(span.spring.low()).over(length).root()
            };
            let bound = 2.4143 * (settled + spread + 0.2310 * curved) + 0.5774 * curved;
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

    /// sup|e| on a part: between anchors at distance h the larger bound + s(h³/48)^½; on an overhang o beyond anchors b₁
    /// (nearer) and b₂ at distance h: b₁ + (b₁ + b₂)o/h + s(o²(h + o)/3)^½; beyond a clamp s o^{3/2}/√3.
    fn along(&self, part: &Range<usize>, anchors: &[Anchor]) -> Size {
        let frame = self.fields.frame;
        let s = self.flexure(part);
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
            let bent = s * cube.over(48.0).root();
            largest = largest.worst(pair[0].bound.worst(pair[1].bound) + bent);
        }
        largest = largest.worst(first.bound).worst(last.bound);
        let ends = [frame.nodes[part.start].x, frame.nodes[part.end].x];
        let left = distance(ends[0].low(), first.x[1]);
        let right = distance(last.x[0], ends[1].high());
        for (near, over, side) in [(first, left, 0), (last, right, 1)] {
            let mut least = Size::INFINITE;
            if near.clamp {
                least = 0.5774 * (s * over * over.root());
            }
            for far in &anchors {
                let gap = if side == 0 { far.x[0] - near.x[1] } else { near.x[0] - far.x[1] };
                let gap = gap.next_down();
                if gap > 0.0 {
                    let turn = ((near.bound + far.bound) * over).over(gap);
                    let long = distance(far.x[0], near.x[1]).worst(distance(near.x[0], far.x[1]));
                    let bent = s * (over.square() * (long + over)).over(3.0).root();
                    least = least.least(near.bound + turn + bent);
                }
            }
            let outside = over.value() > 0.0;
            largest = if outside { largest.worst(least) } else { largest };
        }
        largest
    }

    /// ε_w = sup|e| + max|c|, and ε_θ = min_h {2 sup|e|/h + min(½h max(ε_w″ + |c″|), s(h/3)^½)} + max|c′|.
    fn on_part(
        &self,
        part: &Range<usize>,
        error: Size,
        moments: &[Size],
        bounds: &mut [PieceBounds],
    ) {
        let frame = self.fields.frame;
        let closed = &self.fields.deflection.pieces;
        let s = self.flexure(part);
        let mut most = [Size::ZERO; 3];
        for i in part.clone() {
            let curvature = moments[i].over(frame.spans[i].bending.low()) + closed[i].bounds[2];
            let here = [closed[i].bounds[0], closed[i].bounds[1], curvature];
            for (most, here) in most.iter_mut().zip(here) {
                *most = most.worst(here);
            }
        }
        let mut h = (frame.nodes[part.end].x - frame.nodes[part.start].x).low();
        let mut slope = Size::INFINITE;
        for _ in 0..60 {
            let long = Size::of(h);
            let bent = (0.5 * (long * most[2])).least(s * long.over(3.0).root());
            slope = slope.least((2.0 * error).over(h) + bent);
            h *= 0.7;
        }
        for i in part.clone() {
            bounds[i].deflection = error + most[0];
            bounds[i].slope = slope + most[1];
        }
    }
}

/// A bound of the distance from a to b, zero if b lies before a.
fn distance(a: f64, b: f64) -> Size {
    let d = (b - a).next_up();
    if d <= 0.0 { Size::ZERO } else { Size::of(d) }
}
