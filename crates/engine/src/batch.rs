//! What a program states, judged in many layouts that differ in nothing but where their objects are: the environments of a
//! simulator, the samples of a learner. Each costs what its formulas cost; no rows are made, and no sentences.
//!
//! The margins are those of [`check`](crate::check), to the last bit. Physical rules are not judged.

use crate::{Pose, State};
use scenelang_lang::program::{ObjectId, Program};
use scenelang_layout::{Layout, Vec3};
use scenelang_verify::check::draws;
use scenelang_verify::{Lazy, Options, Scratch, Truth, Value, World};

/// One instance that takes the place of all others, one after the other.
pub struct Batch<'a> {
    program: &'a Program,
    state: State,
    scratch: Scratch<f64>,
    /// By constraint: what of it need not be looked at.
    lazy: Vec<Option<Lazy>>,
}

impl<'a> Batch<'a> {
    /// All that does not move is as a layout has it: sizes, parts, regions, variables, draws.
    pub fn new(program: &'a Program, layout: &Layout, options: &Options) -> Self {
        let mut world = World::new(program, layout, options);
        // A draw out of its bounds has no value; whoever judges the layout by itself is told why.
        draws::check(program, &mut world, None, &mut Vec::new());
        let lazy = program.constraints.iter().map(|constraint| Lazy::of(&constraint.formula, &world)).collect();
        Self { program, state: State::new(world), scratch: Scratch::new(), lazy }
    }

    /// Puts an object somewhere: the middle of its bottom face (metres), and its Euler triple (degrees). Does nothing for
    /// one that the layout lacks.
    pub fn put(&mut self, id: ObjectId, pos: Vec3, rot: Vec3) {
        if let Some(old) = self.state.pose(id) {
            let new = Pose { pos, rot, scale: old.scale };
            // What stays where it is keeps what is known of it.
            if new != old {
                self.state.set_pose(id, &new);
                self.state.keep();
            }
        }
    }

    /// What each constraint of the program says, in its order; `None`: it cannot be judged.
    pub fn judge(&mut self) -> impl Iterator<Item = Option<Truth<f64>>> + use<'_, 'a> {
        let (program, world, scratch) = (self.program, self.state.world(), &mut self.scratch);
        program.constraints.iter().zip(&self.lazy).map(move |(constraint, lazy)| {
            let value = match lazy {
                Some(lazy) => scratch.evaluate_lazily(&constraint.formula, lazy, world),
                None => scratch.evaluate(&constraint.formula, world),
            };
            match value {
                Ok(Value::Truth(truth)) => Some(truth),
                _ => None,
            }
        })
    }
}
