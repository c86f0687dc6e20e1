//! The physical rules over a whole layout. Rows for what fails; on request for everything.
//!
//! A row is null, not failed, where its object is missing, or where something that is missing could make it hold.

use super::describe::{declarations, number};
use super::{Judged, Subject, Verdict};
use crate::builtins;
use crate::eval::{Cause, EvalError, Truth, judge as judge_formula};
use crate::explain::{self, Explanation};
use crate::report::model::Kind;
use crate::rules::support::{self, Rest};
use crate::rules::{Scope, Support, bounds, collide, mounts, pairs_within};
use crate::world::World;
use scenelang_lang::program::{ObjectId, Program, Unit};
use scenelang_layout::inside_clearance;

pub(super) fn judge(program: &Program, world: &World<f64>, verdict: &mut Verdict) {
    let rules = Rules::new(program, world);
    let near = pairs_within(world, rules.reach());
    let everything: Vec<(ObjectId, ObjectId)>;
    // Pairs that are not near each other hold without a look.
    let pairs: &[(ObjectId, ObjectId)] = if world.options.detail.all {
        everything = ids(program).flat_map(|a| (0..a.0).map(move |b| (ObjectId(b), a))).collect();
        &everything
    } else {
        &near
    };
    let mut violations = 0;
    for &(a, b) in pairs.iter().filter(|(a, b)| rules.scope.collide(*a, *b)) {
        let found = rules.collision(world, a, b);
        violations += usize::from(found.holds == Some(false));
        verdict.rows.extend(found.row);
    }
    let physical = &mut verdict.summary.physical;
    let (total, judged) = rules.pairs(world);
    physical.total += total;
    physical.satisfied += judged - violations;
    for id in ids(program).filter(|id| rules.bounds(*id)) {
        let found = rules.bounded(world, id);
        verdict.summary.physical.add(found.holds);
        verdict.rows.extend(found.row);
    }
    let mut neighbours: Vec<Vec<ObjectId>> = vec![Vec::new(); program.objects.len()];
    for &(a, b) in &near {
        neighbours[a.0 as usize].push(b);
        neighbours[b.0 as usize].push(a);
    }
    for id in ids(program).filter(|id| rules.scope.support(*id) != Support::Lifted) {
        let found = rules.supported(world, id, &neighbours[id.0 as usize]);
        verdict.summary.physical.add(found.holds);
        verdict.rows.extend(found.row);
    }
}

pub(super) fn ids(program: &Program) -> impl Iterator<Item = ObjectId> + use<> {
    (0..program.objects.len() as u32).map(ObjectId)
}

/// What a rule says: whether it holds (`None`: it cannot be judged), and its row, if that is listed.
pub(super) struct Ruled {
    pub holds: Option<bool>,
    pub row: Option<Judged>,
}

/// The rules for one program, and for the instances of it that have the same objects and regions.
pub(super) struct Rules<'a> {
    program: &'a Program,
    pub scope: Scope,
    /// Whether the layout has all objects, and all regions.
    complete: bool,
    enclosed: bool,
    /// See [`Rules::reach`].
    reach: f64,
}

