//! Indoor or outdoor: decided first, and without chance.

use super::ask::{Asker, SCENE, Trouble, object};
use serde::Deserialize;
use serde_json::json;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneAnswer {
    scene: Kind,
}

#[derive(Debug, Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Indoor,
    Outdoor,
}

/// Whether the scene is outdoors.
pub(super) fn is_outdoor(asker: &mut Asker<'_>, request: &str) -> Result<bool, Trouble> {
    let schema = object(&json!({ "scene": { "type": "string", "enum": ["indoor", "outdoor"] } }));
    let answer: SceneAnswer = asker.ask(SCENE, schema, &json!({ "request": request }))?;
    Ok(answer.scene == Kind::Outdoor)
}
