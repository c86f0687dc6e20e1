//! OBJ files, with the colours of their MTL files. Such a file has no unit and no front; axes are taken as those of GLB
//! files (right-handed, y up, front to +z), and numbers as metres, unless a card says otherwise.

use crate::faults::{Fault, broken, unreadable};
use crate::raw::{Patch, Raw, plain_surface, surface};
use scenelang_assets::Surface;
use scenelang_base::door::{Door, outside};
use scenelang_layout::Vec3;
use std::cell::RefCell;
use std::path::Path;

/// The triangles of an OBJ file in `folder`.
pub(crate) fn read(bytes: &[u8], folder: &Path, door: &Door) -> Result<Raw, Fault> {
    let options = tobj::LoadOptions { triangulate: true, single_index: true, ignore_points: true, ignore_lines: true };
    let refused = RefCell::new(None);
    let materials = |name: &Path| match door.read(&folder.join(name)) {
        Ok(bytes) => tobj::load_mtl_buf(&mut bytes.as_slice()),
        Err(e) => {
            if outside(&e).is_some() {
                *refused.borrow_mut() = Some(unreadable(&e));
            }
            // Without its colours it is grey.
            Err(tobj::LoadError::OpenFileFailed)
        }
    };
    let (models, materials) = tobj::load_obj_buf(&mut &*bytes, &options, materials)
        .map_err(|e| broken(format!("it is not a valid OBJ file: {e}")))?;
    if let Some(refused) = refused.into_inner() {
        return Err(refused);
    }
    let surfaces: Vec<Surface> = materials.unwrap_or_default().iter().map(look).collect();
    let mut raw = Raw::default();
    for mesh in models.into_iter().map(|m| m.mesh) {
        let triples = |numbers: &[f32]| -> Vec<Vec3> {
            numbers.as_chunks().0.iter().map(|p: &[f32; 3]| Vec3::from(p.map(f64::from))).collect()
        };
        let positions = triples(&mesh.positions);
        let normals = Some(triples(&mesh.normals)).filter(|n| n.len() == positions.len()).unwrap_or_default();
        let surface = mesh.material_id.and_then(|m| surfaces.get(m)).cloned().unwrap_or_else(plain_surface);
        raw.add(Patch { surface, positions, normals, indices: mesh.indices })?;
    }
    Ok(raw)
}

/// What a material looks like. Shininess (`Ns`) goes to about a thousand.
fn look(material: &tobj::Material) -> Surface {
    let color = material.diffuse.unwrap_or([0.8; 3]);
    let shine = material.shininess.filter(|s| s.is_finite()).unwrap_or(50.0).clamp(0.0, 1000.0);
    let opacity = material.dissolve.filter(|d| d.is_finite()).unwrap_or(1.0);
    surface(color, opacity, 1.0 - (shine / 1000.0).sqrt(), 0.0, material.emissive.unwrap_or_default())
}
