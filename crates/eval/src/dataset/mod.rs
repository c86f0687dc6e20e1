//! A dataset of requests with ground truth, made offline: the published procedure with a grammar in place of a language model.
//!
//! ```text
//! seed, number ──plan──▶ rooms, things, relations ──┬─tell──▶ request, sentence
//!                                                   └─program──▶ program ──solve──▶ layout
//! ```
//!
//! Absent here: files, and who reads the requests.

mod dice;
mod looks;
mod plan;
mod pools;
mod program;
mod record;
mod statistics;
mod tell;

pub(crate) use dice::Dice;
pub use record::{Connection, DatasetScene, Held, Object, Relation, RoomRecord, parse};
pub use statistics::{PUBLISHED, Statistics};

use crate::correctness::{laid_out, satisfied};

use program::{ProgramNames, program, stated};
use scenelang_solve::Stop;
use tell::{SceneWords, tell};

/// What a record calls itself.
pub const FORMAT: &str = "scenelang.dataset/1";
/// The JSON Schema of a record.
pub const SCHEMA: &str = include_str!("../../schemas/dataset.json");
/// Streams of random numbers from here on are for words; those before are for plans.
const WORDS: u64 = 1 << 32;

/// A scene of the dataset, without its layout.
pub fn scene(seed: u64, number: u64) -> DatasetScene {
    let plan = plan::plan(seed, number);
    let names = ProgramNames::new(&plan);
    let stated = stated(&plan, &names);
    let told = tell(&mut Dice::new(seed, WORDS + number), &plan, &stated);
    let program = program(&plan, &names, &stated, &told.sentences);
    record::scene(seed, number, &plan, &names, &stated, told, program)
}

/// The same with its layout, and how much of what must hold does in it; where the end was asked for, with the layout that was
/// found by then.
///
/// # Errors
/// Its program does not compile.
pub fn solved(seed: u64, number: u64, stop: &Stop) -> Result<DatasetScene, String> {
    let mut scene = scene(seed, number);
    let laid = laid_out(&scene.program, seed, stop).map_err(|why| format!("the program of {}: {why}", scene.id))?;
    let held = satisfied(&laid.program, &laid.layout);
    scene.held = Some(Held { relations: held.stated.into(), all: held.all.into() });
    scene.satisfiable = laid.satisfiable;
    scene.layout = serde_json::from_str(&scenelang_layout::file::to_json(&laid.layout, None)).ok();
    Ok(scene)
}

/// The request of a scene with `_` for whatever is filled in: two requests of one skeleton differ in words only.
pub fn skeleton(seed: u64, number: u64) -> String {
    let plan = plan::plan(seed, number);
    let names = ProgramNames::new(&plan);
    let SceneWords { skeleton, .. } = tell(&mut Dice::new(seed, WORDS + number), &plan, &stated(&plan, &names));
    skeleton
}
