//! How a statement begins: its keyword, the name it declares, the target it assigns.

use super::super::wanted::Wanted;
use super::super::words::{declares, is_constructor, is_type_word, is_word, starts_statement};
use super::{After, Finding, Site};
use crate::token::Kind;
use scenelang_base::codes::{E0110, E0112, E0115};
use scenelang_base::suggest::nearest;
use scenelang_base::{Applicability, Diagnostic, TextRange};

/// The words that statements begin with.
const STATEMENTS: &[(&str, Kind)] = &[
    ("object", Kind::Object),
    ("entity", Kind::Entity),
    ("region", Kind::Region),
    ("Number", Kind::NumberType),
    ("Degree", Kind::Degree),
    ("Bool", Kind::Bool),
    ("Vector3", Kind::Vector3),
    ("Rotation", Kind::Rotation),
    ("Color", Kind::Color),
    ("Material", Kind::Material),
    ("assert", Kind::Assert),
    ("prefer", Kind::Prefer),
    ("allowCollide", Kind::AllowCollide),
    ("allowOutside", Kind::AllowOutside),
    ("allowFloat", Kind::AllowFloat),
    ("predicate", Kind::Predicate),
    ("import", Kind::Import),
];

/// What other languages call them.
const SYNONYMS: &[(&str, &str)] = &[
    ("require", "assert"),
    ("constraint", "assert"),
    ("ensure", "assert"),
    ("check", "assert"),
    ("must", "assert"),
    ("shall", "assert"),
    ("should", "prefer"),
    ("soft", "prefer"),
    ("room", "region"),
    ("area", "region"),
    ("zone", "region"),
    ("include", "import"),
    ("use", "import"),
    ("def", "predicate"),
    ("define", "predicate"),
    ("function", "predicate"),
    ("let", "Number"),
    ("var", "Number"),
    ("float", "Number"),
    ("int", "Number"),
    ("double", "Number"),
    ("length", "Number"),
    ("real", "Number"),
    ("angle", "Degree"),
    ("boolean", "Bool"),
    ("vec3", "Vector3"),
    ("quaternion", "Rotation"),
    ("allowOverlap", "allowCollide"),
    ("allowOverlaps", "allowCollide"),
    ("allowIntersect", "allowCollide"),
    ("allowCollision", "allowCollide"),
];

/// Statements that the language does not have, and what is written instead.
const FOREIGN: &[(&str, &str)] = &[
    (
        "minimize",
        "there is no `minimize` statement; state what should hold as a preference, as in \
         `prefer near(lamp, bed, 0.5);`",
    ),
    (
        "maximize",
        "there is no `maximize` statement; state what should hold as a preference, as in \
         `prefer distance(bed, tv) > 2;`",
    ),
    (
        "if",
        "there is no `if` statement; write the condition inside the assertion, with `implies`: \
         `assert near(a, b, 1) implies facing(a, b);`",
    ),
    ("for", "to state something for each object in a set, write `assert forall c in chair: near(c, table, 1);`"),
    ("foreach", "to state something for each object in a set, write `assert forall c in chair: near(c, table, 1);`"),
];

/// The word for a statement that a misspelt one is near to.
pub fn nearest_statement(word: &str) -> Option<&'static str> {
    if FOREIGN.iter().any(|(other, _)| other.eq_ignore_ascii_case(word)) {
        return None;
    }
    let synonym = SYNONYMS.iter().find(|(other, _)| other.eq_ignore_ascii_case(word)).map(|(_, ours)| *ours);
    synonym.or_else(|| nearest(word, STATEMENTS.iter().map(|(s, _)| *s)))
}

