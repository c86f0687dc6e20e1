//! Conversations as files: recorded while they happen, played back in place of a model.

use crate::error::{Error, plain};
use crate::message::{Reply, Request};
use crate::model::Model;
use crate::whole;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

const FORMAT: &str = "scenelang.conversation/1";

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Conversation {
    format: String,
    model: String,
    turns: Vec<Turn>,
}

/// A question with its answer, or why there was none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Turn {
    request: Request,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    reply: Option<Reply>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    error: Option<String>,
}

/// Writes what is said into a file, after each turn the whole of it.
pub(crate) struct Recorder {
    path: PathBuf,
    conversation: Conversation,
}

impl Recorder {
    /// A recording without turns, so that a file that cannot be written is known before anything is paid.
    ///
    /// # Errors
    /// What the file system says.
    pub(crate) fn new(path: &Path, model: &str) -> Result<Self, Error> {
        let conversation = Conversation { format: FORMAT.into(), model: model.to_owned(), turns: Vec::new() };
        let new = Self { path: path.to_path_buf(), conversation };
        new.write().map(|()| new)
    }

    fn write(&self) -> Result<(), Error> {
        let mut text = serde_json::to_vec_pretty(&self.conversation).map_err(|e| Error::File(e.to_string()))?;
        text.push(b'\n');
        whole::write(&self.path, &text)
    }

    /// Adds a turn.
    ///
    /// # Errors
    /// What the file system says.
    pub(crate) fn add(&mut self, request: &Request, answer: &Result<Reply, Error>) -> Result<(), Error> {
        self.conversation.turns.push(Turn {
            request: request.clone(),
            reply: answer.as_ref().ok().cloned(),
            error: answer.as_ref().err().map(ToString::to_string),
        });
        self.write()
    }
}

/// A recorded conversation in place of a model: it gives the recorded answers to the recorded questions, in their order,
/// and none to others.
#[derive(Clone, Debug)]
pub struct Replay {
    conversation: Conversation,
    next: usize,
}

impl Replay {
    /// Reads a recording.
    ///
    /// # Errors
    /// It cannot be read, or is none.
    pub fn open(path: &Path) -> Result<Self, Error> {
        let text =
            std::fs::read_to_string(path).map_err(|e| Error::File(format!("cannot read {}: {e}", path.display())))?;
        Self::read(&text)
            .map_err(|why| Error::File(format!("{} is not a recorded conversation: {why}", path.display())))
    }

    /// Reads the text of a recording.
    ///
    /// # Errors
    /// Why it is none.
    pub fn read(text: &str) -> Result<Self, String> {
        let conversation: Conversation = serde_json::from_str(text).map_err(|e| plain(&e.to_string(), 200))?;
        if conversation.format != FORMAT {
            return Err(format!("its format is not {FORMAT}"));
        }
        Ok(Self { conversation, next: 0 })
    }

    /// How many turns were played.
    pub fn played(&self) -> usize {
        self.next
    }
}

impl Model for Replay {
    fn name(&self) -> &str {
        &self.conversation.model
    }

    fn reaches_out(&self) -> bool {
        false
    }

    fn ask(&mut self, request: &Request) -> Result<Reply, Error> {
        let n = self.next + 1;
        let Some(turn) = self.conversation.turns.get(self.next) else {
            return Err(Error::OffScript(format!("the recorded conversation ends before question {n}")));
        };
        if turn.request != *request {
            let say = format!("question {n} differs from the recording; record the conversation again");
            return Err(Error::OffScript(say));
        }
        self.next = n;
        match (&turn.reply, &turn.error) {
            (Some(reply), _) => Ok(reply.clone()),
            (None, said) => {
                Err(Error::OffScript(format!("as recorded: {}", plain(said.as_deref().unwrap_or(""), 300))))
            }
        }
    }
}
