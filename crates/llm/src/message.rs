//! What a model is asked, and what it says: plain values that can be written to a file and compared.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Who speaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// The rules of the conversation.
    System,
    /// Who asks.
    User,
    /// The model, earlier in the conversation.
    Assistant,
}

/// One message of a conversation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Message {
    /// Who speaks.
    pub role: Role,
    /// What is said.
    pub text: String,
    /// What is shown; only [`Role::User`] shows anything.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub images: Vec<Image>,
}

impl Message {
    /// A message without images.
    pub fn new(role: Role, text: impl Into<String>) -> Self {
        Self { role, text: text.into(), images: Vec::new() }
    }
}

/// A picture.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Image {
    /// Its media type, such as `image/png`.
    pub media: String,
    /// Its bytes, in base64 with padding.
    pub base64: String,
}

/// What the answer must look like.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Schema {
    /// A short name for it: letters, digits and `_`.
    pub name: String,
    /// A JSON Schema. For all providers to enforce it, every object lists all its properties as required and sets
    /// `additionalProperties` to false, and there are no limits on numbers and lengths; what may be left out is nullable.
    pub json: Value,
}

/// A question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// The conversation so far; it ends with a message of [`Role::User`].
    pub messages: Vec<Message>,
    /// What the answer must look like.
    pub schema: Schema,
    /// How freely the model chooses its words, from 0; without it, as the provider likes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub temperature: Option<f64>,
    /// Fixes the model's choices, as far as the provider offers that. At most 31 bits. Part of
    /// what the cache knows a question by.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// At most so many tokens in the answer.
    pub max_output: u64,
}

/// An answer.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Reply {
    /// The text of it, with the JSON that was asked for, if the model did as it was told.
    pub text: String,
    /// What it took.
    pub usage: Usage,
}

/// Tokens of one answer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Usage {
    /// Tokens read.
    pub input: u64,
    /// Tokens written, those of thinking included.
    pub output: u64,
    /// Whether the provider did not say, and these are our estimate: a token for every three bytes.
    #[serde(default)]
    pub estimated: bool,
}

impl Usage {
    pub(crate) fn add(&mut self, other: Self) {
        self.input = self.input.saturating_add(other.input);
        self.output = self.output.saturating_add(other.output);
        self.estimated |= other.estimated;
    }

    /// The estimate for a question and its answer.
    pub fn estimate(request: &Request, text: &str) -> Self {
        let asked: usize = request.messages.iter().map(|m| m.text.len()).sum();
        let asked = asked + request.schema.json.to_string().len();
        Self { input: asked.div_ceil(3) as u64, output: text.len().div_ceil(3) as u64, estimated: true }
    }
    /// Both kinds together.
    pub fn total(&self) -> u64 {
        self.input.saturating_add(self.output)
    }
}
