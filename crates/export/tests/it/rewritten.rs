//! Scenes that libraries of others have written again: a YAML library and unityparser for Unity projects, trimesh for GLB
//! files, USD's own library. What nobody moved comes back as it was; what was moved, and nothing else, is told.

use crate::back::{layout, said};
use crate::fixture::{parts, python_with, written};
use scenelang_base::door::Door;
use scenelang_export::Exporter;
use scenelang_export::embedded::{self, Carrier};
use scenelang_export::glb::Glb;
use scenelang_export::unity::Unity;
use scenelang_export::usd::Usd;
use std::path::{Path, PathBuf};
use std::process::Command;

/// By how much things are moved, along the axes of a layout (metres).
const BY: [f64; 3] = [0.25, 0.0, -0.5];

struct Library {
    name: &'static str,
    /// What it needs.
    module: &'static str,
    carrier: Carrier,
    /// The file that it reads, and the one that it writes.
    files: [&'static str; 2],
    /// Objects that it can move.
    moves: &'static [&'static str],
}

const UNITY: [&str; 2] = ["unity", "again"];
const USD: [&str; 2] = ["room.usda", "again.usda"];
const BOTH: &[&str] = &["table", "chair[1]"];
const LIBRARIES: [Library; 5] = [
    Library { name: "pyyaml", module: "yaml", carrier: Carrier::Unity, files: UNITY, moves: BOTH },
    // It knows nothing of instances.
    Library { name: "unityparser", module: "unityparser", carrier: Carrier::Unity, files: UNITY, moves: &["table"] },
    Library {
        name: "trimesh",
        module: "trimesh",
        carrier: Carrier::Glb,
        files: ["room.glb", "again.glb"],
        moves: BOTH,
    },
    Library { name: "usd", module: "pxr", carrier: Carrier::Usd, files: USD, moves: BOTH },
    Library { name: "usd-over", module: "pxr", carrier: Carrier::Usd, files: USD, moves: BOTH },
];

fn write(python: &Path, library: &Library, folder: &Path, moved: Option<&str>) -> PathBuf {
    let [source, out] = library.files.map(|name| folder.join(name));
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/oracles/rewrite.py");
    let mut command = Command::new(python);
    command.arg(script).arg(library.name).args([&source, &out]);
    if let Some(name) = moved {
        let [x, y, z] = BY;
        let x = if library.carrier == Carrier::Unity { x } else { -x };
        command.arg(name).args([x, y, z].map(|far| far.to_string()));
    }
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}: {}", library.name, String::from_utf8_lossy(&output.stderr));
    out
}

fn check(library: &Library) {
    let Some(python) = python_with(library.module) else { return };
    let before = parts().layout;
    for moved in std::iter::once(None).chain(library.moves.iter().map(Some)) {
        let exporter: &dyn Exporter = match library.carrier {
            Carrier::Glb => &Glb,
            Carrier::Usd => &Usd,
            Carrier::Unity => &Unity::default(),
        };
        let (folder, text) = written(&before, &[exporter]);
        let out = write(&python, library, folder.path(), moved.copied());
        let found = embedded::read("it", &out, library.carrier, &Door::within(folder.path())).unwrap();
        let Some(name) = moved else {
            assert_eq!((said(&found), &found.layout), (Vec::new(), &text), "{}", library.name);
            continue;
        };
        let expected = format!("`{name}` was moved by +0.250 m along x, -0.500 m along z");
        assert_eq!(said(&found), [expected], "{}", library.name);
        for ((object, now), (_, was)) in layout(&found.layout).objects.iter().zip(&before.objects) {
            let by = now.pos - was.pos;
            let far = if object == name { BY } else { [0.0; 3] };
            assert!((0..3).all(|k| (by[k] - far[k]).abs() < 1e-5), "{}: {object} by {by}", library.name);
        }
    }
}

#[test]
fn a_yaml_library_writes_a_unity_project_again() {
    check(&LIBRARIES[0]);
}

#[test]
fn unityparser_writes_a_unity_project_again() {
    check(&LIBRARIES[1]);
}

#[test]
fn trimesh_writes_a_glb_file_again() {
    check(&LIBRARIES[2]);
}

#[test]
fn usd_core_writes_a_layer_again_or_one_above_it() {
    check(&LIBRARIES[3]);
    check(&LIBRARIES[4]);
}
