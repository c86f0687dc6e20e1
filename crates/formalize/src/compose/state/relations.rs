//! One thing and another: on, beside, in front of, around, between.

use super::said::Said;
use super::{LISTED, Named, indexed};
use crate::brief::{Fact, FactKind, Group, Pattern, Place, Quantifier, Rel};
use crate::sizes::SILL;
use crate::write::number;

/// How far "near" reaches, in metres.
pub(super) const NEAR: f64 = 1.0;
/// How far away what stands in front of a door or a window is at most, in metres: there is room to open it.
pub(super) const BEFORE: f64 = 1.4;
/// How far the seats around a fire are from it at most (metres).
const BY_FIRE: f64 = 3.2;
/// So many of several things stand along one window.
const ABREAST: usize = 2;
/// How far a seat is from its table.
pub(super) const DRAWN_UP: f64 = 0.4;
/// The same of a table that is lower than a seat, before which there are legs, and how low that is.
const BEFORE_LEGS: f64 = 0.6;
const LOW: f64 = 0.5;
/// How far apart things are that stand across from each other, at least.
pub(in crate::compose) const ACROSS: f64 = 1.5;
/// How far "around" reaches, for what is no seat.
pub(super) const AROUND: f64 = 1.2;
/// What is as wide and as deep and is around something encloses it (metres).
const ENCLOSING: f64 = 1.5;

