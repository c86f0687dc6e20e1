//! Stage I in one call: a request, and perhaps a model; out comes a program. Without a model, or where it fails, the
//! English reader reads.

use crate::draft::{Draft, Note, ThingOrigin};
use crate::model::{self, Asking, Usage};
use crate::read::{Options, Reading, read};
use crate::text::sentence_ranges;
use crate::write::write;
use scenelang_llm::{Error, Model};

/// A request as a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Formalized {
    /// The text of the program.
    pub program: String,
    /// What it was written from.
    pub draft: Draft,
    /// The words of the request that became no statement.
    pub notes: Vec<Note>,
    /// What went wrong on the way, a sentence each; the program is good all the same.
    pub diagnostics: Vec<String>,
    /// What the model took; `None`: nobody was asked.
    pub usage: Option<Usage>,
}

/// A request as a program: by the model, else by the reader.
///
/// # Errors
/// The model failed, and the reader understood nothing.
pub fn formalize(
    request: &str,
    options: &Options,
    model: Option<(&mut dyn Model, &Asking)>,
) -> Result<Formalized, Error> {
    let Some((model, asking)) = model else { return Ok(of_draft(read(request, options).draft)) };
    let asking = Asking { literal: options.literal, ..*asking };
    let Reading { draft, nothing, .. } = read(request, options);
    with_model(request, &asking, (!nothing).then_some(draft), model)
}

/// Asks a model what a request says, and writes the program. Where the model fails, the program is written from
/// `fallback`, and the diagnostics say why.
///
/// # Errors
/// The model failed, and there is no fallback.
pub fn with_model(
    request: &str,
    asking: &Asking,
    fallback: Option<Draft>,
    model: &mut dyn Model,
) -> Result<Formalized, Error> {
    let model::ModelOutcome { draft, mut diagnostics, usage } = model::draft(request, asking, model);
    let draft = match (draft, fallback) {
        (Ok(draft), _) => draft,
        (Err(error), Some(fallback)) => {
            diagnostics.push(format!("the model failed: {error}; the program contains what was understood without it"));
            fallback
        }
        (Err(error), None) => return Err(error),
    };
    let mut formalized = of_draft(draft);
    formalized.diagnostics = diagnostics;
    formalized.usage = Some(usage);
    Ok(formalized)
}

/// The program of a draft.
pub fn of_draft(draft: Draft) -> Formalized {
    let program = write(&draft);
    Formalized { program, notes: draft.notes.clone(), draft, diagnostics: Vec::new(), usage: None }
}

impl Formalized {
    /// Of each sentence of the request whether something came of it, as the reader says it of clauses.
    pub fn reading(&self) -> Reading {
        let draft = &self.draft;
        let rooms = draft.rooms.iter().map(|room| &room.source);
        let openings = draft.openings.iter().map(|opening| &opening.source);
        let things = draft.things.iter().map(|thing| &thing.source);
        let statements = draft.statements.iter().map(|statement| &statement.source);
        let sources: Vec<&ThingOrigin> = rooms.chain(openings).chain(things).chain(statements).collect();
        let came = |at: &std::ops::Range<usize>| {
            sources
                .iter()
                .any(|source| matches!(source, ThingOrigin::Stated(own) if own.start < at.end && at.start < own.end))
        };
        let read: Vec<_> = sentence_ranges(&draft.request).into_iter().map(|at| (at.clone(), came(&at))).collect();
        Reading {
            draft: draft.clone(),
            understood: read.iter().filter(|(_, came)| *came).count(),
            clauses: read.len(),
            nothing: !read.iter().any(|(_, came)| *came),
            read,
            absent: Vec::new(),
            words: Vec::new(),
            furnished: None,
        }
    }
}
