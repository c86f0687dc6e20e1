//! A program of stage I, tried by stage III before it is handed out: what a reader or a model wrote may be more than a
//! room can take, or mean something that the words did not. What the search finds in the way becomes a preference.

use crate::furnish::furnish;
use crate::narrow::{narrow, narrow_all, widened};
use crate::refute::give_up_refuted;
use scenelang_formalize::draft::{Demand, Statement, ThingOrigin};
use scenelang_formalize::prefer::Stated;
use scenelang_formalize::write::write;
use scenelang_formalize::{Draft, Reading, arrange_rooms, overfull};
use scenelang_lang::program::{Constraint, ConstraintKind, ObjectId, Program};
use scenelang_lang::{Options, compile_text};
use scenelang_layout::{Layout, Vec3};
use scenelang_solve::{End, Outcome, Placed, Problem, Progress, Stop, TermSubject, solve};
use scenelang_verify::prove::WORK;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;

/// How often a program is tried.
const ROUNDS: usize = 12;
/// Work that a trial may take: at least, and for each object. A tenth of what the solver takes by itself.
const TRIAL: [u64; 2] = [6_000_000, 400_000];
/// How often what is proved impossible is given up before a trial.
const PROOFS: usize = 24;
/// How much more a trial from nothing may take once there is a layout.
const PATIENCE: u64 = 3;
/// Work after which no other trial begins: some six seconds of it, where it is not interrupted.
const MOST: u64 = 300_000_000;
/// Of what is violated in the best layout, where the search can name nothing better, one in so many is given up at a time.
const PART: usize = 3;
/// How often a room grows whose size nobody gave, and by how much.
const TIMES: usize = 3;
const GROWTH: f64 = 1.15;
/// How often all rooms whose size nobody gave are larger, and furnished anew.
const ROOMIER: usize = 3;
/// How often some of what was added is left out, before all of it is.
const PATIENT: usize = 6;
/// With more objects than this a room is not searched for a second time to put back what was left out.
const REFILLED: usize = 60;
/// Why a statement became a preference.
const REASON: &str =
    "no layout was found that satisfies it together with the other statements, so it became a preference";

/// How a trial ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tried {
    /// A layout was found in which all holds that must.
    Holds,
    /// None was found.
    Fails,
    /// None was found within the work that a trial may take.
    Spent,
    /// None was looked for: what is asked for does not fit on a floor, as [`overfull`] says.
    Overfull,
}

/// Tries the program of a draft, and gives up what is in the way.
pub fn rehearse(draft: &mut Draft, stop: &Stop, progress: &mut dyn FnMut(Progress)) -> Tried {
    rehearsed(draft, stop, progress).0
}

/// The same with the layout, where one was found from the places that the draft has for its things. It stands up to all
/// that must hold, and who lays out the program may begin with it.
pub(crate) fn rehearsed(draft: &mut Draft, stop: &Stop, progress: &mut dyn FnMut(Progress)) -> (Tried, Option<Layout>) {
    if overfull(draft).is_some() {
        return (Tried::Overfull, None);
    }
    match planned(&plain(draft), stop, progress) {
        Some(layout) => (Tried::Holds, Some(layout)),
        None => reduced(draft, stop, progress),
    }
}

/// The same of a request that was read. Where furniture was added and there is no layout with all of it, rooms whose size nobody
/// gave are made larger before any of it is left out.
pub fn rehearse_reading(
    reading: &mut Reading,
    stop: &Stop,
    progress: &mut dyn FnMut(Progress),
) -> (Tried, Option<Layout>) {
    if overfull(&reading.draft).is_some() {
        return (Tried::Overfull, None);
    }
    if let Some(layout) = planned(&plain(&reading.draft), stop, progress) {
        return (Tried::Holds, Some(layout));
    }
    for times in 1..=ROOMIER {
        let Some(larger) = reading.roomier(times).filter(|_| !stop.is_set()) else { break };
        if overfull(&larger.draft).is_none()
            && let Some(layout) = planned(&plain(&larger.draft), stop, progress)
        {
            *reading = larger;
            return (Tried::Holds, Some(layout));
        }
    }
    reduced(&mut reading.draft, stop, progress)
}

/// A draft without the guidelines: preferences have no part in whether there is a layout.
fn plain(draft: &Draft) -> Draft {
    Draft { guided: false, ..draft.clone() }
}

