//! The front end in one call: read, parse, resolve, check, lower.

use crate::db::Analysis;
use crate::program::Program;
use crate::sources::{Loader, decode, unreadable};
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap};
use std::io::ErrorKind;
use std::path::Path;

/// At most so many errors of a file are listed, and as many warnings.
pub const MAX_ERRORS: usize = 100;

/// How to compile.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Accept only the published core language.
    pub core: bool,
}

/// What came of it.
#[derive(Debug)]
pub struct Compiled {
    /// All files read.
    pub sources: SourceMap,
    pub main: FileId,
    /// The program, if there is no error.
    pub program: Option<Program>,
    /// Errors and warnings, by file and place; at most [`MAX_ERRORS`] of each in a file.
    pub diagnostics: Vec<Diagnostic>,
}

impl Compiled {
    /// Whether there is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}

/// Compiles a file from disk; `name` is how it is called in messages.
pub fn compile_file(name: &str, path: &Path, options: Options) -> Compiled {
    compile_with(name, path, options, &Door::of(path), SourceMap::new())
}

/// Compiles a text; imports come from disk, relative to `path`.
pub fn compile_text(name: &str, path: &Path, text: &str, options: Options) -> Compiled {
    let mut sources = SourceMap::new();
    let main = sources.add(SourceFile::new(name, path, text));
    compile_main(main, options, &Door::of(path), sources)
}

/// Compiles `path` with files from `loader`; `sources` may hold other files already (a layout).
pub fn compile_with(
    name: &str,
    path: &Path,
    options: Options,
    loader: &dyn Loader,
    mut sources: SourceMap,
) -> Compiled {
    match loader.load(path) {
        Err(e) => {
            let main = sources.add(SourceFile::new(name, path, ""));
            let d = unreadable(&format!("read {name}"), &e);
            let other = path.with_extension("scene");
            let d = match e.kind() == ErrorKind::NotFound && other != path && loader.load(&other).is_ok() {
                true => d.note(format!("did you mean {}?", Path::new(name).with_extension("scene").display())),
                false => d,
            };
            Compiled { sources, main, program: None, diagnostics: vec![d] }
        }
        Ok(bytes) => match decode(name, path, bytes, &mut sources) {
            Err(refused) => {
                let (main, d) = *refused;
                Compiled { sources, main, program: None, diagnostics: vec![d] }
            }
            Ok(main) => compile_main(main, options, loader, sources),
        },
    }
}

/// Compiles a file that is in `sources` already.
pub fn compile_main(main: FileId, options: Options, loader: &dyn Loader, mut sources: SourceMap) -> Compiled {
    let mut analysis = Analysis::new(options);
    analysis.update(main, &mut sources, loader);
    let (program, diagnostics) = analysis.program(&sources).expect("nobody else holds it, so nobody changes it");
    Compiled { sources, main, program, diagnostics }
}
