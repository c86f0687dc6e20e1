//! A program with a cursor, a layout beside it, and words that others know.

use scenelang_base::{Edit, TextRange};
use scenelang_ide::{Host, Snapshot};
use scenelang_lang::sources::Loader;
use std::io;
use std::path::Path;

/// What the main file imports.
const PARTS: &str =
    "/// They are within arm's length.\npredicate atHand(Object a, Object b) := near(a, b, 1);\nobject spare;\n";

/// A bedroom, in which a stand is in the bed.
pub const ROOM: &str = "import \"parts.scene\";
region room;
room.pos <- vec3(0, 0, 0);
room.scale <- vec3(4, 2.6, 4);
/// Where one sleeps.
object bed;
bed.category <- \"bed\";
bed.dimensions <- vec3(1.6, 0.55, 2);
object stand[2];
stand.category <- \"nightstand\";
object lamp;
Number space;
predicate low(Object thing, Number height) := thing.top < height;
@req(\"a lamp stands on the left stand\")
assert on(lamp, stand[0]);
assert gap(stand[1], bed) >= space and lamp.top > 0.5;
";

const LAYOUT: &str = r#"{
  "format": "scenelang.layout/1",
  "scene": "room.scene",
  "objects": {
    "bed": { "pos": [0, 0, -0.9], "rot": [0, 0, 0], "scale": [1.6, 0.55, 2] },
    "stand[0]": { "pos": [-1.05, 0, -1.5], "rot": [0, 0, 0], "scale": [0.4, 0.5, 0.4] },
    "stand[1]": { "pos": [0.9, 0, -1.5], "rot": [0, 0, 0], "scale": [0.4, 0.5, 0.4] },
    "lamp": { "pos": [-1.05, 0.5, -1.5], "rot": [0, 0, 0], "scale": [0.2, 0.4, 0.2] },
    "spare": { "pos": [1.5, 0, 1.5], "rot": [0, 0, 0], "scale": [0.2, 0.4, 0.2] }
  },
  "regions": { "room": { "pos": [0, 0, 0], "rot": [0, 0, 0], "scale": [4, 2.6, 4] } },
  "variables": { "space": 0.02 }
}"#;

struct Files;

impl Loader for Files {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        match path.to_str() {
            Some("/rooms/parts.scene") => Ok(PARTS.as_bytes().to_vec()),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    }
}

/// A program, what is known of it, and where the cursor is.
pub struct Fixture {
    pub snapshot: Snapshot,
    pub text: String,
    pub at: u32,
}

impl Fixture {
    /// A program with `$0` in it, beside the layout of the bedroom.
    pub fn new(marked: &str) -> Self {
        Self::beside(marked, LAYOUT)
    }

    /// The bedroom with these lines behind it, in which the cursor is.
    pub fn with(lines: &str) -> Self {
        Self::new(&format!("{ROOM}{lines}"))
    }

    /// The bedroom with the cursor where `marked`, a piece of it, has `$0`.
    pub fn at(marked: &str) -> Self {
        let plain = marked.replacen("$0", "", 1);
        assert_eq!(ROOM.matches(&plain).count(), 1, "{plain} is once in the room");
        Self::new(&ROOM.replacen(&plain, marked, 1))
    }

    /// A program beside another layout.
    pub fn beside(marked: &str, layout: &str) -> Self {
        let at = marked.find("$0").unwrap_or(0);
        let text = marked.replacen("$0", "", 1);
        let path = Path::new("/rooms/room.scene");
        let mut host = Host::new("room.scene", path, &text, &Files);
        let file = Path::new("/rooms/room.layout.json");
        host.set_layout(Some(("room.layout.json".to_owned(), file, Ok(layout.as_bytes().to_vec()))));
        Self { snapshot: host.snapshot(), text, at: at as u32 }
    }

    /// The text of a range.
    pub fn slice(&self, range: TextRange) -> &str {
        &self.text[range.bytes()]
    }

    /// The main file after edits.
    pub fn edited(&self, edits: &[Edit]) -> String {
        let mut own: Vec<&Edit> = edits.iter().filter(|e| e.place.file == self.snapshot.main()).collect();
        own.sort_by_key(|e| e.place.range.start);
        let mut text = self.text.clone();
        for edit in own.iter().rev() {
            text.replace_range(edit.place.range.bytes(), &edit.text);
        }
        text
    }
}

/// What could be imported.
pub fn imports() -> Vec<String> {
    vec!["parts.scene".to_owned()]
}
