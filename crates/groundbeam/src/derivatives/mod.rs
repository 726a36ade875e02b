//! Exact derivatives of results by the data of the model, from the contact problem linearised at its solution.
//!
//! With a(y, z; p) = F(z; p) for all z on the contact that the solution has, an output j(y; p) changes by
//!
//! dj/dp = ∂j/∂p − ∂a(y, λ)/∂p + ∂F(λ)/∂p,  where a(λ, z) = j(z) for all z:
//!
//! one solve of the same chain for each output, and then one integral of products of polynomials for each parameter.
//! `docs/derivatives.md` derives it.

mod change;
mod extreme;
mod field;
mod forward;
mod joint;
mod linearised;
mod names;
mod output;
mod parameter;
pub(crate) mod piece;
mod point;
mod product;
mod push;
mod topology;

use crate::existence::verdict::Verdict;
use crate::model::Load;
use crate::options::Method;
use crate::solution::field::Field as Quantity;
use crate::solution::fields::Side;
use crate::solution::solution::Solution;
use change::Change;
use linearised::Linearised;
use output::Functional;
pub use output::Output;
pub use parameter::{Domain, LoadNumber, Parameter, Property, SupportNumber};
use product::{Dual, Rate};
use push::Push;
use std::fmt;
pub use topology::{Condition, Nearest};

/// A value with its derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// The output.
    pub value: f64,
    /// Its derivative by each parameter, in their order; the unit is the output's over the parameter's.
    pub derivatives: Vec<f64>,
    /// Why these hold for small changes in one direction only, if they do.
    pub one_sided: Vec<OneSided>,
}

/// Why a derivative holds for small changes in one direction only.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum OneSided {
    /// Beam and ground are about to touch or to part somewhere: all derivatives change there.
    Contact(Nearest),
    /// What the parameter with this number moves stands where the output's dual field jumps: the output looks there,
    /// or the beam's stiffness jumps there. The derivative is that of a move to the right, where nothing else is seen
    /// from the output's side.
    Place {
        /// The parameter, counted from 0.
        parameter: usize,
        /// The position \[m\].
        at: f64,
    },
    /// The field is as large elsewhere.
    Rival {
        /// The other position \[m\].
        at: f64,
    },
}

impl OneSided {
    /// In words, positions with a unit behind them.
    pub fn in_words(&self, unit: &str) -> String {
        match *self {
            OneSided::Contact(Nearest { condition, at, margin }) => {
                let what = condition.in_words();
                format!(
                    "contact is about to change: {what} is nearly zero at x = {at}{unit} ({margin:.1e})"
                )
            }
            OneSided::Place { at, .. } => {
                format!(
                    "what moves stands at x = {at}{unit}, where the output tells the sides apart"
                )
            }
            OneSided::Rival { at } => format!("the field is as large at x = {at}{unit}"),
        }
    }
}

/// Why there is no derivative.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotDifferentiable {
    /// The solution is one of a method with a mesh.
    Method(Method),
    /// The solution is one of many.
    NotUnique,
    /// The model has no such number, or it is none that can be changed by itself.
    NoSuchParameter(Parameter),
    /// There is no such output.
    NoSuchOutput,
    /// μ = 0: a shear layer, however weak, makes other ground.
    NoShearLayer,
    /// Loads on the ground: how far it settles under them is not derived by its constants.
    GroundUnderLoads,
}

impl fmt::Display for NotDifferentiable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotDifferentiable::Method(method) => write!(
                f,
                "derivatives are those of the exact method's solutions, and this one is of `{}`",
                method.name()
            ),
            NotDifferentiable::NotUnique => {
                f.write_str("the equilibrium is one of many, and has no derivatives")
            }
            NotDifferentiable::NoSuchParameter(parameter) => {
                write!(f, "the model has no number {parameter:?} of its own")
            }
            NotDifferentiable::NoSuchOutput => f.write_str("the solution has no such output"),
            NotDifferentiable::NoShearLayer => f.write_str(
                "the ground has no shear layer, and even a weak one changes it: derive by mu where it is positive",
            ),
            NotDifferentiable::GroundUnderLoads => f.write_str(
                "loads act on the ground: outputs are not derived by the ground's constants, energies by nothing",
            ),
        }
    }
}

impl std::error::Error for NotDifferentiable {}

/// Parameters closer to a change of contact than this have one-sided derivatives.
pub const CLOSE: f64 = 1e-6;

