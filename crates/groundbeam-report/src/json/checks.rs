//! Writes verdicts on checks in the result document.

use crate::checked::{Governing, Row, Verdict, verdicts};
use crate::context::Context;
use groundbeam::{design::Beside, solution::EndForces};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Checked {
    name: &'static str,
    /// The limit state; `null` for loads as given, and for combinations without a limit state.
    limit_state: Option<&'static str>,
    /// Name of the governing combination, if there are several combinations.
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<String>,
    value: Option<f64>,
    limit: Option<f64>,
    utilisation: Option<f64>,
    x: Option<f64>,
    /// Point contact forces under the ends of the beam. The checked peak pressure does not include them.
    #[serde(skip_serializing_if = "Option::is_none")]
    end_forces: Option<EndForces>,
    #[serde(skip_serializing_if = "Option::is_none")]
    effective_area: Option<Area>,
    clause: Option<&'static str>,
    /// Whether the check passes; `null` if it is not judged.
    passes: Option<bool>,
    /// Reason why the check has no value.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

#[derive(Serialize)]
struct Area {
    width: f64,
    length: f64,
}

/// Returns the verdicts on the design checks; empty if no checks are requested.
pub(super) fn of(rows: &[Row], context: &Context) -> Vec<Checked> {
    verdicts(context.limits, rows).iter().map(|verdict| Checked::of(verdict, rows)).collect()
}

impl Checked {
    fn of(verdict: &Verdict, rows: &[Row]) -> Self {
        let (judged, reason) = match verdict.of {
            Governing::Judged(_, judged) => (Some(judged.check), None),
            Governing::Falls(_) => (None, Some("no equilibrium".to_owned())),
            Governing::Unsolved(_) => (None, Some("not solved".to_owned())),
            Governing::NoResultant(_) => (None, Some("no resultant".to_owned())),
            Governing::NoCombination(states) => {
                (None, Some(format!("no combination has the limit state {}", states.names())))
            }
        };
        let name = verdict.by().map(|by| rows[by].name.to_string()).filter(|name| !name.is_empty());
        let beside = judged.map_or(Beside::Nothing, |check| check.beside);
        Checked {
            name: verdict.what.name(),
            limit_state: verdict.state.map(|state| state.name()),
            combination: name,
            value: judged.map(|check| check.found),
            limit: judged.map(|check| check.limit),
            utilisation: judged.map(|check| check.utilisation()),
            x: judged.and_then(|check| check.at),
            end_forces: match beside {
                Beside::EndForces(ends) => Some(ends),
                _ => None,
            },
            effective_area: match beside {
                Beside::EffectiveArea { width, length } => Some(Area { width, length }),
                _ => None,
            },
            clause: verdict.clause(rows),
            passes: verdict.passes(),
            reason,
        }
    }
}
