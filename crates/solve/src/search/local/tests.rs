//! What a search believes of a layout is what it would find if it looked at all of it anew, after any moves kept or taken
//! back; and of plain boxes it is what the evaluator says.

use super::LocalSearch;
use super::moves::turned;
use crate::problem::setup::setup;
use crate::problem::{Options, Placed, Problem};
use crate::search::chance::Chance;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use scenelang_engine::candidate::Candidate;
use scenelang_engine::frame::checks::Check;
use scenelang_engine::limit::Limit;
use scenelang_engine::penalty;
use scenelang_lang::program::ObjectId;
use scenelang_lang::{Options as Reading, compile_text};
use scenelang_layout::{Joint, Layout, Motion, Part, Placement, Vec3};
use scenelang_verify::Opens;
use std::path::Path;

const SCENES: [&str; 6] = [
    // Equations on every axis, chains, turns that are the same.
    "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(6, 3, 5);
     object a; object b; object c; object d;
     assert inside(a, room) and inside(b, room) and inside(c, room) and inside(d, room);
     assert a.pos.x = b.pos.x + 1; assert c.pos.z = a.pos.z - 0.8; assert c.rot = a.rot; assert d.pos.x = 1;
     assert leftOf(b, d) or behind(b, d); assert facing(a, d);",
    // What has no code, and what is seen all around.
    "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(6, 3, 5);
     object a; object b; object c; object d; object e;
     assert againstWall(a, room); assert clear(a, front, 0.6); assert visible(a, b) or not visible(b, c);
     assert clear(b, front, 0.5) or near(b, a, 1); assert a.up.y > 0.5; assert on(d, b); assert distance(c, e) >= 1.5;
     prefer near(c, a, 0.5); prefer far(e, a, 2);",
    // Two storeys.
    "region low; low.pos <- vec3(0, 0, 0); low.scale <- vec3(5, 2.5, 5);
     region high; high.pos <- vec3(0, 3, 0); high.scale <- vec3(5, 2.5, 5);
     object a; object b; object c; object d;
     assert inside(a, low) and inside(b, high) and inside(c, high) and near(b, c, 0.5); assert on(d, c);",
    // An outline, and walls.
    "region ell; ell.pos <- vec3(0, 0, 0); ell.scale <- vec3(0, 2.6, 0);
     ell.vertices <- polygon(vec3(0, 0, 0), vec3(5, 0, 0), vec3(5, 0, 2.5), vec3(2.5, 0, 2.5), vec3(2.5, 0, 5), vec3(0, 0, 5));
     object a; object b; object c; object d;
     assert againstWall(a, ell); assert inCorner(b, ell); assert wallMounted(c, ell); assert near(d, a, 0.3) and parallel(d, a);",
    // What lies, what hangs aslant, and what may lean as it likes.
    "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(6, 3, 5);
     object book; object desk; object panel; object ramp; object lamp; object twin;
     book.dimensions <- vec3(0.2, 0.3, 0.05); book.rot <- rot(90, 0, 0); panel.rot <- rot(30, 40, 10);
     allowFloat(panel); allowFloat(ramp); allowFloat(twin);
     assert on(book, desk); assert inside(panel, room) and near(panel, desk, 0.4); assert on(lamp, book);
     assert ramp.rot.x >= 20 and ramp.rot.x <= 40 and gap(ramp, desk) <= 0.5; assert twin.rot = ramp.rot;",
    // Paths: what is believed of corridors is looked at in one pass, too.
    "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(6, 3, 5);
     object door; object a[3]; object b;
     assert connects(door, room) and door.pos.y = 0;
     assert forall x in a: reachable(door, x, 0.7); assert reachable(b, a[0], 0.9) or reachable(b, a[1], 0.9);
     prefer reachable(b, a[2], 0.6); prefer forall x in a: reachable(door, x, 1.1) and againstWall(x, room);",
];

