//! The physical rules over a whole layout. Rows for what fails; on request for everything.
//!
//! A row is null, not failed, where its object is missing, or where something that is missing could make it hold.

use super::describe::{declarations, number};
use super::{CheckVerdict, Judged, Subject};
use crate::builtins;
use crate::eval::{Cause, EvalError, Truth, judge as judge_formula};
use crate::explain::{self, Explanation};
use crate::opening::{self, LOOKS, Met};
use crate::report::model::RowKind;
use crate::rules::support::{self, Rest};
use crate::rules::{Columns, Scope, Support, bounds, collide, mounts, open, pairs_up_to};
use crate::world::World;
use rustc_hash::FxHashSet;
use scenelang_base::{Diagnostic, codes};
use scenelang_lang::program::{ObjectId, Program, Unit};
use scenelang_layout::inside_clearance;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// What measuring the gaps between objects that are near each other may cost, in gaps of two boxes.
const GAPS: usize = 2_000_000;
/// The same where the gaps are followed while objects move.
pub const GAPS_FOLLOWED: usize = 400_000;
/// What trying all parts that open may cost, in looks at a pose.
const SWEEPS: usize = 4_000_000;
/// So many violations of a rule are listed, those that fail most.
pub const LISTED: usize = 1_000;
/// Of no more pairs than this those that hold are listed, where all that holds is to be listed.
const PAIRS_LISTED: usize = 100_000;

pub(super) fn judge(program: &Program, world: &World<f64>, verdict: &mut CheckVerdict) {
    let rules = Rules::new(program, world);
    let near = pairs_up_to(world, rules.reach(), GAPS);
    let (total, there) = rules.pairs(world);
    let everything: Vec<(ObjectId, ObjectId)>;
    // Pairs that are not near each other hold without a look.
    let listed = world.options.detail.all && near.complete && total <= PAIRS_LISTED;
    let pairs: &[(ObjectId, ObjectId)] = if listed {
        everything = ids(program).flat_map(|a| (0..a.0).map(move |b| (ObjectId(b), a))).collect();
        &everything
    } else {
        &near.pairs
    };
    let (mut judged, mut violations) = (0, Worst::default());
    for &(a, b) in pairs.iter().filter(|(a, b)| rules.scope.collide(*a, *b)) {
        judged += 1;
        if listed {
            let found = rules.collision(world, a, b);
            violations.count += usize::from(found.holds == Some(false));
            verdict.rows.extend(found.row);
        } else if let Ok(truth) = collide::pair(world, a, b)
            && !truth.holds
        {
            violations.add(truth.margin, (a, b));
        }
    }
    let rest = violations.count - violations.kept.len();
    verdict.unlisted.failing += if listed { 0 } else { rest };
    verdict.rows.extend(violations.sorted().into_iter().filter_map(|(a, b)| rules.collision(world, a, b).row));
    let holding = if near.complete { there } else { judged } - violations.count;
    verdict.unlisted.holding += if world.options.detail.all && !listed { holding } else { 0 };
    verdict.summary.physical.total += total;
    verdict.summary.physical.satisfied += holding;
    let first = verdict.rows.len();
    for id in ids(program).filter(|id| rules.bounds(*id)) {
        let found = rules.bounded(world, id);
        verdict.summary.physical.add(found.holds);
        verdict.rows.extend(found.row);
    }
    verdict.unlisted.failing += keep_worst(&mut verdict.rows, first);
    let first = verdict.rows.len();
    let mut columns: Option<Columns> = None;
    let mut neighbours: Vec<Vec<ObjectId>> = vec![Vec::new(); program.objects.len()];
    for &(a, b) in &near.pairs {
        neighbours[a.0 as usize].push(b);
        neighbours[b.0 as usize].push(a);
    }
    let mut unasked = 0;
    for id in ids(program).filter(|id| rules.scope.support(*id) != Support::Lifted) {
        let mut others = || {
            let found = near.complete.then(|| columns.get_or_insert_with(|| Columns::new(world)).of(id)).flatten();
            unasked += usize::from(found.is_none());
            found
        };
        let found = rules.supported(world, id, &neighbours[id.0 as usize], &mut others);
        verdict.summary.physical.add(found.holds);
        verdict.rows.extend(found.row);
    }
    verdict.unlisted.failing += keep_worst(&mut verdict.rows, first);
    let untried = judge_opening(program, world, &rules, verdict);
    if untried > 0 {
        let parts = if untried == 1 { "part" } else { "parts" };
        let say = format!("there are too many obstacles: it was not checked whether {untried} {parts} can open");
        verdict.diagnostics.push(too_dense(program, say));
    }
    if !near.complete {
        let say = format!("too many objects overlap: {} of {there} pairs were not checked", there - judged);
        verdict.diagnostics.push(too_dense(program, say));
    } else if unasked > 0 {
        let say = format!(
            "too many objects are above one another: it was not checked whether {unasked} of them are supported"
        );
        verdict.diagnostics.push(too_dense(program, say));
    }
}

