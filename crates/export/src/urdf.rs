//! URDF: one object as a robot — a link for what stays, a link and a joint for each piece that turns or slides. The meshes are
//! beside it.
//!
//! Right-handed with z up: y and z of the scene change places. The base link has its origin in the middle of the lower face of
//! the object, wherever that stands; a link that moves has its origin on its joint, as URDF demands. Angles are radians.

use crate::geometry::frame::Frame;
use crate::geometry::mesh::MeshGroup;
use crate::loss::Lost;
use crate::names::{Identifiers, Stems};
use crate::numbers::{number, spaced};
use crate::obj::{Materials, Mesh};
use crate::physics::{Geom, Inertia, Joint, Physics, Shape};
use crate::xml::Xml;
use crate::{ExportError, Exporter, OutFile, Scene};
use nalgebra::Matrix3;
use scenelang_layout::{Motion, Vec3};
use std::collections::BTreeSet;

/// The `urdf/` folder: `OBJECT.urdf` and `meshes/`.
#[derive(Clone, Debug)]
pub struct Urdf {
    /// Its name in the program.
    pub object: String,
}

impl Urdf {
    /// Its name on the command line.
    pub const NAME: &'static str = "urdf";
}

const FRAME: Frame = Frame::ZUp;
/// The file of all materials.
const LIBRARY: &str = "materials.mtl";
/// What a limit of a joint has to say: no more is done to it (N·m or N), and it is no faster (rad/s or m/s).
const EFFORT: f64 = 100.0;
const VELOCITY: f64 = 3.0;

impl Exporter for Urdf {
    fn name(&self) -> &'static str {
        Self::NAME
    }

    fn key(&self) -> String {
        format!("{} {}", Self::NAME, self.object)
    }

    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let physics = Physics::of(scene);
        let body = physics.bodies.iter().find(|b| b.as_object().is_some_and(|object| object.name == self.object));
        let Some(body) = body else {
            let names = physics.bodies.iter().filter_map(|b| Some(b.as_object()?.name.as_str()));
            let near = scenelang_base::suggest::nearest(&self.object, names);
            let hint = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            return Err(ExportError::Format(Self::NAME, format!("the layout has no object `{}`{hint}", self.object)));
        };
        let stem = Stems::default().take(&self.object);
        let (mut names, mut joints) = (Identifiers::default(), Identifiers::default());
        let pieces = body.moving.iter().map(|m| (&m.drawn[..], &m.geoms)).chain([(&body.drawn[..], &body.geoms)]);
        let surfaces: BTreeSet<usize> =
            pieces.flat_map(|(d, g)| d.iter().map(|d| d.surface).chain(g.iter().map(|g| g.surface))).collect();
        let materials = Materials::used(scene, |surface| surfaces.contains(&surface));
        let mut meshes = Meshes { materials, stems: Stems::default(), files: Vec::new() };
        let mut xml = Xml::new();
        xml.begin("robot", &[("name", &Identifiers::default().take(&self.object))]);
        let base = names.take("base_link");
        let piece =
            Piece { geoms: &body.geoms, drawn: &body.drawn, inertia: body.inertia.as_ref(), origin: Vec3::zeros() };
        link(&mut xml, &base, &piece, &mut meshes);
        for moving in &body.moving {
            let name = names.take(moving.name.rsplit('/').next().unwrap_or_default());
            let origin = moving.joint.anchor;
            let piece = Piece { geoms: &moving.geoms, drawn: &moving.drawn, inertia: Some(&moving.inertia), origin };
            link(&mut xml, &name, &piece, &mut meshes);
            joint(&mut xml, &joints.take(&format!("{name}_joint")), [&base, &name], &moving.joint);
        }
        xml.end();
        let mut files = vec![OutFile::new(format!("urdf/{stem}.urdf"), xml.finish())];
        files.extend(meshes.files);
        files.extend(meshes.materials.files(scene, "urdf/meshes", LIBRARY)?);
        Ok(files)
    }

    fn lost(&self, _: &Scene) -> Vec<Lost> {
        vec![Lost::Others, Lost::Program]
    }
}

/// What a link is made of, in the frame of the object, and where its own origin is.
struct Piece<'a> {
    geoms: &'a [Geom],
    drawn: &'a [MeshGroup],
    inertia: Option<&'a Inertia>,
    origin: Vec3,
}

