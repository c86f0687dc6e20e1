//! A closed piece that is far from convex, cut into parts by planes along the axes.
//!
//! Each step takes the part with the most room in its hull, and cuts it where the boxes of the two sides have the least room
//! left; of equal ones, where more of it fills its box. The hulls together hold the whole piece: those of the two sides of a cut hold all of the
//! surface on their side. Furniture is made along its axes, so few cuts do: a table becomes its top and its legs. V-HACD
//! (`parry3d` has it) works on voxels; its parts round off edges, and it panics on what is degenerate.

use crate::pieces::{outermost, volume};
use scenelang_layout::{Convex, Vec3};

/// A piece becomes at most so many parts.
const PARTS: usize = 12;
/// Pieces with more triangles are not cut: that would take long.
const TRIANGLES: usize = 5_000;
/// So many places are tried along an axis at each step.
const PLACES: usize = 8;
/// A part with less room in its hull, as a share of the hull of the whole piece, is convex enough.
const ROOM: f64 = 0.02;
/// How much it counts that a side is not convex yet.
const OPEN: f64 = 0.1;
/// A cut that leaves more than this share of what there was to do is none. The top of a table is thin.
const HELPS: f64 = 0.9995;
/// What is nearer than this to a plane is on it, and places nearer than this are one (as a share of the extent).
const NEAR: f64 = 1e-6;
const APART: f64 = 1e-3;

type Face = Vec<Vec3>;
/// Faces of one side of a plane, and what closes it.
type Side = (Vec<Face>, Vec<Face>);

/// What is on one side of all cuts so far.
#[derive(Clone, Debug, Default)]
struct Region {
    /// The surface of the piece.
    faces: Vec<Face>,
    /// Closes it along the cuts, as far as its volume goes: fans of triangles that may lie over each other, with a sign.
    caps: Vec<Face>,
    cloud: Vec<Vec3>,
    /// The volume of the hull.
    hull: f64,
    /// The volume of the hull beyond that of the solid.
    room: f64,
}

/// The clouds of points whose hulls are the parts of a closed piece, with its triangles outward; `None` where it cannot be cut
/// in a way that helps.
pub(crate) fn cut(triangles: &[[Vec3; 3]]) -> Option<Vec<Vec<Vec3>>> {
    if triangles.len() > TRIANGLES {
        return None;
    }
    let whole = Region::of(triangles.iter().map(|t| t.to_vec()).collect(), Vec::new())?;
    let enough = ROOM * whole.hull;
    let mut open = vec![whole];
    let mut done: Vec<Region> = Vec::new();
    while open.len() + done.len() < PARTS {
        let most = (0..open.len()).max_by(|&a, &b| open[a].room.total_cmp(&open[b].room).then(b.cmp(&a)));
        let Some(region) = most.map(|at| open.remove(at)) else { break };
        match best(&region, enough).filter(|_| region.room > enough) {
            Some(sides) => open.extend(sides),
            None => done.push(region),
        }
    }
    done.extend(open);
    (done.len() > 1).then(|| done.into_iter().map(|region| region.cloud).collect())
}

impl Region {
    fn of(faces: Vec<Face>, caps: Vec<Face>) -> Option<Self> {
        let cloud = outermost(distinct(faces.iter().flatten().copied()));
        let hull = volume(&Convex::from_hull(&cloud)?);
        let room = hull - faces.iter().chain(&caps).map(|face| signed(face)).sum::<f64>();
        (hull.is_finite() && room.is_finite()).then_some(Self { faces, caps, cloud, hull, room })
    }

    /// How far it is from being done.
    fn cost(&self, enough: f64) -> f64 {
        cost(self.room, self.hull, enough)
    }

