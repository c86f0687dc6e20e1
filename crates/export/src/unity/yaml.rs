//! Unity's flavour of YAML: documents with class and anchor, two blanks per level, lists not indented, flow mappings
//! for references and vectors, lines broken after column 80 as Unity breaks them.

use std::fmt::Write;

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Yaml {
    /// A scalar that needs no quotes: a number, a word.
    Word(String),
    /// Any text.
    Text(String),
    /// `{x: 0, y: 1}` in one line.
    Flow(Vec<(&'static str, String)>),
    /// A mapping, a line for each entry.
    Map(Map),
    List(Vec<Yaml>),
}

/// Entries of a mapping, in order.
pub(super) type Map = Vec<(String, Yaml)>;

/// A mapping from keys and values that become [`Yaml`].
macro_rules! map {
    ($($key:expr => $value:expr),* $(,)?) => {
        vec![$(($key.to_string(), $crate::unity::yaml::Yaml::from($value))),*]
    };
}
pub(super) use map;

impl From<i64> for Yaml {
    fn from(v: i64) -> Self {
        Self::Word(v.to_string())
    }
}
impl From<i32> for Yaml {
    fn from(v: i32) -> Self {
        Self::Word(v.to_string())
    }
}
impl From<f32> for Yaml {
    fn from(v: f32) -> Self {
        Self::Word(number(v))
    }
}
impl From<&str> for Yaml {
    fn from(v: &str) -> Self {
        Self::Text(v.to_owned())
    }
}
impl From<Map> for Yaml {
    fn from(v: Map) -> Self {
        Self::Map(v)
    }
}
impl From<Vec<Self>> for Yaml {
    fn from(v: Vec<Self>) -> Self {
        Self::List(v)
    }
}

/// A float as Unity prints it: the shortest text that reads back the same, and `0` for both zeros.
pub(super) fn number(v: f32) -> String {
    // Adding 0 turns -0 into 0.
    (v + 0.0).to_string()
}

/// `{fileID: 0}`: nothing.
pub(super) fn none() -> Yaml {
    local(0)
}

/// A reference to something in the same file.
pub(super) fn local(anchor: i64) -> Yaml {
    Yaml::Flow(vec![("fileID", anchor.to_string())])
}

/// A reference to something in another asset; `kind` 0 built in, 2 written as text, 3 imported.
pub(super) fn asset(id: i64, guid: &str, kind: u8) -> Yaml {
    Yaml::Flow(vec![("fileID", id.to_string()), ("guid", guid.to_owned()), ("type", kind.to_string())])
}

/// `{x: …, y: …}`
pub(super) fn pair(v: [f32; 2]) -> Yaml {
    Yaml::Flow(["x", "y"].into_iter().zip(v.map(number)).collect())
}

/// `{x: …, y: …, z: …}`
pub(super) fn vector(v: [f32; 3]) -> Yaml {
    Yaml::Flow(["x", "y", "z"].into_iter().zip(v.map(number)).collect())
}

/// `{x: …, y: …, z: …, w: …}`
pub(super) fn quaternion(v: [f32; 4]) -> Yaml {
    Yaml::Flow(["x", "y", "z", "w"].into_iter().zip(v.map(number)).collect())
}

/// `{r: …, g: …, b: …, a: …}`
pub(super) fn color([r, g, b]: [f32; 3], a: f32) -> Yaml {
    Yaml::Flow(["r", "g", "b", "a"].into_iter().zip([r, g, b, a].map(number)).collect())
}

/// Documents of one file.
pub(super) struct Stream {
    out: String,
}

impl Stream {
    /// The two header lines.
    pub fn new() -> Self {
        Self { out: "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n".into() }
    }

    /// Adds a document: an object of a class (`GameObject`, 1) that others refer to by its anchor.
    pub fn document(&mut self, class: u32, anchor: i64, kind: &str, fields: &Map) {
        let _ = writeln!(self.out, "--- !u!{class} &{anchor}\n{kind}:");
        write_map(&mut self.out, fields, 2);
    }

    /// Adds what stands for an object of a prefab's instance.
    pub fn stripped(&mut self, class: u32, anchor: i64, kind: &str, fields: &Map) {
        let _ = writeln!(self.out, "--- !u!{class} &{anchor} stripped\n{kind}:");
        write_map(&mut self.out, fields, 2);
    }

    /// Adds a document's fields without a header: the whole content of a `.meta` file.
    pub fn meta(fields: &Map) -> Vec<u8> {
        let mut out = String::new();
        write_map(&mut out, fields, 0);
        out.into_bytes()
    }

    pub fn into_bytes(self) -> Vec<u8> {
        self.out.into_bytes()
    }
}

/// Lines are broken at the first opportunity after this column.
const WIDTH: usize = 80;

fn write_map(out: &mut String, fields: &Map, indent: usize) {
    for (i, (key, value)) in fields.iter().enumerate() {
        // The first entry of a list's item stands on the line of its dash.
        if i > 0 || !out.ends_with("- ") {
            out.extend(std::iter::repeat_n(' ', indent));
        }
        out.push_str(key);
        out.push(':');
        write_value(out, value, indent);
    }
}

/// A value after `key:` or `-`, and the end of its line.
fn write_value(out: &mut String, value: &Yaml, indent: usize) {
    match value {
        Yaml::Map(fields) if !fields.is_empty() => {
            out.push('\n');
            write_map(out, fields, indent + 2);
            return;
        }
        Yaml::List(items) if !items.is_empty() => {
            out.push('\n');
            for item in items {
                out.extend(std::iter::repeat_n(' ', indent));
                out.push('-');
                match item {
                    Yaml::Map(fields) if !fields.is_empty() => {
                        out.push(' ');
                        write_map(out, fields, indent + 2);
                    }
                    other => write_value(out, other, indent),
                }
            }
            return;
        }
        Yaml::Map(_) => out.push_str(" {}"),
        Yaml::List(_) => out.push_str(" []"),
        Yaml::Word(word) => {
            out.push(' ');
            out.push_str(word);
        }
        Yaml::Text(text) => write_text(out, text, indent + 2),
        Yaml::Flow(fields) => write_flow(out, fields, indent + 2),
    }
    out.push('\n');
}

fn column(out: &str) -> usize {
    out.chars().rev().take_while(|&c| c != '\n').count()
}

fn break_line(out: &mut String, indent: usize) {
    out.push('\n');
    out.extend(std::iter::repeat_n(' ', indent));
}

fn write_flow(out: &mut String, fields: &[(&str, String)], indent: usize) {
    out.push_str(" {");
    for (i, (key, value)) in fields.iter().enumerate() {
        if i > 0 {
            out.push(',');
        }
        if column(out) > WIDTH {
            break_line(out, indent);
        } else if i > 0 {
            out.push(' ');
        }
        let _ = write!(out, "{key}: {value}");
    }
    out.push('}');
}

/// A text: plain where that is safe in any reader, else in double quotes, folded at blanks.
fn write_text(out: &mut String, text: &str, indent: usize) {
    out.push(' ');
    let plain = |c: char| c.is_ascii_alphanumeric() || "_-./ ".contains(c);
    let starts_well = text.chars().next().is_none_or(|c| c.is_ascii_alphabetic());
    if text.len() <= 40 && starts_well && !text.ends_with(' ') && text.chars().all(plain) {
        out.push_str(text);
        return;
    }
    out.push('"');
    let last = text.chars().count().saturating_sub(1);
    for (i, c) in text.chars().enumerate() {
        match c {
            ' ' if i > 0 && i < last && column(out) > WIDTH => break_line(out, indent),
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            '\r' => out.push_str("\\r"),
            ' '..='~' => out.push(c),
            c if (c as u32) < 0x100 => drop(write!(out, "\\x{:02X}", c as u32)),
            c if (c as u32) < 0x10000 => drop(write!(out, "\\u{:04X}", c as u32)),
            c => drop(write!(out, "\\U{:08X}", c as u32)),
        }
    }
    out.push('"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_layout_is_unitys() {
        let long = asset(-2432090755550338912, "0123456789abcdef0123456789abcdef", 3);
        let fields = map! {
            "m_Component" => vec![Yaml::from(map! { "component" => local(4) })],
            "m_Children" => Vec::<Yaml>::new(),
            "m_Mesh_with_a_long_name" => long,
            "m_Position" => vector([1.0, -0.0, 0.1]),
            "m_Name" => "",
            "nested" => map! { "a" => 1, "list" => vec![local(7)] },
            "text" => "chair[0]: \"ä\"",
        };
        let mut stream = Stream::new();
        stream.document(1, 42, "GameObject", &fields);
        let text = String::from_utf8(stream.into_bytes()).unwrap();
        assert_eq!(
            text,
            "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!1 &42\nGameObject:\n\
             \x20 m_Component:\n  - component: {fileID: 4}\n  m_Children: []\n\
             \x20 m_Mesh_with_a_long_name: {fileID: -2432090755550338912, guid: 0123456789abcdef0123456789abcdef,\n\
             \x20   type: 3}\n  m_Position: {x: 1, y: 0, z: 0.1}\n  m_Name: \n\
             \x20 nested:\n    a: 1\n    list:\n    - {fileID: 7}\n  text: \"chair[0]: \\\"\\xE4\\\"\"\n"
        );
    }

    #[test]
    fn long_texts_fold_at_blanks_only() {
        let words = "word ".repeat(40);
        let mut stream = Stream::new();
        stream.document(114, 1, "MonoBehaviour", &map! { "t" => words.trim_end() });
        let text = String::from_utf8(stream.into_bytes()).unwrap();
        let folded: String = text.lines().skip(4).map(str::trim).collect::<Vec<_>>().join(" ");
        assert_eq!(folded, format!("t: \"{}\"", words.trim_end()));
        assert!(text.lines().all(|l| l.len() < 90));
    }
}
