//! Rooms that can be furnished so that all of it opens, solved with and without the demand that it does: how many are
//! solved, and how much more work that is. Work is counted, so the figures are the same on every machine.
//!
//! `SCENELANG_ROOMS=100` solves as many rooms as the figures in the documentation are about. It prints times as well, which
//! differ much less: in most of a search looking at what opens is cheap.

use crate::hostile::Dice;
use scenelang_lang::{Program, compile_text};
use scenelang_layout::{Layout, Vec3};
use scenelang_solve::{Outcome, Placed, Problem, draws, solve};
use scenelang_synth::furnish;
use scenelang_verify::{Opens, Options, check};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

/// Rooms in a usual run of the tests.
const ROOMS: usize = 8;
/// Furniture that opens, with its width and depth.
const OPENS: [(&str, [f64; 2]); 9] = [
    ("wardrobe", [1.2, 0.6]),
    ("cabinet", [0.9, 0.45]),
    ("dresser", [1.0, 0.5]),
    ("nightstand", [0.45, 0.4]),
    ("filing cabinet", [0.45, 0.6]),
    ("fridge", [0.7, 0.7]),
    ("desk", [1.4, 0.7]),
    ("sideboard", [1.6, 0.45]),
    ("tv stand", [1.5, 0.4]),
];
/// And furniture that does not.
const PLAIN: [(&str, [f64; 2]); 6] = [
    ("bed", [1.6, 2.1]),
    ("sofa", [2.0, 0.9]),
    ("coffee table", [1.1, 0.6]),
    ("bookshelf", [0.9, 0.3]),
    ("dining table", [1.4, 0.8]),
    ("armchair", [0.85, 0.85]),
];
/// Heights of all of them are the same: nothing here is about them.
const HEIGHT: f64 = 1.1;
/// The work of a median room is at most so many times as much.
const DEARER: f64 = 3.5;
/// So much of the floor is covered, at most.
const COVERED: f64 = 0.35;

/// A rectangle on the floor: least and greatest x, least and greatest z.
type Rect = [f64; 4];

/// A thing of the hidden layout.
struct Thing {
    name: String,
    category: &'static str,
    size: [f64; 2],
    at: [f64; 2],
    yaw: f64,
    opens: bool,
}

fn between(dice: &mut Dice, from: f64, to: f64) -> f64 {
    from + (to - from) * dice.below(1 << 40) as f64 / (1_u64 << 40) as f64
}

/// A box around a thing, `front` metres longer at its front.
fn rect(at: [f64; 2], [w, d]: [f64; 2], yaw: f64, front: f64) -> Rect {
    let [x, z] = at;
    let (low, high) = (d / 2.0, d / 2.0 + front);
    match yaw as i32 {
        0 => [x - w / 2.0, x + w / 2.0, z - low, z + high],
        90 => [x - low, x + high, z - w / 2.0, z + w / 2.0],
        180 => [x - w / 2.0, x + w / 2.0, z - high, z + low],
        _ => [x - high, x + low, z - w / 2.0, z + w / 2.0],
    }
}

fn overlap(a: &Rect, b: &Rect) -> bool {
    a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3]
}

/// Things in a room of this width and depth, each with room to open, and the place of the door.
fn hidden(dice: &mut Dice, [w, d]: [f64; 2]) -> (Vec<Thing>, f64) {
    let door = between(dice, -0.5, 0.5) * (w - 1.2);
    let mut taken: Vec<Rect> = vec![[door - 0.5, door + 0.5, -d / 2.0, -d / 2.0 + 1.0]];
    let mut bodies = taken.clone();
    let mut things: Vec<Thing> = Vec::new();
    let mut covered = 0.0;
    for i in 0..40 {
        let opens = i % 2 == 0;
        let (category, size) = if opens { OPENS[dice.below(9)] } else { PLAIN[dice.below(6)] };
        if covered + size[0] * size[1] > COVERED * w * d || things.len() == 10 {
            continue;
        }
        let yaw = 90.0 * dice.below(4) as f64;
        let front = if opens { size[0].clamp(0.7, 1.0) } else { 0.0 };
        let own = rect([0.0; 2], size, yaw, 0.0);
        let mut at = [0, 1].map(|k: usize| {
            let room = [w, d][k];
            between(dice, -room / 2.0 - own[2 * k], room / 2.0 - own[2 * k + 1])
        });
        // Most things stand with their back to a wall.
        if dice.below(4) > 0 {
            match yaw as i32 {
                0 => at[1] = -d / 2.0 + size[1] / 2.0,
                90 => at[0] = -w / 2.0 + size[1] / 2.0,
                180 => at[1] = d / 2.0 - size[1] / 2.0,
                _ => at[0] = w / 2.0 - size[1] / 2.0,
            }
        }
        let (body, whole) = (rect(at, size, yaw, 0.0), rect(at, size, yaw, front));
        let inside = whole[0] >= -w / 2.0 && whole[1] <= w / 2.0 && whole[2] >= -d / 2.0 && whole[3] <= d / 2.0;
        // Two may open into the same place, as long as they are closed.
        if inside && !taken.iter().any(|t| overlap(t, &body)) && !bodies.iter().any(|b| overlap(b, &whole)) {
            taken.push(whole);
            bodies.push(body);
            covered += size[0] * size[1];
            things.push(Thing { name: format!("thing_{}", things.len()), category, size, at, yaw, opens });
        }
    }
    (things, door)
}

