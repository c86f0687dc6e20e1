//! Writes the same made-up house in the formats of others, from their descriptions: rooms in a row, openings in their walls,
//! things on the floor and on tables. Nothing here is shared with the readers.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

/// A thing: where the middle of its base is (x, height, z), how it is turned (degrees, +z towards +x), and how large it is.
#[derive(Clone, Debug)]
pub struct Thing {
    pub category: &'static str,
    pub room: usize,
    pub base: [f64; 3],
    pub yaw: f64,
    pub size: [f64; 3],
    pub parent: Option<usize>,
}

/// A room: from x to x, from z to z.
#[derive(Clone, Debug)]
pub struct Room {
    pub kind: &'static str,
    pub x: [f64; 2],
    pub z: [f64; 2],
}

/// An opening: along the wall at this x, from z to z, from height to height; the rooms on its sides.
#[derive(Clone, Debug)]
pub struct Opening {
    pub is_window: bool,
    pub x: f64,
    pub z: [f64; 2],
    pub y: [f64; 2],
    pub rooms: [Option<usize>; 2],
}

#[derive(Clone, Debug)]
pub struct House {
    pub rooms: Vec<Room>,
    pub openings: Vec<Opening>,
    pub things: Vec<Thing>,
    pub height: f64,
}

const KINDS: [&str; 4] = ["LivingRoom", "Bedroom", "Kitchen", "Bathroom"];
const FURNITURE: [&str; 6] = ["Sofa", "Bed", "Dresser", "Desk", "DiningTable", "ShoeRack"];

fn cm(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}

impl House {
    /// Things stand apart, each in a cell of its own, so that whatever is wrong is the fault of a reader.
    pub fn new(seed: u64, rooms: usize) -> Self {
        let mut dice = ChaCha8Rng::seed_from_u64(seed);
        let mut house = Self {
            rooms: Vec::new(),
            openings: Vec::new(),
            things: Vec::new(),
            height: cm(dice.random_range(2.4..3.2)),
        };
        let (mut x, depth) = (cm(dice.random_range(-3.0..3.0)), cm(dice.random_range(4.0..6.0)));
        let z = cm(dice.random_range(-3.0..3.0));
        for index in 0..rooms {
            let end = cm(x + dice.random_range(4.0..6.0));
            house.rooms.push(Room { kind: KINDS[index % KINDS.len()], x: [x, end], z: [z, cm(z + depth)] });
            let at = cm(z + 0.2 + dice.random_range(0.0..depth - 1.6));
            let neighbours = [index.checked_sub(1), Some(index)];
            let (is_window, y) = if index == 0 { (true, [0.9, 2.1]) } else { (false, [0.0, 2.05]) };
            house.openings.push(Opening { is_window, x, z: [at, cm(at + 0.9)], y, rooms: neighbours });
            house.furnish(index, &mut dice);
            x = end;
        }
        house
    }

    fn furnish(&mut self, room: usize, dice: &mut ChaCha8Rng) {
        let Room { x, z, .. } = self.rooms[room].clone();
        // Cells of 1.6 m, away from the walls.
        let cells = |range: [f64; 2]| (((range[1] - range[0] - 0.4) / 1.6).floor() as usize).min(2);
        for (i, j) in (0..cells(x)).flat_map(|i| (0..cells(z)).map(move |j| (i, j))) {
            let size = [dice.random_range(0.4..1.0), dice.random_range(0.4..0.9), dice.random_range(0.4..1.0)].map(cm);
            let at = [cm(x[0] + 1.0 + 1.6 * i as f64), 0.0, cm(z[0] + 1.0 + 1.6 * j as f64)];
            let category = FURNITURE[dice.random_range(0..FURNITURE.len())];
            let yaw = cm(dice.random_range(0.0..360.0));
            let own = self.things.len();
            self.things.push(Thing { category, room, base: at, yaw, size, parent: None });
            if dice.random_bool(0.5) {
                let size = [0.15, cm(dice.random_range(0.1..0.4)), 0.15];
                let base = [at[0], self.things[own].size[1], at[2]];
                self.things.push(Thing { category: "Vase", room, base, yaw: 0.0, size, parent: Some(own) });
            }
        }
    }