/// Gives up what is in the way of a layout.
fn reduced(draft: &mut Draft, stop: &Stop, progress: &mut dyn FnMut(Progress)) -> (Tried, Option<Layout>) {
    let guided = std::mem::take(&mut draft.guided);
    let whole = draft.clone();
    let end = searched(draft, stop, progress);
    let mut layout = None;
    if end == Tried::Holds {
        if let Some((fuller, found)) = refilled(&whole, draft, stop, progress) {
            (*draft, layout) = (fuller, found);
        }
        // What opens just so far is found again from here, and hardly from nothing.
        layout = layout.or_else(|| widened(draft, stop, progress));
    }
    if end != Tried::Holds {
        // It was of no use.
        draft.narrowed.clear();
    }
    draft.guided = guided;
    (end, layout)
}

/// Where something that was said could not hold even in an emptier room, what was added was not in its way: the whole draft
/// without that, if less has to be left out of it; with the layout, if it was found from the places that it has.
fn refilled(
    whole: &Draft,
    emptied: &Draft,
    stop: &Stop,
    progress: &mut dyn FnMut(Progress),
) -> Option<(Draft, Option<Layout>)> {
    let left_out = |draft: &Draft| draft.left_out.iter().map(|(_, count)| count).sum::<usize>();
    if left_out(emptied) == left_out(whole) || stop.is_set() {
        return None;
    }
    let given_up = |stated: &Statement| {
        let is_it = |s: &Statement| s.relaxed && s.text == stated.text && s.source == stated.source;
        let was_said = stated.demand == Demand::Must && matches!(stated.source, ThingOrigin::Stated(_));
        was_said && emptied.statements.iter().any(is_it)
    };
    let statements = whole.statements.iter().enumerate().filter(|(_, s)| given_up(s)).map(|(i, _)| i).collect();
    let mut again = whole.clone();
    if !again.prefer(statements, REASON) {
        return None;
    }
    if let Some(layout) = planned(&again, stop, progress) {
        return Some((again, Some(layout)));
    }
    // What is large was searched for long already.
    let objects: usize = again.things.iter().map(|thing| thing.count.max(1)).sum();
    let holds = objects <= REFILLED && searched(&mut again, stop, progress) == Tried::Holds;
    (holds && left_out(&again) < left_out(emptied)).then_some((again, None))
}

/// The layout that comes of the places that the draft has for its things, with what has none placed among them.
fn planned(draft: &Draft, stop: &Stop, progress: &mut dyn FnMut(Progress)) -> Option<Layout> {
    if draft.places.is_empty() || stop.is_set() {
        return None;
    }
    let judge = scenelang_verify::Options::default();
    let compiled = compile_text("room.scene", Path::new("room.scene"), &write(draft), Options::default());
    let program = compiled.program.as_ref().filter(|_| !compiled.has_errors())?;
    let mut start = furnish(program, scenelang_solve::draws(program, 0), None, &judge).layout;
    let places: BTreeMap<&str, [f64; 4]> = draft.places.iter().map(|(name, place)| (name.as_str(), *place)).collect();
    let mut objects = Vec::new();
    for (i, (name, placement)) in start.objects.iter_mut().enumerate() {
        if let Some([x, y, z, yaw]) = places.get(name.as_str()) {
            (placement.pos, placement.rot) = (Vec3::new(*x, *y, *z), Vec3::new(0.0, *yaw, 0.0));
            objects.push(ObjectId(i as u32));
        }
    }
    let problem = Problem { program, start, placed: Placed::Some { objects, regions: Vec::new() } };
    trial(&problem, judge, stop, progress)
}

/// The layout in which all that must hold does, if one is found within the budget of a trial.
pub fn trial(
    problem: &Problem<'_>,
    judge: scenelang_verify::Options,
    stop: &Stop,
    progress: &mut dyn FnMut(Progress),
) -> Option<Layout> {
    let [least, each] = TRIAL;
    let options = scenelang_solve::Options {
        budget: least + each * problem.program.objects.len() as u64,
        polish: 0.0,
        diagnose: false,
        stop: stop.clone(),
        judge,
        ..Default::default()
    };
    let outcome = solve(problem, &options, &mut |now| {
        progress(now);
        ControlFlow::Continue(())
    });
    outcome.converged.then_some(outcome.layout)
}

