//! Controlled expansion, Q → Q′: the request in full, and what it asks for without saying so.
//!
//! The model writes Q′; that it keeps Q is checked here. Every number, every negation and every word that names
//! something must be there still, as often as before. Where one is missing the model is told which, and asked again; in
//! the end Q′ is Q.

use super::ask::{Asker, EXPAND, Trouble, list, maybe, object};
use super::sentences::Sentences;
use crate::text::{folded, sentence_ranges};
use scenelang_llm::{Message, Role, plain};
use serde::Deserialize;
use serde_json::json;
use std::collections::BTreeMap;

/// More sentences are not added.
const MOST: usize = 60;

/// Words that say that something is not to be.
const NEGATIONS: &[&str] =
    &["no", "not", "never", "without", "none", "neither", "nor", "nothing", "avoid", "except", "cannot"];

/// Words that name nothing.
const EMPTY: &[&str] = &[
    "a", "an", "the", "and", "or", "of", "in", "on", "at", "to", "for", "with", "is", "are", "be", "it", "its", "this",
    "that", "there", "should", "must", "has", "have", "by", "from", "as", "into", "which", "them", "they", "i", "we",
    "you", "my", "our", "please", "some", "also", "will", "would", "can", "was", "were", "been", "being", "their",
    "do", "does", "did", "want", "need", "like", "create", "make", "design", "generate", "then", "so", "where",
    "while", "each", "both",
];

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ExpandAnswer {
    sentences: Vec<Sentence>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sentence {
    text: String,
    /// Why it is there, if the request does not say it.
    reason: Option<String>,
}

/// The sentences of Q′.
pub(super) fn expand(asker: &mut Asker<'_>, request: &str) -> Result<Sentences, Trouble> {
    let sentence = object(&json!({ "text": { "type": "string" }, "reason": maybe("string") }));
    let schema = object(&json!({ "sentences": list(&sentence) }));
    let mut said = vec![Message::new(Role::User, json!({ "request": request }).to_string())];
    for _ in 0..=asker.asking.expansions {
        let answer: ExpandAnswer = asker.converse(EXPAND, schema.clone(), said.clone())?;
        let stated: Vec<&str> =
            answer.sentences.iter().filter(|s| s.reason.is_none()).map(|s| s.text.as_str()).collect();
        let lost = lost(request, &stated.join(" \n"));
        if lost.is_empty() {
            return Ok(sentences(request, &answer));
        }
        let lost: Vec<String> = lost.iter().map(|word| format!("`{}`", plain(word, 40))).take(20).collect();
        let say = format!(
            "This expansion loses part of the request: {}. Repeat every sentence of the request word for word, without a reason, followed by your own sentences.",
            lost.join(", ")
        );
        let shown: Vec<&str> = stated.iter().take(MOST).copied().collect();
        said.truncate(1);
        said.push(Message::new(Role::Assistant, plain(&shown.join(" "), 4000)));
        said.push(Message::new(Role::User, say));
    }
    asker.diagnostics.push("the request is not expanded, because every expansion lost part of it".into());
    Ok(Sentences::of_request(request))
}

/// Q′ with where each sentence comes from: a stated one from the sentence of the request that it shares most words with.
fn sentences(request: &str, answer: &ExpandAnswer) -> Sentences {
    let own: Vec<_> = sentence_ranges(request).into_iter().map(|at| (counted(&request[at.clone()]), at)).collect();
    let mut out = Sentences::default();
    let mut added = 0;
    for Sentence { text, reason } in &answer.sentences {
        let words = counted(text);
        let shared = |theirs: &Counts| words.keys().filter(|word| theirs.contains_key(*word)).count();
        let nearest = own.iter().rev().max_by_key(|(theirs, _)| shared(theirs));
        match (reason, nearest) {
            (None, Some((theirs, at))) if shared(theirs) > 0 => out.state(folded(text), at.clone()),
            _ if added < MOST => {
                added += 1;
                out.add(plain(text, 400), reason.as_deref().unwrap_or("added by the model"));
            }
            _ => {}
        }
    }
    out
}

type Counts = BTreeMap<String, usize>;

/// Numbers, negations and words that name something, each with how often it stands there. Plurals count as singulars.
fn counted(text: &str) -> Counts {
    let mut counts = Counts::new();
    let lower = text.to_lowercase().replace("n't", " not").replace('’', "'");
    for word in lower.split(|c: char| !(c.is_alphanumeric() || c == '.')) {
        let word = word.trim_matches('.');
        if word.is_empty() || EMPTY.contains(&word) {
            continue;
        }
        let number = word.starts_with(|c: char| c.is_ascii_digit());
        let key = if number || NEGATIONS.contains(&word) { word.to_owned() } else { stem(word) };
        *counts.entry(key).or_default() += 1;
    }
    counts
}

/// What of the request an expansion lacks. Words count once; numbers and negations as often as they are said.
fn lost(request: &str, expanded: &str) -> Vec<String> {
    let theirs = counted(expanded);
    let missing = counted(request).into_iter().filter(|(word, count)| {
        let must = word.starts_with(|c: char| c.is_ascii_digit()) || NEGATIONS.contains(&word.as_str());
        theirs.get(word).copied().unwrap_or(0) < if must { *count } else { 1 }
    });
    missing.map(|(word, _)| word).collect()
}

/// A word without the ending of a plural.
fn stem(word: &str) -> String {
    let cut = match word {
        w if w.len() > 4 && w.ends_with("ies") => return format!("{}y", &w[..w.len() - 3]),
        w if w.len() > 4 && ["ches", "shes", "xes", "sses"].iter().any(|end| w.ends_with(end)) => 2,
        w if w.len() > 3 && w.ends_with('s') && !w.ends_with("ss") => 1,
        _ => 0,
    };
    word[..word.len() - cut].to_owned()
}

#[cfg(test)]
mod tests {
    use super::lost;

    #[test]
    fn nothing_stated_gets_lost() {
        let request = "A room of 2.5 by 2.5 m with two benches, without any rug. Don't put shelves near it.";
        let cases = [
            (request, ""),
            ("Don't put a shelf near it. A room of 2.5 by 2.5 m with two benches, without any rug!", "shelve"),
            ("A room of 2.5 by 3 m with two benches, without any rug. Don't put shelves near it.", "2.5"),
            ("A room of 2.5 by 2.5 m with a bench, without any rug. Don't put shelves near it.", "two"),
            ("A room of 2.5 by 2.5 m with two benches and any rug. Don't put shelves near it.", "without"),
            ("A room of 2.5 by 2.5 m with two benches, without any rug. Put shelves near it.", "not"),
            ("A room of 2.5 by 2.5 m with two chairs, without any rug. Don't put shelves near it.", "bench"),
        ];
        for (expanded, expected) in cases {
            assert_eq!(lost(request, expanded).join(" "), expected, "{expanded}");
        }
    }
}
