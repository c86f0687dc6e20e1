//! A program with a layout as editors show it: what holds, the room for the viewer, the plan.

use crate::commands::count;
use crate::convert::Places;
use crate::dispatch::Fault;
use scenelang_base::{FileId, SourceMap};
use scenelang_export::scene::Memory;
use scenelang_export::{Scene, SceneInput, plan, preview};
use scenelang_lang::program::Program;
use scenelang_layout::Layout;
use scenelang_verify::{CheckVerdict, Options, report};
use serde::Serialize;
use serde_json::Value;
use std::path::Path;
use tower_lsp::ls_types::{Range, Uri};

/// What `scenelang/provisional` answers, and a part of what `scenelang/scene` does.
#[derive(Default, Serialize)]
pub struct Shown {
    /// How many constraints hold, of how many.
    holds: usize,
    total: usize,
    /// The room as the viewer takes it (`scenelang_export::preview::live`); null: a part of it cannot be drawn, or there is
    /// no layout.
    data: Value,
    constraints: Vec<Row>,
}

/// A constraint, and whether it holds.
#[derive(Serialize)]
struct Row {
    /// What it is called in reports.
    id: String,
    /// The statement as written, or the rule in words.
    text: String,
    /// Of the statement; lines from 0.
    line: u32,
    uri: Option<Uri>,
    range: Range,
    state: Standing,
    margin: Option<f64>,
    unit: Option<String>,
    /// The objects of the instance that decided.
    objects: Vec<String>,
}

#[derive(Serialize)]
#[serde(rename_all = "lowercase")]
enum Standing {
    Holds,
    Fails,
    Unknown,
}

/// What a picture is made of.
pub struct Picture<'a> {
    /// The file of the program.
    pub path: &'a Path,
    pub program: &'a Program,
    /// Its files, and that of its layout.
    pub sources: &'a SourceMap,
    /// What the report is about: the file of the layout, or of the program where there is none.
    pub about: FileId,
    /// The file of the layout, if it has one.
    pub layout_file: Option<FileId>,
    /// Where everything is.
    pub layout: &'a Layout,
    /// The layout as a file.
    pub text: &'a str,
    /// What holds.
    pub verdict: &'a CheckVerdict,
    /// How that was judged.
    pub options: &'a Options,
    /// What its objects look like, as far as that is known.
    pub looks: &'a Memory,
}

impl Picture<'_> {
    /// Rows and room; the room is null if a part of it cannot be drawn. `known`: the shape that the client has.
    ///
    /// # Errors
    /// A mistake of ours.
    pub fn shown(&self, places: &Places<'_>, known: Option<&str>) -> Result<Shown, Fault> {
        let name = self.sources.get(self.about).name();
        let report = report::build(name, self.verdict, Some(self.program), self.sources, self.options);
        let rows = self.verdict.rows.iter().zip(&report.constraints).map(|(row, listed)| {
            let state = match row.satisfied {
                Some(true) => Standing::Holds,
                Some(false) => Standing::Fails,
                None => Standing::Unknown,
            };
            let range = places.range(row.place);
            Row {
                id: listed.id.clone(),
                text: listed.text.clone(),
                line: range.start.line,
                uri: places.uri(row.place.file),
                range,
                state,
                margin: listed.margin,
                unit: listed.unit.clone(),
                objects: listed.objects.clone(),
            }
        });
        let constraints = rows.collect();
        let report = serde_json::to_value(&report).map_err(|_| Fault::Internal)?;
        let data = self.scene(&report).and_then(|scene| preview::live(scene, known, true).ok());
        let [holds, total] = count(self.verdict);
        Ok(Shown { holds, total, data: data.unwrap_or_default(), constraints })
    }

    /// The plan (SVG); `None`: it cannot be drawn.
    ///
    /// # Errors
    /// A mistake of ours.
    pub fn plan(&self) -> Result<Option<String>, Fault> {
        let name = self.sources.get(self.about).name();
        let report = report::build(name, self.verdict, Some(self.program), self.sources, self.options);
        let report = serde_json::to_value(&report).map_err(|_| Fault::Internal)?;
        Ok(self.scene(&report).map(|scene| plan::svg(&scene)))
    }

    fn scene(&self, report: &Value) -> Option<Scene> {
        let stem = self.path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let files: Vec<FileId> =
            self.sources.iter().map(|(id, _)| id).filter(|id| Some(*id) != self.layout_file).collect();
        let input = SceneInput {
            name: &stem,
            program: self.program,
            sources: self.sources,
            files: &files,
            layout: self.layout,
            layout_text: self.text,
            report,
        };
        Scene::remembered(&input, self.looks).ok()
    }
}
