//! Poses as arrays have them, from and to those of layouts.
//!
//! A quaternion becomes an Euler triple, which is what layouts hold and formulas read. It is rounded to a billionth of a degree,
//! a thousandth of what a file of ours writes, and a yaw is in [0, 360), as the solver writes it: so the quaternion of an
//! upright object of a layout becomes the angle of the layout again, to the last bit.

use pyo3::exceptions::PyValueError;
use pyo3::{PyErr, PyResult};
use scenelang_export::Frame;
use scenelang_layout::file::LARGEST;
use scenelang_layout::{Vec3, rotation};

/// Angles are rounded to one part of so many of a degree.
const PER_DEGREE: f64 = 1e9;

/// A quaternion of smaller numbers has no direction that could be told.
const ZERO: f64 = 1e-100;

/// How a pose is written.
#[derive(Clone, Copy, Debug)]
pub struct Convention {
    /// Numbers of a pose: 6 with an Euler triple, 7 with a quaternion.
    pub width: usize,
    /// Whether the quaternion begins with its real part.
    pub real_first: bool,
    /// Whether it is right-handed with z up, as in MuJoCo; else as in layouts.
    pub z_up: bool,
}

impl Convention {
    /// From what Python calls it.
    ///
    /// # Errors
    /// There is no such convention.
    pub fn new(width: usize, order: &str, frame: &str) -> PyResult<Self> {
        let no = |said: String| -> PyErr { PyValueError::new_err(said) };
        let real_first = match order {
            "wxyz" => true,
            "xyzw" => false,
            other => return Err(no(format!("order is \"wxyz\" or \"xyzw\", not {other:?}"))),
        };
        let z_up = match frame {
            "scene" => false,
            "z-up" => true,
            other => return Err(no(format!("frame is \"scene\" or \"z-up\", not {other:?}"))),
        };
        match width {
            6 if z_up => Err(no("Euler angles are those of layouts: frame \"z-up\" takes quaternions".to_owned())),
            6 | 7 => Ok(Self { width, real_first, z_up }),
            other => Err(no(format!(
                "a pose has 7 numbers (position, quaternion) or 6 (position, Euler angles), not {other}"
            ))),
        }
    }

    /// Position and Euler triple of a pose; `None`: it is none, since something is not finite, too large, or a quaternion of
    /// zeros.
    pub fn read(self, pose: &[f64]) -> Option<(Vec3, Vec3)> {
        let is_number = |v: &f64| v.is_finite() && v.abs() <= LARGEST;
        if pose.len() != self.width || !pose.iter().all(is_number) {
            return None;
        }
        // Adding 0 turns -0 into 0.
        let pos = Vec3::new(pose[0], pose[1], pose[2]).map(|v| v + 0.0);
        if self.width == 6 {
            return Some((pos, Vec3::new(pose[3], pose[4], pose[5]).map(|v| v + 0.0)));
        }
        let [x, y, z, w] = match self.real_first {
            true => [pose[4], pose[5], pose[6], pose[3]],
            false => [pose[3], pose[4], pose[5], pose[6]],
        };
        if [x, y, z, w].iter().all(|v| v.abs() < ZERO) {
            return None;
        }
        let axes = rotation::from_quaternion([x, y, z, w]);
        let (pos, axes) = if self.z_up { (Frame::ZUp.point(pos), Frame::ZUp.tensor(&axes)) } else { (pos, axes) };
        Some((pos, triple(rotation::triple(&axes))))
    }

    /// The numbers of a pose.
    pub fn write(self, pos: Vec3, rot: Vec3, out: &mut Vec<f64>) {
        let axes = rotation::matrix(rot);
        let (pos, axes) = if self.z_up { (Frame::ZUp.point(pos), Frame::ZUp.tensor(&axes)) } else { (pos, axes) };
        out.extend(pos.iter());
        if self.width == 6 {
            out.extend(rot.iter());
            return;
        }
        let [x, y, z, w] = rotation::quaternion(&axes);
        out.extend(if self.real_first { [w, x, y, z] } else { [x, y, z, w] });
    }
}

/// Rounded, and the yaw in [0, 360).
fn triple(rot: Vec3) -> Vec3 {
    let rounded = |degrees: f64| (degrees * PER_DEGREE).round() / PER_DEGREE + 0.0;
    let [x, y, z]: [f64; 3] = rot.map(rounded).into();
    let yaw = if y < 0.0 { rounded(y + 360.0) } else { y };
    Vec3::new(x, if yaw >= 360.0 { 0.0 } else { yaw }, z)
}
