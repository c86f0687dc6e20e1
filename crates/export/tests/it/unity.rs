//! The Unity project, read line by line.

use crate::fixture::{named, scene};
use scenelang_export::unity::{Editor, Pipeline, Unity};
use scenelang_export::{Exporter, Scene};
use std::collections::{BTreeMap, BTreeSet};

fn project(scene: &Scene, pipeline: Pipeline) -> BTreeMap<String, String> {
    written(scene, Unity { pipeline, ..Unity::default() })
}

fn written(scene: &Scene, unity: Unity) -> BTreeMap<String, String> {
    let files = unity.files(scene).unwrap();
    let count = files.len();
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    let out: BTreeMap<String, String> =
        files.into_iter().map(|f| (f.path.to_str().unwrap().to_owned(), text(&f.bytes))).collect();
    assert_eq!(out.len(), count, "no file is written twice");
    out
}

fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    text.lines().find_map(|l| l.trim_start().strip_prefix(key)?.strip_prefix(": "))
}

/// The documents of a file: class, anchor, text.
fn documents(text: &str) -> Vec<(u32, i64, &str)> {
    text.split("--- !u!")
        .skip(1)
        .map(|d| {
            let (head, body) = d.split_once('\n').unwrap();
            let (class, anchor) = head.split_once(" &").unwrap();
            (class.parse().unwrap(), anchor.trim_end_matches(" stripped").parse().unwrap(), body)
        })
        .collect()
}

const SCENE: &str = "unity/Assets/Scenes/room.unity";

/// The prefab of the chairs: its name and its text.
fn chair(files: &BTreeMap<String, String>) -> (&str, &str) {
    let prefabs: Vec<(&str, &str)> = files
        .iter()
        .filter_map(|(path, text)| {
            Some((path.strip_prefix("unity/Assets/Scenelang/Prefabs/")?.strip_suffix(".prefab")?, &**text))
        })
        .collect();
    let [chair] = prefabs[..] else { panic!("{:?}", prefabs.iter().map(|(name, _)| name).collect::<Vec<_>>()) };
    chair
}

#[test]
fn every_asset_and_folder_has_a_meta_file_with_its_own_guid() {
    let files = project(&scene(), Pipeline::BuiltIn);
    let mut expected = BTreeSet::new();
    for path in files.keys().filter(|p| p.starts_with("unity/Assets/") && !p.ends_with(".meta")) {
        let path = path.strip_prefix("unity/").unwrap();
        expected.insert(path.to_owned());
        expected.extend(path.match_indices('/').skip(1).map(|(i, _)| path[..i].to_owned()));
    }
    expected.insert("Assets/Scenes".into());
    let found: BTreeSet<String> =
        files.keys().filter_map(|p| p.strip_prefix("unity/")?.strip_suffix(".meta")).map(str::to_owned).collect();
    assert_eq!(found, expected);
    let guids: BTreeSet<&str> =
        files.iter().filter(|(p, _)| p.ends_with(".meta")).map(|(_, t)| value(t, "guid").unwrap()).collect();
    assert_eq!(guids.len(), found.len());
    assert!(guids.iter().all(|g| g.len() == 32));
}

#[test]
fn all_references_lead_somewhere() {
    let files = project(&scene(), Pipeline::BuiltIn);
    let guids: BTreeSet<&str> =
        files.iter().filter(|(p, _)| p.ends_with(".meta")).filter_map(|(_, t)| value(t, "guid")).collect();
    for (path, text) in files.iter().filter(|(p, _)| [".unity", ".prefab", ".mat"].iter().any(|end| p.ends_with(end))) {
        let anchors: BTreeSet<i64> = documents(text).iter().map(|d| d.1).collect();
        assert_eq!(anchors.len(), documents(text).len(), "{path}: an anchor is used twice");
        // Long references are broken after a comma.
        let flat = text.replace(",\n", ",").split_whitespace().collect::<Vec<_>>().join(" ");
        for reference in flat.split("{fileID: ").skip(1) {
            let body = reference.split('}').next().unwrap();
            let id: i64 = body.split(',').next().unwrap().parse().unwrap();
            match body.split("guid: ").nth(1).map(|g| &g[..32]) {
                None => assert!(id == 0 || anchors.contains(&id), "{path}: {body}"),
                Some(guid) => assert!(guid.starts_with("0000000000000000") || guids.contains(guid), "{path}: {body}"),
            }
        }
    }
}

