//! The stage on which moves are tried: the instance with a few objects moved, and what that does to which rows.
//!
//! Only rows that mention what was moved are judged again, with the pairs and supports around its old and its new place.

use super::index::Index;
use super::moves::Step;
use super::{DEAR, RowRef};
use crate::builtins::Call;
use crate::check::Subject;
use crate::eval::{Scratch, Truth, Value, judge};
use crate::number::{Dual, Number};
use crate::report::model::Kind;
use crate::rules::{Scope, Support, bounds, collide, mounts, support};
use crate::vector::V3;
use crate::world::World;
use rustc_hash::FxHashMap;
use scenelang_lang::program::{ConstraintKind, Node, NodeId, ObjectId, Owner, Pinned, Program};
use std::rc::Rc;

/// Derivatives by a move in x, y, z and a turn about the vertical (metres, degrees).
pub(super) type Slope = Dual<4>;

/// What is to hold: a row, or a part of a statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Goal {
    Row(RowRef),
    /// A node of the statement's formula.
    Part(usize, NodeId),
}

/// What a move does to the rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Consequences {
    /// Held, and fail.
    pub breaks: Vec<RowRef>,
    /// Failed, and hold.
    pub mends: Vec<RowRef>,
    /// Hold still, with less margin: which, and how much it falls; the greatest fall first.
    pub falls: Vec<(RowRef, f64)>,
}

impl Consequences {
    /// How many hard rows break, then how many preferences.
    pub fn harm(&self) -> (usize, usize) {
        let soft = self.breaks.iter().filter(|row| row.kind == Kind::Prefer).count();
        (self.breaks.len() - soft, soft)
    }
}

/// See the file.
pub(super) struct Stage<'a> {
    pub program: &'a Program,
    base: &'a World<f64>,
    moved: World<f64>,
    /// The same with derivatives, made when they are first asked for.
    dual: Option<World<Slope>>,
    /// Objects that are elsewhere there, or unknown.
    elsewhere: Vec<ObjectId>,
    /// Objects that are elsewhere on the stage than in the layout.
    off: Vec<ObjectId>,
    scope: Scope,
    index: Index,
    scratch: Scratch<f64>,
    slopes: Scratch<Slope>,
    before: FxHashMap<RowRef, Option<Truth<f64>>>,
    cones: FxHashMap<(usize, NodeId), Rc<[NodeId]>>,
    /// Work done, in small comparisons.
    pub work: usize,
    /// What may still be spent on dear rows.
    purse: usize,
}

impl<'a> Stage<'a> {
    /// Whoever tries out what is dear has so much to spend.
    pub fn new(program: &'a Program, base: &'a World<f64>, purse: usize) -> Self {
        Self {
            program,
            base,
            moved: base.clone(),
            dual: None,
            elsewhere: Vec::new(),
            off: Vec::new(),
            scope: Scope::new(base),
            index: Index::new(program),
            scratch: Scratch::new(),
            slopes: Scratch::new(),
            before: FxHashMap::default(),
            cones: FxHashMap::default(),
            work: 0,
            purse,
        }
    }

