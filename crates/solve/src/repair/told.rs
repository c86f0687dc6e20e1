//! What is said of repairs, and which rows they are to repair: the command, the server for assistants and the Python module
//! say the same.

use super::{Alternative, How, Moved, Repaired};
use scenelang_base::{Edit, SourceMap, Span};
use scenelang_lang::Program;
use scenelang_lang::program::{Constraint, ConstraintKind, ObjectId};
use scenelang_verify::Checked;
use scenelang_verify::check::Subject;
use scenelang_verify::explain::{ObjectMove, RowRef, SmallestMove, move_in_words};
use scenelang_verify::prove::Contradiction;
use scenelang_verify::report::{self, model::SourceSpan};
use serde_json::{Value, json};

/// The rows that are meant by an id, or by a line of the program `main`.
///
/// # Errors
/// There is none.
pub fn rows(checked: &Checked, main: &str, asked: &str) -> Result<Vec<RowRef>, String> {
    let line: Option<u32> = asked.parse().ok();
    let judged = checked.verdict.rows.iter().zip(&checked.report.constraints);
    let meant = judged.filter(|(row, listed)| match line {
        None => listed.id == asked,
        Some(line) => {
            let (start, end) = checked.sources.lines(row.place);
            matches!(row.subject, Subject::Statement(_))
                && checked.sources.get(row.place.file).name() == main
                && (start.line..=end.line).contains(&line)
        }
    });
    let meant: Vec<RowRef> = meant.map(|(row, _)| RowRef { kind: row.kind, subject: row.subject }).collect();
    match (meant.is_empty(), line) {
        (false, _) => Ok(meant),
        // Of physical rules only those are listed that fail.
        (true, None) if asked.starts_with("P-") => Ok(meant),
        (true, Some(line)) => Err(format!("there is no constraint on line {line} of {main}")),
        (true, None) => Err(format!("there is no constraint `{asked}`")),
    }
}

/// What is said of alternatives.
#[derive(Clone, Copy, Debug)]
pub struct AlternativesReport<'a> {
    /// The layout, judged.
    pub checked: &'a Checked,
    pub program: &'a Program,
    /// What its file is called.
    pub name: &'a str,
}

impl AlternativesReport<'_> {
    fn object(&self, id: ObjectId) -> &str {
        &self.program.objects[id.0 as usize].name
    }

    fn statement(&self, index: usize) -> String {
        report::statement_id(self.name, &self.checked.sources, self.program.constraints[index].span)
    }

    /// What fails: id, kind and text.
    pub fn failing(&self, rows: &[RowRef]) -> Vec<(String, &'static str, String)> {
        let judged = self.checked.verdict.rows.iter().zip(&self.checked.report.constraints);
        let asked =
            |row: &scenelang_verify::check::Judged| rows.contains(&RowRef { kind: row.kind, subject: row.subject });
        judged
            .filter(|(row, _)| asked(row))
            .map(|(row, l)| (l.id.clone(), row.kind.as_str(), row.text.clone()))
            .collect()
    }

    /// The answer as JSON.
    pub fn json(&self, found: &Repaired, applied: Option<usize>, written: &[String]) -> Value {
        let failing = self.failing(&found.failing).into_iter();
        let all = &found.alternatives;
        let member = |(id, text)| json!({ "id": id, "text": text });
        let members = |c| self.members(c).into_iter().map(member).collect::<Vec<_>>();
        let contradiction = found.contradiction.as_ref().map(members);
        let mut out = json!({
            "format": "scenelang.repair/1",
            "file": self.name,
            "failing": failing.map(|(id, kind, text)| json!({ "id": id, "kind": kind, "text": text })).collect::<Vec<_>>(),
            "contradiction": contradiction,
            "alternatives": all.iter().map(|a| self.alternative(a)).collect::<Vec<_>>(),
            "applied": applied,
            "written": written,
        });
        if let Some(with) = &self.checked.report.judged_with {
            out["judged_with"] = json!(with);
        }
        out
    }

    /// One of them as JSON.
    pub fn alternative(&self, a: &Alternative) -> Value {
        let moves = a.moves.iter().map(|m| {
            let step = m.step();
            let [pos, rot] = [m.to.pos, m.to.rot].map(<[f64; 3]>::from);
            json!({ "object": self.object(m.object), "by": step.by, "turn": step.turn, "pos": pos, "rot": rot })
        });
        let edits = a.edits.iter().enumerate().map(|(i, edit)| {
            let mut out = json!({
                "span": report::place(&self.checked.sources, edit.place),
                "old": self.checked.sources.text(edit.place),
                "text": edit.text,
            });
            if let Some(least) = a.least.get(i) {
                out["least"] = short(*least).into();
            }
            out
        });
        json!({
            "how": how(a),
            "cost": rounded(a.cost),
            "text": self.words(a),
            "moves": moves.collect::<Vec<_>>(),
            "also": a.also,
            "edits": edits.collect::<Vec<_>>(),
            "drops": a.drops.iter().map(|i| self.statement(*i)).collect::<Vec<_>>(),
        })
    }

    /// An alternative in the imperative, with the places of its edits.
    pub fn words(&self, a: &Alternative) -> String {
        let sources = &self.checked.sources;
        let mut parts = layout_in_words(self.program, a);
        let place = |edit: &Edit| {
            let SourceSpan { file, start: [line, column], .. } = report::place(sources, edit.place);
            format!("{file}:{line}:{column}")
        };
        if a.how == How::Prefer {
            let places: Vec<String> = a.edits.iter().map(place).collect();
            parts.push(format!("{} ({})", demoted(a.edits.len()), places.join(", ")));
        } else {
            parts.extend(a.edits.iter().enumerate().map(|(i, edit)| {
                let least = a.least.get(i).map_or(String::new(), |least| needed(a.shown.get(i), *least));
                format!("{} ({}{least})", edit_in_words(self.program, sources, a, i), place(edit))
            }));
        }
        parts.extend(
            a.drops
                .iter()
                .map(|i| format!("drop the preference {} `{}`", self.statement(*i), self.program.constraints[*i].text)),
        );
        parts.join("; ")
    }

    /// The statements of a contradiction: id and text of each, in their order.
    pub fn members(&self, found: &Contradiction) -> Vec<(String, String)> {
        let text = |i: usize| self.program.constraints[i].text.split_whitespace().collect::<Vec<_>>().join(" ");
        found.statements.iter().map(|i| (self.statement(*i), text(*i))).collect()
    }
}

