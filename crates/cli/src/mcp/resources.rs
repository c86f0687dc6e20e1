//! What clients may read without a tool: the guide of the language, the programs of the workspace, and their reports.

use super::tools::Call;
use super::workspace::{called, is_program};
use crate::targets::{self, JudgeTarget};
use rmcp::model::{Resource, ResourceContents, ResourceTemplate};
use scenelang_verify::report;
use std::path::{Path, PathBuf};

/// So many programs are listed.
const LISTED: usize = 100;
const GUIDE: &str = "scenelang://guide";
const PROGRAM: &str = "scenelang://program/";
const REPORT: &str = "scenelang://report/";

/// Chapters of the book from which the language can be learnt.
const CHAPTERS: [&str; 6] = [
    include_str!("../../../../spec/src/tutorial/first-room.md"),
    include_str!("../../../../spec/src/tutorial/many-things.md"),
    include_str!("../../../../spec/src/tutorial/doors-and-ways.md"),
    include_str!("../../../../spec/src/reference/statements.md"),
    include_str!("../../../../spec/src/reference/expressions.md"),
    include_str!("../../../../spec/src/reference/predicates.md"),
];

/// What there is to read.
pub fn listed() -> Vec<Resource> {
    let guide = Resource::new(GUIDE, "guide")
        .with_title("The language")
        .with_description("How scenes are written: the tutorial, then statements, expressions and predicates")
        .with_mime_type("text/markdown");
    let programs = programs().into_iter().take(LISTED).flat_map(|path| {
        let name = called(&path);
        let program = Resource::new(uri(PROGRAM, &path), name.clone())
            .with_description("A program")
            .with_mime_type("text/x-scenelang");
        let report = Resource::new(uri(REPORT, &path), format!("report of {name}"))
            .with_description("What holds and what fails, in full")
            .with_mime_type("application/json");
        [program, report]
    });
    std::iter::once(guide).chain(programs).collect()
}

/// The same with a place for the path.
pub fn templates() -> Vec<ResourceTemplate> {
    vec![
        ResourceTemplate::new(format!("{PROGRAM}{{+path}}"), "program")
            .with_description("A program or a layout of the workspace, by its path")
            .with_mime_type("text/plain"),
        ResourceTemplate::new(format!("{REPORT}{{+path}}"), "report")
            .with_description(
                "The report of a program and the layout beside it, as `scenelang schema report` describes it",
            )
            .with_mime_type("application/json"),
    ]
}

/// What an address stands for.
///
/// # Errors
/// There is no such thing, or it may not be read.
pub fn read(call: &Call<'_>, address: &str) -> Result<ResourceContents, String> {
    let (text, kind) = if address == GUIDE {
        (guide(), "text/markdown")
    } else if let Some(path) = address.strip_prefix(PROGRAM) {
        let path = call.workspace.scene_file(&decoded(path))?;
        (call.workspace.files(&path).text(&path)?, "text/plain")
    } else if let Some(path) = address.strip_prefix(REPORT) {
        let path = call.workspace.scene_file(&decoded(path))?;
        let files = call.workspace.files(&path);
        files.text(&path)?;
        (report::json(&call.workspace.judge(&path, &files).report), "application/json")
    } else {
        return Err(format!("there is no `{address}`; the resources are {GUIDE}, {PROGRAM}PATH and {REPORT}PATH"));
    };
    Ok(ResourceContents::text(text, address).with_mime_type(kind))
}

/// Programs of the workspace on disk.
fn programs() -> Vec<PathBuf> {
    let found = targets::find(&[PathBuf::from(".")]).into_iter();
    found
        .filter_map(|target| if let JudgeTarget::File(path) = target { Some(path) } else { None })
        .filter(|p| is_program(p))
        .collect()
}

/// The chapters, without layouts, drawings and links.
fn guide() -> String {
    let mut out = String::new();
    for chapter in CHAPTERS {
        let mut in_layout = false;
        for line in chapter.lines() {
            let starts = line.starts_with("```json layout");
            in_layout |= starts;
            let is_left_out = line.starts_with("![") || line.is_empty() && out.ends_with("\n\n");
            if !in_layout && !is_left_out {
                out.push_str(line);
                out.push('\n');
            }
            in_layout &= starts || line != "```";
        }
        out.push('\n');
    }
    out
}

/// An address of a path: what could be taken for something else is written as its bytes.
fn uri(kind: &str, path: &Path) -> String {
    let mut out = kind.to_owned();
    for byte in called(path).bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => out.push(char::from(byte)),
            other => out += &format!("%{other:02X}"),
        }
    }
    out
}

/// The path of an address. What is no byte stands for itself.
fn decoded(text: &str) -> String {
    let bytes = text.as_bytes();
    let mut out = Vec::with_capacity(bytes.len());
    let mut i = 0;
    while i < bytes.len() {
        let digits = text.get(i + 1..i + 3).filter(|_| bytes[i] == b'%');
        match digits.and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                out.push(byte);
                i += 3;
            }
            None => {
                out.push(bytes[i]);
                i += 1;
            }
        }
    }
    String::from_utf8_lossy(&out).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_say_which_path_is_meant() {
        for path in ["room.scene", "rooms/large one.scene", "größe%20.scene", "a?b#c.scene"] {
            let address = uri(PROGRAM, Path::new(path));
            assert_eq!(decoded(address.strip_prefix(PROGRAM).unwrap_or_default()), path);
            assert!(address.is_ascii() && !address.contains(' '));
        }
        assert_eq!(decoded("100%.scene"), "100%.scene");
        assert_eq!(decoded("%é"), "%é");
    }

    #[test]
    fn the_guide_is_text_alone() {
        let guide = guide();
        assert!(guide.contains("```scene") && !guide.contains("json layout") && !guide.contains("!["));
    }
}
