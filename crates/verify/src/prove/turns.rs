//! Turns that are said to differ by certain angles, all the way round: they must add up to whole turns.

use super::Contradiction;
use crate::tolerances::Options;
use scenelang_lang::program::{
    Arith, Axis, Comparison, ConstraintKind, Formula, Node, NodeId, ObjectId, ObjectProperty, Program, Unit,
};
use std::collections::VecDeque;

/// What rounding may add (degrees).
const ROUNDING: f64 = 1e-6;

/// That the turn of one object, less that of another (or less 0), is an angle.
#[derive(Clone, Copy)]
struct Difference {
    of: ObjectId,
    from: Option<ObjectId>,
    angle: f64,
    statement: usize,
}

/// A contradiction for each statement that closes a circle of turns which is no whole number of turns.
pub(super) fn impossible(program: &Program, options: &Options) -> Vec<Contradiction> {
    let mut known: Vec<Difference> = Vec::new();
    let mut found: Vec<Contradiction> = Vec::new();
    for new in differences(program) {
        let way = way(&known, new.from, Some(new.of));
        if let Some(way) = &way {
            let sum: f64 = way.iter().map(|(edge, back)| if *back { -edge.angle } else { edge.angle }).sum();
            let off = (sum - new.angle).rem_euclid(360.0);
            let tolerance = options.tolerances.angle * (way.len() + 1) as f64 + ROUNDING;
            if off > tolerance && off < 360.0 - tolerance {
                let mut statements: Vec<usize> =
                    way.iter().map(|(edge, _)| edge.statement).chain([new.statement]).collect();
                statements.sort_unstable();
                statements.dedup();
                if !found.iter().any(|other| other.statements.iter().any(|s| statements.contains(s))) {
                    found.push(contradiction(program, statements, (new, way), sum - new.angle));
                }
                continue;
            }
        }
        if way.is_none() {
            known.push(new);
        }
    }
    found
}

fn contradiction(
    program: &Program,
    statements: Vec<usize>,
    (new, way): (Difference, &Vec<(Difference, bool)>),
    sum: f64,
) -> Contradiction {
    let name = |id: Option<ObjectId>| match id {
        Some(id) => format!("`{}`", program.objects[id.0 as usize].name),
        None => "north".to_owned(),
    };
    let mut ends: Vec<String> = vec![name(new.from)];
    ends.extend(way.iter().map(|(edge, back)| name(if *back { edge.from } else { Some(edge.of) })));
    let sum = (sum.abs() * 100.0).round() / 100.0;
    let reason = format!(
        "the turns from {} and back to {} add up to {sum}°, which is not a multiple of 360°",
        ends.join(" to "),
        ends[0]
    );
    let mut definitions: Vec<usize> =
        statements.iter().flat_map(|s| program.constraints[*s].definitions.iter().copied()).collect();
    definitions.sort_unstable();
    definitions.dedup();
    Contradiction { statements, definitions, reason: Some(reason), ..Contradiction::default() }
}

/// The shortest way from one to the other over what is known, each step with whether it goes back.
fn way(known: &[Difference], from: Option<ObjectId>, to: Option<ObjectId>) -> Option<Vec<(Difference, bool)>> {
    let mut reached = vec![(from, None::<(usize, Difference, bool)>)];
    let mut open = VecDeque::from([0]);
    while let Some(at) = open.pop_front() {
        let here = reached[at].0;
        if here == to {
            let (mut steps, mut at) = (Vec::new(), at);
            while let Some((before, edge, back)) = reached[at].1 {
                steps.push((edge, back));
                at = before;
            }
            steps.reverse();
            return Some(steps);
        }
        for edge in known {
            for (start, end, back) in [(edge.from, Some(edge.of), false), (Some(edge.of), edge.from, true)] {
                if start == here && !reached.iter().any(|(known, _)| *known == end) {
                    open.push_back(reached.len());
                    reached.push((end, Some((at, *edge, back))));
                }
            }
        }
    }
    None
}

/// What assertions say of differences of turns, in their conjunctions.
fn differences(program: &Program) -> Vec<Difference> {
    let mut found = Vec::new();
    for (statement, constraint) in program.constraints.iter().enumerate() {
        let formula = &constraint.formula;
        let mut open = if constraint.kind == ConstraintKind::Assert { vec![formula.root] } else { Vec::new() };
        while let Some(id) = open.pop() {
            match formula.node(id) {
                Node::And(parts) => open.extend(parts.iter().rev()),
                Node::Compare(Comparison::Eq, Unit::Degree, a, b) => {
                    let mut sum = Sum::default();
                    if !(sum.add(formula, *a, false) && sum.add(formula, *b, true)) {
                        continue;
                    }
                    sum.turns.retain(|(_, count)| *count != 0);
                    let (of, from, angle) = match sum.turns.as_slice() {
                        [(of, 1)] => (*of, None, -sum.angle),
                        [(of, -1)] => (*of, None, sum.angle),
                        [(of, 1), (from, -1)] => (*of, Some(*from), -sum.angle),
                        [(from, -1), (of, 1)] => (*of, Some(*from), -sum.angle),
                        _ => continue,
                    };
                    found.push(Difference { of, from, angle, statement });
                }
                _ => {}
            }
        }
    }
    found
}

/// A sum of turns, each so many times, and an angle.
#[derive(Default)]
struct Sum {
    turns: Vec<(ObjectId, i32)>,
    angle: f64,
}

impl Sum {
    /// Adds a formula, or takes it away; whether it is made of turns and numbers.
    fn add(&mut self, formula: &Formula, id: NodeId, minus: bool) -> bool {
        match formula.node(id) {
            Node::Number(n) => {
                self.angle += if minus { -n } else { *n };
                true
            }
            Node::Neg(a) => self.add(formula, *a, !minus),
            Node::Arith(Arith::Add, a, b) => self.add(formula, *a, minus) && self.add(formula, *b, minus),
            Node::Arith(Arith::Sub, a, b) => self.add(formula, *a, minus) && self.add(formula, *b, !minus),
            Node::Component(Axis::Y, of) => match formula.node(*of) {
                Node::Object(ObjectProperty::Rot, object) => {
                    let count = if minus { -1 } else { 1 };
                    match self.turns.iter_mut().find(|(known, _)| known == object) {
                        Some((_, own)) => *own += count,
                        None => self.turns.push((*object, count)),
                    }
                    true
                }
                _ => false,
            },
            _ => false,
        }
    }
}