/// The keyword that the first word of a statement was meant to be, if what follows it looks like it.
pub fn meant_statement(word: &str, after: &str) -> Option<(&'static str, Kind)> {
    let near = nearest_statement(word)?;
    let fits = match near {
        "assert" | "prefer" => !after.is_empty() && !after.starts_with(['.', '[', '<', '=', ':']),
        allow if allow.starts_with("allow") => after == "(",
        _ => is_word(after) || after.starts_with('"'),
    };
    STATEMENTS.iter().find(|(statement, _)| fits && *statement == near).copied()
}

/// What is said of a condition that is neither asserted nor preferred.
const UNASSERTED: &str = "a condition alone is not a statement: write `assert` or `prefer` before it";

/// `@req` without its sentence, or without a statement behind it.
pub fn attribute(site: &Site<'_>) -> Option<Finding> {
    if site.at == site.head && site.head > 0 && site.found().is_none() {
        let place = site.ranges[0].cover(site.behind(site.at - 1));
        let message = "`@req` must be followed by the statement that expresses the requirement";
        let diagnostic = Diagnostic::new(E0110, place, message);
        return Some(diagnostic.label(format!("expected a statement after it, found {}", site.name_of(site.at))));
    }
    let start = (0..site.at).rev().find(|&at| site.kinds[at] == Kind::Req)?;
    if site.head > start || site.at > start + 3 {
        return None;
    }
    let message = format!("expected {} after `@req`, found {}", site.expectation(), site.name_of(site.at));
    Some(Diagnostic::new(E0110, site.range(site.at), message).note("write it as `@req(\"the requirement\")`"))
}

/// A reserved word where a name is wanted.
pub fn reserved_name(site: &Site<'_>) -> Option<Finding> {
    let kind = site.found()?;
    let word = site.slice(site.at);
    if !site.wanted.has(Wanted::NAME) || kind == Kind::Ident || !is_word(word) {
        return None;
    }
    let message = format!("{} is a reserved word and cannot be a name", site.quoted(site.at));
    let diagnostic = Diagnostic::new(E0110, site.range(site.at), message);
    let other = format!("{word}_");
    Some(diagnostic.fix(Applicability::Unsafe, format!("call it `{other}`"), site.range(site.at), other))
}

/// `object`, `Number`, … and what is wrong behind it.
pub fn declaration(site: &Site<'_>) -> Option<Finding> {
    let keyword = site.kind(site.head).filter(|k| declares(*k))?;
    let word = site.slice(site.head);
    let place = site.range(site.at);
    if site.at == site.head + 1 {
        return Some(match site.found() {
            Some(Kind::Str) => {
                let name = site.slice(site.at).trim_matches('"');
                let diagnostic = Diagnostic::new(E0110, place, "names are written without quotation marks");
                if is_name(name) {
                    diagnostic.fix(Applicability::Safe, format!("write `{name}`"), place, name)
                } else {
                    diagnostic.note("a name is one word of letters, digits and `_`")
                }
            }
            None => Diagnostic::new(E0112, site.range(site.head), format!("a name is missing after `{word}`")),
            Some(_) => {
                let message = format!("expected a name after `{word}`, found {}", site.name_of(site.at));
                Diagnostic::new(E0110, place, message)
            }
        });
    }
    if site.wanted.has(Wanted::VALUE) && site.before() == Some(Kind::LBracket) && site.found() == Some(Kind::RBracket) {
        let diagnostic = Diagnostic::new(E0112, place, "the size of the array is missing");
        return Some(diagnostic.note("give the number of elements: `object chair[6];`"));
    }
    if site.innermost_open().is_some() {
        return None;
    }
    let name = site.slice(site.head + 1);
    let diagnostic = match site.found()? {
        Kind::Comma => {
            let text = format!("; {word}");
            let another = site.kind(site.at + 1) == Some(Kind::Ident);
            let diagnostic = Diagnostic::new(E0110, place, "a declaration declares only one name");
            if another {
                diagnostic.fix(Applicability::Safe, format!("repeat `{word}`"), place, text)
            } else {
                diagnostic.fix(Applicability::Safe, "remove the comma", place, "")
            }
        }
        Kind::Arrow | Kind::ArrowSign | Kind::Eq | Kind::Define => {
            let diagnostic =
                Diagnostic::new(E0110, place, "a declaration cannot assign a value; use a separate assignment");
            if is_type_word(keyword) {
                let title = format!("write `{word} {name}; {name} <- …`");
                diagnostic.fix(
                    Applicability::Safe,
                    title,
                    site.behind(site.at - 1).cover(place),
                    format!("; {name} <-"),
                )
            } else {
                diagnostic
            }
        }
        Kind::Minus if matches!(site.kind(site.at + 1), Some(Kind::Ident | Kind::Number)) => {
            let joined = format!("{name}_{}", site.slice(site.at + 1));
            let place = site.range(site.at - 1).cover(site.range(site.at + 1));
            let diagnostic = Diagnostic::new(E0110, place, "a name cannot contain `-`");
            diagnostic.fix(Applicability::Unsafe, format!("call it `{joined}`"), place, joined)
        }
        Kind::Ident => {
            let message = format!("expected `;` after the name `{name}`, found {}", site.name_of(site.at));
            let diagnostic = Diagnostic::new(E0110, place, message)
                .note("a name is a single word, and a declaration declares one name");
            let both = format!("{name}_{}", site.slice(site.at));
            let joined = site.range(site.at - 1).cover(place);
            let diagnostic = diagnostic.fix(Applicability::Unsafe, format!("join them: `{both}`"), joined, both);
            let between = TextRange { start: site.range(site.at - 1).end, end: place.start };
            diagnostic.fix(Applicability::Unsafe, "declare both", between, format!("; {word} "))
        }
        _ => return None,
    };
    Some(diagnostic)
}