/// Searches for a layout from nothing.
fn searched(draft: &mut Draft, stop: &Stop, progress: &mut dyn FnMut(Progress)) -> Tried {
    let judge = scenelang_verify::Options::default();
    // From where the next trial begins: less is asked of it, so little has to move.
    let mut last = None;
    let mut grown = vec![0; draft.rooms.len()];
    let (mut spent, mut patience, mut left_out) = (0, 1, 0);
    prove_first(draft, stop, &mut grown);
    for _ in 0..ROUNDS + PATIENT {
        let compiled = compile_text("room.scene", Path::new("room.scene"), &write(draft), Options::default());
        let Some(program) = compiled.program.as_ref().filter(|_| !compiled.has_errors()) else { return Tried::Fails };
        let start = furnish(program, scenelang_solve::draws(program, 0), last.as_ref(), &judge).layout;
        let [least, each] = TRIAL;
        let options = scenelang_solve::Options {
            budget: patience * (least + each * program.objects.len() as u64),
            polish: 0.0,
            // What was added is given up without a look at what exactly is in the way.
            diagnose: left_out > PATIENT || !draft.has_additions(),
            stop: stop.clone(),
            judge,
            ..Default::default()
        };
        let placed = if last.is_some() { Placed::All } else { Placed::None };
        let problem = Problem { program, start, placed };
        let outcome = solve(&problem, &options, &mut |now| {
            progress(now);
            ControlFlow::Continue(())
        });
        if outcome.converged {
            if last.take().is_none() {
                return Tried::Holds;
            }
            // Whoever solves it begins from nothing.
            patience = PATIENCE;
            continue;
        }
        spent += outcome.work;
        if outcome.end == End::Asked {
            return Tried::Fails;
        }
        if spent > MOST {
            return Tried::Spent;
        }
        // What was added goes before anything that was asked for.
        let groups = at_odds(program, &outcome);
        let groups: Vec<Vec<String>> = groups.into_iter().map(|group| with_fixed(draft, group)).collect();
        if left_out < PATIENT && draft.leave_out(&groups) {
            left_out += 1;
            last = None;
            continue;
        }
        if left_out == PATIENT && draft.leave_out_all() {
            // Of what is left more can be proved with the same work.
            prove_first(draft, stop, &mut grown);
            left_out += 1;
            last = None;
            continue;
        }
        if enlarge(draft, &crowded(draft, program, &outcome), &mut grown) {
            last = None;
            continue;
        }
        if squeeze(draft, program, &outcome) {
            last = Some(outcome.layout);
            continue;
        }
        // Before that, all that was added is out of the way.
        if (left_out > PATIENT || !draft.has_additions()) && narrow(draft, program, &outcome, &judge) {
            last = Some(outcome.layout);
            continue;
        }
        if let_out(draft, program, &outcome) {
            last = Some(outcome.layout);
            continue;
        }
        // The rest of what was added may be in the way where no statement says so.
        if left_out <= PATIENT && draft.leave_out_all() {
            prove_first(draft, stop, &mut grown);
            left_out = PATIENT + 1;
            last = None;
            continue;
        }
        if !give_up(draft, program, &outcome, &judge) {
            return Tried::Fails;
        }
        last = Some(outcome.layout);
    }
    Tried::Spent
}

/// Gives up what is proved impossible, one proof after the other.
fn prove_first(draft: &mut Draft, stop: &Stop, grown: &mut [usize]) {
    for _ in 0..PROOFS {
        let mut work = WORK;
        if stop.is_set() {
            return;
        }
        let compiled = compile_text("room.scene", Path::new("room.scene"), &write(draft), Options::default());
        let Some(program) = compiled.program.as_ref().filter(|_| !compiled.has_errors()) else { return };
        if !give_up_refuted(draft, program, stop, grown, &mut work) {
            return;
        }
    }
}

/// Gives up what is in the way. Whether there was anything.
fn give_up(draft: &mut Draft, program: &Program, outcome: &Outcome, judge: &scenelang_verify::Options) -> bool {
    let given_up = in_the_way(draft, program, outcome);
    // Furniture opens less far before anything is given up that was said, or that it stands on the floor.
    let dear = |i: &usize| {
        let statement = &draft.statements[*i];
        matches!(statement.source, ThingOrigin::Stated(_)) || statement.text.contains("onFloor(")
    };
    let last_resort = given_up.is_empty() || given_up.iter().any(dear);
    last_resort && narrow_all(draft, program, outcome, judge) || draft.prefer(given_up, REASON)
}

