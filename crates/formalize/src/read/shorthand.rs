//! Words that people leave out or put in the place of others: "5 on 4 m" is 5 by 4 m, "a nightstand between" is between what was
//! named before, and "six desks, two rows of three" stand in two rows of three.

use super::lexicon::{LookWord, get};
use super::number::{count, unit};
use super::paraphrase::{ends, put, word};
use super::shares::noun;
use super::token::{Token, WordKind};

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 19] = [
        not_forgotten,
        on_for_by,
        made_from,
        between_them,
        rows_after,
        kitchen_behind,
        per_side,
        headboards,
        both_sides,
        upper_cabinets,
        on_wall,
        relatives,
        out_front,
        behind_me,
        stocked,
        stick,
        have_got,
        lined_up,
        around_walls,
    ];
    turns.iter().any(|turn| turn(tokens, i))
}

/// "Do not forget a lamp": there is one. "Don't forget to add a lamp": add one.
fn not_forgotten(tokens: &mut Vec<Token>, i: usize) -> bool {
    let not = i + usize::from(matches!(word(tokens, i), "do" | "please"));
    let said = matches!(word(tokens, not), "not" | "don't" | "dont" | "never") && word(tokens, not + 1) == "forget";
    if !said || i > 0 && matches!(word(tokens, i - 1), "do" | "please") {
        return false;
    }
    match word(tokens, not + 2) {
        "to" => drop(tokens.drain(i..not + 3)),
        "about" => put(tokens, i, not + 3, &["there", "is"]),
        _ => put(tokens, i, not + 2, &["there", "is"]),
    }
    true
}

fn starts(tokens: &[Token], i: usize) -> bool {
    i == 0 || tokens[i - 1].stops() || tokens[i - 1].is(",") || tokens[i - 1].is("and")
}

fn article(tokens: &[Token], i: usize) -> bool {
    matches!(word(tokens, i), "a" | "an" | "the" | "some" | "my" | "our")
        || tokens.get(i..).is_some_and(|rest| count(rest).is_some())
}

/// "Stick a table near the door": put it there.
fn stick(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "stick" | "pop" | "chuck" | "plonk" | "bung" | "shove") && starts(tokens, i);
    if said && article(tokens, i + 1) {
        put(tokens, i, i + 1, &["put"]);
        return true;
    }
    false
}

/// "We've got a 5 by 6 m lounge": there is one.
fn have_got(tokens: &mut Vec<Token>, i: usize) -> bool {
    let got = match [word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)] {
        ["we've" | "i've", "got", _] => i + 2,
        ["we" | "i", "have", "got"] => i + 3,
        _ => return false,
    };
    if !starts(tokens, i) || !article(tokens, got) {
        return false;
    }
    put(tokens, i, got, &["there", "is"]);
    true
}

/// "Tables for two lined up along the windows": along the windows.
fn lined_up(tokens: &mut Vec<Token>, i: usize) -> bool {
    let places = i > 1 && word(tokens, i - 2) == "for" && count(&tokens[i - 1..]).is_some();
    let next = word(tokens, i + 2).to_owned();
    let said = word(tokens, i) == "lined" && word(tokens, i + 1) == "up";
    if !said || !places || !matches!(next.as_str(), "along" | "by" | "against" | "at" | "under" | "near") {
        return false;
    }
    put(tokens, i, i + 3, &[&next]);
    true
}

/// "A waiting room with eight chairs around the walls": not at one of them alone.
fn around_walls(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "around" && word(tokens, i + 1) == "the" && word(tokens, i + 2) == "walls";
    let sits = i > 0 && matches!(word(tokens, i - 1), "chairs" | "seats" | "benches");
    let waits = tokens.iter().any(|t| t.is("waiting"));
    let turned = said && sits && waits;
    if turned {
        put(tokens, i, i + 3, &["along", "both", "side", "walls"]);
    }
    turned
}

fn is_number(tokens: &[Token], i: usize) -> bool {
    tokens.get(i).is_some_and(|t| matches!(t.kind, WordKind::Number(_)))
}

