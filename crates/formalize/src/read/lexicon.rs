//! The words the reader knows, from the tables in `data/`.

use super::token::Token;
use crate::brief::{Group, Rel};
use scenelang_lang::nouns::Stands;
use scenelang_lang::roles::role_of;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Words for materials that are also shades of a colour.
pub(crate) const MATERIALS_AND_SHADES: [&str; 3] = ["brick", "slate", "steel"];

/// A word or words for how a thing looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LookWord {
    Color,
    /// What may stand before a colour: "dark".
    Shade,
    /// What a thing is made of.
    Material,
    /// Anything else.
    Feature,
}

/// What a verb does for a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verb {
    Be,
    Have,
    Carry,
    Face,
    Hang,
    Flank,
    Surround,
    Keep,
    Lead,
    Light,
    Cover,
    Block,
}

/// Classes of words of the grammar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    Det,
    Def,
    Each,
    No,
    Pronoun,
    Soft,
    Not,
    Space,
    Abstract,
    Stop,
    Holder,
    Portion,
    Tail,
    Paired,
    Surface,
    Which,
    Person,
    /// Nouns of the library that are other words as well.
    Either,
}

#[derive(Debug)]
pub struct RoomKind {
    /// "meeting room".
    pub name: &'static str,
    /// Said of buildings and of rooms in general.
    pub loose: bool,
    /// Usual width, depth, height.
    pub size: [f64; 3],
}

/// All tables.
pub struct Lexicon {
    nouns: BTreeMap<&'static str, Group>,
    looks: BTreeMap<&'static str, LookWord>,
    relations: BTreeMap<&'static str, Rel>,
    verbs: BTreeMap<&'static str, Verb>,
    words: BTreeMap<&'static str, Vec<Class>>,
    synonyms: Vec<Vec<&'static str>>,
    rooms: BTreeMap<&'static str, usize>,
    /// All kinds of rooms.
    pub kinds: Vec<RoomKind>,
    parts: BTreeMap<&'static str, ()>,
}

/// The longest phrase of the tables, in words.
const LONGEST: usize = 6;

/// The tables, read once.
pub fn get() -> &'static Lexicon {
    static TABLES: OnceLock<Lexicon> = OnceLock::new();
    TABLES.get_or_init(Lexicon::new)
}

/// Lines `key: item, item`, goes on over indented lines; `#` begins a comment.
pub(super) fn table(text: &'static str) -> Vec<(&'static str, Vec<&'static str>)> {
    let mut out: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in text.lines().filter(|l| !l.starts_with('#') && !l.trim().is_empty()) {
        let items = match line.split_once(": ").filter(|_| !line.starts_with(' ')) {
            Some((key, items)) => {
                out.push((key, Vec::new()));
                items
            }
            None => line,
        };
        if let Some((_, list)) = out.last_mut() {
            list.extend(items.split(',').map(str::trim).filter(|i| !i.is_empty()));
        }
    }
    out
}

