//! The fields of a solution, and a table of their names, symbols, units, reference magnitudes and sign conventions.

use crate::model::Beam;

/// A quantity that has a value at every position of the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Field {
    /// The deflection w.
    Deflection,
    /// The slope w'.
    Slope,
    /// The rotation φ of the cross-sections. It equals w' where the beam has no shear deformation.
    Rotation,
    /// The bending moment M.
    Moment,
    /// The shear force V.
    ShearForce,
    /// The settlement u of the ground's surface.
    Settlement,
    /// The gap u + g₀ − w between beam and ground.
    Gap,
    /// The contact pressure p.
    Pressure,
}

/// One value for each field, in the order of [`Field::ALL`].
pub type ByField<T> = [T; Field::ALL.len()];

/// The dimension of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A length \[m\].
    Length,
    /// An angle \[rad\].
    Angle,
    /// A moment \[N·m\].
    Moment,
    /// A force \[N\].
    Force,
    /// A force per length of the beam \[N/m\].
    ForcePerLength,
}

/// A row of the table of field properties.
struct Facts {
    name: &'static str,
    label: &'static str,
    title: &'static str,
    symbol: &'static str,
    dimension: Dimension,
    positive: &'static str,
    drawn_down: bool,
}

impl Field {
    /// All fields, in the order in which results list them.
    pub const ALL: [Field; 8] = [
        Field::Deflection,
        Field::Slope,
        Field::Rotation,
        Field::Moment,
        Field::ShearForce,
        Field::Settlement,
        Field::Gap,
        Field::Pressure,
    ];

    /// The fields that are listed in the results of a beam, in the order of the list. The rotation is omitted if the
    /// beam has no shear deformation, because it then equals the slope.
    pub fn of(beam: &Beam) -> impl Iterator<Item = Field> + Clone + use<> {
        Field::listed(beam.shears())
    }

    /// The fields that are listed in results. The rotation is included only if `shears` is true.
    pub(crate) fn listed(shears: bool) -> impl Iterator<Item = Field> + Clone + use<> {
        Field::ALL.into_iter().filter(move |field| shears || *field != Field::Rotation)
    }

    /// The field with the given name; `None` if no field has this name.
    pub fn named(name: &str) -> Option<Self> {
        Field::ALL.into_iter().find(|field| field.name() == name)
    }

    /// Position of the field in [`Field::ALL`].
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Name of the field in JSON, CSV, model files, commands and Python, such as `deflection` or `shear_force`.
    pub const fn name(self) -> &'static str {
        self.facts().name
    }

    /// Short name of the field in texts, such as `Moment`.
    pub const fn label(self) -> &'static str {
        self.facts().label
    }

    /// Full name of the field, such as `Bending moment`.
    pub const fn title(self) -> &'static str {
        self.facts().title
    }

    /// Symbol of the field in formulas, such as `w′`.
    pub const fn symbol(self) -> &'static str {
        self.facts().symbol
    }

    /// The dimension of the field.
    pub const fn dimension(self) -> Dimension {
        self.facts().dimension
    }

    /// SI unit of the field, such as `N·m`.
    pub const fn unit(self) -> &'static str {
        self.dimension().unit()
    }

    /// Meaning of a positive value of the field, such as `sagging`. It is empty for the shear force, because no
    /// short text describes its sign.
    pub const fn positive(self) -> &'static str {
        self.facts().positive
    }

    /// Whether a diagram shows positive values below the zero line.
    pub const fn drawn_down(self) -> bool {
        self.facts().drawn_down
    }

    /// Expected magnitude of the field, from the beam's length, the sum of the forces, the largest deflection and a
    /// typical pressure. Much smaller values are rounding errors.
    pub fn natural_size(self, length: f64, force: f64, deflection: f64, pressure: f64) -> f64 {
        match self.dimension() {
            Dimension::Length => deflection,
            Dimension::Angle => deflection / length,
            Dimension::Moment => force * length,
            Dimension::Force => force,
            Dimension::ForcePerLength => pressure,
        }
    }

    #[rustfmt::skip]
    const fn facts(self) -> Facts {
        use Dimension::{Angle, Force, ForcePerLength, Length, Moment};
        let (name, label, title, symbol, dimension, positive, drawn_down) = match self {
            Field::Deflection => ("deflection", "Deflection", "Deflection", "w", Length, "down", true),
            Field::Slope => ("slope", "Slope", "Slope", "w′", Angle, "the right side is lower", true),
            Field::Rotation => ("rotation", "Rotation", "Rotation", "φ", Angle, "the right side is lower", true),
            Field::Moment => ("moment", "Moment", "Bending moment", "M", Moment, "sagging", true),
            Field::ShearForce => ("shear_force", "Shear force", "Shear force", "V", Force, "", false),
            Field::Settlement => ("settlement", "Settlement", "Settlement", "u", Length, "down", true),
            Field::Gap => ("gap", "Gap", "Gap", "u + g₀ − w", Length, "open", false),
            Field::Pressure => ("pressure", "Pressure", "Contact pressure", "p", ForcePerLength, "pushes the beam up", true),
        };
        Facts { name, label, title, symbol, dimension, positive, drawn_down }
    }
}

impl Dimension {
    /// SI unit of the dimension.
    pub const fn unit(self) -> &'static str {
        match self {
            Dimension::Length => "m",
            Dimension::Angle => "rad",
            Dimension::Moment => "N·m",
            Dimension::Force => "N",
            Dimension::ForcePerLength => "N/m",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_index_is_the_position_in_the_list_and_a_name_is_of_one_field() {
        for (i, field) in Field::ALL.into_iter().enumerate() {
            assert_eq!((field.index(), Field::named(field.name())), (i, Some(field)));
        }
        assert_eq!(Field::named("curvature"), None);
    }

    #[test]
    fn a_beam_without_shear_deformation_lists_no_rotation() {
        let beam = Beam::uniform(1.0, 1.0);
        let listed: Vec<Field> = Field::of(&beam).collect();
        assert_eq!(listed.len(), 7);
        assert!(!listed.contains(&Field::Rotation));
        assert!(Field::of(&beam.with_shear_stiffness(1.0)).eq(Field::ALL));
    }
}
