//! What is asked for and goes with something else stands where such things go with it: chairs at their table, nightstands
//! beside the bed, the coffee table before the sofa. It waits for that, whether it is asked for, too, or comes with the
//! room.

use super::groups::{self, Along, GroupPart, Where};
use super::kinds::{Count, FurnishingKind, Line};
use super::plan::{AtWall, Plan, for_people, why};
use super::slots::{self, CORNER_TABLE, Sizes, Slot, Taken, slots};
use super::stand::{self, counts_as};
use super::{FENCED, daylight, units};
use crate::brief::Group;
use crate::draft::{Demand, Draft, DraftThing, Statement, ThingOrigin};
use crate::names::{calls, mentions, words};

/// Groups of groups: so deep.
const DEEP: usize = 2;
/// What is lower lies flat, and things stand on it (metres).
const FLAT: f64 = 0.05;
/// Between a desk and those who visit, and between it and a second chair beside it (metres).
const VISITOR: f64 = 0.4;
/// Before an L-shaped desk or sofa, for what is said to look at it (metres).
const FACING: f64 = 0.05;
const SECOND: f64 = 0.25;
/// A requested rug that is smaller than usual, because there is no room for a larger one.
const SMALLER: &str = "small rug";
/// What says that something is before something else.
const BEFORE: [&str; 3] = ["looksAt", "facing", "inFrontOf"];
/// What is fenced in is so near to its fence (metres).
const WITHIN: f64 = 0.8;

