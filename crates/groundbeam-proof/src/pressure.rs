//! The contact pressure p = k(w − g₀) − (μ(w − g₀)′)′ of the claimed deflection, and the tensile part of the pressure.

use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
use crate::polynomial::{Budget, Polynomial, below};
use crate::scalar::Scalar;
use crate::size::Size;

/// The pressure on one piece; zero on a piece out of contact.
#[derive(Debug)]
pub(crate) struct Pressure<S> {
    pub field: Polynomial<S>,
    /// A bound of |w − g₀|.
    pub obstacle: Size,
    /// ∫p, ∫tp and ∫t²p.
    pub masses: [S; 3],
    /// Bound η of the tensile pressure: p ≥ −η.
    pub depth: Size,
    /// Bound ω of the length on which p < 0. The tensile pressure is at most η = `depth`, so its resultant is at most
    /// ηω.
    pub width: Size,
}

impl<S: Scalar> Pressure<S> {
    fn none() -> Self {
        let (field, masses) = (Polynomial::zero(), [S::zero(); 3]);
        Pressure { field, obstacle: Size::ZERO, masses, depth: Size::ZERO, width: Size::ZERO }
    }

    fn of(span: &Span<S>, negligible: Size, budget: &mut Budget) -> Self {
        let obstacle = span.obstacle();
        let field = span.pressure_under(&obstacle);
        let masses = span.integrals(&field);
        let negligible = Size::of(span.spring.size()) * negligible;
        let tensile = below(&field.coarse(), Size::ZERO, negligible, span.interval(), budget);
        let width = (tensile.width * Size::of(span.half.high())).least(span.length());
        Pressure { field, obstacle: obstacle.size(span.tau), masses, depth: tensile.depth, width }
    }

    /// Upper bound of the resultant of the tensile pressure.
    pub fn tensile_force(&self) -> Size {
        self.depth * self.width
    }

    /// Upper bound of the resultant of the compressive pressure max(p, 0).
    pub fn pressing(&self) -> Size {
        Size::of(self.masses[0].size()) + self.tensile_force()
    }
}

/// The pressures of all pieces.
pub(crate) fn pressures<S: Scalar>(frame: &Frame<S>, budget: &mut Budget) -> Vec<Pressure<S>> {
    let negligible = frame.negligible();
    let of = |span: &Span<S>| match span.touches {
        true => Pressure::of(span, negligible, budget),
        false => Pressure::none(),
    };
    frame.spans.iter().map(of).collect()
}

/// Upper bound of ∫(k c² + μ c′²) over the pieces in contact, for the correction c of the deflection. It is the sum of
/// h(k max c² + μ max c′²), where h is the length of a piece.
pub(crate) fn carried<S: Scalar>(frame: &Frame<S>, deflection: &Deflection<S>) -> Size {
    let pieces = frame.spans.iter().zip(&deflection.pieces).filter(|(span, _)| span.touches);
    pieces
        .map(|(span, c)| {
            let springs = Size::of(span.spring.high()) * c.bounds[0].square();
            let layer = Size::of(span.shear.size()) * c.bounds[1].square();
            span.length() * (springs + layer)
        })
        .sum()
}

/// Upper bound of the energy norm of the ground's displacement under the tensile pressure: the sum of η(ω/k)^½ over the
/// pieces, with η = `depth` and ω = `width`.
pub(crate) fn tension_norm<S: Scalar>(frame: &Frame<S>, pressures: &[Pressure<S>]) -> Size {
    let pieces = frame.spans.iter().zip(pressures);
    pieces.map(|(span, p)| p.depth * p.width.over(span.spring.low()).root()).sum()
}
