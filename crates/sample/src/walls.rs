//! From one place along the walls to another. What stands or hangs at a wall keeps its distance from it and its turn
//! towards it, so that a bed whose head is against one wall comes to have it against another. The wall that something is at
//! is the nearest one; the new place is uniform along all walls, so that the way back is as likely.

use crate::dice::Dice;
use scenelang_engine::Pose;
use scenelang_engine::pose::{round_turn, yaw_towards};
use scenelang_layout::{Vec2, Vec3};
use scenelang_verify::World;

/// Things further from every wall than this (metres) are not at one.
const AT: f64 = 1.5;
/// Shorter walls (metres) are none.
const SHORT: f64 = 1e-6;

#[derive(Clone, Copy, Debug)]
struct Wall {
    from: Vec2,
    /// Unit vector.
    along: Vec2,
    /// Unit vector into the room.
    inward: Vec2,
    length: f64,
    /// Where something faces that has its back to it (degrees).
    yaw: f64,
}

impl Wall {
    /// How far along it is, and how far from it.
    fn at(&self, pos: &Vec3) -> [f64; 2] {
        let way = Vec2::new(pos.x, pos.z) - self.from;
        [way.dot(&self.along), way.dot(&self.inward)]
    }
}

/// The walls of all regions.
pub struct Walls(Vec<Wall>);

impl Walls {
    /// Of an instance.
    pub fn new(world: &World<f64>) -> Self {
        let edges = world.prisms().flat_map(|(_, prism)| prism.polygon.edges().collect::<Vec<_>>());
        let wall = |(from, to): (Vec2, Vec2)| {
            let (way, length) = (to - from, (to - from).norm());
            let along = way / length.max(SHORT);
            let inward = Vec2::new(-along.y, along.x);
            Wall { from, along, inward, length, yaw: yaw_towards(&Vec3::new(inward.x, 0.0, inward.y)) }
        };
        Self(edges.map(wall).filter(|wall| wall.length > SHORT).collect())
    }

    /// The wall that a place is at, with how far along and how far from it.
    fn nearest(&self, pos: &Vec3) -> Option<(usize, [f64; 2])> {
        let near = self.0.iter().enumerate().map(|(i, wall)| (i, wall.at(pos)));
        let near = near.filter(|(i, [along, off])| (0.0..=self.0[*i].length).contains(along) && off.abs() <= AT);
        near.min_by(|(_, a), (_, b)| a[1].abs().total_cmp(&b[1].abs()))
    }

    /// Elsewhere along the walls; `None`: it is at none, or would be at another one there.
    pub fn elsewhere(&self, pose: &Pose, may_turn: bool, dice: &mut Dice) -> Option<Pose> {
        let (old, [_, off]) = self.nearest(&pose.pos)?;
        let new = dice.pick(self.0.iter().map(|wall| wall.length));
        let wall = self.0.get(new)?;
        let at = wall.from + wall.along * dice.between(0.0, wall.length) + wall.inward * off;
        let there = pose.at(at.x, pose.pos.y, at.y);
        let turn = round_turn(wall.yaw - self.0[old].yaw);
        let is_back = self.nearest(&there.pos).is_some_and(|(found, _)| found == new);
        if !is_back || turn != 0.0 && !may_turn {
            return None;
        }
        Some(there.facing(pose.rot.y + turn))
    }
}
