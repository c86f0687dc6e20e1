//! What of an output folder is made again: the manifest in it, read before the work and written after it, and what is said of
//! both (`--explain-rebuild`).

use crate::args::StageName;
use crate::replace::{self, Changed, May};
use scenelang_base::plain;
use scenelang_export::{Exporter, OutFile, Scene};
use scenelang_synth::rebuild::{self, Before, Format, Inputs, Known, Manifest, Planned, State};
use scenelang_synth::{Made, Solved};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// So many objects, or files, are named.
const NAMED: usize = 8;

/// What is known of a folder, and what becomes of it.
pub struct Rebuild<'a> {
    folder: &'a Path,
    stem: &'a str,
    manifest: Manifest,
    /// What an earlier run has left.
    known: Known,
    /// The first stage that is made again in any case.
    from: Option<StageName>,
    /// The next manifest's entry.
    next: Known,
    /// What is said of it.
    pub told: RebuildReport,
}

/// An object or a format, and why it was made again.
type Again = (String, Vec<String>);

/// What was made again, and why.
#[derive(Default)]
pub struct RebuildReport {
    program: Option<Vec<String>>,
    /// How many objects there are, and why some of them were made again.
    assets: Option<(usize, Vec<Again>)>,
    layout: Option<Vec<String>>,
    formats: Vec<Again>,
    changed: Changed,
}

impl<'a> Rebuild<'a> {
    /// Reads what is known of a scene.
    pub fn of(folder: &'a Path, stem: &'a str, from: Option<StageName>) -> Self {
        let manifest = Manifest::of(folder);
        let known = manifest.scene(stem);
        Self { folder, stem, next: known.clone(), known, manifest, from, told: RebuildReport::default() }
    }

    /// Whether a stage is made again because the user says so; why.
    fn anew(&self, stage: StageName) -> Option<String> {
        let from = self.from.filter(|from| *from <= stage)?;
        Some(format!("--from {}", name(from)))
    }

    /// Whether the program of a request need not be written again.
    pub fn has_program(&mut self, inputs: &Inputs) -> bool {
        let anew = self.anew(StageName::Program);
        let same = self.known.program.iter().find(|state| state.inputs == *inputs);
        let is_there = same.is_some_and(|state| state.is_there(self.folder));
        let why = match (anew, same, is_there) {
            (Some(why), ..) => vec![why],
            (None, Some(_), true) => Vec::new(),
            (None, Some(_), false) => vec!["the program is missing or was changed since it was written".to_owned()],
            (None, None, _) if self.known.program.is_empty() => vec!["it was not written before".to_owned()],
            (None, None, _) => vec!["the request, or the way it is read, has changed".to_owned()],
        };
        self.told.program = Some(why);
        is_there && self.from != Some(StageName::Program)
    }

    /// Notes the program: what it was written from, and its files. A program that the user has written is read in any case.
    pub fn program(&mut self, request: Option<Inputs>, files: &[OutFile]) {
        let names = rebuild::own_names(files);
        let sums = || names.iter().cloned().zip(files.iter().map(|file| rebuild::sum(&file.bytes))).collect();
        let inputs = request.unwrap_or_else(sums);
        if self.told.program.is_none() {
            let before = self.known.program.last().map(|state| &state.inputs);
            let why = before.map(|before| rebuild::of_program(before, &inputs));
            self.told.program = Some(why.unwrap_or_else(|| vec!["it was not written before".to_owned()]));
        }
        let sum = scenelang_base::owned::sum_of(files.iter().map(|file| file.bytes.as_slice()));
        self.next.program = vec![State { inputs, files: names, sum, converged: false }];
    }

    /// The layout to keep or to start from.
    pub fn before(&self, seed: u64) -> Option<Before> {
        // Another seed asks for another layout.
        let is_same = |before: &Before| before.inputs.get("seed").is_some_and(|was| *was == seed.to_string());
        self.known.layout(self.folder).filter(is_same).filter(|_| self.anew(StageName::Layout).is_none())
    }

