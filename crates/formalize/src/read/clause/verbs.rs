//! Verbs: what they make of the noun phrase that comes next.

use super::*;

impl Reader<'_> {
    pub(super) fn on_verb(&mut self, i: usize, verb: Verb) {
        let after = self.main.clone();
        match verb {
            Verb::Be | Verb::Keep => {
                self.s.verb = true;
                if !self.main.is_empty() && self.s.subject {
                    self.near = self.main.clone();
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
                // "the room has", "we have": nothing that owns.
                let of_room = self.s.of_room && !self.s.subject || owner.is_empty();
                let join = if verb == Verb::Carry { Join::On } else { Join::Usual };
                self.s.expect = if of_room { Expect::Nothing } else { Expect::With(owner, join) };
                self.s.listed = true;
            }
            Verb::Block => self.s.expect = Expect::Blocked,
            Verb::Face => self.s.expect = Expect::Object(Rel::Facing),
            Verb::Light => {
                let passive = self.tokens[self.chunks[i].at.start].is("lit") || self.chunks[i].at.len() > 1;
                self.s.expect =
                    if passive { Expect::With(self.near.clone(), Join::Above) } else { Expect::Object(Rel::Above) };
            }
            Verb::Cover => self.s.expect = Expect::Object(Rel::On),
            Verb::Hang => {
                self.s.hang = true;
                self.s.verb = true;
                if !self.main.is_empty() {
                    self.near = self.main.clone();
                }
            }
            Verb::Flank | Verb::Surround => {
                let passive = self.chunks[i].at.len() > 1;
                let (join, rel) =
                    if verb == Verb::Flank { (Join::Beside, Rel::Beside) } else { (Join::Around, Rel::Around) };
                self.s.expect = if passive { Expect::With(self.near.clone(), join) } else { Expect::Object(rel) };
                self.s.each = self.s.each || passive && self.near.first().is_some_and(|n| self.scene.items[*n].many);
            }
            Verb::Lead => {}
        }
        if verb != Verb::Be {
            self.mark(i);
        }
    }
}
