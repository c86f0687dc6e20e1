//! Rotations: Euler triples, matrices, quaternions, and the angle between two orientations.
//!
//! A triple (rx, ry, rz) in degrees turns first about x, then z, then y, about the fixed world axes:
//! R = Ry·Rz·Rx with the usual matrices. The left-handed frame has the same formulas as a right-handed one.

use crate::Vec3;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};

/// Sine and cosine of an angle in degrees, exact at multiples of 90°.
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    let quarter = (degrees / 90.0).round();
    let (s, c) = (degrees - 90.0 * quarter).to_radians().sin_cos();
    match quarter.rem_euclid(4.0) as i64 {
        0 => (s, c),
        1 => (c, -s),
        2 => (-s, -c),
        _ => (-c, s),
    }
}

/// The matrix of an Euler triple in degrees; its columns are the object's right, up and front.
pub fn matrix(triple: Vec3) -> Matrix3<f64> {
    let (sx, cx) = sin_cos(triple.x);
    let (sy, cy) = sin_cos(triple.y);
    let (sz, cz) = sin_cos(triple.z);
    let rx = Matrix3::new(1.0, 0.0, 0.0, 0.0, cx, -sx, 0.0, sx, cx);
    let ry = Matrix3::new(cy, 0.0, sy, 0.0, 1.0, 0.0, -sy, 0.0, cy);
    let rz = Matrix3::new(cz, -sz, 0.0, sz, cz, 0.0, 0.0, 0.0, 1.0);
    ry * rz * rx
}

/// The Euler triple in degrees of a rotation matrix: x and y in [-180, 180], z in [-90, 90]; x = 0 where z = ±90.
pub fn triple(r: &Matrix3<f64>) -> Vec3 {
    let level = r[(0, 0)].hypot(r[(2, 0)]);
    let z = r[(1, 0)].atan2(level);
    // Where z = ±90° only the sum (or difference) of x and y is determined: all of it goes to y.
    let y = if level < 1e-12 { r[(0, 2)].atan2(r[(2, 2)]) } else { (-r[(2, 0)]).atan2(r[(0, 0)]) };
    // x from what Ry leaves over, so that an inexact y near the pole is made good.
    let (s, c) = y.sin_cos();
    let x = if level < 1e-12 { 0.0 } else { (s * r[(0, 1)] + c * r[(2, 1)]).atan2(s * r[(0, 2)] + c * r[(2, 2)]) };
    // Adding 0 turns -0 into 0.
    Vec3::new(x, y, z).map(|a| a.to_degrees() + 0.0)
}

/// The unit quaternion [x, y, z, w] of a rotation matrix, with w ≥ 0.
pub fn quaternion(r: &Matrix3<f64>) -> [f64; 4] {
    let q = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*r));
    let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
    [q.i, q.j, q.k, q.w].map(|v| v * sign + 0.0)
}

/// The matrix of a unit quaternion [x, y, z, w].
pub fn from_quaternion([x, y, z, w]: [f64; 4]) -> Matrix3<f64> {
    *UnitQuaternion::new_normalize(nalgebra::Quaternion::new(w, x, y, z)).to_rotation_matrix().matrix()
}

/// The angle between two orientations, in degrees, in [0, 180].
pub fn angle_between(a: &Matrix3<f64>, b: &Matrix3<f64>) -> f64 {
    let d = a.transpose() * b;
    let axis = Vec3::new(d[(2, 1)] - d[(1, 2)], d[(0, 2)] - d[(2, 0)], d[(1, 0)] - d[(0, 1)]);
    // 2 sin and 2 cos of the angle: accurate at both ends, where acos is not.
    axis.norm().atan2(d.trace() - 1.0).to_degrees()
}

/// The angle between two vectors, in degrees, in [0, 180]; of a zero vector 0.
pub fn angle_of(a: &Vec3, b: &Vec3) -> f64 {
    a.cross(b).norm().atan2(a.dot(b)).to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_quarter_turn_about_y_faces_x() {
        assert_eq!(matrix(Vec3::new(0.0, 90.0, 0.0)) * Vec3::z(), Vec3::x());
        assert_eq!(matrix(Vec3::new(0.0, -630.0, 0.0)), matrix(Vec3::new(0.0, 90.0, 0.0)));
    }

    #[test]
    fn the_order_is_x_then_z_then_y() {
        // x takes +z to -y, z takes -y to +x, y takes +x to -z.
        assert_eq!(matrix(Vec3::new(90.0, 90.0, 90.0)) * Vec3::z(), -Vec3::z());
    }

    #[test]
    fn all_right_angles_come_back() {
        for i in 0..64 {
            let t = Vec3::new(f64::from(i % 4), f64::from(i / 4 % 4), f64::from(i / 16)) * 90.0;
            let r = matrix(t);
            assert!((matrix(triple(&r)) - r).amax() < 1e-15, "{t}");
            assert!((from_quaternion(quaternion(&r)) - r).amax() < 1e-15, "{t}");
        }
    }

    #[test]
    fn angles_are_exact_at_both_ends() {
        for degrees in [0.0, 1e-9, 0.1, 90.0, 179.999_999_9, 180.0] {
            let r = matrix(Vec3::new(degrees, 0.0, 0.0));
            assert!((angle_between(&Matrix3::identity(), &r) - degrees).abs() < 1e-11);
        }
    }

    proptest! {
        #[test]
        fn triples_and_quaternions_come_back(
            x in -400.0..400.0, y in -400.0..400.0, z in prop_oneof![-400.0..400.0, 89.999_999..90.000_001, -1e-9..1e-9f64],
        ) {
            let r = matrix(Vec3::new(x, y, z));
            prop_assert!((r * r.transpose() - Matrix3::identity()).amax() < 1e-14);
            prop_assert!((matrix(triple(&r)) - r).amax() < 1e-11);
            prop_assert!((from_quaternion(quaternion(&r)) - r).amax() < 1e-13);
            prop_assert!(quaternion(&r)[3] >= 0.0);
        }
    }
}
