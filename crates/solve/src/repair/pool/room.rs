//! Candidates from the room: along its walls, in its corners and its middle, on its floor, under its ceiling, in its
//! walls.

use super::{Chance, Pool, SKIRTING};
use crate::problem::pose::{Pose, round_turn, yaw_towards};
use crate::search::looks::LINTEL;
use scenelang_lang::program::RegionId;
use scenelang_layout::{Vec2, Vec3};

/// Centre heights that are tried on walls (metres above the floor).
const HEIGHTS: [f64; 3] = [1.5, 1.2, 1.8];
/// How many random places on the floor of a region.
const SCATTERED: usize = 24;

/// A side of a room.
#[derive(Clone, Copy, Debug)]
struct Wall {
    from: Vec3,
    along: Vec3,
    inward: Vec3,
    length: f64,
}

impl Wall {
    fn new((a, b): (Vec2, Vec2)) -> Self {
        let length = (b - a).norm();
        let along = (b - a) / length;
        Self {
            from: Vec3::new(a.x, 0.0, a.y),
            along: Vec3::new(along.x, 0.0, along.y),
            // Polygons run from x towards z, the inside on the positive side.
            inward: Vec3::new(-along.y, 0.0, along.x),
            length,
        }
    }
    /// A point so far along and so far inside.
    fn point(&self, along: f64, inside: f64) -> Vec3 {
        self.from + self.along * along + self.inward * inside
    }
    /// How far along a point is.
    fn shadow(&self, p: &Vec3) -> f64 {
        (p - self.from).dot(&self.along)
    }
}

impl Pool<'_, '_> {
    /// Walls, corners, middle, grid and anywhere, in all regions that come into question.
    pub(super) fn around_the_room(&mut self) {
        for region in self.regions() {
            self.along_walls(region);
            self.on_the_floor(region);
        }
        if self.state.frame.program.regions.is_empty() {
            self.in_the_open();
        }
    }

    fn walls(&self, region: RegionId) -> Vec<Wall> {
        self.prism(region).map_or(Vec::new(), |p| p.polygon.edges().map(Wall::new).collect())
    }

    /// Places along a wall for something that reaches so far to either side: both ends, the middle, the quarters, where
    /// others are, and some at random.
    fn stations(&mut self, wall: &Wall, reach: f64) -> Vec<f64> {
        let room = wall.length - 2.0 * reach;
        if room < 0.0 {
            return if room > -1e-6 { vec![wall.length / 2.0] } else { Vec::new() };
        }
        let mut list = vec![reach, wall.length - reach, wall.length / 2.0, reach + room / 4.0, reach + room * 0.75];
        if room > 2.0 * SKIRTING {
            list.extend([reach + SKIRTING, wall.length - reach - SKIRTING]);
        }
        for other in self.related().into_iter().take(6) {
            let pose = self.state.pose(other);
            let (at, half) = (wall.shadow(&pose.center()), pose.reach(&wall.along));
            let ends = [at, at - half - reach - 0.02, at + half + reach + 0.02, at - half + reach, at + half - reach];
            list.extend(ends.into_iter().filter(|s| (reach..=wall.length - reach).contains(s)));
        }
        for _ in 0..4 {
            list.push(reach + self.chance.between(0.0, room));
        }
        list
    }

    /// With the back to a wall, or (where the yaw is fixed) with whatever side shows there.
    fn along_walls(&mut self, region: RegionId) {
        for wall in self.walls(region) {
            let back = yaw_towards(&wall.inward);
            for yaw in self.yaws(back) {
                let pose = self.now.facing(yaw);
                let (side, depth) = (pose.reach(&wall.along), pose.reach(&wall.inward));
                let stations = self.stations(&wall, side);
                // Backs are what most things show to a wall; other sides are tried in the corners and the middle.
                let count = if round_turn(yaw - back) == 0.0 || !self.turns { stations.len() } else { 3 };
                for s in stations.into_iter().take(count) {
                    let p = wall.point(s, depth + SKIRTING);
                    self.push_standing(pose.at(p.x, 0.0, p.z));
                    if self.chance.below(4) == 0 {
                        let p = wall.point(s, depth);
                        self.push_standing(pose.at(p.x, 0.0, p.z));
                    }
                }
            }
        }
    }

