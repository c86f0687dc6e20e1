//! Scenes read back from GLB files and Unity projects: as they were where nobody changed them, else with what was changed and
//! nothing else. Edits of Unity projects are in [`crate::edited`].

use crate::fixture::{parts, written};
use crate::project::Project;
use proptest::prelude::*;
use scenelang_base::FileId;
use scenelang_base::door::Door;
use scenelang_export::embedded::{self, Carrier, Embedded};
use scenelang_export::glb::Glb;
use scenelang_export::unity::Unity;
use scenelang_layout::{Layout, Vec3, file, rotation};
use serde_json::{Value, json};
use std::fs;

/// A scene in both kinds of files.
pub struct Written {
    pub folder: tempfile::TempDir,
    pub text: String,
}

impl Written {
    /// The scene of the fixture with another layout.
    pub fn new(layout: &Layout) -> Self {
        let (folder, text) = written(layout, &[&Glb, &Unity::default()]);
        Self { folder, text }
    }

    pub fn read(&self, carrier: Carrier) -> Embedded {
        let path = self.folder.path().join(if carrier == Carrier::Glb { "room.glb" } else { "unity" });
        embedded::read("it", &path, carrier, &Door::of(&path)).unwrap()
    }

    /// Changes the document of the GLB file.
    fn edit(&self, change: impl FnOnce(&mut Value)) {
        let path = self.folder.path().join("room.glb");
        let bytes = fs::read(&path).unwrap();
        let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
        let mut document: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
        change(&mut document);
        let mut json = document.to_string().into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let size = (json.len() as u32).to_le_bytes();
        let whole = [&bytes[..12], &size, b"JSON", &json, &bytes[20 + length..]].concat();
        fs::write(&path, whole).unwrap();
    }
}

fn node<'d>(document: &'d mut Value, name: &str) -> &'d mut Value {
    document["nodes"].as_array_mut().unwrap().iter_mut().find(|n| n["name"] == name).unwrap()
}

pub fn layout(text: &str) -> Layout {
    file::read(text, FileId(0)).layout
}

pub fn said(found: &Embedded) -> Vec<&str> {
    found.changes.iter().map(|change| change.message.as_str()).collect()
}

#[test]
fn layouts_differ_in_the_words_of_edits() {
    let before = parts().layout;
    assert_eq!(embedded::differences(&before, &before), Vec::<String>::new());
    let mut after = before.clone();
    let index = |name: &str| before.objects.iter().position(|(n, _)| n == name).unwrap();
    let (table, picture) = (index("table"), index("picture"));
    after.objects[table].1.pos.x += 0.25;
    after.objects[picture].1.rot.y += 90.0;
    let mut fewer = before.clone();
    fewer.objects.retain(|(name, _)| name != "balloon");
    assert_eq!(
        embedded::differences(&fewer, &after),
        ["`table` was moved by +0.250 m along x", "`balloon` was added", "`picture` was turned by 90.0°"]
    );
    // What only the first one has is no difference of things that both have.
    assert_eq!(embedded::differences(&before, &fewer), Vec::<String>::new());
}

