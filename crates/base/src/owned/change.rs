//! The change of a folder as a whole: files that are written, files that no longer belong there and are removed, and a record
//! of both that whoever comes next reads.
//!
//! A change is a list of steps, each of which happens or does not. Lists and records say what was before and what will be until
//! all is done, so that after any step the next process knows which files are ours and goes on.

use super::{LIST, List, Standing, full, is_outside, key, there};
use crate::fs::{sweep, write_set};
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What is to become of a folder.
#[derive(Clone, Copy, Debug, Default)]
pub struct Change<'c, 'b> {
    /// Files to be there, with their bytes.
    pub files: &'c [(PathBuf, &'b [u8])],
    /// Files that no longer belong there. Those that we wrote and nobody edited are removed; all others stay.
    pub gone: &'c [PathBuf],
    /// What is written down of it.
    pub record: Option<&'c Record>,
}

/// A file that says what the others were made from. It is ours, and in no list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Record {
    /// Its name in the folder.
    pub name: PathBuf,
    /// Its bytes as long as old and new files may be mixed.
    pub during: Vec<u8>,
    /// Its bytes once all is done.
    pub after: Vec<u8>,
}

/// A step, which happens as a whole or not at all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChangeStep<'a> {
    Write(PathBuf, Cow<'a, [u8]>),
    /// A file is removed, and the folders that are empty without it.
    Remove(PathBuf),
}

/// The steps of a change, in order.
#[derive(Clone, Debug, Default)]
pub struct Steps<'a> {
    /// The folder that is changed.
    folder: PathBuf,
    /// The folders in which its files are.
    folders: BTreeSet<PathBuf>,
    /// All of them.
    pub steps: Vec<ChangeStep<'a>>,
    /// Files that are written: their bytes are other ones than before.
    pub written: Vec<PathBuf>,
    /// Files that are removed.
    pub removed: Vec<PathBuf>,
    /// Files that no longer belong there but were edited, and stay. They are the user's from now on.
    pub kept: Vec<PathBuf>,
}

impl<'b> Change<'_, 'b> {
    /// What has to be done, as the folder is now.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn steps(&self, folder: &Path) -> io::Result<Steps<'b>> {
        let mut list = List::of(folder);
        let before = list.text();
        let folders = self.files.iter().filter_map(|(name, _)| folder.join(name).parent().map(Path::to_path_buf));
        let mut out = Steps { folder: folder.to_path_buf(), folders: folders.collect(), ..Steps::default() };
        let (mut set, mut sums) = (Vec::new(), Vec::new());
        for (name, bytes) in self.files {
            let path = folder.join(name);
            let same = there(&path)?.is_some_and(|old| old == *bytes);
            if same && list.standing(name, bytes) == Standing::Foreign {
                continue;
            }
            let (key, sum) = (key(name), full(bytes));
            if !key.contains(['\n', '\r']) {
                list.0.entry(key.clone()).or_default().insert(sum.clone());
                sums.push((key, sum));
            }
            if !same {
                out.written.push(path.clone());
                set.push(ChangeStep::Write(path, Cow::Borrowed(*bytes)));
            }
        }
        let gone = self.gone(folder, &list, &mut out)?;
        // Old and new sums first: whatever ends this process, the next one knows its files.
        if !set.is_empty() || !out.removed.is_empty() {
            out.write(folder.join(LIST), &before, list.text().into_bytes());
            if let Some(record) = self.record {
                out.write(folder.join(&record.name), &read(folder, &record.name), record.during.clone());
            }
        }
        let during = list.text();
        let is_new = !out.steps.is_empty();
        out.steps.extend(set);
        out.steps.extend(out.removed.iter().cloned().map(ChangeStep::Remove));
        for (key, sum) in sums {
            list.0.insert(key, BTreeSet::from([sum]));
        }
        gone.iter().for_each(|name| drop(list.0.remove(name)));
        // What an earlier change has written before it was ended need not be written again, but is of one state now.
        for (name, sums) in list.0.iter_mut().filter(|(_, sums)| sums.len() > 1) {
            let sum = there(&folder.join(name))?.map(|bytes| full(&bytes)).filter(|sum| sums.contains(sum));
            sums.retain(|known| sum.as_ref().is_none_or(|sum| known == sum));
        }
        out.write(folder.join(LIST), if is_new { &during } else { &before }, list.text().into_bytes());
        if let Some(record) = self.record {
            let there = if is_new { record.during.clone() } else { read(folder, &record.name).into_bytes() };
            if there != record.after {
                out.steps.push(ChangeStep::Write(folder.join(&record.name), Cow::Owned(record.after.clone())));
            }
        }
        Ok(out)
    }

    /// Sorts what no longer belongs there; the names that the list need not have any more.
    fn gone(&self, folder: &Path, list: &List, out: &mut Steps<'_>) -> io::Result<Vec<String>> {
        let root = folder.canonicalize().ok();
        let mut names = Vec::new();
        for name in self.gone {
            let path = folder.join(name);
            if is_outside(root.as_deref(), &path) || !list.0.contains_key(&key(name)) {
                continue;
            }
            names.push(key(name));
            let Some(bytes) = there(&path)? else { continue };
            match list.standing(name, &bytes) {
                Standing::Free | Standing::Ours => out.removed.push(path),
                Standing::Edited | Standing::Foreign => out.kept.push(path),
            }
        }
        Ok(names)
    }
}

