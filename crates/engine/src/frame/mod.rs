//! What a program demands of every layout, worked out once: terms, rules, how each object is held, who has to do with whom.

pub mod checks;
mod equations;
mod priority;
pub mod rules;
pub mod terms;

use crate::Index;
use rules::{Fixed, RuleSource, Rules, Sets};
use rustc_hash::FxHashMap;
use scenelang_lang::Program;
use scenelang_lang::program::{
    Axis, MountedOn, Node, NodeId, ObjectId, ObjectProperty, Owner, Pinned, Region, RegionId, VariableId,
};
use scenelang_layout::Vec3;
use scenelang_verify::rules::{Scope, Support};
use std::sync::Arc;
use terms::Term;

/// Which properties of a region the program assigns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pins {
    pub pos: bool,
    pub rot: bool,
    pub scale: bool,
}

/// What keeps an object where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// It rests on a floor or on something else.
    Rests,
    /// It hangs on a wall of the region.
    Wall(RegionId),
    /// It hangs from the ceiling of the region.
    Ceiling(RegionId),
    /// It sits in the wall of one region, or in that of two.
    Door(RegionId, Option<RegionId>),
    Container(ObjectId),
    /// It may float.
    Floats,
}

/// What stays the same during a search.
pub struct Frame<'a> {
    pub program: &'a Program,
    /// Its constraints, taken apart.
    pub terms: Vec<Term>,
    /// Where the physical rules apply; `None`: nowhere.
    pub scope: Option<Scope>,
    /// By object.
    pub holds: Vec<Hold>,
    /// By object: which come first in a placement.
    pub priority: Vec<f64>,
    pub region_pins: Vec<Pins>,
    /// What the program fixes of objects, given the rest.
    pub rules: Rules,
    /// By object: rules to be obeyed again when it moves, in order.
    pub followers: Vec<Vec<usize>>,
    /// By region, as `followers`.
    pub region_followers: Vec<Vec<usize>>,
    /// By decision variable, as `followers`.
    pub variable_followers: Vec<Vec<usize>>,
    /// By object: objects that its rules read.
    pub sources: Vec<Vec<ObjectId>>,
    /// By object: whether the program speaks of its tilt; all others stay upright.
    pub tilts: Vec<bool>,
    /// By object: other objects that share a term with it, and how much it has to do with them; greatest first.
    pub related: Vec<Vec<(ObjectId, f64)>>,
    /// By object: other elements of its array.
    pub siblings: Vec<Siblings>,
    /// By object: regions that its terms read.
    pub regions: Vec<Vec<RegionId>>,
    /// From what can change to the terms that read it.
    pub index: Index,
    /// Terms that ask for ways over the floor.
    pub walks: Vec<usize>,
}

impl<'a> Frame<'a> {
    /// Of a program, once it is known which containers are solid boxes and how large things are.
    pub fn new(program: &'a Program, terms: Vec<Term>, scope: Option<Scope>, size: impl Fn(ObjectId) -> Vec3) -> Self {
        let n = program.objects.len();
        let mut region_pins = vec![Pins::default(); program.regions.len()];
        for pin in &program.pins {
            let Owner::Region(id) = pin.owner else { continue };
            let of = &mut region_pins[id.0 as usize];
            match pin.property {
                Pinned::Pos => of.pos = true,
                Pinned::Rot => of.rot = true,
                Pinned::Scale => of.scale = true,
                Pinned::Vertices => {}
            }
        }
        let index = Index::new(program, terms.iter().map(|term| &term.reads));
        let objects = (0..n as u32).map(ObjectId);
        let holds: Vec<Hold> = objects.clone().map(|o| hold(program, scope.as_ref(), o)).collect();
        let priority: Vec<f64> = objects
            .clone()
            .map(|o| priority::of(index.of_object(o).iter().map(|&t| &terms[t]), holds[o.0 as usize], size(o)))
            .collect();
        let rules = equations::add(Rules::new(rules::pins(program), n), program, &terms, &priority);
        let regions = objects.clone().map(|o| regions_of(&terms, index.of_object(o))).collect();
        Self {
            holds,
            priority,
            walks: index.walking().to_vec(),
            index,
            related: related(&terms, n),
            siblings: siblings(program),
            followers: objects.clone().map(|o| rules.after(RuleSource::Object(o))).collect(),
            region_followers: (0..program.regions.len() as u32)
                .map(|r| rules.after(RuleSource::Region(RegionId(r))))
                .collect(),
            variable_followers: variables(program).map(|v| rules.after(RuleSource::Variable(v))).collect(),
            sources: objects.map(|o| rules.sources(o)).collect(),
            tilts: tilts(&terms, &rules, n),
            rules,
            program,
            terms,
            scope,
            region_pins,
            regions,
        }
    }

