//! Input that nobody means well with: for each a diagnosis, and an end.

use crate::{compiled, run_with};
use scenelang_layout::{DecisionValue, Layout, Placement, RegionPlacement, Vec3};
use scenelang_solve::{End, Options, Placed};

/// Work for a scene that cannot be solved: enough to be sure that nothing runs away.
const BUDGET: u64 = 1_500_000;

/// A repeatable stream of numbers (splitmix64).
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
    /// A number as a hand would write it, or one that nobody should.
    fn float(&mut self) -> f64 {
        const WILD: [f64; 14] = [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            0.0,
            -0.0,
            f64::MIN_POSITIVE,
            5e-324,
            f64::MAX,
            f64::MIN,
            1e300,
            -1e18,
            1e9,
            1e-9,
            -1.0,
        ];
        match self.below(3) {
            0 => self.one(&WILD),
            1 => f64::from_bits(self.next()),
            _ => self.below(2000) as f64 / 100.0 - 10.0,
        }
    }
    fn vector(&mut self) -> Vec3 {
        Vec3::from_fn(|_, _| self.float())
    }
}

/// Objects, regions and constraints that could be solved.
fn program(dice: &mut Dice) -> String {
    let n = 2 + dice.below(5);
    let mut text = format!("region room; object o[{n}]; object lamp; Number space;\n");
    for i in 1..n {
        let j = dice.below(i);
        let demand = dice.one(&["gap(A, B) >= 0.1", "distance(A, B) <= 2", "A.pos.x + 0.2 <= B.pos.x", "facing(A, B)"]);
        let demand = demand.replace('A', &format!("o[{i}]")).replace('B', &format!("o[{j}]"));
        text += &format!("assert {demand};\n");
    }
    text + "assert on(lamp, o[0]) and space > 1;\nprefer o[0].pos.x > 0;\n"
}

/// A layout to start from with any numbers in every field.
fn layout(dice: &mut Dice, names: &[String]) -> Layout {
    let mut layout = Layout { seed: Some(dice.next()), ..Layout::default() };
    for name in names {
        let placement = Placement {
            pos: dice.vector(),
            rot: dice.vector(),
            scale: dice.vector(),
            parts: Vec::new(),
            surface: (dice.below(2) == 0).then(|| dice.float()),
            joints: Vec::new(),
        };
        layout.objects.push((name.as_str().into(), placement));
    }
    let vertices =
        (dice.below(2) == 0).then(|| (0..dice.below(5)).map(|_| [dice.float(), dice.float()]).collect::<Vec<_>>());
    let room = RegionPlacement { pos: dice.vector(), rot: dice.vector(), scale: dice.vector(), vertices };
    layout.regions.push(("room".into(), room));
    layout.variables.push(("space".into(), DecisionValue::Number(dice.float())));
    layout.draws.push(("nobody/0".into(), dice.float()));
    layout
}

#[test]
fn any_floats_in_a_layout_to_start_from() {
    for seed in 0..50 {
        let mut dice = Dice(seed);
        let text = program(&mut dice);
        let compiled = compiled(&text);
        let names: Vec<String> =
            compiled.program.as_ref().unwrap().objects.iter().map(|o| o.name.to_string()).collect();
        let start = layout(&mut dice, &names);
        let options = Options { budget: BUDGET, seed, ..Options::default() };
        let outcome = run_with(&compiled, &options, start, Placed::All);
        assert_eq!(outcome.layout.objects.len(), names.len(), "{seed}: nothing is dropped");
        assert!(outcome.converged || !outcome.unsatisfied.is_empty(), "{seed}: {outcome:?}");
        assert!(outcome.warnings.iter().any(|w| w.contains("has an invalid value")), "{seed}: {outcome:?}");
        let finite = |p: &Placement| p.pos.iter().chain(&p.rot).chain(&p.scale).all(|x| x.abs() < 1e6);
        assert!(outcome.layout.objects.iter().all(|(_, p)| finite(p)), "{seed}: {outcome:?}");
    }
}

const ROOM: &str = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(5, 3, 4);\n";

/// Programs that cannot hold, whatever is tried.
const IMPOSSIBLE: [&str; 19] = [
    "object a; a.pos <- vec3(0, 0, 0); a.rot <- rot(0, 0, 0); assert a.pos.x > 1; assert a.rot.y = 90;",
    "object a; object b; a.pos <- vec3(0, 0, 0); b.pos <- vec3(0, 0, 0);",
    "object a; object b; a.pos <- b.pos; assert distance(a, b) > 1;",
    "object a; a.dimensions <- vec3(9, 9, 9); assert inside(a, room);",
    "object a[3]; a.dimensions <- vec3(4.9, 2.9, 3.9); assert forall x in a: inside(x, room);",
    "object a; a.dimensions <- vec3(1000000, 1000000, 1000000); assert inside(a, room);",
    "region r; r.pos <- vec3(0, 0, 0); r.scale <- vec3(0.000001, 1, 0.000001); object a; assert inside(a, r);",
    "region r; r.pos <- vec3(50, 0, 0); r.scale <- vec3(1, 1, 0.000001); object a[4]; assert forall x in a: inside(x, r);",
    "region l; l.vertices <- polygon(vec3(0, 0, 0), vec3(0.0001, 0, 0), vec3(0, 0, 0.0001)); object a; assert inside(a, l);",
    "region x; x.vertices <- polygon(vec3(0, 0, 0), vec3(4, 0, 4), vec3(4, 0, 0), vec3(0, 0, 4)); object a; assert inside(a, x);",
    "object a; a.scale <- vec3(1e300, 1, 1); assert inside(a, room);",
    "object a; a.pos <- vec3(1e300, 0, 1e-300); assert inside(a, room);",
    "region r; r.pos <- vec3(0, 0, 0); r.scale <- vec3(1e300, 1e300, 1e300); object a; assert inside(a, r); assert a.pos.x < a.pos.x;",
    "object a; object b; assert distance(a, b) > 1e300;",
    "object a; assert a.pos.x >= 2 and a.pos.x <= 1;",
    "object a; object b; assert gap(a, b) >= 3 and gap(a, b) <= 1;",
    "object a; assert a.pos.x = 1 / (a.pos.x - a.pos.x);",
    "Number lo; Number hi; object a; assert lo > hi and hi > lo and a.pos.x > lo;",
    "object a; object b; assert on(a, b); assert on(b, a);",
];

