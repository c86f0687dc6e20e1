//! Repair: what a change of the layout or the program would repair, verified before it is offered, with what it moves and
//! which margins it changes.

use crate::advised::advised;
use crate::commands::{Hold, count};
use crate::dispatch::Fault;
use crate::jobs::{Job, JobOutcome, Moved, Shown, Written};
use crate::refuted::refusal;
use scenelang_base::{Edit, SourceFile, SourceMap, TextRange};
use scenelang_ide::actions::Ghost;
use scenelang_ide::diagnostics::margin;
use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, Placement};
use scenelang_solve::Pose;
use scenelang_solve::repair::told::title;
use scenelang_solve::repair::{
    Alternative, Damaged, How, Moved as Carried, RepairOptions, Text, Unjudged, Which, by_numbers, repair as look,
};
use scenelang_verify::CheckVerdict;
use scenelang_verify::check::{Judged, Subject};
use scenelang_verify::explain::RowRef;
use scenelang_verify::report::model::RowKind;

/// What is to be repaired.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// Whatever must hold and does not.
    All,
    /// What is stated in a line of the document, or asked of what is declared there; lines from 0.
    Line(u32),
    /// The same, by numbers of the program instead of moves.
    Program(u32),
}

/// Budgets of work, small ones first, so that a change of mind is noticed between them.
const BUDGETS: [u64; 3] = [20_000_000, 60_000_000, 200_000_000];

/// Looks for the best way, with a language model first if there is one. What is held is not moved.
///
/// # Errors
/// There is nothing to repair, or no way was found.
pub fn repair(job: &Job, wanted: &Wanted, hold: &Hold) -> Result<JobOutcome, Fault> {
    if let Some(finding) = scenelang_synth::too_large(&job.compiled.program) {
        return Err(Fault::Failed(finding.message));
    }
    let layout = job.layout.as_ref().filter(|l| l.read.usable);
    let layout =
        &layout.ok_or_else(|| Fault::Failed("there is no layout to repair; solve first".to_owned()))?.read.layout;
    let before = job.verdict(layout, 0);
    let which = which(job, wanted, &before)?;
    let targets: Vec<RowRef> = before.rows.iter().map(row_of).filter(|row| is_target(&which, row, &before)).collect();
    if targets.is_empty() {
        return Ok(JobOutcome {
            layout: None,
            edit: None,
            message: "nothing to repair".to_owned(),
            count: count(&before),
            moves: Vec::new(),
        });
    }
    let locked = hold.objects(job)?;
    let text = Text {
        name: job.sources.get(job.main).name(),
        path: job.sources.get(job.main).path(),
        compile: scenelang_lang::Options::default(),
        loader: &job.files,
        sources: &job.sources,
    };
    let damaged = Damaged { program: &job.compiled.program, layout, text: Some(text) };
    if matches!(wanted, Wanted::Program(_)) {
        return changed(job, &damaged, (&which, &before));
    }
    let asked = by_model(job, layout, &before, &targets)?;
    let obeys = |found: &Alternative| !found.moves.iter().any(|moved| locked.contains(&moved.object));
    if let Some(found) = asked.filter(obeys) {
        return offer(job, layout, &before, &found, PROPOSED);
    }
    for (round, budget) in BUDGETS.into_iter().enumerate() {
        if job.stop.is_set() {
            return Err(Fault::Cancelled);
        }
        job.progress.say(&format!("looking for the smallest change, round {}", round + 1));
        let (judge, stop) = (job.judging.options, job.stop.clone());
        let options = RepairOptions { budget, judge, stop, locked: locked.clone(), ..RepairOptions::default() };
        let found = look(&damaged, &which, &options).map_err(unjudged)?;
        // An assertion is weakened only by an action that says so.
        if let Some(chosen) = found.alternatives.iter().find(|a| a.how == How::Moves) {
            return offer(job, layout, &before, chosen, "");
        }
        if let Some(contradiction) = found.contradiction {
            return Err(Fault::Failed(refusal(job, &contradiction)));
        }
    }
    Err(Fault::Failed(if locked.is_empty() {
        "no move was found that repairs it, which is not a proof that none exists; the program can be changed instead"
            .to_owned()
    } else {
        let names = locked.iter().map(|id| format!("`{}`", job.compiled.program.objects[id.0 as usize].name));
        let names = names.collect::<Vec<_>>().join(", ");
        format!("no move was found that repairs it and leaves what is locked in place: {names}")
    }))
}

fn unjudged(_: Unjudged) -> Fault {
    Fault::Failed("the layout cannot be checked completely; its diagnostics say why".to_owned())
}

