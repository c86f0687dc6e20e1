//! The GLB, taken apart.

use crate::fixture::scene;
use scenelang_assets::textures::Texture;
use scenelang_export::glb::bytes;
use serde_json::Value;

struct Glb {
    json: Value,
    binary: Vec<u8>,
}

fn read() -> Glb {
    let bytes = bytes(&scene()).unwrap();
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!(&bytes[..4], b"glTF");
    assert_eq!([word(4), word(8)], [2, bytes.len()]);
    let (json_length, json_start) = (word(12), 20);
    let binary_start = json_start + json_length + 8;
    assert_eq!(&bytes[16..20], b"JSON");
    assert_eq!(&bytes[binary_start - 4..binary_start], b"BIN\0");
    Glb { json: serde_json::from_slice(&bytes[20..20 + json_length]).unwrap(), binary: bytes[binary_start..].to_vec() }
}

impl Glb {
    fn list(&self, key: &str) -> &Vec<Value> {
        self.json[key].as_array().unwrap()
    }
    /// The bytes of an accessor's elements.
    fn elements(&self, accessor: &Value) -> Vec<&[u8]> {
        let view = &self.json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let number = |v: &Value, key: &str| v[key].as_u64().unwrap_or(0) as usize;
        let size = match accessor["componentType"].as_u64().unwrap() {
            5123 => 2,
            5125 => 4,
            5126 => 12,
            other => panic!("{other}"),
        };
        let start = number(view, "byteOffset") + number(accessor, "byteOffset");
        assert!(number(accessor, "byteOffset") + size * number(accessor, "count") <= number(view, "byteLength"));
        (0..number(accessor, "count")).map(|i| &self.binary[start + i * size..start + (i + 1) * size]).collect()
    }
}

#[test]
fn nodes_are_found_by_their_extras() {
    let glb = read();
    let tags: Vec<String> = glb
        .list("nodes")
        .iter()
        .map(|n| {
            let tag = &n["extras"]["scenelang"];
            let text = |key: &str| tag[key].as_str().unwrap_or("-").to_owned();
            match (tag["id"].as_str(), n["extensions"].is_object()) {
                (Some(id), _) => id.to_owned(),
                (None, true) => "light".to_owned(),
                (None, false) => format!("{} {}", text("region"), text("part")),
            }
        })
        .collect();
    assert_eq!(
        tags,
        [
            "table",
            "chair[0]",
            "chair[1]",
            "balloon",
            "picture",
            "door",
            "window",
            "crate",
            "hall floor",
            "hall ceiling",
            "hall wall",
            "hall skirting",
            "hall wall",
            "hall skirting",
            "hall wall",
            "hall skirting",
            "hall wall",
            "hall skirting",
            "den floor",
            "den ceiling",
            "den wall",
            "den skirting",
            "den wall",
            "den skirting",
            "den wall",
            "den skirting",
            "den wall",
            "den skirting",
            "corner floor",
            "light",
            "light",
            "light",
        ]
    );
    let own = &glb.json["scenes"][0]["extras"]["scenelang"];
    assert!(own["spec"].as_str().unwrap().contains("object chair[2];"));
    assert!(own["layout"].as_str().unwrap().contains("scenelang.layout/1"));
}

#[test]
fn places_are_mirrored_at_x() {
    let glb = read();
    let chair = &glb.list("nodes")[1];
    assert_eq!(chair["translation"], serde_json::json!([0.4, 0.0, 1.0]));
    let turn: Vec<f64> = chair["rotation"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    assert!((turn[1].abs() - 1.0).abs() < 1e-9, "half a turn about y: {turn:?}");
}

#[test]
fn accessors_say_what_is_there() {
    let glb = read();
    let mut triangles = 0;
    for primitive in glb.list("meshes").iter().flat_map(|m| m["primitives"].as_array().unwrap()) {
        let accessor = |v: &Value| &glb.json["accessors"][v.as_u64().unwrap() as usize];
        let position = accessor(&primitive["attributes"]["POSITION"]);
        let vector = |b: &[u8]| [0, 4, 8].map(|i| f32::from_le_bytes(b[i..i + 4].try_into().unwrap()));
        let points: Vec<[f32; 3]> = glb.elements(position).into_iter().map(vector).collect();
        for axis in 0..3 {
            let along = points.iter().map(|p| f64::from(p[axis]));
            let (lo, hi) = along.fold((f64::MAX, f64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)));
            assert_eq!([&position["min"][axis], &position["max"][axis]].map(|v| v.as_f64().unwrap()), [lo, hi]);
        }
        let normals = glb.elements(accessor(&primitive["attributes"]["NORMAL"]));
        assert_eq!(normals.len(), points.len());
        for n in normals.into_iter().map(vector) {
            assert!((n.iter().map(|v| v * v).sum::<f32>() - 1.0).abs() < 1e-3, "{n:?}");
        }
        let indices = glb.elements(accessor(&primitive["indices"]));
        triangles += indices.len() / 3;
        for index in indices {
            assert_eq!(index.len(), 2, "small meshes have short indices");
            assert!((u16::from_le_bytes([index[0], index[1]]) as usize) < points.len());
        }
        assert!((primitive["material"].as_u64().unwrap() as usize) < glb.list("materials").len());
    }
    assert!(triangles > 500);
}

