//! Things in lines: how far rows are apart ("in parallel rows with 1.2 m between them"), what is at their end, and units that are
//! things ("an air conditioning unit").

use super::lexicon::{plural, singular};
use super::number::length;
use super::paraphrase::{ends, put, word};
use super::shares::{counted, noun};
use super::token::{Token, WordKind};

/// What stands in rows that have an end.
const IN_ROWS: [&str; 14] = [
    "bookcases",
    "bookshelves",
    "cabinets",
    "desks",
    "gondolas",
    "lockers",
    "machines",
    "pallets",
    "racks",
    "shelves",
    "shelving",
    "tables",
    "workbenches",
    "workstations",
];
/// What stands in rows of its own: five of them in rows are five rows.
const SHELVES: [&str; 5] = ["bookcases", "bookshelves", "gondolas", "racks", "shelves"];
/// So far back rows are looked for.
const BACK: usize = 40;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 5] = [unit, in_rows, between_them, at_the_end, low_table];
    turns.iter().any(|turn| turn(tokens, i))
}

/// "An air conditioning unit", "two fridge units": an air conditioner, two fridges.
fn unit(tokens: &mut Vec<Token>, i: usize) -> bool {
    let counted = super::number::count(&tokens[i..]).map_or(0, |(_, used)| used);
    let from = i + counted.max(usize::from(matches!(word(tokens, i), "a" | "an" | "the")));
    let Some(end) = noun(tokens, from).map(|name| name.end).filter(|_| from > i) else { return false };
    let many = word(tokens, end) == "units";
    let last = word(tokens, end - 1);
    if !many && word(tokens, end) != "unit" || plural(last) {
        return false;
    }
    let one = if last == "conditioning" { "conditioner" } else { last }.to_owned();
    let said = if many { scenelang_lang::nouns::plural(&one) } else { one };
    put(tokens, end - 1, end + 1, &[&said]);
    true
}

/// Where the sentence of a token begins.
fn sentence(tokens: &[Token], i: usize) -> usize {
    tokens[..i].iter().rposition(Token::stops).map_or(0, |k| k + 1)
}

/// "Five bookshelves in parallel rows": in five rows.
fn in_rows(tokens: &mut Vec<Token>, i: usize) -> bool {
    let looks = |k: usize| matches!(word(tokens, k), "parallel" | "straight" | "neat" | "even" | "tidy" | "separate");
    let said = word(tokens, i) == "in" && looks(i + 1) && word(tokens, i + 2) == "rows" && word(tokens, i + 3) != "of";
    let Some(all) = counted(tokens, i, 2).filter(|all| said && all.noun.end == i && all.n <= 12) else { return false };
    if !SHELVES.contains(&word(tokens, i - 1)) {
        return false;
    }
    put(tokens, i, i + 3, &["in", &all.n.to_string(), "rows"]);
    tokens[i + 1].kind = WordKind::Number(all.n as f64);
    true
}

/// "In rows with about 1.2 metres between them": so much between the rows.
fn between_them(tokens: &mut Vec<Token>, i: usize) -> bool {
    let joins = matches!(word(tokens, i), "with" | "and" | "leaving" | "at");
    let about = i
        + 1
        + match [word(tokens, i + 1), word(tokens, i + 2)] {
            ["at", "least"] => 2,
            ["about" | "around" | "roughly" | "approximately" | "some" | "nearly", _] => 1,
            _ => 0,
        };
    let rows = tokens[sentence(tokens, i)..i].iter().any(|t| t.is("rows") || t.is("lines"));
    let measured = |from: usize| length(tokens.get(from..)?).map(|(_, used)| from + used);
    let Some(end) = measured(about).filter(|_| joins && rows) else { return false };
    let space = match [word(tokens, end), word(tokens, end + 1)] {
        ["of", "space" | "room" | "floor"] => 2,
        ["gap" | "gaps" | "space", _] => 1,
        _ => 0,
    };
    let from = end + space;
    let whom = from + 1 + usize::from(matches!(word(tokens, from + 1), "the" | "each" | "every"));
    let after = match word(tokens, from) {
        "apart" => from + 1,
        "between" if matches!(word(tokens, whom), "them" | "rows" | "row" | "other" | "one") => whom + 1,
        "between" if matches!(word(tokens, whom - 1), "each" | "every") => whom,
        _ => return false,
    };
    put(tokens, end, after, &["between", "the", "rows"]);
    // What comes before has said where the rows are.
    if i > 0 && tokens[i - 1].is(",") {
        tokens.remove(i);
    } else {
        tokens[i] = Token { kind: WordKind::Sign(','), ..tokens[i].saying(",") };
    }
    true
}