fn triple() -> impl Strategy<Value = [f64; 3]> {
    [-9.0..9.0, 0.0..4.0, -9.0..9.0]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Two hundred layouts, each as a GLB file and as a Unity project.
    #[test]
    fn what_nobody_changed_comes_back_and_what_moved_is_what_differs(
        poses in prop::collection::vec((triple(), [0.0..360.0, 0.0..360.0, 0.0..360.0]), 8),
        which in 0..8_usize,
        by in triple(),
        yaw in 1.0..359.0,
    ) {
        let mut scene = parts().layout;
        for ((_, place), (pos, rot)) in scene.objects.iter_mut().zip(&poses) {
            (place.pos, place.rot) = ((*pos).into(), (*rot).into());
        }
        let written = Written::new(&scene);
        for carrier in [Carrier::Glb, Carrier::Unity] {
            let found = written.read(carrier);
            prop_assert_eq!((&found.layout, said(&found)), (&written.text, Vec::new()));
        }
        // One thing elsewhere, and turned.
        let (name, place) = scene.objects[which].clone();
        let turned = rotation::matrix(Vec3::new(0.0, yaw, 0.0)) * rotation::matrix(place.rot);
        let [x, y, z, w] = rotation::quaternion(&turned);
        let to = place.pos + Vec3::from(by) + Vec3::new(0.0, 0.01, 0.0);
        written.edit(|document| {
            let node = node(document, &name);
            node["translation"] = json!([-to.x, to.y, to.z]);
            node["rotation"] = json!([x, -y, -z, w]);
        });
        Project::at(&written.folder.path().join("unity")).edit(|scene| scene.put(&name, [to.x, to.y, to.z], [x, y, z, w]));
        for carrier in [Carrier::Glb, Carrier::Unity] {
            let found = written.read(carrier);
            prop_assert_eq!(found.changes.len(), 1);
            for ((object, now), (_, before)) in layout(&found.layout).objects.iter().zip(&scene.objects) {
                if *object == name {
                    prop_assert!((now.pos - to).amax() < 1e-5, "{} {}", now.pos, to);
                    prop_assert!((rotation::matrix(now.rot) - turned).amax() < 1e-5);
                } else {
                    prop_assert_eq!(now, before);
                }
            }
        }
    }
}

/// What is said of a GLB file after a change of its document.
fn after(change: impl FnOnce(&mut Value)) -> (Vec<String>, Layout) {
    let written = Written::new(&parts().layout);
    written.edit(change);
    let found = written.read(Carrier::Glb);
    (said(&found).into_iter().map(str::to_owned).collect(), layout(&found.layout))
}

#[test]
fn each_change_is_reported_by_name() {
    let (said, now) = after(|d| node(d, "table")["translation"] = json!([-0.3, 0, 0]));
    assert_eq!(said, ["`table` was moved by +0.300 m along x"]);
    assert_eq!(now.object("table").unwrap().pos, Vec3::new(0.3, 0.0, 0.0));
    // What was only moved keeps its triple.
    let (_, now) = after(|d| node(d, "chair[1]")["translation"] = json!([0, 0, 0]));
    assert_eq!(now.object("chair[1]").unwrap().rot, Vec3::new(0.0, 165.0, 0.0));

    let (said, now) = after(|d| node(d, "table")["name"] = json!("Table.001"));
    assert_eq!(said, ["`table` was renamed to `Table.001` in the scene"]);
    assert!(now.object("table").is_some());

    let (said, now) = after(|d| d["scenes"][0]["nodes"].as_array_mut().unwrap().retain(|i| i != 0));
    assert_eq!(said, ["`table` was removed from the scene or deactivated"]);
    assert!(now.object("table").is_none());

    let (said, _) = after(|d| {
        let mut copy = node(d, "balloon").clone();
        copy["name"] = json!("balloon.001");
        let nodes = d["nodes"].as_array_mut().unwrap();
        nodes.push(copy);
        let last = nodes.len() - 1;
        d["scenes"][0]["nodes"].as_array_mut().unwrap().push(json!(last));
    });
    assert_eq!(said, ["`balloon` was copied as `balloon.001`; the copy is not checked"]);

    let (said, _) = after(|d| {
        let nodes = d["nodes"].as_array_mut().unwrap();
        nodes.push(json!({ "name": "Suzanne", "mesh": 0 }));
        let last = nodes.len() - 1;
        d["scenes"][0]["nodes"].as_array_mut().unwrap().push(json!(last));
    });
    assert_eq!(said, ["`Suzanne` was added; it is not in the program, so it is not checked"]);

    let (said, now) = after(|d| node(d, "crate")["scale"] = json!([2, 2, 2]));
    assert_eq!(said, ["`crate` was scaled by 2.000 × 2.000 × 2.000"]);
    assert_eq!(now.object("crate").unwrap().scale, Vec3::new(0.8, 0.8, 0.8));
    // A turned part cannot follow an uneven scale: the thing is its box then.
    let (_, now) = after(|d| node(d, "crate")["scale"] = json!([2, 1, 1]));
    assert!(now.object("crate").unwrap().parts.is_empty());
    let (said, _) = after(|d| node(d, "crate")["scale"] = json!([-1, 1, 1]));
    assert_eq!(said, ["`crate` was sheared or mirrored; it is checked as it was exported"]);

    let (said, now) = after(|d| {
        // Below the table, which stands at the origin.
        node(d, "table")["children"] = json!([1]);
        d["scenes"][0]["nodes"].as_array_mut().unwrap().retain(|i| i != 1);
    });
    assert_eq!(said, ["`chair[0]` was made a child of `table`; it is checked at its current position"]);
    assert_eq!(now, parts().layout);

    let (said, _) = after(|d| {
        let wall = d["nodes"].as_array_mut().unwrap().iter_mut().find(|n| n["extras"]["scenelang"]["part"] == "wall");
        wall.unwrap()["translation"] = json!([0, 0, 1]);
    });
    assert!(said.len() == 1 && said[0].contains("a part of the building, was moved"), "{said:?}");
}

