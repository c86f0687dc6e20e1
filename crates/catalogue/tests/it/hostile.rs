//! Files that nobody should trust: one diagnosis each, and the others are still read.

use crate::made::{Mesh, block, glb, write};
use flate2::Compression;
use flate2::write::GzEncoder;
use proptest::prelude::*;
use scenelang_catalogue::{Catalogue, limits};
use serde_json::{Value, json};
use std::fs;
use std::io::Write;
use tempfile::tempdir;

/// A GLB file with its document changed.
fn changed(by: impl FnOnce(&mut Value)) -> Vec<u8> {
    let (mut document, binary) = block(1.0, 1.0, 1.0).document();
    by(&mut document);
    glb(&document, &binary)
}

#[test]
fn each_file_that_cannot_be_used_is_one_diagnosis() {
    let good = block(1.0, 1.0, 1.0).glb();
    let strange = |at: usize, x: f32| {
        let mut mesh = block(1.0, 1.0, 1.0);
        mesh.positions[at][1] = x;
        mesh.glb()
    };
    let rows: Vec<(&str, Vec<u8>, &str)> = vec![
        ("empty", Vec::new(), "E0701 it is not a GLB file"),
        ("text", b"solid".to_vec(), "E0701 it is not a GLB file"),
        ("header", good[..10].to_vec(), "E0701 it ends within its header"),
        ("truncated", good[..good.len() - 7].to_vec(), "E0701 it is truncated: it declares 700 bytes, but has 693"),
        ("nan", strange(3, f32::NAN), "E0701 it has a vertex whose coordinates are not finite"),
        ("infinite", strange(3, f32::INFINITY), "E0701 it has a vertex whose coordinates are not finite"),
        ("far", strange(3, 1e30), "E0702 a vertex is 1.0e30 from the origin; the maximum is 10000"),
        ("no_triangles", changed(|d| d["accessors"][1]["count"] = json!(0)), "E0704 it has no triangles"),
        ("a_point", block(1.0, 1.0, 1.0).map(|_| [1.0; 3]).glb(), "E0704 all its triangles have zero area"),
        ("no_scene", changed(|d| d["scenes"] = json!([])), "E0701 it has no scene"),
        ("points", changed(|d| d["meshes"][0]["primitives"][0]["mode"] = json!(0)), "E0704 it has no triangles"),
        (
            "claim",
            changed(|d| d["buffers"][0]["byteLength"] = json!(10_000_000_000_u64)),
            "E0702 it declares a buffer of 9536 MB; the maximum is 64 MB",
        ),
        (
            "count",
            changed(|d| d["accessors"][0]["count"] = json!(u64::MAX)),
            "E0701 it declares 18446744073709551615 numbers, but there are fewer",
        ),
        (
            "many",
            changed(|d| d["accessors"][1]["count"] = json!(4_000_000_000_u64)),
            "E0701 it declares 4000000000 numbers, but there are fewer",
        ),
        (
            "stride",
            changed(|d| d["bufferViews"][0]["byteStride"] = json!(0)),
            "E0701 its numbers are 0 bytes apart, but 12 bytes long",
        ),
        (
            "view",
            changed(|d| d["bufferViews"][0]["byteOffset"] = json!(u64::MAX)),
            "E0701 it refers to bytes beyond its buffer",
        ),
        (
            "external",
            changed(|d| d["buffers"][0]["uri"] = json!("mesh.bin")),
            "E0703 it has a buffer that is not in the file",
        ),
        (
            "picture",
            changed(|d| d["images"] = json!([{ "uri": "a/%2e%2e/../../key.png" }])),
            "E0703 it refers to an image outside its folder: a/%2e%2e/../../key.png",
        ),
        (
            "address",
            changed(|d| d["images"] = json!([{ "uri": "http://a.example/x" }])),
            "E0703 it refers to an image outside its folder: http://a.example/x",
        ),
        (
            "circle",
            changed(|d| d["nodes"][0]["children"] = json!([0])),
            "E0702 its nodes are nested more than 64 levels deep",
        ),
        (
            "copies",
            changed(|d| {
                d["nodes"] =
                    (0..16).map(|i| json!({ "mesh": 0, "children": [i + 1, i + 1] })).chain([json!({})]).collect()
            }),
            "E0702 it has more than 10000 nodes",
        ),
        (
            "corner",
            Mesh { positions: vec![[0.0; 3]; 3], indices: vec![0, 1, 9] }.glb(),
            "E0701 a triangle has a corner that is not one of the 3 vertices",
        ),
        (
            "draco",
            changed(|d| d["extensionsRequired"] = json!(["KHR_draco_mesh_compression"])),
            "E0701 it requires the extension KHR_draco_mesh_compression, which is not supported",
        ),
        (
            "sparse",
            changed(|d| d["accessors"][0]["sparse"] = json!({})),
            "E0701 it has sparse accessors, which are not supported",
        ),
        (
            "types",
            changed(|d| d["nodes"] = json!("none")),
            "E0701 its JSON is not valid glTF: invalid type: string \"none\", expected a sequence",
        ),
        (
            "rotation",
            changed(|d| d["nodes"][0]["rotation"] = json!([0, 0, 0, 0])),
            "E0701 a node has an invalid rotation",
        ),
    ];
    for (name, bytes, wanted) in rows {
        let folder = tempdir().unwrap();
        write(folder.path(), "a.glb", &good, &Value::Null);
        write(folder.path(), &format!("{name}.glb"), &bytes, &Value::Null);
        write(folder.path(), "z.glb", &good, &Value::Null);
        let found = Catalogue::open(folder.path()).unwrap();
        let files: Vec<&str> = found.entries.iter().map(|e| e.file.as_str()).collect();
        assert_eq!(files, ["a.glb", "z.glb"], "{name}");
        let [refused] = found.refused.as_slice() else { panic!("{name}: {:?}", found.refused) };
        assert_eq!(refused.file, format!("{name}.glb"));
        let said = format!("{} {}", refused.finding.code, refused.finding.message);
        assert!(said.starts_with(wanted), "{name}: {said}");
    }
}