/// What the record says now; a text that none has if there is no record.
fn read(folder: &Path, name: &Path) -> String {
    there(&folder.join(name))
        .ok()
        .flatten()
        .map_or_else(String::new, |bytes| String::from_utf8_lossy(&bytes).into_owned())
}

impl Steps<'_> {
    fn write(&mut self, path: PathBuf, before: &str, bytes: Vec<u8>) {
        if before.as_bytes() != bytes {
            self.steps.push(ChangeStep::Write(path, Cow::Owned(bytes)));
        }
    }

    /// Does all of it.
    ///
    /// # Errors
    /// What the file system says; the message names the path, and the files that are new.
    pub fn run(&self) -> io::Result<()> {
        // A process that was killed leaves files, also where there is nothing to write any more.
        sweep(self.folders.iter().map(PathBuf::as_path));
        self.first(self.steps.len())
    }

    /// Does the first steps only: what is there if the process ends then.
    ///
    /// # Errors
    /// As for [`Steps::run`].
    pub fn first(&self, steps: usize) -> io::Result<()> {
        let mut set: Vec<(PathBuf, &[u8])> = Vec::new();
        for step in self.steps.iter().take(steps) {
            match step {
                // Of a file that is written twice, the first text has to be there while the others are written.
                ChangeStep::Write(path, bytes) => {
                    if set.iter().any(|(other, _)| other == path) {
                        write_set(&std::mem::take(&mut set))?;
                    }
                    set.push((path.clone(), bytes));
                }
                ChangeStep::Remove(path) => {
                    write_set(&std::mem::take(&mut set))?;
                    self.remove(path)?;
                }
            }
        }
        write_set(&set)
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        match fs::remove_file(path) {
            Err(e) if e.kind() != io::ErrorKind::NotFound => {
                return Err(io::Error::new(e.kind(), format!("cannot remove {}: {e}", path.display())));
            }
            _ => {}
        }
        // A folder that is not empty refuses.
        let above = path.ancestors().skip(1).take_while(|above| *above != self.folder);
        above.take_while(|above| fs::remove_dir(above).is_ok()).for_each(drop);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{in_the_way, write_folder};
    use super::*;

    fn change<'c, 'b>(files: &'c [(PathBuf, &'b [u8])], gone: &'c [PathBuf]) -> Change<'c, 'b> {
        Change { files, gone, record: None }
    }

    #[test]
    fn what_no_longer_belongs_is_removed_unless_it_is_somebodys_work() {
        let dir = tempfile::tempdir().unwrap();
        let at = |name: &str| dir.path().join(name);
        let old: Vec<(PathBuf, &[u8])> = ["a", "deep/er/b", "deep/c"].map(|n| (n.into(), b"1".as_slice())).into();
        write_folder(dir.path(), &old).unwrap();
        fs::write(at("deep/c"), "mine").unwrap();
        fs::write(at("foreign"), "theirs").unwrap();
        let gone = ["deep/er/b", "deep/c", "foreign", "nowhere"].map(PathBuf::from);
        let steps = change(&old[..1], &gone).steps(dir.path()).unwrap();
        assert_eq!((steps.removed.as_slice(), steps.kept.as_slice()), (&[at("deep/er/b")][..], &[at("deep/c")][..]));
        steps.run().unwrap();
        assert!(!at("deep/er").exists() && at("deep/c").exists() && at("foreign").exists());
        let list = fs::read_to_string(at(LIST)).unwrap();
        assert!(list.lines().count() == 1 && list.contains("  a\n"), "{list}");
        // What was kept is the user's now.
        assert_eq!(in_the_way(dir.path(), &[("deep/c".into(), b"2")]).unwrap().len(), 1);
        assert!(change(&old[..1], &gone).steps(dir.path()).unwrap().steps.is_empty());
    }

    #[test]
    fn what_a_killed_process_left_goes_though_nothing_is_written() {
        let dir = tempfile::tempdir().unwrap();
        let files: [(PathBuf, &[u8]); 1] = [("deep/a".into(), b"1")];
        write_folder(dir.path(), &files).unwrap();
        let left = dir.path().join("deep/.scenelang-aB3dE6.part");
        let age = std::time::SystemTime::now() - std::time::Duration::from_secs(600);
        fs::File::create(&left).unwrap().set_modified(age).unwrap();
        let steps = change(&files, &[]).steps(dir.path()).unwrap();
        assert!(steps.steps.is_empty() && left.exists());
        steps.run().unwrap();
        assert!(!left.exists());
    }

    #[test]
    fn a_record_says_both_until_all_is_done() {
        let dir = tempfile::tempdir().unwrap();
        let files: [(PathBuf, &[u8]); 1] = [("a".into(), b"1")];
        let record = Record { name: "record".into(), during: b"both".into(), after: b"new".into() };
        let change = Change { files: &files, gone: &[], record: Some(&record) };
        let steps = change.steps(dir.path()).unwrap();
        let says = || fs::read_to_string(dir.path().join("record")).unwrap_or_default();
        for (count, wanted) in [(0, ""), (2, "both"), (3, "both"), (4, "new")] {
            steps.first(count).unwrap();
            assert_eq!(says(), wanted, "{count} of {:?}", steps.steps);
        }
        assert!(change.steps(dir.path()).unwrap().steps.is_empty());
    }

    #[test]
    fn what_an_ended_change_has_written_is_of_one_state() {
        let dir = tempfile::tempdir().unwrap();
        let files = |bytes: &'static [u8]| ["a", "b"].map(|name| (PathBuf::from(name), bytes));
        write_folder(dir.path(), &files(b"1")).unwrap();
        let new = files(b"2");
        // The list, and one of both.
        change(&new, &[]).steps(dir.path()).unwrap().first(2).unwrap();
        change(&new[1..], &[]).steps(dir.path()).unwrap().run().unwrap();
        let list = fs::read_to_string(dir.path().join(LIST)).unwrap();
        assert_eq!(list.lines().count(), 2, "{list}");
    }

    #[cfg(unix)]
    #[test]
    fn nothing_is_removed_behind_a_link() {
        let (dir, far) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        write_folder(dir.path(), &[("out/a".into(), b"1")]).unwrap();
        fs::rename(dir.path().join("out"), far.path().join("out")).unwrap();
        std::os::unix::fs::symlink(far.path().join("out"), dir.path().join("out")).unwrap();
        let gone = [PathBuf::from("out/a")];
        let steps = change(&[], &gone).steps(dir.path()).unwrap();
        assert!(steps.removed.is_empty(), "{steps:?}");
        assert!(far.path().join("out/a").exists());
    }
}
