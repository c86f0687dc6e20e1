//! Derivatives against differences, and what must hold of every evaluation: of each built-in, in random instances.

use crate::given::layout;
use proptest::prelude::*;
use scenelang_base::SourceMap;
use scenelang_lang::program::{NodeId, ObjectId, Program, RegionId};
use scenelang_layout::file::read;
use scenelang_verify::vector::V3;
use scenelang_verify::{Dual, Number, Options, Scratch, Truth, Value, World, cone, evaluate, rules};
use std::path::Path;
use std::sync::LazyLock;

/// What is differentiated: the place, turn and size of `a`, of which height stays.
const UNKNOWNS: usize = 8;
type D = Dual<UNKNOWNS>;

const SCENE: &str = "
object a; object b; object c; object p;
region room; region hall;
assert a.top + a.bottom - b.top < 1;
assert a.center.x * a.front.y <= a.right.z / (2 + a.up.x);
assert a.min.z + a.max.x = b.surface;
assert a.rot.y <= 200;
assert a.rot.x = b.rot.x;
assert a.rot = b.rot;
assert a.pos != b.pos;
assert length(cross(a.front, b.up)) < dot(a.pos, b.right);
assert angle(a.front, b.center - a.center) < 45;
assert distance(a, b) < sqrt(a.size.x + 3);
assert max(a.pos.x, b.pos.x, abs(a.pos.z)) > min(sin(a.rot.y), cos(a.rot.x));
assert normalize(a.pos - b.pos).y < 0.3;
assert leftOf(a, b) or facing(b, a);
assert between(a, b, c) implies aligned(a, c);
assert count(x in objects: x.pos.x < a.pos.x) >= 2;
assert (a.pos.x < b.pos.x) = (a.pos.z < b.pos.z);
assert gap(a, b) > 0;
assert gap(a, p) > 0;
assert gap(a, c) < 1;
assert not collides(a, b);
assert inside(a, room);
assert inside(a, hall);
assert inside(a, b);
assert inside(b, a);
assert gap(a, room) > 1;
assert gap(a.center + a.front, hall) > 0;
assert connects(a, room, hall);
assert visible(a, c);
assert visible(b, c);
assert a.center.x + hall.area > 0;
";

pub fn compiled(scene: &str) -> Program {
    let options = scenelang_lang::Options::default();
    let compiled = scenelang_lang::compile_text("t.scene", Path::new("t.scene"), scene, options);
    assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics);
    compiled.program.expect("no errors")
}

fn program() -> &'static Program {
    static PROGRAM: LazyLock<Program> = LazyLock::new(|| compiled(SCENE));
    &PROGRAM
}

fn world(program: &Program, pos: [f64; 3], rot: [f64; 3], size: [f64; 3]) -> World<f64> {
    let three = |v: [f64; 3]| format!("{} {} {}", v[0], v[1], v[2]);
    let parts = r#"{"parts": [{"shape": "box", "pos": [0, 0.25, 0], "size": [1, 0.5, 1]},
        {"shape": "cylinder", "pos": [0, 0.75, 0], "radius": 0.3, "height": 0.5, "rot": [0, 10, 0]}]}"#;
    let text = format!(
        "object a {} | {} | {}
         object b 0.3 0.1 0.2 | 1 0.8 1.4 | 5 30 -10
         object c 2 0 -1 | 0.5 2 0.5 | 0 77 0
         object p -1.5 0.2 0.5 | 1 1 1 | 0 20 0 | {}
         region room 0.1 -1 0.2 | 5 4 6 | 20
         outline hall -0.5 3 | -4 -4, 4 -4, 4 0.5, 0.5 0.6, 0.7 4, -4 4",
        three(pos),
        three(size),
        three(rot),
        parts.replace('\n', " ")
    );
    let mut sources = SourceMap::new();
    let file = sources.add(scenelang_base::SourceFile::new("t", "t", layout(&text)));
    let read = read(sources.get(file).text(), file);
    assert_eq!(read.diagnostics, []);
    World::new(program, &read.layout, &Options::default())
}

