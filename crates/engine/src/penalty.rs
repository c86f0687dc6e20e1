//! The penalty: a second fold over the atoms of a formula, which hides none of them.
//!
//! A margin says by how much a formula holds; of a conjunction it shows the worst part only. A search wants the sum of
//! what is violated: over `and` costs add up, over `or` the cheapest branch counts, over `at least n` the n cheapest.
//! An atom that holds costs a little until it holds comfortably, so that results do not end at the edge of a tolerance.

use scenelang_lang::program::{Comparison, Formula, Node, NodeId, Unit};
use scenelang_verify::{Number, Scratch, Tolerances, Truth, Value, declared};
use std::marker::PhantomData;

/// What a violated atom costs beyond the metres that it is off: fewer violations come first.
pub const BASE: f64 = 0.1;
/// What a violated fact costs that has no metres.
const FACT: f64 = 0.5;
/// What a formula costs that cannot be judged.
const UNKNOWN: f64 = 2.0;
/// Metres that a degree counts for.
const PER_DEGREE: f64 = 0.02;
/// Beyond so many metres more do not cost much more.
const FAR: f64 = 4.0;
/// The part of the cost of a missing metre that counts where the atom holds.
pub const COMFORT: f64 = 0.2;
/// How much more than nothing the margin of an inequality should be (metres, or fiftieths of a degree).
const EASE: f64 = 1e-3;

/// Where the truths are that a formula is made of.
pub trait Truths<N: Number> {
    /// That of a node, as last evaluated; `None`: it has none.
    fn truth(&self, node: NodeId) -> Option<Truth<N>>;
}

impl<N: Number> Truths<N> for Scratch<N> {
    fn truth(&self, node: NodeId) -> Option<Truth<N>> {
        match self.get(node) {
            Ok(Value::Truth(truth)) => Some(truth),
            _ => None,
        }
    }
}

/// A formula as last evaluated.
pub struct Penalty<'a, N: Number, T: Truths<N>> {
    pub formula: &'a Formula,
    /// The values of its nodes.
    pub values: &'a T,
    pub tolerances: &'a Tolerances,
    pub numbers: PhantomData<N>,
}

