//! What a program leaves open: in which directions each object could go, or how it could turn, by itself, with everything
//! that holds still holding.

use crate::problem::{Options, Placed, Problem};
use crate::setup::setup;
use crate::state::{Change, State};
use scenelang_lang::program::ObjectId;
use scenelang_layout::Layout;
use std::fmt;

/// A step that shows freedom to move (metres).
const STEP: f64 = 0.02;
/// Turns that show freedom to turn (degrees).
const TURNS: [f64; 5] = [2.0, -2.0, 90.0, 180.0, 270.0];
/// What a step may cost.
const HARM: f64 = 1e-3;

/// What is open about an object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Freedom {
    /// Which.
    pub object: ObjectId,
    /// Its name.
    pub name: String,
    /// Whether it could move along x, y, z.
    pub moves: [bool; 3],
    /// Whether it could turn about the vertical.
    pub turns: bool,
}

impl fmt::Display for Freedom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let axes: Vec<&str> = ["x", "y", "z"].into_iter().zip(self.moves).filter(|(_, m)| *m).map(|(a, _)| a).collect();
        let moves = match axes[..] {
            [] => None,
            [one] => Some(format!("move along {one}")),
            [ref some @ .., last] => Some(format!("move along {} and {last}", some.join(", "))),
        };
        let turns = self.turns.then(|| "turn".to_owned());
        let what: Vec<String> = moves.into_iter().chain(turns).collect();
        write!(f, "`{}` is free to {}", self.name, what.join(", and to "))
    }
}

/// What a program leaves open of a layout; objects of which nothing is open are left out.
pub fn freedom(problem: &Problem<'_>, options: &Options, layout: &Layout) -> Vec<Freedom> {
    let problem = Problem { program: problem.program, start: layout.clone(), placed: Placed::All };
    let setup = setup(&problem, options);
    let mut state = State::new(&setup.frame, setup.world.clone());
    let all: Vec<Change> = setup.given.iter().filter_map(|(id, pose)| Some(Change::Object(*id, (*pose)?))).collect();
    if state.attempt(&all, f64::INFINITY).is_some() {
        state.keep();
    }
    state.measure_all();
    let mut found = Vec::new();
    for id in setup.frame.objects().filter(|id| setup.frame.is_movable(*id)) {
        let fixed = setup.frame.fixed(id);
        let pose = state.pose(id);
        let moves = std::array::from_fn(|axis| {
            !fixed.pos[axis]
                && [STEP, -STEP].into_iter().any(|step| {
                    let mut next = pose;
                    next.pos[axis] += step;
                    is_harmless(&mut state, id, next)
                })
        });
        let turns =
            !fixed.rot && TURNS.into_iter().any(|turn| is_harmless(&mut state, id, pose.facing(pose.rot.y + turn)));
        if turns || moves.contains(&true) {
            found.push(Freedom { object: id, name: setup.frame.name(id).to_owned(), moves, turns });
        }
    }
    found
}

fn is_harmless(state: &mut State<'_>, id: ObjectId, pose: crate::pose::Pose) -> bool {
    let before = state.violated().len();
    let changes = state.with_riders(id, pose);
    if state.attempt(&changes, HARM).is_none() {
        return false;
    }
    let harmless = state.violated().len() <= before;
    state.undo();
    harmless
}
