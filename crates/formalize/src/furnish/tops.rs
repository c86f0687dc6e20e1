//! Small things that are asked for and of which nobody says where they stand: a coffee machine stands on a counter, a
//! laptop on a desk, and not on the floor. What carries what is in `data/carriers.txt`.

use super::groups::{self, GroupPart, Where};
use super::inventory::single;
use super::kinds::{Count, Line, PlanPlace};
use super::plan::Plan;
use super::slots::{Level, Slot, Taken};
use super::{place, stand};
use crate::brief::Group;
use crate::draft::{DraftThing, ThingOrigin};
use crate::names::{mentions, words};
use scenelang_lang::nouns::{self, Stands, with_article};
use std::sync::OnceLock;

/// Nothing is put on what is higher (metres).
const HIGHEST: f64 = 1.35;
/// From the edge of a top, and from one place that is tried to the next (metres).
const EDGE: f64 = 0.02;
const STEP: f64 = 0.05;
/// Their tops are sloped.
const SLOPED: [&str; 3] = ["mixing desk", "drafting table", "pinball machine"];
/// So many of the carriers in a list are the most usual ones.
const USUAL: usize = 5;
/// The part of a round top, and of a seat or a bed, that things stand on.
const ROUND: f64 = 0.7;
const SEAT: f64 = 0.6;

/// Whether a thing that is asked for stands on something, and nobody says on what.
pub fn waits(plan: &Plan, at: usize) -> bool {
    let thing = &plan.draft.things[at];
    is_small(thing) && !plan.claimed.contains(&at) && is_loose(plan, thing)
}

/// Puts what waits on a thing that is being dressed, if it is among the most usual carriers of such things.
pub fn load(plan: &mut Plan, of: usize) {
    let name = plan.draft.things[of].category.replace('_', " ");
    // What a television stands on is for the television.
    let parts = groups::of(&name, plan.kind.dress);
    if parts.iter().any(|part| part.noun == "tv" && matches!(part.at, Where::Top(..))) {
        return;
    }
    for at in plan.small.clone() {
        let noun = plan.draft.things[at].category.replace('_', " ");
        if !plan.claimed.contains(&at) && rank(plan, of, &noun).is_some_and(|rank| rank <= USUAL) {
            put(plan, at, of);
        }
    }
}

/// Puts it on something in the room. Whether there was a place.
pub fn carry(plan: &mut Plan, at: usize) -> bool {
    let noun = plan.draft.things[at].category.replace('_', " ");
    let mut carriers: Vec<(usize, usize)> = (0..plan.draft.things.len())
        .filter(|of| *of != at)
        .filter_map(|of| Some((rank(plan, of, &noun)?, of)))
        .collect();
    carriers.sort_unstable();
    plan.claimed.contains(&at) || carriers.into_iter().any(|(_, of)| put(plan, at, of))
}

/// Adds the most usual carrier of such things to a room where nothing has a place for it, and puts it there. Whether that
/// was possible.
pub fn carry_on_new(plan: &mut Plan, at: usize) -> bool {
    let thing = plan.draft.things[at].clone();
    let (noun, Some(own)) = (thing.category.replace('_', " "), thing.size) else { return false };
    let fits = |size: [f64; 3], n: usize| own[0] * n as f64 <= size[0] && own[2] <= size[2] && size[1] <= HIGHEST;
    let stands = |noun: &str| matches!(stand::group(noun), Group::Table | Group::Storage);
    let wanted =
        |n: usize| carriers(&noun).iter().find(|on| stands(on) && !plan.is_closed(on) && fits(Plan::size(on), n));
    // All on one, or each on its own.
    let all = wanted(thing.count).map(|carrier| (carrier, 1));
    let Some((carrier, n)) = all.or_else(|| Some((wanted(1)?, thing.count))) else { return false };
    let before = plan.draft.things.len();
    plan.matters = true;
    let line = Line {
        count: Count::Fixed(n),
        noun: carrier,
        place: PlanPlace::Wall,
        least: 0.0,
        gap: 0.0,
        by: Default::default(),
    };
    single(plan, &line, n, &format!("{} stands on {}", with_article(&noun), with_article(carrier)));
    plan.draft.things.len() > before && carry(plan, at)
}

