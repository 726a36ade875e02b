//! Looks up fields and sides by name.

use crate::failure::Failure;
use groundbeam::{Field, solution::Side};

/// Returns the field with this name.
pub fn field(name: &str) -> Result<Field, Failure> {
    Field::named(name).ok_or_else(|| {
        let names = Field::ALL.map(Field::name).join(", ");
        Failure::Asked(format!("no field has the name `{name}`; the fields are {names}"))
    })
}

/// Returns the side with this name.
pub fn side(name: &str) -> Result<Side, Failure> {
    match name {
        "left" => Ok(Side::Left),
        "right" => Ok(Side::Right),
        _ => Err(Failure::Asked(format!("`{name}` is not a side: write `left` or `right`"))),
    }
}
