//! Warnings about programs of several files, and about programs that no hand has written.

use scenelang_base::SourceMap;
use scenelang_lang::sources::Loader;
use scenelang_lang::{Options, compile_text, compile_with};
use std::io;
use std::path::Path;

/// Files by name; the first is the main one.
struct Files<'f>(&'f [(&'f str, &'f str)]);

impl Loader for Files<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        let file = self.0.iter().find(|(name, _)| path == Path::new(name));
        file.map(|(_, text)| text.as_bytes().to_vec()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

/// What is found, as `file:line code`.
fn found(files: &[(&str, &str)]) -> Vec<String> {
    let main = files[0].0;
    let compiled = compile_with(main, Path::new(main), Options::default(), &Files(files), SourceMap::new());
    let told = compiled.diagnostics.iter().map(|d| {
        let place = d.primary.as_ref().unwrap().place;
        format!("{}:{} {}", compiled.sources.get(place.file).name(), compiled.sources.lines(place).0.line, d.code)
    });
    told.collect()
}

#[test]
fn imported_files_are_made_for_others() {
    let library = "Number eye;\neye <- 1.6;\nNumber seat;\nseat <- 0.45;\n\
                   predicate lit(Object a, Object lamp) := lamp.pos.y > eye and a.pos.x > 0;\n\
                   predicate doorsFree() := forall d in objects where .category = \"door\": clear(d, front, 1);\n\
                   predicate never(Object a) := a.pos.x > 1;\n";
    let rules = "assert forall d in objects where .category = \"door\": clear(d, front, 0.9);\n";
    let things = "object desk;\nobject lamp;\nobject shelf;\ndesk.category <- \"desk\";\n";
    type Case<'c> = (&'c [(&'c str, &'c str)], &'c [&'c str]);
    let cases: [Case<'_>; 8] = [
        // A library by itself, rules by themselves, declarations by themselves.
        (&[("lib.scene", library)], &[]),
        (&[("rules.scene", rules)], &[]),
        (&[("things.scene", "object desk;\nregion room;\n")], &[]),
        // Used in part: what is left is no news, nor that a parameter is called like something of the importer.
        (
            &[
                ("main.scene", "import \"lib.scene\";\nobject a;\nobject lamp;\nassert lit(a, lamp);\n"),
                ("lib.scene", library),
            ],
            &[],
        ),
        (&[("main.scene", "import \"rules.scene\";\nobject a;\nassert a.pos.x > 1;\n"), ("rules.scene", rules)], &[]),
        // But an object that is imported is in the scene.
        (
            &[("main.scene", "import \"things.scene\";\nassert on(lamp, desk);\n"), ("things.scene", things)],
            &["things.scene:3 W0201"],
        ),
        // The main file can see what it imports; equal statements of two files are two.
        (
            &[
                (
                    "main.scene",
                    "import \"b.scene\";\nobject c[2];\nassert forall a in c: a.pos.x > 0;\nassert a.pos.x > 1;\n",
                ),
                ("b.scene", "object a;\nassert a.pos.x > 1;\n"),
            ],
            &["main.scene:3 W0203"],
        ),
        // Comments silence what stands in their own file, and only the main file's are told to be idle.
        (
            &[
                (
                    "main.scene",
                    "// allow(W0201, W0304)\nimport \"b.scene\";\nobject a;\nassert b.pos.x > 1;\nassert true;\n",
                ),
                ("b.scene", "object b;\nobject d;\nassert true; // allow(W0304)\nobject e; // allow(W0201, W0301)\n"),
            ],
            &["b.scene:2 W0201"],
        ),
    ];
    for (files, expected) in cases {
        assert_eq!(found(files), expected, "{files:?}");
    }
}

#[test]
fn a_file_that_cannot_be_read_hides_what_it_uses() {
    let main = "import \"gone.scene\";\nobject lamp;\nobject desk;\nassert desk.pos.x > 1;\n";
    assert_eq!(found(&[("main.scene", main)]), ["main.scene:1 E0206"]);
    let broken = "assert lamp.pos.x > ;\n";
    assert_eq!(found(&[("main.scene", main), ("gone.scene", broken)]), ["gone.scene:1 E0112"]);
}

#[test]
fn so_many_warnings_of_a_file_are_listed() {
    let mut text: String = (0..300).map(|i| format!("object a{i};\n")).collect();
    text.push_str("object lamp;\nassert lamp.pos.x > 1;\n");
    let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
    assert_eq!(compiled.diagnostics.len(), scenelang_lang::compile::MAX_ERRORS);
}

/// What nests as deeply as the parser lets it is looked at without a stack overflow.
#[test]
fn deep_nesting_is_no_problem() {
    let deep = |n, open: &str, inner: &str, close: &str| format!("{}{inner}{}", open.repeat(n), close.repeat(n));
    let conditions = [
        deep(900, "not ", "(.category = \"chair\")", ""),
        deep(450, "(.color = \"x\" or ", ".category = \"chair\"", ")"),
        deep(450, "(true implies ", ".category = \"chair\"", ")"),
    ];
    for condition in conditions {
        let text = format!(
            "object lamp;\nlamp.category <- \"chair\";\nassert exists o in objects where {condition}: o.pos.x > 1;\n"
        );
        let compiled = compile_text("room.scene", Path::new("room.scene"), &text, Options::default());
        assert!(!compiled.has_errors(), "{:?}", compiled.diagnostics.iter().find(|d| d.is_error()));
    }
}
