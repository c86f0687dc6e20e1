//! Scene states: the format of SmartScenes that SceneEval reads.
//!
//! Frame: right-handed, metres (times `unit`), z up unless the file says y. (x, y, z) there is (x, z, y) in a layout, or
//! (−x, y, z) where y is up. A model is in the frame of glTF: y up, front to +z. Floors and walls are elements; the box of a
//! hole is along its wall and up. The file has neither sizes nor names of models: both stand in the lists of the datasets.
//!
//! Whether a model stands where the middle of its box is, or the middle of its base, depends on the dataset. Things that
//! stand on the floor tell: where some have their origin at its height, it is the base.

use crate::cursor::{At, Found};
use crate::house::{Holds, House, HouseObject, HouseRoom, Open, Opening, usual, usually};
use crate::layoutvlm::axes;
use crate::names::category;
use crate::sizes::Sizes;
use nalgebra::Matrix3;
use scenelang_base::codes;
use scenelang_layout::file::json::Json;
use scenelang_layout::{Vec2, Vec3};
use std::collections::BTreeMap;

const SCENE: &[&str] = &["version", "arch", "object", "up", "front", "unit", "id", "assetSource"];
const ARCH: &[&str] = &["version", "elements", "up", "front", "coords2d", "scaleToMeters", "defaults", "id", "regions"];
const ELEMENT: &[&str] = &["id", "roomId", "type", "height", "depth", "points", "holes"];
const OBJECT: &[&str] =
    &["id", "index", "modelId", "parentId", "parentIndex", "transform", "holodeckType", "name", "category", "label"];

/// How its frame becomes that of a layout.
#[derive(Clone, Copy)]
struct Frame {
    y_up: bool,
    unit: f64,
}

impl Frame {
    fn of(at: &At<'_>, unit: &str) -> Found<Self> {
        let up = at.maybe("up")?.map(|at| at.numbers::<3>()).transpose()?.unwrap_or([0.0, 0.0, 1.0]);
        let unit = at.maybe(unit)?.map(|at| at.length()).transpose()?.unwrap_or(1.0);
        match up {
            [0.0, 0.0, z] if z > 0.0 => Ok(Self { y_up: false, unit }),
            [0.0, y, 0.0] if y > 0.0 => Ok(Self { y_up: true, unit }),
            _ => at.need("up")?.fail(codes::E0505, "`up` is neither y nor z"),
        }
    }

    fn point(self, [x, y, z]: [f64; 3]) -> Vec3 {
        self.unit * if self.y_up { Vec3::new(-x, y, z) } else { Vec3::new(x, z, y) }
    }

    /// Right, up and front of a thing, by the columns of its transform.
    fn axes(self, there: &Matrix3<f64>) -> Matrix3<f64> {
        if self.y_up {
            let flip = Matrix3::from_diagonal(&Vec3::new(-1.0, 1.0, 1.0));
            return flip * there * flip;
        }
        // Front +z, up +y; left is +x.
        axes(there, [2, 0, 1])
    }
}

pub(crate) fn read(at: &At<'_>, sizes: &Sizes) -> Found<House> {
    let scene = at.need("scene")?;
    let mut house = House::default();
    house.rest.of(&scene, "scene.", SCENE);
    if let Some(arch) = scene.maybe("arch")? {
        house.rest.of(&arch, "arch.", ARCH);
        building(&arch, &mut house)?;
    }
    let frame = Frame::of(&scene, "unit")?;
    let mut placed = Vec::new();
    for at in scene.list("object")? {
        house.rest.of(&at, "object[].", OBJECT);
        if let Some(found) = object(&at, frame, sizes, &mut house)? {
            placed.push(found);
        }
    }
    let floor = house.rooms.first().map_or(0.0, |room| room.floor);
    let at_base = placed.iter().any(|(thing, middle)| middle.is_none() && (thing.center.y - floor).abs() < 0.01);
    for (mut thing, middle) in placed {
        let to_middle = middle.unwrap_or(if at_base { Vec3::new(0.0, thing.size.y / 2.0, 0.0) } else { Vec3::zeros() });
        thing.center += thing.axes * to_middle;
        let bottom = thing.bottom();
        if thing.holds == Holds::Stands {
            thing.holds = usually(&thing.category, bottom, floor);
        }
        house.things.push(thing);
    }
    Ok(house)
}

