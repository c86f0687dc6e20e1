//! Models and features as objathor and Holodeck keep them: pickles and MessagePack, written by Python (`tests/data/make.py`).

use crate::made::write;
use proptest::prelude::*;
use scenelang_catalogue::{Catalogue, Features, published_score};
use scenelang_layout::Vec3;
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::{TempDir, tempdir};

const PROTOCOLS: [&str; 3] = ["2", "4", "5"];

fn data(name: &str) -> Vec<u8> {
    fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)).unwrap()
}

/// A folder of three objects whose triangles are in a file of the same kind.
fn folder(ending: &str, bytes: &[u8]) -> TempDir {
    let folder = tempdir().unwrap();
    let known = json!({ "aa11": { "category": "chair", "mass": 12 }, "bb22": { "category": "chair" }, "cc33": {} });
    fs::write(folder.path().join("annotations.json"), known.to_string()).unwrap();
    for uid in ["aa11", "bb22", "cc33"] {
        write(folder.path(), &format!("assets/{uid}/{uid}.{ending}"), bytes, &Value::Null);
    }
    folder
}

/// What is said of the first object of a folder, or its size and its parts.
fn first(folder: &Path) -> Result<(Vec3, usize), String> {
    let catalogue = Catalogue::open(folder).map_err(|e| e.message.clone())?;
    let model = catalogue.model(&catalogue.entries[0]).map_err(|e| format!("{} {}", e.code, e.message))?;
    Ok((model.size, model.parts.len()))
}

#[test]
fn a_model_is_the_same_in_each_form() {
    let pickled = PROTOCOLS.map(|protocol| ("pkl.gz", data(&format!("asset-{protocol}.pkl.gz"))));
    for (ending, bytes) in pickled.into_iter().chain([("msgpack.gz", data("asset.msgpack.gz"))]) {
        let folder = folder(ending, &bytes);
        let (size, parts) = first(folder.path()).unwrap();
        assert!((size - Vec3::new(0.5, 1.0, 2.0)).amax() < 1e-9 && parts == 1, "{ending}: {size} {parts}");
    }
}

/// Numbers of single precision as `numpy.save` writes them.
fn npy(shape: &str, numbers: &[f32]) -> Vec<u8> {
    let header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}\n");
    let numbers: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    [b"\x93NUMPY\x01\x00", (header.len() as u16).to_le_bytes().as_slice(), header.as_bytes(), &numbers].concat()
}

/// The features of a folder as Holodeck writes them, with one query.
fn features(clip: &[u8], sbert: &[u8]) -> (TempDir, PathBuf) {
    let folder = folder("pkl.gz", &data("asset-4.pkl.gz"));
    let at = folder.path().join("features");
    fs::create_dir(&at).unwrap();
    fs::write(at.join("clip_features.pkl"), clip).unwrap();
    fs::write(at.join("sbert_features.pkl"), sbert).unwrap();
    fs::write(at.join("queries.json"), json!(["a chair"]).to_string()).unwrap();
    fs::write(at.join("clip_queries.npy"), npy("(1, 8)", &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])).unwrap();
    fs::write(at.join("sbert_queries.npy"), npy("(1, 6)", &[0.0, 0.0, 1.0, 0.0, 0.0, 0.0])).unwrap();
    (folder, at)
}

/// The similarity of a row of what `make.py` calls `numbers` to the query, which is an axis.
fn similarity(shape: &[usize], row: usize, axis: usize) -> f64 {
    let width = shape[shape.len() - 1];
    let number = |i: usize| ((row * width + i) as f64 * 1.7 + shape.len() as f64).cos();
    let length = (0..width).map(|i| number(i).powi(2)).sum::<f64>().sqrt();
    (1.0 + number(axis) / length) / 2.0
}

#[test]
fn the_features_of_holodeck_give_the_published_score() {
    for protocol in PROTOCOLS {
        let (folder, _) = features(&data(&format!("clip-{protocol}.pkl")), &data(&format!("sbert-{protocol}.pkl")));
        let catalogue = Catalogue::open(folder.path()).unwrap();
        assert!(catalogue.refused.is_empty(), "{:?}", catalogue.refused);
        let features: &Features = catalogue.features.as_ref().unwrap();
        for (model, uid) in ["aa11", "bb22", "cc33"].into_iter().enumerate() {
            let visual = (0..3).map(|view| similarity(&[3, 3, 8], model * 3 + view, 0)).fold(0.0, f64::max);
            let wanted = published_score(visual, similarity(&[3, 6], model, 2));
            let score = features.score("a chair", uid).unwrap();
            // Half precision has eleven bits.
            assert!((score - wanted).abs() < 1e-3, "protocol {protocol}, {uid}: {score} instead of {wanted}");
        }
    }
}

