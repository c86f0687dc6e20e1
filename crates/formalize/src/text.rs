//! Text of a request inside a program: its sentences, quoted so that whatever it holds stays text.

use std::ops::Range;

/// The longest sentence that is quoted whole, in bytes; of a longer one the words around the place are.
const LONGEST: usize = 400;

/// Words that end with a full stop inside a sentence.
const SHORT: &[&str] =
    &["approx", "e.g", "i.e", "ca", "incl", "min", "max", "vs", "no", "dr", "mr", "mrs", "st", "fig"];

/// The sentence of a request that contains some bytes, its blanks folded.
pub fn sentence(request: &str, at: &Range<usize>) -> String {
    let whole = sentence_range(request, at);
    folded(&request[whole])
}

/// The words of a request at some bytes, word for word, its blanks folded; where they are too many, or none, the
/// sentence around their beginning.
pub fn phrase(request: &str, at: &Range<usize>) -> String {
    match request.get(at.clone()) {
        Some(words) if words.len() <= LONGEST && !words.trim().is_empty() => folded(words),
        _ => sentence(request, at),
    }
}

/// The bytes of the sentence that contains others; of one too long the words near them.
pub fn sentence_range(request: &str, at: &Range<usize>) -> Range<usize> {
    let start = floor(request, at.start.min(request.len()));
    let end = floor(request, at.end.clamp(start, request.len()));
    let first = floor(request, start.saturating_sub(LONGEST));
    let last = floor(request, (end.min(start + LONGEST) + LONGEST).min(request.len()));
    let mut from = first;
    let mut to = last;
    for (offset, _) in request[first..last].char_indices() {
        let place = first + offset;
        if !ends_at(request, place) {
            continue;
        }
        let behind = place + request[place..].chars().next().map_or(1, char::len_utf8);
        if behind <= start {
            from = behind;
        } else if behind >= end {
            to = behind;
            break;
        }
    }
    let cut = &request[from..to];
    let from = from + (cut.len() - cut.trim_start().len());
    from..(from + cut.trim().len()).max(from)
}

/// All sentences of a request, in order.
pub fn sentence_ranges(request: &str) -> Vec<Range<usize>> {
    let mut out = Vec::new();
    let mut at = 0;
    while let Some(blank) = request.get(at..).and_then(|rest| rest.find(|c: char| !c.is_whitespace())) {
        let start = at + blank;
        let whole = sentence_range(request, &(start..start));
        // Of a text without sentences a piece is as long as can be seen from its start.
        at = whole.end.max(start + request[start..].chars().next().map_or(1, char::len_utf8));
        out.push(start..at);
    }
    out
}

/// Whether a sentence ends with the character at a place.
fn ends_at(text: &str, at: usize) -> bool {
    let rest = &text[at..];
    let mut after = rest.chars();
    let Some(mark) = after.next() else { return false };
    match mark {
        '。' | '！' | '？' => true,
        '!' | '?' => after.next().is_none_or(|c| c.is_whitespace() || matches!(c, '"' | '\'' | '”' | ')')),
        '.' => {
            let closed = after.next().is_none_or(char::is_whitespace);
            let word_start = text[..at].rfind(char::is_whitespace).map_or(0, |i| i + 1);
            let word = text.get(word_start..at).unwrap_or("").trim_start_matches(['(', '"']);
            let more = !after.as_str().trim().is_empty();
            closed && !(more && SHORT.iter().any(|short| word.eq_ignore_ascii_case(short)))
        }
        '\n' => {
            let line = after.as_str().trim_start_matches([' ', '\t', '\r']);
            let number = line.trim_start_matches(|c: char| c.is_ascii_digit());
            line.starts_with(['\n', '-', '*', '•']) || number.len() < line.len() && number.starts_with(['.', ')'])
        }
        _ => false,
    }
}

/// The next character boundary at or before an offset.
fn floor(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// A text on one line.
pub fn folded(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A text as the language quotes it. What is not seen, or turns the direction of reading, is written as its number.
pub fn quoted(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if is_hidden(c) => {
                for unit in c.encode_utf16(&mut [0; 2]) {
                    out.push_str(&format!("\\u{unit:04x}"));
                }
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A text for a comment: on one line, with nothing hidden in it.
pub fn plain(text: &str) -> String {
    folded(text).chars().filter(|c| !is_hidden(*c)).collect()
}

/// Characters that are not seen, or that make others appear elsewhere.
fn is_hidden(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

/// Lines of at most `width` characters, broken between words.
pub fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_around_a_word() {
        let request = "A room of approx. 2.5 by 3 m. It has two lamps!\nIt is\nred. \n- a desk\n- \"a bed\"";
        let cases = [
            ("2.5", "A room of approx. 2.5 by 3 m."),
            ("lamps", "It has two lamps!"),
            ("red", "It is red."),
            ("desk", "- a desk"),
            ("bed", "- \"a bed\""),
        ];
        for (word, expected) in cases {
            let at = request.find(word).unwrap();
            assert_eq!(sentence(request, &(at..at + word.len())), expected);
        }
        assert_eq!(sentence("", &(0..0)), "");
        let all: Vec<String> = sentence_ranges(request).iter().map(|at| folded(&request[at.clone()])).collect();
        assert_eq!(all, cases.map(|(_, sentence)| sentence));
        let long = "word ".repeat(9000);
        assert_eq!(
            sentence_ranges(&long).iter().map(|at| long[at.clone()].split(' ').count()).sum::<usize>() / 9000,
            1
        );
        assert_eq!(sentence("é", &(1..9)), "é", "places inside a character or behind the end");
        assert!(sentence(&"word ".repeat(9000), &(20_000..20_004)).len() <= 3 * LONGEST);
    }

    #[test]
    fn quoting_keeps_text_text() {
        assert_eq!(quoted("a \"b\" \\ \n\u{202e}x\u{0}"), "\"a \\\"b\\\" \\\\ \\n\\u202ex\\u0000\"");
        assert_eq!(quoted("\u{e0041}"), "\"\\udb40\\udc41\"");
        assert_eq!(plain("a\n*/ b\u{202e}"), "a */ b");
        assert_eq!(wrapped("one two three", 7), ["one two", "three"]);
    }
}
