//! Built-in predicates, and the library of the language, written again by its text.

use super::eval::{Outcome, Value, World};
use super::flat;
use super::scene::{Room, Thing};
use super::solid::{self, Solid};
use super::space::{V, add, angle, distance, dot, length, sub, times};
use super::term::{Order, Term};
use super::value::{CONTACT, Kind, Num, Truth, compare};

const ETA: f64 = 0.03;

impl World<'_> {
    fn thing(&self, value: &Value) -> (usize, &Thing) {
        match value {
            Value::Object(i) => (*i, &self.scene.things[*i]),
            other => panic!("no object: {other:?}"),
        }
    }
    fn room(&self, value: &Value) -> &Room {
        match value {
            Value::Region(i) => &self.scene.rooms[*i],
            other => panic!("no region: {other:?}"),
        }
    }

    /// The least gap over the pairs of convex parts.
    pub fn gap_of(&self, a: usize, b: usize) -> f64 {
        let pairs = self.solids[a].iter().flat_map(|p| self.solids[b].iter().map(|q| solid::gap(p, q)));
        pairs.fold(f64::INFINITY, f64::min)
    }

    pub fn gap(&self, a: &Value, b: &Value) -> Num {
        let (x, noise) = match (a, b) {
            (Value::Object(a), Value::Object(b)) => {
                let gap = self.gap_of(*a, *b);
                (gap, distance_noise(gap))
            }
            (Value::Object(a), Value::Region(r)) => {
                let clearance = self.scene.rooms[*r].clearance(&self.scene.things[*a]);
                (clearance.value, if clearance.bound { f64::INFINITY } else { 1e-8 })
            }
            (Value::Vector(p), Value::Region(r)) => {
                let depth = flat::depth(&self.scene.rooms[*r].polygon(), [p.v[0], p.v[2]]);
                (depth, p.noise + 1e-9)
            }
            _ => panic!("no gap between {a:?} and {b:?}"),
        };
        Num { x, kind: Kind::Plain, noise }
    }

    /// The least of three clearances and the tolerance.
    pub fn inside_room(&self, thing: &Thing, room: &Room) -> Truth {
        let clearance = room.clearance(thing);
        let (lo, hi) = thing.span();
        let upright = (lo[1] - room.floor()).min(room.ceiling() - hi[1]);
        if !clearance.bound {
            return Truth::geometric(clearance.value.min(upright) + CONTACT);
        }
        // Its farthest point is at least so far outside: that may settle it.
        let bound = Truth::sign(clearance.value.min(upright) + CONTACT);
        if bound.holds == Some(false) { bound } else { Truth { holds: None, ..bound } }
    }

    fn inside_box(&self, a: &Thing, b: &Thing) -> Truth {
        let [w, h, d] = b.scale;
        let clearance = |corner: &V| {
            let off = sub(*corner, b.pos);
            let [x, y, z] = [0, 1, 2].map(|k| dot(off, b.axis(k)));
            (w / 2.0 - x.abs()).min(d / 2.0 - z.abs()).min(y).min(h - y)
        };
        Truth::geometric(a.cuboid().corners.iter().map(clearance).fold(f64::MAX, f64::min) + CONTACT)
    }

    /// The centre and both ends of the width are near the edges; between the higher floor and the lower ceiling.
    fn connects(&self, door: &Thing, rooms: &[&Room]) -> Truth {
        let half = times(door.axis(0), door.scale[0] / 2.0);
        let mut margin = f64::MAX;
        for room in rooms {
            let polygon = room.polygon();
            for point in [door.center(), add(door.center(), half), sub(door.center(), half)] {
                margin = margin.min(2.0 * ETA + 0.01 - flat::to_edges(&polygon, [point[0], point[2]]));
            }
            let (lo, hi) = door.span();
            margin = margin.min(lo[1] - room.floor() + 0.01).min(room.ceiling() - hi[1] + 0.01);
        }
        Truth::sign(margin)
    }

    fn visible(&self, a: usize, b: usize) -> Truth {
        let (from, to) = (self.scene.things[a].center(), self.scene.things[b].center());
        if distance(from, to) < 1e-6 {
            return Truth { holds: None, ..Truth::sign(0.0) };
        }
        let others = (0..self.boxes.len()).filter(|i| *i != a && *i != b);
        let gap = others.map(|i| solid::gap_to_line(&self.boxes[i], from, to)).fold(f64::INFINITY, f64::min);
        Truth { noise: f64::INFINITY, ..Truth::geometric(gap + CONTACT) }
    }

    /// What replaces P-SUPPORT of what is `wallMounted` or `ceilingMounted`: that it touches.
    pub fn touches(&self, mounted: &Term) -> Truth {
        let Term::Call(name, arguments) = mounted else { panic!("{mounted:?}") };
        let [Term::Object(a), Term::Region(r)] = arguments.as_slice() else { panic!("{arguments:?}") };
        let (a, room) = (&self.scene.things[*a], &self.scene.rooms[*r]);
        if name == "wallMounted" { back_to_wall(a, room, 0.01) } else { at_ceiling(a, room) }
    }

    /// The space on a side of an object, and what must not be in it.
    pub fn clear(&self, arguments: &[Term]) -> Outcome<Value> {
        let (Value::Object(i), Value::Num(depth)) = (self.value(&arguments[0])?, self.value(&arguments[2])?) else {
            panic!("clear of {arguments:?}");
        };
        let Term::Name(side) = &arguments[1] else { panic!("a side is a word") };
        let unknown = Ok(Value::Truth(Truth { holds: None, ..Truth::sign(0.0) }));
        let (thing, depth) = (&self.scene.things[i], depth.x);
        let [w, h, d] = thing.scale;
        let (lo, hi) = match side.as_str() {
            "front" => ([-w / 2.0, 0.0, d / 2.0], [w / 2.0, h, d / 2.0 + depth]),
            "behind" => ([-w / 2.0, 0.0, -d / 2.0 - depth], [w / 2.0, h, -d / 2.0]),
            "left" => ([-w / 2.0 - depth, 0.0, -d / 2.0], [-w / 2.0, h, d / 2.0]),
            "right" => ([w / 2.0, 0.0, -d / 2.0], [w / 2.0 + depth, h, d / 2.0]),
            _ => ([-w / 2.0, h, -d / 2.0], [w / 2.0, h + depth, d / 2.0]),
        };
        let space = Solid::cuboid(sub(hi, lo)).placed(&super::space::euler([0.0; 3]), times(add(lo, hi), 0.5));
        let space = space.placed(&thing.turned(), thing.pos);
        let low = thing.span().0[1] + 0.05;
        let Some(space) = (if side == "above" { Some(space) } else { space.above(low) }) else { return unknown };
        let others = (0..self.solids.len()).filter(|o| *o != i).flat_map(|o| &self.solids[o]);
        let gap = others.map(|other| solid::gap(&space, other)).fold(f64::INFINITY, f64::min);
        let mut truth = Truth::geometric(gap + CONTACT);
        let bounds = match self.doors.iter().find(|door| **door == i) {
            // Which room is on that side is tried by the cases; here nothing is said of it.
            Some(_) => return unknown,
            None => {
                let mut by: Vec<(f64, bool, usize)> = Vec::new();
                for (k, room) in self.scene.rooms.iter().enumerate() {
                    let clearance = room.clearance(thing);
                    let (lo, hi) = thing.span();
                    let value = clearance.value.min(lo[1] - room.floor()).min(room.ceiling() - hi[1]);
                    by.push((value, clearance.bound, k));
                }
                by.sort_by(|a, b| b.0.total_cmp(&a.0));
                // Which of several that hold it is the best is not said.
                if by.iter().any(|b| b.1) || by.len() > 1 && (by[1].0 > -0.01 || by[0].0 - by[1].0 < 1e-6) {
                    return unknown;
                }
                by.first().map(|b| &self.scene.rooms[b.2])
            }
        };
        if let Some(room) = bounds {
            let flat: Vec<_> = space.corners.iter().map(|c| [c[0], c[2]]).collect();
            let clearance = flat::clearance(&room.polygon(), &flat::hull(&flat));
            let sideways = Truth::geometric(clearance.value + CONTACT);
            let undecided = clearance.bound && sideways.holds != Some(false);
            truth = truth.and(if undecided { Truth { holds: None, ..sideways } } else { sideways });
            truth = truth.and(Truth::geometric(room.ceiling() - space.heights().1 + CONTACT));
        }
        Ok(Value::Truth(truth.rough()))
    }
}

