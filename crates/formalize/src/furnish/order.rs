//! In which order what is asked for gets its place: what hangs at a place of its own, what stands on its own, what goes with
//! something of the inventory, and last what stands on things.

use super::asked::is_island;
use super::inventory::{TEAM, has_seats};
use super::kinds::{Count, Line, PlanPlace};
use super::plan::Plan;
use super::room::{MATTER, tables};
use super::{hang, stand, tops};
use crate::brief::Group;
use crate::draft::{DraftThing, ThingOrigin};

/// What children play on.
pub(super) const PLAY_MAT: &str = "play_mat";
/// What has its place before the tables around it.
pub(super) const DANCE_FLOOR: &str = "dance floor";
/// More seats than this are for guests.
const WAITING: usize = 3;

/// Indices of the things that are asked for.
pub struct Order {
    /// What hangs where such rooms have it.
    pub boards: Vec<usize>,
    /// What has its place before the inventory.
    pub first: Vec<usize>,
    /// What has its place after the first two lines of the inventory: tables in the middle of a kitchen.
    pub later: Vec<usize>,
    /// What hangs wherever a wall is free.
    pub hung: Vec<usize>,
    /// What goes with something of the inventory.
    pub waiting: Vec<usize>,
    /// What stands on things.
    pub small: Vec<usize>,
    /// Whether there are many tables, or one to play at: they leave the place where such rooms have their counter.
    many_tables: bool,
    /// Whether there are many seats, which leave that place, too.
    many_seats: bool,
}

impl Order {
    /// The order of things that are asked for.
    pub fn of(plan: &Plan, asked: Vec<usize>) -> Self {
        type Both = (Vec<usize>, Vec<usize>);
        let (small, asked): Both = asked.into_iter().partition(|at| tops::waits(plan, *at));
        let hangs = |at: &usize| hang::waits(plan, *at);
        let (with_asked, asked): Both = asked.into_iter().partition(|at| plan.waits_for_asked(*at) && !hangs(at));
        let (waiting, asked): Both = asked.into_iter().partition(|at| plan.waits_for_inventory(*at) && !hangs(at));
        let (hung, asked): Both = asked.into_iter().partition(|at| hang::waits(plan, *at));
        let (boards, hung): Both = hung.into_iter().partition(|at| hang::has_place(plan, *at));
        // One sits before a fire, on what is asked for or on the sofa of such rooms.
        let is_fire = |at: &usize| plan.draft.things[*at].category.ends_with("fireplace");
        let (mut fires, asked): Both = asked.into_iter().partition(is_fire);
        let (mut later, mut first): Both = asked.into_iter().partition(|at| is_later(plan, *at));
        // A wall of books takes the longest wall; a mat to play on lies near the toys; a team that works around a sofa moves
        // aside for it.
        let plays = |at: &usize| plan.draft.things[*at].category == PLAY_MAT;
        let is_lounge = |at: &usize| plan.is_team() && plan.draft.things[*at].category.ends_with("sofa");
        // A mirror hangs or stands near the fitting room that is asked for after it.
        let is_beside = |at: &usize| waits_for_neighbour(plan, *at);
        // What belongs at a window has no other place.
        let is_lit = |at: &usize| plan.draft.things[*at].category.replace('_', " ").starts_with(stand::AT_WINDOW);
        // A dance floor has its place before the tables, in front of the stage.
        let dances = |at: &usize| match plan.draft.things[*at].category.as_str() {
            "stage" => 0,
            category if category.replace('_', " ") == DANCE_FLOOR => 1,
            _ => 2,
        };
        let has_dance = first.iter().any(|at| dances(at) == 1);
        let dances = |at: &usize| if has_dance { dances(at) } else { 0 };
        let key =
            |at: &usize| (plays(at), is_beside(at), dances(at), !is_lit(at), !is_wall_of(plan, *at), !is_lounge(at));
        first.sort_by_key(key);
        let many = |at: &usize| {
            let thing = &plan.draft.things[*at];
            thing.count > 2 && tables(&thing.category) || stand::played_at(&thing.category).is_some()
        };
        let many_tables = first.iter().any(many);
        // Nobody waits beside the receptionist.
        let sits = |at: &usize| {
            let thing = &plan.draft.things[*at];
            thing.count > WAITING && stand::group(&thing.category) == Group::Seat
        };
        let many_seats = first.iter().any(sits);
        // In a library one sits at the fire, which has its place first.
        if with_asked.iter().any(|at| fires.iter().any(|fire| plan.goes_with(*at, *fire))) {
            first.append(&mut fires);
        }
        if later.is_empty() {
            first.extend(with_asked)
        } else {
            later.extend(with_asked)
        }
        later.sort_by_key(|at| !is_island(&plan.draft.things[*at].category));
        later.extend(fires);
        Self { boards, first, later, hung, waiting, small, many_tables, many_seats }
    }

