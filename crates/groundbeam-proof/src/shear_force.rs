//! Bounds of the error of the shear force, from the change of moment over a window and the errors of the
//! loads in the window.
//!
//! T̃ = (m − M*)′ + P(e′ − c′) + β is the error of the transverse force, and β is the transverse force that
//! the tension carries in the balance. On a window of length h without rigid support its mean is at most
//! (2s₂K + 2P sup|e|)/h + P max|c′| + max|β|, and it differs from its mean by the errors of pressure,
//! concentrated forces and springs inside:
//!
//! ```text
//! ε_T = min_h {(2s₂K + 2P sup|e| + Σs₂√κ_θ)/h + ½hq} + P max|c′| + max|β| + Σ(θp_o + θ′p_i) + Σ(ε_a + |λ|a) + Σs₂√κ,
//! ε_V = |δ′| + Pε_φ + |β| + ε_T,   q = max(ε_p + γp + (1 + γ)η).
//! ```
//!
//! Where a beam without shear deformation has no hinge in the window, T̃ − Pe′ takes the place of T̃. This
//! gives a bound of the error of V from the error of the curvature, without the errors of deflection and
//! slope:
//!
//! ```text
//! ε_V = |δ′| + |β| + min_h {(2s₂K + Σs₂√κ_θ)/h + ½h(q + P max|e″|)} + 2P max|c′| + max|β| + forces,   |e″| ≤ ε_M/EI + |c″|.
//! ```

use crate::coefficient::Coefficient;
use crate::contact_set::Shown;
use crate::edge_forces::edges_of_pieces;
use crate::frame::Span;
use crate::pointwise::{PieceBounds, Pointwise};
use crate::polynomial::Polynomial;
use crate::scalar::Scalar;
use crate::size::Size;
use crate::test_functions::least_of_halves;
use std::ops::Range;

/// The errors of the forces inside a window, and the errors of its rotational springs.
fn inside(window: &Range<usize>, loads: &[LoadError], nodes: &[[Size; 2]]) -> [Size; 2] {
    let [mut forces, mut couples] = [Size::ZERO; 2];
    for i in window.clone() {
        forces += loads[i].edges;
        if i > window.start {
            forces += nodes[i][0];
            couples += nodes[i][1];
        }
    }
    [forces, couples]
}

/// A bound of the absolute value of a polynomial within a distance of the left or the right end of a piece.
fn size_beside<S: Scalar>(span: &Span<S>, p: &Polynomial<S>, side: usize, distance: Size) -> Size {
    let part = distance.over(span.half.low()).value().next_up();
    if !(part < 1.0) {
        return p.size(span.tau);
    }
    let end = span.interval()[side];
    let middle = if side == 0 { end + 0.5 * part } else { end - 0.5 * part };
    // The margin allows for rounding of the end and the middle.
    let reach = 0.5 * part + 8.0 * f64::EPSILON;
    p.shifted(middle).size(reach).least(p.size(span.tau))
}

/// Number of pieces by which a window extends to each side.
const REACHES: [usize; 5] = [0, 1, 3, 7, 15];

/// The error of the loads on one piece.
#[derive(Clone, Copy)]
struct LoadError {
    /// q, per length.
    spread: Size,
    /// Force error of the lengths where only one of the two solutions is in contact.
    edges: Size,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Lowers the bounds of the shear force on all pieces, and of the slope on a beam with shear deformation.
    /// It needs the contact set of all layers, or rough bounds of it.
    pub fn shear_forces(&self, shown: &Shown, bounds: &mut [PieceBounds]) {
        if shown.failed[0].is_some() {
            return;
        }
        let loads = self.load_errors(shown, bounds);
        let nodes: Vec<[Size; 2]> =
            (0..=bounds.len()).map(|node| self.node_error(node, shown)).collect();
        let edges = edges_of_pieces(&shown.edges, bounds.len());
        for pair in self.obstacles().windows(2) {
            for i in pair[0]..pair[1] {
                let turned = self.axial_size() * bounds[i].rotation;
                let rest = turned + self.balancing_shear(i) + self.balanced.pieces[i].drawn;
                let [mut least, mut directly] = [Size::INFINITE; 2];
                if edges[i] != [None; 2] {
                    let steady = self.steady(i..i + 1, 0.5, bounds, &loads, Size::ZERO);
                    let slid = self.slid(i);
                    let both = [steady, rest + slid];
                    least = self.beside_edges(i, &bounds[i], &edges[i], both);
                }
                for reach in REACHES {
                    let from = i.saturating_sub(reach).max(pair[0]);
                    let window = from..(i + 1 + reach).min(pair[1]);
                    least = least.least(self.mean(window.clone(), bounds, &loads, &nodes));
                    directly =
                        directly.least(self.directly(window.clone(), bounds, &loads, &nodes));
                    if window == (pair[0]..pair[1]) {
                        break;
                    }
                }
                let directly = directly + self.balancing_shear(i) + self.balanced.pieces[i].drawn;
                self.on_piece(i, (least + rest).least(directly), &mut bounds[i]);
            }
        }
    }

