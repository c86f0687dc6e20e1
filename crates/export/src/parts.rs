//! What a scene consists of, as sums: by them it is known which exported files still show the scene as it is, and if they do
//! not, because of what.

use crate::Scene;
use crate::geometry::mesh::MeshGroup;
use crate::scene::Object;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::{self, Debug, Write};

/// How many digits of a sum are enough to tell two parts of a scene apart.
const DIGITS: usize = 16;

/// Sums by part: `look lamp`, `place lamp`, `building`, `lights`, `program`, `layout`, `report`.
pub type Parts = BTreeMap<String, String>;

/// Which parts of a scene a format shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shows {
    #[default]
    All,
    /// What can be seen and touched, but no text and no verdict.
    Bodies,
}

/// The parts of a scene that a format shows.
pub fn parts(scene: &Scene, shows: Shows) -> Parts {
    let mut out = Parts::new();
    for object in &scene.objects {
        out.insert(format!("look {}", object.name), look(scene, object));
        let place = (object.place.pos, object.place.rot);
        out.insert(format!("place {}", object.name), Sum::of(&place));
    }
    let mut building = Sum::new();
    building.add(&scene.regions);
    for shell in &scene.shells {
        building.group(scene, &shell.group);
        building.add(&(&shell.name, &shell.region, shell.role, &shell.pieces, &shell.boxes));
    }
    building.add(&(&scene.name, scene.objects.iter().map(|object| &object.name).collect::<Vec<_>>()));
    out.insert("building".into(), building.end());
    out.insert("lights".into(), Sum::of(&(&scene.lamps, &scene.overlaps)));
    if shows == Shows::All {
        out.insert("program".into(), Sum::of(&scene.program));
        out.insert("layout".into(), Sum::of(&scene.layout_text));
        out.insert("report".into(), Sum::of(&(&scene.report, &scene.rows)));
    }
    out
}

/// What an object is but for where it stands and what is said of it.
fn look(scene: &Scene, object: &Object) -> String {
    let mut sum = Sum::new();
    object.mesh.iter().for_each(|group| sum.group(scene, group));
    object.looks.iter().for_each(|&surface| sum.add(&scene.surfaces[surface]));
    let place = &object.place;
    sum.add(&(place.scale, &place.parts, &place.surface, &place.joints, &object.solid, &object.weights, object.mass));
    sum.add(&(&object.stem, &object.label, &object.category, &object.family, object.body, &object.lights));
    sum.add(&object.openings.iter().map(|opening| (opening.joint, opening.amount, &opening.swept)).collect::<Vec<_>>());
    sum.end()
}

/// A sum of values as they print themselves, which for numbers is without loss.
struct Sum(Sha256);

impl Write for Sum {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.update(text);
        Ok(())
    }
}

impl Sum {
    fn new() -> Self {
        Self(Sha256::new())
    }

    fn of(value: &impl Debug) -> String {
        let mut sum = Self::new();
        sum.add(value);
        sum.end()
    }

    fn add(&mut self, value: &impl Debug) {
        // A sum takes whatever it is given.
        let _ = writeln!(self, "{value:?}");
    }

    fn group(&mut self, scene: &Scene, group: &MeshGroup) {
        self.add(&scene.surfaces[group.surface]);
        for [x, y, z] in group.positions.iter().chain(&group.normals) {
            [x, y, z].into_iter().for_each(|v| self.0.update(v.to_le_bytes()));
        }
        group.uvs.iter().flatten().for_each(|v| self.0.update(v.to_le_bytes()));
        group.indices.iter().for_each(|v| self.0.update(v.to_le_bytes()));
    }

    fn end(self) -> String {
        let mut out = String::new();
        for byte in self.0.finalize().iter().take(DIGITS / 2) {
            let _ = write!(out, "{byte:02x}");
        }
        out
    }
}