    /// Notes what objects were given.
    pub fn assets(&mut self, made: &Made) {
        let anew = self.anew(StageName::Assets);
        let why = |(name, look): (&String, &rebuild::AssetInput)| {
            let why = match (&anew, self.known.assets.get(name)) {
                (Some(why), _) => vec![why.clone()],
                (None, None) => vec!["it was not there before".to_owned()],
                (None, Some(before)) => look.changes(before),
            };
            (!why.is_empty()).then(|| (name.clone(), why))
        };
        let again = made.looks.iter().filter_map(why).collect();
        self.told.assets = Some((made.looks.len(), again));
        self.next.assets = made.looks.clone();
    }

    /// Notes the layout. `taken`: it was begun from an edited scene.
    pub fn layout(&mut self, solved: &Solved, quality: u8, taken: Option<&str>) {
        let mut state = State {
            inputs: solved.made.inputs.clone(),
            files: vec![format!("{}.layout.json", self.stem)],
            sum: scenelang_base::owned::sum_of([solved.first.text.as_bytes()]),
            converged: solved.first.outcome.converged,
        };
        // A layout that was taken is as good as one that was looked for.
        state.inputs.insert("quality".to_owned(), quality.to_string());
        let why = match (self.anew(StageName::Layout), taken, self.known.layout.last()) {
            _ if solved.made.kept => Vec::new(),
            (Some(why), ..) => vec![why],
            (None, Some(from), _) => vec![format!("{from} was edited")],
            (None, None, None) => vec!["it was not written before".to_owned()],
            (None, None, Some(before)) => {
                let why = rebuild::of_layout(&before.inputs, &state.inputs);
                let is_cut = || vec!["it is missing, was changed since it was written, or was not finished".to_owned()];
                if why.is_empty() { is_cut() } else { why }
            }
        };
        self.told.layout = Some(why);
        self.next.layout = vec![state];
    }

    /// The files of the formats that have to be made again; `None`: `go_on` said no.
    ///
    /// # Errors
    /// A format cannot hold the scene.
    pub fn formats(
        &mut self,
        scene: &Scene,
        exporters: &[Box<dyn Exporter>],
        go_on: &mut dyn FnMut(&str) -> bool,
    ) -> Result<Option<Planned>, String> {
        let anew = self.anew(StageName::Export);
        let planned = rebuild::planned(scene, (self.folder, &self.known), exporters, anew.as_deref(), go_on);
        let planned = planned.map_err(|e| e.to_string())?;
        for format in planned.iter().flat_map(|planned| &planned.formats) {
            self.told.formats.push((format.name.clone(), format.why.clone()));
        }
        Ok(planned)
    }

    /// Writes what was made, removes what no longer belongs, and records both. All files that the scene has from these stages.
    ///
    /// # Errors
    /// What is in the way, and how to go on; or what the file system says.
    pub fn write(
        &mut self,
        own: Vec<OutFile>,
        planned: Planned,
        inputs: &[&Path],
        may: May<'_>,
        is_whole: bool,
    ) -> Result<Vec<PathBuf>, String> {
        let mut names = rebuild::own_names(&own);
        // What only later stages write is still there.
        let later =
            self.known.own.iter().filter(|name| !is_whole && !names.contains(name)).cloned().collect::<Vec<_>>();
        let listed = names.iter().chain(planned.formats.iter().flat_map(|format| &format.state.files));
        let all = listed.map(|name| self.folder.join(name)).collect();
        names.extend(later);
        self.next.own = names;
        let mut files = own;
        files.extend(planned.files);
        self.record(&files, &planned.formats, inputs, may)?;
        Ok(all)
    }

