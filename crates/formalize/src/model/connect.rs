//! Doors and windows: which regions they join, what they look like, how large they are.

use super::ask::{Asker, CONNECT, Trouble, length, list, maybe, object, words};
use super::sentences::Sentences;
use crate::draft::{Draft, Look, Note, Opening, OpeningKind};
use crate::names::{GivenNames, identifier};
use serde::Deserialize;
use serde_json::json;

/// More openings are not made.
const MOST: usize = 120;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ConnectAnswer {
    connections: Vec<Connection>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Connection {
    kind: Kind,
    between: Vec<String>,
    description: Option<String>,
    color: Option<String>,
    material: Option<String>,
    width: f64,
    height: f64,
    sentence: Option<i64>,
    reason: Option<String>,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Door,
    Window,
}

/// Adds the openings to the draft. Outdoors there are none.
pub(super) fn connect(
    asker: &mut Asker<'_>,
    sentences: &Sentences,
    draft: &mut Draft,
    names: &mut GivenNames,
) -> Result<(), Trouble> {
    if draft.outdoor {
        return Ok(());
    }
    let connection = object(&json!({
        "kind": { "type": "string", "enum": ["door", "window"] },
        "between": list(&json!({ "type": "string" })),
        "description": maybe("string"),
        "color": maybe("string"),
        "material": maybe("string"),
        "width": { "type": "number" },
        "height": { "type": "number" },
        "sentence": maybe("integer"),
        "reason": maybe("string"),
    }));
    let regions: Vec<_> = draft.rooms.iter().map(|room| json!({ "name": room.name, "kind": room.kind })).collect();
    let known = json!({ "regions": regions, "sentences": sentences.told(None) });
    let answer: ConnectAnswer = asker.ask(CONNECT, object(&json!({ "connections": list(&connection) })), &known)?;
    for connection in answer.connections.into_iter().take(MOST) {
        let source = sentences.source(connection.sentence, connection.reason.as_deref());
        let room = |name: &String| draft.rooms.iter().position(|room| room.name == *name);
        let mut rooms: Vec<usize> = connection.between.iter().filter_map(room).collect();
        rooms.dedup();
        rooms.truncate(2);
        if rooms.is_empty() {
            if let crate::draft::ThingOrigin::Stated(at) = source {
                draft.notes.push(Note { at, reason: "an opening between regions that do not exist".into() });
            }
            continue;
        }
        let (word, kind, usual) = match connection.kind {
            Kind::Door => ("door", OpeningKind::Door, [0.9, 2.1]),
            Kind::Window => ("window", OpeningKind::Window, [1.4, 1.3]),
        };
        let name = match rooms.as_slice() {
            [room] => identifier(&format!("{} {word}", draft.rooms[*room].name), word),
            _ => word.to_owned(),
        };
        draft.openings.push(Opening {
            name: names.take(&name),
            kind,
            category: None,
            rooms,
            size: [
                length(connection.width, [0.3, 8.0], usual[0]),
                length(connection.height, [0.3, 4.0], usual[1]),
                0.06,
            ],
            look: Look {
                color: words(connection.color.as_deref()),
                material: words(connection.material.as_deref()),
                features: words(connection.description.as_deref()).into_iter().collect(),
            },
            source,
        });
    }
    Ok(())
}
