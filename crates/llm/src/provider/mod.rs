//! Models that are reached over HTTP. A provider is a row in a table: which of four shapes its requests have, where it is,
//! which variable holds its key. One more that speaks like OpenAI is no code at all: `compatible:NAME` and a base URL.

mod anthropic;
mod gemini;
mod http;
mod key;
mod ollama;
mod openai;
mod wait;
mod web;

use crate::clock::SystemClock;
use crate::error::{Error, plain};
use crate::message::{Reply, Request, Role, Usage};
use crate::model::Model;
use crate::session::{Limits, Session};
use crate::tape::Replay;
use http::Http;
pub use key::Key;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::path::Path;
use std::time::Duration;
pub use web::Web;

/// How requests and answers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    OpenAi,
    Anthropic,
    Gemini,
    Ollama,
}

impl Shape {
    fn write(self, question: &Question<'_>, key: Option<&Key>) -> Call {
        match self {
            Self::OpenAi => openai::write(question, key),
            Self::Anthropic => anthropic::write(question, key),
            Self::Gemini => gemini::write(question, key),
            Self::Ollama => ollama::write(question),
        }
    }
    fn read(self, body: &[u8]) -> ReplyText {
        match self {
            Self::OpenAi => openai::read(body),
            Self::Anthropic => anthropic::read(body),
            Self::Gemini => gemini::read(body),
            Self::Ollama => ollama::read(body),
        }
    }
}

#[derive(Debug)]
struct Provider {
    name: &'static str,
    shape: Shape,
    /// Where it is; empty: wherever the user says.
    base: &'static str,
    /// Variables that may hold its key, the first that is set counts. None: it needs no key.
    keys: &'static [&'static str],
    /// Whether it takes requests without a key, too.
    open: bool,
    /// Whether it holds its models to a schema; otherwise the question carries it.
    schemas: bool,
    /// What it calls the limit of an answer, where that differs within a shape.
    most: &'static str,
}

#[rustfmt::skip] // a table
const PROVIDERS: &[Provider] = &[
    Provider { name: "openai", shape: Shape::OpenAi, base: "https://api.openai.com/v1", keys: &["OPENAI_API_KEY"], open: false, schemas: true, most: "max_completion_tokens" },
    Provider { name: "anthropic", shape: Shape::Anthropic, base: "https://api.anthropic.com/v1", keys: &["ANTHROPIC_API_KEY"], open: false, schemas: true, most: "max_tokens" },
    Provider { name: "gemini", shape: Shape::Gemini, base: "https://generativelanguage.googleapis.com/v1beta", keys: &["GEMINI_API_KEY", "GOOGLE_API_KEY"], open: false, schemas: true, most: "maxOutputTokens" },
    Provider { name: "deepseek", shape: Shape::OpenAi, base: "https://api.deepseek.com", keys: &["DEEPSEEK_API_KEY"], open: false, schemas: false, most: "max_tokens" },
    Provider { name: "ollama", shape: Shape::Ollama, base: "http://localhost:11434", keys: &[], open: true, schemas: true, most: "num_predict" },
    Provider { name: "compatible", shape: Shape::OpenAi, base: "", keys: &["SCENELANG_API_KEY"], open: true, schemas: true, most: "max_tokens" },
];

/// The names of the providers, and the variables that may hold their keys.
pub fn providers() -> impl Iterator<Item = (&'static str, &'static [&'static str])> {
    PROVIDERS.iter().map(|p| (p.name, p.keys))
}

/// A model of a provider, as the user names it.
#[derive(Clone, Debug)]
pub struct ModelName {
    provider: &'static Provider,
    model: String,
    base: String,
}

impl ModelName {
    /// Reads `PROVIDER:NAME`, and a base URL that takes the place of the provider's own.
    ///
    /// # Errors
    /// No such provider, a name or URL that cannot be one, no URL where one is needed.
    pub fn new(text: &str, base: Option<&str>) -> Result<Self, Error> {
        let setup = |why: String| Err(Error::Setup(why));
        let known = || PROVIDERS.iter().map(|p| p.name).collect::<Vec<_>>().join(", ");
        let Some((provider, model)) = text.split_once(':') else {
            return setup(format!("a model is given as PROVIDER:NAME; the providers are {}", known()));
        };
        let Some(provider) = PROVIDERS.iter().find(|p| p.name == provider) else {
            return setup(format!("there is no provider `{provider}`; valid names: {}", known()));
        };
        // The name becomes part of an address.
        let fits = |c: char| c.is_ascii_alphanumeric() || "._-:/@".contains(c);
        if model.is_empty() || !model.chars().all(fits) || model.contains("..") {
            return setup(format!("`{model}` is not a valid model name"));
        }
        let base = base.unwrap_or(provider.base).trim_end_matches('/');
        if base.is_empty() {
            return setup(format!(
                "{} is any server with the OpenAI interface: give its address with --base-url",
                provider.name
            ));
        }
        http::check_base(base)?;
        Ok(Self { provider, model: model.to_owned(), base: base.to_owned() })
    }

    /// How it is called: as the user names it, with the URL if that is not the provider's own.
    pub fn name(&self) -> String {
        let Self { provider, model, base } = self;
        let own = base == provider.base;
        format!("{}:{model}{}", provider.name, if own { String::new() } else { format!(" at {base}") })
    }

    /// The key for it, from the environment or else from the keyring of the system.
    ///
    /// # Errors
    /// It needs one and there is none, or would have to send it where others can read it.
    pub fn key(&self) -> Result<Option<Key>, Error> {
        let Provider { name, keys, open, .. } = self.provider;
        let key = keys
            .iter()
            .find_map(|v| Key::from_environment(v))
            .or_else(|| if keys.is_empty() { None } else { Key::from_keyring(name) });
        match key {
            None if !open => Err(Error::Setup(format!("{name} needs a key: set {}", keys.join(" or ")))),
            Some(_) if !http::is_private(&self.base) => Err(Error::Setup(format!(
                "the key of {name} would be sent unencrypted: {} must start with https",
                self.base
            ))),
            key => Ok(key),
        }
    }
}

/// A part of a request that some models do not know.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Temperature,
    Seed,
    Schema,
}

