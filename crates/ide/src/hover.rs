//! What is said of the thing under the pointer: its type, its documentation, what it is in the layout; of a constraint, by
//! how much it holds, what was asked for, and what would repair it.

use crate::diagnostics::margin;
use crate::names::{self, Occurrence, Symbol};
use crate::navigate::word_of;
use crate::{Judged, Snapshot, conjuncts, facts, keywords};
use scenelang_base::TextRange;
use scenelang_lang::ast::{Stmt, StmtKind};
use scenelang_lang::chunk::cut;
use scenelang_lang::db::Cancelled;
use scenelang_lang::hir::LocalKind;
use scenelang_lang::items::{ItemKind, Located};
use scenelang_lang::library;
use scenelang_lang::natives::{self, Signature};
use scenelang_lang::program::{ObjectId, Program, RegionId};
use scenelang_lang::roles;
use scenelang_lang::token::{Kind, Token, lex};
use scenelang_lang::types::Ty;
use scenelang_verify::check::{Judged as Row, Subject};
use scenelang_verify::explain::move_in_words;
use std::fmt::Write;

/// Markdown about what is at an offset of the main file, and what it is about.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn hover(snapshot: &Snapshot, offset: u32) -> Result<Option<(TextRange, String)>, Cancelled> {
    if let Some(found) = of_requirement(snapshot, offset)? {
        return Ok(Some(found));
    }
    let name = names::name_at(snapshot, snapshot.main(), offset)?;
    let constraint = constraint_at(snapshot, offset)?;
    let about = match &name {
        Some(name) => of_name(snapshot, name)?,
        None => None,
    };
    if about.is_none()
        && let Some((range, text)) = of_word(snapshot.text(), offset)
    {
        return Ok(Some(match constraint {
            // What became of it comes first; a word is the same everywhere.
            Some((whole, verdict)) => (whole, format!("{verdict}\n\n---\n{text}")),
            None => (range, text),
        }));
    }
    Ok(match (name, about, constraint) {
        (Some(name), Some(text), None) => Some((name.range, text)),
        (Some(name), Some(text), Some((_, verdict))) => {
            // Of a conjunction the part that the pointer is on.
            let part = part_in_words(snapshot, offset)?;
            let state = part.unwrap_or_else(|| verdict.lines().next().unwrap_or_default().to_owned());
            Some((name.range, format!("{text}\n\n---\n{state}")))
        }
        (_, None, Some((range, verdict))) => Some((range, verdict)),
        (_, None, None) => None,
        (None, Some(_), _) => None,
    })
}

fn code(text: &str) -> String {
    format!("```scene\n{text}\n```")
}

