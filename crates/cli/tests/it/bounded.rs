//! Programs of hostile sizes: a verdict, or a message that a limit was met, in bounded memory. A process that takes too
//! long is ended by `support`; that twice as much takes no more than a few times as much memory is measured.

use crate::support::{Ended, binary, run};
use std::fs;
use std::path::Path;
use std::process::Command;

/// A program that has one thing very often.
struct Case {
    name: &'static str,
    /// How often.
    n: usize,
    text: fn(usize) -> String,
    command: &'static [&'static str],
    /// The exit code, and what is said.
    ends: (i32, &'static str),
}

const ROOM: &str = "region room;\nroom.pos <- vec3(0, 0, 0);\nroom.scale <- vec3(400, 3, 400);\n";

fn objects(n: usize) -> String {
    format!("{ROOM}object a[{n}];\na.dimensions <- vec3(1, 1, 1);\nassert forall x in a: inside(x, room);\n")
}

fn chain(first: &str, n: usize) -> String {
    let links = (1..n).map(|i| format!("Number v{i};\nv{i} <- v{} + 1;\n", i - 1)).collect::<String>();
    format!("object o;\nNumber v0;\nv0 <- {first};\n{links}assert o.pos.x >= v{};\n", n - 1)
}

const CASES: [Case; 15] = [
    Case {
        name: "all of many may collide",
        n: 20_000,
        text: |n| format!("object a[{n}];\nallowCollide(objects, objects);\n"),
        command: &["check"],
        ends: (0, "1 warning"),
    },
    Case {
        name: "many sets of many may collide",
        n: 300,
        text: |n| {
            let sets = (0..n).map(|i| format!("allowCollide(a, b); allowCollide(c[{i}], a);\n")).collect::<String>();
            format!("object a[5000];\nobject b[5000];\nobject c[{n}];\n{sets}")
        },
        command: &["check"],
        ends: (0, "warning"),
    },
    Case {
        name: "many objects that are allowed to collide are stated",
        n: 20_000,
        text: |n| format!("object a[{n}];\nallowCollide(objects, objects);\n"),
        command: &["constraints", "--format", "json"],
        ends: (0, "allowCollide"),
    },
    Case { name: "many objects", n: 6_000, text: objects, command: &["check"], ends: (0, "W0403") },
    Case {
        name: "many objects to place",
        n: 6_000,
        text: objects,
        command: &["solve", "--time", "1"],
        ends: (2, "6000 objects are too many to solve"),
    },
    Case { name: "a chain of constants", n: 20_000, text: |n| chain("1", n), command: &["check"], ends: (0, "") },
    Case { name: "a chain of values", n: 20_000, text: |n| chain("o.pos.y", n), command: &["check"], ends: (0, "") },
    Case {
        name: "a chain that doubles",
        n: 60,
        text: |n| {
            let links = (1..n).map(|i| format!("Number v{i};\nv{i} <- v{0} + v{0};\n", i - 1)).collect::<String>();
            format!("object o;\nNumber v0;\nv0 <- o.pos.y;\n{links}assert o.pos.x >= v{};\n", n - 1)
        },
        command: &["check"],
        ends: (0, ""),
    },
    Case {
        name: "deeply nested",
        n: 100_000,
        text: |n| format!("object a; assert {}a.pos.x > 1{};\n", "(".repeat(n), ")".repeat(n)),
        command: &["check"],
        ends: (2, "E0004"),
    },
    Case {
        name: "unknown names",
        n: 50_000,
        text: |n| {
            let uses = (0..n).map(|i| format!("assert chiar{i}.pos.x > 1;\n")).collect::<String>();
            format!("object chair;\n{uses}")
        },
        command: &["check"],
        ends: (2, "`chiar0` is not declared"),
    },
    Case {
        name: "unknown names among many known ones",
        n: 5_000,
        text: |n| {
            let known = (0..n).map(|i| format!("object chair{i};\n")).collect::<String>();
            let uses = (0..n).map(|i| format!("assert chiar{i}.pos.x > 1;\n")).collect::<String>();
            known + &uses
        },
        command: &["check"],
        ends: (2, "`chiar0` is not declared"),
    },
    Case {
        name: "a set of pairs",
        n: 3_000,
        text: |n| format!("object a[{n}];\nassert count(x in a: exists y in a: x != y and distance(x, y) < 1) >= 1;\n"),
        command: &["check"],
        ends: (2, "E0005"),
    },
    Case {
        name: "statements about pairs",
        n: 3_000,
        text: |n| format!("object a[{n}];\nassert forall x in a: forall y in a: x != y implies gap(x, y) > 0;\n"),
        command: &["check"],
        ends: (2, "E0005"),
    },
    Case {
        name: "pairs of hundreds",
        n: 750,
        text: |n| format!("object a[{n}];\nassert forall x in a: forall y in a: x != y implies gap(x, y) > 0;\n"),
        command: &["check"],
        ends: (0, "W0403"),
    },
    Case {
        name: "time for a check",
        n: 1_400,
        text: objects,
        command: &["check", "--time", "0.001"],
        ends: (2, "the time limit was reached"),
    },
];

