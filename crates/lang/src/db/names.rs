//! What is declared, defined, assigned and imported, without a word on where it stands in the text.

use super::runs::{File, Run, Sources, parsed, placed_runs};
use crate::ast::{ExprKind, Stmt, StmtKind, TypeWord};
use crate::check::cycles;
use crate::items::{AssignKey, ItemKind, Names, PredicateHead, array_size, head_of, whole_number};
use crate::types::Ty;
use crate::{library, natives};
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_base::TextRange;
use smol_str::SmolStr;

/// A statement: its file, its run in it, its place among the run's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct At {
    pub unit: u32,
    pub run: u32,
    pub stmt: u32,
}

/// What a statement contributes to the names of the program.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Head {
    Declares {
        name: SmolStr,
        kind: ItemKind,
    },
    Defines {
        name: SmolStr,
        head: PredicateHead,
        /// Predicates that its body calls.
        calls: Vec<SmolStr>,
    },
    Assigns {
        name: SmolStr,
        /// The index as a whole number, if there is an index and it is one.
        index: Option<Option<u32>>,
        /// Empty for a variable.
        property: SmolStr,
        /// Names on the right side of a variable's.
        reads: Vec<SmolStr>,
    },
    Imports {
        path: String,
    },
    /// It did not parse; these are its words.
    Broken {
        words: Vec<SmolStr>,
    },
}

/// The heads of a run, each with its statement.
#[salsa::interned]
pub(crate) struct Heads<'db> {
    #[returns(deref)]
    pub list: Vec<(u32, Head)>,
}

#[salsa::tracked(returns(copy))]
fn heads<'db>(db: &'db dyn salsa::Database, run: Run<'db>) -> Heads<'db> {
    let statements = &parsed(db, run).statements;
    let list = statements.iter().enumerate().filter_map(|(i, (offset, stmt))| {
        let text = |range: TextRange| &run.text(db)[range.shifted(*offset).bytes()];
        Some((i as u32, head(stmt, text)?))
    });
    Heads::new(db, list.collect::<Vec<_>>())
}

fn head<'t>(stmt: &Stmt, text: impl Fn(TextRange) -> &'t str) -> Option<Head> {
    Some(match &stmt.kind {
        StmtKind::Declare { ty, name, size, .. } => {
            let kind = match (ty, size) {
                (TypeWord::Object, Some(size)) => {
                    ItemKind::Array(array_size(stmt, *size).unwrap_or_else(|e| e.assumed))
                }
                (TypeWord::Object, None) => ItemKind::Object,
                (TypeWord::Region, _) => ItemKind::Region,
                (word, _) => ItemKind::Variable(Ty::of(*word)),
            };
            Head::Declares { name: name.text.clone(), kind }
        }
        StmtKind::Predicate { name, params, body } => {
            let calls = stmt.exprs.iter().filter_map(|e| match &e.kind {
                ExprKind::Call(name, _) => Some(name.text.clone()),
                _ => None,
            });
            let head = head_of(stmt, params, *body, false);
            Head::Defines { name: name.text.clone(), head, calls: calls.collect() }
        }
        StmtKind::Assign { name, index, path, .. } => {
            let property = match path.as_slice() {
                [] => SmolStr::default(),
                [property] => property.text.clone(),
                _ => return None,
            };
            let whole = |i| whole_number(stmt, i).filter(|i| (0.0..=f64::from(u32::MAX)).contains(i)).map(|i| i as u32);
            let mut reads = Vec::new();
            if path.is_empty() {
                for e in &stmt.exprs {
                    if let ExprKind::Name(n) = &e.kind
                        && !reads.contains(n)
                    {
                        reads.push(n.clone());
                    }
                }
            }
            Head::Assigns { name: name.text.clone(), index: index.map(whole), property, reads }
        }
        // A path without quotation marks has been reported.
        StmtKind::Import { path, range } if text(*range).starts_with('"') => Head::Imports { path: path.clone() },
        StmtKind::Error => {
            let word = |c: char| c == '_' || c.is_alphanumeric();
            let words = text(stmt.range).split(|c| !word(c)).filter(|w| !w.is_empty());
            Head::Broken { words: words.map(SmolStr::new).collect() }
        }
        _ => return None,
    })
}

