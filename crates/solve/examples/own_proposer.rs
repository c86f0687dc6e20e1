//! A proposer of one's own: whatever is too far from the object that it has to do with is put half way to it.
//!
//! It sees the layout and the batch, and answers with moves; the solver judges each before it counts, and finishes what
//! it leaves. A language model, a table of habits or a person can stand in its place.

use scenelang_lang::{Options as Reading, compile_text};
use scenelang_layout::Layout;
use scenelang_solve::{Concern, Move, Options, Placed, Problem, Proposal, Proposer, Steps, View, solve_with};
use std::ops::ControlFlow;
use std::path::Path;

const SCENE: &str = "
region room;
room.pos <- vec3(0, 0, 0);
room.scale <- vec3(6, 3, 5);
object table;
table.dimensions <- vec3(1.6, 0.75, 0.9);
object lamp;
lamp.dimensions <- vec3(0.3, 1.5, 0.3);
assert inside(table, room) and inside(lamp, room);
assert distance(table.center, lamp.center) <= 1.5;
assert lamp.pos.x + lamp.pos.z >= 2;
";

/// Moves the last object of each constraint half way to the first.
struct HalfWay {
    taken: usize,
}

impl Proposer for HalfWay {
    fn propose(&mut self, view: &View<'_>, batch: &[Concern], _round: usize) -> Vec<Proposal> {
        let half_way = |concern: &Concern| {
            let (&first, &last) = (concern.objects.first()?, concern.objects.last()?);
            let (to, from) = (view.pose(first)?, view.pose(last)?);
            let pos = (to.pos + from.pos) / 2.0;
            Some(Proposal { moves: vec![Move { object: last, pos, rot: from.rot }] })
        };
        batch.iter().filter_map(half_way).collect()
    }
    fn judged(&mut self, taken: &[bool]) {
        self.taken += taken.iter().filter(|t| **t).count();
    }
}

fn main() -> Result<(), String> {
    let compiled = compile_text("own.scene", Path::new("own.scene"), SCENE, Reading::default());
    let Some(program) = &compiled.program else {
        return Err(format!("the program has errors: {:?}", compiled.diagnostics));
    };
    let problem = Problem { program, start: Layout::default(), placed: Placed::None };
    let mut own = HalfWay { taken: 0 };
    let mut steps = Steps { proposers: vec![&mut own], ..Steps::default() };
    let outcome = solve_with(&problem, &Options::default(), &mut steps, &mut |_| ControlFlow::Continue(()));
    println!("{} after {} rounds", if outcome.converged { "solved" } else { "not solved" }, outcome.iterations);
    for (name, placement) in &outcome.layout.objects {
        println!("{name} at {:.2}, {:.2}", placement.pos.x, placement.pos.z);
    }
    println!("{} proposals were taken", own.taken);
    Ok(())
}
