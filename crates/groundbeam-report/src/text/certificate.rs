//! The proof, in words.

use super::sheet::Sheet;
use crate::number::order;
use crate::quantity::{Kind, Units};
use groundbeam::{Certificate, Verdict};

/// What was recomputed from the model, by code that shares nothing with the method.
pub(crate) fn rows(sheet: &mut Sheet, proof: &Certificate, verdict: Verdict, units: Units) {
    let words = "recomputed from the model alone, by other code than the method's";
    sheet.row("Certificate", words);
    sheet.item("energy gap", &format!("{} of the strain energy", order(proof.relative_gap())));
    let balance = format!(
        "forces balance to {}, moments to {}",
        order(proof.force_balance()),
        order(proof.moment_balance())
    );
    sheet.item("balance", &balance);
    let pull = if proof.smallest_pressure() < 0.0 {
        format!("no pull beyond {} of the largest pressure", order(-proof.smallest_pressure()))
    } else {
        "no pull anywhere".to_owned()
    };
    sheet.item("pressure", &pull);
    let penetration = if proof.deepest_penetration() > 0.0 {
        let depth = order(proof.deepest_penetration());
        format!("the beam enters the ground by {depth} of its deflection at most")
    } else {
        "the beam enters the ground nowhere".to_owned()
    };
    sheet.item("gap", &penetration);
    let bound = |kind, value: f64| units.write(kind, value, 1);
    let settlement = if proof.settlement_bound().is_finite() {
        format!("right to ± {} everywhere", bound(Kind::Deflection, proof.settlement_bound()))
    } else {
        "no bound at a point: the ground has no shear layer".to_owned()
    };
    sheet.item("settlement", &settlement);
    if proof.moment_rms_bound().is_finite() {
        let moment = bound(Kind::Moment, proof.moment_rms_bound());
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
    use groundbeam::{Beam, Foundation, Load, Method, Model, Options, Outcome, solve_with};

    /// Kikuchi's case IV on two elements, with or without its shear layer: errors that are no rounding.
    fn proof(foundation: Foundation) -> Certificate {
        let model = Model::new(Beam::uniform(1.0, 1.0), foundation)
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.49));
        let options = Options { method: Method::ActiveSet, elements: 2, ..Options::default() };
        let Ok(Outcome::Equilibrium(solution)) = solve_with(&model, &options) else { panic!() };
        *solution.certificate()
    }

    fn written(proof: &Certificate) -> String {
        let mut sheet = Sheet::new(false);
        rows(&mut sheet, proof, Verdict::Unique, Units::Si);
        sheet.finish()
    }

    #[test]
    fn a_proof_in_words() {
        let proof = proof(Foundation::pasternak(1.0, 1.0));
        // Rounding alone: these figures may change with any change of the program.
        let [force, moment] = [proof.force_balance(), proof.moment_balance()].map(order);
        let expected = format!(
            "\
Certificate  recomputed from the model alone, by other code than the method's
             energy gap  3e-6 of the strain energy
             balance     forces balance to {force}, moments to {moment}
             pressure    no pull anywhere
             gap         the beam enters the ground nowhere
             settlement  right to ± 0.8 mm everywhere
             moment      right to ± 0.001 N m, root mean square along the beam
"
        );
        assert_eq!(written(&proof), expected);
    }

    #[test]
    fn without_a_shear_layer_nothing_is_claimed_at_a_point() {
        let proof = proof(Foundation::winkler(1.0));
        assert!(written(&proof).contains("no bound at a point: the ground has no shear layer"));
        let pull = order(-proof.smallest_pressure());
        assert!(written(&proof).contains(&format!("no pull beyond {pull} of the largest")));
    }
}
