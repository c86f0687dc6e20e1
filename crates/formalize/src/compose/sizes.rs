//! Sizes that the request leaves out: of things, so that what stands on them finds room; of rooms, so that all does.

use super::state::ACROSS;
use crate::brief::{Brief, Dim, FactKind, Group, Op, Place, Rel, Side, Thing};
use crate::read::lexicon::get;

/// Width, height and depth of every thing.
pub fn things(brief: &Brief) -> Vec<[f64; 3]> {
    let mut out: Vec<[f64; 3]> = brief.things.iter().map(|item| crate::sizes::usual(item.group, &item.words)).collect();
    out.iter_mut().zip(&brief.things).for_each(|(size, item)| by_look(size, item));
    by_relation(brief, &mut out);
    by_load(brief, &mut out);
    contained(brief, &mut out);
    limited(brief, &mut out);
    for size in &mut out {
        for v in size {
            *v = (*v * 100.0).round().max(1.0) / 100.0;
        }
    }
    out
}

/// What is lower than this (metres) and no furniture grows with what is said of its size.
const WHOLE: f64 = 1.0;

/// The usual size of what has a name of its own with something that is said of it: "a single bed".
fn by_kind(item: &Thing) -> Option<[f64; 3]> {
    const KINDS: [&str; 3] = ["bed", "sofa", "table"];
    let plain = item.words.join(" ");
    let kind = item.words.last().filter(|last| KINDS.contains(&last.as_str()))?;
    let names = item.look.features.iter().map(|feature| feature.replace('-', " "));
    let mut named = names.flat_map(|feature| [format!("{feature} {plain}"), format!("{feature} {kind}")]);
    named.find_map(|name| scenelang_lang::nouns::noun(&name)).map(|noun| noun.size)
}

/// A size as its look has it: large, low, round, and what was said in figures.
fn by_look(size: &mut [f64; 3], item: &Thing) {
    if let Some(own) = by_kind(item) {
        *size = own;
    }
    let feature = |words: &[&str]| item.look.features.iter().any(|f| words.contains(&f.as_str()));
    let scale = if feature(&["small", "little", "tiny", "compact", "mini"]) {
        0.75
    } else if feature(&["large", "big", "huge", "giant", "massive", "oversized"]) {
        1.3
    } else {
        1.0
    };
    size[0] *= scale;
    size[2] *= scale;
    // What is no furniture is larger or smaller as a whole.
    let whole = matches!(item.group, Group::Top | Group::Soft | Group::Floor) && size[1] <= WHOLE;
    if whole {
        size[1] *= scale;
    }
    if whole && feature(&["huge", "giant", "massive", "life-size", "life-sized", "oversized"]) {
        size.iter_mut().for_each(|v| *v *= 1.4);
    }
    if item.group == Group::Seat && feature(&["tiny", "child-sized", "child-size"]) {
        size[1] *= 0.65;
    }
    if feature(&["long"]) {
        size[0] *= 1.4;
    }
    if feature(&["low"]) && size[1] > 0.45 {
        size[1] = (size[1] * 0.6).max(0.35);
    }
    if feature(&["tall", "high"]) && item.group != Group::Seat {
        size[1] = (size[1] * 1.2).min(2.2);
    }
    if feature(&["round", "circular"]) && matches!(item.group, Group::Table | Group::Flat) {
        size[2] = size[0].min(size[2].max(0.7 * size[0]));
        size[0] = size[2];
    }
    if feature(&["square"]) && matches!(item.group, Group::Table | Group::Flat) {
        let side = size[0].min(size[2]).max(0.7 * size[0]);
        (size[0], size[2]) = (side, side);
    }
    for (have, said) in size.iter_mut().zip(item.size) {
        *have = said.unwrap_or(*have);
    }
}

