//! `check`: planted faults are all found, and nothing is found in what the furniture library draws.

use crate::made::{Mesh, block, card, furniture, usual, write};
use scenelang_assets::{categories, family_of};
use scenelang_catalogue::{Checked, check};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use tempfile::tempdir;

/// What is found, file by file: codes and messages.
fn found(folder: &Path) -> BTreeMap<String, Vec<String>> {
    let said = |c: Checked| {
        let findings = c.findings.iter().map(|d| format!("{} {}", d.code, d.message)).collect();
        (c.file, findings)
    };
    check(folder, &usual).unwrap().into_iter().map(said).collect()
}

/// A noun for each family, the first that a size is known of.
fn families() -> Vec<&'static str> {
    let mut seen = BTreeSet::new();
    let sized = categories().filter(|c| usual(c).is_some());
    sized.filter(|c| family_of(c, "").is_some_and(|family| seen.insert(family))).collect()
}

#[test]
fn nothing_is_found_in_the_furniture_library() {
    let folder = tempdir().unwrap();
    let families = families();
    assert!(families.len() > 120, "{}", families.len());
    for category in &families {
        let asset = furniture(category);
        write(folder.path(), &format!("{category}.glb"), &Mesh::of(&asset).glb(), &card(category, &asset.size));
    }
    let found = found(folder.path());
    assert_eq!(found.len(), families.len());
    let alarms: Vec<_> = found.into_iter().filter(|(_, findings)| !findings.is_empty()).collect();
    assert!(alarms.is_empty(), "{alarms:#?}");
}

/// A table as a single piece: a profile of top and two legs, carried along its depth.
fn table_of_one_piece() -> Mesh {
    let profile =
        [[-0.6, 0.0], [-0.55, 0.0], [-0.55, 0.7], [0.55, 0.7], [0.55, 0.0], [0.6, 0.0], [0.6, 0.75], [-0.6, 0.75]];
    let caps = [[0, 1, 2], [0, 2, 7], [2, 3, 7], [3, 6, 7], [3, 5, 6], [3, 4, 5]];
    Mesh::extruded(&profile, &caps, 0.8)
}

#[test]
fn planted_faults_are_all_found() {
    let folder = tempdir().unwrap();
    let families = families();
    let mut planted = Vec::new();
    for i in 0..500 {
        let category = families[i % families.len()];
        let asset = furniture(category);
        let good = card(category, &asset.size);
        let with = |key: &str, value: Value| {
            let mut card = good.clone();
            card[key] = value;
            card
        };
        let without = |key: &str| {
            let mut card = good.clone();
            card.as_object_mut().unwrap().remove(key);
            card
        };
        let mesh = Mesh::of(&asset);
        let bytes = mesh.glb();
        let volume = asset.size.product();
        let (bytes, card, code) = match i % 10 {
            0 => {
                let mut open = mesh;
                let at = 3 * (i * 7 % (open.indices.len() / 3));
                open.indices.drain(at..at + 3);
                (open.glb(), good, "W0701")
            }
            1 => (mesh.map(|p| p.map(|x| 100.0 * x)).glb(), without("mass"), "W0702"),
            2 => (bytes, without("front"), "W0703"),
            3 => (mesh.map(|[x, y, z]| [x, y - 0.3, z]).glb(), good, "W0704"),
            4 => (table_of_one_piece().glb(), card("table", &usual("table").unwrap()), "W0705"),
            5 => (bytes, with("mass", json!(if i % 20 == 5 { 20_000.0 * volume } else { 0.2 * volume })), "W0706"),
            6 => (bytes, without("licence"), "W0707"),
            7 => (bytes[..bytes.len() - 1 - i].to_vec(), good, "E0701"),
            8 => {
                let mut strange = mesh;
                let at = i % strange.positions.len();
                strange.positions[at][2] = f32::NAN;
                (strange.glb(), good, "E0701")
            }
            _ => (bytes, with("front", json!("north")), "E0705"),
        };
        let name = format!("{i:03}.glb");
        write(folder.path(), &name, &bytes, &card);
        planted.push((name, code));
    }
    let found = found(folder.path());
    for (name, code) in planted {
        let codes: Vec<&str> = found[&name].iter().map(|said| &said[..5]).collect();
        assert_eq!(codes, [code], "{name}: {:?}", found[&name]);
    }
}

#[test]
fn findings_say_how_much_and_what_to_do() {
    let folder = tempdir().unwrap();
    let mut sheet = block(1.0, 0.75, 1.0);
    sheet.indices.truncate(33);
    let table = |more: Value| {
        let mut card = json!({ "category": "table", "front": "+z", "licence": "CC0-1.0" });
        card.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        card
    };
    write(folder.path(), "a.glb", &sheet.glb(), &table(json!({})));
    write(folder.path(), "b.glb", &block(120.0, 75.0, 80.0).glb(), &table(json!({})));
    write(folder.path(), "c.glb", &block(1.0, 0.75, 1.0).glb(), &table(json!({ "size": [1.0, 0.75, 2.0] })));
    write(folder.path(), "d.glb", &block(450.0, 900.0, 450.0).glb(), &table(json!({ "category": "gizmo" })));
    write(
        folder.path(),
        "e.glb",
        &block(1.0, 0.75, 1.0).map(|[x, y, z]| [x, y + 0.1, z]).glb(),
        &table(json!({ "mass": 7000 })),
    );
    write(folder.path(), "f.glb", &table_of_one_piece().glb(), &table(json!({ "mass": -1 })));
    let said: Vec<String> = check(folder.path(), &usual)
        .unwrap()
        .into_iter()
        .flat_map(|c| {
            c.findings.into_iter().map(move |d| format!("{} {} {}; {}", c.file, d.code, d.message, d.notes[0]))
        })
        .collect();
    assert_eq!(
        said,
        [
            "a.glb W0701 its mesh is not closed: 3 edges have only one triangle; close the holes, or merge vertices with the same position",
            "b.glb W0702 its longest side is 120 m; the usual size of \"table\" is 1.4 m; its unit may be centimetres",
            "c.glb W0702 the proportions of the size on its card differ from those of its mesh by a factor of 2.00; give its width, height and depth with the front facing +z",
            "d.glb W0702 its longest side is 900 m; its unit may be millimetres",
            "e.glb W0704 its lowest point is 0.1 m above the origin of the file; it is placed on the floor; if it should hang, give its height in the program",
            "e.glb W0706 its mass is 7000 kg, 9333 kg/m³: heavier than a block of steel of the same size; give the mass in kilograms on its card: `\"mass\": 7.5`",
            "f.glb W0705 it is one piece that fills 14 % of its convex hull; it is cut into 3 parts at the most suitable positions; build it from several convex pieces that do not share edges",
            "f.glb W0706 its mass is -1 kg, which is not possible; give the mass in kilograms on its card: `\"mass\": 7.5`",
        ]
    );
}
