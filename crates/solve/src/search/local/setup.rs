//! What the local search knows of each object before it begins: what moves with it, its terms, its turns, its home.

use super::rooms::{Field, Room, Stretch, stretches};
use super::{CodedRule, Home, Judge, LocalSearch};
use crate::problem::pose::Pose;
use scenelang_engine::frame::{Frame, Hold};
use scenelang_lang::program::{Formula, Node, ObjectId, ObjectProperty, RegionId};
use scenelang_verify::coded::Block;
use scenelang_verify::{Scratch, Value, World};

/// Where one looks in a scene without rooms (metres).
const OPEN: Field = Field { min: [-5.0; 2], max: [5.0; 2] };

impl LocalSearch<'_> {
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

    /// Floors that it may stand on.
    pub(super) fn levels_of(&self, id: ObjectId) -> Vec<f64> {
        let named = rooms_named(self.frame, id).filter_map(|region| self.room(region)).map(|room| room.floor);
        let mut levels: Vec<f64> = named.collect();
        if levels.is_empty() {
            levels.extend(self.rooms.iter().map(|room| room.floor));
        }
        if levels.is_empty() {
            levels.push(0.0);
        }
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        levels
    }

    /// The regions that it must be in, all at once.
    pub(super) fn field_of(&self, id: ObjectId) -> Field {
        let named = rooms_named(self.frame, id).filter_map(|region| self.room(region)).map(|room| room.field);
        let around = || self.rooms.iter().map(|room| room.field).reduce(Field::join);
        named.reduce(Field::meet).or_else(around).unwrap_or(OPEN)
    }

    /// Narrows the field of an object that others follow at fixed distances, so that all of them are in theirs.
    pub(super) fn heed_followers(&mut self, i: usize) {
        let owners: Vec<usize> = self.followers[i].iter().map(|&rule| self.rules[rule].owner).collect();
        if owners.is_empty() {
            return;
        }
        let start = self.inputs(i);
        let mut there = start;
        (there[0], there[2]) = (start[0] + 1.0, start[2] + 2.0);
        let offsets = |local: &Self| -> Vec<[f64; 2]> {
            let here = local.inputs(i);
            owners.iter().map(|&k| local.inputs(k)).map(|at| [at[0] - here[0], at[2] - here[2]]).collect()
        };
        self.go(i, start);
        let before = offsets(self);
        self.undo();
        self.go(i, there);
        let after = offsets(self);
        let turns = self.yaws[i].len() > 1 || self.turns[i];
        let mut field = self.field[i];
        for (at, &k) in owners.iter().enumerate() {
            let off = before[at];
            if turns || (0..2).any(|axis| (off[axis] - after[at][axis]).abs() > 1e-9) {
                continue;
            }
            let reach = |k: usize| <[f64; 2]>::from(self.reach(k, &self.inputs(k)));
            let (own, theirs) = (reach(i), reach(k));
            for axis in 0..2 {
                let more = theirs[axis] - own[axis];
                field.min[axis] = field.min[axis].max(self.field[k].min[axis] - off[axis] + more);
                field.max[axis] = field.max[axis].min(self.field[k].max[axis] - off[axis] - more);
            }
        }
        self.undo();
        if (0..2).all(|axis| field.min[axis] < field.max[axis]) {
            self.field[i] = field;
        }
    }

    /// The room of a region.
    pub(super) fn room(&self, id: RegionId) -> Option<&Room> {
        self.rooms.iter().find(|room| room.id == id)
    }

    /// Where it belongs.
    pub(super) fn home_of(&self, id: ObjectId, field: Field, world: &World<f64>) -> Home {
        match self.known_home(id, world) {
            Some(home) => home,
            None => {
                let mut walls = field.walls();
                let known = self.frame.regions[id.0 as usize].iter().filter_map(|r| self.room(*r));
                let outlined = |room: &&Room| room.outline.is_some();
                walls.extend(known.filter(outlined).flat_map(|room| room.walls.iter().copied()));
                Home::Stands(walls)
            }
        }
    }

    /// Where something is held, if there is such a place.
    fn known_home(&self, id: ObjectId, world: &World<f64>) -> Option<Home> {
        Some(match self.frame.hold(id) {
            Hold::Rests | Hold::Floats => return None,
            Hold::Wall(region) => Home::Hangs(self.room(region)?.walls.clone()),
            Hold::Ceiling(region) => Home::Ceiling(self.room(region)?.ceiling),
            Hold::Door(first, second) => {
                let second = second.and_then(|second| self.room(second));
                let found: Vec<Stretch> = stretches(world, self.room(first)?, second);
                (!found.is_empty()).then_some(Home::Door(found))?
            }
            Hold::Container(container) => Home::Within(container.0 as usize),
        })
    }

    /// Outlines that it must be in and that are no rectangles.
    pub(super) fn outlines_of(&self, id: ObjectId) -> Vec<usize> {
        let named = rooms_named(self.frame, id);
        let index = |region: RegionId| self.rooms.iter().position(|room| room.id == region && room.outline.is_some());
        named.filter_map(index).collect()
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
                yaws.push(crate::problem::pose::round_turn(*yaw));
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

/// Others that the program may ask an object to go onto: those whose height is compared with its own. Where something must be
/// on something, preferences have no say: guidelines compare the heights of all things.
pub(super) fn carriers(frame: &Frame<'_>, id: ObjectId) -> Vec<usize> {
    let mut found: Vec<usize> = frame.sources[id.0 as usize].iter().map(|o| o.0 as usize).collect();
    for hard in [true, false] {
        let terms = frame.index.of_object(id).iter().map(|&t| &frame.terms[t]);
        found.extend(terms.filter(|term| term.is_hard() == hard).flat_map(|term| compared(&term.formula, id)));
        if !found.is_empty() {
            break;
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// Objects whose tops a formula compares with the base of one.
fn compared(formula: &Formula, id: ObjectId) -> Vec<usize> {
    use ObjectProperty::{Bottom, Pos, Surface, Top};
    let own = |node: &Node| matches!(node, Node::Object(Bottom | Pos, o) if *o == id);
    if !formula.nodes.iter().any(own) {
        return Vec::new();
    }
    let top = |node: &Node| match node {
        Node::Object(Surface | Top, o) if *o != id => Some(o.0 as usize),
        _ => None,
    };
    formula.nodes.iter().filter_map(top).collect()
}

/// The regions that hard terms say an object is in.
fn rooms_named<'f>(frame: &'f Frame<'_>, id: ObjectId) -> impl Iterator<Item = RegionId> + 'f {
    let terms = frame.index.of_object(id).iter().filter(|&&t| frame.terms[t].is_hard());
    terms.filter_map(move |&t| inside_of(&frame.terms[t].formula, id))
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
pub(super) fn inside_of(formula: &Formula, id: ObjectId) -> Option<RegionId> {
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
