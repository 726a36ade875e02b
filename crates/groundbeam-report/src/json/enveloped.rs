//! Writes the envelope over all results, the envelopes of the limit states, and the verdicts on checks.

use super::checks::Checked;
use super::{Along, ByName, Lines};
use groundbeam::design::{LimitState, LimitStates};
use serde::Serialize;

/// Envelopes, extremes and verdicts of a document. `G` identifies the governing result at a position. `E`
/// contains the extremes of a field.
#[derive(Serialize)]
#[serde(bound(serialize = "Lines<G>: Serialize, E: Serialize"))]
pub(super) struct Enveloped<G, E> {
    #[serde(skip_serializing_if = "Option::is_none")]
    envelope: Option<Along<Lines<G>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extremes: Option<ByName<E>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    envelopes: Vec<OfState<G, E>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<Checked>,
}

/// The envelope and the extremes over the results of one limit state.
#[derive(Serialize)]
#[serde(bound(serialize = "Lines<G>: Serialize, E: Serialize"))]
struct OfState<G, E> {
    limit_state: &'static str,
    #[serde(flatten)]
    envelope: Along<Lines<G>>,
    extremes: ByName<E>,
}

impl<G, E> Enveloped<G, E> {
    /// Computes the envelopes. `of` returns the envelope and the extremes over the results of one limit state, or of
    /// all results for `None`. Without a solution, `of` returns `None`.
    pub fn new(
        states: LimitStates,
        of: impl Fn(Option<LimitState>) -> Option<(Along<Lines<G>>, ByName<E>)>,
        checks: Vec<Checked>,
    ) -> Self {
        let (envelope, extremes) = of(None).unzip();
        let of_state = |state: LimitState| {
            let (envelope, extremes) = of(Some(state))?;
            Some(OfState { limit_state: state.name(), envelope, extremes })
        };
        Enveloped {
            envelope,
            extremes,
            envelopes: states.iter().filter_map(of_state).collect(),
            checks,
        }
    }
}