/// P-OPEN of every part that has to open; how many of them were not tried, there being too many.
fn judge_opening(program: &Program, world: &World<f64>, rules: &Rules<'_>, verdict: &mut CheckVerdict) -> usize {
    let first = verdict.rows.len();
    let (mut left, mut untried) = (SWEEPS, 0);
    for id in ids(program) {
        for (part, _) in open::demands(world, id) {
            if left == 0 {
                untried += 1;
                continue;
            }
            let before = left.min(LOOKS);
            let mut looks = before;
            let found = rules.opened(world, id, part, &mut looks);
            left -= before - looks;
            verdict.summary.physical.add(found.holds);
            verdict.rows.extend(found.row);
        }
    }
    verdict.unlisted.failing += keep_worst(&mut verdict.rows, first);
    untried
}

/// That there is too much in one place.
pub fn too_dense(program: &Program, say: String) -> Diagnostic {
    let note = "move them apart, or allow overlaps with `allowCollide`";
    match program.objects.first() {
        Some(first) => Diagnostic::new(codes::E0005, first.span, say).note(note),
        None => Diagnostic::without_place(codes::E0005, say).note(note),
    }
}

/// The pairs that fail most, and how many fail.
#[derive(Default)]
struct Worst {
    /// The one that fails least on top.
    kept: BinaryHeap<Failing>,
    count: usize,
}

/// A pair that fails, ordered by its margin; of the same margin by its objects.
struct Failing(f64, (ObjectId, ObjectId));

impl Ord for Failing {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.total_cmp(&other.0).then(self.1.cmp(&other.1))
    }
}

impl PartialOrd for Failing {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Failing {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Failing {}

impl Worst {
    fn add(&mut self, margin: f64, pair: (ObjectId, ObjectId)) {
        self.count += 1;
        self.kept.push(Failing(margin, pair));
        if self.kept.len() > LISTED {
            self.kept.pop();
        }
    }

    fn sorted(&self) -> Vec<(ObjectId, ObjectId)> {
        let mut pairs: Vec<_> = self.kept.iter().map(|Failing(_, pair)| *pair).collect();
        pairs.sort_unstable();
        pairs
    }
}

/// Keeps of the rows from `first` on those that fail most, and all that do not fail; returns how many are left out.
pub(super) fn keep_worst(rows: &mut Vec<Judged>, first: usize) -> usize {
    let margin = |row: &Judged| row.margin.map_or(f64::NEG_INFINITY, |(margin, _)| margin);
    let mut failing: Vec<(f64, usize)> = Vec::new();
    for (index, row) in rows.iter().enumerate().skip(first).filter(|(_, row)| row.satisfied == Some(false)) {
        failing.push((margin(row), index));
    }
    if failing.len() <= LISTED {
        return 0;
    }
    failing.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let dropped: FxHashSet<usize> = failing.drain(LISTED..).map(|(_, index)| index).collect();
    let mut index = 0;
    rows.retain(|_| {
        index += 1;
        !dropped.contains(&(index - 1))
    });
    dropped.len()
}

fn ids(program: &Program) -> impl Iterator<Item = ObjectId> + use<> {
    (0..program.objects.len() as u32).map(ObjectId)
}

/// What a rule says: whether it holds (`None`: it cannot be judged), and its row, if that is listed.
pub struct Ruled {
    /// Whether it holds.
    pub holds: Option<bool>,
    pub row: Option<Judged>,
}

/// The rules for one program, and for the instances of it that have the same objects and regions.
pub struct Rules<'a> {
    program: &'a Program,
    /// What each of them speaks of.
    pub scope: Scope,
    /// Whether the layout has all objects, and all regions.
    complete: bool,
    enclosed: bool,
    /// See [`Rules::reach`].
    reach: f64,
}

impl<'a> Rules<'a> {
    /// For an instance of a program.
    pub fn new(program: &'a Program, world: &World<f64>) -> Self {
        Self {
            program,
            scope: Scope::new(world),
            complete: world.missing_object().is_none(),
            enclosed: world.missing_region().is_none(),
            reach: world.options.tolerances.support + world.options.tolerances.order,
        }
    }

    /// Objects that are further apart than this (metres) have nothing to do with each other, unless one hovers.
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// Of how many pairs P-COLLIDE speaks, and how many of these are there.
    pub fn pairs(&self, world: &World<f64>) -> (usize, usize) {
        let count = |filter: &dyn Fn(ObjectId) -> bool| self.scope.pairs(self.program.objects.len(), filter);
        (count(&|_| true), count(&|id| world.object(id).is_ok()))
    }

