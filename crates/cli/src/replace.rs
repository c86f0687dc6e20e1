//! What a command may replace: what scenelang wrote and nobody edited since, or what the user says (`--force`). What it
//! reads it never writes over.

use scenelang_base::door::Door;
use scenelang_base::fs::{is_same, is_stream, write_set};
use scenelang_base::owned::{self, Change, InTheWay, Record, Standing, Why, sealed_json, sealed_program, write_folder};
use scenelang_export::OutFile;
use std::path::{Path, PathBuf};

/// So many files are named.
const NAMED: usize = 5;

/// Whether a file may be written, before any work is done for it.
///
/// # Errors
/// Why not, and how to go on.
pub fn permit(path: &Path, inputs: &[&Path], force: bool) -> Result<(), String> {
    if let Some(input) = inputs.iter().find(|input| is_same(input, path)) {
        return Err(format!(
            "{} is the input file {} itself, which must not be overwritten; name another file with -o",
            path.display(),
            input.display()
        ));
    }
    if force || is_stream(path) {
        return Ok(());
    }
    // A link that leads elsewhere may be somebody else's.
    Door::of(path)
        .permits(path)
        .map_err(|e| format!("cannot write {}: {e}; use --force to write it anyway", path.display()))?;
    let why = match owned::standing(path).map_err(|e| e.to_string())? {
        Standing::Free | Standing::Ours => return Ok(()),
        Standing::Edited => "has been edited since scenelang wrote it",
        Standing::Foreign => "exists already and was not written by scenelang",
    };
    Err(format!(
        "{} {why}, so it is not overwritten; use --force to overwrite it, or name another file",
        path.display()
    ))
}

/// Writes a program, with a sum by which it is known again.
///
/// # Errors
/// What the file system says.
pub fn program(path: &Path, text: &str) -> Result<(), String> {
    let text = if is_stream(path) { text.to_owned() } else { sealed_program(text) };
    write_set(&[(path.to_path_buf(), text.as_bytes())]).map_err(|e| e.to_string())
}

/// Writes a JSON document in the same way.
///
/// # Errors
/// What the file system says.
pub fn json(path: &Path, text: &str) -> Result<(), String> {
    layouts(&[(path, text)], |_| false)
}

/// Writes layouts, all or none of them. `edited`: whether somebody's work is in it, which the next command is not to take
/// for ours.
///
/// # Errors
/// What the file system says.
pub fn layouts(files: &[(&Path, &str)], edited: impl Fn(&Path) -> bool) -> Result<(), String> {
    let plain = |path: &Path| edited(path) || is_stream(path);
    let sealed = |(path, text): &(&Path, &str)| {
        (path.to_path_buf(), if plain(path) { (*text).to_owned() } else { sealed_json(text) })
    };
    let files: Vec<(PathBuf, String)> = files.iter().map(sealed).collect();
    let set: Vec<_> = files.iter().map(|(path, text)| (path.clone(), text.as_bytes())).collect();
    write_set(&set).map_err(|e| e.to_string())
}

/// Writes programs and layouts, all or none of them: `ours` with the sum by which they are known again, `edited` without.
///
/// # Errors
/// What the file system says.
pub fn mixed(ours: &[(&Path, &str)], edited: &[(&Path, &str)]) -> Result<(), String> {
    let is_json = |path: &Path| path.extension().is_some_and(|e| e.eq_ignore_ascii_case("json"));
    let sealed = ours
        .iter()
        .map(|(path, text)| (path.to_path_buf(), if is_json(path) { sealed_json(text) } else { sealed_program(text) }));
    let plain = edited.iter().map(|(path, text)| (path.to_path_buf(), (*text).to_owned()));
    let files: Vec<(PathBuf, String)> = sealed.chain(plain).collect();
    let set: Vec<_> = files.iter().map(|(path, text)| (path.clone(), text.as_bytes())).collect();
    write_set(&set).map_err(|e| e.to_string())
}

/// Whether a file that was read as `text` is as we wrote it.
pub fn is_ours(path: &Path, text: &str) -> bool {
    owned::said(text.as_bytes()) == Standing::Ours || owned::standing(path).is_ok_and(|is| is == Standing::Ours)
}

/// Whether the files that were written into a folder before are as they were: asked before the work, so that it is not
/// done in vain.
///
/// # Errors
/// Which are not, and how to go on.
pub fn unedited(folder: &Path, force: bool) -> Result<(), String> {
    still_ours(if force { Vec::new() } else { owned::edited_below(folder) })
}

