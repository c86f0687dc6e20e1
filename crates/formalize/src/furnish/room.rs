//! One room, from the way in to the light: openings, floor and walls, what is asked for with what goes with it, then the
//! inventory of its kind as far as there is room.

use super::daylight::{add_windows, keep_windows_free, place_over, place_windows, way_in};
use super::floor::Floor;
use super::inventory::{came_along, inventory};
use super::kinds::{self, Count, Line, PlanPlace};
use super::openings;
use super::order::Order;
use super::plan::{Plan, for_people};
use super::rows::is_desk;
use super::taste::{self, Taste};
use super::{asked, cell, gates, hang, line, stand, tops};
use crate::brief::{Brief, Group, MOST_GUIDED};
use crate::draft::{Draft, DraftThing, ThingOrigin};

/// So much of the floor a place to eat takes (square metres).
const EATING: f64 = 8.0;

/// So many lines of an inventory matter: a room without them is not what it is called.
pub(super) const MATTER: usize = 4;

/// What came of furnishing a room.
#[derive(Clone, Copy, Debug, Default)]
pub struct Furnished {
    /// How much that matters found no room.
    pub lacking: usize,
    /// The part of the floor that nothing is near and nobody needs.
    pub idle: f64,
    /// How many things there is no way to.
    pub unreached: usize,
    /// How many groups have little room behind their chairs.
    pub tight: usize,
}

impl Furnished {
    /// What a larger room may mend.
    pub fn wants(&self) -> [usize; 3] {
        [self.lacking, self.unreached, self.tight]
    }
}

/// What gets its place first in a room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum First {
    Asked,
    /// What makes it such a room: the bed of a bedroom.
    Kind,
    /// What such a room has next: the wardrobe.
    Next,
}

/// Furnishes a room of its size with as much as one of `counted` square metres has.
pub fn furnish_once(
    draft: &mut Draft,
    brief: &Brief,
    at: usize,
    closed: &[String],
    (counted, first): (f64, First),
) -> Furnished {
    let kind = kinds::of(&draft.rooms[at].kind).or_else(|| kinds::of("room"));
    let kind = if receives(draft, at) { kinds::of("private office") } else { kind };
    let Some(kind) = kind else { return Furnished::default() };
    let doors_ruled_out = brief.absent.iter().any(|(name, _)| name.contains("door"));
    if !draft.outdoor && !doors_ruled_out {
        way_in(draft, at);
        gates::doors(draft, at, kind);
    }
    let rectangular = draft.rooms[at].outline.is_none();
    if rectangular && !draft.outdoor {
        openings::doors(draft, at);
    }
    // The crib of a baby, too, has its place before the inventory.
    let is_asked = |t: &DraftThing| {
        let is_bed = || stand::group(&t.category) == Group::Bed;
        matches!(t.source, ThingOrigin::Stated(_)) || for_people(&t.source) && tables(&t.category) || is_bed()
    };
    let own = |t: &DraftThing| t.room == Some(at) && is_asked(t);
    let mut asked: Vec<usize> = (0..draft.things.len()).filter(|i| own(&draft.things[*i])).collect();
    // What seats go with comes before them.
    let at_back = |category: &str| {
        let noun = category.replace('_', " ");
        let own = kind.lines.iter().find(|line| stand::counts_as(line.noun, &noun));
        own.is_some_and(|line| {
            matches!(line.place, PlanPlace::Back(_) | PlanPlace::Service(_) | PlanPlace::Before(_, 180.0))
        })
    };
    // So does what has its place at the back or serves guests: a robot stands before its conveyor, and nobody waits behind a
    // desk.
    asked.sort_by_key(|i| {
        let category = &draft.things[*i].category;
        let sits = stand::group(category) == Group::Seat && !stand::has_back(category);
        (sits, !at_back(category))
    });
    let windows = brief.things.iter().any(|t| t.room == at && t.group == Group::Window)
        || closed.iter().any(|name| name.ends_with("window") || name.ends_with("windows"))
        || draft.outdoor;
    let taste = Taste::new(kind, brief.rooms[at].style);
    let room = &mut draft.rooms[at];
    taste.surfaces(&mut room.floor, &mut room.walls);
    let mut turn = 0;
    for it in draft.things.iter_mut().filter(|it| it.room == Some(at)) {
        taste.dress(&it.category, &mut it.look, &mut turn);
    }
    let mut plan = Plan::new(draft, at, kind, closed.to_vec(), brief.rooms[at].people);
    (plan.taste, plan.turn) = (taste, turn);
    (plan.only, plan.counted) = (brief.rooms[at].only, counted);
    if !windows {
        add_windows(&mut plan);
    } else if rectangular && !plan.draft.outdoor {
        place_windows(&mut plan);
    }
    if rectangular {
        plan.ground = Some(openings::floor(plan.draft, at));
        gates::curtains(&mut plan);
    }
    asked::rounded(&mut plan, brief);
    asked::lengthened(&mut plan, brief);
    // A plan tries many places for each thing and looks for the ways that are left: a crowd is for the search alone.
    let crowd = plan.draft.things.iter().map(|thing| thing.count).sum::<usize>() > MOST_GUIDED;
    place_all(&mut plan, asked, crowd, first);
    let idle = plan.ground.as_ref().map_or(0.0, Floor::idle);
    let unreached = plan.ground.as_ref().map_or(0, Floor::unreached);
    let furnished = Furnished { lacking: plan.lacking, idle, unreached, tight: plan.tight };
    keep_windows_free(plan.draft, at);
    taste::fitted(draft, at);
    furnished
}

