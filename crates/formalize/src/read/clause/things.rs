//! Noun phrases: what they bring in or speak of again, what is said right after them, and who "it" is.

use super::*;

impl Reader<'_> {
    pub(super) fn on_np(&mut self, i: usize, end: usize, np: &Np) -> usize {
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
    pub(super) fn on_place_first(&mut self, i: usize, end: usize, place: Place, _np: &Np) -> usize {
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
    pub(super) fn doors(&mut self) {
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

    pub(super) fn connect(&mut self, from: usize, to: usize) {
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

    pub(super) fn on_pronoun(&mut self, i: usize, end: usize, np: &Np) {
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
    pub(super) fn it(&self) -> Vec<usize> {
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
    pub(super) fn them(&self) -> Vec<usize> {
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
    pub(super) fn resolve(&mut self, i: usize, np: &Np, object: bool) -> Option<usize> {
        let found = self.scene.find(np, self.room);
        let exact = found.filter(|f| {
            let item = &self.scene.items[*f];
            item.words == np.words && (np.look.color.is_none() || item.look.color == np.look.color)
        });
        let counted = |f: &usize| np.count.is_none_or(|n| self.scene.items[*f].count.is_none_or(|m| m >= n));
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

    pub(super) fn introduce(&mut self, i: usize, np: &Np) -> Option<usize> {
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

    pub(super) fn say(&mut self, of: &[usize], what: What) {
        let (soft, at) = (self.s.soft, self.s.at.clone());
        self.scene.say(of, what, soft, false, at);
    }

    /// Things named one after the other, with what is said of each right after it: sizes, looks, parts.
    pub(super) fn on_things(&mut self, i: usize, end: usize) -> usize {
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
    pub(super) fn more_of(&mut self, id: usize, np: &Np) {
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
    pub(super) fn list_next(&self, k: usize, end: usize) -> Option<usize> {
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
    pub(super) fn after_noun(&mut self, from: usize, end: usize, id: usize) -> usize {
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
                    if self
                        .np(k + 1, end)
                        .is_some_and(|n| matches!(n.kind, Kind::Thing | Kind::Abstract) && n.det == Det::None) =>
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
                    crate::read::noun::add_dims(&mut dims, &m.values, &m.dims);
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
    pub(super) fn deny(&mut self, i: usize, end: usize) -> usize {
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
    pub(super) fn place_group(&mut self, group: &[usize], new_from: usize, each: bool) {
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
    pub(super) fn multiply(&mut self, fresh: &[usize], owner: usize) {
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
    pub(super) fn apply_lead(&mut self) {
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
    pub(super) fn join(&mut self, owner: &[usize], things: &[usize], join: Join) {
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
}