impl Plan<'_> {
    /// A part of a group that is asked for, and of which nothing else is said, stands where such a part does. Whether there
    /// is one.
    pub(super) fn claim(
        &mut self,
        thing: usize,
        part: &GroupPart,
        wall: AtWall,
        deep: usize,
        taken: &mut Vec<Taken>,
    ) -> bool {
        // A rug for which there is no room becomes a smaller one first.
        let skips = |noun| self.building.as_ref().is_none_or(|group| group.skip.contains(&noun));
        let smaller = matches!(part.at, Where::Under(..)) && skips(part.noun) && !skips(SMALLER);
        let left_out = skips(part.noun) && !smaller;
        let around = part.at.is_around();
        if !is_claimed(part) || left_out || around && self.is_at_wall(&self.draft.things[thing].name) {
            return false;
        }
        let anchor = self.draft.things[thing].clone();
        let asked = (0..self.draft.things.len()).find(|i| {
            *i != thing
                && self.is_free(*i, Some(&anchor))
                && takes(part, &self.draft.things[*i].category)
                && self.agrees(part, &self.draft.things[*i].name)
        });
        let Some(asked) = asked else { return false };
        if let (Where::Enclose(beside, behind), Some(of)) = (&part.at, anchor.size)
            && (wall == AtWall::Yes || !self.fence_in(asked, of, [*beside, *behind]))
        {
            return false;
        }
        let mut it = self.draft.things[asked].clone();
        let (Some(of), Some(mut own)) = (anchor.size, it.size) else { return false };
        if matches!(part.at, Where::Under(..)) {
            // A rug of which no size is said is as large as what is on it asks for.
            let usual = Self::size(part.noun);
            let mut size = if [own[0], own[2]] == [usual[0], usual[2]] { self.fitted(thing, part, of).0 } else { own };
            if smaller {
                size = [(of[0] + size[0]) / 2.0, size[1], (of[2] + size[2]) / 2.0];
            }
            if !self.has_room_for_rug(size) {
                return false;
            }
            own = size;
            it.size = Some(size);
            self.draft.things[asked].size = it.size;
        }
        let each = it.count / anchor.count;
        if each == 0 || each * anchor.count != it.count {
            return false;
        }
        let round = stand::round(&anchor.category, &anchor.look.features);
        // What is said to look at it stands before it, and not in its corner.
        let faces = |s: &Statement| {
            matches!(s.source, ThingOrigin::Stated(_))
                && mentions(&s.text, &it.name)
                && calls(&s.text).iter().any(|call| BEFORE.contains(call))
        };
        let in_corner = matches!(part.at, Where::Front(gap, ..) if gap < 0.0);
        let before = GroupPart { at: Where::Front(FACING, 180.0, 0.0), ..part.clone() };
        let part = if in_corner && self.draft.statements.iter().any(faces) { &before } else { part };
        // Two benches at a table are at its long sides.
        let facing = GroupPart { at: Where::LongSides(each, 0.02), ..part.clone() };
        let part = if part.noun == "bench" && each > 1 { &facing } else { part };
        let foot = stand::foot(part.noun, own);
        let is_bent = self.building.as_ref().is_some_and(|group| group.is_bent(thing));
        let mut places: Vec<Slot> = wheres(part, each, (wall, is_bent))
            .iter()
            .flat_map(|at| slots(at, &Sizes { of, own, round }, &[]))
            .filter(|slot| own[1] < FLAT || !taken.iter().any(|other| Taken::by(slot, foot).meets(other)))
            .collect();
        // What is left as one looks at its front is at its own right.
        let seen_left = ["[0]", ""].map(|index| format!("seenLeftOf({}{index}, ", it.name));
        if self.draft.statements.iter().any(|s| seen_left.iter().any(|seen| s.text.contains(seen))) {
            places.reverse();
        }
        places.truncate(each);
        if places.len() != each {
            return false;
        }
        let height = self.draft.rooms[self.room].size[1];
        let why = why(&anchor.category.replace('_', " "), part.noun, &part.at);
        if let Some(group) = &mut self.building {
            let noun = if smaller { SMALLER } else { part.noun };
            group.add(thing, asked, &places, (noun, own, &part.at), height);
        }
        if own[1] >= FLAT {
            taken.extend(places.iter().map(|slot| Taken::by(slot, foot)));
        }
        self.claimed.push(asked);
        if matches!(part.at, Where::Enclose(..)) {
            self.fenced(&anchor.name, &it.name);
        }
        // A bench or a highchair is at one side of a table: chairs are at the others. Two benches are all its seats.
        let benches = part.noun == "bench" && each > 1;
        let aside = matches!(part.noun, "bench" | "highchair") && !benches;
        let is_seat = stand::group(part.noun) == Group::Seat && !aside;
        if let Some(group) = self.building.as_mut().filter(|_| is_seat) {
            group.seated.push(thing);
        }
        self.fix(thing, asked, &places, height, &why);
        let flush = matches!(part.at, Where::Side(_, Along::Backs, _, _) | Where::Sides(_, Along::Backs));
        let name = if slots::in_corner(&part.at, &Sizes { of, own, round }) { CORNER_TABLE } else { part.noun };
        self.surround_as(name, asked, if flush { wall } else { AtWall::No }, deep + 1);
        true
    }

    /// What is said to be behind a fence that goes around it is near it on all sides.
    fn fenced(&mut self, thing: &str, fence: &str) {
        for statement in &mut self.draft.statements {
            let named = words(&statement.text);
            let both = named.contains(&thing) && named.contains(&fence);
            if both && matches!(statement.source, ThingOrigin::Stated(_)) && statement.text.contains("behind(") {
                statement.text = format!("near({thing}, {fence}, {WITHIN})");
            }
        }
    }

    /// Makes a fence that is asked for as large as what it goes around needs. Whether it can be.
    fn fence_in(&mut self, fence: usize, of: [f64; 3], [beside, behind]: [f64; 2]) -> bool {
        let it = &mut self.draft.things[fence];
        let Some([w, h, d]) = it.size.filter(|_| it.count == 1) else { return false };
        let around = slots::enclosure(of, beside, behind, h);
        if d < slots::THIN {
            it.size = Some(around);
        }
        d < slots::THIN || w == around[0] && d == around[2]
    }

    /// Whether a thing is asked for and has no place yet, and nothing is said of where it is but in relation to `anchor`.
    fn is_free(&self, at: usize, anchor: Option<&DraftThing>) -> bool {
        let noun = anchor.map(|anchor| self.group_name(&anchor.category));
        self.is_unplaced(at)
            && !self.is_said_elsewhere(
                at,
                anchor.map(|anchor| anchor.name.as_str()),
                noun.as_deref().unwrap_or_default(),
            )
    }

    /// Whether it is said where a thing is, but in relation to `other`, to a window that goes where the thing is, or as the
    /// group of `noun` has it.
    fn is_said_elsewhere(&self, at: usize, other: Option<&str>, noun: &str) -> bool {
        let is_fixed = |s: &Statement| !daylight::is_moving_window(self, s);
        let name = &self.draft.things[at].name;
        let says = |s: &Statement| {
            let any = is_any_of(&s.text, name) || units::is_in_run(&s.text, name);
            is_fixed(s) && !any && !carries(&s.text, name) && !self.is_within(noun, &s.text)
        };
        stand::placed_where(self.draft, name, other, &says)
    }

    /// Whether a statement says that a part of a group is before one that hangs above what the group goes with: a chair
    /// before the mirror over a counter.
    fn is_within(&self, noun: &str, text: &str) -> bool {
        let parts = groups::of(noun, self.kind.dress);
        let is_part = |thing: &DraftThing, place: &dyn Fn(&Where) -> bool| {
            parts.iter().any(|part| place(&part.at) && takes(part, &thing.category))
        };
        let own = self.draft.things.iter().filter(|thing| mentions(text, &thing.name));
        let (before, rest): (Vec<_>, Vec<_>) = own.partition(|thing| is_subject(text, &thing.name));
        calls(text).iter().all(|call| BEFORE.contains(call))
            && !before.is_empty()
            && !rest.is_empty()
            && before.iter().all(|thing| is_part(thing, &|at| matches!(at, Where::Front(..))))
            && rest.iter().all(|thing| is_part(thing, &|at| matches!(at, Where::Above(..))))
    }

    /// Whether a thing is asked for, has no place yet, and stands where something else might have it.
    fn is_unplaced(&self, at: usize) -> bool {
        let it = &self.draft.things[at];
        it.room == Some(self.room)
            && (matches!(it.source, ThingOrigin::Stated(_)) || for_people(&it.source) || encloses(&it.source))
            && !self.claimed.contains(&at)
            && self.draft.place_of(&it.name).or(self.draft.place_of(&format!("{}[0]", it.name))).is_none()
            && (stand::on_floor(self.draft, it)
                || matches!(stand::group(&it.category), Group::Screen | Group::Flat)
                || it.category.ends_with("mirror"))
            && !is_drawn_up(self.draft, &it.name)
    }

    /// Whether what is said of a thing holds where such a part stands, as far as its words tell.
    fn agrees(&self, part: &GroupPart, name: &str) -> bool {
        let around = part.at.is_around();
        let about = |s: &&Statement| matches!(s.source, ThingOrigin::Stated(_)) && mentions(&s.text, name);
        // Most sofas stand at a wall: a bookcase is behind one only if the request says so.
        let optional = part.least >= groups::IF_ASKED && matches!(part.at, Where::Back(..));
        if optional && !self.draft.statements.iter().filter(about).any(|s| calls(&s.text).contains(&"behind")) {
            return false;
        }
        let hangs_over = matches!(part.at, Where::Above(..));
        let tells = |s: &&Statement| {
            // What hangs there has something before it, and is not said to be anywhere.
            let only_before = hangs_over && !is_subject(&s.text, name);
            !(daylight::is_moving_window(self, s) || carries(&s.text, name) || only_before)
        };
        self.draft.statements.iter().filter(about).filter(tells).all(|s| {
            // That seats are spread over the sides of a table is only preferred.
            let spread = around && s.demand == Demand::Prefer;
            calls(&s.text).iter().all(|call| match *call {
                "near" | "looksAt" | "facing" | "onFloor" | "reachable" => true,
                "clear" => around && stand::group(part.noun) == Group::Seat,
                "inside" => s.text.contains(&format!(", {})", self.draft.rooms[self.room].name)),
                "around" => around,
                "inFrontOf" => spread || matches!(part.at, Where::Front(..) | Where::Row(..)),
                "behind" => spread || matches!(part.at, Where::Enclose(..) | Where::Back(..) | Where::RowBehind(..)),
                "leftOf" | "rightOf" => spread,
                // "A nightstand on each side of it": one left and one right, as one looks at its front.
                "seenLeftOf" | "seenRightOf" => matches!(part.at, Where::Sides(..)),
                "beside" => matches!(part.at, Where::Side(..) | Where::Sides(..)),
                _ => false,
            })
        })
    }

    /// Whether a thing is said to stand in a corner or at a wall, so that nothing is on all sides of it.
    fn is_at_wall(&self, name: &str) -> bool {
        const WALLS: [&str; 3] = ["inCorner", "againstWall", "backToWall"];
        self.draft.statements.iter().any(|s| {
            matches!(s.source, ThingOrigin::Stated(_))
                && mentions(&s.text, name)
                && calls(&s.text).iter().any(|call| WALLS.contains(call))
        })
    }

    /// Whether a thing that is asked for gets its place with another one that is.
    pub(super) fn waits_for_asked(&self, at: usize) -> bool {
        self.is_unplaced(at) && (0..self.draft.things.len()).any(|other| self.joins(at, other))
    }

    /// Whether a thing that is asked for goes with another one, and nothing is said that keeps it from there.
    pub(super) fn goes_with(&self, at: usize, other: usize) -> bool {
        self.is_unplaced(at) && self.joins(at, other)
    }

    /// The same of a thing that has no place yet.
    fn joins(&self, at: usize, other: usize) -> bool {
        let anchor = &self.draft.things[other];
        at != other
            && self.ground.is_some()
            && anchor.room == Some(self.room)
            && (matches!(anchor.source, ThingOrigin::Stated(_)) || for_people(&anchor.source))
            && self.draft.things[at].count.is_multiple_of(anchor.count)
            && !self.is_said_elsewhere(at, Some(&anchor.name), &self.group_name(&anchor.category))
            && has_part(&self.group_name(&anchor.category), self.kind.dress, DEEP, &|part| {
                takes(part, &self.draft.things[at].category) && self.agrees(part, &self.draft.things[at].name)
            })
    }

    /// The things that are asked for and go with one that is.
    pub(super) fn companions(&self, of: usize) -> Vec<usize> {
        (0..self.draft.things.len()).filter(|at| self.goes_with(*at, of)).collect()
    }

    /// Whether the request says where a thing stands, and not only where something else does in relation to it.
    pub(super) fn is_placed(&self, at: usize) -> bool {
        let name = &self.draft.things[at].name;
        let stated = self.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
        stated.filter(|s| mentions(&s.text, name) && !stand::is_path(s)).any(|s| is_subject(&s.text, name))
    }

    /// Whether the request says that something is in a corner, or each of several things.
    pub(super) fn is_cornered(&self, at: usize) -> bool {
        let name = &self.draft.things[at].name;
        let corners = [format!("inCorner({name}, "), format!("forall a in {name}: inCorner(a, ")];
        let mut stated = self.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
        stated.any(|s| s.demand == Demand::Must && corners.iter().any(|corner| s.text.contains(corner)))
    }

    /// On which side of the room's middle something is said to be (signs of x and z; 0: nothing is said).
    pub(super) fn side(&self, at: usize) -> [f64; 2] {
        let name = &self.draft.things[at].name;
        let stated = || self.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
        ["x", "z"].map(|axis| {
            let says = |sign: &str| stated().any(|s| s.text.contains(&format!("{name}.center.{axis} {sign}= ")));
            f64::from(u8::from(says(">"))) - f64::from(u8::from(says("<")))
        })
    }

    /// Whether the request says that something is in a corner, or each of several things, and nothing else of where it stands.
    pub(super) fn is_in_corners(&self, at: usize) -> bool {
        let thing = &self.draft.things[at];
        let name = &thing.name;
        let corners = match thing.count {
            1 => format!("inCorner({name}, "),
            _ => format!("forall a in {name}: inCorner(a, "),
        };
        let stated = self.draft.statements.iter().filter(|s| matches!(s.source, ThingOrigin::Stated(_)));
        let mut own = stated.filter(|s| is_subject(&s.text, &thing.name)).peekable();
        own.peek().is_some() && own.all(|s| s.text.starts_with(&corners))
    }

    /// Whether a thing that is asked for gets its place with something of the inventory.
    pub(super) fn waits_for_inventory(&self, at: usize) -> bool {
        self.line_of(at).is_some()
    }

    /// How many of a line's things there are for seats that are asked for and stand at them. A bin stands at one of them.
    pub(super) fn tables(&self, line: &Line) -> Option<usize> {
        let is_seat = |at: &usize| stand::group(&self.draft.things[*at].category) == Group::Seat;
        let seats = (0..self.draft.things.len()).filter(is_seat).find(|at| self.line_of(*at) == Some(line))?;
        spread(line, self.draft.things[seats].count)
    }

    /// The line of the inventory with which a thing that is asked for stands.
    fn line_of(&self, at: usize) -> Option<&'static Line> {
        let it = &self.draft.things[at];
        if self.ground.is_none() || !matches!(it.source, ThingOrigin::Stated(_)) || !self.is_unplaced(at) {
            return None;
        }
        let said = |noun: &str| self.is_closed(noun);
        let line = line(self.kind, &it.category.replace('_', " "), it.count, &said)?;
        (!self.is_said_elsewhere(at, None, line.noun)).then_some(line)
    }
}

