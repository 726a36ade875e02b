//! Converts one solution to a row of the table of results.

use groundbeam::derivatives::{Gradient, NotDifferentiable, Output, Parameter};
use groundbeam::{Answer, Error, Existence, Field, Model, Solution, Solver, solution::Side};

/// The values to be stored for every solution.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Wanted {
    /// Positions \[m\].
    pub at: Vec<f64>,
    /// Quantities along the beam whose values are stored at the positions `at`.
    pub fields: Vec<Field>,
    /// Quantities along the beam whose smallest and largest values are stored.
    pub extremes: Vec<Field>,
    /// Outputs whose derivatives with respect to `parameters` are stored.
    pub outputs: Vec<Output>,
    /// Parameters with respect to which the outputs are differentiated.
    pub parameters: Vec<Parameter>,
}

/// Status of a sample, with its code in tables of results.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    /// A certified solution exists.
    Solved = 0,
    /// No equilibrium exists.
    NoEquilibrium = 1,
    /// No solution could be certified.
    NotConverged = 2,
    /// The model was refused.
    Wrong = 3,
}

impl Status {
    /// All statuses, in the order of their codes.
    pub const ALL: [Status; 4] =
        [Status::Solved, Status::NoEquilibrium, Status::NotConverged, Status::Wrong];

    /// The name in results.
    pub fn name(self) -> &'static str {
        match self {
            Status::Solved => "solved",
            Status::NoEquilibrium => "no-equilibrium",
            Status::NotConverged => "not-converged",
            Status::Wrong => "wrong",
        }
    }
}

/// Reason why a sample has no solution.
#[derive(Debug, Clone)]
pub enum Trouble {
    /// No equilibrium exists.
    NoEquilibrium(Existence),
    /// The model was refused, or no solution was certified.
    Failed(Error),
}

/// The stored values of one sample. Without a solution, numbers are NaN.
#[derive(Debug, Clone)]
pub struct Row {
    /// The status.
    pub status: Status,
    /// Reason why the sample has no solution; `None` for a solved sample.
    pub trouble: Option<Box<Trouble>>,
    /// Point contact forces under the left and the right end of the beam \[N\].
    pub end_forces: [f64; 2],
    /// The fraction of the beam that is not in contact.
    pub lifted_share: f64,
    /// Energy gap of the certificate, relative to the strain energy.
    pub relative_gap: f64,
    /// Displacements of the left and the right end of the beam in the rigid motion or buckling mode that proves
    /// that no equilibrium exists, and the work of the loads in this motion.
    pub motion: [f64; 3],
    /// Contact zones \[m\].
    pub contact: Vec<[f64; 2]>,
    /// Position and value of the minimum, then position and value of the maximum, for each requested field.
    pub extremes: Vec<[f64; 4]>,
    /// Values at the requested positions: all values of the first requested quantity, then those of the next one.
    pub values: Vec<f64>,
    /// The derivatives of each requested output with respect to each parameter; NaN for an output that the solution does
    /// not have.
    pub gradients: Vec<f64>,
    /// For each requested output: whether its derivative with respect to at least one parameter is one-sided.
    pub one_sided: Vec<bool>,
}

impl Row {
    /// Solves the model of a sample in the workspace of the previous solve. The result does not depend on
    /// previous solves.
    pub fn solve(model: &Model, wanted: &Wanted, solver: &mut Solver) -> Self {
        match solver.solve(model) {
            Ok(Answer::Equilibrium(solution)) => Row::of(solution, wanted),
            Ok(Answer::NoEquilibrium(existence)) => Row::without(existence, wanted),
            Err(error) => Row::failed(error, wanted),
        }
    }

    fn empty(status: Status, trouble: Trouble, wanted: &Wanted) -> Self {
        Row {
            status,
            trouble: Some(Box::new(trouble)),
            end_forces: [f64::NAN; 2],
            lifted_share: f64::NAN,
            relative_gap: f64::NAN,
            motion: [f64::NAN; 3],
            contact: Vec::new(),
            extremes: vec![[f64::NAN; 4]; wanted.extremes.len()],
            values: vec![f64::NAN; wanted.at.len() * wanted.fields.len()],
            gradients: vec![f64::NAN; wanted.outputs.len() * wanted.parameters.len()],
            one_sided: vec![false; wanted.outputs.len()],
        }
    }

    /// Returns the stored values of an equilibrium. At positions outside the beam only the settlement has a
    /// value.
    fn of(solution: &Solution, wanted: &Wanted) -> Self {
        let ends = solution.end_forces();
        let on_beam = 0.0..=solution.model().beam.length;
        let fields: Vec<_> = wanted.at.iter().map(|&x| solution.at(x, Side::Right)).collect();
        let value = |field: Field| {
            let on_beam = &on_beam;
            let each = wanted.at.iter().zip(&fields);
            each.map(move |(x, fields)| match (on_beam.contains(x), field) {
                (true, field) => fields.get(field),
                (false, Field::Settlement) => solution.settlement(*x),
                (false, _) => f64::NAN,
            })
        };
        let extremes = wanted.extremes.iter().map(|&field| {
            let range = solution.range(field);
            [range.min.x, range.min.value, range.max.x, range.max.value]
        });
        let gradients = gradients(solution, wanted);
        let derivatives = |gradient: &Option<Gradient>| match gradient {
            Some(gradient) => gradient.derivatives.clone(),
            None => vec![f64::NAN; wanted.parameters.len()],
        };
        let is_one_sided =
            |own: &Option<Gradient>| own.as_ref().is_some_and(|own| !own.one_sided.is_empty());
        Row {
            status: Status::Solved,
            trouble: None,
            end_forces: [ends.left, ends.right],
            lifted_share: solution.lifted_share(),
            relative_gap: solution.certificate().relative_gap(),
            motion: [f64::NAN; 3],
            contact: solution.contact().iter().map(|c| [c.from, c.to]).collect(),
            extremes: extremes.collect(),
            values: wanted.fields.iter().flat_map(|&field| value(field)).collect(),
            gradients: gradients.iter().flat_map(derivatives).collect(),
            one_sided: gradients.iter().map(is_one_sided).collect(),
        }
    }

    /// Returns the row of a model without an equilibrium.
    fn without(existence: Existence, wanted: &Wanted) -> Self {
        let motion = existence.verdict.motion().unwrap_or([f64::NAN; 3]);
        let trouble = Trouble::NoEquilibrium(existence);
        Row { motion, ..Self::empty(Status::NoEquilibrium, trouble, wanted) }
    }

    /// Returns the row of a model that was refused or has no certified solution.
    fn failed(error: Error, wanted: &Wanted) -> Self {
        let status = match error {
            Error::NotConverged(_) => Status::NotConverged,
            _ => Status::Wrong,
        };
        Self::empty(status, Trouble::Failed(error), wanted)
    }
}

/// Computes the derivatives of the requested outputs with respect to the requested parameters. The entry of an
/// output without derivatives is `None`.
fn gradients(solution: &Solution, wanted: &Wanted) -> Vec<Option<Gradient>> {
    if wanted.outputs.is_empty() {
        return Vec::new();
    }
    let of = |outputs: &[Output]| solution.gradients(outputs, &wanted.parameters);
    match of(&wanted.outputs) {
        Ok(gradients) => gradients.into_iter().map(Some).collect(),
        // The number of contact zones differs between solutions, so a solution may lack one of the outputs.
        Err(NotDifferentiable::NoSuchOutput) => {
            wanted.outputs.iter().map(|output| of(&[*output]).ok()?.pop()).collect()
        }
        Err(_) => vec![None; wanted.outputs.len()],
    }
}
