//! What is said of the places of objects, as statements of the language. What does not compile goes back to the model
//! with what is wrong with it, as people see it, until all of it compiles.

use super::ask::{Asker, CONSTRAIN, Prompt, Trouble, list, maybe, object};
use super::compile::{TrialProgram, malformed, one_line};
use super::divide::SentenceNumbers;
use super::sentences::Sentences;
use super::{complete, prune};
use crate::draft::{Draft, Note, Statement, ThingOrigin};
use crate::write::write;
use scenelang_llm::{Message, Role, plain};
use serde::Deserialize;
use serde_json::{Value, json};

/// More statements of one region are not read.
const MOST: usize = 300;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ConstrainAnswer {
    constraints: Vec<Constraint>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Constraint {
    statement: String,
    sentence: Option<i64>,
    reason: Option<String>,
}

/// All that is asked of the objects of a region: stated, pruned, completed.
pub(super) fn constrain(
    asker: &mut Asker<'_>,
    sentences: &Sentences,
    part: &SentenceNumbers,
    room: usize,
    draft: &mut Draft,
) -> Result<(), Trouble> {
    let mut own = statements(asker, CONSTRAIN, sentences, part, room, draft, &[])?;
    let pruned = prune::prune(asker, draft, &mut own);
    if pruned.is_ok() && !asker.asking.literal {
        let added = complete::complete(asker, sentences, part, room, draft, &own);
        let added = added.map(|added| own.extend(added));
        prune::by_proof(draft, &mut own);
        draft.statements.append(&mut own);
        return added;
    }
    draft.statements.append(&mut own);
    pruned
}

/// Asks for statements, and sends them back until they compile. `given`: those that stand already.
pub(super) fn statements(
    asker: &mut Asker<'_>,
    prompt: Prompt,
    sentences: &Sentences,
    part: &SentenceNumbers,
    room: usize,
    draft: &mut Draft,
    given: &[Statement],
) -> Result<Vec<Statement>, Trouble> {
    let bare = Draft { statements: given.to_vec(), notes: Vec::new(), request: String::new(), ..draft.clone() };
    let known = json!({
        "region": draft.rooms[room].name,
        "program": write(&bare),
        "sentences": sentences.told(Some(part)),
    });
    let first = Message::new(Role::User, known.to_string());
    let mut said = vec![first];
    let mut rounds = 0;
    loop {
        let mut answer: ConstrainAnswer = match asker.converse(prompt, schema(), said.clone()) {
            Err(Trouble::Answer(error)) if rounds > 0 => {
                // Of the statements that were nearly right nothing is known any more.
                return Err(Trouble::Answer(error));
            }
            other => other?,
        };
        if answer.constraints.len() > MOST {
            asker
                .diagnostics
                .push(format!("{} statements are too many: only the first {MOST} are read", answer.constraints.len()));
            answer.constraints.truncate(MOST);
        }
        let (wrong, report) = judged(draft, given, &answer.constraints);
        if wrong.is_empty() || rounds == asker.asking.compilations {
            return Ok(kept(asker, sentences, draft, &answer.constraints, &wrong));
        }
        rounds += 1;
        said.truncate(1);
        said.push(Message::new(Role::Assistant, plain(&shown(&answer.constraints).to_string(), 20_000)));
        said.push(Message::new(Role::User, format!(
            "These statements do not compile. Return all statements of the region again, with these corrected and the others unchanged.\n\n{report}"
        )));
    }
}

fn schema() -> Value {
    let constraint = object(&json!({
        "statement": { "type": "string" },
        "sentence": maybe("integer"),
        "reason": maybe("string"),
    }));
    object(&json!({ "constraints": list(&constraint) }))
}

fn shown(constraints: &[Constraint]) -> Value {
    let one = |c: &Constraint| json!({ "statement": c.statement, "sentence": c.sentence, "reason": c.reason });
    json!({ "constraints": constraints.iter().map(one).collect::<Vec<_>>() })
}

/// Which constraints cannot stand, each with why; and all of that for the model.
fn judged(draft: &Draft, given: &[Statement], constraints: &[Constraint]) -> (Vec<(usize, String)>, String) {
    let mut wrong = Vec::new();
    let mut report = String::new();
    let mut formed = Vec::new();
    for (at, constraint) in constraints.iter().enumerate() {
        match malformed(&constraint.statement) {
            Some(why) => {
                report.push_str(&format!("Error: `{}`: {why}\n", plain(&constraint.statement, 200)));
                wrong.push((at, why));
            }
            None => formed.push(at),
        }
    }
    let texts = || formed.iter().map(|at| constraints[*at].statement.clone());
    let trial = TrialProgram::new(draft, given.iter().map(Statement::line).chain(texts()));
    let broken: Vec<usize> = trial.broken().into_iter().filter_map(|at| at.checked_sub(given.len())).collect();
    if !broken.is_empty() {
        report.push_str(&trial.told());
    }
    wrong.extend(broken.into_iter().map(|at| (formed[at], "it does not compile".to_owned())));
    (wrong, report)
}

/// The constraints that can stand, as statements; of the others there are notes.
fn kept(
    asker: &mut Asker<'_>,
    sentences: &Sentences,
    draft: &mut Draft,
    constraints: &[Constraint],
    wrong: &[(usize, String)],
) -> Vec<Statement> {
    let mut out = Vec::new();
    for (at, Constraint { statement, sentence, reason }) in constraints.iter().enumerate() {
        let source = sentences.source(*sentence, reason.as_deref());
        let Some((_, why)) = wrong.iter().find(|(wrong, _)| *wrong == at) else {
            out.push(Statement::new(&one_line(statement), source));
            continue;
        };
        asker.diagnostics.push(format!("a statement is left out: `{}`: {why}", plain(statement, 120)));
        if let ThingOrigin::Stated(at) = source {
            draft.notes.push(Note { at, reason: format!("no statement compiled for this: {}", plain(statement, 120)) });
        }
    }
    out
}
