//! Scenes read back from USD: as they were where nobody changed them, also after USD's own library has written the file again;
//! else with what was changed and nothing else.

use crate::fixture::{parts, python_with, written};
use proptest::prelude::*;
use scenelang_base::FileId;
use scenelang_base::door::Door;
use scenelang_export::embedded::{self, Carrier, Embedded};
use scenelang_export::usd::{Usd, Usdz};
use scenelang_layout::{Layout, Vec3, file, rotation};
use std::fs;
use std::path::PathBuf;
use std::process::Command;

struct Written {
    folder: tempfile::TempDir,
    text: String,
}

impl Written {
    fn new(layout: &Layout) -> Self {
        let (folder, text) = written(layout, &[&Usd, &Usdz]);
        Self { folder, text }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn read(&self, name: &str) -> Embedded {
        let path = self.path(name);
        embedded::read(name, &path, Carrier::Usd, &Door::within(self.folder.path())).unwrap_or_else(|e| panic!("{e:?}"))
    }

    /// Replaces what follows the prim of a name.
    fn edit(&self, prim: &str, from: &str, to: &str) {
        let text = fs::read_to_string(self.path("room.usda")).unwrap();
        let at = text.find(&format!("def Xform \"{prim}\"")).unwrap();
        let begin = at + text[at..].find(from).unwrap_or_else(|| panic!("{from} is not there"));
        let changed = format!("{}{to}{}", &text[..begin], &text[begin + from.len()..]);
        fs::write(self.path("room.usda"), changed).unwrap();
    }

    /// The value of a property of a prim, as it stands in the file.
    fn value(&self, prim: &str, property: &str) -> String {
        let text = fs::read_to_string(self.path("room.usda")).unwrap();
        let rest = &text[text.find(&format!("def Xform \"{prim}\"")).unwrap()..];
        let line = rest.lines().find(|line| line.trim_start().starts_with(property)).unwrap();
        line.trim_start().to_owned()
    }
}

fn said(found: &Embedded) -> Vec<&str> {
    found.changes.iter().map(|change| change.message.as_str()).collect()
}

fn layout(text: &str) -> Layout {
    file::read(text, FileId(0)).layout
}

/// The name of a prim.
fn prim(name: &str) -> String {
    name.replace('[', "_").replace(']', "")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_nobody_changed_comes_back_and_what_moved_is_what_differs(
        poses in prop::collection::vec(([-9.0..9.0, 0.0..4.0, -9.0..9.0], [0.0..360.0, 0.0..360.0, 0.0..360.0]), 8),
        which in 0..8_usize,
        by in [-9.0..9.0, 0.0..4.0, -9.0..9.0],
        yaw in 1.0..359.0,
    ) {
        let mut scene = parts().layout;
        for ((_, place), (pos, rot)) in scene.objects.iter_mut().zip(&poses) {
            (place.pos, place.rot) = ((*pos).into(), (*rot).into());
        }
        let written = Written::new(&scene);
        for name in ["room.usda", "room.usdz"] {
            let found = written.read(name);
            prop_assert_eq!((&found.layout, said(&found)), (&written.text, Vec::new()));
        }
        let (name, place) = scene.objects[which].clone();
        let turned = rotation::matrix(Vec3::new(0.0, yaw, 0.0)) * rotation::matrix(place.rot);
        let [x, y, z, w] = rotation::quaternion(&turned);
        let to = place.pos + Vec3::from(by) + Vec3::new(0.0, 0.01, 0.0);
        let prim = prim(&name);
        let old = written.value(&prim, "double3 xformOp:translate");
        written.edit(&prim, &old, &format!("double3 xformOp:translate = ({}, {}, {})", -to.x, to.y, to.z));
        let old = written.value(&prim, "quatd xformOp:orient");
        written.edit(&prim, &old, &format!("quatd xformOp:orient = ({w}, {x}, {}, {})", -y, -z));
        let found = written.read("room.usda");
        prop_assert_eq!(found.changes.len(), 1, "{:?}", said(&found));
        for ((object, now), (_, before)) in layout(&found.layout).objects.iter().zip(&scene.objects) {
            if *object == name {
                prop_assert!((now.pos - to).amax() < 1e-5, "{} {}", now.pos, to);
                prop_assert!((rotation::matrix(now.rot) - turned).amax() < 1e-5);
            } else {
                prop_assert_eq!(now, before);
            }
        }
    }
}

#[test]
fn each_change_is_reported_by_name() {
    let changed = |prim: &str, from: &str, to: &str| {
        let written = Written::new(&parts().layout);
        written.edit(prim, from, to);
        said(&written.read("room.usda")).join("; ")
    };
    let origin = "xformOp:translate = (0, 0, 0)";
    assert_eq!(changed("table", origin, "xformOp:translate = (-0.3, 0, 0)"), "`table` was moved by +0.300 m along x");
    assert_eq!(changed("table", "\"table\" (", "\"Tisch\" ("), "`table` was renamed to `Tisch` in the scene");
    assert_eq!(changed("chair_0", "\"chair_0\" (", "\"chair\" ("), "`chair[0]` was renamed to `chair` in the scene");
    assert_eq!(
        changed("table", "kind = \"component\"", "active = false"),
        "`table` was removed from the scene or deactivated"
    );
    let order = "[\"xformOp:translate\", \"xformOp:orient\"]";
    let scaled = "[\"xformOp:translate\", \"xformOp:orient\", \"xformOp:scale\"]\n float3 xformOp:scale = (1, 2, 1)";
    assert_eq!(changed("table", order, scaled), "`table` was scaled by 1.000 × 2.000 × 1.000");
    let mirrored = scaled.replace("(1, 2, 1)", "(-1, 1, 1)");
    assert_eq!(changed("table", order, &mirrored), "`table` was sheared or mirrored; it is checked as it was exported");
    // Another program's way to say the same turn, and a matrix.
    let turned = "[\"xformOp:translate\", \"xformOp:rotateXYZ\"]\n float3 xformOp:rotateXYZ = (0, -90, 0)";
    assert_eq!(changed("table", order, turned), "`table` was turned by 90.0°");
    let matrix = "[\"xformOp:transform\"]\n matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0.5, 1) )";
    assert_eq!(changed("table", order, matrix), "`table` was moved by +0.500 m along z");
    let added = "def Mesh \"Suzanne\"\n{\n}\n\ndef Xform \"table\" (";
    assert_eq!(
        changed("table", "def Xform \"table\" (", added),
        "`Suzanne` was added; it is not in the program, so it is not checked"
    );
    let group = "def Xform \"table\" (";
    let within = "def Xform \"group\" {\n double3 xformOp:translate = (0, 0, 2)\n uniform token[] xformOpOrder = [\"xformOp:translate\"]\n }\n def Xform \"table\" (";
    assert!(changed("table", group, within).contains("`group` was added"));
    let wall = "def Xform \"hall_wall0\" (";
    let written = Written::new(&parts().layout);
    let text = fs::read_to_string(written.path("room.usda")).unwrap();
    assert!(text.contains("string part = \"wall\"") && text.contains("string id = \"chair[0]\""), "{wall}");
}

#[test]
fn a_copy_is_named_and_what_is_below_another_thing_is_judged_where_it_stands() {
    let written = Written::new(&parts().layout);
    let text = fs::read_to_string(written.path("room.usda")).unwrap();
    let at = text.find("        def Xform \"balloon\"").unwrap();
    let end = at + text[at..].find("\n        }\n").unwrap() + "\n        }\n".len();
    let balloon = &text[at..end];
    let copy = balloon.replace("\"balloon\" (", "\"balloon_1\" (");
    fs::write(written.path("room.usda"), format!("{}{copy}{}", &text[..end], &text[end..])).unwrap();
    assert_eq!(said(&written.read("room.usda")), ["`balloon` was copied as `balloon_1`; the copy is not checked"]);
    let group = format!(
        "        def Xform \"group\"\n        {{\n            double3 xformOp:translate = (0, 1, 0)\n            uniform token[] xformOpOrder = [\"xformOp:translate\"]\n{balloon}        }}\n"
    );
    fs::write(written.path("room.usda"), format!("{}{group}{}", &text[..at], &text[end..])).unwrap();
    let found = written.read("room.usda");
    let words = said(&found);
    assert!(
        words.contains(&"`balloon` was made a child of `group`; it is checked at its current position"),
        "{words:?}"
    );
    assert!(words.contains(&"`balloon` was moved by +1.000 m along y"), "{words:?}");
}

#[test]
fn what_is_no_scene_of_ours_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        embedded::read(name, &path, Carrier::Usd, &Door::within(folder.path())).unwrap_err().message
    };
    assert_eq!(refused("a.usda", b"#usda 1.0\n"), "a.usda is a USD file without an embedded program and layout");
    assert_eq!(
        refused("a.usda", b"#usda 1.0\ndef \"x\" {"),
        "a.usda cannot be read as USD: line 2: the file ends within a prim"
    );
    assert_eq!(refused("a.usd", b"PXR-USDC\0\0"), "a.usd is a binary USD layer, which is not supported");
    assert!(refused("a.usdz", b"PK\x03\x04").starts_with("a.usdz is not a USD package"));
    let written = Written::new(&parts().layout);
    let text = fs::read_to_string(written.path("room.usda")).unwrap();
    for k in 1..60 {
        let cut: String = text.chars().take(text.chars().count() * k / 60).collect();
        let path = folder.path().join("cut.usda");
        fs::write(&path, &cut).unwrap();
        assert!(embedded::read("cut.usda", &path, Carrier::Usd, &Door::within(folder.path())).is_err(), "{k}");
    }
    let inches = text.replace("metersPerUnit = 1\n", "metersPerUnit = 0.0254\n");
    assert!(refused("inches.usda", inches.as_bytes()).contains("no longer in metres"));
}

