//! Computes the derivatives of a model's input values with respect to one parameter.
//!
//! The derivatives are stored as a model with the same parts. The derivative with respect to the position of a load is
//! represented by a moment and jumps at this position ([`Moved`]).

use super::parameter::{Domain, LoadNumber, Parameter, Property, change, courses, set_load};
use crate::model::{Action, Extent, Load, Model, SupportKind};

/// The derivatives of a model's input values with respect to one parameter.
#[derive(Debug, Clone)]
pub(super) struct Tangent {
    pub model: Model,
    /// Interval of the beam outside which the derivatives of the stiffnesses of beam and ground, of the initial gap and
    /// of distributed loads are zero.
    pub reach: [f64; 2],
    /// The load whose position is the parameter.
    pub moved: Option<Moved>,
}

/// A point load, or an end of a distributed load, whose position is the parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moved {
    /// Position of the point load or of the load's end \[m\].
    pub x: f64,
    pub what: Motion,
}

/// Kind and size of the load that moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Motion {
    /// A point force. If it moves by δ, M on its right changes by δ times the jump of V. With shear deformation, w on
    /// its right changes by δ times the jump of w'.
    Force(f64),
    /// A point moment. If it moves by δ, the rotation φ on its right changes by δ times the jump of φ′ at the moment.
    Moment(f64),
    /// A force per length at the moving end of a distributed force, with a negative sign for the left end. A
    /// displacement δ of the end adds a point force of δ times this value.
    ForcePerLength(f64),
    /// A moment per length at the moving end of a distributed moment, with a negative sign for the left end. A
    /// displacement δ of the end adds a point moment of δ times this value.
    MomentPerLength(f64),
    /// An imposed curvature at the moving end of its interval, with a negative sign for the left end. If the end moves
    /// by δ, the rotation φ jumps at the end by δ times this value.
    Curvature(f64),
}

impl Tangent {
    /// Computes the derivatives of a model's input values with respect to a parameter of this model.
    pub fn of(parameter: Parameter, model: &Model) -> Self {
        let mut reach = [0.0, model.beam.length];
        if let Parameter::Value(property, Domain::Segment(i))
        | Parameter::Factor(property, Domain::Segment(i)) = parameter
        {
            reach = match property {
                Property::Spring | Property::Shear => {
                    let segment = &model.foundation.segments[i];
                    [segment.from, segment.to]
                }
                _ => [model.beam.segments[i].from, model.beam.segments[i].to],
            };
        }
        let mut tangent = Tangent { model: without_numbers(model), reach, moved: None };
        let rates = &mut tangent.model;
        match parameter {
            Parameter::Value(property, domain) => change(rates, property, domain, |_| 1.0.into()),
            Parameter::Factor(property, domain) => {
                let mut own = courses(model, property, domain);
                change(rates, property, domain, |zero| own.next().unwrap_or(zero));
            }
            Parameter::LoadFactor => rates.loads.clone_from(&model.loads),
            Parameter::Load(i, number) => tangent.add_load(i, &model.loads[i], number),
            number => {
                number.assign_number(rates, 1.0);
            }
        }
        tangent
    }

    fn add_load(&mut self, i: usize, load: &Load, number: LoadNumber) {
        let moves = matches!(number, LoadNumber::At | LoadNumber::From | LoadNumber::To);
        if !moves {
            set_load(&mut self.model.loads[i], number, 1.0);
            return;
        }
        match load.extent {
            Extent::Point { at, size } => {
                let what = match load.action {
                    Action::Moment => Motion::Moment(size),
                    _ => Motion::Force(size),
                };
                self.moved = Some(Moved { x: at, what });
            }
            Extent::Distributed { from, to, start, end } => {
                // At a fixed x, the ratio (x − from)/(to − from) decreases if `from` or `to` moves to the right.
                let rise = (end - start) / (to - from);
                let (x, size) = if number == LoadNumber::From { (from, -start) } else { (to, end) };
                let changed =
                    if number == LoadNumber::From { LoadNumber::Start } else { LoadNumber::End };
                set_load(&mut self.model.loads[i], changed, -rise);
                let what = match load.action {
                    Action::Force => {
                        self.model.loads.push(Load::point_force(x, size));
                        Motion::ForcePerLength(size)
                    }
                    Action::Moment => Motion::MomentPerLength(size),
                    Action::Curvature => Motion::Curvature(size),
                };
                self.moved = Some(Moved { x, what });
            }
        }
    }
}

/// Returns a model with the same parts at the same positions as `model`. All its numbers are 0.
fn without_numbers(model: &Model) -> Model {
    let mut zero = model.clone().with_loads_scaled(0.0);
    let beam = zero.beam.stiffened(0.0);
    zero.beam = beam.with_axial_force(0.0);
    zero.foundation = zero.foundation.scaled(0.0, 0.0);
    for support in &mut zero.supports {
        support.settlement = 0.0;
        if let SupportKind::Spring { spring, rotational_spring } = &mut support.kind {
            (*spring, *rotational_spring) = (0.0, 0.0);
        }
    }
    zero.hinges.iter_mut().for_each(|hinge| hinge.rotational_spring = 0.0);
    zero.gap.iter_mut().for_each(|corner| corner.value = 0.0);
    zero
}
