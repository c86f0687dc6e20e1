//! The sentences of Q′, numbered: steps name what they rest on by number, and so each thing knows its words.

use crate::draft::ThingOrigin;
use crate::text::{folded, sentence_ranges};
use scenelang_llm::plain;
use serde_json::{Value, json};

/// The sentences of the expanded request.
#[derive(Clone, Debug, Default)]
pub(super) struct Sentences {
    list: Vec<(String, ThingOrigin)>,
}

impl Sentences {
    /// Those of the request alone.
    pub fn of_request(request: &str) -> Self {
        let own = sentence_ranges(request).into_iter();
        Self { list: own.map(|at| (folded(&request[at.clone()]), ThingOrigin::Stated(at))).collect() }
    }

    /// Adds one that the request does not say.
    pub fn add(&mut self, text: String, reason: &str) {
        self.list.push((text, inferred(Some(reason))));
    }

    /// Adds one that says what these bytes of the request say.
    pub fn state(&mut self, text: String, at: std::ops::Range<usize>) {
        self.list.push((text, ThingOrigin::Stated(at)));
    }

    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// As the model is told them: all, or those with these numbers (from 1).
    pub fn told(&self, only: Option<&[usize]>) -> Value {
        let all = self.list.iter().zip(1_usize..).filter(|(_, number)| only.is_none_or(|only| only.contains(number)));
        let told = all.map(|((text, source), number)| {
            json!({ "number": number, "text": text, "stated": matches!(source, ThingOrigin::Stated(_)) })
        });
        told.collect()
    }

    /// Where something comes from that rests on a sentence, or on a reason of the model's own.
    pub fn source(&self, number: Option<i64>, reason: Option<&str>) -> ThingOrigin {
        let index = number.and_then(|number| usize::try_from(number).ok()).and_then(|number| number.checked_sub(1));
        match index.and_then(|index| self.list.get(index)) {
            Some((_, source)) => source.clone(),
            None => inferred(reason),
        }
    }
}

fn inferred(reason: Option<&str>) -> ThingOrigin {
    let reason = plain(reason.unwrap_or(""), 200);
    ThingOrigin::Inferred(if reason.is_empty() { "added by the model".into() } else { reason })
}
