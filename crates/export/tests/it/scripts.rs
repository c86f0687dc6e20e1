//! The scripts of a Unity project, compiled as Unity compiles them: those of the scene, then those of the editor on top. Where
//! Unity is not installed its API is that of `tests/unity`. Warnings are errors, and so is what is public and not documented.

use crate::fixture::scene;
use nalgebra::{Rotation3, Unit};
use scenelang_export::Exporter;
use scenelang_export::unity::Unity;
use scenelang_layout::Vec3;
use std::env;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Compiles C# 7 to a library; what the compiler says if it refuses.
fn compile(folder: &Path, name: &str, sources: &[PathBuf], against: &[&str], strict: bool) -> Result<(), String> {
    let mut command = Command::new("mcs");
    command.current_dir(folder).args(["-target:library", "-langversion:7", &format!("-out:{name}.dll")]);
    command.args(against.iter().map(|library| format!("-r:{library}.dll"))).args(sources);
    if strict {
        command.args(["-warn:4", "-warnaserror+", &format!("-doc:{name}.xml")]);
    }
    let out = command.output().map_err(|e| e.to_string())?;
    let said = [out.stdout, out.stderr].concat();
    if out.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&said).into_owned()) }
}

fn has_compiler() -> bool {
    let there = Command::new("mcs").arg("--version").output().is_ok_and(|out| out.status.success());
    if !there {
        assert!(env::var("CI").as_deref() != Ok("true"), "in CI nothing may be skipped: no mcs");
        eprintln!("skipped: scripts not compiled, there is no mcs (Debian: mono-mcs)");
    }
    there
}

/// A folder with Unity's API as two libraries, and the scripts of a project: of the scene, of the editor.
struct Scripts {
    folder: tempfile::TempDir,
    scene: Vec<PathBuf>,
    editor: Vec<PathBuf>,
}

fn scripts() -> Scripts {
    let folder = tempfile::tempdir().unwrap();
    let stubs = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/unity");
    compile(folder.path(), "UnityEngine", &[stubs.join("UnityEngine.cs")], &[], false).unwrap();
    compile(folder.path(), "UnityEditor", &[stubs.join("UnityEditor.cs")], &["UnityEngine"], false).unwrap();
    let (mut scene_scripts, mut editor) = (Vec::new(), Vec::new());
    for file in
        Unity::default().files(&scene()).unwrap().iter().filter(|f| f.path.extension().is_some_and(|e| e == "cs"))
    {
        let path = folder.path().join(file.path.file_name().unwrap());
        fs::write(&path, &file.bytes).unwrap();
        let list = if file.path.starts_with("unity/Assets/Editor") { &mut editor } else { &mut scene_scripts };
        list.push(path);
    }
    Scripts { folder, scene: scene_scripts, editor }
}

#[test]
fn scripts_compile_without_warnings_and_all_that_is_public_is_documented() {
    if !has_compiler() {
        return;
    }
    let Scripts { folder, scene, editor } = scripts();
    assert_eq!((scene.len(), editor.len()), (5, 3));
    compile(folder.path(), "Scene", &scene, &["UnityEngine"], true).unwrap();
    compile(folder.path(), "Editor", &editor, &["UnityEngine", "UnityEditor", "Scene"], true).unwrap();
    let documented = fs::read_to_string(folder.path().join("Scene.xml")).unwrap();
    let api = [
        "Scene.Find(",
        "Scene.FindByCategory(",
        "Scene.FindByRequirement(",
        "Scene.FindConstraints(",
        "Object.Requires(",
        "Scene.ConstraintsOf(",
        "Scene.Distance(",
        "Scene.FreePath(",
        "Scene.Open(",
        "Scene.Close(",
        "Joint.Open(",
        "Joint.Close",
    ];
    for member in api {
        assert!(documented.contains(&format!("M:Scenelang.Scenelang{member}")), "{member}");
    }
}

#[test]
fn the_compiler_finds_what_is_wrong_with_a_script() {
    if !has_compiler() {
        return;
    }
    let Scripts { folder, mut scene, .. } = scripts();
    let wrong = folder.path().join("Wrong.cs");
    scene.push(wrong.clone());
    for (text, code) in [
        ("class A { int x = \"1\"; }", "CS0029"),
        ("class A { void M() { int unused; } }", "CS0168"),
        ("public class A { }", "CS1591"),
        ("class A { UnityEditor.EditorWindow x; }", "CS0246"),
    ] {
        fs::write(&wrong, text).unwrap();
        let said = compile(folder.path(), "Scene", &scene, &["UnityEngine"], true).unwrap_err();
        assert!(said.contains(code), "{code}: {said}");
    }
}