#[test]
fn the_scene_has_the_components_it_needs() {
    let files = project(&scene(), Pipeline::BuiltIn);
    let mut classes = BTreeMap::new();
    for (class, _, _) in documents(&files[SCENE]) {
        *classes.entry(class).or_insert(0) += 1;
    }
    let count = |class: u32| classes.get(&class).copied().unwrap_or(0);
    assert_eq!(count(1001), 2, "the chairs are instances");
    assert_eq!(count(1) + 2, count(4), "a transform each, and one for each instance");
    assert_eq!(count(114), 6 + 2, "a script on each object, two on the root");
    assert_eq!(count(54), 4, "doors and windows have no rigid body");
    assert_eq!(count(108), 3, "sun and two lamps");
    assert_eq!([count(20), count(29), count(104), count(157), count(196), count(1_660_057_539)], [1; 6]);
    assert_eq!(
        count(23),
        6 + 2 * (2 + 2 * 4) + 1,
        "objects; floor, ceiling, four walls with skirting for each room; a tint"
    );
    assert_eq!(count(23), count(33));
    let text = &files[SCENE];
    assert!(documents(text).last().unwrap().0 == 1_660_057_539, "the list of roots comes last");
    assert!(text.contains("  id: table\n") && text.contains("  declaration: \"object table;\"\n"));
    assert_eq!(text.matches("m_IsKinematic: 1").count(), 2);
    // The crate: one upright box on itself, one turned box on a child, a cylinder as a convex mesh.
    assert!(text.contains("m_Name: part1\n"));
    assert!(files.contains_key("unity/Assets/Scenelang/Meshes/Objects/crate.hull2.obj"));
    assert_eq!(
        text.matches("m_Convex: 1").count() + chair(&files).1.matches("m_Convex: 1").count(),
        files.keys().filter(|p| p.contains(".hull") && p.ends_with(".obj")).count()
    );
}

#[test]
fn equal_objects_are_instances_of_one_prefab() {
    let scene = scene();
    let files = project(&scene, Pipeline::BuiltIn);
    let (name, prefab) = chair(&files);
    assert_eq!(value(&files[&format!("unity/Assets/Scenelang/Prefabs/{name}.prefab.meta")], "PrefabImporter"), None);
    let guid = value(&files[&format!("unity/Assets/Scenelang/Prefabs/{name}.prefab.meta")], "guid").unwrap();
    assert!(name.starts_with("chair-") && prefab.contains(&format!("  m_Name: {name}\n")));
    // It says nothing of a single chair.
    for line in
        ["  id: \n", "  category: \n", "  declaration: \n", "  constraints: []\n", "  boundsMin: {x: 0, y: 0, z: 0}\n"]
    {
        assert!(prefab.contains(line), "{line}");
    }
    assert!(!prefab.contains("chair["));
    let roots = documents(prefab).into_iter().filter(|d| d.0 == 4 && d.2.contains("m_Father: {fileID: 0}"));
    let [(_, root, _)] = roots.collect::<Vec<_>>()[..] else { panic!("one root") };
    let text = &files[SCENE];
    let objects = documents(text).into_iter().find(|d| d.0 == 1 && d.2.contains("m_Name: Objects\n")).unwrap().1;
    let group = documents(text)
        .into_iter()
        .find(|d| d.0 == 4 && d.2.contains(&format!("m_GameObject: {{fileID: {objects}}}")))
        .unwrap();
    for (i, constraints) in [0, 1].into_iter().zip(["1", "1"]) {
        let told = |path: &str, value: &str| {
            format!("      propertyPath: {path}\n      value: {value}\n      objectReference: {{fileID: 0}}\n")
        };
        let instance =
            documents(text).into_iter().find(|d| d.0 == 1001 && d.2.contains(&told("id", &format!("\"chair[{i}]\""))));
        let (_, own, instance) = instance.unwrap();
        let object = scene.objects.iter().find(|object| object.name == format!("chair[{i}]")).unwrap();
        for (path, value) in [
            ("m_Name", format!("\"chair[{i}]\"")),
            ("category", "chair".into()),
            ("declaration", "\"object chair[2];\"".into()),
            ("constraints.Array.size", constraints.into()),
            ("m_LocalPosition.x", (object.place.pos.x as f32).to_string()),
            ("m_LocalEulerAnglesHint.y", (object.place.rot.y as f32).to_string()),
        ] {
            assert!(instance.contains(&told(path, &value)), "{path}: {instance}");
        }
        assert!(instance.contains("      propertyPath: \"constraints.Array.data[0]\"\n"), "{instance}");
        assert!(!instance.contains("m_LocalScale") && !instance.contains("m_Mass"), "{instance}");
        assert!(instance.contains(&format!("m_TransformParent: {{fileID: {}}}", group.1)));
        assert!(instance.contains(&format!("m_SourcePrefab: {{fileID: 100100000, guid: {guid}")));
        let stands = documents(text)
            .into_iter()
            .find(|d| d.2.contains(&format!("m_PrefabInstance: {{fileID: {own}}}")))
            .unwrap();
        assert!(text.contains(&format!("--- !u!4 &{} stripped\n", stands.1)));
        assert!(stands.2.contains(&format!("m_CorrespondingSourceObject: {{fileID: {root}, guid: {guid}")));
        assert!(group.2.contains(&format!("  - {{fileID: {}}}\n", stands.1)));
    }
    let meshes = files.keys().filter(|path| path.contains("/Objects/chair") && path.ends_with(".obj")).count();
    let hulls = scene.objects[1].solid.iter().filter(|part| part.as_box().is_none()).count();
    assert_eq!(meshes, 1 + hulls, "the mesh of both");
}

