//! A room for a program that has no layout yet: found in the background, shown, and kept in memory until it is written.

use crate::commands::{Watch, count};
use crate::dispatch::{Fault, params, sent};
use crate::jobs::Job;
use crate::picture::{Picture, Shown};
use crate::refuted::{Sought, unless_refuted};
use crate::state::{State, Stop};
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, file as layout_file};
use scenelang_synth::{Arranging, arrange, too_large};
use scenelang_verify::CheckVerdict;
use serde::Deserialize;
use serde_json::Value;
use std::sync::Arc;
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::Uri;

#[derive(Deserialize)]
struct Asked {
    uri: Uri,
    /// The shape that the client has.
    known: Option<String>,
}

impl State {
    /// `scenelang/provisional`
    ///
    /// # Errors
    /// There is no such program, or it has errors.
    pub fn provisional(&mut self, id: &Id, given: Value) -> Result<(), Fault> {
        let Asked { uri, known } = params(given)?;
        let key = uri.as_str().to_owned();
        let finish = Box::new(move |state: &mut State, id: &Id, (layout, shown): (Layout, Shown)| {
            state.rooms.insert(key, Arc::new(layout));
            state.reply(id, sent(shown));
        });
        self.begin(id, uri.as_str(), "Finding a room", None, move |job| room(job, known.as_deref()), finish)
    }
}

/// A layout of the program, and how it is shown. What the last one has stays where it was, if all holds so.
fn room(job: &Job, known: Option<&str>) -> Result<(Layout, Shown), Fault> {
    let program = &job.compiled.program;
    if let Some(path) = job.layout.as_ref().and(job.layout_path.as_ref()) {
        return Err(Fault::Failed(format!("the program has a layout: {}", path.display())));
    }
    if let Some(finding) = too_large(program) {
        return Err(Fault::Failed(finding.message));
    }
    let before = job.provisional.as_deref();
    let there = before.map_or_else(Vec::new, |before| {
        let objects = (0..).map(ObjectId).zip(&program.objects);
        objects.filter(|(_, o)| before.object(&o.name).is_some()).map(|(id, _)| id).collect()
    });
    let find = |locked: Vec<ObjectId>, stop: &Stop| {
        let how = Arranging {
            previous: before,
            locked,
            judge: job.judging.options,
            stop: stop.clone(),
            ..Arranging::default()
        };
        let arranged = arrange(program, how, None, &mut Watch(job)).ok_or(Fault::Cancelled)?;
        let verdict = job.verdict(&arranged.outcome.layout, 0);
        Ok::<_, Fault>((arranged.outcome.layout, verdict, arranged.outcome.converged))
    };
    let (layout, verdict) = unless_refuted(job, before, |stop| {
        let all_hold = |verdict: &CheckVerdict| count(verdict)[0] == count(verdict)[1];
        let found = match find(there, stop) {
            Ok((_, verdict, _)) if before.is_some() && !all_hold(&verdict) => find(Vec::new(), stop),
            found => found,
        };
        let converged = found.as_ref().is_ok_and(|(.., converged)| *converged);
        Sought { result: found.map(|(layout, verdict, _)| (layout, verdict)), converged }
    })?;
    let picture = Picture {
        path: &job.path,
        program,
        sources: &job.sources,
        about: job.main,
        layout_file: None,
        layout: &layout,
        text: &layout_file::to_json(&layout, None),
        verdict: &verdict,
        options: &job.judging.options,
        looks: &job.looks,
    };
    let shown = picture.shown(&job.places(), known)?;
    Ok((layout, shown))
}
