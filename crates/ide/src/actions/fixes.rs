//! Fixes of what is marked.

use super::{Action, ActionKind, Ghost, indent, is_safe, line_end, line_start};
use crate::diagnostics::{Finding, diagnostics};
use crate::{LayoutFile, Snapshot};
use scenelang_base::{Edit, FileId, TextRange, codes, fix};
use scenelang_lang::db::Cancelled;
use scenelang_lang::program::Program;
use scenelang_layout::file::MemberPlace;
use scenelang_layout::{Layout, Placement, Vec3};
use scenelang_verify::explain::{ObjectMove, move_in_words};

pub(super) fn of_finding(snapshot: &Snapshot, finding: &Finding, out: &mut Vec<Action>) -> Result<(), Cancelled> {
    let d = &finding.diagnostic;
    let repairs = |action: Action| Action { repairs: Some(finding.clone()), ..action };
    for fix in &d.fixes {
        let preferred = is_safe(fix.applicability);
        let action = Action::new(sentence(&fix.title), ActionKind::Fix, fix.edits.clone());
        out.push(repairs(Action { preferred, ..action }));
    }
    let Some(place) = d.primary.as_ref().map(|label| label.place) else { return Ok(()) };
    if d.code == codes::E0201 {
        let said = d.fixes.iter().any(|fix| fix.title.contains("`object "));
        out.extend(declare(snapshot, place.range, !said).into_iter().map(repairs));
    }
    if d.code.as_str().starts_with('W') && place.file == snapshot.main() {
        out.push(repairs(silence(snapshot, d.code.as_str(), place.range)));
    }
    if let Some(index) = finding.row {
        out.extend(choices(snapshot, index)?.into_iter().map(repairs));
    }
    Ok(())
}

/// A title with a capital letter.
pub fn sentence(title: &str) -> String {
    let mut chars = title.chars();
    chars.next().map_or(String::new(), |first| first.to_uppercase().chain(chars).collect())
}

/// Declarations of a name that nothing has.
fn declare(snapshot: &Snapshot, name: TextRange, object: bool) -> Vec<Action> {
    let text = snapshot.text();
    let Some(written) = text.get(name.bytes()) else { return Vec::new() };
    let at = line_start(text, name.start);
    let lead = indent(text, name.start);
    let make = |word: &str, what: &str| {
        let place = TextRange::empty(at).in_file(snapshot.main());
        let edit = Edit { place, text: format!("{lead}{word} {written};\n") };
        Action::new(format!("Declare `{written}` as {what}"), ActionKind::Fix, vec![edit])
    };
    let kinds = [("object", "an object"), ("region", "a region"), ("Number", "a number")];
    // That it may be an object is often said by the diagnostic itself.
    kinds.into_iter().skip(usize::from(!object)).map(|(word, what)| make(word, what)).collect()
}

/// A comment behind the line that silences a warning.
fn silence(snapshot: &Snapshot, code: &str, place: TextRange) -> Action {
    let end = line_end(snapshot.text(), place.start);
    let edit = Edit { place: TextRange::empty(end).in_file(snapshot.main()), text: format!(" // allow({code})") };
    Action::new(format!("Allow {code} here"), ActionKind::Fix, vec![edit])
}

/// Moves that repair a row and break nothing, the best first: they were judged before.
fn choices(snapshot: &Snapshot, index: usize) -> Result<Vec<Action>, Cancelled> {
    let (Some(judged), Some(explained)) = (snapshot.judged()?, snapshot.explained()?) else { return Ok(Vec::new()) };
    let Some(row) = judged.verdict.rows.get(index) else { return Ok(Vec::new()) };
    let same = explained.rows.iter().find(|r| r.kind == row.kind && r.subject == row.subject);
    let Some(explanation) = same.and_then(|r| r.explanation.as_ref()) else { return Ok(Vec::new()) };
    let program = &judged.compiled.program;
    let mut out = Vec::new();
    for choice in &explanation.choices {
        let Some(edits) = moves(snapshot, program, &choice.steps) else { continue };
        let title = sentence(&move_in_words(program, choice));
        let moves = choice.steps.iter().filter_map(|step| Ghost::of(snapshot, program, step)).collect();
        out.push(Action { preferred: out.is_empty(), moves, ..Action::new(title, ActionKind::Fix, edits) });
    }
    Ok(out)
}

impl Ghost {
    /// Where an object is after a step.
    fn of(snapshot: &Snapshot, program: &Program, step: &ObjectMove) -> Option<Self> {
        let object = program.objects.get(step.object.0 as usize)?.name.to_string();
        let placed = snapshot.layout()?.read.layout.object(&object)?;
        let mut rot = placed.rot;
        rot.y += step.turn;
        Some(Self { object, pos: placed.pos + Vec3::from(step.by), rot })
    }
}

