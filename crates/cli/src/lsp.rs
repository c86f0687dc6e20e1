//! `scenelang lsp`: serves an editor.

use crate::FAILED;
use crate::args::{self, Lsp};
use crate::consent::{CONFIGURED, Consent, consent};
use crate::model;
use scenelang_llm::Error;
use scenelang_lsp::{ModelQuestion, Named, Recorder, Setup, replay, serve};
use scenelang_verify::settings::Llm;
use std::io::{stdin, stdout};

/// Serves until the editor says `exit` or is gone; 0 if it said `shutdown` before, else 1.
pub fn run(args: &Lsp) -> u8 {
    let setup = match args.record.as_deref().map(Recorder::new).transpose() {
        Ok(record) => Setup { record, connect: Some(connect) },
        Err(e) => return fail(&format!("cannot record: {e}")),
    };
    match &args.replay {
        None => serve(stdin(), stdout(), setup),
        Some(path) => {
            let played = replay(path, stdout());
            played.unwrap_or_else(|e| fail(&format!("cannot replay {}: {e}", path.display())))
        }
    }
}

/// The model that the user's editor names, else the one that the settings name, for a user whose editor says that it may be
/// asked; its key comes from the environment.
fn connect(settings: &Llm, named: &Named) -> Result<Option<ModelQuestion>, Error> {
    // An address is that of the model beside it: a workspace that names another must not bring its key there.
    let base_url = named.base_url.clone().filter(|_| named.name.is_some());
    let model = named.name.clone().unwrap_or_else(|| CONFIGURED.to_owned());
    let chosen = args::ModelOptions { model: Some(model), base_url, ..args::ModelOptions::default() };
    match consent(&chosen, settings)? {
        Consent::Given(allowed) => {
            model::ModelSession::allowed(&allowed, &chosen, 0).map(model::ModelSession::into_parts).map(Some)
        }
        Consent::Unasked(_) => Ok(None),
    }
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
