//! What is known of terms and objects before anything moves: how each term is judged, what goes along with an object, the
//! turns that it may have.

use super::paths::PathRequest;
use super::{Clear, CodedRule, Judge, Mixed, PathGroup, RoomBox, Trial};
use crate::frame::Frame;
use crate::frame::terms::Term;
use crate::pose::{Pose, round_turn};
use scenelang_lang::program::{Formula, Node, ObjectId, ObjectProperty, RegionId};
use scenelang_verify::coded::{Block, Coder};
use scenelang_verify::{Scratch, Value, World};

impl Trial<'_> {
    /// Rules that have something new to say when an object moves. One of its own that reads only what it fixes itself,
    /// such as its height over the floor, has not.
    pub(super) fn followers_of(&self, id: ObjectId) -> Vec<usize> {
        let all = &self.frame.followers[id.0 as usize];
        let fixed = self.frame.fixed(id);
        let moves = |owner: ObjectId| all.iter().any(|&r| self.rules[r].owner == owner.0 as usize);
        let news = |rule: &CodedRule| {
            let Some(value) = &rule.value else { return true };
            value.reads().any(|(o, input)| if o == id { input > 2 || !fixed.pos[input] } else { moves(o) })
        };
        all.iter().copied().filter(|&r| self.rules[r].owner != id.0 as usize || news(&self.rules[r])).collect()
    }

    /// Terms that speak of an object, cheap ones first: those that must hold, or preferences.
    pub(super) fn sorted_terms(&self, i: usize, hard: bool) -> Vec<usize> {
        let mut list: Vec<usize> = self.frame.index.of_object(ObjectId(i as u32)).to_vec();
        list.retain(|&t| self.frame.terms[t].is_hard() == hard && self.is_judged_alone(t));
        list.sort_by_key(|&t| (self.frame.terms[t].objects.len(), self.frame.terms[t].formula.nodes.len()));
        list
    }

    /// Whether a term is judged as soon as one of its objects moves.
    pub(super) fn is_judged_alone(&self, t: usize) -> bool {
        matches!(self.judges[t], Judge::Code(_) | Judge::Mixed(_) | Judge::Inside(..) | Judge::Clear(_))
    }

    /// The turns that each object may have.
    pub(super) fn know_turns(&mut self, world: &World<f64>) {
        for id in self.frame.objects() {
            let domain = self.yaws_of(world, id);
            let told = self.frame.index.of_object(id).iter().any(|&t| matches!(self.judges[t], Judge::Turn));
            self.turns.push(!self.frame.fixed(id).rot && !told);
            self.yaws.push(domain);
        }
    }

    /// Quarter turns, and whatever turns its terms name, as far as the terms that speak of its turn alone allow them. Where
    /// they allow none, the evaluator judges them.
    pub(super) fn yaws_of(&mut self, world: &World<f64>, id: ObjectId) -> Vec<f64> {
        if self.frame.fixed(id).rot {
            return vec![self.inputs(id.0 as usize)[3]];
        }
        let of_object = self.frame.index.of_object(id).iter().copied();
        let terms: Vec<usize> = of_object
            .filter(|&t| {
                matches!(self.judges[t], Judge::Turn) || !self.does_lean(id) && is_about_tilt(self.frame, t, id)
            })
            .collect();
        let yaws = yaws_that_hold(self.frame, world, id, &terms);
        if !yaws.is_empty() {
            return yaws;
        }
        terms.into_iter().for_each(|t| self.ask_evaluator(t));
        yaws_that_hold(self.frame, world, id, &[])
    }

    pub fn room(&self, id: RegionId) -> Option<&RoomBox> {
        self.rooms.iter().find(|room| room.id == id)
    }
}

/// Turns in which an object fulfils, upright, what the program says of its tilt alone.
pub(super) fn upright_yaws(frame: &Frame<'_>, world: &World<f64>, id: ObjectId) -> Vec<f64> {
    let of_object = frame.index.of_object(id).iter().copied();
    let terms: Vec<usize> = of_object.filter(|&t| is_about_tilt(frame, t, id)).collect();
    yaws_that_hold(frame, world, id, &terms)
}

/// Whether a term says how an object is turned that need not be upright, and nothing else.
fn is_about_tilt(frame: &Frame<'_>, t: usize, id: ObjectId) -> bool {
    frame.tilts[id.0 as usize] && frame.terms[t].is_hard() && turned(&frame.terms[t].formula) == Some(id)
}

/// Quarter turns and those that these terms name, as far as all of the terms hold there.
fn yaws_that_hold(frame: &Frame<'_>, world: &World<f64>, id: ObjectId, terms: &[usize]) -> Vec<f64> {
    let mut yaws = vec![0.0, 90.0, 180.0, 270.0];
    for &t in terms {
        let formula = &frame.terms[t].formula;
        for node in &formula.nodes {
            if let Node::Rotation([_, y, _]) = node
                && let Node::Number(yaw) = formula.node(*y)
            {
                yaws.push(round_turn(*yaw));
            }
        }
    }
    yaws.sort_by(f64::total_cmp);
    yaws.dedup();
    let Some(now) = world.object(id).ok().map(Pose::of).filter(|_| !terms.is_empty()) else { return yaws };
    let mut world = world.clone();
    let mut scratch = Scratch::new();
    yaws.retain(|yaw| {
        let [pos, rot, scale] = now.facing(*yaw).constant();
        world.place(id, pos, rot, scale);
        let holds = |t: &usize, scratch: &mut Scratch<f64>| {
            matches!(scratch.evaluate(&frame.terms[*t].formula, &world), Ok(Value::Truth(v)) if v.holds)
        };
        terms.iter().all(|t| holds(t, &mut scratch))
    });
    yaws
}

