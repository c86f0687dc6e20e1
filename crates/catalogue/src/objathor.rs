//! The folder of objathor and Holodeck: what is known of all objects in `annotations.json.gz`, and the triangles of each in
//! `assets/UID/UID.pkl.gz`, or in JSON or MessagePack.
//!
//! Triangles are in the frame of Unity, which is that of the layout, in metres. Any member of an annotation may be
//! missing.

use crate::card::Card;
use crate::faults::{Fault, beyond, broken, fault};
use crate::limits;
use crate::model::{Axes, CatalogueModel};
use crate::pickle::Pickle;
use crate::raw::{Patch, Raw};
use flate2::read::GzDecoder;
use scenelang_assets::covering;
use scenelang_base::codes;
use scenelang_base::door::Door;
use scenelang_layout::convex::MAX_HULL_POINTS;
use scenelang_layout::{Convex, Part, Vec3};
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Path, PathBuf};

/// What the file about all objects is called; the first that is there counts.
pub(crate) const ANNOTATIONS: [&str; 2] = ["annotations.json.gz", "annotations.json"];
/// What the file of an object ends with, in the order of objathor; the first that is there counts.
const ENDINGS: [&str; 6] = ["pkl.gz", "pkl", "msgpack.gz", "msgpack", "json.gz", "json"];

/// The members of an annotation that are looked at; each may be anything.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Annotation {
    category: Value,
    description: Value,
    description_auto: Value,
    synset: Value,
    materials: Value,
    mass: Value,
    license_info: Value,
    width: Value,
    height: Value,
    depth: Value,
    thor_metadata: Value,
}

/// The triangles of an object.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase", expecting = "an object with vertices and triangles")]
struct Asset {
    vertices: Vec<Point>,
    triangles: Vec<u32>,
    #[serde(default)]
    normals: Vec<Point>,
    #[serde(default)]
    colliders: Vec<Collider>,
    /// Degrees, from +z towards +x, by which it is turned when it is loaded.
    #[serde(default)]
    y_rot_offset: f64,
}

#[derive(Debug, Deserialize)]
struct Collider {
    vertices: Vec<Point>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
struct Point {
    x: f64,
    y: f64,
    z: f64,
}

impl From<Point> for Vec3 {
    fn from(p: Point) -> Self {
        Self::new(p.x, p.y, p.z)
    }
}

/// An object of the folder.
pub(crate) struct Object {
    /// The file with its triangles, below the folder.
    pub file: String,
    pub card: Card,
}

/// Objects, and what is wrong with others by their names.
type Found = (Vec<Object>, Vec<(String, Fault)>);

/// What there is in the folder: objects in the order of their names, and what was found wrong with others.
pub(crate) fn objects(folder: &Path, annotations: &str, door: &Door) -> Result<Found, Fault> {
    let bytes = unpacked(door.read(&folder.join(annotations)).map_err(|e| crate::faults::unreadable(&e))?)?;
    let all: BTreeMap<String, Annotation> =
        serde_json::from_slice(&bytes).map_err(|e| broken(format!("it is not a list of annotations: {e}")))?;
    if all.len() > limits::MODELS {
        return Err(beyond(format!("it has {} objects; the maximum is {}", all.len(), limits::MODELS)));
    }
    let (mut found, mut wrong, mut missing) = (Vec::new(), Vec::new(), 0);
    let total = all.len();
    for (uid, annotation) in all {
        if !uid.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '-')) || uid.is_empty() {
            let say = format!("it has an object whose name is not a valid file name: {uid:?}");
            wrong.push((annotations.to_owned(), fault(codes::E0703, say)));
            continue;
        }
        let at = |ending: &str| format!("assets/{uid}/{uid}.{ending}");
        let is_there = |ending: &&&str| door.is_file(&folder.join(at(ending)));
        if let Some(ending) = ENDINGS.iter().find(is_there) {
            found.push(Object { file: at(ending), card: card(&annotation) });
        } else {
            missing += 1;
        }
    }
    if missing > 0 {
        let say = format!("{missing} of its {total} objects have no model below assets/");
        wrong.push((annotations.to_owned(), fault(codes::E0001, say)));
    }
    Ok((found, wrong))
}

/// What an annotation says.
fn card(from: &Annotation) -> Card {
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let described = text(&from.description);
    let list = from.materials.as_array().into_iter().flatten();
    Card {
        category: text(&from.category),
        description: if described.is_empty() { text(&from.description_auto) } else { described },
        synset: text(&from.synset),
        materials: list.filter_map(Value::as_str).map(str::to_owned).collect(),
        // The numbers of the file are metres already.
        size: None,
        z_up: false,
        // It is said again, exactly, by the file of the triangles.
        front: Some(0.0),
        licence: from.license_info["license"].as_str().map(str::to_owned),
        mass: from.mass.as_f64(),
    }
    .sized(from)
}

