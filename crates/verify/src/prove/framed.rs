//! Things as one of them sees them. What statements say of things and rooms among themselves is the same wherever all of them
//! stand and whichever way they are turned together. So a thing may be taken to be unturned, instead of the rooms, where
//! nothing but such statements counts: what contradicts itself then does so for every turn of that thing.
//!
//! That needs things to be upright, so it is looked at only where things are taken as usual.

use super::minimal::Prover;
use super::usual::Usual;
use super::{Contradiction, ProveOptions, WORK};
use crate::rules::Scope;
use crate::world::World;
use scenelang_base::TextRange;
use scenelang_lang::program::{
    Arg, Arith, Axis, BuiltIn, Comparison, Constraint, ConstraintKind, Formula, Function, Node, NodeId, ObjectId,
    ObjectProperty, Owner, Pin, Pinned, Program, RegionId, RegionProperty, Unit,
};
use std::collections::{BTreeMap, BTreeSet};

/// So many things are taken as the one that sees the others: first those of which most is said.
const MOST: usize = 8;
/// The part of the work that one of them may take; where there is more work than usual, all of them share twice that.
const ONE: u64 = 16;

/// Sets of statements that cannot hold together, as one of the things sees them.
pub(super) fn contradictions(program: &Program, options: &ProveOptions) -> Vec<Contradiction> {
    let hard = |c: &Constraint| !matches!(c.kind, ConstraintKind::Prefer { .. });
    let stated = program.constraints.iter().enumerate().filter(|(_, c)| hard(c));
    let relative: Vec<Relative> = stated.filter_map(|(index, c)| Relative::of(index, c)).collect();
    let turned: BTreeSet<ObjectId> = program.pins.iter().filter_map(turned).collect();
    // By thing: of how many statements the verdict depends on how it is turned.
    let mut read: BTreeMap<ObjectId, usize> = BTreeMap::new();
    for object in relative.iter().flat_map(|statement| oriented(&statement.formula)) {
        *read.entry(object).or_default() += 1;
    }
    let mut seeing: Vec<(ObjectId, usize)> = read.into_iter().filter(|(id, _)| !turned.contains(id)).collect();
    seeing.sort_by_key(|(id, count)| (std::cmp::Reverse(*count), *id));
    seeing.truncate(MOST);
    let dear = options.work > WORK;
    let work = if dear { 2 * options.work / seeing.len().max(1) as u64 } else { options.work / ONE };
    let options = &ProveOptions { work, redundant: false, ..options.clone() };
    let mut found: Vec<Contradiction> = Vec::new();
    for (object, _) in seeing {
        if options.cancel.as_ref().is_some_and(|cancel| cancel.load(std::sync::atomic::Ordering::Relaxed)) {
            break;
        }
        let is_new = |new: &Contradiction| {
            let shared = |old: &Contradiction| old.statements.iter().any(|s| new.statements.contains(s));
            !found.iter().any(shared)
        };
        let new: Vec<Contradiction> =
            seen_from(program, options, &relative, object).into_iter().filter(is_new).collect();
        found.extend(new);
    }
    found
}

/// A statement without what depends on where the whole stands, and how it is turned.
struct Relative {
    index: usize,
    formula: Formula,
    /// What was left of it, where that is not all.
    kept: Option<Vec<TextRange>>,
}

impl Relative {
    fn of(index: usize, constraint: &Constraint) -> Option<Self> {
        let formula = &constraint.formula;
        let kinds = kinds(formula);
        let is_relative = |id: &NodeId| kinds[id.0 as usize] == Kind::Scalar;
        let (mut open, mut parts) = (vec![formula.root], Vec::new());
        while let Some(id) = open.pop() {
            match formula.node(id) {
                Node::And(all) => open.extend(all.iter().rev()),
                _ => parts.push(id),
            }
        }
        let kept: Vec<NodeId> = parts.iter().copied().filter(is_relative).collect();
        let objects = formula.objects().len();
        if kept.is_empty() || objects == 0 {
            return None;
        }
        let mut own = formula.clone();
        let all = kept.len() == parts.len();
        if !all {
            own.nodes.push(Node::And(kept.clone().into()));
            own.ranges.push(own.ranges[own.root.0 as usize]);
            own.root = NodeId(own.nodes.len() as u32 - 1);
            own = only_needed(&own);
        }
        let ranges = || kept.iter().map(|id| formula.ranges[id.0 as usize]).collect();
        Some(Self { index, formula: own, kept: (!all).then(ranges) })
    }
}

