//! Computes the conversion factor of the unit of an expected value, by reading a small model file that contains this unit.

use groundbeam::model::Extent;
use groundbeam_file::UnitSystem;

/// The dimension of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A position or deflection.
    Length,
    /// A slope.
    Angle,
    /// A force.
    Force,
    /// A moment or an energy.
    Moment,
    /// A pressure.
    LineLoad,
    /// A number without a unit.
    Number,
}

/// Returns the factor from a unit to m, N and rad; 1 if the numbers of the file have no units.
pub fn scale(kind: Kind, unit: &str, units: UnitSystem) -> Result<f64, String> {
    if kind == Kind::Number || units == UnitSystem::Plain {
        return match unit {
            "" => Ok(1.0),
            _ => Err(format!("the value has no unit: remove `{unit}`")),
        };
    }
    let (load, at) = match kind {
        Kind::Angle if unit == "rad" => return Ok(1.0),
        Kind::Angle if unit == "mrad" => return Ok(1e-3),
        Kind::Angle => return Err(format!("`{unit}` is not `rad` or `mrad`")),
        Kind::Length => ("point = \"1 N\"".to_owned(), format!("1 {unit}")),
        Kind::Force => (format!("point = \"1 {unit}\""), "0 m".to_owned()),
        Kind::Moment => (format!("moment = \"1 {unit}\""), "0 m".to_owned()),
        Kind::LineLoad | Kind::Number => (format!("distributed = \"1 {unit}\""), String::new()),
    };
    let at = if at.is_empty() { at } else { format!("at = \"{at}\"") };
    let text = format!(
        "[beam]\nlength = \"1e9 m\"\nEI = \"1 N m^2\"\n[foundation]\nk = \"1 N/m^2\"\n\
         [[load]]\n{load}\n{at}\n"
    );
    let document = groundbeam_file::parse(&text)
        .map_err(|_| format!("`{unit}` is not a unit of {}", kind.describe()))?;
    match document.model.loads[0].extent() {
        Extent::Point { at, .. } if kind == Kind::Length => Ok(at),
        extent => Ok(extent.sizes()[0]),
    }
}

impl Kind {
    fn describe(self) -> &'static str {
        match self {
            Kind::Length => "a length",
            Kind::Angle => "a slope",
            Kind::Force => "a force",
            Kind::Moment => "a moment",
            Kind::LineLoad => "a force per length",
            Kind::Number => "a number",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_those_of_the_model_files() {
        let scale = |kind, unit| scale(kind, unit, UnitSystem::Si);
        assert_eq!(scale(Kind::Length, "mm"), Ok(1e-3));
        assert_eq!(scale(Kind::Moment, "kN m"), Ok(1e3));
        assert_eq!(scale(Kind::LineLoad, "kN/m"), Ok(1e3));
        assert_eq!(scale(Kind::Angle, "mrad"), Ok(1e-3));
        assert!(scale(Kind::Force, "mm").is_err());
        assert!(super::scale(Kind::Force, "kN", UnitSystem::Plain).is_err());
    }
}
