//! Long work: it has a thread of its own, says how far it is, can be cancelled, and its result is an edit.

use crate::change::{TextChange, WorkspaceChange};
use crate::convert::Places;
use crate::disk::{Reach, uri_of};
use crate::dispatch::{Context, Fault, sent};
use crate::model::Advisers;
use crate::state::{Event, State, Stop, guarded};
use crate::text::Text;
use scenelang_analysis::Judging;
use scenelang_base::door::relative;
use scenelang_base::owned::{self, Standing};
use scenelang_base::{Edit, FileId, SourceMap, TextRange, fix};
use scenelang_engine::check_read;
use scenelang_export::scene::Memory;
use scenelang_ide::actions::{self, Ghost};
use scenelang_ide::{Compiled, LayoutFile};
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, file as layout_file};
use scenelang_verify::settings::Llm;
use scenelang_verify::{CheckVerdict, Explain};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tower_lsp::jsonrpc::{Id, Request};
use tower_lsp::ls_types::{
    ChangeAnnotation, LogMessageParams, MessageType, Uri, WorkDoneProgress, WorkDoneProgressBegin, WorkDoneProgressEnd,
    WorkDoneProgressReport,
};

/// How often progress is told at most.
const EVERY: Duration = Duration::from_millis(100);

/// What long work has: copies, so that nobody waits for it.
pub struct Job {
    /// The program.
    pub compiled: Arc<Compiled>,
    /// Its files.
    pub sources: Arc<SourceMap>,
    /// Its own.
    pub main: FileId,
    /// Where it is.
    pub path: PathBuf,
    pub layout: Option<Arc<LayoutFile>>,
    /// Where that is, or would be.
    pub layout_path: Option<PathBuf>,
    /// Where everything is in the room that is shown as long as there is no layout.
    pub provisional: Option<Arc<Layout>>,
    pub judging: Judging,
    /// Objects that the user has locked.
    pub locked: Vec<ObjectId>,
    /// Which language model is asked.
    pub llm: Llm,
    /// Open texts, then the disk.
    pub files: Reach,
    /// Whether the result is wanted.
    pub stop: Stop,
    /// Where progress is told.
    pub progress: Progress,
    /// What the objects of its room look like.
    pub looks: Arc<Memory>,
    /// How a language model is reached.
    pub advisers: Advisers,
    text: Arc<Text>,
    open: BTreeMap<PathBuf, Uri>,
    versions: BTreeMap<String, i32>,
    client: Arc<crate::client::Client>,
}

impl Job {
    /// Places in the program's files.
    pub fn places(&self) -> Places<'_> {
        Places::new(&self.sources, self.client.encoding, &self.open, (self.main, Arc::clone(&self.text)))
    }

    /// What holds in a layout of the program, as it would be read from its file.
    pub fn verdict(&self, layout: &Layout, explain: usize) -> CheckVerdict {
        let read = layout_file::read(&layout_file::to_json(layout, None), FileId(0));
        let mut options = self.judging.options;
        options.detail.explain = Explain::First(explain);
        options.detail.sentences = false;
        check_read(&self.compiled.program, &read, &options)
    }

    /// The edit that makes the layout another one.
    ///
    /// # Errors
    /// The document has no place for a layout.
    pub fn layout_edit(&self, layout: &Layout) -> Result<LayoutEdit, Fault> {
        let path = self.layout_path.clone();
        let (path, uri) = path
            .and_then(|path| Some((self.open.get(&path).cloned().or_else(|| uri_of(&path))?, path)))
            .map(|(uri, path)| (path, uri))
            .ok_or_else(|| Fault::Failed("save the program first: its layout is written beside it".to_owned()))?;
        self.files.door().permits(&path).map_err(|e| Fault::Failed(format!("cannot write {}: {e}", path.display())))?;
        // Where layouts are is said by a setting, which may come with the workspace; it does not say to overwrite other files.
        let known = path.to_string_lossy().ends_with(".layout.json");
        if !known && self.layout.as_ref().is_some_and(|l| !l.read.usable) {
            return Err(Fault::Failed(format!("{} is not a layout and is left unchanged", path.display())));
        }
        let mut layout = layout.clone();
        if layout.scene.is_none() {
            layout.scene = Some(relative(&self.path, path.parent().unwrap_or(Path::new(""))));
        }
        let there = self.layout.as_ref().filter(|l| l.read.usable);
        let old = self.layout.as_ref().map(|l| self.sources.get(l.file).text());
        let before = old.map(|old| Text::new(old.to_owned()));
        // The command line replaces what scenelang wrote, and nothing that somebody edited.
        let ours = old.is_none_or(|old| matches!(owned::said(old.as_bytes()), Standing::Ours | Standing::Free));
        // What somebody edited keeps its form.
        if let (Some(there), Some(old), false) = (there, old, ours)
            && let Some(edits) = actions::changing(there, old, &layout)
        {
            let edits: Vec<Edit<TextRange>> =
                edits.into_iter().map(|e| Edit { place: e.place.range, text: e.text }).collect();
            let text = fix::apply(old, [edits.as_slice()]).text;
            return Ok(LayoutEdit { path, uri, text, old: before, edits });
        }
        let text = layout_file::to_json(&layout, there.map(|l| &l.read.document));
        let text = if ours { owned::sealed_json(&text) } else { text };
        let edits = old.map_or_else(Vec::new, |old| scenelang_ide::format::differences(old, &text));
        let edits = edits.into_iter().map(|(place, text)| Edit { place, text }).collect();
        Ok(LayoutEdit { path, uri, text, old: before, edits })
    }

    /// Edits of the layout and of the program as a change of the workspace; `note` says what it does, for editors that
    /// show that before. `None`: nothing would change, which editors take for a failure of theirs. A layout that is not
    /// there yet is no part of it: that file is written.
    pub fn change(&self, layout: Option<&LayoutEdit>, program: &[Edit], note: &str) -> Option<WorkspaceChange> {
        let encoding = self.client.encoding;
        let mut by_file = self.places().by_file(program);
        if let Some(LayoutEdit { uri, old: Some(old), edits, .. }) = layout.filter(|l| !l.edits.is_empty()) {
            let changes = edits.iter().map(|e| TextChange::new(old.range(e.place, encoding), e.text.clone()));
            by_file.entry(uri.as_str().to_owned()).or_default().extend(changes);
        }
        if by_file.is_empty() {
            return None;
        }
        let mut out = WorkspaceChange::new(by_file, self.client.document_changes.then_some(&self.versions));
        if self.client.annotates && !note.is_empty() {
            let (label, rest) = note.split_once('\n').unwrap_or((note, ""));
            let (label, description) = (label.to_owned(), Some(rest.to_owned()));
            out.annotate(ChangeAnnotation { label, description, needs_confirmation: None });
        }
        Some(out)
    }
}

