//! Text → words, numbers and signs, each with its bytes.

use std::ops::Range;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WordKind {
    /// Letters, hyphens, apostrophes.
    Word,
    /// Written in digits.
    Number(f64),
    Sign(char),
    /// The end of a line; several in a row are one.
    Line,
    /// What begins an item of a list: `-`, `*`, `1.` at the start of a line.
    Bullet,
}

/// A token: its kind, how it is compared (lower case, no possessive), its bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    pub kind: WordKind,
    /// In lower case; a possessive `'s` is left out.
    pub text: String,
    /// Bytes of the request.
    pub at: Range<usize>,
    /// Whether it had a possessive `'s`: "teacher's".
    pub owner: bool,
    /// Whether it began with a capital letter.
    pub capital: bool,
}

impl Token {
    /// Whether it is this word or sign.
    pub fn is(&self, text: &str) -> bool {
        self.text == text
    }

    /// Whether it is a word.
    pub fn word(&self) -> bool {
        self.kind == WordKind::Word
    }

    /// Whether a sentence ends here.
    pub fn stops(&self) -> bool {
        matches!(self.kind, WordKind::Line | WordKind::Sign('.' | '!' | '?' | ';'))
    }

    /// Another word, said where this one is.
    pub fn saying(&self, text: &str) -> Self {
        Self { kind: WordKind::Word, text: text.to_owned(), at: self.at.clone(), owner: false, capital: false }
    }
}

/// Words that may be shortened, with a full stop behind them.
const ABBREVIATED: &[&str] =
    &["no", "nos", "approx", "ca", "min", "max", "incl", "dia", "qty", "pcs", "ft", "sq", "dist", "ht"];

