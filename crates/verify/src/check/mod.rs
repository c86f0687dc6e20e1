//! The judgement of a layout: every stated constraint, then the physical rules, then what looks odd.

mod describe;
mod draws;
mod file;
mod live;
mod matching;
mod physical;
mod rooms;
mod stated;
mod wording;

pub(crate) use describe::number as measure_in_words;
pub use file::{
    Checked, check_file, check_file_with, check_layout_of, check_layout_text, check_program, check_read, program_of,
};
pub use live::Live;

use crate::eval::Cause;
use crate::explain::{self, Explanation};
use crate::report::model::{Kind, Summary};
use crate::tolerances::Options;
use crate::world::World;
use scenelang_base::{Code, Diagnostic, Label, Span};
use scenelang_lang::program::{DrawId, ObjectId, Program, Unit, VariableId};
use scenelang_layout::{Layout, Places};
use smol_str::SmolStr;

/// A judgement: rows, counts, and what could not be judged or looks odd. Places are absolute.
#[derive(Clone, Debug, Default)]
pub struct Verdict {
    /// Stated constraints in source order, then physical ones.
    pub rows: Vec<Judged>,
    /// How many there are of each kind, listed or not, and how many hold.
    pub summary: Summary,
    /// What could not be judged or looks odd, beside the rows.
    pub diagnostics: Vec<Diagnostic>,
}

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Subject {
    /// A statement: an index into [`Program::constraints`].
    Statement(usize),
    /// A pair of objects, in the order of their names.
    Pair(ObjectId, ObjectId),
    /// An object.
    Object(ObjectId),
}

/// One constraint, judged.
#[derive(Clone, Debug)]
pub struct Judged {
    /// What kind of constraint.
    pub kind: Kind,
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
    /// What was measured and, where it fails, where its objects are.
    pub fn message(&self) -> String {
        let places = self.related.iter().map(|label| label.message.as_str());
        let parts: Vec<&str> =
            std::iter::once(self.measured.as_str()).chain(places).filter(|p| !p.is_empty()).collect();
        parts.join("; ")
    }
}

/// Judges a layout that was read without its file: what is wrong with a draw is said in the program.
pub fn check(program: &Program, layout: &Layout, options: &Options) -> Verdict {
    check_at(program, layout, None, options)
}

/// Judges a layout; `places` says where its values stand.
fn check_at(program: &Program, layout: &Layout, places: Option<&Places>, options: &Options) -> Verdict {
    let mut world = World::new(program, layout, options);
    if let Some(places) = places {
        refuse(program, &mut world, places);
    }
    let mut verdict = Verdict::default();
    draws::check(program, &mut world, places, &mut verdict.diagnostics);
    let mut physical = Verdict::default();
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
    verdict.diagnostics.append(&mut physical.diagnostics);
    explain::complete(program, &world, &mut verdict, options.detail.explain);
    rooms::warn(program, &world, &mut verdict.diagnostics);
    verdict
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
