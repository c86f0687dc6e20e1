//! Twenty files of each kind: what was written is what is read, the program compiles, and the layout is judged; what is spoilt
//! in a file is found.

use crate::written::House;
use scenelang_base::FileId;
use scenelang_engine::check_layout_text;
use scenelang_foreign::{Beside, FileKind, Foreign, RoomFile, Sizes, read, recognise};
use scenelang_layout::{Layout, file, rotation};
use scenelang_verify::{Checked, Options};
use serde_json::{Value, json};
use std::path::Path;

pub fn taken(value: &Value, beside: &Beside) -> Foreign {
    let text = serde_json::to_string_pretty(value).unwrap();
    assert!(recognise(&text).is_some());
    read("house.json", Path::new("house.json"), &text, FileId(0), beside).unwrap_or_else(|e| panic!("{e:?}"))
}

pub fn judged(scene: &Foreign) -> Checked {
    let compile = scenelang_lang::Options::default();
    check_layout_text(&scene.layout_name, &scene.layout_path, scene.layout.clone(), &Options::default(), compile, scene)
}

/// The codes of what was found, without what is said of walls that rooms share.
fn codes(checked: &Checked) -> Vec<String> {
    let mut codes: Vec<String> = checked.verdict.diagnostics.iter().map(|d| d.code.to_string()).collect();
    codes.extend(
        checked.report.constraints.iter().filter(|row| row.satisfied == Some(false)).filter_map(|row| row.code.clone()),
    );
    codes.retain(|code| code != "W0502");
    codes.sort();
    codes.dedup();
    codes
}

fn layout(scene: &Foreign) -> Layout {
    let read = file::read(&scene.layout, FileId(0));
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    read.layout
}

fn sizes(value: &Value) -> Beside {
    Beside { sizes: Sizes::read(&value.to_string(), FileId(0)).unwrap(), room: None }
}

/// Holds what was read against what was written: rooms, openings, and the things of these rooms.
fn compare(house: &House, scene: &Foreign, rooms: usize, openings: usize) {
    let found = layout(scene);
    assert_eq!(found.regions.len(), rooms);
    for ((_, region), room) in found.regions.iter().zip(&house.rooms) {
        let corners = region.vertices.as_ref().unwrap();
        let has = |x: f64, z: f64| corners.iter().any(|c| (c[0] - x).abs() < 1e-5 && (c[1] - z).abs() < 1e-5);
        assert!(room.x.iter().all(|x| room.z.iter().all(|z| has(*x, *z))), "{corners:?} is not {room:?}");
        assert!((region.scale.y - house.height).abs() < 1e-5);
    }
    for (k, opening) in house.openings.iter().take(openings).enumerate() {
        let middle = (opening.z[0] + opening.z[1]) / 2.0;
        let what = if opening.is_window { "window" } else { "door" };
        let near = found.objects.iter().find(|(name, p)| {
            name.starts_with(what) && (p.pos.x - opening.x).abs() < 0.03 && (p.pos.z - middle).abs() < 1e-5
        });
        let (_, placed) = near.unwrap_or_else(|| panic!("opening {k} is not in its place"));
        assert!((placed.scale.x - 0.9).abs() < 1e-5 && (placed.pos.y - opening.y[0]).abs() < 1e-5);
    }
    let expected: Vec<_> = house.things.iter().filter(|thing| thing.room < rooms).collect();
    assert_eq!(found.objects.len(), openings + expected.len());
    for thing in expected {
        let here = |p: &scenelang_layout::Placement| (0..3).all(|k| (p.pos[k] - thing.base[k]).abs() < 1e-5);
        let (name, placed) =
            found.objects.iter().find(|(_, p)| here(p)).unwrap_or_else(|| panic!("{thing:?} is not there"));
        assert!((0..3).all(|k| (placed.scale[k] - thing.size[k]).abs() < 1e-5), "{name}: {placed:?} is not {thing:?}");
        let turned = rotation::matrix(scenelang_layout::Vec3::new(0.0, thing.yaw, 0.0));
        assert!((rotation::matrix(placed.rot) - turned).amax() < 1e-5, "{name}: {placed:?} is not {thing:?}");
    }
}

#[test]
fn houses_of_procthor() {
    for seed in 0..20 {
        let house = House::new(seed, 1 + seed as usize % 4);
        let scene = taken(&house.procthor(seed % 2 == 0), &sizes(&house.database()));
        assert_eq!(scene.kind, FileKind::House);
        compare(&house, &scene, house.rooms.len(), house.openings.len());
        assert_eq!(codes(&judged(&scene)), Vec::<String>::new(), "{}", scene.program);
    }
}

