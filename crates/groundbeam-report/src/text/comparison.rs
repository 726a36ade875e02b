//! Writes the terminal report of a comparison of methods, with one row per method.

use super::sheet::Sheet;
use super::title;
use crate::context::Context;
use crate::number::order;
use crate::quantity::duration;
use groundbeam::{Error, Field, Solution};
use groundbeam_run::{Answer, Answers, Errors, Found};

/// The report of the results of several methods. The first method is exact. `colour` adds escape codes for a
/// terminal.
pub fn comparison(answers: &Answers, context: &Context, colour: bool) -> String {
    let mut sheet = Sheet::new(colour);
    title(&mut sheet, context);
    sheet.heading(&line("", ["error of", "", "", "", "energy", "", ""]));
    let [w, m, u] = [Field::Deflection, Field::Moment, Field::Settlement].map(Field::symbol);
    let heads = [w, m, u, "ends", "gap", "steps", "time"];
    sheet.heading(&line("method", heads));
    let exact = answers.list.first().and_then(Answer::solution);
    let mut failures = Vec::new();
    for (i, Answer { label, found, seconds, .. }) in answers.list.iter().enumerate() {
        let name = label.method;
        let (why, time) = match found {
            Found::Equilibrium(solution) => {
                let errors = exact.filter(|_| i > 0).map(|exact| Errors::of(solution, exact));
                sheet.line(&of(name, solution, errors, *seconds));
                continue;
            }
            Found::Unsolved(Error::Unsupported(problem)) => {
                (problem.message.clone(), String::new())
            }
            Found::Unsolved(Error::TooLarge(refused)) => {
                (refused.problem.message.clone(), String::new())
            }
            Found::Unsolved(error) => (error.to_string(), duration(*seconds)),
            Found::NotConverged(reached) => (reached.to_string(), duration(*seconds)),
            Found::Exists(_) | Found::NoEquilibrium(_) => continue,
        };
        sheet.line(&line(name, ["none", "", "", "", "", "", &time]));
        failures.push(format!("{name}: {why}"));
    }
    sheet.blank();
    for (i, failure) in failures.iter().enumerate() {
        sheet.row(if i == 0 { "Not solved" } else { "" }, failure);
    }
    let words = "largest difference from exact along the beam, relative to the largest value; end forces: \
                 relative to the resultant";
    sheet.row("Errors", words);
    let words = "the error bound of each result, from its certificate";
    sheet.row("Energy gap", words);
    sheet.finish()
}

fn of(name: &str, solution: &Solution, errors: Option<Errors>, seconds: f64) -> String {
    let gap = order(solution.certificate().relative_gap());
    let steps = solution.iterations().to_string();
    let errors = errors.map_or([const { String::new() }; 4], |errors| {
        [errors.deflection, errors.moment, errors.settlement, errors.end_forces].map(order)
    });
    let [w, m, u, ends] = &errors;
    line(name, [w, m, u, ends, &gap, &steps, &duration(seconds)])
}

fn line(name: &str, cells: [&str; 7]) -> String {
    let cells: String = cells.iter().map(|cell| format!("{cell:>8}")).collect();
    format!("{name:<21}{cells}").trim_end().to_owned()
}
