//! The shortest way through free space: a search over the corners that a taut string can bend at.
//!
//! Candidates wait in a queue by what they would cost at least; whether one sees the other is tested only when it comes
//! to the front.

use super::free::{Floor, vec};
use geo::{LineString, MultiPolygon, Polygon};
use scenelang_layout::Vec2;
use scenelang_layout::planar::{nearest_of_segments, nearest_on_segment, turn};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Corners and crossings nearer than this are one (metres).
const TOUCHING: f64 = 1e-7;

/// The length of the shortest way between places, given piece by piece of the floor; infinite where there is none.
pub(super) fn between(floor: &Floor, from: &[MultiPolygon], to: &[MultiPolygon]) -> f64 {
    let pieces = floor.pieces.iter().zip(from.iter().zip(to));
    pieces
        .filter(|(_, (a, b))| !a.0.is_empty() && !b.0.is_empty())
        .map(|(piece, (a, b))| Search::new(piece, a, b).length())
        .fold(f64::INFINITY, f64::min)
}

type Segment = (Vec2, Vec2);

/// A corner of the free space at which a string can bend round.
struct Bend {
    at: Vec2,
    before: Vec2,
    after: Vec2,
}

struct Search {
    /// All sides of the piece.
    sides: Vec<Segment>,
    bends: Vec<Bend>,
    from: Vec<Segment>,
    to: Vec<Segment>,
    /// Whether one place serves both.
    together: bool,
}

/// A step that may turn out to be barred.
#[derive(PartialEq)]
struct Step {
    /// What the way costs at least if this step is taken.
    bound: f64,
    /// What it costs up to the end of this step.
    cost: f64,
    line: Segment,
    /// The bend that it leads to; `None`: it arrives.
    to: Option<usize>,
}

impl Eq for Step {}

impl Ord for Step {
    fn cmp(&self, other: &Self) -> Ordering {
        // The cheapest first; of equals the lower number, so that the order is always the same.
        other.bound.total_cmp(&self.bound).then_with(|| other.to.cmp(&self.to))
    }
}

