//! Doors that open: layouts that are found leave them room, and repair makes room.

use scenelang_lang::{Program, compile_text};
use scenelang_layout::{Joint, Layout, Motion, Part, Placement, RegionPlacement, Vec3};
use scenelang_solve::repair::{Damaged, How, RepairOptions, Which, repair};
use scenelang_solve::{Options, Placed, Problem, solve};
use scenelang_verify::{Opens, check};
use std::ops::ControlFlow;
use std::path::Path;

const ROOM: &str = "
region room; object door; object wardrobe; object bed; object desk;
room.pos <- vec3(0, 0, 0); room.scale <- vec3(2.9, 2.5, 2.9);
assert connects(door, room);
assert door.rot.y = 0 or door.rot.y = 90 or door.rot.y = 180 or door.rot.y = 270;
assert inside(wardrobe, room); assert inside(bed, room); assert inside(desk, room);
";

fn compiled(text: &str) -> Program {
    let compiled = compile_text("room.scene", Path::new("room.scene"), text, scenelang_lang::Options::default());
    compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics))
}

fn place(scale: [f64; 3]) -> Placement {
    Placement {
        pos: Vec3::zeros(),
        rot: Vec3::zeros(),
        scale: Vec3::from(scale),
        parts: Vec::new(),
        surface: None,
        joints: Vec::new(),
    }
}

/// A door 0.9 m wide with a leaf of 0.76 m, which opens to its front.
fn door() -> Placement {
    let part = |x: f64, w: f64, h: f64, d: f64| Part::Box {
        pos: Vec3::new(x, h / 2.0, 0.0),
        size: Vec3::new(w, h, d),
        rot: Vec3::zeros(),
    };
    let leaf = Joint {
        name: "leaf".into(),
        motion: Motion::Hinge,
        axis: -Vec3::y(),
        anchor: Vec3::new(-0.38, 0.0, 0.03),
        limits: [0.0, 110.0],
        useful: Some(90.0),
        handle: None,
        parts: vec![2],
    };
    let parts = vec![part(-0.415, 0.07, 2.1, 0.1), part(0.415, 0.07, 2.1, 0.1), part(0.0, 0.76, 2.02, 0.06)];
    Placement { parts, joints: vec![leaf], ..place([0.9, 2.1, 0.1]) }
}

fn start() -> Layout {
    let things = [
        ("door", door()),
        ("wardrobe", place([1.5, 2.0, 0.6])),
        ("bed", place([1.4, 0.5, 2.0])),
        ("desk", place([1.2, 0.75, 0.6])),
    ];
    Layout { objects: things.map(|(name, thing)| (name.into(), thing)).to_vec(), ..Layout::default() }
}

/// How many rows of P-OPEN fail in a layout, and whether anything else does.
fn failing(program: &Program, layout: &Layout) -> (usize, bool) {
    let rows = check(program, layout, &scenelang_verify::Options::default()).rows;
    let fails =
        |open: bool| rows.iter().filter(|r| r.satisfied == Some(false) && (r.code.as_str() == "V0107") == open).count();
    (fails(true), fails(false) > 0)
}

#[test]
fn layouts_leave_doors_room() {
    let program = compiled(ROOM);
    let problem = Problem { program: &program, start: start(), placed: Placed::None };
    let (mut barred, mut wrong) = (0, Vec::new());
    for seed in 0..10 {
        let mut options = Options { seed, ..Options::default() };
        let found = solve(&problem, &options, &mut |_| ControlFlow::Continue(()));
        if !found.converged || failing(&program, &found.layout) != (0, false) {
            wrong.push((seed, found.unsatisfied));
        }
        options.judge.opens = Opens::None;
        let careless = solve(&problem, &options, &mut |_| ControlFlow::Continue(()));
        barred += failing(&program, &careless.layout).0;
    }
    assert!(wrong.is_empty(), "{wrong:?}");
    assert!(barred > 0, "without the rule some doors are barred");
}

/// A pole between two of the poses at which the search looks at the leaf: only the evaluator sees that it is in the way.
#[test]
fn what_is_met_between_two_poses_is_moved_away() {
    let program = compiled(
        "region hall; object door; object pole;
         hall.pos <- vec3(0, 0, 0); hall.scale <- vec3(4, 2.5, 3); door.pos <- vec3(0, 0, -1.5); door.rot <- rot(0, 0, 0);
         assert connects(door, hall); assert abs(pole.pos.x - 0.2) <= 0.1 and abs(pole.pos.z + 1) <= 0.1;",
    );
    let things = [("door", door()), ("pole", place([0.03, 2.0, 0.03]))];
    let start = Layout { objects: things.map(|(name, thing)| (name.into(), thing)).to_vec(), ..Layout::default() };
    let problem = Problem { program: &program, start, placed: Placed::None };
    for seed in 0..10 {
        let options = Options { seed, ..Options::default() };
        let found = solve(&problem, &options, &mut |_| ControlFlow::Continue(()));
        assert!(found.converged, "{seed}: {:?}", found.unsatisfied);
    }
}

#[test]
fn repair_makes_room_for_a_door() {
    let program = compiled("region hall; object door; object wardrobe; assert connects(door, hall);");
    let hall =
        RegionPlacement { pos: Vec3::zeros(), rot: Vec3::zeros(), scale: Vec3::new(4.0, 2.5, 3.0), vertices: None };
    // 0.57 m between the door and the wardrobe.
    let at = |thing: Placement, z: f64| Placement { pos: Vec3::new(0.0, 0.0, z), ..thing };
    let layout = Layout {
        objects: vec![("door".into(), at(door(), -1.5)), ("wardrobe".into(), at(place([1.2, 2.0, 0.6]), -0.58))],
        regions: vec![("hall".into(), hall)],
        ..Layout::default()
    };
    assert_eq!(failing(&program, &layout), (1, false));
    let damaged = Damaged { program: &program, layout: &layout, text: None };
    let found = repair(&damaged, &Which::All, &RepairOptions::default()).unwrap();
    let best = found.alternatives.first().expect("there is a way");
    assert_eq!((best.how, best.moves.len()), (How::Moves, 1));
    assert_eq!(failing(&program, &best.layout), (0, false));
}
