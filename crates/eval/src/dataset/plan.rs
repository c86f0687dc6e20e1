//! Phases I and II of the published procedure, by draws instead of a language model: the rooms of a scene with their attributes
//! and connections, what is in them, and what is said of its places.

use super::dice::Dice;
use super::looks::{ThingLook, look};
use super::pools::{Building, Item, RoomPool, ThingPlace, tables};
use scenelang_lang::library::usual_size;
use scenelang_lang::nouns::{Stands, noun};

/// As published: the chance that there is less of a thing than the most of it.
const REDUCED: f64 = 0.2;
/// As published: the chance of one more connection for each pair that has none.
const MORE: f64 = 0.5;
/// As published: so many attributes of a room.
const ATTRIBUTES: [usize; 2] = [5, 15];
/// A room with fewer things than this gets some that any room may have.
const THINGS: [f64; 2] = [20.0, 30.0];
/// How much of the length of the walls what stands at them may take.
const WALLS: f64 = 0.5;
/// Floor for each square metre that is stood on, or used by who stands before something.
const FLOOR: f64 = 2.1;
/// Metres before each thing that are counted as used.
const USED: f64 = 0.6;
/// How much of a top may be covered.
const TOP: f64 = 0.6;
/// Relations for each thing, at which no more are added; the published scenes have 0.9.
const RELATIONS: f64 = 0.88;

/// A scene before it is written down.
#[derive(Debug)]
pub(crate) struct Plan {
    pub building: &'static str,
    pub rooms: Vec<PlannedRoom>,
    /// Room by room, what others refer to before them.
    pub things: Vec<PlannedThing>,
    pub links: Vec<Link>,
    /// What is said of places, beyond what the things themselves say.
    pub extras: Vec<Extra>,
}

#[derive(Debug)]
pub(crate) struct PlannedRoom {
    pub kind: &'static str,
    /// Width, height, depth.
    pub size: [f64; 3],
    /// What is said of it, with the phrase: dimension, value, phrase.
    pub attributes: Vec<(&'static str, &'static str, &'static str)>,
}

#[derive(Debug)]
pub(crate) struct PlannedThing {
    pub room: usize,
    pub noun: &'static str,
    pub count: u32,
    pub place: ThingPlace,
    /// The thing that the place refers to: an index into the things.
    pub other: Option<usize>,
    pub look: ThingLook,
    pub size: [f64; 3],
}

/// A door or a window.
#[derive(Debug)]
pub(crate) struct Link {
    pub noun: &'static str,
    pub size: [f64; 3],
    pub look: ThingLook,
    /// A room, and the other one; `None`: outside.
    pub between: (usize, Option<usize>),
}

/// A relation between two kinds of things of a room, or of one.
#[derive(Debug)]
pub(crate) struct Extra {
    pub kind: ExtraKind,
    pub thing: usize,
    pub other: Option<usize>,
    pub distance: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ExtraKind {
    Far,
    Close,
    Clear,
    Facing,
    Left,
    Right,
    Apart,
}

impl ExtraKind {
    /// The rule of the grammar that speaks of it.
    pub fn rule(self) -> &'static str {
        match self {
            Self::Far => "far",
            Self::Close => "close",
            Self::Clear => "clear",
            Self::Facing => "facing",
            Self::Left => "left",
            Self::Right => "right",
            Self::Apart => "apart",
        }
    }
}

impl PlannedThing {
    /// Whether it stands on the floor.
    fn on_floor(&self) -> bool {
        !matches!(self.place, ThingPlace::Hung | ThingPlace::Ceiling | ThingPlace::Over(_) | ThingPlace::On(_))
    }

    /// How many relations its place says: one for each of it, but for what stands anywhere, and a row.
    pub fn relations(&self) -> usize {
        match self.place {
            ThingPlace::Floor => 0,
            ThingPlace::Row => 1,
            ThingPlace::Around(_) => self.count as usize + usize::from(self.count > 1),
            _ => self.count as usize,
        }
    }
}

/// The plan of a scene: the building and the number of rooms go round, so that each has its share.
pub(crate) fn plan(seed: u64, number: u64) -> Plan {
    let mut dice = Dice::new(seed, number);
    let buildings = &tables().buildings;
    let building = &buildings[(number % buildings.len() as u64) as usize];
    let rooms = 1 + (number / buildings.len() as u64 % 2) as usize;
    let mut plan =
        Plan { building: building.name, rooms: Vec::new(), things: Vec::new(), links: Vec::new(), extras: Vec::new() };
    for kind in kinds(&mut dice, building, rooms) {
        let room = plan.rooms.len();
        let begun = plan.things.len();
        furnish(&mut dice, &mut plan.things, room, kind);
        let attributes = attributes(&mut dice);
        let size = measure(&mut dice, &plan.things[begun..]);
        plan.rooms.push(PlannedRoom { kind: kind.name, size, attributes });
        relate(&mut dice, &mut plan, begun);
    }
    if let [first, second] = plan.rooms.as_mut_slice() {
        // They stand side by side under one ceiling.
        first.size[1] = first.size[1].max(second.size[1]);
        second.size[1] = first.size[1];
    }
    plan.links = links(&mut dice, plan.rooms.len());
    plan
}

/// Kinds of rooms, no two of one name.
fn kinds<'a>(dice: &mut Dice, building: &'a Building, count: usize) -> Vec<&'a RoomPool> {
    let mut all: Vec<&RoomPool> = building.kinds.iter().collect();
    dice.shuffle(&mut all);
    all.truncate(count);
    all
}

