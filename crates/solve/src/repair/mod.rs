//! Repairing: the smallest changes after which a layout satisfies its program again, or one constraint of it.
//!
//! Three kinds, in this order: objects are moved, few of them and not far; a number in a constraint is relaxed, by as
//! little as will do; a preference is given up, or a demand becomes one. Whatever is offered has been judged as a whole: what
//! was to be repaired holds, and what held before still does. A pinned property stays at what the program assigns.
//!
//! Moves are looked for in circles, each within a budget that counts work: first what `check` offers for the same rows
//! (`scenelang_engine::moves_for`), so that the two agree; only where that breaks something or is nothing, local
//! searches from the layout as it is, and a new solution altogether (`whole`). What a search finds is then taken back as
//! far as all still holds (`least`).
//!
//! What is proved to be contradictory is not searched for: the smallest set of statements that cannot hold together is the
//! answer, with the numbers and demands that may be changed.
//!
//! Absent here: reading and writing of files. Edits of the program are offered as edits of its text.

mod edit;
mod judge;
mod least;
mod moves;
mod preference;
mod relax;
mod room;
#[cfg(test)]
mod tests;
pub mod told;
mod whole;

use crate::problem::pose::{Pose, half_turn};
pub use edit::edited;
use judge::Judge;
pub use relax::{Relaxed, has_numbers, in_statement};
use scenelang_base::{Edit, SourceMap};
use scenelang_engine::limit::Stop;
use scenelang_engine::{Reads, row_of};
use scenelang_lang::Program;
use scenelang_lang::program::{ObjectId, Owner, Pinned};
use scenelang_lang::sources::Loader;
use scenelang_layout::{Layout, Vec3};
use scenelang_verify::check::Subject;
use scenelang_verify::explain::{ObjectMove, RowRef};
use scenelang_verify::prove::{Contradiction, ProveOptions, prove};
use scenelang_verify::report::model::RowKind;
use std::cmp::Ordering;
use std::path::Path;
use std::time::Duration;

/// A layout that does not satisfy its program.
#[derive(Clone, Copy)]
pub struct Damaged<'a> {
    /// What must hold.
    pub program: &'a Program,
    /// Where everything is.
    pub layout: &'a Layout,
    /// Where the program comes from; without it no edits of its text are offered.
    pub text: Option<Text<'a>>,
}

/// The text of a program, and how it is compiled again after an edit.
#[derive(Clone, Copy)]
pub struct Text<'a> {
    /// How its main file is called in messages.
    pub name: &'a str,
    /// Where that is.
    pub path: &'a Path,
    /// How it was compiled.
    pub compile: scenelang_lang::Options,
    /// Where its files come from.
    pub loader: &'a dyn Loader,
    /// The files as they were read; spans of the program refer to these.
    pub sources: &'a SourceMap,
}

/// What is to be repaired.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Which {
    /// Whatever must hold and does not.
    All,
    /// Those of these rows that fail, preferences too. Others may go on failing.
    Rows(Vec<RowRef>),
}

/// How to look.
#[derive(Clone, Debug, PartialEq)]
pub struct RepairOptions {
    /// At most so much work in all; a unit is about ten nanoseconds.
    pub budget: u64,
    /// At most so long, whatever the budget. What comes of it then depends on the machine.
    pub time: Option<Duration>,
    /// Set from elsewhere, it ends the search.
    pub stop: Stop,
    /// Objects that stay where they are.
    pub locked: Vec<ObjectId>,
    /// At most so many alternatives of each kind.
    pub alternatives: usize,
    /// Tolerances, η, what a solid is, whether the physical rules apply.
    pub judge: scenelang_verify::Options,
}

