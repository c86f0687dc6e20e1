//! A line of progress on a terminal; nothing in a pipe.

use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};
use scenelang_base::plain;
use std::io::IsTerminal;
use std::time::Duration;

/// The remaining time is estimated once so much has passed.
const KNOWN: Duration = Duration::from_secs(5);

/// A spinner with a sentence, on standard error.
pub struct Progress(ProgressBar);

impl Progress {
    /// Starts with a sentence. It shows itself only on a terminal.
    pub fn new(what: impl Into<String>) -> Self {
        let bar = ProgressBar::new_spinner();
        if std::io::stderr().is_terminal() {
            if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} ({elapsed})") {
                bar.set_style(style);
            }
            bar.enable_steady_tick(Duration::from_millis(100));
        } else {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        }
        bar.set_message(clean(what));
        Self(bar)
    }
    /// Says what is being done now.
    pub fn say(&self, what: impl Into<String>) {
        self.0.set_message(clean(what));
    }
    /// The end of a sentence about so many things that are done and so many that are not: how long these will take.
    pub fn left(&self, done: usize, open: usize) -> String {
        match self.0.elapsed() {
            elapsed if elapsed >= KNOWN && done > 0 && open > 0 => {
                format!(", about {} left", HumanDuration(elapsed.mul_f64(open as f64 / done as f64)))
            }
            _ => String::new(),
        }
    }
    /// Does something that prints, with the spinner out of the way.
    pub fn aside<R>(&self, print: impl FnOnce() -> R) -> R {
        self.0.suspend(print)
    }
    /// Prints a line above the spinner (on a terminal only).
    pub fn done(&self, line: impl AsRef<str>) {
        self.0.println(line);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

/// On a terminal a file's name must not act.
fn clean(what: impl Into<String>) -> String {
    plain::line(&what.into()).into_owned()
}

/// The solver's progress in words.
pub fn solving(p: &scenelang_solve::Progress) -> String {
    use scenelang_solve::Phase;
    let phase = match p.phase {
        Phase::InitialPlacement => "placing",
        Phase::PhysicsRelaxation => "relaxing",
        Phase::Repair => "repairing",
    };
    format!("{phase}: {} of {} terms hold, round {}", p.held, p.total, p.iteration)
}