/// The same formula without nodes that its value does not depend on.
fn only_needed(formula: &Formula) -> Formula {
    let mut needed = vec![false; formula.nodes.len()];
    needed[formula.root.0 as usize] = true;
    for id in (0..formula.nodes.len()).rev().filter(|id| *id <= formula.root.0 as usize) {
        if needed[id] {
            formula.nodes[id].for_each_child(|child| needed[child.0 as usize] = true);
        }
    }
    let mut new = vec![NodeId(0); formula.nodes.len()];
    let mut out = Formula { nodes: Vec::new(), ranges: Vec::new(), root: formula.root };
    for id in (0..formula.nodes.len()).filter(|id| needed[*id]) {
        new[id] = NodeId(out.nodes.len() as u32);
        out.nodes.push(formula.nodes[id].map_children(|child| new[child.0 as usize]));
        out.ranges.push(formula.ranges[id]);
    }
    out.root = new[formula.root.0 as usize];
    out
}

/// What happens to a value when all things are turned together, and moved over the floor.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    /// Nothing: a number, a truth.
    Scalar,
    /// Nothing: three such numbers.
    Sizes,
    /// It is a point of theirs, a direction, an orientation, and goes along.
    Point,
    Direction,
    Orientation,
    /// It is how they are turned about y, or differs from that by a fixed angle.
    Yaw,
    Other,
}

/// The kinds of all nodes.
fn kinds(formula: &Formula) -> Vec<Kind> {
    let mut kinds: Vec<Kind> = Vec::with_capacity(formula.nodes.len());
    for node in &formula.nodes {
        let kind = kind(node, &|id: NodeId| kinds[id.0 as usize], formula);
        kinds.push(kind);
    }
    kinds
}

fn kind(node: &Node, of: &dyn Fn(NodeId) -> Kind, formula: &Formula) -> Kind {
    use Kind::{Direction, Orientation, Other, Point, Scalar, Sizes, Yaw};
    let all_scalar = |list: &[NodeId]| list.iter().all(|id| of(*id) == Scalar);
    let scalar_if = |holds: bool| if holds { Scalar } else { Other };
    match node {
        Node::Number(_) | Node::Truth(_) | Node::Draw(_) => Scalar,
        Node::Vector([x, _, z]) => {
            let is_zero = |id: &NodeId| matches!(formula.node(*id), Node::Number(v) if *v == 0.0);
            let Node::Vector(all) = node else { return Other };
            match all_scalar(all) {
                true if is_zero(x) && is_zero(z) => Direction,
                true => Sizes,
                false => Other,
            }
        }
        Node::Object(property, _) => match property {
            ObjectProperty::Pos | ObjectProperty::Center => Point,
            ObjectProperty::Rot => Orientation,
            ObjectProperty::Scale => Sizes,
            ObjectProperty::Top | ObjectProperty::Bottom | ObjectProperty::Surface => Scalar,
            ObjectProperty::Front | ObjectProperty::Right | ObjectProperty::Up => Direction,
            ObjectProperty::Min | ObjectProperty::Max => Other,
        },
        Node::Region(property, _) => match property {
            RegionProperty::Pos | RegionProperty::Center => Point,
            RegionProperty::Rot => Orientation,
            RegionProperty::Scale => Sizes,
            RegionProperty::Floor | RegionProperty::Ceiling | RegionProperty::Area => Scalar,
        },
        Node::SamePolygon(..) | Node::Variable(_) | Node::Choice(..) | Node::Rotation(_) => Other,
        Node::Neg(a) => match of(*a) {
            kind @ (Scalar | Sizes | Direction) => kind,
            _ => Other,
        },
        Node::Arith(op, a, b) => arith(*op, of(*a), of(*b)),
        Node::Component(axis, a) => match (of(*a), axis) {
            (Sizes, _) | (Point | Direction, Axis::Y) => Scalar,
            (Orientation, Axis::Y) => Yaw,
            _ => Other,
        },
        Node::Call(function, args) => call(*function, &args.iter().map(|id| of(*id)).collect::<Vec<_>>()),
        Node::Compare(comparison, _, a, b) => match (of(*a), of(*b)) {
            (Scalar, Scalar) => Scalar,
            (Yaw, Yaw) => scalar_if(*comparison == Comparison::Eq),
            _ => Other,
        },
        Node::Same(a, b) => scalar_if(of(*a) == of(*b) && matches!(of(*a), Point | Direction | Orientation | Sizes)),
        Node::Not(a) => scalar_if(of(*a) == Scalar),
        Node::Iff(a, b) => scalar_if(of(*a) == Scalar && of(*b) == Scalar),
        Node::And(list) | Node::Or(list) | Node::Count(list) | Node::AtLeast(_, list) => scalar_if(all_scalar(list)),
        Node::BuiltIn(_, args) => {
            let goes_along = |arg: &Arg| match arg {
                Arg::Value(id) => matches!(of(*id), Scalar | Point),
                Arg::Object(_) | Arg::Region(_) | Arg::Side(_) => true,
            };
            scalar_if(args.iter().all(goes_along))
        }
    }
}

