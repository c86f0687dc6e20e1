//! Random scenes: things that stand, lean, touch and overlap, in rooms of any shape.

use super::flat::P;
use super::scene::{Chosen, Part, Room, Scene, Thing};
use super::space::V;
use crate::dice::Dice;

const COLORS: [&str; 4] = ["", "red", "blue", "red"];
const CATEGORIES: [&str; 4] = ["", "chair", "table", "box"];

pub fn scene(dice: &mut Dice) -> Scene {
    let mut scene = Scene::default();
    // Far away now and then: nothing may depend on where the origin is.
    let far = dice.chance(5);
    let origin =
        if far { [dice.between(-9e3, 9e3), dice.between(-50.0, 50.0), dice.between(-9e3, 9e3)] } else { [0.0; 3] };
    let singles = 2 + dice.below(4);
    for name in &["a", "b", "c", "d", "e"][..singles] {
        let thing = thing(dice, (*name).to_owned(), &scene, origin);
        scene.things.push(thing);
    }
    let elements = dice.one(&[0, 0, 2, 3]);
    if elements > 0 {
        scene.array = Some(("chair".to_owned(), (singles..singles + elements).collect()));
        for i in 0..elements {
            let thing = thing(dice, format!("chair[{i}]"), &scene, origin);
            scene.things.push(thing);
        }
    }
    let rooms = dice.one(&[0, 1, 1, 2, 3]);
    for name in &["room", "hall", "zone"][..rooms] {
        let room = room(dice, name, origin);
        scene.rooms.push(room);
    }
    // Some against walls, floors and ceilings.
    for i in 0..scene.things.len() {
        if !scene.rooms.is_empty() && dice.chance(30) {
            let room = dice.one(&scene.rooms);
            against(dice, &mut scene.things[i], &room);
        }
    }
    if dice.chance(60) {
        scene.chosen = vec![
            ("n", Chosen::Number(dice.between(-3.0, 3.0))),
            ("turn", Chosen::Degree(dice.between(0.0, 359.0))),
            ("p", Chosen::Bool(dice.chance(50))),
            ("v", Chosen::Vector([0; 3].map(|_| dice.between(-2.0, 2.0)))),
            ("r", Chosen::Rotation([0; 3].map(|_| dice.between(0.0, 359.0)))),
        ];
    }
    scene
}

/// Coordinates on a coarse grid meet each other; others do not.
fn coordinate(dice: &mut Dice, reach: f64) -> f64 {
    if dice.chance(50) { (dice.between(-reach, reach) * 4.0).round() / 4.0 } else { dice.between(-reach, reach) }
}

fn thing(dice: &mut Dice, name: String, scene: &Scene, origin: V) -> Thing {
    let rot = match dice.below(10) {
        0..3 => [0.0; 3],
        3..5 => [0.0, 90.0 * dice.below(4) as f64, 0.0],
        5..8 => [0.0, dice.between(-180.0, 359.0), 0.0],
        8 => [dice.between(-180.0, 180.0), dice.between(0.0, 359.0), dice.between(-180.0, 180.0)],
        _ => {
            [dice.one(&[0.5, 1.5, -3.0, 10.0, 90.0, 180.0]), dice.between(0.0, 359.0), dice.one(&[0.0, 0.0, 90.0, 5.0])]
        }
    };
    let size = |dice: &mut Dice| match dice.below(12) {
        0 => 0.001,
        1 => 0.01,
        2 => 6.0,
        3..6 => 0.5,
        6 => 1.0,
        _ => dice.between(0.1, 1.5),
    };
    let scale = [0; 3].map(|_| size(dice));
    let mut pos = [coordinate(dice, 2.0), 0.0, coordinate(dice, 2.0)];
    pos[1] = match dice.below(10) {
        0..5 => 0.0,
        5 => coordinate(dice, 2.0),
        6 => dice.one(&[0.004, -0.004, 0.006, -0.006, 0.3, -0.05]),
        _ => 0.0,
    };
    let mut thing = Thing {
        name,
        pos: [0, 1, 2].map(|k| pos[k] + origin[k]),
        rot,
        scale,
        parts: Vec::new(),
        surface: None,
        color: dice.one(&COLORS),
        category: dice.one(&CATEGORIES),
        dimensions: dice.chance(10).then(|| if dice.chance(50) { scale } else { [0.5, 0.4, 0.3] }),
    };
    if dice.chance(30) {
        of_parts(dice, &mut thing);
    }
    // On top of another.
    if !scene.things.is_empty() && dice.chance(25) {
        let below = dice.one(&scene.things);
        let top = below.surface.filter(|_| dice.chance(70)).map_or(below.span().1[1], |s| below.pos[1] + s);
        thing.pos = [below.pos[0] + dice.between(-0.4, 0.4), top, below.pos[2] + dice.between(-0.4, 0.4)];
    }
    // Beside another, touching it.
    if !scene.things.is_empty() && dice.chance(20) {
        let other = dice.one(&scene.things);
        thing.rot = if thing.surface.is_some() { [0.0, other.rot[1], 0.0] } else { other.rot };
        let axis = dice.one(&[0, 2]);
        let off = (thing.scale[axis] + other.scale[axis]) / 2.0 + dice.one(&[0.0, -0.0005, -0.0015, 0.0005, 0.02]);
        let mut local = [0.0; 3];
        local[axis] = if dice.chance(50) { off } else { -off };
        thing.pos = other.point(local);
    }
    thing
}