    pub fn id(&self, index: usize) -> String {
        let thing = &self.things[index];
        format!("{}|{}|{index}", thing.category, thing.room + 2)
    }

    /// A house of ProcTHOR; `boxes`: as the first version of the schema has its openings.
    pub fn procthor(&self, boxes: bool) -> Value {
        let point = |x: f64, y: f64, z: f64| json!({ "x": x, "y": y, "z": z });
        let id = |room: usize| format!("room|{}", room + 2);
        let mut walls = Vec::new();
        let mut rooms = Vec::new();
        for (index, room) in self.rooms.iter().enumerate() {
            let corners =
                [[room.x[0], room.z[0]], [room.x[0], room.z[1]], [room.x[1], room.z[1]], [room.x[1], room.z[0]]];
            let polygon: Vec<Value> = corners.iter().map(|[x, z]| point(*x, 0.0, *z)).collect();
            rooms.push(
                json!({ "id": id(index), "roomType": room.kind, "floorPolygon": polygon, "ceilings": [], "children": [],
                               "floorMaterial": { "name": "OrangeWood" } }),
            );
            for k in 0..4 {
                let ([ax, az], [bx, bz]) = (corners[k], corners[(k + 1) % 4]);
                walls.push(json!({ "id": format!("wall|{index}|{k}"), "roomId": id(index), "material": { "name": "Plaster" },
                    "polygon": [point(ax, 0.0, az), point(bx, 0.0, bz), point(bx, self.height, bz), point(ax, self.height, az)] }));
            }
        }
        let mut lists = [Vec::new(), Vec::new()];
        for (index, opening) in self.openings.iter().enumerate() {
            // The wall of the room on the right runs from low z to high z at its left side.
            let room = opening.rooms[1].unwrap();
            let along = [opening.z[0] - self.rooms[room].z[0], opening.z[1] - self.rooms[room].z[0]];
            let corners = [point(along[0], opening.y[0], 0.0), point(along[1], opening.y[1], 0.0)];
            let mut value = json!({ "id": format!("opening|{index}"), "assetId": "Doorway_1", "room0": id(room),
                "room1": opening.rooms[0].map_or("exterior".to_owned(), id), "wall0": format!("wall|{room}|0"),
                "wall1": "wall|exterior|9", "openness": 1 });
            if boxes {
                value["boundingBox"] = json!({ "min": corners[0], "max": corners[1] });
            } else {
                value["holePolygon"] = json!(corners);
            }
            lists[usize::from(opening.is_window)].push(value);
        }
        let object = |index: usize| {
            let thing = &self.things[index];
            json!({ "id": self.id(index), "assetId": format!("asset_{index}"), "kinematic": true, "layer": "Procedural0",
                    "position": point(thing.base[0], thing.base[1] + thing.size[1] / 2.0, thing.base[2]),
                    "rotation": point(0.0, thing.yaw, 0.0) })
        };
        let mut objects = Vec::new();
        for index in (0..self.things.len()).filter(|i| self.things[*i].parent.is_none()) {
            let children = (0..self.things.len()).filter(|i| self.things[*i].parent == Some(index)).map(object);
            let mut value = object(index);
            value["children"] = children.collect();
            objects.push(value);
        }
        let [doors, windows] = lists;
        json!({ "rooms": rooms, "walls": walls, "doors": doors, "windows": windows, "objects": objects,
                "proceduralParameters": { "skyboxId": "SkyMidday", "lights": [] }, "metadata": { "schema": "1.0.0" } })
    }

    /// The asset database to it.
    pub fn database(&self) -> Value {
        let one = |(index, thing): (usize, &Thing)| {
            let [x, y, z] = thing.size;
            json!({ "assetId": format!("asset_{index}"), "objectType": thing.category, "boundingBox": { "x": x, "y": y, "z": z } })
        };
        json!({ "Things": self.things.iter().enumerate().map(one).collect::<Vec<_>>() })
    }

