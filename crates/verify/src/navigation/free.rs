//! Where the centre of a disc is free: the floor, less everything that blocks grown by the radius.
//!
//! Growing is done here, corner by corner, so that the number of corners of an arc is ours to choose; unions and
//! differences are geo's.

use geo::{BooleanOps, BoundingRect, Coord, InteriorPoint, Intersects, LineString, MultiPolygon, Polygon, unary_union};
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec2;
use scenelang_layout::planar::convex_hull;

/// Something that blocks the way.
#[derive(Clone, Debug)]
pub(super) struct Obstacle {
    /// The object; `None`: a wall.
    pub object: Option<ObjectId>,
    /// Its footprint, a convex polygon; of a wall a segment.
    pub outline: Vec<Vec2>,
}

/// The floor and what stands on it, for discs of any width.
#[derive(Debug)]
pub(super) struct Ground {
    whole: MultiPolygon,
    /// Walls first, then objects.
    pub obstacles: Vec<Obstacle>,
}

impl Ground {
    /// The floor made of `rooms` (simple polygons), with walls around it and objects on it.
    pub fn new(rooms: impl IntoIterator<Item = Vec<Vec2>>, objects: impl IntoIterator<Item = Obstacle>) -> Self {
        let rooms: Vec<Polygon> = rooms.into_iter().map(|corners| polygon(&corners)).collect();
        let whole = unary_union(&rooms);
        let rings = whole.iter().flat_map(|p| std::iter::once(p.exterior()).chain(p.interiors()));
        let walls = rings.flat_map(|ring| ring.lines().map(|line| vec![vec(line.start), vec(line.end)]));
        let walls = walls.map(|outline| Obstacle { object: None, outline });
        let obstacles = walls.chain(objects).collect();
        Self { whole, obstacles }
    }

    /// The open floor, as far as anyone who walks between the things on it with this radius will go.
    pub fn open(around: &[Vec<Vec2>], objects: impl IntoIterator<Item = Obstacle>, radius: f64) -> Self {
        let points = || around.iter().flatten();
        let room = 4.0 * radius + 1.0;
        let low = points().fold(Vec2::repeat(f64::INFINITY), |m, p| m.inf(p)) - Vec2::repeat(room);
        let high = points().fold(Vec2::repeat(f64::NEG_INFINITY), |m, p| m.sup(p)) + Vec2::repeat(room);
        let whole = polygon(&[low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)]);
        Self { whole: MultiPolygon(vec![whole]), obstacles: objects.into_iter().collect() }
    }

    /// Where the centre of a disc is free, with a further obstacle if one is given.
    pub fn free(&self, radius: f64, corners: usize, further: Option<&[Vec2]>) -> Floor {
        let outlines = self.obstacles.iter().map(|o| o.outline.as_slice()).chain(further);
        let blocked: Vec<Polygon> = outlines.map(|outline| grown(outline, radius, corners)).collect();
        Floor { pieces: self.whole.difference(&unary_union(&blocked)).0, whole: self.whole.clone(), blocked }
    }
}

/// Where the centre of a disc may be, as polygons (perhaps with holes) that do not meet.
#[derive(Debug)]
pub(super) struct Floor {
    pub pieces: Vec<Polygon>,
    /// What they were cut from, and what was cut away.
    whole: MultiPolygon,
    blocked: Vec<Polygon>,
}

impl Floor {
    /// Where the disc is within `reach` of a footprint, piece by piece.
    pub fn places(&self, footprint: &[Vec2], reach: f64, corners: usize) -> Vec<Places> {
        let near = grown(footprint, reach, corners);
        self.pieces.iter().map(|piece| Places { area: piece.intersection(&near), near: near.clone() }).collect()
    }

