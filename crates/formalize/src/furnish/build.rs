//! A group is put together and placed as one piece. What does not fit with it is left out, the last part first.

use super::floor::{Floor, Footprint, Pose, Shape};
use super::groups::Where;
use super::openings::in_scene;
use super::plan::{AtWall, Plan, for_people};
use super::slots::{Level, Slot, fences};
use super::stand;
use crate::draft::{Demand, DraftThing, ThingOrigin};
use crate::names::{GivenNames, words};
use scenelang_lang::nouns;
use std::collections::BTreeMap;

/// How often a group is put together anew with less.
const ATTEMPTS: usize = 9;
/// Nothing else stands on these.
const MATS: [&str; 6] = ["exercise mat", "yoga mat", "gym mat", "play mat", "bath mat", "dance floor"];
/// What is higher stands before no window (metres).
const TALL: f64 = 1.1;
/// Behind a chair this much is free to pull it out and sit down, or at least so much where there is less room.
pub(super) const PULL_OUT: f64 = 0.6;
const SHORT_PULL_OUT: f64 = 0.36;
/// Behind the chairs of a table for so many this much is free, where there is room.
const MANY: usize = 8;
const GET_PAST: f64 = 0.8;
/// What is free at the ends of a table at whose long sides so many sit.
const AT_ENDS: f64 = 0.7;
/// How a group is placed, from the best manner to the last: how much is free behind its chairs, and whether ways may be narrower.
const MANNERS: [(f64, bool); 3] = [(PULL_OUT, false), (SHORT_PULL_OUT, false), (SHORT_PULL_OUT, true)];
/// Before a seat that belongs to no table this much is free.
const FEET: f64 = 0.4;
/// Beyond a table before a sofa this much is free, and so much wider.
const PASS: f64 = 0.5;
const ASIDE: f64 = 0.4;
/// What one works at from all sides, and how much is free there.
const WORKED_AROUND: [(&str, f64); 2] = [("table saw", 0.8), ("work table", 0.6)];
/// Beside a sofa this much is free of what does not belong to it.
const BESIDE_SOFA: f64 = 0.25;
/// On both sides of a toilet this much is free.
const ELBOW: f64 = 0.18;
/// What a television stands on is lower than this (metres).
const ABOVE_STAND: f64 = 1.0;
/// Beside a fireplace this much is free.
const HEARTH: f64 = 0.4;
/// Behind the belt of a treadmill this much is free.
const FALL: f64 = 0.9;
/// How much is free on both sides of what one lies on to be treated.
const BESIDE_TABLE: f64 = 0.6;
/// Beside what one trains on this much is free.
const TRAINED: [(&str, f64); 4] =
    [("weight bench", 0.5), ("treadmill", 0.3), ("exercise bike", 0.2), ("rowing machine", 0.3)];
/// Beside a bed for two this much is free.
const BESIDE_BED: f64 = 0.52;

/// A table without its seats is lacking as much as so many other things.
const SEATLESS: usize = 3;
/// What a group is not complete without, beside its seats.
const USED: [&str; 5] = ["kitchen sink", "stove", "fridge", "sink", "nightstand"];

/// Whether a group is not complete without a part.
fn matters(part: &str) -> bool {
    USED.contains(&part) || stand::group(part) == crate::brief::Group::Seat
}

fn is_sofa(noun: &str) -> bool {
    ["sofa", "couch", "loveseat", "sectional"].iter().any(|end| noun.ends_with(end))
}

/// A group that is being put together.
#[derive(Clone, Debug, Default)]
pub struct Building {
    /// What it takes.
    pub shape: Shape,
    /// Parts that are left out.
    pub skip: Vec<&'static str>,
    /// Things at which seats stand that are asked for: they get no others.
    pub seated: Vec<usize>,
    /// Whether there is no floor for seats that belong to it.
    pub is_crowded: bool,
    /// How much is free behind its chairs, and whether it has any.
    pull: f64,
    has_chairs: bool,
    /// Where the elements of each thing are, for one element of the first.
    frames: BTreeMap<usize, Vec<Pose>>,
    /// What each thing but the first is in the table of groups.
    parts: BTreeMap<usize, &'static str>,
}

