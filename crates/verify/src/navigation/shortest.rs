//! The shortest way through free space: a search over the corners that a taut string can bend at.
//!
//! Candidates wait in a queue by what they would cost at least; whether one sees the other is tested only when it comes
//! to the front.

use super::free::{Floor, Places, vec};
use geo::{BooleanOps, LineString, Polygon};
use scenelang_layout::Vec2;
use scenelang_layout::planar::{nearest_of_segments, nearest_on_segment, turn};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Corners and crossings nearer than this are one (metres).
const TOUCHING: f64 = 1e-7;

/// A way: where it starts, where it bends, where it ends. One without points stays where it is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Path {
    /// Metres.
    pub length: f64,
    /// World x, z.
    pub points: Vec<Vec2>,
}

/// The shortest way between places, given piece by piece of the floor; `None` where there is none.
pub(super) fn between(floor: &Floor, from: &[Places], to: &[Places]) -> Option<Path> {
    let pieces = floor.pieces.iter().zip(from.iter().zip(to));
    pieces
        .filter(|(_, (a, b))| a.any() && b.any())
        .filter_map(|(piece, (a, b))| {
            if a.area.intersection(&b.area).0.is_empty() {
                Search::new(piece, a, b).shortest()
            } else {
                Some(Path { length: 0.0, points: Vec::new() })
            }
        })
        .min_by(|a, b| a.length.total_cmp(&b.length))
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
    from: Vec<Shore>,
    to: Vec<Shore>,
    /// At least so much is left to go from each bend.
    rest: Vec<f64>,
}

/// The outline of places that hang together. What is near something is convex, so that a shortest way leaves the places
/// either at the point nearest to where it leads, or where the outline of what is near meets that of the floor.
struct Shore {
    sides: Vec<Segment>,
    meets: Vec<Vec2>,
}

impl Shore {
    /// Where a shortest way to a point may leave.
    fn exits(&self, point: Vec2) -> impl Iterator<Item = Vec2> + '_ {
        self.meets.iter().copied().chain(self.nearest(point))
    }
    fn nearest(&self, point: Vec2) -> Option<Vec2> {
        let points = self.sides.iter().map(|(a, b)| nearest_on_segment(&point, a, b));
        points.min_by(|p, q| (p - point).norm_squared().total_cmp(&(q - point).norm_squared()))
    }
}

/// A step that may turn out to be barred.
#[derive(PartialEq)]
struct Step {
    /// What the way costs at least if this step is taken.
    bound: f64,
    /// What it costs up to the end of this step.
    cost: f64,
    line: Segment,
    /// The bend that it comes from; `None`: it sets out.
    from: Option<usize>,
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
    fn new(piece: &Polygon, from: &Places, to: &Places) -> Self {
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
        let shores = |places: &Places| shores(places, &sides);
        let (from, to) = (shores(from), shores(to));
        let rest = bends.iter().map(|bend| {
            let far = |shore: &Shore| shore.nearest(bend.at).map_or(f64::INFINITY, |p| (p - bend.at).norm());
            to.iter().map(far).fold(f64::INFINITY, f64::min)
        });
        Self { rest: rest.collect(), sides, bends, from, to }
    }

    fn shortest(&self) -> Option<Path> {
        let mut queue = BinaryHeap::new();
        for (a, b) in self.from.iter().flat_map(|a| self.to.iter().map(move |b| (a, b))) {
            let pairs =
                a.sides.iter().flat_map(|(p, q)| b.sides.iter().map(move |(r, s)| nearest_of_segments([p, q], [r, s])));
            let nearest = pairs.min_by(|x, y| (x.1 - x.0).norm_squared().total_cmp(&(y.1 - y.0).norm_squared()));
            let starts = a.meets.iter().flat_map(|p| b.exits(*p).map(move |q| (*p, q)));
            let ends = b.meets.iter().flat_map(|q| a.exits(*q).map(move |p| (p, *q)));
            for line in nearest.into_iter().chain(starts).chain(ends) {
                let cost = (line.1 - line.0).norm();
                queue.push(Step { bound: cost, cost, line, from: None, to: None });
            }
        }
        for (i, bend) in self.bends.iter().enumerate() {
            let starts = self.from.iter().flat_map(|shore| shore.exits(bend.at));
            for start in starts.filter(|start| taut(bend, *start)) {
                let cost = (bend.at - start).norm();
                queue.push(Step { bound: cost + self.rest[i], cost, line: (start, bend.at), from: None, to: Some(i) });
            }
        }
        let mut settled: Vec<Option<(Option<usize>, Vec2)>> = vec![None; self.bends.len()];
        while let Some(step) = queue.pop() {
            if step.to.is_some_and(|i| settled[i].is_some()) || !self.sees(step.line) {
                continue;
            }
            let Some(i) = step.to else { return Some(Path { length: step.cost, points: trace(&step, &settled) }) };
            settled[i] = Some((step.from, step.line.0));
            self.leave(i, step.cost, &settled, &mut queue);
        }
        None
    }

