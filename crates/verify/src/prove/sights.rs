//! What is known of the direction from one thing to another, seen from above.
//!
//! That a thing faces another to within 30 degrees is a statement about a product and a length, of which linear reasoning
//! makes little. As an angle between two directions, its front and the way to the other, it adds up with all other angles:
//! two things that face each other look opposite ways, to within 60 degrees.

use super::tape::{Claim, Term, all, any, implies, look, unknown};
use super::unknowns::{ANY, OUT_OF_BOX, Unknowns};
use crate::eval::{Scratch, Value};
use crate::number::Algebra;
use crate::prove::interval::Interval;
use crate::vector::V3;
use rustc_hash::FxHashMap;
use scenelang_lang::program::{Arith, Comparison, Formula, Function, Node, NodeId, ObjectId};
use std::collections::BTreeSet;

/// A direction is known where the middles are so far from each other, seen from above (metres).
const APART: f64 = 0.01;
/// What the tolerance of a comparison may add to a cosine there, and then some.
const COSINE: f64 = 2e-4;

/// Of more objects than this it is not looked at where each is along common axes; and what rounding may cost there (metres).
const MOST_FRAMED: usize = 40;
const ROUNDING: f64 = 1e-7;

/// Two things, with the length of the way from the middle of one to that of the other, seen from above.
pub(super) type Sight = ([ObjectId; 2], Term);

