//! Regions as prisms: a floor polygon from the floor up to the ceiling, and what is inside it.

use crate::planar::Vec2;
use crate::polygon::{Clearance, NotSimple, Polygon};
use crate::{Obb, RegionPlacement, Vec3};

/// A region in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Prism {
    /// Its outline, world x and z.
    pub polygon: Polygon,
    /// Height of the floor.
    pub floor: f64,
    /// Height of the ceiling.
    pub ceiling: f64,
}

/// The three clearances of a box in a region, in metres, without tolerance; negative: outside by so much.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// From the walls.
    pub horizontal: Clearance,
    /// Of the lowest corner above the floor.
    pub floor: f64,
    /// Of the highest corner below the ceiling.
    pub ceiling: f64,
}

impl Inside {
    /// The least of the three.
    pub fn least(&self) -> f64 {
        self.horizontal.value.min(self.floor).min(self.ceiling)
    }
}

impl Prism {
    /// The prism of a placed region.
    ///
    /// # Errors
    /// Its vertices are no simple polygon.
    pub fn from_placement(region: &RegionPlacement) -> Result<Self, NotSimple> {
        let polygon = match &region.vertices {
            Some(vertices) => Polygon::new(vertices)?,
            None => Polygon::rectangle(
                Vec2::new(region.pos.x, region.pos.z),
                Vec2::new(region.scale.x, region.scale.z),
                region.rot.y,
            ),
        };
        Ok(Self { polygon, floor: region.pos.y, ceiling: region.pos.y + region.scale.y })
    }
    /// A cube of one metre over the origin.
    pub fn unit() -> Self {
        let polygon = Polygon::rectangle(Vec2::zeros(), Vec2::repeat(1.0), 0.0);
        Self { polygon, floor: 0.0, ceiling: 1.0 }
    }
    /// Square metres of floor.
    pub fn area(&self) -> f64 {
        self.polygon.area()
    }
    /// Centroid of the floor polygon, at half the height.
    pub fn center(&self) -> Vec3 {
        let c = self.polygon.centroid();
        Vec3::new(c.x, (self.floor + self.ceiling) / 2.0, c.y)
    }
}

/// How a box lies in a region.
pub fn inside_clearance(obb: &Obb, prism: &Prism) -> Inside {
    let span = obb.aabb();
    Inside {
        horizontal: prism.polygon.clearance(&obb.footprint()),
        floor: span.min.y - prism.floor,
        ceiling: prism.ceiling - span.max.y,
    }
}