/// Whether a thing is a fence that nobody asked for.
fn encloses(source: &ThingOrigin) -> bool {
    matches!(source, ThingOrigin::Inferred(why) if why == FENCED)
}

/// Whether a thing stands at its table by a statement that nobody asked for, as seats in rows do.
fn is_drawn_up(draft: &Draft, name: &str) -> bool {
    let place = format!("{name}[i].pos.");
    draft.statements.iter().any(|s| !matches!(s.source, ThingOrigin::Stated(_)) && s.text.contains(&place))
}

/// Whether a statement places a thing: it is the first argument of a call, its elements are gone through, or a property of
/// it is spoken of.
fn is_subject(text: &str, name: &str) -> bool {
    let begins = |rest: &str| {
        rest.strip_prefix(name).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
    };
    let after = |sign: &str| text.match_indices(sign).any(|(at, _)| begins(text[at + sign.len()..].trim_start()));
    after("(") || after(" in ") || text.contains(&format!("{name}.")) || text.contains(&format!("{name}[i]."))
}

/// Whether a statement says only what stands on a thing: a lamp on each nightstand.
fn carries(text: &str, name: &str) -> bool {
    calls(text).iter().all(|call| *call == "restsOn") && text.contains("restsOn(") && !is_subject(text, name)
}

