//! Ctrl-C, and SIGTERM like it. In most stages it ends the process at once, with the exit code 130: files are written
//! whole, what is unfinished is taken away, and what was written before is said. A stage that has something to show for
//! itself, as a search for a layout has, asks for the end itself ([`gently`]) and writes what it has by then; there, the
//! second Ctrl-C ends the process at once.

use crate::{FAILED, INTERRUPTED};
use scenelang_base::fs;
use scenelang_solve::Stop;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{OnceLock, mpsc};
use std::time::Duration;

static STOP: OnceLock<Stop> = OnceLock::new();
/// How many stages there are that look at [`asked`].
static GENTLE: AtomicUsize = AtomicUsize::new(0);
/// So long may it take to say what was written: whoever reads standard error may have stopped reading.
const PATIENCE: Duration = Duration::from_millis(500);
/// So many files are named.
const NAMED: usize = 20;

/// Starts listening. Where the system does not let us, Ctrl-C simply ends the process: files are written whole anyway.
pub fn listen() {
    STOP.get_or_init(Stop::default);
    #[cfg(unix)]
    {
        use signal_hook::consts::{SIGINT, SIGTERM};
        let Ok(mut signals) = signal_hook::iterator::Signals::new([SIGINT, SIGTERM]) else { return };
        let heard = move || signals.forever().for_each(|_| hear());
        let _ = std::thread::Builder::new().name("signals".to_owned()).spawn(heard);
    }
    #[cfg(not(unix))]
    let _ = ctrlc::set_handler(hear);
}

/// What a signal does.
fn hear() {
    if GENTLE.load(Ordering::SeqCst) > 0 && !stop().set() {
        return;
    }
    end("interrupted", INTERRUPTED);
}

/// Ends the process when a time is over that all of a command may take, as Ctrl-C does, but with the exit code of a
/// command that could not do its work. A stage that looks at the time itself is left to do so.
pub fn within(time: Option<Duration>) {
    let Some(time) = time else { return };
    let wait = move || {
        std::thread::sleep(time);
        while GENTLE.load(Ordering::SeqCst) > 0 {
            std::thread::sleep(PATIENCE);
        }
        end(&format!("error: the time limit was reached ({} s)", time.as_secs_f64()), FAILED);
    };
    let _ = std::thread::Builder::new().name("time".to_owned()).spawn(wait);
}

/// Ends the process, and says why and what was written.
fn end(why: &str, code: u8) {
    let (why, written) = (why.to_owned(), fs::end());
    let (done, said) = mpsc::channel();
    let tell = move || {
        eprintln!("{}", told(&why, &written));
        let _ = done.send(());
    };
    if std::thread::Builder::new().spawn(tell).is_ok() {
        let _ = said.recv_timeout(PATIENCE);
    }
    std::process::exit(i32::from(code));
}

fn told(why: &str, written: &[std::path::PathBuf]) -> String {
    let mut names: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    names.dedup();
    let more = match names.len().saturating_sub(NAMED) {
        _ if names.is_empty() => return format!("{why}; nothing was written"),
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    names.truncate(NAMED);
    format!("{why}; these files are new; all others are unchanged: {}{more}", names.join(", "))
}

/// From here on, Ctrl-C is for this command to see.
pub fn gently() {
    GENTLE.fetch_max(1, Ordering::SeqCst);
}

/// A stage that looks at [`asked`] often, until it is dropped.
pub struct Gentle(());

impl Gentle {
    /// Begins such a stage.
    pub fn new() -> Self {
        GENTLE.fetch_add(1, Ordering::SeqCst);
        Self(())
    }
}

impl Drop for Gentle {
    fn drop(&mut self) {
        GENTLE.fetch_sub(1, Ordering::SeqCst);
    }
}

/// Whether Ctrl-C was pressed.
pub fn asked() -> bool {
    STOP.get().is_some_and(Stop::is_set)
}

/// What Ctrl-C sets in a stage that looks at it.
pub fn stop() -> Stop {
    STOP.get().cloned().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_new_is_said() {
        let paths = |n: usize| (0..n).map(|i| format!("out/{i}").into()).collect::<Vec<std::path::PathBuf>>();
        assert_eq!(told("interrupted", &[]), "interrupted; nothing was written");
        assert!(told("interrupted", &paths(2)).ends_with("all others are unchanged: out/0, out/1"));
        assert!(told("interrupted", &paths(25)).ends_with("out/19 and 5 more"));
    }
}
