//! What samples promise: each is verified and depends on its number alone, and together they are spread as layouts are that
//! are drawn as a whole and kept where everything holds.

mod energy;
mod plain;
mod skipped;

use energy::distance_test;
use plain::{compiled, features, plain};
use scenelang_lang::Program;
use scenelang_sample::{Coverage, Drawn, Missing, Sampler, Settings, holds};

fn settings(whole: bool) -> Settings {
    Settings {
        seed: 7,
        judge: scenelang_verify::Options::default(),
        effort: 1,
        // What has no place need not be looked for long.
        budget: 1_000_000,
        scene: "t.scene".to_owned(),
        whole,
        stop: scenelang_solve::Stop::default(),
    }
}

fn samples(program: &Program, whole: bool, count: u64) -> Vec<Drawn> {
    let sampler = Sampler::new(program, settings(whole)).expect("the solver finds a layout");
    (0..count).map(|index| sampler.sample(index)).collect()
}

/// Small programs: what they are called, their room and their text. Things turn freely unless it is said otherwise. Of more than
/// two things none can be put on another: the room is not that high.
const PROGRAMS: &[(&str, &str, &str)] = &[
    (
        "two boxes that may not meet",
        RECTANGLE,
        "object a; a.dimensions <- vec3(1.2, 0.5, 0.8); object b; b.dimensions <- vec3(1, 0.5, 1);
         assert a.rot = rot(0, 0, 0);",
    ),
    (
        "two parts of the room that no small step joins",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.6, 0.5, 0.6); object b; b.dimensions <- vec3(0.8, 0.5, 0.4);
         assert abs(a.pos.x) >= 1 and abs(b.pos.z) >= 0.5 and a.rot = rot(0, 0, 0);",
    ),
    (
        "neighbours",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.6, 0.5, 0.6); object b; b.dimensions <- vec3(0.5, 0.5, 0.5);
         assert near(a, b, 0.6) and a.rot = rot(0, 0, 0) and b.rot = rot(0, 0, 0);",
    ),
    (
        "on the floor or on each other",
        RECTANGLE,
        "object a; a.dimensions <- vec3(2, 0.5, 1.5); object b; b.dimensions <- vec3(0.4, 0.4, 0.4);",
    ),
    (
        "turned towards each other",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.8, 0.5, 0.5); object b; b.dimensions <- vec3(0.5, 0.5, 0.5);
         assert dot(a.front, b.pos - a.pos) >= 0.4 and b.rot = rot(0, 0, 0);",
    ),
    (
        "a thing that another's place sets",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.5, 1.4, 0.5); object b; b.dimensions <- vec3(0.4, 1.4, 0.4);
         assert b.pos.x = a.pos.x and a.rot = rot(0, 0, 0) and b.rot = rot(0, 0, 0);",
    ),
    (
        "around a corner",
        ELBOW,
        "object a; a.dimensions <- vec3(1.2, 0.5, 0.8); object b; b.dimensions <- vec3(1, 0.5, 1);
         assert a.rot = rot(0, 0, 0);",
    ),
    ("one thing around a corner", ELBOW, "object a; a.dimensions <- vec3(1.6, 0.5, 0.6);"),
    (
        "three high boxes",
        RECTANGLE,
        "object a; a.dimensions <- vec3(1, 1.4, 0.6); object b; b.dimensions <- vec3(0.8, 1.4, 0.8);
         object c; c.dimensions <- vec3(0.6, 1.4, 1);",
    ),
    (
        "five high boxes",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.6, 1.4, 0.6); object b; b.dimensions <- vec3(0.6, 1.4, 0.6);
         object c; c.dimensions <- vec3(0.6, 1.4, 0.6); object d; d.dimensions <- vec3(0.6, 1.4, 0.6);
         object e; e.dimensions <- vec3(0.6, 1.4, 0.6);",
    ),
    (
        "two that cannot pass each other",
        CORRIDOR,
        "object a; a.dimensions <- vec3(0.8, 1.4, 0.7); object b; b.dimensions <- vec3(1.2, 1.4, 0.7);
         assert a.rot = rot(0, 0, 0) and b.rot = rot(0, 0, 0);",
    ),
    (
        "a row of three",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.5, 1.4, 0.5); object b; b.dimensions <- vec3(0.5, 1.4, 0.5);
         object c; c.dimensions <- vec3(0.5, 1.4, 0.5);
         assert near(a, b, 0.8) and near(b, c, 0.8) and a.rot = rot(0, 0, 0) and b.rot = rot(0, 0, 0) and c.rot = rot(0, 0, 0);",
    ),
    (
        "one of two corners",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.5, 0.5, 0.5); object b; b.dimensions <- vec3(0.7, 0.5, 0.5);
         assert a.pos.x >= 1 and a.pos.z >= 0.5 or a.pos.x <= -1.2 and a.pos.z <= -0.8;",
    ),
    (
        "far from each other",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.5, 0.5, 0.5); object b; b.dimensions <- vec3(0.7, 0.5, 0.5);
         assert gap(a, b) >= 1.5;",
    ),
    (
        "side by side, whichever way they are turned",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.5, 0.5, 0.5); object b; b.dimensions <- vec3(0.6, 0.5, 0.4);
         assert dot(b.pos - a.pos, a.right) >= 0.5 and gap(a, b) <= 0.5 and b.rot = rot(0, 0, 0);",
    ),
    (
        "in a ring",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.5, 0.5, 0.5);
         assert length(vec3(a.pos.x, 0, a.pos.z)) >= 0.7 and length(vec3(a.pos.x, 0, a.pos.z)) <= 1.1;",
    ),
    (
        "two in two rooms",
        ROOMS,
        "object a; a.dimensions <- vec3(0.6, 1.4, 0.6); object b; b.dimensions <- vec3(0.6, 1.4, 0.6);
         assert gap(a, b) >= 0.4;",
    ),
    (
        "nearly as wide as the room",
        CORRIDOR,
        "object a; a.dimensions <- vec3(0.9, 0.5, 0.4); object b; b.dimensions <- vec3(0.3, 0.5, 0.3);",
    ),
    (
        "a thing midway between two",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.4, 1.4, 0.4); object b; b.dimensions <- vec3(0.4, 1.4, 0.4);
         object c; c.dimensions <- vec3(0.4, 1.4, 0.4);
         assert length(a.pos + b.pos - c.pos - c.pos) <= 0.8 and a.rot = rot(0, 0, 0) and b.rot = rot(0, 0, 0);",
    ),
    (
        "turned alike, give or take",
        RECTANGLE,
        "object a; a.dimensions <- vec3(0.9, 0.5, 0.5); object b; b.dimensions <- vec3(0.9, 0.5, 0.5);
         assert dot(a.front, b.front) >= 0.8;",
    ),
];

