//! Solves many models on all processors, from arrays of parameters to arrays of results.

mod parameter;
mod run;

use crate::derivatives::{Asked, output, parameter_of};
use crate::failure::Failure;
use crate::model::{Model, options};
use crate::names::field;
use groundbeam::{Field, Method};
use groundbeam_study::{Row, Wanted};
use numpy::{PyArray1, PyReadonlyArray1, PyReadonlyArray2};
use parameter::Parameter;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use run::{Answered, Task, run};

/// A parameter: its name, the optional name of the Python class of its values, and its rows of values. The class, such
/// as `Points`, states how the values of a row vary along the beam.
type Given<'py> = (String, Option<String>, PyReadonlyArray2<'py, f64>);

/// Solves `count` models, or one model with `count` sets of parameters.
///
/// Arrays of `parameters` have one row for each model, or one row for all. The results have one row for each model.
#[pyfunction]
pub fn solve_many<'py>(
    py: Python<'py>,
    models: Vec<PyRef<'py, Model>>,
    count: usize,
    parameters: Vec<Given<'py>>,
    at: PyReadonlyArray1<'py, f64>,
    fields: Vec<String>,
    extremes: Vec<String>,
    outputs: Vec<Asked>,
    with_respect_to: Vec<String>,
    method: &str,
    elements: usize,
    threads: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let options = options(method, elements)?;
    let named = |names: &[String]| names.iter().map(|n| field(n)).collect::<Result<Vec<_>, _>>();
    let models: Vec<_> = models.iter().map(|model| model.read.clone()).collect();
    if !outputs.is_empty() && options.method != Method::Exact {
        return Err(Failure::Asked("gradients need the exact method".to_owned()).into());
    }
    for (read, name) in
        models.iter().flat_map(|read| with_respect_to.iter().map(move |name| (read, name)))
    {
        parameter_of(name, &read.document.model, read.document.model.foundation.soil.is_some())?;
    }
    let by = with_respect_to.iter().map(|name| crate::derivatives::parameter(name));
    let wanted = Wanted {
        at: at.as_array().to_vec(),
        fields: named(&fields)?,
        extremes: named(&extremes)?,
        outputs: outputs.iter().map(output).collect::<Result<_, _>>()?,
        parameters: by.collect::<Result<_, _>>()?,
    };
    let parameters: Result<Vec<Parameter>, Failure> = parameters
        .iter()
        .map(|(name, shape, values)| {
            Parameter::read(name, shape.as_deref(), values.as_array(), &models)
        })
        .collect();
    let parameters = parameters?;
    parameter::agree(&parameters)?;
    let task = Task { models, parameters, wanted, options };
    let rows = py.detach(|| run(&task, count, threads, progress.as_ref()))?;
    columns(py, &task.wanted, rows)
}

/// Converts the results, which are one row for each model, to a dictionary with one array for each column.
fn columns<'py>(
    py: Python<'py>,
    wanted: &Wanted,
    rows: Vec<Answered>,
) -> PyResult<Bound<'py, PyDict>> {
    let table = PyDict::new(py);
    let column = |name: String, of: &dyn Fn(&Row) -> f64| {
        let values = rows.iter().map(|answered| of(&answered.row)).collect();
        table.set_item(name, PyArray1::from_vec(py, values))
    };
    column("left".into(), &|row| row.end_forces[0])?;
    column("right".into(), &|row| row.end_forces[1])?;
    column("lifted_share".into(), &|row| row.lifted_share)?;
    column("relative_gap".into(), &|row| row.relative_gap)?;
    for (i, name) in ["motion_left", "motion_right", "motion_work"].into_iter().enumerate() {
        column(name.into(), &|row| row.motion[i])?;
    }
    for (i, name) in wanted.extremes.iter().map(|field| field.name()).enumerate() {
        for (j, part) in ["min_x", "min", "max_x", "max"].into_iter().enumerate() {
            column(format!("{name}_{part}"), &|row| row.extremes[i][j])?;
        }
    }
    let stations = wanted.at.len();
    for (i, name) in wanted.fields.iter().map(|field: &Field| field.name()).enumerate() {
        let values =
            rows.iter().flat_map(|each| &each.row.values[i * stations..(i + 1) * stations]);
        table.set_item(name, PyArray1::from_vec(py, values.copied().collect()))?;
    }
    let gradients = rows.iter().flat_map(|each| each.row.gradients.iter().copied()).collect();
    table.set_item("gradients", PyArray1::from_vec(py, gradients))?;
    let one_sided = rows.iter().flat_map(|each| each.row.one_sided.iter().copied()).collect();
    table.set_item("one_sided", PyArray1::from_vec(py, one_sided))?;
    // The number of contact zones differs between models. So one array contains the zones of all models, and
    // another array contains the index of the first zone of each model.
    let mut starts = vec![0_i64];
    let mut edges: Vec<f64> = Vec::new();
    for Answered { row, .. } in &rows {
        edges.extend(row.contact.iter().flatten());
        starts.push((edges.len() / 2) as i64);
    }
    table.set_item("contact_starts", PyArray1::from_vec(py, starts))?;
    table.set_item("contact_edges", PyArray1::from_vec(py, edges))?;
    let status = rows.iter().map(|each| each.row.status as u8).collect();
    table.set_item("status", PyArray1::from_vec(py, status))?;
    let messages: Vec<Option<String>> = rows.into_iter().map(|each| each.message).collect();
    table.set_item("messages", messages)?;
    Ok(table)
}