    /// What Holodeck makes of it: rooms are called by what they are, things have outlines.
    pub fn holodeck(&self) -> Value {
        let mut value = self.procthor(false);
        let name = |room: usize| self.rooms[room].kind.to_lowercase();
        for (index, room) in value["rooms"].as_array_mut().unwrap().iter_mut().enumerate() {
            let Room { x, z, .. } = &self.rooms[index];
            *room = json!({ "id": name(index), "roomType": name(index), "floorPolygon": room["floorPolygon"], "floor_design": "oak",
                            "vertices": [[x[0], z[0]], [x[0], z[1]], [x[1], z[1]], [x[1], z[0]]] });
        }
        for wall in value["walls"].as_array_mut().unwrap() {
            let room: usize = wall["roomId"].as_str().unwrap()[5..].parse().unwrap();
            // The corners of the base are the first and the last.
            let p = wall["polygon"].as_array().unwrap().clone();
            wall["polygon"] = json!([p[0], p[3], p[2], p[1]]);
            wall["roomId"] = json!(name(room - 2));
        }
        for (list, segment) in [("doors", "doorSegment"), ("windows", "windowSegment")] {
            for opening in value[list].as_array_mut().unwrap() {
                let index: usize = opening["id"].as_str().unwrap()[8..].parse().unwrap();
                let Opening { x, z, rooms, .. } = &self.openings[index];
                opening["room0"] = json!(name(rooms[1].unwrap()));
                opening["room1"] = json!(rooms[0].map_or("exterior".to_owned(), name));
                opening[segment] = json!([[x, z[0]], [x, z[1]]]);
                // Measured from elsewhere, as it happens there: the segment counts.
                opening["holePolygon"][0]["x"] = json!(0.3);
                opening["holePolygon"][1]["x"] = json!(1.2);
            }
        }
        let (mut floor, mut small) = (Vec::new(), Vec::new());
        for (index, thing) in self.things.iter().enumerate() {
            let called =
                |i: usize| format!("{}-{i} ({})", self.things[i].category.to_lowercase(), name(self.things[i].room));
            let [x, y, z] = thing.base;
            let mut object = json!({ "assetId": format!("asset_{index}"), "roomId": name(thing.room), "kinematic": true,
                "position": { "x": x, "y": y + thing.size[1] / 2.0, "z": z }, "rotation": { "x": 0, "y": thing.yaw, "z": 0 } });
            if let Some(parent) = thing.parent {
                object["id"] = json!(format!("vase-{index}|{}", called(parent)));
                small.push(object);
                continue;
            }
            let (sin, cos) = thing.yaw.to_radians().sin_cos();
            let corner = |u: f64, v: f64| {
                let (w, d) = ((thing.size[0] + 0.1) / 2.0 * u, (thing.size[2] + 0.1) / 2.0 * v);
                [100.0 * (x + w * cos + d * sin), 100.0 * (z - w * sin + d * cos)]
            };
            object["id"] = json!(called(index));
            object["object_name"] = json!(format!("{}-{index}", thing.category.to_lowercase()));
            object["vertices"] = json!([corner(-1.0, -1.0), corner(-1.0, 1.0), corner(1.0, 1.0), corner(1.0, -1.0)]);
            floor.push(object);
        }
        value["objects"] = floor.iter().chain(&small).cloned().collect();
        value["floor_objects"] = json!(floor);
        value["small_objects"] = json!(small);
        value["wall_height"] = json!(self.height);
        value
    }

