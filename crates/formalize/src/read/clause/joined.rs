//! Things that come with others: "with", "each", what was said before its subject came.

use super::*;

/// One sits at these on one side.
const ONE_SIDED: [&str; 6] = ["desk", "bar", "counter", "island", "workbench", "bench"];

impl Reader<'_> {
    /// "Two armchairs and a sofa around a table": a sofa alone is around nothing, so the seats before it are meant as well.
    pub(super) fn with_seats_before(&self, i: usize, of: Vec<usize>) -> Vec<usize> {
        let piece = |back: usize| i.checked_sub(back).map(|k| &self.chunks[k]);
        let (Some(last), Some(and), Some(first)) = (piece(1), piece(2), piece(3)) else { return of };
        let is_seat = |o: &usize| self.brief.things[*o].group == Group::Seat;
        let named = |chunk: &Chunk| {
            let bytes = self.tokens[chunk.at.start].at.start..self.tokens[chunk.at.end - 1].at.end;
            self.brief.things.iter().position(|thing| bytes.contains(&thing.source.at().start))
        };
        let alone = matches!(of[..], [one] if named(last) == Some(one) && is_seat(&one) && self.brief.count(one) == 1);
        match named(first).filter(|o| alone && and.piece == ChunkPiece::And && is_seat(o)) {
            Some(before) => vec![before, of[0]],
            None => of,
        }
    }

    /// The same, but where there are as many of both, there is one for each: "five placemats, aligned with each chair".
    pub(super) fn share_out(&mut self, fresh: &[usize], owner: usize) {
        let all = self.brief.count(owner);
        let even = |f: &usize| self.brief.things[*f].number.said().is_some_and(|n| n > 1 && n == all);
        let fresh: Vec<usize> = fresh.iter().copied().filter(|f| !even(f)).collect();
        self.multiply(&fresh, owner);
    }

    /// So many of these for each of the owner's; a seat has no tables and no cupboards of its own.
    pub(super) fn multiply(&mut self, fresh: &[usize], owner: usize) {
        let seat = self.brief.things[owner].group == Group::Seat;
        for f in fresh {
            let item = &mut self.brief.things[*f];
            let own = item.number.said().unwrap_or(1);
            let large = matches!(item.group, Group::Table | Group::Storage | Group::Bed);
            if *f != owner && !item.number.follows() && !(seat && large) {
                item.number = Number::Each { of: owner, number: own };
            }
        }
    }

    /// "… and the wall".
    pub(super) fn wall_next(&self, next: usize, end: usize) -> bool {
        let wall = self.np(next + 1, end).is_some_and(|np| np.kind == NounKind::Place(Place::Wall));
        wall && self.piece(next, end) == Some(&ChunkPiece::And)
    }

    /// Relations said before the subject came.
    pub(super) fn apply_lead(&mut self) {
        let lead = std::mem::take(&mut self.s.lead);
        let of = self.main.clone();
        let fresh: Vec<usize> = of.clone();
        if let Some(pattern) = self.s.lead_pattern.take() {
            self.say(&of, FactKind::Pattern(pattern));
        }
        if std::mem::take(&mut self.s.lead_twice) {
            self.double();
        }
        for (rel, to) in &lead {
            match to {
                Lead::Items(items, _) if self.s.lead_not => {
                    let soft = self.soft();
                    self.state(&of, FactKind::Rel(*rel, items.clone()), soft, true);
                }
                Lead::Items(items, each) => {
                    if *each && items.len() == 1 {
                        self.share_out(&fresh, items[0]);
                    }
                    self.s.quantifier = if *each { Quantifier::Each } else { Quantifier::Usual };
                    self.relate(&of, *rel, items);
                    self.s.quantifier = Quantifier::Usual;
                    if *rel == Rel::On {
                        self.s.frame = Some(items.clone());
                    }
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
    pub(super) fn join(&mut self, owner: &[usize], things: &[usize], join: Join) {
        const RUN: [&str; 9] =
            ["sink", "stove", "oven", "hob", "cooktop", "cooker", "dishwasher", "fridge", "refrigerator"];
        for t in things {
            // "A bookcase, two tables with four chairs each": these are joined with their tables already.
            let is_shared = matches!(self.brief.things[*t].number, Number::Each { of, .. } if owner.contains(&of));
            if is_shared && owner.len() > 1 {
                continue;
            }
            // "A kitchen with an island with three stools and a double sink": the kitchen has the sink.
            let is_end = |thing: usize, ends: &[&str]| ends.contains(&self.brief.things[thing].head().as_str());
            let seats = self.brief.facts.iter().any(|fact| {
                fact.what.objects().unwrap_or_default().contains(&owner[0])
                    && fact.of.iter().any(|of| self.brief.things[*of].group == Group::Seat)
            });
            if join == Join::Usual && seats && is_end(*t, &RUN) && is_end(owner[0], &["island", "kitchen island"]) {
                continue;
            }
            if self.brief.things[owner[owner.len() - 1]].name() == crate::read::free_floor::AREA {
                continue;
            }
            self.seats_for(owner[owner.len() - 1], *t);
            let (group, owner_group) = (self.brief.things[*t].group, self.brief.things[owner[owner.len() - 1]].group);
            let usual = match group {
                Group::Top | Group::Screen if !matches!(owner_group, Group::Seat) => Some(Rel::On),
                Group::Soft => Some(Rel::On),
                // Who waits sits within sight of the reception, and not at its edge.
                Group::Seat if self.waits(*t, owner[0]) => Some(Rel::Near),
                Group::Seat if matches!(owner_group, Group::Table) => {
                    if ONE_SIDED.iter().any(|end| self.brief.things[owner[0]].head().ends_with(end)) {
                        Some(Rel::InFrontOf)
                    } else {
                        Some(Rel::Around)
                    }
                }
                Group::Seat => Some(Rel::Near),
                Group::Flat => Some(Rel::Under),
                Group::Drape if matches!(owner_group, Group::Window | Group::Door) => Some(Rel::Near),
                Group::Ceiling => Some(Rel::Above),
                Group::Floor if self.brief.things[*t].words.last().is_some_and(|w| w == "lamp") => {
                    Some(if owner_group == Group::Table { Rel::On } else { Rel::Beside })
                }
                Group::Floor if owner_group == Group::Seat && self.brief.things[*t].head() == "stand" => {
                    Some(Rel::InFrontOf)
                }
                Group::Table | Group::Storage | Group::Floor => Some(Rel::Beside),
                _ => None,
            };
            let rel = match join {
                Join::Usual => usual.map(|r| (r, false)),
                Join::On => Some((Rel::On, false)),
                Join::In => Some((Rel::In, false)),
                Join::Beside => Some((Rel::Sides, true)),
                Join::Around => Some((Rel::Around, true)),
                // "a sideboard illuminated by a table lamp"
                Join::Above if group == Group::Top => Some((Rel::On, false)),
                // "lit by a lamp and a chair beside it": what gives no light is lit by nothing.
                Join::Above if !self.gives_light(*t) => None,
                Join::Above => Some((Rel::Above, true)),
            };
            // A relation in words replaces the usual one: it is dropped again where one follows.
            if let Some((rel, _)) = rel {
                self.relate(&[*t], rel, owner);
            }
        }
    }

    /// Whether somebody waits on this seat at a desk or a counter.
    fn waits(&self, seat: usize, desk: usize) -> bool {
        let head = |thing: usize| self.brief.things[thing].head();
        let ends = |text: String, names: [&str; 3]| names.iter().any(|name| text.ends_with(name));
        ends(head(seat), ["sofa", "couch", "armchair"]) && ends(head(desk), ["reception desk", "front desk", "counter"])
    }

    /// "A bedroom with a bathroom, a desk and a wardrobe": the list goes on with what is in the bedroom.
    pub(super) fn goes_on_before(&self, i: usize, end: usize, room: usize) -> bool {
        let is_annex = self.rooms.several.get(room).is_some_and(|several| several.own == Some(self.room));
        let joins = |k: usize| matches!(self.piece(k, end), Some(ChunkPiece::Comma | ChunkPiece::And));
        let next = i + 1 + usize::from(joins(i + 1)) + usize::from(joins(i + 1) && joins(i + 2));
        let thing = self.np(next, end).filter(|np| np.kind == NounKind::Thing);
        let kind = crate::furnish::kinds::of(&self.rooms.rooms[room].name);
        let is_own = |noun: &str| {
            let lines = kind.iter().flat_map(|kind| &kind.lines);
            lines.into_iter().any(|line| crate::furnish::stand::counts_as(line.noun, noun))
        };
        is_annex && joins(i + 1) && thing.is_some_and(|np| !is_own(&np.name()))
    }

    /// "a table for six with chairs": as many as it has places.
    fn seats_for(&mut self, owner: usize, seat: usize) {
        let Some(number) = self.brief.things[owner].places else { return };
        let each = self.brief.things[owner].number.many();
        let seat = &mut self.brief.things[seat];
        if seat.group == Group::Seat && matches!(seat.number, Number::Plural | Number::Each { number: 1, .. }) {
            seat.number = if each { Number::Each { of: owner, number } } else { Number::Exactly(number) };
        }
    }

    /// "two lamps, one on each side of the bed": both of them. Whether that is said.
    pub(super) fn one_on_each_side(&mut self, i: usize, end: usize, np: &Np) -> bool {
        let side = matches!(self.piece(i + 1, end), Some(ChunkPiece::Rel(_))) && self.sides(i + 1);
        let pair = matches!(self.main.as_slice(), [pair] if self.brief.things[*pair].number.said() == Some(2));
        let said = np.count == Some(1) && side && pair;
        if said {
            self.near = self.main.clone();
            self.s.subject = true;
            self.mark(i);
            self.apply_lead();
        }
        said
    }

    /// "In two islands of three", "in groups of four": how things stand, and how many they are.
    pub(super) fn clusters(&mut self, i: usize, end: usize, rel: Rel) -> Option<usize> {
        const GROUPS: [&str; 7] = ["island", "block", "cluster", "group", "pod", "pair", "bank"];
        let chunk = self.chunks.get(i + 1).filter(|_| rel == Rel::In && i + 1 < end)?;
        let groups = crate::read::lexicon::singular(&self.tokens[chunk.at.end - 1].text);
        if groups == self.tokens[chunk.at.end - 1].text || !GROUPS.contains(&groups.as_str()) {
            return None;
        }
        let count = chunk.np().and_then(|np| np.count).filter(|n| *n > 1);
        let of = matches!(self.piece(i + 2, end), Some(ChunkPiece::Rel(Rel::Of)));
        let each = if of { self.number_at(i + 3, end) } else { None };
        let each = each.or_else(|| (groups == "pair").then_some(2));
        let of_it = if self.main.is_empty() { &self.near } else { &self.main };
        let next = i + 2 + if of && each.is_some() { 2 } else { 0 };
        let [item] = of_it[..] else { return count.map(|_| next) };
        let thing = &mut self.brief.things[item];
        if let (Some(n), Some(each)) = (count, each)
            && thing.number.many()
            && thing.number.said().is_none()
        {
            thing.number = Number::Exactly(n * each);
        }
        let all = thing.number.said();
        let groups = count.or_else(|| each.zip(all).map(|(each, all)| all / each.max(1)));
        let whole = |groups: &usize| all.is_some_and(|all| *groups > 0 && all % groups == 0 && all > *groups);
        if let Some(groups) = groups.filter(whole) {
            self.say(&[item], FactKind::Pattern(Pattern::Groups(groups)));
            (i..next).for_each(|chunk| self.mark(chunk));
        }
        Some(next)
    }

    /// "Which form three blocks of four", and the blocks later on: the things that form them. The next chunk.
    pub(super) fn forms(&mut self, i: usize, end: usize, np: &Np) -> Option<usize> {
        const GROUPS: [&str; 6] = ["block", "cluster", "group", "pod", "bank", "set"];
        let name = np.name();
        if let Some((_, of)) = self.formed.as_ref().filter(|(formed, _)| *formed == name) {
            self.main = vec![*of];
            self.near = self.main.clone();
            self.s.subject = true;
            self.mark(i);
            return Some(i + 1);
        }
        let n = np.count.filter(|n| *n > 1 && GROUPS.contains(&name.as_str()))?;
        let of = matches!(self.piece(i + 1, end), Some(ChunkPiece::Rel(Rel::Of)));
        let each = self.number_at(i + 2, end).filter(|_| of)?;
        let [item] = self.main[..] else { return None };
        let thing = &mut self.brief.things[item];
        if thing.number == Number::Plural && n * each <= MOST_COUNT {
            thing.number = Number::Exactly(n * each);
        }
        self.say(&[item], FactKind::Pattern(Pattern::Groups(n)));
        self.formed = Some((name, item));
        (i..i + 3).for_each(|chunk| self.mark(chunk));
        Some(i + 3)
    }

    /// "A shelf for controllers and headsets": that is where these are.
    pub(super) fn kept_there(&mut self, i: usize, np: &Np) {
        let is_for = i > 1
            && matches!(self.chunks[i - 1].piece, ChunkPiece::Word(_))
            && self.tokens[self.chunks[i].at.start - 1].is("for")
            && self.chunks[i - 2].np().is_some_and(|before| before.kind == NounKind::Thing);
        let small = np.many && matches!(np.det, Det::None | Det::Number) && np.group == Some(Group::Top);
        if let ([keeper], true) = (self.near.as_slice(), is_for && small)
            && matches!(self.brief.things[*keeper].group, Group::Storage | Group::Table)
            && self.s.expect == Expect::Nothing
        {
            self.s.expect = Expect::With(self.near.clone(), Join::Usual);
        }
    }
}
