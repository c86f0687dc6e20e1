//! What is known of how things stand: on the floor or not, with their back at a wall or not, how much room their use
//! takes, and which words may be counted as one thing.

use crate::brief::Group;
use crate::draft::{Draft, DraftThing, Statement, ThingOrigin};
use crate::names::{calls, mentions};
use crate::read::lexicon::get;
use scenelang_lang::nouns::{self, Stands};
use std::collections::HashMap;
use std::sync::OnceLock;

/// The words of `data/kin.txt`.
#[derive(Default)]
struct Words {
    /// Words that name one kind of thing.
    kin: Vec<Vec<&'static str>>,
    /// By word: which of `kin` it is among, in order.
    among: HashMap<&'static str, Vec<usize>>,
    /// A thing, and what serves as well.
    instead: Vec<(&'static str, Vec<&'static str>)>,
}

fn known() -> &'static Words {
    static WORDS: OnceLock<Words> = OnceLock::new();
    WORDS.get_or_init(|| {
        let list = |text: &'static str| text.split(',').map(str::trim).collect::<Vec<_>>();
        let mut words = Words::default();
        for line in include_str!("../../data/kin.txt").lines().filter(|l| !l.starts_with('#') && !l.is_empty()) {
            match line.split_once('<') {
                Some((noun, instead)) => words.instead.push((noun.trim(), list(instead))),
                None => words.kin.push(list(line)),
            }
        }
        for (at, kin) in words.kin.iter().enumerate() {
            kin.iter().for_each(|word| words.among.entry(word).or_default().push(at));
        }
        words
    })
}

/// The lists of kin that a word is among.
fn kin_of(word: &str) -> &'static [usize] {
    known().among.get(word).map_or(&[], Vec::as_slice)
}

/// Whether two words are among the same kin.
fn share_kin(a: &[usize], b: &[usize]) -> bool {
    a.iter().any(|kin| b.contains(kin))
}

/// What of a thing is in the way on the floor: under a parasol one sits.
pub fn foot(noun: &str, [w, h, d]: [f64; 3]) -> [f64; 3] {
    const FOOT: f64 = 0.2;
    if noun.ends_with("parasol") { [FOOT * w, h, FOOT * d] } else { [w, h, d] }
}

/// Whether something that is asked for stands in for another thing.
pub fn stands_in(noun: &str, asked: &str) -> bool {
    known().instead.iter().any(|(other, instead)| *other == noun && instead.contains(&asked))
}

/// Chairs that stand at no table.
const EASY: [&str; 10] =
    ["reading", "lounge", "rocking", "easy", "accent", "club", "waiting", "massage", "wing", "egg"];

/// Whether this is a chair that stands at no table.
pub fn is_easy(chair: &str) -> bool {
    chair.split(' ').any(|word| EASY.contains(&word))
}

/// Behind a rocking chair so much is free (metres).
pub const BEHIND_ROCKING: f64 = 0.25;

/// The room that something needs for itself: a rocking chair does not rock at a wall.
pub fn moving(noun: &str, [w, h, d]: [f64; 3]) -> [f64; 3] {
    const BESIDE: f64 = 0.1;
    const BEHIND: f64 = BEHIND_ROCKING + 0.03;
    if noun.ends_with("rocking chair") { [w + 2.0 * BESIDE, h, d + 2.0 * BEHIND] } else { [w, h, d] }
}

/// What guests use, beside seats: it does not stand behind the counter of those who serve them.
const GUESTS: [&str; 28] = [
    "arcade machine",
    "atm",
    "bistro table",
    "bookcase",
    "bookshelf",
    "booth",
    "brochure rack",
    "cafe table",
    "clothes rack",
    "coat rack",
    "coat stand",
    "dartboard",
    "display table",
    "fitting room",
    "high table",
    "jukebox",
    "kiosk",
    "low table",
    "luggage cart",
    "magazine rack",
    "mannequin",
    "pool table",
    "scale",
    "shopping basket",
    "standing table",
    "umbrella stand",
    "vending machine",
    "water dispenser",
];

/// What stands side by side without a gap: cupboards, shelves, machines of a kitchen.
pub fn lines_up(noun: &str) -> bool {
    const UNITS: [&str; 21] = [
        "bin",
        "board",
        "cart",
        "counter",
        "dishwasher",
        "dryer",
        "freezer",
        "fridge",
        "kitchenette",
        "nightstand",
        "oven",
        "piano",
        "plant",
        "rack",
        "safe",
        "sink",
        "stove",
        "table",
        "toilet",
        "washbasin",
        "machine",
    ];
    let last = noun.rsplit(' ').next().unwrap_or(noun);
    group(noun) == Group::Storage || UNITS.contains(&last)
}

