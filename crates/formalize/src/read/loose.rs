//! What is said behind a noun and belongs before it: "a fridge, which is tall", "twelve chairs, all brown except one", "chairs,
//! at least three of them", "a hall, 20 metres on each side".

use super::lexicon::{Class, get, plural, singular};
use super::number;
use super::paraphrase::{ends, put, word};
use super::shares::{counted, noun};
use super::token::{Token, WordKind};
use crate::brief::Group;

/// Turns what begins at a token; whether it did.
pub fn plain(tokens: &mut Vec<Token>, i: usize) -> bool {
    let turns: [fn(&mut Vec<Token>, usize) -> bool; 29] = [
        scattered,
        down_the_middle,
        on_plinths,
        on_tracks,
        |tokens, i| reason(tokens, i),
        left_behind,
        which_is,
        all_but,
        so_many_of_them,
        square,
        keep_away,
        two_seater,
        joined_by,
        filled,
        behind_what,
        back_to_back,
        only_so_large,
        only_by,
        moved_ahead,
        same_unit,
        same_bath,
        students,
        in_a_game,
        hotel_double,
        kitchen_counters,
        at_the_till,
        connected_rooms,
        connected_by,
        other_one,
    ];
    turns.iter().any(|turn| turn(tokens, i))
}

fn sentence(tokens: &mut Token) {
    tokens.text = ".".to_owned();
    tokens.kind = WordKind::Sign('.');
}

/// "A sink and a fridge, which is tall": a tall fridge. Of several things "which are" may be all of them.
fn which_is(tokens: &mut Vec<Token>, i: usize) -> bool {
    let which = matches!(word(tokens, i), "which" | "that") && word(tokens, i + 1) == "is";
    let look = i + 2;
    if !which || i == 0 || !get().is_look(word(tokens, look)) || !ends(tokens, look + 1) {
        return false;
    }
    let comma = usize::from(tokens[i - 1].is(","));
    let end = i - comma;
    const BACK: usize = 5;
    let article = (end.saturating_sub(BACK)..end).rev().find(|k| matches!(word(tokens, *k), "a" | "an"));
    let Some(article) = article.filter(|at| noun(tokens, at + 1).is_some_and(|name| name.end == end)) else {
        return false;
    };
    let said = tokens[look].clone();
    tokens.drain(end..look + 1);
    tokens.insert(article + 1, said);
    true
}

/// "Twelve chairs, all brown except one, which is black": eleven brown chairs and one black chair.
fn all_but(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !tokens[i].is(",") || word(tokens, i + 1) != "all" || !get().is_look(word(tokens, i + 2)) {
        return false;
    }
    let except = matches!(word(tokens, i + 3), "except" | "but") && word(tokens, i + 4) == "one";
    let Some(all) = counted(tokens, i, 2).filter(|all| except && all.noun.end == i) else { return false };
    let comma = i + 5 + usize::from(tokens.get(i + 5).is_some_and(|t| t.is(",")));
    let which =
        word(tokens, comma) == "which" && word(tokens, comma + 1) == "is" && get().is_look(word(tokens, comma + 2));
    if !which || !ends(tokens, comma + 3) {
        return false;
    }
    let Some(from) = (0..all.noun.start).rev().find(|k| number::count(&tokens[*k..=*k]).is_some()) else {
        return false;
    };
    let looks = [word(tokens, i + 2).to_owned(), word(tokens, comma + 2).to_owned()];
    let mut names: Vec<String> = tokens[from + 1..i].iter().map(|t| t.text.clone()).collect();
    let many = names.clone();
    if let Some(last) = names.last_mut() {
        *last = singular(last);
    }
    let n = (all.n - 1).to_string();
    let words = [vec![n, looks[0].clone()], many, vec!["and".into(), "one".into(), looks[1].clone()], names].concat();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    put(tokens, from, comma + 3, &words);
    tokens[from].kind = WordKind::Number((all.n - 1) as f64);
    true
}

