//! SDF, the worlds of the simulator Gazebo: a model for each body with a link for each piece, the meshes beside it.
//!
//! Right-handed with z up: y and z of the scene change places, in the meshes as well. What stands still is a static model.
//! Names are plain identifiers, since topics are made of them; `scenelang:id` has the name of the program.

use crate::geometry::frame::Frame;
use crate::geometry::mesh::MeshGroup;
use crate::loss::Lost;
use crate::names::{Identifiers, Stems};
use crate::numbers::{coarse, number, spaced};
use crate::obj::{Materials, Mesh};
use crate::physics::{Body, FRICTION, GRAVITY, Geom, Inertia, Joint, Physics, Shape};
use crate::scene::view;
use crate::xml::Xml;
use crate::{ExportError, Exporter, OutFile, Scene};
use nalgebra::Matrix3;
use scenelang_layout::{Motion, Vec3};

/// The `sdf/` folder: `NAME.sdf` and `meshes/`.
#[derive(Clone, Copy, Debug)]
pub struct Sdf;

impl Exporter for Sdf {
    fn name(&self) -> &'static str {
        "sdf"
    }

    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let physics = Physics::of(scene);
        let mut meshes = Meshes::new(scene);
        let document = document(scene, &physics, &mut meshes);
        let stem = Stems::default().take(&scene.name);
        let mut files = vec![OutFile::new(format!("sdf/{stem}.sdf"), document)];
        files.extend(meshes.files);
        files.extend(meshes.materials.files(scene, "sdf/meshes", LIBRARY)?);
        Ok(files)
    }

    fn lost(&self, scene: &Scene) -> Vec<Lost> {
        let physics = Physics::of(scene);
        let pairs: Vec<_> = physics.through.iter().map(|&pair| physics.names(pair).map(str::to_owned)).collect();
        let overlaps = (!pairs.is_empty()).then_some(Lost::Overlaps(pairs));
        overlaps.into_iter().chain([Lost::Program]).collect()
    }
}

const FRAME: Frame = Frame::ZUp;
/// The file of all materials.
const LIBRARY: &str = "materials.mtl";
/// Both Gazebo Classic and the present Gazebo read it.
const VERSION: &str = "1.7";
/// The namespace of what is ours in the file; readers pass over it.
const NAMESPACE: &str = "https://github.com/scenelang/scenelang";

fn document(scene: &Scene, physics: &Physics<'_>, meshes: &mut Meshes) -> Vec<u8> {
    let mut names = Identifiers::default();
    // The frame that all others are in has this name.
    names.take("world");
    let mut xml = Xml::new();
    xml.begin("sdf", &[("version", VERSION), ("xmlns:scenelang", NAMESPACE)]);
    xml.begin("world", &[("name", &Identifiers::default().take(&scene.name))]);
    xml.begin("physics", &[("name", "default"), ("type", "ode")]);
    xml.text("max_step_size", "0.001");
    xml.text("real_time_factor", "1");
    xml.end();
    xml.text("gravity", &spaced([0.0, 0.0, -GRAVITY]));
    lights(&mut xml, scene, &mut names);
    for body in &physics.bodies {
        model(&mut xml, body, &names.take(body.name), meshes);
    }
    xml.end();
    xml.end();
    xml.finish()
}

fn lights(xml: &mut Xml, scene: &Scene, names: &mut Identifiers) {
    let sun = spaced(FRAME.point(view::SUN.normalize()).iter().copied());
    xml.begin("light", &[("name", &names.take("sun")), ("type", "directional")]);
    xml.text("cast_shadows", "false");
    xml.text("pose", "0 0 10 0 0 0");
    xml.text("diffuse", "0.6 0.6 0.6 1");
    xml.text("specular", "0.1 0.1 0.1 1");
    xml.text("direction", &sun);
    xml.end();
    for lamp in &scene.lamps {
        xml.begin("light", &[("name", &names.take(&lamp.name)), ("type", "point")]);
        xml.text("cast_shadows", "false");
        xml.text("pose", &pose(&lamp.pos, &Matrix3::identity()));
        let [r, g, b] = lamp.color.map(|c| coarse(0.8 * c));
        xml.text("diffuse", &format!("{r} {g} {b} 1"));
        xml.text("specular", "0.1 0.1 0.1 1");
        xml.begin("attenuation", &[]);
        xml.text("range", &number(lamp.range));
        xml.text("constant", "0.5");
        xml.text("linear", "0.1");
        xml.text("quadratic", "0.02");
        xml.end();
        xml.end();
    }
}

