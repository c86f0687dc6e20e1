//! Unity projects that somebody edited: objects that stand in the scene, instances of prefabs, the prefabs themselves, and what
//! an editor makes of them. The chairs of the fixture are instances, all other objects stand in the scene.

use crate::back::{Written, layout, said};
use crate::fixture::parts;
use crate::project::{Project, Text, as_prefab, chair, change, listed, put_in, unpacked};
use scenelang_export::embedded::Carrier;
use scenelang_layout::Vec3;
use std::fs;
use std::path::Path;

/// What is said of the fixture's project after an edit of its scene, and the layout then.
fn after(change: impl FnOnce(&mut Text)) -> (String, scenelang_layout::Layout) {
    after_all(|project| project.edit(change))
}

fn after_all(change: impl FnOnce(&Project)) -> (String, scenelang_layout::Layout) {
    let written = Written::new(&parts().layout);
    change(&Project::at(&written.folder.path().join("unity")));
    let found = written.read(Carrier::Unity);
    (said(&found).join("; "), layout(&found.layout))
}

/// An object that stands in the scene, and one that is an instance.
const BOTH: [&str; 2] = ["table", "chair[1]"];
const UPRIGHT: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

#[test]
fn the_chairs_are_instances() {
    let written = Written::new(&parts().layout);
    let text = Text(fs::read_to_string(written.folder.path().join("unity/Assets/Scenes/room.unity")).unwrap());
    for (name, _) in &parts().layout.objects {
        assert_eq!(text.instance(name).is_some(), name.starts_with("chair"), "{name}");
    }
}

#[test]
fn each_edit_is_reported_by_name() {
    for name in BOTH {
        assert_eq!(after(|s| s.rename(name, "Big one")).0, format!("`{name}` was renamed to `Big one` in the scene"));
        let (said, now) = after(|s| s.switch_off(name));
        assert_eq!(said, format!("`{name}` was removed from the scene or deactivated"));
        assert!(now.object(name).is_none());
        let (said, now) = after(|s| s.scale(name, [1.0, 2.0, 1.0]));
        assert_eq!(said, format!("`{name}` was scaled by 1.000 × 2.000 × 1.000"));
        assert!((now.object(name).unwrap().scale.y - 2.0 * parts().layout.object(name).unwrap().scale.y).abs() < 1e-6);
        assert_eq!(
            after(|s| s.scale(name, [-1.0, 1.0, 1.0])).0,
            format!("`{name}` was sheared or mirrored; it is checked as it was exported")
        );
        let (said, now) = after(|s| s.put(name, [0.25, 0.0, -1.5], UPRIGHT));
        assert!(said.starts_with(&format!("`{name}` was moved by ")) && !said.contains("; "), "{said}");
        assert!((now.object(name).unwrap().pos - Vec3::new(0.25, 0.0, -1.5)).norm() < 1e-6);
    }
    // The whole scene may stand anywhere.
    assert_eq!(after(|s| s.put("room", [50.0, 0.0, 9.0], UPRIGHT)).0, "");
}

#[test]
fn an_instance_is_taken_away_copied_and_put_below_others() {
    let (said, now) = after(|s| s.delete("chair[1]"));
    assert_eq!(said, "`chair[1]` was removed from the scene or deactivated");
    assert!(now.object("chair[1]").is_none() && now.object("chair[0]").is_some());
    assert_eq!(
        after(|s| s.duplicate("chair[0]", "chair[0] (1)")).0,
        "`chair[0]` was copied as `chair[0] (1)`; the copy is not checked"
    );
    // The table stands at the origin, and so does the group of the objects.
    for father in ["table", "Building"] {
        let (said, now) = after(|s| s.reparent("chair[0]", Some(father)));
        assert_eq!(said, format!("`chair[0]` was made a child of `{father}`; it is checked at its current position"));
        assert_eq!(now, parts().layout);
    }
    assert_eq!(
        after(|s| s.reparent("chair[0]", None)).0,
        "`chair[0]` was made a child of `the scene`; it is checked at its current position"
    );
    // Below another instance it stands where that one has brought it.
    let (said, now) = after(|s| {
        s.put("chair[0]", [1.0, 0.0, 0.0], UPRIGHT);
        s.reparent("chair[1]", Some("chair[0]"));
    });
    assert!(
        said.contains("`chair[1]` was made a child of `chair[0]`; it is checked at its current position"),
        "{said}"
    );
    let before = parts().layout.object("chair[1]").unwrap().pos;
    assert!((now.object("chair[1]").unwrap().pos - before - Vec3::x()).norm() < 1e-5);
    let (said, now) = after(|s| {
        s.put("chair[1]", [1.0, 0.0, 0.0], UPRIGHT);
        s.reparent("table", Some("chair[1]"));
    });
    assert!(said.contains("`table` was made a child of `chair[1]`"), "{said}");
    assert!((now.object("table").unwrap().pos - Vec3::x()).norm() < 1e-5);
}