#[test]
fn what_is_believed_after_many_moves_is_what_is_found_anew() {
    let both = SCENES.iter().enumerate().flat_map(|scene| [(scene, false), (scene, true)]);
    for ((index, text), tips) in both {
        let compiled = compile_text("s.scene", Path::new("s.scene"), text, Reading::default());
        let program = compiled.program.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let problem = Problem { program, start: Layout::default(), placed: Placed::None };
        let setup = setup(&problem, &Options::default());
        let mut state = Candidate::new(&setup.frame, setup.world.clone());
        let numbering = state.numbering;
        let mut world = setup.world.clone();
        for id in setup.frame.objects() {
            let [pos, rot, scale] = state.home(id).at(0.0, 0.0, 0.0).constant();
            world.place(id, pos, rot, scale);
        }
        let mut local = LocalSearch::new(&setup.frame, &world, numbering, tips);
        let mut chance = ChaCha8Rng::seed_from_u64(index as u64);
        local.search(&mut chance, 2_000, &Limit::default(), &[]);
        // Preferences, too.
        local.trial.preferring = true;
        local.trial.judge_all();
        local.trial.judge_paths();
        local.trial.plan_missing(&|| false);
        let (mut poses, mut compared) = (Vec::new(), 0);
        for round in 0..2_000 {
            let i = local.trial.movable[chance.below(local.trial.movable.len())];
            local.poses(i, &mut chance, &mut poses);
            let pose = poses[chance.below(poses.len())];
            local.trial.go(i, pose);
            if chance.below(4) == 0 {
                let angles = [chance.between(-90.0, 90.0), 90.0 * chance.below(3) as f64];
                if local.trial.may_lean(i) {
                    local.trial.go_lean(i, angles);
                }
            }
            if local.trial.judge(f64::INFINITY).is_some() && chance.below(3) > 0 {
                local.trial.keep();
            } else {
                local.trial.undo();
            }
            if round % 20 == 0 {
                let believed: Vec<(f64, bool)> =
                    (0..local.trial.cost.len()).map(|c| (local.trial.cost[c], local.trial.holds[c])).collect();
                local.trial.judge_all();
                local.trial.judge_paths();
                for (check, (cost, holds)) in believed.into_iter().enumerate() {
                    let what = numbering.check(check);
                    assert!(
                        (cost - local.trial.cost[check]).abs() < 1e-9,
                        "{index} {what:?}: {cost} {}",
                        local.trial.cost[check]
                    );
                    assert_eq!(holds, local.trial.holds[check], "{index} {what:?}");
                    compared += 1;
                }
            }
        }
        assert!(compared >= 400, "{compared}");
        // The evaluator's word on the last layout.
        if state.attempt(&local.trial.changes(), f64::INFINITY).is_some() {
            state.keep();
        }
        for check in 0..numbering.len() {
            let elsewhere = match numbering.check(check) {
                // A plan of a corridor is only a plan; that some walls hold a thing is said by a term, too.
                Check::Term(t) => setup.frame.terms[t].walks,
                Check::Bounds(id) => !local.trial.bounded[id.0 as usize],
                Check::Collide(..) | Check::Support(_) => false,
            };
            // What hardly fails or holds may be seen differently in the last digits.
            if !elsewhere && (local.trial.cost[check] == 0.0 || local.trial.cost[check] > 0.12) {
                assert_eq!(local.trial.holds[check], state.does_hold(check), "{index} {:?}", numbering.check(check));
            }
        }
    }
}

#[test]
fn what_is_built_anew_leaves_the_rest_where_it_was() {
    // Two that cannot both be so near to the third: the search is stuck at once.
    let text = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(9, 3, 9); object a[40];
        assert forall x in a: inside(x, room); assert distance(a[0], a[1]) <= 1; assert distance(a[0], a[1]) >= 2;";
    let compiled = compile_text("s.scene", Path::new("s.scene"), text, Reading::default());
    let program = compiled.program.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let problem = Problem { program, start: Layout::default(), placed: Placed::None };
    let setup = setup(&problem, &Options::default());
    let state = Candidate::new(&setup.frame, setup.world.clone());
    let mut local = LocalSearch::new(&setup.frame, &setup.world, state.numbering, false);
    let mut chance = ChaCha8Rng::seed_from_u64(3);
    assert!(!local.search(&mut chance, 1_500_000, &Limit::default(), &[]));
    let (least, before) = local.best_of_lineage().expect("all but one of the statements can hold");
    assert_eq!(least, 1);
    let mut moved = [0; 40];
    for _ in 0..20 {
        local.ruin(&mut chance, &|| false);
        assert!(local.trial.away.iter().all(|away| !away));
        let elsewhere: Vec<usize> = (0..40).filter(|&i| local.trial.inputs(i) != before[i]).collect();
        assert!((1..=7).contains(&elsewhere.len()), "{elsewhere:?}");
        elsewhere.into_iter().for_each(|i| moved[i] += 1);
    }
    // What is at fault is taken away each time.
    assert!(moved[0] + moved[1] >= 20, "{moved:?}");
}

