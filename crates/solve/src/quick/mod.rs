//! The quick search: weighted min-conflicts over many sampled poses, on straight-line code.
//!
//! The layout is a row of floats here, formulas are code (see [`scenelang_verify::coded`]), solids are boxes, and a trial
//! looks only at what the moved objects touch. Everything found is handed back to the search proper, which judges it by
//! the evaluator itself.

mod moves;
mod run;
mod tidy;

use crate::checks::Check;
use crate::checks::Numbering;
use crate::frame::{Frame, Hold};
use crate::merit::{self, Merit, Truths};
use crate::pose::Pose;
use crate::rules::Sets;
use crate::state::{Change, State};
use scenelang_lang::program::{Arg, Formula, Native, Node, NodeId, ObjectId, ObjectProperty, RegionId};
use scenelang_layout::{Prism, Vec3};
use scenelang_verify::coded::{Coded, CodedValue, Coder, INPUTS, Slots};
use scenelang_verify::{Scratch, Tolerances, Truth, Value, World, rules};
use std::marker::PhantomData;

/// Overlaps of less than this are rounding (metres).
const TOUCHING: f64 = 1e-7;

/// How a term is judged here.
enum Judge {
    /// An object is in a rectangular room.
    Inside(usize, (Field, [f64; 2])),
    /// By its code.
    Code(Coded),
    /// It speaks of the turn of one object only, whose yaws are chosen so that it holds.
    Turn,
    /// Not here.
    Absent,
}

/// What a rule sets, as code.
struct CodedRule {
    owner: usize,
    sets: Sets,
    value: CodedValue,
}

/// The upright box around an object.
#[derive(Clone, Copy, Debug, Default)]
struct Span {
    min: [f64; 3],
    max: [f64; 3],
}

/// A rectangle on the floor, by its least and greatest x and z.
#[derive(Clone, Copy, Debug)]
struct Field {
    min: [f64; 2],
    max: [f64; 2],
}

/// A layout under quick search.
pub(crate) struct Quick<'a> {
    frame: &'a Frame<'a>,
    tolerances: Tolerances,
    numbering: Numbering,
    slots: Slots,
    judges: Vec<Judge>,
    rules: Vec<CodedRule>,
    /// By object: rules to be obeyed when it moves, in order.
    followers: Vec<Vec<usize>>,
    /// By object: its terms, cheap ones first.
    terms_of: Vec<Vec<usize>>,
    size: Vec<[f64; 3]>,
    span: Vec<Span>,
    /// Whether P-COLLIDE speaks of a pair.
    collide: Vec<bool>,
    rests: Vec<bool>,
    /// By object: whether P-BOUNDS speaks of it and no term says the same.
    bounded: Vec<bool>,
    rooms: Vec<(Field, [f64; 2])>,
    floor: f64,
    /// By object: yaws to choose from.
    yaws: Vec<Vec<f64>>,
    /// By object: whether other yaws are worth a try.
    turns: Vec<bool>,
    /// By object: where its centre may be, its extents not counted.
    field: Vec<Field>,
    /// By object: others that it shares terms with.
    related: Vec<Vec<usize>>,
    movable: Vec<usize>,
    cost: Vec<f64>,
    weight: Vec<f64>,
    /// What is violated, and by check where it stands in that list.
    bad: Vec<usize>,
    bad_at: Vec<u32>,
    /// By object: others that it overlaps.
    hits: Vec<Vec<usize>>,
    /// By object: whether it stands on something else than a floor.
    raised: Vec<bool>,
    moved: Vec<(usize, [f64; INPUTS], Span)>,
    fresh: Vec<(usize, f64, bool)>,
    stamp: Vec<u32>,
    now: u32,
    /// Work done.
    pub work: u64,
}

/// Truths of code that has run.
struct Ran<'r> {
    code: &'r Coded,
    slots: &'r Slots,
}

impl Truths<f64> for Ran<'_> {
    fn truth(&self, node: NodeId) -> Option<Truth<f64>> {
        self.code.truth(node, self.slots)
    }
}

