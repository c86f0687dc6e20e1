//! Floor polygons for drawing: moved outwards, cut into triangles. All of positive winding (x towards z).

use scenelang_layout::planar::{Vec2, turn};

/// Each vertex moved outwards, so that every edge moves by `distance` (mitred corners).
pub fn offset(polygon: &[Vec2], distance: f64) -> Vec<Vec2> {
    offset_each(polygon, &vec![distance; polygon.len()])
}

/// Each vertex moved outwards, so that every edge moves by a distance of its own (mitred corners). Edges that go on straight
/// need the same distance.
pub fn offset_each(polygon: &[Vec2], distances: &[f64]) -> Vec<Vec2> {
    let n = polygon.len();
    (0..n)
        .map(|i| {
            let last = (i + n - 1) % n;
            let before = outward(polygon[last], polygon[i]);
            let after = outward(polygon[i], polygon[(i + 1) % n]);
            // The mitre point m satisfies m·before and m·after = the distances: half their sum along the sum of the normals
            // and half their difference along the difference. Very sharp corners and very flat steps are cut short.
            let (sum, turn) = (before + after, before - after);
            let (half, step) = ((distances[last] + distances[i]) / 2.0, (distances[last] - distances[i]) / 2.0);
            let along = |way: Vec2, by: f64| way * (by / (0.5 * way.norm_squared()).max(0.1));
            polygon[i] + along(sum, half) + along(turn, step)
        })
        .collect()
}

/// The unit normal of an edge that points out of the polygon.
pub fn outward(a: Vec2, b: Vec2) -> Vec2 {
    let d = b - a;
    Vec2::new(d.y, -d.x) / d.norm().max(1e-12)
}

/// Triangles (vertex indices, positive winding) that fill a simple polygon, by cutting ears.
pub fn triangles(polygon: &[Vec2]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..polygon.len()).collect();
    let mut out = Vec::with_capacity(polygon.len().saturating_sub(2));
    while left.len() > 3 {
        let n = left.len();
        let corner = |i: usize| [left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
        let doubled = |[a, b, c]: [usize; 3]| turn(polygon[a], polygon[b], polygon[c]);
        // Rounding can leave a polygon without a strict ear; then the first corner goes, so that the loop ends.
        let ear = (0..n)
            .find(|&i| {
                let t = corner(i);
                doubled(t) > 0.0 && !left.iter().any(|k| !t.contains(k) && in_triangle(polygon, t, polygon[*k]))
            })
            .unwrap_or(0);
        if doubled(corner(ear)) > 1e-12 {
            out.push(corner(ear));
        }
        left.remove(ear);
    }
    if let [a, b, c] = left[..] {
        out.push([a, b, c]);
    }
    out
}

fn in_triangle(polygon: &[Vec2], [a, b, c]: [usize; 3], p: Vec2) -> bool {
    [(a, b), (b, c), (c, a)].iter().all(|&(i, j)| turn(polygon[i], polygon[j], p) >= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::planar::edges;

    fn l() -> Vec<Vec2> {
        [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]].map(Vec2::from).to_vec()
    }

    #[test]
    fn triangles_fill_a_concave_polygon_exactly() {
        let l = l();
        let area: f64 = triangles(&l).iter().map(|&[a, b, c]| turn(l[a], l[b], l[c])).sum();
        assert_eq!(triangles(&l).len(), 4);
        assert_eq!(area, 28.0);
    }

    #[test]
    fn offset_moves_every_edge_outwards_by_the_distance() {
        let out = offset(&l(), 0.03);
        for (i, (a, b)) in edges(&l()).enumerate() {
            for k in [i, (i + 1) % 6] {
                assert!(((out[k] - a).dot(&outward(a, b)) - 0.03).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn edges_move_by_distances_of_their_own() {
        let distances = [0.12, 0.03, 0.12, 0.1, 0.03, 0.12];
        let out = offset_each(&l(), &distances);
        for (i, (a, b)) in edges(&l()).enumerate() {
            for k in [i, (i + 1) % 6] {
                assert!(((out[k] - a).dot(&outward(a, b)) - distances[i]).abs() < 1e-12);
            }
        }
    }
}