impl Solution {
    /// Derivatives of outputs by parameters: one gradient for each output. Each output costs about as much as a step of
    /// the solver, each parameter hardly anything.
    ///
    /// ```
    /// use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, Side, solve};
    /// use groundbeam::derivatives::{Domain, Output, Parameter, Property};
    ///
    /// let model = Model::new(Beam::uniform(1.0, 1.0), Foundation::pasternak(1.0, 1.0))
    ///     .with_load(Load::point_force(0.5, 1.0))
    ///     .with_load(Load::point_moment(0.5, 0.49));
    /// let Outcome::Equilibrium(solution) = solve(&model)? else { panic!("it tips") };
    /// let by_k = Parameter::Value(Property::Spring, Domain::Whole);
    /// let edge = solution.gradients(&[Output::Edge(0, Side::Left)], &[by_k])?;
    /// // On stiffer ground less of the beam touches.
    /// assert!(edge[0].derivatives[0] > 0.0 && edge[0].one_sided.is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`NotDifferentiable`], for solutions of other methods than [`Method::Exact`] and for what the model does not have.
    pub fn gradients(
        &self,
        outputs: &[Output],
        parameters: &[Parameter],
    ) -> Result<Vec<Gradient>, NotDifferentiable> {
        let (lin, changes) = self.linearised(outputs, parameters)?;
        let nearest = self.nearest_change_in(&lin);
        let gradient = |output: &Output| {
            let derived = self.derived(&lin, *output, &changes)?;
            let mut one_sided = Vec::new();
            one_sided.extend(nearest.filter(|near| near.margin < CLOSE).map(OneSided::Contact));
            one_sided.extend(derived.rival.map(|at| OneSided::Rival { at }));
            for (parameter, rate) in derived.rates.iter().enumerate() {
                one_sided.extend(rate.jumps_at.map(|at| OneSided::Place { parameter, at }));
            }
            let derivatives = derived.rates.iter().map(|rate| rate.value + 0.0).collect();
            Ok(Gradient { value: derived.value, derivatives, one_sided })
        };
        outputs.iter().map(gradient).collect()
    }

    /// The same forward: the answer of beam and ground to one parameter at a time, read off at all outputs. It is the
    /// way to go for many outputs and few parameters, and the check of [`Self::gradients`]. One row for each parameter.
    ///
    /// # Errors
    ///
    /// As [`Self::gradients`].
    pub fn responses(
        &self,
        outputs: &[Output],
        parameters: &[Parameter],
    ) -> Result<Vec<Vec<f64>>, NotDifferentiable> {
        let (lin, changes) = self.linearised(outputs, parameters)?;
        self.forward(&lin, outputs, &changes)
    }

    /// How near beam and ground are to touching or parting somewhere else: the least of all forces, pressures,
    /// clearances and lengths that a change of contact would bring to zero. None of a beam that has none.
    ///
    /// # Errors
    ///
    /// As [`Self::gradients`].
    pub fn nearest_change(&self) -> Result<Option<Nearest>, NotDifferentiable> {
        let (lin, _) = self.linearised(&[], &[])?;
        Ok(self.nearest_change_in(&lin))
    }

    fn linearised(
        &self,
        outputs: &[Output],
        parameters: &[Parameter],
    ) -> Result<(Linearised, Vec<Change>), NotDifferentiable> {
        if self.method() != Method::Exact {
            return Err(NotDifferentiable::Method(self.method()));
        }
        let many = matches!(self.existence().verdict, Verdict::NotUnique(_));
        let lin = Linearised::at(self, &self.places(outputs)).filter(|_| !many);
        let lin = lin.ok_or(NotDifferentiable::NotUnique)?;
        let change = |parameter: &Parameter| {
            let value = parameter.value(self.model());
            let value = value.ok_or(NotDifferentiable::NoSuchParameter(*parameter))?;
            if matches!(parameter, Parameter::Value(Property::Shear, _)) && value == 0.0 {
                return Err(NotDifferentiable::NoShearLayer);
            }
            let change = Change::of(&lin, self.acting(*parameter));
            let energy = outputs.contains(&Output::PotentialEnergy);
            if self.model().loads.iter().any(Load::is_on_ground)
                && (change.is_of_ground() || energy)
            {
                return Err(NotDifferentiable::GroundUnderLoads);
            }
            Ok(change)
        };
        let changes = parameters.iter().map(change).collect::<Result<_, _>>()?;
        Ok((lin, changes))
    }

    /// The parameter in the model on the supports that act.
    fn acting(&self, parameter: Parameter) -> Parameter {
        match parameter {
            Parameter::Support(i, number) => {
                Parameter::Support(self.number_among_acting(i).unwrap_or(usize::MAX), number)
            }
            other => other,
        }
    }

    fn number_among_acting(&self, i: usize) -> Option<usize> {
        let acts =
            |i: usize| !self.model().supports[i].is_one_way() || self.reactions()[i].force != 0.0;
        acts(i).then(|| (0..i).filter(|i| acts(*i)).count())
    }

    /// Where outputs look at the beam.
    fn places(&self, outputs: &[Output]) -> Vec<f64> {
        let l = self.model().beam.length;
        let place = |output: &Output| match *output {
            Output::Value(_, x, _) => Some(x.clamp(0.0, l)),
            Output::Smallest(field) => Some(self.extreme(field, false).x),
            Output::Largest(field) => Some(self.extreme(field, true).x),
            _ => None,
        };
        outputs.iter().filter_map(place).collect()
    }

