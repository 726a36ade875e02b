//! Condenses the rotations of hinges, which are nodes at which the rotation θ of the beam jumps.
//!
//! A hinge is an element of length zero. The jump δ of θ has the energy ½ k_φ δ², where k_φ is the stiffness of the
//! hinge. Elimination of θ on the side of the hinge that is already condensed changes the condensed stiffness S of
//! the node to S − S e (eᵀS e + k_φ)⁻¹ eᵀS with the unit vector e of θ. At a hinge without a spring the row and the
//! column of θ vanish.

use crate::chain::node::{ChainNode, CondensedStiffness, NotDefinite, THETA};
use crate::numeric::real::sum;

/// Coefficients of the back-substitution across a hinge. The rotation on the near side of the hinge, which is
/// eliminated first, is constant − gain · y. The vector y contains the deflection, the rotation on the far side and
/// the unknown of the ground surface at the hinge.
#[derive(Debug, Clone, Copy)]
pub(super) struct HingeRotation {
    gain: [f64; 3],
    constant: f64,
}

impl HingeRotation {
    /// Condenses the hinge of a node. Returns `None` for a node without a hinge. No moment and no rotational support
    /// may act at a node with a hinge.
    pub fn condense(
        node: &ChainNode,
        state: &mut CondensedStiffness,
    ) -> Result<Option<Self>, NotDefinite> {
        let Some(spring) = node.hinge else { return Ok(None) };
        let CondensedStiffness { s, r } = *state;
        let held = s[THETA][THETA] + spring;
        // `held` is the stiffness against the rotation θ on the condensed side of the hinge. It comes from
        // the spring of the hinge, and from the ground and the supports on this side.
        if held.is_nan() || held <= 0.0 {
            return Err(NotDefinite);
        }
        let share = spring / held;
        for i in 0..3 {
            for j in 0..3 {
                state.s[i][j] = if i == THETA || j == THETA {
                    s[i][j] * share
                } else {
                    s[i][j] - s[i][THETA] * (s[THETA][j] / held)
                };
            }
            state.r[i] =
                if i == THETA { r[i] * share } else { r[i] - s[i][THETA] * (r[THETA] / held) };
        }
        let mut gain = s[THETA].map(|s| s / held);
        gain[THETA] = -share;
        Ok(Some(HingeRotation { gain, constant: r[THETA] / held }))
    }

    /// Converts the unknowns `y` at the far side of a hinge to the unknowns at its near side. The elimination
    /// crosses the hinge from its near to its far side. Without a hinge, returns `y` unchanged.
    pub fn beyond_hinge(turned: Option<Self>, mut y: [f64; 3]) -> [f64; 3] {
        if let Some(HingeRotation { gain, constant }) = turned {
            y[THETA] = constant - sum::<f64, 3>(|i| gain[i] * y[i]);
        }
        y
    }
}