#[test]
fn features_without_queries_are_not_used() {
    let (folder, at) = features(&data("clip-4.pkl"), &data("sbert-4.pkl"));
    for name in ["queries.json", "clip_queries.npy", "sbert_queries.npy"] {
        fs::remove_file(at.join(name)).unwrap();
    }
    let catalogue = Catalogue::open(folder.path()).unwrap();
    assert!(catalogue.refused.is_empty() && catalogue.features.is_none());
}

#[test]
fn features_that_cannot_be_used_are_one_diagnosis() {
    let (clip, sbert) = (data("clip-4.pkl"), data("sbert-4.pkl"));
    let renamed = String::from_utf8_lossy(&sbert).contains("cc33").then(|| {
        let at = sbert.windows(4).position(|w| w == b"cc33").unwrap();
        [&sbert[..at], b"dd44", &sbert[at + 4..]].concat()
    });
    for (clip, sbert, said) in [
        (&clip[..clip.len() - 30], &sbert[..], "features/clip_features.pkl: it ends early"),
        (&sbert, &sbert, "features/clip_features.pkl: it has no member `img_features`"),
        (b"\x80\x04}.", &sbert, "features/clip_features.pkl: it has no member `uids`"),
        (b"{}", &sbert, "features/clip_features.pkl: it is not a pickle of protocol 2 to 5"),
        (
            b"\x80\x04}(\x8c\x04uids](\x8c\x01ae\x8c\x0cimg_featuresNu.",
            &sbert,
            "features/clip_features.pkl: `img_features`: it is not an array of NumPy",
        ),
        (
            &clip,
            renamed.as_deref().unwrap(),
            "features/: clip_features.pkl and sbert_features.pkl do not list the same",
        ),
    ] {
        let (folder, _) = features(clip, sbert);
        let catalogue = Catalogue::open(folder.path()).unwrap();
        let [refused] = catalogue.refused.as_slice() else { panic!("{said}: {:?}", catalogue.refused) };
        assert!(refused.finding.message.contains(said), "{said}: {}", refused.finding.message);
    }
}

#[test]
fn a_pickle_is_data_and_nothing_else() {
    // The machine would call os.system; twenty lists of the last one twice are a million; lists in lists in lists.
    let call = b"\x80\x04cos\nsystem\n\x8c\x0ctouch /tmp/x\x85R.".to_vec();
    let mut shared = b"\x80\x04]\x94".to_vec();
    for place in 0..40_u8 {
        shared.extend([b']', 0x94, b'h', place, b'a', b'h', place, b'a']);
    }
    shared.push(b'.');
    let deep = [&[0x80, 4][..], &vec![b']'; 1 << 20], &vec![b'a'; (1 << 20) - 1], b"."].concat();
    let endless = [&b"\x80\x04N"[..], &vec![b'2'; (16 << 20) + 1], b"."].concat();
    for (bytes, said) in [
        (call, "E0701 it is not an objathor model: invalid type: null, expected an object with vertices and triangles"),
        (shared, "E0701 it is not an objathor model: it contains more than 16777216 values"),
        (deep, "E0701 it is not an objathor model: it is nested too deeply"),
        (endless, "E0701 it is not an objathor model: it contains more than 16777216 values"),
        (
            b"\x80\x04a.".to_vec(),
            "E0701 it is not an objathor model: it has an instruction for a value that is not there",
        ),
        (b"\x80\x04.".to_vec(), "E0701 it is not an objathor model: it contains no value"),
        (b"\x80\x04h\x07.".to_vec(), "E0701 it is not an objathor model: it refers to a value that it does not have"),
        (b"\x80\x04P1\n.".to_vec(), "E0701 it is not an objathor model: its instruction 0x50 is not supported"),
        (b"\x80\x04X\xff\xff\xff\xff.".to_vec(), "E0701 it is not an objathor model: it ends early"),
    ] {
        let folder = folder("pkl", &bytes);
        assert_eq!(first(folder.path()).unwrap_err(), said);
    }
    let folder = folder("msgpack", &[0x91; 1 << 20]);
    assert!(first(folder.path()).unwrap_err().starts_with("E0701 it is not an objathor model:"));
}

proptest! {
    /// Whatever is changed in a file, there is a model or a diagnosis.
    #[test]
    fn damaged_pickles_are_diagnosed(cut in 0_usize..2_000, changes in prop::collection::vec((0_usize..2_000, any::<u8>()), 0..4)) {
        let mut bytes = Vec::new();
        std::io::copy(&mut flate2::read::GzDecoder::new(data("asset-4.pkl.gz").as_slice()), &mut bytes).unwrap();
        let whole = bytes.len();
        for (at, by) in changes {
            bytes[at % whole] = by;
        }
        bytes.truncate(cut.max(whole.saturating_sub(1_000)) % (whole + 1));
        let folder = folder("pkl", &bytes);
        prop_assert!(first(folder.path()).is_ok_and(|(size, _)| size.min() > 0.0) || first(folder.path()).is_err());
    }
}
