//! Any text is compiled without a panic; a program without errors has formulas, one with errors says where they are.
#![no_main]

use libfuzzer_sys::fuzz_target;
use scenelang_lang::sources::Loader;
use scenelang_lang::{Options, compile_main};
use scenelang_base::{SourceFile, SourceMap};
use std::io;
use std::path::Path;

/// One file that can be imported, and nothing else.
struct Other;

impl Loader for Other {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        match path.to_str() {
            Some("other.scene") => Ok(b"import \"main.scene\"; object lamp; region room; predicate p(Object a) := q(a);".into()),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    }
}

fuzz_target!(|input: (bool, &str)| {
    let (core, text) = input;
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new("main.scene", "main.scene", text));
    let compiled = compile_main(main, Options { core }, &Other, sources);
    assert_eq!(compiled.program.is_none(), compiled.has_errors());
    for d in &compiled.diagnostics {
        let primary = d.primary.as_ref().expect("everything said of a text has a place");
        let text = compiled.sources.get(primary.place.file).text();
        assert!(text.get(primary.place.range.bytes()).is_some(), "a place outside the text: {d:?}");
    }
});