/// "A living room of 5 on 4 metres": 5 by 4.
fn on_for_by(tokens: &mut Vec<Token>, i: usize) -> bool {
    let unit = (i + 2..i + 4).find(|k| !is_number(tokens, *k)).is_some_and(|k| unit(word(tokens, k)).is_some());
    let said = word(tokens, i) == "on" && i > 0 && is_number(tokens, i - 1) && is_number(tokens, i + 1) && unit;
    if said {
        put(tokens, i, i + 1, &["by"]);
        if i > 1 && word(tokens, i - 2) == "of" {
            tokens.remove(i - 2);
        }
    }
    said
}

/// "A table from glass": of glass.
fn made_from(tokens: &mut Vec<Token>, i: usize) -> bool {
    let material = get().look(word(tokens, i + 1)) == Some(LookWord::Material);
    let said = word(tokens, i) == "from" && material && i > 0 && noun_before(tokens, i) && ends(tokens, i + 2);
    if said {
        put(tokens, i, i + 1, &["of"]);
    }
    said
}

fn noun_before(tokens: &[Token], i: usize) -> bool {
    (i.saturating_sub(3)..i).any(|k| noun(tokens, k).is_some_and(|name| name.end == i))
}

/// "Twin beds, a nightstand between", "between them a low table": between these.
fn between_them(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "between" && i > 0 && noun_before(tokens, i) && ends(tokens, i + 1);
    if said {
        put(tokens, i, i + 1, &["between", "them"]);
    }
    said
}

/// "Six desks, two rows of three": six desks in two rows of three.
fn rows_after(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !tokens[i].is(",") {
        return false;
    }
    let Some((rows, used)) = tokens.get(i + 1..).and_then(count) else { return false };
    let of = i + 1 + used;
    if !matches!(word(tokens, of), "rows" | "row" | "lines" | "columns") || word(tokens, of + 1) != "of" {
        return false;
    }
    let Some((each, more)) = tokens.get(of + 2..).and_then(count) else { return false };
    let end = of + 2 + more;
    let sentence = tokens[..i].iter().rposition(Token::stops).map_or(0, |k| k + 1);
    let all = |k: &usize| count(&tokens[*k..i]).filter(|(n, _)| *n == rows * each).map(|(_, used)| *k + used);
    let things = (sentence..i).find_map(|k| all(&k)).and_then(|after| {
        let adjectives = (after..after + 3).find_map(|k| noun(tokens, k));
        adjectives.map(|name| name.end)
    });
    let Some(things) = things.filter(|end_of| *end_of <= i && ends(tokens, end)) else { return false };
    let said: Vec<Token> = tokens.drain(i..end).skip(1).collect();
    let like = said[0].saying("in");
    tokens.splice(things..things, std::iter::once(like).chain(said));
    true
}

/// "A counter with stools, kitchen behind it": where one cooks.
fn kitchen_behind(tokens: &mut Vec<Token>, i: usize) -> bool {
    let it = matches!(word(tokens, i + 2), "it" | "that")
        || word(tokens, i + 2) == "the" && word(tokens, i + 3) == "counter";
    let begins = i > 0 && (tokens[i - 1].is(",") || word(tokens, i - 1) == "and");
    let said = word(tokens, i) == "kitchen" && word(tokens, i + 1) == "behind" && it && begins;
    if said {
        put(tokens, i, i + 1, &["a", "stove"]);
    }
    said
}

/// "A four-bed ward, two per side", "six beds, three beds per side": half of them along each side wall.
fn per_side(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !tokens[i].is(",") {
        return false;
    }
    let Some((each, used)) = tokens.get(i + 1..).and_then(count) else { return false };
    let named = noun(tokens, i + 1 + used).map_or(i + 1 + used, |name| name.end);
    if word(tokens, named) != "per" || word(tokens, named + 1) != "side" {
        return false;
    }
    let sentence = tokens[..i].iter().rposition(Token::stops).map_or(0, |k| k + 1);
    let joined = |k: usize| super::number::small(tokens[k].text.split('-').next().unwrap_or(""));
    let counted = |k: usize| count(&tokens[k..i]).map(|(n, _)| n).or_else(|| joined(k));
    let all = (sentence..i).any(|k| counted(k) == Some(2.0 * each));
    if all {
        put(tokens, i, named + 2, &["in", "two", "rows"]);
    }
    all
}

