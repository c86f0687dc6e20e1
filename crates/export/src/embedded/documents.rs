//! Unity's files as a list of documents with their own fields: as much of YAML as Unity writes, and tools that rewrite its
//! files. What is nested deeper than a field's own line is passed over.

use std::collections::BTreeMap;

/// A document: `--- !u!CLASS &ANCHOR`, then fields.
#[derive(Clone, Debug, Default)]
pub(super) struct Document {
    /// Unity's number of its class.
    pub class: u32,
    /// What others refer to it by.
    pub anchor: i64,
    fields: BTreeMap<String, String>,
}

impl Document {
    /// A field's text, without quotation marks.
    pub fn text(&self, key: &str) -> Option<String> {
        self.fields.get(key).map(|value| unquoted(value))
    }

    /// The document that a field refers to; `None`: to none.
    pub fn reference(&self, key: &str) -> Option<i64> {
        flow(self.fields.get(key)?, "fileID")?.parse().ok().filter(|id| *id != 0)
    }

    /// A field that is a vector: the members that are named.
    pub fn numbers<const N: usize>(&self, key: &str, members: [&str; N]) -> Option<[f64; N]> {
        let value = self.fields.get(key)?;
        let mut out = [0.0; N];
        for (slot, member) in out.iter_mut().zip(members) {
            *slot = flow(value, member)?.parse().ok()?;
        }
        Some(out)
    }
}

/// The documents of a file.
pub(super) fn documents(text: &str) -> Vec<Document> {
    let mut found: Vec<Document> = Vec::new();
    let mut key: Option<String> = None;
    for line in text.lines() {
        if let Some(header) = line.strip_prefix("--- !u!") {
            let mut words = header.split_whitespace();
            let class = words.next().and_then(|w| w.parse().ok()).unwrap_or_default();
            let anchor = words.next().and_then(|w| w.strip_prefix('&')?.parse().ok()).unwrap_or_default();
            found.push(Document { class, anchor, ..Document::default() });
            key = None;
            continue;
        }
        let Some(document) = found.last_mut() else { continue };
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
fn flow<'v>(value: &'v str, member: &str) -> Option<&'v str> {
    let inner = value.strip_prefix('{')?.strip_suffix('}')?;
    inner.split(',').find_map(|part| {
        let (key, value) = part.split_once(':')?;
        (key.trim() == member).then(|| value.trim())
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
}