/// "Chairs, at least three of them": at least three chairs.
fn so_many_of_them(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !tokens[i].is(",") {
        return false;
    }
    let words = match [word(tokens, i + 1), word(tokens, i + 2)] {
        ["at", "least" | "most"] => 2,
        ["exactly", _] => 1,
        _ => return false,
    };
    let Some((_, used)) = tokens.get(i + 1 + words..).and_then(number::count) else { return false };
    let of = i + 1 + words + used;
    if word(tokens, of) != "of" || word(tokens, of + 1) != "them" || !ends(tokens, of + 2) {
        return false;
    }
    const BACK: usize = 4;
    let plural = |k: &usize| {
        let named = noun(tokens, *k).filter(|name| name.end == i && name.start == *k);
        named.is_some_and(|name| singular(&tokens[name.end - 1].text) != tokens[name.end - 1].text)
    };
    let Some(from) = (i.saturating_sub(BACK)..i).find(plural) else { return false };
    let looks = (0..from).rev().take_while(|k| get().is_look(&tokens[*k].text)).count();
    let said: Vec<Token> = tokens[i + 1..of].to_vec();
    tokens.drain(i..of + 2);
    tokens.splice(from - looks..from - looks, said);
    true
}

/// "A hall, 20 metres on each side", "a cell 3 m square": 20 by 20 metres.
fn square(tokens: &mut Vec<Token>, i: usize) -> bool {
    let Some((_, used)) = tokens.get(i..).and_then(super::measure::measure) else { return false };
    let end = i + used;
    let sides = word(tokens, end) == "on"
        && matches!(word(tokens, end + 1), "each" | "every" | "a")
        && word(tokens, end + 2) == "side";
    let to = match () {
        () if sides => end + 3,
        () if word(tokens, end) == "square" => end + 1,
        () => return false,
    };
    if used > 2 || !ends(tokens, to) {
        return false;
    }
    let measure = tokens[i..end].to_vec();
    put(tokens, end, to, &["by"]);
    tokens.splice(end + 1..end + 1, measure);
    true
}

/// "Keep everything at least 1 m away from the door": nothing is within 1 m of the door.
fn keep_away(tokens: &mut Vec<Token>, i: usize) -> bool {
    let all = matches!(word(tokens, i + 1), "everything" | "all");
    if !matches!(word(tokens, i), "keep" | "leave") || !all {
        return false;
    }
    let least = if word(tokens, i + 2) == "at" && word(tokens, i + 3) == "least" { i + 4 } else { i + 2 };
    let Some((_, used)) = tokens.get(least..).and_then(super::measure::measure) else { return false };
    let end = least + used;
    let away = usize::from(word(tokens, end) == "away");
    if word(tokens, end + away) != "from" {
        return false;
    }
    put(tokens, end, end + away + 1, &["of"]);
    put(tokens, i, least, &["nothing", "is", "within"]);
    true
}

/// "A two-seater and a lamp": a sofa for two.
fn two_seater(tokens: &mut Vec<Token>, i: usize) -> bool {
    // "A three seater sofa" is one.
    let seats = matches!(word(tokens, i), "two" | "three" | "four") && matches!(word(tokens, i + 1), "seat" | "seater");
    if seats && matches!(word(tokens, i + 2), "sofa" | "couch" | "settee" | "bench") {
        let text = format!("{}-seater", word(tokens, i));
        put(tokens, i, i + 2, &[&text]);
        return true;
    }
    let said =
        matches!(word(tokens, i), "two-seater" | "three-seater" | "four-seater" | "two-seaters" | "three-seaters");
    if !said || noun(tokens, i + 1).is_some_and(|name| name.end > i + 1) {
        return false;
    }
    let many = word(tokens, i).ends_with('s');
    let text = tokens[i].text.trim_end_matches('s').to_owned();
    put(tokens, i, i + 1, &[&text, if many { "sofas" } else { "sofa" }]);
    true
}

/// "A kitchen and a hall joined by a door": connected.
fn joined_by(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = matches!(word(tokens, i), "joined" | "linked")
        && word(tokens, i + 1) == "by"
        && matches!(word(tokens, i + 2), "a" | "an" | "the" | "one");
    if said {
        put(tokens, i, i + 1, &["connected"]);
    }
    said
}