/// "Beds with headboards to the wall": the beds are against the wall.
fn headboards(tokens: &mut Vec<Token>, i: usize) -> bool {
    let with = word(tokens, i) == "with" && matches!(word(tokens, i + 1), "headboards" | "heads");
    let wall = matches!(word(tokens, i + 2), "to" | "against" | "at")
        && word(tokens, i + 3) == "the"
        && word(tokens, i + 4) == "wall";
    if with && wall {
        put(tokens, i, i + 3, &["against"]);
    }
    with && wall
}

/// "A galley kitchen, counters 0.9 m high on both sides": along both long walls.
fn both_sides(tokens: &mut Vec<Token>, i: usize) -> bool {
    const FAR: usize = 6;
    let said = matches!(word(tokens, i), "on" | "along" | "down" | "at")
        && word(tokens, i + 1) == "both"
        && word(tokens, i + 2) == "sides"
        && ends(tokens, i + 3);
    let lines =
        |k: &usize| matches!(word(tokens, *k), "counters" | "worktops" | "units" | "cabinets" | "racks" | "shelves");
    let sentence = tokens[..i].iter().rposition(Token::stops).map_or(0, |k| k + 1);
    let of_room = || (sentence..i).any(|k| super::noun::room_here(&tokens[k..]).is_some());
    if !said || !(i.saturating_sub(FAR)..i).any(|k| lines(&k)) || !of_room() {
        return false;
    }
    put(tokens, i, i + 3, &["along", "both", "long", "walls"]);
    true
}

/// "Upper cabinets" hang on the wall.
fn upper_cabinets(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "upper" | "overhead")
        && matches!(word(tokens, i + 1), "cabinets" | "cupboards" | "units");
    if said {
        put(tokens, i, i + 2, &["wall", "cabinets"]);
    }
    said
}

/// "A shelf on left wall": on the left wall.
fn on_wall(tokens: &mut Vec<Token>, i: usize) -> bool {
    let on = matches!(word(tokens, i), "on" | "at" | "along" | "against" | "in" | "to");
    let which = matches!(
        word(tokens, i + 1),
        "left" | "right" | "back" | "front" | "far" | "rear" | "north" | "south" | "east" | "west" | "long" | "short"
    );
    let said = on && which && matches!(word(tokens, i + 2), "wall" | "corner");
    if said {
        let like = tokens[i].saying("the");
        tokens.insert(i + 1, like);
    }
    said
}

/// "My uncle pizzeria": that of my uncle.
fn relatives(tokens: &mut Vec<Token>, i: usize) -> bool {
    const WHO: [&str; 18] = [
        "uncle", "aunt", "mother", "mum", "mom", "dad", "father", "brother", "sister", "friend", "niece", "nephew",
        "grandma", "grandpa", "wife", "husband", "boss", "cousin",
    ];
    let said = matches!(word(tokens, i), "my" | "our") && WHO.contains(&word(tokens, i + 1)) && !tokens[i + 1].owner;
    let room = said && super::noun::room_here(&tokens[i + 2..]).is_some();
    if room {
        put(tokens, i, i + 2, &["the"]);
    }
    room
}

/// "A bench out front of the window": in front of it.
fn out_front(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "out" && word(tokens, i + 1) == "front" && word(tokens, i + 2) == "of";
    if said {
        put(tokens, i, i + 2, &["in", "front"]);
    }
    said
}