/// Position, and roll, pitch and yaw in radians: turns about x, then y, then z of the frame outside.
fn pose(pos: &Vec3, axes: &Matrix3<f64>) -> String {
    let m = FRAME.tensor(axes);
    let pitch = (-m[(2, 0)]).atan2(m[(0, 0)].hypot(m[(1, 0)]));
    // Straight up or down only the difference of roll and yaw is determined.
    let (roll, yaw) = if m[(0, 0)].hypot(m[(1, 0)]) > 1e-9 {
        (m[(2, 1)].atan2(m[(2, 2)]), m[(1, 0)].atan2(m[(0, 0)]))
    } else {
        (0.0, (-m[(0, 1)]).atan2(m[(1, 1)]))
    };
    spaced(FRAME.point(*pos).iter().copied().chain([roll, pitch, yaw]))
}

fn model(xml: &mut Xml, body: &Body<'_>, name: &str, meshes: &mut Meshes) {
    xml.begin("model", &[("name", name)]);
    xml.text("scenelang:id", body.name);
    xml.text("scenelang:category", body.category());
    // In a model that is static no joint moves: what stays is then held by a joint.
    let held = !body.loose && !body.moving.is_empty();
    let still = !body.loose && !held;
    xml.text("static", if still { "true" } else { "false" });
    xml.text("pose", &pose(&body.pos, &body.axes));
    link(xml, "link", name, body.inertia.as_ref().filter(|_| !still), (&body.geoms, &body.drawn), meshes);
    if held {
        xml.begin("joint", &[("name", "held"), ("type", "fixed")]);
        xml.text("parent", "world");
        xml.text("child", "link");
        xml.end();
    }
    let mut names = Identifiers::default();
    names.take("link");
    names.take("held");
    for piece in &body.moving {
        let own = names.take(piece.name.rsplit('/').next().unwrap_or_default());
        link(xml, &own, &format!("{name}.{own}"), Some(&piece.inertia), (&piece.geoms, &piece.drawn), meshes);
        joint(xml, &names.take(&format!("{own}_joint")), &own, &piece.joint);
    }
    xml.end();
}

/// A link; what it is made of and what is seen of it. `file` is what its meshes are called.
fn link(
    xml: &mut Xml,
    name: &str,
    file: &str,
    inertia: Option<&Inertia>,
    (geoms, drawn): (&[Geom], &[MeshGroup]),
    meshes: &mut Meshes,
) {
    xml.begin("link", &[("name", name)]);
    if let Some(inertia) = inertia {
        inertial(xml, inertia);
    }
    for (i, geom) in geoms.iter().enumerate() {
        xml.begin("collision", &[("name", &format!("solid_{i}"))]);
        if !matches!(geom.shape, Shape::Hull(_)) {
            xml.text("pose", &pose(&geom.pos, &geom.axes));
        }
        geometry(xml, geom, &format!("{file}.solid_{i}"), meshes);
        friction(xml);
        xml.end();
    }
    if drawn.iter().any(|g| !g.indices.is_empty()) {
        xml.begin("visual", &[("name", "look")]);
        mesh(xml, &meshes.file(file, drawn));
        xml.end();
    }
    xml.end();
}

/// The joint of a link that moves, at a point of its axis.
fn joint(xml: &mut Xml, name: &str, child: &str, joint: &Joint) {
    let kind = match joint.motion {
        Motion::Hinge => "revolute",
        Motion::Slide => "prismatic",
    };
    xml.begin("joint", &[("name", name), ("type", kind)]);
    xml.text("parent", "link");
    xml.text("child", child);
    xml.text("pose", &pose(&joint.anchor, &Matrix3::identity()));
    xml.begin("axis", &[]);
    xml.text("xyz", &spaced(joint.axis_in(FRAME).iter().copied()));
    xml.begin("limit", &[]);
    xml.text("lower", &number(joint.range[0]));
    xml.text("upper", &number(joint.range[1]));
    xml.end();
    xml.begin("dynamics", &[]);
    xml.text("damping", &number(joint.damping));
    xml.text("friction", &number(joint.friction));
    xml.end();
    xml.end();
    xml.end();
}

