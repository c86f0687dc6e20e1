//! One layout under search: poses, what every check costs in it, and trial moves that are judged by what they touch.
//!
//! A trial is made, judged, and then kept or taken back. Judging stops as soon as it is clear that the trial is worse
//! than the caller cares for; costs only add up.

mod swings;

use crate::State;
use crate::frame::checks::{Check, Numbering};
use crate::frame::terms::Force;
use crate::frame::{Frame, Hold};
use crate::limit::Limit;
use crate::penalty::{self, Penalty};
use crate::pose::{Pose, Ride};
use scenelang_lang::program::{ObjectId, RegionId, VariableId};
use scenelang_layout::{Aabb, Vec2, obb};
use scenelang_verify::{Scratch, Tolerances, Truth, Value, World, rules};
use std::marker::PhantomData;
use swings::Swings;

/// All preferences together cost at most about this, so that none is worth a violation.
const PREFERENCES: f64 = 0.05;
/// Overlaps of less than this are rounding (metres).
const TOUCHING: f64 = 1e-7;
/// Objects not placed yet wait this far below everything, each on a level of its own (metres).
const LIMBO: f64 = -1e5;

/// A step of a trial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// An object goes elsewhere.
    Object(ObjectId, Pose),
    /// An object without a place takes the one that its rules give it.
    Join(ObjectId),
    /// A region changes place or size.
    Region(RegionId, Pose),
    /// A decision variable takes a value.
    Variable(VariableId, Value<f64>),
}

/// What must be put back if a trial is not kept, beside the poses.
#[derive(Default)]
struct Journal {
    open: bool,
    placed: Vec<ObjectId>,
    costs: Vec<(usize, f64, bool)>,
}

/// One layout under search.
pub struct Candidate<'a> {
    /// What stays the same.
    pub frame: &'a Frame<'a>,
    layout: State,
    /// How checks are numbered.
    pub numbering: Numbering,
    /// By check: how much it counts. Stubborn ones come to count more.
    pub weight: Vec<f64>,
    /// By object: what it stands on, if that is not a floor.
    pub seats: Vec<Option<ObjectId>>,
    /// Work done so far.
    pub work: u64,
    /// When looking has to end, whatever the work.
    pub limit: Limit,
    placed: Vec<bool>,
    /// By term: how many of its objects are not placed yet.
    missing: Vec<usize>,
    spans: Vec<Aabb>,
    cost: Vec<f64>,
    holds: Vec<bool>,
    walks_stale: bool,
    swings: Swings,
    journal: Journal,
    scratch: Scratch<f64>,
    stamp: Vec<u32>,
    now: u32,
}

impl<'a> Candidate<'a> {
    /// Nothing placed yet; regions and variables as the world has them.
    pub fn new(frame: &'a Frame<'a>, world: World<f64>) -> Self {
        let n = frame.program.objects.len();
        let numbering = Numbering::new(frame.terms.len(), n);
        let preferences: f64 = frame.terms.iter().map(|t| if let Force::Soft(w) = t.force { w } else { 0.0 }).sum();
        let mut weight = vec![1.0; numbering.len()];
        for (index, term) in frame.terms.iter().enumerate() {
            if let Force::Soft(w) = term.force {
                weight[index] = PREFERENCES * w / preferences;
            }
        }
        let swings = Swings::of(frame, &world);
        let mut state = Self {
            frame,
            layout: State::new(world),
            numbering,
            weight,
            seats: vec![None; n],
            work: 0,
            limit: Limit::default(),
            placed: vec![false; n],
            missing: frame.terms.iter().map(|t| t.objects.len()).collect(),
            spans: vec![Aabb::of([]); n],
            cost: vec![0.0; numbering.len()],
            holds: vec![true; numbering.len()],
            walks_stale: true,
            swings,
            journal: Journal::default(),
            scratch: Scratch::new(),
            stamp: vec![0; numbering.len()],
            now: 0,
        };
        frame.objects().for_each(|id| state.banish(id));
        state
    }

