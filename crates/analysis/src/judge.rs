//! The verdict about a file, and what of it is told.

use crate::settings::{FileSettings, Judging};
use scenelang_base::{Diagnostic, SourceMap};
use scenelang_engine::check_file_with;
use scenelang_lang::program::Program;
use scenelang_lang::sources::Loader;
use scenelang_verify::prove::{ProveOptions, prove};
use scenelang_verify::settings::Settings;
use scenelang_verify::{Checked, Detail, Options};
use std::path::Path;

/// What is to be judged, and how much is to be said.
#[derive(Clone, Copy)]
pub struct Question<'a> {
    /// What the file is called in messages.
    pub name: &'a str,
    /// Where it is.
    pub path: &'a Path,
    /// What the command line says in place of the settings.
    pub given: &'a Settings,
    /// How much is said.
    pub detail: Detail,
    /// How programs are compiled.
    pub compile: scenelang_lang::Options,
}

/// Judges a program by itself, or a layout with its program, by the settings that count for it.
pub fn judge(question: &Question<'_>, found: &FileSettings, loader: &dyn Loader) -> Checked {
    judge_as(question, found, |options| {
        check_file_with(question.name, question.path, options, question.compile, loader)
    })
}

impl Question<'_> {
    /// The same of something that is judged in another way.
    pub fn judge_by(&self, found: &FileSettings, check: impl FnOnce(&Options) -> Checked) -> Checked {
        judge_as(self, found, check)
    }
}

fn judge_as(question: &Question<'_>, found: &FileSettings, check: impl FnOnce(&Options) -> Checked) -> Checked {
    if found.is_broken() {
        let (sources, diagnostics) = (found.sources.clone(), found.diagnostics.clone());
        return Checked::refused(question.name, sources, diagnostics, &Options::default());
    }
    let judging = found.judging(question.given);
    let mut checked = check(&Options { detail: question.detail, ..judging.options });
    checked.silence(&judging.allow);
    checked.report.judged_with = judging.with;
    checked
}

/// What is proved of a program that compiles, as far as it is told.
pub fn proofs(program: &Program, sources: &SourceMap, judging: &Judging) -> Vec<Diagnostic> {
    let how = ProveOptions { judging: judging.options, usual: true, ..ProveOptions::default() };
    let mut found = prove(program, &how).diagnostics(program);
    scenelang_lang::lint::allow::silence(sources, &mut found);
    silence(&mut found, judging);
    found
}

/// Leaves out the warnings that the settings silence; errors stay.
pub fn silence(diagnostics: &mut Vec<Diagnostic>, judging: &Judging) {
    diagnostics.retain(|d| d.is_error() || !judging.allow.contains(&d.code));
}
