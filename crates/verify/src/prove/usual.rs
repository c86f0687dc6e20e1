//! What nobody means otherwise, and what `solve` takes for granted: rooms stand unturned with their floors at height 0,
//! things stand upright on a floor, and have their usual sizes, unless the program speaks of it.
//!
//! A program that contradicts itself under this is refuted by it, and the verdict says so. Whatever is taken for granted
//! is decided by the whole program, so that no choice among its statements changes it.

use crate::eval::{cone, objects_of};
use scenelang_lang::library::usual_size;
use scenelang_lang::program::{
    Arith, Axis, BuiltIn, Constraint, ConstraintKind, Formula, Function, Node, NodeId, Object, ObjectId,
    ObjectProperty, Owner, Pinned, Program, RegionId, RegionProperty,
};
use scenelang_lang::roles::role_of;
use scenelang_lang::solids::solid_of;
use std::collections::BTreeSet;

/// A conjunction of more parts is looked at as one.
const MOST_PARTS: usize = 64;
/// The size of what nobody knows anything about (metres).
const UNKNOWN: [f64; 3] = [0.5; 3];

/// What is taken for granted of a program.
#[derive(Clone, Debug)]
pub(crate) struct Usual {
    /// By object: whether it stands upright.
    pub upright: Vec<bool>,
    /// By object: its size (metres), where the program says nothing of it.
    pub size: Vec<Option<[f64; 3]>>,
    /// By object: what it may stand on, beside a floor; nothing is known of what the program says a height of.
    pub carriers: Vec<Option<Vec<ObjectId>>>,
    /// By region: whether it is unturned.
    pub unturned: Vec<bool>,
    /// By region: whether its floor is at height 0, unless that is assigned.
    pub on_the_ground: Vec<bool>,
    /// The region whose middle is taken for the origin of x and z: nothing in the program depends on where that is.
    pub origin: Option<RegionId>,
    /// Whether furniture is solid where that of `solve` is, and has its surface where that has it.
    pub shapes: bool,
}

impl Usual {
    /// What is taken for granted of a program.
    pub fn of(program: &Program) -> Self {
        use RegionProperty::{Ceiling, Center, Floor, Pos, Rot};
        let objects = || (0..program.objects.len() as u32).map(ObjectId);
        let regions = || (0..program.regions.len() as u32).map(RegionId);
        let sized = sizes_said(program);
        let size = |id: ObjectId| (!sized.contains(&id)).then(|| size_of(&program.objects[id.0 as usize]));
        // Of a region that statements relate to others of its kind, or to numbers, nothing is taken for granted.
        let said = |id: RegionId, properties: &[RegionProperty]| {
            let reads = |n: &Node| matches!(n, Node::Region(p, r) if *r == id && properties.contains(p));
            let alone = |c: &&Constraint| c.kind == ConstraintKind::Assert && c.formula.objects().is_empty();
            hard(program).filter(alone).any(|c| c.formula.nodes.iter().any(reads))
        };
        Self {
            upright: upright(program),
            size: objects().map(size).collect(),
            carriers: carriers(program),
            unturned: regions().map(|r| !said(r, &[Rot])).collect(),
            on_the_ground: regions().map(|r| !said(r, &[Pos, Floor, Ceiling, Center])).collect(),
            origin: regions().next().filter(|_| is_relative(program)),
            shapes: true,
        }
    }
}

/// Width and depth of a box about the middle axis of a thing of a size (metres) that is solid whatever asset it gets,
/// and from which to which height above its base that reaches. Nothing is known of most, nor of what has features.
pub fn core_of(object: &Object, size: [f64; 3]) -> Option<([f64; 2], [f64; 2])> {
    let solid = solid_of(what(object), size).filter(|_| object.features.is_empty())?;
    let [w, h, d] = size;
    let plan = [w, d].map(|s| solid.plan.of(s));
    (plan[0].min(plan[1]) > 0.0).then_some((plan, solid.heights.map(|part| part * h)))
}

/// Whether what stands on a thing stands on its top: no asset of its kind declares another surface.
pub(crate) fn carries_on_top(object: &Object) -> bool {
    let known = !object.category.is_empty() || usual_size(what(object)).is_some();
    !known || matches!(role_of(what(object)), "storage" | "appliance" | "table" | "desk" | "counter")
}

fn hard(program: &Program) -> impl Iterator<Item = &Constraint> {
    program.constraints.iter().filter(|c| !matches!(c.kind, ConstraintKind::Prefer { .. }))
}

/// The size that an object gets where the program says nothing of it: that of its category, or of its name.
fn size_of(object: &Object) -> [f64; 3] {
    usual_size(what(object)).unwrap_or(UNKNOWN)
}

