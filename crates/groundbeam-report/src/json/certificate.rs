//! The certificate in the result document.

use groundbeam::Certificate;
use serde::Serialize;

/// Its fields, by their names and in their order.
#[derive(Serialize)]
#[serde(remote = "Certificate")]
pub(super) struct Proof {
    primal_energy: f64,
    dual_energy: f64,
    gap: f64,
    relative_gap: f64,
    force_balance: f64,
    moment_balance: f64,
    smallest_pressure: f64,
    deepest_penetration: f64,
    continuity: f64,
    complementarity: f64,
    settlement_bound: f64,
    moment_bound: f64,
    moment_rms_bound: f64,
}
