//! A wall along one edge of a floor: what doors and windows cut out of it, what stops things, and the board at its foot.

use super::shell::{Role, Shell, Slab, WallPrism};
use crate::geometry::mesh::MeshGroup;
use crate::geometry::polygon::outward;
use scenelang_layout::{Vec2, Vec3};

/// Walls and openings count as parallel within this angle (cosine of 10°).
const PARALLEL: f64 = 0.985;
/// Height and thickness of a skirting board, metres.
const SKIRTING: [f64; 2] = [0.07, 0.012];
/// A shorter piece of a skirting board is left out, metres.
const STUB: f64 = 0.02;

/// An object that makes a hole in the walls it stands in.
#[derive(Clone, Debug, PartialEq)]
pub struct Opener {
    /// Index of the object in the scene.
    pub object: usize,
    /// Corners of its box.
    pub corners: Vec<Vec3>,
    /// Where it faces, horizontally (unit length).
    pub front: Vec2,
    /// How far it may be from a wall and still open it, metres.
    pub reach: f64,
    /// How thick walls are, metres.
    pub wall: f64,
}

impl Opener {
    /// The hole in the wall `from`–`to`: along the wall and in height; `None` where it has nothing to do with it.
    pub fn hole(&self, from: Vec2, to: Vec2) -> Option<Hole> {
        let normal = outward(from, to);
        if normal.dot(&self.front).abs() < PARALLEL {
            return None;
        }
        let wall_length = (to - from).norm();
        let along = (to - from) / wall_length;
        let range = |f: &dyn Fn(&Vec3) -> f64| {
            self.corners.iter().map(f).fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), v| (lo.min(v), hi.max(v)))
        };
        let flat = |c: &Vec3| Vec2::new(c.x, c.z) - from;
        let (near, far) = range(&|c| flat(c).dot(&normal));
        let (left, right) = range(&|c| flat(c).dot(&along));
        let (bottom, top) = range(&|c| c.y);
        let touches = far > -self.reach && near < self.wall + self.reach;
        // What stands beside the wall and does not cut into it shows its frame in front of a slightly smaller hole.
        let lap = if far > 0.005 { 0.0 } else { 0.03 };
        let hole = Hole {
            left: (left + lap).max(0.0),
            right: (right - lap).min(wall_length),
            bottom: bottom + lap,
            top: top - lap,
            lap,
            object: self.object,
        };
        (touches && hole.right - hole.left > 0.05 && hole.top - hole.bottom > 0.05).then_some(hole)
    }
}

/// A rectangular hole in a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole {
    /// Distance of its near end from the start of the wall.
    pub left: f64,
    /// Distance of its far end from the start of the wall.
    pub right: f64,
    /// World height of its lower edge.
    pub bottom: f64,
    /// World height of its upper edge.
    pub top: f64,
    /// How far the frame reaches over its edges on the inside.
    pub lap: f64,
    /// The object that made it.
    pub object: usize,
}

/// A wall before its holes are cut.
pub(super) struct Wall {
    pub from: Vec2,
    pub to: Vec2,
    /// Where the outer edge of what is drawn begins and ends.
    pub outer: [Vec2; 2],
    /// Where the outer edge of what stops things begins and ends.
    pub stop: [Vec2; 2],
    pub low: f64,
    pub high: f64,
    /// How thick it is drawn.
    pub drawn: f64,
    /// How thick it is where it stops things.
    pub stops: f64,
}

impl Wall {
    /// What is left of it beside its holes.
    pub fn shell(&self, region: &str, number: usize, holes: &[Hole], surface: usize) -> Shell {
        let mut group = MeshGroup::new(surface);
        let mut pieces = Vec::new();
        let mut boxes = Vec::new();
        for (left, right, low, high) in self.solid_rectangles(holes) {
            let polygon = self.strip(left, right);
            group.prism(&polygon, low, high);
            pieces.push(WallPrism { polygon, low, high });
            boxes.push(self.collider(left, right, low, high));
        }
        let role = Role::Wall { from: self.from, to: self.to };
        Shell { name: format!("{region}/wall{number}"), region: Some(region.to_owned()), role, group, pieces, boxes }
    }

    /// The board at its foot, where no hole reaches down to it; none where nothing of it is left.
    pub fn skirting(&self, region: &str, number: usize, holes: &[Hole], surface: usize) -> Option<Shell> {
        let [height, depth] = SKIRTING;
        let low = |h: &&Hole| h.bottom < self.low + height && h.top > self.low;
        let mut gaps: Vec<[f64; 2]> = holes.iter().filter(low).map(|h| [h.left - h.lap, h.right + h.lap]).collect();
        gaps.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut group = MeshGroup::new(surface);
        let mut pieces = Vec::new();
        let mut at = 0.0;
        for [left, right] in gaps.into_iter().chain([[self.length(); 2]]) {
            if left - at > STUB {
                let polygon = vec![self.at(left, -depth), self.at(at, -depth), self.at(at, 0.0), self.at(left, 0.0)];
                group.prism(&polygon, self.low, self.low + height);
                pieces.push(WallPrism { polygon, low: self.low, high: self.low + height });
            }
            at = right.max(at);
        }
        let role = Role::Skirting { from: self.from, to: self.to };
        let name = format!("{region}/skirting{number}");
        (!pieces.is_empty()).then(|| Shell {
            name,
            region: Some(region.to_owned()),
            role,
            group,
            pieces,
            boxes: vec![],
        })
    }

