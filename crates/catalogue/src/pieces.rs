//! What a mesh is made of: its connected pieces, whether they are closed, and a convex part for each.

use crate::cut::cut;
use nalgebra::Vector3;
use rustc_hash::FxHashMap;
use scenelang_layout::convex::MAX_HULL_POINTS;
use scenelang_layout::{Aabb, Convex, Part, Vec3};

/// A model has at most so many parts; smaller pieces are joined to what is nearest.
const MOST: usize = 48;
/// A part that fills so much of its box is a box.
const BOX: f64 = 0.97;
/// Nothing is thinner (metres): a sheet has no volume.
pub(crate) const THINNEST: f64 = 0.001;
/// Of a piece with too many points, those that are farthest in so many directions.
const DIRECTIONS: usize = 128;

/// A closed piece is cut where it fills less than this share of its hull, and leaves more room in it than this (m³).
const CONVEX: f64 = 0.7;
const SPARE: f64 = 0.03;

/// Three corners, by index.
type Corners = [u32; 3];

/// A mesh taken apart.
#[derive(Debug)]
pub(crate) struct Body {
    /// Convex, and together as large as the mesh.
    pub parts: Vec<Part>,
    /// The volume of the hulls of the pieces, those that overlap counted twice (m³).
    pub filled: f64,
    /// How many edges do not have a triangle on either side.
    pub open_edges: usize,
    /// How many pieces hang together by their edges.
    pub pieces: usize,
    /// The volume of the mesh, where it is closed (m³).
    pub volume: Option<f64>,
}

/// Takes a mesh apart; its corners are in the frame of the object, with its triangles wound as the layout has them.
pub(crate) fn take_apart(triangles: &[[Vec3; 3]]) -> Body {
    let (points, corners) = weld(triangles);
    let (open_edges, pieces) = connect(&corners);
    let clouds: Vec<Vec<Vec3>> = pieces.iter().map(|piece| cloud(piece, &corners, &points)).collect();
    let whole = clouds.iter().flatten().copied();
    let whole = Aabb::of(whole);
    let signed: f64 = triangles.iter().map(|[a, b, c]| a.dot(&b.cross(c))).sum::<f64>() / 6.0;
    let parts_of = |clouds| -> Vec<Part> { joined(clouds).iter().map(|cloud| part(cloud, &whole)).collect() };
    let hulls = parts_of(clouds.clone());
    let filled = hulls.iter().filter_map(Convex::from_part).map(|c| volume(&c)).sum();
    let mut cuts = false;
    let mut cut_up = |(piece, cloud): (&Vec<u32>, Vec<Vec3>)| {
        let parts = if open_edges == 0 { hollow(piece, &corners, &points, &cloud, signed < 0.0) } else { None };
        cuts |= parts.is_some();
        parts.unwrap_or_else(|| vec![cloud])
    };
    let clouds: Vec<Vec<Vec3>> = pieces.iter().zip(clouds).flat_map(&mut cut_up).collect();
    Body {
        filled,
        parts: if cuts { parts_of(clouds) } else { hulls },
        open_edges,
        pieces: pieces.len(),
        volume: (open_edges == 0).then_some(signed.abs()),
    }
}

/// A piece with much room in its hull, cut into parts; `inward`: whether its triangles face inward.
fn hollow(piece: &[u32], corners: &[Corners], points: &[Vec3], cloud: &[Vec3], inward: bool) -> Option<Vec<Vec<Vec3>>> {
    let at = |&t: &u32| {
        let [a, b, c] = corners[t as usize].map(|i| points[i as usize]);
        if inward { [a, c, b] } else { [a, b, c] }
    };
    let triangles: Vec<[Vec3; 3]> = piece.iter().map(at).collect();
    let solid = triangles.iter().map(|[a, b, c]| a.dot(&b.cross(c))).sum::<f64>() / 6.0;
    let hull = volume(&Convex::from_hull(cloud)?);
    // A cavity in another piece is a piece of its own, and inside out.
    (solid > 0.0 && solid < CONVEX * hull && hull - solid > SPARE).then(|| cut(&triangles))?
}

/// Corners that are at the same place become one; triangles without an area go.
fn weld(triangles: &[[Vec3; 3]]) -> (Vec<Vec3>, Vec<Corners>) {
    let mut points = Vec::new();
    let mut known: FxHashMap<[u64; 3], u32> = FxHashMap::default();
    let mut corners = Vec::with_capacity(triangles.len());
    for triangle in triangles {
        let [a, b, c] = triangle.map(|p| {
            // Adding zero makes −0 the same as 0.
            let bits = [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits());
            *known.entry(bits).or_insert_with(|| {
                points.push(p);
                points.len() as u32 - 1
            })
        });
        if a != b && b != c && c != a {
            corners.push([a, b, c]);
        }
    }
    (points, corners)
}

