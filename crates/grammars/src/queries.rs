//! The queries of the tree-sitter grammar: which node has which colour, what a name refers to, what folds.
//!
//! Where several patterns match a node, the last one counts, so the general ones stand first.

use crate::style::{known_functions, known_properties, style};
use crate::syntax::is_word;
use scenelang_lang::token::{Class, TABLE};
use std::collections::BTreeMap;
use std::fmt::Write;

const HEAD: &str = "; Made by `./x grammars` from the table of tokens.\n\n";

/// Nodes with a colour of their own, in the order of their patterns.
const NODES: &[(&str, &str)] = &[
    ("(identifier)", "variable"),
    ("(property)", "variable.member"),
    ("(parameter name: (identifier) @)", "variable.parameter"),
    ("(binding variable: (identifier) @)", "variable.parameter"),
    ("(predicate name: (identifier) @)", "function"),
    ("(call function: (identifier) @)", "function.call"),
    ("(unit)", "type"),
    ("(escape)", "string.escape"),
    ("(import path: (string) @)", "string.special.path"),
];

/// `highlights.scm`
pub fn highlights() -> String {
    let mut out = HEAD.to_owned();
    for (node, class) in [
        ("(number)", Class::Number),
        ("(string)", Class::Text),
        ("[(line_comment) (block_comment)]", Class::Comment),
        ("(documentation)", Class::Documentation),
        ("(type)", Class::Type),
        ("(constructor)", Class::Function),
        ("[(truth) (objects)]", Class::Constant),
    ] {
        line(&mut out, node, style(class).capture);
    }
    for (node, capture) in NODES {
        line(&mut out, node, capture);
    }
    among(&mut out, "(property) @", "property", &known_properties());
    among(&mut out, "(call function: (identifier) @)", "function.builtin", &known_functions());
    for (capture, tokens) in literals() {
        let quoted: Vec<String> = tokens.iter().map(|t| format!("\n  \"{t}\"")).collect();
        write!(out, "\n[{}\n] @{capture}\n", quoted.concat()).expect("a string takes all");
    }
    out
}

fn line(out: &mut String, node: &str, capture: &str) {
    let node =
        if node.contains('@') { node.replace('@', &format!("@{capture}")) } else { format!("{node} @{capture}") };
    writeln!(out, "{node}").expect("a string takes all");
}

/// A pattern for nodes whose text is one of some names.
fn among(out: &mut String, node: &str, capture: &str, names: &[&str]) {
    let node = node.replace('@', &format!("@{capture}"));
    let names: String = names.iter().map(|n| format!("\n    \"{n}\"")).collect();
    write!(out, "\n({node}\n  (#any-of? @{capture}{names}))\n").expect("a string takes all");
}

/// Words and signs that are nodes without a name, by capture. Types, functions and constants have nodes of their own.
fn literals() -> BTreeMap<&'static str, Vec<&'static str>> {
    let mut all: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for row in TABLE {
        let capture = style(row.class).capture;
        match row.class {
            Class::Blank | Class::Error | Class::Type | Class::Function | Class::Constant => {}
            _ => {
                for spelling in row.spellings.iter().chain(row.words).copied() {
                    let sign = row.class == Class::Logic && !is_word(spelling);
                    all.entry(if sign { "operator" } else { capture }).or_default().push(spelling);
                }
            }
        }
    }
    all
}

/// `locals.scm`
pub fn locals() -> String {
    let rules = "\
[
  (quantified)
  (count)
  (predicate)
] @local.scope

(binding variable: (identifier) @local.definition)
(parameter name: (identifier) @local.definition)

(identifier) @local.reference
";
    HEAD.to_owned() + rules
}

/// `folds.scm`
pub fn folds() -> String {
    let rules = "\
[
  (statement)
  (block_comment)
] @fold
";
    HEAD.to_owned() + rules
}
