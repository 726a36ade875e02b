//! Reads the shear stiffness of a beam: one number, or G and the shear area.

use super::error::{Read, wrong};
use super::fields::{
    AREA, Along, Fields, MODULUS, NUMBER, Quantity, SHEAR_STIFFNESS, Section, Values,
};
use super::product::{Found, Given};
use super::shapes::Shape;
use crate::Scalar;

/// Keys of the shear stiffness in `[beam]` and in its segments.
pub(crate) const KEYS: &[&str] = &["shear_stiffness", "GA", "G", "nu", "shear_area"];
const NAMES: [&str; 3] = ["shear_stiffness", "G", "shear_area"];

/// Shear data of a table: the shear stiffness or its factors, and Poisson's ratio.
#[derive(Debug, Clone)]
pub(crate) struct Shear<S> {
    given: Given<S>,
    poisson: Option<Quantity<S>>,
    /// Whether the table gives `shear_area`. Otherwise the shear area is that of the section.
    says_area: bool,
}

impl<S: Scalar> Shear<S> {
    /// Shear data of a table that has no keys of the shear stiffness.
    pub fn nothing() -> Self {
        Shear { given: Given::nothing(), poisson: None, says_area: false }
    }

    /// Restricts the shear stiffness or its factors to a part of the stretch of the beam to which they apply. The part
    /// begins and ends at the fractions `way` of the length of the stretch.
    pub fn between(&self, way: [S; 2]) -> Self {
        Shear { given: self.given.between(way), ..self.clone() }
    }

    /// Reads the shear data of a table. `modulus` is Young's modulus of this table and that of the whole beam, and
    /// `shape` is the cross section of this table.
    pub fn read(
        fields: &mut Fields,
        section: Section,
        modulus: [Option<&Along<S>>; 2],
        shape: Option<&Shape<S>>,
        parent: &Shear<S>,
    ) -> Read<Self> {
        section.exclusive("shear_stiffness", "GA")?;
        section.exclusive("G", "nu")?;
        let mut whole = None;
        for key in ["shear_stiffness", "GA"] {
            let read = fields.along(section, key, SHEAR_STIFFNESS, Values::Curve(6))?;
            whole = whole.or(read);
        }
        let own_modulus = fields.along(section, "G", MODULUS, Values::Linear)?;
        let poisson: Option<Quantity<S>> = fields.quantity(section, "nu", NUMBER)?;
        let [own, beams] = modulus;
        // If a table gives E but not G, its G follows from this E and from Poisson's ratio of the beam.
        let inherits = own.is_some() && own_modulus.is_none();
        let inherited = parent.poisson.as_ref().filter(|_| inherits);
        let by_poisson = match (poisson.as_ref().or(inherited), own.or(beams)) {
            (None, _) => None,
            (Some(nu), _) if !(0.0..=0.5).contains(&nu.value.middle()) => {
                return wrong(nu.at, "Poisson's ratio must lie between 0 and 0.5");
            }
            (Some(nu), None) => return wrong(nu.at, "`nu` is given without `E`"),
            (Some(nu), Some(modulus)) => {
                let factor = S::one().div(S::of(2.0) * (S::one() + nu.value));
                let course = super::course::scaled(&modulus.course, factor);
                Some(Along { course, exact: None, at: nu.at })
            }
        };
        let area = fields.along(section, "shear_area", AREA, Values::Linear)?;
        let says_area = area.is_some();
        let area = area.or_else(|| shape?.shear_area.clone());
        let given = Given { whole, factors: [own_modulus.or(by_poisson), area] };
        Ok(Shear { given, poisson, says_area })
    }

    /// Computes the shear stiffness of the beam from the keys of a table; `None` if the table has no keys for shear
    /// deformation. A missing factor of the stiffness is taken from `parent`.
    pub fn settle(&self, section: Section, parent: &Shear<S>) -> Read<Option<Along<S>>> {
        let mut given = self.given.clone();
        if given.whole.is_some() && !self.says_area {
            given.factors[1] = None;
        }
        let says_modulus = given.factors[0].is_some();
        match given.resolve(&parent.given, NAMES)? {
            Found::Nothing => Ok(None),
            // If neither G nor a shear area is given, a cross section does not add shear deformation.
            Found::Half(_) if !self.says_area && !says_modulus => Ok(None),
            found => found.known(section, "shear_stiffness").map(Some),
        }
    }
}
