//! A sign of life on the terminal for whatever takes more than a second.

use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::Duration;

/// How long nothing is shown.
const PATIENCE: Duration = Duration::from_secs(1);
/// Between two pictures of the spinner.
const TICK: Duration = Duration::from_millis(120);

/// Does some work; if a person waits for it, shows that it goes on.
pub fn while_working<T>(words: String, work: impl FnOnce() -> T) -> T {
    let spinner = std::io::stderr().is_terminal().then(|| Spinner::start(words));
    let done = work();
    drop(spinner);
    done
}

struct Spinner {
    done: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Spinner {
    fn start(words: String) -> Self {
        let (done, ended) = channel();
        let thread = thread::spawn(move || show(&ended, words));
        Spinner { done: Some(done), thread: Some(thread) }
    }
}

impl Drop for Spinner {
    fn drop(&mut self) {
        drop(self.done.take());
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Ends when the sender is dropped.
fn show(ended: &Receiver<()>, words: String) {
    if !matches!(ended.recv_timeout(PATIENCE), Err(RecvTimeoutError::Timeout)) {
        return;
    }
    let style = ProgressStyle::with_template("{spinner} {msg} ({elapsed})");
    let spinner = ProgressBar::new_spinner()
        .with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()))
        .with_elapsed(PATIENCE)
        .with_message(words);
    spinner.enable_steady_tick(TICK);
    let _ = ended.recv();
    spinner.finish_and_clear();
}