/// Parts, and the box around them as its size.
fn of_parts(dice: &mut Dice, thing: &mut Thing) {
    let [w, h, d] = thing.scale.map(|s| s.max(0.05));
    let turned = |dice: &mut Dice| match dice.below(4) {
        0 => [0.0, dice.between(0.0, 90.0), 0.0],
        1 => [dice.between(-90.0, 90.0), dice.between(-90.0, 90.0), dice.between(-90.0, 90.0)],
        _ => [0.0; 3],
    };
    let mut parts = Vec::new();
    match dice.below(4) {
        0 => {
            let leg = 0.04_f64.min(w / 4.0).min(d / 4.0);
            let slab = (h / 8.0).min(0.1);
            parts.push(Part::Box { pos: [0.0, h - slab / 2.0, 0.0], size: [w, slab, d], rot: [0.0; 3] });
            for (x, z) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let pos = [x * (w - leg) / 2.0, (h - slab) / 2.0, z * (d - leg) / 2.0];
                parts.push(Part::Box { pos, size: [leg, h - slab, leg], rot: [0.0; 3] });
            }
            thing.surface = dice.chance(50).then_some(h);
        }
        1 => {
            // A seat and its back.
            parts.push(Part::Box { pos: [0.0, h / 4.0, 0.0], size: [w, h / 2.0, d], rot: [0.0; 3] });
            parts.push(Part::Box { pos: [0.0, h / 2.0, -0.45 * d], size: [w, h, 0.1 * d], rot: [0.0; 3] });
            thing.surface = Some(h / 2.0);
        }
        2 => {
            let radius = w.min(d) / 2.0;
            parts.push(Part::Cylinder { pos: [0.0, h / 2.0, 0.0], radius, height: h, rot: turned(dice) });
        }
        _ => {
            for _ in 0..1 + dice.below(2) {
                let pos = [0; 3].map(|_| dice.between(-0.5, 0.5));
                parts.push(match dice.below(3) {
                    0 => Part::Box { pos, size: [w, h, d], rot: turned(dice) },
                    1 => Part::Cylinder { pos, radius: w / 2.0, height: h, rot: turned(dice) },
                    _ => {
                        let points = (0..5 + dice.below(4)).map(|_| [0; 3].map(|_| dice.between(-0.5, 0.5)));
                        Part::Hull { points: points.collect() }
                    }
                });
            }
        }
    }
    fit(thing, parts);
    // An edited layout: the parts are not those of this box.
    if dice.chance(10) {
        thing.scale[dice.below(3)] += 0.05;
    }
    if thing.surface.is_some() {
        thing.rot = [0.0, thing.rot[1], 0.0];
    }
}

