//! Unity's files as a list of documents with their fields. Each document is YAML; the line before it, with Unity's number of
//! the class and what others refer to it by, is not, so it is read here.

use saphyr_parser::{Event, Parser};

/// A document: `--- !u!CLASS &ANCHOR`, then fields.
#[derive(Clone, Debug)]
pub(super) struct UnityDocument {
    /// Unity's number of its class.
    pub class: u32,
    /// What others refer to it by.
    pub anchor: i64,
    /// Whether it only stands for an object of a prefab's instance.
    pub is_stripped: bool,
    fields: Node,
}

/// A value of a document.
#[derive(Clone, Debug)]
pub(super) enum Node {
    Text(String),
    Map(Vec<(String, Self)>),
    List(Vec<Self>),
}

/// Values that are nested deeper are left out: nothing that is read here is.
const DEEPEST: usize = 8;

impl Node {
    /// A member of a map.
    pub fn get(&self, key: &str) -> Option<&Self> {
        let Self::Map(members) = self else { return None };
        members.iter().find(|(name, _)| name == key).map(|(_, value)| value)
    }

    pub fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self { Some(text) } else { None }
    }

    /// The document that it refers to; `None`: to none.
    pub fn reference(&self) -> Option<i64> {
        self.get("fileID")?.text()?.parse().ok().filter(|id| *id != 0)
    }

    /// The items of a list.
    pub fn items(&self) -> &[Self] {
        if let Self::List(items) = self { items } else { &[] }
    }

    fn number(&self) -> Option<f64> {
        self.text()?.parse().ok()
    }

    fn put(&mut self, key: &str, value: Self) {
        let Self::Map(members) = self else { return };
        match members.iter_mut().find(|(name, _)| name == key) {
            Some((_, old)) => *old = value,
            None => members.push((key.to_owned(), value)),
        }
    }

    fn referring_to(id: i64) -> Self {
        Self::Map(vec![("fileID".to_owned(), Self::Text(id.to_string()))])
    }
}

impl UnityDocument {
    /// One without fields.
    pub fn new(class: u32, anchor: i64) -> Self {
        Self { class, anchor, is_stripped: false, fields: Node::Map(Vec::new()) }
    }

    pub fn field(&self, key: &str) -> Option<&Node> {
        self.fields.get(key)
    }

    pub fn text(&self, key: &str) -> Option<String> {
        Some(self.field(key)?.text()?.to_owned())
    }

    /// The document that a field refers to; `None`: to none.
    pub fn reference(&self, key: &str) -> Option<i64> {
        self.field(key)?.reference()
    }

    /// A field that is a vector: the members that are named.
    pub fn numbers<const N: usize>(&self, key: &str, members: [&str; N]) -> Option<[f64; N]> {
        let value = self.field(key)?;
        let mut out = [0.0; N];
        for (slot, name) in out.iter_mut().zip(members) {
            *slot = value.get(name)?.number()?;
        }
        Some(out)
    }

    /// The object that it tells of, as the script that carries what the program says of one. That of a prefab tells of none.
    pub fn told_id(&self) -> Option<String> {
        self.field("declaration")?;
        self.text("id").filter(|id| !id.is_empty())
    }

    /// Changes a field, or a member of one: `m_LocalPosition.x`.
    pub fn set(&mut self, path: &str, value: &str) {
        let value = Node::Text(value.to_owned());
        let Some((key, name)) = path.rsplit_once('.') else { return self.fields.put(path, value) };
        let usual = match key {
            "m_LocalPosition" => [("x", "0"), ("y", "0"), ("z", "0")].as_slice(),
            "m_LocalRotation" => &[("x", "0"), ("y", "0"), ("z", "0"), ("w", "1")],
            "m_LocalScale" => &[("x", "1"), ("y", "1"), ("z", "1")],
            // Nothing else that has members is read.
            _ => return,
        };
        let owned = |(key, value): &(&str, &str)| ((*key).to_owned(), Node::Text((*value).to_owned()));
        let mut vector = self.field(key).cloned().unwrap_or_else(|| Node::Map(usual.iter().map(owned).collect()));
        if vector.get(name).is_some() {
            vector.put(name, value);
        }
        self.fields.put(key, vector);
    }

