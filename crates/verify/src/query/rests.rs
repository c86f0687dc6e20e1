//! What an object rests on, as it stands.

use crate::Checked;
use crate::check::Subject;
use crate::report::model::RowKind;
use crate::rules::support;
use crate::world::World;
use scenelang_lang::program::{MountedOn, ObjectId, Program};
use scenelang_layout::Vec2;
use serde::Serialize;

/// What an object rests on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RestsOn {
    /// What kind of thing that is.
    pub on: On,
    /// Which: an object, or the region whose floor, wall or ceiling it is. Of what rests on nothing, the object that is
    /// nearest below or above its lowest point. `None`: a floor that belongs to no region.
    pub name: Option<String>,
    /// How far its lowest point is above that (metres, negative below); only where it rests on nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gap: Option<f64>,
}

/// Kinds of things to rest on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum On {
    Floor,
    /// Another object.
    Object,
    /// A wall that it hangs on, or is set in.
    Wall,
    Ceiling,
    /// The object that it is in.
    Inside,
    Nothing,
}

/// What an object rests on; `None`: it has no place.
pub(super) fn on(checked: &Checked, program: &Program, world: &World<f64>, id: ObjectId) -> Option<RestsOn> {
    let object = |id: ObjectId| Some(program.objects[id.0 as usize].name.to_string());
    let region = |id: scenelang_lang::program::RegionId| Some(program.regions[id.0 as usize].name.to_string());
    let rest = support::rest(world, id, &support::others(world, id)).ok()?;
    let allow = &program.allow;
    // What is mounted is where it should be unless its rule fails.
    let is_off =
        checked.verdict.rows.iter().any(|row| {
            row.kind == RowKind::Support && row.subject == Subject::Object(id) && row.satisfied == Some(false)
        });
    if let Some(mount) = allow.mounts.iter().find(|mount| mount.object == id).filter(|_| !is_off) {
        let on = if mount.on == MountedOn::Wall { On::Wall } else { On::Ceiling };
        return Some(RestsOn { on, name: region(mount.region), gap: None });
    }
    if let Some(door) = allow.doors.iter().find(|door| door.object == id) {
        return Some(RestsOn { on: On::Wall, name: region(door.first), gap: None });
    }
    if rest.off.is_some() && rest.truth(&world.options.tolerances).holds {
        return Some(match rest.carrier {
            Some(carrier) => RestsOn { on: On::Object, name: object(carrier), gap: None },
            None => RestsOn { on: On::Floor, name: floor(program, world, id, rest.nearest), gap: None },
        });
    }
    if let Some((_, container)) = allow.contents.iter().find(|(content, _)| *content == id).filter(|_| !is_off) {
        return Some(RestsOn { on: On::Inside, name: object(*container), gap: None });
    }
    let name = rest.carrier.and_then(object);
    Some(RestsOn { on: On::Nothing, name, gap: Some(rest.lowest - rest.nearest) })
}

/// The region whose floor is at a height under an object.
fn floor(program: &Program, world: &World<f64>, id: ObjectId, height: f64) -> Option<String> {
    let center = world.object(id).ok()?.body.obb.center;
    let tolerance = world.options.tolerances.contact;
    let mut under = world.prisms().filter(|(_, prism)| {
        prism.floor == height && prism.polygon.clearance_of_point(Vec2::new(center.x, center.z)).value >= -tolerance
    });
    under.next().map(|(region, _)| program.regions[region.0 as usize].name.to_string())
}