    /// The bounds of V, and of w′ where the beam has shear deformation, from a bound of ε_T + |δ′| + |P|ε_φ:
    /// with η = S(w′ − φ) − V
    ///
    /// ```text
    /// ε_V = (ε_T + |δ′| + |P|ε_φ + |P||η|/S)/(1 + P/S),   ε_θ = ε_φ + (ε_V + |η|)/S.
    /// ```
    fn on_piece(&self, i: usize, all: Size, bounds: &mut PieceBounds) {
        let frame = self.fields.frame;
        let Some(stiffness) = &frame.spans[i].stiffness else {
            bounds.shear_force = bounds.shear_force.least(all);
            return;
        };
        let misfit = self.fields.residual.pieces[i].misfit[0];
        let stiffened = self.stiffened(stiffness);
        bounds.shear_force = bounds.shear_force.least((all + self.slid(i)).over(stiffened));
        let slope = bounds.rotation + (bounds.shear_force + misfit).over(stiffness.low());
        bounds.slope = bounds.slope.least(slope);
    }

    /// |P||η|/S.
    fn slid(&self, i: usize) -> Size {
        let stiffness = self.fields.frame.spans[i].stiffness.as_ref();
        let misfit = self.fields.residual.pieces[i].misfit[0];
        stiffness.map_or(Size::ZERO, |s| self.axial_size() * misfit.over(s.low()))
    }

    /// A lower bound of 1 + P/S.
    pub(crate) fn stiffened(&self, stiffness: &Coefficient<S>) -> f64 {
        let axial = self.fields.frame.axial_force().unwrap_or_else(S::zero);
        let worst = if axial.low() > 0.0 { stiffness.high() } else { stiffness.low() };
        (S::one() + axial.div(S::of(worst))).low()
    }

    /// |P|.
    pub(crate) fn axial_size(&self) -> Size {
        Size::of(self.fields.frame.axial_force().map_or(0.0, S::size))
    }

    /// |δ′| on a piece.
    pub(crate) fn balancing_shear(&self, i: usize) -> Size {
        let [a, b] = self.balanced.pieces[i].shears.map(|shear| Size::of(shear.size()));
        let long = self.fields.frame.spans[i].length();
        a.worst(b) + long * self.fields.residual.pieces[i].rest + self.balanced.pieces[i].added[1]
    }

    /// ε_T in windows that contain a piece and lie within a range of pieces.
    fn mean(
        &self,
        window: Range<usize>,
        bounds: &[PieceBounds],
        loads: &[LoadError],
        nodes: &[[Size; 2]],
    ) -> Size {
        let [forces, couples] = inside(&window, loads, nodes);
        self.steady(window, 1.0, bounds, loads, couples) + forces
    }

    /// The bound of V minus |δ′| + |β| from the error of the curvature, under an axial force, in windows
    /// without hinges on a beam without shear deformation.
    fn directly(
        &self,
        window: Range<usize>,
        bounds: &[PieceBounds],
        loads: &[LoadError],
        nodes: &[[Size; 2]],
    ) -> Size {
        let (frame, closed) = (self.fields.frame, &self.fields.deflection.pieces);
        let axial = self.axial_size();
        let hinged = (window.start + 1..window.end).any(|node| frame.nodes[node].is_hinged());
        let shears = window.clone().any(|i| frame.spans[i].stiffness.is_some());
        if axial == Size::ZERO || hinged || shears {
            return Size::INFINITE;
        }
        let [mut moment, mut turned, mut drawn, mut load] = [Size::ZERO; 4];
        for i in window.clone() {
            let bent = bounds[i].moment.over(frame.spans[i].bending.low()) + closed[i].bounds[2];
            moment = moment.worst(bounds[i].balanced_moment);
            turned = turned.worst(closed[i].bounds[1]);
            drawn = drawn.worst(self.balanced.pieces[i].drawn);
            load = load.worst(loads[i].spread + axial * bent);
        }
        let [forces, couples] = inside(&window, loads, nodes);
        let change = 2.0 * moment + couples;
        let available = (frame.nodes[window.end].x - frame.nodes[window.start].x).low();
        let least = least_of_halves(available, |h| change.over(h) + 0.5 * (Size::of(h) * load));
        least + 2.0 * (axial * turned) + drawn + forces
    }

    /// The part of ε_T without edges and concentrated forces, in windows within a part of a range of pieces.
    fn steady(
        &self,
        window: Range<usize>,
        part: f64,
        bounds: &[PieceBounds],
        loads: &[LoadError],
        couples: Size,
    ) -> Size {
        let frame = self.fields.frame;
        let tension = self.axial_size();
        let [mut moment, mut moved, mut turned] = [Size::ZERO; 3];
        let [mut spread, mut drawn] = [Size::ZERO; 2];
        for i in window.clone() {
            moment = moment.worst(bounds[i].balanced_moment);
            moved = moved.worst(bounds[i].deflection);
            turned = turned.worst(self.fields.deflection.pieces[i].bounds[1]);
            spread = spread.worst(loads[i].spread);
            drawn = drawn.worst(self.balanced.pieces[i].drawn);
        }
        let swing = if tension == Size::ZERO { tension } else { tension * moved };
        let change = 2.0 * moment + 2.0 * swing + couples;
        let available = part * (frame.nodes[window.end].x - frame.nodes[window.start].x).low();
        let least = least_of_halves(available, |h| change.over(h) + 0.5 * (Size::of(h) * spread));
        least + tension * turned + drawn
    }