/// Says of files that were edited why they are not replaced.
///
/// # Errors
/// There are any.
pub fn still_ours(edited: Vec<PathBuf>) -> Result<(), String> {
    if edited.is_empty() {
        return Ok(());
    }
    let files = edited.into_iter().map(|path| (path, Why::Edited)).collect::<Vec<_>>();
    Err(refused(&files))
}

/// What may be replaced of what is not ours.
#[derive(Clone, Copy, Debug, Default)]
pub struct May<'a> {
    /// Everything.
    pub force: bool,
    /// These files, and what is below these folders.
    pub these: &'a [PathBuf],
}

/// Writes a set of files into a folder, all or none of them. Which files.
///
/// # Errors
/// Which are in the way, and how to go on; or what the file system says.
pub fn folder(folder: &Path, files: &[OutFile], inputs: &[&Path], may: May<'_>) -> Result<Vec<PathBuf>, String> {
    permit_folder(folder, files, inputs, may)?;
    let set = set_of(files);
    write_folder(folder, &set).map_err(|e| e.to_string())?;
    Ok(set.into_iter().map(|(name, _)| folder.join(name)).collect())
}

/// What became of a folder.
#[derive(Clone, Debug, Default)]
pub struct Changed {
    /// Files that are other ones than before.
    pub written: Vec<PathBuf>,
    /// Files that no longer belonged there.
    pub removed: Vec<PathBuf>,
    /// Files that no longer belong there but were edited.
    pub kept: Vec<PathBuf>,
}

/// Writes a set of files into a folder, removes what no longer belongs there if it is ours, and records it.
///
/// # Errors
/// As for [`folder`].
pub fn change(
    folder: &Path,
    files: &[OutFile],
    (gone, record): (&[PathBuf], &Record),
    inputs: &[&Path],
    may: May<'_>,
) -> Result<Changed, String> {
    permit_folder(folder, files, inputs, may)?;
    let door = Door::within(folder);
    let is_inside = |name: &&PathBuf| door.permits(&folder.join(name)).is_ok();
    let gone: Vec<PathBuf> = gone.iter().filter(is_inside).cloned().collect();
    let set = set_of(files);
    let steps = Change { files: &set, gone: &gone, record: Some(record) }.steps(folder).map_err(|e| e.to_string())?;
    steps.run().map_err(|e| e.to_string())?;
    Ok(Changed { written: steps.written, removed: steps.removed, kept: steps.kept })
}

fn set_of(files: &[OutFile]) -> Vec<(PathBuf, &[u8])> {
    files.iter().map(|file| (file.path.clone(), file.bytes.as_slice())).collect()
}

/// Whether [`folder`] would write these files, where something else has to be written before.
///
/// # Errors
/// Which are in the way, and how to go on.
pub fn permit_folder(folder: &Path, files: &[OutFile], inputs: &[&Path], may: May<'_>) -> Result<(), String> {
    let set = set_of(files);
    let door = Door::within(folder);
    for (name, bytes) in &set {
        let path = folder.join(name);
        door.permits(&path).map_err(|e| format!("cannot write {}: {e}", path.display()))?;
        // A scene may be built beside its own program, which stays as it is.
        let lost =
            |input: &&&Path| is_same(input, &path) && Door::of(input).read(input).ok().as_deref() != Some(*bytes);
        if let Some(input) = inputs.iter().find(lost) {
            let input = input.display();
            return Err(format!("{} would overwrite the input {input}; name another folder with -o", path.display()));
        }
    }
    if may.force {
        return Ok(());
    }
    let allowed = |found: &InTheWay| found.why != Why::Outside && may.these.iter().any(|at| found.path.starts_with(at));
    let found = owned::in_the_way(folder, &set).map_err(|e| e.to_string())?;
    let found: Vec<_> =
        found.into_iter().filter(|found| !allowed(found)).map(|found| (found.path, found.why)).collect();
    if found.is_empty() { Ok(()) } else { Err(refused(&found)) }
}

fn refused(files: &[(PathBuf, Why)]) -> String {
    let mut out = "nothing was written, because these files must not be overwritten:\n".to_owned();
    for (path, why) in files.iter().take(NAMED) {
        let why = match why {
            Why::Edited => "has been edited since scenelang wrote it",
            Why::Foreign => "exists already and was not written by scenelang",
            Why::Outside => "is behind a link that leads out of the folder",
        };
        out += &format!("  {} {why}\n", path.display());
    }
    if files.len() > NAMED {
        out += &format!("  and {} more\n", files.len() - NAMED);
    }
    out + "use --force to overwrite them, or name another folder with -o"
}
