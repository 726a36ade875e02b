//! `groundbeam compare`.

use crate::Status;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{print, standard_error_has_colour, standard_output_has_colour};
use crate::request::Compare;
use crate::solve::solved_one;
use crate::waiting::{Audience, while_working};
use groundbeam::{Error, Method, Options, Outcome, Pressure, Solution};
use groundbeam_report::{Compared, Comparison, Context, json, text};
use std::time::Instant;

/// The methods that are held against `exact`.
const OTHERS: [(&str, Method, Pressure); 4] = [
    ("active-set", Method::ActiveSet, Pressure::Distributed),
    ("active-set, dirac", Method::ActiveSet, Pressure::Dirac),
    ("psor", Method::Psor, Pressure::Dirac),
    ("uzawa", Method::Uzawa, Pressure::Dirac),
];

pub fn run(request: &Compare) -> Result<Status, Failure> {
    let input = Input::read(&request.file)?;
    let document = &input.document;
    if !document.trains.is_empty() || document.has_combinations() {
        let rule = "methods are compared on one model, and this file has combinations or a train";
        return Err(Failure::usage(format!("{}: {rule}", request.file.display())));
    }
    let as_written = document.as_written();
    let timed = |name: &str, options: Options| {
        let started = Instant::now();
        let words = format!("solving with the method {name}");
        let outcome =
            while_working(words, Audience::Caller, || solved_one(&input, &as_written, &options));
        (outcome.map(|(outcome, _)| outcome), started.elapsed().as_secs_f64())
    };
    let memory_limit = request.memory_limit;
    let (outcome, seconds) = timed("exact", Options { memory_limit, ..Options::default() });
    let context = input.context();
    let exact = match outcome {
        Ok(Outcome::Equilibrium(solution)) => solution,
        Ok(Outcome::NoEquilibrium(existence)) => {
            let colour = standard_error_has_colour();
            let shown = text::existence(&as_written.model, &existence, &context, colour);
            return Err(Failure::reported(shown, Status::NoEquilibrium));
        }
        Err(error) => return Err(refused(&input, &error)),
    };
    let mut answers: Vec<(&str, Result<Box<Solution>, Error>, f64)> = Vec::new();
    for (name, method, pressure) in OTHERS {
        let (elements, most_sweeps) = (request.elements, request.most_sweeps);
        let options =
            Options { method, pressure, elements, most_sweeps, memory_limit, ..Options::default() };
        match timed(name, options) {
            (Ok(Outcome::Equilibrium(solution)), seconds) => {
                answers.push((name, Ok(solution), seconds));
            }
            (Err(error @ Error::Invalid(_)), _) => return Err(refused(&input, &error)),
            (Err(error), seconds) => answers.push((name, Err(error), seconds)),
            // Existence is decided before any method.
            (Ok(Outcome::NoEquilibrium(_)), _) => {}
        }
    }
    let others = answers.iter().map(|(name, answer, seconds)| Compared {
        name,
        answer: answer.as_deref(),
        seconds: *seconds,
    });
    shown(&Comparison { exact: &exact, seconds, others: others.collect() }, &context, request)
}

fn shown(found: &Comparison, context: &Context, request: &Compare) -> Result<Status, Failure> {
    print(&if request.json {
        json::comparison(found, context)
    } else {
        text::comparison(found, context, standard_output_has_colour())
    })?;
    let stopped = |other: &Compared| matches!(other.answer, Err(Error::NotConverged(_)));
    let stopped = found.others.iter().any(stopped);
    Ok(if stopped { Status::NotConverged } else { Status::Done })
}

fn refused(input: &Input, error: &Error) -> Failure {
    match error {
        Error::NotConverged(reached) => {
            let shown = text::not_converged(reached, standard_error_has_colour());
            Failure::reported(shown, Status::NotConverged)
        }
        other => input.refused(other),
    }
}
