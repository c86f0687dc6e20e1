//! Numbers that the local search does not look for: sizes of objects that constraints ask for, open regions, and the decision
//! variables that go with them, by damped least squares on what is violated, with slopes from dual numbers.
//!
//! Equations end exact; inequalities end with a little ease.

mod system;

use crate::problem::pose::{Pose, round_turn};
use scenelang_engine::Mirror;
use scenelang_engine::candidate::{Candidate, Change};
use scenelang_lang::program::{ObjectId, RegionId, VariableId, VariableKind};
use scenelang_verify::vector::V3;
use scenelang_verify::{Dual, Number, Scratch, Truth, Value};
use system::System;

/// Unknowns that are differentiated by at a time: two objects on a floor.
const K: usize = 6;
type Slope = Dual<K>;

/// What is to be found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Targets {
    /// Objects: their sizes.
    pub sizes: Vec<ObjectId>,
    /// Regions: place and size.
    pub regions: Vec<RegionId>,
    /// Decision variables.
    pub variables: Vec<VariableId>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Entity {
    Object(ObjectId),
    Region(RegionId),
    Variable(VariableId),
}

/// One number to be found: which of an entity's (position 0–2, extents 6–8; variables 0–2).
#[derive(Clone, Copy, Debug)]
struct Unknown {
    entity: Entity,
    index: usize,
    angle: bool,
}

/// Two worlds to try things in: one of plain numbers, one of slopes.
struct Worlds {
    plain: Mirror<f64>,
    slopes: Mirror<Slope>,
    scratch: (Scratch<f64>, Scratch<Slope>),
}

/// Gives the targets numbers with which what touches them is violated less, if there are such.
pub(crate) fn least_squares(state: &mut Candidate<'_>, targets: &Targets) {
    let unknowns = unknowns(state, targets);
    if unknowns.is_empty() {
        return;
    }
    let (plain, slopes) = (Mirror::of(state.layout()), Mirror::of(state.layout()));
    let mut worlds = Worlds { plain, slopes, scratch: (Scratch::new(), Scratch::new()) };
    let mut system = System::new(state, &mut worlds, unknowns);
    let start = system.values.clone();
    system.solve();
    let (values, unknowns, work) = (system.values, system.unknowns, system.work);
    state.work += work;
    let changes = changes(state, &unknowns, &values);
    if values != start && state.attempt(&changes, -1e-9).is_some() {
        state.keep();
    }
}

/// Which numbers are free.
fn unknowns(state: &Candidate<'_>, targets: &Targets) -> Vec<Unknown> {
    let frame = state.frame;
    let mut list = Vec::new();
    for &id in targets.sizes.iter().filter(|id| !frame.fixed(**id).scale) {
        list.extend((6..9).map(|index| Unknown { entity: Entity::Object(id), index, angle: false }));
    }
    for &id in &targets.regions {
        let pins = frame.region_pins[id.0 as usize];
        let outlined = state.world().region(id).is_ok_and(|r| r.outlined);
        let free = (0..3).filter(|&i| !pins.pos && (i == 1 || !outlined));
        let free = free.chain((6..9).filter(|&i| !pins.scale && (i == 7 || !outlined)));
        list.extend(free.map(|index| Unknown { entity: Entity::Region(id), index, angle: false }));
    }
    for &id in &targets.variables {
        let (count, angle) = match frame.program.variables[id.0 as usize].kind {
            VariableKind::Number => (1, false),
            VariableKind::Degree => (1, true),
            VariableKind::Vector => (3, false),
            VariableKind::Rotation => (3, true),
            VariableKind::Bool => (0, false),
        };
        if state.world().variable(id).is_ok() {
            list.extend((0..count).map(|index| Unknown { entity: Entity::Variable(id), index, angle }));
        }
    }
    list
}

/// Objects that move with an entity: itself, and those whose rules follow it.
fn touched_objects(state: &Candidate<'_>, entity: Entity) -> Vec<ObjectId> {
    let mut list = if let Entity::Object(id) = entity { vec![id] } else { Vec::new() };
    for owner in rules_after(state, entity).iter().map(|&r| state.frame.rules.list[r].owner) {
        if !list.contains(&owner) {
            list.push(owner);
        }
    }
    list
}

/// Rules that follow an entity, in order.
fn rules_after<'a>(state: &Candidate<'a>, entity: Entity) -> &'a [usize] {
    match entity {
        Entity::Object(id) => &state.frame.followers[id.0 as usize],
        Entity::Region(id) => &state.frame.region_followers[id.0 as usize],
        Entity::Variable(id) => &state.frame.variable_followers[id.0 as usize],
    }
}

/// The changes that give unknowns their values.
fn changes(state: &Candidate<'_>, unknowns: &[Unknown], values: &[f64]) -> Vec<Change> {
    let mut list: Vec<Change> = Vec::new();
    for group in unknowns.chunk_by(|a, b| a.entity == b.entity) {
        let start = unknowns.iter().position(|u| u.entity == group[0].entity).unwrap_or(0);
        let values = &values[start..start + group.len()];
        let own = || group.iter().zip(values).map(|(u, v)| (u.index, *v));
        match group[0].entity {
            Entity::Object(id) => list.push(Change::Object(id, with_numbers(&state.pose(id), own()))),
            Entity::Region(id) => list.push(Change::Region(id, with_numbers(&state.region_pose(id), own()))),
            Entity::Variable(id) => {
                let Ok(old) = state.world().variable(id) else { continue };
                let mut parts = numbers(old);
                own().for_each(|(i, v)| parts[i] = v);
                let degree = state.frame.program.variables[id.0 as usize].kind == VariableKind::Degree;
                if degree {
                    parts[0] = round_turn(parts[0]);
                }
                list.push(Change::Variable(id, lift(parts, old)));
            }
        }
    }
    list
}

fn with_numbers(pose: &Pose, numbers: impl Iterator<Item = (usize, f64)>) -> Pose {
    let mut next = *pose;
    for (index, value) in numbers {
        match index {
            0..3 => next.pos[index] = value,
            // Nothing shrinks to nothing.
            _ => next.scale[index - 6] = value.max(0.01),
        }
    }
    next
}

/// The numbers of a variable's value.
fn numbers(value: Value<f64>) -> [f64; 3] {
    match value {
        Value::Number(n) => [n, 0.0, 0.0],
        Value::Vector(v) | Value::Rotation(v) => v.0,
        Value::Truth(_) => [0.0; 3],
    }
}

/// A value like another one, of these numbers.
fn lift<N: Number>(parts: [N; 3], like: Value<f64>) -> Value<N> {
    match like {
        Value::Number(_) => Value::Number(parts[0]),
        Value::Vector(_) => Value::Vector(V3(parts)),
        Value::Rotation(_) => Value::Rotation(V3(parts)),
        Value::Truth(t) => Value::Truth(Truth::discrete(t.holds)),
    }
}
