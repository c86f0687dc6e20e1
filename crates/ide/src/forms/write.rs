//! Writing JSON by hand, where a value would be as deep as a tree is: nothing here recurses.

use serde_json::Value;
use std::fmt::Write;

/// A JSON text in the making. Whoever calls sees to it that names and values alternate.
#[derive(Default)]
pub struct Json {
    text: String,
}

impl Json {
    /// Begins an object or an array.
    pub fn open(&mut self, bracket: char) {
        self.separate();
        self.text.push(bracket);
    }
    /// Ends an object or an array.
    pub fn close(&mut self, bracket: char) {
        self.text.push(bracket);
    }
    /// The name of a member, whose value follows.
    pub fn name(&mut self, name: &str) {
        self.separate();
        // Our names need no escapes.
        let _ = write!(self.text, "\"{name}\":");
    }
    pub fn value(&mut self, value: impl Into<Value>) {
        self.separate();
        let _ = write!(self.text, "{}", value.into());
    }
    pub fn member(&mut self, name: &str, value: impl Into<Value>) {
        self.name(name);
        self.value(value);
    }
    /// Its text.
    pub fn finish(self) -> String {
        self.text
    }

    fn separate(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with(['{', '[', ':']) {
            self.text.push(',');
        }
    }
}
