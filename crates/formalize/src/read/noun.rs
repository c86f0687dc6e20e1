//! Noun phrases: "two low oak side tables", "each of the desks", "the back wall", "the meeting room", "it".

use super::chunk::{Dims, add_look, look_at};
use super::lexicon::{Class, Look, get, plural, singular};
use super::measure::{Measure, measure};
use super::number;
use super::token::{Kind as TokenKind, Token};
use crate::brief::{Dim, Group, Op, Place};
use crate::draft;
use ahead::*;
use amount::in_inches;
pub use amount::{add_dims, bounded};

mod ahead;
mod amount;

/// How a noun phrase begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Det {
    /// By nothing: "chairs".
    None,
    /// "a", "some".
    Indefinite,
    /// "the", "these".
    Definite,
    /// "my", "its", "the teacher's".
    Own,
    /// "each", "all", "both".
    Each,
    /// "no".
    No,
    /// By a number.
    Number,
}

/// What a noun phrase speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A thing.
    Thing,
    /// A room: an index into the kinds.
    Room,
    /// A place in a room or on a thing.
    Place(Place),
    /// Something that is no thing: "the atmosphere".
    Abstract,
    /// "it", "they", "both".
    Pronoun,
}

/// A noun phrase.
#[derive(Clone, Debug, PartialEq)]
pub struct Np {
    /// How it begins.
    pub det: Det,
    /// How many.
    pub count: Option<usize>,
    /// The number as it is written, where that is no count of things.
    pub number: Option<f64>,
    /// A plural with no number.
    pub many: bool,
    /// "several", "a few": at least three.
    pub several: bool,
    /// What it speaks of.
    pub kind: Kind,
    /// Words of the name in the singular, looks left out: "coffee", "table".
    pub words: Vec<String>,
    /// How many of the last words the tables know as one noun.
    pub last: usize,
    /// The group of the noun, if the tables know it.
    pub group: Option<Group>,
    /// Whether the tables know the noun.
    pub known: bool,
    /// Looks before the noun.
    pub look: draft::Look,
    /// Sizes before the noun.
    pub dims: Dims,
    /// Words before a place or a room: "left", "front", "north", "long".
    pub which: Vec<String>,
    /// "another", "other".
    pub other: bool,
    /// Which of several: "the first exit", "half of the desks".
    pub nth: Option<Nth>,
    /// "a row of chairs".
    pub row: bool,
    /// Whether the number is said to bind from one side, or exactly: "at least two chairs".
    pub bound: Option<Op>,
}

/// Which of several a noun phrase speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Nth {
    /// This one, from 0: "the first exit".
    At(usize),
    /// "the last exit".
    Last,
    /// As many as are counted: "two of the desks".
    Some,
    /// "half of the desks".
    Half,
    /// "every second desk".
    Every(usize),
    /// "each desk except the first".
    ButFirst,
    /// "all desks but the last".
    ButLast,
}

impl Np {
    fn new(kind: Kind) -> Self {
        Self {
            det: Det::None,
            count: None,
            number: None,
            many: false,
            several: false,
            kind,
            words: Vec::new(),
            last: 1,
            group: None,
            known: false,
            look: draft::Look::default(),
            dims: Vec::new(),
            which: Vec::new(),
            other: false,
            nth: None,
            row: false,
            bound: None,
        }
    }

    /// The noun itself: the words that the tables know as one.
    pub fn head(&self) -> String {
        self.words[self.words.len().saturating_sub(self.last)..].join(" ")
    }

    /// The whole name.
    pub fn name(&self) -> String {
        self.words.join(" ")
    }
}

/// Colours that are things where no noun follows.
const FRUIT: [&str; 7] = ["apple", "cherry", "plum", "peach", "lemon", "lime", "rose"];