/// The program of a room: its things, and what holds of them.
fn program(dice: &mut Dice, [w, d]: [f64; 2], things: &[Thing]) -> String {
    let mut text = format!(
        "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3({w}, 2.6, {d});\nobject door;\n\
         door.dimensions <- vec3(0.9, 2.1, 0.1);\nassert connects(door, room);\nassert door.rot.y = 0;\n"
    );
    for thing in things {
        let Thing { name, category, size: [w, d], yaw, .. } = thing;
        text += &format!(
            "object {name};\n{name}.category <- \"{category}\";\n{name}.dimensions <- vec3({w}, {HEIGHT}, {d});\n\
             assert inside({name}, room);\n"
        );
        text += &match dice.below(2) {
            0 => format!("assert {name}.rot.y = {yaw};\n"),
            _ => format!("assert {name}.rot.y = 0 or {name}.rot.y = 90 or {name}.rot.y = 180 or {name}.rot.y = 270;\n"),
        };
    }
    for pair in things.windows(2) {
        let [a, b] = pair else { continue };
        let (dx, dz) = (b.at[0] - a.at[0], b.at[1] - a.at[1]);
        let (a, b) = (&a.name, &b.name);
        text += &match dice.below(3) {
            0 => format!("assert distance({a}, {b}) <= {:.2};\n", 1.2 * dx.hypot(dz) + 0.1),
            1 if dx > 0.1 => format!("assert {a}.pos.x < {b}.pos.x;\n"),
            1 => format!("assert {a}.pos.x > {b}.pos.x - 0.2;\n"),
            _ if dz > 0.1 => format!("assert {a}.pos.z < {b}.pos.z;\n"),
            _ => format!("assert {a}.pos.z > {b}.pos.z - 0.2;\n"),
        };
    }
    text
}

fn compiled(text: &str) -> Program {
    let compiled = compile_text("room.scene", Path::new("room.scene"), text, scenelang_lang::Options::default());
    compiled.program.unwrap_or_else(|| panic!("{:?}\n{text}", compiled.diagnostics))
}

/// Sizes and parts, as `solve` gives them.
fn start(program: &Program) -> Layout {
    furnish(program, draws(program, 0), None, &Options::default()).layout
}

/// Without the rule for furniture, which demands of all of it what is compared here.
fn solved(program: &Program) -> (Outcome, Duration) {
    let judge = Options { opens: Opens::Doors, ..Options::default() };
    let options = scenelang_solve::Options { diagnose: false, judge, ..Default::default() };
    let problem = Problem { program, placed: Placed::None, start: start(program) };
    let since = Instant::now();
    (solve(&problem, &options, &mut |_| ControlFlow::Continue(())), since.elapsed())
}

/// A room: its program without what opens, and with it.
fn room(dice: &mut Dice) -> [Program; 2] {
    loop {
        let size = [between(dice, 3.2, 5.5), between(dice, 3.2, 5.5)].map(|x| (x * 100.0).round() / 100.0);
        let (things, door) = hidden(dice, size);
        let plain = program(dice, size, &things);
        let demands = things.iter().filter(|t| t.opens).map(|t| format!("assert opens({});\n", t.name));
        let text = demands.fold(plain.clone(), |text, demand| text + &demand);
        let both = [compiled(&plain), compiled(&text)];
        // The hidden layout is a solution, or this is none of the rooms.
        let mut layout = start(&both[1]);
        for (name, place) in &mut layout.objects {
            let thing = things.iter().find(|t| t.name == *name);
            let ([x, z], yaw) = thing.map_or(([door, -size[1] / 2.0], 0.0), |t| (t.at, t.yaw));
            (place.pos, place.rot) = (Vec3::new(x, 0.0, z), Vec3::new(0.0, yaw, 0.0));
        }
        let empty = scenelang_layout::RegionPlacement {
            pos: Vec3::zeros(),
            rot: Vec3::zeros(),
            scale: Vec3::new(size[0], 2.6, size[1]),
            vertices: None,
        };
        layout.regions = vec![("room".into(), empty)];
        let verdict = check(&both[1], &layout, &Options::default());
        let holds = verdict.rows.iter().all(|row| row.satisfied == Some(true));
        if holds && things.iter().filter(|t| t.opens).count() >= 2 {
            return both;
        }
    }
}

fn median<T: Copy + PartialOrd>(mut of: Vec<T>) -> T {
    of.sort_by(|a, b| a.partial_cmp(b).unwrap());
    of[of.len() / 2]
}

#[test]
fn rooms_in_which_all_opens_are_solved_for_little_more_work() {
    let rooms = std::env::var("SCENELANG_ROOMS").ok().and_then(|n| n.parse().ok()).unwrap_or(ROOMS);
    let mut dice = Dice(18);
    let mut unsolved = [0, 0];
    let (mut work, mut times) = ([Vec::new(), Vec::new()], [Vec::new(), Vec::new()]);
    for i in 0..rooms {
        for (k, program) in room(&mut dice).iter().enumerate() {
            let (outcome, time) = solved(program);
            if !outcome.converged {
                unsolved[k] += 1;
                println!("room {i}: not solved {}: {:?}", ["without", "with"][k], outcome.unsatisfied);
            }
            work[k].push(outcome.work as f64);
            times[k].push(time.as_secs_f64());
        }
    }
    let means = [0, 1].map(|k: usize| work[k].iter().sum::<f64>() / rooms as f64);
    let ratio = median(work[1].clone()) / median(work[0].clone());
    let [without, with] = times.map(median);
    println!(
        "{rooms} rooms: unsolved without and with: {unsolved:?}; median work {ratio:.3} times as much (means {means:.0?}); \
         median time {:.1} ms without, {:.1} ms with",
        without * 1e3,
        with * 1e3
    );
    assert!(unsolved[1] * 50 <= rooms, "{unsolved:?} of {rooms} are not solved");
    assert!(ratio <= DEARER, "{ratio} times the work");
}