#[test]
fn an_instance_without_its_script_is_known_by_its_name() {
    let (said, now) = after_all(|project| {
        let (guid, script) = chair(project, 114);
        project.edit(|s| {
            listed(s, "chair[1]", "m_RemovedComponents", &format!("{{fileID: {script}, guid: {guid}, type: 3}}"));
            s.put("chair[1]", [0.0, 0.0, -1.0], UPRIGHT);
        });
    });
    assert!(said.starts_with("`chair[1]` was moved by ") && !said.contains("; "), "{said}");
    assert!((now.object("chair[1]").unwrap().pos + Vec3::z()).norm() < 1e-6);
    // Taken out of the instance, it is away.
    let (said, _) = after_all(|project| {
        let (guid, root) = chair(project, 1);
        project.edit(|s| {
            listed(s, "chair[1]", "m_RemovedGameObjects", &format!("{{fileID: {root}, guid: {guid}, type: 3}}"))
        });
    });
    assert_eq!(said, "`chair[1]` was removed from the scene or deactivated");
}

#[test]
fn an_edit_of_a_prefab_is_one_of_all_its_instances() {
    let (said, _) = after_all(|project| {
        project.change(&format!("{}.prefab", project.chair()), |prefab| {
            let root = prefab.document(4, "m_Father: {fileID: 0}").unwrap();
            prefab.line(&root, "m_LocalScale:", "m_LocalScale: {x: 2, y: 2, z: 2}");
        });
    });
    assert_eq!(said, "`chair[0]` was scaled by 2.000 × 2.000 × 2.000; `chair[1]` was scaled by 2.000 × 2.000 × 2.000");
    // Moved to another folder it is the same; without it the instances still say where they stand.
    let moved = |project: &Project| {
        let from = project.file(&project.chair());
        for end in ["prefab", "prefab.meta"] {
            fs::rename(from.with_extension(end), project.file(&format!("Assets/Chair.{end}"))).unwrap();
        }
    };
    assert_eq!(after_all(moved), (String::new(), parts().layout));
    let (said, _) = after_all(|project| {
        moved(project);
        project.change("Assets/Chair.prefab", |prefab| {
            let root = prefab.document(1, "m_TagString: Furniture").unwrap();
            prefab.line(&root, "m_Name:", "m_Name: Chair");
        });
        project.edit(|s| s.scale("chair[0]", [1.0, 1.0, 3.0]));
    });
    assert_eq!(said, "`chair[0]` was scaled by 1.000 × 1.000 × 3.000");
    let gone = |project: &Project| fs::remove_dir_all(project.file("Assets/Scenelang/Prefabs")).unwrap();
    assert_eq!(after_all(gone), (String::new(), parts().layout));
    let (said, _) = after_all(|project| {
        gone(project);
        project.edit(|s| s.put("chair[0]", [0.0, 0.0, -1.0], UPRIGHT));
    });
    assert!(said.starts_with("`chair[0]` was moved by ") && !said.contains("; "), "{said}");
}