/// What was said of the small things before they had a place, for the lack of anything better, is said no more.
pub fn settle(plan: &mut Plan) {
    let placed = plan.small.iter().filter(|at| plan.claimed.contains(at));
    let names: Vec<String> = placed.map(|at| plan.draft.things[*at].name.clone()).collect();
    let is_about = |text: &str| words(text).iter().any(|word| names.iter().any(|name| name == word));
    plan.draft
        .statements
        .retain(|s| matches!(s.source, ThingOrigin::Stated(_)) || !is_default(&s.text) || !is_about(&s.text));
}

/// Puts a thing on another. Whether there was a place.
fn put(plan: &mut Plan, at: usize, of: usize) -> bool {
    let (thing, carrier) = (plan.draft.things[at].clone(), plan.draft.things[of].clone());
    let Some(own) = thing.size else { return false };
    let noun = thing.category.replace('_', " ");
    // As many on each of several carriers, if there is at least one for each.
    let each = if thing.count >= carrier.count { thing.count.div_ceil(carrier.count) } else { thing.count };
    let Some(places) = places(plan, of, own, &noun, each) else { return false };
    let anchor =
        |j: usize| if carrier.count > 1 { format!("{}[{}]", carrier.name, j / each) } else { carrier.name.clone() };
    let element = |j: usize| if thing.count > 1 { format!("{}[{j}]", thing.name) } else { thing.name.clone() };
    let fixed: Vec<String> =
        (0..thing.count).map(|j| place::fixed(&element(j), &anchor(j), &places[j % each], own[1], 0.0)).collect();
    let why = format!("{} stands on {}", with_article(&noun), with_article(&carrier.category.replace('_', " ")));
    plan.say(format!("assert {};", fixed.join(" and ")), &why);
    plan.loads.extend(places.iter().map(|slot| (of, Taken::by(slot, own))));
    plan.claimed.push(at);
    true
}

/// Whether such things stand or lie on others.
fn is_small(thing: &DraftThing) -> bool {
    let known = nouns::ending(&thing.category).map(|noun| noun.stands);
    match known {
        Some(stands) => matches!(stands, Stands::Top | Stands::Soft),
        None => matches!(stand::group(&thing.category), Group::Top | Group::Soft),
    }
}

/// Whether nothing is said of a thing but the room that it is in. What was inferred for the lack of anything better does
/// not count.
fn is_loose(plan: &Plan, thing: &DraftThing) -> bool {
    let about = plan.draft.statements.iter().filter(|s| mentions(&s.text, &thing.name));
    about.into_iter().all(|s| {
        let inferred = !matches!(s.source, ThingOrigin::Stated(_));
        is_in_room(&s.text) || inferred && is_default(&s.text)
    })
}

fn is_default(text: &str) -> bool {
    ["onFloor(", "againstWall(", "restsOn("].iter().any(|call| text.contains(call))
}

fn is_in_room(text: &str) -> bool {
    text.contains("inside(") && !text.contains(" and ") && !text.contains("exists")
}

/// How far down the list of what carries such things something is; `None`: it carries none.
fn rank(plan: &Plan, of: usize, noun: &str) -> Option<usize> {
    let carrier = &plan.draft.things[of];
    let [w, h, d] = carrier.size?;
    let name = carrier.category.replace('_', " ");
    let sloped = SLOPED.iter().any(|sloped| name.ends_with(sloped));
    if sloped || carrier.room != Some(plan.room) || h > HIGHEST || w.min(d) < 0.2 || !stands(plan, carrier) {
        return None;
    }
    if part_of(&name, plan.kind.dress, noun).is_some() {
        return Some(0);
    }
    let known = |end: &str| name == end || name.ends_with(&format!(" {end}"));
    carriers(noun).iter().position(|end| known(end)).map(|at| at + 1)
}

/// The part of what goes with a carrier that such a thing is.
fn part_of(carrier: &str, dress: &str, noun: &str) -> Option<&'static GroupPart> {
    groups::of(carrier, dress).iter().find(|part| {
        matches!(part.at, Where::Top(..)) && (part.noun == noun || noun.ends_with(&format!(" {}", part.noun)))
    })
}

/// Whether a thing stands on the floor or on nothing that is known, and not on another or on a wall.
fn stands(plan: &Plan, thing: &DraftThing) -> bool {
    stand::on_floor(plan.draft, thing) && !is_small(thing)
}

