//! Runs the command `groundbeam solve`, which solves a model and writes its results.

use crate::colour::{standard_error_has_colour, standard_output_has_colour};
use crate::command::Solve;
use crate::distinct;
use crate::failure::Failure;
use crate::host::solved;
use crate::input::Input;
use crate::output::{draw, print, report, standard_output_is_a_terminal, write};
use crate::status::Status;
use crate::verify::prove;
use groundbeam::proof::Document;
use groundbeam_file::{Combination, parse_cases, parse_positions_on_beam};
use groundbeam_report::{Context, Named, Results, csv, json, text};
use groundbeam_run::{Answer, Asked, Found, Growing, Run};
use std::path::Path;

pub fn run(request: &Solve) -> Result<Status, Failure> {
    let input = Input::read(&request.file)?.printed(request.printed)?;
    if request.json {
        input.show_warnings();
    }
    let files = input.document.files.iter().map(|file| Path::new(&file.name));
    distinct::check(request.outputs(), files.chain([request.file.as_path()]))?;
    let stations = request.at.as_deref().map(|list| {
        parse_positions_on_beam(list, &input.document)
            .map_err(|found| Failure::diagnostics(&found, "--at", list))
    });
    let stations = stations.transpose()?;
    let (run, title) = asked(&input, request)?;
    let (answers, seconds) = solved(&run, &input, request.method.name())?;
    let context = Context {
        title: title.as_deref(),
        pieces: request.includes_pieces(),
        selected: request.combination.is_some() || request.set.is_some(),
        ..input.context()
    };
    let model = request.includes_pieces() && input.is_not_proven_as_written();
    let context = Context { model, ..context.with_seconds(seconds) };
    let stations = stations.as_deref();
    let proofs = match request.proven {
        true => proven(&Results::new(&answers, context), &input, stations)?,
        false => Vec::new(),
    };
    let context = Context { proofs: &proofs, ..context };
    let results = Results::new(&answers, context);
    let status = deliver(&results, &input, request, stations)?;
    let all = proofs.iter().all(Named::is_proven) && !results.has_undecided_check();
    let fails = request.strict && results.has_failed_check();
    Ok(match (status, all, fails) {
        (Status::Done, false, _) => Status::NotProven,
        (Status::Done, true, true) => Status::CheckFailed,
        _ => status,
    })
}

/// Proves each solution in the result document. Without `stations`, combinations are proven at all positions of the
/// envelope.
fn proven(
    results: &Results,
    input: &Input,
    stations: Option<&[f64]>,
) -> Result<Vec<Named>, Failure> {
    if !results.has_fields() {
        return Ok(Vec::new());
    }
    let of_envelope = json::envelope_stations(results.answers());
    let stations = match (results.one(), stations) {
        (None, None) => Some(&of_envelope[..]),
        _ => stations,
    };
    let documents = Document::read(&results.json(stations))
        .map_err(|error| Failure::usage(format!("the result document: {error}")))?;
    documents.iter().map(|document| prove(input.text(), input.name(), document)).collect()
}

/// Returns the models to solve, and the title of the results.
fn asked(input: &Input, request: &Solve) -> Result<(Run, Option<String>), Failure> {
    let document = &input.document;
    let (run, title) = match (&request.combination, &request.set) {
        (None, Some(name)) => {
            let combinations = document
                .combinations_of_set(name)
                .map_err(|found| Failure::diagnostics(&found, "--set", name))?;
            (Run::of_some(document, combinations), document.title.clone())
        }
        (Some(name), _) => {
            let combination = document
                .combination(name)
                .map_err(|found| Failure::diagnostics(&found, "--combination", name))?;
            let title = Some(document.title_of(&combination));
            (Run::of_one(document, combination), title)
        }
        (None, None) => (Run::of(document), document.title.clone()),
    };
    if let Some(option) = request.about_one_answer() {
        let rule = match run.asked() {
            Asked::One | Asked::Methods => None,
            Asked::Trains => Some(
                "this option needs a single load position, but the file has a train; omit the option",
            ),
            Asked::Combinations => {
                Some("this option applies to one combination of the file; add --combination NAME")
            }
        };
        if let Some(rule) = rule {
            return Err(Failure::usage(format!("{option}: {rule}")));
        }
    }
    if request.includes_pieces() && run.asked() == Asked::Trains {
        let (option, rule) = match request.proven {
            true => ("--proven", "results for train positions cannot be proven; omit this option"),
            false => (
                "--pieces",
                "the document for a train contains no piecewise polynomials; omit this option",
            ),
        };
        return Err(Failure::usage(format!("{option}: {rule}")));
    }
    let growing = match (&request.factors, run.combinations()) {
        (Some(cases), [combination, ..]) => Some(growing(input, cases.as_deref(), combination)?),
        _ => None,
    };
    Ok((run.with_options(request.options()).with_growing(growing), title))
}

/// Returns the loads that the load factor multiplies: the loads of the listed cases, or all loads if no case is
/// listed.
fn growing(
    input: &Input,
    cases: Option<&str>,
    combination: &Combination,
) -> Result<Growing, Failure> {
    let Some(list) = cases else { return Ok(Growing::all(combination)) };
    let cases = parse_cases(list, &input.document)
        .map_err(|found| Failure::diagnostics(&found, "--factors", list))?;
    Ok(Growing::of_cases(cases, &input.document, combination))
}

/// Writes the results to the requested outputs and returns the exit status.
fn deliver(
    results: &Results,
    input: &Input,
    request: &Solve,
    stations: Option<&[f64]>,
) -> Result<Status, Failure> {
    let one = results.one();
    let solution = one.and_then(Answer::solution);
    if results.has_fields() {
        if let Some(path) = &request.csv {
            write(path, results.csv(stations).as_bytes())?;
        }
        if let (Some(path), Some(solution)) = (&request.history, solution) {
            write(path, csv::history(solution).as_bytes())?;
        }
        draw(request.plot.as_ref(), || results.picture())?;
    }
    report(request.report.as_ref(), request.paper, results, input)?;
    let status = results.answers().overall().into();
    if request.json {
        print(&results.json(stations))?;
        return Ok(status);
    }
    let failed =
        |answer: &Answer| matches!(answer.found, Found::NoEquilibrium(_) | Found::NotConverged(_));
    if one.is_some_and(failed) {
        return Err(Failure::reported(results.text(standard_error_has_colour()), status));
    }
    let colour = standard_output_has_colour();
    print(&results.text(colour))?;
    if let Some(solution) = solution
        && !request.no_drawing
        && standard_output_is_a_terminal()
    {
        print(&format!("\n{}", text::drawing(solution, results.context().units, colour)))?;
    }
    Ok(status)
}
