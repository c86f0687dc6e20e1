//! A line at which things are made or packed: workplaces in a row along their conveyor, who works there on the other side of them
//! with the parts behind, and a table at the end.

use super::floor::Pose;
use super::formation::{Ground, Piece, dress, put};
use super::plan::Plan;
use super::stand;
use crate::brief::Group;
use crate::draft::{Statement, ThingOrigin};
use crate::names::mentions;

/// Between the conveyor and the workplaces, and between these and the seats (metres).
const BESIDE: f64 = 0.05;
const DRAWN_UP: f64 = 0.1;
/// Behind the seats, before what stands there (metres).
const BEHIND: f64 = 0.35;
/// Between the end of the conveyor and what stands there (metres).
const END: f64 = 0.08;
/// Around the whole, and at the ends of a room that is as long as its line (metres).
const AROUND: f64 = 0.7;
const WHY: &str = "workplaces stand along their conveyor";

/// A line that is asked for.
struct Line {
    conveyor: usize,
    places: usize,
    seats: Option<usize>,
    behind: Option<usize>,
    /// What stands at its ends, at its own right (1) or left (-1).
    ends: Vec<(usize, f64)>,
}

/// Whether it is said of two things, or of the elements of them.
fn says(plan: &Plan, call: &str, a: usize, b: usize) -> bool {
    let [a, b] = [a, b].map(|at| plan.draft.things[at].name.clone());
    let of = [format!("{call}({a}[i], {b}[i])"), format!("{call}({a}, {b})"), format!("{call}(a, {b})")];
    let about = |s: &Statement| matches!(s.source, ThingOrigin::Stated(_)) && mentions(&s.text, &a);
    plan.draft.statements.iter().any(|s| about(s) && of.iter().any(|said| s.text.contains(said.as_str())))
}

fn line(plan: &Plan) -> Option<Line> {
    let here = |at: &usize| plan.draft.things[*at].room == Some(plan.room);
    let all: Vec<usize> = (0..plan.draft.things.len()).filter(here).collect();
    let is_conveyor = |category: &str| category.ends_with("conveyor") || category.ends_with("belt");
    let conveyor = all.iter().copied().find(|at| {
        let thing = &plan.draft.things[*at];
        thing.count == 1 && is_conveyor(&thing.category)
    })?;
    let places = all.iter().copied().find(|at| {
        let thing = &plan.draft.things[*at];
        let row = !thing.formation.is_empty() && thing.formation.iter().all(|[_, z, yaw]| *z == 0.0 && *yaw == 0.0);
        row && stand::group(&thing.category) == Group::Table && says(plan, "inFrontOf", *at, conveyor)
    })?;
    let n = plan.draft.things[places].count;
    let each = |call: &str, of: usize| {
        all.iter().copied().find(|at| plan.draft.things[*at].count == n && *at != of && says(plan, call, *at, of))
    };
    let seats = each("inFrontOf", places);
    let behind = seats.and_then(|seats| each("behind", seats));
    let single = |at: &usize| plan.draft.things[*at].count == 1 && *at != conveyor;
    let ends = all.iter().copied().filter(single).filter_map(|at| {
        let left = says(plan, "seenLeftOf", at, conveyor).then_some(1.0);
        let right = || says(plan, "seenRightOf", at, conveyor).then_some(-1.0);
        left.or_else(right).map(|side| (at, side))
    });
    Some(Line { conveyor, places, seats, behind, ends: ends.collect() })
}

/// Gives a line its place. What finds none stands where such things do.
pub fn stand_up(plan: &mut Plan) {
    let Some(line) = line(plan) else { return };
    let size = |at: usize| plan.draft.things[at].size;
    let (Some(belt), Some(place)) = (size(line.conveyor), size(line.places)) else { return };
    let row = plan.draft.things[line.places].formation.clone();
    let along = row.iter().map(|[x, ..]| *x).fold(0.0, f64::max);
    let usual = Plan::size(&plan.draft.things[line.conveyor].category.replace('_', " "));
    let long = if belt == usual { belt[0].max(along + place[0]) } else { belt[0] };
    let mut pieces = vec![Piece { thing: line.conveyor, element: None, at: Pose::default() }];
    let mut blocks = vec![(Pose::default(), [long, belt[1], belt[2]])];
    let mut depth = belt[2] / 2.0;
    let rows = [(Some(line.places), BESIDE, 0.0), (line.seats, DRAWN_UP, 180.0), (line.behind, BEHIND, 0.0)];
    for (thing, gap, yaw) in rows {
        let Some((thing, own)) = thing.and_then(|thing| Some((thing, size(thing)?))) else { continue };
        let z = depth + gap + own[2] / 2.0;
        for (i, [x, ..]) in row.iter().enumerate() {
            let at = Pose { x: x - along / 2.0, z, yaw, ..Pose::default() };
            pieces.push(Piece { thing, element: Some(i), at });
            blocks.push((at, own));
        }
        depth = z + own[2] / 2.0;
    }
    for (thing, side) in &line.ends {
        let Some(own) = size(*thing) else { continue };
        let x = side * (long / 2.0 + END + own[2] / 2.0);
        let at = Pose { x, yaw: if *side > 0.0 { 90.0 } else { 270.0 }, ..Pose::default() };
        pieces.push(Piece { thing: *thing, element: None, at });
        blocks.push((at, own));
    }
    plan.draft.things[line.conveyor].size = Some([long, belt[1], belt[2]]);
    let ground = Ground::around(&blocks, AROUND);
    if !put(plan, &pieces, ground, (&[0.0], false), WHY) {
        plan.draft.things[line.conveyor].size = Some(belt);
        plan.lacking += pieces.len();
        return;
    }
    let carry: Vec<usize> = std::iter::once(line.places).chain(line.ends.iter().map(|(thing, _)| *thing)).collect();
    dress(plan, &carry);
}
