//! What could be written: the labels that must be there, in which order the first ones are, and what must not be there.

use crate::fixture::{Fixture, imports};
use scenelang_ide::completion::{Proposals, complete, describe};

fn proposed(lines: &str) -> (Fixture, Proposals) {
    let fixture = Fixture::with(lines);
    let found = complete(&fixture.snapshot, &imports, fixture.at, true).unwrap();
    (fixture, found)
}

/// Line, first label, others, never.
const PROPOSED: &[(&str, &str, &str, &str)] = &[
    ("ass$0", "", "assert object region prefer bed", "near true"),
    ("$0", "", "assert object @req", "near"),
    ("object $0", "", "", "bed assert"),
    ("// as$0", "", "", "assert bed"),
    ("/* as$0 */", "", "", "assert bed"),
    ("\"as$0\"", "", "", "assert bed"),
    ("assert $0", "", "bed room near inside forall", "assert object"),
    ("assert bed.$0", "", "pos top category color", "floor bed x"),
    ("assert room.$0;", "", "floor area vertices", "category top"),
    ("assert bed.pos.$0", "x", "y z", "pos bed"),
    ("assert forall c in stand: c.$0", "", "pos top", "floor"),
    ("assert forall c in objects where .$0", "category", "color material features", "pos"),
    ("assert forall c $0", "in", "and", "bed"),
    ("assert near($0", "bed", "lamp stand room", "front true"),
    ("assert inside(bed, $0", "", "room lamp", "front"),
    ("assert againstWall(bed, $0", "room", "", "front"),
    ("assert clear(bed, $0", "above", "behind front left right", "bed near"),
    ("allowCollide($0", "bed", "lamp stand", "near"),
    ("bed.$0", "", "pos rot color", "floor"),
    ("bed.color <- \"ste$0\";", "", "steelblue red", "bed assert"),
    ("bed.material <- \"$0\";", "", "oak", "assert"),
    ("bed.color <- oneOf(\"red\", \"ste$0\");", "", "steelblue red", "bed assert"),
    ("bed.color <- o$0", "", "oneOf", ""),
    ("bed.category <- \"$0\";", "", "sofa bed", "assert"),
    ("import \"$0\";", "parts.scene", "", "room.scene bed"),
    ("predicate p($0", "", "Object Region Number", "bed"),
    ("assert bed.top > 30c$0", "30cm", "", "bed 30m"),
    ("assert bed.top $0", "", "and or implies", "bed"),
    ("prefer bed.top > 1 $0", "", "weight and", "bed"),
];

fn wrong(line: &str, whole: &str, first: &str, others: &str, never: &str) -> Option<String> {
    let (fixture, found) = proposed(whole);
    let labels: Vec<&str> = found.list.iter().map(|p| p.label.as_str()).collect();
    let replaced = fixture.slice(found.replaces);
    assert!(
        !replaced.contains('\n') && found.replaces.start <= fixture.at && fixture.at <= found.replaces.end,
        "{line}"
    );
    let missing = others.split_whitespace().find(|w| !labels.contains(w)).map(|w| format!("no {w}"));
    let there = never.split_whitespace().find(|w| labels.contains(w)).map(str::to_owned);
    let begins = first.is_empty() || labels.first() == Some(&first);
    let bad = missing.or(there).or((!begins).then(|| format!("not {first} first")))?;
    Some(format!("{line}: {bad}: {:?}", &labels[..labels.len().min(30)]))
}

#[test]
fn in_front_of_another_statement() {
    let found = PROPOSED.iter().filter_map(|(l, f, o, n)| wrong(l, &format!("\n{l}\nobject last;\n"), f, o, n));
    assert_eq!(found.collect::<Vec<_>>(), [""; 0]);
}

/// At the end of a file nothing follows that would tell that a statement goes on; and blanks belong to what is not over.
#[test]
fn at_the_end_of_the_file() {
    let found = PROPOSED.iter().filter_map(|(l, f, o, n)| wrong(l, &format!("\n{l}"), f, o, n));
    assert_eq!(found.collect::<Vec<_>>(), [""; 0]);
    for line in [
        "assert near(bed, $0",
        "assert bed.top > $0",
        "assert bed.top >\n  $0",
        "assert not $0",
        "assert bed.top + $0",
        "assert near(bed, lamp, 1) and $0",
        "assert forall c in $0",
        "assert forall c in stand: $0",
        "prefer $0",
        "assert ($0",
        "bed.pos <- vec3(1, $0",
        "lamp.top <- $0",
    ] {
        let (_, found) = proposed(&format!("\n{line}"));
        let keywords = ["object", "region", "assert", "prefer", "predicate", "import", "allowCollide", "@req"];
        let wrong: Vec<&str> = found.list.iter().map(|p| p.label.as_str()).filter(|l| keywords.contains(l)).collect();
        assert_eq!(wrong, [""; 0], "{line}");
        assert!(!found.list.is_empty(), "{line}");
    }
}

#[test]
fn half_of_a_requirement_is_a_word() {
    for (lines, replaced) in [
        ("\n@$0", "@"),
        ("\n@re$0", "@re"),
        ("\n@re$0\nobject x;", "@re"),
        ("\n@req(\"a\") @r$0", "@r"),
        ("\n@r$0eq(\"a\") object x;", "@req"),
    ] {
        let (fixture, found) = proposed(lines);
        let own = found.list.iter().find(|p| p.label == "@req").unwrap_or_else(|| panic!("{lines}"));
        assert_eq!(
            (fixture.slice(found.replaces), own.snippet.as_deref()),
            (replaced, Some("@req(\"$1\")")),
            "{lines}"
        );
    }
    let (_, found) = proposed("\nassert bed.top @re$0");
    assert!(found.list.iter().all(|p| p.label != "@req"), "not within a statement");
}

#[test]
fn units_only_where_somebody_asks() {
    let fixture = Fixture::with("assert bed.top > 3$0\n");
    assert_eq!(complete(&fixture.snapshot, &imports, fixture.at, false).unwrap().list, []);
    assert!(complete(&fixture.snapshot, &imports, fixture.at, true).unwrap().list.iter().any(|p| p.label == "3cm"));
}

#[test]
fn what_is_said_of_a_proposal() {
    assert!(describe("library near").unwrap().contains("predicate near(Object a, Object b, Number d)"));
    assert!(describe("builtin gap").unwrap().contains("gap(Object a, Object b) -> Number"));
    assert_eq!(describe("own low"), None);
}
