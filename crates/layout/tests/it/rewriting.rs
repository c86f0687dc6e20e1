//! Layouts written back: nothing lost, nothing moved, the same text twice.

use proptest::prelude::*;
use scenelang_base::FileId;
use scenelang_layout::file::{read, to_json, write};
use scenelang_layout::{DecisionValue, Joint, Layout, Motion, Part, Placement, RegionPlacement, Vec3};

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![(-50i32..50).prop_map(|i| f64::from(i) / 8.0), -1e6..1e6f64, -1e-9..1e-9f64, Just(-0.0)]
}

fn triple() -> impl Strategy<Value = Vec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn extent() -> impl Strategy<Value = f64> {
    prop_oneof![1e-7..5.0f64, Just(1.0)]
}

fn extents() -> impl Strategy<Value = Vec3> {
    (extent(), extent(), extent()).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

fn part() -> impl Strategy<Value = Part> {
    let rot = || prop_oneof![Just(Vec3::zeros()), triple()];
    prop_oneof![
        (triple(), extents(), rot()).prop_map(|(pos, size, rot)| Part::Box { pos, size, rot }),
        (triple(), extent(), extent(), rot()).prop_map(|(pos, radius, height, rot)| Part::Cylinder {
            pos,
            radius,
            height,
            rot
        }),
        (0.1..2.0f64)
            .prop_map(|s| Part::Hull { points: vec![Vec3::zeros(), Vec3::x() * s, Vec3::y() * s, Vec3::z() * s] }),
    ]
}

fn placement() -> impl Strategy<Value = Placement> {
    let parts = (prop::collection::vec(part(), 0..4), any::<bool>(), axis(), limits(), prop::option::of(triple()));
    (triple(), triple(), extents(), parts, prop::option::of(number())).prop_map(
        |(pos, rot, scale, (parts, hinge, axis, limits, handle), surface)| Placement {
            pos,
            rot,
            scale,
            joints: joints(parts.len(), hinge, axis, limits, handle),
            parts,
            surface,
        },
    )
}

fn axis() -> impl Strategy<Value = Vec3> {
    prop_oneof![Just(Vec3::y()), triple().prop_map(|v| if v.norm() > 0.01 { v } else { Vec3::z() })]
}

fn limits() -> impl Strategy<Value = [f64; 2]> {
    (prop_oneof![Just(0.0), -10.0..0.0f64], 0.01..200.0f64).prop_map(|(low, high)| [low, high])
}

/// Every part but the first moves.
fn joints(parts: usize, hinge: bool, axis: Vec3, limits: [f64; 2], handle: Option<Vec3>) -> Vec<Joint> {
    let joint = |i: usize| Joint {
        name: format!("door {i}").into(),
        motion: if hinge { Motion::Hinge } else { Motion::Slide },
        axis,
        anchor: Vec3::new(0.25, 0.0, i as f64),
        limits,
        useful: (i == 1).then_some(limits[1] / 2.0),
        handle,
        parts: vec![i],
    };
    (1..parts).map(joint).collect()
}

fn region() -> impl Strategy<Value = RegionPlacement> {
    let vertices = prop::option::of((0.1..9.0f64).prop_map(|s| vec![[0.0, 0.0], [s, 0.0], [s, s], [0.0, 2.0 * s]]));
    (triple(), number(), extents(), vertices).prop_map(|(pos, y, scale, vertices)| RegionPlacement {
        pos,
        rot: Vec3::new(0.0, y, 0.0),
        scale,
        vertices,
    })
}

fn value() -> impl Strategy<Value = DecisionValue> {
    prop_oneof![
        number().prop_map(DecisionValue::Number),
        any::<bool>().prop_map(DecisionValue::Bool),
        triple().prop_map(|t| DecisionValue::Triple(t.into())),
    ]
}

/// Entries under names of which no two are alike.
fn named<T: std::fmt::Debug>(entry: impl Strategy<Value = T>) -> impl Strategy<Value = Vec<(String, T)>> {
    let name = prop_oneof!["[a-d]", "chair\\[[0-9]\\]", "\\PC{1,5}"];
    prop::collection::vec((name, entry), 0..4).prop_map(|mut list| {
        let mut seen = std::collections::HashSet::new();
        list.retain(|(name, _)| seen.insert(name.clone()));
        list
    })
}

fn layout() -> impl Strategy<Value = Layout> {
    let head = (prop::option::of(".{0,8}"), prop::option::of(any::<u64>()), any::<bool>());
    let object = (placement(), prop::option::of("[a-z ]{0,8}"));
    (head, named(object), named(region()), named(value()), named(number())).prop_map(
        |((scene, seed, incomplete), objects, regions, variables, draws)| Layout {
            scene,
            seed,
            incomplete,
            categories: objects
                .iter()
                .filter_map(|(name, (_, category))| Some((name.into(), category.as_ref()?.into())))
                .collect(),
            objects: objects.into_iter().map(|(n, (v, _))| (n.into(), v)).collect(),
            regions: regions.into_iter().map(|(n, v)| (n.into(), v)).collect(),
            variables: variables.into_iter().map(|(n, v)| (n.into(), v)).collect(),
            draws,
        },
    )
}

/// Layouts mean the same if they have the same entries: a rewrite keeps the old order.
fn sorted(mut layout: Layout) -> Layout {
    layout.objects.sort_by(|a, b| a.0.cmp(&b.0));
    layout.regions.sort_by(|a, b| a.0.cmp(&b.0));
    layout.variables.sort_by(|a, b| a.0.cmp(&b.0));
    layout.draws.sort_by(|a, b| a.0.cmp(&b.0));
    layout
}

proptest! {
    #[test]
    fn what_is_written_reads_back(layout in layout()) {
        let text = to_json(&layout, None);
        let back = read(&text, FileId(0));
        prop_assert!(back.diagnostics.iter().all(|d| !d.is_error()), "{text}\n{:?}", back.diagnostics);
        prop_assert_eq!(&back.layout, &layout);
        prop_assert_eq!(to_json(&back.layout, Some(&back.document)), text);
    }

    #[test]
    fn one_layout_over_another_leaves_what_it_does_not_know(old in layout(), new in layout()) {
        // Unknown members everywhere in the old file.
        let text = to_json(&old, None).replacen('{', "{ \"first\": [1.50, {}], ", 1);
        let text = text.replace("\"pos\": ", "\"tool\": {\"k\": 1E2}, \"pos\": ");
        let before = read(&text, FileId(0));
        let text = to_json(&new, Some(&before.document));
        let after = read(&text, FileId(0));
        prop_assert!(after.diagnostics.iter().all(|d| !d.is_error()), "{text}\n{:?}", after.diagnostics);
        // A category that the new layout does not know is a member like any other.
        let stays = |name: &str| new.object(name).is_some() && !new.categories.contains_key(name);
        let mut wanted = new.clone();
        wanted.categories.extend(old.categories.into_iter().filter(|(name, _)| stays(name)));
        prop_assert_eq!(sorted(after.layout), sorted(wanted));
        let first = text.starts_with("{\n  \"first\": [1.50, {}],\n");
        prop_assert!(first, "{text}");
        let kept = |name: &str| before.places.objects.get(name).is_some();
        for (name, _) in new.objects.iter().filter(|(n, _)| kept(n)) {
            prop_assert!(after.places.objects.get(name).unwrap().member("tool").is_some());
        }
    }
}

#[test]
fn a_rewrite_changes_what_changed() {
    let text = r#"{"made by": "hand", "objects": {
  "lamp": {"note": "mind the cable", "scale": [1,1,1], "pos": [0,0,0],
    "asset": {"file": "lamp.glb", "parts": [{"name": "all", "shape": "box", "pos": [0,0.5,0], "size": [1,1,1]}]}},
  "gone": {"pos": [0,0,0], "scale": [1,1,1]},
  "broken": {"pos": [0,0], "scale": [1,1,1]}},
 "format": "scenelang.layout/1", "variables": {"text": "not ours", "gap": 1.0e0}}"#;
    let mut file = read(text, FileId(0));
    file.layout.objects.retain(|(n, _)| n == "lamp");
    file.layout.objects[0].1.pos.x = 0.1 + 0.2;
    let new = Placement { parts: Vec::new(), joints: Vec::new(), ..file.layout.objects[0].1.clone() };
    file.layout.objects.push(("new".into(), new));
    file.layout.seed = Some(3);
    insta::assert_snapshot!(to_json(&file.layout, Some(&file.document)), @r#"
    {
      "made by": "hand",
      "objects": {
        "lamp": { "note": "mind the cable", "scale": [1, 1, 1], "pos": [0.30000000000000004, 0, 0], "rot": [0, 0, 0],
          "asset": { "file": "lamp.glb", "parts": [{ "name": "all", "shape": "box", "pos": [0, 0.5, 0], "size": [1, 1, 1] }] } },
        "broken": { "pos": [0, 0], "scale": [1, 1, 1] },
        "new": { "pos": [0.30000000000000004, 0, 0], "rot": [0, 0, 0], "scale": [1, 1, 1] }
      },
      "format": "scenelang.layout/1",
      "variables": {
        "text": "not ours",
        "gap": 1.0e0
      },
      "seed": 3
    }
    "#);
}

