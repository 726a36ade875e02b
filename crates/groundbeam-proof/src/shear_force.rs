//! Bounds of the error of the shear force, from the error of the moment over a window and the errors of the loads in it.
//!
//! The mean error of the transverse force over a window follows from the errors of moment and deflection at its ends.
//! The error at a position differs from this mean by the errors of the forces inside the window. See (15) and (15a) in
//! `docs/proof.md`.

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

/// Returns the sum of the errors of contact and spring forces inside a window, and that of the moments of rotational
/// springs.
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
    // `8.0 * f64::EPSILON` covers the rounding errors of `end` and `middle`.
    let reach = 0.5 * part + 8.0 * f64::EPSILON;
    p.shifted(middle).size(reach).least(p.size(span.tau))
}

/// Numbers of pieces by which the window around a piece extends to each side, in the order in which they are tried.
const REACHES: [usize; 5] = [0, 1, 3, 7, 15];

/// Bounds of the error of the contact pressure on one piece.
#[derive(Clone, Copy)]
struct LoadError {
    /// Bound of the error of the pressure where the exact and the claimed solution are both in contact or both out of
    /// contact.
    spread: Size,
    /// Bound of the error of the contact force on the lengths where the beam is in contact in only one of the two
    /// solutions, the exact or the claimed one.
    edges: Size,
}

impl<S: Scalar> Pointwise<'_, S> {
    /// Tightens the error bounds of the shear force on all pieces and, with shear deformation, those of the slope.
    /// `shown` must contain bounds of the contact edges of all shear layers.
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

    /// Lowers the error bounds of the shear force and, with shear deformation, of the slope. `all` is an error bound of
    /// T − Pφ, with the transverse force T, the axial tension P and the rotation φ. See *Shear force* in section 6 of
    /// `docs/proof.md`.
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

    /// Upper bound of |P||η|/S on a piece, with the axial force P, the misfit η = S(w′ − φ) − V of the claimed shear
    /// force V, and the shear stiffness S.
    fn slid(&self, i: usize) -> Size {
        let stiffness = self.fields.frame.spans[i].stiffness.as_ref();
        let misfit = self.fields.residual.pieces[i].misfit[0];
        stiffness.map_or(Size::ZERO, |s| self.axial_size() * misfit.over(s.low()))
    }

    /// A lower bound of 1 + P/S, with the axial tension P and the shear stiffness S of the beam.
    pub(crate) fn stiffened(&self, stiffness: &Coefficient<S>) -> f64 {
        let axial = self.fields.frame.axial_force().unwrap_or_else(S::zero);
        let worst = if axial.low() > 0.0 { stiffness.high() } else { stiffness.low() };
        (S::one() + axial.div(S::of(worst))).low()
    }

    /// Upper bound of the absolute value of the axial force.
    pub(crate) fn axial_size(&self) -> Size {
        Size::of(self.fields.frame.axial_force().map_or(0.0, S::size))
    }

    /// Upper bound of |δ′| on a piece, where δ is the moment that balances the residual of equilibrium.
    pub(crate) fn balancing_shear(&self, i: usize) -> Size {
        let [a, b] = self.balanced.pieces[i].shears.map(|shear| Size::of(shear.size()));
        let long = self.fields.frame.spans[i].length();
        a.worst(b) + long * self.fields.residual.pieces[i].rest + self.balanced.pieces[i].added[1]
    }

    /// Error bound of the transverse force on a piece by formula (15) of docs/proof.md. `window` is a range of pieces
    /// around the piece.
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

    /// Error bound of the shear force by (15a) of `docs/proof.md`, without |δ′| and |β|. It is infinite without axial
    /// force, with a hinge inside the window, or with shear deformation.
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

    /// The bound (15) of `docs/proof.md` without the terms of contact edges and concentrated forces. It is the minimum
    /// over lengths h up to `part` times the length of `window`.
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

    /// Computes the errors of the loads on all pieces from the errors of the pressure.
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
        // In the exact solution, the beam may be in contact on the length `outside` beyond an edge of the claimed
        // contact, or out of contact on the length `inside` before this edge.
        for edge in &shown.edges {
            // `outer` is the piece at the edge outside the claimed contact, and `inner` the piece inside. At an end of
            // the beam, the length on the missing piece is zero.
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

    /// Upper bound of |ku − q − (μψ′)′| on an open piece of a shear layer, with the load q on the ground and ψ = w −
    /// g₀. The exact pressure on the piece is at most this bound plus the error bound of the pressure.
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

    /// Returns the bound of `open_pressure` for the part of a piece within the given `distance` of one of its ends.
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
        // The slope of the settlement minus the free-field settlement is largest at an end of the piece.
        let slope = left.worst(right).over(span.shear.low());
        let bent = span.derivative(&span.derivative(&span.deflection));
        let at_end = span.spring.times(Polynomial::from_coefficients([above]));
        let at_end = at_end - &span.shear.times(bent);
        let whole = size_beside(span, &at_end, side, distance)
            + Size::of(span.spring.high()) * slope * distance;
        whole.least(self.open_pressure(i))
    }

    /// Returns the error of the forces at a node, and the error of the moment of its rotational spring.
    fn node_error(&self, node: usize, shown: &Shown) -> [Size; 2] {
        let (frame, surface) = (self.fields.frame, &self.fields.surface);
        let here = &frame.nodes[node];
        let elastic = |spring: S| self.test_factor() * Size::of(spring.high()).root();
        let mut force = here.spring.map_or(Size::ZERO, |[spring, _]| elastic(spring));
        if surface.touches[node] {
            let (jump, factor) = (&surface.nodes[node].jump, self.balanced.factors[node].size());
            let size = Size::of(jump.size());
            // The exact solution has no concentrated contact force at a node for which `Frame::smooth` is true.
            let missed = if frame.smooth(node) { size } else { shown.tolerances[node] };
            force += missed + Size::of(factor) * size;
        }
        [force, here.turning.map_or(Size::ZERO, elastic)]
    }
}

mod tests;