    /// Leaves an object where it is, whatever the rules say.
    pub fn lock(&mut self, id: ObjectId) {
        let i = id.0 as usize;
        self.rules.fixed[i] = Fixed { pos: [true; 3], rot: true, scale: true };
        self.rules.own[i].clear();
        self.sources[i].clear();
        let rules = &self.rules;
        let lists = self.followers.iter_mut().chain(&mut self.region_followers).chain(&mut self.variable_followers);
        lists.for_each(|list| list.retain(|r| rules.list[*r].owner != id));
    }

    /// All objects.
    pub fn objects(&self) -> impl Iterator<Item = ObjectId> + use<> {
        (0..self.program.objects.len() as u32).map(ObjectId)
    }
    /// What rules set of an object.
    pub fn fixed(&self, id: ObjectId) -> Fixed {
        self.rules.fixed[id.0 as usize]
    }
    /// Whether the search may move or turn an object.
    pub fn is_movable(&self, id: ObjectId) -> bool {
        !self.fixed(id).is_all()
    }
    /// What keeps an object where it is.
    pub fn hold(&self, id: ObjectId) -> Hold {
        self.holds[id.0 as usize]
    }
    /// Whether the program leaves the size or the place of a region open.
    pub fn has_open_regions(&self) -> bool {
        let is_open = |(region, pins): (&Region, &Pins)| !(region.has_vertices || pins.pos && pins.scale);
        std::iter::zip(&self.program.regions, &self.region_pins).any(is_open)
    }
    pub fn name(&self, id: ObjectId) -> &str {
        &self.program.objects[id.0 as usize].name
    }
}

fn hold(program: &Program, scope: Option<&Scope>, id: ObjectId) -> Hold {
    if let Some(door) = program.allow.doors.iter().find(|d| d.object == id) {
        return Hold::Door(door.first, door.second);
    }
    if let Some(mount) = program.allow.mounts.iter().find(|m| m.object == id) {
        return match mount.on {
            MountedOn::Wall => Hold::Wall(mount.region),
            MountedOn::Ceiling => Hold::Ceiling(mount.region),
        };
    }
    let container = program.allow.contents.iter().find(|(content, _)| *content == id).map(|(_, c)| *c);
    match scope.map(|s| s.support(id)) {
        Some(Support::Held) => container.map_or(Hold::Rests, Hold::Container),
        Some(Support::Lifted) => Hold::Floats,
        _ => Hold::Rests,
    }
}

/// Objects whose x or z rotation some hard term reads by itself, or compares with one that is not upright; those that a
/// rule turns so, and those that are turned as one of them is.
fn tilts(terms: &[Term], rules: &Rules, n: usize) -> Vec<bool> {
    let mut found = vec![false; n];
    let mut same = Vec::new();
    for term in terms.iter().filter(|t| t.is_hard()) {
        let nodes = &term.formula.nodes;
        let turned = |id: NodeId| match &nodes[id.0 as usize] {
            Node::Object(ObjectProperty::Rot, object) => Some(*object),
            _ => None,
        };
        for node in nodes {
            let tilted = match node {
                Node::Component(Axis::X | Axis::Z, of) => turned(*of),
                Node::Same(a, b) => {
                    same.extend(turned(*a).zip(turned(*b)));
                    turned(*a).filter(|_| !is_level(nodes, *b)).or(turned(*b).filter(|_| !is_level(nodes, *a)))
                }
                Node::Object(ObjectProperty::Up, object) => Some(*object),
                _ => None,
            };
            if let Some(object) = tilted {
                found[object.0 as usize] = true;
            }
        }
    }
    for rule in rules.list.iter().filter(|rule| rule.sets == Sets::Rot) {
        match rule.formula.root_node() {
            Node::Object(ObjectProperty::Rot, other) => same.push((rule.owner, *other)),
            _ => found[rule.owner.0 as usize] |= !is_level(&rule.formula.nodes, rule.formula.root),
        }
    }
    loop {
        let before = found.iter().filter(|tilts| **tilts).count();
        for (a, b) in same.iter().map(|(a, b)| (a.0 as usize, b.0 as usize)) {
            let either = found[a] || found[b];
            (found[a], found[b]) = (either, either);
        }
        if found.iter().filter(|tilts| **tilts).count() == before {
            return found;
        }
    }
}