/// The heads of a file's runs, in order. After an edit inside an assertion it is what it was.
#[salsa::tracked]
pub(crate) fn outline<'db>(db: &'db dyn salsa::Database, file: File) -> Vec<Heads<'db>> {
    placed_runs(db, file).iter().map(|(_, run)| heads(db, *run)).collect()
}

/// All heads of the program.
fn all_heads(db: &dyn salsa::Database, sources: Sources) -> impl Iterator<Item = (At, &Head)> {
    sources.files(db).iter().enumerate().flat_map(move |(unit, file)| {
        outline(db, *file).iter().enumerate().flat_map(move |(run, heads)| {
            let at = move |stmt| At { unit: unit as u32, run: run as u32, stmt };
            heads.list(db).iter().map(move |(stmt, head)| (at(*stmt), head))
        })
    })
}

/// What was declared, defined or assigned already.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Twice {
    /// What: a name, or a property of one.
    pub what: String,
    pub first: At,
    pub again: At,
}

/// The declared names of the program.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct NameTable {
    /// Names of objects, regions and variables, in order of declaration, each once.
    pub order: Vec<SmolStr>,
    pub items: FxHashMap<SmolStr, (ItemKind, At)>,
    pub predicates: FxHashMap<SmolStr, (PredicateHead, At)>,
    /// Names that are assigned as variables are.
    assigned: FxHashSet<SmolStr>,
    /// Names that stand in statements that did not parse: not reported as unknown.
    poisoned: FxHashSet<SmolStr>,
    /// Objects, regions and variables declared again; predicates defined again.
    pub declared_twice: Vec<Twice>,
    pub defined_twice: Vec<Twice>,
}

#[salsa::tracked]
pub(crate) fn names(db: &dyn salsa::Database, sources: Sources) -> NameTable {
    let mut table = NameTable::default();
    let bundled = |at: At| sources.files(db)[at.unit as usize].bundled(db);
    for (at, head) in all_heads(db, sources) {
        match head {
            Head::Declares { name, kind } => match table.items.get(name) {
                Some((_, first)) => {
                    table.declared_twice.push(Twice { what: name.to_string(), first: *first, again: at });
                }
                None => {
                    table.order.push(name.clone());
                    table.items.insert(name.clone(), (*kind, at));
                }
            },
            Head::Defines { name, .. } if natives::is_built_in(name) => {}
            Head::Defines { name, head, .. } => match table.predicates.get(name) {
                // What the program defines hides what it imports of the library.
                Some((_, first)) if bundled(at) && !bundled(*first) => {}
                Some((_, first)) if bundled(*first) && !bundled(at) => {
                    table.predicates.insert(name.clone(), (head.clone(), at));
                }
                Some((_, first)) => {
                    table.defined_twice.push(Twice { what: name.to_string(), first: *first, again: at });
                }
                None => {
                    table.predicates.insert(name.clone(), (head.clone(), at));
                }
            },
            Head::Assigns { name, property, .. } if property.is_empty() => {
                table.assigned.insert(name.clone());
            }
            Head::Broken { words } => table.poisoned.extend(words.iter().cloned()),
            Head::Assigns { .. } | Head::Imports { .. } => {}
        }
    }
    table
}

/// What is assigned, and where.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Assignments {
    /// For an array assigned by its bare name, one entry for each element.
    pub by_key: FxHashMap<AssignKey, At>,
    pub twice: Vec<Twice>,
}

#[salsa::tracked]
pub(crate) fn assignments(db: &dyn salsa::Database, sources: Sources) -> Assignments {
    let mut out = Assignments::default();
    let items = &names(db, sources).items;
    for (at, head) in all_heads(db, sources) {
        let Head::Assigns { name, index, property, .. } = head else { continue };
        let Some((kind, _)) = items.get(name) else { continue };
        let elements: Vec<Option<u32>> = match (kind, index) {
            (ItemKind::Array(n), None) => (0..*n).map(Some).collect(),
            (ItemKind::Array(n), Some(Some(i))) if i < n => vec![Some(*i)],
            (ItemKind::Array(_), Some(_)) => continue,
            _ => vec![None],
        };
        let mut first = None;
        for element in elements {
            let key = AssignKey { name: name.clone(), element, property: property.clone() };
            match out.by_key.get(&key) {
                Some(at) => first = first.or(Some(*at)),
                None => {
                    out.by_key.insert(key, at);
                }
            }
        }
        if let Some(first) = first {
            let what = if property.is_empty() { name.to_string() } else { format!("{name}.{property}") };
            out.twice.push(Twice { what, first, again: at });
        }
    }
    out
}

