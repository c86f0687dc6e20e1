//! What objects looked like in scenes that were built before: what is the same is not drawn again. An editor shows a scene
//! after every edit, and most of its objects are those of the last one.

use super::dress::{Dressed, Wardrobe};
use super::weight;
use scenelang_assets::{Mesh, Surface};
use scenelang_lang::program;
use scenelang_layout::{Convex, Geometry, Part, Placement, Vec3, convex};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

/// So many looks are kept beside those of the last scene: what is undone, or is another thing only while its name is typed,
/// comes back.
const SPARE: usize = 256;

/// The looks of objects that were drawn. Scenes that are built with it are the same as without.
#[derive(Debug, Default)]
pub struct Memory(Mutex<Known>);

#[derive(Debug, Default)]
struct Known {
    /// Each look by what it is made from, with the number of the last scene that has it.
    looks: BTreeMap<Vec<u8>, (Arc<ObjectLook>, u64)>,
    scenes: u64,
    drawn: usize,
}

/// How an object looks, in its own frame.
#[derive(Debug)]
pub(super) struct ObjectLook {
    /// The number of the look: see [`super::Object::look`].
    pub id: u64,
    /// What `dressed` and `looks` index.
    pub surfaces: Vec<Surface>,
    /// Its triangles and lights.
    pub dressed: Dressed,
    /// Its convex parts, or its box.
    pub solid: Vec<Convex>,
    /// The surface of each part.
    pub looks: Vec<usize>,
    /// Kilograms of each part.
    pub weights: Vec<f64>,
    /// The colour of each part from above.
    pub tops: Arc<Tops>,
}

/// The colours of the parts of an object that stands upright, seen from above; the plan finds them out.
pub(crate) type Tops = OnceLock<Vec<[f32; 3]>>;

impl Memory {
    /// How many objects were drawn, which is what takes time.
    pub fn drawn(&self) -> usize {
        self.known().drawn
    }

    fn known(&self) -> MutexGuard<'_, Known> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The look of an object of the furniture library.
    pub(super) fn look(
        &self,
        declared: &program::Object,
        place: &Placement,
        floor: Option<&Surface>,
    ) -> Arc<ObjectLook> {
        let key = key(declared, place, floor);
        {
            let mut known = self.known();
            let scenes = known.scenes;
            if let Some((look, last)) = known.looks.get_mut(&key) {
                *last = scenes;
                return Arc::clone(look);
            }
        }
        let look = Arc::new(ObjectLook::draw(number(&key), declared, place, floor, None));
        let mut known = self.known();
        known.drawn += 1;
        let scenes = known.scenes;
        known.looks.insert(key, (Arc::clone(&look), scenes));
        look
    }

    /// A scene is complete; what was not seen for long is forgotten.
    pub(super) fn complete(&self) {
        let mut known = self.known();
        let scenes = known.scenes;
        let shown = known.looks.values().filter(|(_, last)| *last == scenes).count();
        if known.looks.len() > shown + SPARE {
            known.looks.retain(|_, (_, last)| *last == scenes);
        }
        known.scenes += 1;
    }
}

impl ObjectLook {
    /// Draws an object; `own`: what it looks like if the furniture library does not draw it.
    fn draw(
        id: u64,
        declared: &program::Object,
        place: &Placement,
        floor: Option<&Surface>,
        own: Option<&Mesh>,
    ) -> Self {
        let solid = convex::local_solid(place, Geometry::Parts);
        let mut wardrobe = Wardrobe::default();
        let dressed = wardrobe.furnish(declared, place, &solid, own, floor);
        let surfaces = wardrobe.into_surfaces();
        let looks = weight::looks(&solid, &dressed.mesh);
        let weights = solid.iter().zip(&looks).map(|(part, &look)| weight::weight(part, &surfaces[look])).collect();
        Self { id, surfaces, dressed, solid, looks, weights, tops: Arc::default() }
    }

    /// The look of an object with a mesh of its own, which is worked out anew each time.
    pub fn own(declared: &program::Object, place: &Placement, floor: Option<&Surface>, mesh: &Mesh) -> Self {
        let mut key = key(declared, place, floor);
        for group in &mesh.groups {
            key.extend_from_slice(format!("{:?}", group.surface).as_bytes());
            let points = group.positions.iter().chain(&group.normals).flatten().chain(group.uvs.iter().flatten());
            points.for_each(|x| key.extend_from_slice(&x.to_le_bytes()));
            group.indices.iter().for_each(|i| key.extend_from_slice(&i.to_le_bytes()));
        }
        Self::draw(number(&key), declared, place, floor, Some(mesh))
    }
}

/// All that the look of an object depends on.
fn key(declared: &program::Object, place: &Placement, floor: Option<&Surface>) -> Vec<u8> {
    let mut out = Vec::with_capacity(128);
    let program::Object { name, category, color, material, features, .. } = declared;
    for text in [name.as_str(), category, color, material, features] {
        out.extend_from_slice(&(text.len() as u64).to_le_bytes());
        out.extend_from_slice(text.as_bytes());
    }
    // The floor matters only to what has no colour of its own.
    let floor = floor.filter(|_| color.trim().is_empty());
    out.push(u8::from(floor.is_some()));
    floor.iter().flat_map(|floor| floor.color).for_each(|c| out.extend_from_slice(&c.to_le_bytes()));
    let mut vectors = |tag: u8, vectors: &[Vec3]| {
        out.push(tag);
        out.extend_from_slice(&(vectors.len() as u64).to_le_bytes());
        vectors.iter().flatten().for_each(|x| out.extend_from_slice(&x.to_le_bytes()));
    };
    vectors(0, &[place.scale]);
    for part in &place.parts {
        match part {
            Part::Box { pos, size, rot } => vectors(1, &[*pos, *size, *rot]),
            Part::Cylinder { pos, radius, height, rot } => vectors(2, &[*pos, *rot, Vec3::new(*radius, *height, 0.0)]),
            Part::Hull { points } => vectors(3, points),
        }
    }
    out
}

fn number(key: &[u8]) -> u64 {
    let mut hasher = DefaultHasher::new();
    key.hash(&mut hasher);
    hasher.finish()
}
