//! Solves the samples of a study on all processors and stores them in parts, so that a stopped run can be resumed.

use crate::draws::{Draw, Draws};
use crate::progress::{Progress, Stage, Watch};
use crate::row::Row;
use crate::store::{Column, Head, Parts, StoreError, Table, Whole};
use groundbeam::Solver;
use groundbeam_file::output::Identity;
use std::collections::VecDeque;
use std::ops::{ControlFlow, Range};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::{Duration, Instant};

/// Maximum number of samples that a thread takes at once.
const MOST_IN_A_PART: u64 = 16_384;
/// Minimum number of samples that a thread takes at once, unless fewer remain.
const FEWEST_IN_A_PART: u64 = 16;
/// Time after which a thread stores the samples that it has solved so far.
const LONGEST: Duration = Duration::from_secs(2);
/// Number of rows that are converted to columns together.
const ROWS_AT_ONCE: usize = 64;
/// Time between two progress reports.
const BETWEEN_LOOKS: Duration = Duration::from_millis(100);

/// The share of a study that one of several machines solves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Index of the machine, from 1.
    pub number: u64,
    /// Number of machines.
    pub of: u64,
}

impl Shard {
    /// The whole study.
    pub const WHOLE: Shard = Shard { number: 1, of: 1 };

    /// Returns the consecutive samples of this shard in a study of `of` samples. The numbers of samples of two
    /// shards differ by at most one.
    pub fn samples(self, of: u64) -> Range<u64> {
        let start = |number: u64| {
            let start = u128::from(of) * u128::from(number) / u128::from(self.of);
            u64::try_from(start).unwrap_or(of)
        };
        start(self.number - 1)..start(self.number)
    }
}

/// The result of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Finished {
    /// The results file contains all samples. The number counts the samples that this run solved.
    Whole(u64),
    /// The run was stopped; the results so far are stored in parts.
    Stopped(Progress),
}

/// Solves the samples of a study that are not solved yet, and writes one file.
///
/// The file does not depend on the number of threads or interruptions. If `threads` is 0, the run uses one thread per
/// processor. `watch` may stop the run; every solved sample is then stored.
///
/// # Errors
///
/// A file cannot be read or written, or belongs to another study.
pub fn run(
    draws: &Draws,
    out: &Path,
    shard: Shard,
    restart: bool,
    threads: usize,
    watch: &mut Watch,
) -> Result<Finished, StoreError> {
    let table = Table::of(draws);
    let samples = shard.samples(draws.plan().samples);
    let of = samples.end - samples.start;
    refuse_inputs(draws, out)?;
    if !restart
        && !Parts::wait(out)
        && let Some(whole) = Whole::of(out, &table.head, &samples)?
    {
        return match whole.verify(watch) {
            Err(StoreError::Stopped) => Ok(Finished::Stopped(Progress {
                stage: Stage::Verifying,
                done: of,
                before: of,
                of,
            })),
            verified => verified.map(|()| Finished::Whole(0)),
        };
    }
    let parts = Parts::open(out, restart)?;
    let missing = parts.missing(samples.clone())?;
    let left: u64 = missing.iter().map(|range| range.end - range.start).sum();
    let before = of - left;
    let progress = |done: u64| Progress { stage: Stage::Solving, done: before + done, before, of };
    match parts.verify(&table, &samples, watch) {
        Err(StoreError::Stopped) => return Ok(Finished::Stopped(progress(0))),
        verified => verified?,
    }
    let threads = match threads {
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        threads => threads,
    };
    let size = (left / (8 * threads as u64)).clamp(FEWEST_IN_A_PART, MOST_IN_A_PART);
    let work = Work {
        draws,
        table: &table,
        parts: &parts,
        todo: Mutex::new(cut(&missing, size)),
        done: AtomicU64::new(0),
        stop: AtomicBool::new(false),
    };
    work.on(threads, &mut |done| watch(progress(done)))?;
    let done = work.done.load(Ordering::Relaxed);
    if done < left {
        return Ok(Finished::Stopped(progress(done)));
    }
    match parts.finish(&table, watch) {
        Err(StoreError::Stopped) => Ok(Finished::Stopped(progress(done))),
        finished => finished.map(|()| Finished::Whole(done)),
    }
}

/// Digest of the study, its model, the files that the model names, the plan and the program version. Results
/// with the same digest are equal.
pub fn digest(draws: &Draws) -> String {
    Head::of(draws).get("digest").unwrap_or_default().to_owned()
}

/// Whether a file contains all results of a shard.
///
/// # Errors
///
/// Fails if the file cannot be read or contains results of another study.
pub fn is_done(draws: &Draws, out: &Path, shard: Shard) -> Result<bool, StoreError> {
    let samples = shard.samples(draws.plan().samples);
    Ok(!Parts::wait(out) && Whole::of(out, &Head::of(draws), &samples)?.is_some())
}