impl Building {
    /// With its first thing, whose elements that are placed together are there.
    fn new(thing: usize, noun: &str, size: [f64; 3], frames: Vec<Pose>, pull: f64) -> Self {
        let mut out = Self { pull, ..Self::default() };
        out.shape.is_lounge = is_sofa(noun) || noun == super::asked::BOOTH;
        // Who sits alone has room for the feet.
        let sits = stand::group(noun) == crate::brief::Group::Seat && !stand::has_back(noun);
        for frame in &frames {
            out.piece(thing, noun, size, frame);
            if sits && frames.len() == 1 {
                let feet = Pose { z: (size[2] + FEET) / 2.0, y: 0.05, ..Pose::default() };
                out.shape.free.push((frame.then(&feet), [size[0], 1.0, FEET]));
            }
        }
        out.frames.insert(thing, frames);
        out
    }

    fn piece(&mut self, thing: usize, noun: &str, size: [f64; 3], at: &Pose) {
        let [w, h, d] = size;
        let flat = h < 0.05;
        let tall = h > TALL && w * d > 0.12 && stand::has_back(noun);
        self.shape.pieces.push(Footprint { thing, at: *at, size, flat, tall });
        let mut keep = |x: f64, z: f64, size: [f64; 3]| {
            let place = Pose { x, z, y: 0.05, yaw: 0.0 };
            self.shape.free.push((at.then(&place), size));
        };
        if at.y > 0.3 {
            return;
        }
        if flat && MATS.iter().any(|mat| noun.ends_with(mat)) {
            keep(0.0, 0.0, [w, 1.0, d]);
        }
        if let Some(depth) = stand::access(noun) {
            keep(0.0, d / 2.0 + depth / 2.0, [w, 1.7, depth]);
        }
        if noun.ends_with("treadmill") {
            // Who falls off it falls behind it.
            keep(0.0, (d + FALL) / 2.0, [w, 1.0, FALL]);
        }
        if let Some((_, beside)) = TRAINED.iter().find(|(end, _)| noun.ends_with(end)) {
            for side in [-1.0, 1.0] {
                keep(side * (w + beside) / 2.0, 0.0, [*beside, 1.2, d]);
            }
        }
        if is_sofa(noun) {
            for side in [-1.0, 1.0] {
                keep(side * (w + BESIDE_SOFA) / 2.0, 0.0, [BESIDE_SOFA, 1.0, d]);
            }
        }
        if noun.ends_with("toilet") {
            // Who sits there has elbows.
            for side in [-1.0, 1.0] {
                keep(side * (w + ELBOW) / 2.0, 0.0, [ELBOW, 1.0, d]);
            }
        }
        if noun.ends_with("fireplace") {
            // Nothing that burns stands beside a fire.
            for side in [-1.0, 1.0] {
                keep(side * (w + HEARTH) / 2.0, 0.0, [HEARTH, 1.2, d]);
            }
        }
        if noun.ends_with("coffee table") {
            // One walks past it on the side away from the sofa.
            keep(0.0, -(d + PASS) / 2.0, [w + 2.0 * ASIDE, 1.0, PASS]);
        }
        let worked = WORKED_AROUND.iter().find(|(end, _)| noun.ends_with(end)).map(|(_, depth)| *depth);
        if let Some(depth) = stand::played_at(noun).or(worked) {
            for side in [-1.0, 1.0] {
                keep(side * (w + depth) / 2.0, 0.0, [depth, 1.2, d]);
                keep(0.0, side * (d + depth) / 2.0, [w, 1.2, depth]);
            }
        }
        let bed = nouns::ending(noun).is_some() && noun.ends_with("bed") && d > 1.8;
        if bed && (w >= 1.2 || noun.ends_with("hospital bed")) {
            // Who nurses stands at the head, too.
            let head = if noun.ends_with("hospital bed") { 0.0 } else { 0.6 };
            for side in [-1.0, 1.0] {
                keep(side * (w + BESIDE_BED) / 2.0, head / 2.0, [BESIDE_BED, 0.9, d - head]);
            }
        } else if stand::is_treated_on(noun) {
            // One works at both sides of who lies there.
            for side in [-1.0, 1.0] {
                keep(side * (w + BESIDE_TABLE) / 2.0, 0.0, [BESIDE_TABLE, 0.9, d]);
            }
        } else if bed {
            keep((w + BESIDE_BED) / 2.0, 0.3, [BESIDE_BED, 0.9, d - 0.6]);
        }
    }

