//! Services that make models: how each is asked, and where it has what it made.
//!
//! The shapes are those that the services document: a task that is looked at until it is done (Meshy, Tripo), a request
//! that answers with the file (the server of Hunyuan3D-2), or a function of an app (Gradio). What comes back is a stranger's
//! file, and is judged as one.

use super::{Maker, Order, Watch, gradio};
use crate::limits;
use scenelang_llm::{Error, Key, Web, plain};
use serde_json::{Value, json};
use std::time::Duration;

/// How long is waited before a task is looked at again, first and at most.
const FIRST: Duration = Duration::from_millis(250);
const LONGEST: Duration = Duration::from_secs(5);
/// How many words of a request are sent (characters): some services take no more.
const PROMPT: usize = 500;

/// How a service is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ServiceKind {
    /// Meshy, version 2 of text to 3D: the preview.
    Meshy,
    /// Tripo, version 2: `text_to_model`.
    Tripo,
    /// `api_server.py` of Hunyuan3D-2, on a machine of your own.
    Hunyuan,
    /// A function of an app of Gradio: the last part of the address.
    Gradio,
}

impl ServiceKind {
    /// The names, each with the address that it has where no other is given, and the variable that holds its key.
    pub const ALL: [(&'static str, Self, &'static str, &'static str); 4] = [
        ("meshy", Self::Meshy, "https://api.meshy.ai", "MESHY_API_KEY"),
        ("tripo", Self::Tripo, "https://api.tripo3d.ai", "TRIPO_API_KEY"),
        ("hunyuan", Self::Hunyuan, "http://127.0.0.1:8080", ""),
        ("gradio", Self::Gradio, "http://127.0.0.1:7860", ""),
    ];

    fn row(self) -> (&'static str, Self, &'static str, &'static str) {
        Self::ALL.into_iter().find(|row| row.1 == self).unwrap_or(Self::ALL[0])
    }
}

/// A service at an address.
#[derive(Debug)]
pub struct Service {
    kind: ServiceKind,
    base: String,
    /// The function of an app of Gradio.
    function: String,
    web: Web,
}

impl Service {
    /// A service; its key comes from the environment.
    ///
    /// # Errors
    /// It needs a key and there is none, or the address is none.
    pub fn new(kind: ServiceKind, base: Option<&str>, timeout: Duration, stop: fn() -> bool) -> Result<Self, String> {
        let (_, _, usual, variable) = kind.row();
        let key = std::env::var(variable).unwrap_or_default();
        Self::on(kind, base.unwrap_or(usual), &key, timeout, stop)
    }

    /// A service at an address, with a key.
    ///
    /// # Errors
    /// As for [`Self::new`].
    pub fn on(kind: ServiceKind, base: &str, key: &str, timeout: Duration, stop: fn() -> bool) -> Result<Self, String> {
        let (name, _, _, variable) = kind.row();
        let key = Key::new(key).filter(|_| !variable.is_empty());
        if !variable.is_empty() && key.is_none() {
            return Err(format!("{name} needs a key: set {variable}"));
        }
        let (base, function) = match kind {
            ServiceKind::Gradio => split(base)?,
            _ => (base, ""),
        };
        let web = Web::new(base, key, timeout, limits::BYTES as u64, stop).map_err(|e| e.to_string())?;
        Ok(Self { kind, base: base.to_owned(), function: function.to_owned(), web })
    }

    /// A task, looked at until it is done: where its file is. `look`: from what is said of a task to its state.
    fn task(&self, path: &str, watch: &Watch, look: fn(&Value) -> State) -> Result<String, String> {
        let mut pause = FIRST;
        loop {
            let said = json_of(&self.web.get(path).map_err(told)?)?;
            match look(&said) {
                State::Done(url) => return Ok(url),
                State::Failed(why) => return Err(format!("the service could not make it: {}", plain(&why, 200))),
                State::Working(percent) => watch.say(&format!("{percent:.0} %")),
            }
            watch.wait(pause)?;
            pause = (pause * 2).min(LONGEST);
        }
    }
}

/// How far a task is.
enum State {
    Working(f64),
    Done(String),
    Failed(String),
}

impl Maker for Service {
    fn name(&self) -> &str {
        self.kind.row().0
    }