/// "Two rows of racks, an air conditioner at the end": against the wall at which the rows end.
fn at_the_end(tokens: &mut Vec<Token>, i: usize) -> bool {
    let which = match [word(tokens, i), word(tokens, i + 1)] {
        ["at" | "on", "the" | "one" | "each"] => word(tokens, i + 1).to_owned(),
        _ => return false,
    };
    let far = usize::from(matches!(word(tokens, i + 2), "far" | "other" | "near" | "left" | "right"));
    let end = i + 2 + far;
    if word(tokens, end) != "end" || which == "each" || i == 0 {
        return false;
    }
    let of = word(tokens, end + 1) == "of";
    let article = usize::from(of && matches!(word(tokens, end + 2), "the" | "these" | "both" | "each"));
    let last = end + 2 + article;
    let named = matches!(word(tokens, last), "rows" | "row" | "aisle" | "aisles" | "them");
    let to = if of { last + 1 } else { end + 1 };
    let is_rows = |k: usize| {
        let rows = matches!(word(tokens, k), "rows" | "row");
        let of = word(tokens, k + 1) == "of" && (k + 2..k + 6).any(|k| IN_ROWS.contains(&word(tokens, k)));
        let before = (k.saturating_sub(5)..k).any(|k| IN_ROWS.contains(&word(tokens, k)));
        rows && (of || before)
    };
    let faces = |k: usize| matches!(word(tokens, k), "facing" | "face") && word(tokens, k + 1) == "each";
    let says = |is: &dyn Fn(usize) -> bool| (i.saturating_sub(BACK)..i).any(is);
    let rows = says(&is_rows) || says(&faces) && says(&|k| word(tokens, k) == "rows");
    let thing = (i.saturating_sub(4)..i).any(|k| noun(tokens, k).is_some_and(|name| name.end == i));
    if !rows || !thing || of && !named || !of && !ends(tokens, to) {
        return false;
    }
    let side = match word(tokens, i + 2) {
        "left" | "near" => "left",
        "other" | "far" | "right" => "right",
        _ if which == "one" => "left",
        _ => "right",
    };
    put(tokens, i, to, &["against", "the", side, "wall"]);
    true
}

/// "A low table with cushions in the corner": the table is there, and one sits around it on the floor.
fn low_table(tokens: &mut Vec<Token>, i: usize) -> bool {
    let low = i > 1 && word(tokens, i - 1) == "table" && matches!(word(tokens, i - 2), "low" | "tea" | "kotatsu");
    if word(tokens, i) != "with" || !low {
        return false;
    }
    let number = super::number::count(&tokens[i + 1..]).map_or(0, |(_, used)| used);
    let some = number.max(usize::from(matches!(word(tokens, i + 1), "some" | "few")));
    let floor = usize::from(word(tokens, i + 1 + some) == "floor");
    let last = i + 1 + some + floor;
    if !matches!(word(tokens, last), "cushions" | "poufs" | "pillows") {
        return false;
    }
    // Those on it are said to be so.
    let on = matches!(word(tokens, last + 1), "on") && !matches!(word(tokens, last + 3), "floor");
    if on {
        return false;
    }
    let round = usize::from(matches!(word(tokens, last + 1), "around" | "round")) * 2;
    let place = match [word(tokens, last + 1), word(tokens, last + 2)] {
        ["in" | "by" | "near" | "at" | "under", "the" | "a" | "one"] => {
            (last + 3..last + 7).find(|k| !tokens.get(*k).is_some_and(Token::word) || tokens[*k].is("and"))
        }
        _ => None,
    };
    let like = tokens[last].clone();
    let around = ["around", "it"].map(|text| like.saying(text));
    if singular(&like.text) != "pouf" {
        let name: &[&str] = &["floor", "cushions"];
        put(tokens, last - floor, last + 1, name);
    }
    let end = if singular(&like.text) == "pouf" { last + 1 } else { last - floor + 2 };
    let moved = place.map(|to| to + end - (last + 1));
    tokens.drain(end..end + round);
    tokens.splice(end..end, around);
    if let Some(to) = moved {
        tokens[i..to + 2].rotate_left(end + 2 - i);
    }
    true
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn lines_are_told_plainly() {
        for (said, becomes) in [
            ("an air conditioning unit, two fridge units", "an air conditioner , two fridges"),
            ("a shelving unit and a kitchen unit", "a shelving unit and a kitchen unit"),
            (
                "five bookshelves in parallel rows with about 1.2 metres between them.",
                "five bookshelves in 5 rows , about 1.2 metres between the rows .",
            ),
            ("pallets in four lines with 2 m between them", "pallets in four lines , 2 m between the rows"),
            (
                "two rows of five treadmills facing each other, a bin at the end.",
                "two rows of five treadmills facing each other , a bin against the right wall .",
            ),
            ("desks in rows with 90 cm between each row", "desks in rows , 90 cm between the rows"),
            ("two rows of racks, at least 1 m apart", "two rows of racks , at least 1 m apart"),
            ("two rows of racks with 1 m of space between the rows", "two rows of racks , 1 m between the rows"),
            ("two desks with 1 m between them", "two desks with 1 m between them"),
            (
                "two rows of six racks facing each other, an air conditioner at the end and a bin",
                "two rows of six racks facing each other , an air conditioner against the right wall and a bin",
            ),
            (
                "lockers in two rows, a mirror at one end of the rows.",
                "lockers in two rows , a mirror against the left wall .",
            ),
            ("rows of pews, an altar at the end", "rows of pews , an altar at the end"),
            (
                "a low table with cushions in the front corner, and a desk",
                "a low table in the front corner with floor cushions around it , and a desk",
            ),
            ("a low table with four floor cushions around it.", "a low table with four floor cushions around it ."),
            ("a low table with cushions on it", "a low table with cushions on it"),
            ("a sofa with cushions in the corner", "a sofa with cushions in the corner"),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
