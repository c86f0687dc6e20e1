//! `scenelang lsp`: serves an editor, and shows rooms beside it.

use crate::FAILED;
use crate::args::{self, Lsp};
use crate::consent::{CONFIGURED, Consent, consent};
use crate::model;
use scenelang_export::preview::has_viewer;
use scenelang_llm::Error;
use scenelang_lsp::{Beside, ModelQuestion, Named, Recorder, Setup, replay, serve};
use scenelang_verify::settings::Llm;
use std::io::{BufRead, BufReader, Write, stdin, stdout};
use std::path::Path;
use std::process::{Command, Stdio};

/// Serves until the editor says `exit` or is gone; 0 if it said `shutdown` before, else 1.
pub fn run(args: &Lsp) -> u8 {
    let setup = match args.record.as_deref().map(Recorder::new).transpose() {
        Ok(record) => Setup { record, connect: Some(connect), show: Some(show) },
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

/// Has `scenelang view` show a room; it ends with the server, or when it is not wanted any more.
fn show(path: &Path) -> Result<Beside, String> {
    if !has_viewer() {
        return Err("this scenelang was built without the viewer".to_owned());
    }
    let own = std::env::current_exe().map_err(|e| e.to_string())?;
    let mut child = Command::new(own)
        .args(["view", "--follow"])
        .arg(path)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .map_err(|e| format!("cannot show the room: {e}"))?;
    let (names, said) = (child.stdin.take(), child.stdout.take());
    let (Some(mut names), Some(said)) = (names, said) else { return Err("cannot show the room".to_owned()) };
    let mut address = String::new();
    let read = BufReader::new(said).read_line(&mut address);
    // It is waited for, so that nothing of it is left when it has ended.
    std::thread::spawn(move || child.wait());
    if read.is_err() || address.trim().is_empty() {
        return Err(format!("cannot show the room of {}", path.display()));
    }
    let select = Box::new(move |what: &str| writeln!(names, "{what}").is_ok());
    Ok(Beside { address: address.trim().to_owned(), select })
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
