//! A judgement that follows a layout while objects move, as under an editor's pointer: what a move cannot change is not
//! judged again.

use crate::{Index, Pose, State};
use scenelang_base::Diagnostic;
use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::{Aabb, Layout, Vec3};
use scenelang_verify::check::{GAPS_FOLLOWED, Judged, LISTED, Ruled, Rules, draws, parts, rooms, stated, too_dense};
use scenelang_verify::opening::LOOKS;
use scenelang_verify::report::model::Summary;
use scenelang_verify::rules::{Columns, Support, open, pairs_up_to, support};
use scenelang_verify::{CheckVerdict, EvalError, Options, Scratch, World};
use std::collections::BTreeMap;

/// The judgement of a layout whose objects can be moved. It says at any time what [`check`](scenelang_verify::check())
/// would say of the layout as it then is, except that it lists only the physical rules that fail.
pub struct Live<'a> {
    program: &'a Program,
    state: State,
    rules: Option<Rules<'a>>,
    index: Index,
    scratch: Scratch<f64>,
    summary: Summary,
    stated: Vec<Judged>,
    errors: BTreeMap<usize, EvalError>,
    /// Pairs that collide, smaller id first.
    collisions: BTreeMap<(ObjectId, ObjectId), Judged>,
    /// By object, what P-BOUNDS and P-SUPPORT say; `None`: nothing.
    bounds: Vec<Option<Ruled>>,
    support: Vec<Option<Ruled>>,
    /// By object, what P-OPEN says of each of its parts that have to open, and what can change that reaches into.
    opening: Vec<Vec<Option<Ruled>>>,
    swept: Vec<Option<Aabb>>,
    /// Objects whose support fails by what is nearest, wherever that is.
    unsupported: Vec<ObjectId>,
    draws: Vec<Diagnostic>,
    rooms: Vec<Diagnostic>,
    /// Why the physical rules are not followed.
    dense: Option<Diagnostic>,
}

impl<'a> Live<'a> {
    /// Judges everything once.
    pub fn new(program: &'a Program, layout: &Layout, options: &Options) -> Self {
        let mut options = *options;
        options.detail.all = false;
        let mut world = World::new(program, layout, &options);
        let mut draws = Vec::new();
        draws::check(program, &mut world, None, &mut draws);
        let nothing = || ids(program).map(|_| None).collect::<Vec<_>>();
        let mut live = Self {
            program,
            rules: options.physics.then(|| Rules::new(program, &world)),
            index: Index::of_constraints(program),
            scratch: Scratch::new(),
            summary: Summary::default(),
            stated: Vec::with_capacity(program.constraints.len()),
            errors: BTreeMap::new(),
            collisions: BTreeMap::new(),
            bounds: nothing(),
            support: nothing(),
            opening: ids(program).map(|_| Vec::new()).collect(),
            swept: vec![None; program.objects.len()],
            unsupported: Vec::new(),
            draws,
            rooms: Vec::new(),
            dense: None,
            state: State::new(world),
        };
        for index in 0..program.constraints.len() {
            let (row, error) = stated::judge_one(program, live.state.world(), &mut live.scratch, index);
            live.summary.stated(row.kind).add(row.satisfied);
            live.errors.extend(error.map(|e| (index, e)));
            live.stated.push(row);
        }
        live.judge_rules();
        rooms::warn(program, live.state.world(), &mut live.rooms);
        live
    }

    /// The physical rules, all of them.
    fn judge_rules(&mut self) {
        let Some(rules) = &self.rules else { return };
        let world = self.state.world();
        let mut neighbours: Vec<Vec<ObjectId>> = vec![Vec::new(); self.program.objects.len()];
        let (total, judged) = rules.pairs(world);
        let near = pairs_up_to(world, rules.reach(), GAPS_FOLLOWED);
        for &(a, b) in &near.pairs {
            neighbours[a.0 as usize].push(b);
            neighbours[b.0 as usize].push(a);
            if self.collisions.len() <= LISTED
                && rules.scope.collide(a, b)
                && let Some(row) = rules.collision(world, a, b).row
            {
                self.collisions.insert((a, b), row);
            }
        }
        if !near.complete || self.collisions.len() > LISTED {
            let say = "too many objects are in one place: the physical rules are not checked while they move";
            self.dense = Some(too_dense(self.program, say.to_owned()));
            self.collisions.clear();
            self.rules = None;
            return;
        }
        self.summary.physical.total += total;
        self.summary.physical.satisfied += judged - self.collisions.len();
        let mut columns = Columns::new(self.state.world());
        for id in ids(self.program) {
            self.judge_bounds(id);
            self.judge_support(id, &neighbours[id.0 as usize], Some(&mut columns));
            self.judge_opening(id);
        }
    }

