//! What stays the same during a search: terms, pins and their order, how each object is held, who has to do with whom.

use crate::terms::{Reads, Term};
use rustc_hash::FxHashMap;
use scenelang_lang::Program;
use scenelang_lang::program::{
    Axis, MountedOn, Node, NodeId, ObjectId, ObjectProperty, Owner, Pin, Pinned, RegionId, VariableId,
};
use scenelang_verify::rules::{Scope, Support};

/// Which properties of an object or a region the program assigns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Pins {
    /// `pos`.
    pub pos: bool,
    /// `rot`.
    pub rot: bool,
    /// `scale` (or `dimensions`).
    pub scale: bool,
    /// `vertices`.
    pub vertices: bool,
}

/// What keeps an object where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hold {
    /// It rests on a floor or on something else.
    Rests,
    /// It hangs on a wall of the region.
    Wall(RegionId),
    /// It hangs from the ceiling of the region.
    Ceiling(RegionId),
    /// It sits in the wall of one region, or in that of two.
    Door(RegionId, Option<RegionId>),
    /// It is in a container.
    Container(ObjectId),
    /// It may float.
    Floats,
}

/// What stays the same during a search.
pub(crate) struct Frame<'a> {
    /// The program.
    pub program: &'a Program,
    /// Its constraints, taken apart.
    pub terms: Vec<Term>,
    /// Where the physical rules apply; `None`: nowhere.
    pub scope: Option<Scope>,
    /// By object.
    pub holds: Vec<Hold>,
    /// By object.
    pub pins: Vec<Pins>,
    /// By region.
    pub region_pins: Vec<Pins>,
    /// Indices into `Program::pins`, each after those it depends on.
    pub pin_order: Vec<usize>,
    /// By object: its own pins, in order.
    pub own_pins: Vec<Vec<usize>>,
    /// By object: pins that read it, directly or through others, in order: what they fix moves along.
    pub followers: Vec<Vec<usize>>,
    /// By region, as `followers`.
    pub region_followers: Vec<Vec<usize>>,
    /// By decision variable, as `followers`.
    pub variable_followers: Vec<Vec<usize>>,
    /// By object: whether the program speaks of its tilt; all others stay upright.
    pub tilts: Vec<bool>,
    /// By object: objects that its pins read.
    pub sources: Vec<Vec<ObjectId>>,
    /// By object: other objects that share a term with it, and how much it has to do with them; greatest first.
    pub related: Vec<Vec<(ObjectId, f64)>>,
    /// By object: regions that its terms read.
    pub regions: Vec<Vec<RegionId>>,
    /// By object, by region, by variable: the terms that read it.
    pub terms_of: Vec<Vec<usize>>,
    /// See `terms_of`.
    pub terms_of_region: Vec<Vec<usize>>,
    /// See `terms_of`.
    pub terms_of_variable: Vec<Vec<usize>>,
    /// Terms that depend on everything around, ways over the floor excepted.
    pub onlookers: Vec<usize>,
    /// Terms that ask for ways over the floor.
    pub walks: Vec<usize>,
}

impl<'a> Frame<'a> {
    /// Of a program, once it is known which containers are solid boxes.
    pub fn new(program: &'a Program, terms: Vec<Term>, scope: Option<Scope>) -> Self {
        let n = program.objects.len();
        let mut pins = vec![Pins::default(); n];
        let mut region_pins = vec![Pins::default(); program.regions.len()];
        for pin in &program.pins {
            let of = match pin.owner {
                Owner::Object(id) => &mut pins[id.0 as usize],
                Owner::Region(id) => &mut region_pins[id.0 as usize],
            };
            match pin.property {
                Pinned::Pos => of.pos = true,
                Pinned::Rot => of.rot = true,
                Pinned::Scale => of.scale = true,
                Pinned::Vertices => of.vertices = true,
            }
        }
        let mut terms_of = vec![Vec::new(); n];
        let mut terms_of_region = vec![Vec::new(); program.regions.len()];
        let mut terms_of_variable = vec![Vec::new(); program.variables.len()];
        for (index, term) in terms.iter().enumerate() {
            term.objects.iter().for_each(|o| terms_of[o.0 as usize].push(index));
            term.regions.iter().for_each(|r| terms_of_region[r.0 as usize].push(index));
            term.variables.iter().for_each(|v| terms_of_variable[v.0 as usize].push(index));
        }
        let pin_order = pin_order(program);
        let follow = Follow::new(program);
        let objects = (0..n as u32).map(ObjectId);
        let regions = (0..n).map(|o| regions_of(&terms, &terms_of[o])).collect();
        Self {
            holds: (0..n).map(|i| hold(program, scope.as_ref(), ObjectId(i as u32))).collect(),
            onlookers: (0..terms.len()).filter(|&t| terms[t].sees_all && !terms[t].walks).collect(),
            walks: (0..terms.len()).filter(|&t| terms[t].walks).collect(),
            related: related(&terms, n),
            followers: objects.clone().map(|o| follow.after(&pin_order, Read::Object(o))).collect(),
            region_followers: (0..program.regions.len() as u32)
                .map(|r| follow.after(&pin_order, Read::Region(RegionId(r))))
                .collect(),
            variable_followers: variables(program).map(|v| follow.after(&pin_order, Read::Variable(v))).collect(),
            own_pins: objects.clone().map(|o| pins_of(program, &pin_order, o)).collect(),
            sources: objects.map(|o| follow.sources(o)).collect(),
            tilts: tilts(&terms, n),
            program,
            terms,
            scope,
            pins,
            region_pins,
            pin_order,
            regions,
            terms_of,
            terms_of_region,
            terms_of_variable,
        }
    }

