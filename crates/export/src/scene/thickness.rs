//! How thick the walls of a room are drawn: as thick as light walls are, where nothing is behind them.

use super::{Object, Region, RegionKind};
use crate::geometry::polygon::outward;
use scenelang_layout::planar::{convex_hull, edges};
use scenelang_layout::{Obb, Vec2};

/// A light partition wall: a stud of 75 to 100 mm with plasterboard on both sides, metres.
const WALL: f64 = 0.12;
/// Neighbouring edges that turn by less than this (sine) have the same thickness.
const STRAIGHT: f64 = 0.2;
/// What lies this far inside a wall does not stand behind it, metres.
const INSIDE: f64 = 1e-3;

/// What stands outside a room, and what part of the gap before it a wall may fill.
struct Neighbour {
    outline: Vec<Vec2>,
    share: f64,
}

/// The thickness of the wall over each edge of a room's floor, at least `least`. `openers` are objects in walls.
pub(super) fn of(
    room: usize,
    regions: &[Region],
    objects: &[Object],
    openers: impl Fn(usize) -> bool,
    least: f64,
) -> Vec<f64> {
    let prism = &regions[room].prism;
    let meets = |low: f64, high: f64| low < prism.ceiling && high > prism.floor;
    let region = |(index, region): (usize, &Region)| {
        let other = &region.prism;
        let beside = index != room && region.kind != RegionKind::Zone && meets(other.floor, other.ceiling);
        // Rooms have a wall each; the floor of a terrace reaches up to the wall.
        let share = if region.kind == RegionKind::Room { 0.5 } else { 1.0 };
        beside.then(|| Neighbour { outline: other.polygon.corners().to_vec(), share })
    };
    let object = |(index, object): (usize, &Object)| {
        let (low, high) = (object.place.pos.y, object.place.pos.y + object.place.scale.y);
        let outside = !openers(index) && meets(low, high) && !prism.polygon.contains(object.place.pos.xz());
        let outline = || convex_hull(Obb::from_placement(&object.place).corners().iter().map(|c| c.xz()));
        outside.then(|| Neighbour { outline: outline(), share: 1.0 })
    };
    let mut neighbours: Vec<Neighbour> = regions.iter().enumerate().filter_map(region).collect();
    neighbours.extend(objects.iter().enumerate().filter_map(object));
    let corners = prism.polygon.corners();
    let n = corners.len();
    let free = |(from, to), beyond: [f64; 2]| {
        neighbours.iter().map(|n| n.share * gap(from, to, beyond, &n.outline)).fold(WALL, f64::min).max(least)
    };
    let alone: Vec<f64> = edges(corners).map(|edge| free(edge, [0.0; 2])).collect();
    // At a corner a wall reaches as far as the next one is thick.
    let beyond = |i: usize| [alone[(i + n - 1) % n], alone[(i + 1) % n]];
    let mut out: Vec<f64> = edges(corners).enumerate().map(|(i, edge)| free(edge, beyond(i))).collect();
    even_out(corners, &mut out);
    out
}

/// How far an outline is from an edge, straight outwards from it and so far beyond its ends.
fn gap(from: Vec2, to: Vec2, beyond: [f64; 2], outline: &[Vec2]) -> f64 {
    let length = (to - from).norm().max(1e-9);
    let (along, out) = ((to - from) / length, outward(from, to));
    let local = |p: Vec2| Vec2::new((p - from).dot(&along), (p - from).dot(&out));
    let piece = |(a, b): (Vec2, Vec2)| {
        let [a, b] = [local(a), local(b)];
        let [low, high] = if a.x <= b.x { [a, b] } else { [b, a] };
        let (left, right) = (low.x.max(-beyond[0]), high.x.min(length + beyond[1]));
        if left > right - 1e-9 && high.x - low.x > 1e-9 || left > right {
            return f64::INFINITY;
        }
        let height = |x: f64| low.y + (high.y - low.y) * ((x - low.x) / (high.x - low.x).max(1e-9)).clamp(0.0, 1.0);
        let ends = if high.x - low.x < 1e-9 { [low.y, high.y] } else { [height(left), height(right)] };
        let [near, far] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        if far < -INSIDE { f64::INFINITY } else { near.max(0.0) }
    };
    edges(outline).map(piece).fold(f64::INFINITY, f64::min)
}

/// Edges that go on straight get the least thickness of all of them: there is no corner where it could change.
fn even_out(corners: &[Vec2], thick: &mut [f64]) {
    let n = corners.len();
    let turns = |i: usize| {
        let [a, b] = [outward(corners[(i + n - 1) % n], corners[i]), outward(corners[i], corners[(i + 1) % n])];
        a.perp(&b).abs() > STRAIGHT || a.dot(&b) < 0.0
    };
    // Twice around, so that what comes last reaches what came first.
    for i in (0..n).chain(0..n).chain((0..n).rev()).chain((0..n).rev()) {
        let last = (i + n - 1) % n;
        if !turns(i) {
            let least = thick[last].min(thick[i]);
            (thick[last], thick[i]) = (least, least);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::{Polygon, Prism};

    fn region(kind: RegionKind, [x, z, w, d]: [f64; 4]) -> Region {
        let corners = [[x, z], [x + w, z], [x + w, z + d], [x, z + d]];
        let prism = Prism { polygon: Polygon::new(&corners).unwrap(), floor: 0.0, ceiling: 2.5 };
        Region { name: "r".into(), kind, prism }
    }

    fn thickness(others: &[(RegionKind, [f64; 4])]) -> Vec<f64> {
        let mut regions = vec![region(RegionKind::Room, [0.0, 0.0, 4.0, 3.0])];
        regions.extend(others.iter().map(|(kind, at)| region(*kind, *at)));
        of(0, &regions, &[], |_| false, 0.03)
    }

    #[test]
    fn walls_are_as_thick_as_there_is_room_for() {
        let near = |found: &[f64], expected: [f64; 4]| {
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} {expected:?}");
        };
        // The edges are those at the south, east, north and west.
        near(&thickness(&[]), [0.12; 4]);
        near(&thickness(&[(RegionKind::Room, [4.1, 0.0, 3.0, 3.0])]), [0.12, 0.05, 0.12, 0.12]);
        near(&thickness(&[(RegionKind::Room, [4.0, 1.0, 3.0, 1.0])]), [0.12, 0.03, 0.12, 0.12]);
        near(&thickness(&[(RegionKind::Room, [4.3, 0.0, 3.0, 3.0])]), [0.12; 4]);
        near(&thickness(&[(RegionKind::Outdoor, [1.0, 3.08, 1.0, 1.0])]), [0.12, 0.12, 0.08, 0.12]);
        // A zone at the wall is inside.
        near(&thickness(&[(RegionKind::Zone, [3.0, 0.0, 1.0, 1.0])]), [0.12; 4]);
        // Only beyond a corner.
        near(&thickness(&[(RegionKind::Room, [4.06, 3.06, 2.0, 2.0])]), [0.12, 0.03, 0.03, 0.12]);
    }

    #[test]
    fn a_wall_that_goes_on_straight_keeps_its_thickness() {
        let corners: Vec<Vec2> = [[0.0, 0.0], [2.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]].map(Vec2::from).to_vec();
        let mut thick = [0.12, 0.03, 0.12, 0.12, 0.12];
        even_out(&corners, &mut thick);
        assert_eq!(thick, [0.03, 0.03, 0.12, 0.12, 0.12]);
    }
}