/// Another text for the layout.
pub struct LayoutEdit {
    pub path: PathBuf,
    /// The address of that.
    pub uri: Uri,
    /// All of it.
    pub text: String,
    /// What it was; `None`: there was none.
    pub old: Option<Text>,
    /// What makes it of that.
    pub edits: Vec<Edit<TextRange>>,
}

/// What came of long work.
pub struct JobOutcome {
    /// The layout afterwards.
    pub layout: Option<LayoutEdit>,
    /// The change that the client is asked to make.
    pub edit: Option<WorkspaceChange>,
    /// What was done, in a sentence.
    pub message: String,
    /// How many constraints hold afterwards, of how many.
    pub count: [usize; 2],
    /// Where objects are afterwards, if that is shown before.
    pub moves: Vec<Ghost>,
}

/// Says how far long work is.
#[derive(Clone)]
pub struct Progress {
    token: Option<Value>,
    to_client: futures::channel::mpsc::UnboundedSender<Request>,
    last: Arc<Mutex<Option<Instant>>>,
}

impl Progress {
    /// What is being done now.
    pub fn say(&self, message: &str) {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.is_none_or(|at| at.elapsed() >= EVERY) {
            *last = Some(Instant::now());
            self.tell(reported(message));
        }
    }

    /// Something that the user should find again: shown as progress, and kept in the editor's log.
    pub fn log(&self, message: &str) {
        self.tell(reported(message));
        self.send("window/logMessage", LogMessageParams { typ: MessageType::INFO, message: message.to_owned() });
    }

    fn tell(&self, value: WorkDoneProgress) {
        if let Some(token) = &self.token {
            self.send("$/progress", Told { token, value });
        }
    }

    fn send(&self, method: &'static str, params: impl Serialize) {
        if let Ok(params) = sent(params) {
            let _ = self.to_client.unbounded_send(Request::build(method).params(params).finish());
        }
    }
}

/// Parameters of `$/progress`; a token of the client is given back as it came.
#[derive(Serialize)]
struct Told<'a> {
    token: &'a Value,
    value: WorkDoneProgress,
}

fn reported(message: &str) -> WorkDoneProgress {
    WorkDoneProgress::Report(WorkDoneProgressReport { message: Some(message.to_owned()), ..Default::default() })
}

/// What commands that change something answer, and `scenelang.check`.
#[derive(Serialize)]
struct Done {
    /// What was done, in a sentence.
    message: String,
    /// How many constraints hold afterwards, of how many.
    holds: usize,
    total: usize,
}

