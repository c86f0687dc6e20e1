//! What was changed in a scene since it was exported: how its things stand now, held against the embedded layout.
//!
//! Numbers of a file are single floats, so what differs by no more than they round is where it was, and keeps its numbers. What
//! was moved or turned is where it is now; each change is reported by the name that the program has for the thing.

use super::stand::{FramePose, Standing};
use nalgebra::Matrix3;
use scenelang_base::{Diagnostic, FileId, codes};
use scenelang_layout::{Layout, Part, Placement, Vec3, file, rotation};

/// What differs by no more is where it was (metres, and entries of a matrix); of coordinates so much more for each metre that
/// they are from the origin.
const SAME: f64 = 1e-5;
const ROUNDED: f64 = 1e-6;

/// What came of a comparison.
pub(super) struct Edited {
    /// The layout as the scene stands now; `None`: as it was embedded.
    pub layout: Option<String>,
    /// What was changed.
    pub changes: Vec<Diagnostic>,
}

/// Holds what stands in a scene against the layout that it was exported with.
pub(super) fn apply(text: &str, standing: &[Standing]) -> Edited {
    let read = file::read(text, FileId(0));
    if !read.usable {
        return Edited { layout: None, changes: Vec::new() };
    }
    let mut edits = Edits { layout: read.layout, changes: Vec::new(), is_other: false };
    let names: Vec<String> = edits.layout.objects.iter().map(|(name, _)| name.to_string()).collect();
    let mut known = vec![false; standing.len()];
    for name in &names {
        let has_id = |s: &Standing| s.id.as_deref() == Some(name);
        // Where a tool has dropped what we wrote into it, the name tells.
        let has_name = |s: &Standing| s.id.is_none() && !s.is_building && s.name == *name;
        let mut own: Vec<usize> = (0..standing.len()).filter(|&i| has_id(&standing[i])).collect();
        if own.is_empty() {
            own = (0..standing.len()).filter(|&i| has_name(&standing[i])).collect();
        }
        own.iter().for_each(|&i| known[i] = true);
        // Of copies that one is the object which is called so, else the first.
        let first = own.iter().position(|&i| standing[i].name == *name).unwrap_or(0);
        match own.get(first) {
            None => edits.remove(name),
            Some(&i) => {
                edits.object(name, &standing[i]);
                for copy in own.iter().filter(|copy| **copy != i) {
                    edits.say(format!("`{name}` was copied as `{}`; the copy is not checked", standing[*copy].name));
                }
            }
        }
    }
    for (thing, _) in standing.iter().zip(&known).filter(|(_, known)| !**known) {
        if thing.is_building {
            edits.building(thing);
        } else {
            edits.say(format!("`{}` was added; it is not in the program, so it is not checked", thing.name));
        }
    }
    let layout = edits.is_other.then(|| file::to_json(&edits.layout, Some(&read.document)));
    Edited { layout, changes: edits.changes }
}

struct Edits {
    layout: Layout,
    changes: Vec<Diagnostic>,
    /// Whether the layout is another one now.
    is_other: bool,
}

impl Edits {
    fn say(&mut self, what: String) {
        self.changes.push(Diagnostic::without_place(codes::W0504, what));
    }

    fn remove(&mut self, name: &str) {
        self.layout.objects.retain(|(n, _)| n != name);
        self.is_other = true;
        self.say(format!("`{name}` was removed from the scene or deactivated"));
    }

    fn object(&mut self, name: &str, thing: &Standing) {
        if thing.id.is_some() && thing.name != name {
            self.say(format!("`{name}` was renamed to `{}` in the scene", thing.name));
        }
        if let Some(parent) = &thing.parent {
            self.say(format!("`{name}` was made a child of `{parent}`; it is checked at its current position"));
        }
        let place = match &thing.place {
            Ok(place) => place,
            Err(why) => return self.say(format!("`{name}` {why}; it is checked as it was exported")),
        };
        let Some((_, placement)) = self.layout.objects.iter_mut().find(|(n, _)| n == name) else { return };
        let said = changed(placement, place);
        if !said.is_empty() {
            self.is_other = true;
            self.say(format!("`{name}` was {}", said.join(" and ")));
        }
    }

