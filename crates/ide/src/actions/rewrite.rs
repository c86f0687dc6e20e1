//! The same said in another way.

use super::{Action, ActionKind, Detail, indent};
use crate::Snapshot;
use crate::names::{Role, Symbol, declared_kind, name_at, occurrences};
use rustc_hash::FxHashMap;
use scenelang_base::{Edit, Span, TextRange};
use scenelang_lang::ast::{BinaryOp, ExprId, ExprKind, Stmt, StmtKind};
use scenelang_lang::db::Cancelled;
use scenelang_lang::items::ItemKind;
use scenelang_lang::program::{Owner, Pinned};
use smol_str::SmolStr;

/// `assert φ and ψ` becomes two assertions, with the requirements of the one.
pub(super) fn split(snapshot: &Snapshot, range: TextRange, out: &mut Vec<Action>) -> Result<(), Cancelled> {
    let meanings = snapshot.meanings()?;
    let text = snapshot.text();
    for (place, _) in &meanings.statements {
        let StmtKind::Assert { formula } = place.stmt.kind else { continue };
        let whole = place.stmt.range.shifted(place.offset);
        if !(whole.start <= range.start && range.end <= whole.end) {
            continue;
        }
        let mut parts = Vec::new();
        conjuncts(place.stmt, formula, &mut parts);
        // Draws are known by the number of their assertion, which would be another one.
        let draws = snapshot.compiled()?.program.draws.iter().any(|d| d.key.contains("assert["));
        if parts.len() < 2 || draws {
            return Ok(());
        }
        let lead = indent(text, whole.start);
        let requirements: String = place
            .stmt
            .requirements
            .iter()
            .map(|(_, r)| format!("@req({})\n{lead}", &text[r.shifted(place.offset).bytes()]))
            .collect();
        // What stands between the parts belongs to one of them: brackets too.
        let Some(written) = between(text, &parts, place.offset, whole) else { return Ok(()) };
        let statements: Vec<String> = written.iter().map(|part| format!("assert {part}")).collect();
        let joined = statements.join(&format!(";\n{lead}{requirements}"));
        let edit = Edit { place: whole.in_file(snapshot.main()), text: joined };
        out.push(Action::new(format!("Split into {} assertions", parts.len()), ActionKind::Rewrite, vec![edit]));
    }
    Ok(())
}

/// The operands of a chain of `and`, with the places of the operators between them.
fn conjuncts(stmt: &Stmt, id: ExprId, out: &mut Vec<(ExprId, Option<TextRange>)>) {
    // A chain leans to the left, so the right operands are found first.
    let mut id = id;
    let mut found = Vec::new();
    while let ExprKind::Binary(BinaryOp::And, operator, left, right) = &stmt.expr(id).kind {
        found.push((*right, Some(*operator)));
        id = *left;
    }
    found.push((id, None));
    out.extend(found.into_iter().rev());
}

/// The texts between the operators; `None`: brackets around the whole chain, or not in pairs.
fn between(text: &str, parts: &[(ExprId, Option<TextRange>)], offset: u32, whole: TextRange) -> Option<Vec<String>> {
    let keyword = whole.start + "assert".len() as u32;
    let mut out = Vec::new();
    for (i, (_, operator)) in parts.iter().enumerate() {
        let start = operator.map_or(keyword, |r| r.shifted(offset).end);
        let end = parts.get(i + 1).and_then(|(_, next)| *next).map_or(whole.end, |r| r.shifted(offset).start);
        let part = text.get(start as usize..end as usize)?.trim();
        if part.matches('(').count() != part.matches(')').count() || part.is_empty() {
            return None;
        }
        out.push(part.to_owned());
    }
    Some(out)
}

/// Objects `chair1`, `chair2`, … become an array, in the layout too. Everything that speaks of one of them is edited.
pub(super) fn array(
    snapshot: &Snapshot,
    range: TextRange,
    detail: Detail,
    out: &mut Vec<Action>,
) -> Result<(), Cancelled> {
    let meanings = snapshot.meanings()?;
    let Some(name) = name_at(snapshot, snapshot.main(), range.start)? else { return Ok(()) };
    let Symbol::Item(item, ItemKind::Object) = &name.symbol else { return Ok(()) };
    let stem = item.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_').to_owned();
    if stem.is_empty() || stem.len() == item.len() || meanings.declared.contains_key(stem.as_str()) {
        return Ok(());
    }
    let number = |n: &str| n.strip_prefix(&stem)?.trim_start_matches('_').parse::<u32>().ok();
    let mut members: Vec<(u32, SmolStr, Span)> = Vec::new();
    for (place, _) in &meanings.statements {
        if let Some((name, ItemKind::Object)) = declared_kind(place)
            && let Some(n) = number(&name)
            && let Some(span) = place.span(place.stmt.range)
        {
            members.push((n, name, span));
        }
    }
    members.sort();
    members.dedup_by_key(|(n, ..)| *n);
    if members.len() < 2 {
        return Ok(());
    }
    let edits = match detail {
        Detail::Titles => Vec::new(),
        Detail::Edits => array_edits(snapshot, &stem, &members)?,
    };
    out.push(Action::new(
        format!("Combine these objects into the array `{stem}[{}]`", members.len()),
        ActionKind::Rewrite,
        edits,
    ));
    Ok(())
}

