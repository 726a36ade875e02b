//! Defines the kinds of quantity in a model file, and reads a quantity from a text.

mod kind;
mod kinds;
mod read;

pub(crate) use kind::Kind;
pub(crate) use kinds::{
    AREA_SHEAR, BEHIND, BENDING_STIFFNESS, CAMBER, CLEARANCE, CURVATURE, DEPTH, ELASTIC_MODULUS,
    EXPANSION, FORCE, GROUND_POSITION, LENGTH, LOAD_PER_LENGTH, MOMENT, MOMENT_PER_LENGTH, OFFSET,
    POSITION, RATIO, ROTATIONAL_SPRING, SECOND_MOMENT_OF_AREA, SETTLEMENT_LIMIT, SHEAR_AREA,
    SHEAR_CONSTANT, SHEAR_MODULUS, SHEAR_STIFFNESS, SOIL_MODULUS, SPRING, SPRING_PER_LENGTH,
    STRAIN, STRESS_LIMIT, SUBGRADE_MODULUS, TEMPERATURE, UNIT_WEIGHT, WIDTH,
};
pub(crate) use read::{REACH, Written, is_within_reach, not_finite, out_of_reach};
