//! Convex solids as lists of corners and faces, and the signed gap between two, by trying everything.

use super::space::{M, V, add, apply, cross, distance, dot, length, sub, times};

/// A convex polyhedron in world coordinates.
#[derive(Clone, Debug)]
pub struct Solid {
    pub corners: Vec<V>,
    /// Corners of each face, in order around it.
    pub faces: Vec<Vec<usize>>,
}

impl Solid {
    /// A box with its centre at the origin.
    pub fn cuboid(size: V) -> Self {
        let corners = (0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 1 { size[k] / 2.0 } else { -size[k] / 2.0 }));
        let faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
        Self { corners: corners.collect(), faces: faces.map(|f| f.to_vec()).to_vec() }
    }
    /// A regular prism of 24 sides, a corner on +x, its centre at the origin.
    pub fn cylinder(radius: f64, height: f64) -> Self {
        let n = 24;
        let at = |i: usize| (i as f64 * 360.0 / n as f64).to_radians();
        let ring = |y: f64| (0..n).map(move |i| [radius * at(i).cos(), y, radius * at(i).sin()]);
        let corners = ring(-height / 2.0).chain(ring(height / 2.0)).collect();
        let mut faces: Vec<Vec<usize>> = (0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]).collect();
        faces.extend([(0..n).collect(), (n..2 * n).collect()]);
        Self { corners, faces }
    }
    /// The hull of a few points: every plane through three of them that has all others on one side.
    pub fn hull(points: &[V]) -> Self {
        let n = points.len();
        let mut faces: Vec<Vec<usize>> = Vec::new();
        for i in 0..n {
            for j in i + 1..n {
                for k in j + 1..n {
                    let normal = cross(sub(points[j], points[i]), sub(points[k], points[i]));
                    let size = length(normal);
                    if size < 1e-9 {
                        continue;
                    }
                    let normal = times(normal, 1.0 / size);
                    let off: Vec<f64> = points.iter().map(|p| dot(sub(*p, points[i]), normal)).collect();
                    if off.iter().any(|d| *d > 1e-9) && off.iter().any(|d| *d < -1e-9) {
                        continue;
                    }
                    let face: Vec<usize> = (0..n).filter(|p| off[*p].abs() <= 1e-9).collect();
                    let face = around(points, face, normal);
                    let same = |f: &Vec<usize>| f.len() == face.len() && f.iter().all(|p| face.contains(p));
                    if !faces.iter().any(same) {
                        faces.push(face);
                    }
                }
            }
        }
        Self { corners: points.to_vec(), faces }
    }
    /// Turned, then moved.
    pub fn placed(mut self, turned: &M, at: V) -> Self {
        for corner in &mut self.corners {
            *corner = add(apply(turned, *corner), at);
        }
        self
    }
    fn middle(&self) -> V {
        let sum = self.corners.iter().fold([0.0; 3], |sum, c| add(sum, *c));
        times(sum, 1.0 / self.corners.len() as f64)
    }
    /// Outward, a unit vector.
    pub fn normal(&self, face: &[usize]) -> V {
        // Newell's sum: no three corners need to be far apart.
        let points: Vec<V> = face.iter().map(|i| self.corners[*i]).collect();
        let sum = (0..points.len()).fold([0.0; 3], |sum, i| {
            add(sum, cross(sub(points[i], points[0]), sub(points[(i + 1) % points.len()], points[0])))
        });
        let normal = times(sum, 1.0 / length(sum));
        if dot(sub(points[0], self.middle()), normal) < 0.0 { times(normal, -1.0) } else { normal }
    }
    /// Degrees between the outside of a face and straight up.
    pub fn tilt(&self, face: &[usize]) -> f64 {
        super::space::angle(self.normal(face), [0.0, 1.0, 0.0])
    }
    /// Corners of what of it is not higher than a height.
    pub fn below(&self, height: f64) -> Vec<V> {
        let mut corners: Vec<V> = self.corners.iter().copied().filter(|c| c[1] <= height).collect();
        corners.extend(self.edges().iter().filter_map(|edge| through(*edge, height)));
        corners
    }
    /// What of it is not lower than a height; `None`: nothing, or next to nothing.
    pub fn above(&self, height: f64) -> Option<Self> {
        let mut corners: Vec<V> = self.corners.iter().copied().filter(|c| c[1] >= height).collect();
        if corners.len() == self.corners.len() {
            return Some(self.clone());
        }
        corners.extend(self.edges().iter().filter_map(|edge| through(*edge, height)));
        let highest = corners.iter().map(|c| c[1]).fold(height, f64::max);
        (highest > height + 1e-6).then(|| Self::hull(&corners)).filter(|s| s.faces.len() > 3)
    }
    fn edges(&self) -> Vec<(V, V)> {
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        for face in &self.faces {
            for i in 0..face.len() {
                let (a, b) = (face[i], face[(i + 1) % face.len()]);
                pairs.push((a.min(b), a.max(b)));
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        pairs.into_iter().map(|(a, b)| (self.corners[a], self.corners[b])).collect()
    }
    fn reach(&self, along: V) -> (f64, f64) {
        let all = self.corners.iter().map(|c| dot(*c, along));
        all.fold((f64::MAX, f64::MIN), |(lo, hi), x| (lo.min(x), hi.max(x)))
    }
    pub fn heights(&self) -> (f64, f64) {
        self.reach([0.0, 1.0, 0.0])
    }
}

/// Where an edge passes a height.
fn through((a, b): (V, V), height: f64) -> Option<V> {
    let t = (height - a[1]) / (b[1] - a[1]);
    ((a[1] < height) != (b[1] < height)).then(|| add(a, times(sub(b, a), t)))
}

/// The corners of a face in order around its middle.
fn around(points: &[V], mut face: Vec<usize>, normal: V) -> Vec<usize> {
    let sum = face.iter().fold([0.0; 3], |sum, i| add(sum, points[*i]));
    let middle = times(sum, 1.0 / face.len() as f64);
    let first = sub(points[face[0]], middle);
    let second = cross(normal, first);
    face.sort_by(|a, b| {
        let at = |i: usize| dot(sub(points[i], middle), second).atan2(dot(sub(points[i], middle), first));
        at(*a).total_cmp(&at(*b))
    });
    face
}

/// Directions of edges, each once.
fn directions(edges: &[(V, V)]) -> Vec<V> {
    let mut out: Vec<V> = Vec::new();
    for (a, b) in edges {
        let along = sub(*b, *a);
        let size = length(along);
        if size > 0.0 {
            let along = times(along, 1.0 / size);
            if !out.iter().any(|o| length(cross(*o, along)) < 1e-10) {
                out.push(along);
            }
        }
    }
    out
}

/// The greatest separation along any of the axes; where negative, minus the least move that parts the two.
fn along_axes(a: &Solid, b: &Solid, axes: impl Iterator<Item = V>) -> f64 {
    axes.map(|axis| {
        let ((a_lo, a_hi), (b_lo, b_hi)) = (a.reach(axis), b.reach(axis));
        (b_lo - a_hi).max(a_lo - b_hi)
    })
    .fold(f64::MIN, f64::max)
}

/// Distance of the surfaces; overlapping: minus the depth.
pub fn gap(a: &Solid, b: &Solid) -> f64 {
    let (edges_a, edges_b) = (a.edges(), b.edges());
    let normals = a.faces.iter().map(|f| a.normal(f)).chain(b.faces.iter().map(|f| b.normal(f)));
    let (along_a, along_b) = (directions(&edges_a), directions(&edges_b));
    let crossed = along_a.iter().flat_map(|x| along_b.iter().map(|y| cross(*x, *y)));
    let crossed = crossed.filter(|c| length(*c) > 1e-7).map(|c| times(c, 1.0 / length(c)));
    let apart = along_axes(a, b, normals.chain(crossed));
    if apart <= 0.0 {
        return apart;
    }
    let between_edges = edges_a.iter().flat_map(|x| edges_b.iter().map(|y| between_segments(*x, *y)));
    between_edges.chain(over_faces(a, b)).chain(over_faces(b, a)).fold(f64::MAX, f64::min)
}

/// Heights of corners of `b` that stand straight over a face of `a`.
fn over_faces<'s>(a: &'s Solid, b: &'s Solid) -> impl Iterator<Item = f64> + 's {
    a.faces.iter().flat_map(move |face| {
        let normal = a.normal(face);
        let sum = face.iter().fold([0.0; 3], |sum, i| add(sum, a.corners[*i]));
        let middle = times(sum, 1.0 / face.len() as f64);
        let above = move |p: &V| {
            let inside = (0..face.len()).all(|i| {
                let (c, d) = (a.corners[face[i]], a.corners[face[(i + 1) % face.len()]]);
                let out = cross(sub(d, c), normal);
                // The side of the edge that the middle of the face is on.
                dot(sub(*p, c), out) * dot(sub(middle, c), out) >= 0.0
            });
            let height = dot(sub(*p, a.corners[face[0]]), normal);
            (inside && height >= -1e-9).then_some(height.max(0.0))
        };
        b.corners.iter().filter_map(above)
    })
}

fn to_segment(p: V, (a, b): (V, V)) -> f64 {
    let along = sub(b, a);
    let square = dot(along, along);
    let t = if square > 0.0 { (dot(sub(p, a), along) / square).clamp(0.0, 1.0) } else { 0.0 };
    distance(p, add(a, times(along, t)))
}

fn between_segments(x: (V, V), y: (V, V)) -> f64 {
    let ends = [to_segment(x.0, y), to_segment(x.1, y), to_segment(y.0, x), to_segment(y.1, x)];
    let least = ends.into_iter().fold(f64::MAX, f64::min);
    // Where both are nearest in their middles, the line between is along the product of their directions.
    let (u, v) = (sub(x.1, x.0), sub(y.1, y.0));
    let normal = cross(u, v);
    let square = dot(normal, normal);
    if square < 1e-14 * dot(u, u) * dot(v, v) {
        return least;
    }
    let from = sub(y.0, x.0);
    let (s, t) = (dot(cross(from, v), normal) / square, dot(cross(from, u), normal) / square);
    let meets = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
    if meets { least.min(dot(from, normal).abs() / square.sqrt()) } else { least }
}

/// The gap between a box and the line from one point to another, without thickness.
pub fn gap_to_line(a: &Solid, from: V, to: V) -> f64 {
    let (edges, line) = (a.edges(), (from, to));
    let along = sub(to, from);
    let as_solid = Solid { corners: vec![from, to], faces: Vec::new() };
    let normals = a.faces.iter().map(|f| a.normal(f));
    let crossed = directions(&edges).into_iter().map(|e| cross(e, along));
    let crossed = crossed.filter(|c| length(*c) > 1e-7 * length(along)).map(|c| times(c, 1.0 / length(c)));
    let apart = along_axes(a, &as_solid, normals.chain(crossed));
    if apart <= 0.0 {
        return apart;
    }
    edges.iter().map(|e| between_segments(*e, line)).chain(over_faces(a, &as_solid)).fold(f64::MAX, f64::min)
}

#[test]
fn gaps_of_boxes() {
    let cube = |at: V, degrees: V| Solid::cuboid([1.0; 3]).placed(&super::space::euler(degrees), at);
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
    let still = cube([0.0; 3], [0.0; 3]);
    near(gap(&still, &cube([3.0, 0.0, 0.0], [0.0; 3])), 2.0);
    near(gap(&still, &cube([0.9, 0.1, 0.2], [0.0; 3])), -0.1);
    near(gap(&still, &cube([4.0, 5.0, 0.0], [0.0; 3])), 5.0);
    near(gap(&still, &cube([2.0, 0.0, 0.0], [0.0, 45.0, 0.0])), 1.5 - 0.5_f64.sqrt());
    // Two edges across each other.
    near(gap(&cube([0.0; 3], [45.0, 0.0, 0.0]), &cube([0.0, 2.0, 0.0], [0.0, 0.0, 45.0])), 2.0 - 2.0_f64.sqrt());
    near(gap_to_line(&still, [-2.0, 0.4, 0.0], [2.0, 0.4, 0.0]), -0.1);
    near(gap_to_line(&still, [-2.0, 1.0, 0.0], [2.0, 1.0, 0.0]), 0.5);
    let hull = Solid::hull(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0]]);
    assert_eq!(hull.faces.len(), 5);
}
