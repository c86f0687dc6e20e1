//! Where everything in a layout file stands, for whoever finds fault with it later.

use super::json::{JsonNode, Member, find};
use scenelang_base::{FileId, Span, TextRange};
use smol_str::SmolStr;
use std::collections::HashMap;

/// Where a member of a JSON object stands in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MemberPlace {
    /// The key, with its quotation marks.
    pub key: Span,
    /// The whole value.
    pub value: Span,
}

/// An entry of one of the blocks: an object, a region, a variable or a draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Its name (the key, escapes resolved).
    pub name: SmolStr,
    /// Key and value.
    pub place: MemberPlace,
    members: Vec<(SmolStr, MemberPlace)>,
}

impl Entry {
    /// Where its member `pos`, `rot`, … stands.
    pub fn member(&self, key: &str) -> Option<MemberPlace> {
        self.members.iter().find(|(k, _)| k == key).map(|(_, p)| *p)
    }
}

/// The entries of a block in the order of the file. What could not be read is here too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Block {
    entries: Vec<Entry>,
    index: HashMap<SmolStr, usize>,
}

impl Block {
    pub fn get(&self, name: &str) -> Option<&Entry> {
        self.index.get(name).map(|&i| &self.entries[i])
    }
    /// All entries.
    pub fn iter(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter()
    }
    fn of(file: FileId, members: &[Member]) -> Self {
        let place = |m: &Member| MemberPlace { key: m.key_range.in_file(file), value: m.node.range.in_file(file) };
        let entries: Vec<Entry> = members
            .iter()
            .map(|m| Entry {
                name: SmolStr::new(&m.key),
                place: place(m),
                members: m.node.members().unwrap_or_default().iter().map(|n| ((&n.key).into(), place(n))).collect(),
            })
            .collect();
        let index = entries.iter().enumerate().map(|(i, e)| (e.name.clone(), i)).collect();
        Self { entries, index }
    }
}

/// Places in a layout file.
#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    pub document: Span,
    /// Its members `scene`, `objects`, ….
    pub top: Block,
    pub objects: Block,
    pub regions: Block,
    /// Decision variables.
    pub variables: Block,
    /// Recorded draws.
    pub draws: Block,
}

impl Places {
    pub(super) fn of(file: FileId, root: &JsonNode) -> Self {
        let members = root.members().unwrap_or_default();
        let block = |key| Block::of(file, find(members, key).and_then(|m| m.node.members()).unwrap_or_default());
        Self {
            document: root.range.in_file(file),
            top: Block::of(file, members),
            objects: block("objects"),
            regions: block("regions"),
            variables: block("variables"),
            draws: block("draws"),
        }
    }
    pub(super) fn nowhere(file: FileId) -> Self {
        let none = Block::default;
        let document = TextRange::empty(0).in_file(file);
        Self { document, top: none(), objects: none(), regions: none(), variables: none(), draws: none() }
    }
    /// Where to say that something is missing in a block (`objects`, `regions`, …): at its key, or at the brace that
    /// opens the document if there is no such block.
    pub fn block(&self, key: &str) -> Span {
        self.top.get(key).map_or_else(|| self.opening(), |e| e.place.key)
    }
    /// The brace that opens the document.
    pub fn opening(&self) -> Span {
        let TextRange { start, end } = self.document.range;
        TextRange { start, end: end.min(start + 1) }.in_file(self.document.file)
    }
}