#[test]
fn obj_files_and_cards_are_not_trusted_either() {
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (name, text, card, wanted) in [
        (
            "face",
            format!("{cube}f 1 2 9\n"),
            Value::Null,
            "E0701 it is not a valid OBJ file: face vertex index out of bounds",
        ),
        (
            "nan",
            "v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".into(),
            Value::Null,
            "E0701 it has a vertex whose coordinates are not finite",
        ),
        ("none", cube.into(), Value::Null, "E0704 it has no triangles"),
        ("line", format!("{cube}f 1 1 1\n"), Value::Null, "E0704 all its triangles have zero area"),
        (
            "above",
            format!("mtllib ../secret.mtl\n{cube}f 1 2 3\n"),
            Value::Null,
            "E0703 it leads outside of its folder",
        ),
        (
            "absolute",
            format!("mtllib /etc/passwd\n{cube}f 1 2 3\n"),
            Value::Null,
            "E0703 it leads outside of its folder",
        ),
        (
            "card",
            format!("{cube}f 1 2 3\n"),
            json!([1]),
            "E0705 its card card.json cannot be used: invalid type: integer `1`",
        ),
    ] {
        let folder = tempdir().unwrap();
        let own = folder.path().join("models");
        fs::write(folder.path().join("secret.mtl"), "newmtl a\nKd 1 0 0\n").unwrap();
        write(&own, &format!("{name}.obj"), text.as_bytes(), &card);
        write(&own, "z.glb", &block(1.0, 1.0, 1.0).glb(), &Value::Null);
        let found = Catalogue::open(&own).unwrap();
        let [refused] = found.refused.as_slice() else { panic!("{name}: {:?}", found.refused) };
        let said = format!("{} {}", refused.finding.code, refused.finding.message);
        assert!(said.starts_with(wanted), "{name}: {said}");
        assert_eq!(found.entries.len(), 1);
    }
}

#[cfg(unix)]
#[test]
fn links_out_of_the_folder_are_refused() {
    let folder = tempdir().unwrap();
    let own = folder.path().join("models");
    write(folder.path(), "secret.glb", &block(1.0, 1.0, 1.0).glb(), &Value::Null);
    write(&own, "z.glb", &block(1.0, 1.0, 1.0).glb(), &Value::Null);
    std::os::unix::fs::symlink("../secret.glb", own.join("link.glb")).unwrap();
    std::os::unix::fs::symlink("../", own.join("circle")).unwrap();
    let found = Catalogue::open(&own).unwrap();
    assert_eq!((found.entries.len(), found.refused.len()), (1, 1));
    assert_eq!((found.refused[0].file.as_str(), found.refused[0].finding.code.as_str()), ("link.glb", "E0703"));
}

#[test]
fn what_is_packed_is_unpacked_up_to_a_limit() {
    let folder = tempdir().unwrap();
    let mut bomb = GzEncoder::new(Vec::new(), Compression::fast());
    let blanks = vec![b' '; 1 << 20];
    (0..=limits::UNPACKED >> 20).for_each(|_| bomb.write_all(&blanks).unwrap());
    let bomb = bomb.finish().unwrap();
    assert!(bomb.len() < 4 << 20);
    let annotations = json!({ "aa": {}, "bb": {} });
    fs::write(folder.path().join("annotations.json"), annotations.to_string()).unwrap();
    write(folder.path(), "assets/aa/aa.json.gz", &bomb, &Value::Null);
    write(folder.path(), "assets/bb/bb.json.gz", &bomb[..1000], &Value::Null);
    let found = Catalogue::open(folder.path()).unwrap();
    let said: Vec<String> = found.entries.iter().map(|e| found.model(e).unwrap_err().message).collect();
    assert_eq!(said[0], "unpacked, it is larger than 256 MB");
    assert!(said[1].starts_with("it cannot be unpacked: "), "{}", said[1]);
    fs::write(folder.path().join("annotations.json"), &bomb).unwrap();
    assert_eq!(Catalogue::open(folder.path()).unwrap_err().code.as_str(), "E0702");
}

#[test]
fn folders_without_models_say_so() {
    let folder = tempdir().unwrap();
    let said = |name: &str| Catalogue::open(&folder.path().join(name)).unwrap_err().message;
    assert_eq!(said("none"), "there is no such folder");
    fs::write(folder.path().join("file"), "").unwrap();
    assert_eq!(said("file"), "it is not a folder");
    assert_eq!(said("."), "there is no .glb and no .obj file in it");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Whatever becomes of the bytes of a file, it is read or refused.
    #[test]
    fn changed_bytes_do_no_harm(changes in prop::collection::vec((0_usize..700, any::<u8>()), 1..8), end in 600_usize..720) {
        let mut bytes = block(1.0, 1.0, 1.0).glb();
        changes.into_iter().for_each(|(at, byte)| bytes[at] = byte);
        bytes.truncate(end);
        let folder = tempdir().unwrap();
        write(folder.path(), "it.glb", &bytes, &Value::Null);
        let found = Catalogue::open(folder.path()).unwrap();
        prop_assert_eq!(found.entries.len() + found.refused.len(), 1);
    }
}
