//! Furniture that can stand but not open as far as is useful, in a room whose size is given: the program then asks for as
//! much as there is room for. First it asks for nothing, so that there is a layout; then for more, as far as one is found.

use crate::furnish::furnish;
use crate::rehearse::trial;
use scenelang_formalize::Draft;
use scenelang_formalize::draft::Narrowed;
use scenelang_formalize::write::write;
use scenelang_lang::program::{ObjectId, Program};
use scenelang_lang::{Options, compile_text};
use scenelang_layout::{Layout, Motion};
use scenelang_solve::{Outcome, Placed, Problem, Progress, Stop, TermSubject};
use scenelang_verify::opening::{self, LOOKS};
use scenelang_verify::{Options as Judging, World};
use std::path::Path;

/// A search for more ends where no more than so much is left to gain (degrees, metres).
const CLOSE: [f64; 2] = [4.0, 0.03];
/// What is demanded is a multiple of this (degrees, metres).
const GRAIN: [f64; 2] = [1.0, 0.01];
/// How many trials are spent on one object, and on all.
const TRIALS: usize = 5;
const MOST_TRIALS: usize = 24;

/// Asks nothing more of furniture that does not open as it should, but for the doors of rooms. Whether there was any.
pub fn narrow(draft: &mut Draft, program: &Program, outcome: &Outcome, judge: &Judging) -> bool {
    let shut =
        |name: &str| outcome.unsatisfied.iter().any(|u| matches!(&u.what, TermSubject::Open(shut, _) if shut == name));
    narrow_those(draft, program, outcome, judge, &shut)
}

/// Asks nothing more of any furniture that does not open as it should, whatever the search has put up with instead: it may
/// have left a gap for a door at the cost of something that was said.
pub fn narrow_all(draft: &mut Draft, program: &Program, outcome: &Outcome, judge: &Judging) -> bool {
    narrow_those(draft, program, outcome, judge, &|_| true)
}

fn narrow_those(
    draft: &mut Draft,
    program: &Program,
    outcome: &Outcome,
    judge: &Judging,
    those: &dyn Fn(&str) -> bool,
) -> bool {
    let before = draft.narrowed.len();
    for (at, object) in program.objects.iter().enumerate() {
        let (id, name) = (ObjectId(at as u32), &object.name);
        if !those(name) || draft.openings.iter().any(|opening| opening.name == *name) {
            continue;
        }
        for motion in [Motion::Hinge, Motion::Slide] {
            let turns = motion == Motion::Hinge;
            let known = draft.narrowed.iter().any(|n| n.object == *name && n.turns == turns);
            if !known && let Some((_, useful)) = reach(program, &outcome.layout, id, motion, judge) {
                draft.narrowed.push(Narrowed { object: name.to_string(), turns, least: 0.0, useful });
            }
        }
    }
    draft.narrowed.len() > before
}

/// How far all of an object that moves this way opens in a layout, down to the grain, and how far is useful; `None`: nothing
/// of it has to open.
fn reach(program: &Program, layout: &Layout, id: ObjectId, motion: Motion, judge: &Judging) -> Option<(f64, f64)> {
    let world = World::<f64>::new(program, layout, judge);
    let own = || opening::joints(&world, id).iter().enumerate().filter(|(_, joint)| joint.motion == motion);
    let useful = own().filter_map(|(_, joint)| joint.useful).reduce(f64::max)?;
    let mut least = useful;
    for (part, joint) in own() {
        let most = least.min(joint.limits[1]);
        least = opening::free(&world, id, part, most, &mut { LOOKS }).map_or(0.0, |(free, _)| free);
    }
    if least >= useful {
        return Some((useful, useful));
    }
    let grain = of(GRAIN, motion == Motion::Hinge);
    // Nothing is lost of a multiple of the grain to a rounding error.
    Some(((least / grain + 1e-6).floor() * grain, useful))
}

fn of([turning, sliding]: [f64; 2], turns: bool) -> f64 {
    if turns { turning } else { sliding }
}

/// Asks as much of what was narrowed as there is a layout for, one after the other. The last layout that was found; `None`:
/// nothing is narrowed, or no layout is found any more.
pub fn widened(draft: &mut Draft, stop: &Stop, progress: &mut dyn FnMut(Progress)) -> Option<Layout> {
    if draft.narrowed.is_empty() {
        return None;
    }
    let mut best = tried(draft, None, stop, progress)?;
    let mut left = MOST_TRIALS;
    for at in 0..draft.narrowed.len() {
        let Narrowed { turns, useful, .. } = draft.narrowed[at];
        let mut low = draft.narrowed[at].least.max(best.reach(draft, at));
        let mut high = useful;
        for _ in 0..TRIALS {
            if high - low <= of(CLOSE, turns) || left == 0 || stop.is_set() {
                break;
            }
            left -= 1;
            let grain = of(GRAIN, turns);
            // At first all that is useful: what was in the way may have been the way things were laid out.
            let middle = if high == useful { useful } else { ((low + high) / 2.0 / grain).round() * grain };
            draft.narrowed[at].least = middle;
            let from_nothing = |draft: &Draft, progress: &mut dyn FnMut(Progress)| {
                if middle == useful { tried(draft, None, stop, progress) } else { None }
            };
            let found = tried(draft, Some(&best.layout), stop, progress).or_else(|| from_nothing(draft, progress));
            match found {
                Some(found) => {
                    best = found;
                    low = best.reach(draft, at).max(middle);
                }
                None => high = middle - grain,
            }
        }
        draft.narrowed[at].least = low.min(useful);
    }
    draft.narrowed.retain(|n| n.least < n.useful);
    Some(best.layout)
}

