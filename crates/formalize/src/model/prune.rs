//! Redundant statements, then contradictory ones: first those that are proved to be, then what the model sees and the
//! prover cannot.

use super::ask::{Asker, CONTRADICTORY, Prompt, REDUNDANT, Trouble, list, object};
use super::compile::{TrialProgram, remove, weakest};
use crate::draft::{Draft, Statement, ThingOrigin};
use scenelang_llm::plain;
use serde::Deserialize;
use serde_json::json;

/// How often statements are looked at for proofs.
const LOOKS: usize = 12;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PruneAnswer {
    remove: Vec<Removal>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Removal {
    /// The statement to take out, from 1.
    number: i64,
    /// The others that imply or contradict it.
    because: Vec<i64>,
    reason: String,
}

/// Both passes over the statements of a region.
pub(super) fn prune(asker: &mut Asker<'_>, draft: &mut Draft, own: &mut Vec<Statement>) -> Result<(), Trouble> {
    by_proof(draft, own);
    for (prompt, times) in [(REDUNDANT, asker.asking.redundancy), (CONTRADICTORY, asker.asking.contradiction)] {
        for _ in 0..times {
            if own.len() < 2 || !by_model(asker, prompt, draft, own)? {
                break;
            }
        }
    }
    Ok(())
}

/// Takes out what is proved to be implied by the rest, and of sets proved contradictory one statement each.
pub(super) fn by_proof(draft: &mut Draft, own: &mut Vec<Statement>) {
    for _ in 0..LOOKS {
        let proved = TrialProgram::new(draft, own.iter().map(Statement::line)).proved(true);
        if let Some((among, texts)) = proved.contradictions.iter().find(|(among, _)| !among.is_empty()) {
            let Some(at) = weakest(own, among) else { return };
            take_out(draft, own, at, &format!("it contradicts: {}", texts.join("; ")), false);
            continue;
        }
        // What implies one may itself be implied: one at a time.
        let Some(at) = proved.always.iter().chain(&proved.redundant).max() else { return };
        take_out(draft, own, *at, "the other statements imply it", true);
    }
}

/// Asks the model once; whether anything was taken out.
fn by_model(
    asker: &mut Asker<'_>,
    prompt: Prompt,
    draft: &mut Draft,
    own: &mut Vec<Statement>,
) -> Result<bool, Trouble> {
    let removal = object(&json!({
        "number": { "type": "integer" },
        "because": list(&json!({ "type": "integer" })),
        "reason": { "type": "string" },
    }));
    let statements: Vec<_> = own
        .iter()
        .zip(1..)
        .map(|(statement, number)| {
            let stated = matches!(statement.source, ThingOrigin::Stated(_));
            json!({ "number": number, "statement": statement.line(), "stated": stated })
        })
        .collect();
    let schema = object(&json!({ "remove": list(&removal) }));
    let answer: PruneAnswer = asker.ask(prompt, schema, &json!({ "statements": statements }))?;
    let index = |number: i64| {
        let index = usize::try_from(number).ok()?.checked_sub(1)?;
        (index < own.len()).then_some(index)
    };
    // A set keeps a member: what another removal rests on stays.
    let mut held = Vec::new();
    let mut gone: Vec<(usize, &str)> = Vec::new();
    for removal in &answer.remove {
        let others: Vec<usize> = removal.because.iter().filter_map(|number| index(*number)).collect();
        let Some(at) = index(removal.number).filter(|at| !held.contains(at) && !others.contains(at)) else { continue };
        let known = gone.iter().any(|(other, _)| *other == at || others.contains(other));
        if others.is_empty() || known {
            continue;
        }
        held.extend(others);
        gone.push((at, &removal.reason));
    }
    gone.sort_by_key(|(at, _)| std::cmp::Reverse(*at));
    for (at, reason) in &gone {
        let why = format!("the model removed it as {}: {}", prompt.step, plain(reason, 120));
        take_out(draft, own, *at, &why, prompt.step == REDUNDANT.step);
    }
    Ok(!gone.is_empty())
}

/// Takes a statement out. A note keeps the words of the request, unless it goes as redundant and another statement
/// carries them.
fn take_out(draft: &mut Draft, own: &mut Vec<Statement>, at: usize, reason: &str, redundant: bool) {
    let carried = own.iter().enumerate().any(|(other, s)| other != at && s.source == own[at].source);
    if redundant && carried {
        own.remove(at);
        return;
    }
    // `remove` speaks of a draft's own statements.
    std::mem::swap(&mut draft.statements, own);
    remove(draft, at, reason);
    std::mem::swap(&mut draft.statements, own);
}
