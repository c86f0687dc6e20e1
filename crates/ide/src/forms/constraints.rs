//! `scenelang constraints`: what the statements of a program become, after everything is expanded.

use super::formula::Formulas;
use super::write::Json;
use scenelang_base::{FileId, SourceMap, Span};
use scenelang_lang::ast::Allow;
use scenelang_lang::print::Printed;
use scenelang_lang::program::{Allowances, ConstraintKind, MountedOn, ObjectId, Program};
use scenelang_verify::report;
use serde_json::{Value, json};
use std::fmt::Write;

/// The value of the member `format`.
const FORMAT: &str = "scenelang.constraints/1";

/// One line for each constraint.
pub fn text(program: &Program, sources: &SourceMap, main: FileId) -> String {
    View { sources, main, program }.text()
}

/// All as JSON.
pub fn json(program: &Program, sources: &SourceMap, main: FileId) -> String {
    View { sources, main, program }.json()
}

struct View<'a> {
    sources: &'a SourceMap,
    main: FileId,
    program: &'a Program,
}

impl View<'_> {
    fn text(&self) -> String {
        let sources = self.sources;
        let mut out = String::new();
        for c in &self.program.constraints {
            let kind = match c.kind {
                ConstraintKind::Assert => "assert".to_owned(),
                ConstraintKind::Prefer { weight } => format!("prefer (weight {weight})"),
                ConstraintKind::Pin => "pin".to_owned(),
            };
            let (start, _) = sources.lines(c.span);
            let file = sources.get(c.span.file).name();
            let formula = Printed(self.program, &c.formula);
            let _ = writeln!(out, "{file}:{}:{}: {kind} {formula}", start.line, start.column);
        }
        out
    }

    fn json(&self) -> String {
        let mut json = Json::default();
        json.open('{');
        json.member("format", FORMAT);
        json.member("file", self.sources.get(self.main).name());
        json.name("constraints");
        json.open('[');
        (0..self.program.constraints.len()).for_each(|i| self.constraint(i, &mut json));
        json.close(']');
        let allowances: Vec<Value> = self
            .program
            .allow
            .stated
            .iter()
            .map(|a| {
                let mut row = self.statement(allow_word(a.rule), a.span, &a.text, &a.requirements);
                row["objects"] = a.arguments.iter().map(|argument| self.objects(argument)).collect();
                row
            })
            .collect();
        json.member("allowances", allowances);
        json.member("lifted", self.lifted(&self.program.allow));
        json.close('}');
        json.finish()
    }

    /// What all statements have.
    fn statement(&self, kind: &str, span: Span, text: &str, requirements: &[String]) -> Value {
        let Self { sources, main, .. } = self;
        json!({
            "id": report::statement_id(sources.get(*main).name(), sources, span),
            "kind": kind,
            "span": report::place(sources, span),
            "requirements": requirements,
            "text": text,
        })
    }

    fn constraint(&self, index: usize, json: &mut Json) {
        let c = &self.program.constraints[index];
        let formulas = Formulas::new(self.program, &c.formula);
        let kind = match c.kind {
            ConstraintKind::Assert => "assert",
            ConstraintKind::Prefer { .. } => "prefer",
            ConstraintKind::Pin => "pin",
        };
        let mut row = self.statement(kind, c.span, &c.text, &c.requirements);
        if let ConstraintKind::Prefer { weight } = c.kind {
            row["weight"] = json!(weight);
        }
        row["names"] = formulas.names();
        row["expanded"] = json!(Printed(self.program, &c.formula).to_string());
        json.open('{');
        if let Value::Object(members) = row {
            members.into_iter().for_each(|(name, value)| json.member(&name, value));
        }
        json.name("formula");
        formulas.write(json);
        json.close('}');
    }

    fn object(&self, id: ObjectId) -> &str {
        &self.program.objects[id.0 as usize].name
    }

    fn objects(&self, ids: &[ObjectId]) -> Value {
        ids.iter().map(|id| self.object(*id)).collect()
    }

    /// What assertions at top level lift besides.
    fn lifted(&self, allow: &Allowances) -> Value {
        let region = |id: scenelang_lang::program::RegionId| self.program.regions[id.0 as usize].name.as_str();
        let contents: Vec<Value> = allow
            .contents
            .iter()
            .map(|(content, container)| json!({ "content": self.object(*content), "container": self.object(*container) }))
            .collect();
        let mounts: Vec<Value> = allow
            .mounts
            .iter()
            .map(|m| {
                let on = match m.on {
                    MountedOn::Wall => "wall",
                    MountedOn::Ceiling => "ceiling",
                };
                json!({ "object": self.object(m.object), "region": region(m.region), "on": on })
            })
            .collect();
        let doors: Vec<Value> = allow
            .doors
            .iter()
            .map(|d| {
                let regions: Vec<&str> = [Some(d.first), d.second].into_iter().flatten().map(region).collect();
                json!({ "object": self.object(d.object), "regions": regions })
            })
            .collect();
        json!({ "contents": contents, "mounts": mounts, "doors": doors })
    }
}

fn allow_word(rule: Allow) -> &'static str {
    match rule {
        Allow::Collide => "allowCollide",
        Allow::Outside => "allowOutside",
        Allow::Float => "allowFloat",
    }
}
