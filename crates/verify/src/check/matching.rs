//! A layout against its program: names that only one of them knows, values of the wrong kind, outlines that the program
//! does not leave open.

use rustc_hash::FxHashSet;
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, codes};
use scenelang_lang::program::{Object, Program, VariableKind};
use scenelang_layout::file::{Block, Entry, LARGEST};
use scenelang_layout::{DecisionValue, Layout, Places, ReadLayout};
use smol_str::SmolStr;

/// So many entries of a block are told of.
const MOST: usize = 100;

/// What is wrong, in the order of the file.
pub fn check(program: &Program, read: &ReadLayout) -> Vec<Diagnostic> {
    let (layout, places) = (&read.layout, &read.places);
    let mut out = Vec::new();
    let objects: Vec<&SmolStr> = program.objects.iter().map(|o| &o.name).collect();
    let regions: Vec<&SmolStr> = program.regions.iter().map(|r| &r.name).collect();
    unknown(program, "object", &places.objects, &objects, &regions, &mut out);
    unknown(program, "region", &places.regions, &regions, &objects, &mut out);
    missing("object", "objects", read, &places.objects, &objects, &mut out);
    missing("region", "regions", read, &places.regions, &regions, &mut out);
    for region in program.regions.iter().filter(|r| r.has_scale && !r.has_vertices) {
        if let Some(vertices) = places.regions.get(&region.name).and_then(|entry| entry.member("vertices")) {
            let say =
                format!("`{}` has a `scale` in the program, so the layout cannot give it `vertices`", region.name);
            let finding = Diagnostic::new(codes::E0512, vertices.key, say).related(region.span, "declared here");
            out.push(finding.note("assign `vertices` in the program instead, if it is not a rectangle"));
        }
    }
    variables(program, layout, places, &mut out);
    out.sort_by_key(|d| d.primary.as_ref().map(|l| l.place.range.start));
    out
}

/// Entries that the program does not know.
fn unknown(
    program: &Program,
    what: &str,
    block: &Block,
    own: &[&SmolStr],
    other: &[&SmolStr],
    out: &mut Vec<Diagnostic>,
) {
    let known: FxHashSet<&str> = own.iter().map(|name| name.as_str()).collect();
    let strangers: Vec<&Entry> = block.iter().filter(|entry| !known.contains(entry.name.as_str())).take(MOST).collect();
    // Against thousands of names a slip of the pen is not worth the search.
    let free = own.iter().map(|name| name.as_str()).filter(|name| block.get(name).is_none()).take(MOST * 10);
    let free: Vec<&str> = if strangers.is_empty() { Vec::new() } else { free.collect() };
    for Entry { name, place, .. } in strangers {
        let base = name.split('[').next().unwrap_or(name);
        let of_array = |o: &&Object| o.array.as_ref().is_some_and(|(array, _)| array == base);
        let elements: Vec<&Object> = program.objects.iter().filter(of_array).collect();
        let finding = |say: String| Diagnostic::new(codes::E0506, place.key, say);
        out.push(if let Some(last) = elements.last() {
            let say = if base == name {
                format!(
                    "`{name}` is an array, not an object; its elements are `{}` to `{}`",
                    elements[0].name, last.name
                )
            } else {
                format!("the program has no `{name}`: the array `{base}` ends with `{}`", last.name)
            };
            finding(say).related(last.span, "declared here")
        } else if other.contains(&name) {
            let (is, there) = if what == "object" { ("a region", "regions") } else { ("an object", "objects") };
            finding(format!("`{name}` is {is}: it belongs under \"{there}\""))
        } else {
            let finding = finding(format!("the program has no {what} `{name}`"));
            match nearest(name, free.iter().copied()) {
                Some(near) => {
                    let (title, key) = (format!("did you mean `{near}`?"), serde_json::Value::from(near));
                    finding.fix(Applicability::Unsafe, title, place.key, key.to_string())
                }
                None => finding.note(format!("remove it from the layout, or declare it: `{what} {base};`")),
            }
        });
    }
}

/// What the program has and the layout lacks, all of a kind in one diagnostic.
fn missing(what: &str, key: &str, read: &ReadLayout, block: &Block, own: &[&SmolStr], out: &mut Vec<Diagnostic>) {
    const NAMED: usize = 8;
    let lacking: Vec<&SmolStr> = own.iter().copied().filter(|name| block.get(name).is_none()).collect();
    if lacking.is_empty() || is_spoilt(read, key, block) {
        return;
    }
    let mut names: Vec<String> = lacking.iter().take(NAMED).map(|name| format!("`{name}`")).collect();
    if lacking.len() > NAMED {
        names.push(format!("{} more", lacking.len() - NAMED));
    }
    let plural = if lacking.len() > 1 { "s" } else { "" };
    let message = format!("{what}{plural} missing from the layout: {}", names.join(", "));
    out.push(Diagnostic::new(codes::E0507, read.places.block(key), message).note(format!(
        "statements that depend on the missing {what}{plural} cannot be checked; all others are checked"
    )));
}

/// Whether a block could not be read, which has been told of.
fn is_spoilt(read: &ReadLayout, key: &str, block: &Block) -> bool {
    let Some(entry) = read.places.top.get(key) else { return false };
    let within = |d: &Diagnostic| {
        let at = d.primary.as_ref().map(|label| label.place.range.start);
        at.is_some_and(|at| entry.place.value.range.bytes().contains(&(at as usize)))
    };
    block.iter().next().is_none() && read.diagnostics.iter().any(within)
}

fn variables(program: &Program, layout: &Layout, places: &Places, out: &mut Vec<Diagnostic>) {
    for entry in places.variables.iter().take(MOST) {
        let Some(variable) = program.variables.iter().find(|v| v.name == entry.name) else {
            if !program.assigned_variables.contains(&entry.name) {
                let message = format!("the program has no variable `{}`", entry.name);
                let finding = Diagnostic::new(codes::E0506, entry.place.key, message);
                let free = program.variables.iter().filter(|v| places.variables.get(&v.name).is_none());
                out.push(match nearest(&entry.name, free.map(|v| v.name.as_str())) {
                    Some(near) => finding.note(format!("did you mean `{near}`?")),
                    None => finding,
                });
            }
            continue;
        };
        let value = layout.variables.iter().find(|(name, _)| *name == entry.name).map(|(_, value)| *value);
        let (fits, wanted) = match variable.kind {
            VariableKind::Number => (matches!(value, Some(DecisionValue::Number(_))), "a number"),
            VariableKind::Degree => (matches!(value, Some(DecisionValue::Number(_))), "a number of degrees"),
            VariableKind::Bool => (matches!(value, Some(DecisionValue::Bool(_))), "true or false"),
            VariableKind::Vector => (matches!(value, Some(DecisionValue::Triple(_))), "three numbers"),
            VariableKind::Rotation => (matches!(value, Some(DecisionValue::Triple(_))), "three numbers of degrees"),
        };
        let large = match value {
            Some(DecisionValue::Number(n)) => n.abs() > LARGEST,
            Some(DecisionValue::Triple(t)) => t.iter().any(|n| n.abs() > LARGEST),
            _ => false,
        };
        let finding = if !fits {
            Diagnostic::new(codes::E0504, entry.place.value, format!("`{}` must be {wanted}", entry.name))
        } else if large {
            Diagnostic::new(codes::E0505, entry.place.value, format!("`{}` must not exceed a million", entry.name))
        } else {
            continue;
        };
        out.push(finding.related(variable.span, "declared here"));
    }
}