impl<'a> Quick<'a> {
    /// For a layout; `None`: something that must hold cannot be judged here.
    pub fn new(state: &State<'a>) -> Option<Self> {
        let frame = state.frame;
        let world = &state.world;
        let n = frame.program.objects.len();
        let still = |id: ObjectId| !frame.is_movable(id) && frame.sources[id.0 as usize].is_empty();
        let plain = |id: &ObjectId| {
            let held = matches!(frame.hold(*id), Hold::Rests | Hold::Floats);
            let upright = state.pose(*id).is_upright() && !frame.tilts[id.0 as usize];
            held && upright && world.object(*id).is_ok_and(|thing| thing.body.is_box())
        };
        if n == 0 || !frame.objects().all(|id| plain(&id)) {
            return None;
        }
        let mut rooms = Vec::new();
        for (_, prism) in world.prisms() {
            rooms.push(rectangle(prism)?);
        }
        let floor = rooms.first().map_or(0.0, |(_, [floor, _])| *floor);
        if rooms.iter().any(|(_, [other, _])| *other != floor) {
            return None;
        }
        let mut coder = Coder::new(frame.program, world, &still);
        let mut judges = Vec::with_capacity(frame.terms.len());
        for term in &frame.terms {
            judges.push(if !term.is_hard() || term.sizes_only {
                Judge::Absent
            } else if let Some(inside) = in_rectangle(&term.formula, world) {
                Judge::Inside(inside.0, inside.1)
            } else if let Some(code) = coder.truth(&term.formula) {
                Judge::Code(code)
            } else if turned(&term.formula).is_some() {
                Judge::Turn
            } else {
                return None;
            });
        }
        let mut rules = Vec::new();
        for rule in &frame.rules.list {
            rules.push(CodedRule { owner: rule.owner.0 as usize, sets: rule.sets, value: coder.value(&rule.formula)? });
        }
        let size = frame.objects().map(|id| state.pose(id).scale.into()).collect();
        let scope = frame.scope.as_ref();
        let mut collide = vec![false; n * n];
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            collide[i * n + j] = scope.is_some_and(|s| s.collide(ObjectId(i as u32), ObjectId(j as u32)));
        }
        let holds_inside = |id: ObjectId| {
            frame.terms_of[id.0 as usize]
                .iter()
                .any(|&t| frame.terms[t].is_hard() && inside_of(&frame.terms[t].formula, id).is_some())
        };
        let mut quick = Self {
            tolerances: world.options.tolerances,
            numbering: state.numbering,
            slots: coder.slots(),
            followers: Vec::new(),
            terms_of: Vec::new(),
            size,
            span: vec![Span::default(); n],
            collide,
            rests: frame.objects().map(|id| scope.is_some_and(|s| s.support(id) == rules::Support::Rests)).collect(),
            bounded: frame
                .objects()
                .map(|id| scope.is_some_and(|s| s.bounds(id)) && !rooms.is_empty() && !holds_inside(id))
                .collect(),
            floor,
            yaws: Vec::new(),
            turns: Vec::new(),
            field: Vec::new(),
            related: frame.related.iter().map(|l| l.iter().map(|(o, _)| o.0 as usize).collect()).collect(),
            movable: (0..n).filter(|&i| frame.is_movable(ObjectId(i as u32))).collect(),
            cost: vec![0.0; state.numbering.len()],
            weight: vec![1.0; state.numbering.len()],
            bad: Vec::new(),
            bad_at: vec![u32::MAX; state.numbering.len()],
            hits: vec![Vec::new(); n],
            raised: vec![false; n],
            moved: Vec::new(),
            fresh: Vec::new(),
            stamp: vec![0; state.numbering.len()],
            now: 0,
            work: 0,
            rooms,
            rules,
            judges,
            frame,
        };
        quick.followers = frame.objects().map(|id| quick.followers_of(id)).collect();
        quick.terms_of = (0..n).map(|i| quick.sorted_terms(i)).collect();
        for id in frame.objects() {
            let domain = quick.yaws_of(state, id)?;
            quick.turns.push(!frame.fixed(id).rot);
            quick.yaws.push(domain);
            let field = quick.field_of(id, world);
            quick.field.push(field);
        }
        Some(quick)
    }

    /// Rules that have something new to say when an object moves. One of its own that reads only what it fixes itself,
    /// such as its height over the floor, has not.
    fn followers_of(&self, id: ObjectId) -> Vec<usize> {
        let all = &self.frame.followers[id.0 as usize];
        let fixed = self.frame.fixed(id);
        let moves = |owner: ObjectId| all.iter().any(|&r| self.rules[r].owner == owner.0 as usize);
        let news = |rule: &CodedRule| {
            rule.value.reads().any(|(o, input)| if o == id { input > 2 || !fixed.pos[input] } else { moves(o) })
        };
        all.iter().copied().filter(|&r| self.rules[r].owner != id.0 as usize || news(&self.rules[r])).collect()
    }

    fn sorted_terms(&self, i: usize) -> Vec<usize> {
        let mut list: Vec<usize> = self.frame.terms_of[i].to_vec();
        list.retain(|&t| matches!(self.judges[t], Judge::Code(_) | Judge::Inside(..)));
        list.sort_by_key(|&t| (self.frame.terms[t].objects.len(), self.frame.terms[t].formula.nodes.len()));
        list
    }

    /// Quarter turns, and whatever turns its terms name, as far as the terms that speak of its turn alone allow them.
    fn yaws_of(&self, state: &State<'_>, id: ObjectId) -> Option<Vec<f64>> {
        let now = state.pose(id).rot.y;
        if self.frame.fixed(id).rot {
            return Some(vec![now]);
        }
        let terms: Vec<usize> = self.frame.terms_of[id.0 as usize]
            .iter()
            .copied()
            .filter(|&t| matches!(self.judges[t], Judge::Turn))
            .collect();
        let mut yaws = vec![0.0, 90.0, 180.0, 270.0];
        for &t in &terms {
            let formula = &self.frame.terms[t].formula;
            for node in &formula.nodes {
                if let Node::Rotation([_, y, _]) = node
                    && let Node::Number(yaw) = formula.node(*y)
                {
                    yaws.push(crate::pose::round_turn(*yaw));
                }
            }
        }
        yaws.sort_by(f64::total_cmp);
        yaws.dedup();
        if terms.is_empty() {
            return Some(yaws);
        }
        let mut world = state.world.clone();
        let mut scratch = Scratch::new();
        yaws.retain(|yaw| {
            let [pos, rot, scale] = state.pose(id).facing(*yaw).constant();
            world.place(id, pos, rot, scale);
            let holds = |t: &usize, scratch: &mut Scratch<f64>| {
                matches!(scratch.evaluate(&self.frame.terms[*t].formula, &world), Ok(Value::Truth(v)) if v.holds)
            };
            terms.iter().all(|t| holds(t, &mut scratch))
        });
        (!yaws.is_empty()).then_some(yaws)
    }

    /// The regions that it must be in, all at once.
    fn field_of(&self, id: ObjectId, world: &World<f64>) -> Field {
        let span = |region: RegionId| {
            let room = world.region(region).ok()?;
            let corners = room.prism.polygon.corners();
            let low = corners.iter().copied().reduce(|a, b| a.inf(&b))?;
            let high = corners.iter().copied().reduce(|a, b| a.sup(&b))?;
            Some(Field { min: [low.x, low.y], max: [high.x, high.y] })
        };
        let named = self.frame.terms_of[id.0 as usize]
            .iter()
            .filter(|&&t| self.frame.terms[t].is_hard())
            .filter_map(|&t| inside_of(&self.frame.terms[t].formula, id))
            .filter_map(span);
        let meet = |a: Field, b: Field| Field {
            min: [a.min[0].max(b.min[0]), a.min[1].max(b.min[1])],
            max: [a.max[0].min(b.max[0]), a.max[1].min(b.max[1])],
        };
        let join = |a: Field, b: Field| Field {
            min: [a.min[0].min(b.min[0]), a.min[1].min(b.min[1])],
            max: [a.max[0].max(b.max[0]), a.max[1].max(b.max[1])],
        };
        let around = self.rooms.iter().map(|(field, _)| *field).reduce(join);
        named.reduce(meet).or(around).unwrap_or(Field { min: [-5.0; 2], max: [5.0; 2] })
    }

    fn count(&self) -> usize {
        self.size.len()
    }

    fn inputs(&self, i: usize) -> [f64; INPUTS] {
        self.slots.get(ObjectId(i as u32))
    }

    /// Puts an object somewhere, without a look at anything.
    fn put(&mut self, i: usize, inputs: [f64; INPUTS]) {
        self.slots.put(ObjectId(i as u32), inputs);
        let ([w, h, d], [x, y, z, _, sin, cos]) = (self.size[i], inputs);
        let (rx, rz) = ((cos.abs() * w + sin.abs() * d) / 2.0, (sin.abs() * w + cos.abs() * d) / 2.0);
        self.span[i] = Span { min: [x - rx, y, z - rz], max: [x + rx, y + h, z + rz] };
    }

    /// Begins a trial: an object goes somewhere, and what its rules tie to it goes along.
    fn go(&mut self, i: usize, mut inputs: [f64; INPUTS]) {
        let id = ObjectId(i as u32);
        let (fixed, old) = (self.frame.fixed(id), self.inputs(i));
        (0..3).filter(|&k| fixed.pos[k]).for_each(|k| inputs[k] = old[k]);
        if fixed.rot {
            inputs[3..].copy_from_slice(&old[3..]);
        }
        self.shift(i, inputs);
        for at in 0..self.followers[i].len() {
            let rule = self.followers[i][at];
            self.obey(rule);
        }
    }

    fn obey(&mut self, rule: usize) {
        let CodedRule { owner, sets, value } = &self.rules[rule];
        let owner = *owner;
        let found = value.run(&mut self.slots);
        let mut next = self.slots.get(ObjectId(owner as u32));
        match *sets {
            Sets::Pos => next[..3].copy_from_slice(&found),
            Sets::Axis(axis, per) => next[axis] -= found[0] / per,
            Sets::Shift(per) => (0..3).for_each(|k| next[k] -= found[k] / per),
            Sets::Rot | Sets::Yaw => {
                let yaw = if *sets == Sets::Rot { found[1] } else { found[0] };
                let (sin, cos) = scenelang_layout::rotation::sin_cos(yaw);
                next[3..].copy_from_slice(&[crate::pose::round_turn(yaw), sin, cos]);
            }
            Sets::Scale => return,
        }
        if next != self.inputs(owner) {
            self.shift(owner, next);
        }
    }

    fn shift(&mut self, i: usize, inputs: [f64; INPUTS]) {
        if !self.moved.iter().any(|(o, ..)| *o == i) {
            self.moved.push((i, self.inputs(i), self.span[i]));
        }
        self.put(i, inputs);
    }

    /// Takes a trial back.
    fn undo(&mut self) {
        while let Some((i, inputs, span)) = self.moved.pop() {
            self.slots.put(ObjectId(i as u32), inputs);
            self.span[i] = span;
        }
    }

    /// By how much a trial costs more than what was before; `None`: more than `limit`.
    fn judge(&mut self, limit: f64) -> Option<f64> {
        self.fresh.clear();
        self.now = self.now.wrapping_add(1);
        let moved = std::mem::take(&mut self.moved);
        let delta = self.judge_moved(&moved, limit);
        self.moved = moved;
        delta
    }

    fn judge_moved(&mut self, moved: &[(usize, [f64; INPUTS], Span)], limit: f64) -> Option<f64> {
        let mut delta = 0.0;
        // What these cost before.
        for &(i, ..) in moved {
            let id = ObjectId(i as u32);
            for check in [self.numbering.bounds(id), self.numbering.support(id)] {
                delta -= self.weight[check] * self.cost[check];
            }
            for at in 0..self.terms_of[i].len() {
                let t = self.terms_of[i][at];
                if self.stamp[t] != self.now {
                    self.stamp[t] = self.now;
                    delta -= self.weight[t] * self.cost[t];
                }
            }
            for &j in &self.hits[i] {
                let check = self.numbering.collide(id, ObjectId(j as u32));
                if self.stamp[check] != self.now {
                    self.stamp[check] = self.now;
                    delta -= self.weight[check] * self.cost[check];
                }
            }
        }
        self.now = self.now.wrapping_add(1);
        for &(i, ..) in moved {
            let check = self.numbering.bounds(ObjectId(i as u32));
            if self.bounded[i] {
                let found = self.bounds(i);
                delta += self.note(check, found);
            }
            let check = self.numbering.support(ObjectId(i as u32));
            if self.rests[i] {
                let found = self.support(i);
                delta += self.note(check, found);
            }
            if delta > limit {
                return None;
            }
        }
        for &(i, ..) in moved {
            delta += self.collisions(i, moved);
            if delta > limit {
                return None;
            }
        }
        let alone = moved.len() == 1;
        for &(i, ..) in moved {
            for at in 0..self.terms_of[i].len() {
                let t = self.terms_of[i][at];
                if !alone && std::mem::replace(&mut self.stamp[t], self.now) == self.now {
                    continue;
                }
                let found = self.term(t);
                delta += self.note(t, found);
                if delta > limit {
                    // What often decides is asked earlier the next time.
                    self.terms_of[i].swap(at, at.saturating_sub(1));
                    return None;
                }
            }
        }
        delta += self.others_above(moved);
        (delta <= limit).then_some(delta)
    }

    fn note(&mut self, check: usize, (cost, holds): (f64, bool)) -> f64 {
        self.fresh.push((check, cost, holds));
        self.weight[check] * cost
    }

    fn term(&mut self, t: usize) -> (f64, bool) {
        let code = match &self.judges[t] {
            Judge::Code(code) => code,
            Judge::Inside(i, room) => {
                let contact = self.tolerances.contact;
                return self.physical(clearance(&self.span[*i], room) + contact, contact);
            }
            Judge::Turn | Judge::Absent => return (0.0, true),
        };
        self.work += 3 + self.frame.terms[t].formula.nodes.len() as u64 / 2;
        code.run(&mut self.slots);
        let ran = Ran { code, slots: &self.slots };
        let merit = Merit {
            formula: &self.frame.terms[t].formula,
            values: &ran,
            tolerances: &self.tolerances,
            numbers: PhantomData,
        };
        merit.both()
    }

    fn physical(&self, margin: f64, target: f64) -> (f64, bool) {
        let holds = margin >= -self.tolerances.order;
        (merit::cost(holds, target - margin), holds)
    }

    fn bounds(&self, i: usize) -> (f64, bool) {
        let span = &self.span[i];
        let best = self.rooms.iter().map(|room| clearance(span, room)).fold(f64::NEG_INFINITY, f64::max);
        let contact = self.tolerances.contact;
        self.physical(best + contact, contact)
    }

    /// On a floor, or with its middle over a top that it touches. Standing on the edges of several things is left to the
    /// search proper.
    fn support(&self, i: usize) -> (f64, bool) {
        let tolerance = self.tolerances.support;
        let target = tolerance.min(self.tolerances.contact);
        let bottom = self.span[i].min[1];
        let mut off = (bottom - self.floor).abs();
        if off > target {
            let [x, _, z, ..] = self.inputs(i);
            for j in 0..self.count() {
                let other = &self.span[j];
                if j != i
                    && (other.min[0]..=other.max[0]).contains(&x)
                    && (other.min[2]..=other.max[2]).contains(&z)
                    && self.is_over(j, x, z)
                {
                    off = off.min((bottom - other.max[1]).abs());
                }
            }
        }
        self.physical(tolerance - off, target)
    }

    fn is_over(&self, j: usize, x: f64, z: f64) -> bool {
        let [ox, _, oz, _, sin, cos] = self.inputs(j);
        let (dx, dz) = (x - ox, z - oz);
        (dx * cos - dz * sin).abs() <= self.size[j][0] / 2.0 && (dx * sin + dz * cos).abs() <= self.size[j][2] / 2.0
    }

    /// What overlaps of one of the moved objects cost now.
    fn collisions(&mut self, i: usize, moved: &[(usize, [f64; INPUTS], Span)]) -> f64 {
        let n = self.count();
        let own = self.span[i];
        let mut sum = 0.0;
        self.work += 2 + n as u64 / 8;
        for j in 0..n {
            let other = &self.span[j];
            let apart = own.min[0] >= other.max[0] - TOUCHING
                || other.min[0] >= own.max[0] - TOUCHING
                || own.min[2] >= other.max[2] - TOUCHING
                || other.min[2] >= own.max[2] - TOUCHING
                || own.min[1] >= other.max[1] - TOUCHING
                || other.min[1] >= own.max[1] - TOUCHING;
            if apart || !self.collide[i * n + j] || j < i && moved.iter().any(|(m, ..)| *m == j) {
                continue;
            }
            let gap = self.gap(i, j);
            if gap < -TOUCHING {
                let contact = self.tolerances.contact;
                let found = self.physical(gap + contact, contact - TOUCHING);
                let check = self.numbering.collide(ObjectId(i as u32), ObjectId(j as u32));
                sum += self.note(check, found);
            }
        }
        sum
    }

    /// The signed gap of two upright boxes that may overlap.
    fn gap(&self, i: usize, j: usize) -> f64 {
        let (a, b) = (&self.span[i], &self.span[j]);
        let along = |k: usize| (a.min[k] - b.max[k]).max(b.min[k] - a.max[k]);
        let mut gap = along(0).max(along(1)).max(along(2));
        let (p, q) = (self.inputs(i), self.inputs(j));
        let square = |v: &[f64; INPUTS]| v[4] == 0.0 || v[5] == 0.0;
        if square(&p) && square(&q) {
            return gap;
        }
        gap = along(1);
        let way = [q[0] - p[0], q[2] - p[2]];
        let half = |k: usize| [self.size[k][0] / 2.0, self.size[k][2] / 2.0];
        for axes in [&p, &q] {
            for axis in [[axes[5], -axes[4]], [axes[4], axes[5]]] {
                let reach = |v: &[f64; INPUTS], k: usize| {
                    half(k)[0] * (v[5] * axis[0] - v[4] * axis[1]).abs()
                        + half(k)[1] * (v[4] * axis[0] + v[5] * axis[1]).abs()
                };
                gap = gap.max((way[0] * axis[0] + way[1] * axis[1]).abs() - reach(&p, i) - reach(&q, j));
            }
        }
        gap
    }

    /// What stands on something: its carrier may have come or gone.
    fn others_above(&mut self, moved: &[(usize, [f64; INPUTS], Span)]) -> f64 {
        let mut sum = 0.0;
        for k in 0..self.count() {
            if !self.raised[k] || moved.iter().any(|(m, ..)| *m == k) {
                continue;
            }
            let span = self.span[k];
            let over = |s: &Span| {
                s.min[0] < span.max[0] && span.min[0] < s.max[0] && s.min[2] < span.max[2] && span.min[2] < s.max[2]
            };
            if moved.iter().any(|(m, _, old)| over(old) || over(&self.span[*m])) {
                let check = self.numbering.support(ObjectId(k as u32));
                let found = self.support(k);
                sum += self.note(check, found) - self.weight[check] * self.cost[check];
            }
        }
        sum
    }

    /// Keeps a trial that was judged to its end.
    fn keep(&mut self) {
        let moved = std::mem::take(&mut self.moved);
        for &(i, ..) in &moved {
            for j in std::mem::take(&mut self.hits[i]) {
                self.hits[j].retain(|k| *k != i);
                self.set(self.numbering.collide(ObjectId(i as u32), ObjectId(j as u32)), 0.0, true);
            }
            self.raised[i] = self.rests[i] && self.span[i].min[1] > self.floor + self.tolerances.support;
        }
        let fresh = std::mem::take(&mut self.fresh);
        for &(check, cost, holds) in &fresh {
            self.set(check, cost, holds);
            if let Check::Collide(a, b) = self.numbering.check(check) {
                self.hits[a.0 as usize].push(b.0 as usize);
                self.hits[b.0 as usize].push(a.0 as usize);
            }
        }
        self.fresh = fresh;
        self.moved = moved;
        self.moved.clear();
    }

    fn set(&mut self, check: usize, cost: f64, holds: bool) {
        self.cost[check] = cost;
        let at = self.bad_at[check];
        if holds && at != u32::MAX {
            self.bad.swap_remove(at as usize);
            self.bad_at[check] = u32::MAX;
            if let Some(&last) = self.bad.get(at as usize) {
                self.bad_at[last] = at;
            }
        } else if !holds && at == u32::MAX {
            self.bad_at[check] = self.bad.len() as u32;
            self.bad.push(check);
        }
    }

    /// The layout as changes of the search proper.
    pub fn changes(&self, state: &State<'_>) -> Vec<Change> {
        let pose = |id: ObjectId| {
            let [x, y, z, yaw, ..] = self.slots.get(id);
            Pose { rot: Vec3::new(0.0, yaw, 0.0), pos: Vec3::new(x, y, z), ..state.pose(id) }
        };
        self.frame.objects().map(|id| Change::Object(id, pose(id))).collect()
    }
}

