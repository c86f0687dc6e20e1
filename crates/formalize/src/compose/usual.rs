//! What nobody says because everybody knows it: pictures hang on walls, lamps under the ceiling, a cup stands on a table;
//! a rug may lie under anything.

use super::state::{Named, Stated};
use crate::brief::{Fact, FactKind, Group, Pattern, Place, Rel, Thing};
use crate::write::number;

/// What is said to be behind something is so near to it, where there is room (metres).
const BEHIND: f64 = 1.5;

/// Adds it.
pub fn usual(named: &Named, out: &mut Stated) {
    let whole = |a: &usize| named.brief.things[*a].part.is_none();
    for a in (0..named.brief.things.len()).filter(whole) {
        let it = It::new(named, a);
        it.hangs_or_stands(out);
        it.with_others(out);
        it.over_something(out);
        it.on_floor(out);
        it.in_order(out);
        it.screen(out);
        it.at_eye_level(out);
        it.under_others(out);
        it.along_walls(out);
        it.square(out);
        it.side_by_side(out);
    }
}

/// A thing, and what is said of it.
struct It<'n, 'b> {
    named: &'n Named<'b>,
    a: usize,
    item: &'n Thing,
    /// Something carries it.
    held: bool,
    /// It has a place at a wall, in a corner, in the middle or under the ceiling.
    placed: bool,
    high: bool,
    on_wall: bool,
    above: bool,
    /// A distance or a height is given.
    measured: bool,
    /// A small thing that is said to be beside what carries nothing: it stands on the floor.
    apart: bool,
    lamp: bool,
}

impl<'n, 'b> It<'n, 'b> {
    fn new(named: &'n Named<'b>, a: usize) -> Self {
        let item = &named.brief.things[a];
        let carries = |t: &usize| {
            matches!(named.brief.things[*t].group, Group::Top | Group::Screen) || carrier(named, *t).is_some()
        };
        let beside = |w: &FactKind| match w {
            FactKind::Rel(Rel::LeftOf | Rel::RightOf | Rel::Beside | Rel::Sides | Rel::InFrontOf | Rel::Behind, to) => {
                !to.iter().all(carries)
            }
            _ => false,
        };
        let held =
            |w: &FactKind| matches!(w, FactKind::Rel(Rel::On | Rel::In | Rel::Under | Rel::Mounted | Rel::Hang, _));
        let placed = |w: &FactKind| {
            matches!(w, FactKind::Place(_, Place::Wall | Place::Ceiling | Place::Corner | Place::Middle, _))
        };
        Self {
            named,
            a,
            item,
            held: named.said(a, held),
            placed: named.said(a, placed),
            high: named.said(a, |w| matches!(w, FactKind::Height(..))),
            on_wall: named.said(a, |w| matches!(w, FactKind::Place(_, Place::Wall, _))),
            above: named.said(a, |w| matches!(w, FactKind::Rel(Rel::Above, _))),
            measured: named.said(a, |w| matches!(w, FactKind::Gap(..) | FactKind::Height(..))),
            apart: item.group == Group::Top && named.said(a, beside),
            lamp: item.words.last().is_some_and(|w| w == "lamp" || w == "light"),
        }
    }

    fn said(&self, what: impl Fn(&FactKind) -> bool) -> bool {
        self.named.said(self.a, what)
    }

    /// That a predicate holds of it and its room.
    fn mounted(&self, predicate: &str) -> String {
        let room = self.named.room(self.a);
        format!("assert {};", self.named.all(self.a, |x| format!("{predicate}({x}, {room})")))
    }

    /// That it may be where nothing carries it.
    fn floating(&self) -> String {
        format!("allowFloat({});", self.named.name(self.a))
    }

    /// On a wall, from the ceiling, on something with a top.
    fn hangs_or_stands(&self, out: &mut Stated) {
        let name = self.item.name();
        match self.item.group {
            Group::Wall | Group::Drape
                if !self.held
                    && !self.on_wall
                    && !self.said(|w| matches!(w, FactKind::Place(_, Place::Ceiling, _))) =>
            {
                out.infer(self.mounted("wallMounted"), &format!("a {name} hangs on a wall"));
            }
            Group::Screen if !self.held && !self.on_wall => {
                out.infer(
                    self.mounted("wallMounted"),
                    &format!("a {name} that does not stand on anything hangs on a wall"),
                );
            }
            Group::Ceiling if self.hangs() => {
                out.infer(self.mounted("ceilingMounted"), &format!("a {name} hangs from the ceiling"));
            }
            Group::Ceiling if self.above && self.measured && !self.placed => {
                out.infer(self.floating(), "it hangs from a cord");
            }
            Group::Top if !self.held && !self.placed && !self.above && !self.apart => {
                self.rests_on(self.top(), &format!("a {name} stands on something"), out);
            }
            Group::Bed | Group::Storage
                if !self.named.brief.facts.iter().any(|f| f.of.contains(&self.a)) && self.named.counts[self.a] <= 4 =>
            {
                let at_wall = self.mounted("againstWall").replacen("assert", "prefer", 1);
                out.infer(at_wall, "this kind of object stands against a wall");
            }
            Group::Soft if !self.held && !self.placed => {
                self.rests_on(self.seat(), &format!("a {name} lies on something"), out);
            }
            _ => {}
        }
    }