/// The tokens of a text; at most `most`, and the byte where reading ended.
pub fn tokens(text: &str, most: usize) -> (Vec<Token>, usize) {
    let mut out: Vec<Token> = Vec::new();
    let mut at = 0;
    let text = &super::unwrapped::unwrapped(text)[..];
    while at < text.len() && out.len() < most {
        let rest = &text[at..];
        let c = rest.chars().next().unwrap_or(' ');
        // "w/" is "with" where messages are short.
        if rest.starts_with("w/") && out.last().is_none_or(|t| t.at.end != at) {
            let len = if rest.starts_with("w/o") { 3 } else { 2 };
            let text = if len == 3 { "without" } else { "with" };
            out.push(Token { kind: WordKind::Word, text: text.into(), at: at..at + len, owner: false, capital: false });
            at += len;
            continue;
        }
        // "4 no., grey", "approx. 2 m": no end of a sentence.
        if c == '.'
            && out.last().is_some_and(|t| t.at.end == at && ABBREVIATED.contains(&t.text.as_str()))
            && (!out.last().is_some_and(|t| t.is("no"))
                || out.iter().rev().nth(1).is_some_and(|t| matches!(t.kind, WordKind::Number(_))))
            && !rest[1..].trim_start_matches([' ', '\t']).starts_with(|n: char| n.is_uppercase() || n == '\n')
            && rest.len() > 1
        {
            at += 1;
            continue;
        }
        let fresh = out.last().is_none_or(|t| t.kind == WordKind::Line);
        let (len, found) = if c == '\n' || c == '\r' {
            (1, if fresh { None } else { Some((WordKind::Line, "\n".to_owned(), false)) })
        } else if c.is_whitespace() {
            (c.len_utf8(), None)
        } else if fresh && let Some(len) = bullet(rest) {
            let number = if rest.starts_with(|c: char| c.is_ascii_digit()) { &rest[..len] } else { "" };
            (len, Some((WordKind::Bullet, number.to_owned(), false)))
        } else if let Some((len, part)) = fraction(rest) {
            // "1 1/2", "2½": a whole number before it belongs to it.
            let whole = out.last().and_then(|t| match t.kind {
                WordKind::Number(n) if n.fract() == 0.0 && text[t.at.end..at].trim().is_empty() => {
                    Some((n, t.at.start))
                }
                _ => None,
            });
            let (value, start) = whole.map_or((part, at), |(n, start)| (n + part, start));
            if whole.is_some() {
                out.pop();
            }
            let kind = WordKind::Number(value);
            out.push(Token { kind, text: value.to_string(), at: start..at + len, owner: false, capital: false });
            (len, None)
        } else if c.is_ascii_digit() || (c == '.' && rest[1..].starts_with(|d: char| d.is_ascii_digit())) {
            let (len, value) = number(rest);
            // "3D", "4K": a word.
            let letters: String = rest[len..].chars().take_while(|c| c.is_alphabetic()).collect();
            let lower = letters.to_lowercase();
            let all = len + letters.len();
            if let Some(text) = nth(&lower, value).map(str::to_owned).or_else(|| when(&lower, value, &rest[..all])) {
                out.push(Token { kind: WordKind::Word, text, at: at..at + all, owner: false, capital: false });
                at += all;
                continue;
            }
            let unit = super::number::unit(&lower).is_some() || lower.starts_with('x') || lower.starts_with("sq");
            if letters.is_empty() || unit || letters.len() > 2 || letters.chars().any(char::is_lowercase) {
                (len, Some((WordKind::Number(value), rest[..len].to_owned(), false)))
            } else {
                (all, Some((WordKind::Word, rest[..all].to_lowercase(), false)))
            }
        } else if matches!(c, '“' | '”' | '*' | '`') && !is_after_number(&out, at) && touches_word(text, at, c) {
            // Quoted or emphasised words are words.
            (c.len_utf8(), None)
        } else if c.is_alphabetic() {
            let (len, text, owner) = word(rest);
            (len, Some((WordKind::Word, text, owner)))
        } else {
            let sign = match c {
                '×' => 'x',
                '’' | '‘' | '′' => '\'',
                '“' | '”' | '″' => '"',
                '–' | '—' => '—',
                c => c,
            };
            (c.len_utf8(), Some((WordKind::Sign(sign), sign.to_string(), false)))
        };
        if let Some((kind, text, owner)) = found {
            out.push(Token { kind, text, at: at..at + len, owner, capital: c.is_uppercase() });
        }
        at += len;
    }
    (joined(out), at)
}

/// "1st", "2nd": in words.
fn nth(letters: &str, value: f64) -> Option<&'static str> {
    const WORDS: [&str; 10] =
        ["first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"];
    let at = (1..=WORDS.len()).find(|n| *n as f64 == value)?;
    matches!(letters, "st" | "nd" | "rd" | "th").then(|| WORDS[at - 1])
}

/// "1930s", "14th": when, and no number of anything.
fn when(letters: &str, value: f64, text: &str) -> Option<String> {
    let decade = letters == "s" && (1000.0..2100.0).contains(&value) && value % 10.0 == 0.0;
    (decade || matches!(letters, "th" | "st" | "nd" | "rd")).then(|| text.to_lowercase())
}

/// Whether a sign is at the beginning or the end of a word: no "7 * 5".
fn touches_word(text: &str, at: usize, sign: char) -> bool {
    let is_of_word = |c: char| c.is_alphanumeric() || c == sign;
    text[at + sign.len_utf8()..].starts_with(is_of_word) || text[..at].ends_with(is_of_word)
}

/// Whether a number ends where a sign stands: 6” are inches.
fn is_after_number(out: &[Token], at: usize) -> bool {
    out.last().is_some_and(|t| matches!(t.kind, WordKind::Number(_)) && t.at.end == at)
}