/// The noun phrase that begins here and how many tokens it takes. `listed`: where a thing is expected, so that a word
/// nobody knows may be one.
pub fn noun_phrase(rest: &[Token], listed: bool) -> Option<(Np, usize)> {
    let lexicon = get();
    let text = |i: usize| rest.get(i).map_or("", |t| t.text.as_str());
    let mut used = 0;
    let mut np = Np::new(Kind::Thing);
    // How it begins.
    let pronoun = matches!(
        text(0),
        "it" | "they" | "them" | "both" | "each" | "these" | "those" | "itself" | "either" | "all" | "one"
    );
    let determiner = |w: &str| {
        lexicon.is(w, Class::Def) || lexicon.is(w, Class::Det) || lexicon.is(w, Class::Each) || lexicon.is(w, Class::No)
    };
    let mut last_det = Det::None;
    let mut article = false;
    while let Some(t) = rest.get(used).filter(|t| t.word()) {
        let w = t.text.as_str();
        if matches!(
            w,
            "each" | "every" | "all" | "both" | "any" | "either" | "neighbouring" | "neighboring" | "adjacent" | "per"
        ) && (w != "adjacent" || text(used + 1) != "to")
        {
            last_det = Det::Each;
        } else if lexicon.is(w, Class::No) && used == 0 && w != "without" {
            last_det = Det::No;
        } else if lexicon.is(w, Class::Def) {
            let own = matches!(w, "my" | "your" | "our" | "its" | "their" | "his" | "her");
            last_det = if matches!(last_det, Det::Each | Det::No) {
                last_det
            } else if own {
                Det::Own
            } else {
                Det::Definite
            };
        } else if lexicon.is(w, Class::Det) && w != "one" {
            np.other |= w == "another";
            np.several |= matches!(w, "several" | "few" | "many" | "various" | "multiple" | "numerous");
            np.many |= np.several || w == "some";
            if last_det == Det::None {
                last_det = Det::Indefinite;
            }
            article = matches!(w, "a" | "an" | "another");
        } else if w == "other" && used > 0 {
            np.other = true;
        } else if w == "half" && used == 0 && half(&rest[1..]) > 0 {
            used += half(&rest[1..]);
            np.nth = Some(Nth::Half);
            last_det = Det::Definite;
        } else if let (true, Some(nth)) = (used > 0 && np.nth.is_none(), ordinal(w))
            && last_det != Det::Indefinite
            && names_something(&rest[used + 1..])
        {
            np.nth = match (last_det, nth) {
                (Det::Each, Nth::At(n)) => Some(Nth::Every(n + 1)),
                _ => Some(nth),
            };
            if last_det == Det::Each {
                last_det = Det::Definite;
            }
        } else if let (true, Some((nth, n))) =
            (last_det == Det::Each && np.nth.is_none(), but_one(&rest[used..]).filter(|_| text(used) == "but"))
            && before_noun(&rest[used + n..])
        {
            // "all but the last desk"
            np.nth = Some(nth);
            used += n - 1;
        } else if w == "of"
            && used > 0
            && matches!(text(used - 1), "each" | "both" | "all" | "any" | "one" | "either" | "some" | "none")
            && determiner(text(used + 1))
        {
            // "each of the desks"
        } else if w == "one" && used > 0 && text(used + 1) == "of" {
            // "every one of them"
        } else {
            break;
        }
        used += 1;
    }
    // "a row of four hooks", "a set of knives", "a group of armchairs"
    let of_them = |w: &str| {
        matches!(
            w,
            "row" | "line" | "series" | "set" | "group" | "cluster" | "collection" | "number" | "bunch" | "bank"
        )
    };
    // "a stack of two books": two books.
    let heap = matches!(text(used), "stack" | "pile") && rest.get(used + 2..).and_then(number::count).is_some();
    if heap && text(used + 1) == "of" {
        np.look.features.push("stacked".to_owned());
    }
    if article && (heap || of_them(text(used))) && text(used + 1) == "of" && rest.get(used + 2).is_some_and(Token::word)
    {
        np.row = matches!(text(used), "row" | "line" | "series" | "bank");
        used += 2;
        last_det = Det::None;
        article = false;
    }
    np.det = last_det;
    let begun = used > 0;
    let owner_end = used;
    // "on its surface", "on their tops"
    if np.det == Det::Own
        && matches!(text(owner_end - 1), "its" | "their")
        && lexicon.is(text(owner_end), Class::Surface)
        && !before_noun(&rest[owner_end + 1..])
    {
        np.kind = Kind::Pronoun;
        np.words = vec![if text(owner_end - 1) == "its" { "it" } else { "them" }.to_owned()];
        return Some((np, owner_end + 1));
    }
    // "each of them", "it", "all three"
    if begun && matches!(text(used), "it" | "them") {
        np.kind = Kind::Pronoun;
        np.words = vec![text(used).to_owned()];
        return Some((np, used + 1));
    }
    if !begun && pronoun && !matches!(text(0), "all" | "these" | "those" | "each" | "one") {
        np.kind = Kind::Pronoun;
        np.words = vec![text(0).to_owned()];
        return Some((np, 1));
    }
    // How many. "a dozen", "a pair of" begin with their article.
    let from = if article
        && number::count(&rest[used - 1..])
            .is_some_and(|(_, n)| n > 1 && matches!(text(used), "dozen" | "pair" | "couple" | "trio"))
    {
        used - 1
    } else {
        used
    };
    if measure(&rest[used..]).is_none()
        && let Some((n, k)) = number::count(&rest[from..])
        && (n.fract() == 0.0 || rest.get(from + k).is_some_and(Token::word))
        && (0.0..=1e9).contains(&n)
    {
        np.number = super::counts::said(n).map(|_| n);
        np.count = Some(if n.fract() == 0.0 { n as usize } else { super::counts::whole(n) });
        used = from + k;
        if last_det == Det::None || last_det == Det::Indefinite {
            np.det = Det::Number;
        }
        // "2 x bookcase", "2 no. bookcases"
        while matches!(text(used), "x" | "×" | "nos" | "pcs") && rest.get(used + 1).is_some_and(Token::word) {
            used += 1;
        }
        // "two of the chairs", "two by"
        if text(used) == "of" && matches!(text(used + 1), "them" | "these" | "those") {
            np.kind = Kind::Pronoun;
            np.words = vec!["them".to_owned()];
            return Some((np, used + 2));
        }
        if text(used) == "of" && determiner(text(used + 1)) {
            used += 2;
            np.det = Det::Definite;
            np.nth = Some(Nth::Some);
        }
        while lexicon.is(text(used), Class::Def) {
            used += 1;
        }
    }
    let counted = np.count.is_some();
    // What stands before the noun.
    let start = used;
    let mut nouns: Vec<(String, bool)> = Vec::new(); // in the singular, whether as written it is a plural
    let mut noun_end = 0; // tokens up to the last noun
    let mut looks_end = used;
    let mut inches: Option<(f64, String)> = None;
    while let Some(t) = rest.get(used) {
        let w = t.text.as_str();
        if !t.word() {
            let adjectives =
                nouns.is_empty() && used > start && look_at(&rest[used + 1..]).is_some() && looks_end == used;
            // "a large, round table", as long as a noun comes
            if t.is(",") && adjectives && leads_to_noun(&rest[used + 1..]) {
                used += 1;
                continue;
            }
            if matches!(t.kind, TokenKind::Number(_))
                && nouns.is_empty()
                && let Some((m, n)) = measure(&rest[used..]).filter(|(m, _)| m.plain())
            {
                inches = inches.or_else(|| in_inches(&m, &rest[used..used + n]));
                add_dims(&mut np.dims, &m.values, &m.dims);
                used += n;
                looks_end = used;
                continue;
            }
            break;
        }
        if nouns.is_empty()
            && w == "and"
            && used > start
            && looks_end == used
            && look_at(&rest[used + 1..]).is_some()
            && leads_to_noun(&rest[used + 1..])
            && lexicon.noun(text(used - 1)).is_none()
        {
            used += 1;
            continue;
        }
        if matches!(w, "very" | "really" | "quite" | "slightly" | "rather" | "fairly" | "super" | "extra")
            && nouns.is_empty()
        {
            used += 1;
            continue;
        }
        // "a neatly rolled towel", "a glass top table"
        if nouns.is_empty()
            && (begun || counted || used > start || listed)
            && let Some(n) = worded_look(&rest[used..])
        {
            add_look(&mut np.look, Look::Feature, &rest[used..used + n]);
            used += n;
            looks_end = used;
            continue;
        }
        if nouns.is_empty()
            && used > owner_end.min(start)
            && let Some((m, n)) = measure(&rest[used..]).filter(|(m, _)| m.plain())
        {
            inches = inches.or_else(|| in_inches(&m, &rest[used..used + n]));
            add_dims(&mut np.dims, &m.values, &m.dims);
            used += n;
            looks_end = used;
            continue;
        }
        if t.owner {
            // "a teacher's desk": part of the name; "the desk's left side": of a thing.
            nouns.push((singular(w), false));
            used += 1;
            continue;
        }
        // "the island surface", "the table's top": that thing.
        let known = || lexicon.noun(nouns.last().map_or("", |n| n.0.as_str())).is_some();
        if matches!(last_det, Det::Definite | Det::Own)
            && !nouns.is_empty()
            && known()
            && lexicon.is(w, Class::Surface)
            && !before_noun(&rest[used + 1..])
        {
            used += 1;
            noun_end = used;
            break;
        }
        if !nouns.is_empty() && !nouns.last().is_some_and(|n| n.1) {
            let several = np.count.map_or(last_det == Det::None || !article, |n| n > 1);
            let several =
                several && (np.count.is_some() || last_det == Det::None || lexicon.verb(&rest[used..]).is_none());
            let counted = counted && np.count != Some(1);
            if tail_here(&rest[used..], several) {
                nouns.push((singular(w), plural(w)));
                used += 1;
                noun_end = used;
                continue;
            }
            // "a lamp casts light", "a vanity spans the wall": after "a", what ends so is a verb, known or not.
            let one = article && !counted;
            let acts = plural(w)
                && (one
                    || (longest_noun(&rest[used..]).is_none() || lexicon.verb(&rest[used..]).is_some())
                        && (takes_object(&rest[used + 1..])
                            || matches!(text(used + 1), "through" | "into" | "onto" | "across" | "over")));
            if acts && noun_end > 0 && !(one && longest_noun(&rest[used..]).is_some_and(|(_, n)| n > 1)) {
                break;
            }
        }
        // The longest noun of the tables that begins here.
        let mut table = longest_noun(&rest[used..]);
        // "a fern plant stands near the window": not two plant stands.
        if let Some((_, n)) = &table
            && *n > 1
            && (article || np.count == Some(1))
            && plural(text(used + n - 1))
            && lexicon.verb(&rest[used + n - 1..]).is_some()
        {
            table = longest_noun(&rest[used..used + n - 1]);
        }
        let look = look_at(&rest[used..]);
        if let Some((phrase, n)) = table
            .clone()
            .filter(|(_, n)| look.is_none_or(|(_, m)| *n > m || (*n == m && !before_noun(&rest[used + n..]))))
        {
            // "a chest of drawers" is one.
            let many = plural(text(if phrase.contains(" of ") { used } else { used + n - 1 }));
            if n == 1 && nouns.is_empty() && stops_here(&rest[used..], begun || counted || used > start || listed) {
                break;
            }
            // "the window side": by the window.
            let side = phrase == "window" && matches!(text(used + n), "side" | "front" | "wall");
            nouns.extend(phrase.split(' ').map(|p| (p.to_owned(), false)));
            if let Some(last) = nouns.last_mut() {
                last.1 = many;
            }
            used += n + usize::from(side);
            noun_end = used;
            if many && longest_noun(&rest[used..]).is_none() {
                break;
            }
            continue;
        }
        if let Some((kind, n)) = look {
            let noun_after = nouns.is_empty() || before_noun(&rest[used + n..]);
            // "a massage stone lies near the soap"
            let named = article
                && noun_end > 0
                && kind == Look::Material
                && longest_noun(&rest[used - 1..used]).is_none()
                && (lexicon.verb(&rest[used + n..]).is_some() || lexicon.relation(&rest[used + n..]).is_some());
            if named && !noun_after {
                nouns.extend(rest[used..used + n].iter().map(|t| (singular(&t.text), false)));
                used += n;
                noun_end = used;
                continue;
            }
            if !noun_after {
                break;
            }
            // "standing there", "double": only before something
            add_look(&mut np.look, kind, &rest[used..used + n]);
            used += n;
            looks_end = used;
            continue;
        }
        let room = lexicon.room(w).is_some() || lexicon.room(&singular(w)).is_some();
        // "on your left"
        if matches!(w, "left" | "right")
            && used > 0
            && text(used - 1) == "your"
            && !matches!(text(used + 1), "side" | "hand" | "wall")
        {
            np.kind = Kind::Place(Place::Side);
            np.which = vec![w.to_owned()];
            np.words = vec!["side".to_owned()];
            return Some((np, used + 1));
        }
        let place_here = place(w).filter(|_| {
            nouns.iter().all(|(n, _)| WHICH.contains(&n.as_str()))
                // "six wall panels": no place.
                && (np.count.is_none_or(|n| n <= 1) || w.ends_with('s'))
                && (begun
                    || counted
                    || used > start
                    || !np.which.is_empty()
                    // "hangs from ceiling"
                    || listed && matches!(w, "ceiling" | "wall" | "floor" | "corner" | "center" | "centre")
                    || matches!(w, "walls" | "corners" | "rows"))
        });
        if WHICH.contains(&w) && leads_to_place(&rest[used..]) {
            np.which.push(w.to_owned());
            used += 1;
            continue;
        }
        if let Some(p) = place_here
            .filter(|_| !before_noun(&rest[used + 1..]) || matches!(place(w), Some(Place::Middle | Place::Row)))
        {
            np.kind = Kind::Place(p);
            np.many = w.ends_with('s');
            np.words = vec![singular(w)];
            return Some((np, used + 1));
        }
        // "the room center"
        if let Some(n) = room_here(&rest[used..])
            && let Some(p @ (Place::Middle | Place::Corner)) = place(text(used + n))
            && nouns.is_empty()
            && !before_noun(&rest[used + n + 1..])
        {
            np.kind = Kind::Place(p);
            np.words = vec![singular(text(used + n))];
            return Some((np, used + n + 1));
        }
        // Room names of several words: "living room".
        if let Some(n) = room_here(&rest[used..]) {
            let after = longest_noun(&rest[used + n..]);
            // "a laundry hamper" is no room.
            let more = article
                && rest.get(used + n).is_some_and(|t| {
                    t.word() && !lexicon.known(&t.text) && !["s", "ed", "ing", "ly"].iter().any(|e| t.text.ends_with(e))
                });
            nouns.extend(rest[used..used + n].iter().map(|t| (singular(&t.text), false)));
            used += n;
            noun_end = used;
            if after.is_none() && !more && !before_noun(&rest[used..]) {
                break;
            }
            continue;
        }
        // "a tool wall", "six wall panels": things.
        let of_wall = np.det == Det::Indefinite && nouns.last().is_some_and(|n| lexicon.noun(&n.0).is_some())
            || np.count.is_some_and(|n| n > 1) && rest.get(used + 1).is_some_and(|t| plural(&t.text));
        if w == "wall" && of_wall {
            nouns.push((w.to_owned(), false));
            used += 1;
            noun_end = used;
            continue;
        }
        let adverb = matches!(w, "anywhere" | "everywhere" | "somewhere" | "elsewhere");
        if (lexicon.is(w, Class::Stop) && lexicon.is(w, Class::Abstract) || adverb) && !nouns.is_empty() {
            break;
        }
        // "a lamp shaped like …", "a board made …": after the noun a clause of its own begins.
        let participle = noun_end > 0
            && (w.ends_with("ed") || w.ends_with("ing"))
            && !before_noun(&rest[used + 1..])
            && (nouns.iter().any(|n| lexicon.noun(&n.0).is_some())
                || article && w.ends_with("ing") && lexicon.verb(&rest[used + 1..]).is_none());
        if participle {
            break;
        }
        let modifies = (begun || counted)
            && rest.get(used + 1).is_some_and(|n| {
                n.word() && !lexicon.known(&n.text) && !n.text.ends_with("ed") && !n.text.ends_with("ing")
            });
        // "the bookshelf lines the wall", "a fern and a lamp rest on it"
        let verbal = lexicon.relation(&rest[used..]).is_some() || lexicon.verb(&rest[used..]).is_some();
        if verbal && noun_end > 0 && lexicon.noun(nouns.last().map_or("", |n| n.0.as_str())).is_some() {
            break;
        }
        if lexicon.is(w, Class::Abstract) && !before_noun(&rest[used + 1..]) && !modifies {
            if nouns.is_empty() {
                if !(begun || counted) {
                    return None;
                }
                np.kind = Kind::Abstract;
                np.words = vec![singular(w)];
                return Some((np, used + 1));
            }
            if begun || counted {
                // "the conversation area"
                let known = noun_end > 0 && nouns.len() > 1;
                if !known {
                    // "a glass top"
                    let material = |n: &&(String, bool)| lexicon.look(&n.0) == Some(Look::Material);
                    np.look.material = np.look.material.take().or(nouns.iter().find(material).map(|n| n.0.clone()));
                    np.kind = Kind::Abstract;
                    np.words = vec![singular(w)];
                    return Some((np, used + 1));
                }
            }
            break;
        }
        let grammar = lexicon.relation(&rest[used..]).is_some()
            || lexicon.verb(&rest[used..]).is_some()
            || lexicon.is(w, Class::Stop)
            || determiner(w)
            || lexicon.is(w, Class::Pronoun)
            || lexicon.is(w, Class::Not)
            || number::small(w).is_some()
            || number::unit(w).is_some()
            || w == "with"
            || w == "and"
            || w == "or"
            || lexicon.is(w, Class::Space) && w != "floor" && !before_noun(&rest[used + 1..]);
        // "a round play rug"
        let modifier = article
            && noun_end == 0
            && lexicon.relation(&rest[used..]).is_none()
            && !["s", "ed"].iter().any(|e| w.ends_with(e))
            && lexicon.verb(&rest[used..]).is_some_and(|(_, n)| n == 1)
            && longest_noun(&rest[used + 1..]).is_some();
        let grammar = grammar && !modifier || !nouns.is_empty() && super::chunk::fixed(&rest[used..]).is_some();
        if grammar && !(lexicon.is(w, Class::Space) && before_noun(&rest[used + 1..])) {
            break;
        }
        let adverb = w.ends_with("ly") && w.len() > 4;
        if adverb {
            if nouns.is_empty() && (begun || counted || used > start) {
                used += 1;
                continue;
            }
            break;
        }
        // A word that no table has: part of a name where a noun phrase has begun or is expected.
        let context = begun || counted || listed || used > start || room || before_noun(&rest[used + 1..]);
        let verbal = nouns.is_empty() && !begun && !counted && (w.ends_with("ing") || w.ends_with("ed"));
        if !context || verbal || w.chars().count() < 2 || nouns.len() > 5 {
            break;
        }
        if nouns.last().is_some_and(|n| n.1) {
            break;
        }
        if nouns.is_empty()
            && adjective(w)
            && (before_noun(&rest[used + 1..])
                || leads_to_noun(&rest[used + 1..])
                || rest.get(used + 1).is_some_and(|t| t.word() && !lexicon.known(&t.text)))
        {
            add_look(&mut np.look, Look::Feature, &rest[used..=used]);
            used += 1;
            looks_end = used;
            continue;
        }
        // After a known noun in the singular an unknown word may go on only if more of the name follows.
        let going_on = begun || counted || plural(w) || before_noun(&rest[used + 1..]);
        if noun_end > 0 && !going_on {
            break;
        }
        nouns.push((singular(w), plural(w)));
        used += 1;
        noun_end = used;
    }
    // "a single apple"
    if noun_end == 0 && begun && used > owner_end && FRUIT.contains(&singular(text(used - 1)).as_str()) {
        let last = used - 1;
        np.look = draft::Look::default();
        if let Some((look, n)) = super::chunk::looks(&rest[start..last]).filter(|(_, n)| start + n == last) {
            let _ = n;
            np.look = look;
        }
        nouns.push((singular(text(last)), plural(text(last))));
        noun_end = used;
    }
    if noun_end == 0 {
        // "white glass", "a cane": the last look may be the noun.
        if pronoun && !begun && matches!(text(0), "these" | "those" | "each" | "all")
            || begun && np.det == Det::Each && used == owner_end
        {
            np.kind = Kind::Pronoun;
            np.words = vec![text(0).to_owned()];
            return Some((np, owner_end.max(1)));
        }
        if begun && matches!(text(owner_end), "one" | "ones" | "other" | "others")
            || np.other && used == owner_end && owner_end > 0
        {
            np.kind = Kind::Pronoun;
            np.words = vec!["other".to_owned()];
            return Some((
                np,
                if matches!(text(owner_end), "one" | "ones" | "other" | "others") { owner_end + 1 } else { owner_end },
            ));
        }
        if counted && used == start && (last_det == Det::Definite || last_det == Det::Each || np.count == Some(1)) {
            np.kind = Kind::Pronoun;
            np.words = vec!["ones".to_owned()];
            return Some((np, used));
        }
        return None;
    }
    np.words = nouns.iter().map(|n| n.0.clone()).collect();
    np.many |= nouns.last().is_some_and(|n| n.1) && np.count.is_none();
    let room = lexicon.room_ending(&np.words);
    let thing = lexicon.noun_ending(&np.words);
    match (room, thing) {
        (Some((n, _)), t) if t.is_none_or(|(m, _)| n >= m) => {
            np.kind = Kind::Room;
            np.last = n;
            np.known = true;
            // What may be either is a thing where it is not said like a room.
            np.group = t.filter(|(m, _)| *m == n).map(|t| t.1);
        }
        (_, Some((m, group))) => {
            np.last = m;
            np.group = Some(group);
            np.known = true;
        }
        _ => {
            let head = np.words.last().cloned().unwrap_or_default();
            let named = np.words.len() > 1 && lexicon.is(&head, Class::Tail);
            if lexicon.is(&head, Class::Abstract) && !named {
                np.kind = Kind::Abstract;
            }
        }
    }
    let screen = np.words.last().is_some_and(|w| matches!(w.as_str(), "tv" | "television" | "monitor" | "screen"));
    if let Some((across, said)) = inches.filter(|_| screen) {
        // The diagonal of a picture of 16 to 9.
        np.dims.retain(|(dim, _)| *dim != Dim::Length);
        np.dims.extend([(Dim::Width, across * 0.872), (Dim::Height, across * 0.49)]);
        np.look.features.push(said);
    }
    let exception = matches!(np.det, Det::Each | Det::Definite) && np.kind == Kind::Thing && np.nth.is_none();
    if let Some((nth, n)) = but_one(&rest[noun_end..]).filter(|_| exception) {
        np.nth = Some(nth);
        return Some((np, noun_end + n));
    }
    Some((np, noun_end))
}
