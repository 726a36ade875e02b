//! Scaling of length and force by powers of two, so that the length of the beam and the largest load lie in [1, 2).
//!
//! Scaling by a power of two is exact. So a factor 2ⁿ on all forces or all lengths of a model leaves the proof
//! unchanged.

use crate::model::{Action, Extent, Load, Model, SupportKind};
use crate::refusal::NotProven;
use crate::scalar::Scalar;

/// The units of the proof. The unit of length is 2ⁿ m and the unit of force 2ᵐ N, with the integers n = `length` and m
/// = `force`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Units {
    pub length: i32,
    pub force: i32,
}

impl Units {
    /// Chooses the units such that the length and the largest load lie in [1, 2).
    pub fn of<S: Scalar>(model: &Model<S>) -> Result<Self, NotProven> {
        let length = exponent(model.beam.length).ok_or_else(|| {
            NotProven::new("the length of the beam is not between 1e-290 m and 1e290 m")
        })?;
        let in_length = Units { length, force: 0 };
        let stiffness =
            exponent(in_length.of_power(model.beam.bending_stiffness, 2)).ok_or_else(|| {
                NotProven::new(
                    "EI, divided by the square of the length, is not between 1e-290 N and 1e290 N",
                )
            })?;
        let mut force = None;
        for load in &model.loads {
            larger(&mut force, exponent(in_length.load_as_force(load, stiffness)));
        }
        for support in &model.supports {
            let settlement = in_length.of_power(support.settlement, 1);
            let felt = match support.kind {
                SupportKind::Spring { spring, .. } => in_length.of_power(spring, -1) * settlement,
                SupportKind::Pinned | SupportKind::Fixed => settlement.scaled(stiffness),
            };
            larger(&mut force, exponent(felt));
        }
        Ok(Units { length, force: force.unwrap_or(stiffness) })
    }

    /// Converts a load to a force, so that loads of different kinds can be compared. `stiffness` is the binary exponent
    /// of EI/l² with the unit of length l.
    fn load_as_force<S: Scalar>(self, load: &Load<S>, stiffness: i32) -> S {
        let (size, spread) = match load.extent {
            Extent::Point { size, .. } => (size, 0),
            Extent::Distributed { start, end, .. } => {
                (if start.size() >= end.size() { start } else { end }, 1)
            }
        };
        match load.action {
            Action::Force => self.of_power(size, -spread),
            Action::Moment => self.of_power(size, 1 - spread),
            Action::Curvature => self.of_power(size, -1).scaled(stiffness),
        }
    }

    /// Converts a number from the unit m^`length` to the units of the proof.
    fn of_power<S: Scalar>(self, x: S, length: i32) -> S {
        x.scaled(-length * self.length)
    }

    /// Converts a number from the unit N^`force` · m^`length` to the units of the proof.
    pub fn scaled<S: Scalar>(self, x: S, force: i32, length: i32) -> S {
        x.scaled(-force * self.force - length * self.length)
    }

    /// Converts a length to the units of the proof.
    pub fn metres<S: Scalar>(self, x: S) -> S {
        self.scaled(x, 0, 1)
    }

    /// Converts a bound from the units of the proof to the unit N^`force` · m^`length`, and rounds it up.
    pub fn restored(self, x: f64, force: i32, length: i32) -> f64 {
        let shift = force * self.force + length * self.length;
        let back = f64::scaled(x, shift);
        if x == 0.0 {
            0.0
        } else if back.abs() >= 1e-290 {
            back
        } else {
            1e-290
        }
    }
}

/// Returns the exponent n with 2ⁿ ≤ |x| < 2ⁿ⁺¹; `None` if |x| is not between 1e-290 and 1e290.
fn exponent<S: Scalar>(x: S) -> Option<i32> {
    let x = x.middle().abs();
    (1e-290..=1e290).contains(&x).then(|| (x.to_bits() >> 52) as i32 - 1023)
}

fn larger(most: &mut Option<i32>, exponent: Option<i32>) {
    if let Some(exponent) = exponent {
        *most =
            Some(most.map_or(exponent, |most: i32| if most >= exponent { most } else { exponent }));
    }
}

#[cfg(test)]
mod tests {
    use super::Units;
    use crate::float::power_of_two;
    use crate::read::read_model;
    use crate::wide::Wide;

    /// Checks the units for each kind of load and settlement on a beam of length 1.5. The lengths have the factor 2ᵃ
    /// and the forces the factor 2ᵇ.
    #[test]
    fn the_units_follow_the_lengths_and_the_largest_load() {
        // Start of a load or support table, exponents of N and m in the unit of its value, and expected binary exponent
        // of the unit of force for a = b = 0.
        let tables = [
            ("", [0, 0], 2),
            ("[[load]]\nat = 0\npoint = ", [1, 0], 1),
            ("[[load]]\nat = 0\nmoment = ", [1, 1], 1),
            ("[[load]]\ndistributed = ", [1, -1], 1),
            ("[[load]]\ndistributed_moment = ", [1, 0], 1),
            ("[[load]]\ncurvature = ", [0, -1], 3),
            ("[[support]]\nat = 0\ntype = 'pinned'\nsettlement = ", [0, 1], 3),
            ("[[support]]\nat = 0\ntype = 'fixed'\nsettlement = ", [0, 1], 3),
            ("[[support]]\nat = 0\nspring = SPRING\nsettlement = ", [0, 1], 4),
        ];
        for [a, b] in [[0, 0], [5, 0], [0, 5], [-9, 4], [12, -30]] {
            let scaled = |x: f64, [force, length]: [i32; 2]| {
                format!("{:?}", x * power_of_two(force * b + length * a))
            };
            for (table, unit, exponent) in tables {
                let beam = format!(
                    "[beam]\nlength = {}\nEI = {}\n[foundation]\nk = 1\n",
                    scaled(1.5, [0, 1]),
                    scaled(4.0, [1, 2])
                );
                let number = if table.is_empty() { String::new() } else { scaled(3.0, unit) };
                let spring = scaled(7.0, [1, -1]);
                let text = beam + &table.replace("SPRING", &spring) + &number;
                let model = read_model::<Wide>(&text, None).expect("a model");
                let found = Units::of(&model).expect("units");
                assert_eq!(found, Units { length: a, force: b + exponent }, "{text}");
            }
        }
    }
}
