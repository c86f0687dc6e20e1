//! Vectors, matrices and rotations over any [`Number`]. Metres and degrees; left-handed frame, y up.

use crate::number::{Algebra, Number};
use nalgebra::Vector3;
use std::ops::{Add, Neg, Sub};

/// Three numbers: a point, a direction, extents, or an Euler triple in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct V3<N>(pub [N; 3]);

impl<N: Number> V3<N> {
    /// Its plain value.
    pub fn value(&self) -> Vector3<f64> {
        Vector3::new(self.0[0].value(), self.0[1].value(), self.0[2].value())
    }
}

impl<N: Algebra> V3<N> {
    /// From plain numbers.
    pub fn constant(v: &Vector3<f64>) -> Self {
        Self([N::constant(v.x), N::constant(v.y), N::constant(v.z)])
    }
    /// Each component by itself.
    pub fn map(self, f: impl FnMut(N) -> N) -> Self {
        Self(self.0.map(f))
    }
    /// Times a number.
    pub fn times(self, factor: N) -> Self {
        self.map(|c| c * factor)
    }
    /// Scalar product.
    pub fn dot(self, other: Self) -> N {
        self.0[0] * other.0[0] + self.0[1] * other.0[1] + self.0[2] * other.0[2]
    }
    /// Scalar product with a plain direction.
    pub fn along(self, direction: &Vector3<f64>) -> N {
        self.0[0].scale(direction.x) + self.0[1].scale(direction.y) + self.0[2].scale(direction.z)
    }
    /// Vector product, by the usual formula.
    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }
    pub fn length(self) -> N {
        self.dot(self).sqrt()
    }
    /// Degrees between two vectors.
    pub fn angle(self, other: Self) -> N {
        self.cross(other).length().atan2(self.dot(other))
    }
}

impl<N: Algebra> Add for V3<N> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }
}

impl<N: Algebra> Sub for V3<N> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] - other.0[i]))
    }
}

impl<N: Algebra> Neg for V3<N> {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|c| -c)
    }
}

/// A rotation matrix by its columns: where the local axes point (right, up, front).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct M3<N>(pub [V3<N>; 3]);

impl<N: Algebra> M3<N> {
    /// R = Ry·Rz·Rx of an Euler triple: first about x, then z, then y, about the fixed world axes.
    pub fn rotation(euler: V3<N>) -> Self {
        let [x, y, z] = euler.0;
        let ((sx, cx), (sy, cy), (sz, cz)) = ((x.sin(), x.cos()), (y.sin(), y.cos()), (z.sin(), z.cos()));
        // Columns of Rz·Rx, then each turned about y.
        let about_y = |[a, b, c]: [N; 3]| V3([cy * a + sy * c, b, cy * c - sy * a]);
        let zero = N::constant(0.0);
        Self([about_y([cz, sz, zero]), about_y([-(sz * cx), cz * cx, sx]), about_y([sz * sx, -(cz * sx), cx])])
    }
    /// A local vector, in the world.
    pub fn turn(&self, v: V3<N>) -> V3<N> {
        self.0[0].times(v.0[0]) + self.0[1].times(v.0[1]) + self.0[2].times(v.0[2])
    }
    /// A plain local vector, in the world.
    pub fn turn_constant(&self, v: &Vector3<f64>) -> V3<N> {
        let [x, y, z] = self.0;
        x.map(|c| c.scale(v.x)) + y.map(|c| c.scale(v.y)) + z.map(|c| c.scale(v.z))
    }
    /// Degrees of the turn that takes one orientation to the other.
    pub fn angle(&self, other: &Self) -> N {
        // Of D = selfᵀ·other: twice the sine is the length of its antisymmetric part, trace = 1 + twice the cosine.
        let d = |i: usize, j: usize| self.0[i].dot(other.0[j]);
        let twice_sine = V3([d(2, 1) - d(1, 2), d(0, 2) - d(2, 0), d(1, 0) - d(0, 1)]).length();
        twice_sine.atan2(d(0, 0) + d(1, 1) + d(2, 2) - N::constant(1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned(euler: [f64; 3], axis: usize) -> [f64; 3] {
        M3::rotation(V3(euler)).0[axis].0.map(|c| c + 0.0)
    }

    #[test]
    fn x_is_turned_first_then_z_then_y() {
        // rot(90, 0, 90) faces +x, its up is +z, its right is +y; rot(0, 90, 0) faces +x, its right is −z.
        assert_eq!(turned([90.0, 0.0, 90.0], 2), [1.0, 0.0, 0.0]);
        assert_eq!(turned([90.0, 0.0, 90.0], 1), [0.0, 0.0, 1.0]);
        assert_eq!(turned([90.0, 0.0, 90.0], 0), [0.0, 1.0, 0.0]);
        assert_eq!(turned([0.0, 90.0, 0.0], 2), [1.0, 0.0, 0.0]);
        assert_eq!(turned([0.0, 90.0, 0.0], 0), [0.0, 0.0, -1.0]);
    }

    #[test]
    fn angles_between_orientations() {
        for (a, b, angle) in [
            ([0.0, 10.0, 0.0], [0.0, 350.0, 0.0], 20.0),
            ([0.0, 90.0, 0.0], [0.0, 450.0, 0.0], 0.0),
            ([0.0, 0.0, 0.0], [0.0, 180.0, 0.0], 180.0),
            ([180.0, 0.0, 180.0], [0.0, 180.0, 0.0], 0.0),
        ] {
            let measured = M3::rotation(V3(a)).angle(&M3::rotation(V3(b)));
            assert!((measured - angle).abs() < 1e-9, "{a:?} {b:?}: {measured}");
        }
    }
}