/// Distances of solids that are far apart are found by approaching them.
pub fn distance_noise(gap: f64) -> f64 {
    1e-8 + 1e-7 * gap.max(0.0)
}

/// At most, of plain numbers.
fn at_most(a: f64, b: f64) -> Truth {
    Truth::at_least_zero(b - a)
}

pub fn predicate(world: &World<'_>, name: &str, values: &[Value]) -> Truth {
    match name {
        "inside" => match &values[1] {
            Value::Region(_) => world.inside_room(world.thing(&values[0]).1, world.room(&values[1])),
            _ => world.inside_box(world.thing(&values[0]).1, world.thing(&values[1]).1),
        },
        "collides" => Truth::geometric(world.gap(&values[0], &values[1]).x + CONTACT).not(),
        "connects" => {
            let rooms: Vec<&Room> = values[1..].iter().map(|v| world.room(v)).collect();
            world.connects(world.thing(&values[0]).1, &rooms)
        }
        "visible" => world.visible(world.thing(&values[0]).0, world.thing(&values[1]).0),
        "onFloor" | "againstWall" | "inCorner" | "centeredIn" | "wallMounted" | "ceilingMounted" => {
            in_room(world, name, world.thing(&values[0]).1, world.room(&values[1]))
        }
        "backToWall" => match values[2] {
            Value::Num(d) => back_to_wall(world.thing(&values[0]).1, world.room(&values[1]), d.x),
            _ => panic!("how far?"),
        },
        "near" | "far" => {
            let (Value::Object(_), Value::Num(d)) = (&values[1], &values[2]) else { panic!("{values:?}") };
            let order = if name == "near" { Order::Le } else { Order::Ge };
            compare(order, world.gap(&values[0], &values[1]), *d)
        }
        "between" => {
            let [a, b, c] = [0, 1, 2].map(|i| world.thing(&values[i]).1.center());
            at_most(distance(a, b) + distance(a, c), 1.1 * distance(b, c))
        }
        "around" => {
            let members = match &values[0] {
                Value::Objects(list) => list.clone(),
                one => vec![world.thing(one).0],
            };
            let Value::Num(d) = values[2] else { panic!("how far?") };
            around(world, &members, world.thing(&values[1]).0, d)
        }
        "beside" => {
            let (a, b) = (world.thing(&values[0]).1, world.thing(&values[1]).1);
            let side = of_two("leftOf", a, b).or(of_two("rightOf", a, b));
            let limit = Num { x: 0.5, kind: Kind::Plain, noise: 0.0 };
            side.and(compare(Order::Le, world.gap(&values[0], &values[1]), limit))
        }
        "on" => {
            let (a, b) = (world.thing(&values[0]).1, world.thing(&values[1]).1);
            let surface = b.surface.filter(|_| b.has_parts()).map_or(b.span().1[1], |height| b.pos[1] + height);
            at_most((a.span().0[1] - surface).abs(), 0.005).and(of_two("within", a, b))
        }
        "restsOn" => {
            let (a, b) = (world.thing(&values[0]).1, world.thing(&values[1]).1);
            let surface = b.surface.filter(|_| b.has_parts()).map_or(b.span().1[1], |height| b.pos[1] + height);
            at_most((a.span().0[1] - surface).abs(), 0.005).and(of_two("over", a, b))
        }
        _ => of_two(name, world.thing(&values[0]).1, world.thing(&values[1]).1),
    }
}

