//! What is asked for, in words: a conversational request and a sentence, from the grammar in `data/grammar.txt`.

use super::dice::Dice;
use super::plan::{Link, Plan, PlannedThing};
use super::pools::{ThingPlace, tables};
use super::program::Stated;
use scenelang_lang::nouns::{plural, with_article};

/// So many kinds of things are named in the short version.
const NAMED: usize = 6;

#[derive(Debug, Default)]
pub(crate) struct SceneWords {
    pub request: String,
    /// The same with `_` for whatever is filled in: what of it is the grammar's.
    pub skeleton: String,
    /// The short version.
    pub sentence: String,
    /// The sentence for each relation, in the order of the relations.
    pub sentences: Vec<String>,
}

/// How often a relation is followed by a remark that asks for nothing.
const ASIDES: f64 = 0.45;

/// Words and their skeleton, as they grow.
#[derive(Default)]
struct Text {
    words: String,
    skeleton: String,
}

impl Text {
    fn sentence(&mut self, (words, skeleton): (String, String)) {
        for (all, new) in [(&mut self.words, words), (&mut self.skeleton, skeleton)] {
            if !all.is_empty() && !all.ends_with('\n') {
                all.push(' ');
            }
            all.push_str(&new);
        }
    }

    fn paragraph(&mut self) {
        self.words.push_str("\n\n");
        self.skeleton.push_str("\n\n");
    }
}

pub(crate) fn tell(dice: &mut Dice, plan: &Plan, stated: &[Stated]) -> SceneWords {
    let mut told = SceneWords::default();
    let mut text = Text::default();
    let names: Vec<String> = plan.rooms.iter().map(|room| format!("the {}", room.kind)).collect();
    let number = if names.len() == 1 { "one room" } else { "two rooms" };
    let rooms = format!("{number}, {}", list(&names));
    text.sentence(drawn(dice, "opening", false, &[("building", &with_article(plan.building)), ("rooms", &rooms)]));
    text.sentence(drawn(dice, "summary", false, &[]));
    let mut asides = tables().rule("aside").to_vec();
    dice.shuffle(&mut asides);
    for (i, room) in plan.rooms.iter().enumerate() {
        text.paragraph();
        let [width, height, depth] = room.size.map(|x| x.to_string());
        let slots = [("room", room.kind), ("width", &width), ("height", &height), ("depth", &depth)];
        text.sentence(drawn(dice, if i == 0 { "room" } else { "next" }, false, &slots));
        // What cannot be measured is said here and there among the rest.
        let attributes = room.attributes.iter().map(|(_, value, phrase)| {
            let (before, after) = phrase.split_once('_').unwrap_or((phrase, ""));
            (format!("{before}{value}{after}"), (*phrase).to_owned())
        });
        let mut attributes: Vec<(String, String)> = attributes.collect();
        let own: Vec<usize> = (0..stated.len()).filter(|s| plan.things[stated[*s].thing].room == i).collect();
        let later = attributes.split_off(attributes.len().div_ceil(2));
        attributes.into_iter().for_each(|said| text.sentence(said));
        let middle = own.len() / 2;
        let mut later = later.into_iter();
        for (n, &s) in own.iter().enumerate() {
            let said = of_relation(dice, plan, &stated[s]);
            told.sentences.push(said.0.clone());
            text.sentence(said);
            if dice.chance(ASIDES)
                && let Some(aside) = asides.pop()
            {
                text.sentence((aside.to_owned(), aside.to_owned()));
            }
            if n >= middle
                && let Some(said) = later.next()
            {
                text.sentence(said);
            }
        }
        later.for_each(|said| text.sentence(said));
        let links = plan.links.iter().filter(|link| link.between.1.map_or(link.between.0, |to| to) == i);
        links.for_each(|link| text.sentence(of_link(dice, plan, link)));
    }
    text.paragraph();
    text.sentence(drawn(dice, "closing", false, &[]));
    told.request = text.words + "\n";
    told.skeleton = text.skeleton;
    told.sentence = short(dice, plan);
    told
}

