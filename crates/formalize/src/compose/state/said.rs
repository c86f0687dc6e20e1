//! How each kind of relation is said: on, under, beside, in front of, turned to, left and right of.

use super::Named;
use super::relations::{ACROSS, BEFORE, DRAWN_UP, NEAR, predicate};
use crate::brief::{FactKind, Group, Pattern, Place, Rel};
use crate::compose::sizes;
use crate::write::number;

/// What is opposite something is no nearer to it than this part of the shorter side of its room.
const SMALL_ROOM: f64 = 0.35;
/// The least between two things across from each other, and what is between walls and things (metres).
const PASSAGE: f64 = 0.6;
const LOOSE: f64 = 0.1;
/// What is lower than this may stand at the foot of a bed, so far from it (metres).
const LOW: f64 = 0.7;
const AT_FOOT: f64 = 0.6;
const AT_WINDOW: f64 = 0.6;

/// A relation of one thing to another that is not denied.
#[derive(Clone, Copy)]
pub(super) struct Said {
    pub a: usize,
    pub rel: Rel,
    /// The other thing.
    pub b: usize,
    /// `assert` or `prefer`.
    pub verb: &'static str,
    /// Of one thing it is said of all the others: "the bin is near every desk".
    pub all: bool,
    /// Of each it is said of some one of the others: "each table is near a pillar".
    pub any: bool,
}

