//! After the search: the layout with clean numbers, and what does not hold in it.

use crate::problem::pose::round_to;
use crate::problem::setup::Setup;
use crate::problem::{Standing, TermSubject, Unsatisfied};
use scenelang_engine::candidate::Candidate;
use scenelang_engine::frame::checks::Check;
use scenelang_lang::program::{ConstraintKind, ObjectId, Owner, Pinned, RegionId};
use scenelang_layout::{DecisionValue, Layout, Vec3, digits};
use scenelang_verify::opening::Met;
use scenelang_verify::{Options, Truth, World, judge, rules};
use smol_str::SmolStr;
use std::collections::BTreeSet;

/// Digits of what would fail with as few as are usual (metres and degrees).
const FINE: f64 = 1e-6;

/// The layout of a state, in numbers of few digits where that does no harm.
pub(crate) fn layout(
    setup: &Setup<'_>,
    state: &Candidate<'_>,
    options: &Options,
) -> (Layout, (Vec<Unsatisfied>, Vec<Standing>)) {
    let judged = |layout: Layout| {
        let found = unsatisfied(setup, &layout, options);
        (layout, found)
    };
    // To judge is dear where ways are looked for: where no more fails than the search says, once is enough.
    let failing = (0..state.numbering.len()).filter(|&check| !state.does_hold(check));
    // Parts of one statement fail as one: else a preference with several would hide what fails for want of digits.
    let whole = |check: usize| match state.numbering.check(check) {
        Check::Term(term) if setup.frame.terms[term].opens.is_none() => (true, setup.frame.terms[term].constraint),
        _ => (false, check),
    };
    let expected = failing.map(whole).collect::<BTreeSet<_>>().len();
    let mut best = judged(compose(setup, state, |_, x| round_to(x, digits::STEP)));
    // What fails may fail for want of digits. So what it speaks of gets more of them, then everything.
    let concerned = concerned(setup, &best.1.0);
    let is_far = |who: Who| matches!(who, Who::Object(id) if !concerned.contains(&id));
    let finer: [&dyn Fn(Who, f64) -> f64; 3] =
        [&|who, x| round_to(x, if is_far(who) { digits::STEP } else { FINE }), &|_, x| round_to(x, FINE), &|_, x| x];
    for cut in finer {
        if best.1.0.len() <= expected {
            break;
        }
        let next = judged(compose(setup, state, cut));
        if next.1.0.len() < best.1.0.len() {
            best = next;
        }
    }
    best
}

/// Whose numbers are cut.
#[derive(Clone, Copy)]
pub(crate) enum Who {
    /// Those of an object.
    Object(ObjectId),
    /// Those of a region or a variable.
    Other,
}

/// The objects that something is said of which does not hold.
fn concerned(setup: &Setup<'_>, unsatisfied: &[Unsatisfied]) -> BTreeSet<ObjectId> {
    let mut found = BTreeSet::new();
    for each in unsatisfied {
        let names: Vec<&SmolStr> = match &each.what {
            TermSubject::Stated(index) => {
                found.extend(setup.frame.program.constraints[*index].formula.objects());
                continue;
            }
            TermSubject::Collision(a, b) => vec![a, b],
            TermSubject::Open(a, met) => std::iter::once(a).chain(met).collect(),
            TermSubject::Bounds(a) | TermSubject::Support(a) => vec![a],
        };
        found.extend(setup.frame.objects().filter(|id| names.iter().any(|name| *name == setup.frame.name(*id))));
    }
    found
}

