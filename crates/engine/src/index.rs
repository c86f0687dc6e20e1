//! From what can change to the formulas that it changes: the constraints of a program, or the terms of a search.

use scenelang_lang::program::{Arg, Formula, Node, ObjectId, ObjectProperty, Program, RegionId, VariableId};
use scenelang_verify::{Surroundings, surroundings};

/// What a formula depends on.
#[derive(Clone, Debug, Default)]
pub struct Reads {
    /// Objects, sorted.
    pub objects: Vec<ObjectId>,
    /// Regions, sorted.
    pub regions: Vec<RegionId>,
    /// Decision variables, sorted.
    pub variables: Vec<VariableId>,
    /// Whether it depends on everything that stands around (free space, lines of sight, paths).
    pub sees_all: bool,
    /// Whether it asks for paths over the floor, which cost thousands of times more than anything else.
    pub walks: bool,
    /// Whether it speaks of nothing but sizes.
    pub sizes_only: bool,
}

impl Reads {
    pub fn of(formula: &Formula) -> Self {
        let mut reads = Self { objects: formula.objects(), sizes_only: true, ..Self::default() };
        for node in &formula.nodes {
            match node {
                Node::Object(property, _) => reads.sizes_only &= *property == ObjectProperty::Scale,
                Node::Region(_, id) | Node::SamePolygon(id, _) => reads.regions.push(*id),
                Node::Variable(id) => reads.variables.push(*id),
                Node::BuiltIn(_, args) => {
                    let surroundings = surroundings(formula, node);
                    reads.sizes_only = false;
                    reads.sees_all |= surroundings.is_something();
                    reads.walks |= surroundings.is_path();
                    let region = |arg: &Arg| if let Arg::Region(id) = arg { Some(*id) } else { None };
                    reads.regions.extend(args.iter().filter_map(region));
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
}

/// Formulas, by their numbers, by what they read.
#[derive(Debug)]
pub struct Index {
    objects: Vec<Vec<usize>>,
    regions: Vec<Vec<usize>>,
    variables: Vec<Vec<usize>>,
    seeing: Vec<usize>,
    walking: Vec<usize>,
}

impl Index {
    /// Of formulas of a program, which are numbered as they come.
    pub fn new<'r>(program: &Program, formulas: impl IntoIterator<Item = &'r Reads>) -> Self {
        let mut index = Self {
            objects: vec![Vec::new(); program.objects.len()],
            regions: vec![Vec::new(); program.regions.len()],
            variables: vec![Vec::new(); program.variables.len()],
            seeing: Vec::new(),
            walking: Vec::new(),
        };
        for (i, reads) in formulas.into_iter().enumerate() {
            reads.objects.iter().for_each(|id| index.objects[id.0 as usize].push(i));
            reads.regions.iter().for_each(|id| index.regions[id.0 as usize].push(i));
            reads.variables.iter().for_each(|id| index.variables[id.0 as usize].push(i));
            if reads.walks {
                index.walking.push(i);
            } else if reads.sees_all {
                index.seeing.push(i);
            }
        }
        index
    }

    pub fn of_constraints(program: &Program) -> Self {
        let reads: Vec<Reads> = program.constraints.iter().map(|c| Reads::of(&c.formula)).collect();
        Self::new(program, &reads)
    }

    /// Those that read an object.
    pub fn of_object(&self, id: ObjectId) -> &[usize] {
        &self.objects[id.0 as usize]
    }

    /// Those that read a region.
    pub fn of_region(&self, id: RegionId) -> &[usize] {
        &self.regions[id.0 as usize]
    }

    /// Those that read a decision variable.
    pub fn of_variable(&self, id: VariableId) -> &[usize] {
        &self.variables[id.0 as usize]
    }

    /// Those that depend on everything around, those that ask for paths excepted.
    pub fn seeing(&self) -> &[usize] {
        &self.seeing
    }

    /// Those that ask for paths over the floor.
    pub fn walking(&self) -> &[usize] {
        &self.walking
    }

    /// Those that moving these objects can change, sorted.
    pub fn touched_by(&self, objects: &[ObjectId]) -> Vec<usize> {
        let own = objects.iter().flat_map(|id| self.of_object(*id));
        let mut found: Vec<usize> = own.chain(&self.seeing).chain(&self.walking).copied().collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

/// What judging a formula costs in a program of so many objects, in units of a small comparison.
pub(crate) fn cost(formula: &Formula, objects: usize) -> usize {
    let seen = formula.nodes.iter().map(|node| surroundings(formula, node));
    1 + formula.nodes.len() / 16 + Surroundings::cost(seen, objects)
}
