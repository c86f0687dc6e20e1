//! Strict JSON, read into a tree in which every key and value knows its place.
//!
//! A slip (a comma too many or too few, a comment, `NaN`, single quotes) is one error and does not keep the rest from
//! being read; the value that is spoilt by it becomes [`Json::Invalid`]. What leaves no way on ends the reading.

use scenelang_base::{Applicability, Code, Diagnostic, FileId, TextRange, codes};
use std::collections::HashMap;

/// How deep brackets may nest: far more than any layout needs, and safe on a small stack.
pub const MAX_DEPTH: usize = 200;

/// How many findings are kept: whoever has more starts with these.
const MAX_FINDINGS: usize = 100;

/// A value with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct JsonNode {
    pub value: Json,
    /// Where it stands.
    pub range: TextRange,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Json {
    /// `null`
    Null,
    /// `true` or `false`
    Bool(bool),
    /// A finite number.
    Number(f64),
    /// A string, escapes resolved.
    Text(String),
    /// Items in order.
    Array(Vec<JsonNode>),
    /// Members in order, each key once.
    Object(Vec<Member>),
    /// Something was here that an error has been reported for.
    Invalid,
}

/// A member of an object.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// The key, escapes resolved.
    pub key: String,
    /// The key with its quotation marks.
    pub key_range: TextRange,
    /// The value.
    pub node: JsonNode,
}

impl JsonNode {
    /// The members, if it is an object.
    pub fn members(&self) -> Option<&[Member]> {
        match &self.value {
            Json::Object(members) => Some(members),
            _ => None,
        }
    }
    /// The items, if it is an array.
    pub fn items(&self) -> Option<&[JsonNode]> {
        match &self.value {
            Json::Array(items) => Some(items),
            _ => None,
        }
    }
    /// Whether an error in it has been reported already.
    pub fn is_spoilt(&self) -> bool {
        match &self.value {
            Json::Invalid => true,
            Json::Array(items) => items.iter().any(Self::is_spoilt),
            Json::Object(members) => members.iter().any(|m| m.node.is_spoilt()),
            _ => false,
        }
    }
    /// What it is, in words.
    pub fn kind(&self) -> &'static str {
        match &self.value {
            Json::Null => "null",
            Json::Bool(_) => "a truth value",
            Json::Number(_) => "a number",
            Json::Text(_) => "a string",
            Json::Array(_) => "an array",
            Json::Object(_) => "an object",
            Json::Invalid => "nothing that JSON knows",
        }
    }
}

pub fn find<'a>(members: &'a [Member], key: &str) -> Option<&'a Member> {
    members.iter().find(|m| m.key == key)
}

#[derive(Debug)]
pub struct Findings {
    file: FileId,
    /// As they were found, the first hundred of them.
    pub list: Vec<Diagnostic>,
}

impl Findings {
    /// None yet.
    pub fn new(file: FileId) -> Self {
        Self { file, list: Vec::new() }
    }
    /// Adds a finding, which may then be told more about.
    pub fn add(&mut self, code: Code, at: TextRange, message: impl Into<String>) {
        self.push(Diagnostic::new(code, at, message));
    }
    /// Adds a finding that says more.
    pub fn push(&mut self, finding: Diagnostic<TextRange>) {
        if self.list.len() < MAX_FINDINGS {
            self.list.push(finding.map_places(|range| range.in_file(self.file)));
        }
    }
}

/// Reads a text; `None` where nothing of use came of it.
pub fn parse(text: &str, findings: &mut Findings) -> Option<JsonNode> {
    let start = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let mut parser = Parser { text, at: start, depth: 0, findings };
    parser.blanks();
    if parser.at == text.len() {
        findings.add(codes::E0501, TextRange::new(start, start), "the file is empty");
        return None;
    }
    let root = parser.value().ok()?;
    parser.blanks();
    if parser.at < text.len() {
        let at = parser.here();
        parser.error(at, "unexpected text after the end of the document");
    }
    Some(root)
}

/// There is no way on; the error has been reported.
struct Stop;

struct Parser<'a, 'f> {
    text: &'a str,
    at: usize,
    depth: usize,
    findings: &'f mut Findings,
}

