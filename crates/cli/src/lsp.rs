//! `scenelang lsp`: serves an editor.

use crate::FAILED;
use crate::args::Lsp;
use scenelang_lsp::{Recorder, Setup, replay, serve};
use std::io::{stdin, stdout};

/// Serves until the editor says `exit` or is gone; 0 if it said `shutdown` before, else 1.
pub fn run(args: &Lsp) -> u8 {
    let setup = match args.record.as_deref().map(Recorder::new).transpose() {
        Ok(record) => Setup { record },
        Err(e) => return fail(&format!("cannot record: {e}")),
    };
    match &args.replay {
        None => serve(stdin(), stdout(), setup),
        Some(path) => match replay(path) {
            Ok(session) => serve(session, stdout(), setup),
            Err(e) => fail(&format!("cannot replay {}: {e}", path.display())),
        },
    }
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}