/// Of which so many stand side by side in one row.
pub fn is_unit(noun: &str, n: usize) -> bool {
    // A wall of books.
    const WALL: usize = 3;
    if n >= WALL && ["bookshelf", "bookcase"].iter().any(|end| noun.ends_with(end)) {
        return true;
    }
    const UNITS: [&str; 14] = [
        "washing machine",
        "dryer",
        "locker",
        "vending machine",
        "arcade machine",
        "fridge",
        "freezer",
        "washbasin",
        "sink",
        "basin",
        "urinal",
        "slot machine",
        "pinball machine",
        "display fridge",
    ];
    UNITS.iter().any(|unit| noun == *unit || noun.ends_with(&format!(" {unit}")))
}

/// Whether guests use a thing of this name.
pub fn for_guests(noun: &str) -> bool {
    let is = |guest: &&str| noun == *guest || noun.ends_with(&format!(" {guest}"));
    group(noun) == Group::Seat || GUESTS.iter().any(is)
}

/// Whether a thing of this name could be taken for what is asked for: the same noun, one that includes it, or a synonym.
pub fn counts_as(noun: &str, asked: &str) -> bool {
    // A teacher's desk does not count as a pupil's.
    if noun == "teacher desk" && asked != "desk" && !asked.contains("teacher") && !are_kin(noun, asked) {
        return false;
    }
    // Nor is a counter at which one sits and looks out the one at which guests are served.
    if noun.starts_with(AT_WINDOW) != asked.starts_with(AT_WINDOW) {
        return false;
    }
    // The worktop around the corner of an L comes with the counter.
    if noun == "kitchen worktop" && asked.ends_with("counter") {
        return false;
    }
    // Who asks for an armchair in a nursery has it in the place of the rocking chair.
    if noun == "rocking chair" && asked == "armchair" {
        return true;
    }
    // A child has one bed: what is asked for instead of it.
    if noun == "single bed" && asked.ends_with(" bed") && group(asked) == Group::Bed {
        return true;
    }
    fn last(text: &str) -> &str {
        text.rsplit(' ').next().unwrap_or(text)
    }
    let ends_with = |text: &str, end: &str| text.strip_suffix(end).is_some_and(|before| before.ends_with(' '));
    let (head, other) = (last(noun), last(asked));
    let one_word = !noun.contains(' ') || !asked.contains(' ');
    // A chair at a table is not taken for one that is asked for to read in.
    let easy = is_easy(asked) && !is_easy(noun);
    if noun == asked || !easy && head == other && (one_word || ends_with(noun, asked) || ends_with(asked, noun)) {
        return true;
    }
    let [of_noun, of_asked, of_head, of_other] = [noun, asked, head, other].map(kin_of);
    share_kin(of_noun, of_asked)
        || share_kin(of_asked, of_head)
        || share_kin(of_noun, of_other) && !asked.contains(' ')
        || !easy && share_kin(of_head, of_other) && one_word
}

/// What belongs at a window has a name that begins so.
pub const AT_WINDOW: &str = "window ";

/// Whether a thing of a draft stands on the floor: by its group, unless it is said to be on something, or to hang.
pub fn on_floor(draft: &Draft, thing: &DraftThing) -> bool {
    if !matches!(group(&thing.category), Group::Seat | Group::Table | Group::Storage | Group::Bed | Group::Floor) {
        return false;
    }
    let carried = ["restsOn(", "on(", "wallMounted(", "ceilingMounted(", "allowFloat("];
    !draft.statements.iter().any(|s| {
        mentions(&s.text, &thing.name) && carried.iter().any(|c| s.text.contains(c)) && {
            let code: String = s.text.split_whitespace().collect();
            let first = |name: &str| carried.iter().any(|c| code.contains(&format!("{c}{name}")));
            first(&thing.name) || first("a,") && code.contains(&format!("forallain{}:", thing.name))
        }
    })
}

/// Whether a thing is round or oval, seen from above.
pub fn round(category: &str, features: &[String]) -> bool {
    const ROUND: [&str; 5] = ["round", "circular", "oval", "pedestal", "bistro"];
    let said = category.split(['_', ' ']).chain(features.iter().map(String::as_str));
    said.into_iter().any(|word| ROUND.contains(&word)) && group(category) == Group::Table
}

/// How things of this name are in a room.
pub fn group(category: &str) -> Group {
    let words: Vec<String> = category.split(['_', ' ']).map(str::to_owned).collect();
    get().noun_ending(&words).map_or(Group::Floor, |(_, group)| group)
}

/// Whether something of this name stands with its back at a wall.
pub fn has_back(category: &str) -> bool {
    nouns::ending(category).is_some_and(|noun| noun.stands == Stands::Back)
}

/// How much floor before a thing that stands at a wall is free for its use, in metres; `None`: none is kept free.
pub fn access(category: &str) -> Option<f64> {
    nouns::ending(category).filter(|noun| noun.stands == Stands::Back && noun.access > 0.0).map(|noun| noun.access)
}