    /// Adds a fence around something, in which nothing else stands.
    fn enclose(&mut self, thing: usize, size: [f64; 3], frame: &Pose) {
        for ([x, z], size) in fences(size) {
            let at = frame.then(&Pose { x, z, ..Pose::default() });
            self.shape.pieces.push(Footprint { thing, at, size, flat: false, tall: false });
        }
        self.shape.free.push((frame.then(&Pose { y: 0.05, ..Pose::default() }), size));
    }

    /// Adds a part that goes with each element of a thing of the group.
    pub fn add(
        &mut self,
        of: usize,
        new: usize,
        places: &[Slot],
        (noun, size, at): (&'static str, [f64; 3], &Where),
        ceiling: f64,
    ) {
        let Some(anchors) = self.frames.get(&of).cloned() else { return };
        // Toys on a mat are in the way, what stands on a table is not.
        let is_mat = self.shape.pieces.iter().any(|piece| piece.thing == of && piece.flat);
        // Nothing hangs behind a television.
        let is_seen = noun.ends_with("tv") || noun.ends_with("television");
        let under = self.shape.pieces.iter().find(|piece| piece.thing == of).map_or(0.0, |piece| piece.size[1]);
        let mut frames = Vec::new();
        for anchor in &anchors {
            for slot in places {
                let y = match slot.level {
                    Level::Floor => 0.0,
                    Level::Above(y) => y,
                    Level::Ceiling => ceiling - size[1],
                    Level::Top if is_mat => 0.01,
                    Level::Top if is_seen => under,
                    // What lies on something is in nobody's way.
                    Level::Top | Level::At(_) => return,
                };
                frames.push(anchor.then(&Pose { x: slot.x, y, z: slot.z, yaw: slot.yaw }));
            }
        }
        for frame in &frames {
            if matches!(at, Where::Enclose(..)) {
                self.enclose(new, size, frame);
                continue;
            }
            self.piece(new, noun, size, frame);
            if stand::is_easy(noun) {
                let feet = Pose { z: (size[2] + FEET) / 2.0, y: 0.05, ..Pose::default() };
                self.shape.free.push((frame.then(&feet), [size[0], 1.0, FEET]));
            }
            let at_bar = matches!(at, Where::Row(..)) && noun.ends_with("stool");
            let seat = at.is_around()
                || at_bar
                || matches!(at, Where::Front(..)) && (noun.ends_with("chair") || noun.ends_with("stool"));
            if seat {
                // Behind those who sit at a long table one gets past.
                let pull = if frames.len() >= MANY && self.pull == PULL_OUT { GET_PAST } else { self.pull };
                let behind = Pose { z: -(size[2] + pull) / 2.0, y: 0.05, ..Pose::default() };
                self.shape.free.push((frame.then(&behind), [size[0], 1.0, pull]));
                self.has_chairs = true;
            }
        }
        // Nor does a long table bar the way at its ends.
        let table = self.shape.pieces.iter().find(|piece| piece.thing == of).map(|piece| piece.size);
        if let (Where::LongSides(..), Some([w, _, d])) = (at, table)
            && frames.len() >= MANY
            && self.pull == PULL_OUT
        {
            for (anchor, side) in anchors.iter().flat_map(|anchor| [(anchor, -1.0), (anchor, 1.0)]) {
                let end = Pose { x: side * (w + AT_ENDS) / 2.0, y: 0.05, ..Pose::default() };
                self.shape.free.push((anchor.then(&end), [AT_ENDS, 1.0, d]));
            }
        }
        self.frames.insert(new, frames);
        self.parts.insert(new, noun);
    }

    /// Whether several elements of a thing are placed together, side by side.
    pub fn is_run(&self, thing: usize) -> bool {
        self.shape.pieces.first().is_some_and(|first| first.thing == thing)
            && self.frames.get(&thing).is_some_and(|frames| frames.len() > 1)
    }

    /// Whether the group begins with a sofa that turns a corner, in which a thing stands.
    pub fn is_bent(&self, thing: usize) -> bool {
        let first = self.shape.pieces.first().filter(|first| first.thing != thing && self.shape.is_lounge);
        first.is_some_and(|first| first.size[2] >= super::slots::BENT)
    }

    /// Whether the two elements of a thing look at each other, or at the same table from two sides.
    pub fn is_pair(&self, thing: usize) -> bool {
        self.is_run(thing) && self.frames.get(&thing).is_some_and(|frames| frames[1].yaw != 0.0 && frames[1].z > 0.0)
    }

    /// The part that is left out next: the last that stands somewhere.
    fn least(&self, root: usize) -> Option<&'static str> {
        let last = self.shape.pieces.iter().rev().find(|piece| piece.thing != root)?;
        self.parts.get(&last.thing).copied().filter(|noun| !self.skip.contains(noun))
    }
}

