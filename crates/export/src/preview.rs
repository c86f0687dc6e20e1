//! One page that needs nothing else: the room in 3D (or, where the viewer was not built, its plan) beside every
//! constraint with its margin.
//!
//! The viewer is a script of its own (the `viewer` folder) that the build embeds where it is there; page and viewer
//! agree on the data only: `scenelang.preview/1`.

use crate::scene::{Lamp, Object, Opening, Shell};
use crate::{ExportError, Exporter, OutFile, Scene, glb, plan};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use nalgebra::Matrix3;
use scenelang_layout::Vec3;
use serde_json::{Value, json};
use std::hash::{DefaultHasher, Hash, Hasher};

/// `preview.html`.
#[derive(Clone, Copy, Debug)]
pub struct Preview;

/// The viewer's bundle; empty where it was not built.
const VIEWER: &str = include_str!(concat!(env!("OUT_DIR"), "/viewer.js"));
const FALLBACK: &str = include_str!("../web/fallback.js");
const TEMPLATE: &str = include_str!("../web/preview.html");
const STYLE: &str = include_str!("../web/preview.css");

impl Exporter for Preview {
    fn name(&self) -> &'static str {
        "preview"
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let viewer = (!VIEWER.is_empty()).then_some(VIEWER);
        Ok(vec![OutFile::new("preview.html", page(scene, viewer)?)])
    }
}

/// Whether pages show the room in 3D: whether the viewer was there when this program was built.
pub fn has_viewer() -> bool {
    !VIEWER.is_empty()
}

/// The viewer's script, for who serves a page of its own; `None` where it was not there when this program was built.
pub fn viewer() -> Option<&'static str> {
    has_viewer().then_some(VIEWER)
}

/// The page, with the viewer's script or without.
fn page(scene: &Scene, viewer: Option<&str>) -> Result<String, ExportError> {
    // Only the viewer needs the geometry.
    let glb = if viewer.is_some() { STANDARD.encode(glb::in_pieces(scene)?) } else { String::new() };
    // In a script element `<` could begin its end; in JSON it can be written otherwise.
    let mut data = data(scene, &glb, true);
    data["report"] = scene.report.clone();
    let data = data.to_string().replace('<', "\\u003c");
    let script = viewer.unwrap_or(FALLBACK).replace("</script", "<\\/script");
    let title = scene.name.replace('&', "&amp;").replace('<', "&lt;");
    let style = if viewer.is_some() { "" } else { STYLE };
    let mut out = String::with_capacity(data.len() + script.len() + 4096);
    let mut rest = TEMPLATE;
    for (mark, content) in [("{{title}}", &*title), ("{{style}}", style), ("{{data}}", &data), ("{{script}}", &script)]
    {
        let Some((before, after)) = rest.split_once(mark) else { continue };
        out.push_str(before);
        out.push_str(content);
        rest = after;
    }
    out.push_str(rest);
    Ok(out)
}

/// What a page is told that is shown the scene again after every change: in its geometry all objects stand unturned at the
/// origin, and `shape` names it. So it stays the same when things are only moved, and is not sent (`glb` is null) to who has
/// the one that is `known`. A page that shows geometry needs no `plan`, which takes as long as the rest.
///
/// # Errors
/// The geometry cannot be written.
pub fn live(mut scene: Scene, known: Option<&str>, plan: bool) -> Result<Value, ExportError> {
    let mut told = data(&scene, "", plan);
    told["report"] = std::mem::take(&mut scene.report);
    let lights = scene.objects.iter().flat_map(|object| &object.lights);
    for (lamp, light) in scene.lamps.iter_mut().filter(|lamp| lamp.object.is_some()).zip(lights) {
        lamp.pos = light.pos;
    }
    for object in &mut scene.objects {
        (object.place.pos, object.axes) = (Vec3::zeros(), Matrix3::identity());
    }
    // What it was made of is for files.
    scene.program.clear();
    scene.layout_text.clear();
    let shape = shape(&scene);
    told["glb"] =
        if known == Some(shape.as_str()) { Value::Null } else { STANDARD.encode(glb::in_pieces(&scene)?).into() };
    told["shape"] = shape.into();
    Ok(told)
}

/// Names the geometry of a scene by what it is made from, so that nothing has to be written to know whether it is the same.
fn shape(scene: &Scene) -> String {
    let mut hasher = DefaultHasher::new();
    scene.name.hash(&mut hasher);
    for object in &scene.objects {
        (&object.name, &object.category, &object.label, object.look).hash(&mut hasher);
        for joint in &object.place.joints {
            (&joint.name, &joint.parts).hash(&mut hasher);
            joint.axis.iter().for_each(|x| x.to_bits().hash(&mut hasher));
        }
    }
    for Shell { name, region, role, group, .. } in &scene.shells {
        (name, region, std::mem::discriminant(role), &group.indices).hash(&mut hasher);
        format!("{:?}", scene.surfaces[group.surface]).hash(&mut hasher);
        let vertices = group.positions.iter().chain(&group.normals).flatten().chain(group.uvs.iter().flatten());
        vertices.for_each(|x| x.to_bits().hash(&mut hasher));
    }
    for Lamp { name, object, pos, range, color, candela } in &scene.lamps {
        (name, object, color.map(f32::to_bits)).hash(&mut hasher);
        pos.iter().chain([range, candela]).for_each(|x| x.to_bits().hash(&mut hasher));
    }
    format!("{:016x}", hasher.finish())
}

