//! A formula becomes a predicate, and a call becomes the formula that it stands for.

use super::{Action, ActionKind, indent};
use crate::Snapshot;
use crate::names::{Occurrence, Symbol, occurrences};
use crate::shape::is_constraint;
use scenelang_base::{Edit, TextRange};
use scenelang_lang::ast::{ExprId, ExprKind, StmtKind};
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::{LocalKind, Resolution};
use scenelang_lang::items::ItemKind;
use scenelang_lang::token::lex;
use scenelang_lang::types::Ty;

/// A condition that a selection covers, or all of the constraint that the cursor is in, becomes a predicate.
pub(super) fn extract(snapshot: &Snapshot, range: TextRange, out: &mut Vec<Action>) -> Result<(), Cancelled> {
    let meanings = snapshot.meanings()?;
    let text = snapshot.text();
    let holds = |whole: TextRange| whole.start <= range.start && range.end <= whole.end;
    let found = meanings.statements.iter().find(|(place, _)| holds(place.stmt.range.shifted(place.offset)));
    let Some((place, hir)) = found.filter(|(place, _)| is_constraint(&place.stmt.kind)) else { return Ok(()) };
    let is_condition = |i: &usize| hir.type_of(ExprId(*i as u32)) == Some(Ty::Bool);
    let exprs = (0..place.stmt.exprs.len()).filter(is_condition);
    let place_of = |i: usize| place.stmt.exprs[i].range.shifted(place.offset);
    // The largest within the selection; without one, the whole formula.
    let chosen = if range.is_empty() {
        match place.stmt.kind {
            StmtKind::Assert { formula } | StmtKind::Prefer { formula, .. } => Some(place_of(formula.0 as usize)),
            _ => None,
        }
    } else {
        let trimmed = trimmed(text, range);
        exprs.map(place_of).filter(|r| trimmed.start <= r.start && r.end <= trimmed.end).max_by_key(|r| r.len())
    };
    let Some(chosen) = chosen.map(|r| with_brackets(text, r)) else { return Ok(()) };
    let Some(written) = text.get(chosen.bytes()) else { return Ok(()) };
    // A draw belongs to its place: moved into a predicate it would be another one.
    let tokens = lex(written);
    if tokens.len() < 4 || tokens.iter().any(|t| scenelang_lang::natives::is_draw(&written[t.range.bytes()])) {
        return Ok(());
    }
    let names = occurrences(snapshot, snapshot.main())?;
    let inside = names.iter().filter(|o| chosen.start <= o.range.start && o.range.end <= chosen.end);
    let Some(params) = parameters(text, chosen, &inside.collect::<Vec<_>>()) else { return Ok(()) };
    let name = free_name("holds", |n| meanings.defined.contains_key(n) || scenelang_lang::natives::is_built_in(n));
    let head: Vec<String> = params.iter().map(|p| format!("{} {}", p.ty.name(), p.name)).collect();
    let args: Vec<&str> = params.iter().map(|p| p.argument.as_str()).collect();
    let body =
        replaced(text, chosen, params.iter().flat_map(|p| p.places.iter().map(|r| (*r, p.name.as_str()))).collect());
    let start = scenelang_lang::chunk::cut(text)
        .chunks
        .iter()
        .find(|c| c.range.start <= chosen.start && chosen.start < c.range.end)
        .map_or(chosen.start, |c| c.range.start);
    let lead = indent(text, start);
    let definition = format!("predicate {name}({}) := {};\n{lead}", head.join(", "), body.trim());
    let file = snapshot.main();
    let edits = vec![
        Edit { place: TextRange::empty(start).in_file(file), text: definition },
        Edit { place: chosen.in_file(file), text: format!("{name}({})", args.join(", ")) },
    ];
    out.push(Action::new(format!("Extract predicate `{name}`"), ActionKind::Extract, edits));
    Ok(())
}

/// A parameter of a predicate to be.
struct Param {
    name: String,
    ty: Ty,
    argument: String,
    places: Vec<TextRange>,
}

/// What a formula speaks of, as parameters; `None`: something that cannot be one.
fn parameters(text: &str, whole: TextRange, names: &[&Occurrence]) -> Option<Vec<Param>> {
    let bound_inside =
        |o: &Occurrence| names.iter().any(|d| d.symbol.is(&o.symbol) && d.role == crate::names::Role::Declares);
    let mut out: Vec<Param> = Vec::new();
    let mut letters = (b'a'..=b'z').map(char::from);
    for name in names {
        let (ty, range) = match &name.symbol {
            Symbol::Item(_, ItemKind::Array(_)) => match element(text, name.range, whole) {
                Some(range) => (Ty::Object, range),
                None => (Ty::Objects, name.range),
            },
            Symbol::Item(_, kind) => (kind.ty(), name.range),
            Symbol::Local { kind, ty, .. } if !bound_inside(name) => match (kind, ty) {
                (LocalKind::Variable, Ty::Literal) => return None,
                (_, ty) => (*ty, name.range),
            },
            _ => continue,
        };
        let argument = text.get(range.bytes())?.to_owned();
        match out.iter_mut().find(|p| p.argument == argument) {
            Some(param) => param.places.push(range),
            None => {
                let taken = |n: &str| names.iter().any(|o| text.get(o.range.bytes()) == Some(n));
                let letter = letters.by_ref().map(String::from).find(|n| !taken(n))?;
                out.push(Param { name: letter, ty, argument, places: vec![range] });
            }
        }
    }
    Some(out)
}

