//! What operations mean for linear reasoning: inequalities that hold for every value of the arguments (within their
//! present bounds, where a bound is named as a reason), made where the values that linear reasoning proposes break them.
//!
//! - a square lies above each of its tangents and, between two bounds, below its chord;
//! - a product lies, between bounds, above and below two planes each (McCormick);
//! - an absolute value is at least its argument and its contrary; a maximum at least, a minimum at most its arguments;
//! - a root lies below its tangents; a length is at least its vector seen from any direction (Cauchy–Schwarz);
//! - the way from one point to another is at most the sum of ways over others (the triangle inequality), and so it is
//!   with the angles between directions.

use super::interval::Interval;
use super::problem::{Affine, Function, Problem, UnknownKind, Var};
use super::simplex::Simplex;
use super::state::{EventId, State};
use super::tape::Term;
use scenelang_lang::program::ObjectId;
use std::collections::{BTreeMap, VecDeque};

/// An inequality: the sum is at least `least`.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    pub parts: Vec<(Var, f64)>,
    pub least: f64,
    /// The bounds that it takes for granted.
    pub reasons: Vec<EventId>,
    /// How far the proposed values break it.
    broken: f64,
}

/// Less than this is not worth an inequality.
const WORTH: f64 = 1e-6;
/// What rounding of an angle or a length may cost.
const SLACK: f64 = 1e-7;
/// At most so many at a time, the most broken first.
const MOST: usize = 48;

/// Inequalities that the present values break.
pub(super) fn broken(problem: &Problem, state: &State, simplex: &Simplex, points: &Points, work: &mut u64) -> Vec<Cut> {
    let mut out = Gather { problem, state, simplex, cuts: Vec::new() };
    for (index, kind) in problem.kinds.iter().enumerate() {
        if let UnknownKind::Apply(function, a, b) = kind
            && !problem.curved[index]
        {
            *work += 1;
            out.operation(*function, index as Var, *a, *b);
        }
    }
    for (var, parts) in &problem.lengths {
        *work += 2;
        out.length(*var, parts);
    }
    points.ways(&mut out, work);
    let mut cuts = out.cuts;
    cuts.sort_by(|a, b| b.broken.total_cmp(&a.broken));
    cuts.truncate(MOST);
    cuts
}

struct Gather<'a> {
    problem: &'a Problem,
    state: &'a State,
    simplex: &'a Simplex,
    cuts: Vec<Cut>,
}

