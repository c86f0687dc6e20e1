//! MJCF, SDF, USD and OBJ, read back: names, who is loose, what may overlap, and names that are hard to write.

use crate::fixture::{Parts, named, parts, scene};
use roxmltree::{Document, Node};
use scenelang_export::{Exporter, Lost, Scene, losses, mjcf, obj, sdf, usd};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// The files of an exporter, as text; what is no text are pictures.
fn files(exporter: &dyn Exporter, scene: &Scene) -> BTreeMap<String, String> {
    let files = exporter.files(scene).unwrap();
    let count = files.len();
    let mut out: BTreeMap<_, _> = files.into_iter().map(|f| (f.path.to_str().unwrap().to_owned(), f.bytes)).collect();
    assert_eq!(out.len(), count, "no file is written twice");
    out.retain(|path, _| !path.ends_with(".png"));
    out.into_iter().map(|(path, bytes)| (path, String::from_utf8(bytes).unwrap())).collect()
}

fn elements<'a>(document: &'a Document<'_>, tag: &'a str) -> impl Iterator<Item = Node<'a, 'a>> {
    document.root().descendants().filter(move |n| n.has_tag_name(tag))
}

#[test]
fn mjcf_has_a_body_for_each_thing_and_joints_for_what_is_loose() {
    let files = files(&mjcf::Mjcf, &scene());
    let document = Document::parse(&files["room.mjcf.xml"]).unwrap();
    let loose: Vec<&str> = elements(&document, "freejoint").map(|n| n.attribute("name").unwrap()).collect();
    assert_eq!(loose, ["table", "chair[0]", "chair[1]", "crate"]);
    let bodies: BTreeSet<&str> = elements(&document, "body").map(|n| n.attribute("name").unwrap()).collect();
    let told: Value = serde_json::from_str(&files["room.mjcf.json"]).unwrap();
    let told = told["bodies"].as_object().unwrap();
    assert_eq!(told.keys().map(String::as_str).collect::<BTreeSet<_>>(), bodies);
    assert_eq!(told["door"]["static"], true);
    assert_eq!(told["chair[1]"]["category"], "chair");
    assert_eq!(told["hall/wall0"]["category"], "wall");
    let meshes: BTreeSet<&str> = elements(&document, "mesh").map(|n| n.attribute("name").unwrap()).collect();
    let used: BTreeSet<&str> = elements(&document, "geom").filter_map(|n| n.attribute("mesh")).collect();
    assert_eq!(meshes, used, "every mesh is used, and every mesh that is used is there");
    let chairs = meshes.iter().filter(|name| name.starts_with("chair")).all(|name| name.starts_with("chair[0]"));
    assert!(chairs, "equal chairs share their meshes: {meshes:?}");
}

#[test]
fn a_zone_is_seen_and_stops_nothing() {
    let files = files(&sdf::Sdf, &scene());
    let document = Document::parse(&files["sdf/room.sdf"]).unwrap();
    let zone = elements(&document, "model").find(|n| n.attribute("name") == Some("corner_floor")).unwrap();
    let count = |tag: &str| zone.descendants().filter(|n| n.has_tag_name(tag)).count();
    assert_eq!((count("visual"), count("collision")), (1, 0));
}

#[test]
fn sdf_refers_to_files_that_are_there() {
    let files = files(&sdf::Sdf, &scene());
    let document = Document::parse(&files["sdf/room.sdf"]).unwrap();
    let used: BTreeSet<String> = elements(&document, "uri").map(|n| format!("sdf/{}", n.text().unwrap())).collect();
    let written: BTreeSet<String> = files.keys().filter(|p| p.ends_with(".obj")).cloned().collect();
    assert_eq!(used, written);
    let library = &files["sdf/meshes/materials.mtl"];
    for path in written {
        let materials = files[&path].lines().filter_map(|l| l.strip_prefix("usemtl ")).collect::<Vec<_>>();
        assert!(!materials.is_empty() && materials.iter().all(|m| library.contains(&format!("newmtl {m}\n"))));
    }
}

#[test]
fn obj_has_the_triangles_of_all_things_in_the_world() {
    let scene = scene();
    let files = files(&obj::Obj, &scene);
    let text = &files["obj/room.obj"];
    let triangles = |groups: &[scenelang_export::MeshGroup]| groups.iter().map(|g| g.indices.len() / 3).sum::<usize>();
    let drawn = scene.objects.iter().map(|o| triangles(&o.mesh)).sum::<usize>()
        + scene.shells.iter().map(|s| s.group.indices.len() / 3).sum::<usize>();
    assert_eq!(text.lines().filter(|l| l.starts_with("f ")).count(), drawn);
    let count = text.lines().filter(|l| l.starts_with("v ")).count();
    let used = text.lines().filter_map(|l| l.strip_prefix("f ")).flat_map(|l| l.split(' '));
    let used = used.map(|corner| corner.split('/').next().unwrap().parse::<usize>().unwrap());
    assert_eq!(used.max(), Some(count));
    assert!(files["obj/room.mtl"].contains("newmtl"));
}

