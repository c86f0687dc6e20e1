//! The grammar of the reference (`spec/src/reference/grammar.md`) as tree-sitter wants it: nodes are named as the rules
//! there, and precedence stands in numbers instead of a rule for each level. Words and signs come from the table of
//! tokens.
//!
//! Only reserved words are reserved here, too. A contextual word is a keyword where the grammar has it and a name
//! wherever tree-sitter finds it in the place of a name. The one place where what follows must decide is `forall
//! implies …`, a conflict that both readings are tried for.

use crate::rule::Associativity::{Left, None, Right};
use crate::rule::{
    Grammar, Rule, alias, choice, field, immediate, optional, pattern, prec, repeat, reserved, seq, symbol, text, token,
};
use scenelang_lang::token::{Class, Kind, TABLE, UNITS};

/// A backslash and what may follow it in text; two halves make one character beyond the first plane.
pub const ESCAPE: &str = r#"\\(["\\\/nrt]|u([0-9a-cA-Ce-fE-F][0-9a-fA-F]{3}|[dD]([0-7][0-9a-fA-F]{2}|[89abAB][0-9a-fA-F]{2}\\u[dD][c-fC-F][0-9a-fA-F]{2})))"#;

/// All spellings of some kinds.
fn spelt(kinds: &[Kind]) -> Rule {
    choice(kinds.iter().flat_map(|kind| kind.row().spellings).map(|s| text(s)))
}

/// Reserved and contextual words of a class.
fn words(class: Class) -> Rule {
    let rows = TABLE.iter().filter(|r| r.class == class);
    choice(rows.flat_map(|r| r.spellings.iter().chain(r.words)).filter(|s| is_word(s)).map(|s| text(s)))
}

/// Words and not signs.
pub fn is_word(spelling: &str) -> bool {
    spelling.starts_with(|c: char| c.is_alphabetic())
}

/// The first pattern of a kind.
fn pattern_of(kind: Kind) -> Rule {
    pattern(kind.row().patterns[0])
}

/// `a, b, c`, or nothing.
fn list(rule: Rule) -> Rule {
    optional(seq([rule.clone(), repeat(seq([text(","), rule]))]))
}

/// The whole grammar.
pub fn grammar() -> Grammar {
    let reserved_words = TABLE.iter().flat_map(|r| r.spellings).filter(|s| is_word(s));
    Grammar {
        name: "scenelang",
        word: "identifier",
        rules: [statements(), formulas(), values(), tokens()].concat(),
        extras: vec![pattern_of(Kind::Blank), symbol("line_comment"), symbol("documentation"), symbol("block_comment")],
        conflicts: vec![vec!["quantified", "value"]],
        externals: vec!["block_comment", "_characters", "_error_sentinel"],
        inline: vec!["_contextual"],
        supertypes: vec!["formula", "value"],
        reserved: vec![("global", reserved_words.map(|w| text(w)).collect()), ("properties", vec![])],
    }
}

fn statements() -> Vec<(&'static str, Rule)> {
    let formula = || symbol("formula");
    let name = || field("name", symbol("_name"));
    let bodies = ["declaration", "assignment", "assertion", "preference", "allowance", "predicate", "import"];
    vec![
        ("program", repeat(choice([symbol("statement"), text(";")]))),
        ("statement", seq([repeat(symbol("requirement")), choice(bodies.map(symbol)), text(";")])),
        ("requirement", seq([text("@req"), text("("), symbol("string"), text(")")])),
        (
            "declaration",
            seq([
                field("type", choice([spelt(&[Kind::Object, Kind::Entity, Kind::Region]), symbol("type")])),
                name(),
                optional(seq([text("["), field("size", formula()), text("]")])),
            ]),
        ),
        ("type", choice(TABLE.iter().filter(|r| r.class == Class::Type).flat_map(|r| r.spellings).map(|s| text(s)))),
        (
            "assignment",
            seq([
                name(),
                optional(seq([text("["), field("index", formula()), text("]")])),
                repeat(seq([text("."), field("property", symbol("_property"))])),
                spelt(&[Kind::Arrow, Kind::ArrowSign]),
                field("value", formula()),
            ]),
        ),
        ("assertion", seq([text("assert"), formula()])),
        ("preference", seq([text("prefer"), formula(), optional(seq([text("weight"), field("weight", formula())]))])),
        (
            "allowance",
            seq([
                choice(["allowCollide", "allowOutside", "allowFloat"].map(text)),
                field("arguments", symbol("arguments")),
            ]),
        ),
        (
            "predicate",
            seq([
                text("predicate"),
                field("name", choice([symbol("_name"), symbol("constructor")])),
                field("parameters", symbol("parameters")),
                text(":="),
                field("body", formula()),
            ]),
        ),
        ("parameters", seq([text("("), list(symbol("parameter")), text(")")])),
        ("parameter", {
            let words = Kind::ParamType.row().words.iter().map(|w| text(w));
            seq([field("type", choice([symbol("type"), alias(choice(words), "type")])), name()])
        }),
        ("import", seq([text("import"), field("path", symbol("string"))])),
    ]
}