/// Runs a command on a program, with no more address space than this machine can spare, where that can be said.
fn judged(folder: &Path, command: &[&str], file: &str) -> Ended {
    let exe = env!("CARGO_BIN_EXE_scenelang");
    let mut limited = if cfg!(target_os = "linux") {
        let mut shell = Command::new("sh");
        shell.args(["-c", "ulimit -v 2500000; exec \"$0\" \"$@\"", exe]);
        shell
    } else {
        Command::new(exe)
    };
    run(limited.args(command).arg(file).current_dir(folder), b"")
}

#[test]
fn hostile_sizes_end_with_a_verdict_or_a_message() {
    let folder = tempfile::tempdir().unwrap();
    let mut wrong = Vec::new();
    for Case { name, n, text, command, ends } in CASES {
        fs::write(folder.path().join("room.scene"), text(n)).unwrap();
        let ended = judged(folder.path(), command, "room.scene");
        let said = format!("{}{}", ended.stdout, ended.stderr);
        if ended.code != ends.0 || !said.contains(ends.1) {
            wrong.push(format!("{name}: {} {}", ended.code, said.chars().take(600).collect::<String>()));
        }
        assert!(said.len() < 8_000_000, "{name}: nobody reads {} bytes", said.len());
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn many_imports_end_with_a_verdict() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: String, imports: &[String], object: &str| {
        let imports: String = imports.iter().map(|to| format!("import \"{to}.scene\";\n")).collect();
        fs::write(folder.path().join(name + ".scene"), format!("{imports}object {object};\n")).unwrap();
    };
    let n = 1_000;
    for i in 0..n {
        let next = |of: &str| if i + 1 < n { vec![format!("{of}{}", i + 1)] } else { Vec::new() };
        write(format!("chain{i}"), &next("chain"), &format!("o{i}"));
        for side in ["left", "right"] {
            let both: Vec<String> = ["left", "right"].iter().flat_map(|side| next(side)).collect();
            write(format!("{side}{i}"), &both, &format!("{side}{i}"));
        }
    }
    for file in ["chain0.scene", "left0.scene"] {
        let ended = judged(folder.path(), &["check"], file);
        assert_eq!(ended.code, 0, "{file}: {}{}", ended.stdout, ended.stderr);
    }
}

/// A search that may take a second, with more to do than that: there is a layout, or a message, and no hang.
#[test]
fn a_time_limit_is_kept_by_commands_that_search() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("room.scene"), objects(600)).unwrap();
    let request = "a hall with 300 chairs, 100 tables and 80 lamps, every chair near a table and far from every lamp";
    for (args, codes) in [
        (&["solve", "room.scene", "--time", "1"][..], &[0, 1, 2][..]),
        (&["repair", "room.layout.json", "--time", "1"], &[0, 1, 2]),
        (&["check", "room.layout.json", "--time", "30"], &[0, 1, 2]),
        (&["formalize", request, "--time", "1", "-o", "asked.scene"], &[0, 2]),
    ] {
        let mut command = binary();
        let ended = run(command.args(args).current_dir(folder.path()), b"");
        assert!(codes.contains(&ended.code), "{args:?}: {ended:?}");
    }
}

/// The layout of as many cubes of a metre as there are places.
fn cubes(places: impl Iterator<Item = [f64; 3]>) -> String {
    let objects: Vec<String> = places
        .enumerate()
        .map(|(i, pos)| format!("\"a[{i}]\": {{ \"pos\": {pos:?}, \"scale\": [1, 1, 1] }}"))
        .collect();
    format!(
        "{{ \"format\": \"scenelang.layout/1\", \"scene\": \"room.scene\", \"objects\": {{ {} }} }}",
        objects.join(",")
    )
}

