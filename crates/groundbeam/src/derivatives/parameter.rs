//! Parameters: the numbers of a model with respect to which outputs are differentiated.

use crate::model::{
    BeamSegment, Extent, FoundationSegment, Load, Model, Profile, Support, SupportKind,
};

/// A stiffness of the beam or the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Property {
    /// Bending stiffness EI \[N·m²\].
    BendingStiffness,
    /// Shear stiffness S = κGA of a beam with shear deformation \[N\].
    ShearStiffness,
    /// Spring constant k of the ground \[N/m²\].
    Spring,
    /// Shear constant μ of the ground \[N\].
    Shear,
}

/// The part of the beam or of the ground on which a parameter changes a property.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Domain {
    /// The whole beam or the whole ground, inside and outside of all segments.
    Whole,
    /// The part of the beam or of the ground outside all segments, where the property has the value given for the beam
    /// or the foundation itself.
    OutsideSegments,
    /// One segment, counted from 0. A ground segment at an end of the beam continues outside the beam.
    Segment(usize),
}

/// A number of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LoadNumber {
    /// Size of the load: force \[N, N/m\], moment \[N·m, N·m/m\] or curvature \[1/m\]. For a distributed load, the
    /// size is the value at both ends if these values are equal.
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
    /// Settlement of the support \[m\].
    Settlement,
    /// Spring constant of the support \[N/m\].
    Spring,
    /// Rotational spring constant of the support \[N·m/rad\].
    RotationalSpring,
}

/// A numerical parameter of a model. Indices of loads, supports and other parts start at 0, in the order of the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Parameter {
    /// The value of a property on a domain where the property is constant. With [`Domain::Whole`], no segment may
    /// define the property.
    Value(Property, Domain),
    /// A factor on a property. The current value of the factor is 1.
    Factor(Property, Domain),
    /// Axial force P \[N\], positive in tension.
    AxialForce,
    /// A number of one load.
    Load(usize, LoadNumber),
    /// A factor on all loads. The current value of the factor is 1.
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

    /// Returns the value of the parameter in the model, or `None` if the model does not have the parameter.
    pub fn value(self, model: &Model) -> Option<f64> {
        match self {
            Parameter::Value(property, domain) => constant(model, property, domain),
            Parameter::Factor(property, domain) => {
                courses(model, property, domain).next().map(|_| 1.0)
            }
            Parameter::LoadFactor => Some(1.0),
            Parameter::AxialForce => Some(model.beam.axial_force),
            Parameter::Load(i, number) => {
                let [first, second] = of_load(model.loads.get(i)?, number)?;
                (first == second).then_some(first)
            }
            Parameter::Support(i, number) => {
                of_support(&mut model.supports.get(i)?.clone(), number).copied()
            }
            Parameter::HingeSpring(i) => Some(model.hinges.get(i)?.rotational_spring),
            Parameter::Gap(i) => Some(model.gap.get(i)?.value),
        }
    }

    /// Returns the model with the parameter set to `to`, or `None` if the model does not have the parameter.
    pub fn set(self, model: &Model, to: f64) -> Option<Model> {
        let mut model = model.clone();
        self.assign(&mut model, to).then_some(model)
    }

    /// Sets the parameter in a model. Returns whether the model has the parameter.
    pub fn assign(self, model: &mut Model, to: f64) -> bool {
        self.value(model).is_some() && self.assigned(model, to).is_some()
    }

    fn assigned(self, model: &mut Model, to: f64) -> Option<()> {
        match self {
            Parameter::Value(property, domain) => change(model, property, domain, |_| to.into()),
            Parameter::Factor(property, domain) => {
                change(model, property, domain, |course| course.scaled(to));
            }
            Parameter::LoadFactor => {
                model.loads.iter_mut().for_each(|load| *load = load.scaled(to))
            }
            _ => self.assign_number(model, to)?,
        }
        Some(())
    }

    /// Sets the axial force, or a number of a load, support, hinge or gap point. Returns `None` for all other
    /// parameters, and if the model does not have the parameter.
    pub(super) fn assign_number(self, model: &mut Model, to: f64) -> Option<()> {
        match self {
            Parameter::AxialForce => model.beam.axial_force = to,
            Parameter::Load(i, number) => set_load(model.loads.get_mut(i)?, number, to)?,
            Parameter::Support(i, number) => *of_support(model.supports.get_mut(i)?, number)? = to,
            Parameter::HingeSpring(i) => model.hinges.get_mut(i)?.rotational_spring = to,
            Parameter::Gap(i) => model.gap.get_mut(i)?.value = to,
            Parameter::Value(..) | Parameter::Factor(..) | Parameter::LoadFactor => return None,
        }
        Some(())
    }
}

fn is_meant(domain: Domain, segment: usize) -> bool {
    domain == Domain::Whole || domain == Domain::Segment(segment)
}

