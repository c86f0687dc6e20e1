//! P-BOUNDS: one region holds the whole object.

use crate::builtins::in_region;
use crate::eval::{Cause, Truth};
use crate::number::Number;
use crate::world::{Body, World};
use scenelang_lang::program::{ObjectId, RegionId};
use scenelang_layout::{Aabb, Prism, Vec3};

/// Whether some region holds an object: the margin of the region that holds it best. Without any region it is −∞: the
/// rule then does not speak of it.
///
/// # Errors
/// The layout lacks the object.
pub fn object<N: Number>(world: &World<N>, id: ObjectId) -> Result<Truth<N>, Cause> {
    best(world, id).map(|(_, truth)| truth)
}

/// The same, with the region.
///
/// # Errors
/// The layout lacks the object.
pub fn best<N: Number>(world: &World<N>, id: ObjectId) -> Result<(Option<RegionId>, Truth<N>), Cause> {
    let thing = world.object(id)?;
    let mut found: (Option<RegionId>, Truth<N>) = (None, Truth::discrete(false));
    for (region, prism) in world.prisms() {
        let bound = at_most(&thing.body, prism) + world.options.tolerances.contact;
        if bound > found.1.margin.value() {
            let truth = in_region(thing, world.region(region)?, &world.options.tolerances);
            if found.0.is_none() || truth.margin.value() > found.1.margin.value() {
                found = (Some(region), truth);
            }
        }
    }
    Ok(found)
}

/// What the clearance in a region can be at most: that from the upright box around it.
fn at_most(body: &Body, prism: &Prism) -> f64 {
    let own = body.obb.aabb();
    let around = Aabb::of(
        prism
            .polygon
            .corners()
            .iter()
            .flat_map(|c| [Vec3::new(c.x, prism.floor, c.y), Vec3::new(c.x, prism.ceiling, c.y)]),
    );
    (own.min - around.min).min().min((around.max - own.max).min()) + 1e-9
}
