//! Unity's files as a list of documents with their own fields: as much of YAML as Unity writes, and tools that rewrite its
//! files. What is nested deeper than a field's own line is passed over, except in instances of prefabs.

use std::collections::BTreeMap;

/// A document: `--- !u!CLASS &ANCHOR`, then fields.
#[derive(Clone, Debug, Default)]
pub(super) struct UnityDocument {
    /// Unity's number of its class.
    pub class: u32,
    /// What others refer to it by.
    pub anchor: i64,
    /// Whether it only stands for an object of a prefab's instance.
    pub is_stripped: bool,
    /// Of an instance of a prefab: its lines, for [`entries`].
    pub lines: Vec<String>,
    fields: BTreeMap<String, String>,
}

const PREFAB_INSTANCE: u32 = 1001;

impl UnityDocument {
    /// One without fields.
    pub fn new(class: u32, anchor: i64) -> Self {
        Self { class, anchor, ..Self::default() }
    }

    /// A field's text, without quotation marks.
    pub fn text(&self, key: &str) -> Option<String> {
        self.fields.get(key).map(|value| unquoted(value))
    }

    /// The document that a field refers to; `None`: to none.
    pub fn reference(&self, key: &str) -> Option<i64> {
        member(self.fields.get(key)?, "fileID")?.parse().ok().filter(|id| *id != 0)
    }

    /// A field that is a vector: the members that are named.
    pub fn numbers<const N: usize>(&self, key: &str, members: [&str; N]) -> Option<[f64; N]> {
        let value = self.fields.get(key)?;
        let mut out = [0.0; N];
        for (slot, name) in out.iter_mut().zip(members) {
            *slot = member(value, name)?.parse().ok()?;
        }
        Some(out)
    }

    /// The object that it tells of, as the script that carries what the program says of one. That of a prefab tells of none.
    pub fn told_id(&self) -> Option<String> {
        self.fields.get("declaration")?;
        self.text("id").filter(|id| !id.is_empty())
    }

    /// Changes a field, or a member of one: `m_LocalPosition.x`.
    pub fn set(&mut self, path: &str, value: &str) {
        let Some((key, name)) = path.rsplit_once('.') else {
            self.fields.insert(path.to_owned(), value.to_owned());
            return;
        };
        let usual = match key {
            "m_LocalPosition" => "{x: 0, y: 0, z: 0}",
            "m_LocalRotation" => "{x: 0, y: 0, z: 0, w: 1}",
            "m_LocalScale" => "{x: 1, y: 1, z: 1}",
            // Nothing else that has members is read.
            _ => return,
        };
        let before = self.fields.get(key).map_or(usual, String::as_str);
        let now = ["x", "y", "z", "w"].into_iter().filter_map(|each| {
            let number = member(before, each)?;
            Some(format!("{each}: {}", if each == name { value } else { number }))
        });
        let now = format!("{{{}}}", now.collect::<Vec<_>>().join(", "));
        self.fields.insert(key.to_owned(), now);
    }

    /// Gives what it belongs to and what it is below other anchors.
    pub fn refer(&mut self, to: impl Fn(i64) -> i64) {
        for key in ["m_GameObject", "m_Father"] {
            if let Some(id) = self.reference(key) {
                self.fields.insert(key.to_owned(), format!("{{fileID: {}}}", to(id)));
            }
        }
    }
}

pub(super) fn documents(text: &str) -> Vec<UnityDocument> {
    let mut found: Vec<UnityDocument> = Vec::new();
    let mut key: Option<String> = None;
    for line in text.lines() {
        if let Some(header) = line.strip_prefix("--- !u!") {
            let mut words = header.split_whitespace();
            let class = words.next().and_then(|w| w.parse().ok()).unwrap_or_default();
            let anchor = words.next().and_then(|w| w.strip_prefix('&')?.parse().ok()).unwrap_or_default();
            let is_stripped = words.next() == Some("stripped");
            found.push(UnityDocument { is_stripped, ..UnityDocument::new(class, anchor) });
            key = None;
            continue;
        }
        let Some(document) = found.last_mut() else { continue };
        if document.class == PREFAB_INSTANCE {
            document.lines.push(line.to_owned());
            continue;
        }
        let indent = line.len() - line.trim_start_matches(' ').len();
        match indent {
            2 if !line[2..].starts_with('-') => {
                key = line[2..].split_once(':').map(|(name, value)| {
                    document.fields.insert(name.to_owned(), value.trim().to_owned());
                    name.to_owned()
                });
            }
            0 => key = None,
            // A long text goes on in the next line.
            _ => {
                let open = key.as_ref().and_then(|key| document.fields.get_mut(key)).filter(|value| is_open(value));
                if let Some(value) = open {
                    value.push(' ');
                    value.push_str(line.trim());
                }
            }
        }
    }
    found
}