    /// Whether P-BOUNDS speaks of an object.
    pub fn bounds(&self, id: ObjectId) -> bool {
        !self.program.regions.is_empty() && self.scope.bounds(id)
    }

    fn name(&self, id: ObjectId) -> &str {
        &self.program.objects[id.0 as usize].name
    }

    /// P-COLLIDE of a pair that it speaks of.
    pub fn collision(&self, world: &World<f64>, a: ObjectId, b: ObjectId) -> Ruled {
        let outcome = collide::pair(world, a, b).ok();
        let (a, b) = if self.name(a) <= self.name(b) { (a, b) } else { (b, a) };
        let text = || format!("`{}` and `{}` do not collide", self.name(a), self.name(b));
        self.ruled(world, (RowKind::Collision, Subject::Pair(a, b)), outcome, None, text, || {
            match (world.object(a), world.object(b)) {
                (Ok(x), Ok(y)) => builtins::gap_in_words(self.name(a), self.name(b), builtins::gap(x, y)),
                _ => "cannot be checked: the layout lacks an object".to_owned(),
            }
        })
    }

    /// P-BOUNDS of an object that it speaks of.
    pub fn bounded(&self, world: &World<f64>, id: ObjectId) -> Ruled {
        let best = bounds::best(world, id).ok();
        // A region that is missing could hold it.
        let outcome = best.map(|(_, truth)| truth).filter(|t| t.holds || self.enclosed);
        let text = || format!("`{}` is inside a region", self.name(id));
        self.ruled(world, (RowKind::Bounds, Subject::Object(id)), outcome, None, text, || {
            let (Some((Some(region), truth)), Ok(thing)) = (best, world.object(id)) else {
                return String::new();
            };
            let region_name = &self.program.regions[region.0 as usize].name;
            if truth.holds {
                return format!("it is inside `{region_name}`");
            }
            let mut far = truth.margin.abs();
            let place = world.region(region).map_or("a wall", |room| {
                let inside = inside_clearance(&thing.body.obb, &room.prism);
                far = far.max(-inside.least());
                if inside.least() == inside.horizontal.value {
                    "a wall"
                } else if inside.least() == inside.floor {
                    "the floor"
                } else {
                    "the ceiling"
                }
            });
            let (name, allowed) = (self.name(id), far - truth.margin.abs());
            let metres = |x: f64| number(x, Unit::Metre);
            let allowed = match allowed > 1e-9 {
                true => format!(" ({} m is allowed)", metres(allowed)),
                false => String::new(),
            };
            let far = metres(far);
            format!("`{name}` extends {far} m beyond {place} of `{region_name}`, the nearest region{allowed}")
        })
    }

    /// P-SUPPORT of an object that it does not lift. `neighbours` are others within reach: all of them, or `others`
    /// gives nothing. That gives all that are over or under the object, unless that is too much.
    pub fn supported(
        &self,
        world: &World<f64>,
        id: ObjectId,
        neighbours: &[ObjectId],
        others: &mut dyn FnMut() -> Option<Vec<ObjectId>>,
    ) -> Ruled {
        let how = self.scope.support(id);
        let outcome = match how {
            Support::Lifted | Support::Held => world.object(id).map(|_| Truth::discrete(true)),
            Support::Mounted => mounted(world, id),
            Support::Rests => support::among(world, id, neighbours),
        };
        let mut outcome = outcome.ok();
        let mut rest = None;
        if outcome.is_some_and(|t| !t.holds) {
            // What fails among its neighbours fails among all: then all say by how much.
            rest = others().and_then(|others| support::rest(world, id, &others).ok());
            if how == Support::Rests {
                outcome = rest.as_ref().map(|rest| rest.truth(&world.options.tolerances));
            }
        }
        // What is missing could carry it.
        let known = how != Support::Rests || (self.complete && self.enclosed);
        let outcome = outcome.filter(|t| t.holds || known);
        let text = || format!("`{}` is supported", self.name(id));
        self.ruled(world, (RowKind::Support, Subject::Object(id)), outcome, rest.as_ref(), text, || match how {
            Support::Mounted => "it does not touch the wall or ceiling that it is mounted on".to_owned(),
            Support::Held => "its container holds it".to_owned(),
            _ => {
                let rest = rest.clone().or_else(|| support::rest(world, id, neighbours).ok());
                rest.map_or(String::new(), |rest| self.resting(&rest))
            }
        })
    }

