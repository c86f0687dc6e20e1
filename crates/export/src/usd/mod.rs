//! USD: a layer as text (`NAME.usda`), and the same layer in a package (`NAME.usdz`). Metres, y up, front to +z; rigid bodies
//! with mass and convex colliders for engines that read UsdPhysics, materials and lights for those that draw, labels for
//! those that learn.
//!
//! USD is right-handed: x is negated. What stands still has colliders and no rigid body. Colliders have the purpose `guide`,
//! so that they are not drawn. Things that are equal share a prim of the abstract scope `Shapes` by reference.

mod joints;
mod looks;
#[cfg(not(target_family = "wasm"))]
mod package;
#[cfg(target_family = "wasm")]
mod package {
    //! No packages: see the manifest.

    /// Why there is none.
    pub(super) fn of(_: &[(String, Vec<u8>)]) -> Result<Vec<u8>, crate::ExportError> {
        Err(crate::ExportError::Format("usdz", "packages are not written in a browser".to_owned()))
    }
}
mod shapes;
mod text;

use crate::geometry::frame::Frame;
use crate::names::Identifiers;
use crate::numbers::numbers;
use crate::physics::{Body, GRAVITY, Inertia, Physics};
use crate::scene::view;
use crate::{ExportError, Exporter, OutFile, Scene};
use looks::Looks;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion};
use scenelang_layout::{Vec3, rotation};
use shapes::Shapes;
use text::{Usda, quaternion, quoted, scalar, schemas, triple};

/// `NAME.usda` and `textures/`.
#[derive(Clone, Copy, Debug)]
pub struct Usd;

/// `NAME.usdz`.
#[derive(Clone, Copy, Debug)]
pub struct Usdz;

impl Exporter for Usd {
    fn name(&self) -> &'static str {
        "usd"
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let mut files = vec![OutFile::new(format!("{}.usda", scene.name), layer(scene))];
        files.extend(looks::pictures(scene)?.into_iter().map(|(path, bytes)| OutFile::new(path, bytes)));
        Ok(files)
    }
}

impl Exporter for Usdz {
    fn name(&self) -> &'static str {
        "usdz"
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        // The layer is the first file of a package.
        let mut files = vec![("scene.usda".to_owned(), layer(scene).into_bytes())];
        files.extend(looks::pictures(scene)?);
        Ok(vec![OutFile::new(format!("{}.usdz", scene.name), package::of(&files)?)])
    }
}

const FRAME: Frame = Frame::YUp;
/// Nits of a lamp for each candela; it is a ball of the radius after it (metres). A room is lit, and no more.
const LAMP: f64 = 670.0;
const LAMP_RADIUS: f64 = 0.1;
/// Of the sun.
const SUN: f64 = 500.0;

fn layer(scene: &Scene) -> String {
    write_layer(scene, &Physics::of(scene))
}

pub(crate) fn write_layer(scene: &Scene, physics: &Physics<'_>) -> String {
    let mut out = Usda::new(&metadata(scene));
    let looks = Looks::of(scene);
    let shapes = Shapes::of(physics, &looks);
    shapes.write(&mut out);
    out.begin("def Xform", "World", &["kind = \"assembly\"".into(), schemas(&["MaterialBindingAPI"])]);
    out.line(&format!("rel material:binding:physics = <{SURFACE}>"));
    out.begin("def PhysicsScene", "PhysicsScene", &[]);
    out.line("vector3f physics:gravityDirection = (0, -1, 0)");
    out.line(&scalar("float physics:gravityMagnitude", GRAVITY));
    out.end();
    looks.write(&mut out, scene);
    let paths = paths(physics);
    for (folder, objects) in [("Building", false), ("Objects", true)] {
        out.begin("def Scope", folder, &["kind = \"group\"".into()]);
        for (index, body) in physics.bodies.iter().enumerate().filter(|(_, b)| b.as_object().is_some() == objects) {
            let others = physics.through.iter().filter(|[a, _]| *a == index).map(|&[_, b]| b);
            let through: Vec<String> = others.flat_map(|b| joints::paths(&physics.bodies[b], &paths[b])).collect();
            let through: Vec<&str> = through.iter().map(String::as_str).collect();
            write_body(&mut out, body, &paths[index], &through, shapes.of_body(index));
        }
        out.end();
    }
    lights(&mut out, scene);
    out.end();
    out.finish()
}

