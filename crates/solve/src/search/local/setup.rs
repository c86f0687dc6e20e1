//! What the local search knows of each object before it begins: where it may be, and where it belongs.

use super::{Home, LocalSearch};
use scenelang_engine::frame::{Frame, Hold};
use scenelang_engine::trial::{Field, RoomBox, Stretch, inside_of, stretches};
use scenelang_lang::program::{Formula, Node, ObjectId, ObjectProperty, RegionId};
use scenelang_verify::World;

/// Where one looks in a scene without rooms (metres).
const OPEN: Field = Field { min: [-5.0; 2], max: [5.0; 2] };

impl LocalSearch<'_> {
    /// Floors that it may stand on.
    pub(super) fn levels_of(&self, id: ObjectId) -> Vec<f64> {
        let named =
            rooms_named(self.trial.frame, id).filter_map(|region| self.trial.room(region)).map(|room| room.floor);
        let mut levels: Vec<f64> = named.collect();
        if levels.is_empty() {
            levels.extend(self.trial.rooms.iter().map(|room| room.floor));
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
        let named =
            rooms_named(self.trial.frame, id).filter_map(|region| self.trial.room(region)).map(|room| room.field);
        let around = || self.trial.rooms.iter().map(|room| room.field).reduce(Field::join);
        named.reduce(Field::meet).or_else(around).unwrap_or(OPEN)
    }

    /// Narrows the field of an object that others follow at fixed distances, so that all of them are in theirs.
    pub(super) fn heed_followers(&mut self, i: usize) {
        let owners: Vec<usize> = self.trial.followers[i].iter().map(|&rule| self.trial.rules[rule].owner).collect();
        if owners.is_empty() {
            return;
        }
        let start = self.trial.inputs(i);
        let mut there = start;
        (there[0], there[2]) = (start[0] + 1.0, start[2] + 2.0);
        let offsets = |local: &Self| -> Vec<[f64; 2]> {
            let here = local.trial.inputs(i);
            owners.iter().map(|&k| local.trial.inputs(k)).map(|at| [at[0] - here[0], at[2] - here[2]]).collect()
        };
        self.trial.go(i, start);
        let before = offsets(self);
        self.trial.undo();
        self.trial.go(i, there);
        let after = offsets(self);
        let turns = self.trial.yaws[i].len() > 1 || self.trial.turns[i];
        let mut field = self.field[i];
        for (at, &k) in owners.iter().enumerate() {
            let off = before[at];
            if turns || (0..2).any(|axis| (off[axis] - after[at][axis]).abs() > 1e-9) {
                continue;
            }
            let reach = |k: usize| <[f64; 2]>::from(self.reach(k, &self.trial.inputs(k)));
            let (own, theirs) = (reach(i), reach(k));
            for axis in 0..2 {
                let more = theirs[axis] - own[axis];
                field.min[axis] = field.min[axis].max(self.field[k].min[axis] - off[axis] + more);
                field.max[axis] = field.max[axis].min(self.field[k].max[axis] - off[axis] - more);
            }
        }
        self.trial.undo();
        if (0..2).all(|axis| field.min[axis] < field.max[axis]) {
            self.field[i] = field;
        }
    }

    /// Where it belongs.
    pub(super) fn home_of(&self, id: ObjectId, field: Field, world: &World<f64>) -> Home {
        match self.known_home(id, world) {
            Some(home) => home,
            None => {
                let mut walls = field.walls();
                let known = self.trial.frame.regions[id.0 as usize].iter().filter_map(|r| self.trial.room(*r));
                let outlined = |room: &&RoomBox| room.outline.is_some();
                walls.extend(known.filter(outlined).flat_map(|room| room.walls.iter().copied()));
                Home::Stands(walls)
            }
        }
    }

    /// Where something is held, if there is such a place.
    fn known_home(&self, id: ObjectId, world: &World<f64>) -> Option<Home> {
        Some(match self.trial.frame.hold(id) {
            Hold::Rests | Hold::Floats => return None,
            Hold::Wall(region) => Home::Hangs(self.trial.room(region)?.walls.clone()),
            Hold::Ceiling(region) => Home::Ceiling(self.trial.room(region)?.ceiling),
            Hold::Door(first, second) => {
                let second = second.and_then(|second| self.trial.room(second));
                let found: Vec<Stretch> = stretches(world, self.trial.room(first)?, second);
                (!found.is_empty()).then_some(Home::Door(found))?
            }
            Hold::Container(container) => Home::Within(container.0 as usize),
        })
    }

    /// Outlines that it must be in and that are no rectangles.
    pub(super) fn outlines_of(&self, id: ObjectId) -> Vec<usize> {
        let named = rooms_named(self.trial.frame, id);
        let index =
            |region: RegionId| self.trial.rooms.iter().position(|room| room.id == region && room.outline.is_some());
        named.filter_map(index).collect()
    }
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
