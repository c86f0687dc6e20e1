//! What comes with the server and is to be read in an editor: files of the standard library, and the pages of codes. They are
//! kept where an editor can open them, and need no network.

use crate::disk;
use crate::dispatch::Fault;
use scenelang_base::codes::Code;
use scenelang_base::door::Door;
use scenelang_lang::library;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};
use tower_lsp::ls_types::Uri;

/// Where the page of a code is for those who cannot be given a file.
const ELSEWHERE: &str = "https://github.com/scenelang/scenelang/blob/main/spec/src/codes/";

/// Where files are kept that can be made again: the user's own folder, since into the one for temporary files anybody may
/// have put something else under the same name.
fn kept() -> PathBuf {
    let set = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let own = if cfg!(windows) { set("LOCALAPPDATA") } else { set("XDG_CACHE_HOME") };
    let own = own.or_else(|| std::env::home_dir().map(|home| home.join(".cache")));
    own.unwrap_or_else(std::env::temp_dir).join("scenelang").join(env!("CARGO_PKG_VERSION"))
}

/// A file in that folder, written unless it is there as it should be.
fn file(name: &str, text: &str) -> std::io::Result<PathBuf> {
    let folder = kept();
    let (path, door) = (folder.join(name), Door::within(&folder));
    if door.read(&path).ok().as_deref() != Some(text.as_bytes()) {
        door.write(&path, text.as_bytes())?;
    }
    Ok(path)
}

/// A file of the standard library.
///
/// # Errors
/// There is none of that number, or it cannot be written.
pub fn library_file(index: usize) -> Result<(PathBuf, &'static str), Fault> {
    let (name, text) = library::FILES.get(index).ok_or(Fault::Internal)?;
    let path = file(name, text).map_err(|e| Fault::Failed(format!("the library cannot be shown: {e}")))?;
    Ok((path, text))
}

/// The address of the page of a code.
pub fn of_code(code: Code) -> Option<Uri> {
    static KNOWN: Mutex<BTreeMap<Code, Option<Uri>>> = Mutex::new(BTreeMap::new());
    // Each is looked for once: a program can have hundreds of marks.
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let make = || {
        let path = file(&format!("codes/{code}.md"), code.page()).ok();
        let kept = path.and_then(|path| disk::uri_of(&path));
        kept.or_else(|| format!("{ELSEWHERE}{code}.md").parse().ok())
    };
    known.entry(code).or_insert_with(make).clone()
}
