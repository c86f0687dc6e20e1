//! A house as a program and a layout. The program says what things are, how large, and what is known of them; where things
//! stand, the layout says, so that whoever works on with it may move them. Rooms stay as they are.

use crate::FileKind;
use crate::house::{Holds, House, HouseObject, Open, Opening, is_flat};
use crate::names::GivenNames;
use nalgebra::Matrix3;
use scenelang_base::{Diagnostic, codes, plain};
use scenelang_lang::fmt::{FormatOptions, format};
use scenelang_layout::{Layout, Placement, RegionPlacement, Vec2, Vec3, file, rotation};
use std::fmt::Write;

/// Of a door or a window nobody says how thick it is (metres).
const THICK: f64 = 0.04;
/// What is no more above the floor stands on it (metres).
const ON: f64 = 0.05;
/// So many names are listed.
const LISTED: usize = 12;

pub(crate) struct Written {
    pub program: String,
    pub layout: String,
    pub notes: Vec<Diagnostic>,
}

pub(crate) fn write(house: &House, scene: &str, from: &str, kind: FileKind) -> Written {
    let mut writer = Writer {
        house,
        names: GivenNames::default(),
        program: format!("// {}, read from {}.\n", capital(kind.in_words()), plain::line(from)),
        layout: Layout { scene: Some(scene.to_owned()), ..Layout::default() },
        rooms: Vec::new(),
        things: Vec::new(),
        left_out: Vec::new(),
    };
    writer.rooms();
    writer.openings();
    writer.things();
    let notes = writer.notes();
    let program = format(&writer.program, &FormatOptions::default());
    Written { program, layout: file::to_json(&writer.layout, None), notes }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

struct Writer<'h> {
    house: &'h House,
    names: GivenNames,
    program: String,
    layout: Layout,
    /// Names of the rooms and of the things, in their order.
    rooms: Vec<String>,
    things: Vec<String>,
    /// Openings in no wall of any room.
    left_out: Vec<String>,
}

/// Without the noise of a computation.
fn tidy(value: f64) -> f64 {
    (value * 1e6).round() / 1e6 + 0.0
}

fn vec3(v: Vec3) -> String {
    format!("vec3({}, {}, {})", v.x, v.y, v.z)
}

/// A text as a comment or a string can have it.
fn clean(text: &str) -> String {
    let short: String = text.chars().filter(|c| !c.is_control()).take(80).collect();
    plain::line(&short).replace(['"', '\\'], "'")
}

