//! Houses and layouts of other systems: AI2-THOR (ProcTHOR, Holodeck), LayoutVLM and SceneEval, read as a program and a
//! layout of what their files say, so that they can be judged.
//!
//! A reader makes a [`house::House`] of a file: rooms, openings, things, in the frame of a layout. [`write`] makes a program
//! and a layout of that. What a file leaves open (the size of a model that stands elsewhere) is filled in from what is usual
//! and said; what it says besides is listed.
//!
//! Absent here: judging, and the way back to such a file.

mod ai2thor;
mod cursor;
mod house;
mod layoutvlm;
mod names;
mod scenestate;
mod sizes;
mod write;

pub use sizes::Sizes;

use cursor::At;
use scenelang_base::{Diagnostic, FileId, TextRange, codes};
use scenelang_lang::sources::{Loader, normal};
use scenelang_layout::file::json::{Findings, Json, JsonNode, find, parse};
use std::io;
use std::path::{Path, PathBuf};

/// The largest file that is read, in bytes: a house of a hundred rooms has a few.
pub const MAX_BYTES: usize = 16 << 20;

/// Corners of rooms times things: what is beyond is no house.
const MOST_WORK: usize = 50_000_000;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A house of AI2-THOR, as ProcTHOR and Holodeck write it.
    House,
    /// A room and its assets, as LayoutVLM is given it.
    Task,
    /// Where things are, as LayoutVLM writes it.
    Poses,
    /// A scene state, as SceneEval reads it.
    SceneState,
}

impl FileKind {
    /// What such a file is, in words.
    pub fn in_words(self) -> &'static str {
        match self {
            Self::House => "a house of AI2-THOR",
            Self::Task => "a room of LayoutVLM",
            Self::Poses => "a layout of LayoutVLM",
            Self::SceneState => "a scene state of SceneEval",
        }
    }
}

/// What else is known of the things of a file.
#[derive(Clone, Debug, Default)]
pub struct Beside {
    /// How large models are.
    pub sizes: Sizes,
    /// The room that a layout of LayoutVLM belongs to.
    pub room: Option<RoomFile>,
}

/// A room of LayoutVLM.
#[derive(Clone, Debug)]
pub struct RoomFile {
    root: JsonNode,
    file: FileId,
}

impl RoomFile {
    /// Reads a room.
    ///
    /// # Errors
    /// It is no JSON, or no room of LayoutVLM.
    pub fn read(text: &str, file: FileId) -> Result<Self, Box<Diagnostic>> {
        let root = whole(text, file)?.filter(|root| kind_of(root) == Some(FileKind::Task));
        root.map(|root| Self { root, file }).ok_or_else(|| {
            let say = "this is no room of LayoutVLM: it has no `boundary`, or no `assets`";
            Box::new(Diagnostic::new(codes::E0502, TextRange::empty(0).in_file(file), say))
        })
    }
}

/// A text of which every byte is as it should be; the first thing that is not, else.
fn whole(text: &str, file: FileId) -> Result<Option<JsonNode>, Box<Diagnostic>> {
    let mut findings = Findings::new(file);
    let root = parse(text, &mut findings);
    match findings.list.into_iter().find(Diagnostic::is_error) {
        Some(first) => Err(Box::new(first)),
        None => Ok(root),
    }
}

/// What a file says, as a program and a layout. As a [`Loader`] it gives the program, as if it stood beside the layout.
#[derive(Clone, Debug)]
pub struct Foreign {
    pub kind: FileKind,
    /// How to call the layout in messages: as a file below the one that was read.
    pub layout_name: String,
    /// The path of the same.
    pub layout_path: PathBuf,
    /// The path of the program.
    pub main: PathBuf,
    pub program: String,
    pub layout: String,
    /// What was filled in, and what was not taken over.
    pub notes: Vec<Diagnostic>,
}

impl Loader for Foreign {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        if normal(path) == self.main {
            Ok(self.program.clone().into_bytes())
        } else {
            Err(io::ErrorKind::NotFound.into())
        }
    }
}

