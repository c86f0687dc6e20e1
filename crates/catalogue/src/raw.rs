//! What the readers of formats give: triangles in the frame of the file.

use crate::faults::{Fault, beyond, broken};
use crate::limits;
use nalgebra::{Matrix3, Matrix4};
use scenelang_assets::Surface;
use scenelang_layout::Vec3;

/// The triangles of one surface, in the frame and unit of the file.
#[derive(Clone, Debug)]
pub(crate) struct Patch {
    pub surface: Surface,
    pub positions: Vec<Vec3>,
    /// One per vertex, or none at all.
    pub normals: Vec<Vec3>,
    /// Three per triangle; each is the index of a position.
    pub indices: Vec<u32>,
}

/// All of a file. Normals by the right-hand rule point outward.
#[derive(Clone, Debug, Default)]
pub(crate) struct Raw {
    pub patches: Vec<Patch>,
}

impl Raw {
    /// How many triangles there are.
    pub fn triangles(&self) -> usize {
        self.patches.iter().map(|p| p.indices.len() / 3).sum()
    }

    /// Adds a patch.
    ///
    /// # Errors
    /// Numbers that are not finite, points that are too far away, indices without a point, too many triangles.
    pub fn add(&mut self, patch: Patch) -> Result<(), Fault> {
        if patch.positions.iter().flat_map(|p| p.iter()).any(|x| !x.is_finite()) {
            return Err(broken("it has a vertex whose coordinates are not finite"));
        }
        if let Some(p) = patch.positions.iter().find(|p| p.amax() > limits::EXTENT) {
            let far = p.amax();
            return Err(beyond(format!("a vertex is {far:.1e} from the origin; the maximum is {}", limits::EXTENT)));
        }
        if patch.indices.iter().any(|&i| i as usize >= patch.positions.len()) {
            return Err(broken(format!(
                "a triangle has a corner that is not one of the {} vertices",
                patch.positions.len()
            )));
        }
        self.patches.push(patch);
        if self.triangles() > limits::TRIANGLES {
            return Err(beyond(format!("it has more than {} triangles", limits::TRIANGLES)));
        }
        Ok(())
    }

    /// Least and greatest corner of what the triangles touch; `None` without triangles.
    pub fn bounds(&self) -> Option<(Vec3, Vec3)> {
        let mut points = self.patches.iter().flat_map(|p| p.indices.iter().map(|&i| p.positions[i as usize]));
        let first = points.next()?;
        Some(points.fold((first, first), |(lo, hi), p| (lo.inf(&p), hi.sup(&p))))
    }

    /// The same after a linear map; triangles are turned round where it mirrors.
    pub fn map(&mut self, by: &Matrix3<f64>) {
        let mirrors = by.determinant() < 0.0;
        for patch in &mut self.patches {
            patch.positions.iter_mut().for_each(|p| *p = by * *p);
            turn_normals(&mut patch.normals, by);
            if mirrors {
                patch.indices.chunks_exact_mut(3).for_each(|t| t.swap(1, 2));
            }
        }
    }
}

impl Patch {
    /// The same where a node puts it.
    pub fn placed(mut self, by: &Matrix4<f64>) -> Self {
        let linear: Matrix3<f64> = by.fixed_view::<3, 3>(0, 0).into();
        let shift: Vec3 = by.fixed_view::<3, 1>(0, 3).into();
        self.positions.iter_mut().for_each(|p| *p = linear * *p + shift);
        turn_normals(&mut self.normals, &linear);
        if linear.determinant() < 0.0 {
            self.indices.chunks_exact_mut(3).for_each(|t| t.swap(1, 2));
        }
        self
    }
}

/// Normals after a linear map: by its inverse transpose; where it has none, or where they are no directions, there are
/// none any more.
fn turn_normals(normals: &mut Vec<Vec3>, by: &Matrix3<f64>) {
    let Some(inverse) = by.try_inverse() else { return normals.clear() };
    let turn = inverse.transpose();
    for n in normals.iter_mut() {
        match (turn * *n).try_normalize(1e-12).filter(|n| n.iter().all(|x| x.is_finite())) {
            Some(turned) => *n = turned,
            None => return normals.clear(),
        }
    }
}

/// A surface of a plain colour. Equal looks have equal names, over all models.
pub(crate) fn surface(color: [f32; 3], opacity: f32, roughness: f32, metallic: f32, emissive: [f32; 3]) -> Surface {
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let ([r, g, b], [o, rough, metal]) = (color.map(byte), [opacity, roughness, metallic].map(byte));
    let glow = emissive.map(byte);
    let back = |x: u8| f32::from(x) / 255.0;
    let glows = glow != [0; 3];
    let shine = if glows { format!("-{:02x}{:02x}{:02x}", glow[0], glow[1], glow[2]) } else { String::new() };
    Surface {
        name: format!("own-{r:02x}{g:02x}{b:02x}-{o:02x}{rough:02x}{metal:02x}{shine}"),
        color: [r, g, b].map(back),
        roughness: back(rough),
        metallic: back(metal),
        emissive: glows.then(|| glow.map(back)),
        opacity: back(o),
    }
}

/// A surface about which the file says nothing.
pub(crate) fn plain_surface() -> Surface {
    surface([0.8; 3], 1.0, 0.7, 0.0, [0.0; 3])
}
