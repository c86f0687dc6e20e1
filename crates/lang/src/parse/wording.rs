//! How messages name what stands in the text.

use crate::token::Kind;

/// The longest piece of the user's text that a message repeats, in characters.
const LONGEST: usize = 40;

/// A piece of the user's text in backquotes: shortened, on one line, without control characters.
pub fn quote(text: &str) -> String {
    let mut shown: String = text.chars().take(LONGEST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    format!("`{shown}`")
}

/// A token as a sentence names it: "the name `lamp`", "`)`".
pub fn describe(kind: Kind, text: &str) -> String {
    let text = quote(text);
    match kind {
        Kind::Ident | Kind::Objects => format!("the name {text}"),
        Kind::Number => format!("the number {text}"),
        Kind::Str => format!("the string {text}"),
        Kind::True | Kind::False | Kind::And | Kind::Or | Kind::Not => text,
        _ if text.starts_with("`@") => text,
        _ if super::words::is_word(text.trim_matches('`')) => format!("the word {text}"),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotes_are_short_and_on_one_line() {
        assert_eq!(quote("a\nb\0"), "`a b `");
        assert_eq!(quote(&"é".repeat(100)), format!("`{}…`", "é".repeat(40)));
        assert_eq!(describe(Kind::Ident, "lamp"), "the name `lamp`");
        assert_eq!(describe(Kind::Region, "region"), "the word `region`");
        assert_eq!(describe(Kind::RParen, ")"), "`)`");
    }
}
