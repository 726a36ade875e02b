//! What an array of numbers changes in a model.

use crate::failure::Failure;
use crate::model::Read;
use groundbeam::sensitivity::{LoadNumber, Parameter as Number};
use groundbeam::{Beam, Load, Model, Profile};
use numpy::ndarray::ArrayView2;
use std::sync::Arc;

/// Numbers for one part of the models, a row for each or one row for all.
pub struct Parameter {
    name: String,
    target: Target,
    /// Row by row.
    values: Vec<f64>,
    /// Numbers in a row: one, or as many as there are points along the beam.
    width: usize,
}

/// The part of a model that is changed.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Target {
    Spring,
    Shear,
    Stiffness,
    AxialForce,
    SpringFactor,
    ShearFactor,
    StiffnessFactor,
    LoadFactor,
    Load(usize, OfLoad),
    /// Any other number of the model.
    Number(Number),
}

/// The part of a load that is changed.
#[derive(Debug, Clone, Copy, PartialEq)]
enum OfLoad {
    Size,
    At,
    From,
    To,
    Start,
    End,
}

impl Target {
    fn read(name: &str) -> Option<Self> {
        Some(match name {
            "k" => Target::Spring,
            "mu" => Target::Shear,
            "EI" => Target::Stiffness,
            "axial_force" => Target::AxialForce,
            "k_factor" => Target::SpringFactor,
            "mu_factor" => Target::ShearFactor,
            "EI_factor" => Target::StiffnessFactor,
            "load_factor" => Target::LoadFactor,
            _ => match Number::named(name)? {
                Number::Load(index, number) => Target::Load(
                    index,
                    match number {
                        LoadNumber::Size => OfLoad::Size,
                        LoadNumber::At => OfLoad::At,
                        LoadNumber::From => OfLoad::From,
                        LoadNumber::To => OfLoad::To,
                        LoadNumber::Start => OfLoad::Start,
                        LoadNumber::End => OfLoad::End,
                    },
                ),
                other => Target::Number(other),
            },
        })
    }

    /// Whether it may be given at points along the beam.
    fn varies_along_the_beam(self) -> bool {
        matches!(self, Target::Spring | Target::Shear | Target::Stiffness)
    }

    fn is_of_ground(self) -> bool {
        use Target::{Shear, ShearFactor, Spring, SpringFactor};
        matches!(self, Spring | Shear | SpringFactor | ShearFactor)
            || matches!(self, Target::Number(number) if number.is_of_ground())
    }
}

impl Parameter {
    /// A named array, if it fits the models.
    pub fn read(
        name: &str,
        values: ArrayView2<'_, f64>,
        models: &[Arc<Read>],
    ) -> Result<Self, Failure> {
        let wrong = |why: String| Err(Failure::Asked(format!("parameter `{name}`: {why}")));
        let Some(target) = Target::read(name) else {
            return wrong(format!("means nothing; what can be changed: {}", Number::NAMES));
        };
        let width = values.ncols();
        if width == 0 || (width > 1 && !target.varies_along_the_beam()) {
            return wrong("takes one number for each model".to_owned());
        }
        for read in models {
            let model = &read.document.model;
            if target.is_of_ground() && read.document.bed.is_some() {
                return wrong("the model's ground is made of its soil".to_owned());
            }
            let has_segments = match target {
                Target::Spring | Target::Shear => !model.foundation.segments.is_empty(),
                Target::Stiffness => !model.beam.segments.is_empty(),
                _ => false,
            };
            if has_segments {
                return wrong(format!(
                    "the model gives it by segments; `{name}_factor` multiplies it in all of them"
                ));
            }
            if let Target::Number(number) = target
                && number.value(model).is_none()
            {
                return wrong("the model has no such number".to_owned());
            }
            if let Target::Load(index, part) = target {
                let Some(load) = model.loads.get(index) else {
                    let count = model.loads.len();
                    return wrong(format!("loads count from 0, and the model has {count}"));
                };
                if changed(*load, part, 0.0).is_none() {
                    return wrong("the load has no such number".to_owned());
                }
            }
        }
        let values = values.iter().copied().collect();
        Ok(Parameter { name: name.to_owned(), target, values, width })
    }

    fn row(&self, number: usize) -> &[f64] {
        let rows = self.values.len() / self.width;
        let row = if rows == 1 { 0 } else { number };
        &self.values[row * self.width..(row + 1) * self.width]
    }
}

