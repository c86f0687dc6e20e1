//! Noun phrases: what they bring in or speak of again, what is said right after them, and who "it" is.

use super::*;

impl Reader<'_> {
    pub(super) fn on_np(&mut self, i: usize, end: usize, np: &Np) -> usize {
        match np.kind {
            // "the bedroom is a mess"
            NounKind::Thing
                if !np.known
                    && np.det == Det::Indefinite
                    && i > 0
                    && matches!(self.chunks[i - 1].piece, ChunkPiece::Verb(Verb::Be))
                    && matches!(self.tokens[self.chunks[i - 1].at.start].text.as_str(), "is" | "are" | "was")
                    && (self.s.subject || self.s.of_room) =>
            {
                i + 1
            }
            NounKind::Thing => self.forms(i, end, np).unwrap_or_else(|| self.on_things(i, end)),
            NounKind::Room => {
                self.on_room(i, end, np);
                i + 1
            }
            NounKind::Pronoun => {
                self.on_pronoun(i, end, np);
                self.s.skip.take().unwrap_or(i + 1)
            }
            NounKind::Abstract => {
                let anything = np.words.first().is_some_and(|w| w == "anything" || w == "something");
                if np.det == Det::No
                    || np.words.first().is_some_and(|w| w == "nothing")
                    || anything && std::mem::take(&mut self.s.not)
                {
                    self.s.nothing = true;
                    self.s.keep = true;
                }
                if let (true, [(Dim::Width | Dim::Length, width), ..]) = (self.s.path, np.dims.as_slice()) {
                    // "a 1.5 m wide path from the gate to the stage"
                    let m = Measure {
                        op: Op::Least,
                        said: true,
                        values: vec![*width],
                        dims: vec![],
                        area: false,
                        least: None,
                        exact: false,
                    };
                    self.mark(i);
                    return self.on_path(i, end, &m);
                }
                // "the distance between the bed and the desk is 1 m"
                let distance = np.words.first().is_some_and(|w| matches!(w.as_str(), "distance" | "gap"));
                let measured = (i + 1..end).any(|k| matches!(self.chunks[k].piece, ChunkPiece::Measure(_)));
                if distance && measured && self.piece(i + 1, end) == Some(&ChunkPiece::Rel(Rel::Between)) {
                    self.mark(i);
                }
                if np.words.first().is_some_and(|w| w == "neighbour" || w == "neighbor")
                    && let Some(m) = self.s.pending.take()
                {
                    self.among(&m);
                    self.mark(i);
                }
                i + 1
            }
            NounKind::Place(place) => self.on_place_first(i, end, place, np),
        }
    }

    /// A place with no relation before it: "the walls are white", "one corner".
    pub(super) fn on_place_first(&mut self, i: usize, end: usize, place: Place, np: &Np) -> usize {
        let surface = matches!(place, Place::Wall | Place::Floor | Place::Ceiling);
        let mut k = i + 1;
        while matches!(self.piece(k, end), Some(ChunkPiece::Verb(Verb::Be) | ChunkPiece::Rel(Rel::In | Rel::Of))) {
            k += 1;
        }
        if surface && let Some(ChunkPiece::Attr(look)) = self.piece(k, end) {
            let room = &mut self.brief.rooms[self.room];
            match place {
                Place::Wall => room.walls = look.clone(),
                Place::Floor => room.floor = look.clone(),
                _ => {}
            }
            (i..=k).for_each(|c| self.mark(c));
            return k + 1;
        }
        self.s.rows |= place == Place::Row && !self.s.subject;
        let before = i.checked_sub(1).map(|k| &self.chunks[k].piece);
        // "Desks, five rows"
        if let (Place::Row, Some(rows), false) = (place, np.count.filter(|n| *n > 1), self.near.is_empty()) {
            let of = self.near.clone();
            self.say(&of, FactKind::Pattern(Pattern::Rows(Some(rows))));
            self.mark(i);
            return i + 1;
        }
        // "the chairs occupy the corner", "cabin: rear right corner"
        // "a rug covers the floor": nothing else is covered.
        if place == Place::Floor && matches!(before, Some(ChunkPiece::Verb(Verb::Cover))) {
            self.s.expect = Expect::Nothing;
            self.mark(i);
            return i + 1;
        }
        let there = matches!(place, Place::Corner | Place::Middle) || place == Place::Wall && !np.which.is_empty();
        let verb = matches!(before, Some(ChunkPiece::Verb(_)));
        let of = if self.near.is_empty() || verb { self.main.clone() } else { self.near.clone() };
        if there
            && !of.is_empty()
            && matches!(before, Some(ChunkPiece::Verb(Verb::Be | Verb::Cover) | ChunkPiece::Colon | ChunkPiece::Comma))
            && matches!(self.piece(i + 1, end), None | Some(ChunkPiece::Comma | ChunkPiece::Rel(_) | ChunkPiece::And))
        {
            self.at_place(&of, if place == Place::Wall { Rel::Against } else { Rel::In }, place, &np.which);
            self.s.expect = Expect::Nothing;
            self.mark(i);
            return i + 1;
        }
        // "its front is kept clear to a depth of 1 m"
        if place == Place::Front && np.det == Det::Own && self.s.keep && !self.s.subject {
            self.main = self.it();
            self.near = self.main.clone();
            self.s.subject = !self.main.is_empty();
            self.mark(i);
            return i + 1;
        }
        self.near.clear();
        if place == Place::Ceiling {
            self.s.room_last = true;
        }
        i + 1
    }

    pub(super) fn on_room(&mut self, i: usize, end: usize, np: &Np) {
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
        let led = self.s.lead.iter().any(|(_, l)| matches!(l, Lead::Items(..)));
        self.s.room_first |= !self.s.subject && !led;
        self.s.of_room = true;
        // "You get there from the hall", "the office is next to the hall": what comes next is not in the hall.
        let before = i.checked_sub(1).and_then(|k| self.piece(k, end));
        let beside = [Rel::Beside, Rel::Near, Rel::Behind, Rel::Opposite];
        let aside = match before {
            Some(ChunkPiece::Rel(Rel::From)) => true,
            Some(ChunkPiece::Rel(rel)) => named_before && beside.contains(rel),
            _ => false,
        };
        if !aside && !self.goes_on_before(i, end, room) {
            (self.room, self.room_listed) = (room, named_before);
        }
        self.near.clear();
        if !self.s.subject {
            self.main.clear();
            self.before.clear();
        }
        if matches!(self.piece(i + 1, end), Some(ChunkPiece::With)) {
            self.mark(i + 1);
        }
    }

    /// The door of the sentence leads from one of its rooms to the other.
    pub(super) fn doors(&mut self) {
        let mut rooms = std::mem::take(&mut self.s.rooms);
        rooms.dedup();
        if !self.s.doors {
            return;
        }
        match rooms.as_slice() {
            [a, b, ..] if a != b => self.connect(*a, *b),
            [a] if self.brief.rooms.len() > 1 && *a != self.s.from => {
                let from = self.s.from;
                self.connect(from, *a);
            }
            [] | [_] if self.brief.rooms.len() == 2 => self.connect(0, 1),
            _ => {}
        }
    }

    pub(super) fn connect(&mut self, from: usize, to: usize) {
        let start = self.s.at.start;
        let said = self
            .brief
            .things
            .iter()
            .rposition(|it| it.group == Group::Door && it.source.at().start >= start && it.part.is_none());
        let again = self.recent.last().copied().filter(|r| self.brief.things[*r].group == Group::Door);
        let again = again.map(|r| self.brief.whole(r));
        if let Some(door) = said.or(again) {
            let item = &mut self.brief.things[door];
            if item.room == to {
                item.room = from;
            }
            item.beyond = Some(to);
        }
    }

    pub(super) fn on_pronoun(&mut self, i: usize, end: usize, np: &Np) {
        let word = np.words.first().map_or("", String::as_str);
        let followed = self.is_followed(i, end);
        let each_next = self.each_next(i, end);
        if let (Some(n), [item]) = (np.count.filter(|n| *n > 1 || word == "them"), self.main.as_slice())
            && each_next.is_none()
        {
            // "four of them"
            let it = &mut self.brief.things[*item];
            if it.number.many() && it.number.said().is_none() {
                it.number = Number::Exactly(n);
                self.mark(i);
            }
        }
        if let (Some(1), Some(k)) = (np.count, each_next)
            && let (Some(owner), Some(of)) = (self.np(k, end).and_then(|np| self.find(np)), self.main.first().copied())
        {
            // "one for each counter"
            self.one_each(&[of], owner);
            self.mark(i);
            self.mark(k);
            self.s.skip = Some(k + 1);
            return;
        }
        if self.one_on_each_side(i, end, np) {
            return;
        }
        if !matches!(self.s.expect, Expect::Object(_))
            && let Some(part) = self.dealt(i, end, np)
        {
            if self.main.first().is_some_and(|m| self.brief.things[*m].part.is_none()) {
                self.before = std::mem::take(&mut self.main);
            }
            self.main = vec![part];
            self.near = vec![part];
            self.s.subject = true;
            self.s.one = true;
            self.s.expect = Expect::Nothing;
            self.mark(i);
            self.apply_lead();
            return;
        }
        let bare = !self.s.subject && !self.s.of_room && matches!(word, "it") && i > 0 && np.det == Det::None;
        // "It shall contain …", after a sentence that began with the room.
        let contains = (i + 1..end.min(i + 4)).any(|k| self.piece(k, end) == Some(&ChunkPiece::Verb(Verb::Have)));
        if bare && (self.about_room || self.room_began && contains) {
            self.s.of_room = true;
            self.s.room_last = true;
            self.s.rooms.push(self.room);
            self.mark(i);
            return;
        }
        self.s.one |= np.count.is_some() && word == "ones" || word == "one";
        let dir = if matches!(word, "them" | "they" | "these" | "those" | "both" | "all" | "ones") {
            self.them()
        } else {
            self.it()
        };
        if matches!(word, "each" | "both" | "all" | "these" | "those" | "ones") || np.det == Det::Each {
            return self.on_each(i, end, np, dir);
        }
        match self.s.expect.clone() {
            Expect::Object(rel) if !self.main.is_empty() => {
                let of = self.main.clone();
                let dir = if dir == of { self.their(word, false) } else { self.on_rug(&dir, rel) };
                self.relate(&of, rel, &dir);
                self.s.expect = Expect::Nothing;
            }
            // "one speaker stands left of the shelf and another stands right of it"
            _ if word == "other" && np.det == Det::Indefinite && followed && self.main.len() == 1 => {
                let model = &self.brief.things[self.main[0]];
                if model.number != Number::Exactly(1) || model.opening() || model.part.is_some() {
                    return;
                }
                let source = ThingOrigin::Stated(self.bytes(i..i + 1));
                let another = Thing { source, ..model.clone() };
                self.brief.things.push(another);
                let id = self.brief.things.len() - 1;
                self.before = std::mem::replace(&mut self.main, vec![id]);
                self.near = vec![id];
                self.recent.push(id);
                self.s.subject = true;
                self.s.expect = Expect::Nothing;
            }
            _ if word == "other" => return,
            _ if !self.s.subject && !dir.is_empty() => self.on_subject(dir, word, followed),
            _ => {}
        }
        self.mark(i);
    }

    /// "each has a lamp", "both stand …": of those that were named.
    fn on_each(&mut self, i: usize, end: usize, np: &Np, dir: Vec<usize>) {
        let word = np.words.first().map_or("", String::as_str);
        let followed = self.is_followed(i, end);
        self.s.each |= np.det == Det::Each || matches!(word, "each" | "both" | "all");
        if followed || matches!(self.piece(i + 1, end), None | Some(ChunkPiece::Comma | ChunkPiece::Np(_))) {
            let many = |l: &[usize]| l.len() > 1 || l.iter().any(|i| self.brief.things[*i].number.many());
            if self.main.is_empty() {
                self.main = dir;
            } else if !many(&self.main)
                && let Some(last) = self.recent.iter().rev().find(|r| self.brief.things[**r].number.many())
            {
                self.main = vec![*last];
            }
            self.near = self.main.clone();
            self.mark(i);
        }
    }

    /// Whether something is said of what a pronoun stands for.
    fn is_followed(&self, i: usize, end: usize) -> bool {
        matches!(
            self.piece(i + 1, end),
            Some(
                ChunkPiece::Rel(_)
                    | ChunkPiece::Verb(_)
                    | ChunkPiece::ToIts(_)
                    | ChunkPiece::With
                    | ChunkPiece::Pattern(_)
                    | ChunkPiece::Measure(_)
            )
        )
    }

    /// "one for each counter", "one per desk": the chunk of the counter.
    fn each_next(&self, i: usize, end: usize) -> Option<usize> {
        let per = self.np(i + 1, end).filter(|n| n.det == Det::Each && n.kind == NounKind::Thing);
        if per.is_some() {
            return Some(i + 1);
        }
        let word = matches!(self.piece(i + 1, end), Some(ChunkPiece::Word(_)))
            && matches!(self.tokens[self.chunks[i + 1].at.start].text.as_str(), "for" | "per");
        let each = self.np(i + 2, end).filter(|n| n.kind == NounKind::Thing && n.det == Det::Each);
        (word && each.is_some()).then_some(i + 2)
    }

    /// Whether a noun phrase brings in something new, or which thing it speaks of again.
    pub(super) fn resolve(&mut self, i: usize, np: &Np, object: bool) -> Option<usize> {
        let found = self.find(np);
        // "workbenches with vices, one vice per bench": those.
        let of_each = |f: &usize| {
            let item = &self.brief.things[*f];
            item.words == np.words && item.number.many() && item.source.at().start >= self.s.at.start
        };
        if np.count == Some(1)
            && self.np(i + 1, self.s.chunks.end).is_some_and(|next| next.det == Det::Each)
            && self.tokens[self.chunks[i + 1].at.start].is("per")
            && let Some(known) = found.filter(of_each)
        {
            return Some(known);
        }
        if let Some(part) = np.nth.and_then(|nth| self.some_of(i, nth, np.count, found)) {
            return Some(part);
        }
        let of_those = np.other && np.det == Det::Definite && (np.many || np.count.is_some());
        if of_those && found.is_some() && self.dealt.map(|d| d.0) == found {
            return self.others(i, np).or(found);
        }
        // "the window", in a room that has spoken of none: its own.
        let plain = np.words.len() == 1 && matches!(np.group, Some(Group::Window)) && np.det != Det::Each;
        let here = |f: &usize| {
            let item = &self.brief.things[*f];
            !plain || item.room == self.room || item.beyond == Some(self.room)
        };
        let found = found.filter(here);
        let exact = found.filter(|f| {
            let item = &self.brief.things[*f];
            item.words == np.words && (np.look.color.is_none() || item.look.color == np.look.color)
        });
        let counted = |f: &usize| np.count.is_none_or(|n| self.brief.things[*f].number.said().is_none_or(|m| m >= n));
        let again = match np.det {
            Det::Definite | Det::Own => found.filter(|f| counted(f)),
            Det::Each | Det::No => found,
            Det::None if np.count.is_none() => {
                let plain = object || self.s.keep || self.s.pending.is_some();
                let here = |f: &usize| plain || self.brief.things[*f].room == self.room;
                exact.filter(here).or(found.filter(|_| plain))
            }
            // "on one nightstand", "on a nightstand" where there are two: on one of these. Where there are more,
            // "a stool" is another.
            Det::Indefinite | Det::Number if object && np.count.unwrap_or(1) == 1 && !np.many => {
                let plain = np.look == crate::draft::Look::default() && np.dims.is_empty() && !np.other;
                let known = |f: &usize| {
                    let item = &self.brief.things[*f];
                    // "never on a console": on none of them.
                    let of_these =
                        np.det == Det::Number || item.opening() || item.number.said() == Some(2) || self.s.not;
                    plain && of_these && item.number.many() && item.words == np.words && item.room == self.room
                };
                match found.filter(known) {
                    // "to an exit", "each table near a pillar": any of those there are.
                    Some(of) if np.count.is_none() && (self.s.each || self.brief.things[of].opening()) => Some(of),
                    Some(of) if self.brief.things[of].number.said().is_some() => self.deal(i, of, 1),
                    _ => None,
                }
            }
            Det::None | Det::Number | Det::Indefinite => None,
        };
        if np.other && np.det != Det::Definite {
            return self.introduce(i, np);
        }
        if let Some(all) = exact.filter(|f| again.is_none() && self.is_every(*f, np)) {
            self.brief.things[all].number = Number::Exactly(np.count.unwrap_or(1));
            return Some(all);
        }
        again.or_else(|| self.introduce(i, np))
    }

    /// "A shower within 3 m of every bench. There are three benches.": how many those are of which all were spoken of.
    /// "It runs in front of the benches" as well.
    fn is_every(&self, thing: usize, np: &Np) -> bool {
        let it = &self.brief.things[thing];
        let first = self.tokens.iter().find(|token| token.at.start == it.source.at().start);
        let all: &[&str] = match it.number {
            Number::Unsaid => &["every", "each", "all"],
            Number::Plural => &["the", "all"],
            _ => return false,
        };
        np.det == Det::Number
            && np.count.is_some_and(|n| n > 1)
            && first.is_some_and(|token| all.iter().any(|word| token.is(word)))
    }

    /// "the first exit", "two of the chairs": some of what is known.
    fn some_of(&mut self, i: usize, nth: Nth, count: Option<usize>, found: Option<usize>) -> Option<usize> {
        let of = found.filter(|f| self.brief.things[*f].number.many())?;
        let all = self.brief.count(of);
        let pick = match nth {
            // "the first four desks"
            Nth::At(0) if count.is_some_and(|n| n < all) => Pick::Run(0, count.unwrap_or(1).max(1)),
            Nth::Last if count.is_some_and(|n| (1..all).contains(&n)) => Pick::Rest(all - count.unwrap_or(1)),
            Nth::At(n) if n < all => Pick::Run(n, 1),
            Nth::At(_) => return None,
            Nth::Last => Pick::Last,
            Nth::Middle if all > 2 => Pick::Run((all - 1) / 2, 1),
            Nth::Middle => return None,
            Nth::Half => Pick::Half,
            Nth::Every(n) => Pick::Every(n),
            // "each table near one of the pillars"
            Nth::Some if count == Some(1) && self.s.each && self.s.subject => return Some(of),
            Nth::Some => return self.deal(i, of, count?),
            Nth::ButFirst if all > 1 => Pick::Rest(1),
            Nth::ButLast if all > 1 => Pick::Run(0, all - 1),
            Nth::ButFirst | Nth::ButLast => return None,
        };
        let at = self.bytes(i..i + 1);
        match (nth, pick) {
            (Nth::Half, _) => self.dealt = Some((of, (all / 2).max(1))),
            // "the first shelf …, the other two": those after it.
            (Nth::At(_), Pick::Run(from, n)) if self.dealt.map_or(0, |d| if d.0 == of { d.1 } else { 0 }) == from => {
                self.dealt = Some((of, from + n));
            }
            _ => {}
        }
        Some(self.brief.part(of, pick, at))
    }

    /// The next so many of several, if there are so many.
    fn deal(&mut self, i: usize, of: usize, n: usize) -> Option<usize> {
        let all = self.brief.count(of);
        let stated = self.brief.things[of].number.said().is_some() || self.brief.things[of].number.follows();
        if n == 0 || n >= all && stated {
            return None;
        }
        let from = self.dealt.filter(|d| d.0 == of && d.1 + n <= all).map_or(0, |d| d.1);
        self.dealt = Some((of, from + n));
        let at = self.bytes(i..i + 1);
        Some(self.brief.part(of, Pick::Run(from, n), at))
    }

    /// "the other two", "the other desks": those of which nothing was said yet, of several that were told apart.
    fn others(&mut self, i: usize, np: &Np) -> Option<usize> {
        let (of, taken) = self.dealt?;
        let at = self.bytes(i..i + 1);
        let all = self.brief.count(of);
        let n = np.count.unwrap_or(all.saturating_sub(taken));
        if taken >= all {
            return None;
        }
        self.dealt = Some((of, taken + n));
        let whole = taken + n >= all;
        Some(self.brief.part(of, if whole { Pick::Rest(taken) } else { Pick::Run(taken, n) }, at))
    }

    /// "one on the west wall and one on the east wall", "the other two": some of what was spoken of last.
    fn dealt(&mut self, i: usize, end: usize, np: &Np) -> Option<usize> {
        let word = np.words.first().map_or("", String::as_str);
        if np.other && matches!(np.det, Det::Definite | Det::Own) {
            return self.others(i, np);
        }
        let n = np.count?;
        let others = self.chunks[i..end]
            .iter()
            .flat_map(|c| c.at.clone())
            .any(|t| matches!(self.tokens[t].text.as_str(), "other" | "others"));
        let (of_them, bare) = (word == "them", word == "ones" && np.det == Det::Number);
        let goes_on = matches!(
            self.piece(i + 1, end),
            Some(
                ChunkPiece::Rel(_)
                    | ChunkPiece::ToIts(_)
                    | ChunkPiece::Verb(_)
                    | ChunkPiece::With
                    | ChunkPiece::Pattern(_)
            )
        );
        if !(of_them || bare) || !goes_on || np.det == Det::Each {
            return None;
        }
        let many = |o: &usize| self.brief.things[*o].number.many() && self.brief.things[*o].part.is_none();
        let known = |o: &usize| self.dealt.is_some_and(|d| d.0 == *o);
        let last = self.recent.last().filter(|r| self.brief.things[**r].source.at().start >= self.s.at.start);
        let of = [&self.main, &self.near]
            .into_iter()
            .flatten()
            .chain(last)
            .map(|o| self.brief.whole(*o))
            .find(|o| many(o))
            .or_else(|| self.before.iter().copied().find(|o| many(o) && (of_them || known(o) || others)))
            .or_else(|| self.several_of(n).filter(|_| of_them))?;
        // "one on each side": of one thing, so many for each.
        let each = |k: usize| self.np(k, end).is_some_and(|n| n.det == Det::Each);
        if each(i + 2)
            || self.brief.things[of].number.said().is_none() && !self.brief.things[of].number.follows() && !of_them
        {
            return None;
        }
        self.deal(i, of, n)
    }

    pub(super) fn introduce(&mut self, i: usize, np: &Np) -> Option<usize> {
        let head = np.head();
        // "its doors", "the headboard": parts.
        if np.det == Det::Own && get().part(&head) && !matches!(np.group, Some(Group::Door | Group::Window)) {
            return None;
        }
        if self.brief.things.len() >= MOST_THINGS || !nameable(&head) {
            return None;
        }
        // "the draught": a word nobody knows is a thing only where things are.
        let placed = |p: Option<&ChunkPiece>| matches!(p, Some(ChunkPiece::Rel(r)) if !matches!(r, Rel::Of | Rel::To | Rel::From | Rel::In | Rel::Than));
        let stands = matches!(
            self.chunks.get(i + 1).map(|c| &c.piece),
            Some(ChunkPiece::Verb(Verb::Be | Verb::Hang | Verb::Carry))
        );
        // "no farther than 2 m from the silo"
        let measured = self.s.pending.is_some()
            && i > 0
            && matches!(self.chunks[i - 1].piece, ChunkPiece::Rel(Rel::From | Rel::To | Rel::Of | Rel::Than));
        let around = measured
            || placed(self.chunks.get(i + 1).map(|c| &c.piece))
            || i > 0 && placed(self.chunks.get(i - 1).map(|c| &c.piece))
            || stands;
        if !np.known && matches!(np.det, Det::Definite | Det::Own | Det::Each) && !around {
            return None;
        }
        if !np.known && (abstraction(np) || self.no_noun(i, np)) {
            return None;
        }
        let at = self.bytes(i..i + 1);
        let id = self.add(np, at);
        if np.row {
            self.say(&[id], FactKind::Pattern(Pattern::Row));
        }
        if let Some(pattern) = np.pattern {
            self.say(&[id], FactKind::Pattern(pattern));
        }
        if np.look.features.iter().any(|f| f == "matching") {
            self.match_looks(id);
        }
        if np.look.features.iter().any(|f| f == "ceiling-mounted") && !self.brief.things[id].opening() {
            self.say(&[id], FactKind::Place(Rel::Hang, Place::Ceiling, vec![]));
        }
        if np.look.features.iter().any(|f| f == "wall-mounted" || f == "wall-hung") && !self.brief.things[id].opening()
        {
            self.say(&[id], FactKind::Place(Rel::Mounted, Place::Wall, vec![]));
        }
        Some(id)
    }

    /// "opinions about that", "to fight": a word nobody knows that is no thing here.
    fn no_noun(&self, i: usize, np: &Np) -> bool {
        let at = &self.chunks[i].at;
        let about = self.tokens.get(at.end).is_some_and(|t| t.is("about"));
        let to = at.start.checked_sub(1).is_some_and(|k| self.tokens[k].is("to"));
        np.det == Det::None && np.count.is_none() && (about || to && !np.many)
    }

    pub(super) fn say(&mut self, of: &[usize], what: FactKind) {
        let soft = self.soft();
        self.state(of, what, soft, false);
    }

    /// Things named one after the other, with what is said of each right after it: sizes, looks, parts.
    pub(super) fn on_things(&mut self, i: usize, end: usize) -> usize {
        let chunks = self.chunks;
        let Some(np) = chunks[i].np() else { return i + 1 };
        let comma = (self.s.chunks.start..i).rev().map(|k| &chunks[k].piece).find(|p| **p != ChunkPiece::And);
        let unlike = comma == Some(&ChunkPiece::Comma) && self.unlike(self.s.owned.first(), i);
        if matches!(self.s.expect, Expect::With(..)) && (unlike || self.new_clause(i, end)) {
            self.s.expect = Expect::Nothing;
            self.s.each = false;
            self.s.hang = false;
            self.s.it.clear();
        }
        // What must not be there.
        let denied = np.det == Det::No
            || self.s.not
                && self.s.expect != Expect::Blocked
                && !matches!(np.det, Det::Definite | Det::Each | Det::Own);
        let to = (i..end).find(|k| chunks[*k].piece == ChunkPiece::Colon).unwrap_or(end);
        if denied && !self.limits(i..to, end, np) {
            return self.deny(i, end);
        }
        self.s.not |= np.det == Det::No;
        // "for bottle storage": no thing.
        let purpose = i > 0 && self.tokens[chunks[i].at.start - 1].is("for")
            || i > 0 && np.words == ["light"] && self.tokens[chunks[i].at.start - 1].is("to");
        // Nor is light that is cast: "provides soft light".
        let purpose = purpose
            || matches!(np.words.last().map(String::as_str), Some("light" | "lighting" | "illumination" | "glow"))
                && np.words.len() == 1
                && i > 0
                && !matches!(chunks[i - 1].piece, ChunkPiece::Rel(_) | ChunkPiece::With);
        if purpose && np.det == Det::None && np.count.is_none() && !np.many {
            return i + 1;
        }
        self.kept_there(i, np);
        let mut group: Vec<usize> = Vec::new();
        let mut k = i;
        let mut each = np.det == Det::Each;
        let new_from = self.brief.things.len();
        let (mut joined, mut over) = (false, false);
        while let Some(np) = self.np(k, end) {
            if np.kind != NounKind::Thing {
                break;
            }
            if let Some(id) = self.resolve(k, np, false) {
                self.mark(k);
                group.push(id);
                self.near = vec![id];
                if id < new_from {
                    self.more_of(id, np);
                } else if np.det == Det::Definite && !np.many {
                    self.s.definite.push(id);
                }
                k = self.after_noun(k + 1, end, id);
                k = self.for_each(k, end, id, &group);
            } else {
                k += 1;
            }
            each |= np.det == Det::Each;
            let Some(next) = self.list_next(k, end) else { break };
            // "each with a monitor, a mouse and a chair, and a printer": the printer is of no desk.
            let and = (k..next).any(|c| chunks[c].piece == ChunkPiece::And);
            let comma = (k..next).any(|c| chunks[c].piece == ChunkPiece::Comma);
            if and && joined && matches!(self.s.expect, Expect::With(..))
                || comma && self.unlike(group[..].first(), next)
                || and && self.stands_apart(group[..].first(), next)
            {
                over = true;
                break;
            }
            joined |= and;
            k = next;
        }
        if group.is_empty() {
            return k.max(i + 1);
        }
        self.s.room_last = false;
        self.recent.extend(&group);
        self.place_group(&group, new_from, each);
        if over {
            self.s.expect = Expect::Nothing;
            self.s.each = false;
        }
        k
    }

    /// Where a list goes on: after "and" or a comma, if a noun phrase follows that is a thing.
    pub(super) fn list_next(&self, k: usize, end: usize) -> Option<usize> {
        let mut n = k;
        while matches!(self.piece(n, end), Some(ChunkPiece::And | ChunkPiece::Comma | ChunkPiece::Close)) {
            n += 1;
        }
        if n == k {
            return None;
        }
        self.np(n, end).filter(|np| np.kind == NounKind::Thing && np.det != Det::No)?;
        // "…, the table in the middle": a clause of its own is read on its own all the same; the list ends before a verb.
        // So does "… encircles the column, and the column is …".
        let again =
            matches!(self.s.expect, Expect::Object(_)) && self.np(n, end).is_some_and(|np| np.det == Det::Definite);
        let verb_before = matches!(self.piece(n + 1, end), Some(ChunkPiece::Verb(v)) if *v != Verb::Be || again);
        let verb_before = verb_before && !self.of_several(n);
        // "Above the desk hangs a mirror, and a lamp stands …": the subject came after its verb, so the list is over.
        let inverted = self.s.verb && !self.s.subject && !self.s.lead.is_empty();
        let over = (inverted || matches!(self.s.expect, Expect::With(..))) && self.new_clause(n, end);
        (!verb_before && !over).then_some(n)
    }

    /// Whether what comes after a comma is of another kind than what a thing was said to have: "surrounded by six chairs,
    /// a sideboard, …", "holding a lamp, a bed …".
    fn unlike(&self, first: Option<&usize>, next: usize) -> bool {
        let Expect::With(owner, join) = &self.s.expect else { return false };
        let (Some(first), Some(group)) = (first, self.chunks[next].np().and_then(|np| np.group)) else { return false };
        let flat = owner.iter().any(|o| self.brief.things[*o].group == Group::Flat);
        match join {
            _ if self.s.each => false,
            Join::Beside | Join::Around => group != self.brief.things[*first].group,
            Join::On | Join::In => !flat && matches!(group, Group::Seat | Group::Bed | Group::Table),
            // "A bedroom with a bed with two nightstands, a wardrobe and a desk": the list is of the room.
            Join::Usual => self.s.of_room && !self.s.verb && group != self.brief.things[*first].group,
            Join::Above => false,
        }
    }

    /// "A living room with a cabinet with vases and a sofa": what is no part of a cabinet and cannot stand on it is of the room.
    fn stands_apart(&self, first: Option<&usize>, next: usize) -> bool {
        let Expect::With(owner, Join::Usual) = &self.s.expect else { return false };
        let (Some(first), Some(group)) = (first, self.chunks[next].np().and_then(|np| np.group)) else { return false };
        let holds = owner.iter().all(|o| self.brief.things[*o].group == Group::Storage);
        let large = matches!(group, Group::Seat | Group::Bed | Group::Table);
        holds && large && !self.s.each && group != self.brief.things[*first].group
    }

    /// Whether the verb after one thing in the singular is one of several: "a sofa and a table occupy the middle".
    fn of_several(&self, n: usize) -> bool {
        let word = self.tokens[self.chunks[n + 1].at.start].text.as_str();
        let one = self.chunks[n].np().is_some_and(|np| !np.many && np.count.is_none_or(|c| c == 1));
        let and = n > 0 && self.chunks[n - 1].piece == ChunkPiece::And;
        let finite = matches!(word, "occupy" | "fill" | "flank" | "frame" | "surround" | "adorn" | "face" | "hang");
        one && and && finite && matches!(self.s.expect, Expect::Nothing)
    }

    /// What a group of things is in its sentence.
    pub(super) fn place_group(&mut self, group: &[usize], new_from: usize, each: bool) {
        let fresh: Vec<usize> = group.iter().copied().filter(|g| *g >= new_from).collect();
        match std::mem::replace(&mut self.s.expect, Expect::Nothing) {
            Expect::With(owner, join) if !owner.is_empty() => {
                let per = self.s.each || owner.iter().any(|o| self.brief.things[*o].number.many());
                if per && owner.len() == 1 {
                    // "six desks, with the printer in a corner": one printer.
                    let definite = std::mem::take(&mut self.s.definite);
                    let own: Vec<usize> = fresh.iter().copied().filter(|f| !definite.contains(f)).collect();
                    // "two monitors with a keyboard": one keyboard.
                    let small =
                        matches!(self.brief.things[owner[0]].group, Group::Top | Group::Screen | Group::Ceiling);
                    if self.s.each || !(small || self.s.together) {
                        if self.s.each { self.multiply(&own, owner[0]) } else { self.share_out(&own, owner[0]) }
                    }
                }
                self.join(&owner, &fresh, join);
                self.s.owned.clone_from(&fresh);
                self.s.expect = Expect::With(owner, join);
                self.near = group[group.len() - 1..].to_vec();
            }
            Expect::Object(rel) if !self.main.is_empty() => {
                let of = self.main.clone();
                self.relate(&of, rel, group);
                self.near = group.to_vec();
            }
            Expect::Blocked if self.s.nothing || !self.s.subject => self.clear(group, Rel::InFrontOf, CLEAR),
            Expect::Blocked if !std::mem::take(&mut self.s.not) => {}
            Expect::Blocked => {
                let (of, soft) = (self.main.clone(), self.soft());
                self.state(&of, FactKind::Rel(Rel::InFrontOf, group.to_vec()), soft, true);
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
}

/// Whether a noun that nobody knows is no thing by its end: "warmth and functionality", "a playful and cozy touch".
fn abstraction(np: &Np) -> bool {
    const NOUNS: [&str; 9] = ["ity", "ness", "ance", "ence", "ship", "hood", "ism", "tude", "ation"];
    const ADJECTIVES: [&str; 5] = ["ful", "ous", "ible", "less", "ish"];
    let head = np.head();
    let ends = |list: &[&str]| list.iter().any(|e| head.len() > e.len() + 2 && head.ends_with(e));
    let thing = ["decoration", "installation", "appliance", "ambulance"].contains(&head.as_str());
    !thing && (ends(&NOUNS) || np.words.len() == 1 && ends(&ADJECTIVES)) || get().is(&head, Class::Surface)
}