const RECTANGLE: &str = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(4, 2.5, 3);\n";
const CORRIDOR: &str = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(4, 2.5, 1);\n";
const ELBOW: &str = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(4, 2.5, 4);
room.vertices <- polygon(vec3(-2, 0, -2), vec3(2, 0, -2), vec3(2, 0, 0), vec3(0, 0, 0), vec3(0, 0, 2), vec3(-2, 0, 2));\n";
const ROOMS: &str = "region room; room.pos <- vec3(-1, 0, 0); room.scale <- vec3(2, 2.5, 3);
region other; other.pos <- vec3(1.1, 0, 0); other.scale <- vec3(1.8, 2.5, 2);\n";

fn text_of(which: usize) -> String {
    let (_, room, text) = PROGRAMS[which];
    format!("{room}{text}")
}

/// Whether samples of a program and layouts drawn plainly can be told apart: the chance that two samples of one distribution
/// are as far from each other.
fn likeness(which: usize, whole: bool, count: usize, partitions: usize) -> f64 {
    let text = text_of(which);
    let compiled = compiled(&text);
    let program = compiled.program.as_ref().expect("it compiles");
    let ours: Vec<Vec<f64>> = samples(program, whole, count as u64)
        .iter()
        .map(|drawn| features(program, &drawn.result.as_ref().expect("each sample is good").layout))
        .collect();
    let theirs: Vec<Vec<f64>> =
        plain(program, count, 1000 + which as u64).iter().map(|layout| features(program, layout)).collect();
    distance_test(&ours, &theirs, partitions)
}

/// Both ways to draw, on a program of the list: so many samples drawn as a whole, so many by chains. `level`: how seldom the
/// test fails where there is nothing to find.
fn alike(which: usize, counts: [usize; 2], level: f64) {
    let text = text_of(which);
    for (whole, count) in std::iter::zip([true, false], counts) {
        let chance = likeness(which, whole, count, (1.2 / level) as usize);
        eprintln!("{}, {}: {chance:.4}", PROGRAMS[which].0, if whole { "as a whole" } else { "by chains" });
        assert!(chance >= level, "drawn as a whole: {whole}; the chance is {chance:.4}\n{text}");
    }
}