/// Moves as edits of the layout: of the numbers, and nothing else.
fn moves(snapshot: &Snapshot, program: &Program, steps: &[ObjectMove]) -> Option<Vec<Edit>> {
    let layout = snapshot.layout()?;
    let mut edits = Vec::new();
    for step in steps {
        let name = &program.objects.get(step.object.0 as usize)?.name;
        let placed = layout.read.layout.object(name)?;
        let turned = Vec3::new(placed.rot.x, (placed.rot.y + step.turn).rem_euclid(360.0), placed.rot.z);
        let rot = if step.turn == 0.0 { placed.rot } else { turned };
        edits.extend(placing(layout, name, placed.pos + Vec3::from(step.by), rot)?);
    }
    Some(edits)
}

/// Another place for an object as edits of the layout: of the numbers that change, and nothing else. `None`: the layout has
/// no such object.
pub fn placing(layout: &LayoutFile, name: &str, pos: Vec3, rot: Vec3) -> Option<Vec<Edit>> {
    let placed = layout.read.layout.object(name)?;
    let entry = layout.read.places.objects.get(name)?;
    let at = entry.member("pos")?.value;
    let mut edits = Vec::new();
    if pos != placed.pos {
        edits.push(Edit { place: at, text: numbers(pos) });
    }
    if rot != placed.rot {
        edits.push(match entry.member("rot") {
            Some(member) => Edit { place: member.value, text: numbers(rot) },
            // Behind the position, which is there.
            None => {
                let place = TextRange::empty(at.range.end).in_file(at.file);
                Edit { place, text: format!(", \"rot\": {}", numbers(rot)) }
            }
        });
    }
    Some(edits)
}

/// Other places for objects, and another seed, as edits of the layout's text: of the numbers that change, and nothing else,
/// however the file is formatted. `None`: something else changes as well.
pub fn changing(layout: &LayoutFile, text: &str, to: &Layout) -> Option<Vec<Edit>> {
    let mut edits = Vec::new();
    if let Some(seed) = to.seed.filter(|seed| layout.read.layout.seed != Some(*seed)) {
        let MemberPlace { key, value } = layout.read.places.top.get("seed")?.place;
        let place = TextRange { start: key.range.start, end: value.range.end }.in_file(key.file);
        edits.push(Edit { place, text: format!("\"seed\": {seed}") });
    }
    for (name, placed) in &to.objects {
        edits.extend(placing(layout, name, placed.pos, placed.rot)?);
    }
    let own: Vec<Edit<TextRange>> = edits.iter().map(|e| Edit { place: e.place.range, text: e.text.clone() }).collect();
    let after = fix::apply(text, [own.as_slice()]);
    // What that makes of the file is what is wanted, to the rounding of the numbers.
    let read = scenelang_layout::file::read(&after.text, layout.file);
    let near = |a: &Layout| {
        let close = |((_, a), (_, b)): (&(_, Placement), &(_, Placement))| {
            (a.pos - b.pos).amax() < ROUNDED && (a.rot - b.rot).amax() < ROUNDED
        };
        a.objects.len() == to.objects.len() && a.objects.iter().zip(&to.objects).all(close)
    };
    let rest = |a: &Layout| {
        let mut rest = a.clone();
        rest.scene.clone_from(&to.scene);
        for ((name, own), (other, wanted)) in rest.objects.iter_mut().zip(&to.objects) {
            if name == other {
                (own.pos, own.rot) = (wanted.pos, wanted.rot);
            }
        }
        rest
    };
    (after.left.is_empty() && near(&read.layout) && rest(&read.layout) == *to).then_some(edits)
}

/// How far apart numbers are that are written alike.
const ROUNDED: f64 = 1e-6;

/// Three numbers as the layout file has them, to a tenth of a micrometre.
fn numbers(v: Vec3) -> String {
    let short = |x: f64| (x * 1e7).round() / 1e7 + 0.0;
    format!("[{}, {}, {}]", short(v.x), short(v.y), short(v.z))
}

/// The main file with every safe fix made, if there is any.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn all_safe(snapshot: &Snapshot) -> Result<Option<Edit>, Cancelled> {
    let own = |file: FileId| file == snapshot.main();
    let found = diagnostics(snapshot)?;
    let fixes = found.iter().flat_map(|f| f.diagnostic.fixes.iter().find(|fix| is_safe(fix.applicability)));
    let fixes = fixes.filter(|fix| fix.edits.iter().all(|e| own(e.place.file)));
    let edits: Vec<Vec<Edit<TextRange>>> = fixes
        .map(|fix| fix.edits.iter().map(|e| Edit { place: e.place.range, text: e.text.clone() }).collect())
        .collect();
    let text = snapshot.text();
    let applied = fix::apply(text, edits.iter().map(Vec::as_slice));
    let whole = TextRange::new(0, text.len()).in_file(snapshot.main());
    Ok((!applied.made.is_empty()).then_some(Edit { place: whole, text: applied.text }))
}