/// What stands in a relation that says something of its size.
fn by_relation(brief: &Brief, out: &mut [[f64; 3]]) {
    for fact in brief.facts.iter().filter(|f| !f.not) {
        for a in &fact.of {
            let item = &brief.things[*a];
            let large = ["wardrobe", "closet", "locker", "armoire", "safe", "trunk"];
            let shelf = item.group == Group::Storage
                && out[*a][1] > 0.7
                && !item.words.last().is_some_and(|w| large.contains(&w.as_str()));
            match &fact.what {
                // What stores and hangs is no tall thing.
                FactKind::Rel(Rel::Above, _) | FactKind::Place(Rel::Mounted | Rel::Hang, Place::Wall, _)
                    if shelf && !item.look.features.iter().any(|f| f == "tall") =>
                {
                    out[*a][1] = item.size[1].unwrap_or(0.5);
                    out[*a][2] = item.size[2].unwrap_or(out[*a][2].min(0.32));
                }
                // A hood above all of them is as long as they are.
                FactKind::Rel(Rel::Above, to) if to.len() > 1 && item.size[0].is_none() => {
                    let all: f64 = to.iter().map(|b| out[*b][0] + 0.1).sum();
                    out[*a][0] = out[*a][0].max(all);
                }
                // "a lamp" on a table is no standard lamp.
                FactKind::Rel(Rel::On, to)
                    if item.size[1].is_none()
                        && item.name() == "lamp"
                        && to.iter().any(|b| matches!(brief.things[*b].group, Group::Table | Group::Storage)) =>
                {
                    out[*a] = [0.25, 0.45, 0.25];
                }
                // A statue on a plinth is no larger than its top.
                FactKind::Rel(Rel::On, to)
                    if item.size == [None; 3] && to.iter().all(|b| is_plinth(brief, *b)) && out[*a][1] > 0.4 =>
                {
                    let top = to.iter().map(|b| out[*b][0].min(out[*b][2])).fold(f64::INFINITY, f64::min);
                    let factor = (0.75 * top / out[*a][0].max(out[*a][2])).min(1.0);
                    out[*a] = [out[*a][0] * factor, (out[*a][1] * factor).min(0.8), out[*a][2] * factor];
                }
                // What is under another is no higher than that.
                FactKind::Rel(Rel::Under, to) => {
                    let least = |b: &usize| {
                        let under = matches!(brief.things[*b].group, Group::Table | Group::Bed | Group::Seat);
                        if under { out[*b][1] - 0.08 } else { f64::INFINITY }
                    };
                    let most = to.iter().map(least).fold(f64::INFINITY, f64::min);
                    if item.size[1].is_none() && most > 0.05 {
                        out[*a][1] = out[*a][1].min(most);
                    }
                }
                _ => {}
            }
        }
    }
}

/// What shows one thing on its top.
fn is_plinth(brief: &Brief, thing: usize) -> bool {
    brief.things[thing].words.last().is_some_and(|word| matches!(word.as_str(), "plinth" | "pedestal" | "podium"))
}

/// What a thing has to carry, or to have beside it: metres along it, square metres, and the sides of the largest.
struct Load {
    width: f64,
    area: f64,
    sides: [f64; 2],
}

/// What stands on another needs its place there.
fn by_load(brief: &Brief, out: &mut [[f64; 3]]) {
    for b in (0..brief.things.len()).filter(|b| brief.things[*b].part.is_none()) {
        let carries = matches!(
            brief.things[b].group,
            Group::Table | Group::Storage | Group::Bed | Group::Flat | Group::Seat | Group::Floor | Group::Top
        );
        if brief.things[b].size[0].is_some() || !carries || is_plinth(brief, b) {
            continue;
        }
        if is_for_two(&brief.things[b]) {
            out[b][0] = out[b][0].min(FOR_TWO);
            out[b][2] = out[b][2].min(FOR_TWO);
        }
        let Load { width, area, sides } = load(brief, out, b);
        let width = width.max(places(&brief.things[b], brief.count(b)));
        let flat = brief.things[b].group == Group::Flat;
        let top = out[b][0] * out[b][2];
        let wanted = area * if flat { 2.2 } else { 1.8 };
        if wanted > top {
            let grow = (wanted / top).sqrt();
            out[b][0] *= grow * grow.sqrt();
            out[b][2] *= grow.sqrt();
        }
        let [short, long] = if out[b][0] < out[b][2] { [0, 2] } else { [2, 0] };
        out[b][short] = out[b][short].max(sides[0]);
        out[b][long] = out[b][long].max(sides[1]);
        out[b][0] = out[b][0].max(width);
        if brief.things[b].look.features.iter().any(|f| f == "round") && width > 0.0 {
            out[b][2] = out[b][0];
        }
    }
}

/// The side of a table at which two sit across from each other (metres; Neufert, Architects' Data: 0.75 to 0.8).
const FOR_TWO: f64 = 0.8;

/// Whether it is a table that is said to be for two.
fn is_for_two(thing: &Thing) -> bool {
    const SAT_AT: [&str; 8] = ["", "dining", "restaurant", "cafe", "café", "bistro", "kitchen", "breakfast"];
    let kind = thing.words.iter().rev().nth(1).map_or("", String::as_str);
    let is_table = thing.words.last().is_some_and(|word| word == "table");
    is_table && SAT_AT.contains(&kind) && thing.places.is_some_and(|places| places <= 2)
}

