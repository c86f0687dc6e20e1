//! How fast models are indexed and found: `cargo bench -p scenelang-catalogue --features services`. A folder of small GLB
//! files with cards is opened, which reads every file; and a folder of objathor with 50,000 objects is searched by words and
//! by features. Everything runs on one core.

use scenelang_catalogue::{Catalogue, Index};
use scenelang_layout::Vec3;
use serde_json::{Map, Value, json};
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

const SMALL: usize = 2_000;
const LARGE: usize = 50_000;
/// Extents of features as of ViT-L/14 and all-mpnet-base-v2, and views of each model.
const VIEWS: usize = 3;
const WIDTH: usize = 768;

const KINDS: [&str; 20] = [
    "chair",
    "table",
    "sofa",
    "bookshelf",
    "floor lamp",
    "bed",
    "wardrobe",
    "desk",
    "rug",
    "mirror",
    "stool",
    "cabinet",
    "dresser",
    "nightstand",
    "bench",
    "plant",
    "vase",
    "clock",
    "fridge",
    "sink",
];
const COLOURS: [&str; 10] = ["red", "green", "blue", "yellow", "black", "white", "brown", "gray", "pink", "orange"];
const STUFFS: [&str; 5] = ["oak", "walnut", "steel", "brass", "leather"];
const STYLES: [&str; 5] = ["rustic", "modern", "baroque", "nordic", "industrial"];

fn described(i: usize) -> Value {
    let (kind, colour) = (KINDS[i % 20], COLOURS[i / 20 % 10]);
    let (stuff, style) = (STUFFS[i / 200 % 5], STYLES[i / 1000 % 5]);
    let description = format!("a {style} {colour} {kind} with some details, number {i}");
    json!({ "category": kind, "description": description, "materials": [stuff], "synset": format!("{kind}.n.01"),
            "width": 50 + i % 100, "height": 90, "depth": 50 })
}

/// A tetrahedron as a GLB file.
fn tetrahedron() -> Vec<u8> {
    let positions: [f32; 12] = [0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.5];
    let indices: [u32; 12] = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
    let mut binary: Vec<u8> = positions.iter().flat_map(|x| x.to_le_bytes()).collect();
    binary.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
    let document = json!({
        "asset": { "version": "2.0" }, "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
        "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" },
                      { "bufferView": 1, "componentType": 5125, "count": 12, "type": "SCALAR" }],
        "bufferViews": [{ "buffer": 0, "byteOffset": 0, "byteLength": 48 }, { "buffer": 0, "byteOffset": 48, "byteLength": 48 }],
        "buffers": [{ "byteLength": 96 }],
    });
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = |n: usize| (n as u32).to_le_bytes();
    let (text_length, all) = (length(text.len()), length(12 + 8 + text.len() + 8 + binary.len()));
    [
        b"glTF",
        2_u32.to_le_bytes().as_slice(),
        &all,
        &text_length,
        b"JSON",
        &text,
        &length(binary.len()),
        b"BIN\0",
        &binary,
    ]
    .concat()
}

fn time<T>(what: impl FnOnce() -> T) -> (T, Duration) {
    let since = Instant::now();
    let found = what();
    (found, since.elapsed())
}

/// The median time of a query, over many of them.
fn median(count: usize, mut ask: impl FnMut(usize)) -> Duration {
    let mut times: Vec<Duration> = (0..count).map(|i| time(|| ask(i)).1).collect();
    times.sort();
    println!("    slowest {:.2} ms", times[count - 1].as_secs_f64() * 1e3);
    times[count / 2]
}

/// Half-precision features of all objects and of some queries.
fn features(folder: &Path, names: &[String], queries: &[String]) {
    let at = folder.join("features");
    fs::create_dir_all(&at).expect("a folder");
    let mut state = 18_u64;
    let mut file = |name: &str, shape: String, count: usize| {
        let header = format!("{{'descr': '<f2', 'fortran_order': False, 'shape': {shape}, }}\n");
        let mut bytes =
            [b"\x93NUMPY\x01\x00", (header.len() as u16).to_le_bytes().as_slice(), header.as_bytes()].concat();
        for _ in 0..count {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // Sign and fraction are drawn; the exponent is that of numbers from a half to one.
            bytes.extend(((state >> 40) as u16 & 0x83ff | 0x3800).to_le_bytes());
        }
        fs::write(at.join(name), bytes).expect("it can be written");
    };
    let (n, q) = (names.len(), queries.len());
    file("clip_models.npy", format!("({n}, {VIEWS}, {WIDTH})"), n * VIEWS * WIDTH);
    file("sbert_models.npy", format!("({n}, {WIDTH})"), n * WIDTH);
    file("clip_queries.npy", format!("({q}, {WIDTH})"), q * WIDTH);
    file("sbert_queries.npy", format!("({q}, {WIDTH})"), q * WIDTH);
    fs::write(at.join("names.json"), json!(names).to_string()).expect("it can be written");
    fs::write(at.join("queries.json"), json!(queries).to_string()).expect("it can be written");
}

