//! What the statements of a program say together: who is declared where, how often who is named, what text who has.

use super::Linted;
use crate::ast::{ExprKind, Name, StmtKind};
use crate::items::{ItemKind, Names, whole_number};
use crate::roles::role_of;
use crate::types::Ty;
use rustc_hash::{FxHashMap, FxHashSet};
use scenelang_base::{FileId, Span};
use smol_str::SmolStr;

/// The value of a text property or variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TextValue<'a> {
    /// A literal.
    Text(&'a str),
    Variable(&'a SmolStr),
    /// Something else.
    Other,
}

/// The element of an array, if only one is assigned, and the value.
type Assigned<'a> = (Option<u32>, TextValue<'a>);

/// What a program says, for the warnings about all of it.
pub struct Facts<'a> {
    /// What names stand for.
    pub names: &'a dyn Names,
    /// All statements, the main file's first.
    pub statements: &'a [Linted<'a>],
    pub main: Option<FileId>,
    /// Names with the statement that declares them, in order, each once.
    pub order: Vec<(&'a Name, usize)>,
    declared: FxHashMap<&'a SmolStr, usize>,
    /// How many expressions of statements hold a name.
    pub read: FxHashMap<&'a SmolStr, u32>,
    /// How many statements assign a name or a property of it.
    pub assigned: FxHashMap<&'a SmolStr, u32>,
    /// Assigned properties and variables (the property empty).
    values: FxHashMap<(&'a SmolStr, &'a str), Vec<Assigned<'a>>>,
    /// Properties that some object or region is assigned.
    pub properties: FxHashSet<&'a str>,
}

impl<'a> Facts<'a> {
    /// Gathers them.
    pub fn of(names: &'a dyn Names, statements: &'a [Linted<'a>]) -> Self {
        let mut facts = Self {
            names,
            statements,
            main: statements.first().and_then(|s| s.place.file),
            order: Vec::new(),
            declared: FxHashMap::default(),
            read: FxHashMap::default(),
            assigned: FxHashMap::default(),
            values: FxHashMap::default(),
            properties: FxHashSet::default(),
        };
        for (i, Linted { place, uses, .. }) in statements.iter().enumerate() {
            for name in &uses.names {
                *facts.read.entry(&name.text).or_default() += 1;
            }
            match &place.stmt.kind {
                StmtKind::Declare { name, .. } if !facts.declared.contains_key(&name.text) => {
                    facts.declared.insert(&name.text, i);
                    facts.order.push((name, i));
                }
                StmtKind::Assign { name, index, path, value, .. } => {
                    *facts.assigned.entry(&name.text).or_default() += 1;
                    let property = path.first().map_or("", |p| p.text.as_str());
                    let value = match &place.stmt.expr(*value).kind {
                        ExprKind::Text(text) => TextValue::Text(text),
                        ExprKind::Name(variable) => TextValue::Variable(variable),
                        _ => TextValue::Other,
                    };
                    let element = index.map(|i| whole_number(place.stmt, i).map_or(u32::MAX, |i| i as u32));
                    facts.properties.insert(property);
                    facts.values.entry((&name.text, property)).or_default().push((element, value));
                }
                _ => {}
            }
        }
        facts
    }

    /// The statement that declares a name.
    pub fn declared(&self, name: &str) -> Option<&'a Linted<'a>> {
        self.declared.get(&SmolStr::new(name)).map(|i| &self.statements[*i])
    }

    /// The place of a declared name.
    pub fn declared_at(&self, name: &str) -> Option<Span> {
        let place = self.declared(name)?.place;
        match &place.stmt.kind {
            StmtKind::Declare { name, .. } => place.span(name.range),
            _ => None,
        }
    }

    /// What a declared name is, in a word.
    pub fn what(&self, name: &str) -> &'static str {
        match self.names.item(name) {
            Some(ItemKind::Object) => "object",
            Some(ItemKind::Array(_)) => "array",
            Some(ItemKind::Region) => "region",
            Some(ItemKind::Variable(_)) => "variable",
            None => "name",
        }
    }

