//! The chain of providers: who is asked, what is given at which size, and why the ones before passed.

use crate::made::{block, usual, write};
use flate2::Compression;
use flate2::write::GzEncoder;
use scenelang_catalogue::{AssetProvider, Boxed, Chain, Choice, Library, Local, Query, Why};
use scenelang_layout::{Aabb, Convex, Vec3};
use serde_json::{Value, json};
use std::io::Read;
use tempfile::{TempDir, tempdir};

/// A query for a thing of a category.
fn query(category: &str, size: Option<[f64; 3]>) -> Query {
    Query {
        name: "it".to_owned(),
        what: category.to_owned(),
        category: category.to_owned(),
        size: size.map(Vec3::from),
        usual: usual(category),
        ..Query::default()
    }
}

fn shop() -> TempDir {
    let folder = tempdir().unwrap();
    let card = |category: &str, description: &str| json!({ "category": category, "description": description });
    write(folder.path(), "chair.glb", &block(0.5, 0.9, 0.5).glb(), &card("chair", "a plain chair"));
    write(folder.path(), "red.glb", &block(0.5, 0.9, 0.5).glb(), &card("chair", "a red chair"));
    write(folder.path(), "sofa.glb", &block(2.0, 0.8, 0.9).glb(), &card("couch", "three seats"));
    write(folder.path(), "lamp.glb", &block(20.0, 45.0, 20.0).glb(), &card("desk lamp", "in centimetres"));
    folder
}

fn chain(folder: &TempDir, least: f64) -> Chain {
    let local = Local::open(folder.path(), "models", Some(least)).unwrap();
    Chain::new(vec![Box::new(local), Box::new(Library)])
}

fn one(chain: &Chain, query: Query) -> Choice {
    chain.choose(&[query], &mut |_| {}).remove(0)
}

/// Who gave what, and each remark in a word.
fn told(choice: &Choice) -> String {
    let passed: Vec<String> =
        choice.passed.iter().map(|(who, remark)| format!("{who} {}", remark.why.name())).collect();
    format!("{}:{} [{}]", choice.provider, choice.given.source, passed.join(", "))
}

#[test]
fn each_object_has_what_fits_it_and_says_why_not_the_rest() {
    let folder = shop();
    let chain = chain(&folder, 0.0);
    let red = Query { color: "red".to_owned(), ..query("chair", None) };
    for (query, wanted) in [
        (query("chair", None), "models:chair.glb []"),
        (red, "models:red.glb []"),
        (query("sofa", Some([2.2, 0.8, 0.9])), "models:sofa.glb []"),
        (query("sofa", Some([1.0, 0.8, 0.9])), "library:sofa [models size]"),
        (query("chair", Some([2.5, 4.5, 2.5])), "library:chair [models size, models size]"),
        (query("desk lamp", None), "library:desk_lamp [models size]"),
        (query("table", None), "library:table [models nothing]"),
        (query("gizmo", Some([1.0; 3])), "box:unknown [models nothing, library nothing]"),
    ] {
        let choice = one(&chain, query.clone());
        assert_eq!(told(&choice), wanted, "{query:?}: {:?}", choice.passed);
        let piece = &choice.given.piece;
        if let Some(size) = query.size {
            assert!((piece.size - size).amax() < 1e-9, "{wanted}");
        }
        let corners = piece.parts.iter().filter_map(Convex::from_part).flat_map(|c| c.vertices().to_vec());
        let bounds = Aabb::of(corners);
        assert!((bounds.max - bounds.min - piece.size).amax() < 1e-6 && bounds.min.y.abs() < 1e-6, "{wanted}");
    }
}

#[test]
fn the_order_of_queries_and_of_calls_changes_nothing() {
    let folder = shop();
    let (a, b, c) = (query("chair", None), query("table", None), query("sofa", Some([2.2, 0.8, 0.9])));
    let forth = chain(&folder, 0.0).choose(&[a.clone(), b.clone(), c.clone()], &mut |_| {});
    let back = chain(&folder, 0.0).choose(&[c, b, a], &mut |_| {});
    for (x, y) in forth.iter().zip(back.iter().rev()) {
        assert_eq!(told(x), told(y));
        assert_eq!((&x.given.piece.mesh, &x.given.piece.parts), (&y.given.piece.mesh, &y.given.piece.parts));
    }
    // What is kept is found by who was asked, the words, the sizes, and what it was made from.
    let query = query("chair", None);
    let keys = [
        query.key("a", b""),
        query.key("b", b""),
        query.key("a", b"x"),
        Query { size: usual("chair"), ..query.clone() }.key("a", b""),
        Query { color: "red".to_owned(), ..query.clone() }.key("a", b""),
    ];
    assert!(keys.iter().enumerate().all(|(i, key)| !keys[..i].contains(key)), "{keys:?}");
    assert_eq!(Query { name: "other".to_owned(), ..query }.key("a", b""), keys[0]);
}

