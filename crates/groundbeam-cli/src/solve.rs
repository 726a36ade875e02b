//! `groundbeam solve`.

use crate::Status;
use crate::combinations;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{draw, print, standard_error_has_colour, standard_output_has_colour, write};
use crate::request::{Grow, Solve};
use crate::trains;
use crate::waiting::while_working;
use groundbeam::{Error, LoadFactors, Model, Options, Outcome, Solution};
use groundbeam_file::{
    Combination, Diagnostic, Diagnostics, Severity, parse_cases, parse_positions,
};
use groundbeam_report::{Context, Factors, Ground, csv, json, png, svg, text};
use std::time::Instant;

pub fn run(request: &Solve) -> Result<Status, Failure> {
    let input = Input::read(&request.file)?;
    let train = input.document.train.as_ref();
    let loaded = match &request.combination {
        Some(name) => Loaded::combined(&input, name)?,
        None if !input.document.has_combinations() => Loaded::as_written(&input),
        None if train.is_some() => {
            let message = "the file has combinations and a train: add --combination NAME for the \
                           one under which it passes";
            return Err(Failure::usage(message.to_owned()));
        }
        None => return combinations::solve(&input, request),
    };
    match train {
        Some(train) => {
            trains::solve(&input, request, train, &loaded.model, loaded.title.as_deref())
        }
        None => one(&input, request, &loaded),
    }
}

/// The model under the loads that are asked for.
struct Loaded {
    title: Option<String>,
    model: Model,
    /// Which of the document's loads these are.
    loads: Vec<usize>,
}

impl Loaded {
    /// Every load of the file as it is written.
    fn as_written(input: &Input) -> Self {
        let model = input.document.model.clone();
        let loads = (0..model.loads.len()).collect();
        Loaded { title: input.document.title.clone(), model, loads }
    }

    /// One of the file's combinations.
    fn combined(input: &Input, name: &str) -> Result<Self, Failure> {
        let combination = input
            .document
            .combination(name)
            .map_err(|found| Failure::diagnostics(&found, "--combination", name))?;
        let Combination { name, model, loads, .. } = combination;
        let title = match &input.document.title {
            Some(title) => format!("{title}: {name}"),
            None => name,
        };
        Ok(Loaded { title: Some(title), model, loads })
    }
}

fn one(input: &Input, request: &Solve, loaded: &Loaded) -> Result<Status, Failure> {
    let model = &loaded.model;
    let stations = request.at.as_deref().map(|list| positions(input, list)).transpose()?;
    let growing =
        request.factors.as_ref().map(|grow| Growing::of(input, grow, loaded)).transpose()?;

    let started = Instant::now();
    let words = format!("solving with the method {}", request.options.method.name());
    let outcome = while_working(words, || solved(input, model, &request.options));
    let context = Context { title: loaded.title.as_deref(), ..input.context() };
    let context = context.with_seconds(started.elapsed().as_secs_f64());
    let (outcome, context) = match outcome {
        Ok((outcome, Some(ground))) => (Ok(outcome), context.with_ground(ground)),
        Ok((outcome, None)) => (Ok(outcome), context),
        Err(error) => (Err(error), context),
    };
    let factors =
        growing.as_ref().map(|growing| growing.factors(input, model, &context)).transpose()?;
    let context = match (&growing, &factors) {
        (Some(Growing { cases, .. }), Some(found)) => {
            context.with_factors(Factors { found, cases })
        }
        _ => context,
    };

    match outcome {
        Ok(Outcome::Equilibrium(solution)) => {
            let stations = stations.unwrap_or_else(|| json::default_stations(&solution));
            write_files(request, &solution, &stations, &context)?;
            print(&if request.json {
                json::solved(&solution, &stations, &context)
            } else {
                text::solved(&solution, &context, standard_output_has_colour())
            })?;
            Ok(Status::Done)
        }
        Ok(Outcome::NoEquilibrium(existence)) => {
            if request.json {
                print(&json::no_equilibrium(model, &existence, &context))?;
                return Ok(Status::NoEquilibrium);
            }
            let shown = text::existence(model, &existence, &context, standard_error_has_colour());
            Err(Failure::reported(shown, Status::NoEquilibrium))
        }
        Err(Error::NotConverged(reached)) => {
            if request.json {
                print(&json::not_converged(&reached, &context))?;
                return Ok(Status::NotConverged);
            }
            let colour = standard_error_has_colour();
            let shown =
                text::not_converged(&reached, colour) + &text::load_factors(&context, colour);
            Err(Failure::reported(shown, Status::NotConverged))
        }
        Err(other) => Err(input.refused(&other)),
    }
}

