//! Bounds the energies of the moments, transverse forces and pressures that are added for exact equilibrium.

use crate::balance::{Balance, Balanced, BalancedPiece};
use crate::deflection::Deflection;
use crate::frame::Span;
use crate::scalar::Scalar;
use crate::size::Size;

impl<S: Scalar> Balance<'_, S> {
    /// Returns a bound of ‖δ‖² = Σ∫δ²/EI, twice the complementary energy of the moment δ that balances the
    /// residual loads.
    pub fn bending(&self, balanced: &Balanced<S>) -> Size {
        let of = |i: usize| {
            let (span, piece) = (&self.frame.spans[i], &self.residual.pieces[i]);
            let load = (piece.constant, piece.rest);
            let norm =
                moment_norm(span.h, balanced.pieces[i].moments, load, balanced.pieces[i].added[0]);
            norm.square().over(span.bending.low())
        };
        (0..self.frame.spans.len()).map(of).sum()
    }

    /// Returns a bound of Σβ²h/P over the pieces of length h, twice the energy of the transverse forces β that the
    /// axial tension P carries.
    pub fn drawn(&self, balanced: &Balanced<S>) -> Size {
        let Some(tension) = self.frame.tension else { return Size::ZERO };
        let pieces = self.frame.spans.iter().zip(&balanced.pieces);
        let of = |(span, piece): (&Span<S>, &BalancedPiece<S>)| {
            (span.length() * piece.drawn.square()).over(tension.low())
        };
        pieces.map(of).sum()
    }

    /// Returns a bound of ‖Gδp‖_b², twice the energy of the ground under the pressure change δp, by (8) of
    /// docs/proof.md. `missed` bounds the norm of the residual of the ground equation.
    pub fn ground(&self, balanced: &Balanced<S>, deflection: &Deflection<S>, missed: Size) -> Size {
        let mut sum = Size::ZERO;
        for (i, span) in self.frame.spans.iter().enumerate().filter(|(_, span)| span.touches) {
            let pressure = &self.pressures[i];
            let per_load = if span.layered {
                let settled = pressure.obstacle + deflection.pieces[i].bounds[0];
                settled + self.surface.pieces[i].flexibility * missed
            } else {
                pressure.field.size(span.tau).over(span.spring.low())
            };
            sum += balanced.factor(i).square() * pressure.pressing() * per_load;
        }
        sum + self.ground_at_nodes(balanced, missed)
    }

    fn ground_at_nodes(&self, balanced: &Balanced<S>, missed: Size) -> Size {
        let of = |node: usize| {
            // The concentrated force is zero at nodes out of contact.
            let force = Size::of(self.surface.nodes[node].force.size());
            if force.value() == 0.0 {
                return Size::ZERO;
            }
            let factor = Size::of(balanced.factors[node].size());
            let settled = Size::of(self.surface.nodes[node].settlement.size());
            let missed = self.surface.flexibility_at(node) * missed;
            factor.square() * force * (settled + missed)
        };
        (0..self.frame.nodes.len()).map(of).sum()
    }
}

/// Returns the bound (9) of docs/proof.md for (∫δ²)^½ on a piece of length h. The moment δ has the end values a and b
/// and the load r ± `rest`, plus a further moment of at most `added`.
fn moment_norm<S: Scalar>(h: S, [a, b]: [S; 2], (r, rest): (S, Size), added: Size) -> Size {
    let cube = h * h * h;
    let chord = h.div(S::of(3.0)) * (a * a + a * b + b * b);
    let mixed = r * cube * (a + b).div(S::of(12.0));
    let parabola = (r * r * cube * h * h).div(S::of(120.0));
    let long = Size::of(h.high());
    let fifth = (long.square().square() * long).over(120.0).root();
    Size::of((chord + mixed + parabola).size()).root() + fifth * rest + long.root() * added
}

#[cfg(test)]
mod tests {
    use super::moment_norm;
    use crate::ball::Ball;
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;

    /// Returns the moment at −1 ≤ t ≤ 1 under the load Σcⱼtʲ on the length 2 `half`, with the end moments a and b.
    fn moment(c: &[f64; 4], half: f64, [a, b]: [f64; 2], t: f64) -> f64 {
        let twice = |t: f64| {
            let terms = c.iter().enumerate();
            terms.map(|(j, c)| c * t.powi(j as i32 + 2) / ((j + 1) * (j + 2)) as f64).sum::<f64>()
        };
        let (left, right) = (twice(-1.0), twice(1.0));
        let chord = |left: f64, right: f64| 0.5 * (left + right) + 0.5 * (right - left) * t;
        chord(a, b) + half * half * (chord(left, right) - twice(t))
    }

    #[test]
    fn the_bound_of_the_moment_is_sharp_for_a_constant_residual() {
        let mut random = numbers();
        for case in 0..500 {
            let half = 10.0_f64.powf(2.0 * random());
            let mut c = [random(), random(), random(), random()];
            if case % 2 == 0 {
                c = [c[0], 0.0, 0.0, 0.0];
            }
            let ends = [random(), random()].map(|x| x * half * half);
            let steps = 2000;
            let square =
                |i: i32| moment(&c, half, ends, -1.0 + (f64::from(i) + 0.5) / 1000.0).powi(2);
            let exact = ((0..steps).map(square).sum::<f64>() * half / 1000.0).sqrt();
            let rest = Size::of(c[1].abs() + c[2].abs() + c[3].abs());
            let load = (Ball::of(c[0]), rest);
            let norm = moment_norm(Ball::of(2.0 * half), ends.map(Ball::of), load, Size::ZERO);
            assert!(exact <= norm.value() * (1.0 + 1e-6), "{exact} {norm:?}");
            if case % 2 == 0 {
                assert!(norm.value() <= exact * (1.0 + 1e-5), "{exact} {norm:?} is not sharp");
            }
        }
    }
}
