//! Importing: what is written is what was read, and reads as such.

use crate::made::{block, card, furniture, write};
use scenelang_base::codes;
use scenelang_catalogue::{Catalogue, check, import};
use scenelang_layout::Vec3;
use serde_json::json;
use std::fs;
use tempfile::tempdir;

#[test]
fn a_catalogue_reads_as_what_was_imported() {
    let folder = tempdir().unwrap();
    let from = folder.path().join("from");
    // Z up, in millimetres, seen from behind, below the floor: all that can be wrong.
    let odd = block(500.0, 900.0, 400.0).map(|[x, y, z]| [x + 30.0, -z, y - 70.0]);
    let said = json!({ "category": "chair", "size": [0.5, 0.9, 0.4], "up": "z", "front": "+y", "licence": "CC0-1.0" });
    write(&from, "odd.glb", &odd.glb(), &said);
    let shelf = furniture("bookshelf");
    write(&from, "deep/shelf.glb", &crate::made::Mesh::of(&shelf).glb(), &card("bookshelf", &shelf.size));
    write(&from, "short.glb", &block(1.0, 1.0, 1.0).glb()[..99], &json!(null));
    let tent = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    fs::write(from.join("odd.obj"), tent).unwrap();
    fs::write(from.join("bare.obj"), tent).unwrap();
    let imported = import(&from).unwrap();
    let files: Vec<(&str, Result<&str, _>)> = imported
        .iter()
        .map(|i| (i.file.as_str(), i.outcome.as_ref().map(|k| k.name.as_str()).map_err(|d| d.code)))
        .collect();
    let wanted = [
        ("bare.obj", Ok("bare.glb")),
        ("deep/shelf.glb", Ok("deep/shelf.glb")),
        ("odd.glb", Ok("odd.glb")),
        ("odd.obj", Ok("odd-2.glb")),
        ("short.glb", Err(codes::E0701)),
    ];
    assert_eq!(files, wanted);
    let to = folder.path().join("to");
    for kept in imported.iter().filter_map(|i| i.outcome.as_ref().ok()) {
        write(&to, &kept.name, &kept.glb, &kept.card);
    }
    let (before, after) = (Catalogue::open(&from).unwrap(), Catalogue::open(&to).unwrap());
    let model = |catalogue: &Catalogue, file: &str| {
        let entry = catalogue.entries.iter().find(|e| e.file == file).unwrap();
        catalogue.model(entry).unwrap()
    };
    for (a, b) in [
        ("bare.obj", "bare.glb"),
        ("deep/shelf.glb", "deep/shelf.glb"),
        ("odd.glb", "odd.glb"),
        ("odd.obj", "odd-2.glb"),
    ] {
        let (a, b) = (model(&before, a), model(&after, b));
        assert!((a.size - b.size).amax() < 1e-6 && b.origin.base.abs() < 1e-6, "{}", b.file);
        assert_eq!((a.parts.len(), a.triangles(), a.card.licence), (b.parts.len(), b.triangles(), b.card.licence));
        let (Some((p, q)), Some((r, s))) = (a.mesh.bounds(), b.mesh.bounds()) else { panic!() };
        assert!((p - r).amax() < 1e-5 && (q - s).amax() < 1e-5, "{}", b.file);
    }
    // What was said is said, and what nobody knows is still asked for.
    let codes: Vec<(String, Vec<&str>)> = check(&to, &|_| Some(Vec3::repeat(1.0)))
        .unwrap()
        .into_iter()
        .map(|c| (c.file, c.findings.iter().map(|d| d.code.as_str()).collect()))
        .collect();
    let none = Vec::new;
    let wanted =
        [("bare.glb", vec!["W0703", "W0707"]), ("deep/shelf.glb", none()), ("odd-2.glb", none()), ("odd.glb", none())];
    assert_eq!(codes, wanted.map(|(file, codes)| (file.to_owned(), codes)));
}