fn link(xml: &mut Xml, name: &str, piece: &Piece<'_>, meshes: &mut Meshes) {
    xml.begin("link", &[("name", name)]);
    if let Some(inertia) = piece.inertia {
        xml.begin("inertial", &[]);
        origin(xml, &(inertia.center - piece.origin), &Matrix3::identity());
        xml.empty("mass", &[("value", &number(inertia.mass))]);
        let tensor = FRAME.tensor(&inertia.tensor);
        // Moments of small things are small: no figure may be lost.
        let of = |row: usize, column: usize| (tensor[(row, column)] + 0.0).to_string();
        xml.empty(
            "inertia",
            &[
                ("ixx", &of(0, 0)),
                ("ixy", &of(0, 1)),
                ("ixz", &of(0, 2)),
                ("iyy", &of(1, 1)),
                ("iyz", &of(1, 2)),
                ("izz", &of(2, 2)),
            ],
        );
        xml.end();
    }
    if piece.drawn.iter().any(|group| !group.indices.is_empty()) {
        xml.begin("visual", &[("name", &format!("{name}_look"))]);
        let file = meshes.file(name, piece.drawn, &-piece.origin);
        mesh(xml, &file);
        xml.end();
    }
    for (i, geom) in piece.geoms.iter().enumerate() {
        let called = format!("{name}_solid_{i}");
        xml.begin("collision", &[("name", &called)]);
        match &geom.shape {
            Shape::Box(size) => {
                origin(xml, &(geom.pos - piece.origin), &geom.axes);
                xml.begin("geometry", &[]);
                xml.empty("box", &[("size", &spaced(FRAME.extents(*size).iter().copied()))]);
                xml.end();
            }
            Shape::Cylinder { radius, height } => {
                origin(xml, &(geom.pos - piece.origin), &geom.axes);
                xml.begin("geometry", &[]);
                xml.empty("cylinder", &[("radius", &number(*radius)), ("length", &number(*height))]);
                xml.end();
            }
            Shape::Hull(hull) => {
                let mut group = MeshGroup::new(geom.surface);
                group.solid(hull);
                let file = meshes.file(&called, &[group], &-piece.origin);
                mesh(xml, &file);
            }
        }
        xml.end();
    }
    xml.end();
}

/// The joint between two links, at a point of its axis.
fn joint(xml: &mut Xml, name: &str, [parent, child]: [&str; 2], joint: &Joint) {
    let kind = match joint.motion {
        Motion::Hinge => "revolute",
        Motion::Slide => "prismatic",
    };
    xml.begin("joint", &[("name", name), ("type", kind)]);
    origin(xml, &joint.anchor, &Matrix3::identity());
    xml.empty("parent", &[("link", parent)]);
    xml.empty("child", &[("link", child)]);
    xml.empty("axis", &[("xyz", &spaced(joint.axis_in(FRAME).iter().copied()))]);
    let [lower, upper] = joint.range.map(number);
    let (effort, velocity) = (number(EFFORT), number(VELOCITY));
    xml.empty("limit", &[("lower", &lower), ("upper", &upper), ("effort", &effort), ("velocity", &velocity)]);
    let (damping, friction) = (number(joint.damping), number(joint.friction));
    xml.empty("dynamics", &[("damping", &damping), ("friction", &friction)]);
    xml.end();
}

/// Position, and roll, pitch and yaw: turns about x, then y, then z of the frame outside.
fn origin(xml: &mut Xml, pos: &Vec3, axes: &Matrix3<f64>) {
    let m = FRAME.tensor(axes);
    let flat = m[(0, 0)].hypot(m[(1, 0)]);
    let pitch = (-m[(2, 0)]).atan2(flat);
    // Straight up or down only the difference of roll and yaw is determined.
    let (roll, yaw) = if flat > 1e-9 {
        (m[(2, 1)].atan2(m[(2, 2)]), m[(1, 0)].atan2(m[(0, 0)]))
    } else {
        (0.0, (-m[(0, 1)]).atan2(m[(1, 1)]))
    };
    xml.empty("origin", &[("xyz", &spaced(FRAME.point(*pos).iter().copied())), ("rpy", &spaced([roll, pitch, yaw]))]);
}

fn mesh(xml: &mut Xml, file: &str) {
    xml.begin("geometry", &[]);
    xml.empty("mesh", &[("filename", &format!("meshes/{file}"))]);
    xml.end();
}

/// Files of meshes.
struct Meshes {
    materials: Materials,
    stems: Stems,
    files: Vec<OutFile>,
}

