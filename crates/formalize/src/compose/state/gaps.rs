//! Distances that are measured, and room that is kept free.

use super::{Named, Side};
use crate::brief::{Fact, FactKind, Group, Op, Place, Quantifier, Rel};
use crate::write::number;
use scenelang_lang::nouns::{self, Stands};

impl Named<'_> {
    pub(super) fn gap(&self, a: usize, b: usize, op: Op, v: f64, [subject, object]: [Quantifier; 2]) -> String {
        match op {
            Op::Least => self.every(a, b, &|x, y| format!("far({x}, {y}, {})", number(v))),
            // "every table within 3 m of every pillar"
            Op::Most if subject == Quantifier::Each && object == Quantifier::Each => {
                self.every(a, b, &|x, y| format!("near({x}, {y}, {})", number(v)))
            }
            Op::Most if object == Quantifier::Any => self.some(a, b, &|x, y| format!("near({x}, {y}, {})", number(v))),
            // "a shower within 3 m of every bench"
            Op::Most if object == Quantifier::Each && self.counts[b] > 1 => {
                self.each(a, b, &|x, y| format!("near({x}, {y}, {})", number(v)))
            }
            Op::Most => self.pairs(a, b, &|x, y| format!("near({x}, {y}, {})", number(v))),
            Op::Equal => self.pairs(a, b, &|x, y| format!("abs(gap({x}, {y}) - {}) <= 0.05", number(v))),
        }
    }

    pub(super) fn among(&self, a: usize, op: Op, v: f64) -> Option<String> {
        if !self.array(a) {
            return None;
        }
        let of = self.name(a);
        let n = self.counts[a];
        Some(match op {
            Op::Least => format!("forall a in {of}: forall b in {of}: a != b implies far(a, b, {})", number(v)),
            Op::Most => format!("forall i in 0..{}: near({of}[i], {of}[i + 1], {})", n - 1, number(v)),
            Op::Equal => format!("forall i in 0..{}: abs(gap({of}[i], {of}[i + 1]) - {}) <= 0.05", n - 1, number(v)),
        })
    }

    /// Nothing else so near. What was put near it is left out.
    pub(super) fn alone(&self, a: usize, v: f64) -> String {
        let kin: Vec<usize> = (0..self.counts.len()).filter(|i| *i != a && self.kin(a, *i)).collect();
        let except: String = kin.iter().flat_map(|i| self.elements(*i)).map(|e| format!(" and o != {e}")).collect();
        let v = number(v);
        if self.array(a) {
            let of = self.name(a);
            return format!("prefer forall a in {of}: forall o in objects: o != a{except} implies far(o, a, {v});");
        }
        let of = self.name(a);
        format!("assert forall o in objects: o != {of}{except} implies far(o, {of}, {v});")
    }

    /// Whether two things are said to be near each other, or above one another.
    fn kin(&self, a: usize, b: usize) -> bool {
        let flat = matches!(self.group(b), Group::Flat | Group::Ceiling | Group::Wall | Group::Door | Group::Window);
        flat || self.brief.facts.iter().any(|f| match &f.what {
            FactKind::Rel(rel, to) => {
                !f.not
                    && *rel != Rel::Far
                    && (f.of.contains(&a) && to.contains(&b) || f.of.contains(&b) && to.contains(&a))
            }
            _ => false,
        })
    }

    /// Whether seats are said to be at a thing.
    fn has_seats(&self, a: usize) -> bool {
        self.brief.facts.iter().any(|f| match &f.what {
            FactKind::Rel(Rel::Around | Rel::At, to) => !f.not && to.contains(&a),
            _ => false,
        })
    }

    /// Whether a thing stands with its back at a wall, or is said to be at one.
    fn has_back(&self, a: usize) -> bool {
        let walled =
            |f: &Fact| f.of.contains(&a) && matches!(f.what, FactKind::Place(_, Place::Wall | Place::Corner, _));
        let noun = self.brief.things[a].words.join(" ");
        let back = nouns::ending(&noun).is_some_and(|noun| noun.stands == Stands::Back);
        back || matches!(self.group(a), Group::Bed) || self.brief.facts.iter().any(|f| !f.not && walled(f))
    }

    pub(super) fn clear(&self, a: usize, side: Side, v: f64) -> String {
        let v = number(v);
        let door = self.group(a) == Group::Door;
        let sides: &[&str] = match side {
            Side::Front => &["front"],
            Side::Behind => &["behind"],
            Side::Left => &["left"],
            Side::Right => &["right"],
            Side::Above => &["above"],
            Side::Sides | Side::Around if door => &["front", "behind"],
            Side::Sides => &["left", "right"],
            // Where people sit, what is free is at its ends.
            Side::Around if self.has_seats(a) => &["left", "right"],
            Side::Around if self.has_back(a) => &["front", "left", "right"],
            Side::Around => &["front", "behind", "left", "right"],
        };
        // A door's front is whichever side the solver gives it.
        let outer = door && self.brief.things[a].beyond.is_none();
        let sides: &[&str] = if door && !outer { &["front", "behind"] } else { sides };
        self.all(a, |x| sides.iter().map(|s| format!("clear({x}, {s}, {v})")).collect::<Vec<_>>().join(" and "))
    }
}
