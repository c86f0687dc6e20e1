//! W0306: templates of messages that cannot be used. Reports then show the plain text of the comparison.

use super::scope::Scopes;
use crate::ast::{Stmt, StmtKind, TypeWord};
use crate::check::Where;
use crate::wording::{MARK, Template, TemplatePiece, Term, comparisons, lines};
use scenelang_base::{Diagnostic, codes};

/// Looks at the templates of a predicate.
pub fn check(stmt: &Stmt, scopes: &Scopes<'_>, out: &mut Vec<Diagnostic<Where>>) {
    let StmtKind::Predicate { name, params, .. } = &stmt.kind else { return };
    if !stmt.doc.contains(MARK) {
        return;
    }
    let mut say = |message: String| {
        let d = Diagnostic::new(codes::W0306, Where::Here(name.range), message);
        out.push(d.note("reports show the text of the comparison instead"));
    };
    let (templates, places) = (lines(&stmt.doc).count(), comparisons(stmt).len());
    if templates > places {
        say(format!("there are more templates ({templates}) than comparisons ({places})"));
    }
    for text in lines(&stmt.doc).take(places).flatten() {
        let template = match Template::parse(text) {
            Ok(template) => template,
            Err(why) => {
                say(format!("a template has {why}"));
                continue;
            }
        };
        let in_sums = |index: usize| {
            let is_it = |(_, term): &(bool, Term)| *term == Term::Name(index);
            template.pieces.iter().any(|p| matches!(p, TemplatePiece::Value { terms, .. } if terms.iter().any(is_it)))
        };
        for (index, word) in template.names.iter().enumerate() {
            let number = |ty: TypeWord| matches!(ty, TypeWord::Number | TypeWord::Degree);
            let shown = |ty: TypeWord| number(ty) || matches!(ty, TypeWord::Object | TypeWord::Region);
            match params.iter().find(|p| p.name.text == *word) {
                Some(p) if in_sums(index) && !number(p.ty) => say(format!("`{word}` in a template is not a number")),
                Some(p) if !shown(p.ty) => {
                    say(format!("`{word}` in a template is not an object, a region or a number"))
                }
                Some(_) => {}
                None if scopes.bound.iter().any(|bound| bound.text == *word) => {}
                None => say(format!("`{word}` in the `Measured:` template is not a parameter of the predicate")),
            }
        }
    }
}
