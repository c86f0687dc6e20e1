//! `scenelang check --watch`: judges again whenever a file changes that the last judgement has read, or would have read.
//!
//! Files are looked at four times a second. That needs nothing of the operating system, and sees a save by renaming, a
//! file that appears, and a folder on another machine like any other change.

use crate::args::{Check, Format};
use crate::{check, interrupt, targets};
use scenelang_base::door::Door;
use scenelang_lang::sources::Loader;
use std::collections::BTreeMap;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, SystemTime};

/// Between two looks at Ctrl-C.
const TICK: Duration = Duration::from_millis(50);
/// So many ticks between two looks at the files.
const TICKS: usize = 5;
/// So often a file that is still being written is waited for.
const PATIENCE: usize = 40;

/// Judges until Ctrl-C; the last exit code.
pub fn run(args: &Check) -> u8 {
    let people = args.format == Format::Human;
    // Whoever has read a report and ends the watch then gets its code, however soon that is.
    let _gentle = interrupt::Gentle::new();
    loop {
        if people && io::stdout().is_terminal() {
            // Clears the screen and what has scrolled off it.
            print!("\x1b[2J\x1b[3J\x1b[H");
        }
        let seen = Seen::default();
        let found = targets::find(&args.files);
        let code = check::pass(args, Some(&seen));
        let seen = seen.files();
        if people {
            let count = seen.values().filter(|stamp| stamp.is_some()).count();
            eprintln!("watching {count} file{}; Ctrl-C ends", if count == 1 { "" } else { "s" });
        }
        if !wait(&seen, || targets::find(&args.files) != found) {
            return code;
        }
    }
}

/// What tells one state of a file from another; `None`: there is none.
pub type Stamp = Option<(SystemTime, u64)>;

fn stamp(path: &Path) -> Stamp {
    let data = std::fs::metadata(path).ok()?;
    Some((data.modified().ok()?, data.len()))
}

/// A memory of what was asked for.
#[derive(Default)]
pub struct Seen(Mutex<BTreeMap<PathBuf, Stamp>>);

impl Seen {
    /// What was asked for, and the state it was in.
    pub fn files(self) -> BTreeMap<PathBuf, Stamp> {
        self.0.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The disk behind a door, and what was asked of it.
pub struct Watched<'a> {
    pub seen: &'a Seen,
    pub door: &'a Door,
}

impl Loader for Watched<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        // Before the file is read: a change in between is then seen as one. Of several looks the first counts.
        let stamp = stamp(path);
        self.seen.0.lock().unwrap_or_else(PoisonError::into_inner).entry(path.to_path_buf()).or_insert(stamp);
        self.door.read(path)
    }
}

/// Waits for a change, until it is complete; false: Ctrl-C.
pub fn wait(seen: &BTreeMap<PathBuf, Stamp>, others: impl Fn() -> bool) -> bool {
    let now = || seen.keys().map(|path| stamp(path)).collect::<Vec<_>>();
    let before: Vec<Stamp> = seen.values().copied().collect();
    loop {
        for _ in 0..TICKS {
            if interrupt::asked() {
                return false;
            }
            std::thread::sleep(TICK);
        }
        let mut last = now();
        if last == before && !others() {
            continue;
        }
        for _ in 0..PATIENCE {
            std::thread::sleep(TICK);
            let next = now();
            if next == last {
                break;
            }
            last = next;
        }
        return !interrupt::asked();
    }
}