/// Whether P-BOUNDS speaks of an object, and no term says the same.
pub(super) fn is_bounded(frame: &Frame<'_>, id: ObjectId) -> bool {
    let says = |&t: &usize| frame.terms[t].is_hard() && inside_of(&frame.terms[t].formula, id).is_some();
    frame.scope.as_ref().is_some_and(|scope| scope.bounds(id)) && !frame.index.of_object(id).iter().any(says)
}

/// Whether P-COLLIDE speaks of a pair: by the first and then the second.
pub(super) fn collide(frame: &Frame<'_>) -> Vec<bool> {
    let pairs = frame.objects().flat_map(|a| frame.objects().map(move |b| (a, b)));
    pairs.map(|(a, b)| frame.scope.as_ref().is_some_and(|scope| scope.collide(a, b))).collect()
}

/// The object and the region of a term that says the one is in the other.
pub(super) fn inside(formula: &Formula) -> Option<(ObjectId, RegionId)> {
    let [id] = formula.objects()[..] else { return None };
    Some((id, inside_of(formula, id)?))
}

/// The object whose turn is all that a formula reads of objects.
pub(super) fn turned(formula: &Formula) -> Option<ObjectId> {
    let mut found = None;
    for node in &formula.nodes {
        match node {
            Node::Object(ObjectProperty::Rot, id) if found.is_none_or(|f| f == *id) => found = Some(*id),
            Node::Object(..) | Node::BuiltIn(..) | Node::Variable(_) => return None,
            _ => {}
        }
    }
    found
}

/// The region that a term says an object is inside of.
pub fn inside_of(formula: &Formula, id: ObjectId) -> Option<RegionId> {
    match formula.root_node() {
        Node::BuiltIn(built_in, args) => built_in.contained(args).filter(|(o, _)| *o == id).map(|(_, region)| region),
        _ => None,
    }
}

/// Where a thing touches what it stands on: the middles of the blocks that reach down to its base, give or take; of one
/// that stands on one block only, its own middle.
pub(super) fn feet(blocks: &[Block], tolerance: f64) -> Vec<[f64; 2]> {
    let bottom = |block: &Block| block.at[1] - block.half[1];
    let lowest = blocks.iter().map(bottom).fold(f64::INFINITY, f64::min);
    let feet: Vec<[f64; 2]> =
        blocks.iter().filter(|b| bottom(b) <= lowest + tolerance).map(|b| [b.at[0], b.at[2]]).collect();
    if feet.len() > 1 { feet } else { vec![[0.0; 2]] }
}

/// What is known before terms are given their judges.
pub(super) struct Known<'k> {
    pub world: &'k World<f64>,
    pub rooms: &'k [RoomBox],
    pub doors: &'k [usize],
    /// Whether an object stands upright.
    pub stands: &'k dyn Fn(ObjectId) -> bool,
    /// Whether what opens of an object is judged on boxes.
    pub has_panels: &'k dyn Fn(usize) -> bool,
    /// Whether corridors can be planned: all rooms share a floor.
    pub plans: bool,
}

/// The fastest judge of each term, and the paths that are planned together.
pub(super) fn judges(frame: &Frame<'_>, known: &Known<'_>, coder: &mut Coder<'_>) -> (Vec<Judge>, Vec<PathGroup>) {
    let mut judges = Vec::with_capacity(frame.terms.len());
    let mut asked = Vec::new();
    for term in &frame.terms {
        match PathRequest::of(judges.len(), &term.formula, (!term.is_hard()).then_some(term.constraint)) {
            Some(path) if known.plans && !term.sizes_only => {
                asked.push(path);
                judges.push(Judge::Absent);
            }
            _ => judges.push(judge(frame, term, known, coder)),
        }
    }
    let mut groups = Vec::new();
    for (index, (group, terms)) in PathRequest::together(&asked, known.world).into_iter().enumerate() {
        terms.iter().for_each(|&t| judges[t] = Judge::Shared(index));
        judges[terms[0]] = Judge::PathGroup(index);
        groups.push(group);
    }
    (judges, groups)
}

/// The judge of a term that asks for no path that is planned.
fn judge(frame: &Frame<'_>, term: &Term, known: &Known<'_>, coder: &mut Coder<'_>) -> Judge {
    let formula = &term.formula;
    if term.sizes_only {
        return Judge::Absent;
    }
    let room = |region: RegionId| known.rooms.iter().position(|room| room.id == region);
    let inside = inside(formula).filter(|(id, _)| (known.stands)(*id));
    if let Some((id, room)) = inside.and_then(|(id, region)| Some((id, room(region)?))) {
        return Judge::Inside(id.0 as usize, room);
    }
    let clear = |node: &Node, formula: &Formula| {
        let clear = Clear::of(node, formula, known.doors, known.world);
        clear.filter(|clear| (known.stands)(ObjectId(clear.owner as u32)))
    };
    if let Some(clear) = clear(formula.root_node(), formula) {
        return Judge::Clear(clear);
    }
    let (code, missing) = coder.partly(formula);
    if missing.is_empty() {
        Judge::Code(code)
    } else if term.is_hard() && turned(formula).is_some_and(known.stands) {
        Judge::Turn
    } else {
        Judge::Mixed(Mixed::new(formula, code, &missing, clear, known.has_panels, frame.program.objects.len()))
    }
}