/// What mechanics says of a model of the file, and the ground that was made of its soil if it has one.
pub fn solved<'a>(
    input: &'a Input,
    model: &Model,
    options: &Options,
) -> Result<(Outcome, Option<Ground<'a>>), Error> {
    let Some(bed) = &input.document.bed else {
        return Ok((groundbeam::solve_with(model, options)?, None));
    };
    let found = bed.solve(model, options)?;
    let ground = Ground::of(bed, &found);
    Ok((found.outcome, Some(ground)))
}

/// The loads that grow.
struct Growing {
    /// Names of load cases; none if all loads grow.
    cases: Vec<String>,
    /// In the order of the model's loads.
    grows: Vec<bool>,
}

impl Growing {
    fn of(input: &Input, grow: &Grow, loaded: &Loaded) -> Result<Self, Failure> {
        let Grow::Cases(list) = grow else {
            let grows = vec![true; loaded.loads.len()];
            return Ok(Growing { cases: Vec::new(), grows });
        };
        let of_file = parse_cases(list, &input.document)
            .map_err(|found| Failure::diagnostics(&found, "--factors", list))?;
        let grows = loaded.loads.iter().map(|&load| of_file[load]).collect();
        let mut cases: Vec<String> = Vec::new();
        for name in list.split(',').map(str::trim) {
            if !cases.iter().any(|case| case == name) {
                cases.push(name.to_owned());
            }
        }
        Ok(Growing { cases, grows })
    }

    /// On the ground that was solved.
    fn factors(
        &self,
        input: &Input,
        model: &Model,
        context: &Context,
    ) -> Result<LoadFactors, Failure> {
        let model = context.ground.map_or_else(|| model.clone(), |g| g.subgrade.under(model));
        let grows = |load: usize| self.grows.get(load).is_some_and(|&grows| grows);
        groundbeam::load_factors(&model, grows).map_err(|error| match error {
            Error::NotConverged(reached) => {
                let shown = text::not_converged(&reached, standard_error_has_colour());
                Failure::reported(shown, Status::NotConverged)
            }
            other => input.refused(&other),
        })
    }
}

fn write_files(
    request: &Solve,
    solution: &Solution,
    stations: &[f64],
    context: &Context,
) -> Result<(), Failure> {
    if let Some(path) = &request.csv {
        write(path, csv::table(solution, stations, context.units).as_bytes())?;
    }
    if let Some(path) = &request.history {
        write(path, csv::history(solution).as_bytes())?;
    }
    let plot = request.plot.as_ref();
    draw(plot, || svg::picture(solution, context), || png::picture(solution, context))
}

/// The positions of `--at`, each on the beam.
pub fn positions(input: &Input, list: &str) -> Result<Vec<f64>, Failure> {
    let units = input.document.units;
    let failure = |found: &Diagnostics| Failure::diagnostics(found, "--at", list);
    let positions = parse_positions(list, units).map_err(|found| failure(&found))?;
    let length = input.document.model.beam.length;
    let mut start = 0;
    for (entry, &x) in list.split(',').zip(&positions) {
        if !(0.0..=length).contains(&x) {
            let at = start + entry.len() - entry.trim_start().len();
            let span = at..at + entry.trim().len();
            let (message, hint) = (
                format!("{} lies off the beam", units.length(x)),
                format!(
                    "the beam goes from 0 to {}, measured from its left end",
                    units.length(length)
                ),
            );
            let off = Diagnostic {
                code: "GB301",
                severity: Severity::Error,
                file: None,
                message,
                label: String::new(),
                hint,
                line: 1,
                column: list[..at].chars().count() + 1,
                span,
                related: Vec::new(),
            };
            return Err(failure(&off.into()));
        }
        start += entry.len() + 1;
    }
    Ok(positions)
}
