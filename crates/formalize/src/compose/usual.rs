//! What nobody says because everybody knows it: pictures hang on walls, lamps under the ceiling, a cup stands on a table;
//! a rug may lie under anything.

use super::state::{Named, Stated};
use crate::brief::{Fact, Group, Pattern, Place, Rel, What};
use crate::write::number;

/// Adds it.
pub fn usual(named: &Named, out: &mut Stated) {
    let brief = named.brief;
    for a in (0..brief.things.len()).filter(|a| brief.things[*a].part.is_none()) {
        let item = &brief.things[a];
        let room = named.room(a).to_owned();
        let held =
            named.said(a, |w| matches!(w, What::Rel(Rel::On | Rel::In | Rel::Under | Rel::Mounted | Rel::Hang, _)));
        let placed = named
            .said(a, |w| matches!(w, What::Place(_, Place::Wall | Place::Ceiling | Place::Corner | Place::Middle, _)));
        let high = named.said(a, |w| matches!(w, What::Height(..)));
        let on_wall = named.said(a, |w| matches!(w, What::Place(_, Place::Wall, _)));
        let above = named.said(a, |w| matches!(w, What::Rel(Rel::Above, _)));
        let measured = named.said(a, |w| matches!(w, What::Gap(..) | What::Height(..)));
        let lamp = item.words.last().is_some_and(|w| w == "lamp" || w == "light");
        let mounted = |p: &str| format!("assert {};", named.all(a, |x| format!("{p}({x}, {room})")));
        let beside = |w: &What| matches!(w, What::Rel(Rel::Beside | Rel::Near | Rel::InFrontOf | Rel::Along, to) if to.iter().any(|t| brief.things[*t].group != Group::Ceiling));
        let elsewhere = held || placed || above && measured || named.said(a, beside);
        let hangs = item.group == Group::Ceiling && !elsewhere;
        // "a mixer to the left of the counter", "a lamp beside the armchair" stand on the floor.
        let apart = item.group == Group::Top
            && named.said(a, |w| {
                matches!(w, What::Rel(Rel::LeftOf | Rel::RightOf | Rel::Beside | Rel::Sides | Rel::InFrontOf | Rel::Behind, to)
                    if to.iter().any(|t| !matches!(brief.things[*t].group, Group::Top | Group::Screen) && carrier(named, *t).is_none()))
            });
        match item.group {
            Group::Wall | Group::Drape
                if !held && !on_wall && !named.said(a, |w| matches!(w, What::Place(_, Place::Ceiling, _))) =>
            {
                out.infer(mounted("wallMounted"), &format!("a {} hangs on a wall", item.name()));
            }
            Group::Screen if !held && !on_wall => {
                out.infer(mounted("wallMounted"), &format!("a {} that stands on nothing hangs on a wall", item.name()))
            }
            Group::Ceiling if hangs => {
                out.infer(mounted("ceilingMounted"), &format!("a {} hangs from the ceiling", item.name()));
            }
            Group::Ceiling if above && measured && !placed => {
                out.infer(format!("allowFloat({});", named.name(a)), "it hangs on a cord")
            }
            Group::Top if !held && !placed && !above && !apart => {
                let near = named.brief.facts.iter().find_map(|f| match &f.what {
                    What::Rel(_, to) if f.of.contains(&a) => to.first().copied().filter(|t| holds(named, *t)),
                    _ => None,
                });
                // "an espresso machine beside the cake display": on what that stands on.
                let same = brief.facts.iter().find_map(|f| match &f.what {
                    What::Rel(_, to) if f.of.contains(&a) => to.first().and_then(|t| carrier(named, *t)),
                    _ => None,
                });
                let top = near.or(same).or_else(|| {
                    (0..brief.things.len())
                        .find(|i| brief.things[*i].room == item.room && holds(named, *i) && named.counts[*i] == 1)
                });
                if let Some(top) = top {
                    out.infer(
                        format!("assert {};", named.pairs(a, top, &|x, y| format!("restsOn({x}, {y})"))),
                        &format!("a {} stands on something", item.name()),
                    );
                }
            }
            Group::Bed | Group::Storage if !brief.facts.iter().any(|f| f.of.contains(&a)) && named.counts[a] <= 4 => {
                out.infer(
                    format!("prefer {};", named.all(a, |x| format!("againstWall({x}, {room})"))),
                    "such things stand at a wall",
                );
            }
            Group::Soft if !held && !placed => {
                let under = (0..brief.things.len()).find(|i| {
                    brief.things[*i].room == item.room
                        && matches!(brief.things[*i].group, Group::Bed | Group::Seat)
                        && named.sizes[*i][0] > 0.7
                });
                if let Some(under) = under {
                    out.infer(
                        format!("assert {};", named.pairs(a, under, &|x, y| format!("restsOn({x}, {y})"))),
                        &format!("a {} lies on something", item.name()),
                    );
                }
            }
            _ => {}
        }
        for fact in brief.facts.iter().filter(|f| f.of.contains(&a) && !f.not && !f.soft) {
            let What::Rel(rel @ (Rel::Beside | Rel::Opposite), to) = &fact.what else { continue };
            let [b] = to[..] else { continue };
            if let (Rel::Beside, Some(sides)) = (rel, named.both_sides(a, b)) {
                out.infer(format!("prefer {sides};"), "a pair stands at both sides");
            } else if *rel == Rel::Opposite {
                let near = named.pairs(a, b, &|x, y| format!("near({x}, {y}, 4)"));
                out.infer(format!("prefer {near};"), "what is across from a thing is in sight of it");
            }
        }
        if above && lamp && !held && !placed && !measured && matches!(item.group, Group::Floor | Group::Top) {
            out.infer(mounted("ceilingMounted"), "a lamp above something hangs from the ceiling");
        } else if above
            && !held
            && !placed
            && !matches!(item.group, Group::Ceiling | Group::Wall | Group::Drape | Group::Screen)
            && !item.opening()
        {
            let wall = matches!(item.group, Group::Storage | Group::Floor | Group::Table | Group::Top);
            if named.tall(a) {
                // Said of its place on the plan.
            } else if wall && !measured {
                out.infer(mounted("wallMounted"), "what is above something and stands on nothing hangs on a wall");
            } else {
                out.infer(format!("allowFloat({});", named.name(a)), "it hangs above something");
            }
        }
        let hung = above && !named.tall(a);
        if hung && measured && matches!(item.group, Group::Floor | Group::Storage | Group::Top) && !on_wall {
            out.infer(format!("allowFloat({});", named.name(a)), "it hangs above something");
        }
        let floor =
            matches!(item.group, Group::Seat | Group::Table | Group::Storage | Group::Bed | Group::Floor | Group::Flat)
                || apart;
        let raised = held && !named.said(a, |w| matches!(w, What::Rel(Rel::Under, _)))
            || above && !named.tall(a)
            || high
            || named.said(a, |w| matches!(w, What::Pattern(Pattern::Stacked)))
            || named.said(a, |w| matches!(w, What::Place(_, Place::Ceiling | Place::Floor, _)))
            || named.said(a, |w| {
                matches!(w, What::Place(Rel::Mounted | Rel::Hang, Place::Wall, _))
                    || matches!(w, What::Place(Rel::On, Place::Wall, _))
                        && !matches!(item.group, Group::Table | Group::Seat | Group::Bed)
                        && !named.tall(a)
            });
        if floor && !raised && !(above && lamp) {
            out.infer(mounted("onFloor"), "what nothing carries stands on the floor");
        }
        let said = named.said(a, |w| matches!(w, What::Pattern(_)));
        if let Some(places) = named.rows(a).filter(|_| !said) {
            out.infer(format!("assert {places};"), "tables with their seats stand in rows");
        }
        if let Some(places) = named.drawn_up(a) {
            out.infer(format!("assert {places};"), "seats are drawn up to their tables");
        }
        let faces = |f: &Fact| matches!(f.what, What::Rel(Rel::Facing, _)) && f.of.contains(&a) && !f.not;
        if let Some(turned) = named.turned(a).filter(|_| !brief.facts.iter().any(faces)) {
            out.infer(turned, "rows stand straight");
        }
        // A television looks the way its stand does, unless it is said to look elsewhere.
        if let (Group::Screen, Some(stand)) = (item.group, carrier(named, a))
            && matches!(brief.things[stand].group, Group::Table | Group::Storage)
        {
            let turned = named.said(a, |w| matches!(w, What::Rel(Rel::Facing | Rel::Opposite | Rel::BackTo, _)));
            let verb = if turned { "prefer" } else { "assert" };
            let along = named.pairs(a, stand, &|x, y| format!("angle({x}.front, {y}.front) <= 5"));
            out.infer(format!("{verb} {along};"), "a screen looks the way its stand does");
        }
        // At the height of the eyes, where nothing is said.
        let up = matches!(item.group, Group::Wall | Group::Screen) && !held && !high && !above;
        if up && named.sizes[a][1] < 1.6 {
            // People look at a screen from their seats.
            let sits = |i: &crate::brief::Thing| matches!(i.group, Group::Seat | Group::Bed) && i.room == item.room;
            let seated = named.screen(a) && brief.things.iter().any(sits);
            let (eyes, least, give) = if seated { (1.1, 0.5, 0.1) } else { (1.5, 0.6, 0.2) };
            let low = (eyes - named.sizes[a][1] / 2.0).max(least);
            let test = |x: &str| format!("abs({x}.bottom - {}) <= {}", number(low), number(give));
            out.infer(format!("prefer {};", named.all(a, test)), "at the height of the eyes");
        }
        let cloth = item
            .words
            .last()
            .is_some_and(|w| matches!(w.as_str(), "tablecloth" | "placemat" | "blanket" | "throw" | "duvet" | "quilt"));
        if (item.group == Group::Flat || cloth) && named.names[a].len() == 1 {
            out.infer(format!("allowCollide({}, objects);", named.name(a)), "things may stand on it");
        }
    }
}

/// What a thing is said to stand on.
fn carrier(named: &Named, item: usize) -> Option<usize> {
    named.brief.facts.iter().find_map(|f| match &f.what {
        What::Rel(Rel::On, to) if f.of.contains(&item) && !f.not => {
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
