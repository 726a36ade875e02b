//! The pressure p = k(w − g₀) − (μ(w − g₀)′)′ where beam and ground are in contact, from the claimed deflection, and its
//! tensile part.

use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
use crate::polynomial::{Budget, Polynomial, below};
use crate::scalar::Scalar;
use crate::size::Size;

/// The pressure on one piece; zero on an open piece.
#[derive(Debug)]
pub(crate) struct Pressure<S> {
    pub field: Polynomial<S>,
    /// A bound of |w − g₀|.
    pub obstacle: Size,
    /// ∫p, ∫tp and ∫t²p.
    pub masses: [S; 3],
    /// p ≥ −η.
    pub depth: Size,
    /// ω: p < 0 on a length of at most ω. With p ≥ −η, the tensile part max(−p, 0) has a resultant of at most ηω.
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

    /// The bound ηω of the resultant of the tensile part.
    pub fn tensile_force(&self) -> Size {
        self.depth * self.width
    }

    /// The resultant of max(p, 0).
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

/// ‖c‖_b² on the pieces that touch: Σ h(k c² + μ c′²).
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

/// Σ η(ω/k)^½: a bound of the change of the ground's surface by the tensile parts, in the energy norm.
pub(crate) fn tension_norm<S: Scalar>(frame: &Frame<S>, pressures: &[Pressure<S>]) -> Size {
    let pieces = frame.spans.iter().zip(pressures);
    pieces.map(|(span, p)| p.depth * p.width.over(span.spring.low()).root()).sum()
}
