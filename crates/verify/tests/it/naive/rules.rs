//! The physical rules by their text, over all pairs and all objects.

use super::eval::World;
use super::flat::{self, P};
use super::library::distance_noise;
use super::program::{Program, conjuncts};
use super::solid::Solid;
use super::term::Term;
use super::value::{CONTACT, Truth};

/// How far the lowest point may be from what carries it.
const SUPPORT: f64 = 5e-3;

/// What the statements lift.
#[derive(Default)]
pub struct Lifted {
    pub contents: Vec<(usize, usize)>,
    /// The object, and the predicate that says where it is held.
    pub mounts: Vec<(usize, Term)>,
    pub doors: Vec<usize>,
}

/// Of the assertions, expanded.
pub fn lifted(asserted: &[Term]) -> Lifted {
    let mut all = Vec::new();
    asserted.iter().for_each(|t| conjuncts(t, &mut all));
    let mut out = Lifted::default();
    for term in all {
        let Term::Call(name, arguments) = term else { continue };
        match (name.as_str(), arguments.as_slice()) {
            ("inside", [Term::Object(a), Term::Object(b)]) if a != b => out.contents.push((*a, *b)),
            ("wallMounted" | "ceilingMounted", [Term::Object(a), _]) => out.mounts.push((*a, term.clone())),
            ("connects", [Term::Object(a), ..]) => out.doors.push(*a),
            _ => {}
        }
    }
    out
}

/// What a rule must say.
pub struct Ruling {
    /// `P-COLLIDE:a:b`.
    pub id: String,
    pub truth: Truth,
}

pub fn rulings(world: &World<'_>, program: &Program, lifted: &Lifted) -> Vec<Ruling> {
    let things = &world.scene.things;
    let mut out = Vec::new();
    // Pairs of content and container, and content of the content.
    let mut within: Vec<(usize, usize)> =
        lifted.contents.iter().copied().filter(|(_, b)| !things[*b].has_parts()).collect();
    loop {
        let further = |(a, b): &(usize, usize)| {
            let next = within.iter().filter(move |(c, _)| c == b);
            next.map(|(_, d)| (*a, *d)).collect::<Vec<_>>()
        };
        let new: Vec<_> = within.iter().flat_map(further).filter(|pair| !within.contains(pair)).collect();
        if new.is_empty() {
            break;
        }
        within.extend(new);
    }
    for a in 0..things.len() {
        for b in a + 1..things.len() {
            let either = |list: &[(usize, usize)]| list.contains(&(a, b)) || list.contains(&(b, a));
            if either(&program.collide) || either(&within) {
                continue;
            }
            let (first, second) =
                (things[a].name.as_str().min(&things[b].name), things[a].name.as_str().max(&things[b].name));
            let gap = world.gap_of(a, b);
            let truth = Truth { noise: distance_noise(gap), ..Truth::geometric(gap + CONTACT) };
            out.push(Ruling { id: format!("P-COLLIDE:{first}:{second}"), truth });
        }
    }
    for (i, thing) in things.iter().enumerate() {
        let is_door = lifted.doors.contains(&i);
        if !world.scene.rooms.is_empty() && !is_door && !program.outside.contains(&i) {
            let insides = world.scene.rooms.iter().map(|room| world.inside_room(thing, room));
            let truth = insides.fold(Truth::discrete(false), Truth::or);
            out.push(Ruling { id: format!("P-BOUNDS:{}", thing.name), truth });
        }
        if is_door || program.float.contains(&i) {
            continue;
        }
        let held = lifted.contents.iter().any(|(a, b)| *a == i && !things[*b].has_parts());
        // Where two statements hold it, one that does is enough.
        let mounts = lifted.mounts.iter().filter(|(a, _)| *a == i).map(|(_, on)| world.touches(on));
        let truth = match mounts.reduce(Truth::or) {
            Some(touches) => touches,
            None if held => Truth::discrete(true),
            None => support(world, i),
        };
        out.push(Ruling { id: format!("P-SUPPORT:{}", thing.name), truth: truth.rough() });
    }
    out
}

