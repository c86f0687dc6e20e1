//! A session as a file, one message a line, and such a file played again.
//!
//! Each line is `{"from": "client", "message": {…}}` or `{"from": "server", …}`. A recording has the texts of documents in
//! it, and no keys: those never pass through the protocol.

use crate::frames::{self, Frame};
use serde_json::{Value, json};
use std::collections::{HashSet, VecDeque};
use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::Path;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::Duration;

/// How each line of a recording begins.
const START: &str = "{\"from\":";

/// Writes down what is said.
#[derive(Clone)]
pub struct Recorder(Arc<Mutex<BufWriter<File>>>);

impl Recorder {
    /// A recording in a new file, or in place of another recording.
    ///
    /// # Errors
    /// What the file system says; or that the file is none of ours.
    pub fn new(path: &Path) -> io::Result<Self> {
        if std::fs::metadata(path).is_ok_and(|data| data.is_file() && data.len() > 0) {
            let mut start = Vec::new();
            File::open(path)?.take(START.len() as u64).read_to_end(&mut start)?;
            if start != START.as_bytes() {
                let say = format!("{} already exists and is not a recorded session; name another file", path.display());
                return Err(io::Error::new(io::ErrorKind::AlreadyExists, say));
            }
        }
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

/// Plays the client of a recording to a server, whose messages go to `output`; the exit code. A message of the client waits
/// until the server has answered, and asked, what it had in the recording: so the answers are the same, whatever the speed
/// of the machine.
///
/// # Errors
/// The file cannot be read, or is no recording.
pub fn replay(path: &Path, output: impl Write + Send + 'static) -> io::Result<u8> {
    let mut steps = Vec::new();
    for (number, line) in BufReader::new(File::open(path)?).lines().enumerate() {
        let bad =
            || io::Error::new(io::ErrorKind::InvalidData, format!("line {} is not part of a recording", number + 1));
        let mut line: Value = serde_json::from_str(&line?).map_err(|_| bad())?;
        let mut message = line["message"].take();
        match line["from"].as_str() {
            Some("client") if message.is_object() => {
                // Whoever recorded it may be gone by now.
                if message["method"] == "initialize" {
                    message["params"]["processId"] = Value::Null;
                }
                steps.push(Step::Say(frames::framed(&message)));
            }
            Some("server") => steps.extend(key(&message).map(Step::Await)),
            _ => return Err(bad()),
        }
    }
    let heard = Arc::new(Heard::default());
    let client = Player { steps: steps.into(), rest: io::Cursor::new(Vec::new()), heard: Arc::clone(&heard) };
    Ok(crate::serve(client, Listener { output, heard }, crate::Setup::default()))
}

/// A step of the client of a recording.
enum Step {
    /// It says this.
    Say(Vec<u8>),
    /// It has seen this message of the server.
    Await(String),
}

/// What names an answer or a question; what is only told comes when it comes.
fn key(message: &Value) -> Option<String> {
    message.get("id").map(|id| format!("{} {id}", message["method"].as_str().unwrap_or("answer")))
}

/// What the server has said so far.
#[derive(Default)]
struct Heard {
    keys: Mutex<HashSet<String>>,
    more: Condvar,
}

/// The client of a recording, as a stream.
struct Player {
    steps: VecDeque<Step>,
    rest: io::Cursor<Vec<u8>>,
    heard: Arc<Heard>,
}

impl Read for Player {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        /// A server that never says it is another one than was recorded; the session goes on.
        const PATIENCE: Duration = Duration::from_secs(30);
        loop {
            let count = self.rest.read(out)?;
            if count > 0 {
                return Ok(count);
            }
            match self.steps.pop_front() {
                None => return Ok(0),
                Some(Step::Say(bytes)) => self.rest = io::Cursor::new(bytes),
                Some(Step::Await(key)) => {
                    let keys = self.heard.keys.lock().unwrap_or_else(PoisonError::into_inner);
                    let missing = |keys: &mut HashSet<String>| !keys.contains(&key);
                    drop(self.heard.more.wait_timeout_while(keys, PATIENCE, missing));
                }
            }
        }
    }
}

/// Where the server writes: everything is passed on.
struct Listener<W> {
    output: W,
    heard: Arc<Heard>,
}

impl<W: Write> Write for Listener<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Whole frames come at once.
        let mut frames = bytes;
        while let Ok(Some(Frame::Message(message))) = frames::next(&mut frames) {
            if let Some(key) = key(&message) {
                self.heard.keys.lock().unwrap_or_else(PoisonError::into_inner).insert(key);
                self.heard.more.notify_all();
            }
        }
        self.output.write_all(bytes)?;
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        self.output.flush()
    }
}
