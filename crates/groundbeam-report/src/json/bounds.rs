//! Writes error bounds for combinations: of the envelope, the extremes, the ranges of extremes over k and μ, and the checks.

use super::ByName;
use crate::checked::rows_of;
use crate::checked::{Governing, Judged, verdicts};
use crate::combinations::{
    bound_of_extreme, bounds_at, bounds_of_band, largest_end_force, numbered,
};
use crate::context::Context;
use groundbeam::Field;
use groundbeam_run::Answers;
use serde::Serialize;

/// Error bounds in the result document of several load combinations. A missing bound is written as `null`.
#[derive(Serialize)]
pub(super) struct Together {
    envelope: ByName<Ends<Vec<f64>>>,
    extremes: ByName<Ends<f64>>,
    /// For each end of the beam, error bound of the largest concentrated contact force among all combinations.
    end_forces: Forces,
    #[serde(skip_serializing_if = "Option::is_none")]
    band: Option<ByName<Ends<Spread>>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<JudgedCheck>,
}

/// Error bounds of the smallest and of the largest value of a field.
#[derive(Serialize)]
struct Ends<T> {
    min: T,
    max: T,
}

#[derive(Serialize)]
struct Forces {
    left: f64,
    right: f64,
}

#[derive(Serialize)]
struct Spread {
    best: f64,
    low: f64,
    high: f64,
}

/// A design check with the error bound of its value. A missing bound is written as `null`.
#[derive(Serialize)]
pub(super) struct JudgedCheck {
    name: &'static str,
    /// Name of the governing combination, if there are several combinations.
    #[serde(skip_serializing_if = "Option::is_none")]
    combination: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    limit_state: Option<&'static str>,
    value: f64,
    limit: f64,
    bound: Option<f64>,
    /// Verdict: `proven-to-pass`, `proven-to-fail` or `undecided` if the value has a finite error bound,
    /// otherwise `passes` or `fails`.
    judgement: &'static str,
}

impl JudgedCheck {
    pub fn of(judged: &Judged, combination: Option<&str>) -> Self {
        JudgedCheck {
            name: judged.check.what.name(),
            combination: combination.map(str::to_owned),
            limit_state: None,
            value: judged.check.found,
            limit: judged.check.limit,
            bound: judged.error,
            judgement: judged.judgement().name(),
        }
    }
}

impl Together {
    /// Computes the error bounds of the document. The bounds of the envelope apply at the positions `stations`.
    /// Returns `None` if no proof is requested or no combination is solved.
    pub fn of(answers: &Answers, stations: &[f64], context: &Context) -> Option<Self> {
        let solved = numbered(answers, context);
        if context.proofs.is_empty() || solved.is_empty() {
            return None;
        }
        let envelope = answers.envelope();
        let all: Vec<_> = stations.iter().map(|&x| envelope.all_at(x)).collect();
        let along = |field: Field| {
            let at = stations.iter().zip(&all).map(|(&x, bounds)| {
                let bounds = bounds[field.index()];
                let printed = [bounds.min, bounds.max].map(|governing| governing.extreme.value);
                let [min, max] = bounds_at(&solved, field, x, printed);
                (min, max)
            });
            let (min, max) = at.unzip();
            Ends { min, max }
        };
        let extremes = |field: Field| {
            let range = envelope.range(field);
            let bound = |is_max, governing| bound_of_extreme(&solved, field, is_max, governing).0;
            Ends { min: bound(false, range.min), max: bound(true, range.max) }
        };
        let band = answers.bands().map(|bands| {
            ByName::of(envelope.fields(), |field| {
                let spread = |is_max: bool| {
                    let banded = &bands[field.index()][usize::from(is_max)];
                    let [best, low, high] = bounds_of_band(&solved, field, is_max, banded);
                    Spread { best, low, high }
                };
                Ends { min: spread(false), max: spread(true) }
            })
        });
        Some(Together {
            envelope: ByName::of(envelope.fields(), along),
            extremes: ByName::of(envelope.fields(), extremes),
            end_forces: Forces {
                left: largest_end_force(&solved, 0)?.2,
                right: largest_end_force(&solved, 1)?.2,
            },
            band,
            checks: checks(answers, context),
        })
    }
}

/// Returns, for each design check in each limit state, the governing value with its bound and its
/// combination.
fn checks(answers: &Answers, context: &Context) -> Vec<JudgedCheck> {
    let rows = rows_of(answers, context);
    let all = verdicts(context.limits, &rows);
    let each = all.iter().filter_map(|verdict| match verdict.of {
        Governing::Judged(by, judged) => {
            let limit_state = verdict.state.map(|state| state.name());
            Some(JudgedCheck { limit_state, ..JudgedCheck::of(&judged, Some(&rows[by].name)) })
        }
        _ => None,
    });
    each.collect()
}