impl Writer<'_> {
    fn rooms(&mut self) {
        for room in &self.house.rooms {
            let words = if room.kind.is_empty() { &room.id } else { &room.kind };
            let name = self.names.take(words, "room");
            let corners: Vec<[f64; 2]> = room.corners.iter().map(|c| c.map(tidy)).collect();
            let fold = |k: usize, f: fn(f64, f64) -> f64, from: f64| corners.iter().map(|c| c[k]).fold(from, f);
            let low = [0, 1].map(|k| fold(k, f64::min, f64::INFINITY));
            let high = [0, 1].map(|k| fold(k, f64::max, f64::NEG_INFINITY));
            let middle = |k: usize| tidy((low[k] + high[k]) / 2.0);
            let pos = Vec3::new(middle(0), tidy(room.floor), middle(1));
            let height = tidy(room.height.unwrap_or(self.house.usual_height()));
            let scale = Vec3::new(tidy(high[0] - low[0]), height, tidy(high[1] - low[1]));
            let outline: Vec<String> = corners.iter().map(|[x, z]| format!("vec3({x}, 0, {z})")).collect();
            let _ = write!(
                self.program,
                "\n/// {}\nregion {name};\n{name}.vertices <- polygon({});\n{name}.pos <- {};\n{name}.scale <- {};\n",
                clean(&room.id),
                outline.join(", "),
                vec3(pos),
                vec3(scale)
            );
            let placed = RegionPlacement { pos, rot: Vec3::zeros(), scale, vertices: Some(corners) };
            self.layout.regions.push((name.as_str().into(), placed));
            self.rooms.push(name);
        }
    }

    fn openings(&mut self) {
        for opening in &self.house.openings {
            let rooms = self.rooms_of(opening);
            let Some(&first) = rooms.first() else {
                self.left_out.push(clean(&opening.id));
                continue;
            };
            let category = if opening.is_window { "window" } else { "door" };
            let name = self.names.take(category, category);
            let [a, b] = opening.segment;
            let (middle, along) = ((a + b) / 2.0, b - a);
            let mut yaw = (-along.y).atan2(along.x);
            let front = |yaw: f64| Vec2::new(yaw.sin(), yaw.cos());
            if !self.house.rooms[first].holds(middle + front(yaw) * 0.1) {
                yaw += std::f64::consts::PI;
            }
            // What leads outside does not reach into the room, so that a curtain may hang before it.
            let back = if rooms.len() == 1 { THICK / 2.0 } else { 0.0 };
            let at = middle - front(yaw) * back;
            let size = Vec3::new(along.norm(), opening.height, THICK).map(tidy);
            let pos = Vec3::new(at.x, opening.bottom, at.y).map(tidy);
            let rot = Vec3::new(0.0, tidy((yaw.to_degrees() + 360.0) % 360.0), 0.0);
            self.declare(&name, category, size, &clean(&opening.id));
            let rooms: Vec<&str> = rooms.iter().map(|room| self.rooms[*room].as_str()).collect();
            let _ = writeln!(self.program, "assert connects({name}, {});", rooms.join(", "));
            self.place(&name, pos, rot, size);
        }
    }

    /// The rooms that an opening is in the walls of, two at most: those that the file names, else those that are there.
    fn rooms_of(&self, opening: &Opening) -> Vec<usize> {
        let mut rooms = opening.rooms.clone();
        let beside = self.house.rooms.iter().enumerate().filter(|(_, room)| room.has_wall(&opening.segment));
        for (room, _) in beside {
            if !rooms.contains(&room) {
                rooms.push(room);
            }
        }
        rooms.truncate(2);
        rooms
    }

    fn things(&mut self) {
        for thing in &self.house.things {
            let words = if thing.category.is_empty() { &thing.id } else { &thing.category };
            let name = self.names.take(words, "thing");
            let size = thing.size.map(tidy);
            let model = if thing.asset.is_empty() { String::new() } else { format!(", model {}", clean(&thing.asset)) };
            self.declare(&name, &thing.category, size, &format!("{}{model}", clean(&thing.id)));
            self.place(&name, thing.base().map(tidy), rotation::triple(&squared(&thing.axes)).map(tidy), size);
            self.things.push(name);
        }
        let any_usual = self.house.things.iter().any(|thing| thing.is_usual);
        let before = self.program.len();
        for (index, thing) in self.house.things.iter().enumerate() {
            self.known(index, thing, any_usual);
        }
        if self.program.len() > before {
            self.program.insert_str(before, "\n// What holds of them.\n\n");
        }
    }

    /// What is known of a thing, as statements.
    fn known(&mut self, index: usize, thing: &HouseObject, any_usual: bool) {
        let name = &self.things[index];
        let base = thing.base();
        let over = || self.house.rooms.iter().position(|room| room.holds(Vec2::new(base.x, base.z)));
        let room = thing.room.or_else(over);
        let floor = room.map_or(0.0, |room| self.house.rooms[room].floor);
        let room = room.map(|room| self.rooms[room].as_str());
        let mut said = Vec::new();
        match (thing.holds, room) {
            (Holds::Wall, Some(room)) if !thing.is_usual => said.push(format!("assert wallMounted({name}, {room});")),
            (Holds::Ceiling, Some(room)) if !thing.is_usual => {
                said.push(format!("assert ceilingMounted({name}, {room});"))
            }
            (Holds::Wall | Holds::Ceiling, _) => said.push(format!("allowFloat({name});")),
            (Holds::Stands, room) => {
                if let (Some(room), true) = (room.filter(|_| thing.room.is_some()), self.rooms.len() > 1) {
                    said.push(format!("assert inside({name}, {room});"));
                }
                let parent = thing.parent.map(|parent| (&self.house.things[parent], &self.things[parent]));
                match parent {
                    // A box knows no shelves: that it is in there the file says.
                    Some((parent, holder)) if thing.bottom() < parent.top() - 0.005 => {
                        said.push(format!("allowCollide({name}, {holder});\nallowFloat({name});"));
                    }
                    _ if thing.is_usual && thing.bottom() > floor + 1e-6
                        || any_usual && thing.bottom() > floor + ON =>
                    {
                        said.push(format!("allowFloat({name});"))
                    }
                    _ => {}
                }
            }
        }
        if is_flat(&thing.category) {
            said.push(format!("allowCollide({name}, objects);"));
        }
        if !said.is_empty() {
            let _ = writeln!(self.program, "{}", said.join("\n"));
        }
    }

    fn declare(&mut self, name: &str, category: &str, size: Vec3, comment: &str) {
        let _ = write!(self.program, "\n/// {comment}\nobject {name};\n");
        if !category.is_empty() {
            let _ = writeln!(self.program, "{name}.category <- \"{}\";", clean(category));
            self.layout.categories.insert(name.into(), clean(category).into());
        }
        let _ = writeln!(self.program, "{name}.dimensions <- {};", vec3(size));
    }

    fn place(&mut self, name: &str, pos: Vec3, rot: Vec3, scale: Vec3) {
        let placed = Placement { pos, rot, scale, parts: Vec::new(), surface: None, joints: Vec::new() };
        self.layout.objects.push((name.into(), placed));
    }

    /// What was filled in, and what was not taken over.
    fn notes(&self) -> Vec<Diagnostic> {
        let mut out = Vec::new();
        let mut note = |say: String| {
            let found = Diagnostic::without_place(codes::W0505, say);
            out.push(found);
            out.len() - 1
        };
        let mut sizes = Vec::new();
        for (what, whose) in &self.house.open {
            let (n, list) = (many(whose.len(), "object"), listed(whose));
            let their = if whose.len() == 1 { "its" } else { "their" };
            match what {
                Open::Usual => {
                    sizes.push(note(format!("the file does not give the size of {n}; the usual size is used: {list}")))
                }
                Open::Sizeless => sizes.push(note(format!("{n} left out, because {their} size is unknown: {list}"))),
                Open::Nowhere => {
                    note(format!("{n} left out, because the file does not give {their} position: {list}"));
                }
            }
        }
        let heights: Vec<String> =
            self.house.rooms.iter().filter(|r| r.height.is_none()).map(|r| r.id.clone()).collect();
        if !heights.is_empty() {
            let (n, list, height) = (many(heights.len(), "room"), listed(&heights), tidy(self.house.usual_height()));
            note(format!("the file does not give the height of {n}; {height} m is used: {list}"));
        }
        if !self.left_out.is_empty() {
            let (n, list) = (many(self.left_out.len(), "opening"), listed(&self.left_out));
            let they = if self.left_out.len() == 1 { "it is" } else { "they are" };
            note(format!("{n} left out, because {they} not in the wall of any room: {list}"));
        }
        let rest = self.house.rest.list();
        if !rest.is_empty() {
            note(format!("ignored members: {}", listed(&rest)));
        }
        for index in sizes {
            out[index].notes.push("pass --sizes FILE to read the sizes from a list of models".to_owned());
        }
        out
    }
}

/// `1 room`, `2 rooms`
fn many(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

fn listed(names: &[String]) -> String {
    let mut out: Vec<String> = names.iter().take(LISTED).map(|name| clean(name)).collect();
    if names.len() > LISTED {
        out.push(format!("and {} more", names.len() - LISTED));
    }
    out.join(", ")
}

/// The rotation nearest to axes that were rounded.
fn squared(axes: &Matrix3<f64>) -> Matrix3<f64> {
    let up = axes.column(1).normalize();
    let front: Vec3 = axes.column(2) - up * up.dot(&axes.column(2));
    let front = front.normalize();
    Matrix3::from_columns(&[up.cross(&front), up, front])
}
