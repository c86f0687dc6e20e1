//! The entities of a region: the surfaces of floor and walls, and the objects, with their properties.

use super::ask::{Asker, FURNISH, Trouble, length, list, maybe, object, words};
use super::divide::SentenceNumbers;
use super::sentences::Sentences;
use crate::draft::{Draft, DraftThing, Look, Surface};
use crate::names::{GivenNames, identifier};
use scenelang_llm::plain;
use serde::Deserialize;
use serde_json::json;

/// More of one thing, and more things of one region, are not made.
const MOST_ALIKE: usize = 200;
const MOST: usize = 150;
/// More objects of a whole scene are not made, each of an array counted.
const MOST_IN_ALL: usize = 3000;
/// How small and how large a thing can be (metres).
const LENGTHS: [f64; 2] = [0.005, 60.0];

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FurnishAnswer {
    floor: Texture,
    walls: Texture,
    objects: Vec<Object>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Texture {
    color: Option<String>,
    material: Option<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Object {
    name: String,
    category: String,
    count: i64,
    color: Option<String>,
    material: Option<String>,
    features: Vec<String>,
    dimensions: Option<Dimensions>,
    sentence: Option<i64>,
    reason: Option<String>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Dimensions {
    width: f64,
    height: f64,
    depth: f64,
}

/// Adds the entities of a region to the draft.
pub(super) fn furnish(
    asker: &mut Asker<'_>,
    sentences: &Sentences,
    part: &SentenceNumbers,
    room: usize,
    draft: &mut Draft,
    names: &mut GivenNames,
) -> Result<(), Trouble> {
    let number = || json!({ "type": "number" });
    let texture = object(&json!({ "color": maybe("string"), "material": maybe("string") }));
    let mut dimensions = object(&json!({ "width": number(), "height": number(), "depth": number() }));
    dimensions["type"] = json!(["object", "null"]);
    let entity = object(&json!({
        "name": { "type": "string" },
        "category": { "type": "string" },
        "count": { "type": "integer" },
        "color": maybe("string"),
        "material": maybe("string"),
        "features": list(&json!({ "type": "string" })),
        "dimensions": dimensions,
        "sentence": maybe("integer"),
        "reason": maybe("string"),
    }));
    let region = &draft.rooms[room];
    let [width, height, depth] = region.size;
    // A sentence may speak of several regions: what another one has already is not to come again.
    let elsewhere: Vec<&str> = draft.things.iter().map(|thing| thing.name.as_str()).collect();
    let known = json!({
        "region": { "name": region.name, "kind": region.kind, "width": width, "height": height, "depth": depth },
        "outdoor": draft.outdoor,
        "objects_of_other_regions": elsewhere,
        "sentences": sentences.told(Some(part)),
    });
    let schema = object(&json!({ "floor": texture, "walls": texture, "objects": list(&entity) }));
    let answer: FurnishAnswer = asker.ask(FURNISH, schema, &known)?;
    let surface = |texture: &Texture| Surface {
        color: words(texture.color.as_deref()),
        material: words(texture.material.as_deref()),
    };
    draft.rooms[room].floor = surface(&answer.floor);
    draft.rooms[room].walls = surface(&answer.walls);
    if answer.objects.len() > MOST {
        asker
            .diagnostics
            .push(format!("{} objects are too many: only the first {MOST} are kept", answer.objects.len()));
    }
    for object in answer.objects.iter().take(MOST) {
        let most = i64::try_from(MOST_ALIKE).unwrap_or(i64::MAX);
        if object.count < 1 || object.count > most {
            let name = plain(&object.name, 40);
            asker
                .diagnostics
                .push(format!("`{name}` cannot have {} elements: expected 1 to {MOST_ALIKE}", object.count));
        }
        let count = usize::try_from(object.count.clamp(1, most)).unwrap_or(1);
        if draft.things.iter().map(|thing| thing.count).sum::<usize>() + count > MOST_IN_ALL {
            asker.diagnostics.push(format!("a scene has at most {MOST_IN_ALL} objects; the others are left out"));
            break;
        }
        // Of a size that cannot be nothing is taken: then it is the usual one of its category.
        let size = object.dimensions.map(|Dimensions { width, height, depth }| [width, height, depth]);
        let size = size.map(|size| size.map(|metres| length(metres, LENGTHS, 0.0)));
        let size = size.filter(|size| !size.contains(&0.0));
        let category = identifier(&object.category, "thing");
        draft.things.push(DraftThing {
            name: names.take(&identifier(&object.name, &category)),
            category: underscored(&object.category),
            count,
            room: Some(room),
            size,
            look: Look {
                color: words(object.color.as_deref()),
                material: words(object.material.as_deref()),
                features: object.features.iter().take(12).filter_map(|feature| words(Some(feature))).collect(),
            },
            formation: Vec::new(),
            source: sentences.source(object.sentence, object.reason.as_deref()),
        });
    }
    Ok(())
}

/// A category as the language has it: "Office chair" is `office_chair`.
fn underscored(category: &str) -> String {
    let words = category.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).take(4);
    let joined =
        words.map(|word| word.chars().take(24).collect::<String>().to_lowercase()).collect::<Vec<_>>().join("_");
    if joined.is_empty() { "thing".into() } else { joined }
}
