//! Houses of AI2-THOR: what ProcTHOR and Holodeck write, and the simulator loads.
//!
//! Frame: that of a layout (left-handed, y up, metres). A thing stands where the middle of its box is, turned as Unity turns:
//! about z, then x, then y, about fixed axes; or about an axis. An opening is measured along its first wall, from the first
//! corner of that; Holodeck also says where its ends are. Sizes stand in the asset database, but for the outlines that
//! Holodeck leaves in its things, in centimetres: those of things on the floor are 10 cm wider than the things.

use crate::cursor::{At, Found};
use crate::house::{Holds, House, HouseObject, HouseRoom, Open, Opening, standing, usual, usually};
use crate::names::category;
use crate::sizes::Sizes;
use nalgebra::{Matrix3, Rotation3, Unit};
use scenelang_layout::{Vec2, Vec3, rotation};
use std::collections::BTreeMap;

/// By how much the outline of a thing on the floor is wider than the thing (metres).
const BUFFER: f64 = 0.1;
/// What is less is no size (metres).
const LEAST: f64 = 0.001;

const HOUSE: &[&str] = &[
    "rooms",
    "walls",
    "doors",
    "windows",
    "objects",
    "wall_height",
    "floor_objects",
    "wall_objects",
    "ceiling_objects",
    "small_objects",
    "query",
];
const ROOM: &[&str] = &["id", "roomType", "floorPolygon", "vertices", "full_vertices", "children", "ceilings"];
const OPENING: &[&str] = &[
    "id",
    "assetId",
    "holePolygon",
    "boundingBox",
    "room0",
    "room1",
    "roomId",
    "wall0",
    "wall1",
    "assetPosition",
    "assetOffset",
    "doorSegment",
    "doorBoxes",
    "windowSegment",
    "windowBoxes",
];
const OBJECT: &[&str] = &[
    "id",
    "assetId",
    "position",
    "rotation",
    "children",
    "roomId",
    "object_name",
    "vertices",
    "objectType",
    "boundingBox",
    "kinematic",
];

/// A wall: where it begins and ends, and how high it is.
struct Wall {
    ends: [Vec2; 2],
    top: f64,
}

pub(crate) fn read(at: &At<'_>, sizes: &Sizes) -> Found<House> {
    let mut house = House::default();
    house.rest.of(at, "", HOUSE);
    let whole = at.maybe("wall_height")?.map(|at| at.length()).transpose()?;
    let mut index: BTreeMap<String, usize> = BTreeMap::new();
    for at in at.list("rooms")? {
        house.rest.of(&at, "rooms[].", ROOM);
        let room = room(&at, whole)?;
        index.entry(room.id.clone()).or_insert(house.rooms.len());
        // Holodeck's openings name rooms by what they are.
        index.entry(room.kind.clone()).or_insert(house.rooms.len());
        house.rooms.push(room);
    }
    let walls = walls(at, &index, &mut house.rooms)?;
    for (list, is_window) in [("doors", false), ("windows", true)] {
        for at in at.list(list)? {
            house.rest.of(&at, &format!("{list}[]."), OPENING);
            opening(&at, is_window, &walls, &index, &mut house)?;
        }
    }
    let mut held = BTreeMap::new();
    for (list, how) in
        [("wall_objects", Holds::Wall), ("ceiling_objects", Holds::Ceiling), ("floor_objects", Holds::Stands)]
    {
        for at in at.list(list)? {
            held.extend(at.maybe_name("id")?.map(|id| (id, how)));
        }
    }
    let mut reader = Things { sizes, index: &index, held: &held, house, ids: BTreeMap::new() };
    for at in at.list("objects")? {
        reader.thing(&at, None)?;
    }
    Ok(reader.finish())
}

fn room(at: &At<'_>, height: Option<f64>) -> Found<HouseRoom> {
    let id = at.need("id")?.name()?;
    let kind = at.maybe_name("roomType")?.unwrap_or_default();
    let polygon = at.need("floorPolygon")?;
    let points: Vec<Vec3> = polygon.items()?.iter().map(At::xyz).collect::<Found<_>>()?;
    let corners: Vec<[f64; 2]> = points.iter().map(|p| [p.x, p.z]).collect();
    let floor = points.first().map_or(0.0, |p| p.y);
    Ok(HouseRoom { id, kind: category(&kind), corners: polygon.outline(&corners)?, floor, height, polygon: None })
}

