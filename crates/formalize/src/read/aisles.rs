//! Aisles: "four rows of racks with 3 m wide aisles between them" have 3 m between the rows, and "a grocery with five aisles" has so
//! many rows of shelves.

use super::number::{count, unit};
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    long_rows(tokens, i) || wide(tokens, i) || rows_of_shelves(tokens, i)
}

/// "Four long rows of racks": a row is as long as it has racks.
fn long_rows(tokens: &mut Vec<Token>, i: usize) -> bool {
    let looks =
        tokens[i..].iter().take_while(|t| matches!(t.text.as_str(), "long" | "straight" | "parallel" | "neat")).count();
    let counted = i > 0 && count(&tokens[i - 1..i]).is_some();
    let said = looks > 0 && counted && word(tokens, i + looks) == "rows" && word(tokens, i + looks + 1) == "of";
    if said {
        put(tokens, i, i + looks + 1, &["rows"]);
    }
    said
}

/// Where a length ends that begins here: "3 m", "at least 1.4 metres".
fn length(tokens: &[Token], i: usize) -> Option<usize> {
    let least = if word(tokens, i) == "at" && word(tokens, i + 1) == "least" { 2 } else { 0 };
    let (_, used) = count(tokens.get(i + least..)?)?;
    let end = i + least + used;
    unit(word(tokens, end)).map(|_| end + 1)
}

/// "With aisles of 3 m between them", "aisles 2 m wide", "with 3 m wide aisles": so much between the rows.
fn wide(tokens: &mut Vec<Token>, i: usize) -> bool {
    let listed = i > 0 && (tokens[i - 1].is(",") || tokens[i - 1].is("with") || tokens[i - 1].is("and"));
    if !listed || !tokens[..i].iter().any(|t| t.is("rows")) {
        return false;
    }
    let is_wide = |k: usize| usize::from(word(tokens, k) == "wide");
    let (from, to, end) = if word(tokens, i) == "aisles" {
        let of = i + 1 + usize::from(matches!(word(tokens, i + 1), "of" | "are"));
        let Some(to) = length(tokens, of) else { return false };
        (of, to, to + is_wide(to))
    } else {
        let Some(to) = length(tokens, i) else { return false };
        let aisles = to + is_wide(to);
        // Between server racks: the cold aisle, from which they take the air.
        let aisles = aisles + usize::from(matches!(word(tokens, aisles), "cold" | "hot" | "wide" | "clear"));
        if !matches!(word(tokens, aisles), "aisles" | "aisle") {
            return false;
        }
        (i, to, aisles + 1)
    };
    let whom = usize::from(word(tokens, end + 1) == "the") + 1;
    let between =
        word(tokens, end) == "between" && matches!(word(tokens, end + whom), "them" | "rows" | "racks" | "shelves");
    let end = if between { end + whom + 1 } else { end };
    let said = tokens[from..to].to_vec();
    put(tokens, i, end, &["between", "the", "rows"]);
    tokens.splice(i..i, said);
    if tokens[i - 1].is("with") && i > 1 && tokens[i - 2].is(",") {
        tokens.remove(i - 1);
    } else if tokens[i - 1].is("with") {
        tokens[i - 1].kind = WordKind::Sign(',');
        tokens[i - 1].text = ",".to_owned();
    }
    true
}

/// "A grocery with five aisles": with so many rows of shelves.
fn rows_of_shelves(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((_, used)) = tokens.get(i..).and_then(count) else { return false };
    let said =
        word(tokens, i + used) == "aisles" && i > 0 && matches!(word(tokens, i - 1), "with" | "has" | "and" | ",");
    let stands = tokens.iter().any(|t| matches!(t.text.as_str(), "shelves" | "racks" | "rows" | "gondolas"));
    if !said || stands || !ends(tokens, i + used + 1) {
        return false;
    }
    put(tokens, i + used, i + used + 1, &["rows", "of", "shelves"]);
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn aisles_are_between_rows() {
        for (said, becomes) in [
            (
                "four long rows of racks, parallel to each other, with aisles of 3 metres between them.",
                "four rows of racks , parallel to each other , 3 metres between the rows .",
            ),
            (
                "four rows of shelves with 1.4 m wide aisles between them",
                "four rows of shelves , 1.4 m between the rows",
            ),
            ("four rows of racks and aisles at least 2 m wide", "four rows of racks and at least 2 m between the rows"),
            ("two rows of racks, 1.2 m cold aisle between them", "two rows of racks , 1.2 m between the rows"),
            ("six racks with 2 m aisles", "six racks with 2 m aisles"),
            ("a long row of lockers", "a long row of lockers"),
            ("a grocery with five aisles and a till.", "a grocery with five rows of shelves and a till ."),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
