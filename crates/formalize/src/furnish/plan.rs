//! A room that is being furnished: what it has, how much of its floor and walls is taken, and how things are added.

use super::build::{Building, PULL_OUT};
use super::floor::{Block, Floor};
use super::groups::{self, Along, GroupPart, Where};
use super::kinds::{FurnishingKind, PlanPlace, seats_all};
use super::slots::{
    CORNER_TABLE, Level, Sizes, Slot, Taken, boards, capacity, in_corner, in_row, is_beside_books, slots,
};
use super::taste::Taste;
use super::{place, stand, tops};
use crate::brief::Group;
use crate::draft::{Demand, Draft, DraftThing, OpeningKind, Statement, ThingOrigin};
use crate::names::{GivenNames, identifier, mentions};
use crate::read::lexicon::get;
use crate::sizes::usual;
use crate::write::number;
use scenelang_lang::nouns::{self, with_article};
use std::borrow::Cow;

/// A furnished room has at most so many things, those asked for included, unless more are asked for; what stands on shelves
/// and tables ends before the inventory does.
const MOST: usize = 220;
const INVENTORY: f64 = 1.6;
/// Of several rooms each has its share of so many, and of so many more for each room.
const SHARED: [usize; 2] = [60, 30];
/// On top of something higher than this (metres) stands only what is put away.
const HIGH: f64 = 1.6;
const KEPT_HIGH: [&str; 4] = ["box", "suitcase", "basket", "plant"];
/// What precedes the name of something that a request rules out.
pub(super) const RULED_OUT: &str = "no ";
/// Groups of groups of groups: so deep.
const DEEP: usize = 4;
/// The parts of a kitchen at its window.
const COUNTER: &str = "kitchen counter";
const SINK: &str = "kitchen sink";
const WINDOW_SINK: &str = "window sink";
/// A table in a restaurant that is shorter is for two (metres).
const FOR_FOUR: f64 = 1.1;
/// A table that is shorter has no more than four chairs, if nobody says how many (metres).
const FOR_SIX: f64 = 1.3;
const RESTAURANT_TABLE: &str = "restaurant table";
const SMALL_RESTAURANT_TABLE: &str = "small restaurant table";

/// A room and its draft.
pub struct Plan<'a> {
    /// What is furnished.
    pub draft: &'a mut Draft,
    pub room: usize,
    pub kind: &'static FurnishingKind,
    pub taste: Taste,
    pub names: GivenNames,
    /// Nouns that are asked for or ruled out.
    closed: Vec<String>,
    /// The square metres that its inventory is counted by: those of such a room, which may be larger.
    pub counted: f64,
    /// For how many people, where that is said.
    pub people: Option<usize>,
    /// Square metres of the floor that are taken.
    pub floor: f64,
    /// Metres of the walls that are taken.
    pub walls: f64,
    /// So many textiles and the like have a colour.
    pub turn: usize,
    /// What is taken where; `None` for floors that are no rectangles.
    pub ground: Option<Floor>,
    /// Things that are asked for and have their place with another: stools at an island.
    pub claimed: Vec<usize>,
    /// Whether what is furnished now matters, and how much that does found no room.
    pub matters: bool,
    /// See `matters`.
    pub lacking: usize,
    /// How many groups have little room behind their chairs, and how much the one has that is placed now.
    pub tight: usize,
    pub pull: f64,
    /// Whether nothing is added but lights: the room has only what is asked for.
    pub only: bool,
    /// Small things that are asked for and wait for something to stand on.
    pub small: Vec<usize>,
    /// What stands on the tops of things.
    pub loads: Vec<(usize, Taken)>,
    /// The part of a shop beyond its tills.
    pub exit: Option<Block>,
    /// The group that is being put together.
    pub building: Option<Building>,
}

/// Whether a thing stands at a wall, and whether that must hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtWall {
    /// Its back touches it.
    Yes,
    /// It need not.
    No,
}

