//! What is in the way where not all can hold: few statements, a layout in which the rest holds, nothing more than that.

use crate::{ROOM, compiled};
use scenelang_lang::program::ConstraintKind;
use scenelang_layout::Layout;
use scenelang_solve::{End, Options, Outcome, Placed, Problem, Stop, TermSubject, solve};
use std::ops::ControlFlow;
use std::time::Duration;

/// Programs that cannot hold, each with how many statements must go, and which of them may (by a part of their text).
const CASES: [(&str, usize, &[&str]); 6] = [
    // Each of three asks something else of the fourth: it is that one.
    (
        "object hub; object s[3]; hub.dimensions <- vec3(0.3, 0.3, 0.3); s.dimensions <- vec3(0.3, 0.3, 0.3);
         assert hub.pos.x >= 1;
         assert distance(s[0], hub) <= 0.9; assert distance(s[1], hub) <= 0.9; assert distance(s[2], hub) <= 0.9;
         assert s[0].pos.x <= -1; assert s[1].pos.x <= -1; assert s[2].pos.x <= -1;",
        1,
        &["hub.pos.x >= 1"],
    ),
    // Nothing that is stated is violated, but a physical rule.
    (
        "object a; object b; a.dimensions <- vec3(1, 1, 1); b.dimensions <- vec3(1, 1, 1);
         a.pos <- vec3(0, 0, 0); b.pos <- vec3(0.3, 0, 0);",
        1,
        &["a.pos <-", "b.pos <-"],
    ),
    (
        "object a[4];
         assert a[0].pos.x >= a[1].pos.x + 1; assert a[1].pos.x >= a[0].pos.x;
         assert a[2].pos.z >= a[3].pos.z + 1; assert a[3].pos.z >= a[2].pos.z;",
        2,
        &["a[0].pos.x >=", "a[1].pos.x >=", "a[2].pos.z >=", "a[3].pos.z >="],
    ),
    // The room has place for one of them on its floor.
    (
        "object a; object b; a.dimensions <- vec3(4, 1.2, 3.5); b.dimensions <- vec3(4, 1.2, 3.5);
         assert a.bottom = room.floor; assert b.bottom = room.floor;",
        1,
        &["a.bottom", "b.bottom"],
    ),
    (
        "object sofa; sofa.dimensions <- vec3(2, 0.8, 0.9); object tv; tv.dimensions <- vec3(1.2, 0.7, 0.3);
         object table; table.dimensions <- vec3(1, 0.4, 0.6);
         assert gap(sofa, tv) >= 2.5; assert gap(table, sofa) <= 0.2; assert gap(table, tv) <= 0.3;",
        1,
        &["gap("],
    ),
    ("object a; assert a.pos.x > 1 or a.pos.x > 2; assert a.pos.x < 0.5;", 1, &["a.pos.x"]),
];

fn run(text: &str, options: &Options) -> Outcome {
    let compiled = compiled(text);
    let program = compiled.program.as_ref().expect("the program compiles");
    let problem = Problem { program, start: Layout::default(), placed: Placed::None };
    solve(&problem, options, &mut |_| ControlFlow::Continue(()))
}

#[test]
fn few_statements_are_named_and_all_others_hold() {
    for (body, count, among) in CASES {
        let text = format!("{ROOM}{body}");
        let program = compiled(&text).program.unwrap();
        for seed in 0..2 {
            let outcome = run(&text, &Options { seed, budget: 10_000_000, ..Options::default() });
            let named: Vec<&str> = outcome.in_the_way.iter().map(|i| program.constraints[*i].text.as_str()).collect();
            assert!(!outcome.converged && outcome.end != End::Solved, "{body}");
            assert_eq!(named.len(), count, "{body}: {named:?}");
            assert!(named.iter().all(|n| among.iter().any(|part| n.contains(part))), "{body}: {named:?}");
            // The layout is the witness.
            let hard = |i: &usize| program.constraints[*i].kind == ConstraintKind::Assert;
            for failing in &outcome.unsatisfied {
                let TermSubject::Stated(index) = failing.what else { panic!("{body}: {failing:?}") };
                assert!(outcome.in_the_way.contains(&index) || !hard(&index), "{body}: {failing:?}");
            }
            assert!(outcome.in_the_way.iter().all(|i| !outcome.constraints[*i].holds), "{body}");
        }
    }
}

#[test]
fn the_diagnosis_keeps_to_its_budget_and_ends_when_asked() {
    let text = format!("{ROOM}{}", CASES[2].0);
    let with = |options: Options| run(&text, &options);
    let options = Options { budget: 8_000_000, ..Options::default() };
    let (plain, whole) = (with(Options { diagnose: false, ..options.clone() }), with(options.clone()));
    assert!(whole.work >= plain.work && whole.work <= plain.work + 6_000_000, "{} {}", plain.work, whole.work);
    let stop = Stop::default();
    stop.set();
    let asked = with(Options { stop, ..options.clone() });
    assert_eq!((asked.end, asked.converged), (End::Asked, false));
    assert!(asked.work < plain.work && asked.layout.objects.len() == 4);
    assert!(asked.layout.objects.iter().all(|(_, p)| p.pos.iter().all(|c| c.abs() < 100.0)), "{:?}", asked.layout);
    let late = with(Options { time: Some(Duration::ZERO), ..options });
    assert_eq!(late.end, End::Time);
    assert!(late.layout.objects.iter().all(|(_, p)| p.pos.iter().all(|c| c.abs() < 100.0)), "{:?}", late.layout);
}

/// Thirty-nine desks in a hall that has place for seven in each of five rows with their aisles.
#[test]
fn forty_objects_that_cannot_be_placed_end_within_the_budget_and_name_what_to_look_at() {
    let text = "region hall; hall.pos <- vec3(0, 0, 0); hall.scale <- vec3(9, 3, 6); hall.rot <- rot(0, 0, 0);
        object door; door.dimensions <- vec3(0.9, 2, 0.06); assert connects(door, hall);
        object desk[39]; desk.dimensions <- vec3(1.2, 0.75, 0.7);
        assert forall d in desk: onFloor(d, hall) and clear(d, front, 0.9);
        assert forall d in desk: reachable(door, d, 0.8);";
    const BUDGET: u64 = 6_000_000;
    let outcome = run(text, &Options { budget: BUDGET, ..Options::default() });
    assert!(!outcome.converged && outcome.end != End::Solved);
    // What is in the way is looked for afterwards, with a quarter of it.
    assert!(outcome.work <= BUDGET * 13 / 10, "{}", outcome.work);
    assert!(!outcome.in_the_way.is_empty() || !outcome.unsatisfied.is_empty(), "{outcome:?}");
}