    /// The layout as it is.
    pub fn layout(&self) -> &'a World<f64> {
        self.base
    }

    /// The instance with what is moved.
    pub fn world(&self) -> &World<f64> {
        &self.moved
    }

    /// Moves an object from where the layout has it.
    pub fn put(&mut self, step: &Step) {
        let Ok(thing) = self.base.object(step.object) else { return };
        let (pos, rot) = (thing.pos.0, thing.rot.0);
        let pos = V3(std::array::from_fn(|i| pos[i] + step.by[i]));
        self.moved.place(step.object, pos, V3([rot[0], rot[1] + step.turn, rot[2]]), thing.scale);
        if !self.off.contains(&step.object) {
            self.off.push(step.object);
        }
    }

    /// The same, and with it what goes along.
    pub fn put_with(&mut self, step: &Step, riders: &[ObjectId]) {
        self.put(step);
        for &rider in riders {
            if let Some(step) = self.along(step, rider) {
                self.put(&step);
            }
        }
    }

    /// The step of an object that goes along with another.
    pub fn along(&self, leader: &Step, object: ObjectId) -> Option<Step> {
        let place = |id: ObjectId| self.base.object(id).ok().map(|thing| thing.pos.0);
        let (pivot, pos) = (place(leader.object)?, place(object)?);
        let (sin, cos) = scenelang_layout::rotation::sin_cos(leader.turn);
        let (x, z) = (pos[0] - pivot[0], pos[2] - pivot[2]);
        let [bx, by, bz] = leader.by;
        let by = [bx + cos * x + sin * z - x, by, bz + cos * z - sin * x - z];
        Some(Step { object, by, turn: leader.turn, with: Some(leader.object) })
    }

    /// Puts everything back, then these elsewhere.
    pub fn set(&mut self, steps: &[Step]) {
        for object in std::mem::take(&mut self.off) {
            self.put(&Step { object, by: [0.0; 3], turn: 0.0, with: None });
        }
        self.off.clear();
        steps.iter().for_each(|step| self.put(step));
    }

    fn pay(&mut self, cost: usize) {
        self.work += cost;
        if cost > DEAR {
            self.purse = self.purse.saturating_sub(cost);
        }
    }

    /// Whether so much work is done, or nothing is left for dear rows.
    pub fn has_spent(&self, limit: usize) -> bool {
        self.work >= limit || self.purse == 0
    }

    /// The verdict on a goal as things are on the stage; `None`: it cannot be judged.
    pub fn truth(&mut self, goal: Goal) -> Option<Truth<f64>> {
        self.pay(self.cost(goal));
        let cone = self.cone(goal);
        truth(self.program, &self.scope, &self.moved, &mut self.scratch, goal, cone.as_deref())
    }

    /// The derivatives of a goal's margin by moves of an object, with what goes along with it.
    pub fn slope(&mut self, goal: Goal, (object, riders): (ObjectId, &[ObjectId])) -> Option<[f64; 4]> {
        self.pay(3 * self.cost(goal));
        let cone = self.cone(goal);
        let pivot = self.moved.object(object).ok()?.pos.0;
        let dual = self.dual.get_or_insert_with(|| self.base.constant());
        // What was elsewhere the last time may be back in its place.
        let mut elsewhere = std::mem::take(&mut self.elsewhere);
        elsewhere.extend(self.off.iter().chain(riders).chain([&object]));
        elsewhere.sort_unstable();
        elsewhere.dedup();
        for &id in &elsewhere {
            let Ok(thing) = self.moved.object(id) else { continue };
            let [mut pos, mut rot, scale]: [V3<Slope>; 3] =
                [&thing.pos, &thing.rot, &thing.scale].map(|v| V3::constant(&v.value()));
            if id == object || riders.contains(&id) {
                let [x, z] = [0, 2].map(|i| (thing.pos.0[i] - pivot[i]).to_radians());
                for i in 0..3 {
                    pos.0[i].slope[i] = 1.0;
                }
                (pos.0[0].slope[3], pos.0[2].slope[3]) = (z, -x);
                rot.0[1].slope[3] = 1.0;
            }
            dual.place(id, pos, rot, scale);
        }
        let found = truth(self.program, &self.scope, dual, &mut self.slopes, goal, cone.as_deref());
        let kept = |id: &ObjectId| *id == object || riders.contains(id) || self.off.contains(id);
        elsewhere.retain(kept);
        self.elsewhere = elsewhere;
        Some(found?.margin.slope)
    }

    /// The objects that goals speak of, one apart.
    pub fn spoken_of(&self, goals: &[Goal], but: ObjectId) -> Vec<ObjectId> {
        let mut all = Vec::new();
        for goal in goals {
            match *goal {
                Goal::Part(index, _) | Goal::Row(RowRef { subject: Subject::Statement(index), .. }) => {
                    all.extend(self.program.constraints[index].formula.objects());
                }
                Goal::Row(RowRef { subject: Subject::Pair(a, b), .. }) => all.extend([a, b]),
                Goal::Row(RowRef { subject: Subject::Object(a), .. }) => all.push(a),
            }
        }
        all.retain(|id| *id != but);
        let mut known = rustc_hash::FxHashSet::default();
        all.retain(|id| known.insert(*id));
        all
    }

    /// Whether a row speaks of an object.
    pub fn is_about(&self, row: &RowRef, object: ObjectId) -> bool {
        match row.subject {
            Subject::Statement(index) => self.index.mentions(object, index),
            Subject::Pair(a, b) => a == object || b == object,
            Subject::Object(a) => a == object,
        }
    }

    /// Cheap rows that hold and speak of an object.
    pub fn kept(&mut self, object: ObjectId) -> Vec<Goal> {
        let mut rows: Vec<RowRef> =
            self.index.touched_by(&[object]).into_iter().map(|i| row_of(self.program, i)).collect();
        if self.base.options.physics {
            let own = Subject::Object(object);
            rows.push(RowRef { kind: Kind::Support, subject: own });
            if !self.program.regions.is_empty() && self.scope.bounds(object) {
                rows.push(RowRef { kind: Kind::Bounds, subject: own });
            }
        }
        rows.retain(|row| self.cost(Goal::Row(*row)) <= DEAR && self.before(*row).is_some_and(|t| t.holds));
        rows.into_iter().map(Goal::Row).collect()
    }

    /// The verdict on a row in the layout.
    fn before(&mut self, row: RowRef) -> Option<Truth<f64>> {
        if let Some(known) = self.before.get(&row) {
            return *known;
        }
        // Who asks first does not pay for others: what may be tried must not depend on what was asked before.
        let (work, goal) = (self.work, Goal::Row(row));
        self.pay(self.cost(goal));
        self.work = work;
        let found = truth(self.program, &self.scope, self.base, &mut self.scratch, goal, None);
        self.before.insert(row, found);
        found
    }

    /// What judging a goal costs, in small comparisons.
    pub fn cost(&self, goal: Goal) -> usize {
        match goal {
            Goal::Part(index, _) | Goal::Row(RowRef { subject: Subject::Statement(index), .. }) => {
                self.index.cost(index)
            }
            Goal::Row(RowRef { kind: Kind::Support, .. }) => 4 + self.program.objects.len() / 16,
            Goal::Row(_) => 2,
        }
    }

    fn cone(&mut self, goal: Goal) -> Option<Rc<[NodeId]>> {
        let Goal::Part(index, node) = goal else { return None };
        let formula = &self.program.constraints[index].formula;
        let make = || crate::eval::cone(formula, node).into();
        Some(Rc::clone(self.cones.entry((index, node)).or_insert_with(make)))
    }

    /// What decides a goal that fails: the node, if it is part of a statement, and the objects that have a say.
    pub fn deciding(&mut self, goal: Goal) -> Vec<ObjectId> {
        let (index, from) = match goal {
            Goal::Row(RowRef { subject: Subject::Statement(index), .. }) => {
                (index, self.program.constraints[index].formula.root)
            }
            Goal::Part(index, node) => (index, node),
            Goal::Row(RowRef { subject: Subject::Pair(a, b), .. }) => return vec![a, b],
            Goal::Row(RowRef { subject: Subject::Object(a), .. }) => return vec![a],
        };
        let formula = &self.program.constraints[index].formula;
        if self.scratch.evaluate(formula, &self.moved).is_err() {
            return Vec::new();
        }
        let node = self.scratch.deciding_from(formula, from);
        let mut objects = crate::eval::objects_of(formula, node);
        if let Node::BuiltIn(built_in, args) = formula.node(node) {
            let values = self.scratch.values();
            let call = Call { built_in: *built_in, args, values, world: &self.moved, node };
            objects.extend(call.in_the_way());
        }
        if objects.is_empty() {
            objects = crate::eval::objects_of(formula, from);
        }
        objects
    }

    /// The parts of a conjunction that fail, the one that fails most first; none of anything else.
    pub fn failing_parts(&mut self, goal: Goal) -> Vec<Goal> {
        let (index, from) = match goal {
            Goal::Row(RowRef { subject: Subject::Statement(index), .. }) => {
                (index, self.program.constraints[index].formula.root)
            }
            Goal::Part(index, node) => (index, node),
            Goal::Row(_) => return Vec::new(),
        };
        let formula = &self.program.constraints[index].formula;
        self.pay(self.index.cost(index));
        let Node::And(parts) = formula.node(from) else { return Vec::new() };
        if self.scratch.evaluate(formula, &self.moved).is_err() {
            return Vec::new();
        }
        let failing = parts.iter().filter_map(|&part| match self.scratch.get(part) {
            Ok(Value::Truth(t)) if !t.holds => Some((t.margin, part)),
            _ => None,
        });
        let mut failing: Vec<(f64, NodeId)> = failing.collect();
        failing.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        failing.into_iter().map(|(_, part)| Goal::Part(index, part)).collect()
    }

    /// The assignments that keep an object where it is and as it is turned, except those in some rows.
    pub fn pins(&self, object: ObjectId, except: &[RowRef]) -> [Option<usize>; 2] {
        let pin = |property: Pinned| {
            let own = |p: &&scenelang_lang::program::Pin| p.owner == Owner::Object(object) && p.property == property;
            let pins = self.program.pins.iter().filter(own).map(|p| p.constraint);
            pins.into_iter().find(|&c| !except.contains(&row_of(self.program, c)))
        };
        [pin(Pinned::Pos), pin(Pinned::Rot)]
    }

    /// What rests on an object, and on that.
    pub fn carried_by(&self, object: ObjectId) -> Vec<ObjectId> {
        const MOST: usize = 12;
        let mut found = vec![object];
        let mut next = 0;
        while let Some(&carrier) = found.get(next) {
            next += 1;
            let Ok(below) = self.base.object(carrier).map(|thing| thing.body.aabb()) else { continue };
            let near = |id: &ObjectId| self.base.object(*id).is_ok_and(|t| t.body.aabb().distance(&below) < 0.01);
            for id in support::others(self.base, carrier).into_iter().filter(near) {
                let rests = self.scope.support(id) == Support::Rests
                    && support::rest(self.base, id, &[carrier])
                        .is_ok_and(|r| r.carrier == Some(carrier) && r.off.is_some());
                if rests && !found.contains(&id) && found.len() <= MOST {
                    found.push(id);
                }
            }
        }
        found.split_off(1)
    }

    /// What the moves on the stage do to all rows that they touch, these objects being the ones moved.
    pub fn consequences(&mut self, moved: &[ObjectId]) -> Consequences {
        let mut out = Consequences::default();
        for row in self.touched(moved) {
            let before = self.before(row);
            let (Some(before), Some(after)) = (before, self.truth(Goal::Row(row))) else { continue };
            match (before.holds, after.holds) {
                (true, false) => out.breaks.push(row),
                (false, true) => out.mends.push(row),
                (true, true) if before.margin - after.margin > 1e-6 && after.margin.is_finite() => {
                    out.falls.push((row, before.margin - after.margin));
                }
                _ => {}
            }
        }
        let order = |row: &RowRef| (row.kind == Kind::Prefer, *row);
        out.breaks.sort_by_key(order);
        out.mends.sort_by_key(order);
        out.falls.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        out
    }

    /// The rows that moving these objects can change: cheap ones first.
    fn touched(&self, moved: &[ObjectId]) -> Vec<RowRef> {
        let mut rows: Vec<RowRef> = Vec::new();
        if self.base.options.physics {
            for &id in moved {
                if !self.program.regions.is_empty() && self.scope.bounds(id) {
                    rows.push(RowRef { kind: Kind::Bounds, subject: Subject::Object(id) });
                }
                rows.push(RowRef { kind: Kind::Support, subject: Subject::Object(id) });
                for other in self.around(id) {
                    rows.push(RowRef { kind: Kind::Support, subject: Subject::Object(other) });
                    if self.scope.collide(id, other) {
                        rows.push(RowRef { kind: Kind::Collision, subject: self.pair(id, other) });
                    }
                }
            }
            rows.sort_unstable();
            rows.dedup();
        }
        let mut stated = self.index.touched_by(moved);
        stated.sort_by_key(|&i| (self.index.cost(i), i));
        rows.extend(stated.into_iter().map(|i| row_of(self.program, i)));
        rows
    }

    fn pair(&self, a: ObjectId, b: ObjectId) -> Subject {
        let name = |id: ObjectId| &self.program.objects[id.0 as usize].name;
        if name(a) <= name(b) { Subject::Pair(a, b) } else { Subject::Pair(b, a) }
    }

    /// Objects next to the old or the new place of one.
    fn around(&self, id: ObjectId) -> Vec<ObjectId> {
        let reach = self.base.options.tolerances.support + self.base.options.tolerances.order;
        let boxes = [self.base, &self.moved].map(|world| world.object(id).map(|thing| thing.body.aabb()));
        let near = |other: &ObjectId| {
            let theirs = self.moved.object(*other).map(|thing| thing.body.aabb());
            boxes.iter().flatten().any(|own| theirs.as_ref().is_ok_and(|t| own.distance(t) <= reach))
        };
        support::others(&self.moved, id).into_iter().filter(near).collect()
    }
}

