//! Vectors and rotations as plain arrays, in the frame of the language: left-handed, y up, metres, degrees.

pub type V = [f64; 3];
/// Rows.
pub type M = [V; 3];

pub fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
pub fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}
pub fn times(a: V, k: f64) -> V {
    [a[0] * k, a[1] * k, a[2] * k]
}
pub fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
pub fn length(a: V) -> f64 {
    dot(a, a).sqrt()
}
pub fn distance(a: V, b: V) -> f64 {
    length(sub(a, b))
}
pub fn apply(m: &M, v: V) -> V {
    [dot(m[0], v), dot(m[1], v), dot(m[2], v)]
}
pub fn column(m: &M, i: usize) -> V {
    [m[0][i], m[1][i], m[2][i]]
}
pub fn product(a: &M, b: &M) -> M {
    let mut out = [[0.0; 3]; 3];
    for (i, row) in out.iter_mut().enumerate() {
        for (j, cell) in row.iter_mut().enumerate() {
            *cell = dot(a[i], column(b, j));
        }
    }
    out
}

/// R = Ry·Rz·Rx: first about x, then z, then y, about the fixed axes.
pub fn euler(degrees: V) -> M {
    let [x, y, z] = degrees.map(f64::to_radians);
    let about_x = [[1.0, 0.0, 0.0], [0.0, x.cos(), -x.sin()], [0.0, x.sin(), x.cos()]];
    let about_y = [[y.cos(), 0.0, y.sin()], [0.0, 1.0, 0.0], [-y.sin(), 0.0, y.cos()]];
    let about_z = [[z.cos(), -z.sin(), 0.0], [z.sin(), z.cos(), 0.0], [0.0, 0.0, 1.0]];
    product(&product(&about_y, &about_z), &about_x)
}

/// Degrees between two directions.
pub fn angle(a: V, b: V) -> f64 {
    length(cross(a, b)).atan2(dot(a, b)).to_degrees()
}

/// Degrees between two orientations: those of the one rotation that takes the first to the second.
pub fn turn_between(a: &M, b: &M) -> f64 {
    // The matrix Aᵀ·B has trace 1 + 2 cos and an antisymmetric part of length 2 sin.
    let between = product(&[column(a, 0), column(a, 1), column(a, 2)], b);
    let trace = between[0][0] + between[1][1] + between[2][2];
    let axis = [between[2][1] - between[1][2], between[0][2] - between[2][0], between[1][0] - between[0][1]];
    length(axis).atan2(trace - 1.0).to_degrees()
}

#[test]
fn a_turned_object_faces_as_the_text_says() {
    let front = |degrees| apply(&euler(degrees), [0.0, 0.0, 1.0]);
    assert!(distance(front([0.0, 90.0, 0.0]), [1.0, 0.0, 0.0]) < 1e-12);
    assert!(distance(front([90.0, 0.0, 0.0]), [0.0, -1.0, 0.0]) < 1e-12);
    assert!(distance(front([90.0, 0.0, 90.0]), [1.0, 0.0, 0.0]) < 1e-12);
    assert!((turn_between(&euler([0.0; 3]), &euler([0.0, 200.0, 0.0])) - 160.0).abs() < 1e-9);
}
