//! Numbers in words and digits, and lengths: "forty-five centimetres", "one metre ten", "6'", "half a metre".

use super::token::{Token, WordKind};

/// A number in one word: "seven", "twenty-four".
pub fn small(word: &str) -> Option<f64> {
    const WORDS: [&str; 21] = [
        "zero",
        "one",
        "two",
        "three",
        "four",
        "five",
        "six",
        "seven",
        "eight",
        "nine",
        "ten",
        "eleven",
        "twelve",
        "thirteen",
        "fourteen",
        "fifteen",
        "sixteen",
        "seventeen",
        "eighteen",
        "nineteen",
        "twenty",
    ];
    const TENS: [&str; 10] = ["", "", "twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"];
    if let Some(n) = WORDS.iter().position(|w| *w == word) {
        return Some(n as f64);
    }
    if let Some(n) = TENS.iter().position(|w| *w == word && !w.is_empty()) {
        return Some(n as f64 * 10.0);
    }
    let (tens, ones) = word.split_once('-')?;
    let tens = TENS.iter().position(|w| *w == tens && !w.is_empty())?;
    let ones = WORDS[..10].iter().position(|w| *w == ones)?;
    Some((tens * 10 + ones) as f64)
}

/// A number at a place: its value and how many tokens it takes. "a dozen", "half a dozen", "a pair of", "two or three"
/// (the lower), "three and a half".
pub fn count(tokens: &[Token]) -> Option<(f64, usize)> {
    let text = |i: usize| tokens.get(i).map_or("", |t| t.text.as_str());
    let article = usize::from(matches!(text(0), "a" | "one"));
    let of = |n: usize| n + usize::from(text(n) == "of");
    match text(article) {
        "dozen" => return Some((12.0, of(article + 1))),
        "pair" | "couple" => {
            let one = paired(&tokens[article + 1..]);
            return Some((if one { 1.0 } else { 2.0 }, of(article + 1)));
        }
        "half-dozen" => return Some((6.0, of(article + 1))),
        "half" if text(article + 1) == "dozen" => return Some((6.0, of(article + 2))),
        "score" if text(article + 1) == "of" => return Some((20.0, article + 2)),
        "quartet" => return Some((4.0, of(article + 1))),
        "trio" => return Some((3.0, of(article + 1))),
        _ => {}
    }
    if text(0) == "half" && text(1) == "a" && text(2) == "dozen" {
        return Some((6.0, 3));
    }
    let single = |t: &Token| match t.kind {
        WordKind::Number(n) => Some(n),
        WordKind::Word => small(&t.text),
        _ => None,
    };
    // "a hundred" is one hundred.
    let mut value = if text(0) == "a" && text(1) == "hundred" { 1.0 } else { single(tokens.first()?)? };
    let mut used = 1;
    // "twenty four", "one hundred and twenty"
    if tokens[0].word()
        && (20.0..100.0).contains(&value)
        && value % 10.0 == 0.0
        && let Some(ones) = tokens.get(1).filter(|t| t.word()).and_then(single).filter(|n| (1.0..10.0).contains(n))
    {
        value += ones;
        used = 2;
    }
    if text(used) == "hundred" {
        value *= 100.0;
        used += 1;
        let and = usize::from(text(used) == "and");
        if let Some(more) = tokens.get(used + and).filter(|t| t.word()).and_then(single).filter(|n| *n < 100.0) {
            value += more;
            used += and + 1;
        }
    }
    if text(used) == "dozen" {
        return Some((value * 12.0, of(used + 1)));
    }
    if matches!(text(used), "pairs" | "couples") {
        let each = if paired(&tokens[used + 1..]) { 1.0 } else { 2.0 };
        return Some((value * each, of(used + 1)));
    }
    if text(used) == "and" && text(used + 1) == "a" && matches!(text(used + 2), "half" | "quarter") {
        let part = if text(used + 2) == "half" { 0.5 } else { 0.25 };
        return Some((value + part, used + 3));
    }
    // "one point two"
    if text(used) == "point"
        && let Some(tenths) = tokens.get(used + 1).and_then(single).filter(|n| *n < 10.0)
    {
        return Some((value + tenths / 10.0, used + 2));
    }
    // "two or three", "2-3", "2 to 3": what is sure is the lower.
    if matches!(text(used), "or" | "to" | "-" | "—") && tokens.get(used + 1).and_then(single).is_some_and(|n| n > value)
    {
        let unit_after = tokens.get(used + 2).is_some_and(|t| unit(&t.text).is_some());
        if !unit_after {
            return Some((value, used + 2));
        }
    }
    Some((value, used))
}