#[test]
fn what_cannot_be_gets_a_diagnosis() {
    for body in IMPOSSIBLE {
        let text = format!("{ROOM}{body}");
        let outcome = run_with(
            &compiled(&text),
            &Options { budget: BUDGET, ..Options::default() },
            Layout::default(),
            Placed::None,
        );
        assert!(!outcome.converged && outcome.end != End::Solved, "{body}");
        assert!(!outcome.unsatisfied.is_empty(), "{body}");
        assert!(outcome.layout.objects.iter().all(|(_, p)| p.pos.iter().all(|c| c.is_finite())), "{body}");
    }
}

#[test]
fn a_program_that_fixes_everything_may_ask_for_paths() {
    let fixed = "object a; object b; a.pos <- vec3(1, 0, 1); a.rot <- rot(0, 0, 0); a.scale <- vec3(0.5, 1, 0.5);
        b.pos <- vec3(-1, 0, -1); b.rot <- rot(0, 0, 0); b.scale <- vec3(0.5, 1, 0.5);
        assert reachable(a, b, 4.5) or walkDistance(a, b) <= FAR; prefer not reachable(a, b, 0.5);";
    for (far, holds) in [("3", true), ("0.1", false)] {
        let text = format!("{ROOM}{}", fixed.replace("FAR", far));
        let options = Options { budget: BUDGET, ..Options::default() };
        let outcome = run_with(&compiled(&text), &options, Layout::default(), Placed::None);
        assert_eq!(outcome.converged, holds, "{far}: {outcome:?}");
    }
}

#[test]
fn draws_whose_least_is_above_their_greatest_are_named() {
    let text = format!("{ROOM}object a; Number x; x <- rand(3, 1); assert a.pos.x = x;");
    let compiled = scenelang_lang::compile_text(
        "t.scene",
        std::path::Path::new("t.scene"),
        &text,
        scenelang_lang::Options::default(),
    );
    // The compiler may see it; if it does not, the solver says so.
    if compiled.program.is_some() {
        let options = Options { budget: BUDGET, ..Options::default() };
        let outcome = run_with(&compiled, &options, Layout::default(), Placed::None);
        assert!(outcome.warnings.iter().any(|w| w.contains("wrong order")), "{:?}", outcome.warnings);
    } else {
        assert!(compiled.diagnostics.iter().any(|d| d.is_error()));
    }
}

/// Fifty disjunctions of anything.
fn disjunctions(dice: &mut Dice, n: usize) -> String {
    const PARTS: [&str; 12] = [
        "A.pos.x > B.pos.x + N",
        "A.pos.z = N",
        "distance(A, B) < N",
        "gap(A, B) > N",
        "A.rot.y = N",
        "facing(A, B)",
        "on(A, B)",
        "leftOf(A, B)",
        "inside(A, room)",
        "not A.pos.x < N",
        "visible(A, B)",
        "reachable(A, B, 0.5)",
    ];
    let mut text = format!("{ROOM}object o[{n}]; o.dimensions <- vec3(0.5, 0.5, 0.5);\n");
    for _ in 0..50 {
        let parts: Vec<String> = (0..2 + dice.below(3))
            .map(|_| {
                let (a, b) = (dice.below(n), dice.below(n - 1));
                let b = b + usize::from(b >= a);
                let part = dice.one(&PARTS).replace('A', &format!("o[{a}]")).replace('B', &format!("o[{b}]"));
                part.replace('N', &format!("{:.2}", dice.below(800) as f64 / 100.0 - 4.0))
            })
            .collect();
        text += &format!("assert {};\n", parts.join(" or "));
    }
    text
}

#[test]
fn fifty_disjunctions_come_to_an_end() {
    for (seed, n) in [3, 6, 10, 20, 50].into_iter().enumerate() {
        let text = disjunctions(&mut Dice(seed as u64), n);
        let options = Options { budget: 3 * BUDGET, ..Options::default() };
        let outcome = run_with(&compiled(&text), &options, Layout::default(), Placed::None);
        assert_eq!(outcome.converged, outcome.unsatisfied.is_empty(), "{n}");
        // What one step takes may go beyond a budget, but no more than that.
        assert!(outcome.work < 4 * options.budget, "{n}: {}", outcome.work);
        if !outcome.converged {
            assert!(!outcome.in_the_way.is_empty() || outcome.unsatisfied.len() > 1, "{n}: {:?}", outcome.unsatisfied);
        }
    }
}