/// Whether a thing is small and nobody steps up to it, as a plant or a cello: it stands out of the way.
pub fn is_aside(category: &str) -> bool {
    nouns::ending(category).is_some_and(|noun| {
        let [w, h, d] = noun.size;
        let least = if noun.front { 0.4 } else { 0.6 };
        noun.stands == Stands::Floor && noun.access == 0.0 && h > 0.2 && w * d < least
    }) && group(category) == Group::Floor
}

/// How much floor all around a thing is free for those who walk round it, as at a pool table; `None`: none is kept free.
pub fn played_at(category: &str) -> Option<f64> {
    const PLAYED: f64 = 1.0;
    // Who treats somebody works from all sides.
    const TREATED: f64 = 0.7;
    if ["massage table", "operating table"].iter().any(|end| category.replace('_', " ").ends_with(end)) {
        return Some(TREATED);
    }
    let noun = nouns::ending(category)?;
    (noun.stands == Stands::Floor && noun.access > PLAYED).then_some(noun.access)
}

/// Whether one lies on it to be treated.
pub fn is_treated_on(noun: &str) -> bool {
    ["treatment table", "massage table", "therapy table"].iter().any(|end| noun.ends_with(end))
}

/// Whether something asked for stands on a thing.
pub fn loaded(draft: &Draft, thing: usize) -> bool {
    let name = &draft.things[thing].name;
    draft.statements.iter().any(|s| {
        matches!(s.source, ThingOrigin::Stated(_))
            && mentions(&s.text, name)
            && ["restsOn(", "on(", "inside("].iter().any(|c| s.text.contains(c))
    })
}

/// Whether a robot arm that is asked for stands on a thing.
pub fn has_robot(draft: &Draft, thing: usize) -> bool {
    let on = |robot: &str, s: &Statement| s.text.contains("restsOn(") && mentions(&s.text, robot);
    let robots = draft.things.iter().filter(|t| are_kin("robot arm", &t.category.replace('_', " ")));
    let name = &draft.things[thing].name;
    robots.into_iter().any(|robot| draft.statements.iter().any(|s| on(&robot.name, s) && mentions(&s.text, name)))
}

/// Whether the request says where or how a thing stands.
pub fn placed(draft: &Draft, name: &str) -> bool {
    let about = |s: &&Statement| matches!(s.source, ThingOrigin::Stated(_)) && mentions(&s.text, name);
    draft.statements.iter().filter(about).any(|s| !is_path(s))
}

/// Whether all that a statement says is that a path leads to something, wherever it stands.
pub fn is_path(statement: &Statement) -> bool {
    calls(&statement.text) == ["reachable"]
}

/// The same, but for what is said of it in relation to one other thing, by the statements that count.
pub fn placed_where(draft: &Draft, name: &str, other: Option<&str>, counts: &dyn Fn(&Statement) -> bool) -> bool {
    let about = |s: &&Statement| matches!(s.source, ThingOrigin::Stated(_)) && mentions(&s.text, name) && counts(s);
    draft.statements.iter().filter(about).filter(|s| !is_path(s)).any(|s| {
        let related = other.is_some_and(|other| mentions(&s.text, other));
        // Two on both sides of a table face each other.
        let related = related || s.text.contains(&format!("facing({name}[2 * i], {name}["));
        // Free space behind a seat says nothing of where the seat is.
        let seat = draft.things.iter().any(|thing| thing.name == name && group(&thing.category) == Group::Seat);
        let is_space = seat && s.text.contains(": clear(a, behind, ");
        !related && !is_space && !s.text.contains("onFloor(")
    })
}

/// Whether two words name one kind of thing.
pub fn are_kin(noun: &str, other: &str) -> bool {
    share_kin(kin_of(noun), kin_of(other))
}

#[cfg(test)]
mod tests {
    use super::counts_as;

    #[test]
    fn what_is_asked_for_is_not_added_by_another_name() {
        for (noun, asked, same) in [
            ("coffee table", "table", true),
            ("table", "coffee table", true),
            ("coffee table", "dining table", false),
            ("floor lamp", "lamp", true),
            ("ceiling light", "lamp", true),
            ("floor lamp", "desk lamp", false),
            ("couch", "sofa", true),
            ("desk lamp", "desk", false),
            ("laptop", "computer", true),
            ("office chair", "chair", true),
            ("office chair", "swivel chair", true),
            ("office chair", "dining chair", false),
            ("chair", "reading chair", false),
            ("reading chair", "chair", true),
            ("armchair", "reading chair", true),
            ("kitchen table", "farmhouse table", true),
            ("kitchen table", "breakfast table", true),
            ("computer desk", "workstation", true),
            ("lab bench", "lab table", true),
            ("workbench", "lab table", false),
            ("tv stand", "tv", false),
            ("plant", "plant stand", false),
        ] {
            assert_eq!(counts_as(noun, asked), same, "{noun} / {asked}");
        }
    }
}
