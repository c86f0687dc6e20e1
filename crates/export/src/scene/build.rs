//! From program, layout and report to a [`Scene`].

use super::dress::{Dresser, Wardrobe};
use super::memory::{Memory, ObjectLook};
use super::shell::{self, Shell, Surfaces, Thickness, USUAL_WALL};
use super::wall::Opener;
use super::{Body, Lamp, Object, Region, RegionKind, ReportRow, Scene, opening, thickness};
use crate::geometry::mesh::MeshGroup;
use crate::names::Stems;
use scenelang_assets::{Light, Mesh, Surface};
use scenelang_base::{FileId, SourceMap, Span};
use scenelang_lang::program::{self, Program};
use scenelang_layout::{Aabb, Layout, NotSimple, Obb, Polygon, Prism, Vec2, Vec3, broad, convex, rotation};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// What a scene is made from.
#[derive(Clone, Copy, Debug)]
pub struct SceneInput<'a> {
    /// What to call it: the stem of the program's file name.
    pub name: &'a str,
    /// The compiled program.
    pub program: &'a Program,
    /// Where its spans point.
    pub sources: &'a SourceMap,
    /// Its files: main first, then imports.
    pub files: &'a [FileId],
    /// Where everything is.
    pub layout: &'a Layout,
    /// The layout file's text.
    pub layout_text: &'a str,
    /// The report of the layout, as JSON.
    pub report: &'a Value,
}

/// Why a scene cannot be drawn up.
#[derive(Clone, Debug, PartialEq)]
pub enum BuildError {
    /// The layout has no such object.
    MissingObject(String),
    /// The layout has no such region.
    MissingRegion(String),
    /// The floor of this region is no simple polygon.
    Floor(String, NotSimple),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MissingObject(name) => write!(f, "the layout does not place the object `{name}`"),
            Self::MissingRegion(name) => write!(f, "the layout does not place the region `{name}`"),
            Self::Floor(name, why) => write!(f, "region `{name}`: {why}"),
        }
    }
}

impl std::error::Error for BuildError {}

/// Things that overlap by no more than this touch each other, metres.
const DEEP: f64 = 1e-3;

/// What an object looks like that the furniture library does not draw, by its name.
pub type Looks<'a> = &'a dyn Fn(&str) -> Option<&'a Mesh>;

pub(super) fn build(input: &SceneInput<'_>, own: Looks<'_>, memory: &Memory) -> Result<Scene, BuildError> {
    let dressed = input.program.dressed(&input.layout.draws);
    let input = &SceneInput { program: &dressed, ..*input };
    let mut wardrobe = Wardrobe::default();
    let (rows, mentions) = rows(input);
    let regions = regions(input)?;
    let mut stems = Stems::default();
    let mut objects = Vec::with_capacity(input.program.objects.len());
    let floors = floors(&regions, input.program);
    for (id, declared) in input.program.objects.iter().enumerate() {
        objects.push(object((input, own, memory), id, declared, (&regions, &floors), &mut wardrobe, &mut stems)?);
    }
    memory.complete();
    let demands = opening::demands(input.program, |index| {
        let key = statement_key(input.sources, input.program.constraints[index].span);
        rows.iter().any(|row| row.violated() && file_name(&row.id) == key)
    });
    for (id, object) in objects.iter_mut().enumerate() {
        object.rows = mentions.get(object.name.as_str()).cloned().unwrap_or_default();
        object.violated = object.rows.iter().any(|&r| rows[r].violated());
        object.openings = opening::openings(id, object, &rows, &demands);
    }
    let wall = input.report["eta"].as_f64().filter(|eta| *eta > 0.0).unwrap_or(USUAL_WALL);
    let openers = openers(input.program, &objects, wall);
    let mut shells = Vec::new();
    let mut lamps = lamps(&objects);
    for (index, (region, declared)) in regions.iter().zip(&input.program.regions).enumerate() {
        let opens = |object: usize| openers.iter().any(|o| o.object == object);
        let drawn = thickness::of(index, &regions, &objects, opens, wall);
        let thick = Thickness { stops: wall, drawn: &drawn };
        shells.extend(enclose(region, declared, thick, &openers, &mut wardrobe));
        if region.kind == RegionKind::Room && !is_lit(region, &lamps) {
            lamps.push(invented(region));
        }
    }
    if regions.is_empty() {
        shells.push(ground(&objects, wall, &mut wardrobe));
    }
    let file = |&id: &FileId| (input.sources.get(id).name().to_owned(), input.sources.get(id).text().to_owned());
    let overlaps = overlaps(input.program, &objects);
    hold(&mut objects, &overlaps);
    Ok(Scene {
        name: input.name.to_owned(),
        program: input.files.iter().map(file).collect(),
        layout_text: input.layout_text.to_owned(),
        report: input.report.clone(),
        rows,
        surfaces: wardrobe.into_surfaces(),
        objects,
        regions,
        shells,
        lamps,
        overlaps,
    })
}

