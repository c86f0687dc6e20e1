//! The playground's one function, called as a page calls it.

mod examples;
mod questions;
mod strange;

use scenelang_playground::Session;
use serde_json::{Value, json};

/// The answer to a request, or why there is none.
fn ask(session: &mut Session, request: &Value) -> Result<Value, String> {
    raw(session, request.to_string().as_bytes())
}

fn raw(session: &mut Session, request: &[u8]) -> Result<Value, String> {
    let answer: Value = serde_json::from_slice(&session.call(request)).expect("answers are JSON");
    match answer.get("error") {
        Some(why) => Err(why.as_str().expect("why is a text").to_owned()),
        None => Ok(answer["ok"].clone()),
    }
}

/// A session with a program, and what is said of it.
fn opened(text: &str) -> (Session, Value) {
    let mut session = Session::default();
    let marks = ask(&mut session, &json!({ "method": "open", "name": "room.scene", "text": text, "layout": null }));
    let marks = marks.expect("a program is opened whatever it says");
    (session, marks)
}
