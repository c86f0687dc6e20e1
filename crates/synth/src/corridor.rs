//! From a program file to a judged layout: stages I to III.

use crate::again::{FEW, Repaired, moved, repaired};
use crate::doubt::{Ended, doubted};
use crate::furnish::{Chosen, Earlier, Furnished, furnish_from, gathered};
use crate::hold::Hold;
use crate::rebuild::{Before, How, Inputs, Looks, layout_inputs, prefers_otherwise};
use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap, codes};
use scenelang_catalogue::Chain;
use scenelang_engine::{Instant, check_layout_of, check_program};
use scenelang_lang::program::ObjectId;
use scenelang_lang::sources::Loader;
use scenelang_lang::{Compiled, Program, compile_with};
use scenelang_layout::{Layout, ReadLayout, file as layout_file};
use scenelang_llm::Model;
use scenelang_solve::{
    Asking, End, Finisher, Free, Hybrid, MOST_OBJECTS, Outcome, Placed, Problem, Progress, Stop, Tally, alternatives,
    freedom, hybrid,
};
use scenelang_verify::{Checked, Explain};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The part of the work for preferences that is done where the furniture has its places already, for [`LayoutRequest::share`].
pub const PLANNED: u8 = 20;

/// What to lay out.
#[derive(Clone, Copy)]
pub struct LayoutRequest<'a> {
    /// How the program is called in messages.
    pub name: &'a str,
    /// The program's file.
    pub path: &'a Path,
    /// Where it and what it imports come from.
    pub files: &'a dyn Loader,
    /// A layout to start from: its name and its text.
    pub start: Option<(&'a str, &'a str)>,
    /// What an earlier run made of the program as it was then, for who makes again only what has changed: its layout is kept,
    /// or started from where there is no other one to start from.
    pub before: Option<&'a Before>,
    /// How the layout is called in messages and in the report.
    pub layout_name: &'a str,
    /// What the `scene` member of the layout will say.
    pub scene_member: &'a str,
    /// What stays where the layout to start from has it.
    pub hold: Hold<'a>,
    /// All of it takes at most so long, from the reading to the judgement.
    pub time: Option<Duration>,
    /// How many layouts that differ in kind are wanted; `None`: one, and a model may propose.
    pub alternatives: Option<usize>,
    /// How much work may go into what a layout leaves open; 0: it is not looked for.
    pub free: u64,
    /// How many threads the solver may use; 0: as many as there are cores. The layout does not depend on it.
    pub threads: usize,
    /// How many times the usual work the solver may do before it gives up; 0 counts as 1.
    pub effort: u64,
    /// What part of the usual work may go into preferences, in percent.
    pub quality: u8,
    /// One part in so many of that is enough, because the layout to start from was planned; 0 counts as 1.
    pub share: u8,
    /// Set from elsewhere, it ends the work: what there is of a layout by then is the result.
    pub stop: &'a Stop,
    /// Fixes draws and every random choice.
    pub seed: u64,
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub judge: scenelang_verify::Options,
    /// Where furniture comes from; `None`: from the library.
    pub furniture: Option<&'a Chain>,
}

/// A language model that proposes moves, and how it is asked.
pub struct Adviser<'m> {
    pub model: &'m mut dyn Model,
    /// k, T, temperature and the rest.
    pub asking: Asking,
}

/// What came of asking a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// Rounds, moves, why it ended.
    pub tally: Tally,
    /// Whether the numeric search did better without it, and the layout is its.
    pub without: bool,
}

/// The stages of the corridor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// I: the program is read and compiled.
    Program,
    /// II: every object gets a size and parts.
    Assets,
    /// III: every object gets a place.
    Layout,
    /// IV: files are written.
    Export,
}

impl Stage {
    /// As shown to people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Program => "program",
            Self::Assets => "assets",
            Self::Layout => "layout",
            Self::Export => "export",
        }
    }
}

/// Someone who wants to know how far it is.
pub trait Observer {
    /// A stage begins.
    fn enter(&mut self, stage: Stage);
    /// A stage ends.
    fn leave(&mut self, stage: Stage);
    /// What is made or looked for in stage II.
    fn furnishing(&mut self, _said: &str) {}
    /// How far the solver is.
    fn solving(&mut self, progress: &Progress);
}