/// Layouts in which all is in one place, or above each other: a verdict on what was judged, how much was not, and rows that
/// somebody can read.
#[test]
fn layouts_in_one_place_end_with_a_verdict() {
    let folder = tempfile::tempdir().unwrap();
    let said = |places: Vec<[f64; 3]>, args: &[&str]| {
        fs::write(folder.path().join("room.scene"), format!("object a[{}];\n", places.len())).unwrap();
        fs::write(folder.path().join("room.layout.json"), cubes(places.into_iter())).unwrap();
        let ended = judged(folder.path(), args, "room.layout.json");
        assert!(ended.stdout.len() < 8_000_000, "nobody reads {} bytes", ended.stdout.len());
        ended
    };
    let many = |n: usize, at: fn(f64) -> [f64; 3]| (0..n).map(|i| at(i as f64)).collect::<Vec<_>>();
    let [one, above]: [fn(f64) -> [f64; 3]; 2] = [|i| [i * 1e-6, 0.0, 0.0], |i| [0.0, i * 1.5, 0.0]];
    let all = said(many(20_000, one), &["check", "--format", "json"]);
    let report = all.reports().remove(0);
    assert_eq!(all.code, 2, "{}", all.stderr);
    assert_eq!(report["summary"]["physical"]["total"], 199_990_000 + 20_000);
    let [finding] = report["diagnostics"].as_array().unwrap().as_slice() else { panic!("{report}") };
    assert_eq!(finding["code"], "E0005");
    let message = finding["message"].as_str().unwrap();
    assert!(message.contains(" of 199990000 pairs were not checked"), "{message}");
    // Those that overlap most are listed, the others are counted.
    assert_eq!(report["constraints"].as_array().unwrap().len(), 1_000);
    assert_eq!(report["unlisted"]["failing"], 2_000_000 - 1_000);
    let tower = said(many(20_000, above), &["check"]);
    assert_eq!(tower.code, 2, "{}", tower.stdout);
    assert!(tower.stdout.contains("were not checked") || tower.stdout.contains("was not checked"), "{}", tower.stdout);
    for command in
        [&["repair"][..], &["check", "--all"], &["trace", "room.scene", "--layout"], &["diff", "room.layout.json"]]
    {
        assert_eq!(said(many(20_000, one), command).code, 2, "{command:?}");
    }

    // So many can be judged: what is not listed is counted, in each format.
    let [failing, rest] = [60 * 59 / 2, 60 * 59 / 2 - 1_000];
    let more = format!("{rest} more physical rules fail");
    for (format, wanted) in [
        ("human", format!("… and {} more that fail; `--format json` lists the first 1000", failing - 50)),
        ("compact", more.clone()),
        ("json", format!("\"unlisted\":{{\"failing\":{rest},\"holding\":0}}")),
        ("sarif", more.clone()),
        ("junit", more.clone()),
        ("github", more),
    ] {
        let option = if format == "compact" { "--verbosity" } else { "--format" };
        let ended = said(many(60, one), &["check", option, format]);
        assert_eq!(ended.code, 1, "{format}: {}", ended.stderr);
        assert!(
            ended.stdout.contains(&wanted),
            "{format}: {wanted}: {}",
            ended.stdout.chars().rev().take(600).collect::<String>()
        );
    }
}

/// A requirement, an object and a statement of each, very often.
#[test]
fn many_requirements_are_traced() {
    let folder = tempfile::tempdir().unwrap();
    let n = 20_000;
    let one = |i: usize| format!("@req(\"chair {i}\")\nobject c{i};\n@req(\"place {i}\")\nassert c{i}.pos.x >= 0;\n");
    fs::write(folder.path().join("room.scene"), (0..n).map(one).collect::<String>()).unwrap();
    for by in ["requirement", "object"] {
        let ended = judged(folder.path(), &["trace", "--by", by], "room.scene");
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        assert!(ended.stdout.contains("40000 requirements"), "{}", ended.stdout.lines().last().unwrap_or_default());
    }
    let text = format!("object a[{n}];\n@req(\"all\")\nassert forall x in a: x.pos.x >= 0;\n");
    fs::write(folder.path().join("room.scene"), text).unwrap();
    let ended = judged(folder.path(), &["trace"], "room.scene");
    assert!(ended.code == 0 && ended.stdout.contains("[a]\n"), "{}", ended.stdout);
}