impl<'a> Plan<'a> {
    /// For a room of a draft; `closed`: what is asked for, and after [`RULED_OUT`] what is ruled out.
    pub fn new(
        draft: &'a mut Draft,
        room: usize,
        kind: &'static FurnishingKind,
        closed: Vec<String>,
        people: Option<usize>,
    ) -> Self {
        let mut names = GivenNames::default();
        let rooms = draft.rooms.iter().map(|r| &r.name);
        let all = rooms.chain(draft.openings.iter().map(|o| &o.name)).chain(draft.things.iter().map(|t| &t.name));
        all.for_each(|name| {
            names.take(name);
        });
        let (mut floor, mut walls) = (0.0, 0.0);
        for thing in draft.things.iter().filter(|t| t.room == Some(room)) {
            if let (Some([w, h, d]), true) = (thing.size, stand::on_floor(draft, thing)) {
                // A low flat thing takes no floor.
                let use_of = if h < 0.05 { 0.0 } else { 0.45 };
                floor += thing.count as f64 * (w + 0.1) * (d + use_of);
                if stand::has_back(&thing.category) {
                    walls += thing.count as f64 * (w + 0.1);
                }
            }
        }
        let openings = draft.openings.iter().filter(|o| o.rooms.contains(&room));
        walls += openings.map(|o| o.size[0] + 0.2).sum::<f64>();
        Self {
            draft,
            room,
            kind,
            taste: Taste::new(kind, None),
            names,
            closed,
            counted: 0.0,
            people,
            floor,
            walls,
            turn: 0,
            ground: None,
            claimed: Vec::new(),
            matters: true,
            lacking: 0,
            tight: 0,
            pull: PULL_OUT,
            only: false,
            small: Vec::new(),
            loads: Vec::new(),
            exit: None,
            building: None,
        }
    }

    /// Whether one eats in the room for want of another, beside what such a room has: in a home of several rooms, and where
    /// one cooks.
    pub fn dines(&self) -> bool {
        let eats = |room: &crate::draft::DraftRoom| super::kinds::of(&room.kind).is_some_and(|kind| kind.is_eaten_in());
        let is_asked = |thing: &DraftThing, noun: &str| {
            thing.room == Some(self.room)
                && matches!(thing.source, ThingOrigin::Stated(_))
                && thing.category.replace('_', " ").ends_with(noun)
        };
        let cooks = |thing: &DraftThing| is_asked(thing, COUNTER);
        let eats_at = |thing: &DraftThing| is_asked(thing, "dining table");
        let is_home =
            self.draft.rooms.len() > 1 || self.draft.things.iter().any(|thing| cooks(thing) || eats_at(thing));
        !self.kind.eat.is_empty() && is_home && !self.draft.rooms.iter().any(eats)
    }

    /// Whether rows of people look to the back of the room.
    pub fn is_taught(&self) -> bool {
        self.kind.is_taught()
    }

    /// Whether the desks of a team fill such a room.
    pub fn is_team(&self) -> bool {
        let first = self.kind.lines.first();
        first.is_some_and(|line| matches!(line.place, PlanPlace::Rows(false)) && line.noun.ends_with("desk"))
    }

    /// Whether a table of this name stands aside from the desks of a team.
    pub fn is_parted(&self, noun: &str) -> bool {
        self.is_team() && stand::group(noun) == Group::Table && noun.ends_with("table")
    }

    /// Square metres.
    pub fn area(&self) -> f64 {
        let [w, _, d] = self.draft.rooms[self.room].size;
        w * d
    }

    /// Its name in the program.
    pub fn room_name(&self) -> String {
        self.draft.rooms[self.room].name.clone()
    }

    /// Whether nothing of this name may be added: it is asked for or ruled out, or could be taken for that.
    pub fn is_closed(&self, noun: &str) -> bool {
        let stands_in = |asked: &String| stand::stands_in(noun, asked.strip_prefix(RULED_OUT).unwrap_or(asked));
        self.only || self.is_said(noun) || self.closed.iter().any(stands_in)
    }