    pub fn layout(&self) -> &State {
        &self.layout
    }
    /// The layout, as the evaluator sees it.
    pub fn world(&self) -> &World<f64> {
        self.layout.world()
    }
    pub fn pose(&self, id: ObjectId) -> Pose {
        self.layout.pose(id).expect("every object of the program is in the world")
    }
    pub fn region_pose(&self, id: RegionId) -> Pose {
        self.layout.region_pose(id).expect("every region of the program is in the world")
    }
    /// The upright box around an object.
    pub fn span(&self, id: ObjectId) -> &Aabb {
        &self.spans[id.0 as usize]
    }
    /// Whether an object has a place yet.
    pub fn is_placed(&self, id: ObjectId) -> bool {
        self.placed[id.0 as usize]
    }
    pub fn placed(&self) -> impl Iterator<Item = ObjectId> + '_ {
        self.frame.objects().filter(|id| self.is_placed(*id))
    }
    /// Whether all objects of a term have a place.
    pub fn is_active(&self, term: usize) -> bool {
        self.missing[term] == 0
    }
    /// What a check costs, without its weight.
    pub fn cost(&self, check: usize) -> f64 {
        self.cost[check]
    }
    /// Whether a check must hold and does not.
    pub fn is_violated(&self, check: usize) -> bool {
        !self.holds[check] && self.is_hard(check)
    }
    /// Whether a check must hold.
    pub fn is_hard(&self, check: usize) -> bool {
        self.frame.terms.get(check).is_none_or(|t| t.is_hard())
    }
    /// Whether a check holds.
    pub fn does_hold(&self, check: usize) -> bool {
        self.holds[check]
    }
    /// What must hold and does not.
    pub fn violated(&self) -> Vec<usize> {
        (0..self.cost.len()).filter(|&c| self.is_violated(c)).collect()
    }
    /// How many checks that must hold do not, and what all that must hold costs by plain weights. Ways over the floor
    /// are looked at only where all else holds; before that all of them count as barred.
    pub fn hard(&mut self) -> (usize, f64) {
        let frame = self.frame;
        let mut sum = (0, 0.0);
        for check in (0..self.cost.len()).filter(|&c| self.is_hard(c) && !frame.terms.get(c).is_some_and(|t| t.walks)) {
            sum = (sum.0 + usize::from(!self.holds[check]), sum.1 + self.cost[check]);
        }
        let ways = frame.walks.iter().copied().filter(|&t| frame.terms[t].is_hard());
        if sum.0 > 0 {
            return (sum.0 + ways.count(), sum.1);
        }
        self.look_at_ways();
        ways.fold(sum, |sum, t| (sum.0 + usize::from(!self.holds[t]), sum.1 + self.cost[t]))
    }
    /// What must hold and does not, ways over the floor as in [`Self::hard`].
    pub fn failing(&mut self) -> Vec<usize> {
        let frame = self.frame;
        let cheap: Vec<usize> =
            self.violated().into_iter().filter(|&c| !frame.terms.get(c).is_some_and(|t| t.walks)).collect();
        if !cheap.is_empty() {
            return cheap;
        }
        self.look_at_ways();
        self.violated()
    }
    /// All that is preferred for costs together.
    pub fn soft(&self) -> f64 {
        let preferences = (0..self.frame.terms.len()).filter(|&t| !self.is_hard(t));
        preferences.map(|t| self.weight[t] * self.cost[t]).sum::<f64>()
    }
    /// What everything costs, by the weights in force.
    pub fn total(&self) -> f64 {
        self.cost.iter().zip(&self.weight).map(|(c, w)| c * w).sum::<f64>()
    }

    /// Takes an object out of the scene.
    pub fn banish(&mut self, id: ObjectId) {
        let pose = self.pose(id).at(0.0, LIMBO * (1.0 + 0.01 * f64::from(id.0)), 0.0);
        self.put(id, pose);
        self.seats[id.0 as usize] = None;
        self.seats.iter_mut().filter(|s| **s == Some(id)).for_each(|s| *s = None);
        if std::mem::replace(&mut self.placed[id.0 as usize], false) {
            for &t in self.frame.index.of_object(id) {
                self.missing[t] += 1;
            }
        }
        let touched = self.touched(&[id], &[], &[], &[]);
        for check in touched {
            (self.cost[check], self.holds[check]) = self.measure(check);
        }
        self.walks_stale = true;
    }

    /// Measures everything anew.
    pub fn measure_all(&mut self) {
        for check in 0..self.cost.len() {
            if !self.frame.terms.get(check).is_some_and(|t| t.walks) {
                (self.cost[check], self.holds[check]) = self.measure(check);
            }
        }
        self.walks_stale = true;
        for id in self.frame.objects() {
            self.find_seat(id);
        }
    }

    /// Looks at the ways over the floor again, if something has moved since. Each look is dear: those for which there is
    /// no time any more count as barred.
    pub fn look_at_ways(&mut self) {
        if std::mem::replace(&mut self.walks_stale, false) {
            for &term in &self.frame.walks {
                if self.limit.is_over() {
                    self.walks_stale = true;
                    self.holds[term] = false;
                } else {
                    (self.cost[term], self.holds[term]) = self.measure(term);
                }
            }
        }
    }

    /// Whether all of these ways over the floor are free. One that is barred is enough to know.
    pub fn has_ways(&mut self, terms: impl Fn(usize) -> bool) -> bool {
        let frame = self.frame;
        frame.walks.iter().filter(|t| terms(**t)).all(|&term| {
            if self.walks_stale && !self.limit.is_over() {
                (self.cost[term], self.holds[term]) = self.measure(term);
                self.holds[term]
            } else {
                !self.walks_stale && self.holds[term]
            }
        })
    }

    /// Makes changes as a trial. `Some`: by how much everything now costs more (or less, if negative); the trial must
    /// then be kept or taken back. `None`: more than `limit`; all is as it was.
    pub fn attempt(&mut self, changes: &[Change], limit: f64) -> Option<f64> {
        let touched = self.make(changes);
        let before: f64 = touched.iter().map(|&c| self.weight[c] * self.cost[c]).sum::<f64>();
        let mut after = 0.0;
        for check in touched {
            after += self.weight[check] * self.measure_again(check).0;
            if after - before > limit {
                self.undo();
                return None;
            }
        }
        if after - before > limit {
            self.undo();
            return None;
        }
        Some(after - before)
    }

    /// Makes changes as a trial that has to leave all in force that must hold; what is preferred, and ways over the floor,
    /// are not looked at. `Ok`: the trial must then be kept or taken back. `Err`: a check that it breaks; all is as it was.
    ///
    /// # Errors
    /// See above.
    pub fn attempt_holding(&mut self, changes: &[Change]) -> Result<(), usize> {
        for check in self.make(changes) {
            if self.is_hard(check) && !self.measure_again(check).1 {
                self.undo();
                return Err(check);
            }
        }
        Ok(())
    }

    /// Makes changes, and follows the rules; the checks that this may alter.
    fn make(&mut self, changes: &[Change]) -> Vec<usize> {
        debug_assert!(!self.journal.open, "a trial within a trial");
        self.journal.open = true;
        let mut objects: Vec<ObjectId> = Vec::with_capacity(changes.len());
        let (mut regions, mut variables) = (Vec::new(), Vec::new());
        // Where things were and where they come to be: both ends of a way touch what stands there.
        let mut swept: Vec<Aabb> = Vec::with_capacity(2 * changes.len());
        for change in changes {
            match *change {
                Change::Object(id, pose) => {
                    self.move_object(id, pose, &mut objects, &mut swept);
                }
                Change::Join(id) => self.join(id, &mut objects, &mut swept),
                Change::Region(id, pose) => {
                    self.layout.set_region(id, &pose);
                    regions.push(id);
                }
                Change::Variable(id, value) => {
                    self.layout.set_variable(id, value);
                    variables.push(id);
                }
            }
        }
        self.obey_rules(&mut objects, &mut swept, &regions, &variables);
        self.touched(&objects, &regions, &variables, &swept)
    }

    /// Measures a check in a trial.
    fn measure_again(&mut self, check: usize) -> (f64, bool) {
        let measured = self.measure(check);
        self.journal.costs.push((check, self.cost[check], self.holds[check]));
        (self.cost[check], self.holds[check]) = measured;
        measured
    }

    /// Keeps the trial.
    pub fn keep(&mut self) {
        let moved: Vec<ObjectId> = self.layout.moved().map(|(id, _)| id).collect();
        self.keep_sizes();
        for id in moved {
            self.find_seat(id);
        }
    }

    /// Keeps a trial of sizes alone: what carries an object is not asked before it has a place.
    pub fn keep_sizes(&mut self) {
        self.journal = Journal::default();
        self.layout.keep();
        self.walks_stale = true;
    }

    /// Takes the trial back.
    pub fn undo(&mut self) {
        let journal = std::mem::take(&mut self.journal);
        for (id, pose) in self.layout.moved() {
            self.spans[id.0 as usize] = pose.span();
        }
        self.layout.undo();
        for id in journal.placed {
            self.placed[id.0 as usize] = false;
            for &t in self.frame.index.of_object(id) {
                self.missing[t] += 1;
            }
        }
        for (check, cost, holds) in journal.costs {
            (self.cost[check], self.holds[check]) = (cost, holds);
        }
    }

    /// The moves of an object with everything that stands on it, hangs in it, and so on.
    pub fn with_riders(&self, id: ObjectId, pose: Pose) -> Vec<Change> {
        let ride = Ride::new(&self.pose(id), &pose);
        let mut list = vec![Change::Object(id, pose)];
        if self.is_placed(id) {
            list.extend(self.riders(id).into_iter().map(|r| Change::Object(r, ride.apply(&self.pose(r)))));
        }
        list
    }

    /// What stands on an object or is contained in it, and may be moved; and what stands on that.
    pub fn riders(&self, id: ObjectId) -> Vec<ObjectId> {
        let mut found: Vec<ObjectId> = Vec::new();
        let mut open = vec![id];
        while let Some(base) = open.pop() {
            for rider in self.frame.objects() {
                let rides =
                    self.seats[rider.0 as usize] == Some(base) || self.frame.hold(rider) == Hold::Container(base);
                if rides
                    && rider != id
                    && !found.contains(&rider)
                    && self.frame.is_movable(rider)
                    && self.is_placed(rider)
                {
                    found.push(rider);
                    open.push(rider);
                }
            }
        }
        found
    }

    fn move_object(&mut self, id: ObjectId, pose: Pose, objects: &mut Vec<ObjectId>, swept: &mut Vec<Aabb>) {
        // What the program assigns is not the search's to change.
        let fixed = self.frame.fixed(id);
        let old = self.pose(id);
        let mut next = Pose {
            pos: pose.pos,
            rot: if fixed.rot { old.rot } else { pose.rot },
            scale: if fixed.scale { old.scale } else { pose.scale },
        };
        if self.is_placed(id) {
            (0..3).filter(|&i| fixed.pos[i]).for_each(|i| next.pos[i] = old.pos[i]);
        }
        let waited = !self.is_placed(id);
        self.set_object(id, next, objects, swept);
        if waited {
            // Rules have not been obeyed while it had no place.
            for &rule in &self.frame.rules.own[id.0 as usize] {
                self.obey(rule, objects, swept);
            }
        }
    }

    fn join(&mut self, id: ObjectId, objects: &mut Vec<ObjectId>, swept: &mut Vec<Aabb>) {
        let mut pose = self.home(id);
        let here = Vec2::new(pose.pos.x, pose.pos.z);
        let prism = self.world().prisms().map(|(_, p)| p).find(|p| p.polygon.contains(here));
        if !self.frame.fixed(id).pos[1] {
            pose.pos.y = match self.frame.hold(id) {
                Hold::Ceiling(region) => self.world().region(region).map_or(0.0, |r| r.prism.ceiling - pose.scale.y),
                _ => prism.map_or(0.0, |p| p.floor) + pose.depth_below(),
            };
        }
        self.move_object(id, pose, objects, swept);
    }

    fn set_object(&mut self, id: ObjectId, pose: Pose, objects: &mut Vec<ObjectId>, swept: &mut Vec<Aabb>) {
        let i = id.0 as usize;
        swept.push(self.spans[i]);
        self.put(id, pose);
        swept.push(self.spans[i]);
        if !self.placed[i] {
            self.placed[i] = true;
            self.journal.placed.push(id);
            for &t in self.frame.index.of_object(ObjectId(i as u32)) {
                self.missing[t] -= 1;
            }
        }
        if !objects.contains(&id) {
            objects.push(id);
        }
    }

    fn put(&mut self, id: ObjectId, pose: Pose) {
        self.layout.set_pose(id, &pose);
        if !self.journal.open {
            self.layout.keep();
        }
        self.spans[id.0 as usize] = pose.span();
    }

    /// Obeys the rules that depend on what has moved.
    fn obey_rules(
        &mut self,
        objects: &mut Vec<ObjectId>,
        swept: &mut Vec<Aabb>,
        regions: &[RegionId],
        variables: &[VariableId],
    ) {
        let frame = self.frame;
        let of_objects = objects.iter().map(|o| &frame.followers[o.0 as usize]);
        let of_regions = regions.iter().map(|r| &frame.region_followers[r.0 as usize]);
        let lists =
            of_objects.chain(of_regions).chain(variables.iter().map(|v| &frame.variable_followers[v.0 as usize]));
        let mut rules: Vec<usize> = lists.flatten().copied().collect();
        rules.sort_unstable();
        rules.dedup();
        for rule in rules {
            self.obey(rule, objects, swept);
        }
    }

    fn obey(&mut self, rule: usize, objects: &mut Vec<ObjectId>, swept: &mut Vec<Aabb>) {
        let owner = self.frame.rules.list[rule].owner;
        // An object that waits for a place is not brought in by its rules alone.
        if !self.is_placed(owner) {
            return;
        }
        if let Some(pose) = self.ruled(rule).filter(|pose| *pose != self.pose(owner)) {
            self.set_object(owner, pose, objects, swept);
        }
    }

    /// The pose that a rule gives its object.
    fn ruled(&self, rule: usize) -> Option<Pose> {
        let [pos, rot, scale] = self.frame.rules.list[rule].apply(self.world())?;
        Some(Pose { pos: pos.value(), rot: rot.value(), scale: scale.value() })
    }

    /// Its pose as the rules want it, for an object without a place.
    pub fn home(&mut self, id: ObjectId) -> Pose {
        let old = self.pose(id);
        for &rule in &self.frame.rules.own[id.0 as usize] {
            if let Some(pose) = self.ruled(rule) {
                self.put(id, pose);
            }
        }
        let home = self.pose(id);
        self.put(id, old);
        home
    }

    /// Checks that may change with these, cheap and telling ones first.
    fn touched(
        &mut self,
        objects: &[ObjectId],
        regions: &[RegionId],
        variables: &[VariableId],
        swept: &[Aabb],
    ) -> Vec<usize> {
        self.now += 1;
        let (frame, numbering) = (self.frame, self.numbering);
        let mut list: Vec<usize> = Vec::with_capacity(64);
        let physical = frame.scope.is_some();
        if physical {
            list.extend(objects.iter().map(|&id| numbering.bounds(id)));
        }
        let terms = objects.iter().flat_map(|o| frame.index.of_object(*o));
        let terms = terms.chain(regions.iter().flat_map(|r| frame.index.of_region(*r)));
        let terms = terms.chain(variables.iter().flat_map(|v| frame.index.of_variable(*v)));
        list.extend(terms.filter(|&&t| !frame.terms[t].sees_all && self.missing[t] == 0));
        if physical {
            for &id in objects {
                let others = frame.objects().filter(|o| *o != id);
                list.extend(others.map(|other| numbering.collide(id, other)).filter(|&c| {
                    // Apart before and after: nothing to see.
                    self.cost[c] > 0.0 || self.may_meet(numbering.check(c))
                }));
            }
            list.extend(objects.iter().map(|&id| numbering.support(id)));
            let above = |span: &Aabb| swept.iter().any(|s| overlap_in_plan(s, span));
            list.extend(
                self.placed()
                    .filter(|id| self.seats[id.0 as usize].is_some() || !self.holds[numbering.support(*id)])
                    .filter(|id| above(self.span(*id)))
                    .map(|id| numbering.support(id)),
            );
            if !regions.is_empty() {
                list.extend(frame.objects().flat_map(|id| [numbering.bounds(id), numbering.support(id)]));
            }
        }
        if !objects.is_empty() || !regions.is_empty() {
            // Of what is taken out of the scene nobody says where it was.
            let anything = !regions.is_empty() || !variables.is_empty() || swept.is_empty();
            let sees = |t: usize| {
                anything
                    || frame.terms[t].objects.iter().any(|own| objects.contains(own))
                    || self.swings.may_see(t, self.layout.world(), swept)
            };
            list.extend(frame.index.seeing().iter().filter(|&&t| self.missing[t] == 0 && sees(t)));
        }
        let (now, stamp) = (self.now, &mut self.stamp);
        list.retain(|&c| std::mem::replace(&mut stamp[c], now) != now);
        list
    }

    fn may_meet(&self, check: Check) -> bool {
        let Check::Collide(a, b) = check else { return false };
        let (p, q) = (self.span(a), self.span(b));
        overlap_in_plan(p, q) && p.min.y < q.max.y - TOUCHING && q.min.y < p.max.y - TOUCHING
    }

    /// What a check costs now, and whether it holds.
    fn measure(&mut self, index: usize) -> (f64, bool) {
        const FINE: (f64, bool) = (0.0, true);
        match self.numbering.check(index) {
            Check::Term(t) => {
                if self.missing[t] > 0 {
                    return FINE;
                }
                self.term(t)
            }
            Check::Collide(a, b) => {
                let scope = self.frame.scope.as_ref().filter(|s| s.collide(a, b));
                if scope.is_none() || !self.is_placed(a) || !self.is_placed(b) || !self.may_meet(Check::Collide(a, b)) {
                    return FINE;
                }
                self.collision(a, b)
            }
            Check::Bounds(id) => {
                let speaks = self.frame.scope.as_ref().is_some_and(|s| s.bounds(id));
                if !speaks || !self.is_placed(id) || self.frame.program.regions.is_empty() {
                    return FINE;
                }
                self.work += 10;
                rules::bounds::object(self.world(), id)
                    .map_or(FINE, |t| self.physical(t, self.world().options.tolerances.contact))
            }
            Check::Support(id) => {
                let rests = self.frame.scope.as_ref().is_some_and(|s| s.support(id) == rules::Support::Rests);
                if !rests || !self.is_placed(id) {
                    return FINE;
                }
                self.support(id)
            }
        }
    }

    fn term(&mut self, index: usize) -> (f64, bool) {
        let term = &self.frame.terms[index];
        let dear = if term.walks {
            150_000
        } else if term.sees_all {
            1_000
        } else {
            5
        };
        self.work += dear + term.formula.nodes.len() as u64;
        let holds = match self.scratch.evaluate(&term.formula, self.layout.world()) {
            Ok(Value::Truth(truth)) => truth.holds,
            _ => false,
        };
        let tolerances = &self.layout.world().options.tolerances;
        let cost = Penalty { formula: &term.formula, values: &self.scratch, tolerances, numbers: PhantomData }.cost();
        (cost, holds)
    }

    fn collision(&mut self, a: ObjectId, b: ObjectId) -> (f64, bool) {
        let world = self.layout.world();
        let (Ok(x), Ok(y)) = (world.object(a), world.object(b)) else { return (0.0, true) };
        let Tolerances { contact, order, .. } = world.options.tolerances;
        self.work += 20;
        let boxes = obb::separation(&x.body.obb, &y.body.obb).gap;
        if boxes >= -TOUCHING {
            return (0.0, true);
        }
        if !x.body.has_parts() && !y.body.has_parts() {
            return self.physical(Truth::metres(boxes + contact, order), contact - TOUCHING);
        }
        self.work += 300;
        rules::collide::pair(world, a, b).map_or((0.0, true), |t| self.physical(t, contact - TOUCHING))
    }

    fn support(&mut self, id: ObjectId) -> (f64, bool) {
        self.work += 100;
        let tolerance = self.world().options.tolerances.support;
        // Most things stand on a floor, and need no look at what is around them.
        if let Ok(truth) = rules::support::among(self.world(), id, &[])
            && truth.holds
        {
            return self.rested(truth, tolerance);
        }
        let carriers = self.carriers(id);
        self.work += 100 * carriers.len() as u64;
        rules::support::among(self.world(), id, &carriers).map_or((0.0, true), |t| self.rested(t, tolerance))
    }

    /// Objects over which an object is.
    fn carriers(&self, id: ObjectId) -> Vec<ObjectId> {
        let span = *self.span(id);
        self.placed().filter(|other| *other != id && overlap_in_plan(self.span(*other), &span)).collect()
    }

    /// Resting has a tolerance of height, but none of balance: only the former is asked to be unused.
    fn rested(&self, truth: Truth<f64>, tolerance: f64) -> (f64, bool) {
        let contact = self.world().options.tolerances.contact;
        let target = if truth.holds { tolerance.min(contact) } else { tolerance };
        self.physical(truth, target)
    }

    fn physical(&self, truth: Truth<f64>, target: f64) -> (f64, bool) {
        let margin = truth.margin;
        let margin = if margin.is_finite() { margin } else { -10.0 };
        (penalty::cost(truth.holds, target - margin), truth.holds)
    }

    /// Objects that a check speaks of.
    pub fn objects_of(&self, check: usize) -> Vec<ObjectId> {
        match self.numbering.check(check) {
            Check::Term(t) => self.frame.terms[t].objects.clone(),
            Check::Collide(a, b) => vec![a, b],
            Check::Bounds(a) | Check::Support(a) => vec![a],
        }
    }

    /// Remembers what carries an object.
    fn find_seat(&mut self, id: ObjectId) {
        let i = id.0 as usize;
        let rests = self.frame.scope.as_ref().is_none_or(|s| s.support(id) == rules::Support::Rests);
        self.seats[i] = None;
        if rests && self.is_placed(id) && !rules::support::among(self.world(), id, &[]).is_ok_and(|t| t.holds) {
            let carriers = self.carriers(id);
            let rest = rules::support::rest(self.world(), id, &carriers);
            let tolerance = self.world().options.tolerances.support;
            self.seats[i] = rest.ok().filter(|r| (r.lowest - r.nearest).abs() <= tolerance).and_then(|r| r.carrier);
        }
    }
}

/// Whether two upright boxes overlap, seen from above.
pub fn overlap_in_plan(a: &Aabb, b: &Aabb) -> bool {
    a.min.x < b.max.x - TOUCHING
        && b.min.x < a.max.x - TOUCHING
        && a.min.z < b.max.z - TOUCHING
        && b.min.z < a.max.z - TOUCHING
}
