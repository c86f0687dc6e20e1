//! A file of samples. When it is complete, it has a record beside it; before that, a journal with an entry for each sample.

use super::stored::{Origin, Store};
use super::{file_of, record_of};
use crate::replace::{self, May};
use scenelang_base::FileId;
use scenelang_base::door::Door;
use scenelang_base::owned::{self, Standing, standing};
use scenelang_export::OutFile;
use scenelang_layout::file as layout_file;
use scenelang_sample::{Drawn, Missing, Sample, Tally, seed_of};
use serde::{Deserialize, Serialize};
use std::fs::{self, File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// What a record calls itself.
const FORMAT: &str = "scenelang.sampleFile/1";

/// The first line of a journal, and the first member of a record.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Head {
    format: String,
    pub origin: Origin,
    pub first: u64,
    pub end: u64,
    /// The formats in which each sample was exported.
    pub exported: Vec<String>,
}

/// What is kept of a complete file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Record {
    pub head: Head,
    /// The sum of the file.
    samples: String,
    drawn_as_whole: u64,
    no_layout: Vec<u64>,
    unverified: Vec<u64>,
    tally: Tally,
}

/// A sample in a journal.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    index: u64,
    /// The layout.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    line: Option<String>,
    /// Whether there is no layout because it failed the check, and not because the draws admit none.
    #[serde(default)]
    unverified: bool,
    #[serde(default)]
    whole: bool,
    tally: Tally,
}

/// A file of samples, complete or in progress.
pub struct Piece {
    folder: PathBuf,
    head: Head,
    /// The formats in which new samples are exported.
    export: Vec<String>,
    text: String,
    /// How many samples it has, including those without a layout.
    count: u64,
    pub whole: u64,
    no_layout: Vec<u64>,
    unverified: Vec<u64>,
    /// The counts of all its samples.
    pub tally: Tally,
    journal: Option<File>,
    is_recorded: bool,
}

impl Piece {
    /// What there is of it, and its samples (without their counts).
    pub fn open(store: &Store<'_>, range: &Range<u64>) -> (Self, Vec<Drawn>) {
        let head = Head {
            format: FORMAT.to_owned(),
            origin: store.origin.clone(),
            first: range.start,
            end: range.end,
            exported: store.export.to_vec(),
        };
        let mut piece = Self {
            folder: store.folder.to_path_buf(),
            head,
            export: store.export.to_vec(),
            text: String::new(),
            count: 0,
            whole: 0,
            no_layout: Vec::new(),
            unverified: Vec::new(),
            tally: Tally::new(store.program),
            journal: None,
            is_recorded: false,
        };
        let mut drawn = piece.recorded(store).unwrap_or_default();
        piece.resume(store, &mut drawn);
        (piece, drawn)
    }

    fn range(&self) -> Range<u64> {
        self.head.first..self.head.end
    }

    fn is_own(&self, head: &Head) -> bool {
        head.format == FORMAT && head.origin == self.head.origin && head.first == self.head.first
    }

    /// Takes a file that has a record, if both are as they were written. It may be shorter: fewer samples were asked for.
    fn recorded(&mut self, store: &Store<'_>) -> Option<Vec<Drawn>> {
        let range = self.range();
        let found = record(&self.folder, &record_of(&range)).filter(|found| self.is_own(&found.head))?;
        if found.head.end > range.end {
            return None;
        }
        let path = self.folder.join(file_of(&range));
        Door::within(&self.folder).permits(&path).ok()?;
        let text = fs::read_to_string(path).ok().filter(|text| owned::full(text.as_bytes()) == found.samples)?;
        let mut lines = text.lines();
        let mut drawn = Vec::new();
        for index in range.start..found.head.end {
            let result = match () {
                () if found.no_layout.contains(&index) => Err(Missing::NoLayout),
                () if found.unverified.contains(&index) => Err(Missing::Unverified),
                () => Ok(sample(lines.next()?, false)?),
            };
            drawn.push(bare(store, index, result));
        }
        self.is_recorded = found.head.end == range.end;
        (self.text, self.count, self.head.exported) = (text, drawn.len() as u64, found.head.exported);
        (self.whole, self.tally) = (found.drawn_as_whole, found.tally);
        (self.no_layout, self.unverified) = (found.no_layout, found.unverified);
        Some(drawn)
    }

    /// Takes the samples of the journal, as far as it can be read: its last entry may be cut off.
    fn resume(&mut self, store: &Store<'_>, drawn: &mut Vec<Drawn>) {
        let path = self.folder.join(journal_of(&self.range()));
        if self.is_recorded || Door::within(&self.folder).permits(&path).is_err() {
            return;
        }
        let text = fs::read(&path).unwrap_or_default();
        let mut lines = text.split_inclusive(|byte| *byte == b'\n').filter(|line| line.ends_with(b"\n"));
        let Some(first) = lines.next() else { return };
        let Some(head) = serde_json::from_slice::<Head>(first).ok().filter(|head| self.is_own(head)) else { return };
        let mut length = first.len();
        for line in lines {
            let Ok(entry) = serde_json::from_slice::<Entry>(line) else { break };
            let result = match &entry.line {
                Some(line) => sample(line, entry.whole).ok_or(Missing::Stopped),
                None if entry.unverified => Err(Missing::Unverified),
                None => Err(Missing::NoLayout),
            };
            let next = self.head.first + self.count;
            if entry.index > next || entry.index >= self.head.end || matches!(result, Err(Missing::Stopped)) {
                break;
            }
            length += line.len();
            // The record may have been written since.
            if entry.index < next {
                continue;
            }
            let mut found = Drawn { tally: entry.tally, ..bare(store, entry.index, result) };
            self.count_in(&found);
            found.tally = Tally::default();
            if let Ok(sample) = &mut found.result {
                sample.whole = false;
            }
            drawn.push(found);
        }
        self.head.exported.retain(|format| head.exported.contains(format));
        // What follows was cut off.
        let file = OpenOptions::new().write(true).open(&path).and_then(|mut file| {
            file.set_len(length as u64)?;
            file.seek(SeekFrom::End(0)).map(|_| file)
        });
        self.journal = file.ok();
    }

