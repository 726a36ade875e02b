//! Trains that pass over the beam: every position solved, and the envelope of all.

use crate::Status;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{print, standard_output_has_colour};
use crate::request::{Check, Solve};
use crate::solve::Loaded;
use crate::waiting::while_counting;
use groundbeam::Error;
use groundbeam::train::{Answer, Passage, Sweep};
use groundbeam_file::{Combination, MovingTrain};
use groundbeam_report::{CheckedTrain, Context, Found, Ground, Moving, Passages, json, text};
use rayon::prelude::*;
use std::time::Instant;

/// The error of the envelope, relative to each field's largest value.
const ERROR: f64 = 1e-3;

/// Moves every train over every combination and hands on what was found.
pub fn solved<T>(
    input: &Input,
    request: &Solve,
    all: &Loaded,
    deliver: impl FnOnce(&Found, &Context) -> Result<T, Failure>,
) -> Result<T, Failure> {
    if let Some(option) = request.about_one_answer() {
        let rule = "it is about one position, and the file has a train";
        return Err(Failure::usage(format!("{option}: {rule}")));
    }
    let started = Instant::now();
    let ways = ways(input, all);
    let words = format!("moving trains with the method {}", request.options.method.name());
    let swept: Result<Vec<Passage>, Error> =
        while_counting(words, ways.len(), request.audience, |another| {
            let passages = ways.iter().map(|way| {
                let passage = way.swept(request)?;
                another();
                Ok(passage)
            });
            passages.collect()
        });
    let swept = swept.map_err(|error| input.refused(&error))?;
    let passages = Passages { all: ways.iter().zip(&swept).map(Way::moving).collect() };
    let context = Context { title: all.title.as_deref(), ..input.context() };
    let context = context.with_seconds(started.elapsed().as_secs_f64());
    let ground = all.combinations.first().and_then(|first| match &first.bed {
        Some(bed) => Some(Ground::before(bed, &first.model.beam)),
        None => Ground::of_area(&first.model.foundation, input.document.width?),
    });
    let context = Context { ground, ..context };
    deliver(&Found::Trains(&passages), &context)
}

/// Tells of every train and combination where on its way there is no equilibrium.
pub fn check(input: &Input, request: &Check) -> Result<Status, Failure> {
    let all = Loaded::all(input);
    let started = Instant::now();
    let checked = ways(input, &all).into_iter().map(|way| {
        let MovingTrain { name, train, range, .. } = way.train;
        let without_equilibrium = train
            .without_equilibrium(&way.combination.model, *range)
            .map_err(|error| input.refused(&error))?;
        Ok(CheckedTrain { combination: way.named(), name, range: *range, without_equilibrium })
    });
    let checked = checked.collect::<Result<Vec<CheckedTrain>, Failure>>()?;
    let context = input.context().with_seconds(started.elapsed().as_secs_f64());
    print(&if request.json {
        json::checked_trains(&checked, &context)
    } else {
        text::checked_trains(&checked, &context, standard_output_has_colour())
    })?;
    let falls = checked.iter().any(|train| !train.without_equilibrium.is_empty());
    Ok(if falls { Status::NoEquilibrium } else { Status::Done })
}

/// A train under a combination.
struct Way<'a> {
    combination: &'a Combination,
    train: &'a MovingTrain,
}

fn ways<'a>(input: &'a Input, all: &'a Loaded) -> Vec<Way<'a>> {
    let of = |combination: &'a Combination| {
        input.document.trains.iter().map(move |train| Way { combination, train })
    };
    all.combinations.iter().flat_map(of).collect()
}

impl<'a> Way<'a> {
    fn swept(&self, request: &Solve) -> Result<Passage, Error> {
        let Way { combination, train: MovingTrain { train, range, .. } } = self;
        let mut sweep = Sweep::new(&combination.model, train, *range, ERROR);
        while !sweep.wanted().is_empty() {
            // Each is solved by itself, from a neighbour of the rounds before, and kept in its place: the same bits on
            // any number of processors.
            let solved = sweep.wanted().par_iter().map(|&first_axle| {
                let there = train.on(&combination.model, first_axle);
                let near = sweep.near(first_axle);
                Answer::of(combination.solve_near(&there, &request.options, near))
            });
            let solved: Vec<Result<Answer, Error>> = solved.collect();
            sweep.give(solved.into_iter().collect::<Result<Vec<Answer>, Error>>()?);
        }
        Ok(sweep.finish())
    }

    /// The combination's name, if it has one.
    fn named(&self) -> Option<&'a str> {
        Some(&*self.combination.name).filter(|name| !name.is_empty())
    }

    fn moving((way, passage): (&Way<'a>, &'a Passage)) -> Moving<'a> {
        let MovingTrain { name, set, factor, range, .. } = way.train;
        Moving {
            combination: way.named(),
            name,
            set: set.as_deref(),
            factor: *factor,
            range: *range,
            passage,
        }
    }
}
