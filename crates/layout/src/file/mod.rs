//! The layout file: read with positions, checked as far as that needs no program, and written back.

mod joints;
pub mod json;
mod places;
mod read;
mod write;

pub use json::MAX_DEPTH;
pub use places::{Block, Entry, MemberPlace, Places};
pub use read::{FORMAT, LARGEST};
pub use write::{checked, to_json, write};

use crate::Layout;
use scenelang_base::{Diagnostic, FileId, TextRange, codes};

/// The largest file that is read, in bytes.
pub const MAX_BYTES: usize = 64 << 20;

/// A layout file as read: what it says, where, and what is wrong with it.
#[derive(Clone, Debug)]
pub struct ReadLayout {
    /// What could be read. An object or region with an error in it is left out here, but not in `places`; so is a
    /// variable of a shape that no variable has.
    pub layout: Layout,
    /// Where everything is.
    pub places: Places,
    /// What [`to_json`] keeps of this file.
    pub document: Document,
    /// Errors and warnings, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// False where this is no layout of our format, or breaks off: then nothing else about it is worth saying.
    pub usable: bool,
}

/// A layout file as text, so that rewriting it keeps what it says besides.
#[derive(Clone, Debug)]
pub struct Document {
    text: String,
    root: json::JsonNode,
    /// Starts of the entries that were understood, sorted.
    understood: Vec<u32>,
}

/// The text of a file: UTF-8, with or without a byte order mark (which stays in the text).
///
/// # Errors
/// What is wrong with it, without a place, there being no text.
pub fn decode(bytes: Vec<u8>) -> Result<String, Box<Diagnostic>> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        let say = "the file is UTF-16; save it as UTF-8";
        return Err(Box::new(Diagnostic::without_place(codes::E0003, say)));
    }
    String::from_utf8(bytes).map_err(|e| {
        let good = e.utf8_error().valid_up_to();
        let line = e.as_bytes()[..good].iter().filter(|b| **b == b'\n').count() + 1;
        let byte = e.as_bytes().get(good).copied().unwrap_or_default();
        let say = format!("the file is not valid UTF-8: there is a byte {byte:02x} on line {line}");
        Box::new(Diagnostic::without_place(codes::E0003, say))
    })
}

/// Reads a layout. Never fails: what is wrong is in the diagnostics.
pub fn read(text: &str, file: FileId) -> ReadLayout {
    let mut findings = json::Findings::new(file);
    let root = if text.len() > MAX_BYTES {
        let say = format!("a layout of more than {} MiB cannot be read", MAX_BYTES >> 20);
        findings.add(codes::E0006, TextRange::empty(0), say);
        None
    } else {
        json::parse(text, &mut findings)
    };
    let Some(root) = root else {
        let nothing = json::JsonNode { value: json::Json::Object(Vec::new()), range: TextRange::empty(0) };
        return ReadLayout {
            layout: Layout::default(),
            places: Places::nowhere(file),
            document: Document { text: String::new(), root: nothing, understood: Vec::new() },
            diagnostics: findings.list,
            usable: false,
        };
    };
    let read::DocumentMembers { layout, usable, understood } = read::document(text, &root, &mut findings);
    let mut diagnostics = findings.list;
    diagnostics.sort_by_key(|d| d.primary.as_ref().map(|l| l.place.range.start));
    ReadLayout {
        layout,
        places: Places::of(file, &root),
        document: Document { text: text.to_owned(), root, understood },
        diagnostics,
        usable,
    }
}
