//! Runs the command `groundbeam compare`, which solves one model with every method.

use crate::colour::{standard_error_has_colour, standard_output_has_colour};
use crate::command::Compare;
use crate::failure::Failure;
use crate::host::Threads;
use crate::input::Input;
use crate::output::print;
use crate::status::Status;
use crate::waiting::while_working;
use groundbeam_report::{Results, json, text};
use groundbeam_run::{self as run, Asked, Found, Overall, Run};

pub fn run(request: &Compare) -> Result<Status, Failure> {
    let input = Input::read(&request.file)?.printed(request.printed)?;
    if request.json {
        input.show_warnings();
    }
    let run = Run::of(&input.document);
    if run.asked() != Asked::One {
        let rule = "`compare` needs a single model, but this file has combinations, a train or a band of the ground; \
                    use a file without them";
        return Err(Failure::usage(format!("{}: {rule}", request.file.display())));
    }
    let Compare { elements, most_sweeps, memory_limit, .. } = *request;
    let options = run::Compare { elements, most_sweeps, memory_limit };
    let words = "solving with every method".to_owned();
    let answers = while_working(words, run::Compare::PIECES, |done| {
        run.compare(options, &Threads::new(done))
    });
    let answers = answers.map_err(|error| input.refused(&error))?;
    let colour = standard_error_has_colour();
    let (model, context) = (&input.document.model, input.context());
    let (shown, document) = match &answers.list[0].found {
        Found::NoEquilibrium(existence) => (
            text::existence(model, existence, &context, colour),
            json::existence(model, existence, &context),
        ),
        Found::NotConverged(reached) => {
            (text::not_converged(reached, colour), json::not_converged(reached, &context))
        }
        _ => {
            let results = Results::new(&answers, input.context());
            print(&match request.json {
                true => results.json(None),
                false => results.text(standard_output_has_colour()),
            })?;
            return Ok(match answers.overall() {
                Overall::NotConverged => Status::NotConverged,
                _ => Status::Done,
            });
        }
    };
    let status: Status = answers.list[0].found.overall().into();
    if request.json {
        print(&document)?;
        return Ok(status);
    }
    Err(Failure::reported(shown, status))
}