/// An alternative in the imperative, as an editor names it.
pub fn title(program: &Program, sources: &SourceMap, a: &Alternative) -> String {
    let mut parts = layout_in_words(program, a);
    if a.how == How::Prefer {
        parts.push(demoted(a.edits.len()));
    } else {
        parts.extend((0..a.edits.len()).map(|i| edit_in_words(program, sources, a, i)));
    }
    parts.extend(a.drops.iter().map(|i| format!("drop the preference `{}`", program.constraints[*i].text)));
    parts.join("; ")
}

/// What changes in the layout.
fn layout_in_words(program: &Program, a: &Alternative) -> Vec<String> {
    let mut parts = Vec::new();
    let is_moved = |step: &ObjectMove| step.by != [0.0; 3] || step.turn != 0.0;
    let resized = |m: &&Moved| m.from.scale != m.to.scale;
    let resizes = |object: ObjectId| a.moves.iter().any(|m| m.object == object && resized(&m));
    let steps = a.moves.iter().map(Moved::step).filter(|step| is_moved(step) || !resizes(step.object));
    let steps: Vec<ObjectMove> = steps.collect();
    if !steps.is_empty() {
        parts.push(move_in_words(program, &SmallestMove { steps, breaks: Vec::new(), repairs: Vec::new() }));
    }
    parts.extend(a.moves.iter().filter(resized).map(|m| {
        let [w, h, d] = [m.to.scale.x, m.to.scale.y, m.to.scale.z];
        format!("resize `{}` to {w:.2} × {h:.2} × {d:.2} m", program.objects[m.object.0 as usize].name)
    }));
    if !a.also.is_empty() {
        parts.push(format!("change `{}`", a.also.join("`, `")));
    }
    parts
}

/// How far a number must at least be changed: to which value, if it is shown in the unit of the change.
fn needed(shown: Option<&[String; 2]>, least: f64) -> String {
    let parts = shown.and_then(|[old, _]| old.split_once(' '));
    let old = parts.filter(|(_, unit)| *unit == "m").and_then(|(number, _)| number.parse::<f64>().ok());
    match old {
        Some(old) => {
            let bound = if least < 0.0 { "more" } else { "less" };
            format!("; {bound} than {} m would still fail", short(old + least))
        }
        None => format!(", by at least {}", short(least.abs())),
    }
}

/// What an edit of the text means.
fn edit_in_words(program: &Program, sources: &SourceMap, a: &Alternative, i: usize) -> String {
    let Edit { place, text } = &a.edits[i];
    match a.shown.get(i) {
        Some(shown) => number_in_words(program, *place, shown),
        None => format!("write `{text}` instead of `{}`", sources.text(*place)),
    }
}

/// An assertion that becomes a preference.
pub const PREFER: &str = "make the assertion a preference: `prefer` instead of `assert`";

/// The same of several.
fn demoted(count: usize) -> String {
    match count {
        0 | 1 => PREFER.to_owned(),
        n => format!("turn {n} assertions into preferences: `prefer` instead of `assert`"),
    }
}

/// Another number: "require 0.5 m instead of 0.4 m".
pub fn number_in_words(program: &Program, place: Span, [old, new]: &[String; 2]) -> String {
    let around = |c: &&Constraint| c.span.file == place.file && c.span.range.cover(place.range) == c.span.range;
    let verb = match program.constraints.iter().find(around).map(|c| &c.kind) {
        Some(ConstraintKind::Assert) => "require",
        Some(ConstraintKind::Prefer { .. }) => "prefer",
        _ => "write",
    };
    format!("{verb} {new} instead of {old}")
}

/// What changes, in a word.
pub fn how(a: &Alternative) -> &'static str {
    match a.how {
        How::Moves => "move",
        How::Numbers => "number",
        How::Drop => "drop",
        How::Prefer => "prefer",
    }
}

/// To four digits after the point: tolerances are of that size.
fn short(x: f64) -> f64 {
    (x * 1e4).round() / 1e4 + 0.0
}

/// To six digits after the point: the rest is noise.
pub fn rounded(x: f64) -> f64 {
    (x * 1e6).round() / 1e6 + 0.0
}
