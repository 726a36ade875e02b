//! The numbers of a model that an array changes.

use crate::derivatives::parameter;
use crate::failure::Failure;
use crate::read::Read;
use groundbeam::Model;
use groundbeam::derivatives::{Parameter as Number, Property};
use groundbeam_file::{Course, Shape, along_the_beam, change, most_control_values, problem};
use numpy::ndarray::ArrayView2;
use std::sync::Arc;

/// Numbers for one part of the models, a row for each or one row for all.
pub struct Parameter {
    name: String,
    target: Number,
    /// What the numbers of a row mean, if there are several.
    shape: Shape,
    /// Row by row.
    values: Vec<f64>,
    /// Numbers in a row: one, or several along the beam.
    width: usize,
}

impl Parameter {
    /// A named array, if it fits the models. `shape` is the Python class that says what the numbers of a row mean.
    pub fn read(
        name: &str,
        shape: Option<&str>,
        values: ArrayView2<'_, f64>,
        models: &[Arc<Read>],
    ) -> Result<Self, Failure> {
        let wrong = |why: String| Err(Failure::Asked(format!("parameter `{name}`: {why}")));
        let target = parameter(name)?;
        let width = values.ncols();
        let property = along_the_beam(target);
        if width == 0 || (width > 1 && property.is_none()) {
            return wrong("takes one number for each model".to_owned());
        }
        let shape = match shape {
            Some("Points") => Shape::Even(Course::Lines),
            Some("Steps") => Shape::Even(Course::Steps),
            Some("ControlValues") => Shape::Curve,
            Some(other) => return wrong(format!("`{other}` is no shape")),
            // Both meanings of two values agree.
            None if width <= 2 => Shape::Even(Course::Lines),
            None => {
                return wrong(format!(
                    "a row of {width} values can mean two things: write groundbeam.Points(values) for values at even \
                     points with straight lines between them, or groundbeam.ControlValues(values) for the control \
                     values of one curve, as Foundation(k=[...]) and Beam(EI=[...]) take them"
                ));
            }
        };
        let most = property.map_or(1, most_control_values);
        if shape == Shape::Curve && width > most {
            return wrong(format!(
                "a curve has at most {most} control values, and these are {width}; groundbeam.Points takes any number"
            ));
        }
        for read in models {
            if let Some(problem) = problem(target, name, &read.document) {
                return wrong(problem);
            }
        }
        let values = values.iter().copied().collect();
        Ok(Parameter { name: name.to_owned(), target, shape, values, width })
    }

    fn row(&self, number: usize) -> &[f64] {
        let rows = self.values.len() / self.width;
        let row = if rows == 1 { 0 } else { number };
        &self.values[row * self.width..(row + 1) * self.width]
    }
}

/// k and μ along the beam must be given on the same stretches, or one of them on the whole beam.
pub fn agree(parameters: &[Parameter]) -> Result<(), Failure> {
    let of_ground = |p: &&Parameter| {
        let is_ground = |property| matches!(property, Property::Spring | Property::Shear);
        p.width > 1 && along_the_beam(p.target).is_some_and(is_ground)
    };
    let stretches = |p: &Parameter| p.shape.stretches(p.width);
    let mut fields = parameters.iter().filter(of_ground);
    if let (Some(one), Some(other)) = (fields.next(), fields.next())
        && stretches(one) != stretches(other)
        && stretches(one) > 1
        && stretches(other) > 1
    {
        return Err(Failure::Asked(format!(
            "`{}` has {} stretches along the beam and `{}` has {}; give both the same",
            one.name,
            stretches(one),
            other.name,
            stretches(other)
        )));
    }
    Ok(())
}

/// The model under the parameters of a row.
pub fn apply(parameters: &[Parameter], number: usize, model: &mut Model) {
    let changes = parameters
        .iter()
        .map(|parameter| (parameter.target, parameter.shape, parameter.row(number)));
    change(model, changes);
}