    /// P-OPEN of what of an object has to open; how many parts were judged.
    fn judge_opening(&mut self, id: ObjectId) -> usize {
        let Some(rules) = &self.rules else { return 0 };
        let world = self.state.world();
        let parts = open::demands(world, id);
        self.swept[id.0 as usize] = open::reach(world, id);
        self.opening[id.0 as usize].resize_with(parts.len(), || None);
        for (index, (part, _)) in parts.iter().enumerate() {
            let now = rules.opened(world, id, *part, &mut { LOOKS });
            replace(&mut self.summary, &mut self.opening[id.0 as usize][index], now);
        }
        parts.len()
    }

    fn judge_bounds(&mut self, id: ObjectId) {
        let Some(rules) = self.rules.as_ref().filter(|rules| rules.bounds(id)) else { return };
        let now = rules.bounded(self.state.world(), id);
        replace(&mut self.summary, &mut self.bounds[id.0 as usize], now);
    }

    fn judge_support(&mut self, id: ObjectId, neighbours: &[ObjectId], columns: Option<&mut Columns>) {
        let Some(rules) = &self.rules else { return };
        let how = rules.scope.support(id);
        if how == Support::Lifted {
            return;
        }
        let world = self.state.world();
        let all = || Some(support::others(world, id));
        let now = match columns {
            Some(columns) => rules.supported(world, id, neighbours, &mut || columns.of(id).or_else(all)),
            None => rules.supported(world, id, neighbours, &mut { all }),
        };
        let place = self.unsupported.binary_search(&id);
        match (place, how == Support::Rests && now.holds != Some(true)) {
            (Err(at), true) => self.unsupported.insert(at, id),
            (Ok(at), false) => drop(self.unsupported.remove(at)),
            _ => {}
        }
        replace(&mut self.summary, &mut self.support[id.0 as usize], now);
    }

    /// Moves an object: `pos` in metres, the centre of its bottom face; `rot` in degrees about x, y and z. Judges what
    /// that can change. Returns how many rows were judged; none if the layout lacks the object.
    pub fn place(&mut self, object: ObjectId, pos: Vec3, rot: Vec3) -> usize {
        let Some(pose) = self.state.pose(object) else { return 0 };
        self.set_pose(object, &Pose { pos, rot, ..pose })
    }

    /// The same of an object that is held by a pointer. Whatever else was moved since the last [`Live::keep`] was let go
    /// without being put down, and goes back.
    pub fn drag(&mut self, object: ObjectId, pos: Vec3, rot: Vec3) -> usize {
        let others = self.state.moved().any(|(id, _)| id != object);
        let judged = if others { self.undo() } else { 0 };
        judged + self.place(object, pos, rot)
    }

    /// From here on things are where they belong.
    pub fn keep(&mut self) {
        self.state.keep();
    }

    /// Puts back what has moved since the last [`Live::keep`]. Returns how many rows were judged.
    pub fn undo(&mut self) -> usize {
        let moved: Vec<(ObjectId, Pose)> = self.state.moved().collect();
        let judged = moved.iter().map(|(id, home)| self.set_pose(*id, home)).sum();
        self.state.keep();
        judged
    }