#[derive(Debug)]
pub struct JudgedLayout {
    /// Where everything is, and how the solver got there; as far as it got, if it was asked to end
    /// ([`Layout::incomplete`]).
    pub outcome: Outcome,
    pub text: String,
    /// The judgement of that file, by the same code as `scenelang check`.
    pub checked: Checked,
    /// What is still open, where that was asked for and all that must hold does.
    pub free: Free,
}

impl JudgedLayout {
    /// Where everything is.
    pub fn layout(&self) -> &Layout {
        &self.outcome.layout
    }
}

/// What came of a program.
#[derive(Debug)]
pub struct Solved {
    /// The program.
    pub compiled: Compiled,
    /// The layout, or what comes closest to one.
    pub first: JudgedLayout,
    /// Others that differ from it, and from each other, in kind.
    pub others: Vec<JudgedLayout>,
    /// What the model had to do with it, if there was one.
    pub advice: Option<Advice>,
    /// What had no asset or no usual size.
    pub warnings: Vec<Diagnostic>,
    /// Who gave each object what; nothing, where only the library was asked.
    pub furniture: Vec<Chosen>,
    /// What it was made from.
    pub made: Made,
}

/// What a layout was made from, for the next run.
#[derive(Clone, Debug, Default)]
pub struct Made {
    /// What was asked for and given, by object.
    pub looks: Looks,
    /// What decided where things are.
    pub inputs: Inputs,
    /// Whether the layout is that of the earlier run, as it was.
    pub kept: bool,
}

impl Solved {
    /// All layouts in order.
    pub fn all(&self) -> impl Iterator<Item = &JudgedLayout> {
        std::iter::once(&self.first).chain(&self.others)
    }
}

/// Why there is no layout.
#[derive(Debug)]
pub enum Failure {
    /// The program, or the layout to start from, has errors.
    Input(SourceMap, Vec<Diagnostic>),
    /// It is proved that there is none: the judgement of the program, as `scenelang check` has it.
    Contradiction(Box<Checked>),
    /// It was asked to end before there was anything to show.
    Interrupted,
}

/// Compiles, furnishes, solves and judges. A layout that breaks a hard constraint is a result, too: the judgement says
/// which.
///
/// # Errors
/// The program does not compile or cannot hold, the layout to start from cannot be read, or the end is asked for.
pub fn solve(request: &LayoutRequest<'_>, observer: &mut dyn Observer) -> Result<Solved, Failure> {
    solve_with(request, None, observer)
}

/// The same with a model that proposes, if there is one.
///
/// # Errors
/// As for [`solve`]; a model that does not answer is none of them.
pub fn solve_with(
    request: &LayoutRequest<'_>,
    adviser: Option<Adviser<'_>>,
    observer: &mut dyn Observer,
) -> Result<Solved, Failure> {
    let may_fail = request.before.is_none() || request.start.is_some() || adviser.is_some();
    let solved = solve_once(request, adviser, observer)?;
    if may_fail || solved.made.kept || solved.first.outcome.converged || request.stop.is_set() {
        return Ok(solved);
    }
    // From where things stood, no layout was found; from nothing there may be one.
    solve_once(&LayoutRequest { before: None, ..*request }, None, observer)
}

