//! W0203: a quantifier's variable or a parameter with the name of something else, which cannot be reached inside.

use super::facts::Facts;
use super::scope::Scopes;
use crate::check::Where;
use scenelang_base::{Diagnostic, codes};

/// Names that hide one that the same statement binds further out.
pub fn within(scopes: &Scopes<'_>, out: &mut Vec<Diagnostic<Where>>) {
    for (inner, outer) in &scopes.hiding {
        let message = format!("`{}` shadows the outer `{}`", inner.text, inner.text);
        let d = Diagnostic::new(codes::W0203, Where::Here(inner.range), message)
            .related(Where::Here(outer.range), "the one that is shadowed")
            .note("give one of them another name");
        out.push(d);
    }
}

/// Names that hide something declared. A file that is imported cannot know what its importers declare: it is held
/// against itself only.
pub fn declared(facts: &Facts<'_>, out: &mut Vec<Diagnostic>) {
    for linted in facts.statements {
        for name in &linted.uses.bound {
            let Some(declared) = facts.declared(&name.text) else { continue };
            if linted.place.file != facts.main && linted.place.file != declared.place.file {
                continue;
            }
            let (Some(at), Some(hidden)) = (linted.place.span(name.range), facts.declared_at(&name.text)) else {
                continue;
            };
            let message = format!("`{}` shadows the {} of the same name", name.text, facts.what(&name.text));
            let d = Diagnostic::new(codes::W0203, at, message).related(hidden, "declared here");
            out.push(d.note("give one of them another name; the outer one cannot be used here"));
        }
    }
}
