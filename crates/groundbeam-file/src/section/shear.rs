//! Reads the beam's shear stiffness: one number, or G and the shear area.

use super::shape::Shape;
use crate::code;
use crate::fault::Fault;
use crate::keys::{ALSO_NU, Key, Value, along, key, quantity};
use crate::profile::Along;
use crate::quantity::{RATIO, SHEAR_AREA, SHEAR_MODULUS, SHEAR_STIFFNESS};
use crate::reader::{Field, Reader};
use crate::stiffness::{Given, Keys, Stiffness};
use crate::table::Section;
use groundbeam::model::Profile;

// Keys of the shear stiffness, in `[beam]` and in `[[beam.segment]]`.
const SHEARS: Value = Value::Along(&SHEAR_STIFFNESS, Profile::MOST);
pub(super) const STIFFNESS: Key =
    key("shear_stiffness", SHEARS, "The shear stiffness S = κGA; default: no shear deformation.")
        .also(&["kga", "gas", "gav", "shear_rigidity", "timoshenko"]);
pub(super) const GA: Key = key("GA", SHEARS, "Another name for `shear_stiffness`.");
pub(super) const MODULUS: Key =
    along("G", &SHEAR_MODULUS, 2, "The shear modulus; it needs a `section` or `shear_area`.")
        .also(&["shear_modulus"]);
pub(super) const POISSON: Key =
    quantity("nu", &RATIO, "Poisson's ratio, in place of `G`; it gives G = E/(2 (1 + nu)).")
        .also(ALSO_NU);
pub(super) const AREA: Key =
    along("shear_area", &SHEAR_AREA, 2, "The shear area κA; default: that of the section.")
        .also(&["as", "a_s", "av", "a_v"]);

const fn keys(modulus: &'static str) -> Keys {
    Keys {
        product: "shear_stiffness",
        factors: [modulus, "shear_area"],
        instead: ", or a `section` that has a shear area, in place of `EI` or `I`",
    }
}

/// Shear data of one table.
#[derive(Debug, Clone, Default)]
pub(super) struct Shear {
    given: Given,
    poisson: Option<Field>,
    /// Whether a shear area is given explicitly, not only through a section.
    says_area: bool,
}

impl Shear {
    /// Returns the shear data between two fractions of the length of the stretch.
    pub fn between(&self, way: [f64; 2]) -> Self {
        Shear { given: self.given.between(way), ..self.clone() }
    }

    /// Reads the shear data of `table`. `modulus` contains the E of the table and the E of the whole beam,
    /// and `shape` is the table's own section.
    pub fn read(
        reader: &mut Reader,
        table: &Section,
        modulus: [Option<&Along>; 2],
        shape: Option<&Shape>,
        parent: &Shear,
    ) -> Self {
        let both = ["shear_stiffness", "GA"].map(|key| reader.along(table, key));
        if let [Some(a), Some(b)] = &both {
            let hint = "`shear_stiffness` and `GA` have the same meaning; keep one of the two";
            reader.exclusive(("shear_stiffness", &a.span), ("GA", &b.span), hint);
        }
        let [named, short] = both;
        let shear_modulus = reader.along(table, "G");
        let shear_modulus = shear_modulus.map(|given| reader.positive_along("G", given));
        let poisson = poisson(reader, table);
        if let (Some(given), Some(poisson)) = (&shear_modulus, &poisson) {
            let hint = "`nu` gives G = E/(2 (1 + nu)): keep either `G` or `nu`";
            reader.exclusive(("G", &given.span), ("nu", &poisson.span), hint);
        }
        // A segment with its own E inherits Poisson's ratio, so that it has its own G.
        let [own, whole] = modulus;
        let inherited = parent.poisson.clone().filter(|_| own.is_some() && shear_modulus.is_none());
        let of = poisson.clone().or(inherited);
        let by_poisson = of.map(|nu| match own.or(whole) {
            Some(modulus) => {
                let profile = modulus.profile.scaled(0.5 / (1.0 + nu.value));
                Along { profile, span: nu.span }
            }
            None => {
                let message = "`nu` is given without `E`";
                let hint = "replace `EI` by a `section` with `E` or a `material`, or replace `nu` by `shear_stiffness`";
                let fault = Fault::new(code::INCOMPLETE, nu.span.clone(), message, "", hint);
                reader.report(fault);
                Along::unreadable(nu.span)
            }
        });
        let area = reader.along(table, "shear_area");
        let area = area.map(|area| reader.positive_along("shear_area", area));
        let says_area = area.is_some();
        let area = area.or_else(|| shape?.shear_area.clone());
        let given =
            Given { product: named.or(short), factors: [shear_modulus.or(by_poisson), area] };
        Shear { given, poisson, says_area }
    }

    /// Computes the shear stiffness from the data of a table, and reports missing values. Returns `None` if
    /// the table gives no data for the shear stiffness.
    pub fn settle(&self, reader: &mut Reader, table: &Section, parent: &Shear) -> Option<Along> {
        let keys = keys(if self.poisson.is_some() { "nu" } else { "G" });
        let mut given = self.given.clone();
        if given.product.is_some() && !self.says_area {
            // The file gives the shear stiffness directly, so the shear area of the section is ignored.
            given.factors[1] = None;
        }
        match given.resolve(reader, &parent.given, &keys) {
            Stiffness::NotGiven => None,
            // If neither G nor Poisson's ratio is given, the shear area of the cross-section alone does not add shear
            // deformation.
            Stiffness::Half(1, _) if !self.says_area => None,
            known => Some(reader.settle(known, table, &keys)),
        }
    }
}

/// Reads Poisson's ratio of the beam's material, which must lie between 0 and 0.5.
fn poisson(reader: &mut Reader, table: &Section) -> Option<Field> {
    let poisson = reader.quantity(table, "nu")?;
    if poisson.value < 0.0 || poisson.value > 0.5 {
        let message = "Poisson's ratio must lie between 0 and 0.5";
        let hint = "write nu = 0.2 for concrete or nu = 0.3 for steel; for timber give `G`";
        reader.report(Fault::new(code::POISSON, poisson.span.clone(), message, "", hint));
        return Some(Field::unreadable(poisson.span));
    }
    Some(poisson)
}
