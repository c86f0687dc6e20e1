//! A picture of one thing by itself: what a category looks like.

use crate::picture::{self, Picture};
use crate::{ExportError, Scene, SceneInput};
use scenelang_assets::{Asset, AssetRequest, furnish};
use scenelang_lang::library::usual_size;
use scenelang_lang::{Compiled, compile_text};
use scenelang_layout::{Convex, Layout, Moving, Part, Placement, Vec3, convex, rotation};
use std::path::Path;

/// A picture of a category in its usual size, PNG; `None`: the category is not known, or it cannot be drawn.
pub fn of_category(category: &str, pixels: [usize; 2]) -> Option<Vec<u8>> {
    let size = Some(Vec3::from(usual_size(category)?));
    let asset = furnish(&AssetRequest { name: "it", category, size, ..AssetRequest::default() });
    png(category, &asset, false, pixels).ok()
}

/// A picture of a piece of furniture, PNG, so many pixels wide and high. Open, it is drawn of its convex parts.
///
/// # Errors
/// It cannot be drawn.
pub fn png(noun: &str, asset: &Asset, open: bool, pixels: [usize; 2]) -> Result<Vec<u8>, ExportError> {
    let program = format!("object it;\nit.category <- \"{noun}\";\n");
    let Compiled { program: Some(program), sources, main, .. } =
        compile_text("thumbnail.scene", Path::new("thumbnail.scene"), &program, scenelang_lang::Options::default())
    else {
        return Err(ExportError::Format("picture", "its program does not compile".into()));
    };
    let (parts, scale) = if open { opened(asset) } else { (asset.parts.clone(), asset.size) };
    let placement = Placement {
        pos: Vec3::zeros(),
        rot: Vec3::zeros(),
        scale,
        parts,
        surface: asset.surface,
        joints: if open { Vec::new() } else { asset.joints.clone() },
    };
    let layout = Layout { objects: vec![("it".into(), placement)], ..Layout::default() };
    let scene = Scene::build(&SceneInput {
        name: "picture",
        program: &program,
        sources: &sources,
        files: &[main],
        layout: &layout,
        layout_text: "",
        report: &serde_json::json!({ "ok": true, "constraints": [], "diagnostics": [] }),
    });
    let scene = scene.map_err(|e| ExportError::Format("picture", e.to_string()))?;
    picture::png(&scene, Picture { size: pixels, ..Picture::default() })
}

/// Its parts with all that opens as far open as it is of use, and the size of the box around them, on which they stand.
fn opened(asset: &Asset) -> (Vec<Part>, Vec3) {
    let mut bodies: Vec<Convex> = asset.parts.iter().filter_map(Convex::from_part).collect();
    if bodies.len() < asset.parts.len() {
        // Parts without a volume: indices would mean others.
        return (asset.parts.clone(), asset.size);
    }
    for joint in &asset.joints {
        let known: Vec<usize> = joint.parts.iter().copied().filter(|&i| i < bodies.len()).collect();
        let still = rotation::matrix(Vec3::zeros());
        let moving = Moving::new(joint, known.iter().map(|&i| &bodies[i]), &still, &Vec3::zeros());
        for (i, body) in known.into_iter().zip(moving.opened(joint.useful.unwrap_or(joint.limits[1]))) {
            bodies[i] = body;
        }
    }
    let around = convex::aabb(&bodies);
    let middle = (around.min + around.max) / 2.0;
    let base = Vec3::new(middle.x, around.min.y, middle.z);
    let hull = |body: &Convex| Part::Hull { points: body.vertices().iter().map(|v| v - base).collect() };
    (bodies.iter().map(hull).collect(), around.max - around.min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_known_has_a_picture() {
        let chair = of_category("chair", [64, 48]).expect("a picture");
        assert!(chair.starts_with(b"\x89PNG"));
        assert_ne!(Some(chair), of_category("bed", [64, 48]));
        assert_eq!(of_category("xyzzy", [64, 48]), None);
    }

    /// Parts that do not fill the box of their object do not count, and the box would be drawn.
    #[test]
    fn what_stands_open_fills_a_box_that_is_deeper() {
        for category in ["fridge", "wardrobe", "door", "window"] {
            let size = usual_size(category).map(Vec3::from);
            let asset = furnish(&AssetRequest { name: "it", category, size, ..AssetRequest::default() });
            let (parts, scale) = opened(&asset);
            assert!(scale.z > asset.size.z + 0.3, "{category}: {scale:?}");
            let (pos, rot) = (Vec3::zeros(), Vec3::zeros());
            let placement = Placement { pos, rot, scale, parts, surface: None, joints: Vec::new() };
            assert!(convex::parts_fill_box(&placement), "{category}");
        }
    }
}
