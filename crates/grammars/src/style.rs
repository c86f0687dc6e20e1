//! What a class of tokens is called in themes: the scope of TextMate, and the capture of tree-sitter.

use scenelang_lang::library;
use scenelang_lang::natives::{BUILT_INS, OBJECT_PROPERTIES, REGION_PROPERTIES};
use scenelang_lang::token::Class;

/// Both names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// The scope, without the language behind it; empty for what has no colour.
    pub scope: &'static str,
    /// The capture, without its `@`; empty for what has no colour.
    pub capture: &'static str,
}

/// The names of a class.
pub fn style(class: Class) -> Style {
    let (scope, capture) = match class {
        Class::Blank => ("", ""),
        Class::Comment => ("comment", "comment"),
        Class::Documentation => ("comment.line.documentation", "comment.documentation"),
        Class::Name => ("variable.other", "variable"),
        Class::Number => ("constant.numeric", "number"),
        Class::Text => ("string.quoted.double", "string"),
        Class::Declaration => ("storage.type", "keyword"),
        Class::Type => ("support.type", "type.builtin"),
        Class::Keyword => ("keyword.control", "keyword"),
        Class::Function => ("support.function", "function.builtin"),
        Class::Constant => ("constant.language", "constant.builtin"),
        Class::Attribute => ("entity.other.attribute-name", "attribute"),
        Class::Logic => ("keyword.operator.logical", "keyword.operator"),
        Class::Comparison => ("keyword.operator.comparison", "operator"),
        Class::Arithmetic => ("keyword.operator.arithmetic", "operator"),
        Class::Range => ("keyword.operator.range", "operator"),
        Class::Assignment => ("keyword.operator.assignment", "operator"),
        Class::Accessor => ("punctuation.accessor", "punctuation.delimiter"),
        Class::Separator => ("punctuation.separator", "punctuation.delimiter"),
        Class::Terminator => ("punctuation.terminator", "punctuation.delimiter"),
        Class::Bracket => ("punctuation.section", "punctuation.bracket"),
        Class::Error => ("invalid.illegal", ""),
    };
    Style { scope, capture }
}

/// Functions and predicates that every program has: the built-in ones and those of the standard library, sorted.
pub fn known_functions() -> Vec<&'static str> {
    sorted(BUILT_INS.iter().map(|s| s.name).chain(library::names()))
}

/// Properties that objects, regions and vectors have, sorted.
pub fn known_properties() -> Vec<&'static str> {
    let tables = OBJECT_PROPERTIES.iter().chain(REGION_PROPERTIES);
    sorted(tables.map(|p| p.name).chain(["x", "y", "z"]))
}

fn sorted(names: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    let mut names: Vec<_> = names.collect();
    names.sort_unstable();
    names.dedup();
    names
}
