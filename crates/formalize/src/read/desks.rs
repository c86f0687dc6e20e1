//! Desks of which a request says how many by whom they are for: "desks in groups of four" of an office for twelve, desks "for two
//! children each", and the desk of the one who writes: "my own desk" in a classroom is the teacher's.

use super::lexicon::{Class, get};
use super::number::count;
use super::paraphrase::{put, word};
use super::token::{Token, WordKind};

const DESKS: [&str; 4] = ["desks", "workstations", "workplaces", "tables"];
const GROUPS: [&str; 8] = ["groups", "islands", "pods", "clusters", "blocks", "banks", "sets", "pairs"];

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    teaching(tokens, i)
        || in_pairs(tokens, i)
        || in_groups(tokens, i)
        || shared(tokens, i)
        || own(tokens, i)
        || one_each(tokens, i)
        || people_facing(tokens, i)
}

/// "Six desks in two rows with people facing each other": the desks face each other.
fn people_facing(tokens: &mut Vec<Token>, i: usize) -> bool {
    let who = matches!(word(tokens, i + 1), "people" | "staff" | "everyone" | "pupils" | "students" | "colleagues");
    let with = matches!(word(tokens, i), "with" | "so") && who;
    let sit = i + 2 + usize::from(matches!(word(tokens, i + 2), "sit" | "sitting" | "seated"));
    let face = matches!(word(tokens, sit), "facing" | "face") && word(tokens, sit + 1) == "each";
    let desks = (i.saturating_sub(6)..i).any(|k| DESKS.contains(&word(tokens, k)));
    if !with || !face || word(tokens, sit + 2) != "other" || !desks {
        return false;
    }
    put(tokens, i, sit + 3, &["facing", "each", "other"]);
    true
}

fn whole(tokens: &[Token], i: usize) -> Option<usize> {
    let (n, used) = count(tokens.get(i..i + 1)?)?;
    (used == 1 && n.fract() == 0.0 && (1.0..=400.0).contains(&n)).then_some(n as usize)
}

/// "An office for twelve people, desks in groups of four": twelve desks in groups of four.
fn in_groups(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = DESKS.contains(&word(tokens, i))
        && word(tokens, i + 1) == "in"
        && GROUPS.contains(&word(tokens, i + 2))
        && word(tokens, i + 3) == "of";
    let Some(each) = whole(tokens, i + 4).filter(|_| said) else { return false };
    let counted = |t: &Token| count(std::slice::from_ref(t)).is_some();
    if tokens[..i].iter().rev().take(3).take_while(|t| !matches!(t.kind, WordKind::Sign(_))).any(counted) {
        return false;
    }
    let is_for = |k: &usize| word(tokens, *k) == "for" && whole(tokens, k + 1).is_some();
    let Some(people) = (0..i).find(is_for).map(|k| k + 1) else { return false };
    let fits = whole(tokens, people).is_some_and(|n| n > each && n.is_multiple_of(each));
    // Pupils share a table.
    if fits && DESKS[3] == word(tokens, i) {
        let all = whole(tokens, people).unwrap_or(each) / each;
        let (all, four) = (all.to_string(), tokens[i + 4].clone());
        put(tokens, i, i + 5, &[&all, "tables", "for", "n"]);
        tokens[i].kind = WordKind::Number(all.parse().unwrap_or(1.0));
        tokens[i + 3] = four;
        return true;
    }
    if fits {
        let number = Token { at: tokens[i].at.clone(), ..tokens[people].clone() };
        tokens.insert(i, number);
    }
    fits
}

/// "I teach first grade and want a new layout": a classroom is spoken of.
fn teaching(tokens: &mut Vec<Token>, i: usize) -> bool {
    const NAMED: [&str; 6] = ["classroom", "class", "room", "studio", "lab", "hall"];
    let teach = i == 0 && matches!([word(tokens, 0), word(tokens, 1)], ["i" | "we", "teach"]);
    if teach && word(tokens, 2) != "in" && taught(tokens) {
        return true;
    }
    if !teach || tokens.iter().any(|t| NAMED.contains(&t.text.as_str())) {
        return false;
    }
    let ends = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | '!' | ','));
    let end = tokens.iter().position(ends).unwrap_or(tokens.len());
    put(tokens, 0, end, &["a", "classroom"]);
    true
}

/// "I teach woodwork. The room is 11 m by 7": that room is a workshop.
fn taught(tokens: &mut Vec<Token>) -> bool {
    let kind = match word(tokens, 2) {
        "woodwork" | "metalwork" | "carpentry" | "joinery" | "technology" => "workshop",
        "chemistry" | "physics" | "biology" | "science" => "laboratory",
        "art" | "painting" | "pottery" | "ceramics" | "drawing" => "art room",
        "music" => "music room",
        _ => "classroom",
    };
    let is_room = |k: &usize| word(tokens, *k) == "room" && matches!(word(tokens, k + 1), "is" | "measures" | "has");
    let Some(at) = (3..tokens.len()).find(is_room) else { return false };
    put(tokens, at, at + 1, &kind.split(' ').collect::<Vec<_>>());
    true
}