fn arith(op: Arith, a: Kind, b: Kind) -> Kind {
    use Kind::{Direction, Other, Point, Scalar, Sizes, Yaw};
    match (op, a, b) {
        (_, Scalar, Scalar) => Scalar,
        (Arith::Add | Arith::Sub, Direction, Direction) | (Arith::Sub, Point, Point) => Direction,
        (Arith::Add | Arith::Sub, Point, Direction) | (Arith::Add, Direction, Point) => Point,
        (Arith::Add | Arith::Sub, Sizes, Sizes) => Sizes,
        (Arith::Mul | Arith::Div, Direction, Scalar) | (Arith::Mul, Scalar, Direction) => Direction,
        (Arith::Mul | Arith::Div, Sizes, Scalar) | (Arith::Mul, Scalar, Sizes) => Sizes,
        (Arith::Add | Arith::Sub, Yaw, Scalar) | (Arith::Add, Scalar, Yaw) => Yaw,
        _ => Other,
    }
}

fn call(function: Function, args: &[Kind]) -> Kind {
    use Kind::{Direction, Orientation, Other, Point, Scalar};
    match (function, args) {
        (_, all) if all.iter().all(|kind| *kind == Scalar) => Scalar,
        (Function::Length, [Direction])
        | (Function::Dot | Function::Angle | Function::Distance, [Direction, Direction])
        | (Function::Distance, [Point, Point])
        | (Function::Angle, [Orientation, Orientation]) => Scalar,
        (Function::Normalize, [Direction]) | (Function::Cross, [Direction, Direction]) => Direction,
        _ => Other,
    }
}

/// Things of which it is read how they are turned.
fn oriented(formula: &Formula) -> BTreeSet<ObjectId> {
    use ObjectProperty::{Front, Right, Rot};
    let read = |node: &Node| match node {
        Node::Object(Rot | Front | Right, id) => Some(*id),
        Node::BuiltIn(BuiltIn::Clear, args) => match args.first() {
            Some(Arg::Object(id)) => Some(*id),
            _ => None,
        },
        _ => None,
    };
    formula.nodes.iter().filter_map(read).collect()
}

/// Whether a region, if it is assigned where it stands, is assigned to the ground.
fn is_low(program: &Program, region: RegionId) -> bool {
    let places = |pin: &&Pin| pin.owner == Owner::Region(region) && pin.property == Pinned::Pos;
    program.pins.iter().filter(places).flat_map(|pin| &pin.values).all(|value| match value.root_node() {
        Node::Vector([_, y, _]) => matches!(value.node(*y), Node::Number(height) if *height == 0.0),
        _ => false,
    })
}

