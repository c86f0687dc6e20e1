//! What is said right after a noun: looks, sizes, parts, how many there are, for each of what; and what must not be there.

use super::*;

impl Reader<'_> {
    /// What a second mention adds.
    pub(super) fn more_of(&mut self, id: usize, np: &Np) {
        let look = np.look.clone();
        let item = &mut self.brief.things[id];
        if let (None, Some(n)) = (item.number.said(), np.count) {
            item.number = Number::Exactly(n);
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

    /// "one chair per desk", "a chair for each bed", "ten tables, four chairs each": so many for each.
    pub(super) fn for_each(&mut self, k: usize, end: usize, id: usize, group: &[usize]) -> usize {
        let is_for =
            matches!(self.piece(k, end), Some(ChunkPiece::Word(_))) && self.tokens[self.chunks[k].at.start].is("for");
        if let (true, Some(np)) = (is_for, self.np(k + 1, end))
            && (np.kind, np.det) == (NounKind::Thing, Det::Each)
            && let Some(owner) = self.find(np).filter(|owner| *owner != id)
        {
            self.mark(k);
            self.mark(k + 1);
            self.multiply(&[id], owner);
            self.join(&[owner], &[id], Join::Usual);
            return k + 2;
        }
        // "two beds and a chair for each"
        let is_for = is_for && self.np(k + 1, end).is_some_and(|np| np.kind == NounKind::Pronoun);
        let of = k + usize::from(is_for);
        let Some(np) = self.np(of, end).filter(|n| n.det == Det::Each || n.kind == NounKind::Pronoun) else { return k };
        let owner = if np.kind == NounKind::Thing && self.tokens[self.chunks[of].at.start].is("per") {
            self.find(np)
        } else {
            let ends =
                matches!(self.piece(of + 1, end), None | Some(ChunkPiece::Comma | ChunkPiece::And | ChunkPiece::Close));
            let many = |o: &&usize| **o != id && self.brief.things[**o].number.many();
            let lists = || group.iter().rev().chain(self.main.iter()).chain(self.before.iter());
            let each = np.kind == NounKind::Pronoun && np.words.first().is_some_and(|w| w == "each");
            if each && ends { lists().find(many).copied() } else { None }
        };
        let Some(owner) = owner.filter(|o| *o != id) else { return k };
        (k..=of).for_each(|chunk| self.mark(chunk));
        self.multiply(&[id], owner);
        self.join(&[owner], &[id], Join::Usual);
        of + 1
    }

    /// Looks, sizes and parts right after a noun: "(white, 2 m wide)", "of dark cedar", "in yellow steel", "with armrests".
    pub(super) fn after_noun(&mut self, from: usize, end: usize, id: usize) -> usize {
        let mut k = from;
        let mut depth = 0;
        loop {
            if let Some(next) = self.count_after(k, end, id, from).or_else(|| self.places_after(k, end, id)) {
                k = next;
                continue;
            }
            match self.piece(k, end) {
                Some(ChunkPiece::Open) => depth += 1,
                Some(ChunkPiece::Close) => depth -= 1,
                Some(ChunkPiece::Attr(look)) => {
                    self.mark(k);
                    self.add_look(&[id], look);
                }
                // "a block of wood"
                Some(ChunkPiece::Rel(Rel::Of))
                    if self.is_look_at(k + 1, end)
                        && self.brief.things[id].words.last().is_some_and(|w| get().is(w, Class::Portion)) =>
                {
                    let text: Vec<&str> = self.chunks[k + 1].at.clone().map(|t| self.tokens[t].text.as_str()).collect();
                    self.brief.things[id].of = Some(format!("of {}", text.join(" ")));
                    self.mark(k);
                }
                Some(ChunkPiece::Rel(Rel::Of | Rel::In)) if self.is_look_at(k + 1, end) => self.mark(k),
                Some(ChunkPiece::Rel(Rel::Of))
                    if self.np(k + 1, end).is_some_and(|n| {
                        matches!(n.kind, NounKind::Thing | NounKind::Abstract) && n.det == Det::None
                    }) =>
                {
                    // "a bowl of mints", "a stack of books"
                    self.holds(k, end, id);
                    k += 1;
                }
                Some(ChunkPiece::Measure(m))
                    if !m.area && (m.values.len() > 1 || !m.dims.is_empty()) && is_its_size(m) =>
                {
                    let mut dims = Vec::new();
                    crate::read::noun::add_dims(&mut dims, &m.values, &m.dims);
                    let whole = self.brief.whole(id);
                    self.brief.things[whole].take_dims(&dims);
                    self.mark(k);
                }
                Some(ChunkPiece::Comma) if self.part_here(k + 1, end).is_some() => {
                    // "a desk, glass top, …"
                    k = self.part_after_comma(k, end, id);
                    continue;
                }
                Some(ChunkPiece::Comma)
                    if self.is_look_at(k + 1, end)
                        || matches!(self.piece(k + 1, end), Some(ChunkPiece::Measure(m)) if !m.dims.is_empty() && is_its_size(m)) =>
                    {}
                Some(ChunkPiece::Comma | ChunkPiece::And) if depth > 0 => {}
                Some(ChunkPiece::And) if self.is_look_at(k + 1, end) => {}
                Some(ChunkPiece::Np(np))
                    if depth > 0
                        && (get().part(&np.head()) || np.look != crate::draft::Look::default() && !np.known) =>
                {
                    // "(white tops, grey steel frames)"
                    self.add_look(&[id], &np.look.clone());
                    self.feature(id, k..k + 1);
                }
                Some(ChunkPiece::With) if self.np(k + 1, end).is_some_and(part_of_it) => {
                    let back = matches!(self.piece(k + 2, end), Some(ChunkPiece::Rel(r)) if *r != Rel::Of);
                    if back {
                        break;
                    }
                    self.near = vec![id];
                    k = self.with_part(k, end);
                    continue;
                }
                // "a shelf on wheels"
                Some(ChunkPiece::Rel(Rel::On)) if self.np(k + 1, end).is_some_and(is_what_it_stands_on) => {
                    self.feature(id, k..k + 2);
                    k += 1;
                }
                // "palms in black pots", "a picture in a gold frame"
                Some(ChunkPiece::Rel(Rel::In))
                    if matches!(self.brief.things[id].group, Group::Floor | Group::Wall)
                        && self.np(k + 1, end).is_some_and(is_what_it_is_in) =>
                {
                    self.feature(id, k..k + 2);
                    k += 1;
                }
                Some(ChunkPiece::Word(_)) if self.shape(k, end).is_some() => {
                    let np = self.shape(k, end).unwrap_or(k);
                    self.feature(id, k..np + 1);
                    k = np;
                }
                Some(ChunkPiece::Soft) if depth > 0 => self.mark(k),
                Some(ChunkPiece::Word(_) | ChunkPiece::Measure(_)) if depth > 0 => {}
                Some(ChunkPiece::Np(np)) if depth > 0 && np.kind == NounKind::Abstract => {}
                _ => break,
            }
            k += 1;
        }
        k
    }

    /// Whether a chunk says how something looks.
    fn is_look_at(&self, k: usize, end: usize) -> bool {
        matches!(self.piece(k, end), Some(ChunkPiece::Attr(_)))
    }

    /// "a lamp shaped like a moon": the chunk of the moon.
    fn shape(&self, k: usize, end: usize) -> Option<usize> {
        let is_shaped = self.tokens[self.chunks[k].at.start].is("shaped");
        (k + 1..end.min(k + 4)).find(|n| is_shaped && self.np(*n, end).is_some())
    }

    /// Words that are kept as they are, as something that a thing has.
    fn feature(&mut self, id: usize, chunks: Range<usize>) {
        let words = &self.tokens[self.chunks[chunks.start].at.start..self.chunks[chunks.end - 1].at.end];
        let text: Vec<&str> = words.iter().map(|t| t.text.as_str()).collect();
        self.brief.things[id].look.features.push(text.join(" "));
        chunks.for_each(|chunk| self.mark(chunk));
    }

    /// "a jar of honey", "a stack of books": what is in it, or what it is made of.
    fn holds(&mut self, k: usize, end: usize, id: usize) {
        self.mark(k);
        self.mark(k + 1);
        let text: Vec<&str> = self.chunks[k + 1].at.clone().map(|t| self.tokens[t].text.as_str()).collect();
        let name = text.join(" ");
        let head = self.brief.things[id].words.last().cloned().unwrap_or_default();
        if get().is(&head, Class::Holder) && self.np(k + 1, end).is_some_and(|n| n.count.is_none()) {
            // "a jar of honey", "a bar of soap"
            let item = &mut self.brief.things[id];
            item.of = Some(format!("of {name}"));
            if get().is(&head, Class::Portion) && matches!(item.group, Group::Floor | Group::Table) {
                item.group = Group::Top;
            }
            return;
        }
        let heap = self.brief.things[id].words.last().is_some_and(|w| matches!(w.as_str(), "stack" | "pile"));
        match self.np(k + 1, end).filter(|n| heap && n.kind == NounKind::Thing) {
            // "a stack of beer mats"
            Some(np) => {
                let words = np.words.clone();
                self.brief.things[id].words.splice(0..0, words);
            }
            None => self.brief.things[id].look.features.push(format!("of {name}")),
        }
    }

    /// A part that is said after a comma; the chunk behind it.
    fn part_after_comma(&mut self, k: usize, end: usize, id: usize) -> usize {
        let to = self.part_here(k + 1, end).unwrap_or(k + 1);
        let range = self.chunks[k + 1].at.start..self.chunks[to - 1].at.end;
        let tokens = &self.tokens[range];
        if let Some((look, _)) = crate::read::chunk::looks(tokens) {
            self.add_look(&[id], &crate::draft::Look { features: vec![], ..look });
        }
        let text: Vec<&str> = tokens.iter().map(|t| t.text.as_str()).collect();
        self.brief.things[id].look.features.push(text.join(" "));
        (k + 1..to).for_each(|c| self.mark(c));
        to
    }

    /// How many there are, said after the noun: "(6)", "x 2", "bookcases - four", "shelving / 8 / …".
    pub(super) fn count_after(&mut self, k: usize, end: usize, id: usize, first: usize) -> Option<usize> {
        let text = |i: usize| (i < end).then(|| self.tokens[self.chunks[i].at.start].text.as_str());
        if self.piece(k, end) == Some(&ChunkPiece::Comma) && matches!(text(k + 1), Some("x" | "×")) {
            return self.count_after(k + 1, end, id, first);
        }
        let n = self.number_at(k + 1, end)?;
        let after = self.piece(k + 2, end);
        let alone =
            matches!(after, None | Some(ChunkPiece::Comma | ChunkPiece::Close | ChunkPiece::Line | ChunkPiece::Stop));
        let said = match self.piece(k, end)? {
            ChunkPiece::Open => alone || matches!(text(k + 2), Some("no" | "nos" | "off" | "pcs" | "pieces")),
            ChunkPiece::Comma => alone && k == first,
            ChunkPiece::Word(_) => matches!(text(k), Some("x" | "×")) && alone,
            _ => false,
        };
        // "heat lamps over the pass - four": of the lamps.
        let definite = self.chunks[first - 1].np().is_some_and(|np| !matches!(np.det, Det::None | Det::Number));
        let subject = self.main.first().copied().filter(|_| definite && self.s.subject).unwrap_or(id);
        let item = &mut self.brief.things[subject];
        let free = item.part.is_none()
            && !item.number.follows()
            && if definite {
                item.number.many() && item.number.said().is_none()
            } else {
                item.number.said().is_none_or(|c| c == 1)
            };
        if !said || !free || n == 0 {
            return None;
        }
        item.number = Number::Exactly(n.min(MOST_COUNT));
        let at = item.source.at();
        self.brief.notes.extend(crate::read::counts::said(n as f64).map(|reason| Note { at, reason }));
        self.mark(k + 1);
        Some(k + 2 + usize::from(matches!(self.piece(k + 2, end), Some(ChunkPiece::Not | ChunkPiece::Word(_)))))
    }

    /// "a table for six", "six tables, each for four pupils".
    fn places_after(&mut self, k: usize, end: usize, id: usize) -> Option<usize> {
        let each = self.piece(k, end) == Some(&ChunkPiece::Comma)
            && self.chunks.get(k + 1).is_some_and(|c| c.at.len() == 1 && self.tokens[c.at.start].is("each"));
        let first = if each { k + 2 } else { k };
        let from = self.chunks.get(first).filter(|_| first < end)?.at.start;
        let (n, words) = crate::read::people::places(&self.tokens[from..])?;
        let seats = matches!(self.brief.things[id].group, Group::Table | Group::Seat | Group::Bed);
        let to = (first..end).find(|c| self.chunks[*c].at.end == from + words).filter(|_| seats)? + 1;
        let whole = self.brief.whole(id);
        self.brief.things[whole].places = Some(n);
        (k..to).for_each(|c| self.mark(c));
        Some(to)
    }

    /// "no television and no whiteboard".
    pub(super) fn deny(&mut self, i: usize, end: usize) -> usize {
        let mut k = i;
        let first = self.np(i, end).map_or(Det::None, |np| np.det);
        while let Some(np) = self.np(k, end).filter(|n| n.kind == NounKind::Thing) {
            let at = self.bytes(k..k + 1);
            // "no blorbing" rules out nothing that could be there.
            if np.known || !np.words.last().is_some_and(|w| w.ends_with("ing")) {
                self.brief.absent.push((np.name(), at));
                self.mark(k);
            }
            k += 1;
            let mut next = k;
            while matches!(self.piece(next, end), Some(ChunkPiece::And | ChunkPiece::Comma)) {
                next += 1;
            }
            // "no beds and two chairs": the chairs are there.
            let counted = self.np(next, end).is_some_and(|n| {
                n.kind == NounKind::Thing && (n.count.is_some() || n.det == Det::Indefinite && first != Det::Indefinite)
            });
            // "without a bed and with two chairs": so are these.
            if counted || self.np(next, end).is_none() {
                break;
            }
            k = next;
        }
        // Where it must not be says nothing more; one that must not be there is none that must not be at all.
        if matches!(self.piece(k, end), Some(ChunkPiece::Rel(Rel::Between | Rel::InFrontOf | Rel::Behind | Rel::Near)))
        {
            self.brief.absent.pop();
        }
        while k < end && !matches!(self.chunks[k].piece, ChunkPiece::Comma | ChunkPiece::And) {
            self.mark(k);
            k += 1;
        }
        self.s.not = false;
        k
    }
}

/// "wheels", "four legs".
fn is_what_it_stands_on(np: &Np) -> bool {
    matches!(np.head().as_str(), "wheel" | "castor" | "caster" | "leg") && matches!(np.det, Det::None | Det::Number)
}

/// "black pots", "a gold frame".
fn is_what_it_is_in(np: &Np) -> bool {
    matches!(np.head().as_str(), "pot" | "planter" | "tub" | "frame" | "flower pot" | "case")
        && matches!(np.det, Det::None | Det::Indefinite)
        && np.count.is_none()
}

/// Whether a measure says how large a thing is, and not how high something hangs.
fn is_its_size(measure: &Measure) -> bool {
    !measure.said && !measure.dims.iter().any(|d| matches!(d, Dim::Ceiling | Dim::Elevation))
}