/// "1/2", "3/4", "½": a part of one, and its length in bytes.
fn fraction(rest: &str) -> Option<(usize, f64)> {
    const SIGNS: [(char, f64); 5] = [('½', 0.5), ('¼', 0.25), ('¾', 0.75), ('⅓', 1.0 / 3.0), ('⅔', 2.0 / 3.0)];
    if let Some((sign, part)) = SIGNS.iter().find(|(sign, _)| rest.starts_with(*sign)) {
        return Some((sign.len_utf8(), *part));
    }
    let (over, under) = rest.split_once('/')?;
    let digits = under.bytes().take_while(u8::is_ascii_digit).count();
    let [over_number, under_number] = [over, &under[..digits]].map(|n| n.parse::<u8>().ok());
    let (over_number, under_number) = (over_number?, under_number?);
    // "24/7" and "9/10 m" are dates and the like, and a half is no "2/4".
    let is_part = over_number < under_number && matches!(under_number, 2 | 3 | 4 | 8) && over.len() == 1;
    is_part.then(|| (over.len() + 1 + digits, f64::from(over_number) / f64::from(under_number)))
}

/// `-`, `*`, `•`, `##`, `1.`, `2)`, `a)` before a blank.
fn bullet(rest: &str) -> Option<usize> {
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    // "2.1 The office", but not "2.1 m".
    if digits > 0 && rest[digits..].starts_with('.') && rest.as_bytes().get(digits + 1).is_some_and(u8::is_ascii_digit)
    {
        let len = rest.bytes().take_while(|b| b.is_ascii_digit() || *b == b'.').count();
        let capital = rest[len..].trim_start_matches([' ', '\t']).starts_with(char::is_uppercase);
        return (capital && rest[len..].starts_with([' ', '\t'])).then_some(len);
    }
    let sign = rest.chars().next().filter(|c| "-*•·–—+▪◦".contains(*c)).map(char::len_utf8);
    if rest.starts_with('#') {
        let signs = rest.bytes().take_while(|b| *b == b'#').count();
        return rest[signs..].starts_with([' ', '\t']).then_some(signs);
    }
    let len = match sign {
        Some(len) => len,
        None if (1..3).contains(&digits) && rest[digits..].starts_with(['.', ')']) => digits + 1,
        None if rest.as_bytes().get(1) == Some(&b')') && rest.as_bytes()[0].is_ascii_alphabetic() => 2,
        None => return None,
    };
    rest[len..].starts_with([' ', '\t']).then_some(len)
}

/// `12`, `2.6`, `1,5` (a comma before one or two digits), `1,200`.
fn number(rest: &str) -> (usize, f64) {
    let bytes = rest.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
    let mut len = digits(0);
    let mut text = rest[..len].to_owned();
    if matches!(bytes.get(len), Some(b'.' | b',')) {
        let after = digits(len + 1);
        let comma = bytes[len] == b',';
        if after > 0 && (!comma || after <= 2) {
            text.push('.');
            text.push_str(&rest[len + 1..=len + after]);
            len += 1 + after;
        } else if comma && after == 3 {
            text.push_str(&rest[len + 1..=len + after]);
            len += 1 + after;
        }
    }
    (len, text.parse().unwrap_or(0.0))
}

/// Several who own something, written with an apostrophe that is no closing quote.
const OWNERS: [&str; 16] = [
    "kids",
    "boys",
    "girls",
    "teachers",
    "students",
    "pupils",
    "nurses",
    "doctors",
    "guests",
    "visitors",
    "players",
    "workers",
    "parents",
    "teenagers",
    "toddlers",
    "twins",
];