#[test]
fn colours_are_linear_and_glass_is_blended() {
    let glb = read();
    let named = |start: &str| {
        glb.list("materials").iter().find(|m| m["name"].as_str().unwrap().starts_with(start)).unwrap().clone()
    };
    let glass = named("glass-");
    assert_eq!(glass["alphaMode"], "BLEND");
    assert!(glass["pbrMetallicRoughness"]["baseColorFactor"][3].as_f64().unwrap() < 1.0);
    // The chairs are 000080: 0x80 is 0.2159 in linear light, as the mean of colour and texture.
    let blue = glb.list("materials").iter().find(|m| m["name"].as_str().unwrap().ends_with("-000080")).unwrap();
    let factor = blue["pbrMetallicRoughness"]["baseColorFactor"][2].as_f64().unwrap();
    let texture = Texture::all().find(|t| named_texture(&glb, blue) == t.name()).unwrap();
    assert!((factor * f64::from(texture.pixels().mean[2]) - 0.215861).abs() < 1e-6, "{factor}");
}

/// The kind of texture that a material's colour has: its picture is called `weave_color`.
fn named_texture(glb: &Glb, material: &Value) -> String {
    let texture = material["pbrMetallicRoughness"]["baseColorTexture"]["index"].as_u64().unwrap() as usize;
    let image = glb.list("textures")[texture]["source"].as_u64().unwrap() as usize;
    let name = glb.list("images")[image]["name"].as_str().unwrap();
    name.strip_suffix("_color").unwrap().to_owned()
}

#[test]
fn a_set_of_pictures_for_each_kind_of_texture_and_a_place_on_it_for_each_vertex() {
    let glb = read();
    let names: Vec<&str> = glb.list("images").iter().map(|i| i["name"].as_str().unwrap()).collect();
    let kinds: Vec<&str> = names.iter().filter_map(|n| n.strip_suffix("_color")).collect();
    assert!(kinds.contains(&"boards") && kinds.contains(&"plaster") && kinds.contains(&"wood"), "{kinds:?}");
    assert_eq!(names.len(), 3 * kinds.len(), "three pictures each, and none twice: {names:?}");
    let mut bytes = 0;
    for image in glb.list("images") {
        let view = &glb.json["bufferViews"][image["bufferView"].as_u64().unwrap() as usize];
        let number = |key: &str| view[key].as_u64().unwrap() as usize;
        let png = &glb.binary[number("byteOffset")..number("byteOffset") + number("byteLength")];
        let info = png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap().info().size();
        assert!(info.0 * info.1 <= 512 * 256, "{info:?}");
        bytes += png.len();
    }
    assert!(bytes < 1_500_000, "{bytes}");
    for primitive in glb.list("meshes").iter().flat_map(|m| m["primitives"].as_array().unwrap()) {
        let material = &glb.list("materials")[primitive["material"].as_u64().unwrap() as usize];
        let attributes = &primitive["attributes"];
        let textured = material.get("normalTexture").is_some();
        assert_eq!([attributes["TEXCOORD_0"].is_u64(), attributes["TANGENT"].is_u64()], [textured; 2], "{material}");
        let count = |key: &str| &glb.json["accessors"][attributes[key].as_u64().unwrap() as usize]["count"];
        assert!(!textured || count("TEXCOORD_0") == count("POSITION"));
    }
}

#[test]
fn a_lamp_shines_where_it_stands_and_its_room_has_no_other_light() {
    let mut parts = crate::fixture::parts();
    let table = parts.program.objects.iter_mut().find(|o| o.name == "balloon").unwrap();
    table.category = "floor lamp".into();
    let scene = parts.build().unwrap();
    let lamps: Vec<&str> = scene.lamps.iter().map(|l| l.name.as_str()).collect();
    assert_eq!(lamps, ["balloon/light", "den/lamp"]);
    let (lamp, object) = (&scene.lamps[0], &scene.objects[scene.lamps[0].object.unwrap()]);
    assert!((lamp.pos - object.place.pos).norm() < 0.5 && lamp.candela > 10.0 && lamp.color[0] > lamp.color[2]);
    let bytes = bytes(&scene).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let json: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    let nodes = json["nodes"].as_array().unwrap();
    let own = nodes.iter().find(|n| n["extras"]["scenelang"]["id"] == "balloon").unwrap();
    let child = own["children"][0].as_u64().unwrap();
    assert_eq!(nodes[child as usize]["name"], "balloon/light");
    assert!(!json["scenes"][0]["nodes"].as_array().unwrap().iter().any(|n| n.as_u64() == Some(child)));
}