fn of_name(snapshot: &Snapshot, name: &Occurrence) -> Result<Option<String>, Cancelled> {
    Ok(match &name.symbol {
        Symbol::Item(item, kind) => Some(of_item(snapshot, item, *kind)?),
        Symbol::Local { kind, ty, .. } => {
            let written = snapshot.slice(name.range.in_file(snapshot.main()));
            let (ty, how) = match (kind, ty) {
                (LocalKind::Variable, Ty::Object) => ("Object", "variable of a quantifier"),
                (LocalKind::Variable, _) => (ty.name(), "variable of a quantifier"),
                (LocalKind::Parameter, _) => (ty.name(), "parameter"),
            };
            Some(format!("{}\n\n{how}", code(&format!("{ty} {written}"))))
        }
        Symbol::Predicate(predicate) => {
            let meanings = snapshot.meanings()?;
            let Some(span) = meanings.defined.get(predicate) else { return Ok(None) };
            let other = snapshot.analysis().meanings(span.file)?;
            let own = |(place, _): &&(Located<'_>, _)| matches!(&place.stmt.kind, StmtKind::Predicate { name, .. } if name.text == *predicate);
            other.statements.iter().find(own).map(|(place, _)| {
                let text = snapshot.sources().get(span.file).slice(place.stmt.range.shifted(place.offset));
                format!("{}{}", code(text), documentation(place.stmt))
            })
        }
        Symbol::Library(predicate) => library_predicate(predicate),
        Symbol::BuiltIn(built_in) => Some(built_ins(built_in)),
        Symbol::Property(of, property) => natives::property(*of, property).map(|p| {
            let value =
                value_of(snapshot, name, property).map_or(String::new(), |v| format!("\n\nis `{v}` in the layout"));
            let owner = word_of(*of);
            format!("{}\n\n{}{value}", code(&format!("{owner}.{} : {}", p.name, p.ty.name())), p.doc)
        }),
        Symbol::AllRooms => Some(format!("{}\n\nall rooms: the regions that are not outdoors", code("Regions rooms"))),
        Symbol::AllObjects => Some(format!("{}\n\nall objects, including elements of arrays", code("Objects objects"))),
        Symbol::Component | Symbol::Side => None,
    })
}

/// A predicate of the library, with its documentation.
pub fn library_predicate(name: &str) -> Option<String> {
    let predicate = library::predicates().get(name)?;
    let params: Vec<String> =
        predicate.params.iter().map(|p| format!("{} {}", Ty::of(p.ty).name(), p.name.text)).collect();
    let head = format!("predicate {name}({})", params.join(", "));
    Some(format!("{}{}\n\nof the standard library", code(&head), documentation(predicate.place.stmt)))
}

/// A built-in, with all its overloads.
pub fn built_ins(name: &str) -> String {
    let mut heads: Vec<String> = Vec::new();
    let mut docs: Vec<&str> = Vec::new();
    for signature in natives::overloads(name) {
        heads.push(head_of(signature));
        if !docs.contains(&signature.doc) {
            docs.push(signature.doc);
        }
    }
    format!("{}\n\n{}", code(&heads.join("\n")), docs.join("\n\n"))
}

/// `distance(Object a, Object b) -> Number`
pub(crate) fn head_of(signature: &Signature) -> String {
    let names: Vec<&str> = signature.names.split(", ").collect();
    let params: Vec<String> = names
        .iter()
        .enumerate()
        .map(|(i, name)| match signature.param(i) {
            _ if *name == "…" => "…".to_owned(),
            Ty::Literal => (*name).to_owned(),
            ty => format!("{} {name}", ty.name()),
        })
        .collect();
    let result =
        if signature.result == Ty::Literal { String::new() } else { format!(" -> {}", signature.result.name()) };
    format!("{}({}){result}", signature.name, params.join(", "))
}

pub(crate) fn documentation(stmt: &Stmt) -> String {
    let mut out = String::new();
    let doc = scenelang_lang::wording::description(&stmt.doc);
    if !doc.trim().is_empty() {
        let _ = write!(out, "\n\n{}", doc.trim());
    }
    for (sentence, _) in &stmt.requirements {
        let _ = write!(out, "\n\n_asked for by “{sentence}”_");
    }
    out
}

fn of_item(snapshot: &Snapshot, item: &str, kind: ItemKind) -> Result<String, Cancelled> {
    let meanings = snapshot.meanings()?;
    let mut doc = String::new();
    let mut head = item.to_owned();
    if let Some(span) = meanings.declared.get(item) {
        let other = snapshot.analysis().meanings(span.file)?;
        let own = |(place, _): &&(Located<'_>, _)| {
            place
                .span(place.stmt.range)
                .is_some_and(|s| s.range.start <= span.range.start && span.range.end <= s.range.end)
        };
        if let Some((place, _)) = other.statements.iter().find(own) {
            head = snapshot.sources().get(span.file).slice(place.stmt.range.shifted(place.offset)).to_owned();
            doc = documentation(place.stmt);
        }
    }
    let mut out = format!("{}{doc}", code(&head));
    let compiled = snapshot.compiled()?;
    let Some(layout) = snapshot.layout().filter(|l| l.read.usable).map(|l| &l.read.layout) else { return Ok(out) };
    match kind {
        ItemKind::Object | ItemKind::Array(_) => {
            let own = |name: &str| name == item || name.strip_prefix(item).is_some_and(|rest| rest.starts_with('['));
            let placed: Vec<_> = layout.objects.iter().filter(|(name, _)| own(name)).collect();
            for (name, p) in placed.iter().take(4) {
                let turn =
                    if p.rot.amax() > 1e-6 { format!(", turned ({})", facts::triple(p.rot)) } else { String::new() };
                let _ = write!(out, "\n\n`{name}` is at ({}){turn}, {}", facts::triple(p.pos), facts::size(&p.scale));
            }
            if placed.len() > 4 {
                let _ = write!(out, "\n\nand {} more", placed.len() - 4);
            }
            out.push_str(&failing(snapshot, &compiled.program, &own)?);
        }
        ItemKind::Region => {
            if let Some(p) = layout.region(item) {
                let _ = write!(out, "\n\nis at ({}), {}", facts::triple(p.pos), facts::size(&p.scale));
            }
        }
        ItemKind::Variable(_) => {
            if let Some(value) = facts::of_variable(layout, item) {
                let _ = write!(out, "\n\nis `{value}` in the layout");
            }
        }
    }
    Ok(out)
}

/// What does not hold of objects.
fn failing(snapshot: &Snapshot, program: &Program, own: &dyn Fn(&str) -> bool) -> Result<String, Cancelled> {
    const MOST: usize = 5;
    let Some(judged) = snapshot.judged()? else { return Ok(String::new()) };
    let name = |id: &ObjectId| program.objects.get(id.0 as usize).is_some_and(|o| own(&o.name));
    let fails = |row: &&Row| row.satisfied == Some(false) && row.objects.iter().any(name);
    let rows: Vec<&Row> = judged.verdict.rows.iter().filter(fails).collect();
    let mut out = String::new();
    for row in rows.iter().take(MOST) {
        let _ = write!(out, "\n- fails: {}", crate::diagnostics::headline(row));
    }
    if rows.len() > MOST {
        let _ = write!(out, "\n- and {} more", rows.len() - MOST);
    }
    Ok(if out.is_empty() { out } else { format!("\n{out}") })
}

/// The value of the property at an occurrence, where it is one of a single thing.
fn value_of(snapshot: &Snapshot, name: &Occurrence, property: &str) -> Option<String> {
    let text = snapshot.text();
    // What stands before the dot, on the same line.
    let before = text.get(..name.range.start as usize)?.trim_end().strip_suffix('.')?.trim_end();
    let start = before
        .rfind(|c: char| !(c.is_alphanumeric() || c == '_' || c == '[' || c == ']'))
        .map_or(0, |at| at + before[at..].chars().next().map_or(1, char::len_utf8));
    let owner = &before[start..];
    let compiled = snapshot.compiled().ok()?;
    let program = &compiled.program;
    let layout = &snapshot.layout()?.read.layout;
    if let Some(id) = program.objects.iter().position(|o| o.name == owner) {
        return facts::of_object(snapshot, program, layout, ObjectId(id as u32), property);
    }
    let id = program.regions.iter().position(|r| r.name == owner)?;
    facts::of_region(snapshot, program, layout, RegionId(id as u32), property)
}

/// The category that is assigned at an offset.
pub fn category_at(snapshot: &Snapshot, offset: u32) -> Option<String> {
    match word_at(snapshot.text(), offset)? {
        (_, Word::Category(category)) => Some(category.trim().to_owned()),
        (_, Word::Other(_)) => None,
    }
}

/// The word of the language, or the category, at an offset.
fn of_word(text: &str, offset: u32) -> Option<(TextRange, String)> {
    let (range, word) = word_at(text, offset)?;
    match word {
        Word::Category(category) => Some((range, of_category(category))),
        Word::Other(written) => keywords::says(written).map(|text| (range, text)),
    }
}

enum Word<'t> {
    /// What is between the quotes.
    Category(&'t str),
    Other(&'t str),
}

/// What is written at an offset; of texts only categories.
fn word_at(text: &str, offset: u32) -> Option<(TextRange, Word<'_>)> {
    let chunk = cut(text).chunks.into_iter().find(|c| c.range.start <= offset && offset <= c.range.end)?;
    let tokens = lex(text.get(chunk.range.bytes())?);
    let at = offset - chunk.range.start;
    let own = |t: &&Token| t.range.start <= at && at < t.range.end && !t.kind.is_trivia();
    let token = tokens.iter().find(own)?;
    let range = token.range.shifted(chunk.range.start);
    let written = text.get(range.bytes())?;
    if token.kind == Kind::Str {
        let mut before = tokens.iter().filter(|t| t.range.end <= token.range.start && t.kind == Kind::Ident);
        let word = |t: &Token| text.get(t.range.shifted(chunk.range.start).bytes());
        let category = before.next_back().and_then(word) == Some("category");
        return category.then(|| (range, Word::Category(written.trim_matches('"'))));
    }
    Some((range, Word::Other(written)))
}

/// How large a thing of a category usually is, and what it is for.
fn of_category(category: &str) -> String {
    let role = roles::role_of(category);
    let role = if role.is_empty() { String::new() } else { format!("\n\nits role: `{role}`") };
    match library::usual_size(category) {
        Some([x, y, z]) => {
            format!("**{category}**\n\nusual size: {x:.2} × {y:.2} × {z:.2} m (width × height × depth){role}")
        }
        None => {
            let near = library::nearest_category(category).map(|near| format!("; did you mean `{near}`?"));
            format!("**{category}**\n\nno usual size is known{}{role}", near.unwrap_or_default())
        }
    }
}

/// The requirement whose `@req(…)` holds an offset: what became of all statements that answer it.
fn of_requirement(snapshot: &Snapshot, offset: u32) -> Result<Option<(TextRange, String)>, Cancelled> {
    let meanings = snapshot.meanings()?;
    let text = snapshot.text();
    // From the `@` on, which stands before the bracket that the sentence is in.
    let whole = |sentence: TextRange| {
        let start = text[..sentence.start as usize].rfind('@').map_or(sentence.start, |at| at as u32);
        TextRange { start, end: sentence.end }
    };
    let marked = meanings.statements.iter().find_map(|(place, _)| {
        let holds = |(_, range): &&(String, TextRange)| {
            let own = whole(range.shifted(place.offset));
            own.start <= offset && offset <= own.end
        };
        let (sentence, range) = place.stmt.requirements.iter().find(holds)?;
        Some((sentence.clone(), whole(range.shifted(place.offset))))
    });
    let Some((sentence, range)) = marked else { return Ok(None) };
    let judged = snapshot.judged()?;
    let mut lines = Vec::new();
    let (mut holds, mut all) = (0, 0);
    for (place, _) in &meanings.statements {
        if !place.stmt.requirements.iter().any(|(other, _)| *other == sentence) {
            continue;
        }
        let span = place.stmt.range.shifted(place.offset);
        let written = text.get(span.bytes()).unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ");
        let rows = judged.iter().flat_map(|judged| &judged.verdict.rows);
        let own = |row: &&Row| {
            matches!(row.subject, Subject::Statement(_))
                && row.place.file == snapshot.main()
                && span.start <= row.place.range.start
                && row.place.range.end <= span.end
        };
        let mut said = Vec::new();
        for row in rows.filter(own) {
            all += 1;
            holds += usize::from(row.satisfied == Some(true));
            said.push(state_in_words(row));
        }
        let line = text[..span.start as usize].matches('\n').count() + 1;
        let said = if said.is_empty() { String::new() } else { format!(": {}", said.join(", ")) };
        lines.push(format!("- line {line}: `{written}`{said}"));
    }
    let sum = match (holds, all) {
        (_, 0) => String::new(),
        (holds, all) if holds == all => "\n\nis met".to_owned(),
        (holds, all) => format!("\n\nis **not met**: {holds} of {all} hold"),
    };
    Ok(Some((range, format!("“{sentence}”{sum}\n\n{}", lines.join("\n")))))
}

/// Whether a row holds, and by how much.
fn state_in_words(row: &Row) -> String {
    let by = margin(row).map_or(String::new(), |m| format!(", margin **{m}**"));
    match row.satisfied {
        Some(true) => format!("holds{by}"),
        Some(false) => format!("**fails**{by}"),
        None => "cannot be checked in this layout".to_owned(),
    }
}

/// The row of the constraint whose statement holds an offset.
fn row_at(snapshot: &Snapshot, judged: &Judged, offset: u32) -> Option<usize> {
    let here = |row: &Row| {
        let place = row.place;
        matches!(row.subject, Subject::Statement(_))
            && place.file == snapshot.main()
            && place.range.start <= offset
            && offset <= place.range.end
    };
    judged.verdict.rows.iter().position(here)
}

/// Whether the part of a conjunction holds in which an offset is, and by how much; `None`: it is in none.
fn part_in_words(snapshot: &Snapshot, offset: u32) -> Result<Option<String>, Cancelled> {
    let Some(judged) = snapshot.judged()? else { return Ok(None) };
    let row = row_at(snapshot, &judged, offset).map(|index| &judged.verdict.rows[index]);
    let Some(Subject::Statement(index)) = row.map(|row| row.subject) else { return Ok(None) };
    let Some(constraint) = judged.compiled.program.constraints.get(index) else { return Ok(None) };
    let part = conjuncts::part_at(snapshot, constraint, offset)?;
    Ok(part.map(|part| {
        let by = part.margin.map_or(String::new(), |m| format!(", margin **{m}**"));
        format!("{}{by}", if part.holds { "holds" } else { "**fails**" })
    }))
}

/// The constraint whose statement holds an offset, and what is to be said of it.
pub(crate) fn constraint_at(snapshot: &Snapshot, offset: u32) -> Result<Option<(TextRange, String)>, Cancelled> {
    let Some(judged) = snapshot.judged()? else { return Ok(None) };
    let Some(index) = row_at(snapshot, &judged, offset) else { return Ok(None) };
    let row = &judged.verdict.rows[index];
    // The sentences and the moves are worked out only for who asks.
    let verdict = if row.satisfied == Some(false) { snapshot.explained()? } else { None };
    let full = verdict.as_ref().and_then(|v| v.rows.iter().find(|r| r.subject == row.subject && r.kind == row.kind));
    let program = &judged.compiled.program;
    let mut text = verdict_in_words(program, full.unwrap_or(row));
    if let Subject::Statement(index) = row.subject
        && let Some(constraint) = program.constraints.get(index)
    {
        for part in conjuncts::parts(snapshot, constraint)? {
            let state = if part.holds { "holds" } else { "**fails**" };
            let by = part.margin.map_or(String::new(), |m| format!(", margin {m}"));
            let _ = write!(text, "\n- `{}` {state}{by}", part.text);
        }
    }
    Ok(Some((row.place.range, text)))
}

fn verdict_in_words(program: &Program, row: &Row) -> String {
    let mut out = state_in_words(row);
    if !row.measured.is_empty() {
        let _ = write!(out, "\n\n{}", row.measured);
    }
    for label in &row.related {
        let _ = write!(out, "\n- {}", label.message);
    }
    for requirement in &row.requirements {
        let _ = write!(out, "\n\n_asked for by “{requirement}”_");
    }
    if let Some(explanation) = &row.explanation {
        let choices = match (explanation.choices.as_slice(), &explanation.repair) {
            ([], Some(repair)) => std::slice::from_ref(repair),
            (choices, _) => choices,
        };
        for (i, choice) in choices.iter().enumerate() {
            let lead = if i == 0 { "\n\nto repair it: " } else { ", or " };
            let _ = write!(out, "{lead}{}", move_in_words(program, choice));
        }
        if !explanation.pinned.is_empty() {
            out.push_str("\n\nassignments fix its objects");
        }
    }
    out
}
