//! Relations: what they are said of, what they are to, and places.

use super::*;
use scenelang_lang::library::usual_size;

/// No side of what people put on something is longer (metres).
const SMALL: f64 = 0.45;

/// A relation that is read: where, and what it is said of.
struct Said {
    i: usize,
    next: usize,
    end: usize,
    rel: Rel,
    of: Vec<usize>,
    negative: bool,
    /// Whether what it is said of comes later.
    before_subject: bool,
}

impl Reader<'_> {
    pub(super) fn on_rel(&mut self, i: usize, end: usize, rel: Rel) -> usize {
        if let Some(next) = self.not_of_two(i, end, rel) {
            return next;
        }
        let chunks = self.chunks;
        let negative = std::mem::take(&mut self.s.not);
        // What it is said of is known before the object is spoken of.
        let said_of = self.subject(i);
        let reduced = i > 0 && self.reduced(i - 1).is_some();
        let Some((object, next)) = self.object(i + 1, end, rel) else {
            if rel == Rel::Between && self.np(i + 1, end).is_some_and(|n| n.kind == NounKind::Abstract) {
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
        // "at the foot of the bed": what place and "of" together say.
        let rel = self.s.turned.take().unwrap_or(rel);
        // "knives go on a magnetic strip on the wall": the strip is on the wall.
        let led = match self.s.lead.last() {
            Some((_, Lead::Items(items, _))) if !self.s.subject && self.s.verb && chunks[i - 1].np().is_some() => {
                items.iter().all(|o| self.brief.things[*o].source.at().start >= self.s.at.start)
            }
            _ => false,
        };
        if led && let Some((_, Lead::Items(items, _))) = self.s.lead.pop() {
            self.near = items;
        }
        let with = matches!(self.s.expect, Expect::With(..)) && !self.near.is_empty();
        let before_subject = !self.s.subject && self.s.pending.is_none() && !self.s.keep && !led && !with;
        // "hangs from", "faces": said of what the sentence is about.
        let verbal = get().verb(&self.tokens[self.chunks[i].at.start..self.chunks[i].at.start + 1]).is_some()
            && !self.main.is_empty()
            && self.tokens[self.chunks[i].at.start].text.ends_with('s');
        if verbal {
            self.near = self.main.clone();
            self.s.expect = Expect::Nothing;
        }
        let said_of = if led || verbal { self.subject(i) } else { said_of };
        // "a rug near the door, beneath the sofa": a door is beneath nothing.
        let opening = |l: &[usize]| l.iter().all(|o| self.brief.things[*o].opening());
        let moved = !self.main.is_empty() && opening(&said_of) && !opening(&self.main);
        let said_of =
            if moved && matches!(object, Lead::Items(..)) && self.s.subject { self.main.clone() } else { said_of };
        let of = match &object {
            // "with a lamp and a chair placed beside the table": of the chair.
            Lead::Items(items, _) if !reduced || rel == Rel::On => self.all_owned(i, items).unwrap_or(said_of),
            _ => said_of,
        };
        let of = if rel == Rel::Around { self.with_seats_before(i, of) } else { of };
        if let (Rel::Between, Lead::Items(items, _)) = (rel, &object)
            && self.wall_next(next, end)
            && let Some(m) = self.s.pending.take()
        {
            // "90 cm between the counter and the wall"
            self.say(items, FactKind::Wall(min_if_keep(&m, self.s.keep), m.values[0]));
            (i..next + 2).for_each(|k| self.mark(k));
            return next + 2;
        }
        let one = matches!(&object, Lead::Items(items, _) if items.len() == 1);
        let walled = rel == Rel::Between && !negative && one && self.wall_next(next, end);
        let (rel, next) = if walled {
            (next..next + 2).for_each(|k| self.mark(k));
            (Rel::WallBeyond, next + 2)
        } else {
            (rel, next)
        };
        let said = Said { i, next, end, rel, of, negative, before_subject };
        match object {
            Lead::Items(items, each) => self.relate_items(said, items, each),
            Lead::Place(place, which) => self.relate_place(said, place, which),
        }
        self.s.quantifier = Quantifier::Usual;
        next
    }

    /// Where a word of a relation says something else than how two things stand to each other; the next chunk.
    fn not_of_two(&mut self, i: usize, end: usize, rel: Rel) -> Option<usize> {
        // "in dark green felt"
        if matches!(rel, Rel::In | Rel::Of) && matches!(self.piece(i + 1, end), Some(ChunkPiece::Attr(_))) {
            return Some(i + 1);
        }
        let chunks = self.chunks;
        // "…, and nearby a table stands": of no thing.
        if rel == Rel::Near && self.tokens[chunks[i].at.start].is("nearby") && self.stands_next(i + 1, end) {
            self.s.expect = Expect::Nothing;
            return Some(i + 1);
        }
        if let Some(next) = self.clusters(i, end, rel) {
            return Some(next);
        }
        // "a basement turned into a casino": what it is now is no thing in it.
        let before = chunks[i].at.start.checked_sub(1).map_or("", |k| self.tokens[k].text.as_str());
        if matches!(before, "turned" | "transformed" | "converted" | "changed" | "remade")
            && self.tokens[chunks[i].at.start].is("into")
            && self.np(i + 1, end).is_some()
        {
            return Some(i + 2);
        }
        // "a lamp stands nearby", "with a mirror above": of what was spoken of before.
        let words = &self.tokens[chunks[i].at.clone()];
        let adverb = words.last().is_some_and(|t| {
            matches!(
                t.text.as_str(),
                "nearby" | "above" | "below" | "beneath" | "underneath" | "alongside" | "inside" | "behind"
            )
        });
        // "mounted above", "tucked underneath"
        let participle = words.len() == 2 && words[0].text.ends_with("ed") || words.len() == 2 && words[0].is("hung");
        let alone = adverb
            && (words.len() == 1 || participle)
            && matches!(
                self.piece(i + 1, end),
                None | Some(ChunkPiece::Comma | ChunkPiece::And | ChunkPiece::Verb(Verb::Hang))
            );
        if alone && self.s.pending.is_none() {
            self.mark(i);
            self.on_its(i, end, rel);
            return Some(i + 1);
        }
        None
    }

    /// A relation to things.
    fn relate_items(&mut self, said: Said, items: Vec<usize>, each: bool) {
        let Said { i, next, end, rel, of, negative, before_subject } = said;
        self.mark(i);
        self.s.quantifier = self.quantifier(i + 1..next, each, &items);
        if let Some(m) = self.s.pending.take() {
            self.measured(&of, rel, &items, &m, negative);
        } else if self.s.nothing && !self.s.subject {
            self.nothing(i, rel, &items);
        } else if before_subject
            || of.is_empty()
            || self.preposed(i, next, end)
            || rel == Rel::Between && items.len() == 1 && self.measure_follows(next, end)
        {
            self.s.lead_not |= negative;
            let twice = rel == Rel::Beside && self.sides(i);
            self.s.lead_twice |= twice;
            self.s.lead.push((if twice { Rel::Sides } else { rel }, Lead::Items(items, each)));
        } else {
            if each && items.len() == 1 && self.s.one {
                self.one_each(&of, items[0]);
            }
            // "A whiteboard visible from every desk" is one.
            let of_each = !matches!(rel, Rel::Visible | Rel::Reachable);
            if each && items.len() == 1 && !self.s.one && of_each {
                let fresh: Vec<usize> = of
                    .iter()
                    .copied()
                    .filter(|o| self.brief.things[*o].source.at().start >= self.s.at.start && !items.contains(o))
                    .collect();
                self.share_out(&fresh, items[0]);
            }
            if negative {
                let soft = self.soft();
                self.state(&of, FactKind::Rel(rel, items), soft, true);
            } else {
                let rel = if self.sides(i) && rel == Rel::Beside {
                    self.double();
                    Rel::Sides
                } else {
                    rel
                };
                let fresh = items.iter().all(|o| self.brief.things[*o].source.at().start >= self.bytes(i..i + 1).start);
                self.four_sides(i, &of);
                self.drop_usual(&of);
                self.relate(&of, rel, &items);
                // "a lamp on a table next to the sofa": the table is next to the sofa.
                self.near = if fresh { items } else { of };
            }
        }
    }

    fn relate_place(&mut self, said: Said, place: Place, mut which: Vec<String>) {
        let Said { i, next, end, rel, of, negative, before_subject } = said;
        let chunks = self.chunks;
        // "Mirrors on one wall": all of them.
        let named = chunks[i + 1..next].iter().flat_map(|c| &self.tokens[c.at.clone()]);
        if place == Place::Wall && named.clone().any(|t| t.is("one") || t.is("single")) {
            which.push("one".to_owned());
        }
        if place == Place::Wall {
            which.extend(self.part_of_walls(i, next));
        }
        if place == Place::Row && named.clone().any(|t| t.is("rows")) {
            which.push("several".to_owned());
        }
        self.mark(i);
        if let Some(m) = self.s.pending.take() {
            match place {
                Place::Row => self.rows(&m),
                Place::Floor => self.say(&of, FactKind::Height(m.op, m.values[0])),
                _ => self.say(&of, FactKind::Wall(flip(&m, self.s.nothing || negative), m.values[0])),
            }
        } else if before_subject || of.is_empty() || self.preposed(i, next, end) {
            self.s.lead.push((rel, Lead::Place(place, which)));
        } else if negative {
            self.not_at_place(i..next, &of, rel, place, &which);
        } else {
            // "a table with two chairs in the corner", "in the centre": the table stands there.
            let of = match &self.s.expect {
                Expect::With(owner, Join::Usual)
                    if matches!(place, Place::Corner | Place::Middle)
                        && self.s.owned == of
                        && of.iter().all(|o| self.brief.things[*o].group == Group::Seat)
                        && chunks[i - 1].np().is_some() =>
                {
                    owner.clone()
                }
                _ => of,
            };
            let of_room = self.np(next - 1, end).is_some_and(|np| np.kind == NounKind::Room);
            if place == Place::Middle && which.is_empty() && !of_room && self.middle_of_carrier(&of) {
                return;
            }
            self.drop_usual(&of);
            self.at_place(&of, rel, place, &which);
        }
    }

    /// Not at a wall, not in a corner; of other places, and of one wall among several, nothing says that.
    fn not_at_place(&mut self, chunks: Range<usize>, of: &[usize], rel: Rel, place: Place, which: &[String]) {
        let any = which.iter().all(|which| which == "each");
        let there = matches!(rel, Rel::At | Rel::Against | Rel::In | Rel::On | Rel::Along | Rel::Mounted);
        let stands = !of.iter().any(|o| self.brief.things[*o].opening());
        let known = matches!(place, Place::Wall | Place::Corner | Place::Middle);
        if any && there && stands && known {
            let soft = self.soft();
            return self.state(of, FactKind::Place(rel, place, Vec::new()), soft, true);
        }
        let reason = "no statement can say that something is not in this place".to_owned();
        self.brief.notes.push(Note { at: self.bytes(chunks.clone()), reason });
        for at in chunks.filter_map(|k| self.chunks.get(k)).map(|c| c.at.clone()) {
            self.used[at].fill(false);
        }
    }

    /// "On the table, a bowl is beside a centerpiece in the middle", "a table with a vase in the center": small things
    /// are in the middle of what they are on. Whether that was said.
    fn middle_of_carrier(&mut self, of: &[usize]) -> bool {
        let group = |o: &usize| self.brief.things[*o].group;
        if of.is_empty() || !of.iter().all(|o| group(o) == Group::Top) {
            return false;
        }
        let owner = match &self.s.expect {
            Expect::With(owner, Join::Usual | Join::On) => Some(owner),
            _ => self.s.frame.as_ref(),
        };
        let carries = |list: &&Vec<usize>| list.len() == 1 && matches!(group(&list[0]), Group::Table | Group::Storage);
        let Some(owner) = owner.filter(carries).cloned() else { return false };
        let one = |o: usize| self.brief.count(o) == 1 && !self.brief.things[o].number.many();
        let rel = if one(owner[0]) && of.len() == 1 && one(of[0]) { Rel::Centre } else { Rel::On };
        let said = |f: &Fact| f.of == of && matches!(&f.what, FactKind::Rel(Rel::On, to) if *to == owner);
        if rel == Rel::Centre || !self.brief.facts.iter().any(said) {
            self.drop_usual(of);
            self.relate(of, rel, &owner);
        }
        true
    }

    /// Whether what was spoken of last are small things that stand on others.
    fn is_small_thing(&self) -> bool {
        let of = if self.near.is_empty() { &self.main } else { &self.near };
        let new = |o: &usize| self.brief.things[*o].source.at().start >= self.s.at.start;
        let small = |o: &usize| {
            let item = &self.brief.things[*o];
            let size = usual_size(&item.name());
            item.group == Group::Top
                || item.is_small_plant()
                || item.group == Group::Floor && size.is_some_and(|size| size.iter().all(|side| *side <= SMALL))
        };
        !of.is_empty() && of.iter().all(|o| small(o) && new(o))
    }

    /// What a relation speaks of, and the next chunk. Rooms change what the sentence is about.
    pub(super) fn object(&mut self, from: usize, end: usize, rel: Rel) -> Option<(Lead, usize)> {
        let chunks = self.chunks;
        let mut k = from;
        while matches!(self.piece(k, end), Some(ChunkPiece::Word(false) | ChunkPiece::Soft))
            && !self.tokens[chunks[k].at.start].is("so")
        {
            k += 1;
        }
        let np = self.np(k, end)?;
        // "on the lid of a chest", "on the surface of the desk"
        if get().is(&np.head(), Class::Surface)
            && np.words.len() == 1
            && matches!(self.piece(k + 1, end), Some(ChunkPiece::Rel(Rel::Of)))
            && self.np(k + 2, end).is_some_and(|n| matches!(n.kind, NounKind::Thing | NounKind::Pronoun))
        {
            self.mark(k);
            return self.object(k + 2, end, rel);
        }
        // "books on its top shelf": in what has shelves.
        let within = np.det == Det::Own && matches!(np.head().as_str(), "shelf" | "tier" | "compartment");
        if within && np.kind == NounKind::Thing && matches!(rel, Rel::On | Rel::In) {
            let items = self.their("it", false);
            if items.iter().any(|o| self.brief.things[*o].group == Group::Storage) {
                self.mark(k);
                return Some((Lead::Items(items, false), k + 1));
            }
        }
        // "a lamp over every block", of those that the desks form
        if let Some((_, of)) = self.formed.as_ref().filter(|(formed, _)| *formed == np.name()) {
            let items = vec![*of];
            self.mark(k);
            return Some((Lead::Items(items, false), k + 1));
        }
        match np.kind {
            NounKind::Thing => self.things_object(k, end, rel, np),
            NounKind::Pronoun => {
                let word = np.words.first().map_or("", String::as_str);
                let contrast = self.other_side(rel).filter(|_| word == "it");
                // "A desk stands under the window. On its surface …": of the desk.
                let led = word == "it" && !self.s.subject && self.s.expect == Expect::Nothing && self.before.len() == 1;
                let items = contrast
                    .or_else(|| led.then(|| self.before.clone()))
                    .unwrap_or_else(|| self.their(word, np.det == Det::Each));
                if items.is_empty() {
                    return None;
                }
                self.s.it = items.clone();
                self.mark(k);
                Some((Lead::Items(items, np.det == Det::Each || word == "each"), k + 1))
            }
            NounKind::Room => self.room_object(k, rel),
            NounKind::Place(Place::Row) if self.row(np).is_some() => {
                self.mark(k);
                let part = self.row(np)?;
                Some((Lead::Items(vec![part], false), k + 1))
            }
            // "at its foot", "by its side"
            NounKind::Place(
                place @ (Place::Middle
                | Place::Foot
                | Place::Head
                | Place::Side
                | Place::Front
                | Place::Back
                | Place::End),
            ) if np.det == Det::Own && !self.their("it", false).is_empty() => {
                let items = self.their("it", false);
                self.mark(k);
                self.s.turned = Some(match place {
                    Place::Foot | Place::Front => Rel::InFrontOf,
                    Place::Back => Rel::Behind,
                    Place::Side if rel == Rel::On && np.words.first().is_some_and(|w| w == "edge") => Rel::On,
                    Place::Middle if items.iter().all(|o| self.brief.things[*o].group == Group::Table) => Rel::On,
                    _ => of_length(&np.which).or_else(|| of_length(&np.look.features)).unwrap_or(Rel::Beside),
                });
                Some((Lead::Items(items, false), k + 1))
            }
            NounKind::Place(place) => {
                self.mark(k);
                Some(self.place_object(k, end, rel, place, np))
            }
            // "on its cushioned top": on it, and a look of it.
            NounKind::Abstract if np.det == Det::Own && get().is(&np.head(), Class::Surface) => {
                let items = self.their("it", false);
                let last = *items.last()?;
                let words = self.tokens[self.chunks[k].at.clone()].iter().skip(1);
                let text: Vec<&str> = words.map(|t| t.text.as_str()).collect();
                self.brief.things[last].look.features.push(text.join(" "));
                self.mark(k);
                Some((Lead::Items(items, false), k + 1))
            }
            NounKind::Abstract => {
                let id = self.collective(np)?;
                self.mark(k);
                Some((Lead::Items(vec![id], false), k + 1))
            }
        }
    }

    /// Things as the object of a relation: one, or several that are listed.
    fn things_object(&mut self, k: usize, end: usize, rel: Rel, np: &Np) -> Option<(Lead, usize)> {
        // "between two tables": any two of those there are.
        let two = np.count == Some(2) && np.det == Det::Number && rel == Rel::Between;
        let known = self.find(np).filter(|f| {
            let item = &self.brief.things[*f];
            two && item.number.many() && item.words == np.words && item.room == self.room
        });
        let id = match known {
            Some(id) => id,
            None => self.resolve(k, np, true)?,
        };
        self.mark(k);
        self.recent.push(id);
        let mut items = self.all_of(id, np);
        let mut next = self.after_noun(k + 1, end, id);
        // "on each of three tables", but not "on all three tables".
        let first = &self.tokens[self.chunks[k].at.start];
        let mut each = np.det == Det::Each && (np.count.is_none() || first.is("each") || first.is("every"));
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

    /// A room as the object of a relation: one is in it from now on, or a door leads there.
    fn room_object(&mut self, k: usize, rel: Rel) -> Option<(Lead, usize)> {
        let room = self.rooms.spoken.get(&k).copied();
        if let Some(room) = room {
            self.s.rooms.push(room);
            self.s.room_last = true;
        }
        if self.s.centre && !self.near.is_empty() {
            let of = self.near.clone();
            self.at_place(&of, Rel::In, Place::Middle, &[]);
        }
        if matches!(rel, Rel::In | Rel::At)
            && let Some(room) = room.filter(|_| !self.s.doors)
        {
            self.enter(room);
            self.mark(k);
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

    /// "the end of the counter" is on the counter, "the corner of the room" is of the room; "the wall opposite the door".
    pub(super) fn place_object(&mut self, k: usize, end: usize, said: Rel, place: Place, np: &Np) -> (Lead, usize) {
        let mut which = np.which.clone();
        // "the long side" is no look of it.
        which.extend(np.look.features.iter().filter(|f| of_length(std::slice::from_ref(f)).is_some()).cloned());
        if np.det == Det::Each || np.many {
            which.push("each".into());
        }
        let mut next = k + 1;
        if matches!(self.piece(next, end), Some(ChunkPiece::Rel(Rel::Of))) {
            match self.np(next + 1, end).map(|n| (n.kind, n)) {
                Some((NounKind::Room, np)) => {
                    if let Some(room) = self.rooms.spoken.get(&(next + 1)).copied() {
                        self.room_look(room, np);
                        self.s.rooms.push(room);
                        if !self.s.of_room {
                            self.enter(room);
                        }
                    }
                    self.mark(next);
                    self.mark(next + 1);
                    next += 2;
                }
                Some((NounKind::Thing, np))
                    if !matches!(place, Place::Wall | Place::Corner | Place::Ceiling | Place::Floor) =>
                {
                    if let Some(id) = self.resolve(next + 1, np, true) {
                        self.mark(next);
                        self.mark(next + 1);
                        let edge =
                            said == Rel::On && self.tokens[self.chunks[k].at.clone()].iter().any(|t| t.is("edge"));
                        let rel = of_part(place, said, edge);
                        if rel.is_some() {
                            let carries = !matches!(
                                self.brief.things[id].group,
                                Group::Seat | Group::Wall | Group::Ceiling | Group::Door | Group::Window
                            );
                            if place == Place::Middle && carries && matches!(said, Rel::At | Rel::In | Rel::On) {
                                self.s.turned = Some(Rel::Centre);
                            } else if let (Place::Side, Some(side)) = (place, of_length(&which)) {
                                self.s.turned = Some(side);
                            } else if matches!(said, Rel::At | Rel::In) && !self.is_small_thing() {
                                self.s.turned = rel.map(|r| if r == Rel::On { Rel::Beside } else { r });
                            } else if matches!(said, Rel::At | Rel::In) {
                                // "a vase at one end of the sideboard"
                                self.s.turned = rel;
                            }
                            let both = matches!(place, Place::Side | Place::End) && which.iter().any(|w| w == "each");
                            if both && of_length(&which).is_none() {
                                self.s.turned = Some(Rel::Sides);
                                self.s.lead_twice |= !self.s.subject;
                                self.double();
                            }
                            return (Lead::Items(vec![id], np.det == Det::Each), next + 2);
                        }
                        next += 2;
                    }
                }
                // "in the middle of the wall": at the wall.
                Some((NounKind::Place(Place::Wall), np))
                    if matches!(place, Place::Middle | Place::End | Place::Side) =>
                {
                    self.mark(next);
                    self.mark(next + 1);
                    return (Lead::Place(Place::Wall, np.which.clone()), next + 2);
                }
                // "in the middle of it": of the room spoken of.
                Some((NounKind::Pronoun, np))
                    if self.about_room && !self.s.subject && np.words.first().is_some_and(|w| w == "it") =>
                {
                    self.mark(next);
                    self.mark(next + 1);
                    next += 2;
                }
                Some((NounKind::Pronoun, np)) => {
                    let items = self.their(np.words.first().map_or("", String::as_str), np.det == Det::Each);
                    self.mark(next + 1);
                    if !items.is_empty()
                        && !matches!(place, Place::Wall | Place::Corner | Place::Ceiling | Place::Floor)
                    {
                        let side = of_length(&which).filter(|_| place == Place::Side);
                        if side.is_some() {
                            self.s.turned = side;
                        } else if place == Place::Side && which.iter().any(|w| w == "each") {
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

    /// Whether a relation says "either side", "both sides".
    pub(super) fn sides(&self, i: usize) -> bool {
        let words = &self.tokens[self.chunks[i].at.clone()];
        let both = words.iter().any(|t| t.is("left")) && words.iter().any(|t| t.is("right"));
        both || words.iter().any(|t| matches!(t.text.as_str(), "each" | "either" | "both"))
    }

    /// "round lamps, one for each counter": as many as there are of the other.
    pub(super) fn one_each(&mut self, of: &[usize], owner: usize) {
        for o in of.iter().filter(|o| **o != owner) {
            let item = &mut self.brief.things[*o];
            if item.number.many() && item.number.said().is_none() && !item.number.follows() {
                item.number = Number::Each { of: owner, number: 1 };
            }
        }
    }

    /// "nothing in front of the door", "nothing between the door and the desk".
    fn nothing(&mut self, i: usize, rel: Rel, items: &[usize]) {
        match (rel, items) {
            (Rel::InFrontOf | Rel::Behind | Rel::LeftOf | Rel::RightOf | Rel::Above | Rel::Around, _) => {
                self.clear(items, rel, CLEAR)
            }
            (Rel::Near | Rel::Beside | Rel::At, _) => self.say(items, FactKind::Alone(0.5)),
            (Rel::Between, [a, rest @ ..]) if !rest.is_empty() => {
                self.say(&[*a], FactKind::Rel(Rel::Visible, rest.to_vec()))
            }
            _ => self.chunks[i].at.clone().for_each(|t| self.used[t] = false),
        }
    }

    pub(super) fn measure_follows(&self, from: usize, end: usize) -> bool {
        self.chunks[from..end]
            .iter()
            .take_while(|c| c.piece != ChunkPiece::Comma)
            .any(|c| matches!(c.piece, ChunkPiece::Measure(_)))
    }

    /// "…, and behind it a mirror hangs": a relation that its subject follows.
    pub(super) fn preposed(&self, i: usize, next: usize, end: usize) -> bool {
        let joins = |c: &Chunk| {
            matches!(c.piece, ChunkPiece::And | ChunkPiece::Comma)
                || matches!(self.tokens[c.at.start].text.as_str(), "while" | "but")
        };
        let joined = i > 0 && joins(&self.chunks[i - 1]);
        let after =
            if matches!(self.piece(next, end), Some(ChunkPiece::Verb(Verb::Be | Verb::Hang) | ChunkPiece::There)) {
                next + 1
            } else {
                next
            };
        let fresh = |n: &Np| n.kind == NounKind::Thing && matches!(n.det, Det::Indefinite | Det::Number | Det::None);
        joined && self.np(after, end).is_some_and(fresh)
    }

    /// "a nightstand on each side": two of them.
    pub(super) fn double(&mut self) {
        for o in self.near.clone() {
            let item = &mut self.brief.things[o];
            if item.number == Number::Exactly(1) {
                item.number = Number::Exactly(2);
            }
        }
    }

    pub(super) fn enter(&mut self, room: usize) {
        // What this sentence has brought in so far is in that room.
        let start = self.s.at.start;
        for item in self.brief.things.iter_mut().filter(|i| i.source.at().start >= start) {
            item.room = room;
        }
        (self.room, self.room_listed) = (room, false);
    }

    /// Another object after "and": a definite one, or anything where two are needed.
    pub(super) fn more_objects(&self, k: usize, end: usize, rel: Rel, so_far: usize) -> Option<usize> {
        if !matches!(self.piece(k, end), Some(ChunkPiece::And)) {
            return None;
        }
        let np = self.np(k + 1, end).filter(|n| n.kind == NounKind::Thing)?;
        if rel == Rel::Between {
            return (so_far < 2).then_some(k + 1);
        }
        let alone = matches!(
            self.piece(k + 2, end),
            None | Some(ChunkPiece::Comma | ChunkPiece::Stop | ChunkPiece::Line | ChunkPiece::Close)
        );
        let known = np.det == Det::Definite || np.det == Det::None && np.count.is_none() && self.find(np).is_some();
        (alone && known).then_some(k + 1)
    }

    /// The usual relation of things to their owner gives way to the one in words.
    pub(super) fn drop_usual(&mut self, of: &[usize]) {
        if let Expect::With(owner, Join::Usual) = &self.s.expect {
            let within = |at: Range<usize>| self.s.at.start <= at.start && at.end <= self.s.at.end;
            self.brief.facts.retain(|f| {
                !(f.of.len() == 1
                    && of.contains(&f.of[0])
                    && within(f.source.at())
                    && matches!(&f.what, FactKind::Rel(_, o) if o == owner)
                    && !f.not)
            });
        }
    }

    /// "chairs on all four sides": at least one at each, so four where nobody counts them.
    pub(super) fn four_sides(&mut self, i: usize, of: &[usize]) {
        if !self.chunks[i].at.clone().any(|t| self.tokens[t].is("four")) {
            return;
        }
        for o in of {
            let item = &mut self.brief.things[*o];
            if item.number == Number::Plural {
                item.number = Number::Exactly(4);
            }
        }
    }

    /// Says a relation.
    pub(super) fn relate(&mut self, of: &[usize], rel: Rel, to: &[usize]) {
        let of: Vec<usize> = of.iter().copied().filter(|o| !to.contains(o) || to.len() == 1 && of.len() == 1).collect();
        // "sunlight streams through a window onto a table": windows are on nothing.
        let opening = matches!(rel, Rel::On | Rel::In) && of.iter().all(|o| self.brief.things[*o].opening());
        if of.is_empty() || opening {
            return;
        }
        let of = if rel == Rel::On { self.able_to_lie(&of, to).to_vec() } else { of };
        // Nothing lies on what lies on it.
        let back = |f: &Fact| matches!(&f.what, FactKind::Rel(r, o) if *r == rel && *o == of && f.of == to && !f.not);
        if of == to
            || matches!(rel, Rel::On | Rel::Under | Rel::In | Rel::Above)
                && self.brief.facts.iter().rev().take(8).any(back)
        {
            return;
        }
        self.say(&of, FactKind::Rel(rel, to.to_vec()));
        self.s.object = to.to_vec();
        if matches!(rel, Rel::LeftOf | Rel::RightOf) {
            self.side = Some((rel, to.to_vec()));
        }
        if rel == Rel::On {
            self.s.shared = Some((rel, to.to_vec()));
        }
        self.s.last = Some((of, rel, to.to_vec()));
    }

    /// "Ten chairs, a counter and some magazines on a low table": of a list only the last things that people put on tables.
    fn able_to_lie<'a>(&self, of: &'a [usize], to: &[usize]) -> &'a [usize] {
        let group = |o: &usize| self.brief.things[*o].group;
        let carries = |o: &usize| matches!(group(o), Group::Table | Group::Storage);
        let heavy = |o: &usize| matches!(group(o), Group::Seat | Group::Table | Group::Bed | Group::Storage);
        let stands = |o: &usize| heavy(o) || group(o) == Group::Floor;
        let last = of.iter().rposition(stands).map_or(0, |at| at + 1);
        let is_list = of.iter().any(heavy) && to.iter().all(carries) && last < of.len();
        if is_list { &of[last..] } else { of }
    }

    pub(super) fn at_place(&mut self, of: &[usize], rel: Rel, place: Place, which: &[String]) {
        // "an island with stools along one long side": of what they come with, or what was spoken of before.
        if let (Place::Side | Place::End, Some(side)) = (place, of_length(which)) {
            let owner = match &self.s.expect {
                Expect::With(owner, _) if !owner.is_empty() => owner.clone(),
                _ => self.before.clone(),
            };
            let table = |o: &usize| !of.contains(o) && self.brief.things[*o].group == Group::Table;
            let owner: Vec<usize> = owner.into_iter().filter(table).collect();
            if !owner.is_empty() {
                return self.relate(of, side, &owner);
            }
        }
        match (place, &self.s.expect) {
            // "an island with stools along one side"
            (Place::Side | Place::End, Expect::With(owner, _))
                if !owner.is_empty() && matches!(rel, Rel::Along | Rel::At | Rel::On) && which.is_empty() =>
            {
                let owner = owner.clone();
                return self.relate(of, Rel::Along, &owner);
            }
            _ => {}
        }
        if place == Place::Corner && which.iter().any(|w| w == "each") {
            // "speakers in every corner", "a barrel in each corner": rooms have four.
            for o in of {
                let item = &mut self.brief.things[*o];
                let is_one = item.number.said().is_none_or(|n| n == 1);
                if !item.number.follows() && is_one {
                    item.number = Number::Exactly(4);
                }
            }
        }
        match place {
            Place::Row if which.iter().any(|w| w == "several") => self.say(of, FactKind::Pattern(Pattern::Rows(None))),
            Place::Row => self.say(of, FactKind::Pattern(Pattern::Row)),
            Place::Circle => self.say(of, FactKind::Pattern(Pattern::Circle)),
            Place::Side | Place::End | Place::Head | Place::Foot if which.iter().any(|w| w == "each") => {
                // "on each side": of what was spoken of before.
                let to = self.before.clone();
                if !to.is_empty() {
                    self.relate(of, Rel::Sides, &to);
                }
            }
            _ => {
                let hangs = self.s.hang && place == Place::Wall && rel != Rel::In;
                self.say(of, FactKind::Place(if hangs { Rel::Mounted } else { rel }, place, which.to_vec()));
            }
        }
        self.s.last = None;
    }
}

/// What a part of a thing that something is at makes of it: on the edge of the tub is on it.
fn of_part(place: Place, said: Rel, edge: bool) -> Option<Rel> {
    Some(match place {
        Place::Side if edge => Rel::On,
        // "toys on the head of the bed"
        Place::Head | Place::Foot if said == Rel::On => Rel::On,
        Place::Side | Place::Head => Rel::Beside,
        Place::Foot | Place::Front => Rel::InFrontOf,
        Place::Back => Rel::Behind,
        Place::End | Place::Middle => Rel::On,
        _ => return None,
    })
}

/// The long or the short side of a thing, if that is said.
fn of_length(which: &[String]) -> Option<Rel> {
    which.iter().find_map(|w| match w.as_str() {
        "long" | "longer" | "longest" => Some(Rel::LongSide),
        "short" | "shorter" | "shortest" => Some(Rel::ShortSide),
        _ => None,
    })
}
