//! Meshes as OBJ text. Places on materials are in metres; the materials know the size of their textures.
//!
//! Unity's importer negates x and turns triangles round, so that is how they are written. No `g` and `o` lines: then
//! the file holds one mesh, and each `usemtl` is one submesh in order of appearance.

use crate::geometry::mesh::MeshGroup;
use crate::obj::to_tenths;
use std::fmt::Write;

/// The file of some groups; `material` names the surface of a group.
pub(super) fn obj(groups: &[MeshGroup], material: impl Fn(usize) -> String) -> String {
    let mut out = String::from("# x is negated: importers that read OBJ into a left-handed frame negate it back\n");
    let mut first = 1;
    for group in groups {
        for [x, y, z] in &group.positions {
            let _ = writeln!(out, "v {} {} {}", 0.0 - x, y, z);
        }
        for [x, y, z] in &group.normals {
            let _ = writeln!(out, "vn {} {} {}", 0.0 - x, y, z);
        }
        for uv in &group.uvs {
            let [u, v] = uv.map(to_tenths);
            let _ = writeln!(out, "vt {u} {v}");
        }
        let _ = writeln!(out, "usemtl {}", material(group.surface));
        for t in group.indices.chunks_exact(3) {
            let [a, b, c] = [t[0], t[2], t[1]].map(|i| i + first);
            let _ = writeln!(out, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}");
        }
        first += group.positions.len() as u32;
    }
    out
}
