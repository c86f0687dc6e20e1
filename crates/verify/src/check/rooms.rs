//! What looks odd about rooms and walls: rooms nearer to each other than their walls are thick, and objects that are
//! allowed outside and stand in a wall where no door is.

use super::describe::number;
use crate::navigation::opening;
use crate::tolerances::Options;
use crate::world::World;
use rustc_hash::FxHashSet;
use scenelang_base::{Diagnostic, codes};
use scenelang_lang::program::{Node, ObjectId, Owner, Pinned, Program, RegionId, Unit};
use scenelang_layout::planar::{convex_overlap, depth_in_convex, nearest_of_segments};
use scenelang_layout::{Prism, Vec2};

/// Tells of it.
pub fn warn(program: &Program, world: &World<f64>, out: &mut Vec<Diagnostic>) {
    let rooms = rooms(program, world);
    for (i, (a, first)) in rooms.iter().enumerate() {
        for (b, second) in &rooms[i + 1..] {
            too_close(program, world, (*a, first), (*b, second), out);
        }
    }
    let doors: FxHashSet<ObjectId> = world.allow.doors.iter().map(|door| door.object).collect();
    let open = world.bodies().filter(|(id, _)| doors.contains(id));
    let openings: Vec<Vec<Vec2>> = open.map(|(_, door)| opening(&door.obb, &world.options)).collect();
    for id in world.allow.outside.iter().filter(|id| !doors.contains(id)) {
        crossing(program, world, *id, (&rooms, &openings), out);
    }
}

/// Regions with walls: neither a zone of another nor out of doors.
fn rooms<'a>(program: &Program, world: &'a World<f64>) -> Vec<(RegionId, &'a Prism)> {
    let contact = world.options.tolerances.contact;
    let is_zone = |id: RegionId, prism: &Prism| {
        world.prisms().any(|(other, outer)| {
            // Of two that are the same the second is a zone of the first.
            let larger = outer.area() > prism.area() || (outer.area() == prism.area() && other < id);
            let within = |c: &Vec2| outer.polygon.clearance_of_point(*c).value >= -contact;
            other != id
                && larger
                && prism.polygon.corners().iter().all(within)
                && prism.floor >= outer.floor - contact
                && prism.ceiling <= outer.ceiling + contact
        })
    };
    let outdoor = |id: RegionId| program.regions[id.0 as usize].text("features").contains("outdoor");
    world.prisms().filter(|(id, prism)| !outdoor(*id) && !is_zone(*id, prism)).collect()
}

fn too_close(
    program: &Program,
    world: &World<f64>,
    (a, first): (RegionId, &Prism),
    (b, second): (RegionId, &Prism),
    out: &mut Vec<Diagnostic>,
) {
    let tolerances = &world.options.tolerances;
    let apart = first.floor.max(second.floor) - first.ceiling.min(second.ceiling);
    if apart > -tolerances.contact {
        return;
    }
    let mut least = f64::INFINITY;
    for (p, q) in first.polygon.edges() {
        for (r, s) in second.polygon.edges() {
            let (x, y) = nearest_of_segments([&p, &q], [&r, &s]);
            least = least.min((x - y).norm());
        }
    }
    let walls = 2.0 * world.options.eta;
    if least >= walls - tolerances.contact {
        return;
    }
    let depth = overlap(first, second).filter(|depth| *depth > tolerances.contact);
    out.push(finding(program, [a, b], (least, depth), walls));
}

/// What is said of two rooms that are too close: their distance, or how far they overlap.
fn finding(program: &Program, rooms: [RegionId; 2], (apart, overlap): (f64, Option<f64>), walls: f64) -> Diagnostic {
    let [a, b] = rooms.map(|id| &program.regions[id.0 as usize]);
    let [apart, walls] = [apart, walls].map(|x| number(x, Unit::Metre));
    let message = match overlap {
        Some(depth) => format!("`{}` and `{}` overlap by {} m", a.name, b.name, number(depth, Unit::Metre)),
        None => format!("`{}` and `{}` are {apart} m apart, but their walls need {walls} m", a.name, b.name),
    };
    let finding = Diagnostic::new(codes::W0502, b.span, message).related(a.span, "the other room");
    match overlap {
        Some(_) => finding.note(format!("each room has its own walls: leave {walls} m between the rooms")),
        None => finding,
    }
}