/// The least of three clearances of an upright box in a rectangular room.
fn clearance(span: &Span, (field, [floor, ceiling]): &(Field, [f64; 2])) -> f64 {
    let x = (span.min[0] - field.min[0]).min(field.max[0] - span.max[0]);
    let z = (span.min[2] - field.min[1]).min(field.max[1] - span.max[2]);
    x.min(z).min(span.min[1] - floor).min(ceiling - span.max[1])
}

/// A room whose walls run along x and z.
fn rectangle(prism: &Prism) -> Option<(Field, [f64; 2])> {
    let corners = prism.polygon.corners();
    let low = corners.iter().copied().reduce(|a, b| a.inf(&b))?;
    let high = corners.iter().copied().reduce(|a, b| a.sup(&b))?;
    let whole = (prism.area() - (high - low).x * (high - low).y).abs() < 1e-9;
    whole.then(|| (Field { min: [low.x, low.y], max: [high.x, high.y] }, [prism.floor, prism.ceiling]))
}

/// The object and the room of a term that says the one is in the other.
fn in_rectangle(formula: &Formula, world: &World<f64>) -> Option<(usize, (Field, [f64; 2]))> {
    let [id] = formula.objects()[..] else { return None };
    let room = world.region(inside_of(formula, id)?).ok()?;
    Some((id.0 as usize, rectangle(&room.prism)?))
}

/// The object whose turn is all that a formula reads of objects.
fn turned(formula: &Formula) -> Option<ObjectId> {
    let mut found = None;
    for node in &formula.nodes {
        match node {
            Node::Object(ObjectProperty::Rot, id) if found.is_none_or(|f| f == *id) => found = Some(*id),
            Node::Object(..) | Node::Native(..) | Node::Measure(..) | Node::Variable(_) => return None,
            _ => {}
        }
    }
    found
}

/// The region that a term says an object is inside of.
fn inside_of(formula: &Formula, id: ObjectId) -> Option<RegionId> {
    match formula.root_node() {
        Node::Native(Native::Inside, args) => match **args {
            [Arg::Object(o), Arg::Region(r)] if o == id => Some(r),
            _ => None,
        },
        _ => None,
    }
}