    /// The middle, a grid, and anywhere.
    fn on_the_floor(&mut self, region: RegionId) {
        let Some(prism) = self.prism(region) else { return };
        let polygon = prism.polygon.clone();
        let base = self.room_yaw(region);
        let middle = polygon.centroid();
        for yaw in self.yaws(base) {
            self.push_standing(self.now.facing(yaw).at(middle.x, 0.0, middle.y));
        }
        let low = polygon.corners().iter().copied().reduce(|a, b| a.inf(&b)).unwrap_or_default();
        let high = polygon.corners().iter().copied().reduce(|a, b| a.sup(&b)).unwrap_or_default();
        for i in 1..6 {
            for j in 1..6 {
                let p = low + (high - low).component_mul(&Vec2::new(f64::from(i), f64::from(j))) / 6.0;
                if polygon.contains(p) {
                    let yaws = self.yaws(base);
                    let yaw = yaws[self.chance.below(yaws.len())];
                    self.push_standing(self.now.facing(yaw).at(p.x, 0.0, p.y));
                }
            }
        }
        for _ in 0..SCATTERED {
            let p = Vec2::new(self.chance.between(low.x, high.x), self.chance.between(low.y, high.y));
            let free = self.turns && self.chance.below(8) == 0;
            let yaws = self.yaws(base);
            let yaw = if free { self.chance.between(0.0, 360.0) } else { yaws[self.chance.below(yaws.len())] };
            if polygon.contains(p) {
                self.push_standing(self.now.facing(yaw).at(p.x, 0.0, p.y));
            }
        }
    }

    /// Without any region: around what there is.
    fn in_the_open(&mut self) {
        let spans = self.state.placed().map(|o| *self.state.span(o)).reduce(|a, b| a.cover(&b));
        let (low, high) = spans.map_or((Vec3::zeros(), Vec3::zeros()), |s| (s.min, s.max));
        let room = self.now.scale.amax() + 0.5;
        self.push_standing(self.now.at(0.0, 0.0, 0.0));
        for _ in 0..2 * SCATTERED {
            let x = self.chance.between(low.x - room, high.x + room);
            let z = self.chance.between(low.z - room, high.z + room);
            let yaws = self.yaws(0.0);
            let yaw = yaws[self.chance.below(yaws.len())];
            self.push_standing(self.now.facing(yaw).at(x, 0.0, z));
        }
    }

    /// Flat against a wall, at heights where things hang, and beside or over what it has to do with.
    pub(super) fn on_wall(&mut self, region: RegionId) {
        let Some((floor, ceiling)) = self.prism(region).map(|p| (p.floor, p.ceiling)) else { return };
        let tall = self.now.scale.y;
        let mut heights: Vec<f64> = HEIGHTS.map(|h| floor + h - tall / 2.0).to_vec();
        for other in self.related().into_iter().take(4) {
            let span = self.state.span(other);
            heights.extend([span.max.y + 0.15, span.max.y + 0.4, (span.min.y + span.max.y - tall) / 2.0, span.min.y]);
        }
        heights.retain(|h| *h >= floor && h + tall <= ceiling);
        if heights.is_empty() {
            heights.push(floor);
        }
        for wall in self.walls(region) {
            let back = yaw_towards(&wall.inward);
            if !self.turns && round_turn(self.now.rot.y - back) > 0.1 && round_turn(back - self.now.rot.y) > 0.1 {
                continue;
            }
            let pose = self.now.facing(if self.turns { back } else { self.now.rot.y });
            let depth = pose.reach(&wall.inward);
            for s in self.stations(&wall, pose.reach(&wall.along)) {
                let p = wall.point(s, depth);
                self.out.extend(heights.iter().map(|&y| pose.at(p.x, y, p.z)));
            }
        }
    }

