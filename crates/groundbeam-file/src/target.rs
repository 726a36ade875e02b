//! Changes numbers of a model for studies and for batches of models, and explains why some numbers cannot be changed.

use crate::document::Document;
use crate::quantity::{
    BENDING_STIFFNESS, CLEARANCE, FORCE, Kind, LOAD_PER_LENGTH, POSITION, RATIO, ROTATIONAL_SPRING,
    SHEAR_CONSTANT, SPRING, SPRING_PER_LENGTH,
};
use crate::section::load::kind_of;
use groundbeam::derivatives::{Domain, LoadNumber, Parameter, Property, SupportNumber};
use groundbeam::{Beam, Foundation, Model, model::Profile};

/// Interpolation of a quantity between equidistant points along the whole beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Course {
    /// Linear between neighbouring points.
    #[default]
    Lines,
    /// Constant on each of several equal stretches, with one number for each stretch.
    Steps,
}

/// Interpretation of a list of numbers that describes one quantity along the beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Values at equidistant points or on equal stretches.
    Even(Course),
    /// Bernstein coefficients of one polynomial along the whole beam (control values of a Bézier curve), as in a model
    /// file ([`Profile`]).
    Curve,
}

/// A parameter and its new values: one number, or several numbers along the beam. `Shape` states how several numbers
/// describe the variation along the beam.
pub type Change<'a> = (Parameter, Shape, &'a [f64]);

/// Maximum number of control values of a curve that describes the property along the beam.
pub fn most_control_values(property: Property) -> usize {
    match property {
        Property::Spring | Property::Shear => Foundation::MOST_CONTROL_VALUES,
        Property::BendingStiffness | Property::ShearStiffness => Profile::MOST,
    }
}

/// Returns k, μ or EI if the parameter is one of these properties on the whole beam; `None` otherwise. These properties
/// can also be given by several numbers along the beam.
pub fn along_the_beam(parameter: Parameter) -> Option<Property> {
    match parameter {
        Parameter::Value(Property::ShearStiffness, _) => None,
        Parameter::Value(property, Domain::Whole) => Some(property),
        _ => None,
    }
}

/// Whether two parameters set the same value in the model, so that one of them would have no effect.
pub fn set_the_same_number(a: Parameter, b: Parameter) -> bool {
    let includes = |whole, part| match (whole, part) {
        (Parameter::Value(a, Domain::Whole), Parameter::Value(b, _)) => a == b,
        (Parameter::Load(a, LoadNumber::Size), Parameter::Load(b, number)) => {
            a == b && matches!(number, LoadNumber::Start | LoadNumber::End)
        }
        _ => whole == part,
    };
    includes(a, b) || includes(b, a)
}

/// Whether the number that the parameter sets must be positive.
pub(crate) fn must_be_positive(parameter: Parameter) -> bool {
    match parameter {
        Parameter::Value(property, _) | Parameter::Factor(property, _) => {
            property != Property::Shear
        }
        _ => false,
    }
}

/// Returns the reason why a number of the model cannot be changed, if any. `name` is the name that the user
/// gave to the number.
pub fn problem(parameter: Parameter, name: &str, document: &Document) -> Option<String> {
    let model = &document.model;
    if parameter.is_of_ground() && document.model.foundation.soil.is_some() {
        return Some("the model's ground is defined by soil data".to_owned());
    }
    if let Parameter::Load(index, _) = parameter
        && index >= model.loads.len()
    {
        let count = model.loads.len();
        return Some(format!("loads are numbered from 0, and the model has {count} of them"));
    }
    if parameter.value(model).is_some() {
        return None;
    }
    Some(match parameter {
        Parameter::Value(Property::ShearStiffness, _)
        | Parameter::Factor(Property::ShearStiffness, _)
            if !model.beam.shears() =>
        {
            "the beam has no shear deformation: give it `shear_stiffness`, `G` or `nu`".to_owned()
        }
        Parameter::Value(_, Domain::Whole) => {
            format!(
                "the model gives several values of `{name}` along the beam; use `{name}_factor`, which multiplies all of them"
            )
        }
        Parameter::Load(..) => "the load has no such number".to_owned(),
        _ => "the model has no such number".to_owned(),
    })
}

