//! Rooms and layouts of LayoutVLM.
//!
//! Frame: right-handed, z up, metres, degrees. (x, y, z) there is (x, z, y) in a layout: seen from above the room is the same.
//! A thing that is not turned faces +x; it stands where the middle of its box is. The box of an asset is width, depth and
//! height; where the program of LayoutVLM has prepared a room (its assets have `asset_var_name`), x and y have changed places.

use crate::cursor::{At, Found};
use crate::house::{Holds, House, HouseObject, HouseRoom, Open, standing, usual, usually};
use crate::names::category;
use crate::sizes::Sizes;
use nalgebra::Matrix3;
use scenelang_layout::Vec3;
use scenelang_layout::file::json::Json;

const TASK: &[&str] = &["boundary", "assets", "task_description", "layout_criteria", "layout"];
const ASSET: &[&str] = &[
    "path",
    "assetMetadata",
    "category",
    "description",
    "uid",
    "count",
    "instance_var_name",
    "asset_var_name",
    "instance_idx",
    "annotations",
    "onCeiling",
    "onFloor",
    "onWall",
    "onObject",
    "frontView",
    "position",
    "rotation",
    "scale",
];
const POSE: &[&str] = &["position", "rotation", "scale", "assetMetadata", "category", "onCeiling", "onWall"];

/// A room with its assets, where they stand if that is said.
pub(crate) fn task(at: &At<'_>, sizes: &Sizes) -> Found<House> {
    let mut house = House::default();
    house.rest.of(at, "", TASK);
    house.rooms.push(room(&at.need("boundary")?)?);
    let placed = at.maybe("layout")?;
    for (id, asset) in at.need("assets")?.members()? {
        house.rest.of(&asset, "assets.*.", ASSET);
        let pose = match &placed {
            Some(placed) => placed.maybe(id)?,
            None => asset.maybe("position")?.map(|_| asset.clone()),
        };
        match pose {
            Some(pose) => thing(id, &pose, Some(&asset), sizes, &mut house)?,
            None => house.note(Open::Nowhere, id),
        }
    }
    Ok(house)
}

/// A layout, in its room where that is known.
pub(crate) fn poses(at: &At<'_>, of: Option<&At<'_>>, sizes: &Sizes) -> Found<House> {
    let mut house = House::default();
    let mut assets = None;
    if let Some(of) = of {
        house.rooms.push(room(&of.need("boundary")?)?);
        assets = Some(of.need("assets")?);
    }
    for (id, pose) in at.members()? {
        house.rest.of(&pose, "*.", POSE);
        let asset = assets.as_ref().map(|assets| assets.maybe(id)).transpose()?.flatten();
        thing(id, &pose, asset.as_ref(), sizes, &mut house)?;
    }
    Ok(house)
}

fn room(at: &At<'_>) -> Found<HouseRoom> {
    let vertices = at.need("floor_vertices")?;
    let mut corners = Vec::new();
    let mut floor = 0.0;
    for corner in vertices.items()? {
        let numbers: Vec<f64> = corner.items()?.iter().map(At::number).collect::<Found<_>>()?;
        match numbers[..] {
            [x, y] => corners.push([x, y]),
            [x, y, z] => {
                corners.push([x, y]);
                floor = z;
            }
            _ => return corner.fail(scenelang_base::codes::E0504, "a corner of the floor is two or three numbers"),
        }
    }
    let height = at.maybe("wall_height")?.map(|at| at.length()).transpose()?;
    Ok(HouseRoom {
        id: "room".into(),
        kind: "room".into(),
        corners: vertices.outline(&corners)?,
        floor,
        height,
        polygon: None,
    })
}

