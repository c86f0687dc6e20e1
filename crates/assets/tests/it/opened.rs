//! Furniture with all its doors and drawers open: what is seen then has no two faces in one plane either.

use crate::geometry::{bounds, corners};
use crate::looks::{SEEN, all, fighting, report};
use scenelang_assets::Asset;
use scenelang_layout::{Joint, Motion, Vec3};

/// A triangle belongs to a part whose box it is no farther out of than this, as in the exported files (metres).
const NEAR: f64 = 0.002;

/// Where a joint takes a point when it is opened as far as is of use.
fn moved(joint: &Joint, p: Vec3) -> Vec3 {
    let amount = joint.useful.unwrap_or(joint.limits[1]);
    let axis = joint.axis.normalize();
    match joint.motion {
        Motion::Slide => p + axis * amount,
        // Rodrigues' formula.
        Motion::Hinge => {
            let ((sin, cos), from) = (amount.to_radians().sin_cos(), p - joint.anchor);
            joint.anchor + from * cos + axis.cross(&from) * sin + axis * (axis.dot(&from) * (1.0 - cos))
        }
    }
}

/// The same furniture, open.
fn opened(asset: &Asset) -> Asset {
    let boxes: Vec<(Vec3, Vec3)> = asset.parts.iter().map(|part| bounds(corners(part))).collect();
    let volume = |part: usize| (boxes[part].1 - boxes[part].0).product();
    let part_of = |points: &[Vec3; 3]| {
        let about = |part: &usize| {
            let (lo, hi) = boxes[*part];
            points.iter().all(|p| (0..3).all(|i| (lo[i] - NEAR..=hi[i] + NEAR).contains(&p[i])))
        };
        (0..boxes.len()).filter(about).min_by(|a, b| f64::total_cmp(&volume(*a), &volume(*b)))
    };
    let mut open = asset.clone();
    for group in &mut open.mesh.groups {
        // A triangle of its own for each, since its neighbours may stay.
        let indices = std::mem::take(&mut group.indices);
        let before = std::mem::replace(group, scenelang_assets::MeshGroup { indices: Vec::new(), ..group.clone() });
        (group.positions, group.normals, group.uvs) = (Vec::new(), Vec::new(), Vec::new());
        for t in indices.chunks_exact(3) {
            let points = [t[0], t[1], t[2]].map(|i| Vec3::from(before.positions[i as usize].map(f64::from)));
            let joint = part_of(&points).and_then(|part| asset.joints.iter().find(|j| j.parts.contains(&part)));
            for (i, p) in t.iter().zip(points) {
                let to = joint.map_or(p, |joint| moved(joint, p));
                group.indices.push(group.positions.len() as u32);
                group.positions.push([to.x as f32, to.y as f32, to.z as f32]);
                group.normals.push(before.normals[*i as usize]);
            }
        }
    }
    open
}

#[test]
fn no_two_faces_are_seen_in_one_plane_when_all_is_open() {
    let mut bad = Vec::new();
    let mut count = 0;
    for (name, asset) in all().filter(|(_, asset)| !asset.joints.is_empty()) {
        let (area, place) = fighting(&opened(&asset));
        count += 1;
        if area > SEEN {
            bad.push(format!("{name}: {area:.4} m² of {place}"));
        }
    }
    assert!(count > 100, "{count} pieces of furniture open");
    report(&bad);
}
