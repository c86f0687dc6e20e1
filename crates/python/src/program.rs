//! A program, and what is said of it and its layouts.

use crate::errors::{refused, sentence};
use crate::work::away;
use pyo3::prelude::*;
use scenelang_analysis::permissions::measured;
use scenelang_analysis::{FileSettings, Judging, Question};
use scenelang_base::door::{Door, MARK};
use scenelang_base::{Diagnostic, FileId};
use scenelang_engine::{check_file_with, check_layout_of};
use scenelang_export::{Scene, SceneInput, plan};
use scenelang_lang::program::ConstraintKind;
use scenelang_lang::sources::{Loader, decode};
use scenelang_lang::{Compiled, compile_main};
use scenelang_verify::report::{self, statement_id};
use scenelang_verify::settings::Settings;
use scenelang_verify::{Checked, Detail, Options};
use serde_json::json;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A program that compiles. Its own text stays what it was; what it imports is read again where that is needed.
#[pyclass(frozen, module = "scenelang._native")]
pub struct Program {
    pub held: Arc<Held>,
}

/// What a program is made of.
pub struct Held {
    /// What it is called in messages.
    pub name: String,
    /// Where it is, or would be.
    pub path: PathBuf,
    pub text: String,
    /// What came of it; it has a program.
    pub compiled: Compiled,
}

/// The files of a program: its own text as it was, everything else from disk.
pub struct Files<'a> {
    pub door: Door,
    path: &'a Path,
    text: &'a str,
}

impl Loader for Files<'_> {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        if path == self.path { Ok(self.text.as_bytes().to_vec()) } else { self.door.load(path) }
    }
}

impl Held {
    /// What it states.
    pub fn program(&self) -> &scenelang_lang::Program {
        self.compiled.program.as_ref().expect("what does not compile was refused")
    }

    /// Where its files come from.
    pub fn files(&self) -> Files<'_> {
        Files { door: Door::of(&self.path), path: &self.path, text: &self.text }
    }

    /// The settings that count for it.
    fn settings(&self, files: &Files<'_>) -> FileSettings {
        let here = std::env::current_dir().unwrap_or_default();
        FileSettings::of(&files.door, files, |path| path.strip_prefix(&here).unwrap_or(path).display().to_string())
    }

    /// How layouts of it are judged.
    ///
    /// # Errors
    /// The settings have errors.
    pub fn judging(&self) -> PyResult<Judging> {
        let found = self.settings(&self.files());
        if found.is_broken() {
            return Err(refused(MARK, found.sources, found.diagnostics));
        }
        Ok(found.judging(&Settings::default()))
    }

    /// What `scenelang check` says of a layout, or of the program by itself.
    pub fn check(&self, layout: Option<(&str, &str)>) -> Checked {
        let files = self.files();
        let detail = Detail { sentences: true, bars: true, ..Detail::default() };
        let (compile, given) = (scenelang_lang::Options::default(), Settings::default());
        let (name, path) = (self.name.as_str(), self.path.as_path());
        let question = |name| Question { name, path, given: &given, detail, compile };
        let found = self.settings(&files);
        let mut checked = match layout {
            None => question(name).judge_by(&found, |options| check_file_with(name, path, options, compile, &files)),
            Some((called, text)) => question(called).judge_by(&found, |options| {
                check_layout_of(called, text.to_owned(), (name, path), options, compile, &files)
            }),
        };
        checked.report.permissions = measured(&checked);
        checked
    }

    /// The same, of a layout that is to be changed or drawn.
    ///
    /// # Errors
    /// It cannot be judged as a whole.
    pub fn judged(&self, layout: (&str, &str)) -> PyResult<Checked> {
        let checked = self.check(Some(layout));
        let errors: Vec<Diagnostic> = checked.verdict.diagnostics.iter().filter(|d| d.is_error()).cloned().collect();
        if errors.is_empty() && checked.program.is_some() && checked.layout.is_some() {
            return Ok(checked);
        }
        Err(refused(layout.0, checked.sources, errors))
    }
}