/// What a repair answers that is only proposed.
#[derive(Serialize)]
struct Proposal {
    /// What would be done: a title, then a line for each margin that changes.
    message: String,
    /// How many constraints would hold, of how many.
    holds: usize,
    total: usize,
    /// null: there is nothing to do.
    edit: Option<WorkspaceChange>,
    #[serde(flatten)]
    shown: Shown,
}

/// Where a change would put objects of a program: for a picture of it before it is made.
#[derive(Clone, Deserialize, Serialize)]
pub struct Shown {
    pub uri: Uri,
    pub moves: Vec<Moved>,
    /// What would be written in the program.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub texts: Vec<Written>,
    /// Which margins it would change, in words, as soon as that has been worked out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub margins: Vec<String>,
}

/// Where an object stands afterwards.
#[derive(Clone, Deserialize, Serialize)]
pub struct Moved {
    pub object: String,
    pub pos: [f64; 3],
    pub rot: [f64; 3],
}

/// Another text for bytes of the program.
#[derive(Clone, Deserialize, Serialize)]
pub struct Written {
    pub bytes: [u32; 2],
    pub text: String,
}

impl Shown {
    pub fn new(uri: Uri, moves: &[Ghost]) -> Self {
        let moved = |m: &Ghost| Moved { object: m.object.clone(), pos: m.pos.into(), rot: m.rot.into() };
        Self { uri, moves: moves.iter().map(moved).collect(), texts: Vec::new(), margins: Vec::new() }
    }
}

/// Parameters of `workspace/applyEdit`.
#[derive(Serialize)]
struct Apply {
    label: String,
    edit: WorkspaceChange,
}

/// Long work that has not ended.
pub struct Running {
    stop: Stop,
    /// The program that it is about, and what that was when it began.
    uri: String,
    generation: u64,
}

/// How the result of a job is used.
pub type Finish<T> = Box<dyn FnOnce(&mut State, &Id, T) + Send>;

