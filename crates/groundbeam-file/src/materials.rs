//! Finds materials by name in the data files in `materials/`.

use crate::catalogue::{self, Entry};
use crate::quantity::{ELASTIC_MODULUS, EXPANSION, UNIT_WEIGHT};
use serde::Deserialize;
use std::sync::LazyLock;

/// Data file of materials. Each source applies to all materials of the file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Family {
    #[serde(rename = "E")]
    elastic_modulus: String,
    unit_weight: String,
    expansion: String,
    #[serde(rename = "material")]
    materials: Vec<Listed>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Listed {
    name: String,
    #[serde(default)]
    also: Vec<String>,
    #[serde(rename = "E")]
    elastic_modulus: String,
    unit_weight: Option<String>,
    expansion: String,
}

/// A built-in material, which a model file selects with `[beam] material = "…"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Material {
    /// Name of the material.
    pub name: String,
    /// Alternative names of the material.
    pub also: Vec<String>,
    /// Elastic modulus E \[N/m²\].
    pub elastic_modulus: f64,
    /// Unit weight \[N/m³\]; `None` if the standard does not list the unit weight.
    pub unit_weight: Option<f64>,
    /// Coefficient of thermal expansion \[1/K\].
    pub expansion: f64,
    /// Sources of the elastic modulus, the unit weight and the coefficient of thermal expansion.
    pub sources: [String; 3],
}

static MATERIALS: LazyLock<Vec<Material>> = LazyLock::new(|| {
    let families: Vec<Family> = catalogue::files(&[
        include_str!("../materials/concrete.toml"),
        include_str!("../materials/steel.toml"),
        include_str!("../materials/rails.toml"),
        include_str!("../materials/timber.toml"),
        include_str!("../materials/hardwood.toml"),
        include_str!("../materials/glulam.toml"),
    ]);
    families.into_iter().flat_map(materials_of).collect()
});

/// Returns all built-in materials.
///
/// ```
/// let materials = groundbeam_file::materials();
/// let concrete = materials.iter().find(|material| material.name == "C30/37").unwrap();
/// assert_eq!((concrete.elastic_modulus, concrete.unit_weight), (33e9, Some(25e3)));
/// ```
pub fn materials() -> &'static [Material] {
    &MATERIALS
}

/// Returns the material with this name or alternative name.
pub(crate) fn find(name: &str) -> Option<&'static Material> {
    MATERIALS.iter().find(|material| material.is_called(name))
}

/// Returns all names of all materials, including the alternative names.
pub(crate) fn spellings() -> Vec<&'static str> {
    catalogue::spellings(MATERIALS.iter())
}

impl Entry for Material {
    fn name(&self) -> &str {
        &self.name
    }

    fn also(&self) -> &[String] {
        &self.also
    }
}

/// Returns the names of materials that contain a word, for suggestions. For example, `C30` may mean `C30/37`.
pub(crate) fn holding(word: &str) -> Vec<&'static str> {
    let parts = |name: &str| name.split([' ', '/']).any(|part| part.eq_ignore_ascii_case(word));
    MATERIALS.iter().map(|m| &*m.name).filter(|name| parts(name)).collect()
}

fn materials_of(family: Family) -> impl Iterator<Item = Material> {
    let sources = [family.elastic_modulus, family.unit_weight, family.expansion];
    family.materials.into_iter().map(move |listed| Material {
        elastic_modulus: ELASTIC_MODULUS.listed(&listed.elastic_modulus),
        unit_weight: listed.unit_weight.map(|weight| UNIT_WEIGHT.listed(&weight)),
        expansion: EXPANSION.listed(&listed.expansion),
        name: listed.name,
        also: listed.also,
        sources: sources.clone(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the elastic moduli of concrete by EN 1992-1-1, Table 3.1:
    /// E_cm = 22 (f_cm/10)^0.3 GPa with f_cm = f_ck + 8 MPa, rounded to whole numbers.
    #[test]
    fn concrete_follows_its_formula() {
        let concrete = materials().iter().filter(|m| m.name.contains('/'));
        let mut count = 0;
        for material in concrete {
            let strength: f64 = material.name[1..].split('/').next().unwrap().parse().unwrap();
            let formula = 22.0 * (0.1 * (strength + 8.0)).powf(0.3);
            assert!((material.elastic_modulus / 1e9 - formula).abs() < 0.52, "{}", material.name);
            count += 1;
        }
        assert_eq!(count, 14);
    }

    #[test]
    fn values_of_materials_are_in_their_ranges() {
        for material in materials() {
            let Material { name, elastic_modulus, unit_weight, expansion, sources, .. } = material;
            assert!((7e9..=210e9).contains(elastic_modulus), "{name}");
            assert!(unit_weight.is_none_or(|weight| (3e3..80e3).contains(&weight)), "{name}");
            assert!((5e-6..=12e-6).contains(expansion), "{name}");
            assert!(sources.iter().all(|source| !source.is_empty()));
        }
        assert_eq!(holding("C30"), ["C30/37", "timber C30"]);
    }
}
