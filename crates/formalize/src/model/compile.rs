//! Statements held against the compiler: what is wrong with them, in the words and with the places that people see.

use crate::draft::{Draft, Note, Statement, ThingOrigin};
use crate::names::words;
use crate::write::write;
use scenelang_base::Diagnostic;
use scenelang_lang::ast::StmtKind;
use scenelang_lang::parse::parse_statement;
use scenelang_lang::token::lex;
use scenelang_lang::{Compiled, Options, compile_text};
use scenelang_verify::prove::{Findings, ProveOptions, prove};
use scenelang_verify::report::diagnostics;
use std::collections::BTreeSet;
use std::path::Path;

/// The longest statement that is read (bytes).
const LONGEST: usize = 2000;

/// How much of what is wrong the model is shown (bytes).
const SHOWN: usize = 12_000;

/// How often a draft is looked at for contradictions.
const LOOKS: usize = 24;

/// A program with statements behind it, each on its own line.
pub(super) struct TrialProgram {
    compiled: Compiled,
    /// Lines before the first statement.
    base: u32,
    count: usize,
}

impl TrialProgram {
    /// The program of a draft without its statements, and these.
    pub fn new(draft: &Draft, statements: impl IntoIterator<Item = impl AsRef<str>>) -> Self {
        let bare = Draft { statements: Vec::new(), notes: Vec::new(), ..draft.clone() };
        let mut text = write(&bare);
        let base = text.lines().count() as u32;
        let mut count = 0;
        for statement in statements {
            text.push_str(&one_line(statement.as_ref()));
            text.push('\n');
            count += 1;
        }
        Self { compiled: compile_text("room.scene", Path::new("room.scene"), &text, Options::default()), base, count }
    }

    /// Which of the statements something speaks of.
    fn statement_of(&self, span: scenelang_base::Span) -> Option<usize> {
        let line = self.compiled.sources.lines(span).0.line;
        let index = line.checked_sub(self.base + 1)? as usize;
        (span.file == self.compiled.main && index < self.count).then_some(index)
    }

    /// Those that do not compile.
    pub fn broken(&self) -> BTreeSet<usize> {
        let errors = self.compiled.diagnostics.iter().filter(|d| d.is_error());
        errors.filter_map(|d| self.statement_of(d.primary.as_ref()?.place)).collect()
    }

    /// What is wrong with these statements, with line and column.
    pub fn told(&self) -> String {
        let wrong = self.compiled.diagnostics.iter().filter(|d| d.is_error());
        let wrong: Vec<Diagnostic> = wrong.take(20).cloned().collect();
        let text = diagnostics(&wrong, &self.compiled.sources, false);
        text[..text.floor_char_boundary(SHOWN)].to_owned()
    }

    /// What can be proved of it; statements by their number among these, `None`: one of the declarations.
    pub fn proved(&self, redundant: bool) -> Proved {
        let Some(program) = &self.compiled.program else { return Proved::default() };
        let findings: Findings = prove(program, &ProveOptions { redundant, ..ProveOptions::default() });
        let of = |constraint: &usize| self.statement_of(program.constraints[*constraint].span);
        let text = |constraint: &usize| program.constraints[*constraint].text.clone();
        Proved {
            contradictions: findings
                .contradictions
                .iter()
                .map(|found| {
                    (found.statements.iter().filter_map(of).collect(), found.statements.iter().map(text).collect())
                })
                .collect(),
            redundant: findings.redundant.iter().filter_map(|found| of(&found.statement)).collect(),
            always: findings.always.iter().filter_map(of).collect(),
        }
    }
}

/// What can be proved of a trial.
#[derive(Debug, Default)]
pub(super) struct Proved {
    /// Sets that cannot hold together: the statements among them, and the texts of all members.
    pub contradictions: Vec<(Vec<usize>, Vec<String>)>,
    /// Statements that others imply.
    pub redundant: Vec<usize>,
    /// Statements that always hold.
    pub always: Vec<usize>,
}

/// What is wrong with the form of a statement, before it is compiled: it must be one assertion, preference or permission.
pub(super) fn malformed(statement: &str) -> Option<String> {
    let text = one_line(statement);
    if text.len() > LONGEST {
        return Some(format!("it is longer than {LONGEST} bytes"));
    }
    if lex(&text).iter().any(|token| token.kind.is_comment()) {
        return Some("it has a comment".into());
    }
    let (statements, _) = parse_statement(&text);
    match statements.as_slice() {
        [one] if !one.requirements.is_empty() => Some("it contains an `@req`, which only the tool writes".into()),
        [one] => match one.kind {
            StmtKind::Assert { .. } | StmtKind::Prefer { .. } | StmtKind::Allow { .. } | StmtKind::Error => None,
            _ => Some("only `assert`, `prefer` and permissions are allowed here".into()),
        },
        [] => Some("it is empty".into()),
        _ => Some("it contains more than one statement".into()),
    }
}

/// A statement on one line, with its `;`.
pub(super) fn one_line(statement: &str) -> String {
    let line = statement.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.ends_with(';') { line } else { line + ";" }
}

/// Makes sure of what is promised: the program of the draft compiles, and nothing in it is proved to contradict.
pub(super) fn settle(draft: &mut Draft, told: &mut Vec<String>) {
    for _ in 0..LOOKS {
        let trial = TrialProgram::new(draft, draft.statements.iter().map(Statement::line));
        let broken = trial.broken();
        if !broken.is_empty() {
            for at in broken.into_iter().rev() {
                remove(draft, at, "its statement does not compile");
            }
            continue;
        }
        let proved = trial.proved(false);
        let Some((statements, texts)) = proved.contradictions.into_iter().next() else { return };
        if let Some(at) = weakest(&draft.statements, &statements) {
            remove(draft, at, &format!("it contradicts: {}", texts.join("; ")));
            continue;
        }
        // The declarations alone cannot be: what is too large for its room has its usual size.
        let named: Vec<&str> = texts.iter().flat_map(|text| words(text)).collect();
        let large = draft.things.iter_mut().find(|thing| thing.size.is_some() && named.contains(&thing.name.as_str()));
        let Some(thing) = large else {
            told.push(format!("these cannot all hold: {}", texts.join("; ")));
            return;
        };
        thing.size = None;
        told.push(format!(
            "the size of {} is left out, because with it these cannot all hold: {}",
            thing.name,
            texts.join("; ")
        ));
    }
    told.push("there are more contradictions than the search looks for".into());
}

/// Whether the program of a draft compiles.
pub(super) fn compiles(draft: &Draft) -> bool {
    !compile_text("room.scene", Path::new("room.scene"), &write(draft), Options::default()).has_errors()
}

/// Of contradictory statements the one to give up: one that nobody stated, else the last.
pub(super) fn weakest(all: &[Statement], among: &[usize]) -> Option<usize> {
    let inferred = among.iter().rev().find(|at| matches!(all[**at].source, ThingOrigin::Inferred(_)));
    inferred.or(among.last()).copied()
}

/// Takes a statement out. What the request says of it is kept as a note.
pub(super) fn remove(draft: &mut Draft, at: usize, reason: &str) {
    let statement = draft.statements.remove(at);
    if let ThingOrigin::Stated(at) = &statement.source {
        draft.notes.push(Note { at: at.clone(), reason: format!("{} — {reason}", statement.line()) });
    }
}
