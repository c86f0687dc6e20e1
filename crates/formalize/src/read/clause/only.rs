//! "Only": what is said of some things is denied of the others of their kind, or nothing is said.

use super::*;

impl Reader<'_> {
    /// Whether "only" narrows what its clause says in a way that no statement has: "the chairs stand only at the long
    /// table". Not where it counts ("only two chairs"), names one of several ("only the first desk has …"), or says
    /// what there is ("with only a bed").
    pub(super) fn narrows(&self, i: usize, end: usize) -> bool {
        let before = self.chunks[i].at.start.checked_sub(1).map_or("", |k| self.tokens[k].text.as_str());
        let counts = self.chunks[i].np().is_some();
        let there = i > self.s.chunks.start
            && matches!(self.chunks[i - 1].piece, ChunkPiece::With | ChunkPiece::There | ChunkPiece::Verb(Verb::Have))
            && self.np(i + 1, end).is_some();
        // "I only need a desk with a lamp", "one door only"
        let need = matches!(self.piece(i + 1, end), Some(ChunkPiece::Verb(Verb::Be | Verb::Have)))
            && self.np(i + 2, end).is_some_and(|np| np.kind == NounKind::Thing && np.det != Det::Definite);
        let stops = |k: &usize| self.chunks[*k].piece == ChunkPiece::Comma;
        let from = (self.s.chunks.start..i).rev().find(stops).unwrap_or(self.s.chunks.start);
        let to = (i + 1..end).find(stops).unwrap_or(end);
        let relates = |c: &Chunk| {
            matches!(
                c.piece,
                ChunkPiece::Rel(_)
                    | ChunkPiece::ToIts(_)
                    | ChunkPiece::Pattern(_)
                    | ChunkPiece::With
                    | ChunkPiece::Measure(_)
            ) || matches!(c.piece, ChunkPiece::Verb(verb) if !matches!(verb, Verb::Be | Verb::Lead))
        };
        let there = there || need || !self.chunks[from..to].iter().any(relates);
        !counts && !there && !matches!(before, "not" | "the") && self.some_only(i, end).is_none()
    }

    /// "Only the first desk …": which of several, as they are called.
    pub(super) fn some_only(&self, i: usize, end: usize) -> Option<&Np> {
        let np = self.np(i + 1, end).filter(|np| np.nth.is_some() && np.kind == NounKind::Thing)?;
        let several = |f: usize| {
            let number = self.brief.things[f].number;
            number.said().is_some() || number.follows()
        };
        let first = &self.tokens[self.chunks[i].at.start];
        let exactly = (first.is("exactly") || first.is("precisely") || first.is("just")) && np.nth == Some(Nth::Some);
        let starts = i == self.s.chunks.start && (first.is("only") || exactly);
        (starts && self.find(np).is_some_and(several)).then_some(np)
    }

    /// After a sentence that began with "only the first desk": what it said of this one is denied of the others. Where
    /// that cannot be denied, nothing is said at all. `first`: the first fact of the sentence.
    pub(super) fn only_these(&mut self, from: usize, end: usize, first: usize) {
        if self.some_only(from, end).is_none() {
            return;
        }
        let part = self.brief.things.iter().rposition(|t| t.part.is_some());
        let said: Vec<Fact> = self.brief.facts[first.min(self.brief.facts.len())..].to_vec();
        let denied: Option<Vec<Fact>> = part.and_then(|part| {
            let each: Vec<Vec<Fact>> = said.iter().map(|f| self.denied_of_others(f, part)).collect::<Option<_>>()?;
            Some(each.into_iter().flatten().collect())
        });
        match denied.filter(|denied| !denied.is_empty()) {
            Some(denied) => {
                denied.into_iter().for_each(|fact| self.brief.say(fact));
                self.mark(from);
            }
            None => {
                self.brief.facts.truncate(first);
                let reason =
                    "the request does not say for which others this does not hold, so no statement expresses it"
                        .to_owned();
                self.brief.notes.push(Note { at: self.s.at.clone(), reason });
            }
        }
    }

    /// After a sentence that says what a room has and that it has only this: "a bedroom with only a bed". Nothing is added
    /// to this room. `first`: the first thing of the sentence. Where more is said of the things, "only" may belong to that
    /// ("only a bed near the window"), and in a home of several rooms nothing says which it is said of: it stays a note.
    pub(super) fn nothing_else(&mut self, from: usize, end: usize, first: usize) {
        self.and_nothing_else(from, end);
        let Some(only) = (from + 1..end).find(|i| self.tokens[self.chunks[*i].at.start].is("only")) else { return };
        let is_room = |i: usize| self.np(i, end).is_some_and(|np| np.kind == NounKind::Room);
        let said_of_room = match self.chunks[only - 1].piece {
            ChunkPiece::With | ChunkPiece::Verb(Verb::Have) => only >= from + 2 && is_room(only - 2),
            ChunkPiece::There => only == from + 1,
            _ => false,
        };
        let new = self.brief.things.get(first..).unwrap_or_default();
        let furniture = new.iter().any(|thing| !thing.opening() && thing.part.is_none());
        let Some(room) = new.first().map(|thing| thing.room) else { return };
        let together = new.iter().all(|thing| thing.room == room);
        let home = self.brief.rooms.get(room).is_none_or(|room| crate::read::several::is_home(&room.name));
        let word = matches!(self.chunks[only].piece, ChunkPiece::Word(_));
        if said_of_room && word && furniture && together && !home && !self.s.soft && self.lists(only + 1, end) {
            self.brief.rooms[room].only = true;
            self.mark(only);
        }
    }

    /// "A gallery with seven paintings and a bench, nothing else": of the only room.
    fn and_nothing_else(&mut self, from: usize, end: usize) {
        let nothing = |i: &usize| self.word_at(*i, 0) == "nothing" && self.word_at(*i, 1) == "else";
        let Some(at) = (from..end).find(nothing) else { return };
        let last = self.chunks[at].at.start + 2;
        let ends = self.tokens.get(last).is_none_or(|t| !t.word());
        let [room] = &mut self.brief.rooms[..] else { return };
        if ends && !crate::read::several::is_home(&room.name) {
            room.only = true;
            self.used[last - 2..last].fill(true);
        }
    }

    /// Whether these chunks name things, and at most the room that they are in.
    fn lists(&self, from: usize, end: usize) -> bool {
        let within = |i: &usize| self.piece(*i, end) == Some(&ChunkPiece::Rel(Rel::In));
        let to = (from..end).find(within).unwrap_or(end);
        let listed = (from..to).all(|i| match &self.chunks[i].piece {
            ChunkPiece::Np(np) => np.kind == NounKind::Thing && np.det != Det::Definite,
            ChunkPiece::And | ChunkPiece::Comma => true,
            _ => false,
        });
        let room = |np: &Np| np.kind == NounKind::Room || np.kind == NounKind::Pronoun;
        listed && from < to && (to == end || to + 2 == end && self.np(to + 1, end).is_some_and(room))
    }

    /// A fact of some things, denied of the others of their kind. `None`: it cannot be denied.
    fn denied_of_others(&mut self, fact: &Fact, part: usize) -> Option<Vec<Fact>> {
        let at_place = matches!(&fact.what, FactKind::Place(rel, place, which)
            if matches!(place, Place::Wall | Place::Corner | Place::Middle)
                && which.iter().all(|which| which == "each")
                && matches!(rel, Rel::At | Rel::Against | Rel::In | Rel::On | Rel::Along));
        let objects: &[usize] = match &fact.what {
            FactKind::Rel(_, to) => to,
            _ if at_place => &[],
            _ => return None,
        };
        let Subset { of, pick } = self.brief.things[part].part.clone()?;
        let all = self.brief.count(of);
        let (from, n) = match pick {
            Pick::Run(from, n) => (from, n),
            Pick::Rest(from) => (from, all.saturating_sub(from)),
            Pick::Last => (all.checked_sub(1)?, 1),
            Pick::Half | Pick::Every(_) | Pick::Row(_) => return None,
        };
        let mut others = Vec::new();
        if from > 0 {
            others.push(Pick::Run(0, from));
        }
        if from + n < all {
            others.push(Pick::Rest(from + n));
        }
        let at = fact.source.at();
        let mut out = Vec::new();
        for pick in others {
            let other = self.brief.part(of, pick, at.clone());
            let turned = match (fact.of.as_slice(), &fact.what) {
                ([one], _) if *one == part => Fact { of: vec![other], ..fact.clone() },
                (_, FactKind::Rel(rel, _)) if objects == [part] => {
                    Fact { what: FactKind::Rel(*rel, vec![other]), ..fact.clone() }
                }
                _ => return None,
            };
            out.push(Fact { not: !fact.not, object: Quantifier::Each, ..turned });
        }
        (!fact.not).then_some(out)
    }
}