/// Whether a rotation is that of something upright, as far as its formula shows. That of an object is its own affair.
fn is_level(nodes: &[Node], id: NodeId) -> bool {
    match &nodes[id.0 as usize] {
        Node::Rotation([x, _, z]) => [x, z].iter().all(|c| nodes[c.0 as usize] == Node::Number(0.0)),
        Node::Object(..) => true,
        _ => false,
    }
}

/// The other objects of an array. All of an array share one list: of 6,000 objects each has 5,999 others.
#[derive(Clone, Debug)]
pub struct Siblings {
    own: ObjectId,
    all: Arc<[ObjectId]>,
}

impl Siblings {
    /// Whether there are no others.
    pub fn is_empty(&self) -> bool {
        self.all.len() <= 1
    }
    /// The others, in the order of the array.
    pub fn iter(&self) -> impl Iterator<Item = &ObjectId> {
        self.all.iter().filter(|o| **o != self.own)
    }
}

fn siblings(program: &Program) -> Vec<Siblings> {
    let mut arrays: FxHashMap<&str, Vec<ObjectId>> = FxHashMap::default();
    for (i, object) in program.objects.iter().enumerate() {
        if let Some((name, _)) = &object.array {
            arrays.entry(name.as_str()).or_default().push(ObjectId(i as u32));
        }
    }
    let arrays: FxHashMap<&str, Arc<[ObjectId]>> = arrays.into_iter().map(|(name, all)| (name, all.into())).collect();
    let nobody: Arc<[ObjectId]> = Arc::default();
    let of = |(i, object): (usize, &scenelang_lang::program::Object)| {
        let all = object.array.as_ref().and_then(|(name, _)| arrays.get(name.as_str()));
        Siblings { own: ObjectId(i as u32), all: all.unwrap_or(&nobody).clone() }
    };
    program.objects.iter().enumerate().map(of).collect()
}

/// Who shares terms with whom. A term of many objects says less about each pair.
fn related(terms: &[Term], n: usize) -> Vec<Vec<(ObjectId, f64)>> {
    let mut weights: Vec<FxHashMap<ObjectId, f64>> = vec![FxHashMap::default(); n];
    for term in terms.iter().filter(|t| t.objects.len() > 1 && !t.walks) {
        let weight = if term.is_hard() { 1.0 } else { 0.2 } / (term.objects.len() - 1) as f64;
        for a in &term.objects {
            for b in term.objects.iter().filter(|b| *b != a) {
                *weights[a.0 as usize].entry(*b).or_default() += weight;
            }
        }
    }
    weights
        .into_iter()
        .map(|of| {
            let mut list: Vec<(ObjectId, f64)> = of.into_iter().collect();
            list.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
            list
        })
        .collect()
}

fn regions_of(terms: &[Term], of: &[usize]) -> Vec<RegionId> {
    // A term of one object says where that one belongs; one of several speaks of their relation.
    let alone = of.iter().filter(|&&t| terms[t].is_hard() && terms[t].objects.len() == 1);
    let mut list: Vec<RegionId> = alone.flat_map(|&t| terms[t].regions.iter().copied()).collect();
    list.sort_unstable();
    list.dedup();
    list
}

/// Variables that regions are made of, or sizes of objects.
pub fn variables_of_sizes(program: &Program) -> Vec<VariableId> {
    let shapes = program.pins.iter().filter(|pin| match pin.owner {
        Owner::Region(_) => true,
        Owner::Object(_) => pin.property == Pinned::Scale,
    });
    let mut found: Vec<VariableId> =
        shapes.flat_map(|pin| &pin.values).flat_map(|formula| crate::Reads::of(formula).variables).collect();
    found.sort_unstable();
    found.dedup();
    found
}

/// All decision variables.
pub fn variables(program: &Program) -> impl Iterator<Item = VariableId> {
    (0..program.variables.len() as u32).map(VariableId)
}
