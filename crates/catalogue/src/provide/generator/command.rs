//! A program of the user's that makes models.
//!
//! It gets the order as one line of JSON on standard input, and writes a GLB file: to the path that the order names as
//! `out`, or to standard output. What it writes to standard error is shown as its progress, line by line. It is ended, with
//! all that it started, when it takes too long or somebody ends the command.

use super::{LOOK, Maker, Order, Watch, short};
use crate::limits;
use scenelang_base::door::Door;
use serde_json::json;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, Command as Process, Stdio};
use std::sync::mpsc::channel;
use std::time::{Duration, Instant};

/// What the order calls itself.
const FORMAT: &str = "scenelang.order/1";
/// A line of its standard error is not longer (bytes).
const LINE: u64 = 4096;
/// How long is waited for its last words.
const LAST: Duration = Duration::from_millis(200);

/// A program with its arguments. It is the user's word that it may run: who makes one of these asks first.
#[derive(Clone, Debug)]
pub struct Command {
    argv: Vec<String>,
}

impl Command {
    /// The program and its arguments; `None` without a program.
    pub fn new(argv: &[String]) -> Option<Self> {
        argv.first().filter(|program| !program.trim().is_empty())?;
        Some(Self { argv: argv.to_vec() })
    }
}

impl Maker for Command {
    fn name(&self) -> &str {
        "command"
    }

    fn identity(&self) -> String {
        format!("command\0{}", self.argv.join("\0"))
    }

    fn make(&self, order: &Order, watch: &Watch) -> Result<Vec<u8>, String> {
        let (program, arguments) = self.argv.split_first().ok_or("no program is named")?;
        let folder =
            tempfile::tempdir().map_err(|e| format!("cannot create a temporary folder for its output: {e}"))?;
        let out = folder.path().join("model.glb");
        let asked = json!({
            "format": FORMAT,
            "prompt": order.prompt,
            "category": order.category,
            "size": order.size,
            "out": out.display().to_string(),
        });
        let mut process = Process::new(program);
        process.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut process, 0);
        let child = process.spawn().map_err(|e| format!("{} cannot be started: {e}", short(program)))?;
        let said = run(Ended(child), asked.to_string() + "\n", watch)?;
        let bytes = if out.is_file() {
            Door::within(folder.path()).read(&out).map_err(|e| format!("its output cannot be read: {e}"))?
        } else {
            said
        };
        if bytes.is_empty() {
            return Err(
                "it produced no model: there was neither a file at the path `out` nor a GLB file on standard output"
                    .into(),
            );
        }
        Ok(bytes)
    }
}

/// A process that does not outlive what waits for it.
struct Ended(Child);

impl Drop for Ended {
    fn drop(&mut self) {
        if let Ok(Some(_)) = self.0.try_wait() {
            return;
        }
        #[cfg(unix)]
        {
            use rustix::process::{Pid, Signal, kill_process_group};
            let _ = kill_process_group(Pid::from_child(&self.0), Signal::KILL);
        }
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Gives a process its input, and waits for its end: what it wrote to standard output.
fn run(mut process: Ended, input: String, watch: &Watch) -> Result<Vec<u8>, String> {
    let child = &mut process.0;
    let (stdin, stdout, stderr) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
    // Of their own, since it may write before it reads, and what it started may hold the pipes open for longer than it.
    std::thread::spawn(move || stdin.map(|mut stdin| stdin.write_all(input.as_bytes())));
    let (wrote, written) = channel();
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        let most = limits::BYTES as u64 + 1;
        let read = stdout.map(|stdout| stdout.take(most).read_to_end(&mut bytes));
        wrote.send(read.unwrap_or(Ok(0)).map(|_| bytes))
    });
    let (told, telling) = channel();
    std::thread::spawn(move || {
        let mut lines = stderr.map(BufReader::new);
        while let Some(reader) = &mut lines {
            let mut line = Vec::new();
            match reader.by_ref().take(LINE).read_until(b'\n', &mut line) {
                Ok(0) | Err(_) => return,
                Ok(_) if told.send(String::from_utf8_lossy(&line).trim().to_owned()).is_err() => return,
                Ok(_) => {}
            }
        }
    });
    let mut last = String::new();
    let status = loop {
        for said in telling.try_iter().filter(|said| !said.is_empty()) {
            watch.say(&said);
            last = said;
        }
        match child.try_wait() {
            Ok(Some(status)) => break status,
            Ok(None) => watch.wait(LOOK)?,
            Err(e) => return Err(format!("cannot wait for it: {e}")),
        }
    };
    let bytes = loop {
        match written.recv_timeout(LOOK) {
            Ok(bytes) => break bytes.map_err(|e| format!("its standard output cannot be read: {e}"))?,
            Err(std::sync::mpsc::RecvTimeoutError::Disconnected) => break Vec::new(),
            Err(std::sync::mpsc::RecvTimeoutError::Timeout) => {
                if let Some(why) = watch.over() {
                    return Err(why);
                }
            }
        }
    };
    // What it said last may still be on its way, unless something that it started holds the pipe.
    let patience = Instant::now() + LAST;
    while let Ok(said) = telling.recv_timeout(patience.saturating_duration_since(Instant::now())) {
        if !said.is_empty() {
            last = said;
        }
    }
    // Who writes without an end is not listened to any more, and may end by that.
    if !status.success() && bytes.len() <= limits::BYTES {
        let why = if last.is_empty() { String::new() } else { format!(": {}", short(&last)) };
        return Err(format!("it ended with {status}{why}"));
    }
    Ok(bytes)
}