impl Gather<'_> {
    fn value(&self, a: Affine) -> f64 {
        let own = self.simplex.value(a.var);
        let add = if a.add.is_point() { a.add.lo } else { a.add.lo + a.add.width() / 2.0 };
        if a.minus { add - own } else { add + own }
    }

    /// Σ factor·term ≥ least.
    fn add(&mut self, terms: &[(Affine, f64)], least: f64, reasons: &[EventId]) {
        // Few terms: a sorted list.
        let mut sum: Vec<(Var, f64)> = Vec::with_capacity(terms.len());
        let mut bound = Interval::point(least);
        for (term, factor) in terms {
            bound = bound - term.add.scale(*factor);
            if term.var != 0 {
                let factor = if term.minus { -factor } else { *factor };
                match sum.binary_search_by_key(&term.var, |(v, _)| *v) {
                    Ok(at) => sum[at].1 += factor,
                    Err(at) => sum.insert(at, (term.var, factor)),
                }
            }
        }
        sum.retain(|(_, c)| *c != 0.0);
        // What rounding of the factors may have cost.
        let cost: f64 = sum.iter().map(|(v, c)| c.abs() * self.problem.initial[*v as usize].magnitude()).sum();
        let least = bound.lo - 1e-12 - 1e-15 * (cost + bound.magnitude() + least.abs());
        if sum.is_empty() || !least.is_finite() || sum.iter().any(|(_, c)| c.abs() > 1e5) {
            return;
        }
        let there: f64 = sum.iter().map(|(v, c)| c * self.simplex.value(*v)).sum();
        let size = sum.iter().fold(0.0f64, |m, (_, c)| m.max(c.abs())).max(1.0);
        let broken = (least - there) / size;
        if broken > WORTH {
            self.cuts.push(Cut { parts: sum, least, reasons: reasons.to_vec(), broken });
        }
    }

    fn operation(&mut self, function: Function, var: Var, a: Affine, b: Affine) {
        let z = Affine { var, minus: false, add: Interval::point(0.0) };
        let (x0, z0) = (self.value(a), self.value(z));
        let (x, y) = (a.of(self.state.domain[a.var as usize]), b.of(self.state.domain[b.var as usize]));
        let [p, q] = [a, b].map(|t| self.state.why[t.var as usize]);
        let both = [p[0], p[1], q[0], q[1]];
        match function {
            Function::Square => {
                // At the value itself, and where it is beyond the bounds at the nearest that is not.
                let t = x0.clamp(x.lo.min(x.hi), x.hi.max(x.lo));
                self.add(&[(z, 1.0), (a, -2.0 * t)], -t * t, &[]);
                if x.width().is_finite() && z0 > x0 * x0 {
                    self.add(&[(z, -1.0), (a, x.lo + x.hi)], x.lo * x.hi, &both);
                }
            }
            Function::Mul if x.magnitude().is_finite() && y.magnitude().is_finite() => {
                for (s, t) in [(x.lo, y.lo), (x.hi, y.hi)] {
                    self.add(&[(z, 1.0), (b, -s), (a, -t)], -s * t, &both);
                }
                for (s, t) in [(x.hi, y.lo), (x.lo, y.hi)] {
                    self.add(&[(z, -1.0), (b, s), (a, t)], s * t, &both);
                }
            }
            Function::Abs => {
                self.add(&[(z, 1.0), (a, -1.0)], 0.0, &[]);
                self.add(&[(z, 1.0), (a, 1.0)], 0.0, &[]);
                if x.lo >= 0.0 {
                    self.add(&[(z, -1.0), (a, 1.0)], 0.0, &both);
                } else if x.hi <= 0.0 {
                    self.add(&[(z, -1.0), (a, -1.0)], 0.0, &both);
                } else if x.width().is_finite() {
                    // The chord from |lo| to hi.
                    let slope = (x.hi + x.lo) / x.width();
                    self.add(&[(z, -1.0), (a, slope)], (x.lo * (1.0 + slope)).min(x.hi * (slope - 1.0)), &both);
                }
            }
            Function::Min | Function::Max => {
                let sign = if function == Function::Max { 1.0 } else { -1.0 };
                self.add(&[(z, sign), (a, -sign)], 0.0, &[]);
                self.add(&[(z, sign), (b, -sign)], 0.0, &[]);
                let first = if function == Function::Max { x.lo >= y.hi } else { x.hi <= y.lo };
                let second = if function == Function::Max { y.lo >= x.hi } else { y.hi <= x.lo };
                if first || second {
                    self.add(&[(z, -sign), (if first { a } else { b }, sign)], 0.0, &both);
                }
            }
            Function::Sqrt if x0 > 1e-9 => {
                let root = x0.sqrt();
                self.add(&[(z, -1.0), (a, 0.5 / root)], -root / 2.0, &[]);
            }
            _ => {}
        }
    }

    fn length(&mut self, var: Var, parts: &[Affine]) {
        let at: Vec<f64> = parts.iter().map(|p| self.value(*p)).collect();
        let size = at.iter().map(|v| v * v).sum::<f64>().sqrt();
        if size <= self.simplex.value(var) + WORTH {
            return;
        }
        // A direction that is certainly no longer than 1.
        let mut terms = vec![(Affine { var, minus: false, add: Interval::point(0.0) }, 1.0)];
        terms.extend(parts.iter().zip(&at).map(|(p, v)| (*p, -v / size * (1.0 - 1e-12))));
        self.add(&terms, 0.0, &[]);
    }
}

/// Points between which lengths are known, as a graph.
#[derive(Clone, Debug, Default)]
pub(super) struct Points {
    nodes: usize,
    edges: Vec<(usize, usize, Affine)>,
}

/// A coordinate of a point: variables with factors. What is constant of it is in the offset.
type Coordinate = Vec<(Var, u64)>;
/// How far a point is from where its variables are, by coordinates, in steps of [`STEP`].
type Offset = Vec<i64>;

/// So near to each other, points are the same (metres): far less than [`SLACK`].
const STEP: f64 = 1e-9;
/// So many points are told apart.
const MOST_POINTS: usize = 400;
/// A point stands at so many offsets.
const MOST_MOVED: usize = 3;

