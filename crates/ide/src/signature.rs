//! What a call takes, and which argument is being written.

use crate::Snapshot;
use crate::hover::{documentation, head_of};
use scenelang_lang::ast::{Param, Stmt, StmtKind};
use scenelang_lang::db::Cancelled;
use scenelang_lang::library;
use scenelang_lang::natives;
use scenelang_lang::syntax::{context_at, parse};
use scenelang_lang::types::Ty;

/// One way to call something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// All of it: `near(Object a, Object b, Number d)`.
    pub label: String,
    /// Its parameters: parts of the label.
    pub params: Vec<String>,
    /// What it does.
    pub doc: String,
}

/// The ways to call what is being called at an offset, which of them fits best, and the argument that the offset is in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Help {
    /// The ways.
    pub signatures: Vec<Signature>,
    /// The first that takes as many arguments as there are.
    pub active: usize,
    /// The argument, from 0.
    pub argument: usize,
}

/// What is being called at an offset.
///
/// # Errors
/// [`Cancelled`]: the text has changed.
pub fn help(snapshot: &Snapshot, offset: u32) -> Result<Option<Help>, Cancelled> {
    let text = snapshot.text();
    let Some(call) = context_at(&parse(text), offset).call else { return Ok(None) };
    let Some(callee) = text.get(call.callee.bytes()) else { return Ok(None) };
    let signatures = signatures(snapshot, callee)?;
    if signatures.is_empty() {
        return Ok(None);
    }
    let enough = |s: &Signature| s.params.len() > call.argument || s.params.last().is_some_and(|p| p == "…");
    let active = signatures.iter().position(enough).unwrap_or(0);
    let most = signatures[active].params.len().saturating_sub(1);
    Ok(Some(Help { active, argument: call.argument.min(most), signatures }))
}

/// The ways to call a name.
fn signatures(snapshot: &Snapshot, callee: &str) -> Result<Vec<Signature>, Cancelled> {
    let allowance = |label: &str, params: &[&str], doc: &str| {
        vec![Signature {
            label: label.into(),
            params: params.iter().map(|p| (*p).to_owned()).collect(),
            doc: doc.into(),
        }]
    };
    Ok(match callee {
        "allowCollide" => {
            allowance("allowCollide(a, b)", &["a", "b"], "These objects, or arrays, may overlap each other.")
        }
        "allowOutside" => allowance("allowOutside(a)", &["a"], "This object may be outside every region."),
        "allowFloat" => allowance("allowFloat(a)", &["a"], "This object needs no support."),
        _ if natives::is_built_in(callee) => natives::overloads(callee)
            .map(|s| {
                let label = head_of(s);
                let inner =
                    label.split_once('(').and_then(|(_, rest)| rest.split_once(')')).map_or("", |(inner, _)| inner);
                let params = inner.split(", ").map(str::to_owned).collect();
                Signature { params, doc: s.doc.to_owned(), label }
            })
            .collect(),
        _ => {
            let meanings = snapshot.meanings()?;
            if let Some(span) = meanings.defined.get(callee) {
                let other = snapshot.analysis().meanings(span.file)?;
                let found = other.statements.iter().find_map(|(place, _)| match &place.stmt.kind {
                    StmtKind::Predicate { name, params, .. } if name.text == callee => {
                        Some(of_predicate(callee, params, place.stmt))
                    }
                    _ => None,
                });
                return Ok(found.into_iter().collect());
            }
            let library = library::predicates().get(callee);
            library.map(|p| of_predicate(callee, p.params, p.place.stmt)).into_iter().collect()
        }
    })
}

fn of_predicate(name: &str, params: &[Param], stmt: &Stmt) -> Signature {
    let params: Vec<String> = params.iter().map(|p| format!("{} {}", Ty::of(p.ty).name(), p.name.text)).collect();
    let doc = documentation(stmt).trim().to_owned();
    Signature { label: format!("{name}({})", params.join(", ")), params, doc }
}
