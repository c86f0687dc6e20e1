//! The evaluator: one walk over the nodes of a formula, in any [`Algebra`].
//!
//! What takes geometry to know (built-ins, outlines, surfaces) is asked of an [`Oracle`]: with plain values that is
//! [`Measured`].
//! Each node yields a value or the reason why there is none. `and`, `or` and `implies` forget the reasons that stand to
//! the right of a discrete fact which decides them already; everything else passes them on.

mod arithmetic;
mod connective;
mod lazy;
mod property;
mod value;

pub use lazy::Lazy;
pub(crate) use property::of_outline as outline;
pub(crate) use property::of_region as rectangle;
pub use value::{Cause, EvalError, Truth, Value};

use crate::builtins::Call;
use crate::number::{Algebra, Number};
use crate::world::World;
use arithmetic::vector;
use scenelang_lang::program::{Formula, Node, NodeId, ObjectId, ObjectProperty, RegionProperty};

/// What nodes have yielded so far, by their index.
pub(crate) type Values<N> = [Result<Value<N>, EvalError>];

/// Room for the values of a formula's nodes: keep one and evaluate without allocating.
#[derive(Clone, Debug)]
pub struct Scratch<N: Algebra> {
    values: Vec<Result<Value<N>, EvalError>>,
    /// The greatest margins of an `AtLeast`.
    greatest: Vec<Truth<N>>,
}

/// Who knows what takes geometry to know: built-ins, outlines, declared surfaces, equal orientations; and draws.
pub(crate) trait Oracle<N: Algebra> {
    /// The value of such a node; `values` are those of the nodes before it.
    fn ask(&mut self, node: &Node, id: NodeId, values: &Values<N>, world: &World<N>) -> Result<Value<N>, EvalError>;
}

/// The value that a draw chooses; draws of a layout are in their bounds.
pub(crate) fn chosen<N: Algebra>(draw: f64, list: &[NodeId], values: &Values<N>) -> Result<Value<N>, EvalError> {
    let at = (draw.max(0.0) as usize).min(list.len() - 1);
    values[list[at].0 as usize]
}

/// What geometry measures on plain floats.
struct Measured;

impl<N: Number> Oracle<N> for Measured {
    fn ask(&mut self, node: &Node, id: NodeId, values: &Values<N>, world: &World<N>) -> Result<Value<N>, EvalError> {
        let fail = |cause: Cause| EvalError { cause, node: id };
        match node {
            Node::Object(ObjectProperty::Surface, object) => property::surface(world, *object).map_err(fail),
            Node::Region(property, region) => property::of_outline(world, *property, *region).map_err(fail),
            Node::Draw(draw) => Ok(Value::Number(N::constant(world.draw(*draw).map_err(fail)?))),
            Node::Choice(draw, list) => chosen(world.draw(*draw).map_err(fail)?, list, values),
            Node::BuiltIn(built_in, args) => Call { built_in: *built_in, args, values, world, node: id }.exact(),
            Node::Same(a, b) => {
                let (a, b) = (values[a.0 as usize]?, values[b.0 as usize]?);
                Ok(Value::Truth(connective::same_turn(a, b, &world.options.tolerances)))
            }
            Node::SamePolygon(region, vertices) => {
                Ok(Value::Truth(property::same_polygon(world, *region, values, vertices, id)?))
            }
            other => unreachable!("no geometry in {other:?}"),
        }
    }
}

impl<N: Algebra> Default for Scratch<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<N: Number> Scratch<N> {
    /// The value of the whole formula.
    ///
    /// # Errors
    /// The first reason, in the order of the nodes, why it cannot be judged.
    pub fn evaluate(&mut self, formula: &Formula, world: &World<N>) -> Result<Value<N>, EvalError> {
        self.evaluate_with(formula, world, &mut Measured)
    }

    /// The value of the last of `nodes`, which are those it depends on, see [`cone`].
    ///
    /// # Errors
    /// The first reason why it cannot be judged.
    pub fn evaluate_cone(
        &mut self,
        formula: &Formula,
        nodes: &[NodeId],
        world: &World<N>,
    ) -> Result<Value<N>, EvalError> {
        const UNUSED: EvalError = EvalError { cause: Cause::Refused, node: NodeId(0) };
        self.values.resize(formula.nodes.len(), Err(UNUSED));
        let mut last = Err(UNUSED);
        for &id in nodes {
            last = self.node(formula, id, world, &mut Measured);
            self.values[id.0 as usize] = last;
        }
        last
    }

    /// What a node yielded when the formula was last evaluated.
    ///
    /// # Errors
    /// Why it yielded nothing.
    pub fn get(&self, node: NodeId) -> Result<Value<N>, EvalError> {
        self.values[node.0 as usize]
    }

    /// The part of the formula that decided its margin, as last evaluated: a comparison, a predicate, a fact.
    pub fn deciding(&self, formula: &Formula) -> NodeId {
        self.deciding_from(formula, formula.root)
    }

    /// The same of a part of the formula.
    pub fn deciding_from(&self, formula: &Formula, part: NodeId) -> NodeId {
        let mut at = part;
        while let Some(child) = connective::deciding_child(formula.node(at), at, &self.values) {
            at = child;
        }
        at
    }
}