    /// The errors of the pressure on all pieces.
    fn load_errors(&self, shown: &Shown, bounds: &[PieceBounds]) -> Vec<LoadError> {
        let spans = &self.fields.frame.spans;
        let on_piece = |i: usize| {
            let (span, pressure) = (&spans[i], &self.fields.pressures[i]);
            let factor = self.balanced.factor(i);
            let given_back = factor * pressure.field.size(span.tau);
            let tension = (Size::of(1.0) + factor) * pressure.depth;
            let spread = match span.touches || !span.layered {
                true => bounds[i].pressure + given_back + tension,
                false => Size::ZERO,
            };
            LoadError { spread, edges: Size::ZERO }
        };
        let mut errors: Vec<LoadError> = (0..spans.len()).map(on_piece).collect();
        // The exact beam may be in contact on θ of an open piece, and open on θ′ of a touching one.
        for edge in &shown.edges {
            // θ > 0 only at an end of an open piece, θ′ > 0 only at an end of a touching one.
            let [outer, inner] = match edge.side {
                0 => [edge.node.wrapping_sub(1), edge.node],
                _ => [edge.node, edge.node.wrapping_sub(1)],
            };
            if edge.outside > Size::ZERO {
                let pressure = self.open_pressure_beside(outer, 1 - edge.side, edge.outside);
                errors[outer].edges += edge.outside * (pressure + bounds[outer].pressure);
            }
            if edge.inside > Size::ZERO {
                let field = &self.fields.pressures[inner].field;
                let pressure = size_beside(&spans[inner], field, edge.side, edge.inside);
                let kept = Size::of(1.0) + self.balanced.factor(inner);
                errors[inner].edges += edge.inside * (kept * pressure);
            }
        }
        errors
    }

    /// A bound of |ku − q − (μψ′)′| on an open piece of a layer: the pressure if the exact beam is in contact
    /// there.
    pub(crate) fn open_pressure(&self, i: usize) -> Size {
        let span = &self.fields.frame.spans[i];
        if let Some(along) = &self.fields.surface.pieces[i].along {
            return span.pressure_under(along).size(span.tau);
        }
        let Some(ends) = self.fields.surface.pieces[i].open else { return Size::INFINITE };
        let ends = span.above_free_ends(ends);
        let settled = Size::of(ends[0].size()).worst(Size::of(ends[1].size()));
        let bent = span.derivative(&span.derivative(&span.deflection)).size(span.tau);
        Size::of(span.spring.high()) * settled + Size::of(span.shear.high()) * bent
    }

    /// As `open_pressure`, within a distance of one end of the piece. v = u − q/k changes by at most the
    /// distance times its largest slope, which occurs at an end.
    fn open_pressure_beside(&self, i: usize, side: usize, distance: Size) -> Size {
        let (span, surface) = (&self.fields.frame.spans[i], &self.fields.surface.pieces[i]);
        if let Some(along) = &surface.along {
            return size_beside(span, &span.pressure_under(along), side, distance);
        }
        let Some(ends) = surface.open else { return Size::INFINITE };
        let above = span.above_free_ends(ends)[side];
        let free = span
            .free_field()
            .map_or(S::zero(), |free| span.shear.least() * free.coefficient(1) * span.per_length);
        let [left, right] = surface.flux.map(|flux| Size::of((flux - free).size()));
        let slope = left.worst(right).over(span.shear.low());
        let bent = span.derivative(&span.derivative(&span.deflection));
        let at_end = span.spring.times(Polynomial::from_coefficients([above]));
        let at_end = at_end - &span.shear.times(bent);
        let whole = size_beside(span, &at_end, side, distance)
            + Size::of(span.spring.high()) * slope * distance;
        whole.least(self.open_pressure(i))
    }

    /// The error of the forces at a node, and the error of its rotational spring.
    fn node_error(&self, node: usize, shown: &Shown) -> [Size; 2] {
        let (frame, surface) = (self.fields.frame, &self.fields.surface);
        let here = &frame.nodes[node];
        let elastic = |spring: S| self.test_factor() * Size::of(spring.high()).root();
        let mut force = here.spring.map_or(Size::ZERO, |[spring, _]| elastic(spring));
        if surface.touches[node] {
            let (jump, factor) = (&surface.nodes[node].jump, self.balanced.factors[node].size());
            let size = Size::of(jump.size());
            // At a smooth node the exact solution has no concentrated force.
            let missed = if frame.smooth(node) { size } else { shown.tolerances[node] };
            force += missed + Size::of(factor) * size;
        }
        [force, here.turning.map_or(Size::ZERO, elastic)]
    }
}

mod tests;
