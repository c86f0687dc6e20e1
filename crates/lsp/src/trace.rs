//! What the server tells of its own work when the client wants to know: `$/logTrace`, as much of it as `$/setTrace` says.

use serde_json::{Value, json};

/// More of a message than this is not told (bytes): a document may be large.
const MOST: usize = 4 << 10;

/// How much is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Trace {
    /// Nothing.
    #[default]
    Off,
    /// What is done.
    Messages,
    Verbose,
}

impl Trace {
    /// Reads a value of the protocol; what is none of its words is as usual.
    pub fn read(value: &Value) -> Self {
        match value.as_str() {
            Some("messages") => Self::Messages,
            Some("verbose") => Self::Verbose,
            _ => Self::Off,
        }
    }

    /// The parameters of `$/logTrace`; `None`: nobody wants them. `about` is told only where everything is.
    pub fn entry(self, message: impl FnOnce() -> String, about: impl FnOnce() -> String) -> Option<Value> {
        match self {
            Self::Off => None,
            Self::Messages => Some(json!({ "message": message() })),
            Self::Verbose => Some(json!({ "message": message(), "verbose": cut(about()) })),
        }
    }
}

/// The beginning of a text, if it is long.
fn cut(mut text: String) -> String {
    if text.len() > MOST {
        text.truncate(text.floor_char_boundary(MOST));
        text.push('…');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_much_is_told_as_is_wanted() {
        for (word, message, about) in [
            (json!("off"), false, false),
            (json!("messages"), true, false),
            (json!("verbose"), true, true),
            (json!("loud"), false, false),
            (Value::Null, false, false),
        ] {
            let entry = Trace::read(&word).entry(|| "a".to_owned(), || "ä".repeat(5000)).unwrap_or_default();
            assert_eq!(entry["message"].is_string(), message, "{word}");
            let text = entry["verbose"].as_str();
            assert_eq!(text.is_some(), about, "{word}");
            assert!(text.is_none_or(|t| t.len() <= MOST + '…'.len_utf8() && t.ends_with('…')), "{word}");
        }
    }
}
