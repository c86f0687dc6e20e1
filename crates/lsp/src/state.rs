//! The one owner of all state: takes messages in the order in which they came, hands questions to readers with a snapshot,
//! and publishes what they find only as long as it is about the newest text.

use crate::beside::{Beside, Show};
use crate::client::Client;
use crate::commands::Locks;
use crate::config::Config;
use crate::dispatch::{Context, Fault, sent};
use crate::documents::{Documents, OpenDocument};
use crate::drag::Drag;
use crate::jobs::Running;
use crate::model::Connect;
use crate::parked::Parked;
use crate::pool::Pool;
use crate::proved::Proofs;
use crate::publish::{Board, Findings, proofs, verdict};
use crate::reading::Reading;
use crate::record::Recorder;
use crate::text::Encoding;
use crate::told::{Changed, Published, registration, section};
use crate::trace::Trace;
use crate::{capabilities, disk, parent};
use futures::channel::{mpsc, oneshot};
use scenelang_layout::Layout;
use scenelang_llm::Account;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::HashMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Arc, mpsc as queue};
use std::time::{Duration, Instant};
use tower_lsp::jsonrpc::{self, Error, ErrorCode, Id, Request, Response};
use tower_lsp::ls_types::{
    ConfigurationParams, Diagnostic, DidChangeTextDocumentParams, DidChangeWatchedFilesParams,
    DidChangeWatchedFilesRegistrationOptions, DidChangeWorkspaceFoldersParams, DidCloseTextDocumentParams,
    DidOpenTextDocumentParams, DidSaveTextDocumentParams, FileSystemWatcher, GlobPattern, InitializeResult,
    NumberOrString, RegistrationParams, Uri, WorkDoneProgressCreateParams,
};

/// What a server needs to know besides what the client tells it.
#[derive(Default)]
pub struct Setup {
    /// Where the session is written down.
    pub record: Option<Recorder>,
    /// Reaches the language model that the settings of a workspace name.
    pub connect: Option<Connect>,
    /// Shows a room in a browser.
    pub show: Option<Show>,
}

/// What happens to the state.
pub enum Event {
    /// The client asks.
    Request {
        /// Its number for it.
        id: Id,
        method: String,
        /// About what.
        params: Value,
        /// Where the answer goes.
        reply: oneshot::Sender<jsonrpc::Result<Value>>,
    },
    /// The client tells.
    Notification {
        method: String,
        /// About what.
        params: Value,
    },
    /// The client answers.
    Answer(Response),
    /// Another thread has something to say.
    Done(Box<dyn FnOnce(&mut State) + Send>),
    /// The client is gone.
    Closed,
}

/// How far the session is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    New,
    Running,
    ShutDown,
}

/// A question that is being worked on.
struct Pending {
    method: String,
    began: Instant,
    reply: oneshot::Sender<jsonrpc::Result<Value>>,
    stop: Stop,
}

pub use scenelang_solve::Stop;

/// What is done with an answer of the client.
type Continuation = Box<dyn FnOnce(&mut State, Result<Value, Error>) + Send>;
/// How a question is answered; asked again if the text changes meanwhile.
pub type Work = Arc<dyn Fn(&Context) -> Result<Value, Fault> + Send + Sync>;