    /// With its top at the ceiling: in the middle, over others, on a grid.
    pub(super) fn under_ceiling(&mut self, region: RegionId) {
        let Some(prism) = self.prism(region) else { return };
        let y = prism.ceiling - self.now.scale.y;
        let corners = prism.polygon.corners();
        let low = corners.iter().copied().reduce(|a, b| a.inf(&b)).unwrap_or_default();
        let high = corners.iter().copied().reduce(|a, b| a.sup(&b)).unwrap_or_default();
        let middle = prism.polygon.centroid();
        let mut places = vec![middle];
        for i in 1..4 {
            places
                .extend((1..4).map(|j| low + (high - low).component_mul(&Vec2::new(f64::from(i), f64::from(j))) / 4.0));
        }
        for other in self.related() {
            let c = self.state.pose(other).center();
            places.extend([Vec2::new(c.x, c.z), Vec2::new(c.x, middle.y), Vec2::new(middle.x, c.z)]);
        }
        for _ in 0..SCATTERED / 3 {
            places.push(Vec2::new(self.chance.between(low.x, high.x), self.chance.between(low.y, high.y)));
        }
        let mut yaws = self.yaws(self.room_yaw(region));
        yaws.truncate(2);
        for p in places {
            self.out.extend(yaws.iter().map(|&yaw| self.now.facing(yaw).at(p.x, y, p.y)));
        }
    }

    /// In the wall of a region, or in the one that two share: in the middle of the wall's thickness, along it.
    pub(super) fn in_wall(&mut self, first: RegionId, second: Option<RegionId>) {
        let eta = self.state.world().options.eta;
        let Some(floor) = self.prism(first).map(|p| p.floor) else { return };
        let floor = second.and_then(|s| self.prism(s)).map_or(floor, |p| p.floor.max(floor));
        let beyond: Vec<Wall> = second.map_or(Vec::new(), |s| self.walls(s));
        for wall in self.walls(first) {
            // Stretches of this wall with the distance of the middle of the thickness.
            let mut stretches: Vec<(f64, f64, f64)> = Vec::new();
            if second.is_none() {
                stretches.push((0.0, wall.length, eta / 2.0));
            }
            for other in beyond.iter().filter(|w| w.along.dot(&wall.along) < -0.999) {
                let apart = -(other.from - wall.from).dot(&wall.inward);
                let (a, b) = (wall.shadow(&other.point(other.length, 0.0)), wall.shadow(&other.from));
                if (-0.01..0.2).contains(&apart) {
                    stretches.push((a.max(0.0), b.min(wall.length), apart / 2.0));
                }
            }
            for (from, to, middle) in stretches {
                self.in_stretch(&wall, from, to, middle, floor);
            }
        }
    }

    fn in_stretch(&mut self, wall: &Wall, from: f64, to: f64, middle: f64, floor: f64) {
        let back = yaw_towards(&wall.inward);
        let yaws = if self.turns { vec![back, round_turn(back + 180.0)] } else { vec![self.now.rot.y] };
        for yaw in yaws {
            let pose: Pose = self.now.facing(yaw);
            if pose.front().dot(&wall.inward).abs() < 0.99 {
                continue;
            }
            let half = pose.reach(&wall.along);
            let shifted = Wall { from: wall.point(from, 0.0), length: to - from, ..*wall };
            let sill = (LINTEL - pose.scale.y).max(0.0);
            for s in self.stations(&shifted, half) {
                let p = shifted.point(s, -middle);
                for y in [floor + sill, floor] {
                    self.out.push(pose.at(p.x, y, p.z));
                }
            }
        }
    }
}