impl Parser<'_, '_> {
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }
    /// The range of the next character, empty at the end.
    fn here(&self) -> TextRange {
        TextRange::new(self.at, self.at + self.rest().chars().next().map_or(0, char::len_utf8))
    }
    fn error(&mut self, at: TextRange, message: impl Into<String>) {
        self.findings.add(codes::E0501, at, message);
    }
    fn fixable(&mut self, at: TextRange, message: &str, title: &str, place: TextRange, text: impl Into<String>) {
        let finding = Diagnostic::new(codes::E0501, at, message).fix(Applicability::Safe, title, place, text);
        self.findings.push(finding);
    }

    /// Skips blanks, and comments with an error.
    fn blanks(&mut self) {
        loop {
            self.at += self.rest().bytes().take_while(|b| matches!(b, b' ' | b'\t' | b'\n' | b'\r')).count();
            let rest = self.rest();
            let length = if rest.starts_with("//") {
                rest.find(['\n', '\r']).unwrap_or(rest.len())
            } else if rest.starts_with("/*") {
                rest.find("*/").map_or(rest.len(), |i| i + 2)
            } else {
                return;
            };
            let comment = TextRange::new(self.at, self.at + length);
            self.fixable(comment, "JSON has no comments", "remove the comment", comment, "");
            self.at += length;
        }
    }

    fn value(&mut self) -> Result<JsonNode, Stop> {
        let start = self.at;
        let value = match self.peek() {
            Some(b'{') => self.nested(Self::object)?,
            Some(b'[') => self.nested(Self::array)?,
            Some(b'"' | b'\'') => Json::Text(self.string()?),
            Some(b'+' | b'-' | b'.' | b'0'..=b'9') => self.number(),
            Some(c) if c.is_ascii_alphabetic() || c == b'_' => self.word(),
            Some(_) => {
                let (at, c) = (self.here(), self.rest().chars().next().unwrap_or_default());
                self.error(at, format!("expected a value, not {c:?}"));
                return Err(Stop);
            }
            None => {
                let at = self.here();
                self.error(at, "expected a value, but the file ends here");
                return Err(Stop);
            }
        };
        Ok(JsonNode { value, range: TextRange::new(start, self.at) })
    }

    fn nested(&mut self, read: fn(&mut Self) -> Result<Json, Stop>) -> Result<Json, Stop> {
        if self.depth == MAX_DEPTH {
            let at = self.here();
            self.findings.add(codes::E0004, at, format!("brackets are nested more than {MAX_DEPTH} levels deep here"));
            return Err(Stop);
        }
        self.depth += 1;
        let value = read(self);
        self.depth -= 1;
        value
    }

    fn array(&mut self) -> Result<Json, Stop> {
        let mut items = Vec::new();
        let open = self.here();
        self.list(b']', |p| {
            let item = p.value()?;
            p.blanks();
            if p.peek() == Some(b':') {
                let say = "an array cannot contain keys";
                let finding = Diagnostic::new(codes::E0501, item.range, say);
                p.findings.push(finding.related(open, "the `]` that closes this array may be missing"));
                return Err(Stop);
            }
            items.push(item);
            Ok(())
        })?;
        Ok(Json::Array(items))
    }

    fn object(&mut self) -> Result<Json, Stop> {
        let mut members: Vec<Member> = Vec::new();
        let mut seen: HashMap<String, TextRange> = HashMap::new();
        self.list(b'}', |p| {
            let member = p.member()?;
            match seen.get(&member.key) {
                Some(first) => p.findings.push(
                    Diagnostic::new(codes::E0509, member.key_range, format!("{:?} is given twice", member.key))
                        .related(*first, "first here"),
                ),
                None => {
                    seen.insert(member.key.clone(), member.key_range);
                    members.push(member);
                }
            }
            Ok(())
        })?;
        Ok(Json::Object(members))
    }

    /// What stands between a bracket and its partner `close`, with commas between.
    fn list(&mut self, close: u8, mut item: impl FnMut(&mut Self) -> Result<(), Stop>) -> Result<(), Stop> {
        let open = self.here();
        self.at += 1;
        // The end of the item before, and the comma after it, if they have been seen.
        let (mut end, mut comma): (Option<usize>, Option<TextRange>) = (None, None);
        loop {
            self.blanks();
            let here = self.here();
            match self.peek() {
                Some(b',') => {
                    if comma.is_some() || end.is_none() {
                        self.fixable(here, "there is an extra comma", "remove the comma", here, "");
                    }
                    comma = Some(here);
                    self.at += 1;
                }
                Some(c) if c == close => {
                    if let (Some(comma), Some(_)) = (comma, end) {
                        self.fixable(comma, "a trailing comma is not allowed in JSON", "remove the comma", comma, "");
                    }
                    self.at += 1;
                    return Ok(());
                }
                None | Some(b']' | b'}') => {
                    let opened = char::from(self.text.as_bytes()[open.bytes()][0]);
                    let what =
                        if self.peek().is_none() { "the file ends without closing" } else { "this does not close" };
                    let finding = Diagnostic::new(codes::E0501, here, format!("{what} the `{opened}` opened earlier"));
                    self.findings.push(finding.related(open, "opened here"));
                    return Err(Stop);
                }
                Some(_) => {
                    if let (Some(end), None) = (end, comma) {
                        let gap = TextRange::new(end, end);
                        self.fixable(here, "a comma is missing before this", "insert a comma", gap, ",");
                    }
                    item(self)?;
                    (end, comma) = (Some(self.at), None);
                }
            }
        }
    }

    fn member(&mut self) -> Result<Member, Stop> {
        let start = self.at;
        let word = self.rest().bytes().take_while(|b| b.is_ascii_alphanumeric() || *b == b'_').count();
        let key = if matches!(self.peek(), Some(b'"' | b'\'')) {
            self.string()?
        } else if word > 0 {
            let range = TextRange::new(start, start + word);
            let key = self.text[range.bytes()].to_owned();
            self.at += word;
            self.fixable(range, "keys are written in double quotes", "add the quotes", range, format!("\"{key}\""));
            key
        } else {
            let at = self.here();
            self.error(at, "a key in double quotes was expected here");
            return Err(Stop);
        };
        let key_range = TextRange::new(start, self.at);
        self.blanks();
        if self.peek() == Some(b':') {
            self.at += 1;
            self.blanks();
        } else {
            let at = self.here();
            self.error(at, format!("a colon was expected after the key {key:?}"));
            if self.peek().is_none() {
                return Err(Stop);
            }
        }
        let node = if matches!(self.peek(), Some(b',' | b'}' | b']')) {
            let at = self.here();
            self.error(at, format!("the value of {key:?} is missing"));
            JsonNode { value: Json::Invalid, range: TextRange::empty(at.start) }
        } else {
            self.value()?
        };
        Ok(Member { key, key_range, node })
    }

    /// `true`, `false`, `null`, or an error.
    fn word(&mut self) -> Json {
        let length = self.rest().bytes().take_while(|b| b.is_ascii_alphanumeric() || *b == b'_').count();
        let range = TextRange::new(self.at, self.at + length);
        self.at += length;
        let word = &self.text[range.bytes()];
        match word {
            "true" => return Json::Bool(true),
            "false" => return Json::Bool(false),
            "null" => return Json::Null,
            _ => {}
        }
        let say = match word.to_ascii_lowercase().as_str() {
            "nan" | "infinity" | "inf" => format!("JSON has no number `{word}`"),
            lower @ ("true" | "false" | "null") => format!("in JSON, `{lower}` must be in lower case"),
            _ => format!("`{word}` means nothing in JSON; strings are written in double quotes"),
        };
        self.error(range, say);
        Json::Invalid
    }

    fn number(&mut self) -> Json {
        let length =
            self.rest().bytes().take_while(|b| b.is_ascii_alphanumeric() || matches!(b, b'+' | b'-' | b'.' | b'_'));
        let range = TextRange::new(self.at, self.at + length.count());
        self.at = range.end as usize;
        let written = &self.text[range.bytes()];
        let shown = if written.len() > 40 { "this" } else { written };
        if !is_number(written) {
            self.error(range, format!("in JSON a number cannot be written as {shown}"));
            return Json::Invalid;
        }
        match written.parse::<f64>() {
            Ok(number) if number.is_finite() => Json::Number(number),
            _ => {
                self.findings.add(codes::E0505, range, format!("the number {shown} is too large"));
                Json::Invalid
            }
        }
    }

    /// A string; one in single quotes is an error, and read all the same.
    fn string(&mut self) -> Result<String, Stop> {
        let start = self.at;
        let quote = self.text.as_bytes()[start];
        self.at += 1;
        let mut out = String::new();
        loop {
            let plain = self.rest().bytes().take_while(|&b| b != quote && b != b'\\' && b >= 0x20).count();
            out.push_str(&self.text[self.at..self.at + plain]);
            self.at += plain;
            match self.peek() {
                Some(c) if c == quote => break,
                Some(b'\\') => self.escape(&mut out),
                None | Some(b'\n' | b'\r') => {
                    self.error(TextRange::new(start, self.at), "the string is not closed on its line");
                    return Err(Stop);
                }
                Some(c) => {
                    let at = self.here();
                    self.error(at, format!("a control character in a string is written \\u{c:04x}"));
                    self.at += 1;
                }
            }
        }
        self.at += 1;
        if quote == b'\'' {
            let range = TextRange::new(start, self.at);
            let quoted = serde_json::Value::from(out.as_str()).to_string();
            self.fixable(range, "strings are written in double quotes", "use double quotes", range, quoted);
        }
        Ok(out)
    }

    /// One escape, at its backslash; a wrong one is an error and left out.
    fn escape(&mut self, out: &mut String) {
        let start = self.at;
        self.at += 1;
        let c = self.rest().chars().next().filter(|c| !c.is_control());
        self.at += c.map_or(0, char::len_utf8);
        let simple = match c {
            Some('u') => self.unicode(),
            Some(c @ ('"' | '\\' | '/')) => Some(c),
            Some('b') => Some('\u{8}'),
            Some('f') => Some('\u{c}'),
            Some('n') => Some('\n'),
            Some('r') => Some('\r'),
            Some('t') => Some('\t'),
            _ => None,
        };
        match simple {
            Some(c) => out.push(c),
            None => {
                let range = TextRange::new(start, self.at);
                self.error(range, format!("JSON has no escape {}", &self.text[range.bytes()]));
            }
        }
    }

    /// What follows `\u`: four hexadecimal digits, or two such escapes that make a pair.
    fn unicode(&mut self) -> Option<char> {
        let first = self.four_digits()?;
        if !(0xd800..0xdc00).contains(&first) {
            return char::from_u32(first);
        }
        if !self.rest().starts_with("\\u") {
            return None;
        }
        let back = self.at;
        self.at += 2;
        let second = self.four_digits().filter(|s| (0xdc00..0xe000).contains(s));
        if second.is_none() {
            self.at = back;
        }
        char::from_u32(0x10000 + ((first - 0xd800) << 10) + (second? - 0xdc00))
    }

    fn four_digits(&mut self) -> Option<u32> {
        let digits = self.rest().get(..4).filter(|d| d.bytes().all(|b| b.is_ascii_hexdigit()))?;
        let code = u32::from_str_radix(digits, 16).ok()?;
        self.at += 4;
        Some(code)
    }
}

/// Whether JSON would write a number so.
fn is_number(written: &str) -> bool {
    let digits = |s: &str| !s.is_empty() && s.bytes().all(|b| b.is_ascii_digit());
    let unsigned = written.strip_prefix('-').unwrap_or(written);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).map_or((unsigned, None), |(m, e)| (m, Some(e)));
    let (whole, fraction) = mantissa.split_once('.').map_or((mantissa, None), |(w, f)| (w, Some(f)));
    digits(whole)
        && (whole.len() == 1 || !whole.starts_with('0'))
        && fraction.is_none_or(digits)
        && exponent.is_none_or(|e| digits(e.strip_prefix(['+', '-']).unwrap_or(e)))
}
