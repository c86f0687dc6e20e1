//! Features that were computed before: the published score against a plain reference, and files that cannot be used.

use crate::made::{block, usual, write};
use scenelang_catalogue::{AssetProvider, Catalogue, Chain, Library, Local, Query, Reply, TAU, published_score};
use scenelang_layout::Vec3;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::{TempDir, tempdir};

/// Random numbers, the same on every machine.
struct Random(u64);

impl Random {
    /// From -1 to 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
    fn list(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.next()).collect()
    }
}

/// A file as `numpy.save` writes it, of numbers in single precision.
fn npy(shape: &str, numbers: &[f64]) -> Vec<u8> {
    let header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}\n");
    let data: Vec<u8> = numbers.iter().flat_map(|x| (*x as f32).to_le_bytes()).collect();
    [b"\x93NUMPY\x01\x00", (header.len() as u16).to_le_bytes().as_slice(), header.as_bytes(), &data].concat()
}

/// Features of models with three views each, and of queries.
struct Given {
    clip: [Vec<f64>; 2],
    sbert: [Vec<f64>; 2],
}

const VIEWS: usize = 3;
const CLIP: usize = 40;
const SBERT: usize = 24;

fn save(folder: &Path, names: &[String], queries: &[String], random: &mut Random) -> Given {
    let (n, q) = (names.len(), queries.len());
    let given = Given {
        clip: [random.list(n * VIEWS * CLIP), random.list(q * CLIP)],
        sbert: [random.list(n * SBERT), random.list(q * SBERT)],
    };
    let at = folder.join("features");
    fs::create_dir_all(&at).unwrap();
    fs::write(at.join("names.json"), json!(names).to_string()).unwrap();
    fs::write(at.join("queries.json"), json!(queries).to_string()).unwrap();
    fs::write(at.join("clip_models.npy"), npy(&format!("({n}, {VIEWS}, {CLIP})"), &given.clip[0])).unwrap();
    fs::write(at.join("clip_queries.npy"), npy(&format!("({q}, {CLIP})"), &given.clip[1])).unwrap();
    fs::write(at.join("sbert_models.npy"), npy(&format!("({n}, {SBERT})"), &given.sbert[0])).unwrap();
    fs::write(at.join("sbert_queries.npy"), npy(&format!("({q}, {SBERT})"), &given.sbert[1])).unwrap();
    given
}

/// The score as the paper has it, from the numbers alone.
fn reference(given: &Given, model: usize, query: usize) -> f64 {
    let cosine = |a: &[f64], b: &[f64]| {
        let (mut ab, mut aa, mut bb) = (0.0, 0.0, 0.0);
        for (x, y) in a.iter().zip(b) {
            ab += x * y;
            aa += x * x;
            bb += y * y;
        }
        ab / (aa.sqrt() * bb.sqrt())
    };
    let mut visual = f64::NEG_INFINITY;
    for view in 0..VIEWS {
        let from = (model * VIEWS + view) * CLIP;
        let cos = cosine(&given.clip[0][from..from + CLIP], &given.clip[1][query * CLIP..(query + 1) * CLIP]);
        visual = visual.max((1.0 + cos) / 2.0);
    }
    let from = model * SBERT;
    let cos = cosine(&given.sbert[0][from..from + SBERT], &given.sbert[1][query * SBERT..(query + 1) * SBERT]);
    (100.0 * visual + (1.0 + cos) / 2.0) / 101.0
}

fn query(category: &str) -> Query {
    Query {
        name: "it".into(),
        what: category.into(),
        category: category.into(),
        usual: usual(category),
        ..Query::default()
    }
}

/// A folder of chairs, and their names.
fn chairs(count: usize) -> (TempDir, Vec<String>) {
    let folder = tempdir().unwrap();
    let names: Vec<String> = (0..count).map(|i| format!("m{i:03}.glb")).collect();
    for name in &names {
        write(folder.path(), name, &block(0.5, 0.9, 0.5).glb(), &json!({ "category": "chair" }));
    }
    (folder, names)
}

