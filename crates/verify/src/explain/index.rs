//! Which stated rows speak of an object: moving it can change these, and what looks at everything.

use scenelang_lang::program::{Formula, Measure, Native, Node, ObjectId, Program};

/// Rows by the objects they mention.
#[derive(Debug)]
pub(crate) struct Index {
    /// By [`ObjectId`], sorted: indices of constraints.
    rows: Vec<Vec<u32>>,
    /// Constraints that see whatever stands around: ways, lines of sight, free space.
    seeing: Vec<u32>,
    /// By constraint: what judging it costs, in units of a small comparison.
    cost: Vec<usize>,
}

/// What a floor costs on which ways are looked for, in comparisons: at least, and per object on it.
const FLOOR: usize = 250;
const FLOOR_PER_OBJECT: usize = 25;
/// What each way on it costs.
const WAY: usize = 60;

impl Index {
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
            let (walks, looks) = seen(&constraint.formula);
            if walks + looks > 0 {
                index.seeing.push(i);
            }
            let walking = if walks > 0 { FLOOR.max(FLOOR_PER_OBJECT * program.objects.len()) + walks * WAY } else { 0 };
            let looking = looks * program.objects.len() / 8;
            index.cost.push(1 + constraint.formula.nodes.len() / 16 + walking + looking);
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

/// How many nodes of a formula ask for ways, and how many look at all objects in another way.
fn seen(formula: &Formula) -> (usize, usize) {
    let (mut walks, mut looks) = (0, 0);
    for node in &formula.nodes {
        match node {
            Node::Native(Native::Reachable, _) | Node::Measure(Measure::WalkDistance, _) => walks += 1,
            Node::Native(Native::Clear | Native::Visible, _) => looks += 1,
            _ => {}
        }
    }
    (walks, looks)
}