/// The smallest change of a number in the program after which some rows hold. Nothing is searched for that.
fn changed(job: &Job, damaged: &Damaged<'_>, (which, before): (&Which, &CheckVerdict)) -> Result<JobOutcome, Fault> {
    let (judge, stop) = (job.judging.options, job.stop.clone());
    let options = RepairOptions { judge, stop, ..RepairOptions::default() };
    let found = by_numbers(damaged, which, &options).map_err(unjudged)?;
    match (found.alternatives.first(), found.contradiction) {
        (Some(chosen), _) => offer(job, damaged.layout, before, chosen, ""),
        (None, Some(contradiction)) => Err(Fault::Failed(refusal(job, &contradiction))),
        (None, None) => Err(Fault::Failed("no number was found whose change would repair it".to_owned())),
    }
}

fn row_of(row: &Judged) -> RowRef {
    RowRef { kind: row.kind, subject: row.subject }
}

/// The rows that are meant.
fn which(job: &Job, wanted: &Wanted, before: &CheckVerdict) -> Result<Which, Fault> {
    let (Wanted::Line(line) | Wanted::Program(line)) = wanted else { return Ok(Which::All) };
    let places = job.places();
    let meant = |row: &&Judged| {
        let on_line = |span| {
            let range = places.range(span);
            range.start.line <= *line && *line <= range.end.line
        };
        let own = |id: &ObjectId| job.compiled.program.objects.get(id.0 as usize).is_some_and(|o| on_line(o.span));
        let here = row.place.file == job.main;
        match row.subject {
            Subject::Statement(_) => here && on_line(row.place),
            // No number of the program changes a physical rule.
            _ if matches!(wanted, Wanted::Program(_)) => false,
            Subject::Pair(a, b) => own(&a) || own(&b),
            Subject::Object(a) | Subject::Part(a, _) => own(&a),
        }
    };
    let rows: Vec<RowRef> = before.rows.iter().filter(meant).map(row_of).collect();
    if rows.is_empty() {
        Err(Fault::Failed("there is no constraint on this line".to_owned()))
    } else {
        Ok(Which::Rows(rows))
    }
}

fn is_target(which: &Which, row: &RowRef, before: &CheckVerdict) -> bool {
    let fails = before.rows.iter().any(|r| row_of(r) == *row && r.satisfied == Some(false));
    fails
        && match which {
            Which::All => row.kind != RowKind::Prefer,
            Which::Rows(rows) => rows.contains(row),
        }
}

/// What a language model makes of the layout, if that repairs what is to be repaired and breaks nothing.
fn by_model(
    job: &Job,
    layout: &Layout,
    before: &CheckVerdict,
    targets: &[RowRef],
) -> Result<Option<Alternative>, Fault> {
    let Some(after) = advised(job, layout, targets)? else { return Ok(None) };
    let program = &job.compiled.program;
    let verdict = job.verdict(&after, 0);
    let holds = |row: &RowRef, v: &CheckVerdict| {
        v.rows.iter().find(|r| row_of(r) == *row).is_none_or(|r| r.satisfied == Some(true))
    };
    let repairs = targets.iter().all(|row| holds(row, &verdict));
    let keeps = before.rows.iter().filter(|r| r.satisfied == Some(true)).all(|r| holds(&row_of(r), &verdict));
    // A physical rule is listed only where it fails.
    let was = |r: &Judged| before.rows.iter().any(|b| row_of(b) == row_of(r));
    let breaks = verdict.rows.iter().any(|r| r.satisfied == Some(false) && !was(r));
    if !repairs || !keeps || breaks {
        return Ok(None);
    }
    let moves = moved(program, layout, &after);
    Ok((!moves.is_empty()).then(|| Alternative {
        how: How::Moves,
        moves,
        also: Vec::new(),
        edits: Vec::new(),
        least: Vec::new(),
        shown: Vec::new(),
        drops: Vec::new(),
        layout: after,
        cost: 0.0,
    }))
}

/// What stands elsewhere in another layout.
fn moved(program: &Program, from: &Layout, to: &Layout) -> Vec<Carried> {
    let pose = |p: &Placement| Pose { pos: p.pos, rot: p.rot, scale: p.scale };
    let objects = program.objects.iter().enumerate();
    let differs = objects.filter_map(|(id, object)| {
        let (a, b) = (from.object(&object.name)?, to.object(&object.name)?);
        let far = (a.pos - b.pos).amax().max((a.rot - b.rot).amax()) > 1e-6;
        far.then(|| Carried { object: ObjectId(id as u32), from: pose(a), to: pose(b), with: None })
    });
    differs.collect()
}

/// What is said before a move that a language model has proposed.
const PROPOSED: &str = "proposed by the language model: ";

