//! What "it", "them", "its left", "on top" and "nearby" are of.

use super::*;

impl Reader<'_> {
    /// The things that a pronoun behind a relation stands for.
    pub(super) fn their(&self, word: &str, each: bool) -> Vec<usize> {
        if matches!(word, "them" | "these" | "those" | "both" | "all" | "ones" | "each") || each {
            // Not what is being placed, if it is new: "three bean bags and a toy train next to them".
            let owner = match &self.s.expect {
                Expect::With(owner, _) => owner.clone(),
                _ => vec![],
            };
            let many = |l: &[usize]| l.len() > 1 || l.iter().any(|i| self.brief.things[*i].number.many());
            if many(&owner) {
                return owner;
            }
            let subject = self.near.clone();
            for list in [&self.before, &self.main] {
                let others: Vec<usize> = list.iter().copied().filter(|o| !subject.contains(o)).collect();
                if many(&others) {
                    return others;
                }
            }
            if let Some(i) =
                self.recent.iter().rev().find(|i| self.brief.things[**i].number.many() && !subject.contains(i))
            {
                return vec![*i];
            }
        }
        if let Expect::With(owner, _) = &self.s.expect
            && !owner.is_empty()
        {
            return owner.clone();
        }
        let subject = self.near.clone();
        // "a desk, a chair behind it, two chairs in front of it": the desk all the time.
        if self.s.subject && word == "it" && !self.s.it.is_empty() && self.s.it.iter().all(|o| !subject.contains(o)) {
            return self.s.it.clone();
        }
        // "a long table, eight chairs around it"
        if self.s.subject
            && subject != self.main
            && let Some(other) = self.main.iter().rev().find(|m| !subject.contains(m))
        {
            return vec![*other];
        }
        // "a telephone on the desk, and a chair behind it"
        let small = |l: &[usize]| {
            l.len() > 1
                || l.iter().any(|i| {
                    self.brief.things[*i].number.many()
                        || matches!(self.brief.things[*i].group, Group::Top | Group::Soft | Group::Flat)
                })
        };
        if self.s.subject
            && !self.s.object.is_empty()
            && small(&self.before)
            && !small(&self.s.object)
            && self.s.object != subject
        {
            return self.s.object.clone();
        }
        if self.s.subject && !self.before.is_empty() {
            return self.before.clone();
        }
        let own: &[usize] = if self.s.subject { &self.main } else { &[] };
        self.recent.iter().rev().find(|i| !own.contains(i)).map(|i| vec![*i]).unwrap_or_default()
    }

    /// "On the desk a monitor stands, a lamp to its left": of the monitor, not of the desk that both are on.
    fn on_the_same(&self, object: Vec<usize>) -> Vec<usize> {
        let group = |o: &usize| self.brief.things[*o].group;
        let framed = self.s.frame.as_ref().is_some_and(|frame| *frame == object);
        if !framed || !self.near.iter().all(|o| group(o) == Group::Top) {
            return object;
        }
        let on = |o: &&usize| {
            let says = |f: &Fact| f.of.contains(o) && matches!(&f.what, FactKind::Rel(Rel::On, to) if *to == object);
            !self.near.contains(o)
                && matches!(group(o), Group::Top | Group::Screen)
                && self.brief.facts.iter().any(says)
        };
        self.recent.iter().rev().find(on).map_or(object.clone(), |o| vec![*o])
    }

    /// "to its left", "on top", "between them".
    pub(super) fn on_its(&mut self, i: usize, end: usize, rel: Rel) {
        let text: Vec<&str> = self.chunks[i].at.clone().map(|t| self.tokens[t].text.as_str()).collect();
        let many = text.contains(&"them");
        if matches!(rel, Rel::LeftOf | Rel::RightOf) && !text.iter().any(|w| matches!(*w, "its" | "their")) {
            let which = if rel == Rel::LeftOf { "left" } else { "right" };
            let of = if self.s.subject { self.subject(i) } else { vec![] };
            if self.side_of_room(i, &of, which) {
                return;
            }
        }
        // "they flank the desk on the left and right": that is said already.
        let again = matches!(&self.s.last, Some((_, Rel::Sides, _)));
        if again && self.sides(i) {
            return;
        }
        if let Some((of, among)) = self.listed_between(i, rel).filter(|_| many) {
            self.drop_usual(&[of]);
            return self.relate(&[of], rel, &[among]);
        }
        // "the ovens stand here, and nothing within 1.5 m in front of them"
        let own = many && self.s.nothing && self.s.pending.is_some() && rel != Rel::Between;
        let object = if own { self.them() } else { self.its(i, end, rel) };
        let alone = !text.iter().any(|w| matches!(*w, "it" | "them" | "its" | "their"));
        let object = if alone && matches!(rel, Rel::Near | Rel::Above) { self.ground(object) } else { object };
        let object =
            if matches!(rel, Rel::LeftOf | Rel::RightOf | Rel::Beside) { self.on_the_same(object) } else { object };
        let object = self.on_rug(&object, rel);
        if object.is_empty() {
            return;
        }
        if !many && rel != Rel::Between {
            self.s.it = object.clone();
        }
        let of: Vec<usize> = if self.s.subject { self.subject(i) } else { vec![] };
        // "a lamp and a chair placed beside it": of the chair.
        let reduced = i > 0 && self.reduced(i - 1).is_some();
        let of = if reduced { of } else { self.all_owned(i, &object).unwrap_or(of) };
        // "Two sofas with a table between them and a rug under it": one rug.
        for thing in &of {
            if let Number::Each { of: owner, number } = self.brief.things[*thing].number
                && let [one] = object[..]
                && owner != one
                && !self.brief.things[one].number.many()
            {
                self.brief.things[*thing].number = Number::Exactly(number);
            }
        }

        if let Some(m) = self.s.pending.take() {
            if rel == Rel::Between {
                self.measured(&of, rel, &object, &m, false);
            } else if self.s.keep || self.s.nothing {
                self.clear(&object, rel, m.values[0]);
            } else {
                self.measured(&of, rel, &object, &m, false);
            }
            return;
        }
        let not = std::mem::take(&mut self.s.not);
        if of.is_empty() || of == object || self.preposed(i, i + 1, end) {
            let rel = if rel == Rel::Beside && self.sides(i) { Rel::Sides } else { rel };
            self.s.lead.push((rel, Lead::Items(object, false)));
        } else if not {
            let soft = self.soft();
            self.state(&of, FactKind::Rel(rel, object), soft, true);
        } else {
            let sides = self.sides(i);
            if sides {
                self.double();
            }
            if rel == Rel::Between {
                // "two sofas with a table between them": one table.
                for o in &of {
                    let item = &mut self.brief.things[*o];
                    if matches!(item.number, Number::Each { of, number: 1 } if object.contains(&of)) {
                        item.number = Number::Exactly(1);
                    }
                }
            }
            self.four_sides(i, &of);
            self.drop_usual(&of);
            self.relate(&of, if sides && rel == Rel::Beside { Rel::Sides } else { rel }, &object);
        }
    }

    /// "Two beds and a dresser between them": the dresser, and the beds.
    fn listed_between(&self, i: usize, rel: Rel) -> Option<(usize, usize)> {
        let [.., among, of] = self.recent[..] else { return None };
        let own = self.chunks.get(i.checked_sub(1)?)?.np().and_then(|np| self.find(np)) == Some(of);
        let (list, one) = (&self.brief.things[among], &self.brief.things[of]);
        let joined = self
            .tokens
            .iter()
            .any(|t| (list.source.at().end..one.source.at().start).contains(&t.at.start) && (t.is("and") || t.is(",")));
        let fits = list.number.many() && !one.number.many() && among != of;
        (rel == Rel::Between && own && joined && fits && self.s.pending.is_none()).then_some((of, among))
    }

    /// "It hangs on the wall, and a vase stands beside the sofa": a pronoun begins the clause, `followed` by what is said
    /// of it. "It" is one thing, the last of those that were named together.
    pub(super) fn on_subject(&mut self, of: Vec<usize>, word: &str, followed: bool) {
        let begins = followed && self.s.expect == Expect::Nothing;
        let single = |o: &&usize| !self.brief.things[**o].number.many();
        let last = of.iter().rfind(single).filter(|_| begins && word == "it").copied();
        self.main = last.map_or(of, |last| vec![last]);
        self.near = self.main.clone();
        self.s.subject |= begins;
        self.apply_lead();
    }

    /// What "its", "it" and "them" of a relation stand for.
    fn its(&mut self, i: usize, end: usize, rel: Rel) -> Vec<usize> {
        let text: Vec<&str> = self.chunks[i].at.clone().map(|t| self.tokens[t].text.as_str()).collect();
        let many = text.contains(&"them");
        // "two bottles and a jug to their right": of the bottles.
        let listed = match self.s.owned.as_slice() {
            [.., many, last] if self.near == [*last] && self.brief.things[*many].number.many() => Some(*many),
            _ => None,
        };
        let object = if let (Some(many), true) = (listed, text.contains(&"their")) {
            vec![many]
        } else if rel == Rel::Between {
            let pair = |l: &[usize]| l.len() > 1 || l.iter().any(|i| self.brief.things[*i].number.many());
            let list = match &self.s.expect {
                // "two sofas with a table between them"
                Expect::With(owner, _) if pair(owner) => owner.clone(),
                _ if self.main.len() > 1 || !self.s.subject => self.main.clone(),
                _ => self.before.clone(),
            };
            if pair(&list) {
                list
            } else if let (true, [one], [other, ..]) = (self.s.pending.is_some(), &self.main[..], &self.s.object[..]) {
                // "the chest is at the foot of the bed, but leave 60 cm between them"
                vec![*one, *other]
            } else {
                let own: &[usize] = if self.s.subject { &self.main } else { &[] };
                let mut last: Vec<usize> = Vec::new();
                for r in self.recent.iter().rev() {
                    if !own.contains(r) && !last.contains(r) && last.len() < 2 {
                        last.push(*r);
                    }
                }
                last.reverse();
                last
            }
        } else if let Some(to) = self.both_sides(i, end, rel) {
            to
        } else if let Some(to) = self.other_side(rel) {
            to
        } else if self.s.subject && self.preposed(i, i + 1, end) && !self.main.is_empty() {
            // "a table, and on it a bowl"
            self.main.clone()
        } else if self.s.pending.is_some() && self.s.keep && !self.main.is_empty() {
            self.main.clone()
        } else if self.s.subject || matches!(self.s.expect, Expect::With(..)) {
            self.their(if many { "them" } else { "it" }, false)
        } else if many {
            self.them()
        } else {
            match (self.before.as_slice(), self.carrier.as_slice()) {
                ([], _) => self.recent.last().map(|r| vec![*r]).unwrap_or_default(),
                // "on the counter are a till and a scale; under it …"
                ([_, _, ..], [one]) => vec![*one],
                (before, _) => before.to_vec(),
            }
        };
        // "it" is one thing, the last of those that were named together.
        let one = text.contains(&"it") && !text.iter().any(|w| matches!(*w, "them" | "their"));
        let single = |o: &&usize| !self.brief.things[**o].number.many();
        match object.as_slice() {
            [.., last] if one && rel != Rel::Between => {
                // "Two sofas with a table between them and a rug under it": under the table.
                let here = |o: &&usize| {
                    single(o) && !self.near.contains(o) && self.brief.things[**o].source.at().start >= self.s.at.start
                };
                let named = || self.recent.iter().rfind(here);
                vec![*object.iter().rfind(single).or_else(named).unwrap_or(last)]
            }
            _ => object,
        }
    }

    /// "to the left as you come in", "against the wall to the right": in that part of the room.
    fn side_of_room(&mut self, i: usize, of: &[usize], which: &str) -> bool {
        let wall = i > 0 && self.chunks[i - 1].np().is_some_and(|np| np.kind == NounKind::Place(Place::Wall));
        let own = self.s.at.clone();
        let last = self.brief.facts.iter_mut().rev().take_while(|f| own.start <= f.source.at().start);
        if wall && let Some(FactKind::Place(_, Place::Wall, sides)) = last.map(|f| &mut f.what).next() {
            sides.push(which.to_owned());
            return true;
        }
        let next = self.tokens.get(self.chunks[i].at.end);
        let enters = next.is_some_and(|t| matches!(t.text.as_str(), "as" | "when" | "once" | "upon"));
        if enters && !of.is_empty() {
            self.at_place(of, Rel::At, Place::Side, &[which.to_owned()]);
        }
        enters && !of.is_empty()
    }

    /// "A chair faces the desk. A shelf hangs above": above the desk, not above who sits at it.
    fn ground(&self, object: Vec<usize>) -> Vec<usize> {
        let seat = object.len() == 1 && self.brief.things[object[0]].group == Group::Seat;
        let stable = |o: &usize| matches!(self.brief.things[*o].group, Group::Table | Group::Bed);
        let at = self.brief.facts.iter().rev().find_map(|f| match &f.what {
            FactKind::Rel(Rel::Facing | Rel::At | Rel::InFrontOf | Rel::Around, to) if f.of == object && !f.not => {
                Some(to.clone())
            }
            _ => None,
        });
        at.filter(|to| seat && to.iter().all(stable)).unwrap_or(object)
    }

    /// "with two chisels and two brushes on top": what a relation to the owner, right after a list of what it has,
    /// is said of.
    pub(super) fn all_owned(&self, i: usize, to: &[usize]) -> Option<Vec<usize>> {
        let Expect::With(owner, _) = &self.s.expect else { return None };
        let verb = usize::from(i > 0 && matches!(self.chunks[i - 1].piece, ChunkPiece::Verb(Verb::Be)));
        let listed = i > verb && self.chunks[i - 1 - verb].np().is_some_and(|np| np.kind == NounKind::Thing);
        if !listed || owner != to {
            return None;
        }
        // "with a cabinet, a chair, and both beds visible from the door": of the beds.
        let np = self.chunks[i - 1 - verb].np()?;
        if matches!(np.det, Det::Definite | Det::Each) {
            return None;
        }
        // "with a matching chair, and two books on top": of the books.
        let last = *self.s.owned.last()?;
        let group = self.brief.things[last].group;
        let small = |o: &usize| self.small(*o, to);
        let alike = |o: &usize| self.brief.things[*o].group == group || small(o) && small(&last);
        let same: Vec<usize> = self.s.owned.iter().copied().filter(alike).collect();
        (same.len() > 1).then_some(same)
    }

    /// "one to the left and one to the right of the sofa": of the sofa both.
    pub(super) fn both_sides(&mut self, i: usize, end: usize, rel: Rel) -> Option<Vec<usize>> {
        let bare = !self.chunks[i].at.clone().any(|t| matches!(self.tokens[t].text.as_str(), "its" | "their"));
        let opposite = match rel {
            Rel::LeftOf => Rel::RightOf,
            Rel::RightOf => Rel::LeftOf,
            _ => return None,
        };
        let k = (i + 1..end.min(i + 4)).find(|k| self.chunks[*k].piece == ChunkPiece::Rel(opposite))?;
        let between = |c: &Chunk| c.piece == ChunkPiece::And || c.np().is_some_and(|n| n.kind == NounKind::Pronoun);
        if !bare || !self.chunks[i + 1..k].iter().all(between) || self.np(k + 1, end)?.kind != NounKind::Thing {
            return None;
        }
        match self.object(k + 1, end, rel)? {
            (Lead::Items(items, _), _) => Some(items),
            _ => None,
        }
    }

    /// "to the right of the fireplace a bookcase, to its left a desk": of the fireplace both.
    pub(super) fn other_side(&self, rel: Rel) -> Option<Vec<usize>> {
        let (said, to) = self.side.as_ref()?;
        let contrast = matches!((said, rel), (Rel::LeftOf, Rel::RightOf) | (Rel::RightOf, Rel::LeftOf));
        contrast.then(|| to.clone())
    }

    /// "A table and a rug under it. Four chairs surround it": what stands on the rug, where nothing is said to lie on that.
    pub(super) fn on_rug(&self, object: &[usize], rel: Rel) -> Vec<usize> {
        const ASIDE: [Rel; 8] =
            [Rel::Around, Rel::Beside, Rel::Near, Rel::InFrontOf, Rel::Behind, Rel::LeftOf, Rel::RightOf, Rel::Facing];
        let over = |rug: usize| {
            self.brief.facts.iter().rev().find_map(|fact| match &fact.what {
                FactKind::Rel(Rel::Under, to) if fact.of == [rug] && to.len() == 1 && !fact.not => Some(to[0]),
                _ => None,
            })
        };
        let is_flat = |o: usize| self.brief.things[o].group == Group::Flat;
        let mut out: Vec<usize> = Vec::new();
        for o in object {
            let o = over(*o).filter(|_| ASIDE.contains(&rel) && is_flat(*o)).unwrap_or(*o);
            if !out.contains(&o) {
                out.push(o);
            }
        }
        out
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

    /// The last things of which there are more than so many.
    pub(super) fn several_of(&self, n: usize) -> Option<usize> {
        self.recent.iter().rev().map(|i| self.brief.whole(*i)).find(|i| self.brief.count(*i) > n)
    }

    /// The things that "them" stands for.
    pub(super) fn them(&self) -> Vec<usize> {
        let many = |list: &[usize]| list.len() > 1 || list.first().is_some_and(|i| self.brief.things[*i].number.many());
        for list in [&self.main, &self.before] {
            if many(list) {
                return list.clone();
            }
        }
        if let Some(i) = self.recent.iter().rev().find(|i| self.brief.things[**i].number.many()) {
            return vec![*i];
        }
        self.it()
    }
}
