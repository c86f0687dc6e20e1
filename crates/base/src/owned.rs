//! Which files are ours to replace: those that we wrote and nobody has changed since.
//!
//! A program has a sum of its text in its first line, a JSON document in its first member. In a folder of exported files a
//! list has the sums of all, in the form of `sha256sum`. A file without a sum is somebody else's work, and one whose sum is
//! wrong was edited. The sums guard against mistakes; anybody can forge them.

mod change;

pub use change::{Change, ChangeStep, Record, Steps};

use crate::fs::is_stream;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// How the first line of a program begins that we wrote; 16 digits follow.
const PROGRAM: &str = "// Written by scenelang; checksum ";
/// How the second line of a JSON document begins that we wrote; 16 digits and `",` follow.
const MEMBER: &str = "  \"written\": \"";
/// So many digits of a sum are written into a file.
const DIGITS: usize = 16;
/// The list of the files of a folder. Its beginning is that of temporary files: what is hidden and ours.
pub const LIST: &str = ".scenelang-files.sha256";
/// Larger files than this (bytes) are none of ours.
const LARGEST: u64 = 1 << 30;

/// What is at a path, as far as replacing it goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Nothing that could be lost: no file, an empty one, a pipe or a device.
    Free,
    /// A file that we wrote, as we wrote it.
    Ours,
    /// A file that we wrote and that was edited since.
    Edited,
    /// A file that we did not write, or that does not say so.
    Foreign,
}

/// A program with its sum.
pub fn sealed_program(text: &str) -> String {
    let text = unsealed(text);
    format!("{PROGRAM}{}\n{text}", short(text))
}

/// A JSON document, an object with a member a line, with its sum as its first member.
pub fn sealed_json(text: &str) -> String {
    let text = without_member(text);
    let sum = short(&text);
    match text.split_once('\n') {
        Some(("{", rest)) if !rest.trim_start().starts_with('}') => format!("{{\n{MEMBER}{sum}\",\n{rest}"),
        _ => text,
    }
}

/// A program without its sum.
fn unsealed(text: &str) -> &str {
    match text.strip_prefix(PROGRAM).and_then(|rest| rest.split_once('\n')) {
        Some((sum, rest)) if is_sum(sum.trim_end_matches('\r')) => rest,
        _ => text,
    }
}

fn without_member(text: &str) -> String {
    match member(text) {
        Some((_, line)) => text.replacen(line, "", 1),
        None => text.to_owned(),
    }
}

/// The sum in a JSON document, and its line.
fn member(text: &str) -> Option<(&str, &str)> {
    let line = text.split_inclusive('\n').nth(1)?;
    let sum = line.strip_prefix(MEMBER)?.trim_end().strip_suffix("\",")?;
    is_sum(sum).then_some((sum, line))
}

fn is_sum(text: &str) -> bool {
    text.len() == DIGITS && text.bytes().all(|b| b.is_ascii_hexdigit())
}

/// The sum of a text, whatever the ends of its lines became on their way through version control.
fn short(text: &str) -> String {
    let mut sum = full(text.replace('\r', "").as_bytes());
    sum.truncate(DIGITS);
    sum
}

/// The sum of some bytes, in full.
pub fn full(bytes: &[u8]) -> String {
    digits(&Sha256::digest(bytes))
}