#[test]
fn what_is_said_of_an_instance_leaves_its_prefab_as_it_is() {
    let one = scene();
    let mut other = scene();
    let chairs = |scene: &Scene| -> Vec<usize> {
        (0..scene.objects.len()).filter(|&i| scene.objects[i].name.starts_with("chair")).collect()
    };
    for i in chairs(&other) {
        let object = &mut other.objects[i];
        object.place.pos.x += 0.5;
        object.rows.clear();
        object.requirements.push("a seat".into());
    }
    let (one, other) = (project(&one, Pipeline::BuiltIn), project(&other, Pipeline::BuiltIn));
    assert_eq!(chair(&one), chair(&other));
    assert!(
        one[SCENE] != other[SCENE]
            && other[SCENE].contains("      propertyPath: \"requirements.Array.data[0]\"\n      value: a seat\n")
    );
    // A single chair is like no other: it stands in the scene.
    let mut single = scene();
    let last = chairs(&single)[1];
    single.objects[last].place.scale.y += 0.01;
    let files = project(&single, Pipeline::BuiltIn);
    assert!(!files.keys().any(|path| path.contains("Prefabs")) && !files[SCENE].contains("!u!1001 "));
    assert!(files.contains_key("unity/Assets/Scenelang/Meshes/Objects/chair_1.obj"));
}

#[test]
fn meshes_come_mirrored_with_one_submesh_for_each_material() {
    let scene = scene();
    let files = project(&scene, Pipeline::BuiltIn);
    for object in &scene.objects {
        let asset = if object.name.starts_with("chair") { chair(&files).0 } else { &object.stem };
        let text = &files[&format!("unity/Assets/Scenelang/Meshes/Objects/{asset}.obj")];
        assert!(!text.lines().any(|l| l.starts_with("g ") || l.starts_with("o ")));
        assert_eq!(text.lines().filter(|l| l.starts_with("usemtl ")).count(), object.mesh.len());
        let vertices: Vec<Vec<f32>> = text
            .lines()
            .filter_map(|l| l.strip_prefix("v "))
            .map(|l| l.split(' ').map(|n| n.parse().unwrap()).collect())
            .collect();
        let originals = object.mesh.iter().flat_map(|g| &g.positions);
        for (v, p) in vertices.iter().zip(originals) {
            assert_eq!([-v[0], v[1], v[2]], *p, "{}", object.name);
        }
        // In the file's right-handed frame triangles run counterclockwise seen from outside.
        let volume: f32 = text
            .lines()
            .filter_map(|l| l.strip_prefix("f "))
            .map(|l| {
                let [a, b, c] = [0, 1, 2].map(|i| {
                    let index: usize = l.split(' ').nth(i).unwrap().split('/').next().unwrap().parse().unwrap();
                    &vertices[index - 1]
                });
                a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                    + a[2] * (b[0] * c[1] - b[1] * c[0])
            })
            .sum();
        assert!(volume > 0.0, "{}: {volume}", object.name);
    }
}