/// Places for so many on a top, one after the other, the best first.
fn places(plan: &Plan, of: usize, own: [f64; 3], noun: &str, count: usize) -> Option<Vec<Slot>> {
    let carrier = &plan.draft.things[of];
    let [w, height, d] = carrier.size?;
    let group = stand::group(&carrier.category);
    let soft = matches!(group, Group::Seat | Group::Bed);
    let part = match () {
        () if stand::round(&carrier.category, &carrier.look.features) => ROUND,
        () if soft => SEAT,
        () => 1.0,
    };
    // What is as wide as a top stands on it without an edge.
    let free = |whole: f64, own: f64| {
        let left = whole * part - own;
        (left >= 0.0).then_some((left - 2.0 * EDGE).max(0.0))
    };
    let (free_w, free_d) = (free(w, own[0])?, free(d, own[2])?);
    // Where such things stand on such carriers; else at the back where there is one, beside the middle, which people use.
    let usual = part_of(&carrier.category.replace('_', " "), plan.kind.dress, noun).map(|part| &part.at);
    let (wanted, yaw) = match usual {
        Some(Where::Top(x, z, yaw)) => ([(x * free_w / 2.0).abs(), z * free_d / 2.0], *yaw),
        _ => ([free_w / 3.0, if soft || part < 1.0 { 0.0 } else { -free_d / 2.0 }], 0.0),
    };
    let steps = |free: f64| (0..=(free / STEP) as usize).map(move |i| i as f64 * STEP - free / 2.0);
    let mut tries: Vec<[f64; 2]> = steps(free_w).flat_map(|x| steps(free_d).map(move |z| [x, z])).collect();
    let far = |[x, z]: [f64; 2]| (x.abs() - wanted[0]).abs() + 2.0 * (z - wanted[1]).abs();
    tries.sort_by(|a, b| far(*a).total_cmp(&far(*b)));
    let mut taken: Vec<Taken> = plan.loads.iter().filter(|(on, _)| *on == of).map(|(_, taken)| *taken).collect();
    // So are other things on it and, for what is tall, the picture above it.
    let is_in_the_way = |other: &Taken, slot: &Slot| {
        let here = Taken::by(slot, own);
        here.meets(other) || here.reaches(other, height)
    };
    let mut out = Vec::new();
    // Several stand side by side before they stand one behind the other.
    if count > 1
        && let Some(row) = side_by_side(own, [free_w, free_d], wanted[1], count, yaw)
        && !row.iter().any(|slot| taken.iter().any(|other| is_in_the_way(other, slot)))
    {
        return Some(row);
    }
    for [x, z] in tries {
        let slot = Slot { x, z, level: Level::Top, yaw };
        if out.len() < count && !taken.iter().any(|other| is_in_the_way(other, &slot)) {
            taken.push(Taken::by(&slot, own));
            out.push(slot);
        }
    }
    (out.len() == count).then_some(out)
}

/// So many in a row about the middle of a top, at a depth; `None` if the row is too long.
fn side_by_side(own: [f64; 3], [free_w, free_d]: [f64; 2], z: f64, count: usize, yaw: f64) -> Option<Vec<Slot>> {
    const APART: f64 = 0.02;
    const MOST: f64 = 0.1;
    let between = (count - 1) as f64;
    let step = (own[0] + MOST).min(free_w / between);
    let z = z.clamp(-free_d / 2.0, free_d / 2.0);
    let slots = (0..count).map(|i| Slot { x: step * (i as f64 - between / 2.0), z, level: Level::Top, yaw });
    (step >= own[0] + APART).then(|| slots.collect())
}

/// What carries things of this name.
fn carriers(noun: &str) -> &'static [&'static str] {
    static LINES: OnceLock<Vec<(Vec<&'static str>, Vec<&'static str>)>> = OnceLock::new();
    let lines = LINES.get_or_init(|| {
        let list = |text: &'static str| text.split(',').map(str::trim).collect();
        let lines = include_str!("../../data/carriers.txt").lines().filter(|line| !line.starts_with('#'));
        lines.filter_map(|line| line.split_once(':')).map(|(things, on)| (list(things), list(on))).collect()
    });
    let is = |thing: &&&str| noun == **thing || noun.ends_with(&format!(" {thing}")) || **thing == "*";
    lines.iter().find(|(things, _)| things.iter().any(|thing| is(&thing))).map_or(&[], |(_, on)| on)
}

#[cfg(test)]
mod tests {
    use super::carriers;

    #[test]
    fn each_thing_has_carriers() {
        for (noun, first) in
            [("coffee machine", "kitchen counter"), ("red table lamp", "nightstand"), ("gizmo", "sideboard")]
        {
            assert_eq!(carriers(noun)[0], first, "{noun}");
        }
    }
}