fn inertial(xml: &mut Xml, inertia: &Inertia) {
    xml.begin("inertial", &[]);
    xml.text("pose", &pose(&inertia.center, &Matrix3::identity()));
    xml.text("mass", &number(inertia.mass));
    let tensor = FRAME.tensor(&inertia.tensor);
    xml.begin("inertia", &[]);
    for (tag, at) in
        [("ixx", (0, 0)), ("ixy", (0, 1)), ("ixz", (0, 2)), ("iyy", (1, 1)), ("iyz", (1, 2)), ("izz", (2, 2))]
    {
        // Moments of small things are small: no figure may be lost.
        xml.text(tag, &(tensor[at] + 0.0).to_string());
    }
    xml.end();
    xml.end();
}

fn geometry(xml: &mut Xml, geom: &Geom, name: &str, meshes: &mut Meshes) {
    match &geom.shape {
        Shape::Box(size) => {
            xml.begin("geometry", &[]);
            xml.begin("box", &[]);
            xml.text("size", &spaced(FRAME.extents(*size).iter().copied()));
            xml.end();
            xml.end();
        }
        Shape::Cylinder { radius, height } => {
            xml.begin("geometry", &[]);
            xml.begin("cylinder", &[]);
            xml.text("radius", &number(*radius));
            xml.text("length", &number(*height));
            xml.end();
            xml.end();
        }
        Shape::Hull(hull) => {
            let mut group = MeshGroup::new(geom.surface);
            group.solid(hull);
            let file = meshes.file(name, &[group]);
            mesh(xml, &file);
        }
    }
}

fn mesh(xml: &mut Xml, file: &str) {
    xml.begin("geometry", &[]);
    xml.begin("mesh", &[]);
    xml.text("uri", &format!("meshes/{file}"));
    xml.end();
    xml.end();
}

fn friction(xml: &mut Xml) {
    xml.begin("surface", &[]);
    xml.begin("friction", &[]);
    xml.begin("ode", &[]);
    xml.text("mu", &number(FRICTION));
    xml.text("mu2", &number(FRICTION));
    xml.end();
    xml.end();
    xml.end();
}

/// Files of meshes; equal ones are written once.
struct Meshes {
    materials: Materials,
    stems: Stems,
    files: Vec<OutFile>,
    /// What was written, and its file's name.
    written: Vec<(Vec<MeshGroup>, String)>,
}

impl Meshes {
    fn new(scene: &Scene) -> Self {
        let stems = Stems::default();
        Self { materials: Materials::of(scene), stems, files: Vec::new(), written: Vec::new() }
    }

    /// The file of some groups, named so if it is new.
    fn file(&mut self, name: &str, groups: &[MeshGroup]) -> String {
        if let Some((_, file)) = self.written.iter().find(|(known, _)| known == groups) {
            return file.clone();
        }
        let file = format!("{}.obj", self.stems.take(name));
        let mut mesh = Mesh::new(FRAME, &self.materials, LIBRARY);
        mesh.groups(groups, &Matrix3::identity(), &Vec3::zeros());
        self.files.push(OutFile::new(format!("sdf/meshes/{file}"), mesh.finish()));
        self.written.push((groups.to_vec(), file.clone()));
        file
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::fixture::cupboard;

    #[test]
    fn what_opens_is_a_link_with_a_joint_and_what_stands_still_is_held() {
        let mut scene = cupboard();
        scene.objects[0].body = crate::scene::Body::Static;
        let text = String::from_utf8(document(&scene, &Physics::of(&scene), &mut Meshes::new(&scene))).unwrap();
        let xml = roxmltree::Document::parse(&text).unwrap();
        let model = xml.descendants().find(|n| n.attribute("name") == Some("cupboard")).unwrap();
        let children = |tag: &'static str| model.children().filter(move |n| n.has_tag_name(tag));
        let links: Vec<_> = children("link").map(|n| n.attribute("name").unwrap()).collect();
        assert_eq!(links, ["link", "door", "drawer"]);
        let joints: Vec<_> =
            children("joint").map(|n| [n.attribute("name").unwrap(), n.attribute("type").unwrap()]).collect();
        assert_eq!(joints, [["held", "fixed"], ["door_joint", "revolute"], ["drawer_joint", "prismatic"]]);
        assert_eq!(children("static").next().unwrap().text(), Some("false"));
    }
}
