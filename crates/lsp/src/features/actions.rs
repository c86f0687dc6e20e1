//! Code actions: what `ide` offers, at once; repair, listed at once and worked out when it is chosen.

use super::Within;
use crate::commands::repair_command;
use crate::convert::workspace_edit;
use crate::dispatch::{Context, Fault, params};
use crate::mending::{Wanted, mend};
use crate::publish::mark;
use crate::state::State;
use scenelang_ide::actions::{self, Action, Kind};
use scenelang_ide::diagnostics::Finding;
use serde::Deserialize;
use serde_json::{Value, json};
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::Uri;

/// Parameters of `textDocument/codeAction`.
#[derive(Deserialize)]
pub struct Asked {
    #[serde(flatten)]
    within: Within,
    context: Reason,
}

#[derive(Deserialize)]
struct Reason {
    #[serde(default)]
    only: Option<Vec<String>>,
}

const FIX_ALL: &str = "source.fixAll.scenelang";

/// `textDocument/codeAction`
pub fn actions(context: &Context, asked: &Asked) -> Result<Value, Fault> {
    let range = context.bytes(asked.within.range);
    let only = asked.context.only.as_deref();
    let wanted = |kind: &str| {
        only.is_none_or(|list| list.iter().any(|o| o.is_empty() || kind == o || kind.starts_with(&format!("{o}."))))
    };
    let mut out = Vec::new();
    for finding in actions::failing(&context.snapshot, range)?.iter().filter(|_| wanted("quickfix")) {
        repairs(context, finding, &mut out);
    }
    out.extend(
        actions::actions(&context.snapshot, range)?
            .iter()
            .map(|a| shown(context, a))
            .filter(|a| wanted(a["kind"].as_str().unwrap_or_default())),
    );
    // All at once only where somebody asks for that.
    if only.is_some()
        && wanted(FIX_ALL)
        && let Some(edit) = actions::all_safe(&context.snapshot)?
    {
        let edit = context.places().workspace_edit(&[edit], context.edit_versions());
        out.push(json!({ "title": "Make all safe fixes", "kind": FIX_ALL, "edit": edit }));
    }
    Ok(out.into())
}

fn shown(context: &Context, action: &Action) -> Value {
    let kind = match action.kind {
        Kind::Fix => "quickfix",
        Kind::Extract => "refactor.extract",
        Kind::Inline => "refactor.inline",
        Kind::Rewrite => "refactor.rewrite",
    };
    let edit = context.places().workspace_edit(&action.edits, context.edit_versions());
    let mut out = json!({ "title": action.title, "kind": kind, "edit": edit });
    if let Some(finding) = &action.mends {
        out["diagnostics"] = json!([marked(context, finding)]);
    }
    if action.preferred {
        out["isPreferred"] = true.into();
    }
    out
}

fn marked(context: &Context, finding: &Finding) -> Value {
    mark(&finding.diagnostic, context.file(), &context.places(), context.client.related)
}

/// Repair of something that fails: by moves, and by changes of the program.
fn repairs(context: &Context, finding: &Finding, out: &mut Vec<Value>) {
    let Some(label) = &finding.diagnostic.primary else { return };
    let line = context.range(label.place.range).start.line;
    let marks = json!([marked(context, finding)]);
    let listed = |list: &[Value], title: &str| list.iter().any(|a| a["title"] == title);
    if context.client.resolves_edits {
        for (title, program) in [("Repair this constraint", false), ("Change the program so that this holds", true)] {
            if !listed(out, title) {
                out.push(json!({
                    "title": title, "kind": "quickfix", "diagnostics": marks,
                    "data": { "uri": context.uri, "line": line, "program": program },
                }));
            }
        }
    } else if !listed(out, "Repair this constraint") {
        let command = repair_command(&context.uri, line);
        out.push(json!({
            "title": "Repair this constraint", "kind": "quickfix", "diagnostics": marks, "command": command,
        }));
    }
}

#[derive(Deserialize)]
struct Data {
    uri: Uri,
    line: u32,
    program: bool,
}

impl State {
    /// `codeAction/resolve`: works out a repair. What is offered has been verified.
    ///
    /// # Errors
    /// It is no action of ours that has to be worked out.
    pub fn resolve_action(&mut self, id: &Id, mut action: Value) -> Result<(), Fault> {
        let Data { uri, line, program } = params(action["data"].clone())?;
        let wanted = if program { Wanted::Program(line) } else { Wanted::Line(line) };
        let finish = Box::new(move |state: &mut State, id: &Id, outcome: crate::jobs::Outcome| {
            let nothing = || workspace_edit(std::collections::BTreeMap::new(), None);
            action["edit"] = outcome.edit.unwrap_or_else(nothing);
            state.tell("window/logMessage", json!({ "type": 3, "message": outcome.message }));
            state.reply(id, Ok(action));
        });
        self.begin(id, uri.as_str(), "Repairing", None, move |job| mend(job, &wanted), finish)
    }
}
