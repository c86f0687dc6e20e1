//! A scene as it is stored: one line of JSON with request, ground truth, program and layout.

use super::FORMAT;
use super::plan::Plan;
use super::program::{ProgramNames, Stated, middles};
use super::tell::SceneWords;
use crate::expect;
use crate::score::Share;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeMap;

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DatasetScene {
    /// [`FORMAT`].
    pub format: String,
    /// Its name, and that of its files.
    pub id: String,
    pub seed: u64,
    pub number: u64,
    /// What kind of building it is in.
    pub building: String,
    pub rooms: Vec<RoomRecord>,
    /// Doors and windows.
    pub connections: Vec<Connection>,
    /// What is in the rooms.
    pub objects: Vec<Object>,
    /// What the request states of places.
    pub relations: Vec<Relation>,
    /// The conversational request.
    pub request: String,
    /// The same in one sentence.
    pub sentence: String,
    /// The text of the program.
    pub program: String,
    /// Whether a layout is not ruled out by proof; `None` before it was looked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub satisfiable: Option<bool>,
    /// How much of what must hold does in the layout.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held: Option<Held>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub layout: Option<Value>,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RoomRecord {
    /// Its name in the program.
    pub name: String,
    /// What it is called in the request.
    pub kind: String,
    /// Where its middle is along x; rooms stand side by side.
    pub x: f64,
    /// Width, height, depth in metres.
    pub size: [f64; 3],
    /// What is said of it, by what it is about.
    pub attributes: BTreeMap<String, String>,
}

/// A door or a window.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Connection {
    /// Its name in the program.
    pub name: String,
    /// Door or window.
    pub kind: String,
    /// Two rooms, or one and `outside`.
    pub between: [String; 2],
    /// How it looks.
    pub description: String,
}

/// A thing, or several that are alike.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Object {
    /// Its name in the program.
    pub name: String,
    /// What it is called in the request, in the singular.
    pub noun: String,
    /// How many.
    pub count: u32,
    pub room: String,
    /// Colour, material, feature; empty where nothing is said.
    pub look: [String; 3],
    /// What it is, with how it looks.
    pub description: String,
}

/// What one sentence states of places.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Relation {
    /// What kind of relation: a rule of the grammar.
    pub relation: String,
    /// Of which thing.
    pub subject: String,
    /// With respect to which thing, or to the room.
    pub object: String,
    /// The sentence of the request.
    pub sentence: String,
    /// The formulas of the program, one for each instance.
    pub formulas: Vec<String>,
}

/// How much holds in the layout: how many, of how many.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Held {
    pub relations: [usize; 2],
    /// Of all that must hold: relations, the other assertions, physical rules.
    pub all: [usize; 2],
}

impl From<Share> for [usize; 2] {
    fn from(share: Share) -> Self {
        [share.part, share.whole]
    }
}

/// A scene of a line of JSON, or why it is none.
pub fn parse(line: &str) -> Result<DatasetScene, String> {
    let scene: DatasetScene = serde_json::from_str(line).map_err(|e| e.to_string())?;
    if scene.format == FORMAT {
        Ok(scene)
    } else {
        Err(format!("its format is {:?}, expected {FORMAT:?}", scene.format))
    }
}

impl DatasetScene {
    /// Whether all that must hold does.
    pub fn holds(&self) -> bool {
        self.held.is_some_and(|held| held.all[0] == held.all[1])
    }

    /// How many things there are.
    pub fn things(&self) -> usize {
        self.objects.iter().map(|object| object.count as usize).sum()
    }

    /// How many relations there are, each instance for itself.
    pub fn instances(&self) -> usize {
        self.relations.iter().map(|relation| relation.formulas.len()).sum()
    }

    pub fn line(&self) -> Result<String, String> {
        serde_json::to_string(self).map(|line| line + "\n").map_err(|e| e.to_string())
    }

