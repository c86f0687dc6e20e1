//! The judgement of a layout: every stated constraint, then the physical rules, then what looks odd.
//!
//! Its steps can be taken one by one, for who judges again only what a change can alter. Absent here: what would repair a
//! violation.

mod describe;
pub mod draws;
pub mod matching;
mod physical;
pub mod rooms;
pub mod stated;
mod wording;

pub(crate) use describe::number as measure_in_words;
pub use physical::{GAPS_FOLLOWED, LISTED, Ruled, Rules, too_dense};

use crate::eval::Cause;
use crate::explain::{Explanation, RowRef};
use crate::opening;
use crate::report::model::{RowKind, Summary, Unlisted};
use crate::report::{Report, build};
use crate::rules::open;
use crate::tolerances::Options;
use crate::world::World;
use scenelang_base::{Code, Diagnostic, Label, SourceMap, Span};
use scenelang_lang::program::{DrawId, ObjectId, Program, Unit, VariableId};
use scenelang_layout::{Layout, Places};
use smol_str::SmolStr;

/// A judgement: rows, counts, and what could not be judged or looks odd. Places are absolute.
#[derive(Clone, Debug, Default)]
pub struct CheckVerdict {
    /// Stated constraints in source order, then physical ones.
    pub rows: Vec<Judged>,
    /// How many there are of each kind, listed or not, and how many hold.
    pub summary: Summary,
    /// What the summary counts and the rows leave out.
    pub unlisted: Unlisted,
    /// What could not be judged or looks odd, beside the rows.
    pub diagnostics: Vec<Diagnostic>,
    /// The names of the movable parts that rows may speak of.
    pub parts: Vec<(ObjectId, u8, SmolStr)>,
}

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Subject {
    /// A statement: an index into [`Program::constraints`].
    Statement(usize),
    /// A pair of objects, in the order of their names.
    Pair(ObjectId, ObjectId),
    Object(ObjectId),
    /// A movable part of an object: which of its joints.
    Part(ObjectId, u8),
}

/// One constraint, judged.
#[derive(Clone, Debug)]
pub struct Judged {
    /// What kind of constraint.
    pub kind: RowKind,
    /// What it is about.
    pub subject: Subject,
    /// Whether it holds; `None`: cannot be judged.
    pub satisfied: Option<bool>,
    /// By how much; `None` where it cannot be judged or has no measure.
    pub margin: Option<(f64, Unit)>,
    /// Objects of the deciding instance.
    pub objects: Vec<ObjectId>,
    /// The statement as written, or the rule in words.
    pub text: String,
    /// What was measured, in a sentence.
    pub measured: String,
    /// The statement; for a physical rule the declaration of its first object.
    pub place: Span,
    /// Declarations of the objects, with where they are.
    pub related: Vec<Label>,
    /// Weight of a preference.
    pub weight: Option<f64>,
    /// The guideline that it is an instance of.
    pub guideline: Option<SmolStr>,
    /// `@req` sentences.
    pub requirements: Vec<String>,
    /// What a violation of it is called.
    pub code: Code,
    /// Why it fails, where it does.
    pub explanation: Option<Box<Explanation>>,
}

impl Judged {
    pub fn row(&self) -> RowRef {
        RowRef { kind: self.kind, subject: self.subject }
    }

    /// What was measured and, where it fails, where its objects are.
    pub fn message(&self) -> String {
        let places = self.related.iter().map(|label| label.message.as_str());
        let parts: Vec<&str> =
            std::iter::once(self.measured.as_str()).chain(places).filter(|p| !p.is_empty()).collect();
        parts.join("; ")
    }
}

/// What came of judging a file.
#[derive(Debug)]
pub struct Checked {
    /// All files read; places in the verdict refer to these.
    pub sources: SourceMap,
    /// The program, if it compiles.
    pub program: Option<Program>,
    /// The layout, if the file is one that could be read.
    pub layout: Option<Layout>,
    /// Rows and diagnostics, those of the program and of the layout file included.
    pub verdict: CheckVerdict,
    /// The same as a report.
    pub report: Report,
}

