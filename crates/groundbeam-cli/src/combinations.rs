//! All combinations of a file: solved or checked, one by one.

use crate::Status;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{print, standard_output_has_colour};
use crate::request::{Check, Solve};
use crate::solve::solved_one;
use crate::waiting::while_counting;
use groundbeam::{Error, Existence, Outcome};
use groundbeam_file::{Combination, LoadCase};
use groundbeam_report::{
    Alone, Answer, Combinations, Combined, Context, Found, Ground, json, text,
};
use rayon::prelude::*;
use std::time::Instant;

/// Solves every combination and hands on what was found of all together.
pub fn solved<T>(
    input: &Input,
    request: &Solve,
    combinations: &[Combination],
    deliver: impl FnOnce(&Found, &Context) -> Result<T, Failure>,
) -> Result<T, Failure> {
    if let Some(option) = request.about_one_answer() {
        let rule = "of a file with combinations it is about one of them";
        return Err(Failure::usage(format!("{option}: {rule}; add --combination NAME")));
    }
    let started = Instant::now();
    let words = format!("solving combinations with the method {}", request.options.method.name());
    // Each is solved by itself and kept in its place: the same bits on any number of processors.
    let outcomes: Vec<Result<(Outcome, Option<Ground>), Error>> =
        while_counting(words, combinations.len(), request.audience, |another| {
            let solved = combinations.par_iter().map(|combination| {
                let outcome = solved_one(input, combination, &request.options);
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
    deliver(&Found::Combinations(&all), &context)
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
    Ok(all.overall().into())
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
