//! The scene in a GLB file: program and layout in `extras.scenelang` of the scene, objects by `extras.scenelang.id` of
//! their nodes, or by name where a tool has dropped that.

use super::stand::{FramePose, Standing, transform};
use super::{Embedded, embedded, nothing};
use nalgebra::Matrix4;
use scenelang_base::{Diagnostic, codes};
use scenelang_lang::sources::{Loader, unreadable};
use serde_json::Value;
use std::path::Path;

/// Nodes that are deeper than this are not looked at.
const DEEPEST: usize = 64;
/// Entries of the transform of a whole scene that differ by less are as they were.
const MOVED: f64 = 1e-6;
/// At most so many nodes are looked at.
const MOST: usize = 100_000;

/// Reads a GLB file.
pub(super) fn read(name: &str, path: &Path, loader: &dyn Loader) -> Result<Embedded, Box<Diagnostic>> {
    let bytes = loader.load(path).map_err(|e| Box::new(unreadable(&format!("read {name}"), &e)))?;
    let Some(document) = json_chunk(&bytes) else {
        return Err(Box::new(Diagnostic::without_place(codes::E0008, format!("{name} is not a GLB file"))));
    };
    let scene = &document["scenes"][document["scene"].as_u64().unwrap_or(0) as usize];
    let own = &scene["extras"]["scenelang"];
    let (Some(spec), Some(layout)) = (own["spec"].as_str(), own["layout"].as_str()) else {
        return Err(nothing(format!("{name} is a GLB file without an embedded program and layout")));
    };
    let found = embedded(format!("{name}/layout.json"), path.join("layout.json"), layout, spec, &own["imports"]);
    let mut walk = Walk { nodes: &document["nodes"], seen: Vec::new(), left: MOST };
    let (mut roots, mut moved) = (indices(&scene["nodes"]), None);
    // Some tools put the whole scene below one more node. It may stand anywhere.
    for _ in 0..DEEPEST {
        let [only] = roots[..] else { break };
        let node = &document["nodes"][only];
        if !node.is_object() || node.get("mesh").is_some() || node["extras"]["scenelang"].is_object() {
            break;
        }
        roots = indices(&node["children"]);
        if (local(node) - Matrix4::identity()).amax() > MOVED {
            moved = Some(node["name"].as_str().unwrap_or("its root").to_owned());
        }
    }
    for node in roots {
        walk.node(node, &Matrix4::identity(), None, 0);
    }
    let mut found = found.updated(&walk.seen);
    if let Some(root) = moved {
        let message =
            format!("`{root}`, the node of the whole scene, was moved; objects are checked in relation to it");
        found.changes.push(Diagnostic::without_place(codes::W0504, message));
    }
    Ok(found)
}

/// The first chunk of a GLB file: a header of 12 bytes, then length, kind and data of each chunk.
fn json_chunk(bytes: &[u8]) -> Option<Value> {
    let number = |at: usize| bytes.get(at..at + 4)?.try_into().ok().map(u32::from_le_bytes);
    if !bytes.starts_with(b"glTF") || number(4)? != 2 || bytes.get(16..20)? != b"JSON" {
        return None;
    }
    let end = 20_usize.checked_add(number(12)? as usize)?;
    serde_json::from_slice(bytes.get(20..end)?).ok()
}

/// The things below the nodes of a scene.
struct Walk<'d> {
    nodes: &'d Value,
    seen: Vec<Standing>,
    /// How many nodes may still be looked at: they may refer to each other in circles.
    left: usize,
}

impl Walk<'_> {
    fn node(&mut self, index: usize, above: &Matrix4<f64>, parent: Option<&str>, depth: usize) {
        let node = &self.nodes[index];
        if depth > DEEPEST || self.left == 0 || !node.is_object() {
            return;
        }
        self.left -= 1;
        let here = above * local(node);
        let own = &node["extras"]["scenelang"];
        let name = node["name"].as_str().unwrap_or_default().to_owned();
        let children = indices(&node["children"]);
        // A tool may keep what was written into an object only in what the object is made of.
        let made_of = !children.is_empty() && children.iter().all(|child| self.id(*child) == Some(&name));
        let id = own["id"].as_str().map(str::to_owned).or_else(|| made_of.then(|| name.clone()));
        let is_building = own["part"].is_string();
        let is_object = id.is_some();
        let is_seen = node.get("mesh").is_some();
        if is_object || is_building || is_seen {
            let place = FramePose::of(&unmirrored(&here));
            let parent = parent.map(str::to_owned);
            self.seen.push(Standing { id: id.clone(), name: name.clone(), parent, is_building, place });
        }
        // What hangs on one of our objects belongs to it, also where a tool has repeated what was written into it.
        for child in children {
            let belongs = is_object && self.id(child).is_none_or(|of| Some(of) == id.as_deref());
            if !belongs {
                self.node(child, &here, Some(&name), depth + 1);
            }
        }
    }

    /// The object that a node was exported as.
    fn id(&self, node: usize) -> Option<&str> {
        self.nodes[node]["extras"]["scenelang"]["id"].as_str()
    }
}

fn indices(list: &Value) -> Vec<usize> {
    list.as_array().into_iter().flatten().filter_map(|i| usize::try_from(i.as_u64()?).ok()).collect()
}

/// The transform of a node: a matrix, column by column, or translation, rotation and scale.
fn local(node: &Value) -> Matrix4<f64> {
    if let Some(matrix) = numbers::<16>(&node["matrix"]) {
        return Matrix4::from_column_slice(&matrix);
    }
    let pos = numbers(&node["translation"]).unwrap_or([0.0; 3]);
    let rot = numbers(&node["rotation"]).unwrap_or([0.0, 0.0, 0.0, 1.0]);
    transform(pos, rot, numbers(&node["scale"]).unwrap_or([1.0; 3]))
}

fn numbers<const N: usize>(list: &Value) -> Option<[f64; N]> {
    let list: Vec<f64> = list.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    list.try_into().ok()
}

/// A transform of glTF's right-handed frame in the scene's: x is negated on both sides.
fn unmirrored(m: &Matrix4<f64>) -> Matrix4<f64> {
    let flip = Matrix4::from_diagonal(&nalgebra::Vector4::new(-1.0, 1.0, 1.0, 1.0));
    flip * m * flip
}
