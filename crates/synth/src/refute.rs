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
use scenelang_verify::prove::{Contradiction, ProveOptions, WORK, prove};

/// Why a statement became a preference.
const REASON: &str = "it cannot hold together with the rest, so it is only a preference";

/// Gives up part of each set of statements that is proved contradictory: what was added to the request first, then the
/// size of a room that nobody gave, then the statement that is given up most willingly. Whether anything was given up.
pub fn give_up_refuted(draft: &mut Draft, program: &Program, stop: &Stop, grown: &mut [usize]) -> bool {
    let options = ProveOptions {
        work: WORK,
        redundant: false,
        usual: true,
        cancel: Some(stop.flag()),
        ..ProveOptions::default()
    };
    let found = prove(program, &options).contradictions;
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
    let ranked = |c: usize| Some((stated.rank(draft, c)?, stated.of(c)?));
    let willing = |set: &Contradiction| set.statements.iter().filter_map(|c| ranked(*c)).max();
    let given_up: Vec<usize> = found.iter().filter_map(willing).map(|(_, statement)| statement).collect();
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
