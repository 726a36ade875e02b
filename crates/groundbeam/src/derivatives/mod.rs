//! Computes exact derivatives of results with respect to model data by linearising the contact problem at its solution.
//!
//! The equations are generic over the number type, so dual numbers give their derivatives. See `docs/derivatives.md`.

mod adjoint;
mod energy;
mod equilibrium;
mod evaluate;
mod extreme;
mod frame;
mod linear;
mod moved;
mod names;
mod output;
mod parameter;
mod tangent;
mod topology;

use crate::existence::verdict::Verdict;
use crate::options::Method;
use crate::solution::solution::Solution;
use equilibrium::Equilibrium;
use frame::Frame;
use linear::Linear;
pub use output::Output;
use output::Reading;
pub use parameter::{Domain, LoadNumber, Parameter, Property, SupportNumber};
use std::fmt;
use tangent::{Moved, Tangent};
pub use topology::{Condition, Nearest};

/// The value of an output, with its derivatives with respect to the parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradient {
    /// The value of the output, in its unit.
    pub value: f64,
    /// Derivatives of the output with respect to the parameters, in the order of the parameters. The unit is that of
    /// the output divided by that of the parameter.
    pub derivatives: Vec<f64>,
    /// Reasons why derivatives hold for small changes in one direction only; empty if they hold in both.
    pub one_sided: Vec<OneSided>,
}

/// Reason why a derivative holds for small changes in one direction only.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum OneSided {
    /// Beam and ground are about to touch or to separate at some position. All derivatives jump at this change of
    /// contact.
    Contact(Nearest),
    /// The derivative holds only for a move of a load to the right. The load acts at a hinge, at a jump of the beam's
    /// stiffness or at the position of the output.
    Place {
        /// Index of the parameter, from 0.
        parameter: usize,
        /// The position \[m\].
        at: f64,
    },
    /// The field has the same extreme value at another position.
    Rival {
        /// Position \[m\] of a second extreme, whose value equals that of the output.
        at: f64,
    },
}

impl OneSided {
    /// Returns a text that says why the derivative holds in one direction only. `unit` is written after each position.
    pub fn in_words(&self, unit: &str) -> String {
        match *self {
            OneSided::Contact(Nearest { condition, at, margin }) => {
                let what = condition.in_words();
                format!(
                    "contact is about to change: {what} is nearly zero at x = {at}{unit} (relative margin {margin:.1e})"
                )
            }
            OneSided::Place { at, .. } => {
                format!(
                    "the output has different left and right derivatives with respect to the position of the load \
                     at x = {at}{unit}"
                )
            }
            OneSided::Rival { at } => {
                format!("the field has another extreme of the same size at x = {at}{unit}")
            }
        }
    }
}

/// Reason why a result has no derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotDifferentiable {
    /// The solution was not computed by [`Method::Exact`].
    Method(Method),
    /// The equilibrium is not unique.
    NotUnique,
    /// The model does not have this parameter, or the parameter cannot be changed alone.
    NoSuchParameter(Parameter),
    /// The solution does not have the requested output.
    NoSuchOutput,
    /// The derivative with respect to μ does not exist at μ = 0, because even a weak shear layer changes the type of
    /// the ground.
    NoShearLayer,
}

impl fmt::Display for NotDifferentiable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotDifferentiable::Method(method) => write!(
                f,
                "derivatives need a solution of the exact method; this solution was computed by the method `{}`",
                method.name()
            ),
            NotDifferentiable::NotUnique => {
                f.write_str("the equilibrium is not unique, so its derivatives with respect to parameters do not exist")
            }
            NotDifferentiable::NoSuchParameter(parameter) => {
                write!(f, "the model has no parameter {parameter:?}")
            }
            NotDifferentiable::NoSuchOutput => f.write_str("the solution does not contain the requested output"),
            NotDifferentiable::NoShearLayer => f.write_str(
                "the ground has no shear layer: differentiate with respect to mu only where mu is positive",
            ),
        }
    }
}

impl std::error::Error for NotDifferentiable {}

/// If the relative margin of the nearest change of contact ([`Nearest::margin`]) is below this value, the derivatives
/// with respect to the parameters are reported as one-sided.
pub const CLOSE: f64 = 1e-6;

impl Solution {
    /// Computes the derivatives of outputs with respect to parameters, as one gradient for each output.
    ///
    /// ```
    /// use groundbeam::{Beam, Field, Foundation, Load, Model, Outcome, solve, solution::Side};
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
    /// Returns [`NotDifferentiable`] if the solution, an output or a parameter has no derivatives.
    pub fn gradients(
        &self,
        outputs: &[Output],
        parameters: &[Parameter],
    ) -> Result<Vec<Gradient>, NotDifferentiable> {
        let frame = self.linearised()?;
        let readings = readings(&frame, outputs)?;
        let Derivatives { rows, moved } = derivatives(&frame, &readings, parameters)?;
        let nearest = self.nearest_change_in(&frame).filter(|near| near.margin < CLOSE);
        let gradient = |(reading, derivatives): (&Reading, Vec<f64>)| {
            let mut one_sided = Vec::new();
            one_sided.extend(nearest.map(OneSided::Contact));
            one_sided.extend(reading.rival.map(|at| OneSided::Rival { at }));
            for (parameter, moved) in moved.iter().enumerate() {
                let moved = moved.filter(|moved| frame.is_one_sided(&reading.of, moved));
                one_sided.extend(moved.map(|moved| OneSided::Place { parameter, at: moved.x }));
            }
            Gradient { value: reading.value, derivatives, one_sided }
        };
        Ok(readings.iter().zip(rows).map(gradient).collect())
    }

