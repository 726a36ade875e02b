//! Warns about implausible sizes of quantities and about models without loads.

use crate::code;
use crate::diagnostic::{Diagnostic, Severity};
use crate::fault::Fault;
use crate::print::{Kind, Units};
use crate::reader::Reader;
use crate::section::Contents;
use std::ops::Range;

/// Plausible range of μ/(k h²), where h is the height of the beam. Soil layers with a thickness between h/3 and 30 h
/// have ratios in this range.
const SHEAR: [f64; 2] = [1e-2, 3e2];

/// Returns the warnings about a file. In a file without units, the sizes of quantities cannot be judged.
pub(crate) fn warnings(reader: &Reader, contents: &Contents, units: Units) -> Vec<Diagnostic> {
    let sized = reader.quantities.iter().filter(|seen| seen.has_unit && !units.is_plain());
    let sizes = sized.filter_map(|seen| {
        let (range, rule) = seen.kind.plausible?;
        let is_plausible = (range[0]..=range[1]).contains(&seen.value.abs()) || seen.value == 0.0;
        let message = format!("`{}` has an implausible size: {rule}", seen.key);
        (!is_plausible).then(|| Fault::new(code::IMPLAUSIBLE, seen.span.clone(), message, "", ""))
    });
    let shear = shear(reader, contents, units);
    let none = contents.model.loads.is_empty() && contents.trains.is_empty();
    let none = none.then(|| {
        let hint = "add a load, as in [[load]] with point = \"600 kN\" and at = \"1 m\"";
        Fault::new(code::NO_LOADS, 0..0, "the model has no loads", "", hint)
    });
    let all = sizes.chain(shear).chain(none);
    let warning =
        |fault| Diagnostic { severity: Severity::Warning, ..Diagnostic::new(reader.source, fault) };
    all.map(warning).collect()
}

/// Warns if the shear constant μ is far from k h², where h is the height of the beam.
fn shear(reader: &Reader, contents: &Contents, units: Units) -> Option<Fault> {
    let given = |key: &str| reader.quantities.iter().find(|seen| seen.key == key);
    let at: Range<usize> = given("mu").or(given("C2"))?.span.clone();
    let height = contents.height.filter(|height| *height > 0.0 && !units.is_plain())?;
    let (spring, shear) =
        (contents.model.foundation.subgrade, contents.model.foundation.shear_layer);
    let usual = spring * height * height;
    let quotient = shear / usual;
    if !(spring > 0.0 && shear > 0.0) || (SHEAR[0]..=SHEAR[1]).contains(&quotient) {
        return None;
    }
    let side = if quotient < 1.0 { "small" } else { "large" };
    let message = format!(
        "the shear constant is implausibly {side}: k times the square of the beam's height is {}, and mu is {}",
        units.write(Kind::Constant, usual),
        units.write(Kind::Constant, shear)
    );
    let hint = "mu is a force and applies to the whole width of the beam";
    Some(Fault::new(code::IMPLAUSIBLE, at, message, "", hint))
}

#[cfg(test)]
mod tests {
    /// Returns, for each warning about a model, its code and the part of the input that it marks.
    fn warned(text: &str) -> Vec<(&'static str, String)> {
        let document = crate::parse(text).unwrap();
        let marked = |d: &crate::Diagnostic| (d.code, text[d.span.clone()].to_owned());
        document.warnings.iter().map(marked).collect()
    }

    fn footing(e: &str, k: &str, mu: &str, load: &str) -> String {
        format!(
            "[beam]\nlength = '12 m'\nE = '{e}'\nsection = {{ width = '1 m', height = '0.5 m' }}\n\
             [foundation]\nsubgrade_modulus = '{k}'\nwidth = '1 m'\nmu = '{mu}'\n{load}"
        )
    }

    const LOAD: &str = "[[load]]\npoint = '600 kN'\nat = '6 m'\n";

    #[test]
    fn plausible_sizes_give_no_warning() {
        assert_eq!(warned(&footing("30 GPa", "40 MN/m^3", "9 MN", LOAD)), []);
        assert_eq!(warned(&footing("30 GPa", "40 MN/m^3", "0 kN", LOAD)), []);
        // In a file without units, the sizes of quantities cannot be judged.
        let plain =
            "[beam]\nlength = 1\nEI = 1\n[foundation]\nk = 1e9\n[[load]]\npoint = 1\nat = 0.5\n";
        assert_eq!(warned(plain), []);
    }

    #[test]
    fn implausible_sizes_give_a_warning() {
        let of = |e, k, mu, load| warned(&footing(e, k, mu, load));
        let marked = |text: &str| vec![("GB901", text.to_owned())];
        assert_eq!(of("30 GPa", "40 GN/m^3", "9 GN", LOAD), marked("'40 GN/m^3'"));
        assert_eq!(of("15 MPa", "40 MN/m^3", "9 MN", LOAD), marked("'15 MPa'"));
        assert_eq!(of("30 GPa", "40 MN/m^3", "9 kN", LOAD), marked("'9 kN'"));
        assert_eq!(of("30 GPa", "40 MN/m^3", "90 GN", LOAD), marked("'90 GN'"));
        assert_eq!(warned(&footing("30 GPa", "40 MN/m^3", "9 MN", ""))[0].0, "GB902");
    }
}
