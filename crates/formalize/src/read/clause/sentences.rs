//! Where sentences end, and what begins none: headings, titles, questions that are answered with "no".

use super::*;

impl Reader<'_> {
    /// Whether a sentence ends as a question that the next one answers with "no".
    pub(super) fn asked_back(&self, end: usize) -> bool {
        let first = |i: usize| self.chunks.get(i).map(|c| &self.tokens[c.at.start]);
        first(end).is_some_and(|t| t.is("?")) && first(end + 1).is_some_and(|t| t.is("no") || t.is("nope"))
    }

    /// Whether what comes next takes a sentence back as a whole: "There is a whale above it … just joking.", "Put up a
    /// poster. No, what am I saying, …".
    pub(super) fn joking(&self, end: usize) -> bool {
        const TAKES_BACK: [&[&str]; 6] = [
            &["just", "joking"],
            &["just", "kidding"],
            &["only", "joking"],
            &["i'm", "joking"],
            &["no", "what", "am", "i", "saying"],
            &["what", "am", "i", "saying"],
        ];
        let Some(next) = self.chunks.get(end + 1) else { return false };
        let words: Vec<&str> =
            self.tokens[next.at.start..].iter().filter(|t| t.word()).take(5).map(|t| t.text.as_str()).collect();
        TAKES_BACK.iter().any(|phrase| words.starts_with(phrase))
    }

    /// Where the last clause of a sentence begins, after ", and"; where it begins, if it has but one.
    pub(super) fn last_clause(&self, from: usize, end: usize) -> usize {
        let joined =
            |k: &usize| self.chunks[*k].piece == ChunkPiece::And && self.chunks[k - 1].piece == ChunkPiece::Comma;
        (from + 1..end).rev().find(joined).map_or(from, |k| k - 1)
    }

    /// The chunk that ends a sentence: a full stop, or the end of a line that is one.
    pub(super) fn sentence_end(&self, from: usize) -> usize {
        let mut i = from;
        while i < self.chunks.len() {
            match self.chunks[i].piece {
                ChunkPiece::Stop => return i,
                ChunkPiece::Line => {
                    let next = self.chunks.get(i + 1);
                    let fresh = next.is_none_or(|c| {
                        c.piece == ChunkPiece::Bullet
                            || self.tokens[c.at.start].capital
                            || i > 0 && self.chunks[i - 1].piece == ChunkPiece::Colon
                    });
                    if fresh || matches!(self.chunks[from].piece, ChunkPiece::Bullet) {
                        return i;
                    }
                }
                _ => {}
            }
            i += 1;
        }
        i
    }

    /// "Storage." after a number, "Kitchen:", a title: what begins no sentence.
    pub(super) fn heading(&mut self, from: usize, end: usize) -> bool {
        let first = from + usize::from(matches!(self.piece(from, end), Some(ChunkPiece::Bullet)));
        let Some(np) = self.np(first, end) else { return false };
        let closed =
            first + 1 == end || first + 2 == end && matches!(self.piece(first + 1, end), Some(ChunkPiece::Colon));
        match np.kind {
            NounKind::Room => {
                if let Some(room) = self.rooms.spoken.get(&first) {
                    (self.room, self.room_listed) = (*room, false);
                    self.room_look(*room, np);
                    if closed {
                        self.mark(from);
                        self.mark(first);
                        self.main.clear();
                        self.near.clear();
                        self.about_room = true;
                        return true;
                    }
                }
                false
            }
            _ if closed && np.det == Det::None && np.count.is_none() && np.look == crate::draft::Look::default() => {
                let stop = self.chunks.get(end).is_some_and(|c| c.piece == ChunkPiece::Stop) || first + 2 == end;
                // "2. Desks. Eight desks …", "Entrance. Customers come in …", but "- armchair" is a thing.
                let more =
                    self.chunks.get(end + 1).is_some_and(|c| !matches!(c.piece, ChunkPiece::Line | ChunkPiece::Bullet));
                let next = self.chunks.get(end + 1..self.sentence_end(end + 1)).unwrap_or(&[]);
                let told = next.iter().any(|c| matches!(c.piece, ChunkPiece::Verb(_)));
                if stop && more && (first > from || told) || self.numbered(from, end) {
                    self.mark(first);
                    return true;
                }
                false
            }
            _ => false,
        }
    }

    /// "5. General" before "5.1 All doors …".
    pub(super) fn numbered(&self, from: usize, end: usize) -> bool {
        let bullet = |i: usize| {
            let c = self.chunks.get(i).filter(|c| c.piece == ChunkPiece::Bullet)?;
            Some(self.tokens[c.at.start].text.as_str())
        };
        matches!((bullet(from), bullet(end + 1)), (Some(a), Some(b)) if !a.is_empty() && b.len() > a.len() && b.starts_with(a))
    }

    /// "near a cabinet, which stands opposite the window": of the cabinet, where it was named right before.
    pub(super) fn relative(&mut self, i: usize, end: usize) -> bool {
        let word = &self.tokens[self.chunks[i].at.start];
        if word.is("where") {
            return self.where_it_is(i, end);
        }
        let which = word.is("which") || word.is("that");
        let Some(ChunkPiece::Verb(_)) = self.piece(i + 1, end).filter(|_| which) else { return false };
        let comma = usize::from(i > 0 && self.chunks[i - 1].piece == ChunkPiece::Comma);
        let Some(np) = (i - comma).checked_sub(1).and_then(|k| self.np(k, end)) else { return false };
        let last = self.recent.last().copied().filter(|o| self.brief.things[*o].words == np.words);
        let Some(last) = last.filter(|o| !self.main.contains(o) && np.kind == NounKind::Thing) else { return false };
        self.before = std::mem::replace(&mut self.main, vec![last]);
        self.near = vec![last];
        self.s.expect = Expect::Nothing;
        self.s.subject = true;
        true
    }

    /// "The stool faces the bench, where a laptop stands": small things are on what was named last.
    fn where_it_is(&mut self, i: usize, end: usize) -> bool {
        let small = |np: &Np| {
            let fresh = matches!(np.det, Det::Indefinite | Det::Number | Det::None);
            np.kind == NounKind::Thing && fresh && np.group == Some(Group::Top)
        };
        let comma = usize::from(i > 0 && self.chunks[i - 1].piece == ChunkPiece::Comma);
        let named = (i - comma).checked_sub(1).and_then(|k| self.np(k, end)).filter(|np| np.kind == NounKind::Thing);
        let carries = |o: &usize| {
            let item = &self.brief.things[*o];
            matches!(item.group, Group::Table | Group::Storage | Group::Bed | Group::Seat)
                && named.is_some_and(|np| np.words == item.words)
        };
        let Some(on) = self.recent.last().copied().filter(carries) else { return false };
        if !self.np(i + 1, end).is_some_and(small) {
            return false;
        }
        self.s.lead = vec![(Rel::On, Lead::Items(vec![on], false))];
        self.s.expect = Expect::Nothing;
        (self.s.subject, self.s.verb) = (false, false);
        true
    }
}