/// Whether a statement places something else at any one of several things: a bench opposite the chairs.
fn is_any_of(text: &str, name: &str) -> bool {
    let text = text.trim_start_matches('(');
    text.starts_with("exists ")
        && text
            .split_once(':')
            .is_some_and(|(head, rest)| head.ends_with(&format!(" in {name}")) && !mentions(rest, name))
}

/// Where elements of a part may be that are asked for, the best place first.
fn wheres(part: &GroupPart, each: usize, (wall, is_bent): (AtWall, bool)) -> Vec<Where> {
    match part.at {
        // At the other side of a low table is the corner of its sofa.
        Where::Side(gap, ..) if is_bent => vec![part.at.clone(), Where::Back(gap, 0.0)],
        Where::Row(_, gap) => vec![Where::Row(each, gap)],
        Where::RowBehind(_, gap) => vec![Where::RowBehind(each, gap)],
        Where::Around(_, gap) => vec![Where::Around(each, gap)],
        Where::LongSides(_, gap) => vec![Where::LongSides(each, gap)],
        Where::Outside(_, gap) => vec![Where::Outside(each, gap)],
        Where::Side(gap, along, left, yaw) => {
            vec![part.at.clone(), Where::Side(gap, along, -left, (360.0 - yaw) % 360.0)]
        }
        // One at each side.
        Where::Front(gap, yaw, aside) if each == 2 && aside != 0.0 => {
            vec![part.at.clone(), Where::Front(gap, (360.0 - yaw) % 360.0, -aside)]
        }
        // Who visits sits across the desk, or beside it where it stands at a wall.
        Where::Front(..) if each > 1 && stand::group(part.noun) == Group::Seat => match wall {
            AtWall::No => vec![part.at.clone(), Where::RowBehind(each - 1, VISITOR)],
            AtWall::Yes => vec![
                part.at.clone(),
                Where::Side(SECOND, Along::Backs, -1.0, 0.0),
                Where::Side(SECOND, Along::Backs, 1.0, 0.0),
            ],
        },
        ref at => vec![at.clone()],
    }
}