/// What the page is told, `scenelang.preview/1`, but for the report, which is most of it and need not be copied by all.
/// Places are in the layout's frame; `constraints` are rows of the report.
fn data(scene: &Scene, glb: &str, plan: bool) -> Value {
    let triple = |v: Vec3| [v.x, v.y, v.z];
    let objects: Vec<Value> = scene
        .objects
        .iter()
        .map(|o| {
            json!({
                "name": o.name, "label": o.label, "category": o.category,
                "pos": triple(o.place.pos), "rot": triple(o.place.rot), "scale": triple(o.place.scale),
                "constraints": o.rows, "joints": joints(o),
            })
        })
        .collect();
    let regions: Vec<Value> = scene
        .regions
        .iter()
        .map(|r| {
            let vertices: Vec<[f64; 2]> = r.prism.polygon.corners().iter().map(|c| [c.x, c.y]).collect();
            json!({ "name": r.name, "vertices": vertices, "floor": r.prism.floor, "ceiling": r.prism.ceiling })
        })
        .collect();
    json!({
        "format": "scenelang.preview/1", "name": scene.name, "glb": glb,
        "plan": if plan { plan::svg(scene) } else { String::new() },
        "report": null, "objects": objects, "regions": regions,
    })
}

/// The movable parts of an object, in its own frame; each is a node of the geometry.
fn joints(object: &Object) -> Vec<Value> {
    let told = |opening: &Opening| {
        let joint = object.place.joints.get(opening.joint)?;
        let (axis, anchor) = (joint.axis.normalize(), joint.anchor);
        let swept: Vec<[f64; 2]> = opening.swept.iter().map(|p| [p.x, p.y]).collect();
        Some(json!({
            "name": joint.name.as_str(), "motion": joint.motion.name(), "axis": [axis.x, axis.y, axis.z],
            "anchor": [anchor.x, anchor.y, anchor.z], "amount": opening.amount, "blocked": opening.blocked,
            "swept": swept,
        }))
    };
    object.openings.iter().filter_map(told).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SceneInput;
    use scenelang_base::SourceMap;
    use scenelang_lang::Program;
    use scenelang_layout::Layout;

    fn scene() -> Scene {
        let report = json!({
            "ok": true, "constraints": [], "diagnostics": [{ "message": "</script><b>", "severity": "warning" }]
        });
        Scene::build(&SceneInput {
            name: "a<b>&c",
            program: &Program::default(),
            sources: &SourceMap::new(),
            files: &[],
            layout: &Layout::default(),
            layout_text: "{}",
            report: &report,
        })
        .unwrap()
    }

    /// What the page's script will read.
    fn read_back(page: &str) -> Value {
        let start = page.split("id=\"scenelang-data\">").nth(1).unwrap();
        serde_json::from_str(start.split("</script>").next().unwrap()).unwrap()
    }

    #[test]
    fn data_survives_whatever_it_says() {
        let page = page(&scene(), None).unwrap();
        assert_eq!(page.matches("</script>").count(), 2, "nothing in the data ends its element");
        let data = read_back(&page);
        assert_eq!(data["report"]["diagnostics"][0]["message"], "</script><b>");
        assert_eq!(data["name"], "a<b>&c");
        assert!(page.contains("<title>a&lt;b>&amp;c</title>"));
        assert!(data["plan"].as_str().unwrap().starts_with("<svg"));
    }

    #[test]
    fn what_moves_is_a_node_below_its_object_and_the_page_knows_its_joint() {
        let scene = crate::physics::fixture::cupboard();
        let data = read_back(&page(&scene, Some("start()")).unwrap());
        let [door, drawer] = &data["objects"][0]["joints"].as_array().unwrap()[..] else { panic!("two joints") };
        assert_eq!((&door["name"], &door["motion"], &door["amount"]), (&json!("door"), &json!("hinge"), &json!(110.0)));
        assert_eq!((&drawer["motion"], &drawer["swept"].as_array().map(Vec::len)), (&json!("slide"), &Some(4)));
        let glb = STANDARD.decode(data["glb"].as_str().unwrap()).unwrap();
        let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
        let document: Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
        let nodes = document["nodes"].as_array().unwrap();
        let hung: Vec<&Value> = nodes[0]["children"].as_array().unwrap().iter().collect();
        let tags: Vec<&Value> =
            hung.iter().map(|n| &nodes[n.as_u64().unwrap() as usize]["extras"]["scenelang"]["joint"]).collect();
        assert_eq!(tags, ["door", "drawer"]);
        let roots = document["scenes"][0]["nodes"].as_array().unwrap();
        assert!(hung.iter().all(|n| !roots.contains(n)), "a node has one parent");
    }

    #[test]
    fn the_viewer_gets_the_geometry_and_the_page_without_it_says_how_to_get_it() {
        let with = page(&scene(), Some("start('</script>')")).unwrap();
        assert!(with.contains("start('<\\/script>')"));
        let glb = STANDARD.decode(read_back(&with)["glb"].as_str().unwrap()).unwrap();
        assert!(glb.starts_with(b"glTF"));
        let without = page(&scene(), None).unwrap();
        assert_eq!(read_back(&without)["glb"], "");
        assert!(without.contains("npm ci && npm run build"));
    }
}
