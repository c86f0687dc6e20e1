//! What an editor asks: the same as of the language server.

use crate::offsets::Offsets;
use crate::session::{Open, Refused, cancelled};
use scenelang_base::{Diagnostic, Label, codes};
use scenelang_ide::completion::{Proposal, Sort, complete};
use scenelang_ide::diagnostics::diagnostics;
use scenelang_ide::tokens::{TYPES, tokens};
use scenelang_ide::{Snapshot, format, hover as hovering};
use serde_json::{Value, json};

/// All that is to be marked, what each token is, and how the program stands.
pub fn marks(open: &Open) -> Result<Value, Refused> {
    let snapshot = open.host.snapshot();
    let offsets = Offsets::new(snapshot.text());
    let found = diagnostics(&snapshot).map_err(cancelled)?;
    let mut marks: Vec<Value> = Vec::new();
    for finding in &found {
        let mark = mark(&finding.diagnostic, &snapshot, &offsets);
        if !marks.contains(&mark) {
            marks.push(mark);
        }
    }
    let compiled = snapshot.compiled().map_err(cancelled)?;
    let judged = snapshot.judged().map_err(cancelled)?;
    let count = judged.map(|judged| {
        let rows = &judged.verdict.rows;
        let failing = rows.iter().filter(|row| row.satisfied != Some(true) && row.weight.is_none()).count();
        [rows.iter().filter(|row| row.satisfied == Some(true)).count(), rows.len(), failing]
    });
    let placed = snapshot.layout().is_some_and(|layout| {
        let (program, layout) = (&compiled.program, &layout.read.layout);
        program.objects.iter().all(|object| layout.object(&object.name).is_some())
            && program.regions.iter().all(|region| layout.region(&region.name).is_some())
            && layout.objects.iter().all(|(name, _)| program.objects.iter().any(|object| object.name == *name))
    });
    let colours: Vec<u32> = tokens(&snapshot, None)
        .map_err(cancelled)?
        .into_iter()
        .flat_map(|token| {
            let [from, to] = offsets.range(token.range);
            [from, to, token.ty as u32, token.modifiers]
        })
        .collect();
    Ok(json!({
        "marks": marks, "tokens": colours, "types": TYPES, "complete": compiled.complete,
        "objects": compiled.program.objects.len(), "placed": placed, "count": count,
    }))
}

/// A diagnostic as the language server words it. What is said of the layout, whose text is nowhere to be seen, has no range.
fn mark(diagnostic: &Diagnostic, snapshot: &Snapshot, offsets: &Offsets<'_>) -> Value {
    let here = |label: &&Label| label.place.file == snapshot.main();
    let mut message = diagnostic.message.clone();
    for note in &diagnostic.notes {
        message.push('\n');
        message.push_str(note);
    }
    let related = diagnostic.related.iter().filter(here).filter(|label| !label.message.is_empty());
    json!({
        "range": diagnostic.primary.as_ref().filter(here).map(|label| offsets.range(label.place.range)),
        "severity": diagnostic.severity.as_str(),
        "code": diagnostic.code.as_str(),
        "message": message,
        "unused": diagnostic.code == codes::W0201,
        "related": related.map(|label| json!({
            "range": offsets.range(label.place.range), "message": label.message,
        })).collect::<Vec<_>>(),
    })
}

/// What is proved of the program, as far as that has no errors.
pub fn proofs(open: &Open) -> Result<Value, Refused> {
    let snapshot = open.host.snapshot();
    let compiled = snapshot.compiled().map_err(cancelled)?;
    if !compiled.complete {
        return Ok(json!([]));
    }
    let offsets = Offsets::new(snapshot.text());
    let found = scenelang_analysis::proofs(&compiled.program, snapshot.sources(), snapshot.judging());
    let here = |d: &&Diagnostic| d.primary.as_ref().is_some_and(|label| label.place.file == snapshot.main());
    Ok(found.iter().filter(here).map(|d| mark(d, &snapshot, &offsets)).collect())
}

/// What could be written.
pub fn completion(open: &Open, at: u32, asked: bool) -> Result<Value, Refused> {
    let snapshot = open.host.snapshot();
    let offsets = Offsets::new(snapshot.text());
    // There are no other files that could be imported.
    let found = complete(&snapshot, &Vec::new, offsets.byte(at), asked).map_err(cancelled)?;
    let [from, to] = offsets.range(found.replaces);
    let list: Vec<Value> = found.list.into_iter().map(proposal).collect();
    Ok(json!({ "from": from, "to": to, "list": list }))
}

fn proposal(Proposal { label, sort, detail, snippet, rank, about }: Proposal) -> Value {
    let sort = match sort {
        Sort::Keyword => "keyword",
        Sort::Object => "class",
        Sort::Region => "namespace",
        Sort::Variable => "variable",
        Sort::Property => "property",
        Sort::Function | Sort::Predicate => "function",
        Sort::Type => "type",
        Sort::Constant | Sort::Unit => "constant",
        Sort::Color | Sort::Text | Sort::File => "text",
    };
    json!({ "label": label, "sort": sort, "detail": detail, "snippet": snippet, "rank": rank, "about": about })
}

/// What is at an offset, as Markdown.
pub fn hover(open: &Open, at: u32) -> Result<Value, Refused> {
    let snapshot = open.host.snapshot();
    let offsets = Offsets::new(snapshot.text());
    let found = hovering::hover(&snapshot, offsets.byte(at)).map_err(cancelled)?;
    Ok(found.map_or(Value::Null, |(range, text)| json!({ "range": offsets.range(range), "text": text })))
}

/// The program, formatted; `null`: it is already.
pub fn formatted(open: &Open) -> Result<Value, Refused> {
    let snapshot = open.host.snapshot();
    let offsets = Offsets::new(snapshot.text());
    Ok(format::file(snapshot.text())
        .map_or(Value::Null, |(range, text)| json!({ "range": offsets.range(range), "text": text })))
}
