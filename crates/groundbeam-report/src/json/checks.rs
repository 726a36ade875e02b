//! Checks in the result document.

use groundbeam::{Check, Limits, Solution};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Checked {
    name: &'static str,
    value: f64,
    limit: f64,
    x: Option<f64>,
    clause: Option<&'static str>,
    passes: bool,
}

/// Empty where nothing is asked for.
pub(super) fn of(limits: Option<&Limits>, solution: &Solution) -> Vec<Checked> {
    let checks = limits.map(|limits| limits.check(solution)).unwrap_or_default();
    let written = |check: Check| Checked {
        name: check.what.name(),
        value: check.found,
        limit: check.limit,
        x: check.at,
        clause: check.what.clause(),
        passes: check.passes(),
    };
    checks.into_iter().map(written).collect()
}
