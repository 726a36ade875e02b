//! Requirements on the number under a key: its sign and, for a position, whether it must lie on the beam or on the ground.

/// Signs that a number may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sign {
    /// The number may be negative, zero or positive.
    Any,
    /// The number must be zero or positive.
    NotNegative,
    /// The number must be positive.
    Positive,
}

/// Whether a position must lie on the beam or on the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The position must lie on the beam, between 0 and the length of the beam.
    Beam,
    /// The position must lie on the ground, which extends beyond the beam.
    Ground,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Quantity;
    use std::collections::BTreeSet;
    use std::path::{Path, PathBuf};

    /// Model file with keys that the other model files of the repository do not use.
    const OTHERS: &str = "\
[beam]
length = \"12 m\"
EI = \"1e5 kN m^2\"
shear_stiffness = \"900 MN\"
axial_force = \"0 kN\"
[foundation]
k = \"40 MN/m^2\"
mu = \"9 MN\"
left = { ends = \"-2 m\", as = \"free\" }
[[hinge]]
at = \"4 m\"
rotational_spring = \"5 MN m/rad\"
[[support]]
at = \"9 m\"
spring = \"10 MN/m\"
rotational_spring = \"5 MN m/rad\"
settlement = \"2 mm\"
[[load]]
curvature = \"1e-4 1/m\"
[[load]]
temperature_difference = \"15 K\"
expansion = \"1e-5 1/K\"
depth = \"0.5 m\"
[[load]]
distributed_moment = \"5 kN m/m\"
[[ground_load]]
point = \"20 kN\"
at = \"14 m\"
[[gap]]
at = \"3 m\"
value = \"2 mm\"
[[train]]
axles = [{ at = \"0 m\", force = \"50 kN\" }, { at = \"3 m\", force = \"60 kN\" }]
uniform = [{ from = \"5 m\", to = \"9 m\", load = \"80 kN/m\" }]
from = \"-1 m\"
to = \"20 m\"
[checks]
bearing_pressure = \"200 kPa\"
width = \"1 m\"
settlement = \"20 mm\"
";

    /// Returns all valid model files of `cases/` and `docs/`, with their folders.
    fn files() -> Vec<(String, PathBuf)> {
        let root = groundbeam_testing::repository();
        let mut all = vec![(OTHERS.to_owned(), root.clone())];
        for folder in ["docs", "cases"] {
            let found = groundbeam_testing::files(&root.join(folder), "toml");
            for path in
                found.into_iter().filter(|path| !path.starts_with(root.join("cases/errors")))
            {
                let text = std::fs::read_to_string(&path).unwrap();
                all.push((text, path.parent().unwrap().to_owned()));
            }
        }
        all
    }

    /// Replaces a number of the file. Returns whether the reader refuses the file because of the sign of the new
    /// number.
    fn is_refused(text: &str, folder: &Path, quantity: &Quantity, number: &str) -> bool {
        let at = quantity.number.clone();
        let unit = quantity.decimal.map_or("", |(_, unit)| unit);
        let changed = format!("{}{number}{unit}{}", &text[..at.start], &text[at.end..]);
        let Err(found) = crate::parse_beside(&changed, folder) else { return false };
        found.iter().any(|fault| {
            let words = format!("{} {}", fault.message, fault.hint);
            fault.span.contains(&quantity.span.start) && words.contains("positive")
        })
    }

    #[test]
    fn recorded_signs_agree_with_the_reader() {
        let mut keys = BTreeSet::new();
        let mut wrong = BTreeSet::new();
        // A key that allows 0 must be accepted with 0 in at least one model file. Some files need a shear layer and
        // refuse μ = 0.
        let (mut may_be_zero, mut was_zero) = (BTreeSet::new(), BTreeSet::new());
        for (text, folder) in files() {
            let Ok(document) = crate::parse_beside(&text, &folder) else { continue };
            for quantity in &document.quantities {
                let key = quantity.key.clone();
                let [zero, negative] =
                    ["0", "-3"].map(|number| is_refused(&text, &folder, quantity, number));
                if negative != (quantity.sign != Sign::Any) {
                    wrong.insert(format!("{key}: {:?}, -3", quantity.sign));
                }
                if !zero && quantity.sign == Sign::Positive {
                    wrong.insert(format!("{key}: {:?}, 0", quantity.sign));
                }
                if !zero {
                    was_zero.insert((key.clone(), quantity.sign == Sign::Positive));
                }
                may_be_zero.insert((key.clone(), quantity.sign == Sign::Positive));
                keys.insert(key);
            }
        }
        may_be_zero.retain(|(_, is_positive)| !is_positive);
        assert!(keys.len() > 30, "{keys:?}");
        assert!(wrong.is_empty(), "{wrong:#?}");
        assert!(may_be_zero.is_subset(&was_zero), "{may_be_zero:?} {was_zero:?}");
    }
}
