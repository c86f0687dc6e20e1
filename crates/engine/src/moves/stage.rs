//! The stage on which moves are tried: the instance with a few objects moved, and what that does to which rows.
//!
//! Only rows that mention what was moved are judged again, with the pairs and supports around its old and its new place.

use super::DEAR;
use super::flaws::{Flaw, Sense};
use crate::index::cost;
use crate::rows::{Goal, row_of, truth};
use crate::{Index, Mirror, Pose, State};
use rustc_hash::FxHashMap;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, ObjectProperty, Owner, Pinned, Program};
use scenelang_layout::Aabb;
use scenelang_verify::check::Subject;
use scenelang_verify::explain::{ObjectMove, RowRef};
use scenelang_verify::opening::Met;
use scenelang_verify::report::model::RowKind;
use scenelang_verify::rules::{Scope, Support, open, support};
use scenelang_verify::vector::V3;
use scenelang_verify::{Dual, Scratch, Truth, Value, World, in_the_way, objects_of};
use std::rc::Rc;

/// What is moved farther than this is not pushed aside, but carried (metres).
const CARRIED: f64 = 0.5;

/// Derivatives by a move in x, y, z and a turn about the vertical (metres, degrees).
pub(super) type Slope = Dual<4>;

/// What a move does to the rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Consequences {
    /// Held, and fail.
    pub breaks: Vec<RowRef>,
    /// Failed, and hold.
    pub repairs: Vec<RowRef>,
    /// Hold still, with less margin: which, and how much it falls; the greatest fall first.
    pub falls: Vec<(RowRef, f64)>,
}

impl Consequences {
    /// How many hard rows break, then how many preferences.
    pub fn harm(&self) -> (usize, usize) {
        let soft = self.breaks.iter().filter(|row| row.kind == RowKind::Prefer).count();
        (self.breaks.len() - soft, soft)
    }
}

pub(super) struct Stage<'a> {
    pub program: &'a Program,
    pub(super) state: State,
    /// By object: the box around it in the layout.
    boxes: Vec<Option<Aabb>>,
    /// The same with derivatives, made when they are first asked for.
    dual: Option<Mirror<Slope>>,
    pub(super) scope: Scope,
    pub(super) index: Index,
    /// By constraint: what judging it costs.
    pub(super) costs: Vec<usize>,
    pub(super) scratch: Scratch<f64>,
    slopes: Scratch<Slope>,
    before: FxHashMap<RowRef, Option<Truth<f64>>>,
    /// By object: what it rests on in the layout, as far as somebody has asked.
    carriers: FxHashMap<ObjectId, Option<Option<ObjectId>>>,
    /// By object: what is awkward about where the layout has it, as far as somebody has asked.
    flaws: FxHashMap<ObjectId, Vec<Flaw>>,
    /// By object: whether it belongs on the floor, as far as somebody has asked.
    pub(super) grounded: FxHashMap<ObjectId, bool>,
    cones: FxHashMap<(usize, NodeId), Rc<[NodeId]>>,
    /// Work done, in small comparisons.
    pub work: usize,
    /// What may still be spent on dear rows.
    purse: usize,
}

impl<'a> Stage<'a> {
    /// Whoever tries out what is dear has so much to spend.
    pub fn new(program: &'a Program, layout: World<f64>, purse: usize) -> Self {
        let objects = (0..program.objects.len() as u32).map(ObjectId);
        Self {
            program,
            boxes: objects.map(|id| layout.object(id).ok().map(|thing| thing.body.aabb())).collect(),
            dual: None,
            scope: Scope::new(&layout),
            index: Index::of_constraints(program),
            costs: program.constraints.iter().map(|c| cost(&c.formula, program.objects.len())).collect(),
            scratch: Scratch::new(),
            slopes: Scratch::new(),
            before: FxHashMap::default(),
            carriers: FxHashMap::default(),
            flaws: FxHashMap::default(),
            grounded: FxHashMap::default(),
            cones: FxHashMap::default(),
            work: 0,
            purse,
            state: State::new(layout),
        }
    }

