//! From a judgement to a [`Report`]: offsets become lines and columns, numbers become names.

use super::exit_code;
use super::model::{FORMAT, Finding, Kind, Place, Related, Remedy, Replacement, Report, Row};
use crate::check::{Judged, Subject, Verdict};
use crate::tolerances::Options;
use scenelang_base::{Applicability, Diagnostic, LineColumn, SourceMap, Span};
use scenelang_lang::program::{ObjectId, Program, Unit};
use std::path::Path;

/// The report of a judgement of the file called `name`. `program` is the one whose rows these are.
pub fn build(
    name: &str,
    verdict: &Verdict,
    program: Option<&Program>,
    sources: &SourceMap,
    options: &Options,
) -> Report {
    let builder = Builder { folder: Path::new(name).parent().unwrap_or(Path::new("")), program, sources };
    let mut report = Report {
        format: FORMAT.to_owned(),
        file: name.to_owned(),
        ok: false,
        summary: verdict.summary,
        constraints: verdict.rows.iter().map(|row| builder.row(row)).collect(),
        diagnostics: verdict.diagnostics.iter().map(|d| builder.finding(d)).collect(),
        tolerances: options.tolerances,
        eta: options.eta,
    };
    report.ok = exit_code(&report) == 0;
    report
}

/// The code of a violation.
pub(super) fn code(kind: Kind) -> &'static str {
    use scenelang_base::codes;
    match kind {
        Kind::Assert => codes::V0101,
        Kind::Collision => codes::V0102,
        Kind::Bounds => codes::V0103,
        Kind::Support => codes::V0104,
        Kind::Pin => codes::V0105,
        Kind::Prefer => codes::V0106,
    }
    .as_str()
}

/// A span as lines and columns.
pub(super) fn place(span: Span, sources: &SourceMap) -> Place {
    let (start, end) = sources.lines(span);
    let pair = |at: LineColumn| [at.line, at.column];
    Place { file: sources.get(span.file).name().to_owned(), start: pair(start), end: pair(end) }
}

struct Builder<'a> {
    folder: &'a Path,
    program: Option<&'a Program>,
    sources: &'a SourceMap,
}

impl Builder<'_> {
    fn row(&self, row: &Judged) -> Row {
        Row {
            id: self.id(row),
            kind: row.kind,
            rule: row.kind.rule().map(str::to_owned),
            code: (row.satisfied == Some(false)).then(|| code(row.kind).to_owned()),
            satisfied: row.satisfied,
            margin: row.margin.map(|(margin, _)| margin + 0.0),
            unit: row.margin.map(|(_, unit)| if unit == Unit::Degree { "deg" } else { "m" }.to_owned()),
            objects: row.objects.iter().map(|id| self.object(*id).to_owned()).collect(),
            text: row.text.clone(),
            message: row.message(),
            span: Some(self.place(row.place)),
            weight: row.weight,
            requirements: row.requirements.clone(),
        }
    }

    fn id(&self, row: &Judged) -> String {
        let rule = row.kind.rule().unwrap_or_default();
        match row.subject {
            Subject::Pair(a, b) => format!("{rule}:{}:{}", self.object(a), self.object(b)),
            Subject::Object(a) => format!("{rule}:{}", self.object(a)),
            Subject::Statement(_) => {
                let Place { file, start, .. } = self.place(row.place);
                let file = Path::new(&file).strip_prefix(self.folder).map_or(file.clone(), |p| p.display().to_string());
                format!("{file}:{}:{}", start[0], start[1])
            }
        }
    }

    fn object(&self, id: ObjectId) -> &str {
        self.program.and_then(|p| p.objects.get(id.0 as usize)).map_or("", |object| object.name.as_str())
    }

    fn place(&self, span: Span) -> Place {
        place(span, self.sources)
    }

    fn finding(&self, diagnostic: &Diagnostic) -> Finding {
        let related =
            diagnostic.related.iter().map(|l| Related { message: l.message.clone(), span: self.place(l.place) });
        let fixes = diagnostic.fixes.iter().map(|fix| Remedy {
            title: fix.title.clone(),
            applicability: match fix.applicability {
                Applicability::Safe => "safe",
                Applicability::Unsafe => "unsafe",
            }
            .to_owned(),
            edits: fix
                .edits
                .iter()
                .map(|edit| Replacement { span: self.place(edit.place), text: edit.text.clone() })
                .collect(),
        });
        Finding {
            code: diagnostic.code.as_str().to_owned(),
            severity: diagnostic.severity.as_str().to_owned(),
            message: diagnostic.message.clone(),
            span: diagnostic.primary.as_ref().map(|label| self.place(label.place)),
            related: related.collect(),
            notes: diagnostic.notes.clone(),
            fixes: fixes.collect(),
        }
    }
}
