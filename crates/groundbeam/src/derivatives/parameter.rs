//! Parameters: the numbers of a model with respect to which outputs are differentiated.

use crate::model::Extent;
use crate::model::{Load, Model};

/// A stiffness of the beam or the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Property {
    /// Bending stiffness EI \[N·m²\].
    BendingStiffness,
    /// Shear stiffness S = κGA of a beam with shear deformation \[N\].
    ShearStiffness,
    /// Subgrade stiffness k of the ground \[N/m²\].
    Spring,
    /// Shear-layer stiffness μ of the ground \[N\].
    Shear,
}

/// The part of the beam or of the ground on which a parameter changes a property.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Domain {
    /// On all segments and outside them.
    Whole,
    /// Outside all segments: the model's own value.
    OutsideSegments,
    /// On one segment, counted from 0. A ground segment at an end of the beam continues outside the beam.
    Segment(usize),
}

/// A number of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LoadNumber {
    /// Force \[N, N/m\], moment \[N·m, N·m/m\] or curvature \[1/m\]; for a distributed load, the value at both ends if
    /// they are equal.
    Size,
    /// The position of a point load \[m\].
    At,
    /// The left end of a distributed load \[m\].
    From,
    /// The right end of a distributed load \[m\].
    To,
    /// The value of a distributed load at its left end.
    Start,
    /// The value of a distributed load at its right end.
    End,
}

/// A number of a support.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SupportNumber {
    /// Its settlement \[m\].
    Settlement,
    /// Its spring constant \[N/m\].
    Spring,
    /// Its rotational spring constant \[N·m/rad\].
    RotationalSpring,
}

/// A number of a model. Parts are counted from 0, in the order of the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Parameter {
    /// The value of a property where it is constant. With `Whole`, no segment may define it.
    Value(Property, Domain),
    /// A factor on a property; its current value is 1.
    Factor(Property, Domain),
    /// Axial force P \[N\], positive in tension.
    AxialForce,
    /// A number of one load.
    Load(usize, LoadNumber),
    /// A factor on all loads; its current value is 1.
    LoadFactor,
    /// A number of one support.
    Support(usize, SupportNumber),
    /// The rotational spring constant of one hinge \[N·m/rad\].
    HingeSpring(usize),
    /// The initial gap at one point of the gap profile \[m\].
    Gap(usize),
}

impl Parameter {
    /// Whether the parameter is the value of k or μ, or a factor on k or μ.
    pub fn is_of_ground(self) -> bool {
        use Property::{Shear, Spring};
        matches!(self, Parameter::Value(Spring | Shear, _) | Parameter::Factor(Spring | Shear, _))
    }

    /// Value of the number in the model; `None` if the model does not have it.
    pub fn value(self, model: &Model) -> Option<f64> {
        match self {
            Parameter::Value(property, domain) => constant(model, property, domain),
            Parameter::Factor(property, domain) if !has(model, property, domain) => None,
            Parameter::Factor(..) | Parameter::LoadFactor => Some(1.0),
            Parameter::AxialForce => Some(model.beam.axial_force),
            Parameter::Load(i, number) => of_load(model.loads.get(i)?, number),
            Parameter::Support(i, number) => {
                let support = model.supports.get(i)?;
                match (number, support.kind) {
                    (SupportNumber::Settlement, _) => Some(support.settlement),
                    (SupportNumber::Spring, crate::SupportKind::Spring { spring, .. }) => {
                        Some(spring)
                    }
                    (
                        SupportNumber::RotationalSpring,
                        crate::SupportKind::Spring { rotational_spring, .. },
                    ) => Some(rotational_spring),
                    _ => None,
                }
            }
            Parameter::HingeSpring(i) => Some(model.hinges.get(i)?.rotational_spring),
            Parameter::Gap(i) => Some(model.gap.get(i)?.value),
        }
    }

