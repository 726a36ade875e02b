//! Looks up result fields by name, and the left or the right side of a position.

use crate::failure::Failure;
use groundbeam::{Field, solution::Side};

/// Returns the field with this name.
pub fn field(name: &str) -> Result<Field, Failure> {
    Field::named(name).ok_or_else(|| {
        let names = Field::ALL.map(Field::name).join(", ");
        Failure::Asked(format!("no field has the name `{name}`; the fields are {names}"))
    })
}

/// Converts `left` or `right` to the side of a position from which the value of a field is taken.
pub fn side(name: &str) -> Result<Side, Failure> {
    match name {
        "left" => Ok(Side::Left),
        "right" => Ok(Side::Right),
        _ => Err(Failure::Asked(format!("`{name}` is not a side: write `left` or `right`"))),
    }
}