#[test]
fn the_example_in_the_book_compiles() {
    if !has_compiler() {
        return;
    }
    let Scripts { folder, mut scene, .. } = scripts();
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../spec/src/for/unity.md");
    let text = fs::read_to_string(page).unwrap();
    let example = text.split("```csharp\n").nth(1).unwrap().split("```").next().unwrap();
    let using = "using Scenelang; using UnityEngine; using UnityEngine.AI;";
    let own = folder.path().join("Example.cs");
    fs::write(&own, format!("{using} class Example : MonoBehaviour {{ void Start() {{ {example} }} }}")).unwrap();
    scene.push(own);
    compile(folder.path(), "Scene", &scene, &["UnityEngine"], true).unwrap();
}

/// What is opened: motion, axis, pivot, range, and a point of the part.
type Part = (u8, [f64; 3], [f64; 3], [f64; 2], [f64; 3]);

const PARTS: [Part; 4] = [
    (0, [0.0, -1.0, 0.0], [-0.39, 0.65, 0.23], [0.0, 110.0], [0.3, 0.6, 0.25]),
    (0, [0.0, 1.0, 0.0], [0.4, 0.1, 0.2], [-90.0, 175.0], [-0.3, 0.5, 0.2]),
    (0, [0.0, 0.6, 0.8], [0.1, 0.2, 0.3], [0.0, 200.0], [0.5, -0.5, 0.1]),
    (1, [0.0, 0.0, 1.0], [0.0, 0.1, 0.2], [0.0, 0.3], [0.1, 0.1, 0.26]),
];

#[test]
fn what_a_script_opens_is_where_the_layout_says() {
    if !has_compiler() {
        return;
    }
    let Scripts { folder, scene, .. } = scripts();
    compile(folder.path(), "Scene", &scene, &["UnityEngine"], true).unwrap();
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/unity/Opens.cs");
    let mut compiler = Command::new("mcs");
    compiler.current_dir(folder.path()).args(["-r:UnityEngine.dll", "-r:Scene.dll", "-out:Opens.exe"]).arg(program);
    assert!(compiler.status().unwrap().success());
    let mut asked = String::new();
    let mut wanted = Vec::new();
    for (motion, axis, pivot, range, point) in PARTS {
        for fraction in [0.0, 0.25, 1.0] {
            let numbers = [&[f64::from(motion)][..], &axis, &pivot, &range, &point, &[fraction]].concat();
            let words: Vec<String> = numbers.iter().map(f64::to_string).collect();
            asked += &format!("{}\n", words.join(" "));
            let opening = fraction * range[1];
            let [axis, pivot, point] = [axis, pivot, point].map(Vec3::from);
            let at = if motion == 1 {
                point + axis * opening
            } else {
                let turn = Rotation3::from_axis_angle(&Unit::new_normalize(axis), opening.to_radians());
                pivot + turn * (point - pivot)
            };
            wanted.push([opening, at.x, at.y, at.z]);
        }
    }
    let mut run = Command::new("mono");
    run.current_dir(folder.path()).arg("Opens.exe").stdin(Stdio::piped()).stdout(Stdio::piped());
    let mut run = run.spawn().unwrap();
    run.stdin.take().unwrap().write_all(asked.as_bytes()).unwrap();
    let said = String::from_utf8(run.wait_with_output().unwrap().stdout).unwrap();
    assert_eq!(said.lines().count(), wanted.len());
    for (line, want) in said.lines().zip(&wanted) {
        let found: Vec<f64> = line.split(' ').map(|word| word.parse().unwrap()).collect();
        assert!((found[0] - want[0]).abs() < 1e-3, "{line}: {want:?}");
        assert!((1..4).all(|i| (found[i] - want[i]).abs() < 1e-5), "{line}: {want:?}");
    }
}

#[test]
fn layers_have_the_same_numbers_in_scripts_and_in_the_project() {
    let files = Unity::default().files(&scene()).unwrap();
    let text = |end: &str| {
        let file = files.iter().find(|f| f.path.ends_with(end)).unwrap();
        String::from_utf8(file.bytes.clone()).unwrap()
    };
    let settings = text("ProjectSettings/TagManager.asset");
    let layers = settings.split("  layers:\n").nth(1).unwrap().split("  m_SortingLayers").next().unwrap();
    let layers: Vec<&str> = layers.lines().map(|line| line.trim_start_matches("  -").trim()).collect();
    assert_eq!(layers.len(), 32);
    let script = text("ScenelangNavMesh.cs");
    let mut named = 0;
    for (number, name) in layers.iter().enumerate().skip(8).filter(|(_, name)| !name.is_empty()) {
        assert!(script.contains(&format!("public const int {name} = {number};")), "{name}");
        named += 1;
    }
    assert_eq!(named, script.matches("public const int ").count());
}