/// Returns the profiles of a property on a domain: first the value outside the segments, then the profiles of the
/// segments.
pub(super) fn courses(
    model: &Model,
    property: Property,
    domain: Domain,
) -> impl Iterator<Item = Profile> + '_ {
    let (beam, ground) = (&model.beam, &model.foundation);
    let own = match property {
        Property::BendingStiffness => Some(beam.bending_stiffness),
        Property::ShearStiffness => beam.shear_stiffness,
        Property::Spring => Some(ground.subgrade),
        Property::Shear => Some(ground.shear_layer),
    };
    let of_beam = move |segment: &BeamSegment| match property {
        Property::BendingStiffness => Some(segment.bending_stiffness),
        Property::ShearStiffness => segment.shear_stiffness,
        Property::Spring | Property::Shear => None,
    };
    let of_ground = move |segment: &FoundationSegment| match property {
        Property::Spring => Some(segment.subgrade),
        Property::Shear => Some(segment.shear_layer),
        Property::BendingStiffness | Property::ShearStiffness => None,
    };
    let beam = beam.segments.iter().map(of_beam).enumerate();
    let segments = beam.chain(ground.segments.iter().map(of_ground).enumerate());
    let segments = segments.filter_map(move |(i, own)| own.filter(|_| is_meant(domain, i)));
    let own = own.filter(|_| !matches!(domain, Domain::Segment(_)));
    own.map(Profile::constant).into_iter().chain(segments)
}

/// Applies `to` to each profile of a property in a domain of the beam or ground, in the order of [`courses`]. A profile
/// is the variation of the property along x, such as EI(x).
pub(super) fn change(
    model: &mut Model,
    property: Property,
    domain: Domain,
    mut to: impl FnMut(Profile) -> Profile,
) {
    let (beam, ground) = (&mut model.beam, &mut model.foundation);
    let own = match property {
        Property::BendingStiffness => Some(&mut beam.bending_stiffness),
        Property::ShearStiffness => beam.shear_stiffness.as_mut(),
        Property::Spring => Some(&mut ground.subgrade),
        Property::Shear => Some(&mut ground.shear_layer),
    };
    if let Some(own) = own.filter(|_| !matches!(domain, Domain::Segment(_))) {
        *own = to(Profile::constant(*own)).start();
    }
    let beam = beam.segments.iter_mut().map(|segment| match property {
        Property::BendingStiffness => Some(&mut segment.bending_stiffness),
        Property::ShearStiffness => segment.shear_stiffness.as_mut(),
        Property::Spring | Property::Shear => None,
    });
    let ground = ground.segments.iter_mut().map(|segment| match property {
        Property::Spring => Some(&mut segment.subgrade),
        Property::Shear => Some(&mut segment.shear_layer),
        Property::BendingStiffness | Property::ShearStiffness => None,
    });
    for (_, course) in
        beam.enumerate().chain(ground.enumerate()).filter(|(i, _)| is_meant(domain, *i))
    {
        if let Some(course) = course {
            *course = to(*course);
        }
    }
}

/// Returns the value of a property on a domain, or `None` if the property varies on the domain.
fn constant(model: &Model, property: Property, domain: Domain) -> Option<f64> {
    let is_single = domain != Domain::Whole || courses(model, property, domain).nth(1).is_none();
    let own = if domain == Domain::Whole { Domain::OutsideSegments } else { domain };
    let course = courses(model, property, own).next()?;
    (is_single && course.is_constant()).then(|| course.start())
}

/// Returns a parameter of a load as two values, which differ only for the size of a varying distributed load. Returns
/// `None` if the load does not have the parameter.
fn of_load(load: &Load, number: LoadNumber) -> Option<[f64; 2]> {
    Some(match (load.extent, number) {
        (Extent::Point { size, .. }, LoadNumber::Size) => [size; 2],
        _ if load.on_ground => return None,
        (Extent::Point { at, .. }, LoadNumber::At) => [at; 2],
        (Extent::Distributed { start, end, .. }, LoadNumber::Size) => [start, end],
        (Extent::Distributed { from, .. }, LoadNumber::From) => [from; 2],
        (Extent::Distributed { to, .. }, LoadNumber::To) => [to; 2],
        (Extent::Distributed { start, .. }, LoadNumber::Start) => [start; 2],
        (Extent::Distributed { end, .. }, LoadNumber::End) => [end; 2],
        _ => return None,
    })
}

/// Sets a parameter of a load, such as its size or its position. Returns `None` if the load does not have this
/// parameter.
pub(super) fn set_load(load: &mut Load, number: LoadNumber, value: f64) -> Option<()> {
    of_load(load, number)?;
    match (&mut load.extent, number) {
        (Extent::Point { size, .. }, LoadNumber::Size) => *size = value,
        (Extent::Point { at, .. }, _) => *at = value,
        (Extent::Distributed { start, end, .. }, LoadNumber::Size) => [*start, *end] = [value; 2],
        (Extent::Distributed { from, .. }, LoadNumber::From) => *from = value,
        (Extent::Distributed { to, .. }, LoadNumber::To) => *to = value,
        (Extent::Distributed { start, .. }, LoadNumber::Start) => *start = value,
        (Extent::Distributed { end, .. }, _) => *end = value,
    }
    Some(())
}

/// Returns a parameter of a support: its settlement or a spring constant. Returns `None` if the support does not have
/// this parameter.
fn of_support(support: &mut Support, number: SupportNumber) -> Option<&mut f64> {
    match (number, &mut support.kind) {
        (SupportNumber::Settlement, _) => Some(&mut support.settlement),
        (SupportNumber::Spring, SupportKind::Spring { spring, .. }) => Some(spring),
        (SupportNumber::RotationalSpring, SupportKind::Spring { rotational_spring, .. }) => {
            Some(rotational_spring)
        }
        _ => None,
    }
}
