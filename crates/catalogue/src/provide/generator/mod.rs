//! Who makes models to order, as a provider: a program of the user's, or a service.
//!
//! What was made is kept by who made it and what was asked, so that the same order costs nothing the next time, and a run
//! that was ended goes on where it was. Orders go out side by side; how many there may be in a run is bounded, and which of
//! them are left out then depends on their order in the program only.

mod command;
#[cfg(feature = "services")]
mod gradio;
#[cfg(feature = "services")]
mod service;

pub use command::Command;
#[cfg(feature = "services")]
pub use service::{Service, ServiceKind};

use super::fit::fit;
use super::{AssetProvider, Given, Query, Remark, Reply, Why, sum};
use crate::card::Card;
use crate::faults::beyond;
use crate::model::{Axes, CatalogueModel};
use crate::{glb, limits};
use scenelang_base::Diagnostic;
use scenelang_base::door::Door;
use scenelang_base::plain::line;
use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

/// So many models are made at a time.
const AT_ONCE: usize = 4;
/// How often it is looked whether somebody wants to end it.
const LOOK: Duration = Duration::from_millis(50);
/// A sum in words has so many bytes.
const SUM: usize = 64;
/// How much of what somebody says goes into a remark (characters).
const SAID: usize = 200;

#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// "red oak office chair, with armrests".
    pub prompt: String,
    /// The noun.
    pub category: String,
    /// Extents w, h, d in metres, where they are known.
    pub size: Option<[f64; 3]>,
}

/// How far an order is, and when it is to be given up.
#[derive(Debug)]
pub struct Watch {
    /// When it is too late.
    until: Instant,
    stop: fn() -> bool,
    said: Sender<String>,
    prompt: String,
}

impl Watch {
    /// Tells how far it is.
    pub fn say(&self, said: &str) {
        // Nobody need listen.
        let _ = self.said.send(format!("making \"{}\": {}", short(&self.prompt), short(said)));
    }

    /// Why it is to be given up, if it is.
    pub fn over(&self) -> Option<String> {
        if (self.stop)() {
            return Some("it was interrupted".to_owned());
        }
        (Instant::now() >= self.until).then(|| "it took too long".to_owned())
    }

    /// Waits, unless it is to be given up.
    ///
    /// # Errors
    /// Why it is.
    pub fn wait(&self, time: Duration) -> Result<(), String> {
        let until = Instant::now() + time;
        while Instant::now() < until {
            if let Some(why) = self.over() {
                return Err(why);
            }
            std::thread::sleep(LOOK.min(time));
        }
        self.over().map_or(Ok(()), Err)
    }
}

/// Somebody who makes a model.
pub trait Maker: fmt::Debug + Send + Sync {
    /// What it is called in reports.
    fn name(&self) -> &str;
    /// All that decides what it makes of an order, in words: who it is, where, with which arguments. No key is in it.
    fn identity(&self) -> String;
    /// Makes a GLB file.
    ///
    /// # Errors
    /// Why there is none, in words.
    fn make(&self, order: &Order, watch: &Watch) -> Result<Vec<u8>, String>;
}

/// How much may be spent, and where things are kept.
#[derive(Clone, Debug)]
pub struct Bounds {
    /// The longest wait for a model.
    pub timeout: Duration,
    /// How many are made in a run at most; what was made before does not count.
    pub most: usize,
    /// Where models are kept; `None`: nowhere.
    pub kept: Option<PathBuf>,
    /// Whether somebody wants to end it.
    pub stop: fn() -> bool,
}

/// Who makes models to order.
#[derive(Debug)]
pub struct Generator {
    maker: Box<dyn Maker>,
    bounds: Bounds,
}

/// A GLB file, or why there is none.
type Made = Result<Vec<u8>, Remark>;

impl Generator {
    /// A maker within bounds.
    pub fn new(maker: Box<dyn Maker>, bounds: Bounds) -> Self {
        Self { maker, bounds }
    }

    /// The file in which the model of an order is kept: the sum of a GLB file, and the file.
    fn file(&self, key: &str) -> Option<PathBuf> {
        let folder = self.bounds.kept.as_ref()?;
        Some(folder.join(&key[..2]).join(format!("{}.model", &key[2..])))
    }

    /// The model of an order, if it is kept. What was damaged is as good as nothing, and is made and kept again.
    fn kept(&self, key: &str) -> Option<Vec<u8>> {
        let folder = self.bounds.kept.as_ref()?;
        let bytes = Door::within(folder).read(&self.file(key)?).ok()?;
        let (own, model) = bytes.split_at_checked(SUM)?;
        (own == sum(&[model]).as_bytes()).then(|| model.to_vec())
    }

    fn keep(&self, key: &str, bytes: &[u8]) {
        if let (Some(folder), Some(file)) = (&self.bounds.kept, self.file(key)) {
            let kept = [sum(&[bytes]).as_bytes(), bytes].concat();
            // It is there for the next time; this time goes on without.
            let _ = Door::within(folder).write(&file, &kept);
        }
    }