impl Unknowns<'_> {
    /// Notes the angles that comparisons of a formula limit: of `v·f ≥ k·length(v)`, where f is an axis of an object and v the
    /// horizontal way from the middle of one object to that of another.
    pub(super) fn sighted(&mut self, formula: &Formula, scratch: &Scratch<Term>) {
        for (id, node) in formula.nodes.iter().enumerate() {
            let (at_least, at_most) = match node {
                Node::Compare(Comparison::Ge | Comparison::Gt, _, a, b) => (*a, *b),
                Node::Compare(Comparison::Le | Comparison::Lt, _, a, b) => (*b, *a),
                _ => continue,
            };
            let Some((cosine, way)) = share_of_length(formula, at_most) else { continue };
            let (Ok(Value::Number(product)), Ok(Value::Vector(way)), Ok(Value::Truth(truth))) =
                (scratch.value(at_least), scratch.value(way), scratch.value(NodeId(id as u32)))
            else {
                continue;
            };
            self.limit(&formula.objects(), product, way, cosine, truth.holds);
        }
    }

    fn limit(&mut self, objects: &[ObjectId], product: Term, way: V3<Term>, cosine: f64, holds: Claim) {
        let flat = |v: V3<Term>| V3([v.0[0], Term::constant(0.0), v.0[2]]);
        if way.0[1].known() != Some(0.0) || way.0.iter().all(|c| c.known().is_some()) {
            return;
        }
        let pairs = objects.iter().flat_map(|a| objects.iter().map(move |b| (*a, *b))).filter(|(a, b)| a != b);
        let leads =
            |own: &Self, a: ObjectId, b: ObjectId| flat(own.thing(b).center() - own.thing(a).center()).0 == way.0;
        let Some((from, to)) = pairs.into_iter().find(|(a, b)| leads(self, *a, *b)) else { return };
        let axis = objects.iter().flat_map(|o| [0, 2].map(|k| self.thing(*o).axes.0[k])).find_map(|axis| {
            let own = flat(axis).dot(way);
            if own == product { Some(axis) } else { (-own == product).then(|| -axis) }
        });
        let Some(axis) = axis.filter(|axis| axis.0[1].known() == Some(0.0)) else { return };
        let length = way.length();
        let angle = unknown(Interval::new(0.0, 180.0));
        let most = (cosine - COSINE).clamp(-1.0, 1.0).acos().to_degrees() + 1e-6;
        let limit = (Term::constant(most) - angle).at_least(0.0);
        self.always.push(implies(all(&[holds, length.at_least(APART)]), limit));
        // The way back is the contrary direction.
        let (ends, way) = if from < to { ([from, to], way) } else { ([to, from], -self.way(to, from)) };
        self.angles.push(([axis, way], angle));
        if !self.sights.iter().any(|(known, _)| *known == ends) {
            self.sights.push((ends, length));
        }
    }

    /// The angles between the fronts of objects that claims speak of, by pairs of their numbers here.
    pub(super) fn fronts(&self, objects: &[ObjectId]) -> Vec<((usize, usize), Term)> {
        let fronts: FxHashMap<[Term; 3], usize> =
            objects.iter().enumerate().map(|(i, o)| (self.thing(*o).axes.0[2].0, i)).collect();
        let of = |([p, q], angle): &([V3<Term>; 2], Term)| {
            let (i, k) = (*fronts.get(&p.0)?, *fronts.get(&q.0)?);
            (i != k).then_some(((i.min(k), i.max(k)), *angle))
        };
        self.angles.iter().filter_map(of).collect()
    }

    /// What things see of each other along the axes of some that are turned alike adds up: along each axis every thing has a
    /// place of its own. Of each pair alone linear reasoning knows only a product.
    pub(super) fn shared_frames(&mut self, objects: &BTreeSet<ObjectId>) {
        if objects.len() > MOST_FRAMED {
            return;
        }
        let mut frames: Vec<([V3<Term>; 3], usize)> = Vec::new();
        for &id in objects {
            let axes = self.thing(id).axes.0;
            if axes[1].0[1].known() != Some(1.0) || axes[0].0.iter().all(|c| c.known().is_some()) {
                continue;
            }
            match frames.iter_mut().find(|(known, _)| known[2].0 == axes[2].0) {
                Some((_, count)) => *count += 1,
                None => frames.push((axes, 1)),
            }
        }
        for (axes, _) in frames.into_iter().filter(|(_, count)| *count > 1) {
            for axis in [0, 2] {
                let mut seen: Vec<(ObjectId, ObjectId, Term)> = Vec::new();
                for (&a, &b) in objects.iter().flat_map(|a| objects.iter().map(move |b| (a, b))).filter(|(a, b)| a != b)
                {
                    let between = self.thing(a).center() - self.thing(b).center();
                    let before = look(|tape| tape.ops.len());
                    let term = between.dot(axes[axis]);
                    // What is new is in nobody's claim.
                    if (term.0 as usize) < before {
                        seen.push((a, b, term));
                    }
                }
                // Two of them have no third to add up to.
                if seen.len() < 3 {
                    continue;
                }
                let mut places: FxHashMap<ObjectId, Term> = FxHashMap::default();
                for (a, b, term) in seen {
                    let [a, b] = [a, b].map(|o| *places.entry(o).or_insert_with(|| unknown(ANY)));
                    let off = term - (a - b);
                    self.always.extend([off, -off].map(|off| off.at_least(-ROUNDING)));
                }
            }
        }
    }

    /// The horizontal way from the middle of one thing to that of another.
    fn way(&self, from: ObjectId, to: ObjectId) -> V3<Term> {
        let way = self.thing(to).center() - self.thing(from).center();
        V3([way.0[0], Term::constant(0.0), way.0[2]])
    }

    /// That the solids of two things of which one faces the other do not overlap: that they are not in the same place.
    pub(super) fn apart_in_sight(&self, (ends, length): Sight, contact: f64) -> Option<Claim> {
        let [a, b] = ends;
        let (Some(x), Some(y)) = (self.solid_of(a), self.solid_of(b)) else { return None };
        if [&x, &y].iter().any(|t| t.axes.0[1].0[1].known() != Some(1.0)) {
            return None;
        }
        let contact = Term::constant(contact);
        let top = |t: &crate::world::ObjectInstance<Term>| t.pos.0[1] + t.scale.0[1];
        // Each holds a disc about its middle axis, at each of its heights.
        let round = |t: &crate::world::ObjectInstance<Term>| t.scale.0[0].min(t.scale.0[2]).scale(0.5);
        Some(any(&[
            (x.pos.0[1] - top(&y) + contact).at_least(0.0),
            (y.pos.0[1] - top(&x) + contact).at_least(0.0),
            (length - round(&x) - round(&y) + contact).at_least(0.0),
        ]))
    }

    /// Of upright things: a distance of two middles is that of what one of them sees ahead and aside, where claims speak of
    /// both. Linear reasoning cannot turn one into the other.
    pub(super) fn seen_lengths(&mut self, a: ObjectId, b: ObjectId) {
        let (thing, other) = (self.thing(a), self.thing(b));
        if other.axes.0[1].0[1].known() != Some(1.0) || other.axes.0[0].0.iter().all(|c| c.known().is_some()) {
            return;
        }
        let between = thing.center() - other.center();
        let known = |term: Term, before: usize| (term.0 as usize) < before;
        let before = look(|tape| tape.ops.len());
        let seen = [0, 2].map(|axis| {
            let ways = [between, other.center() - thing.center()].map(|way| way.dot(other.axes.0[axis]));
            ways.into_iter().find(|term| known(*term, before))
        });
        let [Some(aside), Some(ahead)] = seen else { return };
        let zero = Term::constant(0.0);
        let back = other.center() - thing.center();
        let ways = [between, back].into_iter().flat_map(|way| {
            let seen = [zero, between.0[1]].map(|up| V3([aside, up, ahead]));
            std::iter::zip([V3([way.0[0], zero, way.0[2]]), way], seen)
        });
        for (world, seen) in ways {
            let before = look(|tape| tape.ops.len());
            let length = world.length();
            if known(length, before) {
                let off = length - seen.length();
                self.always.extend([off, -off].map(|off| off.at_least(-OUT_OF_BOX)));
            }
        }
    }
}

/// The number k and the vector v of `k·length(v)`, k more than 0.
fn share_of_length(formula: &Formula, id: NodeId) -> Option<(f64, NodeId)> {
    let length = |id: NodeId| match formula.node(id) {
        Node::Call(Function::Length, args) => Some(args[0]),
        _ => None,
    };
    match formula.node(id) {
        Node::Arith(Arith::Mul, a, b) => {
            let number = |id: NodeId| match formula.node(id) {
                Node::Number(k) if *k > 0.0 => Some(*k),
                _ => None,
            };
            number(*a).zip(length(*b)).or_else(|| number(*b).zip(length(*a)))
        }
        _ => length(id).map(|v| (1.0, v)),
    }
}
