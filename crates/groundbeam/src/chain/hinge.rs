//! Hinges: nodes at which θ jumps.
//!
//! A hinge is an element of length zero, x' = x + (0, δ), with the energy ½ k_φ δ² of its rotation δ. Elimination of θ
//! gives S' = S − S e (eᵀS e + k_φ)⁻¹ eᵀS with e the unit vector of θ. At a hinge without a spring the row and the
//! column of θ vanish.

use crate::chain::node::{ChainNode, CondensedStiffness, NotDefinite, THETA};
use crate::numeric::real::sum;

/// Back-substitution across a hinge: θ_behind = constant − gain·(w, θ_ahead, u), where the sweep goes from behind to
/// ahead.
#[derive(Debug, Clone, Copy)]
pub(super) struct HingeRotation {
    gain: [f64; 3],
    constant: f64,
}

impl HingeRotation {
    /// Condenses the hinge of a node, if there is one. No other load or support may act on θ at the node.
    pub fn condense(
        node: &ChainNode,
        state: &mut CondensedStiffness,
    ) -> Result<Option<Self>, NotDefinite> {
        let Some(spring) = node.hinge else { return Ok(None) };
        let CondensedStiffness { s, r } = *state;
        let held = s[THETA][THETA] + spring;
        // Only the ground and the supports behind a hinge without a spring resist the rotation.
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

    /// (w, θ, u) behind the hinge, if there is one, from those ahead of it.
    pub fn beyond_hinge(turned: Option<Self>, mut y: [f64; 3]) -> [f64; 3] {
        if let Some(HingeRotation { gain, constant }) = turned {
            y[THETA] = constant - sum::<f64, 3>(|i| gain[i] * y[i]);
        }
        y
    }
}
