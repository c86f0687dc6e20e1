//! Formulas as JSON: nested operators with their operands.
//!
//! A formula is a graph in which equal parts are shared, and written out in full it could be larger by any factor. So a
//! shared part is written once, with an `id`, and is `{"ref": id}` everywhere else.

use super::write::Json;
use scenelang_lang::natives::SIDES;
use scenelang_lang::program::*;
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// A formula, to be written.
pub struct Formulas<'a> {
    program: &'a Program,
    formula: &'a Formula,
    /// Of each node, how many use it.
    uses: Vec<u32>,
    /// Of each node, whether it is known to be in degrees.
    angle: Vec<bool>,
}

/// What is left to write, last first.
enum Step {
    /// A node, in the unit that its user expects.
    Node(NodeId, Unit),
    /// Something without parts.
    Leaf(Value),
    /// The end of operands.
    End,
}

impl<'a> Formulas<'a> {
    pub fn new(program: &'a Program, formula: &'a Formula) -> Self {
        let mut uses = vec![0; formula.nodes.len()];
        formula.nodes.iter().for_each(|node| node.for_each_child(|child| uses[child.0 as usize] += 1));
        let mut made = Self { program, formula, uses, angle: Vec::with_capacity(formula.nodes.len()) };
        for node in &formula.nodes {
            let angle = made.is_angle(node);
            made.angle.push(angle);
        }
        made
    }

    /// The names that the formula depends on, in order of declaration.
    pub fn names(&self) -> Value {
        let objects: BTreeSet<ObjectId> = self.formula.objects().into_iter().collect();
        let (mut regions, mut variables, mut draws) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for node in &self.formula.nodes {
            match node {
                Node::Region(_, id) | Node::SamePolygon(id, _) => drop(regions.insert(*id)),
                Node::Variable(id) => drop(variables.insert(*id)),
                Node::Draw(id) | Node::Choice(id, _) => drop(draws.insert(*id)),
                Node::BuiltIn(_, args) => {
                    regions.extend(args.iter().filter_map(|a| if let Arg::Region(id) = a { Some(*id) } else { None }));
                }
                _ => {}
            }
        }
        let objects: Vec<&str> = objects.into_iter().map(|id| self.object(id)).collect();
        let regions: Vec<&str> = regions.into_iter().map(|id| self.region(id)).collect();
        let variables: Vec<&str> = variables.into_iter().map(|id| self.variable(id)).collect();
        let draws: Vec<&str> = draws.into_iter().map(|id| self.draw(id)).collect();
        json!({ "objects": objects, "regions": regions, "variables": variables, "draws": draws })
    }

    /// Writes the formula as one value.
    pub fn write(&self, json: &mut Json) {
        let mut written = vec![false; self.formula.nodes.len()];
        let mut steps = vec![Step::Node(self.formula.root, Unit::Metre)];
        while let Some(step) = steps.pop() {
            match step {
                Step::Leaf(value) => json.value(value),
                Step::End => {
                    json.close(']');
                    json.close('}');
                }
                Step::Node(id, unit) => {
                    let node = self.formula.node(id);
                    if let Some(leaf) = self.leaf(node, unit) {
                        json.value(leaf);
                    } else if std::mem::replace(&mut written[id.0 as usize], true) {
                        json.value(json!({ "ref": id.0 }));
                    } else {
                        json.open('{');
                        if self.uses[id.0 as usize] > 1 {
                            json.member("id", id.0);
                        }
                        self.operator(node, json);
                        json.name("operands");
                        json.open('[');
                        steps.push(Step::End);
                        let first = steps.len();
                        self.operands(node, unit, &mut steps);
                        steps[first..].reverse();
                    }
                }
            }
        }
    }

    /// A node without parts.
    fn leaf(&self, node: &Node, unit: Unit) -> Option<Value> {
        Some(match node {
            Node::Number(x) => json!({ "number": x, "unit": unit_word(unit) }),
            Node::Truth(truth) => json!({ "truth": truth }),
            Node::Object(property, id) => {
                json!({ "property": lower_first(&format!("{property:?}")), "object": self.object(*id) })
            }
            Node::Region(property, id) => {
                json!({ "property": lower_first(&format!("{property:?}")), "region": self.region(*id) })
            }
            Node::Variable(id) => json!({ "variable": self.variable(*id) }),
            Node::Draw(id) => json!({ "draw": self.draw(*id) }),
            _ => return None,
        })
    }