/// How many edges are open, and the pieces: lists of triangles in the order of their first ones. Triangles hang together
/// where exactly two meet at an edge: of two boxes that touch along an edge, four do.
fn connect(corners: &[Corners]) -> (usize, Vec<Vec<u32>>) {
    /// How often an edge is run along in each direction, how many triangles have it, and the first two of them.
    #[derive(Default)]
    struct Side {
        balance: i64,
        count: usize,
        triangles: [u32; 2],
    }
    let mut sides: FxHashMap<[u32; 2], Side> = FxHashMap::default();
    for (t, &[a, b, c]) in corners.iter().enumerate() {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let side = sides.entry([from.min(to), from.max(to)]).or_default();
            side.balance += if from < to { 1 } else { -1 };
            if let Some(place) = side.triangles.get_mut(side.count) {
                *place = t as u32;
            }
            side.count += 1;
        }
    }
    let mut owner: Vec<u32> = (0..corners.len() as u32).collect();
    for side in sides.values().filter(|side| side.count == 2) {
        let [one, other] = side.triangles.map(|t| root(&mut owner, t));
        // The least one owns, so that the order of the edges does not matter.
        owner[one.max(other) as usize] = one.min(other);
    }
    let open: u64 = sides.values().map(|side| side.balance.unsigned_abs()).sum();
    let mut place: FxHashMap<u32, usize> = FxHashMap::default();
    let mut pieces: Vec<Vec<u32>> = Vec::new();
    for t in 0..corners.len() as u32 {
        let at = *place.entry(root(&mut owner, t)).or_insert_with(|| {
            pieces.push(Vec::new());
            pieces.len() - 1
        });
        pieces[at].push(t);
    }
    (open as usize, pieces)
}

fn root(owner: &mut [u32], mut at: u32) -> u32 {
    while owner[at as usize] != at {
        owner[at as usize] = owner[owner[at as usize] as usize];
        at = owner[at as usize];
    }
    at
}

/// The points of a piece, each once; of many, the outermost.
fn cloud(piece: &[u32], corners: &[Corners], points: &[Vec3]) -> Vec<Vec3> {
    let mut ids: Vec<u32> = piece.iter().flat_map(|&t| corners[t as usize]).collect();
    ids.sort_unstable();
    ids.dedup();
    outermost(ids.into_iter().map(|i| points[i as usize]).collect())
}

/// Not more points than a hull may have: along the axes, so that the box stays exact, and in directions spread evenly.
pub(crate) fn outermost(points: Vec<Vec3>) -> Vec<Vec3> {
    if points.len() <= MAX_HULL_POINTS {
        return points;
    }
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    let spread = (0..DIRECTIONS).map(|i| {
        let y = 1.0 - 2.0 * (i as f64 + 0.5) / DIRECTIONS as f64;
        let (sin, cos) = (golden * i as f64).sin_cos();
        let r = (1.0 - y * y).sqrt();
        Vec3::new(r * cos, y, r * sin)
    });
    let axes = [Vec3::x(), Vec3::y(), Vec3::z()].into_iter().flat_map(|axis| [axis, -axis]);
    let farthest = |d: Vec3| (0..points.len()).max_by(|&a, &b| points[a].dot(&d).total_cmp(&points[b].dot(&d)));
    let mut chosen: Vec<usize> = axes.chain(spread).filter_map(farthest).collect();
    chosen.sort_unstable();
    chosen.dedup();
    chosen.into_iter().map(|i| points[i]).collect()
}

/// Not more clouds than there may be parts: each small one is joined to the large one that is nearest.
fn joined(clouds: Vec<Vec<Vec3>>) -> Vec<Vec<Vec3>> {
    if clouds.len() <= MOST {
        return clouds;
    }
    let boxes: Vec<Aabb> = clouds.iter().map(|c| Aabb::of(c.iter().copied())).collect();
    let extent = |b: &Aabb| (b.max - b.min).norm();
    let mut order: Vec<usize> = (0..clouds.len()).collect();
    order.sort_by(|&a, &b| extent(&boxes[b]).total_cmp(&extent(&boxes[a])).then(a.cmp(&b)));
    let (large, small) = order.split_at(MOST);
    let mut out: Vec<Vec<Vec3>> = large.iter().map(|&i| clouds[i].clone()).collect();
    for &i in small {
        let apart = |j: usize| {
            let gap = |a: &Vec3, b: &Vec3| (a - b).sup(&Vector3::zeros());
            gap(&boxes[j].min, &boxes[i].max).norm() + gap(&boxes[i].min, &boxes[j].max).norm()
        };
        let nearest = (0..MOST).min_by(|&a, &b| apart(large[a]).total_cmp(&apart(large[b])));
        out[nearest.expect("there is more than one part")].extend_from_slice(&clouds[i]);
    }
    out.into_iter().map(outermost).collect()
}

