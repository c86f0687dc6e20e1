//! What the command line says to somebody who uses it for the first time: each command with its exit code, and a part of what
//! it says.

use crate::support::{Ended, scenelang};
use std::fs;

const PROGRAM: &str = "region room;\nobject bed;\nassert inside(bed, room);\n";

/// Commands, one after the other, in a folder with `study.scene` and the same program as `foo.txt`.
const SAID: &[(&[&str], u8, &str)] = &[
    (&["new", "bar.txt"], 2, "ends in `.scene`, unlike bar.txt; try `scenelang new bar.scene`"),
    (&["new", "my room.scene"], 0, "`scenelang synth \"my room.scene\"` furnishes it"),
    (&["new", "my room.scene"], 2, "use --force, or name another file"),
    (&["new", "my room.scene", "--force"], 0, "my room.scene written"),
    (&["synth", "foo.txt", "-o", "out"], 2, "foo.txt: this is a program, not a request in words"),
    (&["synth", "a room", "-o", "study.scene"], 2, "-o takes a folder, but study.scene is a file"),
    (&["formalize", "nofile.txt"], 2, "nofile.txt looks like the name of a file, but there is none"),
    (&["formalize", "study.scene"], 2, "study.scene is a program already"),
    (&["formalize", "-f", "foo.txt"], 2, "foo.txt is a program already"),
    (&["check", "study"], 2, "did you mean study.scene?"),
    (&["check", "study.scn"], 2, "did you mean study.scene?"),
    (&["check", "--fxi", "study.scene"], 2, "a similar argument exists: '--fix'"),
    (&["solve", "study.scene", "--time", "-1"], 2, "expected a number of seconds greater than 0"),
    (&["solve", "study.scene", "--seed", "abc"], 2, "expected a whole number from 0 to"),
    (&["explain", "E9999"], 2, "there is no code E9999"),
    (&["explain", "E0401", "E0402"], 0, "E0402: a statement that can never hold"),
    (&["explain", "bed"], 2, "`bed` is a category: `scenelang categories bed`"),
    (&["explain", "margin"], 0, "by how much it holds"),
    (&["explain", "<-"], 0, "assigns a value"),
    (&["explain", "E0201"], 0, "// E0201\n"),
    (&["check", "unnamed.layout.json"], 2, "the layout names no program, so unnamed.scene is expected"),
    (&["check", "rotated.layout.json"], 0, "`rotation` in `bed` is not read; did you mean `rot`?"),
    (&["check", "sized.layout.json"], 1, "set the `scale` of `bed` in the layout to [1.6, 0.5, 2]"),
    (&["check", "long.layout.json"], 1, "the layout seems to be in centimetres; lengths in a layout are in metres"),
    (&["check", "rooms.scene"], 0, "`living` and `kitchen` overlap by 2 m"),
    (&["check", "lamp.scene"], 1, "usual sizes are assumed (width × height × depth): `lamp` 0.4 × 1.55 × 0.4 m"),
    (&["check", "window.scene"], 1, "a door or window belongs in a wall: add `assert connects(window, room);`"),
];

#[test]
fn commands_say_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let layout = |rest: &str| format!("{{ \"format\": \"scenelang.layout/1\", {rest} }}");
    let room = "\"regions\": { \"room\": { \"pos\": [0, 0, 0], \"scale\": [4, 2.5, 4] } }";
    let bed = |more: &str| {
        format!("\"objects\": {{ \"bed\": {{ \"pos\": [0, 0, 0], \"scale\": [1.5, 0.5, 2]{more} }} }}, {room}")
    };
    for (name, text) in [
        ("study.scene", PROGRAM.to_owned()),
        ("foo.txt", PROGRAM.to_owned()),
        ("unnamed.layout.json", layout(&bed(""))),
        ("rotated.layout.json", layout(&format!("\"scene\": \"study.scene\", {}", bed(", \"rotation\": [0, 90, 0]")))),
        ("sized.scene", format!("{PROGRAM}bed.dimensions <- vec3(1.6, 0.5, 2);\n")),
        ("sized.layout.json", layout(&bed(""))),
        (
            "long.layout.json",
            layout(&bed("").replace("[1.5, 0.5, 2]", "[160, 50, 200]"))
                .replace("{ \"format", "{ \"scene\": \"sized.scene\", \"format"),
        ),
        ("rooms.scene", ROOMS.to_owned()),
        ("lamp.scene", LAMP.to_owned()),
        ("window.scene", WINDOW.to_owned()),
    ] {
        fs::write(folder.path().join(name), text).unwrap();
    }
    for (args, code, said) in SAID {
        let Ended { code: ended, stdout, stderr, .. } = scenelang(folder.path(), *args);
        let all = stdout + &stderr;
        assert!(ended == i32::from(*code) && all.contains(said), "{args:?}: {ended}\n{all}");
    }
}

const ROOMS: &str = "region living;
living.pos <- vec3(0, 0, 0);
living.scale <- vec3(4, 2.5, 4);
region kitchen;
kitchen.pos <- vec3(2, 0, 0);
kitchen.scale <- vec3(4, 2.5, 4);
region zone;
zone.pos <- vec3(-1, 0, 0);
zone.scale <- vec3(1, 2.5, 1);
";

const LAMP: &str = "region room;
room.scale <- vec3(3, 2.5, 3);
object lamp;
lamp.category <- \"lamp\";
object shelf;
shelf.category <- \"shelf\";
assert on(lamp, shelf);
";

const WINDOW: &str = "region room;
room.pos <- vec3(0, 0, 0);
room.scale <- vec3(4, 2.5, 4);
object window;
window.category <- \"window\";
window.pos <- vec3(0, 1, 2);
";