    /// How many samples there are, including those without a layout.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The formats that are wanted and that its samples do not have.
    pub fn lacks(&self, export: &[String]) -> Vec<String> {
        export.iter().filter(|format| !self.head.exported.contains(format)).cloned().collect()
    }

    /// All its samples have been exported in these formats, too.
    pub fn exported(&mut self, formats: Vec<String>) {
        self.is_recorded &= formats.is_empty();
        self.head.exported.extend(formats);
    }

    fn count_in(&mut self, drawn: &Drawn) {
        self.count += 1;
        self.tally.add(&drawn.tally);
        match &drawn.result {
            Ok(sample) => {
                self.whole += u64::from(sample.whole);
                self.text += &sample.line;
                self.text.push('\n');
            }
            Err(Missing::NoLayout) => self.no_layout.push(drawn.index),
            Err(_) => self.unverified.push(drawn.index),
        }
    }

    /// Takes the next sample. Of those after one that was not finished nothing is kept.
    ///
    /// # Errors
    /// What the file system says.
    pub fn add(&mut self, drawn: &Drawn) -> Result<(), String> {
        let is_next = drawn.index == self.head.first + self.count;
        if !is_next || matches!(drawn.result, Err(Missing::Stopped)) {
            return Ok(());
        }
        self.count_in(drawn);
        self.head.exported.retain(|format| self.export.contains(format));
        let entry = Entry {
            index: drawn.index,
            line: drawn.result.as_ref().ok().map(|sample| sample.line.clone()),
            unverified: matches!(drawn.result, Err(Missing::Unverified)),
            whole: drawn.result.as_ref().is_ok_and(|sample| sample.whole),
            tally: drawn.tally.clone(),
        };
        let path = self.folder.join(journal_of(&self.range()));
        self.note(&path, &entry).map_err(|e| format!("cannot write {}: {e}", path.display()))
    }

    fn note(&mut self, path: &Path, entry: &Entry) -> std::io::Result<()> {
        let mut text = String::new();
        if self.journal.is_none() {
            fs::create_dir_all(&self.folder)?;
            Door::within(&self.folder).permits(path)?;
            self.journal = Some(File::create(path)?);
            text = serde_json::to_string(&self.head)? + "\n";
        }
        text += &serde_json::to_string(entry)?;
        text.push('\n');
        self.journal.as_mut().map_or(Ok(()), |file| file.write_all(text.as_bytes()))
    }

    /// Writes the file and its record, unless they are there.
    ///
    /// # Errors
    /// Which files are in the way; what the file system says.
    pub fn finish(self, inputs: &[&Path], force: bool) -> Result<(), String> {
        let journal = self.folder.join(journal_of(&self.range()));
        // A run that ended right after the record was written has left its journal.
        if self.is_recorded {
            return removed(&journal);
        }
        let range = self.range();
        let record = Record {
            samples: owned::full(self.text.as_bytes()),
            drawn_as_whole: self.whole,
            no_layout: self.no_layout,
            unverified: self.unverified,
            tally: self.tally,
            head: self.head,
        };
        let record = serde_json::to_string(&record).map_err(|e| e.to_string())? + "\n";
        let files = [OutFile::new(file_of(&range), self.text), OutFile::new(record_of(&range), record)];
        replace::folder(&self.folder, &files, inputs, May { force, these: &[] })?;
        drop(self.journal);
        removed(&journal)
    }
}

/// Removes a journal that is no longer needed, if there is one.
fn removed(journal: &Path) -> Result<(), String> {
    match fs::remove_file(journal) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => Err(format!("cannot remove {}: {e}", journal.display())),
        _ => Ok(()),
    }
}

/// The journal of a file of samples.
fn journal_of(range: &Range<u64>) -> String {
    format!(".scenelang-samples-{:09}.journal", range.start)
}

/// A layout as it is stored.
fn sample(line: &str, whole: bool) -> Option<Sample> {
    let read = layout_file::read(line, FileId(0));
    let is_read = read.usable && !read.diagnostics.iter().any(|d| d.is_error());
    is_read.then(|| Sample { layout: read.layout, line: line.to_owned(), whole })
}

/// A sample without its counts.
fn bare(store: &Store<'_>, index: u64, result: Result<Sample, Missing>) -> Drawn {
    let seed = seed_of(store.origin.seed, index);
    Drawn { index, seed, draws: scenelang_solve::draws(store.program, seed), result, tally: Tally::default() }
}

/// A record, if it is as we wrote it.
pub fn record(folder: &Path, name: &str) -> Option<Record> {
    let path = folder.join(name);
    if standing(&path).ok()? != Standing::Ours {
        return None;
    }
    let record: Record = serde_json::from_slice(&Door::within(folder).read(&path).ok()?).ok()?;
    (record.head.format == FORMAT).then_some(record)
}
