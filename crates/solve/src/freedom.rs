//! What a program leaves open: in which directions each object could go, how far, and whether it could turn, by itself,
//! with everything that holds still holding.

use crate::problem::setup::setup;
use crate::problem::{Options, Placed, Problem};
use crate::search::Snapshot;
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_engine::limit::Limit;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Layout;
use std::fmt;

/// A step that shows freedom to move (metres).
const STEP: f64 = 0.02;
/// Nobody asks how far beyond this (metres).
pub const FAR: f64 = 10.0;
/// How exactly it is found out how far an object could go (metres).
const EXACT: f64 = 0.005;
/// Turns that show freedom to turn (degrees).
const TURNS: [f64; 5] = [2.0, -2.0, 90.0, 180.0, 270.0];

/// What is open about an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Freedom {
    pub object: ObjectId,
    pub name: String,
    /// How far it could move along x, y, z: backwards and forwards, metres, up to [`FAR`].
    pub moves: [[f64; 2]; 3],
    /// Whether it could turn about the vertical.
    pub turns: bool,
}

/// What is open of a layout.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Free {
    /// By object, what is demanded least of first; objects of which nothing is open are left out.
    pub objects: Vec<Freedom>,
    /// Whether all objects were looked at: there was work enough for that.
    pub complete: bool,
}

impl fmt::Display for Freedom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ways = ["x", "y", "z"].into_iter().zip(self.moves);
        let mut what: Vec<String> = ways
            .map(|(axis, [back, forth])| (axis, back.max(forth)))
            .filter(|(_, far)| *far > 0.0)
            .map(|(axis, far)| {
                if far < FAR {
                    format!("along {axis} by up to {far} m")
                } else {
                    format!("along {axis} by {FAR} m or more")
                }
            })
            .collect();
        what.extend(self.turns.then(|| "by turning".to_owned()));
        let list = match what.as_slice() {
            [some @ .., last] if !some.is_empty() => format!("{} and {last}", some.join(", ")),
            all => all.join(", "),
        };
        write!(f, "`{}` {list}", self.name)
    }
}

/// What a program leaves open of a layout, as far as can be found out with so much work, within the time of the options.
pub fn freedom(problem: &Problem<'_>, options: &Options, layout: &Layout, work: u64) -> Free {
    let problem = Problem { program: problem.program, start: layout.clone(), placed: Placed::All };
    let setup = setup(&problem, options);
    let mut state = Candidate::new(&setup.frame, setup.world.clone());
    let all: Vec<Change> = setup.given.iter().filter_map(|(id, pose)| Some(Change::Object(*id, (*pose)?))).collect();
    if state.attempt(&all, f64::INFINITY).is_some() {
        state.keep();
    }
    state.measure_all();
    state.limit = Limit::new(options.time, &options.stop);
    let frame = &setup.frame;
    let mut order: Vec<ObjectId> = frame.objects().filter(|id| frame.is_movable(*id)).collect();
    let demands = |id: ObjectId| frame.index.of_object(id).iter().filter(|&&t| frame.terms[t].is_hard()).count();
    order.sort_by_key(|id| (demands(*id), *id));
    let mut look = Look { before: violated(&state), start: Snapshot::of(&state), state };
    let mut found = Free { objects: Vec::new(), complete: true };
    for id in order {
        if look.state.work >= work || look.state.limit.is_over() {
            found.complete = false;
            break;
        }
        let free = look.at(id);
        if look.state.limit.is_over() {
            // What was seen since is no answer.
            found.complete = false;
            break;
        }
        if free.turns || free.moves.as_flattened().iter().any(|far| *far > 0.0) {
            found.objects.push(free);
        }
    }
    found
}

/// A layout, and trials with one object of it.
struct Look<'a> {
    state: Candidate<'a>,
    start: Snapshot,
    /// How much is violated in it.
    before: usize,
}

impl Look<'_> {
    fn at(&mut self, id: ObjectId) -> Freedom {
        let frame = self.state.frame;
        let fixed = frame.fixed(id);
        let pose = self.state.pose(id);
        let mut moves = [[0.0; 2]; 3];
        for axis in (0..3).filter(|&axis| !fixed.pos[axis]) {
            moves[axis] = [-1.0, 1.0].map(|way| self.along(id, axis, way));
        }
        let turns = !fixed.rot && TURNS.into_iter().any(|turn| self.is_harmless(id, pose.facing(pose.rot.y + turn)));
        Freedom { object: id, name: frame.name(id).to_owned(), moves, turns }
    }

    /// How far an object could go one way, in whole centimetres.
    fn along(&mut self, id: ObjectId, axis: usize, way: f64) -> f64 {
        let pose = self.state.pose(id);
        let mut reaches = |far: f64| {
            let mut next = pose;
            next.pos[axis] += way * far;
            self.is_harmless(id, next)
        };
        let (mut near, mut far) = (0.0, STEP);
        while far < FAR && reaches(far) {
            (near, far) = (far, (2.0 * far).min(FAR));
        }
        if far >= FAR && reaches(FAR) {
            return FAR;
        }
        while near > 0.0 && far - near > EXACT {
            let middle = (near + far) / 2.0;
            if reaches(middle) {
                near = middle;
            } else {
                far = middle;
            }
        }
        (near * 100.0 + 1e-6).floor() / 100.0
    }

    fn is_harmless(&mut self, id: ObjectId, pose: crate::problem::pose::Pose) -> bool {
        let changes = self.state.with_riders(id, pose);
        // Good looks are no demand: only what is violated counts.
        if self.state.attempt(&changes, f64::INFINITY).is_none() {
            return false;
        }
        let harmless = violated(&self.state) <= self.before;
        if !harmless || self.state.frame.walks.is_empty() {
            self.state.undo();
            return harmless;
        }
        // Ways over the floor are not looked at in a trial.
        self.state.keep();
        let frame = self.state.frame;
        let harmless = self.state.has_ways(|term| frame.terms[term].is_hard());
        self.start.show(&mut self.state);
        harmless
    }
}

/// How much is violated, ways over the floor left out.
fn violated(state: &Candidate<'_>) -> usize {
    let walks = |check: usize| state.frame.terms.get(check).is_some_and(|t| t.walks);
    state.violated().into_iter().filter(|check| !walks(*check)).count()
}