/// What kind of file a text is; `None`: none that is read here. A text that breaks off is recognised by how it begins.
pub fn recognise(text: &str) -> Option<FileKind> {
    if text.len() > MAX_BYTES {
        // Nobody needs to know more of it than that it is refused.
        return by_words(text.get(..MAX_BYTES.min(1 << 16)).unwrap_or_default());
    }
    let root = parse(text, &mut Findings::new(FileId(0)));
    match &root {
        Some(root) => kind_of(root),
        None => by_words(text),
    }
}

/// By what stands in a text that cannot be read as a whole.
fn by_words(text: &str) -> Option<FileKind> {
    let has = |word: &str| text.contains(word);
    if has("\"sceneState\"") {
        Some(FileKind::SceneState)
    } else if has("\"floor_vertices\"") {
        Some(FileKind::Task)
    } else if has("\"floorPolygon\"") || has("\"proceduralParameters\"") {
        Some(FileKind::House)
    } else {
        None
    }
}

fn kind_of(root: &JsonNode) -> Option<FileKind> {
    let members = root.members()?;
    let has = |key: &str| find(members, key).is_some();
    if find(members, "format").is_some_and(|m| m.node.value == Json::Text("sceneState".to_owned())) {
        return Some(FileKind::SceneState);
    }
    if has("format") {
        return None;
    }
    if has("boundary") && has("assets") {
        return Some(FileKind::Task);
    }
    if has("rooms") && (has("walls") || has("proceduralParameters") || has("doors")) {
        return Some(FileKind::House);
    }
    let is_pose = |node: &JsonNode| {
        node.members().is_some_and(|m| find(m, "position").is_some() && find(m, "rotation").is_some())
    };
    (!members.is_empty() && members.iter().all(|m| is_pose(&m.node))).then_some(FileKind::Poses)
}

/// Reads a file that is called `name` and is at `path`; places in what is wrong with it are those of `file`.
///
/// # Errors
/// The first thing that is wrong with it: the file is left alone then.
pub fn read(name: &str, path: &Path, text: &str, file: FileId, beside: &Beside) -> Result<Foreign, Box<Diagnostic>> {
    if text.len() > MAX_BYTES {
        let say = format!("{name} is larger than the maximum of {} MiB", MAX_BYTES >> 20);
        let note = "a house is a file of a few megabytes; large lists of assets stand in files of their own";
        return Err(Box::new(Diagnostic::without_place(codes::E0006, say).note(note)));
    }
    let root = whole(text, file)?;
    let Some((root, kind)) = root.as_ref().and_then(|root| Some((root, kind_of(root)?))) else {
        let say = "this file cannot be imported: it is not an AI2-THOR house, a LayoutVLM room or layout, or a SceneEval scene state";
        let note = "`scenelang explain W0505` says how these formats are recognised";
        return Err(Box::new(Diagnostic::new(codes::E0502, TextRange::empty(0).in_file(file), say).note(note)));
    };
    let (at, sizes) = (At::root(root, file), &beside.sizes);
    let mut house = match kind {
        FileKind::House => ai2thor::read(&at, sizes),
        FileKind::Task => layoutvlm::task(&at, sizes),
        FileKind::Poses => {
            layoutvlm::poses(&at, beside.room.as_ref().map(|room| At::root(&room.root, room.file)).as_ref(), sizes)
        }
        FileKind::SceneState => scenestate::read(&at, sizes),
    }?;
    if house.work() > MOST_WORK {
        return at.fail(codes::E0005, "there are more corners of rooms and things than can be looked at");
    }
    house.rooms.iter_mut().for_each(house::HouseRoom::finish);
    let stem = names::stem(path);
    let written = write::write(&house, &format!("{stem}.scene"), name, kind);
    let (main, layout_file) = (path.join(format!("{stem}.scene")), format!("{stem}.layout.json"));
    Ok(Foreign {
        kind,
        layout_name: format!("{name}/{layout_file}"),
        layout_path: path.join(layout_file),
        main: normal(&main),
        program: written.program,
        layout: written.layout,
        notes: written.notes,
    })
}
