//! A sign of life on a terminal while a computation takes longer than a second.

use std::io::{self, IsTerminal};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// Computations that are done sooner show nothing.
const PATIENCE: Duration = Duration::from_secs(1);

/// As much of a formula is shown.
const LONGEST: usize = 50;

/// While it lives, a computation goes on; what it showed goes with it.
pub(super) struct Waiting {
    done: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Waiting {
    /// Says after a while what is being computed, and for how long, if standard error is a terminal.
    pub fn of(what: &str) -> Self {
        let dumb = std::env::var_os("TERM").is_some_and(|terminal| terminal == "dumb");
        if dumb || !io::stderr().is_terminal() {
            return Waiting { done: None, thread: None };
        }
        let what = shortened(what);
        let (done, waiting) = mpsc::channel();
        let thread = thread::Builder::new().spawn(move || {
            if waiting.recv_timeout(PATIENCE) != Err(RecvTimeoutError::Timeout) {
                return;
            }
            let bar = ProgressBar::new_spinner().with_elapsed(PATIENCE).with_message(what);
            if let Ok(style) = ProgressStyle::with_template("{spinner} {elapsed} {msg}") {
                bar.set_style(style);
            }
            bar.enable_steady_tick(Duration::from_millis(120));
            // Ends when the sender is dropped.
            let _ = waiting.recv();
            bar.finish_and_clear();
        });
        Waiting { done: Some(done), thread: thread.ok() }
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        self.done = None;
        if let Some(thread) = self.thread.take() {
            // Nothing is lost if it panicked.
            let _ = thread.join();
        }
    }
}

/// The beginning of a text, on one line.
fn shortened(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(LONGEST) {
        Some((at, _)) => format!("{} …", &line[..at]),
        None => line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_shortened() {
        assert_eq!(shortened(" t^2\n + 1 "), "t^2 + 1");
        assert_eq!(shortened(&"x".repeat(60)).chars().count(), LONGEST + 2);
    }
}