/// Predicates of two objects that read nothing but their boxes.
fn of_two(name: &str, a: &Thing, b: &Thing) -> Truth {
    let [w, _, d] = b.scale;
    let off = sub(a.center(), b.center());
    let (right, front) = (dot(off, b.axis(0)), dot(off, b.axis(2)));
    let (beyond_width, beyond_depth) = (right.abs() - w / 2.0, front.abs() - d / 2.0);
    let (a_lo, a_hi) = a.span();
    let (b_lo, b_hi) = b.span();
    let most = |x: f64, y: f64| x.max(y).max(0.0);
    match name {
        "leftOf" => at_most(most(beyond_depth, 0.0), -right - w / 2.0),
        "rightOf" => at_most(most(beyond_depth, 0.0), right - w / 2.0),
        "inFrontOf" => at_most(most(beyond_width, 0.0), front - d / 2.0),
        "behind" => at_most(most(beyond_width, 0.0), -front - d / 2.0),
        "above" => at_most(most(beyond_width, beyond_depth), a_lo[1] - b_hi[1]),
        "below" => at_most(most(beyond_width, beyond_depth), b_lo[1] - a_hi[1]),
        "within" => at_most(beyond_width.max(beyond_depth), 0.0),
        "over" => {
            let reach =
                |way: V| (dot(a.axis(0), way).abs() * a.scale[0] + dot(a.axis(2), way).abs() * a.scale[2]) / 2.0;
            let aside = right.abs() - (w / 2.0 - reach(b.axis(0))).max(0.05);
            let along = front.abs() - (d / 2.0 - reach(b.axis(2))).max(0.05);
            at_most(aside.max(along), 0.0)
        }
        "seenLeftOf" => of_two("rightOf", a, b),
        "seenRightOf" => of_two("leftOf", a, b),
        "looksAt" => {
            let to = sub(b.center(), a.center());
            let way = a.axis(0);
            let reach = (dot(b.axis(0), way).abs() * w + dot(b.axis(2), way).abs() * d) / 2.0;
            let past = dot(to, way).abs() - (reach - a.scale[0] / 2.0).max(0.0);
            at_most(past.max(0.0), 0.15 * dot(to, a.axis(2)))
        }
        "under" => {
            let lower = at_most(a_lo[1], b_lo[1]).or(at_most(a_hi[1], b_hi[1]));
            let deep = compare(Order::Gt, Num::plain(b_hi[1] - a_lo[1]), Num::plain(0.05));
            lower.and(deep).and(of_two("within", a, b))
        }
        "facing" => {
            let to = sub(b.center(), a.center());
            let toward = dot(to, a.axis(2)) - to[1] * a.axis(2)[1];
            at_most(0.866_025_4 * length([to[0], 0.0, to[2]]), toward)
        }
        "aligned" => at_most(right.abs().min(front.abs()), 0.05),
        "parallel" => {
            let between = angle(a.axis(2), b.axis(2));
            let noise = if !(0.01..179.99).contains(&between) { 1e-4 } else { 1e-8 };
            let turned = Num { x: between.min(180.0 - between), kind: Kind::Degree, noise };
            compare(Order::Le, turned, Num { x: 5.0, kind: Kind::Literal, noise: 0.0 })
        }
        _ => panic!("no predicate {name}"),
    }
}