    /// The lines of the inventory that come before what is asked for.
    pub fn early(&self, plan: &Plan) -> Vec<&'static Line> {
        // So do shelves along all walls; who serves has a place before goods take the walls.
        let is_stock = |thing: &DraftThing| thing.count > 1 && stand::group(&thing.category) == Group::Storage;
        let is_wall = self.first.iter().any(|at| is_wall_of(plan, *at) || is_stock(&plan.draft.things[*at]));
        let before_tables = if self.many_tables || self.many_seats || is_wall { MATTER } else { 0 };
        let lines = plan.kind.lines.iter().enumerate();
        let early = lines.filter(|(at, line)| match line.place {
            PlanPlace::Before(_, 180.0) | PlanPlace::Service(_) => *at < before_tables,
            // What stands at the edge of a balcony stands before its railing.
            PlanPlace::Edge => true,
            _ => false,
        });
        early.map(|(_, line)| line).collect()
    }
}

/// Whether such rooms have a thing near another one that is asked for, too.
fn waits_for_neighbour(plan: &Plan, at: usize) -> bool {
    let thing = &plan.draft.things[at];
    let noun = thing.category.replace('_', " ");
    let by = plan.kind.lines.iter().find(|line| stand::counts_as(line.noun, &noun)).map_or("", |line| line.by);
    let is_there = |other: &DraftThing| {
        other.room == Some(plan.room)
            && matches!(other.source, ThingOrigin::Stated(_))
            && other.category.replace('_', " ").ends_with(by)
    };
    !by.is_empty() && plan.draft.things.iter().any(is_there)
}

/// Whether these are so many shelves side by side that they make a wall.
fn is_wall_of(plan: &Plan, at: usize) -> bool {
    const WALL: usize = 3;
    let thing = &plan.draft.things[at];
    thing.count >= WALL && stand::is_unit(&thing.category.replace('_', " "), thing.count)
}

/// Whether something at which people sit leaves the walls to what stands there, the table of a kitchen to its cupboards, that
/// of an office to the desks, seats to wait on to the places at which a hairdresser works; or whether it is watched from a
/// seat, which has its place before.
fn is_later(plan: &Plan, at: usize) -> bool {
    let first = plan.kind.lines.first();
    let at_walls = first.is_some_and(|line| matches!(line.place, PlanPlace::Wall | PlanPlace::Run));
    let at_desks = first.is_some_and(|line| {
        matches!(line.count, Count::People(_)) && line.noun.ends_with("desk") && plan.people.is_some_and(|n| n >= TEAM)
    });
    let noun = plan.draft.things[at].category.replace('_', " ");
    let is_watched = plan.kind.lines.iter().any(|line| {
        matches!(line.place, PlanPlace::Opposite(_)) && stand::counts_as(line.noun, &noun) && !plan.is_placed(at)
    });
    // An island stands before the worktops.
    let own = plan.kind.lines.iter().position(|line| stand::counts_as(line.noun, &noun));
    let is_run = |line: &Line| line.place == PlanPlace::Run && matches!(line.count, Count::People(_));
    let waits = stand::group(&noun) == Group::Seat
        && own.is_some_and(|own| own > 1)
        && plan.kind.lines.iter().take(2).any(is_run)
        && !plan.is_placed(at);
    is_watched || waits || at_walls && is_island(&noun) || (at_walls || at_desks) && has_seats(plan, &noun)
}