fn word(rest: &str) -> (usize, String, bool) {
    let mut len = 0;
    let mut chars = rest.char_indices().peekable();
    while let Some((i, c)) = chars.next() {
        let inner = matches!(c, '\'' | '’' | '´' | '`' | 'ʼ' | '-' | '‐' | '‑' | '–' | '_')
            && i > 0
            && chars.peek().is_some_and(|(_, n)| n.is_alphanumeric());
        if !(c.is_alphabetic() || inner || (c.is_numeric() && i > 0 && rest[..i].ends_with('-'))) {
            break;
        }
        len = i + c.len_utf8();
    }
    // "Café" and "cafe" are one word.
    let text = rest[..len]
        .to_lowercase()
        .replace(['’', '´', '`', 'ʼ'], "'")
        .replace(['_', '‐', '‑', '–'], "-")
        .replace(['é', 'è', 'ê'], "e");
    // What is no possessive of a thing: "it's", "let's", "there's".
    let owner = text.strip_suffix("'s").filter(|w| !["it", "let", "there", "that", "here", "what", "who"].contains(w));
    // "The kids' bedroom".
    let closes = rest[len..].starts_with("' ") || rest[len..].starts_with("’ ");
    if closes && OWNERS.contains(&text.as_str()) {
        return (len + rest[len..].find(' ').unwrap_or(0), text, true);
    }
    match owner {
        Some(w) => (len, w.to_owned(), true),
        None => {
            let text = if text.ends_with("n't") { "not".to_owned() } else { text };
            (len, text, false)
        }
    }
}

/// "it's made of oak", "they're white": a pronoun and its verb.
fn contracted(word: Token) -> Vec<Token> {
    let Some((pronoun, verb)) = word.text.split_once('\'') else { return vec![word] };
    let whole = match (pronoun, verb) {
        ("it" | "that", "s") => "is",
        ("they" | "these" | "those", "re") => "are",
        _ => return vec![word],
    };
    let end = (word.at.start + pronoun.len()).min(word.at.end);
    let part = |text: &str, at| Token { kind: WordKind::Word, text: text.to_owned(), at, ..word.clone() };
    vec![part(pronoun, word.at.start..end), part(whole, end..word.at.end)]
}

/// "8-foot-long": the unit, and which side of a thing is so long. Other words stay whole.
fn unit_and_side(word: Token) -> Vec<Token> {
    const SIDES: [&str; 7] = ["long", "wide", "deep", "high", "tall", "diameter", "across"];
    let mut parts: Vec<&str> = word.text.split('-').collect();
    let sided = parts.pop().is_some_and(|side| SIDES.contains(&side));
    let [.., unit] = parts[..] else { return vec![word] };
    // Lower case may be longer than what was written; then the word stays whole.
    if !sided || parts.len() > 2 || super::number::unit(unit).is_none() || word.at.len() != word.text.len() {
        return vec![word];
    }
    let end = word.text.rfind('-').unwrap_or(0);
    let part = |from: usize, to: usize| Token {
        kind: WordKind::Word,
        text: word.text[from..to].to_owned(),
        at: word.at.start + from..word.at.start + to,
        ..word.clone()
    };
    vec![part(0, end), part(end + 1, word.text.len())]
}

/// "two-metre" and "90-cm" are two words: the number, and what it counts.
fn joined(tokens: Vec<Token>) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
    let mut tokens = tokens.into_iter().flat_map(contracted).flat_map(unit_and_side).peekable();
    while let Some(t) = tokens.next() {
        let number_before = out.last().is_some_and(|b| matches!(b.kind, WordKind::Number(_)) && b.at.end == t.at.start);
        if t.kind == WordKind::Sign('-')
            && number_before
            && tokens.peek().is_some_and(|n| n.word() && n.at.start == t.at.end)
        {
            let unit = |n: &Token| super::number::unit(n.text.split('-').next().unwrap_or("")).is_some();
            // "a 4-burner stove": one stove.
            if !tokens.peek().is_some_and(unit)
                && let Some(number) = out.pop()
                && let Some(rest) = tokens.next()
            {
                let text = format!("{}-{}", number.text, rest.text);
                out.push(Token { kind: WordKind::Word, text, at: number.at.start..rest.at.end, ..rest });
            }
            continue;
        }
        // "5x4", "6x4m": the sign between two sizes, not a letter of a word.
        if t.word() && number_before && t.text == "x" {
            out.push(Token { kind: WordKind::Sign('x'), ..t });
            continue;
        }
        // "six-burner", "three-door": a look of one thing, and not so many of it.
        let measured = |rest: &str| super::number::unit(rest.split('-').next().unwrap_or(rest)).is_some();
        let halves =
            t.text.split_once('-').filter(|(n, rest)| t.word() && super::number::small(n).is_some() && measured(rest));
        match halves {
            Some((first, second))
                if super::number::small(second).is_none() && !super::lexicon::get().is_look(&t.text) =>
            {
                let cut = t.at.start + first.len();
                // Lower case may be longer than what was written; then the word stays whole.
                if cut + 1 + second.len() == t.at.end && !t.owner {
                    let part = |text: &str, at| Token { kind: WordKind::Word, text: text.to_owned(), at, ..t.clone() };
                    out.push(part(first, t.at.start..cut));
                    out.push(part(second, cut + 1..t.at.end));
                } else {
                    out.push(t);
                }
            }
            _ => out.push(t),
        }
    }
    sides(&mut out);
    halves(&mut out);
    out
}

