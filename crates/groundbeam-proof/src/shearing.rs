//! The energy of the error of the shear force on a beam with shear deformation, a part of the energy bound E.
//!
//! The energy is ½∫(η − δ′)²/S ≤ ½(‖η‖ + ‖δ′‖)² in the norm ‖x‖² = ∫x²/S, with the shear stiffness S. η = S(w′ − φ) − V
//! is the misfit of the claimed shear force V. δ is the moment that balances the residual of equilibrium.

use crate::balance::Balanced;
use crate::frame::Frame;
use crate::residual::Residual;
use crate::scalar::Scalar;
use crate::size::Size;

/// Upper bound of (‖η‖ + ‖δ′‖)² in the norm ‖x‖² = ∫x²/S. η is the misfit of the claimed shear force, and δ′ the shear
/// force that balances the residual of equilibrium.
pub(crate) fn shearing_energy<S: Scalar>(
    frame: &Frame<S>,
    residual: &Residual<S>,
    balanced: &Balanced<S>,
) -> Size {
    let (mut misfit, mut balancing) = (Size::ZERO, Size::ZERO);
    for (i, span) in frame.spans.iter().enumerate() {
        let Some(stiffness) = &span.stiffness else { continue };
        let piece = &residual.pieces[i];
        misfit += (span.length() * piece.misfit[0].square()).over(stiffness.low());
        let norm =
            shear_norm(span.h, balanced.pieces[i].shears, piece.rest, balanced.pieces[i].added[1]);
        balancing += norm.square().over(stiffness.low());
    }
    (misfit.root() + balancing.root()).square()
}

/// Bound (9a) of `docs/proof.md` for (∫δ′²)^½ on a piece of length h. The balancing shear force δ′ has the end values a
/// and b. `rest` bounds the variation of δ″, and `added` the part of δ′ from the distributed forces.
fn shear_norm<S: Scalar>(h: S, [a, b]: [S; 2], rest: Size, added: Size) -> Size {
    let chord = h.div(S::of(3.0)) * (a * a + a * b + b * b);
    let long = Size::of(h.high());
    Size::of(chord.size()).root() + long.root() * (0.5 * (long * rest) + added)
}

#[cfg(test)]
mod tests {
    use super::shear_norm;
    use crate::ball::Ball;
    use crate::random::numbers;
    use crate::scalar::Scalar;
    use crate::size::Size;

    /// Computes the shear force δ′ at the coordinate t on a piece of length 2 `half`, from its end values a and b and
    /// the varying part c₁t + c₂t² + c₃t³ of the residual.
    fn shear(c: &[f64; 3], half: f64, [a, b]: [f64; 2], t: f64) -> f64 {
        let once = |t: f64| {
            let terms = c.iter().enumerate();
            terms.map(|(j, c)| c * t.powi(j as i32 + 2) / (j + 2) as f64).sum::<f64>()
        };
        let chord = |left: f64, right: f64| 0.5 * (left + right) + 0.5 * (right - left) * t;
        chord(a, b) - half * (once(t) - chord(once(-1.0), once(1.0)))
    }

    #[test]
    fn the_bound_of_the_shear_force_is_sharp_for_a_constant_residual() {
        let mut random = numbers();
        for case in 0..500 {
            let half = 10.0_f64.powf(2.0 * random());
            let mut c = [random(), random(), random()];
            if case % 2 == 0 {
                c = [0.0; 3];
            }
            let ends = [random(), random()].map(|x| x * half);
            let square =
                |i: i32| shear(&c, half, ends, -1.0 + (f64::from(i) + 0.5) / 1000.0).powi(2);
            let exact = ((0..2000).map(square).sum::<f64>() * half / 1000.0).sqrt();
            let rest = Size::of(c.iter().map(|c| c.abs()).sum());
            let norm = shear_norm(Ball::of(2.0 * half), ends.map(Ball::of), rest, Size::ZERO);
            assert!(exact <= norm.value() * (1.0 + 1e-6), "{exact} {norm:?}");
            if case % 2 == 0 {
                assert!(norm.value() <= exact * (1.0 + 1e-5), "{exact} {norm:?} is not sharp");
            }
        }
    }
}
