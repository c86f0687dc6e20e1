//! The way from the scene's left-handed frame to the frames of others.

use nalgebra::Matrix3;
use scenelang_layout::{Vec3, rotation};

/// A right-handed frame of others. Either is reached by a reflection, so triangles run the other way round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// y up: x is negated (glTF, USD, OBJ).
    YUp,
    /// z up: y and z change places (MuJoCo, SDF).
    ZUp,
}

impl Frame {
    /// A point or a direction.
    pub fn point(self, p: Vec3) -> Vec3 {
        match self {
            Self::YUp => mirrored(p),
            Self::ZUp => Vec3::new(p.x, p.z, p.y),
        }
    }

    /// Extents along the axes.
    pub fn extents(self, size: Vec3) -> Vec3 {
        match self {
            Self::YUp => size,
            Self::ZUp => Vec3::new(size.x, size.z, size.y),
        }
    }

    /// A rotation, or any tensor.
    pub fn tensor(self, m: &Matrix3<f64>) -> Matrix3<f64> {
        let s = Matrix3::from_columns(&[Vec3::x(), Vec3::y(), Vec3::z()].map(|e| self.point(e)));
        s * m * s
    }

    /// A rotation as a unit quaternion x, y, z, w.
    pub fn quaternion(self, m: &Matrix3<f64>) -> [f64; 4] {
        rotation::quaternion(&self.tensor(m))
    }

    /// A corner or a normal of a mesh.
    pub fn corner(self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        match self {
            Self::YUp => [0.0 - x, y, z],
            Self::ZUp => [x, z, y],
        }
    }
}

/// A point in a right-handed frame: x negated (glTF, OBJ). Triangles then run the other way round.
pub fn mirrored(p: Vec3) -> Vec3 {
    Vec3::new(0.0 - p.x, p.y, p.z)
}

/// An orientation (a unit quaternion x, y, z, w) in that right-handed frame.
pub fn mirrored_quaternion([x, y, z, w]: [f64; 4]) -> [f64; 4] {
    [x, 0.0 - y, 0.0 - z, w]
}

/// The triple (degrees) that Unity's inspector shows for an orientation: Unity turns about z, then x, then y.
pub fn unity_euler(m: &Matrix3<f64>) -> [f64; 3] {
    let sin = (-m[(1, 2)]).clamp(-1.0, 1.0);
    let (y, z) = if sin.abs() < 1.0 - 1e-9 {
        (m[(0, 2)].atan2(m[(2, 2)]), m[(1, 0)].atan2(m[(1, 1)]))
    } else {
        ((-m[(2, 0)]).atan2(m[(0, 0)]), 0.0)
    };
    // Adding 0 turns -0 into 0.
    [sin.asin(), y, z].map(|a| a.to_degrees() + 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::rotation::{from_quaternion, matrix, quaternion};

    /// Angles that hit every right angle and some that hit none.
    fn triples() -> impl Iterator<Item = Vec3> {
        const ANGLES: [f64; 7] = [0.0, 30.0, 90.0, 135.0, 180.0, 211.0, 270.0];
        ANGLES.into_iter().flat_map(|x| ANGLES.into_iter().flat_map(move |y| ANGLES.map(|z| Vec3::new(x, y, z))))
    }

    #[test]
    fn unity_reads_its_own_triple_back_to_the_same_orientation() {
        for t in triples() {
            let m = matrix(t);
            let [x, y, z] = unity_euler(&m);
            let about = |x, y, z| matrix(Vec3::new(x, y, z));
            let back = about(0.0, y, 0.0) * about(x, 0.0, 0.0) * about(0.0, 0.0, z);
            assert!((m - back).amax() < 1e-7, "{t}");
        }
    }

    #[test]
    fn a_frame_turns_points_as_it_turns_rotations() {
        let p = Vec3::new(0.3, -1.2, 2.5);
        for frame in [Frame::YUp, Frame::ZUp] {
            for t in triples() {
                let turned = from_quaternion(frame.quaternion(&matrix(t))) * frame.point(p);
                assert!((turned - frame.point(matrix(t) * p)).norm() < 1e-9, "{frame:?} {t}");
                assert!(frame.tensor(&matrix(t)).determinant() > 0.0);
            }
        }
        assert_eq!(Frame::ZUp.point(Vec3::y()), Vec3::z());
        assert_eq!(Frame::YUp.point(Vec3::z()), Vec3::z());
    }

    #[test]
    fn the_mirrored_quaternion_turns_mirrored_points() {
        let p = Vec3::new(0.3, -1.2, 2.5);
        for t in triples() {
            let m = from_quaternion(mirrored_quaternion(quaternion(&matrix(t))));
            assert!((m * mirrored(p) - mirrored(matrix(t) * p)).norm() < 1e-9, "{t}");
        }
    }
}