/// How many samples of each program are drawn as a whole and by chains in each run of the tests. What stands on each other is
/// seldom drawn plainly.
fn few(which: usize) -> [usize; 2] {
    if which == 3 { [40, 25] } else { [60, 30] }
}

/// All programs, both ways, with so many samples of each. A test at this level fails once in a hundred times where there is
/// nothing to find, so one of them may.
fn all_alike(counts: impl Fn(usize) -> [usize; 2] + Sync) {
    let next = std::sync::atomic::AtomicUsize::new(0);
    let failed = std::sync::Mutex::new(Vec::new());
    let labour = || {
        loop {
            let which = next.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            if which >= PROGRAMS.len() {
                return;
            }
            let counts = counts(which);
            if std::panic::catch_unwind(|| alike(which, counts, 0.01)).is_err() {
                failed.lock().expect("nobody panics while holding it").push(PROGRAMS[which].0);
            }
        }
    };
    std::thread::scope(|scope| {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        (0..threads).for_each(|_| drop(scope.spawn(labour)));
    });
    let failed = failed.into_inner().expect("nobody panics while holding it");
    assert!(failed.len() <= 1, "{failed:?}");
}

#[test]
fn few_are_spread_as_plainly_drawn_ones() {
    all_alike(few);
}

#[test]
#[ignore = "minutes: 2,000 samples of each program, both ways"]
fn many_are_spread_as_plainly_drawn_ones() {
    all_alike(|_| [2000, 2000]);
}

#[test]
fn a_sample_depends_on_its_number_alone() {
    let text = format!("{}object c; c.dimensions <- vec3(rand(0.3, 0.9), 0.4, 0.4);", text_of(0));
    for text in [text_of(2), text] {
        let compiled = compiled(&text);
        let program = compiled.program.as_ref().expect("it compiles");
        let line = |drawn: Drawn| drawn.result.expect("it has a layout").line;
        let sampler = Sampler::new(program, settings(false)).expect("there is a layout");
        let forwards: Vec<String> = (0..6).map(|i| line(sampler.sample(i))).collect();
        let another = Sampler::new(program, settings(false)).expect("there is a layout");
        let backwards: Vec<String> = (0..6).rev().map(|i| line(another.sample(i))).collect();
        assert_eq!(forwards, backwards.into_iter().rev().collect::<Vec<_>>());
        let distinct: std::collections::BTreeSet<_> = forwards.iter().collect();
        assert_eq!(distinct.len(), 6);
    }
}

#[test]
fn each_sample_has_draws_of_its_own_and_hopeless_ones_are_counted() {
    // A box of more than 3 m by 4 m has no place in the room.
    let text =
        format!("{RECTANGLE}object a; a.dimensions <- vec3(rand(3.5, 4.5), 0.5, 2.9); assert a.rot = rot(0, 0, 0);");
    let compiled = compiled(&text);
    let program = compiled.program.as_ref().expect("it compiles");
    let all = samples(program, true, 12);
    let mut coverage = Coverage::new(program);
    all.iter().for_each(|drawn| coverage.add(drawn));
    let widths: std::collections::BTreeSet<u64> = all
        .iter()
        .filter_map(|drawn| Some(drawn.result.as_ref().ok()?.layout.objects[0].1.scale.x.to_bits()))
        .collect();
    assert_eq!(widths.len() as u64, coverage.stored, "each has another width");
    assert!(coverage.stored > 0 && coverage.no_layout > 0, "{coverage:?}");
    assert_eq!(coverage.stored + coverage.no_layout, 12);
    let hopeless = all.iter().filter(|drawn| drawn.result.as_ref().err() == Some(&Missing::NoLayout));
    for drawn in hopeless {
        let draws = scenelang_solve::draws(program, drawn.seed);
        assert!(draws[0].1 > 4.0 - 0.1, "{draws:?} admits layouts");
    }
}