/// Whether something stands: its lowest points on floors and tops, its centre over what they touch.
fn support(world: &World<'_>, i: usize) -> Truth {
    let unknown = Truth { holds: None, ..Truth::sign(0.0) };
    let thing = &world.scene.things[i];
    let solids = &world.solids[i];
    let lowest = solids.iter().map(|s| s.heights().0).fold(f64::MAX, f64::min);
    let center = [thing.center()[0], thing.center()[2]];
    // What of it is lowest. Where more is nearly as low, the text does not say what touches.
    let (mut bases, mut wides): (Vec<Vec<P>>, Vec<Vec<P>>) = Default::default();
    for solid in solids {
        let above = |c: &[f64; 3]| c[1] - lowest;
        let down = |face: &Vec<usize>| 180.0 - solid.tilt(face);
        let nearly = solid.faces.iter().any(|f| (1e-3..1.5).contains(&down(f)));
        let level = solid.faces.iter().any(|f| down(f) < 1e-3);
        let hover = |c: &[f64; 3]| (1e-7..2.0 * SUPPORT).contains(&above(c));
        let lower = if level { hover(&[0.0, solid.heights().0, 0.0]) } else { solid.corners.iter().any(hover) };
        if nearly || lower {
            return unknown;
        }
        let low: Vec<P> = solid.corners.iter().filter(|c| above(c) < 1e-7).map(|c| [c[0], c[2]]).collect();
        if !low.is_empty() {
            bases.push(flat::hull(&low));
            // What is within the tolerance of being lowest may touch, too: it must not matter.
            let wide = solid.below(lowest + SUPPORT).into_iter().map(|c| [c[0], c[2]]);
            wides.push(flat::hull(&wide.collect::<Vec<P>>()));
        }
    }
    let mut sure = true;
    let mut contact: Vec<P> = Vec::new();
    let mut perhaps: Vec<P> = Vec::new();
    let at_height = |height: f64, sure: &mut bool| {
        let off = (lowest - height).abs();
        *sure &= (off - SUPPORT).abs() > 1e-6;
        off <= SUPPORT
    };
    let over: Vec<_> = world.scene.rooms.iter().filter(|r| flat::holds(&r.polygon(), center)).collect();
    // What is a millimetre outside is as good as inside.
    let edge = world.scene.rooms.iter().any(|r| flat::to_edges(&r.polygon(), center) < 1.1e-3);
    if edge {
        return unknown;
    }
    for room in &over {
        if at_height(room.floor(), &mut sure) {
            let polygon = room.polygon();
            perhaps.extend(wides.iter().flatten());
            for base in &bases {
                let whole = flat::clearance(&polygon, base).value >= -1e-9;
                if whole {
                    contact.extend(base);
                }
            }
        }
    }
    if over.is_empty() && at_height(0.0, &mut sure) {
        contact.extend(bases.iter().flatten());
        perhaps.extend(wides.iter().flatten());
    }
    for other in (0..world.solids.len()).filter(|o| *o != i) {
        for solid in &world.solids[other] {
            for top in tops(solid, &mut sure) {
                if !at_height(top.1, &mut sure) {
                    continue;
                }
                for base in &bases {
                    // A hair more and a hair less, so that an edge that only touches is told.
                    contact.extend(flat::clip(&grown(base, 1.0 - 1e-5), &top.0));
                }
                for wide in &wides {
                    perhaps.extend(flat::clip(&grown(wide, 1.0 + 1e-5), &grown(&top.0, 1.0 + 1e-5)));
                }
            }
        }
    }
    let stands = |points: &[P]| flat::to_hull(&flat::hull(points), center);
    let all: Vec<P> = contact.iter().chain(&perhaps).copied().collect();
    let (less, more) = (stands(&contact), stands(&all));
    let near = |d: f64| (d - 1e-3).abs() < 1e-4;
    if !sure || near(less) || near(more) || (less <= 1e-3) != (more <= 1e-3) {
        return unknown;
    }
    // On a mere edge or point it stands by no more than the tolerance.
    if bases.iter().map(Vec::len).sum::<usize>() < 3 && less < 2e-3 {
        return unknown;
    }
    let holds = less <= 1e-3;
    Truth { holds: Some(holds), ..Truth::sign(if holds { 1e-3 } else { -1e-3 }) }
}

/// Level faces on the upper side: outline, running to the left, and height.
fn tops(solid: &Solid, sure: &mut bool) -> Vec<(Vec<P>, f64)> {
    let mut out = Vec::new();
    for face in &solid.faces {
        let tilt = solid.tilt(face);
        // The height of a face that is not quite level is not one number.
        *sure &= !(1e-3..1.5).contains(&tilt);
        if tilt < 1e-3 {
            let outline: Vec<P> = face.iter().map(|c| [solid.corners[*c][0], solid.corners[*c][2]]).collect();
            out.push((flat::hull(&outline), solid.corners[face[0]][1]));
        }
    }
    out
}

/// A convex outline, larger or smaller about its middle.
fn grown(outline: &[P], by: f64) -> Vec<P> {
    let n = outline.len() as f64;
    let middle = outline.iter().fold([0.0; 2], |m, p| [m[0] + p[0] / n, m[1] + p[1] / n]);
    outline.iter().map(|p| [0, 1].map(|k| middle[k] + by * (p[k] - middle[k]))).collect()
}
