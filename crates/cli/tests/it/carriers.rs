//! GLB files and Unity projects that we wrote are judged by what they carry; others are refused.

use crate::support::{folder_with, scenelang};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The rows of the one report on a path.
fn rows(folder: &Path, path: &str) -> (i32, Value) {
    let ended = scenelang(folder, ["check", path, "--format", "json", "--all"]);
    let report = ended.reports().remove(0);
    assert_eq!(report["file"], path);
    (ended.code, report)
}

fn ids(report: &Value) -> Vec<(String, Value, Value)> {
    let rows = report["constraints"].as_array().unwrap().iter();
    rows.map(|r| (r["id"].as_str().unwrap().to_owned(), r["satisfied"].clone(), r["margin"].clone())).collect()
}

/// A program with imports, from below and from above.
fn with_imports() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [
        // Makes one workspace of both folders.
        ("scenelang.toml", ""),
        ("above.scene", "predicate closeTo(Object a, Object b) := distance(a, b) <= rand(1, 2);\n"),
        ("rooms/lib/words.scene", "import \"../../above.scene\";\npredicate isLow(Object a) := a.top < 1;\n"),
        (
            "rooms/study.scene",
            "import \"lib/words.scene\";\nregion study;\nstudy.scale <- vec3(4, 2.5, 4);\nobject desk;\ndesk.category <- \"desk\";\n\
             object chair;\nchair.category <- \"chair\";\nassert closeTo(chair, desk);\nassert isLow(desk);\n",
        ),
    ] {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

#[test]
fn what_synth_wrote_is_judged_like_its_layout() {
    let (folder, _) = folder_with("bedroom");
    assert_eq!(scenelang(folder.path(), ["synth", "bedroom.scene", "-o", "out"]).code, 0);
    let (code, layout) = rows(folder.path(), "out/bedroom.layout.json");
    assert_eq!(code, 0);
    for carrier in ["out/bedroom.glb", "out/unity"] {
        let (code, report) = rows(folder.path(), carrier);
        assert_eq!((code, ids(&report)), (0, ids(&layout)), "{carrier}");
        let same = scenelang(folder.path(), ["diff", "out/bedroom.layout.json", carrier]);
        assert_eq!(same.code, 0, "{carrier}: {}{}", same.stdout, same.stderr);
    }
}

#[test]
fn a_carrier_stands_on_its_own_with_its_imports() {
    let made = with_imports();
    let ended = scenelang(&made.path().join("rooms"), ["synth", "study.scene", "-o", "../out"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    // Elsewhere, without the program.
    let folder = tempfile::tempdir().unwrap();
    fs::copy(made.path().join("out/study.glb"), folder.path().join("moved.glb")).unwrap();
    fs::rename(made.path().join("out/unity"), folder.path().join("project")).unwrap();
    for carrier in ["moved.glb", "project"] {
        let (code, report) = rows(folder.path(), carrier);
        assert_eq!(code, 0, "{report:#}");
        assert_eq!(report["summary"]["assertions"]["total"], 2);
    }
}

#[test]
fn what_an_edited_layout_breaks_is_shown() {
    let (folder, _) = folder_with("bedroom");
    assert_eq!(scenelang(folder.path(), ["synth", "bedroom.scene", "-o", "out"]).code, 0);
    let layout = folder.path().join("out/unity/Assets/Scenelang/layout.json");
    let text = fs::read_to_string(&layout).unwrap();
    let mut document: Value = serde_json::from_str(&text).unwrap();
    document["objects"]["bed"]["pos"][1] = 1.0.into();
    fs::write(&layout, document.to_string()).unwrap();
    let ended = scenelang(folder.path(), ["check", "out/unity"]);
    assert_eq!(ended.code, 1);
    assert!(ended.stdout.contains("`bed`"), "{}", ended.stdout);
}

/// Changes the document of a GLB file.
pub fn edit_glb(path: &Path, change: impl FnOnce(&mut Value)) {
    let bytes = fs::read(path).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let mut document: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    change(&mut document);
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let size = (json.len() as u32).to_le_bytes();
    fs::write(path, [&bytes[..12], &size, b"JSON", &json, &bytes[20 + length..]].concat()).unwrap();
}

#[test]
fn what_comes_back_is_what_was_made() {
    let (folder, _) = folder_with("bedroom");
    assert_eq!(scenelang(folder.path(), ["synth", "bedroom.scene", "-o", "out"]).code, 0);
    let made = |file: &str| fs::read_to_string(folder.path().join(file)).unwrap();
    for (carrier, back) in [("out/bedroom.glb", "a"), ("out/unity", "b")] {
        let ended = scenelang(folder.path(), ["import", carrier, "-o", back]);
        assert_eq!((ended.code, ended.stderr.as_str()), (0, ""), "{carrier}");
        for file in ["bedroom.scene", "bedroom.layout.json"] {
            assert_eq!(made(&format!("{back}/{file}")), made(&format!("out/{file}")), "{carrier}: {file}");
        }
        let again = scenelang(folder.path(), ["check", &format!("{back}/bedroom.layout.json")]);
        assert_eq!(again.code, 0, "{}", again.stdout);
    }
}

#[test]
fn a_program_comes_back_with_its_imports() {
    let made = with_imports();
    let ended = scenelang(&made.path().join("rooms"), ["synth", "study.scene", "-o", "../out"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let ended = scenelang(made.path(), ["import", "out/study.glb", "-o", "back"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    // One of them stood above the program, which is in a folder of its own therefore.
    for file in ["above.scene", "scene/lib/words.scene", "scene/study.scene", "scene/study.layout.json"] {
        assert!(made.path().join("back").join(file).is_file(), "{file}: {}", ended.stdout);
    }
    assert_eq!(scenelang(made.path(), ["check", "back/scene/study.layout.json"]).code, 0);
}

#[test]
fn a_scene_is_judged_as_it_stands_now() {
    let (folder, _) = folder_with("bedroom");
    assert_eq!(scenelang(folder.path(), ["synth", "bedroom.scene", "-o", "out"]).code, 0);
    edit_glb(&folder.path().join("out/bedroom.glb"), |document| {
        let bed = document["nodes"].as_array_mut().unwrap().iter_mut().find(|node| node["name"] == "bed").unwrap();
        bed["translation"][1] = 1.0.into();
    });
    let (code, report) = rows(folder.path(), "out/bedroom.glb");
    assert_eq!(code, 1);
    assert_eq!(report["diagnostics"][0]["code"], "W0504");
    assert_eq!(report["diagnostics"][0]["message"], "`bed` was moved by +1.000 m along y");
    // It is taken over, and nothing is changed but the bed.
    assert_eq!(scenelang(folder.path(), ["import", "out/bedroom.glb", "-o", "back"]).code, 0);
    let ended =
        scenelang(folder.path(), ["diff", "out/bedroom.layout.json", "back/bedroom.layout.json", "--format", "json"]);
    let found: Value = serde_json::from_str(&ended.stdout).unwrap();
    assert_eq!(ended.code, 1);
    assert!(found.to_string().contains("bed"), "{found:#}");
    // What was moved there is somebody's work, so the file is not replaced.
    let again = scenelang(folder.path(), ["synth", "bedroom.scene", "-o", "out"]);
    assert_eq!(again.code, 2, "{}", again.stdout);
    assert!(again.stderr.contains("bedroom.glb has been edited since scenelang wrote it"), "{}", again.stderr);
}

#[test]
fn no_file_is_written_outside_of_the_folder_or_that_is_no_program() {
    let made = with_imports();
    let ended = scenelang(&made.path().join("rooms"), ["synth", "study.scene", "-o", "../out"]);
    assert_eq!(ended.code, 0, "{}{}", ended.stdout, ended.stderr);
    let glb = made.path().join("out/study.glb");
    let kept = fs::read(&glb).unwrap();
    let outside = made.path().join("outside.scene");
    for (import, written) in [
        (".git/hooks/post-checkout", false),
        ("settings.json", false),
        (outside.to_str().unwrap(), false),
        // What leads above the folder of the program makes that a folder below.
        ("../../../../outside.scene", true),
    ] {
        fs::write(&glb, &kept).unwrap();
        edit_glb(&glb, |document| {
            document["scenes"][0]["extras"]["scenelang"]["imports"][import] = "object evil;".into()
        });
        let ended = scenelang(made.path(), ["import", "out/study.glb", "-o", "back", "--force"]);
        assert_eq!(ended.code, if written { 0 } else { 2 }, "{import}: {}{}", ended.stdout, ended.stderr);
        assert_eq!(made.path().join("back").exists(), written, "{import}");
        assert!(!outside.exists(), "{import}");
    }
}

#[test]
fn what_is_not_ours_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let glb = |json: &str| {
        let mut json = json.as_bytes().to_vec();
        json.resize(json.len().next_multiple_of(4), b' ');
        let length = |n: usize| u32::try_from(n).unwrap().to_le_bytes();
        [b"glTF", &length(2)[..], &length(20 + json.len()), &length(json.len()), b"JSON", &json].concat()
    };
    let ours = |layout: &str, spec: &str| {
        let own = serde_json::json!({ "scenes": [{ "extras": { "scenelang": { "spec": spec, "layout": layout } } }] });
        glb(&own.to_string())
    };
    for (name, bytes) in [
        ("empty.glb", Vec::new()),
        ("text.glb", b"solid cube".to_vec()),
        ("short.glb", b"glTF\x02\0\0\0\xff\0\0\0\xff\xff\xff\xffJSON{".to_vec()),
        ("other.glb", glb(r#"{ "asset": { "version": "2.0" }, "scenes": [{ "nodes": [] }] }"#)),
        ("no-json.glb", glb("{")),
        ("far.glb", glb(r#"{ "scene": 99999999999, "scenes": [] }"#)),
        ("half.glb", glb(r#"{ "scenes": [{ "extras": { "scenelang": { "spec": "object a;" } } }] }"#)),
        ("spoilt.glb", ours("{", "object a;")),
        ("no-scene.glb", ours(r#"{ "format": "scenelang.layout/1" }"#, "object a;")),
        ("bad-program.glb", ours(r#"{ "format": "scenelang.layout/1", "scene": "x.scene" }"#, "object")),
        ("project/Assets/thing.txt", Vec::new()),
        ("project/ProjectSettings/ProjectVersion.txt", Vec::new()),
    ] {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, bytes).unwrap();
    }
    for (path, wanted) in [
        ("empty.glb", "E0008"),
        ("text.glb", "E0008"),
        ("short.glb", "E0008"),
        ("other.glb", "E0008"),
        ("no-json.glb", "E0008"),
        ("far.glb", "E0008"),
        ("half.glb", "E0008"),
        ("nowhere.glb", "E0001"),
        ("project", "E0008"),
        ("spoilt.glb", "E0501"),
        ("no-scene.glb", "E0507"),
        ("bad-program.glb", "E0510"),
    ] {
        let (code, report) = rows(folder.path(), path);
        assert_eq!((code, &report["diagnostics"][0]["code"]), (2, &wanted.into()), "{path}: {report:#}");
    }
    let ended = scenelang(folder.path(), ["check", "other.glb"]);
    insta::assert_snapshot!(ended.stdout, @r##"
    [E0008] Error: other.glb is a GLB file without an embedded program and layout
      `scenelang synth` embeds the program and the layout in the files it writes; other programs may remove them
    other.glb: 1 error
    "##);
}
