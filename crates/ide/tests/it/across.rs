//! Names that several programs share by importing the same file: found, and given another name, from any of them.

use scenelang_base::{Edit, Span};
use scenelang_ide::across::{Shared, shared};
use scenelang_ide::names::name_at;
use scenelang_ide::rename::rename;
use scenelang_ide::{Host, navigate};
use scenelang_lang::sources::Loader;
use std::collections::{BTreeMap, BTreeSet};
use std::io;
use std::path::{Path, PathBuf};

/// Files of a folder, one of which has the cursor.
struct Folder {
    files: BTreeMap<PathBuf, String>,
    main: PathBuf,
    at: u32,
}

impl Loader for Folder {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        let text = self.files.get(path).map(|text| text.as_bytes().to_vec());
        text.ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

impl Folder {
    /// Each file after a line `=== NAME`; `$0` is where the cursor is.
    fn new(marked: &str) -> Self {
        let mut folder = Self { files: BTreeMap::new(), main: PathBuf::new(), at: 0 };
        for part in marked.split("=== ").skip(1) {
            let (name, text) = part.split_once('\n').unwrap();
            let path = Path::new("/rooms").join(name);
            if let Some(at) = text.find("$0") {
                (folder.main, folder.at) = (path.clone(), at as u32);
            }
            folder.files.insert(path, text.replacen("$0", "", 1));
        }
        assert!(!folder.main.as_os_str().is_empty(), "there is a cursor");
        folder
    }

    /// A program, with its layout if there is one beside it.
    fn host(&self, path: &Path) -> Host {
        let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
        let mut host = Host::new(&name(path), path, &self.files[path], self);
        let layout = path.with_extension("layout.json");
        if let Some(text) = self.files.get(&layout) {
            host.set_layout(Some((name(&layout), &layout, Ok(text.as_bytes().to_vec()))));
        }
        host
    }

    /// The other programs that read the file of a declaration.
    fn others(&self, shared: &Shared) -> Vec<Host> {
        let programs = self.files.keys().filter(|path| path.extension().is_some_and(|e| e == "scene"));
        let hosts = programs.filter(|path| **path != self.main).map(|path| self.host(path));
        hosts.filter(|host| shared.is_read_by(host.files())).collect()
    }

    /// The files in which something is named, with `‹›` around the name.
    fn references(&self, declaration: bool) -> String {
        let snapshot = self.host(&self.main).snapshot();
        let named = name_at(&snapshot, snapshot.main(), self.at).unwrap().unwrap();
        let spans = |found: Vec<(Span, _)>| found.into_iter().map(|(span, _)| span).collect::<Vec<Span>>();
        let own = navigate::references(&snapshot, snapshot.main(), &named.symbol, declaration).unwrap();
        let mut changed = Changed::default();
        let marked = |span: Span, text: &str| Edit { place: span, text: format!("‹{text}›") };
        let mut add = |snapshot: &scenelang_ide::Snapshot, spans: Vec<Span>| {
            let edits: Vec<Edit> = spans.into_iter().map(|span| marked(span, snapshot.slice(span))).collect();
            changed.add(snapshot, &edits);
        };
        add(&snapshot, spans(own));
        if let Some(shared) = shared(&snapshot, self.at).unwrap() {
            for other in self.others(&shared).iter().map(Host::snapshot) {
                let found = spans(shared.references(&other, declaration).unwrap());
                add(&other, found);
            }
        }
        changed.shown(&self.files)
    }

    /// The files that another name changes, as they are then; or why it cannot be given.
    fn renamed(&self, new: &str) -> Result<String, String> {
        let snapshot = self.host(&self.main).snapshot();
        let mut changed = Changed::default();
        changed.add(&snapshot, &rename(&snapshot, self.at, new).unwrap()?);
        if let Some(shared) = shared(&snapshot, self.at).unwrap() {
            for other in self.others(&shared).iter().map(Host::snapshot) {
                changed.add(&other, &shared.rename(&other, new).unwrap()?);
            }
        }
        Ok(changed.shown(&self.files))
    }
}

/// Other texts by file and place: what two programs say of the same place is one change.
#[derive(Default)]
struct Changed(BTreeMap<PathBuf, BTreeSet<(u32, u32, String)>>);

impl Changed {
    fn add(&mut self, snapshot: &scenelang_ide::Snapshot, edits: &[Edit]) {
        for Edit { place, text } in edits {
            let path = snapshot.sources().get(place.file).path().to_owned();
            self.0.entry(path).or_default().insert((place.range.start, place.range.end, text.clone()));
        }
    }