/// The layout of a state, its numbers cut, but for what the program assigns and what has not moved.
pub(crate) fn compose(setup: &Setup<'_>, state: &Candidate<'_>, cut: impl Fn(Who, f64) -> f64) -> Layout {
    let mut layout = setup.layout.clone();
    let vec = |who: Who, now: Vec3, before: Vec3, pinned: bool| {
        if pinned || now == before { now } else { now.map(|x| cut(who, x)) }
    };
    for (id, (_, placement)) in state.frame.objects().zip(&mut layout.objects) {
        let pose = state.pose(id);
        let pinned =
            |property| state.frame.program.pins.iter().any(|p| p.owner == Owner::Object(id) && p.property == property);
        let who = Who::Object(id);
        placement.pos = vec(who, pose.pos, placement.pos, pinned(Pinned::Pos));
        placement.rot = vec(who, pose.rot, placement.rot, pinned(Pinned::Rot));
        // Parts are made for one size.
        placement.scale = pose.scale;
    }
    for (index, (_, placement)) in layout.regions.iter_mut().enumerate() {
        let (pose, pins) = (state.region_pose(RegionId(index as u32)), state.frame.region_pins[index]);
        placement.pos = vec(Who::Other, pose.pos, placement.pos, pins.pos);
        placement.rot = vec(Who::Other, pose.rot, placement.rot, pins.rot);
        placement.scale = vec(Who::Other, pose.scale, placement.scale, pins.scale);
    }
    for (id, (_, value)) in scenelang_engine::frame::variables(state.frame.program).zip(&mut layout.variables) {
        *value = match state.world().variable(id) {
            Ok(scenelang_verify::Value::Number(n)) => DecisionValue::Number(cut(Who::Other, n)),
            Ok(scenelang_verify::Value::Vector(v) | scenelang_verify::Value::Rotation(v)) => {
                DecisionValue::Triple(v.0.map(|x| cut(Who::Other, x)))
            }
            Ok(scenelang_verify::Value::Truth(t)) => DecisionValue::Bool(t.holds),
            Err(_) => *value,
        };
    }
    layout
}

/// What does not hold in a layout: stated constraints in order, then physical rules.
pub(crate) fn unsatisfied(setup: &Setup<'_>, layout: &Layout, options: &Options) -> (Vec<Unsatisfied>, Vec<Standing>) {
    let program = setup.frame.program;
    let world = World::<f64>::new(program, layout, options);
    let mut found = Vec::new();
    let mut standings = Vec::new();
    let mut note = |what: TermSubject, truth: Option<Truth<f64>>| {
        if truth.is_none_or(|t| !t.holds) {
            found.push(Unsatisfied { what, margin: truth.map(|t| t.margin).filter(|m| m.is_finite()) });
        }
    };
    for (index, constraint) in program.constraints.iter().enumerate() {
        let truth = judge(&constraint.formula, &world).ok();
        let margin = truth.map(|t| t.margin).filter(|m| m.is_finite());
        standings.push(Standing { holds: truth.is_some_and(|t| t.holds), margin });
        note(TermSubject::Stated(index), truth);
    }
    if let Some(scope) = &setup.frame.scope {
        let name = |id| setup.frame.name(id).into();
        for (a, b) in rules::pairs_within(&world, 0.0) {
            if scope.collide(a, b) {
                note(TermSubject::Collision(name(a), name(b)), rules::collide::pair(&world, a, b).ok());
            }
        }
        for id in setup.frame.objects() {
            if scope.bounds(id) && !program.regions.is_empty() {
                note(TermSubject::Bounds(name(id)), rules::bounds::object(&world, id).ok());
            }
            match scope.support(id) {
                rules::Support::Rests => note(TermSubject::Support(name(id)), rules::support::object(&world, id).ok()),
                rules::Support::Mounted => {
                    for mount in rules::mounts(&program.allow, id) {
                        note(TermSubject::Support(name(id)), judge(&mount.formula, &world).ok());
                    }
                }
                rules::Support::Lifted | rules::Support::Held => {}
            }
            for (part, _) in rules::open::demands(&world, id) {
                let truth = rules::open::part(&world, id, part).ok();
                if truth.is_none_or(|t| !t.holds) {
                    note(TermSubject::Open(name(id), met(&world, setup, id, part)), truth);
                }
            }
        }
    }
    (found, standings)
}

/// The object that keeps a part of another from opening.
fn met(world: &World<f64>, setup: &Setup<'_>, id: ObjectId, part: u8) -> Option<SmolStr> {
    match rules::open::met(world, id, part) {
        Some(Met::Object(other)) => Some(setup.frame.name(other).into()),
        _ => None,
    }
}

/// Whether all of it is preferences.
pub(crate) fn is_soft(setup: &Setup<'_>, all: &[Unsatisfied]) -> bool {
    all.iter().all(|u| match u.what {
        TermSubject::Stated(index) => {
            matches!(setup.frame.program.constraints[index].kind, ConstraintKind::Prefer { .. })
        }
        _ => false,
    })
}

/// The stated constraints that must hold and do not, if they are all that is violated.
pub(crate) fn in_the_way(setup: &Setup<'_>, unsatisfied: &[Unsatisfied]) -> Vec<usize> {
    let mut found = Vec::new();
    for each in unsatisfied {
        match each.what {
            TermSubject::Stated(index) => {
                if !matches!(setup.frame.program.constraints[index].kind, ConstraintKind::Prefer { .. }) {
                    found.push(index);
                }
            }
            _ => return Vec::new(),
        }
    }
    found
}
