//! What the prover says of a draft before it is tried: a search for what is proved impossible takes its whole budget and
//! then can only guess what is in the way; a proof names it at once.
//!
//! A proof is sound, so nothing that can hold is given up: of statements that have a layout nothing is refuted, as far as
//! things are taken as the solver takes them (upright, unturned, of their usual sizes).

use crate::rehearse::{base, enlarge, squeeze_door, with_fixed};
use scenelang_formalize::Draft;
use scenelang_formalize::prefer::Stated;
use scenelang_lang::program::{Owner, Pinned, Program};
use scenelang_solve::Stop;
use scenelang_verify::prove::{Contradiction, ProveOptions, prove};

/// Why a statement became a preference.
const REASON: &str = "it contradicts the rest, so it is kept as a preference";

/// Gives up part of each set of statements that is proved contradictory: what was added to the request first, then the
/// size of a room that nobody gave, then the statement that is given up most willingly. Whether anything was given up.
/// `work` is what proofs may still take.
pub fn give_up_refuted(draft: &mut Draft, program: &Program, stop: &Stop, grown: &mut [usize], work: &mut u64) -> bool {
    let options = ProveOptions {
        work: *work,
        redundant: false,
        usual: true,
        cancel: Some(stop.flag()),
        ..ProveOptions::default()
    };
    let findings = prove(program, &options);
    *work = work.saturating_sub(findings.work_spent);
    let found = findings.contradictions;
    if found.is_empty() {
        return false;
    }
    let groups: Vec<Vec<String>> = found.iter().map(|set| with_fixed(draft, things_of(program, set))).collect();
    if draft.leave_out(&groups) {
        return true;
    }
    let rooms: Vec<usize> = found.iter().flat_map(|set| rooms_of(draft, program, set)).collect();
    if enlarge(draft, &rooms, grown) {
        return true;
    }
    let stated = Stated::new(draft, program);
    // That a thing stands on the floor of its room is given up last: without it, it may be anywhere.
    let placed = |statement: usize| {
        let statement = &draft.statements[statement];
        statement.source.reason().is_some() && statement.text.contains("onFloor(")
    };
    let ranked = |c: usize| {
        let statement = stated.of(c)?;
        Some((!placed(statement), stated.rank(draft, c)?, statement))
    };
    let willing = |set: &Contradiction| set.statements.iter().filter_map(|c| ranked(*c)).max();
    let given_up: Vec<usize> = found.iter().filter_map(willing).map(|(.., statement)| statement).collect();
    if draft.prefer(given_up, REASON) {
        return true;
    }
    // What is left are statements that come with the things: a door opens, a thing is in its room.
    let own = |c: usize| &program.constraints[c];
    let rest: Vec<usize> = found.iter().flat_map(|set| set.statements.iter().copied()).collect();
    let squeezed = rest.iter().filter(|c| squeeze_door(draft, program, own(**c))).count();
    let inside = rest.iter().filter(|c| own(**c).text.contains("inside("));
    let first = |c: &usize| own(*c).formula.objects().first().map(|o| base(&program.objects[o.0 as usize].name));
    squeezed > 0 || inside.filter_map(first).any(|name| draft.let_out(name))
}

/// The things that a set of statements speaks of.
fn things_of(program: &Program, set: &Contradiction) -> Vec<String> {
    let objects = set.statements.iter().flat_map(|c| program.constraints[*c].formula.objects());
    objects.map(|o| base(&program.objects[o.0 as usize].name).to_owned()).collect()
}

