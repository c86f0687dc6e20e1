//! Chunks → what is said: an attribute grammar that reads a sentence from left to right and carries along what it is about.

use crate::brief::{
    Brief, Dim, Fact, FactKind, Group, MOST_COUNT, MOST_THINGS, Note, Number, Op, Pattern, Pick, Place, Quantifier,
    Rel, Side, Subset, Thing, ThingOrigin,
};
use crate::read::chunk::{Chunk, ChunkPiece};
use crate::read::lexicon::{Class, Verb, get};
use crate::read::measure::Measure;
use crate::read::noun::{Det, NounKind, Np, Nth};
use crate::read::rooms::Rooms;
use crate::read::token::Token;
use parts::part_of_it;
use std::ops::Range;

mod after;
mod its;
mod joined;
mod measures;
mod mention;
mod only;
mod parts;
mod relations;
mod sentences;
mod things;
mod unsaid;
mod verbs;

/// What a noun phrase that comes next is to what came before.
#[derive(Clone, Debug, Default, PartialEq)]
enum Expect {
    /// A subject.
    #[default]
    Nothing,
    /// "a table with …", "each desk has …": things that belong to these.
    With(Vec<usize>, Join),
    /// "the sofa faces …".
    Object(Rel),
    /// "nothing blocks …".
    Blocked,
}

/// How things that come with another relate to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Join {
    /// As such things usually do.
    Usual,
    On,
    In,
    /// At its sides.
    Beside,
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
    pub brief: Brief,
    /// Things that were taken back: "no, forget the carpet".
    pub gone: Vec<usize>,
    /// For every token, whether something came of it.
    pub used: Vec<bool>,
    room: usize,
    /// That room was named after another one in the same sentence: "a bedroom and a bathroom".
    room_listed: bool,
    /// The sentence before was about the room.
    about_room: bool,
    /// It began with the room, whatever it went on to.
    room_began: bool,
    /// What the sentence is about; of the one before, if this has no subject yet.
    main: Vec<usize>,
    /// What was spoken of before that.
    before: Vec<usize>,
    /// What was mentioned last.
    near: Vec<usize>,
    /// Mentions in their order.
    recent: Vec<usize>,
    /// Several of which some were spoken of one after the other, and how many by now: "one …, the other two …".
    dealt: Option<(usize, usize)>,
    /// What the things of the sentence before were said to be on.
    carrier: Vec<usize>,
    /// What several things form: "twelve desks, which form three blocks of four".
    formed: Option<(String, usize)>,
    /// What something was said to be left or right of, in this sentence or the one before.
    side: Option<(Rel, Vec<usize>)>,
    s: Sentence,
}

/// What holds within one sentence.
#[derive(Clone, Debug, Default)]
struct Sentence {
    at: Range<usize>,
    chunks: Range<usize>,
    /// Of how many of the things on the other side the relation is said that is read.
    quantifier: Quantifier,
    /// The chunk that is read.
    now: usize,
    /// Whether the sentence has a subject of its own.
    subject: bool,
    /// Relations that came before the subject.
    lead: Vec<(Rel, Lead)>,
    /// They are denied: "not in front of the door: tables".
    lead_not: bool,
    /// On both sides: two of what comes.
    lead_twice: bool,
    /// How what comes stands.
    lead_pattern: Option<Pattern>,
    /// What a place says together with "of", in place of the relation before it.
    turned: Option<Rel>,
    expect: Expect,
    /// It is softened, from this chunk on.
    soft: bool,
    soft_from: usize,
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
    /// A measure that waits for its relation, and its chunk.
    pending: Option<Measure>,
    waits: usize,
    /// The ends of the range that was read last.
    range: Option<[f64; 2]>,
    /// The relation said last, for a measure that comes after it.
    last: Option<(Vec<usize>, Rel, Vec<usize>)>,
    /// Whether the last subject was listed as what a room has.
    listed: bool,
    /// The sentence is about a room.
    of_room: bool,
    /// And was from its beginning.
    room_first: bool,
    /// It is about rows.
    rows: bool,
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
    /// The last things of a list that another has: "with two chisels and two brushes on top" is of both.
    owned: Vec<usize>,
    /// What the sentence began with that things are on: "On the desk, …".
    frame: Option<Vec<usize>>,
    /// What comes with several things is said of them together: "two nightstands topped with a clock".
    together: bool,
    /// "centre a table in the room".
    centre: bool,
    /// What the last relation was to.
    object: Vec<usize>,
    /// What "the" brought in.
    definite: Vec<usize>,
    /// The next chunk, where more than one was read.
    skip: Option<usize>,
    /// What "it" stood for last.
    it: Vec<usize>,
    /// A group that has a relation, and the next that may share it.
    shared: Option<(Rel, Vec<usize>)>,
}

