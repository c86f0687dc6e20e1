//! The values of numbers and strings, and what is wrong with those that have none.

use crate::ast::UnitSuffix;
use std::ops::Range;

/// The value of a number as written, and its unit; `None` if it has none (`1e999`, `3kg`).
pub fn number_value(text: &str) -> Option<(f64, Option<UnitSuffix>)> {
    let (digits, unit) = split_unit(text);
    let unit = match unit {
        "" => None,
        "m" => Some(UnitSuffix::M),
        "cm" => Some(UnitSuffix::Cm),
        "mm" => Some(UnitSuffix::Mm),
        "ft" => Some(UnitSuffix::Ft),
        "in" => Some(UnitSuffix::In),
        "deg" => Some(UnitSuffix::Deg),
        "rad" => Some(UnitSuffix::Rad),
        _ => return None,
    };
    digits.parse().ok().filter(|value: &f64| value.is_finite()).map(|value| (value, unit))
}

/// Cuts a number token before what follows its digits: a unit, or what should have been one.
pub fn split_unit(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') {
        end += 1 + digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits((end + 1 + sign).min(bytes.len()));
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    text.split_at(end)
}

/// The text that a string token stands for, its quotation marks of whatever kind taken off. Unknown escapes stay as
/// they are written: they are reported elsewhere.
pub fn string_value(token: &str) -> String {
    let text = without_first(token);
    let text = if is_closed(token) { &text[..text.len() - last_len(text)] } else { text };
    let mut value = String::with_capacity(text.len());
    let mut at = 0;
    while let Some(found) = text[at..].find('\\') {
        value.push_str(&text[at..at + found]);
        at += found;
        match escape(&text[at..]) {
            Ok((c, len)) => {
                value.push(c);
                at += len;
            }
            Err(len) => {
                value.push_str(&text[at..at + len]);
                at += len;
            }
        }
    }
    value.push_str(&text[at..]);
    value
}

/// Whether a string token ends in its quotation mark.
pub fn is_closed(token: &str) -> bool {
    let text = without_first(token);
    let closes = |c: char| if token.starts_with('"') { c == '"' } else { is_quote(c) };
    // Only a straight string can end in an escaped quote, and then it is an open one.
    text.chars().next_back().is_some_and(closes) && !ends_in_escape(text)
}

/// The bytes of the first escape in a string token that is none.
pub fn bad_escape(token: &str) -> Option<Range<usize>> {
    let mut at = 0;
    while let Some(found) = token[at..].find('\\') {
        at += found;
        match escape(&token[at..]) {
            Ok((_, len)) => at += len,
            Err(len) => return Some(at..at + len),
        }
    }
    None
}

/// What an escape at the start of `text` stands for, and its length; or the length of what is no escape.
fn escape(text: &str) -> Result<(char, usize), usize> {
    let mut chars = text.chars().skip(1);
    let simple = match chars.next() {
        Some('"') => '"',
        Some('\\') => '\\',
        Some('/') => '/',
        Some('n') => '\n',
        Some('r') => '\r',
        Some('t') => '\t',
        Some('u') => return unicode_escape(text),
        Some(c) => return Err(1 + c.len_utf8()),
        None => return Err(1),
    };
    Ok((simple, 2))
}

/// `\uXXXX`, or two of them for a character beyond the first plane (as in JSON).
fn unicode_escape(text: &str) -> Result<(char, usize), usize> {
    let unit = |at: usize| -> Option<u32> {
        let digits = text.get(at..at + 6)?.strip_prefix("\\u")?;
        digits.bytes().all(|b| b.is_ascii_hexdigit()).then(|| u32::from_str_radix(digits, 16).ok())?
    };
    let hex = text[2..].bytes().take(4).take_while(u8::is_ascii_hexdigit).count();
    let first = unit(0).ok_or(2 + hex)?;
    if let Some(c) = char::from_u32(first) {
        return Ok((c, 6));
    }
    match unit(6) {
        Some(low @ 0xdc00..=0xdfff) if first < 0xdc00 => {
            let code = 0x10000 + ((first - 0xd800) << 10) + (low - 0xdc00);
            char::from_u32(code).map(|c| (c, 12)).ok_or(6)
        }
        _ => Err(6),
    }
}

fn without_first(text: &str) -> &str {
    let mut chars = text.chars();
    chars.next();
    chars.as_str()
}

fn is_quote(c: char) -> bool {
    matches!(c, '"' | '\'' | '`' | '“' | '”' | '„' | '‟' | '‘' | '’' | '‚' | '»')
}

fn last_len(text: &str) -> usize {
    text.chars().next_back().map_or(0, char::len_utf8)
}

/// Whether the last character is escaped by a backslash.
fn ends_in_escape(text: &str) -> bool {
    let before = &text[..text.len() - last_len(text)];
    before.bytes().rev().take_while(|&b| b == b'\\').count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_values_and_units() {
        let cases = [
            ("5.", Some((5.0, None))),
            (".5", Some((0.5, None))),
            ("5.e3", Some((5000.0, None))),
            ("30cm", Some((30.0, Some(UnitSuffix::Cm)))),
            ("1e3m", Some((1000.0, Some(UnitSuffix::M)))),
            ("5in", Some((5.0, Some(UnitSuffix::In)))),
            ("1e999", None),
            ("1e", None),
            ("3kg", None),
            ("1.2.3", None),
        ];
        for (text, expected) in cases {
            assert_eq!(number_value(text), expected, "{text}");
        }
    }

    #[test]
    fn strings_have_values() {
        let cases = [
            (r#""red""#, "red"),
            (r#""a\"b\\c\/\n\r\té""#, "a\"b\\c/\n\r\té"),
            (r#""\ud83d\ude00""#, "😀"),
            (r#""\q""#, "\\q"),
            (r#""open"#, "open"),
            (r#""open\""#, "open\""),
            ("\"", ""),
            ("\"red”", "red”"),
            ("“red”", "red"),
            ("'red'", "red"),
        ];
        for (text, expected) in cases {
            assert_eq!(string_value(text), expected, "{text}");
        }
    }

    #[test]
    fn bad_escapes_are_found() {
        let cases = [
            (r#""fine \n \" \u00e9""#, None),
            (r#""r\qd""#, Some(2..4)),
            (r#""\u12""#, Some(1..5)),
            (r#""\ud83d""#, Some(1..7)),
            (r#""\é""#, Some(1..4)),
        ];
        for (text, expected) in cases {
            assert_eq!(bad_escape(text), expected, "{text}");
        }
    }
}