/// "of black headphones": of what a pair is one thing.
fn paired(rest: &[Token]) -> bool {
    let words = rest.iter().skip(1).take(4).take_while(|t| t.word());
    rest.first().is_some_and(|t| t.is("of"))
        && words.map(|t| t.text.as_str()).any(|w| super::lexicon::get().is(w, super::lexicon::Class::Paired))
}

/// Metres in a unit of length.
pub fn unit(word: &str) -> Option<f64> {
    Some(match word {
        "m" | "metre" | "metres" | "meter" | "meters" | "mtr" | "mtrs" => 1.0,
        "cm" | "centimetre" | "centimetres" | "centimeter" | "centimeters" | "cms" => 0.01,
        "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" => 0.001,
        "ft" | "foot" | "feet" | "'" => 0.3048,
        "in" | "inch" | "inches" | "\"" => 0.0254,
        "dm" | "decimetre" | "decimetres" | "decimeter" | "decimeters" => 0.1,
        "yd" | "yds" | "yard" | "yards" => 0.9144,
        _ => return None,
    })
}

/// What follows "in" where that stands for inches.
const AFTER_INCHES: [&str; 14] =
    ["wide", "high", "tall", "deep", "long", "thick", "across", "x", "by", "clear", "from", "off", "above", "apart"];

/// A length in metres and how many tokens it takes, the unit included.
pub fn length(tokens: &[Token]) -> Option<(f64, usize)> {
    let text = |i: usize| tokens.get(i).map_or("", |t| t.text.as_str());
    match (text(0), text(1), text(2)) {
        ("a" | "one", "quarter", "of") | ("three", "quarters", "of") if text(3) == "a" && unit(text(4)).is_some() => {
            let part = if text(0) == "three" { 0.75 } else { 0.25 };
            return unit(text(4)).map(|m| (m * part, 5));
        }
        ("half", "a", u) if unit(u).is_some() => return unit(u).map(|m| (m / 2.0, 3)),
        ("a" | "one", u, "and") if unit(u).is_some() && text(3) == "a" && text(4) == "half" => {
            return unit(u).map(|m| (m * 1.5, 5));
        }
        ("a", u, _) if unit(u).is_some() && !matches!(u, "m" | "in" | "'" | "\"" | "foot" | "yard") => {
            return unit(u).map(|m| (m, 2));
        }
        ("arm", "length", _) => return Some((0.7, 2)),
        _ => {}
    }
    let (value, mut used) = count(tokens)?;
    let metres = match text(used) {
        // A bare "in" is hardly ever the unit: "two lamps, 3 in each corner".
        "in" if !tokens.get(used + 1).is_some_and(|t| AFTER_INCHES.contains(&t.text.as_str())) => {
            return None;
        }
        u => unit(u)?,
    };
    used += 1;
    let mut total = value * metres;
    // 5'6", 6 ft 2 in, "one metre ten", "two metres and a half", 1 m 20
    let inches = count(&tokens[used..]).filter(|_| metres == 0.3048);
    if let Some((n, k)) = inches
        && matches!(text(used + k), "in" | "inch" | "inches" | "\"")
    {
        return Some((total + n * 0.0254, used + k + 1));
    }
    if metres == 1.0 {
        if text(used) == "and" && text(used + 1) == "a" && text(used + 2) == "half" {
            return Some((total + 0.5, used + 3));
        }
        // "One metre and twenty centimetres".
        if text(used) == "and"
            && let Some((n, k)) = count(&tokens[used + 1..])
            && unit(text(used + 1 + k)) == Some(0.01)
        {
            return Some((total + n * 0.01, used + 2 + k));
        }
        // Ten and more after whole metres are centimetres, if nothing is counted by them.
        let more = count(&tokens[used..])
            .filter(|(n, k)| (10.0..100.0).contains(n) && n.fract() == 0.0 && counts_nothing(tokens.get(used + k)));
        if let Some((n, k)) = more
            && value.fract() == 0.0
        {
            total += n / 100.0;
            used += k;
            if tokens.get(used).is_some_and(|t| unit(&t.text) == Some(0.01)) {
                used += 1;
            }
        }
    }
    Some((total, used))
}