impl Meshes {
    fn file(&mut self, name: &str, groups: &[MeshGroup], moved: &Vec3) -> String {
        let file = format!("{}.obj", self.stems.take(name));
        let mut mesh = Mesh::new(FRAME, &self.materials, LIBRARY);
        mesh.groups(groups, &Matrix3::identity(), moved);
        self.files.push(OutFile::new(format!("urdf/meshes/{file}"), mesh.finish()));
        file
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::fixture::cupboard;
    use std::collections::BTreeSet;

    fn robot(files: &[OutFile]) -> String {
        String::from_utf8(files[0].bytes.clone()).unwrap()
    }

    fn numbers(node: roxmltree::Node<'_, '_>, key: &str) -> Vec<f64> {
        node.attribute(key).unwrap().split(' ').map(|v| v.parse().unwrap()).collect()
    }

    /// What any reader of URDF asks for.
    #[test]
    fn a_cupboard_is_a_tree_of_links_with_limits_and_masses() {
        let files = Urdf { object: "cupboard".into() }.files(&cupboard()).unwrap();
        let text = robot(&files);
        let xml = roxmltree::Document::parse(&text).unwrap();
        let all = |tag: &'static str| xml.descendants().filter(move |n| n.has_tag_name(tag));
        let child =
            |node: roxmltree::Node<'_, '_>, tag: &str| node.children().find(|n| n.has_tag_name(tag)).unwrap().range();
        let links: BTreeSet<_> = all("link").filter_map(|n| n.attribute("name")).collect();
        assert_eq!(links, BTreeSet::from(["base_link", "door", "drawer"]));
        let mut children = BTreeSet::new();
        for joint in all("joint") {
            let of = |tag: &'static str| joint.children().find(|n| n.has_tag_name(tag)).unwrap();
            assert_eq!(of("parent").attribute("link"), Some("base_link"));
            assert!(children.insert(of("child").attribute("link").unwrap()), "a link has one joint above it");
            let axis = numbers(of("axis"), "xyz");
            assert!((axis.iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-9);
            let [lower, upper] = ["lower", "upper"].map(|key| numbers(of("limit"), key)[0]);
            assert!(lower <= 0.0 && upper > 0.0);
            child(joint, "dynamics");
        }
        assert_eq!(children, BTreeSet::from(["door", "drawer"]));
        for inertial in all("inertial") {
            let of = |tag: &'static str| inertial.children().find(|n| n.has_tag_name(tag)).unwrap();
            let moments = ["ixx", "iyy", "izz"].map(|key| numbers(of("inertia"), key)[0]);
            let sum: f64 = moments.iter().sum();
            assert!(
                numbers(of("mass"), "value")[0] > 0.0
                    && moments.iter().all(|m| *m > 0.0 && 2.0 * m <= sum * (1.0 + 1e-9))
            );
        }
        let written: BTreeSet<String> = files.iter().map(|f| f.path.to_str().unwrap().to_owned()).collect();
        for mesh in all("mesh") {
            let file = format!("urdf/{}", mesh.attribute("filename").unwrap());
            assert!(written.contains(&file), "{file}");
        }
    }

    #[test]
    fn a_link_that_moves_has_its_origin_on_its_joint() {
        let text = robot(&Urdf { object: "cupboard".into() }.files(&cupboard()).unwrap());
        let xml = roxmltree::Document::parse(&text).unwrap();
        let named = |tag: &str, name: &str| {
            xml.descendants().find(|n| n.has_tag_name(tag) && n.attribute("name") == Some(name)).unwrap()
        };
        let origin = |node: roxmltree::Node<'_, '_>| {
            let at = node.children().find(|n| n.has_tag_name("origin")).unwrap();
            numbers(at, "xyz")
        };
        // The anchor of the door is (-0.39, 0.65, 0.23) with y up, the middle of its board (0, 0.65, 0.24).
        let near = |a: Vec<f64>, b: [f64; 3]| assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-9), "{a:?} is not {b:?}");
        near(origin(named("joint", "door_joint")), [-0.39, 0.23, 0.65]);
        near(origin(named("collision", "door_solid_0")), [0.39, 0.01, 0.0]);
        let limit = named("joint", "door_joint").children().find(|n| n.has_tag_name("limit")).unwrap();
        assert!((numbers(limit, "upper")[0] - 110_f64.to_radians()).abs() < 1e-9);
    }

    #[test]
    fn what_is_not_there_is_said() {
        let said = Urdf { object: "cupbord".into() }.files(&cupboard()).unwrap_err().to_string();
        assert_eq!(said, "urdf: the layout has no object `cupbord`; did you mean `cupboard`?");
    }
}