    /// Its two sides of a plane: faces and caps.
    fn split(&self, axis: usize, at: f64, near: f64) -> [Side; 2] {
        let corner = self.cloud.iter().fold(Vec3::repeat(f64::MAX), |lo, p| lo.inf(p));
        let mut middle = corner;
        middle[axis] = at;
        let mut sides = [(Vec::new(), Vec::new()), (Vec::new(), Vec::new())];
        for (cap, face) in self.faces.iter().map(|f| (false, f)).chain(self.caps.iter().map(|f| (true, f))) {
            let on = |p: &Vec3| {
                let mut p = *p;
                if (p[axis] - at).abs() <= near {
                    p[axis] = at;
                }
                p
            };
            let face: Face = face.iter().map(on).collect();
            for (side, (faces, caps)) in sides.iter_mut().enumerate() {
                let sign = if side == 0 { -1.0 } else { 1.0 };
                let Some(kept) = clipped(&face, axis, at, sign) else { continue };
                for (a, b) in kept.iter().zip(kept.iter().cycle().skip(1)) {
                    if a[axis] == at && b[axis] == at {
                        caps.push(vec![middle, *b, *a]);
                    }
                }
                if cap { caps.push(kept) } else { faces.push(kept) }
            }
        }
        sides
    }
}

/// How far something is from being done, with so much room in what is around it.
fn cost(room: f64, around: f64, enough: f64) -> f64 {
    room.max(0.0) + if room > enough { OPEN * around } else { 0.0 }
}

/// The same of a side by its box, which is found quickly; `None` where there is nothing.
fn roughly((faces, caps): &Side, enough: f64) -> Option<f64> {
    let first = *faces.first()?.first()?;
    let (lo, hi) = faces.iter().flatten().fold((first, first), |(lo, hi), p| (lo.inf(p), hi.sup(p)));
    let around = (hi - lo).product();
    let solid = faces.iter().chain(caps).map(|face| signed(face)).sum::<f64>();
    Some(cost(around - solid, around, enough))
}

/// The best cut, if there is one that helps.
fn best(region: &Region, enough: f64) -> Option<[Region; 2]> {
    let mut found: Option<(f64, [Side; 2])> = None;
    for axis in [1, 0, 2] {
        let mut places: Vec<f64> = region.faces.iter().flatten().map(|p| p[axis]).collect();
        places.sort_by(f64::total_cmp);
        let extent = places.last()? - places.first()?;
        places.dedup_by(|b, a| *b - *a < APART * extent);
        let between: Vec<f64> = places.windows(2).map(|w| f64::midpoint(w[0], w[1])).collect();
        let mut all: Vec<f64> = places.iter().skip(1).take(places.len().saturating_sub(2)).copied().collect();
        all.extend(between);
        all.sort_by(f64::total_cmp);
        let step = all.len().div_ceil(PLACES).max(1);
        for at in all.into_iter().skip(step / 2).step_by(step) {
            let sides = region.split(axis, at, NEAR * extent);
            let both: Option<f64> = sides.iter().map(|side| roughly(side, enough)).sum();
            let Some(cost) = both else { continue };
            // What differs by rounding only is equal, so that the first one counts.
            if found.as_ref().is_none_or(|(least, _)| cost < least - 1e-9 * region.hull) {
                found = Some((cost, sides));
            }
        }
    }
    let (_, [(low, low_caps), (high, high_caps)]) = found?;
    let sides = [Region::of(low, low_caps)?, Region::of(high, high_caps)?];
    let cost = sides.iter().map(|side| side.cost(enough)).sum::<f64>();
    (cost < HELPS * region.cost(enough)).then_some(sides)
}

/// What of a convex face is on one side of a plane; a face in the plane belongs to the side where the solid is.
fn clipped(face: &[Vec3], axis: usize, at: f64, sign: f64) -> Option<Face> {
    let over = |p: &Vec3| sign * (p[axis] - at);
    if face.iter().all(|p| p[axis] == at) {
        // Outward is away from the solid.
        return (sign * normal(face)[axis] < 0.0).then(|| face.to_vec());
    }
    if !face.iter().any(|p| over(p) > 0.0) {
        return None;
    }
    let mut out = Vec::with_capacity(face.len() + 2);
    for (a, b) in face.iter().zip(face.iter().cycle().skip(1)) {
        let (x, y) = (over(a), over(b));
        if x >= 0.0 {
            out.push(*a);
        }
        if x * y < 0.0 {
            let mut cut = a + (b - a) * (x / (x - y));
            cut[axis] = at;
            out.push(cut);
        }
    }
    Some(out)
}