/// "A tray with cups on the table": a tray on the table; the tray holds cups.
fn filled(tokens: &mut Vec<Token>, i: usize) -> bool {
    const HOLDERS: [&str; 6] = ["tray", "plate", "bowl", "basket", "crate", "platter"];
    if !HOLDERS.contains(&word(tokens, i)) || word(tokens, i + 1) != "with" || i == 0 {
        return false;
    }
    let Some((_, used)) = tokens.get(i + 2..).map(|rest| number::count(rest).unwrap_or((1.0, 0))) else {
        return false;
    };
    let Some(name) = noun(tokens, i + 2 + used) else { return false };
    let small = get().noun(&singular(&tokens[name.end - 1].text)) == Some(Group::Top);
    let many = singular(&tokens[name.end - 1].text) != tokens[name.end - 1].text;
    let on = word(tokens, name.end) == "on" && matches!(word(tokens, name.end + 1), "the" | "a");
    let Some(carrier) = noun(tokens, name.end + 2).filter(|to| small && many && on && ends(tokens, to.end)) else {
        return false;
    };
    if tokens.get(carrier.end).is_some_and(|t| t.is("and") || t.is(",")) {
        return false;
    }
    let holder = tokens[i].clone();
    let make = |text: &str| Token { text: text.to_owned(), ..holder.clone() };
    let mut stop = make(".");
    sentence(&mut stop);
    let contents: Vec<Token> = tokens[i + 2..name.end].to_vec();
    let place: Vec<Token> = tokens[name.end..carrier.end].to_vec();
    let said = [place, vec![stop, make("the"), holder.clone(), make("holds")], contents].concat();
    tokens.splice(i + 1..carrier.end, said);
    true
}

/// "A desk, two chairs and a bookshelf behind": behind the desk.
fn behind_what(tokens: &mut Vec<Token>, i: usize) -> bool {
    const BEFORE: [&str; 5] = ["desk", "counter", "bar", "sofa", "couch"];
    if word(tokens, i) != "behind" || !ends(tokens, i + 1) || i == 0 || word(tokens, i - 1) == "from" {
        return false;
    }
    let named = noun_before(tokens, i);
    let starts = |k: &usize| matches!(tokens[*k].kind, WordKind::Line | WordKind::Sign('.' | ';'));
    let from = (0..i).rev().find(starts).map_or(0, |k| k + 1);
    let what = (from..i).find(|k| BEFORE.contains(&word(tokens, *k)));
    let Some(what) = what.filter(|what| named && *what + 1 < i) else { return false };
    let what = tokens[what].text.clone();
    put(tokens, i, i + 1, &["behind", "the", &what]);
    true
}

/// Whether a noun ends before a token.
fn noun_before(tokens: &[Token], i: usize) -> bool {
    (i.saturating_sub(3)..i).any(|k| noun(tokens, k).is_some_and(|name| name.end == i))
}

/// "An office for two people working back to back": with two desks at opposite walls.
fn back_to_back(tokens: &mut Vec<Token>, i: usize) -> bool {
    let back = ["back", "to", "back"].iter().enumerate().all(|(k, said)| word(tokens, i + 1 + k) == *said);
    let who = usize::from(i > 0 && word(tokens, i - 1) == "who");
    if !matches!(word(tokens, i), "working" | "sitting" | "work" | "sit")
        || !back
        || i < 2 + who
        || !matches!(word(tokens, i - 1 - who), "people" | "persons")
    {
        return false;
    }
    let Some((n, _)) = (2..i).rev().take(2 + who).find_map(|k| number::count(&tokens[k..i])) else { return false };
    // "Each with their own desk": these are the two desks.
    let own = i + 4 + usize::from(tokens.get(i + 4).is_some_and(|t| t.is(",")));
    let each =
        ["each", "with", "their", "own", "desk"].iter().enumerate().all(|(k, said)| word(tokens, own + k) == *said);
    let has_desk = !each && tokens.iter().any(|t| t.is("desks") || t.is("desk"));
    if n != 2.0 || has_desk {
        return false;
    }
    if each {
        let more = own + 5;
        let goes_on = tokens.get(more).is_some_and(|t| t.is(",") || t.is("and"));
        put(tokens, own, more + usize::from(goes_on), if goes_on { &["each", "with", "a"] } else { &[] });
        if !goes_on {
            tokens.drain(own..own + 5);
        }
    }
    put(tokens, i - who, i + 4, &["with", "two", "desks", "against", "opposite", "walls"]);
    true
}

/// "My office is only 3 x 2.5 metres": it is so large.
fn only_so_large(tokens: &mut Vec<Token>, i: usize) -> bool {
    let about = usize::from(matches!(word(tokens, i + 2), "about" | "around" | "roughly" | "some"));
    let is = matches!(word(tokens, i), "is" | "measures") && matches!(word(tokens, i + 1), "only" | "just");
    let number = tokens.get(i + 2 + about).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let measured = tokens.get(i + 3 + about).is_some_and(|t| {
        matches!(
            t.text.as_str(),
            "x" | "×" | "by" | "m" | "metres" | "meters" | "square" | "sqm" | "m²" | "feet" | "ft"
        )
    });
    if !is || !number || !measured {
        return false;
    }
    put(tokens, i, i + 2 + about, &["is"]);
    true
}