    fn length(&self) -> f64 {
        (self.to - self.from).norm()
    }

    /// The point at a distance along the inner face and a distance out of the room.
    fn at(&self, along: f64, out: f64) -> Vec2 {
        self.from + self.direction() * along + outward(self.from, self.to) * out
    }

    fn direction(&self) -> Vec2 {
        (self.to - self.from) / self.length()
    }

    /// What the holes leave of the wall's face: (left, right, low, high), from left to right.
    fn solid_rectangles(&self, holes: &[Hole]) -> Vec<(f64, f64, f64, f64)> {
        let mut cuts: Vec<f64> = holes.iter().flat_map(|h| [h.left, h.right]).chain([0.0, self.length()]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        let mut out = Vec::new();
        for pair in cuts.windows(2) {
            let middle = (pair[0] + pair[1]) / 2.0;
            let mut gaps: Vec<(f64, f64)> = holes
                .iter()
                .filter(|h| h.left < middle && middle < h.right)
                .map(|h| (h.bottom.max(self.low), h.top.min(self.high)))
                .collect();
            gaps.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut from = self.low;
            for (bottom, top) in gaps.into_iter().chain([(self.high, self.high)]) {
                if bottom - from > 1e-3 {
                    out.push((pair[0], pair[1], from, bottom));
                }
                from = from.max(top);
            }
        }
        out
    }

    /// The plan of the part between two distances along the wall; at the wall's ends the outer edge is mitred.
    fn strip(&self, left: f64, right: f64) -> Vec<Vec2> {
        let outer_left = if left < 1e-6 { self.outer[0] } else { self.at(left, self.drawn) };
        let outer_right = if right > self.length() - 1e-6 { self.outer[1] } else { self.at(right, self.drawn) };
        // The outside is on the right of the direction of travel: backwards along the inner face is positive winding.
        vec![self.at(right, 0.0), self.at(left, 0.0), outer_left, outer_right]
    }

    /// A box for the same part. At a convex corner it reaches to the outer corner, so that no gap is left there.
    fn collider(&self, left: f64, right: f64, low: f64, high: f64) -> Slab {
        let reach = |p: Vec2| (p - self.from).dot(&self.direction());
        let left = if left < 1e-6 { reach(self.stop[0]).min(0.0) } else { left };
        let right = if right > self.length() - 1e-6 { reach(self.stop[1]).max(self.length()) } else { right };
        let center = self.at((left + right) / 2.0, self.stops / 2.0);
        let t = self.direction();
        Slab {
            center: Vec3::new(center.x, (low + high) / 2.0, center.y),
            size: Vec3::new(right - left, high - low, self.stops),
            yaw: (-t.y).atan2(t.x).to_degrees() + 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::shell::{Surfaces, Thickness, room};
    use scenelang_layout::planar::edges;
    use scenelang_layout::{Polygon, Prism, rotation};

    const SURFACES: Surfaces = Surfaces { floor: 0, wall: 1, ceiling: 2, skirting: None };
    const SKIRTED: Surfaces = Surfaces { skirting: Some(3), ..SURFACES };
    const THIN: Thickness<'static> = Thickness { stops: 0.03, drawn: &[0.03; 4] };

    fn prism(vertices: &[[f64; 2]]) -> Prism {
        Prism { polygon: Polygon::new(vertices).unwrap(), floor: 0.0, ceiling: 2.5 }
    }

    fn oblong() -> Prism {
        prism(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]])
    }

    fn box_opener(center: Vec3, size: Vec3, reach: f64) -> Opener {
        let corners = (0..8)
            .map(|i| {
                let s = |bit: usize| if i >> bit & 1 == 0 { -0.5 } else { 0.5 };
                center + size.component_mul(&Vec3::new(s(0), s(1), s(2)))
            })
            .collect();
        Opener { object: 0, corners, front: Vec2::new(0.0, 1.0), reach, wall: 0.03 }
    }

    fn area(polygon: &[Vec2]) -> f64 {
        edges(polygon).map(|(a, b)| a.perp(&b)).sum::<f64>() / 2.0
    }

    fn face_area(shell: &Shell) -> f64 {
        let wall = |p: &WallPrism| (p.polygon[1] - p.polygon[0]).norm() * (p.high - p.low);
        shell.pieces.iter().map(wall).sum()
    }

    #[test]
    fn a_room_without_doors_has_one_mitred_prism_per_edge_outside_the_floor() {
        let shells = room("r", &oblong(), THIN, &[], SURFACES);
        assert_eq!(shells.len(), 6);
        for shell in &shells[2..] {
            let [piece] = &shell.pieces[..] else { panic!("{shell:?}") };
            assert!(!oblong().polygon.contains(piece.polygon.iter().sum::<Vec2>() / 4.0));
        }
        let plan: f64 = shells[2..].iter().map(|s| area(&s.pieces[0].polygon)).sum();
        assert!((plan - (4.06 * 3.06 - 12.0)).abs() < 1e-9, "{plan}");
    }

    #[test]
    fn a_door_leaves_two_sides_and_a_lintel_and_a_window_also_a_sill() {
        let door = box_opener(Vec3::new(1.0, 1.0, -0.03), Vec3::new(0.9, 2.0, 0.1), 0.07);
        let window = box_opener(Vec3::new(3.0, 1.5, 0.01), Vec3::new(1.0, 1.0, 0.1), 0.02);
        let shells = room("r", &oblong(), THIN, &[door.clone(), window], SURFACES);
        let south = &shells[2];
        assert_eq!(south.pieces.len(), 6, "side, lintel, pier, sill, lintel, side");
        assert!((face_area(south) - (4.0 * 2.5 - 0.9 * 2.0 - 1.0)).abs() < 1e-9);
        assert!(shells[3..].iter().all(|s| s.pieces.len() == 1), "only the wall they stand in is cut");
        let overlapping = room("r", &oblong(), THIN, &[door.clone(), door], SURFACES);
        assert!((face_area(&overlapping[2]) - (10.0 - 1.8)).abs() < 1e-9);
    }

    #[test]
    fn colliders_cover_their_pieces() {
        for shell in &room("r", &prism(&[[0.0, 0.0], [2.0, 1.0], [1.0, 3.0]]), THIN, &[], SURFACES)[2..] {
            let slab = shell.boxes[0];
            let axes = rotation::matrix(Vec3::new(0.0, slab.yaw, 0.0));
            for p in &shell.pieces[0].polygon {
                let local = axes.transpose() * (Vec3::new(p.x, slab.center.y, p.y) - slab.center);
                assert!(local.x.abs() <= slab.size.x / 2.0 + 1e-9 && local.z.abs() <= 0.015 + 1e-9, "{local}");
            }
        }
    }

    #[test]
    fn what_is_drawn_may_be_thicker_than_what_stops_things() {
        let drawn = Thickness { stops: 0.03, drawn: &[0.12, 0.03, 0.12, 0.12] };
        let shells = room("r", &oblong(), drawn, &[], SURFACES);
        let thin = room("r", &oblong(), THIN, &[], SURFACES);
        let plan: f64 = shells[2..].iter().map(|s| area(&s.pieces[0].polygon)).sum();
        assert!((plan - (4.15 * 3.24 - 12.0)).abs() < 1e-9, "mitred between thick and thin: {plan}");
        assert!(shells.iter().zip(&thin).all(|(thick, thin)| thick.boxes == thin.boxes));
    }

    #[test]
    fn a_skirting_board_ends_at_the_frame_of_a_door_and_passes_below_a_window() {
        let door = box_opener(Vec3::new(1.0, 1.0, -0.03), Vec3::new(0.9, 2.0, 0.1), 0.07);
        let window = box_opener(Vec3::new(3.0, 1.5, 0.01), Vec3::new(1.0, 1.0, 0.1), 0.02);
        let shells = room("r", &oblong(), THIN, &[door, window], SKIRTED);
        let boards: Vec<&Shell> = shells.iter().filter(|s| matches!(s.role, Role::Skirting { .. })).collect();
        let lengths = |s: &Shell| s.pieces.iter().map(|p| (p.polygon[1] - p.polygon[0]).norm()).collect::<Vec<_>>();
        assert_eq!(boards.len(), 4);
        assert!(
            lengths(boards[0]).iter().zip([0.55, 2.55]).all(|(a, b)| (a - b).abs() < 1e-9),
            "{:?}",
            lengths(boards[0])
        );
        assert_eq!(boards[1].name, "r/skirting1");
        let inside = |p: &Vec2| (-1e-9..=4.0 + 1e-9).contains(&p.x) && (-1e-9..=3.0 + 1e-9).contains(&p.y);
        assert!(boards.iter().flat_map(|s| &s.pieces).flat_map(|p| &p.polygon).all(inside));
        assert!(boards.iter().all(|s| s.boxes.is_empty() && area(&s.pieces[0].polygon) > 0.0));
    }
}
