//! The unit in which a quantity is written.

use crate::number::significant;
use groundbeam::{Dimension, Field};
use groundbeam_file::UnitSystem;

/// How numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Units {
    /// The model is in m, N and rad; people read kN and mm.
    Si,
    /// The numbers are one consistent system, whichever; no unit is written.
    Plain,
}

impl From<UnitSystem> for Units {
    /// Results are written as the quantities of the file are.
    fn from(of: UnitSystem) -> Self {
        match of {
            UnitSystem::Si => Units::Si,
            UnitSystem::Plain => Units::Plain,
        }
    }
}

impl Units {
    /// The name that results use: `SI` or `none`.
    pub fn name(self) -> &'static str {
        match self {
            Units::Si => "SI",
            Units::Plain => "none",
        }
    }

    /// The unit in which a quantity of at most this size reads well.
    pub(crate) fn unit(self, kind: Kind, largest: f64) -> Unit {
        if self == Units::Plain {
            return Unit { name: "", size: 1.0 };
        }
        let ladder = kind.ladder();
        let size = if largest == 0.0 { kind.usual() } else { largest.abs() };
        let fits = ladder.iter().find(|rung| size >= rung.from);
        let rung = fits.or(ladder.last()).unwrap_or(&BARE);
        Unit { name: rung.name, size: rung.size }
    }

    /// A quantity in a unit of its own choice: `600 kN`.
    pub(crate) fn write(self, kind: Kind, value: f64, digits: usize) -> String {
        self.unit(kind, value).write(value, digits)
    }

    /// A position along the beam.
    pub(crate) fn position(self, x: f64) -> String {
        self.write(Kind::Position, x, 6)
    }
}

/// A unit with its size in m, N and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unit {
    /// Empty for plain numbers.
    pub name: &'static str,
    pub size: f64,
}

impl Unit {
    /// The number alone.
    pub fn number(self, value: f64, digits: usize) -> String {
        significant(value / self.size, digits)
    }

    pub fn write(self, value: f64, digits: usize) -> String {
        let number = self.number(value, digits);
        if self.name.is_empty() { number } else { format!("{number} {}", self.name) }
    }

    /// ` [kN]`, or nothing.
    pub fn bracketed(self) -> String {
        if self.name.is_empty() { String::new() } else { format!(" [{}]", self.name) }
    }
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// What a number measures.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Kind {
            $($(#[$doc])* $name,)*
        }

        impl Kind {
            const ALL: &[Kind] = &[$(Kind::$name),*];
        }
    };
}

kinds! {
    /// A position, or a length along the beam \[m\].
    Position,
    /// w, u, a gap: what people read in millimetres \[m\].
    Deflection,
    /// A slope or a rotation \[rad\].
    Slope,
    /// A moment \[N·m\].
    Moment,
    /// A force \[N\].
    Force,
    /// Force per length \[N/m\].
    Pressure,
    /// EI \[N·m²\].
    BendingStiffness,
    /// k \[N/m²\].
    Spring,
    /// μ and P \[N\].
    Constant,
    /// k on an area: k over a width \[N/m³\].
    AreaSpring,
    /// μ on an area: μ over a width \[N/m\].
    AreaShear,
    /// Force per area \[Pa\].
    Stress,
    /// A curvature, or a wave number \[1/m\].
    PerLength,
}

impl Kind {
    /// What a field measures.
    pub fn of(field: Field) -> Self {
        match field.dimension() {
            Dimension::Length => Kind::Deflection,
            Dimension::Angle => Kind::Slope,
            Dimension::Moment => Kind::Moment,
            Dimension::Force => Kind::Force,
            Dimension::ForcePerLength => Kind::Pressure,
        }
    }

    /// Of this size is what people look at; it gives nothing at all its unit.
    fn usual(self) -> f64 {
        match self {
            Kind::Deflection | Kind::Slope => 1e-3,
            Kind::Moment | Kind::Force | Kind::Pressure => 1e3,
            _ => 1.0,
        }
    }

