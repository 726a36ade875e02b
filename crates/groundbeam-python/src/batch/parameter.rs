//! Parameters of a model, with values from arrays.

use crate::derivatives::parameter;
use crate::failure::Failure;
use crate::read::Read;
use groundbeam::Model;
use groundbeam::derivatives::{Parameter as Number, Property};
use groundbeam_file::{
    Course, Shape, along_the_beam, change, most_control_values, problem, set_the_same_number,
};
use numpy::ndarray::ArrayView2;
use std::sync::Arc;

/// Values of one parameter: one row for each model, or a single row that all models share.
pub struct Parameter {
    name: String,
    target: Number,
    /// How the values of a row vary along the beam: linearly between points, in steps, or as one curve.
    shape: Shape,
    /// Values of all rows, row by row.
    values: Vec<f64>,
    /// Number of values per row: one value, or several values along the beam.
    width: usize,
}

impl Parameter {
    /// Reads a parameter and checks its values against the models. `shape` is the Python class of the values. This
    /// class defines the variation of the values along the beam.
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
            Some(other) => return wrong(format!("`{other}` is not a shape")),
            // One or two values give the same constant or linear function, whether they are values at points or control
            // values of a curve.
            None if width <= 2 => Shape::Even(Course::Lines),
            None => {
                return wrong(format!(
                    "a row of {width} values is ambiguous: write groundbeam.Points(values) for values at equidistant \
                     points with linear variation between them, or groundbeam.ControlValues(values) for the control \
                     values of one curve, as Foundation(k=[...]) and Beam(EI=[...]) take them"
                ));
            }
        };
        let most = property.map_or(1, most_control_values);
        if shape == Shape::Curve && width > most {
            return wrong(format!(
                "a curve has at most {most} control values, but {width} are given: control values are the Bernstein \
                 coefficients of one polynomial; use groundbeam.Points for values at points"
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

/// Checks that no two parameters set the same number. Checks also that k and μ have the same stretches along the
/// beam, unless one of them is given for the whole beam.
pub fn agree(parameters: &[Parameter]) -> Result<(), Failure> {
    for (i, one) in parameters.iter().enumerate() {
        let same = |other: &&Parameter| set_the_same_number(one.target, other.target);
        if let Some(other) = parameters[..i].iter().find(same) {
            return Err(Failure::Asked(format!(
                "parameters `{}` and `{}` set the same number; omit one of them",
                other.name, one.name
            )));
        }
    }
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
            "`{}` has {} stretches along the beam and `{}` has {}; give both parameters the same number of stretches",
            one.name,
            stretches(one),
            other.name,
            stretches(other)
        )));
    }
    Ok(())
}

/// Applies row `number` of each parameter to the model.
pub fn apply(parameters: &[Parameter], number: usize, model: &mut Model) {
    let changes = parameters
        .iter()
        .map(|parameter| (parameter.target, parameter.shape, parameter.row(number)));
    change(model, changes);
}