/// How long a thing is for the people it is said to be for: they sit around a round table, at both long sides of another,
/// and side by side on a sofa and in a bed.
fn places(item: &Thing, count: usize) -> f64 {
    const EACH: f64 = 0.6;
    // "Chairs for eight" are eight chairs, each for one; "six tables for eight" are for eight each.
    let each = |n: usize| if item.seats_each() { n } else { n.div_ceil(count.max(1)) };
    let Some(people) = item.places.map(|n| each(n) as f64) else { return 0.0 };
    match item.group {
        Group::Table if item.look.features.iter().any(|f| f == "round") => people * EACH / std::f64::consts::PI,
        Group::Table => (people / 2.0).ceil() * EACH,
        // Half of them sit across the table.
        Group::Seat if item.words.last().is_some_and(|w| w == "booth") => (people / 2.0).ceil() * EACH,
        _ => people * EACH,
    }
}

fn load(brief: &Brief, out: &[[f64; 3]], b: usize) -> Load {
    let mut width = 0.0;
    let mut area = 0.0;
    let mut sides = [0.0_f64; 2];
    for fact in brief.facts.iter().filter(|f| !f.not) {
        let FactKind::Rel(rel, to) = &fact.what else { continue };
        if !to.iter().any(|t| brief.whole(*t) == b) {
            continue;
        }
        for a in &fact.of {
            let each = (brief.count(*a) as f64 / brief.count(b) as f64).ceil();
            match rel {
                // A cushion is as large as its seat.
                Rel::On if brief.things[*a].group == Group::Soft && brief.things[b].group == Group::Seat => {}
                Rel::On => {
                    // A dryer on a washer takes all of it.
                    let stacked = each == 1.0 && [*a, b].iter().all(|it| brief.things[*it].group == Group::Floor);
                    if !stacked {
                        area += each * (out[*a][0] + 0.08) * (out[*a][2] + 0.08);
                    }
                    // All of it rests there, turned as it may be; a cloth hangs down.
                    if brief.things[*a].group != Group::Soft {
                        let own = [out[*a][0].min(out[*a][2]), out[*a][0].max(out[*a][2])];
                        sides = [0, 1].map(|k| sides[k].max(own[k] + 0.02));
                    }
                }
                Rel::InFrontOf | Rel::Along
                    if brief.things[*a].group == Group::Seat && each > 1.0 && seats(brief, b) =>
                {
                    width = each * (out[*a][0] + 0.12)
                }
                Rel::LongSide if each > 1.0 => width = f64::max(width, each * (out[*a][0] + 0.12)),
                Rel::Around | Rel::At if brief.things[*a].group == Group::Seat && each > 2.0 && seats(brief, b) => {
                    // Half of them at either long side, the ends left free.
                    width = f64::max(width, (each / 2.0).ceil() * (out[*a][0] + 0.15));
                }
                Rel::Under if brief.things[*a].group != Group::Flat => width = each * (out[*a][0] + 0.1),
                _ => {}
            }
        }
    }
    Load { width, area, sides }
}

/// Sizes that the request limits.
fn limited(brief: &Brief, out: &mut [[f64; 3]]) {
    for fact in &brief.facts {
        let FactKind::Size(dim, op, v) = &fact.what else { continue };
        let axis = match dim {
            Dim::Height | Dim::Ceiling | Dim::Elevation => 1,
            Dim::Depth => 2,
            _ => 0,
        };
        for a in &fact.of {
            match op {
                Op::Most => out[*a][axis] = out[*a][axis].min(*v),
                Op::Least => out[*a][axis] = out[*a][axis].max(*v),
                Op::Equal => out[*a][axis] = *v,
            }
        }
    }
}