/// What is in each other's way: the things and openings of each violated rule or statement.
fn at_odds(program: &Program, outcome: &Outcome) -> Vec<Vec<String>> {
    let owned = |name: &str| base(name).to_owned();
    let of = |c: usize| -> Vec<String> {
        let objects = program.constraints[c].formula.objects();
        objects.iter().map(|o| owned(&program.objects[o.0 as usize].name)).collect()
    };
    let mut groups: Vec<Vec<String>> = Vec::new();
    for each in &outcome.unsatisfied {
        groups.push(match &each.what {
            TermSubject::Stated(c) if program.constraints[*c].kind == ConstraintKind::Assert => of(*c),
            TermSubject::Stated(_) => continue,
            TermSubject::Collision(a, b) => vec![owned(a), owned(b)],
            TermSubject::Bounds(a) | TermSubject::Support(a) => vec![owned(a)],
            TermSubject::Open(a, met) => std::iter::once(a).chain(met).map(|name| owned(name)).collect(),
        });
    }
    if groups.is_empty() {
        groups.extend(outcome.in_the_way.iter().map(|c| of(*c)));
    }
    groups
}

/// Some names, and those of what was added at a fixed place beside them: a nightstand is in the way of a corner for its bed.
pub fn with_fixed(draft: &Draft, mut group: Vec<String>) -> Vec<String> {
    let of = |name: &str, text: &str| text.split(|c: char| !(c.is_alphanumeric() || c == '_')).any(|word| word == name);
    let own = group.clone();
    for statement in draft.statements.iter().filter(|s| s.text.contains(".pos = ")) {
        if own.iter().any(|name| of(name, &statement.text)) {
            let things = draft.things.iter().filter(|t| of(&t.name, &statement.text));
            group.extend(things.map(|t| t.name.clone()));
        }
    }
    group
}

/// Rooms in which something finds no place: it stands in the way of another, or not in its room.
fn crowded(draft: &Draft, program: &Program, outcome: &Outcome) -> Vec<usize> {
    let stated = Stated::new(draft, program);
    let mut names: Vec<&str> = Vec::new();
    for each in &outcome.unsatisfied {
        match &each.what {
            TermSubject::Stated(c) => {
                let constraint = &program.constraints[*c];
                if constraint.kind == ConstraintKind::Assert && stated.of(*c).is_none() {
                    names.extend(
                        constraint.formula.objects().iter().map(|o| program.objects[o.0 as usize].name.as_str()),
                    );
                }
            }
            TermSubject::Collision(a, b) => names.extend([a.as_str(), b]),
            TermSubject::Bounds(a) | TermSubject::Support(a) => names.push(a),
            TermSubject::Open(a, met) => names.extend(std::iter::once(a).chain(met).map(|name| name.as_str())),
        }
    }
    let kinds: Vec<&str> = names.into_iter().map(base).collect();
    let mut rooms: Vec<usize> = draft
        .things
        .iter()
        .filter(|thing| kinds.contains(&thing.name.as_str()))
        .filter_map(|thing| thing.room)
        .collect();
    rooms.sort_unstable();
    rooms.dedup();
    rooms
}

/// Makes those of the rooms larger whose size nobody gave. Whether there were any.
pub fn enlarge(draft: &mut Draft, rooms: &[usize], grown: &mut [usize]) -> bool {
    if draft.rooms.iter().any(|room| room.outline.is_some()) {
        return false;
    }
    let mut any = false;
    for &at in rooms {
        let Some((room, times)) = draft.rooms.get_mut(at).zip(grown.get_mut(at)) else { continue };
        if !room.sized && *times < TIMES {
            *times += 1;
            for k in [0, 2] {
                room.size[k] = (room.size[k] * GROWTH * 10.0).ceil() / 10.0;
            }
            any = true;
        }
    }
    if any {
        arrange_rooms(draft);
    }
    any
}

