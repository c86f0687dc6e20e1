//! Work outside of the interpreter: other threads of Python go on, and Ctrl-C ends it.

use pyo3::{PyResult, Python};
use scenelang_engine::limit::Stop;
use std::panic::resume_unwind;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// How often it is asked whether somebody pressed Ctrl-C.
const OFTEN: Duration = Duration::from_millis(50);

/// Does something that may take long; it is to end early where the request to stop is set.
///
/// # Errors
/// What a handler of signals raised: `KeyboardInterrupt`.
pub fn away<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop::default();
    let mut raised = None;
    let done = py.detach(|| {
        thread::scope(|scope| {
            let (done, wait) = channel::<()>();
            let worker = scope.spawn(|| {
                // Dropped at the end, however that comes.
                let _done = done;
                work(&stop)
            });
            while wait.recv_timeout(OFTEN) == Err(RecvTimeoutError::Timeout) {
                if raised.is_none()
                    && let Err(error) = Python::attach(|py| py.check_signals())
                {
                    raised = Some(error);
                    stop.set();
                }
            }
            worker.join()
        })
    });
    match (done, raised) {
        (_, Some(error)) => Err(error),
        (Ok(done), None) => Ok(done),
        (Err(panic), None) => resume_unwind(panic),
    }
}
