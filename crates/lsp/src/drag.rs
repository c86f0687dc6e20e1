//! An object under the pointer: each step is judged by what it can change, by a thread that keeps the judgement while the
//! drag goes on.

use crate::disk::uri_of;
use crate::dispatch::{Fault, params};
use crate::jobs::{JobOutcome, LayoutEdit};
use crate::state::{Event, State, guarded};
use crate::text::Text;
use scenelang_base::{Edit, SourceMap, TextRange, fix};
use scenelang_engine::Live;
use scenelang_ide::actions::placing;
use scenelang_ide::{Judged, LayoutFile};
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, Vec3, file as layout_file};
use scenelang_verify::Options;
use serde::Deserialize;
use serde_json::Value;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::Uri;

#[derive(Deserialize)]
struct Move {
    uri: Uri,
    object: String,
    pos: [f64; 3],
    rot: Option<[f64; 3]>,
    #[serde(default)]
    commit: bool,
}

/// One step of a drag.
struct Step {
    id: Id,
    object: ObjectId,
    pos: Vec3,
    rot: Vec3,
}

/// A drag that goes on: what it is about, and where its steps go.
pub struct Drag {
    /// The verdict that it began from.
    generation: u64,
    steps: Sender<Step>,
}

/// What the thread of a drag has.
struct Scene {
    judged: Arc<Judged>,
    layout: Arc<LayoutFile>,
    sources: Arc<SourceMap>,
    options: Options,
    name: String,
}

impl State {
    /// `scenelang/move`
    ///
    /// # Errors
    /// It does not say what is moved where, or there is no layout in which it could be.
    pub fn move_object(&mut self, id: &Id, given: Value) -> Result<(), Fault> {
        let Move { uri, object, pos, rot, commit } = params(given)?;
        let key = uri.as_str().to_owned();
        let finite = pos.iter().chain(rot.iter().flatten()).all(|x| x.is_finite() && x.abs() <= layout_file::LARGEST);
        if !finite {
            return Err(Fault::Invalid("a position is three numbers from -1000000 to 1000000".to_owned()));
        }
        let context = self.context(&key).ok_or_else(|| Fault::Invalid(format!("{key} is not an open program")))?;
        let generation = context.generation;
        let Some(layout) = context.snapshot.layout_file().filter(|l| l.read.usable) else {
            return Err(Fault::Failed("there is no layout in which it could be moved".to_owned()));
        };
        let placed = layout.read.layout.object(&object);
        let placed = placed.ok_or_else(|| Fault::Invalid(format!("the layout has no `{object}`")))?;
        let (pos, rot) = (Vec3::from(pos), rot.map_or(placed.rot, Vec3::from));
        if commit {
            let mut moved = layout.read.layout.clone();
            if let Some((_, placed)) = moved.objects.iter_mut().find(|(name, _)| *name == object) {
                (placed.pos, placed.rot) = (pos, rot);
            }
            let edits = placing(&layout, &object, pos, rot).ok_or(Fault::Internal)?;
            return self.commit(id, &key, &object, &moved, &layout, &edits);
        }
        let judged = context.snapshot.judged().map_err(Fault::from)?.ok_or(Fault::Outdated)?;
        let found = judged.compiled.program.objects.iter().position(|o| o.name == object);
        let found = found.ok_or_else(|| Fault::Invalid(format!("the program has no `{object}`")))?;
        let step = Step { id: id.clone(), object: ObjectId(found as u32), pos, rot };
        let going = self.drags.get(&key).filter(|drag| drag.generation == generation);
        let unsent = match going {
            None => step,
            Some(drag) => match drag.steps.send(step) {
                Ok(()) => return Ok(()),
                Err(unsent) => unsent.0,
            },
        };
        let mut options = context.snapshot.judging().options;
        options.physics &= judged.compiled.complete;
        let name = context.snapshot.sources().get(layout.file).name().to_owned();
        let (sources, _) = context.snapshot.into_sources();
        let scene = Scene { judged, layout, sources, options, name };
        let (steps, taken) = channel();
        let events = self.events();
        let thread = std::thread::Builder::new().name("drag".to_owned()).stack_size(8 << 20);
        let spawned = thread.spawn(move || {
            // A mistake of ours ends this drag, and the next step begins another.
            let _ = guarded(|| {
                follow(&scene, &taken, &events);
                Ok(())
            });
        });
        spawned.map_err(|e| Fault::Failed(format!("cannot start a thread: {e}")))?;
        let _ = steps.send(unsent);
        self.drags.insert(key, Drag { generation, steps });
        Ok(())
    }

    /// Asks the client to make a move part of the layout.
    fn commit(
        &mut self,
        id: &Id,
        key: &str,
        object: &str,
        moved: &Layout,
        old: &LayoutFile,
        edits: &[Edit],
    ) -> Result<(), Fault> {
        let context = self.context(key).ok_or(Fault::Outdated)?;
        let before = context.snapshot.sources().get(old.file).text();
        let local = |e: &Edit| Edit { place: e.place.range, text: e.text.clone() };
        let made: Vec<Edit<TextRange>> = edits.iter().map(local).collect();
        let text = fix::apply(before, [made.as_slice()]).text;
        let uri = context.open.get(&old.path).cloned().or_else(|| uri_of(&old.path)).ok_or(Fault::Internal)?;
        let edit = context.places().workspace_edit(edits, context.edit_versions());
        let before = Text::new(before.to_owned());
        let mut options = context.snapshot.judging().options;
        let judged = context.snapshot.judged().map_err(Fault::from)?.ok_or(Fault::Outdated)?;
        options.physics &= judged.compiled.complete;
        let live = Live::new(&judged.compiled.program, moved, &options);
        let name = context.snapshot.sources().get(old.file).name();
        let answer = scenelang_engine::moved(&live, &judged.compiled.program, context.snapshot.sources(), name);
        let layout = LayoutEdit { path: old.path.clone(), uri, text, old: Some(before), edits: made };
        let message = format!("move {object}");
        let edit = (!edits.is_empty()).then_some(edit);
        self.apply_with(
            id,
            JobOutcome { layout: Some(layout), edit, message, count: [0, 0], moves: Vec::new() },
            answer,
        );
        Ok(())
    }
}

/// Judges step after step until nobody sends any more.
fn follow(scene: &Scene, steps: &Receiver<Step>, events: &Sender<Event>) {
    let program = &scene.judged.compiled.program;
    let layout = &scene.layout.read.layout;
    let mut live = Live::new(program, layout, &scene.options);
    while let Ok(step) = steps.recv() {
        live.drag(step.object, step.pos, step.rot);
        let answer = scenelang_engine::moved(&live, program, &scene.sources, &scene.name);
        let reply = move |state: &mut State| state.reply(&step.id, Ok(answer));
        if events.send(Event::Done(Box::new(reply))).is_err() {
            return;
        }
    }
}