impl<N: Number, T: Truths<N>> Penalty<'_, N, T> {
    /// What the whole formula costs: 0 where it holds comfortably.
    pub fn cost(&self) -> f64 {
        self.of(self.formula.root, true)
    }

    /// What it costs, and whether it holds.
    pub fn both(&self) -> (f64, bool) {
        let root = self.formula.root;
        match self.formula.node(root) {
            Node::Compare(..) | Node::BuiltIn(..) | Node::Same(..) => {
                self.atom(root, true).map_or((UNKNOWN, false), |a| (a.cost(), a.truth.holds))
            }
            _ => (self.cost(), self.verdict(root)),
        }
    }

    /// Whether a part holds, by the verdicts of what it is made of.
    fn verdict(&self, id: NodeId) -> bool {
        match self.formula.node(id) {
            Node::And(parts) => parts.iter().all(|&p| self.verdict(p)),
            Node::Or(parts) => parts.iter().any(|&p| self.verdict(p)),
            Node::Not(part) => !self.verdict(*part),
            Node::Iff(a, b) => self.verdict(*a) == self.verdict(*b),
            Node::AtLeast(n, parts) => parts.iter().filter(|&&p| self.verdict(p)).count() >= *n as usize,
            _ => self.values.truth(id).is_some_and(|t| t.holds),
        }
    }

    /// What misses comfort, in metres, each a number with its slopes; only the branches that count.
    pub fn residuals(&self, out: &mut Vec<N>) {
        self.gather(self.formula.root, true, out);
    }

    fn of(&self, id: NodeId, want: bool) -> f64 {
        match (self.formula.node(id), want) {
            (Node::And(parts), true) | (Node::Or(parts), false) => parts.iter().map(|&p| self.of(p, want)).sum(),
            (Node::Or(parts), true) | (Node::And(parts), false) => {
                parts.iter().map(|&p| self.of(p, want)).fold(FACT + BASE, f64::min)
            }
            (Node::Not(part), _) => self.of(*part, !want),
            (Node::Iff(a, b), _) => {
                let both = |x, y| self.of(*a, x) + self.of(*b, y);
                both(true, want).min(both(false, !want))
            }
            (Node::AtLeast(..), _) => self.cheapest(id, want).iter().map(|(cost, _)| cost).sum(),
            _ => self.atom(id, want).map_or(UNKNOWN, |a| a.cost()),
        }
    }

    fn gather(&self, id: NodeId, want: bool, out: &mut Vec<N>) {
        match (self.formula.node(id), want) {
            (Node::And(parts), true) | (Node::Or(parts), false) => {
                parts.iter().for_each(|&p| self.gather(p, want, out))
            }
            (Node::Or(parts), true) | (Node::And(parts), false) => {
                let cost = |p: &&NodeId| self.of(**p, want);
                if let Some(&best) = parts.iter().min_by(|a, b| cost(a).total_cmp(&cost(b))) {
                    self.gather(best, want, out);
                }
            }
            (Node::Not(part), _) => self.gather(*part, !want, out),
            (Node::Iff(a, b), _) => {
                let both = |x, y| self.of(*a, x) + self.of(*b, y);
                let (x, y) = if both(true, want) <= both(false, !want) { (true, want) } else { (false, !want) };
                self.gather(*a, x, out);
                self.gather(*b, y, out);
            }
            (Node::AtLeast(..), _) => {
                self.cheapest(id, want).iter().for_each(|(_, part)| self.gather(*part, want, out))
            }
            _ => out.extend(self.atom(id, want).and_then(|a| a.residual())),
        }
    }

    /// The parts of an `at least` that should (or should not) hold: as many as are needed, the cheapest.
    fn cheapest(&self, id: NodeId, want: bool) -> Vec<(f64, NodeId)> {
        let Node::AtLeast(n, parts) = self.formula.node(id) else { return Vec::new() };
        let needed = if want { *n as usize } else { (parts.len() + 1).saturating_sub(*n as usize) };
        let mut costs: Vec<(f64, NodeId)> = parts.iter().map(|&p| (self.of(p, want), p)).collect();
        costs.sort_by(|a, b| a.0.total_cmp(&b.0));
        costs.truncate(needed);
        costs
    }

    fn atom(&self, id: NodeId, want: bool) -> Option<Atom<N>> {
        let truth = self.values.truth(id)?;
        let truth = if want { truth } else { truth.negated() };
        Some(Atom { truth, target: self.target(id, want) })
    }

    /// The margin at which an atom holds comfortably: where a tolerance is part of the margin, when it is not used.
    fn target(&self, id: NodeId, want: bool) -> f64 {
        let t = self.tolerances;
        match (self.formula.node(id), want) {
            (Node::Compare(Comparison::Eq, Unit::Metre, ..), true)
            | (Node::Compare(Comparison::Ne, Unit::Metre, ..), false) => t.equal,
            (Node::Compare(Comparison::Eq, Unit::Degree, ..), true)
            | (Node::Compare(Comparison::Ne, Unit::Degree, ..), false) => t.angle,
            (Node::Compare(_, Unit::Degree, ..), _) => EASE / PER_DEGREE,
            (Node::Same(..), true) => match self.values.truth(id) {
                Some(Truth { unit: Unit::Degree, .. }) => t.angle,
                _ => t.equal,
            },
            (Node::SamePolygon(..), true) => t.equal,
            (Node::BuiltIn(built_in, _), _) => {
                let declared = declared(*built_in);
                let slack = if want { declared.wanted } else { declared.unwanted };
                slack.map_or(if declared.unit == Unit::Degree { EASE / PER_DEGREE } else { EASE }, |slack| slack(t))
            }
            _ => EASE,
        }
    }
}

/// A truth that is not made of others, in the sense that is wanted.
struct Atom<N: Number> {
    truth: Truth<N>,
    target: f64,
}

impl<N: Number> Atom<N> {
    fn scale(&self) -> f64 {
        if self.truth.unit == Unit::Degree { PER_DEGREE } else { 1.0 }
    }
    fn cost(&self) -> f64 {
        if self.truth.is_discrete() {
            return if self.truth.holds { 0.0 } else { BASE + FACT };
        }
        cost(self.truth.holds, self.scale() * (self.target - self.truth.margin.value()))
    }
    fn residual(&self) -> Option<N> {
        let missing = N::constant(self.target) - self.truth.margin;
        (!self.truth.is_discrete() && missing.value() > 0.0).then(|| missing.scale(self.scale()))
    }
}

/// The cost of an atom that is `missing` so many metres (or their equivalent) to comfort.
pub fn cost(holds: bool, missing: f64) -> f64 {
    let missing = missing.max(0.0);
    if holds {
        // Rounding is no discomfort.
        return if missing < 1e-9 { 0.0 } else { COMFORT * missing };
    }
    BASE + if missing <= FAR { missing } else { FAR + (missing / FAR).ln() }
}
