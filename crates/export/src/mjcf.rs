//! MJCF, the scenes of the physics engine MuJoCo: one file that needs no other, and beside it a JSON file that says what
//! each body is.
//!
//! MuJoCo is right-handed with z up: y and z change places. What stands still is a body without a joint, what is loose has a
//! free joint. Every shape is a geom; a hull is a mesh of its corners. Times, contacts and friction are set so that what was
//! verified to stand stays where it is.

use crate::geometry::frame::Frame;
use crate::loss::Lost;
use crate::numbers::{coarse, number, spaced};
use crate::physics::{Body, FRICTION, GRAVITY, Geom, Inertia, Joint, Physics, Shape};
use crate::scene::{View, view};
use crate::xml::{Attribute, Xml};
use crate::{ExportError, Exporter, OutFile, Scene, textures};
use scenelang_layout::{Aabb, Convex, Motion, Vec3};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// `NAME.mjcf.xml` and `NAME.mjcf.json`.
#[derive(Clone, Copy, Debug)]
pub struct Mjcf;

impl Mjcf {
    /// The path of the model, relative to the output folder.
    pub fn model(scene: &Scene) -> String {
        format!("{}.mjcf.xml", scene.name)
    }
}

impl Exporter for Mjcf {
    fn name(&self) -> &'static str {
        "mjcf"
    }

    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let physics = Physics::of(scene);
        Ok(vec![
            OutFile::new(Self::model(scene), document(scene, &physics)),
            OutFile::new(format!("{}.mjcf.json", scene.name), format!("{:#}\n", metadata(scene, &physics))),
        ])
    }

    fn lost(&self, scene: &Scene) -> Vec<Lost> {
        let textures = (!textures::used(scene).is_empty()).then_some(Lost::Textures);
        std::iter::once(Lost::Meshes).chain(textures).chain([Lost::Program]).collect()
    }
}

const FRAME: Frame = Frame::ZUp;
/// Seconds: contacts as stiff as those below need it.
const TIMESTEP: f64 = 0.002;
/// Time constant (seconds) and damping ratio of contacts.
const SOLREF: &str = "0.005 1";
/// Impedance of contacts: what is at rest sinks by less than a tenth of a millimetre.
const SOLIMP: &str = "0.95 0.99 0.0005";
/// Elliptic cones of friction need this, or things creep.
const IMPRATIO: &str = "10";
/// Geoms of this group are hidden in MuJoCo's viewer until asked for: ceilings, which would hide the room.
const HIDDEN: &str = "4";

fn document(scene: &Scene, physics: &Physics<'_>) -> Vec<u8> {
    let mut xml = Xml::new();
    xml.begin("mujoco", &[("model", &scene.name)]);
    xml.comment("Metres, kilograms, seconds; z up. Written by scenelang; NAME.mjcf.json describes each body.");
    xml.empty("compiler", &[("angle", "radian"), ("autolimits", "true"), ("balanceinertia", "true")]);
    xml.empty(
        "option",
        &[
            ("timestep", &number(TIMESTEP)),
            ("integrator", "implicitfast"),
            ("cone", "elliptic"),
            ("impratio", IMPRATIO),
            ("gravity", &spaced([0.0, 0.0, -GRAVITY])),
        ],
    );
    statistic(&mut xml, scene);
    xml.begin("default", &[]);
    let friction = spaced([FRICTION, 0.005, 0.0001]);
    xml.empty("geom", &[("solref", SOLREF), ("solimp", SOLIMP), ("friction", &friction)]);
    xml.end();
    let meshes = assets(&mut xml, scene, physics);
    xml.begin("worldbody", &[]);
    lights(&mut xml, scene);
    camera(&mut xml, scene);
    for body in &physics.bodies {
        write_body(&mut xml, body, scene, &meshes);
    }
    xml.end();
    contacts(&mut xml, physics);
    xml.end();
    xml.finish()
}

/// Bodies that do not push each other: by permission, and the pieces of one thing.
fn contacts(xml: &mut Xml, physics: &Physics<'_>) {
    let names = |body: usize| {
        let body = &physics.bodies[body];
        std::iter::once(own(body.name)).chain(body.moving.iter().map(|m| m.name.as_str())).collect::<Vec<_>>()
    };
    let mut pairs: Vec<[&str; 2]> = Vec::new();
    for &[a, b] in &physics.through {
        let others = names(b);
        pairs.extend(names(a).into_iter().flat_map(|a| others.iter().map(move |b| [a, *b])));
    }
    for index in 0..physics.bodies.len() {
        let pieces = names(index);
        pairs.extend((0..pieces.len()).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| [pieces[j], pieces[i]]));
    }
    if pairs.is_empty() {
        return;
    }
    xml.begin("contact", &[]);
    for [a, b] in pairs {
        xml.empty("exclude", &[("body1", a), ("body2", b)]);
    }
    xml.end();
}

