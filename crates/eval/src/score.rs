//! How much of the ground truth of a request a program says.
//!
//! First things are told from one another. A name of the program (an array is one name) and a name of the ground truth
//! can be the same thing if a word of the one's name or category is a word of the other's name; they are paired one to
//! one, as many as possible, and among the ways to do that the one in which names, numbers, rooms and looks agree most.
//! Rooms are paired in the same way, by name and kind; one that is left on each side is the same one.
//!
//! | score | share of … | that … |
//! |---|---|---|
//! | object precision | the names of the program | are paired |
//! | object recall | the names of the ground truth, forbidden ones apart | are paired |
//! | counts | the names with a stated number | are paired and have that number; a forbidden one: are in no unpaired name |
//! | texts | the stated colours and materials | have all their words in colour, material, features, category or name of the pair |
//! | relations, mentioned | the relations | have an `assert` or `prefer` that mentions subject and object |
//! | relations, named | the relations | have one that also calls the predicate of that name, or denies it where that is asked |
//! | numbers | the measures | have a constraint, assignments of places and sizes included, that mentions one of the things and has a constant within 1 % of the value |
//! | connections | the ways between two rooms of the ground truth | have a door or window that connects these two |
//! | wrong | the statements that say to come from the request | contradict the ground truth (`wrong.rs`) |
//! | weakened | the relations that are named | are named by no `assert` |
//!
//! What a program that does not compile says is nothing: every share of it is 0.

use crate::expect::{Expectation, ExpectedThing};
use crate::pairing::pair;
use crate::told::{Named, ProgramOutline, Statement};
use crate::words::{Called, carried};
use crate::wrong::Truth;
use scenelang_lang::program::Program;
use scenelang_lang::{Options, compile_text};
use serde_json::{Value, json};
use std::path::Path;

/// So many of so many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// How many do.
    pub part: usize,
    /// How many there are.
    pub whole: usize,
}

impl Share {
    /// How many of the items do.
    pub(crate) fn of<T>(items: impl IntoIterator<Item = T>, mut does: impl FnMut(T) -> bool) -> Self {
        let mut share = Self::default();
        for item in items {
            share.whole += 1;
            share.part += usize::from(does(item));
        }
        share
    }
    /// As a number from 0 to 1; `None` of nothing.
    pub fn value(self) -> Option<f64> {
        (self.whole > 0).then(|| self.part as f64 / self.whole as f64)
    }
}

/// The scores of a program for one request.
#[derive(Clone, Debug, Default)]
pub struct Score {
    /// Of the things in the program, those that were asked for.
    pub precision: Share,
    /// Of the things asked for, those in the program.
    pub recall: Share,
    /// Of the stated numbers of things, those that are right.
    pub counts: Share,
    /// Of the stated colours and materials, those that are carried.
    pub texts: Share,
    /// Of the relations, those with a statement about both sides.
    pub mentioned: Share,
    /// Of the relations, those stated by the predicate of that name.
    pub named: Share,
    /// Of the measures, those that a constraint has.
    pub numbers: Share,
    /// Of the ways between two rooms, those that a door or a window is said to be.
    pub connections: Share,
    /// Of the statements that say to come from the request, those that contradict the ground truth.
    pub wrong: Share,
    /// Of the relations that are said, those that are only preferred.
    pub weakened: Share,
    /// What was missed, or is there unasked: a line each.
    pub misses: Vec<String>,
}

