//! The language model behind solving and repairing: the editor's own, asked through the client; one that the settings of the
//! workspace name; or none, unless the user of the editor has said which. Keys are the business of whoever connects: none
//! pass through here, and nobody connects unasked.

use crate::client::{Client, Models, Named};
use crate::jobs::Progress;
use crate::state::{Event, State, Stop};
use scenelang_llm::{
    Account, Budget, Error, Limits, Message, Model, Reply, Request, Retry, Session, SystemClock, Usage,
};
use scenelang_solve::Asking;
use scenelang_verify::settings::Llm;
use serde::Serialize;
use serde_json::Value;
use std::sync::Arc;
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};

/// A model, and how it is asked.
pub type ModelQuestion = (Session, Asking);
/// Reaches the model that the user has named, else the one that the settings of a workspace name, for a user who wants that;
/// `None`: nobody names any.
pub type Connect = fn(&Llm, &Named) -> Result<Option<ModelQuestion>, Error>;

/// The longest wait for an answer of the editor's model.
const LONGEST: Duration = Duration::from_secs(180);
/// Larger answers are not read (bytes): the moves of a whole scene are far smaller.
const LARGEST: usize = 4 << 20;

/// Where a model may come from.
#[derive(Clone)]
pub struct Advisers {
    client: Arc<Client>,
    events: Sender<Event>,
    connect: Option<Connect>,
    account: Account,
    stop: Stop,
}

impl Advisers {
    /// The model to ask, if there is one. Before it is asked, the user is told.
    ///
    /// # Errors
    /// It cannot even be tried.
    pub fn model(&self, settings: &Llm, progress: &Progress) -> Result<Option<ModelQuestion>, Error> {
        let asked = match (self.client.model, self.connect) {
            (Models::None, _) | (Models::Configured, None) => None,
            (Models::Client, _) => Some((self.editor()?, Asking::default())),
            (Models::Configured, Some(connect)) => connect(settings, &self.client.named)?,
        };
        let progress = progress.clone();
        Ok(asked.map(|(session, asking)| {
            let session = session.spending_of(&self.account).announced_by(move |said| progress.log(said));
            (session, asking)
        }))
    }

    /// The editor's own model, within the usual budget.
    fn editor(&self) -> Result<Session, Error> {
        let model = Editor { events: self.events.clone(), stop: self.stop.clone() };
        // Whoever did not answer here has said no, and would be asked for consent again.
        let retry = Retry { tries: 1, ..Retry::default() };
        let limits = Limits { retry, budget: Budget::standard(), ..Limits::default() };
        Session::new(Box::new(model), limits, Box::new(SystemClock::new(|| false)))
    }
}

impl State {
    /// Where a model may come from, for work that can be stopped.
    pub fn advisers(&self, stop: Stop) -> Advisers {
        let account = self.account.clone();
        Advisers { client: Arc::clone(&self.client), events: self.events(), connect: self.connect, account, stop }
    }
}

/// What the client is asked with `scenelang/languageModel`.
#[derive(Serialize)]
struct Question {
    messages: Vec<Message>,
    /// What the answer must look like.
    schema: Value,
}

/// The editor's own model.
struct Editor {
    events: Sender<Event>,
    stop: Stop,
}

impl Model for Editor {
    fn name(&self) -> &str {
        "editor"
    }

    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        let unreachable = |why: &str| Error::Unreachable(why.to_owned());
        let params = Question { messages: request.messages.clone(), schema: request.schema.json.clone() };
        let (answer, answered) = mpsc::channel();
        let ask = move |state: &mut State| {
            state.ask_client("scenelang/languageModel", params, move |_, result| {
                // Whoever asked may have given up.
                let _ = answer.send(result);
            });
        };
        self.events.send(Event::Done(Box::new(ask))).map_err(|_| unreachable("the editor is gone"))?;
        let asked = Instant::now();
        let result = loop {
            match answered.recv_timeout(Duration::from_millis(50)) {
                Ok(result) => break result,
                Err(RecvTimeoutError::Disconnected) => return Err(unreachable("the editor is gone")),
                Err(RecvTimeoutError::Timeout) if self.stop.is_set() => return Err(unreachable("it was cancelled")),
                Err(RecvTimeoutError::Timeout) if asked.elapsed() > LONGEST => return Err(Error::TimedOut(LONGEST)),
                Err(RecvTimeoutError::Timeout) => {}
            }
        };
        let text = result.map_err(|e| unreachable(&scenelang_llm::plain(&e.message, 200)))?;
        match &text["text"] {
            Value::String(text) if text.len() > LARGEST => Err(Error::TooLarge(LARGEST as u64)),
            Value::String(text) => Ok(Reply { text: text.clone(), usage: Usage::estimate(request, text) }),
            _ => Err(Error::Malformed("the editor's answer has no text".to_owned())),
        }
    }
}