    fn record(&mut self, files: &[OutFile], formats: &[Format], inputs: &[&Path], may: May<'_>) -> Result<(), String> {
        let (next, gone) = self.manifest.after(self.stem, self.next.clone(), formats);
        let record = self.manifest.record(self.stem, &next);
        self.told.changed = replace::change(self.folder, files, (&gone, &record), inputs, may)?;
        for path in &self.told.changed.kept {
            let path = path.display().to_string();
            eprintln!("note: {} no longer belongs to the scene, but is kept because it was edited", plain::line(&path));
        }
        Ok(())
    }
}

fn name(stage: StageName) -> &'static str {
    match stage {
        StageName::Program => "program",
        StageName::Assets => "assets",
        StageName::Layout => "layout",
        StageName::Export => "export",
    }
}

impl RebuildReport {
    /// What is said to people.
    pub fn human(&self, folder: &Path) -> String {
        let mut out = String::new();
        let stage = |out: &mut String, name: &str, why: &Option<Vec<String>>| {
            if let Some(why) = why {
                let _ = writeln!(out, "{name:<9}{}", verdict(why));
            }
        };
        stage(&mut out, "program", &self.program);
        if let Some((all, again)) = &self.assets {
            let _ = writeln!(out, "assets   {} of {all} rebuilt", again.len());
            for (objects, why) in alike(again) {
                let _ = writeln!(out, "  {}: {why}", named(&objects));
            }
        }
        stage(&mut out, "layout", &self.layout);
        for (format, why) in &self.formats {
            let _ = writeln!(out, "export   {format}: {}", verdict(why));
        }
        let Changed { written, removed, kept } = &self.changed;
        let _ = writeln!(out, "files    {} written, {} removed", written.len(), removed.len());
        for (what, paths) in [("removed", removed), ("kept, because it was edited:", kept)] {
            for path in paths.iter().take(NAMED) {
                let _ = writeln!(out, "  {what} {}", below(path, folder));
            }
        }
        plain::lines(&out).into_owned()
    }

    /// What is said to programs.
    pub fn json(&self, folder: &Path) -> Value {
        let made = |why: &Option<Vec<String>>| why.as_ref().map(|why| json!({ "made": !why.is_empty(), "why": why }));
        let assets = self.assets.as_ref().map(|(all, again)| {
            let objects: serde_json::Map<String, Value> =
                again.iter().map(|(object, why)| (object.clone(), json!(why))).collect();
            json!({ "objects": all, "made": objects })
        });
        let formats: serde_json::Map<String, Value> =
            self.formats.iter().map(|(format, why)| (format.clone(), made(&Some(why.clone())).into())).collect();
        let paths = |paths: &[PathBuf]| paths.iter().map(|path| below(path, folder)).collect::<Vec<_>>();
        json!({
            "program": made(&self.program), "assets": assets, "layout": made(&self.layout), "export": formats,
            "written": paths(&self.changed.written), "removed": paths(&self.changed.removed),
            "kept": paths(&self.changed.kept),
        })
    }
}

/// Objects by why they were made again, in the order in which each reason comes first.
fn alike(again: &[Again]) -> Vec<(Vec<&str>, String)> {
    let mut out: Vec<(Vec<&str>, String)> = Vec::new();
    for (object, why) in again {
        let why = why.join(", ");
        match out.iter_mut().find(|(_, other)| *other == why) {
            Some((objects, _)) => objects.push(object),
            None => out.push((vec![object], why)),
        }
    }
    out
}

fn named(objects: &[&str]) -> String {
    let first = objects.iter().take(NAMED).copied().collect::<Vec<_>>().join(", ");
    match objects.len().saturating_sub(NAMED) {
        0 => first,
        more => format!("{first} and {more} more"),
    }
}

fn verdict(why: &[String]) -> String {
    if why.is_empty() { "kept".to_owned() } else { format!("rebuilt: {}", why.join(", ")) }
}

/// A path as seen from the output folder.
fn below(path: &Path, folder: &Path) -> String {
    let path = path.strip_prefix(folder).unwrap_or(path);
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}