/// The walls by name. What they are high, their rooms are.
fn walls(at: &At<'_>, index: &BTreeMap<String, usize>, rooms: &mut [HouseRoom]) -> Found<BTreeMap<String, Wall>> {
    let mut out = BTreeMap::new();
    for at in at.list("walls")? {
        let points: Vec<Vec3> = at.need("polygon")?.items()?.iter().map(At::xyz).collect::<Found<_>>()?;
        let low = points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        let top = points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max);
        let mut base = points.iter().filter(|p| p.y <= low + 1e-6).map(|p| Vec2::new(p.x, p.z));
        let (Some(first), Some(last)) = (base.next(), base.next()) else { continue };
        let room = at.maybe_name("roomId")?.and_then(|id| index.get(&id).copied());
        if let Some(room) = room.map(|room| &mut rooms[room]) {
            let height = top - room.floor;
            room.height = Some(room.height.map_or(height, |known| known.max(height)));
        }
        out.insert(at.need("id")?.name()?, Wall { ends: [first, last], top });
    }
    Ok(out)
}

fn opening(
    at: &At<'_>,
    is_window: bool,
    walls: &BTreeMap<String, Wall>,
    index: &BTreeMap<String, usize>,
    house: &mut House,
) -> Found<()> {
    let id = at.need("id")?.name()?;
    let [min, max] = hole(at)?;
    let wall = at.maybe_name("wall0")?.and_then(|id| walls.get(&id));
    let wall = wall.or(at.maybe_name("wall1")?.and_then(|id| walls.get(&id)));
    let told = match at.maybe("doorSegment")? {
        Some(segment) => Some(segment),
        None => at.maybe("windowSegment")?,
    };
    let segment = match (told, wall) {
        (Some(segment), _) => {
            let ends: Vec<[f64; 2]> = segment.items()?.iter().map(At::numbers).collect::<Found<_>>()?;
            <[_; 2]>::try_from(ends).ok().map(|ends| ends.map(Vec2::from))
        }
        (None, Some(Wall { ends: [first, last], .. })) => {
            let along = last - first;
            let length = along.norm();
            (length > LEAST).then(|| [min.x, max.x].map(|far| first + along * (far / length)))
        }
        (None, None) => None,
    };
    let Some(segment) = segment.filter(|[a, b]| (b - a).norm() > LEAST && max.y - min.y > LEAST) else {
        house.note(Open::Nowhere, id);
        return Ok(());
    };
    let mut rooms = Vec::new();
    for key in ["room0", "room1", "roomId"] {
        let room = at.maybe_name(key)?.and_then(|id| index.get(&id).copied());
        rooms.extend(room.filter(|room| !rooms.contains(room)));
    }
    let floor = rooms.first().map_or(0.0, |room| house.rooms[*room].floor);
    let top = wall.map_or(f64::INFINITY, |wall| wall.top);
    let (bottom, height) = (floor + min.y, (max.y - min.y).min(top - floor - min.y).max(LEAST));
    house.openings.push(Opening { id, is_window, segment, bottom, height, rooms });
    Ok(())
}

/// The hole of an opening along its wall: x along, y up. Older houses call it the box.
fn hole(at: &At<'_>) -> Found<[Vec3; 2]> {
    let corners = match at.maybe("holePolygon")? {
        Some(polygon) => {
            let points: Vec<Vec3> = polygon.items()?.iter().map(At::xyz).collect::<Found<_>>()?;
            if points.len() < 2 {
                return polygon.fail(scenelang_base::codes::E0504, "a hole has at least two corners");
            }
            points
        }
        None => {
            let around = at.need("boundingBox")?;
            vec![around.need("min")?.xyz()?, around.need("max")?.xyz()?]
        }
    };
    let fold = |f: fn(f64, f64) -> f64| corners.iter().copied().reduce(|a, b| a.zip_map(&b, f)).unwrap_or_default();
    Ok([fold(f64::min), fold(f64::max)])
}

struct Things<'r> {
    sizes: &'r Sizes,
    index: &'r BTreeMap<String, usize>,
    held: &'r BTreeMap<String, Holds>,
    house: House,
    /// Things by what the file calls them.
    ids: BTreeMap<String, usize>,
}

