//! Things that can be opened: a prim for what stays, one for each piece that moves, and a joint between them.

use super::text::{Usda, quaternion, scalar, schemas, triple};
use super::{FRAME, Piece, shapes};
use crate::names::Identifiers;
use crate::physics::{Body, Joint, Moving};
use nalgebra::UnitQuaternion;
use scenelang_layout::{Motion, Vec3};

/// The prim of what stays.
const BASE: &str = "base";

/// The prims of a body that are rigid, by path.
pub(super) fn paths(body: &Body<'_>, path: &str) -> Vec<String> {
    if body.moving.is_empty() {
        return vec![path.to_owned()];
    }
    let names = names(&body.moving).into_iter().map(|[piece, _]| piece);
    std::iter::once(BASE.to_owned()).chain(names).map(|name| format!("{path}/{name}")).collect()
}

/// What the prims of pieces and of their joints are called.
fn names(moving: &[Moving]) -> Vec<[String; 2]> {
    let mut names = Identifiers::default();
    names.take(BASE);
    let both = |piece: &Moving| {
        let own = names.take(piece.name.rsplit('/').next().unwrap_or_default());
        let joint = names.take(&format!("{own}_joint"));
        [own, joint]
    };
    moving.iter().map(both).collect()
}

/// Writes the pieces of a body into its prim, which is at a path.
pub(super) fn write(out: &mut Usda, path: &str, base: &Piece<'_>, moving: &[Moving]) {
    let (through, looks) = (base.through, base.shape.looks());
    piece(out, BASE, base);
    for ([name, of_joint], moving) in names(moving).iter().zip(moving) {
        let shape = shapes::Use::Own(shapes::Own { looks, drawn: &moving.drawn, geoms: &moving.geoms });
        piece(out, name, &Piece { inertia: Some(&moving.inertia), through, shape });
        joint(out, of_joint, [&format!("{path}/{BASE}"), &format!("{path}/{name}")], &moving.joint);
    }
}

fn piece(out: &mut Usda, name: &str, piece: &Piece<'_>) {
    let apis = piece.apis();
    let schemas = (!apis.is_empty()).then(|| schemas(&apis));
    out.begin("def Xform", name, &piece.reference().into_iter().chain(schemas).collect::<Vec<_>>());
    piece.write(out);
    out.end();
}

/// A joint between two prims, which have the same frame.
fn joint(out: &mut Usda, name: &str, bodies: [&str; 2], joint: &Joint) {
    // Angles are in degrees, also those of the damping.
    let (kind, drive, scale) = match joint.motion {
        Motion::Hinge => ("def PhysicsRevoluteJoint", "angular", 1_f64.to_degrees()),
        Motion::Slide => ("def PhysicsPrismaticJoint", "linear", 1.0),
    };
    out.begin(kind, name, &[schemas(&[&format!("PhysicsDriveAPI:{drive}")])]);
    out.line(&scalar(&format!("float drive:{drive}:physics:damping"), joint.damping / scale));
    out.line(&scalar(&format!("float drive:{drive}:physics:stiffness"), 0.0));
    out.line("uniform token physics:axis = \"X\"");
    let axis = joint.axis_in(FRAME);
    // To point the other way any axis across will do.
    let turn = UnitQuaternion::rotation_between(&Vec3::x(), &axis)
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vec3::y_axis(), std::f64::consts::PI));
    for (side, body) in bodies.iter().enumerate() {
        out.line(&format!("rel physics:body{side} = <{body}>"));
        out.line(&format!("point3f physics:localPos{side} = {}", triple(&FRAME.point(joint.anchor))));
        let rot = quaternion([turn.i, turn.j, turn.k, turn.w]);
        out.line(&format!("quatf physics:localRot{side} = {rot}"));
    }
    out.line(&scalar("float physics:lowerLimit", joint.range[0] * scale));
    out.line(&scalar("float physics:upperLimit", joint.range[1] * scale));
    out.end();
}

#[cfg(test)]
mod tests {
    use crate::physics::Physics;
    use crate::physics::fixture::cupboard;
    use crate::usd::write_layer;

    #[test]
    fn what_opens_is_a_body_of_its_own_and_limits_are_in_degrees() {
        let scene = cupboard();
        let layer = write_layer(&scene, &Physics::of(&scene));
        for line in [
            "def PhysicsRevoluteJoint \"door_joint\" (",
            "rel physics:body0 = </World/Objects/cupboard/base>",
            "rel physics:body1 = </World/Objects/cupboard/door>",
            "float physics:upperLimit = 110",
            "def PhysicsPrismaticJoint \"drawer_joint\" (",
            "float physics:upperLimit = 0.3",
        ] {
            assert!(layer.contains(line), "{line} is not in {layer}");
        }
        assert_eq!(layer.matches("PhysicsRigidBodyAPI").count(), 3);
    }
}