/// "A bedroom only 3 by 3 metres".
fn only_by(tokens: &mut Vec<Token>, i: usize) -> bool {
    let number = |k: usize| tokens.get(k).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let by = matches!(word(tokens, i + 2), "by" | "x" | "×") || tokens.get(i + 2).is_some_and(|t| t.is("×"));
    if !matches!(word(tokens, i), "only" | "just") || i == 0 || !number(i + 1) || !by || !number(i + 3) {
        return false;
    }
    let mut size = tokens[i + 1].clone();
    size.at.start = tokens[i].at.start;
    tokens.splice(i..i + 2, [size]);
    true
}

/// "A bed along the wall, a desk with two monitors opposite": the desk is opposite the bed. "A bed, nightstands with lamps either
/// side": on either side of the bed.
fn moved_ahead(tokens: &mut Vec<Token>, i: usize) -> bool {
    let (used, words) = match (word(tokens, i), word(tokens, i + 1), word(tokens, i + 2)) {
        ("opposite", ..) if ends(tokens, i + 1) => (1, &["opposite", "the"][..]),
        ("either", "side", _) | ("both", "sides", _) if ends(tokens, i + 2) => {
            (2, &["on", "either", "side", "of", "the"][..])
        }
        _ => return false,
    };
    // "On either side" is read where it is.
    if i == 0 || matches!(word(tokens, i - 1), "on" | "at" | "from" | "along" | "to") {
        return false;
    }
    let comma = |end: usize| tokens[..end].iter().rposition(|t| t.is(","));
    let Some(last) = comma(i) else { return false };
    let with = (last + 1..i).find(|k| word(tokens, *k) == "with").filter(|with| with + 1 < i);
    let stops = |t: &Token| matches!(t.kind, WordKind::Line | WordKind::Sign('.' | ',' | ';' | ':'));
    let start = tokens[..last].iter().rposition(stops).map_or(0, |k| k + 1);
    let start = start + usize::from(matches!(word(tokens, start), "a" | "an" | "the"));
    let name = noun(tokens, start).filter(|name| name.end <= last);
    if name.is_none() && used == 2 && with.is_none() {
        // "A kitchen, 2 m wide, counters both sides": of the room.
        put(tokens, i, i + 2, &["along", "both", "long", "walls"]);
        return true;
    }
    let (Some(name), Some(with)) = (name, with.or_else(|| (used == 2).then_some(i))) else { return false };
    let like = Token { at: tokens[i].at.start..tokens[i + used - 1].at.end, ..tokens[i].clone() };
    let mut said: Vec<Token> = words.iter().map(|text| Token { text: (*text).to_owned(), ..like.clone() }).collect();
    said.push(tokens[name.end - 1].clone());
    tokens.drain(i..i + used);
    tokens.splice(with..with, said);
    true
}

/// "2 metres wide and 4 long": 4 metres long.
fn same_unit(tokens: &mut Vec<Token>, i: usize) -> bool {
    let dim = |k: usize| matches!(word(tokens, k), "long" | "wide" | "deep" | "high");
    let number = |k: usize| tokens.get(k).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let joined = i > 3 && word(tokens, i - 1) == "and" && dim(i - 2);
    let unit = joined && number::unit(word(tokens, i - 3)).is_some() && number(i - 4);
    if !unit || !number(i) || !dim(i + 1) {
        return false;
    }
    let unit = tokens[i - 3].text.clone();
    let same = Token { text: unit, ..tokens[i + 1].clone() };
    tokens.insert(i + 1, same);
    true
}

/// "A tub under the window and a towel rail by the bath": the bath is the tub.
fn same_bath(tokens: &mut Vec<Token>, i: usize) -> bool {
    const NAMES: [&str; 3] = ["tub", "bathtub", "bath"];
    let name = word(tokens, i + 1);
    if word(tokens, i) != "the" || !NAMES.contains(&name) {
        return false;
    }
    let named = |t: &Token| NAMES.iter().any(|name| t.is(name));
    let Some(first) = tokens[..i].iter().find(|t| named(t)).map(|t| t.text.clone()).filter(|first| first != name)
    else {
        return false;
    };
    put(tokens, i + 1, i + 2, &[&first]);
    true
}

/// "16 university students": 16 students.
fn students(tokens: &mut Vec<Token>, i: usize) -> bool {
    let number = tokens.get(i).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let of = matches!(word(tokens, i + 1), "university" | "college" | "school" | "office" | "primary");
    if !number || !of || !get().is(word(tokens, i + 2), Class::Person) {
        return false;
    }
    let who = tokens[i + 2].text.clone();
    put(tokens, i + 1, i + 3, &[&who]);
    true
}

