//! Condenses the rotations of hinges, which are nodes at which the rotation θ of the beam jumps.
//!
//! A hinge is an element of length zero. See *Hinges* in `docs/methods.md`.

use crate::chain::node::{ChainNode, CondensedStiffness, NotDefinite, THETA};
use crate::numeric::real::sum;

/// Back-substitution across a hinge: the rotation on the near side is `constant` minus `gain` times the unknowns on the
/// far side.
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

    /// Converts the unknowns `y` on the far side of a hinge to those on its near side, which the elimination reaches
    /// first.
    pub fn beyond_hinge(turned: Option<Self>, mut y: [f64; 3]) -> [f64; 3] {
        if let Some(HingeRotation { gain, constant }) = turned {
            y[THETA] = constant - sum::<f64, 3>(|i| gain[i] * y[i]);
        }
        y
    }
}
