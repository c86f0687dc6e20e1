//! Code actions: what `ide` offers, at once; repairs and long edits, listed at once and worked out when they are chosen.

use super::Within;
use crate::change::WorkspaceChange;
use crate::commands::{Hold, REPAIR, Target, command, repair_command};
use crate::dispatch::{Context, Fault, params, sent};
use crate::jobs::{Job, JobOutcome, Shown, Written};
use crate::publish::mark;
use crate::repair::{Wanted, effect, repair};
use crate::state::State;
use scenelang_base::{Edit, TextRange, codes};
use scenelang_ide::actions::{self, Action, ActionKind, Detail};
use scenelang_ide::diagnostics::Finding;
use scenelang_ide::hints::unplaced;
use scenelang_lang::program::ConstraintKind;
use scenelang_solve::repair::told::{PREFER, number_in_words};
use scenelang_solve::repair::{has_numbers, in_statement};
use scenelang_verify::World;
use scenelang_verify::check::Subject;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::sync::Arc;
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::{
    ChangeAnnotation, Command, Diagnostic, LogMessageParams, MessageType, NumberOrString, Range, Uri,
};

/// Parameters of `textDocument/codeAction`.
#[derive(Deserialize)]
pub struct CodeActionRequest {
    #[serde(flatten)]
    within: Within,
    context: Reason,
}

#[derive(Deserialize)]
struct Reason {
    #[serde(default)]
    only: Option<Vec<String>>,
    /// What the client shows there.
    #[serde(default)]
    diagnostics: Vec<Diagnostic>,
}

const QUICK_FIX: &str = "quickfix";
const FIX_ALL: &str = "source.fixAll.scenelang";

/// `CodeAction`, with a change of ours.
#[derive(Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Offered {
    title: String,
    kind: &'static str,
    /// What it repairs.
    #[serde(skip_serializing_if = "Option::is_none")]
    diagnostics: Option<Vec<Diagnostic>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    edit: Option<WorkspaceChange>,
    #[serde(skip_serializing_if = "Option::is_none")]
    command: Option<Command>,
    #[serde(skip_serializing_if = "Option::is_none")]
    is_preferred: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    data: Option<About>,
}

/// What is known of an action besides: how it is worked out, or what it moves.
#[derive(Serialize)]
#[serde(untagged)]
enum About {
    Later(Data),
    /// For a picture of it before it is made.
    Moves(Shown),
}

/// `textDocument/codeAction`
pub fn actions(context: &Context, asked: &CodeActionRequest) -> Result<Vec<Offered>, Fault> {
    let range = context.bytes(asked.within.range);
    let only = asked.context.only.as_deref();
    let wanted = |kind: &str| {
        only.is_none_or(|list| list.iter().any(|o| o.is_empty() || kind == o || kind.starts_with(&format!("{o}."))))
    };
    let detail = if context.client.resolves_edits { Detail::Titles } else { Detail::Edits };
    let offered = actions::actions(&context.snapshot, range, detail)?;
    let (moves, others): (Vec<Action>, Vec<Action>) = offered.into_iter().partition(|a| !a.moves.is_empty());
    let mut out: Vec<Offered> = Vec::new();
    if wanted(QUICK_FIX) {
        for action in &moves {
            // One move may repair several things that are marked here.
            match out.iter_mut().find(|known| known.title == action.title) {
                Some(known) => {
                    let more = action.repairs.iter().map(|finding| marked(context, finding));
                    known.diagnostics.iter_mut().for_each(|all| all.extend(more.clone()));
                }
                None => out.push(shown(context, action, asked.within.range)),
            }
        }
        let contradicted = contradicted(&asked.context.diagnostics, context.uri.as_str());
        for finding in &actions::failing(&context.snapshot, range)? {
            repairs(context, finding, &contradicted, &mut out)?;
        }
    }
    let touched = |place: &TextRange| place.start <= range.end && range.start <= place.end;
    for (_, name) in unplaced(&context.snapshot)?.iter().filter(|(place, _)| wanted(QUICK_FIX) && touched(place)) {
        let title = format!("Place `{name}`");
        let target = Target { object: Some(name.as_str()), ..Target::of(&context.uri) };
        let command = Some(command(title.clone(), "scenelang.place", target)?);
        out.push(Offered { title, kind: QUICK_FIX, command, ..Offered::default() });
    }
    out.extend(others.iter().map(|a| shown(context, a, asked.within.range)).filter(|a| wanted(a.kind)));
    // All at once only where somebody asks for that.
    if only.is_some()
        && wanted(FIX_ALL)
        && let Some(edit) = actions::all_safe(&context.snapshot)?
    {
        let edit = Some(context.places().workspace_edit(&[edit], context.edit_versions()));
        out.push(Offered { title: "Make all safe fixes".to_owned(), kind: FIX_ALL, edit, ..Offered::default() });
    }
    Ok(out)
}

