//! Commands: check, solve, repair. What they do to a layout is an edit that the editor makes, and can undo.

use crate::alternatives::{Alternatives, alternatives};
use crate::dispatch::{Fault, params, sent};
use crate::jobs::{Job, JobOutcome};
use crate::refuted::{Sought, unless_refuted};
use crate::repair::{self, Wanted};
use crate::state::State;
use scenelang_lang::program::{Object, ObjectId};
use scenelang_layout::Layout;
use scenelang_solve::Phase;
use scenelang_synth::{Adviser, Arranged, Arranging, Observer, Stage, arrange, too_large};
use scenelang_verify::CheckVerdict;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use tower_lsp::jsonrpc::Id;
use tower_lsp::ls_types::{Command, Uri};

/// All commands of the server.
pub const ALL: [&str; 8] = [
    "scenelang.check",
    "scenelang.solve",
    "scenelang.solveAnew",
    "scenelang.alternatives",
    "scenelang.place",
    "scenelang.repairAll",
    "scenelang.repair",
    "scenelang.view",
];

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Execute {
    command: String,
    arguments: Option<Vec<Value>>,
    work_done_token: Option<Value>,
}

#[derive(Deserialize)]
struct Argument {
    uri: Uri,
    seed: Option<u64>,
    line: Option<u32>,
    object: Option<String>,
    /// Objects, or arrays of them, that stay where they are.
    #[serde(default)]
    lock: Vec<String>,
    /// Objects, or arrays of them, that alone may move; none: all may.
    #[serde(default)]
    only: Vec<String>,
    /// Whether a repair is answered, to be shown before it is made, instead of made.
    #[serde(default)]
    propose: bool,
}

/// `scenelang/lock`: the objects of a program, or arrays of them, that stay where they are from now on, all of them.
#[derive(Deserialize)]
pub struct Locks {
    pub uri: Uri,
    pub objects: Vec<String>,
}

impl State {
    /// `workspace/executeCommand`
    ///
    /// # Errors
    /// There is no such command, or it is not told what to do.
    pub fn execute(&mut self, id: &Id, given: Value) -> Result<(), Fault> {
        let Execute { command, arguments, work_done_token: token } = params(given)?;
        let first = arguments.unwrap_or_default().into_iter().next().unwrap_or_default();
        if !ALL.contains(&command.as_str()) {
            return Err(Fault::Invalid(format!("there is no command `{command}`")));
        }
        if command == "scenelang.view" {
            return self.view(id, first);
        }
        let Argument { uri: program, seed, line, object, lock, only, propose } = params(first)?;
        let uri = program.as_str();
        let hold = Hold { lock, only };
        let proposes = propose && command.starts_with("scenelang.repair");
        let shown_in = program.clone();
        let apply = Box::new(
            move |state: &mut State, id: &Id, outcome| {
                if proposes { state.propose(id, shown_in, outcome) } else { state.apply(id, outcome) }
            },
        );
        match command.as_str() {
            "scenelang.check" => {
                self.prove_now(uri);
                self.begin(id, uri, "Checking", token, check, apply)
            }
            "scenelang.solve" => {
                self.begin(id, uri, "Solving", token, move |job| solve(job, seed, Start::Layout, &hold), apply)
            }
            "scenelang.solveAnew" => {
                self.begin(id, uri, "Solving anew", token, move |job| solve(job, seed, Start::Nothing, &hold), apply)
            }
            "scenelang.alternatives" => {
                let list = move |job: &Job| alternatives(job, seed.unwrap_or(1), &hold);
                let answer = Box::new(|state: &mut State, id: &Id, found: Alternatives| state.reply(id, sent(found)));
                self.begin(id, uri, "Looking for alternatives", token, list, answer)
            }
            "scenelang.place" => {
                let object =
                    object.ok_or_else(|| Fault::Invalid("the command does not say which object".to_owned()))?;
                self.begin(id, uri, "Placing", token, move |job| place(job, &object), apply)
            }
            "scenelang.repairAll" => {
                let all = move |job: &Job| repair::repair(job, &Wanted::All, &hold);
                self.begin(id, uri, "Repairing", token, all, apply)
            }
            _ => {
                let line = line.ok_or_else(|| Fault::Invalid("the command does not say which line".to_owned()))?;
                let one = move |job: &Job| repair::repair(job, &Wanted::Line(line), &hold);
                self.begin(id, uri, "Repairing", token, one, apply)
            }
        }
    }
}

