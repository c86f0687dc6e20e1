//! The trait, and the step from an answer to a typed value.

use crate::error::{Error, plain};
use crate::message::{Message, Reply, Request, Role};
use serde::de::DeserializeOwned;

/// How often a model is told that its answer cannot be used, and asked again.
const REPAIRS: usize = 1;
/// How much of an answer that cannot be used is shown to the model again (bytes).
const SHOWN: usize = 2000;

/// A language model: a provider over the network, a recorded conversation, the model of an editor.
pub trait Model {
    /// How it is called in messages, and what the cache knows it by.
    fn name(&self) -> &str;

    /// Answers one question.
    ///
    /// # Errors
    /// Why there is no answer.
    fn ask(&mut self, request: &Request) -> Result<Reply, Error>;

    /// Whether a question leaves this process.
    fn reaches_out(&self) -> bool {
        true
    }
}

/// Asks, and reads the answer as a `T`. An answer that is none is shown to the model with what is wrong with it, once.
///
/// Not every provider holds its models to a schema, so what the answer is worth is decided here: `T` should deny unknown
/// fields.
///
/// # Errors
/// Why there is no answer, or that it is not what was asked for.
pub fn typed<T: DeserializeOwned>(model: &mut dyn Model, request: &Request) -> Result<T, Error> {
    let mut request = request.clone();
    let mut repairs = 0;
    loop {
        let reply = model.ask(&request)?;
        let why = match json_of(&reply.text).and_then(read) {
            Ok(value) => return Ok(value),
            Err(why) => why,
        };
        if repairs == REPAIRS {
            return Err(Error::Malformed(why));
        }
        repairs += 1;
        request.messages.push(Message::new(Role::Assistant, beginning(&reply.text, SHOWN)));
        let say = format!(
            "This answer cannot be used: {why}. Answer again with one JSON object that follows the schema, and nothing else."
        );
        request.messages.push(Message::new(Role::User, say));
    }
}

/// The JSON object in an answer: all of it, or what stands in a fence or between words. Thoughts that a model lets slip
/// before its answer do not count.
///
/// # Errors
/// That there is none.
pub fn json_of(text: &str) -> Result<&str, String> {
    let text = text.rsplit_once("</think>").map_or(text, |(_, after)| after);
    match (text.find('{'), text.rfind('}')) {
        (Some(start), Some(end)) if start < end => Ok(&text[start..=end]),
        (Some(_), _) => Err("its JSON object is not closed".to_owned()),
        _ => Err("it contains no JSON object".to_owned()),
    }
}

fn read<T: DeserializeOwned>(json: &str) -> Result<T, String> {
    serde_json::from_str(json).map_err(|e| plain(&e.to_string(), 200))
}

/// The beginning of a text, cut between characters.
fn beginning(text: &str, most: usize) -> &str {
    &text[..text.floor_char_boundary(most)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::{Schema, Usage};
    use serde::Deserialize;
    use serde_json::json;

    #[derive(Debug, PartialEq, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Point {
        x: f64,
    }

    /// Says these things, one after the other, and remembers what it was asked.
    struct Parrot(Vec<&'static str>, Vec<Request>);

    impl Model for Parrot {
        fn name(&self) -> &str {
            "parrot"
        }
        fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
            self.1.push(request.clone());
            Ok(Reply { text: self.0.remove(0).to_owned(), usage: Usage::default() })
        }
    }

    fn ask(says: &[&'static str]) -> (Result<Point, Error>, Vec<Request>) {
        let mut parrot = Parrot(says.to_vec(), Vec::new());
        let request = Request {
            messages: vec![Message::new(Role::User, "where?")],
            schema: Schema { name: "point".into(), json: json!({}) },
            temperature: None,
            seed: None,
            max_output: 10,
        };
        let answer = typed(&mut parrot, &request);
        (answer, parrot.1)
    }

    #[test]
    fn an_answer_is_read_wherever_its_json_stands() {
        for text in [
            "{\"x\": 1}",
            "```json\n{\"x\": 1}\n```",
            "Here you are: {\"x\": 1.0}. Anything else?",
            "<think>{}?</think>\n{\"x\": 1}",
        ] {
            assert_eq!(ask(&[text]).0, Ok(Point { x: 1.0 }), "{text}");
        }
    }

    #[test]
    fn a_bad_answer_is_sent_back_once() {
        let (answer, asked) = ask(&["{\"x\": \"left\"}", "{\"x\": 2}"]);
        assert_eq!(answer, Ok(Point { x: 2.0 }));
        assert_eq!(asked[1].messages.len(), 3);
        assert_eq!(asked[1].messages[1], Message::new(Role::Assistant, "{\"x\": \"left\"}"));
        assert!(asked[1].messages[2].text.contains("expected f64"), "{}", asked[1].messages[2].text);
        let nested: &'static str = Box::leak(format!("{{\"x\":{}", "[".repeat(100_000)).into_boxed_str());
        let closed: &'static str =
            Box::leak(format!("{{\"x\":{}{}}}", "[".repeat(100_000), "]".repeat(100_000)).into_boxed_str());
        for bad in [
            "",
            "no",
            "{",
            "}{",
            "{\"x\": NaN}",
            "{\"x\": 1e999}",
            "{\"y\": 1}",
            "{\"x\": 1, \"run\": 2}",
            nested,
            closed,
        ] {
            let (answer, asked) = ask(&[bad, bad]);
            assert!(matches!(answer, Err(Error::Malformed(_))), "{bad:.50}: {answer:?}");
            assert_eq!(asked.len(), 2);
        }
    }
}