/// "A bookcase behind me": behind the chair that one sits on at the desk.
fn behind_me(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "behind" && matches!(word(tokens, i + 1), "me" | "you" | "us");
    if !said {
        return false;
    }
    let at = |k: usize| noun(tokens, k).filter(|name| name.end <= i);
    let is_chair = |name: &std::ops::Range<usize>| matches!(word(tokens, name.end - 1), "chair" | "stool");
    let name: Vec<String> = match (0..i).rev().filter_map(at).find(is_chair) {
        Some(chair) => {
            let from = (chair.end.saturating_sub(4)..chair.start).find(|k| at(*k).is_some_and(|n| n.end == chair.end));
            (from.unwrap_or(chair.start)..chair.end).map(|k| word(tokens, k).to_owned()).collect()
        }
        // Who sits at a desk sits on a chair.
        None if (0..i).any(|k| matches!(word(tokens, k), "desk" | "workstation")) => vec!["chair".to_owned()],
        None => return false,
    };
    let ends = usize::from(word(tokens, i + 2) == "and");
    let words = std::iter::once("the").chain(name.iter().map(String::as_str)).chain([","].into_iter().take(ends));
    put(tokens, i + 1, i + 2, &words.collect::<Vec<_>>());
    if ends == 1 {
        tokens[i + 2 + name.len()].kind = WordKind::Sign(',');
    }
    true
}

/// "Three rows of shelves stocked both sides": three rows of shelves.
fn stocked(tokens: &mut Vec<Token>, i: usize) -> bool {
    let filled = matches!(word(tokens, i), "stocked" | "filled" | "accessible" | "loaded" | "usable");
    let on = i + 1 + usize::from(matches!(word(tokens, i + 1), "on" | "from" | "at"));
    let said = filled && word(tokens, on) == "both" && word(tokens, on + 1) == "sides" && i > 0;
    let stands =
        matches!(word(tokens, i.wrapping_sub(1)), "shelves" | "racks" | "gondolas" | "shelving" | "bookshelves");
    if said && stands {
        // Those that stand in rows are open on both sides.
        let shelves = tokens[i - 1].text.clone();
        put(tokens, i - 1, on + 2, &[&shelves]);
    }
    said && stands
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase::plainly;

    #[test]
    fn what_is_left_out_is_added() {
        for (text, becomes) in [
            ("a living room of 5 on 4 metres", "a living room 5 by 4 metres"),
            ("do not forget two lamps.", "there is two lamps ."),
            ("and don't forget to add a bin.", "and add a bin ."),
            ("forget the lamp.", "forget the lamp ."),
            ("stick a table near the door.", "put a table near the door ."),
            ("a wall, a stick and a ball", "a wall , a stick and a ball"),
            ("we've got a 5 x 6 m lounge.", "there is a 5 x 6 m lounge ."),
            ("eight tables for two lined up along the windows.", "eight tables for two along the windows ."),
            (
                "a waiting room with eight chairs around the walls.",
                "a waiting room with eight chairs along both side walls .",
            ),
            ("a hall with pictures around the walls.", "a hall with pictures around the walls ."),
            ("a lamp on 4 metres", "a lamp on 4 metres"),
            ("a low table from glass, a sofa", "a low table of glass , a sofa"),
            ("a path from glass doors", "a path from glass doors"),
            ("twin beds, a nightstand between.", "twin beds , a nightstand between them ."),
            ("a nightstand between the beds", "a nightstand between the beds"),
            ("six desks, two rows of three.", "six desks in two rows of three ."),
            ("a bar, kitchen behind it, two tables", "a bar , a stove behind it , two tables"),
            ("a ward with four beds, two per side", "a ward with four beds in two rows"),
            (
                "a galley kitchen, counters on both sides.",
                "a galley kitchen , kitchen counters along both long walls .",
            ),
            ("beds with headboards to the wall", "beds against the wall"),
            ("a ward with five beds, two per side", "a ward with five beds , two per side"),
            ("a shelf on left wall", "a shelf on the left wall"),
            ("a bench out front of the window", "a bench in front of the window"),
            ("an office chair, a bookcase behind me", "an office chair , a bookcase behind the office chair"),
            ("a bookcase behind me", "a bookcase behind me"),
            ("3 rows of shelves stocked on both sides", "3 rows of shelves"),
            ("seven desks, two rows of three.", "seven desks , two rows of three ."),
        ] {
            assert_eq!(plainly(text), becomes);
        }
    }
}
