//! Measures: sizes, distances, free space, ways.

use super::*;

impl Reader<'_> {
    pub(super) fn on_measure(&mut self, i: usize, end: usize, m: &Measure) -> usize {
        self.mark(i);
        self.s.waits = i;
        self.s.range = m.least.map(|least| [least, m.values[0]]);
        let after_room = self.s.of_room && !self.s.subject || self.s.room_last;
        if m.dims.contains(&Dim::Ceiling) {
            let room = self.room;
            self.room_dim(room, Dim::Ceiling, m.values[0]);
            return i + 1;
        }
        if m.area {
            let room = self.room;
            self.brief.rooms[room].area = Some(m.values[0]);
            return i + 1;
        }
        if m.dims.contains(&Dim::Elevation) {
            let of = self.subject(i);
            self.say(&of, FactKind::Height(m.op, m.values[0]));
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
                Some(ChunkPiece::Verb(Verb::Keep) | ChunkPiece::ToIts(_) | ChunkPiece::Rel(Rel::InFrontOf))
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
                Some(ChunkPiece::Rel(Rel::Of))
                    if self.np(k + 1, end).is_some_and(|n| n.kind == NounKind::Abstract)
                        || matches!(self.piece(k + 1, end), Some(ChunkPiece::Free | ChunkPiece::Word(_))) =>
                {
                    k += 1
                }
                Some(ChunkPiece::Np(np)) if np.kind == NounKind::Abstract => k += 1,
                Some(ChunkPiece::Word(_)) if k < i + 4 => k += 1,
                Some(ChunkPiece::Verb(Verb::Be | Verb::Keep))
                    if matches!(
                        self.piece(k + 1, end),
                        Some(ChunkPiece::Verb(_) | ChunkPiece::Free | ChunkPiece::Word(_))
                    ) && self.s.keep =>
                {
                    k += 1
                }
                Some(ChunkPiece::Verb(Verb::Keep)) => k += 1,
                // "1.5 m is to be maintained between the rows"
                Some(ChunkPiece::Verb(Verb::Be))
                    if matches!(self.piece(k + 1, end), Some(ChunkPiece::Verb(Verb::Keep) | ChunkPiece::Word(_)))
                        && matches!(self.piece(k + 2, end), Some(ChunkPiece::Rel(_))) =>
                {
                    k += 1
                }
                _ => break,
            }
        }
        self.s.pending = Some(m.clone());
        match self.piece(k, end) {
            Some(ChunkPiece::Rel(_) | ChunkPiece::Apart | ChunkPiece::Free | ChunkPiece::ToIts(_)) => {}
            _ => {
                let at = i > 0 && matches!(self.chunks[i - 1].piece, ChunkPiece::Rel(Rel::At))
                    || i > 1 && matches!(self.chunks[i - 2].piece, ChunkPiece::Rel(Rel::At));
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
                    self.say(&of, FactKind::Height(m.op, m.values[0]));
                } else if !of.is_empty() && !m.said {
                    for o in of {
                        let o = self.brief.whole(o);
                        self.brief.things[o].take_dims(&[(Dim::Length, m.values[0])]);
                    }
                } else {
                    self.chunks[i].at.clone().for_each(|t| self.used[t] = false);
                }
            }
        }
        k
    }

    /// Whether a length is that of a way: "a 1.2 m path", "a path of 1.2 m".
    pub(super) fn path_follows(&self, i: usize) -> bool {
        let at = &self.chunks[i].at;
        let around = at.start.saturating_sub(3)..(at.end + 3).min(self.tokens.len());
        let ways = ["aisle", "aisles", "path", "paths", "walkway", "walkways", "passage", "passages"];
        self.tokens[around].iter().any(|t| ways.iter().any(|way| t.is(way)))
    }

    /// A way so wide: to what the sentence speaks of, from its door.
    pub(super) fn on_path(&mut self, i: usize, end: usize, m: &Measure) -> usize {
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
        let way = |np: &Np| {
            np.words.last().is_some_and(|w| matches!(w.as_str(), "path" | "walkway" | "passage" | "aisle" | "aisles"))
        };
        for k in self.s.chunks.start..end {
            let free = matches!(self.chunks[k].piece, ChunkPiece::Free | ChunkPiece::Rel(Rel::Between));
            if free || self.np(k, end).is_some_and(way) {
                self.mark(k);
            }
        }
        let mut k = i + 1;
        while k < end {
            if let Some(np) = self.np(k, end)
                && np.kind == NounKind::Thing
                && let Some(id) = self.find(np).or_else(|| self.introduce(k, np))
            {
                items.push(id);
                self.mark(k);
            }
            k += 1;
        }
        let mut seen = Vec::new();
        items.retain(|item| {
            !seen.contains(item) && {
                seen.push(*item);
                true
            }
        });
        self.s.lead.clear();
        match items.as_slice() {
            [] => self.chunks[i].at.clone().for_each(|t| self.used[t] = false),
            [one] => {
                let door = self.brief.things.iter().position(|it| it.group == Group::Door);
                match door {
                    // "aisles 2 m wide between six racks": from row to row.
                    _ if self.brief.things[*one].number.many() => {
                        self.say(&[*one], FactKind::Rows(Op::Least, m.values[0]))
                    }
                    Some(d) if d != *one => self.say(&[*one], FactKind::Path(m.values[0], vec![d])),
                    _ => self.say(&[*one], FactKind::Among(Op::Least, m.values[0])),
                }
            }
            [a, rest @ ..] => {
                // Between a door and what it leads to, one walks.
                let walked = items.iter().any(|item| self.brief.things[*item].opening());
                let between =
                    !walked && self.chunks[i + 1..end].iter().any(|c| c.piece == ChunkPiece::Rel(Rel::Between));
                let what = if between {
                    FactKind::Gap(Op::Least, m.values[0], rest.to_vec())
                } else {
                    FactKind::Path(m.values[0], rest.to_vec())
                };
                self.say(&[*a], what);
            }
        }
        end
    }

    /// Sizes of what was spoken of, or of the room.
    pub(super) fn on_size(&mut self, m: &Measure, of_room: bool) {
        let mut dims = Vec::new();
        crate::read::noun::add_dims(&mut dims, &m.values, &m.dims);
        let limit = m.said;
        if of_room || self.near.is_empty() && self.main.is_empty() && !self.s.subject && self.before.is_empty() {
            let room = self.s.rooms.last().copied().filter(|_| self.s.room_last).unwrap_or(self.room);
            // What was said first stands: "1 m by 1 m" later on is of something else.
            let size = self.brief.rooms[room].size;
            let whole = m.values.len() > 1 && size[0].is_some() && size[2].is_some();
            // Of a range a room takes the middle.
            let middle = m.least.map(|least| (least + m.values[0]) / 2.0);
            // "The corridor is at least 2 m wide": 2 m is enough.
            let is_size = !limit || middle.is_some() || of_room && !m.dims.is_empty();
            for (dim, value) in dims.into_iter().filter(|_| !whole && is_size) {
                self.room_dim(room, dim, middle.unwrap_or(value));
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
            self.say(&of, FactKind::Size(dim, op, dims[0].1));
        } else {
            for o in of {
                let o = self.brief.whole(o);
                self.brief.things[o].take_dims(&dims);
            }
        }
    }

    /// "90 cm clear in front of it", "a metre free on either side".
    pub(super) fn on_free(&mut self, i: usize, end: usize) -> usize {
        let mut k = i + 1;
        // "kept clear to a depth of 1.2 m"
        while matches!(self.piece(k, end), Some(ChunkPiece::Word(_) | ChunkPiece::Rel(Rel::Of)))
            || matches!(self.piece(k, end), Some(ChunkPiece::Rel(Rel::To)))
                && matches!(self.piece(k + 1, end), Some(ChunkPiece::Measure(_)))
            || self.np(k, end).is_some_and(|n| n.kind == NounKind::Abstract)
        {
            if let Some(ChunkPiece::Rel(Rel::Of | Rel::To)) = self.piece(k, end)
                && matches!(self.piece(k + 1, end), Some(ChunkPiece::Measure(_)))
            {
                k += 1;
                break;
            }
            k += 1;
        }
        if let Some(ChunkPiece::Measure(m)) = self.piece(k, end) {
            self.s.pending = Some(m.clone());
            self.s.waits = k;
            self.mark(k);
            k += 1;
            while self.np(k, end).is_some_and(|n| n.kind == NounKind::Abstract)
                || matches!(self.piece(k, end), Some(ChunkPiece::Word(_) | ChunkPiece::Verb(Verb::Be | Verb::Keep)))
            {
                k += 1;
            }
        }
        self.mark(i);
        // "the exits are to be kept clear to a depth of 1.2 m"
        let ends = matches!(self.piece(k, end), None | Some(ChunkPiece::Comma | ChunkPiece::And | ChunkPiece::Close));
        if ends && self.s.subject && self.s.keep && !self.s.path {
            let passage = self.main.iter().all(|o| self.brief.things[*o].opening());
            let depth = match self.s.pending.take() {
                Some(m) => Some(m.values[0]),
                None => passage.then_some(CLEAR),
            };
            let of = self.main.clone();
            if let Some(depth) = depth.filter(|_| !of.is_empty()) {
                self.clear(&of, Rel::InFrontOf, depth);
            }
        }
        k
    }

    /// A relation with a measure.
    pub(super) fn measured(&mut self, of: &[usize], rel: Rel, to: &[usize], m: &Measure, not: bool) {
        let keep = self.s.keep || self.s.nothing;
        match rel {
            Rel::Between => {
                let m = Measure { op: flip(m, not || self.s.nothing), ..m.clone() };
                match to {
                    [a, rest @ ..] if !rest.is_empty() => {
                        self.say(&[*a], FactKind::Gap(min_if_keep(&m, self.s.keep), m.values[0], rest.to_vec()))
                    }
                    [one, ..] => {
                        let what = FactKind::Among(min_if_keep(&m, self.s.keep), m.values[0]);
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
                if self.s.nothing && (of.is_empty() || of == to || !self.s.subject) =>
            {
                self.say(to, FactKind::Alone(m.values[0]));
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

    pub(super) fn distance(&mut self, of: &[usize], rel: Rel, to: &[usize], m: &Measure) {
        let of: Vec<usize> = of.iter().copied().filter(|o| !to.contains(o)).collect();
        if of.is_empty() {
            return;
        }
        if !matches!(rel, Rel::From | Rel::Of | Rel::To | Rel::Far | Rel::Near | Rel::At | Rel::Than) {
            self.relate(&of, rel, to);
        }
        self.say(&of, FactKind::Gap(m.op, m.values[0], to.to_vec()));
    }

    pub(super) fn among(&mut self, m: &Measure) {
        let of = if self.main.is_empty() { self.before.clone() } else { self.main.clone() };
        let op = flip(m, self.s.not || self.s.nothing);
        match of.as_slice() {
            [a, rest @ ..] if !rest.is_empty() => self.say(&[*a], FactKind::Gap(op, m.values[0], rest.to_vec())),
            [_, ..] => self.say(&of, FactKind::Among(op, m.values[0])),
            [] => {}
        }
    }

    /// A distance between rows.
    pub(super) fn rows(&mut self, m: &Measure) {
        let op = min_if_keep(&Measure { op: flip(m, self.s.not || self.s.nothing), ..m.clone() }, true);
        let of = if self.main.is_empty() { self.before.clone() } else { self.main.clone() };
        let many = of.iter().copied().find(|o| self.brief.things[*o].number.many());
        let rows = self
            .brief
            .facts
            .iter()
            .rev()
            .find(|f| matches!(f.what, FactKind::Pattern(Pattern::Rows(_))))
            .map(|f| f.of[0]);
        if let Some(item) = rows.or(many) {
            self.say(&[item], FactKind::Rows(op, m.values[0]));
        }
    }

    pub(super) fn clear(&mut self, of: &[usize], rel: Rel, depth: f64) {
        let side = match rel {
            Rel::Behind => Side::Behind,
            Rel::LeftOf => Side::Left,
            Rel::RightOf => Side::Right,
            Rel::Above => Side::Above,
            Rel::Beside => Side::Sides,
            Rel::Around => Side::Around,
            _ => Side::Front,
        };
        self.say(of, FactKind::Clear(side, depth));
    }

    /// "Two doors: the main door …, the back door …": the two are those.
    fn listed_one_by_one(&mut self) {
        let start = self.s.at.start;
        let new = |i: &usize| self.brief.things[*i].source.at().start >= start && self.brief.things[*i].part.is_none();
        let mut items = (0..self.brief.things.len()).filter(new);
        let Some(first) = items.next().filter(|i| self.brief.things[*i].number.many()) else { return };
        let item = &self.brief.things[first];
        let colon = self
            .chunks
            .iter()
            .find(|c| self.tokens[c.at.start].at.start >= item.source.at().end)
            .is_some_and(|c| c.piece == ChunkPiece::Colon);
        let (last, count) = (item.words.last().cloned(), item.number.said());
        let others: Vec<usize> = items.collect();
        let named: usize = others.iter().map(|o| self.brief.things[*o].number.said().unwrap_or(0)).sum();
        let like = others.iter().all(|o| self.brief.things[*o].words.last() == last.as_ref());
        if colon && like && !others.is_empty() && Some(named) == count {
            self.gone.push(first);
        }
    }

    /// What is left when a sentence ends: relations whose subject was in the one before.
    pub(super) fn finish(&mut self) {
        self.listed_one_by_one();
        if !self.s.lead.is_empty() && !self.s.subject && !self.s.unknown && !self.before.is_empty() {
            self.main = self.before.clone();
            self.apply_lead();
        }
        if self.s.pending.take().is_some() {
            // It has found nothing that it is of.
            self.chunks[self.s.waits].at.clone().for_each(|t| self.used[t] = false);
        }
        self.framed();
        // "a scale on the counter, and a basket": on the counter too.
        if let Some((rel, to)) = self.s.shared.take() {
            let bare = |i: &usize| {
                self.small(*i, &to)
                    && self.brief.things[*i].group != Group::Wall
                    && !self.brief.facts.iter().any(|f| f.of.contains(i))
            };
            let of: Vec<usize> = self.main.iter().copied().filter(bare).collect();
            self.relate(&of, rel, &to);
        }
    }

    /// "On the desk, a cup stands next to a lamp, and a pen lies beside a pad": on the desk all four.
    fn framed(&mut self) {
        let Some(to) = self.s.frame.take() else { return };
        let carried = |i: usize| {
            self.brief.facts.iter().any(|f| {
                let place = matches!(
                    f.what,
                    FactKind::Place(..)
                        | FactKind::Rel(Rel::On | Rel::In | Rel::Under | Rel::Above | Rel::Mounted | Rel::Hang, _)
                );
                f.of.contains(&i) && place
            })
        };
        let within = |at: Range<usize>| self.s.at.start <= at.start && at.end <= self.s.at.end;
        let related = |i: usize| {
            self.brief.facts.iter().any(|f| {
                within(f.source.at())
                    && (f.of.contains(&i) || matches!(&f.what, FactKind::Rel(_, to) if to.contains(&i)))
            })
        };
        // "…, a lamp stands beside the armchair": not on the desk.
        let elsewhere = |i: usize| {
            self.brief.facts.iter().any(|f| {
                let other = |o: &usize| !to.contains(o) && !self.small(*o, &to) && !carried(*o);
                let apart = matches!(&f.what, FactKind::Rel(_, others) if others.iter().any(other));
                let stands = self.brief.things[i].group == Group::Floor;
                stands && within(f.source.at()) && f.of.contains(&i) && apart
            })
        };
        let own = |i: &usize| self.small(*i, &to) && self.brief.things[*i].part.is_none();
        let of: Vec<usize> =
            (0..self.brief.things.len()).filter(|i| own(i) && !carried(*i) && related(*i) && !elsewhere(*i)).collect();
        for item in of {
            self.relate(&[item], Rel::On, &to);
        }
    }

    /// Whether a thing of this sentence is small enough to stand on others.
    pub(super) fn small(&self, i: usize, to: &[usize]) -> bool {
        let item = &self.brief.things[i];
        let [w, _, d] = crate::sizes::usual(item.group, &item.words);
        item.source.at().start >= self.s.at.start
            && !to.contains(&i)
            && matches!(item.group, Group::Top | Group::Floor | Group::Soft | Group::Wall)
            && w * d < if item.group == Group::Wall { 0.05 } else { 0.3 }
    }
}