/// "Half a metre": 0.5 metres, so that "half" is no part of a name before it.
fn halves(tokens: &mut Vec<Token>) {
    let is_half = |k: usize| {
        let unit =
            tokens.get(k + 2).is_some_and(|t| t.word() && super::number::unit(&t.text).is_some() && t.text.len() > 1);
        unit && tokens[k].is("half") && (tokens[k + 1].is("a") || tokens[k + 1].is("an"))
    };
    for k in (0..tokens.len()).filter(|k| is_half(*k)).rev().collect::<Vec<_>>() {
        tokens[k].kind = WordKind::Number(0.5);
        tokens[k].at.end = tokens[k + 1].at.end;
        tokens.remove(k + 1);
    }
}

/// "the longer side" is the long one: no comparison with anything else.
fn sides(tokens: &mut [Token]) {
    for at in 1..tokens.len() {
        if matches!(tokens[at].text.as_str(), "side" | "sides" | "edge" | "edges") {
            let text = match tokens[at - 1].text.as_str() {
                "longer" | "longest" => "long",
                "shorter" | "shortest" => "short",
                _ => continue,
            };
            tokens[at - 1].text = text.to_owned();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(text: &str) -> String {
        tokens(text, 1000).0.iter().map(|t| t.text.clone()).collect::<Vec<_>>().join("|")
    }

    #[test]
    fn words_numbers_and_signs() {
        for (text, want) in [
            ("a 5x4 m room", "a|5|x|4|m|room"),
            ("a teacher's desk, 1,5 m", "a|teacher|desk|,|1.5|m"),
            ("two-metre counter", "two|metre|counter"),
            ("twenty-four height-adjustable desks", "twenty-four|height-adjustable|desks"),
            ("- a sofa\n- a lamp", "|a|sofa|\n||a|lamp"),
            ("90-cm-wide", "90|cm|wide"),
            ("three 8-foot-long benches", "three|8|foot|long|benches"),
            ("a two-metre-high shelf", "a|two|metre|high|shelf"),
            ("a floor-length curtain, life-long", "a|floor-length|curtain|,|life-long"),
            ("it's red, they're 2 m high, let's", "it|is|red|,|they|are|2|m|high|,|let's"),
            ("a nook w/ a chair", "a|nook|with|a|chair"),
            ("a 6m-by-4m room, six-by-four-metre", "a|6|m|by|4|m|room|,|six|by|four|metre"),
            ("1 1/2 m, ½ m, 2½ m, 3/4 in", "1.5|m|,|0.5|m|,|2.5|m|,|0.75|in"),
            ("a “walk‑in” closet, **table**", "a|walk-in|closet|,|table"),
            ("the 2nd and 3rd desk", "the|second|and|third|desk"),
            ("300 sq. ft. of floor", "300|sq|ft|of|floor"),
            ("its longer side, longer than it", "its|long|side|,|longer|than|it"),
        ] {
            let got = texts(text);
            assert_eq!(got.replace("1,5", "1.5"), want, "{text}");
        }
    }
}
