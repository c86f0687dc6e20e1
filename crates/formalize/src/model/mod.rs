//! Stage I with a language model, step by step as published.
//!
//! | file | step |
//! |---|---|
//! | `scene` | indoor or outdoor |
//! | `expand` | Q → Q′: what is asked for and not said; nothing that is said gets lost |
//! | `divide` | the regions, and the sentences of Q′ that each is made from |
//! | `connect` | doors and windows |
//! | `place` | the regions' outlines, their walls 2η apart |
//! | `furnish` | the entities of a region: surfaces and objects |
//! | `constrain` | what is said of their places, as statements |
//! | `prune` | redundant and contradictory statements: by proof, then by the model |
//! | `complete` | what nobody says: what hangs, what may overlap, what needs room |
//!
//! What the model says is never believed. Every answer has a schema (`ask`), names are made names of the language,
//! numbers are bounded, statements are compiled and sent back with what is wrong with them (`compile`). What cannot be
//! used is left out, and a note says so.

mod ask;
mod compile;
mod complete;
mod connect;
mod constrain;
mod divide;
mod expand;
mod furnish;
mod place;
mod prune;
mod scene;
mod sentences;

use crate::draft::{Draft, Note, ThingOrigin};
use crate::names::GivenNames;
use crate::text::sentence_ranges;
use ask::{Asker, Trouble};
pub use ask::{PROMPTS, Prompt, Usage};
use scenelang_llm::{Error, Model};
use sentences::Sentences;

/// The longest request that a model is asked about (bytes).
const LONGEST: usize = 64 << 10;

/// How a model is asked; the defaults are the published ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asking {
    /// How often an expansion that loses something is asked for again.
    pub expansions: usize,
    /// How often statements that do not compile are sent back.
    pub compilations: usize,
    /// ν_r: how often the model looks for redundant statements.
    pub redundancy: usize,
    /// ν_c: how often the model looks for contradictory statements.
    pub contradiction: usize,
    /// How freely the model chooses its words, but for the type of the scene, where it does not.
    pub temperature: Option<f64>,
    /// At most so many tokens in an answer, those of thinking included.
    pub max_output: u64,
    /// Fixes the model's choices as far as its provider offers that.
    pub seed: u64,
    /// Ask for nothing that the request does not say.
    pub literal: bool,
}

impl Default for Asking {
    fn default() -> Self {
        Self {
            expansions: 2,
            compilations: 3,
            redundancy: 2,
            contradiction: 2,
            temperature: Some(0.7),
            max_output: 16_000,
            seed: 0,
            literal: false,
        }
    }
}

/// What came of asking.
#[derive(Debug)]
pub struct ModelOutcome {
    /// What was understood; `Err`: why there is nothing to go on with.
    pub draft: Result<Draft, Error>,
    /// What went wrong on the way, a sentence each.
    pub diagnostics: Vec<String>,
    /// What it took.
    pub usage: Usage,
}

/// Asks a model what a request says.
pub fn draft(request: &str, asking: &Asking, model: &mut dyn Model) -> ModelOutcome {
    let mut asker = Asker::new(model, *asking);
    let draft = if request.len() > LONGEST {
        Err(Error::Setup(format!("a model is sent at most {LONGEST} bytes, and the request has {}", request.len())))
    } else {
        steps(request, &mut asker)
    };
    let (diagnostics, usage) = asker.into_parts();
    ModelOutcome { draft, diagnostics, usage }
}

/// Whether a text is an answer to a prompt: for the examples in the prompts.
///
/// # Errors
/// Why not.
pub fn readable(prompt: Prompt, answer: &str) -> Result<(), String> {
    fn read<T: serde::de::DeserializeOwned>(answer: &str) -> Result<(), String> {
        serde_json::from_str::<T>(answer).map(drop).map_err(|e| e.to_string())
    }
    match prompt.step {
        "scene" => read::<scene::SceneAnswer>(answer),
        "expand" => read::<expand::ExpandAnswer>(answer),
        "divide" => read::<divide::DivideAnswer>(answer),
        "connect" => read::<connect::ConnectAnswer>(answer),
        "place" => read::<place::PlaceAnswer>(answer),
        "furnish" => read::<furnish::FurnishAnswer>(answer),
        "constrain" | "complete" => read::<constrain::ConstrainAnswer>(answer),
        "redundant" | "contradictory" => read::<prune::PruneAnswer>(answer),
        other => Err(format!("there is no step {other}")),
    }
}

/// All steps. Without regions and their objects there is no draft; what fails behind them is left out.
fn steps(request: &str, asker: &mut Asker<'_>) -> Result<Draft, Error> {
    let mut draft = Draft { request: request.to_owned(), ..Draft::default() };
    let mut names = GivenNames::default();
    draft.outdoor = asker.or_else(scene::is_outdoor, request, |_| false)?;
    let sentences = if asker.asking.literal {
        Sentences::of_request(request)
    } else {
        asker.or_else(expand::expand, request, Sentences::of_request)?
    };
    let parts = divide::divide(asker, &sentences, &mut draft, &mut names).map_err(Trouble::error)?;
    if let Err(trouble) = connect::connect(asker, &sentences, &mut draft, &mut names) {
        asker.tell("doors and windows are left out", trouble)?;
    }
    if let Err(trouble) = place::place(asker, &sentences, &mut draft) {
        asker.tell("the rooms have usual sizes", trouble)?;
    }
    place::separate(&mut draft);
    for (room, part) in parts.iter().enumerate() {
        furnish::furnish(asker, &sentences, part, room, &mut draft, &mut names).map_err(Trouble::error)?;
    }
    let mut ended = None;
    for (room, part) in parts.iter().enumerate() {
        match constrain::constrain(asker, &sentences, part, room, &mut draft) {
            Ok(()) => {}
            Err(Trouble::Answer(why)) => asker.diagnostics.push(format!("statements are missing: {why}")),
            Err(Trouble::Over(error)) => {
                ended = Some(error);
                break;
            }
        }
    }
    // The budget may end here: what was understood is kept, and said to be less than it could be.
    if let Some(error) = ended {
        asker.diagnostics.push(format!("some statements are missing: {error}"));
    }
    compile::settle(&mut draft, &mut asker.diagnostics);
    unread(&mut draft);
    if compile::compiles(&draft) {
        Ok(draft)
    } else {
        Err(Error::Malformed("it produced no program that compiles".into()))
    }
}

/// A note for each sentence of the request that nothing came of.
fn unread(draft: &mut Draft) {
    let stated = |source: &ThingOrigin| match source {
        ThingOrigin::Stated(at) => Some(at.clone()),
        ThingOrigin::Inferred(_) => None,
    };
    let rooms = draft.rooms.iter().map(|room| &room.source);
    let openings = draft.openings.iter().map(|opening| &opening.source);
    let things = draft.things.iter().map(|thing| &thing.source);
    let statements = draft.statements.iter().map(|statement| &statement.source);
    let sources = rooms.chain(openings).chain(things).chain(statements).filter_map(stated);
    let used: Vec<_> = sources.chain(draft.notes.iter().map(|note| note.at.clone())).collect();
    for at in sentence_ranges(&draft.request) {
        if !used.iter().any(|used| used.start < at.end && at.start < used.end) {
            draft.notes.push(Note { at, reason: "the model produced nothing for this sentence".into() });
        }
    }
    draft.notes.sort_by_key(|note| note.at.start);
}
