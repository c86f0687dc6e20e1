//! Rules of a tree-sitter grammar as data, and the two forms in which tree-sitter reads them: `grammar.json`, which its
//! generator takes, and `grammar.js`, which people read.

use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::slice::from_ref;

/// A piece of a rule. The names are those of tree-sitter's own functions.
#[derive(Clone, Debug)]
pub enum Rule {
    /// A word or sign as it stands.
    Text(&'static str),
    /// A regular expression that Rust and JavaScript understand alike; `/` is escaped.
    Pattern(&'static str),
    /// Another rule.
    Symbol(&'static str),
    /// One after the other.
    Seq(Vec<Self>),
    Choice(Vec<Self>),
    /// At most once.
    Optional(Box<Self>),
    /// Any number of times.
    Repeat(Box<Self>),
    /// A child that is found by a name.
    Field(&'static str, Box<Self>),
    /// A piece that shows as a node of another name.
    Alias(Box<Self>, &'static str),
    /// How tightly it binds.
    Prec(Associativity, i32, Box<Self>),
    Token(Box<Self>),
    /// One token without a blank before it.
    Immediate(Box<Self>),
    /// A word where another set of words is reserved.
    Reserved(&'static str, Box<Self>),
}

/// Which way operators that bind alike group.
#[derive(Clone, Copy, Debug)]
pub enum Associativity {
    /// Not at all.
    None,
    /// `(a + b) + c`
    Left,
    /// `a implies (b implies c)`
    Right,
}

pub fn text(text: &'static str) -> Rule {
    Rule::Text(text)
}
pub fn pattern(pattern: &'static str) -> Rule {
    Rule::Pattern(pattern)
}
pub fn symbol(name: &'static str) -> Rule {
    Rule::Symbol(name)
}
pub fn seq<const N: usize>(all: [Rule; N]) -> Rule {
    Rule::Seq(all.into())
}
/// One of several; of one, that one. A choice among them is part of this one.
pub fn choice(all: impl IntoIterator<Item = Rule>) -> Rule {
    let flat = all.into_iter().flat_map(|rule| match rule {
        Rule::Choice(all) => all,
        rule => vec![rule],
    });
    let mut all: Vec<Rule> = flat.collect();
    match all.pop() {
        Some(only) if all.is_empty() => only,
        last => Rule::Choice(all.into_iter().chain(last).collect()),
    }
}
pub fn optional(rule: Rule) -> Rule {
    Rule::Optional(Box::new(rule))
}
pub fn repeat(rule: Rule) -> Rule {
    Rule::Repeat(Box::new(rule))
}
pub fn field(name: &'static str, rule: Rule) -> Rule {
    Rule::Field(name, Box::new(rule))
}
pub fn alias(rule: Rule, name: &'static str) -> Rule {
    Rule::Alias(Box::new(rule), name)
}
pub fn prec(side: Associativity, binds: i32, rule: Rule) -> Rule {
    Rule::Prec(side, binds, Box::new(rule))
}
pub fn token(rule: Rule) -> Rule {
    Rule::Token(Box::new(rule))
}
pub fn immediate(rule: Rule) -> Rule {
    Rule::Immediate(Box::new(rule))
}
pub fn reserved(set: &'static str, rule: Rule) -> Rule {
    Rule::Reserved(set, Box::new(rule))
}

/// A whole grammar.
pub struct Grammar {
    /// The name of the language.
    pub name: &'static str,
    /// The token that words are.
    pub word: &'static str,
    /// The rules; the first is a file.
    pub rules: Vec<(&'static str, Rule)>,
    /// What may stand between tokens.
    pub extras: Vec<Rule>,
    /// Rules between which only what follows decides.
    pub conflicts: Vec<Vec<&'static str>>,
    /// Tokens that `scanner.c` finds.
    pub externals: Vec<&'static str>,
    /// Rules that make no step of their own.
    pub inline: Vec<&'static str>,
    /// Rules that are only names for a choice of others.
    pub supertypes: Vec<&'static str>,
    /// Sets of reserved words; the first holds where nothing else is said.
    pub reserved: Vec<(&'static str, Vec<Rule>)>,
}

impl Rule {
    fn json(&self) -> Value {
        let list = |all: &[Self]| -> Vec<Value> { all.iter().map(Self::json).collect() };
        match self {
            Self::Text(text) => json!({ "type": "STRING", "value": text }),
            Self::Pattern(pattern) if is_unicode(pattern) => {
                json!({ "type": "PATTERN", "value": pattern, "flags": "u" })
            }
            Self::Pattern(pattern) => json!({ "type": "PATTERN", "value": pattern }),
            Self::Symbol(name) => json!({ "type": "SYMBOL", "name": name }),
            Self::Seq(all) => json!({ "type": "SEQ", "members": list(all) }),
            Self::Choice(all) => json!({ "type": "CHOICE", "members": list(all) }),
            Self::Optional(rule) => json!({ "type": "CHOICE", "members": [rule.json(), { "type": "BLANK" }] }),
            Self::Repeat(rule) => json!({ "type": "REPEAT", "content": rule.json() }),
            Self::Field(name, rule) => json!({ "type": "FIELD", "name": name, "content": rule.json() }),
            Self::Alias(rule, name) => {
                json!({ "type": "ALIAS", "content": rule.json(), "named": true, "value": name })
            }
            Self::Prec(side, binds, rule) => {
                let kind = match side {
                    Associativity::None => "PREC",
                    Associativity::Left => "PREC_LEFT",
                    Associativity::Right => "PREC_RIGHT",
                };
                json!({ "type": kind, "value": binds, "content": rule.json() })
            }
            Self::Token(rule) => json!({ "type": "TOKEN", "content": rule.json() }),
            Self::Immediate(rule) => json!({ "type": "IMMEDIATE_TOKEN", "content": rule.json() }),
            Self::Reserved(set, rule) => {
                json!({ "type": "RESERVED", "content": rule.json(), "context_name": set })
            }
        }
    }

    /// As JavaScript, in lines of 100 columns where it can be broken: its first line begins at column `at`, the others
    /// are indented by `indent`.
    fn js(&self, at: usize, indent: usize) -> String {
        let (function, first, rules): (&str, Option<String>, &[Self]) = match self {
            Self::Text(text) => return json!(text).to_string(),
            Self::Pattern(pattern) => return format!("/{pattern}/{}", if is_unicode(pattern) { "u" } else { "" }),
            Self::Symbol(name) => return format!("$.{name}"),
            Self::Alias(rule, name) => return format!("alias({}, $.{name})", rule.js(at + 6, indent)),
            Self::Seq(all) => ("seq", None, all),
            Self::Choice(all) => ("choice", None, all),
            Self::Optional(rule) => ("optional", None, from_ref(rule)),
            Self::Repeat(rule) => ("repeat", None, from_ref(rule)),
            Self::Field(name, rule) => ("field", Some(json!(name).to_string()), from_ref(rule)),
            Self::Prec(Associativity::None, binds, rule) => ("prec", Some(binds.to_string()), from_ref(rule)),
            Self::Prec(Associativity::Left, binds, rule) => ("prec.left", Some(binds.to_string()), from_ref(rule)),
            Self::Prec(Associativity::Right, binds, rule) => ("prec.right", Some(binds.to_string()), from_ref(rule)),
            Self::Token(rule) => ("token", None, from_ref(rule)),
            Self::Immediate(rule) => ("token.immediate", None, from_ref(rule)),
            Self::Reserved(set, rule) => ("reserved", Some(json!(set).to_string()), from_ref(rule)),
        };
        let first = first.map(|f| f + ", ").unwrap_or_default();
        let open = format!("{function}({first}");
        let flat: Vec<String> = rules.iter().map(|r| r.js(0, 0)).collect();
        let flat = format!("{open}{})", flat.join(", "));
        if at + flat.len() < WIDTH && !flat.contains('\n') {
            return flat;
        }
        if let [only] = rules {
            return format!("{open}{})", only.js(at + open.len(), indent));
        }
        let gap = " ".repeat(indent + 2);
        let lines: String = rules.iter().map(|r| format!("{gap}{},\n", r.js(indent + 2, indent + 2))).collect();
        format!("{open}\n{lines}{})", " ".repeat(indent))
    }
}

/// How long the lines of `grammar.js` get, where they can be broken.
const WIDTH: usize = 100;

/// Whether JavaScript needs its flag for Unicode.
fn is_unicode(pattern: &str) -> bool {
    pattern.contains(r"\p{")
}

impl Grammar {
    /// `grammar.json`.
    pub fn json(&self) -> Value {
        let symbols =
            |names: &[&str]| -> Vec<Value> { names.iter().map(|n| json!({ "type": "SYMBOL", "name": n })).collect() };
        let list = |rules: &[Rule]| -> Vec<Value> { rules.iter().map(Rule::json).collect() };
        let rules: Map<String, Value> =
            self.rules.iter().map(|(name, rule)| ((*name).to_owned(), rule.json())).collect();
        let reserved: Map<String, Value> =
            self.reserved.iter().map(|(name, words)| ((*name).to_owned(), list(words).into())).collect();
        json!({
            "$schema": "https://tree-sitter.github.io/tree-sitter/assets/schemas/grammar.schema.json",
            "name": self.name,
            "word": self.word,
            "rules": rules,
            "extras": list(&self.extras),
            "conflicts": self.conflicts,
            "precedences": [],
            "externals": symbols(&self.externals),
            "inline": self.inline,
            "supertypes": self.supertypes,
            "reserved": reserved,
        })
    }

    /// `grammar.js`, with `head` as its first lines.
    pub fn js(&self, head: &str) -> String {
        let mut out = format!("{head}\nexport default grammar({{\n  name: \"{}\",\n", self.name);
        let mut entry = |name: &str, all: Vec<String>| {
            let flat = format!("  {name}: ($) => [{}],\n", all.join(", "));
            if flat.len() <= WIDTH {
                out += &flat;
            } else {
                writeln!(out, "  {name}: ($) => [\n    {},\n  ],", all.join(",\n    ")).expect("a string takes all");
            }
        };
        let symbols = |names: &[&'static str]| -> Vec<String> { names.iter().map(|n| symbol(n).js(0, 0)).collect() };
        entry("extras", self.extras.iter().map(|r| r.js(4, 4)).collect());
        entry("externals", symbols(&self.externals));
        entry("inline", symbols(&self.inline));
        entry("supertypes", symbols(&self.supertypes));
        entry("conflicts", self.conflicts.iter().map(|set| format!("[{}]", symbols(set).join(", "))).collect());
        write!(out, "  word: ($) => $.{},\n  reserved: {{\n", self.word).expect("a string takes all");
        for (name, words) in &self.reserved {
            let words: Vec<String> = words.iter().map(|w| w.js(0, 0)).collect();
            writeln!(out, "    {name}: ($) => [{}],", wrapped(&words)).expect("a string takes all");
        }
        out += "  },\n  rules: {\n";
        for (name, rule) in &self.rules {
            let head = format!("    {name}: ($) => ");
            writeln!(out, "{head}{},", rule.js(head.len(), 4)).expect("a string takes all");
        }
        out + "  },\n});\n"
    }
}

/// Words in lines of about 100 columns, if one does not hold them.
fn wrapped(words: &[String]) -> String {
    let flat = words.join(", ");
    if flat.len() <= 80 {
        return flat;
    }
    let mut lines = vec![String::new()];
    for word in words {
        match lines.last_mut() {
            Some(line) if line.len() + word.len() <= 90 => *line += &format!(" {word},"),
            _ => lines.push(format!(" {word},")),
        }
    }
    lines.iter().map(|line| format!("\n     {line}")).collect::<String>() + "\n    "
}
