//! P-COLLIDE: the solids of two objects do not overlap by more than the tolerance.

use crate::builtins;
use crate::eval::{Cause, Truth};
use crate::number::Number;
use crate::world::World;
use scenelang_lang::program::ObjectId;

/// Whether two objects keep clear of each other: their gap, with the tolerance.
///
/// # Errors
/// The layout lacks one of them.
pub fn pair<N: Number>(world: &World<N>, a: ObjectId, b: ObjectId) -> Result<Truth<N>, Cause> {
    let gap = builtins::gap(world.object(a)?, world.object(b)?);
    let tolerances = &world.options.tolerances;
    Ok(Truth::metres(gap + N::constant(tolerances.contact), tolerances.order))
}
