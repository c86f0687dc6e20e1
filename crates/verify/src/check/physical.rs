//! The physical rules over a whole layout. Rows for what fails; on request for everything.
//!
//! A row is null, not failed, where its object is missing, or where something that is missing could make it hold.

use super::describe::{declarations, number};
use super::{Judged, Subject, Verdict};
use crate::eval::{Cause, EvalError, Truth, judge as judge_formula};
use crate::explain::{self, Explanation};
use crate::natives;
use crate::report::model::Kind;
use crate::rules::support::{self, Rest};
use crate::rules::{Scope, Support, bounds, collide, mounts, pairs_within};
use crate::world::World;
use scenelang_lang::program::{ObjectId, Program, Unit};
use scenelang_layout::inside_clearance;

pub(super) fn judge(program: &Program, world: &World<f64>, verdict: &mut Verdict) {
    let scope = Scope::new(world);
    let near = pairs_within(world, world.options.tolerances.support + world.options.tolerances.order);
    let mut rows = Rows {
        program,
        world,
        verdict,
        complete: world.missing_object().is_none(),
        enclosed: world.missing_region().is_none(),
    };
    collisions(&mut rows, &scope, &near);
    if !program.regions.is_empty() {
        for id in ids(program).filter(|id| scope.bounds(*id)) {
            bounded(&mut rows, id);
        }
    }
    let mut neighbours: Vec<Vec<ObjectId>> = vec![Vec::new(); program.objects.len()];
    for &(a, b) in &near {
        neighbours[a.0 as usize].push(b);
        neighbours[b.0 as usize].push(a);
    }
    for id in ids(program) {
        let how = scope.support(id);
        let outcome = match how {
            Support::Lifted => continue,
            Support::Held => world.object(id).map(|_| Truth::discrete(true)),
            Support::Mounted => mounted(world, id),
            // What fails among its neighbours fails among all: then all say by how much.
            Support::Rests => match support::among(world, id, &neighbours[id.0 as usize]) {
                Ok(truth) if !truth.holds => support::object(world, id),
                outcome => outcome,
            },
        };
        supported(&mut rows, id, outcome, how);
    }
}

fn ids(program: &Program) -> impl Iterator<Item = ObjectId> + use<> {
    (0..program.objects.len() as u32).map(ObjectId)
}

struct Rows<'a> {
    program: &'a Program,
    world: &'a World<f64>,
    verdict: &'a mut Verdict,
    /// Whether the layout has all objects, and all regions.
    complete: bool,
    enclosed: bool,
}

impl Rows<'_> {
    fn name(&self, id: ObjectId) -> &str {
        &self.program.objects[id.0 as usize].name
    }
    /// Adds a row if it fails or all are wanted; `measured` says what was measured.
    fn list(
        &mut self,
        kind: Kind,
        subject: Subject,
        outcome: Option<Truth<f64>>,
        text: impl FnOnce(&Self) -> String,
        measured: impl FnOnce(&Self) -> String,
    ) {
        let satisfied = outcome.map(|t| t.holds);
        if satisfied != Some(false) && !self.world.options.detail.all {
            return;
        }
        let objects = match subject {
            Subject::Pair(a, b) => vec![a, b],
            Subject::Object(a) => vec![a],
            Subject::Statement(_) => Vec::new(),
        };
        let (text, measured) = (text(self), measured(self));
        let fails = satisfied == Some(false);
        let related = if fails { declarations(self.program, self.world, &objects) } else { Vec::new() };
        let place = self.program.objects[objects[0].0 as usize].span;
        let margin = outcome.filter(|t| t.margin.is_finite()).map(|t| (t.margin, t.unit));
        let requirements = Vec::new();
        let explanation = outcome.filter(|_| fails).map(|truth| {
            let measured = explain::of_rule(self.world, kind, subject, truth.margin);
            Box::new(Explanation { measured, ..Explanation::default() })
        });
        self.verdict.rows.push(Judged {
            kind,
            subject,
            satisfied,
            margin,
            objects,
            text,
            measured,
            place,
            related,
            weight: None,
            requirements,
            code: kind.code(),
            explanation,
        });
    }
}

