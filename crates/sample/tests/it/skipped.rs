//! A candidate judges a move by what it touches: all else is as if it had been judged anew.

use crate::plain::compiled;
use scenelang_engine::candidate::Change;
use scenelang_sample::seed_of;
use scenelang_solve::{Ground, Options, Placed, Problem, solve};
use scenelang_synth::furnish;
use scenelang_verify::Opens;
use std::collections::BTreeSet;
use std::ops::ControlFlow;

#[test]
fn what_a_move_does_not_touch_is_as_it_was() {
    let text = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(4, 2.6, 3.6);
        object door; door.category <- \"door\"; door.dimensions <- vec3(0.9, 2, 0.06);
        object wardrobe; wardrobe.category <- \"wardrobe\"; wardrobe.dimensions <- vec3(1, 2, 0.6);
        object nightstand; nightstand.category <- \"nightstand\"; nightstand.dimensions <- vec3(0.5, 0.5, 0.4);
        object lamp; lamp.category <- \"lamp\"; lamp.dimensions <- vec3(0.2, 0.4, 0.2);
        object crate[3]; crate.category <- \"box\"; crate.dimensions <- vec3(0.4, 0.4, 0.4);
        assert connects(door, room) and onFloor(door, room) and on(lamp, nightstand);
        assert opens(wardrobe) and clear(nightstand, front, 0.3);";
    let compiled = compiled(text);
    let program = compiled.program.as_ref().expect("it compiles");
    let judge = scenelang_verify::Options { opens: Opens::All, ..scenelang_verify::Options::default() };
    let start = furnish(program, Vec::new(), None, &judge).layout;
    let options = Options { judge, threads: 1, ..Options::default() };
    let problem = Problem { program, start, placed: Placed::None };
    let solved = solve(&problem, &options, &mut |_| ControlFlow::Continue(()));
    assert!(solved.converged);
    let ground = Ground::new(&Problem { program, start: solved.layout, placed: Placed::All }, &options);
    let mut state = ground.candidate();
    let movable: Vec<_> = state.frame.objects().filter(|id| state.frame.is_movable(*id)).collect();
    // Numbers in [0, 1), one after the other.
    let mut count = 0;
    let mut unit = || {
        count += 1;
        seed_of(7, count) as f64 / (1u64 << 53) as f64
    };
    let (mut barred, mut free) = (BTreeSet::new(), 0);
    for step in 0..600 {
        let id = movable[(unit() * movable.len() as f64) as usize];
        let old = state.pose(id);
        let pose = old.at(unit() * 4.0 - 2.0, old.pos.y, unit() * 3.6 - 1.8).facing((unit() * 8.0).floor() * 45.0);
        let changes = state.with_riders(id, pose);
        if state.attempt(&changes, f64::INFINITY).is_some() {
            state.keep();
        }
        let seen = state.violated();
        state.measure_all();
        assert_eq!(seen, state.violated(), "after step {step}, {:?}", Change::Object(id, pose));
        let opens = |check: &&usize| state.frame.terms.get(**check).is_some_and(|term| term.opens.is_some());
        let found: Vec<usize> = seen.iter().filter(opens).copied().collect();
        free += usize::from(found.is_empty());
        barred.extend(found);
    }
    assert!(barred.len() > 2 && free > 20, "all of it was in force and violated by turns: {barred:?}, {free}");
}