/// An action as the protocol has it, with what finds it again where its edits are to be worked out.
fn shown(context: &Context, action: &Action, range: Range) -> Offered {
    let kind = match action.kind {
        ActionKind::Fix => QUICK_FIX,
        ActionKind::Extract => "refactor.extract",
        ActionKind::Inline => "refactor.inline",
        ActionKind::Rewrite => "refactor.rewrite",
    };
    let mut out = Offered { title: action.title.clone(), kind, ..Offered::default() };
    if action.edits.is_empty() && context.client.resolves_edits {
        let chosen = Chosen { uri: context.uri.clone(), range, title: action.title.clone() };
        out.data = Some(About::Later(Data::Edits(chosen)));
    } else {
        let edit = context.places().workspace_edit(&action.edits, context.edit_versions());
        out.edit = Some(if action.moves.is_empty() { edit } else { to_confirm(context, edit, &action.title) });
    }
    if !action.moves.is_empty() {
        out.data = Some(About::Moves(Shown::new(context.uri.clone(), &action.moves)));
    }
    out.diagnostics = action.repairs.as_ref().map(|finding| vec![marked(context, finding)]);
    out.is_preferred = action.preferred.then_some(true);
    out
}

fn marked(context: &Context, finding: &Finding) -> Diagnostic {
    mark(&finding.diagnostic, context.file(), &context.places(), context.client.related)
}

/// An edit that the client shows before it is made, if it can.
fn to_confirm(context: &Context, mut edit: WorkspaceChange, label: &str) -> WorkspaceChange {
    if context.client.annotates && edit.has_versions() {
        let label = label.to_owned();
        edit.annotate(ChangeAnnotation { label, needs_confirmation: Some(true), description: None });
    }
    edit
}

/// Whether the program can be changed so that a statement holds in the layout as it is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Changeable {
    /// It is no statement, or has no numbers.
    Not,
    /// The number is known, and offered.
    Known,
    /// There are numbers to be looked at.
    Perhaps,
}

/// Changes of the program after which a statement holds in the layout as it is: another number; the assertion as a
/// preference.
fn changes(context: &Context, finding: &Finding) -> Result<(Vec<Offered>, Changeable), Fault> {
    let mut out = Vec::new();
    let (Some(judged), Some(layout)) = (context.snapshot.judged()?, context.snapshot.layout()) else {
        return Ok((out, Changeable::Not));
    };
    let row = finding.row.and_then(|index| judged.verdict.rows.get(index));
    let Some(Subject::Statement(index)) = row.map(|row| row.subject) else { return Ok((out, Changeable::Not)) };
    let (program, sources) = (&judged.compiled.program, context.snapshot.sources());
    let Some(constraint) = program.constraints.get(index) else { return Ok((out, Changeable::Not)) };
    let mut add = |title: String, edit: Edit| {
        let mut written = Shown::new(context.uri.clone(), &[]);
        // What is written elsewhere is shown all the same, and judged when it is made.
        if edit.place.file == context.snapshot.main() {
            let bytes = [edit.place.range.start, edit.place.range.end];
            written.texts.push(Written { bytes, text: edit.text.clone() });
        }
        let edit = context.places().workspace_edit(&[edit], context.edit_versions());
        let edit = Some(to_confirm(context, edit, &title));
        let diagnostics = Some(vec![marked(context, finding)]);
        let data = Some(About::Moves(written));
        out.push(Offered { title, kind: QUICK_FIX, diagnostics, edit, data, ..Offered::default() });
    };
    let world = World::<f64>::new(program, &layout.read.layout, &context.snapshot.judging().options);
    let number = in_statement(program, sources, &world, index).into_iter().next();
    let changeable = match &number {
        Some(_) => Changeable::Known,
        None if has_numbers(program, sources, index) => Changeable::Perhaps,
        None => Changeable::Not,
    };
    if let Some(number) = number {
        let title = number_in_words(program, number.edit.place, &number.shown);
        add(actions::sentence(&title), number.edit);
    }
    if constraint.kind == ConstraintKind::Assert && sources.text(constraint.span).starts_with(ASSERT) {
        let start = constraint.span.range.start as usize;
        let place = TextRange::new(start, start + ASSERT.len()).in_file(constraint.span.file);
        add(actions::sentence(PREFER), Edit { place, text: "prefer".to_owned() });
    }
    Ok((out, changeable))
}

const ASSERT: &str = "assert";

/// Where statements are that are proved to contradict each other: no layout repairs one of them.
fn contradicted(shown: &[Diagnostic], uri: &str) -> Vec<Range> {
    let proved = |mark: &&Diagnostic| matches!(&mark.code, Some(NumberOrString::String(code)) if *code == codes::E0401.as_str() || *code == codes::E0402.as_str());
    let related = |mark: &Diagnostic| -> Vec<Range> {
        let places = mark.related_information.iter().flatten().map(|related| &related.location);
        places.filter(|place| place.uri.as_str() == uri).map(|place| place.range).collect()
    };
    shown.iter().filter(proved).flat_map(|mark| std::iter::once(mark.range).chain(related(mark))).collect()
}

