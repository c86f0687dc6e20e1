//! A suite: scenes of the dataset, read and laid out by several systems, and the published figures of it.
//!
//! Each scene is a [`Case`] of its own, so that a run can be split, ended and taken up again; [`Figures`] are of all of them.
//! Absent here: files, and how requests are read.

mod figures;
mod page;

mod plot;

pub use figures::{Figures, PUBLISHED_COHERENCE, PUBLISHED_CORRECTNESS, PUBLISHED_RESEMBLANCE};
pub use page::{Page, Picture, page};

use crate::coherence;
use crate::correctness::{direct, grid, iterations, problem, satisfied};
use crate::dataset::{self, DatasetScene};
use crate::resemblance::{self, Quality, Similarity, TAUS};
use crate::score::Share;
use scenelang_layout::Layout;
use scenelang_llm::{Image, Model};
use scenelang_solve::{Stop, solve};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::time::Instant;

/// What a suite calls itself.
pub const FORMAT: &str = "scenelang.suite/1";
/// What a case calls itself.
pub const CASE: &str = "scenelang.suiteCase/1";

/// What a suite measures: scenes of a generated dataset.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Suite {
    /// [`FORMAT`].
    pub format: String,
    /// What it is called in reports.
    pub name: String,
    /// So many scenes of the dataset.
    pub scenes: u64,
    /// The seed of the dataset.
    pub seed: u64,
}

/// What came of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// [`CASE`].
    pub format: String,
    /// What it was made of: it is made anew where that is another.
    pub key: String,
    /// The scene.
    pub id: String,
    /// Rooms, objects, relations, words of the request.
    pub size: [usize; 4],
    /// Relations that hold in our layouts, after 0, 1, … iterations; the last one is without a limit.
    pub search: Vec<[usize; 2]>,
    /// All that must hold in the last one: relations, other statements, physical rules.
    pub all: [usize; 2],
    /// Relations that hold where the grid has placed what it could, and how many objects it has left out.
    pub grid: Placed,
    /// The same of a model that was asked directly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direct: Option<Placed>,
    /// How well a model finds that a picture of our layout shows the request, and its one sentence; percent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coherence: Option<[f64; 2]>,
    pub similarity: String,
    /// Resemblance of objects and of constraints at each threshold: precision, recall, F1.
    pub objects: [[f64; 3]; 3],
    /// See `objects`.
    pub layout: [[f64; 3]; 3],
    /// How long reading and laying out took, in milliseconds: no figure that is the same twice.
    pub milliseconds: [f64; 2],
}

/// What a baseline has placed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Placed {
    /// Relations that hold, of all.
    pub relations: [usize; 2],
    /// Objects that were left out, of all.
    pub dropped: [usize; 2],
}

/// Makes a picture of a layout of a scene.
pub type Draw<'a> = dyn Fn(&DatasetScene, &Layout) -> Result<Image, String> + Sync + 'a;

/// What a suite is measured with.
pub struct Means<'a> {
    /// Makes a program of a request.
    pub reader: &'a (dyn Fn(&str) -> String + Sync),
    /// How likeness is judged.
    pub similarity: &'a dyn Similarity,
    /// Makes the pictures that a model is shown; without it, none is.
    pub draw: Option<&'a Draw<'a>>,
    /// Set from elsewhere, it ends the work.
    pub stop: &'a Stop,
}

/// A suite of a text, or why it is none.
pub fn parse(text: &str) -> Result<Suite, String> {
    let suite: Suite = serde_json::from_str(text).map_err(|e| e.to_string())?;
    match () {
        () if suite.format != FORMAT => Err(format!("its format is {:?}, expected {FORMAT:?}", suite.format)),
        () if suite.scenes == 0 => Err("it has no scenes; `scenes` gives their number".to_owned()),
        () if suite.scenes > 10_000 => Err("it has more than 10,000 scenes".to_owned()),
        () => Ok(suite),
    }
}