/// A rule with its slots filled in, and its skeleton.
fn drawn(dice: &mut Dice, rule: &str, many: bool, slots: &[(&str, &str)]) -> (String, String) {
    let template = dice.one(tables().rule(rule));
    (
        capital(&filled(template, many, |slot| lookup(slots, slot))),
        capital(&filled(template, false, |_| "_".to_owned())),
    )
}

fn lookup(slots: &[(&str, &str)], slot: &str) -> String {
    slots.iter().find(|(name, _)| *name == slot).map_or_else(String::new, |(_, value)| (*value).to_owned())
}

/// A template with something for each `{slot}`, and one of each `{one|many}`.
fn filled(template: &str, many: bool, of: impl Fn(&str) -> String) -> String {
    let mut out = String::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('{') {
        let (slot, after) = after.split_once('}').unwrap_or((after, ""));
        out.push_str(before);
        match slot.split_once('|') {
            Some((one, several)) => out.push_str(if many { several } else { one }),
            None => out.push_str(&of(slot)),
        }
        rest = after;
    }
    out + rest
}

fn of_relation(dice: &mut Dice, plan: &Plan, stated: &Stated) -> (String, String) {
    let thing = &plan.things[stated.thing];
    let distance = if stated.distance == 0.0 { String::new() } else { length(stated.distance) };
    if thing.place.rule() != stated.rule {
        let other = stated.other.map_or("", |other| plan.things[other].noun);
        let plural = plural(thing.noun);
        // "Keep 60 cm free in front of each of the wardrobes": there may be several.
        let named = if thing.count > 1 { format!("each {}", thing.noun) } else { format!("the {}", thing.noun) };
        let slots = [("thing", named.as_str()), ("other", other), ("things", &plural), ("distance", &distance)];
        let template =
            dice.one(tables().rule(stated.rule)).replace("the {thing}", "{thing}").replace("The {thing}", "{thing}");
        let words = capital(&filled(&template, false, |slot| lookup(&slots, slot)));
        return (words, capital(&filled(&template, false, |_| "_".to_owned())));
    }
    let (count, others) = shares(plan, thing, stated.other);
    let things = several(thing, count);
    drawn(dice, stated.rule, count > 1, &[("things", &things), ("others", &others)])
}

/// Of how many things a sentence speaks, and how it calls those that their place refers to.
fn shares(plan: &Plan, thing: &PlannedThing, other: Option<usize>) -> (u32, String) {
    let Some(other) = other.map(|other| &plan.things[other]) else { return (thing.count, String::new()) };
    let others = plural(other.noun);
    match (thing.count, other.count) {
        (count, 1) => (count, format!("the {}", other.noun)),
        (a, b) if a == b => (1, format!("each {}", other.noun)),
        (1, b) => (1, format!("one of the {} {others}", word(b))),
        (a, b) if a < b => (1, format!("each of {} of the {} {others}", word(a), word(b))),
        (a, b) => (a, format!("the {} {others}", word(b))),
    }
}

/// "five white steel filing cabinets with slim legs", or "a filing cabinet".
fn several(thing: &PlannedThing, count: u32) -> String {
    let (before, after) = (thing.look.before(), thing.look.after());
    match count {
        1 => with_article(&format!("{before}{}{after}", thing.noun)),
        _ => format!("{} {before}{}{after}", word(count), plural(thing.noun)),
    }
}

fn of_link(dice: &mut Dice, plan: &Plan, link: &Link) -> (String, String) {
    let described = with_article(&format!("{}{}{}", link.look.before(), link.noun, link.look.after()));
    let (from, to) = link.between;
    let other = to.map_or("", |to| plan.rooms[to].kind);
    let rule = match (link.noun, to) {
        ("door", Some(_)) => "between",
        ("door", None) => "entrance",
        _ => "window",
    };
    let slots =
        [("door", described.as_str()), ("window", &described), ("room", plan.rooms[from].kind), ("other", other)];
    drawn(dice, rule, false, &slots)
}

