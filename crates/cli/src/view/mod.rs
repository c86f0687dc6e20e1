//! `scenelang view`: a room in any browser, on this machine alone. What changes on disk is shown at once; what is dragged is
//! judged on its way, and written to the layout when it is let go.

mod live;
mod serve;

use crate::args::View;
use crate::watch::{Seen, wait};
use crate::{FAILED, GOOD};
use live::Shown;
use scenelang_export::preview;
use std::process::{Command, Stdio};
use std::sync::Arc;

/// Serves until Ctrl-C.
pub fn run(args: &View) -> u8 {
    let Some(viewer) = preview::viewer() else {
        eprintln!("error: this scenelang was built without the viewer; `./x demo` builds it with one");
        return FAILED;
    };
    if !crate::room::layout_of(&args.file).exists() && !args.file.exists() {
        eprintln!("error: there is no {}", args.file.display());
        return FAILED;
    }
    let shown = Arc::new(Shown::new(&args.file));
    let address = match serve::start(args.port, viewer, &shown) {
        Ok(address) => address,
        Err(e) => {
            eprintln!("error: cannot listen on port {}: {e}", args.port);
            return FAILED;
        }
    };
    println!("http://{address}/");
    eprintln!("only this machine can see it; Ctrl-C ends");
    if !args.no_open {
        open(&format!("http://{address}/"));
    }
    loop {
        let seen = Seen::default();
        shown.read(&seen);
        if !wait(&seen.files(), || false) {
            return GOOD;
        }
    }
}

/// Opens the browser, if there is one; the address has been said.
fn open(url: &str) {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        let mut command = Command::new("cmd");
        command.args(["/c", "start", ""]);
        command
    } else {
        Command::new("xdg-open")
    };
    let _ = command.arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
}