fn solve_once(
    request: &LayoutRequest<'_>,
    adviser: Option<Adviser<'_>>,
    observer: &mut dyn Observer,
) -> Result<Solved, Failure> {
    let begun = Instant::now();
    let Opened { compiled, start, locked } = opened(request, observer)?;
    let Some(program) = &compiled.program else {
        return Err(Failure::Input(compiled.sources, compiled.diagnostics));
    };

    let before = request.before;
    let how = arranging(request, start.as_ref(), locked);
    let Ready { mut problem, mut options, mut warnings, furniture, looks } = ready(program, how, observer);
    scenelang_lang::lint::allow::silence(&compiled.sources, &mut warnings);
    let warnings = gathered(&warnings);
    let mut made = Made { looks, inputs: inputs(request, program, &problem.start, adviser.is_some()), kept: false };
    if let Some(before) = before.filter(|before| before.inputs == made.inputs && !before.layout.incomplete) {
        observer.enter(Stage::Layout);
        let first = kept(request, before);
        observer.leave(Stage::Layout);
        made.kept = true;
        return Ok(Solved { first, others: Vec::new(), advice: None, warnings, furniture, made, compiled });
    }
    if let Some(before) = before.filter(|_| start.is_none()) {
        stand_as_before(&mut problem, before);
        if !prefers_otherwise(&before.inputs, &made.inputs) {
            options.polish = 0.0;
        }
    }

    observer.enter(Stage::Layout);
    let before = begun.elapsed();
    // With a model the layout is the model's to change.
    let mut repaired =
        if adviser.is_none() { repaired(program, &problem.start, &problem.placed, &options) } else { None };
    if let Some(few) = repaired.take_if(|repaired| repaired.moved <= FEW || request.alternatives.is_some()) {
        problem.start = few.layout;
    }
    if request.stop.is_set() {
        return Err(Failure::Interrupted);
    }
    options.time = request.time.map(|time| left(time, before, begun.elapsed()).max(time / 4));
    // A model is dear: it is not asked for what cannot be.
    let options = &options;
    let found = doubted(program, request.judge, request.stop, (adviser.is_some(), start.is_none()), |stop| {
        let options = scenelang_solve::Options { stop: stop.clone(), ..options.clone() };
        let (outcomes, advice) = match request.alternatives {
            Some(wanted) => {
                let mut watch = |progress: Progress| {
                    observer.solving(&progress);
                    ControlFlow::Continue(())
                };
                (alternatives(&problem, &options, wanted, &mut watch), None)
            }
            None => {
                let (outcome, advice) = settled(&problem, &options, adviser, repaired.as_ref(), observer);
                (vec![outcome], advice)
            }
        };
        let ended = match outcomes.first() {
            Some(outcome) if outcome.converged => Ended::Found,
            Some(Outcome { end: End::Time | End::Asked, .. }) => Ended::Cut,
            _ => Ended::Unfound,
        };
        ((outcomes, advice), ended)
    });
    let (outcomes, advice) = match found {
        Ok(found) => found,
        Err(findings) => {
            observer.leave(Stage::Layout);
            let checked = check_program(request.name, compiled, &findings, &request.judge);
            return Err(Failure::Contradiction(Box::new(checked)));
        }
    };
    let finish = |(index, outcome): (usize, Outcome)| {
        let name = match request.alternatives {
            Some(_) => numbered(Path::new(request.layout_name), index + 1).display().to_string(),
            None => request.layout_name.to_owned(),
        };
        let mut found = judged(request, &name, outcome, start.as_ref());
        // What is still free has the time that is left.
        if request.free > 0 && found.outcome.converged && !request.stop.is_set() {
            let time = request.time.map(|time| left(time, Duration::ZERO, begun.elapsed()));
            let options = scenelang_solve::Options { time, ..options.clone() };
            found.free = freedom(&problem, &options, &found.outcome.layout, request.free);
        }
        found
    };
    let mut all = outcomes.into_iter().enumerate().map(finish);
    let first = all.next().ok_or(Failure::Interrupted)?;
    let others = all.collect();
    observer.leave(Stage::Layout);
    Ok(Solved { first, others, advice, warnings, furniture, made, compiled })
}

/// What decides where things are; `furnished` has their shapes.
fn inputs(request: &LayoutRequest<'_>, program: &Program, furnished: &Layout, advised: bool) -> Inputs {
    let how = How {
        judge: &request.judge,
        seed: request.seed,
        effort: request.effort,
        quality: request.quality,
        limited: request.time.is_some(),
        advised,
    };
    layout_inputs(program, furnished, &how)
}

/// A program that is read, and what is known before its furniture is.
struct Opened {
    compiled: Compiled,
    start: Option<ReadLayout>,
    locked: Vec<ObjectId>,
}

