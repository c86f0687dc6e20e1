//! Models are brought to metres, base and front, whatever axes and units they are in.

use crate::made::{Mesh, block, furniture, glb, write};
use flate2::Compression;
use flate2::write::GzEncoder;
use scenelang_catalogue::{Catalogue, CatalogueModel};
use scenelang_layout::{Convex, Part, Vec3};
use serde_json::{Value, json};
use std::f64::consts::FRAC_1_SQRT_2;
use std::fs;
use std::io::Write;
use tempfile::tempdir;

/// The one model of a folder.
fn only(folder: &std::path::Path) -> CatalogueModel {
    let catalogue = Catalogue::open(folder).unwrap();
    assert!(catalogue.refused.is_empty(), "{:?}", catalogue.refused);
    let [entry] = catalogue.entries.as_slice() else { panic!("{:?}", catalogue.entries) };
    let model = catalogue.model(entry).unwrap();
    if !entry.file.starts_with("assets") {
        assert_eq!(entry.size, Some(model.size));
    }
    model
}

/// A model that is read from one file.
fn read(name: &str, bytes: &[u8], card: &Value) -> CatalogueModel {
    let folder = tempdir().unwrap();
    write(folder.path(), name, bytes, card);
    only(folder.path())
}

/// What always holds: mesh and parts fill the box, which stands on the floor, in the middle.
fn is_in_its_box(model: &CatalogueModel) {
    let half = Vec3::new(model.size.x / 2.0, 0.0, model.size.z / 2.0);
    let (lo, hi) = (-half, half + Vec3::new(0.0, model.size.y, 0.0));
    let (from, to) = model.mesh.bounds().unwrap();
    assert!((from - lo).amax() < 2e-3 && (to - hi).amax() < 2e-3, "{from} {to} {}", model.size);
    let solids: Vec<Convex> = model.parts.iter().map(|p| Convex::from_part(p).unwrap()).collect();
    let boxes = solids.iter().map(|c| *c.aabb());
    let (from, to) = boxes.fold((hi, lo), |(a, b), c| (a.inf(&c.min), b.sup(&c.max)));
    assert!((from - lo).amax() < 1e-6 && (to - hi).amax() < 1e-6, "{from} {to} {}", model.size);
}

/// A desk with a tall board at its back, in the frame of glTF: back at −z, a low box at its right hand, −x.
fn desk() -> Mesh {
    block(1.2, 0.7, 0.6).cuboid([-0.6, 0.7, -0.3], [0.6, 1.0, -0.25]).cuboid([-0.6, 0.7, 0.0], [-0.4, 0.8, 0.2])
}

/// Where the box on the desk is.
fn place_of_the_box(model: &CatalogueModel) -> [f64; 3] {
    let centers = model.parts.iter().map(|part| match part {
        Part::Box { pos, size, .. } => (size.product(), *pos),
        other => panic!("{other:?}"),
    });
    let (_, pos) = centers.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    [pos.x, pos.y, pos.z].map(|x| (x * 1e4).round() / 1e4)
}

#[test]
fn front_unit_and_base_are_put_right() {
    let plain = read("desk.glb", &desk().glb(), &Value::Null);
    // glTF has x to the left of who looks at the front, the layout to the right.
    assert_eq!(place_of_the_box(&plain), [0.5, 0.75, 0.1]);
    assert_eq!(plain.parts.len(), 3);
    is_in_its_box(&plain);

    // Turned by a right angle, in millimetres, in the air and beside the origin.
    let turned = desk().map(|[x, y, z]| [1000.0 * z + 30.0, 1000.0 * y + 450.0, -1000.0 * x]);
    let card = json!({ "front": "+x", "size": [1.2, 1.0, 0.6] });
    let model = read("desk.glb", &turned.glb(), &card);
    assert_eq!(place_of_the_box(&model), [0.5, 0.75, 0.1]);
    assert!((model.size - plain.size).amax() < 1e-6 && (model.origin.base - 0.45).abs() < 1e-6, "{:?}", model.origin);
    is_in_its_box(&model);

    let model = read("desk.glb", &turned.glb(), &json!({ "front": 90, "size": [1.2, 1.0, 0.6] }));
    assert_eq!(place_of_the_box(&model), [0.5, 0.75, 0.1]);

    // z up, as Blender has it inside: the front is at −y.
    let upright = desk().map(|[x, y, z]| [x, -z, y]);
    let model = read("desk.glb", &upright.glb(), &json!({ "up": "z", "front": "-y" }));
    assert_eq!(place_of_the_box(&model), [0.5, 0.75, 0.1]);
    is_in_its_box(&model);
}