fn main() {
    let folder = tempfile::tempdir().expect("a folder");
    let glb = tetrahedron();
    for i in 0..SMALL {
        let at = folder.path().join(format!("m{i:05}.glb"));
        fs::write(&at, &glb).expect("it can be written");
        fs::write(at.with_extension("json"), described(i).to_string()).expect("it can be written");
    }
    let ((catalogue, index), took) = time(|| {
        let catalogue = Catalogue::open(folder.path()).expect("it can be opened");
        let index = Index::of(&catalogue.entries);
        (catalogue, index)
    });
    assert_eq!(catalogue.entries.len(), SMALL);
    println!("open and index {SMALL} GLB files: {:.0} models/s", SMALL as f64 / took.as_secs_f64());
    let right = (0..SMALL).filter(|i| {
        let said = described(*i);
        let text = format!(
            "{} {}",
            said["description"].as_str().unwrap_or_default(),
            said["materials"][0].as_str().unwrap_or_default()
        );
        index.search(&text, None, 1).first().is_some_and(|hit| hit.entry == *i)
    });
    println!("    recall at 1 of their own descriptions: {:.4}", right.count() as f64 / SMALL as f64);

    let folder = tempfile::tempdir().expect("a folder");
    let mut all = Map::new();
    let names: Vec<String> = (0..LARGE).map(|i| format!("u{i:05}")).collect();
    for (i, name) in names.iter().enumerate() {
        let at = folder.path().join("assets").join(name);
        fs::create_dir_all(&at).expect("a folder");
        fs::write(at.join(format!("{name}.json")), "").expect("it can be written");
        all.insert(name.clone(), described(i));
    }
    fs::write(folder.path().join("annotations.json"), Value::from(all).to_string()).expect("it can be written");
    let (catalogue, opened) = time(|| Catalogue::open(folder.path()).expect("it can be opened"));
    assert_eq!(catalogue.entries.len(), LARGE);
    let (index, indexed) = time(|| Index::of(&catalogue.entries));
    let rate = |took: Duration| LARGE as f64 / took.as_secs_f64();
    println!("open {LARGE} objects: {:.0} models/s; index: {:.0} models/s", rate(opened), rate(indexed));
    let asked = |i: usize| format!("{} {} {}", STYLES[i % 5], COLOURS[i / 5 % 10], KINDS[i * 7 % 20]);
    let took = median(400, |i| {
        black_box(index.search(&asked(i), Some(Vec3::new(0.5, 0.9, 0.5)), 8));
    });
    println!("query by words at {LARGE}: median {:.2} ms", took.as_secs_f64() * 1e3);
    // Words that all models have.
    let took = median(400, |i| {
        let text =
            format!("{} {} with some details, number of {}", STYLES[i % 5], COLOURS[i / 5 % 10], KINDS[i * 7 % 20]);
        black_box(index.search(&text, Some(Vec3::new(0.5, 0.9, 0.5)), 8));
    });
    println!("query by words that all have: median {:.2} ms", took.as_secs_f64() * 1e3);

    let queries: Vec<String> = (0..40).map(asked).collect();
    features(folder.path(), &names, &queries);
    let (catalogue, took) = time(|| Catalogue::open(folder.path()).expect("it can be opened"));
    let features = catalogue.features.as_ref().expect("they can be used");
    println!(
        "open with features, and make {} queries ready: {:.1} s, {:.0} models/s",
        queries.len(),
        took.as_secs_f64(),
        rate(took)
    );
    let took = median(40, |i| {
        black_box(features.search(&catalogue.entries, &queries[i], 8));
    });
    println!("query by features at {LARGE}: median {:.1} ms", took.as_secs_f64() * 1e3);
}