    /// All objects.
    pub fn objects(&self) -> impl Iterator<Item = ObjectId> + use<> {
        (0..self.program.objects.len() as u32).map(ObjectId)
    }
    /// Whether the search may move or turn an object.
    pub fn is_movable(&self, id: ObjectId) -> bool {
        let pins = self.pins[id.0 as usize];
        !(pins.pos && pins.rot)
    }
    /// What keeps an object where it is.
    pub fn hold(&self, id: ObjectId) -> Hold {
        self.holds[id.0 as usize]
    }
    /// The name of an object.
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

/// Pins in an order in which each comes after those whose owner it reads.
fn pin_order(program: &Program) -> Vec<usize> {
    let mut of: FxHashMap<Owner, Vec<usize>> = FxHashMap::default();
    for (index, pin) in program.pins.iter().enumerate() {
        of.entry(pin.owner).or_default().push(index);
    }
    let before = |pin: &Pin| -> Vec<usize> {
        let mut list = Vec::new();
        for reads in pin.values.iter().map(Reads::of) {
            let owners = reads.objects.into_iter().map(Owner::Object);
            let owners = owners.chain(reads.regions.into_iter().map(Owner::Region));
            list.extend(owners.filter_map(|o| of.get(&o)).flatten().copied());
        }
        list
    };
    let mut order = Vec::with_capacity(program.pins.len());
    let mut state = vec![0u8; program.pins.len()];
    // Depth first, without recursion. A circle of properties is an error of the front end; one of owners only (a.rot
    // reads b.pos, b.pos reads a.pos) is broken where it closes.
    for start in 0..program.pins.len() {
        let mut stack = vec![(start, false)];
        while let Some((pin, done)) = stack.pop() {
            if done {
                order.push(pin);
                state[pin] = 2;
            } else if state[pin] == 0 {
                state[pin] = 1;
                stack.push((pin, true));
                stack.extend(before(&program.pins[pin]).into_iter().filter(|&b| state[b] == 0).map(|b| (b, false)));
            }
        }
    }
    order
}

fn pins_of(program: &Program, order: &[usize], id: ObjectId) -> Vec<usize> {
    order.iter().copied().filter(|&p| program.pins[p].owner == Owner::Object(id)).collect()
}

/// Something that a pin can read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Read {
    Object(ObjectId),
    Region(RegionId),
    Variable(VariableId),
}

/// What pins read.
struct Follow {
    /// By pin.
    reads: Vec<Vec<Read>>,
    owners: Vec<Owner>,
}

impl Follow {
    fn new(program: &Program) -> Self {
        let reads = program.pins.iter().map(|pin| {
            let reads = pin.values.iter().map(Reads::of);
            let each = reads.flat_map(|r| {
                let objects = r.objects.into_iter().map(Read::Object);
                let regions = r.regions.into_iter().map(Read::Region);
                objects.chain(regions).chain(r.variables.into_iter().map(Read::Variable)).collect::<Vec<_>>()
            });
            each.collect()
        });
        Self { reads: reads.collect(), owners: program.pins.iter().map(|p| p.owner).collect() }
    }

    /// Pins that must be set again when something changes, in order.
    fn after(&self, order: &[usize], start: Read) -> Vec<usize> {
        let mut changed = vec![start];
        let mut list = Vec::new();
        for &pin in order {
            if self.reads[pin].iter().any(|r| changed.contains(r)) {
                changed.push(match self.owners[pin] {
                    Owner::Object(id) => Read::Object(id),
                    Owner::Region(id) => Read::Region(id),
                });
                list.push(pin);
            }
        }
        list
    }

    /// Other objects that the pins of one read.
    fn sources(&self, id: ObjectId) -> Vec<ObjectId> {
        let own = (0..self.owners.len()).filter(|&p| self.owners[p] == Owner::Object(id));
        let mut list: Vec<ObjectId> = own
            .flat_map(|p| &self.reads[p])
            .filter_map(|r| match r {
                Read::Object(o) if *o != id => Some(*o),
                _ => None,
            })
            .collect();
        list.sort_unstable();
        list.dedup();
        list
    }
}

/// Objects whose x or z rotation some hard term reads by itself, or compares with one that is not upright.
fn tilts(terms: &[Term], n: usize) -> Vec<bool> {
    let mut found = vec![false; n];
    for term in terms.iter().filter(|t| t.is_hard()) {
        let nodes = &term.formula.nodes;
        let turned = |id: NodeId| match &nodes[id.0 as usize] {
            Node::Object(ObjectProperty::Rot, object) => Some(*object),
            _ => None,
        };
        let level = |id: NodeId| match &nodes[id.0 as usize] {
            Node::Rotation([x, _, z]) => [x, z].iter().all(|c| nodes[c.0 as usize] == Node::Number(0.0)),
            Node::Object(..) => true,
            _ => false,
        };
        for node in nodes {
            let tilted = match node {
                Node::Component(Axis::X | Axis::Z, of) => turned(*of),
                Node::Same(a, b) => turned(*a).filter(|_| !level(*b)).or(turned(*b).filter(|_| !level(*a))),
                Node::Object(ObjectProperty::Up, object) => Some(*object),
                _ => None,
            };
            if let Some(object) = tilted {
                found[object.0 as usize] = true;
            }
        }
    }
    found
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

/// All decision variables.
pub(crate) fn variables(program: &Program) -> impl Iterator<Item = VariableId> {
    (0..program.variables.len() as u32).map(VariableId)
}
