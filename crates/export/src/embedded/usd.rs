//! The scene in a USD layer or package: program and layout in `customLayerData`, objects by what was written into their
//! prims, or by their label where a tool has dropped that. Poses are those in relation to the root of the scene.

use super::stand::{FramePose, Standing, UNREADABLE, transform};
use super::usda::{Prim, UsdValue, parse};
use super::{Embedded, embedded, nothing};
use nalgebra::{Matrix3, Matrix4, Rotation3};
use scenelang_base::Diagnostic;
use scenelang_lang::sources::{Loader, unreadable};
use scenelang_layout::Vec3;
use scenelang_layout::file::decode;
use serde_json::Value;
#[cfg(not(target_family = "wasm"))]
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

/// Prims that are deeper than this are not looked at.
const DEEPEST: usize = 64;
/// A layer in a package is no larger (bytes).
#[cfg(not(target_family = "wasm"))]
const MOST: u64 = 64 << 20;
/// What a prim can be that one sees.
const SEEN: [&str; 7] = ["Xform", "Mesh", "Cube", "Sphere", "Cylinder", "Cone", "Capsule"];

/// Layers of layers that are deeper than this are not read, and no more than so many in all.
const MOST_LAYERS: usize = 16;

/// Reads a layer, or the first one of a package.
pub(super) fn read(name: &str, path: &Path, loader: &dyn Loader) -> Result<Embedded, Box<Diagnostic>> {
    let root = composed(name, path, loader, &mut vec![path.to_path_buf()])?;
    let own = root.metadata.get("customLayerData").and_then(|data| data.get("scenelang"));
    let said = |key: &str| own?.get(key)?.text();
    let (Some(spec), Some(layout)) = (said("spec"), said("layout")) else {
        return Err(nothing(format!("{name} is a USD file without an embedded program and layout")));
    };
    let is = |key: &str, usual: &str| root.metadata.get(key).and_then(UsdValue::text).is_none_or(|v| v == usual);
    let metres = root.metadata.get("metersPerUnit").and_then(UsdValue::numbers::<1>).is_none_or(|[v]| v == 1.0);
    if !is("upAxis", "Y") || !metres {
        return Err(nothing(format!("{name} is no longer in metres with y up, so its objects cannot be compared")));
    }
    let imports: Value = said("imports").and_then(|text| serde_json::from_str(text).ok()).unwrap_or_default();
    let found = embedded(format!("{name}/layout.json"), path.join("layout.json"), layout, spec, &imports);
    let mut seen = Vec::new();
    let main = root.metadata.get("defaultPrim").and_then(UsdValue::text).unwrap_or("World");
    for prim in &root.children {
        if prim.name == main {
            // The whole scene may stand anywhere.
            prim.children.iter().for_each(|child| walk(child, Some(Matrix4::identity()), &[], &mut seen));
        } else {
            walk(prim, Some(Matrix4::identity()), &[], &mut seen);
        }
    }
    Ok(found.updated(&seen))
}

/// A layer with its sublayers. `seen`: the layers that are read already.
fn composed(name: &str, path: &Path, loader: &dyn Loader, seen: &mut Vec<PathBuf>) -> Result<Prim, Box<Diagnostic>> {
    let bytes = loader.load(path).map_err(|e| Box::new(unreadable(&format!("read {name}"), &e)))?;
    let layer = if bytes.starts_with(b"PK") { unpacked(name, &bytes)? } else { bytes };
    if layer.starts_with(b"PXR-USDC") {
        let found = nothing(format!("{name} is a binary USD layer, which is not supported"));
        return Err(Box::new(found.note("save it as text instead, with the extension .usda")));
    }
    let text = decode(layer)?;
    let mut root = parse(&text)
        .map_err(|broken| nothing(format!("{name} cannot be read as USD: line {}: {}", broken.line, broken.say)))?;
    let below = root.metadata.get("subLayers").map(UsdValue::texts).unwrap_or_default();
    let below: Vec<String> = below.into_iter().map(str::to_owned).collect();
    for layer in below {
        let path = path.parent().unwrap_or(Path::new("")).join(&layer);
        // A layer below itself adds nothing.
        if seen.contains(&path) {
            continue;
        }
        if seen.len() == MOST_LAYERS {
            return Err(nothing(format!("{name} has more than {MOST_LAYERS} layers")));
        }
        seen.push(path.clone());
        root.add_weaker(composed(&format!("{layer}, a sublayer of {name},"), &path, loader, seen)?);
    }
    Ok(root)
}

/// The first file of a package, which is its layer.
#[cfg(target_family = "wasm")]
fn unpacked(name: &str, _: &[u8]) -> Result<Vec<u8>, Box<Diagnostic>> {
    Err(nothing(format!("{name} is a USD package, which cannot be read in a browser")))
}

