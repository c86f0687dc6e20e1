//! Names that several programs of a workspace share: found and renamed in all of them, open or not, and in their layouts.

use crate::client::{Client, at, edited, slice};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use tempfile::TempDir;

const PARTS: &str = "object shelf;\nshelf.dimensions <- vec3(1, 2, 0.3);\n\
    predicate tall(Object thing) := thing.top > 1;\nassert tall(shelf);\n";
/// Open, as is `parts.scene`.
const ROOM: &str = "import \"parts.scene\";\nobject bed;\nassert gap(bed, shelf) > 0.1;\nassert tall(bed);\n";
/// Open, but other on disk; reads the parts by way of another program, from a folder of its own.
const LOFT: &str = "import \"../attic.scene\";\nassert shelf.top < 3;\n";
const FILES: [(&str, &str); 8] = [
    ("parts.scene", PARTS),
    ("room.scene", ROOM),
    ("attic.scene", "import \"parts.scene\";\nassert shelf.pos.x > 0 and tall(shelf);\n"),
    ("deep/loft.scene", "import \"../attic.scene\";\n"),
    // Has a layout and names nothing.
    ("cellar.scene", "import \"parts.scene\";\n"),
    // Means another thing by the same names.
    ("other.scene", "object shelf;\npredicate tall(Object thing) := thing.top > 2;\nassert tall(shelf);\n"),
    (
        "cellar.layout.json",
        "{ \"format\": \"scenelang.layout/1\", \"objects\": { \"shelf\": { \"pos\": [0, 0, 0] } } }\n",
    ),
    (
        "other.layout.json",
        "{ \"format\": \"scenelang.layout/1\", \"objects\": { \"shelf\": { \"pos\": [0, 0, 0] } } }\n",
    ),
];

struct Workspace {
    folder: TempDir,
    client: Client,
    texts: BTreeMap<String, String>,
}

impl Workspace {
    fn open() -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("deep")).unwrap();
        for (file, text) in FILES {
            std::fs::write(folder.path().join(file), text).unwrap();
        }
        let mut client = Client::start(folder.path());
        let mut texts: BTreeMap<String, String> =
            FILES.iter().map(|(file, text)| (client.uri(file), (*text).to_owned())).collect();
        for (file, text) in [("room.scene", ROOM), ("deep/loft.scene", LOFT), ("parts.scene", PARTS)] {
            let uri = client.open(file, text);
            texts.insert(uri, text.to_owned());
        }
        Self { folder, client, texts }
    }

    fn place(&self, file: &str, marked: &str) -> Value {
        let uri = self.client.uri(file);
        json!({ "textDocument": { "uri": uri }, "position": at(&self.texts[&uri], marked) })
    }

    /// How often something is named in each file.
    fn named(&mut self, file: &str, marked: &str, declaration: bool) -> BTreeMap<String, usize> {
        let mut params = self.place(file, marked);
        params["context"] = json!({ "includeDeclaration": declaration });
        let found = self.client.ask("textDocument/references", params);
        let word = marked.replace('|', "").split([' ', '(', '.']).next_back().unwrap_or_default().to_owned();
        let mut out = BTreeMap::new();
        for place in found.as_array().unwrap() {
            let uri = place["uri"].as_str().unwrap();
            assert_eq!(slice(&self.texts[uri], &place["range"]), word, "{place}");
            *out.entry(self.file(uri)).or_default() += 1;
        }
        out
    }

    fn file(&self, uri: &str) -> String {
        uri.strip_prefix(&self.client.uri("")).unwrap().to_owned()
    }

    /// The texts that another name changes.
    fn renamed(&mut self, file: &str, marked: &str, new: &str) -> BTreeMap<String, String> {
        let mut params = self.place(file, marked);
        params["newName"] = new.into();
        let change = self.client.ask("textDocument/rename", params);
        let changes = change["documentChanges"].as_array().unwrap();
        let changed = changes.iter().map(|change| {
            let (uri, version) = (change["textDocument"]["uri"].as_str().unwrap(), &change["textDocument"]["version"]);
            let open = ["room.scene", "deep/loft.scene", "parts.scene"].contains(&self.file(uri).as_str());
            assert_eq!(version.is_null(), !open, "{change}");
            (self.file(uri), edited(&self.texts[uri], &change["edits"]))
        });
        changed.collect()
    }
}

