//! The residual of equilibrium (3.12) of the claimed deflection and pressures: forces along the pieces,
//! forces at the nodes, and jumps of the moment.
//!
//! With M = −EI(φ′ − κ₀), V = M′ − g and T = V + Pw′, φ = w′ where the beam has no shear deformation,
//!
//! ```text
//! r(x) = f − p + T′ on pieces,   r_i = F_i − a_i − R_i + [T]_i,   q_i = M₀_i − R_θi − [M]_i at nodes.
//! ```
//!
//! m = M + δ is in equilibrium if δ″ = −r, [δ′]_i = −r_i, [δ]_i = q_i.

use crate::deflection::Deflection;
use crate::frame::{Frame, Span};
use crate::ground::Surface;
use crate::model::Acts;
use crate::polynomial::Polynomial;
use crate::pressure::Pressure;
use crate::scalar::{Scalar, positive_part};
use crate::size::Size;

/// The residual of one piece.
#[derive(Debug)]
pub(crate) struct PieceResidual<S> {
    /// ∫r.
    pub force: S,
    /// ∫r(x)(X_R − x), the moment about the right end.
    pub moment: S,
    /// The constant coefficient of r, and a bound of the other terms.
    pub constant: S,
    pub rest: Size,
    /// M at both ends.
    pub bending: [S; 2],
    /// T at both ends.
    pub shear: [S; 2],
    /// On a piece with shear deformation, bounds of η = S(w′ − φ) − V and of η′.
    pub misfit: [Size; 2],
}

/// The residual of equilibrium.
#[derive(Debug)]
pub(crate) struct Residual<S> {
    pub pieces: Vec<PieceResidual<S>>,
    /// r_i and q_i at the nodes.
    pub nodes: Vec<[S; 2]>,
    /// The force of the one-way support at a node in its direction, not negative; zero at other nodes.
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

/// The force of a one-way support in its direction: the claimed force of a rigid support, or κ times the
/// positive part of w̄ − δ for a spring.
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

/// Bounds of η = S(w′ − φ) − V and of η′ on a piece with shear deformation.
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