    /// An output's value and its derivatives.
    fn derived(
        &self,
        lin: &Linearised,
        output: Output,
        changes: &[Change],
    ) -> Result<Derived, NotDifferentiable> {
        if output == Output::PotentialEnergy {
            return Ok(self.energy(lin, changes));
        }
        let (functional, value) = self.functional(lin, output)?;
        let mut derived = Derived { value, ..Derived::default() };
        derived.rates = self.rates(lin, &functional, changes)?;
        if let Output::Edge(region, side) = output {
            for (rate, change) in derived.rates.iter_mut().zip(changes) {
                rate.value += self.edge_follows(lin, region, side, change);
            }
        }
        if let Output::Smallest(field) | Output::Largest(field) = output {
            let place = self.extreme(field, matches!(output, Output::Largest(_)));
            derived.rival = place.rival;
            for (i, moved) in self.moves(lin, &place, changes)?.into_iter().enumerate() {
                let rate = &mut derived.rates[i];
                rate.value += place.slope * moved;
                // What the place follows it does not lose sight of.
                if lin.follows(&place, &changes[i]) != 0.0 {
                    rate.jumps_at = None;
                } else if let Some(x) = lin.leaves_others(field, &place, &changes[i]) {
                    rate.jumps_at = Some(x);
                }
            }
        }
        Ok(derived)
    }

    /// How far an edge of contact goes with a load that moves.
    fn edge_follows(&self, lin: &Linearised, region: usize, side: Side, change: &Change) -> f64 {
        let Some(region) = self.contact().get(region) else { return 0.0 };
        let x = if side == Side::Left { region.from } else { region.to };
        lin.zone_at(x, side).map_or(0.0, |zone| lin.edge_moves(zone, side, change))
    }

    /// An output as a functional, and its value.
    fn functional(
        &self,
        lin: &Linearised,
        output: Output,
    ) -> Result<(Functional, f64), NotDifferentiable> {
        let none = NotDifferentiable::NoSuchOutput;
        let l = self.model().beam.length;
        Ok(match output {
            Output::Value(field, x, side) if (0.0..=l).contains(&x) => {
                (lin.field_at(field, x, side), self.at(x, side).get(field))
            }
            Output::Value(..) => return Err(none),
            Output::Smallest(field) | Output::Largest(field) => {
                let place = self.extreme(field, matches!(output, Output::Largest(_)));
                let functional = match place.always {
                    true => Functional::default(),
                    false => lin.field_at(field, place.x, place.side),
                };
                (functional, place.value)
            }
            Output::Edge(region, side) => {
                let region = self.contact().get(region).ok_or(none)?;
                let x = if side == Side::Left { region.from } else { region.to };
                let zone = lin.zone_at(x, side).ok_or(none)?;
                (lin.edge(zone, side), x)
            }
            Output::EndForce(side) => {
                let ends = self.end_forces();
                let value = if side == Side::Left { ends.left } else { ends.right };
                (lin.end_force(side), value)
            }
            Output::SupportForce(i) | Output::SupportMoment(i) => {
                let moment = matches!(output, Output::SupportMoment(_));
                let reaction = self.reactions().get(i).ok_or(none)?;
                let acting = self.number_among_acting(i);
                let functional = acting.map(|i| lin.support(i, moment)).unwrap_or_default();
                (functional, if moment { reaction.moment } else { reaction.force })
            }
            Output::PotentialEnergy => (Functional::default(), self.certificate().primal_energy()),
        })
    }

    /// The derivatives of a functional.
    fn rates(
        &self,
        lin: &Linearised,
        functional: &Functional,
        changes: &[Change],
    ) -> Result<Vec<Rate>, NotDifferentiable> {
        if functional.push.is_empty() {
            let direct = |change| Rate { value: lin.direct(functional, change), jumps_at: None };
            return Ok(changes.iter().map(direct).collect());
        }
        let field = lin.answer(&functional.push).map_err(|_| NotDifferentiable::NotUnique)?;
        let dual =
            Dual { field: &field, push: &functional.push, looks: functional.looks, energy: false };
        let rate = |change: &Change| {
            let mut rate = match lin.settlement_of_rigid(change) {
                // The reaction of a dual field would be a difference of what the ends of two stiff elements bear.
                Some(_) => Rate { value: lin.answer_of(functional, change)?, jumps_at: None },
                None => lin.rate(change, &dual),
            };
            rate.value += lin.direct(functional, change);
            Ok(rate)
        };
        changes.iter().map(rate).collect()
    }

    /// The envelope theorem: ∂ of the energy at the solution, which is minus its own dual field.
    fn energy(&self, lin: &Linearised, changes: &[Change]) -> Derived {
        let field = lin.state.negated();
        let push = Push::default();
        let dual = Dual { field: &field, push: &push, looks: None, energy: true };
        let rate = |change: &Change| {
            let mut rate = lin.rate(change, &dual);
            if let Some(settled) = lin.settlement_of_rigid(change) {
                let reaction = self.reactions().iter().find(|r| r.at == settled);
                rate.value = -reaction.map_or(0.0, |reaction| reaction.force);
            }
            rate
        };
        Derived {
            value: self.certificate().primal_energy(),
            rates: changes.iter().map(rate).collect(),
            rival: None,
        }
    }
}

/// An output's value, its derivatives, and where else it is as large.
#[derive(Debug, Clone, Default)]
struct Derived {
    value: f64,
    rates: Vec<Rate>,
    rival: Option<f64>,
}