impl PartialOrd for Step {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Search {
    fn new(piece: &Polygon, from: &MultiPolygon, to: &MultiPolygon) -> Self {
        use geo::BooleanOps;
        let rings: Vec<Vec<Vec2>> =
            std::iter::once(piece.exterior()).chain(piece.interiors()).map(corners).filter(|r| r.len() > 2).collect();
        let mut sides = Vec::new();
        let mut bends = Vec::new();
        for (index, ring) in rings.iter().enumerate() {
            let n = ring.len();
            // Outlines are wound one way, holes the other: in both the free side is on the same hand.
            let area: f64 = (0..n).map(|i| ring[i].perp(&ring[(i + 1) % n])).sum();
            let hand = if (area > 0.0) == (index == 0) { 1.0 } else { -1.0 };
            for i in 0..n {
                let (before, at, after) = (ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
                sides.push((at, after));
                if turn(before, at, after) * hand < 0.0 {
                    bends.push(Bend { at, before, after });
                }
            }
        }
        Self { sides, bends, from: sides_of(from), to: sides_of(to), together: !from.intersection(to).0.is_empty() }
    }

    fn length(&self) -> f64 {
        if self.together {
            return 0.0;
        }
        let mut queue = BinaryHeap::new();
        for &(a, b) in &self.from {
            for &(c, d) in &self.to {
                let line = nearest_of_segments([&a, &b], [&c, &d]);
                let cost = (line.1 - line.0).norm();
                queue.push(Step { bound: cost, cost, line, to: None });
            }
        }
        for (i, bend) in self.bends.iter().enumerate() {
            for (a, b) in &self.from {
                let start = nearest_on_segment(&bend.at, a, b);
                if taut(bend, start) {
                    let cost = (bend.at - start).norm();
                    queue.push(Step { bound: cost + self.rest(bend), cost, line: (start, bend.at), to: Some(i) });
                }
            }
        }
        let mut settled = vec![false; self.bends.len()];
        while let Some(step) = queue.pop() {
            if step.to.is_some_and(|i| settled[i]) || !self.sees(step.line) {
                continue;
            }
            let Some(i) = step.to else { return step.cost };
            settled[i] = true;
            self.leave(i, step.cost, &settled, &mut queue);
        }
        f64::INFINITY
    }

    /// At least so much is left to go.
    fn rest(&self, bend: &Bend) -> f64 {
        let far = |(a, b): &Segment| (nearest_on_segment(&bend.at, a, b) - bend.at).norm();
        self.to.iter().map(far).fold(f64::INFINITY, f64::min)
    }

    /// Queues the steps from a bend reached at a cost.
    fn leave(&self, index: usize, cost: f64, settled: &[bool], queue: &mut BinaryHeap<Step>) {
        let here = &self.bends[index];
        for (i, next) in self.bends.iter().enumerate().filter(|(i, _)| !settled[*i]) {
            if taut(here, next.at) && taut(next, here.at) {
                let cost = cost + (next.at - here.at).norm();
                queue.push(Step { bound: cost + self.rest(next), cost, line: (here.at, next.at), to: Some(i) });
            }
        }
        for (a, b) in &self.to {
            let end = nearest_on_segment(&here.at, a, b);
            let cost = cost + (end - here.at).norm();
            queue.push(Step { bound: cost, cost, line: (here.at, end), to: None });
        }
    }

    /// Whether a segment stays in the free space, its boundary included.
    fn sees(&self, (p, q): Segment) -> bool {
        let along = q - p;
        let length = along.norm();
        if length <= TOUCHING {
            return true;
        }
        let mut cuts = vec![0.0, 1.0];
        for &(a, b) in &self.sides {
            let (left, right) = (along.perp(&(a - p)) / length, along.perp(&(b - p)) / length);
            if left.min(right) > TOUCHING || left.max(right) < -TOUCHING {
                continue;
            }
            // Along a side, or across it: in between is either free or not.
            let at = |point: Vec2| (point - p).dot(&along) / (length * length);
            if (left - right).abs() <= TOUCHING {
                cuts.extend([at(a), at(b)]);
            } else {
                cuts.push(at(a + (b - a) * (left / (left - right)).clamp(0.0, 1.0)));
            }
        }
        cuts.retain(|t| (0.0..=1.0).contains(t));
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2).all(|pair| {
            (pair[1] - pair[0]) * length <= TOUCHING || self.is_free(p + along * ((pair[0] + pair[1]) / 2.0))
        })
    }

    /// Whether a point is in the free space or within a hair of it.
    fn is_free(&self, p: Vec2) -> bool {
        let mut inside = false;
        for &(a, b) in &self.sides {
            if (a.y > p.y) != (b.y > p.y) && (turn(a, b, p) > 0.0) == (b.y > a.y) {
                inside = !inside;
            }
        }
        inside || self.sides.iter().any(|(a, b)| (nearest_on_segment(&p, a, b) - p).norm() <= TOUCHING)
    }
}

/// Whether a string from a bend to a point leaves both neighbours of the bend on one side, as a taut one does.
fn taut(bend: &Bend, point: Vec2) -> bool {
    let way = point - bend.at;
    let side = |neighbour: Vec2| way.perp(&(neighbour - bend.at));
    side(bend.before) * side(bend.after) >= -1e-15
}

fn corners(ring: &LineString) -> Vec<Vec2> {
    let mut out: Vec<Vec2> = Vec::with_capacity(ring.0.len());
    for &c in &ring.0 {
        if out.last().is_none_or(|last| (last - vec(c)).norm() > TOUCHING) {
            out.push(vec(c));
        }
    }
    while out.len() > 1 && (out[0] - out[out.len() - 1]).norm() <= TOUCHING {
        out.pop();
    }
    out
}

fn sides_of(places: &MultiPolygon) -> Vec<Segment> {
    let rings = places.iter().flat_map(|p| std::iter::once(p.exterior()).chain(p.interiors()));
    rings
        .flat_map(|ring| {
            let ring = corners(ring);
            (0..ring.len()).map(move |i| (ring[i], ring[(i + 1) % ring.len()])).collect::<Vec<_>>()
        })
        .collect()
}