/// USD's own library reads the file, moves one thing, and writes all of it again.
#[test]
fn what_usd_core_has_written_again_is_read() {
    let Some(python) = python_with("pxr") else { return };
    let written = Written::new(&parts().layout);
    let script = "import sys\nfrom pxr import Usd, UsdGeom, Gf\ns = Usd.Stage.Open(sys.argv[1])\n\
                  s.GetRootLayer().Export(sys.argv[2])\n\
                  p = UsdGeom.Xformable(s.GetPrimAtPath('/World/Objects/chair_1'))\n\
                  p.GetPrim().GetAttribute('xformOp:translate').Set(Gf.Vec3d(-0.9, 0, 1.25))\n\
                  s.GetRootLayer().Export(sys.argv[3])\ns.Flatten().Export(sys.argv[4])\n";
    let files = ["room.usda", "again.usda", "moved.usda", "flat.usda"];
    let output = Command::new(python).args(["-c", script]).args(files.map(|name| written.path(name))).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let found = written.read("again.usda");
    assert_eq!((&found.layout, said(&found)), (&written.text, Vec::new()));
    for name in ["moved.usda", "flat.usda"] {
        let found = written.read(name);
        assert_eq!(said(&found), ["`chair[1]` was moved by +0.500 m along x, +0.250 m along z"], "{name}");
        assert_eq!(layout(&found.layout).object("chair[1]").unwrap().pos, Vec3::new(0.9, 0.0, 1.25));
    }
}
