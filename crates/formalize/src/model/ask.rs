//! One question to the model: the prompt of the step, what the step knows as JSON, the schema of its answer.

use super::Asking;
use scenelang_llm::{Error, Message, Model, Reply, Request, Role, Schema, plain, typed};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

/// Seeds that every provider takes: 31 bits.
const SEEDS: u64 = 0x7fff_ffff;

/// What a step tells the model it is to do.
#[derive(Clone, Copy, Debug)]
pub struct Prompt {
    /// The step, as schema and diagnostics call it.
    pub step: &'static str,
    /// The file; its first line has the version.
    pub text: &'static str,
}

macro_rules! prompts {
    ($($name:ident $step:literal;)*) => {
        $(pub(super) const $name: Prompt = Prompt {
            step: $step,
            text: include_str!(concat!("../../prompts/", $step, ".md")),
        };)*
        /// All prompts, in the order of the steps.
        pub const PROMPTS: &[Prompt] = &[$($name),*];
    };
}

prompts! {
    SCENE "scene";
    EXPAND "expand";
    DIVIDE "divide";
    CONNECT "connect";
    PLACE "place";
    FURNISH "furnish";
    CONSTRAIN "constrain";
    REDUNDANT "redundant";
    CONTRADICTORY "contradictory";
    COMPLETE "complete";
}

/// The language, for the steps that write statements.
pub(super) const LANGUAGE: &str = include_str!("../../prompts/language.md");

/// What asking took.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Usage {
    /// Questions, those answered from a cache included.
    pub calls: usize,
    /// Tokens read.
    pub input: u64,
    /// Tokens written.
    pub output: u64,
    /// Which step asked how often, in order.
    pub steps: Vec<(&'static str, usize)>,
}

/// Why a step has no answer.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Trouble {
    /// The answer cannot be used; the next step may be luckier.
    Answer(Error),
    /// Nobody will answer any more: no budget, no network.
    Over(Error),
}

impl Trouble {
    pub fn error(self) -> Error {
        match self {
            Self::Answer(error) | Self::Over(error) => error,
        }
    }
}

impl From<Error> for Trouble {
    fn from(error: Error) -> Self {
        let last = match &error {
            Error::GaveUp(_, last) => last,
            other => other,
        };
        match last {
            Error::Malformed(_) | Error::CutShort | Error::Declined(_) | Error::TooLarge(_) => Self::Answer(error),
            _ => Self::Over(error),
        }
    }
}

/// The model, how it is asked, and what came of it so far.
pub(super) struct Asker<'m> {
    model: &'m mut dyn Model,
    pub asking: Asking,
    pub diagnostics: Vec<String>,
    usage: Usage,
}

/// Counts what a model says.
struct Counted<'a>(&'a mut dyn Model, &'a mut Usage);

impl Model for Counted<'_> {
    fn name(&self) -> &str {
        self.0.name()
    }
    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        self.1.calls += 1;
        if let Some((_, times)) = self.1.steps.last_mut() {
            *times += 1;
        }
        let reply = self.0.ask(request)?;
        self.1.input = self.1.input.saturating_add(reply.usage.input);
        self.1.output = self.1.output.saturating_add(reply.usage.output);
        Ok(reply)
    }
}

impl<'m> Asker<'m> {
    pub fn new(model: &'m mut dyn Model, asking: Asking) -> Self {
        Self { model, asking, diagnostics: Vec::new(), usage: Usage::default() }
    }

    pub fn into_parts(self) -> (Vec<String>, Usage) {
        (self.diagnostics, self.usage)
    }

    /// Asks what the step asks, about what it knows.
    pub fn ask<T: DeserializeOwned>(&mut self, prompt: Prompt, schema: Value, known: &Value) -> Result<T, Trouble> {
        self.converse(prompt, schema, vec![Message::new(Role::User, known.to_string())])
    }

    /// The same in a conversation that has gone on.
    pub fn converse<T: DeserializeOwned>(
        &mut self,
        prompt: Prompt,
        schema: Value,
        said: Vec<Message>,
    ) -> Result<T, Trouble> {
        let writes = [CONSTRAIN.step, COMPLETE.step].contains(&prompt.step);
        let rules = if writes { format!("{}\n{LANGUAGE}", prompt.text) } else { prompt.text.to_owned() };
        let messages = std::iter::once(Message::new(Role::System, rules)).chain(said).collect();
        let request = Request {
            messages,
            schema: Schema { name: prompt.step.into(), json: schema },
            temperature: if prompt.step == SCENE.step { Some(0.0) } else { self.asking.temperature },
            seed: Some(self.asking.seed & SEEDS),
            max_output: self.asking.max_output,
        };
        if self.usage.steps.last().is_none_or(|(step, _)| *step != prompt.step) {
            self.usage.steps.push((prompt.step, 0));
        }
        typed(&mut Counted(self.model, &mut self.usage), &request).map_err(Trouble::from)
    }

    /// A step, or something in its place where its answer cannot be used.
    ///
    /// # Errors
    /// Nobody answers any more.
    pub fn or_else<T>(
        &mut self,
        step: impl Fn(&mut Self, &str) -> Result<T, Trouble>,
        request: &str,
        otherwise: impl Fn(&str) -> T,
    ) -> Result<T, Error> {
        step(self, request).or_else(|trouble| {
            let step = self.usage.steps.last().map_or("a step", |(step, _)| step).to_owned();
            self.tell(&format!("the step `{step}` is left out"), trouble)?;
            Ok(otherwise(request))
        })
    }

    /// Remembers that something is left out.
    ///
    /// # Errors
    /// Nobody answers any more.
    pub fn tell(&mut self, what: &str, trouble: Trouble) -> Result<(), Error> {
        match trouble {
            Trouble::Answer(error) => {
                self.diagnostics.push(format!("{what}: {error}"));
                Ok(())
            }
            Trouble::Over(error) => Err(error),
        }
    }
}

/// A schema of an object with these properties, all of them required.
pub(super) fn object(properties: &Value) -> Value {
    let names: Vec<&str> = properties.as_object().into_iter().flatten().map(|(name, _)| name.as_str()).collect();
    json!({ "type": "object", "required": names, "additionalProperties": false, "properties": properties })
}

/// A schema of a list.
pub(super) fn list(items: &Value) -> Value {
    json!({ "type": "array", "items": items })
}

/// A schema of a value that may be null.
pub(super) fn maybe(kind: &str) -> Value {
    json!({ "type": [kind, "null"] })
}

/// What somebody else wrote, short and on one line; `None` if nothing is left.
pub(super) fn words(text: Option<&str>) -> Option<String> {
    let text = plain(text?, 120);
    (!text.is_empty()).then_some(text)
}

/// A length that can be built, in metres; `usual` for what is none.
pub(super) fn length(metres: f64, [least, most]: [f64; 2], usual: f64) -> f64 {
    let bounded = if (least..=most).contains(&metres) { metres } else { usual };
    (bounded * 1e4).round() / 1e4
}
