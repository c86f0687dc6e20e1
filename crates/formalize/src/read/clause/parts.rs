//! Looks that things have from their parts or from other things: "with a glass top", "featuring sliding doors", "draped in
//! linen", "a matching chair". A part is no thing of its own.

use super::*;

impl Reader<'_> {
    /// "an oak desk and a matching chair": the chair has the looks of the desk, its size and shape excepted.
    pub(super) fn match_looks(&mut self, id: usize) {
        const SIZES: [&str; 30] = [
            "large",
            "small",
            "big",
            "tall",
            "low",
            "high",
            "long",
            "short",
            "wide",
            "narrow",
            "little",
            "tiny",
            "huge",
            "compact",
            "oversized",
            "matching",
            "single",
            "double",
            "twin",
            "queen",
            "queen-size",
            "king",
            "king-size",
            "round",
            "circular",
            "oval",
            "square",
            "rectangular",
            "l-shaped",
            "u-shaped",
        ];
        let last = self.near.last().into_iter().chain(self.recent.iter().rev()).copied();
        let model = last.filter(|o| *o != id).find(|o| !self.brief.things[*o].opening());
        let Some(look) = model.map(|o| self.brief.things[o].look.clone()) else { return };
        let own = &mut self.brief.things[id].look;
        own.color = own.color.take().or(look.color);
        own.material = own.material.take().or(look.material);
        let said = |f: &String| SIZES.contains(&f.as_str()) || f.contains(' ');
        let more: Vec<String> = look.features.into_iter().filter(|f| !said(f) && !own.features.contains(f)).collect();
        own.features.extend(more);
    }

    pub(super) fn gives_light(&self, thing: usize) -> bool {
        let item = &self.brief.things[thing];
        let lights = ["lamp", "light", "chandelier", "lantern", "sconce", "spotlight", "candle", "fixture", "pendant"];
        item.group == Group::Ceiling || item.words.iter().any(|w| lights.iter().any(|l| w.ends_with(l)))
    }

    /// "with": what comes belongs to what was spoken of last, or is a part of it.
    pub(super) fn on_with(&mut self, i: usize, end: usize) -> usize {
        let chunks = self.chunks;
        let seat = |o: &usize| self.brief.things[*o].group == Group::Seat;
        // "a wardrobe with two doors"
        let has_doors = |o: &usize| {
            let thing = &self.brief.things[*o];
            thing.has_doors() || thing.words.last().is_some_and(|w| matches!(w.as_str(), "car" | "van" | "truck"))
        };
        let with_back = self.np(i + 1, end).is_some_and(|n| {
            !self.near.is_empty() && part_of_it(n)
                || n.group == Some(Group::Door) && n.many && self.near.last().is_some_and(has_doors)
                || n.kind == NounKind::Thing
                    && n.count.is_none()
                    && (get().part(&n.head())
                        || !n.known && n.det == Det::None && n.many
                        || n.group == Some(Group::Soft) && n.many && self.near.last().is_some_and(seat))
        });
        // "a room with a door": no part of anything.
        let of_room = self.near.is_empty() && self.np(i + 1, end).is_some_and(|n| n.group == Some(Group::Door));
        let with_back = with_back && !of_room && !self.relates_after(i + 2, end);
        if !with_back && !self.near.is_empty() {
            let mut owner = self.bearer(self.near.clone(), i + 1, end);
            // "Track lights and a desk with magazines": nothing lies on lights.
            let lies = self.np(i + 1, end).is_some_and(|n| matches!(n.group, Some(Group::Top | Group::Soft)));
            let carries = |o: &usize| {
                !matches!(
                    self.brief.things[*o].group,
                    Group::Ceiling | Group::Wall | Group::Drape | Group::Door | Group::Window
                )
            };
            if lies && owner.iter().any(carries) {
                owner.retain(carries);
            }
            // "speakers in the corners, with a screen on the wall": one screen.
            self.s.together = i > 0 && chunks[i - 1].piece == ChunkPiece::Comma;
            self.s.expect = Expect::With(owner, Join::Usual);
        } else if with_back {
            return self.with_part(i, end);
        }
        i + 1
    }

    /// Whether what stands here says where the noun before it is: so that is no part of another.
    pub(super) fn relates_after(&self, k: usize, end: usize) -> bool {
        let of = matches!(self.piece(k, end), Some(ChunkPiece::Rel(Rel::Of))) && self.np(k + 1, end).is_some();
        let k = if of { k + 2 } else { k };
        match self.piece(k, end) {
            // "with a shade hanging over it", but "a mobile with stars hangs from the ceiling"
            Some(ChunkPiece::Rel(rel)) => {
                let finite = self.tokens[self.chunks[k].at.start].text.ends_with('s');
                !finite && !matches!(rel, Rel::Of | Rel::In | Rel::On | Rel::At | Rel::Against)
            }
            Some(ChunkPiece::ToIts(_)) => true,
            // "a rail of pans hanging above it", but "a mobile with stars hangs"
            Some(ChunkPiece::Verb(Verb::Hang)) => !self.tokens[self.chunks[k].at.start].is("hangs"),
            _ => false,
        }
    }

    /// Looks and the name of a part, and nothing else: "glass top"; where that ends.
    pub(super) fn part_here(&self, from: usize, end: usize) -> Option<usize> {
        let first = self.chunks.get(from).filter(|_| from < end)?.at.start;
        let to = (from..end).find(|k| {
            matches!(
                self.chunks[*k].piece,
                ChunkPiece::Comma | ChunkPiece::Close | ChunkPiece::Stop | ChunkPiece::Line | ChunkPiece::And
            )
        });
        let to = to.unwrap_or(end);
        let tokens = &self.tokens[first..self.chunks.get(to.checked_sub(1)?)?.at.end];
        let (_, n) = crate::read::chunk::looks(tokens)?;
        let part: Vec<&str> = tokens.get(n..).unwrap_or(&[]).iter().map(|t| t.text.as_str()).collect();
        let part = part.join(" ");
        (get().part(&part) || get().part(&crate::read::lexicon::singular(&part))).then_some(to)
    }

    /// "a shower featuring sliding doors", "the wardrobe has two drawers": parts of one thing, which is then the last.
    pub(super) fn has_part(&mut self, i: usize, end: usize) -> bool {
        let part = self.np(i + 1, end).is_some_and(part_of_it) && !self.relates_after(i + 2, end);
        // "filled with game cases" is no look of it.
        let word = self.tokens[self.chunks[i].at.start].text.as_str();
        let looks_so = ["has", "have", "having", "featur", "boast", "fitted", "complete"];
        let part = part && looks_so.iter().any(|w| word.starts_with(w));
        if !part || self.s.of_room && !self.s.subject {
            return false;
        }
        let owner = match self.reduced(i) {
            Some(last) => vec![last],
            None if self.s.subject => self.main.clone(),
            None => self.near.clone(),
        };
        let one = owner.len() == 1 && !self.brief.things[owner[0]].opening();
        if one {
            self.near = owner;
        }
        one
    }

    /// "draped in linen": a look of the last thing.
    pub(super) fn draped(&mut self, i: usize, end: usize) -> bool {
        let dressed = matches!(self.tokens[self.chunks[i].at.start].text.as_str(), "draped" | "dressed" | "lined");
        let cloth = match self.piece(i + 1, end) {
            Some(ChunkPiece::Attr(_)) => true,
            Some(ChunkPiece::Np(np)) => {
                !np.known && np.det == Det::None && np.count.is_none() && np.kind == NounKind::Thing
            }
            _ => false,
        };
        let Some(last) = self.near.last().copied().filter(|_| dressed && cloth) else { return false };
        let words = &self.tokens[self.chunks[i].at.start..self.chunks[i + 1].at.end];
        let text: Vec<&str> = words.iter().map(|t| t.text.as_str()).collect();
        self.brief.things[last].look.features.push(text.join(" "));
        self.mark(i);
        true
    }

    /// "In the middle of the north wall", "centred on the wall", "on opposite walls": what is said beside which wall it is.
    pub(super) fn part_of_walls(&mut self, i: usize, next: usize) -> Option<String> {
        let first = i.saturating_sub(1);
        let said = |chunk: &Chunk, words: &[&str]| {
            self.tokens[chunk.at.clone()].iter().any(|t| words.contains(&t.text.as_str()))
        };
        let chunks = self.chunks;
        let centered = chunks[first..=i].iter().any(|chunk| said(chunk, &["centered", "centred"]));
        let middle = chunks[i + 1..next].iter().any(|chunk| said(chunk, &["middle", "center", "centre"]));
        let opposite = chunks[i..next].iter().any(|chunk| said(chunk, &["opposite"]));
        if centered {
            self.mark(first);
        }
        match () {
            () if centered || middle => Some("middle".to_owned()),
            () if opposite => Some("opposite".to_owned()),
            () => None,
        }
    }

    /// "with armrests", "with a glass top": looks of the last thing.
    pub(super) fn with_part(&mut self, i: usize, end: usize) -> usize {
        let from = i + 1;
        let mut to = from;
        while to < end
            && (to == from
                || matches!(self.chunks[to].piece, ChunkPiece::And | ChunkPiece::Attr(_))
                || self.np(to, end).is_some_and(|n| get().part(&n.head())))
        {
            to += 1;
        }
        while to > from + 1 && self.chunks[to - 1].piece == ChunkPiece::And {
            to -= 1;
        }
        // "with its back to a wall" is a relation.
        let text: Vec<&str> =
            (self.chunks[from].at.start..self.chunks[to - 1].at.end).map(|t| self.tokens[t].text.as_str()).collect();
        if let Some(owner) = self.near.last().copied() {
            let feature = format!("with {}", text.join(" "));
            self.brief.things[owner].look.features.push(feature);
            (i..to).for_each(|k| self.mark(k));
            // "A bed with a headboard and a quilt": the quilt is the bed's, too.
            let carried = self
                .np(to + 1, end)
                .is_some_and(|np| matches!(np.group, Some(Group::Soft | Group::Top)) && np.det == Det::Indefinite);
            if carried && self.piece(to, end) == Some(&ChunkPiece::And) {
                self.s.expect = Expect::With(vec![owner], Join::Usual);
            }
        }
        to
    }
}

/// Whether a noun phrase after "with" is a part of what is spoken of: "a glass top", "an integrated sink", "four drawers".
pub(super) fn part_of_it(np: &Np) -> bool {
    const BUILT_IN: [&str; 5] = ["built-in", "integrated", "integral", "inset", "in-built"];
    // Of these, several are said of one thing.
    const COUNTED: [&str; 10] =
        ["drawer", "leg", "wheel", "castor", "compartment", "handle", "cubby", "knob", "burner", "hook"];
    let head = np.head();
    match np.kind {
        NounKind::Thing if np.look.features.iter().any(|f| BUILT_IN.contains(&f.as_str())) => {
            np.count.is_none_or(|n| n == 1)
        }
        NounKind::Thing => get().part(&head) && (np.count.is_none() || COUNTED.contains(&head.as_str())),
        NounKind::Abstract => {
            get().part(&head) && np.count.is_none() && np.look != crate::draft::Look::default() && np.det != Det::Own
        }
        _ => false,
    }
}