fn in_room(world: &World<'_>, name: &str, a: &Thing, room: &Room) -> Truth {
    let inside = || world.inside_room(a, room);
    let wall = |p: V| flat::depth(&room.polygon(), [p[0], p[2]]);
    match name {
        "onFloor" => at_most((a.span().0[1] - room.floor()).abs(), 0.005).and(inside()),
        "againstWall" => inside().and(back_to_wall(a, room, 0.05)),
        "wallMounted" => inside().and(back_to_wall(a, room, 0.01)),
        "ceilingMounted" => inside().and(at_ceiling(a, room)),
        "inCorner" => {
            let side = times(a.axis(0), a.scale[0] / 2.0 + 0.15);
            let back = wall(sub(a.center(), times(a.axis(2), a.scale[2] / 2.0 + 0.15)));
            let beside = wall(sub(a.center(), side)).min(wall(add(a.center(), side)));
            inside().and(at_most(back.max(beside), 0.0))
        }
        "centeredIn" => {
            let off = sub(a.center(), room.center());
            at_most(length([off[0], 0.0, off[2]]), 0.1)
        }
        _ => panic!("no predicate {name}"),
    }
}

fn at_ceiling(a: &Thing, room: &Room) -> Truth {
    at_most((room.ceiling() - a.span().1[1]).abs(), 0.01)
}

fn back_to_wall(a: &Thing, room: &Room, d: f64) -> Truth {
    let back = sub(a.center(), times(a.axis(2), a.scale[2] / 2.0 + d));
    let half = times(a.axis(0), a.scale[0] / 2.0);
    let wall = |p: V| flat::depth(&room.polygon(), [p[0], p[2]]);
    at_most(wall(back).max(wall(sub(back, half))).max(wall(add(back, half))), 0.0)
}

fn around(world: &World<'_>, members: &[usize], b: usize, d: Num) -> Truth {
    let thing = &world.scene.things[b];
    let [w, _, depth] = thing.scale;
    let off = |c: &usize, axis: usize| dot(sub(world.scene.things[*c].center(), thing.center()), thing.axis(axis));
    let near = members.iter().map(|c| compare(Order::Le, world.gap(&Value::Object(*c), &Value::Object(b)), d));
    let all = near.fold(Truth::discrete(true), Truth::and);
    let one = |f: &dyn Fn(&usize) -> Truth| members.iter().map(f).fold(Truth::discrete(false), Truth::or);
    all.and(one(&|c| at_most(off(c, 0), w / 2.0)))
        .and(one(&|c| at_most(-w / 2.0, off(c, 0))))
        .and(one(&|c| at_most(off(c, 2), depth / 2.0)))
        .and(one(&|c| at_most(-depth / 2.0, off(c, 2))))
}
