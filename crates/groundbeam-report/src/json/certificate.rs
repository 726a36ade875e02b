//! The certificate in the result document.

use groundbeam::Certificate;
use serde::Serialize;

#[derive(Serialize)]
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

impl From<&Certificate> for Proof {
    fn from(certificate: &Certificate) -> Self {
        let Certificate {
            primal_energy,
            dual_energy,
            gap,
            relative_gap,
            force_balance,
            moment_balance,
            smallest_pressure,
            deepest_penetration,
            continuity,
            complementarity,
            settlement_bound,
            moment_bound,
            moment_rms_bound,
        } = *certificate;
        Proof {
            primal_energy,
            dual_energy,
            gap,
            relative_gap,
            force_balance,
            moment_balance,
            smallest_pressure,
            deepest_penetration,
            continuity,
            complementarity,
            settlement_bound,
            moment_bound,
            moment_rms_bound,
        }
    }
}