/// The lines of a document however deep they are: whether an entry of a list begins there, the key, and the value. An entry
/// without a key has an empty one.
pub(super) fn entries(lines: &[String]) -> Vec<(bool, String, String)> {
    let mut found: Vec<(bool, String, String)> = Vec::new();
    for line in lines.iter().map(|line| line.trim()) {
        if let Some((_, _, value)) = found.last_mut().filter(|(_, _, value)| is_open(value)) {
            *value += " ";
            *value += line;
            continue;
        }
        let entry = line.strip_prefix("- ");
        let rest = entry.unwrap_or(line);
        let (key, value) = if rest.starts_with('{') { ("", rest) } else { rest.split_once(':').unwrap_or((rest, "")) };
        found.push((entry.is_some(), key.to_owned(), value.trim().to_owned()));
    }
    found
}

/// Whether a value does not end where its line does.
fn is_open(value: &str) -> bool {
    match value.chars().next() {
        Some('"') => value.len() == 1 || !value.ends_with('"') || value.ends_with("\\\""),
        Some('\'') => value.len() == 1 || !value.ends_with('\''),
        Some('{') => !value.ends_with('}'),
        _ => false,
    }
}

/// A member of `{a: 1, b: 2}`.
pub(super) fn member<'v>(value: &'v str, name: &str) -> Option<&'v str> {
    let inner = value.strip_prefix('{')?.strip_suffix('}')?;
    inner.split(',').find_map(|part| {
        let (key, value) = part.split_once(':')?;
        (key.trim() == name).then(|| value.trim())
    })
}

fn unquoted(value: &str) -> String {
    if let Some(inner) = value.strip_prefix('\'').and_then(|v| v.strip_suffix('\'')) {
        return inner.replace("\'\'", "\'");
    }
    if value.starts_with('"') {
        // Unity escapes as JSON does, but for \x41, which it does not write of names.
        return serde_json::from_str(value).unwrap_or_else(|_| value.trim_matches('"').to_owned());
    }
    value.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_are_read_as_unity_writes_them() {
        let text = "%YAML 1.1\n--- !u!4 &12\nTransform:\n  m_Father: {fileID: 7}\n  m_LocalPosition: {x: 1, y: -0.5,\n    z: 2e-3}\n  \
                    m_Children:\n  - {fileID: 9}\n  m_Name: 'it''s'\n--- !u!114 &-3\nMonoBehaviour:\n  id: \"chair[0]\"\n  \
                    declaration: \"a long\n    text\"\n  m_Script: {fileID: 0}\n";
        let found = documents(text);
        assert_eq!((found[0].class, found[0].anchor, found[1].anchor), (4, 12, -3));
        assert_eq!(found[0].reference("m_Father"), Some(7));
        assert_eq!(found[0].numbers("m_LocalPosition", ["x", "y", "z"]), Some([1.0, -0.5, 2e-3]));
        assert_eq!(found[0].text("m_Name").as_deref(), Some("it's"));
        assert_eq!(found[1].text("id").as_deref(), Some("chair[0]"));
        assert_eq!(found[1].text("declaration").as_deref(), Some("a long text"));
        assert_eq!(found[1].reference("m_Script"), None);
    }

    #[test]
    fn a_field_is_changed_by_its_path() {
        let mut document =
            documents("--- !u!4 &1 stripped\nTransform:\n  m_LocalPosition: {x: 1, y: 2, z: 3}\n").remove(0);
        assert!(document.is_stripped);
        for (path, value) in [
            ("m_LocalPosition.y", "-0.5"),
            ("m_LocalScale.z", "2"),
            ("m_LocalPosition.q", "9"),
            ("lines.Array.data[0]", "x"),
            ("m_Name", "\"gr\\xF6n\""),
        ] {
            document.set(path, value);
        }
        assert_eq!(document.numbers("m_LocalPosition", ["x", "y", "z"]), Some([1.0, -0.5, 3.0]));
        assert_eq!(document.numbers("m_LocalScale", ["x", "y", "z"]), Some([1.0, 1.0, 2.0]));
        assert_eq!(document.numbers("m_LocalRotation", ["x", "y", "z", "w"]), None);
        assert_eq!(document.reference("m_Father"), None);
    }

    #[test]
    fn entries_are_read_at_any_depth() {
        let text = "  m_Modification:\n    m_Modifications:\n    - target: {fileID: 3, guid: ab,\n        type: 3}\n      \
                    propertyPath: m_Name\n      value: \"a: b\n        c\"\n    m_RemovedComponents:\n    - {fileID: 7, guid: ab,\n      \
                    type: 3}\n";
        let lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let found = entries(&lines);
        let found: Vec<(bool, &str, &str)> = found.iter().map(|(b, k, v)| (*b, k.as_str(), v.as_str())).collect();
        assert_eq!(
            found,
            [
                (false, "m_Modification", ""),
                (false, "m_Modifications", ""),
                (true, "target", "{fileID: 3, guid: ab, type: 3}"),
                (false, "propertyPath", "m_Name"),
                (false, "value", "\"a: b c\""),
                (false, "m_RemovedComponents", ""),
                (true, "", "{fileID: 7, guid: ab, type: 3}"),
            ]
        );
    }
}