/// Twice the area of a face, as a vector along its normal.
fn normal(face: &[Vec3]) -> Vec3 {
    (1..face.len().saturating_sub(1)).map(|i| (face[i] - face[0]).cross(&(face[i + 1] - face[0]))).sum()
}

/// The volume between a face and the origin, with a sign.
fn signed(face: &[Vec3]) -> f64 {
    (1..face.len().saturating_sub(1)).map(|i| face[0].dot(&face[i].cross(&face[i + 1]))).sum::<f64>() / 6.0
}

/// The points, each once, in the order of their coordinates.
fn distinct(points: impl Iterator<Item = Vec3>) -> Vec<Vec3> {
    let mut points: Vec<Vec3> = points.collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
    points.dedup();
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A closed mesh over cells of a grid: what is between them is not drawn.
    fn cells(solid: &[[i32; 3]]) -> Vec<[Vec3; 3]> {
        let mut out = Vec::new();
        for &[x, y, z] in solid {
            for axis in 0..3 {
                for side in [-1, 1] {
                    let mut next = [x, y, z];
                    next[axis] += side;
                    if solid.contains(&next) {
                        continue;
                    }
                    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
                    let corner = |a: i32, b: i32| {
                        let mut p = [f64::from(x), f64::from(y), f64::from(z)];
                        p[axis] += f64::from((side + 1) / 2);
                        p[u] += f64::from(a);
                        p[v] += f64::from(b);
                        Vec3::from(p)
                    };
                    let quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    let quad = if side > 0 { quad } else { [quad[3], quad[2], quad[1], quad[0]] };
                    out.extend([[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]);
                }
            }
        }
        out
    }

    /// How many parts, and the volume of their hulls.
    fn told(solid: &[[i32; 3]]) -> Option<(usize, f64)> {
        let parts = cut(&cells(solid))?;
        let volume = parts.iter().map(|cloud| volume(&Convex::from_hull(cloud).unwrap())).sum::<f64>();
        Some((parts.len(), (volume * 1e6).round() / 1e6))
    }

    #[test]
    fn a_table_is_a_top_and_legs() {
        let mut table: Vec<[i32; 3]> = (0..5).flat_map(|x| (0..4).map(move |z| [x, 3, z])).collect();
        let legs = [[0, 0], [4, 0], [0, 3], [4, 3]];
        table.extend(legs.iter().flat_map(|[x, z]| (0..3).map(move |y| [*x, y, *z])));
        assert_eq!(told(&table), Some((5, 32.0)));
        // Whatever the numbers are, and however it is turned.
        let turned: Vec<[i32; 3]> = table.iter().map(|[x, y, z]| [-z - 7, *x, 40 - y]).collect();
        assert_eq!(told(&turned), Some((5, 32.0)));
    }

    #[test]
    fn an_angle_is_two_parts_and_a_block_is_not_cut() {
        let angle: Vec<[i32; 3]> = (0..4).map(|x| [x, 0, 0]).chain((1..4).map(|y| [0, y, 0])).collect();
        assert_eq!(told(&angle), Some((2, 7.0)));
        assert_eq!(told(&[[0, 0, 0], [1, 0, 0]]), None);
        assert_eq!(cut(&[]), None);
    }

    #[test]
    fn what_is_cut_is_covered() {
        // A shelf with a back, and a step before it.
        let mut shelf: Vec<[i32; 3]> = (0..6).flat_map(|y| (0..4).map(move |x| [x, y, 0])).collect();
        shelf.extend([0, 3, 5].iter().flat_map(|y| (0..4).flat_map(move |x| [[x, *y, 1], [x, *y, 2]])));
        shelf.push([0, 0, 3]);
        let mesh = cells(&shelf);
        let parts: Vec<Convex> = cut(&mesh).unwrap().iter().map(|cloud| Convex::from_hull(cloud).unwrap()).collect();
        let inside = |p: &Vec3| {
            parts.iter().any(|part| {
                part.faces().iter().all(|f| {
                    let corner = part.face_corners(f).next().unwrap();
                    f.normal.dot(&(p - corner)) < 1e-6
                })
            })
        };
        for [a, b, c] in &mesh {
            assert!(inside(&((a + b + c) / 3.0)) && inside(a), "{a} {b} {c}");
        }
    }
}