/// The first file of a package, which is its layer.
#[cfg(not(target_family = "wasm"))]
fn unpacked(name: &str, bytes: &[u8]) -> Result<Vec<u8>, Box<Diagnostic>> {
    let broken = |e: &dyn std::fmt::Display| nothing(format!("{name} is not a USD package: {e}"));
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(|e| broken(&e))?;
    if archive.is_empty() {
        return Err(nothing(format!("{name} is a USD package without a layer")));
    }
    let file = archive.by_index(0).map_err(|e| broken(&e))?;
    let mut out = Vec::new();
    file.take(MOST + 1).read_to_end(&mut out).map_err(|e| broken(&e))?;
    if out.len() as u64 > MOST {
        return Err(nothing(format!("the layer in {name} is larger than the maximum of {} MiB", MOST >> 20)));
    }
    Ok(out)
}

/// Things below a prim, in relation to the root.
fn walk(prim: &Prim, above: Option<Matrix4<f64>>, names: &[&str], seen: &mut Vec<Standing>) {
    let switched_off = prim.metadata.get("active").is_some_and(|v| v.texts() == ["false"])
        || prim.values.get("visibility").is_some_and(|v| v.text() == Some("invisible"));
    if names.len() > DEEPEST || switched_off || prim.is_class {
        return;
    }
    let here = above.and_then(|above| Some(above * local(prim)?));
    let label =
        prim.values.get("semantics:labels:instance").and_then(|v| v.texts().first().map(|text| (*text).to_owned()));
    let part = prim.own("part").is_some();
    let is_building = part || names.contains(&"Building");
    let id = prim.own("id").map(str::to_owned).or(label.filter(|_| !is_building));
    let is_folder = matches!(prim.kind.as_str(), "Scope")
        || names.is_empty() && matches!(prim.name.as_str(), "Objects" | "Building");
    let is_thing = !is_folder && SEEN.contains(&prim.kind.as_str());
    if id.is_some() || is_thing {
        let father = names.last().copied().filter(|father| *father != "Objects" && !is_building);
        // The prim of `chair[0]` is called `chair_0`; what is called so still is not called otherwise.
        let called = prim.own("prim").is_none_or(|own| own == prim.name);
        let name = if called { id.clone().unwrap_or_else(|| prim.name.clone()) } else { prim.name.clone() };
        let lost = id.is_some() && names.is_empty();
        let parent = father.map(str::to_owned).or_else(|| lost.then(|| "the scene".to_owned()));
        let parent = parent.filter(|_| id.is_some());
        let place = here.ok_or(UNREADABLE).and_then(|m| FramePose::of(&unmirrored(&m)));
        seen.push(Standing { id: id.clone(), name, parent, is_building, place });
    }
    let below: Vec<&str> = names.iter().copied().chain([prim.name.as_str()]).collect();
    for child in &prim.children {
        // What hangs on one of our objects belongs to it, and so does what a thing of others is made of.
        let belongs = (id.is_some() || is_thing) && !has_own(child);
        if !belongs {
            walk(child, here, &below, seen);
        }
    }
}

/// Whether a prim, or one below it, is an object of ours.
fn has_own(prim: &Prim) -> bool {
    prim.own("id").is_some() || prim.children.iter().any(has_own)
}

/// The transform of a prim, op by op; `None`: it has one that is not known here.
fn local(prim: &Prim) -> Option<Matrix4<f64>> {
    let mut out = Matrix4::identity();
    let Some(order) = prim.values.get("xformOpOrder") else { return Some(out) };
    for op in order.texts() {
        let value = prim.values.get(op)?;
        let kind = op.split(':').nth(1)?;
        out *= match kind {
            "translate" => transform(value.numbers()?, [0.0; 4], [1.0; 3]),
            "scale" => transform([0.0; 3], [0.0; 4], value.numbers()?),
            "orient" => {
                let [w, x, y, z] = value.numbers()?;
                transform([0.0; 3], [x, y, z, w], [1.0; 3])
            }
            // Rows there are columns here.
            "transform" => Matrix4::from_row_slice(&value.numbers::<16>()?).transpose(),
            _ => turned(kind.strip_prefix("rotate")?, value)?.to_homogeneous(),
        };
    }
    Some(out)
}

/// `rotateXYZ` turns about x first; `rotateY` about y.
fn turned(axes: &str, value: &UsdValue) -> Option<Matrix3<f64>> {
    let degrees: Vec<f64> = match axes.len() {
        1 => value.numbers::<1>()?.to_vec(),
        3 => value.numbers::<3>()?.to_vec(),
        _ => return None,
    };
    let mut out = Matrix3::identity();
    for (k, axis) in axes.chars().enumerate() {
        let index = "XYZ".find(axis)?;
        let angle = degrees[if axes.len() == 1 { 0 } else { index }].to_radians();
        let about = [Vec3::x_axis(), Vec3::y_axis(), Vec3::z_axis()][index];
        let turn = Rotation3::from_axis_angle(&about, angle).into_inner();
        out = if k == 0 { turn } else { turn * out };
    }
    Some(out)
}

/// A transform of the right-handed frame in the scene's: x is negated on both sides.
fn unmirrored(m: &Matrix4<f64>) -> Matrix4<f64> {
    let flip = Matrix4::from_diagonal(&nalgebra::Vector4::new(-1.0, 1.0, 1.0, 1.0));
    flip * m * flip
}
