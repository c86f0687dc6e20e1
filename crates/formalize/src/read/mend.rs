//! The last pass: what cannot hold together with what was said before becomes a wish, by the prover's word.

use crate::draft::{Draft, Note, Source};
use crate::write::write;
use scenelang_base::Severity;
use scenelang_lang::program::{ConstraintKind, Program};
use scenelang_lang::{Options, compile_text};
use scenelang_verify::prove::{ProveOptions, WORK, prove};
use std::path::Path;

/// How often the program is looked at again.
const ROUNDS: usize = 12;

/// Mends a draft until nothing contradicts; bounded.
pub fn mend(draft: &mut Draft) {
    for _ in 0..ROUNDS {
        let text = write(draft);
        let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
        let changed = match &compiled.program {
            Some(program) if !compiled.has_errors() => relax(draft, program),
            _ => {
                let lines: Vec<String> = compiled
                    .diagnostics
                    .iter()
                    .filter(|d| d.severity == Severity::Error)
                    .filter_map(|d| d.primary.as_ref())
                    .filter_map(|label| {
                        let at = label.place.range.bytes();
                        let from = text[..at.start.min(text.len())].rfind(';').map_or(0, |i| i + 1);
                        let to = text[at.start.min(text.len())..].find(';').map_or(text.len(), |i| at.start + i + 1);
                        text.get(from..to).map(code)
                    })
                    .collect();
                let before = draft.statements.len();
                let mut gone = Vec::new();
                draft.statements.retain(|s| {
                    let own = code(&s.text);
                    let bad = lines.iter().any(|l| l.ends_with(&own));
                    if bad {
                        gone.push(s.source.clone());
                    }
                    !bad
                });
                for source in gone {
                    note(draft, &source, "what this would be is no statement of the language");
                }
                draft.statements.len() < before
            }
        };
        if !changed {
            return;
        }
    }
}

/// Turns one member of each contradiction into a wish; whether there was any.
fn relax(draft: &mut Draft, program: &Program) -> bool {
    let options = ProveOptions { work: WORK, redundant: false, ..ProveOptions::default() };
    let mut changed = false;
    for found in prove(program, &options).contradictions {
        let members: Vec<String> = found
            .statements
            .iter()
            .filter_map(|c| program.constraints.get(*c))
            .filter(|c| c.kind == ConstraintKind::Assert)
            .map(|c| code(&c.text))
            .collect();
        // What nobody said goes first, then what was said last.
        let order = |i: &usize| match &draft.statements[*i].source {
            Source::Inferred(_) => (1, *i),
            Source::Stated(_) => (0, *i),
        };
        let asserted =
            |text: &str| text.strip_prefix("assert").is_some_and(|t| members.contains(&code(t.trim_end_matches(';'))));
        let weakest = (0..draft.statements.len()).filter(|i| asserted(&draft.statements[*i].text)).max_by_key(order);
        let Some(i) = weakest else { continue };
        let statement = &mut draft.statements[i];
        statement.text = statement.text.replacen("assert", "prefer", 1);
        let source = statement.source.clone();
        note(draft, &source, "cannot hold together with the rest, so it is a wish");
        changed = true;
    }
    changed
}

fn note(draft: &mut Draft, source: &Source, reason: &str) {
    if let Source::Stated(at) = source {
        let note = Note { at: at.clone(), reason: reason.to_owned() };
        if !draft.notes.contains(&note) {
            draft.notes.push(note);
        }
    }
}

/// A statement without blanks.
fn code(text: &str) -> String {
    text.chars().filter(|c| !c.is_whitespace()).collect()
}