    /// From the largest unit to the smallest; the last one serves everything below.
    fn ladder(self) -> &'static [Rung] {
        match self {
            Kind::Position => const { &[rung(0.0, 1.0, "m")] },
            // Engineers read settlements in millimetres, from hundredths to a metre.
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
            // Forces in kilonewtons, from 0.1 kN to 100 MN.
            Kind::Force => {
                const {
                    &[
                        rung(1e11, 1e9, "GN"),
                        rung(1e8, 1e6, "MN"),
                        rung(1e2, 1e3, "kN"),
                        rung(0.0, 1.0, "N"),
                    ]
                }
            }
            Kind::Moment => {
                const {
                    &[
                        rung(1e11, 1e9, "GN m"),
                        rung(1e8, 1e6, "MN m"),
                        rung(1e2, 1e3, "kN m"),
                        rung(0.0, 1.0, "N m"),
                    ]
                }
            }
            Kind::Pressure => {
                const {
                    &[
                        rung(1e11, 1e9, "GN/m"),
                        rung(1e8, 1e6, "MN/m"),
                        rung(1e2, 1e3, "kN/m"),
                        rung(0.0, 1.0, "N/m"),
                    ]
                }
            }
            Kind::BendingStiffness => {
                const {
                    &[
                        rung(1e9, 1e9, "GN m²"),
                        rung(1e6, 1e6, "MN m²"),
                        rung(1e3, 1e3, "kN m²"),
                        rung(0.0, 1.0, "N m²"),
                    ]
                }
            }
            Kind::Spring => {
                const {
                    &[
                        rung(1e9, 1e9, "GN/m²"),
                        rung(1e6, 1e6, "MN/m²"),
                        rung(1e3, 1e3, "kN/m²"),
                        rung(0.0, 1.0, "N/m²"),
                    ]
                }
            }
            Kind::Constant => {
                const {
                    &[
                        rung(1e9, 1e9, "GN"),
                        rung(1e6, 1e6, "MN"),
                        rung(1e3, 1e3, "kN"),
                        rung(0.0, 1.0, "N"),
                    ]
                }
            }
            Kind::AreaSpring => {
                const {
                    &[
                        rung(1e9, 1e9, "GN/m³"),
                        rung(1e6, 1e6, "MN/m³"),
                        rung(1e3, 1e3, "kN/m³"),
                        rung(0.0, 1.0, "N/m³"),
                    ]
                }
            }
            Kind::AreaShear => {
                const {
                    &[
                        rung(1e9, 1e9, "GN/m"),
                        rung(1e6, 1e6, "MN/m"),
                        rung(1e3, 1e3, "kN/m"),
                        rung(0.0, 1.0, "N/m"),
                    ]
                }
            }
            Kind::Stress => {
                const {
                    &[
                        rung(1e9, 1e9, "GPa"),
                        rung(1e7, 1e6, "MPa"),
                        rung(1e2, 1e3, "kPa"),
                        rung(0.0, 1.0, "Pa"),
                    ]
                }
            }
            Kind::PerLength => const { &[rung(0.0, 1.0, "1/m")] },
        }
    }
}

/// A unit and the smallest value it is used for.
struct Rung {
    from: f64,
    size: f64,
    name: &'static str,
}

const fn rung(from: f64, size: f64, name: &'static str) -> Rung {
    Rung { from, size, name }
}

const BARE: Rung = rung(0.0, 1.0, "");

/// The units of a time on a clock.
const TIMES: [&str; 3] = ["µs", "ms", "s"];

/// A time on a clock.
pub(crate) fn duration(seconds: f64) -> String {
    let [micro, milli, whole] = TIMES;
    if seconds < 1e-3 {
        format!("{:.0} {micro}", seconds * 1e6)
    } else if seconds < 1.0 {
        format!("{} {milli}", significant(seconds * 1e3, 2))
    } else {
        format!("{} {whole}", significant(seconds, 3))
    }
}

/// Every unit that may be written behind a number.
pub(crate) fn units() -> impl Iterator<Item = &'static str> {
    let of_quantities = Kind::ALL.iter().flat_map(|kind| kind.ladder().iter());
    of_quantities.map(|rung| rung.name).chain(TIMES)
}

/// Whether these words are a unit, or the first word of one; a moment may be one per radian.
pub(crate) fn is_unit(words: &str) -> bool {
    let words = words.strip_suffix("/rad").unwrap_or(words);
    units().any(|unit| unit == words || unit.split(' ').next() == Some(words))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_an_engineer_expects() {
        let cases = [
            (Kind::Force, 600e3, "600 kN"),
            (Kind::Force, -12.5, "-12.5 N"),
            (Kind::Force, 1.44e6, "1440 kN"),
            (Kind::Force, 2.5e8, "250 MN"),
            (Kind::Deflection, 2e-3, "2 mm"),
            (Kind::Deflection, 0.2, "200 mm"),
            (Kind::Deflection, 3e-13, "3e-13 m"),
            (Kind::BendingStiffness, 1.2e9, "1.2 GN m²"),
            (Kind::Spring, 40e6, "40 MN/m²"),
            (Kind::Constant, 9e6, "9 MN"),
            (Kind::Moment, 0.0, "0 kN m"),
        ];
        for (kind, value, text) in cases {
            assert_eq!(Units::Si.write(kind, value, 6), text);
        }
        assert_eq!(Units::Plain.write(Kind::Force, 600e3, 6), "600000");
    }
}