/// The block of the book that shows how layouts are written.
#[test]
fn layouts_are_written_as_the_book_shows() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../spec/src/layout-file.md");
    let page = std::fs::read_to_string(page).unwrap();
    let section = page.split("## How layouts are written").nth(1).unwrap();
    let block = section.split("```json layout\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let file = read(block, FileId(0));
    assert!(file.usable && file.diagnostics.is_empty(), "{:?}", file.diagnostics);
    assert_eq!(to_json(&file.layout, None), block);
}

/// A file of an earlier version: no categories, a part to a line, sixteen digits. Read as ever; written in the new form with
/// every number as it was.
#[test]
fn files_of_earlier_versions_stay_readable() {
    let old = include_str!("old/bedroom.layout.json");
    let file = read(old, FileId(0));
    assert!(file.usable && file.diagnostics.is_empty(), "{:?}", file.diagnostics);
    assert!(file.layout.categories.is_empty() && file.layout.objects.iter().any(|(_, p)| !p.parts.is_empty()));
    let new = to_json(&file.layout, Some(&file.document));
    let again = read(&new, FileId(0));
    assert_eq!(again.layout, file.layout);
    assert!(again.diagnostics.is_empty() && new.lines().count() * 4 < old.lines().count(), "{new}");
    let lines =
        |name: &str| new.lines().filter(|line| line.trim_start().starts_with(&format!("\"{name}\": {{"))).count();
    assert!(file.layout.objects.iter().all(|(name, _)| lines(name) == 1), "{new}");
}