#[test]
fn nodes_put_meshes_where_they_are() {
    let (mut document, binary) = block(1.0, 1.0, 1.0).document();
    document["nodes"] = json!([
        { "mesh": 0, "children": [1] },
        { "mesh": 0, "translation": [0.0, 2.0, 0.0], "rotation": [0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2], "scale": [1.0, 1.0, -3.0] },
    ]);
    let model = read("tower.glb", &glb(&document, &binary), &Value::Null);
    // The second lies on its side: from x = −1 to 0 and three times as deep.
    assert!((model.size - Vec3::new(1.5, 2.5, 3.0)).amax() < 1e-6, "{}", model.size);
    assert_eq!((model.origin.open_edges, model.parts.len(), model.triangles()), (0, 2, 24));
    let volume = model.origin.volume.unwrap();
    assert!((volume - 4.0).abs() < 1e-6, "{volume}: mirrored triangles run the other way round");
    is_in_its_box(&model);
}

#[test]
fn strips_fans_and_meshes_without_indices_are_read() {
    let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let quad = Mesh { positions, indices: vec![0, 1, 3, 2] };
    for (mode, indices) in [(5, vec![0, 1, 3, 2]), (6, vec![0, 1, 2, 3]), (4, vec![0, 1, 2, 0, 2, 3])] {
        let (mut document, binary) = Mesh { indices, ..quad.clone() }.document();
        document["meshes"][0]["primitives"][0]["mode"] = json!(mode);
        let model = read("sheet.glb", &glb(&document, &binary), &Value::Null);
        assert_eq!((model.triangles(), model.size), (2, Vec3::new(1.0, 1.0, 0.001)), "mode {mode}");
        let normals: Vec<_> = model.mesh.groups[0].normals.clone();
        assert!(normals.iter().all(|n| n[2] > 0.99), "mode {mode}: {normals:?}");
    }
    let (mut document, binary) = quad.document();
    document["meshes"][0]["primitives"][0].as_object_mut().unwrap().remove("indices");
    assert_eq!(read("one.glb", &glb(&document, &binary), &Value::Null).triangles(), 1);
}

#[test]
fn colours_are_those_of_the_materials() {
    let (mut document, binary) = block(1.0, 1.0, 1.0).document();
    document["materials"] = json!([{
        "pbrMetallicRoughness": { "baseColorFactor": [0.2158605, 1.0, 0.0, 0.5], "metallicFactor": 0.0 },
        "alphaMode": "BLEND",
    }]);
    document["meshes"][0]["primitives"][0]["material"] = json!(0);
    let model = read("glass.glb", &glb(&document, &binary), &Value::Null);
    let surface = &model.mesh.groups[0].surface;
    // 0.216 in linear light is one half in sRGB.
    assert_eq!((surface.color, surface.opacity), ([128.0 / 255.0, 1.0, 0.0], 128.0 / 255.0));
}

#[test]
fn obj_files_are_read_with_their_colours() {
    let folder = tempdir().unwrap();
    let text = "mtllib oak.mtl\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\nv 1 0 3\nv 1 2 3\nv 0 2 3\nusemtl oak\n\
                f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf -8 -4 -1 -5\nl 1 2\n";
    fs::write(folder.path().join("oak.mtl"), "newmtl oak\nKd 1 0.5 0\n").unwrap();
    write(folder.path(), "deep/chest.obj", text.as_bytes(), &Value::Null);
    // The materials are looked for beside the model.
    fs::copy(folder.path().join("oak.mtl"), folder.path().join("deep/oak.mtl")).unwrap();
    let model = only(folder.path());
    assert_eq!((model.file.as_str(), model.card.category.as_str()), ("deep/chest.obj", "chest"));
    assert_eq!((model.size, model.origin.open_edges), (Vec3::new(1.0, 2.0, 3.0), 0));
    assert_eq!(model.mesh.groups[0].surface.color, [1.0, 128.0 / 255.0, 0.0]);
    is_in_its_box(&model);
}