/// A layout of a draft.
struct Found {
    program: Program,
    layout: Layout,
}

impl Found {
    /// How far what is narrowed opens in it.
    fn reach(&self, draft: &Draft, at: usize) -> f64 {
        let Narrowed { object, turns, .. } = &draft.narrowed[at];
        let motion = if *turns { Motion::Hinge } else { Motion::Slide };
        let id = self.program.objects.iter().position(|o| o.name == *object).map(|at| ObjectId(at as u32));
        let found = id.and_then(|id| reach(&self.program, &self.layout, id, motion, &Judging::default()));
        found.map_or(0.0, |(least, _)| least)
    }
}

/// A layout in which all that must hold does, from another one or from nothing.
fn tried(draft: &Draft, from: Option<&Layout>, stop: &Stop, progress: &mut dyn FnMut(Progress)) -> Option<Found> {
    let judge = Judging::default();
    let compiled = compile_text("room.scene", Path::new("room.scene"), &write(draft), Options::default());
    let has_errors = compiled.has_errors();
    let program = compiled.program.filter(|_| !has_errors)?;
    let start = furnish(&program, scenelang_solve::draws(&program, 0), from, &judge).layout;
    let placed = if from.is_some() { Placed::All } else { Placed::None };
    let layout = trial(&Problem { program: &program, start, placed }, judge, stop, progress)?;
    Some(Found { layout, program })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Tried;
    use crate::rehearse::rehearsed;
    use scenelang_formalize::{Options as Reading, read};
    use scenelang_verify::rules::open;

    /// How the trial of a request ended, its draft, and which objects do not open as far as the program demands.
    fn tried(request: &str) -> (Tried, Draft, Option<Vec<String>>) {
        let mut draft = read(request, &Reading { literal: true }).draft;
        let (end, layout) = rehearsed(&mut draft, &Stop::default(), &mut |_| ());
        let compiled = compile_text("room.scene", Path::new("room.scene"), &write(&draft), Options::default());
        let program = compiled.program.unwrap_or_else(|| panic!("{:?}", compiled.diagnostics));
        let shut = layout.map(|layout| {
            let world = World::<f64>::new(&program, &layout, &Judging::default());
            let ids = (0..program.objects.len() as u32).map(ObjectId);
            let is_shut = |id: &ObjectId| {
                let demands = open::demands(&world, *id);
                demands.iter().any(|(part, _)| open::part(&world, *id, *part).is_ok_and(|truth| !truth.holds))
            };
            ids.filter(is_shut).map(|id| program.objects[id.0 as usize].name.to_string()).collect()
        });
        (end, draft, shut)
    }

    #[test]
    fn what_cannot_open_fully_opens_as_far_as_there_is_room() {
        let (end, draft, shut) = tried("A bedroom, 2.6 by 2.8 m, with a double bed, a wardrobe and a dresser.");
        assert_eq!((end, shut), (Tried::Holds, Some(Vec::new())));
        assert!(!draft.narrowed.is_empty());
        for narrowed in &draft.narrowed {
            assert!(narrowed.least < narrowed.useful, "{narrowed:?}");
            assert!(write(&draft).contains(&narrowed.line()), "{}", write(&draft));
            let told = narrowed.told(&draft);
            assert!(told.ends_with(": the room is 2.6 × 2.8 m"), "{told}");
        }
        assert!(draft.statements.iter().all(|s| !s.relaxed), "nothing was given up: {:?}", draft.statements);
    }

    #[test]
    fn where_there_is_room_nothing_is_narrowed() {
        let (end, draft, _) = tried("A bedroom, 4 by 4 m, with a double bed, a wardrobe and a dresser.");
        assert_eq!((end, draft.narrowed), (Tried::Holds, Vec::new()));
    }

    #[test]
    fn it_is_told_in_plain_words() {
        let mut draft =
            read("A bedroom, 3 by 2.5 m, with two wardrobes and a chest.", &Reading { literal: true }).draft;
        let mut say = |object: &str, turns: bool, least: f64, useful: f64| {
            let narrowed = Narrowed { object: object.to_owned(), turns, least, useful };
            draft.narrowed = vec![narrowed.clone()];
            (narrowed.line(), narrowed.told(&draft))
        };
        for ((object, turns, least, useful), (line, told)) in [
            (
                ("wardrobe[1]", true, 62.0, 90.0),
                ("assert opens(wardrobe[1], 62deg);", "`wardrobe[1]` opens 62° of 90°: the room is 3 × 2.5 m"),
            ),
            (
                ("chest", false, 0.2, 0.35),
                ("assert slides(chest, 0.2);", "the drawers of `chest` open 0.20 m of 0.35 m: the room is 3 × 2.5 m"),
            ),
            (
                ("chest", false, 0.0, 0.35),
                ("assert slides(chest, 0);", "the drawers of `chest` do not open: the room is 3 × 2.5 m"),
            ),
        ] {
            assert_eq!(say(object, turns, least, useful), (line.to_owned(), told.to_owned()));
        }
    }
}