    /// Whether something of this name is asked for or ruled out by its name.
    pub fn is_said(&self, noun: &str) -> bool {
        self.closed.iter().any(|asked| match asked.strip_prefix(RULED_OUT) {
            // Where a sofa bed is ruled out, another sofa is not.
            Some(absent) => stand::counts_as(noun, absent) && !absent.starts_with(&format!("{noun} ")),
            None => stand::counts_as(noun, asked),
        })
    }

    /// Whether there is floor and, for what stands at a wall, wall for more.
    pub fn has_room(&self, size: [f64; 3], n: usize, at_wall: bool) -> bool {
        let [w, _, d] = self.draft.rooms[self.room].size;
        let n = n as f64;
        // Where places are known, they keep ways free; the floor may be fuller.
        let more = if self.ground.is_some() { 1.2 } else { 1.0 };
        let floor = self.floor + n * (size[0] + 0.1) * (size[2] + 0.3) <= more * self.kind.fill * w * d;
        // Corners cannot be used from both sides.
        let walls = !at_wall || self.walls + n * (size[0] + 0.1) <= 0.75 * (2.0 * (w + d) - 2.4);
        floor && walls && size[0].min(size[2]) < w.min(d) - 0.9
    }

    pub fn take(&mut self, size: [f64; 3], n: usize, at_wall: bool) {
        self.floor += n as f64 * (size[0] + 0.1) * (size[2] + 0.3);
        if at_wall {
            self.walls += n as f64 * (size[0] + 0.1);
        }
    }

    /// How many things there are in the room.
    pub fn count(&self) -> usize {
        self.draft.things.iter().filter(|t| t.room == Some(self.room)).map(|t| t.count).sum()
    }

    /// Whether the room has more things than such rooms need.
    pub fn is_full(&self) -> bool {
        self.count() > self.most()
    }

    /// Whether such a room is nothing without its bed.
    pub fn sleeps(&self) -> bool {
        self.kind.lines.first().is_some_and(|line| stand::group(line.noun) == Group::Bed)
    }

    /// Whether nothing more of the inventory is added.
    pub fn is_furnished(&self) -> bool {
        self.count() as f64 > self.most() as f64 * INVENTORY
    }

    fn most(&self) -> usize {
        let [all, each] = SHARED;
        match self.draft.rooms.len() {
            1 => MOST,
            rooms => (all + each * rooms) / rooms,
        }
    }

    /// The usual size of a thing.
    pub fn size(noun: &str) -> [f64; 3] {
        if let Some(known) = nouns::noun(noun) {
            return known.size;
        }
        let words: Vec<String> = noun.split(' ').map(str::to_owned).collect();
        let group = get().noun_ending(&words).map_or(Group::Floor, |(_, group)| group);
        usual(group, &words)
    }

    /// Adds a thing, or several like ones; its index among the things.
    pub fn add(&mut self, noun: &str, count: usize, size: [f64; 3], why: &str) -> usize {
        let mut look = self.taste.look(noun, self.turn);
        let category = noun.replace(' ', "_");
        let mut like = self.draft.things.iter().filter(|t| t.room == Some(self.room) && t.category == category);
        match like.find_map(|t| t.look.color.clone().filter(|_| matches!(t.source, ThingOrigin::Inferred(_)))) {
            // Chairs of one kind have one colour.
            Some(color) if look.color.is_some() && stand::group(noun) == Group::Seat => look.color = Some(color),
            _ => self.turn += usize::from(look.color.is_some() || !look.features.is_empty()),
        }
        self.draft.things.push(DraftThing {
            name: self.names.take(&identifier(noun, "thing")),
            category,
            count,
            room: Some(self.room),
            size: Some(size.map(|v| (v * 1000.0).round() / 1000.0)),
            look,
            formation: Vec::new(),
            source: ThingOrigin::Inferred(why.to_owned()),
        });
        self.draft.things.len() - 1
    }

