//! A solved layout, spoiled: whatever stands freely and is sunk, lifted or tilted is reported, every object of every
//! example. (That what is reported as sound does stand is what a physics engine says, in `checkers.rs`.)

use crate::support::{folder_with, for_each_example, read_json, scenelang};
use scenelang_lang::{Options, Program, compile_file};
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
fn is_blamed(report: &Value, object: &str) -> bool {
    let rows = report["constraints"].as_array().unwrap();
    rows.iter().any(|row| {
        let names = row["objects"].as_array().unwrap();
        row["satisfied"] == false && row["rule"].is_string() && names.iter().any(|n| n == object)
    })
}

mod are_reported {
    use super::*;

    fn all(name: &str) {
        let (folder, scene) = folder_with(name);
        let ended = scenelang(folder.path(), ["solve", &scene.display().to_string()]);
        assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
        let layout = read_json(&scene.with_extension("layout.json"));
        let program = compile_file(name, &scene, Options::default()).program.unwrap();
        let mut spoiled: Vec<(String, String)> = Vec::new();
        for object in free(&program) {
            for (fault, member, axis, by) in FAULTS {
                let mut layout = layout.clone();
                let x = &mut layout["objects"][&object][member][axis];
                *x = (x.as_f64().unwrap() + by).into();
                let file = format!("{}-{fault}.layout.json", spoiled.len());
                std::fs::write(folder.path().join(&file), layout.to_string()).unwrap();
                spoiled.push((file, format!("{object} {fault}")));
            }
        }
        assert!(spoiled.len() > 20, "only {} faults", spoiled.len());
        let files = spoiled.iter().map(|(file, _)| file.as_str());
        let ended = scenelang(folder.path(), ["check", "--format", "json"].into_iter().chain(files));
        assert_eq!(ended.code, 1, "{}", ended.stderr);
        let reports = ended.reports();
        assert_eq!(reports.len(), spoiled.len());
        let missed: Vec<&str> = spoiled
            .iter()
            .zip(&reports)
            .filter(|((_, what), report)| !is_blamed(report, what.split(' ').next().unwrap()))
            .map(|((_, what), _)| what.as_str())
            .collect();
        println!("{name}: {} faults", spoiled.len());
        assert!(missed.is_empty(), "not reported: {missed:?}");
    }
    for_each_example!(all);
}