    /// The model with the number set to `to`; `None` if the model does not have the number.
    pub fn set(self, model: &Model, to: f64) -> Option<Model> {
        let mut model = model.clone();
        self.assign(&mut model, to).then_some(model)
    }

    /// Sets the number in a model. Returns whether the model has the number.
    pub fn assign(self, model: &mut Model, to: f64) -> bool {
        self.value(model).is_some() && self.assigned(model, to).is_some()
    }

    fn assigned(self, model: &mut Model, to: f64) -> Option<()> {
        match self {
            Parameter::Value(property, domain) => set_property(model, property, domain, to),
            Parameter::Factor(property, domain) => scale(model, property, domain, to),
            Parameter::LoadFactor => {
                for load in &mut model.loads {
                    *load = load.scaled(to);
                }
            }
            Parameter::AxialForce => model.beam.axial_force = to,
            Parameter::Load(i, number) => set_load(model.loads.get_mut(i)?, number, to),
            Parameter::Support(i, number) => {
                let support = model.supports.get_mut(i)?;
                match (number, &mut support.kind) {
                    (SupportNumber::Settlement, _) => support.settlement = to,
                    (SupportNumber::Spring, crate::SupportKind::Spring { spring, .. }) => {
                        *spring = to;
                    }
                    (
                        SupportNumber::RotationalSpring,
                        crate::SupportKind::Spring { rotational_spring, .. },
                    ) => *rotational_spring = to,
                    _ => return None,
                }
            }
            Parameter::HingeSpring(i) => model.hinges.get_mut(i)?.rotational_spring = to,
            Parameter::Gap(i) => model.gap.get_mut(i)?.value = to,
        }
        Some(())
    }
}

/// Whether the model has a property on a domain.
fn has(model: &Model, property: Property, domain: Domain) -> bool {
    let beam = &model.beam;
    match (property, domain) {
        (Property::BendingStiffness, Domain::Segment(i)) => i < beam.segments.len(),
        (Property::ShearStiffness, Domain::Segment(i)) => {
            beam.segments.get(i).is_some_and(|segment| segment.shear_stiffness.is_some())
        }
        (Property::ShearStiffness, Domain::OutsideSegments) => beam.shear_stiffness.is_some(),
        (Property::ShearStiffness, Domain::Whole) => beam.shears(),
        (_, Domain::Segment(i)) => i < model.foundation.segments.len(),
        _ => true,
    }
}

/// The value of a property on a domain; `None` if it varies there.
fn constant(model: &Model, property: Property, domain: Domain) -> Option<f64> {
    let (beam, ground) = (&model.beam, &model.foundation);
    let (own, profile) = match property {
        Property::BendingStiffness => {
            (beam.bending_stiffness, beam.segments.iter().map(|s| s.bending_stiffness).collect())
        }
        Property::ShearStiffness => {
            let own = beam.segments.iter().filter_map(|s| s.shear_stiffness);
            match domain {
                Domain::Segment(i) => {
                    let profile = beam.segments.get(i)?.shear_stiffness?;
                    return profile.is_constant().then(|| profile.start());
                }
                Domain::Whole | Domain::OutsideSegments => (beam.shear_stiffness?, own.collect()),
            }
        }
        Property::Spring => {
            (ground.subgrade, ground.segments.iter().map(|s| s.subgrade).collect::<Vec<_>>())
        }
        Property::Shear => {
            (ground.shear_layer, ground.segments.iter().map(|s| s.shear_layer).collect())
        }
    };
    match domain {
        Domain::Whole => profile.is_empty().then_some(own),
        Domain::OutsideSegments => Some(own),
        Domain::Segment(i) => {
            profile.get(i).filter(|profile| profile.is_constant()).map(|profile| profile.start())
        }
    }
}