impl Default for RepairOptions {
    fn default() -> Self {
        Self {
            budget: 200_000_000,
            time: None,
            stop: Stop::default(),
            locked: Vec::new(),
            alternatives: 3,
            judge: scenelang_verify::Options::default(),
        }
    }
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Repaired {
    /// What was to be repaired: rows that fail. None: there is nothing to do.
    pub failing: Vec<RowRef>,
    /// A smallest set of statements that cannot hold together, to which some of that belong: then nothing was moved.
    pub contradiction: Option<Contradiction>,
    /// Ways to repair it, the first being the best. None: no way was found, which proves nothing.
    pub alternatives: Vec<Alternative>,
}

/// How an alternative repairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum How {
    /// The layout changes.
    Moves,
    /// Numbers in the program change.
    Numbers,
    /// A preference that held is taken out of the program, and the layout changes.
    Drop,
    /// Demands become preferences.
    Prefer,
}

/// A way to repair a layout. All of it belongs together.
#[derive(Clone, Debug, PartialEq)]
pub struct Alternative {
    /// What kind it is.
    pub how: How,
    /// What is moved, in the order of the program.
    pub moves: Vec<Moved>,
    /// What else of the layout changes: names of regions and decision variables.
    pub also: Vec<String>,
    /// Edits of the program's text.
    pub edits: Vec<Edit>,
    /// Of each edit of a number: how far at least it must change, in the unit it is written in.
    pub least: Vec<f64>,
    /// Of each edit of a number: what it is and what it becomes, with its unit.
    pub shown: Vec<[String; 2]>,
    /// Preferences that hold in the layout and are given up: indices into [`Program::constraints`].
    pub drops: Vec<usize>,
    /// The layout afterwards.
    pub layout: Layout,
    /// Alternatives of a kind are in the order of this. Of moves: [`EACH`] for every object and the metres that its
    /// farthest point travels, up to twice as many for what is large.
    pub cost: f64,
}

/// What it costs to touch one more object (metres).
pub const EACH: f64 = 0.5;

/// An object that is moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    pub object: ObjectId,
    /// Where it is in the layout.
    pub from: Pose,
    /// Where it is to be.
    pub to: Pose,
    /// The object that it goes along with, because it rests on it.
    pub with: Option<ObjectId>,
}

impl Moved {
    /// The same as a step, to six digits after the point: the rest is noise.
    pub fn step(&self) -> ObjectMove {
        let rounded = |x: f64| (x * 1e6).round() / 1e6 + 0.0;
        let by: [f64; 3] = (self.to.pos - self.from.pos).into();
        let turn = rounded(half_turn(self.to.rot.y - self.from.rot.y));
        ObjectMove { object: self.object, by: by.map(rounded), turn, with: self.with }
    }
}

/// A layout that cannot be judged cannot be repaired: something is missing in it, or has no value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unjudged;

/// Looks for ways to repair a layout.
///
/// The same input gives the same alternatives, to the byte.
///
/// # Errors
/// The layout cannot be judged.
pub fn repair(damaged: &Damaged<'_>, which: &Which, options: &RepairOptions) -> Result<Repaired, Unjudged> {
    let judge = Judge::new(damaged, which, options)?;
    let failing = judge.targets.clone();
    if failing.is_empty() {
        return Ok(Repaired { failing, contradiction: None, alternatives: Vec::new() });
    }
    let mut alternatives = moves::offered(&judge);
    alternatives.truncate(options.alternatives);
    let moved = alternatives.iter().any(|a| a.how == How::Moves);
    // What can be moved contradicts nothing that is kept.
    let contradiction = if moved { None } else { contradiction(&judge, options) };
    if !moved && contradiction.is_none() && !failing.iter().any(|row| is_stuck(&judge, row)) {
        alternatives.extend(moves::all(&judge, options, false));
        if alternatives.is_empty() {
            alternatives.extend(preference::drops(&judge, options));
        }
    }
    if let Some(text) = &damaged.text {
        let apart = preference::apart(&judge, contradiction.as_ref());
        alternatives.extend(relax::numbers(&judge, text, options, &apart));
        alternatives.extend(preference::demand(&judge, text, &apart));
    }
    // Moves are in the order in which a person would choose; where they come from a search, that is by what they cost.
    alternatives.sort_by(|a, b| {
        let by_cost = if a.how == How::Moves { Ordering::Equal } else { a.cost.total_cmp(&b.cost) };
        a.how.cmp(&b.how).then(by_cost)
    });
    Ok(Repaired { failing, contradiction, alternatives })
}

