//! Hinges: nodes at which θ jumps.
//!
//! A hinge is an element of no length, x' = x + (0, δ), whose deformation δ costs ½ k_φ δ². Eliminating θ it
//! gives S' = S − S e (eᵀS e + k_φ)⁻¹ eᵀS with e the unit vector of θ. At a free hinge the row and the column
//! of θ vanish.

use crate::chain::node::{ChainNode, CondensedStiffness, NotDefinite, THETA};
use crate::numeric::real::{Real, sum};

/// Back-substitution across a hinge: θ_behind = constant − gain·(w, θ_ahead, u).
#[derive(Debug, Clone, Copy)]
pub(super) struct HingeRotation<R> {
    gain: [R; 3],
    constant: R,
}

impl<R: Real> HingeRotation<R> {
    /// Adds the hinge of a node, if there is one. No other load or support may act on θ there.
    pub fn condense(
        node: &ChainNode<R>,
        state: &mut CondensedStiffness<R>,
    ) -> Result<Option<Self>, NotDefinite> {
        let Some(spring) = node.hinge else { return Ok(None) };
        let CondensedStiffness { s, r } = *state;
        let held = s[THETA][THETA] + spring;
        // Behind a free hinge only the ground and the supports there resist rotation.
        if held.value().is_nan() || held.value() <= 0.0 {
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

    /// (w, θ, u) on the other side of the hinge, if there is one.
    pub fn beyond_hinge(turned: Option<Self>, mut y: [R; 3]) -> [R; 3] {
        if let Some(HingeRotation { gain, constant }) = turned {
            y[THETA] = constant - sum::<R, 3>(|i| gain[i] * y[i]);
        }
        y
    }
}