/// Whether the statement begins with a name, and an arrow could follow here.
fn assigns(site: &Site<'_>) -> bool {
    site.kind(site.head) == Some(Kind::Ident) && site.wanted.has(Wanted::ARROW)
}

/// A fix that asserts a condition which stands alone.
fn assert_it(diagnostic: Finding, condition: TextRange) -> Finding {
    diagnostic.fix(Applicability::Unsafe, "assert it", TextRange::empty(condition.start), "assert ")
}

/// `lamp.pos = …` and the like: an assignment with another sign.
pub fn assignment(site: &Site<'_>) -> Option<Finding> {
    let place = site.range(site.at);
    match site.found().filter(|_| assigns(site))? {
        Kind::Eq => {
            let diagnostic = Diagnostic::new(E0110, place, "`=` compares two values; to assign one, write `<-`");
            let assigned = diagnostic.fix(Applicability::Unsafe, "assign: write `<-`", place, "<-");
            Some(assert_it(assigned, site.range(site.head)))
        }
        Kind::Define | Kind::Colon => {
            let message = format!("a value is assigned with `<-`, not with {}", site.quoted(site.at));
            Some(Diagnostic::new(E0110, place, message).fix(Applicability::Safe, "write `<-`", place, "<-"))
        }
        _ => None,
    }
}