fn digits(sum: &[u8]) -> String {
    sum.iter().fold(String::new(), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}

/// What the bytes of a file say of themselves.
pub fn said(bytes: &[u8]) -> Standing {
    let Ok(text) = std::str::from_utf8(bytes) else { return Standing::Foreign };
    let held = |sum: &str, rest: &str| if sum == short(rest) { Standing::Ours } else { Standing::Edited };
    if text.is_empty() {
        return Standing::Free;
    }
    if let Some(rest) = text.strip_prefix(PROGRAM) {
        let (sum, rest) = rest.split_once('\n').unwrap_or((rest, ""));
        return held(sum.trim_end_matches('\r'), rest);
    }
    member(text).map_or(Standing::Foreign, |(sum, _)| held(sum, &without_member(text)))
}

/// What is at a path. A file without a sum is asked for in the list of its folder.
///
/// # Errors
/// It cannot be read.
pub fn standing(path: &Path) -> io::Result<Standing> {
    let Some(bytes) = there(path)? else { return Ok(Standing::Free) };
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    Ok(match (said(&bytes), path.file_name()) {
        (Standing::Foreign | Standing::Edited, Some(name)) => List::of(folder).standing(Path::new(name), &bytes),
        (known, _) => known,
    })
}

/// The bytes of a file; `None`: there is none.
fn there(path: &Path) -> io::Result<Option<Vec<u8>>> {
    let tell = |e: io::Error| io::Error::new(e.kind(), format!("cannot read {}: {e}", path.display()));
    match fs::metadata(path) {
        Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(e) => Err(tell(e)),
        // Nothing is read from a pipe; and that a folder is no file is for the write to say.
        Ok(data) if !data.is_file() || is_stream(path) => Ok(None),
        // Never empty, and no text of ours.
        Ok(data) if data.len() > LARGEST => Ok(Some(vec![0])),
        Ok(_) => fs::read(path).map(Some).map_err(tell),
    }
}

/// The sums of the files of a folder. A file has two between the moment in which it is about to be replaced and that in
/// which all of its set are.
#[derive(Default)]
struct List(BTreeMap<String, BTreeSet<String>>);

impl List {
    /// The list of a folder; without one, an empty list.
    fn of(folder: &Path) -> Self {
        let mut out = Self::default();
        for line in fs::read_to_string(folder.join(LIST)).unwrap_or_default().lines() {
            if let Some((sum, name)) = line.split_once("  ") {
                out.0.entry(name.to_owned()).or_default().insert(sum.to_owned());
            }
        }
        out
    }

    fn standing(&self, name: &Path, bytes: &[u8]) -> Standing {
        match (self.0.get(&key(name)), said(bytes)) {
            (_, Standing::Ours) => Standing::Ours,
            (_, Standing::Free) => Standing::Free,
            (Some(sums), _) if sums.contains(&full(bytes)) => Standing::Ours,
            (Some(_), _) => Standing::Edited,
            (None, own) => own,
        }
    }

    fn text(&self) -> String {
        let lines = self.0.iter().flat_map(|(name, sums)| sums.iter().map(move |sum| format!("{sum}  {name}\n")));
        lines.collect()
    }
}

/// A path below the folder, as the list has it on every system.
fn key(path: &Path) -> String {
    path.components().map(|c| c.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// A file that is there and may be somebody's work.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InTheWay {
    pub path: PathBuf,
    /// Why it is not replaced.
    pub why: Why,
}

/// Why a file is not replaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// It was edited since we wrote it.
    Edited,
    /// We did not write it.
    Foreign,
    /// A link leads out of the folder.
    Outside,
}

/// Files of a set that are not ours to replace, in order. A file that is as it would be written is in nobody's way.
///
/// # Errors
/// One of them cannot be read.
pub fn in_the_way(folder: &Path, files: &[(PathBuf, &[u8])]) -> io::Result<Vec<InTheWay>> {
    let list = List::of(folder);
    let root = folder.canonicalize().ok();
    let mut out = Vec::new();
    for (name, bytes) in files {
        let path = folder.join(name);
        let Some(old) = there(&path)? else {
            if is_outside(root.as_deref(), &path) {
                out.push(InTheWay { path, why: Why::Outside });
            }
            continue;
        };
        if old == *bytes {
            continue;
        }
        let why = match list.standing(name, &old) {
            _ if is_outside(root.as_deref(), &path) => Why::Outside,
            Standing::Edited => Why::Edited,
            Standing::Foreign => Why::Foreign,
            Standing::Free | Standing::Ours => continue,
        };
        out.push(InTheWay { path, why });
    }
    Ok(out)
}

/// Files that the list of a folder has and that were edited, as far as can be known before the new ones are made.
pub fn edited_below(folder: &Path) -> Vec<PathBuf> {
    let list = List::of(folder);
    let edited = list.0.keys().map(|name| (name, folder.join(name))).filter(|(name, path)| {
        let bytes = there(path).ok().flatten();
        bytes.is_some_and(|bytes| list.standing(Path::new(name), &bytes) == Standing::Edited)
    });
    edited.map(|(_, path)| path).collect()
}

/// Whether the list of a folder has a file of this name, or files below a folder of this name.
pub fn knows(folder: &Path, name: &Path) -> bool {
    let (name, below) = (key(name), format!("{}/", key(name)));
    List::of(folder).0.keys().any(|known| *known == name || known.starts_with(&below))
}

/// The sum of what a folder has under some names, in their order; `None`: one of them is missing, or cannot be read.
pub fn sum_below<'n>(folder: &Path, names: impl IntoIterator<Item = &'n str>) -> Option<String> {
    let mut sum = Sha256::new();
    for name in names {
        sum.update(full(&there(&folder.join(name)).ok()??));
    }
    Some(digits(&sum.finalize()))
}