/// Whether a part stands on the floor beside what it goes with, or is a television on its stand or above the fire, or a mirror above it.
fn is_claimed(part: &GroupPart) -> bool {
    use Where::{Above, Around, Back, Enclose, Front, LongSides, Outside, Row, RowBehind, Side, Sides, Top, Under};
    match part.at {
        Enclose(..) | Front(..) | Back(..) | Side(..) | Sides(..) | Row(..) | RowBehind(..) => true,
        Around(..) | LongSides(..) | Outside(..) | Under(..) => true,
        Top(..) => stand::group(part.noun) == Group::Screen && part.noun == "tv",
        Above(..) => matches!(part.noun, "mirror" | "tv"),
        _ => false,
    }
}

/// Whether a thing that is asked for is such a part. A plain chair may be any; a plain table is none of the small ones.
fn takes(part: &GroupPart, category: &str) -> bool {
    let asked = category.replace('_', " ");
    let seat = stand::group(part.noun) == Group::Seat;
    let easy = asked != part.noun && stand::is_easy(&asked);
    asked == part.noun
        // A lamp of which nothing is said stands on the floor.
        || asked == "lamp" && part.noun == "floor lamp"
        || asked.ends_with(&format!(" {}", part.noun)) && !easy
        || stand::are_kin(part.noun, &asked)
        || seat && counts_as(part.noun, &asked) && !easy
}

