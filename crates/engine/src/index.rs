//! Which stated rows speak of an object: moving it can change these, and what looks at everything.

use scenelang_lang::program::{ObjectId, Program};
use scenelang_verify::{Surroundings, surroundings};

/// Rows by the objects they mention.
#[derive(Debug)]
pub struct Index {
    /// By [`ObjectId`], sorted: indices of constraints.
    rows: Vec<Vec<u32>>,
    /// Constraints that see whatever stands around: ways, lines of sight, free space.
    seeing: Vec<u32>,
    /// By constraint: what judging it costs, in units of a small comparison.
    cost: Vec<usize>,
}

impl Index {
    /// Of a program.
    pub fn new(program: &Program) -> Self {
        let mut index = Self {
            rows: vec![Vec::new(); program.objects.len()],
            seeing: Vec::new(),
            cost: Vec::with_capacity(program.constraints.len()),
        };
        for (i, constraint) in program.constraints.iter().enumerate() {
            let i = i as u32;
            for id in constraint.formula.objects() {
                index.rows[id.0 as usize].push(i);
            }
            let nodes = &constraint.formula.nodes;
            let seen = || nodes.iter().map(|node| surroundings(&constraint.formula, node));
            if seen().any(|s| s.is_something()) {
                index.seeing.push(i);
            }
            index.cost.push(1 + nodes.len() / 16 + Surroundings::cost(seen(), program.objects.len()));
        }
        index
    }

    /// The constraints that moving these objects can change, sorted.
    pub fn touched_by(&self, objects: &[ObjectId]) -> Vec<usize> {
        let own = objects.iter().flat_map(|id| &self.rows[id.0 as usize]);
        let mut found: Vec<usize> = own.chain(&self.seeing).map(|i| *i as usize).collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Whether a constraint speaks of an object.
    pub fn mentions(&self, object: ObjectId, constraint: usize) -> bool {
        self.rows[object.0 as usize].binary_search(&(constraint as u32)).is_ok()
    }

    /// What judging a constraint costs.
    pub fn cost(&self, constraint: usize) -> usize {
        self.cost[constraint]
    }
}
