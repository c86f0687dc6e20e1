//! Stage IV: what is written, and where. All bytes are made before the first file is touched.

use crate::corridor::{Found, Solved};
use scenelang_base::door::Door;
use scenelang_export::{ExportError, Exporter, OutFile, Scene, SceneInput};
use scenelang_lang::program::Program;
use std::io;
use std::path::{Component, Path, PathBuf};

/// Files written, in order.
#[derive(Debug)]
pub struct Written {
    /// Paths, below the output folder or as asked.
    pub paths: Vec<PathBuf>,
}

/// Writes a layout alone.
///
/// # Errors
/// What the file system says.
pub fn save_layout(found: &Found, path: &Path) -> io::Result<()> {
    Door::of(path).write(path, found.text.as_bytes())
}

/// Writes the scene below `folder`: the program with its imports, the layout, the report, and what the exporters make.
///
/// # Errors
/// An exporter that cannot hold the scene (nothing is written then), or what the file system says.
pub fn export(
    solved: &Solved,
    stem: &str,
    folder: &Path,
    exporters: &[Box<dyn Exporter>],
) -> Result<Written, ExportError> {
    let Some(program) = &solved.compiled.program else {
        return Err(ExportError::Format("scene", "the program did not compile".into()));
    };
    let mut files = own_files(solved, stem);
    let scene = build(solved, program, stem)?;
    for exporter in exporters {
        files.extend(exporter.files(&scene)?);
    }
    write(files, folder).map_err(ExportError::Write)
}

/// Writes below `folder` what is there without the exporters: the program with its imports, the layout, the report.
///
/// # Errors
/// What the file system says.
pub fn save(solved: &Solved, stem: &str, folder: &Path) -> io::Result<Written> {
    write(own_files(solved, stem), folder)
}

fn write(files: Vec<OutFile>, folder: &Path) -> io::Result<Written> {
    let door = Door::within(folder);
    let mut paths = Vec::with_capacity(files.len());
    for file in files {
        let path = folder.join(&file.path);
        // A scene may be built beside its own program, which stays as it is.
        if door.read(&path).ok().as_deref() != Some(file.bytes.as_slice()) {
            door.write(&path, &file.bytes)?;
        }
        paths.push(path);
    }
    Ok(Written { paths })
}

fn build(solved: &Solved, program: &Program, stem: &str) -> Result<Scene, ExportError> {
    let failed = |e: &dyn std::fmt::Display| ExportError::Format("scene", e.to_string());
    let report = serde_json::to_value(&solved.first.checked.report).map_err(|e| failed(&e))?;
    let files: Vec<_> = solved.compiled.sources.iter().map(|(id, _)| id).collect();
    Scene::build(&SceneInput {
        name: stem,
        program,
        sources: &solved.compiled.sources,
        files: &files,
        layout: solved.first.layout(),
        layout_text: &solved.first.text,
        report: &report,
    })
    .map_err(|e| failed(&e))
}

/// The program, its imports, the layout and the report.
fn own_files(solved: &Solved, stem: &str) -> Vec<OutFile> {
    let sources = &solved.compiled.sources;
    let main = sources.get(solved.compiled.main);
    let folder = main.path().parent().unwrap_or(Path::new(""));
    let mut out = vec![OutFile::new(format!("{stem}.scene"), main.text())];
    for (id, file) in sources.iter() {
        // An import from above the program's folder would land outside of ours; its text is embedded in the scene.
        if id != solved.compiled.main
            && let Ok(relative) = file.path().strip_prefix(folder)
            && relative.components().all(|part| matches!(part, Component::Normal(_)))
        {
            out.push(OutFile::new(relative, file.text()));
        }
    }
    out.push(OutFile::new(format!("{stem}.layout.json"), solved.first.text.as_str()));
    let mut report = serde_json::to_string_pretty(&solved.first.checked.report).unwrap_or_default();
    report.push('\n');
    out.push(OutFile::new("report.json", report));
    out
}