    /// The ground truth in the form that requests have it in, `NAME.expect.json`.
    pub fn expectation(&self) -> Value {
        let some = |text: &String| (!text.is_empty()).then(|| text.clone());
        let objects = self.objects.iter().map(|object| {
            serde_json::json!({
                "name": object.name, "count": object.count, "room": object.room,
                "colour": some(&object.look[0]), "material": some(&object.look[1]), "features": some(&object.look[2]),
            })
        });
        let relations = self.relations.iter().filter_map(|relation| {
            let predicate = predicate(&relation.relation)?;
            let object = if relation.object.is_empty() { return None } else { &relation.object };
            Some(serde_json::json!({ "subject": relation.subject, "relation": predicate, "object": object }))
        });
        let rooms = self.rooms.iter().map(|r| serde_json::json!({ "name": r.name, "kind": r.kind, "size": r.size }));
        let connections = self.connections.iter().map(|c| serde_json::json!({ "kind": c.kind, "between": c.between }));
        serde_json::json!({
            "id": self.id, "building": self.building,
            "rooms": rooms.collect::<Vec<_>>(), "connections": connections.collect::<Vec<_>>(),
            "objects": objects.collect::<Vec<_>>(), "relations": relations.collect::<Vec<_>>(), "numeric": [],
        })
    }

    /// The ground truth as a value of its type.
    pub fn expected(&self) -> Result<expect::Expectation, String> {
        serde_json::from_value(self.expectation()).map_err(|e| e.to_string())
    }
}

/// The predicate that a relation is in programs; what is said of a thing alone has none here.
fn predicate(relation: &str) -> Option<&'static str> {
    Some(match relation {
        "wall" => "againstWall",
        "corner" => "inCorner",
        "middle" => "centeredIn",
        "hung" => "wallMounted",
        "ceiling" => "ceilingMounted",
        "on" => "on",
        "at" | "facing" => "facing",
        "around" => "around",
        "beside" => "beside",
        "near" | "close" => "near",
        "before" => "inFrontOf",
        "over" => "above",
        "far" => "far",
        "left" => "leftOf",
        "right" => "rightOf",
        _ => return None,
    })
}

/// The record of a plan.
pub(super) fn scene(
    seed: u64,
    number: u64,
    plan: &Plan,
    names: &ProgramNames,
    stated: &[Stated],
    told: SceneWords,
    program: String,
) -> DatasetScene {
    let text = |words: [&str; 4]| {
        let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
        words.join(" ")
    };
    let middles = middles(plan);
    let rooms = plan.rooms.iter().zip(&names.rooms).zip(middles).map(|((room, name), x)| RoomRecord {
        name: name.clone(),
        kind: room.kind.to_owned(),
        x,
        size: room.size,
        attributes: room.attributes.iter().map(|(what, value, _)| ((*what).to_owned(), (*value).to_owned())).collect(),
    });
    let connections = plan.links.iter().zip(&names.links).map(|(link, name)| Connection {
        name: name.clone(),
        kind: link.noun.to_owned(),
        between: [
            names.rooms[link.between.0].clone(),
            link.between.1.map_or_else(|| "outside".to_owned(), |to| names.rooms[to].clone()),
        ],
        description: text([link.look.colour, link.look.material, link.noun, link.look.feature]),
    });
    let objects = plan.things.iter().zip(&names.things).map(|(thing, name)| Object {
        name: name.clone(),
        noun: thing.noun.to_owned(),
        count: thing.count,
        room: names.rooms[thing.room].clone(),
        look: [thing.look.colour, thing.look.material, thing.look.feature].map(str::to_owned),
        description: text([thing.look.colour, thing.look.material, thing.noun, thing.look.feature]),
    });
    let relations = stated.iter().zip(&told.sentences).filter(|(s, _)| !s.formulas.is_empty());
    let relations = relations.map(|(stated, sentence)| {
        let room = || match stated.rule {
            "wall" | "corner" | "middle" | "hung" | "ceiling" => names.rooms[plan.things[stated.thing].room].clone(),
            _ => String::new(),
        };
        Relation {
            relation: stated.rule.to_owned(),
            subject: names.things[stated.thing].clone(),
            object: stated.other.map_or_else(room, |other| names.things[other].clone()),
            sentence: sentence.clone(),
            formulas: stated.formulas.clone(),
        }
    });
    DatasetScene {
        format: FORMAT.to_owned(),
        id: format!("{}-{}-{number:03}", plan.building, plan.rooms.len()),
        seed,
        number,
        building: plan.building.to_owned(),
        rooms: rooms.collect(),
        connections: connections.collect(),
        objects: objects.collect(),
        relations: relations.collect(),
        request: told.request,
        sentence: told.sentence,
        program,
        satisfiable: None,
        held: None,
        layout: None,
    }
}