/// The row of a statement.
pub(super) fn row_of(program: &Program, constraint: usize) -> RowRef {
    let kind = match program.constraints[constraint].kind {
        ConstraintKind::Assert => Kind::Assert,
        ConstraintKind::Prefer { .. } => Kind::Prefer,
        ConstraintKind::Pin => Kind::Pin,
    };
    RowRef { kind, subject: Subject::Statement(constraint) }
}

/// The verdict on a goal in an instance, with any number.
fn truth<N: Number>(
    program: &Program,
    scope: &Scope,
    world: &World<N>,
    scratch: &mut Scratch<N>,
    goal: Goal,
    cone: Option<&[NodeId]>,
) -> Option<Truth<N>> {
    let value = match goal {
        Goal::Part(index, _) => scratch.evaluate_cone(&program.constraints[index].formula, cone?, world).ok()?,
        Goal::Row(RowRef { subject: Subject::Statement(index), .. }) => {
            scratch.evaluate(&program.constraints[index].formula, world).ok()?
        }
        Goal::Row(RowRef { subject: Subject::Pair(a, b), .. }) => return collide::pair(world, a, b).ok(),
        Goal::Row(RowRef { kind: Kind::Bounds, subject: Subject::Object(id) }) => {
            let truth = bounds::object(world, id).ok()?;
            return (truth.holds || world.missing_region().is_none()).then_some(truth);
        }
        Goal::Row(RowRef { subject: Subject::Object(id), .. }) => {
            let truth = match scope.support(id) {
                Support::Lifted | Support::Held => Truth::discrete(true),
                Support::Mounted => mounts(&world.allow, id)
                    .filter_map(|mount| judge(&mount.formula, world).ok())
                    .fold(Truth::discrete(false), Truth::or),
                Support::Rests => support::object(world, id).ok()?,
            };
            let complete = world.missing_object().or(world.missing_region()).is_none();
            return (truth.holds || complete).then_some(truth);
        }
    };
    match value {
        Value::Truth(truth) => Some(truth),
        _ => None,
    }
}
