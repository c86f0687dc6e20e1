//! Edits on both sides: things are moved in the Unity project and the program is changed, in fifty scripted sequences. No edit is
//! lost without a word, and what cannot be joined is named.

use crate::back::{Room, SYNTH};
use crate::support::read_json;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;

/// Room enough that most places are free. Stool and twin are instances of one prefab as long as they have the same colour.
const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(6, 2.6, 6);\n\
    object bed;\nbed.category <- \"bed\";\nbed.dimensions <- vec3(1.6, 0.55, 2);\nbed.rot <- rot(0, 0, 0);\nassert inside(bed, room);\n\
    object stool;\nstool.category <- \"stool\";\nstool.rot <- rot(0, 0, 0);\nassert inside(stool, room);\n\
    object twin;\ntwin.category <- \"stool\";\ntwin.rot <- rot(0, 0, 0);\nassert inside(twin, room);\n";
const THINGS: [&str; 3] = ["bed", "stool", "twin"];
/// Rounds of a sequence.
const ROUNDS: u64 = 3;

/// A repeatable number (splitmix64).
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) % n
    }

    /// A place on the floor, sometimes one in a wall.
    fn place(&mut self) -> [f64; 3] {
        let mut along = || self.below(60) as f64 / 10.0 - 2.95;
        [along(), 0.0, along()]
    }
}

fn places(room: &Room) -> BTreeMap<String, [f64; 3]> {
    let layout = read_json(&room.at("out/room.layout.json"));
    let pos = |name: &str| std::array::from_fn(|k| layout["objects"][name]["pos"][k].as_f64().unwrap());
    THINGS.iter().map(|name| ((*name).to_owned(), pos(name))).collect()
}

fn is_there(place: &[f64; 3], other: &[f64; 3]) -> bool {
    place.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-5)
}

/// Changes the program; whether that may move something.
fn program(room: &Room, dice: &mut Dice, round: u64) -> bool {
    let path = room.at("room.scene");
    let text = fs::read_to_string(&path).unwrap();
    let (text, moves) = match dice.below(3) {
        0 => (format!("// Round {round}.\n{text}"), false),
        1 => {
            let color = ["red", "navy", "teal"][dice.below(3) as usize];
            let kept: String = text.split_inclusive('\n').filter(|line| !line.contains(".color")).collect();
            (format!("{kept}stool.color <- \"{color}\";\n"), false)
        }
        _ => {
            let least = dice.below(10) as f64 / 10.0;
            let kept: String = text.split_inclusive('\n').filter(|line| !line.contains("gap(")).collect();
            (format!("{kept}assert gap(stool, twin) >= {least};\n"), true)
        }
    };
    fs::write(path, text).unwrap();
    moves
}

/// Moves things in the Unity project; where to.
fn unity(room: &Room, dice: &mut Dice) -> BTreeMap<String, [f64; 3]> {
    let before = places(room);
    let mut put = BTreeMap::new();
    for _ in 0..=dice.below(2) {
        let name = THINGS[dice.below(3) as usize];
        let place = dice.place();
        if !is_there(&before[name], &place) {
            room.put("unity", name, place);
            put.insert(name.to_owned(), place);
        }
    }
    put
}

fn sequence(seed: u64) {
    let dice = &mut Dice(seed);
    let room = Room::of(ROOM, &SYNTH);
    for round in 0..ROUNDS {
        let what = format!("sequence {seed}, round {round}");
        let before = places(&room);
        let turn = dice.below(4);
        let moves = turn != 0 && program(&room, dice, round);
        let put = if turn == 1 { BTreeMap::new() } else { unity(&room, dice) };
        if put.is_empty() {
            let ended = room.run(&SYNTH, &[], 0);
            let now = places(&room);
            // What stands somewhere stays there, unless the program moves it.
            assert!(moves || before.iter().all(|(name, place)| is_there(place, &now[name])), "{what}: {ended:?}");
            continue;
        }
        // Another thing is put elsewhere in the other file: nobody knows which is meant.
        if turn == 3 {
            let files = room.files();
            room.put("glb", "bed", [1.0, 0.0, -1.0]);
            let (both, ended) = (room.files(), room.run(&SYNTH, &["--take"], 2));
            let named = ["out/room.glb", "out/unity"].iter().all(|file| ended.stderr.contains(file));
            assert!(named && ended.stderr.contains("were both edited"), "{what}: {ended:?}");
            assert!(room.files() == both, "{what}");
            fs::write(room.at("out/room.glb"), &files[&room.at("out/room.glb")]).unwrap();
        }
        let files = room.files();
        let ended = room.run(&SYNTH, &[], 2);
        let is_named = |name: &String| ended.stderr.contains(&format!("`{name}` was moved"));
        assert!(put.keys().all(is_named), "{what}: {put:?} {ended:?}");
        assert!(room.files() == files, "{what}: nothing is written");
        let ended = room.any(&SYNTH, &["--take", "--format", "json"]);
        assert!(ended.code <= 1, "{what}: {ended:?}");
        let told: Value = serde_json::from_str(&ended.stdout).unwrap();
        let says = |list: &Value, name: &str| {
            let start = format!("`{name}` was moved");
            list.as_array().unwrap().iter().any(|line| line.as_str().unwrap().starts_with(&start))
        };
        let now = places(&room);
        for (name, place) in &put {
            assert!(says(&told["taken"]["changes"], name), "{what}: {name} in {told:#}");
            let stays = is_there(place, &now[name]);
            assert!(stays || says(&told["taken"]["moved"], name), "{what}: {name} in {told:#}");
        }
        // Nor does what nobody touched go anywhere without a word.
        for (name, place) in before.iter().filter(|(name, _)| !put.contains_key(*name)) {
            assert!(is_there(place, &now[name]) || says(&told["taken"]["moved"], name), "{what}: {name} in {told:#}");
        }
    }
}

/// A tenth of the sequences, so that they run beside each other.
macro_rules! sequences {
    ($($name:ident: $from:expr),*) => {
        $(#[test]
        fn $name() {
            ($from..$from + 10).for_each(sequence);
        })*
    };
}
sequences!(first: 0, second: 10, third: 20, fourth: 30, fifth: 40);