    fn set_pose(&mut self, object: ObjectId, pose: &Pose) -> usize {
        let (before, there) = (self.around(object), self.state.bounds(object));
        self.state.set_pose(object, pose);
        let world = self.state.world();
        let touched = self.index.touched_by(&[object]);
        for &index in &touched {
            let (row, error) = stated::judge_one(self.program, world, &mut self.scratch, index);
            let tally = self.summary.stated(row.kind);
            tally.remove(self.stated[index].satisfied);
            tally.add(row.satisfied);
            match error {
                Some(error) => drop(self.errors.insert(index, error)),
                None => drop(self.errors.remove(&index)),
            }
            self.stated[index] = row;
        }
        if self.program.allow.outside.contains(&object) {
            self.rooms.clear();
            rooms::warn(self.program, world, &mut self.rooms);
        }
        touched.len() + self.follow(object, (&before, there))
    }

    /// The physical rules that a move of an object can have changed, `before` being what was near it; how many were judged.
    fn follow(&mut self, object: ObjectId, (before, there): (&[ObjectId], Option<Aabb>)) -> usize {
        let here = self.around(object);
        let Some(rules) = &self.rules else { return 0 };
        let pair = |other: ObjectId| (object.min(other), object.max(other));
        let mut judged = 1;
        for other in before {
            if self.collisions.remove(&pair(*other)).is_some() {
                self.summary.physical.satisfied += 1;
            }
        }
        for &other in here.iter().filter(|other| rules.scope.collide(object, **other)) {
            judged += 1;
            let (a, b) = pair(other);
            if let Some(row) = rules.collision(self.state.world(), a, b).row {
                self.summary.physical.satisfied -= 1;
                self.collisions.insert((a, b), row);
            }
        }
        self.judge_bounds(object);
        let mut unsettled: Vec<ObjectId> = here.iter().chain(before).chain(&self.unsupported).copied().collect();
        unsettled.push(object);
        unsettled.sort_unstable();
        unsettled.dedup();
        for &id in &unsettled {
            self.judge_support(id, &self.around(id), None);
        }
        let moved = [there, self.state.bounds(object)];
        let near = |swept: &Aabb| moved.iter().flatten().any(|b| b.distance(swept) <= open::REACH);
        let swept: Vec<ObjectId> = ids(self.program)
            .filter(|id| *id == object || self.swept[id.0 as usize].as_ref().is_some_and(near))
            .collect();
        let opened: usize = swept.into_iter().map(|id| self.judge_opening(id)).sum();
        judged + unsettled.len() + opened
    }

    /// Objects within reach of one.
    fn around(&self, object: ObjectId) -> Vec<ObjectId> {
        let of = self.state.bounds(object);
        self.rules.as_ref().map_or(Vec::new(), |rules| self.state.near(object, of.as_slice(), rules.reach()))
    }

    /// The layout as it is now.
    pub fn world(&self) -> &World<f64> {
        self.state.world()
    }

    /// How many there are of each kind, and how many hold.
    pub fn summary(&self) -> Summary {
        self.summary
    }

    /// All rows: stated constraints in source order, then the physical rules that fail.
    pub fn rows(&self) -> impl Iterator<Item = &Judged> {
        let ruled = self.bounds.iter().chain(&self.support).chain(self.opening.iter().flatten());
        let ruled = ruled.flatten().filter_map(|ruled| ruled.row.as_ref());
        self.stated.iter().chain(self.collisions.values()).chain(ruled)
    }

    /// The whole verdict, as a copy.
    pub fn verdict(&self) -> CheckVerdict {
        let mut diagnostics = self.draws.clone();
        diagnostics.extend(stated::diagnostics(self.program, self.errors.iter().map(|(i, e)| (*i, *e))));
        diagnostics.extend(self.dense.clone());
        diagnostics.extend(self.rooms.iter().cloned());
        let parts = if self.rules.is_some() { parts(self.state.world()) } else { Vec::new() };
        CheckVerdict {
            rows: self.rows().cloned().collect(),
            summary: self.summary,
            diagnostics,
            parts,
            ..CheckVerdict::default()
        }
    }
}

fn ids(program: &Program) -> impl Iterator<Item = ObjectId> + use<> {
    (0..program.objects.len() as u32).map(ObjectId)
}

/// Puts a new finding in the place of an old one.
fn replace(summary: &mut Summary, old: &mut Option<Ruled>, new: Ruled) {
    if let Some(old) = old {
        summary.physical.remove(old.holds);
    }
    summary.physical.add(new.holds);
    *old = Some(new);
}
