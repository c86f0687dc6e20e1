//! What a command prints. The macros here stand in front of those of the standard library, which panic when nobody reads any
//! more (`scenelang check . | head -1`), so no command can forget it.
//!
//! A command whose reader is gone goes on and does what else it was asked to: a file that it was to write is written. Then
//! [`end`] gives it the exit code of a closed pipe.

use crate::FAILED;
use scenelang_base::plain;
use std::fmt::Arguments;
use std::io::{self, ErrorKind, IsTerminal, Write};
use std::sync::OnceLock;

/// The exit code of a program whose reader is gone, as shells have it.
pub const CLOSED: u8 = 141;

/// Why nothing more is printed.
static FAULT: OnceLock<io::Error> = OnceLock::new();

macro_rules! print {
    ($($what:tt)*) => { $crate::out::print(format_args!($($what)*)) };
}
macro_rules! println {
    ($($what:tt)*) => { $crate::out::print(format_args!("{}\n", format_args!($($what)*))) };
}
macro_rules! eprint {
    ($($what:tt)*) => { $crate::out::tell(format_args!($($what)*)) };
}
macro_rules! eprintln {
    ($($what:tt)*) => { $crate::out::tell(format_args!("{}\n", format_args!($($what)*))) };
}

/// Standard output, as a stream that never fails: after the first fault nothing is written any more.
pub struct Out;

impl Write for Out {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        Ok(unless_ended(|| io::stdout().write(bytes)).unwrap_or(bytes.len()))
    }
    fn flush(&mut self) -> io::Result<()> {
        unless_ended(|| io::stdout().flush());
        Ok(())
    }
}

fn unless_ended<T>(write: impl Fn() -> io::Result<T>) -> Option<T> {
    while FAULT.get().is_none() {
        match write() {
            Ok(done) => return Some(done),
            // A signal came; nothing is written yet.
            Err(e) if e.kind() == ErrorKind::Interrupted => {}
            Err(e) => drop(FAULT.set(e)),
        }
    }
    None
}

/// Prints to standard output.
pub fn print(what: Arguments<'_>) {
    let _ = Out.write_fmt(what);
}

/// Prints a text that is for people, and has words of files in it: nothing in it acts on a terminal or a build server.
pub fn show(text: &str) {
    print(format_args!("{}", plain::lines(text)));
}

/// Prints to standard error, nothing that acts there but colours. Where that fails there is nobody left to tell.
pub fn tell(what: Arguments<'_>) {
    let _ = io::stderr().write_all(painted(&what.to_string()).as_bytes());
}

/// The text as [`plain::lines`] has it, but with the colours that a terminal is given: what files say has been cleaned
/// before it was painted.
fn painted(text: &str) -> String {
    if !io::stderr().is_terminal() {
        return plain::lines(text).into_owned();
    }
    let mut out = String::new();
    for (i, part) in text.split("\x1b[").enumerate() {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != ';').filter(|at| part[*at..].starts_with('m'));
        match end {
            Some(at) if i > 0 => out += &format!("\x1b[{}m{}", &part[..at], plain::lines(&part[at + 1..])),
            _ => out += &plain::lines(part),
        }
    }
    out
}

/// Whether whoever read standard output has seen enough.
pub fn is_closed() -> bool {
    FAULT.get().is_some_and(|e| e.kind() == ErrorKind::BrokenPipe)
}

/// The exit code of a command that would end with `code`, all things considered.
pub fn end(code: u8) -> u8 {
    let _ = Out.flush();
    match FAULT.get() {
        None => code,
        Some(_) if is_closed() => CLOSED,
        Some(e) => {
            tell(format_args!("error: cannot write to standard output: {e}\n"));
            FAILED
        }
    }
}