impl Named<'_> {
    pub(super) fn rel(&self, fact: &Fact, a: usize, rel: Rel, b: usize, out: &mut Vec<String>) {
        let (verb, denied) = (if fact.soft { "prefer" } else { "assert" }, fact.not);
        let (ga, gb) = (self.group(a), self.group(b));
        let call = |p: &'static str| move |x: &str, y: &str| format!("{p}({x}, {y})");
        let far = |d: f64| move |x: &str, y: &str| format!("near({x}, {y}, {})", number(d));
        // "the bin is near every desk": of one thing it is said of all the others.
        let all = fact.object == Quantifier::Each
            && self.array(b)
            && (self.counts[a] == 1 || fact.subject == Quantifier::Each && matches!(rel, Rel::Near | Rel::Visible));
        let said = Said { a, rel, b, verb, all, any: fact.object == Quantifier::Any };
        let pairs = |f: &dyn Fn(&str, &str) -> String| self.matched(&said, f);
        if denied {
            let p = predicate(rel);
            let f = |x: &str, y: &str| match p {
                "near" => format!("not near({x}, {y}, {})", number(NEAR)),
                p => format!("not {p}({x}, {y})"),
            };
            out.push(format!("{verb} {};", self.every(a, b, &f)));
            return;
        }
        let seat_at = ga == Group::Seat && matches!(gb, Group::Table);
        match rel {
            Rel::At if !seat_at => {
                let d = if ga == Group::Seat { DRAWN_UP } else { self.reach(a, b) };
                out.push(format!("{verb} {};", pairs(&far(d))));
            }
            Rel::Around | Rel::At => self.around(a, b, verb, out),
            Rel::In if matches!(gb, Group::Door | Group::Window) => out.push(format!("{verb} {};", pairs(&far(NEAR)))),
            Rel::On => self.carried_rel(&said, out),
            Rel::OnLeft | Rel::OnRight => {
                let sign = if rel == Rel::OnLeft { ">=" } else { "<=" };
                out.push(format!(
                    "{verb} {};",
                    pairs(&|x, y| format!("dot({x}.center - {y}.center, {y}.right) {sign} 0"))
                ));
            }
            Rel::Centre => {
                // Several share the middle.
                let reach = if self.counts[a] > self.counts[b] { 0.3 } else { 0.05 };
                out.push(format!(
                    "{verb} {};",
                    pairs(&|x, y| {
                        format!("length(vec3({x}.center.x - {y}.center.x, 0, {x}.center.z - {y}.center.z)) <= {reach}")
                    })
                ));
            }
            Rel::LongSide | Rel::ShortSide => self.at_side(a, b, rel == Rel::LongSide, verb, out),
            Rel::In | Rel::Under => self.carried_rel(&said, out),
            // What stands on the floor and is tall is above nothing: it is by it on the plan.
            Rel::Above if self.tall(a) => out.push(format!("{verb} {};", pairs(&far(NEAR)))),
            Rel::SameWall => self.at_wall_of(&said, out),
            // The mirror image of the other in it is outside the room.
            Rel::WallBeyond => {
                let (room, near) = (self.room(a), number(NEAR));
                out.push(format!(
                    "{verb} {};",
                    pairs(&|x, y| format!(
                        "near({x}, {y}, {near}) and gap({x}.center + {x}.center - {y}.center, {room}) <= 0"
                    ))
                ));
            }
            Rel::BackTo => out.push(format!("{verb} {};", pairs(&|x, y| format!("behind({y}, {x})")))),
            Rel::Beside | Rel::Sides => self.beside_rel(&said, out),
            Rel::InFrontOf | Rel::Behind => self.in_front_rel(&said, out),
            Rel::Near => out.push(format!("{verb} {};", pairs(&far(self.reach(a, b))))),
            Rel::Against | Rel::Along => {
                let off = match rel {
                    Rel::Against => 0.1,
                    // Many tables along a window are longer than that.
                    _ if gb == Group::Window && self.counts[a] > ABREAST => self.reach(a, b),
                    _ => 0.5,
                };
                // A window begins above a desk that stands against it.
                let up = if gb == Group::Window { (SILL - self.sizes[a][1]).max(0.0) } else { 0.0 };
                out.push(format!("{verb} {};", pairs(&far(((off + up) * 20.0).ceil() / 20.0))));
            }
            Rel::Facing | Rel::Opposite => self.facing_rel(&said, out),
            Rel::Far => {
                let room = self.room_sizes.get(self.brief.things[a].room).copied().unwrap_or([6.0; 3]);
                let d = (room[0].min(room[2]) / 3.0).clamp(0.5, 2.0);
                out.push(format!(
                    "{verb} {};",
                    self.every(a, b, &|x, y| format!("far({x}, {y}, {})", number((d * 10.0).floor() / 10.0)))
                ));
            }
            Rel::Perpendicular => {
                out.push(format!("{verb} {};", pairs(&|x, y| format!("abs(dot({x}.front, {y}.front)) <= 0.1"))))
            }
            Rel::Visible => out.push(format!("{verb} {};", self.every(a, b, &call("visible")))),
            Rel::Reachable => {
                out.push(format!("{verb} {};", self.every(a, b, &|x, y| format!("reachable({x}, {y}, 0.8)"))))
            }
            Rel::Mounted | Rel::Hang => {
                out.push(format!("{verb} {};", pairs(&far(0.1))));
                out.push(format!("allowFloat({});", self.name(a)));
            }
            Rel::LeftOf | Rel::RightOf | Rel::Above | Rel::Parallel | Rel::Aligned => self.ordered_rel(&said, out),
            Rel::Between | Rel::From | Rel::Of | Rel::To | Rel::Than => {}
        }
    }

    /// At the wall at which another thing is. A door or window may look to either side of its wall.
    fn at_wall_of(&self, said: &Said, out: &mut Vec<String>) {
        let Said { a, b, verb, .. } = *said;
        let hangs = matches!(self.group(a), Group::Wall | Group::Screen | Group::Drape);
        let (room, at) = (self.room(a), if hangs { "wallMounted" } else { "againstWall" });
        if !self.brief.things[a].opening() {
            out.push(format!("{verb} {};", self.all(a, |x| format!("{at}({x}, {room})"))));
        }
        let is_hole = self.brief.things[a].opening() || self.brief.things[b].opening();
        let same = |x: &str, y: &str| match is_hole {
            true => {
                format!("abs(dot({x}.front, {y}.front)) >= 0.9 and abs(dot({x}.center - {y}.center, {y}.front)) <= 1")
            }
            false => format!("dot({x}.front, {y}.front) >= 0.9"),
        };
        out.push(format!("{verb} {};", self.matched(said, &same)));
    }

    /// Twice as many of one as of the other: one at each side.
    pub fn both_sides(&self, a: usize, b: usize) -> Option<String> {
        let m = self.counts[b];
        let own = self.elements(a);
        if own.len().max(self.counts[a]) != 2 * m || !self.array(a) && own.len() != 2 || a == b {
            return None;
        }
        let side = |x: &str, i: usize, y: &str| {
            format!("beside({x}, {y}) and {}({x}, {y})", if i == 0 { "seenLeftOf" } else { "seenRightOf" })
        };
        let of = self.name(a);
        Some(if m == 1 {
            let each: Vec<String> = (0..2).map(|i| side(&own[i], i, self.name(b))).collect();
            each.join(" and ")
        } else {
            let to = format!("{}[i]", self.name(b));
            let each: Vec<String> = (0..2).map(|j| side(&indexed(of, 2, j), j, &to)).collect();
            format!("forall i in 0..{m}: {}", each.join(" and "))
        })
    }

    /// Whether a thing stands on the floor and is as high as people.
    pub fn tall(&self, item: usize) -> bool {
        let up =
            self.said(item, |w| matches!(w, FactKind::Place(Rel::Mounted | Rel::Hang, _, _) | FactKind::Height(..)));
        let words = &self.brief.things[item].words;
        let stands = words.iter().any(|w| matches!(w.as_str(), "floor" | "standing" | "tripod" | "arc"));
        let lamp = !stands && words.last().is_some_and(|w| w == "lamp" || w == "light");
        let [w, h, d] = self.sizes[item];
        !lamp
            && matches!(self.group(item), Group::Floor | Group::Storage | Group::Bed | Group::Table | Group::Seat)
            && !up
            && h >= 1.2
            && (stands || w * d >= 0.15)
    }

    /// How far "near" reaches: a metre, and as far as a group of so many extends.
    pub(super) fn reach(&self, a: usize, b: usize) -> f64 {
        let (n, m) = (self.counts[a], self.counts[b].max(1));
        let each = if self.array(b) { n.div_ceil(m) } else { n };
        let [w, _, d] = self.sizes[a];
        let at_wall = self.said(a, |s| matches!(s, FactKind::Place(_, Place::Wall, _)));
        let extent = match each {
            0..=2 => 0.0,
            // Along a wall to both sides; else in a half circle.
            n if at_wall => n as f64 * (w + 0.1) / 2.0,
            n => (n as f64 * (w + 0.3) * (d + 0.6)).sqrt(),
        };
        (NEAR.max(extent) * 10.0).ceil() / 10.0
    }

    /// Whether a thing hangs: nothing can be under it in the sense of "pushed under".
    pub(super) fn hangs(&self, item: usize) -> bool {
        self.said(item, |w| {
            matches!(w, FactKind::Place(_, Place::Wall, _))
                && !matches!(self.group(item), Group::Table | Group::Bed | Group::Seat)
        }) && self.brief.facts.iter().any(|f| {
            !f.not
                && f.of.contains(&item)
                && matches!(f.what, FactKind::Place(Rel::Mounted | Rel::On | Rel::Hang, Place::Wall, _))
        })
    }

    /// How far from something the seats around it are.
    pub(super) fn seat_gap(&self, table: usize) -> f64 {
        if self.sizes[table][1] < LOW { BEFORE_LEGS } else { DRAWN_UP }
    }

    /// Things around one, or around each of several.
    fn around(&self, a: usize, b: usize, verb: &str, out: &mut Vec<String>) {
        let (n, m) = (self.counts[a], self.counts[b]);
        let (of, to) = (self.name(a), self.name(b));
        let seat = self.group(a) == Group::Seat;
        let gap = self.brief.facts.iter().find_map(|f| match &f.what {
            FactKind::Gap(_, v, t) if f.of.contains(&a) && t.contains(&b) => Some(*v),
            _ => None,
        });
        let d = gap.map_or(if seat { self.seat_gap(b) } else { AROUND }, |v| v + 0.3).max(self.ring(a, b));
        // The sides of a fence are as far from what is in it as it is large.
        let [w, _, depth] = self.sizes[a];
        let d = if n == 1 && w.min(depth) > ENCLOSING { d.max(w.max(depth) / 2.0) } else { d };
        if seat && m == 1 && n > 1 && self.array(a) && self.brief.things[b].name().ends_with("fireplace") {
            // It is at a wall: one of the seats is before it, the others are on both sides.
            out.push(format!("{verb} forall a in {of}: near(a, {to}, {});", number(BY_FIRE)));
            if n > 2 {
                out.push(format!("{verb} exists a in {of}: looksAt(a, {to});"));
            }
            return;
        }
        let words = &self.brief.things[b].words;
        let is_bar = words.last().is_some_and(|word| word == "bar" || word == "counter") && words[0] != "kitchen";
        if m == 1 && n > 1 && self.array(a) && !(seat && is_bar) {
            out.push(format!("{verb} around({of}, {to}, {});", number(d)));
        } else if self.array(a) && self.array(b) && n % m == 0 && n > m && n / m <= 8 {
            // Each table has its own: at its four sides in turn.
            let k = n / m;
            let sides: &[&str] = match k {
                2 => &["leftOf", "rightOf"],
                3 => &["leftOf", "rightOf", "inFrontOf"],
                4 => &["leftOf", "rightOf", "inFrontOf", "behind"],
                _ => &["inFrontOf", "behind", "inFrontOf", "behind", "leftOf", "rightOf", "inFrontOf", "behind"],
            };
            let each: Vec<String> = (0..k).map(|j| format!("{}({}, {to}[i])", sides[j], indexed(of, k, j))).collect();
            // Where rows give each its place, these are the sides.
            if self.drawn_up(a).is_none() {
                out.push(format!("prefer forall i in 0..{m}: {};", each.join(" and ")));
            }
            out.push(format!("{verb} {};", self.pairs(a, b, &|x, y| format!("near({x}, {y}, {})", number(d)))));
        } else {
            out.push(format!("{verb} {};", self.pairs(a, b, &|x, y| format!("near({x}, {y}, {})", number(d)))));
        }
        if seat {
            out.push(format!(
                "{} {};",
                if m > 1 { "prefer" } else { verb },
                self.pairs(a, b, &|x, y| format!("looksAt({x}, {y})"))
            ));
        }
        if seat && m == 1 && self.array(a) && is_bar {
            // Who serves is on the other side.
            out.push(format!("prefer forall a in {of}: inFrontOf(a, {to});"));
        } else if seat && m == 1 && self.array(a) && (3..=LISTED).contains(&n) {
            // Spread evenly, where nothing stands in the way.
            const SIDES: [&str; 6] = ["inFrontOf", "behind", "leftOf", "rightOf", "inFrontOf", "behind"];
            let each: Vec<String> = (0..n).map(|i| format!("{}({of}[{i}], {to})", SIDES[i % SIDES.len()])).collect();
            out.push(format!("prefer {};", each.join(" and ")));
        }
    }

    /// How a thing is on another: wholly, but for furniture that a rug is too small for.
    pub(super) fn carried(&self, a: usize, b: usize) -> &'static str {
        let ([w, _, d], [bw, _, bd]) = (self.sizes[a], self.sizes[b]);
        let fits = w.max(d) <= bw.max(bd) && w.min(d) <= bw.min(bd);
        if self.group(b) == Group::Flat && (!fits || self.counts[a] > 2) { "on" } else { "restsOn" }
    }

    /// Whether it is to be looked at from a seat.
    pub fn screen(&self, item: usize) -> bool {
        let item = &self.brief.things[item];
        item.group == Group::Screen || item.group == Group::Wall && item.words.last().is_some_and(|w| w == "screen")
    }

    /// Whether there is one of each, or as many of the one as of the other.
    pub(super) fn one_each(&self, a: usize, b: usize) -> bool {
        (self.counts[a] == 1 || self.counts[b] == 1 || self.counts[a] == self.counts[b]) && self.grid(a).is_none()
    }

    /// At the long or the short sides of a thing: beyond them, between their ends, and turned to it.
    fn at_side(&self, a: usize, b: usize, long: bool, verb: &str, out: &mut Vec<String>) {
        let [w, _, d] = self.sizes[b];
        let (sides, along, length) = if long == (w >= d) {
            (["inFrontOf", "behind"], "right", "x")
        } else {
            (["leftOf", "rightOf"], "front", "z")
        };
        let half = self.sizes[a][0] / 2.0;
        let between = |x: &str, y: &str| {
            format!(
                "({}({x}, {y}) or {}({x}, {y})) and abs(dot({x}.center - {y}.center, {y}.{along})) <= max(0.1, {y}.size.{length} / 2 - {})",
                sides[0],
                sides[1],
                number(half)
            )
        };
        out.push(format!("{verb} {};", self.pairs(a, b, &between)));
        let reach = if self.group(a) == Group::Seat { DRAWN_UP } else { 0.5 };
        out.push(format!("{verb} {};", self.pairs(a, b, &|x, y| format!("near({x}, {y}, {})", number(reach)))));
        if self.group(a) == Group::Seat {
            out.push(format!("{verb} {};", self.pairs(a, b, &|x, y| format!("looksAt({x}, {y})"))));
        }
    }

    /// How far from a thing so many stand around it, where there is not room for all at its sides.
    pub(super) fn ring(&self, a: usize, b: usize) -> f64 {
        let n = (self.counts[a].div_ceil(self.counts[b].max(1))) as f64;
        let ([w, _, d], [bw, _, bd]) = (self.sizes[a], self.sizes[b]);
        let circle = self.said(a, |s| matches!(s, FactKind::Pattern(Pattern::Circle)));
        let round = n * (w.max(d) + 0.25);
        let open = if circle { round / std::f64::consts::TAU - bw.min(bd) / 2.0 + 0.5 } else { 0.0 };
        let over = (n * (w + 0.15) - 2.0 * (bw + bd)).max(0.0) / std::f64::consts::TAU;
        let far = open.max(if over > 0.0 { over + 0.5 } else { 0.0 });
        (far * 10.0).ceil() / 10.0
    }

    pub(super) fn between(&self, a: usize, to: &[usize]) -> Option<String> {
        let f = |x: &str, y: &str, z: &str| format!("between({x}, {y}, {z})");
        match to {
            [b] if self.counts[*b] > 1 => {
                let e = self.elements(*b);
                if self.array(a) && self.array(*b) {
                    let n = self.counts[a].min(self.counts[*b] - 1);
                    let (of, to) = (self.name(a), self.name(*b));
                    return Some(format!("forall i in 0..{n}: between({of}[i], {to}[i], {to}[i + 1])"));
                }
                Some(self.all(a, |x| f(x, &e[0], &e[1])))
            }
            [b, c, ..] => {
                let (b, c) = (self.elements(*b), self.elements(*c));
                Some(self.all(a, |x| f(x, &b[0], &c[0])))
            }
            _ => None,
        }
    }
}

/// The predicate of the standard library.
pub(super) fn predicate(rel: Rel) -> &'static str {
    match rel {
        Rel::On => "on",
        Rel::Under => "under",
        Rel::Above => "above",
        Rel::Beside | Rel::Sides => "beside",
        // As people see it who look at the thing.
        Rel::LeftOf => "seenLeftOf",
        Rel::RightOf => "seenRightOf",
        Rel::InFrontOf => "inFrontOf",
        Rel::Behind => "behind",
        Rel::Facing | Rel::Opposite => "facing",
        Rel::Parallel => "parallel",
        Rel::Aligned => "aligned",
        Rel::Visible => "visible",
        _ => "near",
    }
}
