//! What the solver promises of its outcomes: on small programs, by the public interface alone.

mod diagnosis;
mod hostile;
mod opening;
mod violations;

use scenelang_lang::program::ObjectId;
use scenelang_lang::{Compiled, Options as Reading, compile_text};
use scenelang_layout::Layout;
use scenelang_solve::{
    Concern, End, Move, Options, Outcome, Placed, Problem, Proposal, Proposer, Steps, TermSubject, View, alternatives,
    freedom, solve, solve_with,
};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Duration;

const ROOM: &str = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(5, 3, 4);\n";

/// Six boxes in a row from left to right, each turned by a quarter or not at all.
const ROW: &str = "
object b[6];
b.dimensions <- vec3(0.5, 0.6, 0.7);
assert forall x in b: inside(x, room) and x.bottom = room.floor and (x.rot = rot(0, 0, 0) or x.rot = rot(0, 90, 0));
assert forall i in 0..5: b[i].center.x + 0.6 <= b[i + 1].center.x;
assert abs(b[0].center.z - b[5].center.z) <= 0.1;
";

/// No code is made for these: gaps and ways are measured.
const MEASURED: &str = "
object table; table.dimensions <- vec3(1.4, 0.75, 0.8);
object chair; chair.dimensions <- vec3(0.45, 0.9, 0.45);
object door; door.dimensions <- vec3(0.9, 2.1, 0.06);
assert inside(table, room) and inside(chair, room) and connects(door, room);
assert gap(chair, table) >= 0.05 and gap(chair, table) <= 0.3 and reachable(door, chair, 0.5);
";

fn compiled(text: &str) -> Compiled {
    let compiled = compile_text("t.scene", Path::new("t.scene"), text, Reading::default());
    assert!(compiled.program.is_some(), "{:?}", compiled.diagnostics);
    compiled
}

fn run_with(compiled: &Compiled, options: &Options, start: Layout, placed: Placed) -> Outcome {
    let program = compiled.program.as_ref().expect("`compiled` looks at that");
    solve(&Problem { program, start, placed }, options, &mut |_| ControlFlow::Continue(()))
}

fn run(text: &str, options: &Options, start: Option<&Layout>) -> Outcome {
    let compiled = compiled(text);
    let placed = if start.is_some() { Placed::All } else { Placed::None };
    let program = compiled.program.as_ref().expect("`compiled` looks at that");
    let problem = Problem { program, start: start.cloned().unwrap_or_default(), placed };
    solve(&problem, options, &mut |_| ControlFlow::Continue(()))
}

fn moved(a: &Layout, b: &Layout) -> Vec<String> {
    let pairs = a.objects.iter().zip(&b.objects);
    pairs
        .filter(|((_, p), (_, q))| (p.pos - q.pos).norm() > 1e-6 || p.rot != q.rot)
        .map(|((n, _), _)| n.to_string())
        .collect()
}

