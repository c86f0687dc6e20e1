//! W0305: `not inside(a, r)`, which keeps a out of r and does not say where it is.

use super::facts::Facts;
use crate::ast::StmtKind;
use crate::items::ItemKind;
use rustc_hash::FxHashSet;
use scenelang_base::{Diagnostic, codes};
use smol_str::SmolStr;

/// Looks at all assertions. Whoever is brought together with another region, or has a place, is somewhere.
pub fn check(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    if facts.statements.iter().all(|s| s.uses.kept_out.is_empty()) {
        return;
    }
    let is_region = |name: &SmolStr| facts.names.item(name) == Some(ItemKind::Region);
    let mut somewhere: FxHashSet<&SmolStr> = FxHashSet::default();
    for linted in facts.statements {
        for names in linted.uses.together.iter().filter(|names| names.iter().any(is_region)) {
            somewhere.extend(names);
        }
        if let StmtKind::Assign { name, path, .. } = &linted.place.stmt.kind
            && path.first().is_some_and(|p| p.text == "pos")
        {
            somewhere.insert(&name.text);
        }
    }
    for linted in facts.statements.iter().filter(|s| s.sound) {
        for (object, region, range) in &linted.uses.kept_out {
            if !is_region(region) || object.as_ref().is_some_and(|o| somewhere.contains(o)) {
                continue;
            }
            let who = object.as_ref().map_or("this".to_owned(), |o| format!("`{o}`"));
            let message = format!("{who} is kept out of `{region}`, but no statement says where it should be");
            if let Some(at) = linted.place.span(*range) {
                let d = Diagnostic::new(codes::W0305, at, message);
                out.push(d.note("assert which region it is in: `inside(…, …)`"));
            }
        }
    }
}