/// A first word that is no keyword, but nearly one; or followed by another word, as only a keyword could be.
pub fn misspelt(site: &Site<'_>) -> Option<Finding> {
    let next = site.found().filter(|_| assigns(site) && site.at == site.head + 1)?;
    let (head, after) = (site.range(site.head), site.slice(site.at));
    let diagnostic = Diagnostic::new(E0115, head, format!("unknown statement {}", site.quoted(site.head)));
    let value = site.ranges.get(site.at + 2).map(|first| first.cover(site.range(site.kinds.len() - 1)));
    match meant_statement(site.slice(site.head), after) {
        Some((near, _)) => {
            // `Object lamp` can mean nothing else.
            let other_case = near.eq_ignore_ascii_case(site.slice(site.head));
            let applicability = if other_case { Applicability::Safe } else { Applicability::Unsafe };
            let diagnostic = match near {
                "Number" if site.kind(site.at + 1) == Some(Kind::Eq) && value.is_some() => {
                    let value = value.map_or("", |value| &site.text[value.bytes()]);
                    let written = format!("Number {after}; {after} <- {value}");
                    let whole = head.cover(site.range(site.kinds.len() - 1));
                    let title = format!("write {}", super::quote(&written));
                    let diagnostic = diagnostic.label("a variable is declared with its type, and then assigned");
                    return Some(diagnostic.fix(Applicability::Unsafe, title, whole, written));
                }
                "Number" if !other_case => {
                    diagnostic.label("a variable declaration begins with a type, such as `Number`")
                }
                _ => diagnostic.label(format!("did you mean `{near}`?")),
            };
            Some(diagnostic.fix(applicability, format!("write `{near}`"), head, near))
        }
        None if let Some((_, instead)) =
            FOREIGN.iter().find(|(other, _)| other.eq_ignore_ascii_case(site.slice(site.head))) =>
        {
            Some(diagnostic.note(*instead))
        }
        None if is_word(after) || next == Kind::Str => Some(diagnostic.note(
            "a statement declares (`object`, `region`, `Number`, …), assigns (`lamp.color <- …`), \
             or begins with `assert`, `prefer`, `allow…`, `predicate` or `import`",
        )),
        None => None,
    }
}

/// A condition that nobody asserts, a name that stands alone, a target without its arrow.
pub fn no_arrow(site: &Site<'_>) -> Option<Finding> {
    if !assigns(site) {
        return None;
    }
    let (head, place) = (site.range(site.head), site.range(site.at));
    let target = super::quote(&site.text[head.cover(site.range(site.at - 1)).bytes()]);
    let Some(next) = site.found() else {
        let message = format!("{target} alone is not a statement: assign a value to it, or assert something about it");
        return Some(Diagnostic::new(E0110, place, message).label("expected `<-` and a value"));
    };
    use Kind::*;
    if next == LParen
        && let Some((near, _)) = meant_statement(site.slice(site.head), "(")
    {
        let message = format!("unknown statement {}", site.quoted(site.head));
        let diagnostic = Diagnostic::new(E0115, head, message).label(format!("did you mean `{near}`?"));
        return Some(diagnostic.fix(Applicability::Unsafe, format!("write `{near}`"), head, near));
    }
    if matches!(next, LParen | Ne | Lt | Le | Gt | Ge | And | Or | Implies) {
        return Some(assert_it(Diagnostic::new(E0110, head, UNASSERTED), head));
    }
    let message = format!("expected `<-` after {target}, found {}", site.name_of(site.at));
    let diagnostic = Diagnostic::new(E0110, place, message);
    match next {
        Plus | Minus | Star | Slash => Some(diagnostic),
        _ if is_constructor(next) || matches!(next, Number | Str | Ident) => {
            Some(diagnostic.fix(Applicability::Unsafe, "insert `<-`", site.behind(site.at - 1), " <-"))
        }
        _ => None,
    }
}