fn collisions(rows: &mut Rows<'_>, scope: &Scope, near: &[(ObjectId, ObjectId)]) {
    let world = rows.world;
    let everything: Vec<(ObjectId, ObjectId)>;
    // Pairs that are not near each other hold without a look.
    let pairs: &[(ObjectId, ObjectId)] = if world.options.detail.all {
        everything = ids(rows.program).flat_map(|a| (0..a.0).map(move |b| (ObjectId(b), a))).collect();
        &everything
    } else {
        near
    };
    let mut violations = 0;
    for &(a, b) in pairs.iter().filter(|(a, b)| scope.collide(*a, *b)) {
        let outcome = collide::pair(world, a, b).ok();
        violations += usize::from(outcome.is_some_and(|t| !t.holds));
        let (a, b) = if rows.name(a) <= rows.name(b) { (a, b) } else { (b, a) };
        let text = |rows: &Rows<'_>| format!("`{}` and `{}` do not collide", rows.name(a), rows.name(b));
        rows.list(Kind::Collision, Subject::Pair(a, b), outcome, text, |rows| {
            match (world.object(a), world.object(b)) {
                (Ok(x), Ok(y)) => natives::gap_in_words(rows.name(a), rows.name(b), natives::gap(x, y)),
                _ => "cannot be judged: the layout lacks an object".to_owned(),
            }
        });
    }
    let count = |filter: &dyn Fn(ObjectId) -> bool| scope.pairs(rows.program.objects.len(), filter);
    let physical = &mut rows.verdict.summary.physical;
    physical.total += count(&|_| true);
    physical.satisfied += count(&|id| world.object(id).is_ok()) - violations;
}

fn bounded(rows: &mut Rows<'_>, id: ObjectId) {
    let world = rows.world;
    let best = bounds::best(world, id).ok();
    // A region that is missing could hold it.
    let outcome = best.map(|(_, truth)| truth).filter(|t| t.holds || rows.enclosed);
    rows.verdict.summary.physical.add(outcome.map(|t| t.holds));
    let text = |rows: &Rows<'_>| format!("`{}` is inside a region", rows.name(id));
    rows.list(Kind::Bounds, Subject::Object(id), outcome, text, |rows| {
        let (Some((Some(region), truth)), Ok(thing)) = (best, world.object(id)) else {
            return String::new();
        };
        let region_name = &rows.program.regions[region.0 as usize].name;
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
    });
}

fn mounted(world: &World<f64>, id: ObjectId) -> Result<Truth<f64>, Cause> {
    mounts(&world.allow, id).try_fold(Truth::discrete(false), |best, mount| {
        judge_formula(&mount.formula, world).map(|t| best.or(t)).map_err(|EvalError { cause, .. }| cause)
    })
}

fn supported(rows: &mut Rows<'_>, id: ObjectId, outcome: Result<Truth<f64>, Cause>, how: Support) {
    let world = rows.world;
    // What is missing could carry it.
    let known = how != Support::Rests || (rows.complete && rows.enclosed);
    let outcome = outcome.ok().filter(|t| t.holds || known);
    rows.verdict.summary.physical.add(outcome.map(|t| t.holds));
    let text = |rows: &Rows<'_>| format!("`{}` is supported", rows.name(id));
    rows.list(Kind::Support, Subject::Object(id), outcome, text, |rows| match how {
        Support::Mounted => "it does not touch the wall or ceiling that it is mounted on".to_owned(),
        Support::Held => "its container holds it".to_owned(),
        _ => support::rest(world, id, &support::others(world, id)).map_or(String::new(), |rest| resting(rows, &rest)),
    });
}

/// How an object rests, in words.
fn resting(rows: &Rows<'_>, rest: &Rest) -> String {
    let on = rest.carrier.map_or("the floor".to_owned(), |id| format!("`{}`", rows.name(id)));
    let metres = |x: f64| format!("{} m", number(x, Unit::Metre));
    match rest.off {
        Some(off) if off > 0.0 => format!("its centre is {} beyond what carries it, on {on}", metres(off)),
        Some(_) => format!("it rests on {on}"),
        None if rest.lowest > rest.nearest => format!("it hovers {} above {on}", metres(rest.lowest - rest.nearest)),
        None => format!("it reaches {} below the top of {on}", metres(rest.nearest - rest.lowest)),
    }
}