/// How many constraints hold, of how many.
pub fn count(verdict: &CheckVerdict) -> [usize; 2] {
    [verdict.rows.iter().filter(|row| row.satisfied == Some(true)).count(), verdict.rows.len()]
}

/// Judges the layout as it is.
fn check(job: &Job) -> Result<JobOutcome, Fault> {
    let layout = job.layout.as_ref().filter(|l| l.read.usable);
    let layout = layout.ok_or_else(|| Fault::Failed("there is no layout to check; solve first".to_owned()))?;
    let verdict = job.verdict(&layout.read.layout, 0);
    let count @ [holds, total] = count(&verdict);
    Ok(JobOutcome { layout: None, edit: None, message: format!("{holds} of {total} hold"), count, moves: Vec::new() })
}

/// Where solving begins.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Start {
    /// From the layout that is there: what holds stays, as far as that can be.
    Layout,
    /// Whatever is there.
    Nothing,
}

/// What stays where it is, besides what the user has locked in the editor.
#[derive(Default)]
pub struct Hold {
    lock: Vec<String>,
    only: Vec<String>,
}

impl Hold {
    /// Where a layout that is made anew begins: the places of what stays, if anything does, and which objects these are.
    ///
    /// # Errors
    /// There is no layout, or an object that the program does not have is named.
    pub fn anew(&self, job: &Job) -> Result<(Option<Layout>, Vec<ObjectId>), Fault> {
        let locked = self.objects(job)?;
        let stays = |name: &str| locked.iter().any(|id| job.compiled.program.objects[id.0 as usize].name == name);
        let mut kept = layout_of(job).filter(|_| !locked.is_empty()).cloned();
        if let Some(kept) = &mut kept {
            kept.objects.retain(|(name, _)| stays(name));
        }
        Ok((kept, locked))
    }

    /// The objects that stay.
    ///
    /// # Errors
    /// As [`Self::anew`].
    pub fn objects(&self, job: &Job) -> Result<Vec<ObjectId>, Fault> {
        let program = &job.compiled.program;
        let layout = match layout_of(job) {
            Some(layout) => layout,
            // What has no place yet cannot stay there.
            None if self.lock.is_empty() && self.only.is_empty() => return Ok(Vec::new()),
            None => {
                let why = "there is no layout whose objects could be kept in place; solve first";
                return Err(Fault::Failed(why.to_owned()));
            }
        };
        let known = |name: &String| program.objects.iter().any(|o| o.is_meant_by(name));
        if let Some(name) = self.lock.iter().chain(&self.only).find(|name| !known(name)) {
            return Err(Fault::Failed(format!("the program has no `{name}`")));
        }
        let objects = (0..).map(ObjectId).zip(&program.objects);
        let stays = |id: ObjectId, o: &Object| {
            let any = |names: &[String]| names.iter().any(|name| o.is_meant_by(name));
            job.locked.contains(&id) || any(&self.lock) || !self.only.is_empty() && !any(&self.only)
        };
        Ok(objects.filter(|(id, o)| stays(*id, o) && layout.object(&o.name).is_some()).map(|(id, _)| id).collect())
    }
}

/// The layout that a job is about, if it can be used.
fn layout_of(job: &Job) -> Option<&Layout> {
    job.layout.as_ref().filter(|l| l.read.usable).map(|l| &l.read.layout)
}

/// Looks for a layout. Without a seed, that of the layout that is there counts; whoever wants another room gets that of the
/// next seed.
fn solve(job: &Job, seed: Option<u64>, start: Start, hold: &Hold) -> Result<JobOutcome, Fault> {
    if let Some(finding) = too_large(&job.compiled.program) {
        return Err(Fault::Failed(finding.message));
    }
    // The room that is shown without a layout is the one that is written.
    let there = layout_of(job).or(job.provisional.as_deref().filter(|_| job.layout.is_none()));
    let last = there.and_then(|layout| layout.seed).unwrap_or(0);
    let again = if there.is_some() { last.wrapping_add(1) } else { 0 };
    let seed = seed.unwrap_or(if start == Start::Layout { last } else { again });
    // As with a repair: who has no key gets what can be had without.
    let (mut model, without) = match job.advisers.model(&job.llm, &job.progress) {
        Ok(model) => (model, String::new()),
        Err(error) => {
            let without = format!("the language model cannot be asked: {error}");
            job.progress.log(&without);
            (None, format!("; {without}"))
        }
    };
    let adviser = model.as_mut().map(|(model, asking)| Adviser { model, asking: *asking });
    let (kept, locked) = match start {
        Start::Layout => (there.cloned(), hold.objects(job)?),
        Start::Nothing => hold.anew(job)?,
    };
    let how = Arranging { previous: kept.as_ref(), locked, seed, judge: job.judging.options, ..Arranging::default() };
    let mut layout = arranged(job, how, adviser)?.outcome.layout;
    layout.seed = Some(seed);
    let count @ [holds, total] = count(&job.verdict(&layout, 0));
    let edit = job.layout_edit(&layout)?;
    let change = job.change(Some(&edit), &[], "");
    let same = if change.is_none() && edit.old.is_some() { ", with everything where it was" } else { "" };
    let message = format!("solved: {holds} of {total} hold{same}{without}");
    Ok(JobOutcome { layout: Some(edit), edit: change, message, count, moves: Vec::new() })
}

