//! What works as one stands as one: a robot with what it picks from and puts on inside its fence, workplaces along their conveyor.

use super::floor::{Footprint, Pose, Shape};
use super::plan::{AtWall, Plan};
use super::slots::{Level, Slot};
use super::{groups, place, seek};

/// An element of a thing, and its place seen from the first of its formation.
#[derive(Clone, Debug)]
pub struct Piece {
    pub thing: usize,
    /// Which of several; `None`: there is one.
    pub element: Option<usize>,
    pub at: Pose,
}

/// What a formation takes.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    /// The middle of it, seen from the first piece, and how large it is.
    pub block: (Pose, [f64; 3]),
    /// What is kept free beside it.
    pub free: (Pose, [f64; 3]),
}

impl Ground {
    /// What blocks take that are seen from the first piece.
    pub fn around(blocks: &[(Pose, [f64; 3])], beyond: f64) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let mut height: f64 = 0.0;
        for (at, size) in blocks {
            let block = super::floor::Block::of(at, *size);
            for (k, axis) in [0, 2].into_iter().enumerate() {
                (low[k], high[k]) = (low[k].min(block.low[axis]), high[k].max(block.high[axis]));
            }
            height = height.max(size[1]);
        }
        let at = Pose { x: (low[0] + high[0]) / 2.0, z: (low[1] + high[1]) / 2.0, ..Pose::default() };
        let size = [high[0] - low[0], height, high[1] - low[1]];
        let free = [size[0] + 2.0 * beyond, height, size[2] + 2.0 * beyond];
        Self { block: (at, size), free: (at, free) }
    }
}

/// Gives a formation its place, its first piece in the middle of the room if it is `centred`. Whether there is one.
pub fn put(plan: &mut Plan, pieces: &[Piece], taken: Ground, (yaws, centred): (&[f64], bool), why: &str) -> bool {
    let (Some(first), Some(floor)) = (pieces.first(), plan.ground.as_ref()) else { return false };
    let (at, size) = taken.block;
    let block = Footprint { thing: first.thing, at, size, flat: false, tall: false };
    let shape = Shape { pieces: vec![block], free: vec![taken.free], ..Shape::default() };
    let middle = Pose { x: -at.x, z: -at.z, ..Pose::default() };
    let places: Vec<Pose> = match centred {
        true => yaws.iter().map(|yaw| Pose { yaw: *yaw, ..Pose::default() }).collect(),
        false => {
            let whole = seek::on_floor(floor.size, taken.free.1.map(|v| (v - 1.2).max(0.1)), yaws);
            whole.iter().map(|at| at.then(&middle)).collect()
        }
    };
    let off = |pose: &Pose| {
        let turned = yaws.iter().position(|yaw| *yaw == pose.yaw).unwrap_or(0);
        pose.then(&at).x.hypot(pose.then(&at).z) + turned as f64
    };
    let Some(pose) = seek::best(floor, &shape, places.into_iter(), &|pose| Some(off(pose))) else { return false };
    plan.ground.iter_mut().for_each(|ground| ground.take(&shape, &pose));
    plan.take(size, 1, false);
    let name = |plan: &Plan, piece: &Piece| {
        let name = &plan.draft.things[piece.thing].name;
        piece.element.map_or_else(|| name.clone(), |i| format!("{name}[{i}]"))
    };
    let root = name(plan, first);
    let room = plan.room_name();
    plan.say(format!("assert {};", place::absolute(&root, &room, [pose.x, 0.0, pose.z], pose.yaw)), why);
    for piece in pieces {
        let element = name(plan, piece);
        plan.note_place(&element, &pose.then(&piece.at));
        if element != root {
            let Pose { x, z, yaw, .. } = piece.at;
            let slot = Slot { x, z, level: Level::Floor, yaw };
            plan.say(format!("assert {};", place::fixed(&element, &root, &slot, 0.0, 0.0)), why);
        }
        if !plan.claimed.contains(&piece.thing) {
            plan.claimed.push(piece.thing);
        }
    }
    true
}

/// Adds what stands on the members of a formation; seats at them are members, too.
pub fn dress(plan: &mut Plan, things: &[usize]) {
    plan.building = None;
    for thing in things {
        let noun = plan.draft.things[*thing].category.replace('_', " ");
        let seats = groups::of(&noun, plan.kind.dress).iter().any(|part| part.at.is_around());
        if !seats {
            plan.surround(*thing, AtWall::No, 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::read::{Options, read};

    #[test]
    fn what_works_as_one_stands_as_one() {
        let cell = "a robot cell with a robot arm in the middle. there is a conveyor beside the robot arm and a pallet beside \
                    the robot arm. there is a fence 4 by 4 m around the robot arm with a safety gate.";
        let line = "an assembly line, 12 m long, with a conveyor and five workbenches in a row in front of the conveyor. there \
                    is a stool in front of each workbench. there is a packing table to the right of the conveyor.";
        let servers = "a server room with two rows of four racks facing each other.";
        let machines = "a factory with two rows of four machines facing each other.";
        let shelves = "a library with five bookshelves in parallel rows with 1.2 m between them.";
        for (request, said) in [
            (cell, "conveyor.pos = robotArm.pos - robotArm.right * 0.8"),
            (cell, "pallet.pos = robotArm.pos + robotArm.right * 0.9"),
            (cell, "fence.pos = robotArm.pos and"),
            (cell, "safetyGate.pos = robotArm.pos + robotArm.front * 1.975"),
            (cell, "near(fence, robotArm, 2)"),
            (line, "workbench[4].pos = conveyor.pos + conveyor.right * 3.8"),
            (line, "stool[2].pos = conveyor.pos + conveyor.front * 1.38"),
            (servers, "serverRack[0].pos.z - r * 2.2"),
            (machines, "machine[0].pos.z - r * 2.7"),
            (shelves, "bookshelf[0].pos.z - i * 1.5"),
            (line, "packingTable.pos = conveyor.pos - conveyor.right * 5.18"),
        ] {
            let draft = read(request, &Options::default()).draft;
            let has = draft.statements.iter().any(|statement| statement.text.contains(said));
            let about = said.split('.').next().unwrap_or("");
            let found: Vec<&str> =
                draft.statements.iter().map(|s| s.text.as_str()).filter(|text| text.contains(about)).collect();
            assert!(has, "{said}: {found:#?}");
        }
    }
}