/// Whether visitors are received in the study or office of one person: the desk stands before them, not at a wall.
fn receives(draft: &Draft, at: usize) -> bool {
    let visits = |noun: &str| noun.ends_with("visitor_chair") || noun.ends_with("guest_chair");
    let studies = kinds::of(&draft.rooms[at].kind).is_some_and(|kind| matches!(kind.name, "home office" | "office"));
    let works = |thing: &DraftThing| thing.room == Some(at) && is_desk(&thing.category.replace('_', " "));
    let desks: usize = draft.things.iter().filter(|thing| works(thing)).map(|thing| thing.count).sum();
    studies && desks < 2 && draft.things.iter().any(|thing| thing.room == Some(at) && visits(&thing.category))
}

/// Gives what is asked for and the inventory their places; of a `crowd`, what is asked for is left to the search.
fn place_all(plan: &mut Plan, asked: Vec<usize>, crowd: bool, first: First) {
    let mut asked = asked;
    if !crowd {
        cell::stand_up(plan);
        line::stand_up(plan);
        asked.retain(|thing| !plan.claimed.contains(thing));
    }
    let order = Order::of(plan, asked);
    plan.small.clone_from(&order.small);
    order.boards.iter().for_each(|thing| hang::up(plan, *thing));
    let mut early = order.early(plan);
    let is_at_wall = |line: &&'static Line| matches!(line.place, PlanPlace::Wall | PlanPlace::Run);
    match first {
        First::Asked => {}
        First::Kind => early.extend(plan.kind.lines.first().filter(is_at_wall)),
        First::Next => early.extend(plan.kind.lines.get(1).filter(is_at_wall)),
    }
    early.iter().for_each(|line| matter(plan, line, true));
    let stand_up = |plan: &mut Plan, things: &[usize]| {
        things.iter().filter(|_| !crowd).for_each(|thing| asked::stand_up(plan, *thing));
    };
    stand_up(plan, &order.first);
    let (first, rest) = plan.kind.lines.split_at(plan.kind.lines.len().min(2));
    let dines = plan.dines();
    // Where one eats in the room, too, its armchairs do not come first.
    let all = plan.counted;
    if dines {
        plan.counted -= EATING;
    }
    // What is watched from the bed has its wall before the wardrobe.
    let sleeps = plan.sleeps();
    let is_screen = |plan: &Plan, at: usize| stand::group(&plan.draft.things[at].category) == Group::Screen;
    let (screens, hung): (Vec<usize>, Vec<usize>) =
        order.hung.iter().partition(|thing| sleeps && is_screen(plan, **thing));
    for (i, line) in first.iter().chain(rest).enumerate() {
        if i == 1 {
            screens.iter().for_each(|thing| hang::up(plan, *thing));
        }
        if i == first.len() {
            plan.counted = all;
            stand_up(plan, &order.later);
            if dines {
                eat_at(plan);
            }
            hung.iter().for_each(|thing| hang::up(plan, *thing));
        }
        let matters = i < MATTER && is_essential(plan, line);
        if !early.contains(&line) && line.place != PlanPlace::Ceiling {
            matter(plan, line, matters);
        }
    }
    stand_up(plan, &order.waiting);
    for thing in &order.small {
        if !tops::carry(plan, *thing) && !tops::carry_on_new(plan, *thing) {
            stand_up(plan, &[*thing]);
        }
    }
    // Lights have their places beside those that hang over tables.
    let lights = plan.kind.lines.iter().filter(|line| line.place == PlanPlace::Ceiling);
    lights.for_each(|line| matter(plan, line, false));
    hang::projectors(plan);
    place_over(plan);
    tops::settle(plan);
    plan.lacking += seats_apart(plan, &order.waiting);
}