fn thing(id: &str, pose: &At<'_>, asset: Option<&At<'_>>, sizes: &Sizes, house: &mut House) -> Found<()> {
    let words = asset.map(|asset| asset.maybe_name("category")).transpose()?.flatten();
    let words = words.or(pose.maybe_name("category")?).unwrap_or_else(|| by_id(id));
    let uid = asset.map(|asset| asset.maybe_name("uid")).transpose()?.flatten();
    let name = uid.unwrap_or_else(|| id.rsplit_once('-').map_or(id, |(uid, _)| uid).to_owned());
    let model = sizes.get(&name).or_else(|| sizes.get(id));
    let category = match model.and_then(|model| model.category.as_deref()) {
        Some(known) if usual(&category(&words)).is_none() => category(known),
        _ => category(&words),
    };
    let own = match asset.map(measured).transpose()?.flatten() {
        Some(own) => Some(own),
        None => measured(pose)?,
    };
    // Lists of models are in the frame of Unity: y is up there.
    let told = own.or_else(|| model.map(|model| model.size));
    let position = pose.need("position")?;
    let numbers: Vec<f64> = position.items()?.iter().map(At::number).collect::<Found<_>>()?;
    let floor = house.rooms.first().map_or(0.0, |room| room.floor);
    let size = match (told, usual(&category)) {
        (Some(size), _) => size.component_mul(&scale(pose)?),
        (None, Some(usual)) => {
            house.note(Open::Usual, id);
            let usual = usual.component_mul(&scale(pose)?);
            numbers.get(2).map_or(usual, |middle| standing(usual, *middle, floor))
        }
        (None, None) => {
            house.note(Open::Sizeless, id);
            return Ok(());
        }
    };
    let axes = turned(pose)?;
    let center = match numbers[..] {
        [x, y, z] => Vec3::new(x, z, y),
        // Two numbers: it stands on the floor.
        [x, y] => Vec3::new(x, floor + size.y / 2.0, y),
        _ => return position.fail(scenelang_base::codes::E0504, "a position is two or three numbers"),
    };
    let said = |key: &str| -> Found<bool> {
        let own = pose.maybe(key)?.or(asset.map(|asset| asset.maybe(key)).transpose()?.flatten());
        Ok(own.is_some_and(|at| at.node.value == Json::Bool(true)))
    };
    let bottom = center.y - size.y / 2.0;
    let holds = match (said("onCeiling")?, said("onWall")? && bottom > floor + 0.05) {
        (true, _) => Holds::Ceiling,
        (_, true) => Holds::Wall,
        _ => usually(&category, bottom, floor),
    };
    let room = (!house.rooms.is_empty()).then_some(0);
    house.things.push(HouseObject {
        id: id.into(),
        category,
        asset: name,
        center,
        axes,
        size,
        is_usual: told.is_none(),
        room,
        parent: None,
        holds,
    });
    Ok(())
}

/// `dining_chair_A-0` is a dining chair.
fn by_id(id: &str) -> String {
    let words = id.rsplit_once('-').map_or(id, |(words, _)| words);
    let is_letter = |w: &str| w.len() == 1 && w.chars().all(|c| c.is_ascii_uppercase());
    let words: Vec<&str> = words.split(['_', ' ']).filter(|w| !is_letter(w)).collect();
    words.join(" ")
}

/// Width, height and depth of an asset.
fn measured(at: &At<'_>) -> Found<Option<Vec3>> {
    let Some(around) = at.maybe("assetMetadata")?.map(|at| at.maybe("boundingBox")).transpose()?.flatten() else {
        return Ok(None);
    };
    let of = |key: &str| around.need(key)?.length();
    let (x, y, z) = (of("x")?, of("y")?, of("z")?);
    let prepared = at.maybe("asset_var_name")?.is_some();
    Ok(Some(if prepared { Vec3::new(y, z, x) } else { Vec3::new(x, z, y) }))
}

/// One number or three, along x (depth), y (width), z of the thing.
fn scale(pose: &At<'_>) -> Found<Vec3> {
    let Some(at) = pose.maybe("scale")? else { return Ok(Vec3::repeat(1.0)) };
    if !at.is_array() {
        return Ok(Vec3::repeat(at.length()?));
    }
    let three: Vec<f64> = at.items()?.iter().map(At::length).collect::<Found<_>>()?;
    match three[..] {
        [x, y, z] => Ok(Vec3::new(y, z, x)),
        _ => at.fail(scenelang_base::codes::E0504, "a scale is one number or three"),
    }
}

/// An angle about z, or angles about x, y and z in that order, about fixed axes.
fn turned(pose: &At<'_>) -> Found<Matrix3<f64>> {
    let at = pose.need("rotation")?;
    let [x, y, z] = if at.is_array() {
        let angles: Vec<f64> = at.items()?.iter().map(At::number).collect::<Found<_>>()?;
        match angles[..] {
            [z] => [0.0, 0.0, z],
            [x, y, z] => [x, y, z],
            _ => return at.fail(scenelang_base::codes::E0504, "a rotation is one angle or three"),
        }
    } else {
        [0.0, 0.0, at.number()?]
    };
    let radians = [x, y, z].map(f64::to_radians);
    let there = nalgebra::Rotation3::from_euler_angles(radians[0], radians[1], radians[2]).into_inner();
    Ok(axes(&there, [0, 1, 2]))
}

/// Right, up and front of a thing whose front, left and up are these columns of a right-handed frame with z up.
pub(crate) fn axes(there: &Matrix3<f64>, [front, left, up]: [usize; 3]) -> Matrix3<f64> {
    let here = |v: nalgebra::Vector3<f64>| Vec3::new(v.x, v.z, v.y);
    let column = |k: usize| here(there.column(k).into_owned());
    Matrix3::from_columns(&[-column(left), column(up), column(front)])
}