    /// The members of a node with parts that come before its operands.
    fn operator(&self, node: &Node, json: &mut Json) {
        let op = match node {
            Node::Vector(_) => "vec3".to_owned(),
            Node::Rotation(_) => "rot".to_owned(),
            Node::Neg(_) => "-".to_owned(),
            Node::Arith(op, ..) => match op {
                Arith::Add => "+",
                Arith::Sub => "-",
                Arith::Mul => "*",
                Arith::Div => "/",
            }
            .to_owned(),
            Node::Component(axis, _) => lower_first(&format!("{axis:?}")),
            Node::Call(function, _) => lower_first(&format!("{function:?}")),
            Node::Compare(op, ..) => match op {
                Comparison::Eq => "=",
                Comparison::Ne => "!=",
                Comparison::Lt => "<",
                Comparison::Le => "<=",
                Comparison::Gt => ">",
                Comparison::Ge => ">=",
            }
            .to_owned(),
            Node::Same(..) => "same".to_owned(),
            Node::And(_) => "and".to_owned(),
            Node::Or(_) => "or".to_owned(),
            Node::Not(_) => "not".to_owned(),
            Node::Iff(..) => "iff".to_owned(),
            Node::Count(_) => "count".to_owned(),
            Node::AtLeast(..) => "atLeast".to_owned(),
            Node::BuiltIn(built_in, _) => built_in.name().to_owned(),
            Node::SamePolygon(..) => "samePolygon".to_owned(),
            Node::Choice(..) => "oneOf".to_owned(),
            Node::Number(_)
            | Node::Truth(_)
            | Node::Object(..)
            | Node::Region(..)
            | Node::Variable(_)
            | Node::Draw(_) => {
                return;
            }
        };
        json.member("op", op);
        match node {
            Node::Compare(_, unit, ..) => json.member("unit", unit_word(*unit)),
            Node::AtLeast(n, _) => json.member("count", *n),
            Node::Choice(id, _) => json.member("draw", self.draw(*id)),
            _ => {}
        }
    }

    /// The operands of a node, each in the unit that it is expected in.
    fn operands(&self, node: &Node, unit: Unit, steps: &mut Vec<Step>) {
        match node {
            Node::BuiltIn(_, args) => {
                steps.extend(args.iter().map(|arg| match arg {
                    Arg::Object(id) => Step::Leaf(json!({ "object": self.object(*id) })),
                    Arg::Region(id) => Step::Leaf(json!({ "region": self.region(*id) })),
                    Arg::Side(side) => {
                        let word = SIDES.iter().find(|(_, s)| s == side).map_or("", |(word, _)| word);
                        Step::Leaf(json!({ "side": word }))
                    }
                    Arg::Value(id) => Step::Node(*id, Unit::Metre),
                }));
                return;
            }
            Node::SamePolygon(region, _) => steps.push(Step::Leaf(json!({ "region": self.region(*region) }))),
            _ => {}
        }
        let expected = self.expected(node, unit);
        let mut expected = expected.into_iter().chain(std::iter::repeat(expected[1]));
        node.for_each_child(|child| steps.push(Step::Node(child, expected.next().unwrap_or(Unit::Metre))));
    }

    /// The units of a node's first operand and of the others, if its own is `unit`.
    fn expected(&self, node: &Node, unit: Unit) -> [Unit; 2] {
        let (deg, metre) = (Unit::Degree, Unit::Metre);
        let angle = |id: NodeId| self.angle[id.0 as usize];
        match node {
            Node::Compare(_, unit, ..) => [*unit; 2],
            Node::Rotation(_) | Node::Call(Function::Sin | Function::Cos, _) => [deg; 2],
            Node::Neg(_) | Node::Arith(Arith::Add | Arith::Sub, ..) | Node::Choice(..) => [unit; 2],
            Node::Call(Function::Abs | Function::Min | Function::Max, _) => [unit; 2],
            // Of a product that is an angle one factor is. If neither shows it, both are numbers or draws: the first.
            Node::Arith(Arith::Mul, a, b) if unit == deg => {
                if angle(*b) && !angle(*a) {
                    [metre, deg]
                } else {
                    [deg, metre]
                }
            }
            Node::Arith(Arith::Div, ..) if unit == deg => [deg, metre],
            // The ratio of two angles.
            Node::Arith(Arith::Div, a, b) if angle(*a) || angle(*b) => [deg; 2],
            _ => [metre; 2],
        }
    }

    /// Whether a node is an angle whatever stands around it. Bare numbers and draws are not told apart from lengths.
    fn is_angle(&self, node: &Node) -> bool {
        let angle = |id: &NodeId| self.angle[id.0 as usize];
        match node {
            Node::Component(_, of) => match self.formula.node(*of) {
                Node::Rotation(_) | Node::Object(ObjectProperty::Rot, _) | Node::Region(RegionProperty::Rot, _) => true,
                Node::Variable(id) => self.program.variables[id.0 as usize].kind == VariableKind::Rotation,
                _ => false,
            },
            Node::Variable(id) => self.program.variables[id.0 as usize].kind == VariableKind::Degree,
            Node::Call(Function::Angle, _) => true,
            Node::Call(Function::Abs | Function::Min | Function::Max, list) | Node::Choice(_, list) => {
                list.iter().any(angle)
            }
            Node::Neg(a) => angle(a),
            Node::Arith(Arith::Div, a, b) => angle(a) && !angle(b),
            Node::Arith(_, a, b) => angle(a) || angle(b),
            _ => false,
        }
    }

    fn object(&self, id: ObjectId) -> &'a str {
        &self.program.objects[id.0 as usize].name
    }
    fn region(&self, id: RegionId) -> &'a str {
        &self.program.regions[id.0 as usize].name
    }
    fn variable(&self, id: VariableId) -> &'a str {
        &self.program.variables[id.0 as usize].name
    }
    fn draw(&self, id: DrawId) -> &'a str {
        &self.program.draws[id.0 as usize].key
    }
}

/// As in reports: `m` also stands for plain numbers, which count as metres.
fn unit_word(unit: Unit) -> &'static str {
    match unit {
        Unit::Metre => "m",
        Unit::Degree => "deg",
    }
}

fn lower_first(word: &str) -> String {
    let mut chars = word.chars();
    chars.next().map_or(String::new(), |c| c.to_lowercase().chain(chars).collect())
}