#[test]
fn houses_without_sizes_have_usual_ones_and_are_judged_all_the_same() {
    for seed in 0..20 {
        let house = House::new(seed, 2);
        let scene = taken(&house.procthor(false), &Beside::default());
        let said: Vec<&str> = scene.notes.iter().map(|note| note.message.as_str()).collect();
        assert!(said[0].starts_with("the file does not give the size of"), "{said:?}");
        assert!(said.iter().any(|say| say.contains("proceduralParameters")), "{said:?}");
        let checked = judged(&scene);
        assert!(checked.program.is_some() && checked.layout.is_some(), "{:?}", checked.verdict.diagnostics);
        // Nothing floats for lack of a size; what is too large for its place may overlap.
        let codes = codes(&checked);
        assert!(
            !codes.iter().any(|code| code == "V0104" || code.starts_with('E')),
            "{seed}: {codes:?}\n{}",
            scene.program
        );
    }
}

#[test]
fn houses_of_holodeck_have_sizes_of_their_own() {
    for seed in 0..20 {
        let house = House::new(100 + seed, 1 + seed as usize % 4);
        let value = house.holodeck();
        let scene = taken(&value, &sizes(&house.database()));
        compare(&house, &scene, house.rooms.len(), house.openings.len());
        assert_eq!(codes(&judged(&scene)), Vec::<String>::new());
        // What stands on the floor is as large without the list, too.
        let (with, without) = (layout(&scene), layout(&taken(&value, &Beside::default())));
        for ((name, a), (_, b)) in
            with.objects.iter().zip(&without.objects).filter(|((name, _), _)| !name.starts_with("vase"))
        {
            assert!((a.scale - b.scale).amax() < 1e-5 && (a.pos - b.pos).amax() < 1e-5, "{name}: {a:?} {b:?}");
        }
    }
}

#[test]
fn rooms_and_layouts_of_layoutvlm() {
    for seed in 0..20 {
        let house = House::new(200 + seed, 1);
        let [task, poses] = house.layoutvlm();
        let room = RoomFile::read(&task.to_string(), FileId(1)).unwrap();
        let scene = taken(&poses, &Beside { room: Some(room), ..Beside::default() });
        assert_eq!(scene.kind, FileKind::Poses);
        compare(&house, &scene, 1, 0);
        assert_eq!(codes(&judged(&scene)), Vec::<String>::new(), "{}", scene.program);
        let mut both = task.clone();
        both["layout"] = poses.clone();
        let whole = taken(&both, &Beside::default());
        assert_eq!((whole.kind, &whole.layout), (FileKind::Task, &scene.layout));
        // By itself a layout has no room, and things have the usual sizes.
        let alone = taken(&poses, &Beside::default());
        let checked = judged(&alone);
        assert!(checked.layout.is_some_and(|layout| layout.regions.is_empty()), "{:?}", checked.verdict.diagnostics);
    }
}

#[test]
fn scene_states() {
    for seed in 0..20 {
        let house = House::new(300 + seed, 1 + seed as usize % 3);
        let value = house.scene_state(seed % 2 == 0);
        let scene = taken(&value, &sizes(&house.database()));
        assert_eq!(scene.kind, FileKind::SceneState);
        compare(&house, &scene, house.rooms.len(), house.openings.len());
        assert_eq!(codes(&judged(&scene)), Vec::<String>::new(), "{}", scene.program);
        // Nobody says what the things are: then they are not there, and that is said.
        let bare = taken(&value, &Beside::default());
        assert_eq!(layout(&bare).objects.len(), house.openings.len());
        assert!(bare.notes.iter().any(|note| note.message.contains("size is unknown: ")));
    }
}

#[test]
fn what_is_wrong_in_a_house_is_found() {
    let house = House::new(7, 2);
    let sizes = sizes(&house.database());
    let found = |change: &dyn Fn(&mut Value)| {
        let mut value = house.procthor(false);
        change(&mut value);
        codes(&judged(&taken(&value, &sizes)))
    };
    let first = |value: &mut Value, key: &str, by: f64| {
        let at = &mut value["objects"][0]["position"][key];
        *at = json!(at.as_f64().unwrap() + by);
    };
    let has = |codes: Vec<String>, code: &str| assert!(codes.iter().any(|c| c == code), "{codes:?} has no {code}");
    has(found(&|value| value["objects"][0]["position"] = value["objects"][1]["position"].clone()), "V0102");
    has(found(&|value| first(value, "y", 0.5)), "V0104");
    has(found(&|value| first(value, "z", -30.0)), "V0103");
    // A door that leads to a room that it is not beside.
    let mut far = House::new(7, 3);
    far.openings[2].rooms = [Some(0), Some(2)];
    let scene = taken(&far.procthor(false), &self::sizes(&far.database()));
    has(codes(&judged(&scene)), "V0101");
}

#[test]
fn the_same_file_gives_the_same_bytes() {
    let house = House::new(3, 3);
    let [a, b] = [0; 2].map(|_| taken(&house.procthor(false), &Beside::default()));
    assert_eq!((a.program, a.layout), (b.program, b.layout));
}
