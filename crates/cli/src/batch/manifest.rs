//! The manifest: a job on each line, as a JSON object. Whatever a line is, the others are read.

use scenelang_base::door::Door;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

/// Longer lines (bytes) are no jobs.
pub const LONGEST: usize = 1 << 20;
/// The longest name.
const LONGEST_NAME: usize = 100;
/// How lines without a name are called; no name begins so.
const UNNAMED: &str = "line-";

/// What a line asks for.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// What its files are called.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// A request in plain words.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub request: Option<String>,
    /// A program's file, seen from the folder of the manifest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// A program's text.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// Fixes draws and every random choice.
    #[serde(default)]
    pub seed: u64,
    /// N times the usual work before the solver gives up.
    #[serde(default = "one")]
    pub effort: u64,
    /// How much of the work may go into preferences, in percent.
    #[serde(default = "usual")]
    pub quality: u8,
    /// Add nothing that the request does not say.
    #[serde(default)]
    pub literal: bool,
}

fn one() -> u64 {
    1
}

fn usual() -> u8 {
    scenelang_solve::QUALITY
}

/// A line of the manifest.
#[derive(Clone, Debug)]
pub struct Line {
    /// Counted from 1, as editors do.
    pub number: usize,
    /// What its files are called.
    pub name: String,
    /// A sum of what it asks for: results with another are of an older manifest.
    pub key: String,
    /// What it asks for, or what is wrong with it.
    pub job: Result<Job, String>,
}

/// The lines of a manifest that are not blank, and a sum of them all.
pub fn lines(bytes: &[u8], path: &Path) -> (Vec<Line>, String) {
    let door = Door::of(path);
    let mut names = BTreeSet::new();
    // A byte order mark, as some editors write it.
    let text = bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(bytes);
    let texts = text.split(|b| *b == b'\n').enumerate().filter(|(_, text)| !text.trim_ascii().is_empty());
    let lines = texts.map(|(index, text)| {
        let number = index + 1;
        let job = job(text, path, &door).and_then(|job| match &job.name {
            // Some file systems do not tell large letters from small ones.
            Some(name) if !names.insert(name.to_ascii_lowercase()) => {
                Err(format!("the name {name:?} was already used on an earlier line; each line needs its own"))
            }
            _ => Ok(job),
        });
        let unnamed = || format!("{UNNAMED}{number:09}");
        let name = job.as_ref().ok().and_then(|job| job.name.clone()).unwrap_or_else(unnamed);
        let mut key = sum(text.trim_ascii());
        // A program that was changed since is another job.
        if let Ok(Job { program: Some(program), .. }) = &job {
            let text = door.read(&beside(path, program)).unwrap_or_default();
            key = sum(format!("{key} {}", sum(&text)).as_bytes());
        }
        Line { number, name, key, job }
    });
    (lines.collect(), sum(bytes))
}

/// A file seen from the folder of another.
pub fn beside(manifest: &Path, name: &str) -> std::path::PathBuf {
    manifest.parent().unwrap_or(Path::new("")).join(name)
}

fn job(text: &[u8], path: &Path, door: &Door) -> Result<Job, String> {
    let text = text.trim_ascii();
    if text.len() > LONGEST {
        let (long, most) = (text.len() as f64 / f64::from(1 << 20), LONGEST >> 20);
        return Err(format!(
            "the line is {long:.1} MiB long, and at most {most} MiB is read; put a long program into a file"
        ));
    }
    let text = std::str::from_utf8(text).map_err(|_| "the line is not valid UTF-8".to_owned())?;
    let job: Job = serde_json::from_str(text).map_err(|e| {
        // All of it stands on one line, so only the column helps.
        let why = e.to_string();
        let why = why.split(" at line ").next().unwrap_or(&why).to_owned();
        format!("column {}: {why}; a line is an object such as {{\"name\": \"study\", \"request\": \"…\"}}", e.column())
    })?;
    if let Some(name) = &job.name {
        is_name(name)?;
    }
    match (&job.request, &job.program, &job.source) {
        (Some(_), None, None) | (None, None, Some(_)) => {}
        (None, Some(program), None) => {
            door.permits(&beside(path, program)).map_err(|e| format!("the program {program:?} cannot be read: {e}"))?;
        }
        _ => return Err("a line must have exactly one of \"request\", \"program\" and \"source\"".to_owned()),
    }
    if job.seed >= 1 << 53 {
        return Err("a seed must be less than 2^53, so that every JSON reader can represent it exactly".to_owned());
    }
    if job.quality > 100 || !(1..=1000).contains(&job.effort) {
        return Err("\"quality\" is 0 to 100, \"effort\" 1 to 1000".to_owned());
    }
    Ok(job)
}

