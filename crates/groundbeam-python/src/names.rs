//! Fields and sides by name.

use crate::failure::Failure;
use groundbeam::{Field, Side};

/// A field by its name.
pub fn field(name: &str) -> Result<Field, Failure> {
    Field::named(name).ok_or_else(|| {
        let names = Field::ALL.map(Field::name).join(", ");
        Failure::Asked(format!("no field is called `{name}`; the fields are {names}"))
    })
}

/// A side by its name.
pub fn side(name: &str) -> Result<Side, Failure> {
    match name {
        "left" => Ok(Side::Left),
        "right" => Ok(Side::Right),
        _ => Err(Failure::Asked(format!("`{name}` is no side: say `left` or `right`"))),
    }
}
