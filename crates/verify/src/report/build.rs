//! From a judgement to a [`Report`]: offsets become lines and columns, numbers become names.

use super::exit_code;
use super::model::{
    self, Design, FORMAT, Finding, FurtherMove, Move, Related, Remedy, Replacement, Report, Row, SourceSpan, Tally,
    Whereabouts,
};
use crate::check::{CheckVerdict, Judged, Subject};
use crate::explain::{self, Explanation, RowRef};
use crate::tolerances::Options;
use scenelang_base::{Applicability, Diagnostic, LineColumn, SourceMap, Span};
use scenelang_lang::program::{ObjectId, Program, Unit};
use smol_str::SmolStr;
use std::path::Path;

/// The report of a judgement of the file called `name`. `program` is the one whose rows these are.
pub fn build(
    name: &str,
    verdict: &CheckVerdict,
    program: Option<&Program>,
    sources: &SourceMap,
    options: &Options,
) -> Report {
    let builder = Builder { name, program, sources, parts: &verdict.parts };
    let mut report = Report {
        format: FORMAT.to_owned(),
        file: name.to_owned(),
        ok: false,
        summary: verdict.summary,
        design: design(verdict),
        constraints: verdict.rows.iter().map(|row| builder.row(row)).collect(),
        unlisted: verdict.unlisted,
        diagnostics: verdict.diagnostics.iter().map(|d| builder.finding(d)).collect(),
        fixed: Vec::new(),
        judged_with: None,
        permissions: Vec::new(),
        tolerances: options.tolerances,
        eta: options.eta,
    };
    report.ok = exit_code(&report) == 0;
    report
}

/// How much of what the guidelines ask holds. What cannot be judged does not.
fn design(verdict: &CheckVerdict) -> Option<Design> {
    let mut guidelines = Tally::default();
    let (mut all, mut held) = (0.0, 0.0);
    for row in verdict.rows.iter().filter(|row| row.guideline.is_some()) {
        let weight = row.weight.unwrap_or(1.0);
        guidelines.add(row.satisfied);
        all += weight;
        held += if row.satisfied == Some(true) { weight } else { 0.0 };
    }
    (all > 0.0).then(|| Design { figure: held / all, guidelines })
}

/// As written in the report.
fn unit(unit: Unit) -> String {
    if unit == Unit::Degree { "deg" } else { "m" }.to_owned()
}

/// A place as reports have it: lines and columns.
pub fn place(sources: &SourceMap, span: Span) -> SourceSpan {
    let (start, end) = sources.lines(span);
    let pair = |at: LineColumn| [at.line, at.column];
    SourceSpan { file: sources.get(span.file).name().to_owned(), start: pair(start), end: pair(end) }
}

/// The id of the statement at `span`, `room.scene:12:1`: its file seen from the folder of the file called `name`.
pub fn statement_id(name: &str, sources: &SourceMap, span: Span) -> String {
    let folder = Path::new(name).parent().unwrap_or(Path::new(""));
    let SourceSpan { file, start, .. } = place(sources, span);
    let file = Path::new(&file).strip_prefix(folder).map_or(file.clone(), |p| p.display().to_string());
    format!("{file}:{}:{}", start[0], start[1])
}

/// The id of a rule about a movable part: `P-OPEN:fridge/door`; `parts` are the names of those that there are.
pub fn part_id(rule: &str, object: &str, (id, part): (ObjectId, u8), parts: &[(ObjectId, u8, SmolStr)]) -> String {
    let name =
        parts.iter().find(|(owner, index, _)| (*owner, *index) == (id, part)).map_or("", |(.., name)| name.as_str());
    format!("{rule}:{object}/{name}")
}

struct Builder<'a> {
    name: &'a str,
    program: Option<&'a Program>,
    sources: &'a SourceMap,
    parts: &'a [(ObjectId, u8, SmolStr)],
}