/// Lets doors open less freely, where nobody asked for the space that they lack. Whether there was such a door.
fn squeeze(draft: &mut Draft, program: &Program, outcome: &Outcome) -> bool {
    let violated = outcome.unsatisfied.iter().filter_map(|u| match u.what {
        TermSubject::Stated(constraint) => Some(constraint),
        _ => None,
    });
    let mut any = false;
    for constraint in violated.map(|c| &program.constraints[c]).filter(|c| c.kind == ConstraintKind::Assert) {
        any |= squeeze_door(draft, program, constraint);
    }
    any
}

/// The same for a statement, where it is that a door opens freely.
pub fn squeeze_door(draft: &mut Draft, program: &Program, constraint: &Constraint) -> bool {
    match &constraint.formula.objects()[..] {
        [object] if constraint.text.contains("clear(") => draft.squeeze(&program.objects[object.0 as usize].name),
        _ => false,
    }
}

/// Lets things out of their rooms where the search names that as what is in the way. Whether there was such a thing.
fn let_out(draft: &mut Draft, program: &Program, outcome: &Outcome) -> bool {
    let stated = Stated::new(draft, program);
    let mut any = false;
    for &index in outcome.in_the_way.iter().filter(|c| stated.of(**c).is_none()) {
        let constraint = &program.constraints[index];
        if let ([object, ..], true) = (&constraint.formula.objects()[..], constraint.text.contains("inside(")) {
            any |= draft.let_out(base(&program.objects[object.0 as usize].name));
        }
    }
    any
}

/// The name of an array, of a member of it.
pub fn base(name: &str) -> &str {
    name.split('[').next().unwrap_or(name)
}

/// Statements of the draft to give up: what the search names; else some of what is violated; else one that speaks of what
/// violates a physical rule.
fn in_the_way(draft: &Draft, program: &Program, outcome: &Outcome) -> Vec<usize> {
    let stated = Stated::new(draft, program);
    if !outcome.in_the_way.is_empty() {
        return outcome.in_the_way.iter().filter_map(|c| instead(draft, program, &stated, *c)).collect();
    }
    let mut violated = Vec::new();
    let mut names = Vec::new();
    for each in &outcome.unsatisfied {
        match &each.what {
            TermSubject::Stated(c) => violated.extend(stated.rank(draft, *c).zip(stated.of(*c))),
            TermSubject::Collision(a, b) => names.extend([a, b]),
            TermSubject::Bounds(a) | TermSubject::Support(a) => names.push(a),
            TermSubject::Open(a, met) => names.extend(std::iter::once(a).chain(met)),
        }
    }
    if !violated.is_empty() {
        violated.sort_unstable_by(|a, b| b.cmp(a));
        violated.truncate(violated.len().div_ceil(PART));
        return violated.into_iter().map(|(_, statement)| statement).collect();
    }
    let troubled = |id: ObjectId| names.iter().any(|n| **n == program.objects[id.0 as usize].name);
    most_willing(draft, program, &stated, &|objects| objects.iter().any(|o| troubled(*o))).into_iter().collect()
}

/// The statement that a constraint is; where it is none that could be given up, as that a thing is in its room, one that
/// speaks of the same thing and of another.
fn instead(draft: &Draft, program: &Program, stated: &Stated, constraint: usize) -> Option<usize> {
    stated.of(constraint).or_else(|| {
        let own = program.constraints[constraint].formula.objects();
        let shares = |objects: &[ObjectId]| objects.iter().any(|o| own.contains(o));
        let with_others = |objects: &[ObjectId]| objects.len() > 1 && shares(objects);
        most_willing(draft, program, stated, &with_others).or_else(|| most_willing(draft, program, stated, &shares))
    })
}