impl Suite {
    /// What a case is known by: a case of another key is another one. `model` is whom is asked.
    pub fn key(&self, number: u64, means: &Means<'_>, model: Option<&str>) -> String {
        let version = env!("CARGO_PKG_VERSION");
        let shown = if means.draw.is_some() { "/pictures" } else { "" };
        format!("{version}/{}/{number}/{}/{}{shown}", self.seed, means.similarity.name(), model.unwrap_or("-"))
    }

    /// The name of a case.
    pub fn id(&self, number: u64) -> String {
        dataset::scene(self.seed, number).id
    }

    /// Measures a scene. `None`: the end was asked for.
    ///
    /// # Errors
    /// The scene cannot be measured; the model has no answer.
    pub fn case(
        &self,
        number: u64,
        means: &Means<'_>,
        mut model: Option<&mut dyn Model>,
    ) -> Option<Result<Case, String>> {
        let scene = dataset::scene(self.seed, number);
        let begun = Instant::now();
        let made = (means.reader)(&scene.request);
        let read = begun.elapsed();
        let program = match crate::correctness::compiled(&scene.program) {
            Ok(program) => program,
            Err(why) => return Some(Err(format!("the program of {} does not compile: {why}", scene.id))),
        };
        let steps = iterations(&program, self.seed, means.stop);
        let options = scenelang_solve::Options {
            seed: self.seed,
            threads: 1,
            polish: 0.0,
            diagnose: false,
            stop: means.stop.clone(),
            ..scenelang_solve::Options::default()
        };
        let begun = Instant::now();
        let outcome = solve(&problem(&program, self.seed), &options, &mut |_| ControlFlow::Continue(()));
        let solving = begun.elapsed();
        let last = satisfied(&program, &outcome.layout);
        if means.stop.is_set() {
            return None;
        }
        let grid = grid::place(&scene, &program, self.seed);
        let of = |layout: &Layout, dropped| Placed {
            relations: satisfied(&program, layout).stated.into(),
            dropped: [dropped, program.objects.len()],
        };
        let asked = model.as_ref().map(|model| model.name().to_owned());
        let bad = |why: String| Some(Err(format!("{}: {why}", scene.id)));
        let direct = match model.as_mut().map(|model| direct::place(&mut **model, &scene, &program, self.seed)) {
            None => None,
            Some(Ok(answer)) => Some(of(&answer.layout, answer.missing)),
            Some(Err(why)) => return bad(why.to_string()),
        };
        let rated = model.zip(means.draw).map(|(model, draw)| {
            let picture = draw(&scene, &outcome.layout)?;
            coherence::rate(model, &scene, &picture).map_err(|why| why.to_string())
        });
        let coherence = match rated.transpose() {
            Ok(rated) => rated,
            Err(why) => return bad(why),
        };
        let [objects, layout] = resembling(&scene, &made, means.similarity);
        let words = scene.request.split_whitespace().count();
        Some(Ok(Case {
            format: CASE.to_owned(),
            key: self.key(number, means, asked.as_deref()),
            id: scene.id.clone(),
            size: [scene.rooms.len(), scene.things(), scene.instances(), words],
            search: steps.iter().map(|step| step.stated).chain([last.stated]).map(Share::into).collect(),
            all: last.all.into(),
            grid: of(&grid.layout, grid.dropped),
            direct,
            coherence,
            similarity: means.similarity.name().to_owned(),
            objects,
            layout,
            milliseconds: [read, solving].map(|time| (time.as_secs_f64() * 1e4).round() / 10.0),
        }))
    }
}

/// Resemblance of objects and of constraints at each threshold.
fn resembling(scene: &DatasetScene, made: &str, by: &dyn Similarity) -> [[[f64; 3]; 3]; 2] {
    let (objects, clauses) = resemblance::of_scene(scene);
    let made = resemblance::of_program(made);
    let three = |q: Quality| [q.precision, q.recall, q.f1];
    [
        TAUS.map(|tau| three(resemblance::objects(&objects, &made.objects, by, tau))),
        TAUS.map(|tau| three(resemblance::layout(&clauses, &made.sentences, by, tau))),
    ]
}
