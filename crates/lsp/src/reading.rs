//! Reading without waiting for long: whoever needs a file must not stand still because a disk does.
//!
//! A file is read by a thread of its own. Where that takes longer than a moment, the reader goes on with what the file was
//! when it was read last, or as if it could not be read; the state is told when it could.

use crate::state::{Event, State};
use scenelang_base::door::outside;
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
    /// Files that took longer than a moment, and are still being read.
    begun: BTreeSet<PathBuf>,
    /// What came of those that were, the last time.
    done: BTreeMap<PathBuf, io::Result<Vec<u8>>>,
}

impl Reading {
    /// Nothing is slow yet; `events`: where the state is told.
    pub fn new(events: mpsc::Sender<Event>) -> Arc<Self> {
        Arc::new(Self { slow: Mutex::default(), events })
    }

    /// What `read` comes to, if it takes no more than a moment; else what it came to the last time.
    ///
    /// # Errors
    /// What `read` says, or that it is still being read.
    pub fn read(
        self: &Arc<Self>,
        path: &Path,
        read: impl FnOnce() -> io::Result<Vec<u8>> + Send + 'static,
    ) -> io::Result<Vec<u8>> {
        {
            let slow = self.lock();
            if slow.begun.contains(path) {
                return slow.last(path);
            }
        }
        let (send, receive) = mpsc::sync_channel(0);
        let (own, file) = (Arc::clone(self), path.to_owned());
        let thread = std::thread::Builder::new().name("reading".to_owned());
        thread.spawn(move || {
            // Nobody waits any more: it was slow.
            if let Err(mpsc::SendError(late)) = send.send(read()) {
                own.late(file, late);
            }
        })?;
        if let Ok(read) = receive.recv_timeout(MOMENT) {
            return read;
        }
        let mut slow = self.lock();
        slow.begun.insert(path.to_owned());
        // Only now does it count as slow: it tells so when it is done.
        drop(receive);
        slow.last(path)
    }

    fn late(&self, file: PathBuf, read: io::Result<Vec<u8>>) {
        let mut slow = self.lock();
        slow.begun.remove(&file);
        let same = slow.done.get(&file).is_some_and(|last| match (last, &read) {
            (Ok(a), Ok(b)) => a == b,
            (Err(a), Err(b)) => a.kind() == b.kind(),
            _ => false,
        });
        slow.done.insert(file, read);
        drop(slow);
        if !same {
            let _ = self.events.send(Event::Done(Box::new(|state: &mut State| state.documents.read_again())));
        }
    }

    /// Where the state is told.
    pub fn events(&self) -> mpsc::Sender<Event> {
        self.events.clone()
    }

    fn lock(&self) -> MutexGuard<'_, Slow> {
        self.slow.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Slow {
    fn last(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.done.get(path) {
            Some(Ok(bytes)) => Ok(bytes.clone()),
            Some(Err(e)) => Err(copied(e)),
            None => Err(io::Error::new(io::ErrorKind::TimedOut, "it is still being read")),
        }
    }
}

/// The same error once more.
pub fn copied(e: &io::Error) -> io::Error {
    match (outside(e), e.raw_os_error()) {
        (Some(refused), _) => io::Error::new(e.kind(), refused.clone()),
        (None, Some(code)) => io::Error::from_raw_os_error(code),
        (None, None) if e.get_ref().is_some() => io::Error::new(e.kind(), e.to_string()),
        (None, None) => e.kind().into(),
    }
}