impl Score {
    /// The shares by name, in the order of tables.
    pub fn shares(&self) -> [(&'static str, Share); 7] {
        [
            ("precision", self.precision),
            ("recall", self.recall),
            ("counts", self.counts),
            ("texts", self.texts),
            ("mentioned", self.mentioned),
            ("named", self.named),
            ("numbers", self.numbers),
        ]
    }

    /// The shares that `shares` leaves out, by name: ways between rooms, and two of which less is better.
    pub fn faults(&self) -> [(&'static str, Share); 3] {
        [("connections", self.connections), ("wrong", self.wrong), ("weakened", self.weakened)]
    }

    /// The shares as `[part, whole]`, and the misses.
    pub fn json(&self) -> Value {
        let pair = |share: Share| json!([share.part, share.whole]);
        json!({
            "objects": { "precision": pair(self.precision), "recall": pair(self.recall), "counts": pair(self.counts) },
            "texts": pair(self.texts),
            "relations": { "mentioned": pair(self.mentioned), "named": pair(self.named) },
            "numbers": pair(self.numbers),
            "connections": pair(self.connections),
            "wrong": pair(self.wrong),
            "weakened": pair(self.weakened),
            "misses": self.misses,
        })
    }
}

/// Compiles a program and scores it. The program comes back where it compiles.
pub fn score(expect: &Expectation, text: &str) -> (Score, Option<Program>) {
    let compiled = compile_text("request.scene", Path::new("request.scene"), text, Options::default());
    let told =
        compiled.program.as_ref().map_or_else(ProgramOutline::default, |p| ProgramOutline::new(p, compiled.main, text));
    (Scorer::new(expect, &told).score(), compiled.program)
}

/// What a name of the ground truth stands for in the program.
#[derive(Clone, Copy, PartialEq)]
enum Referent {
    Thing(usize),
    Region(usize),
}

struct Scorer<'a> {
    expect: &'a Expectation,
    told: &'a ProgramOutline,
    /// Of each room of the ground truth, the region.
    rooms: Vec<Option<usize>>,
    /// Of each object of the ground truth, the thing of the program; forbidden ones have none.
    things: Vec<Option<usize>>,
}

/// What each common word is worth against all other agreement.
const SAME: i64 = 1000;

impl<'a> Scorer<'a> {
    fn new(expect: &'a Expectation, told: &'a ProgramOutline) -> Self {
        let rooms = rooms(expect, told);
        let weight = |thing: &ExpectedThing, named: &Named| {
            let called = Called::by([thing.name.as_str()]);
            if thing.forbidden() || !called.overlaps(&named.called) {
                return 0;
            }
            let room = expect.rooms.iter().position(|r| r.name == thing.room).and_then(|r| rooms[r]);
            let in_room = room.is_some_and(|r| named.regions.contains(&r));
            let counted = thing.count.is_some_and(|n| n as usize == named.count);
            let looks = said(thing).filter(|text| carries(named, text)).count() as i64;
            SAME + called.likeness(&named.called) + 40 * i64::from(in_room) + 30 * i64::from(counted) + 20 * looks
        };
        let weights: Vec<Vec<i64>> =
            expect.objects.iter().map(|thing| told.things.iter().map(|named| weight(thing, named)).collect()).collect();
        let things = pair(&weights);
        Self { expect, told, rooms, things }
    }

    fn score(&self) -> Score {
        let mut misses = Vec::new();
        let mut missed = |is: bool, what: &dyn Fn() -> String| {
            if !is {
                misses.push(what());
            }
            is
        };
        let asked = || self.expect.objects.iter().zip(&self.things);
        let recall = Share::of(asked().filter(|(o, _)| !o.forbidden()), |(thing, named)| {
            missed(named.is_some(), &|| format!("no {}", thing.name))
        });
        let precision = Share::of(0..self.told.things.len(), |named| {
            missed(self.things.contains(&Some(named)), &|| format!("unasked: {}", self.told.things[named].name))
        });
        let counts =
            Share::of(asked().filter_map(|(o, n)| Some((o, n, o.count? as usize))), |(thing, named, count)| {
                let there = named.map_or(0, |n| self.told.things[n].count);
                let is = if count == 0 { !self.forbidden_is_there(thing) } else { there == count };
                missed(is || (count > 0 && there == 0), &|| match count {
                    0 => format!("forbidden: {}", thing.name),
                    _ => format!("{there} {}, not {count}", thing.name),
                });
                is
            });
        let texts = Share::of(asked().flat_map(|(o, n)| said(o).map(move |t| (o, n, t))), |(thing, named, text)| {
            let is = named.is_some_and(|n| carries(&self.told.things[n], text));
            missed(is || named.is_none(), &|| format!("{} is not {text}", thing.name));
            is
        });
        let mentioned = Share::of(&self.expect.relations, |relation| {
            let say = || format!("no statement: {}", wording(relation));
            missed(self.relation(relation, |_| true), &say)
        });
        let named = Share::of(&self.expect.relations, |relation| {
            let is = self.relation(relation, |statement| calls(statement, &relation.relation));
            let say = || format!("said otherwise: {}", wording(relation));
            missed(is || !self.relation(relation, |_| true), &say);
            is
        });
        let numbers = Share::of(&self.expect.numeric, |number| {
            let value = number.metres();
            let things: Vec<Referent> = number.between.iter().filter_map(|n| self.referent(n)).collect();
            let is = self.told.statements.iter().any(|s| {
                things.iter().any(|t| mentions(s, *t))
                    && s.written.constants.iter().any(|c| (c.abs() - value.abs()).abs() <= 0.01 * value.abs())
            });
            missed(is, &|| format!("no number: {}", number.quote))
        });
        let view = Truth { expect: self.expect, told: self.told, rooms: &self.rooms, things: &self.things };
        let connections = view.connections(&mut misses);
        let wrong = view.wrong(&mut misses);
        let said = |r: &&crate::Relation| self.relation(r, |s| calls(s, &r.relation));
        let weakened = Share::of(self.expect.relations.iter().filter(said), |relation| {
            let is = !self.relation(relation, |s| s.must && calls(s, &relation.relation));
            if is {
                misses.push(format!("only a preference: {}", wording(relation)));
            }
            is
        });
        Score { precision, recall, counts, texts, mentioned, named, numbers, connections, wrong, weakened, misses }
    }

