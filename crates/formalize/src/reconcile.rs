//! The last pass: what cannot hold together with what was said before becomes a preference, by the prover's word.

use crate::draft::{Draft, Statement};
use crate::prefer::{Stated, code};
use crate::write::unformatted;
use scenelang_base::Severity;
use scenelang_lang::program::Program;
use scenelang_lang::{Options, compile_text};
use scenelang_verify::prove::{self, ProveOptions};
use std::path::Path;

/// So many things are looked at as closely as `check` does; with more that takes longer than anybody waits.
const SMALL: usize = 40;
/// How often what does not compile is left out.
const ROUNDS: usize = 12;

/// Reconciles a draft with itself: what contradicts is given up; bounded.
pub fn reconcile(draft: &mut Draft) {
    if reconcile_quickly(draft) {
        confirm(draft);
    }
}

/// The same for what a quick look finds. Whether what is left compiles.
pub fn reconcile_quickly(draft: &mut Draft) -> bool {
    for _ in 0..ROUNDS {
        let text = turned(bare(draft), draft);
        let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
        match &compiled.program {
            Some(program) if !compiled.has_errors() => {
                relax(draft, program, &|rank| prove::relax(program, &ProveOptions::default(), rank));
                return true;
            }
            _ => {
                let errors = compiled.diagnostics.iter().filter(|d| d.severity == Severity::Error);
                let places = errors.filter_map(|d| d.primary.as_ref()).map(|label| label.place.range.bytes().start);
                if !leave_out(draft, &text, places) {
                    return false;
                }
            }
        }
    }
    false
}

/// The quick pass looks less deep than `check` does. What is small is looked at as `check` would.
fn confirm(draft: &mut Draft) {
    if draft.things.iter().map(|t| t.count).sum::<usize>() > SMALL {
        return;
    }
    // What others imply is of no interest here, and to look for it takes longer than all the rest.
    let only = ProveOptions { redundant: false, ..ProveOptions::default() };
    for _ in 0..ROUNDS {
        let compiled = compile_text("room.scene", Path::new("room.scene"), &bare(draft), Options::default());
        let Some(program) = &compiled.program else { return };
        let weakest = |rank: &dyn Fn(usize) -> Option<usize>| {
            let found = prove::prove(program, &only).contradictions;
            let weakest = |c: &prove::Contradiction| c.statements.iter().copied().max_by_key(|s| rank(*s));
            found.iter().filter_map(weakest).collect()
        };
        if !relax(draft, program, &weakest) {
            return;
        }
    }
}

/// The program without the guidelines of the library: they only prefer, and there are very many of them for many things.
fn bare(draft: &mut Draft) -> String {
    let guided = std::mem::take(&mut draft.guided);
    let text = unformatted(draft);
    draft.guided = guided;
    text
}

/// With the rooms along the axes, as they are drawn. The program leaves that open, and whatever contradicts itself with
/// it open does so with it fixed; but the prover has far less to look at.
fn turned(mut text: String, draft: &Draft) -> String {
    for room in draft.rooms.iter().filter(|room| room.outline.is_none()) {
        text.push_str(&format!("\n{}.rot <- rot(0, 0, 0);", room.name));
    }
    text
}

/// Leaves out the statements at these places of the text; whether there was any.
fn leave_out(draft: &mut Draft, text: &str, places: impl Iterator<Item = usize>) -> bool {
    let whole = |place: usize| {
        let at = place.min(text.len());
        let from = text[..at].rfind(';').map_or(0, |i| i + 1);
        let to = text[at..].find(';').map_or(text.len(), |i| at + i + 1);
        text.get(from..to).map(code)
    };
    let lines: Vec<String> = places.filter_map(whole).collect();
    let (bad, good) = std::mem::take(&mut draft.statements).into_iter().partition(|s| {
        let own = code(&s.line());
        lines.iter().any(|l| l.ends_with(&own))
    });
    draft.statements = good;
    let bad: Vec<Statement> = bad;
    for statement in &bad {
        draft.note(&statement.source, "the language has no statement for this");
    }
    !bad.is_empty()
}

/// Says which constraints to give up, by how willingly each is: the higher, the sooner; `None`: never.
type Find<'f> = &'f dyn Fn(&dyn Fn(usize) -> Option<usize>) -> Vec<usize>;

/// Turns one member of each contradiction into a preference. Whether there was any.
fn relax(draft: &mut Draft, program: &Program, find: Find<'_>) -> bool {
    let stated = Stated::new(draft, program);
    let given_up = find(&|constraint| stated.rank(draft, constraint));
    let preferences = given_up.into_iter().filter_map(|c| stated.of(c)).collect();
    draft.prefer(preferences, "contradicts the other statements, so it became a preference")
}