/// The same of files that are not written yet.
pub fn sum_of<'b>(files: impl IntoIterator<Item = &'b [u8]>) -> String {
    let mut sum = Sha256::new();
    files.into_iter().for_each(|bytes| sum.update(full(bytes)));
    digits(&sum.finalize())
}

/// Whether a path below a folder leads out of it, by a link on its way.
fn is_outside(root: Option<&Path>, path: &Path) -> bool {
    let Some(root) = root else { return false };
    let there = path.ancestors().find_map(|p| p.canonicalize().ok());
    there.is_some_and(|real| !real.starts_with(root) && !root.starts_with(&real))
}

/// Writes a set of files below a folder, and the list of their sums. Whoever calls has asked [`in_the_way`] before. Files
/// that are there already as they would be written stay, and are not listed if they were not.
///
/// # Errors
/// What the file system says; the message names the path, and the files that are new.
pub fn write_folder(folder: &Path, files: &[(PathBuf, &[u8])]) -> io::Result<()> {
    Change { files, gone: &[], record: None }.steps(folder)?.run()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAYOUT: &str = "{\n  \"format\": \"x\",\n  \"objects\": {}\n}\n";

    #[test]
    fn what_we_wrote_is_known_until_it_is_edited() {
        let cases = [(sealed_program("object a;\n"), "a;", "b;"), (sealed_json(LAYOUT), "{}", "{ }")];
        for (text, old, new) in cases {
            assert_eq!(said(text.as_bytes()), Standing::Ours, "{text}");
            assert_eq!(said(text.replace('\n', "\r\n").as_bytes()), Standing::Ours, "{text}");
            let edited = text.replacen(old, new, 1);
            assert!(edited != text && said(edited.as_bytes()) == Standing::Edited, "{edited}");
        }
        for (text, is) in [("", Standing::Free), ("object a;\n", Standing::Foreign), (LAYOUT, Standing::Foreign)] {
            assert_eq!(said(text.as_bytes()), is, "{text}");
        }
    }

    #[test]
    fn a_second_seal_takes_the_place_of_the_first() {
        let (program, layout) = (sealed_program("object a;\n"), sealed_json(LAYOUT));
        assert_eq!((sealed_program(&program), sealed_json(&layout)), (program, layout));
        assert_eq!(sealed_json("{}"), "{}", "there is no place for it");
    }

    #[test]
    fn a_folder_knows_its_files() {
        let dir = tempfile::tempdir().unwrap();
        let files = |a: &'static [u8], b: &'static [u8]| [(PathBuf::from("a"), a), (PathBuf::from("deep/b"), b)];
        let (old, new) = (files(b"1", b"2"), files(b"1", b"3"));
        write_folder(dir.path(), &old).unwrap();
        assert_eq!(in_the_way(dir.path(), &new).unwrap(), []);
        assert_eq!(standing(&dir.path().join("a")).unwrap(), Standing::Ours);
        write_folder(dir.path(), &new).unwrap();
        let list = fs::read_to_string(dir.path().join(LIST)).unwrap();
        assert_eq!(list.lines().count(), 2, "{list}");
        let b = dir.path().join("deep/b");
        fs::write(&b, "mine").unwrap();
        assert_eq!(in_the_way(dir.path(), &new).unwrap(), [InTheWay { path: b.clone(), why: Why::Edited }]);
        assert_eq!(edited_below(dir.path()), std::slice::from_ref(&b));
        let known = ["a", "deep", "deep/b", "dee", "b"].map(|name| knows(dir.path(), Path::new(name)));
        assert_eq!(known, [true, true, true, false, false]);
        fs::write(&b, "3").unwrap();
        assert_eq!(in_the_way(dir.path(), &old).unwrap(), []);
    }

    #[test]
    fn a_file_that_is_the_same_already_stays_its_owners() {
        let dir = tempfile::tempdir().unwrap();
        let a = PathBuf::from("a");
        fs::write(dir.path().join("a"), "1").unwrap();
        write_folder(dir.path(), &[(a.clone(), b"1"), (PathBuf::from("b"), b"2")]).unwrap();
        let other: &[u8] = b"other";
        let why = in_the_way(dir.path(), &[(a, other)]).unwrap();
        assert_eq!(why, [InTheWay { path: dir.path().join("a"), why: Why::Foreign }]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_out_of_the_folder_is_in_the_way() {
        let (dir, far) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        std::os::unix::fs::symlink(far.path(), dir.path().join("out")).unwrap();
        let files: [(PathBuf, &[u8]); 1] = [(PathBuf::from("out/a"), b"1")];
        let why = in_the_way(dir.path(), &files).unwrap();
        assert_eq!(why, [InTheWay { path: dir.path().join("out/a"), why: Why::Outside }]);
    }
}
