//! Writes the certificate of one solution as text.

use super::sheet::Sheet;
use crate::number::order;
use groundbeam::{Certificate, Verdict};

/// Adds a row with the energy gap, an estimate of the error in energy. For a local equilibrium, a second row states
/// that other equilibria may exist.
pub(crate) fn rows(sheet: &mut Sheet, certificate: &Certificate, verdict: Verdict) {
    let words = "recomputed from model and result by independent code";
    sheet.row("Certificate", words);
    let gap = order(certificate.relative_gap());
    sheet.item("energy gap", &format!("{gap} of the strain energy, an estimate of the error"));
    if let Verdict::Local(_) = verdict {
        let words = "the energy gap measures the error of this solution only; other equilibria far from this solution may exist";
        sheet.item("reach", words);
    }
}

/// Text such as `energy gap at most 3e-16 of the strain energy`. The argument is the relative energy gap as
/// text.
pub(crate) fn energy_gap(gap: &str) -> String {
    format!("energy gap at most {gap} of the strain energy")
}

/// Adds a row with the largest relative energy gap of several solutions.
pub(crate) fn of_several(sheet: &mut Sheet, of: &str, gap: f64) {
    sheet.row("Certificate", &format!("{of}; {}", energy_gap(&order(gap))));
}

#[cfg(test)]
mod tests {
    use super::*;
    use groundbeam::{
        Beam, Foundation, Load, Method, Model, Options, Outcome, existence::Local, solve_with,
    };

    /// Returns the text of the certificate for Kikuchi's case IV. The beam has only two elements, so that the
    /// discretization error is much larger than the rounding errors.
    fn written(verdict: Verdict) -> String {
        let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
            .with_load(Load::point_force(0.5, 1.0))
            .with_load(Load::point_moment(0.5, 0.49));
        let options = Options { method: Method::ActiveSet, elements: 2, ..Options::default() };
        let Ok(Outcome::Equilibrium(solution)) = solve_with(&model, &options) else { panic!() };
        let mut sheet = Sheet::new(false);
        rows(&mut sheet, solution.certificate(), verdict);
        sheet.finish()
    }

    #[test]
    fn the_certificate_has_the_expected_text() {
        let expected = "\
Certificate  recomputed from model and result by independent code
             energy gap  3e−2 of the strain energy, an estimate of the error
";
        assert_eq!(written(Verdict::Unique), expected);
    }

    #[test]
    fn the_text_of_a_local_equilibrium_mentions_other_equilibria() {
        let local = Local { stability_margin: 0.5, critical_compression: 2.0 };
        let text = written(Verdict::Local(local)).replace("\n                         ", " ");
        assert!(text.contains("other equilibria far from this solution may exist"), "{text}");
    }
}