/// Whether such a room is not complete without a line of its inventory.
fn is_essential(plan: &Plan, line: &Line) -> bool {
    let stands = !matches!(line.place, PlanPlace::Hung | PlanPlace::Ceiling | PlanPlace::Corner);
    let few = match line.count {
        Count::Fixed(n) => n <= 3,
        // A bed and a desk for each of two or three.
        Count::People(each) => {
            plan.people.map_or(plan.kind.people, |n| n as f64) / each <= 3.0 || plan.tables(line).is_some()
        }
        Count::Area(_) => false,
    };
    // A shop with a shelf less is a shop; who has no seat is missing.
    let seats = matches!(line.place, PlanPlace::Floor) && matches!(line.count, Count::People(_));
    let few = few || seats || matches!(line.place, PlanPlace::Rows(_)) && !matches!(line.count, Count::Area(_));
    stands && few && line.least == 0.0 && !plan.is_furnished()
}

/// How many kinds of seats have no place at the table that they belong to: they want a larger room.
fn seats_apart(plan: &Plan, waiting: &[usize]) -> usize {
    let apart = |at: &usize| {
        let thing = &plan.draft.things[*at];
        let belongs = for_people(&thing.source) || waiting.contains(at);
        let is_seat = stand::group(&thing.category) == Group::Seat;
        thing.room == Some(plan.room) && is_seat && belongs && !plan.claimed.contains(at)
    };
    (0..plan.draft.things.len()).filter(apart).count()
}

/// Whether things of a category are tables.
pub(super) fn tables(category: &str) -> bool {
    stand::group(category) == Group::Table
}

/// Adds a line of the inventory, and notes where it matters and finds no room.
fn matter(plan: &mut Plan, line: &Line, matters: bool) {
    plan.matters = matters;
    let (things, closed) = (plan.draft.things.len(), plan.is_closed(line.noun));
    inventory(plan, line);
    let is_there = closed || came_along(plan, line);
    plan.lacking += usize::from(matters && !is_there && plan.draft.things.len() == things);
}

/// Adds what one eats at, if there is room for its seats, too.
fn eat_at(plan: &mut Plan) {
    plan.matters = true;
    let lacking = plan.lacking;
    for line in &plan.kind.eat {
        let draft = plan.draft.clone();
        let before = (plan.ground.clone(), plan.floor, plan.walls, plan.turn);
        inventory(plan, line);
        let new = &plan.draft.things[draft.things.len()..];
        if new.iter().any(|thing| stand::group(&thing.category) == Group::Seat) {
            plan.lacking = lacking;
            return;
        }
        *plan.draft = draft;
        (plan.ground, plan.floor, plan.walls, plan.turn) = before;
    }
}