    /// Computes the derivatives of [`Self::gradients`], as one list over all outputs for each parameter.
    ///
    /// # Errors
    ///
    /// The errors are those of [`Self::gradients`].
    pub fn responses(
        &self,
        outputs: &[Output],
        parameters: &[Parameter],
    ) -> Result<Vec<Vec<f64>>, NotDifferentiable> {
        let frame = self.linearised()?;
        let readings = readings(&frame, outputs)?;
        let Derivatives { rows, .. } = derivatives(&frame, &readings, parameters)?;
        let of = |p: usize| rows.iter().map(|row| row[p]).collect();
        Ok((0..parameters.len()).map(of).collect())
    }

    /// Finds the nearest change of contact, where a quantity of [`Condition`] becomes zero. Returns `None` if the
    /// solution has no such quantity.
    ///
    /// # Errors
    ///
    /// The errors are those of [`Self::gradients`].
    pub fn nearest_change(&self) -> Result<Option<Nearest>, NotDifferentiable> {
        let frame = self.linearised()?;
        Ok(self.nearest_change_in(&frame))
    }

    fn linearised(&self) -> Result<Frame<'_>, NotDifferentiable> {
        if self.method() != Method::Exact {
            return Err(NotDifferentiable::Method(self.method()));
        }
        if matches!(self.existence().verdict, Verdict::NotUnique(_)) {
            return Err(NotDifferentiable::NotUnique);
        }
        Ok(Frame::at(self))
    }
}

fn readings(frame: &Frame, outputs: &[Output]) -> Result<Vec<Reading>, NotDifferentiable> {
    let reading = |output: &Output| frame.reading(*output).ok_or(NotDifferentiable::NoSuchOutput);
    outputs.iter().map(reading).collect()
}

/// Computes the derivatives of all input values of the model, such as stiffnesses and loads, with respect to a
/// parameter.
fn tangent(frame: &Frame, parameter: Parameter) -> Result<Tangent, NotDifferentiable> {
    let model = frame.solution.model();
    let value = parameter.value(model).ok_or(NotDifferentiable::NoSuchParameter(parameter))?;
    if matches!(parameter, Parameter::Value(Property::Shear, _)) && value == 0.0 {
        return Err(NotDifferentiable::NoShearLayer);
    }
    let mut tangent = Tangent::of(parameter, model);
    let mut number = 0..;
    let acts = |i| frame.number_among_acting(i).is_some();
    tangent.model.supports.retain(|_| number.next().is_some_and(acts));
    Ok(tangent)
}

/// Derivatives of outputs with respect to parameters.
struct Derivatives {
    /// The derivatives with respect to all parameters, one row for each output.
    rows: Vec<Vec<f64>>,
    /// The load that each parameter moves; `None` for a parameter that moves no load.
    moved: Vec<Option<Moved>>,
}

fn derivatives(
    frame: &Frame,
    readings: &[Reading],
    parameters: &[Parameter],
) -> Result<Derivatives, NotDifferentiable> {
    match parameters.len() {
        0..=1 => derivatives_by::<1>(frame, readings, parameters),
        2..=4 => derivatives_by::<4>(frame, readings, parameters),
        // Dual numbers with more than 8 derivatives take longer than several passes with 8.
        _ => derivatives_by::<8>(frame, readings, parameters),
    }
}

/// Computes the derivatives of the outputs with respect to the parameters, for N parameters at a time, by dual numbers
/// with N derivatives.
fn derivatives_by<const N: usize>(
    frame: &Frame,
    readings: &[Reading],
    parameters: &[Parameter],
) -> Result<Derivatives, NotDifferentiable> {
    let mechanism = NotDifferentiable::NotUnique;
    let equilibrium = Equilibrium::at(frame).ok_or(mechanism)?;
    // The stiffness is symmetric, so a solve for each output gives the same derivatives as a solve for each
    // parameter. The code uses the variant with fewer solves.
    let adjoints = if readings.len() < parameters.len() {
        Some(equilibrium.adjoints(readings).ok_or(mechanism)?)
    } else {
        None
    };
    let read = equilibrium.read_by(readings);
    let mut linear = Linear::<N>::new(&equilibrium);
    let mut rows = vec![Vec::with_capacity(parameters.len()); readings.len()];
    let mut moved = Vec::with_capacity(parameters.len());
    for some in parameters.chunks(N) {
        let tangents = some.iter().map(|parameter| tangent(frame, *parameter));
        linear.vary(tangents.collect::<Result<_, _>>()?);
        moved.extend(linear.tangents.iter().map(|tangent| tangent.moved));
        let loads = linear.loads();
        if adjoints.is_none() {
            let along =
                |n: usize| loads.iter().map(move |(cell, load)| (*cell, load.map(|q| q.by[n])));
            let displaced = equilibrium.displaced((0..some.len()).map(|n| along(n).collect()));
            for (n, by) in displaced.ok_or(mechanism)?.iter().enumerate() {
                linear.displace(n, by);
            }
        }
        let changed = |i: &usize| adjoints.is_none() || linear.exact[*i].is_some();
        let changed: Vec<usize> = read.iter().copied().filter(changed).collect();
        linear.refresh(changed.into_iter());
        for (i, (row, reading)) in rows.iter_mut().zip(readings).enumerate() {
            let mut by = linear.read(reading);
            for (adjoint, (cell, load)) in
                adjoints.iter().flat_map(|all| loads.iter().map(|load| (&all[i], load)))
            {
                for (v, load) in adjoint[*cell].iter().zip(load) {
                    by.iter_mut().zip(load.by).for_each(|(by, load)| *by += v * load);
                }
            }
            // Adding zero turns −0 into 0.
            row.extend(by[..some.len()].iter().map(|by| by + 0.0));
        }
    }
    Ok(Derivatives { rows, moved })
}