/// Stage I: a program that compiles.
fn opened(request: &LayoutRequest<'_>, observer: &mut dyn Observer) -> Result<Opened, Failure> {
    observer.enter(Stage::Program);
    let as_usual = scenelang_lang::Options::default();
    let compiled = compile_with(request.name, request.path, as_usual, request.files, SourceMap::new());
    let Some(program) = &compiled.program else {
        return Err(Failure::Input(compiled.sources, compiled.diagnostics));
    };
    if let Some(finding) = too_large(program) {
        return Err(Failure::Input(compiled.sources, vec![finding]));
    }
    let start = request.start.map(|(name, text)| read_start(name, text)).transpose()?;
    let locked = request.hold.objects(program, start.as_ref().map(|s| &s.layout));
    let locked = locked.map_err(|finding| Failure::Input(compiled.sources.clone(), vec![*finding]))?;
    observer.leave(Stage::Program);
    Ok(Opened { compiled, start, locked })
}

fn arranging<'a>(request: &LayoutRequest<'a>, start: Option<&'a ReadLayout>, locked: Vec<ObjectId>) -> Arranging<'a> {
    Arranging {
        previous: start.map(|s| &s.layout),
        made: request.before.filter(|_| start.is_none()),
        locked,
        time: request.time,
        threads: request.threads,
        effort: request.effort,
        quality: Some(request.quality.div_ceil(request.share.max(1))),
        seed: request.seed,
        judge: request.judge,
        stop: request.stop.clone(),
        furniture: request.furniture,
    }
}

/// A program whose objects have sizes and parts, but no places yet.
#[derive(Debug)]
pub struct Furnishings {
    /// The program.
    pub compiled: Compiled,
    /// What had no asset or no usual size.
    pub warnings: Vec<Diagnostic>,
    /// Who gave each object what; nothing, where only the library was asked.
    pub furniture: Vec<Chosen>,
    /// What was asked for and given; there is no layout yet.
    pub made: Made,
}

/// Stage I alone.
///
/// # Errors
/// As for [`solve`].
pub fn compiled(request: &LayoutRequest<'_>, observer: &mut dyn Observer) -> Result<Compiled, Failure> {
    opened(request, observer).map(|opened| opened.compiled)
}

/// Stages I and II alone.
///
/// # Errors
/// As for [`solve`].
pub fn furnished(request: &LayoutRequest<'_>, observer: &mut dyn Observer) -> Result<Furnishings, Failure> {
    let Opened { compiled, start, locked } = opened(request, observer)?;
    let Some(program) = &compiled.program else {
        return Err(Failure::Input(compiled.sources, compiled.diagnostics));
    };
    let Ready { mut warnings, furniture, looks, .. } =
        ready(program, arranging(request, start.as_ref(), locked), observer);
    scenelang_lang::lint::allow::silence(&compiled.sources, &mut warnings);
    let made = Made { looks, ..Made::default() };
    Ok(Furnishings { warnings: gathered(&warnings), furniture, made, compiled })
}

/// The layout of an earlier run, judged again: what is said of it may have changed.
fn kept(request: &LayoutRequest<'_>, before: &Before) -> JudgedLayout {
    let outcome = Outcome {
        layout: before.layout.clone(),
        converged: true,
        end: End::Solved,
        constraints: Vec::new(),
        in_the_way: Vec::new(),
        iterations: 0,
        work: 0,
        unsatisfied: Vec::new(),
        warnings: Vec::new(),
    };
    let checked = judgement(request, request.layout_name, &before.text, true);
    JudgedLayout { outcome, text: before.text.clone(), checked, free: Free::default() }
}

/// Puts things and rooms where an earlier run had them: the search moves what it must from there.
fn stand_as_before(problem: &mut Problem<'_>, before: &Before) {
    for (name, placement) in &mut problem.start.objects {
        if let Some(old) = before.layout.object(name) {
            (placement.pos, placement.rot) = (old.pos, old.rot);
        }
    }
    problem.start.regions.clone_from(&before.layout.regions);
    problem.start.variables.clone_from(&before.layout.variables);
    problem.placed = placed(problem.program, Some(&before.layout));
}

