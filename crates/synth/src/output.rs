//! Stage IV: what is to be written. Who writes it decides where, and what it may replace.

use crate::corridor::Solved;
use crate::furnish::Chosen;
use crate::manifest::manifest;
use scenelang_export::{ExportError, OutFile, Scene, SceneInput};
use scenelang_lang::Compiled;
use scenelang_lang::program::Program;
use std::path::{Component, Path};

/// A scene as exporters want it.
///
/// # Errors
/// Something is not placed, or a floor is no polygon.
pub fn scene(solved: &Solved, stem: &str) -> Result<Scene, ExportError> {
    let Some(program) = &solved.compiled.program else {
        return Err(ExportError::Format("scene", "the program did not compile".into()));
    };
    build(solved, program, stem)
}

fn build(solved: &Solved, program: &Program, stem: &str) -> Result<Scene, ExportError> {
    let failed = |e: &dyn std::fmt::Display| ExportError::Format("scene", e.to_string());
    let report = serde_json::to_value(&solved.first.checked.report).map_err(|e| failed(&e))?;
    let files: Vec<_> = solved.compiled.sources.iter().map(|(id, _)| id).collect();
    let own = |name: &str| {
        let chosen = solved.furniture.iter().find(|chosen| chosen.object == name && chosen.is_own());
        chosen.map(|chosen| &chosen.choice.given.piece.mesh)
    };
    let input = SceneInput {
        name: stem,
        program,
        sources: &solved.compiled.sources,
        files: &files,
        layout: solved.first.layout(),
        layout_text: &solved.first.text,
        report: &report,
    };
    Scene::dressed(&input, &own).map_err(|e| failed(&e))
}

/// What is there without the exporters: the program, its imports, the layout and the report.
pub fn own_files(solved: &Solved, stem: &str) -> Vec<OutFile> {
    let mut out = program_files(&solved.compiled, stem);
    out.push(OutFile::new(format!("{stem}.layout.json"), solved.first.text.as_str()));
    let mut report = serde_json::to_string_pretty(&solved.first.checked.report).unwrap_or_default();
    report.push('\n');
    out.push(OutFile::new("report.json", report));
    out.extend(furniture_file(&solved.furniture));
    out
}

/// A program and its imports.
pub fn program_files(compiled: &Compiled, stem: &str) -> Vec<OutFile> {
    let main = compiled.sources.get(compiled.main);
    let folder = main.path().parent().unwrap_or(Path::new(""));
    let mut out = vec![OutFile::new(format!("{stem}.scene"), main.text())];
    for (id, file) in compiled.sources.iter() {
        // An import from above the program's folder would land outside of ours; its text is embedded in the scene.
        if id != compiled.main
            && let Ok(relative) = file.path().strip_prefix(folder)
            && relative.components().all(|part| matches!(part, Component::Normal(_)))
        {
            out.push(OutFile::new(relative, file.text()));
        }
    }
    out
}

/// Who gave each object what; `None`: only the library was asked.
pub fn furniture_file(furniture: &[Chosen]) -> Option<OutFile> {
    let text = || serde_json::to_string_pretty(&manifest(furniture)).unwrap_or_default();
    (!furniture.is_empty()).then(|| OutFile::new("furniture.json", text() + "\n"))
}
