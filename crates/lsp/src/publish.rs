//! What is marked in a document, as the protocol has it; and the board that remembers who says what about which file, so
//! that nothing stays marked which nobody says any more.

use crate::convert::Places;
use crate::disk::uri_of;
use crate::dispatch::{Context, Fault};
use crate::pages;
use crate::text::Text;
use scenelang_analysis::FileSettings;
use scenelang_base::{Diagnostic, FileId, Label, Severity, TextRange, codes};
use scenelang_ide::Cancelled;
use scenelang_ide::diagnostics::{Finding, diagnostics};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use tower_lsp::ls_types::{
    CodeDescription, Diagnostic as Mark, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag,
    NumberOrString,
};

/// What a program and its layout come to.
#[derive(Clone, Debug, Default)]
pub struct Findings {
    /// What is marked, by the address of the file.
    pub marks: BTreeMap<String, Vec<Mark>>,
    /// How many constraints hold, and how many there are; `None`: there is no layout to judge.
    pub count: Option<[usize; 2]>,
}

/// Works out what is to be marked.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn verdict(context: &Context) -> Result<Findings, Cancelled> {
    let snapshot = &context.snapshot;
    let places = context.places();
    let mut marks: BTreeMap<String, Vec<Mark>> = BTreeMap::new();
    marks.insert(context.uri.as_str().to_owned(), Vec::new());
    if let Some(uri) = snapshot.layout().and_then(|layout| places.uri(layout.file)) {
        marks.insert(uri.as_str().to_owned(), Vec::new());
    }
    // By settings that cannot be used nothing is judged.
    let found = if context.settings.is_broken() { Vec::new() } else { diagnostics(snapshot)? };
    for Finding { diagnostic, .. } in found {
        // What has no place is about the layout: that of a program has its text. What is outside the workspace has no place
        // at all here.
        let layout = snapshot.layout().filter(|_| diagnostic.code != codes::E0009);
        let nowhere = || layout.map_or(snapshot.main(), |layout| layout.file);
        let file = diagnostic.primary.as_ref().map_or_else(nowhere, |label| label.place.file);
        let Some(uri) = places.uri(file) else { continue };
        marks.entry(uri.as_str().to_owned()).or_default().push(mark(
            &diagnostic,
            file,
            &places,
            context.client.related,
        ));
    }
    of_settings(context, &mut marks);
    for list in marks.values_mut() {
        let mut seen = BTreeSet::new();
        list.retain(|mark| seen.insert(serde_json::to_string(mark).ok()));
    }
    let judged = if context.settings.is_broken() { None } else { snapshot.judged()? };
    let count = judged.map(|judged| {
        let rows = &judged.verdict.rows;
        [rows.iter().filter(|row| row.satisfied == Some(true)).count(), rows.len()]
    });
    Ok(Findings { marks, count })
}

/// What is wrong with the settings of the workspace.
fn of_settings(context: &Context, marks: &mut BTreeMap<String, Vec<Mark>>) {
    let FileSettings { file: Some(path), sources, diagnostics, .. } = &*context.settings else { return };
    let Some(uri) = context.open.get(path).cloned().or_else(|| uri_of(path)) else { return };
    let found = marks.entry(uri.as_str().to_owned()).or_default();
    let Some((file, source)) = sources.iter().next() else { return };
    let text = Arc::new(Text::new(source.text().to_owned()));
    let places = Places::new(sources, context.client.encoding, &context.open, (file, text));
    found.extend(diagnostics.iter().map(|d| mark(d, file, &places, context.client.related)));
}

/// What is proved of a program, as marks: contradictions, what follows from other statements, what can never hold. Of a
/// program with errors nothing is.
///
/// # Errors
/// The text has changed.
pub fn proofs(context: Context) -> Result<Vec<Mark>, Fault> {
    let compiled = context.snapshot.compiled()?;
    if !compiled.complete || context.settings.is_broken() {
        return Ok(Vec::new());
    }
    let judging = context.snapshot.judging().clone();
    let Context { snapshot, text, client, open, .. } = context;
    let (sources, main) = (snapshot.into_sources(), Arc::clone(&text));
    // From here on the text may change: what is read is a copy.
    let found = scenelang_analysis::proofs(&compiled.program, &sources.0, &judging);
    let places = Places::new(&sources.0, client.encoding, &open, (sources.1, main));
    let here = |d: &&Diagnostic| d.primary.as_ref().is_some_and(|label| label.place.file == sources.1);
    Ok(found.iter().filter(here).map(|d| mark(d, sources.1, &places, client.related)).collect())
}

/// A finding as the protocol has it.
pub fn mark(diagnostic: &Diagnostic, file: FileId, places: &Places<'_>, related: bool) -> Mark {
    let span = diagnostic.primary.as_ref().map_or(TextRange::empty(0).in_file(file), |label| label.place);
    let mut message = diagnostic.message.clone();
    for note in &diagnostic.notes {
        message.push('\n');
        message.push_str(note);
    }
    let told = |label: &Label| {
        Some(DiagnosticRelatedInformation { location: places.location(label.place)?, message: label.message.clone() })
    };
    let further: Vec<_> = diagnostic.related.iter().filter_map(told).collect();
    Mark {
        range: places.range(span),
        severity: Some(match diagnostic.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
        }),
        code: Some(NumberOrString::String(diagnostic.code.as_str().to_owned())),
        code_description: pages::of_code(diagnostic.code).map(|href| CodeDescription { href }),
        source: Some("scenelang".to_owned()),
        message,
        related_information: (related && !further.is_empty()).then_some(further),
        tags: (diagnostic.code == codes::W0201).then(|| vec![DiagnosticTag::UNNECESSARY]),
        data: None,
    }
}

/// Who says what about which file.
#[derive(Default)]
pub struct Board {
    /// By owner, then by file.
    said: BTreeMap<String, BTreeMap<String, Vec<Mark>>>,
}

impl Board {
    /// Takes over what an owner says. Returns the files about which something else is said than before, with all that is
    /// said of each. Of a file that is itself an owner, only its own word counts.
    pub fn put(&mut self, owner: &str, marks: BTreeMap<String, Vec<Mark>>) -> BTreeMap<String, Vec<Mark>> {
        let before = self.said.insert(owner.to_owned(), marks).unwrap_or_default();
        self.changed(owner, &before)
    }

    /// Forgets an owner.
    pub fn remove(&mut self, owner: &str) -> BTreeMap<String, Vec<Mark>> {
        let before = self.said.remove(owner).unwrap_or_default();
        self.changed(owner, &before)
    }

    fn changed(&self, owner: &str, before: &BTreeMap<String, Vec<Mark>>) -> BTreeMap<String, Vec<Mark>> {
        let now = self.said.get(owner);
        let files: BTreeSet<&String> = before.keys().chain(now.into_iter().flat_map(|m| m.keys())).collect();
        files.into_iter().map(|file| (file.clone(), self.about(file))).collect()
    }

    /// All that is said of a file.
    pub fn about(&self, file: &str) -> Vec<Mark> {
        if let Some(own) = self.said.get(file) {
            return own.get(file).cloned().unwrap_or_default();
        }
        let mut out: Vec<Mark> = Vec::new();
        for mark in self.said.values().filter_map(|marks| marks.get(file)).flatten() {
            if !out.contains(mark) {
                out.push(mark.clone());
            }
        }
        out
    }
}
