//! Parses comma-separated positions, as given on the command line.

use crate::code;
use crate::diagnostic::Diagnostics;
use crate::document::Document;
use crate::fault::Fault;
use crate::list;
use crate::quantity::POSITION;
use crate::units::UnitSystem;

/// Parses comma-separated positions along the beam. With [`UnitSystem::Si`], every position except 0 needs a unit, and
/// results are in metres. With [`UnitSystem::Plain`], no position may have a unit.
///
/// ```
/// use groundbeam_file::{UnitSystem, parse_positions};
///
/// assert_eq!(parse_positions("0, 0.5, 1", UnitSystem::Plain).unwrap(), [0.0, 0.5, 1.0]);
/// assert_eq!(parse_positions("0, 50 cm", UnitSystem::Si).unwrap(), [0.0, 0.5]);
/// ```
///
/// # Errors
///
/// Returns one diagnostic for each entry that is not a position. Its byte positions refer to `list`.
pub fn parse_positions(list: &str, units: UnitSystem) -> Result<Vec<f64>, Diagnostics> {
    list::read(list, |entry| position(entry, units))
}

/// Parses a comma-separated list of positions on the beam of a document.
///
/// # Errors
///
/// Returns the diagnostics of [`parse_positions`], and one for each position outside the beam.
pub fn parse_positions_on_beam(list: &str, document: &Document) -> Result<Vec<f64>, Diagnostics> {
    let (length, units) = (document.model.beam.length, document.printed.of_input());
    list::read(list, |entry| {
        let x = position(entry, document.units)?;
        if (0.0..=length).contains(&x) {
            return Ok(x);
        }
        let message = format!("{} lies outside the beam", units.position(x));
        let end = units.position(length);
        let hint = format!("the beam extends from 0 to {end}, measured from its left end");
        Err(Fault::new("GB301", 0..entry.len(), message, "", hint))
    })
}

fn position(entry: &str, units: UnitSystem) -> Result<f64, Fault> {
    let at = 0..entry.len();
    let example = match units {
        UnitSystem::Si => "as in \"0 m, 0.5 m, 1 m\"",
        UnitSystem::Plain => "as in 0,0.5,1",
    };
    if entry.is_empty() {
        let message = "a position is missing here";
        let hint = format!("separate positions by single commas, {example}");
        return Err(Fault::new(code::NUMBER, at, message, "", hint));
    }
    let written = POSITION.read("at", entry, units == UnitSystem::Plain)?;
    match (units, written.has_unit) {
        (UnitSystem::Si, false) if written.value != 0.0 => {
            let hint = format!("give every position a unit, {example}");
            let message = format!("`{entry}` has no unit, but the file has units");
            Err(Fault::new(code::MIXED, at, message, "", hint))
        }
        (UnitSystem::Plain, true) => {
            let hint = format!("give plain numbers, {example}");
            let message = format!("`{entry}` has a unit, but the file has no units");
            Err(Fault::new(code::MIXED, at, message, "", hint))
        }
        _ => Ok(written.value),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_wrong_entry_is_reported_at_its_location() {
        let list = "0 m, x,, 2 kN, 3";
        let wrong = parse_positions(list, UnitSystem::Si).unwrap_err();
        let seen: Vec<_> = wrong.iter().map(|d| (d.code, &list[d.span.clone()])).collect();
        let expected =
            [(code::NUMBER, "x"), (code::NUMBER, ""), (code::WRONG_UNIT, "kN"), (code::MIXED, "3")];
        assert_eq!(seen, expected);
        assert!(parse_positions("1 m", UnitSystem::Plain).is_err());
        assert!(parse_positions("", UnitSystem::Plain).is_err());
    }
}