/// "Scatter five or six tables around": five tables.
fn scattered(tokens: &mut Vec<Token>, i: usize) -> bool {
    if !matches!(word(tokens, i), "scatter" | "spread" | "dot") {
        return false;
    }
    let Some((_, used)) = tokens.get(i + 1..).and_then(number::count) else { return false };
    let Some(name) = noun(tokens, i + 1 + used) else { return false };
    let around = name.end;
    let room = word(tokens, around + 1) == "the" && matches!(word(tokens, around + 2), "room" | "floor" | "place");
    if !matches!(word(tokens, around), "around" | "about" | "throughout" | "across")
        || !room && get().noun(word(tokens, around + 2)).is_some()
    {
        return false;
    }
    let last = tokens[around - 1].text.clone();
    put(tokens, around - 1, around + 1 + 2 * usize::from(room), &[&last]);
    put(tokens, i, i + 1, &["there", "are"]);
    true
}

/// "A conveyor running down the middle": in the middle. "Three plinths with busts down the centre line": the plinths are in a row there.
fn down_the_middle(tokens: &mut Vec<Token>, i: usize) -> bool {
    let that = usize::from(matches!(word(tokens, i), "that" | "which"));
    let runs = usize::from(matches!(
        word(tokens, i + that),
        "running" | "runs" | "going" | "goes" | "standing" | "stand" | "placed" | "set"
    ));
    let down = i + that + runs;
    let said = matches!(word(tokens, down), "down" | "along" | "through")
        && word(tokens, down + 1) == "the"
        && matches!(word(tokens, down + 2), "middle" | "centre" | "center")
        && (runs == 1 || that == 0 && word(tokens, down) != "through");
    // Aisles and paths are read elsewhere.
    let passage =
        i > 0 && matches!(word(tokens, i - 1), "aisle" | "path" | "corridor" | "walkway" | "passage" | "gap" | "wide");
    if !said || passage || i == 0 {
        return false;
    }
    let line = usize::from(matches!(word(tokens, down + 3), "line" | "axis"));
    let end = down + 3 + line;
    // What is on them does not stand there by itself.
    let with = (i.saturating_sub(6)..i).rev().find(|k| *k > 0 && word(tokens, *k) == "with");
    let host = with.filter(|k| plural(word(tokens, k - 1)) || matches!(word(tokens, k - 1), "plinth" | "pedestal"));
    let many = plural(word(tokens, host.unwrap_or(i) - 1));
    let words: &[&str] = if many { &["in", "a", "row", "in", "the", "middle"] } else { &["in", "the", "middle"] };
    put(tokens, i, end, words);
    if let Some(with) = host {
        tokens[with..i + words.len()].rotate_right(words.len());
    }
    true
}

/// "No coffee table because of the dog": the reason is no thing of the room.
fn reason(tokens: &mut [Token], i: usize) -> bool {
    let because = matches!(word(tokens, i), "because" | "cause" | "cos" | "'cause") && word(tokens, i + 1) == "of";
    let said = i > 0 && (because || word(tokens, i) == "due" && word(tokens, i + 1) == "to");
    if said {
        tokens[i].text = ",".to_owned();
        tokens[i].kind = WordKind::Sign(',');
    }
    said
}

/// "Spotlights on tracks": track lights.
fn on_tracks(tokens: &mut Vec<Token>, i: usize) -> bool {
    let lights = matches!(word(tokens, i), "spotlights" | "lights" | "spots" | "lamps");
    let article = usize::from(matches!(word(tokens, i + 2), "a" | "the"));
    let end = i + 2 + article;
    let tracks = matches!(word(tokens, end), "tracks" | "track" | "rails" | "rail");
    let said = lights && word(tokens, i + 1) == "on" && tracks;
    if said {
        put(tokens, i, end + 1, &["track", "lights"]);
    }
    said
}

/// "A plinth with a bust": it stands on it.
fn on_plinths(tokens: &mut Vec<Token>, i: usize) -> bool {
    let many = matches!(word(tokens, i), "plinths" | "pedestals" | "podiums");
    let one = matches!(word(tokens, i), "plinth" | "pedestal");
    let article = usize::from(matches!(word(tokens, i + 2), "a" | "an"));
    let name = noun(tokens, i + 2 + article).filter(|_| (many || one) && word(tokens, i + 1) == "with");
    let placed = |k: usize| matches!(word(tokens, k), "down" | "along" | "in" | "at" | "by" | "near");
    let Some(name) = name.filter(|name| ends(tokens, name.end) || placed(name.end)) else { return false };
    super::shares::insert(tokens, name.end, if many { &["on", "them"] } else { &["on", "it"] });
    true
}

