//! The program that is open, and who answers what.

use crate::answers;
use crate::files::{Alone, layout_name};
use crate::make;
use crate::request::PageRequest;
use crate::room;
use scenelang_export::scene::Memory;
use scenelang_ide::{Cancelled, Host};
use serde_json::{Value, json};
use std::path::Path;

/// A program under edit. Requests and answers are JSON.
#[derive(Default)]
pub struct Session {
    open: Option<Open>,
}

/// The open program.
pub(crate) struct Open {
    pub(crate) host: Host,
    pub(crate) name: String,
    /// What its objects look like.
    pub(crate) looks: Memory,
}

/// Why a request has no answer.
pub(crate) type Refused = String;

impl Session {
    /// Answers a request: `{"ok": …}` or `{"error": "…"}`.
    pub fn call(&mut self, request: &[u8]) -> Vec<u8> {
        let answer = match serde_json::from_slice(request) {
            Ok(request) => self.answer(request),
            Err(why) => Err(format!("this is not a valid request: {why}")),
        };
        let answer = match answer {
            // The macro would copy it, and a room is large.
            Ok(mut value) => {
                let mut out = json!({ "ok": null });
                std::mem::swap(&mut out["ok"], &mut value);
                out
            }
            Err(why) => json!({ "error": why }),
        };
        answer.to_string().into_bytes()
    }

    fn answer(&mut self, request: PageRequest) -> Result<Value, Refused> {
        match request {
            PageRequest::Open { name, text, layout } => {
                let mut host = Host::new(&name, Path::new(&name), &text, &Alone { name: &name, text: &text });
                put_layout(&mut host, &name, layout);
                self.open = Some(Open { host, name, looks: Memory::default() });
                answers::marks(self.open()?)
            }
            PageRequest::Edit { text } => {
                let Open { host, name, .. } = self.open_mut()?;
                host.set_text(&text, &Alone { name, text: &text });
                answers::marks(self.open()?)
            }
            PageRequest::Layout { text } => {
                let Open { host, name, .. } = self.open_mut()?;
                put_layout(host, name, text);
                answers::marks(self.open()?)
            }
            PageRequest::Room { known, plan } => room::shown(self.open()?, known.as_deref(), plan),
            PageRequest::Complete { at, asked } => answers::completion(self.open()?, at, asked),
            PageRequest::Describe { about } => Ok(scenelang_ide::completion::describe(&about).into()),
            PageRequest::Hover { at } => answers::hover(self.open()?, at),
            PageRequest::Format => answers::formatted(self.open()?),
            PageRequest::Move { object, pos, rot, commit } => {
                let (mut answer, text) = room::moved(&self.open()?.host.snapshot(), &object, pos, rot)?;
                if commit {
                    answer["layout"] = text.into();
                }
                Ok(answer)
            }
            PageRequest::Proofs => answers::proofs(self.open()?),
            PageRequest::Export { format } => room::exported(self.open()?, format),
            PageRequest::Solve { name, text, start, seed } => make::solve(&name, &text, start.as_deref(), seed),
            PageRequest::Write { text } => make::write_room(&text),
            PageRequest::Version => Ok(json!({ "version": env!("CARGO_PKG_VERSION") })),
        }
    }

    fn open(&self) -> Result<&Open, Refused> {
        self.open.as_ref().ok_or_else(none)
    }

    fn open_mut(&mut self) -> Result<&mut Open, Refused> {
        self.open.as_mut().ok_or_else(none)
    }
}

fn none() -> Refused {
    "no program is open".to_owned()
}

/// There is one thread, and nobody who changes a text while a question about it is answered.
pub(crate) fn cancelled(_: Cancelled) -> Refused {
    "the text has changed".to_owned()
}

fn put_layout(host: &mut Host, name: &str, text: Option<String>) {
    let called = layout_name(name);
    host.set_layout(text.map(|text| (called.clone(), Path::new(&called), Ok(text.into_bytes()))));
}
