//! Dimensions of units: powers of force, length, angle and temperature.

/// Exponents of force, length, angle and temperature difference in a unit. Mass and time do not occur in a
/// model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Dimension {
    pub force: i32,
    pub length: i32,
    pub angle: i32,
    pub temperature: i32,
}

impl Dimension {
    pub const NONE: Dimension = Dimension::new(0, 0);
    pub const FORCE: Dimension = Dimension::new(1, 0);
    pub const LENGTH: Dimension = Dimension::new(0, 1);
    pub const ANGLE: Dimension = Dimension { angle: 1, ..Dimension::NONE };
    pub const TEMPERATURE: Dimension = Dimension { temperature: 1, ..Dimension::NONE };

    /// Returns the dimension force^`force` × length^`length`.
    pub const fn new(force: i32, length: i32) -> Self {
        Dimension { force, length, angle: 0, temperature: 0 }
    }

    /// Multiplies this dimension by a power of `other`. Exponents saturate at the limits of their type, which
    /// are far beyond the exponents of any unit.
    pub fn times(self, other: Dimension, power: i32) -> Self {
        let add = |mine: i32, its: i32| mine.saturating_add(its.saturating_mul(power));
        Dimension {
            force: add(self.force, other.force),
            length: add(self.length, other.length),
            angle: add(self.angle, other.angle),
            temperature: add(self.temperature, other.temperature),
        }
    }

    /// Describes the dimension in words with an article, such as "a force per length".
    pub fn describe(self) -> String {
        if self == Dimension::TEMPERATURE {
            return "a temperature".to_owned();
        }
        let known = match (self.force, self.length, self.angle) {
            _ if self.temperature != 0 => "",
            (0, 0, 0) => "a plain number",
            (0, 0, 1) => "an angle",
            (0, -1, 0 | 1) => "a curvature",
            (0, 1, 0) => "a length",
            (0, 2, 0) => "an area",
            (0, 3, 0) => "a volume",
            (0, 4, 0) => "a second moment of area",
            (1, 0, 0) => "a force",
            (1, -1, 0) => "a force per length",
            (1, -2, 0) => "a force per area",
            (1, -3, 0) => "a force per volume",
            (1, 1, 0) => "a moment",
            (1, 1, -1) => "a moment per angle",
            (1, 2, 0) => "a bending stiffness",
            _ => "",
        };
        if !known.is_empty() {
            return known.to_owned();
        }
        let factors = [
            ("force", self.force),
            ("length", self.length),
            ("angle", self.angle),
            ("temperature", self.temperature),
        ];
        let written: Vec<String> = factors
            .into_iter()
            .filter(|&(_, power)| power != 0)
            .map(|(name, power)| if power == 1 { name.into() } else { format!("{name}^{power}") })
            .collect();
        format!("a quantity of the kind {}", written.join(" "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_kinds_have_names_and_others_are_spelled_out() {
        let line_load = Dimension::FORCE.times(Dimension::LENGTH, -1);
        assert_eq!(line_load.describe(), "a force per length");
        let odd = Dimension::ANGLE.times(Dimension::FORCE, 2).times(Dimension::LENGTH, -5);
        assert_eq!(odd.describe(), "a quantity of the kind force^2 length^-5 angle");
    }
}