    /// Makes a field refer to a document.
    pub fn refer_to(&mut self, key: &str, id: i64) {
        self.fields.put(key, Node::referring_to(id));
    }

    /// Gives what it belongs to and what it is below other anchors.
    pub fn refer(&mut self, to: impl Fn(i64) -> i64) {
        for key in ["m_GameObject", "m_Father"] {
            if let Some(id) = self.reference(key) {
                self.refer_to(key, to(id));
            }
        }
    }
}

/// The documents of a file. One that ends in no YAML has the fields before that.
pub(super) fn documents(text: &str) -> Vec<UnityDocument> {
    const HEADER: &str = "--- !u!";
    let starts: Vec<usize> = text
        .match_indices(HEADER)
        .map(|(at, _)| at)
        .filter(|at| *at == 0 || text.as_bytes()[at - 1] == b'\n')
        .collect();
    let ends = starts.iter().skip(1).copied().chain([text.len()]);
    let document = |(from, to): (&usize, usize)| {
        let (header, body) = text[*from..to].split_once('\n').unwrap_or((&text[*from..to], ""));
        let mut words = header[HEADER.len()..].split_whitespace();
        let class = words.next().and_then(|word| word.parse().ok()).unwrap_or_default();
        let anchor = words.next().and_then(|word| word.strip_prefix('&')?.parse().ok()).unwrap_or_default();
        // The one key is the name of the class.
        let fields = match value(body) {
            Node::Map(mut classes) if !classes.is_empty() => classes.swap_remove(0).1,
            _ => Node::Map(Vec::new()),
        };
        let fields = if matches!(fields, Node::Map(_)) { fields } else { Node::Map(Vec::new()) };
        UnityDocument { class, anchor, is_stripped: words.next() == Some("stripped"), fields }
    };
    starts.iter().zip(ends).map(document).collect()
}

/// A map or a list that is not complete yet, and the key that waits for its value.
type Open = (Node, Option<String>);

/// The value of a text of YAML, as far as it can be read.
fn value(text: &str) -> Node {
    let mut open: Vec<Open> = vec![(Node::List(Vec::new()), None)];
    // How many levels below the deepest that is kept.
    let mut below = 0_usize;
    for (event, _) in Parser::new_from_str(text).map_while(Result::ok) {
        match event {
            Event::MappingStart(..) | Event::SequenceStart(..) if below > 0 || open.len() > DEEPEST => below += 1,
            Event::MappingEnd | Event::SequenceEnd if below > 0 => below -= 1,
            Event::MappingStart(..) => open.push((Node::Map(Vec::new()), None)),
            Event::SequenceStart(..) => open.push((Node::List(Vec::new()), None)),
            Event::MappingEnd | Event::SequenceEnd => close(&mut open),
            Event::Scalar(text, ..) if below == 0 => add(&mut open, Node::Text(text.into_owned())),
            Event::Alias(_) if below == 0 => add(&mut open, Node::Text(String::new())),
            _ => {}
        }
    }
    while open.len() > 1 {
        close(&mut open);
    }
    match open.pop() {
        Some((Node::List(mut found), _)) if !found.is_empty() => found.swap_remove(0),
        _ => Node::List(Vec::new()),
    }
}

fn close(open: &mut Vec<Open>) {
    if open.len() > 1
        && let Some((node, _)) = open.pop()
    {
        add(open, node);
    }
}