/// The short version: the rooms, and the first things that stand by themselves.
fn short(dice: &mut Dice, plan: &Plan) -> String {
    let described = |room: &super::plan::PlannedRoom| {
        let style =
            room.attributes.iter().find(|(what, ..)| matches!(*what, "style" | "mood")).map(|(_, value, _)| *value);
        with_article(&format!("{}{}", style.map_or_else(String::new, |s| format!("{s} ")), room.kind))
    };
    let rooms: Vec<String> = plan.rooms.iter().map(described).collect();
    let mut heads: Vec<&PlannedThing> = plan.things.iter().filter(|t| !matches!(t.place, ThingPlace::On(_))).collect();
    dice.shuffle(&mut heads);
    let things: Vec<String> = heads.iter().take(NAMED).map(|t| plain(t)).collect();
    let building = with_article(plan.building);
    let slots = [
        ("rooms", list(&rooms)),
        ("building", building.clone()),
        ("Building", capital(&building)),
        ("list", list(&things)),
    ];
    let slots: Vec<(&str, &str)> = slots.iter().map(|(name, value)| (*name, value.as_str())).collect();
    drawn(dice, "short", false, &slots).0
}

fn plain(thing: &PlannedThing) -> String {
    match thing.count {
        1 => with_article(&format!("{}{}", thing.look.before(), thing.noun)),
        n => format!("{} {}", word(n), plural(thing.noun)),
    }
}

/// "a, b and c".
fn list(all: &[String]) -> String {
    match all {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

fn word(n: u32) -> String {
    let words = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
    words.get(n as usize).map_or_else(|| n.to_string(), |w| (*w).to_owned())
}

/// "60 cm", "1.4 m".
fn length(metres: f64) -> String {
    if metres < 1.0 { format!("{:.0} cm", metres * 100.0) } else { format!("{metres:.1} m") }
}

fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn english() {
        for (one, many) in [
            ("wall shelf", "wall shelves"),
            ("bench", "benches"),
            ("tv", "tvs"),
            ("pastry", "pastries"),
            ("tray", "trays"),
        ] {
            assert_eq!(plural(one), many);
        }
        assert_eq!(with_article("umbrella stand") + &with_article("utility sink"), "an umbrella standa utility sink");
        assert_eq!(list(&["a".into(), "b".into(), "c".into()]), "a, b and c");
        assert_eq!([length(0.6), length(1.4)], ["60 cm", "1.4 m"]);
    }

    #[test]
    fn slots_and_numbers() {
        let of = |slot: &str| format!("<{slot}>");
        assert_eq!(filled("{things} {stands|stand} there", true, of), "<things> stand there");
        assert_eq!(filled("{things} {stands|stand} there", false, of), "<things> stands there");
        assert_eq!(filled("no slots", false, of), "no slots");
    }

    /// Each rule that is asked for is there, with several alternatives, and asks for nothing that is not filled in.
    #[test]
    fn the_grammar_is_complete() {
        let slots = |rule: &str| -> &[&str] {
            match rule {
                "opening" => &["building", "rooms"],
                "room" | "next" => &["room", "width", "height", "depth"],
                "entrance" => &["door", "room"],
                "between" => &["door", "room", "other"],
                "window" => &["window", "room"],
                "closing" | "summary" | "aside" => &[],
                "short" => &["Building", "building", "rooms", "list"],
                "far" | "close" => &["thing", "other", "distance"],
                "facing" | "left" | "right" => &["thing", "other"],
                "clear" => &["thing", "distance"],
                "apart" => &["things", "distance"],
                "wall" | "corner" | "middle" | "floor" | "row" | "hung" | "ceiling" => &["things"],
                "on" | "at" | "around" | "beside" | "near" | "before" | "over" => &["things", "others"],
                _ => panic!("nobody asks for the rule {rule}"),
            }
        };
        assert_eq!(tables().grammar.len(), 31);
        for (rule, alternatives) in &tables().grammar {
            assert!(alternatives.len() >= 3, "{rule}");
            for line in alternatives {
                let asked = line.split('{').skip(1).filter_map(|part| part.split('}').next());
                for slot in asked.filter(|slot| !slot.contains('|')) {
                    assert!(slots(rule).contains(&slot), "{rule}: {{{slot}}}");
                }
            }
        }
    }
}
