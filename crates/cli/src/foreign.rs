//! Houses and layouts of other systems: read, and judged by what they say.

use crate::args::Beside as Args;
use scenelang_analysis::Question;
use scenelang_base::door::Door;
use scenelang_base::{Diagnostic, FileId, SourceFile, SourceMap};
use scenelang_engine::check_layout_text;
use scenelang_foreign::{Beside, Foreign, RoomFile, Sizes, read, recognise};
use scenelang_lang::sources::{Loader, decode, unreadable};
use scenelang_verify::{Checked, Options};
use std::path::Path;

/// Why a file cannot be used; places refer to the sources.
pub type Refused = Box<(SourceMap, Diagnostic)>;

/// Whether a file may be one of another system, by its name. Layouts of ours are not.
pub fn may_be(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    name.ends_with(".json") && !name.ends_with(".layout.json")
}

/// A file of another system; `None`: it is none, or cannot be read at all.
pub fn find(name: &str, path: &Path, args: &Args, loader: &dyn Loader) -> Option<Result<Foreign, Refused>> {
    if !may_be(path) {
        return None;
    }
    let mut sources = SourceMap::new();
    let file = decode(name, path, loader.load(path).ok()?, &mut sources).ok()?;
    recognise(sources.get(file).text())?;
    Some(taken(name, path, file, sources, args))
}

/// Any file that a user says is one.
///
/// # Errors
/// It cannot be read, or is none.
pub fn open(name: &str, path: &Path, args: &Args, loader: &dyn Loader) -> Result<Foreign, Refused> {
    let mut sources = SourceMap::new();
    match text(name, path, &mut sources, loader) {
        Ok(file) => taken(name, path, file, sources, args),
        Err(finding) => Err(Box::new((sources, *finding))),
    }
}

fn taken(name: &str, path: &Path, file: FileId, mut sources: SourceMap, args: &Args) -> Result<Foreign, Refused> {
    let found = beside(args, &mut sources);
    let found = found.and_then(|beside| read(name, path, sources.get(file).text(), file, &beside));
    found.map_err(|finding| Box::new((sources, *finding)))
}

fn beside(args: &Args, sources: &mut SourceMap) -> Result<Beside, Box<Diagnostic>> {
    let mut out = Beside::default();
    let mut open = |path: &Path| {
        let (name, door) = (path.display().to_string(), Door::of(path));
        text(&name, path, sources, &door).map(|file| (sources.get(file).text().to_owned(), file))
    };
    if let Some(path) = &args.sizes {
        let (text, file) = open(path)?;
        out.sizes = Sizes::read(&text, file)?;
    }
    if let Some(path) = &args.room {
        let (text, file) = open(path)?;
        out.room = Some(RoomFile::read(&text, file)?);
    }
    Ok(out)
}

fn text(name: &str, path: &Path, sources: &mut SourceMap, loader: &dyn Loader) -> Result<FileId, Box<Diagnostic>> {
    let bytes = loader.load(path).map_err(|e| {
        sources.put(SourceFile::new(name, path, ""));
        Box::new(unreadable(&format!("read {name}"), &e))
    })?;
    decode(name, path, bytes, sources).map_err(|refused| Box::new(refused.1))
}

/// Judges what was read of a file that is called `name`.
pub fn judge(name: &str, found: Result<Foreign, Refused>, question: &Question<'_>, options: &Options) -> Checked {
    let scene = match found {
        Ok(scene) => scene,
        Err(refused) => return Checked::refused(name, refused.0, vec![refused.1], options),
    };
    let (called, at) = (&scene.layout_name, &scene.layout_path);
    let mut checked = check_layout_text(called, at, scene.layout.clone(), options, question.compile, &scene);
    if !scene.notes.is_empty() {
        checked.preface(called, scene.notes.clone(), options);
    }
    name.clone_into(&mut checked.report.file);
    checked
}