fn attributes(dice: &mut Dice) -> Vec<(&'static str, &'static str, &'static str)> {
    let mut all: Vec<_> = tables().attributes.iter().collect();
    dice.shuffle(&mut all);
    all.truncate(ATTRIBUTES[0] + dice.below(ATTRIBUTES[1] - ATTRIBUTES[0] + 1));
    all.into_iter().map(|a| (a.what, *dice.one(&a.values), *dice.one(&a.phrases))).collect()
}

fn furnish(dice: &mut Dice, things: &mut Vec<PlannedThing>, room: usize, kind: &RoomPool) {
    let begun = things.len();
    let wanted = dice.between(THINGS[0], THINGS[1]) as u32;
    let add = |dice: &mut Dice, things: &mut Vec<PlannedThing>, items: &[Item]| {
        for item in items {
            if things[begun..].iter().all(|thing| thing.noun != item.noun)
                && let Some(thing) = draw(dice, things, begun, room, item)
            {
                things.push(thing);
            }
        }
    };
    add(dice, things, &kind.items);
    let mut common: Vec<_> = tables().common.iter().collect();
    dice.shuffle(&mut common);
    for items in common {
        if things[begun..].iter().map(|thing| thing.count).sum::<u32>() >= wanted {
            break;
        }
        add(dice, things, items);
    }
}

/// A thing of the inventory; `None`: the draw has left it out, or there is no place for it.
fn draw(dice: &mut Dice, things: &[PlannedThing], begun: usize, room: usize, item: &Item) -> Option<PlannedThing> {
    let size = usual_size(item.noun)?;
    let mut count = item.most;
    if dice.chance(REDUCED) {
        count = dice.below(item.most as usize) as u32;
    }
    let look = look(dice, item.noun);
    let other = match item.place.other() {
        Some(noun) => Some(begun + things[begun..].iter().position(|thing| thing.noun == noun)?),
        None => None,
    };
    let corners = things[begun..].iter().filter(|t| t.place == ThingPlace::Corner).map(|t| t.count).sum::<u32>();
    let most = match (item.place, other.map(|i| &things[i])) {
        (ThingPlace::Corner, _) => 4 - corners.min(4),
        (ThingPlace::Middle, _) => u32::from(things[begun..].iter().all(|t| t.place != ThingPlace::Middle)),
        (ThingPlace::On(_), Some(below)) => fitting(things, begun, size, below) * below.count,
        (ThingPlace::At(_), Some(at)) => at.count,
        (ThingPlace::Around(_), Some(at)) if at.count > 1 => 0,
        (ThingPlace::Beside(_), Some(at)) => 2 * at.count,
        (ThingPlace::Before(_) | ThingPlace::Over(_), Some(at)) => 2 * at.count,
        _ => item.most,
    };
    count = count.min(most);
    // One thing is no row.
    (count > u32::from(item.place == ThingPlace::Row)).then_some(PlannedThing {
        room,
        noun: item.noun,
        count,
        place: item.place,
        other,
        look,
        size,
    })
}

/// How many of a size each of these things still has a place for on its top.
fn fitting(things: &[PlannedThing], begun: usize, size: [f64; 3], below: &PlannedThing) -> u32 {
    let on = |t: &&PlannedThing| matches!(t.place, ThingPlace::On(noun) if noun == below.noun);
    let taken: f64 = things[begun..]
        .iter()
        .filter(on)
        .map(|t| t.size[0] * t.size[2] * f64::from(t.count.div_ceil(below.count)))
        .sum();
    let top = [below.size[0], below.size[2]];
    if size[0].max(size[2]) > top[0].max(top[1]) || size[0].min(size[2]) > top[0].min(top[1]) {
        return 0;
    }
    (((top[0] * top[1] * TOP - taken) / (size[0] * size[2])).max(0.0) as u32).min(5)
}