    /// A name that nothing else has.
    pub fn name(&mut self, noun: &str) -> String {
        self.names.take(&identifier(noun, "thing"))
    }

    /// Adds a statement.
    #[expect(clippy::needless_pass_by_value, reason = "callers make the text for this call")]
    pub fn say(&mut self, text: String, why: &str) {
        let statement = Statement::new(&text, ThingOrigin::Inferred(why.to_owned()));
        let is_same = |s: &Statement| s.demand == statement.demand && s.text == statement.text;
        if !self.draft.statements.iter().any(is_same) {
            self.draft.statements.push(statement);
        }
    }

    /// The name by which the table of groups knows a thing: its own, or that of what such rooms have instead. An armchair in
    /// a reading nook is a chair to read in.
    pub(super) fn group_name<'n>(&self, category: &'n str) -> Cow<'n, str> {
        let noun = category.replace('_', " ");
        // Nothing goes with a loft bed, whatever goes with other beds.
        let is_bare = stand::group(&noun) == Group::Bed && groups::listed(&noun, self.kind.dress).is_some();
        if groups::of(&noun, self.kind.dress).is_empty()
            && !is_bare
            && let Some(line) = self.kind.lines.iter().find(|line| stand::counts_as(line.noun, &noun))
        {
            return Cow::Borrowed(line.noun);
        }
        Cow::Owned(noun)
    }

    /// Adds what goes with a thing, and what goes with that.
    pub fn surround(&mut self, thing: usize, wall: AtWall, deep: usize) {
        let name = self.group_name(&self.draft.things[thing].category).into_owned();
        self.surround_as(&name, thing, wall, deep);
    }

    /// The same of a thing that stands for another: a sink of a kitchen unit, whatever it is called.
    pub(super) fn surround_as(&mut self, name: &str, thing: usize, wall: AtWall, deep: usize) {
        if deep >= DEEP {
            return;
        }
        let loaded = stand::loaded(self.draft, thing);
        let has_robot = stand::has_robot(self.draft, thing);
        let is_under_window = self.is_under_window(&self.draft.things[thing].name) || self.has_window_sink(name);
        // Beside a sink under a window nothing tall stands.
        let name = if is_under_window && name == SINK { WINDOW_SINK } else { name };
        let is_narrow = self.draft.things[thing].size.is_some_and(|size| size[0].max(size[2]) < FOR_FOUR);
        let name = if is_narrow && name == RESTAURANT_TABLE { SMALL_RESTAURANT_TABLE } else { name };
        tops::load(self, thing);
        let mut taken: Vec<Taken> = self.loads.iter().filter(|(of, _)| *of == thing).map(|(_, taken)| *taken).collect();
        // In a corner of which no plan knows, nothing has a place at the sides.
        let cornered = self.building.is_none() && self.is_cornered(thing);
        // One thing hangs above another: where a television is asked for, no mirror does.
        let mut has_above = false;
        for part in groups::of(name, self.kind.dress) {
            let on_top = matches!(part.at, Where::Top(..) | Where::Board(..));
            let hung = matches!(part.at, Where::Above(..));
            // Nothing hangs from the sky.
            let roofed = self.kind.lines.iter().any(|line| line.place == PlanPlace::Ceiling);
            // Only boxes are kept out of reach.
            let is_high =
                matches!(part.at, Where::Top(..)) && self.draft.things[thing].size.is_some_and(|s| s[1] > HIGH);
            let seat = matches!(part.at, Where::Front(..)) && stand::group(part.noun) == Group::Seat;
            let aside = !on_top && !hung && !seat && !matches!(part.at, Where::Over);
            if !roofed && matches!(part.at, Where::Over)
                || cornered && aside
                || is_high && !KEPT_HIGH.iter().any(|end| part.noun.ends_with(end))
                || on_top && loaded
                || hung && (wall == AtWall::No || is_under_window || has_above)
            {
                continue;
            }
            // What is asked for has its place in a small room, too. Nobody sits where a robot moves.
            if self.counted < part.least || has_robot && part.at.is_around() {
                has_above |= self.claim(thing, part, wall, deep, &mut taken) && hung;
            } else {
                self.part(thing, part, wall, deep, &mut taken);
            }
        }
    }

    /// Whether a thing is said to stand under a window, where nothing hangs above it.
    fn is_under_window(&self, name: &str) -> bool {
        let windows = self.draft.openings.iter().filter(|opening| opening.kind == OpeningKind::Window);
        let above: Vec<String> = windows.map(|window| format!("above({}, ", window.name)).collect();
        let says = |text: &str| mentions(text, name) && above.iter().any(|above| text.contains(above));
        self.draft.statements.iter().any(|s| says(&s.text))
    }

    /// Whether it is the worktop beside a sink that is said to be under a window: no cupboard hangs there.
    fn has_window_sink(&self, name: &str) -> bool {
        let here = |thing: &&DraftThing| thing.room == Some(self.room) && thing.category.ends_with("sink");
        name == COUNTER && self.draft.things.iter().filter(here).any(|sink| self.is_under_window(&sink.name))
    }

    /// How many elements of a thing that is there already need a part: none if such things are there.
    fn part(&mut self, thing: usize, part: &GroupPart, wall: AtWall, deep: usize, taken: &mut Vec<Taken>) {
        let noun = part.noun;
        let Some(of) = self.draft.things[thing].size else { return };
        let anchors = self.draft.things[thing].count;
        let category = self.draft.things[thing].category.clone();
        let height = self.draft.rooms[self.room].size[1];
        let round = stand::round(&category, &self.draft.things[thing].look.features);
        // Two that look at each other share what is between them.
        let on_top = matches!(part.at, Where::Top(..));
        let is_shared = !on_top && self.building.as_ref().is_some_and(|group| group.is_pair(thing));
        if is_shared || self.claim(thing, part, wall, deep, taken) {
            return;
        }
        // A fence is there only where it is asked for.
        if matches!(part.at, Where::Enclose(..)) {
            return;
        }
        // In a run there is nothing at the sides, but for beds of a ward.
        let in_ward = category.ends_with("hospital_bed") || category.ends_with("patient_bed");
        let beside = matches!(part.at, Where::Side(..) | Where::Sides(..));
        if beside && !in_ward && self.building.as_ref().is_some_and(|group| group.is_run(thing)) {
            return;
        }
        if noun.ends_with("rug") && !self.wants_rug(thing) {
            return;
        }
        let seat = stand::group(noun) == Group::Seat;
        let left_out = self
            .building
            .as_ref()
            .is_some_and(|group| group.skip.contains(&noun) || seat && group.seated.contains(&thing));
        // One bin serves several desks, one easy chair several cribs, one basket and one dryer for several washing machines.
        let for_all = stand::is_easy(noun) || matches!(noun, "bin" | "laundry basket" | "dryer");
        // Goods are shown on tables, however many lie on the shelves.
        let is_shown = category.ends_with("display_table") || noun == "till";
        let closed = self.is_closed(noun) && !(seat && self.is_for_staff(part));
        if left_out || closed || self.is_full() && !seat && !is_shown || for_all && anchors > 1 {
            return;
        }
        let (mut own, at) = self.fitted(thing, part, of);
        // A table with fewer seats than there are people wants a larger room.
        let seats_them = seats_all(self.kind, &category.replace('_', " "));
        let people = self.people.filter(|_| seats_them).map_or(0, |n| n.div_ceil(anchors));
        if let (Where::Around(n, _) | Where::LongSides(n, _) | Where::Outside(n, _), Some(group)) =
            (&at, &mut self.building)
        {
            group.is_crowded |= *n < people;
        }
        let shelf = boards(&category, of[1], of[0]);
        if let (Where::Board(board, ..), [low, next, ..]) = (&at, &shelf[..])
            && board + 1 < shelf.len()
        {
            own[1] = own[1].min(next - low - 0.045);
        }
        let mut places = slots(&at, &Sizes { of, own, round }, &shelf);
        for slot in &mut places {
            taken.iter().for_each(|other| other.raise(slot, own, of[1]));
        }
        places.retain(|slot| {
            let fits = match (slot.level, &at) {
                (Level::Above(y), _) => y + own[1] < height - 0.05,
                (_, Where::Board(board, ..)) => is_beside_books(&category, slot, own[0], (*board, shelf.len()), of[0]),
                _ => true,
            };
            let low = own[1] < 0.05 && slot.level == Level::Floor;
            fits && (low || !taken.iter().any(|other| Taken::by(slot, stand::foot(noun, own)).meets(other)))
        });
        let each = places.len();
        let stands = places.iter().any(|slot| slot.level == Level::Floor) && own[1] > 0.05;
        // Where places are known, they say better whether there is room for seats that matter.
        let is_asked = matches!(self.draft.things[thing].source, ThingOrigin::Stated(_));
        let is_known = seat && (self.matters || is_asked) && self.ground.is_some();
        let has_room = !stands || is_known || self.has_room(own, each * anchors, false);
        if each == 0 || !self.has_room_for_rug(own) || !has_room {
            // A table without its seats wants a larger room.
            if each > 0
                && seat
                && let Some(group) = &mut self.building
            {
                group.is_crowded = true;
            }
            return;
        }
        let flush = matches!(at, Where::Side(_, Along::Backs, ..) | Where::Sides(_, Along::Backs));
        if stands {
            self.take(own, each * anchors, flush && wall == AtWall::Yes);
        }
        if stands || places.iter().any(|slot| slot.level != Level::Floor) {
            taken.extend(places.iter().map(|slot| Taken::by(slot, stand::foot(noun, own))));
        }
        let why = why(&category.replace('_', " "), noun, &at);
        let new = self.add(noun, each * anchors, own, &why);
        if let Some(group) = &mut self.building {
            group.add(thing, new, &places, (noun, own, &at), height);
        }
        self.fix(thing, new, &places, height, &why);
        self.group(thing, new, (&at, &places), &why);
        let name = if in_corner(&at, &Sizes { of, own, round }) { CORNER_TABLE } else { noun };
        self.surround_as(name, new, if flush { wall } else { AtWall::No }, deep + 1);
    }

    /// Whether it is the seat of who receives those that wait on chairs that are asked for.
    fn is_for_staff(&self, part: &GroupPart) -> bool {
        let waits = |at: usize| super::asked::is_for_waiting(self, at);
        matches!(part.at, Where::Back(..)) && (0..self.draft.things.len()).any(waits)
    }

    /// How large a part is beside a thing of a size, and where it stands: seats as many as the people need who sit there.
    pub(super) fn fitted(&self, thing: usize, part: &GroupPart, of: [f64; 3]) -> ([f64; 3], Where) {
        let it = &self.draft.things[thing];
        let round = stand::round(&it.category, &it.look.features);
        let mut own = part.size.unwrap_or_else(|| Self::size(part.noun));
        let mut at = part.at.clone();
        let people = self.people.filter(|_| seats_all(self.kind, &it.category.replace('_', " ")));
        let each = people.map(|people| people.div_ceil(it.count));
        match (&mut at, each) {
            // Two sit side by side at a desk that they share.
            (Where::Front(gap, ..), _) if stand::group(part.noun) == Group::Seat && super::asked::is_shared(it) => {
                at = Where::Row(2, *gap);
            }
            // Cabinets end where the worktop below them does.
            (Where::Above(..), _) => own[0] = own[0].min(of[0]),
            (Where::Under(wider, deeper, _), _) => own = [of[0] + *wider, 0.012, of[2] + *deeper],
            (Where::Around(n, _), Some(each)) => *n = each.min(capacity(of, own, round)),
            // Nobody sits at the ends of a short table unless they have to.
            (Where::Around(n, _), None) if !round && of[0].max(of[2]) < FOR_SIX => *n = (*n).min(4),
            // Nobody sits at the ends.
            (Where::LongSides(n, _), Some(each)) => {
                let sides = if round { of } else { [of[0].max(of[2]), of[1], 0.0] };
                *n = each.min(capacity(sides, own, round));
            }
            // It is as large as they need.
            (Where::Outside(n, _), Some(each)) => *n = each,
            // At one side of it, unless as many stand there as there is room for.
            (Where::Row(n, _), Some(each)) if *n > 0 => *n = each.clamp(1, in_row(of[0], own[0])),
            _ => {}
        }
        (own, at)
    }

    /// Whether something of a size leaves the edges of the floor bare.
    pub(super) fn has_room_for_rug(&self, [own_w, _, own_d]: [f64; 3]) -> bool {
        let [w, _, d] = self.draft.rooms[self.room].size;
        own_w.min(own_d) < w.min(d) - 0.4 && own_w.max(own_d) < w.max(d) - 0.4
    }

    /// Whether a rug lies under a thing: one in each room, and none on tiles. A table whose place is asked for does not keep
    /// away from the walls for the sake of one, and beside what is asked for in a corner there is no room for one.
    fn wants_rug(&self, thing: usize) -> bool {
        let it = &self.draft.things[thing];
        let is_rug = |t: &DraftThing| t.room == Some(self.room) && t.category.ends_with("rug");
        let bound = stand::group(&it.category) == Group::Table && stand::placed(self.draft, &it.name);
        let corner = format!("inCorner({}, ", it.name);
        let asks = |s: &Statement| matches!(s.source, ThingOrigin::Stated(_)) && s.text.contains(&corner);
        let is_in_corner = self.draft.statements.iter().any(asks);
        let is_free = !bound && !is_in_corner && it.count == 1;
        is_free && self.kind.floor.0 != "tile" && !self.draft.things.iter().any(is_rug)
    }

    /// Says where the elements of a part are, given those of what it goes with.
    pub(super) fn fix(&mut self, thing: usize, new: usize, places: &[Slot], ceiling: f64, why: &str) {
        let (of, part) = (self.draft.things[thing].clone(), self.draft.things[new].clone());
        let (each, own) = (places.len(), part.size.map_or(0.0, |s| s[1]));
        let room = self.room_name();
        let fixed: Vec<String> = places
            .iter()
            .enumerate()
            .map(|(j, slot)| {
                let anchor = if of.count > 1 { format!("{}[i]", of.name) } else { of.name.clone() };
                let element = match (of.count > 1, each > 1, j) {
                    (false, false, _) => part.name.clone(),
                    (false, true, j) => format!("{}[{j}]", part.name),
                    (true, false, _) => format!("{}[i]", part.name),
                    (true, true, 0) => format!("{}[{each} * i]", part.name),
                    (true, true, j) => format!("{}[{each} * i + {j}]", part.name),
                };
                place::fixed(&element, &anchor, slot, own, ceiling)
            })
            .collect();
        let size = part.size.unwrap_or_default();
        let above = places.iter().filter(|slot| matches!(slot.level, Level::Top | Level::Above(_)));
        self.loads.extend(above.map(|slot| (thing, Taken::by(slot, size))));
        let all = fixed.join(" and ");
        // Rows of tables may have given the seats their places already.
        let first = format!("{}[{each} * i].pos.x = ", part.name);
        if !self.draft.statements.iter().any(|s| s.demand == Demand::Must && s.text.contains(&first)) {
            let each = if of.count > 1 { format!("forall i in 0..{}: ", of.count) } else { String::new() };
            self.say(format!("assert {each}{all};"), why);
        }
        let every = |f: &dyn Fn(&str) -> String| match part.count {
            1 => format!("assert {};", f(&part.name)),
            _ => format!("assert forall a in {}: {};", part.name, f("a")),
        };
        match places.first().map(|slot| slot.level) {
            Some(Level::Ceiling) => self.say(every(&|a| format!("ceilingMounted({a}, {room})")), why),
            Some(Level::Above(_)) => self.say(every(&|a| format!("wallMounted({a}, {room})")), why),
            _ => {}
        }
        if own < 0.05 && places.iter().any(|slot| slot.level == Level::Floor) {
            let names: Vec<String> = match part.count {
                1 => vec![part.name.clone()],
                n => (0..n).map(|i| format!("{}[{i}]", part.name)).collect(),
            };
            for name in names {
                let text = format!("allowCollide({name}, objects);");
                if !self.draft.statements.iter().any(|s| s.text == text) {
                    self.say(text, "objects may stand on it");
                }
            }
        }
    }

    /// Names the group by the predicate of the library, where there is one of each.
    pub(super) fn group(&mut self, thing: usize, new: usize, (at, places): (&Where, &[Slot]), why: &str) {
        let (of, part) = (&self.draft.things[thing], &self.draft.things[new]);
        if of.count > 1 {
            return;
        }
        let last = |name: &str| name.rsplit('_').next().unwrap_or(name).to_owned();
        let (anchor, kind) = (last(&of.category), last(&part.category));
        let call = match (anchor.as_str(), kind.as_str(), at) {
            // At an oval table chairs look square to its edge, not to its sides.
            ("table", "chair", Where::Around(..))
                if is_balanced(places)
                    && (!stand::round(&of.category, &of.look.features)
                        || of.size.is_some_and(|s| (s[0] - s[2]).abs() < 0.01)) =>
            {
                "diningSet"
            }
            ("desk", "chair", Where::Front(gap, ..)) if *gap >= 0.0 => "deskSet",
            ("bed", "nightstand", _) => "bedSet",
            ("sofa", "table", Where::Front(gap, ..)) if *gap >= 0.0 => "seatingGroup",
            _ => return,
        };
        let text = format!("assert {call}({}, {});", of.name, part.name);
        self.say(text, why);
    }
}