/// "Cots for six babies": six cots. Of desks and chairs the furniture of the room decides, as pupils may share a desk.
fn one_each(tokens: &mut Vec<Token>, i: usize) -> bool {
    const ONES: [&str; 12] = [
        "cots",
        "cribs",
        "beds",
        "lockers",
        "mats",
        "easels",
        "sewing-machines",
        "high-chairs",
        "highchairs",
        "hooks",
        "pegs",
        "recliners",
    ];
    let counted = tokens[..i]
        .iter()
        .rev()
        .take(4)
        .take_while(|t| t.word())
        .any(|t| t.is("each") || t.is("every") || count(std::slice::from_ref(t)).is_some());
    let said = ONES.contains(&word(tokens, i)) && word(tokens, i + 1) == "for" && !counted;
    let Some(n) = whole(tokens, i + 2).filter(|n| said && *n > 1) else { return false };
    let who = word(tokens, i + 3);
    let person = get().is(who, Class::Person);
    let ends = tokens.get(i + 3).is_none_or(|t| !t.word())
        || matches!(who, "and" | "with" | "in" | "at" | "along" | "against" | "by" | "on");
    if !person && !ends {
        return false;
    }
    let what = word(tokens, i).to_owned();
    let text = n.to_string();
    put(tokens, i, i + 3 + usize::from(person), &[&text, &what]);
    tokens[i].kind = WordKind::Number(n as f64);
    true
}

/// "For 24 kids sitting in pairs": they have double desks.
fn in_pairs(tokens: &mut Vec<Token>, i: usize) -> bool {
    let who = usize::from(word(tokens, i) == "who");
    let sit = matches!(word(tokens, i + who), "sitting" | "seated" | "sit" | "working");
    let said = sit && word(tokens, i + who + 1) == "in" && word(tokens, i + who + 2) == "pairs";
    let pupils = i > 0 && matches!(word(tokens, i - 1), "pupils" | "students" | "children" | "kids");
    if said && pupils {
        put(tokens, i, i + who + 3, &["with", "double", "desks"]);
        return true;
    }
    // "A classroom, 20 pupils, desks in pairs".
    let pairs = word(tokens, i) == "desks" && word(tokens, i + 1) == "in" && word(tokens, i + 2) == "pairs";
    let counted = i > 0 && count(&tokens[i - 1..i]).is_some();
    let taught = tokens.iter().any(|t| ["pupils", "students", "children", "kids"].iter().any(|who| t.is(who)));
    if pairs && taught && !counted {
        put(tokens, i, i + 3, &["double", "desks"]);
    }
    pairs && taught && !counted
}

/// "The desks are for two children each": double desks.
fn shared(tokens: &mut Vec<Token>, i: usize) -> bool {
    let verb = usize::from(matches!(word(tokens, i + 1), "are" | "seat" | "seating"));
    let is_for = usize::from(word(tokens, i + 1 + verb) == "for");
    let n = i + 1 + verb + is_for;
    if word(tokens, i) != "desks" || verb + is_for == 0 || whole(tokens, n) != Some(2) {
        return false;
    }
    let each = n + 1 + usize::from(word(tokens, n + 1) != "each");
    if word(tokens, each) != "each" {
        return false;
    }
    // "The desks are for two pupils each and should stand in rows": the double desks should stand in rows.
    let end = each + 1;
    let goes_on =
        verb == 1 && word(tokens, end) == "and" && matches!(word(tokens, end + 1), "should" | "must" | "are" | "stand");
    put(tokens, i, end + usize::from(goes_on), &["double", "desks"]);
    true
}

/// "My own desk" of a classroom: the teacher's desk.
fn own(tokens: &mut Vec<Token>, i: usize) -> bool {
    let mine = usize::from(word(tokens, i + 1) == "own") + 1;
    let taught = |t: &Token| matches!(t.text.as_str(), "classroom" | "class" | "pupils" | "students" | "schoolroom");
    let said = word(tokens, i) == "my" && word(tokens, i + mine) == "desk" && tokens[..i].iter().any(taught);
    if said {
        put(tokens, i, i + mine + 1, &["the", "teacher", "desk"]);
    }
    said
}

#[cfg(test)]
mod tests {
    use crate::read::paraphrase::plainly;

    #[test]
    fn desks_are_counted_by_whom_they_are_for() {
        for (said, becomes) in [
            (
                "a classroom for 24 children, tables in groups of four, and shelves",
                "a classroom for 24 children , 6 tables for four , and shelves",
            ),
            (
                "an office for 12 people, desks in groups of four, each with a chair",
                "an office for 12 people , 12 desks in groups of four , each with a chair",
            ),
            (
                "an office for 12 people with 8 desks in groups of four",
                "an office for 12 people with 8 desks in groups of four",
            ),
            ("an office for ten people, desks in groups of four", "an office for ten people , desks in groups of four"),
            (
                "the desks are for two children each and should stand in rows.",
                "the double desks should stand in rows .",
            ),
            ("a classroom for 24 kids sitting in pairs.", "a classroom for 24 kids with double desks ."),
            ("twelve desks for two pupils each.", "twelve double desks ."),
            ("six desks in two rows with people facing each other.", "six desks in two rows facing each other ."),
            ("cots for 6 babies along the wall", "6 cots along the wall"),
            ("i teach first grade and want to try a new layout. five tables", "a classroom . five tables"),
            ("two beds for four people", "two beds for four people"),
            ("beds for four", "4 beds"),
            ("beds for", "beds for"),
            ("a classroom. my own desk is at the front.", "a classroom . the teacher desk is at the front ."),
            ("a study. my desk is at the window.", "a study . my desk is at the window ."),
        ] {
            assert_eq!(plainly(said), becomes);
        }
    }
}
