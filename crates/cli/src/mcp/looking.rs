//! Tools that look words up: `explain` and `vocabulary`.

use super::tools::{Answered, Call, ToolAnswer};
use crate::words;
use scenelang_base::{Code, codes, suggest};
use scenelang_ide::hover;
use scenelang_lang::{library, natives, roles};
use serde::Deserialize;
use serde_json::{Value, json};

/// So many words are told of.
const TOLD: usize = 40;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Explain {
    word: String,
}

/// The page of a code, or what a word means.
pub fn explain(_: &Call<'_>, Explain { word }: Explain) -> Answered {
    if let Some(code) = Code::find(&word) {
        return Ok(ToolAnswer::of(json!({ "word": code.as_str(), "text": code.page() })));
    }
    if let Some(text) = words::meaning(&word) {
        return Ok(ToolAnswer::of(json!({ "word": word, "text": text })));
    }
    let all = codes::ALL.iter().map(|(code, _)| code.as_str());
    let near = suggest::nearest(&word.to_uppercase(), all).or_else(|| words::nearest(&word));
    let advice = match near {
        Some(near) => format!("did you mean `{near}`?"),
        None => "codes look like E0201, W0302, V0101; `vocabulary` lists the words".to_owned(),
    };
    Err(format!("`{word}` is neither a code nor a word of the language; {advice}"))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Vocabulary {
    word: Option<String>,
}

/// The names there are, or those with a word in them and what they mean.
pub fn vocabulary(_: &Call<'_>, Vocabulary { word }: Vocabulary) -> Answered {
    let Some(word) = word.map(|word| word.to_lowercase()).filter(|word| !word.is_empty()) else {
        let names = |table: &[natives::Property]| table.iter().map(|p| p.name).collect::<Vec<_>>();
        return Ok(ToolAnswer::of(json!({
            "predicates": library::names().collect::<Vec<_>>(),
            "functions": functions(),
            "properties_of_objects": names(natives::OBJECT_PROPERTIES),
            "properties_of_regions": names(natives::REGION_PROPERTIES),
            "categories": library::categories().len(),
            "note": "give a `word` to see what the names that contain it mean, and which categories contain it",
        })));
    };
    let has = |name: &str| name.to_lowercase().contains(&word);
    let predicates = library::names().filter(|name| has(name)).filter_map(|name| {
        let text = hover::library_predicate(name)?;
        Some(entry(name, &text))
    });
    let functions = functions().into_iter().filter(|name| has(name)).map(|name| entry(name, &hover::built_ins(name)));
    let properties = [("object", natives::OBJECT_PROPERTIES), ("region", natives::REGION_PROPERTIES)];
    let properties = properties.into_iter().flat_map(|(of, table)| table.iter().map(move |p| (of, p)));
    let properties = properties
        .filter(|(_, p)| has(p.name))
        .map(|(of, p)| json!({ "name": p.name, "head": format!("{of}.{} : {}", p.name, p.ty.name()), "says": p.doc }));
    let names: Vec<Value> = predicates.chain(functions).chain(properties).take(TOLD).collect();
    let categories = library::categories().iter().filter(|(name, _)| has(name)).take(TOLD);
    let categories: Vec<Value> = categories
        .map(|(name, size)| json!({ "name": name, "usual_size": size, "role": roles::role_of(name).to_string() }))
        .collect();
    if names.is_empty() && categories.is_empty() {
        let near = words::nearest(&word).map(str::to_owned).or_else(|| library::nearest_category(&word));
        let advice = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
        return Err(format!("no name or category contains `{word}`{advice}"));
    }
    Ok(ToolAnswer::of(json!({ "names": names, "categories": categories })))
}

/// Names of built-in functions, each once.
fn functions() -> Vec<&'static str> {
    let mut names: Vec<&str> = natives::BUILT_INS.iter().map(|signature| signature.name).collect();
    names.dedup();
    names
}

/// What an editor shows of a name, taken apart: how it is called, and what it says.
fn entry(name: &str, shown: &str) -> Value {
    let mut lines = shown.lines().skip_while(|line| !line.starts_with("```")).skip(1);
    let head: Vec<&str> = lines.by_ref().take_while(|line| !line.starts_with("```")).collect();
    let says = lines.map(str::trim).find(|line| !line.is_empty()).unwrap_or_default();
    json!({ "name": name, "head": head.join("; "), "says": says })
}
