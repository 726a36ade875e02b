//! Numbers of a model, changed by their names: what they count, why some cannot be changed, and how rows of them are.

use crate::document::Document;
use crate::quantity::{
    BENDING_STIFFNESS, CLEARANCE, CURVATURE, FORCE, Kind, LOAD_PER_LENGTH, MOMENT,
    MOMENT_PER_LENGTH, POSITION, RATIO, ROTATIONAL_SPRING, SHEAR_CONSTANT, SPRING,
    SPRING_PER_LENGTH,
};
use groundbeam::sensitivity::{Extent, LoadNumber, Parameter, Property, SupportNumber};
use groundbeam::{Beam, Load, Model, Profile};

/// How a quantity runs between numbers at even points from one end of the beam to the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Course {
    /// Straight from one point to the next.
    #[default]
    Lines,
    /// As many equal stretches as there are numbers, each with one of them.
    Steps,
}

/// A number for a parameter, or several along the beam.
pub type Change<'a> = (Parameter, &'a [f64]);

/// k, μ or EI of the whole beam, which may also be given at points along it.
pub fn along_the_beam(parameter: Parameter) -> Option<Property> {
    match parameter {
        Parameter::Value(Property::ShearStiffness, _) => None,
        Parameter::Value(property, Extent::Whole) => Some(property),
        _ => None,
    }
}

/// Whether a model cannot be solved unless this number is positive.
pub(crate) fn must_be_positive(parameter: Parameter) -> bool {
    match parameter {
        Parameter::Value(property, _) | Parameter::Factor(property, _) => {
            property != Property::Shear
        }
        _ => false,
    }
}

/// Why a number of a file's model cannot be changed, if it cannot; `name` is what it was called.
pub fn problem(parameter: Parameter, name: &str, document: &Document) -> Option<String> {
    let model = &document.model;
    if parameter.is_of_ground() && document.bed.is_some() {
        return Some("the model's ground is made of its soil".to_owned());
    }
    if let Parameter::Load(index, _) = parameter
        && index >= model.loads.len()
    {
        let count = model.loads.len();
        return Some(format!("loads count from 0, and the model has {count}"));
    }
    if parameter.value(model).is_some() {
        return None;
    }
    Some(match parameter {
        Parameter::Value(Property::ShearStiffness, _)
        | Parameter::Factor(Property::ShearStiffness, _)
            if !model.beam.shears() =>
        {
            "the beam only bends: give it `shear_stiffness`, `G` or `nu`".to_owned()
        }
        Parameter::Value(_, Extent::Whole) => {
            format!("the model gives it by segments; `{name}_factor` multiplies it in all of them")
        }
        Parameter::Load(..) => "the load has no such number".to_owned(),
        _ => "the model has no such number".to_owned(),
    })
}

/// What a number counts, in a model that has it.
pub(crate) fn kind(parameter: Parameter, model: &Model) -> &'static Kind {
    match parameter {
        Parameter::Value(Property::Spring, _) => &SPRING_PER_LENGTH,
        Parameter::Value(Property::Shear, _) => &SHEAR_CONSTANT,
        Parameter::Value(Property::BendingStiffness, _) => &BENDING_STIFFNESS,
        Parameter::AxialForce | Parameter::Value(Property::ShearStiffness, _) => &FORCE,
        Parameter::Load(_, LoadNumber::At | LoadNumber::From | LoadNumber::To) => &POSITION,
        Parameter::Load(index, _) => match model.loads.get(index) {
            Some(Load::PointForce { .. } | Load::GroundForce { .. }) => &FORCE,
            Some(Load::PointMoment { .. }) => &MOMENT,
            Some(Load::DistributedMoment { .. }) => &MOMENT_PER_LENGTH,
            Some(Load::Curvature { .. }) => &CURVATURE,
            _ => &LOAD_PER_LENGTH,
        },
        Parameter::Support(_, SupportNumber::Settlement) | Parameter::Gap(_) => &CLEARANCE,
        Parameter::Support(_, SupportNumber::Spring) => &SPRING,
        Parameter::Support(..) | Parameter::HingeSpring(_) => &ROTATIONAL_SPRING,
        _ => &RATIO,
    }
}

/// The model with numbers changed: what is set is set first, then what multiplies multiplies.
pub fn change<'a>(
    model: &mut Model,
    course: Course,
    changes: impl Iterator<Item = Change<'a>> + Clone,
) {
    let multiplies =
        |parameter: Parameter| matches!(parameter, Parameter::Factor(..) | Parameter::LoadFactor);
    let numbers = changes.clone().filter(|(_, row)| row.len() == 1);
    for (parameter, row) in numbers.clone().filter(|(parameter, _)| !multiplies(*parameter)) {
        parameter.assign(model, row[0]);
    }
    let mut ground: [Option<&[f64]>; 2] = [None, None];
    for (parameter, row) in changes.filter(|(_, row)| row.len() > 1) {
        match along_the_beam(parameter) {
            Some(Property::Spring) => ground[0] = Some(row),
            Some(Property::Shear) => ground[1] = Some(row),
            Some(Property::BendingStiffness) => vary_stiffness(&mut model.beam, course, row),
            Some(Property::ShearStiffness) | None => {}
        }
    }
    vary_ground(model, course, ground);
    for (parameter, row) in numbers.filter(|(parameter, _)| multiplies(*parameter)) {
        parameter.assign(model, row[0]);
    }
}

impl Course {
    /// How many stretches so many numbers make.
    fn stretches(self, numbers: usize) -> usize {
        match self {
            Course::Lines => numbers - 1,
            Course::Steps => numbers,
        }
    }

    /// The course of a stretch.
    fn of(self, values: &[f64], stretch: usize) -> Profile {
        match self {
            Course::Lines => Profile::linear(values[stretch], values[stretch + 1]),
            Course::Steps => Profile::constant(values[stretch]),
        }
    }
}

fn vary_stiffness(beam: &mut Beam, course: Course, values: &[f64]) {
    let length = beam.length;
    let count = course.stretches(values.len());
    for i in 0..count {
        let [from, to] = ends(length, i, count);
        *beam = std::mem::replace(beam, Beam::uniform(length, values[0])).with_varying_segment(
            from,
            to,
            course.of(values, i),
        );
    }
}

fn vary_ground(model: &mut Model, course: Course, ground: [Option<&[f64]>; 2]) {
    let Some(points) = ground.iter().flatten().map(|values| values.len()).next() else { return };
    let length = model.beam.length;
    let mut foundation = model.foundation.clone();
    let elsewhere = [foundation.spring, foundation.shear];
    let count = course.stretches(points);
    for i in 0..count {
        let [from, to] = ends(length, i, count);
        let [spring, shear] = [0, 1].map(|which| match ground[which] {
            Some(values) => course.of(values, i),
            None => Profile::constant(elsewhere[which]),
        });
        foundation = foundation.with_varying_segment(from, to, spring, shear);
    }
    model.foundation = foundation;
}

/// The ends of one of `count` equal parts of the beam: those of neighbours are the same number.
fn ends(length: f64, part: usize, count: usize) -> [f64; 2] {
    [part, part + 1].map(|i| length * (i as f64 / count as f64))
}