/// How tightly operators bind, loosest first.
const WHERE: i32 = 1;
const IMPLIES: i32 = 2;
const OR: i32 = 3;
const AND: i32 = 4;
const NOT: i32 = 5;
const RANGE: i32 = 6;
const SUM: i32 = 7;
const PRODUCT: i32 = 8;
const SIGN: i32 = 9;
const MEMBER: i32 = 10;

/// `left operator right`
fn infix(operand: &'static str, operator: Rule) -> Rule {
    seq([field("left", symbol(operand)), field("operator", operator), field("right", symbol(operand))])
}

fn formulas() -> Vec<(&'static str, Rule)> {
    let nodes =
        ["filter", "implication", "disjunction", "conjunction", "negation", "quantified", "comparison", "value"];
    let relations = [Kind::Eq, Kind::Ne, Kind::Lt, Kind::Le, Kind::Gt, Kind::Ge];
    vec![
        ("formula", choice(nodes.map(symbol))),
        ("filter", prec(Left, WHERE, infix("formula", text("where")))),
        ("implication", prec(Right, IMPLIES, infix("formula", text("implies")))),
        ("disjunction", prec(Left, OR, infix("formula", spelt(&[Kind::Or])))),
        ("conjunction", prec(Left, AND, infix("formula", spelt(&[Kind::And])))),
        ("negation", prec(None, NOT, seq([field("operator", spelt(&[Kind::Not])), symbol("formula")]))),
        ("quantified", seq([field("quantifier", choice([text("forall"), text("exists")])), symbol("binding")])),
        (
            "binding",
            seq([
                field("variable", symbol("_name")),
                text("in"),
                field("domain", symbol("formula")),
                text(":"),
                field("body", symbol("formula")),
            ]),
        ),
        ("comparison", infix("value", spelt(&relations))),
    ]
}

fn values() -> Vec<(&'static str, Rule)> {
    let formula = || symbol("formula");
    let nodes = ["range", "sum", "product", "factor", "member", "element", "own", "call", "count", "parenthesized"];
    let literals = ["number", "string", "truth", "objects"];
    let reference = [symbol("identifier"), alias(symbol("_contextual"), "identifier")];
    let names =
        [symbol("identifier"), alias(symbol("_contextual"), "identifier"), alias(text("objects"), "identifier")];
    let property = || field("property", symbol("_property"));
    vec![
        ("value", choice(reference.into_iter().chain(literals.map(symbol)).chain(nodes.map(symbol)))),
        // As a token it takes precedence over the fraction in `0..5`.
        ("range", prec(Left, RANGE, infix("value", token(prec(None, 1, spelt(&[Kind::DotDot])))))),
        ("sum", prec(Left, SUM, infix("value", spelt(&[Kind::Plus, Kind::Minus])))),
        ("product", prec(Left, PRODUCT, infix("value", spelt(&[Kind::Star, Kind::Slash])))),
        ("factor", prec(None, SIGN, seq([field("operator", text("-")), symbol("value")]))),
        ("member", prec(None, MEMBER, seq([field("of", symbol("value")), text("."), property()]))),
        (
            "element",
            prec(None, MEMBER, seq([field("of", symbol("value")), text("["), field("index", formula()), text("]")])),
        ),
        ("own", seq([text("."), property()])),
        (
            "call",
            seq([
                field("function", choice(names.clone().into_iter().chain([symbol("constructor")]))),
                field("arguments", symbol("arguments")),
            ]),
        ),
        ("constructor", words(Class::Function)),
        ("count", seq([text("count"), text("("), symbol("binding"), text(")")])),
        ("arguments", seq([text("("), list(formula()), text(")")])),
        ("parenthesized", seq([text("("), formula(), text(")")])),
        ("truth", spelt(&[Kind::True, Kind::False])),
        ("objects", text("objects")),
        // `prefer .` begins an assignment, not a preference: hence the precedence.
        ("_name", choice(names.map(|name| prec(None, 1, name)))),
        ("_contextual", {
            let words = TABLE.iter().flat_map(|r| r.words).filter(|w| **w != "objects");
            choice(words.map(|w| text(w)))
        }),
        ("_property", reserved("properties", alias(symbol("identifier"), "property"))),
    ]
}

fn tokens() -> Vec<(&'static str, Rule)> {
    let digits = seq([pattern("[0-9]+"), optional(immediate(prec(None, 1, pattern(r"\.[0-9]*"))))]);
    vec![
        ("identifier", pattern_of(Kind::Ident)),
        (
            "number",
            seq([
                choice([digits, pattern(r"\.[0-9]+")]),
                optional(immediate(pattern("[eE][+-]?[0-9]+"))),
                optional(symbol("unit")),
            ]),
        ),
        ("unit", immediate(choice(UNITS.map(text)))),
        ("string", seq([text("\""), repeat(choice([symbol("_characters"), symbol("escape")])), immediate(text("\""))])),
        ("escape", immediate(pattern(ESCAPE))),
        ("line_comment", token(choice([pattern(r"\/\/([^\/\r\n][^\r\n]*)?"), pattern(r"\/\/\/\/[^\r\n]*")]))),
        ("documentation", token(pattern(r"\/\/\/([^\/\r\n][^\r\n]*)?"))),
    ]
}
