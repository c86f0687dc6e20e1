//! The guidelines of the library: what `check` reports of them, that their figure falls when a good room is spoiled, and that
//! a program can weigh them, replace them and turn them off.

use crate::support::scenelang;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// A room for one that keeps to every guideline.
const ROOM: &str = include_str!("design/room.scene");
const LAYOUT: &str = include_str!("design/room.layout.json");

/// A room is spoiled by putting things elsewhere: each with x, z and its yaw. The guidelines that this breaks, among others.
type Spoiling = (&'static str, &'static [(&'static str, [f64; 3])], &'static [&'static str]);

const SPOILINGS: [Spoiling; 25] = [
    ("the wardrobe stands in mid-room", &[("wardrobe", [-1.5, -1.2, 0.0])], &["backsToWalls"]),
    ("the wardrobe opens to the wall", &[("wardrobe", [-1.5, -2.2, 180.0])], &["backsToWalls", "frontsFree"]),
    ("the wardrobe is askew", &[("wardrobe", [-1.5, -1.9, 25.0])], &["squareToWalls", "backsToWalls"]),
    ("the bed stands in mid-room", &[("bed", [0.0, 0.0, 90.0])], &["backsToWalls"]),
    ("the bed is askew", &[("bed", [-1.4, 0.3, 42.0])], &["squareToWalls", "backsToWalls"]),
    ("the bed is pushed into the corner", &[("bed", [-2.0, 1.7, 90.0])], &["bedSidesFree"]),
    ("the head of the bed is under the window", &[("bed", [1.0, 1.5, 180.0])], &["headsAwayFromWindows"]),
    ("a nightstand is away from the wall", &[("nightstand[1]", [-2.5, -0.245, 90.0])], &["backsToWalls"]),
    ("a nightstand opens to the bed", &[("nightstand[1]", [-2.8, -0.245, 0.0])], &["backsToWalls", "frontsFree"]),
    ("the bookshelf covers the window", &[("bookshelf", [1.0, 2.35, 180.0])], &["windowsFree"]),
    ("the bookshelf stands before the door", &[("bookshelf", [2.0, -2.0, 90.0])], &["doorsFree"]),
    ("the plant stands before the door", &[("plant", [2.0, -2.0, 0.0])], &["doorsFree"]),
    ("the plant stands before the wardrobe", &[("plant", [-1.5, -1.6, 0.0])], &["frontsFree"]),
    ("the plant blocks the way to a nightstand", &[("plant", [-1.2, 2.05, 0.0])], &["waysFree"]),
    ("the sofa stands in mid-room", &[("sofa", [0.9, 0.6, 180.0])], &["sofasToWalls"]),
    ("the sofa turns its back to the door", &[("sofa", [0.9, 1.0, 0.0])], &["doorsInView", "screensSeen"]),
    ("the sofa is askew", &[("sofa", [0.9, 1.0, 205.0])], &["seatsAligned"]),
    ("the sofa stands before the television's stand", &[("sofa", [0.5, -1.4, 180.0])], &["frontsFree"]),
    ("the stand of the television is askew", &[("tvStand", [0.5, -2.0, 30.0])], &["squareToWalls"]),
    ("the desk stands in mid-room", &[("desk", [0.3, 0.3, 270.0])], &["desksToWalls"]),
    ("the desk is askew", &[("desk", [2.3, 0.6, 228.0])], &["squareToWalls"]),
    ("the chair is away from the desk", &[("chair", [0.2, 0.0, 90.0])], &["chairsAtTables"]),
    ("the chair looks away from the desk", &[("chair", [1.95, 0.6, 270.0])], &["chairsAtTables"]),
    (
        "the lamps are away from the bed",
        &[("bedLamp[0]", [2.9, 2.2, 0.0]), ("bedLamp[1]", [2.9, 1.9, 0.0])],
        &["lampsAtHand"],
    ),
    ("the rug is askew", &[("rug", [0.9, 0.6, 33.0])], &["squareToWalls"]),
];

/// A folder with the room.
fn folder(scene: &str, layout: &Value) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), scene).unwrap();
    fs::write(folder.path().join("room.layout.json"), layout.to_string()).unwrap();
    folder
}

fn good() -> Value {
    serde_json::from_str(LAYOUT).unwrap()
}

fn report(folder: &Path) -> Value {
    scenelang(folder, ["check", "room.layout.json", "--format", "json"]).reports().remove(0)
}

fn figure(report: &Value) -> f64 {
    report["design"]["figure"].as_f64().unwrap_or_else(|| panic!("{report:#}"))
}

/// The guidelines that do not hold, each with its object.
fn broken(report: &Value) -> Vec<String> {
    let rows = report["constraints"].as_array().unwrap().iter();
    let failing = rows.filter(|row| row["satisfied"] == false && row["guideline"].is_string());
    failing.map(|row| format!("{} {}", row["guideline"].as_str().unwrap(), row["id"].as_str().unwrap())).collect()
}

fn spoil(layout: &mut Value, moves: &[(&str, [f64; 3])]) {
    for (name, [x, z, yaw]) in moves {
        let object = &mut layout["objects"][*name];
        object["pos"][0] = json!(x);
        object["pos"][2] = json!(z);
        object["rot"] = json!([0, yaw, 0]);
    }
}

#[test]
fn a_good_room_keeps_to_all_of_them() {
    let room = folder(ROOM, &good());
    let report = report(room.path());
    assert_eq!(report["ok"], true, "{report:#}");
    assert_eq!((figure(&report), broken(&report)), (1.0, vec![]));
    let said = scenelang(room.path(), ["check", "room.layout.json"]);
    let total = report["design"]["guidelines"]["total"].as_u64().unwrap();
    assert!(total > 30, "{total}");
    assert!(said.stdout.contains(&format!("design 1.00 ({total} of {total} guidelines hold)")), "{}", said.stdout);
}

#[test]
fn the_figure_falls_when_the_room_is_spoiled() {
    let mut wrong = String::new();
    for (what, moves, breaks) in SPOILINGS {
        let mut layout = good();
        spoil(&mut layout, moves);
        let room = folder(ROOM, &layout);
        let report = report(room.path());
        let broken = broken(&report);
        for name in breaks {
            if figure(&report) >= 1.0 || !broken.iter().any(|row| row.starts_with(&format!("{name} "))) {
                wrong += &format!("{what}: {name} holds; broken {broken:?}\n");
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn what_does_not_hold_is_listed_with_its_thing_and_the_reason() {
    let mut layout = good();
    spoil(&mut layout, &[("wardrobe", [-1.5, -1.2, 0.0])]);
    let room = folder(ROOM, &layout);
    let said = scenelang(room.path(), ["check", "room.layout.json"]);
    assert_eq!(said.code, 0, "a guideline makes no layout wrong: {}", said.stdout);
    let line = "  `backsToWalls` does not hold for `wardrobe`: Beds, cupboards and machines have their backs within 6 cm of a wall";
    assert!(said.stdout.contains("Guidelines that do not hold:\n"), "{}", said.stdout);
    assert!(said.stdout.contains(line), "{}", said.stdout);
    let report = report(room.path());
    let row = report["constraints"].as_array().unwrap().iter().find(|row| row["satisfied"] == false).unwrap();
    assert!(row["id"].as_str().unwrap().starts_with("std/guidelines.scene:"), "{row:#}");
    assert!(row["id"].as_str().unwrap().ends_with(":wardrobe"), "{row:#}");
    assert_eq!((&row["kind"], &row["weight"]), (&json!("prefer"), &json!(3.0)));
}

#[test]
fn repair_raises_it_again() {
    let mut wrong = String::new();
    for (what, moves, _) in SPOILINGS {
        let mut layout = good();
        spoil(&mut layout, moves);
        let room = folder(ROOM, &layout);
        let before = figure(&report(room.path()));
        // First what is wrong with the layout, then the guideline that is listed first.
        let _repaired = scenelang(room.path(), ["repair", "room.layout.json", "--force"]);
        if let Some(id) = broken(&report(room.path())).first().and_then(|row| row.split_once(' ')) {
            let _repaired = scenelang(room.path(), ["repair", "room.layout.json", "--force", "--constraint", id.1]);
        }
        let after = report(room.path());
        assert!(figure(&after) >= before, "{what}: {before}, then {} with {:?}", figure(&after), broken(&after));
        if figure(&after) == before {
            wrong += &format!("{what}: {before}, then {} with {:?}\n", figure(&after), broken(&after));
        }
    }
    // Two of them need two things moved at once, which is found or not as chance has it.
    assert!(wrong.lines().count() <= 2, "\n{wrong}");
}

#[test]
fn solving_again_raises_it_where_it_moves_anything() {
    let mut raised = 0;
    for (what, moves, _) in [SPOILINGS[0], SPOILINGS[9], SPOILINGS[11]] {
        let mut layout = good();
        spoil(&mut layout, moves);
        let room = folder(ROOM, &layout);
        let before = figure(&report(room.path()));
        let ended = scenelang(room.path(), ["solve", "room.scene", "--layout", "room.layout.json", "--force"]);
        assert_eq!(ended.code, 0, "{what}: {}{}", ended.stdout, ended.stderr);
        let after = report(room.path());
        assert!(figure(&after) >= before, "{what}: {before}, then {} with {:?}", figure(&after), broken(&after));
        raised += usize::from(figure(&after) > before);
    }
    assert!(raised > 0, "solving again leaves everything as it was");
}

#[test]
fn a_program_weighs_replaces_and_turns_off() {
    let mut layout = good();
    spoil(&mut layout, &[("wardrobe", [-1.5, -1.2, 0.0])]);
    let of = |more: &str| {
        let room = folder(&format!("{ROOM}{more}"), &layout);
        report(room.path())
    };
    let usual = of("");
    let heavier = of("prefer backsToWalls(objects) weight 30;\n");
    assert!(figure(&heavier) < figure(&usual));
    assert_eq!(heavier["design"]["guidelines"], usual["design"]["guidelines"]);
    assert!(broken(&heavier)[0].starts_with("backsToWalls room.scene:"), "{:?}", broken(&heavier));
    let off = of("predicate backsToWalls(Objects s) := true;\n");
    assert!(off["design"]["guidelines"]["total"].as_u64() < usual["design"]["guidelines"]["total"].as_u64());
    assert!(!broken(&off).iter().any(|row| row.starts_with("backsToWalls")), "{:?}", broken(&off));
    let own = of("predicate backsToWalls(Objects s) := forall o in s where .role = \"storage\": o.pos.y < 9;\n");
    assert_eq!(own["diagnostics"], json!([]));
    assert!(!broken(&own).iter().any(|row| row.starts_with("backsToWalls")), "{:?}", broken(&own));
}

#[test]
fn the_library_needs_no_file_and_reads_none() {
    // A file of that name is not looked at: the name is the library's.
    let room = folder(ROOM, &good());
    fs::create_dir(room.path().join("std")).unwrap();
    fs::write(room.path().join("std/guidelines.scene"), "this is no program").unwrap();
    assert_eq!(figure(&report(room.path())), 1.0);
    // Other files of that folder are the user's.
    fs::write(room.path().join("std/own.scene"), "import \"std/guidelines.scene\";\nNumber n;\nn <- 1;\n").unwrap();
    fs::write(room.path().join("room.scene"), ROOM.replace("std/guidelines.scene", "std/own.scene")).unwrap();
    assert_eq!(figure(&report(room.path())), 1.0);
    fs::write(room.path().join("room.scene"), "import \"std/nothing.scene\";\nobject a;\n").unwrap();
    let ended = scenelang(room.path(), ["check", "room.scene"]);
    assert_eq!(ended.code, 2);
    assert!(ended.stdout.contains("cannot import `std/nothing.scene`"), "{}", ended.stdout);
}

#[test]
fn a_room_from_a_sentence_keeps_to_the_guidelines() {
    let folder = tempfile::tempdir().unwrap();
    let ended = scenelang(folder.path(), ["synth", "A bedroom for two.", "-o", "room"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let program = fs::read_to_string(folder.path().join("room/room.scene")).unwrap();
    assert!(program.contains("import \"std/guidelines.scene\";"), "{program}");
    let report = scenelang(folder.path(), ["check", "room/room.layout.json", "--format", "json"]).reports().remove(0);
    assert!(figure(&report) >= 0.9, "{} with {:?}", figure(&report), broken(&report));
}