/// Returns the physical quantity of a parameter that exists in the model.
pub(crate) fn kind(parameter: Parameter, model: &Model) -> &'static Kind {
    match parameter {
        Parameter::Value(Property::Spring, _) => &SPRING_PER_LENGTH,
        Parameter::Value(Property::Shear, _) => &SHEAR_CONSTANT,
        Parameter::Value(Property::BendingStiffness, _) => &BENDING_STIFFNESS,
        Parameter::AxialForce | Parameter::Value(Property::ShearStiffness, _) => &FORCE,
        Parameter::Load(_, LoadNumber::At | LoadNumber::From | LoadNumber::To) => &POSITION,
        Parameter::Load(index, _) => {
            model.loads.get(index).map_or(&LOAD_PER_LENGTH, |load| kind_of(load).key.kind())
        }
        Parameter::Support(_, SupportNumber::Settlement) | Parameter::Gap(_) => &CLEARANCE,
        Parameter::Support(_, SupportNumber::Spring) => &SPRING,
        Parameter::Support(..) | Parameter::HingeSpring(_) => &ROTATIONAL_SPRING,
        _ => &RATIO,
    }
}

/// Changes numbers of the model. New values are assigned first, and factors are applied afterwards.
pub fn change<'a>(model: &mut Model, changes: impl Iterator<Item = Change<'a>> + Clone) {
    let multiplies =
        |parameter: Parameter| matches!(parameter, Parameter::Factor(..) | Parameter::LoadFactor);
    let numbers = changes.clone().filter(|(.., row)| row.len() == 1);
    for (parameter, _, row) in numbers.clone().filter(|(parameter, ..)| !multiplies(*parameter)) {
        parameter.assign(model, row[0]);
    }
    let mut ground: [Option<Along>; 2] = [None, None];
    for (parameter, shape, values) in changes.filter(|(.., row)| row.len() > 1) {
        let along = Along { shape, values };
        match along_the_beam(parameter) {
            Some(Property::Spring) => ground[0] = Some(along),
            Some(Property::Shear) => ground[1] = Some(along),
            Some(Property::BendingStiffness) => vary_stiffness(&mut model.beam, along),
            Some(Property::ShearStiffness) | None => {}
        }
    }
    vary_ground(model, ground);
    for (parameter, _, row) in numbers.filter(|(parameter, ..)| multiplies(*parameter)) {
        parameter.assign(model, row[0]);
    }
}

impl Shape {
    /// Returns the number of stretches that a list of `numbers` values describes.
    pub fn stretches(self, numbers: usize) -> usize {
        match self {
            Shape::Even(Course::Lines) => numbers - 1,
            Shape::Even(Course::Steps) => numbers,
            Shape::Curve => 1,
        }
    }
}

/// Values along the beam.
#[derive(Clone, Copy)]
struct Along<'a> {
    shape: Shape,
    values: &'a [f64],
}

impl Along<'_> {
    fn stretches(self) -> usize {
        self.shape.stretches(self.values.len())
    }

    /// Returns the profile on one of `count` equal stretches of the beam. The list of values must describe
    /// `count` stretches, or one curve along the whole beam.
    fn on(self, stretch: usize, count: usize) -> Profile {
        let own = self.stretches();
        if own == count {
            return self.own(stretch);
        }
        let [from, to] = ends(1.0, stretch, count);
        self.own(0).part(from, to)
    }

    /// Returns the profile on one of the stretches that the list of values describes.
    fn own(self, stretch: usize) -> Profile {
        let values = self.values;
        match self.shape {
            Shape::Even(Course::Lines) => Profile::linear(values[stretch], values[stretch + 1]),
            Shape::Even(Course::Steps) => Profile::constant(values[stretch]),
            Shape::Curve => {
                let curve = Profile::by_control_values(values);
                curve.unwrap_or(Profile::constant(f64::NAN))
            }
        }
    }
}

fn vary_stiffness(beam: &mut Beam, along: Along) {
    let length = beam.length;
    let count = along.stretches();
    for i in 0..count {
        let [from, to] = ends(length, i, count);
        *beam = std::mem::replace(beam, Beam::uniform(length, along.values[0]))
            .with_varying_segment(from, to, along.on(i, count));
    }
}

fn vary_ground(model: &mut Model, ground: [Option<Along>; 2]) {
    let Some(count) = ground.iter().flatten().map(|along| along.stretches()).max() else { return };
    let length = model.beam.length;
    let mut foundation = model.foundation.clone();
    let elsewhere = [foundation.subgrade, foundation.shear_layer];
    for i in 0..count {
        let [from, to] = ends(length, i, count);
        let [spring, shear] = [0, 1].map(|which| match ground[which] {
            Some(along) => along.on(i, count),
            None => Profile::constant(elsewhere[which]),
        });
        foundation = foundation.with_varying_segment(from, to, spring, shear);
    }
    model.foundation = foundation;
}

/// Returns the ends of one of `count` equal parts of the beam. The common end of two neighbouring parts is the
/// same number bit for bit.
fn ends(length: f64, part: usize, count: usize) -> [f64; 2] {
    [part, part + 1].map(|i| length * (i as f64 / count as f64))
}