/// All state.
pub struct State {
    phase: Phase,
    /// How much the client wants to be told of what is done.
    trace: Trace,
    /// What the client can.
    pub client: Arc<Client>,
    /// What the user has set.
    pub config: Arc<Config>,
    /// What is open.
    pub documents: Documents,
    /// The folders of the workspace.
    pub roots: Arc<[PathBuf]>,
    board: Board,
    pool: Pool,
    pending: HashMap<Id, Pending>,
    asked: HashMap<i64, Continuation>,
    asks: i64,
    to_client: mpsc::UnboundedSender<Request>,
    events: queue::Sender<Event>,
    /// Long work by the request that asked for it.
    pub jobs: HashMap<Id, Running>,
    /// The same by the token of its progress.
    pub tokens: HashMap<String, (Id, Stop)>,
    /// Drags by document.
    pub drags: HashMap<String, Drag>,
    /// Layouts that were found for programs without one, by document.
    pub rooms: HashMap<String, Arc<Layout>>,
    /// Shows a room in a browser.
    pub show: Option<Show>,
    /// Rooms that are shown in a browser, by document.
    pub beside: HashMap<String, Beside>,
    /// The document that was asked about last.
    pub cursor: Option<String>,
    /// Reaches a language model.
    pub connect: Option<Connect>,
    /// What language models have cost since the server was started: one budget for all that is asked of them.
    pub account: Account,
    /// Whether something is being proved: one thing at a time.
    proving: bool,
    /// What waits for the files of a program, in order.
    pub parked: Vec<(String, Parked)>,
    /// Questions about the workspace that wait for a change.
    pub waiting: Vec<(Id, Value)>,
    /// How often they were looked at again.
    pub wakes: u64,
}

impl State {
    /// Nothing is open yet.
    pub fn new(setup: &Setup, events: queue::Sender<Event>, to_client: mpsc::UnboundedSender<Request>) -> Self {
        let mut documents = Documents::default();
        documents.read_by(Reading::new(events.clone()));
        Self {
            phase: Phase::New,
            trace: Trace::Off,
            client: Arc::new(Client::new(&Value::Null)),
            config: Arc::default(),
            documents,
            roots: Arc::default(),
            board: Board::default(),
            pool: Pool::new(),
            pending: HashMap::new(),
            asked: HashMap::new(),
            asks: 0,
            to_client,
            events,
            proving: false,
            parked: Vec::new(),
            jobs: HashMap::new(),
            tokens: HashMap::new(),
            drags: HashMap::new(),
            rooms: HashMap::new(),
            show: setup.show,
            beside: HashMap::new(),
            cursor: None,
            connect: setup.connect,
            account: Account::default(),
            waiting: Vec::new(),
            wakes: 0,
        }
    }

    /// Takes events until the client says `exit`, or is gone; the exit code.
    pub fn run(mut self, events: &queue::Receiver<Event>) -> u8 {
        while let Ok(event) = events.recv() {
            let mut next = Some(event);
            while let Some(event) = next {
                if let Some(code) = self.take(event) {
                    return code;
                }
                next = events.try_recv().ok();
            }
            // Nothing more has come: time to see what the changes mean.
            self.settle();
        }
        1
    }

    fn take(&mut self, event: Event) -> Option<u8> {
        match event {
            Event::Request { id, method, params, reply } => self.request(&id, &method, params, reply),
            Event::Notification { method, params } if method == "exit" => {
                drop(params);
                return Some(u8::from(self.phase != Phase::ShutDown));
            }
            Event::Notification { method, params } => self.notification(&method, params),
            Event::Answer(answer) => {
                let (id, body) = answer.into_parts();
                if let Id::Number(number) = id
                    && let Some(go_on) = self.asked.remove(&number)
                {
                    go_on(self, body);
                }
            }
            Event::Done(say) => say(self),
            Event::Closed => return Some(u8::from(self.phase != Phase::ShutDown)),
        }
        None
    }

    // ── Questions ──

    fn request(&mut self, id: &Id, method: &str, params: Value, reply: oneshot::Sender<jsonrpc::Result<Value>>) {
        match (self.phase, method) {
            (Phase::New, "initialize") => {
                let answer = self.initialize(&params);
                let _ = reply.send(sent(answer).map_err(Fault::into_error));
            }
            (Phase::New, _) => {
                let message = "the server is not initialized".into();
                let _ = reply.send(Err(Error { code: ErrorCode::ServerError(-32002), message, data: None }));
            }
            (Phase::ShutDown, _) | (Phase::Running, "initialize") => {
                let _ = reply.send(Err(Error::invalid_request()));
            }
            (Phase::Running, "shutdown") => {
                self.phase = Phase::ShutDown;
                for pending in self.pending.values() {
                    pending.stop.set();
                }
                let _ = reply.send(Ok(Value::Null));
            }
            (Phase::Running, _) => {
                self.log(|| format!("received request '{method} - ({id})'"), || format!("Params: {params}"));
                let began = Instant::now();
                let pending = Pending { method: method.to_owned(), began, reply, stop: Stop::default() };
                self.pending.insert(id.clone(), pending);
                self.ask(id.clone(), method.to_owned(), params);
            }
        }
    }

