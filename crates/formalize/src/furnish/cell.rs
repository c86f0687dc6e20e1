//! A robot cell: the robot stands inside its fence with what it picks from and puts on at its sides, within its reach; the gate is
//! in the fence, and who controls it stands outside.

use super::floor::Pose;
use super::formation::{Ground, Piece, dress, put};
use super::plan::{Plan, metres};
use super::{FENCED, stand};
use crate::draft::{DraftThing, Statement, ThingOrigin};
use crate::names::mentions;

/// Between the robot and what is beside it (metres).
const REACH: f64 = 0.15;
/// Between what is in the fence and the fence, and between the fence and what is outside (metres).
const INSIDE: f64 = 0.35;
const OUTSIDE: f64 = 0.06;
/// Before the robot at least, where one comes in (metres).
const BEFORE: f64 = 0.9;
/// The gap that a fence has in its front, the thickness of it and of a gate (metres).
const GAP: f64 = 0.88;
const THICK: f64 = 0.05;
/// Around the fence so much is free (metres).
const AROUND: f64 = 0.7;
const WHY: &str = "a robot stands in its fence with what it reaches";

/// A cell that is asked for.
struct Cell {
    robot: usize,
    fence: usize,
    /// What the robot reaches.
    beside: Vec<usize>,
    gate: Option<usize>,
    outside: Option<usize>,
}

fn is_fence(thing: &DraftThing) -> bool {
    ["fence", "cage", "enclosure"].iter().any(|fence| thing.category.ends_with(fence))
}

/// What is said of two things.
fn says(plan: &Plan, a: usize, b: usize, calls: &[&str]) -> bool {
    let [a, b] = [a, b].map(|at| plan.draft.things[at].name.clone());
    let about = |s: &Statement| matches!(s.source, ThingOrigin::Stated(_)) && mentions(&s.text, &b);
    plan.draft.statements.iter().any(|s| about(s) && calls.iter().any(|call| s.text.contains(&format!("{call}({a},"))))
}

/// The cell of a room that has one robot and one fence.
fn cell(plan: &Plan) -> Option<Cell> {
    let here = |at: &usize| plan.draft.things[*at].room == Some(plan.room) && plan.draft.things[*at].count == 1;
    let all: Vec<usize> = (0..plan.draft.things.len()).filter(here).collect();
    let one = |is: &dyn Fn(&DraftThing) -> bool| {
        let mut found = all.iter().copied().filter(|at| is(&plan.draft.things[*at]));
        found.next().filter(|_| found.next().is_none())
    };
    let robot = one(&|thing| stand::are_kin("robot arm", &thing.category.replace('_', " ")))?;
    let fence = one(&is_fence)?;
    let others = || all.iter().copied().filter(|at| *at != robot && *at != fence);
    let is_gate = |at: &usize| plan.draft.things[*at].category.ends_with("gate");
    let near = ["beside", "near", "seenLeftOf", "seenRightOf", "leftOf", "rightOf", "inside"];
    let beside: Vec<usize> = others()
        .filter(|at| {
            !is_gate(at) && says(plan, *at, robot, &near) && stand::on_floor(plan.draft, &plan.draft.things[*at])
        })
        .collect();
    let gate = others().find(is_gate);
    let outside = others().find(|at| !is_gate(at) && says(plan, *at, fence, &["beside"]) && !beside.contains(at));
    (!beside.is_empty() && beside.len() <= 3).then_some(Cell { robot, fence, beside, gate, outside })
}