#[test]
fn equal_things_share_a_prim_and_a_package_holds_the_same_layer() {
    let files = files(&usd::Usd, &scene());
    let layer = &files["room.usda"];
    assert_eq!(layer.matches("prepend references = </Shapes/chair>").count(), 2);
    let second = layer.split("def Xform \"chair_1\" (").nth(1).and_then(|rest| rest.split("\n            )").next());
    assert!(second.is_some_and(|told| told.contains("displayName = \"chair[1]\"")), "{layer}");
    let package = usd::Usdz.files(&scene()).unwrap().remove(0).bytes;
    let at = package.windows(layer.len()).position(|w| w == layer.as_bytes()).unwrap();
    assert_eq!(at % 64, 0);
}

/// A chair that may overlap the table stands on it, so much deeper than its top.
fn chair_on_table(depth: f64) -> Parts {
    let mut parts = parts();
    let id = |name: &str| {
        let at = parts.program.objects.iter().position(|o| o.name == name).unwrap();
        scenelang_lang::program::ObjectId(at as u32)
    };
    parts.program.allow.contents = vec![(id("chair[0]"), id("table"))];
    let table = &parts.layout.objects.iter().find(|(n, _)| n == "table").unwrap().1;
    let at = table.pos + scenelang_layout::Vec3::new(0.0, table.scale.y - depth, 0.0);
    parts.layout.objects.iter_mut().find(|(n, _)| n == "chair[0]").unwrap().1.pos = at;
    parts
}

#[test]
fn what_may_overlap_is_said_where_it_can_be() {
    let parts = chair_on_table(0.05);
    let scene = parts.build().unwrap();
    assert_eq!(scene.overlaps, [[0, 1]]);
    let mjcf = &files(&mjcf::Mjcf, &scene)["room.mjcf.xml"];
    assert!(mjcf.contains("<exclude body1=\"table\" body2=\"chair[0]\"/>"));
    let usd = &files(&usd::Usd, &scene)["room.usda"];
    assert!(usd.contains("physics:filteredPairs = [</World/Objects/chair_0>]"));
    let lost: Vec<(String, Lost)> = losses(&scene, &[Box::new(usd::Usd) as Box<dyn Exporter>, Box::new(sdf::Sdf)])
        .into_iter()
        .map(|l| (l.format.to_owned(), l.what))
        .collect();
    let pair = Lost::Overlaps(vec![["table".into(), "chair[0]".into()]]);
    assert_eq!(lost, [("sdf".into(), pair), ("sdf".into(), Lost::Program)]);
}

/// What a thing rests on has to hold it up, even if they may overlap.
#[test]
fn what_merely_touches_is_not_let_through() {
    for (depth, overlaps) in [(0.0, vec![]), (0.0005, vec![]), (0.01, vec![[0, 1]])] {
        assert_eq!(chair_on_table(depth).build().unwrap().overlaps, overlaps, "{depth}");
    }
}

#[test]
fn names_and_categories_that_are_hard_to_write_break_nothing() {
    let strange = "x\"/><&]]>\u{1}\n../\\ 灯 </World>";
    for name in ["world", "sun", "灯", "__model__", "ŝeĝo"] {
        let mut parts = named(name);
        for object in &mut parts.program.objects {
            object.category = strange.into();
        }
        let mut scene = parts.build().unwrap();
        scene.name = "a \"b\" & 'c' ../é".into();
        let xml = files(&mjcf::Mjcf, &scene);
        let (path, text) = xml.iter().find(|(p, _)| p.ends_with(".xml")).unwrap();
        let document = Document::parse(text).unwrap_or_else(|e| panic!("{path}: {e}"));
        let bodies: Vec<&str> = elements(&document, "body").map(|n| n.attribute("name").unwrap()).collect();
        // MuJoCo has a body of that name.
        assert!(bodies.contains(&if name == "world" { "world:object" } else { name }) && !bodies.contains(&"world"));
        let world = files(&sdf::Sdf, &scene);
        assert!(world.keys().all(|p| p.starts_with("sdf/") && !p.contains("..")), "{:?}", world.keys());
        let text = world.iter().find(|(p, _)| p.ends_with(".sdf")).unwrap().1;
        let document = Document::parse(text).unwrap();
        let names: Vec<&str> = elements(&document, "model").map(|n| n.attribute("name").unwrap()).collect();
        assert_eq!(names.iter().collect::<BTreeSet<_>>().len(), names.len());
        assert!(!names.contains(&"world") && !names.contains(&"sun"), "these names are taken");
        let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
        assert!(names.iter().all(|n| n.starts_with(|c: char| c.is_ascii_alphabetic()) && n.chars().all(plain)));
        let layer = &files(&usd::Usd, &scene).into_values().next().unwrap();
        assert!(!layer.contains('\u{1}'));
        assert!(files(&obj::Obj, &scene).keys().all(|p| p.starts_with("obj/") && !p.contains("..")));
    }
}

#[test]
fn numbers_are_finite_everywhere() {
    for exporter in [&mjcf::Mjcf as &dyn Exporter, &sdf::Sdf, &usd::Usd, &obj::Obj] {
        for (path, text) in files(exporter, &scene()) {
            for word in text.split(|c: char| !c.is_alphanumeric()) {
                assert!(!matches!(word, "NaN" | "inf" | "nan"), "{path}");
            }
        }
    }
}
