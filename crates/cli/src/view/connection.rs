//! The connections that are open, and which of them has to go when there are too many: the oldest that has not shown the
//! secret yet. So whoever opens hundreds of them and says nothing is in nobody's way.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::task::AbortHandle;

/// At most so many at a time: systems give a process at least 256 files.
pub const MOST: usize = 128;

/// What is known of a connection.
#[derive(Default)]
pub struct Connection {
    trusted: AtomicBool,
    follows: AtomicBool,
}

impl Connection {
    /// A request of it came in.
    pub fn trust(&self) {
        self.trusted.store(true, Ordering::Relaxed);
    }

    /// It is told of news, and does not end.
    pub fn follow(&self) {
        self.follows.store(true, Ordering::Relaxed);
    }

    /// Whether it is told of news.
    pub fn follows(&self) -> bool {
        self.follows.load(Ordering::Relaxed)
    }

    fn is_trusted(&self) -> bool {
        self.trusted.load(Ordering::Relaxed)
    }
}

/// All that are open, by the order in which they came.
#[derive(Default)]
pub struct Connections(Mutex<Open>);

#[derive(Default)]
struct Open {
    next: u64,
    all: BTreeMap<u64, (Arc<Connection>, Option<AbortHandle>)>,
}

impl Connections {
    /// Takes a new one in, in the place of another if need be; `None`: all places are taken by those who know the secret.
    pub fn admit(&self) -> Option<(u64, Arc<Connection>)> {
        let mut open = self.open();
        if open.all.len() >= MOST {
            let (&oldest, _) = open.all.iter().find(|(_, (connection, _))| !connection.is_trusted())?;
            if let Some((_, Some(task))) = open.all.remove(&oldest) {
                task.abort();
            }
        }
        let (number, connection) = (open.next, Arc::new(Connection::default()));
        open.next += 1;
        open.all.insert(number, (Arc::clone(&connection), None));
        Some((number, connection))
    }

    /// What serves it, so that it can be ended.
    pub fn served_by(&self, number: u64, task: AbortHandle) {
        if let Some((_, own)) = self.open().all.get_mut(&number) {
            *own = Some(task);
        }
    }

    /// It has ended.
    pub fn end(&self, number: u64) {
        self.open().all.remove(&number);
    }

    fn open(&self) -> MutexGuard<'_, Open> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strangers_make_room() {
        let connections = Connections::default();
        let (first, page) = connections.admit().unwrap();
        page.trust();
        let all: Vec<_> = (0..1000).map(|_| connections.admit().unwrap().0).collect();
        let open: Vec<u64> = connections.open().all.keys().copied().collect();
        assert_eq!(open.len(), MOST);
        assert!(open[0] == first && open[1..] == all[1000 - (MOST - 1)..], "the newest strangers, and who is trusted");
        connections.open().all.values().for_each(|(connection, _)| connection.trust());
        assert!(connections.admit().is_none());
        connections.end(first);
        assert!(connections.admit().is_some());
    }
}
