//! `groundbeam study` and `groundbeam merge`

use crate::Status;
use crate::failure::Failure;
use crate::input::units;
use crate::output::{draw, print, standard_error_has_colour, standard_output_has_colour};
use crate::request::{Merge, Study};
use groundbeam_file::study::{StudyError, read_study};
use groundbeam_report::{Context, json, png, svg, text};
use groundbeam_study::{Draws, Finished, Progress, Shard, StoreError};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How long nothing is shown.
const PATIENCE: Duration = Duration::from_secs(1);

/// Runs what of a study is left, and says what follows from it.
pub fn run(request: &Study) -> Result<Status, Failure> {
    let draws = read(request)?;
    let stop = Arc::new(AtomicBool::new(false));
    let pressed = Arc::clone(&stop);
    let handled = ctrlc::set_handler(move || {
        if pressed.swap(true, Ordering::Relaxed) {
            // Pressed twice: at once.
            std::process::exit(i32::from(Status::Interrupted as u8));
        }
    });
    handled.map_err(|error| Failure::usage(error.to_string()))?;
    let begun = Instant::now();
    let mut bar = Bar::new(begun);
    let finished = groundbeam_study::run(
        &draws,
        &request.out,
        request.shard,
        request.restart,
        request.threads,
        &mut |progress| {
            bar.show(progress);
            match stop.load(Ordering::Relaxed) {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        },
    );
    bar.end();
    let solved = match finished.map_err(|error| failed(&error))? {
        Finished::Whole(solved) => solved,
        Finished::Stopped(Progress { done, of, .. }) => {
            let out = request.out.display();
            let said = format!(
                "stopped: {done} of {of} samples are kept; the same command goes on with {out}\n"
            );
            return Err(Failure::reported(said, Status::Interrupted));
        }
    };
    if request.shard != Shard::WHOLE {
        return shard(request, &draws);
    }
    let seconds = (solved == draws.plan().samples).then(|| begun.elapsed().as_secs_f64());
    let summary =
        groundbeam_study::summary(&draws, &request.out).map_err(|error| failed(&error))?;
    let units = units(draws.study().document.units);
    let context = Context { seconds, ..Context::new(units) };
    let (svg, png) = (|| svg::study(&summary, &context), || png::study(&summary, &context));
    draw(request.plot.as_ref(), svg, png)?;
    print(&match request.json {
        true => json::study(&summary, &context),
        false => text::study(&summary, &context, standard_output_has_colour()),
    })?;
    Ok(Status::Done)
}

/// Puts shards together.
pub fn merge(request: &Merge) -> Result<Status, Failure> {
    let merged = groundbeam_study::merge(&request.files, &request.out);
    let merged = merged.map_err(|error| failed(&error))?;
    print(&format!(
        "{} samples of {} files in {}\n",
        merged.samples,
        merged.files,
        request.out.display()
    ))?;
    Ok(Status::Done)
}

/// The samples of the file, under what was typed.
fn read(request: &Study) -> Result<Draws, Failure> {
    let study = read_study(&request.file).map_err(|error| match error {
        StudyError::Unreadable(path, error) => Failure::file(&path, &error),
        StudyError::Wrong(found, path, text) => {
            Failure::diagnostics(&found, &path.display().to_string(), &text)
        }
    })?;
    let plan = study.plan.with(request.samples, request.seed);
    Draws::new(study, plan).map_err(|error| Failure::file(&request.file, &error))
}

fn shard(request: &Study, draws: &Draws) -> Result<Status, Failure> {
    let Shard { number, of } = request.shard;
    let samples = request.shard.samples(draws.plan().samples);
    let out = request.out.display();
    if request.json {
        let (first, end) = (samples.start, samples.end);
        print(&format!(
            "{{\"status\":\"done\",\"shard\":{number},\"of\":{of},\"from\":{first},\"to\":{end}}}\n"
        ))?;
    } else {
        print(&format!(
            "shard {number} of {of}: samples {} to {} in {out}\n\
             when all are done: groundbeam merge SHARDS --out ALL, then the study itself with --out ALL\n",
            samples.start,
            samples.end.saturating_sub(1),
        ))?;
    }
    Ok(Status::Done)
}

fn failed(error: &StoreError) -> Failure {
    Failure::usage(error.to_string())
}

/// How far it is, for whoever waits at a terminal.
struct Bar {
    begun: Instant,
    drawn: Option<ProgressBar>,
    wanted: bool,
}

impl Bar {
    fn new(begun: Instant) -> Self {
        Bar { begun, drawn: None, wanted: std::io::stderr().is_terminal() }
    }

    fn show(&mut self, progress: Progress) {
        if !self.wanted || self.begun.elapsed() < PATIENCE {
            return;
        }
        let bar = self.drawn.get_or_insert_with(|| {
            let bar = ProgressBar::new(progress.of);
            let template = match standard_error_has_colour() {
                true => "{bar:24.cyan} {human_pos} of {human_len}, {per_sec}, {eta} left",
                false => "{bar:24} {human_pos} of {human_len}, {per_sec}, {eta} left",
            };
            let style = ProgressStyle::with_template(template);
            let bar = bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
            // The rate is that of now: what earlier runs did counts as done but took no time.
            bar.set_position(progress.before);
            bar.reset_eta();
            bar
        });
        bar.set_position(progress.done);
    }

    fn end(self) {
        if let Some(bar) = self.drawn {
            bar.finish_and_clear();
        }
    }
}