/// "With mugs and plates left behind": behind nothing.
fn left_behind(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "left" && word(tokens, i + 1) == "behind" && ends(tokens, i + 2) && i > 0;
    if said {
        let last = tokens[i - 1].text.clone();
        put(tokens, i - 1, i + 2, &[&last]);
    }
    said
}

/// "A standard hotel double": a hotel room.
fn hotel_double(tokens: &mut Vec<Token>, i: usize) -> bool {
    let said = word(tokens, i) == "hotel" && matches!(word(tokens, i + 1), "double" | "twin" | "single" | "suite");
    if said && (ends(tokens, i + 2) || word(tokens, i + 2) == "with") {
        put(tokens, i + 1, i + 2, &["room"]);
        return true;
    }
    false
}

/// "A galley kitchen with counters": kitchen counters, unless guests are served there.
fn kitchen_counters(tokens: &mut Vec<Token>, i: usize) -> bool {
    const SERVED: [&str; 12] = [
        "cafe",
        "café",
        "restaurant",
        "shop",
        "bar",
        "store",
        "reception",
        "till",
        "customers",
        "canteen",
        "customer",
        "breakfast",
    ];
    let is = |t: &Token, names: &[&str]| names.iter().any(|name| t.is(name));
    let is_kitchen = tokens.iter().any(|t| is(t, &["kitchen", "kitchenette"]));
    let bare = i == 0 || !get().is_look(word(tokens, i - 1)) && get().noun(word(tokens, i - 1)).is_none();
    let named = i > 0 && (tokens[i - 1].is("kitchen") || tokens[i - 1].is("the"));
    let known = tokens[..i].iter().any(|t| is(t, &["counter", "counters", "countertop"]));
    let said = matches!(word(tokens, i), "counter" | "counters") && is_kitchen && bare && !named && !known;
    if !said || tokens.iter().any(|t| is(t, &SERVED)) {
        return false;
    }
    let name = tokens[i].text.clone();
    put(tokens, i, i + 1, &["kitchen", &name]);
    true
}

/// "For a horror game level": for playing, not with a game in the room.
fn in_a_game(tokens: &mut Vec<Token>, i: usize) -> bool {
    const ADJECTIVES: usize = 3;
    if word(tokens, i) != "for" || !matches!(word(tokens, i + 1), "a" | "an" | "my" | "our" | "the") {
        return false;
    }
    let Some(game) = (i + 2..i + 2 + ADJECTIVES).find(|k| word(tokens, *k) == "game") else { return false };
    let end = game + 1 + usize::from(matches!(word(tokens, game + 1), "level" | "scene" | "map" | "environment"));
    if matches!(word(tokens, game - 1), "board" | "card" | "video") && end == game + 1 || !ends(tokens, end) {
        return false;
    }
    put(tokens, i + 1, end, &["playing"]);
    true
}

/// "A cake display next to the till": next to the counter, on which the till stands.
fn at_the_till(tokens: &mut Vec<Token>, i: usize) -> bool {
    let near = matches!(word(tokens, i), "to" | "beside" | "by" | "near" | "behind") && word(tokens, i + 1) == "the";
    let cash = word(tokens, i + 2) == "cash" && word(tokens, i + 3) == "register";
    let end = i + 3 + usize::from(cash);
    let till = cash || word(tokens, i + 2) == "till";
    let again = tokens.iter().filter(|t| t.is("till") || t.is("register") || t.is("counter")).count() > 1;
    if !near || !till || again || !ends(tokens, end) {
        return false;
    }
    let till: Vec<Token> = tokens[i + 2..end].to_vec();
    put(tokens, i + 2, end, &["counter", "with", "a"]);
    tokens.splice(i + 5..i + 5, till);
    true
}