impl Builder<'_> {
    fn row(&self, row: &Judged) -> Row {
        Row {
            id: self.id(row.row()),
            kind: row.kind,
            rule: row.kind.rule().map(str::to_owned),
            code: (row.satisfied == Some(false)).then(|| row.code.as_str().to_owned()),
            satisfied: row.satisfied,
            margin: row.margin.map(|(margin, _)| margin + 0.0),
            unit: row.margin.map(|(_, u)| unit(u)),
            objects: row.objects.iter().map(|id| self.object(*id).to_owned()).collect(),
            text: row.text.clone(),
            message: row.message(),
            span: Some(self.place(row.place)),
            weight: row.weight,
            requirements: row.requirements.clone(),
            guideline: row.guideline.as_ref().map(|name| name.to_string()),
            explanation: row.explanation.as_deref().map(|e| self.explanation(e)),
        }
    }

    fn explanation(&self, from: &Explanation) -> model::Explanation {
        let ids = |rows: &[RowRef]| rows.iter().map(|row| self.id(*row)).collect();
        let finite = |q: &explain::Quantity| match *q {
            explain::Quantity::Number(n) => n.is_finite().then_some(model::Quantity::Number(n)),
            explain::Quantity::Triple(t) => Some(model::Quantity::Triple(t)),
        };
        model::Explanation {
            measured: from.measured.as_ref().map(|m| model::Measured {
                left: finite(&m.left),
                right: finite(&m.right),
                unit: unit(m.unit),
            }),
            objects: from.objects.iter().map(|place| self.whereabouts(place)).collect(),
            opposing: ids(&from.opposing),
            repair: from.repair.as_ref().and_then(|repair| self.repair(repair)),
            choices: from.choices.iter().filter_map(|choice| self.repair(choice)).collect(),
            pinned: ids(&from.pinned),
        }
    }

    fn whereabouts(&self, place: &explain::ObjectPlace) -> Whereabouts {
        let explain::ObjectPlace { object, pos, rot, size, text } = place;
        Whereabouts { name: self.object(*object).to_owned(), pos: *pos, rot: *rot, size: *size, text: text.clone() }
    }

    fn repair(&self, repair: &explain::SmallestMove) -> Option<Move> {
        let name = |id: ObjectId| self.object(id).to_owned();
        let (first, rest) = repair.steps.split_first()?;
        let also = rest.iter().map(|s| FurtherMove { object: name(s.object), by: s.by, turn: s.turn });
        let ids = |rows: &[RowRef]| rows.iter().map(|row| self.id(*row)).collect();
        Some(Move {
            object: name(first.object),
            by: first.by,
            turn: first.turn,
            also: also.collect(),
            breaks: ids(&repair.breaks),
            repairs: ids(&repair.repairs),
            text: explain::move_in_words(self.program?, repair),
        })
    }

    fn id(&self, row: RowRef) -> String {
        let rule = row.kind.rule().unwrap_or_default();
        match row.subject {
            Subject::Pair(a, b) => format!("{rule}:{}:{}", self.object(a), self.object(b)),
            Subject::Object(a) => format!("{rule}:{}", self.object(a)),
            Subject::Part(a, part) => part_id(rule, self.object(a), (a, part), self.parts),
            Subject::Statement(index) => {
                let Some(stated) = self.program.and_then(|p| p.constraints.get(index)) else { return String::new() };
                let id = statement_id(self.name, self.sources, stated.span);
                // A guideline has a row for each thing that it speaks of.
                match stated.guideline.as_ref().and_then(|guideline| guideline.of) {
                    Some(of) => format!("{id}:{}", self.object(of)),
                    None => id,
                }
            }
        }
    }

    fn object(&self, id: ObjectId) -> &str {
        self.program.and_then(|p| p.objects.get(id.0 as usize)).map_or("", |object| object.name.as_str())
    }

    fn place(&self, span: Span) -> SourceSpan {
        place(self.sources, span)
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