/// Of the statements that speak of such objects, the one that is given up most willingly.
fn most_willing(
    draft: &Draft,
    program: &Program,
    stated: &Stated,
    speaks: &dyn Fn(&[ObjectId]) -> bool,
) -> Option<usize> {
    let speaking = (0..program.constraints.len()).filter(|c| speaks(&program.constraints[*c].formula.objects()));
    speaking.filter_map(|c| Some((stated.rank(draft, c)?, stated.of(c)?))).max().map(|(_, statement)| statement)
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_formalize::draft::Demand;
    use scenelang_formalize::{Options, read};

    fn tried(request: &str) -> (bool, Draft) {
        let mut draft = read(request, &Options { literal: true }).draft;
        let holds = rehearse(&mut draft, &Stop::default(), &mut |_| ());
        (holds == Tried::Holds, draft)
    }

    #[test]
    fn what_has_a_layout_stays_as_it_is() {
        let request = "A study, 4 by 3 m, with a desk, a chair in front of the desk and a shelf against the wall.";
        let (holds, draft) = tried(request);
        assert!(holds);
        assert_eq!(draft, read(request, &Options { literal: true }).draft);
    }

    #[test]
    fn what_finds_no_place_becomes_a_wish_and_the_rest_holds() {
        let (holds, draft) = tried(
            "A bedroom, 3.8 by 3 m, with a bed, 2 by 1.8 m, two wardrobes, each 2 m wide, and 1 m clear in front of each \
             wardrobe and 1 m clear in front of the bed.",
        );
        assert!(holds);
        let preferences: Vec<&str> =
            draft.statements.iter().filter(|s| s.demand == Demand::Prefer).map(|s| s.text.as_str()).collect();
        assert!(preferences.iter().any(|w| w.contains("clear(")), "{preferences:?}");
        assert!(draft.notes.iter().any(|note| note.reason == REASON), "{:?}", draft.notes);
    }

    #[test]
    fn a_room_grows_for_what_is_in_it_unless_its_size_was_said() {
        let things =
            "with a billiard table, 2.9 by 1.6 m, a sofa, a wardrobe, a piano and 2 m clear in front of the sofa";
        let (holds, draft) = tried(&format!("A games room {things}."));
        assert!(holds, "{draft:?}");
        let (_, fixed) = tried(&format!("A games room, 3 by 2 m, {things}."));
        assert_eq!([fixed.rooms[0].size[0], fixed.rooms[0].size[2]], [3.0, 2.0]);
    }

    /// In a room whose size nobody gave, all that is asked for holds with all furniture, in a larger room if need be.
    #[test]
    fn a_room_grows_before_its_furniture_is_left_out() {
        for request in [
            "A kitchen with an island in the center.",
            "A bedroom with a wardrobe opposite the bed.",
            "A bedroom with a bed under the window.",
            "An office with a desk against the window.",
            "A living room with a sofa against the window.",
            "A living room with a lamp in each corner.",
            "A study with a desk facing the window.",
            "A living room with a TV above the fireplace.",
        ] {
            let mut reading = read(request, &Options::default());
            let (end, layout) = rehearse_reading(&mut reading, &Stop::default(), &mut |_| ());
            assert!(end == Tried::Holds && layout.is_some(), "{request}");
            let draft = &reading.draft;
            assert!(draft.left_out.is_empty(), "{request}: {:?}", draft.left_out);
            assert!(draft.notes.iter().all(|note| note.reason != REASON), "{request}: {:?}", draft.notes);
        }
    }

    #[test]
    fn a_door_opens_less_freely_before_what_was_said_is_given_up() {
        let request = "A hallway, 1 by 1.2 m. It has a door. There is a cupboard, 90 cm wide, 40 cm deep and 2 m high.";
        let untried = write(&read(request, &Options { literal: true }).draft);
        let (holds, draft) = tried(request);
        assert!(holds && untried.contains("and clear(door, front, 0.95)"), "{untried}");
        assert!(write(&draft).contains("prefer clear(door, front, 0.95)"), "{}", write(&draft));
        assert!(draft.notes.iter().all(|note| note.reason != REASON), "{:?}", draft.notes);
    }

    #[test]
    fn what_was_added_goes_before_anything_that_was_asked_for() {
        let request =
            "A bedroom with a king-size bed in the corner of the room, two large armchairs, and a floor lamp.";
        let mut draft = read(request, &Options::default()).draft;
        assert_eq!(rehearse(&mut draft, &Stop::default(), &mut |_| ()), Tried::Holds);
        let demanded = |s: &&Statement| s.demand == Demand::Must;
        let corner = draft.statements.iter().filter(demanded).any(|s| s.text.contains("inCorner(kingSizeBed"));
        assert!(corner, "{}", write(&draft));
    }

    #[test]
    fn who_does_not_want_to_wait_gets_what_was_read() {
        let stop = Stop::default();
        stop.set();
        let mut draft = read("A hall with a bench.", &Options::default()).draft;
        let before = draft.clone();
        rehearse(&mut draft, &stop, &mut |_| ());
        assert_eq!(draft, before);
    }
}