/// Whether such a part goes with a thing, or with what goes with that.
fn has_part(of: &str, dress: &str, deep: usize, is_such: &dyn Fn(&GroupPart) -> bool) -> bool {
    let mut parts = groups::of(of, dress).iter().filter(|part| is_claimed(part));
    deep > 0 && parts.any(|part| is_such(part) || has_part(part.noun, dress, deep - 1, is_such))
}

/// The line of an inventory with which so many of something stand, for several one that counts people before others; none
/// where such things have a line of their own.
pub(super) fn line(
    kind: &'static FurnishingKind,
    noun: &str,
    n: usize,
    said: &dyn Fn(&str) -> bool,
) -> Option<&'static Line> {
    if kind.lines.iter().any(|line| counts_as(line.noun, noun)) {
        return None;
    }
    let usual = kind.size[0] * kind.size[2];
    let fitting = || {
        let open = kind.lines.iter().filter(|line| line.least <= usual && !said(line.noun) && fits(line, n));
        open.filter(|line| has_part(line.noun, kind.dress, DEEP, &|part| takes(part, noun)))
    };
    let for_people = fitting().find(|line| n > 1 && matches!(line.count, Count::People(_)));
    for_people.or_else(|| fitting().next())
}

/// Whether so many things can be spread evenly over what a line stands for.
fn fits(line: &Line, n: usize) -> bool {
    match line.count {
        Count::Fixed(lines) => lines == 1,
        Count::People(_) => spread(line, n).is_some(),
        Count::Area(_) => false,
    }
}

/// Over how many of a line's things so many seats can be spread, as many at each as usual or fewer, but not one alone;
/// `None` where the line does not count people.
pub(super) fn spread(line: &Line, seats: usize) -> Option<usize> {
    let Count::People(each) = line.count else { return None };
    let each = each as usize;
    (1..=each).rev().find(|k| seats.is_multiple_of(*k) && (*k > 1 || each == 1 || seats == 1)).map(|k| seats / k)
}

/// Whether people sit at what a line stands for, so that as many seats as are asked for say how many people there are.
pub(super) fn sit_at(line: &Line, dress: &str) -> bool {
    let parts = groups::of(line.noun, dress);
    parts.iter().any(|part| matches!(part.at, Where::Row(..) | Where::Around(..) | Where::LongSides(..)))
        || matches!(line.count, Count::People(_))
}