/// How much stays free where nothing may stand, in metres.
const CLEAR: f64 = 0.9;

/// What a relation at the start of a clause is to.
#[derive(Clone, Debug)]
enum Lead {
    Items(Vec<usize>, bool),
    Place(Place, Vec<String>),
}

impl<'a> Reader<'a> {
    /// A reader of a text; nothing is read yet.
    pub fn new(tokens: &'a [Token], chunks: &'a [Chunk], rooms: &'a Rooms) -> Self {
        let brief = Brief { rooms: rooms.rooms.clone(), ..Brief::default() };
        Self {
            tokens,
            chunks,
            rooms,
            brief,
            gone: vec![],
            used: vec![false; tokens.len()],
            room: 0,
            room_listed: false,
            about_room: true,
            room_began: false,
            main: vec![],
            before: vec![],
            near: vec![],
            recent: vec![],
            dealt: None,
            carrier: vec![],
            formed: None,
            side: None,
            s: Sentence::default(),
        }
    }

    /// Reads everything.
    pub fn read(&mut self) {
        let mut from = 0;
        while from < self.chunks.len() {
            let end = self.sentence_end(from);
            // "a rack behind the counter? No, …": taken back.
            let last = if self.asked_back(end) { self.last_clause(from, end) } else { end };
            if last > from {
                self.sentence(from, last);
            }
            from = end + 1;
        }
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

    fn piece(&self, i: usize, end: usize) -> Option<&'a ChunkPiece> {
        (i < end).then(|| self.chunks.get(i).map(|c| &c.piece)).flatten()
    }