/// A cupboard whose door turns about the vertical, with a drawer under it and a flap above.
fn cupboard() -> Placement {
    let part = |y: f64, h: f64, z: f64, d: f64| Part::Box {
        pos: Vec3::new(0.0, y, z),
        size: Vec3::new(0.8, h, d),
        rot: Vec3::zeros(),
    };
    let joint = |name: &str, motion, axis, anchor, most: f64, moved: usize| Joint {
        name: name.into(),
        motion,
        axis,
        anchor,
        limits: [0.0, most],
        useful: Some(0.9 * most),
        handle: None,
        parts: vec![moved],
    };
    let joints = vec![
        joint("door", Motion::Hinge, -Vec3::y(), Vec3::new(-0.4, 0.0, 0.25), 100.0, 1),
        joint("drawer", Motion::Slide, Vec3::z(), Vec3::zeros(), 0.4, 2),
        joint("flap", Motion::Hinge, -Vec3::x(), Vec3::new(0.0, 1.6, 0.25), 90.0, 3),
    ];
    let parts = vec![
        part(0.8, 1.6, -0.01, 0.48),
        part(0.8, 0.7, 0.24, 0.02),
        part(0.2, 0.3, 0.24, 0.02),
        part(1.4, 0.4, 0.24, 0.02),
    ];
    let scale = Vec3::new(0.8, 1.6, 0.5);
    Placement { pos: Vec3::zeros(), rot: Vec3::zeros(), scale, parts, surface: None, joints }
}

/// Boxes at some poses are not the sweep: what they say may be this far off (metres).
const SWEPT: f64 = 0.03;

#[test]
fn what_opens_is_seen_as_the_evaluator_sees_it_but_for_a_little() {
    let text = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(3, 2.5, 3);
        object cupboard; object box; box.dimensions <- vec3(0.3, 0.5, 0.3); object chair; chair.category <- \"chair\";";
    let compiled = compile_text("s.scene", Path::new("s.scene"), text, Reading::default());
    let program = compiled.program.as_ref().unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
    let start = Layout { objects: vec![("cupboard".into(), cupboard())], ..Layout::default() };
    let problem = Problem { program, start, placed: Placed::None };
    let mut options = Options::default();
    options.judge.opens = Opens::All;
    let setup = setup(&problem, &options);
    let mut state = Candidate::new(&setup.frame, setup.world.clone());
    let mut local = LocalSearch::new(&setup.frame, &setup.world, state.numbering, false);
    assert!(setup.world.object(ObjectId(0)).is_ok_and(|thing| thing.body.has_parts()), "the parts fill the box");
    let opens = setup.frame.terms.iter().position(|term| term.opens.is_some()).expect("the cupboard opens");
    let mut chance = ChaCha8Rng::seed_from_u64(1);
    let mut seen = [0; 2];
    for _ in 0..400 {
        for i in 0..3 {
            let pose = local.anywhere(i, &mut chance);
            local.trial.settle(i, turned(pose, chance.between(0.0, 360.0)));
        }
        if state.attempt(&local.trial.changes(), f64::INFINITY).is_some() {
            state.keep();
        }
        let (boxes, exact) = (local.trial.cost[opens], state.cost(opens));
        let tells = |cost: f64| cost > penalty::BASE + SWEPT;
        assert!(!tells(boxes) || exact > 0.0, "{boxes} {exact}");
        assert!(!tells(exact) || boxes > 0.0, "{boxes} {exact}");
        seen[usize::from(exact > 0.0)] += 1;
    }
    assert!(seen[0] > 40 && seen[1] > 40, "{seen:?}");
}
