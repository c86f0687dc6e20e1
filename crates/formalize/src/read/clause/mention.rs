//! Noun phrases and the things of a brief: which thing a phrase speaks of again, and what a new one brings in.

use super::*;

/// In which room of a home a thing is that several of them may have, the first first.
const USUAL_ROOMS: [(&str, &[&str]); 7] = [
    ("dining table", &["dining room", "kitchen", "living room"]),
    ("table", &["dining room", "kitchen", "living room"]),
    ("sofa", &["living room"]),
    ("tv", &["living room", "bedroom"]),
    ("desk", &["study", "bedroom", "living room"]),
    ("fridge", &["kitchen"]),
    ("piano", &["living room"]),
];

impl Reader<'_> {
    /// Of how many of the things in these chunks, which are these, something is said.
    pub(super) fn quantifier(&self, chunks: Range<usize>, each: bool, of: &[usize]) -> Quantifier {
        let any = |c: &Chunk| self.tokens[c.at.start].is("any") || self.tokens[c.at.start].is("neighbouring");
        // "each table near a pillar", "near one of the pillars"
        let one = |np: &Np| np.det == Det::Indefinite && !np.many || np.nth == Some(Nth::Some) && np.count == Some(1);
        let some = matches!(of, [one] if self.brief.things[*one].number.many());
        match self.chunks.get(chunks) {
            Some(chunks) if each && !chunks.iter().any(any) => Quantifier::Each,
            Some(_) if each => Quantifier::Any,
            Some([first, ..]) if some && self.s.each && first.np().is_some_and(one) => Quantifier::Any,
            _ => Quantifier::Usual,
        }
    }

    /// Whether "no desk …" says where what there is must not be, and not that there is none.
    pub(super) fn limits(&self, mut chunks: Range<usize>, end: usize, np: &Np) -> bool {
        chunks.any(|k| match &self.chunks[k].piece {
            ChunkPiece::Measure(_) => true,
            ChunkPiece::Rel(r) if !matches!(r, Rel::In | Rel::Of | Rel::To | Rel::From | Rel::Than) => {
                let object = |n: &Np| {
                    matches!(n.kind, NounKind::Thing | NounKind::Place(Place::Wall | Place::Corner | Place::Middle))
                };
                self.np(k + 1, end).is_some_and(object) && self.find(np).is_some()
            }
            // "no desk is in a corner", where there are desks
            ChunkPiece::Rel(Rel::In) => {
                let corner = |n: &Np| matches!(n.kind, NounKind::Place(Place::Corner | Place::Middle));
                self.np(k + 1, end).is_some_and(corner) && self.find(np).is_some()
            }
            ChunkPiece::Verb(Verb::Be) => {
                self.chunks[k].at.clone().any(|t| matches!(self.tokens[t].text.as_str(), "stand" | "be" | "placed"))
                    && self.find(np).is_some()
            }
            _ => false,
        })
    }

    /// The thing that a phrase speaks of again: the last one of that name, in this room before others.
    pub(super) fn find(&self, np: &Np) -> Option<usize> {
        let lexicon = get();
        let head = np.head();
        let tail = np.words.last().cloned().unwrap_or_default();
        let score = |item: &Thing| -> u32 {
            let same_head = item.head() == head;
            let same_tail = item.words.last() == Some(&tail);
            let all = np.words.iter().all(|w| item.words.contains(w));
            let own = np.words.iter().all(|w| {
                item.words.contains(w)
                    || item.look.features.iter().any(|f| f == w)
                    || item.look.material.as_deref() == Some(w)
            });
            // "the entrance" is no door between two rooms.
            let inner = item.beyond.is_some() && matches!(tail.as_str(), "entrance" | "exit" | "entry");
            if inner && !same_tail {
                return 0;
            }
            let fewer = item.words.iter().all(|w| np.words.contains(w));
            let color = np.look.color.is_none() || np.look.color == item.look.color;
            if item.words == np.words && color {
                8
            } else if all && same_tail {
                7
            } else if (same_head || same_tail) && own {
                6
            } else if np.words.len() == 1 && item.words.contains(&head) && !item.opening() {
                // "the wardrobe door" is no wardrobe, and a desk lamp is no desk; "the bar" may be the bar counter
                let other = lexicon.noun(&head).is_some_and(|group| {
                    matches!(group, Group::Table | Group::Storage | Group::Bed | Group::Seat) && group != item.group
                });
                if other && !same_head && !same_tail { 0 } else { 3 }
            } else if np.words.len() == 1
                && item.words.last().is_some_and(|w| w.len() > head.len() && w.ends_with(&head))
            {
                // "the bench" is the workbench
                5
            } else if all {
                3
            } else if (np.words.len() > 1 || item.words.len() > 1)
                && lexicon.alike(&item.words.join(" "), &np.words.join(" "))
            {
                // "the bedside table" is the nightstand
                6
            } else if lexicon.alike(&item.head(), &head)
                && np.words[..np.words.len() - np.last].iter().all(|w| lexicon.alike(&item.head(), w))
            {
                4
            } else if fewer
                && (same_head || same_tail)
                && np.look.color.is_none()
                && (np.many || np.count.is_some_and(|c| c > 1) || !item.number.many())
            {
                2
            } else {
                0
            }
        };
        let best = self
            .brief
            .things
            .iter()
            .enumerate()
            .filter(|(i, item)| item.part.is_none() && !self.gone.contains(i))
            .map(|(i, item)| (score(item) * 2 + u32::from(item.room == self.room), score(item), i));
        let surface = np.det == Det::Definite && lexicon.is(&head, Class::Surface);
        // "a bar stool beside the bar": beside another thing than itself.
        let own = |b: &(u32, u32, usize)| b.1 == 3 && self.near == [b.2];
        let best = best.filter(|b| b.1 > 0).max_by_key(|b| (!own(b), b.0, b.1, b.2)).map(|b| b.2);
        best.or_else(|| if surface { self.surface(&head) } else { None })
            .or_else(|| self.with_part_named(np))
            .or_else(|| self.collective(np))
    }

    /// "the seating", "the workspace": what was spoken of last that one sits or works at.
    pub(super) fn collective(&self, np: &Np) -> Option<usize> {
        let group = match np.words.last()?.as_str() {
            "seat" | "seating" => Group::Seat,
            "setup" | "workspace" | "workstation" => Group::Table,
            _ => return None,
        };
        let is = |i: &usize| {
            let item = &self.brief.things[*i];
            item.group == group && item.room == self.room && item.part.is_none() && !self.gone.contains(i)
        };
        let said = np.det == Det::Definite && np.words.len() == 1 && !np.many;
        (0..self.brief.things.len()).rev().filter(|_| said).find(is)
    }

    /// "a vanity with an integrated sink … on the sink": what has this part.
    fn with_part_named(&self, np: &Np) -> Option<usize> {
        let name = np.name();
        let part =
            |f: &String| f.starts_with("with ") && crate::read::lexicon::singular(f).ends_with(&format!(" {name}"));
        let has = |o: &usize| {
            let item = &self.brief.things[*o];
            item.room == self.room && item.look.features.iter().any(part) && !self.gone.contains(o)
        };
        let said = np.det == Det::Definite && !np.many && np.count.is_none();
        (0..self.brief.things.len()).rev().filter(|_| said).find(has)
    }

    /// "the tabletop": what was spoken of last that has one.
    fn surface(&self, said: &str) -> Option<usize> {
        let with_top = |i: &usize| {
            let item = &self.brief.things[*i];
            item.room == self.room && item.group == Group::Table && item.part.is_none() && !self.gone.contains(i)
        };
        // "the tabletop" is rather that of a table than of a sideboard.
        let named = |i: &usize| self.brief.things[*i].words.last().is_some_and(|w| said.starts_with(w.as_str()));
        let all = || (0..self.brief.things.len()).rev().filter(with_top);
        all().find(named).or_else(|| all().next())
    }

    /// The room that a new thing is in: that which is spoken of or, where several were only listed, "a bedroom and a bathroom. A
    /// double bed, a shower", the one of them that usually has such a thing. So it is with "the dining table", if the room that
    /// is spoken of has none, and "the living room window" is that of the living room.
    fn usual_room(&self, np: &Np) -> usize {
        let noun = &np.name();
        if matches!(np.group, Some(Group::Window | Group::Door)) {
            let whose =
                |room: &crate::brief::Room| noun.strip_prefix(&room.name).is_some_and(|rest| rest.starts_with(' '));
            if let Some(room) = self.brief.rooms.iter().position(whose) {
                return room;
            }
        }
        let again = np.det == Det::Definite && np.kind == NounKind::Thing && self.brief.rooms.len() > 1;
        if !(self.room_listed || again) || !self.s.rooms.is_empty() {
            return self.room;
        }
        let has = |room: &usize| {
            let kind = crate::furnish::kinds::of(&self.brief.rooms[*room].name);
            let lines = kind.into_iter().flat_map(|kind| &kind.lines);
            lines.into_iter().any(|line| crate::furnish::stand::counts_as(line.noun, noun))
        };
        // A flat has what its rooms have.
        let is_part = |room: &usize| Some(*room) != self.rooms.whole;
        let all: Vec<usize> = (0..self.brief.rooms.len()).filter(|room| is_part(room) && has(room)).collect();
        match all[..] {
            [only] => only,
            [] if again => {
                let named = |name: &str| self.brief.rooms.iter().position(|room| room.name == name);
                let homes = USUAL_ROOMS.iter().find(|(thing, _)| thing == noun);
                homes.and_then(|(_, rooms)| rooms.iter().find_map(|name| named(name))).unwrap_or(self.room)
            }
            _ => self.room,
        }
    }

    /// A new thing.
    pub(super) fn add(&mut self, np: &Np, at: Range<usize>) -> usize {
        let number = match (np.count, np.det) {
            (Some(n), _) => Number::Exactly(n.clamp(1, MOST_COUNT)),
            (None, _) if np.several => Number::Several,
            (None, _) if np.many => Number::Plural,
            (None, Det::Each | Det::No) => Number::Unsaid,
            (None, _) => Number::Exactly(1),
        };
        let notes = np.number.and_then(crate::read::counts::said);
        self.brief.notes.extend(notes.map(|reason| Note { at: at.clone(), reason }));
        let mut thing = Thing {
            words: np.words.clone(),
            last: np.last,
            group: np.group.unwrap_or(Group::Floor),
            number,
            of: None,
            room: self.usual_room(np),
            beyond: None,
            places: None,
            look: np.look.clone(),
            size: [None; 3],
            source: ThingOrigin::Stated(at),
            part: None,
        };
        thing.take_dims(&np.dims);
        self.brief.things.push(thing);
        self.brief.things.len() - 1
    }

    /// The bytes that say something of things: from where they are named in this sentence, or its clause begins, to the
    /// end of the clause.
    fn phrase(&self, of: &[usize]) -> Range<usize> {
        let (whole, chunks) = (&self.s.at, self.chunks);
        let start = |k: usize| self.tokens[chunks[k].at.start].at.start;
        let named = of.iter().map(|o| self.brief.things[*o].source.at());
        let named: Vec<_> = named.filter(|at| whole.start <= at.start && at.end <= whole.end).collect();
        let own = self.s.chunks.start..self.s.chunks.end.min(chunks.len());
        let last = named.iter().map(|at| at.start).max().unwrap_or(0);
        let now = own.clone().rev().find(|k| start(*k) <= last).unwrap_or(own.start).max(self.s.now);
        let ends = |k: &usize| {
            matches!(
                chunks[*k].piece,
                ChunkPiece::Comma | ChunkPiece::Stop | ChunkPiece::Line | ChunkPiece::Open | ChunkPiece::Close
            )
        };
        // "between the sofa and the bed" is one phrase, "a lamp on the desk and a cup on the shelf" are two.
        let joins = |k: &usize| {
            let between = chunks[own.start..*k]
                .iter()
                .rev()
                .take_while(|c| !matches!(c.piece, ChunkPiece::Comma | ChunkPiece::Stop));
            let between = between.into_iter().any(|c| matches!(c.piece, ChunkPiece::Rel(Rel::Between)));
            chunks[*k].piece == ChunkPiece::And
                && !between
                && matches!(self.piece(*k + 1, own.end), Some(ChunkPiece::Np(_)))
        };
        let starts = |k: &usize| ends(k) || joins(k) && named.iter().all(|at| at.start > start(*k));
        let first = (own.start..now).rev().find(starts).map_or(own.start, |k| k + 1);
        let end = (now + 1..own.end).find(|k| ends(k) || joins(k)).unwrap_or(own.end);
        if first >= end {
            return whole.clone();
        }
        let clause = self.bytes(first..end);
        let from = named.iter().map(|at| at.start).min().unwrap_or(clause.start);
        from.min(clause.start)..clause.end.max(last)
    }

    /// Says something of things; denied or not.
    pub(super) fn state(&mut self, of: &[usize], what: FactKind, soft: bool, not: bool) {
        let at = self.phrase(of);
        let low = self.s.range.and_then(|range| lower_end(&what, range)).filter(|_| !not);
        for what in std::iter::once(what).chain(low) {
            self.brief.say(Fact {
                soft,
                not,
                subject: self.of_all(),
                object: self.s.quantifier,
                ..Fact::new(of.to_vec(), what, ThingOrigin::Stated(at.clone()))
            });
        }
    }

    /// "Every table is within 3 m of every pillar": it is said of all the tables, and not of some with each pillar.
    fn of_all(&self) -> Quantifier {
        let both = self.s.quantifier == Quantifier::Each && self.s.each && self.s.subject;
        if both { Quantifier::Each } else { Quantifier::Usual }
    }

    /// "the doors", where one was named after the other: all of them.
    pub(super) fn all_of(&self, id: usize, np: &Np) -> Vec<usize> {
        let like = |o: &usize| {
            let item = &self.brief.things[*o];
            item.part.is_none() && item.room == self.room && item.group == Group::Door && !self.gone.contains(o)
        };
        let plain = np.many && np.det == Det::Definite && np.words.len() == 1 && np.group == Some(Group::Door);
        let doors: Vec<usize> = (0..self.brief.things.len()).filter(like).collect();
        if plain && doors.len() > 1 && !self.brief.things[id].number.many() { doors } else { vec![id] }
    }

    /// "the first row", "the back row": the one in its middle, of what stands in rows here.
    pub(super) fn row(&mut self, np: &Np) -> Option<usize> {
        let which = |words: &[&str]| np.which.iter().any(|w| words.contains(&w.as_str()));
        let row = match np.nth {
            Some(Nth::At(n)) => n,
            Some(Nth::Last) => usize::MAX,
            _ if which(&["front", "first"]) => 0,
            _ if which(&["back", "last", "rear"]) => usize::MAX,
            _ => return None,
        };
        let rows = |f: &&Fact| {
            matches!(f.what, FactKind::Pattern(Pattern::Rows(_))) && self.brief.things[f.of[0]].room == self.room
        };
        let of = self.brief.facts.iter().rev().find(rows)?.of[0];
        Some(self.brief.part(of, Pick::Row(row), self.s.at.clone()))
    }
}

/// What a range says beside its upper end.
fn lower_end(what: &FactKind, [least, most]: [f64; 2]) -> Option<FactKind> {
    let is_most = |op: &Op, v: &f64| *op == Op::Most && *v == most;
    Some(match what {
        FactKind::Gap(op, v, to) if is_most(op, v) => FactKind::Gap(Op::Least, least, to.clone()),
        FactKind::Wall(op, v) if is_most(op, v) => FactKind::Wall(Op::Least, least),
        FactKind::Rows(op, v) if is_most(op, v) => FactKind::Rows(Op::Least, least),
        FactKind::Among(op, v) if is_most(op, v) => FactKind::Among(Op::Least, least),
        FactKind::Height(op, v) if is_most(op, v) => FactKind::Height(Op::Least, least),
        FactKind::Size(dim, op, v) if is_most(op, v) => FactKind::Size(*dim, Op::Least, least),
        _ => return None,
    })
}