/// The length of the way from one point to another, moved by an offset.
struct Difference {
    from: Vec<Coordinate>,
    to: Vec<Coordinate>,
    offset: Offset,
    var: Var,
}

impl Points {
    /// The ends of the lengths that are differences of two points; and directions, by their numbers, a contrary beside
    /// each, with the angles between them; and objects, with ways over their surfaces.
    ///
    /// Coordinates stand in the order of their variables,
    /// x before y before z, and both ends must agree on that; so equal keys are equal points.
    pub fn new(problem: &Problem, angles: &[([usize; 2], Term)], spans: &[([ObjectId; 2], Term)]) -> Self {
        let mut lengths = Vec::new();
        for (var, parts) in &problem.lengths {
            let Some(mut pairs) = parts.iter().map(|p| ends(problem, *p)).collect::<Option<Vec<_>>>() else { continue };
            pairs.sort();
            let offset: Offset = pairs.iter().map(|p| p.2).collect();
            let (from, to): (Vec<Coordinate>, Vec<Coordinate>) = pairs.into_iter().map(|(p, q, _)| (p, q)).unzip();
            let in_order = to.windows(2).all(|w| w[0].is_empty() && w[1].is_empty() || w[0] < w[1]);
            if in_order && (from != to || offset.iter().any(|o| *o != 0)) {
                lengths.push(Difference { from, to, offset, var: *var });
            }
        }
        let mut own = Self::of(&lengths);
        own.directions(problem, angles);
        let first = own.nodes;
        for ([a, b], span) in spans {
            if let Some(span) = problem.terms[span.0 as usize] {
                let ends = [a, b].map(|o| first + o.0 as usize);
                own.nodes = own.nodes.max(ends[0].max(ends[1]) + 1);
                own.edges.push((ends[0], ends[1], span));
            }
        }
        own
    }

    /// Points beside the points that coordinates name, where lengths begin and end. A length between two of them is one
    /// between any two others that are moved alike.
    fn of(lengths: &[Difference]) -> Self {
        let mut known: BTreeMap<(&[Coordinate], Offset), usize> = BTreeMap::new();
        let mut edges: BTreeMap<(usize, usize, Var), ()> = BTreeMap::new();
        let zero = |length: &Difference| vec![0; length.offset.len()];
        let mut open: VecDeque<(&[Coordinate], Offset)> = VecDeque::new();
        let mut by_end: BTreeMap<&[Coordinate], Vec<&Difference>> = BTreeMap::new();
        for length in lengths {
            by_end.entry(&length.from).or_default().push(length);
            by_end.entry(&length.to).or_default().push(length);
        }
        let is_fixed = |key: &[Coordinate]| key.iter().all(Vec::is_empty);
        // Each length stands somewhere, one from a fixed point where its variables are; from there on, wherever the points
        // that it ends at stand.
        let (first, then): (Vec<&Difference>, Vec<&Difference>) = lengths.iter().partition(|l| is_fixed(&l.to));
        for seed in first.into_iter().chain(then) {
            let meets = |key: &[Coordinate]| *key == seed.from || *key == seed.to;
            if is_fixed(&seed.to) || !known.keys().any(|(key, _)| meets(key)) {
                open.push_back((&seed.from, zero(seed)));
            }
            while let Some((key, at)) = open.pop_front() {
                let next = known.len();
                let moved = known.keys().filter(|(of, _)| *of == key).count();
                let few = next < MOST_POINTS && (moved < MOST_MOVED || is_fixed(key));
                if known.contains_key(&(key, at.clone())) || !few {
                    continue;
                }
                known.insert((key, at.clone()), next);
                for length in by_end.get(key).into_iter().flatten() {
                    let moved = |sign: i64| -> Offset {
                        std::iter::zip(&at, &length.offset).map(|(a, o)| a + sign * o).collect()
                    };
                    if length.from == key {
                        open.push_back((&length.to, moved(1)));
                    }
                    // To a fixed point the ways are those from where the variables are.
                    if length.to == key && (!is_fixed(key) || at == length.offset) {
                        open.push_back((&length.from, moved(-1)));
                    }
                }
            }
        }
        for ((key, at), from) in &known {
            for length in by_end.get(key).into_iter().flatten().filter(|length| length.from == *key) {
                let to: Offset = std::iter::zip(at, &length.offset).map(|(a, o)| a + o).collect();
                if let Some(to) = known.get(&(length.to.as_slice(), to)) {
                    edges.insert((*from, *to, length.var), ());
                }
            }
        }
        let of = |(from, to, var)| (from, to, Affine { var, minus: false, add: Interval::point(0.0) });
        Self { nodes: known.len(), edges: edges.into_keys().map(of).collect() }
    }