/// What an object is: its category, or else what its name says.
fn what(object: &Object) -> &str {
    let name = object.array.as_ref().map_or(object.name.as_str(), |(array, _)| array.as_str());
    if object.category.is_empty() { name } else { &object.category }
}

/// Objects whose size the program assigns, or speaks of by itself.
fn sizes_said(program: &Program) -> BTreeSet<ObjectId> {
    let mut found = BTreeSet::new();
    for Constraint { formula, .. } in hard(program) {
        for part in conjuncts(formula) {
            let nodes: Vec<&Node> = cone(formula, part).into_iter().map(|n| formula.node(n)).collect();
            let of_sizes = |n: &&Node| match n {
                Node::Object(property, _) => *property == ObjectProperty::Scale,
                node => !matches!(node, Node::BuiltIn(..)),
            };
            // Of a whole that is looked at as one nothing is known of its parts.
            if nodes.iter().all(of_sizes) || matches!(formula.node(part), Node::And(_)) {
                found.extend(nodes.iter().filter_map(|n| match n {
                    Node::Object(ObjectProperty::Scale, id) => Some(*id),
                    _ => None,
                }));
            }
        }
    }
    found.extend(program.pins.iter().filter_map(|pin| match (pin.owner, pin.property) {
        (Owner::Object(id), Pinned::Scale) => Some(id),
        _ => None,
    }));
    found
}

/// Whether all of a program means the same wherever it is moved along x and z: places are assigned nowhere, and only
/// compared with, or taken from, others.
fn is_relative(program: &Program) -> bool {
    let placed = program.pins.iter().any(|pin| pin.property == Pinned::Pos);
    !placed && !program.regions.iter().any(|r| r.has_vertices) && program.constraints.iter().all(is_relative_formula)
}

fn is_relative_formula(constraint: &Constraint) -> bool {
    use ObjectProperty::{Center, Max, Min, Pos};
    let formula = &constraint.formula;
    let is_place = |id: NodeId| match formula.node(id) {
        Node::Object(property, _) => matches!(property, Pos | Center | Min | Max),
        Node::Region(property, _) => matches!(property, RegionProperty::Pos | RegionProperty::Center),
        _ => false,
    };
    formula.nodes.iter().all(|node| match node {
        Node::Arith(Arith::Sub, a, b) | Node::Same(a, b) | Node::Compare(_, _, a, b)
            if place_in(formula, *a, &is_place).is_some()
                && place_in(formula, *a, &is_place) == place_in(formula, *b, &is_place) =>
        {
            true
        }
        Node::Call(Function::Distance, points) if points.iter().all(|p| is_place(*p)) => true,
        // Moved by something that is no place it is a place; and from a place to a wall it is as far wherever both are.
        Node::Arith(Arith::Add | Arith::Sub, a, b) if place_in(formula, *a, &is_place) == Some(None) => {
            place_in(formula, *b, &is_place).is_none()
        }
        Node::BuiltIn(BuiltIn::Gap, _) => {
            let mut relative = true;
            node.for_each_child(|child| relative &= place_in(formula, child, &is_place) == Some(None));
            relative
        }
        Node::Component(..) => true,
        Node::SamePolygon(..) => false,
        node => {
            let mut relative = true;
            node.for_each_child(|child| {
                relative &= matches!(place_in(formula, child, &is_place), None | Some(Some(Axis::Y)));
            });
            relative
        }
    })
}

/// Whether a node is a place, moved or not, or which component of one.
fn place_in(formula: &Formula, id: NodeId, is_place: &dyn Fn(NodeId) -> bool) -> Option<Option<Axis>> {
    match formula.node(id) {
        _ if is_place(id) => Some(None),
        Node::Component(axis, of) if place_in(formula, *of, is_place) == Some(None) => Some(Some(*axis)),
        Node::Arith(Arith::Add | Arith::Sub, a, b) => {
            let is_moved = place_in(formula, *a, is_place) == Some(None) && place_in(formula, *b, is_place).is_none();
            is_moved.then_some(None)
        }
        _ => None,
    }
}

/// The members of the top-level conjunctions of a formula; the whole of it where there are many.
fn conjuncts(formula: &Formula) -> Vec<NodeId> {
    let (mut open, mut found) = (vec![formula.root], Vec::new());
    while let Some(id) = open.pop() {
        match formula.node(id) {
            Node::And(parts) => open.extend(parts.iter().copied()),
            _ => found.push(id),
        }
    }
    if found.len() > MOST_PARTS { vec![formula.root] } else { found }
}

