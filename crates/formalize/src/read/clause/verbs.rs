//! Verbs: what they make of the noun phrase that comes next.

use super::*;

impl Reader<'_> {
    /// "a chair placed near the window", "a cart topped with a mat": the thing right before a participle, where the
    /// sentence is about another.
    pub(super) fn reduced(&self, i: usize) -> Option<usize> {
        let ChunkPiece::Verb(_) = self.chunks[i].piece else { return None };
        let mut before = self.chunks.get(i.checked_sub(1)?)?.np()?;
        // "a ladder against the wall displaying plants"
        let placed = matches!(before.kind, NounKind::Place(_))
            && i > 2
            && matches!(self.chunks[i - 2].piece, ChunkPiece::Rel(_));
        if placed {
            before = self.chunks[i - 3].np()?;
        }
        if before.kind != NounKind::Thing {
            return None;
        }
        let word = self.tokens[self.chunks[i].at.start].text.as_str();
        let participle =
            word.ends_with("ing") || word.ends_with("ed") || matches!(word, "set" | "hung" | "laid" | "laden");
        let last = self.recent.last().copied().filter(|l| self.brief.things[*l].words == before.words)?;
        // "a basket next to the shelf holding two rolls": what is spoken of again holds nothing new.
        let again = self.brief.things[last].source.at().start < self.bytes(i - 1..i).start;
        let last = if again && !placed { self.near.last().copied()? } else { last };
        let own = self.brief.whole(last);
        (participle && !self.main.is_empty() && !self.main.contains(&last) && !self.main.contains(&own)).then_some(last)
    }

    /// "a bed, a desk, and a lamp placed near the window": of a list with commas, a participle is said of the last.
    pub(super) fn last_listed(&self, i: usize) -> Option<usize> {
        if !matches!(self.chunks[i].piece, ChunkPiece::Verb(_)) {
            return None;
        }
        let word = self.tokens[self.chunks[i].at.start].text.as_str();
        let participle = word.ends_with("ing") || word.ends_with("ed") || word == "set";
        let np = self.np(i.checked_sub(1)?, i).filter(|np| np.kind == NounKind::Thing)?;
        let before =
            self.chunks[self.s.chunks.start..i - 1].iter().rev().map(|c| &c.piece).find(|p| **p != ChunkPiece::And);
        let last = self.main.last().copied().filter(|o| self.brief.things[*o].words == np.words)?;
        let first = !self.s.listed && !self.s.of_room;
        (participle && !first && self.main.len() > 1 && before == Some(&ChunkPiece::Comma)).then_some(last)
    }

    /// Who has what comes: doors and windows have curtains and nothing else.
    pub(super) fn bearer(&self, near: Vec<usize>, next: usize, end: usize) -> Vec<usize> {
        let drape = self.np(next, end).is_some_and(|n| n.group == Some(Group::Drape));
        let opening = |l: &[usize]| l.iter().all(|o| self.brief.things[*o].opening());
        if !drape && opening(&near) && !self.main.is_empty() && !opening(&self.main) { self.main.clone() } else { near }
    }

    /// Whether the noun phrase that begins here is what a new clause is about: "…, while a basket sits …".
    pub(super) fn new_clause(&self, i: usize, end: usize) -> bool {
        let joined = |c: &Chunk| match c.piece {
            ChunkPiece::And | ChunkPiece::Comma => true,
            ChunkPiece::Word(_) | ChunkPiece::Which => {
                matches!(self.tokens[c.at.start].text.as_str(), "while" | "where" | "whereas" | "as" | "but")
            }
            _ => false,
        };
        i > 0 && joined(&self.chunks[i - 1]) && (self.stands_next(i, end) || self.elsewhere(i, end))
    }

    /// Whether what comes after a comma in a list of what another has says of itself where it is, and that has nothing
    /// to do with the other: "a shelf holding a book, and a lamp near the window".
    fn elsewhere(&self, i: usize, end: usize) -> bool {
        let Expect::With(owner, _) = &self.s.expect else { return false };
        let comma = (self.s.chunks.start..i).rev().map(|k| &self.chunks[k].piece).find(|p| **p != ChunkPiece::And);
        if comma != Some(&ChunkPiece::Comma) {
            return false;
        }
        let mut k = i + 1;
        while matches!(
            self.piece(k, end),
            Some(ChunkPiece::Attr(_) | ChunkPiece::Word(false) | ChunkPiece::Verb(Verb::Be | Verb::Hang))
        ) {
            k += 1;
        }
        match self.piece(k, end) {
            Some(ChunkPiece::Rel(rel)) if !matches!(rel, Rel::Of | Rel::To | Rel::From | Rel::Than) => {}
            _ => return false,
        }
        let Some(np) = self.np(k + 1, end) else { return false };
        match np.kind {
            NounKind::Place(place) => matches!(place, Place::Wall | Place::Corner | Place::Ceiling | Place::Floor),
            // "each with a computer, a safe on the wall": one safe; but "each with a lamp, a cup beside it".
            NounKind::Thing if np.det == Det::Own || self.s.each => false,
            // What was named before its owner, and is not what it has.
            NounKind::Thing => match (self.find(np), owner.last()) {
                (Some(found), Some(of)) => {
                    let at = |o: usize| self.brief.things[o].source.at().start;
                    !owner.contains(&found) && at(found) < at(*of)
                }
                _ => np.known && !get().part(&np.head()),
            },
            _ => false,
        }
    }

    /// Whether a noun phrase begins here that a finite verb follows.
    pub(super) fn stands_next(&self, i: usize, end: usize) -> bool {
        let Some(np) = self.np(i, end).filter(|np| np.kind == NounKind::Thing) else { return false };
        let mut k = i + 1;
        while matches!(self.piece(k, end), Some(ChunkPiece::Attr(_) | ChunkPiece::Word(false))) {
            k += 1;
        }
        match self.piece(k, end) {
            Some(ChunkPiece::Verb(_) | ChunkPiece::Rel(_)) => {
                let word = self.tokens[self.chunks[k].at.start].text.as_str();
                let one = word.ends_with('s') && !matches!(word, "across" | "towards" | "less");
                let many = (np.many || np.count.is_some_and(|c| c > 1))
                    && matches!(
                        word,
                        "are" | "stand" | "sit" | "rest" | "lie" | "hang" | "face" | "flank" | "line" | "hold"
                    );
                one || many
            }
            _ => false,
        }
    }

    /// Clauses whose meaning turns on a word that nothing here can say: they are left to the notes.
    /// "each with a lamp, except the last" says nothing of lamps, "a sofa rather than a bench" nothing of the bench.
    pub(super) fn unsaid(&self, from: usize, end: usize) -> Vec<Range<usize>> {
        let mut out = Vec::new();
        if self.corrected(from, end) {
            out.push(from..end);
        }
        for i in from..end {
            let at = self.chunks[i].at.start;
            let word = |n: usize| self.tokens.get(at + n).map_or("", |t| t.text.as_str());
            let stop = |k: &usize| self.chunks[*k].piece == ChunkPiece::Comma;
            let to = (i + 1..end).find(stop).unwrap_or(end);
            match (word(0), word(1)) {
                ("except" | "excepting", _) | ("apart" | "aside", "from") => {
                    // The clause it is said of is the one before it.
                    let before = if i > from && stop(&(i - 1)) { i - 1 } else { i };
                    let start = (from..before).rev().find(stop).unwrap_or(from);
                    out.push(start..to);
                }
                // "all but one of the desks", "no chair but the first"
                ("but", _) if self.quantified((from..i).rev().find(stop).unwrap_or(from), i) => {
                    out.push((from..i).rev().find(stop).unwrap_or(from)..to);
                }
                // "not all chairs", "not every desk": of some it does not hold, and nobody says of which.
                ("not", "all" | "every" | "each" | "both" | "everything") => {
                    out.push((from..i).rev().find(stop).unwrap_or(from)..to);
                }
                ("only", _) if self.narrows(i, end) => {
                    out.push((from..i).rev().find(stop).unwrap_or(from)..to);
                }
                // "Make it look a bit messy": what no statement says.
                ("make" | "makes" | "making", "it") if matches!(self.word_at(i, 2), "look" | "feel" | "seem") => {
                    out.push(i..to);
                }
                ("swap" | "replace" | "exchange" | "substitute", _) => out.push(i..to),
                // "nobody wants a table under it": not which table there is; "clocks make people nervous"
                ("nobody" | "noone", "wants" | "needs" | "likes" | "uses")
                | ("make" | "makes" | "made", "people" | "everyone" | "everybody" | "him" | "her" | "us" | "me")
                    if !self.asks_for(i) =>
                {
                    out.push((from..i).rev().find(stop).unwrap_or(from)..to);
                }
                // "left of the bed as seen from the door": left and right are the viewer's, and no statement says whose.
                ("as" | "when", "seen" | "viewed") => out.push((from..i).rev().find(stop).unwrap_or(from)..to),
                _ if self.some_unsaid(i, to) || self.for_unknown(i, to) || self.nearest_of(i, to) => {
                    out.push((from..i).rev().find(stop).unwrap_or(from)..to);
                }
                _ if self.as_before(i, to).is_some() => {
                    let joins = |k: &usize| stop(k) || self.chunks[*k].piece == ChunkPiece::And;
                    out.push((from..i).rev().find(joins).map_or(from, |k| k + 1)..to);
                }
                _ if self.same_as(i, to).is_some() => out.extend(self.same_as(i, to)),
                _ if self.of_people(i, from, to) || self.so_that(i) || self.comes_with(i) || self.able_to(i) => {
                    out.push(i..to)
                }
                _ if self.free_beneath(i) => {
                    let with = (from..i).rev().find(|k| stop(k) || self.chunks[*k].piece == ChunkPiece::With);
                    let next = |k: &usize| matches!(self.chunks[*k].piece, ChunkPiece::With | ChunkPiece::And);
                    out.push(with.unwrap_or(from)..(i + 1..to).find(next).unwrap_or(to));
                }
                _ if self.as_much(i, end).is_some() => {
                    let begin = i - usize::from(i > from && matches!(self.chunks[i - 1].piece, ChunkPiece::Word(_)));
                    out.push(begin..self.as_much(i, end).unwrap_or(to));
                }
                _ if self.uncounted(i, to) => {
                    out.push((from..i).rev().find(stop).unwrap_or(from)..to);
                }
                ("rather", "than") | ("instead", "of") => out.push(i..to),
                // "no television; instead there is a piano": the piano is said as it is.
                ("instead", _) if i == from => {}
                ("instead", _) | ("neither", _) => {
                    let start = (from..i).rev().find(stop).map_or(from, |k| k + 1);
                    // "neither the sofa nor the bed is …"
                    let end = if word(0) == "neither" { end } else { to };
                    out.push(start..end);
                }
                _ if self.compares(i, end) => {
                    let object = self.np(i + 1, end).is_some();
                    let begin = i - usize::from(i > from && matches!(self.chunks[i - 1].piece, ChunkPiece::Word(_)));
                    out.push(begin..i + 1 + usize::from(object));
                }
                _ => {}
            }
        }
        out
    }

    /// Whether these chunks speak of all or of none of something.
    fn quantified(&self, from: usize, to: usize) -> bool {
        self.chunks[from..to].iter().flat_map(|c| c.at.clone()).any(|t| {
            let word = self.tokens[t].text.as_str();
            matches!(word, "all" | "every" | "each" | "any" | "no" | "none" | "everything" | "everyone" | "nothing")
        })
    }

    /// Whether what stands here speaks of some of the things there are in a way that needs counting: "at least two chairs
    /// face the door", where there are four; "each desk except the last", where nobody says how many there are.
    fn uncounted(&self, i: usize, end: usize) -> bool {
        let Some(np) = self.np(i, end) else { return false };
        let known = self.find(np).map(|f| &self.brief.things[f]).filter(|item| item.number.many());
        let said = |item: &Thing| item.number.said().is_some() || item.number.follows();
        match np.nth {
            Some(Nth::ButFirst | Nth::ButLast) => !known.is_some_and(said),
            // "the first chair … the second chair", where nobody has said yet how many there are.
            Some(Nth::At(_)) if np.kind == NounKind::Thing && np.det == Det::Definite => {
                self.find(np).is_none_or(|f| !self.brief.things[f].number.many()) && self.counted_later(np, i)
            }
            _ => np.bound.is_some() && known.is_some_and(said) && i + 1 < end,
        }
    }

    /// Whether another of these is told apart by its place in the order, too: "the second chair" after "the first chair".
    fn counted_later(&self, np: &Np, i: usize) -> bool {
        let same = |other: &Np| other.words == np.words && other.nth != np.nth && matches!(other.nth, Some(Nth::At(_)));
        self.chunks.iter().enumerate().any(|(k, c)| k != i && c.np().is_some_and(same))
    }

    /// "Actually, make that three chairs": so many of what there is, or what it looks like. What is read with it.
    pub(super) fn revised(&mut self, from: usize, end: usize) -> Option<Range<usize>> {
        let first = |k: usize| self.chunks.get(k).map_or("", |c| self.tokens[c.at.start].text.as_str());
        let i = (from..end.min(from + 6)).find(|k| matches!(first(*k), "make" | "makes"))?;
        let at = self.chunks[i].at.end;
        if !self.tokens.get(at).is_some_and(|t| matches!(t.text.as_str(), "that" | "it" | "them" | "those" | "this")) {
            return None;
        }
        let k = (i + 1..end.min(i + 3)).find(|k| self.np(*k, end).is_some_and(|np| np.kind == NounKind::Thing))?;
        let np = self.np(k, end)?;
        let thing = self.find(np).filter(|o| self.brief.things[*o].part.is_none())?;
        match np.count {
            Some(n) if n > 0 && !self.brief.things[thing].number.follows() => {
                self.brief.things[thing].number = Number::Exactly(n.min(MOST_COUNT));
            }
            None if np.det == Det::Indefinite && np.look != crate::draft::Look::default() => {}
            _ => return None,
        }
        self.more_of(thing, np);
        let to = self.after_noun(k + 1, end, thing);
        (from..to).for_each(|c| self.mark(c));
        self.main = vec![thing];
        self.near = vec![thing];
        self.s.subject = true;
        Some(from..to)
    }

    /// "there is neither a telephone nor a television": both are ruled out. What is read with it.
    pub(super) fn neither(&mut self, from: usize, end: usize) -> Option<Range<usize>> {
        let chunks = self.chunks;
        let i = (from..end).find(|k| self.tokens[chunks[*k].at.start].is("neither"))?;
        let there = |c: &Chunk| {
            matches!(c.piece, ChunkPiece::There | ChunkPiece::With | ChunkPiece::Verb(Verb::Have))
                || self.tokens[c.at.start].is("there")
        };
        let listed = |k: &usize| match &chunks[*k].piece {
            ChunkPiece::Np(np) => np.kind == NounKind::Thing,
            piece => matches!(piece, ChunkPiece::Not | ChunkPiece::Word(_) | ChunkPiece::And | ChunkPiece::Comma),
        };
        let to = (i..end).find(|k| !listed(k)).unwrap_or(end);
        let told =
            matches!(self.piece(to, end), Some(ChunkPiece::Verb(_) | ChunkPiece::ToIts(_) | ChunkPiece::Pattern(_)))
                || matches!(self.piece(to, end), Some(ChunkPiece::Rel(rel)) if *rel != Rel::To);
        let things: Vec<usize> = (i..to).filter(|k| self.np(*k, to).is_some()).collect();
        // "No, neither a hood nor a fridge."
        let alone = chunks[from..i]
            .iter()
            .all(|c| matches!(c.piece, ChunkPiece::Not | ChunkPiece::Comma | ChunkPiece::Word(_)));
        if !alone && !chunks[from..i].iter().any(there) || told || things.len() < 2 {
            return None;
        }
        for k in things {
            let at = self.bytes(k..k + 1);
            self.brief.absent.extend(self.np(k, to).map(|np| (np.name(), at)));
        }
        (i..to).for_each(|k| self.mark(k));
        Some(i..end)
    }

    /// "a table, actually no, a desk": what was said before is taken back, and nobody says how far.
    fn corrected(&self, from: usize, end: usize) -> bool {
        let Some(last) = end.checked_sub(1).and_then(|last| self.chunks.get(last)) else { return false };
        let tokens = &self.tokens[self.chunks[from].at.start..last.at.end];
        let words: Vec<&str> = tokens.iter().filter(|t| t.word()).map(|t| t.text.as_str()).collect();
        words.windows(2).any(|pair| matches!(pair, ["actually", "no"] | ["no", "actually"] | ["no", "wait"]))
            || words
                .windows(3)
                .any(|three| matches!(three, ["on", "second", "thought" | "thoughts"] | ["i", "said", "no"]))
    }

    /// "… in the middle. Actually no, put it under the window": where it was said to be before is said no more. The chunk
    /// that the rest begins with.
    pub(super) fn moved(&mut self, from: usize, end: usize) -> usize {
        let first = |k: usize| self.chunks.get(k).map_or("", |c| self.tokens[c.at.start].text.as_str());
        let lead = |k: &usize| {
            self.piece(*k, end) == Some(&ChunkPiece::Comma)
                || matches!(first(*k), "actually" | "no" | "wait" | "sorry" | "hmm" | "oh")
        };
        let Some(begin) = (from..end).find(|k| !lead(k)) else { return from };
        let turns = (from..begin).any(|k| matches!(first(k), "no" | "sorry" | "wait"));
        let again = matches!(first(begin), "put" | "place" | "move" | "stand" | "hang" | "set" | "keep")
            && self.np(begin + 1, end).is_some_and(|np| np.kind == NounKind::Pronoun);
        if !turns || !again || self.main.is_empty() {
            return from;
        }
        let (before, main) = (self.s.at.clone(), self.main.clone());
        let there = |fact: &Fact| {
            let at = fact.source.at();
            before.start <= at.start
                && at.end <= before.end
                && fact.of.iter().all(|o| main.contains(o))
                && matches!(fact.what, FactKind::Place(..) | FactKind::Rel(..) | FactKind::Gap(..))
        };
        self.brief.facts.retain(|fact| !there(fact));
        (from..begin).for_each(|k| self.mark(k));
        begin
    }

    /// "taller than the desk": a comparison with a thing, for which there is no statement.
    fn compares(&self, i: usize, end: usize) -> bool {
        let chunk = &self.chunks[i];
        let before = chunk.at.start.checked_sub(1).map_or("", |k| self.tokens[k].text.as_str());
        let number = self.np(i + 1, end).is_some_and(|np| np.count.is_some() && np.det == Det::Number);
        chunk.piece == ChunkPiece::Rel(Rel::Than) && !number && !matches!(before, "rather" | "other" | "more" | "less")
    }

    pub(super) fn on_verb(&mut self, i: usize, end: usize, verb: Verb) {
        let after = self.main.clone();
        let reduced = self.reduced(i);
        if let Some(last) = reduced {
            self.near = vec![last];
        }
        match verb {
            Verb::Be | Verb::Keep => {
                self.s.verb = true;
                if !self.main.is_empty() && self.s.subject && reduced.is_none() {
                    let last = self.last_listed(i);
                    self.near = last.map_or_else(|| self.main.clone(), |last| vec![last]);
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
                self.s.together = reduced.is_some();
                let owner = reduced.map_or(owner, |last| self.bearer(vec![last], i + 1, end));
                // "the room has", "we have": nothing that owns.
                let of_room = self.s.of_room && !self.s.subject || owner.is_empty();
                let word = self.tokens[self.chunks[i].at.start].text.as_str();
                let join = match verb {
                    Verb::Carry => Join::On,
                    _ if matches!(word, "filled" | "stocked" | "contain" | "contains" | "containing") => Join::In,
                    _ => Join::Usual,
                };
                self.s.expect = if of_room { Expect::Nothing } else { Expect::With(owner, join) };
                self.s.listed = true;
            }
            Verb::Block => self.s.expect = Expect::Blocked,
            Verb::Face => self.s.expect = Expect::Object(Rel::Facing),
            Verb::Light => {
                let passive = self.tokens[self.chunks[i].at.start].is("lit") || self.chunks[i].at.len() > 1;
                // What stands on the floor gives light from beside.
                let high = self.main.iter().all(|o| self.brief.things[*o].group == Group::Ceiling);
                let from = if high || self.main.is_empty() { Rel::Above } else { Rel::Near };
                self.s.expect =
                    if passive { Expect::With(self.near.clone(), Join::Above) } else { Expect::Object(from) };
            }
            Verb::Cover => self.s.expect = Expect::Object(Rel::On),
            Verb::Hang => {
                self.s.hang = true;
                self.s.verb = true;
                if !self.main.is_empty() && reduced.is_none() {
                    self.near = self.main.clone();
                }
            }
            Verb::Flank | Verb::Surround => {
                let passive = self.chunks[i].at.len() > 1;
                let (join, rel) =
                    if verb == Verb::Flank { (Join::Beside, Rel::Sides) } else { (Join::Around, Rel::Around) };
                self.s.expect = if passive { Expect::With(self.near.clone(), join) } else { Expect::Object(rel) };
                self.s.each =
                    self.s.each || passive && self.near.first().is_some_and(|n| self.brief.things[*n].number.many());
            }
            Verb::Lead => {}
        }
        if verb != Verb::Be {
            self.mark(i);
        }
    }
}