/// Tells of rooms that a program alone puts too close to each other: their places and sizes are assigned, and they are
/// rectangles along the axes.
pub fn warn_of_program(program: &Program, options: &Options) -> Vec<Diagnostic> {
    let contact = options.tolerances.contact;
    let indoor = |id: &RegionId| !program.regions[id.0 as usize].text("features").contains("outdoor");
    let all = (0..program.regions.len() as u32).map(RegionId).filter(indoor);
    let rooms: Vec<(RegionId, [[f64; 2]; 3])> = all.filter_map(|id| Some((id, assigned(program, id)?))).collect();
    let holds = |outer: &[[f64; 2]; 3], inner: &[[f64; 2]; 3]| {
        outer.iter().zip(inner).all(|(o, i)| i[0] >= o[0] - contact && i[1] <= o[1] + contact)
    };
    let walls = 2.0 * options.eta;
    let mut out = Vec::new();
    for (i, (a, first)) in rooms.iter().enumerate() {
        for (b, second) in &rooms[i + 1..] {
            // How far they are apart along each axis; less than 0 where they overlap.
            let [x, y, z] = [0, 1, 2].map(|k| (second[k][0] - first[k][1]).max(first[k][0] - second[k][1]));
            let apart = x.max(0.0).hypot(z.max(0.0));
            let is_zone = holds(first, second) || holds(second, first);
            if is_zone || y > -contact || apart >= walls - contact {
                continue;
            }
            let depth = Some(-x.max(z)).filter(|depth| *depth > contact);
            out.push(finding(program, [*a, *b], (apart, depth), walls));
        }
    }
    out
}

/// From where to where a region reaches along x, y and z, if the program says it.
fn assigned(program: &Program, id: RegionId) -> Option<[[f64; 2]; 3]> {
    let pins = || program.pins.iter().filter(|pin| pin.owner == Owner::Region(id));
    if pins().any(|pin| matches!(pin.property, Pinned::Rot | Pinned::Vertices)) {
        return None;
    }
    let triple = |property: Pinned| {
        let value = pins().find(|pin| pin.property == property)?.values.first()?;
        let Node::Vector(sides) = value.node(value.root) else { return None };
        let mut numbers = sides.iter().map(|side| match value.node(*side) {
            Node::Number(number) => Some(*number),
            _ => None,
        });
        Some([numbers.next()??, numbers.next()??, numbers.next()??])
    };
    let ([x, y, z], [w, h, d]) = (triple(Pinned::Pos)?, triple(Pinned::Scale)?);
    Some([[x - w / 2.0, x + w / 2.0], [y, y + h], [z - d / 2.0, z + d / 2.0]])
}

/// How far one of two rooms has to be moved along x or z for them to touch, by the rectangles around them; `None` where
/// they are apart, or an outline is no rectangle.
fn overlap(first: &Prism, second: &Prism) -> Option<f64> {
    let range = |prism: &Prism, axis: fn(&Vec2) -> f64| {
        let along = prism.polygon.corners().iter().map(axis);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], x| [lo.min(x), hi.max(x)])
    };
    let [x, z]: [fn(&Vec2) -> f64; 2] = [|p| p.x, |p| p.y];
    let fills = |prism: &Prism| {
        let sides = [x, z].map(|axis| range(prism, axis)).map(|[lo, hi]| hi - lo);
        prism.area() > 0.999 * sides[0] * sides[1]
    };
    let shared = [x, z].map(|axis| {
        let ([a, b], [c, d]) = (range(first, axis), range(second, axis));
        (b - c).min(d - a)
    });
    (fills(first) && fills(second)).then(|| shared[0].min(shared[1])).filter(|depth| *depth > 0.0)
}

/// Warns of an object whose box crosses a wall of a room outside the openings of doors.
fn crossing(
    program: &Program,
    world: &World<f64>,
    id: ObjectId,
    (rooms, openings): (&[(RegionId, &Prism)], &[Vec<Vec2>]),
    out: &mut Vec<Diagnostic>,
) {
    let Ok(thing) = world.object(id) else { return };
    let contact = world.options.tolerances.contact;
    let (footprint, span) = (thing.body.obb.footprint(), thing.body.obb.aabb());
    for (room, prism) in rooms {
        let level = span.min.y < prism.ceiling - contact && span.max.y > prism.floor + contact;
        let in_wall = |points: &[Vec2]| {
            let open = |p: &Vec2| openings.iter().any(|o| depth_in_convex(o, *p) >= -contact);
            let middle = points.iter().sum::<Vec2>() / points.len().max(1) as f64;
            // The middle of what a wall and the footprint share is well inside only where the wall is crossed.
            points.len() == 2 && depth_in_convex(&footprint, middle) > contact && !points.iter().all(open)
        };
        if level && prism.polygon.edges().any(|(a, b)| in_wall(&convex_overlap(&[a, b], &footprint))) {
            let object = &program.objects[id.0 as usize];
            let region = &program.regions[room.0 as usize];
            let message = format!("`{}` is inside a wall of `{}` where there is no door", object.name, region.name);
            out.push(Diagnostic::new(codes::W0503, object.span, message).related(region.span, "the room"));
            return;
        }
    }
}
