//! What is said of repairs, and which rows they are to repair; the command and the server for assistants say the same.

use crate::args::Repair;
use scenelang_base::Edit;
use scenelang_lang::Program;
use scenelang_lang::program::ObjectId;
use scenelang_solve::repair::{Alternative, How, Moved};
use scenelang_verify::Checked;
use scenelang_verify::check::Subject;
use scenelang_verify::explain::{RowRef, SmallestMove, Step, move_in_words};
use scenelang_verify::report::{self, model::Place};
use serde_json::{Value, json};

/// The rows that `--constraint` means.
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
        (true, Some(line)) => Err(format!("there is no constraint in line {line} of {main}")),
        (true, None) => Err(format!("there is no constraint `{asked}`")),
    }
}

/// What is said of alternatives.
pub struct Told<'a> {
    pub checked: &'a Checked,
    pub program: &'a Program,
    pub name: &'a str,
}

impl Told<'_> {
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
    pub fn json(&self, failing: &[RowRef], all: &[Alternative], applied: Option<usize>, written: &[String]) -> Value {
        let failing = self.failing(failing).into_iter();
        let mut out = json!({
            "format": "scenelang.repair/1",
            "file": self.name,
            "failing": failing.map(|(id, kind, text)| json!({ "id": id, "kind": kind, "text": text })).collect::<Vec<_>>(),
            "alternatives": all.iter().map(|a| self.alternative(a)).collect::<Vec<_>>(),
            "applied": applied,
            "written": written,
        });
        if let Some(with) = &self.checked.report.judged_with {
            out["judged_with"] = json!(with);
        }
        out
    }

    fn alternative(&self, a: &Alternative) -> Value {
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

    /// The answer for people.
    pub fn text(
        &self,
        failing: &[RowRef],
        all: &[Alternative],
        choice: Option<usize>,
        args: &Repair,
        written: &[String],
    ) -> String {
        let with = self.checked.report.judged_with.as_ref().map_or(String::new(), |with| with.in_words() + "\n");
        if failing.is_empty() {
            return format!("{}: nothing to repair\n{with}", self.name);
        }
        let mut out = String::new();
        for (id, _, text) in self.failing(failing) {
            out += &format!("{id} fails: {}\n", text.split_whitespace().collect::<Vec<_>>().join(" "));
        }
        for (i, a) in all.iter().enumerate() {
            out += &format!("{:3}  {}\n", i + 1, self.words(a));
        }
        out + &match (choice, all.is_empty()) {
            (_, true) => "no repair was found, which is not a proof that none exists\n".to_owned(),
            (None, false) => "nothing was written; use --apply N to apply one of these repairs\n".to_owned(),
            (Some(i), _) if args.dry_run => format!("repair {} would be applied; nothing was written\n", i + 1),
            (Some(i), _) => format!("{} is made: {} written\n", i + 1, written.join(", ")),
        } + &with
    }

    /// An alternative in the imperative.
    pub fn words(&self, a: &Alternative) -> String {
        let mut parts = Vec::new();
        let steps: Vec<Step> = a.moves.iter().map(Moved::step).collect();
        if !steps.is_empty() {
            parts.push(move_in_words(self.program, &SmallestMove { steps, breaks: Vec::new(), repairs: Vec::new() }));
        }
        if !a.also.is_empty() {
            parts.push(format!("change `{}`", a.also.join("`, `")));
        }
        parts.extend(a.edits.iter().enumerate().map(|(i, edit)| self.edit(a, i, edit)));
        parts.extend(
            a.drops.iter().map(|i| {
                format!("give up the preference {} `{}`", self.statement(*i), self.program.constraints[*i].text)
            }),
        );
        parts.join("; ")
    }

    fn edit(&self, a: &Alternative, i: usize, edit: &Edit) -> String {
        let Place { file, start: [line, column], .. } = report::place(&self.checked.sources, edit.place);
        let old = self.checked.sources.text(edit.place);
        let change = format!("{file}:{line}:{column}: {old} → {}", edit.text);
        match (a.how, a.least.get(i)) {
            (How::Prefer, _) => format!("make it a preference: {change}"),
            (_, Some(least)) => format!("change a number: {change} (by at least {})", short(*least)),
            _ => change,
        }
    }
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
