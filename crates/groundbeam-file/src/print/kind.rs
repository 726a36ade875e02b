//! Kinds of printed quantities, and the metric units in which each kind is printed.

use groundbeam::{Field, solution::Dimension};

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// Kind of physical quantity, which determines the units in which a number is printed.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Kind {
            $($(#[$doc])* $name,)*
        }

        impl Kind {
            /// All kinds.
            pub const ALL: &[Kind] = &[$(Kind::$name),*];
        }
    };
}

kinds! {
    /// A position or a length along the beam \[m\].
    Position,
    /// A deflection w, a ground displacement u or an initial gap g₀ \[m\].
    Deflection,
    /// A slope or a rotation \[rad\].
    Slope,
    /// A moment \[N·m\].
    Moment,
    /// A force \[N\].
    Force,
    /// A force per length \[N/m\].
    Pressure,
    /// The bending stiffness EI \[N·m²\].
    BendingStiffness,
    /// The subgrade modulus k per length of beam \[N/m²\].
    Spring,
    /// The stiffness μ of the shear layer, or the compression P \[N\].
    Constant,
    /// The subgrade modulus per area of ground: k divided by the bearing width \[N/m³\].
    AreaSpring,
    /// The stiffness μ of the shear layer divided by the bearing width \[N/m\].
    AreaShear,
    /// A force per area \[Pa\].
    Stress,
    /// A curvature, or a wave number \[1/m\].
    PerLength,
}

/// In the system of tonne-force and kilogram-force, a zero is printed in the unit that is used for a value of
/// this magnitude. The magnitude is in SI units.
pub(super) const TECHNICAL: f64 = 1e4;

/// One tonne-force, 1000 × 9.806 65 N.
const TF: f64 = 9806.65;
const KGF: f64 = 9.80665;

/// Lists two units of a quantity: one with the tonne-force, for values of at least 0.1 tf, and one with the
/// kilogram-force, for smaller values.
macro_rules! technical {
    ($tonnes:literal, $kilograms:literal) => {
        Some(const { &[rung(0.1 * TF, TF, $tonnes), rung(0.0, KGF, $kilograms)] })
    };
}

/// Returns the name of the first unit in `ladder` that suits a value of the magnitude `size`, and the factor from this
/// unit to the SI unit.
pub(super) fn fitting(ladder: &[Rung], size: f64) -> (&'static str, f64) {
    let fits = ladder.iter().find(|rung| size >= rung.from);
    let rung = fits.or(ladder.last()).unwrap_or(&BARE);
    (rung.name, rung.size)
}

impl Kind {
    /// Returns the kind of quantity of a result along the beam, such as the bending moment.
    pub fn of(field: Field) -> Self {
        match field.dimension() {
            Dimension::Length => Kind::Deflection,
            Dimension::Angle => Kind::Slope,
            Dimension::Moment => Kind::Moment,
            Dimension::Force => Kind::Force,
            Dimension::ForcePerLength => Kind::Pressure,
        }
    }

    /// Returns a typical value of this kind of quantity. A zero is printed in the unit of this value.
    pub(super) fn usual(self) -> f64 {
        match self {
            Kind::Deflection | Kind::Slope => 1e-3,
            Kind::Moment | Kind::Force | Kind::Pressure => 1e3,
            _ => 1.0,
        }
    }

    /// Returns n if quantities of this kind have the unit force × lengthⁿ, and `None` if their unit contains no force.
    pub(super) fn power_of_length(self) -> Option<i32> {
        match self {
            Kind::BendingStiffness => Some(2),
            Kind::Moment => Some(1),
            Kind::Force | Kind::Constant => Some(0),
            Kind::Pressure | Kind::AreaShear => Some(-1),
            Kind::Spring | Kind::Stress => Some(-2),
            Kind::AreaSpring => Some(-3),
            Kind::Position | Kind::Deflection | Kind::Slope | Kind::PerLength => None,
        }
    }