#[test]
fn materials_follow_the_pipeline_and_keep_both_sets_of_names() {
    let scene = scene();
    for (pipeline, shader) in [(Pipeline::BuiltIn, "fileID: 46,"), (Pipeline::Urp, "fileID: 4800000,")] {
        let files = project(&scene, pipeline);
        let materials: Vec<&String> = files.iter().filter(|(p, _)| p.ends_with(".mat")).map(|(_, t)| t).collect();
        assert_eq!(materials.len(), scene.surfaces.len());
        for text in materials {
            assert!(text.contains(shader) && text.contains("    - _Color: {") && text.contains("    - _BaseColor: {"));
        }
        assert_eq!(files["unity/Packages/manifest.json"].contains("universal"), pipeline == Pipeline::Urp);
    }
}

#[test]
fn program_layout_and_report_travel_with_the_project() {
    let scene = scene();
    let files = project(&scene, Pipeline::BuiltIn);
    assert_eq!(files["unity/Assets/Scenelang/spec.scene.txt"], scene.program[0].1);
    assert_eq!(files["unity/Assets/Scenelang/layout.json"], scene.layout_text);
    let report: serde_json::Value = serde_json::from_str(&files["unity/Assets/Scenelang/report.json"]).unwrap();
    assert_eq!(report, scene.report);
}

#[test]
fn names_of_any_script_become_safe_files_and_escaped_texts() {
    let scene = named("größe灯").build().unwrap();
    let files = project(&scene, Pipeline::BuiltIn);
    assert!(files.contains_key("unity/Assets/Scenelang/Meshes/Objects/gr_e_.obj"));
    assert!(files["unity/Assets/Scenes/room.unity"].contains("m_Name: \"gr\\xF6\\xDFe\\u706F\"\n"));
    assert!(files.keys().all(|p| p.is_ascii()));
}

#[test]
fn floors_walls_openings_and_furniture_have_layers_and_tags_that_the_project_names() {
    let files = project(&scene(), Pipeline::BuiltIn);
    let mut found: BTreeMap<String, (String, String)> = BTreeMap::new();
    let mut tags = BTreeSet::new();
    let (name, prefab) = chair(&files);
    for (_, _, text) in documents(&files[SCENE]).iter().chain(&documents(prefab)).filter(|d| d.0 == 1) {
        let of = |key: &str| value(text, key).unwrap().trim_matches('"').to_owned();
        tags.insert(of("m_TagString"));
        found.insert(of("m_Name"), (of("m_Layer"), of("m_TagString")));
    }
    let wanted = [
        ("hall floor", "8", "Floor"),
        ("hall wall0", "9", "Wall"),
        ("hall ceiling", "10", "Ceiling"),
        ("door", "11", "Opening"),
        ("window", "11", "Opening"),
        ("table", "12", "Furniture"),
        (name, "12", "Furniture"),
        // A collider of the crate is on the layer of the crate.
        ("part1", "12", "Untagged"),
        ("Main Camera", "0", "MainCamera"),
    ];
    for (name, layer, tag) in wanted {
        assert_eq!(found.get(name), Some(&(layer.to_owned(), tag.to_owned())), "{name}: {:?}", found.keys());
    }
    let settings = &files["unity/ProjectSettings/TagManager.asset"];
    for tag in tags.iter().filter(|tag| !["Untagged", "MainCamera"].contains(&tag.as_str())) {
        assert!(settings.contains(&format!("  - {tag}\n")), "{tag}");
    }
}