fn counts(list: &[(&str, usize)]) -> BTreeMap<String, usize> {
    list.iter().map(|(file, n)| ((*file).to_owned(), *n)).collect()
}

#[test]
fn references_are_found_in_all_programs() {
    let mut w = Workspace::open();
    let shelf = [("parts.scene", 3), ("room.scene", 1), ("attic.scene", 2), ("deep/loft.scene", 1)];
    let tall = [("parts.scene", 2), ("room.scene", 1), ("attic.scene", 1)];
    // It does not matter where one asks.
    assert_eq!(w.named("parts.scene", "object |shelf", true), counts(&shelf));
    assert_eq!(w.named("room.scene", "gap(bed, |shelf", true), counts(&shelf));
    assert_eq!(w.named("deep/loft.scene", "assert |shelf", true), counts(&shelf));
    assert_eq!(w.named("room.scene", "assert |tall", true), counts(&tall));
    let without = [("parts.scene", 1), ("room.scene", 1), ("attic.scene", 1)];
    assert_eq!(w.named("parts.scene", "predicate |tall", false), counts(&without));
    // What only one program knows.
    assert_eq!(w.named("room.scene", "object |bed", true), counts(&[("room.scene", 3)]));
    assert_eq!(w.named("parts.scene", "tall(Object |thing", true), counts(&[("parts.scene", 2)]));
    assert_eq!(w.client.stop(), 0);
}

#[test]
fn a_new_name_is_given_in_all_programs() {
    let mut w = Workspace::open();
    for (file, place) in [("parts.scene", "object |shelf"), ("deep/loft.scene", "assert |shelf")] {
        let changed = w.renamed(file, place, "rack");
        let files: Vec<&str> = changed.keys().map(String::as_str).collect();
        assert_eq!(
            files,
            ["attic.scene", "cellar.layout.json", "deep/loft.scene", "parts.scene", "room.scene"],
            "{place}"
        );
        assert_eq!(changed["attic.scene"], "import \"parts.scene\";\nassert rack.pos.x > 0 and tall(rack);\n");
        assert!(changed["cellar.layout.json"].contains("\"rack\": { \"pos\""));
        assert_eq!(changed["deep/loft.scene"], LOFT.replace("shelf", "rack"));
        assert_eq!(changed["parts.scene"], PARTS.replace("shelf", "rack"));
    }
    let changed = w.renamed("room.scene", "assert |tall", "high");
    let files: Vec<&str> = changed.keys().map(String::as_str).collect();
    assert_eq!(files, ["attic.scene", "parts.scene", "room.scene"]);
    // A name that another program has taken: nobody would know there which is meant.
    let mut params = w.place("parts.scene", "object |shelf");
    params["newName"] = "bed".into();
    let (code, why) = w.client.refused("textDocument/rename", params);
    assert_eq!((code, why.as_str()), (-32803, "in room.scene: there is already a declaration of `bed`"));
    // Within a statement nobody else has a say.
    let changed = w.renamed("parts.scene", "tall(Object |thing", "bed");
    assert_eq!(changed.keys().map(String::as_str).collect::<Vec<_>>(), ["parts.scene"]);
    assert_eq!(w.client.stop(), 0);
}

/// Programs that nobody can read, or that import themselves, stand in nobody's way.
#[test]
fn a_workspace_may_be_in_disorder() {
    let mut w = Workspace::open();
    for (file, text) in [
        ("a.scene", &b"import \"b.scene\";\nimport \"parts.scene\";\nassert shelf.top > 0;"[..]),
        ("b.scene", b"import \"a.scene\";\nassert ((; shelf;"),
        ("c.scene", b"import \"parts.scene\"; \xff\xfe"),
        ("d.scene", b"import \"missing.scene\";"),
    ] {
        std::fs::write(w.folder.path().join(file), text).unwrap();
        let uri = w.client.uri(file);
        w.texts.insert(uri, String::from_utf8_lossy(text).into_owned());
    }
    std::fs::create_dir(w.folder.path().join("e.scene")).unwrap();
    let found = w.named("parts.scene", "object |shelf", true);
    assert_eq!((found["a.scene"], found["room.scene"]), (1, 1), "{found:?}");
    assert_eq!(w.client.stop(), 0);
}