impl Part {
    /// Each with the words by which a provider says that it does not know it.
    const ALL: [(Self, &'static str, &'static [&'static str]); 3] = [
        (Self::Temperature, "temperature", &["temperature"]),
        (Self::Seed, "seed", &["seed"]),
        (Self::Schema, "schema", &["response_format", "json_schema", "output_config", "responseJsonSchema"]),
    ];
}

/// What a shape needs to know to write a request.
struct Question<'a> {
    target: &'a ModelName,
    request: &'a Request,
    left_out: &'a [Part],
}

impl Question<'_> {
    fn temperature(&self) -> Option<f64> {
        self.request.temperature.filter(|_| !self.left_out.contains(&Part::Temperature))
    }
    fn seed(&self) -> Option<u64> {
        self.request.seed.filter(|_| !self.left_out.contains(&Part::Seed))
    }
    /// The schema, if the provider holds its models to it.
    fn schema(&self) -> Option<&Value> {
        let held = self.target.provider.schemas && !self.left_out.contains(&Part::Schema);
        held.then_some(&self.request.schema.json)
    }
    /// The rules of the conversation, with the schema where the provider does not care for it.
    fn system(&self) -> String {
        let said = self.request.messages.iter().filter(|m| m.role == Role::System).map(|m| m.text.as_str());
        let mut text = said.collect::<Vec<_>>().join("\n\n");
        if self.schema().is_none() {
            text += "\n\nAnswer with one JSON object and nothing else. It must follow this JSON Schema:\n";
            text += &self.request.schema.json.to_string();
        }
        text
    }
}

/// A request as it is sent.
struct Call {
    path: String,
    headers: Vec<(&'static str, String)>,
    body: Value,
}

/// What a shape makes of an answer: the text, and the tokens if it says them (read, written).
type ReplyText = Result<(String, Option<(u64, u64)>), Error>;

/// What is around an answer, read as a provider writes it.
fn envelope<T: DeserializeOwned>(body: &[u8]) -> Result<T, Error> {
    serde_json::from_slice(body).map_err(|e| Error::Malformed(plain(&e.to_string(), 200)))
}

/// A model over HTTP; one request for each question, and no second one.
pub struct Remote {
    target: ModelName,
    name: String,
    key: Option<Key>,
    http: Http,
    left_out: Vec<Part>,
}

impl Remote {
    /// A model that gives up after `timeout`, or when an answer is larger than so many bytes, or when `stop` says so.
    ///
    /// # Errors
    /// The system has no certificates.
    pub fn new(
        target: ModelName,
        key: Option<Key>,
        timeout: Duration,
        largest: u64,
        stop: fn() -> bool,
    ) -> Result<Self, Error> {
        let http = Http::new(&target.base, timeout, largest, stop)?;
        Ok(Self { name: target.name(), target, key, http, left_out: Vec::new() })
    }

    /// Which part of the request a provider complains about, if we can do without it.
    fn complaint(&mut self, status: u16, said: &str) -> Option<&'static str> {
        if !matches!(status, 400 | 422) {
            return None;
        }
        let (part, name, _) = *Part::ALL
            .iter()
            .find(|(part, _, words)| !self.left_out.contains(part) && words.iter().any(|w| said.contains(w)))?;
        self.left_out.push(part);
        Some(name)
    }
}

