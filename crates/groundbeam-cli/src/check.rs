//! `groundbeam check`.

use crate::Status;
use crate::combinations;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{print, standard_output_has_colour};
use crate::request::Check;
use crate::trains;
use groundbeam_report::{json, text};
use std::time::Instant;

pub fn run(request: &Check) -> Result<Status, Failure> {
    let input = Input::read(&request.file)?;
    if !input.document.trains.is_empty() {
        return trains::check(&input, request);
    }
    if input.document.has_combinations() {
        return combinations::check(&input, request);
    }
    let model = &input.document.model;
    let started = Instant::now();
    let existence = input.existence(model)?;
    let context = input.context().with_seconds(started.elapsed().as_secs_f64());
    // The verdict is what was asked for: it goes to standard output whatever it is.
    print(&if request.json {
        json::existence(model, &existence, &context)
    } else {
        text::existence(model, &existence, &context, standard_output_has_colour())
    })?;
    Ok(if existence.verdict.stands() { Status::Done } else { Status::NoEquilibrium })
}
