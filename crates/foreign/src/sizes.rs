//! Sizes of models, from the lists that datasets come with: the asset database of ProcTHOR, the annotations of objathor.
//!
//! Anything in such a file that has a box and a name counts: `{ "NAME": { …, "boundingBox": { "x": …, "y": …, "z": … } } }`
//! or `{ "assetId": "NAME", "boundingBox": … }`, at any depth. A box is its extents, or has `min` and `max`, or `size`.

use scenelang_base::{Diagnostic, FileId, TextRange, codes};
use scenelang_layout::Vec3;
use scenelang_layout::file::json::{Json, JsonNode, Member, find};
use std::collections::BTreeMap;

/// What is known of a model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct KnownSize {
    pub size: Vec3,
    /// The middle of its box in its own frame, where that is said.
    pub middle: Option<Vec3>,
    pub category: Option<String>,
}

/// Sizes of models by name.
#[derive(Clone, Debug, Default)]
pub struct Sizes(BTreeMap<String, KnownSize>);

/// The largest size that a model has (metres).
const LARGEST: f64 = 100.0;

impl Sizes {
    /// Reads a list.
    ///
    /// # Errors
    /// It is no JSON, or has no size of anything in it.
    pub fn read(text: &str, file: FileId) -> Result<Self, Box<Diagnostic>> {
        let mut out = Self::default();
        if let Some(root) = &crate::whole(text, file)? {
            out.collect(root, None);
        }
        if out.0.is_empty() {
            let at = TextRange::empty(0).in_file(file);
            let say = "no size of a model is in this file";
            let note = "expected is a list of models, each with `boundingBox`: asset-database.json, annotations.json";
            return Err(Box::new(Diagnostic::new(codes::E0503, at, say).note(note)));
        }
        Ok(out)
    }

    /// How many models are known.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether nothing is known.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// What is known of a model. Datasets put their name before a dot.
    pub(crate) fn get(&self, name: &str) -> Option<&KnownSize> {
        self.0.get(name).or_else(|| self.0.get(name.split_once('.')?.1))
    }

    fn collect(&mut self, node: &JsonNode, name: Option<&str>) {
        match &node.value {
            Json::Array(items) => items.iter().for_each(|item| self.collect(item, name)),
            Json::Object(members) => {
                let own = ["assetId", "uid"].iter().find_map(|key| text(members, key)).or(name);
                if let (Some(name), Some((size, middle))) = (own, boxed(members)) {
                    let category = ["category", "objectType"].iter().find_map(|key| text(members, key));
                    let model = KnownSize { size, middle, category: category.map(str::to_owned) };
                    self.0.entry(name.to_owned()).or_insert(model);
                    return;
                }
                members.iter().for_each(|m| self.collect(&m.node, Some(&m.key)));
            }
            _ => {}
        }
    }
}

fn text<'n>(members: &'n [Member], key: &str) -> Option<&'n str> {
    match &find(members, key)?.node.value {
        Json::Text(text) => Some(text),
        _ => None,
    }
}

/// The box of a model: its own, or that in its metadata.
fn boxed(members: &[Member]) -> Option<(Vec3, Option<Vec3>)> {
    if let Some(own) = find(members, "boundingBox") {
        return extents(own.node.members()?);
    }
    ["assetMetadata", "thor_metadata"].iter().find_map(|key| boxed(find(members, key)?.node.members()?))
}

fn extents(members: &[Member]) -> Option<(Vec3, Option<Vec3>)> {
    let of = |key: &str| find(members, key)?.node.members().and_then(xyz);
    let (size, middle) = match (of("min"), of("max")) {
        (Some(min), Some(max)) => (max - min, Some((min + max) / 2.0)),
        _ => (of("size").or_else(|| xyz(members))?, None),
    };
    size.iter().all(|v| *v > 0.0 && *v <= LARGEST).then_some((size, middle))
}

fn xyz(members: &[Member]) -> Option<Vec3> {
    let of = |key: &str| match find(members, key)?.node.value {
        Json::Number(number) => Some(number),
        _ => None,
    };
    Some(Vec3::new(of("x")?, of("y")?, of("z")?))
}