impl<N: Algebra> Scratch<N> {
    /// As [`Self::get`], of any kind of number.
    pub(crate) fn value(&self, node: NodeId) -> Result<Value<N>, EvalError> {
        self.values[node.0 as usize]
    }
    /// What all nodes yielded.
    pub(crate) fn values(&self) -> &Values<N> {
        &self.values
    }
    /// Nothing evaluated yet.
    pub fn new() -> Self {
        Self { values: Vec::new(), greatest: Vec::new() }
    }

    /// The value of the whole formula; what takes geometry to know is asked of `oracle`.
    ///
    /// # Errors
    /// The first reason, in the order of the nodes, why it cannot be judged.
    pub(crate) fn evaluate_with(
        &mut self,
        formula: &Formula,
        world: &World<N>,
        oracle: &mut impl Oracle<N>,
    ) -> Result<Value<N>, EvalError> {
        self.values.clear();
        for index in 0..=formula.root.0 {
            let value = self.node(formula, NodeId(index), world, oracle);
            self.values.push(value);
        }
        self.values[formula.root.0 as usize]
    }

    fn node(
        &mut self,
        formula: &Formula,
        id: NodeId,
        world: &World<N>,
        oracle: &mut impl Oracle<N>,
    ) -> Result<Value<N>, EvalError> {
        let values = &self.values[..];
        let get = |n: NodeId| values[n.0 as usize];
        let fail = |cause: Cause| EvalError { cause, node: id };
        let value = match formula.node(id) {
            Node::Number(v) => Value::Number(N::constant(*v)),
            Node::Truth(holds) => Value::Truth(Truth::discrete(*holds)),
            Node::Vector(parts) => Value::Vector(vector(values, parts)?),
            Node::Rotation(parts) => Value::Rotation(vector(values, parts)?),
            node @ (Node::Object(ObjectProperty::Surface, _)
            | Node::Region(RegionProperty::Area | RegionProperty::Center, _)
            | Node::Draw(_)
            | Node::Choice(..)
            | Node::BuiltIn(..)
            | Node::SamePolygon(..)) => oracle.ask(node, id, values, world)?,
            Node::Object(property, object) => property::of_object(world, *property, *object).map_err(fail)?,
            Node::Region(property, region) => property::of_region(world, *property, *region).map_err(fail)?,
            Node::Variable(variable) => world.variable(*variable).map_err(fail)?,
            Node::Neg(a) => arithmetic::negate(get(*a)?),
            Node::Arith(op, a, b) => arithmetic::combine(*op, get(*a)?, get(*b)?).map_err(fail)?,
            Node::Component(axis, a) => arithmetic::component(*axis, get(*a)?),
            Node::Call(function, args) => arithmetic::call(*function, values, args, fail)?,
            Node::Compare(op, unit, a, b) => {
                let (a, b) = (arithmetic::number(get(*a)?), arithmetic::number(get(*b)?));
                Value::Truth(connective::compare(*op, *unit, a, b, &world.options.tolerances))
            }
            Node::Same(a, b) => match (get(*a)?, get(*b)?) {
                (Value::Vector(a), Value::Vector(b)) => {
                    Value::Truth(connective::same_point(a, b, &world.options.tolerances))
                }
                _ => oracle.ask(formula.node(id), id, values, world)?,
            },
            Node::And(parts) => Value::Truth(connective::all(values, parts)?),
            Node::Or(parts) => Value::Truth(connective::any(values, parts)?),
            Node::Not(a) => Value::Truth(connective::truth(get(*a)?).negated()),
            Node::Iff(a, b) => Value::Truth(connective::truth(get(*a)?).iff(connective::truth(get(*b)?))),
            Node::Count(parts) => Value::Number(connective::count(values, parts)?),
            Node::AtLeast(n, parts) => {
                Value::Truth(connective::at_least(*n as usize, values, parts, &mut self.greatest)?)
            }
        };
        Ok(value)
    }
}

/// The value of a formula. Who evaluates often keeps a [`Scratch`].
///
/// # Errors
/// The first reason, in the order of the nodes, why it cannot be judged.
pub fn evaluate<N: Number>(formula: &Formula, world: &World<N>) -> Result<Value<N>, EvalError> {
    Scratch::new().evaluate(formula, world)
}

/// The truth of a formula whose root is one.
///
/// # Errors
/// As [`evaluate`].
pub fn judge<N: Number>(formula: &Formula, world: &World<N>) -> Result<Truth<N>, EvalError> {
    evaluate(formula, world).map(connective::truth)
}

/// The nodes that `node` depends on, in order, itself last.
pub fn cone(formula: &Formula, node: NodeId) -> Vec<NodeId> {
    let mut wanted = vec![false; node.0 as usize + 1];
    wanted[node.0 as usize] = true;
    for index in (0..=node.0 as usize).rev() {
        if wanted[index] {
            formula.nodes[index].for_each_child(|child| wanted[child.0 as usize] = true);
        }
    }
    (0..=node.0).filter(|&i| wanted[i as usize]).map(NodeId).collect()
}

/// Objects that a node depends on, sorted, each once.
pub fn objects_of(formula: &Formula, node: NodeId) -> Vec<ObjectId> {
    let nodes: Vec<Node> = cone(formula, node).iter().map(|&n| formula.node(n).clone()).collect();
    Formula { nodes, ranges: Vec::new(), root: NodeId(0) }.objects()
}