fn counts_nothing(next: Option<&Token>) -> bool {
    next.is_none_or(|t| {
        const SIDES: [&str; 6] = ["wide", "high", "tall", "deep", "long", "thick"];
        !t.word()
            || unit(&t.text) == Some(0.01)
            || SIDES.contains(&t.text.as_str())
            || super::lexicon::get().relation(std::slice::from_ref(t)).is_some()
    })
}

/// Square metres and how many tokens they take: "30 square metres", "30 m²", "320 sq ft", "30 sqm".
pub fn area(tokens: &[Token]) -> Option<(f64, usize)> {
    let (value, used) = count(tokens)?;
    let text = |i: usize| tokens.get(used + i).map_or("", |t| t.text.as_str());
    let (per, more) = match (text(0), text(1)) {
        ("square" | "sq", u) => (unit(u)?.powi(2), 2),
        ("sq.", u) => (unit(u)?.powi(2), 2),
        ("sqm" | "m²" | "qm", _) => (1.0, 1),
        ("m" | "ft", "²" | "2") => (unit(text(0))?.powi(2), 2),
        ("m" | "ft", "^") if text(2) == "2" => (unit(text(0))?.powi(2), 3),
        ("sqft" | "ft²", _) => (0.3048 * 0.3048, 1),
        _ => return None,
    };
    Some((value * per, used + more))
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn lengths() {
        for (text, want) in [
            ("forty-five centimetres up", 0.45),
            ("one metre ten between", 1.10),
            ("a metre and a half", 1.5),
            ("6'2\" tall", 1.8796),
            ("half a metre", 0.5),
            ("120 cm", 1.2),
            ("2.5m", 2.5),
            ("three and a half metres", 3.5),
            ("2 m, 4 chairs", 2.0),
            ("one metre and twenty centimetres from", 1.2),
            ("one metre twenty wide", 1.2),
            ("1m20 wide", 1.2),
            ("a quarter of a metre", 0.25),
            ("three quarters of a metre", 0.75),
            ("three and a quarter metres", 3.25),
            ("1 1/2 m wide", 1.5),
            ("12 dm wide", 1.2),
            ("3 yd", 2.7432),
            ("50 in from", 1.27),
        ] {
            let got = length(&tokens(text, 100).0).map(|l| l.0);
            assert!(got.is_some_and(|g| (g - want).abs() < 1e-9), "{text}: {got:?}");
        }
    }

    #[test]
    fn counts() {
        for (text, want) in [
            ("a dozen chairs", 12.0),
            ("a pair of lamps", 2.0),
            ("two or three plants", 2.0),
            ("thirty two", 32.0),
            ("twenty-four desks", 24.0),
            ("a hundred seats", 100.0),
            ("a hundred and twenty chairs", 120.0),
            ("half a dozen", 6.0),
            ("a half dozen chairs", 6.0),
            ("a half-dozen chairs", 6.0),
        ] {
            assert_eq!(count(&tokens(text, 100).0).map(|c| c.0), Some(want), "{text}");
        }
    }
}
