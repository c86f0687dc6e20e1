//! Ctrl-C: asked for between steps, so that nothing is left half-written. A second Ctrl-C ends the process at once.

use scenelang_solve::Stop;
use std::sync::OnceLock;

static STOP: OnceLock<Stop> = OnceLock::new();

/// Starts listening; what is set by Ctrl-C. Where the system does not let us, Ctrl-C simply ends the process: files are
/// written whole anyway.
pub fn listen() -> &'static Stop {
    let stop = STOP.get_or_init(Stop::default);
    let _ = ctrlc::set_handler(|| {
        if stop.set() {
            std::process::exit(i32::from(crate::INTERRUPTED));
        }
    });
    stop
}

/// Whether Ctrl-C was pressed.
pub fn asked() -> bool {
    STOP.get().is_some_and(Stop::is_set)
}

/// What Ctrl-C sets, if somebody listens.
pub fn stop() -> Stop {
    STOP.get().cloned().unwrap_or_default()
}
