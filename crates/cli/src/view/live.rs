//! The room that is shown: read anew when a file changes, judged while something in it is dragged, written when it is let go.

use crate::room::CheckedLayout;
use crate::watch::Seen;
use scenelang_base::door::Door;
use scenelang_engine::Live;
use scenelang_export::preview;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, Vec3, file as layout_file};
use scenelang_verify::check::check;
use scenelang_verify::report;
use serde::Deserialize;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// What a page asks: an object elsewhere.
#[derive(Deserialize)]
pub struct Move {
    object: String,
    /// Metres.
    pos: [f64; 3],
    /// Degrees.
    rot: [f64; 3],
    /// Whether the layout is to be changed, or only judged as if it were.
    commit: bool,
}

/// Why a move is not made, or not judged.
pub enum Refused {
    /// What is asked cannot be.
    Wrong(String),
    /// The file is not what the page has seen.
    Changed(String),
    /// It could not be written.
    Failed(String),
}

/// What all pages show.
pub struct Shown {
    file: PathBuf,
    state: Mutex<State>,
    news: Condvar,
}

struct State {
    news: News,
    room: Option<Arc<CheckedLayout>>,
    /// The room for the page.
    data: Option<Told>,
    /// What is dragged at the moment.
    drag: Option<Drag>,
}

/// What pages have to be told.
#[derive(Clone, Debug)]
pub struct News {
    /// Counts all of it.
    pub version: u64,
    /// Counts rooms.
    pub rooms: u64,
    /// Why there is no room, or why it is old.
    pub why: Option<String>,
    /// Counts selections.
    pub selections: u64,
    /// What is selected: an object by name, or a row of the report by its id.
    pub selected: String,
}

impl News {
    /// Nothing has been read.
    pub fn none() -> Self {
        let why = Some("it is being read".to_owned());
        Self { version: 0, rooms: 0, why, selections: 0, selected: String::new() }
    }
}

/// A room as JSON.
#[derive(PartialEq)]
struct Told {
    /// Names the geometry.
    shape: String,
    whole: String,
    /// Without the geometry.
    places: String,
}

impl Told {
    fn new(room: &CheckedLayout) -> Result<Self, String> {
        let mut told = preview::live(room.scene()?, None, true).map_err(|e| e.to_string())?;
        let (shape, whole) = (told["shape"].as_str().unwrap_or_default().to_owned(), told.to_string());
        told["glb"] = Value::Null;
        Ok(Self { shape, whole, places: told.to_string() })
    }
}

impl Shown {
    /// Nothing yet; `file` is a program or a layout.
    pub fn new(file: &Path) -> Self {
        let state = State { news: News::none(), room: None, data: None, drag: None };
        Self { file: file.to_path_buf(), state: Mutex::new(state), news: Condvar::new() }
    }

    /// Reads the files again, and tells all pages if anything is different.
    pub fn read(&self, seen: &Seen) {
        let read = CheckedLayout::read(&self.file, Some(seen)).and_then(|room| Ok((Told::new(&room)?, room)));
        let mut state = self.lock();
        match read {
            Ok((data, _)) if state.news.why.is_none() && state.data.as_ref() == Some(&data) => return,
            Ok((data, room)) => (state.room, state.data, state.news.why) = (Some(Arc::new(room)), Some(data), None),
            Err(why) if state.news.why.as_ref() == Some(&why) => return,
            // What could be shown last stays.
            Err(why) => state.news.why = Some(why),
        }
        state.news.rooms += 1;
        self.tell(state);
    }

    /// Has all pages select something.
    pub fn select(&self, what: String) {
        let mut state = self.lock();
        if state.news.selected != what {
            state.news.selected = what;
            state.news.selections += 1;
            self.tell(state);
        }
    }

    fn tell(&self, mut state: MutexGuard<'_, State>) {
        state.news.version += 1;
        drop(state);
        self.news.notify_all();
    }

    /// The room as JSON, without the geometry if that is `known`; or why there is none that is up to date.
    pub fn data(&self, known: &str) -> Result<String, String> {
        let state = self.lock();
        match (&state.news.why, &state.data) {
            (Some(why), _) => Err(why.clone()),
            (None, Some(data)) if data.shape == known => Ok(data.places.clone()),
            (None, Some(data)) => Ok(data.whole.clone()),
            (None, None) => Err(String::new()),
        }
    }

    /// Waits for news after `version`, at most so long; what there is to tell now.
    pub fn after(&self, version: u64, patience: Duration) -> News {
        let state = self.lock();
        let waited = self.news.wait_timeout_while(state, patience, |state| state.news.version == version);
        let (state, _) = waited.unwrap_or_else(PoisonError::into_inner);
        state.news.clone()
    }

