//! Edits of a program's text, tried out in memory before they are offered.

use super::Text;
use scenelang_base::{Edit, FileId, SourceMap, TextRange, fix};
use scenelang_lang::Program;
use scenelang_lang::compile::compile_with;
use scenelang_lang::sources::Loader;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

/// The texts of the files that edits change, by file; `None`: the edits overlap.
pub fn edited(sources: &SourceMap, edits: &[Edit]) -> Option<BTreeMap<FileId, String>> {
    let mut by_file: BTreeMap<FileId, Vec<Edit<TextRange>>> = BTreeMap::new();
    for edit in edits {
        let own = Edit { place: edit.place.range, text: edit.text.clone() };
        by_file.entry(edit.place.file).or_default().push(own);
    }
    let mut texts = BTreeMap::new();
    for (file, edits) in by_file {
        let applied = fix::apply(sources.get(file).text(), [edits.as_slice()]);
        if !applied.left.is_empty() {
            return None;
        }
        texts.insert(file, applied.text);
    }
    Some(texts)
}

/// The program after edits, if it compiles.
pub(super) fn compiled(text: &Text<'_>, edits: &[Edit]) -> Option<Program> {
    let files = edited(text.sources, edits)?;
    let files = files.into_iter().map(|(id, new)| (text.sources.get(id).path().to_path_buf(), new)).collect();
    let over = Over { files, loader: text.loader };
    compile_with(text.name, text.path, text.compile, &over, SourceMap::new()).program
}

/// Files as they are after edits, on top of another loader.
struct Over<'l> {
    files: BTreeMap<PathBuf, String>,
    loader: &'l dyn Loader,
}

impl Loader for Over<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self.files.get(path) {
            Some(text) => Ok(text.clone().into_bytes()),
            None => self.loader.load(path),
        }
    }
}