/// A colour that no statement reads has no say in where things are; a size has.
#[test]
fn choices_are_made_anew_for_each_sample() {
    let looks = "a.color <- oneOf(\"red\", \"green\", \"blue\"); b.material <- oneOf(\"oak\", \"walnut\");";
    let sizes = "object c; c.dimensions <- oneOf(vec3(0.4, 0.5, 0.3), vec3(0.6, 0.5, 0.3)); assert c.scale.x < 1;";
    // The second size is more than the room holds.
    let hopeless = "object c; c.dimensions <- oneOf(vec3(0.4, 0.5, 0.3), vec3(9, 0.5, 9));";
    for (text, count) in [(looks, 60), (sizes, 24), (hopeless, 12)] {
        let text = format!("{}{text}", text_of(0));
        let compiled = compiled(&text);
        let program = compiled.program.as_ref().expect("it compiles");
        let all = samples(program, true, count);
        let mut coverage = Coverage::new(program);
        all.iter().for_each(|drawn| coverage.add(drawn));
        let report = coverage.json(program, &|index| format!("statement {index}"));
        for drawn in all.iter() {
            assert_eq!(drawn.draws, scenelang_solve::draws(program, drawn.seed));
            if let Ok(sample) = &drawn.result {
                assert_eq!(sample.layout.draws, drawn.draws);
                assert!(holds(program, &sample.layout, &scenelang_verify::Options::default()));
            }
        }
        let draws = report["draws"].as_array().expect("a list");
        assert_eq!(draws.len(), program.draws.len());
        for draw in draws {
            let of = |member: &str| -> Vec<u64> {
                let choices = draw["choices"].as_array().expect("a list");
                choices.iter().map(|choice| choice[member].as_u64().expect("a count")).collect()
            };
            let (stored, none) = (of("stored"), of("noLayout"));
            assert_eq!(stored.iter().chain(&none).sum::<u64>(), count, "{draw}");
            if text.contains("vec3(9") {
                assert!(stored[0] > 0 && none[1] > 0 && stored[1] == 0 && none[0] == 0, "{draw}");
            } else {
                assert!(stored.iter().all(|times| *times >= count / 6), "{draw}");
            }
        }
        let is_shared = text.contains("color");
        assert_eq!(program.draws_of_places().is_empty(), is_shared);
        assert_eq!(coverage.text(program, &|_| String::new()).contains("red "), is_shared);
    }
}

/// What is drawn for looks alone is spread as it is without.
#[test]
fn looks_do_not_change_where_things_are() {
    let plain = text_of(1);
    let looks = format!("{plain}a.color <- oneOf(\"red\", \"green\");");
    let [plain, looks] = [&plain, &looks].map(|text| {
        let compiled = compiled(text);
        let program = compiled.program.as_ref().expect("it compiles");
        let poses = |drawn: Drawn| {
            let objects = drawn.result.expect("it has a layout").layout.objects;
            objects.into_iter().map(|(_, placement)| (placement.pos, placement.rot)).collect::<Vec<_>>()
        };
        samples(program, true, 8).into_iter().map(poses).collect::<Vec<_>>()
    });
    assert_eq!(plain, looks);
}

#[test]
fn a_furnished_room_is_sampled() {
    let text = "region room; room.pos <- vec3(0, 0, 0); room.scale <- vec3(4, 2.6, 3.6);
        object door; door.category <- \"door\"; door.dimensions <- vec3(0.9, 2, 0.06);
        object bed; bed.category <- \"bed\"; bed.dimensions <- vec3(1.4, 0.9, 2);
        object nightstand; nightstand.category <- \"nightstand\"; nightstand.dimensions <- vec3(0.4, 0.5, 0.4);
        object lamp; lamp.category <- \"lamp\"; lamp.dimensions <- vec3(0.2, 0.4, 0.2);
        object picture; picture.category <- \"picture\"; picture.dimensions <- vec3(0.6, 0.4, 0.04);
        assert connects(door, room) and onFloor(door, room);
        assert againstWall(bed, room) and againstWall(nightstand, room) and near(nightstand, bed, 0.3);
        assert on(lamp, nightstand) and wallMounted(picture, room) and picture.bottom >= 1.2;
        assert reachable(door, bed, 0.5);";
    let compiled = compiled(text);
    let program = compiled.program.as_ref().expect("it compiles");
    let mut coverage = Coverage::new(program);
    for drawn in samples(program, true, 3) {
        let sample = drawn.result.as_ref().expect("there is a layout");
        assert!(holds(program, &sample.layout, &scenelang_verify::Options::default()));
        assert!(!sample.whole);
        coverage.add(&drawn);
    }
    let report = coverage.json(program, &|index| format!("statement {index}"));
    assert_eq!(report["objects"].as_array().map(Vec::len), Some(5), "everything moves: {report}");
    assert!(report["nearestNeighbour"]["mean"].as_f64() > Some(0.3), "{report}");
}