fn turned(pin: &Pin) -> Option<ObjectId> {
    match (pin.owner, pin.property) {
        (Owner::Object(id), Pinned::Rot) => Some(id),
        _ => None,
    }
}

/// What a thing and those that statements relate to it say of each other, with that thing unturned.
fn seen_from(program: &Program, options: &ProveOptions, relative: &[Relative], object: ObjectId) -> Vec<Contradiction> {
    let scope = Scope::new(&World::<f64>::nowhere(program, &options.judging));
    let mut near: BTreeSet<ObjectId> = BTreeSet::from([object]);
    for statement in relative {
        let objects = statement.formula.objects();
        if objects.contains(&object) {
            near.extend(objects);
        }
    }
    let counts = |statement: &&Relative| statement.formula.objects().iter().all(|id| near.contains(id));
    let among: Vec<&Relative> = relative.iter().filter(counts).collect();
    if near.len() < 2 || among.len() < 2 {
        return Vec::new();
    }
    let mut own = program.clone();
    own.constraints = among.iter().map(|s| constraint(&program.constraints[s.index], s.formula.clone())).collect();
    let at = |index: usize| among.iter().position(|s| s.index == index);
    own.pins = (program.pins.iter().filter(|pin| pin.property == Pinned::Scale))
        .filter_map(|pin| Some(Pin { constraint: at(pin.constraint)?, ..pin.clone() }))
        .collect();
    let unturned = own.constraints.len();
    own.constraints.push(constraint(&own.constraints[0], no_turn(Some(object))));
    own.constraints[unturned].kind = ConstraintKind::Pin;
    own.pins.push(Pin {
        owner: Owner::Object(object),
        property: Pinned::Rot,
        values: vec![no_turn(None)],
        constraint: unturned,
    });
    let first = own.constraints.len();
    own.constraints.push(constraint(&own.constraints[0], at_origin(object)));
    let room = only_room(program, options);
    let kept_in: Vec<ObjectId> = match room {
        Some(_) if scope.bounds(object) => {
            near.iter().copied().filter(|other| *other != object && scope.bounds(*other)).collect()
        }
        _ => Vec::new(),
    };
    if let Some(room) = room {
        for other in &kept_in {
            own.constraints.push(constraint(&own.constraints[0], not_beyond(object, *other, room.diagonal)));
        }
    }
    let known = Usual::of(program);
    let regions = || (0..program.regions.len()).map(|region| RegionId(region as u32));
    let usual = Usual {
        unturned: vec![false; program.regions.len()],
        on_the_ground: regions().map(|id| known.on_the_ground[id.0 as usize] && is_low(program, id)).collect(),
        origin: None,
        ..known
    };
    if !usual.upright[object.0 as usize] {
        return Vec::new();
    }
    let mut found = Prover::new(&own, options, Some(&usual)).findings().contradictions;
    for contradiction in &mut found {
        contradiction.as_usual = true;
        let rests = contradiction.statements.iter().filter_map(|s| kept_in.get(s.checked_sub(first + 1)?));
        let rests: Vec<ObjectId> = rests.copied().collect();
        contradiction.statements.retain(|s| *s < unturned);
        let said: Vec<(usize, Vec<TextRange>)> = std::mem::take(&mut contradiction.parts);
        for s in &contradiction.statements {
            let known = said.iter().find(|(of, _)| of == s).map(|(_, ranges)| ranges.clone());
            if let Some(ranges) = known.or_else(|| among[*s].kept.clone()) {
                contradiction.parts.push((among[*s].index, ranges));
            }
        }
        contradiction.statements = contradiction.statements.iter().map(|s| among[*s].index).collect();
        if let Some(room) = room.filter(|_| !rests.is_empty()) {
            let name = |id: ObjectId| &program.objects[id.0 as usize].name;
            contradiction.statements.push(room.sized_by);
            contradiction.statements.sort_unstable();
            contradiction.statements.dedup();
            let rules = rests
                .iter()
                .chain([&object])
                .map(|id| format!("P-BOUNDS keeps `{}` in `{}`", name(*id), program.regions[0].name));
            contradiction.rules.extend(rules);
            contradiction.rules.sort_unstable();
            contradiction.rules.dedup();
        }
    }
    found.retain(|contradiction| !contradiction.statements.is_empty());
    found
}