#[pymethods]
impl Program {
    /// Compiles a text, or the file at `path` where there is none.
    #[new]
    fn new(py: Python<'_>, name: String, path: PathBuf, text: Option<String>) -> PyResult<Self> {
        // Whoever changes the folder later on means the same file.
        let path = std::path::absolute(&path)?;
        let held = py.detach(|| {
            let bytes = match text {
                Some(text) => text.into_bytes(),
                None => Door::of(&path)
                    .load(&path)
                    .map_err(|e| sentence(format!("cannot read {name}: {}", scenelang_lang::sources::plain(&e))))?,
            };
            let mut sources = scenelang_base::SourceMap::new();
            let main =
                decode(&name, &path, bytes, &mut sources).map_err(|no| refused(&name, sources.clone(), vec![no.1]))?;
            let text = sources.get(main).text().to_owned();
            let compiled = compile_main(main, scenelang_lang::Options::default(), &Door::of(&path), sources);
            if compiled.program.is_none() {
                return Err(refused(&name, compiled.sources, compiled.diagnostics));
            }
            Ok(Held { name, path, text, compiled })
        })?;
        Ok(Self { held: Arc::new(held) })
    }

    /// What it is called in messages.
    #[getter]
    fn name(&self) -> &str {
        &self.held.name
    }

    /// Where it is, or would be.
    #[getter]
    fn path(&self) -> &Path {
        &self.held.path
    }

    /// Its text.
    #[getter]
    fn text(&self) -> &str {
        &self.held.text
    }

    /// Names of the objects.
    #[getter]
    fn objects(&self) -> Vec<&str> {
        self.held.program().objects.iter().map(|object| object.name.as_str()).collect()
    }

    /// Names of the regions.
    #[getter]
    fn regions(&self) -> Vec<&str> {
        self.held.program().regions.iter().map(|region| region.name.as_str()).collect()
    }

    /// What it states, in the order of the columns of margins, as JSON.
    fn constraints(&self) -> String {
        let Held { name, compiled, .. } = &*self.held;
        let rows = self.held.program().constraints.iter().map(|constraint| {
            let (kind, weight) = match constraint.kind {
                ConstraintKind::Assert => ("assert", None),
                ConstraintKind::Prefer { weight } => ("prefer", Some(weight)),
                ConstraintKind::Pin => ("pin", None),
            };
            json!({
                "id": statement_id(name, &compiled.sources, constraint.span),
                "kind": kind,
                "text": constraint.text,
                "weight": weight,
                "requirements": constraint.requirements,
            })
        });
        json!(rows.collect::<Vec<_>>()).to_string()
    }

    /// The findings about it, as JSON.
    fn findings(&self, py: Python<'_>) -> PyResult<String> {
        let checked = away(py, |_| {
            let (sources, diagnostics) = (self.held.compiled.sources.clone(), self.held.compiled.diagnostics.clone());
            Checked::refused(&self.held.name, sources, diagnostics, &Options::default())
        })?;
        Ok(json!(checked.report.diagnostics).to_string())
    }

    /// The report on a layout (its name and its text), or on the program by itself, as JSON.
    #[pyo3(signature = (layout=None))]
    fn check(&self, py: Python<'_>, layout: Option<(String, String)>) -> PyResult<String> {
        away(py, |_| {
            let checked = self.held.check(layout.as_ref().map(|(name, text)| (name.as_str(), text.as_str())));
            report::json(&checked.report)
        })
    }

    /// The plan of a layout as SVG.
    fn plan(&self, py: Python<'_>, name: &str, text: &str) -> PyResult<String> {
        away(py, |_| {
            let checked = self.held.judged((name, text))?;
            let (Some(program), Some(layout)) = (&checked.program, &checked.layout) else {
                return Err(sentence(format!("{name} cannot be checked")));
            };
            let report = serde_json::to_value(&checked.report).map_err(|e| sentence(e.to_string()))?;
            let sources = &checked.sources;
            let files: Vec<FileId> = sources.iter().filter(|(_, file)| file.name() != name).map(|(id, _)| id).collect();
            let stem = Path::new(&self.held.name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let input =
                SceneInput { name: &stem, program, sources, files: &files, layout, layout_text: text, report: &report };
            Ok(plan::svg(&Scene::build(&input).map_err(|e| sentence(format!("{name} cannot be rendered: {e}")))?))
        })?
    }
}
