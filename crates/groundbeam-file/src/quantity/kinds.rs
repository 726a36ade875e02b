//! All kinds of quantity in a model.

use super::kind::{Kind, kind};
use crate::demand::{Place, Sign};
use crate::print;
use crate::unit::Dimension;

const LINE_LOAD: Dimension = Dimension::new(1, -1);
const STRESS: Dimension = Dimension::new(1, -2);
pub(super) const MODULUS: Dimension = Dimension::new(1, -3);
const STIFFNESS: Dimension = Dimension::new(1, 2);
const SECOND_MOMENT: Dimension = Dimension::new(0, 4);

pub(crate) const LENGTH: Kind = kind("a length", Dimension::LENGTH, "12 m", "m", &[])
    .sign(Sign::Positive)
    .printed_as(print::Kind::Position);
pub(crate) const POSITION: Kind = kind("a length", Dimension::LENGTH, "1 m", "m", &[])
    .on(Place::Beam)
    .printed_as(print::Kind::Position);
pub(crate) const GROUND_POSITION: Kind = kind("a length", Dimension::LENGTH, "1 m", "m", &[])
    .on(Place::Ground)
    .printed_as(print::Kind::Position);
/// A length measured from a point other than an end of the beam: from the first axle of a train, or from sea
/// level.
pub(crate) const OFFSET: Kind =
    kind("a length", Dimension::LENGTH, "1 m", "m", &[]).printed_as(print::Kind::Position);
/// A distance behind the first axle of a train.
pub(crate) const BEHIND: Kind = kind("a length", Dimension::LENGTH, "1 m", "m", &[])
    .sign(Sign::NotNegative)
    .printed_as(print::Kind::Position);
pub(crate) const WIDTH: Kind =
    kind("a length", Dimension::LENGTH, "1 m", "m", &[]).sign(Sign::Positive);
pub(crate) const CLEARANCE: Kind =
    kind("a length", Dimension::LENGTH, "2 mm", "mm", &[]).printed_as(print::Kind::Deflection);
pub(crate) const SETTLEMENT_LIMIT: Kind = kind("a length", Dimension::LENGTH, "2 mm", "mm", &[])
    .sign(Sign::Positive)
    .printed_as(print::Kind::Deflection);
pub(crate) const FORCE: Kind =
    kind("a force", Dimension::FORCE, "600 kN", "kN", &[]).printed_as(print::Kind::Force);
pub(crate) const MOMENT: Kind =
    kind("a moment", Dimension::new(1, 1), "50 kN m", "kN m", &[]).printed_as(print::Kind::Moment);
pub(crate) const LOAD_PER_LENGTH: Kind = kind(
    "a force per length",
    LINE_LOAD,
    "20 kN/m",
    "kN/m",
    &[(STRESS, "a pressure acts on an area: multiply it by the beam's width")],
)
.printed_as(print::Kind::Pressure);
pub(crate) const MOMENT_PER_LENGTH: Kind =
    kind("a moment per length", Dimension::FORCE, "5 kN m/m", "kN m/m", &[]);
pub(crate) const BENDING_STIFFNESS: Kind = kind(
    "a bending stiffness",
    STIFFNESS,
    "1.2e6 kN m^2",
    "kN m^2",
    &[
        (STRESS, "give an elastic modulus as `E`, together with `I` or `section`"),
        (SECOND_MOMENT, "give a second moment of area as `I`, together with `E`"),
    ],
)
.sign(Sign::Positive)
.printed_as(print::Kind::BendingStiffness);
pub(crate) const ELASTIC_MODULUS: Kind = kind(
    "an elastic modulus",
    STRESS,
    "30 GPa",
    "GPa",
    &[(STIFFNESS, "give a bending stiffness as `EI`, in place of `E` and `I`")],
)
.sign(Sign::Positive).plausible([3e8, 1e12], "the modulus of a beam is usually between 1 and 300 GPa, and that of a soil belongs in [foundation.soil]");
/// The modulus of a soil or a rock.
pub(crate) const SOIL_MODULUS: Kind = kind(
    "an elastic modulus",
    STRESS,
    "15 MPa",
    "MPa",
    &[(MODULUS, "give a force per volume as `subgrade_modulus`, in place of the soil data")],
)
.sign(Sign::Positive)
.plausible([1e5, 1e11], "the modulus of a soil is usually between 1 and 500 MPa");
pub(crate) const SECOND_MOMENT_OF_AREA: Kind =
    kind("a second moment of area", SECOND_MOMENT, "0.04 m^4", "m^4", &[]).sign(Sign::Positive);
pub(crate) const SHEAR_STIFFNESS: Kind = kind(
    "a force (a shear stiffness)",
    Dimension::FORCE,
    "900 MN",
    "MN",
    &[(STRESS, "give a shear modulus as `G`, together with `shear_area` or a `section`")],
)
.sign(Sign::Positive);
pub(crate) const SHEAR_MODULUS: Kind =
    kind("a shear modulus", STRESS, "12.5 GPa", "GPa", &[]).sign(Sign::Positive);
pub(crate) const SHEAR_AREA: Kind =
    kind("an area", Dimension::new(0, 2), "0.4 m^2", "m^2", &[]).sign(Sign::Positive);
