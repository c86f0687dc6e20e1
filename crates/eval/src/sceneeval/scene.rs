//! What there is to score: the objects of a layout with their looks, bodies and what holds them, and its rooms.

use super::names::{Looks, words};
use super::shape::Shape;
use super::table::Table;
use scenelang_lang::Program;
use scenelang_lang::program::MountedOn;
use scenelang_layout::convex::solid;
use scenelang_layout::{Convex, Geometry, Layout, Polygon, Prism, Vec2};
use std::collections::BTreeSet;

/// A layout with what its program says about its objects.
#[derive(Clone, Debug)]
pub struct ScoredScene {
    /// The objects, in the order of the layout.
    pub things: Vec<ScoredObject>,
    /// The rooms, in the order of the layout.
    pub rooms: Vec<ScoredRoom>,
}

/// A placed object.
#[derive(Clone, Debug)]
pub struct ScoredObject {
    /// What it is called and looks like.
    pub looks: Looks,
    /// Its box.
    pub shape: Shape,
    /// Its body in the world: its parts or, without them, its box.
    pub solid: Vec<Convex>,
    /// What holds it.
    pub held: Held,
}

/// What holds an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// Floors and other objects, from below.
    Below,
    Wall,
    Ceiling,
    /// It is a door or a window, and so part of the house.
    House,
}

/// A room: a floor and the space above it.
#[derive(Clone, Debug)]
pub struct ScoredRoom {
    /// Its outline (world x and z).
    pub outline: Polygon,
    /// Height of the floor.
    pub floor: f64,
    /// Height of the ceiling.
    pub ceiling: f64,
    /// The least x and z of the outline.
    pub low: Vec2,
    /// The greatest.
    pub high: Vec2,
}

impl ScoredRoom {
    fn new(prism: Prism) -> Self {
        let corners = prism.polygon.corners();
        let low = corners.iter().fold(Vec2::repeat(f64::INFINITY), |m, c| m.inf(c));
        let high = corners.iter().fold(Vec2::repeat(f64::NEG_INFINITY), |m, c| m.sup(c));
        Self { outline: prism.polygon, floor: prism.floor, ceiling: prism.ceiling, low, high }
    }

    /// The share of a box that is in the room, seen from above.
    pub fn share_of(&self, shape: &Shape) -> f64 {
        shape.share_over(&self.outline, self.floor)
    }

    /// A room with an outline.
    #[cfg(test)]
    pub fn with(polygon: Polygon, floor: f64, ceiling: f64) -> Self {
        Self::new(Prism { polygon, floor, ceiling })
    }

    /// A rectangular room between two corners.
    #[cfg(test)]
    pub fn rectangle(low: [f64; 2], high: [f64; 2], floor: f64, ceiling: f64) -> Self {
        let (low, high) = (Vec2::from(low), Vec2::from(high));
        Self::with(Polygon::rectangle((low + high) / 2.0, high - low, 0.0), floor, ceiling)
    }
}

/// What the program says of an object of a layout, or what its name does.
fn looks(name: &str, program: Option<&Program>) -> Looks {
    match program.and_then(|program| program.objects.iter().find(|object| object.name == *name)) {
        Some(object) => Looks {
            name: name.to_owned(),
            category: if object.category.is_empty() { base(name) } else { object.category.clone() },
            color: object.color.clone(),
            material: object.material.clone(),
            features: object.features.clone(),
        },
        None => Looks { name: name.to_owned(), category: base(name), ..Looks::default() },
    }
}

/// The kinds of things of a layout.
pub fn categories(layout: &Layout, program: Option<&Program>) -> BTreeSet<String> {
    layout.objects.iter().map(|(name, _)| looks(name, program).category).collect()
}

impl ScoredScene {
    /// The objects and rooms of a layout. Without a program, or where it does not know an object, the object's name says
    /// what it is: `chair[2]` and `chair2` are chairs.
    ///
    /// # Errors
    /// Which room is no simple polygon.
    pub fn new(layout: &Layout, program: Option<&Program>, table: &Table) -> Result<Self, String> {
        let dressed = program.map(|program| program.dressed(&layout.draws));
        let program = dressed.as_deref();
        let things = layout.objects.iter().map(|(name, placement)| {
            let looks = looks(name, program);
            let held = held(&looks, program, table);
            let solid = solid(placement, Geometry::Parts);
            ScoredObject { looks, shape: Shape::new(placement), solid, held }
        });
        let things = things.collect();
        let room = |(name, region): &(_, _)| match Prism::from_placement(region) {
            Ok(prism) => Ok(ScoredRoom::new(prism)),
            Err(_) => Err(format!("the outline of {name} is not a simple polygon")),
        };
        Ok(Self { things, rooms: layout.regions.iter().map(room).collect::<Result<_, _>>()? })
    }

    /// The objects that a name means.
    pub fn called<'a>(&'a self, name: &'a str, table: &'a Table) -> impl Iterator<Item = &'a ScoredObject> {
        self.things.iter().filter(move |thing| thing.looks.is_called(name, table))
    }

    /// The doors, or the windows.
    pub fn openings(&self, kind: &str) -> Vec<&Shape> {
        let is = |thing: &&ScoredObject| thing.looks.category.split_whitespace().last() == Some(kind);
        self.things.iter().filter(is).map(|thing| &thing.shape).collect()
    }
}

/// A name without its index.
fn base(name: &str) -> String {
    let own = name.split('[').next().unwrap_or_default();
    let stem = own.trim_end_matches(|c: char| c.is_ascii_digit()).trim_end_matches('_');
    if stem.is_empty() { own } else { stem }.to_owned()
}

fn held(looks: &Looks, program: Option<&Program>, table: &Table) -> Held {
    let category = words(&looks.category);
    let is = |key: &str| category.last().is_some_and(|noun| table.has(key, noun));
    if category.last().is_some_and(|noun| noun == "door" || noun == "window") {
        return Held::House;
    }
    if let Some(program) = program {
        let own = |id: scenelang_lang::program::ObjectId| {
            program.objects.get(id.0 as usize).is_some_and(|object| object.name == looks.name.as_str())
        };
        if program.allow.doors.iter().any(|door| own(door.object)) {
            return Held::House;
        }
        return match program.allow.mounts.iter().find(|mount| own(mount.object)).map(|mount| mount.on) {
            Some(MountedOn::Wall) => Held::Wall,
            Some(MountedOn::Ceiling) => Held::Ceiling,
            None => Held::Below,
        };
    }
    if is("held wall") {
        Held::Wall
    } else if is("held ceiling") {
        Held::Ceiling
    } else {
        Held::Below
    }
}