/// The physical material of everything.
const SURFACE: &str = "/World/Looks/Friction";

fn metadata(scene: &Scene) -> Vec<String> {
    let mut own = vec![
        format!("        string layout = {}", quoted(&scene.layout_text)),
        format!("        string spec = {}", quoted(scene.main_text())),
        format!("        string version = {}", quoted(env!("CARGO_PKG_VERSION"))),
    ];
    if let Some(imports) = scene.imports() {
        own.insert(0, format!("        string imports = {}", quoted(&imports.to_string())));
    }
    let lines = ["customLayerData = {".into(), "    dictionary scenelang = {".into()]
        .into_iter()
        .chain(own)
        .chain(["    }".into(), "}".into()]);
    let stage = [
        "defaultPrim = \"World\"".into(),
        format!("doc = {}", quoted(&format!("{}, written by scenelang", scene.name))),
        "kilogramsPerUnit = 1".into(),
        "metersPerUnit = 1".into(),
        "upAxis = \"Y\"".into(),
    ];
    lines.chain(stage).collect()
}

/// Where the prim of each body is.
fn paths(physics: &Physics<'_>) -> Vec<String> {
    let (mut objects, mut building) = (Identifiers::default(), Identifiers::default());
    let path = |body: &Body<'_>| match body.as_object() {
        Some(object) => format!("/World/Objects/{}", objects.take(&object.name)),
        None => format!("/World/Building/{}", building.take(body.name)),
    };
    physics.bodies.iter().map(path).collect()
}

/// What is after the last slash of a path.
fn leaf(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

fn write_body(out: &mut Usda, body: &Body<'_>, path: &str, through: &[&str], shape: shapes::Use<'_>) {
    let base = Piece { inertia: body.inertia.as_ref().filter(|_| body.loose), through, shape };
    let mut apis = vec!["SemanticsLabelsAPI:category", "SemanticsLabelsAPI:instance"];
    let mut metadata = own(body, leaf(path));
    metadata.extend([format!("displayName = {}", quoted(body.name)), "kind = \"component\"".into()]);
    let whole = body.moving.is_empty();
    if whole {
        apis.extend(base.apis());
        metadata.extend(base.reference());
    }
    metadata.push(schemas(&apis));
    out.begin("def Xform", leaf(path), &metadata);
    out.line(&format!("token[] semantics:labels:category = [{}]", quoted(body.category())));
    out.line(&format!("token[] semantics:labels:instance = [{}]", quoted(body.name)));
    place(out, &body.pos, &body.axes, None);
    if whole {
        base.write(out);
    } else {
        joints::write(out, path, &base, &body.moving);
    }
    out.end();
}

/// By what a body is known again when the file is read back: as metadata, a line each.
fn own(body: &Body<'_>, prim: &str) -> Vec<String> {
    let said = match body.as_object() {
        Some(object) => vec![("id", object.name.as_str()), ("prim", prim)],
        None => vec![("part", body.category())],
    };
    let said = said.into_iter().map(|(key, value)| format!("        string {key} = {}", quoted(value)));
    let begin = ["customData = {".into(), "    dictionary scenelang = {".into()];
    begin.into_iter().chain(said).chain(["    }".into(), "}".into()]).collect()
}

/// What is rigid.
struct Piece<'a> {
    /// Of what is loose.
    inertia: Option<&'a Inertia>,
    /// What it does not push, by path.
    through: &'a [&'a str],
    shape: shapes::Use<'a>,
}

