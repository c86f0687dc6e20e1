//! W0201: declared, and nothing is said of it. W0202: a text is read that nothing has been assigned.

use super::facts::{DefinitionNode, Facts};
use super::sets;
use crate::ast::StmtKind;
use crate::items::ItemKind;
use crate::natives::ROOMS;
use scenelang_base::{Code, Diagnostic, codes};
use smol_str::SmolStr;

/// Whether an error of this code may hide that a name is used: text that was not read, a name that was misspelt.
pub fn may_hide_uses(code: Code) -> bool {
    let code = code.as_str();
    code.starts_with("E00") || code.starts_with("E01") || code == "E0201" || code == "E0206"
}

/// Names that are declared and never used.
pub fn names(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    let any = |such: fn(&StmtKind) -> bool| facts.statements.iter().any(|s| such(&s.place.stmt.kind));
    let stated = any(|kind| matches!(kind, StmtKind::Assert { .. } | StmtKind::Prefer { .. }));
    // Declarations alone are the beginning of a program, or made to be imported.
    if !stated && !any(|kind| matches!(kind, StmtKind::Assign { .. } | StmtKind::Allow { .. })) {
        return;
    }
    let all = facts.statements.iter().any(|s| s.uses.all) && facts.names.item("objects").is_none();
    let regions = facts.order.iter().filter(|(n, _)| facts.names.item(&n.text) == Some(ItemKind::Region)).count();
    let rooms = facts.read.contains_key(&SmolStr::new_static(ROOMS)) && facts.names.item(ROOMS).is_none();
    let mut blank = None;
    for (name, declared) in &facts.order {
        let name = &name.text;
        let named = facts.read.contains_key(name);
        let assigned = facts.assigned.contains_key(name);
        let Some(kind) = facts.names.item(name).filter(|_| !named && !facts.names.is_poisoned(name)) else { continue };
        let message = match kind {
            ItemKind::Object | ItemKind::Array(_) => {
                if assigned || all || *blank.get_or_insert_with(|| sets::keep_blank(facts)) {
                    continue;
                }
                format!("no statement uses `{name}`")
            }
            // The only region holds everything, whether anything is said of it or not.
            ItemKind::Region if assigned || regions == 1 || rooms => continue,
            ItemKind::Region => format!("no statement uses `{name}`"),
            // A file that is imported may define more than every importer needs.
            ItemKind::Variable(_) if facts.statements[*declared].place.file != facts.main => continue,
            ItemKind::Variable(_) if assigned && !stated => continue,
            ItemKind::Variable(_) if assigned => format!("`{name}` is assigned but never used"),
            ItemKind::Variable(_) => format!("`{name}` is never used"),
        };
        if let Some(at) = facts.declared_at(name) {
            let d = Diagnostic::new(codes::W0201, at, message);
            out.push(match kind {
                ItemKind::Variable(_) => d.note("use it in an assertion, or remove it"),
                ItemKind::Region => d.note("state what is inside it, or remove it"),
                _ => d.note("use it in a statement, or remove it"),
            });
        }
    }
}

/// Text properties that are read and never assigned.
pub fn texts(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    for linted in facts.statements.iter().filter(|s| s.sound) {
        let mut told = Vec::new();
        for read in &linted.uses.reads {
            let property = read.property.as_str();
            let (whose, assigned) = match &read.of {
                None => ("of any object".to_owned(), facts.properties.contains(property)),
                Some((name, element)) => {
                    let whole = facts.names.item(name);
                    let has = |property: &str| facts.has(name, *element, property);
                    // Of a region, the bare words mean the walls.
                    let walls = |bare: &str, wall: &str| {
                        whole == Some(ItemKind::Region)
                            && (property == bare || property == wall)
                            && (has(bare) || has(wall))
                    };
                    let known = matches!(whole, Some(ItemKind::Object | ItemKind::Array(_) | ItemKind::Region));
                    let index = element.map_or(String::new(), |i| format!("[{i}]"));
                    let assigned = has(property) || walls("color", "wallColor") || walls("material", "wallMaterial");
                    (format!("of `{name}{index}`"), assigned || !known)
                }
            };
            // Where no role is assigned, the category says it.
            let assigned = assigned || property == "role";
            if assigned || told.contains(&(&read.of, property)) {
                continue;
            }
            told.push((&read.of, property));
            if let Some(at) = linted.place.span(read.range) {
                let d = Diagnostic::new(codes::W0202, at, format!("the {property} {whose} is read but never assigned"));
                out.push(d.note("a text property that the program does not assign is `\"\"`"));
            }
        }
    }
}

/// W0303: assertions and preferences that no layout can change: they speak of no object, no region, and of no variable
/// that the solver chooses.
pub fn without_objects(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    let things = |s: &super::Linted<'_>| {
        let uses = s.uses;
        uses.broken || uses.all || uses.names.iter().any(|n| facts.is_thing(&n.text) || facts.is_chosen(&n.text))
    };
    // What variables and predicates stand for is looked at only if there is a statement that it matters for.
    let mut reached = None;
    for linted in facts.statements.iter().filter(|s| s.sound && !things(s)) {
        let (formula, word) = match &linted.place.stmt.kind {
            StmtKind::Assert { formula } => (*formula, "assertion"),
            StmtKind::Prefer { formula, .. } => (*formula, "preference"),
            _ => continue,
        };
        let reached = reached.get_or_insert_with(|| facts.closure(things));
        let through = linted.uses.names.iter().any(|n| reached.contains(&DefinitionNode::Variable(&n.text)))
            || linted.uses.calls.iter().any(|c| reached.contains(&DefinitionNode::Predicate(c)));
        let expr = linted.place.stmt.expr(formula);
        let dead = linted.dead;
        if !through
            && !dead
            && let Some(at) = linted.place.span(expr.range)
        {
            let d = Diagnostic::new(codes::W0303, at, format!("this {word} mentions no object and no region"));
            out.push(
                d.note("its result is the same in every layout: mention the object that it is about, or remove it"),
            );
        }
    }
}
