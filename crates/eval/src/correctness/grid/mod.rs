//! Holodeck's floor solver, rebuilt from its description (Yang et al., CVPR 2024, and its published parameters): a grid over the
//! room, one object after the other, thirty first placements and then the best one each time; an object without a place ends
//! the attempt, and it and those after it are left out. The best of the attempts counts.
//!
//! A program says more than its relations do: [`words`] translates what it has a word for. What is not on the floor is none
//! of its business; here it is put on what it stands on, on walls and under the ceiling, evenly, so that it is not to blame.

mod rest;
mod search;
mod words;

use crate::dataset::DatasetScene;
use crate::dataset::Dice;
use scenelang_lang::Program;
use scenelang_layout::{Layout, RegionPlacement, Vec3};
use search::{Area, GridObject, search};
use std::collections::BTreeMap;
use words::{Constraint, constraints};

/// Where something stands in its room: centre, how many quarter turns.
pub(crate) type Spot = ([f64; 2], usize);

/// What came of it.
#[derive(Clone, Debug)]
pub struct Placed {
    /// What was placed; what was left out is not there.
    pub layout: Layout,
    /// How many objects were left out.
    pub dropped: usize,
    /// How many placements were judged.
    pub work: u64,
    /// Whether the limit of work ended it.
    pub is_cut: bool,
}

/// Lays out a scene of the dataset.
pub fn place(scene: &DatasetScene, program: &Program, seed: u64) -> Placed {
    let start = super::problem(program, seed).start;
    let mut spots: BTreeMap<String, ([f64; 3], usize)> = BTreeMap::new();
    let (mut work, mut is_cut) = (0, false);
    for (r, room) in scene.rooms.iter().enumerate() {
        let size = [room.size[0], room.size[2]];
        let (names, all) = constraints(scene, &room.name);
        let pieces: Vec<GridObject> = names
            .iter()
            .zip(&all)
            .filter_map(|(name, own)| {
                let size = start.object(name)?.scale;
                Some(GridObject { size: [size.x, size.z], constraints: own.clone() })
            })
            .collect();
        // A room of which some objects have no size is none that the program has.
        if pieces.len() != names.len() {
            continue;
        }
        let area = Area { size, taken: doors(scene, r) };
        let found = search(&area, &pieces, &mut Dice::new(seed, r as u64));
        work += found.work;
        is_cut |= found.is_cut;
        for (name, spot) in names.iter().zip(found.spots) {
            if let Some((at, turns)) = spot {
                spots.insert(name.clone(), ([at[0] + room.x, 0.0, at[1]], turns));
            }
        }
    }
    rest::place(scene, &start, &mut spots);
    let mut layout = Layout { seed: Some(seed), draws: start.draws.clone(), ..Layout::default() };
    for room in &scene.rooms {
        layout.regions.push((room.name.as_str().into(), region(room)));
    }
    for (name, placement) in &start.objects {
        if let Some((at, turns)) = spots.get(name.as_str()) {
            let mut placement = placement.clone();
            placement.pos = Vec3::from(*at);
            placement.rot = Vec3::new(0.0, 90.0 * *turns as f64, 0.0);
            layout.objects.push((name.clone(), placement));
        }
    }
    let dropped = program.objects.len() - layout.objects.len();
    Placed { layout, dropped, work, is_cut }
}

pub(crate) fn region(room: &crate::dataset::RoomRecord) -> RegionPlacement {
    RegionPlacement {
        pos: Vec3::new(room.x, 0.0, 0.0),
        rot: Vec3::zeros(),
        scale: Vec3::from(room.size),
        vertices: None,
    }
}

/// The floor before the doors of a room, which is kept free: centre and extents.
fn doors(scene: &DatasetScene, room: usize) -> Vec<([f64; 2], [f64; 2])> {
    let [w, _, d] = scene.rooms[room].size;
    let name = &scene.rooms[room].name;
    let mine = scene.connections.iter().filter(|c| c.kind == "door" && c.between.contains(name));
    let one = |c: &crate::dataset::Connection| match c.between[1].as_str() {
        "outside" => ([0.0, -d / 2.0 + 0.5], [1.0, 1.0]),
        _ if room == 0 => ([w / 2.0 - 0.5, 0.0], [1.0, 1.0]),
        _ => ([-w / 2.0 + 0.5, 0.0], [1.0, 1.0]),
    };
    mine.map(one).collect()
}