    /// P-OPEN of a part that has to open, with no more than so many looks at poses.
    pub fn opened(&self, world: &World<f64>, id: ObjectId, part: u8, looks: &mut usize) -> Ruled {
        let before = *looks;
        let outcome = open::part_within(world, id, part, looks).ok();
        let (joint, demand) = (opening::joints(world, id).get(usize::from(part)), demand(world, id, part));
        let name = joint.map_or("", |joint| joint.name.as_str());
        let amount = joint.map_or(String::new(), |joint| opening::amount(demand, joint.motion));
        let met = outcome.filter(|t| t.margin.is_finite()).and_then(|_| open::met(world, id, part));
        let text = || format!("`{name}` of `{}` opens {amount}", self.name(id));
        let mut ruled = self.ruled(world, (RowKind::Open, Subject::Part(id, part)), outcome, None, text, || {
            let what = met.map_or(String::new(), |met| opening::met_in_words(self.program, met));
            match outcome {
                Some(truth) if !truth.holds => {
                    let mut looks = before;
                    let free =
                        opening::free(world, id, usize::from(part), demand, &mut looks).map_or(0.0, |(free, _)| free);
                    let [free, amount] =
                        joint.map_or_else(Default::default, |j| opening::amounts(free, demand, j.motion));
                    format!("`{name}` of `{}` opens {free} of {amount}, then hits {what}", self.name(id))
                }
                Some(truth) if truth.margin.is_finite() => {
                    let gap = truth.margin - world.options.tolerances.contact;
                    format!("`{name}` opens {amount}, {} m from {what}", number(gap.max(0.0), Unit::Metre))
                }
                _ => format!("`{name}` opens {amount}"),
            }
        });
        if let (Some(row), Some(Met::Object(other))) = (&mut ruled.row, met) {
            row.objects.push(other);
            if row.satisfied == Some(false) {
                row.related = declarations(self.program, world, &row.objects);
            }
        }
        ruled
    }

    /// The row is there if the rule fails or all are wanted; `rest` says how its object rests, `measured` what was measured.
    fn ruled(
        &self,
        world: &World<f64>,
        (kind, subject): (RowKind, Subject),
        outcome: Option<Truth<f64>>,
        rest: Option<&Rest>,
        text: impl FnOnce() -> String,
        measured: impl FnOnce() -> String,
    ) -> Ruled {
        let holds = outcome.map(|t| t.holds);
        if holds != Some(false) && !world.options.detail.all {
            return Ruled { holds, row: None };
        }
        let objects = match subject {
            Subject::Pair(a, b) => vec![a, b],
            Subject::Object(a) | Subject::Part(a, _) => vec![a],
            Subject::Statement(_) => Vec::new(),
        };
        let fails = holds == Some(false);
        let related = if fails { declarations(self.program, world, &objects) } else { Vec::new() };
        let place = self.program.objects[objects[0].0 as usize].span;
        let margin = outcome.filter(|t| t.margin.is_finite()).map(|t| (t.margin, t.unit));
        let explanation = outcome.filter(|_| fails).map(|truth| {
            let measured = explain::of_rule(world, kind, truth.margin, rest);
            Box::new(Explanation { measured, ..Explanation::default() })
        });
        let row = Judged {
            kind,
            subject,
            satisfied: holds,
            margin,
            objects,
            text: text(),
            measured: measured(),
            place,
            related,
            weight: None,
            guideline: None,
            requirements: Vec::new(),
            code: kind.code(),
            explanation,
        };
        Ruled { holds, row: Some(row) }
    }

    /// How an object rests, in words.
    fn resting(&self, rest: &Rest) -> String {
        let on = rest.carrier.map_or("the floor".to_owned(), |id| format!("`{}`", self.name(id)));
        let metres = |x: f64| format!("{} m", number(x, Unit::Metre));
        match rest.off {
            Some(off) if off > 0.0 => format!("its centre is {} outside its area of contact with {on}", metres(off)),
            Some(_) => format!("it rests on {on}"),
            None if rest.lowest > rest.nearest => {
                format!("it is {} above {on}", metres(rest.lowest - rest.nearest))
            }
            None => format!("it reaches {} below the top of {on}", metres(rest.nearest - rest.lowest)),
        }
    }
}

/// How far a part has to open (degrees or metres).
fn demand(world: &World<f64>, id: ObjectId, part: u8) -> f64 {
    open::demands(world, id).into_iter().find(|(index, _)| *index == part).map_or(0.0, |(_, amount)| amount)
}

fn mounted(world: &World<f64>, id: ObjectId) -> Result<Truth<f64>, Cause> {
    mounts(&world.allow, id).try_fold(Truth::discrete(false), |best, mount| {
        judge_formula(&mount.formula, world).map(|t| best.or(t)).map_err(|EvalError { cause, .. }| cause)
    })
}
