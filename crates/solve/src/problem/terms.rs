//! The stated constraints as terms: top-level conjunctions taken apart, each with what it touches.
//!
//! A term is small, so that moving one object needs only the terms that read it. The parts of a preference over
//! many objects share its weight: what comes closer to holding is better, though only what holds as a whole counts in the end.

use scenelang_lang::Program;
use scenelang_lang::program::{
    Arg, ConstraintKind, Formula, Node, NodeId, ObjectId, ObjectProperty, RegionId, VariableId,
};
use scenelang_verify::surroundings;

/// A preference that speaks of no more objects than so is one term: each of them concerns most of it.
const FEW: usize = 4;

/// How a term counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Force {
    /// It must hold.
    Hard,
    /// It counts by this weight.
    Soft(f64),
}

/// A part of a constraint that is judged by itself.
#[derive(Clone, Debug)]
pub(crate) struct Term {
    /// The constraint that it is a part of: an index into `Program::constraints`.
    pub constraint: usize,
    /// Hard or soft.
    pub force: Force,
    /// What must hold.
    pub formula: Formula,
    /// Objects that it reads, sorted.
    pub objects: Vec<ObjectId>,
    /// Regions that it reads, sorted.
    pub regions: Vec<RegionId>,
    /// Decision variables that it reads, sorted.
    pub variables: Vec<VariableId>,
    /// Whether it depends on everything that stands around (free space, lines of sight, ways).
    pub sees_all: bool,
    /// Whether it asks for ways over the floor, which cost thousands of times more than anything else.
    pub walks: bool,
    /// Whether it speaks of nothing but sizes.
    pub sizes_only: bool,
}

impl Term {
    /// Whether it must hold.
    pub fn is_hard(&self) -> bool {
        self.force == Force::Hard
    }

    fn new(constraint: usize, force: Force, formula: Formula) -> Self {
        let reads = Reads::of(&formula);
        Self {
            constraint,
            force,
            objects: reads.objects,
            regions: reads.regions,
            variables: reads.variables,
            sees_all: reads.sees_all,
            walks: reads.walks,
            sizes_only: reads.sizes_only,
            formula,
        }
    }
}

/// What a formula depends on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reads {
    /// Objects, sorted.
    pub objects: Vec<ObjectId>,
    /// Regions, sorted.
    pub regions: Vec<RegionId>,
    /// Decision variables, sorted.
    pub variables: Vec<VariableId>,
    sees_all: bool,
    walks: bool,
    sizes_only: bool,
}

impl Reads {
    /// Of a formula.
    pub fn of(formula: &Formula) -> Self {
        let mut reads = Self { objects: formula.objects(), sizes_only: true, ..Self::default() };
        for node in &formula.nodes {
            match node {
                Node::Object(property, _) => reads.sizes_only &= *property == ObjectProperty::Scale,
                Node::Region(_, id) => reads.regions.push(*id),
                Node::SamePolygon(id, _) => reads.regions.push(*id),
                Node::Variable(id) => reads.variables.push(*id),
                Node::BuiltIn(_, args) => {
                    let surroundings = surroundings(formula, node);
                    reads.sizes_only = false;
                    reads.sees_all |= surroundings.is_something();
                    reads.walks |= surroundings.is_path();
                    reads.push_regions(args);
                }
                _ => {}
            }
        }
        reads.sizes_only &= !reads.objects.is_empty();
        reads.regions.sort_unstable();
        reads.regions.dedup();
        reads.variables.sort_unstable();
        reads.variables.dedup();
        reads
    }

    fn push_regions(&mut self, args: &[Arg]) {
        self.regions.extend(args.iter().filter_map(|a| match a {
            Arg::Region(id) => Some(*id),
            _ => None,
        }));
    }
}

/// All terms of a program; pins are none: they are obeyed, not searched for.
pub(crate) fn split(program: &Program) -> Vec<Term> {
    let mut terms = Vec::new();
    for (index, constraint) in program.constraints.iter().enumerate() {
        match constraint.kind {
            ConstraintKind::Assert => {
                let parts = conjuncts(&constraint.formula);
                let part = |root| Term::new(index, Force::Hard, extract(&constraint.formula, root));
                terms.extend(parts.into_iter().map(part));
            }
            ConstraintKind::Prefer { weight } => {
                let mut parts = conjuncts(&constraint.formula);
                if parts.is_empty() || constraint.formula.objects().len() <= FEW {
                    parts = vec![constraint.formula.root];
                }
                let weight = weight / parts.len() as f64;
                let part = |root| Term::new(index, Force::Soft(weight), extract(&constraint.formula, root));
                terms.extend(parts.into_iter().map(part));
            }
            ConstraintKind::Pin => {}
        }
    }
    terms
}

/// The members of the top-level conjunctions of a formula; facts that hold anyway are left out.
fn conjuncts(formula: &Formula) -> Vec<NodeId> {
    let mut open = vec![formula.root];
    let mut found = Vec::new();
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(parts) => open.extend(parts.iter().rev()),
            Node::Truth(true) => {}
            _ => found.push(id),
        }
    }
    found
}

/// The part of a formula that `root` needs, as a formula of its own (without places in the source).
fn extract(formula: &Formula, root: NodeId) -> Formula {
    let needed = scenelang_verify::cone(formula, root);
    let at = |id: NodeId| NodeId(needed.partition_point(|n| *n < id) as u32);
    let nodes = needed.iter().map(|id| formula.node(*id).map_children(at)).collect();
    Formula { nodes, ranges: Vec::new(), root: at(root) }
}
