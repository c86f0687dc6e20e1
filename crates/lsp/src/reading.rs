//! Reading without waiting: the thread that owns all state must not stand still because a disk does.
//!
//! A file is read by a thread of its own. Where that takes longer than a moment, the state goes on as if the file could not
//! be read, and is told when it could.

use crate::state::{Event, State};
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};
use std::time::Duration;

/// So long a file is waited for. Files on a disk take a hundredth of it.
const MOMENT: Duration = Duration::from_secs(1);

/// What takes longer than a moment.
pub struct Reading {
    slow: Mutex<Slow>,
    events: mpsc::Sender<Event>,
}

#[derive(Default)]
struct Slow {
    /// Files that are still being read.
    begun: BTreeSet<PathBuf>,
    /// What came of those that were, until somebody asks for it.
    done: BTreeMap<PathBuf, io::Result<Vec<u8>>>,
}

impl Reading {
    /// Nothing is slow yet; `events`: where the state is told.
    pub fn new(events: mpsc::Sender<Event>) -> Arc<Self> {
        Arc::new(Self { slow: Mutex::default(), events })
    }

    /// What `read` comes to, if it takes no more than a moment.
    ///
    /// # Errors
    /// What `read` says, or that it is still being read.
    pub fn read(
        self: &Arc<Self>,
        path: &Path,
        read: impl FnOnce() -> io::Result<Vec<u8>> + Send + 'static,
    ) -> io::Result<Vec<u8>> {
        let still = || io::Error::new(io::ErrorKind::TimedOut, "it is still being read");
        {
            let mut slow = self.lock();
            if let Some(done) = slow.done.remove(path) {
                return done;
            }
            if !slow.begun.insert(path.to_owned()) {
                return Err(still());
            }
        }
        let (send, receive) = mpsc::sync_channel(0);
        let (own, file) = (Arc::clone(self), path.to_owned());
        let thread = std::thread::Builder::new().name("reading".to_owned());
        let spawned = thread.spawn(move || {
            // Nobody waits any more: it was slow.
            if let Err(mpsc::SendError(late)) = send.send(read()) {
                own.late(file, late);
            }
        });
        if let Err(e) = spawned {
            self.lock().begun.remove(path);
            return Err(e);
        }
        let read = receive.recv_timeout(MOMENT).map_err(|_| still())?;
        self.lock().begun.remove(path);
        read
    }

    fn late(&self, file: PathBuf, read: io::Result<Vec<u8>>) {
        let mut slow = self.lock();
        slow.begun.remove(&file);
        slow.done.insert(file, read);
        drop(slow);
        let _ = self.events.send(Event::Done(Box::new(|state: &mut State| state.documents.read_again())));
    }

    fn lock(&self) -> MutexGuard<'_, Slow> {
        self.slow.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