#[test]
fn furniture_comes_back_as_it_was() {
    for category in ["chair", "desk", "wardrobe", "floor lamp", "sofa"] {
        let asset = furniture(category);
        let model = read("it.glb", &Mesh::of(&asset).glb(), &Value::Null);
        assert!((model.size - asset.size).amax() < 1e-5, "{category}");
        assert_eq!(model.triangles(), asset.mesh.triangles());
        assert!(model.parts.len() > 1 && model.origin.open_edges == 0, "{category}: {:?}", model.origin);
        is_in_its_box(&model);
    }
}

#[test]
fn the_folder_of_objathor_is_read() {
    let folder = tempdir().unwrap();
    let packed = |value: &Value| {
        let mut out = GzEncoder::new(Vec::new(), Compression::default());
        out.write_all(value.to_string().as_bytes()).unwrap();
        out.finish().unwrap()
    };
    let annotations = json!({
        "aa11": {
            "category": "chair", "description_auto": "a wooden chair", "synset": "chair.n.01", "materials": ["wood"], "mass": 6.5,
            "license_info": { "license": "by" }, "thor_metadata": { "assetMetadata": { "boundingBox": { "x": 0.5, "y": 1.0, "z": 2.0 } } },
        },
        "bb22": { "category": 7, "width": 50 },
        "cc33": {},
        "../dd44": {},
    });
    fs::write(folder.path().join("annotations.json.gz"), packed(&annotations)).unwrap();
    let point = |[x, y, z]: [f32; 3]| json!({ "x": x, "y": y, "z": z });
    // The layout's frame already; turned by 90° when it is loaded: z goes to x.
    let mesh = block(2.0, 1.0, 0.5);
    let mut triangles = mesh.indices.clone();
    triangles.chunks_exact_mut(3).for_each(|t| t.swap(1, 2));
    let positions: Vec<Value> = mesh.positions.iter().map(|[x, y, z]| point([-x, *y, *z])).collect();
    let asset = json!({ "name": "aa11", "vertices": positions, "triangles": triangles, "yRotOffset": 90.0,
        "colliders": [{ "vertices": positions, "triangles": triangles }] });
    write(folder.path(), "assets/aa11/aa11.json.gz", &packed(&asset), &Value::Null);
    write(folder.path(), "assets/bb22/bb22.pkl.gz", b"", &Value::Null);

    let catalogue = Catalogue::open(folder.path()).unwrap();
    let refused: Vec<String> =
        catalogue.refused.iter().map(|r| format!("{} {} {}", r.file, r.finding.code, r.finding.message)).collect();
    assert_eq!(
        refused,
        [
            "annotations.json.gz E0703 it has an object whose name is not a valid file name: \"../dd44\"",
            "annotations.json.gz E0001 1 of its 4 objects have no model below assets/",
        ]
    );
    let [entry, empty] = catalogue.entries.as_slice() else { panic!("{:?}", catalogue.entries) };
    let fault = catalogue.model(empty).unwrap_err();
    assert_eq!(fault.message, "it is not an objathor model: it is not a pickle of protocol 2 to 5");
    assert_eq!(entry.size, Some(Vec3::new(0.5, 1.0, 2.0)));
    let model = catalogue.model(entry).unwrap();
    assert!((model.size - Vec3::new(0.5, 1.0, 2.0)).amax() < 1e-6, "{}", model.size);
    assert!((model.origin.distortion - 1.0).abs() < 1e-6 && model.origin.volume.unwrap() > 0.99);
    assert_eq!((model.card.description.as_str(), model.card.mass, model.parts.len()), ("a wooden chair", Some(6.5), 1));
    is_in_its_box(&model);
}