impl<'a> Rules<'a> {
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
        self.ruled(world, Kind::Collision, Subject::Pair(a, b), outcome, text, || {
            match (world.object(a), world.object(b)) {
                (Ok(x), Ok(y)) => builtins::gap_in_words(self.name(a), self.name(b), builtins::gap(x, y)),
                _ => "cannot be judged: the layout lacks an object".to_owned(),
            }
        })
    }

    /// P-BOUNDS of an object that it speaks of.
    pub fn bounded(&self, world: &World<f64>, id: ObjectId) -> Ruled {
        let best = bounds::best(world, id).ok();
        // A region that is missing could hold it.
        let outcome = best.map(|(_, truth)| truth).filter(|t| t.holds || self.enclosed);
        let text = || format!("`{}` is inside a region", self.name(id));
        self.ruled(world, Kind::Bounds, Subject::Object(id), outcome, text, || {
            let (Some((Some(region), truth)), Ok(thing)) = (best, world.object(id)) else {
                return String::new();
            };
            let region_name = &self.program.regions[region.0 as usize].name;
            let far = number(truth.margin.abs(), Unit::Metre);
            if truth.holds {
                return format!("it is inside `{region_name}`");
            }
            let place = world.region(region).map_or("a wall", |room| {
                let inside = inside_clearance(&thing.body.obb, &room.prism);
                if inside.least() == inside.horizontal.value {
                    "a wall"
                } else if inside.least() == inside.floor {
                    "the floor"
                } else {
                    "the ceiling"
                }
            });
            format!("it is beyond {place} of `{region_name}`, the nearest region, by {far} m more than allowed")
        })
    }

    /// P-SUPPORT of an object that it does not lift; `neighbours` are all others within reach.
    pub fn supported(&self, world: &World<f64>, id: ObjectId, neighbours: &[ObjectId]) -> Ruled {
        let how = self.scope.support(id);
        let outcome = match how {
            Support::Lifted | Support::Held => world.object(id).map(|_| Truth::discrete(true)),
            Support::Mounted => mounted(world, id),
            // What fails among its neighbours fails among all: then all say by how much.
            Support::Rests => match support::among(world, id, neighbours) {
                Ok(truth) if !truth.holds => support::object(world, id),
                outcome => outcome,
            },
        };
        // What is missing could carry it.
        let known = how != Support::Rests || (self.complete && self.enclosed);
        let outcome = outcome.ok().filter(|t| t.holds || known);
        let text = || format!("`{}` is supported", self.name(id));
        self.ruled(world, Kind::Support, Subject::Object(id), outcome, text, || match how {
            Support::Mounted => "it does not touch the wall or ceiling that it is mounted on".to_owned(),
            Support::Held => "its container holds it".to_owned(),
            _ => {
                let rest = support::rest(world, id, &support::others(world, id));
                rest.map_or(String::new(), |rest| self.resting(&rest))
            }
        })
    }

    /// The row is there if the rule fails or all are wanted; `measured` says what was measured.
    fn ruled(
        &self,
        world: &World<f64>,
        kind: Kind,
        subject: Subject,
        outcome: Option<Truth<f64>>,
        text: impl FnOnce() -> String,
        measured: impl FnOnce() -> String,
    ) -> Ruled {
        let holds = outcome.map(|t| t.holds);
        if holds != Some(false) && !world.options.detail.all {
            return Ruled { holds, row: None };
        }
        let objects = match subject {
            Subject::Pair(a, b) => vec![a, b],
            Subject::Object(a) => vec![a],
            Subject::Statement(_) => Vec::new(),
        };
        let fails = holds == Some(false);
        let related = if fails { declarations(self.program, world, &objects) } else { Vec::new() };
        let place = self.program.objects[objects[0].0 as usize].span;
        let margin = outcome.filter(|t| t.margin.is_finite()).map(|t| (t.margin, t.unit));
        let explanation = outcome.filter(|_| fails).map(|truth| {
            let measured = explain::of_rule(world, kind, subject, truth.margin);
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
            Some(off) if off > 0.0 => format!("its centre is {} beyond what carries it, on {on}", metres(off)),
            Some(_) => format!("it rests on {on}"),
            None if rest.lowest > rest.nearest => {
                format!("it hovers {} above {on}", metres(rest.lowest - rest.nearest))
            }
            None => format!("it reaches {} below the top of {on}", metres(rest.nearest - rest.lowest)),
        }
    }
}

fn mounted(world: &World<f64>, id: ObjectId) -> Result<Truth<f64>, Cause> {
    mounts(&world.allow, id).try_fold(Truth::discrete(false), |best, mount| {
        judge_formula(&mount.formula, world).map(|t| best.or(t)).map_err(|EvalError { cause, .. }| cause)
    })
}
