//! Verdicts on checks in the result document.

use crate::checked::{Governing, Row, Verdict, verdicts};
use crate::context::Context;
use groundbeam::{Beside, EndForces};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Checked {
    name: &'static str,
    /// `null` for loads as they are given, and for combinations that name none.
    limit_state: Option<&'static str>,
    /// The combination that governs, of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<String>,
    value: Option<f64>,
    limit: Option<f64>,
    utilisation: Option<f64>,
    x: Option<f64>,
    /// The concentrated forces under the ends, which a peak pressure leaves out.
    #[serde(skip_serializing_if = "Option::is_none")]
    end_forces: Option<EndForces>,
    #[serde(skip_serializing_if = "Option::is_none")]
    effective_area: Option<Area>,
    clause: Option<&'static str>,
    /// `null` where it is not judged.
    passes: Option<bool>,
    /// Why it has no value.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

#[derive(Serialize)]
struct Area {
    width: f64,
    length: f64,
}

/// Empty where nothing is asked for.
pub(super) fn of(rows: &[Row], context: &Context) -> Vec<Checked> {
    verdicts(context.limits, rows).iter().map(|verdict| Checked::of(verdict, rows)).collect()
}

impl Checked {
    fn of(verdict: &Verdict, rows: &[Row]) -> Self {
        let (judged, by, reason) = match verdict.of {
            Governing::Judged(by, judged) => (Some(judged.check), Some(by), None),
            Governing::Falls(by) => (None, Some(by), Some("no equilibrium".to_owned())),
            Governing::Unsolved(by) => (None, Some(by), Some("not solved".to_owned())),
            Governing::NoCombination(states) => {
                (None, None, Some(format!("no combination of {}", states.names())))
            }
        };
        let name = by.map(|by| rows[by].name.to_string()).filter(|name| !name.is_empty());
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
            clause: verdict.what.clause(),
            passes: verdict.passes(),
            reason,
        }
    }
}
