//! Equations used as assignments: a hard term that is affine in one coordinate (or in the position) of an object fixes
//! it, given the rest; likewise one that says how an object is turned.
//!
//! Each equation sets something of one object, that which comes last in the order of placement, and none in a circle.

use super::rules::{Fixed, Rule, Rules, Sets};
use super::terms::Term;
use scenelang_lang::Program;
use scenelang_lang::program::{
    Arg, Arith, Axis, Comparison, Formula, Function, Node, NodeId, ObjectId, ObjectProperty, RegionProperty, Unit,
    VariableKind,
};
use scenelang_verify::surroundings;

/// Adds rules from equations to those there are. `priority`: which objects are placed first.
pub(super) fn add(mut rules: Rules, program: &Program, terms: &[Term], priority: &[f64]) -> Rules {
    let objects = rules.fixed.len();
    for term in terms.iter().filter(|t| t.is_hard()) {
        let mut owners = term.objects.clone();
        owners.sort_by(|a, b| priority[a.0 as usize].total_cmp(&priority[b.0 as usize]).then(b.cmp(a)));
        let rule = owners.into_iter().find_map(|owner| {
            let rule = solve(program, &term.formula, owner)?;
            let free = is_free(&rules.fixed[owner.0 as usize], rule.sets);
            let circle = rule.reads.objects.iter().any(|o| rules.depends(*o, owner));
            (free && !circle).then_some(rule)
        });
        if let Some(rule) = rule {
            let mut list = rules.list;
            list.push(rule);
            rules = Rules::new(list, objects);
        }
    }
    rules
}

fn is_free(fixed: &Fixed, sets: Sets) -> bool {
    match sets {
        Sets::Pos | Sets::Shift(_) => fixed.pos == [false; 3],
        Sets::Axis(axis, _) => !fixed.pos[axis],
        Sets::Rot | Sets::Yaw => !fixed.rot,
        Sets::Scale => !fixed.scale,
    }
}

/// The equation of a formula, solved for something of an object.
fn solve(program: &Program, formula: &Formula, owner: ObjectId) -> Option<Rule> {
    let (left, right) = match *formula.root_node() {
        Node::Compare(Comparison::Eq, Unit::Metre, l, r) => (l, r),
        Node::Compare(Comparison::Eq, Unit::Degree, l, r) => return yaw(formula, owner, l, r),
        Node::Same(l, r) => (l, r),
        _ => return None,
    };
    if let Some(rule) = turn(formula, owner, left, right) {
        return Some(rule);
    }
    // Left less right, in place of the comparison.
    let mut formula = formula.clone();
    formula.nodes[formula.root.0 as usize] = Node::Arith(Arith::Sub, left, right);
    let slopes = slopes(program, &formula, owner);
    match slopes[formula.root.0 as usize]? {
        Slope::Number(by) => {
            let axis = (0..3).find(|&i| by[i] != 0.0)?;
            let alone = (0..3).all(|i| i == axis || by[i] == 0.0);
            alone.then(|| Rule::new(owner, Sets::Axis(axis, by[axis]), formula))
        }
        Slope::Vector(by) => {
            let per = by[0][0];
            let even = (0..3).all(|i| (0..3).all(|j| by[i][j] == if i == j { per } else { 0.0 }));
            (even && per != 0.0).then(|| Rule::new(owner, Sets::Shift(per), formula))
        }
    }
}

/// `a.rot = …` where the other side does not read a.
fn turn(formula: &Formula, owner: ObjectId, left: NodeId, right: NodeId) -> Option<Rule> {
    let own = |id: NodeId| *formula.node(id) == Node::Object(ObjectProperty::Rot, owner);
    let value = if own(left) { right } else { Some(left).filter(|_| own(right))? };
    side(formula, owner, value, Sets::Rot)
}

/// `a.rot.y = …` where the other side does not read a.
fn yaw(formula: &Formula, owner: ObjectId, left: NodeId, right: NodeId) -> Option<Rule> {
    let own = |id: NodeId| match formula.node(id) {
        Node::Component(Axis::Y, of) => *formula.node(*of) == Node::Object(ObjectProperty::Rot, owner),
        _ => false,
    };
    let value = if own(left) { right } else { Some(left).filter(|_| own(right))? };
    side(formula, owner, value, Sets::Yaw)
}

fn side(formula: &Formula, owner: ObjectId, value: NodeId, sets: Sets) -> Option<Rule> {
    if scenelang_verify::objects_of(formula, value).contains(&owner) {
        return None;
    }
    // Nodes after it are not needed.
    let nodes = formula.nodes[..=value.0 as usize].to_vec();
    let mut rule = Rule::new(owner, sets, Formula { nodes, ranges: Vec::new(), root: value });
    rule.reads.objects = scenelang_verify::objects_of(&rule.formula, value);
    Some(rule)
}

/// How a node changes with the position of an object, if that is the same everywhere: per metre along x, y, z.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Slope {
    Number([f64; 3]),
    /// By component.
    Vector([[f64; 3]; 3]),
}