/// Puts `a` where eight numbers say: position, turn, width and depth.
fn place<N: Number>(world: &mut World<N>, x: [N; UNKNOWNS], height: f64) {
    let [px, py, pz, rx, ry, rz, w, d] = x;
    world.place(ObjectId(0), V3([px, py, pz]), V3([rx, ry, rz]), V3([w, N::constant(height), d]));
}

fn truth<N: Number>(value: Value<N>) -> Truth<N> {
    match value {
        Value::Truth(t) => t,
        other => panic!("{other:?}"),
    }
}

/// Margins of all constraints and rules that move with `a`.
fn margins<N: Number>(program: &Program, world: &World<N>) -> Vec<(String, N)> {
    let mut scratch = Scratch::new();
    let stated = program.constraints.iter().map(|c| {
        let t = truth(scratch.evaluate(&c.formula, world).expect("all is there"));
        (c.text.clone(), t.margin)
    });
    let mut out: Vec<(String, N)> = stated.collect();
    let a = ObjectId(0);
    out.push(("P-COLLIDE".into(), rules::collide::pair(world, a, ObjectId(3)).expect("both are there").margin));
    out.push(("P-BOUNDS".into(), rules::bounds::object(world, a).expect("it is there").margin));
    out
}

fn unit() -> impl Strategy<Value = f64> {
    -1.0..1.0f64
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    #[test]
    fn slopes_are_those_of_differences(v in prop::array::uniform8(unit()), upright in any::<bool>(), height in 0.2..2.0f64) {
        let program = program();
        let tilt = if upright { 0.0 } else { 40.0 };
        let x = [v[0] * 2.0, v[1], v[2] * 2.0, v[3] * tilt, 180.0 + v[4] * 170.0, v[5] * tilt, 1.1 + v[6], 1.1 + v[7]];
        let mut plain = world(program, [x[0], x[1], x[2]], [x[3], x[4], x[5]], [x[6], height, x[7]]);
        let mut dual: World<D> = plain.constant();
        place(&mut dual, std::array::from_fn(|i| D::unknown(x[i], i)), height);
        let exact = margins(program, &dual);
        let mut at = |y: [f64; UNKNOWNS]| {
            place(&mut plain, y, height);
            margins(program, &plain)
        };
        let middle = at(x);
        for (k, _) in x.iter().enumerate() {
            // Degrees are small: a step of the same effect is larger.
            let step = if (3..6).contains(&k) { 1e-4 } else { 2e-6 };
            let mut y = x;
            y[k] = x[k] + step;
            let above = at(y);
            y[k] = x[k] - step;
            let below = at(y);
            for (i, (text, d)) in exact.iter().enumerate() {
                prop_assert_eq!(d.value(), middle[i].1, "{}", text);
                let (up, down) = ((above[i].1 - middle[i].1) / step, (middle[i].1 - below[i].1) / step);
                // At a corner the two sides differ, and either is fine. How far something leads out of a concave outline is
                // measured to two walls at once, of which the slope knows one: its sign is all that counts there.
                let two_walls = text == "inside(a, hall)" && d.value() < 0.0;
                if (up - down).abs() > 1e-3 * (1.0 + up.abs()) || two_walls {
                    continue;
                }
                let expect = (up + down) / 2.0;
                let off = (d.slope[k] - expect).abs();
                prop_assert!(off <= 2e-3 * (1.0 + expect.abs()), "{} by unknown {}: {} and {}", text, k, d.slope[k], expect);
            }
        }
    }

    #[test]
    fn turning_and_moving_everything_changes_nothing(v in prop::array::uniform4(unit()), yaw in 0.0..360.0f64) {
        static PROGRAM: LazyLock<Program> = LazyLock::new(|| {
            compiled("object a; object b; region room; allowFloat(b);
                assert gap(a, b) >= 0; assert inside(a, room); assert leftOf(a, b); assert clear(a, front, 1);
                assert visible(a, b); assert collides(a, b); assert gap(b, room) < 1; assert angle(a.front, b.front) < 90;")
        });
        let program = &*PROGRAM;
        let (sin, cos) = yaw.to_radians().sin_cos();
        let at = |x: f64, y: f64, z: f64, turned: bool| {
            if turned { [cos * x + sin * z + 7.0, y + 1.0, cos * z - sin * x - 3.0] } else { [x, y, z] }
        };
        let judged = |turned: bool| -> Vec<f64> {
            let extra = if turned { yaw } else { 0.0 };
            let three = |v: [f64; 3]| format!("{} {} {}", v[0], v[1], v[2]);
            let text = format!(
                "object a {} | 1 1 0.6 | 0 {} 0\nobject b {} | 0.5 2 1 | 0 {} 0\nregion room {} | 5 3 4 | {extra}",
                three(at(v[0] * 2.0, 0.0, v[1] * 2.0, turned)), 50.0 * v[2] + extra,
                three(at(v[3] * 2.0, 0.3, v[2] * 2.0, turned)), 90.0 * v[1] + extra,
                three(at(0.0, 0.0, 0.0, turned)),
            );
            let mut sources = SourceMap::new();
            let file = sources.add(scenelang_base::SourceFile::new("t", "t", layout(&text)));
            let world = World::new(program, &read(sources.get(file).text(), file).layout, &Options::default());
            program.constraints.iter().map(|c| truth(evaluate(&c.formula, &world).unwrap()).margin).collect()
        };
        for ((before, after), c) in judged(false).iter().zip(judged(true)).zip(&program.constraints) {
            prop_assert!(*before == after || (before - after).abs() < 1e-9, "{}: {} and {}", c.text, before, after);
        }
    }

    #[test]
    fn a_cone_yields_what_the_whole_does(v in prop::array::uniform3(unit())) {
        let program = program();
        let world = world(program, v, [0.0, 90.0 * v[0], 0.0], [1.0; 3]);
        let (mut whole, mut part) = (Scratch::new(), Scratch::new());
        for c in &program.constraints {
            let _ = whole.evaluate(&c.formula, &world);
            for index in 0..c.formula.nodes.len() as u32 {
                let nodes = cone(&c.formula, NodeId(index));
                prop_assert_eq!(part.evaluate_cone(&c.formula, &nodes, &world), whole.get(NodeId(index)));
            }
        }
    }

    #[test]
    fn verdict_and_margin_agree(v in prop::array::uniform6(unit())) {
        let program = program();
        let world = world(program, [v[0], v[1], v[2]], [20.0 * v[3], 180.0 * v[4], 0.0], [1.0 + 0.5 * v[5], 1.0, 1.0]);
        for c in &program.constraints {
            let t = truth(evaluate(&c.formula, &world).unwrap());
            prop_assert!(t.margin.abs() < 1e-5 || t.holds == (t.margin > 0.0), "{} {:?}", c.text, t);
        }
    }
}

#[test]
fn a_region_moves_its_walls() {
    let program = program();
    let mut plain = world(program, [1.9, 0.0, 0.4], [0.0, 15.0, 0.0], [0.6, 1.0, 0.8]);
    let mut dual: World<Dual<4>> = plain.constant();
    let x = [0.1, 0.2, 20.0, 5.0];
    fn set<N: Number>(world: &mut World<N>, [px, pz, turn, w]: [N; 4]) {
        let c = N::constant;
        world.place_region(RegionId(0), V3([px, c(-1.0), pz]), V3([c(0.0), turn, c(0.0)]), V3([w, c(4.0), c(6.0)]));
    }
    set(&mut dual, std::array::from_fn(|i| Dual::unknown(x[i], i)));
    for text in ["inside(a, room)", "gap(a, room) > 1", "connects(a, room, hall)"] {
        let formula = &program.constraints.iter().find(|c| c.text == text).unwrap().formula;
        let exact = truth(evaluate(formula, &dual).unwrap()).margin;
        for k in 0..4 {
            let mut at = |by: f64| {
                let mut y = x;
                y[k] += by;
                set(&mut plain, y);
                truth(evaluate(formula, &plain).unwrap()).margin
            };
            let expect = (at(1e-5) - at(-1e-5)) / 2e-5;
            assert!((exact.slope[k] - expect).abs() < 1e-4, "{text} by {k}: {} and {expect}", exact.slope[k]);
        }
    }
}