/// Objects of these numbers, names and declarations become elements.
fn array_edits(snapshot: &Snapshot, stem: &str, members: &[(u32, SmolStr, Span)]) -> Result<Vec<Edit>, Cancelled> {
    let mut edits = Vec::new();
    let numbers: FxHashMap<&str, usize> = members.iter().enumerate().map(|(i, (_, n, _))| (n.as_str(), i)).collect();
    for (file, _) in snapshot.sources().iter().filter(|(id, _)| snapshot.layout().is_none_or(|l| l.file != *id)) {
        for o in occurrences(snapshot, file)?.iter().filter(|o| o.role != Role::Declares) {
            let Symbol::Item(named, _) = &o.symbol else { continue };
            if let Some(index) = numbers.get(named.as_str()) {
                edits.push(Edit { place: o.range.in_file(file), text: format!("{stem}[{index}]") });
            }
        }
    }
    let text = snapshot.text();
    let first = members.iter().map(|(.., span)| span.range.start).min().unwrap_or_default();
    for (index, (_, name, span)) in members.iter().enumerate() {
        let element = format!("{stem}[{index}]");
        if let Some(entry) = snapshot.layout().and_then(|l| l.read.places.objects.get(name)) {
            edits.push(Edit { place: entry.place.key, text: serde_json::Value::from(element).to_string() });
        }
        let declaration = format!("object {stem}[{}]", members.len());
        let (range, new) = if span.range.start == first {
            (span.range, declaration)
        } else {
            (whole_line(text, span.range), String::new())
        };
        edits.push(Edit { place: range.in_file(span.file), text: new });
    }
    Ok(edits)
}

/// A statement with its `;` and, if it stands alone on its line, with that.
fn whole_line(text: &str, stmt: TextRange) -> TextRange {
    let after = text[stmt.end as usize..].strip_prefix(';').map_or(stmt.end, |_| stmt.end + 1);
    let start = super::line_start(text, stmt.start);
    let alone = text[start as usize..stmt.start as usize].trim().is_empty();
    let rest = &text[after as usize..];
    let line = rest.strip_prefix("\r\n").map(|_| 2).or_else(|| rest.strip_prefix('\n').map(|_| 1));
    match line {
        Some(len) if alone => TextRange { start, end: after + len },
        _ => TextRange { start: stmt.start, end: after },
    }
}

/// The place that an object has in the layout is assigned in the program.
pub(super) fn pin(snapshot: &Snapshot, range: TextRange, out: &mut Vec<Action>) -> Result<(), Cancelled> {
    let Some(name) = name_at(snapshot, snapshot.main(), range.start)? else { return Ok(()) };
    let Symbol::Item(item, ItemKind::Object) = &name.symbol else { return Ok(()) };
    let Some(placed) = snapshot.layout().and_then(|l| l.read.layout.object(item)) else { return Ok(()) };
    let meanings = snapshot.meanings()?;
    let Some(span) = meanings.declared.get(item).filter(|span| span.file == snapshot.main()) else { return Ok(()) };
    let own = |place: &&scenelang_lang::items::Located<'_>| {
        place.span(place.stmt.range).is_some_and(|s| s.range.start <= span.range.start && span.range.end <= s.range.end)
    };
    let Some(place) = meanings.statements.iter().map(|(place, _)| place).find(own) else { return Ok(()) };
    let compiled = snapshot.compiled()?;
    let program = &compiled.program;
    let id = program.objects.iter().position(|o| o.name == *item);
    let pinned = |property: Pinned| {
        program
            .pins
            .iter()
            .any(|p| matches!(p.owner, Owner::Object(o) if Some(o.0 as usize) == id) && p.property == property)
    };
    let text = snapshot.text();
    let end = place.stmt.range.shifted(place.offset).end;
    let at = if text[end as usize..].starts_with(';') { end + 1 } else { end };
    let lead = indent(text, span.range.start);
    let short = |x: f64| (x * 1e4).round() / 1e4 + 0.0;
    let three = |v: scenelang_layout::Vec3| format!("{}, {}, {}", short(v.x), short(v.y), short(v.z));
    let mut new = String::new();
    if !pinned(Pinned::Pos) {
        new.push_str(&format!("\n{lead}{item}.pos <- vec3({});", three(placed.pos)));
    }
    if !pinned(Pinned::Rot) {
        new.push_str(&format!("\n{lead}{item}.rot <- rot({});", three(placed.rot)));
    }
    if !new.is_empty() {
        let edit = Edit { place: TextRange::empty(at).in_file(snapshot.main()), text: new };
        out.push(Action::new(format!("Pin `{item}` at its current position"), ActionKind::Rewrite, vec![edit]));
    }
    Ok(())
}