    /// Queues the steps from a bend reached at a cost.
    fn leave(&self, index: usize, cost: f64, settled: &[Option<(Option<usize>, Vec2)>], queue: &mut BinaryHeap<Step>) {
        let here = &self.bends[index];
        for (i, next) in self.bends.iter().enumerate().filter(|(i, _)| settled[*i].is_none()) {
            if taut(here, next.at) && taut(next, here.at) {
                let (cost, line) = (cost + (next.at - here.at).norm(), (here.at, next.at));
                queue.push(Step { bound: cost + self.rest[i], cost, line, from: Some(index), to: Some(i) });
            }
        }
        for end in self.to.iter().flat_map(|shore| shore.exits(here.at)) {
            let cost = cost + (end - here.at).norm();
            queue.push(Step { bound: cost, cost, line: (here.at, end), from: Some(index), to: None });
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

/// The points of a way by its last step, and by where each bend was reached from.
fn trace(last: &Step, settled: &[Option<(Option<usize>, Vec2)>]) -> Vec<Vec2> {
    let mut points = vec![last.line.1, last.line.0];
    let mut at = last.from;
    while let Some((before, point)) = at.and_then(|i| settled[i]) {
        points.push(point);
        at = before;
    }
    points.reverse();
    points
}

/// Whether a string from a bend to a point leaves both neighbours of the bend on one side, as a taut one does; along a
/// side of the outline is on either side.
fn taut(bend: &Bend, point: Vec2) -> bool {
    let way = point - bend.at;
    let side = |neighbour: Vec2| {
        let off = way.perp(&(neighbour - bend.at));
        if off.abs() <= 10.0 * TOUCHING * way.norm() { 0.0 } else { off }
    };
    side(bend.before) * side(bend.after) >= 0.0
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

fn sides_of(ring: &LineString) -> Vec<Segment> {
    let ring = corners(ring);
    (0..ring.len()).map(|i| (ring[i], ring[(i + 1) % ring.len()])).collect()
}

/// The outlines of places on a piece of the floor with the given sides.
fn shores(places: &Places, floor: &[Segment]) -> Vec<Shore> {
    let near = sides_of(places.near.exterior());
    let on = |p: Vec2, sides: &[Segment]| {
        sides.iter().any(|(a, b)| (nearest_on_segment(&p, a, b) - p).norm() <= 10.0 * TOUCHING)
    };
    let shore = |polygon: &Polygon| {
        let rings = std::iter::once(polygon.exterior()).chain(polygon.interiors());
        let sides: Vec<Segment> = rings.flat_map(sides_of).collect();
        let meets = sides.iter().map(|(p, _)| *p).filter(|p| on(*p, &near) && on(*p, floor)).collect();
        Shore { sides, meets }
    };
    places.area.iter().map(shore).collect()
}

#[cfg(test)]
mod tests {
    use super::super::free::{Ground, Obstacle, whole};
    use super::*;
    use proptest::prelude::*;

    fn square(x: f64, z: f64, half: f64) -> Vec<Vec2> {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .map(|(i, j)| Vec2::new(x + i * half, z + j * half))
            .to_vec()
    }

    fn floor(rooms: &[Vec<Vec2>], obstacles: &[Vec<Vec2>], radius: f64, corners: usize) -> Floor {
        let obstacles = obstacles.iter().map(|outline| Obstacle { object: None, outline: outline.clone() });
        Ground::new(whole(rooms), obstacles).free(radius, corners, None)
    }

    fn length(floor: &Floor, from: &[Places], to: &[Places]) -> f64 {
        let path = between(floor, from, to);
        if let Some(path) = &path {
            let sum: f64 = path.points.windows(2).map(|p| (p[1] - p[0]).norm()).sum();
            assert!((sum - path.length).abs() < 1e-9, "{path:?}");
        }
        path.map_or(f64::INFINITY, |path| path.length)
    }

    /// All ways over all corners and over points of the outlines a hand apart, without any cleverness.
    fn brute(search: &Search) -> f64 {
        let along = |shores: &[Shore]| -> Vec<Vec2> {
            let sides = shores.iter().flat_map(|s| &s.sides);
            sides.flat_map(|(a, b)| (0..8).map(move |i| a + (b - a) * (f64::from(i) / 8.0))).collect()
        };
        let (starts, ends) = (along(&search.from), along(&search.to));
        let corners: Vec<Vec2> = search.sides.iter().map(|(a, _)| *a).collect();
        let mut cost = vec![f64::INFINITY; corners.len()];
        let mut best = f64::INFINITY;
        let step = |p: Vec2, q: Vec2| (q - p).norm();
        for &p in &starts {
            best = ends.iter().filter(|q| search.sees((p, **q))).map(|q| step(p, *q)).fold(best, f64::min);
            for (i, &q) in corners.iter().enumerate() {
                if step(p, q) < cost[i] && search.sees((p, q)) {
                    cost[i] = step(p, q);
                }
            }
        }
        let mut open: Vec<usize> = (0..corners.len()).collect();
        while let Some(at) = (0..open.len()).min_by(|&i, &j| cost[open[i]].total_cmp(&cost[open[j]])) {
            let here = open.swap_remove(at);
            for &next in &open {
                let through = cost[here] + step(corners[here], corners[next]);
                if through < cost[next] && search.sees((corners[here], corners[next])) {
                    cost[next] = through;
                }
            }
            for &q in &ends {
                let through = cost[here] + step(corners[here], q);
                if through < best && search.sees((corners[here], q)) {
                    best = through;
                }
            }
        }
        best
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

        #[test]
        fn the_way_found_is_the_shortest(blocks in prop::collection::vec((-20..=20i32, -20..=20i32, 1..=5i32), 0..6)) {
            // On a grid, so that corners meet and lie in line.
            let at = |n: i32| f64::from(n) / 4.0;
            let obstacles: Vec<Vec<Vec2>> = blocks.iter().map(|(x, z, half)| square(at(*x), at(*z), at(*half))).collect();
            let (corners, radius) = (8, 0.25);
            let floor = floor(&[square(0.0, 0.0, 5.0)], &obstacles, radius, corners);
            let (a, b) = (square(-4.0, -4.0, 0.25), square(4.0, 3.5, 0.5));
            let [from, to] = [a, b].map(|shape| floor.places(&shape, radius + 0.05, corners));
            let found = length(&floor, &from, &to);
            let expect = floor.pieces.iter().zip(from.iter().zip(&to))
                .filter(|(_, (a, b))| a.any() && b.any())
                .map(|(piece, (a, b))| brute(&Search::new(piece, a, b)))
                .fold(f64::INFINITY, f64::min);
            // The other starts only at points a hand apart, and may be longer for it.
            prop_assert!(found <= expect + 1e-9, "{} instead of {}", found, expect);
            prop_assert!(found == expect || expect - found < 0.01, "{} instead of {}", found, expect);
            let back = length(&floor, &to, &from);
            prop_assert!(back == found || (back - found).abs() < 1e-9, "{} and back {}", found, back);
        }
    }

    #[test]
    fn a_block_before_the_goal_costs_the_same_both_ways() {
        let floor = floor(&[square(0.0, 0.0, 5.0)], &[square(3.25, 3.0, 0.25)], 0.25, 8);
        let [a, b] = [square(-4.0, -4.0, 0.25), square(4.0, 3.5, 0.5)].map(|shape| floor.places(&shape, 0.3, 8));
        let (there, back) = (length(&floor, &a, &b), length(&floor, &b, &a));
        assert!((there - back).abs() < 1e-9 && (9.5..9.6).contains(&there), "{there} and back {back}");
    }

    #[test]
    fn a_disc_without_width_moves_too() {
        let floor = floor(&[square(0.0, 0.0, 2.0)], &[square(0.0, 0.0, 0.5)], 0.0, 8);
        let [from, to] = [-1.5, 1.5].map(|x| floor.places(&square(x, 0.0, 0.25), 0.05, 8));
        let found = length(&floor, &from, &to);
        assert!((2.4..2.7).contains(&found), "{found}");
    }
}
