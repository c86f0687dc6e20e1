//! What was read so far: rooms, things, and what is said of them. Indices only; names come at the end.

use super::chunk::Pattern;
use super::lexicon::{Class, Group, Rel, get};
use super::measure::{Dim, Op};
use super::noun::{Det, Np, Place};
use crate::draft::Look;
use std::ops::Range;

/// A thing, or several like ones; doors and windows too.
#[derive(Clone, Debug)]
pub struct Item {
    /// Its name in the singular.
    pub words: Vec<String>,
    /// How many of the last words are one noun.
    pub last: usize,
    /// How it usually is in a room.
    pub group: Group,
    /// How many, where it is said.
    pub count: Option<usize>,
    /// So many for each of another.
    pub per: Option<(usize, usize)>,
    /// A plural.
    pub many: bool,
    /// Of at least three: "several".
    pub several: bool,
    /// What it holds or is of, as part of its name: "of honey".
    pub of: Option<String>,
    /// The room it is in.
    pub room: usize,
    /// For an opening: the room on the other side.
    pub beyond: Option<usize>,
    /// Its looks.
    pub look: Look,
    /// Width, height, depth, where they are said.
    pub size: [Option<f64>; 3],
    /// Bytes that introduce it.
    pub at: Range<usize>,
    /// Why it is there, if the request does not say so.
    pub inferred: Option<String>,
    /// Not a thing of its own, but some of another: "the first exit", "two of them".
    pub part: Option<Part>,
}

/// Some elements of an item that there are several of.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The item.
    pub of: usize,
    /// Which of it.
    pub pick: Pick,
}

/// Which of several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pick {
    /// So many, from this one on: "one of them", "the second exit".
    Run(usize, usize),
    /// All from this one on: "the others".
    Rest(usize),
    /// The last one.
    Last,
    /// "half of the desks".
    Half,
    /// "every second counter".
    Every(usize),
    /// The one in the middle of a row.
    Row(usize),
}

impl Pick {
    /// The indices of so many elements that stand in so many rows.
    pub fn indices(self, count: usize, rows: usize) -> Vec<usize> {
        let last = count.max(1) - 1;
        let all = 0..=last;
        let some: Vec<usize> = match self {
            Self::Run(from, n) => all.skip(from).take(n).collect(),
            Self::Rest(from) => all.skip(from).collect(),
            Self::Last => vec![],
            Self::Half => all.take((count / 2).max(1)).collect(),
            Self::Every(n) => all.skip(n.max(1) - 1).step_by(n.max(1)).collect(),
            Self::Row(row) => {
                let columns = count.div_ceil(rows.max(1)).max(1);
                let row = row.min(rows.max(1) - 1);
                vec![(row * columns + (columns - 1) / 2).min(last)]
            }
        };
        if some.is_empty() { vec![last] } else { some }
    }
}

impl Item {
    /// The noun: "table" of a coffee table.
    pub fn head(&self) -> String {
        self.words[self.words.len().saturating_sub(self.last)..].join(" ")
    }

    /// Its whole name.
    pub fn name(&self) -> String {
        self.words.join(" ")
    }

    /// Whether it is a door or a window.
    pub fn opening(&self) -> bool {
        matches!(self.group, Group::Door | Group::Window)
    }

    /// Takes over sizes; "long" and "wide" together are width and depth, "long" alone is the width.
    pub fn take_dims(&mut self, dims: &[(Dim, f64)]) {
        // "6 m long, 1.2 m wide": what was taken for the width is the depth.
        if let ([(Dim::Width, _)], Some(long), None) = (dims, self.size[0], self.size[2]) {
            self.size[2] = Some(long);
        }
        let wide = dims.iter().any(|(d, _)| *d == Dim::Width) || self.size[0].is_some();
        let rod = self.group == Group::Bed;
        for (dim, value) in dims {
            let axis = match dim {
                Dim::Width => 0,
                Dim::Elevation => continue,
                Dim::Height | Dim::Ceiling => 1,
                Dim::Depth => 2,
                // A bed's length is how far it reaches into the room.
                Dim::Length if rod || wide => 2,
                Dim::Length => 0,
                Dim::Across => {
                    self.size[2] = self.size[2].or(Some(*value));
                    0
                }
            };
            // "90 x 60 cm" of what hangs on a wall is as it is seen.
            let axis = if axis == 2 && matches!(self.group, Group::Wall | Group::Screen) && dims.len() == 2 {
                1
            } else {
                axis
            };
            self.size[axis] = Some(*value);
        }
    }
}

/// A room.
#[derive(Clone, Debug, Default)]
pub struct Room {
    /// Its name in the singular: "meeting room".
    pub name: String,
    /// Width, height, depth, where they are said.
    pub size: [Option<f64>; 3],
    /// Square metres, where they are said.
    pub area: Option<f64>,
    /// How many corners an even outline has: "octagonal".
    pub corners: Option<usize>,
    /// Bytes that introduce it; none: the request names no room.
    pub at: Range<usize>,
    /// The look of its floor.
    pub floor: Look,
    /// The look of its walls.
    pub walls: Look,
}

