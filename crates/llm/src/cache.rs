//! Answers by content: the same question to the same model is answered from a file, free and the same each time.

use crate::error::Error;
use crate::message::{Reply, Request};
use crate::whole;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Part of what an answer is found by: another number, another meaning of the file.
const FORMAT: &str = "scenelang.answer/1";
/// Larger files are none of ours (bytes).
const LARGEST: u64 = 64 << 20;

/// A folder of answers.
#[derive(Debug)]
pub(crate) struct Cache {
    folder: PathBuf,
}

#[derive(Serialize)]
struct Question<'a> {
    format: &'a str,
    model: &'a str,
    request: &'a Request,
}

#[derive(Serialize, Deserialize)]
struct Entry {
    format: String,
    model: String,
    request: Request,
    reply: Reply,
}

impl Cache {
    pub(crate) fn new(folder: &Path) -> Self {
        Self { folder: folder.to_path_buf() }
    }

    /// The file of a question.
    fn file(&self, model: &str, request: &Request) -> PathBuf {
        let bytes = serde_json::to_vec(&Question { format: FORMAT, model, request }).unwrap_or_default();
        let mut hex = String::with_capacity(64);
        for byte in Sha256::digest(&bytes) {
            let _ = write!(hex, "{byte:02x}");
        }
        self.folder.join(&hex[..2]).join(format!("{}.json", &hex[2..]))
    }

    /// The answer, if there is one. A file that was damaged is as good as none.
    pub(crate) fn get(&self, model: &str, request: &Request) -> Option<Reply> {
        let mut bytes = Vec::new();
        let file = std::fs::File::open(self.file(model, request)).ok()?;
        file.take(LARGEST).read_to_end(&mut bytes).ok()?;
        let entry: Entry = serde_json::from_slice(&bytes).ok()?;
        (entry.format == FORMAT && entry.model == model && entry.request == *request).then_some(entry.reply)
    }

    /// Keeps an answer.
    ///
    /// # Errors
    /// What the file system says.
    pub(crate) fn put(&self, model: &str, request: &Request, reply: &Reply) -> Result<(), Error> {
        let entry = Entry {
            format: FORMAT.to_owned(),
            model: model.to_owned(),
            request: request.clone(),
            reply: reply.clone(),
        };
        let bytes = serde_json::to_vec_pretty(&entry).map_err(|e| Error::File(e.to_string()))?;
        whole::write(&self.file(model, request), &bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::{Message, Role, Schema, Usage};

    #[test]
    fn an_answer_belongs_to_its_question_and_model() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::new(folder.path());
        let request = Request {
            messages: vec![Message::new(Role::User, "where?")],
            schema: Schema { name: "s".into(), json: serde_json::json!({"type": "object"}) },
            temperature: Some(0.7),
            seed: Some(1),
            max_output: 10,
        };
        let reply = Reply { text: "{}".into(), usage: Usage { input: 1, output: 2, estimated: false } };
        assert_eq!(cache.get("m", &request), None);
        cache.put("m", &request, &reply).unwrap();
        assert_eq!(cache.get("m", &request), Some(reply.clone()));
        assert_eq!(cache.get("n", &request), None);
        for other in [
            Request { seed: Some(2), ..request.clone() },
            Request { temperature: None, ..request.clone() },
            Request { max_output: 11, ..request.clone() },
        ] {
            assert_eq!(cache.get("m", &other), None);
        }
        // Damage is a miss, and repaired by the next answer.
        let file = cache.file("m", &request);
        for damage in [&b"{"[..], b"", b"\xff", b"{\"format\": \"scenelang.answer/0\"}"] {
            std::fs::write(&file, damage).unwrap();
            assert_eq!(cache.get("m", &request), None);
        }
        cache.put("m", &request, &reply).unwrap();
        assert_eq!(cache.get("m", &request), Some(reply));
        assert_eq!(std::fs::read_dir(file.parent().unwrap()).unwrap().count(), 1, "no temporary files stay");
    }
}
