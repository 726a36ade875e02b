//! Materials by name: E, unit weight and thermal expansion.
//!
//! The unit weights are from EN 1991-1-1, annex A. Those of hardwood follow from the mean density in EN 338. The
//! thermal expansion of timber is from EN 1991-1-5, table C.1.

use super::error::{Read, wrong};
use super::fields::{EXPANSION, Kind, MODULUS, Quantity, Section, UNIT_WEIGHT, listed};
use crate::Scalar;

/// A family of materials, such as concrete: the common unit weight \[kN/m³\] of the materials (empty if it differs), their
/// thermal expansion \[10⁻⁶/K\], and the list of the materials.
struct Family {
    unit_weight: &'static str,
    expansion: &'static str,
    /// Name, E \[GPa\] and unit weight \[kN/m³\] of each material. The text of the unit weight is empty if the
    /// common `unit_weight` applies.
    materials: &'static [(&'static str, &'static str, &'static str)],
}

/// A material of the lists.
#[derive(Clone, Copy)]
pub(crate) struct Material {
    modulus: &'static str,
    unit_weight: &'static str,
    expansion: &'static str,
}

const FAMILIES: [Family; 4] = [
    // Concrete: EN 1992-1-1, table 3.1 and 3.1.3.
    Family {
        unit_weight: "25",
        expansion: "10",
        materials: &[
            ("C12/15", "27", ""),
            ("C16/20", "29", ""),
            ("C20/25", "30", ""),
            ("C25/30", "31", ""),
            ("C30/37", "33", ""),
            ("C35/45", "34", ""),
            ("C40/50", "35", ""),
            ("C45/55", "36", ""),
            ("C50/60", "37", ""),
            ("C55/67", "38", ""),
            ("C60/75", "39", ""),
            ("C70/85", "41", ""),
            ("C80/95", "42", ""),
            ("C90/105", "44", ""),
        ],
    },
    // Structural steel: EN 1993-1-1, 3.2.6. Rail steel has the same values.
    Family {
        unit_weight: "78.5",
        expansion: "12",
        materials: &[
            ("S235", "210", ""),
            ("S275", "210", ""),
            ("S355", "210", ""),
            ("S420", "210", ""),
            ("S450", "210", ""),
            ("S460", "210", ""),
            ("R200", "210", ""),
            ("R220", "210", ""),
            ("R260", "210", ""),
            ("R260Mn", "210", ""),
            ("R320Cr", "210", ""),
            ("R350HT", "210", ""),
            ("R350LHT", "210", ""),
        ],
    },
    // Softwood and hardwood: EN 338, tables 1 and 3.
    Family {
        unit_weight: "",
        expansion: "5",
        materials: &[
            ("timber C14", "7", "3.5"),
            ("timber C16", "8", "3.7"),
            ("timber C18", "9", "3.8"),
            ("timber C20", "9.5", ""),
            ("timber C22", "10", "4.1"),
            ("timber C24", "11", "4.2"),
            ("timber C27", "11.5", "4.5"),
            ("timber C30", "12", "4.6"),
            ("timber C35", "13", "4.8"),
            ("timber C40", "14", "5.0"),
            ("timber C45", "15", ""),
            ("timber C50", "16", ""),
            ("timber D18", "9.5", "5.5897905"),
            ("timber D24", "10", "5.687857"),
            ("timber D27", "10.5", "5.9820565"),
            ("timber D30", "11", "6.276256"),
            ("timber D35", "12", "6.3743225"),
            ("timber D40", "13", "6.472389"),
            ("timber D45", "13.5", "6.864655"),
            ("timber D50", "14", "7.256921"),
            ("timber D55", "15.5", "7.7472535"),
            ("timber D60", "17", "8.237586"),
            ("timber D65", "18.5", "8.825985"),
            ("timber D70", "20", "9.414384"),
            ("timber D75", "22", "10.002783"),
            ("timber D80", "24", "10.591182"),
        ],
    },
    // Glued laminated timber: EN 14080, tables 4 and 5.
    Family {
        unit_weight: "",
        expansion: "5",
        materials: &[
            ("GL20h", "8.4", ""),
            ("GL22h", "10.5", ""),
            ("GL24h", "11.5", "3.7"),
            ("GL26h", "12.1", ""),
            ("GL28h", "12.6", "4.0"),
            ("GL30h", "13.6", ""),
            ("GL32h", "14.2", "4.2"),
            ("GL20c", "10.4", ""),
            ("GL22c", "10.4", ""),
            ("GL24c", "11.0", "3.5"),
            ("GL26c", "12.0", ""),
            ("GL28c", "12.5", "3.7"),
            ("GL30c", "13.0", ""),
            ("GL32c", "13.5", "4.0"),
        ],
    },
];

/// Whether a name such as `D24` is a class of hardwood. No class of another material begins with this letter.
fn is_hardwood(name: &str) -> bool {
    name.strip_prefix('D').is_some_and(|class| class.bytes().all(|byte| byte.is_ascii_digit()))
}

/// Classes of softwood whose names may omit `timber`, because no class of concrete has the same number.
const SHORT: [&str; 5] = ["C14", "C18", "C22", "C24", "C27"];

/// Reads the material that a table names. Returns the material and the position of its name.
pub(crate) fn named(section: Section) -> Read<Option<(Material, usize)>> {
    let Some((name, at)) = section.words("material")? else { return Ok(None) };
    let name = name.trim();
    let is_short = SHORT.contains(&name) || is_hardwood(name);
    let long = if is_short { format!("timber {name}") } else { name.to_owned() };
    for Family { unit_weight, expansion, materials } in FAMILIES {
        if let Some((_, modulus, own)) = materials.iter().find(|(name, ..)| *name == long) {
            let unit_weight = if own.is_empty() { unit_weight } else { own };
            return Ok(Some((Material { modulus, unit_weight, expansion }, at)));
        }
    }
    wrong(at, format!("the material `{name}` is not known"))
}

impl Material {
    /// E.
    pub fn modulus<S: Scalar>(&self) -> Read<Quantity<S>> {
        quantity(self.modulus, "GPa", MODULUS)
    }

    /// Weight per unit volume; `None` if the standard does not list it.
    pub fn unit_weight<S: Scalar>(&self) -> Read<Option<Quantity<S>>> {
        match self.unit_weight {
            "" => Ok(None),
            weight => quantity(weight, "kN/m^3", UNIT_WEIGHT).map(Some),
        }
    }

    /// Strain per temperature.
    pub fn expansion<S: Scalar>(&self) -> Read<Quantity<S>> {
        quantity(self.expansion, "um/(m K)", EXPANSION)
    }
}

fn quantity<S: Scalar>(number: &str, unit: &str, kind: Kind) -> Read<Quantity<S>> {
    listed(&format!("{number} {unit}"), kind)
}