/// The one room of a program, if its size is given in numbers.
#[derive(Clone, Copy)]
struct OnlyRoom {
    /// The statement that gives it.
    sized_by: usize,
    /// From one corner to the opposite one (metres), with what may stick out of the room.
    diagonal: f64,
}

fn only_room(program: &Program, options: &ProveOptions) -> Option<OnlyRoom> {
    /// Much more than the tolerance of P-BOUNDS on both sides (metres).
    const OUT: f64 = 0.1;
    let shaped = program.pins.iter().any(|pin| pin.property == Pinned::Vertices);
    let is_size = |pin: &&Pin| matches!(pin.owner, Owner::Region(_)) && pin.property == Pinned::Scale;
    let mut sizes = program.pins.iter().filter(is_size);
    let (Some(pin), None, 1, false, true) =
        (sizes.next(), sizes.next(), program.regions.len(), shaped, options.judging.physics)
    else {
        return None;
    };
    let [value] = &pin.values[..] else { return None };
    let Node::Vector([w, _, d]) = value.root_node() else { return None };
    let (Node::Number(w), Node::Number(d)) = (value.node(*w), value.node(*d)) else { return None };
    Some(OnlyRoom { sized_by: pin.constraint, diagonal: w.hypot(*d) + OUT })
}

/// That a thing stands in the middle of everything.
fn at_origin(object: ObjectId) -> Formula {
    let mut nodes = vec![Node::Object(ObjectProperty::Center, object), Node::Number(0.0)];
    for axis in [Axis::X, Axis::Z] {
        let at = NodeId(nodes.len() as u32);
        nodes.push(Node::Component(axis, NodeId(0)));
        nodes.push(Node::Compare(Comparison::Eq, Unit::Metre, at, NodeId(1)));
    }
    all(nodes, &[3, 5])
}

/// That another thing is no farther from it, along either axis.
fn not_beyond(object: ObjectId, other: ObjectId, most: f64) -> Formula {
    let center = |id: ObjectId| Node::Object(ObjectProperty::Center, id);
    let mut nodes =
        vec![center(object), center(other), Node::Arith(Arith::Sub, NodeId(1), NodeId(0)), Node::Number(most)];
    for axis in [Axis::X, Axis::Z] {
        let at = nodes.len() as u32;
        nodes.push(Node::Component(axis, NodeId(2)));
        nodes.push(Node::Call(Function::Abs, [NodeId(at)].into()));
        nodes.push(Node::Compare(Comparison::Le, Unit::Metre, NodeId(at + 1), NodeId(3)));
    }
    all(nodes, &[6, 9])
}

fn all(mut nodes: Vec<Node>, parts: &[u32]) -> Formula {
    nodes.push(Node::And(parts.iter().map(|at| NodeId(*at)).collect()));
    let root = NodeId(nodes.len() as u32 - 1);
    Formula { ranges: vec![TextRange::default(); nodes.len()], nodes, root }
}

fn constraint(of: &Constraint, formula: Formula) -> Constraint {
    Constraint { formula, wordings: Vec::new(), ..of.clone() }
}

/// That a thing is not turned; without one: no turn.
fn no_turn(of: Option<ObjectId>) -> Formula {
    let zero = NodeId(0);
    let mut nodes = vec![Node::Number(0.0), Node::Rotation([zero; 3])];
    if let Some(object) = of {
        nodes.extend([Node::Object(ObjectProperty::Rot, object), Node::Same(NodeId(2), NodeId(1))]);
    }
    let root = NodeId(nodes.len() as u32 - 1);
    Formula { ranges: vec![TextRange::default(); nodes.len()], nodes, root }
}
