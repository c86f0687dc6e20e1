//! Findings as exceptions of Python: the text that the command line prints, and the findings as data.

use pyo3::{PyErr, import_exception};
use scenelang_base::{Diagnostic, SourceMap};
use scenelang_verify::report::{self, model::Finding};
use scenelang_verify::{Checked, Options};

import_exception!(scenelang._errors, SceneError);
import_exception!(scenelang._errors, ContradictionError);

/// That something cannot be used, and why.
pub fn refused(name: &str, sources: SourceMap, diagnostics: Vec<Diagnostic>) -> PyErr {
    let said = report::diagnostics(&diagnostics, &sources, false);
    let checked = Checked::refused(name, sources, diagnostics, &Options::default());
    SceneError::new_err((said.trim_end().to_owned(), data(&checked.report.diagnostics)))
}

/// A sentence that no text of a scene is to blame for.
pub fn sentence(said: impl Into<String>) -> PyErr {
    SceneError::new_err((said.into(), data(&[])))
}

/// That it is proved that there is no layout.
pub fn contradiction(checked: &Checked) -> PyErr {
    let errors: Vec<_> = checked.verdict.diagnostics.iter().filter(|d| d.is_error()).cloned().collect();
    let said = report::diagnostics(&errors, &checked.sources, false);
    let said = format!("no layout satisfies all of these\n{}", said.trim_end());
    ContradictionError::new_err((said, data(&checked.report.diagnostics)))
}

fn data(findings: &[Finding]) -> String {
    serde_json::to_string(findings).expect("findings are made of strings, numbers and lists")
}
