//! A layout against its program: names that only one of them knows, values of the wrong kind, outlines that the program
//! does not leave open.

use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, codes};
use scenelang_lang::program::{Program, VariableKind};
use scenelang_layout::file::{Block, Entry, LARGEST};
use scenelang_layout::{Layout, Places, ReadLayout, Value};
use smol_str::SmolStr;

/// What is wrong, in the order of the file.
pub(super) fn check(program: &Program, read: &ReadLayout) -> Vec<Diagnostic> {
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
            let say = format!("`{}` has a `scale` in the program, so the layout gives it no `vertices`", region.name);
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
    let known: rustc_hash::FxHashSet<&str> = own.iter().map(|name| name.as_str()).collect();
    for Entry { name, place, .. } in block.iter().filter(|entry| !known.contains(entry.name.as_str())) {
        let size = program.objects.iter().filter(|o| o.array.as_ref().is_some_and(|(array, _)| array == name)).count();
        let array = name.split('[').next().and_then(|base| {
            let length = |o: &&scenelang_lang::program::Object| o.array.as_ref().is_some_and(|(array, _)| array == base);
            Some((base, program.objects.iter().filter(length).count())).filter(|(_, n)| *n > 0)
        });
        let mut finding = if size > 0 {
            let say = format!("`{name}` is an array, no object: its elements are `{name}[0]` to `{name}[{}]`", size - 1);
            Diagnostic::new(codes::E0506, place.key, say)
        } else if let Some((base, n)) = array {
            let say = format!("the program has no `{name}`: the array `{base}` ends with `{base}[{}]`", n - 1);
            Diagnostic::new(codes::E0506, place.key, say)
        } else if other.contains(&name) {
            let (is, there) = if what == "object" { ("a region", "regions") } else { ("an object", "objects") };
            Diagnostic::new(codes::E0506, place.key, format!("`{name}` is {is}: it belongs under \"{there}\""))
        } else {
            let finding = Diagnostic::new(codes::E0506, place.key, format!("the program has no {what} `{name}`"));
            let free = own.iter().filter(|name| block.get(name).is_none()).map(|name| name.as_str());
            match nearest(name, free) {
                Some(near) => finding.fix(
                    Applicability::Unsafe,
                    format!("did you mean `{near}`?"),
                    place.key,
                    serde_json::Value::from(near).to_string(),
                ),
                None => finding,
            }
        };
        let array_span = program.objects.iter().find(|o| o.array.as_ref().is_some_and(|(a, _)| name.starts_with(a.as_str())));
        if let Some(object) = array_span.filter(|_| size > 0 || array.is_some()) {
            finding = finding.related(object.span, "declared here");
        }
        out.push(finding);
    }
}

/// What the program has and the layout lacks, all of a kind in one diagnostic.
fn missing(what: &str, key: &str, read: &ReadLayout, block: &Block, own: &[&SmolStr], out: &mut Vec<Diagnostic>) {
    const MOST: usize = 8;
    let lacking: Vec<&SmolStr> = own.iter().copied().filter(|name| block.get(name).is_none()).collect();
    if lacking.is_empty() || is_spoilt(read, key, block) {
        return;
    }
    let mut names: Vec<String> = lacking.iter().take(MOST).map(|name| format!("`{name}`")).collect();
    if lacking.len() > MOST {
        names.push(format!("{} more", lacking.len() - MOST));
    }
    let plural = if lacking.len() > 1 { "s" } else { "" };
    let message = format!("the layout lacks the {what}{plural} {}", names.join(", "));
    out.push(
        Diagnostic::new(codes::E0507, read.places.block(key), message)
            .note(format!("what depends on the missing {what}{plural} is not judged; all else is")),
    );
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
    for entry in places.variables.iter() {
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
            VariableKind::Number => (matches!(value, Some(Value::Number(_))), "a number"),
            VariableKind::Degree => (matches!(value, Some(Value::Number(_))), "a number of degrees"),
            VariableKind::Bool => (matches!(value, Some(Value::Bool(_))), "true or false"),
            VariableKind::Vector => (matches!(value, Some(Value::Triple(_))), "three numbers"),
            VariableKind::Rotation => (matches!(value, Some(Value::Triple(_))), "three numbers of degrees"),
        };
        let large = match value {
            Some(Value::Number(n)) => n.abs() > LARGEST,
            Some(Value::Triple(t)) => t.iter().any(|n| n.abs() > LARGEST),
            _ => false,
        };
        let finding = if !fits {
            Diagnostic::new(codes::E0504, entry.place.value, format!("`{}` takes {wanted}", entry.name))
        } else if large {
            Diagnostic::new(codes::E0505, entry.place.value, format!("`{}` is beyond a million", entry.name))
        } else {
            continue;
        };
        out.push(finding.related(variable.span, "declared here"));
    }
}