/// The rooms whose size takes part in a contradiction.
fn rooms_of(draft: &Draft, program: &Program, set: &Contradiction) -> Vec<usize> {
    let sizes = program.pins.iter().filter(|p| p.property == Pinned::Scale && set.statements.contains(&p.constraint));
    let regions = sizes.filter_map(|pin| match pin.owner {
        Owner::Region(id) => Some(program.regions[id.0 as usize].name.as_str()),
        Owner::Object(_) => None,
    });
    regions.filter_map(|name| draft.rooms.iter().position(|room| room.name == name)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Tried, rehearse};
    use scenelang_formalize::draft::{Demand, DraftThing, Statement, ThingOrigin};
    use scenelang_formalize::write::write;
    use scenelang_formalize::{Options, read};
    use scenelang_lang::compile_text;
    use scenelang_verify::prove::WORK;
    use std::path::Path;

    /// Whether anything was given up, and the draft after it.
    fn given_up(mut draft: Draft) -> (bool, Draft) {
        let text = write(&draft);
        let compiled = compile_text("room.scene", Path::new("room.scene"), &text, scenelang_lang::Options::default());
        let program = compiled.program.expect("the draft compiles");
        let mut grown = vec![0; draft.rooms.len()];
        let mut work = WORK;
        let any = give_up_refuted(&mut draft, &program, &Stop::default(), &mut grown, &mut work);
        (any, draft)
    }

    fn with(request: &str, statement: &str, source: ThingOrigin) -> Draft {
        let mut draft = read(request, &Options { literal: true }).draft;
        draft.statements.push(Statement::new(statement, source));
        draft
    }

    fn added() -> ThingOrigin {
        ThingOrigin::Inferred("a room has one".to_owned())
    }

    const STUDY: &str = "A study, 4 by 3 m, with a desk and a bench.";

    #[test]
    fn what_is_proved_impossible_becomes_a_preference_and_is_noted() {
        let (any, draft) = given_up(with(STUDY, "assert far(desk, bench, 6)", ThingOrigin::Stated(0..7)));
        assert!(any);
        let statement = draft.statements.iter().find(|s| s.text.starts_with("far(")).unwrap();
        assert_eq!((statement.demand, statement.relaxed), (Demand::Prefer, true));
        assert!(draft.notes.iter().any(|note| note.reason == REASON), "{:?}", draft.notes);
        let (again, _) = given_up(draft);
        assert!(!again, "nothing else contradicts itself");
    }

    #[test]
    fn what_was_added_is_left_out_before_anything_that_was_asked_for() {
        let mut draft = with(STUDY, "assert far(statue, desk, 6)", added());
        draft.things.push(DraftThing {
            name: "statue".to_owned(),
            category: "statue".to_owned(),
            count: 1,
            room: Some(0),
            size: None,
            look: Default::default(),
            formation: Vec::new(),
            source: added(),
        });
        let asked = draft.things.len() - 1;
        let (any, draft) = given_up(draft);
        assert!(any && draft.things.len() == asked && draft.things.iter().all(|t| t.name != "statue"));
        assert!(draft.statements.iter().all(|s| !s.relaxed), "{:?}", draft.statements);
    }

    #[test]
    fn a_room_whose_size_nobody_gave_grows_before_anything_is_given_up() {
        let draft = with("A study with a desk and a bench.", "assert far(desk, bench, 6)", ThingOrigin::Stated(0..7));
        let before = draft.rooms[0].size;
        let (any, draft) = given_up(draft);
        assert!(any && draft.rooms[0].size[0] > before[0], "{:?}", draft.rooms);
        assert!(draft.statements.iter().all(|s| !s.relaxed), "{:?}", draft.statements);
    }

    /// Of what has a layout nothing is refuted.
    #[test]
    fn what_has_a_layout_stays_as_it_is() {
        for request in [
            "A study, 4 by 3 m, with a desk, a chair in front of the desk and a shelf against the wall.",
            "A bedroom, 3 by 3 m, with a bed in the corner, a wardrobe against the wall and a lamp near the bed.",
            "A hall, 6 by 4 m, with three benches at least 1 m apart and a piano in the corner.",
            "A bathroom, 2.5 by 2 m, with a toilet, a sink against the wall and a mirror above the sink.",
            "A kitchen, 4 by 3 m, with a table in the middle, four chairs around it and a lamp above the table.",
            "An office, 5 by 4 m, with two desks facing each other, each with a monitor, and a plant beside the door.",
        ] {
            let mut draft = read(request, &Options { literal: true }).draft;
            let before = draft.clone();
            assert_eq!(rehearse(&mut draft, &Stop::default(), &mut |_| ()), Tried::Holds, "{request}");
            assert_eq!(draft, before, "{request}");
            let (any, after) = given_up(before.clone());
            assert!(!any && after == before, "{request}");
        }
    }
}