#[test]
fn the_score_is_the_published_one() {
    let (folder, names) = chairs(120);
    let queries: Vec<String> = (0..20).map(|i| format!("a 3D model of a chair that is {i}")).collect();
    let given = save(folder.path(), &names, &queries, &mut Random(18));
    let catalogue = Catalogue::open(folder.path()).unwrap();
    assert!(catalogue.refused.is_empty(), "{:?}", catalogue.refused);
    let features = catalogue.features.as_ref().unwrap();
    for (q, text) in queries.iter().enumerate() {
        let mut plain: Vec<(usize, f64)> = (0..names.len()).map(|m| (m, reference(&given, m, q))).collect();
        plain.sort_by(|a, b| b.1.total_cmp(&a.1));
        let found = features.search(&catalogue.entries, text, usize::MAX).unwrap();
        assert_eq!(found.len(), names.len());
        for (hit, (model, score)) in found.iter().zip(&plain) {
            let own = features.score(text, &names[*model]).unwrap();
            assert!((own - score).abs() < 1e-5 && (hit.score - score).abs() < 1e-5, "{own} {hit:?} {score}");
        }
        assert_eq!(found[0].entry, plain[0].0, "{text}");
    }
    assert_eq!(features.score("another query", &names[0]), None);
    assert_eq!(features.score(&queries[0], "another model"), None);
    assert!(features.search(&catalogue.entries, "another query", 1).is_none());
    assert!((published_score(0.7, 0.2) - 70.2 / 101.0).abs() < 1e-12);
}

#[test]
fn queries_have_the_published_form() {
    let full =
        Query { color: "red".into(), material: "oak".into(), features: "round, tall".into(), ..query("coffee table") };
    assert_eq!(full.published(), "a 3D model of a red coffee table made with oak that is round, tall");
    assert_eq!(query("chair").published(), "a 3D model of a chair");
    assert_eq!(Query { features: "tall".into(), ..query("chair") }.published(), "a 3D model of a chair that is tall");
}

/// Two chairs and a table of which the vectors say how like a chair they are, by the angle to it.
fn told(degrees: [f64; 3], least: Option<f64>) -> (TempDir, Local) {
    let folder = tempdir().unwrap();
    for (i, category) in ["chair", "chair", "table"].iter().enumerate() {
        write(folder.path(), &format!("{i}.glb"), &block(0.5, 0.9, 0.5).glb(), &json!({ "category": category }));
    }
    let at = folder.path().join("features");
    fs::create_dir_all(&at).unwrap();
    let vectors: Vec<f64> = degrees.iter().flat_map(|d| [d.to_radians().cos(), d.to_radians().sin()]).collect();
    for name in ["clip", "sbert"] {
        fs::write(at.join(format!("{name}_models.npy")), npy("(3, 2)", &vectors)).unwrap();
        fs::write(at.join(format!("{name}_queries.npy")), npy("(1, 2)", &[1.0, 0.0])).unwrap();
    }
    fs::write(at.join("names.json"), "[\"0.glb\", \"1.glb\", \"2.glb\"]").unwrap();
    fs::write(at.join("queries.json"), "[\"a 3D model of a chair\"]").unwrap();
    let local = Local::open(folder.path(), "models", least).unwrap();
    (folder, local)
}

fn answer(local: &Local, category: &str) -> String {
    let reply: Reply = local.provide(&[&query(category)], &mut |_| {}).remove(0);
    let said: Vec<&str> = reply.remarks.iter().map(|r| r.why.name()).collect();
    format!("{} [{}]", reply.given.map_or_else(String::new, |g| g.source), said.join(", "))
}

#[test]
fn the_published_score_and_threshold_decide_where_there_are_vectors() {
    // cos 72° = 0.309, so that the score is 0.6545; cos 73° = 0.292 is below the threshold.
    assert_eq!(answer(&told([80.0, 72.0, 90.0], None).1, "chair"), "1.glb []");
    assert_eq!(answer(&told([73.0, 74.0, 90.0], None).1, "chair"), " [score]");
    assert_eq!(answer(&told([73.0, 74.0, 90.0], Some(0.6)).1, "chair"), "0.glb []");
    // What looks most like a chair is taken, whatever its card calls it.
    assert_eq!(answer(&told([60.0, 50.0, 10.0], None).1, "chair"), "2.glb []");
    // Where there are no vectors for a query, words decide.
    assert_eq!(answer(&told([60.0, 50.0, 10.0], None).1, "table"), "2.glb []");
    assert!((TAU - 0.652).abs() < 1e-12);
}