    /// Where the layout has an object.
    pub fn home(&self, id: ObjectId) -> Option<Pose> {
        self.state.home(id)
    }

    /// Where an object is on the stage.
    pub fn pose(&self, id: ObjectId) -> Option<Pose> {
        self.state.pose(id)
    }

    /// What an object is for.
    pub fn role(&self, id: ObjectId) -> &'a str {
        self.program.objects[id.0 as usize].role.as_str()
    }

    /// The instance with what is moved.
    pub fn world(&self) -> &World<f64> {
        self.state.world()
    }

    /// Moves an object from where the layout has it.
    pub fn put(&mut self, step: &ObjectMove) {
        let Some(mut pose) = self.state.home(step.object) else { return };
        (0..3).for_each(|i| pose.pos[i] += step.by[i]);
        pose.rot.y += step.turn;
        self.state.set_pose(step.object, &pose);
    }

    /// The same, and with it what goes along.
    pub fn put_with(&mut self, step: &ObjectMove, riders: &[ObjectId]) {
        self.put(step);
        for &rider in riders {
            if let Some(step) = self.along(step, rider) {
                self.put(&step);
            }
        }
    }

    /// The step of an object that goes along with another.
    pub fn along(&self, leader: &ObjectMove, object: ObjectId) -> Option<ObjectMove> {
        let place = |id: ObjectId| self.state.home(id).map(|pose| pose.pos);
        let (pivot, pos) = (place(leader.object)?, place(object)?);
        let (sin, cos) = scenelang_layout::rotation::sin_cos(leader.turn);
        let (x, z) = (pos[0] - pivot[0], pos[2] - pivot[2]);
        let [bx, by, bz] = leader.by;
        let by = [bx + cos * x + sin * z - x, by, bz + cos * z - sin * x - z];
        Some(ObjectMove { object, by, turn: leader.turn, with: Some(leader.object) })
    }

    /// Puts everything back, then these elsewhere.
    pub fn set(&mut self, steps: &[ObjectMove]) {
        self.state.undo();
        steps.iter().for_each(|step| self.put(step));
    }

    pub(super) fn pay(&mut self, cost: usize) {
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
        truth(self.program, &self.scope, self.state.world(), &mut self.scratch, goal, cone.as_deref())
    }

    /// The derivatives of a goal's margin by moves of an object, with what goes along with it.
    pub fn slope(&mut self, goal: Goal, (object, riders): (ObjectId, &[ObjectId])) -> Option<[f64; 4]> {
        self.pay(3 * self.cost(goal));
        let cone = self.cone(goal);
        let state = &self.state;
        let pivot = state.pose(object)?.pos;
        let dual = self.dual.get_or_insert_with(|| Mirror::of(state));
        dual.catch_up(state);
        for id in riders.iter().copied().chain([object]) {
            let Some(pose) = state.pose(id) else { continue };
            let [mut pos, mut rot, scale]: [V3<Slope>; 3] = pose.constant();
            let [x, z] = [0, 2].map(|i| (pose.pos[i] - pivot[i]).to_radians());
            for i in 0..3 {
                pos.0[i].slope[i] = 1.0;
            }
            (pos.0[0].slope[3], pos.0[2].slope[3]) = (z, -x);
            rot.0[1].slope[3] = 1.0;
            dual.set(id, [pos, rot, scale]);
        }
        let found = truth(self.program, &self.scope, dual.world(), &mut self.slopes, goal, cone.as_deref());
        Some(found?.margin.slope)
    }

    /// The objects that goals speak of, one apart.
    pub fn spoken_of(&self, goals: &[Goal], but: ObjectId) -> Vec<ObjectId> {
        let mut all = self.objects_of_all(goals);
        all.retain(|id| *id != but);
        all
    }

    /// The objects that goals speak of.
    pub fn objects_of_all(&self, goals: &[Goal]) -> Vec<ObjectId> {
        let mut all: Vec<ObjectId> = goals.iter().flat_map(|goal| self.objects_of(*goal)).collect();
        let mut known = rustc_hash::FxHashSet::default();
        all.retain(|id| known.insert(*id));
        all
    }

    /// The objects that a goal speaks of.
    fn objects_of(&self, goal: Goal) -> Vec<ObjectId> {
        match (goal, self.formula(goal)) {
            (_, Some((_, formula, _))) => formula.objects(),
            (Goal::Row(RowRef { subject: Subject::Pair(a, b), .. }), _) => vec![a, b],
            (Goal::Row(RowRef { subject: Subject::Object(a), .. }), _) => vec![a],
            (Goal::Row(RowRef { subject: Subject::Part(a, part), .. }), _) => match open::met(self.world(), a, part) {
                Some(Met::Object(other)) => vec![a, other],
                _ => vec![a],
            },
            _ => Vec::new(),
        }
    }

    /// Whether an object belongs into a wall: a door or a window. Nobody moves these to make room for furniture.
    pub fn is_fitting(&self, id: ObjectId) -> bool {
        matches!(self.role(id), "door" | "window")
    }

    /// Whether goals are about where an object looks: they read its directions, and neither its size nor a region, as what
    /// says on which side of it something stands does.
    pub fn is_about_direction(&self, goals: &[Goal], object: ObjectId) -> bool {
        use ObjectProperty::{Front, Max, Min, Right, Rot, Scale, Up};
        goals.iter().any(|goal| {
            let Some((_, formula, from)) = self.formula(*goal) else { return false };
            let nodes: Vec<&Node> = scenelang_verify::cone(formula, from).iter().map(|id| formula.node(*id)).collect();
            let reads = |properties: &[ObjectProperty]| {
                let own = |n: &&Node| matches!(n, Node::Object(p, id) if *id == object && properties.contains(p));
                nodes.iter().any(own)
            };
            let placed = nodes.iter().any(|n| matches!(n, Node::Region(..) | Node::BuiltIn(..)));
            reads(&[Front, Right, Up, Rot]) && !reads(&[Scale, Min, Max]) && !placed
        })
    }

    /// What of the objects that were moved has come to rest on something that it did not rest on, though no goal asks for
    /// that. What belongs on the floor must be there, wherever it was, unless it only goes along: a chair on its desk.
    pub fn lands(&mut self, steps: &[ObjectMove], goals: &[Goal]) -> Vec<ObjectId> {
        let rests = |step: &&ObjectMove| self.scope.support(step.object) == Support::Rests;
        let resting: Vec<ObjectMove> = steps.iter().filter(rests).copied().collect();
        let mut found = Vec::new();
        for step in resting {
            let id = step.object;
            let Some(Some(carrier)) = self.carrier(id) else { continue };
            let wrong = if step.with.is_none() && !self.is_like_floor(carrier) && self.belongs_on_floor(id) {
                true
            } else {
                let asked = goals.iter().any(|goal| self.is_about_height(*goal, id));
                !asked && self.carrier_before(id).is_some_and(|before| before != Some(carrier))
            };
            if wrong {
                found.push(id);
            }
        }
        found
    }

    /// Whether a goal is about the height of what is under an object: that it is supported, or stands on something.
    pub(super) fn is_about_height(&self, goal: Goal, object: ObjectId) -> bool {
        use ObjectProperty::{Bottom, Surface, Top};
        match (goal, self.formula(goal)) {
            (Goal::Row(RowRef { kind: RowKind::Support, subject }), _) => subject == Subject::Object(object),
            (_, Some((_, formula, from))) => {
                let nodes = scenelang_verify::cone(formula, from);
                let reads = |of: &dyn Fn(&ObjectProperty, &ObjectId) -> bool| {
                    nodes.iter().any(|id| matches!(formula.node(*id), Node::Object(p, o) if of(p, o)))
                };
                reads(&|p, o| *o == object && *p == Bottom) && reads(&|p, o| *o != object && matches!(p, Surface | Top))
            }
            _ => false,
        }
    }

    /// What an object rests on as things are on the stage: nothing, a floor (`Some(None)`) or another object.
    pub(super) fn carrier(&self, id: ObjectId) -> Option<Option<ObjectId>> {
        let tolerances = &self.world().options.tolerances;
        let others: Vec<ObjectId> = self.around(id);
        let rest = support::rest(self.world(), id, &others).ok()?;
        rest.truth(tolerances).holds.then_some(rest.carrier)
    }

    /// The same in the layout.
    pub(super) fn carrier_before(&mut self, id: ObjectId) -> Option<Option<ObjectId>> {
        if let Some(known) = self.carriers.get(&id) {
            return *known;
        }
        let found = self.at_home(|stage| stage.carrier(id));
        self.carriers.insert(id, found);
        found
    }

    /// Whether a row speaks of an object.
    pub fn is_about(&self, row: &RowRef, object: ObjectId) -> bool {
        match row.subject {
            Subject::Statement(index) => self.index.of_object(object).binary_search(&index).is_ok(),
            Subject::Pair(a, b) => a == object || b == object,
            Subject::Object(a) | Subject::Part(a, _) => a == object,
        }
    }

    /// Whether some cheap statement speaks of both objects.
    pub fn are_related(&self, a: ObjectId, b: ObjectId) -> bool {
        let other = self.index.of_object(b);
        self.index.of_object(a).iter().any(|i| self.costs[*i] <= DEAR && other.binary_search(i).is_ok())
    }

    /// Cheap rows that hold and speak of an object.
    pub fn kept(&mut self, object: ObjectId) -> Vec<Goal> {
        let mut rows: Vec<RowRef> =
            self.index.touched_by(&[object]).into_iter().map(|i| row_of(self.program, i)).collect();
        if self.world().options.physics {
            let own = Subject::Object(object);
            rows.push(RowRef { kind: RowKind::Support, subject: own });
            if !self.program.regions.is_empty() && self.scope.bounds(object) {
                rows.push(RowRef { kind: RowKind::Bounds, subject: own });
            }
            rows.extend(self.opening(object));
        }
        rows.retain(|row| self.cost(Goal::Row(*row)) <= DEAR);
        self.learn(&rows);
        rows.retain(|row| self.before(*row).is_some_and(|t| t.holds));
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
        let found = truth(self.program, &self.scope, self.state.world(), &mut self.scratch, goal, None);
        self.before.insert(row, found);
        found
    }

    /// Whether a row holds in the layout; a part of one does not.
    pub fn holds_at_home(&mut self, goal: Goal) -> bool {
        let Goal::Row(row) = goal else { return false };
        self.learn(&[row]);
        self.before(row).is_some_and(|t| t.holds)
    }

    /// Learns the verdicts on rows in the layout; what is elsewhere is so again afterwards.
    fn learn(&mut self, rows: &[RowRef]) {
        if rows.iter().all(|row| self.before.contains_key(row)) {
            return;
        }
        self.at_home(|stage| {
            rows.iter().for_each(|row| {
                stage.before(*row);
            });
        });
    }

    /// What is seen with everything where the layout has it; what is elsewhere is so again afterwards.
    fn at_home<T>(&mut self, look: impl FnOnce(&mut Self) -> T) -> T {
        let state = &self.state;
        let now: Vec<(ObjectId, Pose)> = state.moved().filter_map(|(id, _)| Some((id, state.pose(id)?))).collect();
        self.state.undo();
        let seen = look(self);
        now.iter().for_each(|(id, pose)| self.state.set_pose(*id, pose));
        seen
    }

    /// How much has become awkward that was not, these objects being the ones moved. What is moved and then stands alone in the
    /// room, or before a door, counts although it did before; so does a chair that is carried farther, and belongs to nothing
    /// still.
    pub fn new_flaws(&mut self, moved: &[ObjectId]) -> usize {
        self.work += moved.len() * (4 + self.program.objects.len() / 16);
        let now = Sense::new(self.program, self.state.world()).flaws(moved);
        if now.is_empty() {
            return 0;
        }
        let unknown: Vec<ObjectId> = moved.iter().copied().filter(|id| !self.flaws.contains_key(id)).collect();
        self.at_home(|stage| {
            for id in unknown {
                let before = Sense::new(stage.program, stage.state.world()).flaws(&[id]);
                stage.flaws.insert(id, before);
            }
        });
        let before = |flaw: &Flaw| moved.iter().any(|id| self.flaws[id].contains(flaw));
        let far = |id: ObjectId| {
            let [home, pose] = [self.state.home(id), self.state.pose(id)];
            home.zip(pose).is_some_and(|(home, pose)| (pose.pos - home.pos).norm() > CARRIED)
        };
        let counts = |flaw: &Flaw| match flaw {
            Flaw::Alone(_) => 1,
            // Who moves something before a door moves it out of the way, however far that is.
            Flaw::InTheWay(id, owner) if moved.contains(id) && self.role(*owner) == "door" => 2,
            Flaw::Stray(id) if far(*id) => 1,
            _ => usize::from(!before(flaw)),
        };
        now.iter().map(counts).sum()
    }

    /// What judging a goal costs, in small comparisons.
    pub fn cost(&self, goal: Goal) -> usize {
        match goal {
            Goal::Part(index, _) | Goal::Row(RowRef { subject: Subject::Statement(index), .. }) => self.costs[index],
            Goal::Row(RowRef { kind: RowKind::Open, .. }) => 60 + self.program.objects.len() / 8,
            Goal::Row(RowRef { kind: RowKind::Support, .. }) => 4 + self.program.objects.len() / 16,
            Goal::Row(_) => 2,
        }
    }

    fn cone(&mut self, goal: Goal) -> Option<Rc<[NodeId]>> {
        let Goal::Part(index, node) = goal else { return None };
        let formula = &self.program.constraints[index].formula;
        let make = || scenelang_verify::cone(formula, node).into();
        Some(Rc::clone(self.cones.entry((index, node)).or_insert_with(make)))
    }

    /// The formula that a goal is about, if it is about one, and the part that is to hold.
    pub(super) fn formula(&self, goal: Goal) -> Option<(usize, &'a Formula, NodeId)> {
        let index = match goal {
            Goal::Row(RowRef { subject: Subject::Statement(index), .. }) | Goal::Part(index, _) => index,
            Goal::Row(_) => return None,
        };
        let formula = &self.program.constraints[index].formula;
        Some((index, formula, if let Goal::Part(_, node) = goal { node } else { formula.root }))
    }

    /// What decides a goal that fails: the node, if it is part of a statement, and the objects that have a say.
    pub fn deciding(&mut self, goal: Goal) -> Vec<ObjectId> {
        let Some((_, formula, from)) = self.formula(goal) else { return self.objects_of(goal) };
        if self.scratch.evaluate(formula, self.state.world()).is_err() {
            return Vec::new();
        }
        let node = self.scratch.deciding_from(formula, from);
        let mut objects = self.candidates(formula, from);
        // What is in the way is moved, rather than the ends of the way.
        objects.extend(in_the_way(formula, node, &self.scratch, self.state.world()));
        objects.extend(objects_of(formula, node));
        if objects.is_empty() {
            objects = objects_of(formula, from);
        }
        objects
    }

    /// The parts of a conjunction that fail, the one that fails most first; none of anything else.
    pub fn failing_parts(&mut self, goal: Goal) -> Vec<Goal> {
        let Some((index, formula, from)) = self.formula(goal) else { return Vec::new() };
        self.pay(self.costs[index]);
        let Node::And(parts) = formula.node(from) else { return Vec::new() };
        if self.scratch.evaluate(formula, self.state.world()).is_err() {
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

    /// What rests on an object in the layout, and on that. Puts everything back.
    pub fn carried_by(&mut self, object: ObjectId) -> Vec<ObjectId> {
        const MOST: usize = 12;
        self.set(&[]);
        let layout = self.state.world();
        let mut found = vec![object];
        let mut next = 0;
        while let Some(&carrier) = found.get(next) {
            next += 1;
            let Ok(below) = layout.object(carrier).map(|thing| thing.body.aabb()) else { continue };
            let near = |id: &ObjectId| layout.object(*id).is_ok_and(|t| t.body.aabb().distance(&below) < 0.01);
            for id in support::others(layout, carrier).into_iter().filter(near) {
                let rests = self.scope.support(id) == Support::Rests
                    && support::rest(layout, id, &[carrier])
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
        let touched = self.touched(moved);
        self.learn(&touched);
        for row in touched {
            let (Some(before), Some(after)) = (self.before(row), self.truth(Goal::Row(row))) else { continue };
            match (before.holds, after.holds) {
                (true, false) => out.breaks.push(row),
                (false, true) => out.repairs.push(row),
                (true, true) if before.margin - after.margin > 1e-6 && after.margin.is_finite() => {
                    out.falls.push((row, before.margin - after.margin));
                }
                _ => {}
            }
        }
        let order = |row: &RowRef| (row.kind == RowKind::Prefer, *row);
        out.breaks.sort_by_key(order);
        out.repairs.sort_by_key(order);
        out.falls.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        out
    }

    /// The rows that moving these objects can change: cheap ones first.
    fn touched(&self, moved: &[ObjectId]) -> Vec<RowRef> {
        let mut rows: Vec<RowRef> = Vec::new();
        if self.world().options.physics {
            for &id in moved {
                if !self.program.regions.is_empty() && self.scope.bounds(id) {
                    rows.push(RowRef { kind: RowKind::Bounds, subject: Subject::Object(id) });
                }
                rows.push(RowRef { kind: RowKind::Support, subject: Subject::Object(id) });
                for other in self.around(id) {
                    rows.push(RowRef { kind: RowKind::Support, subject: Subject::Object(other) });
                    if self.scope.collide(id, other) {
                        rows.push(RowRef { kind: RowKind::Collision, subject: self.pair(id, other) });
                    }
                }
            }
            rows.extend(self.swept_by(moved).into_iter().flat_map(|id| self.opening(id)));
            rows.sort_unstable();
            rows.dedup();
        }
        let mut stated = self.index.touched_by(moved);
        stated.sort_by_key(|&i| (self.costs[i], i));
        rows.extend(stated.into_iter().map(|i| row_of(self.program, i)));
        rows
    }

    /// P-OPEN of the parts of an object that have to open.
    fn opening(&self, id: ObjectId) -> Vec<RowRef> {
        let parts = open::demands(self.world(), id).into_iter();
        parts.map(|(part, _)| RowRef { kind: RowKind::Open, subject: Subject::Part(id, part) }).collect()
    }

    /// The objects of which some part may come to open, or no longer, where these have moved.
    fn swept_by(&self, moved: &[ObjectId]) -> Vec<ObjectId> {
        let world = self.world();
        let boxes: Vec<Aabb> =
            moved.iter().flat_map(|id| self.boxes[id.0 as usize].into_iter().chain(self.state.bounds(*id))).collect();
        let near = |id: ObjectId| {
            open::reach(world, id).is_some_and(|reach| boxes.iter().any(|b| b.distance(&reach) <= open::REACH))
        };
        world.bodies().map(|(id, _)| id).filter(|id| moved.contains(id) || near(*id)).collect()
    }

    fn pair(&self, a: ObjectId, b: ObjectId) -> Subject {
        let name = |id: ObjectId| &self.program.objects[id.0 as usize].name;
        if name(a) <= name(b) { Subject::Pair(a, b) } else { Subject::Pair(b, a) }
    }

    /// Objects next to the old or the new place of one.
    pub(super) fn around(&self, id: ObjectId) -> Vec<ObjectId> {
        let tolerances = &self.world().options.tolerances;
        let boxes: Vec<Aabb> = self.boxes[id.0 as usize].into_iter().chain(self.state.bounds(id)).collect();
        self.state.near(id, &boxes, tolerances.support + tolerances.order)
    }
}