    fn shown(&self, files: &BTreeMap<PathBuf, String>) -> String {
        let mut out = String::new();
        for (path, edits) in &self.0 {
            let mut text = files[path].clone();
            for (start, end, new) in edits.iter().rev() {
                text.replace_range(*start as usize..*end as usize, new);
            }
            out.push_str(&format!("=== {}\n{text}", path.strip_prefix("/rooms").unwrap().display()));
        }
        out
    }
}

const PARTS: &str = "=== parts.scene
object shelf;
shelf.dimensions <- vec3(1, 2, 0.3);
Number space;
predicate tall(Object thing) := thing.top > space;
=== attic.scene
import \"parts.scene\";
assert tall(shelf) and shelf.pos.x > 0;
=== deep/loft.scene
import \"../attic.scene\";
assert shelf.top < 3 + space;
=== other.scene
object shelf;
assert shelf.top < 3;
=== cellar.scene
import \"parts.scene\";
=== cellar.layout.json
{ \"objects\": { \"shelf\": { \"pos\": [0, 0, 0] } }, \"variables\": { \"space\": 1 } }
";

/// The files of [`PARTS`] with the cursor where `marked`, a piece of them, has `$0`.
fn parts(marked: &str) -> Folder {
    let plain = marked.replacen("$0", "", 1);
    assert_eq!(PARTS.matches(&plain).count(), 1, "{plain} is once in the files");
    Folder::new(&PARTS.replacen(&plain, marked, 1))
}

#[test]
fn references_in_all_programs() {
    let shelf = "=== attic.scene
import \"parts.scene\";
assert tall(‹shelf›) and ‹shelf›.pos.x > 0;
=== deep/loft.scene
import \"../attic.scene\";
assert ‹shelf›.top < 3 + space;
=== parts.scene
object ‹shelf›;
‹shelf›.dimensions <- vec3(1, 2, 0.3);
Number space;
predicate tall(Object thing) := thing.top > space;
";
    let space = "=== deep/loft.scene
import \"../attic.scene\";
assert shelf.top < 3 + ‹space›;
=== parts.scene
object shelf;
shelf.dimensions <- vec3(1, 2, 0.3);
Number ‹space›;
predicate tall(Object thing) := thing.top > ‹space›;
";
    let tall = "=== attic.scene
import \"parts.scene\";
assert ‹tall›(shelf) and shelf.pos.x > 0;
=== parts.scene
object shelf;
shelf.dimensions <- vec3(1, 2, 0.3);
Number space;
predicate ‹tall›(Object thing) := thing.top > space;
";
    for (marked, wanted) in [
        // It does not matter where one asks.
        ("object she$0lf;\nshelf.dimensions", shelf),
        ("tall(shelf$0) and", shelf),
        ("assert shel$0f.top < 3 +", shelf),
        ("Number sp$0ace", space),
        ("3 + spa$0ce", space),
        ("predicate ta$0ll", tall),
        ("assert t$0all(shelf)", tall),
        // What only one program knows, by the same name or another.
        (
            "object s$0helf;\nassert",
            "=== other.scene
object ‹shelf›;
assert ‹shelf›.top < 3;
",
        ),
        (
            "thin$0g.top",
            "=== parts.scene
object shelf;
shelf.dimensions <- vec3(1, 2, 0.3);
Number space;
predicate tall(Object ‹thing›) := ‹thing›.top > space;
",
        ),
    ] {
        assert_eq!(parts(marked).references(true), wanted, "{marked}");
    }
    let without = parts("object she$0lf;\nshelf.dimensions").references(false);
    assert_eq!(without, shelf.replace("object ‹shelf›", "object shelf"));
}

#[test]
fn another_name_in_all_programs() {
    let rack = "=== attic.scene
import \"parts.scene\";
assert tall(rack) and rack.pos.x > 0;
=== cellar.layout.json
{ \"objects\": { \"rack\": { \"pos\": [0, 0, 0] } }, \"variables\": { \"space\": 1 } }
=== deep/loft.scene
import \"../attic.scene\";
assert rack.top < 3 + space;
=== parts.scene
object rack;
rack.dimensions <- vec3(1, 2, 0.3);
Number space;
predicate tall(Object thing) := thing.top > space;
";
    for marked in ["object she$0lf;\nshelf.dimensions", "assert shel$0f.top < 3 +"] {
        assert_eq!(parts(marked).renamed("rack").as_deref(), Ok(rack), "{marked}");
    }
    let room = parts("Number sp$0ace").renamed("height").unwrap();
    assert!(room.contains("\"variables\": { \"height\": 1 }") && room.contains("< 3 + height;"), "{room}");
    assert!(room.contains("thing.top > height;") && !room.contains("other.scene"), "{room}");
}

/// A name that any of the programs has for something else is refused, wherever one asks; one that others have is not.
#[test]
fn names_that_are_taken() {
    let folder = |marked: &str| {
        let text = "=== parts.scene\nobject shelf;\n=== room.scene\nimport \"parts.scene\";\nobject bed;\n\
                    assert near(bed, shelf, 1);\n=== attic.scene\nimport \"parts.scene\";\nassert shelf.top < 2;\n=== other.scene\nobject cot;\n";
        let plain = marked.replacen("$0", "", 1);
        assert_eq!(text.matches(&plain).count(), 1, "{plain} is once in the files");
        Folder::new(&text.replacen(&plain, marked, 1))
    };
    for marked in ["object sh$0elf", "near(bed, sh$0elf", "assert s$0helf.top"] {
        let why = folder(marked).renamed("bed").unwrap_err();
        assert!(why.contains("already a declaration of `bed`"), "{marked}: {why}");
        assert!(folder(marked).renamed("cot").is_ok(), "{marked}");
    }
}
