//! Reads which quantity a line of expected results names, and returns the value of this quantity in a solution.

use super::growth::Growth;
use super::scale::Kind;
use groundbeam::{
    Field, Solution,
    design::{Checked, LimitState},
    solution::{Dimension, Side},
};
use groundbeam_file::{UnitSystem, parse_positions};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Quantity {
    At(Field, f64, Side),
    Settlement(f64),
    Extreme {
        field: Field,
        largest: bool,
        position: bool,
    },
    Contact,
    EndForce(Side),
    Force(f64),
    Reaction(f64),
    ReactionMoment(f64),
    Energy,
    Verdict,
    StaticReaction(Side),
    FailingMotion,
    FailingWork,
    CriticalCompression,
    StabilityMargin,
    Growth(Growth),
    Governs {
        field: Field,
        largest: bool,
    },
    /// The utilisation of the limit of a check, with the limit state if the check belongs to one.
    Used(Checked, Option<LimitState>),
    /// Whether a check passes.
    Judged(Checked, Option<LimitState>),
}

impl Quantity {
    pub(super) fn read(name: &str, units: UnitSystem) -> Result<Quantity, String> {
        let unknown = || format!("`{name}` is not a known quantity");
        match name {
            "contact" => return Ok(Quantity::Contact),
            "energy" => return Ok(Quantity::Energy),
            "verdict" => return Ok(Quantity::Verdict),
            "failing_motion" => return Ok(Quantity::FailingMotion),
            "failing_work" => return Ok(Quantity::FailingWork),
            "critical_compression" => return Ok(Quantity::CriticalCompression),
            "stability_margin" => return Ok(Quantity::StabilityMargin),
            _ => {}
        }
        let (what, inside) =
            name.strip_suffix(')').and_then(|n| n.split_once('(')).ok_or_else(unknown)?;
        if let Some(growth) = Growth::read(what) {
            return Ok(Quantity::Growth(growth));
        }
        let side = || match inside {
            "left" => Ok(Side::Left),
            "right" => Ok(Side::Right),
            _ => Err(format!("`{inside}` is neither `left` nor `right`")),
        };
        let position = |text: &str| match parse_positions(text, units) {
            Ok(list) if list.len() == 1 => Ok(list[0]),
            _ => Err(format!("`{text}` is not a position")),
        };
        let extreme = |largest, position| {
            let field = Field::named(inside).ok_or_else(|| format!("`{inside}` is not a field"))?;
            Ok(Quantity::Extreme { field, largest, position })
        };
        match what {
            "end_force" => Ok(Quantity::EndForce(side()?)),
            "static_reaction" => Ok(Quantity::StaticReaction(side()?)),
            "max" => extreme(true, false),
            "min" => extreme(false, false),
            "position_of_max" => extreme(true, true),
            "position_of_min" => extreme(false, true),
            "governs_max" | "governs_min" => {
                let field =
                    Field::named(inside).ok_or_else(|| format!("`{inside}` is not a field"))?;
                Ok(Quantity::Governs { field, largest: what == "governs_max" })
            }
            "used" | "judged" => {
                let (name, state) = inside.split_once(", ").unwrap_or((inside, ""));
                let known = |what: &Checked| what.name().replace('-', "_") == name;
                let check = Checked::ALL.into_iter().find(known);
                let check = check.ok_or_else(|| format!("`{name}` is not a check"))?;
                let of = if what == "used" { Quantity::Used } else { Quantity::Judged };
                match LimitState::named(state) {
                    None if !state.is_empty() => Err(format!("`{state}` is not a limit state")),
                    state => Ok(of(check, state)),
                }
            }
            "force" => Ok(Quantity::Force(position(inside)?)),
            "reaction" => Ok(Quantity::Reaction(position(inside)?)),
            "reaction_moment" => Ok(Quantity::ReactionMoment(position(inside)?)),
            _ => {
                let field = Field::named(what).ok_or_else(unknown)?;
                let (side, text) = match (inside.strip_prefix("left of "), field) {
                    (Some(text), _) => (Side::Left, text),
                    // The settlement of the ground is also defined outside the beam.
                    (None, Field::Settlement) => {
                        return Ok(Quantity::Settlement(position(inside)?));
                    }
                    (None, _) => (Side::Right, inside.strip_prefix("right of ").unwrap_or(inside)),
                };
                Ok(Quantity::At(field, position(text)?, side))
            }
        }
    }

    /// Returns the dimension of the quantity; `None` for a verdict or the name of a combination.
    pub(super) fn kind(self) -> Option<Kind> {
        let of = |field: Field| match field.dimension() {
            Dimension::Length => Kind::Length,
            Dimension::Angle => Kind::Angle,
            Dimension::Moment => Kind::Moment,
            Dimension::Force => Kind::Force,
            Dimension::ForcePerLength => Kind::LineLoad,
        };
        Some(match self {
            Quantity::At(field, ..) => of(field),
            Quantity::Extreme { field, position: false, .. } => of(field),
            Quantity::Settlement(_) | Quantity::Extreme { .. } | Quantity::Contact => Kind::Length,
            Quantity::EndForce(_)
            | Quantity::StaticReaction(_)
            | Quantity::Force(_)
            | Quantity::Reaction(_) => Kind::Force,
            Quantity::ReactionMoment(_) | Quantity::Energy => Kind::Moment,
            Quantity::Growth(Growth::PositionOfLiftOff) => Kind::Length,
            Quantity::FailingMotion
            | Quantity::StabilityMargin
            | Quantity::Growth(_)
            | Quantity::Used(..) => Kind::Number,
            // The work of the loads on a rigid motion is given per metre of lift, so its dimension is that of a force.
            Quantity::FailingWork | Quantity::CriticalCompression => Kind::Force,
            Quantity::Verdict | Quantity::Governs { .. } | Quantity::Judged(..) => return None,
        })
    }

    pub(super) fn of(self, solution: &Solution) -> Result<Vec<f64>, String> {
        let support = |at: f64| {
            let found = solution.reactions().iter().find(|reaction| reaction.at == at);
            found.ok_or_else(|| "there is no support".to_owned())
        };
        Ok(match self {
            Quantity::At(field, x, side) => vec![solution.at(x, side).get(field)],
            Quantity::Settlement(x) => vec![solution.settlement(x)],
            Quantity::Extreme { field, largest, position } => {
                let range = solution.range(field);
                let extreme = if largest { range.max } else { range.min };
                vec![if position { extreme.x } else { extreme.value }]
            }
            Quantity::Contact => {
                solution.contact().iter().flat_map(|region| [region.from, region.to]).collect()
            }
            Quantity::EndForce(Side::Left) => vec![solution.end_forces().left],
            Quantity::EndForce(Side::Right) => vec![solution.end_forces().right],
            Quantity::Force(x) => {
                let near = 1e-9 * solution.model().beam.length;
                let forces = solution.concentrated_forces();
                let here = forces.iter().filter(|force| (force.at - x).abs() <= near);
                vec![here.map(|force| force.force).sum()]
            }
            Quantity::Reaction(x) => vec![support(x)?.force],
            Quantity::ReactionMoment(x) => vec![support(x)?.moment],
            Quantity::Energy => vec![solution.certificate().primal_energy()],
            Quantity::StaticReaction(_)
            | Quantity::FailingMotion
            | Quantity::FailingWork
            | Quantity::CriticalCompression
            | Quantity::StabilityMargin
            | Quantity::Growth(_)
            | Quantity::Governs { .. }
            | Quantity::Used(..)
            | Quantity::Judged(..)
            | Quantity::Verdict => Vec::new(),
        })
    }
}