/// The rows of the report, and which of them mention each object by name.
fn rows(input: &SceneInput<'_>) -> (Vec<ReportRow>, BTreeMap<String, Vec<usize>>) {
    let program = input.program;
    // The report names the deciding instance only; the program knows all the objects that a statement reads.
    let stated: BTreeMap<String, &program::Constraint> =
        program.constraints.iter().map(|c| (statement_key(input.sources, c.span), c)).collect();
    let mut mentions: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    let mut rows = Vec::new();
    let text = |row: &Value, key: &str| row[key].as_str().unwrap_or_default().to_owned();
    for (index, row) in input.report["constraints"].as_array().into_iter().flatten().enumerate() {
        let id = text(row, "id");
        let mut names: Vec<&str> = row["objects"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        if let Some(constraint) = stated.get(file_name(&id)) {
            names.extend(constraint.formula.objects().iter().map(|o| program.objects[o.0 as usize].name.as_str()));
        }
        for object in &program.objects {
            let array = object.array.as_ref().map(|(name, _)| name.as_str());
            if names.iter().any(|&n| n == object.name || Some(n) == array) {
                mentions.entry(object.name.to_string()).or_default().push(index);
            }
        }
        rows.push(ReportRow { id, kind: text(row, "kind"), satisfied: row["satisfied"].as_bool() });
    }
    (rows, mentions)
}

/// A statement's id in reports without the folder of its file, which depends on who judged: `room.scene:12:1`.
fn statement_key(sources: &SourceMap, span: Span) -> String {
    let (start, _) = sources.lines(span);
    format!("{}:{}:{}", file_name(sources.get(span.file).name()), start.line, start.column)
}

/// What comes after the last slash.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

fn regions(input: &SceneInput<'_>) -> Result<Vec<Region>, BuildError> {
    let mut out: Vec<Region> = Vec::new();
    for declared in &input.program.regions {
        let name = declared.name.to_string();
        let Some(place) = input.layout.region(&name) else { return Err(BuildError::MissingRegion(name)) };
        let prism = Prism::from_placement(place).map_err(|why| BuildError::Floor(name.clone(), why))?;
        let outdoor = declared.text("features").to_lowercase().contains("outdoor");
        let kind = if outdoor { RegionKind::Outdoor } else { RegionKind::Room };
        out.push(Region { name, kind, prism });
    }
    let zones: Vec<bool> = (0..out.len()).map(|i| (0..out.len()).any(|j| i != j && within(&out, i, j))).collect();
    for (region, zone) in out.iter_mut().zip(zones) {
        if zone {
            region.kind = RegionKind::Zone;
        }
    }
    Ok(out)
}

/// Whether region `i` lies inside region `j` (of two equal ones: the later in the earlier).
fn within(regions: &[Region], i: usize, j: usize) -> bool {
    const SLACK: f64 = 1e-3;
    let (inner, outer) = (&regions[i].prism, &regions[j].prism);
    let inside = |a: &Prism, b: &Prism| {
        a.floor >= b.floor - SLACK
            && a.ceiling <= b.ceiling + SLACK
            && a.polygon.corners().iter().all(|&p| b.polygon.clearance_of_point(p).value >= -SLACK)
            && b.polygon.contains(a.polygon.centroid())
    };
    inside(inner, outer) && (i > j || !inside(outer, inner))
}

fn object(
    (input, own, memory): (&SceneInput<'_>, Looks<'_>, &Memory),
    id: usize,
    declared: &program::Object,
    (regions, floors): (&[Region], &[Surface]),
    wardrobe: &mut Wardrobe,
    stems: &mut Stems,
) -> Result<Object, BuildError> {
    let name = declared.name.to_string();
    let Some(place) = input.layout.object(&name) else { return Err(BuildError::MissingObject(name)) };
    // A zone lies on the floor of its room, and is declared after it or before.
    let under = regions.iter().zip(floors).filter(|(r, _)| r.prism.polygon.contains(place.pos.xz()));
    let floor = under.max_by_key(|(r, _)| r.kind == RegionKind::Zone).map(|(_, floor)| floor);
    let look = match own(&name) {
        Some(mesh) => Arc::new(ObjectLook::own(declared, place, floor, mesh)),
        None => memory.look(declared, place, floor),
    };
    let surfaces: Vec<usize> = look.surfaces.iter().map(|surface| wardrobe.add(surface.clone())).collect();
    let worn = |group: &MeshGroup| MeshGroup { surface: surfaces[group.surface], ..group.clone() };
    let axes = rotation::matrix(place.rot);
    let allow = &input.program.allow;
    let is = |other: &program::ObjectId| other.0 as usize == id;
    let over_floor = regions.iter().any(|r| r.prism.polygon.contains(Vec2::new(place.pos.x, place.pos.z)));
    let body = if allow.doors.iter().any(|d| is(&d.object)) {
        Body::Static
    } else if allow.float.iter().any(is)
        || allow.mounts.iter().any(|m| is(&m.object))
        || (!regions.is_empty() && !over_floor)
    {
        Body::Held
    } else {
        Body::Free
    };
    Ok(Object {
        stem: stems.take(&name),
        label: if declared.category.is_empty() { name.clone() } else { declared.category.clone() },
        category: declared.category.clone(),
        family: look.dressed.family.clone(),
        place: place.clone(),
        axes,
        look: look.id,
        mesh: look.dressed.mesh.iter().map(worn).collect(),
        lights: look.dressed.lights.clone(),
        mass: look.weights.iter().sum(),
        solid: look.solid.clone(),
        looks: look.looks.iter().map(|&part| surfaces[part]).collect(),
        weights: look.weights.clone(),
        tops: Arc::clone(&look.tops),
        body,
        declaration: declaration(input.sources, declared.span),
        requirements: declared.requirements.clone(),
        openings: Vec::new(),
        rows: Vec::new(),
        violated: false,
        name,
    })
}

fn floors(regions: &[Region], program: &Program) -> Vec<Surface> {
    regions.iter().zip(&program.regions).map(|(region, declared)| Dresser::of(declared, region.kind).floor()).collect()
}

/// Pairs of objects that the program lets overlap, as far as they do. What merely touches another may rest on it, and has to
/// be held up by it: a blanket on a bed, a mat on a table.
fn overlaps(program: &Program, objects: &[Object]) -> Vec<[usize; 2]> {
    let allow = &program.allow;
    if allow.collide.is_empty() && allow.contents.is_empty() {
        return Vec::new();
    }
    let solids: Vec<Vec<_>> = objects.iter().map(|o| o.world_solid().collect()).collect();
    let boxes: Vec<Aabb> = solids.iter().map(|solid| convex::aabb(solid)).collect();
    let is_deep = |a: u32, b: u32| {
        let [a, b] = [a, b].map(|index| &solids[index as usize]);
        a.iter().any(|x| b.iter().any(|y| convex::separation(x, y).gap < -DEEP))
    };
    let id = |index: u32| program::ObjectId(index);
    let allowed = |a: u32, b: u32| {
        let within = allow.contents.iter().any(|&(x, y)| (x, y) == (id(a), id(b)) || (x, y) == (id(b), id(a)));
        within || allow.collide.contains(id(a), id(b))
    };
    let near = broad::pairs_within(&boxes, 0.0).into_iter().filter(|&(a, b)| allowed(a, b) && is_deep(a, b));
    near.map(|(a, b)| [a as usize, b as usize]).collect()
}

/// What shares space with another by permission and stands higher than that does is held where it is: the two do not push each
/// other, so it would fall through. A blanket that hangs over the edge of a cot does so.
fn hold(objects: &mut [Object], overlaps: &[[usize; 2]]) {
    const HIGHER: f64 = 0.05;
    let base = |object: &Object| Aabb::of(object.world_solid().flat_map(|piece| piece.vertices().to_vec())).min.y;
    for &[a, b] in overlaps {
        let [low, high] = [base(&objects[a]), base(&objects[b])];
        let upper = if low > high { a } else { b };
        if (low - high).abs() > HIGHER && objects[upper].body == Body::Free {
            objects[upper].body = Body::Held;
        }
    }
}

/// `object chair[6];` — from the word before the declared name to the statement's end.
fn declaration(sources: &SourceMap, name: Span) -> String {
    let text = sources.get(name.file).text();
    let (before, rest) = text.split_at(name.range.start as usize);
    let keyword = before.split_whitespace().next_back().unwrap_or_default();
    let rest = rest.split_inclusive(';').next().unwrap_or_default();
    format!("{keyword} {}", rest.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// Objects that cut holes into walls: doors asserted by `connects`, and windows that stand in or on a wall.
fn openers(program: &Program, objects: &[Object], wall: f64) -> Vec<Opener> {
    let mut out = Vec::new();
    for (index, object) in objects.iter().enumerate() {
        let door = program.allow.doors.iter().any(|d| d.object.0 as usize == index);
        // `connects` lets a door be off the wall by this much; a window counts as in it when it all but touches.
        let reach = if door { 2.0 * wall + 0.01 } else { 0.02 };
        let front = Vec2::new(object.axes[(0, 2)], object.axes[(2, 2)]);
        if let Some(front) = front.try_normalize(0.5)
            && (door || object.family == "window")
        {
            let corners = Obb::from_placement(&object.place).corners().to_vec();
            out.push(Opener { object: index, corners, front, reach, wall });
        }
    }
    out
}

fn enclose(
    region: &Region,
    declared: &program::Region,
    thick: Thickness<'_>,
    openers: &[Opener],
    wardrobe: &mut Wardrobe,
) -> Vec<Shell> {
    let dresser = Dresser::of(declared, region.kind);
    let floor = wardrobe.add(dresser.floor());
    if region.kind != RegionKind::Room {
        let is_zone = region.kind == RegionKind::Zone;
        return vec![shell::open(&region.name, &region.prism, thick.stops, is_zone, floor)];
    }
    let surfaces = Surfaces {
        floor,
        wall: wardrobe.add(dresser.wall()),
        ceiling: wardrobe.add(dresser.ceiling()),
        skirting: dresser.skirting().map(|surface| wardrobe.add(surface)),
    };
    shell::room(&region.name, &region.prism, thick, openers, surfaces)
}

/// Warm white, and the luminous intensity of a room's own lamp (candela): modest, for viewers that take it literally.
const WARM: [f32; 3] = [1.0, 0.98, 0.95];
const MODEST: f64 = 30.0;
/// A lamp of less is for the mood (candela).
const CANDLE: f64 = 5.0;
/// Where a lamp gives less than this (lux), it does not matter any more.
const DIM: f64 = 0.8;

/// The lights of all lamps.
fn lamps(objects: &[Object]) -> Vec<Lamp> {
    let of = |(index, object): (usize, &Object)| {
        let lit = |light: &Light| {
            let candela = light.lumens / (4.0 * std::f64::consts::PI);
            Lamp {
                name: format!("{}/light", object.name),
                object: Some(index),
                pos: object.at(light.pos),
                range: (candela / DIM).sqrt(),
                color: light.color,
                candela,
            }
        };
        object.lights.iter().map(lit).collect::<Vec<_>>()
    };
    objects.iter().enumerate().flat_map(of).collect()
}

/// Whether one of the lamps is to light a room.
fn is_lit(region: &Region, lamps: &[Lamp]) -> bool {
    let prism = &region.prism;
    let within = |p: &Vec3| (prism.floor..=prism.ceiling).contains(&p.y) && prism.polygon.contains(p.xz());
    lamps.iter().any(|lamp| lamp.candela > CANDLE && within(&lamp.pos))
}

/// A lamp for a room that has none.
fn invented(region: &Region) -> Lamp {
    let prism = &region.prism;
    let center = prism.center();
    // A concave room's centroid may be outside of it: then above the middle of its first triangle.
    let corners = prism.polygon.corners();
    let at = if prism.polygon.contains(center.xz()) {
        center.xz()
    } else {
        crate::geometry::polygon::triangles(corners)
            .first()
            .map_or(corners[0], |t| t.iter().map(|&i| corners[i]).sum::<Vec2>() / 3.0)
    };
    let range = corners.iter().map(|c| (c - at).norm()).fold(0.0, f64::max) + (prism.ceiling - prism.floor);
    let height = (prism.ceiling - 0.3).max((prism.floor + prism.ceiling) / 2.0);
    let (name, pos) = (format!("{}/lamp", region.name), Vec3::new(at.x, height, at.y));
    Lamp { name, object: None, pos, range, color: WARM, candela: MODEST }
}

/// Without regions the floor is y = 0, so there it is drawn, a little beyond everything.
fn ground(objects: &[Object], thickness: f64, wardrobe: &mut Wardrobe) -> Shell {
    let reach = |o: &Object| Obb::from_placement(&o.place).aabb();
    let all = objects.iter().map(reach).reduce(|a, b| a.cover(&b));
    let Aabb { min, max } = all.unwrap_or(Aabb { min: Vec3::zeros(), max: Vec3::zeros() });
    let center = (min + max) / 2.0;
    let size = (max - min).xz() + Vec2::new(2.0, 2.0);
    let polygon = Polygon::rectangle(center.xz(), size, 0.0);
    let prism = Prism { polygon, floor: 0.0, ceiling: max.y.max(0.0) };
    let surface = wardrobe.add(Dresser::ground());
    Shell { name: "ground".into(), region: None, ..shell::open("ground", &prism, thickness, false, surface) }
}