impl Things<'_> {
    fn thing(&mut self, at: &At<'_>, parent: Option<usize>) -> Found<()> {
        self.house.rest.of(at, "objects[].", OBJECT);
        let id = at.need("id")?.name()?;
        let asset = at.maybe_name("assetId")?.unwrap_or_default();
        let center = at.need("position")?.xyz()?;
        let axes = turned(at)?;
        let model = self.sizes.get(&asset);
        let kind = kind(at, &id)?;
        let category = match model.and_then(|model| model.category.clone()) {
            Some(known) if usual(&category(&kind)).is_none() => category(&known),
            _ => category(&kind),
        };
        let room = at.maybe_name("roomId")?.and_then(|id| self.index.get(&id).copied());
        let floor = room.map_or(0.0, |room| self.house.rooms[room].floor);
        let held = self.held.get(&id).copied();
        let own = at.maybe("boundingBox")?.filter(At::is_object).map(|b| b.xyz()).transpose()?;
        let told = own.or_else(|| model.map(|model| model.size)).filter(|size| size.min() > LEAST);
        let outline = if told.is_none() { outline(at, &axes, held)? } else { None };
        let hangs = matches!(held, Some(Holds::Wall | Holds::Ceiling));
        let middle = if hangs { f64::INFINITY } else { center.y };
        let size = match (told, outline, usual(&category)) {
            (Some(size), ..) => size,
            // Things on the floor are twice as high as their middle is.
            (None, Some([width, depth]), _) if held == Some(Holds::Stands) && center.y - floor > LEAST => {
                Vec3::new(width, 2.0 * (center.y - floor), depth)
            }
            (None, outline, Some(usual)) => {
                self.house.note(Open::Usual, &id);
                let size = standing(usual, middle, floor);
                outline.map_or(size, |[width, depth]| Vec3::new(width, size.y, depth))
            }
            (None, _, None) => {
                self.house.note(Open::Sizeless, &id);
                return Ok(());
            }
        };
        let is_usual = told.is_none() && !(outline.is_some() && held == Some(Holds::Stands));
        let bottom = center.y - size.y / 2.0;
        let holds = held.unwrap_or_else(|| usually(&category, bottom, floor));
        let holds = if parent.is_some() { Holds::Stands } else { holds };
        let own = self.house.things.len();
        self.ids.entry(id.clone()).or_insert(own);
        self.house.things.push(HouseObject { id, category, asset, center, axes, size, is_usual, room, parent, holds });
        for child in at.list("children")? {
            self.thing(&child, Some(own))?;
        }
        Ok(())
    }

    /// Holodeck's small things are called after what they are on.
    fn finish(mut self) -> House {
        for thing in &mut self.house.things {
            let on = thing.id.split_once('|').and_then(|(_, on)| self.ids.get(on).copied());
            thing.parent = thing.parent.or(on);
        }
        self.house
    }
}

/// What a thing is called: by its own word, else by its name: `Bed|2|0`, `sofa-0 (living room)`.
fn kind(at: &At<'_>, id: &str) -> Found<String> {
    let said = match at.maybe_name("objectType")? {
        Some(said) => said,
        None => at.maybe_name("object_name")?.unwrap_or_else(|| id.to_owned()),
    };
    let word = said.split(['|', '(']).next().unwrap_or_default().trim();
    let without = word.trim_end_matches(|c: char| c.is_ascii_digit());
    Ok(without.strip_suffix('-').unwrap_or(word).to_owned())
}

/// `{ "x", "y", "z" }` in degrees, or `{ "axis", "degrees" }`. Without one it is not turned.
fn turned(at: &At<'_>) -> Found<Matrix3<f64>> {
    let Some(at) = at.maybe("rotation")? else { return Ok(Matrix3::identity()) };
    if let Some(degrees) = at.maybe("degrees")? {
        let axis = at.need("axis")?.xyz()?;
        let Some(axis) = Unit::try_new(axis, 1e-9) else { return Ok(Matrix3::identity()) };
        // In a left-handed frame the same formula turns the other way round for the eye, as Unity does.
        return Ok(Rotation3::from_axis_angle(&axis, degrees.number()?.to_radians()).into_inner());
    }
    let by = at.xyz()?;
    let about = |x: f64, y: f64, z: f64| rotation::matrix(Vec3::new(x, y, z));
    Ok(about(0.0, by.y, 0.0) * about(by.x, 0.0, 0.0) * about(0.0, 0.0, by.z))
}

/// Width and depth by the outline that Holodeck leaves in its things.
fn outline(at: &At<'_>, axes: &Matrix3<f64>, held: Option<Holds>) -> Found<Option<[f64; 2]>> {
    let Some(vertices) = at.maybe("vertices")?.filter(At::is_array) else { return Ok(None) };
    let points: Vec<[f64; 2]> = vertices.items()?.iter().map(At::numbers).collect::<Found<_>>()?;
    let extent = |axis: usize| {
        let along = points.iter().map(|[x, z]| (x * axes[(0, axis)] + z * axes[(2, axis)]) / 100.0);
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low
    };
    let buffer = if held == Some(Holds::Stands) { BUFFER } else { 0.0 };
    let both = [extent(0) - buffer, extent(2) - buffer];
    Ok(both.iter().all(|v| v.is_finite() && *v > LEAST).then_some(both))
}