/// "An art gallery with two connected rooms and a bench": two art galleries, between which there is a door.
fn connected_rooms(tokens: &mut Vec<Token>, i: usize) -> bool {
    const LONGEST: usize = 3;
    if !matches!(word(tokens, i), "a" | "an") && i != 0 {
        return false;
    }
    let first = i + usize::from(matches!(word(tokens, i), "a" | "an"));
    let kind = |n: &usize| {
        let words: Vec<&str> = (first..first + n).map(|k| word(tokens, k)).collect();
        get().room(&words.join(" ")).is_some() && word(tokens, first + n) == "with"
    };
    let Some(n) = (1..=LONGEST).find(kind) else { return false };
    let with = first + n;
    let connected =
        matches!(word(tokens, with + 2), "connected" | "adjoining" | "interconnected" | "linked" | "connecting");
    let two = matches!(word(tokens, with + 1), "two" | "2");
    if !two || !connected || word(tokens, with + 3) != "rooms" || !ends(tokens, with + 4) {
        return false;
    }
    let last = word(tokens, with - 1);
    let many = match last.strip_suffix('y') {
        Some(stem) if !stem.ends_with(['a', 'e', 'o']) => format!("{stem}ies"),
        _ => format!("{last}s"),
    };
    let mut said = vec!["two".to_owned()];
    said.extend((first..with - 1).map(|k| word(tokens, k).to_owned()));
    said.push(many);
    let goes_on = tokens.get(with + 4).is_some_and(|t| t.is(",") || t.is("and"));
    if goes_on {
        said.push("with".into());
    }
    let said: Vec<&str> = said.iter().map(String::as_str).collect();
    put(tokens, i, with + 4 + usize::from(goes_on), &said);
    true
}

/// "Two offices connected by a door, with a desk in each": two offices, between which there is a door.
fn connected_by(tokens: &mut Vec<Token>, i: usize) -> bool {
    const LONGEST: usize = 3;
    let connected = matches!(word(tokens, i), "connected" | "joined" | "linked") && word(tokens, i + 1) == "by";
    let door = matches!(word(tokens, i + 2), "a" | "one") && matches!(word(tokens, i + 3), "door" | "doorway");
    let rooms = (1..=LONGEST.min(i.saturating_sub(1))).any(|n| {
        let words: Vec<&str> = (i - n..i).map(|k| word(tokens, k)).collect();
        let many = words.last().is_some_and(|last| singular(last) != *last);
        many && get().room(&singular(&words.join(" "))).is_some() && matches!(word(tokens, i - n - 1), "two" | "2")
    });
    let said = connected && door && rooms && ends(tokens, i + 4);
    if said {
        let comma = usize::from(tokens.get(i + 4).is_some_and(|t| t.is(",")) && word(tokens, i + 5) == "with");
        tokens.drain(i..i + 4 + comma);
    }
    said
}

/// "A washer and a dryer. The washer is white; a basket stands on the other one": on the dryer. Of two things of different
/// kinds the other one is that of which nothing was said last.
fn other_one(tokens: &mut Vec<Token>, i: usize) -> bool {
    if word(tokens, i) != "the" || word(tokens, i + 1) != "other" || word(tokens, i + 2) != "one" {
        return false;
    }
    let stops = |k: &usize| matches!(tokens[*k].kind, WordKind::Line | WordKind::Sign('.' | ';'));
    let Some(start) = (0..i).rev().find(stops) else { return false };
    let (mut names, mut last): (Vec<String>, Option<String>) = (Vec::new(), None);
    let mut k = 0;
    while k < start {
        let article = matches!(word(tokens, k), "a" | "an" | "the");
        let Some(at) = noun(tokens, k + 1).filter(|at| article && at.end <= start) else {
            k += 1;
            continue;
        };
        let name = tokens[at.clone()].iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ");
        k = at.end;
        if get().room(&name).is_none() {
            if !names.contains(&name) {
                names.push(name.clone());
            }
            last = Some(name);
        }
    }
    let ([first, second], Some(last)) = (&names[..], last) else { return false };
    let other = if *first == last { second } else { first };
    let said: Vec<&str> = ["the"].into_iter().chain(other.split(' ')).collect();
    put(tokens, i, i + 3, &said);
    true
}

#[cfg(test)]
mod tests {
    use super::super::paraphrase;