    /// A piece of the building: rooms are not judged by how their walls are drawn.
    fn building(&mut self, thing: &Standing) {
        let stays = |place: &FramePose| {
            let turned = (place.axes - Matrix3::identity()).amax();
            place.pos.amax() <= SAME && turned <= SAME && (place.scale - Vec3::from_element(1.0)).amax() <= SAME
        };
        if !thing.place.as_ref().is_ok_and(stays) {
            let say =
                format!("`{}`, a part of the building, was moved; rooms are checked as they were exported", thing.name);
            self.say(say);
        }
    }
}

/// What differs of the things of two layouts, in the words in which changes of a scene are reported: "`desk` was moved by …".
/// Of a thing that only the second one has, that it was added.
pub fn differences(before: &Layout, after: &Layout) -> Vec<String> {
    let mut out = Vec::new();
    for (name, now) in &after.objects {
        let Some(mut was) = before.object(name).cloned() else {
            out.push(format!("`{name}` was added"));
            continue;
        };
        let (axes, scale) = (rotation::matrix(now.rot), now.scale.component_div(&was.scale));
        let said = changed(&mut was, &FramePose { pos: now.pos, axes, scale });
        if !said.is_empty() {
            out.push(format!("`{name}` was {}", said.join(" and ")));
        }
    }
    out
}

/// Takes over what differs, and says what that is.
fn changed(placement: &mut Placement, place: &FramePose) -> Vec<String> {
    let mut said = Vec::new();
    let by = place.pos - placement.pos;
    if (0..3).any(|k| by[k].abs() > SAME + ROUNDED * placement.pos[k].abs()) {
        said.push(format!("moved by {}", metres(by)));
        placement.pos = place.pos.map(tidy);
    }
    let before = rotation::matrix(placement.rot);
    if (place.axes - before).amax() > SAME {
        said.push(format!("turned by {:.1}°", rotation::angle_between(&before, &place.axes)));
        placement.rot = rotation::triple(&place.axes).map(tidy);
    }
    if (place.scale - Vec3::from_element(1.0)).amax() > SAME {
        let [x, y, z] = place.scale.into();
        said.push(format!("scaled by {x:.3} × {y:.3} × {z:.3}"));
        scale(placement, place.scale.map(tidy));
    }
    said
}

/// A number of a file, without the noise of a single float.
fn tidy(value: f64) -> f64 {
    (value * 1e6).round() / 1e6 + 0.0
}

/// How far, along the axes that matter.
fn metres(by: Vec3) -> String {
    let along: Vec<String> = ["x", "y", "z"]
        .iter()
        .zip(by.iter())
        .filter(|(_, far)| far.abs() >= 5e-4)
        .map(|(axis, far)| format!("{far:+.3} m along {axis}"))
        .collect();
    if along.is_empty() { format!("{:.5} m", by.norm()) } else { along.join(", ") }
}

/// Makes a thing larger or smaller along its own axes. A part that is turned against them would be sheared: such a thing is its
/// box from then on.
fn scale(placement: &mut Placement, by: Vec3) {
    placement.scale.component_mul_assign(&by);
    placement.surface = placement.surface.map(|height| height * by.y);
    let is_even = by.max() - by.min() <= SAME;
    let straight = |rot: &Vec3| is_even || *rot == Vec3::zeros();
    let stays_itself = |part: &Part| match part {
        Part::Box { rot, .. } => straight(rot),
        Part::Cylinder { rot, .. } => straight(rot) && (by.x - by.z).abs() <= SAME,
        Part::Hull { .. } => true,
    };
    if !placement.parts.iter().all(stays_itself) {
        placement.parts.clear();
        return placement.joints.clear();
    }
    placement.joints.iter_mut().for_each(|joint| *joint = joint.stretched(&by));
    for part in &mut placement.parts {
        match part {
            Part::Box { pos, size, .. } => {
                pos.component_mul_assign(&by);
                size.component_mul_assign(&by);
            }
            Part::Cylinder { pos, radius, height, .. } => {
                pos.component_mul_assign(&by);
                (*radius, *height) = (*radius * by.x, *height * by.y);
            }
            Part::Hull { points } => points.iter_mut().for_each(|point| point.component_mul_assign(&by)),
        }
    }
}