    /// Whether something under ceilings hangs there, since nothing says that it is elsewhere.
    fn hangs(&self) -> bool {
        let things = &self.named.brief.things;
        let beside = |w: &FactKind| match w {
            FactKind::Rel(Rel::Beside | Rel::Near | Rel::InFrontOf | Rel::Along, to) => {
                to.iter().any(|t| things[*t].group != Group::Ceiling)
            }
            _ => false,
        };
        !(self.held || self.placed || self.above && self.measured || self.said(beside))
    }

    fn rests_on(&self, below: Option<usize>, why: &str, out: &mut Stated) {
        if let Some(below) = below {
            let rests = self.named.pairs(self.a, below, &|x, y| format!("restsOn({x}, {y})"));
            out.infer(format!("assert {rests};"), why);
        }
    }

    /// What a small thing stands on: what it is near; what that stands on ("an espresso machine beside the cake display"); the
    /// first table of the room.
    fn top(&self) -> Option<usize> {
        let (named, a) = (self.named, self.a);
        let first = |pick: &dyn Fn(usize) -> Option<usize>| {
            named.brief.facts.iter().find_map(|f| match &f.what {
                FactKind::Rel(_, to) if f.of.contains(&a) => to.first().and_then(|t| pick(*t)),
                _ => None,
            })
        };
        let near = first(&|t| holds(named, t).then_some(t));
        near.or_else(|| first(&|t| carrier(named, t))).or_else(|| {
            (0..named.brief.things.len())
                .find(|i| named.brief.things[*i].room == self.item.room && holds(named, *i) && named.counts[*i] == 1)
        })
    }

    /// What something soft lies on.
    fn seat(&self) -> Option<usize> {
        let things = &self.named.brief.things;
        (0..things.len()).find(|i| {
            things[*i].room == self.item.room
                && matches!(things[*i].group, Group::Bed | Group::Seat)
                && self.named.sizes[*i][0] > 0.7
        })
    }

    /// A pair beside something stands at both of its sides; what is across from something is in its sight.
    fn with_others(&self, out: &mut Stated) {
        let named = self.named;
        for fact in named.brief.facts.iter().filter(|f| f.of.contains(&self.a) && !f.not && !f.soft) {
            let FactKind::Rel(rel @ (Rel::Beside | Rel::Opposite | Rel::Behind), to) = &fact.what else { continue };
            let [b] = to[..] else { continue };
            if let (Rel::Beside, Some(sides)) = (rel, named.both_sides(self.a, b)) {
                out.infer(format!("prefer {sides};"), "the objects of a pair stand on opposite sides");
            } else if *rel == Rel::Opposite {
                let near = named.pairs(self.a, b, &|x, y| format!("near({x}, {y}, 4)"));
                out.infer(format!("prefer {near};"), "an object across from another faces it");
            } else if *rel == Rel::Behind && self.item.group != Group::Seat && !named.brief.things[b].opening() {
                let near = named.pairs(self.a, b, &|x, y| format!("near({x}, {y}, {})", number(BEHIND)));
                out.infer(format!("prefer {near};"), "an object behind another one is near it");
            }
        }
    }

    /// What is above something, and is carried by nothing.
    fn over_something(&self, out: &mut Stated) {
        let (group, tall) = (self.item.group, self.named.tall(self.a));
        let loose = self.above && !self.held && !self.placed;
        if loose && self.lamp && !self.measured && matches!(group, Group::Floor | Group::Top) {
            out.infer(self.mounted("ceilingMounted"), "a lamp above something hangs from the ceiling");
        } else if loose
            // What is tall is above it on the plan only.
            && !tall
            && !matches!(group, Group::Ceiling | Group::Wall | Group::Drape | Group::Screen)
            && !self.item.opening()
        {
            let wall = matches!(group, Group::Storage | Group::Floor | Group::Table | Group::Top);
            if wall && !self.measured {
                out.infer(
                    self.mounted("wallMounted"),
                    "an object that is above another one and has nothing under it hangs on the wall",
                );
            } else {
                out.infer(self.floating(), "it hangs above something");
            }
        }
        let floats = matches!(group, Group::Floor | Group::Storage | Group::Top) && !self.on_wall;
        if self.above && !tall && self.measured && floats {
            out.infer(self.floating(), "it hangs above something");
        }
    }