impl Slope {
    fn is_zero(&self) -> bool {
        match self {
            Self::Number(by) => *by == [0.0; 3],
            Self::Vector(by) => *by == [[0.0; 3]; 3],
        }
    }
    fn scaled(self, factor: f64) -> Self {
        match self {
            Self::Number(by) => Self::Number(by.map(|b| b * factor)),
            Self::Vector(by) => Self::Vector(by.map(|row| row.map(|b| b * factor))),
        }
    }
    fn plus(self, other: Self) -> Option<Self> {
        let sum = |a: [f64; 3], b: [f64; 3]| std::array::from_fn(|i| a[i] + b[i]);
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Some(Self::Number(sum(a, b))),
            (Self::Vector(a), Self::Vector(b)) => Some(Self::Vector(std::array::from_fn(|i| sum(a[i], b[i])))),
            _ => None,
        }
    }
}

const NONE: Slope = Slope::Number([0.0; 3]);
const STILL: Slope = Slope::Vector([[0.0; 3]; 3]);
const ALONG: Slope = Slope::Vector([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

/// By node; `None`: not the same everywhere.
fn slopes(program: &Program, formula: &Formula, owner: ObjectId) -> Vec<Option<Slope>> {
    let mut list: Vec<Option<Slope>> = Vec::with_capacity(formula.nodes.len());
    for node in &formula.nodes {
        let of = |id: &NodeId| list[id.0 as usize];
        let constant = |id: &NodeId| match formula.node(*id) {
            Node::Number(n) => Some(*n),
            _ => None,
        };
        let slope = match node {
            Node::Object(property, id) => Some(match (property, *id == owner) {
                (ObjectProperty::Pos | ObjectProperty::Center | ObjectProperty::Min | ObjectProperty::Max, true) => {
                    ALONG
                }
                (ObjectProperty::Top | ObjectProperty::Bottom | ObjectProperty::Surface, true) => {
                    Slope::Number([0.0, 1.0, 0.0])
                }
                (ObjectProperty::Top | ObjectProperty::Bottom | ObjectProperty::Surface, false) => NONE,
                _ => STILL,
            }),
            Node::Number(_) | Node::Truth(_) | Node::Draw(_) => Some(NONE),
            Node::Variable(id) => Some(match program.variables[id.0 as usize].kind {
                VariableKind::Vector | VariableKind::Rotation => STILL,
                _ => NONE,
            }),
            Node::Region(RegionProperty::Floor | RegionProperty::Ceiling | RegionProperty::Area, _) => Some(NONE),
            Node::Region(..) => Some(STILL),
            Node::Vector(parts) => {
                let rows = parts.map(|p| match list[p.0 as usize] {
                    Some(Slope::Number(by)) => Some(by),
                    _ => None,
                });
                match rows {
                    [Some(x), Some(y), Some(z)] => Some(Slope::Vector([x, y, z])),
                    _ => None,
                }
            }
            Node::Rotation(_) => Some(STILL),
            Node::Neg(a) => of(a).map(|s| s.scaled(-1.0)),
            Node::Component(axis, a) => of(a).map(|s| match s {
                Slope::Vector(by) => Slope::Number(by[*axis as usize]),
                Slope::Number(_) => NONE,
            }),
            Node::Arith(op, a, b) => match (op, of(a), of(b)) {
                (Arith::Add, Some(x), Some(y)) => x.plus(y),
                (Arith::Sub, Some(x), Some(y)) => x.plus(y.scaled(-1.0)),
                (Arith::Mul, Some(x), Some(y)) => match (constant(a), constant(b)) {
                    (Some(factor), _) => Some(y.scaled(factor)),
                    (_, Some(factor)) => Some(x.scaled(factor)),
                    _ => still(x, y),
                },
                (Arith::Div, Some(x), Some(y)) => match constant(b) {
                    Some(divisor) if divisor != 0.0 => Some(x.scaled(1.0 / divisor)),
                    _ => still(x, y),
                },
                _ => None,
            },
            Node::Call(function, parts) => {
                let constant = parts.iter().all(|p| of(p).is_some_and(|s| s.is_zero()));
                let vector = matches!(function, Function::Normalize | Function::Cross);
                constant.then_some(if vector { STILL } else { NONE })
            }
            // Which of the values it is does not change.
            Node::Choice(_, parts) => {
                let first = of(&parts[0]);
                parts.iter().all(|part| of(part) == first).then_some(first).flatten()
            }
            // A measure of its arguments alone.
            Node::BuiltIn(built_in, args)
                if !built_in.is_predicate() && !surroundings(formula, node).is_something() =>
            {
                let constant = args.iter().all(|a| match a {
                    Arg::Object(id) => *id != owner,
                    Arg::Value(id) => of(id).is_some_and(|s| s.is_zero()),
                    _ => true,
                });
                constant.then_some(NONE)
            }
            _ => None,
        };
        list.push(slope);
    }
    list
}

/// A product or quotient of two that do not change.
fn still(x: Slope, y: Slope) -> Option<Slope> {
    let vector = matches!(x, Slope::Vector(_)) || matches!(y, Slope::Vector(_));
    (x.is_zero() && y.is_zero()).then_some(if vector { STILL } else { NONE })
}
