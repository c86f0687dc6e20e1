//! "A galley kitchen with counters on both sides": one row has the sink and the stove, and the other one across the aisle is for
//! work and for what is stored, as such kitchens have it; not a sink and a stove in each.

use crate::brief::{Brief, Fact, FactKind, Number, Rel, ThingOrigin};

const GALLEY: &str = "galley kitchen";

/// Makes two different rows of two counters that are asked for in such a kitchen.
pub fn two_rows(brief: &mut Brief) {
    for room in 0..brief.rooms.len() {
        if brief.rooms[room].name != GALLEY {
            continue;
        }
        let is_counter = |at: &usize| {
            let thing = &brief.things[*at];
            let two = matches!(thing.number, Number::Plural | Number::Exactly(2));
            thing.room == room && thing.words == ["kitchen", "counter"] && thing.part.is_none() && two
        };
        let Some(at) = (0..brief.things.len()).find(is_counter) else { continue };
        brief.things[at].number = Number::Exactly(1);
        let mut second = brief.things[at].clone();
        second.words = ["prep", "counter"].map(str::to_owned).to_vec();
        second.last = second.words.len();
        brief.things.push(second);
        let new = brief.things.len() - 1;
        let of_it = |fact: &&Fact| fact.of == [at] && fact.what.objects().is_none();
        let said: Vec<Fact> = brief.facts.iter().filter(of_it).cloned().collect();
        brief.facts.extend(said.into_iter().map(|fact| Fact { of: vec![new], ..fact }));
        let why = ThingOrigin::Inferred("the rows of a galley kitchen are across from each other".into());
        brief.facts.push(Fact::new(vec![new], FactKind::Rel(Rel::Opposite, vec![at]), why));
    }
}