/// Finds a place for an object, or for the elements of an array, that the layout does not have yet; all others stay where
/// they are.
fn place(job: &Job, object: &str) -> Result<JobOutcome, Fault> {
    let program = &job.compiled.program;
    if let Some(finding) = too_large(program) {
        return Err(Fault::Failed(finding.message));
    }
    let layout = layout_of(job);
    let layout = layout.ok_or_else(|| Fault::Failed("there is no layout to place it in; solve first".to_owned()))?;
    let own = |o: &Object| o.is_meant_by(object);
    let (mut known, mut placed) = (false, layout.clone());
    for object in program.objects.iter().filter(|o| own(o)) {
        known = true;
        placed.objects.retain(|(name, _)| *name != object.name);
    }
    if !known {
        return Err(Fault::Failed(format!("the program has no `{object}`")));
    }
    let objects = (0..).map(ObjectId).zip(&program.objects);
    let locked = objects.filter(|(_, o)| placed.object(&o.name).is_some()).map(|(id, _)| id).collect();
    let seed = layout.seed.unwrap_or(0);
    let how = Arranging { previous: Some(&placed), locked, seed, judge: job.judging.options, ..Arranging::default() };
    let mut after = layout.clone();
    let found = arranged(job, how, None)?.outcome.layout;
    for (name, found) in found.objects {
        if program.objects.iter().any(|o| own(o) && o.name == name) {
            after.objects.retain(|(there, _)| *there != name);
            after.objects.push((name, found));
        }
    }
    after.draws.extend(found.draws.into_iter().filter(|(key, _)| layout.draws.iter().all(|(known, _)| known != key)));
    let known = |name: &str| layout.variables.iter().any(|(known, _)| known == name);
    after.variables.extend(found.variables.into_iter().filter(|(name, _)| !known(name)));
    let count @ [holds, total] = count(&job.verdict(&after, 0));
    let edit = job.layout_edit(&after)?;
    let message = format!("placed `{object}`: {holds} of {total} hold");
    let change = job.change(Some(&edit), &[], &message);
    Ok(JobOutcome { layout: Some(edit), edit: change, message, count, moves: Vec::new() })
}

/// A layout of the program, unless it is proved that there is none.
///
/// # Errors
/// No layout satisfies the program, or nobody waits any more.
fn arranged(job: &Job, how: Arranging<'_>, adviser: Option<Adviser<'_>>) -> Result<Arranged, Fault> {
    unless_refuted(job, how.previous, |stop| {
        let how = Arranging { stop: stop.clone(), ..how };
        let found = arrange(&job.compiled.program, how, adviser, &mut Watch(job)).ok_or(Fault::Cancelled);
        let converged = found.as_ref().is_ok_and(|found| found.outcome.converged);
        Sought { result: found, converged }
    })
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

/// What the repair of one constraint is called.
pub const REPAIR: &str = "Repair this constraint";

/// The command that repairs the constraint in a line, for clients that cannot complete an action.
pub fn repair_command(uri: &Uri, line: u32) -> Result<Command, Fault> {
    command(REPAIR.to_owned(), "scenelang.repair", Target { line: Some(line), ..Target::of(uri) })
}

/// A command as an action or a lens has it.
///
/// # Errors
/// A mistake of ours.
pub fn command(title: String, name: &str, target: Target<'_>) -> Result<Command, Fault> {
    Ok(Command { title, command: name.to_owned(), arguments: Some(vec![sent(target)?]) })
}

/// What a command of an action or a lens is about: what [`Argument`] reads of it.
#[derive(Serialize)]
pub struct Target<'a> {
    pub uri: &'a Uri,
    /// Of a statement; lines from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub object: Option<&'a str>,
}

impl<'a> Target<'a> {
    /// A program.
    pub fn of(uri: &'a Uri) -> Self {
        Self { uri, line: None, object: None }
    }
}