/// Makes what is in another small enough for it, side by side with what else is there.
fn contained(brief: &Brief, out: &mut [[f64; 3]]) {
    let inside = |b: usize| {
        brief
            .facts
            .iter()
            .filter(move |f| matches!(&f.what, FactKind::Rel(Rel::In, to) if !f.not && to.as_slice() == [b]))
    };
    for b in 0..brief.things.len() {
        let shelf = brief.things[b].group == Group::Storage;
        if matches!(
            brief.things[b].group,
            Group::Seat | Group::Flat | Group::Table | Group::Bed | Group::Door | Group::Window
        ) {
            continue;
        }
        let things: Vec<usize> = inside(b).flat_map(|f| f.of.iter().copied()).collect();
        let n: usize = things.iter().map(|a| brief.count(*a)).sum();
        let n = (n as f64 / brief.count(b) as f64).ceil().max(1.0);
        let [w, h, d] = out[b];
        // In a row; in a round or square thing in two.
        let (columns, rows) = if n > 3.0 && d > 0.7 * w { ((n / 2.0).ceil(), 2.0) } else { (n, 1.0) };
        let most =
            [0.95 * w / columns - 0.01, if shelf { 0.4_f64.min(0.9 * h) } else { 0.9 * h }, 0.95 * d / rows - 0.01];
        for a in things {
            let item = &brief.things[a];
            let small = matches!(item.group, Group::Top | Group::Soft | Group::Floor | Group::Wall);
            for k in (0..3).filter(|k| small && item.size[*k].is_none()) {
                out[a][k] = out[a][k].min(most[k].max(0.02));
            }
        }
    }
}

/// Whether people sit at a thing, so that it is as long as they need.
pub fn seats(brief: &Brief, item: usize) -> bool {
    let head = brief.things[item].head();
    ["table", "desk", "bar", "counter", "island", "worktop"].iter().any(|w| head.ends_with(w))
}

/// Makes what stands at walls narrower, where a room of a given size has not so much wall.
pub fn fit_walls(brief: &Brief, sizes: &mut [[f64; 3]], rooms: &[[f64; 3]]) {
    for (i, size) in sizes.iter_mut().enumerate() {
        let item = &brief.things[i];
        let n = brief.count(i) as f64;
        let which = brief.facts.iter().find_map(|f| match &f.what {
            FactKind::Place(Rel::Against | Rel::Along | Rel::At | Rel::On, Place::Wall, which)
                if f.of == [i] && !f.not =>
            {
                Some(which)
            }
            _ => None,
        });
        let (Some(which), Some([w, _, d])) = (which, rooms.get(item.room)) else { continue };
        if n < 2.0 || item.size[0].is_some() || item.opening() || item.part.is_some() {
            continue;
        }
        let said = |words: &[&str]| which.iter().any(|w| words.contains(&w.as_str()));
        let both = if said(&["each"]) { 2.0 } else { 1.0 };
        let free = if said(&["long", "longer", "longest"]) {
            w.max(*d) * both
        } else if said(&["short", "shorter", "end"]) {
            w.min(*d) * both
        } else if said(&["north", "south", "back", "front", "rear", "far"]) {
            *w
        } else if said(&["east", "west", "left", "right"]) {
            *d * both
        } else {
            // All around, but for what stands across the corners.
            ((2.0 * (w + d) - 8.0 * size[2]) * 0.9).max(1.0)
        };
        let most = (free - 0.8) / n - 0.04;
        if size[0] > most && most > 0.2 {
            size[0] = (most * 20.0).floor() / 20.0;
        }
    }
}

/// Whether a thing takes floor.
fn stands(brief: &Brief, item: usize) -> bool {
    let group = brief.things[item].group;
    let floor = !matches!(
        group,
        Group::Wall
            | Group::Ceiling
            | Group::Top
            | Group::Flat
            | Group::Soft
            | Group::Drape
            | Group::Door
            | Group::Window
            | Group::Screen
    );
    floor && !brief.facts.iter().any(|f| !f.not && f.of.contains(&item) && matches!(&f.what, FactKind::Rel(Rel::On | Rel::In, to) if to.iter().all(|t| brief.things[*t].group != Group::Flat)))
}