/// What MuJoCo's viewer frames at first.
fn statistic(xml: &mut Xml, scene: &Scene) {
    let points = scene.shells.iter().flat_map(|s| &s.group.positions).map(|p| Vec3::from(p.map(f64::from)));
    let Aabb { min, max } = Aabb::of(points.chain(scene.objects.iter().map(|o| o.place.pos)));
    if min.x <= max.x {
        let center = spaced(FRAME.point((min + max) / 2.0).iter().copied());
        xml.empty("statistic", &[("center", &center), ("extent", &number(((max - min).norm() / 2.0).max(0.5)))]);
    }
}

/// Hulls by their corners: name of the mesh. Equal hulls are one mesh.
type Meshes = BTreeMap<Vec<u64>, String>;

fn key(hull: &Convex) -> Vec<u64> {
    hull.vertices().iter().flat_map(|v| [v.x, v.y, v.z].map(f64::to_bits)).collect()
}

/// Materials and meshes.
fn assets(xml: &mut Xml, scene: &Scene, physics: &Physics<'_>) -> Meshes {
    xml.begin("asset", &[]);
    for surface in &scene.surfaces {
        let [r, g, b] = surface.color.map(coarse);
        let emission = if surface.emissive.is_some() { "1" } else { "0" };
        xml.empty(
            "material",
            &[
                ("name", &surface.name),
                ("rgba", &spaced([r, g, b, coarse(surface.opacity)])),
                ("emission", emission),
                ("specular", &number(coarse(1.0 - surface.roughness) / 2.0)),
                ("shininess", &number(coarse(1.0 - surface.roughness))),
                ("metallic", &number(coarse(surface.metallic))),
                ("roughness", &number(coarse(surface.roughness))),
            ],
        );
    }
    let mut meshes = Meshes::new();
    for body in &physics.bodies {
        let pieces = body.moving.iter().map(|m| (m.name.as_str(), &m.geoms));
        let geoms = std::iter::once((body.name, &body.geoms)).chain(pieces);
        for (owner, i, geom) in
            geoms.flat_map(|(owner, geoms)| geoms.iter().enumerate().map(move |(i, g)| (owner, i, g)))
        {
            let Shape::Hull(hull) = &geom.shape else { continue };
            meshes.entry(key(hull)).or_insert_with(|| {
                let name = format!("{owner}/{i}");
                let corners = spaced(hull.vertices().iter().flat_map(|&v| FRAME.point(v).data.0[0]));
                xml.empty("mesh", &[("name", &name), ("inertia", "convex"), ("vertex", &corners)]);
                name
            });
        }
    }
    xml.end();
    meshes
}

fn lights(xml: &mut Xml, scene: &Scene) {
    let sun = spaced(FRAME.point(view::SUN.normalize()).iter().copied());
    // All lamps together are as bright as a few; shadows of a sun would fall from the ceiling.
    let each = number((0.4 * (3.0 / scene.lamps.len().max(1) as f64).min(1.0) * 1e3).round() / 1e3);
    let each = format!("{each} {each} {each}");
    let shine = [("specular", "0.1 0.1 0.1"), ("castshadow", "false")];
    let mut light = |own: [Attribute<'_>; 4]| xml.empty("light", &[&own[..], &shine].concat());
    light([("name", "sun"), ("directional", "true"), ("dir", &sun), ("diffuse", "0.4 0.4 0.4")]);
    for lamp in &scene.lamps {
        let pos = spaced(FRAME.point(lamp.pos).iter().copied());
        light([("name", &lamp.name), ("pos", &pos), ("dir", "0 0 -1"), ("diffuse", &each)]);
    }
}

/// The view of the pictures.
fn camera(xml: &mut Xml, scene: &Scene) {
    const ASPECT: f64 = 4.0 / 3.0;
    let view = View::of(scene, ASPECT);
    let axes = view.axes();
    let across = [axes.column(0), axes.column(1)].map(|c| FRAME.point(c.into_owned()));
    xml.empty(
        "camera",
        &[
            ("name", "view"),
            ("pos", &spaced(FRAME.point(view.eye).iter().copied())),
            ("xyaxes", &spaced(across.iter().flat_map(|v| v.iter().copied()))),
            ("fovy", &number(view.fov)),
        ],
    );
}

/// What a body is called: as in the program, but for the one name that MuJoCo's own body has.
fn own(name: &str) -> &str {
    if name == "world" { "world:object" } else { name }
}

/// A quaternion in MuJoCo's order.
fn wxyz([x, y, z, w]: [f64; 4]) -> String {
    spaced([w, x, y, z])
}

fn write_body(xml: &mut Xml, body: &Body<'_>, scene: &Scene, meshes: &Meshes) {
    let pos = spaced(FRAME.point(body.pos).iter().copied());
    xml.begin("body", &[("name", own(body.name)), ("pos", &pos), ("quat", &wxyz(FRAME.quaternion(&body.axes)))]);
    if body.loose {
        xml.empty("freejoint", &[("name", own(body.name))]);
        if let Some(inertia) = &body.inertia {
            write_inertia(xml, inertia);
        }
    }
    let group = body.is_ceiling().then_some(HIDDEN);
    write_geoms(xml, body.name, &body.geoms, group, scene, meshes);
    for piece in &body.moving {
        // The frame is that of the body.
        xml.begin("body", &[("name", &piece.name)]);
        write_joint(xml, &piece.name, &piece.joint);
        write_inertia(xml, &piece.inertia);
        write_geoms(xml, &piece.name, &piece.geoms, None, scene, meshes);
        xml.end();
    }
    xml.end();
}

fn write_joint(xml: &mut Xml, name: &str, joint: &Joint) {
    let kind = match joint.motion {
        Motion::Hinge => "hinge",
        Motion::Slide => "slide",
    };
    xml.empty(
        "joint",
        &[
            ("name", name),
            ("type", kind),
            ("pos", &spaced(FRAME.point(joint.anchor).iter().copied())),
            ("axis", &spaced(joint.axis_in(FRAME).iter().copied())),
            ("range", &spaced(joint.range)),
            ("damping", &number(joint.damping)),
            ("frictionloss", &number(joint.friction)),
        ],
    );
}

fn write_geoms(xml: &mut Xml, owner: &str, geoms: &[Geom], group: Option<&str>, scene: &Scene, meshes: &Meshes) {
    for (i, geom) in geoms.iter().enumerate() {
        let name = format!("{owner}/{i}");
        let mut attributes: Vec<Attribute<'_>> = vec![("name", &name)];
        let place = [spaced(FRAME.point(geom.pos).iter().copied()), wxyz(FRAME.quaternion(&geom.axes))];
        let (kind, size) = form(geom, meshes);
        attributes.push(("type", kind));
        attributes.push((if kind == "mesh" { "mesh" } else { "size" }, &size));
        if kind != "mesh" {
            attributes.extend([("pos", place[0].as_str()), ("quat", place[1].as_str())]);
        }
        attributes.push(("material", &scene.surfaces[geom.surface].name));
        attributes.extend(group.map(|group| ("group", group)));
        xml.empty("geom", &attributes);
    }
}

/// Type of a geom, and its size or its mesh.
fn form(geom: &Geom, meshes: &Meshes) -> (&'static str, String) {
    match &geom.shape {
        Shape::Box(size) => ("box", spaced((FRAME.extents(*size) / 2.0).iter().copied())),
        Shape::Cylinder { radius, height } => ("cylinder", spaced([*radius, height / 2.0])),
        Shape::Hull(hull) => ("mesh", meshes.get(&key(hull)).cloned().unwrap_or_default()),
    }
}

fn write_inertia(xml: &mut Xml, inertia: &Inertia) {
    let t = FRAME.tensor(&inertia.tensor);
    let full = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|i| t[i]);
    // Moments of small things are small: no figure may be lost.
    let full = full.map(|v| (v + 0.0).to_string()).join(" ");
    let pos = spaced(FRAME.point(inertia.center).iter().copied());
    xml.empty("inertial", &[("pos", &pos), ("mass", &number(inertia.mass)), ("fullinertia", &full)]);
}