    /// The first room, as LayoutVLM is given it, and where it has put the things.
    pub fn layoutvlm(&self) -> [Value; 2] {
        let Room { x, z, .. } = &self.rooms[0];
        let (mut assets, mut poses) = (json!({}), json!({}));
        for (index, thing) in self.things.iter().enumerate().filter(|(_, thing)| thing.room == 0) {
            let id = format!("{}_{}-{index}", thing.category.to_lowercase(), "A");
            let [w, h, d] = thing.size;
            assets[&id] = json!({ "path": "a.glb", "category": thing.category, "assetMetadata": { "boundingBox": { "x": w, "y": d, "z": h } } });
            // Facing +x at 0, counterclockwise: the other way round, and a quarter turn on.
            poses[&id] = json!({ "position": [thing.base[0], thing.base[2], thing.base[1] + h / 2.0], "rotation": [0, 0, 90.0 - thing.yaw] });
        }
        let corners = [[x[0], z[0], 0.0], [x[1], z[0], 0.0], [x[1], z[1], 0.0], [x[0], z[1], 0.0]];
        let task = json!({ "task_description": "a room", "layout_criteria": "nice", "assets": assets,
                           "boundary": { "floor_vertices": corners, "wall_height": self.height } });
        [task, poses]
    }

    /// As a scene state; `base`: models have their origin at the middle of their base, else at that of their box.
    pub fn scene_state(&self, base: bool) -> Value {
        let name = |room: usize| self.rooms[room].kind.to_lowercase();
        let mut elements = Vec::new();
        for (index, room) in self.rooms.iter().enumerate() {
            let corners =
                [[room.x[0], room.z[0]], [room.x[1], room.z[0]], [room.x[1], room.z[1]], [room.x[0], room.z[1]]];
            let flat = |[x, z]: [f64; 2]| json!([x, z, 0.0]);
            let floor: Vec<Value> = corners.iter().map(|c| flat(*c)).collect();
            elements.push(json!({ "id": format!("{}|floor", name(index)), "roomId": name(index), "type": "Floor", "points": floor, "depth": 0.05 }));
            for k in 0..4 {
                let holes: Vec<Value> = self
                    .openings
                    .iter()
                    .enumerate()
                    .filter_map(|(i, opening)| {
                        // The last wall runs from high z to low z at the low x, the second from low z to high z at the high x.
                        let from = match (k, opening.rooms) {
                            (3, [_, Some(own)]) if own == index => room.z[1] - opening.z[1],
                            (1, [Some(own), _]) if own == index => opening.z[0] - room.z[0],
                            _ => return None,
                        };
                        let kind = if opening.is_window { "Window" } else { "Door" };
                        let [low, high] = opening.y;
                        Some(json!({ "id": format!("hole {i}"), "type": kind,
                                 "box": { "min": [from, low], "max": [from + opening.z[1] - opening.z[0], high] } }))
                    })
                    .collect();
                elements.push(json!({ "id": format!("wall {index} {k}"), "roomId": name(index), "type": "Wall", "height": self.height,
                    "points": [flat(corners[k]), flat(corners[(k + 1) % 4])], "holes": holes, "materials": [{ "name": "surface" }] }));
            }
        }
        let object = |(index, thing): (usize, &Thing)| {
            let (sin, cos) = thing.yaw.to_radians().sin_cos();
            // Its own z is its front, its own y is up, and its own x is left; column by column.
            let (left, front) = ([-cos, sin, 0.0], [sin, cos, 0.0]);
            let up = thing.base[1] + if base { 0.0 } else { thing.size[1] / 2.0 };
            let data = [
                left[0],
                left[1],
                left[2],
                0.0,
                0.0,
                0.0,
                1.0,
                0.0,
                front[0],
                front[1],
                front[2],
                0.0,
                thing.base[0],
                thing.base[2],
                up,
                1.0,
            ];
            json!({ "id": format!("{index}"), "index": index, "modelId": format!("objaverse.asset_{index}"), "parentId": "",
                    "transform": { "rows": 4, "cols": 4, "data": data } })
        };
        let objects: Vec<Value> = self.things.iter().enumerate().map(object).collect();
        json!({ "format": "sceneState", "selected": [], "scene": { "version": "scene@1.0.2", "up": [0, 0, 1], "front": [0, 1, 0],
            "unit": 1.0, "assetSource": ["objaverse"], "arch": { "version": "arch@1.0.2", "elements": elements, "up": [0, 0, 1] },
            "object": objects } })
    }
}
