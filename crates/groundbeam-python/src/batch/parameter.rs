//! What an array of numbers changes in a model.

use crate::derivatives::parameter;
use crate::failure::Failure;
use crate::model::Read;
use groundbeam::Model;
use groundbeam::sensitivity::{Parameter as Number, Property};
use groundbeam_file::{Course, along_the_beam, change, problem};
use numpy::ndarray::ArrayView2;
use std::sync::Arc;

/// Numbers for one part of the models, a row for each or one row for all.
pub struct Parameter {
    name: String,
    target: Number,
    /// Row by row.
    values: Vec<f64>,
    /// Numbers in a row: one, or as many as there are points along the beam.
    width: usize,
}

impl Parameter {
    /// A named array, if it fits the models.
    pub fn read(
        name: &str,
        values: ArrayView2<'_, f64>,
        models: &[Arc<Read>],
    ) -> Result<Self, Failure> {
        let wrong = |why: String| Err(Failure::Asked(format!("parameter `{name}`: {why}")));
        let target = parameter(name)?;
        let width = values.ncols();
        if width == 0 || (width > 1 && along_the_beam(target).is_none()) {
            return wrong("takes one number for each model".to_owned());
        }
        for read in models {
            if let Some(problem) = problem(target, name, &read.document) {
                return wrong(problem);
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
    let of_ground = |p: &&Parameter| {
        let is_ground = |property| matches!(property, Property::Spring | Property::Shear);
        p.width > 1 && along_the_beam(p.target).is_some_and(is_ground)
    };
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
    let changes = parameters.iter().map(|parameter| (parameter.target, parameter.row(number)));
    change(model, Course::Lines, changes);
}