#[test]
fn what_scores_too_little_is_not_used() {
    let folder = shop();
    let choice = one(&chain(&folder, 1e6), query("chair", None));
    assert_eq!(told(&choice), "library:chair [models score]");
    assert!(choice.passed[0].1.say.contains("less than 1000000"), "{}", choice.passed[0].1.say);
}

#[test]
fn a_file_that_cannot_be_used_is_told_and_the_next_one_is() {
    let good = block(0.5, 0.9, 0.5);
    let nan = good.clone().map(|[x, y, _]| [x, y, f32::NAN]).glb();
    let nothing = crate::made::Mesh { indices: vec![0, 0, 0], ..good.clone() }.glb();
    let claims = {
        let (mut document, binary) = good.document();
        document["buffers"][0]["byteLength"] = json!(10_000_000_000_u64);
        crate::made::glb(&document, &binary)
    };
    let leads_out = {
        let (mut document, binary) = good.document();
        document["images"] = json!([{ "uri": "../../../etc/passwd" }]);
        crate::made::glb(&document, &binary)
    };
    let short = good.glb()[..40].to_vec();
    for (what, bytes, code) in [
        ("truncated", short, "E0701"),
        ("nan", nan, "E0701"),
        ("claim", claims, "E0702"),
        ("leads_out", leads_out, "E0703"),
        ("no_triangles", nothing, "E0704"),
    ] {
        let folder = tempdir().unwrap();
        let card = json!({ "category": "chair", "description": "the very best chair chair" });
        write(folder.path(), "a.glb", &bytes, &card);
        let broken_only = one(&chain(&folder, 0.0), query("chair", None));
        assert_eq!(told(&broken_only), "library:chair [models broken]", "{what}");
        write(folder.path(), "b.glb", &good.glb(), &Value::Null);
        std::fs::rename(folder.path().join("b.glb"), folder.path().join("chair.glb")).unwrap();
        let choice = one(&chain(&folder, 0.0), query("chair", None));
        assert_eq!(told(&choice), "models:chair.glb [models broken]", "{what}");
        assert_eq!(choice.passed[0].1.code.map(|code| code.as_str().to_owned()).as_deref(), Some(code), "{what}");
        assert_eq!(choice.passed[0].1.why, Why::Broken);
    }
}

/// Packed, it is a few kilobytes; unpacked, more than is read.
#[test]
fn what_unpacks_without_end_is_told_and_the_next_one_is_used() {
    let packed = |bytes: &mut dyn Read| {
        let mut out = GzEncoder::new(Vec::new(), Compression::fast());
        std::io::copy(bytes, &mut out).unwrap();
        out.finish().unwrap()
    };
    let bomb = packed(&mut std::io::repeat(b' ').take(300 << 20));
    assert!(bomb.len() < 4 << 20, "{}", bomb.len());
    let folder = tempdir().unwrap();
    write(folder.path(), "assets/aa/aa.json.gz", &bomb, &Value::Null);
    let all = |second: Value| json!({ "aa": { "category": "chair", "description": "chair chair" }, "bb": second });
    let save = |all: Value| std::fs::write(folder.path().join("annotations.json"), all.to_string()).unwrap();
    save(all(json!({ "category": "lamp" })));
    assert_eq!(told(&one(&chain(&folder, 0.0), query("chair", None))), "library:chair [models broken]");
    let mesh = block(0.5, 0.9, 0.5);
    let corners: Vec<Value> = mesh.positions.iter().map(|[x, y, z]| json!({ "x": -x, "y": y, "z": z })).collect();
    let triangles: Vec<u32> = mesh.indices.chunks_exact(3).flat_map(|t| [t[0], t[2], t[1]]).collect();
    let asset = json!({ "vertices": corners, "triangles": triangles });
    let asset = packed(&mut asset.to_string().as_bytes());
    write(folder.path(), "assets/bb/bb.json.gz", &asset, &Value::Null);
    save(all(json!({ "category": "chair", "description": "a chair of another kind" })));
    let choice = one(&chain(&folder, 0.0), query("chair", None));
    assert_eq!(told(&choice), "models:assets/bb/bb.json.gz [models broken]");
    assert_eq!(choice.passed[0].1.code.map(|code| code.as_str().to_owned()).as_deref(), Some("E0702"));
}

#[test]
fn the_box_is_always_there() {
    let choice = one(&Chain::new(Vec::new()), query("chair", Some([1.0, 2.0, 3.0])));
    assert_eq!(told(&choice), "box:unknown []");
    assert_eq!(choice.given.piece.size, Vec3::new(1.0, 2.0, 3.0));
    assert_eq!(Boxed.name(), "box");
}
