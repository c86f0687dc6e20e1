//! How the mass of a body is distributed.

use nalgebra::Matrix3;
use scenelang_layout::{Convex, Vec3};

/// Mass, centre and moments of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Inertia {
    /// Kilograms.
    pub mass: f64,
    /// Centre of mass, in the frame of the body.
    pub center: Vec3,
    /// The tensor about the centre of mass along the axes of the body's frame, kg·m².
    pub tensor: Matrix3<f64>,
}

impl Inertia {
    /// Of convex parts of given masses, each of one density.
    pub fn of<'a>(parts: impl Iterator<Item = (&'a Convex, f64)> + Clone) -> Self {
        let moments: Vec<(f64, Moments)> = parts.map(|(part, mass)| (mass, Moments::of(part))).collect();
        let mass: f64 = moments.iter().map(|(m, _)| m).sum();
        let center = moments.iter().map(|(m, part)| part.center * *m).sum::<Vec3>() / mass;
        let second = moments
            .iter()
            .map(|(m, part)| {
                let off = part.center - center;
                (part.spread + off * off.transpose()) * *m
            })
            .sum::<Matrix3<f64>>();
        let tensor = Matrix3::identity() * second.trace() - second;
        // What rounding leaves off the diagonal says nothing.
        let least = tensor.trace() * 1e-12;
        Self { mass, center, tensor: tensor.map(|v| if v.abs() < least { 0.0 } else { v }) }
    }
}

/// Centre and spread of a solid of mass 1.
struct Moments {
    center: Vec3,
    /// The mean of (p − center)(p − center)ᵀ over the solid.
    spread: Matrix3<f64>,
}

impl Moments {
    /// The solid is cut into tetrahedra from a point within.
    fn of(part: &Convex) -> Self {
        let apex = part.vertices().iter().sum::<Vec3>() / part.vertices().len().max(1) as f64;
        let (mut volume, mut first, mut second) = (0.0, Vec3::zeros(), Matrix3::zeros());
        for face in part.faces() {
            let corners: Vec<Vec3> = part.face_corners(face).map(|p| p - apex).collect();
            for pair in corners[1..].windows(2) {
                let [a, b, c] = [corners[0], pair[0], pair[1]];
                let v = a.dot(&b.cross(&c)).abs() / 6.0;
                let sum = a + b + c;
                volume += v;
                first += sum * (v / 4.0);
                let own = a * a.transpose() + b * b.transpose() + c * c.transpose();
                second += (own + sum * sum.transpose()) * (v / 20.0);
            }
        }
        if volume <= 0.0 {
            return Self { center: apex, spread: Matrix3::zeros() };
        }
        let mean = first / volume;
        Self { center: apex + mean, spread: second / volume - mean * mean.transpose() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_layout::{Obb, Part};

    fn block(center: Vec3, size: Vec3) -> Convex {
        Convex::from_box(&Obb { center, axes: Matrix3::identity(), half: size / 2.0 })
    }

    #[test]
    fn a_box_has_the_moments_of_the_textbook() {
        let part = block(Vec3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, 3.0));
        let found = Inertia::of([(&part, 12.0)].into_iter());
        assert!((found.center - Vec3::new(1.0, 2.0, 3.0)).norm() < 1e-12);
        let want = Matrix3::from_diagonal(&Vec3::new(13.0, 10.0, 5.0));
        assert!((found.tensor - want).amax() < 1e-9, "{}", found.tensor);
    }

    #[test]
    fn two_halves_are_the_whole() {
        let whole = block(Vec3::zeros(), Vec3::new(2.0, 1.0, 1.0));
        let half = |x: f64| block(Vec3::new(x, 0.0, 0.0), Vec3::repeat(1.0));
        let (left, right) = (half(-0.5), half(0.5));
        let one = Inertia::of([(&whole, 6.0)].into_iter());
        let two = Inertia::of([(&left, 3.0), (&right, 3.0)].into_iter());
        assert!((one.tensor - two.tensor).amax() < 1e-9 && (one.center - two.center).norm() < 1e-12);
    }

    #[test]
    fn a_turned_tetrahedron_keeps_its_principal_moments() {
        let points = vec![Vec3::zeros(), Vec3::x(), Vec3::y() * 2.0, Vec3::z() * 3.0];
        let part = Convex::from_part(&Part::Hull { points }).unwrap();
        let turned = part.moved(&scenelang_layout::rotation::matrix(Vec3::new(30.0, 50.0, 70.0)), &Vec3::repeat(5.0));
        let moments = |c: &Convex| {
            let mut values: Vec<f64> =
                Inertia::of([(c, 2.0)].into_iter()).tensor.symmetric_eigenvalues().iter().copied().collect();
            values.sort_by(f64::total_cmp);
            values
        };
        for (a, b) in moments(&part).iter().zip(moments(&turned)) {
            assert!((a - b).abs() < 1e-9);
        }
    }
}
