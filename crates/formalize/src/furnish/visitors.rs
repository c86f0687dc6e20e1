//! Where visitors sit: "two client chairs in front of the desk" are on its other side, opposite whoever works there. As a desk
//! looks at the one who works, that is behind it.

use crate::draft::{Draft, DraftThing};

/// Whose chairs they are.
const WHOSE: [&str; 6] = ["client", "customer", "guest", "patient", "visitor", "interview"];

/// Puts them there.
pub fn opposite(draft: &mut Draft) {
    let noun = |thing: &DraftThing| thing.category.replace('_', " ");
    let is_desk = |thing: &&DraftThing| noun(thing).ends_with("desk") || noun(thing).ends_with("counter");
    let is_visitor = |thing: &&DraftThing| {
        let noun = noun(thing);
        (noun.ends_with("chair") || noun.ends_with("armchair")) && WHOSE.iter().any(|who| noun.starts_with(who))
    };
    let desks: Vec<String> = draft.things.iter().filter(is_desk).map(|desk| desk.name.clone()).collect();
    let chairs: Vec<String> = draft.things.iter().filter(is_visitor).map(|chair| chair.name.clone()).collect();
    for statement in &mut draft.statements {
        let text = &statement.text;
        let before =
            desks.iter().any(|desk| text.ends_with(&format!(", {desk})")) || text.contains(&format!(", {desk}) ")));
        let seated = chairs.iter().any(|chair| {
            text.contains(&format!("inFrontOf({chair},")) || text.contains(&format!(" in {chair}: inFrontOf("))
        });
        if before && seated {
            statement.text = text.replacen("inFrontOf(", "behind(", 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::read::{Options, read};

    #[test]
    fn visitors_sit_opposite_whoever_works() {
        let of = |request: &str| read(request, &Options::default()).draft.statements;
        let says = |request: &str, what: &str| of(request).iter().any(|s| s.text.contains(what));
        assert!(says("An office with a desk and two client chairs in front of it.", "behind("));
        assert!(says("An office with a desk and a chair in front of it.", "inFrontOf("));
    }
}