/// Adds a value to what is open, or takes it as a key.
fn add(open: &mut [Open], node: Node) {
    match open.last_mut() {
        Some((Node::List(items), _)) => items.push(node),
        Some((Node::Map(members), key)) => match (key.take(), node) {
            (Some(name), value) => members.push((name, value)),
            (None, Node::Text(name)) => *key = Some(name),
            // A key that is no text: its value is left out with it.
            (None, _) => *key = Some(String::new()),
        },
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const XYZ: [&str; 3] = ["x", "y", "z"];

    #[test]
    fn fields_are_read_as_unity_writes_them() {
        let text = "%YAML 1.1\n--- !u!4 &12\nTransform:\n  m_Father: {fileID: 7}\n  m_LocalPosition: {x: 1, y: -0.5,\n    z: 2e-3}\n  \
                    m_Children:\n  - {fileID: 9}\n  m_Name: 'it''s'\n--- !u!114 &-3\nMonoBehaviour:\n  id: \"chair[0]\"\n  \
                    declaration: \"a long\n    text\"\n  m_Script: {fileID: 0}\n";
        let found = documents(text);
        assert_eq!((found[0].class, found[0].anchor, found[1].anchor), (4, 12, -3));
        assert_eq!(found[0].reference("m_Father"), Some(7));
        assert_eq!(found[0].numbers("m_LocalPosition", XYZ), Some([1.0, -0.5, 2e-3]));
        assert_eq!(found[0].text("m_Name").as_deref(), Some("it's"));
        assert_eq!(found[1].text("id").as_deref(), Some("chair[0]"));
        assert_eq!(found[1].text("declaration").as_deref(), Some("a long text"));
        assert_eq!(found[1].reference("m_Script"), None);
    }

    #[test]
    fn other_programs_write_the_same_in_other_forms() {
        let text = "--- !u!4 &12 stripped\r\nTransform:\r\n  m_LocalPosition:\r\n    x: !!float '1.05'\r\n    y: \"2\"\r\n    z: 3\r\n  \
                    m_Father:\r\n    fileID: 7\r\n  ? [odd]\r\n  : key\r\n  m_Name: after it\r\n";
        let found = &documents(text)[0];
        assert!(found.is_stripped);
        assert_eq!(found.numbers("m_LocalPosition", XYZ), Some([1.05, 2.0, 3.0]));
        assert_eq!(found.reference("m_Father"), Some(7));
        assert_eq!(found.text("m_Name").as_deref(), Some("after it"));
    }

    #[test]
    fn a_field_is_changed_by_its_path() {
        let mut document = documents("--- !u!4 &1\nTransform:\n  m_LocalPosition: {x: 1, y: 2, z: 3}\n").remove(0);
        for (path, value) in [
            ("m_LocalPosition.y", "-0.5"),
            ("m_LocalScale.z", "2"),
            ("m_LocalPosition.q", "9"),
            ("lines.Array.data[0]", "x"),
            ("m_Name", "grün"),
        ] {
            document.set(path, value);
        }
        assert_eq!(document.numbers("m_LocalPosition", XYZ), Some([1.0, -0.5, 3.0]));
        assert_eq!(document.numbers("m_LocalScale", XYZ), Some([1.0, 1.0, 2.0]));
        assert_eq!(document.numbers("m_LocalRotation", ["x", "y", "z", "w"]), None);
        assert_eq!(document.text("m_Name").as_deref(), Some("grün"));
        assert_eq!(document.reference("m_Father"), None);
    }

    #[test]
    fn any_text_is_survived() {
        let deep = format!("--- !u!4 &1\nTransform: {}", "[".repeat(100_000));
        let broken = "--- !u!1 &1\nGameObject:\n  m_Name: desk\n  m_Is: {x: 1\n --- }\n\t:\n&a *a";
        for text in [deep.as_str(), broken, "--- !u!", "--- !u!4 &99999999999999999999\n- 1\n", "\u{feff}--- !u!4 &1\n"]
        {
            documents(text);
        }
        assert_eq!(documents(broken)[0].text("m_Name").as_deref(), Some("desk"));
    }
}