    /// What nothing carries stands on the floor.
    fn on_floor(&self, out: &mut Stated) {
        let group = self.item.group;
        let low =
            matches!(group, Group::Seat | Group::Table | Group::Storage | Group::Bed | Group::Floor | Group::Flat);
        let tall = self.named.tall(self.a);
        let raised = self.held && !self.said(|w| matches!(w, FactKind::Rel(Rel::Under, _)))
            || self.above && !tall
            || self.high
            || self.said(|w| match w {
                FactKind::Pattern(Pattern::Stacked)
                | FactKind::Place(_, Place::Ceiling | Place::Floor, _)
                | FactKind::Place(Rel::Mounted | Rel::Hang, Place::Wall, _) => true,
                FactKind::Place(Rel::On, Place::Wall, _) => {
                    !matches!(group, Group::Table | Group::Seat | Group::Bed) && !tall
                }
                _ => false,
            });
        if (low || self.apart) && !raised && !(self.above && self.lamp) {
            out.infer(self.mounted("onFloor"), "an object that does not rest on another object stands on the floor");
        }
    }

    /// Rows of tables, and seats that are drawn up to them.
    fn in_order(&self, out: &mut Stated) {
        let (named, a) = (self.named, self.a);
        let said = self.said(|w| matches!(w, FactKind::Pattern(_)));
        if let Some(places) = named.rows(a).filter(|_| !said) {
            out.infer(format!("assert {places};"), "tables with their seats stand in rows");
        }
        if let Some(places) = named.drawn_up(a) {
            out.infer(format!("assert {places};"), "seats belong at their tables");
        }
        // Desks that face the board of a class stand as they would without it.
        let at_board =
            |of: &[usize]| of.iter().all(|board| named.desks_before(a, *board) && !named.is_somewhere(*board));
        let faces = |f: &Fact| match &f.what {
            FactKind::Rel(Rel::Facing, of) => f.of.contains(&a) && !f.not && !at_board(of),
            _ => false,
        };
        if let Some(turned) = named.turned(a).filter(|_| !named.brief.facts.iter().any(faces)) {
            out.infer(turned, "rows are straight");
        }
    }

    /// A television looks the way its stand does, unless it is said to look elsewhere.
    fn screen(&self, out: &mut Stated) {
        if let (Group::Screen, Some(stand)) = (self.item.group, carrier(self.named, self.a))
            && matches!(self.named.brief.things[stand].group, Group::Table | Group::Storage)
        {
            let turned = self.said(|w| matches!(w, FactKind::Rel(Rel::Facing | Rel::Opposite | Rel::BackTo, _)));
            let verb = if turned { "prefer" } else { "assert" };
            let along = self.named.pairs(self.a, stand, &|x, y| format!("angle({x}.front, {y}.front) <= 5"));
            out.infer(format!("{verb} {along};"), "a screen faces the same way as its stand");
        }
    }

    /// A rug in the middle of a room lies along its walls.
    fn along_walls(&self, out: &mut Stated) {
        let middle = self.said(|w| matches!(w, FactKind::Place(_, Place::Middle, _)));
        let other = self.said(|w| matches!(w, FactKind::Rel(Rel::Facing | Rel::Parallel | Rel::Perpendicular, _)));
        let turned = self.item.look.features.iter().any(|feature| matches!(feature.as_str(), "diagonal" | "angled"));
        if self.item.group == Group::Flat && self.named.counts[self.a] == 1 && middle && !other && !turned {
            out.infer(format!("{}.rot <- rot(0, 0, 0);", self.named.name(self.a)), "it lies along the walls");
        }
    }

