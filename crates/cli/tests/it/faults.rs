//! A solved layout, spoiled: whatever stands freely and is sunk, lifted or tilted is reported, every object of every
//! example. (That what is reported as sound does stand is what a physics engine says, in `checkers.rs`.)

use crate::support::{folder_with, for_each_example, read_json, scenelang};
use scenelang_base::FileId;
use scenelang_lang::{Options, Program, compile_file};
use scenelang_verify::check::{Subject, check};
use scenelang_verify::report::model::RowKind;
use serde_json::Value;

/// What is done to an object: the member that changes, which of its numbers, and by how much (metres, degrees).
const FAULTS: [(&str, &str, usize, f64); 5] = [
    ("sunk", "pos", 1, -0.05),
    ("lifted", "pos", 1, 0.3),
    ("tilted", "rot", 0, 10.0),
    ("tilted-back", "rot", 0, -10.0),
    ("tilted-aside", "rot", 2, 10.0),
];

/// Objects that stand by themselves: not hung, set in a wall, floating by permission or put into others.
fn free(program: &Program) -> Vec<String> {
    let allow = &program.allow;
    let mounted = allow.mounts.iter().map(|m| m.object);
    let doors = allow.doors.iter().map(|d| d.object);
    let contents = allow.contents.iter().map(|c| c.0);
    let held: Vec<_> = mounted.chain(doors).chain(contents).chain(allow.float.iter().copied()).collect();
    let free = program.objects.iter().enumerate().filter(|(i, _)| !held.iter().any(|h| h.0 as usize == *i));
    free.map(|(_, object)| object.name.to_string()).collect()
}

/// Whether a physical rule that the object breaks is reported.
fn is_blamed(program: &Program, layout: &Value, object: &str) -> bool {
    let read = scenelang_layout::file::read(&layout.to_string(), FileId(0));
    assert_eq!(read.diagnostics, []);
    let verdict = check(program, &read.layout, &scenelang_verify::Options::default());
    verdict.rows.iter().any(|row| {
        let rule = matches!(row.kind, RowKind::Collision | RowKind::Bounds | RowKind::Support);
        assert!(rule && !matches!(row.subject, Subject::Statement(_)));
        row.satisfied == Some(false) && row.objects.iter().any(|o| program.objects[o.0 as usize].name == object)
    })
}

mod are_reported {
    use super::*;

    fn all(name: &str) {
        let (folder, scene) = folder_with(name);
        let ended = scenelang(folder.path(), ["solve", &scene.display().to_string()]);
        assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
        let layout = read_json(&scene.with_extension("layout.json"));
        let mut program = compile_file(name, &scene, Options::default()).program.unwrap();
        // The rules alone: what the statements say of it is another matter, and walks take their time.
        program.constraints.clear();
        program.pins.clear();
        let (mut faults, mut missed) = (0, Vec::new());
        for object in free(&program) {
            for (fault, member, axis, by) in FAULTS {
                let mut spoiled = layout.clone();
                let x = &mut spoiled["objects"][&object][member][axis];
                *x = (x.as_f64().unwrap() + by).into();
                faults += 1;
                if !is_blamed(&program, &spoiled, &object) {
                    missed.push(format!("{object} {fault}"));
                } else if faults == 1 {
                    let file = folder.path().join("spoiled.layout.json");
                    std::fs::write(&file, spoiled.to_string()).unwrap();
                    let ended = scenelang(folder.path(), ["check", &file.display().to_string()]);
                    assert!(ended.code == 1 && ended.stdout.contains(&object), "{ended:?}");
                }
            }
        }
        println!("{name}: {faults} faults");
        assert!(faults >= 50 && missed.is_empty(), "of {faults} faults are not reported: {missed:?}");
    }
    for_each_example!(all);
}
