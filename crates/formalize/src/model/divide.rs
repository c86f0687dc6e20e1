//! The regions, and which sentences of Q′ each is made from: its sub-prompt.

use super::ask::{Asker, DIVIDE, Trouble, list, object};
use super::sentences::Sentences;
use crate::draft::{Draft, DraftRoom, Surface, ThingOrigin};
use crate::names::{GivenNames, identifier};
use scenelang_llm::plain;
use serde::Deserialize;
use serde_json::json;

/// More regions are not made.
const MOST: usize = 40;

/// The usual height of a room, and its width and depth where nothing is said (metres).
const USUAL: [f64; 3] = [5.0, 2.7, 4.0];

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DivideAnswer {
    regions: Vec<Region>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Region {
    name: String,
    kind: String,
    sentences: Vec<i64>,
}

pub(super) type SentenceNumbers = Vec<usize>;

/// Adds the regions to the draft; which sentences belong to each. A sentence that belongs to none belongs to all.
pub(super) fn divide(
    asker: &mut Asker<'_>,
    sentences: &Sentences,
    draft: &mut Draft,
    names: &mut GivenNames,
) -> Result<Vec<SentenceNumbers>, Trouble> {
    let region = object(&json!({
        "name": { "type": "string" },
        "kind": { "type": "string" },
        "sentences": list(&json!({ "type": "integer" })),
    }));
    let known = json!({ "outdoor": draft.outdoor, "sentences": sentences.told(None) });
    let schema = object(&json!({ "regions": list(&region) }));
    let mut answer: DivideAnswer = asker.ask(DIVIDE, schema, &known)?;
    if answer.regions.is_empty() {
        answer.regions.push(Region { name: "room".into(), kind: "room".into(), sentences: Vec::new() });
    }
    if answer.regions.len() > MOST {
        asker
            .diagnostics
            .push(format!("{} regions are too many: only the first {MOST} are kept", answer.regions.len()));
        answer.regions.truncate(MOST);
    }
    let mut parts = Vec::new();
    for region in &answer.regions {
        let name = names.take(&identifier(&region.name, "room"));
        let numbers = region.sentences.iter().filter_map(|number| usize::try_from(*number).ok());
        let mut part: SentenceNumbers = numbers.filter(|number| (1..=sentences.len()).contains(number)).collect();
        part.sort_unstable();
        part.dedup();
        let first =
            region.sentences.iter().find(|n| matches!(sentences.source(Some(**n), None), ThingOrigin::Stated(_)));
        draft.rooms.push(DraftRoom {
            name,
            kind: plain(&region.kind, 60),
            at: [0.0; 2],
            size: USUAL,
            sized: false,
            rows: [0.0; 2],
            outline: None,
            floor: Surface::default(),
            walls: Surface::default(),
            source: sentences
                .source(first.or(region.sentences.first()).copied(), Some("the request needs this region")),
        });
        parts.push(part);
    }
    for number in 1..=sentences.len() {
        if !parts.iter().any(|part| part.contains(&number)) {
            parts.iter_mut().for_each(|part| part.push(number));
        }
    }
    Ok(parts)
}