    /// Whether a name is a variable that has no definition: the solver chooses it.
    pub fn is_chosen(&self, name: &SmolStr) -> bool {
        matches!(self.names.item(name), Some(ItemKind::Variable(_))) && !self.values.contains_key(&(name, ""))
    }

    /// Elements of an array that are assigned something of their own, sorted.
    pub fn own_elements(&self, array: &SmolStr) -> Vec<u32> {
        let of_text = crate::natives::STATIC_PROPERTIES.iter().filter_map(|p| self.values.get(&(array, *p)));
        let mut own: Vec<u32> = of_text.flatten().filter_map(|(element, _)| *element).collect();
        own.sort_unstable();
        own.dedup();
        own
    }

    /// Whether a property is assigned: of the element, of the array as a whole; if no element is given, of any.
    pub fn has(&self, name: &SmolStr, element: Option<u32>, property: &str) -> bool {
        let Some(values) = self.values.get(&(name, property)) else { return false };
        element.is_none() || values.iter().any(|(e, _)| e.is_none() || *e == element)
    }

    /// The text of a property; `""` where it is not assigned (a role: what the category says), `None` where it cannot be told.
    pub fn text(&self, name: &SmolStr, element: Option<u32>, property: &str) -> Option<&'a str> {
        let unassigned = || match property {
            // What the category says.
            "role" => self.text(name, element, "category").map(role_of),
            _ => Some(""),
        };
        let Some(values) = self.values.get(&(name, property)) else { return unassigned() };
        match values.iter().find(|(e, _)| e.is_none() || *e == element) {
            None => unassigned(),
            Some((_, TextValue::Text(text))) => Some(text),
            Some((_, TextValue::Variable(variable))) => self.variable(variable),
            Some((_, TextValue::Other)) => None,
        }
    }

    /// The text that a variable stands for.
    pub fn variable(&self, name: &SmolStr) -> Option<&'a str> {
        if !matches!(self.names.item(name), Some(ItemKind::Variable(ty)) if ty.is_text()) {
            return None;
        }
        let mut at = name;
        // A circle of definitions is an error of its own.
        for _ in 0..16 {
            match self.values.get(&(at, ""))?.first()? {
                (_, TextValue::Text(text)) => return Some(text),
                (_, TextValue::Variable(next)) => at = next,
                (_, TextValue::Other) => return None,
            }
        }
        None
    }

    /// Variables and predicates of which `such` holds, or which use one of which it holds, directly or through others.
    pub fn closure(&self, such: impl Fn(&Linted<'_>) -> bool) -> FxHashSet<DefinitionNode<'a>> {
        if !self.statements.iter().any(&such) {
            return FxHashSet::default();
        }
        let mut users: FxHashMap<DefinitionNode<'a>, Vec<DefinitionNode<'a>>> = FxHashMap::default();
        let mut open = Vec::new();
        for linted in self.statements {
            let node = match &linted.place.stmt.kind {
                StmtKind::Assign { name, path, .. } if path.is_empty() => DefinitionNode::Variable(&name.text),
                StmtKind::Predicate { name, .. } => DefinitionNode::Predicate(&name.text),
                _ => continue,
            };
            if such(linted) {
                open.push(node);
            }
            for name in &linted.uses.names {
                users.entry(DefinitionNode::Variable(&name.text)).or_default().push(node);
            }
            for name in &linted.uses.calls {
                users.entry(DefinitionNode::Predicate(name)).or_default().push(node);
            }
        }
        let mut reached = FxHashSet::default();
        while let Some(node) = open.pop() {
            if reached.insert(node) {
                open.extend(users.get(&node).into_iter().flatten());
            }
        }
        reached
    }

    /// Whether a name stands for an object, an array or a region; or for nothing known.
    pub fn is_thing(&self, name: &str) -> bool {
        match self.names.item(name) {
            Some(ItemKind::Variable(ty)) => matches!(ty, Ty::Error),
            Some(ItemKind::Object | ItemKind::Array(_) | ItemKind::Region) | None => true,
        }
    }
}

/// A definition: a variable or a predicate of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DefinitionNode<'a> {
    /// A variable that is assigned.
    Variable(&'a SmolStr),
    Predicate(&'a SmolStr),
}