/// Gives a cell its place. What finds none stands where such things do.
pub fn stand_up(plan: &mut Plan) {
    let Some(cell) = cell(plan) else { return };
    let size = |plan: &Plan, at: usize| plan.draft.things[at].size;
    let Some([wide, high, deep]) = size(plan, cell.robot) else { return };
    let mut pieces = vec![Piece { thing: cell.robot, element: None, at: Pose::default() }];
    let mut blocks = vec![(Pose::default(), [wide, high, deep])];
    let mut free = vec![-1.0, 1.0, 0.0];
    for thing in &cell.beside {
        let Some([w, h, d]) = size(plan, *thing) else { return };
        let said = match () {
            () if says(plan, *thing, cell.robot, &["seenLeftOf", "rightOf"]) => 1.0,
            () if says(plan, *thing, cell.robot, &["seenRightOf", "leftOf"]) => -1.0,
            () => free[0],
        };
        let side = if free.contains(&said) { said } else { free[0] };
        free.retain(|other| *other != side);
        // The long side is along the robot; a third one is behind it.
        let at = match side {
            0.0 => Pose { z: -(deep / 2.0 + REACH + d / 2.0), ..Pose::default() },
            side => Pose { x: side * (wide / 2.0 + REACH + d / 2.0), yaw: 90.0, ..Pose::default() },
        };
        pieces.push(Piece { thing: *thing, element: None, at });
        blocks.push((at, [w, h, d]));
    }
    let Some(fence) = fenced(plan, cell.fence, &blocks) else { return };
    let at = Pose { z: fence.1, ..Pose::default() };
    let [fw, fh, fd] = fence.0;
    let before = plan.draft.things[cell.fence].size;
    plan.draft.things[cell.fence].size = Some(fence.0);
    pieces.push(Piece { thing: cell.fence, element: None, at });
    let mut taken = vec![(at, fence.0)];
    if let Some(gate) = cell.gate {
        plan.draft.things[gate].size = Some([GAP, fh, THICK]);
        let at = Pose { z: fence.1 + (fd - THICK) / 2.0, ..Pose::default() };
        pieces.push(Piece { thing: gate, element: None, at });
    }
    if let Some(outside) = cell.outside
        && let Some([w, h, d]) = size(plan, outside)
    {
        let z = fence.1 + fd / 2.0 - w / 2.0 - INSIDE;
        let at = Pose { x: fw / 2.0 + OUTSIDE + d / 2.0, z, yaw: 90.0, ..Pose::default() };
        pieces.push(Piece { thing: outside, element: None, at });
        taken.push((at, [w, h, d]));
    }
    let robot = &plan.draft.things[cell.robot].name;
    let centred = plan.draft.statements.iter().any(|s| s.text.contains(&format!("centeredIn({robot},")));
    let ground = Ground::around(&taken, AROUND);
    if !put(plan, &pieces, ground, (&[180.0, 0.0, 90.0, 270.0], centred), WHY) {
        plan.draft.things[cell.fence].size = before;
        plan.lacking += pieces.len();
        return;
    }
    in_fence(plan, &cell);
    dress(plan, &cell.beside);
}

/// The size of a fence around blocks, and how far its middle is before the robot: as large as is said, else as they need.
fn fenced(plan: &Plan, fence: usize, blocks: &[(Pose, [f64; 3])]) -> Option<([f64; 3], f64)> {
    let inner = Ground::around(blocks, INSIDE + THICK);
    let [w, high, d] = plan.draft.things[fence].size?;
    let (middle, [across, _, along]) = inner.free;
    let across = across + 2.0 * middle.x.abs();
    let robot = blocks[0].1[2] / 2.0;
    let inferred = matches!(&plan.draft.things[fence].source, ThingOrigin::Inferred(why) if why == FENCED);
    if !inferred && d >= super::slots::THIN {
        // The robot is in the middle of a fence of which the size is said.
        let deep = 2.0 * (along / 2.0 + middle.z.abs());
        return (w >= across && d >= deep).then_some(([w, high.max(1.2), d], 0.0));
    }
    let ahead = (middle.z + along / 2.0).max(robot + BEFORE);
    let behind = along / 2.0 - middle.z;
    let round = |v: f64| (v * 20.0).ceil() / 20.0;
    Some(([round(across), high.max(1.8), round(ahead + behind)], (ahead - behind) / 2.0))
}

/// A gate is in its fence, not beside it, and a fence around a robot is as far from it as its middle is from its sides.
fn in_fence(plan: &mut Plan, cell: &Cell) {
    let Some([w, _, d]) = plan.draft.things[cell.fence].size else { return };
    let name = |at: usize| plan.draft.things[at].name.clone();
    let (fence, robot, gate) = (name(cell.fence), name(cell.robot), cell.gate.map(name));
    for statement in &mut plan.draft.statements {
        let with = |name: &str| mentions(&statement.text, name) && mentions(&statement.text, &fence);
        if !matches!(statement.source, ThingOrigin::Stated(_)) {
            continue;
        }
        if let Some(gate) = gate.as_ref().filter(|gate| with(gate)) {
            statement.text = format!("near({gate}, {fence}, 0.1)");
        } else if with(&robot) && statement.text.starts_with("near(") {
            statement.text = format!("near({fence}, {robot}, {})", metres(w.max(d) / 2.0));
        }
    }
}