    /// Answers a question, unless it was cancelled.
    pub fn reply(&mut self, id: &Id, result: Result<Value, Fault>) {
        let Some(pending) = self.pending.remove(id) else { return };
        self.answer(id, pending, result.map_err(Fault::into_error));
    }

    fn answer(&self, id: &Id, pending: Pending, result: jsonrpc::Result<Value>) {
        let Pending { method, began, reply, .. } = pending;
        let say = || {
            let failed = result.as_ref().err().map(|e| format!(": {}", e.message)).unwrap_or_default();
            format!("sending response '{method} - ({id})' after {} ms{failed}", began.elapsed().as_millis())
        };
        self.log(say, || match &result {
            Ok(value) => format!("Result: {value}"),
            Err(error) => format!("Error: {} {}", error.code.code(), error.message),
        });
        let _ = reply.send(result);
    }

    /// Whether a question waits for its answer.
    pub fn is_pending(&self, id: &Id) -> bool {
        self.pending.contains_key(id)
    }

    /// Whether a question was cancelled, for whoever works on it.
    pub fn stop_of(&self, id: &Id) -> Stop {
        self.pending.get(id).map(|p| p.stop.clone()).unwrap_or_default()
    }

    /// Lets a reader answer a question about an open program; of any other document there is nothing to say.
    pub fn ask_reader(&mut self, id: &Id, uri: &str, work: Work) {
        self.documents.sync(uri);
        if self.documents.is_unread(uri) {
            return self.park(id, uri, work);
        }
        let Some(context) = self.context(uri) else { return self.reply(id, Ok(Value::Null)) };
        let (id, uri, stop, events) = (id.clone(), uri.to_owned(), self.stop_of(id), self.events.clone());
        self.pool.run(move || {
            if stop.is_set() {
                return;
            }
            let result = guarded(|| work(&context));
            drop(context);
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| match result {
                Err(Fault::Outdated) if state.pending.contains_key(&id) => state.ask_reader(&id, &uri, work),
                result => state.reply(&id, result),
            })));
        });
    }

    /// Has a thread do something.
    pub fn in_background(&self, work: impl FnOnce() + Send + 'static) {
        self.pool.run(work);
    }

    /// Lets a thread do something that needs no program.
    pub fn ask_pool(&mut self, id: &Id, work: impl FnOnce() -> Result<Value, Fault> + Send + 'static) {
        let (id, events) = (id.clone(), self.events.clone());
        self.pool.run(move || {
            let result = guarded(work);
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| state.reply(&id, result))));
        });
    }

    /// Where other threads say that they are done.
    pub fn events(&self) -> queue::Sender<Event> {
        self.events.clone()
    }

    /// What a reader sees of a program.
    pub fn context(&mut self, uri: &str) -> Option<Context> {
        self.documents.sync(uri);
        let open = self.documents.iter().map(|d| (d.path.clone(), d.uri.clone())).collect();
        let versions = self.documents.iter().map(|d| (d.uri.as_str().to_owned(), d.version)).collect();
        let document = self.documents.get(uri)?;
        let scene = document.scene.as_ref()?;
        Some(Context {
            uri: document.uri.clone(),
            path: document.path.clone(),
            text: Arc::clone(&document.text),
            snapshot: scene.host.snapshot(),
            layout: scene.layout.clone(),
            settings: Arc::clone(&scene.settings),
            generation: scene.generation,
            client: Arc::clone(&self.client),
            config: Arc::clone(&self.config),
            tokens: Arc::clone(&scene.tokens),
            looks: Arc::clone(&scene.looks),
            open,
            versions,
            files: self.documents.files(),
            roots: Arc::clone(&self.roots),
        })
    }

    // ── What the client tells ──

    fn notification(&mut self, method: &str, params: Value) {
        if self.phase == Phase::Running {
            self.log(|| format!("received notification '{method}'"), || format!("Params: {params}"));
        }
        match (self.phase, method) {
            (Phase::Running, "$/setTrace") => self.trace = Trace::read(&params["value"]),
            (_, "$/cancelRequest") => self.cancel(&params["id"]),
            (Phase::Running, "window/workDoneProgress/cancel") => self.cancel_progress(&params["token"]),
            (Phase::Running, "initialized") => self.initialized(),
            (Phase::Running, "textDocument/didOpen") => self.with(params, Self::opened),
            (Phase::Running, "textDocument/didChange") => self.with(params, Self::changed),
            (Phase::Running, "textDocument/didClose") => self.with(params, |s, p| s.closed(&p)),
            (Phase::Running, "textDocument/didSave") => self.with(params, |s, p| s.saved(&p)),
            (Phase::Running, "scenelang/lock") => {
                self.with(params, |s, p: Locks| s.documents.lock(p.uri.as_str(), p.objects))
            }
            (Phase::Running, "workspace/didChangeConfiguration") => self.configured(&params),
            (Phase::Running, "workspace/didChangeWatchedFiles") => self.with(params, |s, p| s.watched(&p)),
            (Phase::Running, "workspace/didChangeWorkspaceFolders") => self.with(params, |s, p| s.folders(&p)),
            _ => {}
        }
    }

    /// Does something with parameters; what does not read as such is passed over, for nobody waits for an answer.
    fn with<P: DeserializeOwned>(&mut self, params: Value, then: impl FnOnce(&mut Self, P)) {
        if let Ok(params) = P::deserialize(params) {
            then(self, params);
        }
    }

    fn cancel(&mut self, id: &Value) {
        let Ok(id) = Id::deserialize(id) else { return };
        let Some(pending) = self.pending.remove(&id) else { return };
        pending.stop.set();
        self.answer(&id, pending, Err(Error::request_cancelled()));
    }

    fn opened(&mut self, params: DidOpenTextDocumentParams) {
        let d = params.text_document;
        let key = d.uri.as_str().to_owned();
        self.documents.open(d.uri, &d.language_id, d.version, d.text, &self.config);
        // What it said before it was opened again is not what the editor shows now.
        let _ = self.board.remove(&key);
    }

    fn changed(&mut self, params: DidChangeTextDocumentParams) {
        let key = params.text_document.uri.as_str().to_owned();
        let encoding = self.encoding();
        let Some(document) = self.documents.get_mut(&key) else { return };
        document.version = params.text_document.version;
        let text = Arc::make_mut(&mut document.text);
        for change in params.content_changes {
            text.change(change, encoding);
        }
        if let Some(scene) = &mut document.scene {
            scene.stale_text = true;
        }
        let path = document.path.clone();
        self.documents.touched(&path, &key);
    }

    fn closed(&mut self, params: &DidCloseTextDocumentParams) {
        let key = params.text_document.uri.as_str();
        if self.documents.close(key) {
            self.drags.remove(key);
            self.rooms.remove(key);
            self.unpark();
            for (uri, marks) in self.board.remove(key) {
                self.publish(&uri, &marks);
            }
        }
    }

    fn saved(&mut self, params: &DidSaveTextDocumentParams) {
        let key = params.text_document.uri.as_str();
        if let Some(path) = self.documents.get(key).map(|d| d.path.clone()) {
            self.documents.touched(&path, key);
        }
        if let Some(scene) = self.documents.get_mut(key).and_then(|d| d.scene.as_mut()) {
            scene.unproved = true;
            scene.published = 0;
        }
    }

    fn watched(&mut self, params: &DidChangeWatchedFilesParams) {
        self.changed_on_disk(params.changes.iter().map(|change| disk::path_of(&change.uri)));
    }

    /// Files are other than they were.
    pub fn changed_on_disk(&mut self, paths: impl IntoIterator<Item = PathBuf>) {
        for path in paths {
            // Of what is open, the editor's text counts.
            if self.documents.at(&path).is_none() {
                self.documents.forget(&path);
                self.documents.touched(&path, "");
            }
        }
        self.wake();
    }

    fn folders(&mut self, params: &DidChangeWorkspaceFoldersParams) {
        let removed: Vec<PathBuf> = params.event.removed.iter().map(|f| disk::path_of(&f.uri)).collect();
        let kept = self.roots.iter().filter(|root| !removed.contains(root)).cloned();
        self.roots = kept.chain(params.event.added.iter().map(|f| disk::path_of(&f.uri))).collect();
        self.documents.set_folders(&self.roots);
        self.wake();
    }

    // ── Beginning ──

    fn initialize(&mut self, params: &Value) -> InitializeResult {
        self.phase = Phase::Running;
        self.trace = Trace::read(&params["trace"]);
        self.client = Arc::new(Client::new(params));
        self.documents.count_in(self.client.encoding);
        let folder = |value: &Value| Uri::deserialize(value).ok().map(|uri| disk::path_of(&uri));
        let folders = params["workspaceFolders"].as_array();
        self.roots = match folders {
            Some(list) => list.iter().filter_map(|f| folder(&f["uri"])).collect(),
            None => folder(&params["rootUri"]).into_iter().collect(),
        };
        self.documents.set_folders(&self.roots);
        if params["initializationOptions"].is_object() {
            self.config = Arc::new(Config::read(&params["initializationOptions"]));
        }
        if let Some(process) = params["processId"].as_u64().and_then(|p| u32::try_from(p).ok()) {
            let events = self.events.clone();
            parent::watch(process, move || {
                let _ = events.send(Event::Closed);
                // Whoever should close our input is gone, and may have left it open.
                std::thread::sleep(Duration::from_millis(500));
                std::process::exit(1);
            });
        }
        capabilities::of(&self.client)
    }

    fn initialized(&mut self) {
        let mut registrations = Vec::new();
        if self.client.watches_files {
            let watched =
                |glob: &str| FileSystemWatcher { glob_pattern: GlobPattern::String(glob.to_owned()), kind: None };
            let watchers = ["**/*.scene", "**/*.json", "**/scenelang.toml"].map(watched).to_vec();
            let options = DidChangeWatchedFilesRegistrationOptions { watchers };
            registrations.push(registration("files", "workspace/didChangeWatchedFiles", options));
        } else {
            self.look_at_files();
        }
        if self.client.watches_configuration {
            registrations.push(registration("configuration", "workspace/didChangeConfiguration", section()));
        }
        if !registrations.is_empty() {
            self.ask_client("client/registerCapability", RegistrationParams { registrations }, |_, _| {});
        }
        self.pull_configuration();
    }

    /// Settings came along, or must be asked for.
    fn configured(&mut self, params: &Value) {
        let section = &params["settings"]["scenelang"];
        if section.is_object() {
            self.reconfigure(section);
        } else {
            self.pull_configuration();
        }
    }

    fn pull_configuration(&mut self) {
        if self.client.configuration {
            self.ask_client(
                "workspace/configuration",
                ConfigurationParams { items: vec![section()] },
                |state, answer| {
                    if let Ok(values) = answer
                        && values[0].is_object()
                    {
                        state.reconfigure(&values[0]);
                    }
                },
            );
        }
    }

    fn reconfigure(&mut self, section: &Value) {
        let config = Config::read(section);
        if config != *self.config {
            self.documents.reconfigured(&config);
            self.config = Arc::new(config);
        }
    }

    fn encoding(&self) -> Encoding {
        self.client.encoding
    }

    // ── What changes mean ──

    /// Has judged again whatever has changed.
    fn settle(&mut self) {
        self.abandon();
        let stale = |d: &OpenDocument| {
            d.scene.as_ref().is_some_and(|s| s.stale_text || s.stale_layout || s.generation != s.published)
        };
        let keys: Vec<String> = self.documents.iter().filter(|d| stale(d)).map(|d| d.uri.as_str().to_owned()).collect();
        for key in keys {
            let judging = self.documents.get(&key).and_then(|d| d.scene.as_ref()).is_some_and(|s| s.judging);
            // One verdict at a time: the next begins when this one is there, or was found outdated.
            if judging {
                self.documents.sync(&key);
                continue;
            }
            self.documents.sync(&key);
            if self.documents.is_unread(&key) {
                continue;
            }
            let Some(context) = self.context(&key) else { continue };
            if let Some(scene) = self.documents.get_mut(&key).and_then(|d| d.scene.as_mut()) {
                scene.judging = true;
            }
            let events = self.events.clone();
            self.pool.run(move || {
                let generation = context.generation;
                let found = guarded(|| Ok(verdict(&context)?));
                drop(context);
                let _ = events.send(Event::Done(Box::new(move |state| state.judged(&key, generation, found))));
            });
        }
    }

    fn judged(&mut self, key: &str, generation: u64, found: Result<Findings, Fault>) {
        let Some(OpenDocument { uri, scene: Some(scene), .. }) = self.documents.get_mut(key) else { return };
        scene.judging = false;
        if scene.generation != generation || scene.stale_text || scene.stale_layout {
            return;
        }
        // A verdict that could not be had is not tried again until something changes.
        scene.published = generation;
        let outside = std::mem::take(&mut scene.outside);
        let Ok(Findings { marks, count }) = found else { return };
        let layout = scene.layout.as_deref().filter(|_| count.is_some()).and_then(disk::uri_of);
        let [holds, total] = count.unwrap_or_default();
        let changed = Changed { uri: uri.clone(), holds, total, layout };
        self.log(|| format!("checked {key}: {holds} of {total} hold"), || format!("generation {generation}"));
        for (uri, marks) in self.board.put(key, marks) {
            self.publish(&uri, &marks);
        }
        self.tell("scenelang/changed", changed);
        if outside {
            for request in self.client.refreshes.clone() {
                self.ask_client(request, (), |_, _| {});
            }
        }
        self.wake();
        self.prove(key);
    }

    /// Looks for proofs about a program now.
    pub fn prove_now(&mut self, key: &str) {
        if let Some(scene) = self.documents.get_mut(key).and_then(|d| d.scene.as_mut()) {
            scene.unproved = true;
            self.prove(key);
        }
    }

    /// Looks for proofs about a program that was opened or saved: that takes too long to be done after each keystroke.
    fn prove(&mut self, key: &str) {
        let Some(scene) = self.documents.get_mut(key).and_then(|d| d.scene.as_mut()) else { return };
        // What is published first is the verdict.
        if !scene.unproved || self.proving || scene.published != scene.generation {
            return;
        }
        if scene.is_stale() {
            // The verdict on what it is now comes first.
            return;
        }
        scene.unproved = false;
        let meaning = scene.meaning;
        let Some(context) = self.context(key) else { return };
        self.proving = true;
        let (key, events) = (key.to_owned(), self.events.clone());
        std::thread::spawn(move || {
            let text = Arc::clone(&context.text);
            let found = guarded(|| proofs(context));
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| {
                state.proving = false;
                state.proved(&key, meaning, found.map(|marks| Proofs::new(marks, text)));
                let wanted = state.documents.iter().filter(|d| d.scene.as_ref().is_some_and(|s| s.unproved));
                let wanted: Vec<String> = wanted.map(|d| d.uri.as_str().to_owned()).collect();
                // The first of them that can be.
                wanted.iter().for_each(|key| state.prove(key));
            })));
        });
    }

    /// What was proved of a program that said `meaning`.
    fn proved(&mut self, key: &str, meaning: u64, found: Result<Proofs, Fault>) {
        let encoding = self.encoding();
        let Some(OpenDocument { text, scene: Some(scene), .. }) = self.documents.get_mut(key) else { return };
        if scene.meaning != meaning || scene.stale_text || matches!(found, Err(Fault::Outdated)) {
            // It was asked for, and is not known of what the program says by now.
            scene.unproved = true;
            return;
        }
        let Ok(mut found) = found else { return };
        found.follow(key, text, encoding);
        scene.proofs = found;
        // Where a verdict is still to come, it takes them along: what was said before is not about this text.
        if scene.published == scene.generation {
            let marks = self.board.about(key);
            self.publish(key, &marks);
        }
    }

    /// Looks again at questions that were waiting for a change.
    fn wake(&mut self) {
        self.wakes += 1;
        for (id, params) in std::mem::take(&mut self.waiting) {
            if self.pending.contains_key(&id)
                && let Err(fault) = self.dispatch(&id, "workspace/diagnostic", params)
            {
                self.reply(&id, Err(fault));
            }
        }
    }

    /// Says what is marked in a file. What the client asks for itself it is not told, but for what is proved, which takes
    /// longer than it would want to wait.
    fn publish(&mut self, uri: &str, marks: &[Diagnostic]) {
        let document = self.documents.get(uri);
        let mut all: Vec<Diagnostic> = Vec::new();
        let pulled = self.client.pulls && document.is_some_and(|d| d.scene.is_some());
        if !pulled {
            all.extend(marks.iter().cloned());
        }
        let version = document.map(|d| d.version);
        if let Some(scene) = self.documents.get_mut(uri).and_then(|d| d.scene.as_mut()) {
            all.extend(scene.proofs.marks().iter().cloned());
            let told = std::mem::replace(&mut scene.told_proofs, !scene.proofs.marks().is_empty());
            if pulled && !told && !scene.told_proofs {
                return;
            }
        }
        self.tell("textDocument/publishDiagnostics", Published { uri, diagnostics: all, version });
    }

    // ── The other direction ──

    /// A token for progress, if the client shows that.
    pub fn new_token(&mut self) -> Option<Value> {
        if !self.client.progress {
            return None;
        }
        let token = format!("scenelang/{}", self.asks + 1);
        let params = WorkDoneProgressCreateParams { token: NumberOrString::String(token.clone()) };
        self.ask_client("window/workDoneProgress/create", params, |_, _| {});
        Some(token.into())
    }

    /// Tells of what is done, as much of it as the client wants.
    fn log(&self, message: impl FnOnce() -> String, about: impl FnOnce() -> String) {
        if let Some(entry) = self.trace.entry(message, about) {
            self.tell("$/logTrace", entry);
        }
    }

    /// For threads that tell the client something themselves.
    pub fn sender(&self) -> mpsc::UnboundedSender<Request> {
        self.to_client.clone()
    }

    /// Tells the client something.
    pub fn tell(&self, method: &'static str, params: impl Serialize) {
        let Ok(params) = sent(params) else { return };
        let _ = self.to_client.unbounded_send(Request::build(method).params(params).finish());
    }

    /// Asks the client something, and goes on when it answers. Nothing waits for that. Parameters of `()` are none.
    pub fn ask_client(
        &mut self,
        method: &'static str,
        params: impl Serialize,
        then: impl FnOnce(&mut State, Result<Value, Error>) + Send + 'static,
    ) {
        let Ok(params) = sent(params) else { return };
        self.asks += 1;
        self.asked.insert(self.asks, Box::new(then));
        let request = Request::build(method).id(self.asks);
        let request = if params.is_null() { request } else { request.params(params) };
        let _ = self.to_client.unbounded_send(request.finish());
    }
}

/// Runs what a message made us do; a mistake of ours ends the question and not the server.
pub fn guarded<T>(work: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Err(Fault::Internal))
}
