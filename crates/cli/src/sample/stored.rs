//! What earlier runs drew into a folder, and whether it belongs to this one. Whatever ends the command, the next one continues
//! from there.

use super::piece::{Piece, Record, record};
use super::{file_of, stem_of};
use crate::args::Shard;
use scenelang_base::door::Door;
use scenelang_base::owned::{self, Change};
use scenelang_lang::{Compiled, Program};
use scenelang_sample::Drawn;
use serde::{Deserialize, Serialize};
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// What determines a sample, apart from its number.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Origin {
    version: String,
    pub seed: u64,
    /// The program, as the layouts name it.
    scene: String,
    /// The sum of its text and of the files that it imports.
    program: String,
    /// The sum of all other options that matter.
    options: String,
}

impl Origin {
    pub fn new(compiled: &Compiled, seed: u64, scene: &str, options: &str) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            seed,
            scene: scene.to_owned(),
            program: owned::sum_of(compiled.sources.iter().map(|(_, file)| file.text().as_bytes())),
            options: owned::full(options.as_bytes()),
        }
    }

    /// How samples of another origin are described; `None`: they are the same.
    fn other(&self, other: &Self) -> Option<String> {
        match () {
            () if self.seed != other.seed => Some(format!("drawn with --seed {} instead of {}", other.seed, self.seed)),
            () if self.scene != other.scene => Some(format!("of the program {}", other.scene)),
            () if self.program != other.program => Some("of another version of the program".to_owned()),
            () if self.options != other.options => Some("drawn with other options".to_owned()),
            () if self.version != other.version => Some(format!("drawn by scenelang {}", other.version)),
            () => None,
        }
    }
}

/// The folder of a run, and what its samples come from.
pub struct Store<'a> {
    pub folder: &'a Path,
    pub program: &'a Program,
    pub origin: &'a Origin,
    /// The formats in which each sample is exported.
    pub export: &'a [String],
}

impl Store<'_> {
    /// What there is of a file, and its samples (without their counts, which the file has).
    pub fn open(&self, range: &Range<u64>) -> (Piece, Vec<Drawn>) {
        Piece::open(self, range)
    }

    /// Whether the folder has only samples of this run, up to a number.
    ///
    /// # Errors
    /// What else it has, and how to go on.
    pub fn permit(&self, end: u64) -> Result<(), String> {
        let found =
            records(self.folder).into_iter().find_map(|(_, record)| match self.origin.other(&record.head.origin) {
                None if record.head.end <= end => None,
                None => Some("with higher numbers than -n asks for".to_owned()),
                other => other,
            });
        let Some(what) = found else { return Ok(()) };
        Err(format!(
            "{} has samples {what}; name another folder with -o, or replace them with --force",
            self.folder.display()
        ))
    }

    /// Removes what other runs wrote, unless it was edited.
    ///
    /// # Errors
    /// What the file system says.
    pub fn clear(&self, end: u64) -> Result<(), String> {
        let door = Door::within(self.folder);
        let is_other = |record: &Record| self.origin != &record.head.origin || record.head.end > end;
        for (name, record) in records(self.folder).into_iter().filter(|(_, record)| is_other(record)) {
            let range = record.head.first..record.head.end;
            // The record last: as long as it is there, the files are known to belong to another run.
            for index in range.clone().filter(|_| !record.head.exported.is_empty()) {
                let folder = self.folder.join(stem_of(index));
                remove(&folder, &below(&folder))?;
                // The list of its files is left; a folder in which something else is left stays.
                let list = folder.join(owned::LIST);
                let is_empty = list.metadata().is_ok_and(|list| list.len() == 0);
                if is_empty && door.permits(&list).is_ok() && fs::remove_file(list).is_ok() {
                    let _ = fs::remove_dir(&folder);
                }
            }
            remove(self.folder, &[file_of(&range).into()])?;
            remove(self.folder, &[name.into()])?;
        }
        Ok(())
    }
}

/// Whether a folder has no samples of a run that was split in another way: all of them together would be of no run.
///
/// # Errors
/// It has some, and how to go on.
pub fn permit_split(output: &Path, shard: Shard) -> Result<(), String> {
    let Ok(entries) = output.read_dir() else { return Ok(()) };
    let own = format!("-of-{:05}", shard.of);
    let is_other = |name: &String| match name.starts_with("shard-") {
        true => shard.of == 1 || !name.ends_with(&own),
        false => shard.of > 1 && name.starts_with("samples-") && name.ends_with(".jsonl"),
    };
    match entries.flatten().filter_map(|entry| entry.file_name().into_string().ok()).filter(is_other).min() {
        None => Ok(()),
        Some(name) => Err(format!(
            "{} has samples of a run that was split in another way ({name}); name another folder with -o, or use --force to \
             write beside them",
            output.display()
        )),
    }
}

/// All records of a folder, in order.
fn records(folder: &Path) -> Vec<(String, Record)> {
    let Ok(entries) = folder.read_dir() else { return Vec::new() };
    let names = entries.flatten().filter_map(|entry| entry.file_name().into_string().ok());
    let mut names: Vec<String> = names.filter(|n| n.starts_with("samples-") && n.ends_with(".json")).collect();
    names.sort();
    names.into_iter().filter_map(|name| record(folder, &name).map(|record| (name, record))).collect()
}

/// Removes those of some files that are as we wrote them, and a folder that is empty without them.
fn remove(folder: &Path, names: &[PathBuf]) -> Result<(), String> {
    let steps = Change { files: &[], gone: names, record: None }.steps(folder).map_err(|e| e.to_string())?;
    steps.run().map_err(|e| e.to_string())
}

/// All files below a folder, by their names in it.
fn below(folder: &Path) -> Vec<PathBuf> {
    let (mut files, mut folders) = (Vec::new(), vec![folder.to_path_buf()]);
    while let Some(at) = folders.pop() {
        for entry in at.read_dir().into_iter().flatten().flatten() {
            match entry.file_type() {
                Ok(kind) if kind.is_dir() => folders.push(entry.path()),
                Ok(kind) if kind.is_file() => files.extend(entry.path().strip_prefix(folder).map(Path::to_path_buf)),
                _ => {}
            }
        }
    }
    files
}
