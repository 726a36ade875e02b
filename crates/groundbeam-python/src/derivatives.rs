//! Derivatives of outputs with respect to parameters, by name, as arrays.

use crate::failure::Failure;
use crate::names::{field, side};
use groundbeam::derivatives::{Output, Parameter};
use groundbeam::{Model, Solution};
use groundbeam_report::Units;

/// Name of an output; for a field also the position and the side.
pub type Asked = (String, f64, String);

/// Values of all outputs, their derivatives with respect to all parameters, and for each output the reasons why its
/// derivatives are one-sided.
pub type Gradients = (Vec<f64>, Vec<f64>, Vec<Vec<String>>);

/// Returns the output with this name. For a field the position must be given.
pub fn output((name, at, from_side): &Asked) -> Result<Output, Failure> {
    if let Some(output) = Output::named(name) {
        return Ok(output);
    }
    match field(name) {
        Ok(field) => Ok(Output::Value(field, *at, side(from_side)?)),
        Err(_) => Err(Failure::Asked(format!(
            "no output has the name `{name}`; outputs are fields at positions, {}",
            Output::NAMES
        ))),
    }
}

/// Returns the parameter with this name.
pub fn parameter(name: &str) -> Result<Parameter, Failure> {
    Parameter::named(name).ok_or_else(|| {
        let names = Parameter::NAMES;
        Failure::Asked(format!("parameter `{name}`: unknown name; parameters are: {names}"))
    })
}

/// Returns the parameter with this name if it is a single number of the model. Returns an error if the parameter is k
/// or μ of a ground that the model defines by soil data.
pub fn parameter_of(name: &str, model: &Model, on_soil: bool) -> Result<Parameter, Failure> {
    let own = parameter(name)?;
    let why = if on_soil && own.is_of_ground() {
        "the model's ground is defined by soil data"
    } else if own.value(model).is_none() {
        "the model has no such number, or its value differs between segments: use a factor such as `k_factor`"
    } else {
        return Ok(own);
    };
    Err(Failure::Asked(format!("parameter `{name}`: {why}")))
}

/// Computes the derivatives of all outputs with respect to all parameters. Returns an error if a parameter is k or μ of
/// a ground that the model defines by soil data.
pub fn gradients(
    solution: &Solution,
    on_soil: bool,
    units: Units,
    outputs: &[Asked],
    parameters: &[String],
) -> Result<Gradients, Failure> {
    let outputs = outputs.iter().map(output).collect::<Result<Vec<_>, _>>()?;
    let by = parameters.iter().map(|name| parameter_of(name, solution.model(), on_soil));
    let by = by.collect::<Result<Vec<Parameter>, _>>()?;
    let found = solution.gradients(&outputs, &by);
    let found = found.map_err(|why| Failure::Asked(why.to_string()))?;
    let si = !units.is_plain();
    let words = |one_sided: &[groundbeam::derivatives::OneSided]| {
        one_sided.iter().map(|why| why.in_words(if si { " m" } else { "" })).collect()
    };
    Ok((
        found.iter().map(|gradient| gradient.value).collect(),
        found.iter().flat_map(|gradient| gradient.derivatives.iter().copied()).collect(),
        found.iter().map(|gradient| words(&gradient.one_sided)).collect(),
    ))
}