#[test]
fn categories_are_written_first_and_kept() {
    let mut file = read(
        r#"{"format": "scenelang.layout/1", "objects": {
      "a": {"pos": [0.50, 0, 1e0], "category": 7, "scale": [1, 1, 1]},
      "b": {"pos": [0, 0, 0], "scale": [1, 1, 1], "asset": {"surface": 0.5}, "note": "mine"}}}"#,
        FileId(0),
    );
    assert!(file.diagnostics.is_empty() && file.layout.categories.is_empty(), "what is no text says nothing");
    file.layout.categories.insert("b".into(), "desk".into());
    file.layout.objects[0].1.pos.y = 0.25;
    insta::assert_snapshot!(to_json(&file.layout, Some(&file.document)), @r#"
    {
      "format": "scenelang.layout/1",
      "objects": {
        "a": { "pos": [0.50, 0.25, 1e0], "category": 7, "scale": [1, 1, 1], "rot": [0, 0, 0] },
        "b": { "category": "desk", "pos": [0, 0, 0], "scale": [1, 1, 1], "note": "mine", "rot": [0, 0, 0],
          "asset": { "surface": 0.5 } }
      }
    }
    "#);
}

#[test]
fn a_layout_that_no_file_can_hold_is_not_written() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.layout.json");
    let mut layout = Layout { seed: Some(1), ..Layout::default() };
    write(&scenelang_base::door::Door::of(&path), &path, &layout, None).unwrap();
    layout.draws.push(("d".to_owned(), f64::NAN));
    let error = write(&scenelang_base::door::Door::of(&path), &path, &layout, None).unwrap_err();
    assert!(error.to_string().contains("the draw `d`"), "{error}");
    assert_eq!(read(&std::fs::read_to_string(&path).unwrap(), FileId(0)).layout.seed, Some(1));
}

#[test]
fn joints_keep_what_is_not_ours() {
    let text = r#"{ "format": "scenelang.layout/1",
  "objects": {
    "box": { "pos": [0, 0, 0], "rot": [0, 0, 0], "scale": [1, 1, 1],
      "asset": {
        "parts": [
          { "shape": "box", "pos": [0, 0.5, -0.05], "size": [1, 1, 0.9] },
          { "shape": "box", "pos": [0, 0.5, 0.45], "size": [1, 1, 0.1] }
        ],
        "joints": [
          { "name": "door", "motion": "hinge", "parts": [1], "axis": [0, 2, 0], "anchor": [-0.5, 0, 0.5], "limits": [0, 110],
            "useful": 90, "handle": [0.4, 0.5, 0.5], "damping": 0.10 }
        ]
      } }
  }
}
"#;
    let mut file = read(text, FileId(0));
    assert!(file.diagnostics.is_empty(), "{:?}", file.diagnostics);
    let joint = &file.layout.objects[0].1.joints[0];
    assert_eq!((joint.motion, joint.useful, joint.parts.as_slice()), (Motion::Hinge, Some(90.0), &[1][..]));
    let same = to_json(&file.layout, Some(&file.document));
    assert_eq!(read(&same, FileId(0)).layout, file.layout);
    assert_eq!(to_json(&file.layout, Some(&read(&same, FileId(0)).document)), same, "the same text twice");
    file.layout.objects[0].1.joints[0].limits[1] = 95.0;
    let after = to_json(&file.layout, Some(&file.document));
    assert!(after.contains("\"limits\": [0, 95]") && after.contains("\"damping\": 0.10"), "{after}");
    file.layout.objects[0].1.joints.clear();
    assert!(!to_json(&file.layout, Some(&file.document)).contains("joints"));
}