/// Of fields along the beam, k and μ must be given at the same points.
pub fn agree(parameters: &[Parameter]) -> Result<(), Failure> {
    let of_ground =
        |p: &&Parameter| matches!(p.target, Target::Spring | Target::Shear) && p.width > 1;
    let mut fields = parameters.iter().filter(of_ground);
    if let (Some(one), Some(other)) = (fields.next(), fields.next())
        && one.width != other.width
    {
        return Err(Failure::Asked(format!(
            "`{}` has {} points along the beam and `{}` has {}; give both the same",
            one.name, one.width, other.name, other.width
        )));
    }
    Ok(())
}

/// The model under the parameters of a row.
pub fn apply(parameters: &[Parameter], number: usize, model: &mut Model) {
    let mut ground: [Option<&[f64]>; 2] = [None, None];
    // What is set is set before it is multiplied.
    for parameter in parameters {
        let row = parameter.row(number);
        match parameter.target {
            Target::Spring if row.len() > 1 => ground[0] = Some(row),
            Target::Shear if row.len() > 1 => ground[1] = Some(row),
            Target::Stiffness if row.len() > 1 => vary_stiffness(&mut model.beam, row),
            Target::Spring => model.foundation.spring = row[0],
            Target::Shear => model.foundation.shear = row[0],
            Target::Stiffness => model.beam.bending_stiffness = row[0],
            Target::AxialForce => model.beam.axial_force = row[0],
            Target::Load(index, part) => {
                if let Some(load) = model.loads.get_mut(index)
                    && let Some(changed) = changed(*load, part, row[0])
                {
                    *load = changed;
                }
            }
            _ => {}
        }
    }
    vary_ground(model, ground);
    for parameter in parameters {
        let factor = parameter.row(number)[0];
        match parameter.target {
            Target::SpringFactor => scale_ground(model, factor, 1.0),
            Target::ShearFactor => scale_ground(model, 1.0, factor),
            Target::StiffnessFactor => {
                model.beam.bending_stiffness *= factor;
                for segment in &mut model.beam.segments {
                    segment.bending_stiffness = segment.bending_stiffness.scaled(factor);
                }
            }
            Target::Number(number) => {
                if let Some(changed) = number.set(model, factor) {
                    *model = changed;
                }
            }
            Target::LoadFactor => {
                for load in &mut model.loads {
                    *load = load.scaled(factor);
                }
            }
            _ => {}
        }
    }
}

fn scale_ground(model: &mut Model, spring: f64, shear: f64) {
    model.foundation = model.foundation.clone().scaled(spring, shear);
}

/// Linear between values at even points from end to end.
fn vary_stiffness(beam: &mut Beam, values: &[f64]) {
    let length = beam.length;
    for (i, pair) in values.windows(2).enumerate() {
        let [from, to] = ends(length, i, values.len() - 1);
        let course = Profile::linear(pair[0], pair[1]);
        *beam = std::mem::replace(beam, Beam::uniform(length, values[0]))
            .with_varying_segment(from, to, course);
    }
}

fn vary_ground(model: &mut Model, ground: [Option<&[f64]>; 2]) {
    let Some(points) = ground.iter().flatten().map(|values| values.len()).next() else { return };
    let length = model.beam.length;
    let mut foundation = model.foundation.clone();
    let elsewhere = [foundation.spring, foundation.shear];
    for i in 0..points - 1 {
        let [from, to] = ends(length, i, points - 1);
        let [spring, shear] = [0, 1].map(|which| match ground[which] {
            Some(values) => Profile::linear(values[i], values[i + 1]),
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

/// A load with one of its numbers changed; none if it has no such number.
fn changed(load: Load, part: OfLoad, value: f64) -> Option<Load> {
    let mut load = load;
    match (&mut load, part) {
        (Load::PointForce { force: size, .. }, OfLoad::Size)
        | (Load::PointMoment { moment: size, .. }, OfLoad::Size) => *size = value,
        (Load::PointForce { at, .. } | Load::PointMoment { at, .. }, OfLoad::At) => *at = value,
        (
            Load::Distributed { from, to, start, end }
            | Load::DistributedMoment { from, to, start, end }
            | Load::Curvature { from, to, start, end },
            part,
        ) => match part {
            OfLoad::Size => [*start, *end] = [value; 2],
            OfLoad::From => *from = value,
            OfLoad::To => *to = value,
            OfLoad::Start => *start = value,
            OfLoad::End => *end = value,
            OfLoad::At => return None,
        },
        _ => return None,
    }
    Some(load)
}
