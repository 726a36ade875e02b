//! The residual of equilibrium (3.12) of the claimed deflection and pressures, on pieces and at nodes.
//!
//! The residuals r on pieces and r_i, q_i at nodes are those of (5) in `docs/proof.md`. The moment M + δ is in
//! equilibrium with the loads if δ″ = −r on pieces, and if δ′ jumps by −r_i and δ by q_i at nodes.

use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
use crate::ground::Surface;
use crate::model::Acts;
use crate::polynomial::Polynomial;
use crate::pressure::Pressure;
use crate::scalar::{Scalar, positive_part};
use crate::size::Size;

/// The residual of equilibrium on one piece.
#[derive(Debug)]
pub(crate) struct PieceResidual<S> {
    /// Integral of the residual r over the piece.
    pub force: S,
    /// ∫r(x)(X_R − x), the moment of the residual about the right end X_R of the piece.
    pub moment: S,
    /// Constant coefficient of the polynomial r(x), the residual on the piece. `rest` is a bound of all other terms
    /// of r.
    pub constant: S,
    pub rest: Size,
    /// Bending moment M at both ends of the piece.
    pub bending: [S; 2],
    /// Transverse force T at both ends of the piece.
    pub shear: [S; 2],
    /// Bounds of the misfit η = S(w′ − φ) − V of the shear force V, and of η′; zero without shear deformation.
    pub misfit: [Size; 2],
}

/// The residual of equilibrium.
#[derive(Debug)]
pub(crate) struct Residual<S> {
    pub pieces: Vec<PieceResidual<S>>,
    /// r_i and q_i at the nodes.
    pub nodes: Vec<[S; 2]>,
    /// Force of the one-way support at each node, positive in the direction in which the support can act; zero at a
    /// node without a one-way support.
    pub pushing: Vec<S>,
}

pub(crate) fn residual<S: Scalar>(
    frame: &Frame<S>,
    deflection: &Deflection<S>,
    surface: &Surface<S>,
    pressures: &[Pressure<S>],
) -> Residual<S> {
    let pieces: Vec<_> = (0..frame.spans.len()).map(|i| on_piece(frame, pressures, i)).collect();
    let pushing: Vec<S> = (0..frame.nodes.len()).map(|i| pushes(frame, deflection, i)).collect();
    let at = |i: usize| at_node(frame, deflection, surface, &pieces, pushing[i], i);
    let nodes = (0..frame.nodes.len()).map(at).collect();
    Residual { pieces, nodes, pushing }
}

/// Force of a one-way support, positive in the direction in which the support can act. A rigid support has its claimed
/// force. A spring has the force at the admissible deflection, or zero if this force is negative.
fn pushes<S: Scalar>(frame: &Frame<S>, deflection: &Deflection<S>, i: usize) -> S {
    let node = &frame.nodes[i];
    match (node.acts, node.spring) {
        (Acts::Both, _) => S::zero(),
        (acts, Some([spring, settled])) => {
            positive_part(acts.towards(spring * deflection.values[i] - settled))
        }
        (acts, None) => acts.towards(node.reaction[0]),
    }
}

fn on_piece<S: Scalar>(frame: &Frame<S>, pressures: &[Pressure<S>], i: usize) -> PieceResidual<S> {
    let span = &frame.spans[i];
    let slope = span.derivative(&span.deflection);
    let moment = span.bending_moment(span.rotation.as_deref().unwrap_or(&slope));
    let mut shear = span.shear_force(&moment);
    let misfit = misfit(span, &slope, &shear);
    if let Some(force) = frame.axial_force() {
        shear = shear + &slope.times(force);
    }
    let r = span.derivative(&shear) + &span.force - &pressures[i].field;
    // X_R − x = half (t_R − t).
    let [force, turned] = span.integrals(&r);
    PieceResidual {
        force,
        moment: (span.t[1] * force - turned) * span.half,
        constant: r.coefficient(0),
        rest: r.tail(span.tau),
        bending: span.t.map(|t| moment.value(t)),
        shear: span.t.map(|t| shear.value(t)),
        misfit,
    }
}

/// Bounds of the misfit η = S(w′ − φ) − V of the shear force V, and of η′; zero without shear deformation.
fn misfit<S: Scalar>(
    span: &Span<S>,
    slope: &Polynomial<S>,
    shear_force: &Polynomial<S>,
) -> [Size; 2] {
    let (Some(stiffness), Some(rotation)) = (&span.stiffness, &span.rotation) else {
        return [Size::ZERO; 2];
    };
    let misfit = stiffness.times(*slope - rotation) - shear_force;
    [misfit.size(span.tau), span.derivative(&misfit).size(span.tau)]
}

fn at_node<S: Scalar>(
    frame: &Frame<S>,
    deflection: &Deflection<S>,
    surface: &Surface<S>,
    pieces: &[PieceResidual<S>],
    pushed: S,
    i: usize,
) -> [S; 2] {
    let node = &frame.nodes[i];
    let end = |side: usize, of: &dyn Fn(&PieceResidual<S>) -> [S; 2]| {
        let piece = if side == 0 { i.checked_sub(1) } else { Some(i) };
        piece.and_then(|i| pieces.get(i)).map_or_else(S::zero, |piece| of(piece)[1 - side])
    };
    let jump = |of: &dyn Fn(&PieceResidual<S>) -> [S; 2]| end(1, of) - end(0, of);
    let mut force = node.force - surface.nodes[i].force - node.reaction[0] + jump(&|p| p.shear);
    let mut moment = node.moment - node.reaction[1] - jump(&|p| p.bending);
    let [w, slope] = deflection.at_support(i);
    if let Some([spring, settled]) = node.spring {
        force = force
            - match node.acts {
                Acts::Both => spring * w - settled,
                acts => acts.towards(pushed),
            };
    }
    if let Some(turning) = node.turning {
        moment = moment - turning * slope;
    }
    [force, moment]
}
