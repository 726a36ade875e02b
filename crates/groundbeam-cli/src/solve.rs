//! `groundbeam solve`.

use crate::Status;
use crate::combinations;
use crate::distinct;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{
    draw, print, report, standard_error_has_colour, standard_output_has_colour,
    standard_output_is_a_terminal, write,
};
use crate::request::{Grow, Solve};
use crate::trains;
use crate::waiting::while_working;
use groundbeam::{Error, Load, LoadFactors, Model, Options, Outcome};
use groundbeam_file::{
    Combination, Diagnostic, Diagnostics, Severity, parse_cases, parse_positions,
};
use groundbeam_report::{Context, Factors, Found, Ground, csv, text};
use std::path::Path;
use std::time::Instant;

pub fn run(request: &Solve) -> Result<Status, Failure> {
    let input = Input::read(&request.file)?;
    let files = input.document.files.iter().map(|file| Path::new(&file.name));
    distinct::check(request.outputs(), files.chain([request.file.as_path()]))?;
    let stations = request.at.as_deref().map(|list| positions(&input, list)).transpose()?;
    let stations = stations.as_deref();
    answered(&input, request, |found, context| deliver(found, &input, request, stations, context))
}

/// Solves what the file asks for, and hands on what was found.
pub fn answered<T>(
    input: &Input,
    request: &Solve,
    deliver: impl FnOnce(&Found, &Context) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let loaded = match &request.combination {
        Some(name) => Loaded::combined(input, name)?,
        None => Loaded::all(input),
    };
    if !input.document.trains.is_empty() {
        return trains::solved(input, request, &loaded, deliver);
    }
    let of_several = request.combination.is_none() && input.document.has_combinations();
    match &loaded.combinations[..] {
        [alone] if !of_several => one(input, request, alone, loaded.title.as_deref(), deliver),
        several => combinations::solved(input, request, several, deliver),
    }
}

/// Writes what was found where it was asked for.
fn deliver(
    found: &Found,
    input: &Input,
    request: &Solve,
    stations: Option<&[f64]>,
    context: &Context,
) -> Result<Status, Failure> {
    if found.has_fields() {
        if let Some(path) = &request.csv {
            write(path, found.csv(stations, context).as_bytes())?;
        }
        if let (Some(path), Found::Equilibrium(solution)) = (&request.history, found) {
            write(path, csv::history(solution).as_bytes())?;
        }
        draw(request.plot.as_ref(), || found.svg(context), || found.png(context))?;
    }
    report(request.report.as_ref(), found, context, input)?;
    if request.json {
        print(&found.json(stations, context))?;
        return Ok(found.overall().into());
    }
    if matches!(found, Found::NoEquilibrium(..) | Found::NotConverged(..)) {
        let shown = found.text(context, standard_error_has_colour());
        return Err(Failure::reported(shown, found.overall().into()));
    }
    let colour = standard_output_has_colour();
    print(&found.text(context, colour))?;
    if let Found::Equilibrium(solution) = found
        && request.drawing
        && standard_output_is_a_terminal()
    {
        print(&format!("\n{}", text::drawing(solution, context.units, colour)))?;
    }
    Ok(found.overall().into())
}

/// What is to be solved, and what it is called.
pub struct Loaded {
    pub title: Option<String>,
    pub combinations: Vec<Combination>,
}

impl Loaded {
    /// All combinations of the file; one that has none is itself one.
    pub fn all(input: &Input) -> Self {
        let document = &input.document;
        Loaded { title: document.title.clone(), combinations: document.wanted() }
    }

    /// One of the file's combinations.
    fn combined(input: &Input, name: &str) -> Result<Self, Failure> {
        let combination = input
            .document
            .combination(name)
            .map_err(|found| Failure::diagnostics(&found, "--combination", name))?;
        let title = match &input.document.title {
            Some(title) => format!("{title}: {}", combination.name),
            None => combination.name.clone(),
        };
        Ok(Loaded { title: Some(title), combinations: vec![combination] })
    }
}

fn one<T>(
    input: &Input,
    request: &Solve,
    combination: &Combination,
    title: Option<&str>,
    deliver: impl FnOnce(&Found, &Context) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let model = &combination.model;
    let growing =
        request.factors.as_ref().map(|grow| Growing::of(input, grow, combination)).transpose()?;

    let started = Instant::now();
    let words = format!("solving with the method {}", request.options.method.name());
    let outcome =
        while_working(words, request.audience, || solved_one(input, combination, &request.options));
    let context = Context { title, ..input.context() };
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
        Ok(Outcome::Equilibrium(solution)) => deliver(&Found::Equilibrium(&solution), &context),
        Ok(Outcome::NoEquilibrium(existence)) => {
            deliver(&Found::NoEquilibrium(model, &existence), &context)
        }
        Err(Error::NotConverged(reached)) => {
            deliver(&Found::NotConverged(model, &reached), &context)
        }
        Err(other) => Err(input.refused(&other)),
    }
}

/// What mechanics says of a combination of the file, and where its ground comes from.
pub fn solved_one<'a>(
    input: &Input,
    combination: &'a Combination,
    options: &Options,
) -> Result<(Outcome, Option<Ground<'a>>), Error> {
    let model = &combination.model;
    let Some(bed) = &combination.bed else {
        let ground = input.document.width.and_then(|b| Ground::of_area(&model.foundation, b));
        return Ok((groundbeam::solve_with(model, options)?, ground));
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
    fn of(input: &Input, grow: &Grow, combination: &Combination) -> Result<Self, Failure> {
        let Grow::Cases(list) = grow else {
            let grows = vec![true; combination.loads.len()];
            return Ok(Growing { cases: Vec::new(), grows });
        };
        let of_file = parse_cases(list, &input.document)
            .map_err(|found| Failure::diagnostics(&found, "--factors", list))?;
        let grows = combination.loads.iter().map(|&load| of_file[load]).collect();
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
        let on_soil = context.ground.filter(|ground| ground.bed.is_some());
        let model = on_soil.map_or_else(|| model.clone(), |g| g.subgrade.under(model));
        // Without a case named, loads on the beam grow: a temperature or a camber stays what it is, and so do
        // neighbours on the ground.
        let stays = |load: usize| {
            let load = model.loads.get(load);
            let curls = matches!(load, Some(Load::Curvature { .. }));
            self.cases.is_empty() && (curls || load.is_some_and(Load::is_on_ground))
        };
        let grows = |load: usize| self.grows.get(load).is_some_and(|&grows| grows && !stays(load));
        groundbeam::load_factors(&model, grows).map_err(|error| match error {
            Error::NotConverged(reached) => {
                let shown = text::not_converged(&reached, standard_error_has_colour());
                Failure::reported(shown, Status::NotConverged)
            }
            other => input.refused(&other),
        })
    }
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