/// A change, judged once more as it will be, with words about it.
fn offer(
    job: &Job,
    layout: &Layout,
    before: &CheckVerdict,
    chosen: &Alternative,
    by: &str,
) -> Result<JobOutcome, Fault> {
    let after = verified(job, &chosen.edits, &chosen.layout)?;
    let changes_layout = !chosen.moves.is_empty() || !chosen.also.is_empty() || *layout != chosen.layout;
    let edit = if changes_layout { Some(job.layout_edit(&chosen.layout)?) } else { None };
    let message = format!("{by}{}", title(&job.compiled.program, &job.sources, chosen));
    let margins = margins(&job.compiled.program, before, &after);
    let note = if margins.is_empty() { message } else { format!("{message}\n{}", margins.join("\n")) };
    let change = job.change(edit.as_ref(), &chosen.edits, &note);
    let ghost = |m: &Carried| {
        let object = job.compiled.program.objects[m.object.0 as usize].name.to_string();
        Ghost { object, pos: m.to.pos, rot: m.to.rot }
    };
    let moves = chosen.moves.iter().map(ghost).collect();
    Ok(JobOutcome { layout: edit, edit: change, message: note, count: count(&after), moves })
}

/// Which margins a change would change that was only shown.
///
/// # Errors
/// There is no layout, or it would no longer be one that can be judged.
pub fn effect(job: &Job, shown: &Shown) -> Result<Vec<String>, Fault> {
    let layout = job.layout.as_ref().filter(|l| l.read.usable);
    let before = &layout.ok_or_else(|| Fault::Failed("there is no layout".to_owned()))?.read.layout;
    let mut after = before.clone();
    for Moved { object, pos, rot } in &shown.moves {
        if let Some((_, placed)) = after.objects.iter_mut().find(|(name, _)| name == object.as_str()) {
            (placed.pos, placed.rot) = ((*pos).into(), (*rot).into());
        }
    }
    let edits = shown.texts.iter().map(|Written { bytes: [start, end], text }| {
        let place = TextRange { start: *start, end: *end }.in_file(job.main);
        Edit { place, text: text.clone() }
    });
    let edits: Vec<Edit> = edits.collect();
    let verdict = verified(job, &edits, &after)?;
    Ok(margins(&job.compiled.program, &job.verdict(before, 0), &verdict))
}

/// What holds after a change of layout and program.
fn verified(job: &Job, edits: &[Edit], layout: &Layout) -> Result<CheckVerdict, Fault> {
    if edits.is_empty() {
        return Ok(job.verdict(layout, 0));
    }
    let overlap = || Fault::Failed("the edits overlap".to_owned());
    let texts = scenelang_solve::repair::edited(&job.sources, edits).ok_or_else(overlap)?;
    let main = job.sources.get(job.main);
    let text = texts.iter().find(|(id, _)| **id == job.main).map_or(main.text(), |(_, text)| text.as_str());
    let mut sources = SourceMap::new();
    let id = sources.add(SourceFile::new(main.name(), main.path(), text));
    let compiled = scenelang_lang::compile_main(id, scenelang_lang::Options::default(), &job.files, sources);
    let broken = || Fault::Failed("the program would no longer compile".to_owned());
    Ok(scenelang_verify::check(&compiled.program.ok_or_else(broken)?, layout, &job.judging.options))
}

/// Which margins a change changes, the first few: `text: −0.07 m → +0.00 m`.
fn margins(program: &Program, before: &CheckVerdict, after: &CheckVerdict) -> Vec<String> {
    const MOST: usize = 6;
    const SEEN: f64 = 0.005;
    let said = |row: &Judged| {
        margin(row).unwrap_or_else(|| if row.satisfied == Some(true) { "holds" } else { "fails" }.to_owned())
    };
    let changed = before.rows.iter().filter_map(|row| {
        let now = after.rows.iter().find(|other| row_of(other) == row_of(row));
        let text = row.text.split_whitespace().collect::<Vec<_>>().join(" ");
        let Some(now) = now else {
            return row.kind.rule().map(|rule| format!("{rule} of {}: holds", names(program, row)));
        };
        let moved = row.margin.zip(now.margin).is_some_and(|((a, _), (b, _))| (a - b).abs() > SEEN);
        (moved || row.satisfied != now.satisfied).then(|| format!("{text}: {} → {}", said(row), said(now)))
    });
    changed.take(MOST).collect()
}

fn names(program: &Program, row: &Judged) -> String {
    let names: Vec<&str> =
        row.objects.iter().filter_map(|id| Some(program.objects.get(id.0 as usize)?.name.as_str())).collect();
    names.join(", ")
}