    /// A desk or a cabinet of which it is said where it is among other things stands square to the walls all the same.
    fn square(&self, out: &mut Stated) {
        let large = matches!(self.item.group, Group::Table | Group::Storage | Group::Bed);
        let size = self.named.sizes[self.a];
        let is_round =
            self.item.look.features.iter().any(|f| matches!(f.as_str(), "round" | "circular" | "diagonal" | "angled"));
        let faces = self.said(|w| matches!(w, FactKind::Rel(Rel::Facing | Rel::BackTo, _)));
        let related =
            self.said(|w| matches!(w, FactKind::Rel(Rel::On | Rel::In | Rel::Parallel | Rel::Perpendicular, _)));
        if large && !is_round && faces && !related && !self.held && size[1] > 0.3 && self.named.counts[self.a] == 1 {
            let name = self.named.name(self.a);
            out.infer(format!("assert abs({name}.front.x * {name}.front.z) <= 0.02;"), "it stands square to the walls");
        }
    }

    /// Of a few seats that face one thing, and of which nothing else is said, none stands behind another.
    fn side_by_side(&self, out: &mut Stated) {
        let faces = self
            .said(|w| matches!(w, FactKind::Rel(Rel::Facing, to) if to.len() == 1 && self.named.counts[to[0]] == 1));
        let other = self.said(|w| {
            !matches!(
                w,
                FactKind::Rel(Rel::Facing, _) | FactKind::Size(..) | FactKind::Place(Rel::In, Place::Middle, _)
            )
        });
        if self.item.group == Group::Seat && (2..=4).contains(&self.named.counts[self.a]) && faces && !other {
            let first = format!("{}[0]", self.named.name(self.a));
            let aside =
                self.named.all(self.a, |x| format!("abs(dot({x}.center - {first}.center, {first}.front)) <= 0.3"));
            out.infer(format!("prefer {aside};"), "seats that face the same thing stand side by side");
        }
    }

    /// At the height of the eyes, where nothing is said.
    fn at_eye_level(&self, out: &mut Stated) {
        let height = self.named.sizes[self.a][1];
        let up = matches!(self.item.group, Group::Wall | Group::Screen) && !self.held && !self.high && !self.above;
        let at_ceiling = self.said(|w| matches!(w, FactKind::Place(_, Place::Ceiling, _)));
        if !up || height >= 1.6 || at_ceiling {
            return;
        }
        // People look at a screen from their seats.
        let sits = |i: &Thing| matches!(i.group, Group::Seat | Group::Bed) && i.room == self.item.room;
        let seated = self.named.screen(self.a) && self.named.brief.things.iter().any(sits);
        let (eyes, least, give) = if seated { (1.1, 0.5, 0.1) } else { (1.5, 0.6, 0.2) };
        // "a low cabinet under the screen": it hangs above that, whatever suits the eyes.
        let below = self.named.brief.facts.iter().filter_map(|f| match &f.what {
            FactKind::Rel(Rel::Under, to) if to.contains(&self.a) && !f.not => f.of.first(),
            _ => None,
        });
        let top = below.map(|&under| self.named.sizes[under][1] + give + 0.05).fold(least, f64::max);
        let low = number((eyes - height / 2.0).max(top));
        let test = |x: &str| format!("abs({x}.bottom - {low}) <= {}", number(give));
        out.infer(format!("prefer {};", self.named.all(self.a, test)), "at eye level");
    }

    /// Rugs and cloths may lie under anything. Nothing stands on a mat that people exercise on.
    fn under_others(&self, out: &mut Stated) {
        const EXERCISE: [&str; 6] = ["exercise", "yoga", "gym", "pilates", "judo", "gymnastics"];
        let words = &self.item.words;
        if words.last().is_some_and(|w| w == "mat") && words.iter().any(|w| EXERCISE.contains(&w.as_str())) {
            return;
        }
        const CLOTHS: [&str; 6] = ["tablecloth", "placemat", "blanket", "throw", "duvet", "quilt"];
        let cloth = self.item.words.last().is_some_and(|w| CLOTHS.contains(&w.as_str()));
        if (self.item.group == Group::Flat || cloth) && self.named.names[self.a].len() == 1 {
            out.infer(format!("allowCollide({}, objects);", self.named.name(self.a)), "objects may stand on it");
        }
    }
}

/// What a thing is said to stand on.
fn carrier(named: &Named, item: usize) -> Option<usize> {
    named.brief.facts.iter().find_map(|f| match &f.what {
        FactKind::Rel(Rel::On, to) if f.of.contains(&item) && !f.not => {
            to.first().copied().filter(|t| named.brief.things[*t].group != Group::Flat)
        }
        _ => None,
    })
}

/// Whether small things can stand on it.
fn holds(named: &Named, item: usize) -> bool {
    let group = named.brief.things[item].group;
    matches!(group, Group::Table) && named.sizes[item][1] < 1.5
}