/// Moves the parts so that the common box has its bottom centre at the origin.
fn fit(thing: &mut Thing, mut parts: Vec<Part>) {
    let corners: Vec<V> = parts.iter().flat_map(|p| p.solid().corners).collect();
    let of = |k: usize, f: fn(f64, f64) -> f64| corners.iter().map(|c| c[k]).reduce(f).unwrap();
    let (lo, hi) = ([0, 1, 2].map(|k| of(k, f64::min)), [0, 1, 2].map(|k| of(k, f64::max)));
    let shift = [-(lo[0] + hi[0]) / 2.0, -lo[1], -(lo[2] + hi[2]) / 2.0];
    for part in &mut parts {
        match part {
            Part::Box { pos, .. } | Part::Cylinder { pos, .. } => *pos = super::space::add(*pos, shift),
            Part::Hull { points } => points.iter_mut().for_each(|p| *p = super::space::add(*p, shift)),
        }
    }
    thing.scale = [0, 1, 2].map(|k| hi[k] - lo[k]);
    thing.parts = parts;
}

fn room(dice: &mut Dice, name: &str, origin: V) -> Room {
    let (small, large) = if name == "zone" { (1.0, 2.5) } else { (3.0, 8.0) };
    let size =
        |dice: &mut Dice| if dice.chance(50) { dice.between(small, large).ceil() } else { dice.between(small, large) };
    let pos = [coordinate(dice, 2.0), dice.one(&[0.0, 0.0, 0.0, 0.0, 0.25, -1.0]), coordinate(dice, 2.0)];
    let pos = [0, 1, 2].map(|k| pos[k] + origin[k]);
    let mut room = Room {
        name: name.to_owned(),
        pos,
        yaw: if dice.chance(60) { 0.0 } else { dice.between(0.0, 359.0) },
        scale: [size(dice), dice.between(2.0, 4.0), size(dice)],
        vertices: None,
    };
    let at = |x: f64, z: f64| [pos[0] + x, pos[2] + z];
    let mut vertices: Vec<P> = match dice.below(5) {
        0 => {
            let (x, z, k) = (size(dice), size(dice), dice.between(0.2, 0.8));
            vec![at(0.0, 0.0), at(x, 0.0), at(x, z * k), at(x * k, z * k), at(x * k, z), at(0.0, z)]
        }
        1 => {
            // Seen from its middle every corner is in order: simple, and rarely convex.
            let n = 3 + dice.below(6);
            let corner = |i: usize, r: f64| {
                let turn = (i as f64 * 360.0 / n as f64).to_radians();
                at(r * turn.cos(), r * turn.sin())
            };
            (0..n).map(|i| corner(i, dice.between(small / 2.0, large / 2.0))).collect()
        }
        2 => {
            // A regular one, convex.
            let (n, r) = (3 + dice.below(6), size(dice));
            let turn = |i: usize| (i as f64 * 360.0 / n as f64 + 10.0).to_radians();
            (0..n).map(|i| at(r * turn(i).cos(), r * turn(i).sin())).collect()
        }
        _ => return room,
    };
    if dice.chance(50) {
        vertices.reverse();
    }
    room.vertices = Some(vertices);
    room
}

/// Puts a thing at a wall, a corner, the floor or the ceiling of a room.
fn against(dice: &mut Dice, thing: &mut Thing, room: &Room) {
    let hair = dice.one(&[0.0, 0.0, 0.0005, -0.0005, -0.002, 0.008, -0.008]);
    let [w, h, d] = thing.scale;
    let height = if dice.chance(30) { room.ceiling() - h - hair } else { room.floor() + hair };
    let polygon = room.polygon();
    let i = dice.below(polygon.len());
    let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
    let t = dice.between(0.0, 1.0);
    let foot = [0, 1].map(|k| a[k] + t * (b[k] - a[k]));
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let mut inward = [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
    if !super::flat::holds(&polygon, [foot[0] + 0.01 * inward[0], foot[1] + 0.01 * inward[1]]) {
        inward = inward.map(|x| -x);
    }
    // Its back to the wall; or in it, as a door is.
    let off = if dice.chance(20) { dice.between(-0.1, 0.1) } else { d / 2.0 + hair };
    thing.rot = [0.0, inward[0].atan2(inward[1]).to_degrees(), 0.0];
    thing.pos = [foot[0] + off * inward[0], height, foot[1] + off * inward[1]];
    if dice.chance(20) {
        // Further along, into the corner.
        let along = [(a[0] - b[0]) / length, (a[1] - b[1]) / length];
        let by = t * length - w / 2.0;
        thing.pos[0] += along[0] * by;
        thing.pos[2] += along[1] * by;
    }
}
