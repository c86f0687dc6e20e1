//! Rows in short for who moves things and looks at nothing but what that changes.

use crate::Live;
use scenelang_base::SourceMap;
use scenelang_lang::program::{ObjectId, Program, Unit};
use scenelang_verify::check::{Judged, Subject, parts};
use scenelang_verify::report::{part_id, statement_id};
use serde_json::{Value, json};

/// What holds while something is moved, in short, as JSON: `holds` of `total`, the stated constraints, and the physical rules
/// that fail. `name` is what the report would be about.
pub fn moved(live: &Live<'_>, program: &Program, sources: &SourceMap, name: &str) -> Value {
    let object = |id: &ObjectId| program.objects.get(id.0 as usize).map_or("", |o| o.name.as_str());
    let id = |row: &Judged| match row.subject {
        Subject::Statement(_) => statement_id(name, sources, row.place),
        Subject::Pair(a, b) => format!("{}:{}:{}", row.kind.rule().unwrap_or_default(), object(&a), object(&b)),
        Subject::Object(a) => format!("{}:{}", row.kind.rule().unwrap_or_default(), object(&a)),
        Subject::Part(a, part) => {
            part_id(row.kind.rule().unwrap_or_default(), object(&a), (a, part), &parts(live.world()))
        }
    };
    let shown = |row: &Judged| {
        let state = match row.satisfied {
            Some(true) => "holds",
            Some(false) => "fails",
            None => "unknown",
        };
        let margin = row.margin.filter(|(m, _)| m.is_finite());
        let unit = margin.map(|(_, u)| if u == Unit::Degree { "deg" } else { "m" });
        let objects: Vec<&str> = row.objects.iter().map(object).collect();
        json!({
            "id": id(row), "state": state, "margin": margin.map(|(m, _)| m + 0.0), "unit": unit, "objects": objects,
        })
    };
    let (physical, stated): (Vec<&Judged>, Vec<&Judged>) = live.rows().partition(|row| row.kind.rule().is_some());
    let holds = live.rows().filter(|row| row.satisfied == Some(true)).count();
    json!({
        "holds": holds, "total": live.rows().count(),
        "constraints": stated.into_iter().map(shown).collect::<Vec<_>>(),
        "physical": physical.into_iter().map(shown).collect::<Vec<_>>(),
    })
}