/// The head of a predicate: its parameters and `:=`.
pub fn predicate(site: &Site<'_>) -> Option<Finding> {
    if site.kind(site.head) != Some(Kind::Predicate) {
        return None;
    }
    let place = site.range(site.at);
    if site.wanted.has(Wanted::DEFINE) {
        let diagnostic = Diagnostic::new(
            E0110,
            place,
            format!("expected `:=` before the condition, found {}", site.name_of(site.at)),
        );
        let wrong = matches!(site.found(), Some(Kind::Eq | Kind::Arrow | Kind::ArrowSign | Kind::Colon));
        return Some(match wrong {
            true => diagnostic.fix(Applicability::Safe, "write `:=`", place, ":="),
            false => diagnostic.note("a predicate is written `predicate near(Object a, Object b) := …;`"),
        });
    }
    if !site.wanted.has(Wanted::TYPE) || site.at <= site.head + 2 {
        return None;
    }
    let types = [
        "Object", "Region", "Objects", "Number", "Degree", "Bool", "Vector3", "Rotation", "Color", "Material", "String",
    ];
    let word = site.slice(site.at);
    let note = "a parameter is a type and a name: `Object a`, `Region r`, `Number d`";
    if site.found().is_some_and(|k| k == Kind::Ident || starts_statement(k)) {
        let typed = site.kind(site.at + 1) == Some(Kind::Ident);
        let diagnostic = Diagnostic::new(
            E0110,
            place,
            match typed {
                true => format!("{} is not a parameter type", site.quoted(site.at)),
                false => format!("the parameter {} has no type", site.quoted(site.at)),
            },
        );
        return Some(match nearest(word, types).filter(|_| typed) {
            Some(near) => diagnostic.label(format!("did you mean `{near}`?")).fix(
                Applicability::Unsafe,
                format!("write `{near}`"),
                place,
                near,
            ),
            None if typed => diagnostic.note(note),
            None => diagnostic.note(note).fix(
                Applicability::Unsafe,
                "make it an object",
                TextRange::empty(place.start),
                "Object ",
            ),
        });
    }
    let message = format!("expected a parameter, found {}", site.name_of(site.at));
    Some(Diagnostic::new(E0112, place, message).note(note))
}

/// An allowance without parentheses.
pub fn allowance(site: &Site<'_>) -> Option<Finding> {
    let allows = matches!(site.kind(site.head)?, Kind::AllowCollide | Kind::AllowOutside | Kind::AllowFloat);
    if !allows || site.at != site.head + 1 {
        return None;
    }
    let word = site.slice(site.head);
    let message = format!("expected `(` after `{word}`, found {}", site.name_of(site.at));
    let arguments = if word == "allowCollide" { "a, b" } else { "a" };
    Some(Diagnostic::new(E0110, site.range(site.at), message).note(format!("write `{word}({arguments});`")))
}

/// The path of an import.
pub fn import(site: &Site<'_>) -> Option<Finding> {
    if site.kind(site.head) != Some(Kind::Import) || !site.wanted.has(Wanted::STRING) {
        return None;
    }
    let Some(last) = site.kinds.len().checked_sub(1).filter(|last| *last >= site.at) else {
        return Some(Diagnostic::new(E0112, site.range(site.head), "the path of the file is missing after `import`"));
    };
    let path = site.range(site.at).cover(site.range(last));
    let quoted = format!("\"{}\"", &site.text[path.bytes()]);
    let diagnostic = Diagnostic::new(E0110, path, "the path of an import is written in double quotes");
    Some(diagnostic.fix(Applicability::Unsafe, format!("write {}", super::quote(&quoted)), path, quoted))
}

/// Something that begins no statement at all.
pub fn first_word(site: &Site<'_>) -> Option<Finding> {
    let found = site.found().filter(|_| site.at == site.head)?;
    let place = site.range(site.at);
    let condition = matches!(found, Kind::Not | Kind::Forall | Kind::Exists | Kind::Count | Kind::LParen)
        || matches!(found, Kind::True | Kind::False | Kind::Number | Kind::Minus | Kind::Objects)
        || is_constructor(found);
    if condition {
        return Some(assert_it(Diagnostic::new(E0110, place, UNASSERTED), place));
    }
    let diagnostic = Diagnostic::new(E0115, place, format!("a statement cannot begin with {}", site.name_of(site.at)));
    Some(match site.after {
        After::Semicolon(_) if site.at + 1 == site.kinds.len() => {
            diagnostic.fix(Applicability::Unsafe, "remove it", place, "")
        }
        _ => diagnostic,
    })
}

fn is_name(text: &str) -> bool {
    is_word(text) && text.chars().all(unicode_ident::is_xid_continue)
}