/// A side of a thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Side {
    Front,
    Behind,
    Left,
    Right,
    Above,
    Around,
}

/// What is said.
#[derive(Clone, Debug, PartialEq)]
pub enum What {
    /// A relation to things.
    Rel(Rel, Vec<usize>),
    /// At a place of the room; which one.
    Place(Rel, Place, Vec<String>),
    /// So far from things.
    Gap(Op, f64, Vec<usize>),
    /// So far from each other.
    Among(Op, f64),
    /// So far from row to row.
    Rows(Op, f64),
    /// So far from the walls.
    Wall(Op, f64),
    /// So far from whatever else there is.
    Alone(f64),
    /// So much free space.
    Clear(Side, f64),
    /// So large.
    Size(Dim, Op, f64),
    /// So high above the floor.
    Height(Op, f64),
    /// A way of this width to things.
    Path(f64, Vec<usize>),
    /// How several stand to each other.
    Pattern(Pattern),
}

/// Something said of things.
#[derive(Clone, Debug)]
pub struct Fact {
    /// Of these.
    pub of: Vec<usize>,
    /// This.
    pub what: What,
    /// As a wish.
    pub soft: bool,
    /// That it is not so.
    pub not: bool,
    /// Bytes of the request.
    pub at: Range<usize>,
}

/// All that was read.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Rooms.
    pub rooms: Vec<Room>,
    /// Things and openings.
    pub items: Vec<Item>,
    /// What is said of them.
    pub facts: Vec<Fact>,
    /// What must not be there, and where that is said.
    pub absent: Vec<(String, Range<usize>)>,
    /// Counts and sizes that were not taken as they are, and why.
    pub notes: Vec<(Range<usize>, String)>,
    /// Items that were taken back: "no, forget the carpet".
    pub gone: Vec<usize>,
}

/// More things than anybody asks for: what goes beyond is noted.
pub const MOST_ITEMS: usize = 300;
/// More of one kind than anybody asks for.
pub const MOST_COUNT: usize = 400;

impl Scene {
    /// The thing that a phrase speaks of again: the last one of that name, in this room before others.
    pub fn find(&self, np: &Np, room: usize) -> Option<usize> {
        let lexicon = get();
        let head = np.head();
        let tail = np.words.last().cloned().unwrap_or_default();
        let score = |item: &Item| -> u32 {
            let same_head = item.head() == head;
            let same_tail = item.words.last() == Some(&tail);
            let all = np.words.iter().all(|w| item.words.contains(w));
            let own = np.words.iter().all(|w| {
                item.words.contains(w)
                    || item.look.features.iter().any(|f| f == w)
                    || item.look.material.as_deref() == Some(w)
            });
            let fewer = item.words.iter().all(|w| np.words.contains(w));
            let color = np.look.color.is_none() || np.look.color == item.look.color;
            if item.words == np.words && color {
                8
            } else if all && same_tail {
                7
            } else if (same_head || same_tail) && own {
                6
            } else if np.words.len() == 1 && item.words.contains(&head) && !item.opening() {
                // "the wardrobe door" is no wardrobe; "the desk" is rather a desk than a desk lamp
                3
            } else if np.words.len() == 1
                && item.words.last().is_some_and(|w| w.len() > head.len() && w.ends_with(&head))
            {
                // "the bench" is the workbench
                5
            } else if all {
                3
            } else if lexicon.alike(&item.head(), &head)
                && np.words[..np.words.len() - np.last].iter().all(|w| lexicon.alike(&item.head(), w))
            {
                4
            } else if fewer
                && (same_head || same_tail)
                && np.look.color.is_none()
                && (np.many || np.count.is_some_and(|c| c > 1) || !item.many)
            {
                2
            } else {
                0
            }
        };
        let best = self
            .items
            .iter()
            .enumerate()
            .filter(|(i, item)| item.part.is_none() && !self.gone.contains(i))
            .map(|(i, item)| (score(item) * 2 + u32::from(item.room == room), score(item), i));
        let surface = np.det == Det::Definite && lexicon.is(&head, Class::Surface);
        best.filter(|b| b.1 > 0).max().map(|b| b.2).or_else(|| if surface { self.surface(&head, room) } else { None })
    }

    /// "the tabletop": what was spoken of last that has one.
    fn surface(&self, said: &str, room: usize) -> Option<usize> {
        let with_top = |i: &usize| {
            let item = &self.items[*i];
            item.room == room && item.group == Group::Table && item.part.is_none() && !self.gone.contains(i)
        };
        // "the tabletop" is rather that of a table than of a sideboard.
        let named = |i: &usize| self.items[*i].words.last().is_some_and(|w| said.starts_with(w.as_str()));
        let all = || (0..self.items.len()).rev().filter(with_top);
        all().find(named).or_else(|| all().next())
    }