/// Says so where a program has more objects than are laid out: each pair of them may collide.
pub fn too_large(program: &Program) -> Option<Diagnostic> {
    let object = program.objects.get(MOST_OBJECTS)?;
    let say = format!("{} objects are too many to solve", program.objects.len());
    let note = format!("the maximum is {MOST_OBJECTS}; split the scene, or represent several objects by one");
    Some(Diagnostic::new(codes::E0005, object.span, say).note(note))
}

/// How a program that is compiled already is laid out.
#[derive(Clone, Debug, Default)]
pub struct Arranging<'a> {
    /// A layout to start from.
    pub previous: Option<&'a Layout>,
    /// What an earlier run made: parts of objects that ask for the same as then.
    pub made: Option<&'a Before>,
    /// Objects that stay where it has them.
    pub locked: Vec<ObjectId>,
    /// The solver takes at most so long.
    pub time: Option<Duration>,
    /// How many threads the solver may use; 0: as many as there are cores. The layout does not depend on it.
    pub threads: usize,
    /// How many times the usual work the solver may do before it gives up; 0 counts as 1.
    pub effort: u64,
    /// What part of the usual work may go into preferences, in percent; `None`: the usual part.
    pub quality: Option<u8>,
    /// Fixes draws and every random choice.
    pub seed: u64,
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub judge: scenelang_verify::Options,
    /// Set from elsewhere, it ends the work.
    pub stop: Stop,
    /// Where furniture comes from; `None`: from the library.
    pub furniture: Option<&'a Chain>,
}

/// A layout that is not judged yet.
#[derive(Debug)]
pub struct Arranged {
    /// The layout, and how the solver got there.
    pub outcome: Outcome,
    /// What the model had to do with it, if there was one.
    pub advice: Option<Advice>,
}

/// Stages II and III for a compiled program; `None`: it was asked to end.
pub fn arrange(
    program: &Program,
    how: Arranging<'_>,
    adviser: Option<Adviser<'_>>,
    observer: &mut dyn Observer,
) -> Option<Arranged> {
    let stop = how.stop.clone();
    let Ready { mut problem, options, .. } = ready(program, how, observer);
    observer.enter(Stage::Layout);
    let mut few = if adviser.is_none() { repaired(program, &problem.start, &problem.placed, &options) } else { None };
    if let Some(few) = few.take_if(|few| few.moved <= FEW) {
        problem.start = few.layout;
    }
    let (outcome, advice) = settled(&problem, &options, adviser, few.as_ref(), observer);
    observer.leave(Stage::Layout);
    (!stop.is_set()).then_some(Arranged { outcome, advice })
}

/// What the solver is given.
struct Ready<'a> {
    problem: Problem<'a>,
    options: scenelang_solve::Options,
    warnings: Vec<Diagnostic>,
    furniture: Vec<Chosen>,
    looks: Looks,
}

/// Stage II.
fn ready<'a>(program: &'a Program, how: Arranging<'_>, observer: &mut dyn Observer) -> Ready<'a> {
    observer.enter(Stage::Assets);
    let draws = scenelang_solve::draws(program, how.seed);
    let mut say = |said: &str| observer.furnishing(said);
    let earlier = Earlier { previous: how.previous, made: how.made };
    let Furnished { layout, warnings, chosen, looks } =
        furnish_from(program, draws, earlier, &how.judge, how.furniture, &mut say);
    observer.leave(Stage::Assets);
    let looks = program.objects.iter().map(|object| object.name.to_string()).zip(looks).collect();
    let problem = Problem { program, placed: placed(program, how.previous), start: layout };
    let options = scenelang_solve::Options {
        seed: how.seed,
        judge: how.judge,
        time: how.time,
        threads: how.threads,
        effort: how.effort,
        polish: f64::from(how.quality.unwrap_or(scenelang_solve::QUALITY)) / 100.0,
        locked: how.locked,
        stop: how.stop,
        ..Default::default()
    };
    Ready { problem, options, warnings, furniture: chosen, looks }
}

