//! Names of a program, made of words.

use scenelang_lang::token::{Kind, lex};
use std::collections::BTreeSet;

/// The longest name, in characters.
const LONGEST: usize = 40;

/// Words that no name may be: reserved ones, and those that mean something where a name may stand.
const TAKEN: &[&str] = &[
    "object",
    "entity",
    "region",
    "assert",
    "allowCollide",
    "allowOutside",
    "allowFloat",
    "and",
    "or",
    "not",
    "true",
    "false",
    "inside",
    "rand",
    "vec3",
    "rot",
    "dot",
    "Number",
    "Degree",
    "Bool",
    "Vector3",
    "Rotation",
    "Color",
    "Material",
    "prefer",
    "weight",
    "predicate",
    "import",
    "forall",
    "exists",
    "count",
    "in",
    "where",
    "implies",
    "objects",
    "front",
    "behind",
    "left",
    "right",
    "above",
    "Object",
    "Region",
    "Objects",
    "String",
];

/// Words as one name: "Meeting room" is `meetingRoom`. What is no letter or digit of ASCII separates words; `fallback`
/// is taken where nothing is left.
pub fn identifier(words: &str, fallback: &str) -> String {
    let mut name = String::new();
    let words = words.chars().map(plain).collect::<String>();
    for word in words.split(|c: char| !c.is_ascii_alphanumeric()).filter(|w| !w.is_empty()) {
        let mut letters = word.chars();
        let Some(first) = letters.next() else { continue };
        if name.is_empty() {
            if first.is_ascii_digit() {
                name.push('n');
            }
            name.push(first.to_ascii_lowercase());
        } else {
            name.push(first.to_ascii_uppercase());
        }
        name.extend(letters);
    }
    name.truncate(LONGEST);
    if name.is_empty() { fallback.to_owned() } else { name }
}

/// The letter without its accent, where it is one of those that English words are written with: "café", "crèche", "piñata".
fn plain(c: char) -> char {
    match c {
        'à' | 'á' | 'â' | 'ä' | 'ã' | 'å' => 'a',
        'ç' => 'c',
        'è' | 'é' | 'ê' | 'ë' => 'e',
        'ì' | 'í' | 'î' | 'ï' => 'i',
        'ñ' => 'n',
        'ò' | 'ó' | 'ô' | 'ö' | 'ø' => 'o',
        'ù' | 'ú' | 'û' | 'ü' => 'u',
        'É' => 'E',
        _ => c,
    }
}

/// Names given so far: each is given once.
#[derive(Clone, Debug, Default)]
pub struct GivenNames {
    given: BTreeSet<String>,
}

impl GivenNames {
    /// A name like this one that nothing else has yet.
    pub fn take(&mut self, wanted: &str) -> String {
        let free = |name: &String| !self.given.contains(name) && !TAKEN.contains(&name.as_str());
        let numbered = (2..).map(|n| format!("{wanted}{n}"));
        let name = std::iter::once(wanted.to_owned()).chain(numbered).find(free).unwrap_or_default();
        self.given.insert(name.clone());
        name
    }
}

/// The names that stand in a piece of a program, in order; texts and reserved words are none.
pub fn words(code: &str) -> Vec<&str> {
    let names = lex(code).into_iter().filter(|token| token.kind == Kind::Ident);
    names.map(|token| &code[token.range.bytes()]).collect()
}

/// Whether a name stands in a piece of a program. Most texts do not have its letters at all, and to cut them into tokens
/// takes much longer than to see that.
pub fn mentions(code: &str, name: &str) -> bool {
    code.contains(name) && words(code).contains(&name)
}

/// The names that are called in a statement.
pub fn calls(text: &str) -> Vec<&str> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let starts = text.match_indices('(').map(|(at, _)| &text[..at]);
    let names = starts.map(|before| before.rsplit(|c: char| !is_name(c)).next().unwrap_or_default());
    names.filter(|name| !name.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_become_names() {
        let cases = [
            ("Meeting room", "meetingRoom"),
            ("office_chair", "officeChair"),
            ("3-seat sofa", "n3SeatSofa"),
            ("<script>alert(1)</script>", "scriptAlert1Script"),
            ("a Café", "aCafe"),
            ("ロボット", "thing"),
            ("../../etc/passwd", "etcPasswd"),
        ];
        for (words, expected) in cases {
            assert_eq!(identifier(words, "thing"), expected);
        }
        assert_eq!(identifier(&"x".repeat(5000), "thing").len(), LONGEST);
    }

    #[test]
    fn each_name_once_and_none_reserved() {
        let mut names = GivenNames::default();
        let taken = ["lamp", "lamp", "object", "lamp", "front"].map(|w| names.take(w));
        assert_eq!(taken, ["lamp", "lamp2", "object2", "lamp3", "front2"]);
    }

    #[test]
    fn words_of_code() {
        assert_eq!(words("near(a, b[0], 0.5) and a.color = \"in \\\"red\\\"\""), ["near", "a", "b", "a", "color"]);
    }
}