    /// Leaves out what was taken back, and what was said of it.
    pub fn forget(&mut self) {
        let gone = std::mem::take(&mut self.gone);
        let lost = |i: usize| gone.contains(&i) || self.items[i].part.as_ref().is_some_and(|p| gone.contains(&p.of));
        let mut next = 0;
        let new: Vec<Option<usize>> = (0..self.items.len())
            .map(|i| {
                let kept = !lost(i);
                next += usize::from(kept);
                kept.then(|| next - 1)
            })
            .collect();
        let moved = |list: &[usize]| -> Vec<usize> { list.iter().filter_map(|i| new[*i]).collect() };
        for fact in &mut self.facts {
            fact.of = moved(&fact.of);
            if let What::Rel(_, to) | What::Gap(_, _, to) | What::Path(_, to) = &mut fact.what {
                let all = to.len();
                *to = moved(to);
                if to.len() < all {
                    fact.of.clear();
                }
            }
        }
        self.facts.retain(|f| !f.of.is_empty());
        let items = std::mem::take(&mut self.items);
        for (mut item, _) in items.into_iter().zip(&new).filter(|(_, new)| new.is_some()) {
            item.per = item.per.and_then(|(owner, n)| Some((new[owner]?, n)));
            if let Some(part) = &mut item.part {
                part.of = new[part.of].unwrap_or(part.of);
            }
            self.items.push(item);
        }
    }

    /// How many there are of an item, as far as it is known: what is not said is taken as `usual`.
    pub fn count(&self, item: usize) -> usize {
        let it = &self.items[item];
        if let Some(part) = &it.part {
            return self.elements(part).len();
        }
        self.stated(item).clamp(1, MOST_COUNT)
    }

    /// The same, however many that are.
    pub fn stated(&self, item: usize) -> usize {
        let it = &self.items[item];
        match (it.per, it.count) {
            (Some((owner, each)), _) if owner < item || self.items[owner].per.is_none() => {
                self.count(owner).saturating_mul(each)
            }
            (_, Some(n)) => n,
            (_, None) if it.many => {
                if it.several || matches!(it.group, Group::Ceiling | Group::Seat) {
                    3
                } else {
                    2
                }
            }
            (_, None) => 1,
        }
    }

    /// The indices of some of an item.
    pub fn elements(&self, part: &Part) -> Vec<usize> {
        let rows = self.facts.iter().find_map(|f| match f.what {
            What::Pattern(Pattern::Rows(n)) if f.of.contains(&part.of) => Some(n),
            _ => None,
        });
        part.pick.indices(self.count(part.of), rows.unwrap_or(1))
    }

    /// Some of an item, as an item.
    pub fn part(&mut self, of: usize, pick: Pick, at: Range<usize>) -> usize {
        let part = Part { of, pick };
        if let Some(known) = self.items.iter().position(|i| i.part.as_ref() == Some(&part)) {
            return known;
        }
        let many = self.elements(&part).len() > 1;
        let item = Item { count: None, per: None, many, part: Some(part), at, ..self.items[of].clone() };
        self.items.push(item);
        self.items.len() - 1
    }

    /// The item that an item is some of, or itself.
    pub fn whole(&self, item: usize) -> usize {
        self.items[item].part.as_ref().map_or(item, |p| p.of)
    }

    /// A new thing.
    pub fn add(&mut self, np: &Np, room: usize, at: Range<usize>) -> usize {
        let count = match np.det {
            Det::Each | Det::No => np.count,
            _ if np.many => np.count,
            _ => Some(np.count.unwrap_or(1)),
        };
        let group = np.group.unwrap_or(Group::Floor);
        self.notes.extend(np.number.and_then(super::counts::said).map(|why| (at.clone(), why)));
        let mut item = Item {
            words: np.words.clone(),
            last: np.last,
            group,
            count: count.map(|c| c.clamp(1, MOST_COUNT)),
            per: None,
            many: np.many || count.is_some_and(|c| c > 1),
            several: np.several,
            of: None,
            room,
            beyond: None,
            look: np.look.clone(),
            size: [None; 3],
            at,
            inferred: None,
            part: None,
        };
        item.take_dims(&np.dims);
        self.items.push(item);
        self.items.len() - 1
    }

    /// Says something.
    pub fn say(&mut self, of: &[usize], what: What, soft: bool, not: bool, at: Range<usize>) {
        let known = self.facts.iter().any(|f| f.of == of && f.what == what && f.not == not);
        if !of.is_empty() && !known && self.facts.len() < 4 * MOST_ITEMS {
            self.facts.push(Fact { of: of.to_vec(), what, soft, not, at });
        }
    }
}
