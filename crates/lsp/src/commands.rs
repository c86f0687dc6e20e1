//! Commands: check, solve, repair. What they do to a layout is an edit that the editor makes, and can undo.

use crate::dispatch::{Fault, params};
use crate::jobs::{Job, Outcome};
use crate::repair::{self, Wanted};
use crate::state::State;
use scenelang_solve::Phase;
use scenelang_synth::{Adviser, Arranging, Observer, Stage, arrange, too_large};
use scenelang_verify::Verdict;
use serde::Deserialize;
use serde_json::{Value, json};
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::Uri;

/// All commands of the server.
pub const ALL: [&str; 4] = ["scenelang.check", "scenelang.solve", "scenelang.repairAll", "scenelang.repair"];

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Execute {
    command: String,
    #[serde(default)]
    arguments: Vec<Value>,
    work_done_token: Option<Value>,
}

#[derive(Deserialize)]
struct Argument {
    uri: Uri,
    #[serde(default)]
    seed: u64,
    line: Option<u32>,
}

impl State {
    /// `workspace/executeCommand`
    ///
    /// # Errors
    /// There is no such command, or it is not told what to do.
    pub fn execute(&mut self, id: &Id, given: Value) -> Result<(), Fault> {
        let Execute { command, mut arguments, work_done_token: token } = params(given)?;
        let first = if arguments.is_empty() { Value::Null } else { arguments.swap_remove(0) };
        if !ALL.contains(&command.as_str()) {
            return Err(Fault::Invalid(format!("there is no command `{command}`")));
        }
        let Argument { uri, seed, line } = params(first)?;
        let uri = uri.as_str();
        let apply = Box::new(|state: &mut State, id: &Id, outcome| state.apply(id, outcome));
        match command.as_str() {
            "scenelang.check" => {
                self.prove_now(uri);
                self.begin(id, uri, "Checking", token, check, apply)
            }
            "scenelang.solve" => self.begin(id, uri, "Solving", token, move |job| solve(job, seed), apply),
            "scenelang.repairAll" => {
                let all = |job: &Job| repair::repair(job, &Wanted::All);
                self.begin(id, uri, "Repairing", token, all, apply)
            }
            _ => {
                let line = line.ok_or_else(|| Fault::Invalid("which line is not said".to_owned()))?;
                let one = move |job: &Job| repair::repair(job, &Wanted::Line(line));
                self.begin(id, uri, "Repairing", token, one, apply)
            }
        }
    }
}

/// How many constraints hold, of how many.
pub fn count(verdict: &Verdict) -> [usize; 2] {
    [verdict.rows.iter().filter(|row| row.satisfied == Some(true)).count(), verdict.rows.len()]
}

/// Judges the layout as it is.
fn check(job: &Job) -> Result<Outcome, Fault> {
    let layout = job.layout.as_ref().filter(|l| l.read.usable);
    let layout = layout.ok_or_else(|| Fault::Failed("there is no layout to check; solve first".to_owned()))?;
    let verdict = job.verdict(&layout.read.layout, 0);
    let count @ [holds, total] = count(&verdict);
    Ok(Outcome { layout: None, edit: None, message: format!("{holds} of {total} hold"), count })
}

/// Looks for a layout from the start.
fn solve(job: &Job, seed: u64) -> Result<Outcome, Fault> {
    let how = Arranging { seed, judge: job.judging.options, stop: job.stop.clone(), ..Arranging::default() };
    let mut model = job.advisers.model(&job.llm, &job.progress).map_err(|e| Fault::Failed(e.to_string()))?;
    let adviser = model.as_mut().map(|(model, asking)| Adviser { model, asking: *asking });
    if let Some(finding) = too_large(&job.compiled.program) {
        return Err(Fault::Failed(finding.message));
    }
    let arranged = arrange(&job.compiled.program, how, adviser, &mut Watch(job)).ok_or(Fault::Cancelled)?;
    let mut layout = arranged.outcome.layout;
    layout.seed = Some(seed);
    let count @ [holds, total] = count(&job.verdict(&layout, 0));
    let edit = job.layout_edit(&layout)?;
    let message = format!("solved: {holds} of {total} hold");
    let change = job.change(Some(&edit), &[], "");
    Ok(Outcome { layout: Some(edit), edit: Some(change), message, count })
}

/// Tells how far the solver is, and ends it when nobody wants the result.
pub struct Watch<'a>(pub &'a Job);

impl Observer for Watch<'_> {
    fn enter(&mut self, stage: Stage) {
        self.0.progress.say(stage.name());
    }
    fn leave(&mut self, _: Stage) {}
    fn solving(&mut self, p: &scenelang_solve::Progress) {
        let phase = match p.phase {
            Phase::InitialPlacement => "placing",
            Phase::PhysicsRelaxation => "relaxing",
            Phase::Repair => "repairing",
        };
        self.0.progress.say(&format!("{phase}: {} of {} terms hold", p.held, p.total));
    }
}

/// The command that repairs the constraint in a line, for clients that cannot complete an action.
pub fn repair_command(uri: &Uri, line: u32) -> Value {
    json!({
        "title": "Repair this constraint", "command": "scenelang.repair",
        "arguments": [{ "uri": uri, "line": line }],
    })
}
