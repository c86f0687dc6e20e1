//! P-OPEN: what has to open does. The solid that a movable part sweeps from closed to as far as is demanded meets no wall
//! and no other solid.
//!
//! What is demanded is part of the asset: how far a part opens that is of use. A program that asserts less of an object
//! lowers it. Which objects are asked is a setting.

use crate::eval::{Cause, Truth};
use crate::number::Number;
use crate::opening::{self, LOOKS, Met};
use crate::tolerances::Opens;
use crate::world::World;
use scenelang_lang::program::ObjectId;
use scenelang_layout::Aabb;

/// What is further (metres) from where a part goes than this does not change whether it opens: what things rest on may.
pub const REACH: f64 = opening::CARRIED;

/// The parts of an object that P-OPEN speaks of, by index, and how far each has to open (degrees or metres).
pub fn demands<N: Number>(world: &World<N>, id: ObjectId) -> Vec<(u8, f64)> {
    let asked = match world.options.opens {
        Opens::All => true,
        Opens::Doors => world.habits.is_door(id),
        Opens::None => false,
    };
    if !asked || !world.options.physics {
        return Vec::new();
    }
    let joints = opening::joints(world, id).iter().enumerate();
    joints.filter_map(|(i, joint)| Some((u8::try_from(i).ok()?, world.habits.demand(id, joint)?))).collect()
}

/// Whether a part opens as far as is demanded.
///
/// # Errors
/// The layout lacks the object.
pub fn part<N: Number>(world: &World<N>, id: ObjectId, part: u8) -> Result<Truth<N>, Cause> {
    part_within(world, id, part, &mut { LOOKS })
}

/// The same with no more than so many looks at poses.
///
/// # Errors
/// The layout lacks the object.
pub(crate) fn part_within<N: Number>(
    world: &World<N>,
    id: ObjectId,
    part: u8,
    looks: &mut usize,
) -> Result<Truth<N>, Cause> {
    let demand = demands(world, id).into_iter().find(|(index, _)| *index == part);
    match demand {
        Some((_, amount)) => opening::opens(world, id, usize::from(part), amount, looks),
        None => world.object(id).map(|_| Truth::discrete(true)),
    }
}

/// What keeps a part from opening as far as is demanded, or comes nearest to that.
pub fn met<N: Number>(world: &World<N>, id: ObjectId, part: u8) -> Option<Met> {
    let (_, amount) = demands(world, id).into_iter().find(|(index, _)| *index == part)?;
    Some(opening::nearest(world, id, usize::from(part), amount, &mut { LOOKS }).ok()??.met)
}

/// The upright box that everything which can change the verdict of P-OPEN on an object reaches into; `None`: the rule does
/// not speak of it.
pub fn reach<N: Number>(world: &World<N>, id: ObjectId) -> Option<Aabb> {
    let body = &world.object(id).ok()?.body;
    let boxes = demands(world, id).into_iter().filter_map(|(part, amount)| {
        let moving = body.moving(usize::from(part))?;
        Some(moving.around(amount))
    });
    boxes.reduce(|a, b| a.cover(&b))
}
