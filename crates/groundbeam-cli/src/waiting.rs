//! Shows progress on the terminal for work that takes more than a second.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// Delay before progress is shown.
pub const PROGRESS_DELAY: Duration = Duration::from_secs(1);
/// Time between two updates of the progress display.
const TICK: Duration = Duration::from_millis(120);

/// Runs `work` and shows progress on a terminal. `work` calls its argument after each of the `pieces` tasks.
pub fn while_working<T>(
    words: String,
    pieces: usize,
    work: impl FnOnce(&(dyn Fn() + Sync)) -> T,
) -> T {
    let count = Arc::new(AtomicU64::new(0));
    let counted = (pieces > 1).then(|| (pieces as u64, Arc::clone(&count)));
    let sign = std::io::stderr().is_terminal().then(|| Sign::start(words, counted));
    let done = work(&|| {
        count.fetch_add(1, Ordering::Relaxed);
    });
    drop(sign);
    done
}

/// Number of tasks, and counter of the finished tasks.
type Counted = Option<(u64, Arc<AtomicU64>)>;

struct Sign {
    done: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Sign {
    fn start(words: String, counted: Counted) -> Self {
        let (done, ended) = channel();
        let thread = thread::spawn(move || show(&ended, words, counted));
        Sign { done: Some(done), thread: Some(thread) }
    }
}

impl Drop for Sign {
    fn drop(&mut self) {
        drop(self.done.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Shows progress until the sender of `ended` is dropped.
fn show(ended: &Receiver<()>, words: String, counted: Counted) {
    if !matches!(ended.recv_timeout(PROGRESS_DELAY), Err(RecvTimeoutError::Timeout)) {
        return;
    }
    let (bar, template) = match &counted {
        None => (ProgressBar::new_spinner(), "{spinner} {msg} ({elapsed})"),
        Some((pieces, _)) => {
            (ProgressBar::new(*pieces), "{bar:20} {pos} of {len}, {msg} ({elapsed})")
        }
    };
    let style = ProgressStyle::with_template(template);
    let bar = bar
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()))
        .with_elapsed(PROGRESS_DELAY)
        .with_message(words);
    bar.enable_steady_tick(TICK);
    while matches!(ended.recv_timeout(TICK), Err(RecvTimeoutError::Timeout)) {
        if let Some((_, done)) = &counted {
            bar.set_position(done.load(Ordering::Relaxed));
        }
    }
    bar.finish_and_clear();
}