    /// Judges a move, and makes it if that is asked for.
    ///
    /// # Errors
    /// It cannot be, the file has changed since it was read, or it cannot be written.
    pub fn go(&self, asked: &Move) -> Result<Value, Refused> {
        let mut state = self.lock();
        let room = state.room.clone().ok_or_else(|| Refused::Wrong("there is no room yet".to_owned()))?;
        let moved = moved(&room.layout, asked).map_err(Refused::Wrong)?;
        if !asked.commit {
            let answer = state.consider(&room, asked)?;
            drop(state);
            // The thread of a drag that ends without an answer has made a mistake; the next move begins another.
            return answer.recv().map_err(|_| Refused::Failed("the move could not be checked".to_owned()));
        }
        state.drag = None;
        let verdict = check(&room.program, &moved, &room.options);
        let name = &room.checked.report.file;
        let report = report::build(name, &verdict, Some(&room.program), &room.checked.sources, &room.options);
        // What somebody else has written meanwhile is not ours to undo.
        let door = Door::of(&room.path);
        let same = door.read(&room.path).is_ok_and(|bytes| layout_file::decode(bytes).is_ok_and(|t| t == room.text()));
        if !same {
            return Err(Refused::Changed(format!("{} was changed in the meantime", room.path.display())));
        }
        let old = layout_file::read(room.text(), scenelang_base::FileId(0));
        layout_file::write(&door, &room.path, &moved, old.usable.then_some(&old.document))
            .map_err(|e| Refused::Failed(e.to_string()))?;
        // Another move may come before the file is looked at.
        if let Ok(now) = CheckedLayout::read(&self.file, None) {
            state.room = Some(Arc::new(now));
        }
        Ok(answer(&report))
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    /// Has a step of a drag judged: where the answer comes.
    fn consider(&mut self, room: &Arc<CheckedLayout>, asked: &Move) -> Result<Receiver<Value>, Refused> {
        let found = room.program.objects.iter().position(|object| object.name == asked.object);
        let found = found.ok_or_else(|| Refused::Wrong(format!("the program has no `{}`", asked.object)))?;
        let (answer, answered) = channel();
        let mut step = Step { object: ObjectId(found as u32), pos: asked.pos, rot: asked.rot, answer };
        if let Some(drag) = self.drag.as_ref().filter(|drag| Arc::ptr_eq(&drag.room, room)) {
            match drag.steps.send(step) {
                Ok(()) => return Ok(answered),
                Err(unsent) => step = unsent.0,
            }
        }
        let drag = Drag::begin(room).map_err(|e| Refused::Failed(e.to_string()))?;
        let _ = drag.steps.send(step);
        self.drag = Some(drag);
        Ok(answered)
    }
}

/// A drag that goes on: the room that it began in, and where its steps go.
struct Drag {
    room: Arc<CheckedLayout>,
    steps: Sender<Step>,
}

struct Step {
    object: ObjectId,
    pos: [f64; 3],
    rot: [f64; 3],
    answer: Sender<Value>,
}

impl Drag {
    /// A thread that keeps the judgement of a room: each step costs what it changes. It ends when nobody holds the drag.
    fn begin(room: &Arc<CheckedLayout>) -> std::io::Result<Self> {
        let (steps, taken) = channel::<Step>();
        let own = Arc::clone(room);
        std::thread::Builder::new().name("drag".to_owned()).stack_size(8 << 20).spawn(move || {
            let CheckedLayout { program, layout, options, checked, .. } = &*own;
            let mut live = Live::new(program, layout, options);
            for step in taken {
                live.drag(step.object, Vec3::from(step.pos), Vec3::from(step.rot));
                // Whoever asked may be gone.
                let _ =
                    step.answer.send(scenelang_engine::moved(&live, program, &checked.sources, &checked.report.file));
            }
        })?;
        Ok(Self { room: Arc::clone(room), steps })
    }
}

/// The layout with an object elsewhere.
fn moved(layout: &Layout, asked: &Move) -> Result<Layout, String> {
    let far = |x: &f64| !x.is_finite() || x.abs() > layout_file::LARGEST;
    if asked.pos.iter().chain(&asked.rot).any(far) {
        return Err("a position is three numbers from -1000000 to 1000000".to_owned());
    }
    let mut moved = layout.clone();
    let found = moved.objects.iter_mut().find(|(name, _)| *name == asked.object);
    let (_, placement) = found.ok_or_else(|| format!("the layout has no `{}`", asked.object))?;
    (placement.pos, placement.rot) = (Vec3::from(asked.pos), Vec3::from(asked.rot));
    Ok(moved)
}

/// What the page is told of a move: every stated constraint, and the physical rules that fail.
fn answer(report: &scenelang_verify::Report) -> Value {
    let rows = report.constraints.iter();
    let (physical, stated): (Vec<_>, Vec<_>) = rows.partition(|row| row.rule.is_some());
    let state = |satisfied: Option<bool>| match satisfied {
        Some(true) => "holds",
        Some(false) => "fails",
        None => "unknown",
    };
    let stated: Vec<Value> = stated
        .into_iter()
        .map(|row| json!({ "id": row.id, "state": state(row.satisfied), "margin": row.margin }))
        .collect();
    let physical: Vec<_> = physical.into_iter().filter(|row| row.satisfied != Some(true)).collect();
    json!({ "constraints": stated, "physical": physical })
}