const GUID: &str = "11111111111111111111111111111111";
/// A lamp of two pieces.
const LAMP: &str = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!1 &10\nGameObject:\n  m_Name: Lamp\n  m_IsActive: 1\n--- !u!4 &11\n\
    Transform:\n  m_GameObject: {fileID: 10}\n  m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}\n  m_LocalPosition: {x: 0, y: 0, z: 0}\n  \
    m_Children:\n  - {fileID: 21}\n  m_Father: {fileID: 0}\n--- !u!1 &20\nGameObject:\n  m_Name: Shade\n  m_IsActive: 1\n--- !u!4 &21\n\
    Transform:\n  m_GameObject: {fileID: 20}\n  m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}\n  m_LocalPosition: {x: 0, y: 1, z: 0}\n  \
    m_Children: []\n  m_Father: {fileID: 11}\n--- !u!33 &22\nMeshFilter:\n  m_GameObject: {fileID: 20}\n";

#[test]
fn a_prefab_that_was_put_there_is_no_object_of_the_program() {
    let added = |name: &str| format!("`{name}` was added; it is not in the program, so it is not checked");
    let (said, now) = after_all(|project| {
        project.prefab("Lamp", GUID, LAMP);
        project.edit(|s| put_in(s, GUID, "Objects", ""));
    });
    assert_eq!((said, now), (added("Lamp"), parts().layout));
    let (said, _) = after_all(|project| {
        project.prefab("Lamp", GUID, LAMP);
        project.edit(|s| put_in(s, GUID, "Objects", &change(10, GUID, "m_Name", "Big lamp")));
    });
    assert_eq!(said, added("Big lamp"));
    // On one of our objects it belongs to that.
    for name in BOTH {
        let (said, _) = after_all(|project| {
            project.prefab("Lamp", GUID, LAMP);
            project.edit(|s| put_in(s, GUID, name, ""));
        });
        assert_eq!(said, "", "{name}");
    }
    // Of a model file the instance says the name.
    let (said, _) = after(|s| {
        put_in(s, "22222222222222222222222222222222", "room", &change(919_132_149_155_446_097, GUID, "m_Name", "sofa"))
    });
    assert_eq!(said, added("sofa"));
    assert_eq!(
        after(|s| put_in(s, "22222222222222222222222222222222", "room", "")).0,
        added("an instance of a prefab")
    );
    // So does one of ours that was dragged into the scene: no object is meant.
    let (said, _) = after_all(|project| {
        let (guid, _) = chair(project, 1);
        project.edit(|s| put_in(s, &guid, "Objects", ""));
    });
    assert!(
        said.starts_with("`chair-") && said.ends_with("` was added; it is not in the program, so it is not checked"),
        "{said}"
    );
}

#[test]
fn instances_within_a_prefab_of_the_users_are_found() {
    let nested = |project: &Project, changes: &dyn Fn(&Text, i64) -> String| {
        let text = Text(fs::read_to_string(project.file("Assets/Scenes/room.unity")).unwrap());
        project.prefab("Room", GUID, &as_prefab(&text));
        let (_, root) = chair(project, 4);
        project.edit(|s| {
            let told = changes(&text, root);
            // The scene has nothing of its own but this instance.
            let settings = s.document(29, "").unwrap().start..s.document(1, "").unwrap().start;
            s.0 = format!("%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n{}--- !u!4 &5\nTransform:\n  m_GameObject: {{fileID: 6}}\n  m_LocalRotation: {{x: 0, y: 0, z: 0, w: 1}}\n  m_LocalPosition: {{x: 0, y: 0, z: 0}}\n--- !u!1 &6\nGameObject:\n  m_Name: World\n--- !u!1660057539 &9\nSceneRoots:\n", &s.0[settings]);
            put_in(s, GUID, "World", &told);
        });
    };
    assert_eq!(after_all(|project| nested(project, &|_, _| String::new())), (String::new(), parts().layout));
    // Unity calls an object of an instance within a prefab by both of their anchors.
    let (said, now) = after_all(|project| {
        nested(project, &|text, root| {
            let within = (text.anchor(&text.instance("chair[1]").unwrap()) ^ root) & i64::MAX;
            change(within, GUID, "m_LocalPosition.z", "-1.25")
        });
    });
    assert!(said.starts_with("`chair[1]` was moved by ") && !said.contains("; "), "{said}");
    assert!((now.object("chair[1]").unwrap().pos.z + 1.25).abs() < 1e-6);
    // By what stands for it in the prefab as well.
    let (_, now) = after_all(|project| {
        nested(project, &|text, _| {
            change(text.anchor(&text.transform("chair[1]")), GUID, "m_LocalPosition.z", "-1.25")
        });
    });
    assert!((now.object("chair[1]").unwrap().pos.z + 1.25).abs() < 1e-6);
}

