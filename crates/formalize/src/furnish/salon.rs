//! "A barber's with three chairs in front of three mirrors": at a hairdresser's such a chair has a counter before it, below its mirror.

use super::kinds;
use crate::brief::{Brief, Fact, FactKind, Number, Rel, ThingOrigin};

/// Adds the counters of chairs that are said to be before mirrors.
pub fn stations(brief: &mut Brief) {
    const WHY: &str = "a chair before a mirror has a counter at a hairdresser's";
    for room in 0..brief.rooms.len() {
        let is_salon = kinds::of(&brief.rooms[room].name).is_some_and(|kind| kind.name == "hair salon");
        let named = |at: usize, noun: &str| {
            let thing = &brief.things[at];
            thing.room == room && thing.part.is_none() && thing.words.last().is_some_and(|word| word == noun)
        };
        let any = |noun: &str| (0..brief.things.len()).any(|at| named(at, noun));
        if !is_salon || brief.rooms[room].only || any("station") || any("counter") {
            continue;
        }
        let before = brief.facts.iter().find_map(|fact| match (&fact.of[..], &fact.what) {
            ([chair], FactKind::Rel(Rel::InFrontOf | Rel::Facing, to)) if named(*chair, "chair") && !fact.not => {
                (to.len() == 1 && named(to[0], "mirror")).then(|| (*chair, to[0]))
            }
            _ => None,
        });
        let Some((chair, mirror)) = before else { continue };
        let n = brief.count(chair);
        let mut station = brief.things[chair].clone();
        station.words = ["styling", "counter"].map(str::to_owned).to_vec();
        station.last = station.words.len();
        station.number = Number::Exactly(n);
        station.group = super::stand::group("styling counter");
        station.look = crate::brief::Look::default();
        station.size = [None; 3];
        brief.things.push(station);
        let new = brief.things.len() - 1;
        // The chair is before its counter, which is below the mirror.
        for fact in &mut brief.facts {
            if let ([of], FactKind::Rel(rel @ (Rel::InFrontOf | Rel::Facing), to)) = (&fact.of[..], &mut fact.what)
                && *of == chair
                && to[..] == [mirror]
            {
                (*rel, *to) = (Rel::InFrontOf, vec![new]);
            }
        }
        let source = ThingOrigin::Inferred(WHY.into());
        brief.facts.push(Fact::new(vec![mirror], FactKind::Rel(Rel::Above, vec![new]), source));
    }
}
