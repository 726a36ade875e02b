//! All combinations of a file: solved or checked, one by one.

use crate::Status;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{draw, print, standard_output_has_colour, write};
use crate::request::{Check, Solve};
use crate::solve::{positions, solved};
use crate::waiting::while_counting;
use groundbeam::{Error, Existence, Outcome};
use groundbeam_file::{Combination, LoadCase};
use groundbeam_report::{
    Alone, Answer, Combinations, Combined, Context, Ground, Overall, csv, json, png, svg, text,
};
use rayon::prelude::*;
use std::time::Instant;

/// Solves every combination and reports them together.
pub fn solve(input: &Input, request: &Solve) -> Result<Status, Failure> {
    if let Some(option) = request.about_one_answer() {
        let rule = "of a file with combinations it is about one of them";
        return Err(Failure::usage(format!("{option}: {rule}; add --combination NAME")));
    }
    let stations = request.at.as_deref().map(|list| positions(input, list)).transpose()?;
    let combinations = input.document.combinations();
    let started = Instant::now();
    let words = format!("solving combinations with the method {}", request.options.method.name());
    // Each is solved by itself and kept in its place: the same bits on any number of processors.
    let outcomes: Vec<Result<(Outcome, Option<Ground>), Error>> =
        while_counting(words, combinations.len(), |another| {
            let solved = combinations.par_iter().map(|combination| {
                let outcome = solved(input, combination, &request.options);
                another();
                outcome
            });
            solved.collect()
        });
    let alone = alone(input)?;
    let mut combined = Vec::new();
    for (combination, outcome) in combinations.iter().zip(&outcomes) {
        let ground = outcome.as_ref().ok().and_then(|(_, ground)| *ground);
        let answer = match outcome {
            Ok((Outcome::Equilibrium(solution), _)) => Answer::Equilibrium(solution),
            Ok((Outcome::NoEquilibrium(existence), _)) => Answer::NoEquilibrium(existence),
            Err(Error::NotConverged(reached)) => Answer::NotConverged(reached),
            Err(error) => return Err(input.refused(error)),
        };
        combined.push(Combined { ground, ..together(combination, answer) });
    }
    let all = Combinations { combined, alone: alone.iter().map(Case::of).collect() };
    let context = input.context().with_seconds(started.elapsed().as_secs_f64());
    write_files(request, &all, stations.as_deref(), &context)?;
    print(&if request.json {
        json::combinations(&all, stations.as_deref(), &context)
    } else {
        text::combinations(&all, &context, standard_output_has_colour())
    })?;
    Ok(status(&all))
}

/// Tells of every combination whether it has an equilibrium.
pub fn check(input: &Input, request: &Check) -> Result<Status, Failure> {
    let combinations = input.document.combinations();
    let started = Instant::now();
    let checked: Result<Vec<Existence>, Failure> =
        combinations.iter().map(|combination| input.existence(&combination.model)).collect();
    let checked = checked?;
    let alone = alone(input)?;
    let combined = combinations.iter().zip(&checked);
    let all = Combinations {
        combined: combined.map(|(c, existence)| together(c, answered(existence))).collect(),
        alone: alone.iter().map(Case::of).collect(),
    };
    let context = input.context().with_seconds(started.elapsed().as_secs_f64());
    print(&if request.json {
        json::checked_combinations(&all, &context)
    } else {
        text::combinations(&all, &context, standard_output_has_colour())
    })?;
    Ok(status(&all))
}

fn answered(existence: &Existence) -> Answer<'_> {
    if existence.verdict.stands() {
        Answer::Exists(existence)
    } else {
        Answer::NoEquilibrium(existence)
    }
}

/// A load case by itself, and whether it could stand.
struct Case {
    case: LoadCase,
    existence: Existence,
}

impl Case {
    fn of(&self) -> Alone<'_> {
        let LoadCase { name, model } = &self.case;
        Alone { name, model, existence: &self.existence }
    }
}

fn alone(input: &Input) -> Result<Vec<Case>, Failure> {
    let check = |case: LoadCase| {
        let existence = input.existence(&case.model)?;
        Ok(Case { case, existence })
    };
    input.document.load_cases().into_iter().map(check).collect()
}

fn together<'a>(combination: &'a Combination, answer: Answer<'a>) -> Combined<'a> {
    let Combination { name, factors, model, ground: band, .. } = combination;
    Combined { name, factors, model, band: *band, ground: None, answer }
}

fn status(all: &Combinations) -> Status {
    match all.overall() {
        Overall::Solved => Status::Done,
        Overall::NoEquilibrium => Status::NoEquilibrium,
        Overall::NotConverged => Status::NotConverged,
    }
}

fn write_files(
    request: &Solve,
    all: &Combinations,
    stations: Option<&[f64]>,
    context: &Context,
) -> Result<(), Failure> {
    if all.solved().next().is_none() {
        return Ok(());
    }
    if let Some(path) = &request.csv {
        let stations = stations.map_or_else(|| json::envelope_stations(all), <[f64]>::to_vec);
        write(path, csv::envelope(all, &stations, context.units).as_bytes())?;
    }
    let plot = request.plot.as_ref();
    draw(plot, || svg::combinations(all, context), || png::combinations(all, context))
}