    /// The angles between directions, each of which is 180° from its contrary.
    fn directions(&mut self, problem: &Problem, angles: &[([usize; 2], Term)]) {
        let first = self.nodes;
        let known = angles.iter().filter_map(|(ends, angle)| Some((ends, problem.terms[angle.0 as usize]?)));
        for (&[p, q], angle) in known {
            let rest = Affine { minus: !angle.minus, add: Interval::point(180.0) - angle.add, ..angle };
            for (a, b, angle) in [(p, q, angle), (p, q ^ 1, rest), (p ^ 1, q, rest), (p ^ 1, q ^ 1, angle)] {
                self.edges.push((first + a, first + b, angle));
                self.nodes = self.nodes.max(first + a.max(b) + 1);
            }
        }
    }

    /// Lengths that are proposed longer than a way over other points.
    fn ways(&self, out: &mut Gather<'_>, work: &mut u64) {
        if self.edges.len() < 3 || self.edges.len() > 600 {
            return;
        }
        let weight: Vec<f64> = self.edges.iter().map(|e| out.value(e.2).max(0.0)).collect();
        for (index, &(from, to, length)) in self.edges.iter().enumerate() {
            if weight[index] <= WORTH {
                continue;
            }
            *work += self.edges.len() as u64;
            if let Some(way) = self.way(from, to, index, &weight) {
                let mut terms = vec![(length, -1.0)];
                terms.extend(way.into_iter().map(|e| (self.edges[e].2, 1.0)));
                out.add(&terms, -SLACK, &[]);
            }
        }
    }

    /// The edges of the shortest way that is shorter than the edge left out (Bellman and Ford).
    fn way(&self, from: usize, to: usize, left_out: usize, weight: &[f64]) -> Option<Vec<usize>> {
        let mut best = vec![f64::INFINITY; self.nodes];
        let mut by = vec![usize::MAX; self.nodes];
        best[from] = 0.0;
        for _ in 0..self.nodes {
            let mut changed = false;
            for (index, &(a, b, _)) in self.edges.iter().enumerate().filter(|(i, _)| *i != left_out) {
                for (p, q) in [(a, b), (b, a)] {
                    if best[p] + weight[index] < best[q] - 1e-12 && best[p] + weight[index] < weight[left_out] {
                        (best[q], by[q]) = (best[p] + weight[index], index);
                        changed = true;
                    }
                }
            }
            if !changed {
                break;
            }
        }
        if best[to] >= weight[left_out] - WORTH {
            return None;
        }
        let mut way = Vec::new();
        let mut at = to;
        while at != from && way.len() <= self.nodes {
            let edge = by[at];
            way.push(edge);
            let (a, b, _) = self.edges[edge];
            at = if a == at { b } else { a };
        }
        (at == from).then_some(way)
    }
}

/// The two ends that a coordinate difference lies between, and how far the second is moved: (from) − (to + offset).
fn ends(problem: &Problem, part: Affine) -> Option<(Coordinate, Coordinate, i64)> {
    let row = match &problem.kinds[part.var as usize] {
        UnknownKind::Row(parts) => parts.to_vec(),
        _ => vec![(part.var, 1.0)],
    };
    if part.add.width() > STEP / 10.0 || part.add.magnitude() > 1e6 {
        return None;
    }
    let side =
        |sign: f64| row.iter().filter(|(_, c)| c * sign > 0.0).map(|(v, c)| (*v, (c * sign).to_bits())).collect();
    let (plus, minus): (Vec<_>, Vec<_>) = (side(1.0), side(-1.0));
    // ±row + add: the row less the constant point.
    let constant = if part.minus { part.add.lo } else { -part.add.lo };
    Some((plus, minus, (constant / STEP).round() as i64))
}