/// `chair[1]` around the name of an array, if a literal says which.
fn element(text: &str, name: TextRange, whole: TextRange) -> Option<TextRange> {
    let rest = text.get(name.end as usize..whole.end as usize)?;
    let inner = rest.trim_start().strip_prefix('[')?;
    let (index, _) = inner.split_once(']')?;
    index.trim().parse::<u32>().ok()?;
    let end = rest.find(']')? + 1;
    Some(TextRange { start: name.start, end: name.end + end as u32 })
}

fn replaced(text: &str, whole: TextRange, mut places: Vec<(TextRange, &str)>) -> String {
    places.sort_by_key(|(range, _)| range.start);
    let mut out = String::new();
    let mut at = whole.start;
    for (range, new) in places {
        out.push_str(&text[at as usize..range.start as usize]);
        out.push_str(new);
        at = range.end;
    }
    out.push_str(&text[at as usize..whole.end as usize]);
    out
}

fn trimmed(text: &str, range: TextRange) -> TextRange {
    let Some(inner) = text.get(range.bytes()) else { return range };
    let start = range.start + (inner.len() - inner.trim_start().len()) as u32;
    TextRange { start, end: (range.start + inner.trim_end().len() as u32).max(start) }
}

/// Ranges of expressions leave out brackets around them; a whole formula must not be torn out of its own.
fn with_brackets(text: &str, range: TextRange) -> TextRange {
    let inner = &text[range.bytes()];
    let open = inner.matches('(').count();
    let close = inner.matches(')').count();
    if open == close {
        return range;
    }
    let before = text[..range.start as usize].trim_end();
    let after = &text[range.end as usize..];
    if close > open && before.ends_with('(') {
        return TextRange { start: before.len() as u32 - 1, end: range.end };
    }
    match after.find(')') {
        Some(at) if open > close => TextRange { start: range.start, end: range.end + at as u32 + 1 },
        _ => range,
    }
}

/// A name that nothing has.
fn free_name(stem: &str, taken: impl Fn(&str) -> bool) -> String {
    let numbered = (2..).map(|n| format!("{stem}{n}"));
    std::iter::once(stem.to_owned()).chain(numbered).find(|n| !taken(n)).unwrap_or_default()
}

/// The call of a predicate of the program becomes its body.
pub(super) fn inline(snapshot: &Snapshot, range: TextRange, out: &mut Vec<Action>) -> Result<(), Cancelled> {
    let meanings = snapshot.meanings()?;
    for (place, hir) in &meanings.statements {
        for (i, expr) in place.stmt.exprs.iter().enumerate() {
            let ExprKind::Call(name, args) = &expr.kind else { continue };
            let own = name.range.shifted(place.offset);
            let here = own.start <= range.start && range.end <= own.end;
            let predicate =
                matches!(hir.resolution(ExprId(i as u32)), Some(Resolution::Predicate { library: false, .. }));
            if !here || !predicate {
                continue;
            }
            let Some(span) = meanings.defined.get(&name.text) else { continue };
            let args: Vec<String> =
                args.iter().map(|id| snapshot.slice_of(place.stmt.expr(*id).range.shifted(place.offset))).collect();
            if let Some(body) = body_with(snapshot, span.file, &name.text, &args)? {
                let whole = with_brackets(snapshot.text(), expr.range.shifted(place.offset));
                let edit = Edit { place: whole.in_file(snapshot.main()), text: format!("({body})") };
                out.push(Action::new(format!("Inline predicate `{}`", name.text), ActionKind::Inline, vec![edit]));
            }
        }
    }
    Ok(())
}

/// The body of a predicate with arguments for its parameters; `None`: a name in an argument would mean something else there.
fn body_with(
    snapshot: &Snapshot,
    file: scenelang_base::FileId,
    predicate: &str,
    args: &[String],
) -> Result<Option<String>, Cancelled> {
    let meanings = snapshot.analysis().meanings(file)?;
    let text = snapshot.sources().get(file).text();
    let found = meanings.statements.iter().find_map(|(place, hir)| match &place.stmt.kind {
        StmtKind::Predicate { name, params, body } if name.text == predicate => Some((place, hir, params, *body)),
        _ => None,
    });
    let Some((place, hir, params, body)) = found.filter(|(.., params, _)| params.len() == args.len()) else {
        return Ok(None);
    };
    let binds = |local: &scenelang_lang::hir::Local| local.kind == LocalKind::Variable;
    let words: Vec<String> =
        args.iter().flat_map(|a| lex(a).into_iter().map(|t| a[t.range.bytes()].to_owned())).collect();
    if hir.locals.iter().filter(|l| binds(l)).any(|l| words.iter().any(|w| *w == l.name.as_str())) {
        return Ok(None);
    }
    let whole = with_brackets(text, place.stmt.expr(body).range.shifted(place.offset));
    let mut places: Vec<(TextRange, String)> = Vec::new();
    for (i, expr) in place.stmt.exprs.iter().enumerate() {
        let Some(Resolution::Local(index)) = hir.resolution(ExprId(i as u32)) else { continue };
        let param = hir.locals.get(*index).and_then(|l| params.iter().position(|p| p.name.range == l.range));
        if let Some(arg) = param.and_then(|at| args.get(at)) {
            let simple =
                lex(arg).iter().all(|t| !t.kind.is_trivia()) && !arg.contains(['+', '-', '*', '/', '=', '<', '>']);
            let written = if simple { arg.clone() } else { format!("({arg})") };
            places.push((expr.range.shifted(place.offset), written));
        }
    }
    Ok(Some(replaced(text, whole, places.iter().map(|(r, t)| (*r, t.as_str())).collect())))
}

impl Snapshot {
    /// The text of a range of the main file.
    fn slice_of(&self, range: TextRange) -> String {
        self.slice(range.in_file(self.main())).to_owned()
    }
}
