//! Areas before what has them: "a 20 square metre bedroom" is a bedroom of 20 square metres, and not one 20 m wide.

use super::noun::room_here;
use super::number;
use super::paraphrase::put;
use super::token::{Token, WordKind};

/// Puts an area that precedes the name of a room behind it.
pub(super) fn before_rooms(tokens: &mut Vec<Token>, i: usize) -> bool {
    hyphened(tokens, i);
    let Some((_, used)) = number::area(&tokens[i..]) else { return false };
    let looks = tokens[i + used..].iter().take_while(|t| t.word() && super::lexicon::get().is_look(&t.text)).count();
    let name = i + used + looks;
    let Some(n) = tokens.get(name..).and_then(room_here) else { return false };
    tokens[i..name + n].rotate_left(used);
    let of = i + looks + n;
    let first = tokens[of].clone();
    tokens.insert(of, Token { kind: WordKind::Word, text: "of".to_owned(), ..first });
    true
}

/// "20-square-metre": three words.
fn hyphened(tokens: &mut Vec<Token>, i: usize) {
    let parts: Vec<String> = tokens[i].text.split('-').map(str::to_owned).collect();
    let [amount, square, unit] = &parts[..] else { return };
    let Some(value) = amount.parse::<f64>().ok().or_else(|| number::small(amount)) else { return };
    if matches!(square.as_str(), "square" | "sq") && number::unit(unit).is_some() {
        put(tokens, i, i + 1, &[amount, square, unit]);
        tokens[i].kind = WordKind::Number(value);
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn areas_follow_rooms() {
        for (text, becomes) in [
            ("a 20 square metre bedroom with a bed", "a bedroom of 20 square metre with a bed"),
            ("a 20-square-metre bright living room", "a bright living room of 20 square metre"),
            ("an office of 40 sqm", "an office of 40 sqm"),
        ] {
            let mut tokens = tokens(text, 100).0;
            for i in 0..tokens.len() {
                let _moved = before_rooms(&mut tokens, i);
            }
            let words: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), becomes);
        }
    }
}
