//! What a scene of 50 objects costs: making their furniture, its textures and one GLB file, on one core.
//! `cargo bench -p scenelang-export`. The first scene of a process makes the textures; the others find them made.

use scenelang_assets::{AssetRequest, solid};
use scenelang_base::FileId;
use scenelang_export::{Scene, SceneInput, glb};
use scenelang_lang::{Options, compile_text};
use scenelang_layout::{Vec3, file};
use serde_json::{Map, json};
use std::path::Path;
use std::time::{Duration, Instant};

/// Things of all kinds of textures, as they stand in an office, each with its size.
const KINDS: [(&str, [f64; 3]); 10] = [
    ("desk", [1.4, 0.75, 0.7]),
    ("office chair", [0.6, 1.1, 0.6]),
    ("sofa", [2.0, 0.85, 0.9]),
    ("bookshelf", [0.9, 2.0, 0.35]),
    ("plant", [0.5, 1.2, 0.5]),
    ("rug", [2.0, 0.01, 1.4]),
    ("filing cabinet", [0.4, 1.3, 0.5]),
    ("round table", [1.0, 0.75, 1.0]),
    ("floor lamp", [0.4, 1.7, 0.4]),
    ("armchair", [0.9, 0.9, 0.9]),
];
const OBJECTS: usize = 50;

struct Office {
    program: String,
    places: String,
}

/// A room with the objects in rows, where their solids are not written in the layout.
fn office() -> Office {
    let mut program = String::from("region room; room.floorMaterial <- \"oak\"; room.wallMaterial <- \"tiles\";\n");
    let mut objects = Map::new();
    for i in 0..OBJECTS {
        let (kind, size) = KINDS[i % KINDS.len()];
        let color = ["white", "navy", "green", "brown", "gray"][i / KINDS.len()];
        program += &format!("object o{i}; o{i}.category <- \"{kind}\"; o{i}.color <- \"{color}\";\n");
        let pos = [3.0 * (i % 8) as f64 - 10.0, 0.0, 3.0 * (i / 8) as f64 - 9.0];
        objects.insert(format!("o{i}"), json!({ "pos": pos, "rot": [0, 0, 0], "scale": size }));
    }
    let regions = json!({ "room": { "pos": [0, 0, 0], "scale": [24, 3, 24] } });
    let places = json!({ "format": "scenelang.layout/1", "objects": objects, "regions": regions });
    Office { program, places: places.to_string() }
}

/// The size of the file, and how long its solids, the scene and the file took to make.
fn made(office: &Office) -> (usize, [Duration; 3]) {
    let compiled = compile_text("office.scene", Path::new("office.scene"), &office.program, Options::default());
    let program = compiled.program.expect("it has no errors");
    let mut layout = file::read(&office.places, FileId(0)).layout;
    let report = json!({ "eta": 0.03, "constraints": [] });
    let since = Instant::now();
    for (object, (_, place)) in program.objects.iter().zip(&mut layout.objects) {
        let size: Option<Vec3> = Some(place.scale);
        let (name, category) = (object.name.as_str(), object.category.as_str());
        place.parts = solid(&AssetRequest { name, category, size, ..AssetRequest::default() }).parts;
    }
    let furnished = since.elapsed();
    let scene = Scene::build(&SceneInput {
        name: "office",
        program: &program,
        sources: &compiled.sources,
        files: &[compiled.main],
        layout: &layout,
        layout_text: &office.places,
        report: &report,
    });
    let scene = scene.expect("everything is placed");
    let built = since.elapsed();
    let bytes = glb::bytes(&scene).expect("it is small");
    (bytes.len(), [furnished, built - furnished, since.elapsed() - built])
}

fn main() {
    let office = office();
    let (size, first) = made(&office);
    let mut others: Vec<[Duration; 3]> = (0..20).map(|_| made(&office).1).collect();
    others.sort_by_key(|times| times.iter().sum::<Duration>());
    let ms = |times: [Duration; 3]| {
        let [solids, scene, file] = times.map(|time| time.as_secs_f64() * 1e3);
        format!("{:.1} ms (solids {solids:.1}, scene {scene:.1}, file {file:.1})", solids + scene + file)
    };
    println!("{OBJECTS} objects with textures, {:.0} KB", size as f64 / 1e3);
    println!("    the first scene: {}", ms(first));
    println!("    another one: {}", ms(others[10]));
}