impl Model for Remote {
    fn name(&self) -> &str {
        &self.name
    }

    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        let question = Question { target: &self.target, request, left_out: &self.left_out };
        let (shape, key) = (self.target.provider.shape, self.key.as_ref());
        let got = self.http.post(&self.target.base, shape.write(&question, key), key)?;
        if let Some(error) = http::verdict(&got) {
            return Err(match error {
                Error::Refused { status, said } => match self.complaint(status, &said) {
                    Some(part) => Error::Unsupported(part),
                    None => Error::Refused { status, said },
                },
                error => error,
            });
        }
        let (text, tokens) = shape.read(&got.body)?;
        if text.trim().is_empty() {
            return Err(Error::Malformed("it is empty".into()));
        }
        let usage = match tokens {
            Some((input, output)) => Usage { input, output, estimated: false },
            None => Usage::estimate(request, &text),
        };
        Ok(Reply { text, usage })
    }
}

/// A model that is not to be called: what is asked must be in the cache.
struct Offline(String);

impl Model for Offline {
    fn name(&self) -> &str {
        &self.0
    }
    fn ask(&mut self, _: &Request) -> Result<Reply, Error> {
        Err(Error::Offline)
    }
    fn reaches_out(&self) -> bool {
        false
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Reach<'a> {
    /// `PROVIDER:NAME`, or `replay:FILE` for a recorded conversation.
    pub model: &'a str,
    /// In place of the provider's own.
    pub base: Option<&'a str>,
    /// Answers come from the cache or not at all; no key is needed.
    pub offline: bool,
    /// A request that takes longer has failed.
    pub timeout: Duration,
    /// The largest answer (bytes).
    pub largest: u64,
    /// Whether somebody wants to end it.
    pub stop: fn() -> bool,
}

/// A session with the model that the user names.
///
/// # Errors
/// It cannot even be tried: see [`ModelName`], or the recording cannot be read.
pub fn connect(reach: &Reach<'_>, limits: impl FnOnce(&str) -> Limits) -> Result<Session, Error> {
    let clock = Box::new(SystemClock::new(reach.stop));
    if let Some(path) = reach.model.strip_prefix("replay:") {
        let replay = Replay::open(Path::new(path))?;
        let limits = Limits { record: limits(replay.name()).record, ..Limits::default() };
        return Session::new(Box::new(replay), limits, clock);
    }
    let target = ModelName::new(reach.model, reach.base)?;
    let limits = limits(reach.model);
    let model: Box<dyn Model> = if reach.offline {
        Box::new(Offline(target.name()))
    } else {
        let key = target.key()?;
        Box::new(Remote::new(target, key, reach.timeout, reach.largest, reach.stop)?)
    };
    Session::new(model, limits, clock)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_model_is_named_with_its_provider() {
        for (text, base, wanted) in [
            ("openai:gpt-4o", None, Ok("openai:gpt-4o")),
            ("ollama:llama3.1:8b", None, Ok("ollama:llama3.1:8b")),
            ("ollama:llama3.1:8b", Some("http://box.lan:11434/"), Ok("ollama:llama3.1:8b at http://box.lan:11434")),
            (
                "compatible:qwen/qwen3",
                Some("https://a.example/v1"),
                Ok("compatible:qwen/qwen3 at https://a.example/v1"),
            ),
            ("compatible:qwen", None, Err("any server with the OpenAI interface")),
            ("gpt-4o", None, Err("PROVIDER:NAME")),
            ("opnai:gpt-4o", None, Err("there is no provider `opnai`; valid names: openai, anthropic, gemini")),
            ("openai:", None, Err("is not a valid model name")),
            ("gemini:../../x", None, Err("is not a valid model name")),
            ("gemini:x?key=1", None, Err("is not a valid model name")),
            ("openai:m", Some("ftp://a.example"), Err("must start with https:// or http://")),
            ("openai:m", Some("https://user:secret@a.example"), Err("a base URL")),
            ("openai:m", Some("https://a.example/?x=1"), Err("a base URL")),
            ("openai:m", Some("not a url"), Err("a base URL")),
        ] {
            match (ModelName::new(text, base), wanted) {
                (Ok(target), Ok(name)) => assert_eq!(target.name(), name),
                (Err(Error::Setup(why)), Err(part)) => assert!(why.contains(part), "{text}: {why}"),
                (got, _) => panic!("{text}: {got:?}"),
            }
        }
    }

    #[test]
    fn a_secret_in_a_url_is_not_repeated() {
        let error = ModelName::new("openai:m", Some("https://user:secret@a.example")).unwrap_err();
        assert!(!format!("{error} {error:?}").contains("secret"), "{error:?}");
    }
}
