//! Boats, wagons and tents that one is inside of: "a narrowboat, 17 m long, with a bed" and "inside a yurt: …" ask for that room
//! and for no boat in one.

use super::lexicon::get;
use super::paraphrase::word;
use super::token::{Token, WordKind};

/// What encloses people without being a building.
const NAMES: [&str; 41] = [
    "airship",
    "barge",
    "boat",
    "bus",
    "camper",
    "campervan",
    "canoe",
    "capsule",
    "caravan",
    "carriage",
    "coach",
    "container",
    "cockpit",
    "dinghy",
    "gondola",
    "greenhouse",
    "houseboat",
    "hut",
    "igloo",
    "lighthouse",
    "lorry",
    "motorhome",
    "narrowboat",
    "pod",
    "rv",
    "ship",
    "submarine",
    "teepee",
    "tent",
    "tepee",
    "tower",
    "trailer",
    "train",
    "tram",
    "trawler",
    "treehouse",
    "truck",
    "van",
    "wagon",
    "yacht",
    "yurt",
];
/// The most words of the name.
const LONGEST: usize = 5;

/// Makes a room of the enclosure that a request begins with.
pub fn plain(tokens: &mut Vec<Token>) {
    let inside =
        ["inside of", "interior of", "inside", "the inside of", "the interior of", "i would like", "i want", "we need"];
    // "Ok so picture a treehouse".
    let talk = tokens.iter().take(5).take_while(|t| !matches!(t.text.as_str(), "a" | "an" | "the")).count();
    if talk > 0 && matches!(word(tokens, talk - 1), "picture" | "imagine") {
        tokens.drain(..talk);
    }
    let lead = inside
        .iter()
        .map(|words| words.split(' ').collect::<Vec<_>>())
        .find(|words| words.iter().enumerate().all(|(k, said)| word(tokens, k) == *said));
    let lead = lead.map_or(0, |words| words.len());
    let is_inside = lead > 0 && !matches!(word(tokens, 0), "i" | "we");
    let from = lead + usize::from(matches!(word(tokens, lead), "a" | "an" | "the" | "my" | "our"));
    let named = |k: &usize| NAMES.contains(&word(tokens, *k));
    let Some(last) = (from..from + LONGEST).take_while(|k| tokens.get(*k).is_some_and(Token::word)).find(named) else {
        return;
    };
    // "A bus station", "a tent and a fire", "toy boat": no room.
    let before_known = (from..last).any(|k| get().noun(word(tokens, k)).is_some() || tokens[k].is("with"));
    let number = |k: usize| tokens.get(k).is_some_and(|t| matches!(t.kind, WordKind::Number(_)));
    let measured = |k: usize| {
        let is_size = |k: &usize| matches!(word(tokens, *k), "long" | "wide" | "by" | "x");
        (k..k + 14).filter(is_size).any(|k| number(k.saturating_sub(1)) || number(k.saturating_sub(2)))
    };
    // Nobody has a greenhouse in a room.
    let is_inside = is_inside
        || matches!(
            word(tokens, last),
            "greenhouse" | "houseboat" | "lighthouse" | "narrowboat" | "submarine" | "treehouse" | "yurt"
        );
    let interior = word(tokens, last + 1) == "interior";
    let after = tokens.get(last + 1);
    let is_room = match after.map(|t| (&t.kind, t.text.as_str())) {
        Some((WordKind::Sign(':'), _)) => true,
        Some((WordKind::Sign(',' | '.'), _)) => is_inside || measured(last + 1),
        Some((_, "with" | "where" | "laid" | "for")) => is_inside || measured(last + 1),
        Some((_, "interior")) => true,
        None => is_inside,
        _ => false,
    };
    if !is_room || before_known {
        return;
    }
    let name = tokens[last].clone();
    match interior {
        true => tokens[last + 1] = tokens[last + 1].saying("room"),
        false => tokens.insert(last + 1, name.saying("room")),
    }
    if is_inside {
        tokens.drain(..lead);
    }
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;

    #[test]
    fn what_one_is_inside_of_is_a_room() {
        for (text, becomes) in [
            (
                "a narrowboat, 17 m long and 2 m wide, with a bed",
                "a narrowboat room , 17 m long and 2 m wide , with a bed",
            ),
            ("inside of a yurt: a stove", "a yurt room : a stove"),
            ("tent interior, a camp bed", "tent room , a camp bed"),
            ("a wagon: a stove", "a wagon room : a stove"),
            ("a tent, a lamp and a chair", "a tent , a lamp and a chair"),
            ("a garage with a van", "a garage with a van"),
            ("a bus station with benches", "a bus station with benches"),
        ] {
            let mut tokens = tokens(text, 100).0;
            super::plain(&mut tokens);
            let rest: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
            assert_eq!(rest.join(" "), becomes, "{text}");
        }
    }
}
