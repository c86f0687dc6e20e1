//! Where the centre of a disc is free: the floor, less everything that blocks grown by the radius.
//!
//! Growing is done here, corner by corner, so that the number of corners of an arc is ours to choose; unions and
//! differences are geo's.

use geo::algorithm::bool_ops::FillRule;
use geo::{BooleanOps, BoundingRect, Coord, InteriorPoint, Intersects, LineString, MultiPolygon, Polygon, unary_union};
use scenelang_lang::program::ObjectId;
use scenelang_layout::Vec2;

/// Points nearer to each other than this are one (metres).
const SAME: f64 = 1e-9;

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

/// The floor made of rooms and doors (simple polygons).
pub(super) fn whole(outlines: &[Vec<Vec2>]) -> MultiPolygon {
    let outlines: Vec<Polygon> = outlines.iter().map(|corners| polygon(corners)).collect();
    unary_union(&outlines)
}

impl Ground {
    /// A floor with walls around it and objects on it.
    pub fn new(whole: MultiPolygon, objects: impl IntoIterator<Item = Obstacle>) -> Self {
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

    /// The same without some obstacles, by their indices.
    pub fn without(&self, gone: &[usize]) -> Self {
        let stays = self.obstacles.iter().enumerate().filter(|(i, _)| !gone.contains(i));
        Self { whole: self.whole.clone(), obstacles: stays.map(|(_, obstacle)| obstacle.clone()).collect() }
    }

    /// Where the centre of a disc is free, with a further obstacle if one is given.
    pub fn free(&self, radius: f64, corners: usize, further: Option<&[Vec2]>) -> Floor {
        let outlines = self.obstacles.iter().map(|o| o.outline.as_slice()).chain(further);
        let blocked: Vec<Polygon> = outlines.map(|outline| grown(outline, radius, corners)).collect();
        Floor { pieces: without(&self.whole, &blocked), whole: self.whole.clone(), blocked }
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
        let blocked: Vec<Polygon> = self.blocked.iter().filter(meets).cloned().collect();
        let free = without(&self.whole.intersection(&near), &blocked);
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

/// What remains of polygons without others, which may overlap: all of them run round the same way.
fn without(whole: &MultiPolygon, others: &[Polygon]) -> Vec<Polygon> {
    whole.difference_with_fill_rule(&MultiPolygon(others.to_vec()), FillRule::NonZero).0
}

/// A convex polygon (or a segment, or a point) and everything within `radius` of it; round corners are inscribed.
///
/// Around each corner run the steps that lie between the normals of its two sides. A side is moved out whole: its own normal
/// is a step at both of its ends.
fn grown(shape: &[Vec2], radius: f64, corners: usize) -> Polygon {
    let step = |i: usize| {
        let (sin, cos) = scenelang_layout::rotation::sin_cos(360.0 * (i % corners) as f64 / corners as f64);
        Vec2::new(cos, sin)
    };
    let sides: Vec<(Vec2, Vec2)> = scenelang_layout::planar::edges(shape)
        .filter_map(|(a, b)| (b - a).try_normalize(SAME).map(|along| (a, Vec2::new(along.y, -along.x))))
        .collect();
    if sides.is_empty() {
        let around = shape.first().into_iter().flat_map(|at| (0..corners).map(move |i| at + step(i) * radius));
        return polygon(&around.collect::<Vec<_>>());
    }
    let mut out: Vec<Vec2> = Vec::with_capacity(corners + 2 * sides.len());
    let mut push = |at: Vec2| {
        if out.last().is_none_or(|last: &Vec2| (at - last).norm() > SAME) {
            out.push(at);
        }
    };
    for (i, (_, before)) in sides.iter().enumerate() {
        let (at, after) = sides[(i + 1) % sides.len()];
        push(at + before * radius);
        let turn = before.perp(&after).atan2(before.dot(&after)).to_degrees();
        // The two sides of a segment turn by half a circle, to either side.
        let turn = if turn < 0.0 { turn + 360.0 } else { turn };
        let (width, from) = (360.0 / corners as f64, before.y.atan2(before.x).to_degrees().rem_euclid(360.0));
        let first = (from / width).floor() as usize + 1;
        let last = ((from + turn) / width).ceil() as usize;
        (first..last).for_each(|i| push(at + step(i) * radius));
        push(at + after * radius);
    }
    if out.len() > 1 && (out[out.len() - 1] - out[0]).norm() <= SAME {
        out.pop();
    }
    polygon(&out)
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
    use scenelang_layout::planar::convex_hull;

    fn rectangle([x, z, w, d]: [f64; 4]) -> Vec<Vec2> {
        [(-w, -d), (w, -d), (w, d), (-w, d)].map(|(i, k)| Vec2::new(x + i / 2.0, z + k / 2.0)).to_vec()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// What is grown holds all corners moved by all steps, and has no other corners.
        #[test]
        fn grown_is_the_sum_of_a_shape_and_a_disc(
            points in proptest::collection::vec([-2.0..2.0_f64, -2.0..2.0_f64], 1..9),
            radius in 0.01..0.6_f64,
            corners in (2..9_usize).prop_map(|k| 4 * k),
        ) {
            let shape = convex_hull(points.into_iter().map(|[x, y]| Vec2::new(x, y)));
            let found: Vec<Vec2> = grown(&shape, radius, corners).exterior().coords().map(|c| vec(*c)).collect();
            let directions = (0..corners).map(|i| std::f64::consts::TAU * i as f64 / corners as f64);
            let mut steps: Vec<Vec2> = directions.map(|a| Vec2::new(a.cos(), a.sin()) * radius).collect();
            for (a, b) in scenelang_layout::planar::edges(&shape) {
                let along = (b - a).try_normalize(1e-12).unwrap_or_default() * radius;
                steps.push(Vec2::new(along.y, -along.x));
            }
            let sums = convex_hull(shape.iter().flat_map(|p| steps.iter().map(move |s| p + s)));
            let near = |p: &Vec2, all: &[Vec2]| {
                scenelang_layout::planar::edges(all).any(|(a, b)| {
                    (scenelang_layout::planar::nearest_on_segment(p, &a, &b) - p).norm() < 1e-7
                })
            };
            prop_assert!(found.iter().all(|p| near(p, &sums)), "{found:?} {sums:?}");
            prop_assert!(sums.iter().all(|p| near(p, &found)), "{found:?} {sums:?}");
        }

        /// What gets through with a polygon around the disc gets through with the disc, and that with a polygon in it.
        #[test]
        fn few_corners_tell_the_same(
            boxes in proptest::collection::vec([-2.0..2.0_f64, -2.0..2.0_f64, 0.3..1.5_f64, 0.3..1.5_f64], 2..9),
            radius in 0.1..0.5_f64,
        ) {
            let obstacle = |b: &[f64; 4]| Obstacle { object: None, outline: rectangle(*b) };
            let ground = Ground::new(whole(&[rectangle([0.0, 0.0, 5.0, 5.0])]), boxes.iter().map(obstacle));
            let through = |radius: f64, corners: usize, reach: f64| {
                let floor = ground.free(radius, corners, None);
                let near = |k: usize| floor.pieces_near(&rectangle(boxes[k]), reach, corners);
                near(0).iter().any(|piece| near(1).contains(piece))
            };
            let apothem = |corners: usize| (std::f64::consts::PI / corners as f64).cos();
            let fine = through(radius, 256, radius + 0.05);
            for around in [8, 24] {
                prop_assert!(fine || !through(radius / apothem(around), around, radius + 0.05));
            }
            for within in [8, 32] {
                prop_assert!(!fine || through(radius, within, (radius + 0.05) / apothem(within)));
            }
        }
    }
}