/// A box where the hull is nearly one or has no volume, else the hull.
fn part(cloud: &[Vec3], whole: &Aabb) -> Part {
    let own = Aabb::of(cloud.iter().copied());
    let size = own.max - own.min;
    match Convex::from_hull(cloud).filter(|_| size.min() >= THINNEST) {
        Some(hull) if volume(&hull) < BOX * size.product() => Part::Hull { points: hull.vertices().to_vec() },
        _ => {
            // A sheet becomes a thin plate, within the box of the whole as far as that is thick enough.
            let mut center = (own.min + own.max) / 2.0;
            let size = size.map(|x| x.max(THINNEST));
            for axis in 0..3 {
                let room = [whole.min[axis] + size[axis] / 2.0, whole.max[axis] - size[axis] / 2.0];
                if room[0] <= room[1] {
                    center[axis] = center[axis].clamp(room[0], room[1]);
                } else {
                    // The whole is a sheet, too: it lies on its lower side.
                    center[axis] = if axis == 1 { room[0] } else { (whole.min[axis] + whole.max[axis]) / 2.0 };
                }
            }
            Part::Box { pos: center, size, rot: Vec3::zeros() }
        }
    }
}

/// The volume of a convex body (m³).
pub(crate) fn volume(body: &Convex) -> f64 {
    let pyramid = |face: &scenelang_layout::Face| {
        let corners: Vec<Vec3> = body.face_corners(face).collect();
        let area: Vec3 = (1..corners.len() - 1)
            .map(|i| (corners[i] - corners[0]).cross(&(corners[i + 1] - corners[0])))
            .fold(Vec3::zeros(), |sum, a| sum + a);
        area.dot(&face.normal).abs() * corners[0].dot(&face.normal) / 6.0
    };
    body.faces().iter().map(pyramid).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The twelve triangles of a box, outward by the right-hand rule.
    fn cuboid(lo: [f64; 3], hi: [f64; 3]) -> Vec<[Vec3; 3]> {
        let corner = |i: usize| {
            let pick = |axis: usize| if i >> axis & 1 == 1 { hi[axis] } else { lo[axis] };
            Vec3::new(pick(0), pick(1), pick(2))
        };
        let quads = [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]];
        quads.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).map(|t| t.map(corner)).collect()
    }

    #[test]
    fn two_boxes_are_two_parts() {
        let mut mesh = cuboid([0.0; 3], [1.0, 2.0, 3.0]);
        mesh.extend(cuboid([2.0, 0.0, 0.0], [3.0, 1.0, 1.0]));
        let body = take_apart(&mesh);
        assert_eq!((body.parts.len(), body.pieces, body.open_edges), (2, 2, 0));
        assert!(body.parts.iter().all(|p| matches!(p, Part::Box { .. })));
        assert!((body.volume.unwrap() - 7.0).abs() < 1e-9 && (body.filled - 7.0).abs() < 1e-9, "{body:?}");
    }

    #[test]
    fn a_box_without_a_side_is_open_and_a_sheet_has_a_part() {
        let mesh = &cuboid([0.0; 3], [1.0; 3])[2..];
        let body = take_apart(mesh);
        assert_eq!((body.open_edges, body.volume), (4, None));
        let sheet = vec![[Vec3::zeros(), Vec3::z(), Vec3::x()]];
        let body = take_apart(&sheet);
        assert_eq!(
            body.parts,
            [Part::Box { pos: Vec3::new(0.5, 0.0005, 0.5), size: Vec3::new(1.0, 0.001, 1.0), rot: Vec3::zeros() }]
        );
    }

    #[test]
    fn many_small_pieces_are_joined_to_large_ones() {
        let mut mesh = cuboid([0.0; 3], [1.0; 3]);
        for i in 0..200 {
            let x = 0.005 * f64::from(i);
            mesh.extend(cuboid([x, 1.0, 0.0], [x + 0.002, 1.01, 0.01]));
        }
        let body = take_apart(&mesh);
        assert_eq!((body.parts.len(), body.pieces), (MOST, 201));
        let boxes = body.parts.iter().filter_map(Convex::from_part).map(|c| *c.aabb());
        let (lo, hi) =
            boxes.fold((Vec3::repeat(9.0), Vec3::repeat(-9.0)), |(lo, hi), b| (lo.inf(&b.min), hi.sup(&b.max)));
        assert!((hi - lo - Vec3::new(1.0, 1.01, 1.0)).amax() < 1e-9, "{lo} {hi}");
    }
}
