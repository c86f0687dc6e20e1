//! Chunks → what is said: an attribute grammar that reads a sentence from left to right and carries along what it is about.

use super::chunk::{Chunk, Pattern, Piece};
use super::lexicon::{Group, Rel, Verb, get};
use super::measure::{Dim, Measure, Op};
use super::noun::{Det, Kind, Np, Place};
use super::rooms::Rooms;
use super::scene::{MOST_ITEMS, Scene, Side, What};
use super::token::Token;
use std::ops::Range;

/// What a noun phrase that comes next is to what came before.
#[derive(Clone, Debug, PartialEq)]
enum Expect {
    /// A subject.
    Nothing,
    /// "a table with …", "each desk has …": things that belong to these.
    With(Vec<usize>, Join),
    /// "the sofa faces …".
    Object(Rel),
}

/// How things that come with another relate to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Join {
    /// As such things usually do.
    Usual,
    /// On it.
    On,
    /// At its sides.
    Beside,
    /// Around it.
    Around,
    /// Over it.
    Above,
}

/// Reads the sentences of a text.
pub struct Reader<'a> {
    tokens: &'a [Token],
    chunks: &'a [Chunk],
    rooms: &'a Rooms,
    /// What was read.
    pub scene: Scene,
    /// For every token, whether something came of it.
    pub used: Vec<bool>,
    room: usize,
    /// The sentence before was about the room.
    about_room: bool,
    /// What the sentence is about; of the one before, if this has no subject yet.
    main: Vec<usize>,
    /// What was spoken of before that.
    before: Vec<usize>,
    /// What was mentioned last.
    near: Vec<usize>,
    /// Mentions in their order.
    recent: Vec<usize>,
    s: Sentence,
}

/// What holds within one sentence.
#[derive(Clone, Debug)]
struct Sentence {
    at: Range<usize>,
    /// Whether the sentence has a subject of its own.
    subject: bool,
    /// Relations that came before the subject.
    lead: Vec<(Rel, Lead)>,
    expect: Expect,
    soft: bool,
    not: bool,
    /// "keep", "leave", "nothing": of free space.
    keep: bool,
    nothing: bool,
    hang: bool,
    path: bool,
    /// A subject that a verb follows: relations go to all of it.
    verb: bool,
    /// "each", "all", "both".
    each: bool,
    /// A measure that waits for its relation.
    pending: Option<Measure>,
    /// The relation said last, for a measure that comes after it.
    last: Option<(Vec<usize>, Rel, Vec<usize>)>,
    /// Whether the last subject was listed as what a room has.
    listed: bool,
    /// The sentence is about a room.
    of_room: bool,
    /// A door may lead from one room to another here.
    doors: bool,
    /// The last noun phrase was of a room.
    room_last: bool,
    /// It is about something that is no thing.
    unknown: bool,
    /// Rooms named in it.
    rooms: Vec<usize>,
    /// The room it begins in.
    from: usize,
    /// "one": of several, so that nothing is multiplied.
    one: bool,
    /// "centre a table in the room".
    centre: bool,
    /// What the last relation was to.
    object: Vec<usize>,
    /// A group that has a relation, and the next that may share it.
    shared: Option<(Rel, Vec<usize>)>,
}

/// What a relation at the start of a clause is to.
#[derive(Clone, Debug)]
enum Lead {
    Items(Vec<usize>, bool),
    Place(Place, Vec<String>),
}

impl<'a> Reader<'a> {
    /// A reader of a text; nothing is read yet.
    pub fn new(tokens: &'a [Token], chunks: &'a [Chunk], rooms: &'a Rooms) -> Self {
        let scene = Scene { rooms: rooms.rooms.clone(), ..Scene::default() };
        let s = Sentence::new(0..0);
        Self {
            tokens,
            chunks,
            rooms,
            scene,
            used: vec![false; tokens.len()],
            room: 0,
            about_room: true,
            main: vec![],
            before: vec![],
            near: vec![],
            recent: vec![],
            s,
        }
    }

    /// Reads everything.
    pub fn read(&mut self) {
        let mut from = 0;
        while from < self.chunks.len() {
            let end = self.sentence_end(from);
            self.sentence(from, end);
            from = end + 1;
        }
    }

    /// The chunk that ends a sentence: a full stop, or the end of a line that is one.
    fn sentence_end(&self, from: usize) -> usize {
        let mut i = from;
        while i < self.chunks.len() {
            match self.chunks[i].piece {
                Piece::Stop => return i,
                Piece::Line => {
                    let next = self.chunks.get(i + 1);
                    let fresh = next.is_none_or(|c| {
                        c.piece == Piece::Bullet
                            || self.tokens[c.at.start].capital
                            || i > 0 && self.chunks[i - 1].piece == Piece::Colon
                    });
                    if fresh || matches!(self.chunks[from].piece, Piece::Bullet) {
                        return i;
                    }
                }
                _ => {}
            }
            i += 1;
        }
        i
    }

    fn bytes(&self, chunks: Range<usize>) -> Range<usize> {
        let first = self.chunks.get(chunks.start).map_or(0, |c| self.tokens[c.at.start].at.start);
        let last = chunks
            .end
            .checked_sub(1)
            .and_then(|i| self.chunks.get(i))
            .map_or(first, |c| self.tokens[c.at.end - 1].at.end);
        first..last.max(first)
    }

    fn mark(&mut self, chunk: usize) {
        if let Some(c) = self.chunks.get(chunk) {
            self.used[c.at.clone()].fill(true);
        }
    }