    fn np(&self, i: usize, end: usize) -> Option<&'a Np> {
        if i < end { self.chunks.get(i).and_then(Chunk::np) } else { None }
    }

    fn sentence(&mut self, from: usize, end: usize) {
        let chunks = self.chunks;
        // "a table, and if possible a plant": what may be left out begins there, what was said before is not touched.
        let turns = |k: &usize| {
            let joined = matches!(chunks[k - 1].piece, ChunkPiece::And | ChunkPiece::Comma);
            chunks[*k].piece == ChunkPiece::Soft && joined && self.np(k + 1, end).is_some()
        };
        if let Some(turn) = (from + 2..end.min(chunks.len())).find(turns) {
            self.sentence(from, turn - 1);
            self.sentence(turn, end);
            return;
        }
        let from = self.moved(from, end);
        let at = self.bytes(from..end);
        self.s = Sentence { from: self.room, chunks: from..end, now: from, at, ..Sentence::default() };
        let words = &chunks[from..end.min(chunks.len())];
        // What depends on a condition is no more than a preference.
        let conditional = |c: &Chunk| c.at.clone().any(|t| self.tokens[t].is("if") || self.tokens[t].is("unless"));
        let softens = |k: &usize| chunks[*k].piece == ChunkPiece::Soft || conditional(&chunks[*k]);
        let first = (from..end.min(chunks.len())).filter(|k| !self.is_aside(*k, from, end)).find(softens);
        self.s.soft = first.is_some();
        self.s.soft_from = first.map_or(from, |soft| self.softened_from(soft, from, end));
        self.s.keep = words.iter().any(|c| matches!(c.piece, ChunkPiece::Verb(Verb::Keep) | ChunkPiece::Free));
        // "a corridor, 8 m wide" is a room.
        let is_room = |c: &Chunk| c.np().is_some_and(|np| np.kind == NounKind::Room);
        self.s.path = words.iter().filter(|c| !is_room(c)).any(|c| {
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
        self.s.doors = words.iter().any(|c| matches!(c.piece, ChunkPiece::Verb(Verb::Lead)));
        for c in words {
            if c.piece == ChunkPiece::Soft {
                self.used[c.at.clone()].fill(true);
            }
        }
        if self.heading(from, end) {
            return;
        }
        let side = self.side.clone();
        self.before = std::mem::take(&mut self.main);
        self.near.clear();
        // "no television; instead there is a piano": the piano is said as it is.
        if self.chunks.get(from).is_some_and(|c| self.tokens[c.at.start].is("instead")) {
            self.mark(from);
        }
        let ruled_out = self.neither(from, end);
        let revised = self.revised(from, end);
        let mut unsaid = match (&ruled_out, &revised) {
            (None, None) => self.unsaid(from, end),
            _ => Vec::new(),
        };
        if self.joking(end) {
            unsaid.push(from..end);
        }
        for range in &unsaid {
            let comma = usize::from(chunks[range.start].piece == ChunkPiece::Comma && range.len() > 1);
            let at = self.bytes(range.start + comma..range.end);
            let reason =
                "this part could not be translated, because no statement of the language expresses it".to_owned();
            self.brief.notes.push(Note { at, reason });
        }
        unsaid.extend(ruled_out);
        unsaid.extend(revised);
        let (mut i, facts, things) = (from, self.brief.facts.len(), self.brief.things.len());
        while i < end {
            self.s.now = i;
            i = match unsaid.iter().find(|r| r.contains(&i)) {
                Some(range) => range.end,
                None => self.step(i, end).max(i + 1),
            };
        }
        self.finish();
        self.only_these(from, end, facts);
        self.nothing_else(from, end, things);
        self.carrier = std::mem::take(&mut self.s.object);
        if self.side == side {
            self.side = None;
        }
        self.doors();
        self.about_room = self.s.of_room && !self.s.subject;
        self.room_began = self.s.of_room && self.s.room_first;
        if !self.s.subject && self.main.is_empty() {
            self.main = std::mem::take(&mut self.before);
        }
    }

    /// Whether what is read now is softened.
    fn soft(&self) -> bool {
        self.s.soft && self.s.now >= self.s.soft_from
    }

    /// Where that begins which a phrase softens: at the end of a sentence no more than what comes after the last comma, "a
    /// sofa in the corner, turned to the fire if possible".
    fn softened_from(&self, soft: usize, from: usize, end: usize) -> usize {
        let chunks = &self.chunks[..end.min(self.chunks.len())];
        let is_last = chunks[soft + 1..].iter().all(|c| matches!(c.piece, ChunkPiece::Soft | ChunkPiece::Comma));
        let comma = (from + 1..soft).rev().find(|k| chunks[*k].piece == ChunkPiece::Comma);
        comma.filter(|comma| is_last && comma + 1 < soft).map_or(from, |comma| comma + 1)
    }

    /// Whether a softening phrase ends an apposition and softens no more than that: "a table, oak if possible, with
    /// twelve chairs" asks for the chairs.
    fn is_aside(&self, soft: usize, from: usize, end: usize) -> bool {
        let chunks = &self.chunks[..end.min(self.chunks.len())];
        if chunks[soft].piece != ChunkPiece::Soft || chunks.get(soft + 1).is_none_or(|c| c.piece != ChunkPiece::Comma) {
            return false;
        }
        let Some(comma) = (from + 1..soft).rev().find(|k| chunks[*k].piece == ChunkPiece::Comma) else { return false };
        comma + 1 < soft
            && chunks[comma + 1..soft]
                .iter()
                .all(|c| matches!(c.piece, ChunkPiece::Np(_) | ChunkPiece::Attr(_) | ChunkPiece::Word(_)))
    }

    fn room_look(&mut self, room: usize, np: &Np) {
        let r = &mut self.brief.rooms[room];
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
        let size = &mut self.brief.rooms[room].size;
        match dim {
            Dim::Elevation => {}
            Dim::Width => {
                // "9 m long and 6 m wide": what was said first is how deep it is.
                if let (Some(long), None) = (size[0], size[2]) {
                    size[2] = Some(long);
                }
                size[0] = Some(value);
            }
            Dim::Height | Dim::Ceiling => size[1] = Some(value),
            Dim::Depth => size[2] = Some(value),
            Dim::Length if size[0].is_some() && size[2].is_none() => size[2] = Some(value),
            Dim::Length => size[0] = Some(value),
            Dim::Across => {
                size[0] = Some(value);
                size[2] = Some(value);
            }
        }
    }

    /// Reads one chunk, or what hangs together; the index of the next.
    fn step(&mut self, i: usize, end: usize) -> usize {
        let chunks = self.chunks;
        if let Some(next) = self.choice(i, end) {
            return next;
        }
        match &chunks[i].piece {
            ChunkPiece::Np(np) => self.on_np(i, end, np),
            ChunkPiece::Rel(rel) => self.on_rel(i, end, *rel),
            ChunkPiece::ToIts(rel) => {
                self.mark(i);
                self.on_its(i, end, *rel);
                i + 1
            }
            ChunkPiece::Verb(Verb::Have) if self.has_part(i, end) => self.with_part(i, end),
            ChunkPiece::Verb(Verb::Carry) if self.draped(i, end) => {
                self.mark(i + 1);
                i + 2
            }
            ChunkPiece::Verb(verb) => {
                self.on_verb(i, end, *verb);
                i + 1
            }
            ChunkPiece::Measure(m) => self.on_measure(i, end, m),
            ChunkPiece::With => self.on_with(i, end),
            ChunkPiece::Attr(look) => {
                let target = self.near.clone();
                if target.is_empty() && self.s.of_room {
                    self.mark(i);
                } else if !target.is_empty() {
                    self.mark(i);
                    self.add_look(&target, look);
                }
                i + 1
            }
            ChunkPiece::Pattern(pattern) => self.on_pattern(i, *pattern),
            ChunkPiece::Which if self.relative(i, end) => i + 1,
            ChunkPiece::Comma | ChunkPiece::Which => {
                if !self.main.is_empty()
                    && !matches!(self.piece(i + 1, end), Some(ChunkPiece::Attr(_) | ChunkPiece::Measure(_)))
                {
                    self.near = self.main.clone();
                }
                if chunks[i].piece == ChunkPiece::Comma {
                    self.s.not = false;
                }
                i + 1
            }
            ChunkPiece::Colon => self.on_colon(i, end),
            ChunkPiece::Open
            | ChunkPiece::Close
            | ChunkPiece::And
            | ChunkPiece::Bullet
            | ChunkPiece::Line
            | ChunkPiece::Stop => i + 1,
            ChunkPiece::There => {
                self.s.expect = Expect::Nothing;
                i + 1
            }
            ChunkPiece::Not => {
                let nothing = self.tokens[chunks[i].at.start].is("nothing");
                self.s.nothing |= nothing;
                self.s.not = !nothing;
                self.mark(i);
                i + 1
            }
            ChunkPiece::Apart => {
                self.mark(i);
                if let Some(m) = self.s.pending.take() {
                    if self.s.rows { self.rows(&m) } else { self.among(&m) }
                }
                i + 1
            }
            ChunkPiece::Free => self.on_free(i, end),
            ChunkPiece::Soft | ChunkPiece::Word(_) => self.on_word(i, end),
        }
    }

    /// "side by side", "in a row", "back to back".
    fn on_pattern(&mut self, i: usize, pattern: Pattern) -> usize {
        let chunks = self.chunks;
        self.mark(i);
        // "two cabins with curtains, side by side": of the cabins, and what comes next is not with them.
        if i > 0 && chunks[i - 1].piece == ChunkPiece::Comma && matches!(self.s.expect, Expect::With(..)) {
            self.s.expect = Expect::Nothing;
            self.near = self.main.clone();
        }
        if !self.s.subject && !self.s.lead.is_empty() {
            // "against the wall, from left to right: a fryer, a grill, …"
            self.s.lead_pattern = Some(pattern);
            return i + 1;
        }
        let of = self.subject(i);
        let one = |l: &[usize]| l.len() == 1 && self.brief.count(l[0]) == 1 && !self.brief.things[l[0]].number.many();
        let of = if one(&of) && self.main.len() > 1 { self.main.clone() } else { of };
        // "a bed along the wall and a dresser next to each other"
        let two = matches!(pattern, Pattern::SideBySide | Pattern::FaceToFace | Pattern::BackToBack);
        let new = |o: &&usize| self.brief.things[**o].source.at().start >= self.s.at.start;
        let of = match self.before.last().filter(new) {
            Some(other) if two && one(&of) => vec![*other, of[0]],
            _ => of,
        };
        // "Chairs with music stands in a circle": the chairs form it, and face something.
        let ring = match &self.s.expect {
            Expect::With(owner, Join::Usual) if matches!(pattern, Pattern::Circle | Pattern::Arc) => {
                let seats = owner.iter().all(|o| self.brief.things[*o].group == Group::Seat);
                Some(owner.clone()).filter(|_| seats && self.s.owned == of)
            }
            _ => None,
        };
        if let Some(owner) = &ring {
            self.s.expect = Expect::Nothing;
            (self.main, self.near) = (owner.clone(), owner.clone());
        }
        let of = ring.unwrap_or(of);
        // "chairs in four rows of five": twenty of them.
        if let (Pattern::Rows(Some(rows)), [item]) = (pattern, of.as_slice()) {
            let words = &self.tokens[chunks[i].at.clone()];
            let each = words.iter().position(|t| t.is("of")).and_then(|k| crate::read::number::count(&words[k + 1..]));
            let item = &mut self.brief.things[*item];
            if let (Some((each, _)), Number::Plural | Number::Unsaid) = (each, item.number)
                && each.fract() == 0.0
                && (1.0..=MOST_COUNT as f64).contains(&(rows as f64 * each))
            {
                item.number = Number::Exactly(rows * each as usize);
            }
        }
        // "a shelf with a bowl and a jar side by side": all that the shelf has.
        let listed = two && self.s.owned.len() > 1 && self.s.owned.ends_with(&of);
        let of = if listed { self.s.owned.clone() } else { of };
        let soft = self.soft();
        self.state(&of, FactKind::Pattern(pattern), soft, false);
        i + 1
    }

    /// A colon: what was denied before it is so no more, and a number alone behind it counts what stands before it.
    fn on_colon(&mut self, i: usize, end: usize) -> usize {
        // "Nobody has to squeeze: at least 1.2 m between …"
        self.s.nothing = false;
        if self.s.expect == Expect::Blocked {
            self.s.expect = Expect::Nothing;
        }
        // "each desk: a lamp, two pens": that is what each has.
        let listed = self.np(i + 1, end).is_some_and(|np| np.kind == NounKind::Thing && np.det != Det::Definite);
        if listed && self.s.each && self.s.subject && !self.s.verb && self.main.len() == 1 {
            self.s.expect = Expect::With(self.main.clone(), Join::Usual);
            return i + 1;
        }
        let alone =
            !matches!(self.piece(i + 2, end), Some(ChunkPiece::Rel(_) | ChunkPiece::ToIts(_) | ChunkPiece::Verb(_)));
        if let (Some(n), true) = (self.number_at(i + 1, end), alone && self.near.len() == 1) {
            let item = &mut self.brief.things[self.near[0]];
            if item.number.many() {
                item.number = Number::Exactly(n);
            }
            self.mark(i + 1);
            return i + 2;
        }
        i + 1
    }

    /// A word of no other kind: a number, "centrally", "forget", "nothing".
    fn on_word(&mut self, i: usize, end: usize) -> usize {
        let chunks = self.chunks;
        // "stools, two at each bench"
        let owner = self.np(i + 2, end).filter(|np| np.det == Det::Each && np.kind == NounKind::Thing);
        if let (Some(n), Some(ChunkPiece::Rel(_)), Some(owner)) =
            (self.number_at(i, end), self.piece(i + 1, end), owner)
        {
            self.s.one = true;
            let owner = self.find(owner);
            let of = self.main.last().copied().filter(|o| Some(*o) != owner);
            if let (Some(owner), Some(item)) = (owner, of.map(|o| &mut self.brief.things[o]))
                && item.number.many()
                && item.number.said().is_none()
            {
                item.number = Number::Each { of: owner, number: n };
            }
            self.near = self.main.clone();
            self.mark(i);
        }
        // "the stools, six in number"
        let at = chunks[i].at.end;
        let in_number =
            self.tokens.get(at).is_some_and(|t| t.is("in")) && self.tokens.get(at + 1).is_some_and(|t| t.is("number"));
        if let (Some(n), true, [item]) = (self.number_at(i, end), in_number, self.main.as_slice()) {
            let item = &mut self.brief.things[*item];
            if item.number.many() && item.number.said().is_none() && n > 0 {
                item.number = Number::Exactly(n);
                self.mark(i);
                self.used[at..at + 2].fill(true);
            }
        }
        // "carts stand by the door, ten in a row"
        if let (Some(n), Some(ChunkPiece::Pattern(_)), [item]) =
            (self.number_at(i, end), self.piece(i + 1, end), self.main.as_slice())
        {
            let item = &mut self.brief.things[*item];
            if item.number.many() && item.number.said().is_none() && n > 1 {
                item.number = Number::Exactly(n);
                self.mark(i);
            }
            self.near = self.main.clone();
        }
        self.s.centre |=
            matches!(self.tokens[chunks[i].at.start].text.as_str(), "center" | "centre" | "centred" | "centered");
        match self.tokens[chunks[i].at.start].text.as_str() {
            // "stands centrally", but "centrally against the wall"
            "centrally" | "centred" | "centered" if !matches!(self.piece(i + 1, end), Some(ChunkPiece::Rel(_))) => {
                let of = if self.main.is_empty() { self.near.clone() } else { self.main.clone() };
                match self.s.frame.clone() {
                    // "On the desk a monitor is centred": on the desk.
                    Some(to) => self.relate(&of, Rel::Centre, &to),
                    None => self.at_place(&of, Rel::In, Place::Middle, &[]),
                }
                self.mark(i);
            }
            // "forget the carpet"
            "forget" | "scrap" | "skip" | "omit" | "cancel" | "remove" | "delete" => {
                let np = self.np(i + 1, end).filter(|np| np.kind == NounKind::Thing);
                if let Some(np) = np {
                    self.gone.extend(self.find(np));
                    let at = self.bytes(i + 1..i + 2);
                    self.brief.absent.push((np.name(), at));
                    self.mark(i);
                    self.mark(i + 1);
                    return i + 2;
                }
            }
            "nothing" | "nobody" => self.s.nothing = true,
            // "don't put anything between …"
            "anything" if std::mem::take(&mut self.s.not) => self.s.nothing = true,
            _ => {}
        }
        i + 1
    }

    /// "either a sofa or two armchairs by the window": nobody says which; where that ends.
    fn choice(&self, i: usize, end: usize) -> Option<usize> {
        let at = self.chunks[i].at.start;
        let first = self.tokens.get(at).filter(|t| t.is("either"))?;
        let next = self.tokens.get(at + 1)?;
        let new = next.is("a") || next.is("an") || super::number::count(std::slice::from_ref(next)).is_some();
        let to = (i + 1..end).find(|k| self.chunks[*k].piece == ChunkPiece::Comma).unwrap_or(end);
        let or = self.tokens[at..self.chunks.get(to.checked_sub(1)?)?.at.end].iter().any(|t| t.is("or"));
        (first.word() && new && or).then_some(to)
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
            // What one of several looks like takes the place of what all look like.
            let all =
                self.brief.things[*i].part.as_ref().and_then(|part| self.brief.things[part.of].look.color.clone());
            let to = &mut self.brief.things[*i].look;
            if look.color.is_some() && to.color == all {
                to.color = None;
            }
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
        if let Some(owner) = self.made_for(i) {
            return vec![owner];
        }
        if i > 0 && self.reduced(i - 1).is_some() && (!self.s.each || matches!(self.s.expect, Expect::With(..))) {
            return self.near.clone();
        }
        if i > 0 && self.last_listed(i - 1).is_some() {
            return self.near.clone();
        }
        let after_comma = i > 0
            && matches!(
                self.chunks[i - 1].piece,
                ChunkPiece::Comma | ChunkPiece::Which | ChunkPiece::Verb(_) | ChunkPiece::And
            );
        let owned = matches!(self.s.expect, Expect::With(..));
        if self.s.each && !owned || after_comma && !self.main.is_empty() || self.near.is_empty() {
            if self.main.is_empty() { self.before.clone() } else { self.main.clone() }
        } else {
            self.near.clone()
        }
    }
}

impl Reader<'_> {
    /// What something is for that was named right before: "shelves for puzzles along the wall" are there, not the puzzles.
    fn made_for(&self, i: usize) -> Option<usize> {
        let owner = i.checked_sub(3)?;
        let is_for = matches!(self.chunks[i - 2].piece, ChunkPiece::Word(_)) && self.word_at(i - 2, 0) == "for";
        let content = self.np(i - 1, i).filter(|_| is_for)?;
        let is_bare = (content.kind, content.det) == (NounKind::Thing, Det::None) && content.count.is_none();
        let owner = self.np(owner, i).filter(|owner| owner.kind == NounKind::Thing && is_bare && content.many)?;
        self.find(owner)
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
    if m.op == Op::Equal && keep && !m.exact { Op::Least } else { m.op }
}

/// Whether a noun can be a name: letters of a language that is written with these.
fn nameable(noun: &str) -> bool {
    noun.chars().all(|c| c.is_alphanumeric() || " -'".contains(c))
        && noun.chars().filter(|c| c.is_alphabetic()).count() > 1
        && noun.len() < 40
}