#[test]
fn prefabs_that_make_no_sense_are_survived() {
    let (said, _) = after_all(|project| {
        let mut own = Text(format!("{LAMP}--- !u!1660057539 &9\nSceneRoots:\n"));
        put_in(&mut own, GUID, "Lamp", "");
        project.prefab("Lamp", GUID, &own.0);
        project.edit(|s| put_in(s, GUID, "Objects", ""));
    });
    assert!(said.starts_with("`Lamp` was added"), "{said}");
    // Each holds ten of the next: that is more than is looked at.
    let (said, _) = after_all(|project| {
        let guid = |i: usize| format!("{i:032x}");
        for i in 0..12 {
            let mut text = Text(format!("{LAMP}--- !u!1660057539 &9\nSceneRoots:\n"));
            for k in 0..10 {
                put_in(&mut text, &guid(i + 1), "Lamp", "");
                text.0 = text.0.replace("&88001", &format!("&{}", 99001 + k));
            }
            project.prefab(&format!("L{i}"), &guid(i), &text.0);
        }
        project.edit(|s| put_in(s, &guid(0), "Objects", ""));
    });
    assert_eq!(said, "`an instance of a prefab` was added; it is not in the program, so it is not checked");
    for broken in ["", "--- !u!1001 &1\n", "--- !u!4 &11\nTransform:\n  m_Father: {fileID: 11}\n", "\u{0}\u{1}"] {
        let (said, _) = after_all(|project| {
            project.prefab("Lamp", GUID, broken);
            project.edit(|s| put_in(s, GUID, "Objects", &change(10, GUID, "m_Name", "Lamp")));
        });
        assert!(said.is_empty() || said.contains("was added"), "{said}");
    }
    for (from, to) in [
        ("value: ", "value: x"),
        ("fileID: 1001", "fileID: q"),
        ("m_Modifications:", "m_Modifications: {"),
        ("propertyPath: m_Name", "propertyPath: a.b.c"),
    ] {
        let (_, now) = after(|s| s.0 = s.0.replace(from, to));
        assert!(now.objects.iter().all(|(_, place)| place.pos.iter().all(|v| v.is_finite())));
    }
}

#[test]
fn an_instance_that_was_unpacked_is_the_same_object() {
    let unpack = |project: &Project| {
        let prefab = fs::read_to_string(project.file(&format!("{}.prefab", project.chair()))).unwrap();
        project.edit(|s| unpacked(s, "chair[0]", &prefab));
    };
    assert_eq!(after_all(unpack), (String::new(), parts().layout));
    let (said, _) = after_all(|project| {
        unpack(project);
        project.edit(|s| s.put("chair[0]", [0.0, 0.0, -1.0], UPRIGHT));
    });
    assert!(said.starts_with("`chair[0]` was moved by ") && !said.contains("; "), "{said}");
}

