//! How a thing of a scene stands: what is read of a node of a GLB file, or of a game object of a Unity project.

use nalgebra::{Matrix3, Matrix4};
use scenelang_layout::Vec3;

/// Axes that are less square to each other than this are sheared.
const SQUARE: f64 = 1e-4;

/// A thing of the scene, in the scene's frame (left-handed, y up, metres).
#[derive(Clone, Debug)]
pub(super) struct Standing {
    /// The object that it was exported as, where that is still written in it.
    pub id: Option<String>,
    /// What it is called there now.
    pub name: String,
    /// What it is below, where that is not the place it was exported to.
    pub parent: Option<String>,
    /// Whether it is a piece of the building.
    pub is_building: bool,
    /// Its frame, or what is said of a thing without one: "was sheared".
    pub place: Result<FramePose, &'static str>,
}

/// Where a frame is.
#[derive(Clone, Copy, Debug)]
pub(super) struct FramePose {
    /// Its origin.
    pub pos: Vec3,
    /// How it is turned.
    pub axes: Matrix3<f64>,
    /// By how much it is larger than it was exported, along its own axes.
    pub scale: Vec3,
}

/// What is said of a thing whose transform holds no numbers.
pub(super) const UNREADABLE: &str = "has a transform that cannot be read";
const SHEARED: &str = "was sheared or mirrored";

impl FramePose {
    /// Of a transform that may move, turn and scale, but not shear or mirror.
    pub fn of(transform: &Matrix4<f64>) -> Result<Self, &'static str> {
        if !transform.iter().all(|v| v.is_finite()) {
            return Err(UNREADABLE);
        }
        let linear: Matrix3<f64> = transform.fixed_view::<3, 3>(0, 0).into();
        let scale = Vec3::new(linear.column(0).norm(), linear.column(1).norm(), linear.column(2).norm());
        if scale.min() < SQUARE || linear.determinant() <= 0.0 {
            return Err(SHEARED);
        }
        let axes = linear * Matrix3::from_diagonal(&scale.map(|s| 1.0 / s));
        let is_square = (axes.transpose() * axes - Matrix3::identity()).amax() < SQUARE;
        is_square.then(|| Self { pos: transform.fixed_view::<3, 1>(0, 3).into(), axes, scale }).ok_or(SHEARED)
    }
}

/// The transform of a translation, a quaternion (x, y, z, w) and a scale.
pub(super) fn transform(pos: [f64; 3], rot: [f64; 4], scale: [f64; 3]) -> Matrix4<f64> {
    // A quaternion of length 0 turns nothing.
    let turns = rot.iter().any(|v| *v != 0.0);
    let axes = if turns { scenelang_layout::rotation::from_quaternion(rot) } else { Matrix3::identity() };
    let linear = axes * Matrix3::from_diagonal(&Vec3::from(scale));
    let mut out = Matrix4::identity();
    out.fixed_view_mut::<3, 3>(0, 0).copy_from(&linear);
    out.fixed_view_mut::<3, 1>(0, 3).copy_from(&Vec3::from(pos));
    out
}
