//! What a random scene is: things, rooms and values; their geometry; and the layout file that says the same.

use super::flat::{self, Clearance, P};
use super::solid::Solid;
use super::space::{M, V, add, apply, column, euler};
use serde_json::{Value as Json, json};

/// A convex part, in the frame of its object.
#[derive(Clone, Debug)]
pub enum Part {
    Box { pos: V, size: V, rot: V },
    Cylinder { pos: V, radius: f64, height: f64, rot: V },
    Hull { points: Vec<V> },
}

impl Part {
    pub fn solid(&self) -> Solid {
        match self {
            Self::Box { pos, size, rot } => Solid::cuboid(*size).placed(&euler(*rot), *pos),
            Self::Cylinder { pos, radius, height, rot } => Solid::cylinder(*radius, *height).placed(&euler(*rot), *pos),
            Self::Hull { points } => Solid::hull(points),
        }
    }
    fn json(&self) -> Json {
        match self {
            Self::Box { pos, size, rot } => json!({ "shape": "box", "pos": pos, "size": size, "rot": rot }),
            Self::Cylinder { pos, radius, height, rot } => {
                json!({ "shape": "cylinder", "pos": pos, "radius": radius, "height": height, "rot": rot })
            }
            Self::Hull { points } => json!({ "shape": "hull", "points": points }),
        }
    }
}

#[derive(Clone, Debug)]
pub struct Thing {
    pub name: String,
    pub pos: V,
    pub rot: V,
    pub scale: V,
    pub parts: Vec<Part>,
    pub surface: Option<f64>,
    pub color: &'static str,
    pub category: &'static str,
    /// What the program assigns to `dimensions`, if it does.
    pub dimensions: Option<V>,
}

impl Thing {
    pub fn turned(&self) -> M {
        euler(self.rot)
    }
    /// A point of its own frame, in the world.
    pub fn point(&self, local: V) -> V {
        add(self.pos, apply(&self.turned(), local))
    }
    pub fn center(&self) -> V {
        self.point([0.0, self.scale[1] / 2.0, 0.0])
    }
    /// Its own x, y or z in the world.
    pub fn axis(&self, i: usize) -> V {
        column(&self.turned(), i)
    }
    pub fn cuboid(&self) -> Solid {
        Solid::cuboid(self.scale).placed(&self.turned(), self.center())
    }
    /// Least and greatest corner of the world-axis box.
    pub fn span(&self) -> (V, V) {
        let corners = self.cuboid().corners;
        let of = |k: usize, f: fn(f64, f64) -> f64| corners.iter().map(|c| c[k]).reduce(f).unwrap();
        ([0, 1, 2].map(|k| of(k, f64::min)), [0, 1, 2].map(|k| of(k, f64::max)))
    }
    /// How far the common box of the parts is from its own box, at the worst face.
    pub fn misfit(&self) -> f64 {
        let corners: Vec<V> = self.parts.iter().flat_map(|p| p.solid().corners).collect();
        let [w, h, d] = self.scale;
        let (lo, hi) = ([-w / 2.0, 0.0, -d / 2.0], [w / 2.0, h, d / 2.0]);
        let worst = |k: usize| {
            let (a, b) = corners.iter().fold((f64::MAX, f64::MIN), |(a, b), c| (a.min(c[k]), b.max(c[k])));
            (a - lo[k]).abs().max((b - hi[k]).abs())
        };
        (0..3).map(worst).fold(0.0, f64::max)
    }
    /// Whether it is made of its parts.
    pub fn has_parts(&self) -> bool {
        !self.parts.is_empty() && self.misfit() <= 1e-3
    }
    /// What it is made of, in the world.
    pub fn solids(&self) -> Vec<Solid> {
        if !self.has_parts() {
            return vec![self.cuboid()];
        }
        self.parts.iter().map(|p| p.solid().placed(&self.turned(), self.pos)).collect()
    }
    pub fn footprint(&self) -> Vec<P> {
        flat::hull(&self.cuboid().corners.iter().map(|c| [c[0], c[2]]).collect::<Vec<_>>())
    }
}

#[derive(Clone, Debug)]
pub struct Room {
    pub name: String,
    pub pos: V,
    pub yaw: f64,
    pub scale: V,
    pub vertices: Option<Vec<P>>,
}

impl Room {
    pub fn polygon(&self) -> Vec<P> {
        if let Some(vertices) = &self.vertices {
            return vertices.clone();
        }
        let turned = euler([0.0, self.yaw, 0.0]);
        let corner = |x: f64, z: f64| {
            let p = add(self.pos, apply(&turned, [x * self.scale[0] / 2.0, 0.0, z * self.scale[2] / 2.0]));
            [p[0], p[2]]
        };
        vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)]
    }
    pub fn floor(&self) -> f64 {
        self.pos[1]
    }
    pub fn ceiling(&self) -> f64 {
        self.pos[1] + self.scale[1]
    }
    pub fn center(&self) -> V {
        let [x, z] = flat::centroid(&self.polygon());
        [x, (self.floor() + self.ceiling()) / 2.0, z]
    }
    pub fn clearance(&self, thing: &Thing) -> Clearance {
        flat::clearance(&self.polygon(), &thing.footprint())
    }
}

/// The value of a decision variable.
#[derive(Clone, Copy, Debug)]
pub enum Chosen {
    Number(f64),
    Degree(f64),
    Bool(bool),
    Vector(V),
    Rotation(V),
}

#[derive(Clone, Debug, Default)]
pub struct Scene {
    pub things: Vec<Thing>,
    /// An array: its name, and which things are its elements.
    pub array: Option<(String, Vec<usize>)>,
    pub rooms: Vec<Room>,
    pub chosen: Vec<(&'static str, Chosen)>,
    /// What `rand` gave, by its key.
    pub draws: Vec<(String, f64)>,
}

impl Scene {
    pub fn layout(&self) -> String {
        let things = self.things.iter().map(|t| {
            let mut asset = json!({});
            if !t.parts.is_empty() {
                asset["parts"] = t.parts.iter().map(Part::json).collect();
            }
            if let Some(surface) = t.surface {
                asset["surface"] = json!(surface);
            }
            (t.name.clone(), json!({ "pos": t.pos, "rot": t.rot, "scale": t.scale, "asset": asset }))
        });
        let rooms = self.rooms.iter().map(|r| {
            let mut room = json!({ "pos": r.pos, "rot": [0.0, r.yaw, 0.0], "scale": r.scale });
            if let Some(vertices) = &r.vertices {
                room["vertices"] = json!(vertices);
            }
            (r.name.clone(), room)
        });
        let chosen = self.chosen.iter().map(|(name, value)| {
            let value = match value {
                Chosen::Number(x) | Chosen::Degree(x) => json!(x),
                Chosen::Bool(p) => json!(p),
                Chosen::Vector(v) | Chosen::Rotation(v) => json!(v),
            };
            ((*name).to_owned(), value)
        });
        let draws = self.draws.iter().map(|(key, x)| (key.clone(), json!(x)));
        json!({
            "format": "scenelang.layout/1",
            "scene": "room.scene",
            "objects": things.collect::<serde_json::Map<_, _>>(),
            "regions": rooms.collect::<serde_json::Map<_, _>>(),
            "variables": chosen.collect::<serde_json::Map<_, _>>(),
            "draws": draws.collect::<serde_json::Map<_, _>>(),
        })
        .to_string()
    }
}
