//! A model brought into the frame of the layout, in metres, with convex parts.

use crate::card::Card;
use crate::faults::{Fault, beyond, fault};
use crate::limits;
use crate::pieces::{THINNEST, take_apart};
use crate::raw::{Patch, Raw};
use nalgebra::Matrix3;
use scenelang_assets::{Mesh, MeshGroup};
use scenelang_base::codes;
use scenelang_layout::{Part, Vec3};

/// A model, ready to be placed. Frame and unit are those of the furniture library.
#[derive(Clone, Debug)]
pub struct CatalogueModel {
    /// The file, below the folder of the catalogue.
    pub file: String,
    /// What is known of it.
    pub card: Card,
    /// Extents w, h, d (metres).
    pub size: Vec3,
    /// What is seen.
    pub mesh: Mesh,
    /// Convex solids; their common box is that of the model.
    pub parts: Vec<Part>,
    /// How the file had it.
    pub origin: Origin,
}

/// How the file had a model, before it was put right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Origin {
    /// Height of its lowest point above the origin of the file (metres).
    pub base: f64,
    /// By how much the size on the card differs from that of the triangles, once they are scaled to it: the greatest ratio
    /// of two scales, 1 where there is no difference.
    pub distortion: f64,
    /// How many edges of triangles have nothing on their other side.
    pub open_edges: usize,
    /// How many pieces hang together by their edges.
    pub pieces: usize,
    /// The volume of the mesh where it is closed (m³).
    pub volume: Option<f64>,
    /// The volume of the hulls of its pieces (m³).
    pub filled: f64,
}

/// How a file's axes are to be understood.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axes {
    /// Those of glTF; the card may say that z is up.
    RightHanded,
    /// Those of the layout, as objathor has them.
    LeftHanded,
}

impl CatalogueModel {
    /// Brings triangles of a file into the frame of the layout. `parts`: the convex parts that the file has itself, in its
    /// own frame.
    pub(crate) fn new(file: &str, card: Card, mut raw: Raw, axes: Axes, parts: Vec<Part>) -> Result<Self, Fault> {
        let by = turn(&card, axes);
        raw.map(&by);
        let (lo, hi) = raw.bounds().ok_or_else(|| fault(codes::E0704, "it has no triangles"))?;
        let extents = hi - lo;
        if extents.max() == 0.0 {
            return Err(fault(codes::E0704, "all its triangles have zero area"));
        }
        let (scale, distortion) = scale(&extents, card.size);
        let shift = Vec3::new((lo.x + hi.x) / 2.0, lo.y, (lo.z + hi.z) / 2.0);
        let place = |p: Vec3| (p - shift) * scale;
        for patch in &mut raw.patches {
            patch.positions.iter_mut().for_each(|p| *p = place(*p));
        }
        let size = (extents * scale).map(|x| x.max(THINNEST));
        if size.max().is_nan() || size.max() > limits::EXTENT {
            return Err(beyond(format!(
                "its longest side is {:.0} m; the maximum is {} m",
                size.max(),
                limits::EXTENT
            )));
        }
        let triangles: Vec<[Vec3; 3]> = raw
            .patches
            .iter()
            .flat_map(|p| p.indices.as_chunks().0.iter().map(|t: &[u32; 3]| t.map(|i| p.positions[i as usize])))
            .collect();
        let body = take_apart(&triangles);
        if body.parts.is_empty() {
            return Err(fault(codes::E0704, "all its triangles have zero area"));
        }
        let own: Vec<Part> = parts.into_iter().map(|part| moved(part, &by, &place)).collect();
        Ok(Self {
            file: file.to_owned(),
            card,
            size,
            mesh: mesh(&raw.patches),
            origin: Origin {
                base: lo.y * scale,
                distortion,
                open_edges: body.open_edges,
                pieces: body.pieces,
                volume: body.volume,
                filled: body.filled,
            },
            parts: if own.is_empty() { body.parts } else { own },
        })
    }

    /// How many triangles it has.
    pub fn triangles(&self) -> usize {
        self.mesh.triangles()
    }
}

/// From the axes of the file to those of the layout: y up, front to +z, left-handed.
fn turn(card: &Card, axes: Axes) -> Matrix3<f64> {
    let degrees = card.front.unwrap_or(0.0);
    // Right angles exactly: a box stays one.
    let (sin, cos) = scenelang_layout::rotation::sin_cos(degrees);
    // The front is at (sin, 0, cos); this turns it to +z, in either frame.
    let front = Matrix3::new(cos, 0.0, -sin, 0.0, 1.0, 0.0, sin, 0.0, cos);
    match axes {
        Axes::LeftHanded => front,
        Axes::RightHanded => {
            let upright = if card.z_up {
                Matrix3::new(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0)
            } else {
                Matrix3::identity()
            };
            Matrix3::from_diagonal(&Vec3::new(-1.0, 1.0, 1.0)) * front * upright
        }
    }
}

/// By how much the numbers of the file are to be scaled, and how much the proportions on the card differ.
fn scale(extents: &Vec3, said: Option<Vec3>) -> (f64, f64) {
    let Some(said) = said else { return (1.0, 1.0) };
    let scale = said.max() / extents.max();
    // What is nearly flat has no proportions to speak of.
    let thick = |axis: &usize| extents[*axis] * scale > 10.0 * THINNEST || said[*axis] > 10.0 * THINNEST;
    let ratios: Vec<f64> = (0..3).filter(thick).map(|axis| said[axis] / extents[axis].max(1e-12)).collect();
    let (least, most) = ratios.iter().fold((f64::MAX, 0.0_f64), |(lo, hi), r| (lo.min(*r), hi.max(*r)));
    (scale, most / least)
}

/// A part of the file where the model is put.
fn moved(part: Part, by: &Matrix3<f64>, place: &impl Fn(Vec3) -> Vec3) -> Part {
    match part {
        Part::Hull { points } => Part::Hull { points: points.into_iter().map(|p| place(by * p)).collect() },
        other => other,
    }
}

/// One group for each surface, in the order of first use. Where there are no normals, each triangle is flat.
fn mesh(patches: &[Patch]) -> Mesh {
    let mut out = Mesh::default();
    for patch in patches {
        let known = out.groups.iter().position(|g| g.surface.name == patch.surface.name);
        let at = known.unwrap_or_else(|| {
            let surface = patch.surface.clone();
            let (positions, normals, uvs, indices) = Default::default();
            out.groups.push(MeshGroup { surface, positions, normals, uvs, indices });
            out.groups.len() - 1
        });
        add(&mut out.groups[at], patch);
    }
    out
}

fn add(group: &mut MeshGroup, patch: &Patch) {
    let narrow = |v: Vec3| [v.x as f32, v.y as f32, v.z as f32];
    let first = group.positions.len() as u32;
    if patch.normals.len() == patch.positions.len() {
        group.positions.extend(patch.positions.iter().map(|p| narrow(*p)));
        group.normals.extend(patch.normals.iter().map(|n| narrow(*n)));
        group.indices.extend(patch.indices.iter().map(|i| first + i));
        return;
    }
    for t in patch.indices.as_chunks::<3>().0 {
        let [a, b, c] = t.map(|i| patch.positions[i as usize]);
        let Some(normal) = (b - a).cross(&(c - a)).try_normalize(0.0) else { continue };
        let start = group.positions.len() as u32;
        group.positions.extend([a, b, c].map(narrow));
        group.normals.extend([narrow(normal); 3]);
        group.indices.extend([start, start + 1, start + 2]);
    }
}