#[test]
fn solves_what_is_coded_and_what_is_measured() {
    for body in [ROW, MEASURED] {
        for seed in 0..4 {
            let outcome = run(&format!("{ROOM}{body}"), &Options { seed, ..Options::default() }, None);
            assert_eq!((outcome.converged, outcome.end), (true, End::Solved), "{:?}", outcome.unsatisfied);
            assert!(outcome.constraints.iter().all(|c| c.holds && c.margin.is_none_or(|m| m > -1e-6)));
            assert!(outcome.in_the_way.is_empty());
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_outcome_on_any_thread() {
    for body in [ROW, MEASURED] {
        let once = move || run(&format!("{ROOM}{body}"), &Options { seed: 3, ..Options::default() }, None);
        let first = once();
        let [a, b] = [std::thread::spawn(once), std::thread::spawn(once)].map(|t| t.join().unwrap());
        assert_eq!(first, a);
        assert_eq!(first, b);
        assert_ne!(
            first.layout,
            run(&format!("{ROOM}{body}"), &Options { seed: 4, ..Options::default() }, None).layout
        );
    }
}

#[test]
fn a_small_edit_moves_little() {
    let text = format!("{ROOM}{ROW}");
    let before = run(&text, &Options::default(), None);
    let same = run(&text, &Options::default(), Some(&before.layout));
    assert!(same.converged);
    assert_eq!(moved(&before.layout, &same.layout), Vec::<String>::new());
    let z = before.layout.object("b[2]").unwrap().pos.z;
    let edit = if z > 0.0 { "assert b[2].center.z <= -0.5;" } else { "assert b[2].center.z >= 0.5;" };
    let after = run(&format!("{text}{edit}"), &Options::default(), Some(&before.layout));
    assert!(after.converged, "{:?}", after.unsatisfied);
    let moved = moved(&before.layout, &after.layout);
    assert!(moved.contains(&"b[2]".to_owned()) && moved.len() <= 3, "{moved:?}");
}

#[test]
fn locked_objects_stay() {
    let text = format!("{ROOM}{ROW}");
    let before = run(&text, &Options::default(), None);
    let locked: Vec<ObjectId> = (1..6).map(ObjectId).collect();
    let edit = "assert abs(b[0].center.z - b[1].center.z) >= 0.9 and abs(b[5].center.z - b[0].center.z) <= 4;";
    let edited = format!("{ROOM}{}{edit}", ROW.replace("assert abs(b[0].center.z - b[5].center.z) <= 0.1;", ""));
    let after = run(&edited, &Options { locked, ..Options::default() }, Some(&before.layout));
    assert!(after.converged, "{:?}", after.unsatisfied);
    assert!(moved(&before.layout, &after.layout).iter().all(|name| name == "b[0]"));
}

#[test]
fn what_cannot_be_is_diagnosed_and_nothing_is_dropped() {
    const CASES: [(&str, &[usize]); 4] = [
        ("object a; object b; assert a.center.x >= b.center.x + 1; assert b.center.x >= a.center.x;", &[0, 1]),
        ("object a; a.pos <- vec3(0, 0, 0); assert a.pos.x > 1;", &[]),
        ("object a; a.dimensions <- vec3(9, 9, 9); assert inside(a, room);", &[]),
        ("region r; r.pos <- vec3(0, 0, 0); r.scale <- vec3(0.0001, 1, 0.0001); object a; assert inside(a, r);", &[]),
    ];
    for (body, one_of) in CASES {
        let text = format!("{ROOM}{body}");
        let outcome = run(&text, &Options { budget: 3_000_000, ..Options::default() }, None);
        assert!(!outcome.converged && outcome.end != End::Solved, "{body}");
        assert_eq!(outcome.layout.objects.len(), compiled(&text).program.unwrap().objects.len());
        assert!(outcome.layout.objects.iter().all(|(_, p)| p.pos.iter().all(|c| c.abs() < 100.0)), "{body}");
        assert!(!outcome.unsatisfied.is_empty(), "{body}");
        if !one_of.is_empty() {
            // Either of the two may go; pins of the room come first.
            let stated: Vec<usize> = outcome.in_the_way.iter().map(|i| i - 2).collect();
            assert!(stated.len() == 1 && one_of.contains(&stated[0]), "{body} {stated:?}");
        }
    }
}

#[test]
fn a_time_limit_is_named() {
    let body = "object a; object b; assert a.center.x >= b.center.x + 1; assert b.center.x >= a.center.x;";
    let options = Options { time: Some(Duration::from_millis(1)), ..Options::default() };
    let outcome = run(&format!("{ROOM}{body}"), &options, None);
    assert_eq!(outcome.end, End::Time);
    assert!(outcome.warnings.iter().any(|w| w.contains("time")), "{:?}", outcome.warnings);
}

#[test]
fn alternatives_differ_and_freedom_is_named() {
    let compiled = compiled(&format!("{ROOM}{ROW}object lamp; assert lamp.pos.x = 2 and lamp.bottom = 0;"));
    let program = compiled.program.as_ref().unwrap();
    let problem = Problem { program, start: Layout::default(), placed: Placed::None };
    let found = alternatives(&problem, &Options::default(), 3, &mut |_| ControlFlow::Continue(()));
    assert_eq!(found.len(), 3);
    assert!(found.iter().all(|o| o.converged));
    let free = freedom(&problem, &Options::default(), &found[0].layout, 1_000_000);
    let words: Vec<String> = free.objects.iter().map(ToString::to_string).collect();
    let lamp = free.objects.iter().find(|f| f.name == "lamp").unwrap();
    // Between the walls at z = ±2, a cube of 0.5 m.
    assert!(lamp.moves[0] == [0.0; 2] && lamp.moves[1] == [0.0; 2] && lamp.turns, "{words:?}");
    let z = found[0].layout.object("lamp").unwrap().pos.z;
    let room = found[0].layout.objects.iter().filter(|(n, _)| n != "lamp").all(|(_, p)| (p.pos.x - 2.0).abs() > 0.7);
    assert!(!room || (lamp.moves[2][0] - (z + 1.75)).abs() < 0.03, "{z} {words:?}");
    assert!(
        words.iter().any(|w| w.starts_with("`lamp` along z by up to ") && w.ends_with(" m and by turning")),
        "{words:?}"
    );
    assert!(free.complete && free.objects.iter().all(|f| f.moves[1] == [0.0; 2]), "nothing floats: {words:?}");
    // Every step that is said to be free is.
    for each in &free.objects {
        for (axis, way, far) in (0..3).flat_map(|a| [(a, -1.0, each.moves[a][0]), (a, 1.0, each.moves[a][1])]) {
            let mut moved = found[0].layout.clone();
            moved.objects.iter_mut().find(|(n, _)| *n == each.name).unwrap().1.pos[axis] += way * far;
            let verdict = scenelang_verify::check(program, &moved, &Options::default().judge);
            assert!(verdict.rows.iter().all(|row| row.satisfied != Some(false)), "{each} breaks {verdict:?}");
        }
    }
    assert!(!freedom(&problem, &Options::default(), &found[0].layout, 1).complete);
}

/// Proposes what it is told, and remembers what became of it.
struct Told {
    moves: Vec<Move>,
    rounds: Vec<usize>,
    taken: Vec<bool>,
}

impl Proposer for Told {
    fn propose(&mut self, view: &View<'_>, batch: &[Concern], round: usize) -> Vec<Proposal> {
        assert!(!batch.is_empty() && batch.len() <= 3 && batch.iter().all(|c| !c.holds));
        assert!(view.unsatisfied().iter().any(|c| matches!(c.what, TermSubject::Stated(_))));
        self.rounds.push(round);
        self.moves.iter().map(|m| Proposal { moves: vec![*m] }).collect()
    }
    fn judged(&mut self, taken: &[bool]) {
        self.taken.extend(taken);
    }
}

#[test]
fn proposals_are_judged_before_they_count() {
    // Nothing can hold of the first; the second is broken by a move out of the room.
    let text = format!("{ROOM}object a; assert a.pos.x > 1 and a.pos.x < 0.9; assert inside(a, room);");
    let compiled = compiled(&text);
    let problem =
        Problem { program: compiled.program.as_ref().unwrap(), start: Layout::default(), placed: Placed::None };
    let away = |x: f64| Move { object: ObjectId(0), pos: [x, 0.0, 0.0].into(), rot: [0.0; 3].into() };
    let moves = vec![away(f64::NAN), away(30.0), Move { object: ObjectId(7), ..away(0.0) }];
    let mut told = Told { moves, rounds: Vec::new(), taken: Vec::new() };
    let mut steps = Steps { proposers: vec![&mut told], rounds: 4, proposers_only: true, ..Steps::default() };
    let outcome = solve_with(&problem, &Options::default(), &mut steps, &mut |_| ControlFlow::Continue(()));
    assert_eq!((outcome.converged, outcome.end), (false, End::Exhausted));
    assert_eq!(told.rounds, [1, 2, 3, 4]);
    assert_eq!(told.taken, [false; 12]);
}
