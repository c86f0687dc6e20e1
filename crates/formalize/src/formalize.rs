//! Stage I in one call: a request, perhaps a model, perhaps a draft of the reader's; out comes a program that compiles.

use crate::draft::{Draft, Note};
use crate::model::{self, Asking, Usage};
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
    let model::Outcome { draft, mut diagnostics, usage } = model::draft(request, asking, model);
    let draft = match (draft, fallback) {
        (Ok(draft), _) => draft,
        (Err(error), Some(fallback)) => {
            diagnostics.push(format!("the model did not help: {error}; the program is what was understood without it"));
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
