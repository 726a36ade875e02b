//! The proof, in words.

use super::sheet::Sheet;
use crate::number::order;
use crate::quantity::{Kind, Units};
use groundbeam::Solution;

/// What was recomputed from the model, by code that shares nothing with the method.
pub(super) fn rows(sheet: &mut Sheet, solution: &Solution, units: Units) {
    let proof = solution.certificate();
    let words = "recomputed from the model alone, by other code than the method's";
    sheet.row("Certificate", words);
    sheet.item("energy gap", &format!("{} of the strain energy", order(proof.relative_gap)));
    let balance = format!(
        "forces balance to {}, moments to {}",
        order(proof.force_balance),
        order(proof.moment_balance)
    );
    sheet.item("balance", &balance);
    let pull = if proof.smallest_pressure < 0.0 {
        format!("no pull beyond {} of the largest pressure", order(-proof.smallest_pressure))
    } else {
        "no pull anywhere".to_owned()
    };
    sheet.item("pressure", &pull);
    let penetration = if proof.deepest_penetration > 0.0 {
        let depth = order(proof.deepest_penetration);
        format!("the beam enters the ground by {depth} of its deflection at most")
    } else {
        "the beam enters the ground nowhere".to_owned()
    };
    sheet.item("gap", &penetration);
    let bound = |kind, value: f64| units.write(kind, value, 1);
    let settlement = if proof.settlement_bound.is_finite() {
        format!("right to ± {} everywhere", bound(Kind::Deflection, proof.settlement_bound))
    } else {
        "no bound at a point: the ground has no shear layer".to_owned()
    };
    sheet.item("settlement", &settlement);
    if proof.moment_rms_bound.is_finite() {
        let moment = bound(Kind::Moment, proof.moment_rms_bound);
        sheet.item("moment", &format!("right to ± {moment}, root mean square along the beam"));
    }
}
