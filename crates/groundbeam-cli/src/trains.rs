//! A train that passes over the beam: every position solved, and the envelope of all.

use crate::Status;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{draw, print, standard_output_has_colour, write};
use crate::request::Solve;
use crate::solve::{Loaded, positions};
use crate::waiting::while_working;
use groundbeam::Error;
use groundbeam::train::{Answer, Passage, Sweep};
use groundbeam_file::{Combination, MovingTrain};
use groundbeam_report::{Context, Moving, csv, json, png, svg, text};
use rayon::prelude::*;
use std::time::Instant;

/// The error of the envelope, relative to each field's largest value.
const ERROR: f64 = 1e-3;

/// Sweeps the train over the model and reports the envelope.
pub fn solve(
    input: &Input,
    request: &Solve,
    train: &MovingTrain,
    loaded: &Loaded,
) -> Result<Status, Failure> {
    if let Some(option) = request.about_one_answer() {
        let rule = "it is about one position, and the file has a train";
        return Err(Failure::usage(format!("{option}: {rule}")));
    }
    let stations = request.at.as_deref().map(|list| positions(input, list)).transpose()?;
    let started = Instant::now();
    let words = format!("moving the train with the method {}", request.options.method.name());
    let passage = while_working(words, || swept(request, train, &loaded.combination));
    let passage = passage.map_err(|error| input.refused(&error))?;
    let moving = Moving {
        name: &train.name,
        set: train.set.as_deref(),
        factor: train.factor,
        range: train.range,
        passage: &passage,
    };
    let context = Context { title: loaded.title.as_deref(), ..input.context() };
    let context = context.with_seconds(started.elapsed().as_secs_f64());
    write_files(request, &moving, stations.as_deref(), &context)?;
    print(&if request.json {
        json::train(&moving, stations.as_deref(), &context)
    } else {
        text::train(&moving, &context, standard_output_has_colour())
    })?;
    Ok(status(&passage))
}

fn swept(
    request: &Solve,
    train: &MovingTrain,
    combination: &Combination,
) -> Result<Passage, Error> {
    let mut sweep = Sweep::new(&combination.model, &train.train, train.range, ERROR);
    while !sweep.wanted().is_empty() {
        // Each is solved by itself and kept in its place: the same bits on any number of processors.
        let solved = sweep.wanted().par_iter().map(|&first_axle| {
            let there = train.train.on(&combination.model, first_axle);
            Answer::of(combination.solve_model(&there, &request.options))
        });
        let solved: Vec<Result<Answer, Error>> = solved.collect();
        sweep.give(solved.into_iter().collect::<Result<Vec<Answer>, Error>>()?);
    }
    Ok(sweep.finish())
}

fn status(passage: &Passage) -> Status {
    if !passage.without_equilibrium().is_empty() {
        Status::NoEquilibrium
    } else if passage.not_converged().next().is_some() {
        Status::NotConverged
    } else {
        Status::Done
    }
}

fn write_files(
    request: &Solve,
    moving: &Moving,
    stations: Option<&[f64]>,
    context: &Context,
) -> Result<(), Failure> {
    if moving.passage.solved().next().is_none() {
        return Ok(());
    }
    if let Some(path) = &request.csv {
        let stations = stations.map_or_else(|| moving.default_stations(), <[f64]>::to_vec);
        write(path, csv::train(moving, &stations, context.units).as_bytes())?;
    }
    draw(request.plot.as_ref(), || svg::train(moving, context), || png::train(moving, context))
}