/// What the bodies are.
fn metadata(scene: &Scene, physics: &Physics<'_>) -> Value {
    let mut bodies = Map::new();
    for body in &physics.bodies {
        let mut entry = json!({ "category": body.category(), "static": !body.loose });
        match body.as_object() {
            Some(object) => {
                entry["id"] = json!(object.name);
                entry["label"] = json!(object.label);
            }
            None => entry["id"] = Value::Null,
        }
        if let Some(inertia) = &body.inertia {
            entry["mass"] = json!(inertia.mass);
        }
        bodies.insert(own(body.name).to_owned(), entry);
        for piece in &body.moving {
            let (id, category, mass) = (body.name, body.category(), piece.inertia.mass);
            let entry = json!({ "category": category, "static": false, "id": id, "joint": piece.name, "mass": mass });
            bodies.insert(piece.name.clone(), entry);
        }
    }
    json!({
        "format": "scenelang.mjcf/1",
        "version": env!("CARGO_PKG_VERSION"),
        "model": scene.name,
        "frame": "right-handed, z up, metres; a point (x, y, z) of the layout is (x, z, y) here",
        "bodies": bodies,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::fixture::cupboard;

    #[test]
    fn what_opens_hangs_on_its_body_by_a_joint() {
        let scene = cupboard();
        let physics = Physics::of(&scene);
        let text = String::from_utf8(document(&scene, &physics)).unwrap();
        let xml = roxmltree::Document::parse(&text).unwrap();
        let joints: Vec<_> = xml.descendants().filter(|n| n.has_tag_name("joint")).collect();
        let told: Vec<_> =
            joints.iter().map(|j| ["name", "type", "pos", "axis"].map(|key| j.attribute(key).unwrap())).collect();
        let door = ["cupboard/door", "hinge", "-0.39 0.23 0.65", "0 0 1"];
        assert_eq!(told, [door, ["cupboard/drawer", "slide", "0 0 0", "0 1 0"]]);
        let hung =
            |j: &roxmltree::Node<'_, '_>| j.parent().unwrap().parent().unwrap().attribute("name") == Some("cupboard");
        assert!(joints.iter().all(hung));
        assert_eq!(text.matches("<exclude").count(), 3, "the pieces of one thing do not push each other");
        assert_eq!(metadata(&scene, &physics)["bodies"]["cupboard/door"]["joint"], "cupboard/door");
    }
}