/// A project of an exporter that wrote every object into the scene.
#[test]
fn a_project_without_prefabs_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/unity/older");
    for (file, to) in [
        ("room.unity", "Assets/Scenes"),
        ("layout.json", "Assets/Scenelang"),
        ("spec.scene.txt", "Assets/Scenelang"),
        ("EditorBuildSettings.asset", "ProjectSettings"),
    ] {
        let to = folder.path().join(to);
        fs::create_dir_all(&to).unwrap();
        fs::copy(from.join(file), to.join(file)).unwrap();
    }
    let project = Project::at(folder.path());
    let found = project.read();
    assert_eq!((said(&found), &found.layout), (Vec::new(), &found.exported));
    project.edit(|s| s.put("stool[1]", [1.0, 0.0, 0.5], UPRIGHT));
    let found = project.read();
    assert_eq!(said(&found).len(), 1);
    assert!(said(&found)[0].starts_with("`stool[1]` was "), "{:?}", said(&found));
    assert!((layout(&found.layout).object("stool[1]").unwrap().pos.z - 0.5).abs() < 1e-6);
}

#[test]
fn whoever_edits_the_layout_itself_wants_that_judged() {
    let written = Written::new(&parts().layout);
    let own = written.folder.path().join("unity/Assets/Scenelang/layout.json");
    let edited = written.text.replacen("[-1.2, 1.8, -1]", "[-1.2, 1.7, -1]", 1);
    assert_ne!(edited, written.text);
    fs::write(&own, &edited).unwrap();
    let found = written.read(Carrier::Unity);
    assert_eq!((found.layout, found.changes.len()), (edited, 0));
}

/// A scene that was saved under another name, or taken out of the list of scenes, is judged as it stands now.
#[test]
fn a_scene_is_found_by_what_it_holds() {
    const ROOM: &str = "Assets/Scenes/room.unity";
    const OTHER: &str = "Assets/Mine/other room.unity";
    let save_as = |project: &Project| {
        fs::create_dir_all(project.file("Assets/Mine")).unwrap();
        fs::copy(project.file(ROOM), project.file(OTHER)).unwrap();
    };
    let moved = "`table` was moved by +1.000 m along x";
    let put = |scene: &mut Text| scene.put("table", [1.0, 0.0, 0.0], UPRIGHT);
    let (said, now) = after_all(|project| {
        save_as(project);
        fs::remove_file(project.file(ROOM)).unwrap();
        project.change(OTHER, put);
    });
    assert_eq!((said.as_str(), now.object("table").unwrap().pos.x), (moved, 1.0));
    let unlisted = |project: &Project| {
        let settings = project.file("ProjectSettings/EditorBuildSettings.asset");
        fs::write(settings, "--- !u!1045 &1\nEditorBuildSettings:\n  m_Scenes: []\n").unwrap();
    };
    let (said, _) = after_all(|project| {
        unlisted(project);
        project.edit(put);
    });
    assert_eq!(said, moved);
    // Of two scenes the listed one is checked, and the other one is no secret.
    let (said, now) = after_all(|project| {
        save_as(project);
        project.change(OTHER, put);
    });
    assert_eq!(said, format!("`{OTHER}` is another scene of this layout, and was edited; `{ROOM}` is checked"));
    assert_eq!(now, parts().layout);
    assert_eq!(after_all(save_as).0, "");
}

#[test]
fn a_project_whose_scene_is_not_ours_any_more_is_not_judged_in_silence() {
    let gone: [fn(&Project); 3] = [
        |project| fs::remove_file(project.file("Assets/Scenes/room.unity")).unwrap(),
        |project| project.edit(|scene| scene.0 = scene.0.replace("layoutSha256", "sum")),
        |project| project.edit(|scene| scene.0.clear()),
    ];
    for gone in gone {
        let (said, now) = after_all(gone);
        assert_eq!(
            said,
            "none of the scenes of it has the object with the script that scenelang writes, so the embedded layout is checked"
        );
        assert_eq!(now, parts().layout);
    }
}

#[test]
fn a_transform_that_cannot_be_read_is_told() {
    let (said, now) = after(|scene| {
        let transform = scene.transform("table");
        scene.line(&transform, "m_LocalPosition:", "m_LocalPosition: {x: over there, y: 0, z: 0}");
    });
    assert_eq!(said, "`table` has a transform that cannot be read; it is checked as it was exported");
    assert_eq!(now, parts().layout);
}
