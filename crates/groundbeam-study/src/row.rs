//! The row of one answer in the table of results.

use groundbeam::{Answer, Error, Existence, Field, Model, Side, Solution, Solver};

/// What is to be kept of every answer.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Wanted {
    /// Positions \[m\].
    pub at: Vec<f64>,
    /// Fields at these positions.
    pub fields: Vec<Field>,
    /// Fields of which the smallest and the largest value are kept.
    pub extremes: Vec<Field>,
}

/// How it went, by the numbers that tables of results know it by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    /// There is an answer, certified.
    Solved = 0,
    /// There is no equilibrium.
    NoEquilibrium = 1,
    /// No answer could be certified.
    NotConverged = 2,
    /// The model was refused.
    Wrong = 3,
}

impl Status {
    /// All, by their numbers.
    pub const ALL: [Status; 4] =
        [Status::Solved, Status::NoEquilibrium, Status::NotConverged, Status::Wrong];

    /// The name that results use.
    pub fn name(self) -> &'static str {
        match self {
            Status::Solved => "solved",
            Status::NoEquilibrium => "no-equilibrium",
            Status::NotConverged => "not-converged",
            Status::Wrong => "wrong",
        }
    }
}

/// Why there is no answer.
#[derive(Debug, Clone)]
pub enum Trouble {
    /// There is no equilibrium.
    NoEquilibrium(Existence),
    /// The model was refused, or no answer was certified.
    Failed(Error),
}

/// What is kept of one answer. Where there is none, numbers are not numbers.
#[derive(Debug, Clone)]
pub struct Row {
    /// How it went.
    pub status: Status,
    /// Why there is no answer; none where there is one.
    pub trouble: Option<Box<Trouble>>,
    /// The concentrated contact forces under both ends \[N\].
    pub end_forces: [f64; 2],
    /// The part of the beam that does not touch.
    pub lifted_share: f64,
    /// The certificate's gap, of the strain energy.
    pub relative_gap: f64,
    /// r(0), r(l) and F(r) of the motion that proves that there is no equilibrium.
    pub motion: [f64; 3],
    /// Where the beam touches \[m\].
    pub contact: Vec<[f64; 2]>,
    /// Of each wanted field, where it is smallest and how small, where it is largest and how large.
    pub extremes: Vec<[f64; 4]>,
    /// The wanted fields at the wanted positions, field by field.
    pub values: Vec<f64>,
}

impl Row {
    /// Solves a model made of a file's, in the memory of the one before. The bits do not depend on what that was.
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
        }
    }

    /// Of an equilibrium. Beyond its ends a beam has no fields, but the ground beside it settles.
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
        }
    }

    /// Of a model that has no equilibrium.
    fn without(existence: Existence, wanted: &Wanted) -> Self {
        let motion = existence.verdict.motion().unwrap_or([f64::NAN; 3]);
        let trouble = Trouble::NoEquilibrium(existence);
        Row { motion, ..Self::empty(Status::NoEquilibrium, trouble, wanted) }
    }

    /// Of a model that was refused, or of which no answer was certified.
    fn failed(error: Error, wanted: &Wanted) -> Self {
        let status = match error {
            Error::NotConverged(_) => Status::NotConverged,
            _ => Status::Wrong,
        };
        Self::empty(status, Trouble::Failed(error), wanted)
    }
}