pub(crate) const SPRING_PER_LENGTH: Kind = kind(
    "a force per length per deflection",
    STRESS,
    "40 MN/m^2",
    "MN/m^2",
    &[(MODULUS, "give a force per volume as `subgrade_modulus`, together with `width`")],
)
.sign(Sign::Positive)
.printed_as(print::Kind::Spring)
.plausible([1e4, 3e9], "k per length of beam is usually between 0.1 and 1000 MN/m²");
pub(crate) const SUBGRADE_MODULUS: Kind = kind(
    "a force per area per deflection",
    MODULUS,
    "40 MN/m^3",
    "MN/m^3",
    &[(
        STRESS,
        "give a force per length of beam per deflection as `k`, in place of `subgrade_modulus` and `width`",
    )],
)
.sign(Sign::Positive)
.printed_as(print::Kind::AreaSpring)
.plausible([1e6, 3e8], "a subgrade modulus is usually between 1 and 300 MN/m³ (4 and 1100 pci)");
pub(crate) const SHEAR_CONSTANT: Kind =
    kind("a force (the ground's shear constant)", Dimension::FORCE, "9 MN", "MN", &[])
        .sign(Sign::NotNegative)
        .printed_as(print::Kind::Constant);
pub(crate) const AREA_SHEAR: Kind = kind(
    "a force per length (the shear constant per width)",
    LINE_LOAD,
    "9 MN/m",
    "MN/m",
    &[(
        Dimension::FORCE,
        "a force is the shear constant of the whole width: give it as `mu`, in place of `C2`",
    )],
)
.sign(Sign::NotNegative)
.printed_as(print::Kind::AreaShear);
pub(crate) const UNIT_WEIGHT: Kind =
    kind("a force per volume", MODULUS, "25 kN/m^3", "kN/m^3", &[])
        .sign(Sign::Positive)
        .plausible([5e3, 9e4], "a unit weight is usually between 5 and 90 kN/m³ (32 and 570 pcf)");
pub(crate) const STRESS_LIMIT: Kind = kind("a pressure", STRESS, "200 kPa", "kPa", &[])
    .sign(Sign::Positive)
    .printed_as(print::Kind::Stress);
pub(crate) const RATIO: Kind = kind("a plain number", Dimension::NONE, "0.3", "", &[]);
pub(crate) const SPRING: Kind =
    kind("a force per deflection", LINE_LOAD, "10 MN/m", "MN/m", &[]).sign(Sign::NotNegative);
pub(crate) const ROTATIONAL_SPRING: Kind = kind(
    "a moment per angle",
    Dimension { angle: -1, ..Dimension::new(1, 1) },
    "5 MN m/rad",
    "MN m/rad",
    &[],
)
.sign(Sign::NotNegative);

pub(crate) const CURVATURE: Kind = kind(
    "a curvature",
    Dimension { angle: 1, ..Dimension::new(0, -1) },
    "1e-4 1/m",
    "1/m",
    &[(
        Dimension::LENGTH,
        "a radius is the inverse of a curvature: give the curvature, as in \"1e-4 1/m\"",
    )],
)
.printed_as(print::Kind::PerLength);
pub(crate) const TEMPERATURE: Kind =
    kind("a temperature difference", Dimension::TEMPERATURE, "15 K", "K", &[]);
pub(crate) const EXPANSION: Kind = kind(
    "a strain per temperature",
    Dimension { temperature: -1, ..Dimension::NONE },
    "1e-5 1/K",
    "1/K",
    &[],
)
.sign(Sign::Positive);
pub(crate) const STRAIN: Kind = kind("a strain", Dimension::NONE, "300e-6", "", &[]);
pub(crate) const DEPTH: Kind =
    kind("a length", Dimension::LENGTH, "0.2 m", "m", &[]).sign(Sign::Positive);
pub(crate) const CAMBER: Kind = kind("a length", Dimension::LENGTH, "20 mm", "mm", &[]);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_of_its_own_kind() {
        let kinds = [
            LENGTH,
            POSITION,
            GROUND_POSITION,
            OFFSET,
            BEHIND,
            WIDTH,
            CLEARANCE,
            SETTLEMENT_LIMIT,
            FORCE,
            MOMENT,
            LOAD_PER_LENGTH,
            MOMENT_PER_LENGTH,
            BENDING_STIFFNESS,
            ELASTIC_MODULUS,
            SOIL_MODULUS,
            SECOND_MOMENT_OF_AREA,
            SHEAR_STIFFNESS,
            SHEAR_MODULUS,
            SHEAR_AREA,
            SPRING_PER_LENGTH,
            SUBGRADE_MODULUS,
            SHEAR_CONSTANT,
            SPRING,
            ROTATIONAL_SPRING,
            CURVATURE,
            TEMPERATURE,
            EXPANSION,
            DEPTH,
            CAMBER,
        ];
        for kind in kinds {
            assert!(kind.read("key", kind.example, false).unwrap().has_unit);
            assert!(kind.read("key", &format!("1 {}", kind.unit), false).unwrap().has_unit);
        }
    }
}
