//! How things look: furniture from the asset library, and the surfaces of rooms from what the program says of them.

use super::RegionKind;
use crate::geometry::mesh::MeshGroup;
use scenelang_assets::{
    Asset, AssetRequest, Light, Mesh, Surface, covering, furnish, on_floor, on_wall, skirting, stand_out, toned,
};
use scenelang_lang::program;
use scenelang_layout::{Convex, Placement};
use std::collections::BTreeMap;

/// Parts of the layout and of the library that differ by no more than this (metres) are the same.
const SAME: f64 = 1e-3;

/// The table of surfaces as it grows; a surface of a name is kept once.
#[derive(Debug, Default)]
pub(super) struct Wardrobe {
    surfaces: Vec<Surface>,
    known: BTreeMap<String, usize>,
}

/// What the library made of an object.
#[derive(Debug)]
pub(super) struct Dressed {
    pub family: String,
    pub mesh: Vec<MeshGroup>,
    pub lights: Vec<Light>,
}

impl Wardrobe {
    /// The index of a surface.
    pub fn add(&mut self, surface: Surface) -> usize {
        *self.known.entry(surface.name.clone()).or_insert_with(|| {
            self.surfaces.push(surface);
            self.surfaces.len() - 1
        })
    }

    /// The table.
    pub fn into_surfaces(self) -> Vec<Surface> {
        self.surfaces
    }

    /// The object as the library draws it at its size; `solid` is what the verifier judged.
    /// What was made elsewhere is drawn as it was made. What has no colour of its own stands out against the floor.
    pub fn furnish(
        &mut self,
        declared: &program::Object,
        place: &Placement,
        solid: &[Convex],
        own: Option<&Mesh>,
        floor: Option<&Surface>,
    ) -> Dressed {
        let mut asset = furnish(&AssetRequest {
            name: &declared.name,
            category: &declared.category,
            color: &declared.color,
            material: &declared.material,
            features: &declared.features,
            size: Some(place.scale),
        });
        if let Some(floor) = floor.filter(|_| declared.color.trim().is_empty()) {
            stand_out(&mut asset.mesh, floor.color);
        }
        if let Some(own) = own {
            let mesh = own.clone().unwrapped().groups.into_iter().map(|g| self.group(g)).collect();
            return Dressed { family: asset.family.to_owned(), mesh, lights: asset.lights };
        }
        let lights = asset.lights.clone();
        let drawn = !asset.mesh.groups.is_empty() && (place.parts.is_empty() || same_solid(&asset, solid));
        let mesh = if drawn {
            asset.mesh.groups.into_iter().map(|g| self.group(g)).collect()
        } else {
            // The layout has parts of its own: a picture of something else would not show what was verified.
            let surface = asset.mesh.groups.into_iter().next().map_or_else(Dresser::ground, |g| g.surface);
            let mut group = MeshGroup::new(self.add(surface));
            solid.iter().for_each(|body| group.solid(body));
            vec![group]
        };
        Dressed { family: asset.family.to_owned(), mesh, lights }
    }

    fn group(&mut self, from: scenelang_assets::MeshGroup) -> MeshGroup {
        MeshGroup {
            surface: self.add(from.surface),
            positions: from.positions,
            normals: from.normals,
            uvs: from.uvs,
            indices: from.indices,
        }
    }
}

/// Whether the parts of the asset are the bodies that were judged, with all their digits or with those of a layout file.
fn same_solid(asset: &Asset, solid: &[Convex]) -> bool {
    let near = |a: &Convex, b: &Convex| {
        a.vertices().len() == b.vertices().len()
            && a.vertices().iter().zip(b.vertices()).all(|(p, q)| (p - q).amax() <= SAME)
    };
    asset.parts.len() == solid.len()
        && asset.parts.iter().zip(solid).all(|(part, body)| {
            [part, &part.in_short()].into_iter().any(|part| Convex::from_part(part).is_some_and(|own| near(&own, body)))
        })
}

/// The surfaces of a region: what the program says, else what is usual.
pub(super) struct Dresser<'a> {
    region: &'a program::Region,
    kind: RegionKind,
}

impl<'a> Dresser<'a> {
    pub fn of(region: &'a program::Region, kind: RegionKind) -> Self {
        Self { region, kind }
    }

    pub fn floor(&self) -> Surface {
        let usual = match self.kind {
            RegionKind::Room => ("#cfb48f", "oak"),
            RegionKind::Zone => ("#b9c3c7", "carpet"),
            RegionKind::Outdoor => ("#93aa74", "carpet"),
        };
        // A region without walls means its floor when it says `color`.
        let own = |special, general| {
            let text = self.region.text(special);
            if text.is_empty() && self.kind != RegionKind::Room { self.region.text(general) } else { text }
        };
        let (color, material) = (own("floorColor", "color"), own("floorMaterial", "material"));
        let said = covering(color, material, usual.0, usual.1);
        // Of a colour that was asked for nothing is changed.
        let is_usual = material.trim().is_empty() || !color.trim().is_empty();
        on_floor(&if is_usual { said } else { toned(&said) })
    }

    pub fn wall(&self) -> Surface {
        let own = |special, general| {
            let text = self.region.text(special);
            if text.is_empty() { self.region.text(general) } else { text }
        };
        on_wall(&covering(own("wallColor", "color"), own("wallMaterial", "material"), "#efece4", "plaster"))
    }

    pub fn ceiling(&self) -> Surface {
        covering("", "", "#f7f6f2", "plaster")
    }

    /// Of the boards at the foot of the walls.
    pub fn skirting(&self) -> Option<Surface> {
        skirting(&self.floor(), &self.wall())
    }

    /// Of the ground where there is no region.
    pub fn ground() -> Surface {
        covering("", "", "#c9c8c2", "concrete")
    }
}