pub(super) fn set_property(model: &mut Model, property: Property, domain: Domain, to: f64) {
    let (beam, ground) = (&mut model.beam, &mut model.foundation);
    match (property, domain) {
        (Property::BendingStiffness, Domain::Segment(i)) => {
            if let Some(segment) = beam.segments.get_mut(i) {
                segment.bending_stiffness = to.into();
            }
        }
        (Property::ShearStiffness, Domain::Segment(i)) => {
            if let Some(segment) = beam.segments.get_mut(i) {
                segment.shear_stiffness = Some(to.into());
            }
        }
        (Property::Spring, Domain::Segment(i)) => {
            if let Some(segment) = ground.segments.get_mut(i) {
                segment.subgrade = to.into();
            }
        }
        (Property::Shear, Domain::Segment(i)) => {
            if let Some(segment) = ground.segments.get_mut(i) {
                segment.shear_layer = to.into();
            }
        }
        (Property::BendingStiffness, _) => beam.bending_stiffness = to,
        (Property::ShearStiffness, _) => beam.shear_stiffness = Some(to),
        (Property::Spring, _) => ground.subgrade = to,
        (Property::Shear, _) => ground.shear_layer = to,
    }
}

fn scale(model: &mut Model, property: Property, domain: Domain, factor: f64) {
    let (beam, ground) = (&mut model.beam, &mut model.foundation);
    if !matches!(domain, Domain::Segment(_)) {
        match property {
            Property::BendingStiffness => beam.bending_stiffness *= factor,
            Property::ShearStiffness => {
                beam.shear_stiffness = beam.shear_stiffness.map(|own| own * factor);
            }
            Property::Spring => ground.subgrade *= factor,
            Property::Shear => ground.shear_layer *= factor,
        }
    }
    let meant = |i: usize| domain == Domain::Whole || domain == Domain::Segment(i);
    match property {
        Property::BendingStiffness => {
            for (_, segment) in beam.segments.iter_mut().enumerate().filter(|(i, _)| meant(*i)) {
                segment.bending_stiffness = segment.bending_stiffness.scaled(factor);
            }
        }
        Property::ShearStiffness => {
            for (_, segment) in beam.segments.iter_mut().enumerate().filter(|(i, _)| meant(*i)) {
                segment.shear_stiffness = segment.shear_stiffness.map(|own| own.scaled(factor));
            }
        }
        _ => {
            for (_, segment) in ground.segments.iter_mut().enumerate().filter(|(i, _)| meant(*i)) {
                let profile = match property {
                    Property::Spring => &mut segment.subgrade,
                    _ => &mut segment.shear_layer,
                };
                *profile = profile.scaled(factor);
            }
        }
    }
}

/// A number of a load; `None` if the load does not have it.
pub(super) fn of_load(load: &Load, number: LoadNumber) -> Option<f64> {
    match (load.extent, number) {
        (Extent::Point { size, .. }, LoadNumber::Size) => Some(size),
        // Distributed loads on the ground and the positions of loads on the ground are not parameters.
        (Extent::Point { at, .. }, LoadNumber::At) if !load.on_ground => Some(at),
        (Extent::Distributed { from, to, start, end }, number) if !load.on_ground => match number {
            LoadNumber::Size => (start == end).then_some(start),
            LoadNumber::From => Some(from),
            LoadNumber::To => Some(to),
            LoadNumber::Start => Some(start),
            LoadNumber::End => Some(end),
            LoadNumber::At => None,
        },
        _ => None,
    }
}

pub(super) fn set_load(load: &mut Load, number: LoadNumber, value: f64) {
    match (&mut load.extent, number) {
        (Extent::Point { size, .. }, LoadNumber::Size) => *size = value,
        (Extent::Point { at, .. }, LoadNumber::At) if !load.on_ground => *at = value,
        (Extent::Distributed { from, to, start, end }, number) if !load.on_ground => match number {
            LoadNumber::Size => [*start, *end] = [value; 2],
            LoadNumber::From => *from = value,
            LoadNumber::To => *to = value,
            LoadNumber::Start => *start = value,
            LoadNumber::End => *end = value,
            LoadNumber::At => {}
        },
        _ => {}
    }
}