/// What a group begins with.
pub struct Root<'r> {
    /// How many are placed one by one.
    pub n: usize,
    /// Elements that are placed together, as seen from the first of them.
    pub frames: Vec<Pose>,
    /// What is known of its place at walls.
    pub wall: AtWall,
    /// What is kept free around it, in its frame.
    pub free: Vec<(Pose, [f64; 3])>,
    /// Whether it is not placed at all without what it is not complete without.
    pub whole: bool,
    /// Finds a place, given those of the elements before it.
    #[expect(clippy::type_complexity, reason = "it is written once")]
    pub seek: &'r dyn Fn(&Floor, &Shape, &[Pose]) -> Option<Pose>,
}

/// Adds a group to a plan without some of its parts: its first thing, and the places of its elements.
type Again<'a, Plan> = dyn FnMut(&mut Plan, &[&'static str]) -> Option<(usize, Vec<Pose>)> + 'a;

/// How far a plan was before a group was tried.
#[derive(Clone)]
struct Mark {
    /// Of things, statements, claimed things, what stands on things, and places.
    counts: [usize; 5],
    names: GivenNames,
    floor: f64,
    walls: f64,
    turn: usize,
    lacking: usize,
    tight: usize,
    ground: Option<Floor>,
}

impl Plan<'_> {
    /// Adds a thing with what goes with it where there is room for all of it, or for less of it. `add` adds the thing, so
    /// many of it. Its index, and the places of its elements in the room.
    pub fn place_group(
        &mut self,
        root: &Root<'_>,
        add: &mut dyn FnMut(&mut Self, usize) -> usize,
    ) -> Option<(usize, Vec<Pose>)> {
        if self.ground.is_none() {
            let thing = add(self, root.n * root.frames.len());
            self.surround(thing, root.wall, 0);
            return Some((thing, Vec::new()));
        }
        let (mut n, mut skip, mut manner) = (root.n, Vec::new(), 0);
        for _ in 0..2 * ATTEMPTS {
            let before = self.mark();
            self.pull = MANNERS[manner].0;
            let thing = add(self, n * root.frames.len());
            if let Some(poses) = self.try_group(thing, n, root, &skip) {
                let mut again = |plan: &mut Self, skip: &[&'static str]| {
                    let thing = add(plan, n * root.frames.len());
                    Some((thing, plan.try_group(thing, n, root, skip)?))
                };
                let (thing, poses) = self.bring_back(&before, &mut skip, (thing, poses), &mut again);
                self.miss(&skip);
                self.settle();
                return Some((thing, poses));
            }
            let has_chairs = self.has_chairs();
            let least = self.take_back(before, thing);
            // First with less room behind the chairs, then with fewer parts.
            manner = usize::from(manner == 0 && has_chairs);
            match least {
                _ if manner > 0 => {}
                Some(part) if root.whole && self.needs(part) => return None,
                Some(part) => skip.push(part),
                None if n > 1 => n -= 1,
                None => return None,
            }
        }
        None
    }

    /// A thing that is there already gets a place with what goes with it. Whether one was found; else nothing is added.
    pub fn place_asked(&mut self, thing: usize, root: &Root<'_>) -> bool {
        let (mut skip, mut manner) = (Vec::new(), 0);
        for _ in 0..MANNERS.len() * ATTEMPTS {
            let before = self.mark();
            let (pull, narrow) = MANNERS[manner];
            self.pull = pull;
            self.ground.iter_mut().for_each(|ground| ground.narrow = narrow);
            let placed = self.try_group(thing, root.n, root, &skip).map(|poses| (thing, poses)).map(|found| {
                let mut again = |plan: &mut Self, skip: &[&'static str]| {
                    plan.ground.iter_mut().for_each(|ground| ground.narrow = narrow);
                    Some((thing, plan.try_group(thing, root.n, root, skip)?))
                };
                self.bring_back(&before, &mut skip, found, &mut again)
            });
            self.ground.iter_mut().for_each(|ground| ground.narrow = false);
            if placed.is_some() {
                // Who works or eats at what is asked for has a seat there.
                let seatless = skip.iter().any(|noun| stand::group(noun) == crate::brief::Group::Seat);
                let is_table = stand::group(&self.draft.things[thing].category) == crate::brief::Group::Table;
                self.lacking += if seatless && is_table { SEATLESS } else { 0 };
                // So do those who cook, at a worktop that is asked for.
                self.lacking += usize::from(skip.iter().any(|noun| USED.contains(noun)));
                // The armchairs that are asked for with a sofa stand with it.
                self.lacking += usize::from(!is_table && skip.iter().any(|noun| self.is_asked(noun)));
                self.settle();
                return true;
            }
            let has_chairs = self.has_chairs();
            let least = self.take_back(before, thing);
            manner = match (manner, least) {
                (0, _) if has_chairs => 1,
                (0 | 1, _) => 2,
                (_, Some(part)) => {
                    skip.push(part);
                    0
                }
                (_, None) => return false,
            };
        }
        false
    }

    fn mark(&self) -> Mark {
        let Self { draft, names, claimed, loads, floor, walls, turn, lacking, tight, ground, .. } = self;
        let counts = [draft.things.len(), draft.statements.len(), claimed.len(), loads.len(), draft.places.len()];
        let (names, ground) = (names.clone(), ground.clone());
        let (floor, walls, turn, lacking, tight) = (*floor, *walls, *turn, *lacking, *tight);
        Mark { counts, names, floor, walls, turn, lacking, tight, ground }
    }

    /// A group has its place without some of its parts, of which the last was in the way: the others come back one by one if
    /// there is room for them. `again` adds the group anew without some parts.
    fn bring_back(
        &mut self,
        before: &Mark,
        skip: &mut Vec<&'static str>,
        found: (usize, Vec<Pose>),
        again: &mut Again<'_, Self>,
    ) -> (usize, Vec<Pose>) {
        let mut best = found;
        let mut is_best = true;
        for part in skip.split_last().map_or(Vec::new(), |(_, others)| others.to_vec()) {
            let fewer: Vec<&'static str> = skip.iter().copied().filter(|other| *other != part).collect();
            self.take_back(before.clone(), best.0);
            is_best = false;
            if let Some(next) = again(self, &fewer) {
                (best, *skip, is_best) = (next, fewer, true);
            }
        }
        if !is_best {
            self.take_back(before.clone(), best.0);
            if let Some(next) = again(self, skip) {
                best = next;
            }
        }
        best
    }

    /// Whether chairs belong to the group that was just tried.
    pub(super) fn has_chairs(&self) -> bool {
        self.building.as_ref().is_some_and(|group| group.has_chairs)
    }

    /// Takes back what was added since for a group that begins with a thing. The part to be left out next.
    fn take_back(&mut self, before: Mark, thing: usize) -> Option<&'static str> {
        let least = self.building.take().and_then(|group| group.least(thing));
        let [things, statements, claimed, loads, places] = before.counts;
        self.draft.things.truncate(things);
        self.draft.statements.truncate(statements);
        self.claimed.truncate(claimed);
        self.loads.truncate(loads);
        self.draft.places.truncate(places);
        (self.lacking, self.tight, self.ground) = (before.lacking, before.tight, before.ground);
        (self.names, self.floor, self.walls, self.turn) = (before.names, before.floor, before.walls, before.turn);
        least
    }

    /// Whether a group is not complete without a part, or the part is asked for.
    fn needs(&self, part: &str) -> bool {
        matters(part) || self.is_asked(part)
    }

    /// Whether a part is asked for in the room.
    fn is_asked(&self, part: &str) -> bool {
        let here = self.draft.things.iter().filter(|it| it.room == Some(self.room));
        let mut asked = here.filter(|it| matches!(it.source, ThingOrigin::Stated(_)));
        asked.any(|it| it.category.replace('_', " ") == part)
    }

    /// Notes that a thing that matters has no seats.
    fn miss(&mut self, skip: &[&'static str]) {
        self.lacking += usize::from(self.matters && skip.iter().any(|noun| self.needs(noun)));
    }

    /// What was said of seats for people before their table had a place, and may be at odds with it, is said no more.
    fn settle(&mut self) {
        let names: Vec<String> = self.claimed.iter().map(|i| self.draft.things[*i].name.clone()).collect();
        let is_screen = |it: &&&DraftThing| stand::group(&it.category) == crate::brief::Group::Screen;
        let is_high = |it: &DraftThing| self.place_in_room(&it.name).is_some_and(|at| at.y > ABOVE_STAND);
        let claimed: Vec<&DraftThing> = self.claimed.iter().map(|i| &self.draft.things[*i]).collect();
        let name = |it: &&DraftThing| it.name.clone();
        let hung = claimed.iter().filter(|it| it.category.ends_with("mirror") || is_screen(it) && is_high(it));
        let hung: Vec<String> = hung.map(name).collect();
        let screens = claimed.iter().filter(|it| is_screen(it) && !is_high(it));
        let screens: Vec<String> = screens.map(name).collect();
        self.draft.statements.retain(|s| {
            // What stands on its stand does not hang on a wall; a mirror hangs above what it goes with.
            let raised = s.demand == Demand::Prefer && s.text.contains(".bottom");
            let mounted = s.text.contains("wallMounted(") || raised;
            let of = |names: &[String]| words(&s.text).iter().any(|w| names.iter().any(|n| n == w));
            if !matches!(s.source, ThingOrigin::Stated(_)) && (mounted && of(&screens) || raised && of(&hung)) {
                return false;
            }
            let turns = s.demand == Demand::Prefer || s.text.contains("looksAt(") || s.text.contains("around(");
            !(turns && for_people(&s.source) && words(&s.text).iter().any(|w| names.iter().any(|n| n == w)))
        });
    }

    fn try_group(&mut self, thing: usize, n: usize, root: &Root<'_>, skip: &[&'static str]) -> Option<Vec<Pose>> {
        let it = &self.draft.things[thing];
        let (noun, size) = (it.category.replace('_', " "), it.size?);
        let mut building = Building::new(thing, &noun, size, root.frames.clone(), self.pull);
        if self.is_cornered(thing) {
            // At one of its sides is the wall.
            building.shape.free.retain(|(at, _)| at.x.abs() < size[0] / 2.0);
        }
        self.building = Some(Building { skip: skip.to_vec(), ..building });
        self.surround(thing, root.wall, 0);
        let mut group = self.building.clone()?;
        group.shape.free.extend(root.free.iter().copied());
        let mut ground = self.ground.clone()?;
        let mut poses = Vec::new();
        for _ in 0..n {
            let pose = (root.seek)(&ground, &group.shape, &poses)?;
            ground.take(&group.shape, &pose);
            poses.push(pose);
        }
        self.building = None;
        self.ground = Some(ground);
        self.lacking += usize::from(self.matters && group.is_crowded);
        self.tight += usize::from(group.has_chairs && self.pull < PULL_OUT);
        self.note_places(&group, &poses);
        Some(poses)
    }

    /// Takes the place of a group that is fixed to the room, and notes where its members are.
    fn note_places(&mut self, group: &Building, poses: &[Pose]) {
        for (thing, frames) in &group.frames {
            let (name, count) = (self.draft.things[*thing].name.clone(), self.draft.things[*thing].count);
            for (i, pose) in poses.iter().enumerate() {
                for (k, frame) in frames.iter().enumerate() {
                    let element = if count > 1 { format!("{name}[{}]", i * frames.len() + k) } else { name.clone() };
                    self.note_place(&element, &pose.then(frame));
                }
            }
        }
    }

    /// Notes where an element of a thing is in the room.
    pub(super) fn note_place(&mut self, element: &str, pose: &Pose) {
        let place = in_scene(self.draft, self.room, pose);
        let place = [place.x, place.y, place.z, place.yaw].map(|v| (v * 1e4).round() / 1e4);
        self.draft.places.push((element.to_owned(), place));
    }

    /// Where an element of a thing has its place in the room.
    pub fn place_in_room(&self, name: &str) -> Option<Pose> {
        let [x, y, z, yaw] = self.draft.place_of(name).or_else(|| self.draft.place_of(&format!("{name}[0]")))?;
        let [at_x, at_z] = self.draft.rooms[self.room].at;
        Some(Pose { x: x - at_x, y, z: z - at_z, yaw })
    }
}
