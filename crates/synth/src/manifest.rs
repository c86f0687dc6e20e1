//! Who gave each object its furniture, and why those who were asked before did not: for programs and for people.

use crate::furnish::Chosen;
use serde_json::{Value, json};

/// What the manifest calls itself.
const FORMAT: &str = "scenelang.furniture/1";

/// The manifest: all objects in the order of the program.
pub fn manifest(furniture: &[Chosen]) -> Value {
    let row = |chosen: &Chosen| {
        let (choice, given) = (&chosen.choice, &chosen.choice.given);
        let size = &given.piece.size;
        let passed = |(provider, remark): &(String, scenelang_catalogue::Remark)| {
            json!({
                "provider": provider,
                "why": remark.why.name(),
                "message": remark.say,
                "code": remark.code.map(|code| code.as_str()),
            })
        };
        json!({
            "object": chosen.object,
            "provider": choice.provider,
            "source": given.source,
            "score": given.score,
            "sha256": given.content,
            "licence": given.licence,
            "size": [size.x, size.y, size.z],
            "passed": choice.passed.iter().map(passed).collect::<Vec<_>>(),
        })
    };
    json!({ "format": FORMAT, "objects": furniture.iter().map(row).collect::<Vec<_>>() })
}

/// How many objects each provider furnished, in the order in which they were asked; an empty text where only the library
/// was.
pub fn told(furniture: &[Chosen]) -> String {
    let mut counts: Vec<(&str, usize)> = Vec::new();
    for chosen in furniture {
        let provider = chosen.choice.provider.as_str();
        match counts.iter_mut().find(|(name, _)| *name == provider) {
            Some((_, count)) => *count += 1,
            None => counts.push((provider, 1)),
        }
    }
    // The library and the box come last in every chain.
    counts.sort_by_key(|(name, _)| ["library", "box"].iter().position(|last| last == name).map_or(0, |at| at + 1));
    let each: Vec<String> = counts.iter().map(|(name, count)| format!("{count} from {name}")).collect();
    each.join(", ")
}