/// Tools put the whole scene below a node, and repeat what was written into an object in what it is made of.
#[test]
fn what_tools_add_around_and_below_objects_is_no_edit() {
    let below_root = |d: &mut Value, at: Value| {
        let roots = d["scenes"][0]["nodes"].take();
        let nodes = d["nodes"].as_array_mut().unwrap();
        nodes.push(json!({ "name": "Root", "children": roots, "translation": at }));
        let root = nodes.len() - 1;
        d["scenes"][0]["nodes"] = json!([root]);
    };
    let wrapped = |at: Value| after(|d| below_root(d, at));
    assert_eq!(wrapped(json!([0, 0, 0])), (Vec::new(), parts().layout));
    let (said, now) = wrapped(json!([0, 0, 5]));
    assert_eq!(said, ["`Root`, the node of the whole scene, was moved; objects are checked in relation to it"]);
    assert_eq!(now, parts().layout);
    let (said, now) = after(|d| {
        let nodes = d["nodes"].as_array_mut().unwrap();
        for at in 0..nodes.len() {
            let mut made_of = nodes[at].clone();
            made_of["name"] = json!("geometry");
            made_of["translation"] = json!([0, 0, 0]);
            made_of.as_object_mut().unwrap().remove("children");
            nodes.push(made_of);
            nodes[at]["children"] = json!([nodes.len() - 1]);
            nodes[at].as_object_mut().unwrap().remove("mesh");
        }
    });
    assert_eq!((said, now), (Vec::new(), parts().layout));
}

#[test]
fn names_tell_where_a_tool_has_dropped_what_was_written() {
    let (said, now) = after(|d| {
        for node in d["nodes"].as_array_mut().unwrap() {
            node.as_object_mut().unwrap().remove("extras");
        }
        node(d, "table")["translation"] = json!([-0.3, 0, 0]);
    });
    assert!(said.contains(&"`table` was moved by +0.300 m along x".to_owned()), "{said:?}");
    assert_eq!(now.objects.len(), parts().layout.objects.len());
}

#[test]
fn documents_that_make_no_sense_are_survived() {
    let odd: [fn(&mut Value); 5] = [
        |d| node(d, "table")["children"] = json!([0]),
        |d| node(d, "table")["translation"] = json!(["a", null, true]),
        |d| node(d, "table")["rotation"] = json!([0, 0, 0, 0]),
        |d| node(d, "table")["matrix"] = json!(vec![0; 16]),
        |d| d["scenes"][0]["nodes"] = json!([99, -1, "x", 0, 0]),
    ];
    for change in odd {
        let (_, now) = after(change);
        assert!(now.objects.iter().all(|(_, place)| place.pos.iter().all(|v| v.is_finite())));
    }
}