impl State {
    /// Begins long work about a program. `given`: the token of the client for its progress, if it has one.
    ///
    /// # Errors
    /// There is no such program, or it has errors.
    pub fn begin<T: Send + 'static>(
        &mut self,
        id: &Id,
        uri: &str,
        title: &str,
        given: Option<Value>,
        work: impl FnOnce(&Job) -> Result<T, Fault> + Send + 'static,
        finish: Finish<T>,
    ) -> Result<(), Fault> {
        let context = self.context(uri).ok_or_else(|| Fault::Invalid(format!("{uri} is not an open program")))?;
        let token = given.or_else(|| self.new_token());
        let stop = self.stop_of(id);
        if let Some(token) = &token {
            self.tokens.insert(token.to_string(), (id.clone(), stop.clone()));
        }
        let running = Running { stop: stop.clone(), uri: uri.to_owned(), generation: context.generation };
        self.jobs.insert(id.clone(), running);
        let progress = Progress { token: token.clone(), to_client: self.sender(), last: Arc::default() };
        let (title, cancellable) = (title.to_owned(), Some(true));
        let begin = WorkDoneProgressBegin { title, cancellable, ..Default::default() };
        progress.tell(WorkDoneProgress::Begin(begin));
        let advisers = self.advisers(stop.clone());
        let provisional = self.rooms.get(uri).cloned();
        let (id, events, generation) = (id.clone(), self.events(), context.generation);
        let uri = uri.to_owned();
        let thread = std::thread::Builder::new().name("job".to_owned()).stack_size(16 << 20);
        let done = progress.clone();
        let spawned = thread.spawn(move || {
            let result = guarded(|| {
                let job = job_of(context, provisional, (stop, progress, advisers))?;
                let outcome = work(&job)?;
                if job.stop.is_set() { Err(Fault::Cancelled) } else { Ok(outcome) }
            });
            done.tell(WorkDoneProgress::End(WorkDoneProgressEnd::default()));
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| {
                state.jobs.remove(&id);
                if let Some(token) = token {
                    state.tokens.remove(&token.to_string());
                }
                match result {
                    // An edit of what is there no more would undo what was written meanwhile.
                    Ok(_) | Err(Fault::Cancelled) if !state.is_current(&uri, generation) => {
                        let why = "the scene was changed in the meantime; nothing was done".to_owned();
                        state.reply(&id, Err(Fault::Failed(why)));
                    }
                    Ok(outcome) => finish(state, &id, outcome),
                    Err(fault) => state.reply(&id, Err(fault)),
                }
            })));
        });
        spawned.map(drop).map_err(|e| Fault::Failed(format!("cannot start a thread: {e}")))
    }

    /// Whether a program and its layout are what they were.
    fn is_current(&self, uri: &str, generation: u64) -> bool {
        let now = self.documents.get(uri).and_then(|d| d.scene.as_ref());
        now.is_some_and(|s| s.generation == generation && !s.stale_text && !s.stale_layout)
    }

    /// Ends long work about what has changed: nobody would use its result.
    pub fn abandon(&mut self) {
        for job in self.jobs.values().filter(|job| !self.is_current(&job.uri, job.generation)) {
            job.stop.set();
        }
    }

    /// Somebody pressed "cancel" where progress is shown.
    pub fn cancel_progress(&mut self, token: &Value) {
        if let Some((id, stop)) = self.tokens.remove(&token.to_string()) {
            stop.set();
            self.reply(&id, Err(Fault::Cancelled));
        }
    }

    /// Answers with the change of an outcome, which the client shows, and makes if it is wanted.
    pub fn propose(&mut self, id: &Id, uri: Uri, outcome: JobOutcome) {
        let [holds, total] = outcome.count;
        let JobOutcome { message, edit, moves, .. } = outcome;
        self.reply(id, sent(Proposal { message, holds, total, edit, shown: Shown::new(uri, &moves) }));
    }

    /// Asks the client to make the change of an outcome, and answers then.
    pub fn apply(&mut self, id: &Id, outcome: JobOutcome) {
        let [holds, total] = outcome.count;
        let done = Done { message: outcome.message.clone(), holds, total };
        match sent(done) {
            Ok(answer) => self.apply_with(id, outcome, answer),
            Err(fault) => self.reply(id, Err(fault)),
        }
    }

    /// The same with another answer.
    pub fn apply_with(&mut self, id: &Id, outcome: JobOutcome, answer: Value) {
        let JobOutcome { layout, edit, message, .. } = outcome;
        // An editor that makes a file makes it empty, and has what is in it in a buffer that nobody has saved.
        if layout.as_ref().is_some_and(|l| l.old.is_none()) {
            return self.write(id, layout, answer);
        }
        let Some(edit) = edit else { return self.reply(id, Ok(answer)) };
        if !self.client.applies {
            return self.write(id, layout, answer);
        }
        let id = id.clone();
        self.ask_client("workspace/applyEdit", Apply { label: message, edit }, move |state, applied| {
            let applied = applied.is_ok_and(|a| a["applied"].as_bool() == Some(true));
            if applied && let Some(layout) = layout {
                state.documents.assume(&layout.path, layout.text);
            }
            let refused = || Fault::Failed("the editor did not apply the change".to_owned());
            state.reply(&id, if applied { Ok(answer) } else { Err(refused()) });
        });
    }

    /// Writes a layout that is not there yet, or where the client cannot.
    fn write(&mut self, id: &Id, layout: Option<LayoutEdit>, answer: Value) {
        let Some(layout) = layout else {
            return self.reply(id, Err(Fault::Failed("the editor cannot make changes".to_owned())));
        };
        let door = self.documents.files().of(&layout.path);
        let (id, events) = (id.clone(), self.events());
        self.in_background(move || {
            let appeared = layout.old.is_none() && door.door().is_file(&layout.path);
            let written = if appeared {
                let say = format!("{} was created in the meantime and is left unchanged", layout.path.display());
                Err(std::io::Error::new(std::io::ErrorKind::AlreadyExists, say))
            } else {
                door.door().write(&layout.path, layout.text.as_bytes())
            };
            let _ = events.send(Event::Done(Box::new(move |state: &mut State| {
                state.documents.touched(&layout.path, "");
                state.reply(&id, written.map(|()| answer).map_err(|e| Fault::Failed(e.to_string())));
            })));
        });
    }
}

fn job_of(
    context: Context,
    provisional: Option<Arc<Layout>>,
    (stop, progress, advisers): (Stop, Progress, Advisers),
) -> Result<Job, Fault> {
    let compiled = context.snapshot.compiled()?;
    if !compiled.complete {
        return Err(Fault::Failed("the program has errors; fix these first".to_owned()));
    }
    let Context { path, text, snapshot, layout: layout_path, settings, client, looks, open, versions, files, .. } =
        context;
    if settings.is_broken() {
        return Err(Fault::Failed("scenelang.toml has errors; fix these first".to_owned()));
    }
    let files = files.of(&path);
    let llm = settings.settings.llm.clone();
    let judging = snapshot.judging().clone();
    let locked = snapshot.locked(&compiled.program);
    let layout = snapshot.layout_file();
    let (sources, main) = snapshot.into_sources();
    Ok(Job {
        compiled,
        sources,
        main,
        path,
        layout,
        layout_path,
        provisional,
        judging,
        locked,
        llm,
        files,
        stop,
        progress,
        looks,
        advisers,
        text,
        open,
        versions,
        client,
    })
}