/// Width, height and depth of a room for these things.
fn measure(dice: &mut Dice, things: &[PlannedThing]) -> [f64; 3] {
    let floor = things.iter().filter(|t| t.on_floor());
    let area: f64 = floor.map(|t| f64::from(t.count) * t.size[0] * (t.size[2] + USED)).sum();
    let at_walls = things.iter().filter(|t| matches!(t.place, ThingPlace::Wall | ThingPlace::Corner));
    let length: f64 = at_walls.map(|t| f64::from(t.count) * t.size[0]).sum();
    let aspect = dice.between(1.0, 1.6);
    let row = things.iter().filter(|t| t.place == ThingPlace::Row).map(|t| f64::from(t.count) * (t.size[0] + 0.3));
    let area = (area * FLOOR).max(12.0).max((length / WALLS / 4.0).powi(2));
    let width = (area * aspect).sqrt().max(row.fold(0.0, f64::max) + 1.0);
    let tallest = things.iter().map(|t| t.size[1]).fold(0.0, f64::max);
    let height = dice.between(2.6, 3.4).max(tallest + 0.3);
    [tenth(width), tenth(height), tenth(area / (area * aspect).sqrt())]
}

/// To a tenth, upwards.
fn tenth(x: f64) -> f64 {
    (x * 10.0 - 1e-9).ceil() / 10.0
}

/// Further relations of the things of a room, until there are about as many for each thing as in the published scenes. Each
/// thing is in one of them at most, so that they do not contradict each other by their number alone.
fn relate(dice: &mut Dice, plan: &mut Plan, begun: usize) {
    let things = &plan.things[begun..];
    let wanted = things.iter().map(|t| f64::from(t.count)).sum::<f64>() * RELATIONS;
    let mut said = things.iter().map(PlannedThing::relations).sum::<usize>() as f64;
    let mut free: Vec<usize> = (0..things.len()).filter(|i| things[*i].on_floor()).collect();
    dice.shuffle(&mut free);
    // What is alone, and stands by itself: "the sofa" says which.
    let alone = |i: usize| things[i].count == 1 && things[i].place.other().is_none();
    while said < wanted
        && let Some(thing) = free.pop()
    {
        let loose = matches!(things[thing].place, ThingPlace::Floor) && things[thing].count > 1;
        let distance = f64::from(4 + dice.below(7) as u32) / 10.0;
        let extra = |kind, other, distance| Extra { kind, thing: begun + thing, other, distance };
        if loose {
            let pairs = (things[thing].count * (things[thing].count - 1) / 2) as f64;
            plan.extras.push(extra(ExtraKind::Apart, None, distance));
            said += pairs;
            continue;
        }
        let has_front = noun(things[thing].noun).is_some_and(|n| n.front && n.stands != Stands::Top);
        let partner = free.iter().position(|other| alone(*other));
        let of = |i: usize| begun + i;
        let kind = match dice.below(6) {
            0 if has_front && matches!(things[thing].place, ThingPlace::Wall) => ExtraKind::Clear,
            _ if !alone(thing) => continue,
            1 => ExtraKind::Close,
            2 if has_front && things[thing].place == ThingPlace::Floor => ExtraKind::Facing,
            3 => ExtraKind::Left,
            4 => ExtraKind::Right,
            _ => ExtraKind::Far,
        };
        if kind == ExtraKind::Clear {
            said += f64::from(things[thing].count);
            plan.extras.push(extra(kind, None, distance));
        } else if let Some(at) = partner {
            let other = free.remove(at);
            // What has no front has no side either, and at a wall there is none behind it.
            let sided = matches!(kind, ExtraKind::Left | ExtraKind::Right);
            let kind = match noun(things[other].noun) {
                Some(n) if sided && n.front => kind,
                _ if sided => ExtraKind::Far,
                _ => kind,
            };
            let distance = if kind == ExtraKind::Close { 1.0 + distance } else { distance };
            plan.extras.push(extra(kind, Some(of(other)), distance));
            said += 1.0;
        }
    }
}

/// Doors that connect all rooms with each other and the outside, more of them by chance, and windows.
fn links(dice: &mut Dice, rooms: usize) -> Vec<Link> {
    let door = |dice: &mut Dice, between| Link {
        noun: "door",
        size: [[0.9, 2.1, 0.06], [1.0, 2.1, 0.06], [0.85, 2.05, 0.06]][dice.below(3)],
        look: look(dice, "door"),
        between,
    };
    let mut out = vec![door(dice, (0, None))];
    if rooms > 1 {
        out.push(door(dice, (0, Some(1))));
        if dice.chance(MORE) {
            out.push(door(dice, (1, None)));
        }
    }
    for room in 0..rooms {
        if dice.chance(MORE) {
            let size = [[1.2, 1.2, 0.06], [1.5, 1.2, 0.06], [1.6, 1.4, 0.06]][dice.below(3)];
            out.push(Link { noun: "window", size, look: ThingLook::default(), between: (room, None) });
        }
    }
    out
}