/// Definitions that go in a circle, each as its members in the order they refer to each other.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Circles {
    pub variables: Vec<Vec<(SmolStr, At)>>,
    pub predicates: Vec<Vec<(SmolStr, At)>>,
}

#[salsa::tracked]
pub(crate) fn circles(db: &dyn salsa::Database, sources: Sources) -> Circles {
    let table = names(db, sources);
    let assigned = assignments(db, sources);
    let mut reads: FxHashMap<At, &[SmolStr]> = FxHashMap::default();
    let mut defined = Vec::new();
    for (at, head) in all_heads(db, sources) {
        match head {
            Head::Assigns { property, reads: names, .. } if property.is_empty() => {
                reads.insert(at, names);
            }
            Head::Defines { name, calls, .. } => {
                defined.push(name.clone());
                reads.insert(at, calls);
            }
            _ => {}
        }
    }
    let onward = |at: &At| reads.get(at).copied().unwrap_or_default();
    let variable = |name: &SmolStr| {
        let key = AssignKey { name: name.clone(), element: None, property: SmolStr::default() };
        assigned.by_key.get(&key).copied()
    };
    let predicate = |name: &SmolStr| table.predicates.get(name).map(|(_, at)| *at);
    Circles {
        variables: cycles::circles(&table.order, variable, |at| onward(&at)),
        predicates: cycles::circles(&defined, predicate, |at| onward(&at)),
    }
}

/// A name, to ask about.
#[salsa::interned]
struct Word<'db> {
    #[returns(deref)]
    text: String,
}

/// What a checker may know of a name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Facts {
    item: Option<ItemKind>,
    assigned: bool,
    poisoned: bool,
    predicate: Option<PredicateHead>,
}

#[salsa::tracked]
fn facts<'db>(db: &'db dyn salsa::Database, word: Word<'db>) -> Facts {
    let table = names(db, Sources::get(db));
    let name = word.text(db);
    Facts {
        item: table.items.get(name).map(|(kind, _)| *kind),
        assigned: table.assigned.contains(name),
        poisoned: table.poisoned.contains(name),
        predicate: table.predicates.get(name).map(|(head, _)| head.clone()),
    }
}

/// All names, for "did you mean".
#[derive(Clone, Debug, PartialEq, Eq)]
struct Spellings {
    declared: Vec<SmolStr>,
    predicates: Vec<SmolStr>,
}

#[salsa::tracked]
fn spellings(db: &dyn salsa::Database, sources: Sources) -> Spellings {
    let table = names(db, sources);
    let mut predicates: Vec<SmolStr> = table.predicates.keys().chain(library::predicates().keys()).cloned().collect();
    predicates.sort_unstable();
    Spellings { declared: table.order.clone(), predicates }
}

/// The names of the program as the checker asks for them; each answer is remembered as what the check depends on.
pub(crate) struct KnownNames<'db>(pub &'db dyn salsa::Database);

impl KnownNames<'_> {
    fn facts(&self, name: &str) -> &Facts {
        facts(self.0, Word::new(self.0, name))
    }
}

impl Names for KnownNames<'_> {
    fn item(&self, name: &str) -> Option<ItemKind> {
        self.facts(name).item
    }
    fn is_assigned(&self, variable: &str) -> bool {
        self.facts(variable).assigned
    }
    fn is_poisoned(&self, name: &str) -> bool {
        self.facts(name).poisoned
    }
    fn predicate(&self, name: &str) -> Option<PredicateHead> {
        self.facts(name).predicate.clone().or_else(|| library::predicate_head(name))
    }
    fn declared(&self) -> Vec<SmolStr> {
        spellings(self.0, Sources::get(self.0)).declared.clone()
    }
    fn predicates(&self) -> Vec<SmolStr> {
        spellings(self.0, Sources::get(self.0)).predicates.clone()
    }
}