    fn piece(&self, i: usize, end: usize) -> Option<&'a Piece> {
        (i < end).then(|| self.chunks.get(i).map(|c| &c.piece)).flatten()
    }

    fn np(&self, i: usize, end: usize) -> Option<&'a Np> {
        if i < end { self.chunks.get(i).and_then(Chunk::np) } else { None }
    }

    fn sentence(&mut self, from: usize, end: usize) {
        let chunks = self.chunks;
        let at = self.bytes(from..end);
        self.s = Sentence { from: self.room, ..Sentence::new(at) };
        let words = &chunks[from..end.min(chunks.len())];
        self.s.soft = words.iter().any(|c| c.piece == Piece::Soft);
        self.s.keep = words.iter().any(|c| matches!(c.piece, Piece::Verb(Verb::Keep) | Piece::Free));
        self.s.path = words.iter().any(|c| {
            c.at.clone().any(|t| {
                matches!(
                    self.tokens[t].text.as_str(),
                    "aisle"
                        | "aisles"
                        | "path"
                        | "paths"
                        | "route"
                        | "routes"
                        | "walkway"
                        | "passage"
                        | "passageway"
                        | "way"
                        | "corridor"
                        | "circulation"
                )
            })
        });
        self.s.doors = words.iter().any(|c| matches!(c.piece, Piece::Verb(Verb::Lead)));
        for c in words {
            if c.piece == Piece::Soft {
                self.used[c.at.clone()].fill(true);
            }
        }
        if self.heading(from, end) {
            return;
        }
        self.before = std::mem::take(&mut self.main);
        self.near.clear();
        let mut i = from;
        while i < end {
            i = self.step(i, end).max(i + 1);
        }
        self.finish();
        self.doors();
        self.about_room = self.s.of_room && !self.s.subject;
        if !self.s.subject && self.main.is_empty() {
            self.main = std::mem::take(&mut self.before);
        }
    }

    /// "Storage." after a number, "Kitchen:", a title: what begins no sentence.
    fn heading(&mut self, from: usize, end: usize) -> bool {
        let first = from + usize::from(matches!(self.piece(from, end), Some(Piece::Bullet)));
        let Some(np) = self.np(first, end) else { return false };
        let closed = first + 1 == end || first + 2 == end && matches!(self.piece(first + 1, end), Some(Piece::Colon));
        match np.kind {
            Kind::Room => {
                if let Some(room) = self.rooms.spoken.get(&first) {
                    self.room = *room;
                    self.room_look(*room, np);
                    if closed {
                        self.mark(from);
                        self.mark(first);
                        self.main.clear();
                        self.near.clear();
                        self.about_room = true;
                        return true;
                    }
                }
                false
            }
            _ if closed
                && first > from
                && np.det == Det::None
                && np.count.is_none()
                && np.look == crate::draft::Look::default() =>
            {
                let stop = self.chunks.get(end).is_some_and(|c| c.piece == Piece::Stop) || first + 2 == end;
                // "2. Desks. Eight desks …", but "- armchair" is a thing.
                let more = self.chunks.get(end + 1).is_some_and(|c| !matches!(c.piece, Piece::Line | Piece::Bullet));
                if stop && more {
                    self.mark(first);
                    return true;
                }
                false
            }
            _ => false,
        }
    }

    fn room_look(&mut self, room: usize, np: &Np) {
        let r = &mut self.scene.rooms[room];
        for f in &np.look.features {
            match f.as_str() {
                "octagonal" => r.corners = Some(8),
                "hexagonal" => r.corners = Some(6),
                "round" | "circular" => r.corners = Some(12),
                _ => {}
            }
        }
        let dims = np.dims.clone();
        for (dim, value) in dims {
            self.room_dim(room, dim, value);
        }
    }

    fn room_dim(&mut self, room: usize, dim: Dim, value: f64) {
        let size = &mut self.scene.rooms[room].size;
        match dim {
            Dim::Width => size[0] = Some(value),
            Dim::Height | Dim::Ceiling => size[1] = Some(value),
            Dim::Depth => size[2] = Some(value),
            Dim::Length if size[0].is_some() && size[2].is_none() => size[2] = Some(value),
            Dim::Length => {
                // "6.5 m long and 5 m wide": the width comes later, and is then the depth.
                size[0] = Some(value);
            }
            Dim::Across => {
                size[0] = Some(value);
                size[2] = Some(value);
            }
        }
    }

    /// Reads one chunk, or what hangs together; the index of the next.
    fn step(&mut self, i: usize, end: usize) -> usize {
        let chunks = self.chunks;
        match &chunks[i].piece {
            Piece::Np(np) => self.on_np(i, end, np),
            Piece::Rel(rel) => self.on_rel(i, end, *rel),
            Piece::ToIts(rel) => {
                self.mark(i);
                self.on_its(i, end, *rel);
                i + 1
            }
            Piece::Verb(verb) => {
                self.on_verb(i, *verb);
                i + 1
            }
            Piece::Measure(m) => self.on_measure(i, end, m),
            Piece::With => {
                let with_back = self.np(i + 1, end).is_some_and(|n| {
                    n.kind == Kind::Thing
                        && n.count.is_none()
                        && (get().part(&n.head()) || !n.known && n.det == Det::None && n.many)
                });
                if !with_back && !self.near.is_empty() {
                    self.s.expect = Expect::With(self.near.clone(), Join::Usual);
                } else if with_back {
                    return self.with_part(i, end);
                }
                i + 1
            }
            Piece::Attr(look) => {
                let target = self.near.clone();
                if target.is_empty() && self.s.of_room {
                    self.mark(i);
                } else if !target.is_empty() {
                    self.mark(i);
                    self.add_look(&target, look);
                }
                i + 1
            }
            Piece::Pattern(pattern) => {
                self.mark(i);
                let of = self.subject(i);
                let (soft, at) = (self.s.soft, self.s.at.clone());
                self.scene.say(&of, What::Pattern(*pattern), soft, false, at);
                i + 1
            }
            Piece::Comma | Piece::Which => {
                if !self.main.is_empty() && !matches!(self.piece(i + 1, end), Some(Piece::Attr(_) | Piece::Measure(_)))
                {
                    self.near = self.main.clone();
                }
                if chunks[i].piece == Piece::Comma {
                    self.s.not = false;
                }
                i + 1
            }
            Piece::Colon => {
                if let (Some(n), true) = (self.number_at(i + 1, end), self.near.len() == 1) {
                    let item = &mut self.scene.items[self.near[0]];
                    if item.many {
                        item.count = Some(n);
                    }
                    self.mark(i + 1);
                    return i + 2;
                }
                i + 1
            }
            Piece::Open | Piece::Close | Piece::And | Piece::Bullet | Piece::Line | Piece::Stop => i + 1,
            Piece::There => {
                self.s.expect = Expect::Nothing;
                i + 1
            }
            Piece::Not => {
                self.s.not = true;
                self.mark(i);
                i + 1
            }
            Piece::Apart => {
                self.mark(i);
                if let Some(m) = self.s.pending.take() {
                    self.among(&m);
                }
                i + 1
            }
            Piece::Free => self.on_free(i, end),
            Piece::Soft | Piece::Word(_) => {
                self.s.centre |= matches!(
                    self.tokens[chunks[i].at.start].text.as_str(),
                    "center" | "centre" | "centred" | "centered"
                );
                if self.tokens[chunks[i].at.start].is("nothing") || self.tokens[chunks[i].at.start].is("nobody") {
                    self.s.nothing = true;
                }
                i + 1
            }
        }
    }

    fn number_at(&self, i: usize, end: usize) -> Option<usize> {
        if i >= end {
            return None;
        }
        let c = &self.chunks[i];
        super::number::count(&self.tokens[c.at.clone()])
            .filter(|(n, k)| *k == c.at.len() && n.fract() == 0.0 && *n < 1000.0)
            .map(|(n, _)| n as usize)
    }

    fn add_look(&mut self, items: &[usize], look: &crate::draft::Look) {
        for i in items {
            let to = &mut self.scene.items[*i].look;
            match (&to.color, &look.color) {
                (None, Some(c)) => to.color = Some(c.clone()),
                (Some(old), Some(c)) if old != c => to.features.push(c.clone()),
                _ => {}
            }
            match (&mut to.material, &look.material) {
                (to @ None, Some(m)) => *to = Some(m.clone()),
                (Some(old), Some(m)) if !old.contains(m.as_str()) => {
                    old.push(' ');
                    old.push_str(m);
                }
                _ => {}
            }
            to.features.extend(look.features.iter().cloned());
        }
    }

    /// What a relation that comes now is said of.
    fn subject(&self, i: usize) -> Vec<usize> {
        let after_comma =
            i > 0 && matches!(self.chunks[i - 1].piece, Piece::Comma | Piece::Which | Piece::Verb(_) | Piece::And);
        let owned = matches!(self.s.expect, Expect::With(..));
        if self.s.each && !owned || after_comma && !self.main.is_empty() || self.near.is_empty() {
            if self.main.is_empty() { self.before.clone() } else { self.main.clone() }
        } else {
            self.near.clone()
        }
    }

    /// "with armrests", "with a glass top": looks of the last thing.
    fn with_part(&mut self, i: usize, end: usize) -> usize {
        let from = i + 1;
        let mut to = from;
        while to < end
            && (to == from
                || matches!(self.chunks[to].piece, Piece::And | Piece::Attr(_))
                || self.np(to, end).is_some_and(|n| get().part(&n.head())))
        {
            to += 1;
        }
        while to > from + 1 && self.chunks[to - 1].piece == Piece::And {
            to -= 1;
        }
        // "with its back to a wall" is a relation.
        let text: Vec<&str> =
            (self.chunks[from].at.start..self.chunks[to - 1].at.end).map(|t| self.tokens[t].text.as_str()).collect();
        if let (false, Some(item)) = (self.near.is_empty(), self.near.last()) {
            let feature = format!("with {}", text.join(" "));
            self.scene.items[*item].look.features.push(feature);
            (i..to).for_each(|k| self.mark(k));
        }
        to
    }

    // ---- Noun phrases ----

    fn on_np(&mut self, i: usize, end: usize, np: &Np) -> usize {
        match np.kind {
            Kind::Thing => self.on_things(i, end),
            Kind::Room => {
                self.on_room(i, end, np);
                i + 1
            }
            Kind::Pronoun => {
                self.on_pronoun(i, end, np);
                i + 1
            }
            Kind::Abstract => {
                if np.det == Det::No || np.words.first().is_some_and(|w| w == "nothing") {
                    self.s.nothing = true;
                    self.s.keep = true;
                }
                if np.words.first().is_some_and(|w| w == "neighbour" || w == "neighbor")
                    && let Some(m) = self.s.pending.take()
                {
                    self.among(&m);
                    self.mark(i);
                }
                i + 1
            }
            Kind::Place(place) => self.on_place_first(i, end, place, np),
        }
    }

    /// A place with no relation before it: "the walls are white", "one corner".
    fn on_place_first(&mut self, i: usize, end: usize, place: Place, _np: &Np) -> usize {
        let surface = matches!(place, Place::Wall | Place::Floor | Place::Ceiling);
        let mut k = i + 1;
        while matches!(self.piece(k, end), Some(Piece::Verb(Verb::Be) | Piece::Rel(Rel::In | Rel::Of))) {
            k += 1;
        }
        if surface && let Some(Piece::Attr(look)) = self.piece(k, end) {
            let room = &mut self.scene.rooms[self.room];
            match place {
                Place::Wall => room.walls = look.clone(),
                Place::Floor => room.floor = look.clone(),
                _ => {}
            }
            (i..=k).for_each(|c| self.mark(c));
            return k + 1;
        }
        self.near.clear();
        if place == Place::Ceiling {
            self.s.room_last = true;
        }
        i + 1
    }

    fn on_room(&mut self, i: usize, end: usize, np: &Np) {
        let Some(room) = self.rooms.spoken.get(&i).copied() else {
            // "the kitchen behind it": a room that is none here is no subject either.
            self.s.unknown |= !self.s.subject;
            return;
        };
        self.mark(i);
        self.room_look(room, np);
        let named_before = !self.s.rooms.is_empty();
        self.s.rooms.push(room);
        self.s.room_last = true;
        if self.s.doors && named_before {
            return;
        }
        self.s.of_room = true;
        self.room = room;
        self.near.clear();
        if !self.s.subject {
            self.main.clear();
            self.before.clear();
        }
        if matches!(self.piece(i + 1, end), Some(Piece::With)) {
            self.mark(i + 1);
        }
    }

    /// The door of the sentence leads from one of its rooms to the other.
    fn doors(&mut self) {
        let mut rooms = std::mem::take(&mut self.s.rooms);
        rooms.dedup();
        if !self.s.doors {
            return;
        }
        match rooms.as_slice() {
            [a, b, ..] if a != b => self.connect(*a, *b),
            [a] if self.scene.rooms.len() > 1 && *a != self.s.from => {
                let from = self.s.from;
                self.connect(from, *a);
            }
            [] | [_] if self.scene.rooms.len() == 2 => self.connect(0, 1),
            _ => {}
        }
    }

    fn connect(&mut self, from: usize, to: usize) {
        let start = self.s.at.start;
        let said = self.scene.items.iter().rposition(|it| it.group == Group::Door && it.at.start >= start);
        let again = self.recent.last().copied().filter(|r| self.scene.items[*r].group == Group::Door);
        if let Some(door) = said.or(again) {
            let item = &mut self.scene.items[door];
            if item.room == to {
                item.room = from;
            }
            item.beyond = Some(to);
        }
    }

    fn on_pronoun(&mut self, i: usize, end: usize, np: &Np) {
        let word = np.words.first().map_or("", String::as_str);
        let followed = matches!(
            self.piece(i + 1, end),
            Some(
                Piece::Rel(_) | Piece::Verb(_) | Piece::ToIts(_) | Piece::With | Piece::Pattern(_) | Piece::Measure(_)
            )
        );
        if let (Some(n), [item]) = (np.count, self.main.as_slice()) {
            // "four of them"
            let it = &mut self.scene.items[*item];
            if it.many && it.count.is_none() {
                it.count = Some(n);
                self.mark(i);
            }
        }
        let bare = !self.s.subject && !self.s.of_room && matches!(word, "it") && i > 0 && np.det == Det::None;
        if bare && self.about_room {
            self.s.of_room = true;
            self.s.room_last = true;
            self.s.rooms.push(self.room);
            self.mark(i);
            return;
        }
        self.s.one |= np.count == Some(1) || word == "one";
        let dir = if matches!(word, "them" | "they" | "these" | "those" | "both" | "all" | "ones") {
            self.them()
        } else {
            self.it()
        };
        if matches!(word, "each" | "both" | "all" | "these" | "those" | "ones") || np.det == Det::Each {
            self.s.each |= np.det == Det::Each || matches!(word, "each" | "both" | "all");
            if followed || matches!(self.piece(i + 1, end), None | Some(Piece::Comma | Piece::Np(_))) {
                let many = |l: &[usize]| l.len() > 1 || l.iter().any(|i| self.scene.items[*i].many);
                if self.main.is_empty() {
                    self.main = dir;
                } else if !many(&self.main)
                    && let Some(last) = self.recent.iter().rev().find(|r| self.scene.items[**r].many)
                {
                    self.main = vec![*last];
                }
                self.near = self.main.clone();
                self.mark(i);
            }
            return;
        }
        match self.s.expect.clone() {
            Expect::Object(rel) if !self.main.is_empty() => {
                let of = self.main.clone();
                self.relate(&of, rel, &dir);
                self.s.expect = Expect::Nothing;
            }
            _ if word == "other" => return,
            _ if !self.s.subject && !dir.is_empty() => {
                self.main = dir.clone();
                self.near = dir;
                self.apply_lead();
            }
            _ => {}
        }
        self.mark(i);
    }

    /// The one thing that "it" stands for.
    fn it(&self) -> Vec<usize> {
        let of = |list: &Vec<usize>| (!list.is_empty()).then(|| list.clone());
        let owner = match &self.s.expect {
            Expect::With(owner, _) if !owner.is_empty() => Some(owner.clone()),
            _ => None,
        };
        let lead = self.s.lead.iter().rev().find_map(|(_, l)| match l {
            Lead::Items(items, _) => Some(items.clone()),
            Lead::Place(..) => None,
        });
        owner
            .or_else(|| of(&self.main))
            .or(lead)
            .or_else(|| of(&self.before))
            .or_else(|| self.recent.last().map(|i| vec![*i]))
            .unwrap_or_default()
    }

    /// The things that "them" stands for.
    fn them(&self) -> Vec<usize> {
        let many = |list: &[usize]| list.len() > 1 || list.first().is_some_and(|i| self.scene.items[*i].many);
        for list in [&self.main, &self.before] {
            if many(list) {
                return list.clone();
            }
        }
        if let Some(i) = self.recent.iter().rev().find(|i| self.scene.items[**i].many) {
            return vec![*i];
        }
        self.it()
    }

    /// Whether a noun phrase brings in something new, or which thing it speaks of again.
    fn resolve(&mut self, i: usize, np: &Np, object: bool) -> Option<usize> {
        let found = self.scene.find(np, self.room);
        let exact = found.filter(|f| {
            let item = &self.scene.items[*f];
            item.words == np.words && (np.look.color.is_none() || item.look.color == np.look.color)
        });
        let counted = |f: &usize| np.count.is_none_or(|n| self.scene.items[*f].count.is_none_or(|m| m == n || m > n));
        let again = match np.det {
            Det::Definite | Det::Own => found.filter(|f| counted(f)),
            Det::Each | Det::No => found,
            Det::None if np.count.is_none() => {
                let plain = object || self.s.keep || self.s.pending.is_some();
                exact.or(found.filter(|_| plain))
            }
            Det::None | Det::Number => None,
            Det::Indefinite => None,
        };
        if np.other && np.det != Det::Definite {
            return self.introduce(i, np);
        }
        again.or_else(|| self.introduce(i, np))
    }

    fn introduce(&mut self, i: usize, np: &Np) -> Option<usize> {
        let head = np.head();
        // "its doors", "the headboard": parts.
        if np.det == Det::Own && get().part(&head) && !matches!(np.group, Some(Group::Door | Group::Window)) {
            return None;
        }
        if self.scene.items.len() >= MOST_ITEMS || !nameable(&head) {
            return None;
        }
        // "the draught": a word nobody knows is a thing only where things are.
        let placed = |p: Option<&Piece>| matches!(p, Some(Piece::Rel(r)) if !matches!(r, Rel::Of | Rel::To | Rel::From | Rel::In | Rel::Than));
        let stands =
            matches!(self.chunks.get(i + 1).map(|c| &c.piece), Some(Piece::Verb(Verb::Be | Verb::Hang | Verb::Carry)));
        let around = placed(self.chunks.get(i + 1).map(|c| &c.piece))
            || i > 0 && placed(self.chunks.get(i - 1).map(|c| &c.piece))
            || stands;
        if !np.known && matches!(np.det, Det::Definite | Det::Own | Det::Each) && !around {
            return None;
        }
        let at = self.bytes(i..i + 1);
        let id = self.scene.add(np, self.room, at);
        if np.look.features.iter().any(|f| f == "wall-mounted" || f == "wall-hung") && !self.scene.items[id].opening() {
            self.say(&[id], What::Place(Rel::Mounted, Place::Wall, vec![]));
        }
        Some(id)
    }

    fn say(&mut self, of: &[usize], what: What) {
        let (soft, at) = (self.s.soft, self.s.at.clone());
        self.scene.say(of, what, soft, false, at);
    }

    /// Things named one after the other, with what is said of each right after it: sizes, looks, parts.
    fn on_things(&mut self, i: usize, end: usize) -> usize {
        let chunks = self.chunks;
        let Some(np) = chunks[i].np() else { return i + 1 };
        // What must not be there.
        let denied = np.det == Det::No || self.s.not && !matches!(np.det, Det::Definite | Det::Each | Det::Own);
        let limits = (i..end).any(|k| match &chunks[k].piece {
            Piece::Measure(_) => true,
            Piece::Verb(Verb::Be) => {
                chunks[k].at.clone().any(|t| matches!(self.tokens[t].text.as_str(), "stand" | "be" | "placed"))
                    && self.scene.find(np, self.room).is_some()
            }
            _ => false,
        });
        if denied && !limits {
            return self.deny(i, end);
        }
        self.s.not |= np.det == Det::No;
        let mut group: Vec<usize> = Vec::new();
        let mut k = i;
        let mut each = np.det == Det::Each;
        let new_from = self.scene.items.len();
        while let Some(np) = self.np(k, end) {
            if np.kind != Kind::Thing {
                break;
            }
            if let Some(id) = self.resolve(k, np, false) {
                self.mark(k);
                group.push(id);
                self.near = vec![id];
                if id < new_from {
                    self.more_of(id, np);
                }
                k = self.after_noun(k + 1, end, id);
            } else {
                k += 1;
            }
            each |= np.det == Det::Each;
            let next = self.list_next(k, end);
            match next {
                Some(n) => k = n,
                None => break,
            }
        }
        if group.is_empty() {
            return k.max(i + 1);
        }
        self.s.room_last = false;
        self.recent.extend(&group);
        self.place_group(&group, new_from, each);
        k
    }

    /// What a second mention adds.
    fn more_of(&mut self, id: usize, np: &Np) {
        let look = np.look.clone();
        let item = &mut self.scene.items[id];
        if item.count.is_none() && np.count.is_some() {
            item.count = np.count;
        }
        item.take_dims(&np.dims);
        if np.det != Det::None {
            let fresh = crate::draft::Look {
                features: look.features.into_iter().filter(|f| !item.look.features.contains(f)).collect(),
                ..look
            };
            self.add_look(&[id], &fresh);
        }
    }

    /// Where a list goes on: after "and" or a comma, if a noun phrase follows that is a thing.
    fn list_next(&self, k: usize, end: usize) -> Option<usize> {
        let mut n = k;
        while matches!(self.piece(n, end), Some(Piece::And | Piece::Comma | Piece::Close)) {
            n += 1;
        }
        if n == k {
            return None;
        }
        self.np(n, end).filter(|np| np.kind == Kind::Thing && np.det != Det::No)?;
        // "…, the table in the middle": a clause of its own is read on its own all the same; the list ends before a verb.
        let verb_before = matches!(self.piece(n + 1, end), Some(Piece::Verb(v)) if *v != Verb::Be);
        (!verb_before).then_some(n)
    }

    /// Looks, sizes and parts right after a noun: "(white, 2 m wide)", "of dark cedar", "in yellow steel", "with armrests".
    fn after_noun(&mut self, from: usize, end: usize, id: usize) -> usize {
        let mut k = from;
        let mut depth = 0;
        loop {
            match self.piece(k, end) {
                Some(Piece::Open) => depth += 1,
                Some(Piece::Close) => depth -= 1,
                Some(Piece::Attr(look)) => {
                    self.mark(k);
                    self.add_look(&[id], look);
                }
                Some(Piece::Rel(Rel::Of | Rel::In)) if matches!(self.piece(k + 1, end), Some(Piece::Attr(_))) => {
                    self.mark(k)
                }
                Some(Piece::Rel(Rel::Of))
                    if self.np(k + 1, end).is_some_and(|n| {
                        n.kind == Kind::Thing && n.det == Det::None || n.kind == Kind::Abstract && n.det == Det::None
                    }) =>
                {
                    // "a bowl of mints", "a stack of books"
                    let text: Vec<&str> = self.chunks[k + 1].at.clone().map(|t| self.tokens[t].text.as_str()).collect();
                    self.scene.items[id].look.features.push(format!("of {}", text.join(" ")));
                    self.mark(k);
                    self.mark(k + 1);
                    k += 1;
                }
                Some(Piece::Measure(m))
                    if !m.said
                        && !m.area
                        && (m.values.len() > 1 || !m.dims.is_empty())
                        && !m.dims.contains(&Dim::Ceiling) =>
                {
                    let mut dims = Vec::new();
                    super::noun::add_dims(&mut dims, &m.values, &m.dims);
                    self.scene.items[id].take_dims(&dims);
                    self.mark(k);
                }
                Some(Piece::Comma)
                    if matches!(self.piece(k + 1, end), Some(Piece::Attr(_)))
                        || matches!(self.piece(k + 1, end), Some(Piece::Measure(m)) if !m.said && !m.dims.is_empty() && !m.dims.contains(&Dim::Ceiling)) =>
                    {}
                Some(Piece::Comma | Piece::And) if depth > 0 => {}
                Some(Piece::And) if matches!(self.piece(k + 1, end), Some(Piece::Attr(_))) => {}
                Some(Piece::Np(np))
                    if depth > 0
                        && (get().part(&np.head()) || np.look != crate::draft::Look::default() && !np.known) =>
                {
                    // "(white tops, grey steel frames)"
                    self.add_look(&[id], &np.look.clone());
                    let text: Vec<&str> = self.chunks[k].at.clone().map(|t| self.tokens[t].text.as_str()).collect();
                    self.scene.items[id].look.features.push(text.join(" "));
                    self.mark(k);
                }
                Some(Piece::With)
                    if self
                        .np(k + 1, end)
                        .is_some_and(|n| n.kind == Kind::Thing && n.count.is_none() && get().part(&n.head())) =>
                {
                    let back = matches!(self.piece(k + 2, end), Some(Piece::Rel(r)) if *r != Rel::Of);
                    if back {
                        break;
                    }
                    self.near = vec![id];
                    k = self.with_part(k, end);
                    continue;
                }
                Some(Piece::Soft) if depth > 0 => self.mark(k),
                Some(Piece::Word(_) | Piece::Measure(_)) if depth > 0 => {}
                Some(Piece::Np(np)) if depth > 0 && np.kind == Kind::Abstract => {}
                _ => break,
            }
            k += 1;
        }
        k
    }

    /// "no television and no whiteboard".
    fn deny(&mut self, i: usize, end: usize) -> usize {
        let mut k = i;
        while let Some(np) = self.np(k, end).filter(|n| n.kind == Kind::Thing) {
            let at = self.bytes(k..k + 1);
            self.scene.absent.push((np.name(), at));
            self.mark(k);
            k += 1;
            while matches!(self.piece(k, end), Some(Piece::And | Piece::Comma)) {
                k += 1;
            }
        }
        // Where it must not be says nothing more.
        while k < end && !matches!(self.chunks[k].piece, Piece::Comma | Piece::And) {
            self.mark(k);
            k += 1;
        }
        self.s.not = false;
        k
    }

    /// What a group of things is in its sentence.
    fn place_group(&mut self, group: &[usize], new_from: usize, each: bool) {
        let fresh: Vec<usize> = group.iter().copied().filter(|g| *g >= new_from).collect();
        match std::mem::replace(&mut self.s.expect, Expect::Nothing) {
            Expect::With(owner, join) if !owner.is_empty() => {
                let per = self.s.each || owner.iter().any(|o| self.scene.items[*o].many);
                if per && owner.len() == 1 {
                    self.multiply(&fresh, owner[0]);
                }
                self.join(&owner, &fresh, join);
                self.s.expect = Expect::With(owner, join);
                self.near = group[group.len() - 1..].to_vec();
            }
            Expect::Object(rel) if !self.main.is_empty() => {
                let of = self.main.clone();
                self.relate(&of, rel, group);
                self.near = group.to_vec();
            }
            expect => {
                if let Expect::With(..) = expect {
                    self.s.listed = true;
                }
                if !self.main.is_empty() {
                    self.before = std::mem::take(&mut self.main);
                }
                self.main = group.to_vec();
                self.near = if group.len() > 1 && !self.s.verb { vec![group[group.len() - 1]] } else { group.to_vec() };
                self.s.subject = true;
                self.s.verb = false;
                self.s.each = each;
                self.s.last = None;
                self.apply_lead();
            }
        }
    }

    /// So many of these for each of the owner's.
    fn multiply(&mut self, fresh: &[usize], owner: usize) {
        for f in fresh {
            let item = &mut self.scene.items[*f];
            let own = item.count.unwrap_or(1);
            if *f != owner && item.per.is_none() {
                item.per = Some((owner, own));
                item.many = true;
            }
        }
    }

    /// Relations said before the subject came.
    fn apply_lead(&mut self) {
        let lead = std::mem::take(&mut self.s.lead);
        let of = self.main.clone();
        let fresh: Vec<usize> = of.clone();
        for (rel, to) in &lead {
            match to {
                Lead::Items(items, each) => {
                    if *each && items.len() == 1 {
                        self.multiply(&fresh, items[0]);
                    }
                    self.relate(&of, *rel, items);
                }
                Lead::Place(place, which) => self.at_place(&of, *rel, *place, which),
            }
        }
        // "its left" in the next clause is of what this one was said to be at.
        if let Some((_, Lead::Items(items, _))) = lead.last() {
            self.before = items.clone();
        }
    }

    /// Things that come with another.
    fn join(&mut self, owner: &[usize], things: &[usize], join: Join) {
        for t in things {
            let (group, owner_group) = (self.scene.items[*t].group, self.scene.items[owner[owner.len() - 1]].group);
            let usual = match group {
                Group::Top | Group::Screen if !matches!(owner_group, Group::Seat) => Some(Rel::On),
                Group::Soft => Some(Rel::On),
                Group::Seat if matches!(owner_group, Group::Table) => {
                    if self.scene.items[owner[0]].head().contains("desk") {
                        Some(Rel::InFrontOf)
                    } else {
                        Some(Rel::Around)
                    }
                }
                Group::Seat => Some(Rel::Near),
                Group::Flat => Some(Rel::Under),
                Group::Ceiling => Some(Rel::Above),
                Group::Table | Group::Storage | Group::Floor => Some(Rel::Beside),
                _ => None,
            };
            let rel = match join {
                Join::Usual => usual.map(|r| (r, false)),
                Join::On => Some((Rel::On, false)),
                Join::Beside => Some((Rel::Beside, true)),
                Join::Around => Some((Rel::Around, true)),
                Join::Above => Some((Rel::Above, true)),
            };
            // A relation in words replaces the usual one: it is dropped again where one follows.
            if let Some((rel, _)) = rel {
                self.relate(&[*t], rel, owner);
            }
        }
    }

    // ---- Verbs ----

    fn on_verb(&mut self, i: usize, verb: Verb) {
        let after = self.main.clone();
        match verb {
            Verb::Be | Verb::Keep => {
                self.s.verb = true;
                if !self.main.is_empty() && self.s.subject {
                    self.near = self.main.clone();
                }
                if verb == Verb::Keep {
                    self.s.expect = Expect::Nothing;
                }
            }
            Verb::Have | Verb::Carry => {
                let owner = if self.s.each || self.s.subject || self.s.verb { after } else { vec![] };
                let owner = if owner.is_empty() && !self.s.of_room && i > 0 && !self.near.is_empty() {
                    self.near.clone()
                } else {
                    owner
                };
                // "the room has", "we have": nothing that owns.
                let of_room = self.s.of_room && !self.s.subject || owner.is_empty();
                let join = if verb == Verb::Carry { Join::On } else { Join::Usual };
                self.s.expect = if of_room { Expect::Nothing } else { Expect::With(owner, join) };
                self.s.listed = true;
            }
            Verb::Face => self.s.expect = Expect::Object(Rel::Facing),
            Verb::Light => {
                let passive = self.tokens[self.chunks[i].at.start].is("lit") || self.chunks[i].at.len() > 1;
                self.s.expect =
                    if passive { Expect::With(self.near.clone(), Join::Above) } else { Expect::Object(Rel::Above) };
            }
            Verb::Cover => self.s.expect = Expect::Object(Rel::On),
            Verb::Hang => {
                self.s.hang = true;
                self.s.verb = true;
                if !self.main.is_empty() {
                    self.near = self.main.clone();
                }
            }
            Verb::Flank | Verb::Surround => {
                let passive = self.chunks[i].at.len() > 1;
                let (join, rel) =
                    if verb == Verb::Flank { (Join::Beside, Rel::Beside) } else { (Join::Around, Rel::Around) };
                self.s.expect = if passive { Expect::With(self.near.clone(), join) } else { Expect::Object(rel) };
                self.s.each = self.s.each || passive && self.near.first().is_some_and(|n| self.scene.items[*n].many);
            }
            Verb::Lead => {}
        }
        if verb != Verb::Be {
            self.mark(i);
        }
    }

    // ---- Relations ----

    fn on_rel(&mut self, i: usize, end: usize, rel: Rel) -> usize {
        // "in dark green felt"
        if matches!(rel, Rel::In | Rel::Of) && matches!(self.piece(i + 1, end), Some(Piece::Attr(_))) {
            return i + 1;
        }
        let negative = std::mem::take(&mut self.s.not) && !(self.s.pending.is_some());
        let Some((object, next)) = self.object(i + 1, end, rel) else {
            if rel == Rel::Between && self.np(i + 1, end).is_some_and(|n| n.kind == Kind::Abstract) {
                // "between the rows"
                match self.s.pending.take() {
                    Some(m) => {
                        self.mark(i);
                        self.rows(&m);
                    }
                    None => self.s.lead.push((rel, Lead::Place(Place::Row, vec![]))),
                }
                return i + 2;
            }
            return i + 1;
        };
        if rel == Rel::Of && !matches!(object, Lead::Place(..)) && self.s.pending.is_none() {
            return next;
        }
        let before_subject = !self.s.subject && self.s.pending.is_none() && !self.s.keep;
        // "hangs from", "faces": said of what the sentence is about.
        let verbal = get().verb(&self.tokens[self.chunks[i].at.start..self.chunks[i].at.start + 1]).is_some()
            && !self.main.is_empty()
            && self.tokens[self.chunks[i].at.start].text.ends_with('s');
        if verbal {
            self.near = self.main.clone();
            self.s.expect = Expect::Nothing;
        }
        let of = self.subject(i);
        match object {
            Lead::Items(items, each) => {
                self.mark(i);
                if let Some(m) = self.s.pending.take() {
                    self.measured(&of, rel, &items, &m, negative);
                } else if before_subject
                    || of.is_empty()
                    || self.preposed(i, next, end)
                    || rel == Rel::Between && items.len() == 1 && self.measure_follows(next, end)
                {
                    self.s.lead.push((rel, Lead::Items(items, each)));
                } else {
                    if each && items.len() == 1 && !self.s.one {
                        let fresh: Vec<usize> = of
                            .iter()
                            .copied()
                            .filter(|o| self.scene.items[*o].at.start >= self.s.at.start && !items.contains(o))
                            .collect();
                        self.multiply(&fresh, items[0]);
                    }
                    if negative {
                        let (soft, at) = (self.s.soft, self.s.at.clone());
                        self.scene.say(&of, What::Rel(rel, items), soft, true, at);
                    } else {
                        let sides = self.chunks[i]
                            .at
                            .clone()
                            .any(|t| matches!(self.tokens[t].text.as_str(), "each" | "either" | "both"));
                        if sides && rel == Rel::Beside {
                            self.double();
                        }
                        let fresh = items.iter().all(|o| self.scene.items[*o].at.start >= self.bytes(i..i + 1).start);
                        self.drop_usual(&of);
                        self.relate(&of, rel, &items);
                        // "a lamp on a table next to the sofa": the table is next to the sofa.
                        self.near = if fresh { items } else { of };
                    }
                }
            }
            Lead::Place(place, which) => {
                self.mark(i);
                if let Some(m) = self.s.pending.take() {
                    match place {
                        Place::Row => self.rows(&m),
                        Place::Floor => self.say(&of, What::Height(m.op, m.values[0])),
                        _ => self.say(&of, What::Wall(flip(&m, self.s.nothing), m.values[0])),
                    }
                } else if before_subject || of.is_empty() || self.preposed(i, next, end) {
                    self.s.lead.push((rel, Lead::Place(place, which)));
                } else if negative {
                    // Not at a wall, not in a corner: kept as a note.
                    self.chunks[i].at.clone().for_each(|t| self.used[t] = false);
                } else {
                    self.drop_usual(&of);
                    self.at_place(&of, rel, place, &which);
                }
            }
        }
        next
    }

    /// What a relation speaks of, and the next chunk. Rooms change what the sentence is about.
    fn object(&mut self, from: usize, end: usize, rel: Rel) -> Option<(Lead, usize)> {
        let chunks = self.chunks;
        let mut k = from;
        while matches!(self.piece(k, end), Some(Piece::Word(false) | Piece::Soft))
            && !self.tokens[chunks[k].at.start].is("so")
        {
            k += 1;
        }
        let np = self.np(k, end)?;
        match np.kind {
            Kind::Thing => {
                let id = self.resolve(k, np, true)?;
                self.mark(k);
                self.recent.push(id);
                let mut items = vec![id];
                let mut next = self.after_noun(k + 1, end, id);
                let mut each = np.det == Det::Each && np.count.is_none();
                // More objects: "between the sofa and the tv", "next to the fridge and the stove".
                while let Some(n) = self.more_objects(next, end, rel, items.len()) {
                    let Some(np) = self.np(n, end) else { break };
                    let Some(id) = self.resolve(n, np, true) else { break };
                    self.mark(n);
                    self.recent.push(id);
                    items.push(id);
                    each |= np.det == Det::Each;
                    next = self.after_noun(n + 1, end, id);
                }
                Some((Lead::Items(items, each), next))
            }
            Kind::Pronoun => {
                let word = np.words.first().map_or("", String::as_str);
                let items = self.their(word, np.det == Det::Each);
                if items.is_empty() {
                    return None;
                }
                self.mark(k);
                Some((Lead::Items(items, np.det == Det::Each || word == "each"), k + 1))
            }
            Kind::Room => {
                let room = self.rooms.spoken.get(&k).copied();
                if let Some(room) = room {
                    self.s.rooms.push(room);
                    self.s.room_last = true;
                }
                if self.s.centre && !self.near.is_empty() {
                    let of = self.near.clone();
                    self.at_place(&of, Rel::In, Place::Middle, &[]);
                }
                if rel == Rel::In || rel == Rel::At {
                    if let Some(room) = room.filter(|_| !self.s.doors) {
                        self.to_room(room);
                        self.mark(k);
                    }
                }
                if let (Rel::To | Rel::In, Some(room)) = (rel, room)
                    && self.s.doors
                    && !self.s.of_room
                {
                    self.room = room;
                    self.s.of_room = true;
                    self.mark(k);
                }
                None
            }
            Kind::Place(place) => {
                self.mark(k);
                Some(self.place_object(k, end, place, np))
            }
            Kind::Abstract => None,
        }
    }

    /// "the end of the counter" is on the counter, "the corner of the room" is of the room; "the wall opposite the door".
    fn place_object(&mut self, k: usize, end: usize, place: Place, np: &Np) -> (Lead, usize) {
        let mut which = np.which.clone();
        if np.det == Det::Each || np.many {
            which.push("each".into());
        }
        let mut next = k + 1;
        if matches!(self.piece(next, end), Some(Piece::Rel(Rel::Of))) {
            match self.np(next + 1, end).map(|n| (n.kind, n)) {
                Some((Kind::Room, _)) => {
                    if let Some(room) = self.rooms.spoken.get(&(next + 1)).copied() {
                        self.s.rooms.push(room);
                        if !self.s.of_room {
                            self.to_room(room);
                        }
                    }
                    self.mark(next);
                    self.mark(next + 1);
                    next += 2;
                }
                Some((Kind::Thing, np))
                    if !matches!(place, Place::Wall | Place::Corner | Place::Ceiling | Place::Floor) =>
                {
                    if let Some(id) = self.resolve(next + 1, np, true) {
                        self.mark(next);
                        self.mark(next + 1);
                        let rel = match place {
                            Place::Side | Place::Head => Some(Rel::Beside),
                            Place::Foot | Place::Front => Some(Rel::InFrontOf),
                            Place::Back => Some(Rel::Behind),
                            Place::End | Place::Middle => Some(Rel::On),
                            _ => None,
                        };
                        if rel.is_some() {
                            if place == Place::Side && which.iter().any(|w| w == "each") {
                                self.double();
                            }
                            return (Lead::Items(vec![id], np.det == Det::Each), next + 2);
                        }
                        next += 2;
                    }
                }
                Some((Kind::Pronoun, np)) => {
                    let items = self.their(np.words.first().map_or("", String::as_str), np.det == Det::Each);
                    self.mark(next + 1);
                    if !items.is_empty()
                        && !matches!(place, Place::Wall | Place::Corner | Place::Ceiling | Place::Floor)
                    {
                        if place == Place::Side && which.iter().any(|w| w == "each") {
                            self.double();
                        }
                        return (Lead::Items(items, np.det == Det::Each), next + 2);
                    }
                    next += 2;
                }
                _ => {}
            }
        }
        (Lead::Place(place, which), next)
    }

    fn measure_follows(&self, from: usize, end: usize) -> bool {
        self.chunks[from..end]
            .iter()
            .take_while(|c| c.piece != Piece::Comma)
            .any(|c| matches!(c.piece, Piece::Measure(_)))
    }

    /// "…, and behind it a mirror hangs": a relation that its subject follows.
    fn preposed(&self, i: usize, next: usize, end: usize) -> bool {
        let joined = i > 0 && matches!(self.chunks[i - 1].piece, Piece::And | Piece::Comma);
        let after = if matches!(self.piece(next, end), Some(Piece::Verb(Verb::Be | Verb::Hang) | Piece::There)) {
            next + 1
        } else {
            next
        };
        let fresh = |n: &Np| n.kind == Kind::Thing && matches!(n.det, Det::Indefinite | Det::Number | Det::None);
        joined && self.np(after, end).is_some_and(fresh)
    }

    /// "a nightstand on each side": two of them.
    fn double(&mut self) {
        for o in self.near.clone() {
            let item = &mut self.scene.items[o];
            if item.count == Some(1) && item.per.is_none() {
                item.count = Some(2);
                item.many = true;
            }
        }
    }

    fn to_room(&mut self, room: usize) {
        // What this sentence has brought in so far is in that room.
        let start = self.s.at.start;
        for item in self.scene.items.iter_mut().filter(|i| i.at.start >= start) {
            item.room = room;
        }
        self.room = room;
    }

    /// Another object after "and": a definite one, or anything where two are needed.
    fn more_objects(&self, k: usize, end: usize, rel: Rel, so_far: usize) -> Option<usize> {
        if !matches!(self.piece(k, end), Some(Piece::And)) {
            return None;
        }
        let np = self.np(k + 1, end).filter(|n| n.kind == Kind::Thing)?;
        if rel == Rel::Between {
            return (so_far < 2).then_some(k + 1);
        }
        let alone =
            matches!(self.piece(k + 2, end), None | Some(Piece::Comma | Piece::Stop | Piece::Line | Piece::Close));
        let known = np.det == Det::Definite
            || np.det == Det::None && np.count.is_none() && self.scene.find(np, self.room).is_some();
        (alone && known).then_some(k + 1)
    }

    fn their(&self, word: &str, each: bool) -> Vec<usize> {
        if matches!(word, "them" | "these" | "those" | "both" | "all" | "ones" | "each") || each {
            // Not what is being placed, if it is new: "three bean bags and a toy train next to them".
            let owner = match &self.s.expect {
                Expect::With(owner, _) => owner.clone(),
                _ => vec![],
            };
            let many = |l: &[usize]| l.len() > 1 || l.iter().any(|i| self.scene.items[*i].many);
            if many(&owner) {
                return owner;
            }
            let subject = self.near.clone();
            for list in [&self.before, &self.main] {
                if many(list) && *list != subject {
                    return list.clone();
                }
            }
            if let Some(i) = self.recent.iter().rev().find(|i| self.scene.items[**i].many && !subject.contains(i)) {
                return vec![*i];
            }
        }
        if let Expect::With(owner, _) = &self.s.expect
            && !owner.is_empty()
        {
            return owner.clone();
        }
        let subject = self.near.clone();
        // "a long table, eight chairs around it"
        if self.s.subject
            && subject != self.main
            && let Some(other) = self.main.iter().rev().find(|m| !subject.contains(m))
        {
            return vec![*other];
        }
        // "a telephone on the desk, and a chair behind it"
        let small = |l: &[usize]| {
            l.len() > 1
                || l.iter().any(|i| {
                    self.scene.items[*i].many
                        || matches!(self.scene.items[*i].group, Group::Top | Group::Soft | Group::Flat)
                })
        };
        if self.s.subject
            && !self.s.object.is_empty()
            && small(&self.before)
            && !small(&self.s.object)
            && self.s.object != subject
        {
            return self.s.object.clone();
        }
        if self.s.subject && !self.before.is_empty() {
            return self.before.clone();
        }
        let own: &[usize] = if self.s.subject { &self.main } else { &[] };
        self.recent.iter().rev().find(|i| !own.contains(i)).map(|i| vec![*i]).unwrap_or_default()
    }

    /// "to its left", "on top", "between them".
    fn on_its(&mut self, i: usize, end: usize, rel: Rel) {
        let text: Vec<&str> = self.chunks[i].at.clone().map(|t| self.tokens[t].text.as_str()).collect();
        let many = text.contains(&"them");
        let object = if rel == Rel::Between {
            let list = if self.main.len() > 1 || !self.s.subject { self.main.clone() } else { self.before.clone() };
            let pair = |l: &[usize]| l.len() > 1 || l.iter().any(|i| self.scene.items[*i].many);
            if pair(&list) {
                list
            } else {
                let own: &[usize] = if self.s.subject { &self.main } else { &[] };
                let mut last: Vec<usize> = Vec::new();
                for r in self.recent.iter().rev() {
                    if !own.contains(r) && !last.contains(r) && last.len() < 2 {
                        last.push(*r);
                    }
                }
                last.reverse();
                last
            }
        } else if self.s.subject && self.preposed(i, i + 1, end) && !self.main.is_empty() {
            // "a table, and on it a bowl"
            self.main.clone()
        } else if self.s.pending.is_some() && self.s.keep && !self.main.is_empty() {
            self.main.clone()
        } else if self.s.subject || matches!(self.s.expect, Expect::With(..)) {
            self.their(if many { "them" } else { "it" }, false)
        } else if many {
            self.them()
        } else {
            let front = if self.before.is_empty() {
                self.recent.last().map(|r| vec![*r]).unwrap_or_default()
            } else {
                self.before.clone()
            };
            front
        };
        if object.is_empty() {
            return;
        }
        let of: Vec<usize> = if self.s.subject { self.subject(i) } else { vec![] };
        if let Some(m) = self.s.pending.take() {
            if self.s.keep || self.s.nothing {
                self.clear(&object, rel, m.values[0]);
            } else {
                self.measured(&of, rel, &object, &m, false);
            }
            return;
        }
        let not = std::mem::take(&mut self.s.not);
        if of.is_empty() || of == object || self.preposed(i, i + 1, end) {
            self.s.lead.push((rel, Lead::Items(object, false)));
        } else if not {
            let (soft, at) = (self.s.soft, self.s.at.clone());
            self.scene.say(&of, What::Rel(rel, object), soft, true, at);
        } else {
            if text.contains(&"either") || text.contains(&"both") || text.contains(&"each") {
                self.double();
            }
            self.drop_usual(&of);
            self.relate(&of, rel, &object);
        }
    }

    /// The usual relation of things to their owner gives way to the one in words.
    fn drop_usual(&mut self, of: &[usize]) {
        if let Expect::With(owner, Join::Usual) = &self.s.expect {
            let at = &self.s.at;
            self.scene.facts.retain(|f| {
                !(f.of.len() == 1
                    && of.contains(&f.of[0])
                    && f.at == *at
                    && matches!(&f.what, What::Rel(_, o) if o == owner)
                    && !f.not)
            });
        }
    }

    /// Says a relation.
    fn relate(&mut self, of: &[usize], rel: Rel, to: &[usize]) {
        let of: Vec<usize> = of.iter().copied().filter(|o| !to.contains(o) || to.len() == 1 && of.len() == 1).collect();
        if of.is_empty() {
            return;
        }
        // Nothing lies on what lies on it.
        let back = |f: &super::scene::Fact| matches!(&f.what, What::Rel(r, o) if *r == rel && *o == of && f.of == to && !f.not);
        if of == to
            || matches!(rel, Rel::On | Rel::Under | Rel::In | Rel::Above)
                && self.scene.facts.iter().rev().take(8).any(back)
        {
            return;
        }
        self.say(&of, What::Rel(rel, to.to_vec()));
        self.s.object = to.to_vec();
        if rel == Rel::On {
            self.s.shared = Some((rel, to.to_vec()));
        }
        self.s.last = Some((of, rel, to.to_vec()));
    }

    fn at_place(&mut self, of: &[usize], rel: Rel, place: Place, which: &[String]) {
        match place {
            Place::Row => self.say(of, What::Pattern(Pattern::Row)),
            Place::Circle => self.say(of, What::Pattern(Pattern::Circle)),
            Place::Side | Place::End | Place::Head | Place::Foot if which.iter().any(|w| w == "each") => {
                // "on each side": of what was spoken of before.
                let to = self.before.clone();
                if !to.is_empty() {
                    self.relate(of, Rel::Beside, &to);
                }
            }
            _ => {
                let hangs = self.s.hang && place == Place::Wall && rel != Rel::In;
                self.say(of, What::Place(if hangs { Rel::Mounted } else { rel }, place, which.to_vec()));
            }
        }
        self.s.last = None;
    }

    // ---- Measures ----

    fn on_measure(&mut self, i: usize, end: usize, m: &Measure) -> usize {
        self.mark(i);
        let after_room = self.s.of_room && !self.s.subject || self.s.room_last;
        if m.dims.contains(&Dim::Ceiling) {
            let room = self.room;
            self.room_dim(room, Dim::Ceiling, m.values[0]);
            return i + 1;
        }
        if m.area {
            let room = self.room;
            self.scene.rooms[room].area = Some(m.values[0]);
            return i + 1;
        }
        let sized = m.values.len() > 1 || !m.dims.is_empty();
        if self.s.path && m.dims == [Dim::Width] || self.s.path && m.dims.is_empty() && self.path_follows(i) {
            return self.on_path(i, end, m);
        }
        if sized
            && self.s.keep
            && matches!(
                self.piece(i + 1, end),
                Some(Piece::Verb(Verb::Keep) | Piece::ToIts(_) | Piece::Rel(Rel::InFrontOf))
            )
        {
            // "a free area of 1 m by 1 m in front of it"
            self.s.pending = Some(m.clone());
            return i + 1;
        }
        if sized {
            self.on_size(m, after_room);
            return i + 1;
        }
        // A single length: what comes next says of what.
        let mut k = i + 1;
        loop {
            match self.piece(k, end) {
                Some(Piece::Rel(Rel::Of))
                    if self.np(k + 1, end).is_some_and(|n| n.kind == Kind::Abstract)
                        || matches!(self.piece(k + 1, end), Some(Piece::Free | Piece::Word(_))) =>
                {
                    k += 1
                }
                Some(Piece::Np(np)) if np.kind == Kind::Abstract => k += 1,
                Some(Piece::Word(_)) if k < i + 4 => k += 1,
                Some(Piece::Verb(Verb::Be | Verb::Keep))
                    if matches!(self.piece(k + 1, end), Some(Piece::Verb(_) | Piece::Free | Piece::Word(_)))
                        && self.s.keep =>
                {
                    k += 1
                }
                Some(Piece::Verb(Verb::Keep)) => k += 1,
                _ => break,
            }
        }
        self.s.pending = Some(m.clone());
        match self.piece(k, end) {
            Some(Piece::Rel(_) | Piece::Apart | Piece::Free | Piece::ToIts(_)) => {}
            _ => {
                let at = i > 0 && matches!(self.chunks[i - 1].piece, Piece::Rel(Rel::At))
                    || i > 1 && matches!(self.chunks[i - 2].piece, Piece::Rel(Rel::At));
                self.s.pending = None;
                let of = self.subject(i);
                let between = self.s.lead.iter().rposition(|(r, _)| matches!(r, Rel::Between | Rel::From));
                if let Some(lead) = between {
                    match self.s.lead.remove(lead) {
                        (rel, Lead::Items(items, _)) => self.measured(&[], rel, &items, m, false),
                        _ => self.rows(m),
                    }
                } else if let Some((of, rel, to)) = self.s.last.clone() {
                    self.distance(&of, rel, &to, m);
                } else if at && !of.is_empty() {
                    self.say(&of, What::Height(m.op, m.values[0]));
                } else if !of.is_empty() && !m.said {
                    for o in of {
                        self.scene.items[o].take_dims(&[(Dim::Length, m.values[0])]);
                    }
                } else {
                    self.chunks[i].at.clone().for_each(|t| self.used[t] = false);
                }
            }
        }
        k
    }

    fn path_follows(&self, i: usize) -> bool {
        self.chunks[i]
            .at
            .clone()
            .chain(self.chunks[i].at.end..(self.chunks[i].at.end + 3).min(self.tokens.len()))
            .any(|t| matches!(self.tokens[t].text.as_str(), "aisle" | "path" | "walkway" | "passage"))
    }

    /// A way so wide: to what the sentence speaks of, from its door.
    fn on_path(&mut self, i: usize, end: usize, m: &Measure) -> usize {
        let mut items: Vec<usize> = Vec::new();
        let mut lead: Vec<usize> = self
            .s
            .lead
            .iter()
            .flat_map(|(_, l)| if let Lead::Items(items, _) = l { items.clone() } else { vec![] })
            .collect();
        items.append(&mut lead);
        items.extend(self.main.iter().copied().filter(|_| self.s.subject));
        if let Some((of, _, to)) = &self.s.last {
            items.extend(of.iter().chain(to));
        }
        let mut k = i + 1;
        while k < end {
            if let Some(np) = self.np(k, end)
                && np.kind == Kind::Thing
                && let Some(id) = self.scene.find(np, self.room)
            {
                items.push(id);
                self.mark(k);
            }
            k += 1;
        }
        items.dedup();
        self.s.lead.clear();
        match items.as_slice() {
            [] => self.chunks[i].at.clone().for_each(|t| self.used[t] = false),
            [one] => {
                let door = self.scene.items.iter().position(|it| it.group == Group::Door);
                match door {
                    Some(d) if d != *one => self.say(&[*one], What::Path(m.values[0], vec![d])),
                    _ => self.say(&[*one], What::Among(Op::Least, m.values[0])),
                }
            }
            [a, rest @ ..] => {
                let between = self.chunks[i + 1..end].iter().any(|c| c.piece == Piece::Rel(Rel::Between));
                let what = if between {
                    What::Gap(Op::Least, m.values[0], rest.to_vec())
                } else {
                    What::Path(m.values[0], rest.to_vec())
                };
                self.say(&[*a], what);
            }
        }
        end
    }

    /// Sizes of what was spoken of, or of the room.
    fn on_size(&mut self, m: &Measure, of_room: bool) {
        let mut dims = Vec::new();
        super::noun::add_dims(&mut dims, &m.values, &m.dims);
        let limit = m.said;
        if of_room || self.near.is_empty() && self.main.is_empty() && !self.s.subject && self.before.is_empty() {
            let room = self.room;
            // What was said first stands: "1 m by 1 m" later on is of something else.
            let size = self.scene.rooms[room].size;
            let whole = m.values.len() > 1 && size[0].is_some() && size[2].is_some();
            for (dim, value) in dims.into_iter().filter(|_| !whole && !limit) {
                self.room_dim(room, dim, value);
            }
            return;
        }
        let of = if self.near.is_empty() {
            if self.main.is_empty() { self.before.clone() } else { self.main.clone() }
        } else {
            self.near.clone()
        };
        if limit {
            let (dim, mut op) = (dims[0].0, m.op);
            // "no gondola may be higher than 1.4 m", "a cupboard taller than 1.8 m shall not stand …"
            if self.s.not || self.s.nothing {
                op = match op {
                    Op::Least => Op::Most,
                    Op::Most => Op::Least,
                    Op::Equal => Op::Equal,
                };
            }
            self.say(&of, What::Size(dim, op, dims[0].1));
        } else {
            for o in of {
                self.scene.items[o].take_dims(&dims);
            }
        }
    }

    /// "90 cm clear in front of it", "a metre free on either side".
    fn on_free(&mut self, i: usize, end: usize) -> usize {
        let mut k = i + 1;
        while matches!(self.piece(k, end), Some(Piece::Word(_) | Piece::Rel(Rel::Of)))
            || self.np(k, end).is_some_and(|n| n.kind == Kind::Abstract)
        {
            if let Some(Piece::Rel(Rel::Of)) = self.piece(k, end)
                && matches!(self.piece(k + 1, end), Some(Piece::Measure(_)))
            {
                k += 1;
                break;
            }
            k += 1;
        }
        if let Some(Piece::Measure(m)) = self.piece(k, end) {
            self.s.pending = Some(m.clone());
            self.mark(k);
            k += 1;
            while self.np(k, end).is_some_and(|n| n.kind == Kind::Abstract)
                || matches!(self.piece(k, end), Some(Piece::Word(_) | Piece::Verb(Verb::Be | Verb::Keep)))
            {
                k += 1;
            }
        }
        self.mark(i);
        k
    }

    /// A relation with a measure.
    fn measured(&mut self, of: &[usize], rel: Rel, to: &[usize], m: &Measure, not: bool) {
        let keep = self.s.keep || self.s.nothing;
        match rel {
            Rel::Between => {
                let m = Measure { op: flip(m, not || self.s.nothing), ..m.clone() };
                match to {
                    [a, rest @ ..] if !rest.is_empty() => {
                        self.say(&[*a], What::Gap(min_if_keep(&m, self.s.keep), m.values[0], rest.to_vec()))
                    }
                    [one, ..] => {
                        let what = What::Among(min_if_keep(&m, self.s.keep), m.values[0]);
                        self.say(&[*one], what);
                    }
                    [] => {}
                }
            }
            Rel::InFrontOf | Rel::Behind | Rel::LeftOf | Rel::RightOf | Rel::Above | Rel::Around | Rel::Beside
                if keep =>
            {
                self.clear(to, rel, m.values[0])
            }
            Rel::Of | Rel::From | Rel::To | Rel::Far | Rel::Near | Rel::Than
                if self.s.nothing && of.is_empty() || self.s.nothing && of == to =>
            {
                self.say(to, What::Alone(m.values[0]));
            }
            _ => {
                if of.is_empty() {
                    return;
                }
                let negative = not || self.s.nothing || self.s.not;
                self.distance(of, rel, to, &Measure { op: flip(m, negative), ..m.clone() });
            }
        }
    }

    fn distance(&mut self, of: &[usize], rel: Rel, to: &[usize], m: &Measure) {
        let of: Vec<usize> = of.iter().copied().filter(|o| !to.contains(o)).collect();
        if of.is_empty() {
            return;
        }
        if !matches!(rel, Rel::From | Rel::Of | Rel::To | Rel::Far | Rel::Near | Rel::At | Rel::Than) {
            self.relate(&of, rel, to);
        }
        self.say(&of, What::Gap(m.op, m.values[0], to.to_vec()));
    }

    fn among(&mut self, m: &Measure) {
        let of = if self.main.is_empty() { self.before.clone() } else { self.main.clone() };
        let op = flip(m, self.s.not || self.s.nothing);
        match of.as_slice() {
            [a, rest @ ..] if !rest.is_empty() => self.say(&[*a], What::Gap(op, m.values[0], rest.to_vec())),
            [_, ..] => self.say(&of, What::Among(op, m.values[0])),
            [] => {}
        }
    }

    /// A distance between rows.
    fn rows(&mut self, m: &Measure) {
        let op = min_if_keep(&Measure { op: flip(m, self.s.not || self.s.nothing), ..m.clone() }, true);
        let of = if self.main.is_empty() { self.before.clone() } else { self.main.clone() };
        let many = of.iter().copied().find(|o| self.scene.items[*o].many);
        let rows =
            self.scene.facts.iter().rev().find(|f| matches!(f.what, What::Pattern(Pattern::Rows(_)))).map(|f| f.of[0]);
        if let Some(item) = rows.or(many) {
            self.say(&[item], What::Rows(op, m.values[0]));
        }
    }

    fn clear(&mut self, of: &[usize], rel: Rel, depth: f64) {
        let side = match rel {
            Rel::Behind => Side::Behind,
            Rel::LeftOf => Side::Left,
            Rel::RightOf => Side::Right,
            Rel::Above => Side::Above,
            Rel::Around | Rel::Beside => Side::Around,
            _ => Side::Front,
        };
        self.say(of, What::Clear(side, depth));
    }

    /// What is left when a sentence ends: relations whose subject was in the one before.
    fn finish(&mut self) {
        if !self.s.lead.is_empty() && !self.s.subject && !self.s.unknown && !self.before.is_empty() {
            self.main = self.before.clone();
            self.apply_lead();
        }
        self.s.pending = None;
        // "a scale on the counter, and a basket": on the counter too.
        if let Some((rel, to)) = self.s.shared.take() {
            let start = self.s.at.start;
            let bare = |i: &usize| {
                let item = &self.scene.items[*i];
                item.at.start >= start
                    && !to.contains(i)
                    && !self.scene.facts.iter().any(|f| f.of.contains(i))
                    && matches!(item.group, Group::Top | Group::Floor | Group::Soft)
                    && {
                        let [w, _, d] = super::sizes::usual(item.group, &item.words);
                        w * d < 0.3
                    }
            };
            let of: Vec<usize> = self.main.iter().copied().filter(bare).collect();
            self.relate(&of, rel, &to);
        }
    }
}

