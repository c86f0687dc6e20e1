//! What waits for a disk: questions about programs whose files are being read, and the look at files that nobody watches. The
//! thread that owns all state waits for neither.

use crate::disk;
use crate::shelf::Shelf;
use crate::state::{Event, State, Work};
use serde_json::Value;
use std::path::PathBuf;
use std::sync::mpsc as queue;
use std::time::Duration;
use tower_lsp::jsonrpc::Id;

/// What goes on when the files of a program were read.
pub type Parked = Box<dyn FnOnce(&mut State) + Send>;

/// How often files are looked at, for a client that cannot say when they change.
const EVERY: Duration = Duration::from_millis(700);

impl State {
    /// Begins with an answer, as soon as the files are read of all programs that are asked about.
    pub fn ask(&mut self, id: Id, method: String, params: Value) {
        self.follow(&method, &params);
        let mut spoken = Vec::new();
        texts(&params, &mut spoken);
        for uri in &spoken {
            self.documents.sync(uri);
        }
        let unread = spoken.iter().find(|uri| self.documents.is_unread(uri)).map(|uri| (*uri).to_owned());
        if let Some(uri) = unread {
            self.parked.push((uri, Box::new(move |state| state.ask(id, method, params))));
        } else if self.is_pending(&id)
            && let Err(fault) = self.dispatch(&id, &method, params)
        {
            self.reply(&id, Err(fault));
        }
    }

    /// The files of a program were read: who waited for them goes on.
    pub fn fetched(&mut self, uri: &str, opening: u64, wanted: u64, shelf: Option<Shelf>) {
        self.documents.shelve(uri, opening, wanted, shelf);
        // What it imports may have to be read, too.
        self.documents.sync(uri);
        self.unpark();
    }

    /// Goes on with what no longer has to wait.
    pub fn unpark(&mut self) {
        for (uri, go_on) in std::mem::take(&mut self.parked) {
            if self.documents.is_unread(&uri) {
                self.parked.push((uri, go_on));
            } else {
                go_on(self);
            }
        }
    }

    /// Asks a reader as soon as the files of a program are read.
    pub fn park(&mut self, id: &Id, uri: &str, work: Work) {
        let (id, key) = (id.clone(), uri.to_owned());
        let again = move |state: &mut Self| {
            if state.is_pending(&id) {
                state.ask_reader(&id, &key, work);
            }
        };
        self.parked.push((uri.to_owned(), Box::new(again)));
    }

    /// Looks at files every now and then.
    pub fn look_at_files(&self) {
        let events = self.events();
        std::thread::spawn(move || {
            // Until there is no state any more.
            loop {
                let (send, known) = queue::channel();
                let ask = move |state: &mut State| drop(send.send(state.documents.stamps()));
                if events.send(Event::Done(Box::new(ask))).is_err() {
                    return;
                }
                let Ok(known) = known.recv() else { return };
                let now = known.into_iter().filter(|(path, before)| disk::stamp(path) != *before);
                let changed: Vec<PathBuf> = now.map(|(path, _)| path).collect();
                if !changed.is_empty() {
                    let tell = move |state: &mut State| state.changed_on_disk(changed);
                    let _ = events.send(Event::Done(Box::new(tell)));
                }
                std::thread::sleep(EVERY);
            }
        });
    }
}

/// All texts in what a client sent.
fn texts<'v>(value: &'v Value, out: &mut Vec<&'v str>) {
    match value {
        Value::String(text) => out.push(text),
        Value::Array(list) => list.iter().for_each(|value| texts(value, out)),
        Value::Object(members) => members.values().for_each(|value| texts(value, out)),
        _ => {}
    }
}