impl Named<'_> {
    /// A formula for each element of the one with its partner.
    pub(super) fn matched(&self, said: &Said, f: &dyn Fn(&str, &str) -> String) -> String {
        match said {
            Said { all: true, .. } => self.every(said.a, said.b, f),
            Said { any: true, .. } => self.some(said.a, said.b, f),
            _ => self.pairs(said.a, said.b, f),
        }
    }

    /// On, in, and under a thing.
    pub(super) fn carried_rel(&self, said: &Said, out: &mut Vec<String>) {
        let Said { a, rel, b, verb, .. } = *said;
        let (ga, gb, m) = (self.group(a), self.group(b), self.counts[b]);
        let call = |p: &'static str| move |x: &str, y: &str| format!("{p}({x}, {y})");
        let far = |d: f64| move |x: &str, y: &str| format!("near({x}, {y}, {})", number(d));
        let pairs = |f: &dyn Fn(&str, &str) -> String| self.matched(said, f);
        match rel {
            Rel::On => {
                // A shelf on a wall has a top.
                let shelf = self.brief.things[b].words.last().is_some_and(|w| w == "shelf" || w == "ledge");
                if matches!(gb, Group::Wall | Group::Door | Group::Window) && !shelf {
                    // On a door, on a window: as near as it can be.
                    out.push(format!("{verb} {};", pairs(&far(0.3))));
                } else if self.counts[a] > 1 && m == 1 && self.said(a, |w| *w == FactKind::Pattern(Pattern::Stacked)) {
                    // Of a stack only the lowest is there.
                    let lowest = call(self.carried(a, b))(&format!("{}[0]", self.name(a)), self.name(b));
                    out.push(format!("{verb} {lowest};"));
                } else {
                    out.push(format!("{verb} {};", pairs(&call(self.carried(a, b)))));
                }
            }
            Rel::In => {
                let fits = (0..3).all(|i| self.sizes[a][i] < self.sizes[b][i] - 0.01)
                    && !matches!(gb, Group::Seat | Group::Flat | Group::Table);
                if fits {
                    out.push(format!("{verb} {};", pairs(&call("inside"))));
                    out.push(format!("allowCollide({}, {});", self.name(a), self.name(b)));
                    out.push(format!("allowFloat({});", self.name(a)));
                } else {
                    out.push(format!("{verb} {};", pairs(&call(self.carried(a, b)))));
                }
            }
            Rel::Under
                if matches!(gb, Group::Wall | Group::Window | Group::Screen | Group::Ceiling) || self.hangs(b) =>
            {
                if gb == Group::Window {
                    // The window is over it, in the wall that it stands at: a bed reaches far into the room from there.
                    out.push(format!("{verb} {};", pairs(&|x, y| format!("above({y}, {x})"))));
                    out.push(format!("{verb} {};", pairs(&far(NEAR))));
                } else {
                    out.push(format!("{verb} {};", pairs(&call("below"))));
                }
                if matches!(gb, Group::Wall | Group::Screen | Group::Ceiling) && self.counts[a] == 1 && m == 1 {
                    out.push(format!("{verb} {};", pairs(&|x, y| format!("over({y}, {x})"))));
                }
            }
            Rel::Under => {
                out.push(format!("{verb} {};", pairs(&call("under"))));
                if ga == Group::Flat && self.counts[a] == 1 && m == 1 {
                    // A rug lies under the whole of a table, or under its middle.
                    out.push(format!("{verb} {};", pairs(&|x, y| format!("over({y}, {x})"))));
                }
                out.push(format!("allowCollide({}, {});", self.name(a), self.name(b)));
            }
            _ => {}
        }
    }

    /// Beside a thing, at both sides or at one.
    pub(super) fn beside_rel(&self, said: &Said, out: &mut Vec<String>) {
        let Said { a, rel, b, verb, .. } = *said;
        let (ga, m) = (self.group(a), self.counts[b]);
        let call = |p: &'static str| move |x: &str, y: &str| format!("{p}({x}, {y})");
        let far = |d: f64| move |x: &str, y: &str| format!("near({x}, {y}, {})", number(d));
        let pairs = |f: &dyn Fn(&str, &str) -> String| self.matched(said, f);
        match rel {
            Rel::Beside | Rel::Sides if ga == Group::Drape => out.push(format!("{verb} {};", pairs(&far(0.3)))),
            Rel::Beside | Rel::Sides => {
                let both = if rel == Rel::Sides { self.both_sides(a, b) } else { None };
                if let Some(text) = both {
                    out.push(format!("{verb} {text};"));
                } else if self.counts[a] > 2 && m == 1 {
                    // Three things have no room at two sides.
                    out.push(format!("{verb} {};", pairs(&far(self.reach(a, b)))));
                } else {
                    out.push(format!("{verb} {};", pairs(&call("beside"))));
                }
            }
            _ => {}
        }
    }

    /// In front of a thing, or behind it.
    pub(super) fn in_front_rel(&self, said: &Said, out: &mut Vec<String>) {
        let Said { a, rel, b, verb, .. } = *said;
        let (ga, gb) = (self.group(a), self.group(b));
        let call = |p: &'static str| move |x: &str, y: &str| format!("{p}({x}, {y})");
        let far = |d: f64| move |x: &str, y: &str| format!("near({x}, {y}, {})", number(d));
        let pairs = |f: &dyn Fn(&str, &str) -> String| self.matched(said, f);
        match rel {
            Rel::InFrontOf | Rel::Behind => {
                out.push(format!("{verb} {};", pairs(&call(predicate(rel)))));
                if matches!(gb, Group::Door | Group::Window) && !self.said(a, |w| matches!(w, FactKind::Gap(..))) {
                    // All of a room lies before a window; what stands in front of it is close.
                    out.push(format!("{verb} {};", pairs(&far(BEFORE))));
                }
                let low = self.sizes[a][1] < LOW && matches!(ga, Group::Seat | Group::Storage | Group::Table);
                if rel == Rel::InFrontOf && gb == Group::Bed && low {
                    // A chest before a bed stands at its foot.
                    out.push(format!("{verb} {};", pairs(&far(AT_FOOT))));
                }
                if ga == Group::Seat && matches!(gb, Group::Table) {
                    // Rows of chairs before a lectern are not drawn up to it.
                    let away = self.said(a, |w| matches!(w, FactKind::Gap(..))) || !sizes::seats(self.brief, b);
                    let d = if away { None } else { Some(DRAWN_UP) };
                    if let Some(d) = d {
                        out.push(format!("{verb} {};", pairs(&far(d))));
                    }
                    out.push(format!("{verb} {};", pairs(&call("looksAt"))));
                } else if rel == Rel::InFrontOf && self.one_each(a, b) {
                    // What stands before a seat or a bed is what one looks at from there.
                    let front = matches!(ga, Group::Table | Group::Storage | Group::Screen | Group::Seat);
                    if front && matches!(gb, Group::Seat | Group::Bed) {
                        out.push(format!(
                            "prefer {};",
                            pairs(&|x, y| format!("looksAt({y}, {x}) and looksAt({x}, {y})"))
                        ));
                    }
                }
            }
            _ => {}
        }
    }

    /// Turned to a thing, or across from it.
    pub(super) fn facing_rel(&self, said: &Said, out: &mut Vec<String>) {
        let Said { a, rel, b, verb, .. } = *said;
        let (ga, gb) = (self.group(a), self.group(b));
        let call = |p: &'static str| move |x: &str, y: &str| format!("{p}({x}, {y})");
        let far = |d: f64| move |x: &str, y: &str| format!("near({x}, {y}, {})", number(d));
        let pairs = |f: &dyn Fn(&str, &str) -> String| self.matched(said, f);
        match rel {
            // Who sits at desks that face the board looks at it across the desk.
            Rel::Facing if self.desks_before(a, b) => {
                out.push(format!("{verb} {};", pairs(&call("sameWay"))));
            }
            Rel::Facing if self.grid(a).is_some() => {
                let (of, to) = (self.name(a), self.elements(b));
                let to = to.first().map_or("", String::as_str);
                out.push(format!("{verb} exists a in {of}: facing(a, {to});"));
                out.push(format!("{verb} forall a in {of}: dot({to}.center - a.center, a.front) >= 0;"));
                let n = self.counts[a];
                out.push(format!("{verb} forall i in 1..{n}: {of}[i].rot = {of}[0].rot;"));
                // What is looked at is before the middle of the rows.
                out.push(format!(
                    "prefer abs(dot({to}.center - ({of}[0].center + {of}[{}].center) * 0.5, {of}[0].right)) <= 0.3;",
                    n - 1
                ));
            }
            // Across from each other, but not each has one of the others straight before it.
            Rel::Opposite if self.array(a) && self.array(b) => {
                let (of, to) = (self.name(a), self.name(b));
                out.push(format!("{verb} exists a in {of}: exists b in {to}: facing(a, b);"));
                out.push(format!("{verb} forall a in {of}: forall b in {to}: dot(b.center - a.center, a.front) >= 0;"));
            }
            // Who sits at a desk that faces the window looks out of it, across the desk.
            Rel::Facing if gb == Group::Window && self.counts[a] == 1 && self.counts[b] == 1 && self.sat_at(a) => {
                out.push(format!("{verb} {};", pairs(&far(AT_WINDOW))));
                out.push(format!("{verb} {};", pairs(&|x, y| format!("behind({y}, {x})"))));
            }
            // Who runs on treadmills that face the windows looks out of them.
            Rel::Facing if gb == Group::Window && self.brief.things[a].head() == "treadmill" => {
                let (of, to) = (self.name(a), self.elements(b));
                let to = to.first().map_or("", String::as_str);
                out.push(format!(
                    "{verb} forall a in {of}: abs(dot(a.front, {to}.front)) >= 0.99 and dot({to}.center - a.center, a.front) <= 0;"
                ));
            }
            // Or at what hangs there.
            Rel::Facing if self.brief.things[a].head() == "treadmill" => {
                let (x, y) = (self.name(a), self.elements(b));
                let y = y.first().map_or("", String::as_str);
                let of = if self.counts[a] > 1 { format!("forall a in {x}: ") } else { String::new() };
                let a = if self.counts[a] > 1 { "a" } else { x };
                out.push(format!("{verb} {of}angle({a}.center - {y}.center, {a}.front) <= 20;"));
            }
            // Who sits at a desk that faces the door sees who comes in.
            Rel::Facing if gb == Group::Door && self.counts[a] == 1 && self.counts[b] == 1 && self.sat_at(a) => {
                out.push(format!("{verb} {};", pairs(&|x, y| format!("behind({y}, {x})"))));
            }
            Rel::Facing => {
                out.push(format!("{verb} {};", pairs(&call("looksAt"))));
                // A screen is seen from its front; of the rest, what faces something is mostly before its front.
                let back = match gb {
                    _ if !self.one_each(a, b) => false,
                    Group::Screen | Group::Seat | Group::Storage | Group::Bed | Group::Wall => true,
                    _ => false,
                };
                if back {
                    out.push(format!("prefer {};", pairs(&|x, y| format!("looksAt({y}, {x})"))));
                }
            }
            Rel::Opposite => {
                let front = !self.brief.things[b].opening();
                let f = |x: &str, y: &str| {
                    if front {
                        format!("looksAt({x}, {y}) and inFrontOf({x}, {y})")
                    } else {
                        format!("looksAt({x}, {y})")
                    }
                };
                out.push(format!("{verb} {};", pairs(&f)));
                if !(ga == Group::Seat && gb == Group::Seat) && ga != Group::Top && gb != Group::Top {
                    // In a small room nothing is far from anything.
                    let room = self.room_sizes.get(self.brief.things[a].room).copied().unwrap_or([6.0; 3]);
                    let side = room[0].min(room[2]);
                    let left = side - self.sizes[a][2] - self.sizes[b][2] - LOOSE;
                    let across = (SMALL_ROOM * side).min(left.max(PASSAGE)).min(ACROSS);
                    let across = (across * 20.0).floor() / 20.0;
                    out.push(format!("{verb} {};", pairs(&|x, y| format!("far({x}, {y}, {})", number(across)))));
                }
            }
            _ => {}
        }
    }

    /// Whether these are desks of a class or a team, and the other is the board or the screen on a wall that all look at.
    pub fn desks_before(&self, desks: usize, board: usize) -> bool {
        let is_board = matches!(self.group(board), Group::Wall | Group::Screen) && self.counts[board] == 1;
        let is_carried = |what: &FactKind| matches!(what, FactKind::Rel(Rel::On, _));
        self.counts[desks] > 1 && self.sat_at(desks) && is_board && !self.said(board, is_carried)
    }

    /// Whether it is a desk at whose front its user sits.
    fn sat_at(&self, item: usize) -> bool {
        const OTHER: [&str; 3] = ["reception", "front", "information"];
        // "A chair behind each desk": at its back.
        let is_seat = |of: &usize| self.brief.things[*of].group == Group::Seat;
        let behind = self.brief.facts.iter().any(|fact| {
            matches!(&fact.what, FactKind::Rel(Rel::Behind, to) if to.contains(&item)) && fact.of.iter().any(is_seat)
        });
        if behind {
            return false;
        }
        let words = &self.brief.things[item].words;
        self.brief.things[item].part.is_none()
            && words.last().is_some_and(|w| w == "desk")
            && !words.iter().any(|w| OTHER.contains(&w.as_str()))
    }

    /// Whether something hangs on a wall that is said to be above what stands in the middle of the room: not both can be.
    fn far_from_wall(&self, a: usize, b: usize) -> bool {
        let on_wall = |w: &FactKind| matches!(w, FactKind::Place(rel, Place::Wall, _) if *rel != Rel::Near);
        let middle = |w: &FactKind| matches!(w, FactKind::Place(rel, Place::Middle, _) if *rel != Rel::Near);
        self.said(a, on_wall) && self.said(b, middle)
    }

    /// Left, right and above; parallel and aligned.
    pub(super) fn ordered_rel(&self, said: &Said, out: &mut Vec<String>) {
        let Said { a, rel, b, verb, .. } = *said;
        let verb = if rel == Rel::Above && self.far_from_wall(a, b) { "prefer" } else { verb };
        let (ga, gb, m) = (self.group(a), self.group(b), self.counts[b]);
        let call = |p: &'static str| move |x: &str, y: &str| format!("{p}({x}, {y})");
        let pairs = |f: &dyn Fn(&str, &str) -> String| self.matched(said, f);
        match rel {
            Rel::LeftOf | Rel::RightOf | Rel::Above | Rel::Parallel | Rel::Aligned => {
                out.push(format!("{verb} {};", pairs(&call(predicate(rel)))));
                if matches!(rel, Rel::LeftOf | Rel::RightOf)
                    && ga == Group::Top
                    && matches!(gb, Group::Top | Group::Screen)
                {
                    // Left and right on a desk are those of who sits there: its things look one way.
                    out.push(format!("{verb} {};", pairs(&|x, y| format!("angle({x}.front, {y}.front) <= 5"))));
                }
                let lights = ga == Group::Ceiling
                    || matches!(self.brief.things[a].head().as_str(), "lamp" | "light" | "chandelier");
                if rel == Rel::Above && lights && gb == Group::Table && self.counts[a] == 1 && m == 1 {
                    let middle = |x: &str, y: &str| {
                        format!("length(vec3({x}.center.x - {y}.center.x, 0, {x}.center.z - {y}.center.z)) <= 0.05")
                    };
                    out.push(format!("prefer {};", pairs(&middle)));
                }
                let wide = self.sizes[a][0] * self.counts[a].div_ceil(m.max(1)) as f64;
                if rel == Rel::Above
                    && !matches!(gb, Group::Door | Group::Window)
                    && wide <= self.sizes[b][0].max(self.sizes[a][0])
                {
                    out.push(format!("{verb} {};", pairs(&call("over"))));
                } else if rel == Rel::Above && !matches!(gb, Group::Door | Group::Window) {
                    // Several share the width: the middle of each is above it.
                    out.push(format!(
                        "{verb} {};",
                        pairs(&|x, y| format!("abs(dot({x}.center - {y}.center, {y}.right)) <= {y}.size.x / 2"))
                    ));
                }
            }
            _ => {}
        }
    }
}
