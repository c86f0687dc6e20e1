//! Scenes of other sizes and elsewhere: things of a tenth of a millimetre, halls of ten kilometres, scenes far from the
//! origin.

use super::make;
use super::scene::{Part, Scene};
use super::space::times;
use crate::dice::Dice;
use crate::given::judged;
use scenelang_verify::report::model::Row;
use scenelang_verify::{Explain, Options};
use std::fmt::Write as _;

impl Scene {
    /// All lengths times a number.
    pub fn scaled(&mut self, by: f64) {
        for thing in &mut self.things {
            thing.pos = times(thing.pos, by);
            thing.scale = times(thing.scale, by);
            thing.surface = thing.surface.map(|s| s * by);
            thing.dimensions = thing.dimensions.map(|d| times(d, by));
            for part in &mut thing.parts {
                match part {
                    Part::Box { pos, size, .. } => (*pos, *size) = (times(*pos, by), times(*size, by)),
                    Part::Cylinder { pos, radius, height, .. } => {
                        (*pos, *radius, *height) = (times(*pos, by), *radius * by, *height * by);
                    }
                    Part::Hull { points } => points.iter_mut().for_each(|p| *p = times(*p, by)),
                }
            }
        }
        for room in &mut self.rooms {
            room.pos = times(room.pos, by);
            room.scale = times(room.scale, by);
            room.vertices.iter_mut().flatten().for_each(|v| *v = v.map(|x| x * by));
        }
    }
    pub fn moved(&mut self, by: [f64; 2]) {
        let shift = |x: &mut f64, by: f64| *x += by;
        for pos in self.things.iter_mut().map(|t| &mut t.pos).chain(self.rooms.iter_mut().map(|r| &mut r.pos)) {
            shift(&mut pos[0], by[0]);
            shift(&mut pos[2], by[1]);
        }
        for v in self.rooms.iter_mut().filter_map(|r| r.vertices.as_mut()).flatten() {
            shift(&mut v[0], by[0]);
            shift(&mut v[1], by[1]);
        }
    }
}

/// Statements that do not say where the origin is, two objects and two regions at a time.
fn relative(scene: &Scene) -> String {
    let mut out = String::new();
    let names: Vec<&str> = scene.things.iter().map(|t| t.name.as_str()).filter(|n| !n.contains('[')).collect();
    for a in &names {
        for b in names.iter().filter(|b| *b != a) {
            for p in
                ["leftOf", "above", "facing", "aligned", "parallel", "on", "under", "inside", "visible", "collides"]
            {
                writeln!(out, "assert {p}({a}, {b});").unwrap();
            }
            writeln!(out, "assert gap({a}, {b}) > 0.1;\nassert distance({a}, {b}) <= 1.5;").unwrap();
            writeln!(out, "assert dot({a}.max - {b}.min, {b}.right) > 0.3;").unwrap();
        }
        for r in &scene.rooms {
            for p in ["inside", "againstWall", "inCorner", "centeredIn", "wallMounted", "onFloor"] {
                writeln!(out, "assert {p}({a}, {});", r.name).unwrap();
            }
            writeln!(out, "assert gap({a}, {}) > 0.2;\nassert distance({a}, {}) < {}.area;", r.name, r.name, r.name)
                .unwrap();
        }
        writeln!(out, "assert clear({a}, front, 0.7);\nassert clear({a}, left, 0.4);").unwrap();
    }
    out
}

/// Whether two rows say the same, as far as rounding allows.
fn agree(a: &Row, b: &Row) -> bool {
    let near = |x: f64| x.abs() < 1e-5 || (x.abs() - 1e-3).abs() < 1e-5;
    if a.rule.as_deref() == Some("P-SUPPORT") {
        // Of its margin the sign alone has a meaning: what nearly carries it may be one thing or another.
        return a.id == b.id && (a.satisfied == b.satisfied || a.margin.is_some_and(near));
    }
    match (a.margin, b.margin) {
        // One value for another, or one region for another, within rounding of each other.
        (Some(x), Some(y)) => a.id == b.id && (x - y).abs() < 1e-5 && (a.satisfied == b.satisfied || near(x)),
        (x, y) => a.id == b.id && x == y && a.satisfied == b.satisfied,
    }
}

#[test]
fn a_scene_moved_by_ten_kilometres_is_judged_alike() {
    let mut options = Options::default();
    options.detail.all = true;
    options.detail.explain = Explain::First(0);
    let (mut rows, mut wrong) = (0, String::new());
    for seed in 0..super::number("SCENELANG_CASES", 2_000) / 20 {
        let mut scene = make::scene(&mut Dice(seed ^ 0xf00d));
        scene.chosen.clear();
        let nearer = scene.things[0].pos;
        scene.moved([-nearer[0], -nearer[2]]);
        let program = super::program::Program::default().text(&scene) + &relative(&scene);
        let here = judged(&program, &scene.layout(), &options).report;
        scene.moved([10_000.0, -10_000.0]);
        let there = judged(&program, &scene.layout(), &options).report;
        assert_eq!(here.constraints.len(), there.constraints.len());
        assert!(here.constraints.len() > 20, "{:?}", here.diagnostics);
        rows += here.constraints.len();
        for (a, b) in here.constraints.iter().zip(&there.constraints).filter(|(a, b)| !agree(a, b)) {
            let (x, y) = ((a.satisfied, a.margin), (b.satisfied, b.margin));
            writeln!(wrong, "seed {seed}: {} `{}`: {x:?} here, {y:?} there\n{}", a.id, a.text, scene.layout()).unwrap();
        }
    }
    assert!(wrong.is_empty(), "of {rows} rows:\n{wrong}");
}