fn building(arch: &At<'_>, house: &mut House) -> Found<()> {
    let frame = Frame::of(arch, "scaleToMeters")?;
    let elements = arch.list("elements")?;
    let mut index = BTreeMap::new();
    for at in &elements {
        house.rest.of(at, "arch.elements[].", ELEMENT);
        if at.need("type")?.text()? != "Floor" {
            continue;
        }
        let id = match at.maybe_name("roomId")? {
            Some(id) => id,
            None => at.need("id")?.name()?,
        };
        let points = points(at, frame)?;
        let corners: Vec<[f64; 2]> = points.iter().map(|p| [p.x, p.z]).collect();
        let corners = at.need("points")?.outline(&corners)?;
        let floor = points.first().map_or(0.0, |p| p.y);
        index.entry(id.clone()).or_insert(house.rooms.len());
        house.rooms.push(HouseRoom { kind: category(&id), id, corners, floor, height: None, polygon: None });
    }
    for at in elements {
        if at.need("type")?.text()? != "Wall" {
            continue;
        }
        let room = at.maybe_name("roomId")?.and_then(|id| index.get(&id).copied());
        let height = at.maybe("height")?.map(|at| at.length()).transpose()?.map(|h| h * frame.unit);
        if let (Some(room), Some(height)) = (room, height) {
            let room = &mut house.rooms[room];
            room.height = Some(room.height.map_or(height, |known| known.max(height)));
        }
        let ends = points(&at, frame)?;
        let [first, last, ..] = ends[..] else { return at.fail(codes::E0504, "a wall has two points") };
        for hole in at.list("holes")? {
            let id = hole.maybe_name("id")?.unwrap_or_else(|| format!("opening {}", house.openings.len() + 1));
            let around = hole.need("box")?;
            let [min, max]: [[f64; 2]; 2] = [around.need("min")?.numbers()?, around.need("max")?.numbers()?];
            let along = Vec2::new(last.x - first.x, last.z - first.z);
            let length = along.norm();
            if length < 1e-3 || max[0] - min[0] < 1e-3 || max[1] - min[1] < 1e-3 {
                house.note(Open::Nowhere, id);
                continue;
            }
            let begin = Vec2::new(first.x, first.z);
            house.openings.push(Opening {
                id,
                is_window: hole.maybe_name("type")?.is_some_and(|kind| kind == "Window"),
                segment: [min[0], max[0]].map(|far| begin + along * (far * frame.unit / length)),
                bottom: first.y + min[1] * frame.unit,
                height: (max[1] - min[1]) * frame.unit,
                rooms: room.into_iter().collect(),
            });
        }
    }
    join(&mut house.openings);
    Ok(())
}

/// An opening between two rooms stands in the walls of both: it is one.
fn join(openings: &mut Vec<Opening>) {
    let mut kept: Vec<Opening> = Vec::new();
    for opening in openings.drain(..) {
        let middle = |o: &Opening| (o.segment[0] + o.segment[1]) / 2.0;
        let is_same = |o: &&mut Opening| {
            o.is_window == opening.is_window
                && (middle(o) - middle(&opening)).norm() < 0.2
                && (o.bottom - opening.bottom).abs() < 0.05
        };
        match kept.iter_mut().find(is_same) {
            Some(known) => known
                .rooms
                .extend(opening.rooms.iter().filter(|r| !known.rooms.contains(r)).copied().collect::<Vec<_>>()),
            None => kept.push(opening),
        }
    }
    *openings = kept;
}

fn points(at: &At<'_>, frame: Frame) -> Found<Vec<Vec3>> {
    let of = |at: &At<'_>| at.numbers::<3>().map(|p| frame.point(p));
    at.need("points")?.items()?.iter().map(of).collect()
}

/// A thing, with its origin in the place of its middle, and where its middle is in its own frame, if that is known.
fn object(at: &At<'_>, frame: Frame, sizes: &Sizes, house: &mut House) -> Found<Option<(HouseObject, Option<Vec3>)>> {
    let model_id = at.need("modelId")?.name()?;
    let id = match at.maybe_name("id")? {
        Some(id) => id,
        None => at.maybe_name("index")?.unwrap_or_else(|| model_id.clone()),
    };
    let transform = at.need("transform")?;
    let data = transform.need("data")?.numbers::<16>()?;
    let column = |k: usize| Vec3::new(data[4 * k], data[4 * k + 1], data[4 * k + 2]);
    let scale = Vec3::new(column(0).norm(), column(1).norm(), column(2).norm());
    if scale.min() < 1e-6 {
        return transform.fail(codes::E0505, "the transform makes the thing infinitely flat");
    }
    let there = Matrix3::from_columns(&[column(0) / scale.x, column(1) / scale.y, column(2) / scale.z]);
    if (there.transpose() * there - Matrix3::identity()).amax() > 1e-3 || there.determinant() < 0.0 {
        return transform.fail(codes::E0505, "the transform shears or mirrors the thing");
    }
    let model = sizes.get(&model_id);
    let mut said = None;
    for key in ["category", "label", "name", "holodeckType"] {
        let word = at.maybe(key)?.filter(|at| matches!(at.node.value, Json::Text(_)));
        said = said.or(word.map(|at| at.name()).transpose()?);
    }
    let known = model.and_then(|model| model.category.clone());
    let category = category(&said.or(known).unwrap_or_default());
    let size = match (model.map(|model| model.size), usual(&category)) {
        (Some(size), _) => size,
        (None, Some(usual)) => {
            house.note(Open::Usual, &id);
            usual
        }
        (None, None) => {
            house.note(Open::Sizeless, format!("{id} ({model_id})"));
            return Ok(None);
        }
    };
    let center = frame.point([data[12], data[13], data[14]]);
    let size = size.component_mul(&scale) * frame.unit;
    // Models are mirrored on their way into the frame of a layout: x of their own frame is left.
    let middle =
        model.and_then(|m| m.middle).map(|m| Vec3::new(-m.x * scale.x, m.y * scale.y, m.z * scale.z) * frame.unit);
    let room = (house.rooms.len() == 1).then_some(0);
    let axes = frame.axes(&there);
    let thing = HouseObject {
        id,
        category,
        asset: model_id,
        center,
        axes,
        size,
        is_usual: model.is_none(),
        room,
        parent: None,
        holds: Holds::Stands,
    };
    Ok(Some((thing, middle)))
}
