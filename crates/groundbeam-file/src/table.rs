//! One table of the file, and the wrong names that users try in it.

use crate::suggest::nearest;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A table with its place and the name it goes by in messages.
#[derive(Clone)]
pub(crate) struct Section<'a> {
    pub table: &'a DeTable<'a>,
    /// The header, or the braces of an inline table.
    pub span: Range<usize>,
    /// As a file writes it: `[beam]`, `[[load]]`.
    pub name: &'static str,
}

impl<'a> Section<'a> {
    /// Whether numbers stand bare in this table and those below, and none stands in quotes.
    pub fn has_bare_numbers_only(&self) -> bool {
        let mut bare = false;
        let mut waiting: Vec<&DeValue> =
            self.table.iter().map(|(_, value)| value.get_ref()).collect();
        while let Some(value) = waiting.pop() {
            match value {
                DeValue::Table(table) => waiting.extend(table.iter().map(|(_, v)| v.get_ref())),
                DeValue::Array(array) => waiting.extend(array.iter().map(|v| v.get_ref())),
                DeValue::Integer(_) | DeValue::Float(_) => bare = true,
                DeValue::String(text)
                    if text.trim_start().starts_with(|c: char| c.is_ascii_digit()) =>
                {
                    return false;
                }
                _ => {}
            }
        }
        bare
    }

    pub fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.table.get(key)
    }
}

/// Other names for the same things: the library's words, other programs' words, other letters.
const MEANT: &[(&str, &[&str])] = &[
    ("beam", &["bar", "girder", "member"]),
    ("foundation", &["ground", "soil", "subgrade", "bed"]),
    ("load", &["force", "forces", "action"]),
    ("support", &["bearing", "constraint"]),
    ("hinge", &["joint", "internal_hinge", "release"]),
    ("gap", &["clearance", "initial_gap"]),
    ("case", &["load_case"]),
    ("combination", &["load_combination", "combinations", "combo"]),
    ("factors", &["factor", "coefficients"]),
    ("action", &["type", "kind", "category", "nature"]),
    ("set", &["code", "standard"]),
    ("group", &["exclusive", "alternative"]),
    ("train", &["moving_load", "vehicle", "trains", "axle_train"]),
    ("axles", &["axle", "wheels", "forces"]),
    ("length", &["l", "span"]),
    ("EI", &["bending_stiffness", "stiffness", "flexural_rigidity"]),
    ("E", &["elastic_modulus", "youngs_modulus", "young", "modulus"]),
    ("I", &["second_moment_of_area", "moment_of_inertia", "inertia"]),
    ("shear_stiffness", &["kga", "gas", "gav", "shear_rigidity", "timoshenko"]),
    ("shear_area", &["as", "a_s", "av", "a_v"]),
    ("G", &["shear_modulus"]),
    ("nu", &["poisson", "poissons_ratio", "ν"]),
    ("axial_force", &["n", "p", "axial", "normal_force"]),
    ("subgrade_modulus", &["ks", "k_s", "modulus", "bedding_modulus"]),
    ("k", &["spring", "spring_constant", "winkler", "stiffness"]),
    ("mu", &["µ", "μ", "shear", "g", "gp", "shear_constant", "pasternak"]),
    ("width", &["b", "breadth"]),
    ("height", &["h", "d", "depth"]),
    ("point", &["f", "p", "force", "value", "point_load", "magnitude"]),
    ("moment", &["m", "couple"]),
    ("distributed", &["q", "w", "uniform", "line", "distributed_load"]),
    ("distributed_moment", &["line_moment"]),
    ("at", &["x", "position", "location", "station"]),
    ("from", &["start", "begin", "x1"]),
    ("to", &["end", "x2"]),
    ("spring", &["k", "stiffness", "spring_constant"]),
    ("rotational_spring", &["k_r", "kr", "rotation", "rotational"]),
    ("type", &["kind"]),
    ("acts", &["direction", "one_way", "only"]),
    ("value", &["gap", "clearance", "size"]),
];

/// The key among `keys` that someone who writes `written` probably means.
pub(crate) fn suggestion<'k>(written: &str, keys: &[&'k str]) -> Option<&'k str> {
    let lower = written.to_lowercase();
    let is_other_name = |key: &str| {
        MEANT.iter().any(|(name, others)| *name == key && others.contains(&lower.as_str()))
    };
    nearest(written, keys.iter().copied())
        .or_else(|| keys.iter().copied().find(|key| is_other_name(key)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slips_and_other_names_lead_to_the_key() {
        assert_eq!(suggestion("lenght", &["length", "EI"]), Some("length"));
        assert_eq!(suggestion("ei", &["length", "EI"]), Some("EI"));
        assert_eq!(suggestion("bending_stiffness", &["length", "EI"]), Some("EI"));
        assert_eq!(suggestion("shear", &["k", "mu"]), Some("mu"));
        assert_eq!(suggestion("loads", &["beam", "load"]), Some("load"));
        assert_eq!(suggestion("colour", &["beam", "load"]), None);
    }
}