impl Card {
    /// With the size that the annotation says, in metres or in centimetres.
    fn sized(mut self, from: &Annotation) -> Self {
        let triple = |v: [&Value; 3]| {
            let v: Option<Vec<f64>> = v.iter().map(|x| x.as_f64()).collect();
            v.map(|v| Vec3::new(v[0], v[1], v[2])).filter(|v| v.iter().all(|x| *x > 0.0 && *x < limits::EXTENT))
        };
        let bounds = &from.thor_metadata["assetMetadata"]["boundingBox"];
        let of = |v: &Value| triple([&v["x"], &v["y"], &v["z"]]);
        let corner = |v: &Value| Some(Vec3::new(v["x"].as_f64()?, v["y"].as_f64()?, v["z"].as_f64()?));
        let between = || Some(corner(&bounds["max"])? - corner(&bounds["min"])?).filter(|v| v.min() > 0.0);
        let centimetres = || Some(triple([&from.width, &from.height, &from.depth])? / 100.0);
        self.size = of(bounds).or_else(|| of(&bounds["size"])).or_else(between).or_else(centimetres);
        self
    }
}

/// Reads the triangles of an object.
pub(crate) fn model(file: &str, card: Card, bytes: Vec<u8>) -> Result<CatalogueModel, Fault> {
    let asset = asset(file, &unpacked(bytes)?).map_err(|why| broken(format!("it is not an objathor model: {why}")))?;
    let vectors = |points: &[Point]| -> Vec<Vec3> { points.iter().map(|p| Vec3::from(*p)).collect() };
    let positions = vectors(&asset.vertices);
    let normals = Some(vectors(&asset.normals)).filter(|n| n.len() == positions.len()).unwrap_or_default();
    let surface = covering("", &card.materials.join(" "), "#c8c4bc", "paint");
    let mut raw = Raw::default();
    let whole = asset.triangles.len() / 3 * 3;
    // Unity winds triangles clockwise in its left-handed frame, which is what the layout does.
    raw.add(Patch { surface, positions, normals, indices: asset.triangles[..whole].to_vec() })?;
    let hull = |c: &Collider| {
        let points = vectors(&c.vertices);
        (points.len() <= MAX_HULL_POINTS).then(|| Convex::from_hull(&points))?.map(|c| c.vertices().to_vec())
    };
    let parts = asset.colliders.iter().filter_map(hull).map(|points| Part::Hull { points }).collect();
    // It is turned by the offset when it is loaded, so its front in the file is where that turns to +z.
    let turned = Card { front: Some((-asset.y_rot_offset).rem_euclid(360.0)), size: None, ..card.clone() };
    let mut model = CatalogueModel::new(file, turned, raw, Axes::LeftHanded, parts)?;
    if let Some(said) = card.size {
        let off = said.component_div(&model.size);
        model.origin.distortion = off.max().max(1.0 / off.min());
    }
    model.card = card;
    Ok(model)
}

/// The triangles in a file, in the form that its name says.
fn asset(file: &str, bytes: &[u8]) -> Result<Asset, String> {
    let name = file.strip_suffix(".gz").unwrap_or(file);
    match name.rsplit('.').next() {
        Some("pkl") => serde_json::from_value(Pickle::read(bytes)?.json()?).map_err(|e| e.to_string()),
        Some("msgpack") => rmp_serde::from_slice(bytes).map_err(|e| e.to_string()),
        _ => serde_json::from_slice(bytes).map_err(|e| e.to_string()),
    }
}

/// The bytes, unpacked where they are those of a gzip file.
fn unpacked(bytes: Vec<u8>) -> Result<Vec<u8>, Fault> {
    if !bytes.starts_with(&[0x1f, 0x8b]) {
        return Ok(bytes);
    }
    let mut out = Vec::new();
    let most = limits::UNPACKED as u64;
    let read = GzDecoder::new(bytes.as_slice()).take(most + 1).read_to_end(&mut out);
    if out.len() as u64 > most {
        return Err(beyond(format!("unpacked, it is larger than {} MB", limits::UNPACKED >> 20)));
    }
    read.map_err(|e| broken(format!("it cannot be unpacked: {e}")))?;
    Ok(out)
}

/// The annotations of a folder, if it is one of objathor.
pub(crate) fn annotations(folder: &Path, door: &Door) -> Option<&'static str> {
    ANNOTATIONS.into_iter().find(|name| door.is_file(&PathBuf::from(folder).join(name)))
}
