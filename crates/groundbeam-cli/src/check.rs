//! Runs the command `groundbeam check`, which decides whether an equilibrium exists.

use crate::colour::standard_output_has_colour;
use crate::command::Check;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::print;
use crate::status::Status;
use groundbeam_report::Results;
use groundbeam_run::Run;
use std::time::Instant;

pub fn run(request: &Check) -> Result<Status, Failure> {
    let input = Input::read(&request.file)?.printed(request.printed)?;
    if request.json {
        input.show_warnings();
    }
    let started = Instant::now();
    let answers = Run::of(&input.document).check().map_err(|error| input.refused(&error))?;
    let context = input.context().with_seconds(started.elapsed().as_secs_f64());
    let results = Results::new(&answers, context);
    // The verdict is the result of this command, so it is printed on standard output even if no equilibrium exists.
    print(&match request.json {
        true => results.json(None),
        false => results.text(standard_output_has_colour()),
    })?;
    Ok(answers.overall().into())
}
