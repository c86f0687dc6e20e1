//! A session as a file, one message a line, and such a file played again.
//!
//! Each line is `{"from": "client", "message": {…}}` or `{"from": "server", …}`. A recording has the texts of documents in
//! it, and no keys: those never pass through the protocol.

use crate::frames::{self, Frame};
use serde_json::{Value, json};
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// Writes down what is said.
#[derive(Clone)]
pub struct Recorder(Arc<Mutex<BufWriter<File>>>);

impl Recorder {
    /// A recording in a new file.
    ///
    /// # Errors
    /// What the file system says.
    pub fn new(path: &Path) -> io::Result<Self> {
        Ok(Self(Arc::new(Mutex::new(BufWriter::new(File::create(path)?)))))
    }

    /// A message of the client.
    pub fn heard(&self, message: &Value) {
        self.line("client", message);
    }

    /// Whole frames of ours.
    pub fn said(&self, mut bytes: &[u8]) {
        while let Ok(Some(Frame::Message(message))) = frames::next(&mut bytes) {
            self.line("server", &message);
        }
    }

    fn line(&self, from: &str, message: &Value) {
        let mut file = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        // A full disk must not end the session.
        let _ = writeln!(file, "{}", json!({ "from": from, "message": message })).and_then(|()| file.flush());
    }
}

/// What the client said in a recording, as a stream to be served again. The client's answers to our questions are in it
/// too: the questions are asked in the same order, and so have the same numbers.
///
/// # Errors
/// The file cannot be read, or is no recording.
pub fn replay(path: &Path) -> io::Result<impl Read + Send + use<>> {
    let mut wire = Vec::new();
    for (number, line) in BufReader::new(File::open(path)?).lines().enumerate() {
        let bad = || io::Error::new(io::ErrorKind::InvalidData, format!("line {} is not of a recording", number + 1));
        let line: Value = serde_json::from_str(&line?).map_err(|_| bad())?;
        match (line["from"].as_str(), &line["message"]) {
            (Some("client"), message) if message.is_object() => {
                let mut message = message.clone();
                // Whoever recorded it may be gone by now.
                if message["method"] == "initialize" {
                    message["params"]["processId"] = Value::Null;
                }
                wire.extend(frames::framed(&message));
            }
            (Some("server"), _) => {}
            _ => return Err(bad()),
        }
    }
    Ok(io::Cursor::new(wire))
}