#[test]
fn features_that_cannot_be_used_are_one_diagnosis_and_words_decide() {
    let good = |folder: &Path, name: &str| fs::read(folder.join("features").join(name)).unwrap();
    type Damage = fn(&Path, &dyn Fn(&Path, &str) -> Vec<u8>);
    let damages: [(Damage, &str, &str); 9] = [
        (|f, _| fs::remove_file(f.join("features/clip_models.npy")).unwrap(), "E0001", "there is no such file"),
        (
            |f, good| fs::write(f.join("features/clip_models.npy"), &good(f, "clip_models.npy")[..90]).unwrap(),
            "E0706",
            "clip_models.npy: it ends early",
        ),
        (
            |f, _| {
                fs::write(f.join("features/sbert_models.npy"), npy("(3, 2)", &[1.0, 0.0, f64::NAN, 1.0, 0.0, 1.0]))
                    .unwrap()
            },
            "E0706",
            "row 1 has a number that is not finite",
        ),
        (
            |f, _| {
                fs::write(f.join("features/sbert_models.npy"), npy("(3, 2)", &[1.0, 0.0, 0.0, 0.0, 0.0, 1.0])).unwrap()
            },
            "E0706",
            "row 1 is a vector of zeros",
        ),
        (
            |f, _| fs::write(f.join("features/sbert_models.npy"), npy("(2, 2)", &[1.0, 0.0, 0.0, 1.0])).unwrap(),
            "E0706",
            "it has 2 rows, but features/names.json has 3 texts",
        ),
        (
            |f, _| fs::write(f.join("features/clip_queries.npy"), npy("(1, 3)", &[1.0, 0.0, 0.0])).unwrap(),
            "E0706",
            "the vectors of clip_models.npy have 2 numbers, but those of clip_queries.npy have 3",
        ),
        (|f, _| fs::write(f.join("features/names.json"), "{}").unwrap(), "E0706", "it is not a list of strings"),
        (
            |f, _| fs::write(f.join("features/names.json"), "[\"a\", \"a\", \"b\"]").unwrap(),
            "E0706",
            "it contains the same text twice",
        ),
        (
            |f, _| fs::write(f.join("features/clip_models.npy"), npy("(9999999999, 2)", &[1.0])).unwrap(),
            "E0702",
            "it declares an array of [9999999999, 2] numbers",
        ),
    ];
    for (damage, code, said) in damages {
        let (folder, _) = told([60.0, 50.0, 10.0], None);
        damage(folder.path(), &good);
        let catalogue = Catalogue::open(folder.path()).unwrap();
        let [refused] = catalogue.refused.as_slice() else { panic!("{said}: {:?}", catalogue.refused) };
        let message = &refused.finding.message;
        assert!(refused.finding.code.as_str() == code && message.contains(said), "{} {message}", refused.finding.code);
        // The chain goes on: by words a chair is a chair, and what no words fit is from the library.
        let local = Local::open(folder.path(), "models", None).unwrap();
        assert_eq!(answer(&local, "chair"), "0.glb []", "{said}");
        let chain = Chain::new(vec![Box::new(local), Box::new(Library)]);
        let sofa = Query { size: Some(Vec3::new(2.0, 0.8, 0.9)), ..query("sofa") };
        assert_eq!(chain.choose(&[sofa], &mut |_| {})[0].provider, "library", "{said}");
    }
    // A model without vectors is told of, and the others are found by theirs.
    let (folder, _) = told([60.0, 50.0, 10.0], None);
    write(folder.path(), "3.glb", &block(0.5, 0.9, 0.5).glb(), &Value::Null);
    let catalogue = Catalogue::open(folder.path()).unwrap();
    assert_eq!(
        catalogue.refused[0].finding.message,
        "1 of 4 models have no features and are not found by feature search"
    );
    assert_eq!(answer(&Local::open(folder.path(), "models", None).unwrap(), "chair"), "2.glb []");
}