    /// Whether a thing of the program that nothing else accounts for is called like a forbidden one. In a program that
    /// says nothing it is not known to be absent.
    fn forbidden_is_there(&self, thing: &ExpectedThing) -> bool {
        let called = Called::by([thing.name.as_str()]);
        let unasked = |n: &usize| !self.things.contains(&Some(*n));
        self.told.things.is_empty()
            || (0..self.told.things.len()).filter(unasked).any(|n| called.overlaps(&self.told.things[n].called))
    }

    fn referent(&self, name: &str) -> Option<Referent> {
        let object = self.expect.objects.iter().position(|o| o.name == name);
        let room = || self.expect.rooms.iter().position(|r| r.name == name);
        match object {
            Some(at) => self.things[at].map(Referent::Thing),
            None => room().and_then(|at| self.rooms[at]).map(Referent::Region),
        }
    }

    /// Whether an `assert` or `prefer` mentions all of a relation's names, and is as wanted.
    fn relation(&self, relation: &crate::Relation, wanted: impl Fn(&Statement) -> bool) -> bool {
        let names = relation.subject.all().iter().chain(relation.object.all());
        let all: Option<Vec<Referent>> = names.map(|n| self.referent(n)).collect();
        let Some(all) = all else { return false };
        self.told.statements.iter().any(|s| s.asks && all.iter().all(|r| mentions(s, *r)) && wanted(s))
    }
}

/// The region of each room.
fn rooms(expect: &Expectation, told: &ProgramOutline) -> Vec<Option<usize>> {
    let called = |room: &crate::ExpectedRoom| Called::by([room.name.as_str()].into_iter().chain(room.kind.as_deref()));
    let weight = |room: &Called, region: &Called| {
        if room.overlaps(region) { SAME + room.likeness(region) } else { 0 }
    };
    let weights: Vec<Vec<i64>> =
        expect.rooms.iter().map(|room| told.regions.iter().map(|r| weight(&called(room), r)).collect()).collect();
    let mut rooms = pair(&weights);
    let free: Vec<usize> = (0..told.regions.len()).filter(|r| !rooms.contains(&Some(*r))).collect();
    let open: Vec<usize> = (0..rooms.len()).filter(|r| rooms[*r].is_none()).collect();
    if let ([region], [room]) = (&free[..], &open[..]) {
        rooms[*room] = Some(*region);
    }
    rooms
}

/// The stated colour and material of a thing.
fn said(thing: &ExpectedThing) -> impl Iterator<Item = &str> {
    [&thing.colour, &thing.material].into_iter().filter(|_| !thing.forbidden()).filter_map(|t| t.as_deref())
}

fn carries(named: &Named, text: &str) -> bool {
    carried(text, &named.texts.iter().map(String::as_str).collect::<Vec<_>>())
}

fn mentions(statement: &Statement, referent: Referent) -> bool {
    match referent {
        Referent::Thing(n) => statement.things.contains(&n),
        Referent::Region(n) => statement.regions.contains(&n),
    }
}

/// Whether a statement calls the predicate that a relation is named after.
fn calls(statement: &Statement, relation: &str) -> bool {
    let (written, name) = match relation.strip_prefix("not_") {
        Some(name) => (&statement.written.denials, name),
        None => (&statement.written.calls, relation),
    };
    // The words of the ground truth for built-in predicates.
    let name = match name {
        "reachable_from" => "reachable",
        "visible_from" => "visible",
        name => name,
    };
    // What says more says that, too. The ground truth does not tell from where left and right are seen.
    let stronger: &[&str] = match name {
        "on" => &["restsOn"],
        "facing" => &["looksAt"],
        "leftOf" => &["seenLeftOf"],
        "rightOf" => &["seenRightOf"],
        _ => &[],
    };
    written.contains(name) || !relation.starts_with("not_") && stronger.iter().any(|name| written.contains(*name))
}

fn wording(relation: &crate::Relation) -> String {
    format!("{} {} {}", relation.subject.all().join(", "), relation.relation, relation.object.all().join(", "))
}
