//! The proof, in words.

use super::sheet::Sheet;
use crate::number::order;
use crate::quantity::{Kind, Units};
use groundbeam::{Certificate, Verdict};

/// What was recomputed from the model, by code that shares nothing with the method.
pub(super) fn rows(sheet: &mut Sheet, proof: &Certificate, verdict: Verdict, units: Units) {
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
    if let Verdict::Local(_) = verdict {
        let words = "the bounds are for the equilibrium with this contact; others, far from it, are not ruled out";
        sheet.item("reach", words);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(proof: &Certificate) -> String {
        let mut sheet = Sheet::new(false);
        rows(&mut sheet, proof, Verdict::Unique, Units::Si);
        sheet.finish()
    }

    #[test]
    fn a_proof_in_words() {
        let proof = Certificate {
            relative_gap: 3.1e-16,
            force_balance: 2.2e-16,
            moment_balance: 0.0,
            smallest_pressure: -1e-17,
            deepest_penetration: 9e-15,
            settlement_bound: 3.4e-13,
            moment_rms_bound: 0.02,
            ..Certificate::default()
        };
        let expected = "\
Certificate  recomputed from the model alone, by other code than the method's
             energy gap  3e-16 of the strain energy
             balance     forces balance to 2e-16, moments to 0
             pressure    no pull beyond 1e-17 of the largest pressure
             gap         the beam enters the ground by 9e-15 of its deflection
                         at most
             settlement  right to ± 3e-13 m everywhere
             moment      right to ± 0.02 N m, root mean square along the beam
";
        assert_eq!(written(&proof), expected);
    }

    #[test]
    fn without_a_shear_layer_nothing_is_claimed_at_a_point() {
        let proof = Certificate { settlement_bound: f64::INFINITY, ..Certificate::default() };
        assert!(written(&proof).contains("no bound at a point: the ground has no shear layer"));
        assert!(written(&proof).contains("no pull anywhere"));
    }
}
