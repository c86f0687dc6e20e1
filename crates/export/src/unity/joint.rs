//! Joints of what moves against its object: hinges, and slides as configurable joints with one free direction. The fields are
//! those that Unity 2022.3 and 6000 share.

use super::tree::narrow;
use super::yaml::{Map, Yaml, local, map, none, vector};
use crate::physics::Joint;
use scenelang_layout::Vec3;

/// `PositiveInfinity` as Unity writes it: nothing breaks.
fn never() -> Yaml {
    Yaml::Word("Infinity".into())
}

/// The greatest force there is, as Unity writes it.
fn any_force() -> Yaml {
    Yaml::Word("3.4028233e+38".into())
}

fn connected(joint: &Joint, to: i64, there: Vec3) -> Map {
    map! {
        "m_ConnectedBody" => local(to),
        "m_ConnectedArticulationBody" => none(),
        "m_Anchor" => vector(narrow(joint.anchor)),
        "m_Axis" => vector(narrow(joint.axis)),
        "m_AutoConfigureConnectedAnchor" => 0,
        "m_ConnectedAnchor" => vector(narrow(there)),
    }
}

/// Piece and body do not collide: a closed piece overlaps the body.
fn ending() -> Map {
    map! {
        "m_BreakForce" => never(),
        "m_BreakTorque" => never(),
        "m_EnableCollision" => 0,
        "m_EnablePreprocessing" => 1,
        "m_MassScale" => 1,
        "m_ConnectedMassScale" => 1,
    }
}

/// A hinge on the body with the anchor `to`; its frame is that of the piece when closed. Limits are in degrees.
pub(super) fn hinge(joint: &Joint, to: i64) -> Map {
    let [min, max] = joint.range.map(|angle| angle.to_degrees() as f32);
    let mut fields = connected(joint, to, joint.anchor);
    fields.extend(map! {
        "m_UseSpring" => 1,
        "m_Spring" => map! { "spring" => 0, "damper" => joint.damping as f32, "targetPosition" => 0 },
        "m_UseMotor" => 0,
        "m_Motor" => map! { "targetVelocity" => 0, "force" => 0, "freeSpin" => 0 },
        "m_UseLimits" => 1,
        // Without this Unity cuts limits to ±177°.
        "m_ExtendedLimits" => i32::from(min < -177.0 || max > 177.0),
        "m_UseAcceleration" => 0,
        "m_Limits" => map! {
            "min" => min, "max" => max, "bounciness" => 0, "bounceMinVelocity" => 0.2, "contactDistance" => 0,
        },
    });
    fields.extend(ending());
    fields
}

/// A slide along the axis. Unity limits a distance to both sides, so the joint is about the middle of the range.
pub(super) fn slide(joint: &Joint, to: i64) -> Map {
    let [min, max] = joint.range;
    let mut fields = connected(joint, to, joint.anchor + joint.axis * ((min + max) / 2.0));
    let across = joint.axis.cross(&Vec3::ith(joint.axis.iamin(), 1.0)).normalize();
    fields.extend(map! {
        "serializedVersion" => 2,
        "m_SecondaryAxis" => vector(narrow(across)),
        "m_XMotion" => 1,
        "m_YMotion" => 0,
        "m_ZMotion" => 0,
        "m_AngularXMotion" => 0,
        "m_AngularYMotion" => 0,
        "m_AngularZMotion" => 0,
        "m_LinearLimitSpring" => map! { "spring" => 0, "damper" => 0 },
        "m_LinearLimit" => map! { "limit" => ((max - min) / 2.0) as f32, "bounciness" => 0, "contactDistance" => 0 },
        "m_TargetPosition" => vector([0.0; 3]),
        "m_TargetVelocity" => vector([0.0; 3]),
        "m_XDrive" => map! {
            "serializedVersion" => 3,
            "positionSpring" => 0,
            "positionDamper" => joint.damping as f32,
            "maximumForce" => any_force(),
        },
        "m_ConfiguredInWorldSpace" => 0,
        "m_SwapBodies" => 0,
    });
    fields.extend(ending());
    fields
}

#[cfg(test)]
mod tests {
    use crate::Exporter;
    use crate::physics::fixture::cupboard;
    use crate::unity::Unity;
    use scenelang_layout::Vec3;

    #[test]
    fn a_door_hangs_on_a_hinge_and_a_drawer_slides() {
        let mut scene = cupboard();
        scene.objects[0].place.joints[0].handle = Some(Vec3::new(0.3, 0.65, 0.26));
        let files = Unity::default().files(&scene).unwrap();
        let file = files.iter().find(|f| f.path.to_str().unwrap().ends_with(".unity")).unwrap();
        let text = std::str::from_utf8(&file.bytes).unwrap();
        let documents = |class: &str| text.split("--- !u!").filter(|d| d.starts_with(class)).collect::<Vec<_>>();
        let ([hinge], [slide]) = (&documents("59 ")[..], &documents("153 ")[..]) else { panic!("{text}") };
        for line in ["m_Axis: {x: 0, y: -1, z: 0}", "m_Anchor: {x: -0.39, y: 0.65, z: 0.23}", "min: 0", "max: 110"] {
            assert!(
                hinge.contains(&format!("    {line}\n")) || hinge.contains(&format!("  {line}\n")),
                "{line}: {hinge}"
            );
        }
        for line in
            ["m_Axis: {x: 0, y: 0, z: 1}", "m_ConnectedAnchor: {x: 0, y: 0, z: 0.15}", "limit: 0.15", "m_XMotion: 1"]
        {
            assert!(slide.contains(&format!("  {line}\n")), "{line}: {slide}");
        }
        let bodies = documents("54 ");
        assert_eq!(bodies.len(), 3, "the case, the door and the drawer");
        let base = super::super::ids::anchor("object:cupboard", "Rigidbody");
        assert!([hinge, slide].iter().all(|joint| joint.contains(&format!("m_ConnectedBody: {{fileID: {base}}}\n"))));
        let mass = |d: &&str| d.split("m_Mass: ").nth(1).unwrap().lines().next().unwrap().parse::<f64>().unwrap();
        let sum: f64 = bodies.iter().map(mass).sum();
        assert!((sum - scene.objects[0].mass).abs() < 1e-4 * sum);
        let owner = |d: &str| d.split("m_GameObject: ").nth(1).unwrap().lines().next().unwrap().to_owned();
        let solid: Vec<String> =
            documents("65 ").iter().filter(|d| d.contains("m_IsTrigger: 0")).map(|d| owner(d)).collect();
        assert!(bodies.iter().all(|body| solid.iter().filter(|o| **o == owner(body)).count() == 1), "a part each");
        let handles = documents("65 ").iter().filter(|d| d.contains("m_IsTrigger: 1")).count();
        assert_eq!(handles, 1, "only the door has a handle");
        // What the scripts know of them.
        let scripts: Vec<&str> = documents("114 ").into_iter().filter(|d| d.contains("  motion: ")).collect();
        let [door, drawer] = &scripts[..] else { panic!("a script on each piece") };
        for (script, id, motion, max) in [(door, "cupboard/door", 0, "110"), (drawer, "cupboard/drawer", 1, "0.3")] {
            for line in [format!("id: {id}"), format!("motion: {motion}"), format!("max: {max}")] {
                assert!(script.contains(&format!("  {line}\n")), "{line}: {script}");
            }
        }
        let grip = super::super::ids::anchor("object:cupboard/joint0/handle", "Transform");
        assert!(door.contains(&format!("handle: {{fileID: {grip}}}")) && drawer.contains("handle: {fileID: 0}"));
    }
}