/// Stage III, beside what was found move by move: what a search moves is not always less than that.
fn settled(
    problem: &Problem<'_>,
    options: &scenelang_solve::Options,
    adviser: Option<Adviser<'_>>,
    repaired: Option<&Repaired>,
    observer: &mut dyn Observer,
) -> (Outcome, Option<Advice>) {
    let (outcome, advice) = place(problem, options, adviser, observer);
    let less = |repaired: &&Repaired| !outcome.converged || moved(&problem.start, &outcome.layout) > repaired.moved;
    let Some(repaired) = repaired.filter(less) else { return (outcome, advice) };
    let problem = Problem { start: repaired.layout.clone(), ..problem.clone() };
    (place(&problem, options, None, observer).0, advice)
}

/// Stage III: by the solver, with a model if there is one.
fn place(
    problem: &Problem<'_>,
    options: &scenelang_solve::Options,
    adviser: Option<Adviser<'_>>,
    observer: &mut dyn Observer,
) -> (Outcome, Option<Advice>) {
    let mut watch = |progress: Progress| {
        observer.solving(&progress);
        ControlFlow::Continue(())
    };
    match adviser {
        None => (scenelang_solve::solve(problem, options, &mut watch), None),
        Some(Adviser { model, asking }) => {
            let Hybrid { outcome, tally, without } =
                hybrid(problem, options, model, asking, Finisher::Numeric, &mut watch);
            (outcome, Some(Advice { tally, without }))
        }
    }
}

/// A layout as a file called `name`, and its judgement.
fn judged(request: &LayoutRequest<'_>, name: &str, mut outcome: Outcome, start: Option<&ReadLayout>) -> JudgedLayout {
    outcome.layout.scene = Some(request.scene_member.to_owned());
    outcome.layout.seed = Some(request.seed);
    outcome.layout.incomplete = request.stop.is_set();
    let text = layout_file::to_json(&outcome.layout, start.map(|s| &s.document));
    let checked = judgement(request, name, &text, outcome.converged);
    JudgedLayout { outcome, text, checked, free: Free::default() }
}

fn judgement(request: &LayoutRequest<'_>, name: &str, text: &str, converged: bool) -> Checked {
    let mut judge = request.judge;
    if !converged {
        // No small move repairs what a whole search could not, and to look for one may take longer than that search.
        judge.detail.explain = Explain::First(0);
        judge.detail.bars = request.time.is_none();
    }
    let program = (request.name, request.path);
    check_layout_of(name, text.to_owned(), program, &judge, scenelang_lang::Options::default(), request.files)
}

/// The file of the `n`th of several layouts: `room.layout.json` becomes `room.2.layout.json`.
pub fn numbered(path: &Path, n: usize) -> PathBuf {
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let end = [".layout.json", ".json"].into_iter().find(|end| name.ends_with(end)).unwrap_or_default();
    path.with_file_name(format!("{}.{n}{end}", &name[..name.len() - end.len()]))
}

/// Of a time that all of it may take, what is left when so much is gone: what was done to read the program has to be done
/// again for the judgement.
fn left(time: Duration, before: Duration, gone: Duration) -> Duration {
    time.saturating_sub(gone + before.mul_f64(1.2))
}

fn read_start(name: &str, text: &str) -> Result<ReadLayout, Failure> {
    let mut sources = SourceMap::new();
    let file: FileId = sources.add(SourceFile::new(name, name, text));
    let read = layout_file::read(text, file);
    if read.usable && !read.diagnostics.iter().any(Diagnostic::is_error) {
        return Ok(read);
    }
    Err(Failure::Input(sources, read.diagnostics))
}

/// What the layout to start from has places for.
fn placed(program: &Program, previous: Option<&Layout>) -> Placed {
    let Some(previous) = previous else { return Placed::None };
    let ids = |has: &dyn Fn(usize) -> bool, n: usize| (0..n).filter(|i| has(*i)).map(|i| i as u32).collect::<Vec<_>>();
    let objects = ids(&|i| previous.object(&program.objects[i].name).is_some(), program.objects.len());
    let regions = ids(&|i| previous.region(&program.regions[i].name).is_some(), program.regions.len());
    Placed::Some {
        objects: objects.into_iter().map(ObjectId).collect(),
        regions: regions.into_iter().map(scenelang_lang::program::RegionId).collect(),
    }
}