/// Whether it can be part of the names of files, on any system.
fn is_name(name: &str) -> Result<(), String> {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    let good = !name.is_empty()
        && name.len() <= LONGEST_NAME
        && name.chars().all(plain)
        && !name.starts_with(['.', '-'])
        && !name.to_ascii_lowercase().starts_with(UNNAMED)
        && !is_device(name);
    if good {
        return Ok(());
    }
    Err(format!(
        "{:?} cannot be a name: a name consists of letters, digits, `-`, `_` and `.`, at most {LONGEST_NAME} characters, begins with a letter or \
         digit, and does not begin with {UNNAMED:?}",
        name.chars().take(LONGEST_NAME).collect::<String>()
    ))
}

/// What Windows takes for a device, whatever follows the dot.
fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().to_ascii_lowercase();
    let numbered = |start: &str| stem.strip_prefix(start).is_some_and(|rest| rest.len() == 1);
    ["con", "prn", "aux", "nul"].contains(&stem.as_str()) || numbered("com") || numbered("lpt")
}

fn sum(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().take(16).fold(String::new(), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_an_editor_saves_a_manifest_changes_no_line() {
        let plain = "{\"request\": \"a chair\"}\n\n{\"name\": \"b\", \"source\": \"object a;\"}\n";
        let read = |text: &str| {
            let (lines, _) = lines(text.as_bytes(), Path::new("manifest.jsonl"));
            lines.into_iter().map(|line| (line.number, line.name, line.key, line.job.is_ok())).collect::<Vec<_>>()
        };
        let same = read(plain);
        assert!(same.len() == 2 && same.iter().all(|(.., good)| *good), "{same:?}");
        let windows = plain.replace('\n', "\r\n");
        for text in [format!("\u{feff}{plain}"), windows.clone(), format!("\u{feff}{windows}")] {
            assert_eq!(read(&text), same);
        }
    }

    #[test]
    fn bad_lines_are_said_and_the_others_are_read() {
        let long = format!("{{\"request\": \"{}\"}}", "x".repeat(2 << 20));
        let manifest = [
            r#"{"name": "a", "request": "a chair"}"#,
            "",
            r#"{"name": "../b", "request": "a chair"}"#,
            r#"{"name": "A", "source": "object a;"}"#,
            r#"{"source": "object a;", "seed": 3}"#,
            r#"{"source": "object a;", "sed": 3}"#,
            r#"{"source": "object a;", "request": "a chair"}"#,
            "{",
            &long,
            r#"{"name": "con.x", "source": ""}"#,
            r#"{"program": "../../../../etc/passwd"}"#,
        ]
        .join("\n");
        let (lines, _) = lines(manifest.as_bytes(), Path::new("/tmp/somewhere/manifest.jsonl"));
        let numbers: Vec<usize> = lines.iter().map(|line| line.number).collect();
        assert_eq!(numbers, [1, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
        let good: Vec<&str> = lines.iter().filter(|line| line.job.is_ok()).map(|line| line.name.as_str()).collect();
        assert_eq!(good, ["a", "line-000000005"]);
        let said = |at: usize| lines[at].job.as_ref().err().cloned().unwrap_or_default();
        assert!(said(1).contains("cannot be a name"), "{}", said(1));
        assert!(said(2).contains("earlier line"), "{}", said(2));
        assert!(said(4).contains("unknown field `sed`"), "{}", said(4));
        assert!(said(5).contains("one of"), "{}", said(5));
        assert!(said(7).contains("2.0 MiB"), "{}", said(7));
        assert!(said(8).contains("cannot be a name"), "{}", said(8));
        assert!(said(9).contains("cannot be read"), "{}", said(9));
    }
}