    /// Returns the units with the tonne-force and with the kilogram-force; `None` for quantities without a
    /// force.
    pub(super) fn technical(self) -> Option<&'static [Rung]> {
        match self.power_of_length()? {
            2 => technical!("tf m²", "kgf m²"),
            1 => technical!("tf m", "kgf m"),
            0 => technical!("tf", "kgf"),
            -1 => technical!("tf/m", "kgf/m"),
            -2 => technical!("tf/m²", "kgf/m²"),
            _ => technical!("tf/m³", "kgf/m³"),
        }
    }

    /// Returns the metric units of this kind in descending order of the values for which they are used. The
    /// last unit is used for all smaller values.
    pub(super) fn ladder(self) -> &'static [Rung] {
        match self {
            Kind::Position => const { &[rung(0.0, 1.0, "m")] },
            // Engineers read settlements in millimetres, from hundredths of a millimetre to a metre.
            Kind::Deflection => {
                const {
                    &[
                        rung(1.0, 1.0, "m"),
                        rung(1e-5, 1e-3, "mm"),
                        rung(1e-8, 1e-6, "µm"),
                        rung(0.0, 1.0, "m"),
                    ]
                }
            }
            Kind::Slope => {
                const { &[rung(0.1, 1.0, "rad"), rung(1e-7, 1e-3, "mrad"), rung(0.0, 1.0, "rad")] }
            }
            Kind::Force => const { &metric(LOADS, ["GN", "MN", "kN", "N"]) },
            Kind::Moment => const { &metric(LOADS, ["GN m", "MN m", "kN m", "N m"]) },
            Kind::Pressure => const { &metric(LOADS, ["GN/m", "MN/m", "kN/m", "N/m"]) },
            Kind::BendingStiffness => {
                const { &metric(STIFFNESSES, ["GN m²", "MN m²", "kN m²", "N m²"]) }
            }
            Kind::Spring => const { &metric(STIFFNESSES, ["GN/m²", "MN/m²", "kN/m²", "N/m²"]) },
            Kind::Constant => const { &metric(STIFFNESSES, ["GN", "MN", "kN", "N"]) },
            Kind::AreaSpring => const { &metric(STIFFNESSES, ["GN/m³", "MN/m³", "kN/m³", "N/m³"]) },
            Kind::AreaShear => const { &metric(STIFFNESSES, ["GN/m", "MN/m", "kN/m", "N/m"]) },
            Kind::Stress => const { &metric(STRESSES, ["GPa", "MPa", "kPa", "Pa"]) },
            Kind::PerLength => const { &[rung(0.0, 1.0, "1/m")] },
        }
    }
}

/// A unit and the smallest value for which it is used.
pub(super) struct Rung {
    from: f64,
    pub size: f64,
    pub name: &'static str,
}

const fn rung(from: f64, size: f64, name: &'static str) -> Rung {
    Rung { from, size, name }
}

/// Smallest loads that are printed in units with the prefixes giga, mega and kilo. Loads from 0.1 kN to 100
/// MN are printed in kilonewtons.
const LOADS: [f64; 3] = [1e11, 1e8, 1e2];
/// Smallest stiffnesses that are printed in units with the prefixes giga, mega and kilo.
const STIFFNESSES: [f64; 3] = [1e9, 1e6, 1e3];
/// Smallest stresses that are printed in units with the prefixes giga, mega and kilo. Stresses from 0.1 kPa
/// to 10 MPa are printed in kilopascals.
const STRESSES: [f64; 3] = [1e9, 1e7, 1e2];

/// Returns the units with the prefixes giga, mega, kilo and none. `from` has the smallest value for each prefix.
const fn metric(from: [f64; 3], names: [&'static str; 4]) -> [Rung; 4] {
    [
        rung(from[0], 1e9, names[0]),
        rung(from[1], 1e6, names[1]),
        rung(from[2], 1e3, names[2]),
        rung(0.0, 1.0, names[3]),
    ]
}

pub(super) const BARE: Rung = rung(0.0, 1.0, "");
