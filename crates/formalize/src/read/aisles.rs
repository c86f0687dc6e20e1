//! Aisles: "four rows of racks with 3 m wide aisles between them" have 3 m between the rows, and "a grocery with five aisles" has so
//! many rows of shelves.

use super::number::{count, unit};
use super::paraphrase::{ends, put, word};
use super::token::{Token, WordKind};

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    each_side(tokens, i)
        || down_the_middle(tokens, i)
        || in_parallel(tokens, i)
        || long_rows(tokens, i)
        || wide(tokens, i)
        || rows_of_shelves(tokens, i)
}

/// How a word begins that stands for an aisle down the middle; its width in centimetres follows.
const AISLE: &str = "aisle=";
/// As wide as an aisle is if nobody says how wide, in centimetres: two people pass each other.
const USUAL: u32 = 120;

/// The width of an aisle for which a word stands, in centimetres.
pub fn aisle(word: &str) -> Option<u32> {
    word.strip_prefix(AISLE)?.parse().ok()
}

/// Where an aisle in the middle ends that is named here, and how wide it is: "a centre aisle 2 m wide", "an aisle down the middle".
fn middle_aisle(tokens: &[Token], i: usize) -> Option<(usize, u32)> {
    let from = i + usize::from(matches!(word(tokens, i), "a" | "an" | "the"));
    let (mut wide, mut at) = (USUAL, from);
    let centimetres = |from: usize, to: usize| -> Option<u32> {
        let (n, used) = count(&tokens[from..])?;
        let metres = n * unit(word(tokens, from + used))?;
        (to == from + used + 1 && (0.3..=20.0).contains(&metres)).then_some((metres * 100.0).round() as u32)
    };
    if let Some(end) = length(tokens, at) {
        wide = centimetres(at, end)?;
        at = end + usize::from(word(tokens, end) == "wide");
    }
    let middle = matches!(word(tokens, at), "centre" | "center" | "central" | "middle");
    at += usize::from(middle);
    if word(tokens, at) != "aisle" {
        return None;
    }
    at += 1;
    let of = usize::from(word(tokens, at) == "of");
    if let Some(end) = length(tokens, at + of) {
        wide = centimetres(at + of, end)?;
        at = end + usize::from(word(tokens, end) == "wide");
    }
    let down = matches!(word(tokens, at), "down" | "in" | "through" | "along")
        && word(tokens, at + 1) == "the"
        && matches!(word(tokens, at + 2), "middle" | "centre" | "center");
    let at = at + 3 * usize::from(down);
    (middle || down).then_some((at, wide))
}

/// "10 pews on each side of a centre aisle 2 m wide": 20 pews in 10 rows with the aisle between.
fn each_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = ["on", "each", "side", "of"].iter().enumerate().all(|(k, said)| word(tokens, i + k) == *said)
        || ["on", "either", "side", "of"].iter().enumerate().all(|(k, said)| word(tokens, i + k) == *said);
    let Some((end, wide)) = middle_aisle(tokens, i + 4).filter(|_| said) else { return false };
    let Some(all) = super::shares::counted(tokens, i, 2).filter(|all| all.noun.end == i) else { return false };
    let number = all.noun.start.saturating_sub(1);
    let (rows, twice) = (all.n.to_string(), (2 * all.n).to_string());
    put(tokens, i, end, &["in", &rows, "rows", &format!("{AISLE}{wide}")]);
    put(tokens, number, number + 1, &[&twice]);
    for (k, n) in [(i + 1, all.n), (number, 2 * all.n)] {
        tokens[k].kind = WordKind::Number(n as f64);
    }
    true
}

/// "Desks in rows with an aisle down the middle".
fn down_the_middle(tokens: &mut Vec<Token>, i: usize) -> bool {
    let joins = matches!(word(tokens, i), "with" | "and" | "leaving");
    let Some((end, wide)) = middle_aisle(tokens, i + usize::from(joins)).filter(|_| joins) else { return false };
    let comma = usize::from(i > 0 && tokens[i - 1].is(","));
    put(tokens, i - comma, end, &[&format!("{AISLE}{wide}")]);
    true
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

/// "Three benches in parallel": parallel to each other. Shelves stand one behind the other.
fn in_parallel(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "in" && word(tokens, i + 1) == "parallel";
    let shelves = |t: &Token| matches!(t.text.as_str(), "shelves" | "bookshelves" | "bookcases" | "racks" | "gondolas");
    let all = (i.saturating_sub(4)..i).find_map(|k| count(&tokens[k..i]));
    let all = all.filter(|(n, _)| (3.0..=12.0).contains(n) && i > 0 && shelves(&tokens[i - 1]));
    let joined = matches!(word(tokens, i + 2), "with" | "to");
    if let Some((n, _)) = all.filter(|_| said && !joined) {
        put(tokens, i, i + 2, &["in", &n.to_string(), "rows"]);
        tokens[i + 1].kind = WordKind::Number(n);
    } else if said {
        put(tokens, i, i + 2, &["parallel", "to", "each", "other"]);
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
    let rows = tokens[..i].iter().any(|t| t.is("rows"));
    let several = super::shares::counted(tokens, i, 2).is_some_and(|all| i - all.noun.end <= 6);
    if !listed || !rows && !several {
        return false;
    }
    let is_wide = |k: usize| usize::from(word(tokens, k) == "wide");
    let kind = |k: usize| usize::from(matches!(word(tokens, k), "cold" | "hot" | "clear" | "main"));
    let article = usize::from(matches!(word(tokens, i), "a" | "an" | "one"));
    let first = i + article + kind(i + article);
    let (from, to, end) = if matches!(word(tokens, first), "aisle" | "aisles") {
        let of = first + 1 + usize::from(matches!(word(tokens, first + 1), "of" | "are"));
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
    put(tokens, i, end, if rows { &["between", "the", "rows"] } else { &["apart"] });
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
            (
                "two rows of racks, hot aisle 1.2 m between them, a desk",
                "two rows of racks , 1.2 m between the rows , a desk",
            ),
            ("five bookshelves in parallel in the middle.", "five bookshelves in 5 rows in the middle ."),
            ("six racks with 2 m aisles", "six racks , 2 m apart"),
            (
                "three lab benches in parallel with 1.2 m aisles between them",
                "three lab benches parallel to each other , 1.2 m apart",
            ),
            (
                "10 pews on each side of a centre aisle 2 m wide, altar at the front",
                "20 pews in 10 rows aisle=200 , altar at the front",
            ),
            ("desks in four rows, with an aisle down the middle.", "desks in four rows aisle=120 ."),
            ("40 chairs with a 1.5 m wide aisle down the middle", "40 chairs aisle=150"),
            ("a shop with an aisle to the door", "a shop with an aisle to the door"),
            ("a long row of lockers", "a long row of lockers"),
            ("a grocery with five aisles and a till.", "a grocery with five rows of shelves and a till ."),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