    fn identity(&self) -> String {
        format!("{}\0{}\0{}", self.kind.row().0, self.base, self.function)
    }

    fn make(&self, order: &Order, watch: &Watch) -> Result<Vec<u8>, String> {
        let prompt = plain(&order.prompt, PROMPT);
        match self.kind {
            ServiceKind::Hunyuan => {
                let body = json!({ "text": prompt, "texture": false, "type": "glb", "seed": 1234 });
                self.web.post("/generate", body).map_err(told)
            }
            ServiceKind::Gradio => gradio::make(&self.web, &self.base, &self.function, &prompt, watch),
            ServiceKind::Meshy => {
                let path = "/openapi/v2/text-to-3d";
                let body = json!({ "mode": "preview", "prompt": prompt, "should_remesh": true });
                let said = json_of(&self.web.post(path, body).map_err(told)?)?;
                let url = self.task(&format!("{path}/{}", id(&said["result"])?), watch, meshy)?;
                self.web.fetch(&url).map_err(told)
            }
            ServiceKind::Tripo => {
                let path = "/v2/openapi/task";
                let said =
                    json_of(&self.web.post(path, json!({ "type": "text_to_model", "prompt": prompt })).map_err(told)?)?;
                let url = self.task(&format!("{path}/{}", id(&said["data"]["task_id"])?), watch, tripo)?;
                self.web.fetch(&url).map_err(told)
            }
        }
    }
}

/// The address of an app of Gradio, and its function.
fn split(url: &str) -> Result<(&str, &str), String> {
    let (base, function) = url.trim_end_matches('/').rsplit_once('/').unwrap_or_default();
    let is_name = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
    if base.ends_with('/') || base.is_empty() || function.is_empty() || !function.chars().all(is_name) {
        return Err(
            "gradio needs the address of an app with one of its functions: `gradio:URL/FUNCTION`, for example \
                    gradio:http://127.0.0.1:7860/generate"
                .to_owned(),
        );
    }
    Ok((base, function))
}

fn meshy(said: &Value) -> State {
    match said["status"].as_str() {
        Some("SUCCEEDED") => done(&[&said["model_urls"]["glb"]]),
        Some("PENDING" | "IN_PROGRESS") => State::Working(said["progress"].as_f64().unwrap_or(0.0)),
        other => State::Failed(why(&said["task_error"]["message"], other)),
    }
}

fn tripo(said: &Value) -> State {
    let data = &said["data"];
    let output = &data["output"];
    match data["status"].as_str() {
        Some("success") => done(&[&output["pbr_model"], &output["model"], &output["base_model"]]),
        Some("queued" | "running") => State::Working(data["progress"].as_f64().unwrap_or(0.0)),
        other => State::Failed(why(&said["message"], other)),
    }
}

fn done(urls: &[&Value]) -> State {
    match urls.iter().find_map(|url| url.as_str()) {
        Some(url) => State::Done(url.to_owned()),
        None => State::Failed("the service reports that the model is finished, but there is no file".to_owned()),
    }
}

fn why(said: &Value, status: Option<&str>) -> String {
    said.as_str().filter(|s| !s.is_empty()).or(status).unwrap_or("it does not report its state").to_owned()
}

/// The name of a task, which becomes part of an address.
pub(super) fn id(said: &Value) -> Result<&str, String> {
    let fits = |text: &&str| {
        !text.is_empty() && text.len() <= 100 && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_')
    };
    said.as_str().filter(fits).ok_or_else(|| "the service did not name a task".to_owned())
}

pub(super) fn json_of(bytes: &[u8]) -> Result<Value, String> {
    serde_json::from_slice(bytes).map_err(|_| "the service answered with something that is not JSON".to_owned())
}

/// An error in the words of a service.
pub(super) fn told(error: Error) -> String {
    match error {
        Error::Unreachable(why) => format!("the service cannot be reached: {why}"),
        Error::TimedOut(after) => format!("the service did not answer completely within {} s", after.as_secs_f64()),
        Error::TooLarge(most) => format!("the file from the service is larger than {} MB", most >> 20),
        Error::Malformed(why) => format!("the service's answer does not have the expected form: {why}"),
        Error::Limited { said, .. } => format!("the service has received too many requests: {said}"),
        other => other.to_string().replace("the provider", "the service"),
    }
}