/// Refuses an output that is an input file of the study or not a regular file. Only a regular file can be read
/// again.
fn refuse_inputs(draws: &Draws, out: &Path) -> Result<(), StoreError> {
    let wrong = |error: std::io::Error| StoreError::File(out.to_owned(), error.to_string());
    let refused = |what: &str| Err(StoreError::File(out.to_owned(), what.to_owned()));
    let Some(identity) = Identity::of(out).map_err(wrong)? else {
        return refused("a study needs a regular file for its results, not a device or a pipe");
    };
    for file in draws.study().files() {
        // An input file that no longer exists cannot be overwritten by the output.
        if Identity::of(Path::new(&file.name)).is_ok_and(|input| input.as_ref() == Some(&identity))
        {
            return refused("the study reads this file; name another file for its results");
        }
    }
    Ok(())
}

/// Divides ranges into pieces of limited size.
fn cut(ranges: &[Range<u64>], size: u64) -> VecDeque<Range<u64>> {
    let pieces = |range: &Range<u64>| {
        let end = range.end;
        let starts = (range.start..end).step_by(usize::try_from(size).unwrap_or(usize::MAX));
        starts.map(move |start| start..(start + size).min(end)).collect::<Vec<_>>()
    };
    ranges.iter().flat_map(pieces).collect()
}

/// The data shared by the threads.
struct Work<'a> {
    draws: &'a Draws,
    table: &'a Table,
    parts: &'a Parts,
    todo: Mutex<VecDeque<Range<u64>>>,
    done: AtomicU64,
    stop: AtomicBool,
}

impl Work<'_> {
    /// Solves all samples of `todo` on `threads` threads, and reports the number of solved samples to `watch`.
    fn on(
        &self,
        threads: usize,
        watch: &mut dyn FnMut(u64) -> ControlFlow<()>,
    ) -> Result<(), StoreError> {
        let (say, ended) = mpsc::channel();
        std::thread::scope(|scope| {
            for _ in 0..threads {
                let say = say.clone();
                scope.spawn(move || {
                    let result = self.thread();
                    if result.is_err() {
                        self.stop.store(true, Ordering::Relaxed);
                    }
                    // Sending cannot fail, because the receiver waits for all threads.
                    let _ = say.send(result);
                });
            }
            drop(say);
            let mut first = Ok(());
            loop {
                match ended.recv_timeout(BETWEEN_LOOKS) {
                    Ok(result) => first = first.and(result),
                    Err(RecvTimeoutError::Disconnected) => break,
                    Err(RecvTimeoutError::Timeout) => {
                        if watch(self.done.load(Ordering::Relaxed)).is_break() {
                            self.stop.store(true, Ordering::Relaxed);
                        }
                    }
                }
            }
            first?;
            let _ = watch(self.done.load(Ordering::Relaxed));
            Ok(())
        })
    }

    /// Takes one range of samples after another from `todo` and solves it, until no range is left or the run is
    /// stopped.
    fn thread(&self) -> Result<(), StoreError> {
        let mut solver = Solver::new();
        let next = || self.todo.lock().ok().and_then(|mut todo| todo.pop_front());
        while let Some(piece) = next() {
            self.piece(piece, &mut solver)?;
            if self.stop.load(Ordering::Relaxed) {
                break;
            }
        }
        Ok(())
    }

    fn piece(&self, piece: Range<u64>, solver: &mut Solver) -> Result<(), StoreError> {
        let Table { wanted, .. } = self.table;
        let mut rows: Vec<(Draw, Row)> = Vec::with_capacity(ROWS_AT_ONCE);
        let mut columns: Vec<Column> = Vec::new();
        let (mut first, mut begun) = (piece.start, Instant::now());
        for sample in piece.clone() {
            let draw = self.draws.draw(sample);
            let model = self.draws.model(&draw);
            let row = Row::solve(&model, wanted, solver);
            rows.push((draw, row));
            let stops = self.stop.load(Ordering::Relaxed);
            let ends = sample + 1 == piece.end || stops || begun.elapsed() > LONGEST;
            if ends || rows.len() == ROWS_AT_ONCE {
                self.table.append(&mut columns, sample + 1 - rows.len() as u64, &rows);
                rows.clear();
            }
            if ends {
                let done = first..sample + 1;
                self.parts.keep(self.table, done.clone(), std::mem::take(&mut columns))?;
                self.done.fetch_add(done.end - done.start, Ordering::Relaxed);
                (first, begun) = (sample + 1, Instant::now());
            }
            if stops {
                break;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_divide_all_samples_evenly() {
        for (samples, of) in [(10, 3), (2, 5), (1 << 40, 7)] {
            let mut reached = 0;
            for number in 1..=of {
                let range = Shard { number, of }.samples(samples);
                assert_eq!(range.start, reached);
                assert!((range.end - range.start).abs_diff(samples / of) <= 1);
                reached = range.end;
            }
            assert_eq!(reached, samples);
        }
    }

    #[test]
    fn pieces_cover_the_missing_samples() {
        let pieces = cut(&[3..10, 20..21], 4);
        assert_eq!(Vec::from(pieces), [3..7, 7..10, 20..21]);
    }
}