/// Looks for numbers of the program whose change repairs a layout, and for nothing else; with the smallest set of statements
/// that cannot hold together, if what is to be repaired belongs to one.
///
/// # Errors
/// The layout cannot be judged.
pub fn by_numbers(damaged: &Damaged<'_>, which: &Which, options: &RepairOptions) -> Result<Repaired, Unjudged> {
    let judge = Judge::new(damaged, which, options)?;
    let failing = judge.targets.clone();
    let contradiction = contradiction(&judge, options);
    let found = damaged.text.as_ref().filter(|_| !failing.is_empty()).map(|text| {
        let apart = preference::apart(&judge, contradiction.as_ref());
        relax::numbers(&judge, text, options, &apart)
    });
    Ok(Repaired { failing, contradiction, alternatives: found.unwrap_or_default() })
}

/// Whether a row speaks of nothing but what stays where it is, locked or pinned, so that no move repairs it.
fn is_stuck(judge: &Judge<'_>, row: &RowRef) -> bool {
    let pinned = |owner: Owner, what: Pinned| {
        let mut own = judge.program.pins.iter().filter(|pin| pin.owner == owner && pin.property == what);
        // What is not where it is pinned may still go there.
        own.any(|pin| !judge.failed(&row_of(judge.program, pin.constraint)))
    };
    let is_pinned = |owner: Owner, what: [Pinned; 2]| what.into_iter().all(|what| pinned(owner, what));
    let stays = |id: &ObjectId| judge.locked.contains(id) || is_pinned(Owner::Object(*id), [Pinned::Pos, Pinned::Rot]);
    match row.subject {
        Subject::Statement(index) => {
            let reads = Reads::of(&judge.program.constraints[index].formula);
            let mut regions = reads.regions.iter();
            !(reads.sees_all || reads.objects.is_empty())
                && reads.variables.is_empty()
                && reads.objects.iter().all(stays)
                && regions.all(|id| is_pinned(Owner::Region(*id), [Pinned::Pos, Pinned::Scale]))
        }
        Subject::Pair(a, b) => stays(&a) && stays(&b),
        Subject::Object(_) | Subject::Part(..) => false,
    }
}

/// A smallest set of statements that no layout satisfies, if what is to be repaired belongs to one. No move can help then.
fn contradiction(judge: &Judge<'_>, options: &RepairOptions) -> Option<Contradiction> {
    let stated = |row: &RowRef| match row.subject {
        Subject::Statement(index) if row.kind != RowKind::Prefer => Some(index),
        _ => None,
    };
    let stated: Vec<usize> = judge.targets.iter().filter_map(stated).collect();
    if stated.is_empty() {
        return None;
    }
    let proving = ProveOptions {
        judging: options.judge,
        redundant: false,
        // The same findings as `check`, and the search takes the same for granted.
        usual: true,
        cancel: Some(options.stop.flag()),
        ..ProveOptions::default()
    };
    let found = prove(judge.program, &proving).contradictions.into_iter();
    let usual = is_usual(judge.layout);
    let applies = |c: &Contradiction| !c.as_usual || usual && c.sizes.is_empty();
    found.filter(applies).find(|c| c.statements.iter().any(|s| stated.contains(s)))
}

/// Whether things stand upright in a layout and rooms are not turned, as proofs may take for granted.
pub fn is_usual(layout: &Layout) -> bool {
    const UPRIGHT: f64 = 0.01;
    let upright = |rot: &Vec3| [rot.x, rot.z].iter().all(|angle| half_turn(*angle).abs() < UPRIGHT);
    let level = |rot: &Vec3| rot.iter().all(|angle| half_turn(*angle).abs() < UPRIGHT);
    layout.objects.iter().all(|(_, p)| upright(&p.rot)) && layout.regions.iter().all(|(_, p)| level(&p.rot))
}