impl Sentence {
    fn new(at: Range<usize>) -> Self {
        Self {
            at,
            subject: false,
            lead: vec![],
            expect: Expect::Nothing,
            soft: false,
            not: false,
            keep: false,
            nothing: false,
            hang: false,
            path: false,
            verb: false,
            each: false,
            pending: None,
            last: None,
            listed: false,
            of_room: false,
            doors: false,
            room_last: false,
            unknown: false,
            rooms: vec![],
            from: 0,
            one: false,
            centre: false,
            object: vec![],
            shared: None,
        }
    }
}

/// "no desk closer than", "nothing within": the other way round.
fn flip(m: &Measure, negative: bool) -> Op {
    match m.op {
        Op::Most if negative => Op::Least,
        Op::Least if negative => Op::Most,
        op => op,
    }
}

/// "keep 1.2 m between them" is at least so much.
fn min_if_keep(m: &Measure, keep: bool) -> Op {
    if m.op == Op::Equal && keep { Op::Least } else { m.op }
}

/// Whether a noun can be a name: letters of a language that is written with these.
fn nameable(noun: &str) -> bool {
    noun.chars().all(|c| c.is_alphanumeric() || " -'".contains(c))
        && noun.chars().filter(|c| c.is_alphabetic()).count() > 1
        && noun.len() < 40
}