impl Checked {
    /// A file that nothing more can be said of than these diagnostics; places in them refer to `sources`.
    pub fn refused(name: &str, sources: SourceMap, diagnostics: Vec<Diagnostic>, options: &Options) -> Self {
        let verdict = CheckVerdict { diagnostics, ..CheckVerdict::default() };
        let report = build(name, &verdict, None, &sources, options);
        Self { sources, program: None, layout: None, verdict, report }
    }

    /// Puts what there is to say besides before all else; `name` is what the file is called.
    pub fn preface(&mut self, name: &str, mut said: Vec<Diagnostic>, options: &Options) {
        said.append(&mut self.verdict.diagnostics);
        self.verdict.diagnostics = said;
        self.report = build(name, &self.verdict, self.program.as_ref(), &self.sources, options);
    }

    /// Leaves out warnings of these codes; errors stay.
    pub fn silence(&mut self, codes: &[Code]) {
        let silent = |code: &str| code.starts_with('W') && codes.iter().any(|c| c.as_str() == code);
        self.verdict.diagnostics.retain(|d| !silent(d.code.as_str()));
        self.report.diagnostics.retain(|d| !silent(&d.code));
    }
}

/// Judges a layout that was read without its file: what is wrong with a draw is said in the program.
pub fn check(program: &Program, layout: &Layout, options: &Options) -> CheckVerdict {
    judged(program, layout, None, options).0
}

/// The same, with the instance that was judged. `places` says where the values of the layout stand.
pub fn judged(
    program: &Program,
    layout: &Layout,
    places: Option<&Places>,
    options: &Options,
) -> (CheckVerdict, World<f64>) {
    let mut world = World::new(program, layout, options);
    if let Some(places) = places {
        refuse(program, &mut world, places);
    }
    let mut verdict = CheckVerdict::default();
    draws::check(program, &mut world, places, &mut verdict.diagnostics);
    let mut physical = CheckVerdict::default();
    // They ask each other nothing. A thread of its own takes longer to begin than a room takes to judge.
    let large = program.objects.len() + program.constraints.len() > 2_000;
    std::thread::scope(|scope| {
        let mut judge_physical = || {
            if options.physics {
                physical::judge(program, &world, &mut physical);
            }
        };
        if large {
            scope.spawn(judge_physical);
        } else {
            judge_physical();
        }
        stated::judge(program, &world, &mut verdict);
    });
    verdict.rows.append(&mut physical.rows);
    verdict.summary.physical = physical.summary.physical;
    verdict.unlisted = physical.unlisted;
    verdict.parts = parts(&world);
    verdict.diagnostics.append(&mut physical.diagnostics);
    rooms::warn(program, &world, &mut verdict.diagnostics);
    (verdict, world)
}

/// The names of the movable parts in an instance that have to open.
pub fn parts(world: &World<f64>) -> Vec<(ObjectId, u8, SmolStr)> {
    let named = |id: ObjectId| {
        let joints = opening::joints(world, id);
        open::demands(world, id)
            .into_iter()
            .filter_map(move |(part, _)| Some((id, part, joints.get(usize::from(part))?)))
    };
    let all = world.bodies().flat_map(|(id, _)| named(id));
    all.map(|(id, part, joint)| (id, part, joint.name.clone())).collect()
}

/// What the file gives but could not be read has been told of: it is refused, not missing.
fn refuse(program: &Program, world: &mut World<f64>, places: &Places) {
    for (index, variable) in program.variables.iter().enumerate() {
        let id = VariableId(index as u32);
        if world.variable(id).is_err() && places.variables.get(&variable.name).is_some() {
            world.refuse_variable(id, Cause::Refused);
        }
    }
    for (index, draw) in program.draws.iter().enumerate() {
        let id = DrawId(index as u32);
        if world.draw(id).is_err() && places.draws.get(&draw.key).is_some() {
            world.set_draw(id, Err(Cause::Refused));
        }
    }
}
