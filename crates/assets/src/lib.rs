//! Furniture made to order: a request (name, category, colour, material, size) becomes convex parts and a mesh.
//!
//! A family draws every object of its kind from a handful of primitives, in metres, inside the box that was asked for,
//! so that nothing is ever stretched: legs stay as thick as legs are. The frame is that of the layout (left-handed, y up;
//! origin in the middle of the bottom face; front to +z). The parts fill the box exactly, and so does the mesh.
//!
//! Absent here: usual sizes (the language has them), placement, files.

mod apart;
mod ask;
mod block;
mod contrast;
mod families;
mod lexicon;
mod lights;
mod loft;
mod looks;
mod mesh;
mod model;
mod shapes;
pub mod textures;
mod unwrap;
mod words;

pub use contrast::{difference, stand_out};
pub use lexicon::{categories, families, family_of, stand_in};
pub use lights::Light;
pub use looks::{color_names, color_of, covering, material_names, on_floor, on_wall, skirting, toned};
pub use mesh::{Mesh, MeshGroup, Surface};
pub use words::words;

use scenelang_layout::{Joint, Part, Vec3};

/// What is asked for. Texts are as the program has them; empty ones mean nothing was said.
#[derive(Clone, Copy, Debug, Default)]
pub struct AssetRequest<'a> {
    /// The object's name (`chair[0]`): a second source for the kind, and the seed of small variations.
    pub name: &'a str,
    /// The noun.
    pub category: &'a str,
    /// A colour in words or `#rrggbb`; a second one, after a comma or "and", is for legs and the like.
    pub color: &'a str,
    /// A material in words, or two.
    pub material: &'a str,
    /// Free words: "round", "with armrests", "standing".
    pub features: &'a str,
    /// Extents w, h, d in metres, each > 0; `None`: a cube of 0.5 m.
    pub size: Option<Vec3>,
}

/// What is made.
#[derive(Clone, Debug)]
pub struct Asset {
    /// The family that drew it; `"unknown"` if none did.
    pub family: &'static str,
    /// Whether a family drew it; else it is a rounded box, to be shown with its label.
    pub known: bool,
    /// Extents w, h, d in metres: those asked for.
    pub size: Vec3,
    /// Convex solids, in the object's own frame, at scale; their common box is the object's box.
    pub parts: Vec<Part>,
    /// Height of the support surface above the base where it is not the top (a seat, a mattress).
    pub surface: Option<f64>,
    /// What of it can be opened, each with some of the parts; as they are, all is closed.
    pub joints: Vec<Joint>,
    /// What is seen.
    pub mesh: Mesh,
    /// What light it gives, if it is a lamp.
    pub lights: Vec<Light>,
    /// What to call it: the category, or the name.
    pub label: String,
}

/// Makes what is asked for. The same request gives the same asset, on every machine.
pub fn furnish(request: &AssetRequest<'_>) -> Asset {
    let mut asset = drawn(request);
    asset.mesh = std::mem::take(&mut asset.mesh).apart().unwrapped();
    asset
}

/// The same without the mesh, for whoever needs to know where it is and not what is seen of it: in less than half of the time.
pub fn solid(request: &AssetRequest<'_>) -> Asset {
    Asset { mesh: Mesh::default(), ..drawn(request) }
}

/// With a mesh as the family drew it: faces may lie in one plane, and nothing says where they are on their material.
fn drawn(request: &AssetRequest<'_>) -> Asset {
    let size =
        request.size.filter(|s| s.iter().all(|c| c.is_finite() && *c > 0.0)).unwrap_or_else(|| Vec3::repeat(0.5));
    let found = family_of(request.category, request.name).and_then(families::maker);
    let (family, maker) = found.unwrap_or(("unknown", families::unknown));
    let model = maker(&ask::Ask::new(request, size));
    let label = [request.category, request.name].into_iter().find(|t| !t.trim().is_empty()).unwrap_or("object");
    Asset {
        family,
        known: found.is_some(),
        size,
        parts: model.parts,
        surface: model.surface,
        joints: model.joints,
        lights: lights::lights(family, &model.mesh),
        mesh: model.mesh,
        label: label.trim().to_owned(),
    }
}