impl Piece<'_> {
    /// The schemas that its prim needs.
    fn apis(&self) -> Vec<&'static str> {
        let body: &[&str] = if self.inertia.is_some() { &["PhysicsRigidBodyAPI", "PhysicsMassAPI"] } else { &[] };
        let pairs: &[&str] = if self.through.is_empty() { &[] } else { &["PhysicsFilteredPairsAPI"] };
        [body, pairs].concat()
    }

    /// Where its shape comes from, if it is not its own.
    fn reference(&self) -> Option<String> {
        match self.shape {
            shapes::Use::Shared(path, _) => Some(format!("prepend references = <{path}>")),
            shapes::Use::Own(..) => None,
        }
    }

    /// What stands in its prim.
    fn write(&self, out: &mut Usda) {
        if let Some(inertia) = self.inertia {
            mass(out, inertia);
        }
        if !self.through.is_empty() {
            let targets: Vec<String> = self.through.iter().map(|path| format!("<{path}>")).collect();
            out.line(&format!("prepend rel physics:filteredPairs = [{}]", targets.join(", ")));
        }
        if let shapes::Use::Own(shape) = &self.shape {
            shape.write(out);
        }
    }
}

/// The transform of a prim.
fn place(out: &mut Usda, pos: &Vec3, axes: &Matrix3<f64>, scale: Option<&Vec3>) {
    out.line(&format!("double3 xformOp:translate = {}", triple(&FRAME.point(*pos))));
    out.line(&format!("quatd xformOp:orient = {}", quaternion(FRAME.quaternion(axes))));
    if let Some(scale) = scale {
        out.line(&format!("double3 xformOp:scale = {}", triple(scale)));
    }
    let order = if scale.is_some() { ", \"xformOp:scale\"" } else { "" };
    out.line(&format!("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"{order}]"));
}

fn mass(out: &mut Usda, inertia: &Inertia) {
    let eigen = FRAME.tensor(&inertia.tensor).symmetric_eigen();
    let mut axes = eigen.eigenvectors;
    if axes.determinant() < 0.0 {
        axes.column_mut(2).neg_mut();
    }
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    out.line(&scalar("float physics:mass", inertia.mass));
    out.line(&format!("point3f physics:centerOfMass = {}", triple(&FRAME.point(inertia.center))));
    // Moments of small things are small: no figure may be lost.
    let moments: Vec<String> = eigen.eigenvalues.iter().map(|v| v.max(0.0).to_string()).collect();
    out.line(&format!("float3 physics:diagonalInertia = ({})", moments.join(", ")));
    out.line(&format!("quatf physics:principalAxes = {}", quaternion([turn.i, turn.j, turn.k, turn.w])));
}

/// A colour in linear light.
fn linear(color: [f32; 3]) -> String {
    let components = color.map(|c| (crate::glb::linear(c) * 1e6).round() / 1e6);
    format!("({})", numbers(components, ", "))
}

fn lights(out: &mut Usda, scene: &Scene) {
    out.begin("def Scope", "Lights", &[]);
    let mut names = Identifiers::default();
    out.begin("def DistantLight", &names.take("sun"), &[]);
    out.line("float inputs:angle = 0.53");
    out.line(&scalar("float inputs:intensity", SUN));
    // Lights of USD shine along −z.
    let turn = UnitQuaternion::rotation_between(&-Vec3::z(), &FRAME.point(view::SUN)).unwrap_or_default();
    out.line(&format!("quatd xformOp:orient = {}", quaternion([turn.i, turn.j, turn.k, turn.w])));
    out.line("uniform token[] xformOpOrder = [\"xformOp:orient\"]");
    out.end();
    for lamp in &scene.lamps {
        out.begin("def SphereLight", &names.take(&lamp.name), &[format!("displayName = {}", quoted(&lamp.name))]);
        out.line(&format!("color3f inputs:color = {}", linear(lamp.color)));
        out.line(&scalar("float inputs:intensity", (LAMP * lamp.candela).round()));
        out.line(&scalar("float inputs:radius", LAMP_RADIUS));
        place(out, &lamp.pos, &rotation::matrix(Vec3::zeros()), None);
        out.end();
    }
    out.end();
}
