//! `scenelang view`: a room in any browser, on this machine alone. What changes on disk is shown at once; what is dragged is
//! judged on its way, and written to the layout when it is let go. A language server says what is under the cursor.

mod body;
mod connection;
mod door;
mod live;
mod peer;
mod serve;
mod site;

use crate::args::View;
use crate::watch::{Seen, wait};
use crate::{FAILED, GOOD, interrupt};
use live::Shown;
use scenelang_export::preview;
use std::io::{BufRead, Write, stdin};
use std::process::{Command, Stdio};
use std::sync::Arc;

/// Serves until Ctrl-C.
pub fn run(args: &View) -> u8 {
    let Some(viewer) = preview::viewer() else {
        eprintln!("error: this scenelang was built without the viewer; `./x demo` builds it with one");
        return FAILED;
    };
    if !crate::room::layout_of(&args.file).exists() && !args.file.exists() {
        eprintln!("error: there is no file {}", args.file.display());
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
    println!("{address}");
    eprintln!("the page can be opened only on this machine and only with this address; press Ctrl-C to stop");
    if !args.no_open {
        open(&address);
    }
    // Whenever it comes, Ctrl-C is how a view ends.
    let _gentle = interrupt::Gentle::new();
    if args.follow {
        follow(&shown);
    }
    loop {
        let seen = Seen::default();
        shown.read(&seen);
        if !wait(&seen.files(), || false) {
            return GOOD;
        }
    }
}

/// Selects what standard input names. Whoever writes there has started this, and it ends when they are gone.
fn follow(shown: &Arc<Shown>) {
    let shown = Arc::clone(shown);
    std::thread::spawn(move || {
        for line in stdin().lock().lines() {
            let Ok(line) = line else { break };
            shown.select(line);
        }
        std::process::exit(GOOD.into());
    });
}

/// Opens the browser, if there is one; the address has been said. On macOS other users could read the secret where the
/// arguments of programs are listed, so it is not one; on Linux they could as well, and are turned away (`peer.rs`).
fn open(url: &str) {
    let quiet = |command: &mut Command| {
        let started = command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::null()).spawn();
        started.ok().and_then(|mut child| child.stdin.take())
    };
    if cfg!(target_os = "macos") {
        if let Some(mut script) = quiet(Command::new("osascript").arg("-")) {
            let _ = writeln!(script, "open location \"{url}\"");
        }
    } else if cfg!(windows) {
        quiet(Command::new("cmd").args(["/c", "start", "", url]));
    } else {
        quiet(Command::new("xdg-open").arg(url));
    }
}