/// Width, height and depth of every room, and an outline where it is no rectangle.
pub fn rooms(brief: &Brief, sizes: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let mut out = Vec::new();
    for (r, room) in brief.rooms.iter().enumerate() {
        let words: Vec<String> = room.name.split(' ').map(str::to_owned).collect();
        let kind = get().room_ending(&words).map_or([5.0, 4.0, 2.7], |(_, k)| k.size);
        let kind = room.usual.map_or(kind, |[w, h, d]| [w, d, h]);
        // Room for everything, and to walk between.
        let mut need = 4.0;
        let mut along = 0.0;
        let mut widest = 2.0_f64;
        let mut tallest = 2.2_f64;
        for (i, item) in brief.things.iter().enumerate().filter(|(_, item)| item.room == r || item.beyond == Some(r)) {
            let n = brief.count(i) as f64;
            let [w, h, d] = sizes[i];
            widest = widest.max(w + 1.0).max(d + 1.0);
            tallest = tallest.max(h + 0.2);
            let spread = spread(brief, i);
            if stands(brief, i) && item.part.is_none() {
                need += n * (w + 0.35 + spread) * (d + 0.55 + spread);
            }
            if item.group == Group::Flat {
                need += n * w * d * 0.5;
            }
            let at_wall = brief.facts.iter().any(|f| {
                !f.not && f.of.contains(&i) && matches!(f.what, FactKind::Place(_, Place::Wall | Place::Corner, _))
            });
            if at_wall && !item.opening() || item.opening() && item.part.is_none() {
                along += n * (w + 0.35);
            }
        }
        let grids = rows(brief, sizes, r);
        let apart = distances(brief, r);
        need = need * 1.7 + apart * 3.0;
        let side = (along / 4.0 * 1.5).max(widest).max(apart + 2.2);
        let [mut w, mut d] = [kind[0], kind[1]];
        if need > w * d {
            let grow = (need / (w * d)).sqrt();
            w *= grow;
            d *= grow;
        }
        w = w.max(side);
        d = d.max(side * 0.85);
        if grids[0] > 0.0 {
            w = w.max(grids[0] + 2.0);
            d = d.max(grids[1] + 3.2 + apart);
        }
        let [sw, sh, sd] = room.size;
        match (sw, sd, room.area) {
            (Some(a), Some(b), _) => (w, d) = (a, b),
            (Some(a), None, Some(area)) => (w, d) = (a, area / a),
            (None, Some(b), Some(area)) => (w, d) = (area / b, b),
            (Some(a), None, None) => (w, d) = (a, (need / a).max(kind[1])),
            (None, Some(b), None) => (w, d) = ((need / b).max(kind[0]), b),
            (None, None, Some(area)) => {
                let ratio = (kind[0] / kind[1]).clamp(1.0, 1.5);
                w = (area * ratio).sqrt();
                d = area / w;
            }
            (None, None, None) => {
                w = (w * 5.0).ceil() / 5.0;
                d = (d * 5.0).ceil() / 5.0;
            }
        }
        let h = sh.unwrap_or(kind[2].max(tallest).max(above(brief, r, sizes)));
        out.push([w, h, d].map(|v| ((v * 1000.0).round() / 1000.0).clamp(0.5, 500.0)));
    }
    out
}

/// What the rows take that are asked for in a room (x, z); zero without rows.
pub fn rows(brief: &Brief, sizes: &[[f64; 3]], room: usize) -> [f64; 2] {
    let own = (0..brief.things.len()).filter(|i| brief.things[*i].room == room);
    let grids = own.filter_map(|i| super::grid::grid(brief, sizes, i, None));
    grids.fold([0.0_f64; 2], |all, g| [all[0].max(g.takes[0]), all[1] + g.takes[1]])
}

/// How far apart the things of an array are to be.
fn spread(brief: &Brief, item: usize) -> f64 {
    let mut out = 0.0_f64;
    for f in brief.facts.iter().filter(|f| f.of.contains(&item)) {
        match &f.what {
            FactKind::Among(_, v) => out = out.max(*v),
            FactKind::Clear(Side::Front | Side::Behind | Side::Sides | Side::Around, v) => out = out.max(v * 0.7),
            FactKind::Path(v, _) => out = out.max(v * 0.5),
            FactKind::Gap(Op::Least, v, to) if to.iter().any(|t| brief.count(*t) > 1) => out = out.max(v * 0.5),
            _ => {}
        }
    }
    out
}

/// The longest distance that is asked for in a room.
fn distances(brief: &Brief, room: usize) -> f64 {
    let mut out = 0.0_f64;
    for f in brief.facts.iter().filter(|f| f.of.iter().any(|i| brief.things[*i].room == room)) {
        match &f.what {
            FactKind::Rel(Rel::Opposite, _) if !f.not => out = out.max(ACROSS),
            FactKind::Gap(Op::Least | Op::Equal, v, _)
            | FactKind::Wall(Op::Least | Op::Equal, v)
            | FactKind::Alone(v)
            | FactKind::Clear(_, v) => out = out.max(*v),
            _ => {}
        }
    }
    out
}

/// How high a room must be for what hangs above other things.
fn above(brief: &Brief, room: usize, sizes: &[[f64; 3]]) -> f64 {
    let mut out = 0.0_f64;
    for f in &brief.facts {
        let FactKind::Rel(Rel::Above, to) = &f.what else { continue };
        for a in f.of.iter().filter(|a| brief.things[**a].room == room) {
            for b in to {
                out = out
                    .max(sizes[*a][1] + sizes[*b][1] + if brief.things[*b].group == Group::Window { 1.1 } else { 0.3 });
            }
        }
    }
    out
}
