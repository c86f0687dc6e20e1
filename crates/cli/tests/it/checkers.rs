//! What `synth` writes, judged by programs that are not ours: Khronos' glTF validator, a Unity parser, a physics engine,
//! Pixar's USD library, a browser. The scripts that call them are in `tests/oracles/`.

use crate::support::{browser, folder_with, for_each_example, has_node_package, python, root, run, scenelang, skip};
use scenelang_base::FileId;
use scenelang_lang::program::ObjectId;
use scenelang_lang::{Options, Program, compile_file};
use scenelang_layout::{Layout, file};
use scenelang_verify::{World, opening};
use serde_json::json;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Makes all files of an example; the folder they are in.
fn synth(folder: &Path, scene: &Path) -> PathBuf {
    let out = folder.join("out");
    let (scene, to) = (scene.display().to_string(), out.display().to_string());
    let ended = scenelang(folder, ["synth", &scene, "-o", &to, "--all-formats"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    out
}

/// Another layout of an example; its path.
fn solved(folder: &Path, scene: &Path, seed: &str) -> PathBuf {
    let layout = folder.join(format!("{seed}.layout.json"));
    let (scene, to) = (scene.display().to_string(), layout.display().to_string());
    let ended = scenelang(folder, ["solve", &scene, "--seed", seed, "-o", &to]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    layout
}

pub(crate) fn oracle(name: &str) -> PathBuf {
    root().join("tests/oracles").join(name)
}

/// Runs a checker; what it found, if it found something.
pub(crate) fn judge(what: &str, command: &mut Command) -> Option<String> {
    let ended = run(command, b"");
    println!("{what}: {}", ended.stdout.trim());
    (ended.code != 0).then(|| format!("{what} (exit {}):\n{}{}", ended.code, ended.stdout, ended.stderr))
}

/// What a physics engine has to know of a program: what is held, and what may overlap.
pub(crate) fn facts(program: &Program) -> serde_json::Value {
    let allow = &program.allow;
    let name = |id: &ObjectId| program.objects[id.0 as usize].name.as_str();
    let mounted = allow.mounts.iter().map(|m| &m.object);
    let doors = allow.doors.iter().map(|d| &d.object);
    let held: Vec<_> = mounted.chain(doors).chain(&allow.float).map(name).collect();
    let overlap: Vec<_> =
        allow.collide.iter().chain(allow.contents.iter().copied()).map(|(a, b)| [name(&a), name(&b)]).collect();
    json!({ "held": held, "overlap": overlap })
}

/// How far each door, drawer and lid of a layout is claimed to open, and what is not in its way.
fn openings(program: &Program, layout: &Layout) -> serde_json::Value {
    let options = scenelang_verify::Options::default();
    let world = World::<f64>::new(program, layout, &options);
    let mut found = Vec::new();
    for (i, object) in program.objects.iter().enumerate() {
        let id = ObjectId(i as u32);
        let others = (0..program.objects.len()).filter(|other| *other != i);
        let aside = others.filter(|other| opening::gives_way(&world, id, ObjectId(*other as u32)));
        let ignored: Vec<&str> = aside.map(|other| program.objects[other].name.as_str()).collect();
        for (part, joint) in layout.object(&object.name).map_or(&[][..], |it| &it.joints).iter().enumerate() {
            let (free, _) = opening::free(&world, id, part, joint.limits[1], &mut { opening::LOOKS }).unwrap();
            found.push(json!({ "object": object.name.as_str(), "joint": joint.name.as_str(), "free": free, "ignored": ignored }));
        }
    }
    found.into()
}

/// The files for simulators, each loaded by a reader that is not ours, and the bounds of all things in all formats.
fn simulators(out: &Path, name: &str, python: &Path, program: &Program) -> Vec<String> {
    let at = |file: String| out.join(file);
    let world = std::fs::read_dir(out.join("sdf")).unwrap().map(|e| e.unwrap().path()).find(|p| p.is_file()).unwrap();
    let layout = at(format!("{name}.layout.json"));
    let placed = file::read(&std::fs::read_to_string(&layout).unwrap(), FileId(0)).layout;
    let claims = out.join("claims.json");
    std::fs::write(&claims, openings(program, &placed).to_string()).unwrap();
    let (usd, usdz) = (at(format!("{name}.usda")), at(format!("{name}.usdz")));
    let (mjcf, told) = (at(format!("{name}.mjcf.xml")), at(format!("{name}.mjcf.json")));
    let call = |script: &str| {
        let mut command = Command::new(python);
        command.arg(oracle(script));
        command
    };
    [
        judge("MuJoCo", call("mjcf.py").args([&mjcf, &told])),
        judge("joints, driven", call("driven.py").args([&mjcf, &layout, &claims])),
        judge("USD", call("usd.py").args([usd, usdz])),
        judge("SDF", call("sdf.py").arg(&world)),
        judge("bounds", call("bounds.py").args([&layout, out])),
    ]
    .into_iter()
    .flatten()
    .chain(joints(out, name, python, &placed, &world))
    .collect()
}

/// The joints in every format that has them, against the layout. A GLB file has them on demand; a URDF file is one object, so
/// there is one for each kind of thing that opens.
fn joints(out: &Path, name: &str, python: &Path, placed: &Layout, sdf: &Path) -> Vec<String> {
    let layout = out.join(format!("{name}.layout.json"));
    let export = |to: &str, more: &[&str]| {
        let layout = layout.display().to_string();
        let ended = scenelang(out, ["export", &layout, "-o", to].iter().chain(more));
        assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
        out.join(to)
    };
    let rigid = export("rigid", &["--only", "glb", "--gltf-physics"]).join(format!("{name}.glb"));
    let open = placed.objects.iter().filter(|(_, placement)| !placement.joints.is_empty());
    let kinds: BTreeMap<&str, &str> = open.map(|(name, _)| (name.split('[').next().unwrap_or(name), &**name)).collect();
    let mut robots = Vec::new();
    for (i, object) in kinds.values().enumerate() {
        let folder = export(&format!("robot{i}"), &["--object", object]).join("urdf");
        let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        robots.extend(files.filter(|file| file.extension().is_some_and(|end| end == "urdf")));
    }
    let mut command = Command::new(python);
    command.arg(oracle("joints.py")).arg(&layout);
    command.args(["usda", "usdz", "mjcf.xml"].map(|end| out.join(format!("{name}.{end}"))));
    command.arg(sdf).args([rigid, out.join("unity")]).args(&robots);
    let mut found: Vec<String> = judge("joints in all formats", &mut command).into_iter().collect();
    for robot in &robots {
        if Command::new("check_urdf").arg("--help").output().is_err() {
            skip("URDF not read by check_urdf: it is not installed");
            break;
        }
        found.extend(judge("check_urdf", Command::new("check_urdf").arg(robot)));
    }
    found
}

/// The GLB file, validated.
fn validated(out: &Path, name: &str) -> Option<String> {
    if !has_node_package("gltf-validator") {
        skip("GLB not validated: no gltf-validator (Node and tests/oracles/node_modules)");
        return None;
    }
    let glb = out.join(format!("{name}.glb"));
    judge("glTF validator", Command::new("node").arg(oracle("gltf.mjs")).arg(glb))
}

/// Requests in plain words, from the sentence to all formats. `SCENELANG_REQUESTS=100` tries as many as the figures in the
/// book are about.
#[test]
fn rooms_from_sentences_hold_in_all_formats() {
    const USUAL: usize = 2;
    let wanted = std::env::var("SCENELANG_REQUESTS").ok().and_then(|n| n.parse().ok()).unwrap_or(USUAL);
    let Some(python) = python() else { return skip("rooms from sentences not judged: no .venv") };
    let all = std::fs::read_to_string(root().join("tests/requests/rooms.txt")).unwrap();
    let all: Vec<&str> = all.lines().collect();
    let mut wrong = Vec::new();
    for request in all.iter().step_by((all.len() / wanted).max(1)).take(wanted) {
        let folder = tempfile::tempdir().unwrap();
        let ended = scenelang(folder.path(), ["synth", request, "-o", "out", "--all-formats"]);
        let out = folder.path().join("out");
        assert_eq!(ended.code, 0, "{request}: {}{}", ended.stdout, ended.stderr);
        let program = compile_file("room", &out.join("room.scene"), Options::default()).program.expect("it was solved");
        let unity = judge("Unity project", Command::new(&python).arg(oracle("unity.py")).arg(out.join("unity")));
        let found = validated(&out, "room").into_iter().chain(unity).chain(simulators(&out, "room", &python, &program));
        wrong.extend(found.map(|found| format!("{request}: {found}")));
    }
    assert!(wrong.is_empty(), "{} of {wanted}:\n{}", wrong.len(), wrong.join("\n"));
}

mod agree_on_every_example {
    use super::*;

    fn hold(name: &str) {
        let (folder, scene) = folder_with(name);
        let out = synth(folder.path(), &scene);
        let mut found = Vec::new();

        found.extend(validated(&out, name));
        if let Some(python) = python() {
            let project = out.join("unity");
            found.extend(judge("Unity project", Command::new(&python).arg(oracle("unity.py")).arg(project)));

            let program = compile_file(name, &scene, Options::default()).program.expect("it was solved");
            let facts_file = folder.path().join("facts.json");
            std::fs::write(&facts_file, facts(&program).to_string()).unwrap();
            let mut layouts = vec![out.join(format!("{name}.layout.json"))];
            layouts.extend(["1", "2"].map(|seed| solved(folder.path(), &scene, seed)));
            let mut physics = Command::new(&python);
            physics.arg(oracle("physics.py"));
            for layout in layouts {
                physics.arg(layout).arg(&facts_file);
            }
            found.extend(judge("physics", &mut physics));
            found.extend(simulators(&out, name, &python, &program));
        } else {
            skip("Unity project, physics and files for simulators not checked: no .venv");
        }
        match browser() {
            Some(browser) if root().join("viewer/dist/viewer.js").exists() => {
                let command = &mut Command::new("node");
                command.env("CHROMIUM", browser).env("PREVIEW", out.join("preview.html"));
                let test = root().join("viewer/test/browser.test.mjs");
                // What a press does and what a page without WebGL shows does not depend on the example: one is enough.
                if name != "bedroom" {
                    command.arg("--test-name-pattern=^the room is shown");
                }
                found.extend(judge("browser", command.arg("--test").arg(test)));
            }
            _ => skip("preview.html not opened: no browser, or no viewer/dist (Node)"),
        }
        assert!(found.is_empty(), "{}", found.join("\n"));
    }
    for_each_example!(hold);
}

/// Names that must be escaped, or that formats keep for themselves, and words that look like the end of something.
const STRANGE: &str = r#"
region raum; raum.pos <- vec3(0, 0, 0); raum.scale <- vec3(4, 2.6, 4);
object 灯; object world; object sun; object base; object ŝeĝo[2];
灯.category <- "lamp \"/><&]]> ../\\ 灯 -->";
world.category <- "</World> </mujoco>"; world.color <- "\"red\" & ../";
sun.category <- "chair'; rm"; sun.material <- "<oak>";
ŝeĝo.category <- "chair";
灯.dimensions <- vec3(0.3, 0.4, 0.3);
world.dimensions <- vec3(0.5, 0.5, 0.5);
base.dimensions <- vec3(0.3, 0.1, 0.3);
assert on(灯, world);
assert forall c in ŝeĝo: gap(c, world) >= 0.1;
"#;

#[test]
fn names_that_are_hard_to_write_break_no_format() {
    let folder = tempfile::tempdir().unwrap();
    let name = "a \"b\" & 'c' <é>";
    let scene = folder.path().join(format!("{name}.scene"));
    std::fs::write(&scene, STRANGE).unwrap();
    let out = synth(folder.path(), &scene);
    match python() {
        Some(python) => {
            let program = compile_file(name, &scene, Options::default()).program.expect("it was solved");
            let found = simulators(&out, name, &python, &program);
            assert!(found.is_empty(), "{}", found.join("\n"));
        }
        None => skip("files for simulators not checked: no .venv"),
    }
}
