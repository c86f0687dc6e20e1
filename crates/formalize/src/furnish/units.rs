//! The counter of a kitchen is all its units: "the fridge at the end of the counter" stands beside any of them, as the sink, the stove
//! and the worktops are one run along the wall.

use super::kinds;
use crate::draft::{Draft, ThingOrigin};

/// What a run of kitchen units consists of.
const UNITS: [&str; 6] =
    ["kitchen counter", "kitchen worktop", "kitchen base cabinet", "base cabinet", "kitchen sink", "prep counter"];
/// What stands in the run.
const IN_RUN: [&str; 9] =
    ["fridge", "refrigerator", "stove", "oven", "dishwasher", "washing machine", "freezer", "kitchen sink", "cooker"];
/// How a statement about any of them begins.
const ANY: &str = "exists unit in objects where ";

/// What is said to stand beside the counter of a kitchen at home stands beside one of its units.
pub fn any_of_run(draft: &mut Draft) {
    let is_home = |room: usize| {
        kinds::of(&draft.rooms[room].kind).is_some_and(|kind| kind.home.is_some() && kind.name.ends_with("kitchen"))
    };
    let named = |names: &[&str]| -> Vec<String> {
        let here = draft.things.iter().filter(|thing| thing.count == 1 && thing.room.is_some_and(is_home));
        let one = here.filter(|thing| names.contains(&thing.category.replace('_', " ").as_str()));
        one.map(|thing| thing.name.clone()).collect()
    };
    let (counters, parts) = (named(&UNITS[..1]), named(&IN_RUN));
    let is_unit = UNITS.map(|unit| format!(".category = \"{unit}\"")).join(" or ");
    for statement in draft.statements.iter_mut().filter(|s| matches!(s.source, ThingOrigin::Stated(_))) {
        for (counter, part) in counters.iter().flat_map(|counter| parts.iter().map(move |part| (counter, part))) {
            if statement.text == format!("beside({part}, {counter})") {
                statement.text = format!("{ANY}{is_unit}: beside({part}, unit)");
            }
        }
    }
}

/// Whether a statement says that something stands beside a unit, whichever that is.
pub fn is_in_run(text: &str, name: &str) -> bool {
    text.starts_with(ANY) && text.ends_with(&format!(": beside({name}, unit)"))
}
