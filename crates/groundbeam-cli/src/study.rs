//! Runs the commands `groundbeam study` and `groundbeam merge`.

use crate::colour::{standard_error_has_colour, standard_output_has_colour};
use crate::command::{Merge, Study};
use crate::distinct;
use crate::failure::Failure;
use crate::output::{draw, print};
use crate::status::Status;
use crate::waiting::PROGRESS_DELAY;
use groundbeam_file::output::Target;
use groundbeam_file::printable;
use groundbeam_file::study::{StudyError, read_study};
use groundbeam_report::{Context, json, svg, text};
use groundbeam_study::{Draws, Finished, Progress, Shard, Stage, StoreError};
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// Solves the remaining samples of a study and prints its summary.
pub fn run(request: &Study) -> Result<Status, Failure> {
    let draws = read(request)?;
    let files = draws.study().files();
    distinct::check(request.outputs(), files.iter().map(|file| Path::new(&file.name)))?;
    let units = request.printed.units(draws.study().document.printed)?;
    let mut watcher = Watcher::new()?;
    let Study { out, restart, threads, .. } = request;
    let watch = &mut |progress| watcher.look(progress);
    let finished = groundbeam_study::run(&draws, out, request.shard(), *restart, *threads, watch);
    let seconds = watcher.end();
    let solved = match finished.map_err(|error| failed(&error))? {
        Finished::Whole(solved) => solved,
        Finished::Stopped(Progress { done, of, .. }) => {
            let out = out.display();
            return Err(stopped(&format!(
                "{done} of {of} samples saved; run the same command again to continue {out}"
            )));
        }
    };
    if request.shard() != Shard::WHOLE {
        return shard(request, &draws);
    }
    let summary = groundbeam_study::summary(&draws, out, &mut |progress| watcher.look(progress));
    watcher.end();
    let kept = || {
        format!("all samples are in {}; run the same command again for the summary", out.display())
    };
    let summary = summary.map_err(|error| ended(&error, kept))?;
    let seconds = (solved == draws.plan().samples).then_some(seconds);
    let context = Context { seconds, ..Context::new(units) };
    draw(request.plot.as_ref(), || Some(svg::study(&summary, &context)))?;
    print(&match request.json {
        true => json::study(&summary, &context),
        false => text::study(&summary, &context, standard_output_has_colour()),
    })?;
    Ok(Status::Done)
}

/// Merges shards.
pub fn merge(request: &Merge) -> Result<Status, Failure> {
    let mut watcher = Watcher::new()?;
    let watch = &mut |progress| watcher.look(progress);
    let merged = groundbeam_study::merge(&request.files, &request.out, watch);
    watcher.end();
    let kept = || "nothing is merged".to_owned();
    let merged = merged.map_err(|error| ended(&error, kept))?;
    if Target::of(&request.out).is_ok_and(|target| target == Target::StandardOutput) {
        // Standard output must contain only the merged file, so no message is printed.
        return Ok(Status::Done);
    }
    print(&format!(
        "{} samples of {} files in {}\n",
        merged.samples,
        merged.files,
        printable(&request.out.to_string_lossy())
    ))?;
    Ok(Status::Done)
}

/// Reads the study file and applies the options of the command line.
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
    let part @ Shard { number, of } = request.shard();
    let samples = part.samples(draws.plan().samples);
    let out = printable(&request.out.to_string_lossy()).into_owned();
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

/// Returns the failure of a study that the user stopped or that ended with an error.
fn ended(error: &StoreError, what_is_kept: impl Fn() -> String) -> Failure {
    match error {
        StoreError::Stopped => stopped(&what_is_kept()),
        error => failed(error),
    }
}

fn stopped(what_is_kept: &str) -> Failure {
    Failure::reported(format!("stopped: {}\n", printable(what_is_kept)), Status::Interrupted)
}

/// Shows progress on a terminal, and stops the run when Ctrl-C is pressed.
struct Watcher {
    stop: Arc<AtomicBool>,
    begun: Instant,
    wanted: bool,
    drawn: Option<(Stage, ProgressBar)>,
}

impl Watcher {
    fn new() -> Result<Self, Failure> {
        let stop = Arc::new(AtomicBool::new(false));
        let pressed = Arc::clone(&stop);
        let handled = ctrlc::set_handler(move || {
            if pressed.swap(true, Ordering::Relaxed) {
                // The second Ctrl-C ends the program at once.
                std::process::exit(i32::from(Status::Interrupted.code()));
            }
        });
        handled.map_err(|error| Failure::usage(error.to_string()))?;
        let wanted = std::io::stderr().is_terminal();
        Ok(Watcher { stop, begun: Instant::now(), wanted, drawn: None })
    }

    fn look(&mut self, progress: Progress) -> ControlFlow<()> {
        if self.wanted && self.begun.elapsed() > PROGRESS_DELAY {
            self.show(progress);
        }
        if self.stop.load(Ordering::Relaxed) {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    fn show(&mut self, Progress { stage, done, before, of }: Progress) {
        if self.drawn.as_ref().is_none_or(|(drawn, _)| *drawn != stage) {
            self.clear();
            let bar = ProgressBar::new(of).with_style(style(stage));
            // The displayed rate excludes the samples of earlier runs.
            bar.set_position(before);
            bar.reset_eta();
            self.drawn = Some((stage, bar));
        }
        if let Some((_, bar)) = &self.drawn {
            bar.set_position(done);
        }
    }

    fn clear(&mut self) {
        if let Some((_, bar)) = self.drawn.take() {
            bar.finish_and_clear();
        }
    }

    /// Removes the progress display and returns the duration \[s\].
    fn end(&mut self) -> f64 {
        self.clear();
        self.begun.elapsed().as_secs_f64()
    }
}

fn style(stage: Stage) -> ProgressStyle {
    let bar = if standard_error_has_colour() { "{bar:24.cyan}" } else { "{bar:24}" };
    let words = match stage {
        Stage::Verifying => "verifying, {percent} %, {eta} left",
        Stage::Solving => "{human_pos} of {human_len}, {per_sec}, {eta} left",
        Stage::Merging => "merging, {percent} %, {eta} left",
        Stage::Summarizing => "summarizing, {percent} %, {eta} left",
    };
    let style = ProgressStyle::with_template(&format!("{bar} {words}"));
    style.unwrap_or_else(|_| ProgressStyle::default_bar())
}