    /// On which pieces, by index, there are places within `reach` of a footprint. It is enough to look at what is there:
    /// a piece may have very many corners.
    pub fn pieces_near(&self, footprint: &[Vec2], reach: f64, corners: usize) -> Vec<usize> {
        let near = grown(footprint, reach, corners);
        let around = near.bounding_rect();
        let meets = |polygon: &&Polygon| around.zip(polygon.bounding_rect()).is_some_and(|(a, b)| a.intersects(&b));
        let blocked = unary_union(self.blocked.iter().filter(meets));
        let free = self.whole.intersection(&near).difference(&blocked);
        let points = free.iter().filter_map(InteriorPoint::interior_point);
        let mut found: Vec<usize> =
            points.filter_map(|point| self.pieces.iter().position(|piece| piece.intersects(&point))).collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// Where a disc stands near something, on one piece of the floor.
#[derive(Debug)]
pub(super) struct Places {
    /// The part of the piece that is near.
    pub area: MultiPolygon,
    /// All that is near, on the floor or not: a convex polygon.
    pub near: Polygon,
}

impl Places {
    /// Whether there is such a place.
    pub fn any(&self) -> bool {
        !self.area.0.is_empty()
    }
    /// Some point of them: a corner, where there is any.
    pub fn some(&self) -> Option<Vec2> {
        self.area.iter().flat_map(|polygon| polygon.exterior().coords()).next().map(|c| vec(*c))
    }
}

/// A convex polygon (or a segment, or a point) and everything within `radius` of it; round corners are inscribed.
fn grown(shape: &[Vec2], radius: f64, corners: usize) -> Polygon {
    let mut steps: Vec<Vec2> = (0..corners)
        .map(|i| {
            let (sin, cos) = scenelang_layout::rotation::sin_cos(360.0 * i as f64 / corners as f64);
            Vec2::new(cos, sin) * radius
        })
        .collect();
    // A side of the shape is moved out whole: its own normal is among the steps at both of its ends.
    for (a, b) in scenelang_layout::planar::edges(shape) {
        let along = (b - a).try_normalize(0.0).unwrap_or_default() * radius;
        steps.extend([Vec2::new(along.y, -along.x), Vec2::new(-along.y, along.x)]);
    }
    // A step leads to a corner of the sum only from a corner of the shape that is farthest in about its direction.
    let wide = 4.0 * std::f64::consts::PI / corners as f64;
    let n = shape.len();
    let outward = move |i: usize, step: &Vec2| {
        [(i + 1) % n, (i + n - 1) % n].into_iter().all(|k| {
            let to = shape[k] - shape[i];
            step.dot(&to) <= wide * radius * to.norm()
        })
    };
    let steps = &steps;
    let sums = (0..n).flat_map(|i| steps.iter().filter(move |step| outward(i, step)).map(move |step| shape[i] + step));
    polygon(&convex_hull(sums))
}

fn polygon(corners: &[Vec2]) -> Polygon {
    Polygon::new(LineString(corners.iter().map(|p| Coord { x: p.x, y: p.y }).collect()), Vec::new())
}

/// A point of geo's as ours.
pub(super) fn vec(c: Coord) -> Vec2 {
    Vec2::new(c.x, c.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn rectangle([x, z, w, d]: [f64; 4]) -> Vec<Vec2> {
        [(-w, -d), (w, -d), (w, d), (-w, d)].map(|(i, k)| Vec2::new(x + i / 2.0, z + k / 2.0)).to_vec()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// What gets through with a polygon around the disc gets through with the disc, and that with a polygon in it.
        #[test]
        fn few_corners_tell_the_same(
            boxes in proptest::collection::vec([-2.0..2.0_f64, -2.0..2.0_f64, 0.3..1.5_f64, 0.3..1.5_f64], 2..9),
            radius in 0.1..0.5_f64,
        ) {
            let obstacle = |b: &[f64; 4]| Obstacle { object: None, outline: rectangle(*b) };
            let ground = Ground::new([rectangle([0.0, 0.0, 5.0, 5.0])], boxes.iter().map(obstacle));
            let through = |radius: f64, corners: usize, reach: f64| {
                let floor = ground.free(radius, corners, None);
                let near = |k: usize| floor.pieces_near(&rectangle(boxes[k]), reach, corners);
                near(0).iter().any(|piece| near(1).contains(piece))
            };
            let apothem = |corners: usize| (std::f64::consts::PI / corners as f64).cos();
            let fine = through(radius, 256, radius + 0.05);
            prop_assert!(fine || !through(radius / apothem(24), 24, radius + 0.05));
            prop_assert!(!fine || through(radius, 32, (radius + 0.05) / apothem(32)));
        }
    }
}