#[test]
fn the_scene_carries_the_rows_of_the_report() {
    let mut scene = scene();
    scene.overlaps = vec![[0, 1]];
    let files = project(&scene, Pipeline::BuiltIn);
    let told: serde_json::Value = serde_json::from_str(&files["unity/Assets/Scenelang/constraints.json"]).unwrap();
    let rows = told["constraints"].as_array().unwrap();
    let verdicts: Vec<i64> = rows.iter().map(|row| row["verdict"].as_i64().unwrap()).collect();
    assert_eq!(verdicts, [1, 2, 2]);
    assert_eq!((&rows[1]["margin"], &rows[1]["unit"]), (&(-0.999).into(), &"m".into()));
    assert_eq!(rows[0]["objects"], serde_json::json!(["chair[1]", "table"]));
    assert_eq!(rows[2]["kind"], "prefer");
    assert_eq!(told["overlaps"], serde_json::json!([{ "a": "table", "b": "chair[0]" }]));
    // The reader leaves a field of another name or kind as it is, and says nothing.
    let script = &files["unity/Assets/Scenelang/Scripts/ScenelangConstraint.cs"];
    for (field, kind) in [
        ("id", "string"),
        ("kind", "string"),
        ("text", "string"),
        ("message", "string"),
        ("verdict", "ScenelangVerdict"),
        ("margin", "float"),
        ("unit", "string"),
        ("requirements", "string[]"),
        ("objects", "string[]"),
    ] {
        assert!(script.contains(&format!("public {kind} {field};")), "{field}");
        assert!(rows.iter().all(|row| !row[field].is_null()), "{field}");
    }
    let guid = value(&files["unity/Assets/Scenelang/constraints.json.meta"], "guid").unwrap();
    assert!(
        files["unity/Assets/Scenes/room.unity"]
            .replace(",\n   ", ",")
            .contains(&format!("rows: {{fileID: 4900000, guid: {guid}"))
    );
}

#[test]
fn a_project_for_unity_6_has_the_fields_of_unity_6() {
    let scene = scene();
    let of = |editor: Editor| written(&scene, Unity { pipeline: Pipeline::Urp, editor });
    let (older, newer) = (of(Editor::V2022), of(Editor::V6000));
    assert_eq!(older.keys().collect::<Vec<_>>(), newer.keys().collect::<Vec<_>>());
    let differ = [
        ("ProjectSettings/ProjectVersion.txt", "2022.3.", "6000.0."),
        ("ProjectSettings/TagManager.asset", "serializedVersion: 2\n", "m_RenderingLayers:\n  - Default\n"),
        ("ProjectSettings/EditorSettings.asset", "serializedVersion: 11\n", "serializedVersion: 13\n"),
        ("Packages/manifest.json", "14.0.9", "17.0.3"),
        (
            "Assets/Scenes/room.unity",
            "m_Drag: 0\n  m_AngularDrag: 0.05\n",
            "m_LinearDamping: 0\n  m_AngularDamping: 0.05\n",
        ),
        (
            "Assets/Scenes/room.unity",
            "m_GIWorkflowMode: 1\n",
            "LightmapSettings:\n  m_ObjectHideFlags: 0\n  serializedVersion: 13\n",
        ),
        ("Assets/Scenelang/Meshes/Objects/table.obj.meta", "serializedVersion: 22200\n", "serializedVersion: 24200\n"),
    ];
    for (file, before, after) in differ {
        let file = format!("unity/{file}");
        assert!(older[&file].contains(before) && !older[&file].contains(after), "{file}: {after}");
        assert!(newer[&file].contains(after) && !newer[&file].contains(before), "{file}: {before}");
    }
    // Objects have the same identities, so that a project can be written again for the other.
    let anchors = |files: &BTreeMap<String, String>| -> Vec<(u32, i64)> {
        documents(&files["unity/Assets/Scenes/room.unity"]).iter().map(|d| (d.0, d.1)).collect()
    };
    assert_eq!(anchors(&older), anchors(&newer));
}