/// By object: the others that some formula relates its height to; nothing, where one gives it a height otherwise.
fn carriers(program: &Program) -> Vec<Option<Vec<ObjectId>>> {
    let mut found: Vec<Option<Vec<ObjectId>>> = vec![Some(Vec::new()); program.objects.len()];
    for Constraint { formula, .. } in &program.constraints {
        for part in conjuncts(formula) {
            let nodes = cone(formula, part);
            let objects = objects_of(formula, part);
            for id in heights_read(formula, &nodes) {
                let others: Vec<ObjectId> = objects.iter().copied().filter(|o| *o != id).collect();
                let own = &mut found[id.0 as usize];
                match own {
                    Some(list) if !others.is_empty() => list.extend(others),
                    _ => *own = None,
                }
            }
        }
    }
    for list in found.iter_mut().flatten() {
        list.sort_unstable();
        list.dedup();
    }
    found
}

/// Objects whose height a part of a formula reads: by its name, as a component, or in a place that is to be the same as
/// another. What is multiplied by the height of an axis says nothing of upright things.
fn heights_read(formula: &Formula, nodes: &[NodeId]) -> BTreeSet<ObjectId> {
    use ObjectProperty::{Bottom, Center, Front, Max, Min, Pos, Right, Surface, Top};
    let flat = |id: NodeId| match formula.node(id) {
        Node::Component(Axis::Y, of) => matches!(formula.node(*of), Node::Object(Front | Right, _)),
        _ => false,
    };
    let mut idle: BTreeSet<NodeId> = BTreeSet::new();
    for &id in nodes {
        if let Node::Arith(Arith::Mul, a, b) = formula.node(id)
            && (flat(*a) || flat(*b))
        {
            idle.extend(cone(formula, if flat(*a) { *b } else { *a }));
        }
    }
    let (mut bases, mut tops) = (BTreeSet::new(), BTreeSet::new());
    for &id in nodes.iter().filter(|id| !idle.contains(id)) {
        match formula.node(id) {
            Node::Object(Bottom, object) => drop(bases.insert(*object)),
            Node::Object(Top | Surface, object) => drop(tops.insert(*object)),
            Node::Component(Axis::Y, of) => {
                if let Node::Object(Pos | Center | Min | Max, object) = formula.node(*of) {
                    bases.insert(*object);
                }
            }
            Node::Same(a, b) => {
                let places = [a, b].into_iter().flat_map(|n| cone(formula, *n));
                bases.extend(places.filter_map(|n| match formula.node(n) {
                    Node::Object(Pos | Center | Min | Max, object) => Some(*object),
                    _ => None,
                }));
            }
            _ => {}
        }
    }
    // The top of something on which something else stands is no height of its own.
    tops.retain(|top| !bases.iter().any(|base| base != top));
    bases.extend(tops);
    bases
}

/// Whether each object stands upright: no statement reads its turn about x or z, or its up, or turns it like something
/// that is not level.
fn upright(program: &Program) -> Vec<bool> {
    let mut tilts = vec![false; program.objects.len()];
    let mut same = Vec::new();
    for Constraint { formula, .. } in hard(program) {
        let turned = |id: NodeId| match formula.node(id) {
            Node::Object(ObjectProperty::Rot, object) => Some(*object),
            _ => None,
        };
        for node in &formula.nodes {
            let tilted = match node {
                Node::Component(Axis::X | Axis::Z, of) => turned(*of),
                Node::Same(a, b) => {
                    same.extend(turned(*a).zip(turned(*b)));
                    turned(*a).filter(|_| !is_level(formula, *b)).or(turned(*b).filter(|_| !is_level(formula, *a)))
                }
                Node::Object(ObjectProperty::Up, object) => Some(*object),
                _ => None,
            };
            if let Some(object) = tilted {
                tilts[object.0 as usize] = true;
            }
        }
    }
    loop {
        let before = tilts.iter().filter(|t| **t).count();
        for (a, b) in same.iter().map(|(a, b)| (a.0 as usize, b.0 as usize)) {
            let either = tilts[a] || tilts[b];
            (tilts[a], tilts[b]) = (either, either);
        }
        if tilts.iter().filter(|t| **t).count() == before {
            return tilts.into_iter().map(|t| !t).collect();
        }
    }
}

/// Whether a rotation is that of something upright, as far as its formula shows. That of an object is its own affair.
fn is_level(formula: &Formula, id: NodeId) -> bool {
    match formula.node(id) {
        Node::Rotation([x, _, z]) => [x, z].iter().all(|c| *formula.node(**c) == Node::Number(0.0)),
        Node::Object(..) => true,
        _ => false,
    }
}
