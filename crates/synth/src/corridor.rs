//! From a program file to a judged layout: stages I to III.

use crate::furnish::{Furnished, furnish};
use crate::hold::Hold;
use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap};
use scenelang_lang::program::ObjectId;
use scenelang_lang::sources::Disk;
use scenelang_lang::{Compiled, Program, compile_file};
use scenelang_layout::{Layout, ReadLayout, file as layout_file};
use scenelang_llm::Model;
use scenelang_solve::{Asking, Finisher, Hybrid, Outcome, Placed, Problem, Progress, Tally, hybrid};
use scenelang_verify::{Checked, check_layout_of};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Duration;

/// What to lay out.
#[derive(Clone, Copy, Debug)]
pub struct Request<'a> {
    /// How the program is called in messages.
    pub name: &'a str,
    /// The program's file.
    pub path: &'a Path,
    /// A layout to start from: its name and its text.
    pub start: Option<(&'a str, &'a str)>,
    /// How the layout is called in messages and in the report.
    pub layout_name: &'a str,
    /// What the `scene` member of the layout will say.
    pub scene_member: &'a str,
    /// What stays where the layout to start from has it.
    pub hold: Hold<'a>,
    /// The solver takes at most so long.
    pub time: Option<Duration>,
    /// Fixes draws and every random choice.
    pub seed: u64,
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub judge: scenelang_verify::Options,
}

/// A language model that proposes moves, and how it is asked.
pub struct Adviser<'m> {
    /// The model.
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

/// Someone who wants to know how far it is, and may end it.
pub trait Observer {
    /// A stage begins.
    fn enter(&mut self, stage: Stage);
    /// A stage ends.
    fn leave(&mut self, stage: Stage);
    /// How far the solver is; `Break` ends everything without a result.
    fn solving(&mut self, progress: &Progress) -> ControlFlow<()>;
}

/// A layout, judged.
#[derive(Debug)]
pub struct Solved {
    /// The program.
    pub compiled: Compiled,
    /// Where everything is.
    pub layout: Layout,
    /// The layout file.
    pub layout_text: String,
    /// How the solver got there.
    pub outcome: Outcome,
    /// What the model had to do with it, if there was one.
    pub advice: Option<Advice>,
    /// The judgement of that file, by the same code as `scenelang check`.
    pub checked: Checked,
    /// What had no asset or no usual size.
    pub warnings: Vec<Diagnostic>,
}

/// Why there is no layout.
#[derive(Debug)]
pub enum Failure {
    /// The program, or the layout to start from, has errors.
    Input(SourceMap, Vec<Diagnostic>),
    /// The observer ended it.
    Interrupted,
}

/// Compiles, furnishes, solves and judges. A layout that breaks a hard constraint is a result, too: the judgement says
/// which.
///
/// # Errors
/// The program does not compile, the layout to start from cannot be read, or the observer ends it.
pub fn solve(request: &Request<'_>, observer: &mut dyn Observer) -> Result<Solved, Failure> {
    solve_with(request, None, observer)
}

/// The same with a model that proposes, if there is one.
///
/// # Errors
/// As for [`solve`]; a model that does not answer is none of them.
pub fn solve_with(
    request: &Request<'_>,
    adviser: Option<Adviser<'_>>,
    observer: &mut dyn Observer,
) -> Result<Solved, Failure> {
    observer.enter(Stage::Program);
    let compiled = compile_file(request.name, request.path, scenelang_lang::Options::default());
    let Some(program) = &compiled.program else {
        return Err(Failure::Input(compiled.sources, compiled.diagnostics));
    };
    let start = request.start.map(|(name, text)| read_start(name, text)).transpose()?;
    let locked = request.hold.objects(program, start.as_ref().map(|s| &s.layout));
    let locked = locked.map_err(|finding| Failure::Input(compiled.sources.clone(), vec![*finding]))?;
    observer.leave(Stage::Program);

    let how = Arranging {
        previous: start.as_ref().map(|s| &s.layout),
        locked,
        time: request.time,
        seed: request.seed,
        judge: request.judge,
    };
    let arranged = arrange(program, how, adviser, observer).ok_or(Failure::Interrupted)?;
    let Arranged { mut outcome, advice, mut warnings } = arranged;
    scenelang_lang::lint::allow::silence(&compiled.sources, &mut warnings);
    outcome.layout.scene = Some(request.scene_member.to_owned());
    outcome.layout.seed = Some(request.seed);
    let layout_text = layout_file::to_json(&outcome.layout, start.as_ref().map(|s| &s.document));
    let checked = check_layout_of(
        request.layout_name,
        layout_text.clone(),
        (request.name, request.path),
        &request.judge,
        scenelang_lang::Options::default(),
        &Disk,
    );
    Ok(Solved { layout: outcome.layout.clone(), layout_text, outcome, advice, checked, warnings, compiled })
}

/// How a program that is compiled already is laid out.
#[derive(Clone, Debug, Default)]
pub struct Arranging<'a> {
    /// A layout to start from.
    pub previous: Option<&'a Layout>,
    /// Objects that stay where it has them.
    pub locked: Vec<ObjectId>,
    /// The solver takes at most so long.
    pub time: Option<Duration>,
    /// Fixes draws and every random choice.
    pub seed: u64,
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub judge: scenelang_verify::Options,
}

/// A layout that is not judged yet.
#[derive(Debug)]
pub struct Arranged {
    /// The layout, and how the solver got there.
    pub outcome: Outcome,
    /// What the model had to do with it, if there was one.
    pub advice: Option<Advice>,
    /// What had no asset or no usual size.
    pub warnings: Vec<Diagnostic>,
}

/// Stages II and III for a compiled program; `None`: the observer ended it.
pub fn arrange(
    program: &Program,
    how: Arranging<'_>,
    adviser: Option<Adviser<'_>>,
    observer: &mut dyn Observer,
) -> Option<Arranged> {
    observer.enter(Stage::Assets);
    let draws = scenelang_solve::draws(program, how.seed);
    let Furnished { layout, warnings } = furnish(program, draws, how.previous, &how.judge);
    observer.leave(Stage::Assets);

    observer.enter(Stage::Layout);
    let problem = Problem { program, placed: placed(program, how.previous), start: layout };
    let options = scenelang_solve::Options {
        seed: how.seed,
        judge: how.judge,
        time: how.time,
        locked: how.locked,
        ..Default::default()
    };
    let mut ended = false;
    let mut watch = |progress: Progress| {
        let flow = observer.solving(&progress);
        ended |= flow.is_break();
        flow
    };
    let (outcome, advice) = match adviser {
        None => (scenelang_solve::solve(&problem, &options, &mut watch), None),
        Some(Adviser { model, asking }) => {
            let Hybrid { outcome, tally, without } =
                hybrid(&problem, &options, model, asking, Finisher::Numeric, &mut watch);
            (outcome, Some(Advice { tally, without }))
        }
    };
    observer.leave(Stage::Layout);
    (!ended).then_some(Arranged { outcome, advice, warnings })
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