    #[test]
    fn what_follows_a_noun_goes_before_it() {
        for (text, becomes) in [
            ("a sink, a stove, and a fridge, which is tall.", "a sink , a stove , and a tall fridge ."),
            ("three red chairs and a table which is black.", "three red chairs and a black table ."),
            ("a sofa facing the tv, which is black.", "a sofa facing the tv , which is black ."),
            ("twelve chairs, all brown except one, which is black.", "11 brown chairs and one black chair ."),
            ("there are chairs, at least three of them.", "there are at least three chairs ."),
            ("a hall, 20 metres on each side.", "a hall , 20 metres by 20 metres ."),
            ("keep everything at least 1 m away from the door.", "nothing is within 1 m of the door ."),
            ("a two-seater and a lamp.", "a two-seater sofa and a lamp ."),
            ("a two-seater sofa.", "a two-seater sofa ."),
            ("a kitchen and a hall joined by a door.", "a kitchen and a hall connected by a door ."),
            ("a tray with cups on the table.", "a tray on the table . the tray holds cups ."),
            ("a desk, two chairs and a bookshelf behind.", "a desk , two chairs and a bookshelf behind the desk ."),
            (
                "an office for two people working back to back.",
                "an office for two people with two desks against opposite walls .",
            ),
            ("a grocery with five aisles and a till.", "a grocery with five rows of shelves and a till ."),
            ("a cake display next to the till.", "a cake display next to the counter with a till ."),
            ("a bowl with fruit on the table.", "a bowl with fruit on the table ."),
            (
                "an art gallery with two connected rooms, paintings and a bench.",
                "two art galleries with paintings and a bench .",
            ),
            ("two offices connected by a door, with a desk in each.", "two offices with a desk in each ."),
            (
                "a washer and a dryer. the washer is white; a basket stands on the other one.",
                "a washer and a dryer . the washer is white ; a basket stands on the dryer .",
            ),
            (
                "two lamps and a desk. the one is red; a cup is on the other one.",
                "two lamps and a desk . the one is red ; a cup is on the other one .",
            ),
            (
                "a warehouse with four rows of shelves, aisles 2 metres wide, and a robot.",
                "a warehouse with four rows of shelves , 2 metres between the rows , and a robot .",
            ),
            ("my home office is only 3 x 2.5 metres.", "my home office is 3 x 2.5 metres ."),
            ("there is only 1 desk.", "there is only 1 desk ."),
            (
                "a bed along the right wall, gaming desk with two monitors opposite, beanbag.",
                "a bed along the right wall , gaming desk opposite the bed with two monitors , beanbag .",
            ),
            ("a bedroom only 3 by 3 metres with a bed.", "a bedroom 3 by 3 metres with a bed ."),
            (
                "a queen bed facing the window, matching nightstands with lamps either side.",
                "a queen bed facing the window , matching nightstands on either side of the bed with lamps .",
            ),
            ("a bed, nightstands either side, a rug.", "a bed , nightstands on either side of the bed , a rug ."),
            ("a bed with lamps on either side.", "a bed with lamps on either side ."),
            (
                "a kitchen, 2 metres wide and 4 long, counters both sides.",
                "a kitchen , 2 metres wide and 4 metres long , kitchen counters along both long walls .",
            ),
            ("a tub and a towel rail near the bath.", "a tub and a towel rail near the tub ."),
            ("a standard hotel double, 22 square metres.", "a standard hotel room , 22 square metres ."),
            ("a kitchen with counters and a sink.", "a kitchen with kitchen counters and a sink ."),
            ("a cafe with a kitchen and a counter.", "a cafe with a kitchen and a counter ."),
            ("a lab for 16 university students.", "a lab for 16 students ."),
            ("a lab for a horror game level, two benches.", "a lab for playing , two benches ."),
            ("a shelf for a board game.", "a shelf for a board game ."),
            ("scatter five or six tables around with benches", "there are five or six tables with benches"),
            ("a three seater sofa and a two seat couch", "a three-seater sofa and a two-seater couch"),
            (
                "an office for two people who work back to back, each with their own desk, monitor and chair.",
                "an office for two people with two desks against opposite walls , each with a monitor and chair .",
            ),
            ("a conveyor belt running down the middle", "a conveyor belt in the middle"),
            ("three long tables down the centre of the room", "three long tables in a row in the middle of the room"),
            (
                "three plinths with busts down the centre line, a bench",
                "three plinths in a row in the middle with busts on them . there is a bench",
            ),
            ("a plinth with a vase", "a plinth with a vase on it"),
            ("spotlights on tracks, a bench", "track lights , a bench"),
            ("no rug because of the dog", "no rug , of the dog"),
            ("a path down the middle", "a path down the middle"),
            ("down the middle", "down the middle"),
            ("with mugs and plates left behind.", "with mugs and plates ."),
            ("scatter three rugs around the table", "scatter three rugs around the table"),
            ("a bed, a desk opposite.", "a bed , a desk opposite it ."),
            ("two desks connected by a door.", "two desks connected by a door ."),
            ("an office with two connected desks.", "an office with two connected desks ."),
        ] {
            assert_eq!(paraphrase::plainly(text), becomes);
        }
    }
}