    /// Makes all orders that are not kept, side by side.
    fn made(&self, orders: &BTreeMap<usize, (String, Order)>, say: &mut dyn FnMut(&str)) -> BTreeMap<usize, Made> {
        let todo: Vec<(&usize, &(String, Order))> = orders.iter().collect();
        let next = AtomicUsize::new(0);
        let mut out = BTreeMap::new();
        let (said, hear) = channel();
        let (done, finished) = channel();
        std::thread::scope(|scope| {
            for _ in 0..AT_ONCE.min(todo.len()) {
                let (said, done, next, todo) = (said.clone(), done.clone(), &next, &todo);
                scope.spawn(move || {
                    while let Some(&(at, (key, order))) = todo.get(next.fetch_add(1, Ordering::SeqCst)) {
                        let until = Instant::now() + self.bounds.timeout;
                        let prompt = order.prompt.clone();
                        let watch = Watch { until, stop: self.bounds.stop, said: said.clone(), prompt };
                        let made = match watch.over() {
                            Some(why) => Err(why),
                            None => self.maker.make(order, &watch),
                        };
                        let made = made.map_err(|why| Remark::new(Why::Failed, short(&why)));
                        let made = made.and_then(|bytes| match judged(&bytes) {
                            Ok(()) => {
                                self.keep(key, &bytes);
                                Ok(bytes)
                            }
                            Err(finding) => Err(Remark::broken(&named(&order.prompt), &finding)),
                        });
                        if done.send((*at, made)).is_err() {
                            return;
                        }
                    }
                });
            }
            drop(done);
            while out.len() < todo.len() {
                match finished.recv_timeout(LOOK) {
                    Ok((at, made)) => drop(out.insert(at, made)),
                    Err(RecvTimeoutError::Disconnected) => break,
                    Err(RecvTimeoutError::Timeout) => {}
                }
                hear.try_iter().for_each(|said: String| say(&said));
            }
        });
        out
    }

    fn given(&self, query: &Query, bytes: &[u8]) -> Result<Given, Remark> {
        let prompt = query.text();
        let broken = |finding: Box<Diagnostic>| Remark::broken(&named(&prompt), &finding);
        let raw = glb::read(bytes).map_err(broken)?;
        let card = Card { front: Some(0.0), ..Card::of_name(&query.what) };
        let model = CatalogueModel::new(&named(&prompt), card, raw, Axes::RightHanded, Vec::new()).map_err(broken)?;
        Ok(Given {
            piece: fit(&model, query, false)?,
            source: prompt,
            score: None,
            content: Some(sum(&[bytes])),
            licence: None,
        })
    }
}

impl AssetProvider for Generator {
    fn name(&self) -> &str {
        self.maker.name()
    }

    fn provide(&self, queries: &[&Query], say: &mut dyn FnMut(&str)) -> Vec<Reply> {
        let order = |query: &Query| Order {
            prompt: query.text(),
            category: query.what.clone(),
            size: query.wanted().map(Into::into),
        };
        // Equal orders are made once, for the first of the queries that has it.
        let mut first: BTreeMap<String, usize> = BTreeMap::new();
        let keys: Vec<String> = queries.iter().map(|query| query.key(&self.maker.identity(), &[])).collect();
        let (mut made, mut orders) = (BTreeMap::new(), BTreeMap::new());
        for (at, query) in queries.iter().enumerate() {
            if *first.entry(keys[at].clone()).or_insert(at) != at {
                continue;
            }
            if let Some(bytes) = self.kept(&keys[at]) {
                made.insert(at, Ok(bytes));
            } else if orders.len() < self.bounds.most {
                orders.insert(at, (keys[at].clone(), order(query)));
            } else {
                let say = match self.bounds.most {
                    0 => "no models may be made in this run".to_owned(),
                    most => format!("the maximum for one run is {most} models"),
                };
                made.insert(at, Err(Remark::new(Why::Budget, say)));
            }
        }
        if !orders.is_empty() {
            say(&format!("making {} models", orders.len()));
            made.extend(self.made(&orders, say));
        }
        let reply = |(query, key): (&&Query, &String)| match first.get(key).and_then(|at| made.get(at)) {
            Some(Ok(bytes)) => match self.given(query, bytes) {
                Ok(given) => Reply { given: Some(given), remarks: Vec::new() },
                Err(remark) => Reply { given: None, remarks: vec![remark] },
            },
            Some(Err(remark)) => Reply { given: None, remarks: vec![remark.clone()] },
            None => Reply::passes(Why::Failed, "it broke off"),
        };
        queries.iter().zip(&keys).map(reply).collect()
    }
}

/// Whether a file that was made can be used.
fn judged(bytes: &[u8]) -> Result<(), Box<Diagnostic>> {
    if bytes.len() > limits::BYTES {
        return Err(beyond(format!("it is larger than {} MB", limits::BYTES >> 20)));
    }
    let raw = glb::read(bytes)?;
    CatalogueModel::new("", Card::default(), raw, Axes::RightHanded, Vec::new()).map(drop)
}

/// What a model that was made is called in remarks.
fn named(prompt: &str) -> String {
    format!("the model made for \"{}\"", short(prompt))
}

/// Text of others on one line, not too long.
fn short(text: &str) -> String {
    let text = line(text);
    match text.char_indices().nth(SAID) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into_owned(),
    }
}
