//! Tangents: which way the first axis of a material runs over a surface, at each corner.

use super::mesh::MeshGroup;
use scenelang_layout::Vec3;

/// For each corner of a group the direction of u across its normal, and on which side v is: 1 where normal × tangent (the
/// usual formula) is along v, else −1.
pub fn tangents(group: &MeshGroup) -> Vec<([f32; 3], f32)> {
    let wide = |v: [f32; 3]| Vec3::from(v.map(f64::from));
    let mut ways = vec![(Vec3::zeros(), Vec3::zeros()); group.positions.len()];
    for t in group.indices.chunks_exact(3) {
        let t = [t[0] as usize, t[1] as usize, t[2] as usize];
        let [a, b, c] = t.map(|i| wide(group.positions[i]));
        let [p, q, r] = t.map(|i| group.uvs[i].map(f64::from));
        let (ab, ac) = (b - a, c - a);
        let normal = ab.cross(&ac);
        // Perpendicular to the other side: what changes along one side only.
        let (to_b, to_c) = (ac.cross(&normal), normal.cross(&ab));
        let way = |k: usize| to_b * (q[k] - p[k]) + to_c * (r[k] - p[k]);
        let area = normal.norm().max(1e-12);
        for i in t {
            ways[i].0 += way(0) / area;
            ways[i].1 += way(1) / area;
        }
    }
    let normals = group.normals.iter().map(|n| wide(*n));
    ways.into_iter()
        .zip(normals)
        .map(|((u, v), normal)| {
            let across = |way: Vec3| (way - normal * normal.dot(&way)).try_normalize(1e-9);
            let tangent = across(u).or_else(|| across(Vec3::x())).or_else(|| across(Vec3::y())).unwrap_or_else(Vec3::z);
            let side = if normal.cross(&tangent).dot(&v) < 0.0 { -1.0 } else { 1.0 };
            ([tangent.x as f32, tangent.y as f32, tangent.z as f32], side)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_run_along_u_and_v_is_on_their_side() {
        let mut group = MeshGroup::new(0);
        let outline = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(scenelang_layout::Vec2::from);
        group.prism(&outline, 0.0, 1.0);
        let found = tangents(&group);
        for t in group.indices.chunks_exact(3) {
            let [a, b, c] = [t[0], t[1], t[2]].map(|i| i as usize);
            let along = |from: usize, to: usize| {
                let d = Vec3::from_fn(|i, _| f64::from(group.positions[to][i] - group.positions[from][i]));
                let normal = Vec3::from(group.normals[from].map(f64::from));
                let tangent = Vec3::from(found[from].0.map(f64::from));
                let other = normal.cross(&tangent) * f64::from(found[from].1);
                [d.dot(&tangent), d.dot(&other)]
            };
            for (from, to) in [(a, b), (b, c), (c, a)] {
                for (k, moved) in along(from, to).into_iter().enumerate() {
                    let want = f64::from(group.uvs[to][k] - group.uvs[from][k]);
                    assert!((moved - want).abs() < 1e-6, "{k}: {moved} is not {want}");
                }
            }
        }
    }
}