/// Whether seats stand on all sides of their table alike, as `balanced` of the library says: not if a bench has one side.
fn is_balanced(places: &[Slot]) -> bool {
    let half = places.len().saturating_sub(1).div_ceil(2);
    let ends: [fn(&Slot) -> f64; 4] = [|s| s.x, |s| -s.x, |s| s.z, |s| -s.z];
    ends.iter().all(|side| places.iter().filter(|slot| side(slot) >= -0.05).count() >= half)
}

/// Whether a thing is there because so many people are said to sit at another.
pub fn for_people(source: &ThingOrigin) -> bool {
    matches!(source, ThingOrigin::Inferred(why) if why.ends_with("people sit there"))
}

/// Why a part is there.
pub(super) fn why(of: &str, noun: &str, at: &Where) -> String {
    let a = with_article;
    match at {
        Where::Top(..) => format!("{} needs {} on it", a(of), a(noun)),
        Where::Board(..) => format!("{} holds things", a(of)),
        Where::Around(..) | Where::LongSides(..) | Where::Outside(..) | Where::Row(..) => {
            format!("people sit at {}", a(of))
        }
        Where::Under(..) => format!("{} lies under {}", a(noun), a(of)),
        Where::Over => format!("{} lights {}", a(noun), a(of)),
        Where::Above(..) => format!("{} is hung above {}", a(noun), a(of)),
        _ => format!("{} goes with {}", a(noun), a(of)),
    }
}

/// A number of metres, as the language writes it.
pub fn metres(v: f64) -> String {
    number((v * 1000.0).round() / 1000.0)
}