/// Repair of something that fails, by longer searches; then by changes of the program. What leaves the program as it is
/// comes first.
fn repairs(context: &Context, finding: &Finding, contradicted: &[Range], out: &mut Vec<Offered>) -> Result<(), Fault> {
    let Some(label) = &finding.diagnostic.primary else { return Ok(()) };
    let place = context.range(label.place.range);
    let line = place.start.line;
    let is_refuted = contradicted.iter().any(|range| range.start <= place.end && place.start <= range.end);
    let offer = |title: &str| {
        let diagnostics = Some(vec![marked(context, finding)]);
        Offered { title: title.to_owned(), kind: QUICK_FIX, diagnostics, ..Offered::default() }
    };
    let later = |program: bool| Some(About::Later(Data::Repair { uri: context.uri.clone(), line, program }));
    let mut offered = Vec::new();
    if !is_refuted {
        offered.push(if context.client.resolves_edits {
            Offered { data: later(false), ..offer(REPAIR) }
        } else {
            Offered { command: Some(repair_command(&context.uri, line)?), ..offer(REPAIR) }
        });
    }
    let (changes, changeable) = changes(context, finding)?;
    offered.extend(changes);
    if context.client.resolves_edits && changeable == Changeable::Perhaps {
        offered.push(Offered { data: later(true), ..offer(CHANGE) });
    }
    for new in offered {
        if out.iter().all(|known| known.title != new.title) {
            out.push(new);
        }
    }
    Ok(())
}

const CHANGE: &str = "Change the program so that this holds";

/// What is to be worked out.
#[derive(Deserialize, Serialize)]
#[serde(untagged)]
enum Data {
    Repair {
        uri: Uri,
        line: u32,
        program: bool,
    },
    Edits(Chosen),
    /// Which margins it changes is to be said; the client has its edit.
    Effect(Shown),
}

/// What was offered of `ide`'s actions, and where.
#[derive(Deserialize, Serialize)]
struct Chosen {
    uri: Uri,
    range: Range,
    title: String,
}

/// The action with its edits.
fn completed(context: &Context, mut action: Value, chosen: &Chosen) -> Result<Value, Fault> {
    let all = actions::actions(&context.snapshot, context.bytes(chosen.range), Detail::Edits)?;
    let found = all.iter().find(|a| a.title == chosen.title);
    let found = found.ok_or_else(|| Fault::Failed(format!("\"{}\" is no longer possible", chosen.title)))?;
    action["edit"] = sent(context.places().workspace_edit(&found.edits, context.edit_versions()))?;
    Ok(action)
}

impl State {
    /// `codeAction/resolve`: works out a repair, or a long edit. What is offered as a repair has been verified.
    ///
    /// # Errors
    /// It is no action of ours that has to be worked out.
    pub fn resolve_action(&mut self, id: &Id, mut action: Value) -> Result<(), Fault> {
        // Some editors have an action completed that is complete.
        if action.get("edit").is_some_and(Value::is_object) {
            self.reply(id, Ok(action));
            return Ok(());
        }
        let (uri, line, program) = match params(action["data"].clone())? {
            Data::Repair { uri, line, program } => (uri, line, program),
            Data::Edits(chosen) => {
                let uri = chosen.uri.as_str().to_owned();
                self.ask_reader(id, &uri, Arc::new(move |context| completed(context, action.clone(), &chosen)));
                return Ok(());
            }
            Data::Effect(shown) => return self.tell_effect(id, action, shown),
        };
        let shown_in = uri.clone();
        let wanted = if program { Wanted::Program(line) } else { Wanted::Line(line) };
        let finish = Box::new(move |state: &mut State, id: &Id, outcome: JobOutcome| {
            // An action that does nothing when it is chosen looks like one that failed without a word.
            let Some(mut edit) = outcome.edit else { return state.reply(id, Err(Fault::Failed(outcome.message))) };
            edit.ask_first();
            // What it is, and whose idea: until now it was only "repair this".
            let title = actions::sentence(outcome.message.lines().next().unwrap_or_default());
            let margins = outcome.message.clone();
            state.tell("window/logMessage", LogMessageParams { typ: MessageType::INFO, message: outcome.message });
            let completed = sent(edit).and_then(|edit| {
                action["edit"] = edit;
                action["title"] = title.into();
                let margins = margins.lines().skip(1).map(str::to_owned).collect();
                action["data"] = sent(Shown { margins, ..Shown::new(shown_in, &outcome.moves) })?;
                Ok(action)
            });
            state.reply(id, completed);
        });
        self.begin(id, uri.as_str(), "Repairing", None, move |job| repair(job, &wanted, &Hold::default()), finish)
    }

    /// Says of a change that the client holds which margins it would change.
    fn tell_effect(&mut self, id: &Id, mut action: Value, shown: Shown) -> Result<(), Fault> {
        let uri = shown.uri.as_str().to_owned();
        let finish = Box::new(move |state: &mut State, id: &Id, shown: Shown| {
            let completed = sent(shown).map(|shown| {
                action["data"] = shown;
                action
            });
            state.reply(id, completed);
        });
        let work = move |job: &Job| Ok(Shown { margins: effect(job, &shown)?, ..shown });
        self.begin(id, &uri, "Judging the change", None, work, finish)
    }
}