fn keyed<T: Copy>(text: &'static str, keys: &[(&str, T)]) -> BTreeMap<&'static str, T> {
    let mut out = BTreeMap::new();
    for (key, items) in table(text) {
        if let Some((_, value)) = keys.iter().find(|(k, _)| *k == key) {
            for item in items {
                out.entry(item).or_insert(*value);
            }
        }
    }
    out
}

/// The nouns of the library of the language, with how they are in rooms.
fn of_library() -> impl Iterator<Item = (&'static str, Group)> {
    static NAMES: OnceLock<Vec<String>> = OnceLock::new();
    let nouns = scenelang_lang::nouns::all();
    let names = NAMES.get_or_init(|| nouns.iter().map(|noun| noun.name.replace('_', " ")).collect());
    nouns.iter().zip(names).filter_map(|(noun, name)| {
        let group = match (role_of(name), noun.stands) {
            (_, Stands::Opening) => return None,
            ("seat", _) => Group::Seat,
            ("bed", _) => Group::Bed,
            ("table" | "desk" | "counter", _) => Group::Table,
            ("storage", _) => Group::Storage,
            (_, Stands::Floor | Stands::Back) => Group::Floor,
            (_, Stands::Wall) => Group::Wall,
            (_, Stands::Ceiling) => Group::Ceiling,
            (_, Stands::Top | Stands::Inside) => Group::Top,
            (_, Stands::Soft) => Group::Soft,
            (_, Stands::Flat) => Group::Flat,
        };
        Some((name.as_str(), group))
    })
}

/// What the groups are called in `nouns.txt`.
const GROUPS: [(&str, Group); 14] = [
    ("seat", Group::Seat),
    ("table", Group::Table),
    ("storage", Group::Storage),
    ("bed", Group::Bed),
    ("floor", Group::Floor),
    ("wall", Group::Wall),
    ("ceiling", Group::Ceiling),
    ("top", Group::Top),
    ("screen", Group::Screen),
    ("flat", Group::Flat),
    ("soft", Group::Soft),
    ("drape", Group::Drape),
    ("door", Group::Door),
    ("window", Group::Window),
];

/// What the kinds of looks are called in `looks.txt`.
const LOOKS: [(&str, LookWord); 5] = [
    ("color", LookWord::Color),
    ("material", LookWord::Material),
    ("joined", LookWord::Material),
    ("feature", LookWord::Feature),
    ("shade", LookWord::Shade),
];

/// What the relations are called in `relations.txt`.
const RELATIONS: [(&str, Rel); 31] = [
    ("on", Rel::On),
    ("under", Rel::Under),
    ("above", Rel::Above),
    ("beside", Rel::Beside),
    ("near", Rel::Near),
    ("leftOf", Rel::LeftOf),
    ("rightOf", Rel::RightOf),
    ("inFrontOf", Rel::InFrontOf),
    ("behind", Rel::Behind),
    ("between", Rel::Between),
    ("around", Rel::Around),
    ("facing", Rel::Facing),
    ("opposite", Rel::Opposite),
    ("against", Rel::Against),
    ("along", Rel::Along),
    ("in", Rel::In),
    ("at", Rel::At),
    ("mounted", Rel::Mounted),
    ("hang", Rel::Hang),
    ("far", Rel::Far),
    ("parallel", Rel::Parallel),
    ("perpendicular", Rel::Perpendicular),
    ("aligned", Rel::Aligned),
    ("visible", Rel::Visible),
    ("reachable", Rel::Reachable),
    ("backTo", Rel::BackTo),
    ("sameWall", Rel::SameWall),
    ("from", Rel::From),
    ("of", Rel::Of),
    ("to", Rel::To),
    ("than", Rel::Than),
];

/// The relation of this name in the tables.
pub fn relation_called(name: &str) -> Option<Rel> {
    RELATIONS.iter().find(|(key, _)| *key == name).map(|(_, rel)| *rel)
}

/// What the verbs are called in `verbs.txt`.
const VERBS: [(&str, Verb); 12] = [
    ("have", Verb::Have),
    ("carry", Verb::Carry),
    ("face", Verb::Face),
    ("hang", Verb::Hang),
    ("flank", Verb::Flank),
    ("surround", Verb::Surround),
    ("keep", Verb::Keep),
    ("lead", Verb::Lead),
    ("light", Verb::Light),
    ("cover", Verb::Cover),
    ("block", Verb::Block),
    ("be", Verb::Be),
];

/// What the classes of words are called in `words.txt`.
const CLASSES: [(&str, Class); 18] = [
    ("det", Class::Det),
    ("def", Class::Def),
    ("each", Class::Each),
    ("no", Class::No),
    ("pronoun", Class::Pronoun),
    ("soft", Class::Soft),
    ("not", Class::Not),
    ("space", Class::Space),
    ("abstract", Class::Abstract),
    ("stop", Class::Stop),
    ("holder", Class::Holder),
    ("portion", Class::Portion),
    ("tail", Class::Tail),
    ("paired", Class::Paired),
    ("surface", Class::Surface),
    ("which", Class::Which),
    ("person", Class::Person),
    ("either", Class::Either),
];

impl Lexicon {
    fn new() -> Self {
        let mut words: BTreeMap<&str, Vec<Class>> = BTreeMap::new();
        for (key, items) in table(include_str!("../../data/words.txt")) {
            if let Some((_, class)) = CLASSES.iter().find(|(k, _)| *k == key) {
                for item in items {
                    words.entry(item).or_default().push(*class);
                }
            }
        }
        let (rooms, kinds) = rooms();
        let mut nouns = keyed(include_str!("../../data/nouns.txt"), &GROUPS);
        let own: Vec<&str> = nouns.keys().copied().collect();
        for (name, group) in of_library() {
            let last = name.rsplit(' ').next().unwrap_or(name);
            // What ends in a noun of the reader is read by that, unless it has another place ("a grab rail"); a room is no thing.
            let hangs = matches!(group, Group::Wall | Group::Ceiling) && nouns.get(last) == Some(&Group::Floor);
            // "Two umbrella stands": no umbrella that stands.
            let front = name.rsplit_once(' ').map_or("", |(front, _)| front);
            let is_either = |name: &str| words.get(name).is_some_and(|classes| classes.contains(&Class::Either));
            let is_new = own.binary_search(&front).is_err() && scenelang_lang::nouns::noun(front).is_some();
            let hides = is_new && !is_either(front);
            let is_read = own.binary_search(&last).is_ok() && !hangs && !hides || rooms.contains_key(name);
            if !is_read && !is_either(name) {
                nouns.entry(name).or_insert(group);
            }
        }
        Self {
            nouns,
            looks: keyed(include_str!("../../data/looks.txt"), &LOOKS),
            relations: keyed(include_str!("../../data/relations.txt"), &RELATIONS),
            verbs: keyed(include_str!("../../data/verbs.txt"), &VERBS),
            words,
            synonyms: lines(include_str!("../../data/synonyms.txt")),
            rooms,
            kinds,
            parts: lines(include_str!("../../data/parts.txt")).into_iter().flatten().map(|p| (p, ())).collect(),
        }
    }

    /// The group of a noun in the singular.
    pub fn noun(&self, phrase: &str) -> Option<Group> {
        self.nouns.get(phrase).copied()
    }

    /// The longest noun that ends a phrase of words in the singular.
    pub fn noun_ending(&self, words: &[String]) -> Option<(usize, Group)> {
        let most = words.len().min(LONGEST);
        (1..=most).rev().find_map(|n| self.noun(&words[words.len() - n..].join(" ")).map(|g| (n, g)))
    }

    /// A word for the looks of a thing.
    pub fn look(&self, phrase: &str) -> Option<LookWord> {
        self.looks.get(phrase).copied()
    }

    /// Whether a word says how a thing looks.
    pub fn is_look(&self, word: &str) -> bool {
        self.looks.contains_key(word)
    }

    /// The longest relation that begins here, and how many tokens it takes.
    pub fn relation(&self, tokens: &[Token]) -> Option<(Rel, usize)> {
        longest(&self.relations, tokens)
    }

    /// The longest verb that begins here, and how many tokens it takes.
    pub fn verb(&self, tokens: &[Token]) -> Option<(Verb, usize)> {
        // "a desk and display cases"
        let names = |second: &Token| {
            let phrase = format!("{} {}", tokens[0].text, singular(&second.text));
            tokens[0].is("display") && second.word() && self.nouns.contains_key(phrase.as_str())
        };
        longest(&self.verbs, tokens).filter(|_| !tokens.get(1).is_some_and(names))
    }

    /// Whether a phrase that begins here softens what is asked, and how many tokens it takes.
    pub fn soft(&self, tokens: &[Token]) -> Option<usize> {
        longest_key(tokens, |k| self.is(k, Class::Soft))
    }

    /// Whether a word is of a class.
    pub fn is(&self, word: &str, class: Class) -> bool {
        self.words.get(word).is_some_and(|c| c.contains(&class))
    }

    /// Whether a word is in any table.
    pub fn known(&self, word: &str) -> bool {
        let grammar = |c: &Class| *c < Class::Holder;
        self.words.get(word).is_some_and(|classes| classes.iter().any(grammar))
            || self.looks.contains_key(word)
            || self.relations.contains_key(word)
            || self.verbs.contains_key(word)
            || self.nouns.contains_key(word)
            || self.nouns.contains_key(singular(word).as_str())
            || self.rooms.contains_key(word)
            || super::number::unit(word).is_some()
            || super::number::small(word).is_some()
    }

    /// The kind of room that a phrase in the singular names.
    pub fn room(&self, phrase: &str) -> Option<&RoomKind> {
        // "newsroom", "mudroom": what ends so is one.
        let own =
            || phrase.ends_with("room") && phrase.len() > 6 && !phrase.contains(' ') && !phrase.ends_with("mushroom");
        let found = self.rooms.get(phrase).or_else(|| if own() { self.rooms.get("stock room") } else { None });
        found.map(|i| &self.kinds[*i])
    }

    /// The longest name of a room that ends a phrase, and its words.
    pub fn room_ending(&self, words: &[String]) -> Option<(usize, &RoomKind)> {
        let most = words.len().min(LONGEST);
        (1..=most).rev().find_map(|n| self.room(&words[words.len() - n..].join(" ")).map(|k| (n, k)))
    }

    /// Whether a noun names a part of a thing.
    pub fn part(&self, noun: &str) -> bool {
        self.parts.contains_key(noun)
    }

    /// Whether two nouns may name one thing.
    pub fn alike(&self, a: &str, b: &str) -> bool {
        a == b || self.synonyms.iter().any(|line| line.contains(&a) && line.contains(&b))
    }
}

fn longest<T: Copy>(map: &BTreeMap<&str, T>, tokens: &[Token]) -> Option<(T, usize)> {
    let used = longest_key(tokens, |k| map.contains_key(k))?;
    map.get(key(&tokens[..used]).as_str()).map(|v| (*v, used))
}

fn longest_key(tokens: &[Token], known: impl Fn(&str) -> bool) -> Option<usize> {
    let most = tokens.iter().take(LONGEST).take_while(|t| t.word()).count();
    (1..=most).rev().find(|n| known(&key(&tokens[..*n])))
}

fn key(tokens: &[Token]) -> String {
    tokens.iter().map(|t| t.text.as_str()).collect::<Vec<_>>().join(" ")
}

fn lines(text: &'static str) -> Vec<Vec<&'static str>> {
    let lines = text.lines().filter(|l| !l.starts_with('#') && !l.is_empty());
    lines.map(|l| l.split(',').map(str::trim).collect()).collect()
}

fn rooms() -> (BTreeMap<&'static str, usize>, Vec<RoomKind>) {
    let mut names = BTreeMap::new();
    let mut kinds = Vec::new();
    for line in include_str!("../../data/rooms.txt").lines().filter(|l| !l.starts_with('#')) {
        let mut columns = line.split('|').map(str::trim);
        let (name, others) = (columns.next().unwrap_or(""), columns.next().unwrap_or(""));
        let mut size = columns.next().unwrap_or("").split(" x ").map(|n| n.trim().parse().unwrap_or(4.0));
        let mut next = || size.next().unwrap_or(4.0);
        let size = [next(), next(), next()];
        let (name, loose) = name.strip_suffix('*').map_or((name, false), |n| (n, true));
        for name in std::iter::once(name).chain(others.split(',').map(str::trim)) {
            names.entry(name).or_insert(kinds.len());
        }
        kinds.push(RoomKind { name, loose, size });
    }
    // Names of several words that only the table of inventories has, such as "data center": a single one may be a thing, too.
    for kind in crate::furnish::kinds::all() {
        let several = kind.also.iter().copied().chain([kind.name]).filter(|name| name.contains(' '));
        let new: Vec<&str> = several.filter(|name| !names.contains_key(name)).collect();
        let at = names.get(kind.name).copied().unwrap_or(kinds.len());
        if at == kinds.len() && !new.is_empty() {
            let [w, h, d] = kind.size;
            kinds.push(RoomKind { name: kind.name, loose: false, size: [w, d, h] });
        }
        names.extend(new.into_iter().map(|name| (name, at)));
    }
    (names, kinds)
}

/// A noun in the singular, as far as its end tells.
pub fn singular(word: &str) -> String {
    const ODD: [(&str, &str); 12] = [
        ("shelves", "shelf"),
        ("knives", "knife"),
        ("leaves", "leaf"),
        ("people", "person"),
        ("children", "child"),
        ("feet", "foot"),
        ("mice", "mouse"),
        ("loaves", "loaf"),
        ("cacti", "cactus"),
        ("bookshelves", "bookshelf"),
        ("scarves", "scarf"),
        ("men", "man"),
    ];
    const SAME: [&str; 32] = [
        "clothes",
        "scissors",
        "tongs",
        "pliers",
        "binoculars",
        "goggles",
        "tweezers",
        "trousers",
        "jeans",
        "glass",
        "canvas",
        "cactus",
        "ficus",
        "stairs",
        "blinds",
        "chess",
        "cutlery",
        "headphones",
        "lens",
        "tapas",
        "bus",
        "billiards",
        "series",
        "stainless",
        "compass",
        "mattress",
        "chaise",
        "tennis",
        "lotus",
        "hibiscus",
        "gas",
        "bias",
    ];
    if SAME.contains(&word) || word.len() < 4 && word != "tvs" && word != "pcs" {
        return word.to_owned();
    }
    if let Some((_, one)) = ODD.iter().find(|(many, _)| *many == word) {
        return (*one).to_owned();
    }
    if let Some(stem) = word.strip_suffix("shelves") {
        return format!("{stem}shelf");
    }
    if word.ends_with("oes") && !["shoes", "toes", "hoes", "canoes"].contains(&word) {
        return word[..word.len() - 2].to_owned();
    }
    for (end, one) in [("ies", "y"), ("sses", "ss"), ("shes", "sh"), ("ches", "ch"), ("xes", "x"), ("sses", "ss")] {
        if let Some(stem) = word.strip_suffix(end).filter(|s| s.len() > 1) {
            return format!("{stem}{one}");
        }
    }
    match word.strip_suffix('s') {
        Some(stem) if !stem.ends_with(['s', 'u', 'i']) || stem == "menu" => stem.to_owned(),
        _ => word.to_owned(),
    }
}

/// Whether a word is a plural by its end.
pub fn plural(word: &str) -> bool {
    singular(word) != word
}
