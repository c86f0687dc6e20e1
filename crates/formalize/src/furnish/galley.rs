//! "A kitchen with counters along both walls": one row has the sink and the stove, and the other one across the aisle is for
//! work and for what is stored, as such kitchens have it; not a sink and a stove in each.

use crate::brief::{Brief, Fact, FactKind, Number, Place, Rel, ThingOrigin};

const GALLEY: &str = "galley kitchen";

/// Whether a thing is said to stand at both walls.
fn is_at_both(brief: &Brief, at: usize) -> bool {
    let both = |fact: &Fact| match &fact.what {
        FactKind::Place(_, Place::Wall, which) => fact.of == [at] && which.iter().any(|word| word == "each"),
        _ => false,
    };
    brief.facts.iter().any(both)
}

/// Makes two different rows of two counters that are asked for in such a kitchen.
pub fn two_rows(brief: &mut Brief) {
    for room in 0..brief.rooms.len() {
        let is_galley = brief.rooms[room].name == GALLEY;
        if !is_galley && brief.rooms[room].name != "kitchen" {
            continue;
        }
        let is_counter = |at: &usize| {
            let thing = &brief.things[*at];
            let two = matches!(thing.number, Number::Plural | Number::Exactly(2));
            thing.room == room
                && thing.words == ["kitchen", "counter"]
                && thing.part.is_none()
                && two
                && (is_galley || is_at_both(brief, *at))
        };
        let Some(at) = (0..brief.things.len()).find(is_counter) else { continue };
        GALLEY.clone_into(&mut brief.rooms[room].name);
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

#[cfg(test)]
mod tests {
    use crate::read::{Options, read};

    /// How many there are of a category in a furnished room.
    fn count(request: &str, category: &str) -> usize {
        let draft = read(request, &Options::default()).draft;
        draft.things.iter().filter(|thing| thing.category == category).map(|thing| thing.count).sum()
    }

    #[test]
    fn rooms_have_what_belongs_at_both_sides() {
        for (request, category, expected) in [
            ("a galley kitchen with counters on both sides", "stove", 1),
            ("a kitchen with counters along both long walls", "kitchen_counter", 1),
            ("a kitchen with counters along both long walls", "prep_counter", 1),
            ("a kitchen with counters along the wall", "prep_counter", 0),
            ("a restaurant, 10 by 6 m, with eight tables for two", "restaurant_chair", 16),
            ("a lounge with a couch in one corner and a dining table for six", "chair", 6),
            ("a lounge with a couch for six", "chair", 0),
            ("a barber with three chairs in front of three mirrors", "barber_chair", 3),
        ] {
            assert_eq!(count(request, category), expected, "{category} of {request}");
        }
    }
}
